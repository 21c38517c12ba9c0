"""What the doctor says, and how it is written down.

    sentences    what a finding is told with
    tree_texts   of names, trees, numbers, owners and mounts
    time_texts   of time
    gate_texts   of what is not as expected
    texts        all of them, and how the blanks are filled
    certainty    how sure, and what would settle it
    faults       which finding names which fault
    text         the report in a terminal, and as JSON
    history      each edge through time, as pictures
    scene3d      the frames in 3D at a moment
    html         the report as a page

Start with `sentences.py`.
"""
