"""Names of users as C identifiers and as text in comments.

Whatever a user calls a joint, the C file compiles: identifiers are ASCII, no reserved words and
unique; comments cannot be left from inside.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Iterable
from functools import lru_cache

LONGEST = 48

# C99, C11, C23 and C++; what the generated text uses; macros of compilers and of math.h
_RESERVED = """
    alignas alignof and and_eq asm atomic auto bitand bitor bool break case catch char class compl
    complex const const_cast constexpr continue decltype default delete do double dynamic_cast else
    enum explicit export extern false float for friend goto if imaginary inline int long mutable
    namespace new noexcept noreturn not not_eq nullptr operator or or_eq private protected public
    register reinterpret_cast restrict return short signed sizeof static static_assert static_cast
    struct switch template this thread_local throw true try typedef typeid typename typeof
    typeof_unqual union unsigned using virtual void volatile wchar_t while xor xor_eq main

    real wreal in out work status w p t q u z s r udot zdot lam tau wrench du q0 e

    unix linux i386 NULL NAN INFINITY HUGE_VAL HUGE_VALF HUGE_VALL EOF I isnan isinf isfinite
    isnormal signbit fpclassify isgreater isgreaterequal isless islessequal islessgreater
    isunordered math_errhandling MATH_ERRNO MATH_ERREXCEPT errno assert M_E M_LOG2E M_LOG10E M_LN2
    M_LN10 M_PI M_PI_2 M_PI_4 M_1_PI M_2_PI M_2_SQRTPI M_SQRT2 M_SQRT1_2 DOMAIN SING OVERFLOW
    UNDERFLOW PLOSS TLOSS X_TLOSS HUGE MAXFLOAT
"""
RESERVED = frozenset(_RESERVED.split())
_TAKEN_BEGINNINGS = ("cardan_", "CARDAN_", "FP_", "DBL_", "FLT_", "LDBL_", "prepare_", "table_")


@lru_cache(maxsize=65536)
def mangle(*words: str) -> str:
    """A C identifier that reminds of some words; different words may give the same one.

    ``"panda_joint2"`` stays, ``"base.com.x"`` is ``base_com_x``, ``"θ1"`` is ``theta1``.
    """
    text = "_".join(_clean(word) for word in words if word)
    if not text:
        return "x"
    return f"x{text}" if text[0].isdigit() or text.startswith(_TAKEN_BEGINNINGS) else text


def _clean(name: str) -> str:
    """ASCII letters and digits, with one "_" between words."""
    text = name
    if not (name.isascii() and name.isidentifier()):
        text = "".join(c if c.isascii() and c.isalnum() else _letter(c) for c in name)
        while "__" in text:
            text = text.replace("__", "_")
    return text.strip("_")[:LONGEST].rstrip("_")


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
