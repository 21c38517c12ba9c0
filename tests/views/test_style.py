"""How numbers are printed, and that our figures leave matplotlib as they found it."""

import subprocess
import sys

import matplotlib
import numpy as np

from tflab.views import style


def test_a_number_has_fixed_decimals_and_its_unit_and_no_minus_where_it_rounds_to_zero():
    assert (style.fmt(0.2), style.fmt(1, "rad", 1), style.fmt(2.0, "")) == ("0.200 m", "1.0 rad", "2.000")
    assert (style.fmt(-0.0), style.fmt(-0.0004), style.fmt(-0.0006)) == ("0.000 m", "0.000 m", "-0.001 m")
    assert style.fmt_all((1, -0.0, 0.25)) == "(1.000, 0.000, 0.250) m"
    assert style.fmt_all((1, 2), "") == "(1.000, 2.000)"
    assert style.fmt_stamp(20_000_000) == "0.020 s"


def test_our_settings_hold_only_while_we_draw():
    before = dict(matplotlib.rcParams)
    with style.our_settings():
        assert matplotlib.rcParams["text.color"] == style.INK
    assert dict(matplotlib.rcParams) == before


def test_a_figure_is_an_opaque_card_in_a_transparent_corner():
    figure = style.figure((2.0, 1.0))
    figure.canvas.draw()
    pixels = np.asarray(figure.canvas.buffer_rgba())
    assert pixels[50, 100].tolist() == [253, 253, 251, 255]  # PAPER
    assert pixels[0, 0, 3] == 0  # outside the rounded corner


def test_importing_a_view_loads_neither_pyplot_nor_widgets():
    names = "style picture projection frames labels axes sentence timeline ages motion_error fault_tables busy_chart"
    code = f"import sys\nfor n in '{names}'.split(): __import__('tflab.views.' + n)\n"
    code += "print(sorted({'matplotlib', 'ipywidgets', 'IPython'} & set(sys.modules)))"
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert out.stdout.strip() == "[]"
