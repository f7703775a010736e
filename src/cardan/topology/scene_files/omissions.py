"""Parts of a scene that a format for robots has no words for."""

from __future__ import annotations

from collections.abc import Container, Iterator

from ...scene.scene import SceneRecord
from .numeric_scene import NumericScene

# taken by all readers of URDF [m/s^2]
GRAVITY = (0.0, 0.0, -9.81)


def of_scene(scene: SceneRecord, numbers: NumericScene, said: Container[str]) -> Iterator[str]:
    """A sentence for everything beside bodies and joints.

    Args:
        scene: The scene.
        numbers: Its numbers.
        said: Names of forces that joints have as their damping.
    """
    gravity = numbers.numbers(numbers.system.gravity).tolist()
    if tuple(gravity) != GRAVITY:
        components = ", ".join(f"{x:g}" for x in gravity)
        yield f"gravity ({components}): programs take (0, 0, -9.81)"
    for name in scene.beams:
        yield f"beam '{name}'"
    for name in scene.cables:
        yield f"cable '{name}'"
    for name in scene.superelements:
        yield f"superelement '{name}'"
    for name, force in scene.forces.items():
        if name not in said:
            yield f"force '{name}' ({force.element.kind})"
    for what in ("inputs", "outputs", "constraints"):
        for name in getattr(scene, what):
            yield f"{what[:-1]} '{name}'"
    if scene.settings:
        yield f"how it is simulated: {', '.join(scene.settings)}"
