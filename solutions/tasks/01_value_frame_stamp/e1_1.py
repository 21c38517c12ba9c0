"""E1.1: One place, three triples."""

from __future__ import annotations

from tflab.workbook.tasks import Parts, Task, Twin, Vector, Words


def robot_and_post(rng):
    return {
        "map_p_base": [round(float(rng.uniform(low, high)), 2) for low, high in ((3, 8), (-3, -1), (0.05, 0.12))],
        "base_p_laser": [
            round(float(rng.uniform(low, high)), 2) for low, high in ((0.15, 0.3), (0.05, 0.12), (0.14, 0.3))
        ],
        "laser_p_post": [round(float(rng.uniform(low, high)), 2) for low, high in ((1.5, 4), (0.4, 1.2), (0.33, 0.6))],
    }


def plus(*points):
    return [sum(numbers) for numbers in zip(*points, strict=True)]


def minus(one, other):
    return [a - b for a, b in zip(one, other, strict=True)]


def answer(base, map_):
    return {"base_link": base, "map": map_}


SAME_NUMBERS = Twin(
    "same numbers",
    lambda g: answer(g.laser_p_post, g.laser_p_post),
    Words(
        en="These are the laser's numbers with other labels. A frame is not a name to be changed: count the way from each frame's own origin.",
        ko="레이저의 숫자에 이름표만 바꾸어 달았습니다. 좌표계는 이름만 바꾼다고 바뀌지 않습니다. 각 좌표계의 원점에서부터 다시 세어 보세요.",
    ),
)


def taken_away(g):
    base = minus(g.laser_p_post, g.base_p_laser)
    return answer(base, minus(base, g.map_p_base))


TAKEN_AWAY = Twin(
    "taken away",
    taken_away,
    Words(
        en="You took the steps away. The laser sits ahead of the robot's middle, so from the middle the way to the post is that much longer: the steps add.",
        ko="이동을 뺐습니다. 레이저는 로봇의 중심보다 앞에 있으므로, 중심에서 기둥까지는 그만큼 더 멉니다. 이동은 더합니다.",
    ),
    "M3",
)


MOUNT_TAKEN_AWAY = Twin(
    "mount taken away",
    lambda g: answer(minus(g.laser_p_post, g.base_p_laser), plus(g.map_p_base, minus(g.laser_p_post, g.base_p_laser))),
    Words(
        en="The laser's mount has the wrong sign. It sits ahead of and above the middle: from there the post is farther ahead and higher, not less.",
        ko="레이저 장착 위치의 부호가 틀렸습니다. 레이저는 중심보다 앞쪽 위에 있습니다. 중심에서 보면 기둥은 더 앞에, 더 높이 있습니다.",
    ),
    "M3",
)


MOUNT_SKIPPED = Twin(
    "mount skipped",
    lambda g: answer(g.laser_p_post, plus(g.map_p_base, g.laser_p_post)),
    Words(
        en="You left the mount out, as if the laser sat in the robot's middle. From the laser to the map there are two steps.",
        ko="레이저가 로봇의 중심에 있는 것처럼 장착 위치를 빠뜨렸습니다. 레이저에서 지도까지는 이동이 두 번입니다.",
    ),
)


MOUNT_SKIPPED_ON_THE_MAP = Twin(
    "mount skipped on the map",
    lambda g: answer(plus(g.base_p_laser, g.laser_p_post), plus(g.map_p_base, g.laser_p_post)),
    Words(
        en="base_link is right. For the map you went on from the laser's numbers: start from where you have just arrived, in base_link.",
        ko="base_link는 맞습니다. 지도로 갈 때는 레이저의 숫자에서 다시 시작했습니다. 방금 구한 base_link 기준 값에서 이어 가 보세요.",
    ),
)


MOUNT_TWICE = Twin(
    "mount twice",
    lambda g: answer(
        plus(g.base_p_laser, g.laser_p_post), plus(g.map_p_base, g.base_p_laser, g.base_p_laser, g.laser_p_post)
    ),
    Words(
        en="On the map the mount is counted twice. It is already in your numbers of base_link.",
        ko="지도에서 장착 위치를 두 번 셌습니다. base_link 기준 값에 이미 들어 있습니다.",
    ),
)


def flat(g):
    base = [*plus(g.base_p_laser, g.laser_p_post)[:2], g.laser_p_post[2]]
    return answer(base, [*plus(g.map_p_base, base)[:2], g.laser_p_post[2]])


HEIGHT_FORGOTTEN = Twin(
    "height forgotten",
    flat,
    Words(
        en="x and y are right; the heights are still the laser's. z adds like the others.",
        ko="x와 y는 맞지만 높이는 아직 레이저 기준입니다. z도 똑같이 더합니다.",
    ),
)


NOT_ON_THE_MAP = Twin(
    "not on the map",
    lambda g: answer(plus(g.base_p_laser, g.laser_p_post), plus(g.base_p_laser, g.laser_p_post)),
    Words(
        en="base_link is right, and you wrote the same for the map. The robot does not stand in the map's corner.",
        ko="base_link는 맞지만 map에도 같은 값을 썼습니다. 로봇은 지도 원점에 서 있지 않습니다.",
    ),
)


TASK = Task(
    id="E1.1",
    kind="N",
    points=4,
    title=Words(en="One place, three triples", ko="한 위치, 세 가지 숫자"),
    answer="post",
    form=Parts({frame: Vector(3, unit="m", frame=frame, tolerance=0.003) for frame in ("base_link", "map")}),
    given=robot_and_post,
    variants=6,
    twins=(
        SAME_NUMBERS,
        TAKEN_AWAY,
        MOUNT_TAKEN_AWAY,
        MOUNT_SKIPPED,
        MOUNT_SKIPPED_ON_THE_MAP,
        MOUNT_TWICE,
        HEIGHT_FORGOTTEN,
        NOT_ON_THE_MAP,
    ),
    hints=(
        Words(
            en="Draw the robot from the side, and the laser on it.",
            ko="로봇을 옆에서 본 모습과 그 위의 레이저를 그려 보세요.",
        ),
        Words(
            en="Stand in base_link: first walk to the laser, then go on to the post.",
            ko="base_link에 서 있다고 생각해 보세요. 먼저 레이저까지 가고, 거기서 기둥까지 더 갑니다.",
        ),
        Words(
            en="While nobody is turned, add part by part: base = mount + laser's numbers, map = robot's place + base.",
            ko="아무것도 돌아 있지 않으면 성분끼리 더합니다. base = 장착 위치 + 레이저의 숫자, map = 로봇의 위치 + base입니다.",
        ),
    ),
    cures=("M3",),
)
