"""Instructions of WebAssembly, and the functions of the kernels that stand for other operators.

Source: WebAssembly Core Specification 2.0, W3C, chapter 5 (binary format).
"""

from __future__ import annotations

import struct

from .module import Code, Signature, signed, unsigned

# instructions
GET, SET, TEE = b"\x20", b"\x21", b"\x22"
CONST_I, LOAD_I, STORE_I = b"\x41", b"\x28", b"\x36"
CONST_D, LOAD_D, STORE_D = b"\x44", b"\x2b", b"\x39"
ADD_I, MUL_I, OR_I, LESS_I, EQUAL_I = b"\x6a", b"\x6c", b"\x72", b"\x48", b"\x46"
EQ, NE, LT, GT, LE = b"\x61", b"\x62", b"\x63", b"\x64", b"\x65"
NUMBER = b"\xb8"  # of an unsigned int
SELECT, DROP, FILL = b"\x1b", b"\x1a", b"\xfc\x0b\0"
LOOP, REPEAT, IF, ELSE, END = b"\x03\x40", b"\x0d", b"\x04\x40", b"\x05", b"\x0b"
# operators that are instructions
PLAIN = {
    "add": b"\xa0",
    "sub": b"\xa1",
    "mul": b"\xa2",
    "div": b"\xa3",
    "neg": b"\x9a",
    "sqrt": b"\x9f",
    "abs": b"\x99",
    "floor": b"\x9c",
    "lt": LT + NUMBER,
    "le": LE + NUMBER,
    "eq": EQ + NUMBER,
}
ONE, TWO = Signature("d", "d"), Signature("dd", "d")
# functions of the kernels: sines and cosines of an array, those that operators call, solvers
SINCOS = "cardan_sincos", Signature("iiii")
CALLED = {
    **{
        name: (f"cardan_{name}", ONE)
        for name in (
            *("tan", "asin", "acos", "atan", "exp", "log", "sinh", "cosh", "tanh"),
            *("asinh", "acosh", "atanh"),
        )
    },
    "atan2": ("cardan_atan2", TWO),
    "pow": ("cardan_pow", TWO),
}
STUMPFF = "cardan_stumpff", Signature("id", "d")
PIECEWISE = "cardan_piecewise", Signature("iiiiid", "d")
SOLVER = Signature("iiiii", "i")


def integer(value: int) -> Code:
    """A constant of 32 bits."""
    return [CONST_I + signed(value)]


def number(value: float) -> Code:
    """A constant double."""
    return [CONST_D + struct.pack("<d", value)]


def memory(alignment: int, offset: int) -> bytes:
    """What an instruction says about its place: a power of two and an offset."""
    return bytes([alignment]) + unsigned(offset)
