"""What is wrong with this TF?  Seven questions, asked of a recording, a graph or a buffer.

    findings     what the doctor says
    evidence     what there is to judge
    gather       where the evidence comes from
    jumps        where a clock was set
    checks/      the seven questions, and their order
    diagnose     all of them, and causes apart from effects
    report/      the sentences, and how they are written down
    profile      each edge in figures
    gate/        what is expected, and the forms that machines read
    examination  the door: examine(recording | graph | buffer)
    live         a robot, through rclpy
    options      what one may ask
    command      `tflab doctor BAG`

Start with `findings.py`.
"""

from .examination import examine

__all__ = ["examine"]
