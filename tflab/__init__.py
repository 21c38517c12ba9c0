"""tflab: a Jupyter workbook that teaches ROS 2 TF2 to people who have only Python.

    text       texts in English and Korean, and their YAML files
    core       the TF engine: the buffer of tf2 in readable Python
    views      figures and 3D views
    ros        ROS 2 in one process: nodes, topics, clocks and `tf2_ros`
    robots     a teaching robot, URDF, and faults to inject
    bags       recordings: read, record, play
    doctor     diagnosis of a recording, a graph or a buffer
    tools      ROS 2's command-line tools
    clinic     diagnosis exercises on simulated faulty robots
    workbook   pages, exercises, the checking of answers, the learner's copy
    grading    release of exercises and grading of a class
    cli        the command `tflab`
    extras     which extra installs a missing library

A package imports only packages above it in this list, and `import tflab` loads none of them.
The `__init__.py` of each package lists its modules.
"""

from importlib import import_module

__version__ = "0.1.0"


def load_ipython_extension(ipython):
    """Answer `%load_ext tflab`: the in-process ROS 2 on virtual time, and the magic %ros2; each time in a new world."""
    from tflab.ros import load_in_notebook
    from tflab.tools import magic
    from tflab.views import rerun

    load_in_notebook(ipython)
    magic.register(ipython)
    rerun.register(ipython)
    for name in ("rerun_cleanup", "stale_graph", "cell_errors"):  # by name: the workbook imports this module
        import_module(f"tflab.workbook.{name}").register(ipython)
    ipython.events.register("post_run_cell", _load_anew_next_time)


def _load_anew_next_time(_result):
    """Let `%load_ext tflab` do the same when its cell is run again, and not say that it is loaded already."""
    from IPython import get_ipython

    if get_ipython() is not None:
        get_ipython().extension_manager.loaded.discard(__name__)
