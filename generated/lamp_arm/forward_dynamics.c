/*
 * forward_dynamics of lamp_arm
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 2, work 5, w 8
 * Operations per call: 56 = 30 mul, 9 add, 8 sub, 2 cos, 2 sin, 1 div, 1 eq, 1 neg, 1 select,
 *     1 solve
 * Operations of prepare: 12 = 6 mul, 5 add, 1 div
 *
 * Input q (2): generalized coordinates
 *   q[0]  shoulder [rad]
 *   q[1]  elbow [rad]
 *
 * Input u (2): generalized speeds
 *   u[0]  shoulder.u [rad/s]
 *   u[1]  elbow.u [rad/s]
 *
 * Input s (1): discrete states
 *   s[0]  stop
 *
 * Input r (1): inputs of the model
 *   r[0]  torque
 *
 * Input p (15): parameters, read by prepare_ only
 *
 * Input tau (2): applied generalized forces
 *   tau[0]  shoulder.u.tau [N*m]
 *   tau[1]  elbow.u.tau [N*m]
 *
 * Output udot (2)
 *   out[0]  shoulder.udot [rad/s^2]
 *   out[1]  elbow.udot [rad/s^2]
 */
#include "cardan.h"
#include "solve.h"
#include "dependent.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* upper: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal upper_mass = p[1]; /* kg */
    const wreal upper_com_z = p[2]; /* m */
    const wreal upper_inertia_yy = p[4]; /* kg m^2 */
    const wreal upper_first_moment_z = upper_mass * upper_com_z;
    const wreal upper_origin_inertia_yy = upper_inertia_yy + upper_com_z * upper_first_moment_z;

    /* lower: first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal elbow_position_z = p[5]; /* m */
    const wreal lower_mass = p[6]; /* kg */
    const wreal lower_com_z = p[7]; /* m */
    const wreal lower_inertia_yy = p[9]; /* kg m^2 */
    const wreal lower_first_moment_z = lower_mass * lower_com_z;
    const wreal lower_origin_inertia_yy = lower_inertia_yy + lower_com_z * lower_first_moment_z;
    const wreal lower_base_mass_moment_z = elbow_position_z * lower_mass;
    w[2] = lower_first_moment_z;
    w[3] = lower_origin_inertia_yy;

    /* upper: base, inertia */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal upper_base_moment_z = upper_first_moment_z + lower_base_mass_moment_z;
    const wreal upper_base_inertia_yy = upper_origin_inertia_yy
        + elbow_position_z * lower_base_mass_moment_z;
    const wreal lower_origin_inertia_yy_plus_upper_base_inertia_yy = lower_origin_inertia_yy
        + upper_base_inertia_yy;
    w[5] = upper_base_moment_z;
    w[6] = lower_origin_inertia_yy_plus_upper_base_inertia_yy;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal M_factor_D_inverse_elbow = 1.0 / lower_origin_inertia_yy;
    w[7] = M_factor_D_inverse_elbow;

    /* parameters as they are */
    w[0] = p[0]; /* gravity.z [m/s^2] */
    w[1] = p[5]; /* elbow.position.z [m] */
    w[4] = p[11]; /* friction.damping [N*m*s/rad] */
}

#include "lanes.h"

/* udot with M udot + h = f + tau */
CARDAN_API int forward_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const real *const s = in->s;
    const real *const r = in->r;
    const wreal *const w = in->w;
    const real *const tau = in->tau;
    real *const circuit_matrix = work + 0;
    real *const circuit_right = work + 1;
    real *const circuit_scratch = work + 2;
    int status = CARDAN_OK;

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
    const real shoulder_q = q[0]; /* rad */
    const real elbow_q = q[1]; /* rad */
    const real angle[CARDAN_PADDED(2)] = {elbow_q, shoulder_q};
    real sine[CARDAN_PADDED(2)], cosine[CARDAN_PADDED(2)];
    cardan_sincos(2, angle, sine, cosine);
    const real elbow_cos = cosine[0];
    const real elbow_sin = sine[0];
    const real shoulder_cos = cosine[1];
    const real shoulder_sin = sine[1];

    /* shared by several: inertia */
    const wreal elbow_position_z = w[1]; /* m */
    const wreal lower_first_moment_z = w[2];
    const real elbow_position_z_times_upper_inertia_mean_moment_z = lower_first_moment_z * elbow_cos
        * elbow_position_z;

    /* upper: composite, a */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const wreal lower_origin_inertia_yy_plus_upper_base_inertia_yy = w[6];
    const real upper_composite_inertia_yy = 2.0 * elbow_position_z_times_upper_inertia_mean_moment_z
        + lower_origin_inertia_yy_plus_upper_base_inertia_yy;
    const real upper_a_x = gravity_z * shoulder_sin;

    /* M */
    /* M = S . momentum */
    const wreal lower_origin_inertia_yy = w[3];
    const real M_elbow_shoulder = lower_origin_inertia_yy
        + elbow_position_z_times_upper_inertia_mean_moment_z;

    /* lower: omega, a, n */
    /* omega = Rᵀ omega_parent + S_w u */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real shoulder_u = u[0]; /* rad/s */
    const real elbow_u = u[1]; /* rad/s */
    const real lower_omega_y = shoulder_u + elbow_u;
    const real lower_a_x = elbow_cos * upper_a_x + elbow_sin * (gravity_z * shoulder_cos
        + shoulder_u * shoulder_u * elbow_position_z);
    const real lower_n_y = lower_first_moment_z * lower_a_x;

    /* upper: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal upper_base_moment_z = w[5];
    const real upper_n_y = upper_base_moment_z * upper_a_x
        - lower_omega_y * lower_omega_y * lower_first_moment_z * elbow_sin * elbow_position_z
        + lower_n_y;

    /* shoulder: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real torque = r[0];
    const real shoulder_u_tau = tau[0]; /* N*m */
    const wreal friction_damping = w[4]; /* N*m*s/rad */
    const real shoulder_tau = shoulder_u * friction_damping - torque + upper_n_y;
    const real shoulder_drive = shoulder_u_tau - shoulder_tau;

    /* elbow: drive */
    /* drive = tau + f - h */
    const real elbow_u_tau = tau[1]; /* N*m */
    const real elbow_drive = elbow_u_tau - lower_n_y;

    /* stop: G */
    /* G = d(rate) / du */
    const real stop = s[0];
    const real stop_G_stop_elbow = cardan_select(cardan_eq(0.0, stop), 0.0, 1.0);

    /* constraints: factor, multipliers */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const wreal M_factor_D_inverse_elbow = w[7];
    const real M_factor_L_elbow_shoulder = M_elbow_shoulder * M_factor_D_inverse_elbow;
    const real M_factor_D_inverse_shoulder = 1.0 / (upper_composite_inertia_yy
        - M_elbow_shoulder * M_factor_L_elbow_shoulder);
    const real free_udot_shoulder = M_factor_D_inverse_shoulder * (shoulder_drive
        - elbow_drive * M_factor_L_elbow_shoulder);
    const real free_udot_elbow = elbow_drive * M_factor_D_inverse_elbow
        - M_factor_L_elbow_shoulder * free_udot_shoulder;
    const real stop_stop_minus_response_shoulder = stop_G_stop_elbow * M_factor_L_elbow_shoulder *
        M_factor_D_inverse_shoulder;
    const real stop_stop_response_elbow = stop_G_stop_elbow * M_factor_D_inverse_elbow
        + M_factor_L_elbow_shoulder * stop_stop_minus_response_shoulder;
    const real circuit_stop_stop_stop_stop = stop_G_stop_elbow * stop_stop_response_elbow;
    circuit_matrix[0] = circuit_stop_stop_stop_stop;
    const real free_gamma_stop_stop = -stop_G_stop_elbow * free_udot_elbow;
    circuit_right[0] = free_gamma_stop_stop;
    /* circuit_matrix lam = circuit_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 1, 1, circuit_matrix, circuit_right, circuit_scratch);

    /* stop: multiplier stop */
    const real stop_multiplier_stop = circuit_right[0];

    /* shoulder: udot */
    /* udot = free_udot + response multipliers */
    /* udot: shoulder.udot [rad/s^2] */
    out[0] = free_udot_shoulder - stop_stop_minus_response_shoulder * stop_multiplier_stop;

    /* elbow: udot */
    /* udot = free_udot + response multipliers */
    /* udot: elbow.udot [rad/s^2] */
    out[1] = free_udot_elbow + stop_stop_response_elbow * stop_multiplier_stop;
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {2, 5, 8, 0, 2, 2, 0, 1, 1, 15, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0};
#endif
