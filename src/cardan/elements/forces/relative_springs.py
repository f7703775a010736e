"""Springs and dampers in the six relative directions of two frames."""

from __future__ import annotations

from dataclasses import dataclass

from ...ir.arithmetic import stumpff
from ...ir.graph import Graph
from ...ir.matrix import Matrix
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


def springs(at: Places, stiffness: Matrix, damping: Matrix, unloaded: Matrix) -> tuple[Action, ...]:
    """Actions of linear springs and dampers, (6, 6) each.

    Args:
        at: Its frames a and b.
        stiffness, damping: By the strain and its rate.
        unloaded: Strain without load (6, 1).
    """
    pose, actions = RelativePose.of(at), []
    if not stiffness.is_zero:
        y = pose.strain - unloaded
        stress = (stiffness @ y).note("stress")
        stored = potential(y.dot(stress) * 0.5, stiffness, unloaded)
        actions.append(Action(pose.loads(stress), (), *stored))
    if not damping.is_zero:
        stress = (damping @ pose.rate()).note("stress")
        actions.append(Action(pose.loads(stress)))
    return tuple(actions)


def spring_lines(strain: str, stress: str, fixed: bool) -> Lines:
    """Formulas of such springs.

    Args:
        strain: Its formula in theta and e.
        stress: Its formula in y and ydot.
        fixed: True where the springs have a potential.
    """
    rated = "ydot" in stress
    about = "stress, k the stiffness" + ", c the damping" * rated
    about += "; s_m and s_n moment and force of s"
    energy: Lines = (("potential energy", "V = dot(y, k @ y) / 2"),)
    y = ("strain" + ", y_0 that without load" * ("y_0" in strain), f"y = {strain}")
    return (*STRAIN, y, *RATES * rated, (about, f"s = {stress}"), *PULL, *energy * fixed)


def square(graph: Graph, entries: Matrix) -> Matrix:
    """The symmetric (6, 6) matrix of its diagonal (6, 1), or of its upper triangle (21, 1)."""
    zero, nodes = graph.const(0.0), tuple(entries.nodes)
    pairs = [(i, j) for i in range(6) for j in range(i, 6)]
    if len(nodes) == 6:
        nodes = tuple(nodes[i] if i == j else zero for i, j in pairs)
    number = {pair: k for k, pair in enumerate(pairs)}
    rows = [nodes[number[min(i, j), max(i, j)]] for i in range(6) for j in range(6)]
    return Matrix(graph, 6, 6, rows)
