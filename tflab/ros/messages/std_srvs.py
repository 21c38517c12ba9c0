"""Define std_srvs."""

from .base import service

Empty = service("std_srvs/srv/Empty")

SetBool = service(
    "std_srvs/srv/SetBool",
    request="bool data",
    response="""
        bool success
        string message
    """,
)

Trigger = service(
    "std_srvs/srv/Trigger",
    response="""
        bool success
        string message
    """,
)
