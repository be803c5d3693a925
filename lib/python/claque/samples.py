"""Labelled pictures of a scene (docs/labels.md), made by the command claque and read as NumPy arrays."""

import json
import os
import pathlib
import subprocess
import tempfile
import time

import numpy

from . import abi
from .labels import Sample
from .places import command_path

_ARRAYS = {"actors": "actor", "zones": "zone", "parts": "part", "depth_m": "depth_m", "normals": "normal",
           "positions": "position", "forward": "flow_forward", "backward": "flow_backward"}


class VariedSample(Sample):
    """A Sample with what was chosen for it. Individuals, triangles and barycentric weights are left out.

    number; choice: the dict of all that was chosen, None without rules; people: a list of dicts with box, mask, joints
    and head of each; camera: the dict of its intrinsics and pose."""

    def __init__(self, number, about, arrays):
        super().__init__(about["time_s"], arrays["rgb"])
        self.number, self.choice = number, about.get("choice")
        self.people, self.camera = about["people"], about["camera"]
        for name, stored in _ARRAYS.items():
            array = arrays[stored]
            if name in ("zones", "parts"):  # stored as one more, in 16 bits
                array = numpy.where(array == 0, abi.NONE, array.astype(numpy.uint32) - 1).astype(numpy.uint32)
            setattr(self, name, array)


def samples(rules=None, numbers=(0,), scene=None, scenario=None, seed=1, size=(640, 480), options=(), command=None):
    """Yields a VariedSample for each number, in their order; sample k is the same whichever others are asked for.

    rules      the path of a file of rules; None: sample k is the scene as it is after k / 25 s
    scene      the name of a scene; or scenario: the path of a scenario
    options    more of the command's, as ("--fps", "10")
    command    the command claque; None: CLAQUE_COMMAND, the one installed with the module, or on PATH

    The command works ahead in a folder for temporary files, which is gone when the loop ends. Until then it holds the
    samples that the loop has not reached yet; TMPDIR says where it is. Raises claque.Error with the command's sentence
    if it fails."""
    numbers = [int(number) for number in numbers]
    if not numbers:
        return
    program = command or command_path()
    varied = ["--vary", str(rules)] if rules else []
    subject = ["--scenario", str(scenario)] if scenario else ["--scene", scene or "plaza"]
    with tempfile.TemporaryDirectory(prefix="claque-") as folder:
        arguments = [str(program), "labels", *subject, *varied, "--seed", str(seed),
                     "--size", f"{size[0]}x{size[1]}", "--write", "npz", "--out", folder,
                     "--frames", _ranges(numbers), *map(str, options)]
        with open(os.path.join(folder, "errors"), "w+", encoding="utf-8") as errors:
            with _started(arguments, errors) as process:
                try:
                    last = {number: at for at, number in enumerate(numbers)}
                    for at, number in enumerate(numbers):
                        sample = _wait_for(process, pathlib.Path(folder), number, errors)
                        if last[number] == at:
                            _remove(pathlib.Path(folder), number)
                        yield sample
                finally:
                    if process.poll() is None:
                        process.terminate()


def _ranges(numbers):
    """The numbers as the command reads them, as in 0:99,120."""
    ranges = []
    for number in sorted(set(numbers)):
        if ranges and number == ranges[-1][1] + 1:
            ranges[-1][1] = number
        else:
            ranges.append([number, number])
    return ",".join(str(first) if first == last else f"{first}:{last}" for first, last in ranges)


def _started(arguments, errors):
    try:
        return subprocess.Popen(arguments, stdout=subprocess.DEVNULL, stderr=errors)
    except OSError as error:
        raise abi.Error(f"{arguments[0]} could not be started: {error.strerror}") from error


def _wait_for(process, folder, number, errors):
    whole = folder / "frames" / f"{number:06}.json"
    ended = False
    while not whole.exists():
        if ended:
            errors.seek(0)
            raise abi.Error(errors.read().strip() or f"the command claque ended with {process.returncode}")
        ended = process.poll() is not None  # what it wrote last may be there now
        time.sleep(0.005)
    with numpy.load(folder / "arrays" / f"{number:06}.npz") as arrays:
        return VariedSample(number, json.loads(whole.read_text()), {name: arrays[name] for name in arrays.files})


def _remove(folder, number):
    for name in (f"arrays/{number:06}.npz", f"images/{number:06}.png"):
        (folder / name).unlink(missing_ok=True)
