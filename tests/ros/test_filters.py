"""message_filters: subscribers, caches and synchronizers."""

import pytest

from tflab.ros.messages.geometry_msgs import PointStamped
from tflab.ros.messages.std_msgs import String
from tflab.ros.tf2.filters import ApproximateTimeSynchronizer, Cache, SimpleFilter, Subscriber, TimeSynchronizer
from tflab.ros.time import Time

MS = 1_000_000


def at(milliseconds, name=""):
    message = PointStamped()
    message.header.stamp = Time(nanoseconds=milliseconds * MS).to_msg()
    message.header.frame_id = name
    return message


def time(milliseconds):
    return Time.from_msg(at(milliseconds).header.stamp)


def milliseconds(message):
    return Time.from_msg(message.header.stamp).nanoseconds // MS


def collected(synchronizer):
    """Return the list that fills with the stamps [ms] of each set that is passed on."""
    sets = []
    synchronizer.registerCallback(lambda *messages: sets.append([milliseconds(message) for message in messages]))
    return sets


# SimpleFilter and Subscriber ------------------------------------------------------


def test_callbacks_get_the_message_and_their_own_arguments_in_order_of_registration():
    source, calls = SimpleFilter(), []
    assert source.registerCallback(lambda message, word: calls.append((message, word)), "first") == 0
    assert source.registerCallback(lambda message: calls.append(message)) == 1
    source.signalMessage("m")
    assert calls == [("m", "first"), "m"]


class NodeThatRemembers:
    def create_subscription(self, msg_type, topic, callback, **options):
        self.asked = (msg_type, topic, options)
        self.receive = callback
        return "subscription"


def test_a_subscriber_is_a_subscription_of_depth_ten_that_passes_messages_on():
    node, received = NodeThatRemembers(), []
    subscriber = Subscriber(node, PointStamped, "detected_point")
    subscriber.registerCallback(received.append)
    assert node.asked == (PointStamped, "detected_point", {"qos_profile": 10})
    assert (subscriber.getTopic(), subscriber.sub) == ("detected_point", "subscription")
    message = at(1)
    node.receive(message)
    assert received == [message]
    Subscriber(node, PointStamped, "p", qos_profile=1, raw=False)
    assert node.asked[2] == {"qos_profile": 1, "raw": False}


# Cache ----------------------------------------------------------------------------


def filled_cache(*stamps_ms, size=10):
    source = SimpleFilter()
    cache = Cache(source, size)
    for stamp_ms in stamps_ms:
        source.signalMessage(at(stamp_ms))
    return cache


def test_a_cache_answers_by_time_both_ends_included():
    cache = filled_cache(10, 20, 30)
    assert [milliseconds(m) for m in cache.getInterval(time(10), time(20))] == [10, 20]
    assert milliseconds(cache.getElemAfterTime(time(15))) == 20
    assert milliseconds(cache.getElemAfterTime(time(20))) == 20
    assert milliseconds(cache.getElemBeforeTime(time(29))) == 20
    assert milliseconds(cache.getElemBeforeTime(time(30))) == 30
    assert (cache.getOldestTime(), cache.getLastestTime()) == (time(10), time(30))
    assert milliseconds(cache.getLast()) == 30


def test_a_cache_has_none_for_times_outside_and_when_it_is_empty():
    cache, empty = filled_cache(10), filled_cache()
    assert cache.getElemBeforeTime(time(9)) is None
    assert cache.getElemAfterTime(time(11)) is None
    assert (empty.getOldestTime(), empty.getLastestTime(), empty.getLast()) == (None, None, None)
    with pytest.raises(AssertionError):
        cache.getInterval(time(20), time(10))


def test_a_full_cache_forgets_what_came_first_and_passes_all_messages_on():
    assert [milliseconds(m) for m in filled_cache(10, 20, 30, size=2).cache_msgs] == [20, 30]
    source, received = SimpleFilter(), []
    cache = Cache(source)  # of size one
    cache.registerCallback(lambda message: received.append(milliseconds(message)))
    for stamp_ms in (10, 20):
        source.signalMessage(at(stamp_ms))
    assert ([milliseconds(m) for m in cache.cache_msgs], received) == ([20], [10, 20])


def test_a_message_without_a_header_is_refused_unless_allowed(capsys):
    source = SimpleFilter()
    strict, lenient = Cache(source), Cache(source, allow_headerless=True)
    (left, _), sets = approximate()
    for each in (source, left):
        each.signalMessage(String(data="x"))
    assert strict.cache_msgs == sets == []
    assert lenient.cache_msgs == [String(data="x")]
    printed = "".join(capsys.readouterr())
    assert (
        "[message_filters_cache]: can not use message filters messages without timestamp infomation when "
        "'allow_headerless' is disabled. auto assign ROSTIME to headerless messages once enabling constructor "
        "option of 'allow_headerless'."
    ) in printed
    assert "[message_filters_approx]: can not use message filters for messages without timestamp infomation" in printed


# Equal stamps ---------------------------------------------------------------------


def test_a_set_is_passed_on_once_in_the_order_of_the_inputs_when_all_have_the_same_stamp():
    left, right = SimpleFilter(), SimpleFilter()
    names = []
    synchronizer = TimeSynchronizer([left, right], 10)
    synchronizer.registerCallback(lambda a, b: names.append((a.header.frame_id, b.header.frame_id)))
    late = at(10)
    late.header.stamp.nanosec += 1
    right.signalMessage(late)
    left.signalMessage(at(10, "left"))
    assert names == []
    for _ in range(2):
        right.signalMessage(at(10, "right"))
    assert names == [("left", "right")]


def test_a_full_queue_forgets_the_oldest_stamp_not_the_first_to_come():
    left, right = SimpleFilter(), SimpleFilter()
    sets = collected(TimeSynchronizer([left, right], 2))
    for stamp_ms in (30, 10, 20):
        left.signalMessage(at(stamp_ms))
    for stamp_ms in (10, 20, 30):
        right.signalMessage(at(stamp_ms))
    assert sets == [[20, 20], [30, 30]]


# Near stamps ----------------------------------------------------------------------


def approximate(count=2, queue_size=10, slop=0.05, **options):
    inputs = [SimpleFilter() for _ in range(count)]
    return inputs, collected(ApproximateTimeSynchronizer(inputs, queue_size, slop, **options))


def test_near_stamps_make_a_set_and_far_ones_do_not():
    (left, right), sets = approximate(slop=0.05)
    left.signalMessage(at(100))
    for far_ms in (151, 150):
        right.signalMessage(at(far_ms))
    assert sets == []
    right.signalMessage(at(149))
    assert sets == [[100, 149]]


def test_of_several_candidates_the_nearest_is_taken_and_used_up():
    (left, right), sets = approximate(slop=0.05)
    for stamp_ms in (100, 120, 140):
        left.signalMessage(at(stamp_ms))
    right.signalMessage(at(125))
    right.signalMessage(at(124))
    assert sets == [[120, 125], [140, 124]]


def test_three_inputs_must_all_be_near_each_other():
    (a, b, c), sets = approximate(count=3, slop=0.05)
    a.signalMessage(at(100))
    b.signalMessage(at(140))
    c.signalMessage(at(60))  # near a, but 80 ms from b
    assert sets == []
    c.signalMessage(at(120))
    assert sets == [[100, 140, 120]]
