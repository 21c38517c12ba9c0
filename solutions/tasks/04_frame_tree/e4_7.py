"""E4.7: The line that the dog needed."""

from __future__ import annotations

from tflab.workbook.tasks import Name, define_task

FRAMES = ("base_link", "laser_frame", "camera_link", "tool0", "imu_link")
ROBOTS = ("robot1", "spot", "tb3_0", "red", "alpha")


def draw_names(rng):
    """Draw every spelling of a prefix with every spelling of a frame, map and odom among them."""
    rows = []
    for first in ("odom", FRAMES[int(rng.integers(len(FRAMES)))]):
        robot = ROBOTS[int(rng.integers(len(ROBOTS)))]
        second = [frame for frame in FRAMES if frame != first][int(rng.integers(len(FRAMES) - 1))]
        for prefix in ("", "/", robot, f"{robot}/", f"/{robot}", f"/{robot}/"):
            rows += [(prefix, first), (prefix, f"/{second}"), (prefix, "map")]
        rows += [(robot, "/map"), (f"fleet/{robot}", first), (robot, "map_server_frame"), (f"/{robot}/", "odom")]
        rows += [("", "/map"), (robot, "odom"), (robot, f"arm/{second}"), (robot.capitalize(), first)]
        rows += [("r", first), (robot, "world"), (robot, "my_map"), (robot, "Map"), (f"//{robot}//", first)]
        rows += [(second.partition("_")[0], second), ("arm", f"arm/{second}")]  # a frame that begins like the prefix
    return rows


def join_name(prefix, name, *, ends="stripped", inner="stripped", glue="/", empty="bare", shared="map alone",
           first="the prefix", slash="between", letters="as they are"):  # fmt: skip
    """Return the full name, step by step; other arguments are mistakes."""
    came, was_empty = name, not prefix
    if ends == "all removed":
        prefix = prefix.replace("/", "")
    elif ends == "left only":
        prefix = prefix.lstrip("/")
    elif ends == "right only":
        prefix = prefix.rstrip("/")
    elif ends == "stripped":
        prefix = prefix.strip("/")
    name = name.strip("/") if inner != "as it is" else name
    name = name.rpartition("/")[2] if inner == "last word" else name
    name = name.replace("/", "") if inner == "all removed" else name
    if letters == "small":
        prefix, name = prefix.lower(), name.lower()
    is_shared = {
        "map alone": name == "map",
        "nothing": False,
        "begins with": name.startswith("map"),
        "odom too": name in ("map", "odom"),
        "as it came": came == "map",
        "a slash in front": name == "map" or came.startswith("/"),
        "a slash inside": name == "map" or "/" in name,
    }[shared]
    is_bare = {"bare": not prefix, "asked first": was_empty, "glued": False}[empty]
    if is_shared or is_bare:
        return name
    whole = f"{name}{glue}{prefix}" if first == "the name" else f"{prefix}{glue}{name}"
    return {"in front": f"/{whole}", "behind": f"{whole}/"}.get(slash, whole)


ANSWERS = {
    "never a prefix": lambda prefix, name: name.strip("/"),
    "glued as they are": lambda prefix, name: prefix + name,
    "a slash between, always": lambda prefix, name: f"{prefix}/{name}",
    "only the empty prefix": lambda prefix, name: f"{prefix}/{name}" if prefix else name,
    "only the prefix cleaned": lambda prefix, name: f"{prefix.strip('/')}/{name}",
    "a slash in front, always": lambda prefix, name: (
        "/" + "/".join(part for part in (prefix.strip("/"), name.strip("/")) if part)
    ),
    "doubled slashes alone": lambda prefix, name: f"{prefix}/{name}".replace("//", "/"),
    "joined as paths": lambda prefix, name: name if name.startswith("/") else f"{prefix.rstrip('/')}/{name}",
    "cleaned at the end": lambda prefix, name: (
        name.strip("/") if name.strip("/") == "map" else f"{prefix}/{name}".strip("/")
    ),
}

TASK = define_task(
    __file__,
    kind="F",
    points=2,
    answer="frame_name",
    form=Name(),
    inputs=draw_names,
    variants=3,
    model=join_name,
    answers=ANSWERS,
)
