"""Provide what a page draws, runs and shows, as `lesson.…`: robots, scenes, panels, recordings.

    from tflab.workbook import lesson

What a page calls as `lesson.…` is this workbook's.  Everything else on it is Python or ROS 2, and runs
on a robot.

    scenes          the teaching robot in its room, and the point clouds of its camera
    panels          panels of a tree and of the joints of the arm
    robots          robots with faults, and nodes that record what happens to them
    toolbox         which of seven tools answers which of seven questions
    recordings      what a bag holds, and what it can place
    clinic_visits   patients in the language of the copy, and two orders of questions
    capstone        launch a robot as the answer to E12.5 describes it
"""

from __future__ import annotations

from tflab.bags.info import example_bag
from tflab.bags.reader import read_bag
from tflab.clinic.causes import BaseLocalizer
from tflab.clinic.panel import clinic_panel
from tflab.clinic.practice import answer_of, practice_patient, worked_patient
from tflab.clinic.practice import two_fault_patient as night_shift
from tflab.core import LATEST
from tflab.core.quaternions import angle, xyzw_from_wxyz
from tflab.robots.model import link_poses
from tflab.robots.motion import Drive, Leg, PlanarPose
from tflab.robots.nodes import launch
from tflab.robots.sensors import BALL, ROOM
from tflab.robots.teaching import Source, TeachingRobot, teaching_urdf
from tflab.robots.urdf import parse_urdf
from tflab.ros import new_graph
from tflab.ros.graph import current_graph
from tflab.tools.rviz import look
from tflab.tools.trees import draw_buffer, draw_history, draw_walk, frame_tree
from tflab.views.ages import Curve, Journey, draw_ages, draw_journeys
from tflab.views.axes import (
    BODY_T_OPTICAL,
    draw_body_axes,
    draw_cameras,
    draw_card,
    draw_right_hand,
    draw_rotation,
    optical_from_body,
)
from tflab.views.clocks import Play, draw_clocks
from tflab.views.coordinates import draw_moments, draw_rulers, readings_of
from tflab.views.frames import draw_scene
from tflab.views.late_joiner import Sender, draw_joins
from tflab.views.late_joiner import SentMessage as Letter
from tflab.views.map_error import draw_detections, draw_placed, draw_tracks
from tflab.views.motion_error import Bend, Sight, draw_bend, draw_latency, latency_error
from tflab.views.moved_frames import draw_moves
from tflab.views.panels import (
    cameras_panel,
    clocks_panel,
    joins_panel,
    latency_panel,
    mount_panel,
    rate_panel,
    rotation_panel,
    rulers_panel,
    sentence_panel,
    timeline_panel,
)
from tflab.views.projection import FROM_ABOVE
from tflab.views.rotations import draw_drives, draw_orders, draw_turns
from tflab.views.scene import Scene, draw_arrow, draw_ball, draw_camera, draw_frame, draw_mug, draw_path, draw_scan
from tflab.views.scene.drawing import ACCENT
from tflab.views.sentence import draw_readings, draw_sentence
from tflab.views.style import fmt, fmt_all
from tflab.views.timeline import lane_from_history
from tflab.views.transform_chain import FROM_THE_SIDE, draw_dominoes
from tflab.views.wrong_frames import describe_extent, draw_misread, draw_mount, seen_from

from ..copy.environment import check_environment
from ..course.course_map import draw_course
from ..course.progress_page import show_progress
from ..warm_up import ask_first
from .capstone import launch_answer
from .clinic_visits import (
    admit,
    draw_both_ways,
    draw_columns,
    draw_questions,
    second_opinion,
    show_findings,
    show_suspects,
    show_trolley,
)
from .panels import draw_joints, joints_panel, tree_panel
from .recordings import doctor, draw_heard, fresh_folder, place_messages, replay
from .robots import (
    GapWatcher,
    WaitingNode,
    ages_of_decisions,
    draw_lanes,
    draw_rviz,
    on_robot_c,
    run_node,
    show_clock_error,
    start_robot,
    stop_node,
    walls_seen,
)
from .scenes import (
    draw_body,
    draw_room,
    draw_walls,
    floor_cloud,
    scan_on_map,
    show_drive,
    show_latency,
    wall_cloud,
)
from .toolbox import draw_toolbox, tools_panel

__all__ = [
    "ACCENT", "BALL", "BODY_T_OPTICAL", "FROM_ABOVE", "FROM_THE_SIDE", "LATEST", "ROOM", "BaseLocalizer", "Bend",
    "Curve", "Drive", "GapWatcher", "Journey", "Leg", "Letter", "PlanarPose", "Play", "Scene", "Sender", "Sight",
    "Source", "TeachingRobot", "WaitingNode", "admit", "ages_of_decisions", "angle", "answer_of", "ask_first",
    "cameras_panel", "check_environment", "clinic_panel", "clocks_panel", "current_graph", "describe_extent", "doctor",
    "draw_ages", "draw_arrow", "draw_ball", "draw_bend", "draw_body", "draw_body_axes", "draw_both_ways",
    "draw_buffer", "draw_camera", "draw_cameras", "draw_card", "draw_clocks", "draw_columns", "draw_course",
    "draw_detections", "draw_dominoes", "draw_drives", "draw_frame", "draw_heard", "draw_history", "draw_joins",
    "draw_joints", "draw_journeys", "draw_lanes", "draw_latency", "draw_misread", "draw_moments", "draw_mount",
    "draw_moves", "draw_mug", "draw_orders", "draw_path", "draw_placed", "draw_questions", "draw_readings",
    "draw_right_hand", "draw_room", "draw_rotation", "draw_rulers", "draw_rviz", "draw_scan", "draw_scene",
    "draw_sentence", "draw_toolbox", "draw_tracks", "draw_turns", "draw_walk", "draw_walls", "example_bag",
    "floor_cloud", "fmt", "fmt_all", "frame_tree", "fresh_folder", "joins_panel", "joints_panel", "lane_from_history",
    "latency_error", "latency_panel", "launch", "launch_answer", "link_poses", "look", "mount_panel", "new_graph",
    "night_shift", "on_robot_c", "optical_from_body", "parse_urdf", "place_messages", "practice_patient", "rate_panel",
    "read_bag", "readings_of", "replay", "rotation_panel", "rulers_panel", "run_node", "scan_on_map", "second_opinion",
    "seen_from", "sentence_panel", "show_clock_error", "show_drive", "show_findings", "show_latency", "show_progress",
    "show_suspects", "show_trolley", "start_robot", "stop_node", "teaching_urdf", "timeline_panel", "tools_panel",
    "tree_panel", "wall_cloud", "walls_seen", "worked_patient", "xyzw_from_wxyz",
]  # fmt: skip
