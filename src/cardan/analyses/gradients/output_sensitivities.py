"""What outputs, energies, forces and other functions of a motion change by, by the chain rule."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...arrays import Array
from ...errors import ArgumentError, CardanError, ModelError, brief, near
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.models.wrenches import force_part, reaction_part
from ...runtime.trajectory.histories import ENERGIES, joint_names, state_places
from ...schema.blocks import COORDINATES, Blocks
from ...schema.functions import DIFFERENTIABLE, FUNCTIONS

ENERGY_ROWS = ("kinetic", "potential", "total")  # of the function ``energy``
STATE = {"t", "x", *"quzsr"}  # arguments that are known along a motion
Entries = int | slice


@dataclass(frozen=True)
class ChangingStates:
    """States along a motion, and what they change by along k directions.

    Attributes:
        t, x, r, s: Times (m,), states (m, nx), inputs (m, nr) and modes (m, ns).
        by_x, by_r, by_s: Their changes (m, k, nx), (m, k, nr), (m, k, ns).
        named: Names of the parameters that change along some direction.
        by_named: Their changes (k, named).
    """

    t: Array
    x: Array
    r: Array
    s: Array
    by_x: Array
    by_r: Array
    by_s: Array
    named: tuple[str, ...]
    by_named: Array


def changes_of(model: LoadedModel, what: str | tuple[str, str], along: ChangingStates) -> Array:
    """Changes (m, k, ...) of a history of a motion, a formula or a function.

    Args:
        model: The model, with the parameters of the run.
        what: As :meth:`.Sensitivities.of` takes it.
        along: The motion.

    Raises:
        ModelError: no such name or formula. ArgumentError: a function of more than the state.
    """
    pair = isinstance(what, tuple) and len(what) == 2 and all(isinstance(x, str) for x in what)
    if not (pair or isinstance(what, str)):
        raise ArgumentError(
            f"sensitivity.of({brief(what)}): give a name of the motion, a formula, or a pair such "
            "as ('pose', 'hand')"
        )
    nq, nu = model.nq, model.nu
    place = state_places(model.manifest).get(what) if isinstance(what, str) else None
    if place is not None:
        # what is a part of the state has its changes already
        q, u, z = np.split(along.by_x, [nq, nq + nu], axis=-1)
        blocks = {"q": q, "u": u, "z": z, "r": along.by_r, "s": along.by_s}
        return np.asarray(blocks[place[0]][..., place[1]])
    function, of, entries = _function(model, what)
    reads = set(FUNCTIONS[function].reads.replace("x", "q u z").split())
    missing = [name for name in FUNCTIONS[function].required if name not in STATE]
    if missing:
        raise ArgumentError(
            f"sensitivity: {function} is a function of {missing[0]} too, which is not part of a "
            "motion. Take a function of the state, or a formula in names of the model"
        )
    # y' = y_x x' + y_r r' + y_p p', by one product along every direction
    sizes = {"q": nq, "u": nu, "z": model.nz, "s": model.ns, "r": model.nr}
    letters = [letter for letter, size in sizes.items() if size and letter in reads]
    parts = dict(zip("quz", np.split(along.by_x, [nq, nq + nu], axis=-1), strict=True))
    parts |= {"s": along.by_s, "r": along.by_r}
    direction = {COORDINATES if one == "q" else one: parts[one] for one in letters}
    shape = along.by_x.shape[:2]
    for k, name in enumerate(along.named):
        direction[name] = np.broadcast_to(along.by_named[:, k], shape)
    q, u, z = model.parts_of(along.x)
    states = {"t": along.t, "x": along.x, "q": q, "u": u, "z": z, "s": along.s, "r": along.r}
    arguments = {n: states[n][:, None] for n in FUNCTIONS[function].arguments if n in states}
    said = f"'{what}'" if isinstance(what, str) else what
    try:
        named = function if of is None else (function, of)
        product: Callable[..., Array] = model.jvp(named, wrt=Blocks(direction))
        changes = product(**arguments, direction=direction)
    except CardanError as problem:
        raise type(problem)(f"sensitivity: {said}: {problem}") from problem
    return np.asarray(changes if entries is None else changes[..., entries])


def _function(
    model: LoadedModel, what: str | tuple[str, str]
) -> tuple[str, str | None, Entries | None]:
    """A function, its frame, joint or formula, and which entries of its result are meant.

    Raises:
        ModelError: there is no such function.
    """
    if isinstance(what, tuple):
        # the product checks the rest
        if what[0] not in DIFFERENTIABLE:
            near_names = near(what[0], DIFFERENTIABLE)
            raise ModelError(f"sensitivity: there is no function '{what[0]}'.{near_names}")
        return what[0], what[1], None
    manifest = model.manifest
    outputs = [row.name for row in manifest.outputs]
    multipliers = [row.name for row in manifest.multipliers]
    forces = manifest.element_forces
    if what in outputs:
        return "outputs", None, outputs.index(what)
    if what in multipliers:
        return "multipliers", None, multipliers.index(what)
    if part := reaction_part(what, joint_names(manifest)):
        return "reaction", part[0], part[1]
    if (entries := force_part(what, forces)) is not None:
        return "element_forces", None, entries
    if what in ENERGIES:
        return "energy", None, ENERGY_ROWS.index(ENERGIES[what])
    if what in DIFFERENTIABLE and not FUNCTIONS[what].of:
        return what, None, None
    return "expression", what, None
