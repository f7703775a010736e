/*
 * forward_dynamics of double_pendulum
 * udot with M udot + h = f + tau
 * formalism: composite
 * passes: unroll, reassociate
 *
 * Sizes: out 2, work 0, w 8
 * Operations per call: 48 = 27 mul, 11 add, 5 sub, 2 cos, 2 sin, 1 div
 * Operations of prepare: 11 = 8 mul, 2 add, 1 div
 *
 * Input q (2): generalized coordinates
 *   q[0]  shoulder [rad]
 *   q[1]  elbow [rad]
 *
 * Input u (2): generalized speeds
 *   u[0]  shoulder.u [rad/s]
 *   u[1]  elbow.u [rad/s]
 *
 * Input p (3): parameters, read by prepare_ only
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

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* shared by several: mass */
    const wreal m = p[0]; /* kg */
    const wreal l = p[1]; /* m */
    const wreal upper_mass_2 = 0.5 * l;
    const wreal upper_mass = m * upper_mass_2;
    w[3] = upper_mass; /* upper_mass */

    /* upper: inertia */
    const wreal upper_inertia_xx = l * l * (0.08333333333333333 * m) + upper_mass_2 * upper_mass;
    w[4] = upper_inertia_xx; /* upper_inertia_xx */
    w[5] = 0.5 * m * l; /* upper_inertia */
    w[6] = upper_inertia_xx + upper_inertia_xx; /* upper_inertia_2 */

    /* M: D inverse */
    w[7] = 1.0 / upper_inertia_xx; /* M_D_inverse_2 */

    /* parameters as they are */
    w[0] = p[0]; /* m [kg] */
    w[1] = p[1]; /* l [m] */
    w[2] = p[2]; /* gravity.z [m/s^2] */
}

#include "lanes.h"

/* udot with M udot + h = f + tau */
CARDAN_API int forward_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    const real *const tau = in->tau;
    (void)work;

    /* shared by several: cos, sin */
    const real shoulder_q = q[0]; /* rad */
    const real elbow_q = q[1]; /* rad */
    const real angle[CARDAN_PADDED(2)] = {shoulder_q, elbow_q};
    real sine[CARDAN_PADDED(2)], cosine[CARDAN_PADDED(2)];
    cardan_sincos(2, angle, sine, cosine);
    const real shoulder_cos = cosine[0];
    const real shoulder_sin = sine[0];
    const real elbow_cos = cosine[1];
    const real elbow_sin = sine[1];

    /* shared by several: inertia */
    const wreal upper_mass = w[3];
    const real upper_inertia_3 = upper_mass * elbow_cos;

    /* upper: composite inertia, a */
    const wreal l = w[1]; /* m */
    const wreal gravity_z = w[2]; /* m/s^2 */
    const wreal upper_inertia = w[5];
    const wreal upper_inertia_2 = w[6];
    const real upper_composite_inertia_yy = l * (upper_inertia_3 + upper_inertia) * 2.0
        + upper_inertia_2;
    const real upper_a_x = gravity_z * shoulder_sin;

    /* M: L, D inverse */
    const wreal upper_inertia_xx = w[4];
    const wreal M_D_inverse_2 = w[7];
    const real M_2_1 = upper_inertia_xx + l * upper_inertia_3;
    const real M_L_2_1 = M_2_1 * M_D_inverse_2;
    const real M_D_inverse_1 = 1.0 / (upper_composite_inertia_yy - M_2_1 * M_L_2_1);

    /* lower: omega, a, inertia force, f */
    const real shoulder_u = u[0]; /* rad/s */
    const real elbow_u = u[1]; /* rad/s */
    const wreal m = w[0]; /* kg */
    const real lower_omega_y = shoulder_u + elbow_u;
    const real lower_a = shoulder_u * shoulder_u * l - gravity_z * shoulder_cos;
    const real lower_a_x = elbow_cos * upper_a_x - elbow_sin * lower_a;
    const real lower_a_z = elbow_sin * upper_a_x + elbow_cos * lower_a;
    const real lower_inertia_force = upper_mass * lower_a_x;
    const real lower_f_x = m * lower_a_x;
    const real lower_f_z = m * lower_a_z + lower_omega_y * lower_omega_y * upper_mass;

    /* shoulder: drive */
    const real shoulder_u_tau = tau[0]; /* N*m */
    const real shoulder_drive = shoulder_u_tau + upper_mass * upper_a_x + lower_inertia_force
        + l * (elbow_cos * lower_f_x + elbow_sin * lower_f_z);

    /* elbow: drive */
    const real elbow_u_tau = tau[1]; /* N*m */
    const real elbow_drive = elbow_u_tau + lower_inertia_force;

    /* shoulder: udot */
    const real shoulder_udot = M_D_inverse_1 * (shoulder_drive - elbow_drive * M_L_2_1);
    out[0] = shoulder_udot; /* udot: shoulder.udot [rad/s^2] */

    /* elbow: udot */
    out[1] = elbow_drive * M_D_inverse_2 - M_L_2_1 * shoulder_udot; /* udot: elbow.udot [rad/s^2] */
    return CARDAN_OK;
}
