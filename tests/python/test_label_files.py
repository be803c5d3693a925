"""Files of labels, read by OpenCV: they hold the arrays of the archive, which NumPy reads."""

import json
import subprocess

import numpy
import pytest

cv2 = pytest.importorskip("cv2", reason="OpenCV is not there (Debian: python3-opencv)")

from drawing_command import COMMAND, needs_command  # noqa: E402

pytestmark = needs_command


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    made = tmp_path_factory.mktemp("labels")
    subprocess.run([COMMAND, "labels", "--scene", "plaza", "--count", "30", "--size", "160x120", "--frames", "12",
                    "--write", "flo,kitti-flow,depth,normals,panoptic,coco,npz", "--out", str(made)], check=True)
    return made


@pytest.fixture(scope="module")
def arrays(folder):
    with numpy.load(folder / "arrays" / "000012.npz") as archive:
        return {name: archive[name] for name in archive.files}


def read(folder, name, flags=cv2.IMREAD_UNCHANGED):
    values = cv2.imread(str(folder / name), flags)
    assert values is not None, name
    return values


@pytest.mark.parametrize("way", ["forward", "backward"])
def test_flow_is_that_of_the_archive(folder, arrays, way):
    expected = arrays[f"flow_{way}"]
    known = ~numpy.isnan(expected).any(2)
    assert 0.02 < known.mean() < 0.9
    flo = cv2.readOpticalFlow(str(folder / f"flow_{way}" / "000012.flo"))
    assert flo.dtype == numpy.float32 and flo.shape == expected.shape
    numpy.testing.assert_array_equal(flo[known], expected[known])
    assert (flo[~known] > 1e9).all()
    kitti = read(folder, f"flow_{way}/000012.png")[:, :, ::-1]  # OpenCV has blue first
    assert kitti.dtype == numpy.uint16
    numpy.testing.assert_array_equal(kitti[:, :, 2] == 1, known)
    assert numpy.abs((kitti[known][:, :2].astype(float) - 32768) / 64 - expected[known]).max() <= 1 / 127


def test_depth_is_that_of_the_archive(folder, arrays):
    depth, expected = read(folder, "depth/000012.png"), arrays["depth_m"]
    assert depth.dtype == numpy.uint16 and depth.shape == expected.shape
    known = ~numpy.isnan(expected)
    assert (depth[~known] == 0).all()
    assert numpy.abs(depth[known] / 256 - expected[known]).max() <= 1 / 511
    numpy.testing.assert_array_equal(numpy.load(folder / "depth" / "000012.npy"), expected)


def test_pictures_are_those_of_the_archive(folder, arrays):
    numpy.testing.assert_array_equal(read(folder, "images/000012.png")[:, :, ::-1], arrays["rgb"])
    blue, green, red = (read(folder, "panoptic/000012.png")[:, :, k].astype(numpy.uint32) for k in range(3))
    numpy.testing.assert_array_equal(red + 256 * green + 65536 * blue, arrays["actor"])
    normals = read(folder, "normals/000012.png")[:, :, ::-1]
    known = arrays["actor"] != 0
    assert numpy.abs(normals[known] - 127.5 * (arrays["normal"][known] + 1)).max() <= 0.51


def test_boxes_are_those_of_the_pixels(folder, arrays):
    annotations = json.loads((folder / "coco.json").read_text())["annotations"]
    assert len(annotations) > 5
    for one in annotations:
        inside = (arrays["actor"] == one["track_id"]).astype(numpy.uint8)
        assert list(cv2.boundingRect(inside)) == one["bbox"]
        assert cv2.countNonZero(inside) == one["area"]
