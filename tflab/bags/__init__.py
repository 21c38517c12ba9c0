"""Real recordings: what a robot said, and when it was heard.

    errors      what can be wrong with a file
    recording   a recording as columns, and from there a buffer
    messages    the bytes of a TFMessage, and of a header
    columns     where what was read is kept
    collect     what to do with each kind of message
    salvage     what is left where the recorder was killed
    reader      from a bag, of ROS 2 or ROS 1, to a recording
    wire        messages and qualities of service, as a bag holds them
    record      `ros2 bag record`: from the graph to a bag
    listen      from the graph to a recording, without a file
    play        `ros2 bag play`: from a bag to the graph
    info        `ros2 bag info`
    example     a bag for who has none

The files are read and written by the rosbags library, which is loaded only when
a file is opened.  Start with `errors.py`.
"""
