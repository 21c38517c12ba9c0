"""A small robot for the tools to look at: odom -> base_link at 20 Hz, a bolted-on laser."""

import math

from tflab.ros import client_library as rclpy
from tflab.ros.messages.geometry_msgs import TransformStamped
from tflab.ros.node import Node
from tflab.ros.tf2.topics import StaticTransformBroadcaster, TransformBroadcaster


def transform(node, parent, child, x=0.0, y=0.0, z=0.0, yaw=0.0):
    """A message, stamped now."""
    message = TransformStamped(child_frame_id=child)
    message.header.frame_id = parent
    message.header.stamp = node.get_clock().now().to_msg()
    message.transform.translation.x = x
    message.transform.translation.y = y
    message.transform.translation.z = z
    message.transform.rotation.z = math.sin(yaw / 2)
    message.transform.rotation.w = math.cos(yaw / 2)
    return message


def moving(parent="odom", child="base_link", name="moving_robot_broadcaster", rate_hz=20.0, speed=1.0, y=0.0):
    """A main function: `child` drives along x at `speed` [m/s]; it is at 0 when the graph's time is 1 s."""

    def main():
        rclpy.init()
        node = Node(name)
        broadcaster = TransformBroadcaster(node)

        def tick():
            x = speed * (node.get_clock().now().nanoseconds / 1e9 - 1.0)
            broadcaster.sendTransform(transform(node, parent, child, x, y))

        node.create_timer(1.0 / rate_hz, tick)
        spin(node)

    return main


def fixed(parent="base_link", child="laser_frame", name="static_sensor_broadcaster", x=0.2, z=0.15):
    """A main function: `child` is bolted on."""

    def main():
        rclpy.init()
        node = Node(name)
        StaticTransformBroadcaster(node).sendTransform(transform(node, parent, child, x, 0.0, z))
        spin(node)

    return main


def spin(node):
    """Spin until Ctrl-C, and tidy up."""
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    finally:
        node.destroy_node()
        rclpy.shutdown()
