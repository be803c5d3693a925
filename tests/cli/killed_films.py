#!/usr/bin/env python3
"""Kills processes of films at random moments, and demands that every film is whole and every picture the same.

killed_films.py CLAQUE [--kills N] [--seed S]: N workers of `claque render --processes`, N ranks of
`mpirun claque render`, N jobs of an array (`--chunk`), each killed by SIGKILL. A worker is replaced while the film goes
on. A rank ends its job, and a job of an array ends alone; both are started again until their frames are there. Ranks
are left out, and it says so, where there is no mpirun.
"""
import argparse
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

FRAMES = 120
SCENE = ["render", "--scene", "plaza", "--count", "12", "--size", "64x48", "--threads", "1"]
MPI = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
       "OMPI_MCA_btl": "self,vader", "OMPI_MCA_plm_rsh_agent": "/bin/false"}


def film_words(folder, manifest="film.json"):
    return SCENE + ["--frames", f"0:{FRAMES - 1}", "--out", f"{folder}/f-%03d.png",
                    "--manifest", f"{folder}/{manifest}"]


def pictures(folder):
    return {path.name: path.read_bytes() for path in sorted(folder.glob("*.png"))}


def children(process):
    try:
        return [int(one) for one in pathlib.Path(f"/proc/{process}/task/{process}/children").read_text().split()]
    except OSError:
        return []


class Trial:
    def __init__(self, command, folder, dice, length_s):
        self.command, self.folder, self.dice, self.length_s = command, folder, dice, length_s
        self.killed = 0

    def start(self, words):
        return subprocess.Popen(words, env={**os.environ, **MPI}, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                text=True)

    def pause(self, share):
        time.sleep(self.dice.uniform(0, share * self.length_s))

    def kill(self, process):
        try:
            os.kill(process, signal.SIGKILL)
        except ProcessLookupError:
            return
        self.killed += 1

    def end(self, running):
        said = running.communicate()[1]
        return running.returncode, said

    def workers(self):
        """One film, of which several workers end."""
        divide = self.dice.choice(["frames", "tiles"])
        running = self.start([self.command, *film_words(self.folder), "--processes", "3", "--divide", divide])
        for _ in range(10):  # fewer than end the command where no worker gets to its first frame
            self.pause(0.3)
            ones = children(running.pid)
            if running.poll() is None and ones:
                self.kill(self.dice.choice(ones))
        return self.end(running)

    def ranks(self):
        """One film; each of its jobs but the last loses a rank."""
        for attempt in range(4):
            divide = self.dice.choice(["frames", "tiles"])
            mpirun = ["mpirun", "--map-by", "slot:oversubscribe", "-n", "3"]
            running = self.start([*mpirun, self.command, *film_words(self.folder), "--divide", divide])
            if attempt < 3:
                self.pause(1)
                ones = children(running.pid)
                if running.poll() is None and ones:
                    self.kill(self.dice.choice(ones))
            code, said = self.end(running)
            if code == 0:
                break
            if not said.strip():
                return code, "a job that lost a rank ended without a word"
        return code, said

    def jobs(self):
        """An array of three jobs, each of which may be killed several times."""
        for share in range(3):
            words = [self.command, *film_words(self.folder, f"share-{share}.json"), "--chunk", f"{share}/3"]
            for attempt in range(3):
                running = self.start(words)
                if attempt < 2:
                    self.pause(0.5)
                    if running.poll() is None:
                        self.kill(running.pid)
                code, said = self.end(running)
                if code == 0:
                    break
            if code != 0:
                return code, said
        return subprocess.run([self.command, "frames", "check", str(self.folder), "--frames", f"0:{FRAMES - 1}"],
                              capture_output=True, text=True).returncode, "frames check"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", metavar="CLAQUE")
    parser.add_argument("--kills", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    command = str(pathlib.Path(asked.command).resolve())
    kinds = ["workers", "ranks", "jobs"]
    if not shutil.which("mpirun") or not pathlib.Path(command).with_name("claque-mpi.so").exists():
        print("ranks are left out: there is no mpirun, or no claque-mpi.so beside the command")
        kinds.remove("ranks")
    with tempfile.TemporaryDirectory() as scratch:
        whole = pathlib.Path(scratch, "whole")
        whole.mkdir()
        begun = time.monotonic()
        subprocess.run([command, *film_words(whole)], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        length_s = time.monotonic() - begun
        expected = pictures(whole)
        if len(expected) != FRAMES:
            sys.exit(f"one process drew {len(expected)} of {FRAMES} pictures")
        for kind in kinds:
            dice, killed, films = random.Random(f"{asked.seed} {kind}"), 0, 0
            while killed < asked.kills:
                folder = pathlib.Path(scratch, "film")
                folder.mkdir()
                trial = Trial(command, folder, dice, length_s)
                code, said = getattr(trial, kind)()
                killed, films = killed + trial.killed, films + 1
                if code != 0:
                    sys.exit(f"{kind}, film {films}: ended with {code}: {said}")
                if pictures(folder) != expected:
                    sys.exit(f"{kind}, film {films}: its pictures are not those of one process")
                if films > 20 + asked.kills:
                    sys.exit(f"{kind}: {films} films ended before {asked.kills} could be killed")
                shutil.rmtree(folder)
            print(f"{kind}: {killed} were killed in {films} films of {FRAMES} frames, all whole and the same",
                  flush=True)


if __name__ == "__main__":
    main()
