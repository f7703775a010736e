"""The C functions of a model directory: compiled on first use, loaded."""

from __future__ import annotations

import ctypes
import hashlib
import json
import threading
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ... import processes, regular_file
from ...build_progress import listed, stage
from ...errors import BuildError, CompilerMissing, DerivationError, ModelError, near
from ...schema.manifest import Manifest, from_file
from ..build import cache, prebuilt
from ..build.object_file import Object
from ..build.toolchain import Compiler
from . import webassembly
from .abi_ctypes import LOADED, block_sizes
from .code import Code
from .interpreted import Interpreted, announce
from .lanes import Recipe

if TYPE_CHECKING:
    from ...ir.function import Function
    from ...ir.trees.assembly import Form
    from .batch import Batch

Key = tuple[str, str | None]
# writes what is missing of functions, gives their C names
Provide = Callable[[Sequence[Key]], list[str]]


class Objects:
    """Loaded functions of one directory; safe to use from several threads.

    Attributes:
        directory: Where ``manifest.json`` and the C files are.
        manifest: As read; grows when functions are provided.
        lock: Held while functions are loaded and checked.
        threads: Of large batches; None for the default.
        dtype: Of what batches may be: ``"float64"``, or ``"float32"`` too.
        batches: What goes through many states, by C name and type of numbers.
        lanes: Functions that are compiled for several states side by side alone, by C name.
        available: Names of the functions that it may have; None: all that the manifest lists.
    """

    def __init__(
        self,
        directory: Path,
        provide: Provide | None = None,
        reproducible: bool = False,
        threads: int | None = None,
        available: Sequence[str] | None = None,
        translate: webassembly.Translate | None = None,
        dtype: str = "float64",
    ) -> None:
        self.directory = Path(directory)
        self.reproducible = reproducible
        self.threads = threads
        self.dtype = dtype
        self.batches: dict[str, dict[str, Batch]] = {}
        self.lanes: dict[str, int] = {}
        self.tables: Any = None  # of elements: what no parameter changes
        self.joint_sources: object = (
            None  # of elements: where the saved states of nodes find joints
        )
        self.mesh: Any = None  # parameters (np,) and the elements that were loaded for them first
        self.entries_read: dict[tuple[str, str], frozenset[int]] = {}  # by function and block
        self.sizes: dict[bytes, float] = {}  # of the mechanism, by parameters
        self.reference: tuple[tuple[Any, ...], Any] | None = (
            None  # of the last judgement, and for what
        )
        self._provide, self._translate = provide, translate
        # others compile the same scene in the same folder, with other functions
        self.available = available
        self.lock = threading.RLock()
        self._loaded: dict[str, Code] = {}
        self._symbols: dict[Key, str] = {}
        self._saved: dict[str, Any] = {}
        self._saved_mark = (0, 0)
        self._parsed: dict[str, tuple[object, Form]] = {}
        self._straight: dict[str, tuple[Form, Function]] = {}
        self.manifest = self._read()

    @contextmanager
    def files(self) -> Iterator[Manifest]:
        """The manifest as it is now, while no other process changes the files it speaks of."""
        with processes.folder_lock(self.directory, read_only=True):
            self.manifest = self._read()
            yield self.manifest

    def _read(self) -> Manifest:
        path = self.directory / "manifest.json"
        try:
            manifest = from_file(regular_file.content(path), str(path))
        except FileNotFoundError:
            raise ModelError(
                f"{self.directory} holds no compiled model: {path} is missing"
            ) from None
        except ModelError:
            raise
        except ValueError as error:
            raise ModelError(
                f"{path} is not a manifest, or is damaged: {error}. Compile or export the model "
                "again"
            ) from None
        except OSError as error:
            raise ModelError(f"{path} cannot be read: {error.strerror or error}") from error
        if self.available is None:
            return manifest
        return manifest.replaced(available=list(self.available))

    def saved(self) -> dict[str, Any]:
        """The saved Functions of ``functions.json`` as plain data, by C name."""
        path = self.directory / "functions.json"
        try:
            status = path.stat()
            mark = (status.st_mtime_ns, status.st_size)
            # the file grows with every function that is written: read it when it has changed
            if mark != self._saved_mark:
                self._saved = self._stated(path)
                self._saved_mark = mark
        except FileNotFoundError:
            return {}
        except (ValueError, RecursionError) as error:
            raise ModelError(
                f"{path} does not hold saved functions: {error}. Compile or export the model again"
            ) from None
        except OSError as error:
            raise ModelError(f"{path} cannot be read: {error.strerror or error}") from error
        return self._saved

    def _stated(self, path: Path) -> dict[str, Any]:
        """The content of ``functions.json``, which is what the manifest says.

        Raises:
            ValueError: it is something else.
        """
        # another process writes both, one after the other
        with self.files() as manifest:
            content = regular_file.content(path)
        digest = hashlib.sha256(content).hexdigest()
        if manifest.sha256.get(path.name, digest) != digest:
            raise ValueError("it is not the file its manifest speaks of")
        statement = json.loads(content)
        if not isinstance(statement, dict):
            raise ValueError("it holds no functions by their names")
        return statement

    def function(self, name: str) -> Function:
        """A saved Function by its C name as straight-line expressions, made of plain data once."""
        from ...ir.function import Function
        from ...ir.grammar import check

        form = self.form(name)
        if isinstance(form, Function):
            return form
        straight = self._straight.get(name)
        if straight is None or straight[0] is not form:
            straight = self._straight[name] = form, check(form.straight())
        return straight[1]

    def form(self, name: str) -> Form:
        """A saved Function or recursion by its C name as it was saved, made of plain data once."""
        from ...ir.serialize import form_from_dict

        data = self.saved().get(name)
        if data is None:
            path = self.directory / "functions.json"
            raise ModelError(f"{path} does not hold '{name}'. Compile or export the model again")
        parsed = self._parsed.get(name)
        if parsed is None or parsed[0] is not data:
            # the data themselves say whether the file was read again
            parsed = self._parsed[name] = data, form_from_dict(data)
        return parsed[1]

    def symbol(self, name: str, of: str | None = None) -> str:
        """C name of one function, as :meth:`symbols`."""
        return self.symbols([(name, of)])[0]

    def symbols(self, keys: Sequence[Key]) -> list[str]:
        """C names of functions; makes sure that their texts and manifest entries exist.

        Raises:
            ModelError: the model has no such function; or it was saved without it.
        """
        with self.lock:
            if self._provide is None:
                return [self._stored(*key) for key in keys]
            symbols = self._provide(keys)
            if not self.manifest.functions.keys() >= {*symbols}:
                self.manifest = self._read()
            for symbol in {*symbols} - self.manifest.functions.keys():
                raise BuildError(f"function '{symbol}' was not written to {self.directory}")
            return symbols

    def write(self, names: Iterable[str]) -> None:
        """Write the C of functions; those that do not exist for this system are left out."""
        for name in names if self._provide is not None else ():
            try:
                self.symbol(name)
            except DerivationError:
                continue  # such as udot where M is singular: nothing to write

    def _stored(self, name: str, of: str | None) -> str:
        """C name of a function that is in the directory."""
        symbol = self.stored(name, of)
        if symbol:
            return symbol
        requested = f"('{name}', '{of}')" if of else f"'{name}'"
        raise ModelError(
            f"model '{self.manifest.name}' was compiled without {requested}. Export it again with "
            f"functions=(..., {requested}), or use it once before pickling."
            f"{near(name, self.manifest.functions)}"
        )

    def stored(self, name: str, of: str | None) -> str:
        """C name of a function that the manifest has; "" where it has none."""
        for symbol, entry in self.manifest.functions.items():
            if symbol.split("__")[0] == name and entry.of == of:
                return str(symbol)
        return ""

    def codes(self, keys: Sequence[Key]) -> list[Code]:
        """The compiled functions of keys: :meth:`load` of their :meth:`symbols`.

        Files of functions that are loaded are not read again: other parameters take no time.
        """
        with self.lock:
            missing = [key for key in keys if self._symbols.get(key) not in self._loaded]
            if missing:
                self._symbols.update(zip(missing, self.symbols(missing), strict=True))
            return self.load([self._symbols[key] for key in keys])

    def load(self, symbols: Sequence[str]) -> list[Code]:
        """The compiled functions; several that must be compiled are compiled at once.

        What is fresh is in no cache yet: :meth:`publish` or :meth:`forget` it after its check.

        Raises:
            BuildError: the compiler failed; or a text is not the one the manifest speaks of.
        """
        with self.lock:
            missing = [s for s in dict.fromkeys(symbols) if s not in self._loaded]
            if missing:
                self._verify_headers()
                self._loaded.update(zip(missing, self._compiled(missing), strict=True))
            return [self._loaded[s] for s in symbols]

    def publish(self, symbol: str) -> Code:
        """A function that passed its check: other processes may find it now."""
        self._loaded[symbol] = code = self._loaded[symbol].checked()
        return code

    def forget(self, symbols: Iterable[str]) -> None:
        """Functions that did not: they are made again when somebody asks for them."""
        for symbol in symbols:
            code = self._loaded.pop(symbol, None)
            self.batches.pop(symbol, None)
            if code is not None:
                code.discard()

    def _compiled(self, symbols: Sequence[str]) -> list[Code]:
        """Functions as C, or as expressions where there is no compiler."""
        paths = [self.text_path(symbol) for symbol in symbols]
        try:
            by = cache.compiler().for_models()
            lanes = [self.lanes.get(symbol, 1) for symbol in symbols]
            extra = [LOADED + (prebuilt.macros(n, True) if n > 1 else by.tuning) for n in lanes]
            with stage(f"model '{self.manifest.name}': compiling {listed(symbols)}"):
                built = cache.compiled_separately(
                    paths, self.directory, self.reproducible, by, extra
                )
        except CompilerMissing as missing:
            functions = [self._expressions(symbol, missing) for symbol in symbols]
            return [self._evaluated(*pair) for pair in zip(symbols, functions, strict=True)]
        try:
            return [self._connected(s, one, by) for s, one in zip(symbols, built, strict=True)]
        except BaseException:
            for one in built:
                one.discard()
            raise

    def _evaluated(self, symbol: str, function: Function) -> Code:
        """A function where there is no compiler: as WebAssembly, or as its expressions."""
        entry = self.manifest.functions[symbol]
        if self._translate is not None and webassembly.available():
            read = {*entry.inputs, "p"}
            blocks = {block.name: len(block) for block in function.inputs if block.name in read}
            one = webassembly.compiled(self._translate, function, entry, blocks)
            # written from what is saved, which passes may have left in another order
            entry = entry.replaced(work_size=one.work_size, prepared_size=one.prepared_size)
            return Code(symbol, entry, True, one.address, one.prepare, wasm=one, blocks=blocks)
        announce()
        expressions = Interpreted(function)
        return Code(symbol, entry, True, expressions.address, interpreted=expressions)

    def _connected(self, symbol: str, built: Object, by: Compiler) -> Code:
        """A function in its object.

        Raises:
            BuildError: the object does not hold what the manifest says.
        """
        entry = self.manifest.functions[symbol]
        # exports may have a prefix before all names
        name = f"{self.manifest.prefix}{symbol}"
        library = built.load()
        try:
            address = ctypes.cast(library[name], ctypes.c_void_p).value or 0
            shared = library[f"{self.manifest.prefix}prepare_{symbol}"]
            prepare = ctypes.cast(shared, ctypes.c_void_p).value or 0
            blocks = block_sizes(library, name, entry)
        except (AttributeError, ValueError) as error:
            raise BuildError(
                f"{self.directory / entry.file} does not hold what its manifest says: {error}. "
                "Compile or export the model again"
            ) from None
        path, check = self.directory / entry.file, partial(self._verify_sources, symbol)
        recipe = Recipe(name, path, self.directory, self.reproducible, by, check)
        loaded = Code(symbol, entry, built.fresh, address, prepare, built, library)
        lanes = self.lanes.get(symbol, 1)
        return replace(loaded, recipe=recipe, blocks=blocks, lanes=lanes)

    def _expressions(self, symbol: str, missing: CompilerMissing) -> Function:
        """The saved Function of a symbol.

        Raises:
            CompilerMissing: it is not saved.
            ModelError: what is saved breaks a rule.
        """
        from ...ir.serialize import from_dict

        saved = self.saved()
        if symbol not in saved:
            raise missing
        try:
            return from_dict(saved[symbol])
        except (ValueError, RecursionError) as error:
            raise ModelError(f"{self.directory / 'functions.json'}: {symbol}: {error}") from None

    def text_path(self, symbol: str) -> Path:
        """The C file of a function, whose content is what the manifest says.

        Raises:
            BuildError: it is missing or was changed.
        """
        entry = self.manifest.functions.get(symbol)
        if entry is None:
            raise BuildError(
                f"{self.directory}: its manifest has no function '{symbol}'. It was changed, or "
                "removed while this process used it: compile the model again"
            )
        path = self.directory / entry.file
        self._verify(path, entry.sha256)
        return path

    def _verify_headers(self) -> None:
        """Make sure that the headers, which the compiler reads as well, are what the manifest says.

        Raises:
            BuildError: one is missing or was changed.
        """
        if self.manifest.precision != "double":
            what = f"{self.directory} holds C in {self.manifest.precision} precision"
            raise BuildError(f"{what}: export the model with precision='double' to open it here")
        for name, stated in self.manifest.sha256.items():
            if name.endswith(".h"):
                self._verify(self.directory / Path(name).name, stated)

    def _verify_sources(self, symbol: str) -> None:
        """Make sure that all the compiler reads for a function is what the manifest says.

        Raises:
            BuildError: something is missing or was changed.
        """
        self.text_path(symbol)
        self._verify_headers()

    def _verify(self, path: Path, stated: str | None) -> None:
        """Make sure that a text is the one the manifest speaks of.

        Raises:
            BuildError: it is missing or was changed.
        """
        try:
            content = regular_file.content(path)
        except OSError as error:
            raise BuildError(f"{path} cannot be read: {error.strerror}") from error
        if stated and hashlib.sha256(content).hexdigest() != stated:
            raise BuildError(
                f"{path} is not the text its manifest speaks of: it was changed by hand or only "
                "half copied. Compile or export the model again"
            )
