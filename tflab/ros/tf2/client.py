"""Look transforms up in the buffer of another node: tf2_ros.BufferClient.

    lookup_transform(...)  --goal-->   action server with a Buffer     (on a robot: ros2 run tf2_ros buffer_server)
                           <--result-- a transform, or the number and the text of what went wrong

It saves every small node from listening to all of /tf.  It blocks, so some other
thread must spin the node.
"""

from __future__ import annotations

import warnings
from typing import Any

from tflab.core import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TimeoutException,
    TransformException,
)

from ..action_client import ActionClient
from ..messages import builtin_interfaces, geometry_msgs, tf2_msgs
from ..task import Future
from ..time import Duration, Time
from .interface import NO_WAIT, BufferInterface

__all__ = ["BufferClient"]

TransformStamped = geometry_msgs.TransformStamped
TF2Error = tf2_msgs.TF2Error

_EXCEPTIONS = {
    TF2Error.LOOKUP_ERROR: LookupException,
    TF2Error.CONNECTIVITY_ERROR: ConnectivityException,
    TF2Error.EXTRAPOLATION_ERROR: ExtrapolationException,
    TF2Error.INVALID_ARGUMENT_ERROR: InvalidArgumentException,
    TF2Error.TIMEOUT_ERROR: TimeoutException,
}


class BufferClient(BufferInterface):
    """Asks a buffer through an action.

    Args:
        node: some other thread must spin it.
        ns: the name of the action.
        check_frequency: as upstream; nothing is polled here.
        timeout_padding: how much longer than `timeout` an answer may take.
    """

    def __init__(
        self,
        node: Any,
        ns: str,
        check_frequency: float = 10.0,
        timeout_padding: Duration = Duration(seconds=2.0),  # noqa: B008 - as upstream; it never changes
    ) -> None:
        super().__init__()
        self.node = node
        self.action_client = ActionClient(node, tf2_msgs.LookupTransform, ns)
        self.timeout_padding = timeout_padding

    def lookup_transform(
        self, target_frame: str, source_frame: str, time: Time, timeout: Duration = NO_WAIT
    ) -> TransformStamped:
        """Return what moves points from source to target.

        Raises:
            TransformException: what the other buffer says; TimeoutException if it says nothing.
            TypeError: `time` is no rclpy Time.
        """
        goal = tf2_msgs.LookupTransform.Goal(
            target_frame=target_frame,
            source_frame=source_frame,
            source_time=_message_from(time),
            timeout=timeout.to_msg(),
            advanced=False,
        )
        return self._ask(goal, timeout)

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
    ) -> TransformStamped:
        """Return source at its time as seen from target at another, `fixed_frame` standing still between."""
        goal = tf2_msgs.LookupTransform.Goal(
            target_frame=target_frame,
            source_frame=source_frame,
            source_time=_message_from(source_time),
            timeout=timeout.to_msg(),
            target_time=_message_from(target_time),
            fixed_frame=fixed_frame,
            advanced=True,
        )
        return self._ask(goal, timeout)

    def can_transform(self, target_frame: str, source_frame: str, time: Time, timeout: Duration = NO_WAIT) -> bool:
        """Return whether lookup_transform would answer."""
        try:
            self.lookup_transform(target_frame, source_frame, time, timeout)
        except TransformException:
            return False
        return True

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
    ) -> bool:
        """Return whether lookup_transform_full would answer."""
        try:
            self.lookup_transform_full(target_frame, target_time, source_frame, source_time, fixed_frame, timeout)
        except TransformException:
            return False
        return True

    def destroy(self) -> None:
        """Ask no more."""
        self.action_client.destroy()

    def _ask(self, goal: tf2_msgs.LookupTransform.Goal, timeout: Duration) -> TransformStamped:
        if not self.action_client.server_is_ready():
            raise TimeoutException("The BufferServer is not ready.")
        limit_ns = (timeout + self.timeout_padding).nanoseconds
        handle = self._wait(self.action_client.send_goal_async(goal), limit_ns)
        if not handle.accepted:
            raise TimeoutException(
                "The LookupTransform goal sent to the BufferServer did not come back with accepted status. "
                "Something is likely wrong with the server."
            )
        result = self._wait(handle.get_result_async(), limit_ns).result
        if result.error.error != TF2Error.NO_ERROR:
            raise _EXCEPTIONS.get(result.error.error, TransformException)(result.error.error_string)
        return result.transform

    def _wait(self, future: Future, limit_ns: int) -> Any:
        """Block until a future is done; somebody else spins."""
        if not self.node.context.process.wait_for(future, limit_ns):
            raise TimeoutException(
                "The LookupTransform goal sent to the BufferServer did not come back in the specified time. "
                "Something is likely wrong with the server."
            )
        return future.result()


def _message_from(time: Time | builtin_interfaces.Time) -> builtin_interfaces.Time:
    if isinstance(time, builtin_interfaces.Time):
        warnings.warn("Passing a builtin_interfaces.msg.Time argument is deprecated, use rclpy.time.Time", stacklevel=4)
        return time
    if not isinstance(time, Time):
        raise TypeError("Must pass a rclpy.time.Time object.")
    return time.to_msg()
