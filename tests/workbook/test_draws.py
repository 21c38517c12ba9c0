"""A task's numbers are the same for the same seed, for as long as a course lasts."""

from __future__ import annotations

from statistics import fmean, stdev

import pytest

from tflab.workbook.tasks import Draws

# What `numpy.random.default_rng(2**200 + 7)` of NumPy 2.4 gives, drawn in this order from a new one for each group.
SEED = 2**200 + 7
NUMBERS = [
    0.8800979100839356,
    -0.21263173817385672,
    [0.5374243204137268, 17.26552296508841],
    [0.8152462920212371, 0.6774936211014889, 0.3132684915217275],
    [[-0.9804971144825791, 0.06523266017718843], [-0.7517083816257784, 0.811222523006462]],
]
INTEGERS = [0, 3, [22, 35, 25, 53, 33], 1560259176, [[2, 2, 1], [1, 2, 1]], 5, 2212432790]
CHOSEN = ["map", 7, ["a", "b", "b", "c", "b", "c"]]
WITHOUT_REPLACEMENT = [[0, 4, 5, 9], ["b", "d", "c", "e", "a"], [[5, 6], [3, 4]]]
PERMUTED = [[7, 2, 3, 1, 5, 6, 0, 4], ["map", "laser", "odom", "base_link"], [0]]


def test_uniform_numbers_are_fixed():
    rng = Draws(SEED)
    drawn = [rng.random(), rng.uniform(-2.5, 4.0), rng.uniform([0, 10], [1, 20]).tolist()]
    assert [*drawn, rng.uniform(0.3, 1.2, 3).tolist(), rng.uniform(-1, 1, (2, 2)).tolist()] == NUMBERS


def test_integers_are_fixed():
    rng = Draws(SEED)
    drawn = [rng.integers(6), rng.integers(-3, 4), rng.integers(0, 100, 5).tolist(), rng.integers(0, 2**31)]
    assert [*drawn, rng.integers(1, 3, (2, 3)).tolist(), rng.integers(5, 6), rng.integers(3_000_000_000)] == INTEGERS


def test_choices_and_permutations_are_fixed():
    rng = Draws(SEED)
    drawn = [rng.choice(["map", "odom", "base_link"]), rng.choice(9), rng.choice(["a", "b", "c", "d"], 6).tolist()]
    assert drawn == CHOSEN
    letters, rows = ["a", "b", "c", "d", "e"], [[1, 2], [3, 4], [5, 6]]
    drawn = [rng.choice(options, size, replace=False).tolist() for options, size in ((10, 4), (letters, 5), (rows, 2))]
    assert drawn == WITHOUT_REPLACEMENT
    drawn = [rng.permutation(options).tolist() for options in (8, ["map", "odom", "base_link", "laser"], 1)]
    assert drawn == PERMUTED


def test_normal_numbers_are_fixed_and_have_mean_0_and_deviation_1():
    rng = Draws(SEED)
    drawn = [rng.standard_normal() for _ in range(5000)]
    assert drawn[0] == pytest.approx(1.1754763842265434, abs=1e-12)  # the quantile of 0.8800979...: the first uniform
    assert fmean(drawn) == pytest.approx(0.0, abs=0.05) and stdev(drawn) == pytest.approx(1.0, abs=0.05)


def test_an_empty_or_too_large_range_of_integers_is_refused():
    for low, high in ((0, 0), (4, 4), (0, 2**32 + 1)):
        with pytest.raises(ValueError, match="integers to draw from"):
            Draws(1).integers(low, high)
