"""What the instructor and the learners read.

    gradebook      CSV and JSON
    feedback       a page for each learner
    html           what such pages share
    gain           a test before and after
    class_figures  pictures of a class
    gain_section   the same on the class's page
    class_page     what the class misunderstands

Start with `gradebook.py`.
"""
