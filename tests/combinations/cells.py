"""What goes with what: every feature beside every other, every integrator and every use, tried."""

from __future__ import annotations

import tempfile
import warnings
from collections.abc import Callable, Collection, Iterator
from functools import partial
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np

import cardan as cd
from cardan.errors import CardanError
from cardan.schema.integrators import INTEGRATORS

from .features import PRESENT, closed, mechanism
from .routes import Route, route

# long enough for a step of each method
SHORT, STEP = 2e-3, 1e-3
RIGID, ELASTIC = "rigid", "beam"
Cell = tuple[str, str, str]


def _equilibrium(side: Route, folder: Path) -> object:
    return side.model.equilibrium(u={})


def _linearize(side: Route, folder: Path) -> object:
    return side.model.linearize(side.model.initial())


def _ensemble(side: Route, folder: Path) -> object:
    inputs = side.made.inputs or None
    return side.model.ensemble(SHORT, u={"shoulder": np.array([0.0, 0.1])}, inputs=inputs)


def _checkpoint(side: Route, folder: Path) -> object:
    stepper = side.model.stepper(inputs=dict.fromkeys(side.made.inputs, 1.0) or None)
    stepper.step(SHORT)
    stepper.save(folder / "run.npz")
    return side.model.resume(folder / "run.npz")


def _export(side: Route, folder: Path) -> object:
    equations = cd.derive(side.made.scene)
    return equations.export(folder / "c", language="c", integrators=["dop853"])


def _save(side: Route, folder: Path) -> object:
    side.run(t=SHORT).save(folder / "run.nc")
    return cd.load_motion(folder / "run.nc")


USES: dict[str, Callable[[Route, Path], object]] = {
    "equilibrium": _equilibrium,
    "linearize": _linearize,
    "ensemble": _ensemble,
    "checkpoint": _checkpoint,
    "export": _export,
    "save": _save,
}


def message_of(act: Callable[[], object]) -> str:
    """What is said where something is refused; "" where it is not."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            act()
        except CardanError as problem:
            return " ".join(str(problem).split())
    return ""


def pairs(names: Collection[str]) -> Iterator[Cell]:
    """Two features, one of which has one of the names, and what is said where both are refused."""
    for pair in combinations(PRESENT, 2):
        if {*pair} & {*names}:
            yield *pair, message_of(partial(_derived, pair))


def _derived(names: tuple[str, ...]) -> object:
    return cd.derive(mechanism(names).scene)


def of_feature(name: str, kind: str) -> Iterator[Cell]:
    """Integrators and uses with a feature, in a rigid scene or in one with a beam."""
    names = closed((name,) if kind == RIGID else (name, "beam"))
    said = message_of(partial(route, names))
    if said:
        yield from ((name, asked, said) for asked in (*INTEGRATORS, *USES))
        return
    side = route(names)

    def run(method: str) -> object:
        steps: dict[str, Any] = {} if INTEGRATORS[method].adaptive else {"step": STEP}
        inputs = side.made.inputs or None
        return side.model.simulate(SHORT, method=method, inputs=inputs, **steps)

    for method in INTEGRATORS:
        yield name, method, message_of(partial(run, method))
    for use, act in USES.items():
        with tempfile.TemporaryDirectory() as folder:
            yield name, use, message_of(partial(act, side, Path(folder)))
