"""Formulas for readers of gravity fields on elements of beams.

R_1, p_1 and R_2, p_2 are the poses of the ends, p_c is the center of the field, L the length, mu
the mass per length, J the inertia per length about the axes of the section.
"""

from __future__ import annotations

from ..formulas import Lines

CENTER: Lines = (("ends from the center of the field", "d_1 = p_1 - p_c"), ("", "d_2 = p_2 - p_c"))
POINTS: Lines = (
    ("share of the cubic in the shape", "eta = 1 / (1 + 6 * (EI_2 / GA_3 + EI_3 / GA_2) / L ** 2)"),
    ("halves of the mass at the points of Gauss: shares of both ends in their place",
     "N_1 = 1 / 2 + (1 / 2 + eta / 6) / sqrt(3)"),
    ("", "N_2 = 1 / 2 - (1 / 2 + eta / 6) / sqrt(3)"),
    ("shares of the tangents, i = (1, 0, 0)", "N_3 = L * (1 + eta / sqrt(3)) / 12"),
    ("", "N_4 = L * (1 - eta / sqrt(3)) / 12"),
    ("places of both halves", "r_1 = N_1 * d_1 + N_2 * d_2 + N_3 * R_1 @ i - N_4 * R_2 @ i"),
    ("", "r_2 = N_2 * d_1 + N_1 * d_2 + N_4 * R_1 @ i - N_3 * R_2 @ i"),
)  # fmt: skip
ENDS: Lines = (("halves of the mass at the ends", "r_1 = d_1"), ("", "r_2 = d_2"))
CENTRAL: Lines = (
    ("their pull, mu_c the constant of the field",
     "F_1 = -(mu_c * mu * L / (2 * sqrt(dot(r_1, r_1)) ** 3) * r_1)"),
    ("", "F_2 = -(mu_c * mu * L / (2 * sqrt(dot(r_2, r_2)) ** 3) * r_2)"),
)  # fmt: skip
CENTRAL_POTENTIAL: Lines = (
    ("potential energy",
     "V = -(mu_c * mu * L / 2 * (1 / sqrt(dot(r_1, r_1)) + 1 / sqrt(dot(r_2, r_2))))"),
)  # fmt: skip
GRADIENT: Lines = (
    ("distances from the center", "rho_1 = sqrt(dot(r_1, r_1))"),
    ("", "rho_2 = sqrt(dot(r_2, r_2))"),
    ("inertia of both halves in ground axes", "J_1 = L / 2 * R_1 @ J @ R_1.T"),
    ("", "J_2 = L / 2 * R_2 @ J @ R_2.T"),
    ("their pull, mu_c the constant of the field",
     "F_1 = -(3 * mu_c / (2 * rho_1 ** 5)"
     " * ((trace(J_1) - 5 * dot(r_1, J_1 @ r_1) / rho_1 ** 2) * r_1 + 2 * J_1 @ r_1))"),
    ("", "F_2 = -(3 * mu_c / (2 * rho_2 ** 5)"
     " * ((trace(J_2) - 5 * dot(r_2, J_2 @ r_2) / rho_2 ** 2) * r_2 + 2 * J_2 @ r_2))"),
    ("torques", "M_1 = 3 * mu_c / rho_1 ** 5 * skew(r_1) @ J_1 @ r_1"),
    ("", "M_2 = 3 * mu_c / rho_2 ** 5 * skew(r_2) @ J_2 @ r_2"),
)  # fmt: skip
GRADIENT_POTENTIAL: Lines = (
    ("potential energy",
     "V = -(mu_c / 2"
     " * ((trace(J_1) - 3 * dot(r_1, J_1 @ r_1) / rho_1 ** 2) / rho_1 ** 3"
     " + (trace(J_2) - 3 * dot(r_2, J_2 @ r_2) / rho_2 ** 2) / rho_2 ** 3))"),
)  # fmt: skip


def gravity_lines(gradient: bool, lumped: bool, potential: bool) -> Lines:
    """A central field on an element.

    Args:
        gradient: The part by the extent of the sections, else that on their mass centers.
        lumped: On halves of the mass at the ends, else along the shape.
        potential: The strength of the field is constant.
    """
    pull = GRADIENT if gradient else CENTRAL
    energy = (GRADIENT_POTENTIAL if gradient else CENTRAL_POTENTIAL) if potential else ()
    places = ENDS if lumped else POINTS
    return (*CENTER, *places, *pull, *energy, *_balance(gradient, lumped))


def _balance(gradient: bool, lumped: bool) -> Lines:
    """Moments and forces that hold both ends."""
    torques = ["-R_1.T @ M_1", "-R_2.T @ M_2"] if gradient else ["0 * F_1", "0 * F_2"]
    if lumped:
        moments, forces = torques, ["-F_1", "-F_2"]
    else:
        moments = [
            "-skew(i) @ R_1.T @ (N_3 * F_1 + N_4 * F_2)",
            "skew(i) @ R_2.T @ (N_4 * F_1 + N_3 * F_2)",
        ]
        if gradient:
            moments = [f"{moment} - R_{k}.T @ M_{k}" for k, moment in enumerate(moments, start=1)]
        forces = ["-(N_1 * F_1 + N_2 * F_2)", "-(N_2 * F_1 + N_1 * F_2)"]
    return (
        ("moments that hold the ends, in their axes", f"tau_1 = {moments[0]}"),
        ("", f"tau_2 = {moments[1]}"),
        ("balance; a center that moves is held by F_1 + F_2",
         f"b = column(tau_1, {forces[0]}, tau_2, {forces[1]})"),
    )  # fmt: skip
