"""The implementations of GL on which claque is tested: how each is chosen, and what must be there for it."""
import contextlib
import dataclasses
import pathlib
import platform
import shutil

import services

SYSTEM = pathlib.Path("/usr/lib") / f"{platform.machine()}-linux-gnu"
LAVAPIPE = pathlib.Path("/usr/share/vulkan/icd.d") / f"lvp_icd.{platform.machine()}.json"
SWIFTSHADER = pathlib.Path("/usr/lib/chromium/vk_swiftshader_icd.json")


@dataclasses.dataclass
class Driver:
    name: str
    says: str  # what GL_RENDERER and GL_VERSION must contain, else something else was tested
    context: str  # CLAQUE_CONTEXT: osmesa, egl, glx
    environment: dict = dataclasses.field(default_factory=dict)
    needs: tuple = ()  # (file or command, Debian package)
    service: object = None  # a context manager of services.py, which gets a folder and gives more environment
    left_out: tuple = ()  # (GoogleTest's filter, why); what other drivers of the same Mesa pass
    shares: str = ""  # its lines of shares.txt; its name if empty

    def absent(self):
        """What is missing, each with its package; empty if all is there."""
        return ", ".join(
            f"{thing} ({package})"
            for thing, package in self.needs
            if not (pathlib.Path(thing).exists() if "/" in thing else shutil.which(thing))
        )

    @contextlib.contextmanager
    def running(self, folder):
        """The environment of a program that draws with this driver."""
        with self.service(folder) if self.service else contextlib.nullcontext({}) as more:
            yield {"CLAQUE_CONTEXT": self.context, "XDG_RUNTIME_DIR": str(folder), **self.environment, **more}


NO_565 = ("*Rgb565*", "it has no surfaces of RGB565")
ZINK_ENDS = ("DisruptiveHooks*", "zink ends in its own code, in some runs and at calls that differ")
EGL = ((str(SYSTEM / "libEGL.so.1"), "libegl1"), (str(SYSTEM / "libEGL_mesa.so.0"), "libegl-mesa0"))
XVFB = ((str(SYSTEM / "libGL.so.1"), "libgl1"), ("Xvfb", "xvfb"))
ZINK = {"LIBGL_ALWAYS_SOFTWARE": "1", "GALLIUM_DRIVER": "zink"}


def indirect(folder):
    return services.x_server(folder, indirect=True)


def installed():
    """Those of the installed Mesa. The first is what pictures are compared with."""
    return [
        Driver("llvmpipe-256", "256 bits", "egl", {"GALLIUM_DRIVER": "llvmpipe", "LP_NATIVE_VECTOR_WIDTH": "256"}, EGL),
        Driver("llvmpipe-128", "128 bits", "egl", {"GALLIUM_DRIVER": "llvmpipe", "LP_NATIVE_VECTOR_WIDTH": "128"}, EGL),
        Driver("osmesa", "OSMesa, llvmpipe", "osmesa", {}, ((str(SYSTEM / "libOSMesa.so.8"), "libosmesa6"),)),
        Driver("softpipe", "softpipe", "egl", {"GALLIUM_DRIVER": "softpipe"}, EGL),
        Driver(
            "zink-lavapipe",
            "zink (llvmpipe",
            "egl",
            {**ZINK, "VK_ICD_FILENAMES": str(LAVAPIPE)},
            (*EGL, (str(LAVAPIPE), "mesa-vulkan-drivers")),
            left_out=(NO_565, ZINK_ENDS),
        ),
        Driver(
            "zink-swiftshader",
            "zink (SwiftShader",
            "egl",
            {**ZINK, "VK_ICD_FILENAMES": str(SWIFTSHADER)},
            (*EGL, (str(SYSTEM / "libvulkan.so.1"), "libvulkan1"), (str(SWIFTSHADER), "chromium")),
            left_out=(
                NO_565,
                ("*WrappedAndClampedTextures*", "where a texture repeats, 6 of 43 000 pixels show another texel"),
                ("*ContinueBehindTheEye", "shadows of people behind the eye are missing"),
                ZINK_ENDS,
            ),
        ),
        Driver(
            "virpipe",
            "virgl",
            "egl",
            {},
            (*EGL, ("virgl_test_server", "virgl-server")),
            services.virgl_server,
            (
                ("*AgreeOnMirroredAndDoubleSided*", "binned and two-sided lighting together: triangles are missing"),
                ("DisruptiveHooks.ThatChangeWhat*", "the second picture is another one than the first"),
            ),
        ),
        Driver(
            "nvidia",
            "NVIDIA",
            "egl",
            {"CLAQUE_EGL_DEVICE": "0"},
            (EGL[0], ("/dev/nvidia0", "a GPU and NVIDIA's driver")),
        ),
        Driver("glx", "GLX, llvmpipe", "glx", {}, XVFB, services.x_server, (NO_565,)),
        Driver(
            "glx-indirect",
            "GLX indirect",
            "glx",
            {},
            (*XVFB, (str(SYSTEM / "libglapi.so.0"), "Debian 12's libglapi-mesa"), ("nm", "binutils"), ("cc", "gcc")),
            indirect,
            (NO_565, ("*ThatLeaveWhatCannotBeUndone*", "GL 1.4 has neither the buffers nor the programs")),
        ),
    ]


def unpacked(folder):
    """Those of the Mesas whose packages are unpacked in the folders of `folder`."""
    drivers = []
    for root in sorted(path for path in pathlib.Path(folder).iterdir() if path.is_dir() and (path / "usr").is_dir()):
        libraries = root / SYSTEM.relative_to("/")
        environment = {
            "LD_LIBRARY_PATH": str(libraries),
            "LIBGL_DRIVERS_PATH": str(libraries / "dri"),
            "__EGL_VENDOR_LIBRARY_FILENAMES": str(root / "usr/share/glvnd/egl_vendor.d/50_mesa.json"),
        }
        for context, says, library in (("osmesa", "OSMesa", "libOSMesa.so.8"), ("egl", "EGL", "libEGL_mesa.so.0")):
            needs = ((str(libraries / library), "its package"),)
            drivers.append(Driver(f"{root.name}-{context}", says, context, environment, needs, shares="other-mesa"))
    return drivers
