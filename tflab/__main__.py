"""Run the command `tflab` as `python -m tflab`, where the shell does not find it or another Python is meant.

Scripts of a Python that is not on PATH are not found, as is usual on Windows.
"""

from __future__ import annotations

import sys

from .cli import main

if __name__ == "__main__":
    sys.exit(main())
