"""The 3-D page in a browser: what it draws, keys, fingers, strip, names, colors of the night.

Needs Chromium and the package playwright (``make browser`` installs the latter).
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd

sync_api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
CHROMIUM = os.environ.get("CHROMIUM") or shutil.which("chromium") or shutil.which("google-chrome")
if CHROMIUM is None:
    pytest.skip("there is no Chromium", allow_module_level=True)

# software rendering, and no request of the browser's own
OPTIONS = [
    "--no-sandbox",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with sync_api.sync_playwright() as started:
        chromium = started.chromium.launch(executable_path=CHROMIUM, args=OPTIONS)
        yield chromium
        chromium.close()


@pytest.fixture(scope="module")
def motion() -> cd.Trajectory:
    scene = cd.Scene("arm </script>", gravity=(0, 0, -9.81))
    rod = cd.inertia.rod(1.0, 1.0, axis="z")
    upper = scene.body("upper", mass=1, com=(0, 0, -0.5), inertia=rod)
    lower = scene.body("lower", mass=1, com=(0, 0, -0.5), inertia=rod)
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -1), lower)
    lower.at(0, 0, -1, name="hand")
    scene.force("stop", cd.Stop("elbow", upper=0.5))
    return cd.compile(scene).simulate(4.0, q={"shoulder": 1.0})


@pytest.fixture(scope="module")
def file(motion: cd.Trajectory, tmp_path_factory: pytest.TempPathFactory) -> str:
    path = tmp_path_factory.mktemp("page") / "page.html"
    return motion.animate(path, show="reactions").saved().as_uri()


class Shown:
    """A page in a browser, and what it complained of."""

    def __init__(self, browser: Any, url: str, **options: Any) -> None:
        size = options.pop("size", (1000, 700))
        viewport = {"width": size[0], "height": size[1]}
        self.context = browser.new_context(viewport=viewport, **options)
        self.page = self.context.new_page()
        self.complaints: list[str] = []
        self.requests: list[str] = []
        self.page.on("pageerror", lambda error: self.complaints.append(str(error)))
        self.page.on("console", lambda said: self.complaints.append(f"{said.type}: {said.text}"))
        self.page.on("request", lambda request: self.requests.append(request.url))
        self.page.goto(url)
        self.page.wait_for_selector("body[data-ready]")

    def __enter__(self) -> Shown:
        return self

    def __exit__(self, *_: object) -> None:
        self.context.close()

    def tell(self, expression: str) -> Any:
        """The value of an expression; the page allows no strings as code, so look past that."""
        return self.page.evaluate(f"() => window.cardan.{expression}")

    @property
    def time(self) -> float:
        return float(self.tell("time"))


@pytest.fixture
def shown(browser: Any, file: str) -> Iterator[Shown]:
    with Shown(browser, f"{file}#t=1", bypass_csp=True) as page:
        yield page


def test_nothing_is_asked_for_and_nothing_fails(browser: Any, file: str) -> None:
    with Shown(browser, file) as page:
        page.page.wait_for_timeout(300)
        assert [url.split("#")[0] for url in page.requests] == [file]
        # what software rendering says of itself is not ours
        assert [said for said in page.complaints if "GPU stall" not in said] == []


def test_bodies_stand_where_the_motion_says(shown: Shown, motion: cd.Trajectory) -> None:
    for t in (0.0, 1.3, 3.7):
        shown.tell(f"seek({t})")
        exact = motion.resample([t]).pose("lower")[0, :3, 3]
        here = shown.tell("project(window.cardan.position('lower'))")
        there = shown.tell(f"project({exact.tolist()})")
        assert np.hypot(*np.subtract(here, there)) < 2
        # and are drawn there: the ball of the elbow has the name of its body
        shown.page.mouse.move(there[0], there[1])
        shown.page.wait_for_selector("#tag:not([hidden])")
        assert shown.page.inner_text("#tag") == "lower"
        shown.page.mouse.move(3, 690)


def test_something_is_drawn_and_hidden_again(shown: Shown) -> None:
    def colored() -> int:
        """Pixels with the blue of the first body."""
        expression = """() => {
          const stage = document.getElementById("stage"), copy = document.createElement("canvas");
          [copy.width, copy.height] = [stage.width, stage.height];
          const pen = copy.getContext("2d");
          pen.drawImage(stage, 0, 0);
          const d = pen.getImageData(0, 0, copy.width, copy.height).data;
          let n = 0;
          for (let i = 0; i < d.length; i += 4) if (d[i + 3] > 200 && d[i + 2] > d[i] + 60) n++;
          return n; }"""
        return int(shown.page.evaluate(expression))

    before = colored()
    assert before > 1000
    shown.page.click("#list")
    shown.page.uncheck("[aria-label='show upper']")
    shown.page.wait_for_timeout(200)
    assert colored() < 0.3 * before


def test_keys(shown: Shown) -> None:
    press = shown.page.keyboard.press
    assert shown.time == pytest.approx(1.0)
    press("ArrowRight")
    assert shown.time == pytest.approx(1.01)
    press("Shift+ArrowLeft")
    assert shown.time == pytest.approx(0.91)
    press("End")
    assert shown.time == pytest.approx(4.0)
    press("Home")
    assert shown.time == 0
    before = shown.tell("camera")
    press("d")
    press("w")
    assert np.linalg.norm(np.subtract(shown.tell("camera"), before)) > 0.1
    press("2")
    target, camera = np.array(shown.tell("target")), np.array(shown.tell("camera"))
    along = (camera - target) / np.linalg.norm(camera - target)
    np.testing.assert_allclose(along, [0, -1, 0], atol=1e-3)
    press("0")
    np.testing.assert_allclose(shown.tell("camera"), before, atol=1e-6)
    press("+")
    assert np.linalg.norm(np.subtract(shown.tell("camera"), shown.tell("target"))) == pytest.approx(
        0.9 * np.linalg.norm(np.subtract(before, target)), rel=0.2
    )
    press(" ")
    for _ in range(50):
        shown.page.wait_for_timeout(100)
        if shown.time > 0.05:
            break
    press(" ")
    assert 0.05 < shown.time < 4
    press("?")
    assert "play or pause" in shown.page.inner_text("#keys")


def test_two_fingers_zoom_and_one_turns(browser: Any, file: str) -> None:
    with Shown(browser, f"{file}#t=1", bypass_csp=True, has_touch=True) as page:
        client = page.context.new_cdp_session(page.page)

        def touch(kind: str, *points: tuple[float, float]) -> None:
            rows = [{"x": x, "y": y, "id": k} for k, (x, y) in enumerate(points)]
            client.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": rows})

        def arm() -> Any:
            return np.subtract(page.tell("camera"), page.tell("target"))

        before = arm()
        touch("touchStart", (450, 200), (550, 200))
        for k in range(1, 6):
            touch("touchMove", (450 - 20 * k, 200), (550 + 20 * k, 200))
        touch("touchEnd")
        page.page.wait_for_timeout(100)
        nearer = arm()
        assert np.linalg.norm(nearer) < 0.8 * np.linalg.norm(before)
        touch("touchStart", (450, 200))
        for k in range(1, 6):
            touch("touchMove", (450 + 20 * k, 200))
        touch("touchEnd")
        page.page.wait_for_timeout(100)
        assert np.linalg.norm(arm() - nearer) > 0.1
        assert np.linalg.norm(arm()) == pytest.approx(np.linalg.norm(nearer), rel=1e-3)


def test_strip_and_slider_are_in_step(shown: Shown) -> None:
    box = shown.page.locator("#strip").bounding_box()
    shown.page.mouse.click(box["x"] + box["width"] / 2, box["y"] + 40)
    assert shown.time == pytest.approx(2.0, abs=0.15)
    # the slider follows with the next picture
    shown.page.wait_for_function(
        "Math.abs(document.getElementById('time').value - cardan.time) < 1e-6", timeout=60000
    )
    assert "total" in shown.page.inner_text("#legend")
    shown.page.click("#tabs button:nth-child(2)")
    shown.page.wait_for_function(
        "document.getElementById('legend').innerText.includes('elbow')", timeout=60000
    )


def test_camera_follows(shown: Shown) -> None:
    shown.page.click("#list")
    shown.page.select_option("#follow", "1")
    before = np.subtract(shown.tell("position('lower')"), shown.tell("target"))
    shown.tell("seek(2.2)")
    after = np.subtract(shown.tell("position('lower')"), shown.tell("target"))
    np.testing.assert_allclose(after, before, atol=1e-6)


def test_night_phone_and_still(browser: Any, file: str) -> None:
    options = {"color_scheme": "dark", "size": (390, 780), "reduced_motion": "reduce"}
    with Shown(browser, file, bypass_csp=True, **options) as page:
        assert page.page.evaluate("() => document.documentElement.dataset.theme") == "dark"
        # nobody who asked for less motion gets some
        page.page.wait_for_timeout(300)
        assert page.time == 0
        wide = page.page.evaluate("() => document.documentElement.scrollWidth")
        assert wide <= 390
        for name in ("#play", "#time", "#list", "#home"):
            box = page.page.locator(name).bounding_box()
            assert box["x"] >= 0
            assert box["x"] + box["width"] <= 390
        assert "upper, lower" in page.page.get_attribute("#stage", "aria-label")


def test_every_control_has_a_name(shown: Shown) -> None:
    unnamed = shown.page.evaluate(
        """() => [...document.querySelectorAll("button, input, select, canvas")].filter((x) =>
           !(x.getAttribute("aria-label") || x.textContent.trim() || x.closest("[aria-hidden]")
             || x.closest("label")?.textContent.trim())).map((x) => x.id)"""
    )
    assert unnamed == []


def test_a_page_of_a_beam_is_of_moderate_size(tmp_path: Path) -> None:
    scene = cd.Scene("beam", gravity=(0, 0, -9.81))
    rubber = cd.material(E=5e6, nu=0.3, rho=1100)
    beam = scene.beam("bar", (0, 0, 0), (1, 0, 0), cd.section.circle(0.02), rubber, elements=10)
    scene.joint("pin", cd.Revolute("y"), scene.ground, beam.start)
    motion = cd.compile(scene).simulate(2.0, step=5e-3)
    assert motion.animate(tmp_path / "beam.html").path.stat().st_size < 300_000  # type: ignore[union-attr]


def test_views_go_with_a_body_that_is_followed(browser: Any, tmp_path: Path) -> None:
    """They looked at the start of the scene, from which a stone had fallen 80 m."""
    scene = cd.Scene("fall", gravity=(0, 0, -9.81))
    shape = cd.shape.box(0.3, 0.3, 0.3)
    stone = scene.body("stone", mass=1, inertia=(1, 1, 1), shape=shape)
    scene.joint("fly", cd.Free(), scene.ground, stone)
    page = cd.compile(scene).simulate(5.0).animate(tmp_path / "page.html", follow="stone")
    with Shown(browser, f"{page.saved().as_uri()}#t=4", bypass_csp=True) as shown:
        for key in ("2", "0", "1"):
            shown.page.keyboard.press(key)
            shown.page.wait_for_timeout(100)
            x, y = shown.tell("project(window.cardan.position('stone'))")
            assert 0 < x < 1000
            assert 0 < y < 600


def test_the_picture_comes_back_with_the_graphics(shown: Shown) -> None:
    """A page that was paused stayed empty."""
    shown.page.evaluate(
        """() => { window.lose = document.getElementById("stage").getContext("webgl2")
          .getExtension("WEBGL_lose_context"); window.lose.loseContext(); }"""
    )
    shown.page.wait_for_timeout(100)
    shown.page.evaluate("() => window.lose.restoreContext()")
    shown.page.wait_for_function(
        """() => { const gl = document.getElementById("stage").getContext("webgl2");
          const d = new Uint8Array(4 * 200 * 200);
          gl.readPixels(400, 200, 200, 200, gl.RGBA, gl.UNSIGNED_BYTE, d);
          return d.some((x) => x > 0); }""",
        timeout=60000,
    )


def test_an_address_that_is_changed_is_followed(shown: Shown) -> None:
    shown.page.evaluate("() => { location.hash = 't=2.5&theme=dark'; }")
    shown.page.wait_for_function("() => document.documentElement.dataset.theme === 'dark'")
    assert shown.time == pytest.approx(2.5)


def test_numbers_of_axes_differ_and_are_short(browser: Any, tmp_path: Path) -> None:
    """Late times were all 12350, large energies did not fit beside the curves."""
    scene = cd.Scene("late", gravity=(0, 0, -9.81))
    rod = scene.body("rod", mass=1e9, com=(0, 0, -0.5), inertia=(3e8, 3e8, 1e8))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
    times = np.linspace(12345, 12350, 100)
    page = cd.compile(scene).simulate(times, q={"pivot": 1.0}).animate(tmp_path / "page.html")
    keep = """window.texts = []; const write = CanvasRenderingContext2D.prototype.fillText;
      CanvasRenderingContext2D.prototype.fillText = function (text, ...more) {
        if (this.canvas.id === "strip") window.texts.push(text);
        write.call(this, text, ...more); }"""
    context = browser.new_context(bypass_csp=True)
    shown = context.new_page()
    shown.add_init_script(keep)
    shown.goto(page.saved().as_uri() + "#t=12346")
    shown.wait_for_selector("body[data-ready]")
    shown.wait_for_timeout(200)
    texts = set(shown.evaluate("() => window.texts"))
    context.close()
    assert {"12346", "12347", "12348", "-2e9"} <= texts
    assert max(map(len, texts)) <= 8


def test_what_is_hidden_has_no_name_under_the_pointer(browser: Any, tmp_path: Path) -> None:
    scene = cd.Scene("hung")
    rod = scene.body("rod", mass=1, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.1))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
    rope = cd.SpringDamper(scene.ground.at(1, 0, -1), rod.at(0, 0, -1), stiffness=3)
    scene.force("rope", rope)
    motion = cd.compile(scene).simulate(1.0)
    page = motion.animate(tmp_path / "page.html").saved().as_uri()
    with Shown(browser, f"{page}#t=0", bypass_csp=True) as shown:

        def names() -> set[str]:
            """What the pointer finds about the middle of the rope."""
            x, y = shown.tell("project([0.5, 0, -1])")
            found = set()
            for k in range(-12, 13, 4):
                shown.page.mouse.move(x, y + k)
                shown.page.wait_for_timeout(80)
                found.add(shown.page.evaluate("() => document.getElementById('tag').hidden"))
            return found

        assert False in names()
        shown.page.click("#list")
        shown.page.uncheck("#layer-springs")
        shown.page.click("#list")
        assert names() == {True}
