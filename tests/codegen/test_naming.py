"""Whatever users call things, the C compiles and the comments stay comments."""

import random
import re

import pytest

from cardan.codegen import generate
from cardan.codegen.program.naming import RESERVED, Names, comment, comments, mangle, mangled
from cardan.ir.function import Block, Function, Output
from cardan.ir.graph import Graph
from codegen.running import call, compilers, expected
from table import each

NASTY = [
    "*/ int evil(void); /*",
    "/* open",
    "line\nbreak\r\n#error broken",
    "trailing \\",
    "tri??/graph ??= ??",
    "int",
    "while",
    "q",
    "w",
    "out",
    "status",
    "real",
    "cardan_sin",
    "M_PI",
    "NULL",
    "unix",
    "θ1",
    "Ärmel",
    "关节",
    "🤖",
    "\u202eright to left",
    "\x00\x07",
    "",
    "   ",
    "9lives",
    "a b",
    "a.b",
    "a_b",
    "a__b",
    "_a_b_",
    "very_long_" * 30,
    '"quoted" %s %d',
    "prepare_nasty",
    "nasty",
    "table_0_breaks",
]


def nasty_function() -> Function:
    """A function all of whose names are nasty."""
    g = Graph()
    n = len(NASTY)
    total = g.const(1.0)
    outputs = []
    for k, name in enumerate(NASTY):
        with g.made_by(name, NASTY[-1 - k]):
            made = g.add(g.mul(total, g.var("q", k)), g.mul(g.var("p", k), g.var("u", k)))
            squared = g.mul(made, made)
        if k % 3 == 0:
            g.label(made, name, name)
        total = g.div(squared, g.add(squared, g.const(1.0 + k)))
        outputs.append(made)
    blocks = tuple(Block(b, tuple(NASTY), tuple(reversed(NASTY))) for b in ("q", "u", "p"))
    output = Output("*/ out", (n,), tuple(outputs), tuple(NASTY), tuple(NASTY))
    return Function("nasty", g, blocks, (output,), tuple(NASTY), "about */ int x; /*\n#error")


@pytest.mark.parametrize("compiler", sorted(compilers()))
def test_nasty_names_compile_without_warning_and_compute(compiler: str) -> None:
    function = nasty_function()
    rng = random.Random(4)
    given = {b: [rng.uniform(-1, 1) for _ in NASTY] for b in ("q", "u", "p")}
    cfile = generate(function, model="model */ evil", notes=["note */ evil\nevil"])
    answer = call(cfile, given, compiler)
    assert (answer.out == expected(function, given)).all()


def test_comments_cannot_be_left() -> None:
    text = generate(nasty_function(), model="*/ evil /* \\").text
    # outside comments, nothing of what users wrote but identifiers
    bare = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
    assert "evil" not in re.sub(r"\w*int_evil_void\w*", "", bare)
    assert "#error" not in "".join(line for line in bare.splitlines() if line.startswith("#"))
    assert "/*" not in bare
    assert "*/" not in bare
    assert "??" not in text


@each("name", NASTY)
def test_identifiers_are_plain_and_free(name: str) -> None:
    found = Names().new(mangle(name))
    assert re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", found)
    assert found not in RESERVED
    assert not found.startswith(("cardan_", "prepare_", "table_"))


def test_names_remind_of_what_the_user_wrote() -> None:
    assert mangle("panda_joint2", "omega_z") == "panda_joint2_omega_z"
    assert mangle("base.com.x") == "base_com_x"
    assert mangle("θ1") == "theta1"
    assert mangle("Ärmel") == "Armel"
    assert mangle("M", "7_7") == "M_7_7"
    assert mangle("", "speed") == "speed"


def test_names_are_unique_whatever_is_asked() -> None:
    rng = random.Random(2)
    bases = ["a", "a_1", "a_2", "a_2_2", "int", "int_1", "b_3", "b"]
    names = Names(["b"])
    found = [names.new(rng.choice(bases)) for _ in range(400)]
    assert len(set(found)) == len(found)
    assert not set(found) & (RESERVED | {"b"})


@each("text", [*NASTY, "?" * 7, "*/" * 3, "/*/*/", "*" + "/" * 5])
def test_comment_text_is_one_harmless_line(text: str) -> None:
    shown = comment(text)
    assert "\n" not in shown
    assert shown.isprintable()
    for pair in ("*/", "/*", "??"):
        assert pair not in shown


def test_comment_leaves_harmless_text_alone() -> None:
    assert comment("udot: arm.u [rad/s^2], 90°, Größe") == "udot: arm.u [rad/s^2], 90°, Größe"


def test_many_names_at_once_are_those_one_by_one() -> None:
    draw, letters = random.Random(2), "ab1_.- *?/\nθcardan"
    for _ in range(500):
        words = ["".join(draw.choices(letters, k=draw.randint(0, 9))) for _ in range(4)]
        words += ["cardan_x", "x" * 70, "1a", "FP_a", "double"][: draw.randint(0, 5)]
        assert mangled(words) == [mangle(word) for word in words]
        assert comments(words) == [comment(word) for word in words]
        bases = [mangle(word) for word in words]
        one, several = Names(bases[:1]), Names(bases[:1])
        for part in (bases[2:4], bases, bases[1:]):
            assert several.several(part) == [one.new(base) for base in part]
