"""Define the message packages of ROS, from definitions.txt, and packages defined at run time.

    define("my_msgs", {
        "Detection.msg": "std_msgs/Header header\\nstring label\\nfloat64 score 0.5   # 0 to 1",
        "Locate.srv": "string label\\n---\\nbool found\\ngeometry_msgs/PointStamped where",
    })
    from my_msgs.msg import Detection
    from my_msgs.srv import Locate

On a robot the same texts are files of a package, and `colcon build` makes the classes
(rosidl's code generation). A folder with that layout, my_msgs/msg/Detection.msg, is
accepted, too.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Mapping
from functools import cache, partial
from importlib.util import find_spec
from pathlib import Path
from types import ModuleType
from typing import Any

from ..distro import current
from .base import action, message, service, types_of
from .definition import Field, NamespacedType, parse_definition

__all__ = ["all_types", "define", "definitions", "interface_files", "ros_package", "type_store"]

KINDS = {".msg": ("msg", 1), ".srv": ("srv", 2), ".action": ("action", 3)}  # folder, and how many parts

DEFINITIONS = Path(__file__).with_name("definitions.txt")
MAKERS = {"msg": message, "srv": service, "action": action}

_defined: dict[str, dict[str, str]] = {}
_made: dict[str, dict[str, type]] = {}


def ros_package(module: str) -> dict[str, type]:
    """Return the types of a package of ROS, named by the last part of `module`; none of a package that is not ROS's."""
    package = module.rpartition(".")[2]
    if package not in _made:
        types = _made[package] = {}
        for ros_type, parts in definitions().get(package, {}).items():
            _, kind, name = ros_type.split("/")
            types[name] = MAKERS[kind](ros_type, *parts)
    return _made[package]


def all_types() -> dict[str, type]:
    """Return every type there is, by its ROS name: messages, services and actions, without what these are made of."""
    for package in definitions():
        ros_package(package)
    types = {name: cls for package in (*definitions(), *_defined) for name, cls in types_of(package).items()}
    return {name: cls for name, cls in sorted(types.items()) if "_" not in cls.__name__}


@cache
def definitions() -> dict[str, dict[str, list[str]]]:
    """Return the parts of each definition of ROS's packages, by package and type."""
    found: dict[str, dict[str, list[str]]] = {}
    for block in DEFINITIONS.read_text(encoding="utf-8").split("==== ")[1:]:
        ros_type, _, text = block.partition("\n")
        ros_type = ros_type.replace("turtlesim/", f"{current().turtlesim_messages}/")
        found.setdefault(ros_type.partition("/")[0], {})[ros_type] = text.split("---\n")
    return found


def define(
    package: str, definitions: Mapping[str, str] | str | Path, faults: dict[str, Exception] | None = None
) -> ModuleType:
    """Make the messages, services and actions of a package; `import` finds them from now on.

    The same package again is taken as it was if its texts are, and is made anew if they are not.

    Args:
        definitions: file names, such as "Detection.msg", and their texts; or the folder of a package.
        faults: is given the definitions that cannot be read, if others can; the types of these are made.

    Raises:
        ValueError: a name or a text is malformed, or the package is one of ROS's own, or of somebody else.
        KeyError: a field has a type that there is none of.
    """
    texts = dict(definitions) if isinstance(definitions, Mapping) else _read(Path(definitions))
    if _defined.get(package) == texts and package in sys.modules:
        return sys.modules[package]
    _check_package(package)
    if not texts:
        raise ValueError(f'{package} has no definitions: expected names such as "Detection.msg", with their texts')
    made: dict[str, type] = {}
    for name in texts:
        try:
            _make(package, name, texts, made, ())
        except (KeyError, ValueError) as fault:
            if faults is None:
                raise
            faults[name] = fault
    if not made:
        raise next(iter(faults.values()))
    _defined[package] = texts
    return _install(package, made, faults or {})


def type_store() -> Any:
    """Return the rosbags library's table of ROS's messages, with those that were defined here: for bytes and hashes."""
    own = [
        (f"{package}/msg/{Path(name).stem}", text)
        for package, texts in _defined.items()
        for name, text in texts.items()
        if name.endswith(".msg") and not re.search(r"^\s*wstring\b", text, re.MULTILINE)  # the library has no wstring
    ]
    return _store_with(tuple(own))


@cache
def _store_with(own: tuple[tuple[str, str], ...]) -> Any:
    from rosbags.typesys import Stores, get_types_from_msg, get_typestore  # loads all of ROS's types: for who asks

    store = get_typestore(Stores.ROS2_JAZZY)
    texts = {ros_type: parts[0] for types in definitions().values() for ros_type, parts in types.items()}
    missing = [row for row in texts.items() if "/msg/" in row[0] and row[0] not in store.fielddefs]
    for ros_type, text in (*missing, *own):
        store.register(get_types_from_msg(text, ros_type))
    return store


def interface_files(folder: Path, kind: str) -> list[Path]:
    """Return the definitions of a kind in a package's folder."""
    return [path for top in (folder / kind, folder / "src" / kind) for path in sorted(top.rglob(f"*.{kind}"))]


def _read(folder: Path) -> dict[str, str]:
    """Return the definitions in a package's folder, by file name."""
    files = [path for kind in ("msg", "srv", "action") for path in interface_files(folder, kind)]
    texts = {path.name: path.read_text(encoding="utf-8") for path in files}
    if len(texts) < len(files):
        raise ValueError(f"{folder} has two definitions of one name: a type is named by its file, without its folder")
    return texts


def _check_package(package: str) -> None:
    if not re.fullmatch(r"[a-z](_?[a-z0-9])*", package):
        raise ValueError(f'"{package}" is no name of a package: small letters, digits and single underscores')
    if package in _defined:
        return
    is_taken = package in definitions() or package in sys.modules or find_spec(package)
    if is_taken and getattr(is_taken, "origin", True):  # Python takes a folder of texts for a package without an origin
        raise ValueError(f"there is a package {package} already: choose another name, such as my_{package}")


def _make(package: str, name: str, texts: Mapping[str, str], made: dict[str, type], above: tuple[str, ...]) -> None:
    """Make one type, after those of the same package that it has fields of."""
    if name in made:
        return
    if name in above:
        raise ValueError(f"{' -> '.join((*above, name))}: a message cannot contain itself")
    stem, suffix = Path(name).stem, Path(name).suffix
    if suffix not in KINDS or not re.fullmatch(r"[A-Z][A-Za-z0-9]*", stem):
        raise ValueError(f'"{name}" is no name of a definition: expected one such as "Detection.msg" or "Locate.srv"')
    kind, count = KINDS[suffix]
    parts = re.split(r"^---.*$", texts[name], flags=re.MULTILINE)
    if len(parts) != count:
        raise ValueError(f"{name} has {len(parts)} parts; a .{kind} has {count}, with a line --- between two")
    for part in parts:
        fields, _ = parse_definition(part, package)
        for needed in (f"{_own(field, package)}.msg" for field in fields):
            if needed in texts:
                _make(package, needed, texts, made, (*above, name))
    made[name] = MAKERS[kind](f"{package}/{kind}/{stem}", *parts)


def _own(field: Field, package: str) -> str | None:
    """Return the name of the message in the same package that a field holds, None if it holds another thing."""
    value_type = getattr(field.slot_type, "value_type", field.slot_type)
    is_own = isinstance(value_type, NamespacedType) and value_type.namespaces == (package, "msg")
    return value_type.name if is_own else None


def _install(package: str, made: Mapping[str, type], faults: Mapping[str, Exception]) -> ModuleType:
    """Put the modules of a package where `import` looks first."""
    top = ModuleType(package, f"{package}, defined in this Python.")
    top.__path__ = []
    stems = {Path(name).stem for name in made}
    sys.modules[package] = top
    for kind, _ in KINDS.values():
        module = ModuleType(f"{package}.{kind}", f"What {package} has of that kind.")
        for name, cls in types_of(package).items():
            if name.split("/")[1] == kind and cls.__name__.partition("_")[0] in stems:
                setattr(module, cls.__name__, cls)
        module.__getattr__ = partial(_refuse, module.__name__, faults)
        sys.modules[module.__name__] = module
        setattr(top, kind, module)
    return top


def _refuse(module: str, faults: Mapping[str, Exception], name: str) -> None:
    kind = module.rpartition(".")[2]
    if fault := faults.get(f"{name}.{kind}"):
        why = f"there is no {fault.args[0]}" if isinstance(fault, KeyError) else fault
        raise ImportError(f"cannot read {name}.{kind}: {why}", name=module)
    raise AttributeError(f"module '{module}' has no attribute '{name}'")
