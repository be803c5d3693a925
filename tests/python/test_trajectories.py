"""Trajectories and areas from Python: what is read, what is refused, whose memory is whose."""

import gc

import numpy
import pytest

import claque

TABLE = b"who,t,x,y\na,0,0,0\nb,0,5,5\na,1,1,0\na,2,2,0\na,2,2,0\n"


def test_people_and_their_samples(context):
    with claque.Trajectories.from_bytes(
        context, TABLE, "people.csv", columns="id,time,x,y", metres_per_unit=0.5
    ) as read:
        assert [(name, len(samples)) for name, samples in read.people] == [("a", 3), ("b", 1)]
        assert read.samples["x"].tolist() == [0, 0.5, 1, 2.5]
        assert numpy.isnan(read.samples["heading_rad"]).all()
        assert read.info.most_at_once == 2
        assert len(read.warnings) == read.info.warning_count == 2


def test_what_is_missing_is_asked_for(context):
    with pytest.raises(claque.Error, match="metres_per_unit") as refused:
        claque.Trajectories.from_bytes(context, TABLE, columns="id,time,x,y")
    assert refused.value.status is claque.Status.ARGUMENT
    with pytest.raises(TypeError, match="no member rate"):
        claque.Trajectories.from_bytes(context, TABLE, rate=5)


def test_samples_outlive_the_name_of_their_owner(context):
    samples = claque.Trajectories.from_bytes(context, TABLE, columns="id,time,x,y", metres_per_unit=1).samples
    gc.collect()
    assert samples["time_s"].tolist() == [0, 1, 2, 0]
    assert not samples.flags.writeable


def test_a_file_and_a_matrix(context, tmp_path):
    (tmp_path / "a.vsp").write_text("1 - the number of splines\n1\n0 0 25 0\n")
    read = claque.Trajectories.load(context, tmp_path / "a.vsp", picture_to_metres=numpy.eye(3))
    assert read.samples[["time_s", "x", "y"]].tolist() == [(1, 288, 360)]


def test_an_area(context, tmp_path):
    (tmp_path / "a.wkt").write_text("POLYGON ((0 0, 4 0, 4 4, 0 4), (1 1, 1 2, 2 2, 2 1), (0 0, 0 0))")
    with claque.Area.load(context, tmp_path / "a.wkt") as area:
        a, b, c = (area.points[area.triangles[:, k]][:, :2] for k in range(3))
        twice = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
        assert twice.sum() / 2 == area.info.area_m2 == 15
        assert area.walls.shape == (8, 2)
        assert area.warnings == ["ring 3 of polygon 1 encloses nothing: left out"]
    with pytest.raises(claque.Error):
        claque.Area.from_bytes(context, b"LINESTRING (0 0, 1 1)", "a.wkt")
