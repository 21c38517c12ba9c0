"""E12.1: Which node publishes what."""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, define_task

NODES = ("amcl", "slam_toolbox", "wheel_odometry", "ekf_filter_node", "lidar_driver", "joint_driver",
         "robot_state_publisher", "nobody")  # fmt: skip
EDGES = ("map -> odom", "odom -> base_footprint", "base_footprint -> base_link", "base_link -> laser_frame",
         "wrist -> tool0")  # fmt: skip
SWITCHES = ("amcl tf_broadcast", "slam_toolbox publishes", "wheel_odometry enable_odom_tf", "ekf publish_tf",
            "lidar_driver publish_tf")  # fmt: skip
LOCALIZERS = {"a map is there": "amcl", "the map is being made": "slam_toolbox", "no map at all": "nobody"}

FINDERS = (
    ("amcl", "slam_toolbox", "nobody"), ("slam_toolbox", "amcl", "nobody"), ("nobody", "amcl", "slam_toolbox"),
)  # fmt: skip


def draw_robot(rng):
    """Draw the robot's purpose, and whether odometry and IMU are fused."""
    return {
        "map_frame": str(rng.choice(list(LOCALIZERS))),
        "odometry": str(rng.choice(["wheels alone", "wheels and imu, fused by ekf_filter_node"])),
    }


def assign_owners(given, *, finder="by the map", odom="one", localizer="its edge", switches="as needed", lidar="quiet",
           arm="by the drawing"):  # fmt: skip
    """Return the owner of each edge and every switch, step by step; other arguments are mistakes."""
    right = list(LOCALIZERS).index(given.map_frame)
    finder = FINDERS[right][("by the map", "the other", "the third").index(finder)]
    fused = "ekf" in given.odometry
    wheels = "ekf_filter_node" if fused else "wheel_odometry"
    answers = {
        "map -> odom": finder,
        "odom -> base_footprint": wheels,
        "base_footprint -> base_link": "robot_state_publisher",
        "base_link -> laser_frame": "robot_state_publisher",
        "wrist -> tool0": "robot_state_publisher",
        "amcl tf_broadcast": finder == "amcl",
        "slam_toolbox publishes": finder == "slam_toolbox",
        "wheel_odometry enable_odom_tf": not fused,
        "ekf publish_tf": fused,
        "lidar_driver publish_tf": False,
    }
    if odom == "both":
        answers |= {"wheel_odometry enable_odom_tf": True, "ekf publish_tf": True}
    elif odom in ("the other", "switches exchanged"):
        answers |= {"wheel_odometry enable_odom_tf": fused, "ekf publish_tf": not fused}
        if odom == "the other":
            answers["odom -> base_footprint"] = "wheel_odometry" if fused else "ekf_filter_node"
    if localizer == "the base":
        answers["odom -> base_footprint"] = "amcl" if finder == "nobody" else finder
    if switches == "all off":
        answers |= dict.fromkeys(SWITCHES, False)
    elif switches == "both localizers on":
        answers |= dict.fromkeys(SWITCHES[:2], True)
    if lidar == "switched on":
        answers |= {"lidar_driver publish_tf": True}
    if lidar == "repeats":
        answers |= {"lidar_driver publish_tf": True, "base_link -> laser_frame": "lidar_driver"}
    if arm == "by the driver":
        answers["wrist -> tool0"] = "joint_driver"
    return answers


TASK = define_task(
    __file__,
    kind="O",
    points=4,
    answer="owners",
    form=Parts(
        {**{edge: Choice(NODES) for edge in EDGES}, **{switch: Choice(("True", "False")) for switch in SWITCHES}}
    ),
    given=draw_robot,
    variants=6,
    model=assign_owners,
)
