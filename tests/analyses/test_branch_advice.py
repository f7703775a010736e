"""Messages about starts of loops name lines that choose a position, and these lines work."""

from __future__ import annotations

import re
import warnings
from dataclasses import replace

import numpy as np
import pytest

import cardan as cd
from mechanisms.closed_planar import four_bar

UP = 0.895664793857865  # angle of B with the crank at 0, by the law of cosines


def driven() -> cd.CompiledModel:
    """The four-bar with a crank that turns as prescribed, from 0."""
    scene = four_bar()
    scene.joints["A"] = replace(scene.joints["A"], prescribed=9 * cd.t)
    return cd.compile(scene)


def pasted(message: str, model: cd.CompiledModel) -> np.ndarray:
    """The start that the line of a message gives, without a warning."""
    line = re.search(r"q=(model\.assemble\(.*?\)\.q)", message)
    assert line, message
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        q = eval(line[1], {"model": model})
        return model.split(model.initial(dict(zip(model.coordinates, q, strict=True))))[0]


def test_a_tie_names_a_line_that_chooses() -> None:
    model = cd.compile(four_bar())
    with pytest.warns(cd.SolveWarning, match="equally near") as told:
        x = model.initial({"A": 0.0})
    assert pasted(str(told[0].message), model) == pytest.approx(model.split(x)[0], abs=1e-9)
    assert model.split(x)[0][1] == pytest.approx(UP, abs=1e-9)


def test_a_tie_of_a_free_mechanism_names_a_coordinate() -> None:
    model = cd.compile(four_bar())
    with pytest.warns(cd.SolveWarning, match="equally near") as told:
        x = model.initial()
    line = re.search(r"such as q=(\{.*\})", str(told[0].message))
    assert line
    assert model.initial(eval(line[1])) == pytest.approx(x, abs=1e-5)


@pytest.mark.parametrize("value", [0.9, -0.9])
def test_a_rough_value_is_shown_as_a_guess(value: float) -> None:
    """A value rounded to one digit was refused with no word of what to do with it."""
    model = cd.compile(four_bar())
    with pytest.raises(cd.ModelError, match=r"Named values must fit to 1e-4.* q0=-?0\.9\)") as told:
        model.initial({"A": 0.0, "B": value})
    assert pasted(str(told.value), model)[1] == pytest.approx(np.copysign(UP, value), abs=1e-9)


def test_a_rough_value_beside_a_prescribed_crank() -> None:
    model = driven()
    with pytest.raises(cd.ModelError, match=r"'D'.* out of reach") as told:
        model.initial({"D": 1.8})
    assert pasted(str(told.value), model)[0] == pytest.approx(UP, abs=1e-9)
    with pytest.raises(cd.ModelError, match="Leave it out: its motion gives its value") as told:
        model.initial({"A": 0.0, "B": 0.9})
    assert pasted(str(told.value), model)[0] == pytest.approx(UP, abs=1e-9)


def test_absolute_coordinates_are_told_the_fitting_value() -> None:
    model = cd.compile(four_bar(), coordinates="absolute")
    with pytest.raises(cd.ModelError, match="the fitting value") as told:
        model.initial({"A": 0.0, "B": 0.9})
    line = re.search(r"q=(\{.*?\})", str(told.value))
    assert line
    at = model.coordinates.index("B")
    assert model.initial(eval(line[1]))[at] == pytest.approx(UP, abs=1e-5)


def test_a_guess_with_the_joint_chooses() -> None:
    scene = four_bar()
    scene.joints["B"] = replace(scene.joints["B"], q0=(-0.9,))
    assert cd.compile(scene).initial({"A": 0.0})[1] == pytest.approx(-UP, abs=1e-9)


def test_values_far_from_any_position_are_no_guess() -> None:
    """Where freedoms are left, the nearest value that is reached says more."""
    model = cd.compile(four_bar())
    with pytest.raises(cd.ModelError, match="out of reach") as told:
        model.initial({"D": 0.5})
    assert "guess" not in str(told.value)


def test_a_start_given_twice_names_the_blocks() -> None:
    model = cd.compile(four_bar())
    found = model.assemble({"A": 0.0}, branch={"B": "+"})
    with pytest.raises(cd.ModelError, match=r"by u= besides x0=.*q=result\.q, u="):
        model.simulate(0.1, x0=found.x, u={"A": 9.0})
    motion = model.simulate(0.1, q=found.q, u={"A": 9.0})
    assert motion["A.u"][0] == 9.0
