"""Animated glTF as three.js plays it in Chromium: where hands, beams and surfaces are drawn.

Needs Chromium, the package playwright, and npm, which fetches three and esbuild.
"""

from __future__ import annotations

import base64
import os
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
import cardan.view as view
from cardan.cli.demo import PACKAGE, locate
from cardan.errors import BuildError

sync_api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
CHROMIUM = os.environ.get("CHROMIUM") or shutil.which("chromium") or shutil.which("google-chrome")
NPM = shutil.which("npm")
if CHROMIUM is None:
    pytest.skip("there is no Chromium", allow_module_level=True)
if NPM is None:
    pytest.skip("npm is not installed", allow_module_level=True)

pytestmark = pytest.mark.slow
OPTIONS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
VIEWER = Path(__file__).with_name("gltf_viewer.js")
PACKAGES = Path(view.__file__).parent / "three" / "package.json"
# from axes of the scene, z upward, to those of glTF
UP = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])


@pytest.fixture(scope="module")
def viewer(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    """A page of Chromium that plays glTF by three's loader."""
    folder = tmp_path_factory.mktemp("viewer")
    shutil.copy(VIEWER, folder / "viewer.js")
    shutil.copy(PACKAGES, folder / "package.json")
    install = [str(NPM), "install", "--no-audit", "--no-fund"]
    if subprocess.run(install, cwd=folder, capture_output=True, timeout=300).returncode:
        pytest.skip("npm cannot fetch three")
    bundle = ["node_modules/.bin/esbuild", "viewer.js", "--bundle", "--outfile=bundle.js"]
    subprocess.run(bundle, cwd=folder, check=True, capture_output=True, timeout=120)
    page_file = folder / "page.html"
    page_file.write_text(
        '<!DOCTYPE html><meta charset="utf-8"><body><script src="bundle.js"></script>', "utf-8"
    )
    with sync_api.sync_playwright() as started:
        chromium = started.chromium.launch(executable_path=CHROMIUM, args=OPTIONS)

        def play(file: Path, picture: str = "") -> Playing:
            page = chromium.new_page(viewport={"width": 800, "height": 600})
            page.goto(page_file.as_uri())
            return Playing(page, file)

        yield play
        chromium.close()


class Playing:
    """A file that the viewer has loaded."""

    def __init__(self, page: Any, file: Path) -> None:
        self.page = page
        text = base64.b64encode(file.read_bytes()).decode("ascii")
        self.about = page.evaluate("text => window.show(text)", text)

    def seek(self, t: float) -> None:
        self.page.evaluate("t => window.seek(t)", t)

    def at(self, node: str) -> np.ndarray:
        return np.array(self.page.evaluate("name => window.at(name)", node))

    def vertices(self, node: str) -> np.ndarray:
        return np.array(self.page.evaluate("name => window.vertices(name)", node))


def test_the_hand_is_where_the_motion_has_it(viewer: Any, tmp_path: Path) -> None:
    """At times between keys, and on both sides of an impact."""
    scene = cd.Scene("arm <é>", gravity=(0, 0, -9.81))
    rod = cd.inertia.rod(1.0, 1.0, axis="z")
    upper = scene.body("upper", mass=1, com=(0, 0, -0.5), inertia=rod)
    lower = scene.body("lower. [b] /c", mass=1, com=(0, 0, -0.5), inertia=rod)
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -1), lower)
    lower.at(0, 0, -1, name="hand: 'right'")
    scene.force("stop", cd.Stop("elbow", upper=0.5, restitution=0.5))
    motion = cd.compile(scene).simulate(4.0, q={"shoulder": 1.0}, rtol=1e-9)
    assert motion.events
    playing = viewer(motion.save(tmp_path / "arm.glb"))
    assert playing.about["duration"] == pytest.approx(4.0, abs=1e-6)
    impact = motion.events[0].t
    for t in (0.4321, 1.7113, 3.97531, impact - 1e-3, impact + 1e-3):
        playing.seek(t)
        there = UP @ motion.resample([t]).pose("hand: 'right'")[0, :3, 3]
        assert np.linalg.norm(playing.at("hand: 'right'") - there) < 1e-5
    playing.page.screenshot(path=tmp_path / "arm.png")


def test_panda_with_meshes(viewer: Any, tmp_path: Path) -> None:
    try:
        path = locate("panda")
    except BuildError as missing:
        pytest.skip(str(missing))
    packages = [parent for parent in path.parents if parent.name == PACKAGE]
    model = cd.compile(cd.load(path, packages=packages))
    motion = model.simulate(2.0, q={"panda_joint2": 0.5, "panda_joint4": -1.5})
    playing = viewer(motion.save(tmp_path / "panda.glb"))
    for t in (0.123, 1.0777, 1.9):
        playing.seek(t)
        there = UP @ motion.resample([t]).pose("panda_hand")[0, :3, 3]
        assert np.linalg.norm(playing.at("panda_hand") - there) < 1e-5
    playing.page.screenshot(path=tmp_path / "panda.png")
    assert len(playing.vertices("panda_link1")) > 1000


def test_beams_bend_and_springs_stretch(viewer: Any, tmp_path: Path) -> None:
    scene = cd.Scene("bent", gravity=(0, 0, -9.81))
    steel = cd.material(E=2e9, nu=0.3, rho=2000)
    tip = scene.body("tip", mass=0.2, pose=(1, 0, 0))
    scene.beam("rod", scene.ground, tip, cd.section.circle(0.01), steel, elements=4)
    scene.force("coil", cd.SpringDamper(scene.ground.at(1, 0, 0.5), tip, 20.0, 0.1, 0.5))
    motion = cd.compile(scene).simulate(0.5)
    playing = viewer(motion.save(tmp_path / "bent.glb"))
    for t in (0.0, 0.1234, 0.5):
        playing.seek(t)
        row = motion.resample([t])
        end, place = row.line("rod")[0, -1], row.pose("tip")[0, :3, 3]
        assert np.linalg.norm(playing.at("tip") - UP @ place) < 1e-5
        skin = playing.vertices("rod")
        # the last ring and the end that closes it are around the tip, at the radius of the section
        far = np.sort(np.linalg.norm(skin - UP @ end, axis=1))[:48]
        np.testing.assert_allclose(far, 0.01, atol=1e-5)
        coil = playing.vertices("coil")
        ends = [UP @ place, UP @ np.array([1, 0, 0.5])]
        for point in ends:
            assert np.linalg.norm(coil - point, axis=1).min() < 0.01
    playing.page.screenshot(path=tmp_path / "bent.png")
