"""rclpy.parameter"""

from tflab.ros.parameter import (
    Parameter as Parameter,
    get_parameter_value as get_parameter_value,
    parameter_dict_from_yaml_file as parameter_dict_from_yaml_file,
    parameter_value_to_python as parameter_value_to_python,
)
