"""Functions to write in C: random ones of every operator, and small ones with a point."""

from __future__ import annotations

import random

from cardan.ir.function import Block, Function, Output
from cardan.ir.graph import Graph
from cardan.ir.table import Table

# what leaves every number what IEEE arithmetic makes of it: C and Python agree to the bit
EXACT = "add add sub sub mul mul div neg sqrt abs sign min max floor lt le eq and or not select"
# the mathematical library answers these
LIBRARY = "sin cos tan asin acos atan atan2 exp log sinh cosh tanh asinh acosh atanh pow"
TABLE = Table((-2.0, -0.5, 0.25, 3.0), ((1.0, -2.0, 0.5), (0.3, 0.1, 1.0), (-0.2, 0.0, 0.4)))
SIZES = {"q": 4, "u": 3, "p": 5}


def blocks() -> tuple[Block, ...]:
    """Input blocks q, u and p with names and units."""
    return tuple(
        Block(name, tuple(f"{name}.{k}" for k in range(n)), ("m",) * n) for name, n in SIZES.items()
    )


def values(seed: int) -> dict[str, list[float]]:
    """Random values for them."""
    rng = random.Random(f"values {seed}")
    return {name: [rng.uniform(-2, 2) for _ in range(n)] for name, n in SIZES.items()}


def apply(g: Graph, op: str, *x: int) -> int:
    """An operator inside its domain, whatever the operands."""
    if op in ("div", "log", "sqrt"):
        # away from zero
        x = (*x[:-1], g.add(g.apply("abs", x[-1]), g.const(0.5)))
    if op in ("asin", "acos", "atanh"):
        x = (g.div(x[0], g.add(g.apply("abs", x[0]), g.const(1.5))),)
    if op in ("exp", "sinh", "cosh", "tanh", "tan"):
        x = (g.div(x[0], g.add(g.apply("abs", x[0]), g.const(1.0))),)
    if op == "acosh":
        x = (g.add(g.apply("abs", x[0]), g.const(1.5)),)
    if op == "pow":
        x = (g.add(g.apply("abs", x[0]), g.const(0.5)), g.apply("sin", x[1]))
    if op == "stumpff":
        return g.apply("stumpff", g.const(float(x[0] % 6)), x[1])
    if op == "table":
        return g.interpolate(TABLE, x[1], x[0] % 3)
    return g.apply(op, *x)


ARITY = dict.fromkeys(
    [
        "add",
        "sub",
        "mul",
        "div",
        "min",
        "max",
        "lt",
        "le",
        "eq",
        "and",
        "or",
        "atan2",
        "pow",
        "stumpff",
        "table",
    ],
    2,
)


def random_function(seed: int, size: int = 120, operators: str = EXACT) -> Function:
    """A function of q, u and p with random expressions, labels, owners and shared nodes."""
    rng = random.Random(f"function {seed}")
    g = Graph()
    pool = [g.var(name, k) for name, n in SIZES.items() for k in range(n)]
    pool += [g.const(c) for c in (0.5, -2.0, 3.0, 1e-3)]
    owners = ("base", "arm", "hand")
    names = operators.split()
    for k in range(size):
        with g.made_by(rng.choice(owners), rng.choice(("force", "omega_x", ""))):
            op = rng.choice(names)
            arity = 3 if op == "select" else ARITY.get(op, 1)
            # mostly of late values, so that expressions grow deep
            operands = [
                rng.choice(pool[-12:] if rng.random() < 0.7 else pool) for _ in range(arity)
            ]
            pool.append(apply(g, op, *operands))
        if rng.random() < 0.15:
            g.label(pool[-1], rng.choice(owners), f"value_{k % 5}")
    roots = [rng.choice(pool) for _ in range(5)] + pool[-4:] + [g.const(0.25), g.var("q", 0)]
    outputs = (
        Output("first", (3,), tuple(roots[:3]), ("a", "b", "c"), ("m", "", "N")),
        Output("second", (2, (len(roots) - 3) // 2), tuple(roots[3:])),
    )
    return Function("random", g, blocks(), outputs, owners, f"a random function, number {seed}")


def solving(kind: str, n: int = 4, m: int = 2, of: str = "q") -> Function:
    """X of a linear system whose entries come from input ``of``, and the sum of X."""
    g = Graph()
    size = n * n + n * m
    entries = [g.var(of, k) for k in range(size)]
    node = g.intern(("solve", kind, n, m, *entries))
    items = [g.intern(("item", node, k)) for k in range(n * m)]
    total = items[0]
    for item in items[1:]:
        total = g.add(total, item)
    block = Block(of, tuple(f"e{k}" for k in range(size)), ("",) * size)
    outputs = (Output("x", (n, m), tuple(items)), Output("total", (), (total,)))
    return Function("solving", g, (block,), outputs)
