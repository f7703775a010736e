"""Names of users as C identifiers and as text in comments.

Whatever a user calls a joint, the C file compiles: identifiers are ASCII, no reserved words and
unique; comments cannot be left from inside. Values without a label are called after what they are
made of: ``A_cos_times_B_position_x``. What would need a longer name is a part of the labeled value
or of the result that it goes into.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cached_property, lru_cache
from typing import NamedTuple

from ...ir.function import Function, operands
from ...ir.graph import Node

LONGEST = 63

# C99, C11, C23 and C++; what the generated text uses; macros of compilers and of math.h
_RESERVED = """
    alignas alignof and and_eq asm atomic auto bitand bitor bool break case catch char class compl
    complex const const_cast constexpr continue decltype default delete do double dynamic_cast else
    enum explicit export extern false float for friend goto if imaginary inline int long mutable
    namespace new noexcept noreturn not not_eq nullptr operator or or_eq private protected public
    register reinterpret_cast restrict return short signed sizeof static static_assert static_cast
    struct switch template this thread_local throw true try typedef typeid typename typeof
    typeof_unqual union unsigned using virtual void volatile wchar_t while xor xor_eq main

    real wreal in out work status w p t q u z s r udot zdot lam tau wrench du q0 e v

    unix linux i386 NULL NAN INFINITY HUGE_VAL HUGE_VALF HUGE_VALL EOF I isnan isinf isfinite
    isnormal signbit fpclassify isgreater isgreaterequal isless islessequal islessgreater
    isunordered math_errhandling MATH_ERRNO MATH_ERREXCEPT errno assert M_E M_LOG2E M_LOG10E M_LN2
    M_LN10 M_PI M_PI_2 M_PI_4 M_1_PI M_2_PI M_2_SQRTPI M_SQRT2 M_SQRT1_2 DOMAIN SING OVERFLOW
    UNDERFLOW PLOSS TLOSS X_TLOSS HUGE MAXFLOAT
"""
RESERVED = frozenset(_RESERVED.split())
_TAKEN_BEGINNINGS = ("cardan_", "CARDAN_", "FP_", "DBL_", "FLT_", "LDBL_", "prepare_", "table_")


_SIGN = re.compile("[^0-9A-Za-z]")
# line ends, which separate names, stay
_SIGNS = {k: "_" for k in range(128) if _SIGN.match(chr(k)) and chr(k) != "\n"}


@lru_cache(maxsize=65536)
def mangle(*words: str) -> str:
    """A C identifier that reminds of some words; different words may give the same one.

    ``"panda_joint2"`` stays, ``"base.com.x"`` is ``base_com_x``, ``"θ1"`` is ``theta1``.
    """
    text = "_".join(_clean(word) for word in words if word)
    if not text:
        return "x"
    return f"x{text}" if text[0].isdigit() or text.startswith(_TAKEN_BEGINNINGS) else text


def mangled(names: Sequence[str]) -> list[str]:
    """:func:`mangle` of each of many names, those of plain letters and signs all at once."""
    text = "\n".join(names)
    if not text.isascii():
        return [mangle(name) for name in names]
    signs = text.translate(_SIGNS).split("\n")
    if len(signs) != len(names):
        return [mangle(name) for name in names]
    # what is long, or has signs beside each other or at an end, is looked at by itself
    return [
        plain
        if len(plain) < LONGEST
        and plain[:1].isalpha()
        and plain[-1] != "_"
        and "__" not in plain
        and not plain.startswith(_TAKEN_BEGINNINGS)
        else mangle(name)
        for plain, name in zip(signs, names, strict=True)
    ]


def _clean(name: str) -> str:
    """ASCII letters and digits, with one "_" between words."""
    text = name
    if not (name.isascii() and name.isidentifier()):
        if not name.isascii():
            text = "".join(c if c.isascii() else _letter(c) for c in name)
        text = _SIGN.sub("_", text)
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
    name_parts = unicodedata.name(c, "").lower().split()
    if "letter" in name_parts and name_parts[-1].isalpha() and name_parts[-1].isascii():
        return name_parts[-1]
    return f"u{ord(c):x}"


# what ends a comment, begins one or is another sign
PAIRS = ("*/", "/*", "??")


def comment(text: str) -> str:
    """Text that can stand in a C comment on one line."""
    safe = text
    if not text.isprintable():
        safe = "".join(c if c.isprintable() else ascii(c)[1:-1] for c in text)
    for pair in PAIRS:
        while pair in safe:
            safe = safe.replace(pair, f"{pair[0]} {pair[1]}")
    return safe


def comments(texts: Sequence[str]) -> list[str]:
    """:func:`comment` of each of many texts."""
    joined = " ".join(texts)
    if joined.isprintable() and not any(pair in joined for pair in PAIRS):
        return list(texts)
    return [comment(text) for text in texts]


class Names:
    """Identifiers of one file: each is given out once."""

    def __init__(self, taken: Iterable[str] = ()) -> None:
        self._taken = set(taken)
        self._next: dict[str, int] = {}

    def new(self, base: str) -> str:
        """``base``, ``base_value`` where that is reserved, with ``_2``, ``_3`` ... where taken."""
        base = f"{base}_value" if base in RESERVED else base
        number = self._next.get(base)
        if number is None:
            self._next[base] = number = 2
            if base not in self._taken:
                self._taken.add(base)
                return base
        while f"{base}_{number}" in self._taken:
            number += 1
        self._next[base] = number + 1
        name = f"{base}_{number}"
        self._taken.add(name)
        return name

    def several(self, bases: Sequence[str]) -> list[str]:
        """:meth:`new` of each of many."""
        names = set(bases)
        free = names.isdisjoint(RESERVED) and names.isdisjoint(self._taken)
        if len(names) < len(bases) or not free or not names.isdisjoint(self._next):
            return [self.new(base) for base in bases]
        self._taken |= names
        self._next |= dict.fromkeys(names, 2)
        return list(bases)


# how tightly the words of a name hold together
SUM, PRODUCT, WORD = 0, 1, 2
FACTORS = {"c0p5": "half", "two": "twice"}
NUMBERS = {0.0: "zero", 1.0: "one", 2.0: "two", -1.0: "minus_one"}
ENDS = frozenset({"var", "const", "atom", "solve", "item", "select", "table"})
# letters of a name that is made of several
MAX_LETTERS = 60


class Phrase(NamedTuple):
    """Words for a value, with whose name they begin and how tightly they hold together."""

    text: str
    owner: str
    level: int


UNKNOWN = Phrase("", "", WORD)


class ValueNames:
    """Names of the live nodes of a function, made when they are first wanted.

    Args:
        function: Whose nodes they are.
        order: Its live nodes, operands first.
        inputs: Words and owner of an input entry.
    """

    def __init__(
        self, function: Function, order: Sequence[int], inputs: Callable[[int], tuple[str, str]]
    ) -> None:
        self._function = function
        self._graph = function.graph
        self._order = order
        self._inputs = inputs
        # what is labeled has that name, also where it needs no line of its own
        self._hints = self._graph.hints | self._graph.labels
        self._names: dict[int, str] = {}
        self._phrases: dict[int, Phrase | None] = {}

    def of(self, i: int) -> str:
        """The name of a node: what it is, or what it is a part of."""
        name = self._names.get(i)
        if name is None:
            if i in self._hints:
                name = mangle(*self._hints[i])
            else:
                phrase = self._phrase(i)
                name = phrase.text if phrase else mangle(mangle(*self._wholes[i]), "part")
            self._names[i] = name
        return name

    def _phrase(self, i: int) -> Phrase | None:
        """Phrase for a node, None where nothing short says what it is."""
        phrases, nodes, hints = self._phrases, self._graph.nodes, self._hints
        stack = [i]
        while stack:
            i = stack[-1]
            node = nodes[i]
            if i in hints:
                phrases[i] = Phrase(mangle(*hints[i]), mangle(hints[i][0]), WORD)
            elif node[0] in ENDS:
                phrases[i] = self._end(node, i)
            else:
                read = []
                for k in node[1:]:
                    phrase = phrases.get(k, UNKNOWN)
                    if phrase is UNKNOWN:
                        stack.append(k)
                        break
                    if phrase is None:
                        phrases[i] = None
                        break
                    read.append(phrase)
                else:
                    phrases[i] = _composed(node[0], read)
                if stack[-1] != i:
                    continue
            stack.pop()
        return phrases[i]

    def _end(self, node: Node, i: int) -> Phrase | None:
        """Phrase for an input or a number; what other operators read says nothing of them."""
        if node[0] == "var":
            return Phrase(*self._inputs(i), WORD)
        return Phrase(_number(node[1]), "", WORD) if node[0] == "const" else None

    @cached_property
    def _wholes(self) -> dict[int, tuple[str, ...]]:
        """Node -> words of the first labeled node or result that it goes into."""
        nodes, hints, wholes = self._graph.nodes, self._hints, dict[int, tuple[str, ...]]()
        for output in self._function.outputs:
            for k, root in enumerate(output.nodes):
                wholes.setdefault(root, (output.name, *output.entries[k : k + 1]))
        for i in reversed(self._order):
            node, hint = nodes[i], hints.get(i) or wholes[i]
            if len(node) == 3 and node[0] not in ENDS:
                wholes[node[1]] = wholes[node[2]] = hint
            else:
                wholes.update(dict.fromkeys(operands(node), hint))
        return wholes


def _composed(op: str, read: list[Phrase]) -> Phrase | None:
    """Phrase for an operator on things that have one, where it is short."""
    if op == "mul" and read[1].text in FACTORS:
        read.reverse()
    phrase = _COMPOSERS.get(op, _function)(op, read)
    return phrase if len(phrase.text) <= MAX_LETTERS else None


def _number(value: float) -> str:
    """Phrase for a number: ``one``, ``c0p75``."""
    text = repr(value).removesuffix(".0").replace("-", "m").replace(".", "p").replace("+", "")
    return NUMBERS.get(value, f"c{text}")


def _joined(a: Phrase, word: str, b: Phrase, level: int) -> Phrase:
    """``arm_u_x_times_cos``: the name of the owner stands once."""
    text = b.text
    if a.owner and a.owner == b.owner and text.startswith(f"{a.owner}_"):
        text = text[len(a.owner) + 1 :]
    return Phrase(f"{a.text}_{word}_{text}", a.owner, level)


def _tight(phrase: Phrase, level: int, word: str) -> Phrase:
    """The phrase as it stands where at least ``level`` is needed."""
    return phrase if phrase.level >= level else Phrase(f"{word}_{phrase.text}", "", WORD)


def _product(_: str, read: Sequence[Phrase]) -> Phrase:
    a, b = _tight(read[0], PRODUCT, "sum"), _tight(read[1], PRODUCT, "sum")
    if a.text in FACTORS:
        return Phrase(f"{FACTORS[a.text]}_{b.text}", "", PRODUCT)
    if a.text == b.text:
        return Phrase(f"{_tight(a, WORD, 'product').text}_squared", a.owner, WORD)
    return _joined(a, "times", b, PRODUCT)


def _quotient(_: str, read: Sequence[Phrase]) -> Phrase:
    a, b = _tight(read[0], PRODUCT, "sum"), read[1]
    b = _tight(b, WORD, "product" if b.level == PRODUCT else "sum")
    inverse = Phrase(f"{b.text}_inverse", b.owner, WORD)
    return inverse if a.text == "one" else _joined(a, "per", b, PRODUCT)


def _sum(_: str, read: Sequence[Phrase]) -> Phrase:
    a, b = read
    if a.text == b.text:
        return Phrase(f"twice_{_tight(a, PRODUCT, 'sum').text}", "", PRODUCT)
    return _joined(a, "plus", b, SUM)


def _difference(_: str, read: Sequence[Phrase]) -> Phrase:
    return _joined(read[0], "minus", _tight(read[1], PRODUCT, "sum"), SUM)


def _comparison(op: str, read: Sequence[Phrase]) -> Phrase:
    a, b = (read[1], read[0]) if op == "eq" and not read[0].owner else read
    return _joined(a, op, b, SUM)


def _negative(_: str, read: Sequence[Phrase]) -> Phrase:
    return Phrase(f"minus_{_tight(read[0], PRODUCT, 'sum').text}", "", PRODUCT)


def _function(op: str, read: Sequence[Phrase]) -> Phrase:
    """``lean_cos``, ``cos_of_A_plus_B``: of one value."""
    a = read[0]
    if len(read) > 1:
        return Phrase(f"{op}_of_{'_and_'.join(phrase.text for phrase in read)}", "", WORD)
    text = f"{a.text}_{op}" if a.level == WORD else f"{op}_of_{a.text}"
    return Phrase(text, a.owner if a.level == WORD else "", WORD)


_COMPOSERS: Mapping[str, Callable[[str, Sequence[Phrase]], Phrase]] = {
    "mul": _product,
    "div": _quotient,
    "add": _sum,
    "sub": _difference,
    "neg": _negative,
    "eq": _comparison,
    "lt": _comparison,
    "le": _comparison,
}
