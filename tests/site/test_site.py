"""The built site: no warnings, no broken links, nothing from elsewhere, and a search that finds."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urldefrag

import gallery
import pytest
import reference
import theory

from cardan.elements.centerlines import CENTERLINES
from cardan.elements.flexible import FLEXIBLE
from cardan.elements.forces import FORCES
from cardan.elements.joints import JOINTS
from cardan.elements.sections import SECTIONS
from golden.public import public

pytestmark = pytest.mark.slow
ROOT = Path(__file__).parents[2]
# what people of other fields type -> pages of which one is among the first three
SEARCHES: dict[str, set[str]] = {
    "inverse kinematics": {"closed_loops"},
    "closed chain": {"closed_loops"},
    "LQR": {"statics_and_modes", "gallery/26_lqr"},
    "gravity compensation": {"functions"},
    "spring rate": {"forces"},
    "hinge": {"scene_files"},
    "mode shape": {"statics_and_modes"},
    "end effector": {"functions"},
    "FMU": {"fmu"},
    "FMI": {"fmu"},
    "Simulink": {"fmu"},
    "co-simulation": {"fmu"},
    "embedded C": {"exports"},
    "CasADi": {"exports"},
    "JAX": {"exports"},
    "URDF out": {"exchange"},
    "glb": {"exchange"},
    "MCAP": {"exchange"},
    "SLURM": {"ensembles"},
    "companion": {"companions/index"},
    "double wishbone": {"parts"},
    "slider": {"live"},
    "share link": {"live"},
    "WebAssembly": {"live"},
    "no compiler": {"live"},
    "Jacobian": {"functions"},
    "PID": {"forces"},
    "contact": {"forces"},
    "friction": {"forces"},
    "Campbell diagram": {"statics_and_modes"},
    "URDF": {"robot_files"},
    "quaternion": {"conventions"},
    "Lagrange multiplier": {"closed_loops"},
    "stiff": {"integrators"},
    "time step": {"integrators"},
    "energy drift": {"integrators"},
    "parameter sweep": {"ensembles"},
    "Monte Carlo": {"ensembles"},
    "system identification": {"identification"},
    "bearing": {"forces"},
    "cable": {"flexible"},
    "damping ratio": {"statics_and_modes"},
    "natural frequency": {"statics_and_modes"},
    "prismatic": {"scene_files", "reference/joints"},
    "motor torque": {"functions"},
    "tire": {"space"},
    "buckling": {"branches"},
    "limit cycle": {"cycles"},
    "finite element model": {"superelements"},
    "KanesMethod": {"sympy"},
    "Baumgarte": {"closed_loops", "theory/constraints"},
    "baumgarte stabilization": {"closed_loops"},
    "animation": {"pictures"},
    "reaction force": {"forces"},
    "checkpoint": {"events"},
    "automatic differentiation": {"derivatives"},
}


@pytest.fixture(scope="module")
def site() -> Path:
    """The site, built with warnings as errors; what examples left is taken from the last time."""
    pytest.importorskip("sphinx")
    target = ROOT / "out" / "site"
    command = [sys.executable, str(ROOT / "docs/site/build_site.py"), str(target)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-4000:]
    return target


class _Page(HTMLParser):
    """Links, things that are loaded, and anchors of a page."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.links: list[str] = []
        self.loaded: list[str] = []
        self.anchors: set[str] = set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        names = dict(attrs)
        self.anchors |= {value for key in ("id", "name") if (value := names.get(key))}
        if tag == "a" and names.get("href"):
            self.links.append(str(names["href"]))
        elif tag in ("link", "script", "img", "iframe", "source", "video"):
            self.loaded += [str(names[key]) for key in ("src", "href") if names.get(key)]


@pytest.fixture(scope="module")
def pages(site: Path) -> dict[Path, _Page]:
    return {path: _Page(path) for path in sorted(site.rglob("*.html"))
            if "_static" not in path.parts}  # fmt: skip


def _inside(pages: dict[Path, _Page], kind: str) -> Iterator[tuple[Path, str]]:
    for path, page in pages.items():
        for link in getattr(page, kind):
            if not re.match(r"[a-z]+:", link):
                yield path, link


def test_nothing_is_loaded_from_elsewhere(pages: dict[Path, _Page]) -> None:
    outside = [
        f"{path.name}: {link[:80]}"
        for path, page in pages.items()
        for link in page.loaded
        if re.match(r"([a-z]+:)?//", link)
    ]
    assert not outside


def test_links_and_anchors_exist(site: Path, pages: dict[Path, _Page]) -> None:
    broken = []
    for kind in ("links", "loaded"):
        for path, link in _inside(pages, kind):
            file, anchor = urldefrag(link)
            target = (path.parent / unquote(file.partition("?")[0])).resolve() if file else path
            if not target.exists():
                broken.append(f"{path.relative_to(site)}: {link}")
            elif anchor and target in pages and unquote(anchor) not in pages[target].anchors:
                broken.append(f"{path.relative_to(site)}: {link} (no such anchor)")
    assert not broken, "\n".join(broken[:40])


def test_every_public_name_has_an_entry(site: Path) -> None:
    ids = {one for path in (site / "reference").glob("*.html") for one in _Page(path).anchors}
    missing = []
    for key, value in public().items():
        if key == "cardan.__version__":
            continue
        full = key if key.startswith("cardan.") else f"{value.__module__}.{value.__qualname__}"
        names = [full]
        if isinstance(value, type):
            names += [f"{full}.{own}" for own in reference.members(value)]
        missing += [name for name in names if name not in ids and f"module-{name}" not in ids]
    assert not missing, "\n".join(missing)


def test_every_member_of_a_family_has_its_theory(site: Path) -> None:
    def ids(page: str) -> set[str]:
        return _Page(site / "theory" / f"{page}.html").anchors

    def anchor(name: str) -> str:
        return name.lower().replace("_", "-")

    families = {
        "joints": JOINTS, "forces": FORCES, "flexible": FLEXIBLE, "sections": SECTIONS,
    }  # fmt: skip
    for page, family in families.items():
        assert {anchor(one.__name__) for one in family.values()} <= ids(page), page
    assert {anchor(one.__name__) for one in CENTERLINES.values()} <= ids("sections")
    for page, family in (
        ("formalisms", theory.FORMALISMS),
        ("integrators", theory.INTEGRATORS),
        ("constraints", {**theory.TREATMENTS, **theory.ROTATIONS}),
    ):
        assert {anchor(name) for name in family} <= ids(page), page
    text = (site / "theory" / "joints.html").read_text(encoding="utf-8")
    assert text.count("<math") > 3 * len(JOINTS)


def test_every_example_has_its_card(site: Path) -> None:
    index = _Page(site / "gallery" / "index.html")
    for script in gallery.examples():
        assert f"{script.stem}.html" in {Path(urldefrag(x)[0]).name for x in index.links}
        assert (site / "gallery" / f"{script.stem}.html").exists()
    assert sum("_images/" in x or "_static/gallery" in x for x in index.loaded) >= 30


def test_the_first_hour_shows_pictures(site: Path) -> None:
    text = (site / "first_hour.html").read_text(encoding="utf-8")
    assert text.count("<iframe") >= 4
    assert text.count("<img") + text.count("<svg") >= 6
    assert "Traceback" not in text


def test_searches_in_the_words_of_others(site: Path) -> None:
    node = shutil.which("node")
    if node is None:
        pytest.skip("the search of the site runs in node")
    command = [node, str(Path(__file__).with_name("search.js")), str(site), *SEARCHES]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    wrong = []
    for (query, wanted), found in zip(SEARCHES.items(), json.loads(done.stdout), strict=True):
        first = [one.partition("#")[0] for one in found[:3]]
        if not wanted & set(first):
            wrong.append(f"{query}: {first}")
    assert not wrong, "\n".join(wrong)
