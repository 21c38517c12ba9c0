"""E12.7: A program that treats patients whom nobody has seen."""

from __future__ import annotations

from tflab.clinic.cures import DIAGNOSES
from tflab.workbook.tasks import Choice, Parts, Proof, Slip, Task, Words

from .draws import CAUSES, FRAMES, everything, one_of_each

PARENTS = {"odom": "map", "base_footprint": "odom", "laser_frame": "base_link"}


def eighteen(rng):
    """One patient of each cause."""
    return [(patient,) for patient in one_of_each(rng)]


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
):
    """Return the verdict, step by step; other steps are the slips."""
    if asks == "everything":
        for check in everything():
            patient.ask(check)
    cause = _cause(patient, map_lost, robot_lost, scan_lost, future, green, jumps, fixed)
    if asks == "one more" and cause == "nothing is wrong":
        patient.ask("view_frames")
    its_own = DIAGNOSES[cause].frame if cause in DIAGNOSES else "laser_frame"
    if frame == "the parent":
        return patient.verdict(cause, PARENTS.get(its_own, its_own))
    return patient.verdict(cause, its_own if frame == "by cause" else frame)


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
    if green not in ("no delay", "neither") and float(patient.ask("delay /scan").split()[0]) > 0.2:
        return "laser clock behind"
    return "nothing is wrong" if jumps == "correction" else "localizer owns the base"


EVERYTHING = Slip(
    "everything asked",
    {"asks": "everything"},
    Words(
        en="Your program asks the whole trolley before it thinks. A proof ends when the last rival is struck, and it has twelve minutes.",
        ko="프로그램이 생각하기 전에 트롤리 전체를 묻습니다. 증명은 마지막 경쟁자가 지워질 때 끝나고, 시간은 12분입니다.",
    ),
)

NO_NODE_NO_MAP = Slip(
    "map gone, node down",
    {"map_lost": "node down"},
    Words(
        en="Where map is missing your program blames a node that is not running. A node can run and wait: which check tells the two apart?",
        ko="map이 없으면 프로그램이 노드가 꺼졌다고 합니다. 켜져 있으면서 기다리는 노드도 있습니다. 둘을 가르는 검사는 무엇입니까?",
    ),
    "M11",
)

NO_NODE_NO_ROBOT = Slip(
    "robot gone, node down",
    {"robot_lost": "node down"},
    Words(
        en="Where the robot is missing your program always blames a node that is not running. A misspelt parent and a switch look the same on the map.",
        ko="로봇이 안 보이면 프로그램이 늘 노드가 꺼졌다고 합니다. 틀린 부모 이름이나 꺼진 스위치도 지도에서는 똑같아 보입니다.",
    ),
    "M11",
)

SECOND_PARENT = Slip(
    "second parent taken for a second owner",
    {"robot_lost": "two owners"},
    Words(
        en="Two nodes that send *different* edges to one child are no second owner of one edge: the tree itself changes to and fro.",
        ko="두 노드가 한 자식에게 *서로 다른* 연결을 보내는 것은 한 연결의 두 번째 발행자가 아닙니다. 트리 자체가 오락가락합니다.",
    ),
    "M7",
)

SENSOR = Slip(
    "sensor broken",
    {"scan_lost": "sensor"},
    Words(
        en="Where the scan is missing your program blames the sensor. RViz has the messages; it names the frame that it does not know.",
        ko="스캔이 안 보이면 프로그램이 센서를 탓합니다. RViz는 메시지를 받았고, 모르는 좌표계의 이름을 댑니다.",
    ),
    "M15",
)

ALWAYS_LATE = Slip(
    "future means late",
    {"future": "late"},
    Words(
        en="“Into the future” does not always mean that transforms are late. A clock that is ahead says the same, and so does an odometry at 2 Hz.",
        ko="“into the future”가 늘 변환이 늦다는 뜻은 아닙니다. 앞선 시계도, 2 Hz로 느린 오도메트리도 같은 말을 합니다.",
    ),
    "M10",
)

ALL_IS_WELL = Slip(
    "green means well",
    {"green": "all is well"},
    Words(
        en="Where RViz is green your program sends the patient home. A wrong mount, a wrong header, a late clock and a second owner are all green.",
        ko="RViz가 초록색이면 프로그램이 환자를 돌려보냅니다. 틀린 장착, 틀린 header, 늦은 시계, 두 번째 발행자도 모두 초록색입니다.",
    ),
    "M6",
)

A_STEP_IS_A_FAULT = Slip(
    "a correction taken for a fault",
    {"jumps": "fault"},
    Words(
        en="Your program finds a fault in a robot that has none. A step of map → odom is a correction; that is what the edge is for.",
        ko="아무 이상이 없는 로봇에서 고장을 찾아냅니다. map → odom이 튀는 것은 보정입니다. 그러라고 있는 연결입니다.",
    ),
    "M8",
)

NO_CLOCK_BUT_ITS_OWN = Slip(
    "always waits for /clock",
    {"map_lost": "clock"},
    Words(
        en="Where map is missing your program says that the localiser waits for /clock. A node that is not there waits for nothing: which check tells?",
        ko="map이 없으면 프로그램이 위치 추정 노드가 /clock을 기다린다고 합니다. 없는 노드는 기다리지도 않습니다. 어느 검사로 알 수 있습니까?",
    ),
    "M11",
)

NAME_IS_NODE = Slip(
    "a name taken for a node",
    {"fixed": "node down"},
    Words(
        en="RViz's own list holds map, and your program blames the localiser. What does it mean that the frame is there, and the one that was typed is not?",
        ko="RViz의 목록에 map이 있는데도 프로그램이 위치 추정 노드를 탓합니다. 그 좌표계는 있고 입력한 이름은 없다면 무슨 뜻입니까?",
    ),
    "M11",
)

ALWAYS_VOLATILE = Slip(
    "always volatile",
    {"scan_lost": "volatile"},
    Words(
        en="Where laser_frame is unknown your program always says volatile. A mount that is heard can still be refused: what does the log of a tool say?",
        ko="laser_frame을 모르면 프로그램이 늘 volatile이라고 합니다. 받았는데 거절된 장착도 있습니다. 도구의 로그는 무엇이라고 합니까?",
    ),
    "M12",
)

ALWAYS_ZEROS = Slip(
    "always zeros",
    {"scan_lost": "zeros"},
    Words(
        en="Where laser_frame is unknown your program always blames the quaternion. A mount that was sent too early for a late listener is missing, too.",
        ko="laser_frame을 모르면 프로그램이 늘 쿼터니언을 탓합니다. 늦게 온 쪽이 받지 못한 장착도 없는 것으로 나옵니다.",
    ),
    "M12",
)

ALWAYS_AHEAD = Slip(
    "future means ahead",
    {"future": "ahead"},
    Words(
        en="Where RViz speaks of the future your program always blames the laser's clock. Late transforms and a slow odometry give the same line.",
        ko="RViz에 future가 나오면 프로그램이 늘 레이저의 시계를 탓합니다. 늦은 변환과 느린 오도메트리도 같은 줄을 냅니다.",
    ),
    "M10",
)

SPREAD_UNREAD = Slip(
    "spread unread",
    {"future": "rate alone"},
    Words(
        en="Of `hz /odom` your program reads the rate alone. Transforms that come late come as often as ever; what gives them away is the std dev behind it, and a laser's clock leaves that as it was.",
        ko="`hz /odom`에서 주파수만 읽습니다. 늦게 오는 변환도 횟수는 그대로입니다. 뒤에 적힌 std dev가 달라지고, 레이저의 시계는 그것을 바꾸지 않습니다.",
    ),
    "M10",
)

HEADER_UNREAD = Slip(
    "header unread",
    {"green": "no header"},
    Words(
        en="Where all is green your program never reads the scan's header, and a header that says base_link gets another name.",
        ko="모두 초록색일 때 프로그램이 스캔의 header를 읽지 않습니다. 그래서 header가 base_link인 환자를 다른 원인으로 진단합니다.",
    ),
    "M15",
)

DELAY_UNREAD = Slip(
    "delay unread",
    {"green": "no delay"},
    Words(
        en="Where all is green your program never holds the scan's stamp against the clock, and a clock that is behind gets another name.",
        ko="모두 초록색일 때 프로그램이 스캔의 측정 시각을 시계와 견주지 않습니다. 그래서 시계가 늦은 환자를 다른 원인으로 진단합니다.",
    ),
    "M9",
)

NEITHER_READ = Slip(
    "header and delay unread",
    {"green": "neither"},
    Words(
        en="Where all is green your program reads neither the scan's header nor its delay. Two of the suspects show there and nowhere else.",
        ko="모두 초록색일 때 프로그램이 스캔의 header도 지연도 읽지 않습니다. 용의자 둘은 거기에만 드러납니다.",
    ),
    "M15",
)

OWNERS_UNSEEN = Slip(
    "owners unseen",
    {"green": "no owners"},
    Words(
        en="Where all is green your program never asks who runs, or how the wheels' edge moves. A second owner is green, too.",
        ko="모두 초록색일 때 프로그램이 누가 실행 중인지, 바퀴의 연결이 어떻게 움직이는지 묻지 않습니다. 두 번째 발행자도 초록색입니다.",
    ),
    "M6",
)

MOUNT_UNREAD = Slip(
    "mount unread",
    {"green": "no mount"},
    Words(
        en="Where all is green your program never reads the mount. RViz computes with whatever it is told.",
        ko="모두 초록색일 때 프로그램이 장착의 값을 읽지 않습니다. RViz는 받은 값으로 계산할 뿐입니다.",
    ),
    "M15",
)

ONE_MORE_QUESTION = Slip(
    "one more question",
    {"asks": "one more"},
    Words(
        en="Your program asks on where only one suspect is left. A proof ends with the check that struck the last rival.",
        ko="용의자가 하나 남았는데도 프로그램이 더 묻습니다. 증명은 마지막 경쟁자를 지운 검사에서 끝납니다.",
    ),
)

ALWAYS_THE_LASER = Slip(
    "always the laser's frame",
    {"frame": "laser_frame"},
    Words(
        en="You name laser_frame for every patient. Whose place is not right depends on the cause: a localiser's, the wheels', everything that moves, or nobody's.",
        ko="모든 환자에게 laser_frame이라고 합니다. 어느 자리가 틀렸는지는 원인에 달렸습니다. 위치 추정의 것, 바퀴의 것, 움직이는 모든 것, 또는 없음입니다.",
    ),
    "M15",
)

ALWAYS_THE_BASE = Slip(
    "always the base",
    {"frame": "base_footprint"},
    Words(
        en="You name base_footprint for every patient. Whose place is not right depends on the cause: a localiser's, the laser's, everything that moves, or nobody's.",
        ko="모든 환자에게 base_footprint라고 합니다. 어느 자리가 틀렸는지는 원인에 달렸습니다. 위치 추정의 것, 레이저의 것, 움직이는 모든 것, 또는 없음입니다.",
    ),
)


THE_EDGES_PARENT = Slip(
    "the edge's parent",
    {"frame": "the parent"},
    Words(
        en="You name the frame above: of the edge that is missing or wrong, its parent. The parent stays where it is; the frame whose place is not right is the child.",
        ko="위쪽 좌표계를 답합니다. 빠지거나 틀린 연결의 부모입니다. 부모는 제자리에 있고, 자리가 틀린 것은 자식입니다.",
    ),
)

NOBODYS_FRAME = Slip(
    "nobody's frame",
    {"frame": "none"},
    Words(
        en='You answer "none" for every patient: that nobody\'s place is wrong. It is so of a robot that has nothing; of all others some frame does not stand where it should.',
        ko='모든 환자에게 "none", 곧 틀린 자리가 없다고 답합니다. 아무 이상이 없는 로봇만 그렇습니다. 다른 환자는 어느 좌표계의 자리가 틀립니다.',
    ),
)


TASK = Task(
    id="E12.7",
    kind="F",
    points=5,
    title=Words(en="A program that makes the rounds", ko="회진하는 프로그램"),
    answer="triage",
    form=Parts({"cause": Choice(CAUSES), "frame": Choice(FRAMES), "proof": Proof(whole=True)}),
    inputs=eighteen,
    variants=1,
    is_costly=True,
    model=treat,
    twins=(
        EVERYTHING,
        NO_NODE_NO_MAP,
        NO_NODE_NO_ROBOT,
        SECOND_PARENT,
        SENSOR,
        ALWAYS_LATE,
        ALL_IS_WELL,
        A_STEP_IS_A_FAULT,
        NO_CLOCK_BUT_ITS_OWN,
        NAME_IS_NODE,
        ALWAYS_VOLATILE,
        ALWAYS_ZEROS,
        ALWAYS_AHEAD,
        SPREAD_UNREAD,
        HEADER_UNREAD,
        DELAY_UNREAD,
        NEITHER_READ,
        OWNERS_UNSEEN,
        MOUNT_UNREAD,
        ONE_MORE_QUESTION,
        ALWAYS_THE_LASER,
        ALWAYS_THE_BASE,
        THE_EDGES_PARENT,
        NOBODYS_FRAME,
    ),
    hints=(
        Words(
            en='Begin with the check that splits best: `patient.ask("rviz")` tells six complaints apart for a minute.',
            ko='가장 잘 가르는 검사로 시작하십시오. `patient.ask("rviz")`는 1분에 여섯 증상을 가릅니다.',
        ),
        Words(
            en="Then one question for each complaint: node list, publish_tf, hz /odom, echo base_link laser_frame.",
            ko="그다음은 증상마다 질문 하나입니다. node list, publish_tf, hz /odom, echo base_link laser_frame.",
        ),
        Words(
            en="Where all is green, rule out one suspect a question, and return as soon as one is found; last remains that nothing is wrong.",
            ko="모두 초록색이면 질문마다 용의자를 하나씩 지우고, 찾으면 바로 반환하십시오. 끝까지 남는 것은 이상 없음입니다.",
        ),
    ),
    cures=("M6", "M7", "M8", "M10", "M11", "M15"),
)
