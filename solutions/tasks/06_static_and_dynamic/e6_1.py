"""E6.1: Board or radio?"""

from __future__ import annotations

from tflab.workbook.tasks import Choice, Parts, Sequence, define_task

BOARD, RADIO = "/tf_static", "/tf"
RIGHT = {
    "cart": [RADIO, BOARD, RADIO],
    "scout": [BOARD, RADIO, BOARD],
    "arm": [RADIO, BOARD, BOARD],
    "drone": [RADIO, RADIO, BOARD],
}


def assign_topics(_given, *, wheels=RADIO, laser=BOARD, corrections=RADIO, imu=BOARD, ramp=RADIO, optical=BOARD,
               shoulder=RADIO, flange=BOARD, tcp=BOARD, flight=RADIO, gimbal=RADIO, camera=BOARD):  # fmt: skip
    """Return each robot's topics, edge by edge; another topic is a mistake."""
    return {
        "cart": [wheels, laser, corrections],
        "scout": [imu, ramp, optical],
        "arm": [shoulder, flange, tcp],
        "drone": [flight, gimbal, camera],
    }


TASK = define_task(
    __file__,
    kind="M",
    points=4,
    answer="topics",
    form=Parts({robot: Sequence(Choice((BOARD, RADIO))) for robot in RIGHT}),
    model=assign_topics,
)
