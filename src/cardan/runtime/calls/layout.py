"""Blocks of a model from its manifest, as arguments of its functions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import final

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array
from ...schema.blocks import ARGUMENTS, SLOT
from ...schema.functions import FUNCTIONS
from ...schema.manifest import Manifest
from ...schema.mechanism import JointRow
from ...schema.request import reads
from ...schema.rows import column, having
from .calling import Argument

AXES = ("mx", "my", "mz", "fx", "fy", "fz")


@final
class Places(Mapping[str, slice]):
    """Name -> where its entries lie; found out when somebody asks, as there may be very many.

    Args:
        names: Of the entries.
        joints, letter: Whose names stand for all of their own, and where they say which.
    """

    def __init__(
        self, names: Sequence[str], joints: Sequence[JointRow] = (), letter: str = ""
    ) -> None:
        self._names, self._joints, self._letter = names, joints, letter

    @cached_property
    def _slices(self) -> dict[str, slice]:
        slices = {name: slice(k, k + 1) for k, name in enumerate(self._names)}
        for joint in self._joints:
            start, size = joint.slot(self._letter)
            if size:
                slices.setdefault(joint.name, slice(start, start + size))
        return slices

    def __getitem__(self, name: str) -> slice:
        return self._slices[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._slices)

    def __len__(self) -> int:
        return len(self._slices)


class Layout:
    """Names, sizes and defaults of the blocks of a model."""

    def __init__(self, manifest: Manifest) -> None:
        self.manifest = manifest
        self._defaults: dict[str, Array] = {}
        self.coordinates: tuple[str, ...] = tuple(column(manifest.coordinates, "name"))
        self.speeds: tuple[str, ...] = tuple(column(manifest.speeds, "name"))
        self.inputs = tuple(row.name for row in manifest.inputs)
        self.internals = tuple(row.name for row in manifest.z)
        self.modes = tuple(row.name for row in manifest.s)
        self.events = tuple(row.name for row in manifest.events)
        self.multipliers = tuple(row.name for row in manifest.multipliers)
        self.parts = tuple(part for body in manifest.bodies for part in body.parts)
        # bodies without parts only stand for joints: their frames are nobody's
        self.part_of = {
            row.name: row.part
            for row in manifest.frames
            if row.part is not None or row.body == "ground"
        }

    @cached_property
    def places(self) -> Mapping[str, Mapping[str, slice]]:
        """Block -> name -> where its entries lie; a joint's name stands for its whole block."""
        joints = self.manifest.joints
        q, u = (
            Places(names, joints, letter)
            for names, letter in ((self.coordinates, "q"), (self.speeds, "u"))
        )
        r = Places(self.inputs)
        other = {block: Places(names) for block, names in self._other_names.items()}
        return {"q": q, "q0": q, "u": u, "udot": u, "tau": u, "du": u, "r": r} | other

    def names(self, block: str) -> tuple[str, ...]:
        """Name of every entry of a block."""
        names = {
            "q": self.coordinates,
            "q0": self.coordinates,
            "r": self.inputs,
        } | self._other_names
        return names.get(block, self.speeds)

    @property
    def _other_names(self) -> dict[str, tuple[str, ...]]:
        """Blocks that only some systems have."""
        names = {"z": self.internals, "s": self.modes, "e": self.events}
        return names | {"lam": self.multipliers}

    def start(self, block: str) -> Array:
        """Entries of a block that are not named: defaults of q, r, z and s, else zeros."""
        if block not in ("q", "q0", "r", "z", "s"):
            return np.zeros(len(self.names(block)))
        return self._default_values(block.removesuffix("0"))

    def _default_values(self, letter: str) -> Array:
        """Defaults of the entries of a block; read once, as there may be very many."""
        if letter not in self._defaults:
            defaults = column(self.manifest.block(letter), "default")
            self._defaults[letter] = np.array([x or 0.0 for x in defaults], dtype=np.float64)
        return self._defaults[letter].copy()

    @cached_property
    def joint_slots(self) -> Mapping[str, NDArray[np.intp]]:
        """``"q"``, ``"u"`` -> first entry and number of entries of every joint (n, 2)."""
        slots = ((letter, column(self.manifest.joints, letter)) for letter in "qu")
        return {
            letter: np.array([slot or (0, 0) for slot in of], dtype=np.intp).reshape(-1, 2)
            for letter, of in slots
        }

    @cached_property
    def lengths(self) -> NDArray[np.bool_]:
        """Mask of the speeds (nu,) that are lengths per time; the others are angles."""
        return np.array(
            [unit == "m/s" for unit in column(self.manifest.speeds, "unit")], dtype=bool
        )

    @cached_property
    def of_joints(self) -> bool:
        """True when all speeds are those of joints: nobody chose others."""
        return None not in column(self.manifest.speeds, "joint")

    @cached_property
    def slots(self) -> Mapping[str, Mapping[str, slice]]:
        """``"q"``, ``"u"``, ``"z"`` -> entries by name; joints stand for all of theirs."""
        return {letter: self.manifest.slots(letter) for letter in "quz"}

    @cached_property
    def starts(self) -> Mapping[str, Array]:
        """``"q"``, ``"u"``, ``"z"`` -> where a run starts unless told: as joints have it, else as
        coordinates and elements do.
        """
        starts = {}
        for letter in "quz":
            starts[letter] = self._default_values(letter)
        for letter in "qu":
            for joint in having(self.manifest.joints, f"{letter}0"):
                first, size = joint.slot(letter)
                if size:
                    values = joint.q0 if letter == "q" else joint.u0
                    starts[letter][first : first + size] = values
        return starts

    @cached_property
    def followers(self) -> Mapping[str, Mapping[str, slice]]:
        """``"q"``, ``"u"`` -> joints and entries that follow from loops in closed form, and their
        places among all that follow.
        """
        slices: dict[str, dict[str, slice]] = {"q": {}, "u": {}}
        for letter, places in slices.items():
            at = 0
            for joint in having(self.manifest.joints, "solved"):
                names = joint.solved.names(letter) if joint.solved else ()
                if names:
                    places[joint.name] = slice(at, at + len(names))
                for name in names:
                    places.setdefault(name, slice(at, at + 1))
                    at += 1
        return slices

    @cached_property
    def arguments(self) -> dict[str, Argument]:
        """Every argument by name."""
        nq, nu, nz = len(self.coordinates), len(self.speeds), len(self.internals)
        wrench = tuple(f"{p}.{a}" for p in self.parts for a in AXES)
        state = ((SLOT["q"], 0), (SLOT["u"], nq), *(((SLOT["z"], nq + nu),) if nz else ()))
        names = self.coordinates + self.speeds + self.internals
        arguments = {
            "t": Argument("t", (), ("t",), ((SLOT["t"], 0),), np.zeros(())),
            "x": Argument("x", (nq + nu + nz,), names, state, None, "entries"),
            "wrench": Argument(
                "wrench",
                (len(self.parts), 6),
                wrench,
                ((SLOT["wrench"], 0),),
                np.zeros((len(self.parts), 6)),
            ),
        }
        return {n: arguments.get(n) or self._vector(n) for n in ARGUMENTS if n != "v"}

    def _vector(self, block: str) -> Argument:
        names, start = self.names(block), self.start(block)
        slots, places = ((SLOT[block], 0),), self.places[block]
        default = start if ARGUMENTS[block].default else None
        what = ARGUMENTS[block].entries
        return Argument(block, (len(names),), names, slots, default, what, places, start)

    def reads(
        self, function: str, of: str | None = None, vector: Sequence[str] = ()
    ) -> list[Argument]:
        """Arguments of a function in their order.

        Args:
            function, of: Which.
            vector: Entries of its block v.
        """
        renamed = FUNCTIONS[function].renamed if function in FUNCTIONS else {}
        vectors = {"v": Argument("v", (len(vector),), tuple(vector), ((SLOT["v"], 0),))}
        return [
            replace(vectors.get(name) or self.arguments[name], label=renamed.get(name, name))
            for name in reads(function, of)
        ]
