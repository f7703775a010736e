"""Derivatives of the elements of a model, written when they are asked for, as C calls them."""

from __future__ import annotations

import ctypes
from collections.abc import Collection, Hashable, Sequence
from typing import final

import numpy as np

from ....arrays import Array
from ....errors import ModelError
from ....schema.finite_elements import DERIVATIVES, EVENT_DERIVATIVES, FORMULAS, requested_name
from ....schema.records import Form
from ...calls.code import Code
from ...calls.lanes import width
from ...calls.objects import Objects
from .mesh import Mesh
from .table_loading import LANE_THRESHOLD
from .tables import Table


@final
class ProductForms:
    """Derivatives of all groups of elements and kinds of places.

    Args:
        mesh: The elements.
        objects: Compiled functions of the model.
        parameters: Their values, which formulas read.

    Attributes:
        local: Numbers that the largest of them reads and gives, per lane.
        work: Numbers of scratch that the largest takes.
        lanes: Elements that one of them takes side by side, at most.
    """

    def __init__(self, mesh: Mesh, objects: Objects, parameters: Array) -> None:
        self.mesh, self.objects, self.parameters = mesh, objects, parameters
        self.tables = mesh.tables
        self._forms: dict[Hashable, ctypes.Array[Form]] = {}
        self.local = self.work = self.lanes = 0

    def derivatives(self, form: str, groups: Collection[int]) -> ctypes.Array[Form]:
        """Derivatives of some groups, made once.

        Args:
            form: Such as ``dynamics_gradient``.
            groups: Numbers of the groups; those that have none are left out.

        Raises:
            ModelError: one reads or gives other numbers than the kernels take.
        """
        listed, of_elements = self.tables.groups, [*groups]
        key = form, tuple(of_elements)
        if key not in self._forms:
            forms = (Form * max(1, len(listed)))()
            having = [k for k in of_elements if form in listed[k].kind.derivatives]
            names = {listed[k].kind.derivatives[form]: listed[k].kind for k in having}
            codes = self._loaded([(form, kind.name) for kind in names.values()], list(names))
            for k in having:
                code = codes[listed[k].kind.derivatives[form]]
                self._check(form, listed[k], code)
                self.mesh.form(forms[k], code, self.mesh.data[k])
                self.local = max(self.local, int(code.entry.output_size) + len(code.entry.vector))
            self._forms[key] = forms
        return self._forms[key]

    def _check(self, form: str, group: Table, code: Code) -> None:
        """Refuse files whose derivatives have other numbers than the kernels hand over.

        Raises:
            ModelError: one has.
        """
        kind, functions = group.kind, self.objects.manifest.functions
        quantity, _, mode = form.rpartition("_")
        read = kind.nq + 2 * kind.nu + kind.m + kind.nz + kind.ns + self.tables.nr + 1
        if group.common:
            read += self.objects.function(group.common).outputs[0].shape[-1]
        if quantity == "dynamics":
            weights = kind.nu + kind.mp + 2 * kind.m + kind.states[0]
        elif quantity == "impulse":
            weights = kind.nu + kind.m
        else:
            weights = int(functions[kind.functions[DERIVATIVES[form][0]]].output_size)
        if form in EVENT_DERIVATIVES:
            read += kind.nu + kind.frictions + kind.responses
        expected = {
            "gradient": (weights, read),
            "change": (read, weights),
            "curvature": (weights + read, read),
        }
        sizes = len(code.entry.vector), int(code.entry.output_size)
        if sizes != expected[mode]:
            raise ModelError(
                f"model '{self.objects.manifest.name}': {form} of '{kind.name}' has {sizes} "
                "numbers, not those of its elements. Compile the scene again"
            )

    def formula(self, formula: str, curved: bool) -> ctypes.Array[Form]:
        """Value of a formula, its slopes, and the changes of these where they are asked for."""
        keys = [(form, formula) for form in FORMULAS[: 3 if curved else 2]]
        forms = (Form * len(keys))()
        symbols = [requested_name(*key) for key in keys]
        codes = self._loaded(keys, symbols)
        for form, symbol in zip(forms, symbols, strict=True):
            self.mesh.form(form, codes[symbol], self.parameters[None])
            entry = codes[symbol].entry
            self.local = max(self.local, int(entry.output_size) + len(entry.vector))
        return forms

    def rates(self, form: str) -> ctypes.Array[Form]:
        """Derivatives of the rates of places that move by functions of their own."""
        if form not in self._forms:
            kinds = [kind for kind in self.tables.kinds if kind.name != "node"]
            forms = (Form * max(1, len(kinds)))()
            having = {k: kind for k, kind in enumerate(kinds) if kind.derivatives}
            keys = [(form, kind.name) for kind in having.values()]
            symbols = [kind.derivatives[form] for kind in having.values()]
            codes = self._loaded(keys, symbols)
            for (k, _), symbol in zip(having.items(), symbols, strict=True):
                self.mesh.form(forms[k], codes[symbol], np.zeros((1, 0)))
                entry = codes[symbol].entry
                self.local = max(self.local, int(entry.output_size) + len(entry.vector))
            self._forms[form] = forms
        return self._forms[form]

    def _loaded(self, keys: Sequence[tuple[str, str]], symbols: Sequence[str]) -> dict[str, Code]:
        """Functions that are written when they are asked for, checked."""
        objects = self.objects
        with objects.lock:
            missing = [
                key
                for key, symbol in zip(keys, symbols, strict=True)
                if symbol not in objects.manifest.functions
            ]
            if missing and objects._provide is None:
                raise ModelError(
                    f"model '{objects.manifest.name}' was saved without the derivatives of its "
                    "elements. Use them once before saving it, or compile the scene again"
                )
            if missing:
                objects.symbols(missing)
            self._side_by_side(symbols)
            codes = self.mesh.loaded(symbols)
        self.work = max([self.work, *(code.entry.work_size for code in codes.values())])
        self.lanes = max([self.lanes, *(code.lanes for code in codes.values())])
        return codes

    def _side_by_side(self, symbols: Sequence[str]) -> None:
        """Functions of many elements are compiled for several of them side by side."""
        objects, lanes = self.objects, width()
        many = [group.kind for group in self.tables.groups if len(group) >= LANE_THRESHOLD]
        for kind in many if lanes > 1 else ():
            for symbol in {*kind.derivatives.values()}.intersection(symbols):
                if lanes in objects.manifest.functions[symbol].lanes:
                    objects.lanes[symbol] = lanes
