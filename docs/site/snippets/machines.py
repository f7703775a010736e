"""Ready subsystems."""

import cardan as cd

# parts
scene = cd.Scene("machine", gravity=(0, 0, -9.81))
scene.include(cd.parts.four_bar(), prefix="left.")

# parts.cam_and_follower
cam_and_follower = cd.parts.cam_and_follower()

# parts.differential
differential = cd.parts.differential()

# parts.double_wishbone
double_wishbone = cd.parts.double_wishbone()

# parts.four_bar
four_bar = cd.parts.four_bar()

# parts.gyroscope
gyroscope = cd.parts.gyroscope()

# parts.planetary_gear
planetary_gear = cd.parts.planetary_gear()

# parts.quadruped_leg
quadruped_leg = cd.parts.quadruped_leg()

# parts.reaction_wheel_set
reaction_wheel_set = cd.parts.reaction_wheel_set()

# parts.slider_crank
slider_crank = cd.parts.slider_crank()

# parts.stewart_platform
stewart_platform = cd.parts.stewart_platform()
