"""rclpy.exceptions"""

from tflab.ros.exceptions import (
    InvalidHandle as InvalidHandle,
    InvalidNamespaceException as InvalidNamespaceException,
    InvalidNodeNameException as InvalidNodeNameException,
    InvalidParameterException as InvalidParameterException,
    InvalidParameterTypeException as InvalidParameterTypeException,
    InvalidParameterValueException as InvalidParameterValueException,
    InvalidServiceNameException as InvalidServiceNameException,
    InvalidTopicNameException as InvalidTopicNameException,
    NameValidationException as NameValidationException,
    NotInitializedException as NotInitializedException,
    NoTypeSupportImportedException as NoTypeSupportImportedException,
    ParameterAlreadyDeclaredException as ParameterAlreadyDeclaredException,
    ParameterException as ParameterException,
    ParameterImmutableException as ParameterImmutableException,
    ParameterNotDeclaredException as ParameterNotDeclaredException,
    ParameterUninitializedException as ParameterUninitializedException,
    ROSInterruptException as ROSInterruptException,
)
