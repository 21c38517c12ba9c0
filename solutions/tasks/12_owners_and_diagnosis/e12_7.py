"""E12.7: A program that treats patients whom nobody has seen."""

from __future__ import annotations

from tflab.clinic.cures import DIAGNOSES
from tflab.workbook.tasks import Choice, Parts, Proof, Task, Text, WrongStep

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
    named="map",
    late="all that move",
):
    """Return the verdict, step by step; other steps are the slips."""
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


EVERYTHING = WrongStep(
    "everything asked",
    {"asks": "everything"},
    Text(
        en="Your program asks the whole trolley before it thinks. A proof ends when the last rival is struck, and it has twelve minutes.",
        ko="프로그램이 생각하기 전에 트롤리 전체를 묻습니다. 증명은 마지막 경쟁자가 지워질 때 끝나고, 시간은 12분입니다.",
    ),
)

NO_NODE_NO_MAP = WrongStep(
    "map gone, node down",
    {"map_lost": "node down"},
    Text(
        en="Where map is missing your program blames a node that is not running. A node can run and wait: which check tells the two apart?",
        ko="map이 없으면 프로그램이 노드가 꺼졌다고 합니다. 켜져 있으면서 기다리는 노드도 있습니다. 둘을 가르는 검사는 무엇입니까?",
    ),
    "M11",
    part="cause",
)

NO_NODE_NO_ROBOT = WrongStep(
    "robot gone, node down",
    {"robot_lost": "node down"},
    Text(
        en="Where the robot is missing your program always blames a node that is not running. A misspelt parent and a switch look the same on the map.",
        ko="로봇이 안 보이면 프로그램이 늘 노드가 꺼졌다고 합니다. 틀린 부모 이름이나 꺼진 스위치도 지도에서는 똑같아 보입니다.",
    ),
    "M11",
    part="cause",
)

SECOND_PARENT = WrongStep(
    "second parent taken for a second owner",
    {"robot_lost": "two owners"},
    Text(
        en="Two nodes that send *different* edges to one child are no second owner of one edge: the tree itself changes to and fro.",
        ko="두 노드가 한 자식에게 *서로 다른* 연결을 보내는 것은 한 연결의 두 번째 발행자가 아닙니다. 트리 자체가 오락가락합니다.",
    ),
    "M7",
    part="cause",
)

SENSOR = WrongStep(
    "sensor broken",
    {"scan_lost": "sensor"},
    Text(
        en="Where the scan is missing your program blames the sensor. RViz has the messages; it names the frame that it does not know.",
        ko="스캔이 안 보이면 프로그램이 센서를 탓합니다. RViz는 메시지를 받았고, 모르는 좌표계의 이름을 댑니다.",
    ),
    "M15",
    part="cause",
)

ALWAYS_LATE = WrongStep(
    "future means late",
    {"future": "late"},
    Text(
        en="“Into the future” does not always mean that transforms are late. A clock that is ahead says the same, and so does an odometry at 2 Hz.",
        ko="“into the future”가 늘 변환이 늦다는 뜻은 아닙니다. 시계가 빠를 때도, 오도메트리가 2 Hz로 느릴 때도 같은 메시지가 나옵니다.",
    ),
    "M10",
    part="cause",
)

ALL_IS_WELL = WrongStep(
    "green means well",
    {"green": "all is well"},
    Text(
        en="Where RViz is green your program sends the patient home. A wrong mount, a wrong header, a late clock and a second owner are all green.",
        ko="RViz가 초록색이면 프로그램이 환자를 돌려보냅니다. 틀린 장착, 틀린 header, 늦은 시계, 두 번째 발행자도 모두 초록색입니다.",
    ),
    "M6",
    part="cause",
)

A_STEP_IS_A_FAULT = WrongStep(
    "a correction taken for a fault",
    {"jumps": "fault"},
    Text(
        en="Your program finds a fault in a robot that has none. A step of map → odom is a correction; that is what the edge is for.",
        ko="아무 이상이 없는 로봇에서 고장을 찾아냅니다. map → odom이 튀는 것은 보정입니다. 그러라고 있는 연결입니다.",
    ),
    "M8",
    part="cause",
)

NO_CLOCK_BUT_ITS_OWN = WrongStep(
    "always waits for /clock",
    {"map_lost": "clock"},
    Text(
        en="Where map is missing your program always says that the localiser waits for /clock. A node that is not there waits for nothing, and asked for its parameter it gives an error, which is a text, too. Which check tells, and what does it say to the letter?",
        ko="map이 없으면 프로그램이 늘 위치 추정 노드가 /clock을 기다린다고 합니다. 없는 노드는 기다리지도 않고, 그 파라미터를 물으면 오류가 나옵니다. 오류도 텍스트입니다. 어느 검사로 알 수 있고, 정확히 무엇이라고 나옵니까?",
    ),
    "M11",
    part="cause",
)

NAME_IS_NODE = WrongStep(
    "a name taken for a node",
    {"fixed": "node down"},
    Text(
        en="RViz's own list holds map, and your program blames the localiser. What does it mean that the frame is there, and the one that was typed is not?",
        ko="RViz의 목록에 map이 있는데도 프로그램이 위치 추정 노드를 탓합니다. 그 좌표계는 있고 입력한 이름은 없다면 무슨 뜻입니까?",
    ),
    "M11",
    part="cause",
)

ALWAYS_VOLATILE = WrongStep(
    "always volatile",
    {"scan_lost": "volatile"},
    Text(
        en="Where laser_frame is unknown your program always says volatile. A mount that is heard can still be refused: what does the log of a tool say?",
        ko="laser_frame을 모르면 프로그램이 늘 volatile이라고 합니다. 받았는데 거절된 장착도 있습니다. 도구의 로그는 무엇이라고 합니까?",
    ),
    "M12",
    part="cause",
)

ALWAYS_ZEROS = WrongStep(
    "always zeros",
    {"scan_lost": "zeros"},
    Text(
        en="Where laser_frame is unknown your program always blames the quaternion. A mount that was sent too early for a late listener is missing, too.",
        ko="laser_frame을 모르면 프로그램이 늘 쿼터니언을 탓합니다. 늦게 온 쪽이 받지 못한 장착도 없는 것으로 나옵니다.",
    ),
    "M12",
    part="cause",
)

ALWAYS_AHEAD = WrongStep(
    "future means ahead",
    {"future": "ahead"},
    Text(
        en="Where RViz speaks of the future your program always blames the laser's clock. Late transforms and a slow odometry give the same line.",
        ko="RViz에 future가 나오면 프로그램이 늘 레이저의 시계를 탓합니다. 늦은 변환과 느린 오도메트리도 같은 줄을 냅니다.",
    ),
    "M10",
    part="cause",
)

SPREAD_UNREAD = WrongStep(
    "spread unread",
    {"future": "rate alone"},
    Text(
        en="Your program takes late transforms for a laser's clock. They come as often as ever; what gives them away is the std dev behind the rate in `hz /odom`, which is far above the card's, and a laser's clock leaves that as it was.",
        ko="늦은 변환을 레이저의 시계로 봅니다. 늦게 오는 변환도 횟수는 그대로입니다. `hz /odom`의 주파수 뒤에 적힌 std dev가 카드보다 훨씬 커지고, 레이저의 시계는 그것을 바꾸지 않습니다.",
    ),
    "M10",
    part="cause",
)

HEADER_UNREAD = WrongStep(
    "header unread",
    {"green": "no header"},
    Text(
        en="Where all is green your program never reads the scan's header, and a header that says base_link gets another name.",
        ko="모두 초록색일 때 프로그램이 스캔의 header를 읽지 않습니다. 그래서 header가 base_link인 환자를 다른 원인으로 진단합니다.",
    ),
    "M15",
)

DELAY_UNREAD = WrongStep(
    "delay unread",
    {"green": "no delay"},
    Text(
        en="Where all is green your program never holds the scan's stamp against the clock, and a clock that is behind gets another name.",
        ko="모두 초록색일 때 프로그램이 스캔의 측정 시각을 시계와 견주지 않습니다. 그래서 시계가 늦은 환자를 다른 원인으로 진단합니다.",
    ),
    "M9",
)

DELAY_MISREAD = WrongStep(
    "delay misread",
    {"green": "delay misread"},
    Text(
        en="Where all is green, a laser's clock that is behind is never found: with it you say that nothing is wrong. If your program reads `delay /scan`, what does it compare it with? Patients differ: compare with the card, and by more or less, not with one number to the letter.",
        ko="모두 초록색일 때 늦은 레이저 시계를 찾지 못하고 이상이 없다고 합니다. `delay /scan`을 읽는다면 무엇과 비교합니까? 환자마다 값이 다릅니다. 한 숫자와 글자까지 같은지가 아니라 카드보다 얼마나 큰지를 보십시오.",
    ),
    "M9",
    part="cause",
)

NEITHER_READ = WrongStep(
    "header and delay unread",
    {"green": "neither"},
    Text(
        en="Where all is green your program reads neither the scan's header nor its delay. Two of the suspects show there and nowhere else.",
        ko="모두 초록색일 때 프로그램이 스캔의 header도 지연도 읽지 않습니다. 용의자 둘은 거기에만 드러납니다.",
    ),
    "M15",
)

OWNERS_UNSEEN = WrongStep(
    "owners unseen",
    {"green": "no owners"},
    Text(
        en="Where all is green your program never asks who runs, or how the wheels' edge moves. A second owner is green, too.",
        ko="모두 초록색일 때 프로그램이 누가 실행 중인지, 바퀴의 연결이 어떻게 움직이는지 묻지 않습니다. 두 번째 발행자도 초록색입니다.",
    ),
    "M6",
)

MOUNT_UNREAD = WrongStep(
    "mount unread",
    {"green": "no mount"},
    Text(
        en="Where all is green your program never reads the mount. RViz computes with whatever it is told.",
        ko="모두 초록색일 때 프로그램이 장착의 값을 읽지 않습니다. RViz는 받은 값으로 계산할 뿐입니다.",
    ),
    "M15",
)

ONE_MORE_QUESTION = WrongStep(
    "one more question",
    {"asks": "one more"},
    Text(
        en="Your program asks on where only one suspect is left. A proof ends with the check that struck the last rival.",
        ko="용의자가 하나 남았는데도 프로그램이 더 묻습니다. 증명은 마지막 경쟁자를 지운 검사에서 끝납니다.",
    ),
)

ALWAYS_THE_LASER = WrongStep(
    "always the laser's frame",
    {"frame": "laser_frame"},
    Text(
        en="You name laser_frame for every patient. Whose place is not right depends on the cause: a localiser's, the wheels', everything that moves, or nobody's.",
        ko="모든 환자에게 laser_frame이라고 합니다. 어느 자리가 틀렸는지는 원인에 달렸습니다. 위치 추정의 것, 바퀴의 것, 움직이는 모든 것, 또는 없음입니다.",
    ),
    "M15",
    part="frame",
)

ALWAYS_THE_BASE = WrongStep(
    "always the base",
    {"frame": "base_footprint"},
    Text(
        en="You name base_footprint for every patient. Whose place is not right depends on the cause: a localiser's, the laser's, everything that moves, or nobody's.",
        ko="모든 환자에게 base_footprint라고 합니다. 어느 자리가 틀렸는지는 원인에 달렸습니다. 위치 추정의 것, 레이저의 것, 움직이는 모든 것, 또는 없음입니다.",
    ),
    part="frame",
)


THE_EDGES_PARENT = WrongStep(
    "the edge's parent",
    {"frame": "the parent"},
    Text(
        en="You name the frame above: of the edge that is missing or wrong, its parent. The parent stays where it is; the frame whose place is not right is the child.",
        ko="위쪽 좌표계를 답합니다. 빠지거나 틀린 연결의 부모입니다. 부모는 제자리에 있고, 자리가 틀린 것은 자식입니다.",
    ),
    part="frame",
)

NO_FRAME_FOR_A_NAME = WrongStep(
    "no frame for a name",
    {"named": "none"},
    Text(
        en='For a misspelt Fixed Frame you answer "none". The frame that is asked for under a wrong name is one of those to choose from: which one did RViz not find?',
        ko='Fixed Frame이 틀린 환자에게 "none"이라고 답합니다. 틀린 이름으로 찾은 좌표계가 보기에 있습니다. RViz가 찾지 못한 것은 어느 좌표계입니까?',
    ),
    part="frame",
)

LASER_FOR_THE_FUTURE = WrongStep(
    "the laser's frame for the future",
    {"frame": "laser_frame for the future"},
    Text(
        en="Wherever RViz speaks of the future you name laser_frame: that is where it shows. Whose place is not right is another question: of a slow odometry it is the wheels' edge, of late transforms every edge that moves.",
        ko="RViz에 future가 나오면 언제나 laser_frame이라고 합니다. 그것은 증상이 보이는 곳입니다. 자리가 틀린 것은 따로 있습니다. 오도메트리가 느리면 바퀴의 연결, 변환이 늦으면 움직이는 연결 모두입니다.",
    ),
    "M15",
    part="frame",
)

LATE_IS_THE_BASE = WrongStep(
    "late is the base",
    {"late": "base_footprint"},
    Text(
        en="For late transforms you name base_footprint. The wheels' edge is late, and not alone: what else comes over the same network, and moves?",
        ko="변환이 늦은 환자에게 base_footprint라고 답합니다. 바퀴의 연결도 늦지만 그것만이 아닙니다. 같은 네트워크로 오면서 움직이는 것이 또 무엇입니까?",
    ),
    part="frame",
)

NOBODYS_FRAME = WrongStep(
    "nobody's frame",
    {"frame": "none"},
    Text(
        en='You answer "none" for every patient: that nobody\'s place is wrong. It is so of a robot that has nothing; of all others some frame does not stand where it should.',
        ko='모든 환자에게 "none", 곧 틀린 자리가 없다고 답합니다. 아무 이상이 없는 로봇만 그렇습니다. 다른 환자는 어느 좌표계의 자리가 틀립니다.',
    ),
    part="frame",
)


SEEN = {  # what there is to see wherever a cause, or a frame, is right
    "localizer not running": Text(
        en="There `node list` holds no localization.",
        ko="여기서는 `node list`에 localization이 없습니다.",
    ),
    "localizer waits for /clock": Text(
        en="There localization runs, and its `use_sim_time` says True.",
        ko="여기서는 localization이 실행 중이고 `use_sim_time`이 True입니다.",
    ),
    "Fixed Frame misspelt": Text(
        en="There RViz does not know its Fixed Frame, and lists map.",
        ko="여기서는 RViz가 Fixed Frame을 모르는데 목록에는 map이 있습니다.",
    ),
    "odometry not running": Text(
        en="There wheel_odometry is not found, neither in `node list` nor for `publish_tf`.",
        ko="여기서는 `node list`에도, `publish_tf`를 물어도 wheel_odometry가 없습니다.",
    ),
    "parent misspelt": Text(
        en="There RViz tells of a foreign frame.",
        ko="여기서는 RViz에 낯선 좌표계가 나옵니다.",
    ),
    "publish_tf off": Text(
        en="There `publish_tf` says False.",
        ko="여기서는 `publish_tf`가 False입니다.",
    ),
    "two owners of one edge": Text(
        en="There `node list` holds an ekf_filter_node.",
        ko="여기서는 `node list`에 ekf_filter_node가 있습니다.",
    ),
    "localizer owns the base": Text(
        en="There the robot is lost to RViz, and yet `publish_tf` says True.",
        ko="여기서는 RViz에 로봇이 없는데 `publish_tf`는 True입니다.",
    ),
    "nothing is wrong": Text(
        en="There every reading is as on the card.",
        ko="여기서는 읽은 값이 모두 카드와 같습니다.",
    ),
    "mount wrong": Text(
        en="There `echo base_link laser_frame` is not what the card says.",
        ko="여기서는 `echo base_link laser_frame`이 카드와 다릅니다.",
    ),
    "header says base_link": Text(
        en="There `scan header` says base_link.",
        ko="여기서는 `scan header`가 base_link입니다.",
    ),
    "laser clock behind": Text(
        en="There `delay /scan` is much larger than on the card.",
        ko="여기서는 `delay /scan`이 카드보다 훨씬 큽니다.",
    ),
    "laser clock ahead": Text(
        en="There RViz speaks of the future, and `hz /odom` is as on the card, its std dev with it.",
        ko="여기서는 RViz에 future가 나오고 `hz /odom`은 std dev까지 카드와 같습니다.",
    ),
    "transforms late": Text(
        en="There `hz /odom` has the rate of the card, and a std dev far above it.",
        ko="여기서는 `hz /odom`의 주파수는 카드와 같지만 std dev가 훨씬 큽니다.",
    ),
    "odometry slow": Text(
        en="There the rate in `hz /odom` is far below the card's.",
        ko="여기서는 `hz /odom`의 주파수가 카드보다 훨씬 작습니다.",
    ),
    "quaternion of zeros": Text(
        en="There a tool that listens logs TF_DENORMALIZED_QUATERNION.",
        ko="여기서는 수신하는 도구의 로그에 TF_DENORMALIZED_QUATERNION이 나옵니다.",
    ),
    "header says another frame": Text(
        en="There RViz names another frame than laser_frame as unknown.",
        ko="여기서는 RViz가 모른다고 하는 좌표계가 laser_frame이 아닙니다.",
    ),
    "mount volatile": Text(
        en="There laser_frame is unknown, and `info /tf_static` shows a publisher that is VOLATILE.",
        ko="여기서는 laser_frame을 모르고, `info /tf_static`에 VOLATILE인 발행자가 있습니다.",
    ),
    "map": Text(
        en="There the Fixed Frame is misspelt: it is map that is asked for by a wrong name.",
        ko="여기서는 Fixed Frame이 틀렸습니다. 틀린 이름으로 찾은 것이 map입니다.",
    ),
    "odom": Text(
        en="There map → odom is missing, and its child is odom.",
        ko="여기서는 map → odom 연결이 없고, 그 자식이 odom입니다.",
    ),
    "base_footprint": Text(
        en="There it is the edge odom → base_footprint, and its child is base_footprint.",
        ko="여기서는 odom → base_footprint 연결이 문제이고, 그 자식이 base_footprint입니다.",
    ),
    "laser_frame": Text(
        en="There it is the laser's mount, header or clock.",
        ko="여기서는 레이저의 장착이나 header나 시계가 문제입니다.",
    ),
    "all that move": Text(
        en="There transforms come late over the network: of every edge that moves.",
        ko="여기서는 네트워크로 오는 변환이 늦습니다. 움직이는 연결이 모두 그렇습니다.",
    ),
    "none": Text(
        en="There nothing is wrong.",
        ko="여기서는 아무 이상이 없습니다.",
    ),
}

TASK = Task(
    id="E12.7",
    kind="F",
    points=5,
    title=Text(en="A program that makes the rounds", ko="회진하는 프로그램"),
    answer="triage",
    form=Parts({"cause": Choice(CAUSES), "frame": Choice(FRAMES), "proof": Proof(whole=True)}),
    inputs=eighteen,
    variants=1,
    is_costly=True,
    model=treat,
    mistakes=(
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
        DELAY_MISREAD,
        NEITHER_READ,
        OWNERS_UNSEEN,
        MOUNT_UNREAD,
        ONE_MORE_QUESTION,
        ALWAYS_THE_LASER,
        ALWAYS_THE_BASE,
        THE_EDGES_PARENT,
        NOBODYS_FRAME,
        NO_FRAME_FOR_A_NAME,
        LASER_FOR_THE_FUTURE,
        LATE_IS_THE_BASE,
    ),
    seen=SEEN,
    hints=(
        Text(
            en='Begin with the check that splits best: `patient.ask("rviz")` tells six complaints apart for a minute.',
            ko='가장 잘 가르는 검사로 시작하십시오. `patient.ask("rviz")`는 1분에 여섯 증상을 가릅니다.',
        ),
        Text(
            en="Then one question for each complaint: node list, publish_tf, hz /odom, echo base_link laser_frame.",
            ko="그다음은 증상마다 질문 하나입니다. node list, publish_tf, hz /odom, echo base_link laser_frame.",
        ),
        Text(
            en="Where all is green, rule out one suspect a question, and return as soon as one is found; last remains that nothing is wrong.",
            ko="모두 초록색이면 질문마다 용의자를 하나씩 지우고, 찾으면 바로 반환하십시오. 끝까지 남는 것은 이상 없음입니다.",
        ),
    ),
    misconceptions=("M6", "M7", "M8", "M10", "M11", "M15"),
)
