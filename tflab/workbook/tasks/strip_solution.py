"""Turn a solution into an exercise by removing its marked regions.

    def invert(t):                          def invert(t):
        # BEGIN SOLUTION                        raise NotImplementedError("your turn")
        return t.inverse()          -->
        # END SOLUTION

    # BEGIN SOLUTION
    base_p_tip = T.apply(p)  # [m]  -->     base_p_tip = ...  # [m]
    # END SOLUTION

Inside a dict, the values of the region's keys become `...`.  What stands outside
the regions stays, so an example can be faded line by line.  A name that begins with
an underscore is a helper of the solution, and is removed.
"""

from __future__ import annotations

import ast
import io
import textwrap
import tokenize

__all__ = ["BlankError", "blank", "regions", "without_marks"]

BEGIN, END = "# BEGIN SOLUTION", "# END SOLUTION"
YOUR_TURN = 'raise NotImplementedError("your turn")'


class BlankError(Exception):
    """A cell whose regions cannot be taken out: `wrong` and `remedy` say why, and what to do."""

    def __init__(self, wrong: str, remedy: str) -> None:
        super().__init__(f"{wrong}; {remedy}")
        self.wrong, self.remedy = wrong, remedy


def without_marks(source: str) -> str:
    """Return a solution's cell for reading: without the lines that mark its regions."""
    return "".join(line for line in source.splitlines(keepends=True) if line.strip() not in (BEGIN, END))


def regions(source: str) -> list[tuple[int, int]]:
    """Return the lines, from 1, of each BEGIN and its END.

    Raises:
        BlankError: one has no other.
    """
    found: list[tuple[int, int]] = []
    begun = 0
    for number, line in enumerate(source.splitlines(), start=1):
        if line.strip() == BEGIN:
            if begun:
                raise BlankError(f'"{BEGIN}" stands inside another region', f'write "{END}" before it')
            begun = number
        elif line.strip() == END:
            if not begun:
                raise BlankError(f'"{END}" has no "{BEGIN}"', "write one before it")
            found.append((begun, number))
            begun = 0
    if begun:
        raise BlankError(f'"{BEGIN}" has no "{END}"', "write one after the solution")
    return found


def blank(source: str) -> str:
    """Return the code of a cell with its regions taken out.

    Raises:
        BlankError: a region has no end, or holds nothing that could be asked for.
    """
    found = regions(source)
    if not found:
        return source
    try:
        tree = ast.parse(source)
    except SyntaxError as error:
        raise BlankError(f"line {error.lineno} is not Python: {error.msg}", "an answer is plain Python") from None
    comments = _comments(source)
    lines = source.splitlines()
    for begin, end in reversed(found):
        indent = lines[begin - 1][: len(lines[begin - 1]) - len(lines[begin - 1].lstrip())]
        instead = _instead(tree, begin, end, comments, source)
        lines[begin - 1 : end] = [indent + line for line in instead]
    return "\n".join(lines)


def _instead(tree: ast.Module, begin: int, end: int, comments: dict[int, str], source: str) -> list[str]:
    """Return the lines that take the region's place."""
    around = [node for node in ast.walk(tree) if _holds(node, begin)]
    if any(isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef) for node in around):
        return [YOUR_TURN]
    for node in reversed(around):  # the innermost comes last
        if isinstance(node, ast.Dict):
            return _open_values(node, begin, end, comments, source)
    statements = [each for each in tree.body if begin < each.lineno and each.end_lineno < end]
    if not any(map(_assigned, statements)) and not any(map(_is_whole, statements)):
        raise BlankError("a region assigns nothing", "give the answer its name inside the region")
    return [line for statement in statements for line in _open_names(statement, comments)]


def _is_whole(statement: ast.stmt) -> bool:
    return isinstance(statement, ast.FunctionDef | ast.ClassDef)


def _open_names(statement: ast.stmt, comments: dict[int, str]) -> list[str]:
    """Return a line for each name that a statement assigns, but for those that only help."""
    if _is_whole(statement) and not statement.name.startswith("_"):
        wrong = f"the whole of {statement.name} stands in the region"
        raise BlankError(wrong, "put the region inside it, so that its first line stays")
    comment = comments.get(statement.end_lineno) or comments.get(statement.lineno) or ""
    return [f"{name} = ...{comment}" for name in _assigned(statement) if not name.startswith("_")]


def _open_values(node: ast.Dict, begin: int, end: int, comments: dict[int, str], source: str) -> list[str]:
    lines = []
    for key, value in zip(node.keys, node.values, strict=True):
        if key is not None and begin < key.lineno and value.end_lineno < end:
            comment = comments.get(value.end_lineno, "")
            lines.append(f"{ast.get_source_segment(source, key)}: ...,{comment}")
    if not lines:
        raise BlankError("a region inside a dict holds no key", "put whole lines of it between the marks")
    return lines


def _holds(node: ast.AST, begin: int) -> bool:
    return getattr(node, "lineno", begin) < begin < (getattr(node, "end_lineno", None) or 0)


def _assigned(statement: ast.stmt) -> list[str]:
    """Return the names that a statement assigns, in order."""
    if isinstance(statement, ast.Assign):
        targets = statement.targets
    elif isinstance(statement, ast.AnnAssign | ast.AugAssign):
        targets = [statement.target]
    else:
        return []
    return [
        name.id
        for target in targets
        for name in ast.walk(target)
        if isinstance(name, ast.Name) and isinstance(name.ctx, ast.Store)
    ]


def _comments(source: str) -> dict[int, str]:
    """Return the comment at the end of each line that has code before it, two spaces and all."""
    found = {}
    for token in tokenize.generate_tokens(io.StringIO(textwrap.dedent(source)).readline):
        if token.type == tokenize.COMMENT and token.line[: token.start[1]].strip():
            found[token.start[0]] = f"  {token.string}"
    return found
