"""Assembly and kinematic analysis, by the constraints alone or by least strain energy."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

from numpy.typing import ArrayLike

from ...arguments import Count, LockedValues, Seed, checked
from ...errors import ModelError, SolveError, SolveWarning, warn
from ...runtime.calls.evaluation import State
from ...runtime.models.loaded_model import LoadedModel
from ..simulation.progress import showing
from .assemble import STARTS, assemble_by_constraints
from .assembly import AssemblyRecord
from .strained_positions import assemble_by_strain_energy, sweep_by_strain_energy
from .sweep import FASTEST, SweepRecord, sweep_by_constraints

CONSTRAINTS, STRAIN_ENERGY = "constraints", "strain_energy"


@checked
def assemble(
    model: LoadedModel,
    targets: Mapping[str, object] | None = None,
    *,
    u: Mapping[str, object] | None = None,
    udot: Mapping[str, object] | None = None,
    weights: Mapping[str, float] | None = None,
    locked: Iterable[str] | None = None,
    branch: Mapping[str, object] | None = None,
    start: Mapping[str, ArrayLike] | ArrayLike | None = None,
    starts: Count = STARTS,
    seed: Seed = 0,
    t: float = 0.0,
    r: State | None = None,
    by: str = CONSTRAINTS,
) -> AssemblyRecord:
    """A position at which all loops close, next to a start, with some of it given.

    Args:
        model: The compiled model; without loops this is inverse kinematics.
        targets: Coordinate or joint -> value, frame -> its position (3,) or pose (4, 4) in the
            ground. All are held exactly but for those in ``weights``.
        u, udot: Given speeds and accelerations by name; the other speeds are those of least kinetic
            energy, the other accelerations those under the forces of the scene.
        weights: Target -> weight; such targets are met as well as the rest allows: the weighted sum
            of squares is least, lengths in sizes of the mechanism, angles in radians.
        locked: Names of the targets that are held, instead of all without a weight.
        branch: Coordinate -> ``"+"``, ``"-"`` or ``(low, high)``: which of several positions.
        start: Coordinates to start from, by name or (nq,); the position next to them is chosen.
        starts: Searches: the first from ``start``, the others from random coordinates.
        seed: Of the random ones.
        t, r: Time [s] and inputs, where something is prescribed.
        by: ``"constraints"``; or ``"strain_energy"``: targets are coordinates, and all else has
            the position next to the start at which the energy of springs, bushings, cables and
            beams is least, without loads and weights. It takes ``targets``, ``start``, t and r.

    Raises:
        ModelError: the loops cannot be assembled, inconsistent targets, no position
            on the branch, unknown names; by strain energy, nothing that is strained.
        ArgumentError, SolveError: values of a wrong shape, or not finite; by strain energy, no
            position that has the values.

    Warns:
        SolveWarning: two positions are equally near to the start; or Ctrl-C ended the searches
            once one had met the targets; by strain energy, nothing strained resists some motion.
    """
    excluded = {"u": u, "udot": udot, "weights": weights, "locked": locked, "branch": branch}
    if _by_strain_energy(by, "assemble", excluded):
        return assemble_by_strain_energy(model, targets or {}, start, t, r)
    return assemble_by_constraints(
        model, targets, u=u, udot=udot, weights=weights, locked=locked, branch=branch,
        start=start, starts=starts, seed=seed, t=t, r=r,
    )  # fmt: skip


@checked
def sweep(
    model: LoadedModel,
    driver: str | Mapping[str, ArrayLike],
    values: ArrayLike | None = None,
    *,
    rate: float = 1.0,
    acceleration: float = 0.0,
    locked: LockedValues | None = None,
    start: Mapping[str, ArrayLike] | ArrayLike | None = None,
    branch: Mapping[str, object] | None = None,
    t: float = 0.0,
    r: State | None = None,
    by: str = CONSTRAINTS,
    snap: bool = False,
    check: bool = False,
    progress: bool | Callable[[float], None] | None = None,
) -> SweepRecord:
    """Drive a mechanism through given values and keep its branch.

    Args:
        model: The compiled model.
        driver: Coordinate that is driven, or several with their values: they go together. By
            strain energy also parameters, such as the length of a spring, inputs and ``"t"``.
        values: Of the one driver (n,).
        rate, acceleration: Derivatives of the driver over time, for speeds and accelerations; of
            several drivers those of the first, the others follow in proportion.
        locked: Further coordinates or frames that keep a value, as ``assemble`` takes them.
        start: Coordinates near those of the first position; branch: as ``assemble`` takes it.
        t, r: Time [s] and inputs, where something is prescribed.
        by: ``"constraints"``; or ``"strain_energy"``: what is not driven has the position at which
            the energy of springs, bushings, cables and beams is least, without loads and weights.
        snap: By strain energy: where minima end, or become saddles, go downhill to another one and
            on from there, instead of stopping, or keeping the saddles.
        check: Raise where the mechanism cannot follow, instead of warning.
        progress: True, False or a function of the fraction done; None: a bar in long sweeps.

    Returns:
        The positions reached, each next to the one before; as far as they were before Ctrl-C.

    Raises:
        ModelError: unknown names, a first position that cannot be assembled, freedoms left.
        ArgumentError: values of a wrong shape. SolveError: values that are not finite; with
            ``check``, a mechanism that cannot follow.

    Warns:
        SolveWarning: the mechanism cannot follow; by strain energy, its energy is no longer least,
            or nothing strained resists some motion.
    """
    for word, value in (("rate", rate), ("acceleration", acceleration)):
        if not abs(value) <= FASTEST:
            raise SolveError(f"sweep: {word}={value:g}; it must be finite, up to {FASTEST:g}")
    excluded = {"branch": branch, "acceleration": acceleration or None}
    strained = _by_strain_energy(by, "sweep", excluded)
    if snap and not strained:
        raise ModelError("sweep: snap=True goes with by='strain_energy': rigid links do not snap")
    with showing(progress, f"sweep of {model.name}") as show:
        if strained:
            args = (driver, values, locked, start, rate, t, r, snap, show)
            record = sweep_by_strain_energy(model, *args)
        else:
            record = sweep_by_constraints(
                model, driver, values, rate=rate, acceleration=acceleration, locked=locked,
                start=start, branch=branch, t=t, r=r, show=show,
            )  # fmt: skip
    if not record.success:
        if check:
            raise SolveError(record.message)
        warn(record.message, SolveWarning)
    return record


def _by_strain_energy(by: str, verb: str, excluded: Mapping[str, object]) -> bool:
    """True for strain energy.

    Args:
        by: As the user says.
        verb: For messages.
        excluded: Arguments that go with constraints alone.

    Raises:
        ModelError: another word, or one of these arguments with strain energy.
    """
    if by == CONSTRAINTS:
        return False
    if by != STRAIN_ENERGY:
        raise ModelError(f"{verb}: by='{by}'; it is 'constraints' or 'strain_energy'")
    spoken = [name for name, value in excluded.items() if value is not None]
    if spoken:
        raise ModelError(
            f"{verb}: {spoken[0]}= does not go with by='strain_energy': what is held and start= "
            "determine the position"
        )
    return True
