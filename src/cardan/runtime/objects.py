"""The C functions of a model directory: compiled on first use, loaded."""

from __future__ import annotations

import ctypes
import hashlib
import json
import os
import threading
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ..errors import BuildError, DerivationError, ModelError, near
from . import cache

ABI = 1
SCHEMA = 1
Provide = Callable[[str, str | None], str]
Key = tuple[str, str | None]


@dataclass(frozen=True)
class Code:
    """A compiled C function.

    Attributes:
        symbol: Its C name.
        address, prepare: Addresses of ``symbol`` and ``prepare_symbol``.
        entry: Its entry in the manifest.
        built: The shared object it lives in.
        library: Keeps it loaded.
    """

    symbol: str
    address: int
    prepare: int
    entry: dict[str, Any] = field(repr=False)
    built: cache.Object
    library: ctypes.CDLL = field(repr=False)


class Objects:
    """Loaded functions of one directory; safe to use from several threads.

    Attributes:
        directory: Where ``manifest.json`` and the C files are.
        manifest: As read; grows when functions are provided.
    """

    def __init__(
        self, directory: Path, provide: Provide | None = None, reproducible: bool = False
    ) -> None:
        self.directory = Path(directory)
        self.reproducible = reproducible
        self._provide = provide
        self._lock = threading.RLock()
        self._loaded: dict[str, Code] = {}
        self._saved: dict[str, Any] = {}
        self._saved_mark = (0, 0)
        self.manifest: dict[str, Any] = self._read()

    def _read(self) -> dict[str, Any]:
        path = self.directory / "manifest.json"
        try:
            manifest: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
        except FileNotFoundError:
            raise ModelError(
                f"{self.directory} holds no compiled model: {path} is missing"
            ) from None
        except ValueError as error:
            raise ModelError(f"{path} is not a manifest: {error}") from None
        for name, known in (("abi", ABI), ("schema", SCHEMA)):
            if manifest.get(name) != known:
                raise ModelError(
                    f"{path}: {name} version {manifest.get(name)} cannot be read, this cardan "
                    f"reads {known}. Compile the model again"
                )
        return manifest

    def saved(self) -> dict[str, Any]:
        """The saved Functions of ``functions.json`` as plain data, by C name."""
        path = self.directory / "functions.json"
        try:
            status = path.stat()
            mark = (status.st_mtime_ns, status.st_size)
            # the file grows with every function that is written: read it when it has changed
            if mark != self._saved_mark:
                self._saved = json.loads(path.read_text(encoding="utf-8"))
                self._saved_mark = mark
        except FileNotFoundError:
            return {}
        except ValueError as error:
            raise ModelError(f"{path} does not hold saved functions: {error}") from None
        return self._saved

    def symbol(self, name: str, of: str | None = None) -> str:
        """C name of a function; makes sure that its text and manifest entry exist.

        Raises:
            ModelError: the model has no such function; or it was saved without it.
        """
        with self._lock:
            if self._provide is not None:
                symbol = self._provide(name, of)
                if symbol not in self.manifest["functions"]:
                    self.manifest = self._read()
            else:
                symbol = self._stored(name, of)
            if symbol not in self.manifest["functions"]:
                raise BuildError(f"function '{symbol}' was not written to {self.directory}")
            return symbol

    def write(self, names: Iterable[str]) -> None:
        """Write the C of functions; those that do not exist for this system are left out."""
        for name in names if self._provide is not None else ():
            try:
                self.symbol(name)
            except DerivationError:
                # such as udot where M is singular: nothing to write
                continue

    def _stored(self, name: str, of: str | None) -> str:
        """C name of a function that is in the directory."""
        functions = self.manifest["functions"]
        for symbol, entry in functions.items():
            if symbol.split("__")[0] == name and entry.get("of") == of:
                return str(symbol)
        asked = f"('{name}', '{of}')" if of else f"'{name}'"
        raise ModelError(
            f"model '{self.manifest['name']}' was compiled without {asked}. Export it again with "
            f"functions=(..., {asked}), or use it once before pickling.{near(name, functions)}"
        )

    def load(self, symbols: Sequence[str]) -> list[Code]:
        """The compiled functions; several that must be compiled are compiled at once.

        Raises:
            BuildError: the compiler failed; or a text is not the one the manifest speaks of.
        """
        with self._lock:
            missing = [s for s in dict.fromkeys(symbols) if s not in self._loaded]
            if len(missing) > 1:
                with ThreadPoolExecutor(min(len(missing), os.cpu_count() or 1)) as pool:
                    made = list(pool.map(self._build, missing))
            else:
                made = [self._build(s) for s in missing]
            for symbol, built in zip(missing, made, strict=True):
                self._loaded[symbol] = self._open(symbol, built)
            return [self._loaded[s] for s in symbols]

    def _build(self, symbol: str) -> cache.Object:
        path = self.text_path(symbol)
        return cache.build([path], [self.directory], self.reproducible)

    def _open(self, symbol: str, built: cache.Object) -> Code:
        library = ctypes.CDLL(str(built.path))
        address = ctypes.cast(getattr(library, symbol), ctypes.c_void_p).value or 0
        prepare = ctypes.cast(getattr(library, f"prepare_{symbol}"), ctypes.c_void_p).value or 0
        entry = self.manifest["functions"][symbol]
        return Code(symbol, address, prepare, entry, built, library)

    def text_path(self, symbol: str) -> Path:
        """The C file of a function, whose content is what the manifest says.

        Raises:
            BuildError: it is missing or was changed.
        """
        entry = self.manifest["functions"][symbol]
        path: Path = self.directory / entry["file"]
        if path.parent != self.directory:
            raise BuildError(f"the manifest of {self.directory} names a file outside: {path}")
        try:
            content = path.read_bytes()
        except OSError as error:
            raise BuildError(f"{path} cannot be read: {error.strerror}") from error
        stated = entry.get("sha256") or self.manifest["sha256"].get(entry["file"])
        if stated and hashlib.sha256(content).hexdigest() != stated:
            raise BuildError(
                f"{path} is not the text its manifest speaks of: it was changed by hand or only "
                "half copied. Compile the model again, or correct its sha256 in the manifest"
            )
        return path
