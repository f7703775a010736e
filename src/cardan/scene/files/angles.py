"""Angles and axes of files: rounded quarter turns become exact ones, residues become 0."""

from __future__ import annotations

from collections.abc import Sequence

from ...spatial.numbers import QUARTER, congruent, of_sequence

# below this, 2 or 1.6 would be taken for pi/2
FEWEST_DECIMALS = 2
# what programs leave of the sine of pi and the like: beside 1 it is lost in doubles
RESIDUE = 2.0**-52
_NAMES = {1: "pi/2", -1: "-pi/2", 2: "pi", -2: "-pi"}


def snapped(word: str, value: float) -> float:
    """The multiple of a quarter turn that a printed number is a rounding of, or the value.

    A number is a rounding where it is within half a unit of its last printed digit.
    """
    turns = round(value / QUARTER)
    exact = turns * QUARTER
    if turns == 0 or value == exact:
        return value
    mantissa, _, power = word.lower().partition("e")
    decimals = len(mantissa.partition(".")[2]) - int(power or 0)
    # the slack is for the rounding of the printed number to binary
    half_unit = 0.5 * 10.0**-decimals if decimals < 300 else 0.0
    near = abs(value - exact) <= half_unit + 4e-16 * abs(value)
    return exact if near and decimals >= FEWEST_DECIMALS else value


def snap(word: str, value: float, who: str, snaps: list[str]) -> float:
    """An angle with its rounding replaced, which is listed in ``snaps``."""
    exact = snapped(word, value)
    if exact != value:
        turns = round(exact / QUARTER)
        snaps.append(f"{who}: {word} -> {_NAMES.get(turns, f'{turns} pi/2')}")
    return exact


def snap_all(texts: Sequence[str], angles: list[float], who: str, snaps: list[str]) -> list[float]:
    """Roll, pitch and yaw with roundings replaced; each is listed in ``snaps``."""
    names = ("roll", "pitch", "yaw")
    return [
        snap(word, cleared(word, value, 1.0, f"{who} {name}", snaps), f"{who} {name}", snaps)
        for word, value, name in zip(texts, angles, names, strict=True)
    ]


def snap_axis(
    texts: Sequence[str], axis: Sequence[float], who: str, snaps: list[str]
) -> list[float]:
    """An axis without residues; each is listed in ``snaps``."""
    largest = max(map(abs, axis))
    return [
        cleared(word, value, largest, f"{who} axis {name}", snaps)
        for word, value, name in zip(texts, axis, "xyz", strict=True)
    ]


def cleared(word: str, value: float, scale: float, who: str, snaps: list[str]) -> float:
    """0 for a residue beside a number of this size, listed in ``snaps``; else the value."""
    if not 0 < abs(value) <= RESIDUE * scale:
        return value
    snaps.append(f"{who}: {word} -> 0")
    return 0.0


def rotated_inertia(inertia: Sequence[float], rpy: Sequence[float]) -> tuple[float, ...]:
    """Entries xx xy xz yy yz zz of R I Rᵀ with R = Rz(yaw) Ry(pitch) Rx(roll)."""
    if not any(rpy):
        return tuple(inertia)
    rotation = of_sequence("xyz", rpy)
    xx, xy, xz, yy, yz, zz = inertia
    rows = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
    in_axes = congruent(rotation, rows)
    return tuple(in_axes[i][j] for i in range(3) for j in range(i, 3))
