"""Templates that Python makes: zones that a map gives, and the folder that keeps them."""

import numpy
import pytest

import claque

LEFT, RIGHT = 0, 1


def halves(width=64, left=LEFT):
    texels = numpy.full((width, width), left, numpy.uint16)
    texels[:, width // 2 :] = RIGHT
    return texels


def test_a_zone_map_names_the_zones_and_is_kept_with_them(context, tmp_path):
    kept = tmp_path / "kept"

    def made(texels, zones=("left", "right")):
        return claque.Template.builtin(context, "citizen", folder=kept, zone_maps=[claque.ZoneMap(texels, zones)])

    with made(halves()) as first, made(halves(), ["left", ("right", True)]) as reduced:
        assert {"left", "right"} <= set(first.zones)
        plain, shown = first.texture()
        grey, _ = reduced.texture()
        for name, changes in (("left", False), ("right", True)):
            here = shown == first.zones.index(name)
            assert here.mean() == pytest.approx(0.5, abs=0.01), name
            assert (plain[here] != grey[here]).any() == changes, name
    assert len(list(kept.iterdir())) == 2, "a zone that loses its colours is another one"
    made(halves()).close()
    assert len(list(kept.iterdir())) == 2, "the same map comes from the folder"
    one_texel = halves()
    one_texel[5, 5] = RIGHT
    made(one_texel).close()
    assert len(list(kept.iterdir())) == 3, "a map that differs in a texel is another one"


def test_a_zone_map_that_is_none_is_refused(context):
    with pytest.raises(ValueError, match="height, width"):
        claque.ZoneMap([1, 2, 3], ["a"])
    with pytest.raises(ValueError, match="0xFFFF"):
        claque.ZoneMap(numpy.full((2, 2), -1), ["a"])
    with pytest.raises(claque.Error, match="names zone 7, which does not exist"):
        claque.Template.builtin(context, "citizen", zone_maps=[claque.ZoneMap(numpy.full((2, 2), 7), ["a"])])
