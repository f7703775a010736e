/*
 * inverse_dynamics of reaching_arm
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 2, work 0, w 6
 * Operations per call: 29 = 16 mul, 8 add, 3 sub, 1 cos, 1 sin
 * Operations of prepare: 19 = 9 add, 8 mul, 2 sub
 *
 * Input q (2): generalized coordinates
 *   q[0]  shoulder [rad]
 *   q[1]  elbow [rad]
 *
 * Input u (2): generalized speeds
 *   u[0]  shoulder.u [rad/s]
 *   u[1]  elbow.u [rad/s]
 *
 * Input r (2): inputs of the model
 *   r[0]  shoulder_torque [N m]
 *   r[1]  elbow_torque [N m]
 *
 * Input p (12): parameters, read by prepare_ only
 *
 * Input udot (2): derivatives of the speeds
 *   udot[0]  shoulder.udot [rad/s^2]
 *   udot[1]  elbow.udot [rad/s^2]
 *
 * Output tau (2)
 *   out[0]  shoulder.u.tau [N*m]
 *   out[1]  elbow.u.tau [N*m]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* upper: first moment, mass, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal upper_mass = p[0]; /* kg */
    const wreal upper_com_x = p[1]; /* m */
    const wreal upper_inertia_yy = p[2]; /* kg m^2 */
    const wreal upper_inertia_zz = p[3]; /* kg m^2 */
    const wreal elbow_position_x = p[4]; /* m */
    const wreal lower_mass = p[5]; /* kg */
    const wreal upper_first_moment_x = upper_mass * upper_com_x;
    const wreal upper_com_x_times_first_moment_x = upper_com_x * upper_first_moment_x;
    const wreal upper_origin_inertia_yy = upper_inertia_yy + upper_com_x_times_first_moment_x;
    const wreal upper_origin_inertia_zz = upper_inertia_zz + upper_com_x_times_first_moment_x;
    const wreal upper_base_half_trace = 0.5 * (upper_origin_inertia_yy + upper_origin_inertia_zz);
    const wreal upper_base_second_moment_yy = upper_base_half_trace - upper_origin_inertia_yy;
    const wreal upper_base_second_moment_xx = elbow_position_x * lower_mass * elbow_position_x
        + upper_base_half_trace;
    const wreal upper_base_second_moment_yy_plus_base_second_moment_xx = upper_base_second_moment_yy
        + upper_base_second_moment_xx;
    w[4] = upper_base_second_moment_yy_plus_base_second_moment_xx;

    /* lower: first moment, mass, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal lower_com_x = p[6]; /* m */
    const wreal lower_inertia_yy = p[7]; /* kg m^2 */
    const wreal lower_inertia_zz = p[8]; /* kg m^2 */
    const wreal lower_first_moment_x = lower_mass * lower_com_x;
    const wreal lower_com_x_times_first_moment_x = lower_com_x * lower_first_moment_x;
    const wreal lower_origin_inertia_yy = lower_inertia_yy + lower_com_x_times_first_moment_x;
    const wreal lower_origin_inertia_zz = lower_inertia_zz + lower_com_x_times_first_moment_x;
    const wreal lower_base_second_moment_xx = 0.5 * (lower_origin_inertia_yy
        + lower_origin_inertia_zz);
    const wreal lower_base_second_moment_yy = lower_base_second_moment_xx - lower_origin_inertia_yy;
    const wreal lower_base_second_moment_xx_plus_base_second_moment_yy = lower_base_second_moment_xx
        + lower_base_second_moment_yy;
    w[1] = lower_first_moment_x;
    w[5] = lower_base_second_moment_xx_plus_base_second_moment_yy;

    /* parameters as they are */
    w[0] = p[4]; /* elbow.position.x [m] */
    w[2] = p[10]; /* shoulder_bearing.damping [N*m*s/rad] */
    w[3] = p[11]; /* elbow_bearing.damping [N*m*s/rad] */
}

#include "lanes.h"

/* tau with M udot + h = f + tau */
CARDAN_API int inverse_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const real *const r = in->r;
    const wreal *const w = in->w;
    const real *const udot = in->udot;
    (void)work;

    /* elbow: R */
    /* R = R_fixed R_joint(q) */
    const real elbow_q = q[1]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {elbow_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real elbow_cos = cosine[0];
    const real elbow_sin = sine[0];

    /* lower: omega, alpha, a, n, f */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real shoulder_u = u[0]; /* rad/s */
    const real elbow_u = u[1]; /* rad/s */
    const real shoulder_udot = udot[0]; /* rad/s^2 */
    const real elbow_udot = udot[1]; /* rad/s^2 */
    const wreal elbow_position_x = w[0]; /* m */
    const wreal lower_first_moment_x = w[1];
    const wreal lower_base_second_moment_xx_plus_base_second_moment_yy = w[5];
    const real lower_omega_z = shoulder_u + elbow_u;
    const real lower_alpha_z = shoulder_udot + elbow_udot;
    const real lower_a_y = shoulder_u * shoulder_u * elbow_position_x * elbow_sin
        + elbow_position_x * shoulder_udot * elbow_cos;
    const real lower_n_z = lower_alpha_z * lower_base_second_moment_xx_plus_base_second_moment_yy
        + lower_first_moment_x * lower_a_y;
    const real lower_f_y = lower_first_moment_x * lower_alpha_z;

    /* upper: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal upper_base_second_moment_yy_plus_base_second_moment_xx = w[4];
    const real upper_n_z = shoulder_udot * upper_base_second_moment_yy_plus_base_second_moment_xx
        + elbow_position_x * (elbow_cos * lower_f_y
        - lower_omega_z * lower_omega_z * lower_first_moment_x * elbow_sin) + lower_n_z;

    /* elbow: tau */
    /* tau = S . [n; f] - force on the joint */
    const real elbow_torque = r[1]; /* N m */
    const wreal elbow_bearing_damping = w[3]; /* N*m*s/rad */
    /* tau: elbow.u.tau [N*m] */
    out[1] = elbow_u * elbow_bearing_damping - elbow_torque + lower_n_z;

    /* shoulder: tau */
    /* tau = S . [n; f] - force on the joint */
    const real shoulder_torque = r[0]; /* N m */
    const wreal shoulder_bearing_damping = w[2]; /* N*m*s/rad */
    /* tau: shoulder.u.tau [N*m] */
    out[0] = shoulder_u * shoulder_bearing_damping - shoulder_torque + upper_n_z;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {2, 0, 6, 0, 2, 2, 0, 0, 2, 12, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
