"""Messages of unique_identifier_msgs, in process."""

from tflab.ros.messages.unique_identifier_msgs import UUID as UUID
