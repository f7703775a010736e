"""What is measured on which mechanism."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import cardan as cd
from mechanisms.chain import chain, full_chain
from mechanisms.closed import CLOSED
from mechanisms.robots import STANDARD

FORWARD, INVERSE, MASS, DERIVATIVES = (
    "forward_dynamics", "inverse_dynamics", "mass_matrix", "derivatives",
)  # fmt: skip
BICYCLE = Path(__file__).parents[2] / "src" / "cardan" / "scenes" / "bicycle.yaml"
ALL = (FORWARD, INVERSE, MASS, DERIVATIVES)


@dataclass(frozen=True)
class Case:
    """A mechanism and the functions compared on it.

    Attributes:
        name: Short.
        title: As tables call it.
        build: Makes the scene.
        functions: Of ``ALL``.
        loops: As :func:`cardan.compile` takes it.
        quick: Whether ``QUICK=1`` keeps it.
        size: Bodies of a chain, for the picture of cost against size.
        closed: It has loops: it stands in a table of its own.
    """

    name: str
    title: str
    build: Callable[[], cd.Scene]
    functions: tuple[str, ...]
    loops: bool | None = None
    quick: bool = False
    size: int | None = None
    closed: bool = False


def _standard(name: str, functions: tuple[str, ...], quick: bool = False) -> Case:
    found = STANDARD[name]
    size = int(name.removeprefix("chain")) if name.startswith("chain") else None
    return Case(name, found.title, found.build, functions, None, quick, size)


def _closed(name: str, title: str, quick: bool = False) -> Case:
    return Case(name, title, CLOSED[name].build, (FORWARD,), None, quick, None, True)


CASES = (
    _standard("panda", ALL, quick=True),
    _standard("ur5", ALL, quick=True),
    _standard("puma560", (FORWARD, INVERSE)),
    _standard("anymal", (FORWARD, INVERSE, MASS), quick=True),
    _standard("talos", ALL),
    _standard("icub", (FORWARD, INVERSE)),
    _standard("g1", (FORWARD, INVERSE)),
    Case("chain5", "chain of 5", lambda: chain(5), (FORWARD,), quick=True, size=5),
    _standard("chain7", ALL),
    _standard("chain14", (FORWARD, INVERSE)),
    _standard("chain30", ALL, quick=True),
    _standard("chain100", ALL),
    Case("full30", "chain of 30, full inertias", lambda: full_chain(30), (FORWARD,)),
    Case("full100", "chain of 100, full inertias", lambda: full_chain(100), (FORWARD,)),
    Case("chain100_straight", "chain of 100, no loops", lambda: chain(100), (FORWARD,), False),
    _standard("pendulum10", (FORWARD,)),
    _standard("pendulum100", (FORWARD,)),
    _closed("four_bar", "four-bar", quick=True),
    _closed("slider_crank", "slider-crank"),
    _closed("andrews", "squeezer of Andrews"),
    _closed("bricard", "Bricard's mechanism"),
    _closed("stewart", "Stewart platform, 6-UPS", quick=True),
    _closed("delta", "Delta robot"),
    Case("bicycle", "bicycle", lambda: cd.load(BICYCLE), (FORWARD,), closed=True),
)
# chains too long for anybody else here: bodies and the seconds they may take
LONG = {1_000: 120, 10_000: 120, 100_000: 400}
