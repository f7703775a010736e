"""Pictures of the documents: pages as Chromium shows them.

``docs/page.png`` of the README is the Panda arm, ``docs/mode.png`` a mode of a superelement,
``docs/link.png`` one in motion, ``docs/antenna.png`` eight of them, ``docs/parts_*.png`` the parts
of the library.
``make picture`` writes them, with names of pictures only those; it needs Chromium and the package
playwright.
"""

from __future__ import annotations

import os
import runpy
import shutil
import sys
import tempfile
from functools import partial
from pathlib import Path

import numpy as np

import cardan as cd
from cardan.cli.demo import PACKAGE, SCENES, locate
from cardan.parts import PARTS

ROOT = Path(__file__).parents[2]
SHADES = 128  # of a small picture
PATIENCE = 120_000  # milliseconds, as the graphics are computed by software
OPTIONS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]


def panda(folder: Path) -> str:
    """The page of the demo."""
    scene = SCENES["panda"]
    file = locate("panda")
    packages = [parent for parent in file.parents if parent.name == PACKAGE]
    model = cd.compile(cd.load(file, packages=packages, limits="stop", friction=True))
    motion = model.simulate(3.0, q=scene.q)
    page = motion.animate(folder / "page.html", show="reactions", traces="panda_hand_tcp")
    return page.saved().as_uri() + "#t=0.3"


def mode(folder: Path) -> str:
    """A mode of the lug of the tests with its root fixed."""
    lug = ROOT / "tests" / "solids" / "files" / "lug.inp"
    aluminium = cd.material(E=70e9, nu=0.3, rho=2700)
    ends = {"base": "root", "pin": "hole"}
    record = cd.superelement.from_mesh(lug, aluminium, ends, modes=6, scale=1e-3)
    quarter = np.pi / 2 / record.modes("base").frequencies[1]
    page = record.animate(2, folder / "mode.html", locked=["base"], title="Mode 2, base fixed")
    return f"{page.saved().as_uri()}#t={quarter}"


def link(folder: Path) -> str:
    """The robot with a link from a mesh of the example."""
    example = ROOT / "examples" / "30_flexible_link.py"
    os.chdir(folder)
    motion = runpy.run_path(str(example))["motion"]
    page = motion.animate(folder / "link.html", plots=["motor"], show="stress")
    row = motion.superelement("arm").largest_stress.argmax()
    return f"{page.saved().as_uri()}#t={motion.t[row]}&bare"


def antenna(folder: Path) -> str:
    """The antenna of the example, where its ribs are bent most."""
    example = ROOT / "examples" / "31_deployable_antenna.py"
    os.chdir(folder)
    result = runpy.run_path(str(example))
    page = result["motion"].animate(folder / "antenna.html", show="stress")
    return f"{page.saved().as_uri()}#t={result['motion'].t[result['stress'].argmax()]}&bare"


def part(name: str, folder: Path) -> str:
    """The page of a part of the library, a little after its start."""
    scene = PARTS[name]()
    motion = cd.compile(scene).simulate(**scene.settings | {"t": 0.2})
    return f"{motion.animate(folder / f'{name}.html').saved().as_uri()}#t=0.05&bare"


PICTURES = {
    **{f"parts_{name}": (partial(part, name), (480, 320)) for name in PARTS},
    "page": (panda, (1280, 720)),
    "mode": (mode, (960, 480)),
    "link": (link, (960, 480)),
    "antenna": (antenna, (960, 480)),
}


def main() -> int:
    """Write the pictures. Returns the exit status."""
    from PIL import Image
    from playwright.sync_api import sync_playwright

    chromium = os.environ.get("CHROMIUM") or shutil.which("chromium")
    if chromium is None:
        print("there is no Chromium: set CHROMIUM", file=sys.stderr)
        return 1
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as started:
        browser = started.chromium.launch(executable_path=chromium, args=OPTIONS)
        for name in sys.argv[1:] or PICTURES:
            address, (width, height) = PICTURES[name]
            page = browser.new_page(viewport={"width": width, "height": height})
            page.goto(address(Path(folder)))
            page.wait_for_selector("body[data-ready]", timeout=PATIENCE)
            page.wait_for_timeout(500)
            path = ROOT / "docs" / f"{name}.png"
            page.screenshot(path=path)
            if name.startswith("parts_"):
                Image.open(path).quantize(SHADES).save(path, optimize=True)
        browser.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
