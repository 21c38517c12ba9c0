"""rclpy.lifecycle.managed_entity"""

from tflab.ros.lifecycle import ManagedEntity as ManagedEntity, SimpleManagedEntity as SimpleManagedEntity
