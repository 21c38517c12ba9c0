"""rclpy.lifecycle.node"""

from tflab.ros.lifecycle import LifecycleMixin as LifecycleMixin, LifecycleNode as LifecycleNode
from tflab.ros.lifecycle_states import (
    LifecycleState as LifecycleState,
    TransitionCallbackReturn as TransitionCallbackReturn,
)
