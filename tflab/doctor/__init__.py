"""What is wrong with this TF?  The lecture's order of questions, asked of a recording, a graph or a buffer.

    findings     what the doctor says
    evidence     what there is to judge
    jumps        where a clock was set
    checks/      the questions, one page each, in the order in which one asks them
    diagnose     all of them, and causes apart from effects
    report/      what is said: as text, as JSON, as a page with pictures
    doctor       the door: doctor(recording | graph | buffer)
    command      `tflab doctor BAG`

Start with `findings.py`; each page names the next.
"""
