"""Ready subsystems, each a function that returns a scene: ``cd.parts``.

::

    print(cd.parts.PARTS)                        names and functions
    scene = cd.parts.four_bar(crank_length=0.08)
    motion = cd.compile(scene).simulate(**scene.settings)

    car = cd.Scene("car")
    ...
    car.include(cd.parts.double_wishbone(), prefix="left", at=chassis.at(0, 0.3, 0))

Numbers are declared parameters with units, which ``model.with_parameters`` changes. Parts that are
driven have inputs; their outputs are what users of such a part look at. The ground of a part
becomes a body of the scene that includes it. Axes: x forward or to the right, z up; mechanisms in a
plane move in x and z, with angles counted from x towards z.

Source: Roberson and Schwertassek, Dynamics of Multibody Systems, 1988, 14.2.2 (subsystems).
"""

from .cam_and_follower import cam_and_follower
from .differential import differential
from .double_wishbone import double_wishbone
from .four_bar import four_bar
from .gyroscope import gyroscope
from .planetary_gear import planetary_gear
from .quadruped_leg import quadruped_leg
from .reaction_wheel_set import reaction_wheel_set
from .slider_crank import slider_crank
from .stewart_platform import stewart_platform

PARTS = {
    make.__name__: make
    for make in (
        four_bar,
        slider_crank,
        cam_and_follower,
        differential,
        planetary_gear,
        double_wishbone,
        quadruped_leg,
        stewart_platform,
        gyroscope,
        reaction_wheel_set,
    )
}
__all__ = ["PARTS", *PARTS]
