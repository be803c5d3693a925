"""What the witness saw of replays, and what of it is wrong."""
import collections

# The lists of passes/guard.h whose state a draw may leave changed, by guard mode.
LEFT_BY = {"full": (), "minimal": ("minimal",), "none": ("minimal", "none")}

Replay = collections.namedtuple("Replay", "frames left")  # [(outside, corner)], {name: guard mode that documents it}


def read(path):
    frames, left = [], {}
    for line in path.read_text().splitlines():
        words = line.split(maxsplit=2)
        if words[0] == "frame":
            frames.append(tuple(words[2].split()))
        else:
            left[words[2]] = words[1]
    return Replay(frames, left)


def differing(a, b, part):
    """How many frames from the second on differ: outside the corner (part 0) or in it (1)."""
    return sum(x[part] != y[part] for x, y in list(zip(a.frames, b.frames))[1:])


def failures(program, alone, again, guests):
    failed = []
    if len(alone.frames) < program.frames:
        failed.append(f"{len(alone.frames)} frames were recorded; it takes {program.frames}")
    for part, where in ((0, "outside"), (1, "in")):
        if differing(alone, again, part):
            failed.append(f"two replays alone differ {where} the corner in {differing(alone, again, part)} frames")
    for guard, guest in guests.items():
        if len(guest.frames) != len(alone.frames):
            failed.append(f"{guard}: {len(guest.frames)} frames instead of {len(alone.frames)}")
        unseen = min(len(alone.frames), len(guest.frames)) - 1 - differing(alone, guest, 1)
        if unseen > 0:
            failed.append(f"{guard}: the corner of {unseen} frames does not show the guest")
        for name, documented in guest.left.items():
            if documented not in LEFT_BY[guard]:
                failed.append(f"{guard}: a draw left {name} changed, which passes/guard.h does not list for this mode")
    changed = differing(alone, guests["full"], 0)
    if changed:
        failed.append(f"full: pixels outside the corner changed in {changed} frames")
    return failed
