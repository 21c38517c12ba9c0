"""QoS profiles: required policies, compatibility, presets, and events of incompatible QoS."""

from dataclasses import astuple

import pytest

from tflab.ros import client_library as rclpy
from tflab.ros.messages.rcl_interfaces import SetParametersResult
from tflab.ros.messages.std_msgs import String
from tflab.ros.node import Node
from tflab.ros.parameter import Parameter
from tflab.ros.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    InvalidQoSProfileException,
    QoSLivelinessPolicy,
    QoSPresetProfiles,
    QoSProfile,
    ReliabilityPolicy,
    profile_from,
    qos_profile_sensor_data,
)
from tflab.ros.qos_compatibility import (
    PublisherEventCallbacks,
    QoSCompatibility,
    QoSPolicyKind,
    SubscriptionEventCallbacks,
    UnsupportedEventTypeError,
    incompatible_policy,
    qos_check_compatible,
    qos_policy_name_from_kind,
)
from tflab.ros.qos_overriding_options import InvalidQosOverridesError, QoSOverridingOptions
from tflab.ros.time import Duration

RELIABLE, BEST_EFFORT = ReliabilityPolicy.RELIABLE, ReliabilityPolicy.BEST_EFFORT
TRANSIENT_LOCAL, VOLATILE = DurabilityPolicy.TRANSIENT_LOCAL, DurabilityPolicy.VOLATILE
AUTOMATIC, MANUAL_BY_TOPIC = QoSLivelinessPolicy.AUTOMATIC, QoSLivelinessPolicy.MANUAL_BY_TOPIC


def profile(**policies):
    return QoSProfile(depth=10, **policies)


# One profile ----------------------------------------------------------------------


def test_a_depth_alone_means_keep_last_reliable_and_volatile():
    qos = QoSProfile(depth=5)
    assert (qos.history, qos.depth) == (HistoryPolicy.KEEP_LAST, 5)
    assert (qos.reliability, qos.durability) == (RELIABLE, VOLATILE)
    assert "depth=5" in str(qos)
    assert profile() == profile()
    assert profile() != profile(durability=TRANSIENT_LOCAL)
    assert profile() != 10


def test_neither_depth_nor_history_is_not_enough():
    with pytest.raises(InvalidQoSProfileException):
        QoSProfile()
    with pytest.raises(InvalidQoSProfileException):
        QoSProfile(history=HistoryPolicy.KEEP_LAST)
    assert QoSProfile(history=HistoryPolicy.KEEP_ALL).history == HistoryPolicy.KEEP_ALL


@pytest.mark.parametrize(
    ("policy", "wrong"),
    [("depth", "ten"), ("reliability", "RELIABLE"), ("durability", None), ("deadline", 1.0), ("lifespan", 1)],
)
def test_policies_of_a_wrong_type_are_refused(policy, wrong):
    with pytest.raises(AssertionError):
        setattr(profile(), policy, wrong)


def test_a_number_given_as_a_profile_is_a_depth():
    assert profile_from(7) == QoSProfile(depth=7)
    given = profile()
    assert profile_from(given) is given
    with pytest.raises(ValueError):
        profile_from(-1)
    with pytest.raises(TypeError):
        profile_from("10")


LAST = HistoryPolicy.KEEP_LAST
PRESETS = {
    "DEFAULT": (LAST, RELIABLE, VOLATILE, 10),
    "SENSOR_DATA": (LAST, BEST_EFFORT, VOLATILE, 5),
    "SERVICES_DEFAULT": (LAST, RELIABLE, VOLATILE, 10),
    "PARAMETERS": (LAST, RELIABLE, VOLATILE, 1000),
    "PARAMETER_EVENTS": (LAST, RELIABLE, VOLATILE, 1000),
    "ACTION_STATUS_DEFAULT": (LAST, RELIABLE, TRANSIENT_LOCAL, 1),
}


def test_the_presets_are_those_of_ros():
    assert {name: summary(QoSPresetProfiles[name].value) for name in PRESETS} == PRESETS
    assert QoSPresetProfiles.get_from_short_key("sensor_data") == qos_profile_sensor_data


@pytest.mark.parametrize(
    "policy", [RELIABLE, BEST_EFFORT, TRANSIENT_LOCAL, HistoryPolicy.KEEP_LAST, AUTOMATIC], ids=lambda each: each.name
)
def test_a_policy_has_its_old_name_which_is_deprecated(policy):
    name = type(policy).__name__
    old = f"RMW_QOS_POLICY_{name.upper()[:-6]}_{policy.name}"
    with pytest.warns(UserWarning, match=f"{name}.{old} is deprecated. Use {name}.{policy.name} instead."):
        assert getattr(type(policy), old) is policy


def summary(qos):
    return (qos.history, qos.reliability, qos.durability, qos.depth)


# Two profiles ---------------------------------------------------------------------


@pytest.mark.parametrize(
    ("policy", "strong", "weak", "reason"),
    [
        ("reliability", RELIABLE, BEST_EFFORT, "Best effort publisher and reliable subscription"),
        ("durability", TRANSIENT_LOCAL, VOLATILE, "Volatile publisher and transient local subscription"),
        ("liveliness", MANUAL_BY_TOPIC, AUTOMATIC, None),
        ("deadline", Duration(seconds=1), Duration(seconds=2), None),
    ],
)
def test_an_offer_fits_if_it_is_no_less_than_the_request(policy, strong, weak, reason):
    more, less = (profile(**{"liveliness": AUTOMATIC, policy: value}) for value in (strong, weak))
    for offered, requested in ((more, more), (more, less), (less, less)):
        assert incompatible_policy(offered, requested) is None
        assert qos_check_compatible(offered, requested) == (QoSCompatibility.OK, "")
    assert incompatible_policy(less, more) == policy.upper()
    result, text = qos_check_compatible(less, more)
    assert result == QoSCompatibility.ERROR
    assert reason is None or text == f"ERROR: {reason};"
    keep_all = QoSProfile(history=HistoryPolicy.KEEP_ALL)  # history and depth do not matter
    assert incompatible_policy(QoSProfile(depth=1), keep_all) is incompatible_policy(keep_all, profile()) is None


@pytest.mark.parametrize(
    ("policy", "offered", "requested", "reason"),
    [
        ("reliability", 0, 0, "Publisher reliability is system_default and subscription reliability is system_default"),
        ("reliability", 0, RELIABLE, "Reliable subscription, but publisher is system_default"),
        ("reliability", BEST_EFFORT, 3, "Best effort publisher, but subscription is unknown"),
        ("durability", 0, 3, "Publisher durabilty is system_default and subscription durability is unknown"),
        ("durability", 0, TRANSIENT_LOCAL, "Transient local subscription, but publisher is system_default"),
        ("durability", VOLATILE, 0, "Volatile publisher, but subscription is system_default"),
        ("liveliness", 0, 0, "Publisher liveliness is system_default and subscription liveliness is system_default"),
        (
            "liveliness",
            0,
            MANUAL_BY_TOPIC,
            "Subscription's liveliness is manual by topic, but publisher's is system_default",
        ),
        ("liveliness", AUTOMATIC, 0, "Publisher's liveliness is automatic, but subscription's is system_default"),
        ("reliability", 0, BEST_EFFORT, None),  # every value is compatible
        ("durability", 0, VOLATILE, None),
    ],
)
def test_an_undetermined_policy_gives_a_warning(policy, offered, requested, reason):
    sides = [profile(**{"liveliness": AUTOMATIC, policy: value}) for value in (offered, requested)]
    expected = (QoSCompatibility.WARNING, f"WARNING: {reason};") if reason else (QoSCompatibility.OK, "")
    assert qos_check_compatible(*sides) == expected


STRICT = QoSProfile(depth=1, reliability=ReliabilityPolicy.RELIABLE)
LOOSE = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)

#   publisher, best effort --x--> subscription, reliable


@pytest.fixture
def node(graph):
    rclpy.init()
    yield Node("ends")
    rclpy.shutdown()


def test_event_callbacks_receive_the_incompatible_policy_and_nothing_is_logged(node, capsys):
    subscription, publisher = [], []
    node.create_subscription(
        String, "t", print, STRICT, event_callbacks=SubscriptionEventCallbacks(incompatible_qos=subscription.append)
    )
    for _ in range(2):
        node.create_publisher(
            String, "t", LOOSE, event_callbacks=PublisherEventCallbacks(incompatible_qos=publisher.append)
        )
    assert (subscription, publisher) == ([], [])
    for _ in range(4):
        rclpy.spin_once(node, timeout_sec=0)
    assert [astuple(each) for each in subscription] == [(n, 1, QoSPolicyKind.RELIABILITY) for n in (1, 2)]
    assert [astuple(each) for each in publisher] == [(1, 1, QoSPolicyKind.RELIABILITY)] * 2
    assert qos_policy_name_from_kind(subscription[0].last_policy_kind) == "RELIABILITY"
    assert "incompatible QoS" not in capsys.readouterr().err


def test_a_matched_callback_receives_how_many_ends_are_connected(node):
    publisher, subscription = [], []
    node.create_publisher(String, "t", STRICT, event_callbacks=PublisherEventCallbacks(matched=publisher.append))
    events = SubscriptionEventCallbacks(matched=subscription.append)
    last = [node.create_subscription(String, "t", print, 1, event_callbacks=events) for _ in range(2)][-1]
    node.destroy_subscription(last)
    for _ in range(6):
        rclpy.spin_once(node, timeout_sec=0)
    assert [astuple(each) for each in publisher] == [(1, 1, 1, 1), (2, 1, 2, 1), (2, 0, 1, -1)]
    assert [each.current_count for each in subscription] == [1, 1]


def test_a_parameter_overrides_a_policy_that_the_options_allow(graph):
    values = {"publisher.reliability": "best_effort", "publisher.depth": "3", "subscription_a.history": "x"}
    words = [word for name, value in values.items() for word in ("-p", f"qos_overrides./t.{name}:={value}")]
    rclpy.init(args=["x", "--ros-args", *words])
    node = Node("ends")
    options = QoSOverridingOptions.with_default_policies()
    qos = node.create_publisher(String, "t", QoSProfile(depth=1), qos_overriding_options=options).qos_profile
    assert (qos.reliability, qos.depth) == (ReliabilityPolicy.BEST_EFFORT, 3)
    assert not node.set_parameters([Parameter("qos_overrides./t.publisher.depth", value=4)])[0].successful
    with pytest.raises(RuntimeError, match="Unexpected QoS override for policy `history`: `x`"):
        options = QoSOverridingOptions([QoSPolicyKind.HISTORY], entity_id="a")
        node.create_subscription(String, "t", print, 1, qos_overriding_options=options)
    options = QoSOverridingOptions([], callback=lambda qos: SetParametersResult(reason="too deep"))
    with pytest.raises(InvalidQosOverridesError, match="for publisher `/u` with id `None`, are not valid: too deep"):
        node.create_publisher(String, "u", 10, qos_overriding_options=options)
    rclpy.shutdown()


def test_without_event_callbacks_a_warning_is_logged_unless_disabled(node, capsys):
    node.create_subscription(String, "t", print, STRICT, event_callbacks=SubscriptionEventCallbacks())
    silent = PublisherEventCallbacks(use_default_callbacks=False)
    node.create_publisher(String, "t", LOOSE, event_callbacks=silent)
    logged = capsys.readouterr().err
    assert "New publisher discovered on topic '/t', offering incompatible QoS." in logged
    assert "New subscription discovered" not in logged


@pytest.mark.parametrize(
    ("callbacks", "event"),
    [
        (PublisherEventCallbacks, "deadline"),
        (PublisherEventCallbacks, "incompatible_type"),
        (SubscriptionEventCallbacks, "message_lost"),
        (SubscriptionEventCallbacks, "liveliness"),
    ],
)
def test_an_unsupported_event_type_is_refused(callbacks, event):
    with pytest.raises(UnsupportedEventTypeError, match=f"nobody reports the event '{event}'"):
        callbacks(**{event: print})
