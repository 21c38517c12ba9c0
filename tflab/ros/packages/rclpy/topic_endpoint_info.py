"""rclpy.topic_endpoint_info"""

from tflab.ros.graph_queries import TopicEndpointInfo, TopicEndpointTypeEnum

__all__ = [
    "TopicEndpointInfo",
    "TopicEndpointTypeEnum",
]
