"""unique_identifier_msgs, in process: see tflab.ros.messages.unique_identifier_msgs."""
