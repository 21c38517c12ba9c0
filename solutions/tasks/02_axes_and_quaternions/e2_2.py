"""E2.2: From the picture to the camera."""

from __future__ import annotations

import math

from tflab.core import Transform
from tflab.workbook.tasks import Draws, Task, Text, Vector, WrongAnswer, WrongStep


def detection(rng: Draws) -> dict:
    """Draw a detection whose three numbers cannot be mistaken for one another."""
    right = rng.choice((-1, 1)) * rng.uniform(0.25, 0.45)
    down = rng.choice((-1, 1)) * rng.uniform(0.55, 0.80)
    return {"optical_p_part": (round(float(right), 2), round(float(down), 2), round(float(rng.uniform(1.2, 3.0)), 2))}


MUG = (0.40, -0.20, 1.50)  # the page's example


def picked(given, *, part="given", turns="both", side="left", height="up", depth="ahead", places="own", origin="camera",
           length="kept"):  # fmt: skip
    """Return the part in camera_link, step by step; other steps are the slips."""
    x, y, z = MUG if part == "the page's" else given.optical_p_part
    x, y, z = {
        "times the depth": (x * z, y * z, z),
        "over the depth": (x / z, y / z, z),
        "of a ray": (x, y, math.sqrt(z * z - x * x - y * y)),
        "with a ray": (x, y, math.hypot(x, y, z)),
        "mount added": (x + 0.10, y, z + 0.30),
    }.get(part, (x, y, z))
    quarter = math.pi / 2
    x, y, z = {
        "both": lambda: (z, -x, -y),
        "none": lambda: (x, y, z),
        "back": lambda: (-y, -z, x),
        "other order": lambda: (y, z, x),
        "sign of x tossed": lambda: (y, -z, -x),
        "sign of z tossed": lambda: (-y, z, -x),
        "x and z exchanged": lambda: (z, y, x),
        "x and z exchanged, y minus": lambda: (z, -y, x),
        "roll alone": lambda: Transform.from_rpy(roll=-quarter).apply((x, y, z)),
        "yaw alone": lambda: Transform.from_rpy(yaw=-quarter).apply((x, y, z)),
        "pitch": lambda: Transform.from_rpy(pitch=quarter).apply((x, y, z)),
        "roll to the other side": lambda: Transform.from_rpy(roll=quarter, yaw=-quarter).apply((x, y, z)),
        "yaw to the other side": lambda: Transform.from_rpy(roll=-quarter, yaw=quarter).apply((x, y, z)),
        "roll alone, plus": lambda: (x, -z, y),
        "yaw alone, plus": lambda: (-y, x, z),
        "pitch, minus": lambda: (-z, y, x),
        "half turns": lambda: (-x, y, -z),
        "converted twice": lambda: Transform.from_rpy(roll=math.radians(-quarter), yaw=math.radians(-quarter)).apply(
            (x, y, z)
        ),
        "eighths": lambda: Transform.from_rpy(roll=-quarter / 2, yaw=-quarter / 2).apply((x, y, z)),
        "degrees": lambda: Transform.from_rpy(roll=-90.0, yaw=-90.0).apply((x, y, z)),
        "degrees, by position": lambda: Transform.from_rpy(-90.0, -90.0).apply((x, y, z)),
        "degrees, plus": lambda: Transform.from_rpy(roll=90.0, yaw=90.0).apply((x, y, z)),
    }[turns]()
    x, y, z = (-x if depth == "behind" else x), (-y if side == "right" else y), (-z if height == "down" else z)
    x, y, z = (x, z, y) if places == "exchanged" else (x, y, z)
    ahead, up = {
        "base_link": (0.10, 0.30),
        "taken off": (-0.10, -0.30),
        "raised": (0.0, 0.30),
        "set forward": (0.10, 0.0),
    }.get(origin, (0.0, 0.0))
    x, z = x + ahead, z + up
    share = math.hypot(x, y, z) if length == "one" else 1.0
    return (x / share, y / share, z / share)


FORGOTTEN = WrongStep(
    "forgotten",
    {"turns": "none"},
    Text(
        en="These are the numbers of the picture, unchanged. In camera_link, which of the three says how far ahead?",
        ko="영상의 숫자를 그대로 썼습니다. camera_link에서는 셋 가운데 앞쪽으로 떨어진 거리는 어느 것입니까?",
    ),
    misconception="M4",
)


BACKWARDS = WrongStep(
    "backwards",
    {"turns": "back"},
    Text(
        en="You went the other way, from the body to the picture. (A transposed matrix, `p @ R`, a second turn, since this one is a third of a whole, and a quaternion of halves with the sign of its w tossed all come to the same.) The part must end up in front: is your x the depth?",
        ko="거꾸로 본체에서 영상 쪽으로 옮겼습니다. (행렬의 전치나 `p @ R`, 0.5로 된 쿼터니언에서 w의 부호를 틀린 것, 두 번 돌린 것도 같은 값이 됩니다. 이 회전은 한 바퀴의 3분의 1이라서 두 번 돌리면 반대쪽으로 한 번 돌린 것과 같습니다.) 부품은 앞에 있어야 합니다. x가 깊이와 같습니까?",
    ),
    misconception="M4",
)


NO_SIGNS = WrongStep(
    "no signs",
    {"side": "right", "height": "down"},
    Text(
        en="The axes are in their places, but their directions are not: right is not left, and down is not up. (Quarter turns by +π/2, a roll and a yaw, come to the same: both are negative. So does a quaternion of four halves whose signs are all alike.)",
        ko="축의 자리는 맞지만 방향이 틀립니다. 오른쪽은 왼쪽이 아니고, 아래는 위가 아닙니다. (roll과 yaw를 +π/2로 돌려도 같은 값이 됩니다. 둘 다 음수입니다. 0.5 네 개의 부호가 모두 같은 쿼터니언도 그렇습니다.)",
    ),
    misconception="M4",
)


UP_AND_DOWN = WrongStep(
    "up and down",
    {"height": "down"},
    Text(
        en="Above and below changed places: the picture's y counts down, the body's z counts up.",
        ko="위아래가 바뀌었습니다. 영상의 y는 아래로, 본체의 z는 위로 셉니다.",
    ),
    misconception="M4",
)


LEFT_AND_RIGHT = WrongStep(
    "left and right",
    {"side": "right"},
    Text(
        en="Left and right changed places: the picture's x counts to the right, the body's y to the left.",
        ko="좌우가 바뀌었습니다. 영상의 x는 오른쪽으로, 본체의 y는 왼쪽으로 셉니다.",
    ),
    misconception="M4",
)


SIDE_AND_HEIGHT = WrongStep(
    "side and height",
    {"places": "exchanged"},
    Text(
        en="Sideways and upwards changed places: in the picture x counts sideways and y downwards; on the body y is the side and z the height.",
        ko="옆 방향과 높이의 자리가 바뀌었습니다. 영상에서는 x가 옆, y가 아래이고, 본체에서는 y가 옆, z가 높이입니다.",
    ),
    misconception="M4",
)


BEHIND = WrongStep(
    "behind",
    {"depth": "behind"},
    Text(
        en="This part lies behind the camera. Depth counts forward in the picture, and x counts forward on the body.",
        ko="부품이 카메라 뒤에 있습니다. 영상의 깊이도 앞으로 세고, 본체의 x도 앞으로 셉니다.",
    ),
    misconception="M4",
)


IN_BASE_LINK = WrongStep(
    "in base_link",
    {"origin": "base_link"},
    Text(
        en="You went one frame too far: these are the numbers in base_link, with the camera's mount of the page added. Asked for is camera_link.",
        ko="한 좌표계를 더 갔습니다. 본문의 카메라 장착 위치까지 더한 base_link 기준 값입니다. 문제는 camera_link 기준을 묻습니다.",
    ),
)


OTHER_ORDER = WrongStep(
    "other order",
    {"turns": "other order"},
    Text(
        en="These are the two right turns in the other order, or a pitch stands in the place of one of them: with quarter turns all of that comes to the same, and so does a quaternion of halves whose y has lost its sign. First the roll, about x, which stands next to the point; then the yaw, about z.",
        ko="두 회전의 순서가 반대이거나, 둘 가운데 하나가 올 자리에 pitch를 썼습니다. 90도 회전에서는 모두 결과가 같습니다. 0.5로 된 쿼터니언에서 y의 부호를 틀려도 그렇습니다. 먼저 x축으로 도는 roll이 점 바로 옆에 오고, 그다음이 z축으로 도는 yaw입니다.",
    ),
)


DEGREES = WrongStep(
    "degrees",
    {"turns": "degrees"},
    Text(
        en="You gave 90 to a turn that counts in radians: that is fourteen full turns and a bit. A quarter turn is math.pi / 2.",
        ko="라디안으로 받는 자리에 90을 넣었습니다. 열네 바퀴가 넘는 회전입니다. 4분의 1바퀴는 math.pi / 2입니다.",
    ),
    misconception="M5",
)

ROLL_ALONE = WrongStep(
    "roll alone",
    {"turns": "roll alone"},
    Text(
        en="This is what the roll alone gives, a quarter turn about x. The yaw comes after it.",
        ko="roll, 곧 x축 4분의 1바퀴만 돌린 값입니다. 그다음에 yaw가 남았습니다.",
    ),
    "M4",
)

YAW_ALONE = WrongStep(
    "yaw alone",
    {"turns": "yaw alone"},
    Text(
        en="This is what the yaw alone gives, a quarter turn about z. A roll comes before it.",
        ko="yaw, 곧 z축 4분의 1바퀴만 돌린 값입니다. 그 앞에 roll이 있습니다.",
    ),
    "M4",
)

DIRECTION = WrongStep(
    "direction",
    {"length": "one"},
    Text(
        en="The direction is right and the length is 1: you divided by the distance. Asked for is the place, in metres.",
        ko="방향은 맞지만 길이가 1입니다. 거리로 나누었습니다. 필요한 것은 미터로 잰 위치입니다.",
    ),
)


ONLY_X_AND_Z = WrongStep(
    "only x and z",
    {"turns": "x and z exchanged"},
    Text(
        en="Depth has gone to the front, and the sideways number up. Only the depth's place is right: the picture's x counts to the right, its y down.",
        ko="깊이는 앞으로 갔지만 옆으로 잰 숫자가 위로 갔습니다. 깊이의 자리만 맞습니다. 영상의 x는 오른쪽, y는 아래쪽으로 셉니다.",
    ),
    "M4",
)


X_AND_Z_AND_A_MINUS = WrongStep(
    "x and z, and a minus",
    {"turns": "x and z exchanged, y minus"},
    Text(
        en="Depth has gone to the front, and the sideways number up; the downward number, with a minus, became the side. Only the depth's place is right: the picture's x counts to the right, its y down.",
        ko="깊이는 앞으로 갔지만 옆으로 잰 숫자가 위로 갔고, 아래로 잰 숫자가 부호만 바뀌어 옆이 되었습니다. 깊이의 자리만 맞습니다. 영상의 x는 오른쪽, y는 아래쪽으로 셉니다.",
    ),
    "M4",
)


ONE_PITCH = WrongStep(
    "one pitch",
    {"turns": "pitch"},
    Text(
        en="This is what one quarter turn about y gives: the depth comes to the front, and the rest lies askew. It takes two turns, a roll and a yaw.",
        ko="y축 둘레로 1/4 바퀴 돌린 값입니다. 그러면 깊이만 앞으로 옵니다. roll과 yaw, 두 번 돌려야 합니다.",
    ),
    "M4",
)


ROLL_TO_THE_OTHER_SIDE = WrongStep(
    "roll to the other side",
    {"turns": "roll to the other side"},
    Text(
        en="Depth and height have the other sign: as where a camera looks along -z and y goes up (OpenGL, Blender), and after a roll the other way, or two signs of the quaternion tossed. In ROS the optical z goes forward and its y down; both quarter turns are negative, -π/2.",
        ko="깊이와 높이의 부호가 반대입니다. 카메라가 -z 쪽을 보고 y가 위로 가는 축(OpenGL, Blender)으로 보았거나, roll을 반대 방향으로 돌렸거나, 쿼터니언의 부호를 둘 틀리면 이렇게 됩니다. ROS의 광학 좌표계는 z가 앞, y가 아래이고, 1/4 바퀴는 둘 다 음수, -π/2입니다.",
    ),
    "M4",
)


YAW_TO_THE_OTHER_SIDE = WrongStep(
    "yaw to the other side",
    {"turns": "yaw to the other side"},
    Text(
        en="Depth and side have the other sign, as after a yaw the other way, or with two signs of the quaternion tossed: both quarter turns are negative, -π/2.",
        ko="깊이와 옆 방향의 부호가 반대입니다. yaw를 반대 방향으로 돌리거나 쿼터니언의 부호를 둘 틀리면 이렇게 됩니다. 1/4 바퀴 둘 다 음수, -π/2입니다.",
    ),
    "M4",
)


EIGHTHS_OF_A_TURN = WrongStep(
    "eighths of a turn",
    {"turns": "eighths"},
    Text(
        en="You turned by an eighth of a circle, twice: a quarter is π/2. Halves belong into quaternions alone.",
        ko="1/8 바퀴씩 두 번 돌렸습니다. 1/4 바퀴는 π/2입니다. 절반은 쿼터니언에만 씁니다.",
    ),
    "M5",
)


DEGREES_AND_PLUS = WrongStep(
    "degrees, and plus",
    {"turns": "degrees, plus"},
    Text(
        en="You gave +90 to turns that count in radians, and both go the other way: a quarter turn is math.pi / 2, and here it is minus that.",
        ko="라디안으로 세는 회전에 +90을 넣었습니다. 1/4 바퀴는 math.pi / 2이고, 여기서는 부호도 음수입니다.",
    ),
    "M5",
)


MOUNT_TAKEN_OFF = WrongStep(
    "mount taken off",
    {"origin": "taken off"},
    Text(
        en="You took the camera's mount of the page off. The picture and camera_link have one origin, the camera: nothing is added or taken off.",
        ko="본문의 카메라 장착 위치를 뺐습니다. 영상의 좌표계와 camera_link는 원점이 같으므로 더하거나 뺄 것이 없습니다.",
    ),
)


CAMERA_RAISED = WrongStep(
    "camera raised",
    {"origin": "raised"},
    Text(
        en="You added the height of the camera. camera_link has its origin in the camera, and heights count from there.",
        ko="카메라의 높이를 더했습니다. camera_link의 원점은 카메라에 있고 높이도 거기서 잽니다.",
    ),
)


DEGREES_BY_POSITION = WrongStep(
    "degrees, by position",
    {"turns": "degrees, by position"},
    Text(
        en="This is what `from_rpy(-90, -90)` gives. It counts in radians, a quarter turn is math.pi / 2; and the second angle is the pitch, not the yaw: write `roll=` and `yaw=`.",
        ko="`from_rpy(-90, -90)`의 값입니다. 각도는 라디안이므로 1/4 바퀴는 math.pi / 2입니다. 그리고 두 번째 자리는 yaw가 아니라 pitch입니다. `roll=`, `yaw=`처럼 이름을 쓰십시오.",
    ),
    "M5",
)


CAMERA_SET_FORWARD = WrongStep(
    "camera set forward",
    {"origin": "set forward"},
    Text(
        en="You added how far ahead on the robot the camera is, 0.10. camera_link has its origin in the camera, and counts from there.",
        ko="카메라가 로봇의 중심보다 앞에 있는 거리 0.10을 더했습니다. camera_link의 원점은 카메라에 있고 거기서부터 잽니다.",
    ),
)


MOUNT_ADDED_FIRST = WrongStep(
    "mount added first",
    {"part": "mount added"},
    Text(
        en="You added the camera's mount of the page to the numbers of the picture. The picture and camera_link have one origin: there is nothing to add, and these two count along other axes.",
        ko="본문의 카메라 장착 위치를 영상의 숫자에 더했습니다. 영상의 좌표계와 camera_link는 원점이 같아 더할 것이 없고, 두 값은 재는 축도 다릅니다.",
    ),
)


HALF_TURNS = WrongStep(
    "half turns",
    {"turns": "half turns"},
    Text(
        en="This is what two half turns give, a roll and a yaw by π: no axis changes places, only signs. A quarter turn is π/2.",
        ko="π만큼, 곧 반 바퀴씩 roll과 yaw로 돌린 값입니다. 그러면 축의 자리는 그대로이고 부호만 바뀝니다. 1/4 바퀴는 π/2입니다.",
    ),
    "M5",
)


CONVERTED_TWICE = WrongStep(
    "converted twice",
    {"turns": "converted twice"},
    Text(
        en="The point has hardly turned: -π/2 was taken for degrees, and converted to radians once more. It is in radians already.",
        ko="점이 거의 돌지 않았습니다. -π/2를 도로 보고 라디안으로 한 번 더 바꾸었습니다. 이미 라디안입니다.",
    ),
    "M5",
)


TIMES_THE_DEPTH = WrongStep(
    "times the depth",
    {"part": "times the depth"},
    Text(
        en="The sideways and the downward number were multiplied by the depth, as one does with pixels over the focal length. These are metres already.",
        ko="옆과 아래로 잰 숫자에 깊이를 곱했습니다. 초점 거리로 나눈 픽셀이라면 그렇게 하지만, 이 숫자는 이미 미터입니다.",
    ),
)


OVER_THE_DEPTH = WrongStep(
    "over the depth",
    {"part": "over the depth"},
    Text(
        en="The sideways and the downward number were divided by the depth, as for a place in the picture. Asked for is the place in space, in metres.",
        ko="옆과 아래로 잰 숫자를 깊이로 나누었습니다. 그것은 영상 속의 위치입니다. 필요한 것은 미터로 잰 공간의 위치입니다.",
    ),
)


DEPTH_OF_A_RAY = WrongStep(
    "depth of a ray",
    {"part": "of a ray"},
    Text(
        en="You took the third number for the length of the ray to the part, and worked out the depth by Pythagoras. It is the depth itself, straight ahead.",
        ko="세 번째 숫자를 부품까지의 직선거리로 보고 피타고라스로 깊이를 구했습니다. 그 숫자가 곧 앞으로 잰 깊이입니다.",
    ),
)


RAY_FOR_DEPTH = WrongStep(
    "ray for depth",
    {"part": "with a ray"},
    Text(
        en="In the depth's place is the distance to the part, the root of all three squares. Ahead is the depth alone, the third number.",
        ko="깊이가 올 자리에 부품까지의 직선거리, 곧 세 수의 제곱합의 제곱근이 있습니다. 앞쪽은 세 번째 숫자인 깊이뿐입니다.",
    ),
)


NUMBERS_OF_THE_ROTATION = WrongAnswer(
    "numbers of the rotation",
    (-0.5, 0.5, -0.5),
    Text(
        en="These are the first three numbers of the turn's quaternion, as `.rotation` holds them. A place is moved by `.apply(point)`; that of a transform is its `.translation`.",
        ko="`.rotation`에 든 쿼터니언의 처음 세 숫자입니다. 점은 `.apply(점)`으로 옮기고, 변환의 위치는 `.translation`입니다.",
    ),
)


def of_one_turn(turns: str, axis: str, en: str, ko: str) -> WrongStep:
    """Return the slip of a single quarter turn, to the side where it does not belong."""
    return WrongStep(
        turns,
        {"turns": turns},
        Text(
            en=f"This is what a single quarter turn about {axis} gives, {en}. It takes two, a roll and a yaw, both by -π/2.",
            ko=f"{axis}축 둘레로 1/4 바퀴 한 번만, {ko} 돌린 값입니다. roll과 yaw, 두 번을 모두 -π/2로 돌려야 합니다.",
        ),
        "M4",
    )


ONE_TURN_TO_THE_OTHER_SIDE = (
    of_one_turn("roll alone, plus", "x", "a roll by +π/2", "+π/2로"),
    of_one_turn("yaw alone, plus", "z", "a yaw by +π/2", "+π/2로"),
    of_one_turn("pitch, minus", "y", "a pitch by -π/2", "-π/2로"),
)


def of_a_sign_tossed(name: str) -> WrongStep:
    """Return the slip of a quaternion (-0.5, 0.5, -0.5, 0.5) in which one sign is another."""
    return WrongStep(
        f"sign of {name} tossed",
        {"turns": f"sign of {name} tossed"},
        Text(
            en=f"This is what the quaternion of the page gives when its {name} has the other sign, and quarter turns about "
            "other axes may come to it, too. It takes a roll and a yaw, both -π/2.",
            ko=f"본문의 쿼터니언에서 {name}의 부호가 반대일 때의 값입니다. 다른 축으로 1/4 바퀴씩 돌려도 이렇게 될 수 있습니다. "
            "roll과 yaw가 필요하고 둘 다 -π/2입니다.",
        ),
        "M4",
    )


THE_MUG_OF_THE_PAGE = WrongStep(
    "the mug of the page",
    {"part": "the page's"},
    Text(
        en="The numbers are those of the page's mug, (0.40, -0.20, 1.50). Your part is another: `e2_2.optical_p_part`.",
        ko="본문에 나온 머그컵 (0.40, -0.20, 1.50)의 숫자입니다. 옮길 것은 `e2_2.optical_p_part`의 부품입니다.",
    ),
)


TASK = Task(
    id="E2.2",
    kind="N",
    points=3,
    title=Text(en="From the picture to the camera", ko="영상에서 카메라로"),
    answer="camera_p_part",
    form=Vector(3, unit="m", frame="camera_link", tolerance=0.005),
    given=detection,
    variants=5,
    model=picked,
    mistakes=(
        FORGOTTEN,
        BACKWARDS,
        NO_SIGNS,
        UP_AND_DOWN,
        LEFT_AND_RIGHT,
        SIDE_AND_HEIGHT,
        BEHIND,
        IN_BASE_LINK,
        OTHER_ORDER,
        DEGREES,
        ROLL_ALONE,
        YAW_ALONE,
        DIRECTION,
        ONLY_X_AND_Z,
        X_AND_Z_AND_A_MINUS,
        ONE_PITCH,
        ROLL_TO_THE_OTHER_SIDE,
        YAW_TO_THE_OTHER_SIDE,
        EIGHTHS_OF_A_TURN,
        DEGREES_AND_PLUS,
        MOUNT_TAKEN_OFF,
        CAMERA_RAISED,
        DEGREES_BY_POSITION,
        *ONE_TURN_TO_THE_OTHER_SIDE,
        of_a_sign_tossed("x"),
        of_a_sign_tossed("z"),
        THE_MUG_OF_THE_PAGE,
        CAMERA_SET_FORWARD,
        MOUNT_ADDED_FIRST,
        HALF_TURNS,
        CONVERTED_TWICE,
        TIMES_THE_DEPTH,
        OVER_THE_DEPTH,
        DEPTH_OF_A_RAY,
        RAY_FOR_DEPTH,
        NUMBERS_OF_THE_ROTATION,
    ),
    hints=(
        Text(
            en="Say in words where the part is, seen from the camera: ahead, right or left, above or below.",
            ko="카메라에서 볼 때 부품이 어디 있는지 먼저 말로 하십시오. 앞인지, 오른쪽인지 왼쪽인지, 위인지 아래인지.",
        ),
        Text(
            en="You need the rotation that carries optical numbers to camera_link: the one to remember, as rpy.",
            ko="광학 좌표계의 숫자를 camera_link로 옮기는 회전이 필요합니다. 외워 둔 바로 그 rpy입니다.",
        ),
        Text(
            en="Transform.from_rpy(roll=-math.pi / 2, yaw=-math.pi / 2) is camera_T_optical; .apply() moves a point from optical to camera_link.",
            ko="Transform.from_rpy(roll=-math.pi / 2, yaw=-math.pi / 2)가 camera_T_optical입니다. .apply()로 점을 광학 좌표계에서 camera_link로 옮깁니다.",
        ),
    ),
    misconceptions=("M4",),
)
