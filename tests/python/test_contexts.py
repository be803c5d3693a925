"""Contexts without a window: each kind draws the same bytes, and one that cannot be made says so in one sentence."""

import ctypes
import os
import pathlib
import subprocess
import sys

import numpy
import pytest

import claque
from claque import egl, osmesa
from drawing import KINDS, drawing


def sample_by(kind, context, crowd, citizen, monkeypatch):
    monkeypatch.setenv("CLAQUE_CONTEXT", kind)
    with claque.Offscreen(161, 120) as target, claque.Renderer(context, target) as renderer:
        renderer.prepare(citizen)
        target.light()
        target.gl("glPixelStorei", 0x0D05, 8)  # GL_PACK_ALIGNMENT, which pads the rows of this width
        target.gl("glPixelTransferf", 0x0D14, 0.5)  # GL_RED_SCALE
        sample, = claque.labels(crowd, crowd.the_view, renderer, target, [1.5], step_s=0.04)
        return sample, target.pixels.copy()


@pytest.mark.skipif(not KINDS, reason="there is no OpenGL")
def test_each_kind_draws_the_same_bytes(context, citizen, monkeypatch):
    with claque.Crowd(context, exact_poses=True) as crowd:
        for i in range(20):
            crowd.add(citizen, (i % 5, 0, -(i // 5)), clip="applaud", phase_s=0.07 * i, seed=i)
        crowd.the_view = crowd.view()
        crowd.the_view.look_at((2, 3, 6), (2, 1, -3), aspect=161 / 120)
        (first, pixels), *others = (sample_by(kind, context, crowd, citizen, monkeypatch)
                                    for kind in (*KINDS, KINDS[0]))
    assert (first.actors > 0).mean() > 0.05 and first.picture[first.actors > 0].max() > 60
    for sample, their_pixels in others:
        numpy.testing.assert_array_equal(their_pixels, pixels)
        for name, array in vars(first).items():
            numpy.testing.assert_array_equal(getattr(sample, name), array)


@drawing
def test_two_targets_hold_a_picture_each():
    with claque.Offscreen(8, 8) as red, claque.Offscreen(4, 4) as blue:
        red.clear((1.0, 0.0, 0.0))
        blue.clear((0.0, 0.0, 1.0))
        assert red.picture()[0, 0].tolist() == [255, 0, 0] and red.pixels.shape == (8, 8, 4)
        assert blue.picture()[3, 3].tolist() == [0, 0, 255] and blue.pixels[0, 0].tolist() == [0, 0, 255, 255]


@drawing
def test_a_picture_without_pixels_or_with_too_many_is_refused():
    for width, height in ((0, 8), (8, 16385)):
        with pytest.raises(claque.Error, match=f"{width} x {height} pixels; each side must be 1 to 16384"):
            claque.Offscreen(width, height)


@drawing
@pytest.mark.parametrize("driver", ["bogus", "softpipe"])
def test_a_driver_that_does_not_start_is_named(gl, driver):
    script = "import claque\ntry: print(claque.Offscreen(8, 8).renderer)\nexcept claque.Error as error: print(error)"
    environment = dict(os.environ, GALLIUM_DRIVER=driver, PYTHONPATH=str(pathlib.Path(claque.__file__).parents[1]))
    said = subprocess.run([sys.executable, "-B", "-c", script], env=environment, check=True, capture_output=True,
                          text=True).stdout
    assert said.startswith(driver) or f"GALLIUM_DRIVER is '{driver}'" in said, said


@drawing
def test_a_driver_other_than_the_named_one_is_refused(monkeypatch):
    first = claque.Offscreen(8, 8)
    monkeypatch.setenv("GALLIUM_DRIVER", "softpipe" if first.renderer.startswith("llvmpipe") else "llvmpipe")
    with pytest.raises(claque.Error, match="^GALLIUM_DRIVER is '.*', and OpenGL drew with .* instead$"):
        claque.Offscreen(8, 8)


@drawing
def test_a_device_that_is_not_there_is_refused(gl, monkeypatch):
    monkeypatch.setenv("CLAQUE_EGL_DEVICE", "99")
    if gl == "egl":
        with pytest.raises(claque.Error, match=r"CLAQUE_EGL_DEVICE is '99', and this machine has \d+ devices?,"):
            claque.Offscreen(8, 8)
    else:
        claque.Offscreen(8, 8).close()


@pytest.mark.parametrize("name", ["bogus", "glx"])
def test_a_kind_that_python_does_not_have_is_named(name, monkeypatch):
    monkeypatch.setenv("CLAQUE_CONTEXT", name)
    with pytest.raises(claque.Error, match=f"^CLAQUE_CONTEXT is '{name}'; Python draws with osmesa or egl$"):
        claque.Offscreen(8, 8)


def test_a_machine_without_opengl_is_told_what_to_install(monkeypatch):
    def absent(name, **_):
        raise OSError(f"{name}: cannot open shared object file")

    monkeypatch.delenv("CLAQUE_CONTEXT", raising=False)
    monkeypatch.setattr(ctypes, "CDLL", absent)
    monkeypatch.setattr(osmesa, "_library", osmesa._library.__wrapped__)
    monkeypatch.setattr(egl, "_library", egl._library.__wrapped__)
    with pytest.raises(claque.Error) as refused:
        claque.Offscreen(8, 8)
    assert str(refused.value) == ("OSMesa: libOSMesa.so.8 is missing (Debian: libosmesa6); "
                                  "EGL: libEGL.so.1 is missing (Debian: libegl1 and libgl1-mesa-dri)")
