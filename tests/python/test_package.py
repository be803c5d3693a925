"""The module can be installed from the source tree, and is of the library's version."""

import pathlib
import re

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def test_the_package_has_the_librarys_version_and_every_module():
    tomllib = pytest.importorskip("tomllib")
    project = tomllib.loads((ROOT / "lib/python/pyproject.toml").read_text())
    version = re.search(r"project\(claque VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())
    assert project["project"]["version"] == version.group(1)
    for package in project["tool"]["setuptools"]["packages"]:
        assert (ROOT / "lib/python" / package / "__init__.py").exists()


def test_no_file_of_the_package_is_too_long():
    for path in (ROOT / "lib/python").rglob("*.py"):
        assert len(path.read_text().splitlines()) <= 300, path


def test_the_parity_example_of_the_docs_is_the_one_that_is_run():
    page = (ROOT / "docs/python.md").read_text()
    example = (ROOT / "lib/python/examples/parity.py").read_text()
    shown = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    assert shown, "docs/python.md shows no Python"
    assert shown[-1].strip() == example.split('"""', 2)[2].strip()
