"""The clinic: sick robots as plain data, tools with prices, and the proof of a diagnosis.

    causes     eighteen changes to how a robot is launched
    findings   what a tool's text says, in a line
    trolley    what one can ask, and what it costs
    told       the same in the learner's language
    table      what each suspect would answer
    examples   what a finding looks like, and the tables in print
    proof      when a diagnosis is proved
    cures      what one can do about it
    patient    a sick robot as plain data
    ward       how a patient is made
    archive    many patients, none made twice
    visit      how one examines a patient, and treats it
    steps      a visit, step by step
    practice   patients without end
    panel      a visit with controls

A cause is made on a running robot, every tool is run on it, and what they print is
all that leaves the ward.  Start with `causes.py`.
"""
