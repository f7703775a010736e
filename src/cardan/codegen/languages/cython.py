"""Cython: a package that calls the exported C from NumPy, free of cardan."""

from __future__ import annotations

import json
import keyword
import sys
from collections.abc import Sequence
from pprint import pformat
from typing import Any

from ...errors import counted
from ...ir.request import reads
from ...schema.blocks import ARGUMENTS, ORDER
from ..naming import mangle

SUFFIX = ".pyx"
NEEDED = ("numpy", "cython", "setuptools", "setup", "cardan")

HEAD = '''\
# cython: language_level=3
"""{title}

{about}

States are arrays with leading axes that broadcast; speeds u are what robotics calls v, quaternions
are (w, x, y, z), 6-vectors have the angular part first, units are SI and radians. ``parameters``
is a mapping of names to new values, or None for those of the model.
"""

from libc.stdlib cimport free, malloc

import numpy as np

cdef extern from "functions.h" nogil:
    ctypedef struct cardan_in:
        const double *t
    const double cardan_default_p[]
    const double cardan_default_q[]
    const double cardan_default_r[]
{externs}

ctypedef int (*function)(const cardan_in *, double *, double *) noexcept nogil
ctypedef void (*preparation)(const double *, double *) noexcept nogil

NAME = {name!r}
COORDINATES = {coordinates}
SPEEDS = {speeds}
INPUTS = {inputs}
PARAMETERS = {parameters}
BODIES = {bodies}

_SIZES = {sizes}
_STARTS = {starts}
'''

BODY = '''

class SingularError(ArithmeticError):
    """A linear system of the model has no solution at the given state."""


def _entries(block, value, names, start):
    """A block as numbers: a mapping changes some of the entries, None leaves them as they are."""
    if value is not None and not hasattr(value, "items"):
        return np.asarray(value, dtype=float)
    found = np.array(start, dtype=float)
    for name, number in dict(value or {}).items():
        if name not in names:
            raise KeyError(f"{block}: there is no {name!r}. Known: {', '.join(names)}")
        found[names.index(name)] = number
    return found


def _defaults(block):
    cdef Py_ssize_t k
    if block == "q":
        return [cardan_default_q[k] for k in range(len(COORDINATES))]
    if block == "r":
        return [cardan_default_r[k] for k in range(len(INPUTS))]
    if block == "p":
        return [cardan_default_p[k] for k in range(len(PARAMETERS))]
    return _STARTS.get(block) or np.zeros(_SIZES[block])


_NAMES = {"q": COORDINATES, "q0": COORDINATES, "u": SPEEDS, "r": INPUTS}


def _array(block, value):
    """A block (..., n) as contiguous numbers."""
    if block == "t":
        return np.asarray(value, dtype=float)[..., None]
    found = _entries(block, value, _NAMES.get(block, ()), _defaults(block))
    size = _SIZES[block]
    if found.ndim == 0 or found.shape[-1] != size:
        raise ValueError(f"{block} must have shape (..., {size}), not {found.shape}")
    return found


cdef object _call(
    function f, preparation prepare, tuple blocks, tuple values, object parameters,
    Py_ssize_t out_size, Py_ssize_t work_size, Py_ssize_t w_size, tuple shape,
):
    """Run a function at every state."""
    arrays = [_array(block, value) for block, value in zip(blocks, values)]
    lead = np.broadcast_shapes(*(a.shape[:-1] for a in arrays))
    cdef Py_ssize_t count = int(np.prod(lead, dtype=np.intp)), i, k
    given = _entries("parameters", parameters, PARAMETERS, _defaults("p"))
    if given.shape != (len(PARAMETERS),):
        raise ValueError(f"parameters must have shape ({len(PARAMETERS)},), not {given.shape}")
    cdef double[::1] p = np.append(given, 0.0)
    cdef double[::1] w = np.zeros(w_size + 1)
    prepare(&p[0], &w[0])
    result = np.empty((count, out_size))
    cdef double[::1] out = result.reshape(-1) if count * out_size else np.empty(1)
    cdef const double *at[16]
    cdef Py_ssize_t step[16]
    cdef double[::1] flat
    for k in range(16):
        at[k], step[k] = NULL, 0
    held = []
    for block, array in zip(blocks, arrays):
        wide = np.broadcast_to(array, lead + array.shape[-1:])
        flat = np.append(np.ascontiguousarray(wide).reshape(-1), 0.0)
        held.append(flat)
        k = _SLOTS[block]
        at[k], step[k] = &flat[0], array.shape[-1]
    at[_SLOTS["w"]] = &w[0]
    cdef double *work = <double *>malloc((work_size + 1) * sizeof(double))
    cdef int status = 0, one
    if work == NULL:
        raise MemoryError()
    with nogil:
        for i in range(count):
            one = f(<const cardan_in *>at, &out[0] + i * out_size, work)
            status |= one
            for k in range(16):
                if at[k] != NULL:
                    at[k] += step[k]
    free(work)
    if status:
        raise SingularError(f"a linear system has no solution (status {status})")
    return result.reshape(lead + shape)
'''

SETUP = '''\
"""Build the package: pip install .   or   python setup.py build_ext --inplace"""

from pathlib import Path

from Cython.Build import cythonize
from setuptools import Extension, setup

SOURCES = sorted(path.name for path in Path(__file__).parent.glob("*.c"))
FLAGS = {flags}
EXTENSION = Extension(
    "{name}", ["{name}.pyx", *SOURCES], include_dirs=["."], extra_compile_args=FLAGS
)

setup(ext_modules=cythonize([EXTENSION], build_dir="build"))
'''

PROJECT = """\
[build-system]
requires = ["setuptools>=77", "cython>=3.0"]
build-backend = "setuptools.build_meta"

[project]
name = "{name}"
version = "1.0"
description = "C functions of a multibody model, for NumPy"
dependencies = ["numpy"]

[tool.setuptools]
packages = []
"""


def package(manifest: dict[str, Any]) -> str:
    """Name of the package of a model: one that can be imported and hides nothing it needs."""
    name = mangle(manifest["name"]).lower()
    taken = keyword.iskeyword(name) or name in sys.stdlib_module_names or name in NEEDED
    return f"{name}_model" if taken else name


def files(manifest: dict[str, Any], flags: Sequence[str]) -> dict[str, str]:
    """The files of the package, by name.

    Args:
        manifest: Of the model, with the functions to export.
        flags: For the compiler.
    """
    name = package(manifest)
    return {
        f"{name}.pyx": write(manifest),
        "setup.py": SETUP.format(name=name, flags=json.dumps(list(flags))),
        "pyproject.toml": PROJECT.format(name=name),
    }


def write(manifest: dict[str, Any]) -> str:
    """The ``.pyx`` of a model."""
    names = {
        key: tuple(row["name"] for row in manifest[key])
        for key in ("coordinates", "speeds", "inputs", "parameters")
    }
    bodies = tuple(part for body in manifest["bodies"] for part in body["parts"])
    nq, nu = len(names["coordinates"]), len(names["speeds"])
    sizes = {"q": nq, "q0": nq, "r": len(names["inputs"]), "wrench": 6 * len(bodies)}
    sizes |= dict.fromkeys(("u", "udot", "tau", "du"), nu)
    starts = {block: tuple(row["default"] for row in manifest[block]) for block in ("z", "s")}
    sizes |= {block: len(values) for block, values in starts.items()}
    sizes["e"] = len(manifest.get("events", ()))
    functions = manifest["functions"]
    externs = "\n".join(
        f'    int c_{f} "{f}"(const cardan_in *, double *, double *) noexcept\n'
        f'    void c_prepare_{f} "prepare_{f}"(const double *, double *) noexcept'
        for f in functions
    )
    head = HEAD.format(
        title=_text(f"{manifest['name']}: C functions of a multibody model."),
        about=_text(
            f"{counted(nq, 'coordinate')}, {counted(nu, 'speed')}, "
            f"{counted(len(names['parameters']), 'parameter')}."
        ),
        externs=externs,
        name=manifest["name"],
        bodies=_literal(bodies),
        sizes=_literal(sizes),
        starts=_literal(starts),
        **{key: _literal(value) for key, value in names.items()},
    )
    slots = {block: k for k, block in enumerate(ORDER)}
    parts = [head + f"_SLOTS = {_literal(slots)}" + BODY]
    parts += [_function(name, entry, nq, nu, sizes["z"]) for name, entry in functions.items()]
    return "\n\n".join(parts)


def _function(name: str, entry: dict[str, Any], nq: int, nu: int, nz: int) -> str:
    """The Python function of one C function."""
    takes = _arguments(name, entry)
    # solvers call rhs(t, x)
    optional = [block for block in takes if ARGUMENTS[block].default]
    left = {block: "0.0" if block == "t" else "None" for block in optional}
    if "x" in takes:
        del left["t"]
    needed = [block for block in takes if block not in left]
    options = [f"{block}={default}" for block, default in left.items()]
    signature = ", ".join([*needed, "*", *options, "parameters=None"])
    outputs = entry["outputs"]
    shape = tuple(outputs[0]["shape"]) if len(outputs) == 1 else (entry["output_size"],)
    entries = [text for o in outputs for text in _named(o)]
    lines = [
        f"def {name}({signature}):",
        f'    """{_text(entry["about"] or name)}.',
        "",
        "    Args:",
    ]
    lines += [f"        {block}: {ARGUMENTS[block].text}" for block in takes]
    lines += ["", "    Returns:", f"        Array (..., {', '.join(map(str, shape))})"]
    lines[-1] += f": {_text(', '.join(entries))}" if len(entries) <= 12 else ""
    lines += ['    """']
    blocks, values = list(takes), list(takes)
    if "x" in takes:
        lines += ["    x = np.asarray(x, dtype=float)"]
        at = takes.index("x")
        rest = f"x[..., {nq}:{nq + nu}]" if nz else f"x[..., {nq}:]"
        parts = {"q": f"x[..., :{nq}]", "u": rest} | ({"z": f"x[..., {nq + nu}:]"} if nz else {})
        blocks[at : at + 1], values[at : at + 1] = [*parts], [*parts.values()]
    row = ", ".join(f'"{block}"' for block in blocks)
    numbers = ", ".join(str(entry[f"{k}_size"]) for k in ("output", "work", "prepared"))
    lines += [
        "    return _call(",
        f"        c_{name}, c_prepare_{name}, ({row},), ({', '.join(values)},), parameters,",
        f"        {numbers}, {shape!r},",
        "    )",
        "",
    ]
    return "\n".join(lines)


def _arguments(name: str, entry: dict[str, Any]) -> list[str]:
    """Arguments as a compiled model takes them, as far as the C can read them."""
    letters = reads(name.split("__")[0], entry["of"])
    usual = (*entry["inputs"], "t", "r")
    return [x for x in letters if not ARGUMENTS[x].default or x in usual]


def _named(output: dict[str, Any]) -> list[str]:
    """Entries of a result with their units."""
    units = output["units"] or [""] * len(output["entries"])
    pairs = zip(output["entries"], units, strict=True)
    return [f"{entry} [{unit}]" if unit else entry for entry, unit in pairs]


def _literal(value: Any) -> str:
    """Python text of names and numbers, wrapped."""
    return pformat(value, width=96, compact=True, sort_dicts=False)


def _text(words: str) -> str:
    """Words of the user inside a docstring."""
    plain = "".join(c if c.isprintable() else " " for c in words)
    return plain.replace("\\", "\\\\").replace('"', "'")
