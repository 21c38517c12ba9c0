"""The course as a whole: chapters, objectives, checklist, terms, and what a learner has passed.

course          the chapters, objectives and misconceptions, from `course.yaml`
glossary        the terms, from `glossary.yaml`
contents        the parts of the pages that are made from these files
course_map      draw which chapter builds on which
progress_page   what a learner has passed
"""
