"""Formulas of flexible elements for readers.

R_1, p_1 and R_2, p_2 are the poses of the ends, L is the length.
"""

from __future__ import annotations

from ..formulas import HALFWAY, MEASURES, TANGENT, Lines, Shapes

# of what the formulas of strains, of masses and of loads read
STRAIN_SHAPES: Shapes = {"K": (6, 1), "epsilon": (6, 1)}
SPIN_SHAPES: Shapes = {"J": ("diagonal", 3)}
LOAD_SHAPES: Shapes = {"f": (3, 1), "m": (3, 1)}

POSE: Lines = (
    ("rotation of end 2 seen from end 1", "r = R_1.T @ R_2"),
    ("its rotation vector", "theta = rotation_vector(r)"),
    ("position of end 2 seen from end 1", "d = R_1.T @ (p_2 - p_1)"),
    ("square of the angle", "x = dot(theta, theta)"),
    ("coefficient of the tangent operator", "a = (1 - sqrt(x) / 2 * cot(sqrt(x) / 2)) / x"),
)
# beta_1, beta_2: coefficients of U; kappa_1, kappa_2: their derivatives by x
HELIX: Lines = (
    ("helicoidal interpolation: coefficients of U", "beta_1 = -(1 / 2)"),
    ("", "beta_2 = a"),
    ("their derivatives by x", "kappa_1 = 0"),
    ("", "kappa_2 = 1 / (8 * x * sin(sqrt(x) / 2) ** 2)"
         " + cot(sqrt(x) / 2) / (4 * x * sqrt(x)) - 1 / x ** 2"),
)  # fmt: skip
DENSE: Lines = (
    ("strain of the element: K that of the reference shape, epsilon that without stress",
     "y = column(theta, e) - L * (K + epsilon)"),
)  # fmt: skip
CONSTANT: Lines = (("stress", "sigma = C @ y / L"), ("energy", "V = dot(y, sigma) / 2"))
EQUILIBRIUM: Lines = (
    ("compliance", "c = L * inverse(C)"),
    ("change of the stress in equilibrium from end to end is -A s",
     "A = block(skew(theta), skew(e), O, skew(theta))"),
    ("flexibility of the element", "F = c + A.T @ c @ A / 12"),
    ("stress resultants of the middle", "s = inverse(F) @ y"),
    ("change from end to end, with its sign turned", "t = A @ s"),
    ("energy", "V = dot(s, c @ s) / 2 + dot(t, c @ t) / 24"),
    ("derivative of A s by the strain, s_m and s_n moment and force of s",
     "Z = block(-skew(s_m), -skew(s_n), -skew(s_n), O)"),
    ("stress that works on the strain, dV/dy", "sigma = s - Z.T @ c @ t / 12"),
)  # fmt: skip
WORK: Lines = (
    *TANGENT,
    ("relative rotation by rotations of the ends in their axes and displacements",
     "P = row(-r.T, O, I, O)"),
    ("the same of d", "Q = row(skew(d), -R_1.T, O, R_1.T)"),
    ("strain by displacement", "B = column(D @ P, N @ D @ P + U @ Q)"),
    ("balance: moment and force that hold end 1, then end 2", "b = B.T @ sigma"),
)  # fmt: skip

LUMPED: Lines = (
    ("moments of inertia at each end, J those per length and mu the mass per length",
     "I_k = L * J / 2"),
    ("moment that holds end k, in its axes",
     "b_m = I_k @ omegadot + skew(omega) @ I_k @ omega"),
    ("force that holds it", "b_f = mu * L / 2 * (vdot - g)"),
    ("kinetic energy of an end", "T = mu * L * dot(v, v) / 4 + dot(omega, I_k @ omega) / 2"),
    ("potential energy of an end", "V = -(mu * L * dot(g, p) / 2)"),
)  # fmt: skip
LINKED: Lines = (
    ("share of the cubic, mu the mass per length",
     "eta = 1 / (1 + 6 * (EI_2 / GA_3 + EI_3 / GA_2) / L ** 2)"),
    ("shares of the mass", "c_1 = 1 / 12 + eta / 30 + eta ** 2 / 210"),
    ("", "c_2 = eta / 120 + eta ** 2 / 420"),
    ("", "c_3 = eta ** 2 / 840"),
    ("mass of the positions p_1, p_2", "m_11 = mu * L * (1 / 4 + c_1)"),
    ("", "m_12 = mu * L * (1 / 4 - c_1)"),
    ("of a position and the tangent of its end, and of the other",
     "m_13 = mu * L ** 2 * (1 / 24 + c_2)"),
    ("", "m_14 = mu * L ** 2 * (c_2 - 1 / 24)"),
    ("of the tangents t_1, t_2, first columns of R_1, R_2",
     "m_33 = mu * L ** 3 * (1 / 120 + c_3)"),
    ("", "m_34 = mu * L ** 3 * (c_3 - 1 / 120)"),
    ("velocities of the tangents", "w_1 = R_1 @ skew(omega_1) @ i"),
    ("", "w_2 = R_2 @ skew(omega_2) @ i"),
    ("kinetic energy: the cubic through the ends, i = (1, 0, 0), ...",
     "T_1 = m_11 * (dot(v_1, v_1) + dot(v_2, v_2)) / 2 + m_12 * dot(v_1, v_2)"
     " + m_13 * (dot(v_1, w_1) - dot(v_2, w_2)) + m_14 * (dot(v_1, w_2) - dot(v_2, w_1))"
     " + m_33 * (dot(w_1, w_1) + dot(w_2, w_2)) / 2 + m_34 * dot(w_1, w_2)"),
    ("... and angular velocities linear between the ends, J the moments of inertia per length",
     "T_2 = L / 6 * (dot(omega_1, J @ (omega_1 + omega_2)) + dot(omega_2, J @ omega_2))"),
    ("kinetic energy", "T = T_1 + T_2"),
    ("potential energy", "V = -dot(g, mu * L / 2 * (p_1 + p_2)"
     " + (m_13 - m_14) * (R_1 @ i - R_2 @ i))"),
    ("accelerations less gravity", "a_1 = vdot_1 - g"),
    ("", "a_2 = vdot_2 - g"),
    ("accelerations of the tangents",
     "z_1 = R_1 @ (skew(omegadot_1) @ i + skew(omega_1) @ skew(omega_1) @ i)"),
    ("", "z_2 = R_2 @ (skew(omegadot_2) @ i + skew(omega_2) @ skew(omega_2) @ i)"),
    ("forces that hold the ends", "f_1 = m_11 * a_1 + m_12 * a_2 + m_13 * z_1 + m_14 * z_2"),
    ("", "f_2 = m_12 * a_1 + m_11 * a_2 - m_14 * z_1 - m_13 * z_2"),
    ("forces that hold the tangents", "h_1 = m_13 * a_1 - m_14 * a_2 + m_33 * z_1 + m_34 * z_2"),
    ("", "h_2 = m_14 * a_1 - m_13 * a_2 + m_34 * z_1 + m_33 * z_2"),
    ("moments that hold the ends, in their axes",
     "tau_1 = skew(i) @ R_1.T @ h_1 + L / 3 * J @ (omegadot_1 + omegadot_2 / 2)"
     " + L / 3 * skew(omega_1) @ J @ (omega_1 + omega_2 / 2)"),
    ("", "tau_2 = skew(i) @ R_2.T @ h_2 + L / 3 * J @ (omegadot_2 + omegadot_1 / 2)"
     " + L / 3 * skew(omega_2) @ J @ (omega_2 + omega_1 / 2)"),
    ("balance M a + h", "b = column(tau_1, f_1, tau_2, f_2)"),
)  # fmt: skip

SECTION: Lines = (
    ("stiffness of the section", "C = diagonal(GJ, EI_2, EI_3, EA, GA_2, GA_3)"),
)  # fmt: skip
SOFT: Lines = (
    ("shear with the residual flexibility of bending",
     "S_2 = 1 / (1 / GA_2 + L ** 2 / (12 * EI_3))"),
    ("", "S_3 = 1 / (1 / GA_3 + L ** 2 / (12 * EI_2))"),
    ("stiffness of the section", "C = diagonal(GJ, EI_2, EI_3, EA, S_2, S_3)"),
)  # fmt: skip
RATE: Lines = (
    ("stress by the rate of strain, eta the damping, u the speeds of the ends",
     "sigma = eta * C @ B @ u / L"),
)  # fmt: skip

HELICOIDAL: Lines = (*POSE, *HELIX, *MEASURES, *DENSE, *SECTION, *CONSTANT, *WORK)
HELLINGER_REISSNER: Lines = (*POSE, *HELIX, *MEASURES, *DENSE, *SECTION, *EQUILIBRIUM, *WORK)
CLASSICAL: Lines = (*POSE, *HALFWAY, *MEASURES, *DENSE, *SOFT, *CONSTANT, *WORK)
CLASSICAL_PLAIN: Lines = (*POSE, *HALFWAY, *MEASURES, *DENSE, *SECTION, *CONSTANT, *WORK)
DAMPING: Lines = (*POSE, *HELIX, *MEASURES, *SOFT, *WORK[:-1], *RATE, *WORK[-1:])

# f: dead load and weight per length in ground axes, n: follower load in section axes
DEAD: Lines = (
    ("dead load f_0 and weight per length, mu the mass per length", "f = f_0 + mu * g"),
    ("as the ends see it", "a_1 = R_1.T @ f"),
    ("", "a_2 = R_2.T @ f"),
    ("picks the force of a stress, and the length of a strain", "E = row(O, I)"),
    ("load in axes of the strain, n the follower load per length",
     "l = L * E.T @ ((a_1 + a_2) / 2 + n)"),
)  # fmt: skip
LOADED: Lines = (
    ("compliance", "c = L * inverse(C)"),
    ("change of the stress in equilibrium from end to end is -(A s + l)",
     "A = block(skew(theta), skew(e), O, skew(theta))"),
    ("flexibility of the element", "F = c + A.T @ c @ A / 12"),
    ("stress resultants of the middle", "s = inverse(F) @ (y - A.T @ c @ l / 12)"),
    ("change from end to end, with its sign turned", "t = A @ s + l"),
    ("energy of the strain, less the work of the load on the helix",
     "V = dot(s, c @ s) / 2 + dot(t, c @ (t - 2 * l)) / 24"
     " - L / 2 * dot(f, p_1 + p_2) + L / 12 * dot(a_2 - a_1, e)"),
    ("derivative of A s by the strain, s_m and s_n moment and force of s",
     "Z = block(-skew(s_m), -skew(s_n), -skew(s_n), O)"),
    ("stress that works on the strain",
     "sigma = s - Z.T @ c @ t / 12 + L / 12 * E.T @ (a_2 - a_1)"),
)  # fmt: skip
END_FORCES: Lines = (
    ("derivatives of V by a_1 and a_2", "d_1 = -(L * E @ c @ t / 24) - L / 12 * e"),
    ("", "d_2 = -(L * E @ c @ t / 24) + L / 12 * e"),
    ("balance: moment and force that hold end 1, then end 2",
     "b = B.T @ sigma"
     " + column(skew(d_1) @ a_1, -(L / 2 * f), skew(d_2) @ a_2, -(L / 2 * f))"),
)  # fmt: skip
HELLINGER_REISSNER_LOADED: Lines = (
    *POSE, *HELIX, *MEASURES, *DENSE, *SECTION, *DEAD, *LOADED, *WORK[:-1], *END_FORCES
)  # fmt: skip

# f_1, f_2: force per length in ground axes as the ends have it, m_1, m_2: moment in their axes
SHARES: Lines = (
    ("forces at the ends by work on the cubic through them, i = (1, 0, 0)",
     "n_1 = L * (7 * f_1 + 3 * f_2) / 20"),
    ("", "n_2 = L * (3 * f_1 + 7 * f_2) / 20"),
    ("forces on the tangents R_1 i, R_2 i", "h_1 = L ** 2 * (3 * f_1 + 2 * f_2) / 60"),
    ("", "h_2 = -(L ** 2 * (2 * f_1 + 3 * f_2) / 60)"),
)  # fmt: skip
SUPPORT: Lines = (
    ("moments that hold the ends, in their axes", "tau_1 = -(skew(i) @ R_1.T @ h_1 + L / 2 * m_1)"),
    ("", "tau_2 = -(skew(i) @ R_2.T @ h_2 + L / 2 * m_2)"),
    ("balance", "b = column(tau_1, -n_1, tau_2, -n_2)"),
)
DEAD_LOAD: Lines = (
    ("force and moment per length in ground axes", "f_1 = f"),
    ("", "f_2 = f"),
    ("", "m_1 = R_1.T @ m"),
    ("", "m_2 = R_2.T @ m"),
    *SHARES,
    ("potential energy of the force",
     "V = -(dot(n_1, p_1) + dot(n_2, p_2) + dot(h_1, R_1 @ i) + dot(h_2, R_2 @ i))"),
    *SUPPORT,
)  # fmt: skip
FOLLOWER_LOAD: Lines = (
    ("force and moment per length in section axes", "f_1 = R_1 @ f"),
    ("", "f_2 = R_2 @ f"),
    ("", "m_1 = m"),
    ("", "m_2 = m"),
    *SHARES,
    *SUPPORT,
)

# gravity fields: p_c is the center, mu the mass per length, J inertia per length in section axes
_CENTER: Lines = (("ends from the center of the field", "d_1 = p_1 - p_c"), ("", "d_2 = p_2 - p_c"))
_POINTS: Lines = (
    ("share of the cubic in the shape", "eta = 1 / (1 + 6 * (EI_2 / GA_3 + EI_3 / GA_2) / L ** 2)"),
    ("halves of the mass at the points of Gauss: shares of both ends in their place",
     "N_1 = 1 / 2 + (1 / 2 + eta / 6) / sqrt(3)"),
    ("", "N_2 = 1 / 2 - (1 / 2 + eta / 6) / sqrt(3)"),
    ("shares of the tangents, i = (1, 0, 0)", "N_3 = L * (1 + eta / sqrt(3)) / 12"),
    ("", "N_4 = L * (1 - eta / sqrt(3)) / 12"),
    ("places of both halves", "r_1 = N_1 * d_1 + N_2 * d_2 + N_3 * R_1 @ i - N_4 * R_2 @ i"),
    ("", "r_2 = N_2 * d_1 + N_1 * d_2 + N_4 * R_1 @ i - N_3 * R_2 @ i"),
)  # fmt: skip
_ENDS: Lines = (("halves of the mass at the ends", "r_1 = d_1"), ("", "r_2 = d_2"))
_CENTRAL: Lines = (
    ("their pull, mu_c the constant of the field",
     "F_1 = -(mu_c * mu * L / (2 * sqrt(dot(r_1, r_1)) ** 3) * r_1)"),
    ("", "F_2 = -(mu_c * mu * L / (2 * sqrt(dot(r_2, r_2)) ** 3) * r_2)"),
)  # fmt: skip
_CENTRAL_POTENTIAL: Lines = (
    ("potential energy",
     "V = -(mu_c * mu * L / 2 * (1 / sqrt(dot(r_1, r_1)) + 1 / sqrt(dot(r_2, r_2))))"),
)  # fmt: skip
_GRADIENT: Lines = (
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
_GRADIENT_POTENTIAL: Lines = (
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
    pull = _GRADIENT if gradient else _CENTRAL
    energy = (_GRADIENT_POTENTIAL if gradient else _CENTRAL_POTENTIAL) if potential else ()
    places = _ENDS if lumped else _POINTS
    return (*_CENTER, *places, *pull, *energy, *_balance(gradient, lumped))


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
