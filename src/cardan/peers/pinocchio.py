"""Pinocchio as C++ headers of its wheel, in the fastest build of the compilers here.

Source: J. Carpentier et al., The Pinocchio C++ library, SII 2019.
"""

from __future__ import annotations

import ctypes
import importlib.metadata
import shutil
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from pathlib import Path

import numpy as np

from ..api.comparison import PINOCCHIO, Coordinates, Scene, build, toolchain
from ..arrays import Array
from ..errors import BuildError
from . import coordinates
from .circuits import Circuits
from .loop import HERE, Loop, address, peer_loop
from .peer import FUNCTIONS, Contender, Peer, States
from .tree import central, depth_first, directions

KIND = {"revolute": 0, "prismatic": 1, "spherical": 2, "free": 3, "universal": 4}
# what its own build defines; Boost's lists are too short for its joints otherwise
OPTIONS = (
    "-std=c++17", "-O3", "-march=native", "-DNDEBUG", "-g0", "-DBOOST_MPL_LIMIT_LIST_SIZE=30",
    "-DBOOST_MPL_LIMIT_VECTOR_SIZE=30", "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS",
    "-DBOOST_FUSION_INVOKE_MAX_ARITY=12",
)  # fmt: skip


def _headers(package: str, file: str) -> Path | None:
    """The folder of a wheel that a header is included from."""
    try:
        entries = importlib.metadata.files(package) or ()
    except importlib.metadata.PackageNotFoundError:
        return None
    for entry in entries:
        if str(entry).endswith(f"include/{file}"):
            return Path(str(entry.locate())).resolve().parents[file.count("/")]
    return None


@cache
def _include() -> dict[str, Path | None]:
    return {
        "pip install pin": _headers("libpinocchio", "pinocchio/algorithm/aba.hpp"),
        "pip install cmeel-boost": _headers("cmeel-boost", "boost/variant.hpp"),
        "pip install cmeel-eigen": _headers("cmeel-eigen", "eigen3/Eigen/Core"),
    }


def missing() -> str:
    """Reason why the program cannot be built, "" where there is none."""
    for cure, place in _include().items():
        if place is None:
            return f"no headers: {cure}"
    return "" if cpp_compilers(()) else "no C++ compiler: pip install ziglang"


def _compilers() -> list[toolchain.Compiler]:
    """Compilers with all they need, among it what changes with the version of the headers."""
    places = [str(place) for place in _include().values() if place is not None]
    places[-1] += "/eigen3"
    version = importlib.metadata.version("libpinocchio")
    options = (*OPTIONS, f'-DPINOCCHIO_WHEEL="{version}"', *(f"-isystem{p}" for p in places))
    return cpp_compilers(options)


@cache
def _library(source: str) -> tuple[ctypes.CDLL, toolchain.Compiler]:
    """The fastest build of a file: tried once on a chain of seven hinges."""
    compilers = _compilers()
    with ThreadPoolExecutor() as pool:
        built = list(pool.map(lambda by: build([HERE / source], [HERE], by=by).load(), compilers))
    if len(built) == 1:
        return built[0], compilers[0]
    times = [_tried(library) for library in built]
    best = int(np.argmin(times))
    return built[best], compilers[best]


def _tried(library: ctypes.CDLL) -> float:
    """Seconds of forward dynamics of a small arm."""
    n = 7
    axes = np.eye(3)[[1 + i % 2 for i in range(n)]]
    inertia = np.broadcast_to(np.diag([0.1, 1.0, 1.0]), (n, 3, 3)) / 12
    turns = np.broadcast_to(np.eye(3), (n, 3, 3))
    rods = np.full((n, 3), [1.0, 0, 0])
    numbers = (axes, axes, turns, rods, np.ones(n), rods / 2, inertia, np.array([0, 0, -9.81]))
    self = _model(library, [-1, *range(n - 1)], [0] * n, numbers)
    x = np.random.default_rng(1).uniform(-1, 1, (4, 50, n))
    blocks = [address(block) for block in x]
    return min(peer_loop(library)(self, 0, *blocks, n, 50, 20) for _ in range(9))


def _model(
    library: ctypes.CDLL, parents: list[int], kinds: list[int], numbers: tuple[np.ndarray, ...]
) -> ctypes.c_void_p:
    """A model made from arrays."""
    make = library.peer_model
    make.restype = ctypes.c_void_p
    integers = [np.array(block, dtype=np.int32) for block in (parents, kinds)]
    arrays = [np.ascontiguousarray(block, dtype=np.float64) for block in numbers]
    places = [*map(address, integers), *map(address, arrays)]
    return ctypes.c_void_p(make(len(parents), *places))


def refusal(scene: Scene, joints: Sequence[str]) -> str:
    """Why a tree cannot be handed over, "" if it can."""
    return coordinates.refusal(scene, joints, KIND)


def _tree(
    library: ctypes.CDLL, scene: Scene
) -> tuple[ctypes.c_void_p, Coordinates, dict[int, int]]:
    """A tree, the map of its states, and its number of every body of ours."""
    com, inertia = central(scene)
    n, order = scene.numbers, depth_first(scene)
    axes = (directions(scene), directions(scene, "axis2"))
    rows = (*axes, n["rotation"], n["position"], n["mass"], com, inertia)
    numbers = (*(row[order] for row in rows), n["gravity"])
    place = {-1: -1, **{body: k for k, body in enumerate(order)}}
    parents = [place[scene.parents[body]] for body in order]
    self = _model(library, parents, [KIND[scene.kinds[body]] for body in order], numbers)
    places = coordinates.after_each_other(scene, order)
    return self, coordinates.coordinates(scene, PINOCCHIO.convention, places), place


def contender(scene: Scene) -> Contender:
    """Pinocchio on a tree.

    Raises:
        BuildError: the compiler does not take its headers.
    """
    library, by = _library("pinocchio.cpp")
    self, coordinate_map, _ = _tree(library, scene)
    loop = Loop(peer_loop(library), self, coordinate_map)
    return Contender(_title(by), FUNCTIONS, loop.start, loop.results, (library,))


def closed_contender(circuits: Circuits) -> Contender:
    """Pinocchio's constrained dynamics, without feedback of residuals.

    Raises:
        BuildError: the compiler does not take its headers.
    """
    library, by = _library("pinocchio_closed.cpp")
    self, coordinate_map, place = _tree(library, circuits.scene)
    for connection in circuits.connections:
        bodies = np.array([place[body] for body in connection.bodies], dtype=np.int32)
        rotations, positions = map(
            np.ascontiguousarray, (connection.rotations, connection.positions)
        )
        places = (address(bodies), address(rotations), address(positions))
        library.peer_hold(self, int(connection.aligned), *places)
    loop = Loop(peer_loop(library), self, coordinate_map)

    def results(function: str, states: States) -> Array:
        return loop.results(function, circuits.states(states))[:, : circuits.nu]

    def start(function: str, states: States) -> Callable[[int], float]:
        return loop.start(function, circuits.states(states))

    return Contender(_title(by), FUNCTIONS[:1], start, results, (library,))


def _title(by: toolchain.Compiler) -> str:
    return f"Pinocchio {importlib.metadata.version('libpinocchio')}, {_compiler_version(by)}"


PEER = Peer("Pinocchio", "pin", missing, refusal, contender, closed_contender)


NAMES = ("clang++", "g++")


def cpp_compilers(options: tuple[str, ...]) -> list[toolchain.Compiler]:
    """Compilers that answer, clang before gcc: it makes the faster code of templates.

    Args:
        options: Language, level, processor, headers.
    """
    commands = [(*candidate.command[:-1], "c++") for candidate in toolchain.ziglang()]
    binaries = [located.binary for located in toolchain.ziglang()]
    for name in NAMES:
        path = shutil.which(name)
        if path:
            commands.append((path,))
            binaries.append(Path(path).resolve())
    compilers = []
    for command, binary in zip(commands, binaries, strict=True):
        try:
            compilers.append(
                toolchain.Compiler(command, binary, toolchain.ask_version(command), options)
            )
        except BuildError:
            # one that does not answer is as good as none
            continue
    return compilers


def _compiler_version(compiler: toolchain.Compiler) -> str:
    """Family and version, such as ``gcc 12.2.0``."""
    first = compiler.identity.splitlines()[0]
    numbers = [word for word in first.split() if word[:1].isdigit()]
    return f"{compiler.family} {numbers[-1] if numbers else first}"
