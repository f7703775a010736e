/*
 * inverse_dynamics of arm_on_path
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 2, work 0, w 6
 * Operations per call: 85 = 44 mul, 23 add, 9 sub, 5 cos, 4 sin
 * Operations of prepare: 27 = 13 add, 10 mul, 4 sub
 *
 * Input t (1): time
 *   t[0]  t [s]
 *
 * Input q (2): generalized coordinates
 *   q[0]  shoulder [rad]
 *   q[1]  elbow [rad]
 *
 * Input u (2): generalized speeds
 *   u[0]  shoulder.u [rad/s]
 *   u[1]  elbow.u [rad/s]
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
    /* upper: first moment, mass, inertia, base moment */
    const wreal upper_mass = p[1]; /* kg */
    const wreal upper_com_x = p[2]; /* m */
    const wreal upper_inertia_yy = p[4]; /* kg m^2 */
    const wreal upper_inertia_zz = p[5]; /* kg m^2 */
    const wreal elbow_position_x = p[6]; /* m */
    const wreal lower_mass = p[7]; /* kg */
    const wreal upper_first_moment_x = upper_mass * upper_com_x;
    const wreal upper_mass_2 = upper_com_x * upper_first_moment_x;
    const wreal upper_inertia_yy_2 = upper_inertia_yy + upper_mass_2;
    const wreal upper_inertia_zz_2 = upper_inertia_zz + upper_mass_2;
    w[3] = upper_first_moment_x + elbow_position_x * lower_mass; /* upper_base_moment_x */

    /* lower: first moment, mass, inertia, base */
    const wreal lower_com_x = p[8]; /* m */
    const wreal lower_inertia_yy = p[10]; /* kg m^2 */
    const wreal lower_inertia_zz = p[11]; /* kg m^2 */
    const wreal lower_first_moment_x = lower_mass * lower_com_x;
    const wreal lower_mass_2 = lower_com_x * lower_first_moment_x;
    const wreal lower_inertia_yy_2 = lower_inertia_yy + lower_mass_2;
    const wreal lower_inertia_zz_2 = lower_inertia_zz + lower_mass_2;
    const wreal lower_base = 0.5 * lower_mass * elbow_position_x * elbow_position_x;
    w[2] = lower_first_moment_x; /* lower_first_moment_x */

    /* common */
    const wreal upper_inertia_xx = p[3]; /* kg m^2 */
    const wreal lower_inertia_xx = p[9]; /* kg m^2 */
    const wreal mul_1 = 0.5 * (upper_inertia_xx + upper_inertia_zz_2 + upper_inertia_yy_2);
    const wreal mul_1_2 = 0.5 * (lower_inertia_xx + lower_inertia_zz_2 + lower_inertia_yy_2);

    /* upper: base second moment, inertia force */
    const wreal upper_base_second_moment_zz = mul_1 - upper_inertia_zz_2;
    const wreal upper_base_second_moment_xx = mul_1 - upper_inertia_xx + (lower_base + lower_base);
    w[4] = upper_base_second_moment_zz + upper_base_second_moment_xx; /* upper_inertia_force */

    /* lower: base second moment, inertia force */
    const wreal lower_base_second_moment_xx = mul_1_2 - lower_inertia_xx;
    const wreal lower_base_second_moment_zz = mul_1_2 - lower_inertia_zz_2;
    w[5] = lower_base_second_moment_xx + lower_base_second_moment_zz; /* lower_inertia_force */

    /* parameters as they are */
    w[0] = p[0]; /* gravity.z [m/s^2] */
    w[1] = p[6]; /* elbow.position.x [m] */
}

#include "lanes.h"

/* tau with M udot + h = f + tau */
CARDAN_API int inverse_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const t = in->t;
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    const real *const udot = in->udot;
    (void)work;

    /* shared by several: data, cos, sin */
    const real shoulder_q = q[0]; /* rad */
    const real elbow_q = q[1]; /* rad */
    const real t_1 = t[0]; /* s */
    const real shoulder_motor_data = 1.3 * t_1;
    const real shoulder_motor_data_2 = 2.1 * t_1;
    const real angle[CARDAN_PADDED(5)] = {shoulder_q
        + elbow_q, shoulder_q, elbow_q, shoulder_motor_data, shoulder_motor_data_2};
    real sine[CARDAN_PADDED(5)], cosine[CARDAN_PADDED(5)];
    cardan_sincos(5, angle, sine, cosine);
    const real shoulder_motor_data_3 = cosine[0];
    const real shoulder_cos = cosine[1];
    const real elbow_cos = cosine[2];
    const real shoulder_motor_data_4 = cosine[3];
    const real shoulder_motor_data_5 = sine[3];
    const real shoulder_motor_data_6 = cosine[4];
    const real shoulder_motor_data_7 = sine[4];
    const real elbow_sin = sine[2];
    const real shoulder_sin = sine[1];

    /* shared by several: data, U */
    const real shoulder_u = u[0]; /* rad/s */
    const real shoulder_motor_data_8 = 2.9430000000000005 * shoulder_motor_data_3;
    const real shoulder_motor_data_9 = 12.48 * shoulder_motor_data_4 - (12.0 * shoulder_u
        + 36.0 * shoulder_q) + 27.448 * shoulder_motor_data_5;
    const real shoulder_motor_data_10 = 0.09000000000000001 + 0.15000000000000002 * elbow_cos;
    const real upper_U = shoulder_u * shoulder_u;

    /* upper: a */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const real upper_a = gravity_z * shoulder_cos;
    const real upper_a_x = gravity_z * shoulder_sin;

    /* shoulder_motor: data */
    const real elbow_u = u[1]; /* rad/s */
    const real shoulder_motor_data_11 = 12.0 * elbow_u + 36.0 * elbow_q
        + 18.953999999999997 * shoulder_motor_data_7 + 15.120000000000001 * shoulder_motor_data_6;

    /* shoulder: tau */
    const real shoulder_tau = 14.715 * shoulder_cos + 0.15000000000000002 * elbow_u * (elbow_u
        + 2.0 * shoulder_u) * elbow_sin + shoulder_motor_data_8;
    const real shoulder_tau_2 = shoulder_tau - (0.7225000000000001
        + 0.30000000000000004 * elbow_cos) * shoulder_motor_data_9;

    /* elbow: tau */
    const real elbow_tau = 1.08 * elbow_u + 3.24 * elbow_q
        - 0.15000000000000002 * upper_U * elbow_sin + 1.3608000000000002 * shoulder_motor_data_6;

    /* lower: omega, alpha, a, n, f */
    const real shoulder_udot = udot[0]; /* rad/s^2 */
    const real elbow_udot = udot[1]; /* rad/s^2 */
    const wreal elbow_position_x = w[1]; /* m */
    const wreal lower_first_moment_x = w[2];
    const wreal lower_inertia_force = w[5];
    const real lower_omega_y = shoulder_u + elbow_u;
    const real lower_alpha_y = shoulder_udot + elbow_udot;
    const real lower_a_z = elbow_sin * (upper_a_x - elbow_position_x * upper_U)
        - elbow_cos * (upper_a + elbow_position_x * shoulder_udot);
    const real lower_n_y = lower_alpha_y * lower_inertia_force - lower_first_moment_x * lower_a_z;
    const real lower_f = lower_omega_y * lower_omega_y * lower_first_moment_x * elbow_sin
        - lower_first_moment_x * lower_alpha_y * elbow_cos;

    /* upper: n */
    const wreal upper_base_moment_x = w[3];
    const wreal upper_inertia_force = w[4];
    const real upper_n_y = shoulder_udot * upper_inertia_force + upper_base_moment_x * upper_a
        - elbow_position_x * lower_f + lower_n_y;

    /* elbow: tau */
    /* tau: elbow.u.tau [N*m] */
    out[1] = shoulder_motor_data_8 + 1.70586 * shoulder_motor_data_7 + elbow_tau
        - shoulder_motor_data_9 * shoulder_motor_data_10 + lower_n_y;

    /* shoulder: tau */
    /* tau: shoulder.u.tau [N*m] */
    out[0] = shoulder_motor_data_10 * shoulder_motor_data_11 + shoulder_tau_2 + upper_n_y;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {2, 0, 6, 1, 2, 2, 0, 0, 0, 12, 0, 2, 0, 0, 0, 0, 0, 0, 0};
#endif
