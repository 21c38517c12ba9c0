"""tf2_ros, tf2_py and tf2_geometry_msgs, in one process: what a node needs to publish and to ask.

    core            tf2_py: the engine behind its ROS face
    interface       what can be asked of any buffer
    buffer          a Buffer, and waiting for a transform
    listener        /tf and /tf_static -> a buffer
    broadcaster     transforms -> /tf and /tf_static
    client          asking somebody else's buffer
    geometry        points, poses, vectors, wrenches: moved to another frame
    clouds          the same for a PointCloud2
    filters         message_filters
    message_filter  hold a message until its transform is there

Start with `core.py`.
"""
