"""One function of a model, ready to be called by an address."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping
from dataclasses import field, replace

from ...errors import BuildError
from ...records import dataclass
from ...schema.c_functions import FunctionRow
from ..build.object_file import Object
from . import webassembly
from .interpreted import Interpreted
from .lanes import Recipe


@dataclass(frozen=True)
class Code:
    """A compiled C function.

    Attributes:
        symbol: Its C name.
        entry: Its entry in the manifest.
        fresh: True until it is checked.
        address: Of ``symbol``, or of what evaluates it where there is no compiler.
        prepare: Address of ``prepare_symbol``; 0 without a compiler.
        built: The shared object it lives in, None without a compiler.
        library: Keeps it loaded.
        interpreted: What is evaluated instead where there is no compiler.
        wasm: The WebAssembly that ``symbol`` stands for there, if it can be run.
        recipe: What its lane builds are made of, None without a compiler.
        blocks: Numbers of each input block that the C reads, as its object says.
        lanes: States that it takes side by side, with parameters of their own where several.
    """

    symbol: str
    entry: FunctionRow = field(repr=False)
    fresh: bool
    address: int = 0
    prepare: int = 0
    built: Object | None = None
    library: ctypes.CDLL | None = field(default=None, repr=False)
    interpreted: Interpreted | None = field(default=None, repr=False)
    wasm: webassembly.Compiled | None = field(default=None, repr=False)
    recipe: Recipe | None = field(default=None, repr=False)
    blocks: dict[str, int] = field(default_factory=dict, repr=False)
    lanes: int = 1

    def take(self, blocks: Mapping[str, int]) -> None:
        """Make sure that blocks of these sizes are what the C reads.

        Raises:
            BuildError: it reads more or less.
        """
        for name, size in blocks.items():
            if self.blocks.get(name, 0) not in (0, size):
                raise BuildError(
                    f"{self.symbol} reads {self.blocks[name]} numbers of '{name}', its manifest "
                    f"gives {size}. Compile or export the model again"
                )

    def discard(self) -> None:
        """Nobody finds its object in the cache."""
        if self.built is not None:
            self.built.discard()

    def checked(self) -> Code:
        """The same after its check: its object goes into the cache."""
        built = None if self.built is None else replace(self.built.published(), fresh=False)
        return replace(self, fresh=False, built=built)
