"""Pictures from Python, by each kind of context that is there; and the example scripts, as a reader would run them."""

import os
import pathlib
import subprocess
import sys

import numpy

import claque
from drawing import drawing

ROOT = pathlib.Path(__file__).resolve().parents[2]


def picture_of(context, crowd, citizen, strategy="fused"):
    with claque.Offscreen(320, 240) as target, claque.Renderer(context, target, strategy) as renderer:
        renderer.prepare(citizen)
        crowd.update(1.5)
        target.clear((0.5, 0.6, 0.7))
        target.light()
        stats = renderer.draw(crowd.the_view)
        return target.picture().copy(), stats


@drawing
def test_a_picture_shows_the_actors_on_the_requested_background(context, crowd, citizen):
    picture, stats = picture_of(context, crowd, citizen)
    assert picture.shape == (240, 320, 3)
    assert stats.individuals == len(crowd.the_view)
    background = numpy.all(numpy.abs(picture.astype(int) - [128, 153, 179]) <= 1, axis=2)
    assert background[:20].all(), "sky above, so row 0 is the top one"
    assert 0.03 < 1 - background.mean() < 0.9


@drawing
def test_every_strategy_shows_the_same_pixels(context, crowd, citizen):
    fused, _ = picture_of(context, crowd, citizen)
    for strategy in ("binned", "per-zone"):
        numpy.testing.assert_array_equal(picture_of(context, crowd, citizen, strategy)[0], fused)


@drawing
def test_the_picture_is_a_view_of_the_contexts_own_pixels():
    with claque.Offscreen(16, 8) as target:
        target.clear((1.0, 0.0, 0.0))
        assert numpy.shares_memory(target.picture(), target.pixels)
        assert target.picture()[0, 0].tolist() == [255, 0, 0]


def run_example(name, folder):
    environment = dict(os.environ, PYTHONPATH=str(ROOT / "lib" / "python"))
    return subprocess.run(
        [sys.executable, ROOT / "lib/python/examples" / name],
        cwd=folder,
        env=environment,
        check=True,
        capture_output=True,
        text=True,
    ).stdout


def test_the_parity_example_reports_the_distance(tmp_path):
    assert "vertices within 0.00" in run_example("parity.py", tmp_path)


def test_the_rehearsal_tries_two_endings(tmp_path):
    assert "applaud after 5 s" in run_example("rehearsal.py", tmp_path)


@drawing
def test_the_procession_leaves_its_picture(tmp_path):
    assert "in view" in run_example("procession.py", tmp_path)
    assert (tmp_path / "procession.png").stat().st_size > 10000


@drawing
def test_the_passers_leave_their_picture(tmp_path):
    assert "in view" in run_example("passers.py", tmp_path)
    assert (tmp_path / "passers.png").stat().st_size > 10000
