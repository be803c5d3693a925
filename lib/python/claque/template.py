"""Templates, their meshes and textures (claque/template.h, template_info.h, mesh.h, prepare.h)."""

import difflib
from ctypes import POINTER, byref, c_char_p, c_float, c_size_t, c_uint8, c_uint16, c_uint32, cast, pointer

import numpy

from . import abi
from .files import read_file
from .memory import borrowed
from .owner import Owned, made

BLENDS = None, "opaque", "mask"  # by number of clq_blend
COLOURS = "near", "wild", "own"  # of clq_colours


class ZoneMap:
    """Zones of one of a character's images: `texels` (height, width), the row at v = 0 first, are indices of `zones`,
    0xFFFF where the nearest zone is meant. A zone is its name, or (name, True): its texels become grey, so that it
    takes any colour."""

    def __init__(self, texels, zones, image=0):
        self._texels = numpy.ascontiguousarray(texels, numpy.uint16)
        if self._texels.ndim != 2 or not numpy.array_equal(self._texels, texels):
            raise ValueError(f"texels of shape {numpy.shape(texels)}; (height, width) of numbers from 0 to 0xFFFF are "
                             "wanted")
        named = [(zone, False) if isinstance(zone, str) else zone for zone in zones]
        self._zones = (abi.ZoneMapZone * len(named))(*((name.encode(), reduced) for name, reduced in named))
        height, width = self._texels.shape
        self.definition = abi.ZoneMapDef(image=image, width_px=width, height_px=height, zone_count=len(named),
                                         texels=self._texels.ctypes.data_as(POINTER(c_uint16)), zones=self._zones)


class Template(Owned):
    """A character that many individuals share, created by builtin(), load() or load_prepared()."""

    _destroy = "clq_template_destroy"

    @classmethod
    def builtin(cls, context, name, levels=False, folder="", zone_maps=()):
        """A built-in character: citizen, patrician, decurion, plebeian, herald or owl. `levels`: with levels of detail;
        `folder`: where the prepared template is stored (None: the user's cache folder; "": nowhere); `zone_maps`: a
        ZoneMap for each image that gets zones."""
        return cls._prepare(context, levels, folder, zone_maps, builtin=name.encode())

    @classmethod
    def load(cls, context, path, levels=False, folder="", zone_maps=(), turn_deg=0, height_m=0, scale=0,
             blend=None, colours="near"):
        """Reads a glTF or GLB file. `turn_deg`: turns it about y; `height_m` or `scale`: its size at rest, or a factor;
        `blend`: materials that blend are drawn where their alpha is 0.5 and more ("mask"; None: and a warning names
        them), or all of them ("opaque") (clq_asset_options). `colours`: individuals wear colours "near"
        those of the file, most hues ("wild"), or the file's "own"."""
        if blend not in BLENDS:
            raise ValueError(f"blend is {blend!r}: None, 'opaque' or 'mask' is wanted")
        if colours not in COLOURS:
            raise ValueError(f"colours is {colours!r}: 'near', 'wild' or 'own' is wanted")
        options = abi.AssetOptions(turn_deg=turn_deg, height_m=height_m, scale=scale, blend=BLENDS.index(blend),
                                   colours=COLOURS.index(colours))
        return cls._prepare(context, levels, folder, zone_maps, path=str(path).encode(),
                            options=cast(byref(options), POINTER(abi.AssetOptions)))

    @classmethod
    def load_prepared(cls, context, path):
        """Reads a prepared template that `claque prepare` wrote."""
        data = read_file(path)
        return cls(made("clq_template_load", abi.call, context.handle, data, c_size_t(len(data))), context)

    @classmethod
    def _prepare(cls, context, levels, folder, zone_maps, **source):
        definition = abi.PrepareDef(**source)
        maps = (POINTER(abi.ZoneMapDef) * len(zone_maps))(*(pointer(one.definition) for one in zone_maps))
        definition.zone_maps, definition.zone_map_count = maps, len(zone_maps)
        definition.folder = None if folder is None else str(folder).encode()
        chain = abi.LevelsDef()
        if levels:
            chain.tolerance_px, chain.metres_per_unit, chain.proxy_max_triangles = 1, 1, 250
            definition.levels = cast(byref(chain), POINTER(abi.LevelsDef))
        out = abi.c_void_p()
        abi.call("clq_template_prepare", context.handle, byref(definition), byref(out), None)
        return cls(out, context)

    @property
    def info(self):
        """The clq_template_info of the template."""
        out = abi.TemplateInfo()
        abi.call("clq_template_get_info", self.handle, byref(out))
        return out

    @property
    def name(self):
        return self.info.name.decode()

    @property
    def clips(self):
        """Lengths in seconds by name, in the order of clip indices."""
        found = {}
        for i in range(self.info.clip_count):
            out = abi.ClipInfo()
            abi.call("clq_template_get_clip", self.handle, i, byref(out))
            found[out.name.decode()] = out.duration_s
        return found

    @property
    def zones(self):
        """Names, in the order of zone indices."""
        names = []
        for i in range(self.info.zone_count):
            out = abi.ZoneInfo()
            abi.call("clq_template_get_zone", self.handle, i, byref(out))
            names.append(out.name.decode())
        return names

    def clip(self, name):
        """The index of a clip. Raises KeyError with the names that are near, or else with all."""
        names = list(self.clips)
        if name not in names:
            raise self._lacks("clip", name, names)
        return names.index(name)

    def node(self, name):
        """The index of a node. Raises KeyError with the names that are near, or else with all."""
        found = abi.library().function("clq_template_find_node", c_uint32)(self.handle, name.encode())
        if found == abi.NONE:
            name_of = abi.library().function("clq_template_get_node_name", c_char_p)
            raise self._lacks("node", name, [name_of(self.handle, i).decode(errors="replace")
                                             for i in range(self.info.node_count)])
        return found

    def _lacks(self, kind, name, names):
        near = difflib.get_close_matches(name, names, 3)
        told = f"near are {', '.join(near)}" if near else f"it has {', '.join(names)}"
        return KeyError(f"{self.name} has no {kind} {name!r}; {told}")

    def mesh(self, level=0):
        """The bind pose of a level: a dict of positions, normals (n, 3) and uvs (n, 2), which are views of the
        template's memory, and of joints, weights (n, influences)."""
        out = abi.Mesh()
        abi.call("clq_template_get_mesh", self.handle, level, byref(out))
        n, influences = out.vertex_count, out.influence_count
        joints = numpy.zeros((n, influences), numpy.uint16)
        weights = numpy.zeros((n, influences), numpy.float32)
        arrays = abi.Influences(per_vertex=influences, joints=joints.ctypes.data_as(POINTER(c_uint16)),
                                weights=weights.ctypes.data_as(POINTER(c_float)), capacity=joints.size)
        abi.call("clq_template_get_influences", self.handle, level, byref(arrays))
        return {"positions": borrowed(out.positions, (n, 3), self), "normals": borrowed(out.normals, (n, 3), self),
                "uvs": borrowed(out.uvs, (n, 2), self), "joints": joints, "weights": weights,
                "bins": [self._bin(level, i) for i in range(out.bin_count)]}

    def _bin(self, level, index):
        out = abi.Triangles()
        abi.call("clq_template_get_triangles", self.handle, level, index, byref(out))
        return {"texture": out.texture, "zone": None if out.zone == abi.NONE else out.zone,
                "indices": borrowed(out.indices, (out.index_count // 3, 3), self)}

    def texture(self, texture=0, texture_set=0):
        """The texels of a texture: rgb (height, width, 3), and zones (height, width), -1 in holes."""
        texels = abi.Texels()
        abi.call("clq_template_get_texture", self.handle, texture_set, texture, byref(texels))
        rgb = numpy.zeros((texels.height_px, texels.width_px, 3), numpy.uint8)
        zones = numpy.zeros((texels.height_px, texels.width_px), numpy.uint32)
        texels.rgb, texels.zones = rgb.ctypes.data_as(POINTER(c_uint8)), zones.ctypes.data_as(POINTER(c_uint32))
        texels.capacity = zones.size
        abi.call("clq_template_get_texture", self.handle, texture_set, texture, byref(texels))
        return rgb, zones.astype(numpy.int64) - (zones == abi.NONE) * (1 << 32)
