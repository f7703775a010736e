"""The equations of first order, x' = A x + B r and y = C x + D r, as expressions."""

from __future__ import annotations

from collections.abc import Iterable

from ...errors import DerivationError, listed, near
from ...ir.matrix import Matrix
from ...ir.solve import solve
from ...records import dataclass
from .all_coordinates import FullMatrices
from .reduced import Reduced
from .reference import Reference, picked


@dataclass(frozen=True)
class Plant:
    """A (nx, nx), B (nx, nr), C (ny, nx), D (ny, nr), rates of x along the reference (nx, 1),
    forces (nw, nr); names of inputs, outputs.
    """

    A: Matrix
    B: Matrix
    C: Matrix
    D: Matrix
    xdot: Matrix
    push: Matrix
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]


def plant(
    at: Reference,
    full: FullMatrices,
    x: Reduced,
    inputs: Iterable[str] | None,
    outputs: Iterable[str] | None,
) -> Plant:
    """x = [increments, speeds, internal states]."""
    g, ny, nw = at.graph, len(at.y), len(at.w)
    nz = full.Zz.rows
    push, driven = _forces(at, x, inputs)
    right = Matrix.hstack(-x.K, -x.C, -x.by_z, push)
    with g.made_by("M", "factor"):
        solution = solve("spd", x.M, right) if nw else right
    states = ny + nw + nz
    accelerations = solution.block(slice(None), slice(0, states))
    J = Matrix.hstack(x.J, Matrix.zeros(g, x.J.rows, nw + nz))
    V = Matrix.hstack(x.Y, x.W, Matrix.zeros(g, x.J.rows, nz))
    inner = Matrix.hstack(Matrix.zeros(g, nz, ny + nw), Matrix.identity(g, nz))
    kinematics = Matrix.hstack(x.Ty, x.Tw, Matrix.zeros(g, ny, nz))
    zdot = full.Ze @ J + full.Zv @ V + full.Zz @ inner
    wdot = Matrix.hstack(x.Vy, x.Vw, Matrix.zeros(g, x.J.rows, nz)) + x.W @ accelerations
    pushed = solution.block(slice(None), slice(states, None))
    by_r = _columns(at, driven)
    B = Matrix.vstack(Matrix.zeros(g, ny, len(driven)), pushed, full.Zr @ by_r)
    output_matrix = full.ye @ J + full.yv @ V + full.yz @ inner + full.ya @ wdot
    through = full.yr @ by_r + full.ya @ (x.W @ pushed)
    rows = _Rows(at, full.N @ J, V, inner, output_matrix, through)
    C, D, output_names = rows.chosen(outputs)
    A = Matrix.vstack(kinematics, accelerations, zdot)
    udot = at.put(Matrix(at.graph, at.system.nu, 1, at.block("udot")))
    xdot = Matrix.vstack(picked(full.edot, at.y, [0]), picked(udot, at.w, [0]), full.zdot)
    return Plant(A, B, C, D, xdot, push, driven, output_names)


def _columns(at: Reference, driven: tuple[str, ...]) -> Matrix:
    """Declared inputs by chosen ones (nr, n): forces along speeds are none of them."""
    nodes = [int(name == entry) for entry in at.names["r"] for name in driven]
    return Matrix(at.graph, len(at.names["r"]), len(driven), nodes)


def _forces(
    at: Reference, x: Reduced, names: Iterable[str] | None
) -> tuple[Matrix, tuple[str, ...]]:
    """Forces along the independent speeds by chosen inputs (nw, n)."""
    if names is None:
        return x.by_r, at.names["r"]
    columns, chosen = [Matrix.zeros(at.graph, len(at.w), 0)], listed("inputs", names, "torque")
    for name in chosen:
        if name in at.names["r"]:
            columns.append(x.by_r.column(at.names["r"].index(name)))
            continue
        slot = next((n for n in (name, f"{name}.u") if n in at.names["u"]), None)
        if slot is None:
            candidates = (*at.names["r"], *at.names["u"])
            raise DerivationError(
                f"linearize: there is no input or speed '{name}'.{near(name, candidates)}"
            )
        columns.append(picked(x.W, [at.names["u"].index(slot)], range(len(at.w))).T)
    return Matrix.hstack(*columns), tuple(chosen)


@dataclass(frozen=True)
class _Rows:
    """Rows of possible outputs, by the states."""

    at: Reference
    places: Matrix
    speeds: Matrix
    inner: Matrix
    output_rows: Matrix
    through: Matrix

    def chosen(self, names: Iterable[str] | None) -> tuple[Matrix, Matrix, tuple[str, ...]]:
        """C, D and names: declared outputs, or all coordinates where there are none."""
        declared = [o.name for o in self.at.system.outputs]
        selected = declared or list(self.at.names["q"])
        if names is not None:
            selected = listed("outputs", names, "height")
        rows, through = [], []
        none = (0,) * self.through.columns
        for name in selected:
            names_by_block = self.at.names
            if name in declared:
                rows.append(self.output_rows.row(declared.index(name)))
                through.append(self.through.row(declared.index(name)))
                continue
            through.append(none)
            if name in names_by_block["q"]:
                rows.append(self.places.row(names_by_block["q"].index(name)))
            elif name in names_by_block["u"]:
                rows.append(self.speeds.row(names_by_block["u"].index(name)))
            elif name in names_by_block["z"]:
                rows.append(self.inner.row(names_by_block["z"].index(name)))
            else:
                every = (
                    *declared,
                    *names_by_block["q"],
                    *names_by_block["u"],
                    *names_by_block["z"],
                )
                raise DerivationError(
                    f"linearize: there is no output, coordinate or speed '{name}'."
                    f"{near(name, every)}"
                )
        g, states = self.at.graph, self.speeds.columns
        C = Matrix(g, len(rows), states, [x for row in rows for x in row])
        return (
            C,
            Matrix(g, len(rows), len(none), [x for row in through for x in row]),
            tuple(selected),
        )
