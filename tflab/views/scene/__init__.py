"""Show a 3D scene inside a page.

shapes    meshes of arrows, axes and bodies, for meshcat
state     the last command on every part of a scene, and the scene as text
widget    Scene: meshcat's viewer in a cell, without a server
drawing   frames, scans, cameras and robots
"""

from .drawing import (
    Part,
    draw_arrow,
    draw_ball,
    draw_camera,
    draw_frame,
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
    "draw_mug",
    "draw_path",
    "draw_points",
    "draw_robot",
    "draw_scan",
    "viewer_file",
]
