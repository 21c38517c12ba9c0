"""Write what the instructor and the learners read: tables, feedback, the page of the class.

In reading order:

    gradebook      grades as CSV and records as JSON
    html           tables, figures and texts of HTML pages
    feedback       a page for each learner
    gain           the concept inventory before and after the course
    class_figures  figures of a class
    class_page     mistakes and misconceptions of the class
"""
