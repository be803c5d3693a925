"""The tests of a build folder as CTest knows them, each run as CTest would."""
import json
import os
import pathlib
import re
import signal
import subprocess
import time


class Case:
    def __init__(self, test, build):
        properties = {p["name"]: p["value"] for p in test.get("properties", [])}
        self.name, self.command = test["name"].split("  #")[0], test["command"]  # without GetParam()
        self.directory = properties.get("WORKING_DIRECTORY", str(build))
        self.folder = os.path.relpath(self.directory, build)  # tests/unit/track
        self.limit_s = float(properties.get("TIMEOUT", 300))
        self.environment = dict(one.split("=", 1) for one in properties.get("ENVIRONMENT", []))
        for one in properties.get("ENVIRONMENT_MODIFICATION", []):
            name, change = one.split("=", 1)
            how, _, value = change.partition(":")
            if how == "set":
                self.environment[name] = value
        self.passes = properties.get("PASS_REGULAR_EXPRESSION", [])
        self.fails = properties.get("FAIL_REGULAR_EXPRESSION", [])
        self.skips = properties.get("SKIP_REGULAR_EXPRESSION", [])
        self.skip_status = properties.get("SKIP_RETURN_CODE")
        self.will_fail = properties.get("WILL_FAIL", False)
        self.seconds, self.reached = 0.0, frozenset()

    def judge(self, status, said):
        if self.skip_status is not None and status == int(self.skip_status) or \
                any(re.search(one, said) for one in self.skips):
            return "skipped"
        if any(re.search(one, said) for one in self.fails):
            return "failed"
        if status < 0:
            return "crashed"
        passed = any(re.search(one, said) for one in self.passes) if self.passes else status == 0
        return "passed" if passed != self.will_fail else "failed"

    def run(self, folder, limit_s, mutant=0, reached=None):
        """What happened in a word (passed, skipped, failed, crashed, endless), and the seconds."""
        files = folder / "files"
        files.mkdir(exist_ok=True)
        environment = {**os.environ, **self.environment, "CLAQUE_MUTANT": str(mutant), "GTEST_FAIL_FAST": "1",
                       "XDG_CACHE_HOME": str(folder / "cache"), "TMPDIR": str(files), "TEST_TMPDIR": str(files)}
        if reached:
            environment["CLAQUE_MUTANTS_REACHED"] = str(reached)
        begun = time.monotonic()
        with open(folder / "log", "wb") as log:
            process = subprocess.Popen(self.command, stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT,
                                       cwd=self.directory, env=environment, start_new_session=True)
            try:
                status = process.wait(limit_s)
            except subprocess.TimeoutExpired:
                status = None
            try:
                os.killpg(process.pid, signal.SIGKILL)  # with what it started
            except ProcessLookupError:
                pass
            process.wait()
        seconds = time.monotonic() - begun
        if status is None:
            return "endless", seconds
        with open(folder / "log", "rb") as log:
            return self.judge(status, log.read(1 << 22).decode(errors="replace")), seconds


def cases_of(build):
    listed = subprocess.run(["ctest", "--show-only=json-v1"], cwd=build, capture_output=True, text=True, check=True)
    tests = json.loads(listed.stdout)["tests"]
    return [Case(test, pathlib.Path(build)) for test in tests if test.get("command")]
