"""The functions of a model as its own C: loaded, checked, published."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, final

from ...build_progress import listed, stage
from ..build import cache_folder
from .code import Code
from .loaded_function import LoadedFunction, assemble, batches
from .objects import Key

if TYPE_CHECKING:
    from ..models.loaded_model import LoadedModel


REGULAR = "regular"  # an empty file beside the C of a model whose accelerations have digits
SOLVING = ("forward_dynamics", "rhs")


def _solves(name: str, of: str | None) -> bool:
    """True for accelerations and their derivatives."""
    return name in SOLVING or (of is not None and of.split(":")[0] in SOLVING)


def _mark(folder: Path) -> Path | None:
    """The file that says so of a folder of the cache; None for one that users look after."""
    return folder / REGULAR if folder.parent == cache_folder.directory() / "models" else None


class Source(ABC):
    """Source of the functions of a model."""

    @abstractmethod
    def add(self, model: LoadedModel, missing: Sequence[Key]) -> None:
        """Load functions into ``model._functions``; nobody gets one before it is checked."""

    @abstractmethod
    def mesh(self, model: LoadedModel) -> int:
        """Address of the tables of elements in C, 0 where functions know the whole model."""

    @abstractmethod
    def codes(self, model: LoadedModel) -> list[Code]:
        """The compiled functions that the derivative of a state consists of."""


@final
class Generated(Source):
    """Every function is C of its own."""

    def add(self, model: LoadedModel, missing: Sequence[Key]) -> None:
        """Load functions, check those that were compiled now, and publish them."""
        objects, loaded = model._objects, model._functions
        codes = objects.codes(missing)
        fresh = {key: c.symbol for key, c in zip(missing, codes, strict=True) if c.fresh}
        mark = _mark(objects.directory)
        # what a check warned of is said by every process, whoever compiled
        unsettled = [
            key
            for key in missing
            if key not in fresh and mark is not None and _solves(*key) and not mark.exists()
        ]
        try:
            for (name, of), code in zip(missing, codes, strict=True):
                arguments = model._layout.reads(name, of, code.entry.vector)
                if code.symbol not in objects.batches:
                    objects.batches[code.symbol] = batches(
                        code, arguments, objects.threads, objects.dtype
                    )
                ways = objects.batches[code.symbol]
                loaded[name, of] = assemble(name, of, code, arguments, model.parameters, ways)
            checked = [*fresh, *unsettled]
            if checked:
                names = listed([" of ".join(filter(None, key)) for key in checked])
                with stage(f"model '{model.name}': checking {names}"):
                    regular = model._verify_built(checked)
                if regular and mark is not None and any(_solves(*key) for key in checked):
                    with suppress(OSError):  # else it is checked again
                        mark.touch()
            for key, symbol in fresh.items():
                function: LoadedFunction = loaded[key]
                loaded[key] = replace(function, code=objects.publish(symbol))
        except BaseException:
            for key in missing:
                loaded.pop(key, None)
            objects.forget(fresh.values())
            raise

    def mesh(self, model: LoadedModel) -> int:
        """None."""
        return 0

    def codes(self, model: LoadedModel) -> list[Code]:
        """``rhs`` alone."""
        return [model._function("rhs").code]
