"""What it takes to prepare many bodies: work for each, and steps that do not grow with them."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from types import FrameType

import cardan as cd
from cardan.codegen import generate
from equations.test_representatives import rope
from table import each

# Python calls for each further link of a rope; they may only fall
ABSOLUTE, RELATIVE = 18_900, 1500
FEW, MORE, MOST = 64, 128, 192
# functions of a rope that are derived from a few links
FOLDED = ("rhs", "energy", "com", "momentum")


def calls(action: Callable[[], object]) -> int:
    """Number of Python calls that something takes."""
    count = 0

    def note(frame: FrameType, event: str, argument: object) -> None:
        nonlocal count
        count += event == "call"

    before = sys.getprofile()
    sys.setprofile(note)
    try:
        action()
    finally:
        sys.setprofile(before)
    return count


def absolute(n: int, folder: Path) -> None:
    """Derive a rope with nodes, and write it."""
    cd.compile(cd.derive(rope(n), "absolute"), directory=folder / str(n))


def relative(n: int, folder: Path) -> None:
    """Derive a rope in joint coordinates, with the C of what a run calls."""
    equations = cd.derive(rope(n), method="articulated")
    for name in FOLDED:
        generate(equations.form(name), model="rope")


@each("kind, most", [(absolute, ABSOLUTE), (relative, RELATIVE)])
def test_every_body_takes_the_same_work(
    kind: Callable[[int, Path], None], most: int, tmp_path: Path
) -> None:
    # what is imported and cached for the first scene is no work of its links
    kind(FEW, tmp_path / "first")
    few, more, many = (calls(lambda n=n: kind(n, tmp_path)) for n in (FEW, MORE, MOST))
    first, second = more - few, many - more
    assert second < 1.02 * first, f"calls per link grow: {first}, then {second}"
    assert second <= most * (MOST - MORE), f"{second / (MOST - MORE):.0f} calls for a link"


@each("name", FOLDED)
def test_the_steps_of_sums_do_not_grow(name: str) -> None:
    # sines of 32 angles at a time, and of what is left in another step: here nothing is
    short, long = (cd.derive(rope(n), method="articulated").recursion(name) for n in (128, 256))
    assert len(short.steps) == len(long.steps)
    sizes = [[sum(step.operations().values()) for step in one.steps] for one in (short, long)]
    assert sizes[0] == sizes[1]
    assert [len(s.parts) for s in short.sweeps] == [len(s.parts) for s in long.sweeps]
