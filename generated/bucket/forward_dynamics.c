/*
 * forward_dynamics of bucket
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 2, work 0, w 8
 * Operations per call: 62 = 40 mul, 11 sub, 6 add, 2 cos, 2 sin, 1 div
 * Operations of prepare: 14 = 8 mul, 3 add, 2 sub, 1 div
 *
 * Input q (2): generalized coordinates
 *   q[0]  hang.angle1 [rad]
 *   q[1]  hang.angle2 [rad]
 *
 * Input u (2): generalized speeds
 *   u[0]  hang.u.angle1 [rad/s]
 *   u[1]  hang.u.angle2 [rad/s]
 *
 * Input p (4): parameters, read by prepare_ only
 *
 * Input tau (2): applied generalized forces
 *   tau[0]  hang.u.angle1.tau [N*m]
 *   tau[1]  hang.u.angle2.tau [N*m]
 *
 * Output udot (2)
 *   out[0]  hang.u.angle1dot [rad/s^2]
 *   out[1]  hang.u.angle2dot [rad/s^2]
 */
#include "cardan.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* bucket: mass, inertia */
    const wreal load = p[0]; /* kg */
    const wreal rope = p[1]; /* m */
    const wreal size = p[2]; /* m */
    const wreal bucket_mass_2 = size * size;
    const wreal bucket_inertia_zz = 0.5 * load * bucket_mass_2;
    const wreal bucket_mass = load * rope;
    const wreal bucket_inertia_xx = 0.3333333333333333 * load * bucket_mass_2 + rope * bucket_mass;
    w[2] = bucket_inertia_zz; /* bucket_inertia_zz */
    w[3] = bucket_mass; /* bucket_mass */
    w[4] = bucket_inertia_xx; /* bucket_inertia_xx */

    /* common */
    const wreal mul_1 = 0.5 * (bucket_inertia_zz + bucket_inertia_xx + bucket_inertia_xx);

    /* bucket: base second moment */
    w[5] = mul_1 - bucket_inertia_xx; /* bucket_base_second_moment_xx */
    w[6] = mul_1 - bucket_inertia_zz; /* bucket_base_second_moment_zz */

    /* M: D inverse */
    w[7] = 1.0 / bucket_inertia_xx; /* M_D_inverse_2 */

    /* parameters as they are */
    w[0] = p[1]; /* rope [m] */
    w[1] = p[3]; /* gravity.z [m/s^2] */
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

    /* hang: cos, sin */
    const real hang_angle1 = q[0]; /* rad */
    const real hang_angle2 = q[1]; /* rad */
    const real angle[CARDAN_PADDED(2)] = {hang_angle1, hang_angle2};
    real sine[CARDAN_PADDED(2)], cosine[CARDAN_PADDED(2)];
    cardan_sincos(2, angle, sine, cosine);
    const real hang_cos = cosine[0];
    const real hang_sin = sine[0];
    const real hang_cos_2 = cosine[1];
    const real hang_sin_2 = sine[1];

    /* hang: R, drift, momentum mx, momentum mz */
    const real hang_u_angle1 = u[0]; /* rad/s */
    const real hang_u_angle2 = u[1]; /* rad/s */
    const wreal bucket_inertia_zz = w[2];
    const wreal bucket_inertia_xx = w[4];
    const real hang_R_yx = hang_sin * hang_sin_2;
    const real hang_drift = hang_u_angle1 * hang_u_angle2;
    const real hang_drift_2 = hang_sin_2 * hang_drift;
    const real hang_momentum_mx = bucket_inertia_xx * hang_cos_2;
    const real hang_momentum_mz = bucket_inertia_zz * hang_sin_2;

    /* bucket: omega, alpha, a, U, n, f */
    const wreal gravity_z = w[1]; /* m/s^2 */
    const wreal bucket_mass = w[3];
    const wreal bucket_base_second_moment_xx = w[5];
    const wreal bucket_base_second_moment_zz = w[6];
    const real bucket_omega_x = hang_u_angle1 * hang_cos_2;
    const real bucket_omega_z = hang_u_angle1 * hang_sin_2;
    const real bucket_alpha_z = hang_cos_2 * hang_drift;
    const real bucket_a_x = hang_cos * hang_sin_2 * gravity_z;
    const real bucket_U = hang_u_angle2 * bucket_omega_x;
    const real bucket_U_xz = bucket_omega_x * bucket_omega_z;
    const real bucket_U_2 = hang_u_angle2 * bucket_omega_z;
    const real bucket_U_xy = bucket_U - bucket_alpha_z;
    const real bucket_U_yx = bucket_alpha_z + bucket_U;
    const real bucket_U_yz = hang_drift_2 + bucket_U_2;
    const real bucket_U_zy = bucket_U_2 - hang_drift_2;
    const real bucket_n_z = bucket_base_second_moment_xx * bucket_U_yx
        - bucket_base_second_moment_xx * bucket_U_xy;
    const real bucket_f = bucket_base_second_moment_xx * bucket_U_zy
        - gravity_z * hang_sin * bucket_mass - bucket_base_second_moment_zz * bucket_U_yz;
    const real bucket_f_2 = bucket_base_second_moment_zz * bucket_U_xz
        - bucket_base_second_moment_xx * bucket_U_xz - bucket_mass * bucket_a_x;

    /* air: force, data */
    const wreal rope = w[0]; /* m */
    const real air_force = rope * hang_u_angle2;
    const real air_data = 2.0 * (rope * bucket_omega_x * hang_cos - hang_R_yx * air_force);

    /* M: D inverse */
    const real M_1_1 = hang_cos_2 * hang_momentum_mx + hang_sin_2 * hang_momentum_mz;
    const real M_D_inverse_1 = 1.0 / M_1_1;

    /* bucket: n */
    const real bucket_n_x = hang_cos * air_data * rope + bucket_f;
    const real bucket_n_y = rope * (hang_cos_2 * air_force * 2.0 * hang_cos_2
        - hang_R_yx * air_data) + bucket_f_2;

    /* hang: tau angle, drive angle, udot angle */
    const real hang_u_angle1_tau = tau[0]; /* N*m */
    const real hang_u_angle2_tau = tau[1]; /* N*m */
    const wreal M_D_inverse_2 = w[7];
    const real hang_tau_angle1 = hang_cos_2 * bucket_n_x + hang_sin_2 * bucket_n_z;
    const real hang_drive_angle1 = hang_u_angle1_tau - hang_tau_angle1;
    const real hang_drive_angle2 = hang_u_angle2_tau - bucket_n_y;
    out[0] = hang_drive_angle1 * M_D_inverse_1; /* udot: hang.u.angle1dot [rad/s^2] */
    out[1] = hang_drive_angle2 * M_D_inverse_2; /* udot: hang.u.angle2dot [rad/s^2] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {2, 0, 8, 0, 2, 2, 0, 0, 0, 4, 0, 0, 0, 0, 2, 0, 0, 0, 0};
#endif
