#!/usr/bin/env python3
"""Draws a crowd into a corner of programs that know nothing of claque, and looks at everything else.

run.py [--build FOLDER] [--keep] [PROGRAM...]: without names, all. Each program is recorded by apitrace under Xvfb, and
the recording is replayed: twice alone, then with the guest (samples/guest) in each guard mode. --keep replays the
recordings of an earlier run. In guard mode full no pixel outside the corner may change from the second frame on, and
no state by any draw; in the modes minimal and none a draw leaves nothing else changed than passes/guard.h lists. The
replays alone must agree, and the corner must show the guest. What is not installed is named in the table and counts as
absent. The exit status is 1 if anything else was seen.
"""
import argparse
import collections
import os
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parent.parent
sys.path[:0] = [str(HERE.parent), str(HERE.parent / "drivers")]

import programs  # noqa: E402
import services  # noqa: E402
from named_runs import run_named  # noqa: E402
from replays import LEFT_BY, differing, failures, read  # noqa: E402

REPLAY_S = 1200

Result = collections.namedtuple("Result", "program absent frames changed left failed")


def replay(program, trace, build, environment, name, guard=None):
    """What the witness saw; with a guest if a guard mode is given."""
    path = trace.with_name(f"{program.name}-{name}.txt")
    path.unlink(missing_ok=True)
    preload = [build / "tests/guest/libclaque_guest_witness.so"]
    environment = {**environment, "CLAQUE_WITNESS": str(path), "CLAQUE_WITNESS_FRAMES": str(program.most_frames)}
    if guard:
        preload.insert(0, build / "samples/libclaque-guest.so")
        environment["CLAQUE_GUEST_GUARD"] = guard
    environment["LD_PRELOAD"] = " ".join(str(library) for library in preload)
    with open(path.with_suffix(".log"), "w") as log:
        done = subprocess.run(
            ["glretrace", "-b", str(trace)], env=environment, stdout=log, stderr=log, timeout=REPLAY_S, check=False
        )
    if not path.exists():
        raise programs.Failed(f"the replay {name} showed nothing and ended with {done.returncode}; see {log.name}")
    return read(path)


def run(program, build, keep):
    folder = SOURCE / "out" / "guest"
    folder.mkdir(parents=True, exist_ok=True)
    absent = ", ".join(filter(None, [program.absent(), *missing_tools()]))
    if absent:
        return Result(program, absent, 0, {}, {}, [])
    trace = folder / f"{program.name}.trace"
    try:
        with services.x_server(folder) as x_server:
            environment = {**os.environ, **x_server}
            if not (keep and trace.exists()):
                programs.record(program, environment, trace)
            alone, again = (replay(program, trace, build, environment, name) for name in ("alone", "again"))
            guests = {guard: replay(program, trace, build, environment, guard, guard) for guard in LEFT_BY}
    except (programs.Failed, services.Failed, subprocess.TimeoutExpired) as error:
        return Result(program, "", 0, {}, {}, [str(error)])
    changed = {guard: differing(alone, guest, 0) for guard, guest in guests.items()}
    left = {guard: len(guest.left) for guard, guest in guests.items()}
    return Result(program, "", len(alone.frames), changed, left, failures(program, alone, again, guests))


def missing_tools():
    return [f"{tool} ({package})" for tool, package in programs.TOOLS if not shutil.which(tool)]


def table_of(results):
    heads = ["frames", *(f"{guard}: frames changed outside, states left" for guard in LEFT_BY), "failed"]
    lines = ["| program | " + " | ".join(heads) + " |", "|---" * (len(heads) + 1) + "|"]
    for r in results:
        if r.absent:
            lines.append(f"| {r.program.name} | absent: needs {r.absent} |" + " |" * (len(heads) - 1))
            continue
        cells = [f"{r.changed[guard]}, {r.left[guard]}" if r.changed else "" for guard in LEFT_BY]
        lines.append(f"| {r.program.name} | {r.frames} | " + " | ".join(cells) + f" | {len(r.failed)} |")
    for r in results:
        lines += [f"{r.program.name} failed: {failure}" for failure in r.failed]
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=pathlib.Path, default=SOURCE / "build" / "release")
    parser.add_argument("--keep", action="store_true", help="replay the recordings of an earlier run")
    parser.add_argument("programs", nargs="*", metavar="PROGRAM")
    given = parser.parse_args()
    known = {program.name: program for program in programs.PROGRAMS}
    build = given.build.resolve()
    run_named(
        parser, given.programs, known, lambda name: run(known[name], build, given.keep), table_of,
        SOURCE / "out" / "guest.md",
    )


if __name__ == "__main__":
    main()
