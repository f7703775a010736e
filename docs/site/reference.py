"""Pages of the reference: every public name with its docstring and an example that runs.

The examples are programs in ``snippets/``: a line ``# Scene.body`` begins that of ``Scene.body``.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import cardan as cd
from golden.public import _function, _is_made, _members, _result, public, signature
from golden.verbs import held

SNIPPETS = Path(__file__).parent / "snippets"
MARK = re.compile(r"^# ([A-Za-z_][\w.]*(?:, [A-Za-z_][\w.]*)*)$", re.MULTILINE)

# page -> its title and the names on it, in this order; a module brings all of its functions
PAGES: dict[str, tuple[str, tuple[str, ...]]] = {
    "scene": (
        "Scenes",
        (
            *("Scene", "load", "examples", "from_dh", "from_sympy", "t", "table", "Body", "Frame"),
            *("Joint", "Force", "Beam", "Cable", "FlexibleBody", "Included", "Interpolation"),
            "GraphView",
        ),
    ),
    "joints": ("Joints", tuple(f"cardan.{name}" for name in cd._members("elements.joints"))),
    "forces": ("Forces", tuple(f"cardan.{name}" for name in cd._members("elements.forces"))),
    "parts": (
        "Inertias, shapes, sections, lines, orbits",
        ("inertia", "shape", "section", "material", "Material", "arc", "spline", "orbit"),
    ),
    "subsystems": ("Ready parts", ("parts",)),
    "superelements": ("Superelements", ("superelement", "DeformedSuperelement")),
    "equations": (
        "Equations",
        (
            *("derive", "Equations", "vectors", "Vectors", "constraints", "Formalism"),
            *("FiniteElementEquations", "Function", "Linearized", "LinearizedAlong"),
        ),
    ),
    "model": ("Compiled models", ("compile", "load_model", "CompiledModel")),
    "motion": (
        "Motions",
        (
            "Trajectory",
            "page",
            "load_motion",
            "GeneralizedAlpha",
            "cost",
            "CFunction",
            "stability",
            "Stepper",
        ),
    ),
    "ensembles": ("Ensembles", ("Ensemble", "load_ensemble", "sample")),
    "identification": ("Identification and conversion", ("excitation", "identify", "convert")),
    "errors": (
        "Errors and warnings",
        tuple(n for n in cd._PUBLIC if n.endswith(("Error", "Missing", "Warning"))),
    ),
}
REMAINING = ("results", "Results of analyses")


def snippets() -> dict[str, tuple[str, str]]:
    """Name -> its lines, and the program that they stand in."""
    found: dict[str, tuple[str, str]] = {}
    for file in sorted(SNIPPETS.glob("*.py")):
        parts = MARK.split(file.read_text(encoding="utf-8"))
        for names, code in zip(parts[1::2], parts[2::2], strict=True):
            for name in names.split(", "):
                assert name not in found, f"two examples of {name}"
                found[name] = code.strip(), file.stem
    return found


def label(key: str) -> str:
    """Name for readers: without ``cardan.``, with the room of a record of the same name."""
    if key.startswith("cardan.") or f"cardan.{key}" not in public():
        return key.removeprefix("cardan.")
    return f"{public()[key].__module__.split('.')[1]}.{key}"


@cache
def makers() -> dict[str, str]:
    """Class of results -> the first function or method with an example that returns it."""
    found: dict[str, str] = {}
    examples = snippets()
    for key, value in public().items():
        named = _members(value) if inspect.isclass(value) and not _is_made(value) else [("", value)]
        for own, member in named:
            for word in re.findall(r"\w+", held(_result(_function(member)))):
                name = f"{label(key)}.{own}".rstrip(".")
                if word != key and name in examples:
                    found.setdefault(word, name)
    return found


def members(kind: type) -> dict[str, Any]:
    """Methods and properties of a class for readers."""
    return {} if _is_made(kind) else {n: x for n, x in _members(kind) if not isinstance(x, str)}


def pages() -> dict[str, tuple[str, list[str]]]:
    """Page -> its title and all keys of ``public()`` on it."""
    everything = list(public())
    taken: set[str] = set()
    result = {}
    for page, (title, names) in PAGES.items():
        keys = []
        for name in names:
            key = next(k for k in (name, f"cardan.{name}") if k in everything)
            keys += [key, *(k for k in everything if k.startswith(f"{key}."))]
        result[page] = title, keys
        taken |= set(keys)
    remaining = [key for key in everything if key not in taken and key != "cardan.__version__"]
    page, title = REMAINING
    return {**result, page: (title, remaining)}


def entry(key: str, examples: dict[str, tuple[str, str]]) -> Iterator[str]:
    """Lines of reStructuredText about one public name."""
    value = public()[key]
    name = label(key)
    yield from ("", name, "-" * len(name), "")
    if inspect.ismodule(value):
        yield from (f".. py:module:: {key}", "", ".. py:currentmodule:: None", "")
        yield from (inspect.getdoc(value) or "", "")
        yield from _example(name, examples, "")
    elif inspect.isclass(value) and value.__name__ != name.rpartition(".")[2]:
        yield from _alias(key, value, examples)
    elif inspect.isclass(value):
        dotted = key if key.startswith("cardan.") else f"{value.__module__}.{value.__qualname__}"
        kind = "autoexception" if issubclass(value, Exception) else "autoclass"
        yield from (f".. {kind}:: {dotted}", "", *_example(name, examples, "   "))
        maker = makers().get(key)
        if maker is not None and name not in examples:
            yield from (f"   Returned by ``{maker}``.", "", *_example(maker, examples, "   "))
        said = inspect.getdoc(value) or ""
        for own, member in members(value).items():
            listed = re.search(rf"^    (\w+, )*{own}(, \w+)*: ", said, re.MULTILINE)
            plain = isinstance(member, property | cached_property)
            if listed and f"{name}.{own}" not in examples:
                continue
            directive = "autoproperty" if plain else "automethod"
            yield from (f"   .. {directive}:: {dotted}.{own}", "")
            yield from _example(f"{name}.{own}", examples, "      ")
    elif callable(value):
        yield from (f".. autofunction:: {key}", "", *_example(name, examples, "   "))
    else:
        yield from (f".. py:data:: {key}", "", f"   {DATA[name]}", "")
        yield from _example(name, examples, "   ")


def _alias(key: str, value: type, examples: dict[str, tuple[str, str]]) -> Iterator[str]:
    """Entry of a class that users call by another name, which autodoc would only refer to."""
    from sphinx.ext.napoleon import Config, GoogleDocstring

    config = Config(napoleon_use_rtype=False, napoleon_custom_sections=["Source"])
    text = str(GoogleDocstring(inspect.getdoc(value) or "", config))
    yield from (f".. py:class:: {key}{signature(value).removesuffix(' -> None')}", "")
    yield from (f"   {line}".rstrip() for line in text.splitlines())
    yield from ("", *_example(label(key), examples, "   "))


DATA = {
    "t": "The time, a SymPy symbol: any number of a scene may be an expression in it.",
    "examples": "Scenes that come with cardan, by name.",
}


def _example(name: str, examples: dict[str, tuple[str, str]], indent: str) -> Iterator[str]:
    if name not in examples:
        return
    code, program = examples[name]
    yield from (
        f"{indent}.. code-block:: python",
        f"{indent}   :caption: In :doc:`programs/{program}`",
        "",
    )
    yield from (f"{indent}   {line}".rstrip() for line in code.splitlines())
    yield ""


def write(folder: Path) -> None:
    """Write all pages."""
    (folder / "programs").mkdir(parents=True, exist_ok=True)
    examples, contents = snippets(), pages()
    for page, (title, keys) in contents.items():
        lines = [title, "=" * len(title), ".. py:currentmodule:: None"]
        for key in keys:
            lines += entry(key, examples)
        (folder / f"{page}.rst").write_text("\n".join(lines) + "\n", encoding="utf-8")
    programs = sorted(file.stem for file in SNIPPETS.glob("*.py"))
    for name in programs:
        text = (SNIPPETS / f"{name}.py").read_text(encoding="utf-8")
        title = f"Examples: {name}"
        body = f"# {title}\n\n```python\n{text}```\n"
        (folder / "programs" / f"{name}.md").write_text(body, encoding="utf-8")
    listed = {"": contents, "## Programs of the examples": [f"programs/{n}" for n in programs]}
    text = "\n".join(
        f"{heading}\n\n```{{toctree}}\n:maxdepth: 1\n\n" + "\n".join(names) + "\n```\n"
        for heading, names in listed.items()
    )
    (folder / "index.md").write_text(f"# Reference\n\n{LEAD}\n{text}", encoding="utf-8")


LEAD = (
    "Every public name with its arguments, results, units, errors and sources, and a few lines "
    "that run. The lines of one page belong to one program, in this order, which the tests run."
)
