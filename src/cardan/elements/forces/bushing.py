"""A bushing: springs and dampers in six directions between two frames."""

from __future__ import annotations

from typing import ClassVar

from ...errors import ModelError
from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ...records import dataclass
from ..formulas import Lines, Shapes
from ..internal_states import Internal
from ..limits import Limit, positive
from ..quantity import Curves, Place, Quantity, Rows
from ..validation import vector
from .bushing_laws import (
    STRAIN,
    Branch,
    branch,
    branches_of,
    matrix_quantity,
    six_by_six,
    tables_by_direction,
)
from .force import Action, ForceElement, Places, constant
from .relative_springs import (
    DIRECTIONS,
    SHAPES,
    RelativePose,
    SpringLaw,
    spring_lines,
    springs,
    square,
)


@dataclass(frozen=True)
class Bushing(ForceElement):
    """Springs and dampers in all six relative directions of two frames, coupled as one likes.

    Strain ``y`` is the rotation vector of frame b seen from frame a, and their distance in the axes
    halfway between them, less ``rest``; both ends are treated alike, at angles up to half a turn.
    The order is rx, ry, rz, x, y, z: rotations before displacements. The stress is ``k y``, what
    the tables say at y, ``c dy/dt``, and what the branches bear; it pulls the frames together
    where it is positive. Springs and tables have a potential: ``y·k y / 2`` and the integrals of
    the tables from 0 on. What dampers and branches take, store and give back is their work in the
    ledger.

    A branch is a spring in series with a damper, ``stress = K (y - z)`` with ``dz/dt = (y - z) /
    time``. The strain z of its damper is a state ``<name>.branches.0.x`` for every direction in
    which K is not zero, and 0 at the start of a run. An equilibrium is relaxed: z = y.

    Args:
        frame_a, frame_b: Frames or bodies at its ends; they coincide without load unless ``rest``
            says otherwise.
        stiffness: Six numbers, or a symmetric 6x6 matrix [N m/rad, N/m; N between them].
        damping: The same of the rate of the strain [N m s/rad, N s/m; N s between them].
        rest: Strain without load (6) [rad, m].
        tables: Direction -> :func:`cardan.table` of the moment or force over the strain
            [N m over rad, N over m]; it adds to the stiffness. Beyond its ends a table continues
            its first and last piece.
        branches: Pairs of a stiffness, as above, and a relaxation time [s]; or one such pair.

    Raises:
        ModelError: other than six numbers or a symmetric 6x6 matrix; an unknown direction, or what
            is not a table; a branch without stiffness, or with a negative one or a relaxation time
            not above 0.

    Source: Géradin and Cardona, Flexible Multibody Dynamics (2001), section 7.7; Masarati and
        Morandini, Multibody System Dynamics 24 (2010) for the halfway axes; Christensen, Theory of
        Viscoelasticity (1982), chapter 1, for branches.
    """

    kind: ClassVar[str] = "bushing"
    symbol_shapes: ClassVar[Shapes] = SHAPES
    frame_a: Place
    frame_b: Place
    stiffness: Rows = (0, 0, 0, 0, 0, 0)
    damping: Rows = (0, 0, 0, 0, 0, 0)
    rest: Rows = (0, 0, 0, 0, 0, 0)
    tables: Curves = ()
    branches: Rows = ()

    def __post_init__(self) -> None:
        for name in ("stiffness", "damping"):
            object.__setattr__(self, name, six_by_six(name, getattr(self, name)))
        object.__setattr__(self, "rest", vector("bushing", "rest", self.rest, 6))
        object.__setattr__(self, "tables", tables_by_direction(self.tables))
        object.__setattr__(self, "branches", branches_of(self.branches))
        super().__post_init__()

    def quantities(self) -> dict[str, Quantity]:
        listed = {
            "stiffness": matrix_quantity(self.stiffness),
            "damping": matrix_quantity(self.damping, "*s"),
            "rest": Quantity(self.rest, labels=DIRECTIONS, units=STRAIN),
        }
        for n, (stiffness, time) in enumerate(self.branches):
            listed[f"branches.{n}.stiffness"] = matrix_quantity(stiffness)
            listed[f"branches.{n}.time"] = Quantity(time, "s")
        return listed

    def limits(self) -> tuple[Limit, ...]:
        return positive(*(f"branches.{n}.time" for n in range(len(self.branches))))

    def linear(self) -> tuple[str, ...]:
        return ("stiffness", "damping")

    def paired(self) -> bool:
        return True

    def internals(self) -> tuple[Internal, ...]:
        return tuple(
            Internal(f"branches.{n}.{DIRECTIONS[k]}", STRAIN[k])
            for n, one in enumerate(self._branches())
            for k in one.directions
        )

    def rates(self, at: Places) -> Matrix:
        if not self.branches:
            return at.z
        y = RelativePose.of(at).strain - at.data["rest"]
        rates = [
            (y[k] - flow[k]) / at.data[f"branches.{n}.time"][0]
            for n, (one, flow) in enumerate(zip(self._branches(), self._flows(at), strict=True))
            for k in one.directions
        ]
        return Matrix.vector(at.motion.graph, rates)

    def act(self, at: Places) -> tuple[Action, ...]:
        return springs(at, self._law(at))

    def formulas(self, at: Places) -> Lines:
        law = self._law(at)
        named = (("stiffness", "k @ y"), ("damping", "c @ ydot"))
        terms = tuple(term for name, term in named if not at.data[name].is_zero)
        if not (terms or law.tables or law.branches):
            return ()
        lines = spring_lines(law, terms, not at.data["rest"].is_zero)
        rates = [f"zdot_{n} = (y - z_{n}) / tau_{n}" for n in range(len(law.branches))]
        about = "rate of the strain of the damper, where the branch has stiffness; tau its time"
        return (*lines, *((about, rate) for rate in rates))

    def _law(self, at: Places) -> SpringLaw:
        graph, data = at.motion.graph, at.data
        matrices = [
            square(graph, data[f"branches.{n}.stiffness"]) for n, _ in enumerate(self.branches)
        ]
        return SpringLaw(
            square(graph, data["stiffness"]),
            square(graph, data["damping"]),
            data["rest"],
            constant(data["stiffness"], data["rest"]),
            tuple((DIRECTIONS.index(name), points.data) for name, points in self.tables),
            tuple(zip(matrices, self._flows(at), strict=True)),
        )

    def _branches(self) -> tuple[Branch, ...]:
        return tuple(branch(*pair) for pair in self.branches)

    def _flows(self, at: Places) -> list[Matrix]:
        """Strains of the dampers of all branches (6, 1), 0 in directions without a state.

        Raises:
            ModelError: a stiffness that was written as 0 got another value.
        """
        flows, states = [], iter(at.z)
        for n, one in enumerate(self._branches()):
            entries = list(Matrix.zeros(at.motion.graph, 6))
            for k in one.directions:
                entries[k] = next(states)
            stiffness = square(at.motion.graph, at.data[f"branches.{n}.stiffness"])
            for k in set(range(6)).difference(one.directions):
                if any(node != ZERO for node in stiffness.row(k)):
                    raise ModelError(
                        f"bushing: branches[{n}].stiffness is 0 in direction {DIRECTIONS[k]} as "
                        "written, and has no state there; write the number that it is to be"
                    )
            flows.append(Matrix.vector(at.motion.graph, entries))
        return flows
