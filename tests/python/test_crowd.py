"""A crowd from Python: what it shows, what it refuses, whose memory is whose."""

import ctypes
import gc
import weakref

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


def test_seeds_and_other_numbers_that_their_bits_do_not_hold_are_refused(crowd, citizen):
    crowd.add(citizen, seed=2**64 - 1)
    for seed in (2**64, 2**70, -1):
        with pytest.raises(ValueError, match=f"seed cannot be {seed}: it has 64 bits"):
            crowd.add(citizen, seed=seed)
    with pytest.raises(ValueError, match="texture_set cannot be 4294967296: it has 32 bits"):
        crowd.add(citizen, texture_set=2**32)


def test_views_of_a_templates_memory_cannot_be_written_and_keep_it_alive(context):
    template = claque.Template.builtin(context, "plebeian", folder=None)
    positions = template.mesh()["positions"]
    again = template.mesh()["positions"]
    assert positions.ctypes.data == again.ctypes.data, "no copies"
    with pytest.raises(ValueError):
        positions[0] = 0
    with pytest.raises(ValueError):
        positions.flags.writeable = True
    before = positions.copy()
    del template, again
    gc.collect()
    numpy.testing.assert_array_equal(positions, before)


def test_places_have_three_numbers(crowd, citizen):
    with pytest.raises(ValueError, match=r"\(1, 2\) has 2 numbers; x, y and z are wanted"):
        crowd.add(citizen, (1, 2))
    with pytest.raises(ValueError):
        crowd.view().look_at((0, 1), (0, 0, 0))


def held_arrays(view, index):
    """The arrays of one individual, with the addresses at which the library has them."""
    held = view.arrays(index)
    positions, normals = view.vertices(index)
    return [(positions, held.positions), (normals, held.normals), (view.palette(index), held.palette),
            (view.colours(index), held.colours)]


def test_vertices_palettes_and_colours_are_views_of_the_librarys_memory(crowd):
    crowd.update(1.5)
    view = crowd.the_view
    for index in range(0, len(view), 9):
        copies = [*view.vertices(index, copy=True), view.palette(index, copy=True), view.colours(index, copy=True)]
        for (array, pointer), copy in zip(held_arrays(view, index), copies):
            assert array.__array_interface__["data"] == (ctypes.addressof(pointer.contents), True)
            numpy.testing.assert_array_equal(array, copy)
            assert not numpy.shares_memory(array, copy)
            copy[0] = 0  # a copy is the caller's
        assert numpy.shares_memory(view.vertices(index)[0], view.vertices(index)[0])
        assert not numpy.shares_memory(view.vertices(index)[0], view.vertices(index)[1])


def test_views_of_a_draw_list_cannot_be_made_writeable(crowd):
    crowd.update(1.5)
    for array, _ in held_arrays(crowd.the_view, 0):
        with pytest.raises(ValueError):
            array[0] = 0
        for one in (array, array[1:], numpy.asarray(array)):
            with pytest.raises(ValueError):
                one.flags.writeable = True


def test_a_view_of_a_draw_list_keeps_its_crowd_alive(context, citizen):
    crowd = claque.Crowd(context)
    crowd.add(citizen, clip="walk")
    view = crowd.view()
    view.look_at((0, 1, 5), (0, 1, 0))
    crowd.update(0.5)
    arrays = [array for array, _ in held_arrays(view, 0)]
    expected = [array.copy() for array in arrays]
    parts = [array[1:] for array in arrays]
    alive = weakref.ref(crowd)
    assert all(array.base is not None for array in arrays)
    del crowd, view, arrays
    gc.collect()
    assert alive() is not None
    for part, whole in zip(parts, expected):
        numpy.testing.assert_array_equal(part, whole[1:])
    del parts, part
    gc.collect()
    assert alive() is None


def test_copies_stay_when_an_update_gives_the_views_other_numbers(crowd):
    crowd.update(1.5)
    before = crowd.the_view.vertices(0, copy=True)[0]
    at_once = before.copy()
    crowd.update(2.0)
    numpy.testing.assert_array_equal(before, at_once)
    assert numpy.abs(crowd.the_view.vertices(0)[0] - before).max() > 1e-3


def test_colours_of_the_template_are_read_only_copies(context, citizen):
    with claque.Crowd(context) as crowd:
        crowd.add(citizen, colours=False)
        view = crowd.view()
        view.look_at((0, 1, 5), (0, 1, 0))
        crowd.update(0)
        assert not view.arrays(0).colours
        colours = view.colours(0)
        numpy.testing.assert_array_equal(colours, view.colours(0, copy=True))
        with pytest.raises(ValueError):
            colours[0] = 0


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


def test_an_update_tells_who_entered_and_left_view(context, citizen):
    with claque.Crowd(context) as crowd:
        here = crowd.add(citizen, (0, 0, -8))
        gone = crowd.add(citizen, (200, 0, -8))
        crowd.view().look_at((0, 2, 0), (0, 1, -8))
        crowd.update(0)
        told = crowd.view_changes()
        assert told["index1"].tolist() == [here.id.index1, gone.id.index1] and told["in_view"].tolist() == [True, False]
        crowd.update(1)
        assert len(crowd.view_changes()) == 0
        gone.set_transform((1, 0, -8))
        crowd.update(1)
        assert crowd.view_changes()[["index1", "in_view"]].tolist() == [(gone.id.index1, True)]


def test_a_tile_culls_by_its_part_of_the_picture(context, citizen):
    with claque.Crowd(context) as crowd:
        for x in (-3, 3):
            crowd.add(citizen, (x, 0, -8))
        view = crowd.view()
        view.look_at((0, 2, 0), (0, 1, -8))
        crowd.update(0)
        assert len(view) == 2
        view.set_tile(0, 0, 0.5, 1)
        crowd.update(0)
        assert len(view) == 1
        with pytest.raises(claque.Error, match="shares of the picture"):
            view.set_tile(0.5, 0, 0.5, 1)


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
