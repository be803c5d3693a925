"""sumo-gui and osgviewer, as Debian has them, with claque's plugin: people walk in what is on the screen."""
import os
import pathlib
import subprocess
import tempfile
import time

import screen

SAMPLE = pathlib.Path(__file__).resolve().parent.parent.parent / "samples/hosts/osg/sumo"
VIEW = (6, 128, 994, 690)  # of the window, where the streets are
# Bodies without a colour in place of people: what the tests must not take for them.
BLANK = """Geode { nodeMask 0xffffffff cullingActive TRUE num_drawables 1
  ShapeDrawable { Box { Center 0 0 0.86 HalfLengths 0.24 0.107 0.86 Rotation 0 0 0 1 } color 0.8 0.8 0.8 1 } }
"""


def is_of_people(r, g, b):
    """Streets and bodies without a colour are grey, the sky is blue, and the lights that SUMO hangs on bodies have no
    blue at all."""
    return max(r, g) > max(24, b + 8) and 5 * b > max(r, g)


def write_streets(folder, model):
    subprocess.run(["netgenerate", "--grid", "--grid.number", "3", "--grid.length", "40", "--sidewalks.guess",
                    "--crossings.guess", "-o", "streets.net.xml"], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    for file in SAMPLE.iterdir():
        (folder / file.name).write_text(file.read_text().replace("citizen.claque", model))
    (folder / "blank.osg").write_text(BLANK)


def run_sumo(folder, shown, plugins):
    environment = dict(shown.environment, OSG_LIBRARY_PATH=str(plugins))
    environment.setdefault("SUMO_HOME", "/usr/share/sumo")
    options = ("-n streets.net.xml -r people.rou.xml --step-length 0.1 --end 60 --osg-view --start --quit-on-end "
               "--delay 300 --window-size 1000,780 --window-pos 0,0 -g view.xml")
    return subprocess.Popen(["sumo-gui", *options.split()], cwd=folder, env=environment, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True)


def watch(shown, process, seconds, at_least):
    """(picture, bodies) with the most bodies until there are so many; process: the program, or it has ended."""
    best = (None, [])
    until = time.monotonic() + seconds
    while time.monotonic() < until and process.poll() is None:
        picture = shown.picture().part(*VIEW)
        bodies = screen.spots(picture, is_of_people, 150)
        if len(bodies) > len(best[1]):
            best = (picture, bodies)
        if len(best[1]) >= at_least:
            break
        time.sleep(0.3)
    return best


def check_sumo(plugins, out):
    with tempfile.TemporaryDirectory() as name, screen.Screen() as shown:
        folder = pathlib.Path(name)
        write_streets(folder, "citizen.claque")
        process = run_sumo(folder, shown, plugins)
        first, bodies = watch(shown, process, 60, 8)
        time.sleep(0.7)
        then = shown.picture().part(*VIEW)
        if first:
            first.save(out / "sumo.png")
            then.save(out / "sumo-later.png")
        said, _ = process.communicate(timeout=120)
        assert process.returncode == 0, f"sumo-gui ended with {process.returncode}: {said}"
        assert "claque" not in said, said
        assert len(bodies) >= 8, f"{len(bodies)} people are in sight"
        means = [screen.mean(first, body) for body in bodies]
        clothes = {tuple(40 * c // sum(rgb) for c in rgb) for rgb in means}
        assert len(clothes) >= 6, f"{len(bodies)} people, and {len(clothes)} hues: {means}"
        colours = {first.at(x, y) for body in bodies for x, y in body}
        assert len(colours) > 300, f"{len(colours)} colours in all people"
        before = {place for body in bodies for place in body}
        after = {place for body in screen.spots(then, is_of_people, 150) for place in body}
        stayed = len(before & after) / max(1, len(before | after))
        assert after and stayed < 0.6, f"{100 * stayed:.0f} % of the pixels with people in them are the same later"

        write_streets(folder, "blank.osg")
        process = run_sumo(folder, shown, plugins)
        _, mistaken = watch(shown, process, 12, 1)
        process.terminate()
        process.communicate()
        assert not mistaken, "bodies without a colour are taken for people: this test cannot fail"
    return f"{len(bodies)} people in sight, {len(clothes)} clothes, {len(colours)} colours"


def moved_pixels(shown, seconds):
    """The most pixels in which two pictures a second apart differ, until there are 200."""
    most, until = 0, time.monotonic() + seconds
    before = shown.picture()
    while most < 200 and time.monotonic() < until:
        time.sleep(1)
        then = shown.picture()
        most = max(most, sum(before.at(x, y) != then.at(x, y) for y in range(0, 600, 2) for x in range(0, 800, 2)))
        before = then
    return most


def check_osgviewer(plugins, out, scenarios):
    with tempfile.TemporaryDirectory() as name, screen.Screen(800, 600) as shown:
        folder = pathlib.Path(name)
        (folder / "person.claque").write_text('character = "plebeian"\n')
        for end in ("csv", "wkt", "toml"):
            (folder / f"corner.{end}").write_bytes((scenarios / f"corner.{end}").read_bytes())
        os.rename(folder / "corner.toml", folder / "crowd.claque")
        counts = []
        for file in ("person.claque", "crowd.claque"):
            process = subprocess.Popen(["osgviewer", file, "--window", "0", "0", "800", "600"], cwd=folder,
                                       env=dict(shown.environment, OSG_LIBRARY_PATH=str(plugins)),
                                       stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            until = time.monotonic() + 60
            colours = set()
            while time.monotonic() < until and process.poll() is None and len(colours) < 400:
                time.sleep(1)
                picture = shown.picture()
                colours = {picture.at(x, y) for y in range(0, 600, 2) for x in range(0, 800, 2)}
            picture.save(out / f"osgviewer-{file.split('.')[0]}.png")
            moved = moved_pixels(shown, 20) if file == "crowd.claque" else None
            process.terminate()
            said, _ = process.communicate()
            assert len(colours) >= 400, f"{file}: {len(colours)} colours: {said}"
            assert moved is None or moved >= 200, f"{file}: {moved} pixels change while people walk"
            counts.append(f"{file}: {len(colours)} colours" + ("" if moved is None else f", {moved} pixels move"))
    return ", ".join(counts)
