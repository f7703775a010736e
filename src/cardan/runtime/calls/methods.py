"""Methods of a compiled model that call its functions, made from the rows of their table."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Sequence
from inspect import Parameter
from types import CodeType, FunctionType
from typing import Any, Literal, NamedTuple, TypeGuard

import numpy as np
from numpy.typing import ArrayLike

from ...arrays import Array
from ...errors import ArgumentError, brief
from ...schema.blocks import ARGUMENTS
from ...schema.functions import FUNCTIONS, ModelFunction
from ..models import wrenches as outside
from .evaluation import Evaluation, State
from .memory_order import into
from .objects import Key

Axes = Literal["ground", "frame"]
# values by the names of blocks, or of all arguments of a method
ByName = dict[str, Any]
GROUND = "ground"
# arguments that the C of a function knows nothing of
SPECIAL = ("in_", "wrenches", "parameters")
# function -> what its result goes through, and the arguments that this takes besides
AFTER = {
    "energy": ("_energy",),
    "rhs_jacobian": ("_three", "x"),
    "inertial_parameters": ("_by_name",),
    "reaction": (
        "_of_least_norm",
        "joint",
        "q",
        "u",
        "tau",
        "wrenches",
        "r",
        "z",
        "s",
        "t",
        "parameters",
    ),
}
# summaries begin with them as they are
SYMBOLS = {"udot", "tau", "h", "f", "g", "qdot", "lam", "phi", "p", "q", "d", "du"}
# arguments in this order after those that are required, blocks and what some methods have besides
OPTIONS = ("in_", "tau", "wrenches", "r", "z", "s", "t", "parameters", "out")
# of arguments that are not blocks: annotation, and what it is
HANDWRITTEN = {
    "formula": ("str", 'such as ``"x^2 + 0.1*hand.z"``'),
    "frame": ("str", "name of a frame"),
    "joint": ("str", "name of a joint, with motion, cut or fixed"),
    "in_": ("Axes", 'axes of the result, ``"ground"`` or ``"frame"``'),
    "events": ("State", ARGUMENTS["e"].text),
    "q1": ("State", ARGUMENTS["q"].text),
    "wrenches": ("Values | None", "frame -> (..., 6) at its origin: moment, force; ground axes"),
    "parameters": ("Values | None", "name -> value (...); by default those of the model"),
    "out": ("Array | None", "array that is filled and returned"),
}
TEXTS = {name: block.text for name, block in ARGUMENTS.items()}
TEXTS |= {name: text for name, (_, text) in HANDWRITTEN.items()}


class Energy(NamedTuple):
    """Kinetic, potential and total energy [J]; gravity's potential is 0 at the ground origin."""

    kinetic: Array
    potential: Array
    total: Array


def _parameters(row: ModelFunction) -> list[Parameter]:
    """Arguments of a method but ``self``."""
    names = row.call.split() or row.required
    order: Sequence[str] = OPTIONS
    if "x" in names:
        # as solvers hand them over
        names, order = ["t", "x"], ("r", "s", *OPTIONS)
    options = {*row.arguments, *row.also.split(), *(["wrenches"] if "wrench" in row.reads else [])}
    by_place, by_name = Parameter.POSITIONAL_OR_KEYWORD, Parameter.KEYWORD_ONLY
    needed = [row.of, *names] if row.of else names
    parameters = [Parameter(name, by_place, annotation=_annotation(name)) for name in needed]
    for name in dict.fromkeys(order):
        if name in options and name not in names:
            # nothing that is needed stands before the parameters of phi
            kind = by_place if not needed or (names[-1] == "x" and name == "r") else by_name
            default = {"in_": "ground", "t": 0.0}.get(name)
            parameters.append(Parameter(name, kind, default=default, annotation=_annotation(name)))
    return parameters


def _annotation(name: str) -> str:
    if name in HANDWRITTEN:
        return HANDWRITTEN[name][0]
    if name in ("t", "x"):
        return "ArrayLike"
    return "State | None" if ARGUMENTS[name].default else "State"


def _text(row: ModelFunction, names: Sequence[str]) -> str:
    """The docstring of a method."""
    summary = row.about
    if summary.split()[0].rstrip(":") not in SYMBOLS:
        summary = summary[0].upper() + summary[1:]
    lines = [f"\n    {name}: {TEXTS[name]}" for name in names]
    axes = ", ".join(["...", *row.shape.split()])
    result = f"({axes})" if row.returns == "Array" else f"{row.returns}, (...) each"
    parts = [f"{summary}.", row.text] if row.text else [f"{summary}."]
    parts += ["Args:" + "".join(lines), f"Returns:\n    {result} [{row.unit}]"]
    return "\n\n".join([*parts, *([f"Source: {row.source}"] if row.source else [])])


def method(row: ModelFunction) -> FunctionType:
    """The method that calls a function: as quick as one that is written out."""
    parameters = _parameters(row)
    by_place = [one for one in parameters if one.kind is Parameter.POSITIONAL_OR_KEYWORD]
    by_name = [one for one in parameters if one.kind is Parameter.KEYWORD_ONLY]
    names = [one.name for one in parameters]
    arguments = ast.arguments(
        posonlyargs=[],
        args=[ast.arg("self"), *(ast.arg(one.name) for one in by_place)],
        kwonlyargs=[ast.arg(one.name) for one in by_name],
        kw_defaults=[None] * len(by_name),
        defaults=[],
    )
    expression = ast.fix_missing_locations(ast.Expression(ast.Lambda(arguments, _body(row, names))))
    (code,) = filter(_is_code, compile(expression, __file__, "eval").co_consts)
    defaults = tuple(one.default for one in by_place if one.default is not Parameter.empty)
    function = FunctionType(
        code.replace(co_name=row.name, co_qualname=row.name), globals(), row.name, defaults
    )
    function.__kwdefaults__ = {one.name: one.default for one in by_name}
    function.__annotations__ = {one.name: one.annotation for one in parameters}
    function.__annotations__["return"] = row.returns
    function.__qualname__, function.__doc__ = f"CompiledModel.{row.name}", _text(row, names)
    return function


def _is_code(value: object) -> TypeGuard[CodeType]:
    return isinstance(value, CodeType)


def _body(row: ModelFunction, names: Sequence[str]) -> ast.expr:
    """Call the C where it knows all arguments that are used, else :func:`_general`."""
    renamed = row.renamed
    blocks: list[ast.expr] = [_name(renamed.get(block, block)) for block in row.arguments]
    none = ast.Constant(None)
    key = ast.Tuple([ast.Constant(row.name), _name(row.of) if row.of else none], ast.Load())
    out = _name("out") if "out" in names else none
    body: ast.expr
    if row.of:
        values = ast.Tuple(blocks, ast.Load())
        body = ast.Call(_of_model("_evaluate"), [key, values, none, out], [])
    else:
        quick = ast.Subscript(_of_model("_calls"), key, ast.Load())
        body = ast.Call(quick, [out, *blocks], [])
    usual: list[ast.expr] = [
        ast.Compare(_name(name), [ast.Is()], [_name("GROUND") if name == "in_" else none])
        for name in names
        if name in SPECIAL or (name == "tau" and name not in row.arguments)
    ]
    if usual:
        by_block, by_name = _dict(row.arguments, blocks), _dict(names, map(_name, names))
        general = ast.Call(_name("_general"), [_name("self"), key, by_block, by_name], [])
        test = usual[0] if len(usual) == 1 else ast.BoolOp(ast.And(), usual)
        body = ast.IfExp(test, body, general)
    if row.name in AFTER:
        function, *more = AFTER[row.name]
        body = ast.Call(_name(function), [_name("self"), body, *map(_name, more)], [])
    return body


def _name(name: str) -> ast.expr:
    return ast.Name(name, ast.Load())


def _of_model(name: str) -> ast.expr:
    return ast.Attribute(_name("self"), name, ast.Load())


def _dict(keys: Iterable[str], values: Iterable[ast.expr]) -> ast.expr:
    return ast.Dict([ast.Constant(key) for key in keys], [*values])


def _general(model: Evaluation, key: Key, blocks: ByName, call: ByName) -> Array:
    """Value of a function under external forces, in other axes, or with other parameters."""
    out, axes = call.get("out"), call.get("in_", GROUND)
    if call.get("wrenches") is not None or (key[0] == "rhs" and call["tau"] is not None):
        return into(PUSHED[key[0]](model, key, blocks, call), out)
    values = tuple(blocks.values())
    if isinstance(axes, str) and axes == GROUND:
        return model._evaluate(key, values, call["parameters"], out)
    return into(_in_its_axes(model, key, values, call), out)


def _in_its_axes(model: Evaluation, key: Key, values: tuple[object, ...], call: ByName) -> Array:
    """A 6-vector of a frame, or columns of them, in its axes."""
    if not isinstance(call["in_"], str) or call["in_"] != "frame":
        raise ArgumentError(f"in_ must be 'ground' or 'frame', not {brief(call['in_'])}")
    place = (call["t"], call["q"], call["r"])
    ground = model._evaluate(key, values, call["parameters"], None)
    axes = model._evaluate(("pose", key[1]), place, call["parameters"], None)[..., :3, :3]
    columns = 1 if FUNCTIONS[key[0]].shape == "6" else ground.shape[-1]
    pair = ground.reshape(*axes.shape[:-2], 2, 3, columns)
    result: Array = np.einsum("...ji,...kjc->...kic", axes, pair)
    return result.reshape(ground.shape)


# outer forces


def _generalized(model: Evaluation, call: ByName) -> Array:
    place = {name: call[name] for name in ("r", "t", "parameters")}
    return outside.generalized(model, call["wrenches"], call["q"], **place)


def _pushed_forward(model: Evaluation, key: Key, blocks: ByName, call: ByName) -> Array:
    tau, more = call["tau"], _generalized(model, call)
    tau = more if tau is None else model._vector("tau", tau) + more
    values = tuple((blocks | {"tau": tau}).values())
    return model._evaluate(key, values, call["parameters"], None)


def _pushed_inverse(model: Evaluation, key: Key, blocks: ByName, call: ByName) -> Array:
    tau = model._evaluate(key, tuple(blocks.values()), call["parameters"], None)
    return tau - _generalized(model, call)


def _pushed_rhs(model: Evaluation, key: Key, blocks: ByName, call: ByName) -> Array:
    """The C of rhs knows no outer forces: udot again, with them."""
    q, u, z = model.parts_of(call["x"])
    again = call | {"q": q, "u": u, "z": z, "out": None}
    forward = {name: again[name] for name in FUNCTIONS["forward_dynamics"].arguments}
    udot = _general(model, ("forward_dynamics", None), forward, again)
    rates = model._evaluate(key, tuple(blocks.values()), call["parameters"], None)
    lead = np.broadcast_shapes(rates.shape[:-1], udot.shape[:-1])
    result: Array = np.array(np.broadcast_to(rates, (*lead, rates.shape[-1])))
    result[..., q.shape[-1] : q.shape[-1] + udot.shape[-1]] = udot
    return result


def _pushed_reaction(model: Evaluation, key: Key, blocks: ByName, call: ByName) -> Array:
    outside.refuse_ground(model, call["wrenches"], call["joint"])
    place = {name: call[name] for name in ("r", "t", "parameters")}
    if model.manifest.absolute:
        # elements know nothing of outer wrenches: a body moves under them, and its joint bears them
        direct = outside.outboard(model, call["wrenches"], call["joint"], call["q"], **place)
        tau, more = call["tau"], _generalized(model, call)
        tau = more if tau is None else model._vector("tau", tau) + more
        values = tuple((blocks | {"tau": tau, "wrench": None}).values())
        return model._evaluate(key, values, call["parameters"], None) - direct
    wrench = outside.by_part(model, call["wrenches"], call["q"], **place)
    values = tuple((blocks | {"wrench": wrench}).values())
    return model._evaluate(key, values, call["parameters"], None)


PUSHED = {
    "rhs": _pushed_rhs,
    "forward_dynamics": _pushed_forward,
    "inverse_dynamics": _pushed_inverse,
    "reaction": _pushed_reaction,
}

# what methods hand on in other forms


def _energy(model: Evaluation, result: Array) -> Energy:
    return Energy(*(result[..., k][()] for k in range(3)))


def _three(model: Evaluation, result: Array, x: ArrayLike) -> tuple[Array, Array, Array]:
    lead, n = result.shape[:-1], np.shape(x)[-1]
    end = n * n
    by_x = result[..., :end].reshape(*lead, n, n)
    by_r = result[..., end + n :]
    by_r = by_r.reshape(*lead, n, by_r.shape[-1] // max(n, 1))
    return by_x, result[..., end : end + n], by_r


def _by_name(model: Evaluation, result: Array) -> dict[str, Any]:
    names = model._function("inertial_parameters").outputs[0].entries or []
    if result.ndim == 1:
        return dict(zip(names, result, strict=True))
    return {name: result[..., k] for k, name in enumerate(names)}


def _of_least_norm(
    model: Evaluation,
    result: Array,
    joint: str,
    q: State,
    u: State,
    tau: State | None,
    wrenches: Any,
    *more: Any,
) -> Array:
    """A reaction; where redundant constraints leave it open that of least norm, said once."""
    if not (model.manifest.multipliers or model.manifest.cuts):
        return result
    r, z, s, t, parameters = more
    undetermined = model._undetermined(joint, result.shape[:-1], q, t, r, parameters)
    if undetermined is None:
        return result
    call = {"q": q, "u": u, "tau": tau, "wrenches": wrenches, "r": r, "z": z, "s": s, "t": t}
    blocks = {name: call.get(name) for name in FUNCTIONS["reaction"].arguments}
    reactions = {joint: result}
    for name in undetermined.joints:
        if name != joint:
            every = call | {"parameters": parameters, "joint": name}
            reactions[name] = _general(model, ("reaction", name), blocks, every)
    return into(undetermined.least(reactions), result)
