"""A screen that no monitor shows (Xvfb), and what is on it: pictures as rows of RGB, and the people in them."""
import os
import pathlib
import signal
import struct
import subprocess
import tempfile
import zlib


class Picture:
    def __init__(self, width, height, rgb):
        self.width, self.height, self.rgb = width, height, rgb

    def at(self, x, y):
        i = 3 * (y * self.width + x)
        return self.rgb[i], self.rgb[i + 1], self.rgb[i + 2]

    def part(self, x0, y0, x1, y1):
        rows = [self.rgb[3 * (y * self.width + x0):3 * (y * self.width + x1)] for y in range(y0, y1)]
        return Picture(x1 - x0, y1 - y0, b"".join(rows))

    def save(self, path):
        def chunk(kind, data):
            return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

        rows = b"".join(b"\0" + self.rgb[3 * y * self.width:3 * (y + 1) * self.width] for y in range(self.height))
        head = struct.pack(">IIBBBBB", self.width, self.height, 8, 2, 0, 0, 0)
        chunks = chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")
        pathlib.Path(path).write_bytes(b"\x89PNG\r\n\x1a\n" + chunks)


class Screen:
    """Xvfb for the duration of a `with`; `environment` is for the programs that use it."""

    def __init__(self, width=1024, height=800):
        self.size = f"{width}x{height}x24"

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory()
        end, other = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(other), "-screen", "0", self.size, "-fbdir", self.folder.name, "-nolisten",
             "tcp", "-noreset"], pass_fds=[other], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(other)
        with os.fdopen(end) as told:
            number = told.readline().strip()
        if not number:
            raise RuntimeError("Xvfb does not start")
        self.environment = dict(os.environ, DISPLAY=":" + number)
        return self

    def __exit__(self, *_):
        self.server.send_signal(signal.SIGTERM)
        self.server.wait()
        self.folder.cleanup()

    def picture(self):
        """What the screen shows now, from the file in X's window dump format that Xvfb draws into."""
        data = (pathlib.Path(self.folder.name) / "Xvfb_screen0").read_bytes()
        head = struct.unpack(">25I", data[:100])
        header_bytes, width, height, line_bytes, colours = head[0], head[4], head[5], head[12], head[19]
        start = header_bytes + 12 * colours
        rgb = bytearray(3 * width * height)
        for y in range(height):
            row = data[start + y * line_bytes:start + y * line_bytes + 4 * width]
            for channel in range(3):  # stored as blue, green, red, unused
                rgb[3 * y * width + channel:3 * (y + 1) * width:3] = row[2 - channel::4]
        return Picture(width, height, bytes(rgb))


def spots(picture, is_of_one, least_px):
    """Sets of at least so many pixels for which is_of_one(r, g, b), each less than 4 pixels from another one of its
    set: lists of (x, y)."""
    around = [(dx, dy) for dx in range(-3, 4) for dy in range(-3, 4)]
    left = {(x, y) for y in range(picture.height) for x in range(picture.width) if is_of_one(*picture.at(x, y))}
    found = []
    while left:
        spot, edge = [], [left.pop()]
        while edge:
            x, y = edge.pop()
            spot.append((x, y))
            for dx, dy in around:
                near = (x + dx, y + dy)
                if near in left:
                    left.remove(near)
                    edge.append(near)
        if len(spot) >= least_px:
            found.append(spot)
    return found


def mean(picture, spot):
    sums = [sum(picture.at(x, y)[k] for x, y in spot) for k in range(3)]
    return tuple(s // len(spot) for s in sums)
