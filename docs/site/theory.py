"""Pages of theory: every formalism, joint, force, flexible element, section and integrator.

Texts and sources are those of the docstrings, formulas those of the code: what a joint computes is
called with symbols, what an element does is what ``equations.explain`` says of it.
"""

from __future__ import annotations

import inspect
import re
import sys
from collections.abc import Iterable, Iterator
from fractions import Fraction
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import sympy
from reference import MARK, SNIPPETS
from theory_formulas import EQUATIONS, STEPS

import cardan as cd
from cardan.elements.centerlines import CENTERLINES
from cardan.elements.flexible import BEAMS, FLEXIBLE
from cardan.elements.forces import FORCES
from cardan.elements.joints import JOINTS
from cardan.elements.sections import SECTIONS
from cardan.equations.constraints.treatments import TREATMENTS
from cardan.equations.formalisms import FORMALISMS, OTHER_NAMES
from cardan.equations.kinematics.kinematics import Kinematics
from cardan.explain.content import Written
from cardan.explain.formulas import formula_line
from cardan.ir.arithmetic import Scalar
from cardan.ir.forms.sympy_out import to_sympy
from cardan.ir.graph import Graph
from cardan.schema.integrators import INTEGRATORS
from cardan.spatial.rotations import ROTATIONS

GIVEN = ("shear", "rhoI")  # what a user may give of a section in place of what its sizes say
LONGEST = 900  # letters of LaTeX of a formula that is shown


def prose(what: object) -> str:
    """The text of a docstring without its sections, and its source, as Markdown."""
    text = inspect.getdoc(what) or ""
    return plain(
        re.split(r"^(?:Args|Returns|Raises|Attributes|Source):", text, flags=re.MULTILINE)[0]
    )


def plain(text: str) -> str:
    """reStructuredText of docstrings as Markdown."""
    text = re.sub(r":\w+:`~?([^`]*)`", r"`\1`", text)
    return re.sub(
        r"``(.*?)``", lambda m: "`" + " ".join(m[1].split()) + "`", text, flags=re.DOTALL
    ).strip()


def source(what: object) -> str:
    """The source that a docstring cites."""
    _, cited, text = (inspect.getdoc(what) or "").partition("Source:")
    return f"*Source: {' '.join(text.split())}*" if cited else ""


def display(name: str, value: Any) -> Iterator[str]:
    """name = value on a line of its own, where that is short enough to read."""
    latex = sympy.latex(value, mat_str="pmatrix", mat_delim="")
    if len(latex) <= LONGEST:
        yield f"$$ {name} = {latex} $$\n"


def listing(lines: Iterable[tuple[str, str]]) -> Iterator[str]:
    """Formulas of an element, with what each one is."""
    for about, formula in lines:
        parts = formula_line(about, formula)
        yield "- " + "".join(f"${p.latex}$" if isinstance(p, Written) else str(p) for p in parts)
    yield ""


def formalisms() -> Iterator[str]:
    yield (
        "All of these give $M \\dot u + h = f + \\tau$ for a tree, and with the treatments of "
        "[constraints](constraints.md) for closed loops. They share the kinematics of the tree: pose, "
        "angular velocity and velocity of every body from those of its parent and the joint between. "
        "A second index r is a derivative by the speed u_r; an index 0 of an acceleration is its part "
        "at zero accelerations of the joints. c(i) are the bodies that body i carries, p(i) is the "
        "one that carries it, X moves 6-vectors from a body to one it carries; J is the inertia about "
        "the center of mass and I that of 6-vectors.\n"
    )
    for name in FORMALISMS:
        module = sys.modules[f"cardan.equations.formalisms.{name}"]
        yield f"## {name}\n"
        alias = [other for other, ours in OTHER_NAMES.items() if ours == name]
        if alias:
            yield f"Elsewhere: {', '.join(alias)}.\n"
        yield prose(module) + "\n"
        for formula in EQUATIONS[name]:
            yield f"$$ {formula} $$\n"
        yield f"{source(module)}\n"


def joints() -> Iterator[str]:
    yield (
        "P is the frame of the joint on its parent, C that on its child; R turns coordinates in C "
        "into those in P, p is the origin of C in P. The columns of S are the velocities of C against "
        "P, angular part first, in axes of C. Where a joint closes a loop, or stands between nodes in "
        "absolute coordinates, it holds g = 0 and pulls with the multipliers λ.\n"
    )
    for element in JOINTS.values():
        scene = _scene("joints", element.__name__)
        (joint,) = [j for j in scene.joints.values() if type(j.kind) is element]
        yield f"## {element.__name__}\n"
        yield prose(element) + "\n"
        yield from _tree_formulas(scene, joint.name)
        yield from _element_formulas(scene, element.kind)
        yield source(element) + "\n"


def _tree_formulas(scene: cd.Scene, name: str) -> Iterator[str]:
    """Pose, motion subspace and rates of a joint of a tree, from its methods."""
    k = Kinematics(cd.derive(scene, method="kane").system)
    for i, joint in enumerate(k.system.joints):
        if joint.name != name:
            continue
        element, q, data = joint.element, k.coordinates[i], k.data[i]
        letters = [c.name or "q" for c in element.coordinates]
        R, p = element.pose(q, **data)
        for letter, matrix in (("R", R), ("p", p), ("S", element.motion(q, **data))):
            if matrix.rows and matrix.columns:
                yield from display(letter, _renamed(to_sympy(matrix), q, letters))


def _renamed(matrix: sympy.Matrix, q: Any, letters: list[str]) -> sympy.Matrix:
    """A matrix in the names of the coordinates."""
    own = [to_sympy(q[n]) for n in range(len(letters))]
    pairs = {
        a: sympy.Symbol(b if len(b) < 3 else rf"\mathrm{{{b}}}")
        for a, b in zip(own, letters, strict=True)
        if a.is_Symbol
    }
    return matrix.subs(pairs, simultaneous=True) if pairs else matrix


def forces() -> Iterator[str]:
    yield (
        "Forces F at the origin of a frame, moments M on it, and forces τ along a joint; with a "
        "potential energy V where there is one.\n"
    )
    for element in FORCES.values():
        scene = _scene("forces", element.__name__)
        yield f"## {element.__name__}\n"
        yield prose(element) + "\n"
        lines = list(_element_formulas(scene, element.kind))
        yield from lines or _generalized(scene)
        yield source(element) + "\n"


def _generalized(scene: cd.Scene) -> Iterator[str]:
    """The generalized forces of a scene that holds one element."""
    try:
        f = cd.derive(scene).forces
    except cd.CardanError:
        return
    if any(f):
        yield "In the scene of the example, along the speeds:\n"
        yield from display("f", f)


def flexible() -> Iterator[str]:
    yield "Elements of beams, what they weigh, and what loads them; see [beams](../flexible.md).\n"
    names = {type(element).kind: [] for element in BEAMS.values()}
    for name, element in BEAMS.items():
        names[element.kind].append(name)
    for kind, element in FLEXIBLE.items():
        yield f"## {element.__name__}\n"
        if kind in names:
            yield f"Called {', '.join(f'`{n}`' for n in names[kind])} in `scene.beam(element=)`.\n"
        yield prose(element) + "\n"
        lines = element.formulas
        yield from listing(lines if isinstance(lines, tuple) else ())
        yield source(element) + "\n"


def sections() -> Iterator[str]:
    yield (
        "Stiffnesses of a section against stretch (EA), shear (GA), twist (GJ) and bending (EI) about "
        "its axes e2 and e3, mass and moments of inertia per length. E, G, ν and ρ are of the material.\n"
    )
    graph = Graph()
    material = {name: Scalar(graph, graph.atom(name)) for name in ("E", "G", "nu", "rho")}
    for kind, section in SECTIONS.items():
        yield f"## {section.__name__}\n\n`cd.section.{kind}(...)`: " + prose(section) + "\n"
        if section.shaped:
            sizes = {n: Scalar(graph, graph.atom(n)) for n in section.units if n not in GIVEN}
            found = section.stiffness(object.__new__(section), sizes, material)
            for name, value in vars(found).items():
                upright = {
                    x: sympy.Symbol(rf"\mathrm{{{x.name}}}") for x in to_sympy(value).free_symbols
                }
                rational = sympy.nsimplify(to_sympy(value), [sympy.pi])
                yield from display(_index(name), rational.subs(upright))
        yield source(section) + "\n"
    yield "## Centerlines\n"
    for line in CENTERLINES.values():
        yield f"### {line.__name__}\n\n{prose(line)}\n\n{source(line)}\n"


def _index(name: str) -> str:
    return re.sub(r"rho", r"\\rho ", re.sub(r"(\d)$", r"_\1", name))


def integrators() -> Iterator[str]:
    yield (
        "Every integrator is one record and one C file. `simulate(method=)` takes these names; "
        "[choosing an integrator](../integrators.md) says which, and what they cost.\n"
    )
    for name, method in INTEGRATORS.items():
        yield f"## {name}\n\nTake it for {method.applies}.\n"
        yield f"- error of order {method.order} in the step, dense output of order {method.dense_order}"
        yield f"- {'adaptive step' if method.adaptive else 'fixed step'}"
        yield f"- functions besides `rhs`: {', '.join(method.needs) or 'none'}"
        for said, holds in (
            ("quaternions by their increments: a Lie group method", method.charted),
            ("finds the multipliers along with the motion", method.multipliers),
            ("several runs in the lanes of a processor", method.lanes),
        ):
            if holds:
                yield f"- {said}"
        yield ""
        yield from (
            f"$$ {formula} $$\n" for formula in STEPS.get(name, STEPS.get(method.kernel, ()))
        )
        yield from _tableau(method)
        yield f"*Source: {method.source}*\n"


def _tableau(method: Any) -> Iterator[str]:
    """Butcher's coefficients of a method that has them in its record or in SciPy."""
    rows = [list(row) for row in method.tableau]
    a, b = rows[:-1], rows[-1] if rows else []
    if not rows:
        from scipy import integrate

        known = getattr(integrate, name_in_scipy(method), None)
        if known is None or not hasattr(known, "A") or len(known.B) > 7:
            return
        a, b = [list(row) for row in known.A], list(known.B)
    wide = max(len(b), *map(len, a))
    table = [[_fraction(x) for x in row + [0] * (wide - len(row))] for row in a]
    yield "Stages $k_i = f(t + c_i h,\\, x + h \\sum_j a_{ij} k_j)$, step $x + h \\sum_i b_i k_i$ with\n"
    yield from display("a", sympy.Matrix(table))
    yield from display("b", sympy.Matrix([[_fraction(x) for x in b]]))


def _fraction(x: float) -> sympy.Expr:
    """The fraction that a printed coefficient stands for."""
    fraction = Fraction(float(x)).limit_denominator(60_000)
    return (
        sympy.Rational(fraction) if abs(fraction - Fraction(float(x))) < 1e-15 else sympy.Float(x)
    )


def name_in_scipy(method: Any) -> str:
    """The method of SciPy with the same coefficients; methods on Lie groups share them."""
    return {"RKMK45": "RK45", "RKMK853": "DOP853"}.get(method.name, method.name)


def constraints() -> Iterator[str]:
    yield (
        "A loop closes where $g(q, t) = 0$, so $G u + g_t = 0$ and $G \\dot u = \\gamma$; with the "
        "multipliers λ, $M \\dot u + h = f + \\tau + G^T \\lambda$. `derive(constraints=)` takes:\n"
    )
    for name, treatment in TREATMENTS.items():
        yield f"## {name}\n\n{prose(treatment)}\n\n{source(treatment)}\n"
    yield "## Rotations\n\n`Spherical` and `Free` take them as `rotation=`.\n"
    for name, rotation in ROTATIONS.items():
        kind = rotation if inspect.isclass(rotation) else type(rotation)
        yield f"### {name}\n\n{prose(kind)}\n\n{source(kind)}\n"


def _scene(program: str, name: str) -> cd.Scene:
    """The scene of an example that holds one element of a kind."""
    head, *parts = MARK.split((SNIPPETS / f"{program}.py").read_text(encoding="utf-8"))
    codes = dict(zip(parts[::2], parts[1::2], strict=True))
    names: dict[str, Any] = {}
    exec(head, names)
    before = {"GravityGradient": "CentralGravity", "J2": "CentralGravity", "Gear": "Revolute"}
    last = list(codes)[-1]
    for part in (before.get(name), name):
        if part is not None:
            code = codes[part]
            exec(
                code.partition("\nmodel =")[0].partition("\nfor ")[0] if part == last else code,
                names,
            )
    scenes = [x for x in names.values() if isinstance(x, cd.Scene)]
    return scenes[-1]


def _element_formulas(scene: cd.Scene, kind: str) -> Iterator[str]:
    """What the page of a scene in absolute coordinates says of one kind of element."""
    with TemporaryDirectory() as folder:
        try:
            page = cd.derive(scene, coordinates="absolute").explain(Path(folder, "page.md"))
        except cd.CardanError:
            return
        text = page.read_text(encoding="utf-8")
    _, _, text = text.partition("## Equations of the elements\n")
    text, _, _ = text.partition("\n## ")
    for block in re.split(r"\n(?=[^\n]*:\n\n- )", text)[1:]:
        head, _, body = block.partition(":\n")
        kinds = [one.strip().replace("\\", "") for one in head.split(",")]
        if any(one.split(" ")[0] == kind for one in kinds):
            yield body.partition("Source:")[0].strip() + "\n"
            return


PAGES = {
    "formalisms": ("Theory: formalisms", formalisms),
    "joints": ("Theory: joints", joints),
    "forces": ("Theory: forces", forces),
    "flexible": ("Theory: flexible elements", flexible),
    "sections": ("Theory: sections of beams", sections),
    "constraints": ("Theory: constraints", constraints),
    "integrators": ("Theory: integrators", integrators),
}


def write(folder: Path) -> None:
    """Write all pages."""
    folder.mkdir(parents=True, exist_ok=True)
    for page, (title, content) in PAGES.items():
        text = f"# {title}\n\n" + "\n".join(content())
        (folder / f"{page}.md").write_text(text + "\n", encoding="utf-8")
    listed = "\n".join(PAGES)
    lead = "The equations behind every member of every family, from the code that computes them."
    index = f"# Theory\n\n{lead}\n\n```{{toctree}}\n:maxdepth: 2\n\n{listed}\n```\n"
    (folder / "index.md").write_text(index, encoding="utf-8")
