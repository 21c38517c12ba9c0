"""Run ROS 2 in one process: nodes, topics, clocks and tf2_ros, import-compatible with the real ones.

In a script (wall time; steps aside for a real ROS 2):

    import tflab.ros
    tflab.ros.activate()
    import rclpy                      # and tf2_ros, geometry_msgs, ...

Node files as they are, together, in real time, until Ctrl-C:

    tflab.ros.run_files(["talker.py", "listener.py"])

On virtual time, as in pages (`%load_ext tflab` does the first three lines, and
leaves the graph in the variable `graph`):

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
    graph.disturb("/tf", delay=0.1, jitter=0.02, loss=0.1, seed=1)   # trouble, staged
    graph.set_clock_offset("talker", 0.5)
    graph.stop()                      # as if by Ctrl-C

`current_graph()` is the graph that `rclpy.init()` attaches to; the cell itself may
also init, create nodes and spin, and time passes while it does.
`snapshot(graph)` says what is going on, in plain values.

In reading order:

    activation  distro                                   import rclpy, %load_ext tflab
    messages/                                            message types
    time  process  virtual  wall  graph  network         processes, topics and the passing of time
    qos  qos_compatibility  names  exceptions  arguments  context  logging
    entity  timer  topic_endpoints  service
    action_goals  action_server  action_client           actions
    task  executors
    parameter  node_parameters  parameter_services  qos_overriding_options
    clock  time_source
    node  node_entities  graph_queries  lifecycle_states  lifecycle
    client_library
    convert  tf2/                                        engine values and messages; tf2_ros
    transformations  cv_bridge                           tf_transformations, cv_bridge
    snapshot  workspace  ament_index  run                a graph as plain values; packages; scripts
"""

from .activation import activate, deactivate, is_active, load_in_notebook
from .graph import Graph, Participant, current_graph, new_graph
from .run import run_files
from .snapshot import snapshot

__all__ = [
    "Graph",
    "Participant",
    "activate",
    "current_graph",
    "deactivate",
    "is_active",
    "load_in_notebook",
    "new_graph",
    "run_files",
    "snapshot",
]
