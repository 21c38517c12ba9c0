"""Robots: what a robot is made of, where its parts are, and how it moves, measures and fails.

    model             what a URDF says: links, joints, shapes
    xml_lines         XML that remembers its lines
    urdf              a file -> a model, or an error that helps
    kinematics        joint positions -> where every link is
    state_publisher   robot_state_publisher: a model and joint states -> /tf, /tf_static

    chance            what is drawn, from a seed and a name
    motion            where the teaching robot truly is
    odometry          what its wheels make of that: slip and drift
    localization      map -> odom, corrected now and then
    world             a room, and rays that meet its walls
    readings          what a sensor says, and when
    sensors           laser, camera and imu
    teaching          the whole robot, without ROS: buffers, records, readings
    reading_messages  readings as ROS messages
    nodes             the same robot on ROS, one node for each source
    circle            the lecture's circle, as written and as meant

    faults/           what goes wrong, and how to make it go wrong

Start with `model.py`.
"""
