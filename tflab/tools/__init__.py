"""Run the commands of a terminal: `ros2 ...`, `rviz2`, and the line magic `%ros2` for pages.

    cpp_numbers                   numbers as C++ reads and writes them
    session                       a tool as a participant of a graph
    static_transform_publisher    tf2_ros: publish a mount
    tf2_echo                      tf2_ros: print a transform
    tf2_monitor                   tf2_ros: rates and delays
    view_frames                   tf2_tools: the tree
    trees                         the tree of a graph or a buffer, with its real publishers
    discovery                     names that a graph knows
    topic  topic_rates  topic_pub ros2 topic
    node  param                   ros2 node, ros2 param
    service  action  lifecycle    ros2 service, action, lifecycle
    interface                     ros2 interface
    bag  launch                   ros2 bag, ros2 launch
    rviz  rviz2                   what RViz would show of a graph
    ros2                          the command line
    page  magic                   in a page
    shell                         in a shell
    package                       node files as a package for colcon

A tool is two things: functions that turn values into upstream's text, and a small
program on a node that calls them.
"""
