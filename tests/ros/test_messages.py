"""Messages behave as the Python classes that rosidl generates: fields, checks, texts, copies."""

import copy
import math
import pickle
from array import array

import numpy as np
import pytest
from rosbags.typesys import Stores, get_typestore

from tflab.ros.activation import PACKAGES
from tflab.ros.messages import (
    builtin_interfaces,
    copy_message,
    field_checks,
    geometry_msgs,
    rcl_interfaces,
    sensor_msgs,
    set_field_checks,
    std_msgs,
    tf2_msgs,
    type_named,
)
from tflab.ros.messages.base import Message, filled
from tflab.ros.messages.definition import Array, BasicType, NamespacedType, UnboundedSequence, parse_definition
from tflab.ros.messages.geometry_msgs import (
    Point,
    Polygon,
    Pose,
    PoseStamped,
    PoseWithCovariance,
    Quaternion,
    TransformStamped,
    Vector3,
)
from tflab.ros.messages.packages import ros_package
from tflab.ros.messages.sensor_msgs import Image, JointState, LaserScan, PointCloud2, PointField
from tflab.ros.messages.std_msgs import Header
from tflab.ros.messages.tf2_msgs import TFMessage
from tflab.ros.messages.values import message_from_object, object_from_message

ALL_MESSAGES = [cls for package in PACKAGES for cls in ros_package(package).values() if issubclass(cls, Message)]


@pytest.fixture(autouse=True)
def unchecked():
    set_field_checks(False)
    yield
    set_field_checks(None)


@pytest.fixture
def checked(unchecked):
    set_field_checks(True)


# What a message is ----------------------------------------------------------------


KNOWN_TO_ROSBAGS = [cls for cls in ALL_MESSAGES if not cls.ROS_TYPE.startswith(("example_interfaces/", "turtlesim/"))]


def test_every_definition_is_that_of_ros():
    idl_names = {"bool": "boolean", "byte": "octet", "char": "uint8", "float32": "float", "float64": "double"}

    def text(node):
        kind, argument = node
        if kind.name == "BASE":
            bound = f"<{argument[1]}>" if argument[1] else ""
            return idl_names.get(argument[0], argument[0]) + bound
        if kind.name == "NAME":
            return argument.replace("/msg/", "/")
        of, size = text(argument[0]), argument[1]
        if kind.name == "ARRAY":
            return f"{of}[{size}]"
        return f"sequence<{of}, {size}>" if size else f"sequence<{of}>"

    definitions = get_typestore(Stores.ROS2_JAZZY).fielddefs
    for cls in KNOWN_TO_ROSBAGS:
        constants, fields = definitions[cls.ROS_TYPE]
        expected = {name: text(node) for name, node in fields if name != "structure_needs_at_least_one_member"}
        assert list(cls.get_fields_and_field_types().items()) == list(expected.items())
        values = {name: bytes([value]) if kind == "byte" else value for name, kind, value in constants}
        assert {name: getattr(cls, name) for name in values} == values


def test_defaults_are_zero_and_empty_but_a_quaternion_is_the_identity():
    assert (Vector3().x, Header().frame_id, builtin_interfaces.Time().sec) == (0.0, "", 0)
    q = Pose().orientation
    assert (q.x, q.y, q.z, q.w) == (0.0, 0.0, 0.0, 1.0)
    assert TransformStamped().transform.rotation.w == 1.0


def test_two_messages_do_not_share_their_defaults_but_an_assigned_sub_message():
    a, b = TransformStamped(), TransformStamped()
    a.transform.translation.x = 1.0
    a.header.frame_id = "map"
    assert (b.transform.translation.x, b.header.frame_id) == (0.0, "")
    c, d = TFMessage(), TFMessage()
    c.transforms.append(a)
    assert d.transforms == []
    b.header = a.header
    b.header.frame_id = "odom"
    assert a.header.frame_id == "odom"


def test_a_misspelt_field_and_positions_are_refused():
    transform = TransformStamped()
    with pytest.raises(AttributeError):
        transform.child_frame = "base_link"
    with pytest.raises(AttributeError):
        transform.transform.translation.X = 1.0
    with pytest.raises(TypeError):
        Vector3(1.0, 2.0, 3.0)


def test_repr_is_that_of_ros():
    assert repr(Vector3(x=1.0)) == "geometry_msgs.msg.Vector3(x=1.0, y=0.0, z=0.0)"
    assert repr(Header(frame_id="map")) == (
        "std_msgs.msg.Header(stamp=builtin_interfaces.msg.Time(sec=0, nanosec=0), frame_id='map')"
    )
    assert "ranges=[0.5, 2.0], intensities=[])" in repr(LaserScan(ranges=[0.5, 2.0]))
    assert "k=array([0., 0., 0., 0., 0., 0., 0., 0., 0.])" in repr(sensor_msgs.CameraInfo())
    assert repr(tf2_msgs.FrameGraph.Response(frame_yaml="map: 'x'")) == (  # the line that view_frames logs
        """tf2_msgs.srv.FrameGraph_Response(frame_yaml="map: 'x'")"""
    )


@pytest.mark.parametrize(
    ("cls", "module"),
    [
        (TransformStamped, "geometry_msgs.msg._transform_stamped"),
        (tf2_msgs.TF2Error, "tf2_msgs.msg._tf2_error"),
        (PointCloud2, "sensor_msgs.msg._point_cloud2"),
        (std_msgs.UInt8, "std_msgs.msg._u_int8"),
        (tf2_msgs.FrameGraph.Request, "tf2_msgs.srv._frame_graph"),
        (tf2_msgs.LookupTransform.Goal, "tf2_msgs.action._lookup_transform"),
    ],
)
def test_the_module_of_a_class_is_that_of_rosidl(cls, module):
    assert cls.__module__ == module


def test_slots_and_types_can_be_listed():
    assert Vector3.__slots__ == ["_x", "_y", "_z", "_check_fields"]
    assert TransformStamped.get_fields_and_field_types() == {
        "header": "std_msgs/Header",
        "child_frame_id": "string",
        "transform": "geometry_msgs/Transform",
    }
    assert TFMessage.get_fields_and_field_types() == {"transforms": "sequence<geometry_msgs/TransformStamped>"}
    assert PoseWithCovariance.get_fields_and_field_types()["covariance"] == "double[36]"
    ranges = rcl_interfaces.ParameterDescriptor.get_fields_and_field_types()
    assert ranges["integer_range"] == "sequence<rcl_interfaces/IntegerRange, 1>"
    assert list(PoseWithCovariance.SLOT_TYPES) == [
        NamespacedType(("geometry_msgs", "msg"), "Pose"),
        Array(BasicType("double"), 36),
    ]
    assert LaserScan.SLOT_TYPES[-1] == UnboundedSequence(BasicType("float"))


def test_constants_are_there_on_class_and_message_and_cannot_be_set():
    assert (PointField.FLOAT32, PointField().FLOAT64, tf2_msgs.TF2Error.TRANSFORM_ERROR) == (7, 8, 6)
    with pytest.raises(AttributeError):
        PointField().FLOAT32 = 1


def test_equal_means_same_class_and_equal_fields():
    assert Vector3(x=1.0) == Vector3(x=1.0)
    assert Vector3(x=1.0) != Vector3(x=2.0)
    assert Vector3() != Point()
    assert Vector3() != (0.0, 0.0, 0.0)
    with pytest.raises(TypeError):
        hash(Vector3())
    a, b = PoseWithCovariance(), PoseWithCovariance()
    assert a == b
    b.covariance[7] = 0.1
    assert a != b


def test_an_invalid_line_of_a_definition_is_refused_with_the_line():
    with pytest.raises(ValueError, match='cannot read "float64 x y z"'):
        parse_definition("float64 x y z", "geometry_msgs")


def test_services_and_actions_are_pairs_and_triples_of_messages_and_no_messages():
    assert list(tf2_msgs.FrameGraph.Response.get_fields_and_field_types()) == ["frame_yaml"]
    assert list(tf2_msgs.FrameGraph.Request.get_fields_and_field_types()) == []
    goal = tf2_msgs.LookupTransform.Goal()
    assert (goal.advanced, goal.target_time) == (False, builtin_interfaces.Time())
    assert tf2_msgs.LookupTransform.Result().error.error == 0
    with pytest.raises(NotImplementedError, match="Service classes can not be instantiated"):
        tf2_msgs.FrameGraph()
    with pytest.raises(NotImplementedError, match="Action classes can not be instantiated"):
        tf2_msgs.LookupTransform()


def test_a_class_is_found_by_its_ros_name_and_only_by_a_known_one():
    assert type_named("geometry_msgs/msg/TransformStamped") is TransformStamped
    assert type_named("tf2_msgs/srv/FrameGraph") is tf2_msgs.FrameGraph
    for unknown in ("geometry_msgs/msg/Nonsense", "nonsense_msgs/msg/Point", "Point", "../x", ""):
        with pytest.raises(KeyError):
            type_named(unknown)


# Field checks ---------------------------------------------------------------------


def test_unchecked_a_wrong_type_is_stored_and_unknown_keywords_are_ignored():
    vector = Vector3(x=1, foo=2)
    vector.y = "north"
    assert (vector.x, vector.y) == (1, "north")


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (lambda: Vector3(x=1), "The 'x' field must be of type 'float'"),
        (lambda: Vector3(x="1"), "The 'x' field must be of type 'float'"),
        (lambda: builtin_interfaces.Time(sec=1.0), "The 'sec' field must be of type 'int'"),
        (lambda: builtin_interfaces.Time(sec=2**31), "The 'sec' field must be an integer in [-2147483648, 2147483647]"),
        (
            lambda: builtin_interfaces.Time(nanosec=-1),
            "The 'nanosec' field must be an unsigned integer in [0, 4294967295]",
        ),
        (lambda: Header(stamp=1.5), "The 'stamp' field must be a sub message of type 'Time'"),
        (lambda: Header(frame_id=None), "The 'frame_id' field must be of type 'str'"),
        (lambda: std_msgs.Bool(data=1), "The 'data' field must be of type 'bool'"),
        (lambda: std_msgs.Byte(data=1), "The 'data' field must be of type 'bytes' or 'ByteString' with length 1"),
        (
            lambda: std_msgs.Float32(data=1e39),
            "The 'data' field must be a float in [-3.402823466e+38, 3.402823466e+38]",
        ),
        (
            lambda: TFMessage(transforms=TransformStamped()),
            "The 'transforms' field must be a set or sequence and each value of type 'TransformStamped'",
        ),
        (
            lambda: TFMessage(transforms=[Pose()]),
            "The 'transforms' field must be a set or sequence and each value of type 'TransformStamped'",
        ),
        (lambda: JointState(name="arm"), "The 'name' field must be a set or sequence and each value of type 'str'"),
        (
            lambda: Image(data=[256]),
            "The 'data' field must be a set or sequence and each value of type 'int' "
            "and each unsigned integer in [0, 255]",
        ),
        (
            lambda: LaserScan(ranges=[1]),
            "The 'ranges' field must be a set or sequence and each value of type 'float' and each float in "
            "[-340282346600000016151267322115014000640.000000, 340282346600000016151267322115014000640.000000]",
        ),
        (lambda: LaserScan(ranges=array("d", [1.0])), "The 'ranges' array.array() must have the type code of 'f'"),
        (lambda: PoseWithCovariance(covariance=np.zeros(9)), "The 'covariance' numpy.ndarray() must have a size of 36"),
        (
            lambda: PoseWithCovariance(covariance=np.zeros(36, dtype=np.float32)),
            "The 'covariance' numpy.ndarray() must have the dtype of 'numpy.float64'",
        ),
        (
            lambda: rcl_interfaces.ParameterDescriptor(integer_range=[rcl_interfaces.IntegerRange()] * 2),
            "The 'integer_range' field must be a set or sequence with length <= 1 and each value of type "
            "'IntegerRange'",
        ),
        (lambda: Vector3(foo=1.0, X=2.0), "Invalid arguments passed to constructor: X, foo"),
    ],
)
def test_checked_a_wrong_value_is_refused_with_rosidls_text(checked, make, text):
    with pytest.raises(AssertionError) as refusal:
        make()
    assert str(refusal.value) == text


def test_checked_infinity_and_nan_and_bools_for_ints_pass_and_a_refused_value_changes_nothing(checked):
    vector = Vector3(x=math.inf)
    with pytest.raises(AssertionError):
        vector.x = "far"
    assert vector.x == math.inf
    assert math.isnan(std_msgs.Float32(data=math.nan).data)
    assert builtin_interfaces.Time(sec=True).sec is True
    with pytest.raises(AssertionError) as refusal:
        PoseWithCovariance(covariance=[0.0] * 9)
    text = str(refusal.value)
    assert text.startswith(
        "The 'covariance' field must be a set or sequence with length 36 and each value of type 'float' "
        "and each double in [-17976931348623157081452742373"
    )
    assert text.endswith(".000000]")


def test_a_keyword_turns_the_checks_on_or_off_for_one_message():
    with pytest.raises(AssertionError):
        Vector3(x=1, check_fields=True)
    set_field_checks(True)
    assert Vector3(x=1, check_fields=False).x == 1


@pytest.mark.parametrize(
    ("release", "variable", "on"), [("jazzy", "1", True), ("jazzy", "", False), ("humble", "", True)]
)
def test_the_environment_turns_the_checks_on_and_humble_has_them_always(monkeypatch, release, variable, on):
    monkeypatch.setenv("TFLAB_ROS_DISTRO", release)
    monkeypatch.setenv("ROS_PYTHON_CHECK_FIELDS", variable)
    set_field_checks(None)
    assert field_checks() is on


# Arrays ---------------------------------------------------------------------------


def test_fixed_numeric_arrays_are_numpy_and_numeric_sequences_are_packed():
    pose = PoseWithCovariance(covariance=[0.5] * 36)
    assert isinstance(pose.covariance, np.ndarray) and pose.covariance.dtype == np.float64
    assert PoseWithCovariance().covariance.tolist() == [0.0] * 36
    scan = LaserScan(ranges=(1.0, 2.0))
    assert scan.ranges == array("f", [1.0, 2.0])
    assert Image(data=b"\x01\x02").data == array("B", [1, 2])
    assert LaserScan(ranges=np.array([1.0, 2.0], dtype=np.float32)).ranges == array("f", [1.0, 2.0])


def test_sequences_of_strings_and_messages_are_kept_by_reference():
    names, transforms = ["arm"], [TransformStamped()]
    assert JointState(name=names).name is names
    assert TFMessage(transforms=transforms).transforms is transforms


def test_a_packed_array_is_kept_when_checked_and_copied_when_not():
    values = array("d", [1.0])
    assert JointState(position=values, check_fields=True).position is values
    assert JointState(position=values).position is not values


# Copies ---------------------------------------------------------------------------


def full_message():
    message = TFMessage(transforms=[TransformStamped(child_frame_id="base_link")])
    message.transforms[0].header.frame_id = "odom"
    message.transforms[0].header.stamp.nanosec = 5
    message.transforms[0].transform.translation.x = 0.25
    return message


@pytest.mark.parametrize("duplicate", [copy_message, copy.deepcopy, lambda m: pickle.loads(pickle.dumps(m))])
def test_a_copy_is_equal_and_shares_nothing(duplicate):
    original = full_message()
    copied = duplicate(original)
    assert copied == original
    original.transforms[0].header.frame_id = "map"
    original.transforms[0].transform.translation.x = 9.0
    assert (copied.transforms[0].header.frame_id, copied.transforms[0].transform.translation.x) == ("odom", 0.25)
    pose, scan = PoseWithCovariance(), LaserScan(ranges=[1.0])
    copied_pose, copied_scan = duplicate(pose), duplicate(scan)
    pose.covariance[0] = 1.0
    scan.ranges[0] = 9.0
    assert (copied_pose.covariance[0], copied_scan.ranges[0]) == (0.0, 1.0)


def test_filled_makes_the_message_that_keywords_make_and_checks_later_assignments(checked):
    filled_one = filled(Vector3, 1.0, 2.0, 3.0)
    assert filled_one == Vector3(x=1.0, y=2.0, z=3.0)
    with pytest.raises(AssertionError, match="The 'x' field must be of type 'float'"):
        filled_one.x = 1
    with pytest.raises(ValueError, match="shorter"):
        filled(Vector3, 1.0, 2.0)


def test_float32_fields_arrive_rounded_and_numpys_floats_as_plain_floats():
    assert copy_message(geometry_msgs.Point32(x=0.1)).x == 0.10000000149011612
    assert copy_message(Polygon(points=[geometry_msgs.Point32(x=0.1)])).points[0].x == 0.10000000149011612
    assert copy_message(Vector3(x=0.1)).x == 0.1
    assert type(copy_message(Vector3(x=np.float64(0.5), check_fields=True)).x) is float
    transform = TransformStamped()
    copied = copy.deepcopy([transform.header, transform])
    assert copied[0] is copied[1].header  # what was shared inside stays shared


@pytest.mark.parametrize(
    ("message", "text"),
    [
        (Vector3(x=1, check_fields=False), "The 'x' field must be of type 'float'"),
        (
            TransformStamped(header="map", check_fields=False),
            "The 'header' field must be a sub message of type 'Header'",
        ),
        (
            TFMessage(transforms=[None], check_fields=False),
            "The 'transforms' field must be a set or sequence and each value of type 'TransformStamped'",
        ),
        (PoseStamped(pose=Pose(position=None, check_fields=False), check_fields=False), "'position' field"),
    ],
    ids=["number", "sub message", "sequence", "deep inside"],
)
def test_a_message_with_an_invalid_field_cannot_be_sent(message, text):
    with pytest.raises(AssertionError, match=text):
        copy_message(message)


# To a bag library's objects and back ----------------------------------------------


def test_a_message_survives_serialization_by_rosbags():
    store = get_typestore(Stores.ROS2_JAZZY)
    for message in (
        full_message(),
        PoseWithCovariance(covariance=[float(i) for i in range(36)]),
        PointCloud2(fields=[PointField(name="x", datatype=7, count=1)], data=b"\x00\x01\xff", width=3),
        JointState(name=["a", "b"], position=[1.0, 2.0]),
        rcl_interfaces.ParameterValue(byte_array_value=[b"\x01"], bool_array_value=[True, False]),
        std_msgs.Empty(),
    ):
        data = store.serialize_cdr(object_from_message(message, store.types), message.ROS_TYPE)
        assert message_from_object(message.ROS_TYPE, store.deserialize_cdr(data, message.ROS_TYPE)) == message
    assert message_from_object("geometry_msgs/msg/Quaternion", Quaternion(w=0.0)).w == 0.0  # not the default
    with pytest.raises(AttributeError, match="frame_id"):
        message_from_object("std_msgs/msg/Header", type("Half", (), {"stamp": builtin_interfaces.Time()})())
