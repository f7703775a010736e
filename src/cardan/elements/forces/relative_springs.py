"""Springs and dampers in the six relative directions of two frames."""

from __future__ import annotations

from ...ir.arithmetic import Scalar, stumpff
from ...ir.graph import Graph
from ...ir.matrix import Matrix
from ...ir.table import Table
from ...records import dataclass
from ...spatial.exponential import exp, log, tangent
from ..formulas import HALFWAY, MEASURES, TANGENT, Lines, Shapes
from .force import Action, Load, Places, potential

SHAPES: Shapes = {"y_0": (6, 1), "k": ("symmetric", 6)}
DIRECTIONS = ("rx", "ry", "rz", "x", "y", "z")
STRAIN: Lines = (
    ("rotation of b seen from a", "r = R_a.T @ R_b"),
    ("its rotation vector", "theta = rotation_vector(r)"),
    ("position of b seen from a", "d = R_a.T @ (p_b - p_a)"),
    ("square of the angle", "x = dot(theta, theta)"),
    ("coefficient of the tangent operator", "a = (1 - sqrt(x) / 2 * cot(sqrt(x) / 2)) / x"),
    *HALFWAY,
    *MEASURES,
    *TANGENT,
)  # fmt: skip
RATES: Lines = (
    ("rates", "thetadot = D @ (omega_b - r.T @ omega_a)"),
    ("", "ddot = R_a.T @ (v_b - v_a) - skew(omega_a) @ d"),
    ("rate of the strain", "ydot = column(thetadot, N @ thetadot + U @ ddot)"),
)
PULL: Lines = (
    ("moment in axes of b, force in axes of a", "m = D.T @ (s_m + N.T @ s_n)"),
    ("", "f = U.T @ s_n"),
    ("moments and forces on a and on b", "M_b = -(R_b @ m)"),
    ("", "F_b = -(R_a @ f)"),
    ("", "M_a = R_b @ m + skew(p_b - p_a) @ R_a @ f"),
    ("", "F_a = R_a @ f"),
)


@dataclass(frozen=True)
class RelativePose:
    """The pose of frame b seen from frame a, as a strain.

    Attributes:
        at: Its frames a and b.
        position: d (3, 1), from a to b in axes of a.
        rotation: r (3, 3), coordinates in axes of b to those of a.
        strain: theta and e (6, 1): rotation vector, and distance in the axes halfway between.
        halfway: U (3, 3): e = U d.
        slope: D (3, 3): theta changes by D rho, rho in axes of b.
        bend: N (3, 3): e changes by N times the change of theta, and by U times that of d.
    """

    at: Places
    position: Matrix
    rotation: Matrix
    strain: Matrix
    halfway: Matrix
    slope: Matrix
    bend: Matrix

    @staticmethod
    def of(at: Places) -> RelativePose:
        """Of the frames a and b of an element.

        ``y = theta, e: exp[theta] = R_aᵀ R_b, e = exp[-theta/2] R_aᵀ (p_b - p_a)``
        """
        motion, graph = at.motion, at.motion.graph
        a, b = at.frames["a"], at.frames["b"]
        one = Matrix.identity(graph, 3)
        columns = [motion.in_frame(one.column(k), b, a) for k in range(3)]
        rotation = Matrix.hstack(*columns).note("relative_rotation")
        turn, position = log(rotation).note("theta"), (-motion.arm(b, a)).note("d")
        halfway = exp(turn * 0.5).T.note("U")
        e = (halfway @ position).note("e")
        # a of the inverse tangent operator, by functions of a quarter of |theta|²
        x = turn.dot(turn)
        quarter = x * 0.25
        a_of_x = (stumpff(2, quarter) - stumpff(3, quarter)) / (4.0 * stumpff(1, quarter))
        twice = turn.outer(turn) - one * x
        slope = (one + turn.skew * 0.5 + twice * a_of_x).note("D")
        bend = (e.skew @ tangent(turn * 0.5) * 0.5).note("N")
        return RelativePose(at, position, rotation, Matrix.vstack(turn, e), halfway, slope, bend)

    def rate(self) -> Matrix:
        """Rate of the strain (6, 1)."""
        motion, a, b = self.at.motion, self.at.frames["a"], self.at.frames["b"]
        spin = motion.spin(a)
        rotating = self.slope @ (motion.spin(b) - self.rotation.T @ spin)
        separating = motion.in_frame(motion.velocity(b) - motion.velocity(a), 0, a)
        moving = self.halfway @ (separating - spin.cross(self.position))
        return Matrix.vstack(rotating.note("thetadot"), self.bend @ rotating + moving)

    def loads(self, stress: Matrix) -> tuple[Load, Load]:
        """What a stress (6, 1) along the strain does on a and on b, in axes of a."""
        a, b = self.at.frames["a"], self.at.frames["b"]
        moment, force = stress.block(slice(0, 3)), stress.block(slice(3, 6))
        moment = self.rotation @ (self.slope.T @ (moment + self.bend.T @ force))
        force = (self.halfway.T @ force).note("force")
        on_a = moment.note("moment") + self.position.cross(force)
        return Load(a, on_a, force, a), Load(b, -moment, -force, a)


@dataclass(frozen=True)
class SpringLaw:
    """The stress by the strain, its rate and states.

    Attributes:
        stiffness, damping: By the strain and its rate (6, 6).
        unloaded: Strain without load (6, 1); the strain counts from there.
        fixed: True where the springs have a potential.
        tables: Curves that add to the stress in single directions, by their numbers.
        branches: Springs in series with dampers: stiffness (6, 6) and strain of the damper (6, 1).
    """

    stiffness: Matrix
    damping: Matrix
    unloaded: Matrix
    fixed: bool
    tables: tuple[tuple[int, Table], ...] = ()
    branches: tuple[tuple[Matrix, Matrix], ...] = ()

    @property
    def stores(self) -> bool:
        """True where there is a potential."""
        return self.fixed and not (self.stiffness.is_zero and not self.tables)


def springs(at: Places, law: SpringLaw) -> tuple[Action, ...]:
    """Actions of springs and dampers between the frames a and b of an element."""
    pose, actions = RelativePose.of(at), []
    y = pose.strain - law.unloaded
    if not law.stiffness.is_zero or law.tables:
        linear = law.stiffness @ y
        stress = (linear + _read(y, law.tables)).note("stress")
        energy = y.dot(linear) * 0.5
        for direction, table in law.tables:
            energy = energy + _value(y, direction, table.integral())
        stored = potential(energy, law.stiffness, law.unloaded)
        actions.append(Action(pose.loads(stress), (), *stored))
    # what gives heat, and what is given back later
    terms = [stiffness @ (y - flow) for stiffness, flow in law.branches]
    if not law.damping.is_zero:
        terms.insert(0, law.damping @ pose.rate())
    if terms:
        actions.append(Action(pose.loads(sum(terms[1:], terms[0]).note("stress"))))
    return tuple(actions)


def _read(y: Matrix, tables: tuple[tuple[int, Table], ...]) -> Matrix:
    """Stress by the tables (6, 1)."""
    stress = list(Matrix.zeros(y.graph, 6))
    for direction, table in tables:
        stress[direction] = _value(y, direction, table)
    return Matrix.vector(y.graph, stress)


def _value(y: Matrix, direction: int, table: Table) -> Scalar:
    return Scalar(y.graph, y.graph.interpolate(table, y[direction].node))


def spring_lines(law: SpringLaw, terms: tuple[str, ...], subtracted: bool = False) -> Lines:
    """Formulas of such springs.

    Args:
        law: What they are.
        terms: Formulas of parts of the stress in y and ydot, beside those of tables and branches.
        subtracted: True where the strain without load is subtracted.
    """
    rated = any("ydot" in term for term in terms)
    about = "stress, k the stiffness" + ", c the damping" * rated
    about += ", t what the tables say at y" * bool(law.tables)
    terms += ("t",) * bool(law.tables)
    if law.branches:
        about += "; K the stiffness and z the flow of a branch"
        terms += tuple(f"K_{n} @ (y - z_{n})" for n in range(len(law.branches)))
    about += "; s_m and s_n moment and force of s"
    stored = [x for x in ("dot(y, k @ y) / 2" * (not law.stiffness.is_zero), "W" * bool(law.tables))
              if x]  # fmt: skip
    about_energy = "potential energy" + ", W the integrals of the tables over y" * bool(law.tables)
    energy: Lines = ((about_energy, f"V = {' + '.join(stored)}"),)
    strain = "y = column(theta, e)" + " - y_0" * subtracted
    y = ("strain" + ", y_0 that without load" * subtracted, strain)
    stress = (about, f"s = {' + '.join(terms)}")
    # what energies read stands before them, and stresses need not
    return (*STRAIN, y, *energy * law.stores, *RATES * rated, stress, *PULL)


def square(graph: Graph, entries: Matrix) -> Matrix:
    """The symmetric (6, 6) matrix of its diagonal (6, 1), or of its upper triangle (21, 1)."""
    zero, nodes = graph.const(0.0), tuple(entries.nodes)
    pairs = [(i, j) for i in range(6) for j in range(i, 6)]
    if len(nodes) == 6:
        nodes = tuple(nodes[i] if i == j else zero for i, j in pairs)
    number = {pair: k for k, pair in enumerate(pairs)}
    rows = [nodes[number[min(i, j), max(i, j)]] for i in range(6) for j in range(6)]
    return Matrix(graph, 6, 6, rows)
