"""The input blocks of functions in the order of ``cardan_in``, and x, which holds three."""

from __future__ import annotations

import re
from typing import NamedTuple

# the last part "u", or the one before the last: names of joints may have dots and such parts too
_SPEED = re.compile(r"\.u(?=$|\.[^.]*$)")


class Block(NamedTuple):
    """An input block.

    Attributes:
        name: Its letter.
        size: How many numbers it has; "" for the time.
        meaning: What it is, in the heads of C files.
        text: What it is as an argument of a function; "" where it is none.
        entries: What its entries are called in messages.
        default: Whether it may be left out.
    """

    name: str
    size: str
    meaning: str
    text: str = ""
    entries: str = ""
    default: bool = False


_STARTS = "by default those at the start"
BLOCKS = {
    block.name: block
    for block in (
        Block("t", "", "time", "time [s], (...)", default=True),
        Block("q", "nq", "generalized coordinates", "coordinates, (..., nq)", "coordinates"),
        Block("u", "nu", "generalized speeds", "speeds, (..., nu)", "speeds"),
        Block(
            *("z", "nz", "internal continuous states"),
            *(f"internal states of elements, (..., nz); {_STARTS}", "internal states", True),
        ),
        Block(
            *("s", "ns", "discrete states"),
            *(f"modes of elements, (..., ns); {_STARTS}", "modes", True),
        ),
        Block(
            *("r", "nr", "inputs of the model"),
            *("inputs, (..., nr); by default those of the model", "inputs", True),
        ),
        Block("p", "np", "parameters"),
        Block("w", "nw", "prepared parameters"),
        Block(
            *("udot", "nu", "derivatives of the speeds"),
            *("derivatives of the speeds, (..., nu)", "accelerations of"),
        ),
        Block("zdot", "nz", "derivatives of the internal states"),
        Block("lam", "nlam", "Lagrange multipliers", "multipliers, (..., nlam)", "multipliers"),
        Block(
            *("tau", "nu", "applied generalized forces"),
            *("generalized applied forces, (..., nu); by default none", "forces along", True),
        ),
        Block(
            *("wrench", "6*nparts", "wrenches on bodies: torque, force"),
            "torque and force on every body, ground axes, (..., 6 per body); by default none",
            default=True,
        ),
        Block(
            *("du", "nu", "finite increment along the speeds"),
            *("finite increment along the speeds, (..., nu)", "increments along"),
        ),
        Block(
            *("q0", "nq", "coordinates at the start of the increment"),
            *("coordinates at the start of the increment, (..., nq)", "coordinates"),
        ),
        Block(
            *("e", "ne", "events that happened, 1 or 0"),
            *("1 for every event that happens, else 0, (..., ne)", "events"),
        ),
        Block(
            *("v", "nv", "weights or direction that a derivative is multiplied by"),
            "weights of the results, or direction of the change, (..., nv)",
        ),
    )
}
STATE = Block("x", "nx", "state", "state [q, u] and internal states, (..., nx)", "entries")
# everything that functions take as an argument
ARGUMENTS = {block.name: block for block in (*BLOCKS.values(), STATE) if block.text}
ORDER = tuple(BLOCKS)
# blocks that expressions read
ABI_ORDER = tuple(block for block in ORDER if block not in ("w", "zdot"))
# q as it is stored, where "q" stands for columns along the speeds
COORDINATES = "coordinates"
# those that functions are differentiated by; of one number there is no axis of columns
DIRECTIONS = ("t", "q", COORDINATES, "u", "z", "s", "r", "p", "udot", "tau")


class Blocks(tuple[str, ...]):
    """Names that stand for blocks, whatever parameters and inputs are called.

    People who name a block that is also a parameter are asked which they mean.
    """


SLOT = {name: k for k, name in enumerate(ORDER)}


def of_rate(speed: str) -> str:
    """Coordinate of which ``elbow.u`` or ``ball.u.x`` is the rate: ``elbow``, ``ball.x``.

    Names of another form stay as they are.
    """
    return _SPEED.sub("", speed, count=1)
