"""Labels from Python: arrays that agree with the picture and with each other."""

import numpy

import claque
from claque import abi
from drawing import drawing


def exact_crowd(context, citizen):
    crowd = claque.Crowd(context, exact_poses=True)
    for i in range(6):
        crowd.add(citizen, position=(i % 3 - 1, 0, -1.2 * (i // 3)), clip="walk", phase_s=0.3 * i, seed=i)
    return crowd


def look(view, time_s):
    view.look_at((0.2 * time_s, 1.5, 5), (0, 1, 0), aspect=4 / 3)


@drawing
def test_labels_agree_with_the_picture_and_with_the_clip(context, citizen):
    with exact_crowd(context, citizen) as crowd, claque.Offscreen(160, 120) as target, \
            claque.Renderer(context, target) as renderer:
        renderer.prepare(citizen)
        view = crowd.view()
        samples = list(claque.labels(crowd, view, renderer, target, [0.5, 0.54], step_s=0.04, look=look))
    assert [sample.time_s for sample in samples] == [0.5, 0.54]
    for sample in samples:
        people = sample.actors > 0
        assert set(numpy.unique(sample.actors)) <= set(range(7))
        assert 0.02 < people.mean() < 0.9
        assert (sample.picture[~people] == 0).all(), "what is not labelled is the cleared background"
        assert numpy.isnan(sample.depth_m[~people]).all() and (sample.zones[~people] == abi.NONE).all()
        assert (numpy.abs(numpy.linalg.norm(sample.normals[people], axis=1) - 1) < 1e-5).all()
        assert (numpy.abs(sample.barycentric[people].sum(axis=1) - 1) < 1e-5).all()
        assert not numpy.isnan(sample.forward[people]).any()
    # A point goes to where the same actor is in the next picture.
    first, second = samples
    y, x = numpy.nonzero(first.actors)
    to = numpy.floor(numpy.stack([x + 0.5, y + 0.5], 1) + first.forward[y, x]).astype(int)
    inside = (to >= 0).all(1) & (to[:, 0] < 160) & (to[:, 1] < 120)
    same = second.actors[to[inside, 1], to[inside, 0]] == first.actors[y, x][inside]
    assert same.mean() > 0.93


@drawing
def test_scenery_hides_people_and_has_no_labels(context, citizen):
    def wall(target, _time_s):
        for matrix in (0x1701, 0x1700):
            target.gl("glMatrixMode", matrix)
            target.gl("glLoadIdentity")
        target.gl("glTranslatef", 0.0, 0.0, -0.999)  # nearer than everybody
        target.gl("glDisable", 0x0B50)
        target.gl("glColor3f", 0.2, 0.4, 0.1)
        target.gl("glRectf", -1.0, -1.0, 0.0, 1.0)  # the left half

    with exact_crowd(context, citizen) as crowd, claque.Offscreen(160, 120) as target, \
            claque.Renderer(context, target) as renderer:
        renderer.prepare(citizen)
        view = crowd.view()
        look(view, 0)
        free, = claque.labels(crowd, view, renderer, target, [0.5])
        hidden, = claque.labels(crowd, view, renderer, target, [0.5], scenery=wall)
    assert (hidden.actors[:, 80:] == free.actors[:, 80:]).all()
    assert (hidden.actors[:, :80] == 0).all() and (free.actors[:, :80] > 0).any()

