"""Names in the generated C are judged by value: what a name says, found out on another way."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd
from cardan import passes
from cardan.codegen.program.naming import ValueNames
from cardan.elements.flexible import HellingerReissner
from cardan.ir.function import Block, Function, Output
from cardan.ir.graph import Graph
from cardan.ir.interpreter import evaluate
from codegen.named_beam import beam
from codegen.named_values import Array, Judge, Values
from golden.scenes import EXAMPLES
from golden.scenes import scene_of as example
from table import each

Blocks = dict[str, Array]
TOLERANCE = 1e-9
# of the named values, those with an independent value at least
SHARE = 0.7
# example -> kinds of quantities that its names are judged by, at least
SCENES = {
    "01_double_pendulum": {"omega", "a", "M", "drive"},
    "02_robot_arm": {"omega", "alpha", "first_moment", "M", "drive"},
    "23_dual_spin": {"a", "drive", "udot"},
    "06_four_bar": {"G", "multiplier", "twist", "M", "udot"},
    "08_stewart_platform": {"G", "multiplier", "twist", "R", "origin_inertia"},
    "09_bicycle": {"G", "gamma", "multiplier", "twist", "R", "omega", "origin_inertia"},
    "10_rolling_disk": {"gamma", "multiplier", "R", "omega"},
    "07_andrews": {"G", "multiplier", "twist", "M", "drive"},
    "27_sliding_door": {"G", "multiplier", "M", "drive", "udot", "free_udot"},
}


def named(function: Function, blocks: Blocks) -> Values:
    """Values of everything that has a label or a hint in a function, as it is written."""
    function = passes.optimize(function).function
    graph, live = function.graph, set(function.live())
    names = [(i, n) for table in (graph.labels, graph.hints) for i, n in table.items() if i in live]
    output = Output("x", (len(names),), tuple(i for i, _ in names))
    whole = Function("names", graph, function.inputs, (output,))
    values = evaluate(whole, blocks)["x"]
    return {name: float(x) for (_, name), x in zip(reversed(names), reversed(values), strict=True)}


@each("name", SCENES)
def test_names_say_what_they_hold(name: str) -> None:
    """Of every scene nearly all that has a name; the numbers are printed."""
    path = next(path for path in EXAMPLES if path.stem == name)
    judge = Judge(cd.derive(example(path), rewrites=()))
    truth, judged, wrong, count = judge.values(), set(), [], 0
    names = named(judge.equations.function("forward_dynamics"), judge.blocks)
    for (owner, quantity), value in names.items():
        minus = quantity.startswith("minus_")
        key = (owner, quantity.removeprefix("minus_"))
        if key not in truth:
            continue
        expected = -truth[key] if minus else truth[key]
        count += 1
        judged.add(key[1].split("_")[0] if key[0] not in ("M", "free_udot") else key[0])
        if abs(value - expected) > TOLERANCE * max(1.0, abs(expected)) * 10:
            wrong.append((owner, quantity, value, expected))
    print(f"{name}: {count} of {len(names)} named values judged")
    assert not wrong
    assert SCENES[name] <= judged | {kind for kind in SCENES[name] if kind.split("_")[0] in judged}
    assert count >= SHARE * len(names)


def test_names_in_a_beam_say_what_they_hold() -> None:
    rng = np.random.default_rng(4)
    element = HellingerReissner()
    function = element.derived()["balance"]
    data = dict(zip(element.data(), rng.uniform(0.5, 2.0, len(element.data())), strict=True))
    q = rng.normal(size=14)
    q[:4] /= np.linalg.norm(q[:4])
    q[7:11] = q[:4] + rng.uniform(-0.5, 0.5, 4)
    q[7:11] /= np.linalg.norm(q[7:11])
    truth, count = beam(q, data), 0
    names = named(function, {"q": q, "p": np.array(list(data.values()))})
    for (owner, quantity), value in names.items():
        key = (owner, quantity.removeprefix("minus_"))
        if key in truth:
            count += 1
            expected = truth[key] if key[1] == quantity else -truth[key]
            assert value == pytest.approx(expected, rel=1e-10, abs=1e-10), quantity
    print(f"beam: {count} of {len(names)} named values judged")
    assert count >= SHARE * len(names)


def test_names_are_made_of_what_values_are_made_of() -> None:
    g = Graph()
    x, y, z = (g.var("q", k) for k in range(3))
    block = Block("q", ("arm.x", "arm.y", "lean"), ("",) * 3)
    sums, products = g.add(x, y), g.mul(x, z)
    said = {
        g.mul(x, y): "arm_x_times_y",
        products: "arm_x_times_lean",
        g.square(z): "lean_squared",
        g.square(sums): "sum_arm_x_plus_y_squared",
        g.div(x, products): "arm_x_per_product_arm_x_times_lean",
        g.sub(z, sums): "lean_minus_sum_arm_x_plus_y",
        g.apply("cos", z): "lean_cos",
        g.apply("sin", sums): "sin_of_arm_x_plus_y",
        g.mul(g.const(0.5), sums): "half_sum_arm_x_plus_y",
        g.add(z, g.const(0.75)): "lean_plus_c0p75",
    }
    function = Function("f", g, (block,), (Output("y", (len(said),), tuple(said)),))
    entries = dict(zip((x, y, z), block.entries, strict=True))
    names = ValueNames(
        function,
        function.live(),
        lambda i: (entries[i].replace(".", "_"), entries[i].partition(".")[0]),
    )
    assert {i: names.of(i) for i in said} == said
