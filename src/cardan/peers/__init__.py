"""Other programs on the same mechanism: how fast they are, and whether they agree.

A peer is one file and one line here. It is loaded when somebody compares, says by name why it
cannot take part, and is called in a loop in C like our own functions.
"""

from __future__ import annotations

from importlib import import_module

from .peer import Peer

# peer -> module of this package
PEERS = {
    "pinocchio": ".pinocchio",
    "casadi": ".casadi",
    "mujoco": ".mujoco",
    "pydy": ".pydy",
    "drake": ".drake",
}


def peer(name: str) -> Peer:
    """A peer by its name in ``PEERS``."""
    adapter: Peer = import_module(PEERS[name], __package__).PEER
    return adapter


__all__ = ["PEERS", "Peer", "peer"]
