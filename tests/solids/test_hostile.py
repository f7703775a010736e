"""Wrong arguments of meshes, materials, loads and reductions: each is refused by a message."""

from __future__ import annotations

import warnings
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan import solids as fem
from cardan.solids.cells import SOLIDS
from solids.meshes import block
from table import each

LUG = Path(__file__).with_name("files") / "lug.inp"
STEEL = cd.material(E=210e9, nu=0.3, rho=7850)
TET = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
ONE = {"tet4": [[0, 1, 2, 3]]}
REFUSED = (cd.ModelError, cd.ArgumentError, cd.SolveError)


@cache
def bar() -> fem.Mesh:
    return block("hex20", (4, 1, 1), (0.4, 0.1, 0.1))


@cache
def body() -> fem.Solid:
    return fem.solid(bar(), STEEL)


def ends() -> dict[str, Any]:
    x = bar().points[:, 0]
    return {"a": np.flatnonzero(x < 1e-9), "b": np.flatnonzero(x > 0.4 - 1e-9)}


def reduced(material: Any = STEEL, interfaces: Any = None, **options: Any) -> Any:
    places = ends() if interfaces is None else interfaces
    return cd.superelement.from_mesh(bar(), material, places, **{"modes": 3, **options})


@each(
    "change, message",
    [
        ({"points": TET > 0}, "mesh: points=array.*give real numbers"),
        ({"points": TET + 1j}, "mesh: points=array.*give real numbers"),
        ({"points": TET.astype(str)}, "mesh: points=array.*give real numbers"),
        ({"points": np.ma.masked_greater(TET, 0)}, "mesh: points: 3 entries are masked; fill them"),
        ({"points": TET * 1e-20}, "1e-20 m long, smaller than an atom: .*scale="),
        ({"points": TET + 1e16}, r"1e\+16 m from the origin .* no digits left.*Move it"),
        ({"cells": {"tet4": np.ones((1, 4), bool)}}, "tet4: an array of bool"),
        ({"scale": "x"}, "mesh: scale='x': give real numbers"),
        ({"scale": True}, "mesh: scale=True: give real numbers"),
        ({"scale": 1j}, "mesh: scale=1j: give real numbers"),
        ({"parts": 0}, "mesh: parts=0: give how many are meant"),
        ({"parts": "x"}, "mesh: parts='x': give how many are meant"),
        ({"node_sets": [1]}, r"mesh: node_sets=\[1\]: give values by name"),
        ({"node_sets": {"a": [[1], [1, 2]]}}, "mesh: set 'a': .*give a list of numbers of nodes"),
        ({"node_sets": {1: [0]}}, "mesh: node_sets: 1 is not a name"),
        ({"surfaces": [1]}, r"mesh: surfaces=\[1\]: give values by name"),
        ({"regions": {"a": [0]}}, r"mesh: regions: 'a'=\[0\]: give values by name"),
    ],
)
def test_arrays_of_a_mesh(change: dict[str, Any], message: str) -> None:
    with pytest.raises(REFUSED, match=message):
        fem.from_arrays(**{"points": TET, "cells": ONE, "scale": 1.0, **change})


@each(
    "points, message",
    [
        (np.vstack([TET[:3], [[0.3, 0.3, 5e-9]]]), "1 cell of tet4 .*nearly flat.* nodes 0, 1, 2"),
        (TET + 1e9, r"1e\+09 m from the origin and is 1 m long: its nodes lose digits"),
    ],
)
def test_what_loses_digits_is_warned_of(points: Any, message: str) -> None:
    with pytest.warns(cd.ModelWarning, match=message):
        fem.from_arrays(points, ONE, scale=1.0)


def test_no_kind_of_cell_folds_over_between_its_nodes_in_silence() -> None:
    """Random cells that are accepted without a word are positive on a fine grid."""
    rng = np.random.default_rng(5)
    grid = np.array(np.meshgrid(*[np.linspace(-1, 1, 7)] * 3)).reshape(3, -1).T
    cell = SOLIDS["hex20"]
    silent = 0
    for _ in range(150):
        mesh = block("hex20", (1, 1, 1))
        points = mesh.points + rng.normal(size=mesh.points.shape) * rng.uniform(0.02, 0.2)
        try:
            with warnings.catch_warnings(record=True) as messages:
                warnings.simplefilter("always")
                fem.from_arrays(points, dict(mesh.cells), scale=1.0)
        except cd.ModelError:
            continue
        slope = cell.slope(grid)
        maps = np.einsum("ar,pak->prk", points[mesh.cells["hex20"][0]], slope)
        # what lies between the 61 places that are looked at is small
        silent += not messages and bool((np.linalg.det(maps) < -0.01).any())
    assert silent == 0


@each(
    "material, message",
    [
        ({"E": 210e9, "nu": 0.3}, r"no material has a density: give rho= \[kg/m\^3\]"),
        ({"E": 210e9, "nu": 0.5, "rho": 7850}, "nu is 0.5: with 1/2 the volume cannot change"),
        ({"E": 1e9, "G": 1e8, "rho": 1000}, r"E and G give nu = 4, .*E = 2 G \(1 \+ nu\)"),
    ],
)
def test_materials_that_no_solid_has(material: dict[str, float], message: str) -> None:
    with pytest.raises(cd.ModelError, match=message):
        reduced(cd.material(**material))


def test_cells_that_lock_are_warned_of() -> None:
    with pytest.warns(cd.ModelWarning, match=r"nu is 0.4999: cells lock .* Give at most 0.495"):
        fem.solid(bar(), cd.material(E=210e9, nu=0.4999, rho=7850))


@each(
    "options, message",
    [
        ({"interfaces": [1]}, r"interfaces=\[1\]: give surfaces, sets or nodes by name"),
        ({"interfaces": {"a": []}}, r"nodes=\[\]: give a list of node numbers"),
        ({"interfaces": {"a": [0, 1]}}, "'a': the motions of 2 nodes do not determine"),
        ({"interfaces": {"a": [0, 1, 2, 3], "b": [3, 4, 5]}}, "node 3 belongs to interface 'a'"),
        ({"modes": float("nan")}, "from_mesh: modes=nan: give a whole number"),
        ({"modes": 10**9}, "the component has 120 modes"),
        ({"scale": "x"}, "from_mesh: scale='x': give a number"),
        ({"stress": [0.5]}, r"nodes=\[0.5\]: give a list of node numbers"),
        ({"stress": [[1], [1, 2]]}, "give a list of node numbers"),
        ({"stiffening": "c"}, "stiffening='c': there is no interface of that name"),
    ],
)
def test_reductions_of_meshes(options: dict[str, Any], message: str) -> None:
    with pytest.raises(REFUSED, match=message):
        reduced(**options)


@each("mesh", [None, 3, b"x.inp", TET])
def test_what_is_not_a_mesh(mesh: Any) -> None:
    with pytest.raises(cd.ArgumentError, match=r"(?s)from_mesh: mesh=.*give a Mesh or the path"):
        cd.superelement.from_mesh(mesh, STEEL, {"a": [0, 1, 2]})


@each(
    "call, message",
    [
        (lambda: fem.solid(3, STEEL), "solid: mesh=3: give a Mesh"),
        (lambda: fem.solid(bar(), 3), "material=3: give one of cd.material or orthotropic"),
        (lambda: body().mass(lumped="x"), "lumped='x': give True or False"),
        (lambda: fem.gravity(body(), "x"), "gravity: acceleration='x': give"),
        (lambda: fem.gravity(3, (0, 0, 1)), "gravity: solid=3: give a Solid"),
        (lambda: fem.centrifugal(body(), (1, 2, 3), center="x"), "centrifugal: center='x'"),
        (lambda: fem.pressure(body(), ends()["a"], "x"), "pressure: value='x': give a number"),
        (lambda: fem.pressure(body(), ends()["a"], np.nan), "pressure: value is nan"),
        (lambda: fem.thermal(body(), "x"), "thermal: temperature='x'"),
        (lambda: fem.thermal_stresses(body(), np.full(56, np.nan)), "temperature of node 0 is not"),
        (lambda: fem.thermal_stresses(body(), np.ones(3)), "temperature has the shape"),
        (lambda: fem.stress_operator(3), "stress_operator: solid=3: give a Solid"),
        (lambda: fem.von_mises([1, 2, 3]), r"stress of shape \(3,\), expected \(\.\.\., 6\)"),
        (lambda: fem.von_mises(np.ones(6) * 1j), "von_mises: stress=.*real numbers"),
        (lambda: body().geometric_stiffness("x"), "displacement='x': give real numbers"),
        (lambda: fem.read(3), "read: path=3: give the path"),
        (lambda: fem.read(LUG, merge="x"), "read: merge='x': give a number"),
        (
            lambda: fem.read(LUG, scale=0, merge=1e-9),
            r"lug.inp: scale=0: give the length of a unit",
        ),
    ],
)
def test_parts_of_meshes(call: Any, message: str) -> None:
    with pytest.raises(REFUSED, match=message):
        call()


def test_a_reduced_component_is_loaded_not_read(tmp_path: Path) -> None:
    file = reduced().save(tmp_path / "bar.npz")
    with pytest.raises(cd.ModelError, match=r"is a reduced component; .*load reads it"):
        cd.superelement.read(file)
