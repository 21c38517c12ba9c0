"""Provide tf2_py.BufferCore: the engine with ROS messages.

BufferCore(Duration(seconds=20))          tf2_py.BufferCore: positional arguments, *_core methods
    `-- .core                             the engine: tflab.core.BufferCore
"""

from __future__ import annotations

from typing import Any

from tflab import core
from tflab.core.velocity import lookup_velocity_as_tf2

from ..convert import duration_ns_from, msg_from_stamped, plain_names, stamp_ns_from, stamped_from_msg
from ..logging import show_engine_refusals
from ..messages import geometry_msgs
from ..time import ClockType, Time

__all__ = ["BufferCore"]

TransformStamped = geometry_msgs.TransformStamped


class BufferCore:
    """Everything that was published, and what can be asked of it.

    Attributes:
        core: the engine, for whoever wants values instead of messages.
    """

    def __init__(self, cache_time: Any = None, /) -> None:
        cache_ns = core.DEFAULT_CACHE_TIME_NS if cache_time is None else duration_ns_from(cache_time)
        self.core = core.BufferCore(cache_ns)
        show_engine_refusals(True)

    def set_transform(self, transform: TransformStamped, authority: str, /) -> None:
        """Store a transform; a bad one is refused with a line in the log.

        Raises:
            TypeError: not a transform, or `authority` is not a str.
        """
        _check_authority(authority)
        self.core.set_transform(stamped_from_msg(transform), authority)

    def set_transform_static(self, transform: TransformStamped, authority: str, /) -> None:
        """Store a transform that is good for any time; as set_transform."""
        _check_authority(authority)
        self.core.set_transform(stamped_from_msg(transform), authority, is_static=True)

    def can_transform_core(self, target_frame: str, source_frame: str, time: Any) -> tuple[int, str]:
        """Return (1, "") if there is an answer now, else (0, why not)."""
        can, text = self.core.why_not(*plain_names(target_frame, source_frame), stamp_ns_from(time))
        return int(can), text

    def can_transform_full_core(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> tuple[int, str]:
        """Return (1, "") if there is an answer now, else (0, why not)."""
        target_frame, source_frame, fixed_frame = plain_names(target_frame, source_frame, fixed_frame)
        can, text = self.core.why_not_full(
            target_frame, stamp_ns_from(target_time), source_frame, stamp_ns_from(source_time), fixed_frame
        )
        return int(can), text

    def lookup_transform_core(self, target_frame: str, source_frame: str, time: Any) -> TransformStamped:
        """Return what moves points from source to target, now, without waiting.

        Raises:
            TransformException: there is no answer; its class and text say why.
        """
        frames = plain_names(target_frame, source_frame)
        return msg_from_stamped(self.core.lookup_transform(*frames, stamp_ns_from(time)))

    def lookup_transform_full_core(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> TransformStamped:
        """Return source at its time as seen from target at another, `fixed_frame` standing still between.

        Raises:
            TransformException: there is no answer; its class and text say why.
        """
        target_frame, source_frame, fixed_frame = plain_names(target_frame, source_frame, fixed_frame)
        return msg_from_stamped(
            self.core.lookup_transform_full(
                target_frame, stamp_ns_from(target_time), source_frame, stamp_ns_from(source_time), fixed_frame
            )
        )

    def get_latest_common_time(self, target_frame: str, source_frame: str, /) -> Time:
        """Return the moment that time zero means between two frames: a SYSTEM_TIME.

        Raises:
            TransformException: a bad or unknown name, or no path.
        """
        stamp_ns = self.core.latest_common_time_ns(*plain_names(target_frame, source_frame))
        return Time(nanoseconds=stamp_ns, clock_type=ClockType.SYSTEM_TIME)

    def lookupVelocityCore(  # the binding's name
        self, tracking_frame: str, observation_frame: str, time: Any, averaging_interval: Any
    ) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
        """Return (linear [m/s], angular [rad/s]) velocity of a frame as seen from another."""
        return self._velocity(tracking_frame, observation_frame, time, averaging_interval)

    def lookupVelocityFullCore(  # the binding's name
        self,
        tracking_frame: str,
        observation_frame: str,
        reference_frame: str,
        reference_point: tuple[float, float, float],
        reference_point_frame: str,
        time: Any,
        averaging_interval: Any,
        /,
    ) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
        """Return (linear [m/s], angular [rad/s]) velocity of a point, in the axes of a third frame."""
        reference = (reference_frame, reference_point, reference_point_frame)
        return self._velocity(tracking_frame, observation_frame, time, averaging_interval, *reference)

    def _velocity(self, tracking: str, observation: str, time: Any, interval: Any, *reference: Any) -> tuple[Any, Any]:
        ask = (self.core.lookup_transform, self.core.latest_common_time_ns)
        span = (stamp_ns_from(time), duration_ns_from(interval))
        velocity = lookup_velocity_as_tf2(*ask, tracking, observation, *span, *reference)
        return velocity.linear, velocity.angular

    def all_frames_as_yaml(self) -> str:
        """Return every edge, as YAML."""
        return self.core.all_frames_as_yaml()

    def all_frames_as_string(self) -> str:
        """Return every edge, a line each."""
        return self.core.all_frames_as_string()

    def clear(self) -> None:
        """Forget every moving sample; names and static transforms stay."""
        self.core.clear()

    def _frameExists(self, frame_id: str, /) -> bool:
        return self.core.frame_exists(frame_id)

    def _getFrameStrings(self) -> list[str]:
        return self.core.frame_names()

    def _allFramesAsDot(self, time: Any = None) -> str:
        return self.core.all_frames_as_dot(None if time is None else stamp_ns_from(time))

    def _chain(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> list[str]:
        to_fixed = self.core.chain(fixed_frame, source_frame, stamp_ns_from(source_time))
        from_fixed = self.core.chain(target_frame, fixed_frame, stamp_ns_from(target_time))
        way: list[str] = []
        for frame in to_fixed + from_fixed[1:]:
            if frame in way:  # there and back again
                del way[way.index(frame) :]
            way.append(frame)
        return way


def _check_authority(authority: object) -> None:
    if not isinstance(authority, str):
        raise TypeError(f"argument 2 must be str, not {type(authority).__name__}")
