"""Define a task by its Python file and the YAML file beside it.

e3_2.py      what is computed: inputs, the model, the form, some wrong answers
e3_2.yaml    what is text or literal: title, hints, mistakes

title: {en: ..., ko: ...}
hints:                       three, coarse to fine
  - {en: ..., ko: ...}
misconceptions: [M1, M3]
mistakes:                    their order decides: the first that fits explains an answer
  - name: swapped
    at: {product: inverted}  arguments of the model; `combines: false` if it is never made with another
    misconception: M1
    part: map
    en: ...
    ko: ...
  - name: all zero
    answer: [0, 0]           a value instead; without `at` and `answer`, it is ANSWERS["all zero"]
    en: ...
    ko: ...
means, shows, seen: {option or part: {en: ..., ko: ...}}
equivalent: {mutant: why it is right}
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Collection, Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

from ...text import LANGUAGES, TextError, compose_yaml, text_of_node
from ..answers.forms import Form, Parts
from .misconceptions import MISCONCEPTIONS
from .task import Task, TaskError, WrongAnswer, WrongStep

if TYPE_CHECKING:
    import yaml

__all__ = ["define_task"]

TEXTS = ("means", "shows", "seen")
KEYS = ("title", "hints", "misconceptions", "mistakes", *TEXTS, "equivalent")
MISTAKE_KEYS = ("name", "at", "combines", "answer", "misconception", "part", "partly", *LANGUAGES)


def define_task(
    module_file: str,
    *,
    form: Form,
    model: Callable[..., Any] | None = None,
    answers: Mapping[str, Any] | None = None,
    **fields: Any,
) -> Task:
    """Return the task of a module `e3_2.py`, with its texts and mistakes from `e3_2.yaml`.

    Args:
        module_file: `__file__` of the module.
        form: of the answer.
        model: the answer by steps; `at` of a mistake names its keyword arguments.
        answers: by the name of a mistake, what is computed for it: a value, or a function as of a WrongAnswer.
        fields: what else a Task has.

    Raises:
        TaskError: the YAML file is faulty; the message begins with its name and the line.
    """
    path = Path(module_file).with_suffix(".yaml")
    try:
        texts = _Definition(path, form, model, answers or {}).read()
    except TextError as error:
        raise TaskError(str(error)) from None
    except FileNotFoundError:
        raise TaskError(f"there is no {path.name} next to {path.stem}.py") from None
    return Task(id=path.stem.upper().replace("_", "."), form=form, model=model, **fields, **texts)


class _Definition:
    """Reads the YAML file of one task."""

    def __init__(self, path: Path, form: Form, model: Callable[..., Any] | None, answers: Mapping[str, Any]) -> None:
        self.path = path
        self.parts = set(form.parts) if isinstance(form, Parts) else set()
        self.model = model
        parameters = inspect.signature(model).parameters.values() if model else ()
        self.steps = {each.name for each in parameters if each.default is not each.empty}
        self.answers = answers

    def read(self) -> dict[str, Any]:
        """Return the fields of the Task that the file holds."""
        root = compose_yaml(self.path)
        nodes = self.fields(root, KEYS)
        if "title" not in nodes:
            self.fail(root, "a task has a `title`")
        read = {
            "title": text_of_node(nodes["title"], self.path),
            "hints": tuple(text_of_node(node, self.path) for node in self.items(nodes.get("hints"))),
            "misconceptions": tuple(map(self.misconception, self.items(nodes.get("misconceptions")))),
            "mistakes": self.mistakes(self.items(nodes.get("mistakes"))),
        }
        for key in TEXTS:
            if key in nodes:
                read[key] = {name: text_of_node(node, self.path) for name, node in self.fields(nodes[key]).items()}
        if "equivalent" in nodes:
            read["equivalent"] = {name: node.value for name, node in self.fields(nodes["equivalent"]).items()}
        return read

    def mistakes(self, nodes: list[yaml.Node]) -> tuple[WrongAnswer | WrongStep, ...]:
        read, replies = {}, set()
        for node in nodes:
            mistake = self.mistake(node)
            if mistake.name in read:
                self.fail(node, f'two mistakes are called "{mistake.name}"')
            for text in mistake.reply:
                if text in replies:
                    self.fail(node, f'"{mistake.name}" has the reply of another mistake')
                replies.add(text)
            read[mistake.name] = mistake
        if unused := sorted(self.answers.keys() - read.keys()):
            raise TaskError(f'{self.path.name} has no mistake "{unused[0]}", which {self.path.stem}.py computes')
        return tuple(read.values())

    def mistake(self, node: yaml.Node) -> WrongAnswer | WrongStep:
        import yaml  # `import tflab` loads nothing but numpy

        nodes = self.fields(node, MISTAKE_KEYS)
        pairs = [pair for pair in node.value if pair[0].value in LANGUAGES]
        reply = text_of_node(yaml.MappingNode(node.tag, pairs, node.start_mark), self.path)
        values = {key: _value(nodes[key]) for key in ("combines", "partly", "answer") if key in nodes}
        if "name" not in nodes:
            self.fail(node, "a mistake has a `name`")
        name = nodes["name"].value
        common = {"reply": reply, "partly": values.get("partly", False)}
        if "misconception" in nodes:
            common["misconception"] = self.misconception(nodes["misconception"])
        if "part" in nodes:
            common["part"] = self.one_of(nodes["part"], self.parts, "part")
        if ("at" in nodes) + ("answer" in nodes) + (name in self.answers) != 1:
            self.fail(node, f'"{name}" has one of `at`, `answer` and an entry in ANSWERS of {self.path.stem}.py')
        if "at" not in nodes:
            return WrongAnswer(name, values["answer"] if "answer" in values else self.answers[name], **common)
        at = self.steps_at(nodes["at"])
        if values.get("combines", True):
            return WrongStep(name, at, **common)
        return WrongAnswer(name, partial(self.model, **at), **common)

    def steps_at(self, node: yaml.Node) -> dict[str, Any]:
        nodes = self.fields(node)
        for key, _ in node.value:
            self.one_of(key, self.steps, "step")
        values = {name: _value(value) for name, value in nodes.items()}
        return {name: tuple(value) if isinstance(value, list) else value for name, value in values.items()}

    def misconception(self, node: yaml.Node) -> str:
        return self.one_of(node, MISCONCEPTIONS, "misconception")

    def one_of(self, node: yaml.Node, names: Collection[str], kind: str) -> str:
        if node.value not in names:
            self.fail(node, f'there is no {kind} "{node.value}"; there is {", ".join(sorted(names)) or "none"}')
        return node.value

    def fields(self, node: yaml.Node, allowed: Collection[str] = ()) -> dict[str, yaml.Node]:
        """Return the values of a mapping by key."""
        if node.id != "mapping":
            self.fail(node, "a mapping is expected, such as `en: ...`")
        nodes: dict[str, yaml.Node] = {}
        for key, value in node.value:
            if key.value in nodes or (allowed and key.value not in allowed):
                self.fail(key, f'"{key.value}" is {"there twice" if key.value in nodes else "no key of a task"}')
            nodes[key.value] = value
        return nodes

    def items(self, node: yaml.Node | None) -> list[yaml.Node]:
        """Return the items of a list; none where there is no list."""
        if node is not None and node.id != "sequence":
            self.fail(node, "a list is expected")
        return node.value if node is not None else []

    def fail(self, node: yaml.Node, wrong: str) -> NoReturn:
        raise TaskError(f"{self.path.name}, line {node.start_mark.line + 1}: {wrong}")


def _value(node: yaml.Node) -> Any:
    """Return the value of a node: a number, a string, a list or a mapping."""
    from yaml.constructor import SafeConstructor

    return SafeConstructor().construct_document(node)
