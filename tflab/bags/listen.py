"""What is said right now?  A recording of a living graph, in memory, with the publishers' names.

    graph --/tf, /tf_static--> a listener for some seconds --> Recording

A file cannot tell who published a transform; in one process nothing gets lost,
so here every label has its publisher.  Read `play.py` next.
"""

from __future__ import annotations

from tflab.core.records import TransformRecord
from tflab.ros import client_library
from tflab.ros.convert import stamped_from_msg
from tflab.ros.graph import Graph
from tflab.ros.messages.tf2_msgs import TFMessage
from tflab.ros.node import Node

from .record import adapted_profile
from .recording import Recording, recording_from_records

__all__ = ["recording_from_graph"]

NODE_NAME = "tf_listener"


def recording_from_graph(graph: Graph, seconds: float = 5.0) -> Recording:
    """Let `seconds` pass on a graph, and return every transform that was heard meanwhile.

    Topics that have no publisher yet are not heard.
    """
    records: list[TransformRecord] = []
    participant = graph.start(_listen, graph, records, name=NODE_NAME)
    graph.run(seconds=seconds)
    graph.stop(participant)
    return recording_from_records(records, "graph")


def _listen(graph: Graph, records: list[TransformRecord]) -> None:
    """Write down all transforms, as a participant of the graph."""
    client_library.init()
    node = Node(NODE_NAME, start_parameter_services=False)
    for topic, types in node.get_topic_names_and_types():
        publishers = node.get_publishers_info_by_topic(topic)
        if types == [TFMessage.ROS_TYPE] and publishers:
            _subscribe(node, topic, publishers, records)
    try:
        client_library.spin(node)
    finally:
        client_library.try_shutdown()


def _subscribe(node: Node, topic: str, publishers: list, records: list[TransformRecord]) -> None:
    names = {bytes(p.endpoint_gid): f"{p.node_namespace.rstrip('/')}/{p.node_name}" for p in publishers}
    is_static = topic.endswith("tf_static")

    def on_message(message: TFMessage, info: dict) -> None:
        publisher = names.get(bytes(info["publisher_gid"]), "")
        for transform in message.transforms:
            stamped = stamped_from_msg(transform)
            records.append(TransformRecord(topic, info["received_timestamp"], publisher, stamped, is_static))

    node.create_subscription(TFMessage, topic, on_message, adapted_profile([p.qos_profile for p in publishers]))
