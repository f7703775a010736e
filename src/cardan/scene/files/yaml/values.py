"""Values of a scene file, by kind: what stands there becomes what Python would be given."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from ....elements.material import material
from ....elements.tables import Interpolation
from ....errors import near
from ....spatial.numbers import check_axes, check_orthonormal
from ...beam import Beam
from ...body import INERTIA_ENTRIES
from ...frame import Place
from ...masses import member
from ...scene import SceneRecord
from ..angles import snap
from ..expression import parse
from ..meshes import Meshes
from . import keys
from .item import Item
from .keys import Key
from .scope import FIXED, Names, Scope


class Values:
    """Reads values; every method is a kind of :class:`.keys.Key`.

    Attributes:
        model: The model being built: names in places and expressions are its own.
        version: Of the format of the file.
        scope: What expressions may speak of in the present section.
        tables: Measured functions by name.
        frames: Frames made inside a value, by the node: an alias means the same frame.
    """

    def __init__(self, model: SceneRecord, meshes: Meshes, snap: bool, version: int) -> None:
        self.model = model
        self.version = version
        self.meshes = meshes
        self.snap = snap
        self.tables: dict[str, Interpolation] = {}
        self.scope = FIXED
        self.local: tuple[str, ...] = ()
        self.frames: dict[int, Place] = {}

    def read(self, key: Key, item: Item) -> Any:
        """The value of a key."""
        return getattr(self, key.kind)(item)

    def record(self, key_table: Sequence[Key], item: Item, what: str) -> dict[str, Any]:
        """The values of a mapping with known keys, as arguments."""
        items = item.fields(key_table, what)
        # in the order of the keys: names of own coordinates come before expressions of them
        return {key.name: self.read(key, items[key.name]) for key in key_table if key.name in items}

    # numbers and expressions

    def value(self, item: Item) -> Any:
        """A number, an expression or rows of them."""
        if item.is_list:
            return tuple(self.value(entry) for entry in item.entries())
        return self.scalar(item)

    def scalar(self, item: Item) -> Any:
        """A number or an expression."""
        number = item.number()
        return self._expression(item, self.scope) if number is None else number

    def _expression(self, item: Item, scope: Scope) -> Any:
        names = Names(self.model, scope, self.tables, self.local, item.where, self.version)
        text = item.text()
        expression = parse(text, names, where=item.where)
        if expression.free_symbols:
            return expression
        if not expression.is_number or not expression.is_extended_real or not expression.is_finite:
            raise item.error(f"'{text[:60]}' is not a finite number")
        return int(expression) if expression.is_Integer else float(expression)

    def law(self, item: Item) -> Any:
        """An expression in anything that moves."""
        number = item.number()
        return self._expression(item, Scope.MOVING) if number is None else number

    def motion(self, item: Item) -> Any:
        """An expression in t, inputs and parameters; several in order, null for none."""
        if item.is_list:
            return tuple(None if x.is_null else self.motion(x) for x in item.entries())
        number = item.number()
        return self._expression(item, Scope.DRIVEN) if number is None else number

    def real(self, item: Item) -> int | float:
        """A number; arithmetic of numbers is one too.

        Raises:
            ModelError: it depends on a name.
        """
        number = item.number()
        if number is None:
            number = self._expression(item, Scope.NUMBERS)
        return number

    def numbers(self, item: Item) -> Any:
        """A number or a list of them."""
        return self.column(item) if item.is_list else self.real(item)

    times = numbers

    def column(self, item: Item) -> tuple[int | float, ...]:
        return tuple(self.real(entry) for entry in item.entries("a list of numbers"))

    def reals(self, item: Item) -> dict[str, int | float]:
        """Numbers by name."""
        return {name: self.real(entry) for name, entry in item.items("numbers by name").items()}

    def initial(self, item: Item) -> dict[str, Any]:
        """A number or several by name."""
        return {name: self.numbers(entry) for name, entry in item.items("numbers by name").items()}

    def signals(self, item: Item) -> dict[str, Any]:
        """Constants, or times and values, by the names of inputs."""
        return {
            name: tuple(self.column(column) for column in entry.entries())
            if entry.is_list
            else self.real(entry)
            for name, entry in item.items("signals by name").items()
        }

    def count(self, item: Item) -> int:
        """An integer."""
        number = self.real(item)
        if not isinstance(number, int):
            raise item.error(f"an integer is wanted, not {item.description()}")
        return number

    def bound(self, item: Item) -> float | None:
        """A limit: a number, ``.inf``, ``-.inf``, or null for none."""
        if item.is_null:
            return None
        if item.is_text and item.text() in (".inf", "-.inf"):
            return -math.inf if item.text()[0] == "-" else math.inf
        return self.real(item)

    def vector(self, item: Item) -> tuple[Any, ...]:
        """Three numbers or expressions."""
        return tuple(self.scalar(entry) for entry in item.three())

    # words

    def text(self, item: Item) -> str:
        return item.text()

    def texts(self, item: Item) -> list[str]:
        return [entry.text() for entry in item.entries("a list of texts")]

    def names(self, item: Item) -> tuple[str, ...]:
        """Names of own coordinates; the expressions beside them may have them."""
        self.local = tuple(self.texts(item))
        return self.local

    def labels(self, item: Item) -> str | dict[str, str]:
        """A text, or texts by name."""
        if item.is_text:
            return item.text()
        return {name: entry.text() for name, entry in item.items("a text or texts").items()}

    def curves(self, item: Item) -> dict[str, Interpolation]:
        """Tables of the scene by direction."""
        curves = {}
        for name, entry in item.items("tables by direction").items():
            if entry.text() not in self.tables:
                listed = near(entry.text(), self.tables).replace(" Known:", " Tables:")
                raise entry.error(f"there is no table '{entry.text()[:80]}'.{listed}")
            curves[name] = self.tables[entry.text()]
        return curves

    def flag(self, item: Item) -> bool:
        if not item.is_text or item.text() not in ("true", "false"):
            raise item.error(f"true or false is wanted, not {item.description()}")
        return item.text() == "true"

    def direction(self, item: Item) -> Any:
        """``x``, ``-z`` or three numbers or expressions."""
        return item.text() if item.is_text else self.vector(item)

    # places

    def place(self, item: Item) -> Place:
        """A body or frame by its name, or a frame made here: ``{body:, at:, rotation:}``."""
        if item.is_text:
            with item.at_item():
                return self.model.place(item.path, item.text())
        frame = self.frames.get(id(item.node))
        if frame is None:
            frame = self.frames[id(item.node)] = self.frame(item, None)
        return frame

    def has_place(self, item: Item) -> bool:
        """True where the body or frame of a place is there by now."""
        if not item.is_text:
            body = item.items("a frame such as {body: ...}").get("body")
            return body is not None and body.is_text and self.has_place(body)
        places = (self.model.bodies, self.model.nodes, self.model.frames)
        return item.text() == "ground" or any(item.text() in named for named in places)

    def places(self, item: Item) -> dict[str, Place]:
        """Frames or bodies by name."""
        return {name: self.place(entry) for name, entry in item.items("places by name").items()}

    def members(self, item: Item) -> tuple[Place | Beam, ...]:
        """A body or a beam by its name, or several."""
        entries = item.entries() if item.is_list else [item]
        return tuple(self._member(entry) for entry in entries)

    def _member(self, item: Item) -> Place | Beam:
        if not item.is_text:
            return self.place(item)
        with item.at_item():
            return member(self.model, item.path, item.text())

    def frame(self, item: Item, name: str | None) -> Place:
        """A frame on a body, or placed from another frame."""
        arguments = self.record(keys.FRAME, item, "a frame")
        with item.at_item():
            base = self.model.place(item.path, arguments["body"], "body")
            at, rotation = arguments.get("at", (0, 0, 0)), arguments.get("rotation")
            return base.at(*at, rotation=rotation, name=name)

    def rotation(self, item: Item) -> Any:
        """``[XYZ, a, b, c]`` or 3x3."""
        entries = item.entries("a rotation, [XYZ, a, b, c] or 3x3,")
        if len(entries) == 4 and entries[0].is_text:
            with entries[0].at_item():
                check_axes(entries[0].text(), entries[0].path)
            return (entries[0].text(), *(self._angle(entry) for entry in entries[1:]))
        rows = tuple(self.vector(entry) for entry in entries)
        if len(rows) != 3:
            raise item.error("a rotation is [XYZ, a, b, c] or 3x3")
        if all(isinstance(entry, (int, float)) for row in rows for entry in row):
            with item.at_item():
                check_orthonormal([[float(x) for x in row] for row in rows], item.path)
        return rows

    def _angle(self, item: Item) -> Any:
        """An angle; a printed rounding of a quarter turn becomes exact."""
        number = item.number()
        if number is None or not self.snap:
            return self.value(item)
        return snap(item.text(), number, item.path, self.model.snaps)

    def pose(self, item: Item) -> tuple[Any, str | None]:
        """A pose as :meth:`Model.body` takes it, and the body in whose axes it is given."""
        if not item.is_list:
            values = self.record(keys.POSE, item, "a pose")
            return (values["position"], values.get("rotation")), values.get("base")
        entries = item.entries()
        if len(entries) == 2:
            return (self.vector(entries[0]), self.rotation(entries[1])), None
        if len(entries) == 4:
            return tuple(tuple(map(self.scalar, row.entries())) for row in entries), None
        return self.vector(item), None

    # what bodies and joints have

    def inertia(self, item: Item) -> Any:
        """3x3, three principal values, entries by name, or the inertia of a solid."""
        if item.is_list:
            return self.value(item)
        items = item.items("an inertia")
        solids = [name for name in items if name in keys.INERTIAS]
        if solids:
            name = solids[0]
            if len(items) > 1:
                raise item.error(f"'{name}' stands alone; move the other keys into it")
            function = keys.INERTIAS[name]
            arguments = self.record(keys.of_function(function), items[name], f"a {name}")
            with items[name].at_item(named=True):
                return function(**arguments)
        for name, entry in items.items():
            if name not in INERTIA_ENTRIES:
                names = [*INERTIA_ENTRIES, *keys.INERTIAS]
                raise entry.at_key(f"an inertia has no key '{name[:80]}'." + near(name, names))
        return {name: self.scalar(entry) for name, entry in items.items()}

    def shapes(self, item: Item) -> list[Any]:
        """One shape or a list of them: ``{cylinder: {radius:, length:}}``."""
        return [self._shape(entry) for entry in (item.entries() if item.is_list else [item])]

    def _shape(self, item: Item) -> Any:
        items = item.items("a shape such as {sphere: {radius: ...}}")
        if len(items) != 1:
            raise item.error("a shape has one key, its kind" + near("", keys.SHAPES))
        ((name, entry),) = items.items()
        function = keys.SHAPES.get(name)
        if function is None:
            raise entry.at_key(f"shape '{name[:80]}' does not exist." + near(name, keys.SHAPES))
        arguments = self.record(keys.of_function(function), entry, f"a {name}")
        with entry.at_item(named=True):
            return function(**arguments)

    # what beams have

    def end(self, item: Item) -> Any:
        """A frame, or three numbers or expressions."""
        return self.vector(item) if item.is_list else self.place(item)

    def section(self, item: Item) -> Any:
        """A cross-section: ``{tube: {outer:, inner:}}``."""
        return self._chosen("section", item)

    def line(self, item: Item) -> Any:
        """A centerline: ``{arc: {center:}}``."""
        return self._chosen("line", item)

    def _chosen(self, what: str, item: Item) -> Any:
        """A member of a family by its kind."""
        family = keys.CHOICES[what]
        items = item.items(f"a {what} such as {{{next(iter(family))}: {{...}}}}")
        if len(items) != 1:
            raise item.error(f"a {what} has one key, its kind." + near("", family))
        ((name, entry),) = items.items()
        if name not in family:
            raise entry.at_key(f"{what} '{name[:80]}' does not exist." + near(name, family))
        arguments = self.record(keys.of_element(family[name]), entry, f"a {name}")
        with entry.at_item(named=True):
            return family[name](**arguments)

    def material(self, item: Item) -> Any:
        """``{E:, nu:, rho:}``."""
        values = self.record(keys.MATERIAL, item, "a material")
        with item.at_item(named=True):
            return material(**values)

    # what superelements are made of

    def matrices(self, item: Item) -> Item:
        """What :mod:`.superelements` reads."""
        return item

    solid_mesh = factors = matrices

    def materials(self, item: Item) -> object:
        """A material, or materials by region."""
        regions = item.items("a material").items()
        if not regions or any(entry.is_text for _, entry in regions):
            return self.material(item)
        return {name: self.material(entry) for name, entry in regions}

    def points(self, item: Item) -> dict[str, tuple[int | float, ...]]:
        """Three numbers by name."""
        return {name: self.column(entry) for name, entry in item.items("points by name").items()}

    def node_set(self, item: Item) -> str | int | tuple[int, ...]:
        """A name, or numbers of nodes."""
        if item.is_list:
            return tuple(self.count(entry) for entry in item.entries())
        return item.text() if item.number() is None else self.count(item)

    def node_sets(self, item: Item) -> dict[str, str | int | tuple[int, ...]]:
        """Nodes by the names of interfaces."""
        return {name: self.node_set(entry) for name, entry in item.items("nodes by name").items()}

    def prestrain(self, item: Item) -> dict[str, Any]:
        """Strains by name."""
        return self.record(keys.PRESTRAIN, item, "prestrain")

    def mesh(self, item: Item) -> str:
        """A mesh file below the declared folders."""
        with item.at_item():
            return self.meshes.find(item.text(), item.path)

    def limits(self, item: Item) -> Any:
        """(lower, upper, ...) or a mapping."""
        if item.is_list:
            return tuple(self.bound(entry) for entry in item.entries())
        return self.record(keys.LIMITS, item, "limits")

    def links(self, item: Item) -> list[Any]:
        """Rows of a Denavit-Hartenberg table."""
        return [self._link(entry) for entry in item.entries("a list of rows")]

    def _link(self, item: Item) -> Any:
        """A mapping, or [a, alpha, d, theta]."""
        if not item.is_list:
            return self.record(keys.LINK, item, "a row")
        if len(item.entries()) != 4:
            raise item.error("a row is [a, alpha, d, theta] or a mapping")
        return [self.scalar(number) for number in item.entries()]

    def couple(self, item: Item) -> tuple[Any, ...]:
        """(leader, ratio, offset) from a list or a mapping."""
        if not item.is_list:
            values = self.record(keys.COUPLE, item, "a coupling")
            return values["leader"], values["ratio"], values.get("offset", 0)
        entries = item.entries()
        if len(entries) not in (2, 3):
            raise item.error("a coupling is [leader, ratio] or [leader, ratio, offset]")
        first, *numbers = entries
        return (first.text(), *(self.scalar(entry) for entry in numbers))
