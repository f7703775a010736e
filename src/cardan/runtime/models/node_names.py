"""Names of nodes of beams, which nobody gave: they stand behind those that somebody did."""

from __future__ import annotations

from collections.abc import Iterable

from ...schema.manifest import Manifest


def of_node(manifest: Manifest, name: str) -> bool:
    """True for entries of nodes, such as ``bar.node1.px`` or ``u0.bar.end``."""
    plain = name.removeprefix("q0.").removeprefix("u0.")
    return any(plain.startswith(f"{beam.name}.") for beam in manifest.beams)


def nodes_last(manifest: Manifest, names: Iterable[str]) -> list[str]:
    """Names in their order, each once, those of nodes last."""
    listed = list(dict.fromkeys(names))
    return sorted(listed, key=lambda name: of_node(manifest, name))
