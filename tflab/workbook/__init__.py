"""The workbook: where its pages are, how they are opened, and how they are written for reading.

    build  run the pages and write them as HTML
    lab    start JupyterLab on them, without a word to the network

Start with `build.py`.
"""
