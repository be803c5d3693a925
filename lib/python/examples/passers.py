"""Two files of people who meet in a corridor and turn their shoulders as they pass. Writes passers.png.

    python3 passers.py [TIME_S]
"""

import sys

import numpy

import claque
from procession import paint_ground, write_png


def corridor(people=24, length_m=30, seed=4):
    """Ids, times and places, as a simulator would give them: half of the people go east, half go west."""
    random = numpy.random.default_rng(seed)
    ids, times, places = [], [], []
    for person in range(people):
        way = 1 if person % 2 else -1
        speed, start_s = random.uniform(1.05, 1.45), 1.1 * (person // 2)
        own = start_s + numpy.arange(0, length_m / speed, 0.1)
        east = way * (speed * (own - start_s) - length_m / 2)
        lane = way * -0.32 + random.uniform(-0.12, 0.12)
        ids += [person] * len(own)
        times.append(own)
        places.append(numpy.stack([east, numpy.full(len(own), lane)], 1))
    return ids, numpy.concatenate(times), numpy.concatenate(places)


def main():
    time_s = float(sys.argv[1]) if len(sys.argv) > 1 else 16.0
    with claque.Context() as context, claque.Offscreen(800, 450) as target:
        citizen = claque.Template.builtin(context, "citizen", folder=None)
        walk = claque.Locomotion(citizen, run="jog", idles=["stand"], slow_walk="walk_slow", turn="turn")
        tracks = claque.Tracks.from_numpy(walk, *corridor())
        with claque.Crowd(context) as crowd, claque.Renderer(context, target) as renderer:
            for actor in tracks.enter(crowd):
                actor.randomise_colours()
            renderer.prepare(citizen)
            view = crowd.view()
            eye, look_at, fov_y_rad = (3.5, 2.6, 4.5), (-1, 0.9, 0), 0.75
            view.look_at(eye, look_at, fov_y_rad=fov_y_rad, aspect=800 / 450)
            crowd.update(time_s, view)
            target.clear((0.72, 0.78, 0.84))
            paint_ground(target, eye, look_at, fov_y_rad)
            target.light()
            stats = renderer.draw(view)
            write_png("passers.png", target.picture())
            print(f"passers.png: {stats.individuals} of {len(crowd)} in view, {stats.triangles} triangles")
        walk.close()
        citizen.close()


if __name__ == "__main__":
    main()
