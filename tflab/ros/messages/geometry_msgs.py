"""Define geometry_msgs.

A default Quaternion is the identity, so a default Pose or Transform is one too.
Covariances are 6x6, row by row, in the order x, y, z, and the turns about x, y, z.
"""

from .packages import ros_package

globals().update(ros_package(__name__))
