"""Nothing is left out of the site: pages, examples, public names, members of families, words."""

from __future__ import annotations

import inspect
import re
from pathlib import Path

import build_site
import gallery
import pytest
import reference
import theory
import words

import cardan as cd
from golden.public import _members, public
from table import each

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
EXAMPLES = reference.snippets()
# names with a capital are used under other ones, such as that of a variable that holds one
NAMED = [name for name in EXAMPLES if name.rpartition(".")[2][0].islower()]


def asked() -> list[str]:
    """Names of ``cardan``, with methods and properties of their classes."""
    found = []
    for key, value in public().items():
        if key.startswith("cardan.") and key != "cardan.__version__":
            name = reference.label(key)
            found.append(name)
            if inspect.isclass(value):
                found += [f"{name}.{own}" for own in reference.members(value)]
    return found


def test_every_public_name_has_a_place_in_the_reference() -> None:
    listed = [key for _, keys in reference.pages().values() for key in keys]
    assert sorted(listed) == sorted(set(public()) - {"cardan.__version__"})


def test_every_public_name_has_an_example() -> None:
    assert not [name for name in asked() if name not in EXAMPLES]


def test_every_class_of_results_has_an_example() -> None:
    results = [key for key in public() if not key.startswith("cardan.")]
    shown = {*EXAMPLES, *(key for key in results if key in reference.makers())}
    assert not [key for key in results if not {key, reference.label(key)} & shown]


def test_every_example_is_of_something_public() -> None:
    every = set()
    for key, value in public().items():
        name = reference.label(key)
        every |= {name}
        if inspect.isclass(value):
            every |= {f"{name}.{own}" for own, _ in _members(value)}
    assert not set(EXAMPLES) - every


@each("name", NAMED)
def test_an_example_uses_its_name(name: str) -> None:
    code, _ = EXAMPLES[name]
    assert re.search(rf"\b{name.rpartition('.')[2]}\b", code), code


def test_every_page_stands_in_the_guide() -> None:
    listed = {page for chapter in build_site.GUIDE.values() for page in chapter}
    front = {"words", "translations"}
    written = {place for _, place in build_site.pages()}
    top = {p for p in written if "/" not in p} - {
        path.stem for path in build_site.HERE.glob("*.md")
    }
    assert top - front == {page for page in listed if "/" not in page}


def test_every_example_stands_in_the_gallery() -> None:
    folder = ROOT / "examples"
    programs = {path.name for path in folder.iterdir() if path.suffix in {".py", ".ipynb"}}
    assert {path.name for path in gallery.examples()} == programs
    for path in folder.glob("*.py"):
        assert gallery.Result(path, folder, "").title, path.name


def test_formulas_of_formalisms_and_integrators() -> None:
    assert set(theory.EQUATIONS) == set(theory.FORMALISMS)
    for method in theory.INTEGRATORS.values():
        written = {method.name, method.kernel} & set(theory.STEPS)
        assert written or "$$ b" in "".join(theory._tableau(method)), method.name


@each("row", [f"{', '.join(names)}: {page}" for names, page in words.table()])
def test_words_lead_to_pages(row: str) -> None:
    page = row.rpartition(": ")[2]
    assert (DOCS / f"{page}.md").exists()


def test_words_name_what_exists() -> None:
    holders = {"cd": cd, "scene": cd.Scene, "model": cd.CompiledModel, "motion": cd.Trajectory,
               "equations": cd.Equations}  # fmt: skip
    text = (DOCS / "words.md").read_text(encoding="utf-8")
    for holder, name in re.findall(r"\b(cd|scene|model|motion|equations)\.(\w+)", text):
        assert hasattr(holders[holder], name), f"{holder}.{name}"
    rows = re.findall(r"^\| .* \|$", text, re.MULTILINE)
    assert len(rows) - 1 == len(words.table())


def test_the_cheat_sheet_has_the_names_of_cardan() -> None:
    pytest.importorskip("latex2mathml")
    import cheat_sheet

    text = cheat_sheet.sheet()
    assert text.count("<main>") == 2
    members = [n for module in cd._FAMILIES for n in cd._members(module)]
    errors = {n for n in cd._PUBLIC if n.endswith(("Error", "Warning", "Missing"))}
    for name in (*cd._PUBLIC, *members):
        assert name in errors or f"<b>cd.{name}</b>" in text, name
    for name in cheat_sheet.FORMULAS:
        assert name in cheat_sheet.FUNCTIONS
        assert f"<b>{name}(" in text
