"""What was heard?  One transform as it arrived, before anybody judged it.

    publisher --- message on a topic ---> listener
                                          topic, receive_ns, publisher,
                                          stamped  (stamp_ns: when it held)

A buffer keeps what is usable.  A recording keeps everything: names with slashes,
rotations of length zero, stamps that go backwards.  So the numbers in here are
as sent, and nothing is dropped, scaled or put in order.  Two times matter, and
they are not the same: `stamped.stamp_ns` says when the transform holds, by the
publisher's clock; `receive_ns` says when it was heard, by the listener's.

A stream is a plain `list[TransformRecord]`, in the order of arrival.  (A rosbag2
keeps topic, receive time and message; who published it is often not known.)
"""

from __future__ import annotations

from typing import NamedTuple

from .transforms import StampedTransform

__all__ = ["TransformRecord"]


class TransformRecord(NamedTuple):
    """One transform of one message.

    Attributes:
        topic: as recorded, "/tf" or "/robot1/tf_static".
        receive_ns: when it was heard [ns], by the listener's clock.
        publisher: full name of the node, "/wheel_odometry"; "" if it is not known.
        stamped: frame names, stamp and numbers exactly as sent, valid or not.
        is_static: whether it came as a static transform: on a `/tf_static` topic.
    """

    topic: str
    receive_ns: int
    publisher: str
    stamped: StampedTransform
    is_static: bool
