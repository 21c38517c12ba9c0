"""The lecture's nodes, commands and tables are on the pages, in both languages."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from tflab.workbook.paths import workbook_data

LECTURE = Path(__file__).parents[1] / "ros" / "lecture"
IN_ENGLISH = {  # what the lecture's nodes say, which is Korean
    "frame_id가 없는 Point 거절": "refused: a point without a frame_id",
    "TF 변환 실패": "no transform",
    "base_link → laser_frame 발행": "sent: base_link → laser_frame",
}
VIEW, ECHO, MONITOR = "ros2 run tf2_tools view_frames", "ros2 run tf2_ros tf2_echo", "ros2 run tf2_ros tf2_monitor"
COMMANDS = {  # of each section what it lets one type, and the chapter that has it
    7: (6, ["ros2 topic info /tf_static --verbose", "ros2 topic echo /tf_static --once"]),
    8: (6, ["--frame-id base_link --child-frame-id laser_frame", "static_transform_publisher --help"]),
    11: (7, ["topic echo /robot_description --once", "topic echo /joint_states", "node info /robot_state_publisher"]),
    12: (11, [VIEW, f"{VIEW} --help"]),
    13: (3, [f"{ECHO} base_link laser_frame", f"{ECHO} odom base_link", f"{ECHO} map base_link"]),
    14: (11, [MONITOR, "odom → base_link"]),
    15: (11, ["rviz2", "Fixed Frame", "Show Names", "Show Axes", "LaserScan", "PointCloud2", "RobotModel"]),
    22: (10, ["ros2 topic echo /clock --once", "ros2 param get /point_to_map use_sim_time",
              "ros2 param set /point_to_map use_sim_time true", "/**: ros__parameters: use_sim_time: true",
              "ros2 bag record /scan /odom /tf /tf_static /clock"]),
    23: (12, ["--frame-id map --child-frame-id odom", "--x 1 {zero} --frame-id odom --child-frame-id base_link",
              "--frame-id odm --child-frame-id base_link", "tf2_echo map base_link"]),
    27: (12, ["ros2 node list", VIEW, f"{ECHO} map base_link", f"{MONITOR} map base_link",
              "ros2 topic info /tf --verbose", "ros2 topic info /tf_static --verbose",
              "ros2 topic echo /tf_static --once", "ros2 param get /problem_node use_sim_time"]),
}  # fmt: skip
ROWS = {  # tables and lists: the cell that has them, and how many rows
    (11, "symptoms"): 8,  # §15 has six of them
    (12, "owner-blank"): 6,  # §24, and a row to fill in
    (12, "ten"): 10,  # §28
    (12, "twelve"): 12,  # §29
}
FENCE = re.compile(r"```python\n(.*?)```", re.DOTALL)


@pytest.mark.parametrize("language", ["en", "ko"])
@pytest.mark.parametrize(
    ("stem", "node"),
    [
        ("06_static_and_dynamic", "static_sensor_broadcaster.py"),
        ("06_static_and_dynamic", "moving_robot_broadcaster.py"),
        ("08_buffer_and_measurement_time", "point_to_map.py"),
    ],
)
def test_a_node_of_the_lecture_is_shown_and_speaks_the_language_of_the_page(stem, node, language):
    page = json.loads((workbook_data() / "notebooks" / language / f"{stem}.ipynb").read_text(encoding="utf-8"))
    prose = ["".join(cell["source"]) for cell in page["cells"] if cell["cell_type"] == "markdown"]
    shown = [lines(block) for text in prose for block in FENCE.findall(text)]
    program = (LECTURE / node).read_text(encoding="utf-8")
    for korean, english in IN_ENGLISH.items() if language == "en" else ():
        program = program.replace(korean, english)
    assert lines(program) in shown
    assert language == "ko" or not re.search("[가-힣]", "".join(prose))


def page_of(chapter, language):
    """Return the cells of a chapter's page, by their names."""
    (path,) = (workbook_data() / "notebooks" / language).glob(f"{chapter:02}_*.ipynb")
    return {cell["id"]: "".join(cell["source"]) for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]}


@pytest.mark.parametrize("language", ["en", "ko"])
def test_the_commands_and_tables_of_the_lecture_are_on_the_pages_of_their_chapters(language):
    for section, (chapter, commands) in COMMANDS.items():
        words = " ".join(" ".join(page_of(chapter, language).values()).replace("\\\n", " ").split())
        assert not [command for command in commands if command not in words], f"of section {section}"
    for (chapter, name), count in ROWS.items():
        rows = [line for line in page_of(chapter, language)[name].splitlines() if line.startswith("|")]
        assert len(rows) == count + 2, name  # the head, and its rule


def test_the_lectures_urdf_is_read_as_it_is():
    path = workbook_data() / "notebooks" / "en" / "07_urdf_and_sensors.ipynb"
    cells = {cell["id"]: cell for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]}
    cell = cells["lecture-urdf"]
    assert (LECTURE / "robot.urdf").read_text(encoding="utf-8").strip() in "".join(cell["source"])
    assert "".join(cell["outputs"][0]["text"]).startswith("base_T_laser (0.200, 0.000, 0.150) m")


def lines(text: str) -> list[str]:
    """Return the lines that are code, without the comments of either."""
    without = (re.sub(r"\s*#.*", "", line) for line in text.splitlines())
    return [line for line in without if line.strip()]
