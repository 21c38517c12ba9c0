"""Define std_srvs."""

from .packages import ros_package

globals().update(ros_package(__name__))
