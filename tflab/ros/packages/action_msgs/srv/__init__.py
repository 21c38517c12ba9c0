"""action_msgs.srv"""

from tflab.ros.messages.action_msgs import CancelGoal as CancelGoal
