"""Names of users as C identifiers and as text in comments.

Whatever a user calls a joint, the C file compiles: identifiers are ASCII, no reserved words and
unique; comments cannot be left from inside.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Iterable
from functools import lru_cache

LONGEST = 48

RESERVED = frozenset(
    # C99, C11, C23 and C++
    """
    alignas alignof and and_eq asm atomic auto bitand bitor bool break case catch char class compl
    complex const const_cast constexpr continue decltype default delete do double dynamic_cast else
    enum explicit export extern false float for friend goto if imaginary inline int long mutable
    namespace new noexcept noreturn not not_eq nullptr operator or or_eq private protected public
    register reinterpret_cast restrict return short signed sizeof static static_assert static_cast
    struct switch template this thread_local throw true try typedef typeid typename typeof
    typeof_unqual union unsigned using virtual void volatile wchar_t while xor xor_eq main
    """.split()
    # what the generated text and its headers use
    + "real wreal in out work status w p t q u z s r udot zdot lam tau wrench du q0".split()
    # macros of compilers and of the mathematical library
    + "unix linux i386 NULL NAN INFINITY HUGE_VAL EOF I isnan isinf isfinite signbit".split()
    + "fpclassify isnormal isgreater isless isunordered math_errhandling errno assert".split()
)
_TAKEN_BEGINNINGS = ("cardan_", "CARDAN_", "FP_", "M_", "DBL_", "FLT_", "prepare_")


@lru_cache(maxsize=65536)
def mangle(name: str) -> str:
    """A C identifier that reminds of a name; different names may give the same one.

    ``"panda_joint2"`` stays, ``"base.com.x"`` is ``base_com_x``, ``"θ1"`` is ``theta1``.
    """
    if name.isascii() and name.isidentifier():
        text = name
    else:
        text = "".join(c if c.isascii() and c.isalnum() else _letter(c) for c in name)
        while "__" in text:
            text = text.replace("__", "_")
    text = text.strip("_")[:LONGEST].rstrip("_")
    if not text:
        return "x"
    return f"x{text}" if text[0].isdigit() or text.startswith(_TAKEN_BEGINNINGS) else text


def _letter(c: str) -> str:
    """ASCII letters for one character; "_" for a sign between words."""
    if c.isascii() or not c.isalnum():
        return "_"
    plain = unicodedata.normalize("NFKD", c)[:1]
    if plain.isascii() and plain.isalnum():
        return plain
    words = unicodedata.name(c, "").lower().split()
    if "letter" in words and words[-1].isalpha() and words[-1].isascii():
        return words[-1]
    return f"u{ord(c):x}"


def comment(text: str) -> str:
    """Text that can stand in a C comment on one line."""
    shown = text
    if not text.isprintable():
        shown = "".join(c if c.isprintable() else ascii(c)[1:-1] for c in text)
    for pair in ("*/", "/*", "??"):
        while pair in shown:
            shown = shown.replace(pair, f"{pair[0]} {pair[1]}")
    return shown


class Names:
    """Identifiers of one file: each is given out once."""

    def __init__(self, taken: Iterable[str] = ()) -> None:
        self._taken = set(taken)
        self._next: dict[str, int] = {}

    def new(self, base: str) -> str:
        """``base``, or ``base_2``, ``base_3`` ... where that is taken or reserved."""
        number = self._next.get(base)
        if number is None:
            self._next[base] = 2
            if base not in self._taken and base not in RESERVED:
                self._taken.add(base)
                return base
            number = 1 if base in RESERVED else 2
        while f"{base}_{number}" in self._taken:
            number += 1
        self._next[base] = number + 1
        name = f"{base}_{number}"
        self._taken.add(name)
        return name
