"""C in single precision: the same text with ``float``, for processors that have no ``double``."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from ...errors import CodegenError, near
from ...schema.integrators import KERNELS
from ...schema.single_precision import single
from .. import layout

PRECISIONS = ("double", "single")
# what headers see: numbers are float
MACRO = "#define CARDAN_FLOAT 1\n"
_GUARD = re.compile(r"^#define CARDAN_H\n", re.M)


def check(precision: str, language: str, methods: Sequence[str]) -> None:
    """Refuse what is not offered.

    Raises:
        CodegenError: an unknown precision, one that does not go with the language or with elements.
    """
    if precision not in PRECISIONS:
        raise CodegenError(f"precision '{precision}' does not exist.{near(precision, PRECISIONS)}")
    if precision == "single" and language != "c":
        raise CodegenError(
            f"precision='single': it goes with language='c'; numbers of '{language}' are double"
        )
    # Newton's method and tangents want more digits
    offered = [name for name, method in KERNELS.items() if not (method.needs or method.multipliers)]
    wrong = [name for name in methods if precision == "single" and name not in offered]
    if wrong:
        raise CodegenError(
            f"precision='single': integrator '{wrong[0]}' solves equations in double precision; "
            f"those that go with it: {', '.join(offered)}"
        )


def apply(folder: Path) -> None:
    """Rewrite the C of an export in single precision; the manifest says so."""
    paths = sorted(path for path in folder.iterdir() if path.suffix in (".c", ".h"))
    texts = {path.name: single(path.read_text("utf-8")) for path in paths}
    texts["cardan.h"] = _GUARD.sub(lambda match: match.group() + MACRO, texts["cardan.h"])
    layout.replace_texts(folder, texts, precision="single")
