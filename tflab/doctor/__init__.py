"""What is wrong with this TF?  The lecture's order of questions, asked of a recording, a graph or a buffer.

    findings     what the doctor says
    evidence     what there is to judge
    jumps        where a clock was set
    motion       steps, and two stories told at once
    names        1  are the names right?
    tree         2  is it one tree?
    values       3  are the numbers transforms?
    timing       4  is it there in time?
    clocks       5  whose clock is it?
    owners       6  who says so?
    statics      7  is what is fixed published as fixed?
    diagnose     all of them, and causes apart from effects
    texts        the sentences
    catalogue    which finding names which fault
    report_text, history, report_html    the report
    time_sources what only a living graph can tell
    doctor       the door: doctor(recording | graph | buffer)
    command      `tflab doctor BAG`

Start with `findings.py`; each page names the next.
"""
