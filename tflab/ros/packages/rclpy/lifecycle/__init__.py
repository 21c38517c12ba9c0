"""rclpy.lifecycle"""

from tflab.ros.lifecycle import (
    LifecycleMixin as LifecycleMixin,
    LifecycleNode as LifecycleNode,
    LifecyclePublisher as LifecyclePublisher,
    ManagedEntity as ManagedEntity,
    SimpleManagedEntity as SimpleManagedEntity,
)
from tflab.ros.lifecycle_states import (
    LifecycleState as LifecycleState,
    TransitionCallbackReturn as TransitionCallbackReturn,
)

Node = LifecycleNode
Publisher = LifecyclePublisher
State = LifecycleState
