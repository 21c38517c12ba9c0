"""What tf2_monitor reckons and prints: to the letter."""

import pytest

from tflab.tools.tf2_monitor import Delays, NetDelay, broadcaster_line, frame_lines, results_heading

from .robot import moving


def heard(*messages):
    delays = Delays()
    for now_s, stamps_s in messages:
        delays.add_message(now_s, stamps_s)
    return delays


def test_a_report_on_a_chain_begins_with_the_chain():
    net = NetDelay(average=0.00812, largest=0.0123)
    assert results_heading(["map", "odom", "base_link"], net) == (
        "\n\n\nRESULTS: for map to base_link\n"
        "Chain is: map -> odom -> base_link\n"
        "Net delay     avg = 0.00812: max = 0.0123"
    )


def test_each_frame_has_its_average_and_its_largest_delay_which_is_none_of_the_future():
    delays = heard((10.25, [("base_link", 10.0)]), (10.75, [("base_link", 10.0)]))
    assert frame_lines(delays) == [
        "Frame: base_link, published by <no authority available>, Average Delay: 0.5, Max Delay: 0.75"
    ]
    assert frame_lines(heard((1.0, [("odom", 1.5)])))[0].endswith("Average Delay: -0.5, Max Delay: 0")


def test_frames_stand_in_alphabetical_order_and_only_those_of_the_chain():
    delays = heard((1.0, [("odom", 1.0), ("base_link", 1.0), ("arm", 1.0)]))
    assert [line.split(",")[0] for line in frame_lines(delays)] == ["Frame: arm", "Frame: base_link", "Frame: odom"]
    assert len(frame_lines(delays, ["map", "odom", "base_link"])) == 2


def test_everybody_is_one_broadcaster():
    delays = heard((1.0, [("odom", 0.5)]), (2.0, [("base_link", 1.5)]))
    # 2 messages in 1 s: n / span, so 2 Hz and not 1
    assert broadcaster_line(delays) == "Node: <no authority available> 2 Hz, Average Delay: 0.5 Max Delay: 0.5"
    assert " 1e+08 Hz" in broadcaster_line(heard((1.0, [("odom", 0.5)])))  # of a single message


def test_the_last_thousand_are_kept():
    delays = heard(*((float(number), [("odom", 0.0)]) for number in range(1001)))
    assert frame_lines(delays)[0].endswith("Average Delay: 500.5, Max Delay: 1000")  # the mean of 1 .. 1000


def test_the_net_delay_creeps_up_from_zero():
    net = NetDelay()
    net.add(1.0)
    net.add(1.0)
    assert net.average == pytest.approx(0.0199)  # 0.01, then 0.01 + 0.99 * 0.01
    assert net.largest == 1.0


def test_a_page_waits_for_the_report_of_a_chain_that_takes_long_to_come(terminal):
    terminal.graph.start(moving())
    terminal.graph.disturb("/tf", delay=3.0)
    out = terminal.type("ros2 run tf2_ros tf2_monitor odom base_link")
    assert "RESULTS: for odom to base_link" in out
