"""Scenes: individuals by place and by category, as NumPy finds them in the positions."""

import numpy
import pytest

import claque
from claque import scene as scenes


@pytest.fixture
def square(context, citizen):
    """Ten rows of ten people, a metre apart; the first row is of category 3."""
    with claque.Crowd(context) as crowd:
        people = [crowd.add(citizen, (i % 10, 0, i // 10), colours=False) for i in range(100)]
        scene = claque.Scene(crowd)
        scene.set_categories(people[:10], 1 << 3)
        scene.set_keys(people, [-i for i in range(100)])
        yield crowd, people, scene


def indices(answer):
    return [int(i) for i in (answer["actor"]["index1"] if "actor" in answer.dtype.names else answer["index1"])]


def test_people_are_found_by_place(square):
    _, people, scene = square
    places = numpy.array([(i % 10, 0, i // 10) for i in range(100)], float)
    away = numpy.linalg.norm(places - (4.3, 0, 2.2), axis=1)
    order = numpy.lexsort((numpy.arange(100), away))
    assert indices(scene.nearest(0, (4.3, 0, 2.2), 7)) == [people[i].id.index1 for i in order[:7]]
    within = scene.within(0, (4.3, 0, 2.2), 3)
    assert indices(within) == [people[i].id.index1 for i in order if away[i] <= 3]
    assert within["distance"] == pytest.approx(numpy.sort(away[away <= 3]))
    assert len(scene.in_box(0, (0, -1, 0), (1, 1, 9))) == 20
    assert len(scene.within(0, (0, 0, 0), 99)) == 100, "more than the first room for answers"


def test_people_are_found_by_category_and_in_order(square, citizen):
    crowd, people, scene = square
    assert indices(scene.find(all_of=8)) == [p.id.index1 for p in people[:10]]
    assert len(scene.find(none_of=8, template=citizen)) == 90
    assert indices(scene.find_keys(-12, -8, any_of=8)) == [people[9].id.index1, people[8].id.index1]
    assert scene.next(people[5]) == (people[4].id.index1, people[4].id.generation)
    assert scene.next(people[5], back=True)[0] == people[6].id.index1
    assert scene.next(people[0]) is None
    with pytest.raises(TypeError):
        scene.find(colour=3)
    people[7].remove()
    assert len(scene.find(all_of=8)) == 9
    assert scene.stats.marked == 1
    scene.update(0)
    assert scene.stats.actor_count == 99


def test_a_click_finds_the_person_and_the_zone(square, citizen):
    crowd, people, scene = square
    view = crowd.view()
    view.look_at((5, 1.2, 14), (5, 1.2, 0))
    crowd.update(0, view)
    hits = scene.on_ray(0, (5, 1.2, 14), (0, 0, -1))
    pick = scene.pick(view, (5, 1.2, 14), (0, 0, -1))
    assert hits["actor"]["index1"][0] == pick.actor.index1 == people[95].id.index1
    assert 3 < pick.distance < 6 and citizen.zones[pick.zone]
    assert scene.pick(view, (5, 1.2, 14), (0, 0, 1)) is None
    known = scene.known(people[95], 0)
    assert known.present and list(known.position) == [5, 0, 9] and known.level == 0


def test_rays_and_frusta_follow_a_camera(square):
    _, _, scene = square
    camera = claque.abi.Camera()
    looks = claque.abi.LookAtDef(
        eye=(5, 1, 14), target=(5, 1, 0), up=(0, 1, 0), fov_y_rad=0.5, aspect=1, z_near=1, z_far=30
    )
    claque.abi.call("clq_camera_look_at", claque.abi.ctypes.byref(looks), claque.abi.ctypes.byref(camera))
    origin, direction = scenes.ray_of(camera, 0, 0)
    assert origin == pytest.approx((5, 1, 13)) and direction == pytest.approx((0, 0, -1))
    seen = scene.in_frustum(0, camera)
    assert 0 < len(seen) < 100
    assert numpy.all(numpy.abs(seen["position"][:, 0] - 5) < 0.26 * (14 - seen["position"][:, 2]) + 2)
