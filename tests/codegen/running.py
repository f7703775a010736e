"""Compiles generated C and calls it, for tests; shares nothing with the runtime."""

from __future__ import annotations

import ctypes
import hashlib
import shutil
import subprocess
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from tempfile import mkdtemp

import numpy as np

from cardan.codegen import CFile
from cardan.ir.function import Function
from cardan.ir.interpreter import evaluate
from cardan.schema import kernel_files

STRICT = ("-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror")
SPEED = ("-O2", "-fno-tree-vectorize", "-fno-math-errno")
EXACT = (*STRICT, *SPEED, "-ffp-contract=off")
# what cardan gives: all sums of products fused, whatever processor the compiler tunes for
CONTRACT = {
    "gcc": ("-ffp-contract=fast", "--param=avoid-fma-max-bits=0"),
    "clang": ("-ffp-contract=on",),
}
ORDER = (
    *("t", "q", "u", "z", "s", "r", "p", "w", "udot", "zdot", "lam", "tau", "wrench", "du", "q0"),
    *("e", "v"),
)

ZIG = (sys.executable, "-m", "ziglang", "cc")


@cache
def compilers() -> dict[str, tuple[str, ...]]:
    """The compilers to test with: gcc (or cc) and clang as ziglang brings it."""
    found = {}
    plain = shutil.which("gcc") or shutil.which("cc")
    if plain:
        found["gcc"] = (plain,)
    if subprocess.run([*ZIG, "--version"], capture_output=True, check=False).returncode == 0:
        found["clang"] = ZIG
    return found


@cache
def _folder() -> Path:
    return Path(mkdtemp(prefix="cardan-test-"))


@cache
def shared(text: str, compiler: str, flags: Sequence[str] = EXACT) -> ctypes.CDLL:
    """The shared object of a C text; a warning is a failure.

    Raises:
        AssertionError: with what the compiler said.
    """
    stem = _folder() / hashlib.sha256(f"{text}{compiler}{flags}".encode()).hexdigest()[:24]
    stem.with_suffix(".c").write_text(text, "utf-8")
    command = [
        *compilers()[compiler],
        *flags,
        "-shared",
        "-fPIC",
        *(f"-I{folder}" for folder in kernel_files.includes()),
    ]
    command += ["-o", f"{stem}.so", f"{stem}.c", "-lm"]
    answer = subprocess.run(command, capture_output=True, text=True, check=False)
    assert answer.returncode == 0, f"{compiler}: {answer.stderr[:3000]}\n{text[:2000]}"
    return ctypes.CDLL(f"{stem}.so")


class Inputs(ctypes.Structure):
    """``cardan_in``."""

    _fields_ = tuple((name, ctypes.POINTER(ctypes.c_double)) for name in ORDER)


@dataclass(frozen=True)
class Answer:
    """Results of a call: status, out, and w as the prepare function made it."""

    status: int
    out: np.ndarray
    w: np.ndarray


def call(
    cfile: CFile,
    values: Mapping[str, Sequence[float]],
    compiler: str = "",
    flags: Sequence[str] = EXACT,
    text: str = "",
) -> Answer:
    """Prepare and call a generated function.

    The arrays have guard values behind them, and blocks that the entry does not name are NULL.

    Args:
        text: C that holds the function among others.
    """
    compiler = compiler or next(iter(compilers()))
    library, entry = shared(text or cfile.text, compiler, tuple(flags)), cfile.entry
    w, out, work = (guarded(entry[f"{k}_size"]) for k in ("prepared", "output", "work"))
    p = np.array(values.get("p", [0.0]), dtype=float)
    getattr(library, f"prepare_{cfile.name}")(pointer(p), pointer(w))
    given = {n: np.array(values[n], dtype=float) for n in entry["inputs"] if n != "p"}
    assert {*given} <= {*ORDER}
    blocks = Inputs(**{n: pointer(v) for n, v in given.items()}, w=pointer(w))
    status = getattr(library, cfile.name)(ctypes.byref(blocks), pointer(out), pointer(work))
    for array in (w, out, work):
        assert (array[-4:] == 12345.0).all(), "something was written behind an array"
    return Answer(status, out[:-4], w[:-4])


def guarded(size: int) -> np.ndarray:
    """An array of NaN with guards behind it."""
    return np.concatenate([np.full(size, np.nan), np.full(4, 12345.0)])


def pointer(array: np.ndarray) -> object:
    return array.ctypes.data_as(ctypes.POINTER(ctypes.c_double))


def expected(function: Function, values: Mapping[str, Sequence[float]]) -> np.ndarray:
    """What the interpreter says, outputs one after the other."""
    found = evaluate(function, values)
    return np.array([float(x) for o in function.outputs for x in found[o.name]])
