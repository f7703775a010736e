"""Build the extension ``cardan.runtime.calls._abi`` and the kernels; the rest is in pyproject.toml.

It is the build backend as well, that of setuptools: it asks for a compiler where there is none.

A wheel holds the extension for every Python from 3.11 on (the limited API) and the kernels for
every level of processors like this one; its name says which glibc it needs. An editable
installation holds the kernels of this processor, beside their sources, where a build that is there
of the same sources stays. Without a compiler or Python.h cardan installs all the same: the C of a
model is then called through ctypes, and kernels are compiled at first use.

Where no C compiler is on the path, the clang of the package ziglang is used; also with
``CARDAN_GLIBC=2.17``, which asks for a wheel that runs with that glibc and newer ones.
"""

from __future__ import annotations

import importlib.util
import os
import platform
import re
import shlex
import sys
import sysconfig
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from setuptools import Distribution, Extension, build_meta, setup
from setuptools.build_meta import *  # noqa: F403
from setuptools.command.bdist_wheel import bdist_wheel
from setuptools.command.build_ext import build_ext

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "src"))

from cardan.build import cpu_levels, kernels, toolchain  # noqa: E402
from cardan.errors import BuildError  # noqa: E402
from cardan.schema import kernel_files  # noqa: E402

GLIBC = os.environ.get("CARDAN_GLIBC", "") if sys.platform == "linux" else ""
# without it (free threads, other Pythons) the extension is for the Python that builds it
LIMITED = platform.python_implementation() == "CPython" and not sysconfig.get_config_var(
    "Py_GIL_DISABLED"
)
# the first Python of the limited API, in C and in the name of a wheel
API, FIRST = "0x030B0000", "cp311"
# the oldest that is named
OLDEST_GLIBC = (2, 17)


def find_compiler() -> toolchain.Compiler | None:
    """The compiler; ziglang's clang where nothing else is there, or a glibc is named."""
    if GLIBC:
        if not toolchain.ziglang():
            return None
        target = f"{platform.machine()}-linux-gnu.{GLIBC}"
        os.environ["CC"] = f"{shlex.quote(sys.executable)} -m ziglang cc -target {target}"
    try:
        compiler = toolchain.find_compiler(lambda mark, ask: ask())
    except BuildError as error:
        print(f"cardan: {error}", file=sys.stderr)
        return None
    if "ziglang" in compiler.command:
        # its default is the processor that it runs on
        os.environ["CC"] = shlex.join([*compiler.command, *cpu_levels.family()[0].zig])
        os.environ["LDSHARED"] = f"{os.environ['CC']} -shared"
    return compiler


COMPILER = find_compiler()


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
        define_macros=[("Py_LIMITED_API", API)] if LIMITED else [],
        py_limited_api=LIMITED,
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
        if self.inplace:
            # one for a single Python would be imported rather than that for all
            for old in (HERE / "src/cardan/runtime/calls").glob("_abi.*"):
                if old.suffix in (".so", ".pyd"):
                    # in use on Windows
                    with suppress(OSError):
                        old.unlink()
        super().run()
        if COMPILER is None:
            return
        root = HERE / "src" if self.inplace else Path(self.build_lib).resolve()
        chosen = () if self.inplace else cpu_levels.of_wheels()
        try:
            kernels.install(root / "cardan" / "kernels" / "built", chosen, COMPILER, print)
        except (BuildError, OSError) as error:
            print(f"cardan: kernels will be compiled at first use: {error}", file=sys.stderr)


class Wheel(bdist_wheel):
    """Named after the glibc that its files need."""

    def get_tag(self) -> tuple[str, str, str]:
        """Python, ABI and platform."""
        python, abi, system = super().get_tag()
        needed = glibc(Path(self.bdist_dir))
        if needed and system.startswith("linux_"):
            system = f"manylinux_{needed[0]}_{needed[1]}_{system.removeprefix('linux_')}"
        return python, abi, system


def glibc(folder: Path) -> tuple[int, int] | None:
    """The oldest glibc that has what the shared objects below a folder ask for; None without any.

    The names of versions stand as text in a shared object, those that it needs and no others.
    """
    texts = [path.read_bytes() for path in folder.rglob("*.so")]
    rows = [match for text in texts for match in re.findall(rb"\0GLIBC_(\d+)\.(\d+)", text)]
    return max([OLDEST_GLIBC, *((int(a), int(b)) for a, b in rows)]) if rows else None


class Compiled(Distribution):
    """What is installed holds compiled code wherever there is a compiler."""

    def has_ext_modules(self) -> bool:
        """Whether build_ext has something to do."""
        return COMPILER is not None


def _missing() -> list[str]:
    """The package that compiles where nothing else does, or not for the glibc that is named."""
    there_is = platform.machine().lower() in ("x86_64", "amd64", "aarch64", "arm64")
    return ["ziglang"] if COMPILER is None and there_is else []


def get_requires_for_build_wheel(settings: Mapping[str, object] | None = None) -> list[str]:
    """What a wheel is built with."""
    return [*build_meta.get_requires_for_build_wheel(settings), *_missing()]


def get_requires_for_build_editable(settings: Mapping[str, object] | None = None) -> list[str]:
    """What an editable installation is built with."""
    return [*build_meta.get_requires_for_build_editable(settings), *_missing()]


if __name__ == "__main__":
    setup(
        ext_modules=extensions(),
        cmdclass={"build_ext": Build, "bdist_wheel": Wheel},
        distclass=Compiled,
        options={"bdist_wheel": {"py_limited_api": FIRST}} if COMPILER and LIMITED else {},
    )
