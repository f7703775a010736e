"""Speed against error of the integrators on a motion."""
