"""The copy of the tree in build/mutants: what it holds, and how it is built."""
import os
import pathlib
import shutil
import subprocess

from mutants import fail

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parent.parent
ROOT = SOURCE / "build" / "mutants"
TREE = ROOT / "tree"
BUILD = TREE / "build" / "mutants"
LOG = ROOT / "log"


def read_tree():
    """The files of the tree, which may change while this runs: {name: bytes}."""
    return {name: (SOURCE / name).read_bytes() for name in tree_files()}


def tree_files():
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=SOURCE, capture_output=True,
                            text=True)
    if listed.returncode == 0:
        return [name for name in listed.stdout.splitlines() if (SOURCE / name).is_file()]
    found = []
    for folder, folders, names in os.walk(SOURCE):
        folders[:] = [f for f in folders if f not in ("build", "out", ".git")]
        found += [os.path.relpath(os.path.join(folder, name), SOURCE) for name in names]
    return found


def write_tree(source, texts):
    """Writes the tree into the copy, with these texts. A file of equal bytes keeps its time and is not built again."""
    for name, original in source.items():
        copy = TREE / name
        content = texts[name].encode() if name in texts else original
        if not copy.is_file() or copy.read_bytes() != content:
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_bytes(content)
            copy.chmod((SOURCE / name).stat().st_mode)
    for folder, folders, files in os.walk(TREE):
        folders[:] = [f for f in folders if f != "build"]
        for name in files:
            if os.path.relpath(os.path.join(folder, name), TREE) not in source:
                os.remove(os.path.join(folder, name))
    shared = ROOT / "shared"
    if (SOURCE.parent / "shared").is_dir() and not shared.exists():
        shared.symlink_to((SOURCE.parent / "shared").resolve())


def run_logged(command, environment=None, limit_s=None, to=LOG):
    """The exit status; None if it did not end in time."""
    with open(to, "w") as log:
        try:
            return subprocess.run(command, stdout=log, stderr=subprocess.STDOUT, cwd=BUILD, timeout=limit_s,
                                  env={**os.environ, **(environment or {})}).returncode
        except subprocess.TimeoutExpired:
            return None


def log_tail(log=LOG, lines=15):
    return "\n".join(log.read_text(errors="replace").splitlines()[-lines:])


COMPILE = {"CCACHE_BASEDIR": str(TREE), "CCACHE_SLOPPINESS": "pch_defines,time_macros"}


def configure():
    BUILD.mkdir(parents=True, exist_ok=True)
    if (BUILD / "compile_commands.json").exists():  # of an older tree, which may lack a test
        if run_logged(["ninja", "-C", str(BUILD), "build.ninja"], COMPILE) != 0:
            fail(f"the copy cannot be configured again\n{log_tail()}")
        return
    flags = "-O1 -DNDEBUG"
    command = ["cmake", "-S", str(TREE), "-B", str(BUILD), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=None",
               "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
               f"-DCMAKE_CXX_FLAGS={flags}", f"-DCMAKE_C_FLAGS={flags}", "-DCMAKE_UNITY_BUILD=ON",
               "-DCMAKE_UNITY_BUILD_BATCH_SIZE=12", "-DCLAQUE_TESTS=ON", "-DCLAQUE_BENCHMARKS=OFF"]
    if shutil.which("ccache"):
        command += ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache", "-DCMAKE_C_COMPILER_LAUNCHER=ccache"]
    if run_logged(command, COMPILE) != 0:
        fail(f"the copy cannot be configured\n{log_tail()}")


def build(targets, jobs):
    return run_logged(["cmake", "--build", str(BUILD), "-j", str(jobs), "--target", *sorted(targets)], COMPILE) == 0
