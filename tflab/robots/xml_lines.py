"""Parse XML and keep the line numbers of its elements.

    <robot name="r">           Element("robot", {"name": "r"}, line=1)
      <link name="a"/>           Element("link", {"name": "a"}, line=2)
    </robot>

Python's own ElementTree forgets line numbers and refuses a prefix that nobody
declared (`<drake:member>`), which real robots do have.  Its parser underneath,
expat, does neither if asked plainly.  Text between elements is not kept: a URDF
has none.  Entities are refused, because a robot needs none and an attacker does.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from xml.parsers import expat

__all__ = ["Element", "XmlFault", "float_from", "read_xml"]


@dataclass(slots=True)
class Element:
    """One element: its name as written, prefix included, its attributes, and its line, counted from 1."""

    tag: str
    attributes: dict[str, str]
    line: int
    children: list[Element] = field(default_factory=list)

    def all(self, tag: str) -> list[Element]:
        """Return the children of that name."""
        return [child for child in self.children if child.tag == tag]

    def first(self, tag: str) -> Element | None:
        """Return the first child of that name, or None."""
        return next((child for child in self.children if child.tag == tag), None)

    def walk(self) -> Iterator[Element]:
        """Yield this element and everything in it, in the order of the file."""
        waiting = [self]
        while waiting:
            element = waiting.pop()
            yield element
            waiting.extend(reversed(element.children))


class XmlFault(ValueError):
    """The text is not XML; `line` says where it stopped making sense."""

    def __init__(self, message: str, line: int) -> None:
        super().__init__(message)
        self.line = line


def read_xml(text: str | bytes) -> Element:
    """Return the root element.

    Raises:
        XmlFault: the text is not well-formed, or declares an entity.
    """
    parser = expat.ParserCreate()
    document = Element("", {}, 0)
    open_elements = [document]

    def start(tag: str, attributes: dict[str, str]) -> None:
        element = Element(tag, attributes, parser.CurrentLineNumber)
        open_elements[-1].children.append(element)
        open_elements.append(element)

    def end(_tag: str) -> None:
        open_elements.pop()

    def entity(name: str, *_rest: object) -> None:
        raise XmlFault(f"the entity &{name}; is declared here; entities are not read", parser.CurrentLineNumber)

    parser.StartElementHandler = start
    parser.EndElementHandler = end
    parser.EntityDeclHandler = entity
    try:
        parser.Parse(text, True)
    except expat.ExpatError as error:
        raise _explained(error, text) from None
    except XmlFault:
        raise
    except (LookupError, ValueError) as error:  # an encoding that Python does not know, or cannot use here
        raise XmlFault(f"these bytes cannot be read as text: {error}", parser.CurrentLineNumber) from None
    return document.children[0]


def float_from(word: str) -> float | None:
    """Return a number as C reads it, or None; Python alone would also take 1_000."""
    try:
        value = float(word)
    except ValueError:
        return None
    return None if "_" in word or math.isnan(value) else value


def _explained(error: expat.ExpatError, text: str | bytes) -> XmlFault:
    """Return expat's complaint, in better words for the mistake that people make most."""
    content = text if isinstance(text, str) else text.decode("utf-8", errors="replace")
    if not content.strip():
        return XmlFault("the file is empty", 1)
    lines = content.split("\n")[: error.lineno]
    before = "\n".join(lines)[: sum(len(line) + 1 for line in lines[:-1]) + error.offset + 2]
    comment_at = before.rfind("<!--")
    inside = before[comment_at + 4 :]
    if comment_at >= 0 and "--" in inside and "-->" not in inside:
        return XmlFault(
            'two hyphens, "--", inside a comment: XML ends a comment there, and only "-->" may follow; '
            "write a single hyphen",
            error.lineno,
        )
    return XmlFault(f"not well-formed XML: {expat.ErrorString(error.code)}", error.lineno)
