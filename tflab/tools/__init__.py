"""What one types in a terminal: `ros2 ...`, `rviz2`, and the line magic `%ros2` for pages.

    numbers_as_in_c               how C++ reads and writes a number
    session                       how a tool takes part in a graph
    static_transform_publisher    how is something bolted on?
    tf2_echo                      where is B as seen from A?
    tf2_monitor                   how late, and how often?
    view_frames                   what does the tree look like?
    trees                         the tree of a graph, with its real publishers
    buffers                       what does this buffer look like?
    discovery                     what is there to name?
    topic  topic_echo  topic_rates  topic_pub    who talks about what, what, and how often?
    node  param                   who is there, and how is it set?
    service  action               who answers, and who works on what takes longer?
    lifecycle                     who is managed, and in which state?
    interface                     what is in a message?
    bag                           what was said, kept and said again?
    rviz  rviz2                   what would RViz see of a graph, and where is it?
    ros2                          what was typed?
    page  completion  magic       in a page
    shell                         in a shell

A tool is two things: functions that turn values into upstream's text, and a small
program on a node that calls them.  Start with `numbers_as_in_c.py`.
"""
