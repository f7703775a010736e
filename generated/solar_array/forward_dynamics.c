/*
 * forward_dynamics of solar_array
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll
 *
 * Sizes: out 10, work 24, w 35
 * Operations per call: 1456 = 792 mul, 356 sub, 287 add, 9 div, 4 cos, 4 sin, 3 neg, 1 solve
 * Operations of prepare: 106 = 53 add, 33 mul, 19 sub, 1 div
 *
 * Input q (11): generalized coordinates
 *   q[0]  drift.w
 *   q[1]  drift.x
 *   q[2]  drift.y
 *   q[3]  drift.z
 *   q[4]  drift.px [m]
 *   q[5]  drift.py [m]
 *   q[6]  drift.pz [m]
 *   q[7]  hinge0 [rad]
 *   q[8]  hinge1 [rad]
 *   q[9]  hinge2 [rad]
 *   q[10]  hinge3 [rad]
 *
 * Input u (10): generalized speeds
 *   u[0]  drift.u.x [rad/s]
 *   u[1]  drift.u.y [rad/s]
 *   u[2]  drift.u.z [rad/s]
 *   u[3]  drift.u.px [m/s]
 *   u[4]  drift.u.py [m/s]
 *   u[5]  drift.u.pz [m/s]
 *   u[6]  hinge0.u [rad/s]
 *   u[7]  hinge1.u [rad/s]
 *   u[8]  hinge2.u [rad/s]
 *   u[9]  hinge3.u [rad/s]
 *
 * Input p (30): parameters, read by prepare_ only
 *
 * Input tau (10): applied generalized forces
 *   tau[0]  drift.u.x.tau [N*m]
 *   tau[1]  drift.u.y.tau [N*m]
 *   tau[2]  drift.u.z.tau [N*m]
 *   tau[3]  drift.u.px.tau [N]
 *   tau[4]  drift.u.py.tau [N]
 *   tau[5]  drift.u.pz.tau [N]
 *   tau[6]  hinge0.u.tau [N*m]
 *   tau[7]  hinge1.u.tau [N*m]
 *   tau[8]  hinge2.u.tau [N*m]
 *   tau[9]  hinge3.u.tau [N*m]
 *
 * Output udot (10)
 *   out[0]  drift.u.xdot [rad/s^2]
 *   out[1]  drift.u.ydot [rad/s^2]
 *   out[2]  drift.u.zdot [rad/s^2]
 *   out[3]  drift.u.pxdot [m/s^2]
 *   out[4]  drift.u.pydot [m/s^2]
 *   out[5]  drift.u.pzdot [m/s^2]
 *   out[6]  hinge0.udot [rad/s^2]
 *   out[7]  hinge1.udot [rad/s^2]
 *   out[8]  hinge2.udot [rad/s^2]
 *   out[9]  hinge3.udot [rad/s^2]
 */
#include "cardan.h"
#include "solve.h"
#include "dependent.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* panel0: first moment, mass, inertia */
    const wreal panel0_mass = p[5]; /* kg */
    const wreal panel0_com_x = p[6]; /* m */
    const wreal panel0_inertia_yy = p[8]; /* kg m^2 */
    const wreal panel0_inertia_zz = p[9]; /* kg m^2 */
    const wreal panel0_first_moment_x = panel0_mass * panel0_com_x;
    const wreal panel0_mass_2 = panel0_com_x * panel0_first_moment_x;
    const wreal panel0_inertia_yy_2 = panel0_inertia_yy + panel0_mass_2;
    const wreal panel0_inertia_zz_2 = panel0_inertia_zz + panel0_mass_2;

    /* panel1: first moment, mass, inertia */
    const wreal panel1_mass = p[11]; /* kg */
    const wreal panel1_com_x = p[12]; /* m */
    const wreal panel1_inertia_yy = p[14]; /* kg m^2 */
    const wreal panel1_inertia_zz = p[15]; /* kg m^2 */
    const wreal panel1_first_moment_x = panel1_mass * panel1_com_x;
    const wreal panel1_mass_2 = panel1_com_x * panel1_first_moment_x;
    const wreal panel1_inertia_yy_2 = panel1_inertia_yy + panel1_mass_2;
    const wreal panel1_inertia_zz_2 = panel1_inertia_zz + panel1_mass_2;

    /* panel2: first moment, mass, inertia, base moment */
    const wreal panel2_mass = p[17]; /* kg */
    const wreal panel2_com_x = p[18]; /* m */
    const wreal panel2_inertia_yy = p[20]; /* kg m^2 */
    const wreal panel2_inertia_zz = p[21]; /* kg m^2 */
    const wreal hinge3_position_x = p[22]; /* m */
    const wreal panel3_mass = p[23]; /* kg */
    const wreal panel2_first_moment_x = panel2_mass * panel2_com_x;
    const wreal panel2_mass_2 = panel2_com_x * panel2_first_moment_x;
    const wreal panel2_inertia_yy_2 = panel2_inertia_yy + panel2_mass_2;
    const wreal panel2_inertia_zz_2 = panel2_inertia_zz + panel2_mass_2;
    w[9] = panel2_first_moment_x + hinge3_position_x * panel3_mass; /* panel2_base_moment_x */

    /* panel3: first moment, mass, inertia, base inertia, base */
    const wreal panel2_inertia_xx = p[19]; /* kg m^2 */
    const wreal panel3_com_x = p[24]; /* m */
    const wreal panel3_inertia_xx = p[25]; /* kg m^2 */
    const wreal panel3_inertia_yy = p[26]; /* kg m^2 */
    const wreal panel3_inertia_zz = p[27]; /* kg m^2 */
    const wreal panel3_first_moment_x = panel3_mass * panel3_com_x;
    const wreal panel3_mass_2 = panel3_com_x * panel3_first_moment_x;
    const wreal panel3_inertia_yy_2 = panel3_inertia_yy + panel3_mass_2;
    const wreal panel3_inertia_zz_2 = panel3_inertia_zz + panel3_mass_2;
    const wreal panel3_base = 0.5 * panel3_mass * hinge3_position_x * hinge3_position_x;
    const wreal panel3_base_2 = 2.0 * panel3_base;
    const wreal panel3_base_3 = panel2_mass + panel3_mass;
    const wreal panel3_base_4 = panel2_inertia_xx + panel3_inertia_xx;
    w[4] = panel3_first_moment_x; /* panel3_first_moment_x */
    w[5] = panel3_inertia_yy_2; /* panel3_inertia_yy_2 */
    w[8] = panel3_inertia_zz_2 - panel3_inertia_xx; /* panel3_base_inertia_zz */

    /* panel2: base inertia, base */
    const wreal panel1_inertia_xx = p[13]; /* kg m^2 */
    const wreal hinge2_position_x = p[16]; /* m */
    const wreal panel2_base = 0.5 * panel3_base_3 * hinge2_position_x * hinge2_position_x;
    const wreal panel2_base_2 = 2.0 * panel2_base;
    const wreal panel2_base_3 = panel1_mass + panel3_base_3;
    const wreal panel2_base_4 = panel1_inertia_xx + panel3_base_4;
    w[10] = panel2_inertia_yy_2 + panel3_base_2; /* panel2_base_inertia_yy */
    /* panel2_base_inertia_zz */
    w[11] = panel3_inertia_xx + panel3_base_2 + panel2_inertia_zz_2 - panel3_base_4;

    /* panel1: base moment, base inertia, base */
    const wreal panel0_inertia_xx = p[7]; /* kg m^2 */
    const wreal hinge1_position_x = p[10]; /* m */
    const wreal panel1_base = 0.5 * panel2_base_3 * hinge1_position_x * hinge1_position_x;
    const wreal panel1_base_2 = 2.0 * panel1_base;
    const wreal panel1_base_3 = panel0_mass + panel2_base_3;
    const wreal panel1_base_4 = panel0_inertia_xx + panel2_base_4;
    w[12] = panel1_first_moment_x + hinge2_position_x * panel3_base_3; /* panel1_base_moment_x */
    w[13] = panel1_inertia_yy_2 + panel2_base_2; /* panel1_base_inertia_yy */
    /* panel1_base_inertia_zz */
    w[14] = panel3_base_4 + panel2_base_2 + panel1_inertia_zz_2 - panel2_base_4;

    /* panel0: base moment, base inertia, base */
    const wreal hinge0_position_x = p[4]; /* m */
    const wreal panel0_base = 0.5 * panel1_base_3 * hinge0_position_x * hinge0_position_x;
    const wreal panel0_base_2 = 2.0 * panel0_base;
    w[15] = panel0_first_moment_x + hinge1_position_x * panel2_base_3; /* panel0_base_moment_x */
    w[16] = panel0_inertia_yy_2 + panel1_base_2; /* panel0_base_inertia_yy */
    /* panel0_base_inertia_zz */
    w[17] = panel2_base_4 + panel1_base_2 + panel0_inertia_zz_2 - panel1_base_4;

    /* hub: base moment, base mass, base inertia */
    const wreal hub_mass = p[0]; /* kg */
    const wreal hub_inertia_xx = p[1]; /* kg m^2 */
    const wreal hub_inertia_yy = p[2]; /* kg m^2 */
    const wreal hub_inertia_zz = p[3]; /* kg m^2 */
    w[18] = hinge0_position_x * panel1_base_3; /* hub_base_moment_x */
    w[19] = hub_mass + panel1_base_3; /* hub_base_mass */
    w[20] = hub_inertia_xx + panel1_base_4; /* hub_base_inertia_xx */
    w[21] = hub_inertia_yy + panel0_base_2; /* hub_base_inertia_yy */
    w[22] = panel1_base_4 + panel0_base_2 + hub_inertia_zz; /* hub_base_inertia_zz */

    /* common */
    const wreal mul_1 = 0.5 * (hub_inertia_xx + hub_inertia_yy + hub_inertia_zz);
    const wreal mul_1_2 = 0.5 * (panel0_inertia_xx + panel0_inertia_yy_2 + panel0_inertia_zz_2);
    const wreal mul_1_3 = 0.5 * (panel1_inertia_xx + panel1_inertia_yy_2 + panel1_inertia_zz_2);
    const wreal mul_1_4 = 0.5 * (panel2_inertia_xx + panel2_inertia_yy_2 + panel2_inertia_zz_2);
    const wreal mul_1_5 = 0.5 * (panel3_inertia_xx + panel3_inertia_yy_2 + panel3_inertia_zz_2);

    /* hub: base second moment */
    w[23] = mul_1 - hub_inertia_zz; /* hub_base_second_moment_zz */
    w[32] = mul_1 - hub_inertia_xx + (panel0_base + panel0_base); /* hub_base_second_moment_xx */

    /* panel0: base second moment */
    w[24] = mul_1_2 - panel0_inertia_zz_2; /* panel0_base_second_moment_zz */
    /* panel0_base_second_moment_xx */
    w[31] = mul_1_2 - panel0_inertia_xx + (panel1_base + panel1_base);

    /* panel1: base second moment, base */
    const wreal panel1_base_5 = mul_1_2 - panel0_inertia_yy_2 + (mul_1_3 - panel1_inertia_yy_2
        + (mul_1_4 - panel2_inertia_yy_2 + (mul_1_5 - panel3_inertia_yy_2)));
    w[25] = mul_1_3 - panel1_inertia_zz_2; /* panel1_base_second_moment_zz */
    /* panel1_base_second_moment_xx */
    w[30] = mul_1_3 - panel1_inertia_xx + (panel2_base + panel2_base);

    /* panel2: base second moment */
    w[26] = mul_1_4 - panel2_inertia_zz_2; /* panel2_base_second_moment_zz */
    /* panel2_base_second_moment_xx */
    w[29] = mul_1_4 - panel2_inertia_xx + (panel3_base + panel3_base);

    /* panel3: base second moment */
    w[27] = mul_1_5 - panel3_inertia_xx; /* panel3_base_second_moment_xx */
    w[28] = mul_1_5 - panel3_inertia_zz_2; /* panel3_base_second_moment_zz */

    /* hub: base second moment */
    w[33] = mul_1 - hub_inertia_yy + panel1_base_5; /* hub_base_second_moment_yy */

    /* constraints: D inverse */
    w[34] = 1.0 / panel3_inertia_yy_2; /* constraints_D_inverse_10 */

    /* parameters as they are */
    w[0] = p[4]; /* hinge0.position.x [m] */
    w[1] = p[10]; /* hinge1.position.x [m] */
    w[2] = p[16]; /* hinge2.position.x [m] */
    w[3] = p[22]; /* hinge3.position.x [m] */
    w[6] = p[28]; /* spring.stiffness [N*m/rad] */
    w[7] = p[29]; /* spring.damping [N*m*s/rad] */
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
    int status = CARDAN_OK;

    /* shared by several: cos, sin */
    const real hinge0_q = q[7]; /* rad */
    const real hinge1_q = q[8]; /* rad */
    const real hinge2_q = q[9]; /* rad */
    const real hinge3_q = q[10]; /* rad */
    const real angle[CARDAN_PADDED(4)] = {hinge3_q, hinge2_q, hinge1_q, hinge0_q};
    real sine[CARDAN_PADDED(4)], cosine[CARDAN_PADDED(4)];
    cardan_sincos(4, angle, sine, cosine);
    const real hinge3_cos = cosine[0];
    const real hinge3_sin = sine[0];
    const real hinge2_cos = cosine[1];
    const real hinge2_sin = sine[1];
    const real hinge1_cos = cosine[2];
    const real hinge1_sin = sine[2];
    const real hinge0_cos = cosine[3];
    const real hinge0_sin = sine[3];

    /* panel2: inertia, composite inertia */
    const wreal panel3_base_inertia_zz = w[8];
    const real panel2_inertia = panel3_base_inertia_zz * hinge3_sin;
    const real panel2_composite_inertia_xx = hinge3_sin * panel2_inertia;

    /* shared by several: inertia */
    const wreal hinge3_position_x = w[3]; /* m */
    const wreal panel3_first_moment_x = w[4];
    const real panel2_inertia_2 = panel3_first_moment_x * hinge3_cos;
    const real panel2_inertia_3 = panel3_first_moment_x * hinge3_sin;
    const real panel2_inertia_4 = hinge3_position_x * panel2_inertia_2;
    const real panel1_inertia = panel2_inertia_3 * hinge2_sin;
    const real panel1_inertia_2 = panel2_inertia_3 * hinge2_cos;

    /* panel2: inertia, composite inertia, composite moment, momentum */
    const wreal panel3_inertia_yy_2 = w[5];
    const wreal panel2_base_moment_x = w[9];
    const wreal panel2_base_inertia_yy = w[10];
    const wreal panel2_base_inertia_zz = w[11];
    const real panel2_inertia_5 = 2.0 * panel2_inertia_4;
    const real panel2_composite_inertia_xz = hinge3_cos * panel2_inertia
        + hinge3_position_x * panel2_inertia_3;
    const real panel2_composite_moment_x = panel2_base_moment_x + panel2_inertia_2;
    const real panel2_composite_inertia_yy = panel3_inertia_yy_2 + panel2_inertia_5
        + panel2_base_inertia_yy;
    const real panel2_composite_inertia_zz = panel3_base_inertia_zz - panel2_composite_inertia_xx
        + panel2_inertia_5 + panel2_base_inertia_zz;
    const real panel2_momentum = panel1_inertia_2 + panel2_inertia_2 * hinge2_sin;
    const real panel2_momentum_2 = panel1_inertia - panel2_inertia_2 * hinge2_cos;

    /* panel1: inertia, composite inertia, momentum */
    const real panel1_inertia_3 = hinge2_sin * (panel2_composite_inertia_zz
        - panel2_composite_inertia_xx);
    const real panel1_inertia_4 = panel1_inertia_3 + hinge2_cos * (panel2_composite_inertia_xz
        + panel2_composite_inertia_xz);
    const real panel1_inertia_5 = hinge2_sin * panel1_inertia_4;
    const real panel1_composite_inertia_xx = panel2_composite_inertia_xx + panel1_inertia_5;
    const real panel1_momentum = hinge1_sin * panel2_momentum_2 - hinge1_cos * panel2_momentum;
    const real panel1_momentum_2 = hinge1_sin * panel2_momentum + hinge1_cos * panel2_momentum_2;

    /* shared by several: inertia */
    const wreal hinge2_position_x = w[2]; /* m */
    const real panel1_inertia_6 = panel2_composite_moment_x * hinge2_cos - panel1_inertia;
    const real panel1_inertia_7 = panel2_composite_moment_x * hinge2_sin + panel1_inertia_2;
    const real panel1_inertia_8 = hinge2_position_x * panel1_inertia_6;
    const real panel0_inertia = panel1_inertia_7 * hinge1_sin;
    const real panel0_inertia_2 = panel1_inertia_7 * hinge1_cos;

    /* panel1: inertia, composite inertia, composite moment, momentum */
    const wreal panel1_base_moment_x = w[12];
    const wreal panel1_base_inertia_yy = w[13];
    const wreal panel1_base_inertia_zz = w[14];
    const real panel1_inertia_9 = 2.0 * panel1_inertia_8;
    const real panel1_composite_inertia_xz = hinge2_cos * panel1_inertia_4
        - panel2_composite_inertia_xz + hinge2_position_x * panel1_inertia_7;
    const real panel1_composite_moment_x = panel1_base_moment_x + panel1_inertia_6;
    const real panel1_composite_inertia_yy = panel2_composite_inertia_yy + panel1_inertia_9
        + panel1_base_inertia_yy;
    const real panel1_composite_inertia_zz = panel2_composite_inertia_zz - panel1_inertia_5
        + panel1_inertia_9 + panel1_base_inertia_zz;
    const real panel1_momentum_3 = panel0_inertia_2 + panel1_inertia_6 * hinge1_sin;
    const real panel1_momentum_4 = panel0_inertia - panel1_inertia_6 * hinge1_cos;

    /* panel0: inertia, composite inertia, momentum, omega, alpha, U, inertia force */
    const real drift_u_x = u[0]; /* rad/s */
    const real drift_u_y = u[1]; /* rad/s */
    const real drift_u_z = u[2]; /* rad/s */
    const real hinge0_u = u[6]; /* rad/s */
    const wreal panel0_base_second_moment_zz = w[24];
    const wreal panel0_base_second_moment_xx = w[31];
    const real panel0_inertia_3 = hinge1_sin * (panel1_composite_inertia_zz
        - panel1_composite_inertia_xx);
    const real panel0_inertia_4 = panel0_inertia_3 + hinge1_cos * (panel1_composite_inertia_xz
        + panel1_composite_inertia_xz);
    const real panel0_inertia_5 = hinge1_sin * panel0_inertia_4;
    const real panel0_composite_inertia_xx = panel1_composite_inertia_xx + panel0_inertia_5;
    const real panel0_momentum = hinge0_cos * panel1_momentum + hinge0_sin * panel1_momentum_2;
    const real panel0_momentum_2 = hinge0_cos * panel1_momentum_2 - hinge0_sin * panel1_momentum;
    const real panel0_momentum_3 = hinge0_sin * panel1_momentum_4 - hinge0_cos * panel1_momentum_3;
    const real panel0_momentum_4 = hinge0_sin * panel1_momentum_3 + hinge0_cos * panel1_momentum_4;
    const real panel0_omega_x = drift_u_x * hinge0_cos - drift_u_z * hinge0_sin;
    const real panel0_omega_z = drift_u_x * hinge0_sin + drift_u_z * hinge0_cos;
    const real panel0_omega_y = drift_u_y + hinge0_u;
    const real panel0_alpha = hinge0_u * panel0_omega_z;
    const real panel0_alpha_z = hinge0_u * panel0_omega_x;
    const real panel0_U_xz = panel0_omega_x * panel0_omega_z;
    const real panel0_U = panel0_omega_y * panel0_omega_y + panel0_omega_z * panel0_omega_z;
    const real panel0_U_yx = panel0_alpha_z + panel0_omega_x * panel0_omega_y;
    const real panel0_U_yz = panel0_alpha + panel0_omega_z * panel0_omega_y;
    const real panel0_inertia_force = panel0_base_second_moment_zz * panel0_U_xz
        - panel0_base_second_moment_xx * panel0_U_xz;

    /* shared by several: inertia */
    const wreal hinge1_position_x = w[1]; /* m */
    const real panel0_inertia_6 = panel1_composite_moment_x * hinge1_cos - panel0_inertia;
    const real panel0_inertia_7 = panel1_composite_moment_x * hinge1_sin + panel0_inertia_2;
    const real panel0_inertia_8 = hinge1_position_x * panel0_inertia_6;
    const real hub_inertia = panel0_inertia_7 * hinge0_sin;
    const real hub_inertia_2 = panel0_inertia_7 * hinge0_cos;

    /* panel0: inertia, composite inertia, composite moment, momentum */
    const wreal panel0_base_moment_x = w[15];
    const wreal panel0_base_inertia_yy = w[16];
    const wreal panel0_base_inertia_zz = w[17];
    const real panel0_inertia_9 = 2.0 * panel0_inertia_8;
    const real panel0_composite_inertia_xz = hinge1_cos * panel0_inertia_4
        - panel1_composite_inertia_xz + hinge1_position_x * panel0_inertia_7;
    const real panel0_composite_moment_x = panel0_base_moment_x + panel0_inertia_6;
    const real panel0_composite_inertia_yy = panel1_composite_inertia_yy + panel0_inertia_9
        + panel0_base_inertia_yy;
    const real panel0_composite_inertia_zz = panel1_composite_inertia_zz - panel0_inertia_5
        + panel0_inertia_9 + panel0_base_inertia_zz;
    const real panel0_momentum_5 = hub_inertia_2 + panel0_inertia_6 * hinge0_sin;
    const real panel0_momentum_6 = hub_inertia - panel0_inertia_6 * hinge0_cos;

    /* hub: inertia, composite inertia, U, inertia force */
    const wreal hub_base_inertia_xx = w[20];
    const wreal hub_base_second_moment_zz = w[23];
    const wreal hub_base_second_moment_yy = w[33];
    const real hub_inertia_3 = hinge0_sin * (panel0_composite_inertia_zz
        - panel0_composite_inertia_xx);
    const real hub_inertia_4 = hub_inertia_3 + hinge0_cos * (panel0_composite_inertia_xz
        + panel0_composite_inertia_xz);
    const real hub_inertia_5 = hinge0_sin * hub_inertia_4;
    const real hub_composite_inertia_xx = panel0_composite_inertia_xx + hub_inertia_5
        + hub_base_inertia_xx;
    const real hub_U_xy = drift_u_x * drift_u_y;
    const real hub_U_xz = drift_u_x * drift_u_z;
    const real hub_U_yz = drift_u_y * drift_u_z;
    const real hub_U = drift_u_y * drift_u_y + drift_u_z * drift_u_z;
    const real hub_inertia_force = hub_base_second_moment_yy * hub_U_yz
        - hub_base_second_moment_zz * hub_U_yz;

    /* shared by several: inertia */
    const wreal hinge0_position_x = w[0]; /* m */
    const real hub_inertia_6 = panel0_composite_moment_x * hinge0_cos - hub_inertia;
    const real hub_inertia_7 = hinge0_position_x * hub_inertia_6;

    /* drift: momentum fy, R, momentum mx, momentum fx, momentum fz */
    const real drift_w = q[0];
    const real drift_x = q[1];
    const real drift_y = q[2];
    const real drift_z = q[3];
    const wreal hub_base_mass = w[19];
    const real drift_momentum_fy = panel0_composite_moment_x * hinge0_sin + hub_inertia_2;
    const real drift_R = 2.0 * drift_x;
    const real drift_R_2 = 2.0 * drift_y;
    const real drift_R_3 = 2.0 * drift_z;
    const real drift_R_4 = drift_w * drift_R;
    const real drift_R_5 = drift_w * drift_R_2;
    const real drift_R_6 = drift_w * drift_R_3;
    const real drift_R_7 = drift_x * drift_R;
    const real drift_R_8 = drift_x * drift_R_2;
    const real drift_R_9 = drift_x * drift_R_3;
    const real drift_R_10 = drift_y * drift_R_2;
    const real drift_R_11 = drift_y * drift_R_3;
    const real drift_R_12 = drift_z * drift_R_3;
    const real drift_R_xx = 1.0 - (drift_R_10 + drift_R_12);
    const real drift_R_xy = drift_R_8 - drift_R_6;
    const real drift_R_xz = drift_R_5 + drift_R_9;
    const real drift_R_yx = drift_R_6 + drift_R_8;
    const real drift_R_yy = 1.0 - (drift_R_7 + drift_R_12);
    const real drift_R_yz = drift_R_11 - drift_R_4;
    const real drift_R_zx = drift_R_9 - drift_R_5;
    const real drift_R_zy = drift_R_4 + drift_R_11;
    const real drift_R_zz = 1.0 - (drift_R_7 + drift_R_10);
    const real drift_momentum_mx = drift_momentum_fy * drift_R_xy;
    const real drift_momentum_mx_2 = drift_momentum_fy * drift_R_yy;
    const real drift_momentum_mx_3 = drift_momentum_fy * drift_R_zy;
    const real drift_momentum_fx = hub_base_mass * drift_R_xx;
    const real drift_momentum_fy_2 = hub_base_mass * drift_R_xy;
    const real drift_momentum_fz = hub_base_mass * drift_R_xz;
    const real drift_momentum_fx_2 = hub_base_mass * drift_R_yx;
    const real drift_momentum_fy_3 = hub_base_mass * drift_R_yy;
    const real drift_momentum_fz_2 = hub_base_mass * drift_R_yz;
    const real drift_momentum_fx_3 = hub_base_mass * drift_R_zx;
    const real drift_momentum_fy_4 = hub_base_mass * drift_R_zy;
    const real drift_momentum_fz_3 = hub_base_mass * drift_R_zz;

    /* hub: inertia, composite inertia, composite moment */
    const wreal hub_base_moment_x = w[18];
    const wreal hub_base_inertia_yy = w[21];
    const wreal hub_base_inertia_zz = w[22];
    const real hub_inertia_8 = 2.0 * hub_inertia_7;
    const real hub_composite_inertia_xz = hinge0_cos * hub_inertia_4
        - panel0_composite_inertia_xz + hinge0_position_x * drift_momentum_fy;
    const real hub_composite_moment_x = hub_base_moment_x + hub_inertia_6;
    const real hub_composite_inertia_yy = panel0_composite_inertia_yy + hub_inertia_8
        + hub_base_inertia_yy;
    const real hub_composite_inertia_zz = panel0_composite_inertia_zz - hub_inertia_5
        + hub_inertia_8 + hub_base_inertia_zz;

    /* M */
    const real M_10_9 = panel3_inertia_yy_2 + panel2_inertia_4;
    const real M_10_8 = M_10_9 - hinge2_position_x * panel2_momentum_2;
    const real M_10_7 = M_10_8 - hinge1_position_x * panel1_momentum_2;
    const real M_10_2 = M_10_7 - hinge0_position_x * panel0_momentum_2;
    const real M_10_4 = panel0_momentum * drift_R_xx + panel0_momentum_2 * drift_R_xz;
    const real M_10_5 = panel0_momentum * drift_R_yx + panel0_momentum_2 * drift_R_yz;
    const real M_10_6 = panel0_momentum * drift_R_zx + panel0_momentum_2 * drift_R_zz;
    const real M_9_8 = panel2_composite_inertia_yy + panel1_inertia_8;
    const real M_9_7 = M_9_8 - hinge1_position_x * panel1_momentum_4;
    const real M_9_2 = M_9_7 - hinge0_position_x * panel0_momentum_4;
    const real M_9_4 = drift_R_xx * panel0_momentum_3 + drift_R_xz * panel0_momentum_4;
    const real M_9_5 = drift_R_yx * panel0_momentum_3 + drift_R_yz * panel0_momentum_4;
    const real M_9_6 = drift_R_zx * panel0_momentum_3 + drift_R_zz * panel0_momentum_4;
    const real M_8_7 = panel1_composite_inertia_yy + panel0_inertia_8;
    const real M_8_2 = M_8_7 - hinge0_position_x * panel0_momentum_6;
    const real M_8_4 = drift_R_xz * panel0_momentum_6 - drift_R_xx * panel0_momentum_5;
    const real M_8_5 = drift_R_yz * panel0_momentum_6 - drift_R_yx * panel0_momentum_5;
    const real M_8_6 = drift_R_zz * panel0_momentum_6 - drift_R_zx * panel0_momentum_5;
    const real M_7_2 = panel0_composite_inertia_yy + hub_inertia_7;
    const real M_4_4 = drift_R_xx * drift_momentum_fx + drift_R_xy * drift_momentum_fy_2
        + drift_R_xz * drift_momentum_fz;
    const real M_5_4 = drift_R_xx * drift_momentum_fx_2 + drift_R_xy * drift_momentum_fy_3
        + drift_R_xz * drift_momentum_fz_2;
    const real M_5_5 = drift_R_yx * drift_momentum_fx_2 + drift_R_yy * drift_momentum_fy_3
        + drift_R_yz * drift_momentum_fz_2;
    const real M_6_4 = drift_R_xx * drift_momentum_fx_3 + drift_R_xy * drift_momentum_fy_4
        + drift_R_xz * drift_momentum_fz_3;
    const real M_6_5 = drift_R_yx * drift_momentum_fx_3 + drift_R_yy * drift_momentum_fy_4
        + drift_R_yz * drift_momentum_fz_3;
    const real M_6_6 = drift_R_zx * drift_momentum_fx_3 + drift_R_zy * drift_momentum_fy_4
        + drift_R_zz * drift_momentum_fz_3;

    /* shared by several: M */
    const real drift_M = drift_momentum_fy * drift_R_xx;
    const real drift_M_2 = drift_momentum_fy * drift_R_yx;
    const real drift_M_3 = drift_momentum_fy * drift_R_zx;

    /* drift: momentum mz */
    const real drift_momentum_mz = hub_composite_moment_x * drift_R_xy;
    const real drift_momentum_mz_2 = hub_composite_moment_x * drift_R_yy;
    const real drift_momentum_mz_3 = hub_composite_moment_x * drift_R_zy;

    /* panel1: omega, alpha, U, inertia force */
    const real hinge1_u = u[7]; /* rad/s */
    const wreal panel1_base_second_moment_zz = w[25];
    const wreal panel1_base_second_moment_xx = w[30];
    const real panel1_omega_x = hinge1_cos * panel0_omega_x - hinge1_sin * panel0_omega_z;
    const real panel1_omega_z = hinge1_sin * panel0_omega_x + hinge1_cos * panel0_omega_z;
    const real panel1_omega_y = hinge1_u + panel0_omega_y;
    const real panel1_alpha = hinge1_cos * panel0_alpha + hinge1_sin * panel0_alpha_z
        + hinge1_u * panel1_omega_z;
    const real panel1_alpha_z = hinge1_cos * panel0_alpha_z - hinge1_sin * panel0_alpha
        + hinge1_u * panel1_omega_x;
    const real panel1_U_xz = panel1_omega_x * panel1_omega_z;
    const real panel1_U = panel1_omega_y * panel1_omega_y + panel1_omega_z * panel1_omega_z;
    const real panel1_U_yx = panel1_alpha_z + panel1_omega_x * panel1_omega_y;
    const real panel1_U_yz = panel1_alpha + panel1_omega_z * panel1_omega_y;
    const real panel1_inertia_force = panel1_base_second_moment_zz * panel1_U_xz
        - panel1_base_second_moment_xx * panel1_U_xz;

    /* panel2: omega, alpha, U, inertia force */
    const real hinge2_u = u[8]; /* rad/s */
    const wreal panel2_base_second_moment_zz = w[26];
    const wreal panel2_base_second_moment_xx = w[29];
    const real panel2_omega_x = hinge2_cos * panel1_omega_x - hinge2_sin * panel1_omega_z;
    const real panel2_omega_z = hinge2_sin * panel1_omega_x + hinge2_cos * panel1_omega_z;
    const real panel2_omega_y = hinge2_u + panel1_omega_y;
    const real panel2_alpha = hinge2_cos * panel1_alpha + hinge2_sin * panel1_alpha_z
        + hinge2_u * panel2_omega_z;
    const real panel2_alpha_z = hinge2_cos * panel1_alpha_z - hinge2_sin * panel1_alpha
        + hinge2_u * panel2_omega_x;
    const real panel2_U_xz = panel2_omega_x * panel2_omega_z;
    const real panel2_U = panel2_omega_y * panel2_omega_y + panel2_omega_z * panel2_omega_z;
    const real panel2_U_yx = panel2_alpha_z + panel2_omega_x * panel2_omega_y;
    const real panel2_U_yz = panel2_alpha + panel2_omega_z * panel2_omega_y;
    const real panel2_inertia_force = panel2_base_second_moment_zz * panel2_U_xz
        - panel2_base_second_moment_xx * panel2_U_xz;

    /* panel3: omega, alpha, U, inertia force, f */
    const real hinge3_u = u[9]; /* rad/s */
    const wreal panel3_base_second_moment_zz = w[28];
    const real panel3_omega_x = hinge3_cos * panel2_omega_x - hinge3_sin * panel2_omega_z;
    const real panel3_omega_z = hinge3_sin * panel2_omega_x + hinge3_cos * panel2_omega_z;
    const real panel3_omega_y = hinge3_u + panel2_omega_y;
    const real panel3_alpha = hinge3_cos * panel2_alpha + hinge3_sin * panel2_alpha_z
        + hinge3_u * panel3_omega_z;
    const real panel3_alpha_z = hinge3_cos * panel2_alpha_z - hinge3_sin * panel2_alpha
        + hinge3_u * panel3_omega_x;
    const real panel3_U_xz = panel3_omega_x * panel3_omega_z;
    const real panel3_U_yx = panel3_alpha_z + panel3_omega_x * panel3_omega_y;
    const real panel3_U_yz = panel3_alpha + panel3_omega_z * panel3_omega_y;
    const real panel3_inertia_force = panel3_base_second_moment_zz * panel3_U_yz;
    const real panel3_inertia_force_2 = panel3_first_moment_x * (panel3_omega_y * panel3_omega_y
        + panel3_omega_z * panel3_omega_z);
    const real panel3_f_y = panel3_first_moment_x * panel3_U_yx;
    const real panel3_f_z = panel3_first_moment_x * panel3_U_xz;
    const real panel3_f = hinge3_sin * panel3_inertia_force_2 + hinge3_cos * panel3_f_z;

    /* panel0: a */
    const real panel0_a = hinge0_position_x * hub_U;
    const real panel0_a_y = hinge0_position_x * hub_U_xy;
    const real panel0_a_2 = hinge0_position_x * hub_U_xz;
    const real panel0_a_z = hinge0_cos * panel0_a_2 - hinge0_sin * panel0_a;

    /* panel1: a */
    const real panel1_a = hinge0_cos * panel0_a + hinge0_sin * panel0_a_2
        + hinge1_position_x * panel0_U;
    const real panel1_a_y = panel0_a_y + hinge1_position_x * panel0_U_yx;
    const real panel1_a_2 = panel0_a_z + hinge1_position_x * panel0_U_xz;
    const real panel1_a_z = hinge1_cos * panel1_a_2 - hinge1_sin * panel1_a;

    /* panel2: a, f */
    const real panel2_a = hinge1_cos * panel1_a + hinge1_sin * panel1_a_2
        + hinge2_position_x * panel1_U;
    const real panel2_a_y = panel1_a_y + hinge2_position_x * panel1_U_yx;
    const real panel2_a_2 = panel1_a_z + hinge2_position_x * panel1_U_xz;
    const real panel2_a_z = hinge2_cos * panel2_a_2 - hinge2_sin * panel2_a;
    const real panel2_f_x = hinge3_sin * panel3_f_z - hinge3_cos * panel3_inertia_force_2
        - panel2_base_moment_x * panel2_U;
    const real panel2_f_y = panel2_base_moment_x * panel2_U_yx + panel3_f_y;
    const real panel2_f_z = panel2_base_moment_x * panel2_U_xz + panel3_f;
    const real panel2_f = hinge2_cos * panel2_f_z - hinge2_sin * panel2_f_x;

    /* panel3: a, n, f */
    const wreal panel3_base_second_moment_xx = w[27];
    const real panel3_a_y = panel2_a_y + hinge3_position_x * panel2_U_yx;
    const real panel3_a = hinge3_sin * (hinge2_cos * panel2_a + hinge2_sin * panel2_a_2
        + hinge3_position_x * panel2_U);
    const real panel3_a_z = hinge3_cos * (panel2_a_z + hinge3_position_x * panel2_U_xz) - panel3_a;
    const real panel3_n_y = panel3_base_second_moment_zz * panel3_U_xz
        - panel3_base_second_moment_xx * panel3_U_xz - panel3_first_moment_x * panel3_a_z;
    const real panel3_n_z = panel3_base_second_moment_xx * panel3_U_yx
        + panel3_first_moment_x * panel3_a_y;
    const real panel3_f_2 = hinge3_sin * panel3_inertia_force + hinge3_cos * panel3_n_z
        + hinge3_position_x * panel3_f_y;

    /* panel2: n, f */
    const real panel2_n_x = hinge3_sin * panel3_n_z - hinge3_cos * panel3_inertia_force
        - panel2_base_second_moment_zz * panel2_U_yz;
    const real panel2_n_y = panel2_inertia_force - panel2_base_moment_x * panel2_a_z
        + (panel3_n_y - hinge3_position_x * panel3_f);
    const real panel2_n_z = panel2_base_second_moment_xx * panel2_U_yx
        + panel2_base_moment_x * panel2_a_y + panel3_f_2;
    const real panel2_f_2 = hinge2_cos * panel2_n_z - hinge2_sin * panel2_n_x
        + hinge2_position_x * panel2_f_y;

    /* panel1: n, f */
    const real panel1_n_x = hinge2_cos * panel2_n_x + hinge2_sin * panel2_n_z
        - panel1_base_second_moment_zz * panel1_U_yz;
    const real panel1_n_y = panel1_inertia_force - panel1_base_moment_x * panel1_a_z
        + (panel2_n_y - hinge2_position_x * panel2_f);
    const real panel1_n_z = panel1_base_second_moment_xx * panel1_U_yx
        + panel1_base_moment_x * panel1_a_y + panel2_f_2;
    const real panel1_f_x = hinge2_cos * panel2_f_x + hinge2_sin * panel2_f_z
        - panel1_base_moment_x * panel1_U;
    const real panel1_f_y = panel1_base_moment_x * panel1_U_yx + panel2_f_y;
    const real panel1_f_z = panel1_base_moment_x * panel1_U_xz + panel2_f;
    const real panel1_f = hinge1_cos * panel1_f_z - hinge1_sin * panel1_f_x;
    const real panel1_f_2 = hinge1_cos * panel1_n_z - hinge1_sin * panel1_n_x
        + hinge1_position_x * panel1_f_y;

    /* panel0: n, f */
    const real panel0_n_x = hinge1_cos * panel1_n_x + hinge1_sin * panel1_n_z
        - panel0_base_second_moment_zz * panel0_U_yz;
    const real panel0_n_y = panel0_inertia_force - panel0_base_moment_x * panel0_a_z
        + (panel1_n_y - hinge1_position_x * panel1_f);
    const real panel0_n_z = panel0_base_second_moment_xx * panel0_U_yx
        + panel0_base_moment_x * panel0_a_y + panel1_f_2;
    const real panel0_f_x = hinge1_cos * panel1_f_x + hinge1_sin * panel1_f_z
        - panel0_base_moment_x * panel0_U;
    const real panel0_f_y = panel0_base_moment_x * panel0_U_yx + panel1_f_y;
    const real panel0_f_z = panel0_base_moment_x * panel0_U_xz + panel1_f;
    const real panel0_f = hinge0_cos * panel0_f_z - hinge0_sin * panel0_f_x;
    const real panel0_f_2 = hinge0_cos * panel0_n_z - hinge0_sin * panel0_n_x
        + hinge0_position_x * panel0_f_y;

    /* hub: n, f */
    const wreal hub_base_second_moment_xx = w[32];
    const real hub_n_x = hinge0_cos * panel0_n_x + hinge0_sin * panel0_n_z + hub_inertia_force;
    const real hub_n_y = hub_base_second_moment_zz * hub_U_xz
        - hub_base_second_moment_xx * hub_U_xz + (panel0_n_y - hinge0_position_x * panel0_f);
    const real hub_n_z = hub_base_second_moment_xx * hub_U_xy
        - hub_base_second_moment_yy * hub_U_xy + panel0_f_2;
    const real hub_f_x = hinge0_cos * panel0_f_x + hinge0_sin * panel0_f_z
        - hub_base_moment_x * hub_U;
    const real hub_f_y = hub_base_moment_x * hub_U_xy + panel0_f_y;
    const real hub_f_z = hub_base_moment_x * hub_U_xz + panel0_f;

    /* hinge0: tau, drive */
    const real hinge0_u_tau = tau[6]; /* N*m */
    const wreal spring_stiffness = w[6]; /* N*m/rad */
    const wreal spring_damping = w[7]; /* N*m*s/rad */
    const real hinge0_tau = hinge0_q * spring_stiffness + hinge0_u * spring_damping + panel0_n_y;
    const real hinge0_drive = hinge0_u_tau - hinge0_tau;

    /* drift: tau px, tau py, tau pz, drive, drive px, drive py, drive pz */
    const real drift_u_x_tau = tau[0]; /* N*m */
    const real drift_u_y_tau = tau[1]; /* N*m */
    const real drift_u_z_tau = tau[2]; /* N*m */
    const real drift_u_px_tau = tau[3]; /* N */
    const real drift_u_py_tau = tau[4]; /* N */
    const real drift_u_pz_tau = tau[5]; /* N */
    const real drift_tau_px = drift_R_xx * hub_f_x + drift_R_xy * hub_f_y + drift_R_xz * hub_f_z;
    const real drift_tau_py = drift_R_yx * hub_f_x + drift_R_yy * hub_f_y + drift_R_yz * hub_f_z;
    const real drift_tau_pz = drift_R_zx * hub_f_x + drift_R_zy * hub_f_y + drift_R_zz * hub_f_z;
    const real drift_drive_x = drift_u_x_tau - hub_n_x;
    const real drift_drive_y = drift_u_y_tau - hub_n_y;
    const real drift_drive_z = drift_u_z_tau - hub_n_z;
    const real drift_drive_px = drift_u_px_tau - drift_tau_px;
    const real drift_drive_py = drift_u_py_tau - drift_tau_py;
    const real drift_drive_pz = drift_u_pz_tau - drift_tau_pz;

    /* hinge1: drive */
    const real hinge1_u_tau = tau[7]; /* N*m */
    const real hinge1_drive = hinge1_u_tau - panel1_n_y;

    /* hinge2: drive */
    const real hinge2_u_tau = tau[8]; /* N*m */
    const real hinge2_drive = hinge2_u_tau - panel2_n_y;

    /* hinge3: drive */
    const real hinge3_u_tau = tau[9]; /* N*m */
    const real hinge3_drive = hinge3_u_tau - panel3_n_y;

    /* constraints: L, multipliers, D inverse */
    const wreal constraints_D_inverse_10 = w[34];
    const real constraints_L_10_9 = M_10_9 * constraints_D_inverse_10;
    const real constraints_multipliers = M_9_2 - M_10_2 * constraints_L_10_9;
    const real constraints_multipliers_2 = M_9_4 - M_10_4 * constraints_L_10_9;
    const real constraints_multipliers_3 = M_9_5 - M_10_5 * constraints_L_10_9;
    const real constraints_multipliers_4 = M_9_6 - M_10_6 * constraints_L_10_9;
    const real constraints_multipliers_5 = M_9_7 - M_10_7 * constraints_L_10_9;
    const real constraints_multipliers_6 = M_9_8 - M_10_8 * constraints_L_10_9;
    const real constraints_L_10_8 = M_10_8 * constraints_D_inverse_10;
    const real constraints_L_10_7 = M_10_7 * constraints_D_inverse_10;
    const real constraints_multipliers_7 = drift_M + hub_inertia_6 * drift_R_xz
        + M_10_4 * constraints_L_10_7;
    const real constraints_multipliers_8 = drift_M_2 + hub_inertia_6 * drift_R_yz
        + M_10_5 * constraints_L_10_7;
    const real constraints_multipliers_9 = drift_M_3 + hub_inertia_6 * drift_R_zz
        + M_10_6 * constraints_L_10_7;
    const real constraints_L_10_6 = M_10_6 * constraints_D_inverse_10;
    const real constraints_multipliers_10 = drift_M_3 + hub_composite_moment_x * drift_R_zz
        + M_10_2 * constraints_L_10_6;
    const real constraints_L_10_5 = M_10_5 * constraints_D_inverse_10;
    const real constraints_multipliers_11 = drift_M_2 + hub_composite_moment_x * drift_R_yz
        + M_10_2 * constraints_L_10_5;
    const real constraints_L_10_4 = M_10_4 * constraints_D_inverse_10;
    const real constraints_multipliers_12 = drift_M + hub_composite_moment_x * drift_R_xz
        + M_10_2 * constraints_L_10_4;
    const real constraints_L_10_2 = M_10_2 * constraints_D_inverse_10;
    const real constraints_D_inverse_9 = 1.0 / (panel2_composite_inertia_yy
        - M_10_9 * constraints_L_10_9);
    const real constraints_L_9_8 = constraints_multipliers_6 * constraints_D_inverse_9;
    const real constraints_multipliers_13 = M_8_2 - M_10_2 * constraints_L_10_8
        - constraints_multipliers * constraints_L_9_8;
    const real constraints_multipliers_14 = M_8_4 - M_10_4 * constraints_L_10_8
        - constraints_multipliers_2 * constraints_L_9_8;
    const real constraints_multipliers_15 = M_8_5 - M_10_5 * constraints_L_10_8
        - constraints_multipliers_3 * constraints_L_9_8;
    const real constraints_multipliers_16 = M_8_6 - M_10_6 * constraints_L_10_8
        - constraints_multipliers_4 * constraints_L_9_8;
    const real constraints_multipliers_17 = M_8_7 - M_10_7 * constraints_L_10_8
        - constraints_multipliers_5 * constraints_L_9_8;
    const real constraints_L_9_7 = constraints_multipliers_5 * constraints_D_inverse_9;
    const real constraints_multipliers_18 = M_7_2 - M_10_2 * constraints_L_10_7
        - constraints_multipliers * constraints_L_9_7;
    const real constraints_multipliers_19 = constraints_multipliers_7
        + constraints_multipliers_2 * constraints_L_9_7;
    const real constraints_multipliers_20 = constraints_multipliers_8
        + constraints_multipliers_3 * constraints_L_9_7;
    const real constraints_multipliers_21 = constraints_multipliers_9
        + constraints_multipliers_4 * constraints_L_9_7;
    const real constraints_multipliers_22 = panel0_composite_inertia_yy
        - M_10_7 * constraints_L_10_7 - constraints_multipliers_5 * constraints_L_9_7;
    const real constraints_L_9_6 = constraints_multipliers_4 * constraints_D_inverse_9;
    const real constraints_multipliers_23 = constraints_multipliers_10
        + constraints_multipliers * constraints_L_9_6;
    const real constraints_multipliers_24 = M_6_4 - M_10_4 * constraints_L_10_6
        - constraints_multipliers_2 * constraints_L_9_6;
    const real constraints_multipliers_25 = M_6_5 - M_10_5 * constraints_L_10_6
        - constraints_multipliers_3 * constraints_L_9_6;
    const real constraints_multipliers_26 = M_6_6 - M_10_6 * constraints_L_10_6
        - constraints_multipliers_4 * constraints_L_9_6;
    const real constraints_L_9_5 = constraints_multipliers_3 * constraints_D_inverse_9;
    const real constraints_multipliers_27 = constraints_multipliers_11
        + constraints_multipliers * constraints_L_9_5;
    const real constraints_multipliers_28 = M_5_4 - M_10_4 * constraints_L_10_5
        - constraints_multipliers_2 * constraints_L_9_5;
    const real constraints_multipliers_29 = M_5_5 - M_10_5 * constraints_L_10_5
        - constraints_multipliers_3 * constraints_L_9_5;
    const real constraints_L_9_4 = constraints_multipliers_2 * constraints_D_inverse_9;
    const real constraints_multipliers_30 = constraints_multipliers_12
        + constraints_multipliers * constraints_L_9_4;
    const real constraints_multipliers_31 = M_4_4 - M_10_4 * constraints_L_10_4
        - constraints_multipliers_2 * constraints_L_9_4;
    const real constraints_L_9_2 = constraints_multipliers * constraints_D_inverse_9;
    const real constraints_multipliers_32 = hub_composite_inertia_yy
        - M_10_2 * constraints_L_10_2 - constraints_multipliers * constraints_L_9_2;
    const real constraints_D_inverse_8 = 1.0 / (panel1_composite_inertia_yy
        - M_10_8 * constraints_L_10_8 - constraints_multipliers_6 * constraints_L_9_8);
    const real constraints_L_8_7 = constraints_multipliers_17 * constraints_D_inverse_8;
    const real constraints_multipliers_33 = constraints_multipliers_18
        - constraints_multipliers_13 * constraints_L_8_7;
    const real constraints_multipliers_34 = constraints_multipliers_19
        + constraints_multipliers_14 * constraints_L_8_7;
    const real constraints_multipliers_35 = constraints_multipliers_20
        + constraints_multipliers_15 * constraints_L_8_7;
    const real constraints_multipliers_36 = constraints_multipliers_21
        + constraints_multipliers_16 * constraints_L_8_7;
    const real constraints_L_8_6 = constraints_multipliers_16 * constraints_D_inverse_8;
    const real constraints_multipliers_37 = constraints_multipliers_23
        + constraints_multipliers_13 * constraints_L_8_6;
    const real constraints_multipliers_38 = constraints_multipliers_24
        - constraints_multipliers_14 * constraints_L_8_6;
    const real constraints_multipliers_39 = constraints_multipliers_25
        - constraints_multipliers_15 * constraints_L_8_6;
    const real constraints_multipliers_40 = constraints_multipliers_26
        - constraints_multipliers_16 * constraints_L_8_6;
    const real constraints_L_8_5 = constraints_multipliers_15 * constraints_D_inverse_8;
    const real constraints_multipliers_41 = constraints_multipliers_27
        + constraints_multipliers_13 * constraints_L_8_5;
    const real constraints_multipliers_42 = constraints_multipliers_28
        - constraints_multipliers_14 * constraints_L_8_5;
    const real constraints_multipliers_43 = constraints_multipliers_29
        - constraints_multipliers_15 * constraints_L_8_5;
    const real constraints_L_8_4 = constraints_multipliers_14 * constraints_D_inverse_8;
    const real constraints_multipliers_44 = constraints_multipliers_30
        + constraints_multipliers_13 * constraints_L_8_4;
    const real constraints_multipliers_45 = constraints_multipliers_31
        - constraints_multipliers_14 * constraints_L_8_4;
    const real constraints_L_8_2 = constraints_multipliers_13 * constraints_D_inverse_8;
    const real constraints_multipliers_46 = constraints_multipliers_32
        - constraints_multipliers_13 * constraints_L_8_2;
    const real constraints_D_inverse_7 = 1.0 / (constraints_multipliers_22
        - constraints_multipliers_17 * constraints_L_8_7);
    const real constraints_multipliers_47 = constraints_multipliers_36 * constraints_D_inverse_7;
    const real constraints_multipliers_48 = constraints_multipliers_33 * constraints_multipliers_47
        - constraints_multipliers_37;
    const real constraints_multipliers_49 = constraints_multipliers_38
        - constraints_multipliers_34 * constraints_multipliers_47;
    const real constraints_multipliers_50 = constraints_multipliers_39
        - constraints_multipliers_35 * constraints_multipliers_47;
    const real constraints_multipliers_51 = constraints_multipliers_35 * constraints_D_inverse_7;
    const real constraints_multipliers_52 = constraints_multipliers_33 * constraints_multipliers_51
        - constraints_multipliers_41;
    const real constraints_multipliers_53 = constraints_multipliers_42
        - constraints_multipliers_34 * constraints_multipliers_51;
    const real constraints_multipliers_54 = constraints_multipliers_43
        - constraints_multipliers_35 * constraints_multipliers_51;
    const real constraints_multipliers_55 = constraints_multipliers_34 * constraints_D_inverse_7;
    const real constraints_multipliers_56 = constraints_multipliers_33 * constraints_multipliers_55
        - constraints_multipliers_44;
    const real constraints_multipliers_57 = constraints_multipliers_45
        - constraints_multipliers_34 * constraints_multipliers_55;
    const real constraints_L_7_2 = constraints_multipliers_33 * constraints_D_inverse_7;
    const real constraints_multipliers_58 = constraints_multipliers_46
        - constraints_multipliers_33 * constraints_L_7_2;
    const real constraints_D_inverse_6 = 1.0 / (constraints_multipliers_40
        - constraints_multipliers_36 * constraints_multipliers_47);
    const real constraints_L_6_5 = constraints_multipliers_50 * constraints_D_inverse_6;
    const real constraints_multipliers_59 = drift_momentum_mx_2
        - drift_momentum_mx_3 * constraints_L_6_5;
    const real constraints_multipliers_60 = constraints_multipliers_52
        - constraints_multipliers_48 * constraints_L_6_5;
    const real constraints_multipliers_61 = drift_momentum_mz_2
        - drift_momentum_mz_3 * constraints_L_6_5;
    const real constraints_multipliers_62 = constraints_multipliers_53
        - constraints_multipliers_49 * constraints_L_6_5;
    const real constraints_L_6_4 = constraints_multipliers_49 * constraints_D_inverse_6;
    const real constraints_multipliers_63 = constraints_multipliers_56
        - constraints_multipliers_48 * constraints_L_6_4;
    const real constraints_multipliers_64 = constraints_multipliers_57
        - constraints_multipliers_49 * constraints_L_6_4;
    const real constraints_L_6_3 = drift_momentum_mz_3 * constraints_D_inverse_6;
    const real constraints_multipliers_65 = hub_composite_inertia_xz
        - drift_momentum_mx_3 * constraints_L_6_3;
    const real constraints_multipliers_66 = hub_composite_inertia_zz
        - drift_momentum_mz_3 * constraints_L_6_3;
    const real constraints_L_6_2 = constraints_multipliers_48 * constraints_D_inverse_6;
    const real constraints_multipliers_67 = constraints_multipliers_58
        - constraints_multipliers_48 * constraints_L_6_2;
    const real constraints_L_6_1 = drift_momentum_mx_3 * constraints_D_inverse_6;
    const real constraints_multipliers_68 = hub_composite_inertia_xx
        - drift_momentum_mx_3 * constraints_L_6_1;
    const real constraints_D_inverse_5 = 1.0 / (constraints_multipliers_54
        - constraints_multipliers_50 * constraints_L_6_5);
    const real constraints_L_5_4 = constraints_multipliers_62 * constraints_D_inverse_5;
    const real constraints_multipliers_69 = drift_momentum_mx
        - drift_momentum_mx_3 * constraints_L_6_4 - constraints_multipliers_59 * constraints_L_5_4;
    const real constraints_multipliers_70 = constraints_multipliers_63
        - constraints_multipliers_60 * constraints_L_5_4;
    const real constraints_multipliers_71 = drift_momentum_mz
        - drift_momentum_mz_3 * constraints_L_6_4 - constraints_multipliers_61 * constraints_L_5_4;
    const real constraints_L_5_3 = constraints_multipliers_61 * constraints_D_inverse_5;
    const real constraints_multipliers_72 = constraints_multipliers_65
        - constraints_multipliers_59 * constraints_L_5_3;
    const real constraints_multipliers_73 = constraints_multipliers_48 * constraints_L_6_3
        + constraints_multipliers_60 * constraints_L_5_3;
    const real constraints_multipliers_74 = constraints_multipliers_66
        - constraints_multipliers_61 * constraints_L_5_3;
    const real constraints_L_5_2 = constraints_multipliers_60 * constraints_D_inverse_5;
    const real constraints_multipliers_75 = drift_momentum_mx_3 * constraints_L_6_2
        + constraints_multipliers_59 * constraints_L_5_2;
    const real constraints_multipliers_76 = constraints_multipliers_67
        - constraints_multipliers_60 * constraints_L_5_2;
    const real constraints_L_5_1 = constraints_multipliers_59 * constraints_D_inverse_5;
    const real constraints_multipliers_77 = constraints_multipliers_68
        - constraints_multipliers_59 * constraints_L_5_1;
    const real constraints_D_inverse_4 = 1.0 / (constraints_multipliers_64
        - constraints_multipliers_62 * constraints_L_5_4);
    const real constraints_L_4_3 = constraints_multipliers_71 * constraints_D_inverse_4;
    const real constraints_multipliers_78 = constraints_multipliers_72
        - constraints_multipliers_69 * constraints_L_4_3;
    const real constraints_multipliers_79 = constraints_multipliers_73
        + constraints_multipliers_70 * constraints_L_4_3;
    const real constraints_L_4_2 = constraints_multipliers_70 * constraints_D_inverse_4;
    const real constraints_multipliers_80 = constraints_multipliers_75
        + constraints_multipliers_69 * constraints_L_4_2;
    const real constraints_multipliers_81 = constraints_multipliers_76
        - constraints_multipliers_70 * constraints_L_4_2;
    const real constraints_L_4_1 = constraints_multipliers_69 * constraints_D_inverse_4;
    const real constraints_multipliers_82 = constraints_multipliers_77
        - constraints_multipliers_69 * constraints_L_4_1;
    const real constraints_D_inverse_3 = 1.0 / (constraints_multipliers_74
        - constraints_multipliers_71 * constraints_L_4_3);
    const real constraints_multipliers_83 = constraints_multipliers_79 * constraints_D_inverse_3;
    const real constraints_multipliers_84 = constraints_multipliers_78 * constraints_multipliers_83
        - constraints_multipliers_80;
    const real constraints_L_3_1 = constraints_multipliers_78 * constraints_D_inverse_3;
    const real constraints_multipliers_85 = constraints_multipliers_82
        - constraints_multipliers_78 * constraints_L_3_1;
    const real constraints_D_inverse_2 = 1.0 / (constraints_multipliers_81
        - constraints_multipliers_79 * constraints_multipliers_83);
    const real constraints_L_2_1 = constraints_multipliers_84 * constraints_D_inverse_2;
    const real constraints_D_inverse_1 = 1.0 / (constraints_multipliers_85
        - constraints_multipliers_84 * constraints_L_2_1);
    const real constraints_multipliers_86 = hinge2_drive - hinge3_drive * constraints_L_10_9;
    const real constraints_multipliers_87 = drift_drive_y - hinge3_drive * constraints_L_10_2
        - constraints_L_9_2 * constraints_multipliers_86;
    const real constraints_multipliers_88 = drift_drive_px - hinge3_drive * constraints_L_10_4
        - constraints_L_9_4 * constraints_multipliers_86;
    const real constraints_multipliers_89 = drift_drive_py - hinge3_drive * constraints_L_10_5
        - constraints_L_9_5 * constraints_multipliers_86;
    const real constraints_multipliers_90 = drift_drive_pz - hinge3_drive * constraints_L_10_6
        - constraints_L_9_6 * constraints_multipliers_86;
    const real constraints_multipliers_91 = hinge0_drive - hinge3_drive * constraints_L_10_7
        - constraints_L_9_7 * constraints_multipliers_86;
    const real constraints_multipliers_92 = hinge1_drive - hinge3_drive * constraints_L_10_8
        - constraints_L_9_8 * constraints_multipliers_86;
    const real constraints_multipliers_93 = constraints_multipliers_87
        - constraints_L_8_2 * constraints_multipliers_92;
    const real constraints_multipliers_94 = constraints_multipliers_88
        - constraints_L_8_4 * constraints_multipliers_92;
    const real constraints_multipliers_95 = constraints_multipliers_89
        - constraints_L_8_5 * constraints_multipliers_92;
    const real constraints_multipliers_96 = constraints_multipliers_90
        - constraints_L_8_6 * constraints_multipliers_92;
    const real constraints_multipliers_97 = constraints_multipliers_91
        - constraints_L_8_7 * constraints_multipliers_92;
    const real constraints_multipliers_98 = constraints_multipliers_93
        - constraints_L_7_2 * constraints_multipliers_97;
    const real constraints_multipliers_99 = constraints_multipliers_94
        + constraints_multipliers_55 * constraints_multipliers_97;
    const real constraints_multipliers_100 = constraints_multipliers_95
        + constraints_multipliers_51 * constraints_multipliers_97;
    const real constraints_multipliers_101 = constraints_multipliers_96
        + constraints_multipliers_47 * constraints_multipliers_97;
    const real constraints_multipliers_102 = constraints_multipliers_98
        - constraints_L_6_2 * constraints_multipliers_101;
    const real constraints_multipliers_103 = constraints_multipliers_99
        - constraints_L_6_4 * constraints_multipliers_101;
    const real constraints_multipliers_104 = constraints_multipliers_100
        - constraints_L_6_5 * constraints_multipliers_101;
    const real constraints_multipliers_105 = drift_drive_x
        - constraints_L_6_1 * constraints_multipliers_101
        - constraints_L_5_1 * constraints_multipliers_104;
    const real constraints_multipliers_106 = constraints_multipliers_102
        - constraints_L_5_2 * constraints_multipliers_104;
    const real constraints_multipliers_107 = drift_drive_z
        - constraints_L_6_3 * constraints_multipliers_101
        - constraints_L_5_3 * constraints_multipliers_104;
    const real constraints_multipliers_108 = constraints_multipliers_103
        - constraints_L_5_4 * constraints_multipliers_104;
    const real constraints_multipliers_109 = constraints_multipliers_105
        - constraints_L_4_1 * constraints_multipliers_108;
    const real constraints_multipliers_110 = constraints_multipliers_106
        - constraints_L_4_2 * constraints_multipliers_108;
    const real constraints_multipliers_111 = constraints_multipliers_107
        - constraints_L_4_3 * constraints_multipliers_108;
    const real constraints_multipliers_112 = constraints_multipliers_109
        - constraints_L_3_1 * constraints_multipliers_111;
    const real constraints_multipliers_113 = constraints_multipliers_110
        + constraints_multipliers_83 * constraints_multipliers_111;
    const real constraints_multipliers_114 = constraints_D_inverse_1 * (constraints_multipliers_112
        - constraints_L_2_1 * constraints_multipliers_113);
    const real constraints_multipliers_115 = constraints_D_inverse_2 * constraints_multipliers_113 -
        constraints_L_2_1 * constraints_multipliers_114;
    const real constraints_multipliers_116 = constraints_D_inverse_3 * constraints_multipliers_111 -
        constraints_L_3_1 * constraints_multipliers_114;
    const real constraints_multipliers_117 = constraints_multipliers_116
        + constraints_multipliers_83 * constraints_multipliers_115;
    const real constraints_multipliers_118 = constraints_D_inverse_4 * constraints_multipliers_108 -
        constraints_L_4_1 * constraints_multipliers_114;
    const real constraints_multipliers_119 = constraints_multipliers_118
        - constraints_L_4_2 * constraints_multipliers_115;
    const real constraints_multipliers_120 = constraints_multipliers_119
        - constraints_L_4_3 * constraints_multipliers_117;
    const real constraints_multipliers_121 = constraints_D_inverse_5 * constraints_multipliers_104 -
        constraints_L_5_1 * constraints_multipliers_114;
    const real constraints_multipliers_122 = constraints_multipliers_121
        - constraints_L_5_2 * constraints_multipliers_115;
    const real constraints_multipliers_123 = constraints_multipliers_122
        - constraints_L_5_3 * constraints_multipliers_117;
    const real constraints_multipliers_124 = constraints_multipliers_123
        - constraints_L_5_4 * constraints_multipliers_120;
    const real constraints_multipliers_125 = constraints_D_inverse_6 * constraints_multipliers_101 -
        constraints_L_6_1 * constraints_multipliers_114;
    const real constraints_multipliers_126 = constraints_multipliers_125
        - constraints_L_6_2 * constraints_multipliers_115;
    const real constraints_multipliers_127 = constraints_multipliers_126
        - constraints_L_6_3 * constraints_multipliers_117;
    const real constraints_multipliers_128 = constraints_multipliers_127
        - constraints_L_6_4 * constraints_multipliers_120;
    const real constraints_multipliers_129 = constraints_multipliers_128
        - constraints_L_6_5 * constraints_multipliers_124;
    const real constraints_multipliers_130 = constraints_D_inverse_7 * constraints_multipliers_97
        - constraints_L_7_2 * constraints_multipliers_115;
    const real constraints_multipliers_131 = constraints_multipliers_130
        + constraints_multipliers_55 * constraints_multipliers_120;
    const real constraints_multipliers_132 = constraints_multipliers_131
        + constraints_multipliers_51 * constraints_multipliers_124;
    const real constraints_multipliers_133 = constraints_multipliers_132
        + constraints_multipliers_47 * constraints_multipliers_129;
    const real constraints_multipliers_134 = constraints_D_inverse_8 * constraints_multipliers_92
        - constraints_L_8_2 * constraints_multipliers_115;
    const real constraints_multipliers_135 = constraints_multipliers_134
        - constraints_L_8_4 * constraints_multipliers_120;
    const real constraints_multipliers_136 = constraints_multipliers_135
        - constraints_L_8_5 * constraints_multipliers_124;
    const real constraints_multipliers_137 = constraints_multipliers_136
        - constraints_L_8_6 * constraints_multipliers_129;
    const real constraints_multipliers_138 = constraints_multipliers_137
        - constraints_L_8_7 * constraints_multipliers_133;
    const real constraints_multipliers_139 = constraints_D_inverse_9 * constraints_multipliers_86
        - constraints_L_9_2 * constraints_multipliers_115;
    const real constraints_multipliers_140 = constraints_multipliers_139
        - constraints_L_9_4 * constraints_multipliers_120;
    const real constraints_multipliers_141 = constraints_multipliers_140
        - constraints_L_9_5 * constraints_multipliers_124;
    const real constraints_multipliers_142 = constraints_multipliers_141
        - constraints_L_9_6 * constraints_multipliers_129;
    const real constraints_multipliers_143 = constraints_multipliers_142
        - constraints_L_9_7 * constraints_multipliers_133;
    const real constraints_multipliers_144 = constraints_multipliers_143
        - constraints_L_9_8 * constraints_multipliers_138;
    const real constraints_multipliers_145 = hinge3_drive * constraints_D_inverse_10
        - constraints_L_10_2 * constraints_multipliers_115;
    const real constraints_multipliers_146 = constraints_multipliers_145
        - constraints_L_10_4 * constraints_multipliers_120;
    const real constraints_multipliers_147 = constraints_multipliers_146
        - constraints_L_10_5 * constraints_multipliers_124;
    const real constraints_multipliers_148 = constraints_multipliers_147
        - constraints_L_10_6 * constraints_multipliers_129;
    const real constraints_multipliers_149 = constraints_multipliers_148
        - constraints_L_10_7 * constraints_multipliers_133;
    const real constraints_multipliers_150 = constraints_multipliers_149
        - constraints_L_10_8 * constraints_multipliers_138;
    const real constraints_multipliers_151 = constraints_multipliers_150
        - constraints_L_10_9 * constraints_multipliers_144;
    const real constraints_multipliers_152 = 2.0 - constraints_L_8_7;
    const real constraints_multipliers_153 = constraints_multipliers_55 *
        constraints_multipliers_152 - constraints_L_8_4;
    const real constraints_multipliers_154 = constraints_multipliers_51 *
        constraints_multipliers_152 - constraints_L_8_5;
    const real constraints_multipliers_155 = constraints_multipliers_47 *
        constraints_multipliers_152 - constraints_L_8_6;
    const real constraints_multipliers_156 = constraints_L_8_2
        + constraints_L_7_2 * constraints_multipliers_152
        + constraints_L_6_2 * constraints_multipliers_155;
    const real constraints_multipliers_157 = constraints_multipliers_153
        - constraints_L_6_4 * constraints_multipliers_155;
    const real constraints_multipliers_158 = constraints_multipliers_154
        - constraints_L_6_5 * constraints_multipliers_155;
    const real constraints_multipliers_159 = constraints_L_6_1 * constraints_multipliers_155
        + constraints_L_5_1 * constraints_multipliers_158;
    const real constraints_multipliers_160 = constraints_multipliers_156
        + constraints_L_5_2 * constraints_multipliers_158;
    const real constraints_multipliers_161 = constraints_L_6_3 * constraints_multipliers_155
        + constraints_L_5_3 * constraints_multipliers_158;
    const real constraints_multipliers_162 = constraints_multipliers_157
        - constraints_L_5_4 * constraints_multipliers_158;
    const real constraints_multipliers_163 = constraints_multipliers_159
        + constraints_L_4_1 * constraints_multipliers_162;
    const real constraints_multipliers_164 = constraints_multipliers_160
        + constraints_L_4_2 * constraints_multipliers_162;
    const real constraints_multipliers_165 = constraints_multipliers_161
        + constraints_L_4_3 * constraints_multipliers_162;
    const real constraints_multipliers_166 = constraints_L_3_1 * constraints_multipliers_165
        - constraints_multipliers_163;
    const real constraints_multipliers_167 = constraints_multipliers_164
        + constraints_multipliers_83 * constraints_multipliers_165;
    const real constraints_multipliers_168 = constraints_D_inverse_1 * (constraints_multipliers_166
        + constraints_L_2_1 * constraints_multipliers_167);
    const real constraints_multipliers_169 = constraints_D_inverse_2 * constraints_multipliers_167 +
        constraints_L_2_1 * constraints_multipliers_168;
    const real constraints_multipliers_170 = constraints_D_inverse_3 * constraints_multipliers_165 +
        constraints_L_3_1 * constraints_multipliers_168;
    const real constraints_multipliers_171 = constraints_multipliers_170
        + constraints_multipliers_83 * constraints_multipliers_169;
    const real constraints_multipliers_172 = constraints_D_inverse_4 * constraints_multipliers_162 -
        constraints_L_4_1 * constraints_multipliers_168;
    const real constraints_multipliers_173 = constraints_multipliers_172
        + constraints_L_4_2 * constraints_multipliers_169;
    const real constraints_multipliers_174 = constraints_multipliers_173
        + constraints_L_4_3 * constraints_multipliers_171;
    const real constraints_multipliers_175 = constraints_D_inverse_5 * constraints_multipliers_158 -
        constraints_L_5_1 * constraints_multipliers_168;
    const real constraints_multipliers_176 = constraints_multipliers_175
        + constraints_L_5_2 * constraints_multipliers_169;
    const real constraints_multipliers_177 = constraints_multipliers_176
        + constraints_L_5_3 * constraints_multipliers_171;
    const real constraints_multipliers_178 = constraints_multipliers_177
        - constraints_L_5_4 * constraints_multipliers_174;
    const real constraints_multipliers_179 = constraints_D_inverse_6 * constraints_multipliers_155 -
        constraints_L_6_1 * constraints_multipliers_168;
    const real constraints_multipliers_180 = constraints_multipliers_179
        + constraints_L_6_2 * constraints_multipliers_169;
    const real constraints_multipliers_181 = constraints_multipliers_180
        + constraints_L_6_3 * constraints_multipliers_171;
    const real constraints_multipliers_182 = constraints_multipliers_181
        - constraints_L_6_4 * constraints_multipliers_174;
    const real constraints_multipliers_183 = constraints_multipliers_182
        - constraints_L_6_5 * constraints_multipliers_178;
    const real constraints_multipliers_184 = constraints_D_inverse_7 * constraints_multipliers_152 +
        constraints_L_7_2 * constraints_multipliers_169;
    const real constraints_multipliers_185 = constraints_multipliers_184
        + constraints_multipliers_55 * constraints_multipliers_174;
    const real constraints_multipliers_186 = constraints_multipliers_185
        + constraints_multipliers_51 * constraints_multipliers_178;
    const real constraints_multipliers_187 = constraints_multipliers_186
        + constraints_multipliers_47 * constraints_multipliers_183;
    const real constraints_multipliers_188 = constraints_D_inverse_8
        + constraints_L_8_2 * constraints_multipliers_169;
    const real constraints_multipliers_189 = constraints_multipliers_188
        - constraints_L_8_4 * constraints_multipliers_174;
    const real constraints_multipliers_190 = constraints_multipliers_189
        - constraints_L_8_5 * constraints_multipliers_178;
    const real constraints_multipliers_191 = constraints_multipliers_190
        - constraints_L_8_6 * constraints_multipliers_183;
    const real constraints_multipliers_192 = constraints_multipliers_191
        - constraints_L_8_7 * constraints_multipliers_187;
    const real constraints_multipliers_193 = constraints_L_9_2 * constraints_multipliers_169
        - constraints_L_9_4 * constraints_multipliers_174;
    const real constraints_multipliers_194 = constraints_multipliers_193
        - constraints_L_9_5 * constraints_multipliers_178;
    const real constraints_multipliers_195 = constraints_multipliers_194
        - constraints_L_9_6 * constraints_multipliers_183;
    const real constraints_multipliers_196 = constraints_multipliers_195
        - constraints_L_9_7 * constraints_multipliers_187;
    const real constraints_multipliers_197 = constraints_multipliers_196
        - constraints_L_9_8 * constraints_multipliers_192;
    const real constraints_multipliers_198 = constraints_L_10_2 * constraints_multipliers_169
        - constraints_L_10_4 * constraints_multipliers_174;
    const real constraints_multipliers_199 = constraints_multipliers_198
        - constraints_L_10_5 * constraints_multipliers_178;
    const real constraints_multipliers_200 = constraints_multipliers_199
        - constraints_L_10_6 * constraints_multipliers_183;
    const real constraints_multipliers_201 = constraints_multipliers_200
        - constraints_L_10_7 * constraints_multipliers_187;
    const real constraints_multipliers_202 = constraints_multipliers_201
        - constraints_L_10_8 * constraints_multipliers_192;
    const real constraints_multipliers_203 = constraints_multipliers_202
        - constraints_L_10_9 * constraints_multipliers_197;
    const real constraints_multipliers_204 = -2.0 - constraints_L_9_7
        + constraints_L_9_8 * constraints_L_8_7;
    const real constraints_multipliers_205 = constraints_L_9_8 * constraints_L_8_2
        - constraints_L_9_2 - constraints_L_7_2 * constraints_multipliers_204;
    const real constraints_multipliers_206 = constraints_L_9_8 * constraints_L_8_4
        - constraints_L_9_4 + constraints_multipliers_55 * constraints_multipliers_204;
    const real constraints_multipliers_207 = constraints_L_9_8 * constraints_L_8_5
        - constraints_L_9_5 + constraints_multipliers_51 * constraints_multipliers_204;
    const real constraints_multipliers_208 = constraints_L_9_8 * constraints_L_8_6
        - constraints_L_9_6 + constraints_multipliers_47 * constraints_multipliers_204;
    const real constraints_multipliers_209 = constraints_multipliers_205
        - constraints_L_6_2 * constraints_multipliers_208;
    const real constraints_multipliers_210 = constraints_multipliers_206
        - constraints_L_6_4 * constraints_multipliers_208;
    const real constraints_multipliers_211 = constraints_multipliers_207
        - constraints_L_6_5 * constraints_multipliers_208;
    const real constraints_multipliers_212 = constraints_L_6_1 * constraints_multipliers_208
        + constraints_L_5_1 * constraints_multipliers_211;
    const real constraints_multipliers_213 = constraints_multipliers_209
        - constraints_L_5_2 * constraints_multipliers_211;
    const real constraints_multipliers_214 = constraints_L_6_3 * constraints_multipliers_208
        + constraints_L_5_3 * constraints_multipliers_211;
    const real constraints_multipliers_215 = constraints_multipliers_210
        - constraints_L_5_4 * constraints_multipliers_211;
    const real constraints_multipliers_216 = constraints_multipliers_212
        + constraints_L_4_1 * constraints_multipliers_215;
    const real constraints_multipliers_217 = constraints_multipliers_213
        - constraints_L_4_2 * constraints_multipliers_215;
    const real constraints_multipliers_218 = constraints_multipliers_214
        + constraints_L_4_3 * constraints_multipliers_215;
    const real constraints_multipliers_219 = constraints_L_3_1 * constraints_multipliers_218
        - constraints_multipliers_216;
    const real constraints_multipliers_220 = constraints_multipliers_217
        - constraints_multipliers_83 * constraints_multipliers_218;
    const real constraints_multipliers_221 = constraints_D_inverse_1 * (constraints_multipliers_219
        - constraints_L_2_1 * constraints_multipliers_220);
    const real constraints_multipliers_222 = constraints_D_inverse_2 * constraints_multipliers_220 -
        constraints_L_2_1 * constraints_multipliers_221;
    const real constraints_multipliers_223 = constraints_D_inverse_3 * constraints_multipliers_218 +
        constraints_L_3_1 * constraints_multipliers_221;
    const real constraints_multipliers_224 = constraints_multipliers_83 *
        constraints_multipliers_222 - constraints_multipliers_223;
    const real constraints_multipliers_225 = constraints_D_inverse_4 * constraints_multipliers_215 -
        constraints_L_4_1 * constraints_multipliers_221;
    const real constraints_multipliers_226 = constraints_multipliers_225
        - constraints_L_4_2 * constraints_multipliers_222;
    const real constraints_multipliers_227 = constraints_multipliers_226
        - constraints_L_4_3 * constraints_multipliers_224;
    const real constraints_multipliers_228 = constraints_D_inverse_5 * constraints_multipliers_211 -
        constraints_L_5_1 * constraints_multipliers_221;
    const real constraints_multipliers_229 = constraints_multipliers_228
        - constraints_L_5_2 * constraints_multipliers_222;
    const real constraints_multipliers_230 = constraints_multipliers_229
        - constraints_L_5_3 * constraints_multipliers_224;
    const real constraints_multipliers_231 = constraints_multipliers_230
        - constraints_L_5_4 * constraints_multipliers_227;
    const real constraints_multipliers_232 = constraints_D_inverse_6 * constraints_multipliers_208 -
        constraints_L_6_1 * constraints_multipliers_221;
    const real constraints_multipliers_233 = constraints_multipliers_232
        - constraints_L_6_2 * constraints_multipliers_222;
    const real constraints_multipliers_234 = constraints_multipliers_233
        - constraints_L_6_3 * constraints_multipliers_224;
    const real constraints_multipliers_235 = constraints_multipliers_234
        - constraints_L_6_4 * constraints_multipliers_227;
    const real constraints_multipliers_236 = constraints_multipliers_235
        - constraints_L_6_5 * constraints_multipliers_231;
    const real constraints_multipliers_237 = constraints_D_inverse_7 * constraints_multipliers_204 -
        constraints_L_7_2 * constraints_multipliers_222;
    const real constraints_multipliers_238 = constraints_multipliers_237
        + constraints_multipliers_55 * constraints_multipliers_227;
    const real constraints_multipliers_239 = constraints_multipliers_238
        + constraints_multipliers_51 * constraints_multipliers_231;
    const real constraints_multipliers_240 = constraints_multipliers_239
        + constraints_multipliers_47 * constraints_multipliers_236;
    const real constraints_multipliers_241 = constraints_L_9_8 * constraints_D_inverse_8
        + constraints_L_8_2 * constraints_multipliers_222;
    const real constraints_multipliers_242 = constraints_multipliers_241
        + constraints_L_8_4 * constraints_multipliers_227;
    const real constraints_multipliers_243 = constraints_multipliers_242
        + constraints_L_8_5 * constraints_multipliers_231;
    const real constraints_multipliers_244 = constraints_multipliers_243
        + constraints_L_8_6 * constraints_multipliers_236;
    const real constraints_multipliers_245 = constraints_multipliers_244
        + constraints_L_8_7 * constraints_multipliers_240;
    const real constraints_multipliers_246 = constraints_D_inverse_9
        - constraints_L_9_2 * constraints_multipliers_222;
    const real constraints_multipliers_247 = constraints_multipliers_246
        - constraints_L_9_4 * constraints_multipliers_227;
    const real constraints_multipliers_248 = constraints_multipliers_247
        - constraints_L_9_5 * constraints_multipliers_231;
    const real constraints_multipliers_249 = constraints_multipliers_248
        - constraints_L_9_6 * constraints_multipliers_236;
    const real constraints_multipliers_250 = constraints_multipliers_249
        - constraints_L_9_7 * constraints_multipliers_240;
    const real constraints_multipliers_251 = constraints_multipliers_250
        + constraints_L_9_8 * constraints_multipliers_245;
    const real constraints_multipliers_252 = constraints_L_10_2 * constraints_multipliers_222
        + constraints_L_10_4 * constraints_multipliers_227;
    const real constraints_multipliers_253 = constraints_multipliers_252
        + constraints_L_10_5 * constraints_multipliers_231;
    const real constraints_multipliers_254 = constraints_multipliers_253
        + constraints_L_10_6 * constraints_multipliers_236;
    const real constraints_multipliers_255 = constraints_multipliers_254
        + constraints_L_10_7 * constraints_multipliers_240;
    const real constraints_multipliers_256 = constraints_L_10_8 * constraints_multipliers_245
        - constraints_multipliers_255;
    const real constraints_multipliers_257 = constraints_multipliers_256
        - constraints_L_10_9 * constraints_multipliers_251;
    const real constraints_multipliers_258 = 2.0 - constraints_L_10_7
        + constraints_L_10_9 * constraints_L_9_7;
    const real constraints_multipliers_259 = constraints_L_10_9 * constraints_L_9_8
        - constraints_L_10_8;
    const real constraints_multipliers_260 = constraints_L_10_9 * constraints_L_9_2
        - constraints_L_10_2 - constraints_L_8_2 * constraints_multipliers_259;
    const real constraints_multipliers_261 = constraints_L_10_9 * constraints_L_9_4
        - constraints_L_10_4 - constraints_L_8_4 * constraints_multipliers_259;
    const real constraints_multipliers_262 = constraints_L_10_9 * constraints_L_9_5
        - constraints_L_10_5 - constraints_L_8_5 * constraints_multipliers_259;
    const real constraints_multipliers_263 = constraints_L_10_9 * constraints_L_9_6
        - constraints_L_10_6 - constraints_L_8_6 * constraints_multipliers_259;
    const real constraints_multipliers_264 = constraints_multipliers_258
        - constraints_L_8_7 * constraints_multipliers_259;
    const real constraints_multipliers_265 = constraints_multipliers_260
        - constraints_L_7_2 * constraints_multipliers_264;
    const real constraints_multipliers_266 = constraints_multipliers_261
        + constraints_multipliers_55 * constraints_multipliers_264;
    const real constraints_multipliers_267 = constraints_multipliers_262
        + constraints_multipliers_51 * constraints_multipliers_264;
    const real constraints_multipliers_268 = constraints_multipliers_263
        + constraints_multipliers_47 * constraints_multipliers_264;
    const real constraints_multipliers_269 = constraints_multipliers_265
        - constraints_L_6_2 * constraints_multipliers_268;
    const real constraints_multipliers_270 = constraints_multipliers_266
        - constraints_L_6_4 * constraints_multipliers_268;
    const real constraints_multipliers_271 = constraints_multipliers_267
        - constraints_L_6_5 * constraints_multipliers_268;
    const real constraints_multipliers_272 = constraints_L_6_1 * constraints_multipliers_268
        + constraints_L_5_1 * constraints_multipliers_271;
    const real constraints_multipliers_273 = constraints_multipliers_269
        - constraints_L_5_2 * constraints_multipliers_271;
    const real constraints_multipliers_274 = constraints_L_6_3 * constraints_multipliers_268
        + constraints_L_5_3 * constraints_multipliers_271;
    const real constraints_multipliers_275 = constraints_multipliers_270
        - constraints_L_5_4 * constraints_multipliers_271;
    const real constraints_multipliers_276 = constraints_multipliers_272
        + constraints_L_4_1 * constraints_multipliers_275;
    const real constraints_multipliers_277 = constraints_multipliers_273
        - constraints_L_4_2 * constraints_multipliers_275;
    const real constraints_multipliers_278 = constraints_multipliers_274
        + constraints_L_4_3 * constraints_multipliers_275;
    const real constraints_multipliers_279 = constraints_L_3_1 * constraints_multipliers_278
        - constraints_multipliers_276;
    const real constraints_multipliers_280 = constraints_multipliers_277
        - constraints_multipliers_83 * constraints_multipliers_278;
    const real constraints_multipliers_281 = constraints_D_inverse_1 * (constraints_multipliers_279
        - constraints_L_2_1 * constraints_multipliers_280);
    const real constraints_multipliers_282 = constraints_D_inverse_2 * constraints_multipliers_280 -
        constraints_L_2_1 * constraints_multipliers_281;
    const real constraints_multipliers_283 = constraints_D_inverse_3 * constraints_multipliers_278 +
        constraints_L_3_1 * constraints_multipliers_281;
    const real constraints_multipliers_284 = constraints_multipliers_83 *
        constraints_multipliers_282 - constraints_multipliers_283;
    const real constraints_multipliers_285 = constraints_D_inverse_4 * constraints_multipliers_275 -
        constraints_L_4_1 * constraints_multipliers_281;
    const real constraints_multipliers_286 = constraints_multipliers_285
        - constraints_L_4_2 * constraints_multipliers_282;
    const real constraints_multipliers_287 = constraints_multipliers_286
        - constraints_L_4_3 * constraints_multipliers_284;
    const real constraints_multipliers_288 = constraints_D_inverse_5 * constraints_multipliers_271 -
        constraints_L_5_1 * constraints_multipliers_281;
    const real constraints_multipliers_289 = constraints_multipliers_288
        - constraints_L_5_2 * constraints_multipliers_282;
    const real constraints_multipliers_290 = constraints_multipliers_289
        - constraints_L_5_3 * constraints_multipliers_284;
    const real constraints_multipliers_291 = constraints_multipliers_290
        - constraints_L_5_4 * constraints_multipliers_287;
    const real constraints_multipliers_292 = constraints_D_inverse_6 * constraints_multipliers_268 -
        constraints_L_6_1 * constraints_multipliers_281;
    const real constraints_multipliers_293 = constraints_multipliers_292
        - constraints_L_6_2 * constraints_multipliers_282;
    const real constraints_multipliers_294 = constraints_multipliers_293
        - constraints_L_6_3 * constraints_multipliers_284;
    const real constraints_multipliers_295 = constraints_multipliers_294
        - constraints_L_6_4 * constraints_multipliers_287;
    const real constraints_multipliers_296 = constraints_multipliers_295
        - constraints_L_6_5 * constraints_multipliers_291;
    const real constraints_multipliers_297 = constraints_D_inverse_7 * constraints_multipliers_264 -
        constraints_L_7_2 * constraints_multipliers_282;
    const real constraints_multipliers_298 = constraints_multipliers_297
        + constraints_multipliers_55 * constraints_multipliers_287;
    const real constraints_multipliers_299 = constraints_multipliers_298
        + constraints_multipliers_51 * constraints_multipliers_291;
    const real constraints_multipliers_300 = constraints_multipliers_299
        + constraints_multipliers_47 * constraints_multipliers_296;
    const real constraints_multipliers_301 = constraints_D_inverse_8 * constraints_multipliers_259 -
        constraints_L_8_2 * constraints_multipliers_282;
    const real constraints_multipliers_302 = constraints_multipliers_301
        - constraints_L_8_4 * constraints_multipliers_287;
    const real constraints_multipliers_303 = constraints_multipliers_302
        - constraints_L_8_5 * constraints_multipliers_291;
    const real constraints_multipliers_304 = constraints_multipliers_303
        - constraints_L_8_6 * constraints_multipliers_296;
    const real constraints_multipliers_305 = constraints_multipliers_304
        - constraints_L_8_7 * constraints_multipliers_300;
    const real constraints_multipliers_306 = constraints_L_10_9 * constraints_D_inverse_9
        + constraints_L_9_2 * constraints_multipliers_282;
    const real constraints_multipliers_307 = constraints_multipliers_306
        + constraints_L_9_4 * constraints_multipliers_287;
    const real constraints_multipliers_308 = constraints_multipliers_307
        + constraints_L_9_5 * constraints_multipliers_291;
    const real constraints_multipliers_309 = constraints_multipliers_308
        + constraints_L_9_6 * constraints_multipliers_296;
    const real constraints_multipliers_310 = constraints_multipliers_309
        + constraints_L_9_7 * constraints_multipliers_300;
    const real constraints_multipliers_311 = constraints_multipliers_310
        + constraints_L_9_8 * constraints_multipliers_305;
    const real constraints_multipliers_312 = constraints_D_inverse_10
        - constraints_L_10_2 * constraints_multipliers_282;
    const real constraints_multipliers_313 = constraints_multipliers_312
        - constraints_L_10_4 * constraints_multipliers_287;
    const real constraints_multipliers_314 = constraints_multipliers_313
        - constraints_L_10_5 * constraints_multipliers_291;
    const real constraints_multipliers_315 = constraints_multipliers_314
        - constraints_L_10_6 * constraints_multipliers_296;
    const real constraints_multipliers_316 = constraints_multipliers_315
        - constraints_L_10_7 * constraints_multipliers_300;
    const real constraints_multipliers_317 = constraints_multipliers_316
        - constraints_L_10_8 * constraints_multipliers_305;
    const real constraints_multipliers_318 = constraints_multipliers_317
        + constraints_L_10_9 * constraints_multipliers_311;
    const real constraints_multipliers_319 = 2.0 * constraints_multipliers_187;
    const real constraints_multipliers_320 = constraints_multipliers_192
        + constraints_multipliers_319;
    work[0] = constraints_multipliers_320;
    const real constraints_multipliers_321 = 2.0 * constraints_multipliers_240;
    const real constraints_multipliers_322 = constraints_multipliers_197
        - constraints_multipliers_319;
    work[1] = constraints_multipliers_322;
    work[3] = constraints_multipliers_322;
    const real constraints_multipliers_323 = constraints_multipliers_251
        - constraints_multipliers_321;
    work[4] = constraints_multipliers_323;
    const real constraints_multipliers_324 = constraints_multipliers_203
        + constraints_multipliers_319;
    work[2] = constraints_multipliers_324;
    work[6] = constraints_multipliers_324;
    const real constraints_multipliers_325 = constraints_multipliers_257
        + constraints_multipliers_321;
    work[5] = constraints_multipliers_325;
    work[7] = constraints_multipliers_325;
    const real constraints_multipliers_326 = constraints_multipliers_318
        + 2.0 * constraints_multipliers_300;
    work[8] = constraints_multipliers_326;
    const real constraints_multipliers_327 = 2.0 * constraints_multipliers_133;
    const real constraints_multipliers_328 = -(constraints_multipliers_138
        + constraints_multipliers_327);
    work[9] = constraints_multipliers_328;
    const real constraints_multipliers_329 = -(constraints_multipliers_144
        - constraints_multipliers_327);
    work[10] = constraints_multipliers_329;
    const real constraints_multipliers_330 = -(constraints_multipliers_151
        + constraints_multipliers_327);
    work[11] = constraints_multipliers_330;
    status |= CARDAN_SOLVE(semidefinite, 3, 1, work + 0, work + 9, work + 12);

    /* cable1: multiplier cable */
    const real cable1_multiplier_cable1 = work[9];

    /* cable2: multiplier cable */
    const real cable2_multiplier_cable2 = work[10];

    /* cable3: multiplier cable */
    const real cable3_multiplier_cable3 = work[11];

    /* constraints: multipliers */
    const real constraints_multipliers_331 = constraints_multipliers_168 * cable1_multiplier_cable1
        + constraints_multipliers_221 * cable2_multiplier_cable2;
    const real constraints_multipliers_332 = constraints_multipliers_222 * cable2_multiplier_cable2
        - constraints_multipliers_169 * cable1_multiplier_cable1;
    const real constraints_multipliers_333 = constraints_multipliers_224 * cable2_multiplier_cable2
        - constraints_multipliers_171 * cable1_multiplier_cable1;
    const real constraints_multipliers_334 = constraints_multipliers_174 * cable1_multiplier_cable1
        + constraints_multipliers_227 * cable2_multiplier_cable2;
    const real constraints_multipliers_335 = constraints_multipliers_178 * cable1_multiplier_cable1
        + constraints_multipliers_231 * cable2_multiplier_cable2;
    const real constraints_multipliers_336 = constraints_multipliers_183 * cable1_multiplier_cable1
        + constraints_multipliers_236 * cable2_multiplier_cable2;
    const real constraints_multipliers_337 = constraints_multipliers_187 * cable1_multiplier_cable1
        + constraints_multipliers_240 * cable2_multiplier_cable2;
    const real constraints_multipliers_338 = constraints_multipliers_192 * cable1_multiplier_cable1
        - constraints_multipliers_245 * cable2_multiplier_cable2;
    const real constraints_multipliers_339 = constraints_multipliers_197 * cable1_multiplier_cable1
        + constraints_multipliers_251 * cable2_multiplier_cable2;
    const real constraints_multipliers_340 = constraints_multipliers_203 * cable1_multiplier_cable1
        + constraints_multipliers_257 * cable2_multiplier_cable2;

    /* drift: udot, udot px, udot py, udot pz */
    /* udot: drift.u.xdot [rad/s^2] */
    out[0] = constraints_multipliers_331 + constraints_multipliers_281 * cable3_multiplier_cable3
        + constraints_multipliers_114;
    /* udot: drift.u.ydot [rad/s^2] */
    out[1] = constraints_multipliers_332 + constraints_multipliers_282 * cable3_multiplier_cable3
        + constraints_multipliers_115;
    /* udot: drift.u.zdot [rad/s^2] */
    out[2] = constraints_multipliers_333 + constraints_multipliers_284 * cable3_multiplier_cable3
        + constraints_multipliers_117;
    /* udot: drift.u.pxdot [m/s^2] */
    out[3] = constraints_multipliers_334 + constraints_multipliers_287 * cable3_multiplier_cable3
        + constraints_multipliers_120;
    /* udot: drift.u.pydot [m/s^2] */
    out[4] = constraints_multipliers_335 + constraints_multipliers_291 * cable3_multiplier_cable3
        + constraints_multipliers_124;
    /* udot: drift.u.pzdot [m/s^2] */
    out[5] = constraints_multipliers_336 + constraints_multipliers_296 * cable3_multiplier_cable3
        + constraints_multipliers_129;

    /* hinge0: udot */
    /* udot: hinge0.udot [rad/s^2] */
    out[6] = constraints_multipliers_337 + constraints_multipliers_300 * cable3_multiplier_cable3
        + constraints_multipliers_133;

    /* hinge1: udot */
    /* udot: hinge1.udot [rad/s^2] */
    out[7] = constraints_multipliers_338 + constraints_multipliers_305 * cable3_multiplier_cable3
        + constraints_multipliers_138;

    /* hinge2: udot */
    /* udot: hinge2.udot [rad/s^2] */
    out[8] = constraints_multipliers_339 - constraints_multipliers_311 * cable3_multiplier_cable3
        + constraints_multipliers_144;

    /* hinge3: udot */
    /* udot: hinge3.udot [rad/s^2] */
    out[9] = constraints_multipliers_340 + constraints_multipliers_318 * cable3_multiplier_cable3
        + constraints_multipliers_151;
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {10, 24, 35, 0, 11, 10, 0, 0, 0, 30, 0, 0, 0, 0, 10, 0, 0, 0, 0};
#endif
