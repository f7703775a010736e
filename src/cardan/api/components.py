"""Components of finite elements as users hold them."""

from __future__ import annotations

from typing import final

from ..runtime.models.finite_elements.superelements import DeformedSuperelementRecord
from ..superelements.readers.matrix_files import ComponentMatricesRecord
from ..superelements.record import SuperelementRecord
from .faces import verb


@final
class Superelement(SuperelementRecord):
    """A component, reduced to motions of its interfaces and some modes."""

    animate = verb("cardan.view.superelements:animate")
    plot = verb("cardan.view.superelements:plot")
    save = verb("cardan.runtime.superelement_file:save")


@final
class DeformedSuperelement(DeformedSuperelementRecord):
    """A superelement of a scene with its deformation, at one state or along a motion."""

    plot = verb("cardan.view.superelements:plot_deformed")


@final
class ComponentMatrices(ComponentMatricesRecord):
    """Mass and stiffness of a component, read from files."""

    reduce = verb("cardan.superelements.readers.matrix_files:reduced")
