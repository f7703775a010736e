"""The input blocks of a compiled function in the order of ``cardan_in``."""

from __future__ import annotations

BLOCKS = "t q u z s r p w udot zdot lam tau wrench du q0 e"
ORDER = tuple(BLOCKS.split())
SLOT = {name: k for k, name in enumerate(ORDER)}
