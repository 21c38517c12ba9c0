"""Define example_interfaces, the types of ROS 2's tutorials."""

from .base import action, message, service

AddTwoInts = service(
    "example_interfaces/srv/AddTwoInts",
    request="""
        int64 a
        int64 b
    """,
    response="int64 sum",
)

SetBool = service(
    "example_interfaces/srv/SetBool",
    request="bool data",
    response="""
        bool success
        string message
    """,
)

Trigger = service(
    "example_interfaces/srv/Trigger",
    response="""
        bool success
        string message
    """,
)

Fibonacci = action(
    "example_interfaces/action/Fibonacci",
    goal="int32 order",
    result="int32[] sequence",
    feedback="int32[] sequence",
)

Bool = message("example_interfaces/msg/Bool", "bool data")
Float64 = message("example_interfaces/msg/Float64", "float64 data")
Int64 = message("example_interfaces/msg/Int64", "int64 data")
String = message("example_interfaces/msg/String", "string data")
