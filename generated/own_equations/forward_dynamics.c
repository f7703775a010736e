/*
 * forward_dynamics of own_equations
 * udot with M udot + h = f + tau
 * formalism: composite
 * passes: unroll, reassociate
 *
 * Sizes: out 3, work 0, w 9
 * Operations per call: 101 = 59 mul, 18 add, 18 sub, 2 cos, 2 div, 2 sin
 * Operations of prepare: 22 = 20 mul, 1 add, 1 div
 *
 * Input q (3): generalized coordinates
 *   q[0]  x
 *   q[1]  q1
 *   q[2]  q2
 *
 * Input u (3): generalized speeds
 *   u[0]  v
 *   u[1]  u1
 *   u[2]  u2
 *
 * Input r (1): inputs of the model
 *   r[0]  F
 *
 * Input p (4): parameters, read by prepare_ only
 *
 * Input tau (3): applied generalized forces
 *   tau[0]  v.tau
 *   tau[1]  u1.tau
 *   tau[2]  u2.tau
 *
 * Output udot (3)
 *   out[0]  vdot
 *   out[1]  u1dot
 *   out[2]  u2dot
 */
#include "cardan.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* M */
    /* M = S . momentum */
    const wreal m = p[2];
    const wreal m_cart = p[3];
    const wreal M_equations_v_equations_v = m_cart + 2.0 * m;
    w[0] = M_equations_v_equations_v;

    /* common */
    const wreal g = p[0];
    const wreal l = p[1];
    const wreal m_times_l_times_c1p5 = 1.5 * l * m;
    const wreal m_times_half_l = 0.5 * l * m;
    const wreal l_squared = l * l;
    const wreal l_squared_times_half_m = 0.5 * m * l_squared;
    const wreal m_times_l_times_g_times_c1p5 = 1.5 * g * l * m;
    const wreal m_times_l_times_half_g = 0.5 * g * l * m;
    const wreal m_times_g_times_l = g * l * m;
    w[1] = m_times_l_times_c1p5;
    w[2] = m_times_half_l;
    w[4] = l_squared_times_half_m;
    w[5] = m_times_l_times_g_times_c1p5;
    w[6] = m_times_l_times_half_g;
    w[7] = m_times_g_times_l;

    /* M: factor */
    /* M = S . momentum */
    /* factor = L, D with M = Lᵀ D L */
    const wreal M_equations_u1_equations_u1 = 1.3333333333333333 * m * l_squared;
    const wreal M_equations_u2_equations_u2 = 0.3333333333333333 * m * l_squared;
    const wreal M_factor_D_inverse_equations_u2 = 1.0 / M_equations_u2_equations_u2;
    w[3] = M_equations_u1_equations_u1;
    w[8] = M_factor_D_inverse_equations_u2;
}

#include "lanes.h"

/* udot with M udot + h = f + tau */
CARDAN_API int forward_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const real *const r = in->r;
    const wreal *const w = in->w;
    const real *const tau = in->tau;
    (void)work;

    /* shared by several: output */
    const real q1_q = q[1];
    const real q2_q = q[2];
    const real angle[CARDAN_PADDED(2)] = {q1_q, q2_q};
    real sine[CARDAN_PADDED(2)], cosine[CARDAN_PADDED(2)];
    cardan_sincos(2, angle, sine, cosine);
    const real q1_cos = cosine[0];
    const real q2_cos = cosine[1];
    const real q1_sin = sine[0];
    const real q2_sin = sine[1];

    /* common */
    const real F = r[0];
    const real v_value = u[0];
    const real u1 = u[1];
    const real u2 = u[2];
    const wreal m_times_l_times_c1p5 = w[1];
    const wreal m_times_half_l = w[2];
    const wreal l_squared_times_half_m = w[4];
    const wreal m_times_l_times_g_times_c1p5 = w[5];
    const wreal m_times_l_times_half_g = w[6];
    const wreal m_times_g_times_l = w[7];
    const real M_minus_equations_u2_equations_v = q2_cos * m_times_half_l;
    const real u1_squared = u1 * u1;
    const real u2_squared = u2 * u2;
    const real equations_drive_v_part = F - m_times_l_times_c1p5 * u1_squared * q1_sin
        - m_times_half_l * u2_squared * q2_sin;
    const real q2_cos_times_q1_sin_minus_q1_cos_times_q2_sin = q2_cos * q1_sin - q1_cos * q2_sin;
    const real equations_drive_u1_part = q1_sin * m_times_l_times_g_times_c1p5
        - l_squared_times_half_m * u2_squared * q2_cos_times_q1_sin_minus_q1_cos_times_q2_sin;
    const real equations_drive_u2_part = q2_sin * m_times_l_times_half_g
        + l_squared_times_half_m * u1_squared * q2_cos_times_q1_sin_minus_q1_cos_times_q2_sin;
    const real u1_times_q1_sin = u1 * q1_sin;
    const real m_times_l_times_c1p5_times_u1_times_q1_sin = m_times_l_times_c1p5 * u1_times_q1_sin;
    const real u2_times_q2_sin = u2 * q2_sin;
    const real m_times_half_l_times_u2_times_q2_sin = m_times_half_l * u2_times_q2_sin;
    const real equations_drive_u1_part_2 = l_squared_times_half_m * (u1 * q1_cos * q2_sin
        + u2 * q2_cos * q1_sin - (q2_cos * u1_times_q1_sin + q1_cos * u2_times_q2_sin));
    const real equations_drive_v_part_2 = equations_drive_v_part
        + 0.5 * (u1 * m_times_l_times_c1p5_times_u1_times_q1_sin
        + u2 * m_times_half_l_times_u2_times_q2_sin);
    const real equations_drive_u1_part_3 = equations_drive_u1_part
        - 1.5 * q1_sin * m_times_g_times_l
        + 0.5 * (v_value * m_times_l_times_c1p5_times_u1_times_q1_sin
        + u2 * equations_drive_u1_part_2);
    const real equations_drive_u2_part_2 = equations_drive_u2_part
        - 0.5 * q2_sin * m_times_g_times_l
        + 0.5 * (v_value * m_times_half_l_times_u2_times_q2_sin + u1 * equations_drive_u1_part_2);

    /* M: factor */
    /* M = S . momentum */
    /* factor = L, D with M = Lᵀ D L */
    const wreal M_equations_v_equations_v = w[0];
    const wreal M_equations_u1_equations_u1 = w[3];
    const wreal M_factor_D_inverse_equations_u2 = w[8];
    const real M_equations_u2_equations_u1 = (q1_cos * q2_cos
        + q1_sin * q2_sin) * l_squared_times_half_m;
    const real M_factor_L_equations_u2_equations_u1 = M_equations_u2_equations_u1 *
        M_factor_D_inverse_equations_u2;
    const real M_factor_DL_equations_u1_equations_v = M_minus_equations_u2_equations_v *
        M_factor_L_equations_u2_equations_u1 - q1_cos * m_times_l_times_c1p5;
    const real M_minus_factor_L_equations_u2_equations_v = M_minus_equations_u2_equations_v *
        M_factor_D_inverse_equations_u2;
    const real M_factor_D_inverse_equations_u1 = 1.0 / (M_equations_u1_equations_u1
        - M_equations_u2_equations_u1 * M_factor_L_equations_u2_equations_u1);
    const real M_factor_L_equations_u1_equations_v = M_factor_DL_equations_u1_equations_v *
        M_factor_D_inverse_equations_u1;
    const real M_factor_D_inverse_equations_v = 1.0 / (M_equations_v_equations_v
        - M_minus_equations_u2_equations_v * M_minus_factor_L_equations_u2_equations_v
        - M_factor_DL_equations_u1_equations_v * M_factor_L_equations_u1_equations_v);

    /* equations: drive */
    /* drive = tau + f - h */
    const real v_tau = tau[0];
    const real u1_tau = tau[1];
    const real u2_tau = tau[2];
    const real equations_drive_v = equations_drive_v_part + v_tau + equations_drive_v_part_2
        - equations_drive_v_part_2;
    const real equations_drive_u1 = equations_drive_u1_part + u1_tau + equations_drive_u1_part_3
        - equations_drive_u1_part_3;
    const real equations_drive_u2 = equations_drive_u2_part + u2_tau + equations_drive_u2_part_2
        - equations_drive_u2_part_2;

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const real M_y_equations_u1 = equations_drive_u1
        - equations_drive_u2 * M_factor_L_equations_u2_equations_u1;

    /* equations: udot */
    /* udot = M⁻¹ drive */
    const real equations_udot_v = M_factor_D_inverse_equations_v * (equations_drive_v
        + equations_drive_u2 * M_minus_factor_L_equations_u2_equations_v
        - M_factor_L_equations_u1_equations_v * M_y_equations_u1);
    const real equations_udot_u1 = M_factor_D_inverse_equations_u1 * M_y_equations_u1
        - M_factor_L_equations_u1_equations_v * equations_udot_v;
    out[0] = equations_udot_v; /* udot: vdot */
    out[1] = equations_udot_u1; /* udot: u1dot */
    /* udot: u2dot */
    out[2] = equations_drive_u2 * M_factor_D_inverse_equations_u2
        + M_minus_factor_L_equations_u2_equations_v * equations_udot_v
        - M_factor_L_equations_u2_equations_u1 * equations_udot_u1;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {3, 0, 9, 0, 3, 3, 0, 0, 1, 4, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0};
#endif
