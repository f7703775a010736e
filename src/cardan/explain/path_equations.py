"""Equations whose solutions are a path, the conditions of its special points, and its steps."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import singledispatch

from ..analyses.continuation import follow
from ..analyses.continuation.configurations import COORDINATE
from ..analyses.continuation.curve import Curve
from ..analyses.continuation.equilibrium_solutions import EquilibriumSolutions
from ..analyses.continuation.position_solutions import PositionSolutions
from ..analyses.continuation.solutions import Solutions
from ..analyses.continuation.special_points import BRANCH, EVENT, FOLD, HOPF
from ..analyses.cycles.cycle_solutions import STILL, TORUS, CycleSolutions
from ..analyses.cycles.cycle_starts import DOUBLING
from ..equations.reading.typesetting import typeset
from ..errors import counted
from . import content as d

EQUALS = d.Written("<mo>=</mo>", "=", "=")
# the rate of the parameter along the curve, which no formula of elements has
RATE = d.Written(
    "<mfrac><mrow><mi>d</mi><mi>σ</mi></mrow><mrow><mi>d</mi><mi>s</mi></mrow></mfrac>",
    r"\frac{d\sigma}{ds}",
    "dsigma / ds",
)


def formula(expression: str) -> d.Text:
    """An expression within a line, in pieces between which the line may end."""
    segments = list[d.Inline]()
    for segment in typeset(expression):
        segments += [d.Written(segment.mathml, segment.latex, segment.text), " "]
    return tuple(segments[:-1])


def equation(left: str, right: str) -> d.Text:
    """left = right within a line; either side may be any expression."""
    return (*formula(left), " ", EQUALS, " ", *formula(right))


@singledispatch
def equations(of: Solutions) -> Iterator[d.Block]:
    """The equations that a path of solutions fulfills.

    Raises:
        TypeError: they are of a kind that has no page.
    """
    raise TypeError(f"there is no page on {of.kind}")


@equations.register(EquilibriumSolutions)
def _(of: EquilibriumSolutions) -> Iterator[d.Block]:
    """Balance of forces, closed loops, internal states at rest, what is held."""
    family = of.family
    system, way = family.problem.system, family.way
    moving = way.base.u is not None
    locked = [*way.base.locked, *(n for n, kind in way.kinds.items() if kind == "locked")]
    yield d.Paragraph((f"{'A steady motion' if moving else 'An equilibrium'} is where",))
    forces = "f" + " + G.T @ lam" * bool(system.multipliers) + " + tau" * bool(locked)
    said = (
        ": forces balance. h are velocity products and gravity, f the applied forces of the "
        "model: springs, loads, controllers"
    )
    many = counted(len(system.multipliers), "multiplier")
    loops = f": loops are closed. G is the Jacobian of these conditions, λ has {many}"
    places = f": what is held has its values: {', '.join(locked)}. The forces τ hold it there"
    rows_of = (
        (True, "M @ udot + h" if moving else "h", forces, said),
        (system.multipliers, "g", "0", loops),
        (system.internals, "zdot", "0", f": internal states rest: {', '.join(system.internals)}"),
        (locked, "q_k", "c_k", places),
    )
    items: list[d.Text] = [(*equation(a, b), text) for present, a, b, text in rows_of if present]
    if moving:
        said = (
            "the speeds u that are named have their values, as seen by an observer who turns "
            "along; the others and their rates follow from the position"
        )
        items.append((said,))
    yield d.Listing(tuple(items))
    yield _load()
    if family.free.shape[1]:
        many = counted(family.free.shape[1], "direction")
        said = f"Nothing resists {many} at the start. Along them positions stay as they are."
        yield d.Paragraph((said,))
    rows = (
        ("motion: radians, lengths in sizes", len(system.columns), family.weights[0]),
        ("internal states", len(system.internals), family.weights[0]),
        ("constraint forces and holding forces", len(system.multipliers) + len(locked), 0.0),
        ("place σ of the load", 1, 1.0),
    )
    yield from _unknowns(rows, system.size)


@equations.register(PositionSolutions)
def _(of: PositionSolutions) -> Iterator[d.Block]:
    """Conditions of loops, drivers and locks, or combinations of them."""
    family, drivers, count = of.family, of.family.drivers, of.family.positions
    conditions = len(drivers.slopes)
    yield d.Paragraph(("A position is where",))
    said = f": {counted(conditions, 'condition')} for {counted(count, 'motion')} of the joints"
    more = (
        f", some of which follow from others. C holds {counted(count, 'combination')} of them, "
        "orthonormal, carried along the path"
    ) * (conditions != count)
    items: list[d.Text] = [(*equation("C.T @ g" if more else "g", "0"), said + more)]
    items.append(("g contains the closure of the loops",))
    if drivers.locked:
        items.append((f"what is locked, and stays: {', '.join(drivers.locked)}",))
    driven = drivers.named(COORDINATE)
    if driven:
        said = f": what drives, from a to b: {', '.join(driven)}"
        items.append((*equation("q_k", "(1 - sigma) * a + sigma * b"), said))
    yield d.Listing(tuple(items))
    yield _load()
    rows = (
        ("motion: radians, lengths in sizes", count, 1.0),
        ("place σ of the drivers", 1, family.weights[-1]),
    )
    yield from _unknowns(rows, drivers.m.size)


@equations.register(CycleSolutions)
def _(of: CycleSolutions) -> Iterator[d.Block]:
    """Shooting: the state behind a lap is the one before it."""
    family, problem = of.family, of.family.problem
    image = problem.symmetry is not None
    yield d.Paragraph(("A cycle is where",))
    behind = " up to the symmetry S" * image
    laps = f" {counted(problem.laps, 'lap')}" if problem.laps > 1 else " a lap"
    said = f": the state behind{laps} is that at its start{behind}. Laps are runs of the model"
    items: list[d.Text] = [(*equation("S(x_T)" if image else "x_T", "x_0"), said)]
    if problem.section is not None:
        items.append((f"a lap ends at the event '{problem.section.name}', behind what it changes",))
    elif problem.period is not None:
        items.append(("a lap lasts for the period T that is known",))
    else:
        said = ": the period T is unknown, and this chooses the start of the lap along the cycle"
        items.append((*equation("c.T @ (x_0 - x_p)", "0"), said))
    if problem.level is not None:
        said = ": energy is kept. This takes the place of what is missed along its gradient"
        items.append((*equation("E(x_0)", "E_p"), said))
    yield d.Listing(tuple(items))
    yield _load()
    how = problem.how
    yield d.Paragraph(
        (f"Runs: {how.method.name}, rtol={how.rtol:g}, atol={how.atol:g}; derivatives are "
         "differences of runs, through all events. Multipliers μ are the eigenvalues of the "
         "derivative of ", *formula("x_T"), " by ", *formula("x_0"), ".")
    )  # fmt: skip
    rows = (
        ("state, in ranges of the motion", len(problem.units), family.weights[0]),
        ("period, as a part of itself", int(problem.free_period), 1.0),
        ("place σ of what is swept", 1, 1.0),
    )
    yield from _unknowns(rows, None)


def _load() -> d.Block:
    """The swept quantity, as an unknown."""
    said = (
        ": what is swept has its first values where σ = 0 and its last ones where σ = 1, and goes "
        "straight on beyond. σ is an unknown like the others, so that it may turn back. There is "
        "one unknown more than there are equations: solutions are curves."
    )
    return d.Paragraph(("All this at ", *equation("p", "(1 - sigma) * p_0 + sigma * p_1"), said))


def _unknowns(rows: tuple[tuple[str, int, float], ...], size: float | None) -> Iterator[d.Block]:
    """Unknowns, and how much they count in the length of the curve."""
    present = tuple((name, float(n), float(weight)) for name, n, weight in rows if n)
    yield d.Table(("unknown", "number", "weight in the length"), present)
    if size is not None:
        yield d.Paragraph((f"The size of the system is {size:.6g} m.",), quiet=True)


def steps(curve: Curve) -> Iterator[d.Block]:
    """Length of the curve, a step along it, and what controls it."""
    reach = curve.reach
    yield d.Paragraph(
        ("Along the curve its length s is measured, with increments dz of all unknowns without "
         "units and the weights w of the table: ",
         *equation("ds**2", "total(k, 1, N, w_k * dz_k**2)"), ".")
    )  # fmt: skip
    yield d.Listing(
        (
            ("A step of length ds goes along the tangent t: ", *equation("z", "z_0 + ds * t"), "."),
            (
                "Newton's method corrects across it: ", *equation("J @ dz", "-r"), ", ",
                *equation("t.T @ W @ dz", "0"), ", J the derivative of the equations, r what they "
                "leave, W the weights.",
            ),
            (
                f"Lengths are chosen for a contraction of {follow.CONTRACTION:g} in these "
                f"corrections and a turn of the tangent by {follow.TURN:g} rad, and double at "
                "most. A step is halved where the tangent turns by more than "
                f"{follow.SHARP:g} rad, corrections fail, or it seems to lead to another curve.",
            ),
            (
                f"The first step is {reach.first:g} long, the longest {reach.longest:g}; the curve "
                f"ends where one of {reach.shortest:g} fails.",
            ),
        )
    )  # fmt: skip


CONDITIONS: Mapping[str, d.Text] = {
    FOLD: (
        "Fold: ", RATE, " ", EQUALS, " 0. What is swept is stationary along the curve. The "
        "derivative of the equations by all other unknowns is singular there: its null vector is "
        "the tangent of the curve.",
    ),
    BRANCH: (
        "Branch point: J, the derivative of the equations by all unknowns, loses its rank. Where k "
        "of it are lost, the null space has k + 1 directions, and more than one curve passes. "
        "Branches leave where the equations, reduced to that space, vanish on a small sphere "
        "around the point.",
    ),
    HOPF: (
        "Hopf point: a pair of eigenvalues of small motions is imaginary, ", *formula("i * omega"),
        " and ", *formula("-i * omega"), ". The oscillation decays on one side and grows on the "
        "other.",
    ),
    DOUBLING: (
        "Period doubling: a multiplier is ", *equation("mu", "-1"), ". Disturbances change their "
        "side from lap to lap, and neither grow nor decay.",
    ),
    TORUS: (
        "Torus point: a complex pair of multipliers has the modulus 1. Disturbances turn from lap "
        "to lap, and neither grow nor decay.",
    ),
    STILL: ("State of rest: the amplitude is 0. Behind it the same cycles follow, mirrored.",),
    EVENT: (
        "Event: a value that was asked for is passed, or an element changes its mode: a stop, a "
        "latch, friction. Behind the latter the equations are others, and the curve has a corner.",
    ),
}  # fmt: skip
OF_CYCLES: Mapping[str, d.Text] = {
    FOLD: (*CONDITIONS[FOLD], " There a multiplier is ", *equation("mu", "1"), ".")
}


def condition(kind: str, of: Solutions) -> d.Text:
    """The condition that defines a kind of special points."""
    more = OF_CYCLES if isinstance(of, CycleSolutions) else {}
    return more.get(kind) or CONDITIONS.get(kind, (kind,))


SOURCES = (
    "H. B. Keller, Applications of Bifurcation Theory (1977), 359-384: paths by their length",
    "R. Seydel, Practical Bifurcation and Stability Analysis (2010): steps, special points, cycles",
    "W. Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria (2000): branch points",
)
