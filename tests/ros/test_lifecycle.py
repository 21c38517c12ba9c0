"""Managed nodes: transitions, callbacks and services."""

import pytest

from tflab.ros import client_library as rclpy
from tflab.ros.executors import SingleThreadedExecutor
from tflab.ros.lifecycle import LifecycleNode, SimpleManagedEntity
from tflab.ros.lifecycle_states import TransitionCallbackReturn
from tflab.ros.messages.lifecycle_msgs import (
    ChangeState,
    GetAvailableStates,
    GetAvailableTransitions,
    GetState,
    Transition,
    TransitionEvent,
)
from tflab.ros.messages.std_msgs import String
from tflab.ros.node import Node

SUCCESS, FAILURE, ERROR = TransitionCallbackReturn


@pytest.fixture(autouse=True)
def begun(graph):
    rclpy.init()
    yield
    rclpy.shutdown()


def state_of(node):
    return node._state_machine.current_state[1]


def ask(node, srv_type, name, request=None):
    """Put one question to a service of `node`, from another node."""
    asking = Node("asking")
    executor = SingleThreadedExecutor()
    for each in (node, asking):
        executor.add_node(each)
    client = asking.create_client(srv_type, f"/{node.get_name()}/{name}")
    future = client.call_async(request or srv_type.Request())
    executor.spin_until_future_complete(future, timeout_sec=1.0)
    executor.shutdown()
    asking.destroy_node()
    return future.result()


class Talker(LifecycleNode):
    """Answers what it was told to answer, and remembers what it was asked."""

    def __init__(self, **answers):
        super().__init__("talker")
        self.answers = answers
        self.asked = []

    def _answer(self, name, state):
        self.asked.append((name, state.label))
        answer = self.answers.get(name, SUCCESS)
        if isinstance(answer, Exception):
            raise answer
        return answer

    def on_configure(self, state):
        return self._answer("on_configure", state)

    def on_activate(self, state):
        return self._answer("on_activate", state)

    def on_error(self, state):
        return self._answer("on_error", state)


def test_a_managed_node_goes_through_its_states_and_back_and_announces_each_step():
    node, listener, heard, seen = LifecycleNode("talker"), Node("listener"), [], []
    listener.create_subscription(
        TransitionEvent,
        "/talker/transition_event",
        lambda event: heard.append((event.start_state.label, event.goal_state.label)),
        20,
    )
    for way in ("configure", "activate", "deactivate", "cleanup", "configure", "shutdown"):
        assert getattr(node, f"trigger_{way}")() is SUCCESS
        seen.append(state_of(node))
    assert seen == ["inactive", "active", "inactive", "unconfigured", "inactive", "finalized"]
    assert node.trigger_shutdown() is None
    for _ in range(2):
        rclpy.spin_once(listener, timeout_sec=0)
    assert heard == [("unconfigured", "configuring"), ("configuring", "inactive")]


def test_a_callback_receives_the_previous_state_and_a_failure_leads_back_to_it(capsys):
    node = Talker(on_activate=FAILURE)
    assert (node.trigger_activate(), state_of(node)) == (ERROR, "unconfigured")  # not from there
    logged = capsys.readouterr().err
    assert "[rcl_lifecycle]: No transition matching 3 found for current state unconfigured" in logged
    assert "[talker]: Unable to start transition 3 from current state (1, 'unconfigured')" in logged
    node.trigger_configure()
    assert (node.trigger_activate(), state_of(node)) == (FAILURE, "inactive")
    assert node.asked == [("on_configure", "unconfigured"), ("on_activate", "inactive")]
    for recovery, state in ((SUCCESS, "unconfigured"), (FAILURE, "finalized"), (ERROR, "finalized")):
        node = Talker(on_configure=ERROR, on_error=recovery)
        assert (node.trigger_configure(), state_of(node)) == (ERROR, state)


@pytest.mark.parametrize(
    ("answer", "text"),
    [
        (ValueError("no port"), "Original error: ValueError: no port"),
        (None, "Original error: TypeError: on_configure() returned None; return TransitionCallbackReturn.SUCCESS"),
    ],
)
def test_an_exception_or_missing_return_value_of_a_callback_is_logged_as_error(capsys, answer, text):
    node = Talker(on_configure=answer)
    assert (node.trigger_configure(), state_of(node)) == (ERROR, "unconfigured")
    logged = capsys.readouterr().err
    assert "[talker]: Caught exception in callback for transition 10" in logged
    assert text in logged


def test_its_services_change_the_state():
    node = LifecycleNode("talker")
    by_id = ChangeState.Request(transition=Transition(id=Transition.TRANSITION_CONFIGURE))
    assert ask(node, ChangeState, "change_state", by_id).success
    by_label = ChangeState.Request(transition=Transition(label="activate"))
    assert ask(node, ChangeState, "change_state", by_label).success
    state = ask(node, GetState, "get_state").current_state
    assert (state.id, state.label) == (3, "active")
    for impossible in (Transition(id=1), Transition(label="configure")):
        assert not ask(node, ChangeState, "change_state", ChangeState.Request(transition=impossible)).success
    alone = LifecycleNode("alone", enable_communication_interface=False)
    assert not [service for service in alone.services if service.srv_name.endswith("_state")]
    assert alone.trigger_configure() is SUCCESS
    with pytest.raises(TypeError, match="must be a bool, not 'no'"):
        LifecycleNode("other", enable_communication_interface="no")


def test_its_services_list_states_and_transitions():
    node = LifecycleNode("talker")
    node.trigger_configure()
    states = ask(node, GetAvailableStates, "get_available_states").available_states
    assert [(state.id, state.label) for state in states] == [
        (0, "unknown"), (1, "unconfigured"), (2, "inactive"), (3, "active"), (4, "finalized"), (10, "configuring"),
        (11, "cleaningup"), (12, "shuttingdown"), (13, "activating"), (14, "deactivating"), (15, "errorprocessing"),
    ]  # fmt: skip
    ways = ask(node, GetAvailableTransitions, "get_available_transitions").available_transitions
    assert [(way.transition.id, way.transition.label, way.goal_state.label) for way in ways] == [
        (2, "cleanup", "cleaningup"), (3, "activate", "activating"), (6, "shutdown", "shuttingdown"),
    ]  # fmt: skip
    graph = ask(node, GetAvailableTransitions, "get_transition_graph").available_transitions
    assert [way.transition.id for way in graph] == [
        1, 10, 11, 12, 2, 20, 21, 22, 3, 30, 31, 32, 4, 40, 41, 42, 5, 6, 7, 50, 51, 52, 60, 61, 62,
    ]  # fmt: skip


def test_a_lifecycle_publisher_is_silent_unless_its_node_is_active():
    node, listener = LifecycleNode("talker"), Node("listener")
    heard = []
    listener.create_subscription(String, "/chatter", lambda message: heard.append(message.data), 10)
    publisher = node.create_lifecycle_publisher(String, "chatter", 10)
    publisher.publish(String(data="unconfigured"))
    node.trigger_configure()
    publisher.publish(String(data="inactive"))
    node.trigger_activate()
    publisher.publish(String(data="active"))
    node.trigger_deactivate()
    publisher.publish(String(data="inactive again"))
    for _ in range(3):
        rclpy.spin_once(listener, timeout_sec=0)
    assert heard == ["active"]
    assert not publisher.is_activated
    assert node.destroy_lifecycle_publisher(publisher)
    with pytest.raises(TypeError, match="unexpected keyword argument 'publisher_class'"):
        node.create_lifecycle_publisher(String, "chatter", 10, publisher_class=None)


def test_a_managed_entity_follows_the_node_and_can_refuse():
    class Motor(SimpleManagedEntity):
        def __init__(self):
            super().__init__()
            self.turns = []

        def on_configure(self, state):
            return FAILURE if state.label == "unconfigured" and not self.turns else SUCCESS

        @SimpleManagedEntity.when_enabled
        def turn(self, angle):
            self.turns.append(angle)

        @SimpleManagedEntity.when_enabled(when_not_enabled=lambda: refused.append("stop"))
        def stop(self):
            self.turns.append("stop")

    refused = []
    node, motor = LifecycleNode("driver"), Motor()
    node.add_managed_entity(motor)
    assert (node.trigger_configure(), state_of(node)) == (FAILURE, "unconfigured")
    motor.turns.append("by hand")
    node.trigger_configure()
    motor.turn(1)
    motor.stop()
    node.trigger_activate()
    motor.turn(2)
    motor.stop()
    assert motor.turns == ["by hand", 2, "stop"]
    assert refused == ["stop"]
