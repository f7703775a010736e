"""Choose the rewrites of the system graph for a function."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from ..errors import DerivationError, brief, near
from ..ir.matrix import Matrix
from ..spatial.moments import inertia_tensor
from ..topology.rewrites import REWRITES
from ..topology.system import System
from .formalisms.formalism import Formalism

Rewritten = tuple[tuple[str, ...], System]
# rewrites that save where much passes between bodies, and cost where their inertia has many zeros:
# both ways are counted
COUNTED = ("axes", "parallel")
# up to so many bodies an origin off a zero of the inertia tells, and counting is quick
FEW = 4


def check_names(names: Sequence[str]) -> tuple[str, ...]:
    """Names of rewrites in the order in which they are applied.

    Raises:
        DerivationError: one does not exist.
    """
    names = (names,) if isinstance(names, str) else names
    if not isinstance(names, Iterable):
        raise DerivationError(
            f"rewrites: names are wanted, () for none, not {brief(names)}. Known: "
            f"{', '.join(REWRITES)}"
        )
    names = tuple(names)
    for name in names:
        if name not in REWRITES:
            raise DerivationError(f"rewrite '{name}' does not exist.{near(name, REWRITES)}")
    return tuple(name for name in REWRITES if name in names)


def candidates(
    system: System, formalism: Formalism, names: tuple[str, ...] | None, rigid: bool = False
) -> list[Rewritten]:
    """The ways to tell a system from which the one with the fewest operations is taken.

    Args:
        system: As the user described it.
        formalism: Whose functions are derived from them.
        names: What was asked for; None for what suits the formalism.
        rigid: Whether axes must turn with their bodies, and one inertia serve all purposes: so it
            is where displaced bodies are taken as a whole.

    Returns:
        (names of the rewrites that changed something, system) of each.

    Raises:
        DerivationError: asked for what the formalism does not take.
    """
    if system.closures:
        # loops are solved in the axes in which they are described
        return [((), system)]
    chosen = formalism.rewrites(system) if names is None else names
    for name in formalism.refused:
        if name in chosen:
            raise DerivationError(
                f"rewrite '{name}': method '{formalism.name}' needs axes that turn with their "
                "bodies; leave it out or use another method"
            )
    if rigid:
        chosen = tuple(name for name in chosen if name != "parallel")
        return [_with_one_inertia(_rewritten(system, chosen))]
    systems = [_rewritten(system, chosen)]
    if names is None:
        counted = (*COUNTED, "origins") if len(system.bodies) <= FEW else COUNTED
        systems += [
            _rewritten(system, tuple(n for n in chosen if n != name))
            for name in counted
            if name in systems[0][0]
        ]
    return systems


def _rewritten(system: System, names: tuple[str, ...]) -> Rewritten:
    applied = []
    for name in names:
        changed = REWRITES[name](system)
        if changed is not system:
            applied.append(name)
        system = changed
    return tuple(applied), system


def _with_one_inertia(rewritten: Rewritten) -> Rewritten:
    """Inertia tensors that belong to the second moments."""
    names, system = rewritten
    if "base_parameters" not in names:
        return rewritten
    graph = system.graph.fork()
    bodies = []
    for body in system.bodies:
        assert body.second_moment is not None
        tensor = inertia_tensor(Matrix(graph, 3, 3, body.second_moment))
        bodies.append(replace(body, inertia=tensor.nodes))
    return names, replace(system, graph=graph, bodies=tuple(bodies))
