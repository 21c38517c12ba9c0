"""E10.2: The smallest recording."""

from __future__ import annotations

from tflab.workbook.tasks import Command, Parts, Task, Text, WrongAnswer, WrongStep

SENSORS = ("/scan", "/front/scan", "/rear/scan", "/lidar/points", "/depth/points", "/radar/points", "/sonar/range")
ODOMETRY = ("/wheel/odom", "/base/odometry", "/encoders/odom", "/drive/odom")


def three_robots(rng):
    """Draw a sensor for each robot, and where the third one's wheels speak."""
    sensors = [SENSORS[i] for i in rng.permutation(len(SENSORS))[:3]]
    return {
        "sensor": dict(zip("abc", sensors, strict=True)),
        "wheels": {"c": ODOMETRY[int(rng.integers(len(ODOMETRY)))]},
    }


def lines(
    g, sensor=True, mounts=True, moving="/tf", sim_clock=True, real_clock=False, wheels="message", everything=False,
    map_too=False,
):  # fmt: skip
    """Return the three lines, step by step."""
    speaks = g.wheels["c"]
    for_c = {"message": [speaks], "none": [], "transform": ["/tf"], "by habit": ["/odom"], "both": [speaks, "/tf"]}[
        wheels
    ]
    topics = {"a": [moving], "b": [moving], "c": for_c}
    answers = {}
    for letter, more in topics.items():
        has_clock = sim_clock if letter == "b" else real_clock
        row = [g.sensor[letter]] * sensor + [topic for topic in more if topic] + ["/tf_static"] * mounts
        row += ["--clock" if has_clock == "option" else "/clock"] * bool(has_clock) + ["/map"] * (
            map_too and letter != "c"
        )
        answers[letter] = "ros2 bag record " + ("-a" if everything else " ".join(row))
    return answers


NO_MOUNTS = WrongStep(
    "no mounts",
    {"mounts": False},
    Text(
        en="/tf_static is missing. Tomorrow nobody says any more where the sensor is bolted on.",
        ko="/tf_static이 없습니다. 내일은 센서가 어디에 달려 있는지 알려 줄 노드가 없습니다.",
    ),
    "M13",
    partly=True,
)

NO_TF = WrongStep(
    "no tf",
    {"moving": ""},
    Text(
        en="/tf is missing: the mounts alone do not tell where the robot was at each moment.",
        ko="/tf가 없습니다. 장착 변환만으로는 순간마다 로봇이 어디에 있었는지 알 수 없습니다.",
    ),
    "M13",
    partly=True,
)

ODOM_FOR_TF = WrongStep(
    "odom for tf",
    {"moving": "/odom"},
    Text(
        en="/odom stands in a or b where /tf should: a message about the pose is no transform, and a buffer does not listen to it.",
        ko="a나 b에서 /tf 대신 /odom을 적었습니다. 포즈를 담은 메시지는 변환이 아니고, 버퍼는 그것을 듣지 않습니다.",
    ),
    "M13",
    partly=True,
)

EVERYTHING = WrongStep(
    "everything",
    {"everything": True},
    Text(
        en="-a records all: cameras fill a disk in minutes. Asked for is the smallest recording.",
        ko="-a는 모두 기록합니다. 카메라가 몇 분이면 디스크를 채웁니다. 필요한 것은 가장 작은 기록입니다.",
    ),
    partly=True,
)

CLOCK_OF_A_REAL_ROBOT = WrongStep(
    "clock of a real robot",
    {"real_clock": True},
    Text(
        en="You record /clock on a real robot. Nobody publishes one there; the player makes it from the times of receipt.",
        ko="실제 로봇에서 /clock을 기록합니다. 거기에는 발행하는 노드가 없습니다. 재생기가 수신 시각으로 만들어 줍니다.",
    ),
    "M13",
    partly=True,
)

NO_CLOCK_OF_THE_SIMULATION = WrongStep(
    "no clock of the simulation",
    {"sim_clock": False},
    Text(
        en="b is a simulation, and its time is a topic like the others. Asked for was also to keep how fast it ran.",
        ko="b는 시뮬레이션이고, 그 시간도 다른 것처럼 토픽입니다. 시간이 어떻게 흘렀는지도 남겨야 합니다.",
    ),
    "M13",
    part="b",
)

CLOCK_AS_AN_OPTION = WrongStep(
    "clock as an option",
    {"sim_clock": "option"},
    Text(
        en="b: `--clock` is an option of `ros2 bag play`, which makes a clock. To record the one that the simulation publishes, its topic stands in the line, as the others do.",
        ko="b: `--clock`은 시계를 만드는 `ros2 bag play`의 옵션입니다. 시뮬레이션이 발행하는 시계를 기록하려면 다른 것처럼 그 토픽을 적습니다.",
    ),
    "M13",
    part="b",
)

NO_SENSOR = WrongStep(
    "no sensor",
    {"sensor": False},
    Text(
        en="The sensor itself is missing: there would be places, and nothing to put there.",
        ko="센서 자체가 빠졌습니다. 자리는 있는데 놓을 것이 없습니다.",
    ),
    partly=True,
)

NO_WHEELS = WrongStep(
    "no wheels",
    {"wheels": "none"},
    Text(
        en="c: a localiser compares what the sensor sees with how far the wheels rolled. Where do these wheels speak?",
        ko="c: 위치 추정은 센서가 본 것과 바퀴가 굴러간 거리를 견줍니다. 이 바퀴는 어디로 발행합니까?",
    ),
    "M13",
    part="c",
)

TF_FOR_THE_WHEELS = WrongStep(
    "tf for the wheels",
    {"wheels": "transform"},
    Text(
        en="c: nobody publishes on /tf there, so you would record an empty topic, and not what the wheels say.",
        ko="c: 이 로봇에서는 아무도 /tf를 발행하지 않습니다. 빈 토픽만 기록되고 바퀴의 오도메트리는 남지 않습니다.",
    ),
    "M13",
    part="c",
)

TF_BESIDE_THE_WHEELS = WrongStep(
    "tf beside the wheels",
    {"wheels": "both"},
    Text(
        en="c: one topic more than it takes. Who would publish on it, with the localiser off and the wheels on a topic of their own?",
        ko="c: 필요 없는 토픽이 하나 있습니다. 위치 추정은 꺼져 있고 바퀴는 자기 토픽으로 발행하는데, 거기에 누가 발행합니까?",
    ),
    part="c",
    partly=True,
)

THE_MAP_TOO = WrongStep(
    "the map too",
    {"map_too": True},
    Text(
        en="You record the map as well. A picture of the room does not say where the robot was in it; the transforms do.",
        ko="지도까지 기록합니다. 방의 그림은 로봇이 그 안의 어디에 있었는지 알려 주지 않습니다. 변환이 알려 줍니다.",
    ),
    partly=True,
)

ODOM_TOO = WrongStep(
    "odom too",
    {"moving": "/tf /odom"},
    Text(
        en="One topic more than it takes in a or b: what the wheels say is on /tf already, as a transform.",
        ko="a나 b에 필요 없는 토픽이 하나 있습니다. 바퀴의 오도메트리는 이미 변환으로 /tf에 있습니다.",
    ),
    partly=True,
)

THE_SENSOR_ALONE = WrongAnswer(
    "the sensor alone",
    lambda g: {letter: f"ros2 bag record {sensor}" for letter, sensor in g.sensor.items()},
    Text(
        en="Only the sensor: tomorrow you know what was seen, and not from where. Follow the path from the sensor to the map, edge by edge.",
        ko="센서뿐입니다. 내일은 무엇을 보았는지는 알아도 어디에서 보았는지는 모릅니다. 센서에서 지도까지 연결을 하나씩 따라가 보세요.",
    ),
    "M13",
)

THE_LECTURES_LINE = WrongAnswer(
    "the lecture's line",
    lambda g: {letter: f"ros2 bag record {sensor} /odom /tf /tf_static /clock" for letter, sensor in g.sensor.items()},
    Text(
        en="The lecture's line for all three: it is on the safe side. Which of these topics is there on each robot, and which is needed tomorrow?",
        ko="셋 모두에 강의의 명령을 썼습니다. 만일을 위한 명령입니다. 로봇마다 실제로 있는 토픽은 무엇이고, 내일 필요한 것은 무엇입니까?",
    ),
    "M13",
)

ODOM_BY_HABIT = WrongStep(
    "odom by habit",
    {"wheels": "by habit"},
    Text(
        en="c: you record /odom. Where these wheels speak stands in `e10_2.wheels`.",
        ko="c: /odom을 기록했습니다. 이 로봇의 바퀴가 어디에 발행하는지는 `e10_2.wheels`에 있습니다.",
    ),
    part="c",
)


TASK = Task(
    id="E10.2",
    kind="C",
    points=4,
    title=Text(en="The smallest recording", ko="가장 작은 기록"),
    answer="recordings",
    form=Parts({letter: Command() for letter in "abc"}),
    given=three_robots,
    variants=8,
    model=lines,
    mistakes=(
        EVERYTHING,
        NO_SENSOR,
        NO_TF,
        ODOM_FOR_TF,
        NO_WHEELS,
        TF_FOR_THE_WHEELS,
        TF_BESIDE_THE_WHEELS,
        NO_MOUNTS,
        NO_CLOCK_OF_THE_SIMULATION,
        CLOCK_AS_AN_OPTION,
        CLOCK_OF_A_REAL_ROBOT,
        THE_MAP_TOO,
        ODOM_TOO,
        THE_SENSOR_ALONE,
        THE_LECTURES_LINE,
        ODOM_BY_HABIT,
    ),
    hints=(
        Text(
            en="Write down the path from the sensor to where it is wanted. Who publishes each edge, and on which topic?",
            ko="센서에서 목표까지의 경로를 적어 보세요. 연결마다 누가 어느 토픽으로 발행합니까?",
        ),
        Text(
            en="Mounts are on one topic, motions on another. For c somebody will compute a part of the path anew: from what?",
            ko="장착 변환과 움직이는 변환은 서로 다른 토픽에 있습니다. c에서는 경로의 일부를 새로 계산합니다. 무엇으로 계산합니까?",
        ),
        Text(
            en="Time is a topic only in a simulation.",
            ko="시간이 토픽인 것은 시뮬레이션뿐입니다.",
        ),
    ),
    misconceptions=("M13",),
)
