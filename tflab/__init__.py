"""tflab: a book that runs.  It teaches ROS 2 TF2 to someone who has only Python."""

__version__ = "0.1.0"
