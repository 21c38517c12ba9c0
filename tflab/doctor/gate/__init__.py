"""Let programs use the doctor.

expectations  what a good recording looks like, as a small file, and deviations from it
filters       findings that are ignored: --ignore, a baseline
formats       JUnit, SARIF, GitHub annotations, and a table of many recordings
"""
