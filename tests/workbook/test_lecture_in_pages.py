"""The lecture's nodes, commands and tables are on the pages, in both languages."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
import yaml

from tflab.workbook.paths import workbook_data

LECTURE = Path(__file__).parents[1] / "ros" / "lecture"
CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))
FENCE = re.compile(r"```python\n(.*?)```", re.DOTALL)


@pytest.mark.parametrize("language", ["en", "ko"])
@pytest.mark.parametrize(
    ("stem", "node"),
    [
        ("08_buffer_and_measurement_time", "point_to_map.py"),
    ],
)
def test_a_node_of_the_lecture_is_shown_and_speaks_the_language_of_the_page(stem, node, language):
    page = json.loads((workbook_data() / "notebooks" / language / f"{stem}.ipynb").read_text(encoding="utf-8"))
    prose = ["".join(cell["source"]) for cell in page["cells"] if cell["cell_type"] == "markdown"]
    shown = [lines(block) for text in prose for block in FENCE.findall(text)]
    program = (LECTURE / node).read_text(encoding="utf-8")
    for korean, english in CASES["in_english"].items() if language == "en" else ():
        program = program.replace(korean, english)
    assert lines(program) in shown
    assert language == "ko" or not re.search("[가-힣]", "".join(prose))


@pytest.mark.parametrize("language", ["en", "ko"])
@pytest.mark.parametrize("node", ["static_sensor_broadcaster.py", "moving_robot_broadcaster.py"])
def test_a_file_to_take_home_is_the_lectures_but_for_lines_that_stand_beside_it(node, language):
    texts = "\n".join(page_of(6, language).values())
    program = (LECTURE / node).read_text(encoding="utf-8")
    for korean, english in CASES["in_english"].items():
        program = program.replace(korean, english)
    for old, new in CASES["today"].items():
        assert old in texts, f"the lecture's form: {old}"
        program = program.replace(old, new)
    assert lines(program) in [lines(block) for block in FENCE.findall(texts)]
    assert "RCLError" in texts


def page_of(chapter, language):
    """Return the cells of a chapter's page, by their names."""
    (path,) = (workbook_data() / "notebooks" / language).glob(f"{chapter:02}_*.ipynb")
    return {cell["id"]: "".join(cell["source"]) for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]}


@pytest.mark.parametrize("language", ["en", "ko"])
def test_the_commands_and_tables_of_the_lecture_are_on_the_pages_of_their_chapters(language):
    for section, (chapter, *commands) in CASES["commands"].items():
        words = " ".join(" ".join(page_of(chapter, language).values()).replace("\\\n", " ").split())
        assert not [command for command in commands if command not in words], f"of section {section}"
    for chapter, name, count in CASES["rows"]:
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
