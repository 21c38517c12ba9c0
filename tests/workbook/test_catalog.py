"""A learner's tasks are computed on demand, and the page that asks for them does not change."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from types import ModuleType
from typing import Any

import pytest

from tflab import ros
from tflab.ros.logging import write_to_stdout
from tflab.ros.messages import field_checks, set_field_checks
from tflab.ros.process import process_here
from tflab.workbook import check
from tflab.workbook.answers.values import from_plain
from tflab.workbook.paths import Workbook, workbook_data
from tflab.workbook.tasks import catalog
from tflab.workbook.tasks.catalog import assigned_cases, outlines, question_digest, solution_of, task_ids, tasks_of
from tflab.workbook.tasks.reference import in_process_ros
from tflab.workbook.tasks.task import read_tasks

from . import small_chapter as chapter

TASKS = {  # that use ROS 2: what they give, their solutions or their mistakes
    "E6.4": "06_static_and_dynamic",
    "E8.3": "08_buffer_and_measurement_time",
    "E9.3": "09_exceptions_and_waiting",
    "E12.1": "12_owners_and_diagnosis",
}


@pytest.fixture(autouse=True)
def nothing_computed(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Nothing was computed before in this process, so it happens in the test."""
    monkeypatch.delenv("NBGRADER_EXECUTION", raising=False)
    for cache in (catalog._tasks, catalog._solution, catalog._assigned):
        cache.cache_clear()
    yield


def right_answer(task_id: str) -> Any:
    """Return what the solution of a task answers."""
    data, stem = workbook_data(), TASKS[task_id]
    (variant,) = assigned_cases(data, stem, task_id, Workbook()).variants
    given = None if variant.given is None else {name: from_plain(value) for name, value in variant.given.items()}
    with in_process_ros():
        answer = solution_of(data, stem).answer(tasks_of(data, stem)[task_id], given)
    catalog._assigned.cache_clear()
    return answer


def ros_modules() -> dict[str, ModuleType]:
    """Return the modules of ROS 2 that are imported."""
    packages = ros.activation.PACKAGES
    return {name: module for name, module in sys.modules.items() if name.partition(".")[0] in packages}


@pytest.mark.parametrize("task_id", TASKS)
def test_a_check_does_not_change_the_graph_the_modules_and_the_field_checks(undone, capfd, task_id: str) -> None:
    assigned_cases(workbook_data(), TASKS[task_id], task_id, Workbook())
    assert capfd.readouterr() == ("", "")
    are_checked = task_id in ("E6.4", "E8.3")
    ros.activate("in-process")
    set_field_checks(are_checked)
    write_to_stdout(True)
    graph = ros.new_graph(virtual=True)
    import rclpy
    from std_msgs.msg import String

    rclpy.init()
    node = rclpy.create_node("mine")
    heard: list[str] = []
    node.create_subscription(String, "said", lambda message: heard.append(message.data), 10)
    publisher = node.create_publisher(String, "said", 10)
    modules, now = ros_modules(), node.get_clock().now()
    capfd.readouterr()
    catalog._assigned.cache_clear()
    for answer in (12345, lambda *_: 12345):
        check(task_id, answer)
        lines = capfd.readouterr().out.splitlines()
        assert lines[0].startswith(f"{task_id} ✗ 0/")
    assert process_here().graph is graph and modules.items() <= ros_modules().items()
    assert node.get_clock().now() == now and field_checks() is are_checked
    assert node.get_node_names() == ["mine"]
    publisher.publish(String(data="here"))
    rclpy.spin_once(node, timeout_sec=1.0)
    assert heard == ["here"]


@pytest.mark.parametrize("task_id", TASKS)
def test_check_works_with_another_rclpy_imported(monkeypatch, capsys, task_id: str) -> None:
    ros.deactivate()
    answer = right_answer(task_id)
    theirs = {name: ModuleType(name) for name in ("rclpy", "rclpy.node", "tf2_ros", "std_msgs")}
    for name, module in theirs.items():
        module.__file__ = f"/opt/ros/jazzy/{name}/__init__.py"
        monkeypatch.setitem(sys.modules, name, module)
    assert catalog._assigned.cache_info().currsize == 0
    check(task_id, answer)
    assert capsys.readouterr().out.startswith(f"{task_id} ✓")
    assert ros_modules() == theirs and not ros.activation.is_active()


def test_outlines_are_in_order_and_without_cases() -> None:
    found = outlines(workbook_data(), TASKS["E8.3"])
    assert list(found) == task_ids(workbook_data(), TASKS["E8.3"]) == [f"E8.{number}" for number in range(1, 8)]
    for task in found.values():
        assert task.variants == () and task.title.ko and len(task.hints) == 3 and task.feedback


def test_an_edit_of_a_yaml_file_is_read(tmp_path, monkeypatch) -> None:
    chapter.copy_of_workbook(tmp_path, monkeypatch)
    path = workbook_data() / "solutions" / "tasks" / chapter.STEM / "e3_3.yaml"
    assert outlines(workbook_data(), chapter.STEM)["E3.3"].feedback["swapped"].reply.en == "turned round"
    before = path.stat().st_mtime_ns
    path.write_text(path.read_text(encoding="utf-8").replace("en: turned round", "en: exchanged"), encoding="utf-8")
    os.utime(path, ns=(before + 10**9, before + 10**9))
    assert outlines(workbook_data(), chapter.STEM)["E3.3"].feedback["swapped"].reply.en == "exchanged"


def test_a_digest_depends_on_the_question_and_not_on_its_texts(tmp_path, monkeypatch) -> None:
    chapter.copy_of_workbook(tmp_path, monkeypatch)
    task = assigned_cases(workbook_data(), chapter.STEM, "E3.1", Workbook())
    (variant,) = task.variants
    digest = question_digest(task, variant)
    assert question_digest(task._replace(title=task.hints[0]), variant) == digest
    corner = variant.given["laser_p_corner"]
    on_another_machine = variant.given | {
        "laser_p_corner": {"tuple": [corner["tuple"][0] + 1e-12, *corner["tuple"][1:]]}
    }
    assert on_another_machine != variant.given
    assert question_digest(task, variant._replace(given=on_another_machine)) == digest
    assert question_digest(task._replace(points=4), variant) != digest
    assert question_digest(task._replace(answer="corner"), variant) != digest
    assert question_digest(task, variant._replace(given=variant.given | {"laser_p_corner": None})) != digest
    drawn_otherwise = assigned_cases(workbook_data(), chapter.STEM, "E3.1", Workbook(seed="another"))
    assert question_digest(task, drawn_otherwise.variants[0]) != digest


def test_threads_can_read_the_tasks_of_one_chapter():
    folder = workbook_data() / "solutions" / "tasks" / "08_buffer_and_measurement_time"

    def read(_):
        with in_process_ros():
            return [task.id for task in read_tasks(folder)]

    with ThreadPoolExecutor(8) as threads:
        (ids,) = {tuple(found) for found in threads.map(read, range(16))}
    assert len(ids) == 7
