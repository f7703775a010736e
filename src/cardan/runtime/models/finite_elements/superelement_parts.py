"""Forces of a superelement and their derivatives, part by part.

The balance of one is b = M u' + (G + P) u / 2 + D u + b_elastic + b_geometric + b_gravity, and its
derivatives by small motions, by u and by u' are K, C and M:

    C = D + G + P + C_geometric, G skew and P symmetric,
    K = K_elastic + K_geometric + K_centrifugal + K_acceleration + K_gravity.

Forces of second order in u are half of their derivative times u. Those of G do no work; those of
P, the pseudo-damping, do u.M~ u / 2 with the rate M~ of the mass along the motion.

Source: Géradin and Cardona, Flexible Multibody Dynamics (2001), section 8.7.2.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from ....arguments import checked
from ....arrays import Array
from ....errors import ArgumentError, ModelError
from ....records import dataclass
from ....schema.records import PARTS
from ...calls import loaded_function
from ...calls.evaluation import State
from ...calls.lanes import unpacked
from . import elements
from .assembled import Assembled
from .superelements import number_of

if TYPE_CHECKING:
    from ..loaded_model import LoadedModel
    from .tables import Table

KIND = re.compile(r"superelement(_\d+)?")
GRAVITY = slice(12, 15)  # of the data of an element
GEOMETRIC = "geometric"


@dataclass(frozen=True, repr=False, eq=False)
class SuperelementParts:
    """Forces of a superelement at a state, and their derivatives, by names of their parts.

    Attributes:
        name: Of the superelement.
        speeds: Names of what rows and columns belong to (N,): speeds of the body with its frame,
            angular velocity in its axes before velocity in those of the ground; then rates of its
            coordinates.
        forces: ``"inertia"``, ``"gyroscopic"``, ``"pseudo_damping"``, ``"damping"``, ``"elastic"``,
            ``"geometric"``, ``"gravity"`` (N,) [N m, N, and those of the coordinates]. They add up
            to 0 together with what others exert.
        M: ``"inertia"``, ``"geometric"`` (N, N): by accelerations.
        C: ``"damping"``, ``"gyroscopic"`` (skew), ``"pseudo_damping"`` (symmetric),
            ``"geometric"`` (N, N): by speeds.
        K: ``"elastic"``, ``"geometric"``, ``"centrifugal"`` (of second order in speeds),
            ``"acceleration"`` (of accelerations), ``"gravity"`` (N, N): by small motions along the
            speeds.
    """

    name: str
    speeds: tuple[str, ...]
    forces: Mapping[str, Array]
    M: Mapping[str, Array]
    C: Mapping[str, Array]
    K: Mapping[str, Array]

    def total(self, letter: str) -> Array:
        """The sum of all parts of ``"forces"`` (N,), ``"M"``, ``"C"`` or ``"K"`` (N, N).

        Raises:
            ArgumentError: another letter.
        """
        if letter not in ("forces", "M", "C", "K"):
            raise ArgumentError(f"total: {letter!r}: give 'forces', 'M', 'C' or 'K'")
        parts: Mapping[str, Array] = getattr(self, letter)
        return np.asarray(np.sum([*parts.values()], axis=0))

    def __repr__(self) -> str:
        lines = [f"SuperelementParts('{self.name}', {len(self.speeds)} speeds), largest entries"]
        for letter in ("forces", "M", "C", "K"):
            sizes = {name: abs(x).max() for name, x in getattr(self, letter).items()}
            some = ", ".join(f"{name} {size:.4g}" for name, size in sizes.items() if size != 0)
            lines.append(f"  {letter:<7} {some or 'none'}")
        return "\n".join(lines)


@checked
def superelement_parts(
    model: LoadedModel, name: str, q: State, u: State | None = None, udot: State | None = None
) -> SuperelementParts:
    """Forces of a superelement and their derivatives by name: gyroscopic ones, and so on.

    Args:
        model: In absolute coordinates.
        name: Of the superelement.
        q: Coordinates (nq,).
        u, udot: Speeds and accelerations (nu,), 0 by default.

    Returns:
        Parts of forces, M, C and K.

    Raises:
        ModelError: there is no such superelement. ArgumentError: a block has another shape.

    Source: Géradin and Cardona, Flexible Multibody Dynamics (2001), section 8.7.2.
    """
    number_of(model.manifest, name)
    blocks = dict[str, Array]()
    for letter, value, size in (("q", q, model.nq), ("u", u, model.nu), ("udot", udot, model.nu)):
        block = np.zeros(size) if value is None else model._vector(letter, value)
        blocks[letter] = np.asarray(block, float)
        if blocks[letter].shape != (size,):
            raise ArgumentError(f"{letter} has shape {blocks[letter].shape}, expected ({size},)")
    source = model._source
    assert isinstance(source, Assembled)
    mesh = source.results(model).mesh
    number, member = _place(mesh.tables.groups, name)
    group = mesh.tables.groups[number]
    inputs = mesh.read(number, elements.State(q=blocks["q"], u=blocks["u"], udot=blocks["udot"]))
    local = {letter: x[member] if x.ndim > 1 else x for letter, x in inputs.items()}
    columns = mesh.tables.columns(group)[member]
    speeds = tuple(model.manifest.speeds[k].name for k in columns.tolist())
    return _parts(name, speeds, _Element(model, group, local))


def _place(groups: tuple[Table, ...], name: str) -> tuple[int, int]:
    """Group and member of a superelement."""
    for number, group in enumerate(groups):
        if KIND.fullmatch(group.kind.name) and name in group.members:
            return number, [*group.members].index(name)
    raise ModelError(f"the model has no element of superelement '{name}'. Compile it again")


class _Element:
    """The functions of one superelement at a state, any of whose blocks can be set to 0."""

    def __init__(self, model: LoadedModel, group: Table, inputs: dict[str, Array]) -> None:
        self.model, self.group, self.inputs = model, group, inputs

    def call(self, form: str, *counting: str) -> Array:
        """Results of a function where of u, udot and gravity only some are not 0."""
        zeros = {x: 0 * self.inputs[x] for x in ("u", "udot") if x not in counting}
        data = self.inputs["p"].copy()
        if "gravity" not in counting:
            data[GRAVITY] = 0.0
        code = self.model._objects.load([self.group.kind.functions[form]])[0]
        run, out = loaded_function.calls(code, {**self.inputs, **zeros, "p": data}, 1)
        run()
        values: Array = unpacked(out, code.lanes)[0]
        return values

    def tangent(self, form: str, *counting: str) -> dict[str, Array]:
        """K, C and M (N, N) of a function where only some of u, udot and gravity are not 0."""
        n, flat = self.group.kind.nu, self.call(form, *counting)
        blocks = flat.reshape(-1, n, n)
        return dict(zip((x for x in PARTS if x in "KCM"), blocks, strict=True))


def _parts(name: str, speeds: tuple[str, ...], element: _Element) -> SuperelementParts:
    """The parts, from states in which only some of speeds, accelerations and gravity are not 0."""
    u, udot = element.inputs["u"], element.inputs["udot"]
    states: dict[str, tuple[str, ...]] = {
        "unloaded": (),
        "speeds": ("u",),
        "acceleration": ("udot",),
        "gravity": ("gravity",),
        "motion": ("u", "udot"),
    }
    tangents = {key: element.tangent("balance_tangent", *some) for key, some in states.items()}
    zeros = {letter: np.zeros((len(u), len(u))) for letter in "KCM"}
    geometric = {
        key: element.tangent(GEOMETRIC, *some)
        if GEOMETRIC in element.group.kind.functions
        else zeros
        for key, some in states.items()
    }
    unloaded, stiffened = tangents["unloaded"], geometric["motion"]
    # forces of second order in speeds
    by_speeds = tangents["speeds"]["C"] - unloaded["C"] - geometric["speeds"]["C"]
    gyroscopic, pseudo = (by_speeds - by_speeds.T) / 2, (by_speeds + by_speeds.T) / 2
    inertia = unloaded["M"] - geometric["unloaded"]["M"]
    elastic, weighted = (element.call("balance", *some)[: len(u)] for some in ((), ("gravity",)))
    changes = {
        key: tangents[key]["K"] - unloaded["K"] - geometric[key]["K"]
        for key in ("speeds", "acceleration", "gravity")
    }
    return SuperelementParts(
        name=name,
        speeds=speeds,
        forces={
            "inertia": inertia @ udot,
            "gyroscopic": gyroscopic @ u / 2,
            "pseudo_damping": pseudo @ u / 2,
            "damping": unloaded["C"] @ u,
            "elastic": elastic,
            GEOMETRIC: stiffened["M"] @ udot + stiffened["C"] @ u / 2,
            "gravity": weighted - elastic,
        },
        M={"inertia": inertia, GEOMETRIC: stiffened["M"]},
        C={
            "damping": unloaded["C"],
            "gyroscopic": gyroscopic,
            "pseudo_damping": pseudo,
            GEOMETRIC: stiffened["C"],
        },
        K={
            "elastic": unloaded["K"],
            GEOMETRIC: stiffened["K"],
            "centrifugal": changes["speeds"],
            "acceleration": changes["acceleration"],
            "gravity": changes["gravity"],
        },
    )
