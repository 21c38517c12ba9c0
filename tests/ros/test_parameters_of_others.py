"""One node reads, sets and watches the parameters of another."""

import pytest

from tflab.ros import client_library as rclpy
from tflab.ros.executors import SingleThreadedExecutor
from tflab.ros.messages.rcl_interfaces import ParameterDescriptor, ParameterEvent, ParameterType
from tflab.ros.node import Node
from tflab.ros.parameter import Parameter
from tflab.ros.parameter_services import AsyncParameterClient, ParameterEventHandler

#   /lab/asking  --parameter services-->  /lab/robot: speed = 1.5, ids = [1, 2, 3]


@pytest.fixture
def nodes(graph):
    rclpy.init()
    asking = Node("asking", namespace="/lab")
    robot = Node("robot", namespace="/lab", allow_undeclared_parameters=True)
    robot.declare_parameter("speed", 1.5)
    robot.declare_parameter("ids", [1, 2, 3])
    yield asking, robot
    rclpy.shutdown()


def answer(nodes, future):
    executor = SingleThreadedExecutor()
    for node in nodes:
        executor.add_node(node)
    executor.spin_until_future_complete(future, timeout_sec=1.0)
    return future.result()


def spin_some(nodes):
    executor = SingleThreadedExecutor()
    for node in nodes:
        executor.add_node(node)
    for _ in range(20):
        executor.spin_once(timeout_sec=0)


def test_parameters_of_another_node_are_read_by_a_relative_name(nodes):
    client = AsyncParameterClient(nodes[0], "robot")
    assert client.services_are_ready()
    values = answer(nodes, client.get_parameters(["speed", "ids"])).values
    assert (values[0].double_value, list(values[1].integer_array_value)) == (1.5, [1, 2, 3])
    assert "speed" in answer(nodes, client.list_parameters()).result.names
    assert list(answer(nodes, client.get_parameter_types(["ids"])).types) == [ParameterType.PARAMETER_INTEGER_ARRAY]
    assert answer(nodes, client.describe_parameters(["ids"])).descriptors[0].name == "ids"


def test_parameters_are_set_each_by_itself_or_all_or_none(nodes):
    client = AsyncParameterClient(nodes[0], "/lab/robot")
    wanted = [Parameter("speed", value=2.5), Parameter("ids", value="none").to_parameter_msg()]
    results = answer(nodes, client.set_parameters(wanted)).results
    assert [result.successful for result in results] == [True, False]
    assert nodes[1].get_parameter("speed").value == 2.5
    wanted = [Parameter("speed", value=3.5), Parameter("ids", value="none")]
    assert not answer(nodes, client.set_parameters_atomically(wanted)).result.successful
    assert nodes[1].get_parameter("speed").value == 2.5


def test_only_dynamically_typed_parameters_can_be_deleted(nodes):
    nodes[1].declare_parameter("loose", 10, ParameterDescriptor(dynamic_typing=True))
    client = AsyncParameterClient(nodes[0], "robot")
    (refused,) = answer(nodes, client.delete_parameters(["speed"])).results
    assert (refused.successful, refused.reason) == (False, "Static parameter cannot be undeclared")
    assert answer(nodes, client.delete_parameters(["loose"])).results[0].successful
    assert not nodes[1].has_parameter("loose")


@pytest.mark.parametrize("atomically", [False, True])
def test_a_parameter_file_is_set_on_another_node(nodes, tmp_path, atomically):
    file = tmp_path / "robot.yaml"
    file.write_text("/lab/robot:\n  ros__parameters:\n    speed: 0.5\n    arm: {length: 2}\n")
    client = AsyncParameterClient(nodes[0], "robot")
    load = client.load_parameter_file_atomically if atomically else client.load_parameter_file
    answer(nodes, load(str(file)))
    assert [nodes[1].get_parameter(name).value for name in ("speed", "arm.length")] == [0.5, 2]


def test_a_callback_gets_the_future_when_the_answer_is_there(nodes):
    got = []
    client = AsyncParameterClient(nodes[0], "robot")
    future = client.get_parameters(["speed"], callback=got.append)
    answer(nodes, future)
    assert got == [future]


def test_services_that_never_come_are_waited_for_no_longer_than_was_said(nodes, graph):
    before_ns = graph.now_ns
    assert AsyncParameterClient(nodes[0], "nobody").wait_for_services(timeout_sec=1.0) is False
    assert graph.now_ns - before_ns == 1_000_000_000


def test_events_can_be_subscribed_to_from_the_client(nodes):
    heard = []
    AsyncParameterClient(nodes[0], "robot").on_parameter_event(heard.append)
    nodes[1].set_parameters([Parameter("speed", value=9.0)])
    spin_some(nodes)
    assert [(event.node, event.changed_parameters[0].name) for event in heard] == [("/lab/robot", "speed")]


def test_a_watcher_hears_of_one_parameter_of_one_node_what_was_added_last_first(nodes):
    heard = []
    handler = ParameterEventHandler(nodes[0])
    handler.add_parameter_callback("speed", "robot", lambda parameter: heard.append(("first", parameter)))
    handler.add_parameter_callback("speed", "/lab/robot", lambda parameter: heard.append(("second", parameter)))
    nodes[1].set_parameters([Parameter("speed", value=9.0), Parameter("ids", value=[4])])
    nodes[0].declare_parameter("speed", 0.0)
    spin_some(nodes)
    assert [(who, parameter.name, parameter.value.double_value) for who, parameter in heard] == [
        ("second", "speed", 9.0), ("first", "speed", 9.0),
    ]  # fmt: skip


def test_a_watcher_of_its_own_node_needs_no_name(nodes):
    heard = []
    ParameterEventHandler(nodes[0]).add_parameter_callback("mode", "", heard.append)
    nodes[0].declare_parameter("mode", "idle")
    spin_some(nodes)
    assert [parameter.value.string_value for parameter in heard] == ["idle"]


def test_a_watcher_of_events_hears_every_node_until_it_is_taken_away(nodes):
    heard = []
    handler = ParameterEventHandler(nodes[0])
    handle = handler.add_parameter_event_callback(lambda event: heard.append(event.node))
    nodes[1].set_parameters([Parameter("speed", value=9.0)])
    nodes[0].declare_parameter("mode", "idle")
    spin_some(nodes)
    handler.remove_parameter_event_callback(handle)
    nodes[1].set_parameters([Parameter("speed", value=8.0)])
    spin_some(nodes)
    assert heard == ["/lab/robot", "/lab/asking"]
    with pytest.raises(RuntimeError, match="Callback doesn't exist"):
        handler.remove_parameter_event_callback(handle)


def test_a_callback_may_take_itself_away(nodes):
    heard = []
    handler = ParameterEventHandler(nodes[0])

    def once(parameter):
        heard.append(parameter.value.double_value)
        handler.remove_parameter_callback(handle)

    handle = handler.add_parameter_callback("speed", "robot", once)
    for speed in (7.0, 8.0):
        nodes[1].set_parameters([Parameter("speed", value=speed)])
    spin_some(nodes)
    assert heard == [7.0]
    with pytest.raises(RuntimeError, match="Callback doesn't exist"):
        handler.remove_parameter_callback(handle)


def test_a_destroyed_watcher_hears_nothing(nodes):
    heard = []
    handler = ParameterEventHandler(nodes[0])
    handler.add_parameter_event_callback(heard.append)
    handler.destroy()
    nodes[1].set_parameters([Parameter("speed", value=9.0)])
    spin_some(nodes)
    assert heard == []


def test_an_event_can_be_taken_apart():
    new, changed = Parameter("a", value=1).to_parameter_msg(), Parameter("b", value=2).to_parameter_msg()
    event = ParameterEvent(node="/n", new_parameters=[new], changed_parameters=[changed])
    assert list(ParameterEventHandler.get_parameters_from_event(event)) == [new, changed]
    assert ParameterEventHandler.get_parameter_from_event(event, "b", "/n") == changed
    assert ParameterEventHandler.get_parameter_from_event(event, "b", "/m") is None
    assert ParameterEventHandler.get_parameter_from_event(event, "c", "/n") is None
