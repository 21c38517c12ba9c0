"""Write what the doctor found, in English or Korean.

sentences   the texts of each finding, and how certain it is
text        the report in a terminal, and as JSON
history     each edge through time, as SVG
scene3d     the frames in 3D at one time, as SVG
html        the report as a page
"""
