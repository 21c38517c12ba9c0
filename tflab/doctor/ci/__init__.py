"""Use the doctor in CI: expectations of a good recording, accepted findings, and reports for other programs.

expectations  what a good recording looks like, as a small file, and deviations from it
filters       findings that are ignored: --ignore, a baseline
formats       JUnit, SARIF, GitHub annotations, and a table of many recordings
"""
