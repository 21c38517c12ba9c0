"""E12.7: A program that diagnoses."""

from __future__ import annotations

from tflab.clinic.fixes import DIAGNOSES
from tflab.workbook.tasks import Choice, Parts, Proof, define_task

from .draws import CAUSES, FRAMES, draw_one_of_each, everything

PARENTS = {"odom": "map", "base_footprint": "odom", "laser_frame": "base_link"}


def draw_patients(rng):
    """Draw one patient of each cause."""
    return [(patient,) for patient in draw_one_of_each(rng)]


def treat(
    patient,
    *,
    asks="what splits",
    map_lost="by nodes",
    robot_lost="by publish_tf",
    scan_lost="by the log",
    future="by rate",
    green="in turn",
    jumps="correction",
    fixed="a name",
    frame="by cause",
    named="map",
    late="all that move",
):
    """Return the verdict, step by step; other arguments are mistakes."""
    if asks == "everything":
        for check in everything():
            patient.ask(check)
    cause = _cause(patient, map_lost, robot_lost, scan_lost, future, green, jumps, fixed)
    if asks == "one more" and cause == "nothing is wrong":
        patient.ask("view_frames")
    its_own = DIAGNOSES[cause].frame if cause in DIAGNOSES else "laser_frame"
    its_own = {"Fixed Frame misspelt": named, "transforms late": late}.get(cause, its_own)
    if frame == "laser_frame for the future" and cause in ("transforms late", "odometry slow"):
        return patient.verdict(cause, "laser_frame")
    if frame == "the parent":
        return patient.verdict(cause, PARENTS.get(its_own, its_own))
    return patient.verdict(cause, frame if frame in FRAMES else its_own)


def _cause(patient, map_lost, robot_lost, scan_lost, future, green, jumps, fixed):
    screen = patient.ask("rviz")
    if "Fixed Frame" in screen:
        return _without_map(patient, screen, map_lost, fixed)
    if "no transform" in screen:
        return _without_robot(patient, screen, robot_lost)
    if "unknown" in screen:
        return _without_scan(patient, screen, scan_lost)
    if "future" in screen:
        if future in ("late", "ahead"):
            return "transforms late" if future == "late" else "laser clock ahead"
        hz, spread = patient.ask("hz /odom").split(" Hz, std dev ")
        if float(hz) < 10.0:
            return "odometry slow"
        return "transforms late" if future != "rate alone" and float(spread.split()[0]) > 0.02 else "laser clock ahead"
    return _all_green(patient, green, jumps)


def _without_scan(patient, screen, scan_lost):
    if scan_lost == "sensor":
        return "sensor broken"
    if "[laser_frame]" not in screen:
        return "header says another frame"
    if scan_lost in ("volatile", "zeros"):
        return "mount volatile" if scan_lost == "volatile" else "quaternion of zeros"
    log = patient.ask("echo base_link laser_frame")
    return "quaternion of zeros" if "DENORMALIZED" in log else "mount volatile"


def _without_map(patient, screen, map_lost, fixed):
    if "not listed" not in screen:
        return "Fixed Frame misspelt" if fixed == "a name" else "localizer not running"
    if map_lost in ("node down", "clock"):
        return "localizer not running" if map_lost == "node down" else "localizer waits for /clock"
    return "localizer waits for /clock" if "localization" in patient.ask("node list") else "localizer not running"


def _without_robot(patient, screen, robot_lost):
    if robot_lost == "node down":
        return "odometry not running"
    if "foreign" in screen:
        return "parent misspelt"
    value = patient.ask("publish_tf")
    if value == "True":
        return "localizer owns the base" if robot_lost == "by publish_tf" else "two owners of one edge"
    return "publish_tf off" if value == "False" else "odometry not running"


def _all_green(patient, green, jumps):
    if green == "all is well":
        return "nothing is wrong"
    if green != "no owners" and "ekf_filter_node" in patient.ask("node list"):
        return "two owners of one edge"
    if green != "no mount" and patient.ask("echo base_link laser_frame") != "0.200, 0.000, 0.150":
        return "mount wrong"
    if green not in ("no header", "neither") and patient.ask("scan header") == "base_link":
        return "header says base_link"
    if green not in ("no delay", "neither"):
        delay_s = float(patient.ask("delay /scan").split()[0])
        if delay_s > 0.2 and green != "delay misread":
            return "laser clock behind"
    return "nothing is wrong" if jumps == "correction" else "localizer owns the base"


TASK = define_task(
    __file__,
    kind="F",
    points=5,
    answer="triage",
    form=Parts({"cause": Choice(CAUSES), "frame": Choice(FRAMES), "proof": Proof(whole=True)}),
    inputs=draw_patients,
    variants=1,
    is_costly=True,
    model=treat,
)
