"""A learner's own copy: laid out, brought up to date, opened in JupyterLab.

    lay_out      the folder, and what was handed out
    merge        new material around what was written: a three-way merge
    environment  whether this machine has what the pages need
    lab          JupyterLab on it, offline

Start with `lay_out.py`.
"""
