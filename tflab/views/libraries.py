"""Import the widget libraries in one place, so that a missing one is reported with the extra that installs it.

    from .libraries import ipywidgets as widgets

matplotlib is imported where a figure is made, because loading it takes long.
"""

from tflab.extras import require

require("matplotlib", "PIL", "ipywidgets", "anywidget", "meshcat")

import anywidget  # noqa: E402
import ipywidgets  # noqa: E402
import traitlets  # noqa: E402

__all__ = ["anywidget", "ipywidgets", "traitlets"]
