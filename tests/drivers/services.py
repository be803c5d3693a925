"""Programs that drivers need beside the tests: X servers, a GL server. Each ends with its context."""
import contextlib
import os
import pathlib
import re
import signal
import subprocess
import time

START_S = 30
VIRGL_SOCKET = pathlib.Path("/tmp/.virgl_test")  # Mesa's client knows no other

# What an X server calls of GL, and from where. Through glvnd's libGL it would call functions without a context: the
# server makes its contexts by itself and tells Mesa's dispatch alone.
DISPATCH = """extern void *_glapi_get_proc_address(const char *);
void *claque_gl[{count}];
static const char *const names[] = {{{names}}};
__attribute__((constructor)) static void find(void)
{{
    for (int i = 0; i < {count}; ++i) claque_gl[i] = _glapi_get_proc_address(names[i]);
}}
void *glXGetProcAddressARB(const char *name) {{ return _glapi_get_proc_address(name); }}
{jumps}
"""
JUMP = '__asm__(".globl {0}\\n.type {0}, @function\\n{0}: movq claque_gl@GOTPCREL(%rip), %r11\\njmp *{1}(%r11)\\n");'


class Failed(Exception):
    """A program that is installed does not start."""


def end(process):
    process.terminate()
    try:
        process.wait(10)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


def server_gl(folder):
    """Makes the libGL.so.1 of an X server that draws for its clients."""
    needed = subprocess.run(["nm", "-D", "/usr/bin/Xvfb"], capture_output=True, text=True, check=True).stdout
    names = re.findall(r" U (gl[A-Z]\w+)", needed)
    names = [name for name in names if not name.startswith("glX")]
    source = folder / "server_gl.c"
    source.write_text(
        DISPATCH.format(
            count=len(names),
            names=", ".join(f'"{name}"' for name in names),
            jumps="\n".join(JUMP.format(name, 8 * i) for i, name in enumerate(names)),
        )
    )
    library = folder / "server_gl"
    library.mkdir(exist_ok=True)
    command = ["cc", "-O1", "-fPIC", "-shared", "-Wl,-soname,libGL.so.1", "-o", str(library / "libGL.so.1")]
    done = subprocess.run([*command, str(source), "-l:libglapi.so.0"], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise Failed(f"the X server's libGL cannot be compiled: {done.stderr.strip().splitlines()[-1]}")
    return library


@contextlib.contextmanager
def x_server(folder, indirect=False):
    """The environment of clients of an Xvfb of their own."""
    environment = dict(os.environ)
    options = ["+iglx"] if indirect else []
    if indirect:
        environment["LD_LIBRARY_PATH"] = str(server_gl(folder))
    read, write = os.pipe()
    command = ["Xvfb", "-displayfd", str(write), "-screen", "0", "1024x768x24", "-noreset", "-nolisten", "tcp"]
    command += options
    with open(folder / "xvfb.log", "w") as log:
        process = subprocess.Popen(command, pass_fds=[write], env=environment, stdout=log, stderr=log)
    os.close(write)
    try:
        with os.fdopen(read) as number:
            display = number.readline().strip()
        if not display:
            raise Failed(f"Xvfb does not start; see {folder / 'xvfb.log'}")
        clients = {"DISPLAY": f":{display}"}
        if indirect:
            clients["LIBGL_ALWAYS_INDIRECT"] = "1"
        yield clients
    finally:
        end(process)


@contextlib.contextmanager
def virgl_server(folder):
    """The environment of clients of a GL server."""
    if VIRGL_SOCKET.exists():
        raise Failed(f"{VIRGL_SOCKET} is there: another virgl_test_server runs, or one left it")
    with open(folder / "virgl.log", "w") as log:
        process = subprocess.Popen(
            ["virgl_test_server", "--use-egl-surfaceless"],
            env={**os.environ, "LIBGL_ALWAYS_SOFTWARE": "1"},
            stdout=log,
            stderr=log,
            start_new_session=True,  # it forks for each client
        )
    try:
        until = time.monotonic() + START_S
        while not VIRGL_SOCKET.exists():
            if process.poll() is not None or time.monotonic() > until:
                raise Failed(f"virgl_test_server does not start; see {folder / 'virgl.log'}")
            time.sleep(0.05)
        yield {"GALLIUM_DRIVER": "virpipe"}
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGTERM)
        process.wait()
        VIRGL_SOCKET.unlink(missing_ok=True)
