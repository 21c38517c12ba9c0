"""In three dimensions, inside the page: a scene, and what is drawn into it.

    shapes    what arrows and axes are made of
    meshes    the same, as meshcat wants it
    state     the last word on everything in a scene
    words     the scene, said
    widget    Scene: meshcat's viewer in a cell, without a server
    drawing   frames, scans, cameras and robots

Start with `shapes.py`.
"""

from .drawing import (
    Part,
    draw_arrow,
    draw_ball,
    draw_camera,
    draw_frame,
    draw_frames,
    draw_mug,
    draw_path,
    draw_points,
    draw_robot,
    draw_scan,
)
from .widget import Scene, viewer_file

__all__ = [
    "Part",
    "Scene",
    "draw_arrow",
    "draw_ball",
    "draw_camera",
    "draw_frame",
    "draw_frames",
    "draw_mug",
    "draw_path",
    "draw_points",
    "draw_robot",
    "draw_scan",
    "viewer_file",
]
