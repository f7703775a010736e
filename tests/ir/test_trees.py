"""Assemblies: saved and read, damaged tables refused, operations counted as they are done."""

from __future__ import annotations

import copy
import json
from typing import Any

import pytest

import cardan as cd
from cardan.ir.function import count, live
from cardan.ir.graph import Graph
from cardan.ir.serialize import from_dict, to_dict
from cardan.ir.trees.assembly import Assembly
from cardan.ir.trees.kernels import KERNELS
from mechanisms.chain import chain
from table import each

REQUEST = "inverse_dynamics: q u udot"


def forked() -> cd.Scene:
    """A chain with a branch, so that paths are not all in one row."""
    scene = chain(6)
    twig = scene.body("twig", mass=1.0, com=(0.1, 0.2, 0.3), inertia=(0.1, 0.2, 0.2))
    scene.joint("fork", cd.Universal(), scene.bodies["rod1"], twig)
    scene.joint("tip", cd.Revolute("x"), twig, scene.body("leaf", mass=1.0, inertia=(1, 1, 1)))
    return scene


def assembly(function: str = "derivative", of: str | None = REQUEST) -> Assembly:
    form = cd.derive(forked()).form(function, of, loops=True)
    assert isinstance(form, Assembly)
    return form


def test_saved() -> None:
    for form in (assembly(), assembly("mass_matrix", None)):
        saved = json.loads(json.dumps(to_dict(form)))
        assert to_dict(from_dict(saved)) == to_dict(form.straight())


def damaged() -> dict[str, tuple[dict[str, Any], str]]:
    """Saved assemblies that name what is not there, and what is said of them."""
    whole = json.loads(json.dumps(to_dict(assembly())))
    found: dict[str, tuple[dict[str, Any], str]] = {}

    def damage(name: str, text: str) -> Any:
        found[name] = (copy.deepcopy(whole), text)
        return found[name][0]

    damage("kernel", "names a kernel")["kernel"] = "tree_mess"
    damage("tree", "needs a table")["tree"] = []
    damage("rows", "needs the rows 'speeds'")["tree"]["speeds"] = None
    damage("row", "5 whole numbers")["tree"]["bodies"][1] = [0, 1]
    damage("parent", "body 1")["tree"]["bodies"][1][0] = 1
    damage("numbers", "body 2")["tree"]["bodies"][2][3] = 10**6
    damage("modes", "body 2")["tree"]["bodies"][2][4] = 10**6
    damage("count", "body 2")["tree"]["bodies"][1][2] = 3
    damage("slot", "slots of u")["tree"]["speeds"][0][0] = 1
    damage("level", "speed 3")["tree"]["speeds"][3][1] = 0
    damage("before", "speed 6")["tree"]["speeds"][6][3] = 7
    damage("columns", "'columns'")["tree"]["columns"] = -1
    damage("first", "columns that are not there")["tree"]["outputs"][0][2] = 1000
    damage("some columns", "columns that are not there")["tree"]["outputs"][0][1] = 8
    damage("size", "results")["tree"]["outputs"].pop()
    damage("change", "adds a number")["tree"]["changes"] = [[0, 0, 10**6]]
    damage("gap", "column that is not there")["tree"]["changes"] = [[0, 9, 0]]
    damage("rotor", "ties joints together")["tree"]["rotors"] = [[3, 1, 0]]
    damage("parts", "saved function has")["parts"] = None
    return found


@each("name", damaged())
def test_damaged_ones_are_refused(name: str) -> None:
    data, text = damaged()[name]
    with pytest.raises(ValueError, match=text):
        from_dict(data)


@pytest.mark.parametrize("function", ["mass_matrix", "derivative"])
def test_counts(function: str) -> None:
    """A kernel takes what its expressions take, where no number is known, and more what they share:

    derivatives go over the momenta of unit speeds for M and for the right sides.
    """
    form = assembly(function, REQUEST if function == "derivative" else None)
    g, kernel = Graph(), KERNELS[form.kernel]
    numbers = [g.var("p", k) for k in range(form.parts.outputs[0].size)]
    nodes = kernel.expressions(g, numbers, form.tree)
    operators = count(g, live(g, nodes))
    twice = len(form.tree.speeds) if function == "derivative" else 0
    again = form.counts["mul"] - operators["mul"]
    assert 24 * twice <= again <= 40 * twice
    assert 0 <= form.counts["add"] - operators["add"] - operators["sub"] <= 60 * twice
