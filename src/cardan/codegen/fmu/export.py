"""Export of a model as a Functional Mock-up Unit: description, binaries and sources in one file."""

from __future__ import annotations

import hashlib
import tempfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from ...equations.finite_elements.record import FiniteElementRecord
from ...equations.record import EquationRecord
from ...errors import CodegenError
from ...schema.manifest import Manifest
from ...schema.planned import Planned
from ...version import VERSION
from .. import layout
from ..export import export as c_export
from ..export import finite_elements
from ..export.export import ExportRequest
from ..export.model_file import Content, starts
from ..finite_elements import functions_header
from . import archive, description, model_table, platforms, readme, slopes
from .description import FmuContent
from .platforms import Platform
from .request import FmuRequest, identifier
from .slopes import Slopes
from .variables import ENERGIES, Facts, Variable, table

HERE = Path(__file__).parent
SOURCES, HEADERS = HERE / "sources", HERE / "headers"
LICENSE = HEADERS / "LICENSE"
# duration [s] and tolerance where an importer gives none; the latter is that of simulate()
EXPERIMENT = (10.0, 1e-6)
# sources, a platform, whether it is this machine's, whether contraction is forbidden -> the binary
Build = Callable[[Sequence[Path], Platform, bool, bool], bytes]
# blocks of a state
STATE = "quz"


def of_joints(
    equations: EquationRecord,
    request: FmuRequest,
    start: Callable[[Path], Mapping[str, Sequence[float]]],
    build: Build,
) -> Path:
    """Write the FMU of a model in joint coordinates.

    Args:
        equations: Of the model.
        request: What was asked for.
        start: Folder of a model -> values to start from, by block.
        build: Compiles the sources for a platform.

    Returns:
        The file. It appears whole or not at all.

    Raises:
        CodegenError: it cannot be written. BuildError: it cannot be compiled.
    """
    available, system = equations.names(), equations.system
    outputs = equations.function("outputs").outputs[0] if "outputs" in available else None
    named = list(zip(outputs.entries, outputs.units, strict=True)) if outputs else []
    energies = "energy" in available
    counts = {
        "rate": system.nq + system.nu + system.nz,
        "output": len(named),
        "energy": len(ENERGIES) * energies,
    }
    extra = slopes.available(equations, counts)
    functions = [
        "rhs",
        *(["outputs"] if named else []),
        *(["energy"] if energies else []),
        *extra.requests,
    ]
    fill = c_export.filler(equations, start, functions, request.integrators)
    return _written(request, fill, named, energies, extra, build)


def of_elements(
    absolute: FiniteElementRecord,
    request: FmuRequest,
    plan: Callable[[Path], Planned],
    build: Build,
) -> Path:
    """Write the FMU of a model whose elements stand in tables.

    Args:
        absolute: The model.
        request: What was asked for.
        plan: Folder of a model -> what is known of its matrices and its start.
        build: Compiles the sources for a platform.

    Returns:
        The file. It appears whole or not at all.

    Raises:
        CodegenError: it cannot be written. BuildError: it cannot be compiled.
    """
    available = functions_header.available(absolute)
    named = [(row.name, row.unit) for row in absolute.system.outputs]
    functions = [name for name in ("energy", "outputs") if name in available]
    fill = finite_elements.filler(absolute, plan, functions, request.integrators)
    return _written(request, fill, named, "energy" in available, Slopes(), build)


def _written(
    request: FmuRequest,
    fill: Callable[[Path], Content],
    outputs: Sequence[tuple[str, str]],
    energies: bool,
    extra: Slopes,
    build: Build,
) -> Path:
    """Write sources into a folder that is gone afterward, compile them, pack everything."""
    try:
        with tempfile.TemporaryDirectory(prefix="cardan-fmu-") as scratch:
            folder = Path(scratch) / "sources"
            content = fill(folder)
            manifest = layout.manifest_of(folder)
            start = {b: content.start.get(b) or starts(manifest, b) for b in STATE}
            facts = Facts(start, outputs, "me" in request.kinds, energies)
            variables = table(manifest, facts)
            files = _sources(folder, request, content, manifest)
            token = _token(files, request)
            files["fmu_model.c"] = model_table.text(
                manifest, variables, extra, token, request.kinds, EXPERIMENT
            )
            for name, text in files.items():
                (folder / name).write_text(text, "utf-8")
            about = _content(manifest, request, variables, extra, token, files)
            paths = [folder / name for name in about.sources]
            binaries = _binaries(request, about, paths, build)
            return archive.write(
                request.target,
                archive.packed({**_texts(manifest, request, about, files), **binaries}),
            )
    except OSError as error:
        why = error.strerror or error
        raise CodegenError(
            f"{request.target} cannot be written: {why}. Make room, or name another file"
        ) from error


def _sources(
    folder: Path, request: FmuRequest, content: Content, manifest: Manifest
) -> dict[str, str]:
    """C of the model, its run, the core and the entry points of a version, by file name."""
    exported = ExportRequest(folder, "c", request.integrators, request.reproducible, "", "double")
    there = {p.name: p.read_text("utf-8") for p in folder.iterdir() if p.suffix in (".c", ".h")}
    more = c_export.texts(manifest, exported, content)
    there |= {name: text for name, text in more.items() if name.endswith((".c", ".h"))}
    del there["example.c"]
    version = request.version
    names = [p.name for p in sorted(SOURCES.glob("fmu_*"))] + [*version.sources]
    there |= {name: (SOURCES / name).read_text("utf-8") for name in names}
    return there | {name: (HEADERS / name).read_text("utf-8") for name in version.headers}


def _token(files: Mapping[str, str], request: FmuRequest) -> str:
    """Hash of everything that a binary is made of, in the form of a UUID."""
    digest = hashlib.sha256(repr((VERSION, request.kinds, request.reproducible)).encode())
    for name in sorted(files):
        digest.update(f"\0{name}\0{len(files[name])}\0{files[name]}".encode())
    text = digest.hexdigest()
    parts = (text[:8], text[8:12], text[12:16], text[16:20], text[20:32])
    return "{" + "-".join(parts) + "}"


def _content(
    manifest: Manifest,
    request: FmuRequest,
    variables: Sequence[Variable],
    extra: Slopes,
    token: str,
    files: Mapping[str, str],
) -> FmuContent:
    return FmuContent(
        manifest.name,
        identifier(manifest.name),
        token,
        request.kinds,
        variables,
        slopes.dependencies(manifest, extra, variables),
        bool(extra.by_state),
        sorted(name for name in files if name.endswith(".c")),
        *EXPERIMENT,
    )


def _binaries(
    request: FmuRequest, about: FmuContent, paths: Sequence[Path], build: Build
) -> dict[str, bytes]:
    """Shared objects by their paths in the archive."""
    this = platforms.here()
    return {
        f"binaries/{request.version.platforms[one.name]}/{about.identifier}{one.suffix}": build(
            paths, one, one == this, request.reproducible
        )
        for one in request.platforms
    }


def _texts(
    manifest: Manifest, request: FmuRequest, about: FmuContent, files: Mapping[str, str]
) -> dict[str, str]:
    """Everything but the binaries, by path."""
    texts = {f"sources/{name}": text for name, text in files.items()}
    if not request.version.listing:
        texts["sources/buildDescription.xml"] = description.build_description(
            about, request.version
        )
    page = readme.page(manifest, request, about, _checked(request))
    return {
        **texts,
        "modelDescription.xml": description.model_description(about, request.version),
        "documentation/index.html": page,
        "documentation/licenses/FMI_headers.txt": LICENSE.read_text("utf-8"),
    }


def _checked(request: FmuRequest) -> str:
    """Sentence about the binaries, for the page."""
    this = platforms.here()
    native = [one.name for one in request.platforms if one == this]
    foreign = [one.name for one in request.platforms if one != this]
    texts = [f"Compiled on its own platform: {', '.join(native)}."] if native else []
    if foreign:
        texts.append(f"Linked for other platforms, not run there: {', '.join(foreign)}.")
    return " ".join(texts) or "Sources only: compile them for your platform."
