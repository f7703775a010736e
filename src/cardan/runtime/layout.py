"""What the manifest says about the blocks of a model, as arguments of its functions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any, final

import numpy as np

from ..ir.request import Request
from ..ir.rows import column
from .calling import Argument, Array
from .slots import SLOT

READS = {
    "rhs": "t x r s",
    "rhs_jacobian": "t x r s",
    "forward_dynamics": "t q u z s r tau",
    "inverse_dynamics": "t q u udot z s r",
    "mass_matrix": "t q r",
    "bias": "t q u r",
    "gravity": "t q r",
    "coriolis": "t q u r",
    "applied": "t q u r z s",
    "qdot": "t q u r",
    "energy": "t q u r",
    "pose": "t q r",
    "velocity": "t q u r",
    "acceleration": "t q u udot r",
    "frame_jacobian": "t q r",
    "com": "t q r",
    "momentum": "t q u r",
    "momenta": "t q u r",
    "momentum_rates": "t q u r tau z s",
    "hamiltonian": "t q u r",
    "reaction": "t q u r tau wrench z s",
    "outputs": "t q u r z s",
    "power": "t q u r z s",
    "dependents": "t q u r",
    "constraints": "t q r",
    "constraint_rates": "t q u r z s",
    "constraint_jacobian": "t q r s",
    "closure": "t q r",
    "facing": "t q r",
    "multipliers": "t q u r tau z s",
    "close_position": "t q r",
    "close_velocity": "t q u r z s",
    "events": "t q u r z s",
    "transition": "t q u r z s e",
    "balance": "t q u udot lam r z s",
    "balance_tangent": "t q u udot lam r z s",
    "regressor": "t q u udot z s r",
    "energy_regressor": "t q u r z s",
    "inertial_parameters": "",
    "move": "q du",
    "integrate": "q du",
    "difference": "q0 q",
}

# functions of one frame or joint
NAMED = frozenset({"pose", "velocity", "acceleration", "frame_jacobian", "reaction"})
# arguments that have a default
OPTIONAL = frozenset({"t", "r", "z", "s", "tau", "wrench"})
# functions that have no derivatives: along increments, or derivatives themselves
APART = ("balance", "balance_tangent", "rhs_jacobian", "move", "integrate", "difference")
SMOOTH = tuple(name for name in READS if name not in APART)
FUNCTIONS = (*READS, "derivative")
# those that only some methods call, and many never
DEMANDED = (
    *("derivative", "rhs_jacobian", "balance", "balance_tangent", "move"),
    *("regressor", "energy_regressor", "inertial_parameters"),
)

AXES = ("mx", "my", "mz", "fx", "fy", "fz")


def reads(function: str, of: str | None) -> list[str]:
    """Names of the arguments of a function; a derivative has those of its function."""
    if function == "derivative":
        function = Request.read(of or "").function
    return READS[function].split()


@final
class Places(Mapping[str, slice]):
    """Name -> where its entries lie; found out when somebody asks, as there may be very many.

    Args:
        names: Of the entries.
        joints, letter: Whose names stand for all of their own, and where they say which.
    """

    def __init__(self, names: Sequence[str], joints: Sequence[Any] = (), letter: str = "") -> None:
        self._names, self._joints, self._letter = names, joints, letter

    @cached_property
    def _found(self) -> dict[str, slice]:
        found = {name: slice(k, k + 1) for k, name in enumerate(self._names)}
        for joint in self._joints:
            start, size = joint[self._letter] or (0, 0)
            if size:
                found.setdefault(joint["name"], slice(start, start + size))
        return found

    def __getitem__(self, name: str) -> slice:
        return self._found[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._found)

    def __len__(self) -> int:
        return len(self._found)


class Layout:
    """Names, sizes and defaults of the blocks of a model."""

    def __init__(self, manifest: dict[str, Any]) -> None:
        self.manifest = manifest
        self.coordinates: tuple[str, ...] = tuple(column(manifest["coordinates"], "name"))
        self.speeds: tuple[str, ...] = tuple(column(manifest["speeds"], "name"))
        self.inputs = tuple(row["name"] for row in manifest["inputs"])
        self.internals = tuple(row["name"] for row in manifest["z"])
        self.modes = tuple(row["name"] for row in manifest["s"])
        self.events = tuple(row["name"] for row in manifest.get("events", ()))
        self.multipliers = tuple(row["name"] for row in manifest.get("multipliers", ()))
        self.parts = tuple(part for body in manifest["bodies"] for part in body["parts"])
        # bodies without parts only stand for joints: their frames are nobody's
        self.part_of = {
            row["name"]: row.get("part")
            for row in manifest["frames"]
            if row.get("part") is not None or row["body"] == "ground"
        }

    @cached_property
    def places(self) -> Mapping[str, Mapping[str, slice]]:
        """Block -> name -> where its entries lie; a joint's name stands for its whole block."""
        joints = self.manifest["joints"]
        q, u = (
            Places(names, joints, letter)
            for names, letter in ((self.coordinates, "q"), (self.speeds, "u"))
        )
        r = Places(self.inputs)
        own = {block: Places(names) for block, names in self._own.items()}
        return {"q": q, "q0": q, "u": u, "udot": u, "tau": u, "du": u, "r": r} | own

    def names(self, block: str) -> tuple[str, ...]:
        """Name of every entry of a block."""
        own = {"q": self.coordinates, "q0": self.coordinates, "r": self.inputs} | self._own
        return own.get(block, self.speeds)

    @property
    def _own(self) -> dict[str, tuple[str, ...]]:
        """Blocks that only some systems have."""
        own = {"z": self.internals, "s": self.modes, "e": self.events}
        return own | {"lam": self.multipliers}

    def start(self, block: str) -> Array:
        """Entries of a block that are not named: defaults of q, r, z and s, else zeros."""
        rows = {"q": "coordinates", "q0": "coordinates", "r": "inputs", "z": "z", "s": "s"}
        if block not in rows:
            return np.zeros(len(self.names(block)))
        defaults = column(self.manifest[rows[block]], "default")
        return np.array([x or 0.0 for x in defaults], dtype=np.float64)

    @cached_property
    def arguments(self) -> dict[str, Argument]:
        """Every argument by name."""
        nq, nu, nz = len(self.coordinates), len(self.speeds), len(self.internals)
        wrench = tuple(f"{p}.{a}" for p in self.parts for a in AXES)
        state = ((SLOT["q"], 0), (SLOT["u"], nq), *(((SLOT["z"], nq + nu),) if nz else ()))
        names = self.coordinates + self.speeds + self.internals
        listed = [
            Argument("t", (), ("t",), ((SLOT["t"], 0),), np.zeros(())),
            Argument("x", (nq + nu + nz,), names, state, None, "entries"),
            self._vector("q", "coordinates"),
            self._vector("q0", "coordinates"),
            self._vector("u", "speeds"),
            self._vector("udot", "accelerations of"),
            self._vector("du", "increments along"),
            self._vector("lam", "multipliers"),
            self._vector("tau", "forces along", np.zeros(nu)),
            self._vector("r", "inputs", self.start("r")),
            self._vector("z", "internal states", self.start("z")),
            self._vector("s", "modes", self.start("s")),
            self._vector("e", "events"),
            Argument(
                "wrench",
                (len(self.parts), 6),
                wrench,
                ((SLOT["wrench"], 0),),
                np.zeros((len(self.parts), 6)),
            ),
        ]
        return {argument.name: argument for argument in listed}

    def _vector(self, block: str, what: str, default: Array | None = None) -> Argument:
        names = self.names(block)
        slots, places = ((SLOT[block], 0),), self.places[block]
        return Argument(
            block, (len(names),), names, slots, default, what, places, self.start(block)
        )

    def reads(self, function: str, of: str | None = None) -> list[Argument]:
        """Arguments of a function in the order of :data:`READS`."""
        return [self.arguments[name] for name in reads(function, of)]
