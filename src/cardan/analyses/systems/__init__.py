"""DynamicSystem, which every analysis works on, and its two implementations."""

from __future__ import annotations

from ...errors import ModelError
from ...runtime.models.loaded_model import LoadedModel
from .dynamic_system import DynamicSystem


def dynamic_system_of(model: object, strain: bool = False) -> DynamicSystem:
    """The dynamic system of a compiled model.

    Args:
        model: Compiled.
        strain: The forces of strains and constraints alone, without loads, weights and masses.

    Raises:
        ModelError: it lacks what analyses need.
    """
    if not isinstance(model, LoadedModel):
        raise ModelError(f"{model!r} is not a compiled model: cd.compile(scene) makes one")
    if model.manifest.absolute:
        from .finite_element_system import FiniteElementSystem

        return FiniteElementSystem(model, strain)
    from .joint_system import JointSystem

    return JointSystem(model, strain)
