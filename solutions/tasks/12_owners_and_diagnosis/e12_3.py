"""E12.3: The first question."""

from __future__ import annotations

from tflab.clinic.trolley import TROLLEY
from tflab.workbook.tasks import Parts, Task, Telling, Text, WrongAnswer

OTHERS = ("longer timeout", "read the code")
CHECKS = (*TROLLEY, *OTHERS)
RIGHT = {
    "no frame map": "node list",
    "odom stands alone": "publish_tf",
    "robot to and fro": "echo odom base_footprint",
    "scan beside the walls": "echo base_link laser_frame",
    "walls smear in bends": "delay /scan",
    "into the future": "delay /scan",
    "localizer silent": "use_sim_time",
    "unknown frame": "scan header",
    "static late joiner": "info /tf_static",
    "slow robot": "hz /odom",
}
SUSPECTS = {
    "no frame map": ("localizer not running", "localizer waits for /clock"),
    "odom stands alone": ("publish_tf off", "parent misspelt"),
    "robot to and fro": ("two owners of one edge", "wheel bad"),
    "scan beside the walls": ("mount wrong", "map wrong"),
    "walls smear in bends": ("laser clock behind", "mount wrong"),
    "into the future": ("laser clock ahead", "transforms late"),
    "localizer silent": ("localizer waits for /clock", "localizer waits for a scan"),
    "unknown frame": ("header says another frame", "mount never sent"),
    "static late joiner": ("mount volatile", "mount never sent"),
    "slow robot": ("odometry slow", "scan slow"),
}


def but(*symptoms, check):
    return {**RIGHT, **dict.fromkeys(symptoms, check)}


CABLE = WrongAnswer(
    "cable first",
    but(*RIGHT, check="other cable"),
    Text(
        en="Half an hour, and a cable is neither of the two suspects. Ask a question for a minute first.",
        ko="30분이 걸리는데 두 용의자 가운데 케이블은 없습니다. 먼저 1분짜리 질문을 하십시오.",
    ),
    "M15",
    partly=True,
)

TIMEOUT = WrongAnswer(
    "timeout first",
    but(*RIGHT, check="longer timeout"),
    Text(
        en="A timeout asks nothing, it only hides. What comes late will come; what never comes, or is stamped wrong, stays so.",
        ko="timeout은 질문이 아니라 가림막입니다. 늦는 것은 오겠지만, 오지 않는 것과 시각이 틀린 것은 그대로입니다.",
    ),
    "M10",
    partly=True,
)

CODE = WrongAnswer(
    "code first",
    but(*RIGHT, check="read the code"),
    Text(
        en="The lecture says it in its last line: facts from the graph first, then code. Which tool shows the fact?",
        ko="강의 27절의 마지막 줄입니다. 코드보다 그래프의 사실이 먼저입니다. 그 사실을 보여 주는 도구는 무엇입니까?",
    ),
    partly=True,
)

MONITOR_FOR_OWNERS = WrongAnswer(
    "monitor for owners",
    but("robot to and fro", check="monitor"),
    Text(
        en="tf2_monitor names nobody: every line says <no authority available>. That too many come in all it would show, after four minutes, and two are allowed. Ask for the values at 20 Hz and watch whether they alternate.",
        ko="tf2_monitor는 아무의 이름도 대지 못합니다. 줄마다 <no authority available>입니다. 모두 합쳐 너무 많이 온다는 것은 보이지만 4분이 걸리고, 허용된 것은 2분입니다. 값을 20 Hz로 물어 번갈아 나오는지 보십시오.",
    ),
    "M6",
)

MONITOR_FOR_A_SMEAR = WrongAnswer(
    "monitor for a smear",
    but("walls smear in bends", check="monitor"),
    Text(
        en="tf2_monitor measures transforms, and these are on time. It is the scan whose stamp is wrong, and the tool does not look at scans.",
        ko="tf2_monitor는 변환의 지연을 잽니다. 변환은 제때 옵니다. 시각이 틀린 것은 스캔인데, 이 도구는 스캔을 보지 않습니다.",
    ),
    "M9",
)

WHEELS_DOWN = WrongAnswer(
    "surely the wheels are down",
    but("odom stands alone", check="node list"),
    Text(
        en="/odom comes, so that node is there, in both cases. A list of names shows no switch.",
        ko="/odom이 오므로 그 노드는 어느 경우든 있습니다. 이름 목록에는 스위치가 보이지 않습니다.",
    ),
    "M11",
)

LOCALIZER_DOWN = WrongAnswer(
    "surely the localizer is down",
    but("localizer silent", check="node list"),
    Text(
        en="A node that waits is in the list as one that works is: both suspects are a localiser that runs and waits. Whose clock it lives by, no list of names shows.",
        ko="기다리는 노드도 일하는 노드처럼 목록에 나옵니다. 두 용의자 모두 실행 중이면서 기다리는 위치 추정 노드입니다. 어느 시계를 따르는지는 이름 목록에 보이지 않습니다.",
    ),
    "M11",
)

TAPE = WrongAnswer(
    "tape measure",
    but("scan beside the walls", check="tape measure"),
    Text(
        en="In the end, perhaps. But first look for a minute at what TF believes: it may not be what the drawing says.",
        ko="나중에는 필요할지도 모릅니다. 먼저 TF가 무엇을 믿는지 1분만 보십시오. 도면과 다를 수 있습니다.",
    ),
)


TASK = Task(
    id="E12.3",
    kind="D",
    points=3,
    title=Text(en="The first question", ko="첫 질문"),
    answer="first",
    form=Parts({symptom: Telling(CHECKS, suspects) for symptom, suspects in SUSPECTS.items()}),
    mistakes=(CABLE, TIMEOUT, CODE, MONITOR_FOR_OWNERS, MONITOR_FOR_A_SMEAR, WHEELS_DOWN, LOCALIZER_DOWN, TAPE),
    means={
        "rviz": Text(
            en="It shows the symptom once more: would RViz say something else for the other of the two suspects?",
            ko="증상을 다시 볼 뿐입니다. 두 용의자 가운데 누구인지에 따라 RViz에 나오는 말이 다릅니까?",
        ),
        "node list": Text(
            en="It shows who runs: is there a node more or less with one of the two suspects, and not with the other?",
            ko="누가 실행 중인지 보여 줍니다. 두 용의자 가운데 한쪽에서만 노드가 더 있거나 없습니까?",
        ),
        "echo map base_footprint": Text(
            en="It shows whether map and base hang together: would that differ between the two suspects?",
            ko="map과 base가 이어졌는지 보여 줍니다. 두 용의자에게서 다르게 나옵니까?",
        ),
        "echo odom base_footprint": Text(
            en="At 20 Hz it shows whether the wheels' edge runs smoothly: would that differ between the two suspects?",
            ko="20 Hz로 바퀴의 연결이 매끄러운지 보여 줍니다. 두 용의자에게서 다르게 나옵니까?",
        ),
        "echo base_link laser_frame": Text(
            en="It shows the mount that TF believes: would that differ between the two suspects?",
            ko="TF가 믿는 장착의 값을 보여 줍니다. 두 용의자에게서 다르게 나옵니까?",
        ),
        "echo map odom": Text(
            en="It shows the correction, and takes two minutes: would it differ between the two suspects, and is there a check of one minute?",
            ko="2분을 들여 보정을 보여 줍니다. 두 용의자에게서 다르게 나옵니까? 1분짜리는 없습니까?",
        ),
        "hz /odom": Text(
            en="It shows how often odometry speaks: would that differ between the two suspects?",
            ko="오도메트리가 얼마나 자주 오는지 보여 줍니다. 두 용의자에게서 다르게 나옵니까?",
        ),
        "hz /scan": Text(
            en="It shows how often the scan comes; a stamp or a name in it does not show: would the two suspects differ?",
            ko="스캔이 얼마나 자주 오는지만 보여 주고, 측정 시각이나 이름은 보여 주지 않습니다. 두 용의자에게서 다르게 나옵니까?",
        ),
        "delay /odom": Text(
            en="It shows the odometry's own way to you: would both suspects change it?",
            ko="오도메트리가 오는 데 걸린 시간을 보여 줍니다. 두 용의자가 모두 그것을 바꿉니까?",
        ),
        "delay /scan": Text(
            en="It holds the scan's stamp against your clock: would that differ between the two suspects?",
            ko="스캔의 측정 시각을 현재 시각과 견줍니다. 두 용의자에게서 다르게 나옵니까?",
        ),
        "scan header": Text(
            en="It shows the frame and the stamp that the scan names: would they differ between the two suspects?",
            ko="스캔에 적힌 좌표계와 측정 시각을 보여 줍니다. 두 용의자에게서 다르게 나옵니까?",
        ),
        "use_sim_time": Text(
            en="It shows in whose time the localiser lives: is that what the two suspects differ in?",
            ko="위치 추정 노드가 어느 시계를 따르는지 보여 줍니다. 두 용의자의 차이가 그것입니까?",
        ),
        "publish_tf": Text(
            en="It shows one switch of the wheels: is that what the two suspects differ in?",
            ko="바퀴 노드의 스위치 하나를 보여 줍니다. 두 용의자의 차이가 그것입니까?",
        ),
        "info /tf": Text(
            en="It counts who may speak on /tf, not who speaks, and not how: would the two suspects differ?",
            ko="/tf로 보낼 수 있는 노드를 셀 뿐, 누가 무엇을 보내는지는 보여 주지 않습니다. 두 용의자에게서 다르게 나옵니까?",
        ),
        "info /tf_static": Text(
            en="It shows who publishes mounts, and with which durability: is that what the two suspects differ in?",
            ko="장착을 발행하는 노드와 durability를 보여 줍니다. 두 용의자의 차이가 그것입니까?",
        ),
        "echo /tf_static": Text(
            en="It shows the mounts that you hear: if one is missing, does it say why?",
            ko="받은 장착을 보여 줍니다. 하나가 없을 때 그 까닭까지 알려 줍니까?",
        ),
        "view_frames": Text(
            en="Three minutes for the whole tree: the question is about one thing. Which check shows just that?",
            ko="3분을 들여 트리 전체를 봅니다. 물을 것은 하나입니다. 바로 그것을 보여 주는 검사는 무엇입니까?",
        ),
        "monitor": Text(
            en="It listens to transforms for four minutes: how late they are, and how many come in all. In what do the two suspects differ, and which check shows just that in a minute or two?",
            ko="4분 동안 변환을 듣고 얼마나 늦는지, 모두 합쳐 얼마나 자주 오는지 보여 줍니다. 두 용의자의 차이는 무엇이고, 그것을 1, 2분에 보여 주는 검사는 무엇입니까?",
        ),
        "tape measure": Text(
            en="A quarter of an hour, and it shows where the laser is, not what TF believes. What does a minute show?",
            ko="15분이 걸립니다. 레이저의 자리를 보여 줄 뿐, TF가 믿는 것은 보여 주지 않습니다. 1분으로 볼 수 있는 것은 무엇입니까?",
        ),
        "other cable": Text(
            en="Half an hour, and a cable is neither of the two suspects. What does a minute show?",
            ko="30분이 걸리는데 두 용의자 가운데 케이블은 없습니다. 1분으로 볼 수 있는 것은 무엇입니까?",
        ),
        "longer timeout": Text(
            en="A timeout asks nothing. Which check shows a fact?",
            ko="timeout은 아무것도 묻지 않습니다. 사실을 보여 주는 검사는 무엇입니까?",
        ),
        "read the code": Text(
            en="Facts from the graph first, then code. Which check shows the fact?",
            ko="코드보다 그래프의 사실이 먼저입니다. 그 사실을 보여 주는 검사는 무엇입니까?",
        ),
    },
    hints=(
        Text(
            en="Name two suspects for each symptom. Which check would they answer differently?",
            ko="증상마다 용의자를 둘 떠올려 보세요. 둘의 답이 다를 검사는 무엇입니까?",
        ),
        Text(
            en="Each of the ten has a check of one or two minutes.",
            ko="열 가지 모두 1, 2분짜리 검사가 있습니다.",
        ),
        Text(
            en="What does the symptom hang on: a node, a switch, a value, a header, a rate, a delay, a durability?",
            ko="증상이 무엇에 달렸습니까? 노드, 스위치, 값, header, 발행률, 지연, durability 가운데 무엇입니까?",
        ),
    ),
    misconceptions=("M6", "M9", "M10", "M11", "M15"),
)
