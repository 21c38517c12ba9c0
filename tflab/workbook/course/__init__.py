"""The course as a whole: chapters, objectives, checklist, terms, and where a learner stands.

    course          the chapters, as course.yaml has them
    standing        what a learner has shown of them
    glossary        the terms, as glossary.yaml has them
    contents        what of the pages is made from these files
    course_map      which chapter builds on which, drawn
    progress_page   the same, with what was passed

Start with `course.py`.
"""
