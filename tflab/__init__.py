"""tflab: a book that runs.  It teaches ROS 2 TF2 to someone who has only Python."""

__version__ = "0.1.0"


def load_ipython_extension(ipython):
    """Answer `%load_ext tflab`: the in-process ROS 2 on virtual time, and the magic %ros2."""
    from tflab.ros import load_in_notebook
    from tflab.tools import magic

    load_in_notebook(ipython)
    magic.register(ipython)
