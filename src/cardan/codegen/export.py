"""Export: a model as plain C that compiles alone."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from ..equations.record import Equations
from ..errors import CodegenError, DerivationError, near
from . import layout, manifest
from .naming import comment
from .writing import CFile, generate

STANDARD = ("rhs", "forward_dynamics", "inverse_dynamics", "mass_matrix", "bias", "energy")


def export(
    equations: Equations, directory: str | Path, functions: Sequence[Any] | None = None
) -> Path:
    """Write C files, headers and a manifest that need nothing but a C compiler.

    Args:
        equations: What to write.
        directory: A new or empty one, or an earlier export of cardan, which is replaced.
        functions: Names such as ``"mass_matrix"``, or pairs such as ``("pose", "hand")``; by
            default the dynamics and the energy.

    Returns:
        The directory.

    Raises:
        CodegenError: the directory holds other things.
        DerivationError: an unknown function.
    """
    target = Path(directory)
    _check(target)
    asked = [(f, None) if isinstance(f, str) else tuple(f) for f in functions or STANDARD]
    known = equations.names()
    for name, _ in asked:
        if name not in known:
            raise DerivationError(f"function '{name}' does not exist.{near(name, known)}")

    # everything is made beside the target, then moved there in one step
    target.parent.mkdir(parents=True, exist_ok=True)
    scratch = Path(tempfile.mkdtemp(prefix=".cardan-", dir=target.parent))
    try:
        scratch.chmod(0o755)
        layout.write_model(scratch, manifest.base(equations, tuple(n for n, _ in asked)))
        made = []
        for name, of in asked:
            function = equations.function(name, of)
            notes = [f"formalism: {equations.method}"]
            made.append((generate(function, equations.system.name, notes, of=of), function))
        layout.add_functions(scratch, made)
        prototypes = _prototypes(equations.system.name, [cfile for cfile, _ in made])
        layout.add_file(scratch, "functions.h", prototypes)
        (scratch / layout.LOCK).unlink()
        if target.exists():
            shutil.rmtree(target)
        scratch.rename(target)
    except BaseException:
        shutil.rmtree(scratch, ignore_errors=True)
        raise
    return target


def _check(target: Path) -> None:
    """Refuse to replace what is not ours.

    Raises:
        CodegenError: the target is a file, or a directory with other things in it.
    """
    if target.exists() and not target.is_dir():
        raise CodegenError(f"{target} is a file: name a directory to export to")
    if target.is_dir():
        names = {path.name for path in target.iterdir()}
        foreign = sorted(names - layout.written(target)) if names else []
        if foreign:
            raise CodegenError(
                f"directory {target} holds other things ({', '.join(foreign[:3])}): "
                "name a new or empty one"
            )


def _prototypes(model: str, files: Sequence[CFile]) -> str:
    """The header of the exported functions, with the sizes a caller must provide."""
    lines = [
        "/*",
        f" * functions.h: what model '{comment(model)}' computes.",
        " *",
        " * out, work and w are arrays of the caller of at least the sizes given here.",
        " */",
        "#ifndef CARDAN_FUNCTIONS_H",
        "#define CARDAN_FUNCTIONS_H",
        "",
        '#include "model.h"',
    ]
    for cfile in files:
        name, entry = cfile.name, cfile.entry
        reads = ", ".join(entry["inputs"]) or "nothing"
        lines += ["", f"/* {comment(entry['about'] or name)}; reads {reads} */", "enum {"]
        lines += [
            f"    {name}_out_size = {entry['output_size']},",
            f"    {name}_work_size = {entry['work_size']},",
            f"    {name}_w_size = {entry['prepared_size']}",
            "};",
            f"CARDAN_API int {name}(const cardan_in *in, real *out, real *work);",
            f"CARDAN_API void prepare_{name}(const real *p, wreal *w);",
        ]
    return "\n".join([*lines, "", "#endif"]) + "\n"
