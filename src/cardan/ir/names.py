"""How entries of blocks are called."""

from __future__ import annotations

import re

# the last part "u", or the one before the last: names of joints may have dots and such parts too
_SPEED = re.compile(r"\.u(?=$|\.[^.]*$)")


def of_rate(speed: str) -> str:
    """What ``elbow.u`` and ``ball.u.x`` are rates of by name: ``elbow``, ``ball.x``.

    Names of another form stay as they are.
    """
    return _SPEED.sub("", speed, count=1)
