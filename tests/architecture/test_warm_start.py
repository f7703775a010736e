"""What a process loads and compiles that uses a scene which was compiled before.

Counts, which are the same everywhere; ``tests/benchmarks/starts.py`` measures times.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

SCENE = """
cardan: 2
name: arm
bodies:
  upper: {mass: 1, com: [0, 0, -0.25], inertia: {rod: {mass: 1, length: 0.5, axis: z}}}
  lower: {mass: 1, com: [0, 0, -0.25], inertia: {rod: {mass: 1, length: 0.5, axis: z}}}
joints:
  shoulder: {type: revolute, axis: y, parent: ground, child: upper}
  elbow: {type: revolute, axis: y, parent: {body: upper, at: [0, 0, -0.5]}, child: lower}
simulate: {time: 0.1}
"""
# texts that Python compiles while it runs are methods of records
PROGRAM = """
import json, sys
texts = []
def note(event, arguments):
    if event == "compile" and arguments[1] == "<string>":
        texts.append(arguments)
sys.addaudithook(note)
{work}
print("loaded:", json.dumps([[*sys.modules], len(texts)]))
"""
CALL = "import cardan as cd; cd.compile(cd.load(sys.argv[1])).forward_dynamics([1, 0], [0, 0])"
COMMAND = "from cardan.cli import main; sys.argv[1:1] = ['simulate']; assert not main()"
NEVER = ("sympy", "mpmath", "scipy", "matplotlib", "logging", "importlib.metadata")
DERIVING = ("pipeline", "topology", "equations", "passes", "codegen")


def loaded(work: str, scene: Path, cache: Path) -> tuple[set[str], int]:
    """Modules and number of texts of the second of two processes."""
    command = [sys.executable, "-c", PROGRAM.replace("{work}", work), str(scene)]
    environment = {**os.environ, "CARDAN_CACHE": str(cache)}
    for _ in range(2):
        done = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
        assert done.returncode == 0, done.stderr
    names, texts = json.loads(done.stdout.rpartition("loaded:")[2])
    return set(names), int(texts)


@pytest.mark.parametrize(
    ("work", "allowed", "most_modules", "most_texts"),
    [(CALL, (), 352, 460), (COMMAND, ("logging",), 483, 650)],
    ids=["call", "command"],
)
def test_a_scene_that_was_compiled_before(
    work: str, allowed: tuple[str, ...], most_modules: int, most_texts: int, tmp_path: Path
) -> None:
    scene = tmp_path / "arm.yaml"
    scene.write_text(SCENE)
    names, texts = loaded(work, scene, tmp_path / "cache")
    assert not names & {*NEVER} - {*allowed}
    ours = {name for name in names if name.partition(".")[0] == "cardan"}
    assert not {name for name in ours if name.split(".")[1:2] and name.split(".")[1] in DERIVING}
    assert len(ours) <= most_modules
    assert texts <= most_texts
