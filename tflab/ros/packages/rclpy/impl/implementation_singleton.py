"""rclpy.impl.implementation_singleton: of rclpy's lower half, only what it raises."""
