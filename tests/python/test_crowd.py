"""A crowd from Python: what it shows, what it refuses, whose memory is whose."""

import gc

import numpy
import pytest

import claque


def test_a_template_describes_its_content(citizen):
    assert citizen.name == "citizen"
    assert citizen.zones == ["skin", "hair", "eyes", "lips", "tunic", "belt", "border", "sandals"]
    assert citizen.clips["walk"] == pytest.approx(1.1)
    mesh = citizen.mesh()
    assert mesh["positions"].shape == (citizen.info.vertex_count, 3)
    assert sum(len(part["indices"]) for part in mesh["bins"]) == citizen.info.triangle_count
    numpy.testing.assert_allclose(mesh["weights"].sum(axis=1), 1, atol=1e-5)
    rgb, zones = citizen.texture(texture_set=1)
    assert rgb.shape == zones.shape + (3,)
    assert zones.max() < len(citizen.zones)


def test_views_of_a_templates_memory_cannot_be_written_and_keep_it_alive(context):
    template = claque.Template.builtin(context, "plebeian", folder=None)
    positions = template.mesh()["positions"]
    again = template.mesh()["positions"]
    assert positions.ctypes.data == again.ctypes.data, "no copies"
    with pytest.raises(ValueError):
        positions[0] = 0
    before = positions.copy()
    del template, again
    gc.collect()
    numpy.testing.assert_array_equal(positions, before)


def test_the_palette_skins_the_mesh_to_the_shown_vertices(crowd, citizen):
    crowd.update(1.5)
    view = crowd.the_view
    assert len(view) > 50
    for index in range(0, len(view), 7):
        mesh, palette = citizen.mesh(view.drawn_actor(index).level), view.palette(index).astype(float)
        points = numpy.c_[mesh["positions"], numpy.ones(len(mesh["positions"]))]
        skinned = numpy.einsum("vi,virc,vc->vr", mesh["weights"], palette[mesh["joints"]], points)
        positions, normals = view.vertices(index)
        assert numpy.abs(skinned - positions).max() < 1e-5
        turned = numpy.einsum("vi,virc,vc->vr", mesh["weights"], palette[mesh["joints"]][..., :3], mesh["normals"])
        assert numpy.abs(turned - normals).max() < 1e-5


def test_equal_calls_give_equal_lists_and_another_time_gives_another(crowd, context, citizen):
    crowd.update(1.5)
    first = crowd.the_view.hash
    crowd.update(2.0)
    assert crowd.the_view.hash != first
    crowd.update(1.5)
    assert crowd.the_view.hash == first


def test_a_destroyed_actor_is_a_stale_id_with_a_message(crowd):
    actor = crowd.add(crowd._held[-1])
    actor.remove()
    with pytest.raises(claque.Error) as refused:
        actor.randomise_colours()
    assert refused.value.status is claque.Status.STALE_ID
    assert "no actor has index" in str(refused.value)
    assert len(crowd) == 100


def test_an_unknown_clip_is_named_with_the_existing_ones(crowd, citizen):
    with pytest.raises(KeyError, match="citizen has no clip 'fly'; it has stand, walk"):
        crowd.add(citizen, clip="fly")


def test_colours_of_another_shape_or_range_are_refused(crowd, citizen):
    actor = crowd.add(citizen)
    with pytest.raises(ValueError, match=r"\(zones, 3\) is wanted"):
        actor.set_colours([1, 0, 0])
    with pytest.raises(claque.Error, match="8"):
        actor.set_colours([[1, 0, 0]])
    with pytest.raises(claque.Error, match="must lie in"):
        actor.set_colours(numpy.full((8, 3), 2.0))


def test_closed_objects_report_it_and_a_context_outlives_its_objects():
    context = claque.Context()
    template = claque.Template.builtin(context, "citizen", folder=None)
    del context
    gc.collect()
    assert template.name == "citizen"
    template.close()
    template.close()
    with pytest.raises(claque.Error, match="this Template has been closed"):
        template.info
