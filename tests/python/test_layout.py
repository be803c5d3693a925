"""The structs of claque.abi have the layout that a C compiler gives those of the headers."""

import ctypes
import os
import pathlib
import shutil
import subprocess

import pytest

from claque import abi

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMPILER = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")


def asked_of_the_compiler(folder):
    lines = []
    for name, struct in abi.STRUCTS.items():
        lines.append(f'printf("{name} %zu\\n", sizeof({name}));')
        for field in struct._fields_:
            lines.append(f'printf("{name}.{field[0]} %zu\\n", offsetof({name}, {field[0]}));')
    source = folder / "layout.c"
    source.write_text(
        "#include <stddef.h>\n#include <stdio.h>\n#include <claque/claque.h>\n#include <claque/mesh.h>\n"
        "#include <claque/prepare.h>\n#include <claque/trajectories.h>\n#include <claque/drawn_actor.h>\n"
        "#include <claque/stage.h>\nint main(void){"
        + "\n".join(lines)
        + "return 0;}"
    )
    subprocess.run(
        [
            COMPILER,
            "-std=c99",
            "-I",
            os.environ.get("CLAQUE_INCLUDE_DIR", ROOT / "include"),
            source,
            "-o",
            folder / "layout",
        ],
        check=True,
    )
    out = subprocess.run([folder / "layout"], check=True, capture_output=True, text=True).stdout
    return dict((line.rsplit(" ", 1)[0], int(line.rsplit(" ", 1)[1])) for line in out.splitlines())


@pytest.mark.skipif(not COMPILER, reason="there is no C compiler")
def test_structs_are_laid_out_as_the_headers_say(tmp_path):
    asked = asked_of_the_compiler(tmp_path)
    ours = {}
    for name, struct in abi.STRUCTS.items():
        ours[name] = ctypes.sizeof(struct)
        for field in struct._fields_:
            ours[f"{name}.{field[0]}"] = getattr(struct, field[0]).offset
    assert ours == asked


def test_a_struct_of_another_size_is_refused_by_the_library(context):
    definition = abi.ContextDef()
    definition.struct_bytes = ctypes.sizeof(definition) - 4
    with pytest.raises(abi.Error) as refused:
        abi.call("clq_context_create", ctypes.byref(definition), ctypes.byref(ctypes.c_void_p()))
    assert refused.value.status is abi.Status.STRUCT_SIZE
