"""Axes of the bodies of a system, for vectors with parts in them."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING, NoReturn, TypeAlias

import numpy as np

from ...arrays import Array
from ...errors import ArgumentError, DerivationError, brief, near
from ...ir.arithmetic import Scalar, sqrt
from ...ir.derivative import forward
from ...ir.function import Function, Output, live
from ...ir.interpreter import evaluate
from ...ir.matrix import Matrix
from ...topology.system import GROUND
from ..finite_elements.record import FiniteElementRecord
from ..functions.blocks import blocks, defaults, symbols
from ..kinematics import paths
from ..kinematics.kinematics import Kinematics
from ..record import EquationRecord

if TYPE_CHECKING:
    import sympy

    from ...scene.frame import Located


Place: TypeAlias = "Located | str"


class MovingAxes:
    """Bodies that turn against each other, in the frames and numbers of the user.

    Args:
        equations: Of the system.

    Attributes:
        blocks: Input blocks that the components read, by letter.
        symbols: SymPy symbol of every entry of theirs.

    Raises:
        DerivationError: nodes that stay in a plane have other coordinates than in space.
    """

    def __init__(self, equations: EquationRecord | FiniteElementRecord) -> None:
        self.equations, self.system = equations, equations.system
        self.name = self.system.name
        chosen = equations.chosen if isinstance(equations, EquationRecord) else ()
        self.k = Kinematics(self.system, chosen)
        self.blocks = blocks(self.system, tuple(speed.name for speed in chosen))
        self.symbols = symbols(self.blocks)
        missing = sorted({*self.blocks["q"].entries} - {*equations.coordinates})
        if missing:
            raise DerivationError(
                f"'{self.name}': its nodes stay in a plane and have the coordinates x, y and angle "
                f"there, not '{missing[0]}'. Vectors need nodes in space: derive with plane=None"
            )
        self.frames = {frame.name: n for n, frame in enumerate(self.system.frames)}

    # bodies and frames

    def frame(self, frame: Place) -> int:
        """Number of a frame."""
        name = frame if isinstance(frame, str) else frame.name
        if name not in self.frames:
            raise ArgumentError(
                f"'{self.name}' has no frame or body '{name}'.{near(name, self.frames)}"
            )
        return self.frames[name]

    def body_of(self, frame: Place) -> int:
        """Body of the system that a frame is fixed to."""
        return self.system.frames[self.frame(frame)].body

    def body(self, body: int) -> str:
        """Name of a body."""
        return "ground" if body == GROUND else self.k.owner(body)

    # motion

    def rotated(self, x: Matrix, start: int, end: int) -> Matrix:
        """Vectors in axes of a body (3, n), in those of another."""
        return x if start == end else paths.body_to_body(self.k, x, start, end)

    def in_frame(self, x: Matrix, body: int, frame: Place) -> Matrix:
        """Vectors in axes of a body (3, n), in those of a frame."""
        number = self.frame(frame)
        aligned = self.rotated(x, body, self.system.frames[number].body)
        return paths.frame_axes(self.k, number).T @ aligned

    def angular_velocity(self, body: int, observer: int) -> dict[int, Matrix]:
        """Angular velocity of a body as seen from another: what each joint between adds.

        ``angular_velocity = sum of the S_w u of the joints from the observer to the body``.
        """
        top = paths.common_ancestor(self.k, body, observer)
        there, back = self.path(body, top), self.path(observer, top)
        angular = {i: self.k.joints[i].velocity.block(slice(0, 3)) for i in (*there, *back)}
        return {i: -omega if i in back else omega for i, omega in angular.items()}

    def spin(self, body: int, observer: int) -> Matrix:
        """The same in axes of the body (3, 1)."""
        total = Matrix.zeros(self.k.graph, 3)
        for i, omega in self.angular_velocity(body, observer).items():
            total = total + self.rotated(omega, i, body)
        return total

    def path(self, body: int, top: int = GROUND) -> list[int]:
        """Bodies from one that carries a body to the body itself, without the first."""
        bodies = list[int]()
        while body != top:
            bodies.append(body)
            body = self.system.bodies[body].parent
        return bodies[::-1]

    @cached_property
    def _speed_rates(self) -> dict[int, int]:
        g = self.k.graph
        return {g.var("u", i): g.var("udot", i) for i in range(self.system.nu)}

    def derivative(self, x: Matrix) -> Matrix:
        """Entry by entry time derivative: at udot = 0, and what udot adds.

        Raises:
            DerivationError: of an entry that depends on something without a derivative.
        """
        g, seeds = self.k.graph, self.k.time_seeds
        for i in live(g, x.nodes):
            op, *at = g.nodes[i]
            if op == "var" and at[0] != "p" and i not in seeds and i not in self._speed_rates:
                self._refuse(at[0], at[1])
        # loops that are solved know the derivatives of their rates at udot = 0 only
        nodes = forward(g, x.nodes, seeds, "rate"), forward(g, x.nodes, self._speed_rates)
        drift, added = (Matrix(g, x.rows, x.columns, part) for part in nodes)
        return drift + added

    def _refuse(self, letter: str, entry: int) -> NoReturn:
        cures = {
            "udot": "equations of motion end with accelerations: differentiate fewer times",
            "r": "inputs have rates where they prescribe a joint: use it in prescribed=",
        }
        cure = cures.get(letter, "use coordinates, speeds and t")
        name = self.symbols[letter, entry].name
        raise DerivationError(
            f"a vector of '{self.name}' depends on '{name}', whose time derivative does not exist "
            f"here; {cure}"
        )

    # expressions and numbers

    def scalar(self, factor: sympy.Expr | float) -> Scalar:
        """A number, or a SymPy expression in the names of the equations.

        Raises:
            ArgumentError: neither; text, which SymPy would run as Python, is none.
        """
        import sympy

        from ...ir.forms.sympy_bridge import from_sympy

        nodes = {symbol: self.k.graph.var(*key) for key, symbol in self.symbols.items()}
        try:
            expression = sympy.sympify(factor, strict=True)
        except sympy.SympifyError:
            raise ArgumentError(
                f"a factor of a vector is a number or a SymPy expression, not {brief(factor)}"
            ) from None
        return Scalar(self.k.graph, from_sympy(self.k.graph, expression, nodes))

    def written(self, x: Matrix | Scalar) -> sympy.Matrix:
        """A SymPy matrix, or an expression for a Scalar, in readable form.

        Raises:
            DerivationError: it is too long to be written out.
        """
        from ...ir.forms.readable import TooLong, readable

        try:
            return readable(x, self.symbols)
        except TooLong as problem:
            raise DerivationError(
                f"a component has {problem.operations:,} operations: too long to write out. "
                "Express the vector in a frame that is nearer to what it describes, or take its "
                "numbers with .evaluate(q, u)"
            ) from problem

    def root(self, x: Scalar) -> sympy.Expr:
        """Square root of what is never negative."""
        return self.written(sqrt(x))

    def text(self, x: Matrix) -> str:
        """Components in one line; their operations where they are too long."""
        from ...ir.forms.readable import TooLong, readable

        try:
            return f"[{', '.join(str(entry) for entry in readable(x, self.symbols))}]"
        except TooLong as problem:
            return f"[{problem.operations:,} operations]"

    def values(
        self, x: Matrix, state: Mapping[str, object], parameters: Mapping[str, float]
    ) -> Array:
        """Entries of a matrix (..., rows, columns) at states."""
        values: dict[str, object] = dict(defaults(self.system))
        values |= {
            letter: self._read(letter, block)
            for letter, block in state.items()
            if block is not None
        }
        names = self.equations.parameters
        p = np.array(values["p"])
        for name, value in parameters.items():
            if name not in names:
                raise ArgumentError(f"no parameter '{name}'.{near(name, names)}")
            p[names.index(name)] = value
        output = Output("components", (x.rows, x.columns), x.nodes)
        inputs = tuple(self.blocks.values())
        function = Function("components", self.k.graph, inputs, (output,))
        try:
            result = evaluate(function, values | {"p": p}, "numpy")["components"]
        except ValueError as problem:
            raise ArgumentError(f"components of a vector of '{self.name}': {problem}") from None
        return np.asarray(result)

    def _read(self, letter: str, block: object) -> Array:
        """The entries of a block that components read: nodes inside of beams have none."""
        values = np.asarray(block, dtype=float)
        if letter not in ("q", "u", "udot"):
            return values
        every = self.equations.coordinates if letter == "q" else self.equations.speeds
        if values.shape[-1:] != (len(every),):
            raise ArgumentError(
                f"'{self.name}': {letter} has shape {values.shape}, expected (..., {len(every)})"
            )
        names = self.blocks["q" if letter == "q" else "u"].entries
        return values[..., [every.index(name) for name in names]]
