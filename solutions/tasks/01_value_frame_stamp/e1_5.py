"""E1.5: Whose numbers change?"""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Task, Text, WrongAnswer

FRAMES = ("map", "base_link", "laser_frame")
RIGHT = {
    **{f"ball in {frame}": "stays" if frame == "map" else "changes" for frame in FRAMES},
    **{f"cup in {frame}": "changes" if frame == "map" else "stays" for frame in FRAMES},
    **{f"lamp in {frame}": "changes" for frame in FRAMES},
}


def but(**changes):
    return {**RIGHT, **{name.replace("_in_", " in "): said for name, said in changes.items()}}


WHAT_RESTS_KEEPS = WrongAnswer(
    "what rests keeps its numbers",
    but(ball_in_base_link="stays", ball_in_laser_frame="stays"),
    Text(
        en="The ball rests in the room. Seen from the robot, which drives, it comes nearer each moment.",
        ko="공은 방 안에서 가만히 있습니다. 달리는 로봇에서 보면 점점 가까워집니다.",
    ),
)

WHAT_IS_MEASURED_CHANGES = WrongAnswer(
    "what is measured always changes",
    but(cup_in_base_link="changes", cup_in_laser_frame="changes"),
    Text(
        en="The cup drives along. Seen from the robot, and from everything bolted to it, it stays where it is.",
        ko="컵은 로봇과 함께 달립니다. 로봇에서 보든, 로봇에 달린 것에서 보든 늘 같은 자리에 있습니다.",
    ),
)

THE_CUP_STANDS_STILL = WrongAnswer(
    "the cup stands still",
    but(cup_in_map="stays"),
    Text(
        en="The cup stands still on the tray, but the tray drives through the room.",
        ko="컵은 쟁반 위에 가만히 있지만, 쟁반은 방 안을 달립니다.",
    ),
)

EVERYTHING_IN_THE_ROBOT_STAYS = WrongAnswer(
    "everything in the robot stays",
    but(ball_in_base_link="stays", ball_in_laser_frame="stays", lamp_in_base_link="stays", lamp_in_laser_frame="stays"),
    Text(
        en="base_link is not the frame in which everything rests, but the one that drives. What is not on board changes in it.",
        ko="base_link는 모든 것이 가만히 있는 좌표계가 아니라 달리는 좌표계입니다. 실려 있지 않은 것의 숫자는 바뀝니다.",
    ),
)

EVERYTHING_ON_THE_MAP_STAYS = WrongAnswer(
    "everything on the map stays",
    but(cup_in_map="stays", lamp_in_map="stays"),
    Text(
        en="The map stands still, but not everything on it does.",
        ko="지도는 가만히 있지만 지도 위의 모든 것이 가만히 있지는 않습니다.",
    ),
)

TWO_DRIVES_CANCEL = WrongAnswer(
    "two drives cancel",
    but(lamp_in_base_link="stays", lamp_in_laser_frame="stays"),
    Text(
        en="The lamp drives too, but the other way: from your robot it moves faster than the ball does.",
        ko="전등도 달리지만 반대쪽으로 달립니다. 로봇에서 보면 공보다 더 빨리 움직입니다.",
    ),
)

A_LASER_IS_NO_ROBOT = WrongAnswer(
    "a laser is no robot",
    but(cup_in_laser_frame="changes"),
    Text(
        en="The laser is bolted to the robot, and the cup rides on it: between the two nothing moves.",
        ko="레이저는 로봇에 고정되어 있고 컵도 로봇에 실려 있습니다. 둘 사이에서는 아무것도 움직이지 않습니다.",
    ),
)


DRIVES_TOWARDS = Text(
    en="The ball lies on the floor, and this frame drives. Straight ahead it may stay; how far ahead, its x, gets less with every metre.",
    ko="공은 바닥에 가만히 있고 이 좌표계는 달립니다. 계속 정면에 있더라도, 얼마나 앞인지를 말하는 x는 달릴수록 줄어듭니다.",
)
RIDES_ALONG = Text(
    en="The cup rides on the robot, and so does this frame: between the two nothing moves.",
    ko="컵은 로봇에 실려 가고 이 좌표계도 함께 갑니다. 둘 사이에서는 아무것도 움직이지 않습니다.",
)
DRIVES_APART = Text(
    en="The lamp drives one way and this frame the other: how far apart they are changes from moment to moment.",
    ko="전등과 이 좌표계는 서로 반대쪽으로 달립니다. 둘 사이의 거리는 순간마다 달라집니다.",
)
SHOWS = {
    "ball in map": Text(
        en="The ball lies on the floor, and map stands still as the floor does.",
        ko="공은 바닥에 가만히 있고, map도 바닥처럼 움직이지 않습니다.",
    ),
    "ball in base_link": DRIVES_TOWARDS,
    "ball in laser_frame": DRIVES_TOWARDS,
    "cup in map": Text(
        en="The cup rides on the robot, and the robot drives across the map.",
        ko="컵은 로봇에 실려 가고, 로봇은 지도 위를 달립니다.",
    ),
    "cup in base_link": RIDES_ALONG,
    "cup in laser_frame": RIDES_ALONG,
    "lamp in map": Text(
        en="The lamp is carried by a robot that drives across the map.",
        ko="전등은 지도 위를 달리는 로봇이 들고 있습니다.",
    ),
    "lamp in base_link": DRIVES_APART,
    "lamp in laser_frame": DRIVES_APART,
}


TASK = Task(
    id="E1.5",
    kind="M",
    points=3,
    title=Text(en="Whose numbers change?", ko="누구의 숫자가 바뀝니까?"),
    answer="numbers",
    form=Parts({name: Choice(("stays", "changes")) for name in RIGHT}),
    mistakes=(
        WHAT_RESTS_KEEPS,
        WHAT_IS_MEASURED_CHANGES,
        THE_CUP_STANDS_STILL,
        EVERYTHING_IN_THE_ROBOT_STAYS,
        EVERYTHING_ON_THE_MAP_STAYS,
        TWO_DRIVES_CANCEL,
        A_LASER_IS_NO_ROBOT,
    ),
    shows=SHOWS,
    hints=(
        Text(
            en="Sit down in each frame in turn, and look at the thing.",
            ko="좌표계에 하나씩 앉아서 물체를 바라본다고 생각해 보세요.",
        ),
        Text(
            en="A thing keeps its numbers in a frame that moves with it.",
            ko="물체와 함께 움직이는 좌표계에서는 숫자가 그대로입니다.",
        ),
        Text(
            en="The laser is bolted to the robot: what holds for base_link holds for it.",
            ko="레이저는 로봇에 고정되어 있습니다. base_link에서 그런 것은 레이저에서도 그렇습니다.",
        ),
    ),
)
