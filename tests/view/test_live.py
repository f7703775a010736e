"""Pages in which a model runs: bits of a native build, sliders, assembly, pulling, refusals."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.codegen.wasm import build
from cardan.schema import wasm_kernels
from cardan.view.packing import text_of
from view import live_native

NODE = shutil.which("node")
needs_node = pytest.mark.skipif(NODE is None, reason="node is not installed")
LOAD = """
const fs = require("fs"), zlib = require("zlib"), html = fs.readFileSync(process.argv[2], "utf8");
const text = (id) => html.match(new RegExp(`id="${id}">([^<]*)</script>`))[1];
const bytes = (id) => zlib.inflateSync(Buffer.from(text(id), "base64"));
const data = JSON.parse(text("data"));
const live = new LiveModel(data.live, bytes("live-kernels"), bytes("live-model"));
"""


def scene(name: str) -> cd.Scene:
    return cd.load(cd.examples.path(name))


def told(html: Any, program: str, folder: Path) -> Any:
    """What a program of node prints about the model of a page, as JSON."""
    page, script = folder / "page.html", folder / "run.js"
    page.write_text(html.html, "utf-8")
    script.write_text(text_of("live.js") + LOAD + program, "utf-8")
    answer = subprocess.run(
        [str(NODE), str(script), str(page)], capture_output=True, text=True, check=False
    )
    assert answer.returncode == 0, answer.stderr
    return json.loads(answer.stdout)


def data_of(html: str) -> dict[str, Any]:
    found = re.search(r'id="data">([^<]*)</script>', html)
    assert found is not None
    return dict(json.loads(found[1]))


START = {"double_pendulum": {"shoulder": 1.0}, "cart_pole": {"pole": 0.4}}
# of which no function calls the mathematical library, whose last digit differs from one to another
EXACT = ("double_pendulum", "four_bar", "bouncing_ball", "cart_pole", "quadrotor")
WORDS = "const words = (x) => [...new Uint32Array(Float64Array.from(x).buffer)];"


def number(words: list[int]) -> np.ndarray:
    """The doubles whose words these are."""
    return np.array(words, dtype=np.uint32).view(np.float64)


@needs_node
@pytest.mark.filterwarnings("ignore::cardan.errors.SolveWarning")
@pytest.mark.parametrize("name", [*EXACT, "bicycle"])
def test_the_state_after_a_second_has_the_bits_of_a_native_build(name: str, tmp_path: Path) -> None:
    equations = cd.derive(scene(name))
    page = cd.page(equations, tmp_path / "first.html", q=START.get(name), rtol=1e-9)
    found = told(
        page,
        f"{WORDS} const first = live.x.slice(); let status = 0;"
        "for (let k = 0; k < 60; k++) status ||= live.advance(1 / 60);"
        "console.log(JSON.stringify({ status, t: live.t, x: [...first], words: words(live.x) }));",
        tmp_path,
    )
    assert found["status"] == 0
    assert found["t"] == pytest.approx(1.0, abs=1e-12)
    live = data_of(page.html)["live"]
    native = live_native.library(equations, live["bodies"], tmp_path / "native")
    expected = live_native.run(native, found["x"], 1.0, live["rtol"], live["atol"], 60)
    here = number(found["words"])
    if name in EXACT:
        assert here.tobytes() == expected.tobytes()
    assert np.abs(here - expected).max() < 1e-12
    # and it is the motion that simulate computes
    motion = cd.compile(equations).simulate(1.0, x0=found["x"], rtol=1e-11, atol=1e-13)
    assert np.abs(here - motion.x[-1]).max() < 1e-6


@needs_node
def test_a_pull_is_what_the_jacobian_makes_of_it(tmp_path: Path) -> None:
    arm = cd.load(cd.examples.path("acrobat"))
    model, page = cd.compile(arm), cd.page(arm, tmp_path / "a.html", meshes=False)
    live = data_of(page.html)["live"]
    body = len(live["bodies"]) - 1
    found = told(
        page,
        f"const f = live.frames().subarray({18 * body + 9}, {18 * body + 12});"
        f"const p = [f[0] + 0.1, f[1], f[2] - 0.2], F = [3, -1, 2]; live.pull({body}, p, F);"
        "const tau = [...live.r.subarray(live.forces)], rate = [...live.call('rhs')];"
        f"const felt = live.felt({body}, p, [0, 0, 1]);"
        "console.log(JSON.stringify({ x: [...live.x], p, tau, rate, felt }));",
        tmp_path,
    )
    q, u = model.split(np.array(found["x"]))
    name, arm_of = live["bodies"][body], np.array([0.1, 0.0, -0.2])
    jacobian = model.frame_jacobian(name, q)
    along = jacobian[3:] - np.cross(arm_of, jacobian[:3], axis=0)
    np.testing.assert_allclose(found["tau"], along.T @ [3, -1, 2], atol=1e-12)
    udot = model.forward_dynamics(q, u, tau=np.array(found["tau"]))
    np.testing.assert_allclose(found["rate"][model.nq :], udot, atol=1e-9)
    # the mass that is felt: 1 / (J M^-1 J^T)
    mass = 1.0 / (along[2] @ np.linalg.solve(model.mass_matrix(q), along[2]))
    assert found["felt"] == pytest.approx(mass, rel=1e-9)


@needs_node
@pytest.mark.filterwarnings("ignore::cardan.errors.SolveWarning")
def test_a_loop_is_assembled_at_every_length_or_stays_as_it_was(tmp_path: Path) -> None:
    page = cd.page(scene("four_bar"), tmp_path / "a.html", sliders={"C.position.x": (0.1, 2.0)})
    k = data_of(page.html)["live"]["sliders"][0]["index"]
    gap = "Math.max(...[...live.call('close_position')].slice(live.sizes.nq).map(Math.abs))"
    found = told(
        page,
        "const rows = [];"
        f"const row = (value) => rows.push([live.change({k}, value), live.p[{k}], {gap}]);"
        "for (const value of [0.3, 0.2, 0.45]) row(value); const x = [...live.x]; row(1.9);"
        "console.log(JSON.stringify({ rows, x, after: [...live.x] }));",
        tmp_path,
    )
    *good, bad = found["rows"]
    for value, (changed, p, gap_of) in zip((0.3, 0.2, 0.45), good, strict=True):
        assert (changed, p) == (True, value)
        assert gap_of < 1e-9
    # longer than the others together
    assert bad[:2] == [False, 0.45]
    assert bad[2] < 1e-9
    np.testing.assert_allclose(found["after"], found["x"], atol=1e-6)


@needs_node
def test_sliders_change_what_simulate_would_compute(tmp_path: Path) -> None:
    pendulum = scene("double_pendulum")
    page = cd.page(pendulum, tmp_path / "a.html", q={"shoulder": 1.0}, rtol=1e-10)
    live = data_of(page.html)["live"]
    assert [row["name"] for row in live["sliders"]] == ["m", "l"]
    k = {row["name"]: row["index"] for row in live["sliders"]}
    found = told(
        page,
        f"live.change({k['l']}, 0.8); live.change({k['m']}, 2.5); const status = live.advance(1.5);"
        "console.log(JSON.stringify({ status, x: [...live.x] }));",
        tmp_path,
    )
    model = cd.compile(pendulum).with_parameters(l=0.8, m=2.5)
    motion = model.simulate(1.5, q={"shoulder": 1.0}, rtol=1e-11)
    np.testing.assert_allclose(found["x"], motion.x[-1], atol=1e-8)


def sampled(built: cd.Scene, joint: str) -> cd.Scene:
    """A scene with a sampled controller that integrates."""
    q, u = built.q(joint), built.u(joint)
    law = cd.Controller.pid(joint, q, u, target=0.1, kp=0.2, ki=3, kd=0.02, sample=0.03125)
    built.force("pid", law)
    return built


@needs_node
@pytest.mark.parametrize("slices", [1, 16, 32, 500])
def test_a_sample_happens_once_where_pictures_meet_it(slices: int, tmp_path: Path) -> None:
    scene_of = sampled(scene("double_pendulum"), "elbow")
    page = cd.page(scene_of, tmp_path / "a.html", q={"shoulder": 1.0}, rtol=1e-10)
    found = told(
        page,
        f"let status = 0; const n = {slices};"
        "for (let k = 0; k < n; k++) status ||= live.advance(0.5 / n);"
        "status ||= live.advance(0.51 - live.t);"
        "console.log(JSON.stringify({ status, t: live.t, x: [...live.x], s: [...live.s] }));",
        tmp_path,
    )
    assert found["status"] == 0
    motion = cd.compile(scene_of).simulate(found["t"], q={"shoulder": 1.0}, rtol=1e-11)
    np.testing.assert_allclose(found["s"], motion.s[-1], atol=1e-8)
    np.testing.assert_allclose(found["x"], motion.x[-1], atol=1e-8)


@needs_node
def test_a_slider_closes_loops_and_does_nothing_else(tmp_path: Path) -> None:
    page = cd.page(sampled(scene("four_bar"), "A"), sliders=["crank.mass", "B.position.x"])
    mass, length = (row["index"] for row in data_of(page.html)["live"]["sliders"])
    found = told(
        page,
        "const status = live.advance(0.1), x = [...live.x], s = [...live.s];"
        f"live.change({mass}, 0.2); const heavy = [...live.x]; live.change({length}, 0.09);"
        "console.log(JSON.stringify({ status, x, s, heavy, after: [...live.s] }));",
        tmp_path,
    )
    assert found["status"] == 0
    assert found["after"] == found["s"] != [0.0] * len(found["s"])
    np.testing.assert_allclose(found["heavy"], found["x"], atol=1e-12)


def fixed() -> cd.Scene:
    """A body that cannot move."""
    made = cd.Scene("fixed")
    made.joint("weld", cd.Fixed(), made.ground, made.body("block", mass=1.0))
    return made


@needs_node
def test_a_scene_without_coordinates_has_a_page(tmp_path: Path) -> None:
    found = told(
        cd.page(fixed(), tmp_path / "a.html"),
        "const status = live.advance(0.5), frames = [...live.frames()];"
        "console.log(JSON.stringify({ status, t: live.t, frames }));",
        tmp_path,
    )
    assert found["status"] == 0
    assert found["t"] == 0.5


def test_shapes_follow_their_sliders() -> None:
    page = cd.page(scene("double_pendulum"), q={"shoulder": 1.0}, sliders={"l": (0.25, 1.0)})
    live = data_of(page.html)["live"]
    ends = [row for row in live["shapes"] if row["field"] == "b" and row["body"] == 0]
    # the rod ends where the next one begins
    found = [[value[2] for value in row["values"]] for row in ends]
    assert any(np.allclose(z, -np.array(row["at"])) for z, row in zip(found, ends, strict=True))


def test_a_page_is_small_and_asks_for_nothing(tmp_path: Path) -> None:
    page = cd.page(scene("double_pendulum"), tmp_path / "page.html", q={"shoulder": 1.0})
    assert (tmp_path / "page.html").stat().st_size <= 100_000
    assert not re.search(r"(src|href)=", page.html)
    assert "'wasm-unsafe-eval'" in page.html
    assert "'unsafe-eval'" not in page.html


def test_names_of_users_stay_text() -> None:
    evil = cd.Scene("</script><b>", gravity=(0, 0, -9.81))
    m = evil.parameter("m", 1.0, unit="kg")
    rod = evil.body("</script><img src=x>", mass=m, com=(0, 0, -0.5))
    evil.joint("a<b", cd.Revolute("y"), evil.ground, rod)
    evil.output("<i>", evil.q("a<b"))
    html = cd.page(evil, plots=["<i>", "a<b"]).html
    assert "<img" not in html
    assert "</script><b>" not in html


def test_inputs_are_sliders_too() -> None:
    cart = scene("cart_pole")
    live = data_of(cd.page(cart).html)["live"]
    inputs = [row for row in live["sliders"] if row["kind"] == "input"]
    assert [row["name"] for row in inputs] == list(cd.compile(cart).inputs)
    assert all(row["low"] < row["high"] for row in live["sliders"])


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"sliders": ["masss"]}, "'masss' is neither a parameter nor an input"),
        ({"sliders": {"m": (2.0, 1.0)}}, "'m': (2.0, 1.0) is not a range"),
        ({"sliders": {"m": (0.0, float("nan"))}}, "is not a range"),
        ({"sliders": {"m": "wide"}}, "is not a range"),
        ({"sliders": {"m": "12"}}, "is not a range"),
        ({"rtol": 0.0}, "rtol=0: give a positive number"),
        ({"rtol": -1e-6}, "rtol=-1e-06: give a positive number"),
        ({"plots": "elbou"}, "there is no history 'elbou'"),
        ({"traces": "hand"}, "'hand' is not a frame"),
        ({"page": "4d"}, "page='4d': there is no such page. Known: auto, 3d, plain"),
    ],
)
def test_what_cannot_be_is_refused_by_name(options: dict[str, Any], said: str) -> None:
    with pytest.raises(cd.ArgumentError, match=re.escape(said)):
        cd.page(scene("double_pendulum"), **options)


def test_a_range_holds_what_a_model_takes_alone() -> None:
    with pytest.raises(cd.ArgumentError, match=r"'crank\.mass' is a mass .* give another range"):
        cd.page(scene("four_bar"), sliders={"crank.mass": (-1.0, 1.0)})


def test_beams_are_recorded_instead() -> None:
    with pytest.raises(cd.ModelError, match="animate"):
        cd.page(scene("flexible_arm"))


def test_kernels_are_those_of_the_sources() -> None:
    """``make wasm`` compiles them anew."""
    assert json.loads(wasm_kernels.INDEX.read_text("utf-8"))["sources"] == build.digest()


@pytest.mark.slow
def test_kernels_are_compiled_to_the_same_bytes(tmp_path: Path) -> None:
    version = pytest.importorskip("importlib.metadata").version("ziglang")
    if f"ziglang {version}" != json.loads(wasm_kernels.INDEX.read_text("utf-8"))["compiler"]:
        pytest.skip("another version of ziglang")
    build.build(tmp_path)
    for path in tmp_path.iterdir():
        assert path.read_bytes() == (wasm_kernels.FOLDER / path.name).read_bytes(), path.name
