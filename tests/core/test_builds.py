"""The pure and the compiled build behave alike, and the environment selects one."""

from __future__ import annotations

import copy
import importlib
import os
import pickle
import subprocess
import sys
import weakref
from importlib.machinery import EXTENSION_SUFFIXES

import numpy as np
import pytest

from tflab.core import BUILD, BufferCore, StampedTransform, Transform, seconds
from tflab.core.builds import COMPILED_MODULES

WHAT_RUNS = (
    "import tflab.core as c; from tflab.core import poses, cache; print(c.BUILD, poses.__file__, cache.__file__)"
)


def test_build_names_the_build_that_runs_and_an_environment_variable_selects_the_sources() -> None:
    files = [importlib.import_module(f"tflab.core.{module}").__file__ for module in COMPILED_MODULES]
    suffixes = tuple(EXTENSION_SUFFIXES) if BUILD == "compiled" else (".py",)
    assert all(file.endswith(suffixes) for file in files), files
    own = os.environ | {"TFLAB_COMPILED": "0"}
    probe = subprocess.run([sys.executable, "-c", WHAT_RUNS], env=own, capture_output=True, text=True, check=True)
    build, *files = probe.stdout.split()
    assert (build, [file[-3:] for file in files]) == ("pure", [".py", ".py"])


@pytest.fixture
def buffer() -> BufferCore:
    #  a --(1000 s, 1001 s, 1002 s: 0, 1, 2 m along x)--> b
    buffer = BufferCore()
    for k in range(3):
        buffer.set_transform(StampedTransform("a", "b", seconds(1000.0 + k), Transform((k, 0, 0))))
    return buffer


QUESTIONS = {
    "lookup_transform": lambda buffer, stamp: buffer.lookup_transform("a", "b", stamp),
    "lookup_transform_full": lambda buffer, stamp: buffer.lookup_transform_full("a", stamp, "b", stamp, "a"),
    "can_transform": lambda buffer, stamp: buffer.can_transform("a", "b", stamp),
    "can_transform_full": lambda buffer, stamp: buffer.can_transform_full("a", stamp, "b", stamp, "a"),
    "why_not": lambda buffer, stamp: buffer.why_not("a", "b", stamp),
    "request_transformable": lambda buffer, stamp: buffer.request_transformable("a", "b", stamp, print),
    "set_transform": lambda buffer, stamp: buffer.set_transform(StampedTransform("a", "b", stamp, Transform())),
}


@pytest.mark.parametrize("question", QUESTIONS)
def test_a_float_stamp_is_refused_and_an_integer_of_numpy_is_one_on_both_builds(buffer: BufferCore, question) -> None:
    for stamp in (1001e9, np.float64(1001e9)):
        with pytest.raises(TypeError) as raised:
            QUESTIONS[question](buffer, stamp)
        assert str(raised.value) == f"a stamp is an int of nanoseconds, not {stamp!r}; seconds(1.5) makes one"
    assert QUESTIONS[question](buffer, np.int64(seconds(1001.0))) == QUESTIONS[question](buffer, seconds(1001.0))


def test_answers_are_pickled_and_copied_and_buffers_are_not_on_both_builds(buffer: BufferCore) -> None:
    answer = buffer.lookup_transform("a", "b", seconds(1000.25))
    assert repr(answer.transform) == "Transform(translation=(0.25, 0.0, 0.0), rotation=(0.0, 0.0, 0.0, 1.0))"
    assert pickle.loads(pickle.dumps(answer)) == copy.deepcopy(answer) == answer
    for refused in (pickle.dumps, copy.deepcopy):
        with pytest.raises(TypeError, match=r"cannot pickle '_thread\.RLock' object"):
            refused(buffer)


def test_a_buffer_can_be_subclassed_and_weakly_referenced_on_both_builds() -> None:
    class Recorder(BufferCore):
        def set_transform(self, stamped, authority="default_authority", is_static=False):
            self.heard = stamped
            return super().set_transform(stamped, authority, is_static)

    recorder = Recorder()
    sample = StampedTransform("a", "b", 5, Transform())
    assert recorder.set_transform(sample)
    assert recorder.heard is sample
    assert weakref.ref(recorder)() is recorder
    assert BufferCore.__doc__.startswith("Transforms between frames")
