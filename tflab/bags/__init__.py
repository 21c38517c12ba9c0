"""Read, write, record and play recordings.

    errors      errors that a bag can cause
    recording   a recording as columns, and from there a buffer
    wire        messages and qualities of service, as a bag holds them
    collect     what to do with each kind of message, and where it is kept
    salvage     what is left where the recorder was killed
    reader      from a bag, of ROS 2 or ROS 1, to a recording
    record      `ros2 bag record`: from the graph to a bag
    listen      from the graph to a recording, without a file
    play        `ros2 bag play`: from a bag to the graph
    info        `ros2 bag info`, and an example bag

The files are read and written by the rosbags library, which is loaded only when
a file is opened.
"""
