"""Options of an FMU, checked: what was named is kept, or refused."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path

from ...errors import CodegenError, near
from ...records import dataclass
from ..export import companions
from ..export.finite_elements import METHODS
from . import platforms
from .platforms import Platform
from .versions import VERSIONS, Version

SUFFIX = ".fmu"
KINDS = {"me": "model exchange", "cs": "co-simulation"}
# methods of co-simulation where none is named, as simulate() takes them
RIGID, ELEMENTS = "dop853", "radau"
# options that FMUs do not have, and what they are where they are not named
NOT_FMU: dict[str, object] = {
    "functions": None,
    "language": None,
    "loops": None,
    "prefix": "",
    "precision": "double",
    "gradient": None,
}


@dataclass(frozen=True)
class FmuRequest:
    """Options of an FMU.

    Attributes:
        target: The file.
        version: Of FMI.
        kinds: ``"me"``, ``"cs"``.
        platforms: Of its binaries.
        integrators: By their kernels; the first is that of co-simulation.
        reproducible: Whether contraction is forbidden.
    """

    target: Path
    version: Version
    kinds: tuple[str, ...]
    platforms: tuple[Platform, ...]
    integrators: tuple[str, ...]
    reproducible: bool


@dataclass(frozen=True)
class FmuOptions:
    """Options that FMUs alone have, as ``equations.export`` takes them; None where not named."""

    fmi: str | None
    kinds: Sequence[str] | None
    platforms: Sequence[str] | None
    q: object = None
    u: object = None


def request_of(
    path: str | Path,
    name: str,
    elements: bool,
    options: FmuOptions,
    foreign: Mapping[str, object],
    integrators: Sequence[str],
    reproducible: bool,
) -> FmuRequest | None:
    """The options of an FMU, checked; None where the name of an export does not end as that of one.

    Args:
        path: Of the export.
        name: Of the model.
        elements: Whether it consists of elements in absolute coordinates.
        options: Those of FMUs alone.
        foreign: Those that FMUs do not have.
        integrators, reproducible: As ``equations.export`` takes them.

    Raises:
        CodegenError: an option of the other kind of export, an unknown word, or kinds that the
            model does not go with.
    """
    if Path(path).suffix.lower() != SUFFIX:
        for option, value in vars(options).items():
            if value is not None:
                raise CodegenError(
                    f"{option}={value!r} is an option of FMUs: name a file that ends with {SUFFIX} "
                    f"instead of {path}"
                )
        return None
    for option, value in foreign.items():
        if value != NOT_FMU[option]:
            raise CodegenError(
                f"{option}={value!r}: {path} is an FMU, which has all functions in C and no "
                f"package. Leave {option}= out, or name a directory"
            )
    fmi = options.fmi or "3.0"
    if fmi not in VERSIONS:
        raise CodegenError(f"fmi={fmi!r}: versions are {', '.join(map(repr, VERSIONS))}")
    target = Path(path).resolve()
    if target.is_dir():
        raise CodegenError(f"{target} is a directory: name a file to export to")
    version = VERSIONS[fmi]
    return FmuRequest(
        target,
        version,
        _kinds(name, elements, options.kinds),
        _platforms(version, options.platforms),
        _integrators(name, elements, integrators),
        reproducible,
    )


def _kinds(name: str, elements: bool, kinds: Sequence[str] | None) -> tuple[str, ...]:
    if kinds is None:
        return ("cs",) if elements else ("me", "cs")
    if isinstance(kinds, str) or not kinds:
        raise CodegenError(f"kinds={kinds!r}: give a tuple such as ('cs',) or ('me', 'cs')")
    for one in kinds:
        if one not in KINDS:
            raise CodegenError(f"kinds: '{one}' does not exist.{near(str(one), KINDS)}")
    if elements and "me" in kinds:
        raise CodegenError(
            f"kinds={tuple(kinds)!r}: model '{name}' is in absolute coordinates, stiff and with "
            "constraints that no importer's integrator solves: kinds=('cs',) integrates it inside "
            "the FMU. Scenes without flexible parts go with model exchange in joint coordinates: "
            "derive(scene, coordinates='relative')"
        )
    return tuple(kind for kind in KINDS if kind in kinds)


def _platforms(version: Version, where: Sequence[str] | None) -> tuple[Platform, ...]:
    if where is None:
        this = platforms.here()
        if this is None or this.name not in version.platforms:
            raise CodegenError(
                f"FMI {version.name} has no name for this machine: platforms=() writes an FMU of "
                f"sources, platforms=('linux',) one for another machine"
            )
        return (this,)
    if isinstance(where, str):
        raise CodegenError(f"platforms={where!r}: give a tuple such as ('linux', 'windows')")
    for one in where:
        if one not in platforms.PLATFORMS:
            raise CodegenError(
                f"platforms: '{one}' does not exist.{near(str(one), platforms.PLATFORMS)}"
            )
        if one not in version.platforms:
            raise CodegenError(
                f"platforms: FMI {version.name} has no name for '{one}': it goes with "
                f"{', '.join(version.platforms)}; fmi='3.0' has all"
            )
    return tuple(platforms.PLATFORMS[one] for one in dict.fromkeys(where))


def _integrators(name: str, elements: bool, integrators: Sequence[str]) -> tuple[str, ...]:
    if isinstance(integrators, str):
        raise CodegenError(f"integrators={integrators!r}: give a tuple such as ('radau',)")
    methods = tuple(one.lower() for one in integrators) or (ELEMENTS if elements else RIGID,)
    for one in methods:
        if one not in companions.INTEGRATORS:
            raise CodegenError(
                f"integrators: '{one}' does not exist.{near(one, companions.INTEGRATORS)}"
            )
        if elements and one not in METHODS:
            raise CodegenError(
                f"integrators: '{one}' needs functions that absolute coordinates do not have. "
                f"Model '{name}' goes with {', '.join(METHODS)}"
            )
    return methods


def identifier(name: str) -> str:
    """The name of a model as one in C, which its binaries have."""
    plain = re.sub(r"[^A-Za-z0-9_]", "_", name)
    return plain if re.match(r"[A-Za-z]", plain) else f"model_{plain}"
