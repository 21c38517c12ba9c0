"""E7.1: Two joints to finish."""

from __future__ import annotations

import math

from tflab.workbook.tasks import Task, Text, Urdf, WrongStep

from .draws import centimetres

OPTICAL = (-math.pi / 2, 0.0, -math.pi / 2)


def a_head(rng):
    """All measures differ, and none is a round turn."""
    ahead = centimetres(rng, 8, 25)
    right = centimetres(rng, 4, 15, (ahead,))
    up = centimetres(rng, 30, 60, (ahead, right))
    return {
        "ahead_cm": ahead,
        "to_its_right_cm": right,
        "up_cm": up,
        "turned_to_the_right_deg": int(rng.integers(20, 70)),
        "lens_ahead_cm": centimetres(rng, 1, 4),
    }


def origin(xyz, rpy):
    return f'<origin xyz="{" ".join(map(repr, xyz))}" rpy="{" ".join(map(repr, rpy))}"/>'


def finished(g, *, place="joint", ends="parent first", name="nod_joint", kind="revolute", length="m", side="right", order="x y z",
             angle="rad", way="right", about="its own", turns="once", hangs="camera_link", lens_length="m", lens="ahead",
             optical="turned"):  # fmt: skip
    """Return the two joints, step by step; other steps are the slips."""
    scale = {"m": 0.01, "cm": 1.0, "mm": 10.0}[length]
    ahead, left, up = g.ahead_cm, -g.to_its_right_cm if side == "right" else g.to_its_right_cm, g.up_cm
    xyz = {"x y z": (ahead, left, up), "y first": (left, ahead, up), "z first": (up, left, ahead)}.get(order)
    yaw = g.turned_to_the_right_deg if angle == "deg" else math.radians(g.turned_to_the_right_deg)
    yaw = yaw if way == "left" else -yaw
    if order == "turned":
        xyz = (ahead * math.cos(yaw) - left * math.sin(yaw), ahead * math.sin(yaw) + left * math.cos(yaw), up)
    if lens == "in the head":
        xyz = (xyz[0] + g.lens_ahead_cm, *xyz[1:])
    rpy = {"once": (0.0, 0.0, yaw), "twice": (OPTICAL[0], 0.0, OPTICAL[2] + yaw), "none": (0.0, 0.0, 0.0),
           "roll": (yaw, 0.0, 0.0), "pitch": (0.0, yaw, 0.0), "at the lens": (0.0, 0.0, 0.0)}[turns]  # fmt: skip
    axes = {
        "its own": (0, 1, 0), "parent": (-math.sin(yaw), math.cos(yaw), 0), "z": (0, 0, 1), "x": (1, 0, 0), "upwards": (0, -1, 0),
    }  # fmt: skip
    lens_m = {"m": 0.01, "cm": 1.0, "mm": 10.0}[lens_length] * g.lens_ahead_cm
    lens_xyz = {
        "ahead": (lens_m, 0.0, 0.0),
        "z": (0.0, 0.0, lens_m),
        "y": (0.0, lens_m, 0.0),
        "behind": (-lens_m, 0.0, 0.0),
    }.get(lens, (0.0, 0.0, 0.0))
    turned = {
        "turned": OPTICAL,
        "not": (0.0, 0.0, 0.0),
        "back": (math.pi / 2, -math.pi / 2, 0.0),
        "deg": (-90.0, 0.0, -90.0),
        "plus": (math.pi / 2, 0.0, math.pi / 2),
        "yaw plus": (OPTICAL[0], 0.0, math.pi / 2),
        "roll plus": (math.pi / 2, 0.0, OPTICAL[2]),
        "roll": (OPTICAL[0], 0.0, 0.0),
        "yaw": (0.0, 0.0, OPTICAL[2]),
        "pitch": (0.0, OPTICAL[0], OPTICAL[2]),
        "pitch alone": (0.0, math.pi / 2, 0.0),
        "pitch up alone": (0.0, -math.pi / 2, 0.0),
    }
    quarter = {"to tenths": 1.5, "to tens of degrees": 1.6}.get(optical)
    turn = (-quarter, 0.0, -quarter) if quarter else turned[optical]
    turn = (turn[0], turn[1], turn[2] + yaw) if turns == "at the lens" else turn
    first, second = origin([scale * each for each in xyz], rpy), origin(lens_xyz, turn)
    painted = "" if place == "joint" else "<geometry><sphere radius='0.01'/></geometry>"
    parent, child = ("camera_link", "base_link") if ends == "child first" else ("base_link", "camera_link")
    visual = f'<link name="camera_link"><visual>{first}{painted}</visual></link>' if painted else ""
    return f"""
{visual}
<joint name="{name}" type="{kind}">
  <parent link="{parent}"/> <child link="{child}"/>
  {"" if painted else first}
  <axis xyz="{" ".join(map(repr, axes[about]))}"/>
</joint>
<joint name="optical_joint" type="fixed">
  <parent link="{hangs}"/> <child link="camera_optical_frame"/>
  {second}
</joint>"""


def slip(name, at, en, ko, misconception=""):
    return WrongStep(name, at, Text(en=en, ko=ko), misconception)


SLIPS = (
    slip("only the paint", {"place": "visual"},
         "nod_joint has no origin: your numbers stand in a <visual>, which moves the paint on the link and nothing else.",
         "nod_joint에 origin이 없습니다. 숫자가 <visual>에 있어, 링크의 겉모습만 옮기고 다른 것은 옮기지 않습니다."),
    slip("ends swapped", {"ends": "child first"},
         "nod_joint has its ends swapped: this robot is bolted onto its camera, and camera_link is the root. The parent is what it hangs on.",
         "nod_joint의 부모와 자식이 바뀌었습니다. 로봇을 카메라에 달아 camera_link가 루트가 되었습니다. 매달린 곳이 부모입니다.", "M2"),
    slip("turned at the lens", {"turns": "at the lens"},
         "nod_joint is not turned, and optical_joint has your turn as well as its quarters. The whole head is turned, with the axis that it nods about: your turn belongs to nod_joint.",
         "nod_joint는 돌아 있지 않고, 대신 optical_joint에 사분의 일 회전과 함께 그 회전이 들어 있습니다. 끄덕이는 축까지 머리 전체가 돌아 있으므로 그 회전은 nod_joint에 써야 합니다."),
    slip("quarter to tenths", {"optical": "to tenths"},
         "a quarter turn is written as 1.5 in optical_joint: the picture is askew by four degrees. It is π/2, 1.5708.",
         "optical_joint에서 사분의 일 회전을 1.5로 썼습니다. 영상이 4도 기울어집니다. π/2, 곧 1.5708입니다."),
    slip("quarter to tenths, up", {"optical": "to tens of degrees"},
         "a quarter turn is written as 1.6 in optical_joint: the picture is askew by two degrees. It is π/2, 1.5708.",
         "optical_joint에서 사분의 일 회전을 1.6으로 썼습니다. 영상이 2도 기울어집니다. π/2, 곧 1.5708입니다."),
    slip("fixed", {"kind": "fixed"},
         "nod_joint is fixed: this camera never nods, whatever its motor does.",
         "nod_joint가 fixed입니다. 모터가 돌아도 카메라가 움직이지 않습니다.", "M12"),
    slip("slides", {"kind": "prismatic"},
         "nod_joint is prismatic: this camera slides along its axis. A joint that turns is revolute.",
         "nod_joint가 prismatic입니다. 축을 따라 미끄러집니다. 도는 관절은 revolute입니다."),
    slip("centimetres", {"length": "cm", "lens_length": "cm"},
         "your lengths are in centimetres. A URDF counts in metres: this camera is wide of the robot by a house.",
         "길이를 센티미터로 썼습니다. URDF는 미터를 씁니다. 카메라가 로봇에서 집 한 채만큼 떨어져 있습니다."),
    slip("millimetres", {"length": "mm", "lens_length": "mm"},
         "your lengths are ten times the centimetres, so millimetres. A URDF counts in metres.",
         "길이가 센티미터의 열 배, 곧 밀리미터입니다. URDF는 미터를 씁니다."),
    slip("head in centimetres", {"length": "cm"},
         "nod_joint's lengths are in centimetres. A URDF counts in metres.",
         "nod_joint의 길이를 센티미터로 썼습니다. URDF는 미터를 씁니다."),
    slip("lens in centimetres", {"lens_length": "cm"},
         "optical_joint's length is in centimetres. A URDF counts in metres.",
         "optical_joint의 길이를 센티미터로 썼습니다. URDF는 미터를 씁니다."),
    slip("another name", {"name": "nod"},
         "the joint that nods has another name. Joint states go by names: nobody will move it as nod_joint.",
         "끄덕이는 관절의 이름이 다릅니다. 관절 값은 이름으로 전해지므로 nod_joint라는 값으로는 움직이지 않습니다."),
    slip("turned as roll", {"turns": "roll"},
         "the head is rolled onto its side: your angle stands first in rpy. A turn to the right is a yaw, which comes last.",
         "머리가 옆으로 기울었습니다. 각도를 rpy의 첫째에 썼습니다. 오른쪽으로 도는 것은 마지막인 yaw입니다."),
    slip("turned as pitch", {"turns": "pitch"},
         "the head looks up or down: your angle stands in the middle of rpy. A turn to the right is a yaw, which comes last.",
         "머리가 위나 아래를 봅니다. 각도를 rpy의 가운데에 썼습니다. 오른쪽으로 도는 것은 마지막인 yaw입니다."),
    slip("optical on the base", {"hangs": "base_link"},
         "the optical frame hangs on base_link: it would not nod along. It hangs on camera_link.",
         "광학 좌표계가 base_link에 달려 있어 함께 끄덕이지 않습니다. camera_link에 달려야 합니다.", "M12"),
    slip("optical plus signs", {"optical": "plus"},
         "both quarter turns of optical_joint go the other way: with plus signs its z looks ahead, but its x points left and its y up. The picture stands on its head.",
         "optical_joint의 90도 회전 두 개가 모두 반대입니다. 양수로 쓰면 z는 앞을 보지만 x가 왼쪽, y가 위를 향해 영상이 뒤집힙니다.", "M4"),
    slip("optical yaw plus", {"optical": "yaw plus"},
         "the roll of optical_joint is right, its yaw goes the other way: this camera looks backwards.",
         "optical_joint의 roll은 맞지만 yaw가 반대입니다. 카메라가 뒤를 봅니다.", "M4"),
    slip("optical roll plus", {"optical": "roll plus"},
         "the yaw of optical_joint is right, its roll goes the other way: this camera looks backwards, and its y points up.",
         "optical_joint의 yaw는 맞지만 roll이 반대입니다. 카메라가 뒤를 보고 y가 위를 향합니다.", "M4"),
    slip("lengths turned", {"order": "turned"},
         "you turned the lengths by the head's own turn. They were measured along the robot: an origin says where in the parent's axes, and only then how it is turned.",
         "머리의 회전만큼 길이를 돌렸습니다. 로봇을 따라 잰 길이입니다. origin은 부모의 축으로 위치를 적고, 그다음에 방향을 적습니다.", "M3"),
    slip("lens in the head", {"lens": "in the head"},
         "the lens's way stands in nod_joint: now the whole head sits farther ahead and nods about another place. It belongs to optical_joint.",
         "렌즈까지의 거리가 nod_joint에 있습니다. 머리 전체가 더 앞에 놓여 다른 곳을 중심으로 끄덕입니다. optical_joint에 적으십시오."),
    slip("optical only rolled", {"optical": "roll"},
         "optical_joint makes one of its two quarter turns: after the roll, a yaw has to follow.",
         "optical_joint가 90도 회전 두 개 가운데 하나만 합니다. roll 다음에 yaw도 있어야 합니다.", "M4"),
    slip("optical only yawed", {"optical": "yaw"},
         "optical_joint makes one of its two quarter turns: before the yaw, a roll has to tip the axes over.",
         "optical_joint가 90도 회전 두 개 가운데 하나만 합니다. yaw 앞에 축을 눕히는 roll이 있어야 합니다.", "M4"),
    slip("optical pitched", {"optical": "pitch"},
         "the two quarter turns of optical_joint stand in the wrong places of rpy: it is roll and yaw that are needed.",
         "optical_joint의 90도 회전 두 개가 rpy의 다른 자리에 있습니다. roll과 yaw가 필요합니다.", "M4"),
    slip("optical only pitched", {"optical": "pitch alone"},
         "optical_joint makes one quarter turn, a pitch: z looks ahead, but x points down and y to the left. In a picture x goes to the right and y down, and that takes two quarter turns, a roll and a yaw.",
         "optical_joint가 pitch로 90도 한 번만 돕니다. z는 앞을 보지만 x가 아래, y가 왼쪽을 향합니다. 영상에서는 x가 오른쪽, y가 아래이므로 roll과 yaw로 두 번 돌려야 합니다.", "M4"),
    slip("optical only pitched up", {"optical": "pitch up alone"},
         "optical_joint makes one quarter turn, a pitch with a minus: z looks backwards, x points up and y to the left. In a picture z looks ahead, x goes to the right and y down, and that takes two quarter turns, a roll and a yaw.",
         "optical_joint가 pitch로 −90도 한 번만 돕니다. z가 뒤, x가 위, y가 왼쪽을 향합니다. 영상에서는 z가 앞, x가 오른쪽, y가 아래이므로 roll과 yaw로 두 번 돌려야 합니다.", "M4"),
    slip("to its left", {"side": "left"},
         "the camera hangs on the robot's left. y points to the left (REP-103), so to the right is negative.",
         "카메라가 로봇의 왼쪽에 있습니다. y는 왼쪽을 향하므로(REP-103) 오른쪽은 음수입니다."),
    slip("x and y exchanged", {"order": "y first"},
         "x and y have changed places: x is ahead, y to the left.",
         "x와 y의 자리가 바뀌었습니다. x가 앞, y가 왼쪽입니다."),
    slip("x and z exchanged", {"order": "z first"},
         "x and z have changed places: x is ahead, z up.",
         "x와 z의 자리가 바뀌었습니다. x가 앞, z가 위입니다."),
    slip("degrees", {"angle": "deg"},
         "nod_joint is turned by degrees. There is no degree in a URDF: math.radians.",
         "nod_joint를 도(degree)로 돌렸습니다. URDF에는 도가 없습니다. math.radians를 쓰십시오.", "M5"),
    slip("turned to the left", {"way": "left"},
         "the head is turned to the left: a yaw to the left is positive.",
         "머리가 왼쪽으로 돌아 있습니다. 왼쪽으로 도는 yaw가 양수입니다."),
    slip("not turned", {"turns": "none"},
         "nod_joint is not turned at all: its head looks straight ahead.",
         "nod_joint가 전혀 돌아 있지 않습니다. 머리가 똑바로 앞을 봅니다."),
    slip("turned twice", {"turns": "twice"},
         "the optical turn stands in nod_joint too. camera_link has the axes of a body; the turn belongs to optical_joint, once.",
         "광학 좌표계의 회전이 nod_joint에도 있습니다. camera_link는 본체의 축을 따릅니다. 이 회전은 optical_joint에 한 번만 씁니다.", "M4"),
    slip("axis in the parent", {"about": "parent"},
         "you wrote nod_joint's axis in base_link's axes. It is written in the child's own, after the origin has turned them.",
         "nod_joint의 axis를 base_link의 축으로 썼습니다. origin으로 돌린 뒤의 자식 축으로 적습니다."),
    slip("shakes", {"about": "z"},
         "with this axis the head shakes from side to side. Nodding turns about the axis that points to its left.",
         "이 axis로는 고개를 좌우로 젓습니다. 끄덕이는 것은 왼쪽을 향하는 축을 중심으로 돕니다."),
    slip("no axis", {"about": "x"},
         "the head rolls onto its side: its axis is x, which is also what a joint without an axis has. Nodding turns about the one that points to its left.",
         "고개가 옆으로 갸웃합니다. axis가 x입니다(axis를 쓰지 않아도 x가 됩니다). 끄덕이는 것은 왼쪽을 향하는 축을 중심으로 돕니다."),
    slip("nods upwards", {"about": "upwards"},
         "positive lifts the head. About +y, as a right hand turns, positive lowers it.",
         "양수일 때 고개가 올라갑니다. +y를 중심으로 오른손 방향으로 돌면 양수가 아래입니다."),
    slip("lens along z", {"lens": "z"},
         "the lens sits above camera_link: you measured it in the optical axes. An origin is measured in the parent's, where ahead is x.",
         "렌즈가 camera_link의 위에 있습니다. 광학 좌표계의 축으로 잰 것입니다. origin은 부모의 축으로 재고, 앞은 x입니다.", "M4"),
    slip("lens forgotten", {"lens": "forgotten"},
         "the lens sits in the middle of camera_link: how far ahead of it is it?",
         "렌즈가 camera_link의 한가운데에 있습니다. 앞으로 얼마나 나와 있습니까?"),
    slip("optical not turned", {"optical": "not"},
         "optical_joint is not turned: its x is still ahead. In an optical frame z is.",
         "optical_joint가 돌아 있지 않아 x가 아직 앞입니다. 광학 좌표계에서는 z가 앞입니다.", "M4"),
    slip("optical turned back", {"optical": "back"},
         "optical_joint is turned the opposite way: this is the pose of the body in the optical frame.",
         "optical_joint를 반대로 돌렸습니다. 광학 좌표계 기준 본체의 방향입니다.", "M4"),
    slip("optical in degrees", {"optical": "deg"},
         "optical_joint is turned by 90 radians. A quarter turn is 1.5708.",
         "optical_joint를 90라디안 돌렸습니다. 90도는 1.5708입니다.", "M5"),
)  # fmt: skip


TASK = Task(
    id="E7.1",
    kind="T",
    points=5,
    title=Text(en="Two joints to finish", ko="관절 두 개 완성하기"),
    answer="joints",
    form=Urdf(links=("camera_link", "camera_optical_frame"), joint="nod_joint", settings=(0.0, 0.4)),
    given=a_head,
    variants=6,
    model=finished,
    mistakes=SLIPS,
    hints=(
        Text(
            en="Two joints: nod_joint from base_link to camera_link, optical_joint from camera_link to camera_optical_frame.",
            ko="관절은 둘입니다. nod_joint는 base_link에서 camera_link, optical_joint는 camera_link에서 camera_optical_frame입니다.",
        ),
        Text(
            en="Metres and radians; right is negative, for y and for yaw. The axis is that of the head itself.",
            ko="미터와 라디안입니다. 오른쪽은 y에서도 yaw에서도 음수입니다. axis는 머리 자신의 축입니다.",
        ),
        Text(
            en='A nod turns about the head\'s own y. The optical turn is rpy="-1.5708 0 -1.5708" (chapter 02).',
            ko='끄덕임은 머리 자신의 y를 중심으로 돕니다. 광학 좌표계의 회전은 rpy="-1.5708 0 -1.5708"입니다(02장).',
        ),
    ),
    misconceptions=("M2", "M4", "M5"),
)
