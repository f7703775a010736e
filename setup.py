"""Build the optional extension ``cardan.runtime._abi``; everything else is in pyproject.toml.

Without a compiler or Python.h the wheel installs all the same: the C of a model is then called
through ctypes. Where no C compiler is on the path, the clang of the package ziglang is used.
"""

from __future__ import annotations

import importlib.util
import os
import shutil
import sys

from setuptools import Extension, setup

KERNELS = "src/cardan/kernels"


def choose_compiler() -> None:
    """Let the build use ziglang's clang where nothing else is there."""
    found = os.environ.get("CC") or any(map(shutil.which, ("cc", "gcc", "clang")))
    if not found and importlib.util.find_spec("ziglang"):
        os.environ["CC"] = f"{sys.executable} -m ziglang cc"
        os.environ["LDSHARED"] = f"{sys.executable} -m ziglang cc -shared"


def extensions() -> list[Extension]:
    """The extension, as C; none where Cython is missing."""
    try:
        from Cython.Build import cythonize
    except ImportError:
        return []
    extension = Extension(
        "cardan.runtime._abi",
        ["src/cardan/runtime/_abi.pyx", f"{KERNELS}/map.c"],
        include_dirs=[KERNELS],
        depends=[f"{KERNELS}/map.h", f"{KERNELS}/cardan.h"],
        extra_compile_args=["-O2", "-g0"],
        optional=True,
    )
    modules: list[Extension] = cythonize([extension], build_dir="build/cython", quiet=True)
    return modules


choose_compiler()
setup(ext_modules=extensions())
