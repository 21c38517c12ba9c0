"""E7.6: Find the tool's tip by touching."""

from __future__ import annotations

import math

from tflab.core import Transform
from tflab.ros.messages import geometry_msgs
from tflab.workbook.tasks import Message, Task, Text, WrongStep

from .draws import tool_pose


def touches(rng):
    """Tips beyond the flange and beside it; flanges that are turned, and one that is not."""
    cases = []
    for _ in range(4):
        base_T_tool0 = tool_pose(rng)
        tip = [
            round(float(each), 3)
            for each in (rng.uniform(-0.05, 0.05), rng.uniform(0.02, 0.06), rng.uniform(0.08, 0.25))
        ]
        cases.append((base_T_tool0, tuple(round(each, 4) for each in base_T_tool0.apply(tip))))
    cases.append((Transform(translation=(0.4, 0.1, 0.3)), (0.4, 0.15, 0.45)))
    return cases


def touched(base_T_tool0, base_p_tip, *, inverse="turned round", axes="tool", sign="plus", ends="parent first", parent="tool0",
            rotation="none", stamp="kept"):  # fmt: skip
    """Return the message, step by step; other steps are the slips."""
    pose = base_T_tool0.inverse() if inverse == "turned round" else base_T_tool0
    place = pose.apply(base_p_tip)
    if inverse in ("translation negated", "step not turned back"):
        back = tuple(-each for each in base_T_tool0.translation)
        turn = base_T_tool0 if inverse == "translation negated" else base_T_tool0.inverse()
        place = Transform(back, turn.rotation).apply(base_p_tip)
    if inverse == "as it is":
        place = base_p_tip
    if axes != "tool":
        place = [tip - origin for tip, origin in zip(base_p_tip, base_T_tool0.translation, strict=True)]
    if axes == "turned on":
        place = Transform(rotation=base_T_tool0.rotation).apply(place)
    if axes == "step added":
        place = [a + b for a, b in zip(base_p_tip, base_T_tool0.inverse().translation, strict=True)]
    if axes == "flange":
        place = base_T_tool0.translation
    if axes == "length":
        place = (0.0, 0.0, math.dist(base_p_tip, base_T_tool0.translation))
    place = [-each for each in place] if sign == "minus" else list(place)
    names = {"tool0": ("tool0", "tcp"), "base": ("base_link", "tcp"), "tip": ("tool0", "tip")}[parent]
    names = names[::-1] if ends == "child first" else names
    turn = {"none": (0.0, 0.0, 0.0, 1.0), "zeros": (0.0, 0.0, 0.0, 0.0), "tool's": base_T_tool0.rotation,
            "back": base_T_tool0.inverse().rotation}[rotation]  # fmt: skip
    message = geometry_msgs.TransformStamped()
    message.header.frame_id, message.child_frame_id = names
    t, r = message.transform.translation, message.transform.rotation
    t.x, t.y, t.z = map(float, place)
    r.x, r.y, r.z, r.w = map(float, turn)
    message.header.stamp.sec = 1 if stamp == "set" else 0
    return message


def slip(name, at, en, ko, misconception=""):
    return WrongStep(name, at, Text(en=en, ko=ko), misconception)


SLIPS = (
    slip("no inverse", {"inverse": "not turned round"},
         "base_T_tool0 went in as it is: [base|tool0] takes points out of tool0. You want the tip in tool0, so it has to be turned round.",
         "base_T_tool0를 그대로 썼습니다. [base|tool0]는 tool0의 점을 꺼내는 변환입니다. tool0 기준이 필요하므로 뒤집어야 합니다.", "M1"),
    slip("translation negated", {"inverse": "translation negated"},
         "to invert base_T_tool0 only its translation was negated: the rotation was not turned back. An inverse turns back, and it turns the negated step, too.",
         "base_T_tool0를 뒤집으면서 이동의 부호만 바꾸었습니다. 회전을 되돌리지 않았습니다. 역변환은 회전을 되돌리고, 부호를 바꾼 이동도 함께 되돌립니다.", "M1"),
    slip("step not turned back", {"inverse": "step not turned back"},
         "the rotation was turned back, and the translation only negated. The step back is measured in tool0's axes: take the tip minus the flange first, and turn that back.",
         "회전은 되돌렸지만 이동은 부호만 바꾸었습니다. 되돌아가는 이동은 tool0의 축으로 잽니다. 먼저 끝점에서 플랜지를 빼고, 그것을 되돌리십시오.", "M3"),
    slip("tip in base", {"inverse": "as it is"},
         "those are the tip's numbers as seen from base_link. They are to be seen from tool0, in its axes.",
         "base_link에서 본 끝점의 숫자입니다. tool0에서 본 숫자를 tool0의 축으로 적으십시오."),
    slip("difference in base axes", {"axes": "base"},
         "that is the way from the flange to the tip in base_link's axes. tool0 is turned: turn it too.",
         "플랜지에서 끝까지의 이동을 base_link의 축으로 적었습니다. tool0는 돌아가 있으므로 함께 돌려야 합니다.", "M3"),
    slip("turned on", {"axes": "turned on"},
         "you turned the way from the flange to the tip onwards by tool0's rotation. It has to be turned back, into tool0's axes.",
         "플랜지에서 끝까지의 이동을 tool0의 회전만큼 더 돌렸습니다. tool0의 축으로 되돌려야 합니다.", "M1"),
    slip("the way back", {"sign": "minus"},
         "all signs are the other way: that leads from the tip to the flange.",
         "부호가 모두 반대입니다. 끝에서 플랜지로 가는 길입니다.", "M3"),
    slip("ends swapped", {"ends": "child first"},
         "parent and child are swapped: the arm would hang on its tool. What something hangs on is header.frame_id.",
         "부모와 자식이 바뀌었습니다. 팔이 공구에 매달린 셈입니다. 매달린 곳이 header.frame_id입니다.", "M2"),
    slip("parent base_link", {"parent": "base"},
         "you name base_link as the parent: such a tip stays behind as soon as the arm moves. It has to hang on tool0.",
         "부모를 base_link로 적었습니다. 그러면 팔이 움직일 때 끝점이 뒤에 남습니다. 끝점은 tool0에 매달려야 합니다.", "M12"),
    slip("another name", {"parent": "tip"},
         'the child is asked to be called "tcp".', '자식의 이름은 "tcp"여야 합니다.'),
    slip("zeros", {"rotation": "zeros"},
         "the rotation is all zeros, which every listener refuses. Not turned is w = 1.",
         "회전이 모두 0이라 모든 수신기가 거절합니다. 돌지 않은 것은 w = 1입니다.", "M5"),
    slip("the flange's rotation", {"rotation": "tool's"},
         "you gave the tip the flange's own rotation: it would be turned twice. Seen from tool0, tcp is not turned.",
         "끝점에 플랜지의 회전을 다시 주었습니다. 두 번 돌아갑니다. tool0에서 보면 tcp는 돌아가 있지 않습니다.", "M4"),
    slip("turned back", {"rotation": "back"},
         "you gave the tip the flange's rotation turned back: such a tcp would stand upright however the arm is held. Seen from tool0, it is not turned.",
         "끝점에 플랜지의 역회전을 주었습니다. 팔이 어떻게 있든 똑바로 서게 됩니다. tool0에서 보면 tcp는 돌아가 있지 않습니다."),
    slip("stamped", {"stamp": "set"},
         "you set the stamp; the task leaves it as it is.", "시각(stamp)을 바꾸었습니다. 문제에서는 그대로 둡니다."),
)  # fmt: skip


STEP_OF_THE_INVERSE_ADDED = WrongStep(
    "step of the inverse added",
    {"axes": "step added"},
    Text(
        en="you added the inverse's step and left out its turn: `.apply` does both.",
        ko="역변환의 이동만 더하고 회전을 빠뜨렸습니다. `.apply`는 둘 다 합니다.",
    ),
    "M3",
)


THE_FLANGE_ITSELF = WrongStep(
    "the flange itself",
    {"axes": "flange"},
    Text(
        en="that is where the flange is in base_link. Asked for is where the tip is in tool0.",
        ko="base_link에서 플랜지의 위치입니다. tool0에서 끝점의 위치가 필요합니다.",
    ),
)


LENGTH_ALONE = WrongStep(
    "length alone",
    {"axes": "length"},
    Text(
        en="that is how far the tip is from the flange, all of it along z. It also lies to the side: three numbers are needed.",
        ko="플랜지에서 끝점까지의 거리를 모두 z에 넣었습니다. 옆으로도 벗어나 있으므로 세 숫자가 필요합니다.",
    ),
)


TASK = Task(
    id="E7.6",
    kind="C",
    points=4,
    title=Text(en="Find the tool's tip by touching", ko="대어서 찾는 공구 끝"),
    answer="tcp_mount",
    form=Message(
        "geometry_msgs/msg/TransformStamped",
        ("header.frame_id", "child_frame_id", "transform.translation", "transform.rotation", "header.stamp"),
    ),
    inputs=touches,
    variants=3,
    model=touched,
    mistakes=(
        *SLIPS,
        STEP_OF_THE_INVERSE_ADDED,
        THE_FLANGE_ITSELF,
        LENGTH_ALONE,
    ),
    hints=(
        Text(
            en="The tip hangs on tool0. So where is it in tool0's own axes?",
            ko="끝점은 tool0에 매달려 있습니다. tool0의 축으로 보면 어디에 있습니까?",
        ),
        Text(
            en="tool0_p_tip = tool0_T_base @ base_p_tip, and you have base_T_tool0.",
            ko="tool0_p_tip = tool0_T_base @ base_p_tip이고, 주어진 것은 base_T_tool0입니다.",
        ),
        Text(
            en="base_T_tool0.inverse().apply(base_p_tip). The rotation stays (0, 0, 0, 1).",
            ko="base_T_tool0.inverse().apply(base_p_tip)입니다. 회전은 (0, 0, 0, 1) 그대로입니다.",
        ),
    ),
    misconceptions=("M1", "M2", "M3"),
)
