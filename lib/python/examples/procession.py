"""A procession of four abreast, led by a decurion, along a winding road. Writes procession.png.

    python3 procession.py [TIME_S]
"""

import math
import struct
import sys
import zlib

import claque


def road(at_m):
    """The position and heading of the road after so many metres."""
    bend = 0.35 * math.sin(at_m / 11)
    return 6 * math.sin(at_m / 11), at_m, math.atan(bend * 6 / 11 / 0.35)


def enter(crowd, templates, rows=24):
    people = [(crowd.add(templates["decurion"], clip="walk", seed=1), 0.0, 2.0)]
    for row in range(rows):
        for file in range(4):
            seed = 10 + 4 * row + file
            name = ("citizen", "plebeian", "patrician")[seed * 7919 % 3]
            actor = crowd.add(templates[name], clip="walk", phase_s=seed * 0.137 % 1.1, seed=seed,
                              texture_set=claque.abi.RANDOM)
            people.append((actor, (file - 1.5) * 1.1, -1.4 * row))
    for actor, _, _ in people:
        actor.set_speed(SPEED_M_S)
    return people


SPEED_M_S = 1.27


def move(people, time_s):
    for actor, beside, behind in people:
        x, z, heading = road(behind + SPEED_M_S * time_s)
        actor.set_transform((x + beside * math.cos(heading), 0, z - beside * math.sin(heading)), heading)


def paint_ground(target, eye, look_at, fov_y_rad):
    """Paints the ground in one colour up to the horizon."""
    level = math.hypot(look_at[0] - eye[0], look_at[2] - eye[2])
    slope = (eye[1] - look_at[1]) / level
    rows = int(target.height * (0.5 + 0.5 * slope / math.tan(fov_y_rad / 2)))
    target.gl("glEnable", 0x0C11)  # GL_SCISSOR_TEST
    target.gl("glScissor", 0, 0, target.width, rows)
    target.clear((0.60, 0.54, 0.44))
    target.gl("glDisable", 0x0C11)


def write_png(path, picture):
    height, width, _ = picture.shape
    rows = b"".join(b"\0" + picture[y].tobytes() for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
                   chunk(b"IDAT", zlib.compress(rows, 6)) + chunk(b"IEND", b""))


def main():
    time_s = float(sys.argv[1]) if len(sys.argv) > 1 else 4.0
    with claque.Context() as context, claque.Offscreen(800, 450) as target:
        templates = {name: claque.Template.builtin(context, name, folder=None)
                     for name in ("citizen", "decurion", "patrician", "plebeian")}
        with claque.Crowd(context) as crowd, claque.Renderer(context, target) as renderer:
            people = enter(crowd, templates)
            renderer.prepare(*templates.values())
            view = crowd.view()
            x, z, _ = road(SPEED_M_S * time_s)
            eye, look_at, fov_y_rad = (x + 5.5, 3.2, z + 7), (x - 1, 1.0, z - 6), 0.75
            view.look_at(eye, look_at, fov_y_rad=fov_y_rad, aspect=800 / 450)
            move(people, time_s)
            crowd.update(time_s)
            target.clear((0.72, 0.78, 0.84))
            paint_ground(target, eye, look_at, fov_y_rad)
            target.light()
            stats = renderer.draw(view)
            write_png("procession.png", target.picture())
            print(f"procession.png: {stats.individuals} of {len(crowd)} in view, {stats.triangles} triangles")
        for template in templates.values():
            template.close()


if __name__ == "__main__":
    main()
