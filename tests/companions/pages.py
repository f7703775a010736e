"""Companions to two books: rows of docs/companions/*.yaml, and the pages written from them."""

from __future__ import annotations

import ast
import inspect
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from ruamel.yaml import YAML

import cardan as cd
from companions import scenes

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
BOOKS = ("roberson_schwertassek", "geradin_cardona")
FIELDS = {"s", "as", "lacks", "on", "call", "holds", "formula", "theory", "example", "problem",
          "test", "number"}  # fmt: skip
NEEDED = {"on", "call", "holds", "formula", "theory", "example", "test", "number"}
# pictures of examples that pages of docs show
FIGURES = {
    "06_four_bar.py": "four_bar.svg",
    "15_flexible_slider_crank.py": "slider_crank.svg",
    "30_flexible_link.py": "link.png",
    "31_deployable_antenna.py": "antenna.png",
    "34_snap_through.py": "branches_truss.svg",
    "36_rotor_limit_cycle.py": "branches_whirl.svg",
}
# speeds and coordinates at which calls are made, by scene; others begin at rest at their defaults
STATES: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
    "double_pendulum": ({"theta1": 0.3, "theta2": 0.2}, {"theta1": 1.0, "theta2": -0.5}),
    "branched": ({"hip.angle1": 0.2, "slide": 0.1}, {"hip.u.angle1": 1.0, "slide.u": 0.3}),
    "top": ({}, {"pivot.u.x": 0.3, "pivot.u.z": 20.0}),
    "gimbals": ({"pivot.angle2": 0.5}, {"pivot.u.z": 20.0}),
    "free_body": ({}, {"free.u.x": 1.0, "free.u.y": 0.1}),
    "four_bar": ({"A": 1.0}, {"A": 2.0}),
    "coin": ({}, {"rolling.u.spin": 5.0}),
    "arm": ({"q1": 0.1, "q2": 0.4, "q3": -0.3}, {"q1": 1.0, "q2": 0.5, "q3": -0.2}),
}


@dataclass(frozen=True)
class Row:
    """A section of a book.

    Attributes:
        number: Of the section.
        title: A short one of our own.
        data: What the file says.
        parts: Numbers of its sections.
    """

    number: str
    title: str
    data: dict[str, str]
    parts: tuple[str, ...] = ()


def sections(book: str) -> dict[str, str]:
    """Number -> title of every section, as the table of contents has them."""
    text = (Path(__file__).parent / "sections" / f"{book}.txt").read_text("utf-8")
    lines = [line for line in text.splitlines() if line and not line.startswith("#")]
    return {number: title for number, _, title in (line.partition(" ") for line in lines)}


@cache
def companion(book: str) -> dict[str, Any]:
    """What the file of a companion says."""
    yaml = YAML(typ="safe", pure=True)
    # sections are numbered, not measured
    text = (DOCS / "companions" / f"{book}.yaml").read_text("utf-8")
    data: dict[str, Any] = yaml.load(text)
    for row in data["rows"]:
        row["s"] = str(row["s"])
        if "as" in row:
            row["as"] = str(row["as"])
    return data


def rows(book: str) -> list[Row]:
    """All sections in order; those without a row of their own have sections."""
    titles = sections(book)
    data = {row["s"]: row for row in companion(book)["rows"]}
    result = []
    for number, title in titles.items():
        parts = tuple(n for n in titles if n.rpartition(".")[0] == number)
        result.append(Row(number, title, data.get(number, {}), parts))
    return result


def statements(row: Row) -> str:
    """A call as statements that leave ``result``."""
    code = row.data["call"].strip()
    try:
        ast.parse(code, mode="eval")
    except SyntaxError:
        return code
    return f"result = {code}"


def builder(name: str) -> Any:
    """The function that makes a scene."""
    return getattr(scenes, name)


@cache
def subject(name: str) -> dict[str, Any]:
    """Names that calls on a scene use; the model is compiled when it is asked for."""
    scene = builder(name)()
    return {"scene": scene, "equations": cd.derive(scene)}


@cache
def compiled(name: str) -> dict[str, Any]:
    """The model of a scene and a state of it."""
    model = cd.compile(subject(name)["equations"])
    q, u = model.split(model.initial(*STATES.get(name, ({}, {}))))[:2]
    return {"model": model, "q": q, "u": u}


def anchor(title: str) -> str:
    """Anchor of a heading, as hosts of repositories and MyST make it."""
    kept = "".join(c for c in title.lower() if c.isalnum() or c in " -_")
    return kept.replace(" ", "-")


def heading(row: Row) -> str:
    return f"{row.number} {row.title}"


def page(book: str) -> str:
    """``docs/companions/<book>.md``."""
    data, all_rows = companion(book), rows(book)
    by_number = {row.number: row for row in all_rows}
    lines = [f"# Companion to {', '.join(data['book'].split(', ')[:-2])}", ""]
    lines += [INTRODUCTION.format(book=data["book"], notation=data["notation"], file=book)]
    for row in all_rows:
        depth = row.number.count(".")
        lines += [f"{'#' * (2 + min(depth, 2))} {heading(row)}", "", *_body(row, by_number), ""]
    lines += ["## Scenes", "", SCENES, ""]
    for name in sorted({row.data["on"] for row in all_rows if "on" in row.data}):
        source = inspect.getsource(builder(name)).rstrip()
        lines += [f"### {name}", "", "```python", source, "```", ""]
    return "\n".join(lines).rstrip() + "\n"


SCENES = """\
Calls are made on these scenes, at a state `q`, `u` of the model; `equations` are `cd.derive(scene)`
and `model` is `cd.compile(equations)`. They stand in
[tests/companions/scenes.py](../../tests/companions/scenes.py); other scenes of that file are
`scenes.boom()` and so on."""
INTRODUCTION = """\
{book}: every section of its table of contents, with the call that does it, its formula in the
symbols of the book ([list](symbols.md), `notation="{notation}"`), an example, and a test with what
it holds. Titles are our own; the numbers are those of the book. What is not offered says so.

Every call on this page is run by the tests, on the [scenes](#scenes) at its end, with
`import cardan as cd, numpy as np, sympy as sp` and `from scipy.spatial.transform import Rotation`.
The page is written from [{file}.yaml]({file}.yaml).
"""


def _body(row: Row, by_number: dict[str, Row]) -> Iterator[str]:
    data = row.data
    if not data:
        links = ", ".join(f"[{n}](#{anchor(heading(by_number[n]))})" for n in row.parts)
        yield f"See {links}."
        return
    if "as" in data:
        other = by_number[data["as"]]
        yield f"As [{heading(other)}](#{anchor(heading(other))})."
        return
    if "lacks" in data:
        yield data["lacks"].strip()
        yield from ("",) * ("theory" in data)
    if data.get("formula"):
        yield f"${data['formula']}$"
        yield ""
    if "call" in data:
        yield "```python"
        yield f"# on {data['on']}"
        yield data["call"].strip()
        yield "```"
        yield ""
    yield from _facts(data)


def _facts(data: dict[str, str]) -> Iterator[str]:
    """Where to read on, as one sentence."""
    facts = []
    if "theory" in data:
        facts.append(f"theory [{data['theory'].partition('#')[0]}]({_up(data['theory'])})")
    if "example" in data:
        figure = FIGURES.get(data["example"])
        example = f"example [{data['example']}](../../examples/{data['example']})"
        facts.append(example + (f" ([figure](../{figure}))" if figure else ""))
    if "problem" in data:
        name = data["problem"]
        drawn = (DOCS / "problems" / "figures" / f"{name}.svg").exists()
        figure = f" ([figure](../problems/figures/{name}.svg))" if drawn else ""
        facts.append(f"problem [{name}](../problems/{name}.md){figure}")
    if "test" in data:
        file, _, name = data["test"].partition("::")
        label = f"[{name or Path(file).stem}](../../{file})"
        facts.append(f"test {label}" + (f": {data['number']}" if data.get("number") else ""))
    if facts:
        sentence = "; ".join(facts)
        yield f"{sentence[0].upper()}{sentence[1:]}."


def _up(link: str) -> str:
    return link.removeprefix("companions/") if link.startswith("companions/") else f"../{link}"


def written() -> Iterator[tuple[str, str]]:
    """Files by their path in the project."""
    for book in BOOKS:
        yield f"docs/companions/{book}.md", page(book)
