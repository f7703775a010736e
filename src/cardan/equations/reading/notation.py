"""Notation of names in formulas: ``theta1.u`` is a θ with the index 1 and a dot.

Names are whatever users called their joints: each writer escapes what it writes.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import TYPE_CHECKING

from ...records import dataclass
from ...schema.blocks import of_rate

if TYPE_CHECKING:
    from ..record import EquationRecord

_GREEK = """
    alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau
    upsilon phi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega
"""
GREEK = frozenset(_GREEK.split())
# numbers of a body by their dotted names: upper.mass is m with the index upper
NUMBERS = {"mass": "m", "com": "c", "inertia": "I", "gravity": "g"}
# what TeX takes for commands or layout
_TEX = {
    "\\": r"\backslash{}",
    "{": r"\{",
    "}": r"\}",
    "$": r"\$",
    "&": r"\&",
    "#": r"\#",
    "%": r"\%",
    "_": r"\_",
    "^": r"\hat{}",
    "~": r"\sim{}",
}


@dataclass(frozen=True)
class Notation:
    """A symbol as it is set.

    Attributes:
        letter: One letter, the name of a Greek one, or a word.
        index: Below it, "" without one.
        dots: Time derivatives, 0 to 2.
        mark: ``"star"`` behind the letter, ``"bar"`` above it.
    """

    letter: str
    index: str = ""
    dots: int = 0
    mark: str = ""

    @property
    def is_letter(self) -> bool:
        return self.letter in GREEK or len(self.letter) == 1

    @property
    def character(self) -> str:
        """The letter itself; Greek ones by their character."""
        if self.letter not in GREEK:
            return self.letter
        name = "lamda" if self.letter.lower() == "lambda" else self.letter
        from unicodedata import lookup

        case = "CAPITAL" if self.letter[0].isupper() else "SMALL"
        return lookup(f"GREEK {case} LETTER {name.upper()}")

    def latex(self) -> str:
        """Escaped for TeX's math mode."""
        if self.letter in GREEK:
            # capitals that look like Latin ones have no command; none of them is in GREEK
            base = f"\\{self.letter}"
        else:
            base = self.letter if self.is_letter and self.letter.isalnum() else _word(self.letter)
        if self.mark:
            base = rf"\bar{{{base}}}" if self.mark == "bar" else f"{base}^{{*}}"
        if self.dots:
            base = f"\\{'d' * self.dots}ot{{{base}}}"
        return f"{base}_{{{_index(self.index)}}}" if self.index else base


SPEED = Notation("u")


def notation(name: str, dots: int = 0, numbers: Mapping[str, str] = NUMBERS) -> Notation:
    """Notation of a name: digits at its end, and the part after a dot, are subscripts.

    Args:
        name: Of a coordinate, parameter or input.
        dots: Time derivatives.
        numbers: Letters of gravity and of the numbers of bodies.
    """
    letters = re.fullmatch(r"([^\W\d_]+)_?(\d+)", name)
    if letters:
        return Notation(letters[1], letters[2], dots)
    number = re.fullmatch(r"(.+)\.(mass|com|inertia)(?:\.([xyz]+))?", name)
    if number:
        letter, _, base = numbers[number[2]].partition("_")
        return Notation(letter, ",".join(filter(None, (base, number[1], number[3]))), dots)
    head, sign, tail = name.partition("_")
    if sign and tail and (head in GREEK or len(head) == 1):
        return Notation(head, tail, dots)
    head, sign, tail = name.partition(".")
    if sign and head and tail:
        letter, _, base = numbers["gravity"].partition("_")
        first = Notation(letter, base) if head == "gravity" else notation(head, dots)
        return Notation(first.letter, ",".join(filter(None, (first.index, tail))), dots)
    return Notation(name, "", dots)


def symbols(
    equations: EquationRecord,
    speed: Notation = SPEED,
    rates: bool = True,
    numbers: Mapping[str, str] = NUMBERS,
) -> Mapping[str, Notation]:
    """Notation by name of symbol, for coordinates, speeds, inputs and parameters.

    Args:
        equations: Of joint coordinates.
        speed: Letter of speeds, with the index that all of them have.
        rates: A speed that is the rate of a coordinate is that coordinate with a dot.
        numbers: Letters of gravity and of the numbers of bodies.
    """
    plain = _rates(equations) if rates else {}
    notations: dict[str, Notation] = {}
    for letter in ("p", "r", "q"):
        for name in equations.blocks[letter].entries:
            notations[name] = notation(name, numbers=numbers)
    for name, rate in zip(equations.speeds, equations.blocks["udot"].entries, strict=True):
        coordinate = plain.get(name)
        for key, dots in ((name, 0), (rate, 1)):
            if coordinate is not None:
                notations[key] = notation(coordinate, dots + 1)
            else:
                index = ", ".join(filter(None, (speed.index, of_rate(name))))
                notations[key] = Notation(speed.letter, index, dots)
    return _distinct(notations)


def _distinct(notations: Mapping[str, Notation]) -> Mapping[str, Notation]:
    """Names that would look the same are set as they are."""
    first: dict[Notation, str] = {}
    for name, sign in notations.items():
        first.setdefault(sign, name)
    return {n: s if first[s] == n else Notation(n) for n, s in notations.items()}


def _rates(equations: EquationRecord) -> dict[str, str]:
    """Speed -> the coordinate whose rate it is."""
    if equations.chosen:
        return {}
    return {
        equations.speeds[joint.u]: equations.coordinates[joint.q]
        for joint in equations.system.joints
        if joint.u >= 0 and len(joint.element.coordinates) == len(joint.element.speeds) == 1
    }


def _word(text: str) -> str:
    return rf"\mathrm{{{''.join(_TEX.get(c, c) for c in text)}}}"


def _index(text: str) -> str:
    return text if text.isalnum() and len(text) <= 2 else _word(text)
