"""What the energies of whole motions change by over the zoo, against differences of motions.

They depend on all of the state, on every mass and on most other parameters directly: a wrong term
of the chain rule shows. Motions and bounds are those of the gradients.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import cardan as cd
from laws import event_scenes
from laws.cases import compiled, states
from laws.circuits import EVERY
from laws.test_energy import BENT
from laws.test_gradients import CRANK, CRUDE, SPEEDS, SPREAD, Array, Run, closed_run, difference
from mechanisms import ZOO
from spread import some

NAMES = ("kinetic energy", "potential energy")


def slopes(run: Run) -> dict[str, Array]:
    """Derivatives (2, ...) of both energies at the end by what they are by."""
    wrt = ("x0", *run.few, *run.tables)
    motion = run.model.simulate(run.t, sensitivity=wrt, **run.start(run.x0), **run.how)
    both = [motion.sensitivity.of(name) for name in NAMES]
    return {name: np.stack([one[name][-1] for one in both]) for name in wrt}


def judge(run: Run, allowed: float, exact: bool | None = None) -> None:
    """Derivatives of energies, and differences of runs to eighth order."""
    if exact is None:
        exact = not any(name.endswith(".qw") for name in run.model.coordinates)
    run = replace(run, parameters=run.few)
    found = slopes(run)
    half = found if exact else slopes(replace(run, step=run.step / 2))
    for name in ("x0", *["p"] * bool(run.parameters), *run.tables):
        by, by_half = (
            np.stack([one[x] for x in run.parameters], axis=-1) if name == "p" else one[name]
            for one in (found, half)
        )
        way = run.direction(name)

        def energies(by: float, name: str = name, way: Array = way) -> Array:
            arguments = {**run.start(run.x0), **run.how, **run.changed(name, by * way)}
            energy = run.model.simulate(run.t, **arguments).energy
            return np.array([energy.kinetic[-1], energy.potential[-1]])

        expected = [difference(lambda by, k=k: energies(by)[k]) for k in range(2)]
        size = max(1.0, float((np.abs(by) @ np.abs(way)).max()))
        bound = allowed * size + 2 * float((np.abs(by_half - by) @ np.abs(way)).max())
        assert bound <= CRUDE * size, f"{name}: give shorter steps"
        np.testing.assert_allclose(by @ way, expected, rtol=0, atol=bound, err_msg=name)


@pytest.mark.parametrize("name", some(ZOO, SPREAD, 3))
def test_trees(name: str) -> None:
    (q, u), kinks = states(name), name in BENT
    t, step = (0.1, 1e-3) if kinks else (0.4, 0.01)
    run = Run(compiled(name), np.concatenate([q[0], u[-1]]), t, step)
    judge(run, 1e-9, exact=False if kinks else None)


@pytest.mark.parametrize("name", some(EVERY, SPREAD))
def test_loops(name: str) -> None:
    judge(closed_run(name), 1e-8)


@pytest.mark.parametrize("name", some([x for x in event_scenes.SCENES if x != "bouncing"], 5, 1))
def test_events(name: str) -> None:
    scene, q = event_scenes.SCENES[name]()
    model = cd.compile(scene)
    x0 = model.initial(q=q, u=SPEEDS.get(name, {}))
    crank = ((model.coordinates.index("A"), model.speeds.index("A.u")),) if name in CRANK else None
    judge(Run(model, x0, 1.0, 1e-3, crank), 1e-7, exact=False)
