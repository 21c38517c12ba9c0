"""What became of an answer, and the words for it.

    verdict    what became of an answer
    options    what was meant by a word that is none to choose from
    mistake    what may be wrong with it, in two tables of words
    replies    what `check` says besides
    comparison the wrong answer drawn beside the right one

Start with `verdict.py`.
"""
