"""E11.7: Three commands."""

from __future__ import annotations

from tflab.workbook.tasks import Command, Parts, Task, Text, WrongStep

PAIRS = (
    ("map", "base_link"), ("odom", "base_link"), ("map", "laser_frame"), ("odom", "camera_link"),
    ("map", "base_footprint"), ("odom", "laser_frame"),
)  # fmt: skip


def frames_and_rate(rng):
    first, second = (PAIRS[i] for i in rng.permutation(len(PAIRS))[:2])
    return {
        "echo_of": first[1],
        "echo_in": first[0],
        "echo_hz": int(rng.choice((5, 10, 20, 25))),
        "chain": list(second),
        "topic": str(rng.choice(("/tf", "/tf_static"))),
    }


ECHO = {
    "tf2_ros": "ros2 run tf2_ros tf2_echo",
    "tf2_tools": "ros2 run tf2_tools tf2_echo",
    "topic echo": "ros2 topic echo",
}


def lines(given, *, order="in first", rate="given", chain="given", clock="simulated", who="--verbose",
          package="tf2_ros", tool="tf2_monitor"):  # fmt: skip
    """Return the three lines, step by step; other steps are the slips."""
    frames = (given.echo_in, given.echo_of) if order == "in first" else (given.echo_of, given.echo_in)
    hz = {
        "given": f" {given.echo_hz}",
        "none": "",
        "option": f" --rate {given.echo_hz}",
        "short option": f" -r {given.echo_hz}",
        "period": f" {1 / given.echo_hz}",
    }[rate]
    other = "/tf" if given.topic == "/tf_static" else "/tf_static"
    ends = given.chain if chain == "given" else [] if chain == "all" else given.chain[::-1]
    sim = {
        "simulated": " --ros-args -p use_sim_time:=true",
        "wall": "",
        "bare": " use_sim_time:=true",
        "off": " --ros-args -p use_sim_time:=false",
        "no --ros-args": " -p use_sim_time:=true",
        "equals": " --ros-args -p use_sim_time=true",
        "one": " --ros-args -p use_sim_time:=1",
        "--clock": " --clock",
    }[clock]
    return {
        "value": f"{ECHO[package]} {' '.join(frames)}{hz if package != 'topic echo' else ''}",
        "late": {
            "tf2_monitor": " ".join(["ros2 run tf2_ros tf2_monitor", *ends]) + sim,
            "tf2_tools": " ".join(["ros2 run tf2_tools tf2_monitor", *ends]) + sim,
            "topic delay": " ".join(["ros2 topic delay", *ends]),
            "view_frames": "ros2 run tf2_tools view_frames",
        }[tool],
        "who": {
            "--verbose": f"ros2 topic info {given.topic} --verbose",
            "counts": f"ros2 topic info {given.topic}",
            "topics": "ros2 topic list",
            "nodes": "ros2 node list",
            "node info": f"ros2 node info {given.topic}",
            "echo": f"ros2 topic echo {given.topic}",
            "hz": f"ros2 topic hz {given.topic}",
            "other topic": f"ros2 topic info {other} --verbose",
        }[who],
    }


OTHER_WAY_ROUND = WrongStep(
    "other way round",
    {"order": "of first"},
    Text(
        en="value: this prints the other pose, the inverse. tf2_echo A B is B as seen from A.",
        ko="value: 반대 방향의 포즈, 곧 역변환이 출력됩니다. tf2_echo A B는 A 기준으로 본 B입니다.",
    ),
    "M1",
    part="value",
)

RATE_FORGOTTEN = WrongStep(
    "rate forgotten",
    {"rate": "none"},
    Text(
        en="value: without a third argument it prints once a second.",
        ko="value: 셋째 인자가 없으면 1초에 한 번 출력합니다.",
    ),
    part="value",
)

RATE_AS_AN_OPTION = WrongStep(
    "rate as an option",
    {"rate": "option"},
    Text(
        en="value: the rate is no option: it stands alone, as the third argument.",
        ko="value: 1초에 몇 번인지는 옵션이 아니라 셋째 인자로 숫자만 씁니다.",
    ),
    part="value",
)

CLOCK_FORGOTTEN = WrongStep(
    "clock forgotten",
    {"clock": "wall"},
    Text(
        en="late: the tool would subtract simulated stamps from the time on the wall: the story's 51.7 years.",
        ko="late: 컴퓨터의 시스템 시각에서 시뮬레이션의 측정 시각을 빼게 됩니다. 첫머리 이야기의 51.7년입니다.",
    ),
    "M13",
    part="late",
)

PARAMETER_BARE = WrongStep(
    "parameter bare",
    {"clock": "bare"},
    Text(
        en="late: that is how launch files take arguments. `ros2 run` takes parameters after --ros-args, each with -p.",
        ko="late: launch 인자를 주는 방식입니다. `ros2 run`에서는 --ros-args 다음에 -p로 파라미터를 줍니다.",
    ),
    part="late",
)

CLOCK_SWITCHED_OFF = WrongStep(
    "clock switched off",
    {"clock": "off"},
    Text(en="late: false is what it is anyway.", ko="late: false는 원래의 값입니다."),
    part="late",
)

ALL_FRAMES = WrongStep(
    "all frames",
    {"chain": "all"},
    Text(
        en="late: without two frames it reports every frame, and no chain.",
        ko="late: 두 좌표계를 주지 않으면 모든 좌표계를 보고하고 사슬은 재지 않습니다.",
    ),
    part="late",
)

CHAIN_TURNED_ROUND = WrongStep(
    "chain turned round",
    {"chain": "turned round"},
    Text(
        en="late: the delay would be the same, but the chain is printed from its other end. Write the frames in the order given.",
        ko="late: 지연은 같지만 사슬이 반대쪽 끝부터 출력됩니다. 주어진 순서대로 쓰십시오.",
    ),
    part="late",
)

ONLY_COUNTS = WrongStep(
    "only counts",
    {"who": "counts"},
    Text(en="who: this prints how many they are, not who.", ko="who: 몇 개인지만 나오고 누구인지는 나오지 않습니다."),
    part="who",
)

PERIOD_FOR_RATE = WrongStep(
    "period for rate",
    {"rate": "period"},
    Text(
        en="value: the third argument is a rate, in prints a second, not the time between two.",
        ko="value: 셋째 인자는 출력 사이의 시간이 아니라 1초에 몇 번인지입니다.",
    ),
    part="value",
)

RATE_AS_A_SHORT_OPTION = WrongStep(
    "rate as a short option",
    {"rate": "short option"},
    Text(
        en="value: there is no -r: the number stands alone, last.",
        ko="value: -r 옵션은 없습니다. 숫자만 마지막에 씁니다.",
    ),
    part="value",
)

ROS_ARGS_FORGOTTEN = WrongStep(
    "ros-args forgotten",
    {"clock": "no --ros-args"},
    Text(
        en="late: -p is heard only behind --ros-args; before it the tool takes it for a frame.",
        ko="late: -p는 --ros-args 뒤에서만 통합니다. 그 앞에 있으면 도구가 좌표계 이름으로 받아들입니다.",
    ),
    part="late",
)

EQUALS_SIGN = WrongStep(
    "equals sign",
    {"clock": "equals"},
    Text(
        en="late: ROS writes := between a parameter and its value.",
        ko="late: ROS에서는 파라미터와 값 사이에 :=을 씁니다.",
    ),
    part="late",
)

ONE_FOR_TRUE = WrongStep(
    "one for true",
    {"clock": "one"},
    Text(
        en="late: use_sim_time is a bool. 1 is an integer, and the node refuses it.",
        ko="late: use_sim_time은 bool입니다. 1은 정수라서 노드가 거부합니다.",
    ),
    part="late",
)

LIST_OF_TOPICS = WrongStep(
    "list of topics",
    {"who": "topics"},
    Text(
        en="who: that lists the topics, and no nodes.",
        ko="who: 토픽의 목록이고 노드는 나오지 않습니다.",
    ),
    part="who",
)

LIST_OF_NODES = WrongStep(
    "list of nodes",
    {"who": "nodes"},
    Text(
        en="who: that lists all nodes, whatever they publish.",
        ko="who: 무엇을 발행하든 모든 노드가 나옵니다.",
    ),
    part="who",
)

OTHER_TOPIC = WrongStep(
    "other topic",
    {"who": "other topic"},
    Text(
        en="who: that is the other of the two TF topics.",
        ko="who: 두 TF 토픽 가운데 다른 쪽입니다.",
    ),
    part="who",
)

ECHO_OF_TOOLS = WrongStep(
    "echo from tf2_tools",
    {"package": "tf2_tools"},
    Text(
        en="value: tf2_echo belongs to the package tf2_ros. tf2_tools has view_frames.",
        ko="value: tf2_echo는 tf2_ros 패키지에 있습니다. tf2_tools에 있는 것은 view_frames입니다.",
    ),
    part="value",
)

TOPIC_FOR_A_POSE = WrongStep(
    "topic for a pose",
    {"package": "topic echo"},
    Text(
        en="value: `topic echo` prints the messages of a topic. A frame is no topic: which tool puts edges together?",
        ko="value: `topic echo`는 토픽의 메시지를 출력합니다. 좌표계는 토픽이 아닙니다. 연결을 이어 주는 도구는 무엇입니까?",
    ),
    "M15",
    part="value",
)

MONITOR_OF_TOOLS = WrongStep(
    "monitor from tf2_tools",
    {"tool": "tf2_tools"},
    Text(
        en="late: tf2_monitor belongs to the package tf2_ros. tf2_tools has view_frames.",
        ko="late: tf2_monitor는 tf2_ros 패키지에 있습니다. tf2_tools에 있는 것은 view_frames입니다.",
    ),
    part="late",
)

DELAY_OF_A_MESSAGE = WrongStep(
    "delay of a message",
    {"tool": "topic delay"},
    Text(
        en="late: `topic delay` takes a topic, and measures its messages. A chain of frames has another tool.",
        ko="late: `topic delay`는 토픽 메시지의 지연을 잽니다. 좌표계의 사슬을 재는 도구는 따로 있습니다.",
    ),
    part="late",
)

TREE_FOR_A_DELAY = WrongStep(
    "tree for a delay",
    {"tool": "view_frames"},
    Text(
        en="late: view_frames draws the tree, and takes no frames. Which tool measures how late a chain is?",
        ko="late: view_frames는 트리를 그리고 좌표계를 받지 않습니다. 사슬이 얼마나 늦는지 재는 도구는 무엇입니까?",
    ),
    part="late",
)

CLOCK_OPTION = WrongStep(
    "clock option",
    {"clock": "--clock"},
    Text(
        en="late: --clock is an option of `bag play`, which makes the time. A tool is told to listen to it by a parameter.",
        ko="late: --clock은 시간을 만드는 `bag play`의 옵션입니다. 도구가 그것을 듣게 하는 것은 파라미터입니다.",
    ),
    "M13",
    part="late",
)

NODE_INFO = WrongStep(
    "node info",
    {"who": "node info"},
    Text(
        en="who: `node info` takes a node and lists its topics. Asked is the other way round.",
        ko="who: `node info`는 노드 하나의 토픽을 보여 줍니다. 여기에 필요한 것은 그 반대입니다.",
    ),
    part="who",
)

MESSAGES_FOR_NODES = WrongStep(
    "messages for nodes",
    {"who": "echo"},
    Text(
        en="who: `topic echo` prints messages, and a message does not say who sent it.",
        ko="who: `topic echo`는 메시지를 출력합니다. 메시지에는 보낸 노드가 적혀 있지 않습니다.",
    ),
    part="who",
)

RATE_FOR_NODES = WrongStep(
    "rate for nodes",
    {"who": "hz"},
    Text(
        en="who: `topic hz` counts messages, whoever sent them.",
        ko="who: `topic hz`는 누가 보냈든 메시지의 수만 셉니다.",
    ),
    part="who",
)


TASK = Task(
    id="E11.7",
    kind="C",
    points=2,
    title=Text(en="Three commands", ko="명령 세 개"),
    answer="commands",
    form=Parts({"value": Command(), "late": Command(), "who": Command()}),
    given=frames_and_rate,
    variants=6,
    model=lines,
    mistakes=(
        OTHER_WAY_ROUND,
        RATE_FORGOTTEN,
        RATE_AS_AN_OPTION,
        ALL_FRAMES,
        CHAIN_TURNED_ROUND,
        CLOCK_FORGOTTEN,
        PARAMETER_BARE,
        CLOCK_SWITCHED_OFF,
        PERIOD_FOR_RATE,
        RATE_AS_A_SHORT_OPTION,
        ROS_ARGS_FORGOTTEN,
        EQUALS_SIGN,
        ECHO_OF_TOOLS,
        TOPIC_FOR_A_POSE,
        MONITOR_OF_TOOLS,
        DELAY_OF_A_MESSAGE,
        TREE_FOR_A_DELAY,
        CLOCK_OPTION,
        NODE_INFO,
        MESSAGES_FOR_NODES,
        RATE_FOR_NODES,
        ONE_FOR_TRUE,
        ONLY_COUNTS,
        LIST_OF_TOPICS,
        LIST_OF_NODES,
        OTHER_TOPIC,
    ),
    hints=(
        Text(
            en="The page's section for the real robot has one of each kind.",
            ko="본문의 '실제 로봇에서'에 종류마다 하나씩 있습니다.",
        ),
        Text(
            en="tf2_echo: the frame to look *from* stands first, then the other, then the rate.",
            ko="tf2_echo에는 기준이 되는 좌표계를 먼저, 다음에 다른 좌표계, 마지막에 1초에 몇 번인지를 씁니다.",
        ),
        Text(
            en="Parameters of a node follow --ros-args, each after a -p, name:=value.",
            ko="노드의 파라미터는 --ros-args 다음에, 저마다 -p를 붙여 이름:=값으로 씁니다.",
        ),
    ),
    misconceptions=("M1", "M13"),
)
