"""Starts of models in absolute coordinates: joints are named, nodes and beams follow them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import cast

from ...arrays import Array
from ...errors import ArgumentError, ModelError, brief
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel
from ..gradients.unknowns import start_blocks, start_places
from ..simulation.settings import start

LETTERS = {"q0": "q", "u0": "u", "z0": "z"}


@dataclass(frozen=True)
class JointStart:
    """A start by names, of which some are unknown.

    Attributes:
        values: q, u and z by names, as they were given.
        unknown: Names of the unknown ones, such as ``"q0.hinge"``.
    """

    values: Mapping[str, Mapping[str, object]]
    unknown: tuple[str, ...]

    @classmethod
    def of(
        cls, model: LoadedModel, begin: tuple[object, ...], unknown: tuple[str, ...]
    ) -> JointStart:
        """The start as ``fit`` was given it.

        Args:
            model: The model.
            begin: q, u and z.
            unknown: Names of unknown starts.

        Raises:
            ArgumentError: it is not a start by names. ModelError: unknown starts are whole blocks.
        """
        values = dict[str, Mapping[str, object]]()
        for letter, block in zip("quz", begin, strict=True):
            if block is not None and not isinstance(block, Mapping):
                raise ArgumentError(
                    f"fit: {letter}={brief(block)}: '{model.manifest.name}' is in absolute "
                    "coordinates: give the start by names of joints, which nodes follow"
                )
            values[letter] = {} if block is None else block
        blocks = [name for name in unknown if name in start_blocks(model)]
        if blocks:
            one = next((n for n in start_places(model) if n.startswith("q0.")), "q0.hinge")
            raise ModelError(
                f"fit: unknown: '{blocks[0]}': '{model.manifest.name}' is in absolute coordinates, "
                f"where nodes follow joints. Name what is free, such as '{one}'"
            )
        start(model, None, *(values[letter] for letter in "quz"))
        return cls(values, unknown)

    def state(self, model: LoadedModel, x: Array) -> dict[str, object]:
        """The start as ``simulate`` takes it, with what is unknown from a state (nx,)."""
        blocks = {letter: dict(values) for letter, values in self.values.items()}
        parts = dict(zip("quz", model.parts_of(x), strict=True))
        for name in self.unknown:
            block, _, key = name.partition(".")
            letter = LETTERS[block]
            blocks[letter][key] = parts[letter][model._layout.places[letter][key]]
        return {"x0": None, **cast(dict[str, object], blocks)}
