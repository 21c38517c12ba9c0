r"""How does a formula stand on a page without a network?  As MathML, which browsers set by themselves.

    $\theta = \pi / 2$     ->  <math> ... </math>             within a line
    $$ p = R q + t $$      ->  <math display="block"> ...     on its own

JupyterLab sets the same formulas with MathJax, which it brings along.  Code is left
as it is: a dollar there is a shell's.
"""

from __future__ import annotations

import re

__all__ = ["with_mathml"]

FENCES, SPAN, INDENTED = r"```.*?```|~~~.*?~~~", r"(?<!`)(`+)(?!`).*?(?<!`)\1(?!`)", r"^(?: {4}|\t)[^\n]*$"
CODE = re.compile(f"{FENCES}|{SPAN}|{INDENTED}", re.DOTALL | re.MULTILINE)
FORMULA = re.compile(r"(?<![\\$])\$\$(?P<block>[^$]+)\$\$|(?<![\\\w$])\$(?=\S)(?P<line>[^$\n]+?)(?<=\S)\$(?![\w$])")


def with_mathml(markdown: str) -> str:
    """Return Markdown with its formulas as MathML."""
    parts, at = [], 0
    for code in CODE.finditer(markdown):
        parts += [_set(markdown[at : code.start()]), code[0]]
        at = code.end()
    return "".join([*parts, _set(markdown[at:])])


def _set(text: str) -> str:
    return FORMULA.sub(lambda found: _mathml(found["block"] or found["line"], found["block"] is not None), text)


def _mathml(formula: str, block: bool) -> str:
    from latex2mathml.converter import convert  # only where a page has a formula

    return convert(formula.strip(), display="block" if block else "inline")
