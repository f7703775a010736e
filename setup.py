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


def has_compiler() -> bool:
    """Whether there is a C compiler; ziglang's clang is chosen where nothing else is there."""
    if os.environ.get("CC") or any(map(shutil.which, ("cc", "gcc", "clang"))):
        return True
    if importlib.util.find_spec("ziglang") is None:
        return False
    os.environ["CC"] = f"{sys.executable} -m ziglang cc"
    os.environ["LDSHARED"] = f"{sys.executable} -m ziglang cc -shared"
    return True


def extensions() -> list[Extension]:
    """The extension, as C; none where Cython or a compiler is missing."""
    if importlib.util.find_spec("Cython") is None or not has_compiler():
        return []
    from Cython.Build import cythonize

    extension = Extension(
        "cardan.runtime._abi",
        ["src/cardan/runtime/_abi.pyx", f"{KERNELS}/map.c"],
        include_dirs=[KERNELS],
        depends=[f"{KERNELS}/map.h", f"{KERNELS}/cardan.h"],
        extra_compile_args=["-O2", "-g0"],
    )
    modules: list[Extension] = cythonize([extension], build_dir="build/cython", quiet=True)
    # a build that fails is a warning: cythonize does not carry this over by itself
    for module in modules:
        module.optional = True
    return modules


setup(ext_modules=extensions())
