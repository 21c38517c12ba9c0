"""Do all nodes read the same clock?  Only a living graph can tell: a recording has no nodes.

/clock --> /point_to_map   use_sim_time: true
           /ekf            use_sim_time: false     stamps of another day
"""

from __future__ import annotations

from collections.abc import Iterator

from tflab.ros.snapshot import GraphSnapshot

from ..findings import Finding

__all__ = ["mixed_time_sources"]

TRANSFORM_TOPICS = ("/tf", "/tf_static")


def mixed_time_sources(snapshot: GraphSnapshot) -> Iterator[Finding]:
    """Yield a finding if, of the nodes that deal with transforms, some follow /clock and others do not."""
    nodes = [n for n in snapshot.nodes if {*n.publishes, *n.subscribes} & set(TRANSFORM_TOPICS)]
    following = [node.name for node in nodes if node.follows_clock]
    others = [node.name for node in nodes if not node.follows_clock]
    if following and others:
        facts = {"following": ", ".join(following), "others": ", ".join(others), "node": others[0]}
        yield Finding("mixed-time", "error", topic="/clock", facts=facts)
