"""sensor_msgs_py, in process: only its module point_cloud2."""
