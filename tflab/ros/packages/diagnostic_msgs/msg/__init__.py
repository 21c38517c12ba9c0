"""Messages of diagnostic_msgs, in process."""

from tflab.ros.messages.diagnostic_msgs import (
    DiagnosticArray as DiagnosticArray,
    DiagnosticStatus as DiagnosticStatus,
    KeyValue as KeyValue,
)
