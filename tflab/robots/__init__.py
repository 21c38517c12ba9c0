"""Simulate robots: model, motion, sensors, nodes and faults.

    model             links, joints and shapes; joint positions -> poses of the links
    xml_lines         XML with line numbers
    urdf              URDF -> model, or an error with its line
    state_publisher   robot_state_publisher: a model and joint states -> /tf, /tf_static

    seeded_rng        random generators from a seed and a name
    motion            the true motion of the teaching robot
    odometry          wheel odometry with drift, and a localizer that corrects map -> odom
    readings          values of sensors with their stamps
    sensors           laser, camera and IMU in a room
    teaching          the whole robot, without ROS: buffers, records, readings
    reading_messages  readings as ROS messages
    nodes             the same robot on ROS, one node for each publisher
    circle            the lecture's circle, as written and as meant
    turtlesim         turtlesim without its window

    faults/           faults to inject into recordings

The list is the reading order.
"""
