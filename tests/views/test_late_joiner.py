"""What a listener that joins late still hears: the last message of each transient local publisher that is alive."""

import pytest

from tflab.views.late_joiner import Sender, SentMessage, draw_joins, frames_known, messages_received
from tflab.views.panels import joins_panel

#  calibrator: camera_1 at 1 s, camera_2 at 2 s, ends at 4 s     driver: VOLATILE, one letter at 1 s
#  wheels: on /tf, base_link every second
CALIBRATOR = Sender("calibrator", (SentMessage(1.0, ("camera_1",)), SentMessage(2.0, ("camera_2",))), ends_s=4.0)
DRIVER = Sender("driver", (SentMessage(1.0, ("laser_frame",)),), is_stored=False)
WHEELS = Sender("wheels", tuple(SentMessage(float(i), ("base_link",)) for i in (1, 2, 3)), is_stored=False, topic="/tf")
ALL = (CALIBRATOR, DRIVER, WHEELS)


@pytest.mark.parametrize(
    ("join_s", "frames"),
    [
        (0.5, ["camera_1", "camera_2"]),  # there from the beginning
        (1.5, ["camera_1", "camera_2"]),  # camera_1 was stored, camera_2 comes
        (2.5, ["camera_2"]),  # the board has its last letter alone
        (3.999, ["camera_2"]),
        (4.0, []),  # and it went with its publisher
    ],
)
def test_a_board_keeps_its_last_letter_as_long_as_its_publisher_lives(join_s, frames):
    assert frames_known([CALIBRATOR], join_s, 5.0) == frames


def test_a_listener_that_asks_for_what_is_stored_is_not_connected_to_one_who_stores_nothing():
    assert messages_received(DRIVER, 0.5, 5.0) == []
    assert messages_received(DRIVER, 0.5, 5.0, asks_for_stored=False) == list(DRIVER.messages)
    assert messages_received(WHEELS, 2.5, 5.0) == [WHEELS.messages[2]]  # on /tf, nothing is stored


def test_who_does_not_ask_hears_only_what_is_sent_from_now_on_and_nothing_of_the_future():
    assert frames_known([CALIBRATOR], 1.5, 5.0, asks_for_stored=False) == ["camera_2"]
    assert frames_known([CALIBRATOR], 2.5, 5.0, asks_for_stored=False) == []
    assert frames_known([CALIBRATOR], 0.5, 1.5) == ["camera_1"]
    assert frames_known([CALIBRATOR._replace(ends_s=1.5)], 0.5, 5.0) == ["camera_1"]


def test_joins_in_words():
    assert draw_joins(ALL, 2.5, 6.0).text.splitlines() == [
        "from 0.0 s to 6.0 s",
        f"calibrator |{' ' * 10}o{'=' * 9}@{'=' * 19}x{' ' * 19}| /tf_static, 1 of 2 heard",
        f"driver     |{' ' * 10}o{' ' * 49}| /tf_static, incompatible QoS",
        f"wheels     |{' ' * 10}o{' ' * 9}o{' ' * 9}@{' ' * 29}| /tf, 1 of 3 heard",
        f"listener   |{' ' * 25}^{' ' * 34}| joins at 2.50 s, TRANSIENT_LOCAL",
        "knows: camera_2, base_link",
    ]


def test_letters_that_are_heard_are_filled_and_stand_where_they_were_sent():
    picture = draw_joins(ALL, 2.5, 6.0)
    received = [line for line in picture.ax.lines if line.get_gid() in (0, 1, 2)]
    assert [list(line.get_xdata()) for line in received] == [[2.0], [], [3.0]]


def test_panel_shows_what_a_listener_knows_for_each_join_and_durability():
    panel = joins_panel(ALL, 0.5, 6.0)
    assert panel.text.endswith("knows: camera_1, camera_2, base_link")
    panel.controls["join [s]"].value = 2.5
    assert panel.text.endswith("knows: camera_2, base_link")
    panel.controls["durability"].value = False
    assert panel.text.endswith("knows: base_link")
    panel.controls["join [s]"].value = 0.5
    assert panel.text.endswith("knows: camera_1, camera_2, laser_frame, base_link")
    panel.close()
