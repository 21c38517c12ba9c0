"""Messages: what nodes send each other.  One table of definitions for each ROS package.

    from tflab.ros.messages import geometry_msgs      # ours, always
    from geometry_msgs.msg import TransformStamped    # the same class, after activate()

    checks        are field types checked?
    definition    what is in a message
    fields        what a field may hold
    base          the classes
    builtin_interfaces, std_msgs, geometry_msgs, sensor_msgs, nav_msgs, visualization_msgs,
    tf2_msgs, rosgraph_msgs, rcl_interfaces, unique_identifier_msgs, action_msgs,
    lifecycle_msgs, trajectory_msgs, diagnostic_msgs, std_srvs, example_interfaces
                  the tables
    text          as `ros2 topic echo` prints them
    fill          from what somebody typed
    own           packages of a learner's own
    values        to plain values and back: for bags

Start with `checks.py`.
"""

from .base import copy_message, type_named
from .checks import field_checks, set_field_checks
from .own import define

__all__ = ["copy_message", "define", "field_checks", "set_field_checks", "type_named"]
