"""Parameters: declared with types, set through checks, and read and set by other nodes."""

import pytest

from tflab.ros.arguments import _concerns
from tflab.ros.client_library import create_node, init, shutdown
from tflab.ros.exceptions import (
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterNotDeclaredException,
)
from tflab.ros.executors import SingleThreadedExecutor
from tflab.ros.messages.rcl_interfaces import (
    FloatingPointRange,
    IntegerRange,
    ParameterDescriptor,
    ParameterEvent,
    ParameterType,
    SetParametersResult,
)
from tflab.ros.node import Node
from tflab.ros.parameter import Parameter
from tflab.ros.parameter_services import AsyncParameterClient, ParameterEventHandler

TYPE = Parameter.Type


@pytest.fixture(autouse=True)
def context(graph):
    init(args=[])
    yield
    shutdown()


def set_one(node, name, value):
    return node.set_parameters([Parameter(name, value=value)])[0]


# A parameter ----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("value", "type_"),
    [
        (None, TYPE.NOT_SET),
        (True, TYPE.BOOL),
        (1, TYPE.INTEGER),
        (1.0, TYPE.DOUBLE),
        ("map", TYPE.STRING),
        ([b"\x01"], TYPE.BYTE_ARRAY),
        ([True], TYPE.BOOL_ARRAY),
        ([1, 2], TYPE.INTEGER_ARRAY),
        ([1.0], TYPE.DOUBLE_ARRAY),
        (["a"], TYPE.STRING_ARRAY),
        ([], TYPE.BYTE_ARRAY),
    ],
)
def test_the_type_of_a_value_is_the_first_that_fits(value, type_):
    parameter = Parameter("p", value=value)
    assert parameter.type_ is type_
    assert Parameter.from_parameter_msg(parameter.to_parameter_msg()).type_ is type_


def test_type_and_value_must_agree():
    with pytest.raises(ValueError, match=r"Type 'Type\.DOUBLE' and value '1' do not agree"):
        Parameter("p", TYPE.DOUBLE, 1)
    with pytest.raises(TypeError):
        Parameter("p", value={"a": 1})


# Declaring and reading ------------------------------------------------------------


def test_a_parameter_is_declared_once_with_a_default_and_use_sim_time_is_always_there():
    node = create_node("n")
    assert node.declare_parameter("rate", 20.0).value == 20.0
    assert node.get_parameter("rate").value == 20.0
    assert [parameter.value for parameter in node.get_parameters(["rate", "use_sim_time"])] == [20.0, False]
    with pytest.raises(ParameterAlreadyDeclaredException, match=r"Parameter\(s\) already declared: \['rate'\]"):
        node.declare_parameter("rate", 1.0)


def test_an_undeclared_parameter_can_be_neither_read_nor_set_unless_the_node_allows_it():
    node = create_node("n")
    with pytest.raises(ParameterNotDeclaredException) as reading:
        node.get_parameter("x")
    assert str(reading.value) == "Invalid access to undeclared parameter(s): x"
    with pytest.raises(ParameterNotDeclaredException) as setting:
        set_one(node, "x", 1)
    assert str(setting.value) == "Invalid access to undeclared parameter(s): ['x']"
    node = create_node("lenient", allow_undeclared_parameters=True)
    assert node.get_parameter("x").type_ is TYPE.NOT_SET
    assert set_one(node, "x", 1).successful
    assert node.get_parameter("x").value == 1


def test_an_override_wins_over_the_default_unless_it_is_ignored_and_has_its_type():
    overrides = [Parameter("rate", value=5.0), Parameter("name", value="real"), Parameter("count", value=5)]
    node = create_node("n", parameter_overrides=overrides)
    assert node.declare_parameter("rate", 20.0).value == 5.0
    assert node.declare_parameter("name", "default", ignore_override=True).value == "default"
    with pytest.raises(InvalidParameterTypeException):
        node.declare_parameter("count", 20.0)


# Setting --------------------------------------------------------------------------


def test_a_value_of_another_type_is_refused_unless_the_type_is_dynamic_and_any_of_a_read_only_one():
    node = create_node("n")
    node.declare_parameter("rate", 20.0)
    assert (set_one(node, "rate", 50.0).successful, node.get_parameter("rate").value) == (True, 50.0)
    result = set_one(node, "rate", 50)
    assert not result.successful
    assert result.reason == "Wrong parameter type, expected 'Type.DOUBLE' got 'Type.INTEGER'"
    assert node.get_parameter("rate").value == 50.0
    node.declare_parameter("anything", 20.0, ParameterDescriptor(dynamic_typing=True))
    assert set_one(node, "anything", "text").successful
    assert node.get_parameter("anything").value == "text"
    node.declare_parameter("frame_id", "/frame", ParameterDescriptor(read_only=True))
    result = set_one(node, "frame_id", "map")
    assert (result.successful, result.reason) == (False, "Trying to set a read-only parameter: frame_id.")


def test_a_range_is_kept():
    node = create_node("n")
    in_percent = ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=100, step=5)])
    node.declare_parameter("percent", 50, in_percent)
    assert set_one(node, "percent", 100).successful
    assert not set_one(node, "percent", 101).successful
    assert not set_one(node, "percent", 7).successful
    half_open = ParameterDescriptor(floating_point_range=[FloatingPointRange(from_value=0.0, to_value=1.0)])
    with pytest.raises(InvalidParameterValueException):
        node.declare_parameter("ratio", 2.0, half_open)


def test_a_callback_may_reject_with_a_reason():
    node = create_node("n")
    node.declare_parameter("rate", 20.0)
    node.add_on_set_parameters_callback(
        lambda parameters: SetParametersResult(successful=parameters[0].value > 0.0, reason="must be positive")
    )
    result = set_one(node, "rate", -1.0)
    assert (result.successful, result.reason) == (False, "must be positive")
    assert node.get_parameter("rate").value == 20.0


def test_use_sim_time_is_a_bool_and_nothing_else():
    node = create_node("n")
    assert not set_one(node, "use_sim_time", 1).successful
    assert set_one(node, "use_sim_time", True).successful
    assert node.get_clock().ros_time_is_active
    assert node.get_clock().now().nanoseconds == 0  # nobody publishes /clock


def test_parameters_come_from_the_command_line_and_a_file_by_node_name_and_wildcard(tmp_path):
    file = tmp_path / "params.yaml"
    file.write_text(
        "/**:\n  ros__parameters:\n    use_sim_time: true\nn:\n  ros__parameters:\n    pid:\n      p: 2.5\n"
    )
    shutdown()
    given = ["-p", "rate:=5.0", "-p", "n:name:=left", "-p", "other:name:=right"]
    init(args=["--ros-args", "--params-file", str(file), *given])
    node = create_node("n")
    assert node.get_parameter("use_sim_time").value is True
    assert node.declare_parameter("pid.p", 0.0).value == 2.5
    assert node.declare_parameter("rate", 20.0).value == 5.0
    assert node.declare_parameter("name", "none").value == "left"


@pytest.mark.parametrize(
    ("pattern", "concerned"),
    [
        ("/**", {"/n", "/a/n", "/a/b/n"}),
        ("/*", {"/n"}),
        ("/a/*", {"/a/n"}),
        ("/a/**", {"/a/n", "/a/b/n"}),
        ("/**/n", {"/n", "/a/n", "/a/b/n"}),
        ("/a/n", {"/a/n"}),
    ],
)
def test_a_star_in_a_parameter_file_is_one_name_and_two_are_any_number(pattern, concerned):
    assert {name for name in ("/n", "/a/n", "/a/b/n") if _concerns(pattern, name)} == concerned


def test_below_a_prefix_parameters_are_listed_by_the_rest_of_their_names():
    node = create_node("n")
    node.declare_parameters("pid", [("p", 1.0), ("i", 0.1)])
    assert {name: p.value for name, p in node.get_parameters_by_prefix("pid").items()} == {"p": 1.0, "i": 0.1}
    assert node.list_parameters(["pid"], 0).names == ["pid.p", "pid.i"]


#   /lab/asking  --parameter services-->  /lab/robot: speed = 1.5, ids = [1, 2, 3]


@pytest.fixture
def nodes():
    asking = Node("asking", namespace="/lab")
    robot = Node("robot", namespace="/lab", allow_undeclared_parameters=True)
    robot.declare_parameter("speed", 1.5)
    robot.declare_parameter("ids", [1, 2, 3])
    return asking, robot


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
    got, changed = [], []
    client = AsyncParameterClient(nodes[0], "robot")
    assert client.services_are_ready()
    future = client.get_parameters(["speed", "ids"], callback=got.append)
    values = answer(nodes, future).values
    assert (values[0].double_value, list(values[1].integer_array_value)) == (1.5, [1, 2, 3])
    assert got == [future]
    assert "speed" in answer(nodes, client.list_parameters()).result.names
    assert list(answer(nodes, client.get_parameter_types(["ids"])).types) == [ParameterType.PARAMETER_INTEGER_ARRAY]
    assert answer(nodes, client.describe_parameters(["ids"])).descriptors[0].name == "ids"
    client.on_parameter_event(changed.append)
    nodes[1].set_parameters([Parameter("speed", value=9.0)])
    spin_some(nodes)
    assert [(event.node, event.changed_parameters[0].name) for event in changed] == [("/lab/robot", "speed")]


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


def test_waiting_for_missing_services_ends_after_the_timeout(nodes, graph):
    before_ns = graph.now_ns
    assert AsyncParameterClient(nodes[0], "nobody").wait_for_services(timeout_sec=1.0) is False
    assert graph.now_ns - before_ns == 1_000_000_000


def test_callbacks_for_one_parameter_run_in_reverse_order_of_registration(nodes):
    heard = []
    handler = ParameterEventHandler(nodes[0])
    handler.add_parameter_callback("speed", "robot", lambda parameter: heard.append(("first", parameter)))
    handler.add_parameter_callback("speed", "/lab/robot", lambda parameter: heard.append(("second", parameter)))
    handler.add_parameter_callback("mode", "", lambda parameter: heard.append(("own", parameter)))
    nodes[1].set_parameters([Parameter("speed", value=9.0), Parameter("ids", value=[4])])
    nodes[0].declare_parameter("speed", 0.0)
    nodes[0].declare_parameter("mode", 0.5)
    spin_some(nodes)
    assert [(who, parameter.name, parameter.value.double_value) for who, parameter in heard] == [
        ("second", "speed", 9.0), ("first", "speed", 9.0), ("own", "mode", 0.5),
    ]  # fmt: skip


def test_an_event_callback_receives_events_of_every_node_until_removed(nodes):
    heard = []
    handler = ParameterEventHandler(nodes[0])
    handle = handler.add_parameter_event_callback(lambda event: heard.append(event.node))
    nodes[1].set_parameters([Parameter("speed", value=9.0)])
    nodes[0].declare_parameter("mode", "idle")
    spin_some(nodes)
    handler.remove_parameter_event_callback(handle)
    with pytest.raises(RuntimeError, match="Callback doesn't exist"):
        handler.remove_parameter_event_callback(handle)
    destroyed = ParameterEventHandler(nodes[0])
    destroyed.add_parameter_event_callback(heard.append)
    destroyed.destroy()
    nodes[1].set_parameters([Parameter("speed", value=8.0)])
    spin_some(nodes)
    assert heard == ["/lab/robot", "/lab/asking"]


def test_a_callback_may_remove_itself(nodes):
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


def test_an_event_can_be_taken_apart():
    new, changed = Parameter("a", value=1).to_parameter_msg(), Parameter("b", value=2).to_parameter_msg()
    event = ParameterEvent(node="/n", new_parameters=[new], changed_parameters=[changed])
    assert list(ParameterEventHandler.get_parameters_from_event(event)) == [new, changed]
    assert ParameterEventHandler.get_parameter_from_event(event, "b", "/n") == changed
    assert ParameterEventHandler.get_parameter_from_event(event, "b", "/m") is None
    assert ParameterEventHandler.get_parameter_from_event(event, "c", "/n") is None
