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
from cardan.view.page import text_of

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


def told(html: cd.view.page.Page | Any, program: str, folder: Path) -> Any:
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


START = {"double_pendulum": {"shoulder": 1.0}, "bouncing_ball": {}, "cart_pole": {"pole": 0.4}}
SCENES = ("double_pendulum", "four_bar", "bouncing_ball", "cart_pole", "bicycle", "quadrotor")


@needs_node
@pytest.mark.filterwarnings("ignore::cardan.errors.SolveWarning")
@pytest.mark.parametrize("name", SCENES)
def test_the_state_after_a_second_has_the_bits_of_a_native_build(name: str, tmp_path: Path) -> None:
    equations = cd.derive(scene(name))
    page = cd.page(equations, tmp_path / "first.html", q=START.get(name), rtol=1e-9)
    found = told(
        page,
        "const first = live.x.slice(); let status = 0;"
        "for (let k = 0; k < 60; k++) status ||= live.advance(1 / 60);"
        "const words = (x) => [...new Uint32Array(Float64Array.from(x).buffer)];"
        "console.log(JSON.stringify({ status, t: live.t, x: [...first], words: words(live.x) }));",
        tmp_path,
    )
    assert found["status"] == 0
    assert found["t"] == pytest.approx(1.0, abs=1e-12)
    here = np.array(found["words"], dtype=np.uint32).view(np.float64)
    live = data_of(page.html)["live"]
    tolerances = live["rtol"], live["atol"]
    native = live_native.library(equations, live["bodies"], tmp_path / "native")
    expected = live_native.run(native, found["x"], 1.0, *tolerances, 60)
    assert here.tobytes() == expected.tobytes()
    # and it is the motion that simulate computes
    motion = cd.compile(equations).simulate(1.0, x0=found["x"], rtol=1e-11, atol=1e-13)
    assert np.abs(here - motion.x[-1]).max() < 1e-6
