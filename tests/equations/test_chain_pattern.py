"""The formulas of a chain of equal links are its equations of motion."""

from __future__ import annotations

import ast
from math import cos, sin
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.equations.reading.chain_pattern import PATTERN, chain_pattern

M, LENGTH, COM, INERTIA, G = 1.3, 0.7, 0.3, 0.2, (0.4, -9.81)
# sums over six links
ROUNDING = 1e-12


def _chain(n: int, axis: str = "z", **first: Any) -> cd.Scene:
    scene = cd.Scene("chain", gravity=(*G, 0.0))
    mass, length = scene.parameter("m", M), scene.parameter("ell", LENGTH)
    parent: Any = scene.ground
    for i in range(n):
        data = {"mass": mass} | (first if i == 0 else {})
        link = scene.body(f"link{i}", com=(COM, 0, 0), inertia=(0, 0, INERTIA), **data)
        scene.joint(f"q{i}", cd.Revolute(axis), parent, link)
        parent = link.at(length, 0, 0)
    return scene


class _Indexed(ast.NodeTransformer):
    """``phi_i`` becomes an entry, ``total`` a sum."""

    def visit_Name(self, node: ast.Name) -> ast.expr:
        head, _, index = node.id.rpartition("_")
        if not head or not set(index) <= set("ijk"):
            return node
        return ast.parse(f"{head}[{','.join(index)}]", mode="eval").body

    def visit_Call(self, node: ast.Call) -> ast.expr:
        self.generic_visit(node)
        if ast.unparse(node.func) != "total":
            return node
        j, first, last, what = map(ast.unparse, node.args)
        text = f"sum({what} for {j} in range({first}, {last} + 1))"
        return ast.parse(text, mode="eval").body


@pytest.mark.parametrize("n", [3, 6])
def test_pattern(n: int) -> None:
    """Evaluated index by index, against the compiled inverse dynamics."""
    lines = chain_pattern(cd.derive(_chain(n)).system)
    assert lines[-len(PATTERN) :] == PATTERN
    rng = np.random.default_rng(n)
    q, u, udot = rng.normal(size=(3, n))
    values: dict[str, Any] = {
        **{"n": n, "m": M, "ell": LENGTH, "g_1": G[0], "g_2": G[1], "cos": cos, "sin": sin},
        **{"com_x": COM, "inertia_zz": INERTIA},
        **{"q": dict(enumerate(q, 1)), "max": max, "sum": sum, "range": range},
        "phidot": dict(enumerate(np.cumsum(u), 1)),
        "phiddot": dict(enumerate(np.cumsum(udot), 1)),
    }
    for _, line in lines:
        left, _, right = line.partition(" = ")
        code = ast.unparse(_Indexed().visit(ast.parse(right, mode="eval")))
        head, _, index = left.rpartition("_")
        if not head:
            values[left] = eval(code, values)
            continue
        places = np.ndindex(*[n] * len(index))
        entries = {tuple(k + 1 for k in place): place for place in places}
        values[head] = {
            (at if len(at) > 1 else at[0]): eval(code, values | dict(zip(index, at, strict=True)))
            for at in entries
        }
    shown = np.array([values["r"][k] for k in range(1, n + 1)])
    tau = cd.compile(_chain(n)).inverse_dynamics(q, u, udot)
    assert np.abs(shown - tau).max() < ROUNDING * np.abs(tau).max()


@pytest.mark.parametrize("scene", [_chain(2), _chain(4, "y"), _chain(4, mass=2.0)])
def test_others_have_none(scene: cd.Scene) -> None:
    """Few links, links that are not straight across the axis, and links that differ."""
    assert chain_pattern(cd.derive(scene).system) == ()


def test_pages_tell_it_too() -> None:
    from cardan.explain import document

    (section,) = [
        x for x in document(cd.derive(_chain(5))).sections if x.title == "Equations of motion"
    ]
    assert any("chain of n = 5 equal links" in str(block) for block in section.blocks)


def test_print_tells_it_once() -> None:
    text = str(cd.derive(_chain(40)))
    assert text.count("b_i = ") == 1
    assert "chain of n = 40 equal links" in text
    assert "a_ij = (J if i == j else ell sigma) + (n - max(i, j)) m ell^2" in text
    assert len(text.splitlines()) < 25
