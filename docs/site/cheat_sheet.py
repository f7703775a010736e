"""Two pages A4 to print: formulas and methods, from the table of functions and the public names."""

from __future__ import annotations

import html
import inspect
import re
import subprocess
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import latex2mathml.converter
from gallery import browser

import cardan as cd
from cardan.runtime.calls.functions import Functions
from cardan.schema.functions import FUNCTIONS
from cardan.schema.integrators import INTEGRATORS

# what the text of the table says of a function, as a formula
FORMULAS = {
    "rhs": r"\dot x = (\dot q, \dot u, \dot z)",
    "forward_dynamics": r"\dot u = M^{-1}(f + \tau - h)",
    "inverse_dynamics": r"\tau = M \dot u + h - f",
    "mass_matrix": "M(q)",
    "bias": "h(q, u)",
    "gravity": "h(q, 0)",
    "coriolis": "h(q, u) - h(q, 0)",
    "applied_forces": "f(q, u)",
    "qdot": r"\dot q = N(q) u + n",
    "energy": "T, V, T + V",
    "pose": r"\begin{pmatrix} R & p \\ 0 & 1 \end{pmatrix}",
    "velocity": r"(\omega, v)",
    "acceleration": r"(\alpha, a)",
    "frame_jacobian": r"(\omega, v) = J u",
    "com": r"\sum m p / \sum m",
    "momentum": r"(L, P)",
    "hamiltonian": r"p \cdot u - T + V",
    "reaction": r"(M, F)",
    "constraints": "g(q, t) = 0",
    "constraint_rates": "G u + g_t = 0",
    "constraint_jacobian": r"G \dot u = \gamma",
    "multipliers": r"M \dot u + h = f + \tau + G^T \lambda",
    "power": r"\dot W",
    "events": r"e(q, u) \downarrow 0",
    "integrate": r"q \oplus \Delta u",
    "difference": r"q_1 \ominus q_0",
    "regressor": r"\tau = Y \varphi",
    "momenta": r"p = \partial T / \partial u",
    "momentum_rates": r"\dot p",
    "strain_energy": "V_e",
    "rhs_jacobian": r"\partial \dot x / \partial x",
}
# analyses of a model beyond its functions, in the order of use
VERBS = (
    *("simulate", "stepper", "ensemble", "assemble", "sweep", "equilibrium", "statics"),
    *("continuation", "cycle", "trim", "linearize", "modes", "campbell", "root_locus"),
    *("sensitivity", "derivative", "hybrid_dynamics", "workspace", "redundancy", "torques"),
    *("identify", "report", "verify", "with_parameters"),
)
SCENE = ("parameter", "input", "body", "joint", "force", "beam", "cable", "superelement")
SCENE += ("constraint", "output", "include", "q", "u", "save")
EQUATIONS = (
    "mass_matrix",
    "bias",
    "forces",
    "constraints",
    "symbolic",
    "contributions",
    "linearize",
)
EQUATIONS += ("conserved", "to_sympy", "explain", "export")
MOTION = ("at", "pose", "reaction", "energy", "energy_residual", "drift", "balance", "events")
MOTION += ("beam", "plot", "animate", "save", "to_xarray")


def summary(what: object) -> str:
    """First sentence of a docstring."""
    text = " ".join((inspect.getdoc(what) or "").split("\n\n")[0].split())
    text = re.sub(r":\w+:`~?([^`]*)`|``(.*?)``", lambda m: m[1] or m[2], text)
    return re.split(r"(?<=[.:;])\s", text)[0].rstrip(".:;")


def row(name: str, said: str, formula: str = "") -> str:
    math = latex2mathml.converter.convert(formula) if formula else ""
    return f"<p><b>{html.escape(name)}</b> {math} {html.escape(said)}</p>"


def block(title: str, rows: Iterable[str]) -> str:
    return f"<section><h2>{title}</h2>{''.join(rows)}</section>"


def verbs(kind: type, names: Iterable[str], before: str) -> Iterator[str]:
    for name in names:
        member: Any = getattr(kind, name)
        yield row(f"{before}.{name}", summary(member))


def functions() -> Iterator[str]:
    for name, one in FUNCTIONS.items():
        if name in vars(Functions):
            method = getattr(Functions, name)
            taken = list(inspect.signature(method).parameters.values())[1:]
            places = ", ".join(x.name for x in taken if x.kind is not x.KEYWORD_ONLY)
            yield row(f"{name}({places})", one.about, FORMULAS.get(name, ""))


def family(module: str) -> Iterator[str]:
    for name, member in cd._members(module).items():
        yield row(f"cd.{name}", summary(member))


def public() -> Iterator[str]:
    """What stands in cardan itself, without families, errors and results."""
    for name in cd._PUBLIC:
        value = getattr(cd, name)
        if not (inspect.isclass(value) and issubclass(value, Exception | Warning)):
            said = "the time, for expressions" if name == "t" else summary(value)
            yield row(f"cd.{name}", said)


def sheet() -> str:
    """The text of the sheet."""
    first = [
        block("From a scene to a motion", [f"<pre>{html.escape(START)}</pre>"]),
        block("Names of cardan", public()),
        block("scene", verbs(cd.Scene, SCENE, "scene")),
        block("Joints", family("elements.joints")),
        block("Forces", family("elements.forces")),
        block("equations", verbs(cd.Equations, EQUATIONS, "equations")),
    ]
    second = [
        block("Functions of a model, over any number of states", functions()),
        block("Analyses of a model", verbs(cd.CompiledModel, VERBS, "model")),
        block("motion", verbs(cd.Trajectory, MOTION, "motion")),
        block("simulate(method=)", (row(n, m.applies) for n, m in INTEGRATORS.items())),
    ]
    pages = "".join(f"<main>{''.join(page)}</main>" for page in (first, second))
    head = f'<meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>cardan: cheat sheet</title><style>{STYLE}</style>'
    return f'<!DOCTYPE html><html lang="en"><head>{head}</head><body>{pages}</body></html>'


PRINT = ("--headless", "--no-sandbox", "--no-pdf-header-footer")
START = """scene = cd.Scene("arm", gravity=(0, 0, -9.81))
m = scene.parameter("m", 1.0, unit="kg")
inertia = cd.inertia.rod(m, 1, axis="z")
arm = scene.body("arm", m, (0, 0, -.5), inertia)
scene.joint("elbow", cd.Revolute("y"), scene.ground, arm)
equations = cd.derive(scene)  # M udot + h = f + tau
model = cd.compile(equations)  # C, checked
motion = model.simulate(10, q={"elbow": 1})
motion.plot()
motion.animate("page.html")"""

STYLE = """
@page { size: A4; margin: 7mm; }
body { font: 7.5pt/1.24 system-ui, sans-serif; color: #111; background: #fff; margin: 0; }
main { width: 196mm; height: 282mm; margin: 4mm auto; columns: 3; column-gap: 4mm; column-fill: auto;
  break-after: page; overflow: hidden; }
main:last-child { break-after: auto; }
h2 { font-size: 8.6pt; margin: 1.4mm 0 .6mm; color: #024; border-bottom: .3mm solid #024; break-after: avoid; }
p { margin: 0; padding: .15mm 0 .15mm 2.5mm; text-indent: -2.5mm; break-inside: avoid;
  border-bottom: .1mm solid #e4e4e4; }
b { font: 600 6.8pt/1.15 ui-monospace, monospace; color: #024; }
pre { font: 5.8pt/1.25 ui-monospace, monospace; margin: 0; white-space: pre-wrap; }
@media (max-width: 700px) { main { columns: 1; width: auto; height: auto; padding: 0 3mm; }
  body { font-size: 10pt; } b { font-size: 9pt; } pre { font-size: 8pt; } }
@media print { main { margin: 0; } }
"""


def write(path: Path) -> None:
    """Write the sheet, and as PDF where there is a browser."""
    path.write_text(sheet(), encoding="utf-8")
    program = browser()
    if program is not None:
        subprocess.run(
            [program, *PRINT, f"--print-to-pdf={path.with_suffix('.pdf')}", path.as_uri()],
            capture_output=True, timeout=120, check=True,
        )  # fmt: skip
