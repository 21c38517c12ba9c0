"""The real tf2 as a peer: reads one JSON command a line, answers with one JSON line.

Run by benchmarks/engine.py with the *system's* Python, where Debian's package
python3-tf2 (ROS 1 tf2 0.7.6: the same C++ core design behind a Python binding)
lives.  Needs nothing of tflab.
"""

import json
import sys
import time

import rospy
import tf2_py
from geometry_msgs.msg import TransformStamped


def message(parent, child, stamp_ns, translation, rotation):
    transform = TransformStamped()
    transform.header.stamp = rospy.Time(stamp_ns // 10**9, stamp_ns % 10**9)
    transform.header.frame_id, transform.child_frame_id = parent, child
    t, r = transform.transform.translation, transform.transform.rotation
    t.x, t.y, t.z = translation
    r.x, r.y, r.z, r.w = rotation
    return transform


def main():
    buffer, stamps, messages, target, source = None, [], [], "", ""
    for line in sys.stdin:
        command = json.loads(line)
        answer = {}
        if command["do"] == "fill":
            buffer = tf2_py.BufferCore(rospy.Duration(10**6))
            for parent, child, stamp_ns, translation, rotation in command["samples"]:
                buffer.set_transform(message(parent, child, stamp_ns, translation, rotation), "peer")
            target, source = command["target"], command["source"]
            stamps = [rospy.Time(ns // 10**9, ns % 10**9) for ns in command["stamps_ns"]]
        elif command["do"] == "lookup":
            lookup = buffer.lookup_transform_core
            begin = time.process_time()
            for stamp in stamps:
                lookup(target, source, stamp)
            answer["seconds"] = time.process_time() - begin
        elif command["do"] == "prepare":
            messages = [message(*sample) for sample in command["samples"]]
        elif command["do"] == "ingest":
            buffer = tf2_py.BufferCore(rospy.Duration(10))
            set_transform = buffer.set_transform
            begin = time.process_time()
            for transform in messages:
                set_transform(transform, "peer")
            answer["seconds"] = time.process_time() - begin
        print(json.dumps(answer), flush=True)


main()
