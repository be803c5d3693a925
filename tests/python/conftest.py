# Fixtures of the Python tests: the module of this tree, a context, the citizen and a small crowd.
import pathlib
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "lib" / "python"))

import claque  # noqa: E402
from drawing import KINDS  # noqa: E402


@pytest.fixture(params=KINDS)
def gl(request, monkeypatch):
    """The kind of context that the test draws with."""
    monkeypatch.setenv("CLAQUE_CONTEXT", request.param)
    return request.param


@pytest.fixture
def context():
    with claque.Context() as made:
        yield made


@pytest.fixture
def citizen(context):
    with claque.Template.builtin(context, "citizen", folder=None) as made:
        yield made


@pytest.fixture
def crowd(context, citizen):
    """A hundred people of ten rows, seen by one view."""
    with claque.Crowd(context) as made:
        for i in range(100):
            made.add(citizen, (i % 10, 0, -(i // 10)), clip="applaud", phase_s=0.07 * i, seed=i,
                     texture_set=claque.abi.RANDOM)
        view = made.view()
        view.look_at((4.5, 4, 12), (4.5, 1, -4))
        made.the_view = view
        yield made
