"""try.py WHEEL SCENARIOS: installs a wheel into a new environment and uses it as its pages say; prints JSON.

Runs on a bare system with Python, NumPy and an OpenGL, and nothing of this project. Each step is timed by the clock and
by the processor. Whatever ends otherwise than it should is a line of `faults`."""

import hashlib
import json
import os
import pathlib
import resource
import struct
import subprocess
import sys
import time

PEOPLE = "id,frame,x,y\n" + "".join(f"{person},{frame},{0.13 * frame},{person}\n"
                                    for person in (1, 2, 3) for frame in range(40))
SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\nf 1//1 3//1 4//1\n"
SCRIPT = "steps = ['wait 1', 'click person 2', 'click \"Character\"', 'wait 0.7', 'shot window.png']\n"
# Of docs/python.md.
THREE_LINES = """import claque
sample, = claque.samples(scene="plaza")
print(sample.picture.shape, sample.actors.max(), sample.depth_m[sample.actors > 0].min(), sample.forward.dtype)
"""
MODULE = """
import hashlib
import claque
with claque.Context() as context, claque.Template.builtin(context, "citizen") as citizen, \\
        claque.Crowd(context, exact_poses=True) as crowd, claque.Offscreen(160, 120) as target, \\
        claque.Renderer(context, target) as renderer:
    for i in range(6):
        crowd.add(citizen, position=(i % 3 - 1, 0, -1.2 * (i // 3)), clip="walk", phase_s=0.3 * i, seed=i)
    renderer.prepare(citizen)
    view = crowd.view()
    view.look_at((0.2, 1.5, 5), (0, 1, 0), aspect=4 / 3)
    for sample in claque.labels(crowd, view, renderer, target, [0.5], step_s=0.04):
        hashed = hashlib.sha256()
        for name in ("actors", "parts", "zones", "triangles", "depth_m", "normals", "positions", "forward"):
            hashed.update(getattr(sample, name).tobytes())
        print(hashed.hexdigest(), hashlib.sha256(sample.picture.tobytes()).hexdigest())
"""

seconds, hashes, faults = {}, {}, []
BIN = pathlib.Path("venv/bin")


def step(name, *arguments, succeeds=True):
    before, begun = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    done = subprocess.run([str(argument) for argument in arguments], capture_output=True, text=True)
    wall, after = time.monotonic() - begun, resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds[name] = [wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime]
    if (done.returncode == 0) != succeeds:
        faults.append(f"{name} ended with {done.returncode}: {(done.stderr or done.stdout).strip()[-600:]}")
    elif succeeds and done.stderr.strip() and name != "pip":
        faults.append(f"{name} complained: {done.stderr.strip()[-600:]}")
    return done


def one_sentence(name, words, *arguments, **environment):
    os.environ.update(environment)
    said = step(name, *arguments, succeeds=False).stderr.strip()
    for variable in environment:
        del os.environ[variable]
    if len(said.splitlines()) != 1 or words not in said:
        faults.append(f"{name} should say one sentence with {words!r}: {said[-600:]!r}")


def keep(name, data):
    hashes[name] = hashlib.sha256(data).hexdigest()


def keep_picture(name, file):
    """Of a PNG its pixels, as they are compressed: its texts name the OpenGL."""
    data, at, pixels = pathlib.Path(file).read_bytes(), 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        pixels += data[at + 8:at + 8 + length] if kind in (b"IHDR", b"IDAT") else b""
        at += 12 + length
    keep(name, pixels)


def use(scenarios):
    claque = BIN / "claque"
    step("first picture", claque, "render", "--scene", "odeon", "--out", "a.png")
    if pathlib.Path("~/.cache/claque").expanduser().exists():
        faults.append("the first picture made people who were not prepared")
    step("version", claque, "--version")
    step("second picture", claque, "render", "--scene", "odeon", "--out", "a.png")
    keep_picture("pixels of the odeon", "a.png")
    printed = step("three lines of Python", BIN / "python", "-c", THREE_LINES).stdout
    keep("labels that three lines of Python print", printed.encode())
    labels, picture = (step("labels in Python", BIN / "python", "-c", MODULE).stdout.split() + ["", ""])[:2]
    hashes["labels in Python"], hashes["pixels in Python"] = labels, picture
    pathlib.Path("people.csv").write_text(PEOPLE)
    step("play", claque, "play", "people.csv", "--columns", "id,frame,x,y", "--rate", "10", "--unit", "m",
         "--time", "1", "--out", "play.png")
    keep_picture("pixels of play", "play.png")
    step("labels", claque, "labels", "odeon", "--camera", "close", "--frames", "0:1", "--write", "npz,coco", "--out",
         "labels")
    pathlib.Path("script.toml").write_text(SCRIPT)
    step("view", claque, "view", "patrician", "--count", "3", "--script", "script.toml", "--shots", ".")
    keep_picture("pixels of the window", "window.png")
    step("chart", claque, "cost", "--plot", "chart.png")
    keep_picture("chart", "chart.png")
    pathlib.Path("square.obj").write_text(SQUARE)
    step("convert", claque, "convert", "square.obj", "--out", "square.glb")
    keep("converted square", pathlib.Path("square.glb").read_bytes())
    step("stage", claque, "stage", scenarios / "market.toml", "--seconds", "1", "--record", "run.clt", "--frames",
         "0:0", "--out", "market-%05d.png")
    keep("record of the market", pathlib.Path("run.clt").read_bytes())
    one_sentence("no SDL2", "SDL2", claque, "view", DISPLAY=":99")
    one_sentence("no LibVNCServer", "libvncserver", claque, "view", "--serve")
    one_sentence("no MPI", "mpi", claque, "render", "--scene", "plaza", "--frames", "0:1", "--out", "%d.png",
                 OMPI_COMM_WORLD_SIZE="2")


def keep_arrays():
    import numpy  # of the system
    for number in (0, 1):
        with numpy.load(f"labels/arrays/{number:06d}.npz") as arrays:
            for name in arrays.files:
                kind = "pixels of labels" if name == "rgb" else f"labels of the odeon, {name}"
                keep(f"{kind}, {number}", arrays[name].tobytes())
            if number == 0:
                pathlib.Path("rgb").write_bytes(arrays["rgb"].tobytes())


if __name__ == "__main__":
    wheel, scenarios = sys.argv[1:]
    step("venv", sys.executable, "-m", "venv", "--system-site-packages", "venv")
    step("pip", BIN / "pip", "install", "--no-index", wheel)
    try:
        use(pathlib.Path(scenarios))
        keep_arrays()
    except OSError as error:  # a file that a step should have left
        faults.append(str(error))
    print(json.dumps({"seconds": seconds, "hashes": hashes, "faults": faults}))
