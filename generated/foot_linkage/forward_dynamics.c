/*
 * forward_dynamics of foot_linkage
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: parallel, base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 2, work 13, w 6
 * Operations per call: 160 = 95 mul, 30 add, 28 sub, 3 cos, 3 sin, 1 solve
 * Operations of prepare: 2 = 2 div
 *
 * Input t (1): time
 *   t[0]  t [s]
 *
 * Input q (2): generalized coordinates
 *   q[0]  B [rad]
 *   q[1]  D [rad]
 *
 * Input u (2): generalized speeds
 *   u[0]  B.u [rad/s]
 *   u[1]  D.u [rad/s]
 *
 * Input p (22): parameters, read by prepare_ only
 *
 * Input tau (2): applied generalized forces
 *   tau[0]  B.u.tau [N*m]
 *   tau[1]  D.u.tau [N*m]
 *
 * Output udot (2)
 *   out[0]  B.udot [rad/s^2]
 *   out[1]  D.udot [rad/s^2]
 */
#include "cardan.h"
#include "solve.h"
#include "dependent.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal coupler_link_inertia_zz = p[17]; /* kg m^2 */
    const wreal rocker_link_inertia_zz = p[21]; /* kg m^2 */
    const wreal M_factor_D_inverse_D = 1.0 / rocker_link_inertia_zz;
    const wreal M_factor_D_inverse_B = 1.0 / coupler_link_inertia_zz;
    w[4] = M_factor_D_inverse_D;
    w[5] = M_factor_D_inverse_B;

    /* parameters as they are */
    w[0] = p[0]; /* crank [m] */
    w[1] = p[2]; /* rocker [m] */
    w[2] = p[3]; /* ground [m] */
    w[3] = p[9]; /* phase [rad] */
}

#include "lanes.h"

/* udot with M udot + h = f + tau */
CARDAN_API int forward_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const t = in->t;
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    const real *const tau = in->tau;
    real (*const circuit_matrix)[2] = (real (*)[2])(work + 0);
    real *const circuit_right = work + 4;
    real *const circuit_scratch = work + 6;
    int status = CARDAN_OK;

    /* shared by several: motion, R */
    /* R = R_fixed R_joint(q) */
    const real B_q = q[0]; /* rad */
    const real D_q = q[1]; /* rad */
    const real t_value = t[0]; /* s */
    const wreal phase = w[3]; /* rad */
    const real A_turn = phase + 6.283185307179586 * t_value;
    const real B_turn = B_q + A_turn;
    const real angle[CARDAN_PADDED(3)] = {A_turn, B_turn, D_q};
    real sine[CARDAN_PADDED(3)], cosine[CARDAN_PADDED(3)];
    cardan_sincos(3, angle, sine, cosine);
    const real A_turn_cos = cosine[0];
    const real A_turn_sin = sine[0];
    const real B_turn_cos = cosine[1];
    const real B_turn_sin = sine[1];
    const real D_cos = cosine[2];
    const real D_sin = sine[2];

    /* B: p */
    /* p = p_fixed + R_fixed p_joint(q) */
    const wreal crank = w[0]; /* m */
    const real B_p_x = crank * A_turn_cos;
    const real B_p_y = crank * A_turn_sin;

    /* C: pose, twist, G */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* G = d(rate) / du */
    const real B_u = u[0]; /* rad/s */
    const real D_u = u[1]; /* rad/s */
    const wreal rocker = w[1]; /* m */
    const wreal ground = w[2]; /* m */
    const real C_child_p_y = rocker * D_sin;
    const real C_child_p_x = ground + rocker * D_cos;
    const real C_R_xx = B_turn_cos * D_cos + B_turn_sin * D_sin;
    const real C_R_xy = B_turn_sin * D_cos - B_turn_cos * D_sin;
    const real C_arm_B_x = C_child_p_x - B_p_x;
    const real C_arm_B_y = C_child_p_y - B_p_y;
    const real C_arm_D_x = C_child_p_x - ground;
    const real C_base_twist_vx = 6.283185307179586 * C_child_p_y - D_u * C_child_p_y
        + B_u * C_arm_B_y;
    const real C_base_twist_vy = D_u * C_arm_D_x - 6.283185307179586 * C_child_p_x
        - B_u * C_arm_B_x;
    const real C_twist_B_vx = D_cos * C_arm_B_y - D_sin * C_arm_B_x;
    const real C_minus_twist_B_vy = D_sin * C_arm_B_y + D_cos * C_arm_B_x;
    const real C_twist_D_vx = D_sin * C_arm_D_x - D_cos * C_child_p_y;
    const real C_twist_D_vy = D_sin * C_child_p_y + D_cos * C_arm_D_x;
    const real C_twist_vx = D_cos * C_base_twist_vx + D_sin * C_base_twist_vy;
    const real C_twist_vy = D_cos * C_base_twist_vy - D_sin * C_base_twist_vx;
    const real C_G_px_B = C_R_xx * C_twist_B_vx - C_R_xy * C_minus_twist_B_vy;
    const real C_G_px_D = C_R_xx * C_twist_D_vx + C_R_xy * C_twist_D_vy;
    const real C_minus_G_py_B = C_R_xy * C_twist_B_vx + C_R_xx * C_minus_twist_B_vy;
    const real C_G_py_D = C_R_xx * C_twist_D_vy - C_R_xy * C_twist_D_vx;

    /* coupler_link: omega */
    /* omega = Rᵀ omega_parent + S_w u */
    const real coupler_link_omega_z = B_u + 6.283185307179586;

    /* B: R */
    /* R = R_fixed R_joint(q) */
    const real B_turn_sin_times_coupler_link_omega_z = B_turn_sin * coupler_link_omega_z;
    const real B_turn_cos_times_coupler_link_omega_z = B_turn_cos * coupler_link_omega_z;

    /* D: R */
    /* R = R_fixed R_joint(q) */
    const real D_u_times_sin = D_u * D_sin;
    const real D_u_times_cos = D_u * D_cos;

    /* C: pose, twist, gamma */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* gamma = -d(rate)/dt at udot = 0 */
    const real C_minus_child_p_x_rate = rocker * D_u_times_sin;
    const real C_child_p_y_rate = rocker * D_u_times_cos;
    const real C_R_xx_rate = B_turn_sin * D_u_times_cos - B_turn_cos * D_u_times_sin
        + (D_sin * B_turn_cos_times_coupler_link_omega_z
        - D_cos * B_turn_sin_times_coupler_link_omega_z);
    const real C_R_xy_rate = D_sin * B_turn_sin_times_coupler_link_omega_z
        + D_cos * B_turn_cos_times_coupler_link_omega_z - (B_turn_cos * D_u_times_cos
        + B_turn_sin * D_u_times_sin);
    const real C_base_twist_vx_rate = 6.283185307179586 * C_child_p_y_rate
        - D_u * C_child_p_y_rate + B_u * (C_child_p_y_rate
        - 6.283185307179586 * A_turn_cos * crank);
    const real C_minus_base_twist_vy_rate = D_u * C_minus_child_p_x_rate
        - 6.283185307179586 * C_minus_child_p_x_rate
        + B_u * (6.283185307179586 * A_turn_sin * crank - C_minus_child_p_x_rate);
    const real C_twist_vx_rate = C_base_twist_vy * D_u_times_cos
        - C_base_twist_vx * D_u_times_sin + (D_cos * C_base_twist_vx_rate
        - D_sin * C_minus_base_twist_vy_rate);
    const real C_minus_twist_vy_rate = C_base_twist_vx * D_u_times_cos
        + C_base_twist_vy * D_u_times_sin + (D_sin * C_base_twist_vx_rate
        + D_cos * C_minus_base_twist_vy_rate);
    const real C_gamma_px = C_R_xy * C_minus_twist_vy_rate - (C_twist_vx * C_R_xx_rate
        + C_twist_vy * C_R_xy_rate) - C_R_xx * C_twist_vx_rate;
    const real C_gamma_py = C_twist_vx * C_R_xy_rate - C_twist_vy * C_R_xx_rate
        + C_R_xy * C_twist_vx_rate + C_R_xx * C_minus_twist_vy_rate;

    /* constraints: factor, multipliers */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const real B_u_tau = tau[0]; /* N*m */
    const real D_u_tau = tau[1]; /* N*m */
    const wreal M_factor_D_inverse_D = w[4];
    const wreal M_factor_D_inverse_B = w[5];
    const real free_udot_B = B_u_tau * M_factor_D_inverse_B;
    const real free_udot_D = D_u_tau * M_factor_D_inverse_D;
    const real C_px_response_B = C_G_px_B * M_factor_D_inverse_B;
    const real C_px_response_D = C_G_px_D * M_factor_D_inverse_D;
    const real C_py_minus_response_B = C_minus_G_py_B * M_factor_D_inverse_B;
    const real C_py_response_D = C_G_py_D * M_factor_D_inverse_D;
    const real circuit_C_px_C_px = C_G_px_B * C_px_response_B + C_G_px_D * C_px_response_D;
    circuit_matrix[0][0] = circuit_C_px_C_px;
    const real circuit_C_py_C_px = C_G_py_D * C_px_response_D - C_minus_G_py_B * C_px_response_B;
    circuit_matrix[0][1] = circuit_C_py_C_px;
    circuit_matrix[1][0] = circuit_C_py_C_px;
    const real circuit_C_py_C_py = C_minus_G_py_B * C_py_minus_response_B
        + C_G_py_D * C_py_response_D;
    circuit_matrix[1][1] = circuit_C_py_C_py;
    const real free_gamma_C_px = C_gamma_px - (C_G_px_B * free_udot_B + C_G_px_D * free_udot_D);
    circuit_right[0] = free_gamma_C_px;
    const real free_gamma_C_py = C_minus_G_py_B * free_udot_B - C_G_py_D * free_udot_D + C_gamma_py;
    circuit_right[1] = free_gamma_C_py;
    /* circuit_matrix lam = circuit_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 2, 1, circuit_matrix[0], circuit_right, circuit_scratch);

    /* C: multiplier px, multiplier py */
    const real C_multiplier_px = circuit_right[0];
    const real C_multiplier_py = circuit_right[1];

    /* B: udot */
    /* udot = free_udot + response multipliers */
    /* udot: B.udot [rad/s^2] */
    out[0] = free_udot_B + C_px_response_B * C_multiplier_px
        - C_py_minus_response_B * C_multiplier_py;

    /* D: udot */
    /* udot = free_udot + response multipliers */
    /* udot: D.udot [rad/s^2] */
    out[1] = free_udot_D + C_px_response_D * C_multiplier_px + C_py_response_D * C_multiplier_py;
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {2, 13, 6, 1, 2, 2, 0, 0, 0, 22, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0};
#endif
