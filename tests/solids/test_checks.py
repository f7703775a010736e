"""Meshes with faults: each message names the node or the cell, and the cure."""

from __future__ import annotations

import contextlib

import numpy as np
import pytest

import cardan as cd
from cardan import solids as fem
from cardan.solids.cells import SOLIDS
from solids.meshes import KINDS, block, grid

TET = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
ONE = {"tet4": [[0, 1, 2, 3]]}


def cube(kind="hex8", counts=(1, 1, 1)):
    points, cells = grid(counts, kind=kind)
    return points.copy(), {name: array.copy() for name, array in cells.items()}


def exchanged(kind, a, b):
    points, cells = cube(kind)
    cells[kind][:, [a, b]] = cells[kind][:, [b, a]]
    return points, cells


def moved(kind, node, to, counts=(1, 1, 1)):
    points, cells = cube(kind, counts)
    points[cells[kind][0, node]] = to
    return points, cells


def two(offset, kind="hex8"):
    points, cells = cube(kind)
    return np.vstack([points, points + offset]), {
        kind: np.vstack([cells[kind], cells[kind] + len(points)])
    }


def touching():
    """Two cubes with one edge in common."""
    points, cells = cube(counts=(2, 2, 1))
    both = cells["hex8"][[0, 3]]
    used = np.unique(both)
    return points[used], {"hex8": np.searchsorted(used, both)}


FAULTS = {
    "no numbers": (("x", ONE), r"mesh: points='x': give real numbers"),
    "plane": ((TET[:, :2], ONE), r"points have the shape \(4, 2\), expected \(nodes, 3\)"),
    "empty": ((np.zeros((0, 3)), ONE), r"points have the shape \(0, 3\)"),
    "nan": ((np.where(TET == 1, np.nan, TET), ONE), r"node 1 lies at .*nan.*\(and 2 more nodes\)"),
    "infinite": ((np.where(TET == 1, np.inf, TET), ONE), r"node 1 lies at .*inf"),
    "unknown kind": ((TET, {"tet5": [[0, 1, 2, 3, 0]]}), r"no kind of cells 'tet5'.*tet4"),
    "no mapping": ((TET, [[0, 1, 2, 3]]), r"give nodes of cells by kind"),
    "no cells": ((TET, {"tet4": []}), r"no cells of a kind that is treated"),
    "twice by names": ((TET, {"tet4": [[0, 1, 2, 3]], "tetra": [[0, 1, 2, 3]]}), r"there twice"),
    "width": ((TET, {"tet4": [[0, 1, 2]]}), r"shape \(1, 3\), expected node numbers \(cells, 4\)"),
    "ragged": ((TET, {"tet4": [[0, 1, 2], [0]]}), r"no cells of a kind that is treated"),
    "real numbers": ((TET, {"tet4": [[0.0, 1, 2, 3]]}), r"array of float64"),
    "huge": ((TET, {"tet4": np.array([[0, 1, 2, 2**63]], np.uint64)}), r"there is no node 9223372"),
    "beyond": ((TET, {"tet4": [[0, 1, 2, 4]]}), r"cell 0 of tet4: there is no node 4; .* 0 to 3"),
    "negative": ((TET, {"tet4": [[0, 1, 2, -1]]}), r"cell 0 of tet4: there is no node -1"),
    "collapsed": ((TET, {"tet4": [[0, 1, 2, 2]]}), r"cell 0 of tet4 has node 2 twice: collapsed"),
    "same cell": (
        (TET, {"tet4": [[0, 1, 2, 3], [1, 2, 0, 3]]}),
        r"cell 0 of tet4 is there again as number 1",
    ),
    "unused": (
        (np.vstack([TET, [[5.0, 5, 5], [6, 6, 6]]]), ONE),
        r"no cell has node 4 \(and 1 more node\).*leave it out",
    ),
    "same place": (two((1.0, 0, 0)), r"nodes 4 and 8 lie in one place, \(1, 0, 0\).*merge="),
    "almost same place": (two((1.0, 0, 1e-8)), r"lie in one place"),
    "apart": (
        two((3.0, 0, 0)),
        r"2 parts without common nodes, expected 1: 1 cell around .*parts=2",
    ),
    "hinge": (touching(), r"cell 0 of hex8 and cell 1 of hex8 are connected by corners or edges"),
    "inside out": (
        (TET, {"tet4": [[0, 2, 1, 3]]}),
        r"cell 0 of tet4 \(nodes 0, 2, 1, 3\) is inside",
    ),
    "all inside out": (
        (cube("tet4")[0] * [1, 1, -1], cube("tet4")[1]),
        r"cell 0 of tet4 .* is inside out, as all 6 of its kind: .* mirrored",
    ),
    "flat": ((np.vstack([TET[:3], [[1, 1, 0]]]), ONE), r"is flat"),
    "bottom crossed": (
        exchanged("hex8", 1, 2),
        r"folds over \(1 cell in all\): corners are in another order",
    ),
    "bottom and top": (
        exchanged("hex8", [0, 1, 2, 3], [4, 5, 6, 7]),
        r"is inside out \(1 cell in all\): number",
    ),
    "middles exchanged": (
        exchanged("tet10", 8, 9),
        r"cell 0 of tet10: node \d+, the middle of nodes .* lies between nodes .*0-1, 1-2",
    ),
    "middle far off": (
        moved("hex20", 8, (0.5, 0.0, -0.6)),
        r"node \d+, the middle of .* lies 0.6 edge lengths from there",
    ),
    "middle near the end": (
        moved("hex20", 8, (0.9, 0.0, 0.0)),
        r"lies 0.4 edge lengths from there",
    ),
    "corner pushed through": (moved("hex8", 6, (-0.5, -0.5, -0.5)), r"folds over"),
    "three at a face": (
        (
            np.vstack([TET, [[0.2, 0.2, -1], [0.3, 0.3, 2.0]]]),
            {"tet4": [[0, 1, 2, 3], [0, 2, 1, 4], [0, 1, 2, 5]]},
        ),
        r"have the face with the corners 0, 1, 2: cells overlap",
    ),
}


@pytest.mark.parametrize("name", FAULTS)
def test_faults_are_named(name: str) -> None:
    (points, cells), says = FAULTS[name]
    with pytest.raises(cd.ModelError, match=says):
        fem.from_arrays(points, cells, scale=1.0)


def test_a_cell_among_good_ones_is_told_apart() -> None:
    points, cells = cube("tet4", (2, 1, 1))
    cells["tet4"][7, [0, 1]] = cells["tet4"][7, [1, 0]]
    with pytest.raises(
        cd.ModelError, match=r"cell 7 of tet4 .* is inside out \(1 cell in all\): num"
    ):
        fem.from_arrays(points, cells, scale=1.0)


@pytest.mark.parametrize(
    ("points", "says"),
    [
        (TET * 320, r"it is 320 m long. If its nodes are in millimeters, give scale=1e-3"),
        (TET * 2e-4, r"it is 0.0002 m long"),
    ],
)
def test_units_that_nobody_means(points, says: str, recwarn) -> None:
    fem.from_arrays(points, ONE, scale=1.0)
    fem.from_arrays(points * 1e3, ONE, scale=1e-3)
    assert not recwarn
    with pytest.warns(cd.ModelWarning, match=says):
        fem.from_arrays(points, ONE)


def test_scale_is_a_length() -> None:
    assert fem.from_arrays(TET * 20, ONE, scale=1e-3).points.max() == pytest.approx(0.02)
    for scale in (0.0, -1.0, float("nan")):
        with pytest.raises(cd.ModelError, match="length of a unit"):
            fem.from_arrays(TET, ONE, scale=scale)


def test_cells_that_fold_at_a_corner_are_warned_of() -> None:
    points, cells = moved("hex8", 6, (0.65, 0.65, 0.65))
    with pytest.warns(cd.ModelWarning, match=r"1 cell of hex8, .* number 0, fold over at a node"):
        fem.from_arrays(points, cells, scale=1.0)


def test_parts_and_quarter_points_may_be_meant() -> None:
    assert len(fem.from_arrays(*two((3.0, 0, 0)), parts=2).points) == 16
    fem.from_arrays(*moved("hex20", 8, (0.25, 0.0, 0.0)), scale=1.0)


def test_nodes_by_name_and_by_number() -> None:
    points, cells = cube("hex20", (2, 1, 1))
    sets = {"pin": [3, 1, 1]}
    faces = {"end": {"quad8": block("hex20", (2, 1, 1)).boundary.faces["quad8"][:1]}}
    mesh = fem.from_arrays(points, cells, sets, faces, {"half": {"hex20": [1]}})
    assert mesh.names == ["end", "pin", "half"]
    assert mesh.nodes("pin").tolist() == [1, 3]
    assert mesh.nodes([5, 2]).tolist() == [2, 5]
    assert len(mesh.nodes("end")) == 8
    assert len(mesh.nodes("half")) == 20
    assert repr(mesh) == "Mesh(32 nodes, 2 hex20; named: end, pin, half)"
    for place, says in (
        ("pins", r"no surface, set or region 'pins'.*Did you mean 'pin'"),
        ([99], r"there is no node 99; nodes are numbered 0 to 31"),
        ([-1], r"there is no node -1"),
        ([0.5], r"give a list of node numbers or the name"),
        ([], r"give a list of node numbers"),
    ):
        with pytest.raises(cd.ModelError, match=says):
            mesh.nodes(place)


def test_faces_are_outer_ones_and_point_outward() -> None:
    mesh = block("tet10", (2, 1, 1))
    every = mesh.faces(np.arange(len(mesh.points)))["tri6"]
    assert len(every) == 20
    corners = mesh.points[every[:, :3]]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert ((corners.mean(axis=1) - 0.5) * normal).sum(axis=1).min() > 0
    assert np.linalg.norm(normal, axis=1).sum() / 2 == pytest.approx(6.0)
    with pytest.raises(cd.ModelError, match=r"no outer face of a cell has all its nodes"):
        mesh.faces([0, 1])
    # a face is recognized in any order of its nodes, and one inside is refused
    left = mesh.boundary.faces["tri6"][:1]
    listed = fem.from_arrays(
        mesh.points, dict(mesh.cells), surfaces={"left": {"tri6": left[:, ::-1]}}
    )
    assert listed.faces("left")["tri6"].tolist() == left.tolist()
    cell = mesh.cells["tet10"][0]
    within = [list(face) for face in SOLIDS["tet10"].faces]
    inner = [face for face in within if sorted(cell[face]) not in np.sort(every).tolist()]
    wrong = {"inside": {"tri6": cell[inner[:1]]}}
    with pytest.raises(cd.ModelError, match=r"'inside': its tri6 face .* is not an outer face"):
        fem.from_arrays(mesh.points, dict(mesh.cells), surfaces=wrong).faces("inside")


@pytest.mark.parametrize("kind", KINDS)
def test_triangles_close_the_surface(kind: str) -> None:
    """Every edge belongs to two of them, in opposite directions; their volume is that of a cube."""
    mesh = block(kind, (2, 1, 1))
    triangles = mesh.triangles
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    there, back = {tuple(x) for x in edges.tolist()}, {tuple(x[::-1]) for x in edges.tolist()}
    assert there == back
    assert len(there) == len(edges)
    a, b, c = mesh.points[triangles].transpose(1, 0, 2)
    assert np.einsum("ij,ij->", a, np.cross(b, c)) / 6 == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"node_sets": {"a": [4]}}, r"set 'a': there is no node 4; numbers go from 0 to 3"),
        ({"node_sets": {"a": [0.5]}}, r"set 'a': .* give a list of numbers of nodes"),
        ({"regions": {"a": {"hex8": [0]}}}, r"there is no hex8 cell 0; there are none"),
        (
            {"surfaces": {"a": {"tri3": [[0, 1, 9]]}}},
            r"surface 'a': cell 0 of tri3: there is no node",
        ),
        ({"surfaces": {"a": {"tet4": [[0, 1, 2, 3]]}}}, r"surface 'a': .*no kind of cells 'tet4'"),
    ],
)
def test_names_of_what_is_not_there(arguments: dict, says: str) -> None:
    with pytest.raises(cd.ModelError, match=says):
        fem.from_arrays(TET, ONE, **arguments)


@pytest.mark.parametrize("seed", range(40))
def test_random_damage_never_ends_in_another_error(seed: int) -> None:
    """Mutants of a good mesh are read or refused by a message."""
    rng = np.random.default_rng(seed)
    kind = ("tet10", "hex20", "hex8")[seed % 3]
    points, cells = cube(kind, (2, 1, 1))
    for _ in range(rng.integers(1, 4)):
        which = rng.integers(4)
        row, column = rng.integers(len(cells[kind])), rng.integers(cells[kind].shape[1])
        if which == 0:
            cells[kind][row, column] = rng.integers(-3, len(points) + 3)
        elif which == 1:
            points[rng.integers(len(points))] = rng.choice([np.nan, np.inf, 1e300, 0.0, 0.5])
        elif which == 2:
            points[rng.integers(len(points))] += rng.normal(size=3)
        else:
            cells[kind] = np.delete(cells[kind], row, axis=0)
            if not len(cells[kind]):
                break
    # no error but this one
    with contextlib.suppress(cd.ModelError):
        mesh = fem.from_arrays(points, cells, scale=1.0)
        assert mesh.dofs == 3 * len(points)
