"""Records: what a crowd has shown is shown again by another one."""

import os

import pytest

import claque


def run(crowd, citizen, path, **options):
    """Twenty frames of people who come; returns what each showed."""
    crowd.record(path, **options)
    view = crowd.view()
    view.look_at((0, 2, 9), (0, 1, 0))
    shown = []
    for frame in range(20):
        if frame % 5 == 0:
            actor = crowd.add(citizen, (frame / 5 - 2, 0, 0), clip="walk", seed=frame)
        actor.set_transform((frame / 5 - 2, 0, 0.1 * frame))
        crowd.update(0.1 * frame, view)
        shown.append(view.hash)
    return shown


def test_a_record_shows_what_was_shown(context, citizen, tmp_path):
    path = tmp_path / "run.clt"
    with claque.Crowd(context) as crowd:
        shown = run(crowd, citizen, path, key_bytes=500)
        info = crowd.end_record()
        assert info.steps == 20 and info.calls == 28 and info.bytes == path.stat().st_size and info.key_states > 1
    with claque.Record.load(context, path) as record:
        assert record.template_names == ["citizen"] and len(record) == 20 and record.info.whole
        record.set_templates([citizen])
        assert record.times_s == pytest.approx([0.1 * frame for frame in range(20)])
        with record.crowd() as again:
            view = again.view()
            view.look_at((0, 2, 9), (0, 1, 0))
            for frame in list(range(20)) + [19, 3, 12, 0]:
                record.play_step(again, frame)
                again.update(record.times_s[frame], view)
                assert view.hash == shown[frame]
            record.play(again, 0.72)
            assert len(again) == 2


def test_a_record_says_where_its_people_were(context, citizen, tmp_path):
    path = tmp_path / "run.clt"
    with claque.Crowd(context) as crowd:
        crowd.record(path)
        walker, gone = crowd.add(citizen, (-1, 0, 0)), crowd.add(citizen, (3, 0, 5))
        for step in range(41):
            walker.set_transform((-1 + 0.2 * step, 0, 0))
            if step == 10:
                gone.remove()
            if step == 30:
                assert crowd.add(citizen, (-7, 0, -2.5)).id.index1 == 2, "the number is used again"
            crowd.update(0.1 * step)
    with claque.Record.load(context, path, [citizen]) as record, record.trajectories(10) as read:
        shown = {name: samples for name, samples in read.people}
        assert sorted(shown) == ["1", "2", "3"]
        assert shown["1"]["time_s"] == pytest.approx([0.1 * step for step in range(41)])
        assert shown["1"]["x"] == pytest.approx([-1 + 0.2 * step for step in range(41)], abs=1e-4)
        assert len(shown["2"]) == 10 and set(shown["2"]["y"]) == {-5}
        assert shown["3"]["time_s"][0] == pytest.approx(3) and set(shown["3"]["y"]) == {2.5}


def test_a_crowd_that_is_closed_ends_its_record(context, citizen, tmp_path):
    path = tmp_path / "run.clt"
    with claque.Crowd(context) as crowd:
        run(crowd, citizen, path)
        assert crowd.recording.steps == 20
    with claque.Record.load(context, path, [citizen]) as record:
        assert record.info.whole and len(record) == 20
    cut = path.read_bytes()[:-30]  # its index is not whole
    with claque.Record(context, cut, [citizen]) as record:
        assert not record.info.whole and len(record) == 20


def test_what_is_no_record_is_refused(context, citizen, tmp_path):
    with pytest.raises(claque.Error, match="no record"):
        claque.Record(context, b"claque")
    with claque.Crowd(context) as crowd:
        with pytest.raises(claque.Error, match="is not recorded"):
            crowd.end_record()
        with pytest.raises(OSError):
            crowd.record(tmp_path / "nowhere" / "run.clt")


def test_a_name_that_leads_to_no_file_or_to_a_long_one_is_refused(context, tmp_path):
    """A pipe without a writer would be waited for, and a device has no end."""
    pipe, large = tmp_path / "pipe", tmp_path / "large"
    os.mkfifo(pipe)
    with open(large, "wb") as file:
        file.truncate((4 << 30) + 1)
    for load in (lambda path: claque.Record.load(context, path),
                 lambda path: claque.Template.load_prepared(context, path)):
        for path, sentence in ((pipe, "is not a regular file"), ("/dev/zero", "is not a regular file"),
                               (large, "has more than 4294967296 bytes")):
            with pytest.raises(claque.Error, match=sentence):
                load(path)
        with pytest.raises(OSError):
            load(tmp_path)
