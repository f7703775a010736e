"""Whatever things are called, a name leads out of no target: C, Python, HTML, SVG, DOT, TeX."""

from __future__ import annotations

import ast
import json
import re
import subprocess
import sys
import tomllib
import xml.etree.ElementTree as ET
from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest

import cardan as cd
from cardan.cli import main
from cardan.explain import document
from cardan.explain.writers import WRITERS
from codegen.running import STRICT, compilers
from explain.tex import problems
from spread import some

NAMES = {
    "comment end": "*/ int main(void) {} /*",
    "trigraph": "??/ what??'",
    "script": "<script>alert(1)</script>",
    "image": '"><img src=x onerror=alert(1)>',
    "tex": r"\end{document} $x_1^2$ % & # ~",
    "dot": '"; digraph { a -> b }',
    "cdata": "]]> -->",
    "quotes": "a\"b'c`d",
    "shell": "${HOME} $(ls) ; rm",
    "path": "../../etc/passwd",
    "backslash": "end\\",
    "braces": "{brace} {{x}} %s %n",
    "markup": "[red]x[/red] [link]",
    "letters": "größe θ 関節",
    "keyword": "while",
    "yaml": "no: {a: [1, &b *c]} # d",
    "long": "x" * 110,
}


def scene_of(word: str, first: bool = False) -> cd.Scene:
    """A scene all of whose names have the word in them, behind or before a letter."""

    def named(letter: str) -> str:
        return f"{word} {letter}" if first else f"{letter} {word}"

    scene = cd.Scene(named("m"), gravity=(0, 0, -9.81))
    k = scene.parameter(named("k"), 3.0)
    push = scene.input(named("r"))
    arm = scene.body(named("b"), mass=1.0, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
    tip = scene.body(named("c"), mass=0.5, com=(0, 0.1, -0.2), inertia=(0.1, 0.1, 0.01))
    scene.joint(named("j"), cd.Revolute("y"), scene.ground, arm)
    scene.joint(named("i"), cd.Spherical(), arm.at(0, 0, -1), tip)
    scene.force(named("f"), cd.JointForce(named("j"), push - k * scene.q(named("j"))))
    # parameters and outputs that are one after mangling
    for name in ("p q", "p_q", "p-q"):
        scene.output(named(name), scene.parameter(named(name), 1.0) * scene.u(named("j")))
    scene.output(named("o"), k * scene.q(named("j")))
    # names that are one after mangling
    for name in ("a b", "a_b", "a-b"):
        fixed = scene.body(named(name), mass=0.1)
        scene.joint(named(f"to {name}"), cd.Fixed(), tip, fixed)
    return scene


class Tags(HTMLParser):
    """Tags and attributes of a page."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.attributes: set[str] = set()
        self.feed(text)

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        self.attributes |= {name for name, _ in attributes}


@pytest.mark.parametrize("word", some(NAMES.values(), 16), ids=NAMES)
def test_c_and_python(word: str, tmp_path: Path) -> None:
    equations = cd.derive(scene_of(word, first=True))
    functions = [*equations.operations, "outputs", "power", "energy", ("pose", f"{word} c")]
    folder = equations.export(tmp_path / "out", functions, integrators=("rk4",))
    assert list(tmp_path.iterdir()) == [folder]
    command = [*compilers()["gcc"], *STRICT, "-DCARDAN_EXAMPLE", "-o", str(tmp_path / "example")]
    sources = sorted(map(str, folder.glob("*.c")))
    done = subprocess.run([*command, *sources, "-lm"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr[:2000]
    ast.parse((folder / "setup.py").read_text("utf-8"))
    tomllib.loads((folder / "pyproject.toml").read_text("utf-8"))
    names = json.loads((folder / "manifest.json").read_text("utf-8"))
    assert names["bodies"][0]["name"] == f"{word} b"
    # Cython reads the names back as they were
    (pyx,) = folder.glob("*.pyx")
    assignments = pyx.read_text("utf-8").split("\nCOORDINATES = ")[1].split("\n\n_SIZES")[0]
    module = ast.parse("COORDINATES = " + assignments)
    found = {node.targets[0].id: ast.literal_eval(node.value) for node in module.body}
    assert found["COORDINATES"][0] == f"{word} j"
    command = [sys.executable, "-m", "cython", "-3", str(pyx), "-o", str(tmp_path / "out.c")]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr[:2000]


@cache
def drawn(word: str, kind: str) -> Tags:
    """The page of a motion of a scene."""
    with TemporaryDirectory() as folder:
        motion = cd.compile(scene_of(word)).simulate(0.1)
        return Tags(motion.animate(Path(folder) / "p.html", page=kind).html)


@pytest.mark.parametrize("word", some(NAMES.values(), 4, 2), ids=NAMES)
def test_pages_and_pictures(word: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene = scene_of(word)
    motion = cd.compile(scene).simulate(0.1)
    history = Tags(motion._repr_html_())
    assert {"script", "img"} & set(history.tags) == set()
    assert history.tags.count("svg") == 2
    for kind in ("3d", "plain"):
        page = Tags(motion.animate(tmp_path / "run.html", page=kind).html)
        expected = drawn("plain", kind)
        assert (page.tags, page.attributes) == (expected.tags, expected.attributes)

    # scene files
    scene.save(tmp_path / "hostile.yaml")

    # on a screen names are not markup
    assert main(["simulate", str(tmp_path / "hostile.yaml"), "--time", "0.1"]) == 0
    said = "".join(capsys.readouterr().out.split())
    assert "".join(word.split())[:10] in said

    back = cd.load(tmp_path / "hostile.yaml")
    assert list(back.bodies) == list(scene.bodies)
    motion.save(tmp_path / "run.nc")
    stored = cd.load_motion(tmp_path / "run.nc")
    np.testing.assert_array_equal(stored[f"j {word}"], motion[f"j {word}"])


@cache
def shown_in_notebooks(word: str) -> list[str]:
    scene = scene_of(word)
    equations = cd.derive(scene)
    shown = (scene, scene.graph, scene.graph.incidence, equations, equations.base_parameters())
    return [x._repr_html_() for x in shown]


@pytest.mark.parametrize("word", some(NAMES.values(), 16, 3), ids=NAMES)
def test_notebooks(word: str) -> None:
    plain = shown_in_notebooks("plain")
    for ours, theirs in zip(shown_in_notebooks(word), plain, strict=True):
        page, expected = Tags(ours), Tags(theirs)
        assert {"script", "img", "link", "iframe"} & set(page.tags) == set()
        assert page.attributes <= expected.attributes | {"intent"}
        assert set(page.tags) <= set(expected.tags) | {"msub", "msup", "msubsup", "mtext"}


@cache
def plain_graph() -> set[str]:
    """The kinds of elements in the picture of a graph."""
    return {e.tag for e in ET.fromstring(scene_of("plain").graph._repr_svg_()).iter()}


@pytest.mark.parametrize("word", some(NAMES.values(), 3, 1), ids=NAMES)
def test_graphs_and_formulas(word: str) -> None:
    scene = scene_of(word)
    kinds = [element.tag for element in ET.fromstring(scene.graph._repr_svg_()).iter()]
    assert set(kinds) == plain_graph()
    dot = scene.graph.dot()
    # every quote that is none of a name's own opens or closes one
    assert dot.replace("\\\\", "").replace('\\"', "").count('"') % 2 == 0
    latex = cd.derive(scene)._repr_latex_()
    assert latex.count("$") - latex.count(r"\$") == 2
    assert r"\end{document}" not in latex
    assert latex.count("{") - latex.count(r"\{") == latex.count("}") - latex.count(r"\}")


@cache
def explained(word: str) -> dict[str, str]:
    """Ending -> text of the pages of a scene."""
    made = document(cd.derive(scene_of(word)))
    return {e: t for w in WRITERS.values() for e, t in w.write(made, Path("page")).items()}


@pytest.mark.parametrize("word", some(NAMES.values(), 17, 4), ids=NAMES)
def test_explained(word: str) -> None:
    found = {"hostile": explained(word), "plain": explained("plain")}
    sheets = [Tags(found[name][".html"]) for name in ("hostile", "plain")]
    assert {"script", "img", "link"} & set(sheets[0].tags) == set()
    assert sheets[0].attributes <= sheets[1].attributes | {"intent"}
    assert set(sheets[0].tags) <= set(sheets[1].tags) | {"msub", "msup", "msubsup", "mtext"}
    assert problems(found["hostile"][".tex"]) == []
    hostile, plain = found["hostile"][".md"], found["plain"][".md"]
    # HTML within Markdown: what is folded, and nothing else
    tags = [re.sub(r"<(/?\w+)[^>]*>", r"\1", tag) for tag in re.findall(r"<[^>]*>", hostile)]
    assert set(tags) <= {"details", "/details", "summary", "/summary"}
    # as many headings, tables and formulas
    for mark in ("## ", "| ", "- "):
        assert [line.startswith(mark) for line in hostile.split("\n")].count(True) == [
            line.startswith(mark) for line in plain.split("\n")
        ].count(True)
    assert hostile.count("\n$$\n") == plain.count("\n$$\n")
    ET.fromstring(found["hostile"][".svg"])
