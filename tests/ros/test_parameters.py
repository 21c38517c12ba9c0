"""Parameters of a node: declared once, typed, set through checks."""

import pytest

from tflab.ros.client_library import create_node, init, shutdown
from tflab.ros.exceptions import (
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterNotDeclaredException,
)
from tflab.ros.graph import new_graph
from tflab.ros.messages.rcl_interfaces import (
    FloatingPointRange,
    IntegerRange,
    ParameterDescriptor,
    ParameterType,
    SetParametersResult,
)
from tflab.ros.parameter import Parameter

TYPE = Parameter.Type


@pytest.fixture(autouse=True)
def graph():
    new_graph()
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


def test_the_types_have_the_numbers_of_the_message():
    assert [t.value for t in TYPE] == list(range(10))
    assert TYPE.STRING_ARRAY.value == ParameterType.PARAMETER_STRING_ARRAY


# Declaring and reading ------------------------------------------------------------


def test_a_declared_parameter_has_its_default_and_use_sim_time_is_always_there():
    node = create_node("n")
    assert node.declare_parameter("rate", 20.0).value == 20.0
    assert node.get_parameter("rate").value == 20.0
    assert node.get_parameter("use_sim_time").value is False


def test_a_parameter_is_declared_once():
    node = create_node("n")
    node.declare_parameter("rate", 20.0)
    with pytest.raises(ParameterAlreadyDeclaredException, match=r"Parameter\(s\) already declared: \['rate'\]"):
        node.declare_parameter("rate", 1.0)


def test_an_undeclared_parameter_can_be_neither_read_nor_set():
    node = create_node("n")
    with pytest.raises(ParameterNotDeclaredException) as reading:
        node.get_parameter("x")
    assert str(reading.value) == "Invalid access to undeclared parameter(s): x"
    with pytest.raises(ParameterNotDeclaredException) as setting:
        set_one(node, "x", 1)
    assert str(setting.value) == "Invalid access to undeclared parameter(s): ['x']"


def test_a_node_may_allow_undeclared_parameters():
    node = create_node("n", allow_undeclared_parameters=True)
    assert node.get_parameter("x").type_ is TYPE.NOT_SET
    assert set_one(node, "x", 1).successful
    assert node.get_parameter("x").value == 1


def test_an_override_wins_over_the_default_unless_it_is_ignored():
    overrides = [Parameter("rate", value=5.0), Parameter("name", value="real")]
    node = create_node("n", parameter_overrides=overrides)
    assert node.declare_parameter("rate", 20.0).value == 5.0
    assert node.declare_parameter("name", "default", ignore_override=True).value == "default"


def test_an_override_of_a_wrong_type_is_refused():
    node = create_node("n", parameter_overrides=[Parameter("rate", value=5)])
    with pytest.raises(InvalidParameterTypeException):
        node.declare_parameter("rate", 20.0)


# Setting --------------------------------------------------------------------------


def test_a_value_of_the_same_type_is_taken():
    node = create_node("n")
    node.declare_parameter("rate", 20.0)
    result = set_one(node, "rate", 50.0)
    assert (result.successful, result.reason) == (True, "")
    assert node.get_parameter("rate").value == 50.0


def test_a_value_of_another_type_is_refused_and_changes_nothing():
    node = create_node("n")
    node.declare_parameter("rate", 20.0)
    result = set_one(node, "rate", 50)
    assert not result.successful
    assert result.reason == "Wrong parameter type, expected 'Type.DOUBLE' got 'Type.INTEGER'"
    assert node.get_parameter("rate").value == 20.0


def test_with_dynamic_typing_any_type_is_taken():
    node = create_node("n")
    node.declare_parameter("anything", 20.0, ParameterDescriptor(dynamic_typing=True))
    assert set_one(node, "anything", "text").successful
    assert node.get_parameter("anything").value == "text"


def test_a_read_only_parameter_is_declared_once_and_for_all():
    node = create_node("n")
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


def test_a_callback_may_refuse_and_says_why():
    node = create_node("n")
    node.declare_parameter("rate", 20.0)
    node.add_on_set_parameters_callback(
        lambda parameters: SetParametersResult(successful=parameters[0].value > 0.0, reason="must be positive")
    )
    result = set_one(node, "rate", -1.0)
    assert (result.successful, result.reason) == (False, "must be positive")
    assert node.get_parameter("rate").value == 20.0


def test_several_are_set_together_or_not_at_all():
    node = create_node("n")
    node.declare_parameter("a", 1)
    node.declare_parameter("b", 2)
    result = node.set_parameters_atomically([Parameter("a", value=10), Parameter("b", value="two")])
    assert not result.successful
    assert [p.value for p in node.get_parameters(["a", "b"])] == [1, 2]


def test_use_sim_time_is_a_bool_and_nothing_else():
    node = create_node("n")
    assert not set_one(node, "use_sim_time", 1).successful
    assert set_one(node, "use_sim_time", True).successful
    assert node.get_clock().ros_time_is_active
    assert node.get_clock().now().nanoseconds == 0  # nobody publishes /clock


def test_parameters_come_from_the_command_line_too():
    shutdown()
    init(args=["--ros-args", "-p", "rate:=5.0", "-p", "n:name:=left", "-p", "other:name:=right"])
    node = create_node("n")
    assert node.declare_parameter("rate", 20.0).value == 5.0
    assert node.declare_parameter("name", "none").value == "left"


def test_parameters_come_from_a_file_by_node_name_and_wildcard(tmp_path):
    file = tmp_path / "params.yaml"
    file.write_text(
        "/**:\n  ros__parameters:\n    use_sim_time: true\nn:\n  ros__parameters:\n    pid:\n      p: 2.5\n"
    )
    shutdown()
    init(args=["--ros-args", "--params-file", str(file)])
    node = create_node("n")
    assert node.get_parameter("use_sim_time").value is True
    assert node.declare_parameter("pid.p", 0.0).value == 2.5


def test_below_a_prefix_parameters_are_listed_by_the_rest_of_their_names():
    node = create_node("n")
    node.declare_parameters("pid", [("p", 1.0), ("i", 0.1)])
    assert {name: p.value for name, p in node.get_parameters_by_prefix("pid").items()} == {"p": 1.0, "i": 0.1}
    assert node.list_parameters(["pid"], 0).names == ["pid.p", "pid.i"]
