"""Names of an export that begin with a prefix, so that several can be linked into one program."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from pathlib import Path

from ...errors import CodegenError, brief
from ...schema.single_precision import SKIPPED
from .. import layout
from . import linkage

# enumerators, macros and types at the beginnings of lines
_DEFINED = re.compile(r"^(?: {4}(?=\w+ = )|#define |typedef struct )(\w+)", re.M)
_GUARD = re.compile(r"^#ifndef (CARDAN_\w+_H)$", re.M)
# headers of which a program has one for each model; types of the others are the same for all
MODEL_HEADERS = ("model.h", "functions.h", "elements.h")


def check(prefix: str, language: str) -> None:
    """Refuse what is not a beginning of names in C, and packages: these never meet in one program.

    Raises:
        CodegenError: one of the two.
    """
    if prefix and not re.fullmatch(r"[A-Za-z]\w*", prefix, re.ASCII):
        raise CodegenError(
            f"prefix={brief(prefix)}: names in C begin with a letter and go on with letters, "
            "digits and _, such as 'arm_'"
        )
    if prefix and language != "c":
        raise CodegenError(
            f"prefix='{prefix}': it goes with language='c'; what {language} loads does not collide"
        )


def add(folder: Path, prefix: str) -> None:
    """Rename what the files of an export show to a linker; the manifest says so."""
    paths = sorted(path for path in folder.iterdir() if path.suffix in (".c", ".h"))
    texts = {path.name: path.read_text("utf-8") for path in paths}
    names = _names(texts)
    shared = _shared(texts)
    for name, text in texts.items():
        more = _declared(text, texts, prefix) if name in shared else ""
        texts[name] = renamed(text + more, names, prefix)
    layout.replace_texts(folder, texts, prefix=prefix)


def _names(texts: Mapping[str, str]) -> frozenset[str]:
    """Names with external linkage, and what the model's own headers define."""
    names: set[str] = set()
    for text in texts.values():
        names |= linkage.external(text)
    for name in MODEL_HEADERS:
        names.update(_DEFINED.findall(texts.get(name, "")))
    return frozenset(names - {"main"})


def _shared(texts: Mapping[str, str]) -> set[str]:
    """Headers that those of the model itself lead to."""
    headers: set[str] = set()
    ahead = [name for name in MODEL_HEADERS if name in texts]
    while ahead:
        new = {*linkage.included(texts[ahead.pop()])} & texts.keys() - headers
        headers |= new
        ahead += sorted(new)
    return headers.difference(MODEL_HEADERS)


def _declared(text: str, texts: Mapping[str, str], prefix: str) -> str:
    """Prototypes after a header whose types are the same for all models.

    Where two models meet in one file, its guard hides the functions of the second.
    """
    guard = _GUARD.search(text)
    functions = linkage.prototypes(text)
    # what has no guard is text for the place where it is included, such as sincos.h
    guarded = [file for file in linkage.included(text) if _GUARD.search(texts.get(file, ""))]
    includes = [f'#include "{file}"' for file in guarded]
    if guard is None or not (functions or includes):
        return ""
    name = f"{prefix}{guard[1]}"
    about = "/* functions of this model, where the types stood in a header of another one */"
    lines = ["", about, f"#ifndef {name}", f"#define {name}", *includes, *functions, "#endif", ""]
    return "\n".join(lines)


def renamed(text: str, names: Iterable[str], prefix: str) -> str:
    """C with the prefix before some names, but in comments, strings and names of files."""
    renamed_names = frozenset(names)

    def word(match: re.Match[str]) -> str:
        name = match.group()
        return prefix + name if name in renamed_names else name

    parts, last = [], 0
    for skipped in SKIPPED.finditer(text):
        parts += [linkage.WORD.sub(word, text[last : skipped.start()]), skipped.group()]
        last = skipped.end()
    parts.append(linkage.WORD.sub(word, text[last:]))
    # macros make names of methods out of two parts
    return "".join(parts).replace("cardan_##", f"{prefix}cardan_##")
