"""activate() makes the ROS 2 modules importable, and deactivate() removes them."""

import importlib
import sys
import types

import pytest

from tflab import ros
from tflab.ros import activation, distro
from tflab.ros.activation import PACKAGES, is_active, load_in_notebook
from tflab.ros.messages import field_checks


@pytest.fixture(autouse=True)
def clean(monkeypatch):
    monkeypatch.delenv("TFLAB_ROS", raising=False)
    yield
    ros.deactivate()


@pytest.fixture
def real(tmp_path, monkeypatch):
    """Return a function that lets Python find something under a name; it has done so for tf2_ros."""

    def add(name):
        (tmp_path / name).mkdir()
        (tmp_path / name / "__init__.py").write_text("REAL = True\n")
        importlib.invalidate_caches()

    monkeypatch.syspath_prepend(str(tmp_path))
    add("tf2_ros")
    yield add
    sys.modules.pop("rclpy", None)
    sys.modules.pop("tf2_ros", None)


def test_every_package_can_be_imported_and_is_gone_afterwards():
    assert ros.activate() == "in-process"
    for name in PACKAGES:
        importlib.import_module(name)
    ros.deactivate()
    assert not [name for name in PACKAGES if name in sys.modules]
    with pytest.raises(ModuleNotFoundError):
        importlib.import_module("rclpy")


def test_a_missing_module_raises_and_lists_the_existing_modules():
    ros.activate()
    with pytest.raises(ModuleNotFoundError, match=r"No module named 'rclpy\.nodes' .*; rclpy has .*, node, "):
        importlib.import_module("rclpy.nodes")
    with pytest.raises(ModuleNotFoundError, match=r"No module named 'std_msgs\.srv' .*; std_msgs has msg\."):
        importlib.import_module("std_msgs.srv")
    with pytest.raises(ImportError, match="cannot import name 'Nod' from 'rclpy'"):
        exec("from rclpy import Nod")


def test_it_steps_aside_for_a_real_ros_2_unless_the_environment_selects_the_in_process_modules(real, monkeypatch):
    assert ros.activate() == "in-process"  # tf2_ros alone is ROS 1
    assert not hasattr(importlib.import_module("tf2_ros"), "REAL")
    ros.deactivate()
    real("rclpy")
    assert ros.activate() == "real"
    assert importlib.import_module("rclpy").REAL
    del sys.modules["rclpy"]
    monkeypatch.setenv("TFLAB_ROS", "in-process")
    assert ros.activate() == "in-process"
    assert not hasattr(importlib.import_module("rclpy"), "REAL")


def test_what_is_not_there_or_not_known_is_refused_with_the_remedy(monkeypatch):
    monkeypatch.setenv("TFLAB_ROS", "real")
    with pytest.raises(ImportError, match="Source its setup file first"):
        ros.activate()
    monkeypatch.setenv("TFLAB_ROS", "virtual")
    with pytest.raises(ValueError, match='"in-process" or "real"'):
        ros.activate()
    monkeypatch.setenv("TFLAB_ROS_DISTRO", "foxy")
    with pytest.raises(ValueError, match="'foxy' is not known: it is one of humble, jazzy, lyrical, rolling"):
        distro.current()


def test_a_module_that_is_imported_already_is_refused_with_the_remedy(monkeypatch):
    stranger = types.ModuleType("geometry_msgs")
    stranger.__file__ = "/opt/ros/geometry_msgs/__init__.py"
    monkeypatch.setitem(sys.modules, "geometry_msgs", stranger)
    with pytest.raises(ImportError, match=r"geometry_msgs already imported, from /opt/ros.* Restart Python"):
        ros.activate("in-process")
    assert not is_active()


def test_loading_in_a_notebook_prints_one_line_and_provides_the_graph(capsys, undone):
    class Shell:
        def push(self, names):
            self.names = names

    shell = Shell()
    graph = load_in_notebook(shell)
    assert capsys.readouterr().out == "tflab: in-process ROS 2 (jazzy), virtual time, message fields checked.\n"
    assert shell.names["graph"] is graph is ros.current_graph()
    assert graph.driver.is_virtual and field_checks()


def test_deactivate_restores_time_sleep(graph):
    import time

    assert time.sleep.__module__ == "tflab.ros.process"
    ros.deactivate()
    assert time.sleep.__module__ == "time"


@pytest.mark.parametrize("release", ["jazzy", "lyrical"])
def test_no_module_of_a_package_is_empty(monkeypatch, release):
    monkeypatch.setenv("TFLAB_ROS_DISTRO", release)
    ros.activate()
    for name, row in activation._table().items():
        if not distro.has_name(name):
            continue
        module = importlib.import_module(name)
        assert not row or [each for each in vars(module) if not each.startswith("__")], name


def test_the_names_that_programs_use_are_the_same_by_every_import_path():
    ros.activate()
    import rclpy.node
    import tf2_py
    import tf2_ros
    from rclpy._rclpy_pybind11 import RCLError
    from rclpy.impl.implementation_singleton import rclpy_implementation
    from rclpy.topic_or_service_is_hidden import topic_or_service_is_hidden
    from rclpy.utilities import get_rmw_implementation_identifier

    from tflab import core
    from tflab.ros.node import Node

    assert rclpy.node.Node is Node
    assert tf2_ros.LookupException is tf2_py.LookupException is core.LookupException
    assert repr(tf2_ros.LookupException) == "<class 'tf2.LookupException'>"
    assert RCLError.__module__ == "rclpy._rclpy_pybind11"
    assert issubclass(rclpy_implementation.RCLError, RuntimeError)
    assert rclpy_implementation.rclpy_get_rmw_implementation_identifier() == get_rmw_implementation_identifier()
    assert topic_or_service_is_hidden("/_hidden/topic") and not topic_or_service_is_hidden("/topic")
