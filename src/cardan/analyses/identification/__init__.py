"""Identification of inertial parameters: what data can tell, motions that excite, estimates."""
