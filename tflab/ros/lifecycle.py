"""Provide managed (lifecycle) nodes.

```
class Scanner(LifecycleNode):
    def on_configure(self, state): ...    open the device, create publishers     -> SUCCESS
    def on_activate(self, state): ...     begin to publish; super() tells the publishers

/scanner/change_state, get_state, ...     the services by which others move it
/scanner/transition_event                 what it says when it moves
```
"""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any

from .exceptions import RCLError
from .lifecycle_states import (
    STATES,
    TRANSITIONS,
    LifecycleState,
    LifecycleTransition,
    StateMachine,
    TransitionCallbackReturn,
)
from .messages import lifecycle_msgs
from .messages.lifecycle_msgs import Transition
from .node import Node
from .topic_endpoints import Publisher

__all__ = ["LifecycleMixin", "LifecycleNode", "LifecyclePublisher", "ManagedEntity", "SimpleManagedEntity"]

SUCCESS = TransitionCallbackReturn.SUCCESS


class ManagedEntity:
    """An entity of a managed node: called at each of its transitions, with the previous state."""

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Get ready."""
        return SUCCESS

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Be as if never configured."""
        return SUCCESS

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:
        """End."""
        return SUCCESS

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Begin to work."""
        return SUCCESS

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Pause."""
        return SUCCESS

    def on_error(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Put in order what went wrong; success leads to unconfigured, anything else to finalized."""
        return SUCCESS


class SimpleManagedEntity(ManagedEntity):
    """A managed entity that knows whether its node is active."""

    def __init__(self) -> None:
        self._enabled = False

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        self._enabled = True
        return SUCCESS

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        self._enabled = False
        return SUCCESS

    @property
    def is_activated(self) -> bool:
        """Whether its node is active."""
        return self._enabled

    @staticmethod
    def when_enabled(
        wrapped: Callable[..., None] | None = None, *, when_not_enabled: Callable[[], None] | None = None
    ) -> Callable[..., Any]:
        """Decorate a method that does nothing, or calls `when_not_enabled`, unless its node is active."""

        def decorate(method: Callable[..., None]) -> Callable[..., None]:
            @wraps(method)
            def only_when_enabled(self: SimpleManagedEntity, *args: Any, **kwargs: Any) -> None:
                if self._enabled:
                    method(self, *args, **kwargs)
                elif when_not_enabled is not None:
                    when_not_enabled()

            return only_when_enabled

        return decorate if wrapped is None else decorate(wrapped)


class LifecyclePublisher(SimpleManagedEntity, Publisher):
    """A publisher that is silent unless its node is active."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        SimpleManagedEntity.__init__(self)
        Publisher.__init__(self, *args, **kwargs)

    @SimpleManagedEntity.when_enabled
    def publish(self, msg: Any) -> None:
        """Send a copy of a message if the node is active, else nothing."""
        Publisher.publish(self, msg)


def _of_all(name: str) -> Callable[[Any, LifecycleState], TransitionCallbackReturn]:
    """Return the method that calls this one of each managed entity in turn, until one does not succeed."""

    def tell(self: Any, state: LifecycleState) -> TransitionCallbackReturn:
        results = (getattr(entity, name)(state) for entity in self._managed_entities)
        return next((result for result in results if result != SUCCESS), SUCCESS)

    return tell


class LifecycleMixin(ManagedEntity):
    """What makes a Node a managed one; see LifecycleNode."""

    def __init__(self, *, enable_communication_interface: bool = True, callback_group: Any = None) -> None:
        if not isinstance(enable_communication_interface, bool):
            raise TypeError(f"enable_communication_interface must be a bool, not {enable_communication_interface!r}")
        self._state_machine = StateMachine()
        self._managed_entities: list[ManagedEntity] = []
        self._transition_events: Publisher | None = None
        if not enable_communication_interface:
            return
        for srv_type, name, callback in (
            (lifecycle_msgs.ChangeState, "change_state", self._on_change_state),
            (lifecycle_msgs.GetState, "get_state", self._on_get_state),
            (lifecycle_msgs.GetAvailableStates, "get_available_states", self._on_get_available_states),
            (lifecycle_msgs.GetAvailableTransitions, "get_available_transitions", self._on_get_available_transitions),
            (lifecycle_msgs.GetAvailableTransitions, "get_transition_graph", self._on_get_transition_graph),
        ):
            self.create_service(srv_type, f"~/{name}", callback, callback_group=callback_group)
        self._transition_events = self.create_publisher(lifecycle_msgs.TransitionEvent, "~/transition_event", 10)

    # -- moved from within ----------------------------------------------------------------

    def trigger_configure(self) -> TransitionCallbackReturn:
        """Go from unconfigured to inactive."""
        return self._change_state(Transition.TRANSITION_CONFIGURE)

    def trigger_cleanup(self) -> TransitionCallbackReturn:
        """Go from inactive back to unconfigured."""
        return self._change_state(Transition.TRANSITION_CLEANUP)

    def trigger_activate(self) -> TransitionCallbackReturn:
        """Go from inactive to active."""
        return self._change_state(Transition.TRANSITION_ACTIVATE)

    def trigger_deactivate(self) -> TransitionCallbackReturn:
        """Go from active back to inactive."""
        return self._change_state(Transition.TRANSITION_DEACTIVATE)

    def trigger_shutdown(self) -> TransitionCallbackReturn | None:
        """Go to finalized; return None from where there is no way."""
        ways = [step for step in self._state_machine.available_transitions if step.label == "shutdown"]
        return self._change_state(ways[0].transition_id) if ways else None

    # -- what it tells its entities ---------------------------------------------------------

    on_configure = _of_all("on_configure")
    on_cleanup = _of_all("on_cleanup")
    on_shutdown = _of_all("on_shutdown")
    on_activate = _of_all("on_activate")
    on_deactivate = _of_all("on_deactivate")
    on_error = _of_all("on_error")

    # -- its entities -------------------------------------------------------------------------

    def add_managed_entity(self, entity: ManagedEntity) -> None:
        """Let something go along with every transition."""
        if entity not in self._managed_entities:
            self._managed_entities.append(entity)

    def create_lifecycle_publisher(self, *args: Any, **kwargs: Any) -> LifecyclePublisher:
        """Return a new publisher, silent unless this node is active; arguments as create_publisher."""
        if "publisher_class" in kwargs:
            raise TypeError("create_publisher() got an unexpected keyword argument 'publisher_class'")
        publisher = self.create_publisher(*args, **kwargs, publisher_class=LifecyclePublisher)
        self.add_managed_entity(publisher)
        return publisher

    def destroy_lifecycle_publisher(self, publisher: LifecyclePublisher) -> bool:
        """Destroy such a publisher of this node; return whether it was one."""
        if publisher in self._managed_entities:
            self._managed_entities.remove(publisher)
        return self.destroy_publisher(publisher)

    # -- inside ---------------------------------------------------------------------------------

    def _change_state(self, transition_id: int) -> TransitionCallbackReturn:
        """Make a transition, call its callback, and go where that leads; an error asks on_error where to."""
        before = self._state_machine.state
        try:
            step = self._state_machine.find(transition_id)
        except RCLError:
            self.get_logger().error(
                f"Unable to start transition {transition_id} from current state {self._state_machine.current_state}"
            )
            return TransitionCallbackReturn.ERROR
        self._go(step)
        result = self._call_back(before)
        self._go(self._state_machine.find(result.to_label()))
        if result is TransitionCallbackReturn.ERROR:
            self._go(self._state_machine.find(self._call_back(before).to_label()))
        return result

    def _go(self, step: LifecycleTransition) -> None:
        self._state_machine.state = step.goal
        if self._transition_events is not None:
            start, goal = _state_message(step.start), _state_message(step.goal)
            self._transition_events.publish(lifecycle_msgs.TransitionEvent(start_state=start, goal_state=goal))

    def _call_back(self, before: LifecycleState) -> TransitionCallbackReturn:
        """Call the callback of the present state; what it raises is an error, and stands in the log."""
        name = _CALLBACKS[self._state_machine.state.label]
        try:
            result = getattr(self, name)(before)
            if not isinstance(result, TransitionCallbackReturn):
                raise TypeError(
                    f"{name}() returned {result!r}; return TransitionCallbackReturn.SUCCESS (or FAILURE, ERROR)"
                )
        except Exception as error:
            # rclpy says nothing here, and the mistake is lost; rclcpp logs these words.
            self.get_logger().error(f"Caught exception in callback for transition {self._state_machine.state.state_id}")
            self.get_logger().error(f"Original error: {type(error).__name__}: {error}")
            return TransitionCallbackReturn.ERROR
        return result

    def _on_change_state(self, request: Any, response: Any) -> Any:
        wanted = request.transition.id
        if request.transition.label:
            try:
                wanted = self._state_machine.find(request.transition.label).transition_id
            except RCLError:
                return response
        response.success = self._change_state(wanted) is SUCCESS
        return response

    def _on_get_state(self, request: Any, response: Any) -> Any:
        response.current_state = _state_message(self._state_machine.state)
        return response

    def _on_get_available_states(self, request: Any, response: Any) -> Any:
        response.available_states = [_state_message(state) for state in STATES]
        return response

    def _on_get_available_transitions(self, request: Any, response: Any) -> Any:
        response.available_transitions = [_description(step) for step in self._state_machine.available_transitions]
        return response

    def _on_get_transition_graph(self, request: Any, response: Any) -> Any:
        response.available_transitions = [_description(step) for step in TRANSITIONS]
        return response


class LifecycleNode(LifecycleMixin, Node):
    """A managed node; `options` are those of Node.

    Args:
        enable_communication_interface: whether others can move it, by its services.
    """

    def __init__(self, node_name: str, *, enable_communication_interface: bool = True, **options: Any) -> None:
        Node.__init__(self, node_name, **options)
        LifecycleMixin.__init__(self, enable_communication_interface=enable_communication_interface)


_CALLBACKS = {
    "configuring": "on_configure",
    "cleaningup": "on_cleanup",
    "shuttingdown": "on_shutdown",
    "activating": "on_activate",
    "deactivating": "on_deactivate",
    "errorprocessing": "on_error",
}


def _state_message(state: LifecycleState) -> lifecycle_msgs.State:
    return lifecycle_msgs.State(id=state.state_id, label=state.label)


def _description(step: LifecycleTransition) -> lifecycle_msgs.TransitionDescription:
    return lifecycle_msgs.TransitionDescription(
        transition=Transition(id=step.transition_id, label=step.label),
        start_state=_state_message(step.start),
        goal_state=_state_message(step.goal),
    )
