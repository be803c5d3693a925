"""Labelled pictures of a scene: each is that of its number, whichever others are asked for."""

import os
import pathlib
import re
import subprocess
import sys

import numpy
import pytest

import claque
from claque import abi
from drawing_command import needs_command

pytestmark = needs_command

RULES = """
time_s = [0, 20]
[people]
count = [4, 20]
[camera]
distance_m = [2, 5]
[sensor]
read_noise = [1, 3]
"""


@pytest.fixture
def rules(tmp_path):
    path = tmp_path / "rules.toml"
    path.write_text(RULES)
    return path


def test_samples_have_arrays_people_and_choices(rules):
    sample, = claque.samples(rules, [3], seed=9, size=(96, 72))
    assert sample.number == 3 and sample.choice["sample"] == 3 and sample.choice["seed"] == 9
    assert sample.picture.shape == (72, 96, 3) and sample.forward.shape == (72, 96, 2)
    people = sample.actors > 0
    assert people.any() and (sample.zones[~people] == abi.NONE).all() and (sample.zones[people] < 100).all()
    assert numpy.isnan(sample.depth_m[~people]).all() and (sample.depth_m[people] > 0).all()
    assert {person["id"] for person in sample.people} >= set(numpy.unique(sample.actors[people]).tolist())
    assert 4 <= sample.choice["people"]["count"] <= 20
    chosen = [person for person in sample.people if person["id"] == sample.choice["camera"]["person"]]
    assert chosen[0]["head"]["seen"] == "visible"


def test_three_lines_of_the_docs_make_arrays():
    page = (pathlib.Path(__file__).resolve().parents[2] / "docs/python.md").read_text()
    lines = re.search(r"```python\n(import claque\n.*?)```", page, re.DOTALL).group(1)
    assert len(lines.splitlines()) == 3
    environment = dict(os.environ, PYTHONPATH=str(pathlib.Path(claque.__file__).parents[1]))
    said = subprocess.run([sys.executable, "-B", "-c", lines], env=environment, check=True, capture_output=True,
                          text=True)
    assert re.fullmatch(r"\(480, 640, 3\) \d+ [\d.]+ float32\n", said.stdout), said.stdout


def test_a_scene_needs_no_rules():
    still, later = claque.samples(numbers=[0, 5], size=(96, 72), options=("--count", 30, "--fps", 10))
    assert (still.time_s, later.time_s) == (0, 0.5) and still.choice is None
    seen = set(numpy.unique(still.actors[still.actors > 0]).tolist())
    assert len(seen) > 10 and {person["id"] for person in still.people} >= seen
    assert not numpy.isnan(still.depth_m[still.actors > 0]).any() and (still.picture != later.picture).any()


def test_a_sample_is_the_same_alone_and_in_any_order(rules):
    several = list(claque.samples(rules, [5, 1, 5], size=(64, 48)))
    assert [sample.number for sample in several] == [5, 1, 5]
    alone, = claque.samples(rules, [1], size=(64, 48), options=("--threads", 2))
    assert alone.choice == several[1].choice
    for name in ("picture", "actors", "zones", "parts", "depth_m", "normals", "positions", "forward", "backward"):
        numpy.testing.assert_array_equal(getattr(alone, name), getattr(several[1], name))
    assert (several[0].picture != several[1].picture).any()


def test_a_loop_may_end_before_its_samples(rules):
    for sample in claque.samples(rules, range(1000), size=(64, 48)):
        assert sample.number == 0
        break


def test_what_the_command_refuses_is_raised(rules):
    with pytest.raises(claque.Error, match="rules.toml:4:9: the scene 'corridor' says itself how many people"):
        corridor = os.path.join(os.path.dirname(__file__), "../../samples/scenarios/corridor.toml")
        list(claque.samples(rules, [0], scenario=corridor))
    with pytest.raises(claque.Error, match="no-such-command"):
        list(claque.samples(rules, [0], command="/no-such-command"))
    assert not list(claque.samples(rules, []))
