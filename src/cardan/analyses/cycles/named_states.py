"""States by name, and maps of them onto one another: symmetries of a cycle."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TypeAlias

import numpy as np

from ...arrays import Array
from ...errors import ArgumentError, ModelError, brief, near
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel
from ..systems.dynamic_system import DynamicSystem

StateMap: TypeAlias = Callable[[Array], Array]


def state_names(model: LoadedModel) -> tuple[str, ...]:
    """Names of the entries of a state (nx,)."""
    return (*model.coordinates, *model.speeds, *model.internals)


def named_state(model: LoadedModel, x: Array) -> dict[str, float]:
    """A state by name."""
    return dict(zip(state_names(model), x.tolist(), strict=True))


def blocks_of(model: LoadedModel, start: Mapping[str, object]) -> dict[str, dict[str, object]]:
    """Values by name as those of coordinates, speeds and internal states.

    Raises:
        ModelError: an unknown name.
    """
    slots = {letter: model.manifest.slots(letter) for letter in "qu"}
    entries = {"q": model.coordinates, "u": model.speeds, "z": model.internals}
    blocks: dict[str, dict[str, object]] = {"q": {}, "u": {}, "z": {}}
    for name, value in start.items():
        # a bare joint names its coordinates, as in q=
        letters = [x for x in "quz" if name in entries[x]] or [x for x in "qu" if name in slots[x]]
        if not letters:
            raise ModelError(f"cycle: start: there is no '{name}'.{near(name, state_names(model))}")
        blocks[letters[0]][name] = value
    return blocks


def symmetry_map(system: DynamicSystem, model: LoadedModel, symmetry: object) -> StateMap:
    """The map of states (nx,) behind a lap onto the start of the next one.

    Args:
        system, model: Whose.
        symmetry: Name -> the name whose value it takes, with a factor and a shift: the speed of a
            coordinate goes along, and what is named once is exchanged. Or a function of the named
            state that returns those values that change.

    Raises:
        ModelError: an unknown name, or two entries that take the same value.
    """
    names = state_names(model)
    if callable(symmetry):
        return _Written(model, names, symmetry)
    if not isinstance(symmetry, Mapping):
        raise ArgumentError(
            f"cycle: symmetry={brief(symmetry)}; give name -> name, or a function of the "
            "named state"
        )
    # what is named once is exchanged, by the inverse of what was given
    images = {name: _image(name, image) for name, image in symmetry.items()}
    for name, (of, factor, shift) in list(images.items()):
        images.setdefault(of, (name, 1 / factor, -shift / factor))
    for name, (of, factor, _) in list(images.items()):
        if {name, of} <= set(system.places):
            rates = (model.speeds[system.places[one][1]] for one in (name, of))
            images.setdefault(next(rates), (next(rates), factor, 0.0))
    matrix, shifts = np.eye(len(names)), np.zeros(len(names))
    for name, (of, factor, shift) in images.items():
        for one in (name, of):
            if one not in names:
                raise ModelError(f"cycle: symmetry: there is no '{one}'.{near(one, names)}")
        row = names.index(name)
        matrix[row], shifts[row] = 0.0, shift
        matrix[row, names.index(of)] = factor
    for name, column in zip(names, matrix.T, strict=True):
        if np.count_nonzero(column) != 1:
            raise ModelError(
                f"cycle: symmetry: the value of '{name}' goes to "
                f"{np.count_nonzero(column)} entries; each goes to one"
            )
    return lambda x: np.asarray(matrix @ x + shifts)


def _image(name: str, image: object) -> tuple[str, float, float]:
    """Name, factor and shift."""
    parts = (image,) if isinstance(image, str) else image
    if isinstance(parts, tuple) and 1 <= len(parts) <= 3 and isinstance(parts[0], str):
        factor, shift = (*(float(x) for x in parts[1:]), *(1.0, 0.0)[len(parts) - 1 :])
        if factor != 0:
            return parts[0], factor, shift
    raise ArgumentError(
        f"cycle: symmetry: '{name}': {brief(image)}; give a name, or (name, factor, shift), such "
        "as ('swing', -1)"
    )


@dataclass(frozen=True, eq=False)
class _Written:
    """A symmetry that the caller wrote.

    Attributes:
        model, names: Whose state, and the names of its entries.
        function: Of the named state.
    """

    model: LoadedModel
    names: tuple[str, ...]
    function: Callable[[dict[str, float]], Mapping[str, float]]

    def __call__(self, x: Array) -> Array:
        """The state (nx,) behind the map."""
        image = x.copy()
        for name, value in self.function(named_state(self.model, x)).items():
            if name not in self.names:
                raise ModelError(f"cycle: symmetry: there is no '{name}'.{near(name, self.names)}")
            image[self.names.index(name)] = value
        return image
