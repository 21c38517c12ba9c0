"""One buffer, asked and told one by one: reads a JSON command a line, answers with a JSON line.

    engine_peer.py tf2_py    the real tf2: Debian's python3-tf2 (ROS 1 tf2 0.7.6, the same C++ core, behind its binding)
    engine_peer.py tflab     our engine, the build that TFLAB_COMPILED asks for

Run by benchmarks/engine.py, all under one interpreter, so that the same loops time the same work.
"""

import json
import sys
import time
from pathlib import Path

if sys.argv[1] == "tf2_py":
    import rospy
    import tf2_py
    from geometry_msgs.msg import TransformStamped

    def new_buffer(cache_s):
        buffer = tf2_py.BufferCore(rospy.Duration(cache_s))
        return buffer.set_transform, buffer.lookup_transform_core

    def stamp_from_ns(ns):
        return rospy.Time(ns // 10**9, ns % 10**9)

    def message(parent, child, stamp_ns, translation, rotation):
        transform = TransformStamped()
        transform.header.stamp = stamp_from_ns(stamp_ns)
        transform.header.frame_id, transform.child_frame_id = parent, child
        t, r = transform.transform.translation, transform.transform.rotation
        t.x, t.y, t.z = translation
        r.x, r.y, r.z, r.w = rotation
        return transform

    BUILD = "tf2_py"
else:
    sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
    from tflab.core import BUILD, BufferCore, StampedTransform, Transform

    def new_buffer(cache_s):
        buffer = BufferCore(cache_s * 10**9)
        return buffer.set_transform, buffer.lookup_transform

    def stamp_from_ns(ns):
        return ns

    def message(parent, child, stamp_ns, translation, rotation):
        return StampedTransform(parent, child, stamp_ns, Transform(translation, rotation))


def lookups(lookup, target, source, stamps):
    begin = time.process_time()
    for stamp in stamps:
        lookup(target, source, stamp)
    return time.process_time() - begin


def ingest(messages):
    set_transform, _ = new_buffer(10)
    begin = time.process_time()
    for transform in messages:
        set_transform(transform, "peer")
    return time.process_time() - begin


def live(rows, target, source, stamps):
    set_transform, lookup = new_buffer(10)
    begin = time.process_time()
    for row, stamp in zip(rows, stamps, strict=True):
        for transform in row:
            set_transform(transform, "peer")
        if stamp is not None:
            lookup(target, source, stamp)
    return time.process_time() - begin


def main():
    for line in sys.stdin:
        command = json.loads(line)
        do = command["do"]
        answer = {"build": BUILD}
        if do == "fill":
            set_transform, lookup = new_buffer(10**6)
            for sample in command["samples"]:
                set_transform(message(*sample), "peer")
            names = command["target"], command["source"]
            stamps = [stamp_from_ns(ns) for ns in command["stamps_ns"]]
            lookups(lookup, *names, stamps)
        elif do == "lookup":
            answer["seconds"] = lookups(lookup, *names, stamps)
        elif do == "prepare":
            messages = [message(*sample) for sample in command["samples"]]
        elif do == "ingest":
            answer["seconds"] = ingest(messages)
        elif do == "prepare_live":
            rows = [[message(*sample) for sample in row] for row in command["rows"]]
            live_names = command["target"], command["source"]
            live_stamps = [None if ns is None else stamp_from_ns(ns) for ns in command["stamps_ns"]]
        elif do == "live":
            answer["seconds"] = live(rows, *live_names, live_stamps)
        print(json.dumps(answer), flush=True)


main()
