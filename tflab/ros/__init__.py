"""ROS 2 in one process: nodes, topics, clocks and tf2_ros, import-compatible with the real ones.

In a script (wall time; stands aside beside a real ROS 2):

    import tflab.ros
    tflab.ros.activate()
    import rclpy                      # and tf2_ros, geometry_msgs, ...

Node files as they are, together, in real time, until Ctrl-C:

    tflab.ros.run_files(["talker.py", "listener.py"])

On virtual time, as in pages (`%load_ext tflab` does the first two lines):

    import tflab.ros
    tflab.ros.activate("in-process")
    graph = tflab.ros.new_graph()     # virtual time, stands at 1 s
    import rclpy
    from rclpy.node import Node

    def main():                       # what one would run in a terminal
        rclpy.init()
        node = Node("talker")
        node.create_timer(1.0, lambda: node.get_logger().info("hello"))
        rclpy.spin(node)

    graph.start(main)                 # lives on between cells
    graph.run(seconds=3)              # three hellos, in milliseconds
    graph.disturb("/tf", delay=0.1)   # lessons can stage trouble
    graph.stop()                      # as if by Ctrl-C

`current_graph()` is the graph that `rclpy.init()` attaches to.  Read in this order:

    activation  distro | time  duration  clock  time_source | qos  names  exceptions
    process     virtual  wall  graph  network | context  executors  task  timer
    node        publisher  subscription  service  parameter  node_parameters
    convert     tf2_core  tf2_buffer  tf2_listener  tf2_broadcaster | snapshot
"""

from .activation import activate, deactivate, is_active

__all__ = ["activate", "deactivate", "is_active"]
