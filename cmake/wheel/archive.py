"""A folder as a wheel (PEP 427) whose bytes depend on the folder's contents and one time alone."""

import base64
import hashlib
import pathlib
import shutil
import time
import zipfile


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


def copy(source, path):
    path.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(source, path)


def _row(name, data):
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(data)}\n"


def pack(tree, about, wheel, seconds):
    """The files of `tree`, sorted, those of the folder `about` last; RECORD lists them and is the very last."""
    files = sorted((path for path in tree.rglob("*") if path.is_file()),
                   key=lambda path: (about in path.parents, path.relative_to(tree).as_posix()))
    record = about / "RECORD"
    rows = "".join(_row(path.relative_to(tree).as_posix(), path.read_bytes()) for path in files)
    write(record, rows + f"{record.relative_to(tree).as_posix()},,\n")
    when = time.gmtime(max(seconds, 315532800))[:6]  # a zip file knows no time before 1980
    part = pathlib.Path(f"{wheel}.part")
    with zipfile.ZipFile(part, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as packed:
        for path in files + [record]:
            entry = zipfile.ZipInfo(path.relative_to(tree).as_posix(), when)
            entry.external_attr = (0o100755 if path.parent.name in ("bin", "scripts") else 0o100644) << 16
            entry.create_system = 3  # whose modes pip reads
            entry.compress_type = zipfile.ZIP_DEFLATED
            packed.writestr(entry, path.read_bytes(), compresslevel=9)
    part.replace(wheel)
