"""The script of the page is made of the sources beside it."""

from __future__ import annotations

import hashlib
import shutil
import subprocess
from pathlib import Path

import pytest

import cardan.view as view

FOLDER = Path(view.__file__).parent
SOURCES = FOLDER / "three"


def test_the_bundle_is_of_these_sources() -> None:
    names = [path for path in SOURCES.iterdir() if path.suffix == ".js"]
    digest = hashlib.sha256()
    for path in sorted([*names, SOURCES / "package.json"]):
        digest.update(path.read_bytes())
    first = (FOLDER / "page.min.js").read_text("utf-8").partition("\n")[0]
    assert digest.hexdigest() in first, "npm install && npm run build in src/cardan/view/three"
    assert "MIT" in (FOLDER / "three.LICENSE").read_text("utf-8")


@pytest.mark.external
def test_the_build_gives_the_same_bytes(tmp_path: Path) -> None:
    npm = shutil.which("npm")
    if npm is None:
        pytest.skip("npm is not installed")
    copy = tmp_path / "three"
    shutil.copytree(SOURCES, copy, ignore=shutil.ignore_patterns("node_modules"))
    subprocess.run([npm, "install", "--no-audit", "--no-fund"], cwd=copy, check=True)
    subprocess.run([npm, "run", "build"], cwd=copy, check=True)
    assert (tmp_path / "page.min.js").read_bytes() == (FOLDER / "page.min.js").read_bytes()
