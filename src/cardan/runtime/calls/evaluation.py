"""Calls of the functions of a compiled model."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Protocol

from numpy.typing import ArrayLike

from ...arrays import Array
from ...errors import ModelError, brief, near
from ...schema.functions import FUNCTIONS, STANDARD
from ...schema.manifest import Manifest
from .objects import Key

if TYPE_CHECKING:
    from .loaded_function import LoadedFunction

Values = Mapping[str, ArrayLike]
State = ArrayLike | Values


class Undetermined(Protocol):
    """States at which the reaction of a joint is not determined."""

    @property
    def joints(self) -> Sequence[str]:
        """Names of all joints of loops."""

    def least(self, reactions: Mapping[str, Array]) -> Array:
        """The reaction (..., 6) with least norm there, from those of all joints of loops."""


class Evaluation(ABC):
    """Functions on states; ``...`` are leading axes that broadcast.

    Every function takes ``parameters={name: value}`` for values other than the model's own; the
    values may have leading axes too. ``t`` and ``r`` matter where motions are prescribed.
    """

    _calls: Mapping[Key, Any]
    _derived: dict[object, Any]

    @abstractmethod
    def _evaluate(
        self, key: Key, values: tuple[object, ...], parameters: Values | None, out: Array | None
    ) -> Array:
        """Call a function, with parameter values of its own where they are given."""

    @abstractmethod
    def _function(self, name: str, of: str | None = None) -> LoadedFunction:
        """A function, loaded."""

    @abstractmethod
    def _load(self, keys: Iterable[Key]) -> list[LoadedFunction]:
        """Several functions, loaded; those that must be compiled are compiled side by side."""

    def _check_of(self, name: str, of: str | None) -> None:
        """Check that a function and its frame or joint exist.

        Raises:
            ModelError: there are not, or the system has no such function.
        """
        if name not in STANDARD:
            raise ModelError(f"function '{name}' does not exist.{near(name, STANDARD)}")
        if name in self.manifest.absent:
            raise ModelError(f"{name}: {self.manifest.absent[name]}")
        kind = FUNCTIONS[name].of
        names = self.joints if kind == "joint" else self.frames
        if kind in ("joint", "frame") and of is None:
            raise ModelError(f"{name}: {kind}=None: give the name of a {kind}.{near('', names)}")
        if kind == "formula" and not isinstance(of, str):
            raise ModelError(f"{name}: give a formula as text, such as 'x^2', not {brief(of)}")
        if kind not in ("function", "formula") and of is not None and of not in names:
            what = kind or "frame"
            raise ModelError(f"{name}: {what} '{of}' does not exist.{near(of, names)}")

    def _undetermined(
        self,
        joint: str,
        lead: tuple[int, ...],
        q: State,
        t: ArrayLike,
        r: State | None,
        parameters: Values | None,
    ) -> Undetermined | None:
        """The states at which the reaction of a joint is not determined, after a warning.

        What tells it is an analysis: models that know analyses do.
        """
        return None

    @abstractmethod
    def _vector(self, block: str, value: object) -> Array:
        """A vector given as an array or by names, as an array."""

    @abstractmethod
    def parts_of(self, x: ArrayLike) -> tuple[Array, Array, Array]:
        """q, u and z of a state x."""

    @abstractmethod
    def split(self, x: ArrayLike) -> tuple[Array, Array]:
        """q and u of a state x."""

    @property
    @abstractmethod
    def manifest(self) -> Manifest:
        """The compiler's statement about the model."""

    @property
    @abstractmethod
    def speeds(self) -> tuple[str, ...]:
        """Names of u."""

    @property
    @abstractmethod
    def bodies(self) -> tuple[str, ...]:
        """Names of the bodies that can move, in the order of the block ``wrench``."""

    @property
    @abstractmethod
    def joints(self) -> tuple[str, ...]:
        """Names of joints."""

    @property
    @abstractmethod
    def frames(self) -> tuple[str, ...]:
        """Names of frames."""

    @property
    @abstractmethod
    def part_of(self) -> dict[str, str | None]:
        """Frame -> the body it is fixed to, None for the ground."""
