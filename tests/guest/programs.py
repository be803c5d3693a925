"""Programs that know nothing of claque, and how a recording of their calls is made."""
import contextlib
import dataclasses
import os
import shutil
import signal
import subprocess
import time

CHECK_S = 0.5
MOST_BYTES = 1 << 30  # of a recording


class Failed(Exception):
    """A program that is installed did not show enough frames."""


@dataclasses.dataclass
class Program:
    name: str
    package: str
    command: list
    presses: list  # seconds to wait before each press of Return, which leads from the menus into the game
    plays_s: float  # and seconds to go on after the last
    frames: int  # as many at least
    most_frames: int  # the rest is not replayed

    def absent(self):
        return "" if shutil.which(self.command[0]) else f"{self.command[0]} ({self.package})"


PROGRAMS = [
    Program("glxgears", "mesa-utils", ["glxgears", "-geometry", "640x480"], [], 6, 50, 300),
    Program("etr", "extremetuxracer", ["/usr/games/etr"], [10, 3, 3, 3, 4], 12, 100, 600),
    Program("gltron", "gltron", ["/usr/games/gltron", "-w"], [10, 3, 3], 8, 100, 600),
    Program("torcs", "torcs", ["/usr/games/torcs"], [15, 3, 3, 4, 8], 40, 60, 300),
]
TOOLS = (("apitrace", "apitrace"), ("glretrace", "apitrace"), ("xdotool", "xdotool"), ("Xvfb", "xvfb"))


def wait(process, seconds, trace):
    """False once the program has ended or written enough."""
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        if process.poll() is not None or (trace.exists() and trace.stat().st_size > MOST_BYTES):
            return False
        time.sleep(CHECK_S)
    return True


def end(process):
    """The program and its children; apitrace writes the rest of the recording."""
    for number in (signal.SIGTERM, signal.SIGKILL):
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, number)
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(10)
            return


def record(program, environment, trace):
    home = trace.parent / f"{program.name}-home"
    shutil.rmtree(home, ignore_errors=True)
    home.mkdir(parents=True)
    trace.unlink(missing_ok=True)
    environment = {**environment, "HOME": str(home), "XDG_CONFIG_HOME": str(home), "XDG_RUNTIME_DIR": str(home)}
    environment |= {"SDL_AUDIODRIVER": "dummy", "ALSOFT_DRIVERS": "null"}
    with open(trace.with_suffix(".log"), "w") as log:
        process = subprocess.Popen(
            ["apitrace", "trace", "--api", "gl", "--output", str(trace), *program.command],
            env=environment,
            cwd=home,
            stdout=log,
            stderr=log,
            start_new_session=True,
        )
        try:
            for seconds in program.presses:
                if not wait(process, seconds, trace):
                    break
                subprocess.run(["xdotool", "key", "Return"], env=environment, stdout=log, stderr=log, check=False)
            wait(process, program.plays_s, trace)
        finally:
            end(process)
    if not trace.exists():
        raise Failed(f"{program.name} made no recording; see {trace.with_suffix('.log')}")
