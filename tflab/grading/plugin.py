"""Let `pytest --nbval` fail where the answer of an exercise is missing or wrong.

    pytest --nbval exercises/en/E03_target_and_source.ipynb
        E03_target_and_source.ipynb::Cell 9 FAILED       E3.2 ✗ 0/4: You ...

pytest finds this module by its entry point.  Without nbval it does nothing.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest

PASSED = re.compile(r"E\d+\.\d+ ✓")  # how a reply of `check` begins


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item: pytest.Item) -> Iterator[None]:
    """Fail a check cell that nbval has run, unless `check` says that the answer is right."""
    yield
    cell = getattr(item, "cell", None)  # an IPyNbCell
    if cell is None or "check" not in cell.metadata.get("tags", ()):
        return
    replies = [out.get("text") or out.get("data", {}).get("text/plain", "") for out in item.test_outputs]
    if not any(map(PASSED.match, replies)):
        pytest.fail("\n".join(replies).strip() or "check printed no reply", pytrace=False)
