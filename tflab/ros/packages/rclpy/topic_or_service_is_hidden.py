"""rclpy.topic_or_service_is_hidden"""
