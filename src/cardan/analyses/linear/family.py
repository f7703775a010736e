"""A family of linear models: the same motion under parameters, inputs or speeds that change.

Loci of eigenvalues, Campbell diagrams and derivatives of eigenvalues all ask it for members. Every
member is found anew, next to one that is known: an equilibrium, a steady motion, or a trim.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array
from ...errors import ArgumentError, ModelError, brief, listed, near
from ...records import dataclass
from ..statics.equilibrium import equilibrium
from ..statics.load_path import TIME, column
from ..systems import dynamic_system_of
from ..systems.dynamic_system import DynamicSystem
from .first_order import Choice
from .linear_model import LinearModelRecord
from .linearize import linearize
from .spectrum import Spectrum, spectrum
from .trim import trim
from .trim_arguments import by_entry

if TYPE_CHECKING:
    from ...runtime.models.loaded_model import LoadedModel

Complex = NDArray[np.complex128]
COUNT = 31  # members of a range
STILL = 1e-7  # of the largest modulus: eigenvalues that are 0


@dataclass(frozen=True, eq=False)
class Member:
    """A linear model of a family.

    Attributes:
        s: Place in the family, 0 to 1.
        state: The equilibrium, or the trimmed motion, about which it stands.
        linear: The linear model.
        spectrum: Its eigenvalues, or those of chosen coordinates.
        shapes: Columns (m, k) by which motions are known again, of length 1.
    """

    s: float
    state: Any
    linear: LinearModelRecord
    spectrum: Spectrum
    shapes: Complex = field(repr=False)

    @property
    def values(self) -> Complex:
        """Eigenvalues (k,)."""
        return self.spectrum.values

    @property
    def still(self) -> NDArray[np.bool_]:
        """Mask of the eigenvalues that are 0 (k,)."""
        return np.asarray(np.abs(self.values) <= STILL * self.spectrum.size)

    @property
    def stable(self) -> bool:
        """True when none does."""
        return not self.spectrum.unstable.any()


@dataclass(frozen=True, eq=False)
class Family:
    """Linear models between two ends.

    Attributes:
        model: The compiled model.
        columns: Name -> values (n,) of what changes, evenly over the family.
        kinds: Name -> which of :data:`PLACES` it belongs to.
        fixed: What stays, as ``equilibrium`` or ``trim`` takes it.
        coordinates: Whose motions count; all if None.
    """

    model: LoadedModel
    columns: Mapping[str, Array]
    kinds: Mapping[str, str]
    fixed: Mapping[str, Any]
    coordinates: tuple[str, ...] | None = None

    @cached_property
    def system(self) -> DynamicSystem:
        """The contract of the model."""
        return dynamic_system_of(self.model)

    @property
    def stations(self) -> Array:
        """Places (n,) of the values that were given."""
        return np.linspace(0, 1, len(next(iter(self.columns.values()))))

    def values_at(self, s: float) -> dict[str, float]:
        """Values of the varied quantities at a place of the family."""
        places = self.stations
        return {name: float(np.interp(s, places, column)) for name, column in self.columns.items()}

    def at(self, s: float, neighbor: Member | None = None, choice: Choice | None = None) -> Member:
        """The member at a place.

        Args:
            s: From 0 to 1; beyond the ends they stay.
            neighbor: A member near it, where the search begins.
            choice: Independent increments and speeds, where they are not to be chosen anew.

        Raises:
            SolveError: no equilibrium or steady motion there.
        """
        return self.member(s, self.values_at(s), neighbor, choice)

    def member(
        self, s: float, values: Mapping[str, float], neighbor: Member | None = None,
        choice: Choice | None = None,
    ) -> Member:  # fmt: skip
        """The member with given values of what changes."""
        arguments = {
            name: dict(v) if isinstance(v, Mapping) else v for name, v in self.fixed.items()
        }
        if neighbor is not None:
            self._begun(arguments, neighbor)
        for name, value in values.items():
            place = self.kinds[name]
            if place == TIME:
                arguments[TIME] = value
            else:
                arguments[place] = {**(arguments.get(place) or {}), name: value}
        find: Any = trim if "targets" in arguments else equilibrium
        state = find(self.model, **arguments, check=True)
        linear = linearize(state.model, state, choice=choice)
        spectrum = linear.spectrum if self.coordinates is None else self._closed(linear)
        return Member(s, state, linear, spectrum, self._shapes(linear, spectrum))

    def _begun(self, arguments: dict[str, Any], neighbor: Member) -> None:
        """Begin where another member is."""
        state = neighbor.state
        arguments["q"] = state.q
        free = getattr(state, "free", {})
        for name, value in free.items():
            for place, names in (("inputs", self.model.inputs), ("u", self.model.speeds),
                                 ("parameters", self.model.parameters)):  # fmt: skip
                if name in names:
                    arguments[place] = {**(arguments.get(place) or {}), name: value}

    def _closed(self, linear: LinearModelRecord) -> Spectrum:
        """Eigenvalues of the chosen coordinates alone."""
        second = linear.second_order(self.coordinates)
        n = len(second.coordinates)
        inner = np.linalg.solve(second.M, np.hstack([-second.K, -second.damping]))
        A = np.vstack([np.eye(n, 2 * n, n), inner])
        rate = max(float(np.abs(np.linalg.eigvals(A)).max(initial=0.0)), 1e-300)
        return spectrum(A, np.concatenate([np.ones(n), np.full(n, rate)]))

    def _shapes(self, linear: LinearModelRecord, spectrum: Spectrum) -> Complex:
        """Motions of all speeds, which do not depend on what is independent, of length 1."""
        right = spectrum.right
        if self.coordinates is None:
            columns = self.system.columns[:, None]
            rate = max(spectrum.size, 1e-300)
            moved = linear.increments @ right / columns
            parts = (moved, linear.speeds @ right / columns / rate, right[len(right) - linear.z :])
            right = np.concatenate(parts)
        length = np.linalg.norm(right, axis=0)
        return np.asarray(right / np.where(length > 0, length, 1.0))


def family(
    model: LoadedModel,
    swept: Mapping[str, Any],
    fixed: Mapping[str, Any],
    count: int | None = None,
    coordinates: Any = None,
) -> Family:
    """A family out of what a user wrote.

    Args:
        model: The compiled model.
        swept: Parameter, input, ``t``, or joint whose speed it is -> (start, end) or values (n,).
        fixed: As ``equilibrium`` takes it, with ``targets`` or ``free`` as ``trim`` does; values in
            ``u``, ``locked`` and ``targets`` may be arrays, and are swept then.
        count: Members of a range.
        coordinates: Whose motions count.

    Raises:
        ModelError: unknown names, nothing that changes. ArgumentError: values of a wrong shape.
        SolveError: values that are not finite.
    """
    kinds, columns = dict[str, str](), dict[str, Any]()
    stays = {name: value for name, value in fixed.items() if value is not None}
    if stays.get("free") and "targets" not in stays:
        stays["targets"] = {}
    # keywords of the call sweep parameters, inputs, coordinates or speeds by name
    for name, values in swept.items():
        kinds[name], columns[name] = _kind(model, name), values
    # rows of numbers inside u=, locked= and targets= are swept as well; single numbers stay
    for place in ("u", "locked", "targets"):
        named = stays.get(place)
        if not isinstance(named, Mapping):
            continue
        moved = {n: v for n, v in named.items() if np.ndim(v) == 1 and _single(model, n)}
        stays[place] = {n: v for n, v in named.items() if n not in moved}
        for name, values in moved.items():
            kinds[name], columns[name] = place, values
    if "targets" in stays:
        stays["u"] = by_entry(model, stays.get("u", {}))
    if not columns:
        raise ModelError(
            "swept: say what changes, from where to where, such as root_locus(P=(0, 10)) or "
            "campbell(spin=(0, 300))"
        )
    if not (count is None or (isinstance(count, int) and count > 1)):
        raise ModelError(f"count={brief(count)}: a number of members, at least 2")
    columns_of_values = {
        name: column(name, values, count or COUNT) for name, values in columns.items()
    }
    # members take one value of every column, so columns must match
    if len({len(column) for column in columns_of_values.values()}) > 1:
        said = ", ".join(
            f"'{name}' has {len(column)}" for name, column in columns_of_values.items()
        )
        raise ArgumentError(f"all that changes goes together: {said} values")
    chosen = None if coordinates is None else tuple(listed("coordinates", coordinates, "steer"))
    return Family(model, columns_of_values, kinds, stays, chosen)


def _single(model: LoadedModel, name: str) -> bool:
    """True when a name has one value, so that several are a sweep."""
    single = {*model.coordinates, *model.speeds}
    single |= {row.name for row in model.manifest.outputs}
    single |= {name.removesuffix(".u") for name in model.speeds}
    return name in single


def _kind(model: LoadedModel, name: str) -> str:
    """Block to which a varied quantity belongs."""
    if name in model.parameters:
        return "parameters"
    if name in model.inputs:
        return "inputs"
    if name == TIME:
        return TIME
    if name in model.speeds or f"{name}.u" in model.speeds:
        return "u"
    names = (*model.inputs, *model.speeds, *model.parameters)
    raise ModelError(
        f"there is no parameter, input or speed '{name}' to change; coordinates are moved by "
        f"locked={{'...': (0, 1)}}.{near(name, names)}"
    )
