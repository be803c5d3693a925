"""Pictures of scenes by the claque command, and in how many pixels two of them differ."""
import json
import subprocess

WIDTH, HEIGHT = 640, 480
STEPS = 8  # differences of a channel up to this are roundings of colours, others are edges of triangles

SCENES = {
    "plaza": ["--scene", "plaza", "--count", "200"],
    "odeon-close": ["--scene", "odeon", "--camera", "close"],
}
STRATEGIES = ("fused", "binned", "per-zone")


class Failed(Exception):
    """The command drew nothing."""


def draw(command, scene, strategy, environment, folder):
    """(RGB of the pixels, what GL says of itself)."""
    report = folder / f"{scene}-{strategy}.json"
    given = ["--size", f"{WIDTH}x{HEIGHT}", "--strategy", strategy, "--out", "-", "--json", str(report)]
    done = subprocess.run(
        [command, "render", *SCENES[scene], *given], env=environment, capture_output=True, timeout=600, check=False
    )
    (folder / f"{scene}-{strategy}.log").write_bytes(done.stderr)
    if done.returncode != 0 or len(done.stdout) != 3 * WIDTH * HEIGHT:
        said = done.stderr.decode(errors="replace").strip().splitlines()
        raise Failed(f"{scene}, {strategy}: claque render ended with {done.returncode}: {said[-1] if said else ''}")
    return done.stdout, json.loads(report.read_text())["context"]


def differing(a, b):
    """Shares of the pixels that differ: at all, and by more than STEPS in a channel."""
    if len(a) != len(b) or not a:
        return 1.0, 1.0
    some = more = 0
    for i in range(0, len(a), 3):
        if a[i : i + 3] != b[i : i + 3]:
            some += 1
            more += any(abs(x - y) > STEPS for x, y in zip(a[i : i + 3], b[i : i + 3]))
    return 3 * some / len(a), 3 * more / len(a)


def read_shares(path):
    """{(driver, scene): (share that may differ, share that may differ by more than STEPS)}."""
    shares = {}
    for number, line in enumerate(path.read_text().splitlines(), 1):
        words = line.split("#")[0].split()
        if not words:
            continue
        if len(words) != 4 or words[1] not in SCENES:
            raise ValueError(f"{path}:{number}: a line has a driver, a scene ({', '.join(SCENES)}) and two shares")
        shares[words[0], words[1]] = (float(words[2]), float(words[3]))
    return shares
