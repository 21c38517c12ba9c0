"""A panel that goes on without a kernel: drawn for each step of its first slider."""

from __future__ import annotations

import struct

import pytest

from tflab.core import Transform
from tflab.views import panels
from tflab.views.slider_frames import Film


def pictures_of(film: Film) -> list[bytes]:
    pictures, at = [], 0
    while at < len(film.pictures):
        (length,) = struct.unpack_from("<I", film.pictures, at)
        pictures.append(film.pictures[at + 4 : at + 4 + length])
        at += 4 + length
    return pictures


def test_a_film_keeps_each_picture_with_its_text_and_one_whose_parts_do_not_fit_together_is_refused():
    film = Film([b"one", b"three"], ["x = 1", "x = 3"], ["one", "three"], (760, 380), start=1)
    assert pictures_of(film) == [b"one", b"three"]
    assert (film.texts, film.position, film.width) == (["x = 1", "x = 3"], 1.0, 760)
    with pytest.raises(ValueError, match="it has 2 pictures, 1 texts, 2 words and start 0"):
        Film([b"one", b"two"], ["x = 1"], ["one", "two"], (760, 380))


def test_a_panels_film_goes_along_its_first_slider_and_leaves_the_panel_as_it_was():
    panel = panels.latency_panel()
    before, words = panel.controls["speed [m/s]"].value, panel.text
    *others, film = panel.film(steps=3).children
    assert film.texts == ["speed [m/s]: 0.00", "speed [m/s]: 1.00", "speed [m/s]: 1.50", "speed [m/s]: 3.00"]
    assert film.words[int(film.position)] == words
    assert len(set(pictures_of(film))) == 4
    assert [control.description for control in others] == ["yaw rate [rad/s]", "range [m]", "delay [s]"]
    assert panel.controls["speed [m/s]"].value == before


def test_a_panel_without_a_slider_is_filmed_along_its_longest_menu():
    poses = {"map": Transform(), "base_link": Transform((1.0, 0.0, 0.0)), "laser_frame": Transform((2.0, 0.0, 0.0))}
    panel = panels.sentence_panel(poses, "map", "laser_frame")
    words = panel.text
    (film,) = panel.film().children
    assert len(film.texts) == len(set(pictures_of(film))) == 6  # each frame in each other one
    assert all(text.startswith("Python: ") for text in film.texts)
    assert film.words[int(film.position)] == panel.text == words


def test_a_page_that_is_built_for_export_shows_panels_as_films(monkeypatch):
    monkeypatch.setenv("TFLAB_FILMS", "1")
    panel = panels.latency_panel()
    view = panel._repr_mimebundle_()[0]["application/vnd.jupyter.widget-view+json"]
    assert view["model_id"] != panel.widget.model_id
