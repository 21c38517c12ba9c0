"""The lecture's nodes stand in the pages as they are run in the tests, in both languages."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from tflab.workbook.places import workbook_data

LECTURE = Path(__file__).parents[1] / "ros" / "lecture"
IN_ENGLISH = {  # what the lecture's nodes say, which is Korean
    "frame_id가 없는 Point 거절": "refused: a point without a frame_id",
    "TF 변환 실패": "no transform",
    "base_link → laser_frame 발행": "sent: base_link → laser_frame",
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
