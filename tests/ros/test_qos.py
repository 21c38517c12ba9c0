"""QoS profiles: required policies, compatibility, presets, and events of incompatible QoS."""

import pytest

from tflab.ros import client_library as rclpy
from tflab.ros.messages.std_msgs import String
from tflab.ros.node import Node
from tflab.ros.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    InvalidQoSProfileException,
    QoSDurabilityPolicy,
    QoSHistoryPolicy,
    QoSLivelinessPolicy,
    QoSPresetProfiles,
    QoSProfile,
    QoSReliabilityPolicy,
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
from tflab.ros.time import Duration

RELIABLE, BEST_EFFORT = ReliabilityPolicy.RELIABLE, ReliabilityPolicy.BEST_EFFORT
TRANSIENT_LOCAL, VOLATILE = DurabilityPolicy.TRANSIENT_LOCAL, DurabilityPolicy.VOLATILE
AUTOMATIC, MANUAL_BY_TOPIC = QoSLivelinessPolicy.AUTOMATIC, QoSLivelinessPolicy.MANUAL_BY_TOPIC


def profile(**policies):
    return QoSProfile(depth=10, **policies)


# One profile ----------------------------------------------------------------------


def test_a_depth_alone_means_keep_last_reliable_and_volatile():
    qos = QoSProfile(depth=5)
    assert (qos.history, qos.depth, qos.reliability, qos.durability) == (
        HistoryPolicy.KEEP_LAST,
        5,
        RELIABLE,
        VOLATILE,
    )


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


def test_profiles_are_equal_field_by_field():
    assert profile() == profile()
    assert profile() != profile(durability=TRANSIENT_LOCAL)
    assert profile() != 10


def test_a_profile_names_its_policies_in_text():
    text = str(QoSProfile(depth=3, durability=TRANSIENT_LOCAL))
    assert text.startswith("QoSProfile(history=")
    assert "depth=3" in text


def test_policies_have_the_numbers_of_rmw_and_their_old_names():
    assert [(p.name, p.value) for p in ReliabilityPolicy] == [
        ("SYSTEM_DEFAULT", 0),
        ("RELIABLE", 1),
        ("BEST_EFFORT", 2),
        ("UNKNOWN", 3),
        ("BEST_AVAILABLE", 4),
    ]
    assert (DurabilityPolicy.TRANSIENT_LOCAL, DurabilityPolicy.VOLATILE) == (1, 2)
    assert (HistoryPolicy.KEEP_LAST, HistoryPolicy.KEEP_ALL, HistoryPolicy.UNKNOWN) == (1, 2, 3)
    assert (QoSLivelinessPolicy.AUTOMATIC, QoSLivelinessPolicy.MANUAL_BY_TOPIC) == (1, 3)
    assert (QoSReliabilityPolicy, QoSDurabilityPolicy, QoSHistoryPolicy) == (
        ReliabilityPolicy,
        DurabilityPolicy,
        HistoryPolicy,
    )


def test_a_number_given_as_a_profile_is_a_depth():
    assert profile_from(7) == QoSProfile(depth=7)
    given = profile()
    assert profile_from(given) is given
    with pytest.raises(ValueError):
        profile_from(-1)
    with pytest.raises(TypeError):
        profile_from("10")


@pytest.mark.parametrize(
    ("preset", "reliability", "durability", "depth"),
    [
        ("DEFAULT", RELIABLE, VOLATILE, 10),
        ("SENSOR_DATA", BEST_EFFORT, VOLATILE, 5),
        ("SERVICES_DEFAULT", RELIABLE, VOLATILE, 10),
        ("PARAMETERS", RELIABLE, VOLATILE, 1000),
        ("PARAMETER_EVENTS", RELIABLE, VOLATILE, 1000),
        ("ACTION_STATUS_DEFAULT", RELIABLE, TRANSIENT_LOCAL, 1),
    ],
)
def test_the_presets_are_those_of_ros(preset, reliability, durability, depth):
    qos = QoSPresetProfiles[preset].value
    assert (qos.history, qos.reliability, qos.durability, qos.depth) == (
        HistoryPolicy.KEEP_LAST,
        reliability,
        durability,
        depth,
    )


def test_a_preset_is_found_by_its_name_on_the_command_line():
    assert QoSPresetProfiles.get_from_short_key("sensor_data") == qos_profile_sensor_data


# Two profiles ---------------------------------------------------------------------


@pytest.mark.parametrize(
    ("offered", "requested", "policy", "reason"),
    [
        ({"reliability": RELIABLE}, {"reliability": RELIABLE}, None, ""),
        ({"reliability": RELIABLE}, {"reliability": BEST_EFFORT}, None, ""),
        ({"reliability": BEST_EFFORT}, {"reliability": BEST_EFFORT}, None, ""),
        (
            {"reliability": BEST_EFFORT},
            {"reliability": RELIABLE},
            "RELIABILITY",
            "ERROR: Best effort publisher and reliable subscription;",
        ),
        ({"durability": TRANSIENT_LOCAL}, {"durability": TRANSIENT_LOCAL}, None, ""),
        ({"durability": TRANSIENT_LOCAL}, {"durability": VOLATILE}, None, ""),
        (
            {"durability": VOLATILE},
            {"durability": TRANSIENT_LOCAL},
            "DURABILITY",
            "ERROR: Volatile publisher and transient local subscription;",
        ),
    ],
)
def test_an_offer_fits_if_it_is_no_less_than_the_request(offered, requested, policy, reason):
    offered = profile(liveliness=AUTOMATIC, **offered)
    requested = profile(liveliness=AUTOMATIC, **requested)
    assert incompatible_policy(offered, requested) == policy
    result = QoSCompatibility.OK if policy is None else QoSCompatibility.ERROR
    assert qos_check_compatible(offered, requested) == (result, reason)


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
    ],
)
def test_an_undetermined_policy_gives_a_warning(policy, offered, requested, reason):
    sides = [profile(**{"liveliness": AUTOMATIC, policy: value}) for value in (offered, requested)]
    assert qos_check_compatible(*sides) == (QoSCompatibility.WARNING, f"WARNING: {reason};")


@pytest.mark.parametrize(
    ("policy", "offered", "requested"), [("reliability", 0, BEST_EFFORT), ("durability", 0, VOLATILE)]
)
def test_an_undetermined_policy_is_ok_if_every_value_is_compatible(policy, offered, requested):
    sides = [profile(**{"liveliness": AUTOMATIC, policy: value}) for value in (offered, requested)]
    assert qos_check_compatible(*sides) == (QoSCompatibility.OK, "")


def test_history_and_depth_do_not_affect_compatibility():
    keep_all = QoSProfile(history=HistoryPolicy.KEEP_ALL)
    assert incompatible_policy(QoSProfile(depth=1), keep_all) is None
    assert incompatible_policy(keep_all, QoSProfile(depth=1)) is None


def test_a_subscription_may_expect_messages_no_more_often_than_they_are_promised():
    slow, fast = profile(deadline=Duration(seconds=2)), profile(deadline=Duration(seconds=1))
    assert incompatible_policy(fast, slow) is None
    assert incompatible_policy(slow, fast) == "DEADLINE"
    assert incompatible_policy(profile(), fast) == "DEADLINE"


def test_liveliness_that_is_requested_by_topic_must_be_offered_by_topic():
    by_topic = profile(liveliness=QoSLivelinessPolicy.MANUAL_BY_TOPIC)
    automatic = profile(liveliness=QoSLivelinessPolicy.AUTOMATIC)
    assert incompatible_policy(by_topic, automatic) is None
    assert incompatible_policy(automatic, by_topic) == "LIVELINESS"


STRICT = QoSProfile(depth=1, reliability=ReliabilityPolicy.RELIABLE)
LOOSE = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)

#   publisher, best effort --x--> subscription, reliable


@pytest.fixture
def node(graph):
    rclpy.init()
    yield Node("ends")
    rclpy.shutdown()


def told(infos):
    return [(info.total_count, info.total_count_change, info.last_policy_kind) for info in infos]


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
    assert told(subscription) == [(1, 1, QoSPolicyKind.RELIABILITY), (2, 1, QoSPolicyKind.RELIABILITY)]
    assert told(publisher) == [(1, 1, QoSPolicyKind.RELIABILITY)] * 2
    assert qos_policy_name_from_kind(subscription[0].last_policy_kind) == "RELIABILITY"
    assert "incompatible QoS" not in capsys.readouterr().err


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
        (PublisherEventCallbacks, "matched"),
        (SubscriptionEventCallbacks, "message_lost"),
        (SubscriptionEventCallbacks, "liveliness"),
    ],
)
def test_an_unsupported_event_type_is_refused(callbacks, event):
    with pytest.raises(UnsupportedEventTypeError, match=f"nobody reports the event '{event}'"):
        callbacks(**{event: print})
