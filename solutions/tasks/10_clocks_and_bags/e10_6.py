"""E10.6: Can a bag's transforms place its own messages?"""

from __future__ import annotations

from tflab.core import StampedTransform, Transform, seconds
from tflab.ros.messages import geometry_msgs, std_msgs
from tflab.ros.tf2.buffer import Buffer
from tflab.ros.time import Duration, Time
from tflab.workbook.tasks import Choice, Number, Parts, define_task

KINDS = ("none", "LookupException", "ConnectivityException", "ExtrapolationException")


def edge(parent, child, *times_s):
    """Return one transform for each time [s], of a frame that moves and rotates; with none it is static."""
    poses = [Transform.from_rpy(yaw=0.4 + 0.3 * number, translation=(1.0 + number, 0.5, 0.1)) for number in range(3)]
    rows = zip(times_s or (0.0,), poses, strict=False)
    return [StampedTransform(parent, child, seconds(t), pose) for t, pose in rows]


def fill(*edges):
    buffer = Buffer(Duration(seconds=60))
    for stamped in (one for each in edges for one in each):
        buffer.core.set_transform(stamped, "bag", is_static=stamped.stamp_ns == 0)
    return buffer


def message(frame, time_s):
    header = std_msgs.Header(frame_id=frame, stamp=Time(nanoseconds=seconds(time_s)).to_msg())
    return geometry_msgs.PointStamped(header=header)


def draw_bags(rng):
    """Draw bags that are whole, begun late, without mounts, with two trees, with a lost frame, and in another order."""
    t = int(rng.integers(20, 40)) + 0.2

    def at(share):
        return round(t + 10.0 * share + float(rng.uniform(0.01, 0.4)), 3)

    wheels = edge("odom", "base_link", t, t + 5.0, t + 10.0)
    drive = edge("map", "odom", t, t + 5.0, t + 10.0), wheels
    laser, camera = edge("base_link", "laser_frame"), edge("mast", "camera_link")
    lamp = edge("base_link", "left/lamp")
    scans = [message("laser_frame", at(share)) for share in (0.1, 0.3, 0.5, 0.7, 0.9)]
    barely = message("laser_frame", t + 10.05)  # in the same whole second as what can be placed
    soon = message("laser_frame", t + 9.85)  # its nanosec has lost a zero
    early, late, seen = (
        message("laser_frame", t - 0.3),
        message("laser_frame", t + 11.5),
        message("camera_link", at(0.4)),
    )
    lost = message("lazer_frame", at(0.2))
    return [
        (fill(*drive, laser), [*scans, soon], "map"),
        (fill(*drive, laser), [early, *scans, late], "map"),
        (fill(*drive), scans[:3], "map"),
        (fill(*drive, laser, camera), [scans[0], seen, scans[1], barely, late, lost, scans[2]], "map"),
        (fill(*drive, laser), [lost, early, *scans[:2]], "odom"),
        (fill(edge("map", "odom", t + 6.0, t + 9.0), wheels, laser), [*scans, late], "odom"),  # map begins late
        (fill(*drive, laser, lamp), [*scans, *scans[:3], message("left/lamp", at(0.6)), lost], "map"),
        (fill(*drive, laser, camera), [*scans[:2], late, seen, lost], "base_link"),
        (fill(*drive, laser, camera), [scans[0], seen, lost, scans[3], late], "map"),  # by stamp it is the second
        (fill(*drive, laser), [], "map"),
    ]


def place_messages(buffer, messages, target, ask="the stamp", stops=False, which="first", kind="its own",
            frame="each", into="target", count="placed", ends="target first", x="last"):  # fmt: skip
    """Return what the bag can transform, step by step; other arguments are mistakes."""
    places, noes, frames, placed = [], [], set(), 0
    in_order = sorted(messages, key=lambda each: (each.header.stamp.sec, each.header.stamp.nanosec))
    for each in in_order if which == "by stamp" else messages:
        source = {
            "the first's": messages[0].header.frame_id,
            "base_link": "base_link",
            "laser_frame": "laser_frame",
        }.get(frame, each.header.frame_id)
        try:
            when = _lookup_time(ask, messages[0].header.stamp if ask == "the first's" else each.header.stamp)
            names = ("map" if into == "map" else target, source)
            names = names[::-1] if ends == "swapped" else names
            places.append(buffer.lookup_transform(*names, when).transform.translation.x)
        except Exception as error:
            noes.append(_name_of(type(error).__name__, kind))
            placed += count == "or the latest" and buffer.can_transform(target, source, Time())
            if stops:
                break
        else:
            placed += 1
            frames.add(source)
    told = {"last": noes[-1:], "most": noes and [max(noes, key=noes.count)]}.get(which, noes)
    no = told[0] if told else "none"
    share = placed / max(1, len(messages))
    counted = {"noes": len(messages) - placed, "all": len(messages), "share": share, "frames": len(frames)}.get(
        count, placed
    )
    x_m = (places or [0.0])[0 if x == "first" else -1]
    return {"placed": counted, "last_x_m": x_m, "first_no": no}


def _lookup_time(ask, stamp):
    """Return the time of the lookup."""
    return {
        "the latest": lambda: Time(),
        "whole seconds": lambda: Time(seconds=stamp.sec),
        "nanosec alone": lambda: Time(nanoseconds=stamp.nanosec),
        "decimals": lambda: Time(seconds=float(f"{stamp.sec}.{stamp.nanosec}")),
    }.get(ask, lambda: Time.from_msg(stamp))()


def _name_of(name, kind):
    """Return the name of an exception."""
    as_another = {
        "its own": {},
        "lookup as connectivity": {"LookupException": "ConnectivityException"},
        "extrapolation as lookup": {"ExtrapolationException": "LookupException"},
    }
    return as_another[kind].get(name, name) if kind in as_another else kind


TASK = define_task(
    __file__,
    kind="F",
    points=4,
    answer="placeable",
    form=Parts({"placed": Number(tolerance=0.0), "last_x_m": Number("m"), "first_no": Choice(KINDS)}),
    inputs=draw_bags,
    variants=3,
    model=place_messages,
)
