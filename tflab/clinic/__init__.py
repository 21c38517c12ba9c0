"""Diagnosis exercises: simulated faulty robots, tools that cost minutes, and a check that a diagnosis is proved.

    causes            eighteen changes to how a robot is launched
    findings          a tool's text in a line
    checks            the tools, and what each costs
    table             what each suspect would answer
    examples          what findings look like, and the tables in print
    proof             when a diagnosis is proved
    fixes             the fixes
    patient           a faulty robot as plain data
    simulate_patient  how a patient is made
    archive           many patients, none made twice
    visit             an examination of a patient
    practice          patients to practise on
    panel             a visit with controls

A cause is made on a running robot, every tool is run on it, and only what they print is kept.
"""
