"""The workbook: where its pages are, and how they are opened.

    lab    start JupyterLab on them, without a word to the network

Start with `lab.py`.
"""
