"""Define the messages of ROS packages and their classes.

    from tflab.ros.messages import geometry_msgs      # always
    from geometry_msgs.msg import TransformStamped    # the same class, after activate()

    checks        the switch for checks of field types
    definition    parsed definitions
    fields        what a field may hold
    base          the classes
    builtin_interfaces, std_msgs, geometry_msgs, sensor_msgs, nav_msgs, tf2_msgs,
    rcl_interfaces, action_msgs, lifecycle_msgs
                  the packages that tflab itself uses; definitions.txt has more
    text          YAML, as `ros2 topic echo` prints it
    packages      the definitions of ROS (definitions.txt), and packages defined at run time
    values        conversion to and from plain data: for bags and the command line

The list is the reading order.
"""

from .base import copy_message, type_named
from .checks import field_checks, set_field_checks
from .packages import define

__all__ = ["copy_message", "define", "field_checks", "set_field_checks", "type_named"]
