"""The lecture's nodes and snippets run unchanged on virtual time."""

import math
import runpy
from pathlib import Path

import pytest

LECTURE = Path(__file__).parent / "lecture"


def main_of(name):
    return runpy.run_path(str(LECTURE / f"{name}.py"))["main"]


def lecture_main(name):
    """A main function that reads the file in the participant's own process, as `ros2 run` would."""
    return lambda: runpy.run_path(str(LECTURE / f"{name}.py"), run_name="__main__")


def ask(graph, target, source):
    """What a node in the notebook hears of the graph."""
    import rclpy
    from rclpy.node import Node
    from rclpy.time import Time
    from tf2_ros import Buffer, TransformListener

    rclpy.init()
    node = Node("asker")
    buffer = Buffer(node=node)
    node.listener = TransformListener(buffer, node)
    for _ in range(5):
        rclpy.spin_once(node, timeout_sec=0.1)
    found = buffer.lookup_transform(target, source, Time())
    rclpy.shutdown()
    return found


def test_the_three_nodes_run_together_and_print_what_they_should(activated, capsys):
    graph = activated
    for name in ("static_sensor_broadcaster", "moving_robot_broadcaster", "point_to_map"):
        graph.start(lecture_main(name), name=name)
    assert "[INFO] [1.000000000] [static_sensor_broadcaster]: base_link → laser_frame 발행" in capsys.readouterr().err
    graph.run(seconds=2)
    assert [each.is_running for each in graph.participants] == [True, True, True]
    # Every 0.05 s the angle grows by 0.01; 40 ticks since 1 s.
    found = ask(graph, "odom", "laser_frame")
    assert (found.header.frame_id, found.child_frame_id) == ("odom", "laser_frame")
    assert found.transform.translation.z == pytest.approx(0.15)

    publish_point(graph, frame_id="laser_frame")
    graph.run(seconds=1)
    # Nobody publishes map: the callback waits 0.2 s for it, in vain.
    assert (
        '[point_to_map]: TF 변환 실패: "map" passed to lookupTransform argument target_frame does not exist. '
        in capsys.readouterr().err
    )
    publish_point(graph, frame_id="")
    graph.run(seconds=1)
    assert "[point_to_map]: frame_id가 없는 Point 거절" in capsys.readouterr().err
    graph.start(static_main("map", "odom", x=10.0))
    graph.run(seconds=1)
    publish_point(graph, frame_id="laser_frame")
    graph.run(seconds=1)
    at = 0.01 * 20 * (graph.now_ns / 1e9 - 2.0)  # the angle at which the point was published [rad]
    x, y = 10 + 1.2 * math.cos(at), 1.2 * math.sin(at)
    assert f"map point=({x:.2f}, {y:.2f}, 0.15)" in capsys.readouterr().err
    graph.stop()
    assert [(each.is_running, each.exception) for each in graph.participants[:3]] == [(False, None)] * 3
    assert graph.nodes == []


@pytest.mark.parametrize(
    ("name", "last_line"),
    [
        ("snippet_16_lookup_latest", "OK §16 3.2"),
        ("snippet_17_lookup_at_stamp", "OK §17 error if newest used: 0.200 m"),
        ("snippet_19_wait_async", "OK §19"),
        ("snippet_20_exceptions", "OK §20"),
    ],
)
def test_the_four_snippets_pass(activated, capsys, name, last_line):
    main_of(name)()
    assert capsys.readouterr().out.splitlines()[-1] == last_line


def test_the_same_program_prints_the_same_twice(activated, capsys):
    from tflab import ros

    def transcript():
        graph = ros.new_graph()
        graph.disturb("/tf", delay=0.05, jitter=0.03, loss=0.2, seed=3)
        for name in ("moving_robot_broadcaster", "static_sensor_broadcaster", "point_to_map"):
            graph.start(lecture_main(name), name=name)
        graph.start(static_main("map", "odom"))
        for _ in range(3):
            publish_point(graph, frame_id="laser_frame")
            graph.run(seconds=0.7)
        graph.stop()
        return capsys.readouterr()

    first, second = transcript(), transcript()
    assert first == second
    assert first.err.count("\n") >= 4


def publish_point(graph, frame_id):
    """Publish one detected point from the notebook, stamped now."""
    import rclpy
    from geometry_msgs.msg import PointStamped
    from rclpy.node import Node

    rclpy.init()
    node = Node("detector")
    publisher = node.create_publisher(PointStamped, "detected_point", 10)
    point = PointStamped()
    point.header.frame_id = frame_id
    point.header.stamp = node.get_clock().now().to_msg()
    publisher.publish(point)
    rclpy.shutdown()


def static_main(parent, child, x=0.0):
    """The main function of a node that publishes one static transform."""

    def main():
        import rclpy
        from geometry_msgs.msg import TransformStamped
        from rclpy.node import Node
        from tf2_ros import StaticTransformBroadcaster

        rclpy.init()
        node = Node(f"static_{parent}_{child}")
        transform = TransformStamped(child_frame_id=child)
        transform.header.frame_id = parent
        transform.transform.translation.x = x
        StaticTransformBroadcaster(node).sendTransform(transform)
        rclpy.spin(node)

    return main
