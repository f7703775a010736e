"""Cython: a package that calls the exported C from NumPy, free of cardan."""

from __future__ import annotations

import json
import keyword
import sys
from collections.abc import Sequence

from ...schema.blocks import ARGUMENTS, ORDER, SLOT
from ...schema.c_functions import FunctionRow, ResultRow
from ...schema.functions import FUNCTIONS
from ...schema.manifest import Manifest
from ..program.naming import mangle
from ..sources import source
from .binding import Binding, BoundModel, about, arguments, literal, plain, summary
from .binding import names as listed_names
from .binding import sizes as block_sizes

SUFFIX = ".pyx"
SIZED = ("q", "q0", "r", "wrench", "u", "udot", "lam", "tau", "du", "z", "s")
NEEDED = ("numpy", "cython", "setuptools", "setup", "cardan")

HEAD = '''\
# cython: language_level=3
"""{title}

{about}

States are arrays with leading axes that broadcast; speeds u are what robotics calls v, quaternions
are (w, x, y, z), 6-vectors have the angular part first, units are SI and radians. ``parameters``
is a mapping of names to new values, or None for those of the model.
"""

from cpython.buffer cimport PyBUF_C_CONTIGUOUS, PyBUF_FORMAT, PyBuffer_Release
from cpython.exc cimport PyErr_Clear
from libc.stdlib cimport free, malloc
from libc.string cimport memset

import numpy as np

cdef extern from "Python.h":
    int PyObject_GetBuffer(object exporter, Py_buffer *view, int flags) noexcept


cdef extern from "functions.h" nogil:
    ctypedef struct cardan_in:
        const double *t
    ctypedef struct cardan_exported_function:
        const char *name
        int (*function)(const cardan_in *, double *, double *) noexcept nogil
        void (*prepare)(const double *, double *) noexcept nogil
        Py_ssize_t out, work, w
    ctypedef struct cardan_export:
        Py_ssize_t nq, nz, ns, nr
        const double *p
        const double *q
        const double *z
        const double *s
        const double *r
        const cardan_exported_function *functions
    const cardan_export cardan_scene

NAME = {name!r}
COORDINATES = {coordinates}
SPEEDS = {speeds}
INPUTS = {inputs}
PARAMETERS = {parameters}
BODIES = {bodies}

_SIZES = {sizes}
_SLOTS = {slots}
# lengths of v, in which every function has entries of its own
_VECTORS = {vectors}

cdef enum:
    BLOCKS = {blocks}
    # of all blocks, and those of a state
    PLACES = {places}
    W = {w}
    SMALL_WORK = 512

cdef object ndarray = np.ndarray
cdef object empty = np.empty
cdef int NUMBERS = PyBUF_C_CONTIGUOUS | PyBUF_FORMAT


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


def package(manifest: Manifest) -> str:
    """Name of the package of a model: one that can be imported and hides nothing it needs."""
    name = mangle(manifest.name).lower()
    taken = keyword.iskeyword(name) or name in sys.stdlib_module_names or name in NEEDED
    return f"{name}_model" if taken else name


def files(model: BoundModel) -> dict[str, str | bytes]:
    """The files of the package, by name."""
    name = package(model.manifest)
    return {
        f"{name}.pyx": write(model.manifest, model.swept),
        "setup.py": SETUP.format(name=name, flags=json.dumps(list(model.flags))),
        "pyproject.toml": PROJECT.format(name=name),
    }


def write(manifest: Manifest, swept: Sequence[str] = ()) -> str:
    """The ``.pyx`` of a model; ``swept``: methods of runs that have a gradient."""
    names = listed_names(manifest)
    lengths = block_sizes(manifest) | {"lam": len(manifest.multipliers)}
    lengths["wrench"] = 6 * len(names["bodies"])
    sizes = {name: lengths[name] for name in SIZED} | {"e": len(manifest.events)}
    head = HEAD.format(
        title=plain(f"{manifest.name}: C functions of a multibody model."),
        about=plain(summary(manifest)),
        name=manifest.name,
        sizes=literal(sizes),
        slots=literal({block: k for k, block in enumerate(ORDER)}),
        blocks=len(ORDER),
        places=len(ORDER) + 2,
        w=SLOT["w"],
        vectors=literal({k: len(f.vector) for k, f in manifest.functions.items() if f.vector}),
        **{key: literal(value) for key, value in names.items()},
    )
    # what runs alone ask for, such as times of jumps, is no function of a model
    functions = [(k, f) for k, f in manifest.functions.items() if k.split("__")[0] in FUNCTIONS]
    parts = [_function(name, entry) for name, entry in functions]
    if swept:
        parts.append(f"METHODS = {literal(list(swept))}\n\n{source('package_gradient.pyx')}")
    return "\n\n".join([head + source("package.pyx"), *parts])


def _function(name: str, entry: FunctionRow) -> str:
    """The Python function of one C function."""
    takes = arguments(name, entry)
    # solvers call rhs(t, x)
    optional = [block for block in takes if ARGUMENTS[block].default]
    left = {block: "0.0" if block == "t" else "None" for block in optional}
    if "x" in takes:
        del left["t"]
    needed = [block for block in takes if block not in left]
    options = [f"{block}={default}" for block, default in left.items()]
    signature = ", ".join([*needed, "*", *options, "parameters=None"])
    outputs = entry.outputs
    shape = tuple(outputs[0].shape) if len(outputs) == 1 else (entry.output_size,)
    entries = [text for o in outputs for text in _named(o)]
    # no function of C begins with an underscore
    call = f"_{name}"
    quoted = "".join(f'"{block}", ' for block in takes)
    lines = [f'cdef _Function {call} = _Function(b"{name}", ({quoted}), {shape!r})', "", ""]
    lines += [f"def {name}({signature}):", f'    """{plain(entry.about or name)}.', "", "    Args:"]
    lines += [f"        {block}: {about(block, entry)}" for block in takes]
    lines += ["", "    Returns:", f"        Array (..., {', '.join(map(str, shape))})"]
    lines[-1] += f": {plain(', '.join(entries))}" if len(entries) <= 12 else ""
    lines += ['    """']
    row = "".join(f"{block}, " for block in takes)
    lines += [f"    return {call}.call(({row}), parameters)", ""]
    return "\n".join(lines)


def _named(output: ResultRow) -> list[str]:
    """Entries of a result with their units."""
    units = output.units or [""] * len(output.entries)
    pairs = zip(output.entries, units, strict=True)
    return [f"{entry} [{unit}]" if unit else entry for entry, unit in pairs]


BINDING = Binding(
    package,
    files,
    "`{package}.pyx`, `setup.py`",
    "a package for NumPy: `pip install .`, then `import {package}`",
)
