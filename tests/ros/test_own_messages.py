"""Message packages that learners define from .msg texts, or from classes."""

import importlib
import sys
from array import array
from pathlib import Path

import pytest
import yaml

from tflab.ros import client_library as rclpy
from tflab.ros import messages
from tflab.ros.messages import geometry_msgs, packages
from tflab.ros.messages.text import type_hash
from tflab.ros.messages.values import deserialize_message, serialize_message
from tflab.ros.node import Node

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))

DETECTION = CASES["detection"]
PACKAGE = {
    "Detection.msg": DETECTION,
    "Box.msg": "geometry_msgs/Point corner\nfloat32 width",
    "Caption.msg": 'wstring text "왕관"\nwstring TITLE=hall',
    "Locate.srv": "string label\n---\nbool found\nBox where",
    "Search.action": "string label\n---\nDetection found\n---\nfloat32 progress",
}


@pytest.fixture(autouse=True)
def forget():
    yield
    for package in list(packages._defined):
        del packages._defined[package]
        for name in [name for name in sys.modules if name.partition(".")[0] == package]:
            del sys.modules[name]


def test_a_defined_package_is_imported_like_a_built_package():
    messages.define("my_msgs", PACKAGE)
    detection = importlib.import_module("my_msgs.msg").Detection()
    assert (detection.label, detection.score, detection.UNKNOWN, detection.MODEL) == ("no # name", 0.5, 255, "small")
    detection.counts[0] = 9
    detection = type(detection)()  # defaults are each message's own
    assert (detection.counts.tolist(), detection.is_sure, detection.boxes) == ([1, 2, 3], True, [])
    corners = detection.corners
    assert corners == [geometry_msgs.Point()] * 2 and corners[0] is not corners[1] is not type(detection)().corners[1]
    assert (detection.sides, detection.flags, detection.raw) == (["left", "right"], [False, False], [b"\0", b"\0"])
    caption = importlib.import_module("my_msgs.msg").Caption()
    assert (detection.tag, caption.text, caption.TITLE) == ("", "왕관", "hall")
    types = detection.get_fields_and_field_types() | caption.get_fields_and_field_types()
    assert (types["sides"], types["tag"], types["text"]) == ("string<5>[2]", "string<8>", "wstring")
    box = importlib.import_module("my_msgs.msg").Box(width=2.0)
    assert repr(box) == "my_msgs.msg.Box(corner=geometry_msgs.msg.Point(x=0.0, y=0.0, z=0.0), width=2.0)"
    srv, action = (importlib.import_module(f"my_msgs.{kind}") for kind in ("srv", "action"))
    assert srv.Locate.Response().where == type(box)() and srv.Locate.Response is srv.Locate_Response
    assert action.Search.Result().found == detection and action.Search.Goal is action.Search_Goal
    assert messages.type_named("my_msgs/msg/Box") is type(box)


def test_the_same_cell_again_gives_the_same_classes_and_another_text_or_folder_new_ones(tmp_path):
    first = messages.define("my_msgs", PACKAGE)
    assert messages.define("my_msgs", dict(PACKAGE)).msg.Box is first.msg.Box
    assert messages.define("my_msgs", {"Box.msg": "float64 width"}).msg.Box is not first.msg.Box
    for name, text in PACKAGE.items():
        folder = tmp_path / name.rpartition(".")[2] / "found"
        folder.mkdir(exist_ok=True, parents=True)
        (folder / name).write_text(text, encoding="utf-8")
    assert messages.define("my_msgs", tmp_path).msg.Detection().score == 0.5
    (tmp_path / "msg/Box.msg").write_text("float64 width")
    with pytest.raises(ValueError, match="two definitions of one name"):
        messages.define("my_msgs", tmp_path)


def test_a_bounded_string_and_a_fixed_array_refuse_what_does_not_fit():
    detection = messages.define("my_msgs", PACKAGE).msg.Detection
    for values, text in CASES["does_not_fit"]:
        with pytest.raises(AssertionError, match=text):
            detection(check_fields=True, **values)


@pytest.mark.parametrize(("package", "definitions", "text"), CASES["invalid"])
def test_an_invalid_definition_raises_with_its_fault(package, definitions, text):
    with pytest.raises(ValueError, match=text.replace(".", r"\.")):
        messages.define(package, definitions)
    assert package not in packages._defined
    with pytest.raises(KeyError, match="nope_msgs/msg/Nope"):
        messages.define("my_msgs", {"A.msg": "nope_msgs/Nope x"})


class Foreign:
    """What rosidl's Python classes have that rclpy asks for."""

    __slots__ = ["_data"]
    __module__ = "test_msgs.msg._foreign"

    def __init__(self, data=()):
        self._data = array("d", data)

    @property
    def data(self):
        return self._data

    @classmethod
    def get_fields_and_field_types(cls):
        return {"data": "sequence<double>"}


def test_a_class_that_looks_like_a_generated_message_travels(graph):
    received = []
    sent = Foreign([1.0])

    def main():
        rclpy.init()
        node = Node("talker")
        publisher = node.create_publisher(Foreign, "/foreign", 10)
        node.create_subscription(Foreign, "/foreign", received.append, 10)
        publisher.publish(sent)
        sent.data[0] = 9.0
        assert dict(node.get_topic_names_and_types())["/foreign"] == ["test_msgs/msg/Foreign"]
        rclpy.spin(node)

    graph.start(main)
    graph.run(seconds=0.1)
    assert [each.data.tolist() for each in received] == [[1.0]]


def test_a_defined_service_answers_and_a_defined_message_survives_serialization(graph):
    srv = messages.define("my_msgs", PACKAGE).srv.Locate
    answers = []

    def main():
        rclpy.init()
        node = Node("locator")

        def locate(request, response):
            response.found = request.label == "cup"
            return response

        node.create_service(srv, "locate", locate)
        client = node.create_client(srv, "locate")
        future = client.call_async(srv.Request(label="cup"))
        rclpy.spin_until_future_complete(node, future)
        answers.append(future.result().found)

    graph.start(main)
    graph.run(seconds=0.1)
    assert answers == [True]
    module = messages.define("my_msgs", PACKAGE)
    sent = module.msg.Detection(label="cup", boxes=[module.msg.Box(width=2.0)])
    assert deserialize_message(serialize_message(sent), module.msg.Detection) == sent
    assert type_hash("my_msgs/msg/Box").startswith("RIHS01_")
    assert type_hash("nope_msgs/msg/Nope") == "INVALID"
