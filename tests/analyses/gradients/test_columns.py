"""Changes forward by few columns and by many, which go two ways, against sweeps backward."""

from __future__ import annotations

from typing import Any

import numpy as np

import cardan as cd
from analyses.gradients.test_elements import model_of
from analyses.gradients.test_gradients import TIGHT, double_pendulum
from analyses.gradients.test_implicit import four_bar
from table import each

TREE: dict[str, Any] = {"t": 1.0, "q": {"a": 1.0, "b": 0.5}, "u": {"a": 0.2}, **TIGHT}
LOOP: dict[str, Any] = {"t": 0.1, "q": {"A": 0.7}, "u": {"A": 3.0}, "rtol": 1e-7}
BEAM: dict[str, Any] = {"t": 0.02, "u": {"hinge": 1.0}, "rtol": 1e-6}
# along one column, two, a vector of them and more than one
GROUPS = {
    "tree": [("m2",), ("m2", "q0.b"), ("p",), ("x0", "p")],
    "loop": [("u0.A",), ("crank.mass", "gravity.y"), ("u0.A", "crank.mass", "gravity.y")],
    "beam": [("E",), ("E", "rho", "m"), ("E", "p", "u0.hinge")],
}


def of(scene: str) -> tuple[cd.CompiledModel, dict[str, Any]]:
    if scene == "tree":
        return double_pendulum(), TREE
    if scene == "loop":
        return four_bar(), LOOP
    return model_of("absolute"), BEAM


@each(
    "scene, method",
    [("tree", "DOP853"), ("tree", "Radau"), ("loop", "DOP853"), ("loop", "Radau"),
     ("beam", "Radau")],
)  # fmt: skip
def test_few_and_many_columns_are_those_of_the_sweep_backward(scene: str, method: str) -> None:
    model, how = of(scene)
    how, entry = {**how, "method": method}, 1
    last = model.coordinates[entry]
    groups = GROUPS[scene]
    every = tuple(dict.fromkeys(name for group in groups for name in group))
    backward = model.gradient(cost=cd.cost(final=last), wrt=every, **how)
    for names in groups:
        forward = model.simulate(sensitivity=names, **how).sensitivity
        for name in names:
            np.testing.assert_allclose(
                np.asarray(forward[name])[-1, entry], backward.slope[name],
                rtol=1e-8, atol=1e-9 * np.abs(backward.slope[name]).max(),
                err_msg=f"{scene}, {method}: {name} of {names}",
            )  # fmt: skip
