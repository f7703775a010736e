"""Names in C that a linker sees, and the files of ``kernels/`` to which they lead."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache

from ...schema import kernel_files
from ...schema.single_precision import SKIPPED

# what headers declare and files define for others, at the beginnings of lines; what is
# CARDAN_INLINE is static
_EXTERNAL = re.compile(
    r"^(?!static|CARDAN_INLINE|typedef|#|return|else|extern \"C\")[A-Za-z_][\w \t*]*?[ *](\w+)"
    r"(?=\(|\[[^\n;]*[;=]|\s+= )",
    re.M,
)
_PROTOTYPE = re.compile(r"^(?!static|typedef|#)[A-Za-z_][^;{}#]*\([^;{}#]*\);", re.M)
_INCLUDED = re.compile(r"^#include \"(\w+\.h)\"", re.M)
WORD = re.compile(r"[A-Za-z_]\w*")


def external(text: str) -> set[str]:
    """Names with external linkage that a file declares or defines."""
    return set(_EXTERNAL.findall(SKIPPED.sub(" ", text)))


def prototypes(text: str) -> list[str]:
    """The functions that a header declares, as it does."""
    return [" ".join(one.split()) for one in _PROTOTYPE.findall(SKIPPED.sub(" ", text))]


def included(text: str) -> list[str]:
    """Headers of ours that a file includes."""
    return _INCLUDED.findall(text)


@cache
def _defined() -> dict[str, str]:
    """The file of ``kernels/`` that defines a name."""
    return {
        name: path.name
        for path in kernel_files.files("*.c")
        for name in external(kernel_files.text(path.name))
    }


@cache
def _leads_to(file: str) -> frozenset[str]:
    """Files whose names another one uses, and those that it includes."""
    text = kernel_files.text(file)
    code = SKIPPED.sub(" ", text)
    # headers declare much of which a file that includes them uses little
    identifiers = WORD.findall(_PROTOTYPE.sub(" ", code) if file.endswith(".h") else code)
    used = {_defined()[name] for name in identifiers if name in _defined()}
    return frozenset({*used, *_INCLUDED.findall(text)})


def closure(files: Iterable[str]) -> tuple[str, ...]:
    """Files of ``kernels/`` with all others that they need, in the order of their names."""
    included: set[str] = set()
    ahead = set(files)
    while ahead:
        file = ahead.pop()
        included.add(file)
        ahead |= _leads_to(file) - included
    return tuple(sorted(included))
