"""Texts in English and Korean, written in Python or read from YAML files.

    Text(en="Not answered yet.", ko="아직 답하지 않았습니다.").say("ko")

Names, code and numbers are the same in both languages. A module that has many texts keeps
them in a YAML file of its own name, here `phrases.yaml` beside `phrases.py`:

    not_answered:
      en: Not answered yet.
      ko: 아직 답하지 않았습니다.

and reads it by `TEXTS["not_answered"].say("ko")`, where `TEXTS` is `Texts(__file__)`.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterator, Mapping
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    import yaml

__all__ = [
    "LANGUAGES",
    "Text",
    "TextError",
    "Texts",
    "capitalized",
    "compose_yaml",
    "language_of_locale",
    "language_of_tools",
    "language_of_workbook",
    "load_yaml",
    "text_of_node",
]

LANGUAGES = ("en", "ko")
ENGLISH_WORD = re.compile(r"[a-z]+(?=[ ,:;.'’-]|$)")
NAMES = ("map", "nanosec", "odom", "rclpy", "sec")  # lower case, also at the beginning of a sentence


class TextError(ValueError):
    """A file of texts is not as it has to be; the message begins with its name and the line."""


class Text(NamedTuple):
    """A text in both languages."""

    en: str
    ko: str

    def say(self, language: str, **names: object) -> str:
        """Return the text in a language, with its {names} filled in."""
        text = self.ko if language == "ko" else self.en
        return text.format(**names) if names else text

    def filled(self, **names: object) -> Text:
        """Return both texts with their {names} filled in; where a name is a Text, each language takes its own."""
        texts = []
        for language in LANGUAGES:
            own = {name: value.say(language) if isinstance(value, Text) else value for name, value in names.items()}
            texts.append(self.say(language, **own))
        return Text(*texts)

    @classmethod
    def joined(cls, *parts: Text | None, between: str = " ") -> Text:
        """Return texts one after the other, at least one; None is left out."""
        return cls(*(between.join(row) for row in zip(*filter(None, parts), strict=True)))

    def plain(self) -> dict[str, str]:
        """Return both texts as JSON has them: {"en": ..., "ko": ...}."""
        return self._asdict()


class Texts(Mapping[str, Text]):
    """The texts of a module, from the YAML file beside it; read when the first one is needed."""

    def __init__(self, module_file: str) -> None:
        """Keep the name of the file: that of the module, with the ending `.yaml`."""
        self.path = Path(module_file).with_suffix(".yaml")

    @cached_property
    def _texts(self) -> dict[str, Text]:
        root = compose_yaml(self.path)
        return {key.value: text_of_node(value, self.path) for key, value in root.value}

    def __getitem__(self, key: str) -> Text:
        return self._texts[key]

    def __iter__(self) -> Iterator[str]:
        return iter(self._texts)

    def __len__(self) -> int:
        return len(self._texts)


def load_yaml(text: str) -> Any:
    """Return what a text in YAML holds, as plain Python values.

    Raises:
        yaml.YAMLError: it is no YAML.
    """
    import yaml  # `import tflab` loads nothing but numpy

    return yaml.load(text, Loader=_loader())


def _loader() -> type[yaml.SafeLoader]:
    """Return libyaml's safe loader, ten times as fast as Python's; Python's where it is not installed."""
    import yaml

    return getattr(yaml, "CSafeLoader", yaml.SafeLoader)


def compose_yaml(path: Path) -> yaml.MappingNode:
    """Return the mapping of a YAML file as nodes, which know their lines.

    Raises:
        TextError: no YAML, no mapping, or a key that is there twice.
    """
    import yaml

    try:
        root = yaml.compose(path.read_text(encoding="utf-8"), Loader=_loader())
    except yaml.MarkedYAMLError as error:
        line = error.problem_mark.line + 1 if error.problem_mark else 1
        raise TextError(f"{path.name}, line {line}: {error.problem}") from None
    if not isinstance(root, yaml.MappingNode):
        raise TextError(f"{path.name}, line 1: a mapping is expected")
    seen: set[str] = set()
    for key, _ in root.value:
        if key.value in seen:
            raise TextError(f'{path.name}, line {key.start_mark.line + 1}: "{key.value}" is there twice')
        seen.add(key.value)
    return root


def text_of_node(node: yaml.Node, path: Path) -> Text:
    """Return the Text of a mapping with `en` and `ko`.

    Raises:
        TextError: a language is missing or empty, or there is something else.
    """
    where = f"{path.name}, line {node.start_mark.line + 1}"
    pairs = [(key.value, value.value) for key, value in node.value] if node.id == "mapping" else []
    if sorted(key for key, _ in pairs) != sorted(LANGUAGES):
        raise TextError(f"{where}: a text has `en` and `ko`, and nothing else")
    texts = dict(pairs)
    for language in LANGUAGES:
        if not isinstance(texts[language], str) or not texts[language].strip():
            raise TextError(f"{where}: `{language}` is empty")
    return Text(**texts)


def capitalized(text: str) -> str:
    """Return a text with a capital as its first letter, unless its first word is a name such as `map`."""
    word = ENGLISH_WORD.match(text)
    return text[:1].upper() + text[1:] if word and word[0] not in NAMES else text


def language_of_tools() -> str:
    """Return the language in which a command prints: of the workbook around the current folder, else of the locale."""
    return language_of_workbook("") or language_of_locale(os.environ)


def language_of_workbook(otherwise: str = "en") -> str:
    """Return the language of the learner's copy around the current folder, or `otherwise` outside a copy."""
    here = Path.cwd()
    for folder in (here, *here.parents):
        try:
            found = json.loads((folder / "workbook.json").read_text(encoding="utf-8"))["language"]
        except (OSError, ValueError, KeyError, TypeError):
            continue
        if found in LANGUAGES:
            return found
    return otherwise


def language_of_locale(environment: Mapping[str, str]) -> str:
    """Return "ko" where the locale is Korean, else "en"."""
    for name in ("LC_ALL", "LC_MESSAGES", "LANG"):
        if environment.get(name):
            return "ko" if environment[name].lower().startswith("ko") else "en"
    return "ko" if _is_windows_korean() else "en"


def _is_windows_korean() -> bool:
    """Return whether the language of Windows is Korean, which no variable contains."""
    if os.name != "nt":
        return False
    import ctypes

    return ctypes.windll.kernel32.GetUserDefaultUILanguage() & 0x3FF == 0x12  # the primary language
