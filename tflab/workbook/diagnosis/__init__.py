"""Judge an answer, and explain a wrong one by the mistakes that would produce it.

verdict               judge outcomes, and say what is wrong, from coarse to fine
failure               the ways in which an answer can fail, and what is said of each
question              an answer to be explained, and a row of a table of explanations
explain               the table of explanations of a whole answer
explanation           what an explanation is, and several merged
parts                 the table of explanations of one part of an answer
part_mistakes         mistakes of a task that explain some parts
calls                 what a function does in some of its calls
options               options that are confused
constants_and_inputs  one result for all calls, an input unchanged, a factor reversed
links                 the links of a robot
wrong_types           answers of another type (`conditions.yaml`: when each explanation is true)
matching              outcomes compared with what a mistake gives
generic               mistakes that any answer can have
precision             what got lost and cannot be corrections
trees                 trees of frames
command_lines         command lines
python_errors         what Python's errors mean
error_line            the line in which a function stopped
lint                  what is wrong in a function's text
comparison            a wrong pose drawn with the right one
"""
