"""Names of speeds, and of what they are rates of."""

from __future__ import annotations

import pytest

from cardan.schema.blocks import of_rate


@pytest.mark.parametrize(
    ("speed", "what"),
    [
        ("elbow.u", "elbow"),
        ("ball.u.x", "ball.x"),
        ("leg.upper.u", "leg.upper"),
        ("leg.under.u.x", "leg.under.x"),
        ("a.u.x.u", "a.u.x"),
        ("spin", "spin"),
        ("left.unit", "left.unit"),
    ],
)
def test_the_last_u_is_left_out(speed: str, what: str) -> None:
    assert of_rate(speed) == what
