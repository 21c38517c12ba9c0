"""What several tasks of this chapter draw: patients, and what belongs to each cause."""

from __future__ import annotations

import hashlib
import json
import lzma
from functools import lru_cache
from pathlib import Path

from tflab.clinic.archive import Admission, patients
from tflab.clinic.causes import draw_numbers
from tflab.clinic.cures import CURES, PLASTERS
from tflab.clinic.patient import SickRobot
from tflab.clinic.proof import fitting
from tflab.clinic.table import COMPLAINTS, SUSPECTS
from tflab.clinic.trolley import TROLLEY
from tflab.workbook.tasks import Text

CAUSES = (*SUSPECTS, "sensor broken")
FRAMES = ("map", "odom", "base_footprint", "laser_frame", "all that move", "none")
OWNERS = (
    "localization",
    "wheel_odometry",
    "ekf_filter_node",
    "laser_mount",
    "laser_driver",
    "rviz",
    "network",
    "nobody",
)
FIXES = (*CURES, *PLASTERS)
TRIES = 8  # of drawing a patient again


STORED = Path(__file__).with_name("patients.json.xz")  # `make patients` writes it


def admitted(rng, groups):
    """Return a stored patient of one of the complaints in each group: to simulate one takes seconds."""
    drawn = []
    for complaints in groups:
        suspects = COMPLAINTS[complaints[int(rng.integers(len(complaints)))]].suspects
        drawn.append(stored_patient(rng, suspects[int(rng.integers(len(suspects)))]))
    return drawn


def stored_patient(rng, cause):
    """Return one of the stored patients that have a cause."""
    rows = _stored()["by cause"][cause]
    return SickRobot(*rows[int(rng.integers(len(rows)))])


def one_of_each(rng, made=None):
    """Return a patient of each cause, in any order, who all say the same.

    Args:
        made: returns the patients of some admissions; those of the public seed are stored, others are simulated.
    """
    made = made or made_or_stored
    causes = [SUSPECTS[place] for place in rng.permutation(len(SUSPECTS))]
    found = made([Admission((cause,), draw_numbers(rng), "") for cause in causes])
    for _ in range(TRIES):
        unclear = [place for place, patient in enumerate(found) if cause_of(patient) != causes[place]]
        if not unclear:
            return found
        others = made([Admission((causes[place],), draw_numbers(rng), "") for place in unclear])
        for place, patient in zip(unclear, others, strict=True):
            found[place] = patient
    unclear_causes = ", ".join(causes[place] for place in unclear)
    raise ValueError(f"after {TRIES} draws no patient's readings fit its cause alone: {unclear_causes}")


def made_or_stored(admissions):
    """Return the patients that these admissions make: stored ones, else simulated."""
    stored = _stored()["by admission"]
    names = [admission_name(admission) for admission in admissions]
    new = [admission for admission, name in zip(admissions, names, strict=True) if name not in stored]
    simulated = iter(patients(new))
    return [SickRobot(*stored[name]) if name in stored else next(simulated) for name in names]


def admission_name(admission):
    """Return the name under which a patient is stored."""
    return hashlib.sha256(repr(admission).encode()).hexdigest()[:16]


@lru_cache
def _stored():
    if not STORED.exists():  # `make patients` is about to write it
        return {"by cause": {}, "by admission": {}}
    return json.loads(lzma.decompress(STORED.read_bytes()))


def cause_of(patient):
    """Return the one suspect that all readings of a patient fit, None if there is none."""
    found = {key: check.kind(patient.reading(key)[2]) for key, check in TROLLEY.items()}
    patient.asked = ()
    return next(iter(fitting(found)), None)


def everything():
    return list(TROLLEY)


# What an option would mean: which check would show it.  Nothing of what is right.
MEANS = {
    "localizer not running": Text(
        en="Then `ros2 node list` would not hold /localization.",
        ko="그렇다면 `ros2 node list`에 /localization이 없어야 합니다.",
    ),
    "localizer waits for /clock": Text(
        en="Then the node is there, and `param get /localization use_sim_time` says True.",
        ko="그렇다면 노드는 있고, `param get /localization use_sim_time`이 True라고 합니다.",
    ),
    "Fixed Frame misspelt": Text(
        en="Then map stands in RViz's own list of frames, and the tree is whole.",
        ko="그렇다면 RViz의 좌표계 목록에 map이 있고 트리도 멀쩡합니다.",
    ),
    "odometry not running": Text(
        en="Then nothing at all comes on /odom: `topic hz /odom` tells.",
        ko="그렇다면 /odom에 아무것도 오지 않습니다. `topic hz /odom`으로 알 수 있습니다.",
    ),
    "parent misspelt": Text(
        en="Then a root stands in `view_frames` whose name is on no card.",
        ko="그렇다면 `view_frames`에 카드에 없는 이름의 루트가 있습니다.",
    ),
    "publish_tf off": Text(
        en="Then /odom comes as ever, and `param get /wheel_odometry publish_tf` says False.",
        ko="그렇다면 /odom은 그대로 오고, `param get /wheel_odometry publish_tf`가 False라고 합니다.",
    ),
    "two owners of one edge": Text(
        en="Then `tf2_echo odom base_footprint 20` goes to and fro, and the edge comes 50 times a second.",
        ko="그렇다면 `tf2_echo odom base_footprint 20`의 값이 오락가락하고, 연결이 1초에 50번 옵니다.",
    ),
    "localizer owns the base": Text(
        en="Then `tf2_echo map odom` finds no connection: somebody hung base_footprint elsewhere.",
        ko="그렇다면 `tf2_echo map odom`이 이어지지 않습니다. 누군가 base_footprint를 다른 곳에 달았습니다.",
    ),
    "nothing is wrong": Text(
        en="Then odom → base_footprint runs smoothly at 20 Hz of asking, and only map → odom steps.",
        ko="그렇다면 20 Hz로 물어도 odom → base_footprint가 매끄럽고, map → odom만 튑니다.",
    ),
    "mount wrong": Text(
        en="Then `tf2_echo base_link laser_frame` differs from the card.",
        ko="그렇다면 `tf2_echo base_link laser_frame`이 카드와 다릅니다.",
    ),
    "header says base_link": Text(
        en="Then the scan's own header says so: `topic echo /scan --once --field header`.",
        ko="그렇다면 스캔의 header에 그렇게 적혀 있습니다. `topic echo /scan --once --field header`로 봅니다.",
    ),
    "laser clock behind": Text(
        en="Then `topic delay /scan` is larger than on the card.",
        ko="그렇다면 `topic delay /scan`이 카드보다 큽니다.",
    ),
    "laser clock ahead": Text(
        en="Then `topic delay /scan` is below zero.",
        ko="그렇다면 `topic delay /scan`이 0보다 작습니다.",
    ),
    "transforms late": Text(
        en="Waiting would cure that one, and `topic delay /odom` would tremble far above the card.",
        ko="그렇다면 기다리면 낫습니다. `topic delay /odom`도 카드보다 훨씬 크고 들쭉날쭉합니다.",
    ),
    "odometry slow": Text(
        en="Then `topic hz /odom` is far below the card's 20.",
        ko="그렇다면 `topic hz /odom`이 카드의 20보다 훨씬 작습니다.",
    ),
    "quaternion of zeros": Text(
        en="Then every listener's log says TF_DENORMALIZED_QUATERNION, and /tf_static holds w: 0.0.",
        ko="그렇다면 수신기마다 로그에 TF_DENORMALIZED_QUATERNION이 나오고, /tf_static에 w: 0.0이 있습니다.",
    ),
    "header says another frame": Text(
        en="Then RViz names a frame that is on no card, and the tree is whole.",
        ko="그렇다면 RViz가 카드에 없는 좌표계 이름을 대고, 트리는 멀쩡합니다.",
    ),
    "mount volatile": Text(
        en="Then `topic info /tf_static --verbose` shows a publisher with VOLATILE.",
        ko="그렇다면 `topic info /tf_static --verbose`에 VOLATILE인 발행자가 있습니다.",
    ),
    "map": Text(
        en="map is at fault where somebody asked for it by a wrong name.",
        ko="map이 문제인 것은 누군가 그 이름을 틀리게 적었을 때입니다.",
    ),
    "odom": Text(
        en="odom is at fault where map → odom is missing, and every other edge is as on the card. Is it so here?",
        ko="odom이 문제인 것은 map → odom 연결만 없고 나머지 연결은 모두 카드와 같을 때입니다. 여기서도 그렇습니까?",
    ),
    "base_footprint": Text(
        en="That would be the edge odom → base_footprint. Is it the one that is not as on the card?",
        ko="odom → base_footprint 연결을 가리키는 답입니다. 카드와 다른 것이 그 연결입니까?",
    ),
    "laser_frame": Text(
        en="That would be the laser, its mount or its header. Which reading of them is not as on the card?",
        ko="레이저의 장착이나 header를 가리키는 답입니다. 그 가운데 카드와 다른 값은 무엇입니까?",
    ),
    "all that move": Text(
        en="Then every moving edge is late, not one. Compare the delays of two senders.",
        ko="그렇다면 움직이는 연결이 모두 늦습니다. 두 발행자의 지연을 견주어 보십시오.",
    ),
    "none": Text(
        en="Then all readings are as on the card. Are they?",
        ko="그렇다면 읽은 값이 모두 카드와 같아야 합니다. 그렇습니까?",
    ),
    "localization": Text(
        en="It owns map → odom. Is that the edge with the fault?",
        ko="map → odom의 발행자입니다. 문제가 있는 것이 그 연결입니까?",
    ),
    "wheel_odometry": Text(
        en="It owns odom → base_footprint on the card. Does it do what the card says?",
        ko="카드에서 odom → base_footprint의 발행자입니다. 카드대로 하고 있습니까?",
    ),
    "ekf_filter_node": Text(
        en="It is on no card. Does it run at all? `ros2 node list`.",
        ko="카드에 없는 노드입니다. 실행 중이기는 합니까? `ros2 node list`로 보십시오.",
    ),
    "laser_mount": Text(
        en="It owns base_link → laser_frame. Read its edge: value, w, durability.",
        ko="base_link → laser_frame의 발행자입니다. 그 연결의 값, w, durability를 읽어 보십시오.",
    ),
    "laser_driver": Text(
        en="It writes the scan's frame and stamp. Is either of the two not as on the card?",
        ko="스캔의 좌표계와 측정 시각을 적는 노드입니다. 둘 가운데 카드와 다른 것이 있습니까?",
    ),
    "rviz": Text(
        en="RViz only shows. It is at fault where what was typed into it names no frame.",
        ko="RViz는 보여 주기만 합니다. 입력한 이름의 좌표계가 없을 때만 RViz의 문제입니다.",
    ),
    "network": Text(
        en="A network delays more than one sender. Does another topic tremble, too?",
        ko="네트워크라면 여러 발행자가 함께 늦습니다. 다른 토픽도 들쭉날쭉합니까?",
    ),
    "nobody": Text(
        en="Then nobody has to change anything, and each reading is as on the card.",
        ko="그렇다면 아무도 고칠 것이 없고, 읽은 값이 모두 카드와 같습니다.",
    ),
}

FIX_MEANS = Text(
    en="That cures another suspect. Which reading would change after it, and is that the one that is not as on the card?",
    ko="다른 용의자를 고치는 방법입니다. 그렇게 하면 어느 값이 바뀌며, 카드와 다른 것이 그 값입니까?",
)
MEANS |= dict.fromkeys(CURES, FIX_MEANS)
