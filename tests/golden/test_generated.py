"""``generated/`` is what cardan writes today for the scenes of the examples, byte by byte.

``pytest tests/golden --accept`` writes it anew; the difference is then read in review.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

import cardan as cd
from cardan.runtime import toolchain
from golden.scenes import EXAMPLES, FUNCTIONS, ROOT, scene_of

KEPT = sorted(path for path in (ROOT / "generated").iterdir() if path.is_dir())


def written(directory: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in directory.iterdir() if path.is_file()}


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.name)
def test_generated_is_up_to_date(
    example: Path, tmp_path: Path, pytestconfig: pytest.Config
) -> None:
    scene = scene_of(example)
    made = cd.derive(scene).export(tmp_path / "c", functions=FUNCTIONS)
    kept = ROOT / "generated" / scene.name
    if pytestconfig.getoption("--accept"):
        cd.derive(scene).export(kept, functions=FUNCTIONS)
    new, old = written(made), written(kept)
    assert set(new) == set(old)
    changed = [name for name in new if new[name] != old[name]]
    assert not changed, f"{changed} of {kept.name} changed: run pytest tests/golden --accept"


def test_hash_seed_does_not_change_a_byte(tmp_path: Path) -> None:
    program = (
        "import sys, cardan as cd\n"
        "sys.path.insert(0, sys.argv[2])\n"
        "from golden.scenes import EXAMPLES, FUNCTIONS, scene_of\n"
        "for example in EXAMPLES[::3]:\n"
        "    folder = f'{sys.argv[1]}/{example.stem}'\n"
        "    cd.derive(scene_of(example)).export(folder, functions=FUNCTIONS)\n"
    )
    texts = []
    for seed in ("1", "2"):
        target = tmp_path / seed
        environment = {**os.environ, "PYTHONHASHSEED": seed}
        command = [sys.executable, "-c", program, str(target), str(ROOT / "tests")]
        subprocess.run(command, env=environment, check=True, timeout=240, capture_output=True)
        folders = sorted(target.iterdir())
        assert [folder.name for folder in folders] == sorted(path.stem for path in EXAMPLES[::3])
        texts.append({folder.name: written(folder) for folder in folders})
    assert texts[0] == texts[1]


STRICT = ("-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror")


@pytest.mark.parametrize("compiler", ["gcc", "clang"])
@pytest.mark.parametrize("kept", KEPT, ids=lambda path: path.name)
def test_generated_compiles_without_warning(kept: Path, compiler: str, tmp_path: Path) -> None:
    """Alone, without Python headers, under the flags of the house, by gcc and clang (ziglang)."""
    found = toolchain.candidates() if compiler == "gcc" else toolchain.ziglang()
    assert found, f"no {compiler} here: install the extra test"
    # gcc says some things only while it optimizes
    level = ["-O2"] if compiler == "gcc" else ["-O0", "-fno-sanitize=undefined"]
    command = [*found[0][0], *STRICT, *level, "-shared", "-fPIC", "-o", str(tmp_path / "all.so")]
    sources = sorted(str(path) for path in kept.glob("*.c"))
    command += [*sources, "-lm"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
