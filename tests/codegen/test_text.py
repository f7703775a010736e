"""The C as a reader sees it: head, sections, names, lines; the same bytes every time."""

import ast
import math
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan.codegen import generate
from cardan.codegen.program.lowering import lower
from cardan.errors import CodegenError
from cardan.ir.function import Block, Function, Output, Staged
from cardan.ir.graph import Graph
from cardan.ir.matrix import Matrix
from cardan.schema import kernel_files
from codegen.functions import random_function
from codegen.running import SPEED, STRICT, call, compilers, shared
from mechanisms import ZOO
from spread import some

SCREENED = ("rhs", "inverse_dynamics", "energy", "integrate", "difference", "outputs", "power")


def pendulums(n: int = 3) -> Function:
    """Torques of a chain of points, made as equations make them: owners, quantities, labels."""
    g = Graph()
    roots = []
    omega = Matrix.zeros(g, 3)
    force = Matrix.zeros(g, 3)
    names = tuple(f"joint{k + 1}" for k in range(n))
    for k, name in enumerate(names):
        with g.made_by(name, "rotation"):
            c, s = g.apply("cos", g.var("q", k)), g.apply("sin", g.var("q", k))
            g.label(s, name, "sin")
            g.label(c, name, "cos")
            R = Matrix(g, 3, 3, (c, 0, s, 0, 1, 0, g.neg(s), 0, c))
        with g.made_by(name, "omega"):
            omega = R.T @ omega + Matrix(g, 3, 1, (0, g.var("u", k), g.var("u", k)))
            omega.label(name, "omega")
        with g.made_by(name, "force"):
            force = force + omega.cross(omega.cross(Matrix(g, 3, 1, (0, 0, g.var("p", k)))))
            roots.append(force.nodes[0])
    blocks = (
        Block("q", names, ("rad",) * n),
        Block("u", tuple(f"{x}.u" for x in names), ("rad/s",) * n),
        Block("p", tuple(f"{x}.length" for x in names), ("m",) * n),
    )
    output = Output("f", (n,), tuple(roots), names, ("N",) * n)
    return Function("chain_force", g, blocks, (output,), names, "centripetal forces of a chain")


def test_head_says_what_where_and_how_much() -> None:
    text = generate(pendulums(), model="three links", notes=["formalism: by hand"]).text
    head = text.split("*/")[0]
    for line in (
        " * chain_force of three links",
        " * centripetal forces of a chain",
        " * formalism: by hand",
        " * passes: reassociate, schedule",
        " * Input q (3): generalized coordinates",
        " *   q[1]  joint2 [rad]",
        " *   u[2]  joint3.u [rad/s]",
        " * Output f (3)",
        " *   out[0]  joint1 [N]",
    ):
        assert line in head.splitlines()
    assert re.search(r"Sizes: out 3, work 0, w 2", head)
    assert re.search(r"Operations per call: \d+ = .*\d+ mul", head)


def test_sections_stand_in_the_order_of_the_joints() -> None:
    body = generate(pendulums()).text.split("CARDAN_API int")[1]
    titles = re.findall(r"^    /\* (joint\d): ", body, re.MULTILINE)
    assert list(dict.fromkeys(titles)) == ["joint2", "joint3"]
    assert "/* joint2: " in body
    assert "omega" in body.split("/* joint2: ")[1].split("*/")[0]


def test_temporaries_are_called_after_owner_and_quantity() -> None:
    text = generate(pendulums()).text
    assert "const real joint2_sin = sine[0];" in text
    assert "const real joint3_omega_z = " in text
    assert "const wreal joint2_length = w[0]; /* m */" in text
    assert re.search(r"out\[1\] = .*; /\* f: joint2 \[N\] \*/", text)
    assert "_tmp" not in text


def test_sines_and_cosines_of_inputs_are_computed_at_once() -> None:
    text = generate(pendulums()).text
    assert "const real angle[CARDAN_PADDED(2)] = {joint2_q, joint3_q};" in text
    assert text.count("cardan_sincos(2, angle, sine, cosine);") == 1
    assert "cardan_sin(" not in text


def test_angles_that_need_other_angles_follow() -> None:
    g = Graph()
    q = g.var("q", 0)
    inner = g.apply("sin", g.mul(q, q))
    roots = (g.apply("cos", g.add(inner, q)), g.apply("sin", g.add(inner, q)), inner)
    block = Block("q", ("a",), ("rad",))
    cfile = generate(Function("nested", g, (block,), (Output("y", (3,), roots),)))
    assert cfile.text.count("cardan_sincos(1, ") == 2
    expected = [math.cos(math.sin(0.49) + 0.7), math.sin(math.sin(0.49) + 0.7), math.sin(0.49)]
    assert np.abs(call(cfile, {"q": [0.7]}).out - expected).max() <= 2.3e-16


@pytest.mark.parametrize("seed", range(4))
def test_lines_fit_a_screen(seed: int) -> None:
    text = generate(random_function(seed, 150), longest=50).text
    assert max(map(len, text.splitlines())) <= 100
    assert max(map(len, generate(pendulums(6)).text.splitlines())) <= 100
    assert not re.search(r"[ \t]$", text, re.MULTILINE)


@pytest.mark.parametrize("compiler", sorted(compilers()))
def test_no_warnings(compiler: str) -> None:
    for function in (pendulums(), random_function(1), constant()):
        for longest in (1000, 5):
            assert shared(generate(function, longest=longest).text, compiler, (*STRICT, *SPEED))


def constant() -> Function:
    """A function that reads nothing."""
    g = Graph()
    return Function("nothing", g, (), (Output("y", (2,), (0, 1)), Output("none", (0,), ())))


@pytest.mark.skipif(shutil.which("g++") is None, reason="no C++ compiler here")
def test_headers_compile_as_cpp() -> None:
    text = '#include "solve.h"\nint main() { return CARDAN_ABI - 2; }\n'
    command = [
        "g++",
        "-std=c++11",
        "-Wall",
        "-Wextra",
        "-Werror",
        "-x",
        "c++",
        "-",
        "-o",
        "/dev/null",
    ]
    answer = subprocess.run(
        [*command, *(f"-I{folder}" for folder in kernel_files.includes())],
        input=text,
        text=True,
        capture_output=True,
        check=False,
    )
    assert answer.returncode == 0, answer.stderr


def test_same_bytes_in_every_process() -> None:
    script = (
        "import hashlib; from codegen.functions import random_function, solving;"
        "from cardan.codegen import generate;"
        "made = [(random_function(s), n) for s in range(3) for n in (9, 999)];"
        "texts = [generate(f, longest=n).text for f, n in made];"
        "texts.append(generate(solving('rank_revealing')).text);"
        "print(hashlib.sha256(''.join(texts).encode()).hexdigest())"
    )
    root = Path(__file__).parents[2]
    found = set()
    for seed in ("0", "1", "77"):
        environment = {
            **os.environ,
            "PYTHONHASHSEED": seed,
            "PYTHONPATH": os.pathsep.join((str(root / "src"), str(root / "tests"))),
        }
        answer = subprocess.run(
            [sys.executable, "-c", script], env=environment, capture_output=True, check=True
        )
        found.add(answer.stdout)
    assert len(found) == 1


def test_nodes_of_several_owners_stand_in_a_section_of_their_own() -> None:
    g = Graph()
    with g.made_by("left", "pull"):
        shared_node = g.mul(g.var("q", 0), g.var("q", 1))
        left = g.add(shared_node, g.var("q", 2))
    with g.made_by("right", "pull"):
        right = g.sub(g.mul(g.var("q", 0), g.var("q", 1)), g.var("q", 3))
    block = Block("q", tuple("abcd"), ("",) * 4)
    outputs = (Output("y", (3,), (left, right, shared_node)),)
    text = generate(Function("both", g, (block,), outputs, ("left", "right"))).text
    assert "/* shared by several: pull */" in text
    assert "const real a_times_b = a_q * b_q;" in text


def test_a_placeholder_is_an_error() -> None:
    g = Graph()
    node = g.add(g.var("q", 0), g.atom("velocity of hand"))
    function = Function("f", g, (Block("q", ("a",), ("",)),), (Output("y", (1,), (node,)),))
    with pytest.raises(CodegenError, match="velocity of hand"):
        lower(Staged(function, ()))


@pytest.mark.parametrize("compiler", sorted(compilers()))
@pytest.mark.parametrize("name", some(ZOO, 3))
def test_the_zoo_gives_no_warnings(name: str, compiler: str, tmp_path: Path) -> None:
    equations = cd.derive(ZOO[name].build())
    texts = [generate(equations.function(n)).text for n in SCREENED if n in equations.names()]
    # several functions can stand in one file
    (tmp_path / "all.c").write_text("\n".join(texts), "utf-8")
    command = [
        *compilers()[compiler],
        *STRICT,
        "-O0",
        "-fno-sanitize=all",
        *(f"-I{folder}" for folder in kernel_files.includes()),
    ]
    answer = subprocess.run(
        [*command, "-c", "all.c", "-o", "all.o"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
    )
    assert answer.returncode == 0, answer.stderr[:2000]


@pytest.mark.parametrize("language", ["cython", "casadi", "jax"])
def test_modules_have_the_name_of_the_scene(language: str, tmp_path: Path) -> None:
    """Whatever characters it has: a name is text in a docstring and in a constant."""
    name = "a\"b\\c'''"
    scene = cd.Scene(name)
    scene.joint("j", cd.Revolute("z"), scene.ground, scene.body("b", mass=1.0, inertia=(1, 1, 1)))
    folder = cd.derive(scene).export(tmp_path / "x", ["rhs"], language=language)
    texts = [path.read_text("utf-8") for path in folder.iterdir() if path.suffix in (".py", ".pyx")]
    constants = re.findall(r"^NAME = (.*)$", "\n".join(texts), re.MULTILINE)
    assert [ast.literal_eval(constant) for constant in constants] == [name]
