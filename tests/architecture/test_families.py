"""Families: every file is listed by its ``__init__``, members never import each other."""

from __future__ import annotations

from architecture.sources import PACKAGE, imports, modules
from architecture.table import FAMILIES
from table import each


def members(family: str) -> set[str]:
    """Module names of the members of a family."""
    folder = PACKAGE.joinpath(*family.split("."))
    shared = FAMILIES[family] | {"__init__"}
    files = {path.stem for path in folder.glob("*.py")}
    folders = {path.parent.name for path in folder.glob("*/__init__.py")}
    return {f"cardan.{family}.{name}" for name in (files | folders) - shared}


@each("family", FAMILIES)
def test_every_file_is_listed(family: str) -> None:
    listed = {found.target for found in imports() if found.source == f"cardan.{family}"}
    # commands, passes and readers may be listed by name and loaded on demand
    text = modules()[f"cardan.{family}"].read_text(encoding="utf-8")
    missing = {
        name
        for name in members(family) - listed
        if f'"{name.rpartition(".")[2]}"' not in text
        and f'".{name.rpartition(".")[2]}"' not in text
    }
    assert not missing


@each("family", FAMILIES)
def test_members_do_not_import_each_other(family: str) -> None:
    inside = members(family)

    def member(module: str) -> str | None:
        return next((m for m in inside if module == m or module.startswith(m + ".")), None)

    wrong = [
        str(found)
        for found in imports()
        if member(found.source)
        and member(found.target)
        and member(found.source) != member(found.target)
    ]
    assert not wrong, "\n".join(wrong)
