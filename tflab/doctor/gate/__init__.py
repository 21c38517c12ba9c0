"""How does a machine use the doctor?  What is expected, what is let pass, and the forms that others read.

    expectations  what a good recording looks like, as a small file
    deviations    where a recording is not as expected; two recordings beside each other
    filters       what is let pass: --ignore, a baseline
    junit         the report as a test run
    sarif         the report as static analysis gives it
    annotations   the report as GitHub shows it beside a commit
    table         many recordings, a line each

Start with `expectations.py`.
"""
