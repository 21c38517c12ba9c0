"""Actions of example_interfaces, in process."""

from tflab.ros.messages.example_interfaces import Fibonacci as Fibonacci
