"""What is drawn, by which driver, and what has to come of it."""
import dataclasses

NAMED = {"llvmpipe": "llvmpipe", "swiftshader": "SwiftShader"}  # how the drivers call themselves


@dataclasses.dataclass
class Case:
    name: str
    what: str  # a scene of claque, or a file among the assets
    options: tuple = ("--size", "640x480")
    driver: str = "llvmpipe"
    times: int = 1
    tolerance: str = "gpu"
    mistake: str = ""
    report: bool = False  # the page of its comparison is opened, too

    @property
    def scene(self):
        return self.name if "." in self.what else self.what

    wanted = "pass gpu"

    def wrong_without_result(self, text):
        return text

    def wrong_in(self, verdict, measures, renderer):
        """A sentence on what is not as it has to be, or none."""
        if NAMED[self.driver] not in renderer:
            return f"drawn by {renderer}"
        return self.wrong_measures(verdict, measures)

    def wrong_measures(self, verdict, measures):
        return broken(measures) if verdict != "pass" else ""


def broken(measures, groups=("",)):
    said = [f"{name} is {m['value']:.3g}" for name, m in measures.items()
            if name.startswith(tuple(groups)) and m.get("kept") is False]
    return ", ".join(said)


class Vertices(Case):
    """SwiftShader places vertices on a 16th of a pixel: its pictures differ, its vertices do not."""

    wanted = "pass gpu with its vertices"

    def wrong_measures(self, verdict, measures):
        groups = ("actors.", "positions.", "normals.")
        if not all(any(name.startswith(group) for name in measures) for group in groups):
            return "vertices were not compared"
        return broken(measures, groups)


class Individuals(Vertices):
    """Drawn 16 times as large, it is a second rasteriser for silhouettes."""

    wanted = "the same, and show other people on at most 1 pixel in 10^5"

    def wrong_measures(self, verdict, measures):
        different = measures["actor_ids.different"]["value"]
        return super().wrong_measures(verdict, measures) or (
            f"actor_ids.different is {different:.3g}" if different > 1e-5 else "")


class Mistake(Case):
    """A broken page, to show that the comparison can fail."""

    wanted = "fail gpu"

    def wrong_measures(self, verdict, measures):
        return "the mistake passes" if verdict != "fail" else ""


class Shader(Mistake):
    wanted = "stop at the error that the browser logs"

    def wrong_without_result(self, text):
        return "" if "the browser logs: THREE.WebGLProgram" in text else text

    def wrong_measures(self, verdict, measures):
        return "the browser drew with a shader that does not compile"


CHARACTERS = [
    "humanoids/kaykit/Mage.glb",
    "hipoly/mannequiny.glb",
    "humanoids/gdquest/gdbot.glb",
    "humanoids/quaternius-ultimate/Kimono_Female.gltf",
    "humanoids/kenney/character.glb",
    "humanoids/khronos/CesiumMan.glb",
]

ALL = [
    Case("odeon", "odeon", report=True),
    Case("ten_thousand", "ten_thousand"),
    Case("town_sky", "town_sky"),
    Case("plaza", "plaza"),
    *(Case(file.rsplit("/", 1)[1].rsplit(".", 1)[0], file, ("--size", "320x240")) for file in CHARACTERS),
    Vertices("odeon-swiftshader", "odeon", driver="swiftshader"),
    Individuals("odeon-16-times", "odeon", driver="swiftshader", times=16, report=True),
    *(Mistake(f"plaza-{name}", "plaza", mistake=name)
      for name in ("weight", "light", "srgb", "premultiplied", "atlas-row")),
    Shader("plaza-shader", "plaza", mistake="shader"),
]

# Changes of a report, by what has to be said of it then.
SPOILED = {
    "does not load": ("base64,iVBOR", "base64,iVBQR"),
    "overlap": ("</style>", "h2 { margin-top: -4rem; }</style>"),
    "reaches from": ("</style>", "table { min-width: 70rem; }</style>"),
    "is small": ("</style>", "td { font-size: 9px; }</style>"),
}
