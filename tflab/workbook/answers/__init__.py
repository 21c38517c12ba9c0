"""What an answer may be, what it looks like, and when two are the same.

values         an answer as plain JSON
form           what an answer looks like
numeric        numbers, vectors, rotations, transforms
structures     choices, names, lists, messages
members        pairs, sets and trees
command_lines  what one would type
urdf_text      a robot, as its file has it
proof          the checks of a diagnosis
discriminating_check  a check that tells two suspects apart
forms          all of them together
equal_answers  which of many answers are the same
showing        an answer in words
"""
