"""rclpy.topic_endpoint_info"""

from tflab.ros.graph_queries import (
    TopicEndpointInfo as TopicEndpointInfo,
    TopicEndpointTypeEnum as TopicEndpointTypeEnum,
)
