"""Bare Debian systems: debootstrap's smallest, each in a folder. Needs root, debootstrap and Debian's archive."""
import os
import pathlib
import shutil
import subprocess

MOUNTS = 'mount -t proc proc "$0/proc" && mount -t sysfs sys "$0/sys" && mount --rbind /dev "$0/dev"'
VARIABLES = ["PATH=/usr/sbin:/usr/bin:/sbin:/bin", "HOME=/root", "LC_ALL=C", "DEBIAN_FRONTEND=noninteractive"]


class Failed(Exception):
    pass


def lacking():
    """What this machine lacks to make bare systems; empty: nothing."""
    absent = [name for name in ("debootstrap", "unshare", "chroot", "git") if not shutil.which(name)]
    return absent or ([] if os.geteuid() == 0 else ["root"])


class Bare:
    """A system in a folder. Commands run there as root, with no variables of this process."""

    def __init__(self, suite, root):
        self.suite, self.root = suite, pathlib.Path(root)

    @classmethod
    def fetch(cls, suite, root, log):
        scripts = pathlib.Path("/usr/share/debootstrap/scripts")
        # All suites since 2008 have the script of sid; the empty word stands for the default mirror.
        script = [] if (scripts / suite).exists() else ["", str(scripts / "sid")]
        with open(log, "w") as out:
            command = ["debootstrap", "--variant=minbase", suite, str(root), *script]
            if subprocess.run(command, stdout=out, stderr=out).returncode != 0:
                raise Failed(f"debootstrap could not fetch {suite}: see {log}")
        made = cls(suite, root)
        made.root.chmod(0o755)
        shutil.copy("/etc/resolv.conf", made.root / "etc/resolv.conf")
        for file in pathlib.Path("/etc/apt/apt.conf.d").glob("*proxy*"):
            shutil.copy(file, made.root / "etc/apt/apt.conf.d")
        # A mirror of testing may be older than its list is valid for.
        (made.root / "etc/apt/apt.conf.d/valid").write_text('Acquire::Check-Valid-Until "false";\n')
        return made

    def copy(self, name):
        other = self.root.with_name(f"{self.root.name}-{name}")
        subprocess.run(["cp", "-a", "--reflink=auto", self.root, other], check=True)
        return Bare(self.suite, other)

    def remove(self):
        shutil.rmtree(self.root, ignore_errors=True)

    def run(self, script, folder="/", log=None):
        """What the script writes, which goes into the file `log` as well. Mounts end with the namespace."""
        enter = f'{MOUNTS} && exec chroot "$0" env -i "$@"'
        inside = ["sh", "-ec", f"cd {folder}\n{script}"]
        command = ["unshare", "-m", "sh", "-c", enter, str(self.root), *VARIABLES, *inside]
        if log:
            with open(log, "w") as out:
                code = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=out, stderr=out).returncode
            said = pathlib.Path(log).read_text(errors="replace")
        else:
            done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE)
            code, said = done.returncode, done.stdout.decode(errors="replace")
        if code != 0:
            raise Failed(f"{self.suite}: '{script.strip().splitlines()[0]}' ended with {code}: {said.strip()[-600:]}")
        return said
