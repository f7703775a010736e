"""Matrices that no component has: each is refused or noted by the name of a row, with a cure."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.linalg import block_diag
from scipy.sparse import csc_matrix

import cardan as cd
from cardan.superelements.interfaces import connect
from cardan.superelements.matrices import symmetric
from cardan.superelements.methods.free_interface import _boundary_coordinates
from cardan.superelements.node_dofs import number_rows
from cardan.superelements.reduction import _component
from superelements.components import BAR, beam_16, planar_beam
from table import each

ENDS = {"root": [11, 12, 13, 14], "tip": [51, 52, 53, 54]}
BEAM = {"node_dofs": "x y rz", "modes": 2}


def solid() -> dict[str, Any]:
    """A small brick of 20 nodes."""
    matrices = cd.superelement.read(BAR)
    return {
        "M": matrices.M.toarray(),
        "K": matrices.K.toarray(),
        "nodes": matrices.nodes.copy(),
        "interface": dict(ENDS),
        "node_ids": list(matrices.node_ids),
        "modes": 2,
    }


def planar() -> dict[str, Any]:
    data = beam_16()
    return {
        "M": data["M"].copy(),
        "K": data["K"].copy(),
        "nodes": data["nodes"].copy(),
        "interface": {"root": 0, "tip": 16},
        **BEAM,
    }


def put(name: str, place: Any, value: float) -> Callable[[dict[str, Any]], None]:
    def change(data: dict[str, Any]) -> None:
        data[name][place] = value

    return change


def say(**values: Any) -> Callable[[dict[str, Any]], None]:
    return lambda data: data.update(values)


def _cut(data: dict[str, Any]) -> None:
    """A second bar beside the first, connected with nothing."""
    for name in "MK":
        data[name] = block_diag(data[name], data[name])
    data["nodes"] = np.vstack([data["nodes"], data["nodes"] + [0.0, 1.0, 0.0]])
    data["node_ids"] += [k + 100 for k in data["node_ids"]]


def _empty(data: dict[str, Any]) -> None:
    for name in "MK":
        data[name][30, :] = data[name][:, 30] = 0.0


def _loose(data: dict[str, Any]) -> None:
    data["K"][30, :] = data["K"][:, 30] = 0.0
    data["supported"] = True


def _grounded(data: dict[str, Any]) -> None:
    data["K"][0, 0] *= 1.01


def _softened(data: dict[str, Any]) -> None:
    data["K"] -= 3e9 * np.diag(np.arange(60) % 3 == 0)
    data["supported"] = True


def _listed(data: dict[str, Any]) -> None:
    data["dofs"] = [(k // 3, ("x", "y", "rz")[k % 3]) for k in range(51)]
    data["dofs"][50] = (16, "y")
    data["node_dofs"] = None


def damaged(matrix: np.ndarray, part: str) -> csc_matrix:
    """A sparse matrix one of whose places lies far outside."""
    sparse = csc_matrix(matrix)
    getattr(sparse, part)[3] = 10**6
    return sparse


REFUSED: list[tuple[Callable[[], dict[str, Any]], Callable[..., None], str]] = [
    # entries
    (solid, put("K", (3, 7), 1e9), r"K is not symmetric: node 1\d \w and node 1\d \w have .*K\.T"),
    (planar, put("M", (3, 4), 1e-3), r"M is not symmetric: node 1 y and node 1 x"),
    (solid, lambda d: d.update(K=np.tril(d["K"])), r"only one triangle is there: give A \+ A\.T"),
    (solid, put("K", (5, 5), np.nan), r"K: the entry of node 12 z and node 12 z is nan"),
    (planar, put("M", (50, 50), np.inf), r"M: the entry of node 16 rz and node 16 rz is inf"),
    (solid, put("K", (5, 5), 1e200), r"K: the entry of node 12 z and node 12 z is 1e\+200"),
    (solid, put("M", (7, 7), -1.0), r"M has -1 on the diagonal at node 13 y.*check the sign"),
    (solid, lambda d: d.update(M=d["M"] * 0), "M is zero"),
    (solid, lambda d: d.update(M=d["M"].astype(complex)), "M: entries of complex128"),
    (solid, lambda d: d.update(M=d["K"], K=-d["M"]), r"K has .* on the diagonal at node"),
    (solid, lambda d: d.update(M=d["M"] > 0), "M: entries of bool, expected real numbers"),
    (solid, lambda d: d.update(K=d["K"].astype(object)), "K: entries of object"),
    (solid, lambda d: d.update(K=csc_matrix(d["K"] > 0)), "K: entries of bool"),
    (solid, lambda d: d.update(K=np.ma.masked_greater(d["K"], 1e8)), "K: 684 entries are masked"),
    (solid, lambda d: d.update(K=damaged(d["K"], "indices")), "K: its sparse matrix is damaged"),
    (solid, lambda d: d.update(M=damaged(d["M"], "indptr")), "M: its sparse matrix is damaged"),
    # sizes
    (solid, lambda d: d.update(M=d["M"][:57, :57]), "M is 57 x 57, expected 60 x 60"),
    (solid, lambda d: d.update(K=d["K"][:57]), r"K: shape \(57, 60\), expected a square matrix"),
    (solid, say(K=[[1, 2], [3]]), "K: rows of different lengths"),
    (solid, lambda d: d.update(nodes=d["nodes"][:19], node_ids=None), "60 rows, 19 nodes have 57"),
    (planar, say(node_dofs="x y"), "17 nodes with motions x y have 34"),
    (planar, say(node_dofs="x y theta"), "node_dofs='x y theta': give names out of x, y, z"),
    (solid, lambda d: d.update(nodes=d["nodes"][:, :2]), r"nodes: shape \(20, 2\).*give z = 0"),
    (solid, put("nodes", (4, 1), np.nan), r"the position of node 21 is \[.*nan"),
    (solid, put("nodes", (4, 1), 1e200), r"node 21 is .*give finite numbers below 1e\+30"),
    (solid, lambda d: d.update(nodes=d["nodes"] > 0), "nodes=array.*give real numbers"),
    (solid, lambda d: d.update(nodes=np.ma.masked_less(d["nodes"], 0.1)), "entries are masked"),
    (solid, lambda d: d["node_ids"].__setitem__(3, 11), "node 11 is there twice"),
    (planar, _listed, "dofs: node 16 y is there twice"),
    (planar, say(dofs=5), r"dofs=5: give a list such as"),
    (planar, say(dofs=[(0, "x")]), "dofs: 1 row named, M and K have 51"),
    (planar, say(dofs=["x"] * 51), "dofs: 'x' is not a row"),
    (solid, say(M=None), r"M: shape \(\), expected a square matrix"),
    (planar, say(order="nodes"), "order='nodes': give 'node' or 'component'"),
    # parts that nothing holds
    (solid, _empty, "node 33 x has neither mass nor stiffness.*take its row and column out"),
    (solid, _loose, "no stiffness at node 33 x"),
    (solid, _cut, r"is singular: node 1\d\d [xyz] moves without a force: .*Connect it"),
    (solid, _grounded, r"K resists a rigid .* most at node 11 x.*supported=True"),
    (planar, lambda d: d["nodes"].__imul__(1000.0), "K resists a rigid rotation about z"),
    (planar, say(node_dofs="y x rz"), "K resists a rigid rotation about z"),
    (solid, _softened, r"indefinite|is not positive definite|has -"),
    # interfaces
    (solid, say(interface={"root": 11}), r"a single node do not determine rx, ry, rz .*'x y z'"),
    (solid, say(interface={"root": [11, 12]}), r"'root': the motions of 2 nodes do not determine"),
    (planar, say(interface={"root": 0}, frame_dofs="x y z"), "do not determine z of its frame"),
    (solid, say(interface={"root": 11}, frame_dofs="x y z"), "still has 3 rigid motions, of node"),
    (planar, say(interface={"root": 0}, frame_dofs="x y"), "still has 1 rigid motion"),
    (solid, say(frame_dofs="x y z"), "which lacks rx ry rz; leave out frame_dofs"),
    (solid, say(interface={"root": [11, 12, 13, 99]}), "there is no node 99. Its 20 nodes have"),
    (solid, say(interface={"root": [11, 12, 13, 11]}), "a node is there twice"),
    (solid, say(interface={"root": "left"}), "'root': 'left'; give a node or nodes"),
    (solid, say(interface={}), "give a node or nodes for at least one"),
    (solid, say(interface={"a.b": [11, 12, 13]}), "give a name without a dot"),
    (solid, say(interface={"a\n": [11, 12, 13]}), r"interface: 'a\\n' is not a name"),
    (solid, say(interface={"\ud800": [11, 12, 13]}), "is not a name; give 1 to 200 letters"),
    (solid, say(interface={"a" * 999: [11, 12, 13]}), "is not a name; give 1 to 200 letters"),
    (solid, say(interface={"a": list(ENDS["root"]), "b": list(ENDS["root"])}), "node 11 belongs"),
    (solid, say(at={"root": (1e9, 0, 0)}), r"at: 'root' lies 1e\+09 m from its nodes"),
    (solid, lambda d: d["interface"].update(mid=[14, 21, 22]), "node 14 belongs to .* 'root' too"),
    (solid, say(rigid="rbe4"), "rigid='rbe4': give 'rbe2' or 'rbe3'"),
    (solid, say(at={"rot": (0, 0, 0)}), r"at: there is no interface 'rot'.*Did you mean 'root'"),
    (solid, say(at={"root": (0, 0)}), "at: 'root' is .*give three finite numbers"),
    # methods and what is added
    (solid, say(method="craig"), r"method='craig': there is no such method.*craig_bampton"),
    (solid, say(method="guyan"), "modes=2: 'guyan' has none"),
    (solid, say(modes=1000), r"modes=1000: the component has 36 modes"),
    (solid, say(modes=-1), "modes=-1: give 0 or more"),
    (solid, say(damping="much"), "damping='much': give real numbers"),
    (solid, say(loads={"heat": "hot"}), "loads: 'heat'='hot': give real numbers"),
    (solid, say(stress="x"), "stress='x': give real numbers"),
    (solid, say(stress=[[1.0], [2.0, 3.0]]), "stress: rows of different lengths"),
    (solid, say(at={"root": "left"}), "at: 'root'='left': give real numbers"),
    (solid, say(damping=-0.1), "damping=-0.1: give a ratio"),
    (solid, say(rayleigh=(-1, 0)), "rayleigh=.*give two numbers that are 0 or more"),
    (solid, say(loads={"heat": np.ones(3)}), r"'heat' has shape \(3,\), expected \(60,\)"),
    (solid, say(loads={"heat": np.full(60, np.nan)}), "'heat' is nan at node 11 x"),
    (solid, say(loads={"heat": np.full(60, 1e300)}), r"'heat' is 1e\+300 at node 11 x"),
    (solid, say(loads={"gravity": np.ones(60)}), "'gravity' is the weight.*rename yours"),
    (solid, say(loads={"a\t": np.ones(60)}), "loads: 'a.*t' is not a name"),
    (solid, say(damping=1e300), r"C: damping=\[1e\+300\] .* give ratios such as 0.01"),
    (solid, say(rayleigh=(1e300, 1e300)), r"C: .*rayleigh=\(1e\+300, 1e\+300\)"),
    (solid, say(damping=[0.01, np.nan]), r"damping=\[0.01, nan\]: give a ratio"),
    (solid, say(stress=np.ones((2, 2, 60))), r"stress: shape \(2, 2, 60\), expected"),
    (solid, say(stress=csc_matrix(np.ones((2, 60)) > 0)), "stress: entries of bool"),
    (solid, say(stress=csc_matrix(np.ones((2, 60)) * 1j)), "stress: entries of complex128"),
    (solid, say(stress=np.ones((1, 60)), stress_names=["\ud800"]), "stress_names: .* not a name"),
    (solid, say(geometric={"": np.eye(60)}), "geometric: '' is not a name"),
    (solid, say(stress=np.ones((2, 3))), r"stress: shape \(2, 3\), expected \(components, 60\)"),
    (solid, say(stress=np.full((2, 60), np.inf)), "stress: an entry is not finite"),
    (solid, say(stress=np.ones((2, 60)), stress_names=["a"]), "1 names for 2 rows"),
    (solid, say(stress_names=["a"]), "give stress= too"),
    (solid, say(geometric={"a": np.triu(np.ones((60, 60)))}), "geometric 'a' is not symmetric"),
]  # fmt: skip


@pytest.mark.filterwarnings("ignore::cardan.errors.ModelWarning")
@each("number", range(len(REFUSED)))
def test_what_no_component_has_is_refused(number: int) -> None:
    make, change, message = REFUSED[number]
    data = make()
    change(data)
    with pytest.raises((cd.ModelError, cd.SolveError), match=message):
        cd.superelement.reduce(**data)


@each("method", ["craig_bampton", "rubin", "macneal"])
def test_a_mechanism_inside_is_named(method: str) -> None:
    """A hinge in the middle of a beam that no interface is behind."""
    # two beams whose neighboring ends share displacements, not rotations
    M_1, K_1, nodes = planar_beam(1.0, 4, 1e6, 100.0, 2.0)
    M_2, K_2, more = planar_beam(0.5, 2, 1e6, 100.0, 2.0)
    M, K = np.zeros((23, 23)), np.zeros((23, 23))
    first, second = np.arange(15), np.r_[12, 13, 15:22]
    for target, a, b in ((M, M_1, M_2), (K, K_1, K_2)):
        target[np.ix_(first, first)] += a
        target[np.ix_(second, second)] += b
    M, K = M[:22, :22], K[:22, :22]
    names = ("x", "y", "rz")
    dofs = [(k // 3, names[k % 3]) for k in range(15)]
    dofs += [(7, "rz"), *((5 + k // 3, names[k % 3]) for k in range(6))]
    positions = np.vstack([nodes, more[1:] + np.array([1.0, 0, 0]), [[1.0, 0, 0]]])
    with pytest.raises(cd.ModelError, match=r"singular: node \d \w+ moves without a force"):
        cd.superelement.reduce(M, K, positions, {"root": 0}, dofs=dofs, modes=2, method=method)


UNITS = [
    ("nodes in mm", lambda d: d["nodes"].__imul__(1000.0), "nodes in mm"),
    ("K in N/mm", lambda d: d["K"].__imul__(1e-3), "K in N/mm"),
    ("M in t", lambda d: d["M"].__imul__(1e-3), "M in t"),
    ("M in g", lambda d: d["M"].__imul__(1e3), "M in g"),
    ("mm, t, s", lambda d: (d["nodes"].__imul__(1e3), d["M"].__imul__(1e-3)), "nodes in mm"),
]


@each("what, change, message", UNITS)
def test_units_off_by_a_thousand_are_noted(what: str, change: Any, message: str) -> None:
    data = solid()
    change(data)
    with pytest.warns(cd.ModelWarning, match=rf"near node \d+ sound would travel.*{message}"):
        record = cd.superelement.reduce(**data)
    assert message in repr(record)


def test_masses_and_places_that_do_not_fit_are_noted() -> None:
    data = solid()
    data["M"][::3, ::3] *= 2.0
    with pytest.warns(cd.ModelWarning, match="masses along x, y, z differ: 243, 121.5, 121.5 kg"):
        cd.superelement.reduce(**data)
    data = planar()
    # rotations show that nodes have another unit than K
    data["nodes"] *= 1e-3
    with pytest.raises(cd.ModelError, match="K resists a rigid rotation"):
        cd.superelement.reduce(**data)
    far = solid()
    far["nodes"][:, 0] *= -1.0
    far["nodes"][0, 0] = 500.0
    with pytest.raises(cd.ModelError, match="K resists a rigid rotation"):
        cd.superelement.reduce(**far)


@each("inertia, message", [(0.0, "center of mass .* lies outside"), (1e6, "radius of gyration")])
def test_a_mass_far_from_all_nodes_is_noted(inertia: float, message: str) -> None:
    data = planar()
    # a rotor on the tip, or an arm of 40 m with a mass at its end
    offset = 0.0 if inertia else 40.0
    data["M"][48:51, 48:51] += [
        [5, 0, 0],
        [0, 5, 5 * offset],
        [0, 5 * offset, 5 * offset**2 + inertia],
    ]
    with pytest.warns(cd.ModelWarning, match=message):
        cd.superelement.reduce(**data)


def test_shapes_that_do_not_move_all_interfaces_are_refused() -> None:
    """Rows of the boundary without full rank, by the names of the motions."""
    data = planar()
    dofs = number_rows(data["nodes"], 51, node_dofs="x y rz")
    M, K = (symmetric(name, data[name], dofs) for name in "MK")
    component = _component(dofs, M, K, connect(dofs, data["interface"]), supported=False)
    rows = np.random.default_rng(4).standard_normal((6, 8))
    rows[4] = 2 * rows[1]
    with pytest.raises(cd.ModelError, match=r"interfaces: 'root\.y', 'tip\.y' follow from other"):
        _boundary_coordinates(component, rows, np.eye(8), np.eye(8))
    rows[4] = rows[3] + rows[0]
    _boundary_coordinates(component, rows + np.eye(6, 8), np.eye(8), np.eye(8))


def test_sparse_and_dense_matrices_are_one() -> None:
    data = solid()
    dense = cd.superelement.reduce(**data)
    for kind in (csc_matrix, lambda x: csc_matrix(x).tocoo(), np.ndarray.tolist):
        other = cd.superelement.reduce(**{**data, "M": kind(data["M"]), "K": kind(data["K"])})
        np.testing.assert_array_equal(other.M, dense.M)


@each("size", [1e3, 1e-2, 1e-4, 1e-6])
@pytest.mark.filterwarnings("ignore::cardan.errors.ModelWarning")
def test_parts_of_any_size_are_equally_accurate(size: float) -> None:
    """Frequencies of similar bodies of one material go with the inverse of their size."""
    data, small = solid(), solid()
    small["K"], small["M"] = small["K"] * size, small["M"] * size**3
    small["nodes"] = small["nodes"] * size
    one, other = cd.superelement.reduce(**data), cd.superelement.reduce(**small)
    for locked in ([], ["root"], ["root", "tip"]):
        exact = one.modes(locked).frequencies / size
        np.testing.assert_allclose(other.modes(locked).frequencies, exact, rtol=1e-11)


@pytest.mark.filterwarnings("ignore::cardan.errors.ModelWarning")
def test_rounding_in_rows_without_force_is_no_support() -> None:
    """A beam along -x, whose matrices are turned by half a turn with what rounding leaves."""
    M, K, nodes = planar_beam(1.0, 4, 1e6, 100.0, 2.0)
    dofs = [(k // 3, ("x", "y", "rz")[k % 3]) for k in range(15)] + [(k, "rx") for k in range(5)]
    torsion = 50.0 * (2 * np.eye(5) - np.eye(5, k=1) - np.eye(5, k=-1))
    torsion[0, 0] = torsion[4, 4] = 50.0
    K, M = block_diag(K, torsion), block_diag(M, np.eye(5))
    # 1e-15 of the stiffness along the beam between torsion and bending
    K[15, 2] = K[2, 15] = 4e-9
    supported = K.copy()
    supported[15, 2] = supported[2, 15] = 1.0
    with pytest.raises(cd.ModelError, match="K resists a rigid"):
        cd.superelement.reduce(M, supported, nodes, {"root": 0}, dofs=dofs, modes=2)
    record = cd.superelement.reduce(M, K, nodes, {"root": 0}, dofs=dofs, modes=2)
    assert max(record.check.residual) < 1e-5


@each(
    "call, message",
    [
        (lambda r: r.displacements("x"), "displacements: z='x': give real numbers"),
        (lambda r: r.displacements(np.ones(14) * 1j), "displacements: z=.*give real numbers"),
        (lambda r: r.stresses(np.ones(14)), "the component has none; give stress="),
        (lambda r: r.surface_displacements(np.ones(3)), r"shape \(3,\), expected \(\.\.\., 14\)"),
        (lambda r: r.rigid_motions((1, 2)), r"about=\(1, 2\): give three finite numbers"),
        (lambda r: r.rigid_motions("x"), "about='x': give real numbers"),
        (lambda r: r.impedance([1e300]), r"below 1e\+30 rad/s"),
        (lambda r: r.impedance([np.nan]), "finite numbers"),
        (lambda r: r.modes("rot"), "there is no interface 'rot'.*Did you mean 'root'"),
    ],
)
def test_what_a_component_is_asked_for_is_checked(call: Any, message: str) -> None:
    record = cd.superelement.reduce(**solid())
    with pytest.raises((cd.ModelError, cd.ArgumentError), match=message):
        call(record)


@pytest.mark.filterwarnings("ignore::cardan.errors.ModelWarning")
def test_what_can_be_reduced_can_be_saved_and_loaded(tmp_path: Any) -> None:
    """Or the file is refused when it is written, not when it is read."""
    file = tmp_path / "part.npz"
    for scale in (1e-80, 1e-12, 1.0, 1e12, 1e80):
        data = solid()
        data["K"], data["M"] = data["K"] * scale, data["M"] * scale
        record = cd.superelement.reduce(**data)
        try:
            record.save(file)
        except cd.ModelError as error:
            assert "cannot be saved: " in str(error)  # noqa: PT017
            assert scale in (1e-80, 1e80)
        else:
            np.testing.assert_array_equal(cd.superelement.load(file).M, record.M)


def test_an_interface_of_many_nodes_takes_memory_for_these() -> None:
    """A face of 20,000 nodes, whose motions would fill 29 GB if all directions were computed."""
    nodes = np.random.default_rng(3).uniform(size=(20_000, 3)) * [0.0, 1.0, 1.0]
    dofs = number_rows(nodes, 60_000)
    connection = connect(dofs, {"face": np.arange(20_000)})
    assert connection.n_boundary == 6
    motions = connection.matrix.toarray()
    np.testing.assert_allclose(motions[:, 3:], dofs.rigid(nodes.mean(axis=0))[:, 3:], atol=1e-12)


def test_a_part_that_no_interface_holds_is_named() -> None:
    """Of a mesh in two parts, as given and as meant."""
    mesh = cd.superelement.mesh
    cube = np.array([[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))], float)
    cells = {"hex8": np.arange(16).reshape(2, 8)}
    two = mesh.from_arrays(
        np.vstack([cube, cube + np.array([5.0, 0, 0])]), cells, scale=1.0, parts=2
    )
    steel = cd.material(E=210e9, nu=0.3, rho=7850)
    with pytest.raises(cd.ModelError, match=r"node (8|9|1\d) [xyz] moves .* not held by the inter"):
        cd.superelement.from_mesh(two, steel, {"a": [0, 3, 4, 7]}, modes=1)
    both = {"a": [0, 3, 4, 7], "b": [8, 11, 12, 15]}
    assert cd.superelement.from_mesh(two, steel, both, modes=1).n == 13
