"""What if a shell does not find `tflab`?  `python -m tflab ...` is the same command, of the Python that one names.

Scripts of a Python that is not on PATH are not found, as is usual on Windows.
"""

from __future__ import annotations

import sys

from .cli import main

if __name__ == "__main__":
    sys.exit(main())
