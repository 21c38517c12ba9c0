"""Write what the doctor found, in English or Korean.

sentences   the texts of each finding, and how certain it is
text        the report in a terminal, and as JSON
drawings    timeline and frames, as SVG
html        the report as a page
"""
