"""Serve tf2_ros, tf2_py, tf2_geometry_msgs and message_filters in one process.

    core            tf2_py.BufferCore: the engine with ROS messages
    interface       BufferInterface: transform() and the registration of types
    buffer          Buffer, and waiting for a transform
    topics          listeners and broadcasters of /tf and /tf_static
    client          BufferClient: lookups in the buffer of another node
    geometry        transform points, poses, vectors and wrenches
    clouds          transform a PointCloud2
    filters         message_filters
    message_filter  hold a message until its transform is there

The list is the reading order.
"""
