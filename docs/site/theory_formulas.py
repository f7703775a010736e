"""Equations of the formalisms, and steps of the integrators, in LaTeX."""

from __future__ import annotations

# omega_r and v_r: derivatives of angular velocity and velocity by the speed u_r; a_0 and alpha_0:
# accelerations at udot = 0; v and a of the center of mass, F and L the force and moment on a body
EQUATIONS: dict[str, tuple[str, ...]] = {
    "kane": (
        r"M_{rs} = \sum_i m_i\, v_{i,r} \cdot v_{i,s} + \omega_{i,r} \cdot J_i\, \omega_{i,s}",
        r"h_r = \sum_i v_{i,r} \cdot m_i (a_{i,0} - g) + \omega_{i,r} \cdot "
        r"(J_i \alpha_{i,0} + \omega_i \times J_i \omega_i)",
        r"\tau_r = \sum_i v_{i,r} \cdot F_i + \omega_{i,r} \cdot L_i",
    ),
    "newton_euler": (
        r"F_i = m_i (a_i - g), \quad L_i = J_i \alpha_i + \omega_i \times J_i \omega_i",
        r"f_i = \begin{pmatrix} L_i \\ F_i \end{pmatrix} + \sum_{j \in c(i)} X_{ji}^T f_j, "
        r"\quad \tau_i = S_i^T f_i",
    ),
    "composite": (
        r"I_i^c = I_i + \sum_{j \in c(i)} X_{ji}^T I_j^c X_{ji}",
        r"M_{ij} = S_i^T X_{ji}^T I_j^c S_j, \quad i \text{ on the path from the ground to } j",
    ),
    "articulated": (
        r"D_i = S_i^T I_i^A S_i, \quad I_i^A = I_i + \sum_{j \in c(i)} X_{ji}^T "
        r"(I_j^A - I_j^A S_j D_j^{-1} S_j^T I_j^A) X_{ji}",
        r"\dot u_i = D_i^{-1} \left( \tau_i - S_i^T (p_i^A + I_i^A X_i a_{p(i)}) \right)",
    ),
    "lagrange": (
        r"p_r = \frac{\partial T}{\partial u_r}, \quad M_{rs} = \frac{\partial^2 T}"
        r"{\partial u_r\, \partial u_s}",
        r"\frac{d}{dt} p_r - \partial_r T - p \cdot c_r + \partial_r V = Q_r",
    ),
    "hamilton": (
        r"H = \frac{1}{2} (p - b)^T M^{-1} (p - b) - T_0 + V",
        r"\dot p = -\partial H + p \cdot c + Q, \quad M \dot u = \dot p - \dot M u - \dot b",
    ),
    "gibbs_appell": (
        r"\mathcal{G} = \frac{1}{2} \int (a - g) \cdot (a - g)\, dm, \quad "
        r"\frac{\partial \mathcal{G}}{\partial \dot u} = M \dot u + h",
    ),
    "barycentric": (
        r"B_i = \text{first moment of body } i \text{ with the masses outboard of it at its joints}",
        r"M_{ij} = S_i^T \left( (d_{ij} \cdot B_j)\, 1 - B_j\, d_{ij}^T \right) S_j "
        r"\text{ for two bodies on one path}",
    ),
}

_LIE = r"x_{n+1} = x_n \circ \exp\Big( h \sum_i b_i k_i \Big), \quad k_i = d\exp^{-1} u_i"
_ALPHA = (
    r"q_{n+1} = q_n \circ \Big( h u_n + h^2 \big( (\tfrac{1}{2} - \beta) a_n + \beta a_{n+1} \big) \Big), "
    r"\quad u_{n+1} = u_n + h \big( (1 - \gamma) a_n + \gamma a_{n+1} \big)",
    r"(1 - \alpha_m) a_{n+1} + \alpha_m a_n = (1 - \alpha_f) \dot u_{n+1} + \alpha_f \dot u_n",
)
# steps of the methods by their kernels, beside those that a table of coefficients says in full
STEPS: dict[str, tuple[str, ...]] = {
    "RKMK45": (_LIE,),
    "RKMK853": (_LIE,),
    "RKMK4": (_LIE,),
    "DOP853": (
        r"k_i = f\Big( t + c_i h, x + h \sum_{j < i} a_{ij} k_j \Big), \quad i = 1 \ldots 12, \quad "
        r"x_{n+1} = x_n + h \sum_i b_i k_i",
    ),
    "alpha": _ALPHA,
    "radau": (
        r"X_i = x_n + h \sum_{j=1}^{3} a_{ij} f(t_n + c_j h, X_j), \quad x_{n+1} = X_3, \quad "
        r"c = \Big( \tfrac{4 - \sqrt 6}{10}, \tfrac{4 + \sqrt 6}{10}, 1 \Big)",
    ),
    "rosenbrock": (
        r"\Big( \frac{1}{h \gamma} - J \Big) k_i = f\Big( t_n + c_i h, x_n + \sum_{j < i} a_{ij} k_j \Big) "
        r"+ \sum_{j < i} \frac{c_{ij}}{h} k_j + h d_i \frac{\partial f}{\partial t}, \quad "
        r"J = \frac{\partial f}{\partial x}",
    ),
    "midpoint": (
        r"x_{n+1} = x_n + h f\Big( t_n + \tfrac{h}{2}, \tfrac{x_n + x_{n+1}}{2} \Big), \quad "
        r"E_{n+1} - E_n = W \text{ (work of all that has no potential) imposed on the step}",
    ),
    "conserving": (
        r"M_{n+1/2} (u_{n+1} - u_n) / h = \text{forces averaged so that } V_{n+1} - V_n "
        r"= -\int f \cdot dq \text{ exactly}",
    ),
}
