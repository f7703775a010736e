"""Equations that a user derived with SymPy's mechanics package, as a model.

Coordinates and speeds become one block that moves no body; see
:mod:`cardan.elements.external_equations`.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from ...arguments import checked
from ...errors import ModelError, brief

if TYPE_CHECKING:
    import sympy

    from ..scene import SceneRecord

__all__ = ["from_sympy"]


@checked
def from_sympy(
    equations: object,
    outputs: Mapping[str, sympy.Expr] | None = None,
    parameters: Mapping[sympy.Expr, float] | None = None,
    inputs: Mapping[sympy.Expr, float] | None = None,
    potential: sympy.Expr | None = None,
    name: str = "equations",
) -> SceneRecord:
    """A model of equations of motion that were derived with SymPy.

    Args:
        equations: ``KanesMethod`` or ``LagrangesMethod`` whose equations are formed, a ``System``
            of ``sympy.physics.mechanics``; ``(q, u, M, f)`` of M u' = f, q' = u;
            ``(q, u, kinematics, M, f)`` with q' as expressions; the same with constraints behind,
            a list or a dict by name of expressions that are kept at 0; or what
            ``equations.to_sympy()`` returns. A speed may be the derivative of a coordinate; it is
            called ``<coordinate>.u`` then.
        outputs: Name -> expression to be computed along with the motion.
        parameters: Symbol or its name -> default value, of every symbol but the time.
        inputs: Function of time or its name -> default value, where that is not 0. Functions of
            time that are neither coordinates nor speeds are inputs; a derivative of one is another,
            ``<input>.rate`` or ``<input>.acceleration``.
        potential: Potential energy [J] as an expression of coordinates and parameters, where M is
            the mass matrix: gives the model its ``energy``. A Lagrangian tells it by itself.
        name: Of the model.

    Returns:
        The model, to be compiled like any other; functions of bodies and frames it has none.

    Raises:
        ModelError: no such form, unknown functions, symbols without a value, names given twice,
            accelerations outside of M u', constraints that contradict, texts for expressions.

    Source: T. R. Kane and D. A. Levinson, Dynamics: Theory and Applications, 1985, chapter 6.
    """
    from .construction import build_scene

    arguments = {"equations": equations, "outputs": outputs, "potential": potential}
    for what, value in arguments.items():
        try:
            _refuse_texts(what, value)
        except RecursionError as problem:
            raise ModelError(f"from_sympy: {what}: lists in lists without end") from problem
    named = (
        ("outputs", outputs, "expressions by name, such as {'height': z}"),
        ("parameters", parameters, "values by symbol or name, such as {'m': 1.0}"),
        ("inputs", inputs, "values by symbol or name, such as {'m': 1.0}"),
    )
    for what, table, expected in named:
        if table is not None and not isinstance(table, Mapping):
            raise ModelError(f"from_sympy: {what}={brief(table)}: give {expected}")
    return build_scene(equations, outputs or {}, parameters or {}, inputs or {}, potential, name)


def _refuse_texts(what: str, expression: object) -> None:
    """Refuse a text where an expression belongs: SymPy would run it as Python.

    Args:
        what: Argument, for the message.
        expression: An expression; lists, arrays and dicts of some, whose keys may be texts.

    Raises:
        ModelError: there is a text.
    """
    if isinstance(expression, (str, bytes)):
        raise ModelError(
            f"from_sympy: {what}: {expression[:40]!r} is a text, which is not run as an "
            "expression; give one of SymPy, such as sympy.Symbol('m')"
        )
    if isinstance(expression, Mapping):
        for key, value in expression.items():
            _refuse_texts(f"{what}[{str(key)[:40]!r}]", value)
    elif type(expression).__name__ == "ndarray":
        _refuse_texts(what, expression.tolist())  # type: ignore[attr-defined]
    elif isinstance(expression, (list, tuple, set, frozenset)):
        for value in expression:
            _refuse_texts(what, value)
