"""Compares skinning in NumPy, as a shader would do it, with claque's."""

import numpy

import claque


def skin(mesh, palette):
    """Skins as a vertex shader would: a weighted sum of palette matrices, times the vertex (S2 2.2)."""
    matrices = numpy.einsum("vi,virc->vrc", mesh["weights"], palette[mesh["joints"]])
    points = numpy.concatenate([mesh["positions"], numpy.ones((len(mesh["positions"]), 1), numpy.float32)], axis=1)
    return numpy.einsum("vrc,vc->vr", matrices, points)


with claque.Context() as context:
    citizen = claque.Template.builtin(context, "citizen", folder=None)
    with claque.Crowd(context) as crowd:
        for i in range(100):
            crowd.add(citizen, (i % 10, 0, -(i // 10)), clip="applaud", phase_s=0.07 * i, seed=i)
        view = crowd.view()
        view.look_at((4.5, 4, 12), (4.5, 1, -4))
        crowd.update(1.5)
        worst = max(
            numpy.abs(skin(citizen.mesh(view.drawn_actor(i).level), view.palette(i)) - view.vertices(i)[0]).max()
            for i in range(len(view))
        )
        print(f"{len(view)} individuals, vertices within {worst * 1000:.4f} mm")
        assert worst < 1e-5
    citizen.close()
