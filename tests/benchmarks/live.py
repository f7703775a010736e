"""Pages in which models run: their sizes, their speed in node beside compiled C, and their bits.

Writes docs/performance/live.md, or nothing with ``--quick``.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

import cardan as cd
from benchmarks.provenance import signed
from cardan.view.packing import text_of
from mechanisms import robots
from view.test_live import LOAD, NODE

PAGE = Path(__file__).resolve().parents[2] / "docs" / "performance" / "live.md"
SECONDS, FRAMES = 10, 60
TEXT = """# Pages in which models run

Written by `tests/benchmarks/live.py`, node {node}. Ten seconds of motion at rtol 1e-6 in frames of
a sixtieth of a second, each of which starts the integrator anew; compiled C runs them in one piece.
A frame with a hand pulls a body: it takes the mass that is felt, the generalized forces, the step
and the places of all bodies.

"""
RUN = f"""
const frames = {SECONDS * FRAMES}, best = {{ run: Infinity, frame: Infinity }};
let status = 0, x;
for (let round = 0; round < 5; round++) {{
  live.start();
  let before = performance.now();
  for (let k = 0; k < frames && status === 0; k++) status = live.advance(1 / {FRAMES});
  best.run = Math.min(best.run, performance.now() - before);
  x ??= [...live.x];
  // a frame with a hand: the mass that it feels, the pull, a step, and where everything is
  live.start();
  before = performance.now();
  for (let k = 0; k < frames && status === 0; k++) {{
    const point = live.frames().slice(9, 12);
    const mass = live.felt(0, point, [0, 0, 1]);
    live.pull(0, point, [0, 0, Number.isFinite(mass) ? mass : 0]);
    status = live.advance(1 / {FRAMES});
    live.frames();
  }}
  best.frame = Math.min(best.frame, (performance.now() - before) / frames);
}}
console.log(JSON.stringify({{ status, x, ...best }}));
"""


def panda() -> cd.Scene:
    """The Franka Emika Panda with its meshes."""
    folder = robots.folder()
    file = folder / "panda_description" / "urdf" / "panda.urdf"
    return cd.load(file, packages=folder.parent)


SCENES = {
    "double pendulum": (lambda: cd.load(cd.examples.path("double_pendulum")), {"shoulder": 1.0}),
    "four-bar": (lambda: cd.load(cd.examples.path("four_bar")), {"A": 0.6}),
    "Panda with meshes": (panda, None),
}


def measured(name: str, folder: Path) -> list[str]:
    """A row of the table."""
    make, start = SCENES[name]
    equations = cd.derive(make())
    file = folder / "page.html"
    cd.page(equations, file, q=start)
    script = folder / "run.js"
    script.write_text(text_of("live.js") + LOAD + RUN, "utf-8")
    answer = subprocess.run([str(NODE), script, file], capture_output=True, text=True, check=True)
    found = json.loads(answer.stdout)
    model, best = cd.compile(equations), np.inf
    for _ in range(5):
        before = time.perf_counter()
        motion = model.simulate(float(SECONDS), q=start, method="DOP853", rtol=1e-6, atol=1e-9)
        best = min(best, time.perf_counter() - before)
    exact = model.simulate(1.0, q=start, method="DOP853", rtol=1e-12, atol=1e-14)
    coarse = model.simulate(1.0, q=start, method="DOP853", rtol=1e-6, atol=1e-9)
    error = np.abs(coarse.x[-1] - exact.x[-1]).max()
    assert motion.success
    return [
        name,
        f"{file.stat().st_size / 1e3:.0f}",
        f"{1e3 * SECONDS / found['run']:.0f}",
        f"{SECONDS / best:.0f}",
        f"{found['frame']:.2f}",
        f"{error:.0e}",
    ]


def main() -> None:
    """Measure, print, write the page."""
    names = list(SCENES)[:2] if "--quick" in sys.argv else list(SCENES)
    head = ["scene", "page [KB]", "node, times real time", "compiled C", "frame with a hand [ms]",
            "error after 1 s"]  # fmt: skip
    with tempfile.TemporaryDirectory() as folder:
        rows = [measured(name, Path(folder)) for name in names]
    table = [head, ["---"] * len(head), *rows]
    text = "\n".join(f"| {' | '.join(row)} |" for row in table) + "\n"
    print(text)
    if "--quick" not in sys.argv:
        version = subprocess.run([str(NODE), "--version"], capture_output=True, text=True).stdout
        PAGE.write_text(signed(TEXT.format(node=version.strip()) + text), "utf-8")


if __name__ == "__main__":
    main()
