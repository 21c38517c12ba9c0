"""How are a node's parameters reached from outside?  Services below its name.

/node/get_parameters, set_parameters, list_parameters, ...    as `ros2 param` calls them
"""

from __future__ import annotations

from typing import Any

from .exceptions import ParameterNotDeclaredException
from .messages import rcl_interfaces
from .parameter import Parameter
from .qos import qos_profile_parameters

__all__ = ["ParameterService"]


class ParameterService:
    """The services that every node offers."""

    def __init__(self, node: Any) -> None:
        self._node = node
        for srv_type, name, callback in (
            (rcl_interfaces.DescribeParameters, "describe_parameters", self._describe),
            (rcl_interfaces.GetParameters, "get_parameters", self._get),
            (rcl_interfaces.GetParameterTypes, "get_parameter_types", self._get_types),
            (rcl_interfaces.ListParameters, "list_parameters", self._list),
            (rcl_interfaces.SetParameters, "set_parameters", self._set),
            (rcl_interfaces.SetParametersAtomically, "set_parameters_atomically", self._set_atomically),
        ):
            node.create_service(srv_type, f"~/{name}", callback, qos_profile=qos_profile_parameters)

    def _describe(self, request: Any, response: Any) -> Any:
        try:
            response.descriptors = self._node.describe_parameters(request.names)
        except ParameterNotDeclaredException:
            response.descriptors = []
        return response

    def _get(self, request: Any, response: Any) -> Any:
        try:
            values = [self._node._parameters[name].get_parameter_value() for name in request.names]
        except KeyError:
            values = (
                []
                if not self._node._allow_undeclared_parameters
                else [self._node.get_parameter_or(name).get_parameter_value() for name in request.names]
            )
        response.values = values
        return response

    def _get_types(self, request: Any, response: Any) -> Any:
        try:
            response.types = [self._node.get_parameter_type(name).value for name in request.names]
        except ParameterNotDeclaredException:
            response.types = []
        return response

    def _list(self, request: Any, response: Any) -> Any:
        response.result = self._node.list_parameters(request.prefixes, request.depth)
        return response

    def _set(self, request: Any, response: Any) -> Any:
        for message in request.parameters:
            try:
                result = self._node.set_parameters_atomically([Parameter.from_parameter_msg(message)])
            except ParameterNotDeclaredException as error:
                result = rcl_interfaces.SetParametersResult(successful=False, reason=str(error))
            response.results.append(result)
        return response

    def _set_atomically(self, request: Any, response: Any) -> Any:
        try:
            response.result = self._node.set_parameters_atomically(
                [Parameter.from_parameter_msg(message) for message in request.parameters]
            )
        except ParameterNotDeclaredException as error:
            response.result = rcl_interfaces.SetParametersResult(successful=False, reason=str(error))
        return response
