"""Build the extension ``cardan.runtime.calls._abi`` and the kernels; the rest is in pyproject.toml.

It is the build backend as well, that of setuptools: it asks for a compiler where there is none.

A wheel holds the kernels for every level of processors like this one; an editable installation
those of this processor, beside their sources, where a build that is there of the same sources
stays. Without a compiler or Python.h cardan installs all the same: the C of a model is then called
through ctypes, and kernels are compiled at first use. Where no C compiler is on the path, the clang
of the package ziglang is used.
"""

from __future__ import annotations

import importlib.util
import os
import platform
import sys
from collections.abc import Mapping
from pathlib import Path

from setuptools import Distribution, Extension, build_meta, setup
from setuptools.build_meta import *  # noqa: F403
from setuptools.command.build_ext import build_ext

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "src"))

from cardan.errors import BuildError  # noqa: E402
from cardan.runtime.build import cpu_levels, kernels, toolchain  # noqa: E402
from cardan.schema import kernel_files  # noqa: E402


def compiler() -> toolchain.Compiler | None:
    """What compiles; ziglang's clang is chosen where nothing else is there."""
    try:
        found = toolchain.find_compiler(lambda mark, ask: ask())
    except BuildError as error:
        print(f"cardan: {error}", file=sys.stderr)
        return None
    if "ziglang" in found.command:
        os.environ["CC"] = " ".join(found.command)
        os.environ["LDSHARED"] = f"{os.environ['CC']} -shared"
    return found


COMPILER = compiler()


def _relative(path: Path) -> str:
    """A path below this folder, as setuptools wants it."""
    return path.relative_to(HERE).as_posix()


def extensions() -> list[Extension]:
    """The extension, as C; none where Cython or a compiler is missing."""
    if importlib.util.find_spec("Cython") is None or COMPILER is None:
        return []
    from Cython.Build import cythonize

    extension = Extension(
        "cardan.runtime.calls._abi",
        ["src/cardan/runtime/calls/_abi.pyx", _relative(kernel_files.file("map.c"))],
        include_dirs=[_relative(folder) for folder in kernel_files.includes()],
        depends=[_relative(kernel_files.file(name)) for name in ("map.h", "cardan.h")],
        extra_compile_args=["-O2", "-g0"],
    )
    modules: list[Extension] = cythonize([extension], build_dir="build/cython", quiet=True)
    # a build that fails is a warning: cythonize does not carry this over by itself
    for module in modules:
        module.optional = True
    return modules


class Build(build_ext):
    """Compiles the kernels as well."""

    def run(self) -> None:
        """The extension first: it is quick."""
        super().run()
        if COMPILER is None:
            return
        root = HERE / "src" if self.inplace else Path(self.build_lib).resolve()
        chosen = () if self.inplace else cpu_levels.of_wheels()
        try:
            kernels.install(root / "cardan" / "kernels" / "built", chosen, COMPILER, print)
        except (BuildError, OSError) as error:
            print(f"cardan: kernels will be compiled at first use: {error}", file=sys.stderr)


class Compiled(Distribution):
    """What is installed holds compiled code wherever there is a compiler."""

    def has_ext_modules(self) -> bool:
        """Whether build_ext has something to do."""
        return COMPILER is not None


def _missing() -> list[str]:
    """The package that compiles where nothing else does."""
    there_is = platform.machine().lower() in ("x86_64", "amd64", "aarch64", "arm64")
    return ["ziglang"] if COMPILER is None and there_is else []


def get_requires_for_build_wheel(settings: Mapping[str, object] | None = None) -> list[str]:
    """What a wheel is built with."""
    return [*build_meta.get_requires_for_build_wheel(settings), *_missing()]


def get_requires_for_build_editable(settings: Mapping[str, object] | None = None) -> list[str]:
    """What an editable installation is built with."""
    return [*build_meta.get_requires_for_build_editable(settings), *_missing()]


if __name__ == "__main__":
    setup(ext_modules=extensions(), cmdclass={"build_ext": Build}, distclass=Compiled)
