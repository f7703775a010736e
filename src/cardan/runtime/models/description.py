"""Names, sizes, limits and sources of a compiled model."""

from __future__ import annotations

from pathlib import Path

from ...schema.manifest import Manifest
from ...schema.rows import column, having
from ..calls.layout import Layout
from ..calls.objects import Objects
from ..calls.parameters import Parameters
from .derivative_products import DerivativeProducts


class Description(DerivativeProducts):
    """Names and sizes of a model, from its manifest."""

    _objects: Objects
    _layout: Layout
    _parameters: Parameters

    @property
    def name(self) -> str:
        """Name of the model."""
        return self.manifest.name

    @property
    def manifest(self) -> Manifest:
        """Everything the compiler says about the model; see ``docs/manifest.schema.json``."""
        return self._objects.manifest

    @property
    def directory(self) -> Path:
        """Folder of its C files and manifest."""
        return self._objects.directory

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of q."""
        return self._layout.coordinates

    @property
    def speeds(self) -> tuple[str, ...]:
        """Names of u."""
        return self._layout.speeds

    @property
    def inputs(self) -> tuple[str, ...]:
        """Names of r."""
        return self._layout.inputs

    @property
    def frames(self) -> tuple[str, ...]:
        """Names of the frames that pose, velocity and others take."""
        return tuple(self.part_of)

    @property
    def bodies(self) -> tuple[str, ...]:
        """Names of the bodies that can move."""
        return self._layout.parts

    @property
    def part_of(self) -> dict[str, str | None]:
        """Frame -> the body it is fixed to, None for the ground."""
        return self._layout.part_of

    @property
    def joints(self) -> tuple[str, ...]:
        """Names of the joints: those of the tree, those that are cut, those that are fixed."""
        manifest = self.manifest
        moving = [*column(manifest.joints, "name"), *(row.name for row in manifest.cuts)]
        # elements that transmit a reaction, some without coordinates of their own
        if manifest.absolute:
            moving += (*manifest.elements.reactions, *manifest.elements.tree_joints)
        return (*dict.fromkeys(moving), *manifest.fixed)

    @property
    def nq(self) -> int:
        """Number of coordinates."""
        return len(self.coordinates)

    @property
    def nu(self) -> int:
        """Number of speeds."""
        return len(self.speeds)

    @property
    def nx(self) -> int:
        """Length of the state x = [q, u, z]."""
        return self.nq + self.nu + self.nz

    @property
    def internals(self) -> tuple[str, ...]:
        """Names of the internal states z of elements."""
        return self._layout.internals

    @property
    def mode_names(self) -> tuple[str, ...]:
        """Names of the discrete states s of elements."""
        return self._layout.modes

    @property
    def event_names(self) -> tuple[str, ...]:
        """Names of everything that can happen to elements."""
        return self._layout.events

    @property
    def nz(self) -> int:
        """Number of internal states."""
        return len(self.internals)

    @property
    def ns(self) -> int:
        """Number of discrete states."""
        return len(self.mode_names)

    @property
    def nr(self) -> int:
        """Number of inputs."""
        return len(self.inputs)

    @property
    def multipliers_of(self) -> tuple[str, ...]:
        """Names of the constraints and their multipliers."""
        return tuple(row.name for row in self.manifest.multipliers)

    @property
    def nlam(self) -> int:
        """Number of Lagrange multipliers."""
        return len(self.manifest.multipliers)

    @property
    def limits(self) -> dict[str, dict[str, float | None]]:
        """Limits of the joints that have some: lower, upper, speed, effort."""
        return {row.name: {**row.limits} for row in having(self.manifest.joints, "limits")}

    @property
    def parameters(self) -> Parameters:
        """Parameter values by dotted name; read-only, see :meth:`with_parameters`."""
        return self._parameters

    @property
    def source(self) -> dict[str, str]:
        """C text by C name, of every function written so far."""
        names = self.manifest.functions
        return {name: self._objects.text_path(name).read_text("utf-8") for name in names}

    @property
    def operations(self) -> dict[str, dict[str, int]]:
        """Number of each operator by C name, of every function written so far."""
        return {name: {**entry.operations} for name, entry in self.manifest.functions.items()}
