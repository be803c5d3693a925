"""The library's warnings are Python's."""

import json
import warnings

import pytest

import claque


@pytest.fixture
def file(tmp_path):
    """A triangle whose picture is not there."""
    corners = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"  # (0, 0, 0), (1, 0, 0), (0, 1, 0)
    path = tmp_path / "triangle.gltf"
    path.write_text(json.dumps({
        "asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}],
        "accessors": [{"componentType": 5126, "type": "VEC3", "count": 3, "bufferView": 0},
                      {"componentType": 5126, "type": "VEC2", "count": 3, "bufferView": 0}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64," + corners}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
        "textures": [{"source": 0}], "images": [{"uri": "lost.png"}]}))
    return path


def test_a_warning_of_a_file_is_one_of_python_where_the_file_is_loaded(context, file):
    with pytest.warns(UserWarning, match=r"triangle\.gltf: .*lost\.png") as caught:
        claque.Template.load(context, file).close()
    assert [one.filename for one in caught] == [__file__]
    assert [text for level, text in context.log if "lost.png" in text] == [str(caught[0].message)]


def test_what_blends_is_a_mask_or_opaque(context, file):
    made = json.loads(file.read_text())
    alpha = {"baseColorFactor": [1, 1, 1, 0.4]}
    made["materials"] = [{"name": "visor", "alphaMode": "BLEND", "pbrMetallicRoughness": alpha}]
    file.write_text(json.dumps(made))
    with pytest.warns(UserWarning, match="'visor' is transparent: left out"):
        claque.Template.load(context, file).close()
    with warnings.catch_warnings():
        warnings.filterwarnings("error", message=".*visor.*")
        for chosen in ("mask", "opaque"):
            claque.Template.load(context, file, blend=chosen).close()
    with pytest.raises(ValueError, match="blend is 'add': None, 'opaque' or 'mask'"):
        claque.Template.load(context, file, blend="add")


def test_colours_are_near_wild_or_the_files_own(context, file):
    for chosen in ("near", "wild", "own"):
        claque.Template.load(context, file, colours=chosen).close()
    with pytest.raises(ValueError, match="colours is 'red': 'near', 'wild' or 'own' is wanted"):
        claque.Template.load(context, file, colours="red")


def test_a_warning_can_be_an_error(context, file):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(UserWarning, match="lost.png"):
            claque.Template.load(context, file)
    with pytest.warns(UserWarning):  # and nothing of it is left
        claque.Template.load(context, file).close()


def test_what_has_no_warnings_gives_none(context):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        claque.Template.builtin(context, "citizen", folder=None).close()
    with pytest.raises(KeyError, match="no clip 'wlak'; near are walk"):
        claque.Template.builtin(context, "citizen", folder=None).clip("wlak")
