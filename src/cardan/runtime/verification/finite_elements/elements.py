"""Functions of every kind of element, judged by each other and by laws that no element may break.

Tangents are differences of balances; balances are those of Lagrange's equations, of energies that
are judged by quadrature (:mod:`.shapes`); momenta follow from kinetic energies, what constraints
transmit from their rows.

Source: Lurie, Analytical Mechanics (2002), chapter 10, for speeds that are not rates.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

import numpy as np

from ....schema.finite_elements import PlaceKind
from ..differences import BLURRED, input_rates, missing, relative, ways, worst_of
from ..joint_motion import Array, cross, times
from ..rotations import quaternion
from . import element_events
from .members import NODE, Members, NotThere
from .shapes import ENERGIES, MOMENTA, STRESSES, quaternion_of

# inputs are shaken by this to see what rounding may do, and how many times
SHAKEN, LESS = 1e-14, 1e2
MOTION = 24  # numbers of the motion of a body of a tree
NO_LAW = "no law leads to it"
MATRICES = {"K": ("q", 0), "C": ("u", 0), "M": ("udot", 0), "R": ("q", 1), "G": ("u", 1)}


def check_kinds(members: Members) -> Iterator[tuple[str, float, str]]:
    """Name, error and reason of every function of a kind."""
    # what modes hold is judged in each of them
    modal, everywhere = "H" in members.table.kind.parts, members.in_all_modes
    for form in members.codes:
        at = everywhere if modal or form in element_events.LAWS else members
        error, why = _text(at, form), ""
        try:
            law = LAWS[form](at) if form in LAWS else NO_LAW
        except NotThere as missed:
            law = f"needs '{missed}'"
        if isinstance(law, str):
            why = law
        elif np.isnan(law):
            why = BLURRED
        else:
            error = worst_of(error, law)
        yield form, error, why


def _text(members: Members, form: str) -> float:
    """C against its expressions, of the largest entry, less what rounding of the inputs may do.

    NaN where expressions give no numbers.
    """
    expected = members.expressions(form)
    if expected is None:
        return np.nan
    results, good = members.call(form), np.isfinite(expected).all(axis=-1)
    if not good.any():
        return np.nan
    expected, results = expected[good], results[good]
    gap = np.nan_to_num(np.abs(results - expected), nan=np.inf)
    size = np.abs(expected).max(initial=0.0)
    if gap.max(initial=0.0) <= 1e-14 * size:
        return 0.0
    rng = np.random.default_rng(11)
    moved = {k: x * (1 + SHAKEN * rng.uniform(-1, 1, x.shape)) for k, x in members.inputs.items()}
    near = members.expressions(form, moved)
    rounding = LESS * np.abs((expected if near is None else near[good]) - expected).max(initial=0.0)
    return float(np.maximum(gap - rounding, 0.0).max(initial=0.0)) / (size or 1.0)


def _tangent(members: Members) -> float | str:
    """K, C, M, R and G."""
    kind, n = members.table.kind, members.count
    flat, worst, nu = members.call("balance_tangent"), np.nan, kind.nu
    for name, (letter, bound) in MATRICES.items():
        rows = kind.m if bound else nu
        at = kind.parts.get(name)
        values = np.zeros((n, rows, nu)) if at is None else flat[:, at : at + rows * nu]
        values = values.reshape(n, rows, nu)
        if not rows:
            continue
        ends = slice(nu + kind.mp, None) if bound else slice(0, nu)
        scale = np.abs(values).max(axis=(1, 2), initial=0.0)
        for way in ways(n, nu):
            rate = members.along(way) if letter == "q" else way
            slope, off = members.slope(lambda b: members.call("balance", b), {letter: rate})
            size = np.abs(members.call("balance")).max(axis=-1, initial=0.0)
            error = missing(slope[:, ends], off, times(values, way), scale, size * 1e-3)
            worst = worst_of(worst, error)
    return worst_of(worst, element_events.released(members)) if "H" in kind.parts else worst


def _rates(members: Members, moving: bool = True) -> dict[str, Array]:
    inputs = members.inputs
    rates = {"q": members.along(inputs["u"]), "t": np.ones((members.count, 1))}
    if inputs["r"].shape[-1]:
        rates["r"] = input_rates(members.model.inputs, inputs["r"])
    return rates | ({"u": inputs["udot"]} if moving else {})


def _gamma(members: Members) -> float | str:
    """G udot - gamma is the derivative of G u + g_t."""
    kind = members.table.kind
    ends = slice(kind.nu + kind.mp, None)
    drift, off = members.slope(lambda b: members.call("balance", b), _rates(members))
    product, _ = members.slope(lambda b: members.call("balance", b), {"u": members.inputs["udot"]})
    expected = product[:, ends] - drift[:, ends]
    return missing(expected, off, members.call("gamma"), drift[:, ends], product[:, ends])


def _balance(members: Members) -> float | str:
    """Rows of constraints and what their multipliers do; forces by energies and powers."""
    kind = members.table.kind
    value, worst, judges = members.call("balance"), np.nan, 0
    if kind.m:
        judges, worst = 1, _rows(members, value)
    # what an element has, compiled or not yet: where it has losses, energy alone is not its law
    forms = {"energy", "power", "zdot"} & set(kind.functions)
    if kind.m or not forms <= set(members.codes):
        return worst if judges else NO_LAW
    if members.plain and forms == {"energy"}:
        judges, worst = 1, worst_of(worst, _lagrange(members, value[:, : kind.nu]))
    if forms and "zdot" not in forms:
        judges, worst = 1, worst_of(worst, _ledger(members, value[:, : kind.nu]))
    return worst if judges else NO_LAW


def _rows(members: Members, value: Array) -> float:
    """G u + g_t is the derivative of g; b has -Gᵀ lam in it."""
    kind, inputs, n = members.table.kind, members.inputs, members.count
    nu, mp = kind.nu, kind.mp
    slope, off = members.slope(lambda b: members.call("balance", b), _rates(members, moving=False))
    rates = value[:, nu + mp :]
    worst = missing(slope[:, nu : nu + mp], off, rates[:, :mp], rates, np.abs(inputs["u"]))
    still = members.call("balance", {"lam": np.zeros((n, kind.m))})[:, :nu]
    constraint_forces = value[:, :nu] - still
    power = (constraint_forces * inputs["u"]).sum(axis=-1)
    # what depends on speeds in the rows, times the multipliers
    explicit_rates = members.call("balance", {"u": np.zeros((n, nu))})[:, nu + mp :]
    expected = -((rates - explicit_rates) * inputs["lam"]).sum(axis=-1)
    terms = constraint_forces * inputs["u"]
    return worst_of(worst, relative((power - expected)[:, None], terms, expected[:, None]))


def _lagrange(members: Members, force: Array) -> float:
    """b = d/dt dT/du + omega x dT/domega - X(T - V), along every speed."""
    inputs, nu = members.inputs, members.table.kind.nu
    n = members.count

    def energies(blocks: Mapping[str, Array]) -> Array:
        return members.call("energy", blocks)

    def momenta(blocks: Mapping[str, Array]) -> Array:
        return _momenta(members, energies, blocks)

    rates, off = members.slope(momenta, _rates(members))
    p, expected = momenta(inputs), rates.copy()
    for block, first in zip(members.blocks, members.starts[1], strict=False):
        if block.node and block.nq == NODE:
            turn = slice(first, first + 3)
            expected[:, turn] += cross(inputs["u"][:, turn], p[:, turn])
    for k in range(nu):
        unit = np.broadcast_to(np.eye(nu)[k], (n, nu))
        change, doubt = members.slope(energies, {"q": members.along(unit)})
        expected[:, k] -= change[:, 0] - change[:, 1]
        off = np.maximum(off, doubt)
    return missing(expected, off, force)


def _momenta(
    members: Members, energies: Callable[..., Array], blocks: Mapping[str, Array]
) -> Array:
    """dT/du: T is of second degree in the speeds, differences of which are exact."""
    u, columns = blocks["u"], []
    for k in range(u.shape[-1]):
        unit = np.eye(u.shape[-1])[k]
        both = [energies({**blocks, "u": u + sign * unit})[:, 0] for sign in (1.0, -1.0)]
        columns.append((both[0] - both[1]) / 2)
    return np.stack(columns, axis=-1)


def _ledger(members: Members, force: Array) -> float:
    """b . u is the rate of the energy less the power."""
    inputs, n = members.inputs, members.count
    work = (force * inputs["u"]).sum(axis=-1)
    expected, off, terms = np.zeros(n), np.zeros(n), [force * inputs["u"]]
    if "energy" in members.codes:
        slope, off = members.slope(lambda b: members.call("energy", b), _rates(members))
        expected, terms = slope.sum(axis=-1), [*terms, slope]
    if "power" in members.codes:
        power = members.call("power")
        expected, terms = expected - power.sum(axis=-1), [*terms, power]
    return missing(expected[:, None], off, work[:, None], *terms)


def _ends(members: Members) -> tuple[Array, Array, dict[str, Array]] | None:
    """Poses (n, 14) and speeds (n, 12) of both ends of a flexible element, and its data by name.

    Ends that are fixed to nodes, or to the ground, have their place among the data. None of
    elements that are not flexible, and of those in a plane.
    """
    name = members.table.kind.name
    if not any(name.startswith(kind) for kind in (*ENERGIES, *STRESSES)):
        return None
    if any(not block.node or block.nq != NODE for block in members.blocks):
        return None
    form = next(iter(members.codes.values())).symbol
    inputs = members.model._objects.saved()[form]["inputs"]
    names: list[str] = next((b["entries"] for b in inputs if b["name"] == "p"), [])
    data = {entry: members.inputs["p"][:, k] for k, entry in enumerate(names)}
    q, u, k = list[Array](), list[Array](), 0
    for end in ("start", "end"):
        attached = f"{end}_px" in data
        grounded = attached and _grounded(members, end, data)
        pose, speed = np.tile([1.0] + [0.0] * 6, (members.count, 1)), np.zeros((members.count, 6))
        if not grounded:
            pose = members.inputs["q"][:, 7 * k : 7 * k + 7]
            speed = members.inputs["u"][:, 6 * k : 6 * k + 6]
            k += 1
        if attached:
            pose, speed = _end_motion(pose, speed, end, data)
        q, u = [*q, pose], [*u, speed]
    return np.concatenate(q, axis=-1), np.concatenate(u, axis=-1), data


def _grounded(members: Members, end: str, data: Mapping[str, Array]) -> bool:
    """True when an end is fixed to the ground: the other one is the only node then."""
    other = "end" if end == "start" else "start"
    parts = members.table.kind.name.split("_")
    if len(members.blocks) == 2:
        return False
    return f"{other}_px" not in data or parts[-2 if end == "start" else -1] == "ground"


def _end_motion(
    pose: Array, speed: Array, end: str, data: Mapping[str, Array]
) -> tuple[Array, Array]:
    """Pose and speeds of a frame that is fixed to another."""
    n = len(pose)
    cells = [data[f"{end}_R{i}{j}"] for i in "123" for j in "123"]
    R = np.stack(cells, axis=-1).reshape(n, 3, 3)
    p = np.stack([data[f"{end}_p{x}"] for x in "xyz"], axis=-1)
    rotation = quaternion(pose[:, :4])
    place = pose[:, 4:] + times(rotation, p)
    back = np.swapaxes(R, -1, -2)
    moved = speed[:, 3:] + times(rotation, cross(speed[:, :3], p))
    end_pose = np.concatenate([quaternion_of(rotation @ R), place], axis=-1)
    return end_pose, np.concatenate([times(back, speed[:, :3]), moved], axis=-1)


def _energy(members: Members) -> float | str:
    """By quadrature of strain measures and of point masses, and by what it does."""
    law, ends = _balance(members), _ends(members)
    names = [name for name in ENERGIES if members.table.kind.name.startswith(name)]
    energies = ENERGIES[max(names, key=len)](*ends) if ends and names else None
    if energies is None:
        return law
    error = relative(members.call("energy") - energies, energies)
    return error if isinstance(law, str) else max(error, law)


def _momentum(members: Members) -> float | str:
    """dT/dv, and its moment with dT/domega; of points along the shape where an end is held."""
    ends = _ends(members)
    names = [name for name in MOMENTA if members.table.kind.name.startswith(name)]
    value = members.call("momentum")
    if ends and names:
        expected = MOMENTA[max(names, key=len)](*ends)
        return relative(value - expected, expected)
    in_space = [_in_space(block) for block in members.blocks]
    # what carries a rigid tree moves all of it
    on_node = "bodies" in members.table.kind.functions and sum(in_space) == 1
    if not (all(in_space) or on_node):
        return "its places are not nodes in space"
    if "ground" in members.table.kind.name:
        return NO_LAW
    p = _momenta(members, lambda b: members.call("energy", b), members.inputs)
    expected = np.zeros((members.count, 6))
    for a, b, here in zip(*members.starts, in_space, strict=False):
        if not here:
            continue
        q = members.inputs["q"][:, a : a + NODE]
        linear_part = times(quaternion(q[:, :4]), p[:, b : b + 3])
        linear = p[:, b + 3 : b + 6]
        expected += np.concatenate([linear_part + cross(q[:, 4:], linear), linear], axis=-1)
    return relative(value - expected, expected, p)


def _reaction(members: Members) -> float | str:
    """The multipliers put it on a node."""
    n, kind = members.count, members.table.kind
    still = members.call("balance", {"lam": np.zeros((n, kind.m))})
    constraint_forces = members.call("balance")[:, : kind.nu] - still[:, : kind.nu]
    return _on_node(members, constraint_forces, members.call("reaction"))


def _element_forces(members: Members) -> float | str:
    """The element puts it on a node: a wrench, a force along a line, or what drives a joint."""
    if "M" in members.table.kind.parts:
        return "what it does to nodes is its inertia too"
    value = members.call("element_forces")
    # without what modes hold
    force = members.call("balance", {"lam": 0 * members.inputs["lam"]})[:, : members.table.kind.nu]
    if value.shape[-1] == 6:
        # force first there, moment first in reactions
        return _on_node(members, force, value[:, [3, 4, 5, 0, 1, 2]])
    if value.shape[-1] > 1:
        return "it drives several speeds at once"
    blocks = zip(members.blocks, members.starts[1], strict=False)
    parts = [
        force[:, part]
        for block, b in blocks
        for part in ((slice(b, b + 3), slice(b + 3, b + 6)) if _in_space(block) else ())
    ]
    kind = members.table.kind
    if not parts and "reactions" not in kind.functions:
        # on a joint itself, not on bodies that it carries
        parts = [force[:, :1]] if kind.nu == 1 else []
    # along a line or a slider the node feels the force itself, on an axle the moment alone
    norms = [np.linalg.norm(part, axis=-1, keepdims=True) for part in reversed(parts)]
    pushed = [norm for norm in norms if norm.any()]
    if not norms:
        return "it acts on no nodes in space"
    norm = pushed[0] if pushed else norms[0]
    return relative(np.abs(value) - norm, value)


def _in_space(block: PlaceKind) -> bool:
    return bool(block.node) and block.nq == NODE


def _on_node(members: Members, generalized: Array, wrench: Array) -> float | str:
    """Force of a wrench, and moment along it, are those of generalized forces on a node."""
    nodes = [
        (a, b)
        for block, a, b in zip(members.blocks, *members.starts, strict=False)
        if _in_space(block)
    ]
    if not nodes:
        return "it acts on no nodes in space"
    a, b = nodes[-1]
    moment = times(quaternion(members.inputs["q"][:, a : a + 4]), generalized[:, b : b + 3])
    force = generalized[:, b + 3 : b + 6]
    size = np.abs(wrench).max(axis=-1, keepdims=True)
    norms = [np.linalg.norm(x, axis=-1) for x in (force, wrench[:, 3:])]
    along = [(x * y).sum(axis=-1) for x, y in ((moment, force), (wrench[:, :3], wrench[:, 3:]))]
    first = relative((norms[0] - norms[1])[:, None], size)
    # the moment about any point has the same part along the force, whichever end it acts on
    gap = np.abs(np.abs(along[0]) - np.abs(along[1]))
    return max(first, relative(gap[:, None], size * size))


def _bodies(members: Members) -> float | str:
    """Velocities are the rates of poses, accelerations those of velocities."""

    def parts(values: Array) -> tuple[Array, Array, Array, Array]:
        rows = values.reshape(members.count, -1, MOTION)
        return rows[..., :9], rows[..., 9:12], rows[..., 12:18], rows[..., 18:]

    value = members.call("bodies")
    slope, off = members.slope(lambda b: members.call("bodies", b), _rates(members))
    (R, _, velocity, acceleration), rates = parts(value), parts(slope)
    axes = np.moveaxis(R.reshape(*R.shape[:-1], 3, 3), -1, 0)
    turned = np.stack([cross(velocity[..., :3], axis) for axis in axes], axis=-1)
    pairs = (
        (rates[0], turned.reshape(R.shape)),
        (rates[1], velocity[..., 3:]),
        (rates[2], acceleration),
    )
    flat = [(a.reshape(members.count, -1), b.reshape(members.count, -1)) for a, b in pairs]
    return max(missing(expected, off, result) for expected, result in flat)


def _mixed(members: Members) -> float | str:
    """With the stress that there is: the balance and its tangent."""
    none = {"du": np.zeros_like(members.inputs["du"])}
    z = members.call("mixed_step", none)
    value = members.call("mixed", {"z": z})
    expected = np.concatenate([members.call("balance"), members.call("balance_tangent")], axis=-1)
    nu = members.table.kind.nu
    parts = (slice(0, nu), slice(nu, None))
    return max(relative(value[:, part] - expected[:, part], expected[:, part]) for part in parts)


def _mixed_step(members: Members) -> float | str:
    """The stress that there is comes from any; small increments lead to that behind them."""
    du = members.inputs["du"]
    none = {"du": np.zeros_like(du)}
    z = members.call("mixed_step", none)
    again = members.call("mixed_step", {**none, "z": z})
    worst = relative(again - z, z, members.inputs["z"])

    def settled(blocks: Mapping[str, Array]) -> Array:
        return members.call("mixed_step", {**blocks, "du": np.zeros_like(blocks["du"])})

    slope, off = members.slope(settled, {"q": members.along(du)})
    step = members.call("mixed_step", {"z": z}) - z
    return worst_of(worst, missing(slope, off, step, z * 1e-3))


def _stress(members: Members) -> float | str:
    """By quadrature of strain measures."""
    ends = _ends(members)
    names = [name for name in STRESSES if members.table.kind.name.startswith(name)]
    expected = STRESSES[max(names, key=len)](ends[0], ends[2]) if ends and names else None
    if expected is None:
        return NO_LAW
    value = members.call("stress").reshape(members.count, 4, 6)
    return max(relative(value[:, k] - expected[:, k], expected[:, k]) for k in range(4))


LAWS: dict[str, Callable[[Members], Any]] = {
    "balance": _balance,
    "balance_tangent": _tangent,
    "gamma": _gamma,
    "energy": _energy,
    "power": lambda members: _balance(members),
    "momentum": _momentum,
    "reaction": _reaction,
    "element_forces": _element_forces,
    "bodies": _bodies,
    "mixed": _mixed,
    "mixed_step": _mixed_step,
    "stress": _stress,
    **element_events.LAWS,
}
