"""``api.txt`` is every public name of cardan with its signature: none changes unseen.

``pytest tests/golden/test_api.py --accept`` writes it anew; the difference is then read in review.
"""

from __future__ import annotations

import os
import subprocess
import sys
from difflib import unified_diff
from pathlib import Path

import pytest

from golden.public import lines

LISTING = Path(__file__).parent / "api.txt"
ACCEPT = "pytest tests/golden/test_api.py --accept"


def difference(new: str, old: str) -> str:
    """What changed, as a patch of ``api.txt``; "" for nothing."""
    found = unified_diff(old.splitlines(), new.splitlines(), "api.txt", "cardan", lineterm="", n=0)
    return "\n".join(found)


def test_the_public_names_are_those_of_the_listing(pytestconfig: pytest.Config) -> None:
    new = "".join(f"{line}\n" for line in lines())
    if pytestconfig.getoption("--accept"):
        LISTING.write_text(new, "utf-8")
        return
    changed = difference(new, LISTING.read_text("utf-8"))
    assert not changed, f"public names changed; where that is meant, {ACCEPT}\n{changed}"


def test_a_difference_names_what_changed() -> None:
    old = "cardan.load(path: str)\ncardan.t: Atom\n"
    told = difference(old.replace("path", "file"), old).splitlines()
    assert told[-2:] == ["-cardan.load(path: str)", "+cardan.load(file: str)"]


@pytest.mark.slow
def test_the_hash_seed_does_not_change_the_listing() -> None:
    program = (
        "import sys; sys.path.insert(0, sys.argv[1])\n"
        "from golden.public import lines; print('\\n'.join(lines()))"
    )
    command = [sys.executable, "-c", program, str(Path(__file__).parents[1])]
    texts = {
        subprocess.run(
            command, env={**os.environ, "PYTHONHASHSEED": seed}, capture_output=True, check=True
        ).stdout
        for seed in ("1", "2")
    }
    assert texts == {LISTING.read_bytes()}
