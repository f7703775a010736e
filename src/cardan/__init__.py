"""cardan: a compiler for multibody mechanics."""

__version__ = "0.1.0"
