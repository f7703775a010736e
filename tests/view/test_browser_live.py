"""Pages in which models run, in a browser: bits, a hand, sliders, a link, a phone, the night.

Needs Chromium and the package playwright (``make browser`` installs the latter).
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from view import live_native
from view.test_browser import CHROMIUM, OPTIONS, sync_api
from view.test_live import WORDS, data_of, number

KINDS = ("plain", "3d")


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with sync_api.sync_playwright() as started:
        chromium = started.chromium.launch(executable_path=CHROMIUM, args=OPTIONS)
        yield chromium
        chromium.close()


@pytest.fixture(scope="module", params=KINDS)
def file(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp(request.param) / "page.html"
    scene = cd.load(cd.examples.path("double_pendulum"))
    cd.page(scene, path, q={"shoulder": 1.0}, page=request.param, traces="lower", rtol=1e-9)
    return path


@pytest.fixture
def page(browser: Any, file: Path) -> Iterator[Any]:
    context = browser.new_context(viewport={"width": 900, "height": 640}, bypass_csp=False)
    shown = context.new_page()
    complaints: list[str] = []
    requests: list[str] = []
    shown.on("pageerror", lambda error: complaints.append(str(error)))
    shown.on("console", lambda said: complaints.append(said.text))
    shown.on("request", lambda request: requests.append(request.url))
    shown.goto(file.as_uri())
    shown.wait_for_selector("body[data-live]", timeout=60000)
    yield shown
    context.close()
    assert complaints == []
    # the page alone
    assert {url.partition("#")[0] for url in requests} == {file.as_uri()}


def test_the_browser_has_the_bits_of_a_native_build(page: Any, file: Path, tmp_path: Path) -> None:
    found = page.evaluate(
        f"() => {{ {WORDS} const {{ live, panel }} = window.cardan; panel.play(false);"
        "live.start(); const x = [...live.x]; for (let k = 0; k < 60; k++) live.advance(1 / 60);"
        "return { x, words: words(live.x) }; }"
    )
    equations = cd.derive(cd.load(cd.examples.path("double_pendulum")))
    live = data_of(file.read_text("utf-8"))["live"]
    native = live_native.library(equations, [*live["bodies"], "lower"], tmp_path / "native")
    expected = live_native.run(native, found["x"], 1.0, live["rtol"], live["atol"], 60)
    assert number(found["words"]).tobytes() == expected.tobytes()


def test_time_goes_on_and_stops(page: Any) -> None:
    page.wait_for_function("() => window.cardan.live.t > 0.05", timeout=20000)
    page.keyboard.press("Space")
    first = page.evaluate("() => window.cardan.live.t")
    page.wait_for_timeout(300)
    assert page.evaluate("() => window.cardan.live.t") == first
    page.get_by_text("Reset").click()
    assert page.evaluate("() => window.cardan.live.t") < 1.0


def test_sliders_and_the_link_that_holds_them(page: Any) -> None:
    page.evaluate(
        "() => { const range = document.querySelector('#live-sliders input');"
        "range.value = 2.5; range.dispatchEvent(new Event('input')); }"
    )
    page.wait_for_function("() => window.cardan.live.p[0] === 2.5", timeout=20000)
    page.get_by_text("Share").click()
    page.wait_for_function("() => location.hash.includes('m=2.5')", timeout=20000)
    page.reload()
    page.wait_for_selector("body[data-live]", timeout=60000)
    assert page.evaluate("() => window.cardan.live.p[0]") == 2.5
    # what says no number leaves the slider where it is
    page.evaluate("() => { location.hash = '#m='; }")
    page.wait_for_function("() => window.cardan.live.t < 0.5", timeout=20000)
    assert page.evaluate("() => window.cardan.live.p[0]") == 2.5


def test_a_hand_pulls_a_body(page: Any) -> None:
    page.evaluate("() => { window.cardan.panel.play(false); }")
    box = page.locator("#stage").bounding_box()
    # where the tip of the lower rod is drawn, by looking for what can be gripped
    hit = page.evaluate(
        """(box) => { const { viewer } = window.cardan.panel;
        for (let y = box.height - 160; y > 40; y -= 5) for (let x = 300; x < box.width; x += 5) {
          const hit = viewer.pick(box.x + x, box.y + y);
          if (hit && hit.body === 1) return { x: box.x + x, y: box.y + y };
        }
        return null; }""",
        box,
    )
    assert hit is not None
    energy = "() => window.cardan.live.call('energy')[2]"
    before = page.evaluate(energy)
    page.mouse.move(hit["x"], hit["y"])
    page.mouse.down()
    page.mouse.move(hit["x"] + 120, hit["y"] - 60, steps=4)
    page.wait_for_function(
        "() => window.cardan.panel.pulled && window.cardan.live.r.some((x) => x !== 0)",
        timeout=20000,
    )
    page.wait_for_timeout(400)
    page.mouse.up()
    assert page.evaluate("() => window.cardan.panel.pulled") is None
    assert page.evaluate("() => window.cardan.live.r.every((x) => x === 0)")
    # a hand does work
    assert abs(page.evaluate(energy) - before) > 1e-3


def test_on_a_phone_nothing_is_wider_than_the_screen(browser: Any, file: Path) -> None:
    context = browser.new_context(viewport={"width": 390, "height": 760}, color_scheme="dark")
    shown = context.new_page()
    shown.goto(file.as_uri())
    shown.wait_for_selector("body[data-live]", timeout=60000)
    width = shown.evaluate("() => document.documentElement.scrollWidth")
    assert width <= 390
    # the panel is folded
    assert not shown.evaluate("() => document.querySelector('#live details').open")
    context.close()


def test_numbers_of_the_page_are_finite(page: Any) -> None:
    frames = page.evaluate("() => [...window.cardan.live.frames()]")
    assert np.isfinite(frames).all()
