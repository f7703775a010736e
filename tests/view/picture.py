"""The picture of the README, ``docs/page.png``: the page of the Panda arm as Chromium shows it.

``make picture`` writes it; it needs Chromium and the package playwright.
"""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
from pathlib import Path

import cardan as cd
from cardan.cli.demo import PACKAGE, SCENES, locate

ROOT = Path(__file__).parents[2]
OPTIONS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]


def page(folder: Path) -> Path:
    """The page of the demo."""
    scene = SCENES["panda"]
    file = locate("panda")
    packages = [parent for parent in file.parents if parent.name == PACKAGE]
    model = cd.compile(cd.load(file, packages=packages, limits="stop", friction=True))
    motion = model.simulate(3.0, q=scene.q)
    shown = motion.animate(folder / "page.html", show="reactions", traces="panda_hand_tcp")
    return shown.saved()


def main() -> int:
    """Write the picture. Returns the exit status."""
    from playwright.sync_api import sync_playwright

    chromium = os.environ.get("CHROMIUM") or shutil.which("chromium")
    if chromium is None:
        print("there is no Chromium: set CHROMIUM", file=sys.stderr)
        return 1
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as started:
        browser = started.chromium.launch(executable_path=chromium, args=OPTIONS)
        shown = browser.new_page(viewport={"width": 1280, "height": 720})
        shown.goto(page(Path(folder)).as_uri() + "#t=0.3")
        shown.wait_for_selector("body[data-ready]")
        shown.wait_for_timeout(500)
        shown.screenshot(path=ROOT / "docs" / "page.png")
        browser.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
