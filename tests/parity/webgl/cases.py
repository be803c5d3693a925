"""What is drawn, by which driver, and what has to come of it."""
import dataclasses
import math

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
        broken = [f"{name} is {m['value']:.3g}" for name, m in measures.items() if m.get("kept") is False]
        return "" if verdict == "pass" else ", ".join(broken) or f"the verdict is {verdict}"


@dataclasses.dataclass
class Coarse(Case):
    """SwiftShader rounds vertices to a 16th of a pixel: its pictures differ, its vertices do not."""

    driver: str = "swiftshader"
    tolerance: str = "coarse"
    wanted = "pass coarse, and gpu with its vertices"
    limits = {"positions.max_relative": 1e-4, "normals.max_deg": 1}

    def wrong_measures(self, verdict, measures):
        values = {name: measures[name]["value"] if name in measures else math.inf for name in self.limits}
        over = [f"{name} is {value:.3g}" for name, value in values.items() if not value <= self.limits[name]]
        return super().wrong_measures(verdict, measures) or ", ".join(over)


class Individuals(Coarse):
    """Drawn 16 times as large, it is a second rasteriser for silhouettes."""

    wanted = "the same, and show other people on at most 1 pixel in 10^5"
    limits = {**Coarse.limits, "actor_ids.different": 1e-5}


class Mistake(Case):
    """A broken page, to show that the comparison can fail."""

    wanted = "fail"

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

# Mistakes of breaks.mjs: what every scene shows, and what `everything` was made for.
COMMON = ("weight", "light", "srgb", "premultiplied", "atlas-row")
RARE = ("second-set", "morphs", "inverse", "one-sided", "spot", "limit", "colours")

ALL = [
    Case("odeon", "odeon"),
    Case("ten_thousand", "ten_thousand"),
    Case("town_sky", "town_sky"),
    Case("plaza", "plaza"),
    Case("everything", "everything", report=True),
    *(Case(file.rsplit("/", 1)[1].rsplit(".", 1)[0], file, ("--size", "320x240")) for file in CHARACTERS),
    *(Coarse(f"{scene}-coarse", scene) for scene in ("odeon", "ten_thousand", "town_sky", "plaza", "everything")),
    Individuals("odeon-16-times", "odeon", times=16, report=True),
    *(Mistake(f"plaza-{name}", "plaza", mistake=name) for name in COMMON),
    *(Mistake(f"plaza-coarse-{name}", "plaza", driver="swiftshader", tolerance="coarse", mistake=name)
      for name in COMMON),
    *(Mistake(f"everything-{name}", "everything", mistake=name) for name in RARE),
    Shader("plaza-shader", "plaza", mistake="shader"),
]

# Changes of a report, by what has to be said of it then.
SPOILED = {
    "does not load": ("base64,iVBOR", "base64,iVBQR"),
    "overlap": ("</style>", "h2 { margin-top: -4rem; }</style>"),
    "reaches from": ("</style>", "table { min-width: 70rem; }</style>"),
    "is small": ("</style>", "td { font-size: 9px; }</style>"),
}
