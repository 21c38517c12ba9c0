"""The test folders are no packages, so the page maker next door is loaded by its path."""

import importlib.util
import sys
from pathlib import Path

_spec = importlib.util.spec_from_file_location("making_pages", Path(__file__).with_name("making_pages.py"))
sys.modules.setdefault("making_pages", importlib.util.module_from_spec(_spec))
_spec.loader.exec_module(sys.modules["making_pages"])
