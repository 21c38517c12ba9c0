"""rclpy.qos"""

from tflab.ros.qos import (
    DurabilityPolicy as DurabilityPolicy,
    HistoryPolicy as HistoryPolicy,
    InvalidQoSProfileException as InvalidQoSProfileException,
    LivelinessPolicy as LivelinessPolicy,
    QoSDurabilityPolicy as QoSDurabilityPolicy,
    QoSHistoryPolicy as QoSHistoryPolicy,
    QoSLivelinessPolicy as QoSLivelinessPolicy,
    QoSPresetProfiles as QoSPresetProfiles,
    QoSProfile as QoSProfile,
    QoSReliabilityPolicy as QoSReliabilityPolicy,
    ReliabilityPolicy as ReliabilityPolicy,
    qos_profile_action_status_default as qos_profile_action_status_default,
    qos_profile_best_available as qos_profile_best_available,
    qos_profile_default as qos_profile_default,
    qos_profile_parameter_events as qos_profile_parameter_events,
    qos_profile_parameters as qos_profile_parameters,
    qos_profile_rosout_default as qos_profile_rosout_default,
    qos_profile_sensor_data as qos_profile_sensor_data,
    qos_profile_services_default as qos_profile_services_default,
    qos_profile_system_default as qos_profile_system_default,
    qos_profile_unknown as qos_profile_unknown,
)
from tflab.ros.qos_compatibility import (
    QoSCompatibility as QoSCompatibility,
    QoSPolicyKind as QoSPolicyKind,
    qos_check_compatible as qos_check_compatible,
    qos_policy_name_from_kind as qos_policy_name_from_kind,
)
