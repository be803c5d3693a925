"""Tracks from arrays: people person walk, in the order and at the places that the arrays say."""

import math

import numpy
import pytest

import claque


@pytest.fixture
def walk(context):
    with claque.Template.builtin(context, "citizen") as citizen:
        yield claque.Locomotion(citizen, run="jog", idles=["stand"])


def rows(rate=10):
    """Anna walks east, and from the second second on Ben walks north."""
    times = numpy.arange(0, 10, 1 / rate)
    ids = numpy.array(["anna"] * len(times) + ["ben"] * len(times))
    xy = numpy.concatenate([numpy.stack([1.1 * times, 0 * times], 1), numpy.stack([3 + 0 * times, 1.3 * times], 1)])
    return ids, numpy.concatenate([times, times + 2]), xy


def test_people_walk_where_the_rows_say(walk):
    tracks = claque.Tracks.from_numpy(walk, *rows())
    assert tracks.ids == ["anna", "ben"] and len(tracks) == 2
    anna, ben = tracks.tracks
    state = anna.at(5)
    assert state.present and not state.stands
    assert list(state.position) == pytest.approx([5.5, 0, 0], abs=0.01)
    assert state.heading_rad == pytest.approx(numpy.pi / 2, abs=0.01)
    state = ben.at(7)
    assert list(state.position) == pytest.approx([3, 0, -6.5], abs=0.01)
    assert state.heading_rad % (2 * numpy.pi) == pytest.approx(numpy.pi, abs=0.01)
    assert not ben.at(1).present and ben.at(3).present


def test_the_order_of_rows_does_not_matter(walk):
    ids, times, xy = rows()
    shuffled = numpy.random.default_rng(1).permutation(len(ids))
    first = claque.Tracks.from_numpy(walk, ids, times, xy)
    second = claque.Tracks.from_numpy(walk, ids[shuffled], times[shuffled], xy[shuffled], seed=0)
    by_id = dict(zip(second.ids, second.tracks))
    assert by_id["anna"].info.hash == first.tracks[0].info.hash


def test_actors_follow_them_and_are_drawn(context, walk):
    with claque.Crowd(context) as crowd:
        view = crowd.view()
        view.look_at((3, 2, 12), (3, 1, 0))
        actors = claque.Tracks.from_numpy(walk, *rows()).enter(crowd)
        seen = []
        for time_s in (1, 5, 11, 13):
            crowd.update(time_s, view)
            seen.append(len(view))
        assert seen == [1, 2, 1, 0]
        actors[1].leave_track(5)
        crowd.update(13, view)
        assert len(view) == 1


def test_trajectories_become_tracks(context, walk):
    table = b"time,pedID,posX,posY\n" + b"".join(b"%g,%d,%g,2\n" % (0.5 * i, person, 0.6 * i + person)
                                                 for i in range(20) for person in (7, 8))
    with claque.Trajectories.from_bytes(context, table, "people.csv") as read:
        tracks = claque.Tracks.from_trajectories(walk, read)
    assert tracks.ids == ["7", "8"]
    assert list(tracks.tracks[1].at(4.5).position) == pytest.approx([8 + 5.4, 0, -2], abs=0.05)


def passers():
    """Anna and Ben walk towards each other and pass at half a metre; Carl walks far away."""
    times = numpy.arange(0, 8, 0.1)
    ways = [numpy.stack([1.2 * times, 0 * times], 1), numpy.stack([9.6 - 1.2 * times, 0.5 + 0 * times], 1),
            numpy.stack([1.2 * times, 40 + 0 * times], 1)]
    return numpy.repeat(["anna", "ben", "carl"], len(times)), numpy.tile(times, 3), numpy.concatenate(ways)


def test_passings_are_where_people_meet(context):
    ids, times, xy = passers()
    points = numpy.stack([xy[:, 0], 0 * times, -xy[:, 1]], 1)
    alike = [ids == person for person in ("anna", "ben", "carl")]
    found = claque.find_passings(context, [(times[rows], points[rows]) for rows in alike])
    assert [len(own) for own in found] == [1, 1, 0]
    assert found[0]["time_s"][0] == pytest.approx(4, abs=0.11)
    assert found[0]["position"][0] == pytest.approx([4.8, 0, -0.5], abs=0.13), "Ben's place"
    with pytest.raises(claque.Error, match="not finite"):
        claque.find_passings(context, [([0, 1], [[0, 0, 0], [numpy.nan, 0, 0]])])


def test_shoulders_turn_where_people_pass(context, walk):
    with_passings, without = (claque.Tracks.from_numpy(walk, *passers(), passings=wanted) for wanted in (True, False))
    differ = [a.info.hash != b.info.hash for a, b in zip(with_passings.tracks, without.tracks)]
    assert differ == [True, True, False]


def test_arrays_of_other_shapes_are_refused(walk):
    ids, times, xy = rows()
    with pytest.raises(ValueError, match="are wanted"):
        claque.Tracks.from_numpy(walk, ids, times[:5], xy)
    with pytest.raises(claque.Error, match="not finite"):
        claque.Track(walk, [0, 1], [[0, 0, 0], [numpy.nan, 0, 0]])
    with pytest.raises(claque.Error, match="ascending"):
        claque.Track(walk, [1, 1], [[0, 0, 0], [1, 0, 0]])


def test_feet_stand_on_the_ground_that_a_function_gives(walk):
    times = numpy.arange(0, 6, 0.1)
    points = numpy.stack([0 * times, 0.5 * times, times], 1)
    asked = []

    def tread(x, y, z):
        asked.append((x, y, z))
        return 0.2 * math.floor(z / 0.4)

    ramp, stairs = claque.Track(walk, times, points), claque.Track(walk, times, points, ground=tread)
    assert stairs.info.hash != ramp.info.hash and stairs.info.plant_count > 4
    assert all(abs(y - 0.5 * z) < 0.6 for _, y, z in asked), "at the height of the person"
    nowhere = claque.Track(walk, times, points, ground=lambda x, y, z: math.nan)
    assert nowhere.info.hash == ramp.info.hash

    def broken(x, y, z):
        raise KeyError("no stone")

    with pytest.raises(KeyError, match="no stone"):
        claque.Track(walk, times, points, ground=broken)


def test_a_file_is_turned_and_sized_by_one_of_two_numbers(context, tmp_path):
    with pytest.raises(claque.Error, match="height_m is 1.8 and scale is 2: each gives the size"):
        path = tmp_path / "none.glb"
        path.write_bytes(b"{}")
        claque.Template.load(context, path, turn_deg=180, height_m=1.8, scale=2)


def test_legs_and_head_can_be_named(context):
    with claque.Template.builtin(context, "citizen") as citizen:
        legs = [[part + side for part in ("thigh", "shin", "foot")] for side in ("_l", "_r")]
        named = claque.Locomotion(citizen, legs=legs, head="head").info
        assert [leg.foot for leg in named.legs] == [citizen.node("foot_l"), citizen.node("foot_r")]
        assert named.legs[0].toes == claque.abi.NONE and named.torso == claque.abi.NONE
        assert named.head == citizen.node("head")
        with pytest.raises(KeyError, match="has no node 'haed'; near are head"):
            claque.Locomotion(citizen, head="haed")
        with pytest.raises(KeyError, match="has no node 'tail'"):
            claque.Locomotion(citizen, head="tail")
