"""``generated/`` is what cardan writes today for the scenes of the examples, byte by byte.

``pytest tests/golden --accept`` writes it anew; the difference is then read in review.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from itertools import product
from pathlib import Path

import pytest

from cardan.build import toolchain
from cardan.schema import kernel_files
from golden.scenes import EXAMPLES, FLEXIBLE, ROOT, scene_of, written
from spread import some

KEPT = sorted(path for path in (ROOT / "generated").iterdir() if path.is_dir())


def files(directory: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in directory.iterdir() if path.is_file()}


@pytest.mark.parametrize("example", [*EXAMPLES, FLEXIBLE], ids=lambda path: path.name)
def test_generated_is_up_to_date(
    example: Path, tmp_path: Path, pytestconfig: pytest.Config
) -> None:
    made = written(example, tmp_path / "c")
    kept = ROOT / "generated" / scene_of(example).name
    if pytestconfig.getoption("--accept"):
        shutil.rmtree(kept, ignore_errors=True)
        shutil.copytree(made, kept)
    new, old = files(made), files(kept)
    assert set(new) == set(old)
    changed = [name for name in new if new[name] != old[name]]
    assert not changed, f"{changed} of {kept.name} changed: run pytest tests/golden --accept"


def test_hash_seed_does_not_change_a_byte(tmp_path: Path) -> None:
    program = (
        "import sys\n"
        "from pathlib import Path\n"
        "sys.path.insert(0, sys.argv[2])\n"
        "from golden.scenes import EXAMPLES, FLEXIBLE, written\n"
        "for example in (*EXAMPLES[::7], FLEXIBLE):\n"
        "    written(example, Path(sys.argv[1]) / example.stem)\n"
    )
    texts = []
    for seed in ("1", "2"):
        target = tmp_path / seed
        environment = {**os.environ, "PYTHONHASHSEED": seed}
        command = [sys.executable, "-c", program, str(target), str(ROOT / "tests")]
        subprocess.run(command, env=environment, check=True, timeout=240, capture_output=True)
        folders = sorted(target.iterdir())
        examples = (*EXAMPLES[::7], FLEXIBLE)
        assert [folder.name for folder in folders] == sorted(path.stem for path in examples)
        texts.append({folder.name: files(folder) for folder in folders})
    assert texts[0] == texts[1]


STRICT = ("-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror")


@pytest.mark.parametrize(("kept", "compiler"), some(product(KEPT, ("gcc", "clang")), 3), ids=str)
def test_generated_compiles_without_warning(kept: Path, compiler: str, tmp_path: Path) -> None:
    """Alone, without Python headers, under the flags of the house, by gcc and clang (ziglang)."""
    found = [*(toolchain.candidates() if compiler == "gcc" else toolchain.ziglang())]
    assert found, f"no {compiler} here: install the extra test"
    # gcc says some things only while it optimizes
    level = ["-O2"] if compiler == "gcc" else ["-O0", "-fno-sanitize=undefined"]
    command = [*found[0][0], *STRICT, *level, "-shared", "-fPIC", "-o", str(tmp_path / "all.so")]
    sources = sorted(str(path) for path in kept.glob("*.c"))
    command += [*(f"-I{folder}" for folder in kernel_files.includes()), *sources, "-lm"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
