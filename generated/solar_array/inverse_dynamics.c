/*
 * inverse_dynamics of solar_array
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 10, work 0, w 23
 * Operations per call: 392 = 213 mul, 103 add, 68 sub, 4 cos, 4 sin
 * Operations of prepare: 81 = 37 add, 29 mul, 15 sub
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
 * Input udot (10): derivatives of the speeds
 *   udot[0]  drift.u.xdot [rad/s^2]
 *   udot[1]  drift.u.ydot [rad/s^2]
 *   udot[2]  drift.u.zdot [rad/s^2]
 *   udot[3]  drift.u.pxdot [m/s^2]
 *   udot[4]  drift.u.pydot [m/s^2]
 *   udot[5]  drift.u.pzdot [m/s^2]
 *   udot[6]  hinge0.udot [rad/s^2]
 *   udot[7]  hinge1.udot [rad/s^2]
 *   udot[8]  hinge2.udot [rad/s^2]
 *   udot[9]  hinge3.udot [rad/s^2]
 *
 * Output tau (10)
 *   out[0]  drift.u.x.tau [N*m]
 *   out[1]  drift.u.y.tau [N*m]
 *   out[2]  drift.u.z.tau [N*m]
 *   out[3]  drift.u.px.tau [N]
 *   out[4]  drift.u.py.tau [N]
 *   out[5]  drift.u.pz.tau [N]
 *   out[6]  hinge0.u.tau [N*m]
 *   out[7]  hinge1.u.tau [N*m]
 *   out[8]  hinge2.u.tau [N*m]
 *   out[9]  hinge3.u.tau [N*m]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
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
    w[7] = panel2_first_moment_x + hinge3_position_x * panel3_mass; /* panel2_base_moment_x */

    /* panel3: first moment, mass, inertia, base */
    const wreal panel3_com_x = p[24]; /* m */
    const wreal panel3_inertia_yy = p[26]; /* kg m^2 */
    const wreal panel3_inertia_zz = p[27]; /* kg m^2 */
    const wreal panel3_first_moment_x = panel3_mass * panel3_com_x;
    const wreal panel3_mass_2 = panel3_com_x * panel3_first_moment_x;
    const wreal panel3_inertia_yy_2 = panel3_inertia_yy + panel3_mass_2;
    const wreal panel3_inertia_zz_2 = panel3_inertia_zz + panel3_mass_2;
    const wreal panel3_base = 0.5 * panel3_mass * hinge3_position_x * hinge3_position_x;
    const wreal panel3_base_2 = panel2_mass + panel3_mass;
    w[4] = panel3_first_moment_x; /* panel3_first_moment_x */

    /* panel2: base */
    const wreal hinge2_position_x = p[16]; /* m */
    const wreal panel2_base = 0.5 * panel3_base_2 * hinge2_position_x * hinge2_position_x;
    const wreal panel2_base_2 = panel1_mass + panel3_base_2;

    /* panel1: base moment, base */
    const wreal hinge1_position_x = p[10]; /* m */
    const wreal panel1_base = 0.5 * panel2_base_2 * hinge1_position_x * hinge1_position_x;
    const wreal panel1_base_2 = panel0_mass + panel2_base_2;
    w[8] = panel1_first_moment_x + hinge2_position_x * panel3_base_2; /* panel1_base_moment_x */

    /* panel0: base moment, base */
    const wreal hinge0_position_x = p[4]; /* m */
    const wreal panel0_base = 0.5 * panel1_base_2 * hinge0_position_x * hinge0_position_x;
    w[9] = panel0_first_moment_x + hinge1_position_x * panel2_base_2; /* panel0_base_moment_x */

    /* hub: base moment, base mass */
    const wreal hub_mass = p[0]; /* kg */
    w[10] = hinge0_position_x * panel1_base_2; /* hub_base_moment_x */
    w[11] = hub_mass + panel1_base_2; /* hub_base_mass */

    /* common */
    const wreal hub_inertia_xx = p[1]; /* kg m^2 */
    const wreal hub_inertia_yy = p[2]; /* kg m^2 */
    const wreal hub_inertia_zz = p[3]; /* kg m^2 */
    const wreal panel0_inertia_xx = p[7]; /* kg m^2 */
    const wreal panel1_inertia_xx = p[13]; /* kg m^2 */
    const wreal panel2_inertia_xx = p[19]; /* kg m^2 */
    const wreal panel3_inertia_xx = p[25]; /* kg m^2 */
    const wreal mul_1 = 0.5 * (hub_inertia_xx + hub_inertia_zz + hub_inertia_yy);
    const wreal mul_1_2 = 0.5 * (panel0_inertia_xx + panel0_inertia_zz_2 + panel0_inertia_yy_2);
    const wreal mul_1_3 = 0.5 * (panel1_inertia_xx + panel1_inertia_zz_2 + panel1_inertia_yy_2);
    const wreal mul_1_4 = 0.5 * (panel2_inertia_xx + panel2_inertia_zz_2 + panel2_inertia_yy_2);
    const wreal mul_1_5 = 0.5 * (panel3_inertia_xx + panel3_inertia_zz_2 + panel3_inertia_yy_2);

    /* hub: base second moment */
    w[12] = mul_1 - hub_inertia_zz; /* hub_base_second_moment_zz */
    w[21] = mul_1 - hub_inertia_xx + (panel0_base + panel0_base); /* hub_base_second_moment_xx */

    /* panel0: base second moment, base */
    const wreal panel0_base_2 = mul_1_5 - panel3_inertia_yy_2 + (mul_1 - hub_inertia_yy
        + (mul_1_2 - panel0_inertia_yy_2));
    w[13] = mul_1_2 - panel0_inertia_zz_2; /* panel0_base_second_moment_zz */
    /* panel0_base_second_moment_xx */
    w[20] = mul_1_2 - panel0_inertia_xx + (panel1_base + panel1_base);

    /* panel1: base second moment */
    w[14] = mul_1_3 - panel1_inertia_zz_2; /* panel1_base_second_moment_zz */
    /* panel1_base_second_moment_xx */
    w[19] = mul_1_3 - panel1_inertia_xx + (panel2_base + panel2_base);

    /* panel2: base second moment */
    w[15] = mul_1_4 - panel2_inertia_zz_2; /* panel2_base_second_moment_zz */
    /* panel2_base_second_moment_xx */
    w[18] = mul_1_4 - panel2_inertia_xx + (panel3_base + panel3_base);

    /* panel3: base second moment */
    w[16] = mul_1_5 - panel3_inertia_xx; /* panel3_base_second_moment_xx */
    w[17] = mul_1_5 - panel3_inertia_zz_2; /* panel3_base_second_moment_zz */

    /* hub: base second moment */
    /* hub_base_second_moment_yy */
    w[22] = mul_1_3 - panel1_inertia_yy_2 + (mul_1_4 - panel2_inertia_yy_2) + panel0_base_2;

    /* parameters as they are */
    w[0] = p[4]; /* hinge0.position.x [m] */
    w[1] = p[10]; /* hinge1.position.x [m] */
    w[2] = p[16]; /* hinge2.position.x [m] */
    w[3] = p[22]; /* hinge3.position.x [m] */
    w[5] = p[28]; /* spring.stiffness [N*m/rad] */
    w[6] = p[29]; /* spring.damping [N*m*s/rad] */
}

#include "lanes.h"

/* tau with M udot + h = f + tau */
CARDAN_API int inverse_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    const real *const udot = in->udot;
    (void)work;

    /* shared by several: cos, sin */
    const real hinge0_q = q[7]; /* rad */
    const real hinge1_q = q[8]; /* rad */
    const real hinge2_q = q[9]; /* rad */
    const real hinge3_q = q[10]; /* rad */
    const real angle[CARDAN_PADDED(4)] = {hinge0_q, hinge1_q, hinge2_q, hinge3_q};
    real sine[CARDAN_PADDED(4)], cosine[CARDAN_PADDED(4)];
    cardan_sincos(4, angle, sine, cosine);
    const real hinge0_cos = cosine[0];
    const real hinge0_sin = sine[0];
    const real hinge1_cos = cosine[1];
    const real hinge1_sin = sine[1];
    const real hinge2_cos = cosine[2];
    const real hinge2_sin = sine[2];
    const real hinge3_cos = cosine[3];
    const real hinge3_sin = sine[3];

    /* drift: R */
    const real drift_w = q[0];
    const real drift_x = q[1];
    const real drift_y = q[2];
    const real drift_z = q[3];
    const real drift_R = 2.0 * drift_x;
    const real drift_R_2 = 2.0 * drift_y;
    const real drift_R_3 = 2.0 * drift_z;
    const real drift_R_4 = drift_w * drift_R;
    const real drift_R_5 = 1.0 - drift_x * drift_R;
    const real drift_R_6 = drift_w * drift_R_2;
    const real drift_R_7 = drift_w * drift_R_3;
    const real drift_R_8 = drift_x * drift_R_2;
    const real drift_R_9 = drift_y * drift_R_2;
    const real drift_R_10 = drift_x * drift_R_3;
    const real drift_R_11 = drift_y * drift_R_3;
    const real drift_R_12 = drift_z * drift_R_3;
    const real drift_R_xx = 1.0 - drift_R_9 - drift_R_12;
    const real drift_R_yy = drift_R_5 - drift_R_12;
    const real drift_R_zz = drift_R_5 - drift_R_9;
    const real drift_R_xy = drift_R_8 - drift_R_7;
    const real drift_R_yx = drift_R_7 + drift_R_8;
    const real drift_R_xz = drift_R_6 + drift_R_10;
    const real drift_R_zx = drift_R_10 - drift_R_6;
    const real drift_R_yz = drift_R_11 - drift_R_4;
    const real drift_R_zy = drift_R_4 + drift_R_11;

    /* hub: a, U, n */
    const real drift_u_x = u[0]; /* rad/s */
    const real drift_u_y = u[1]; /* rad/s */
    const real drift_u_z = u[2]; /* rad/s */
    const real drift_u_xdot = udot[0]; /* rad/s^2 */
    const real drift_u_ydot = udot[1]; /* rad/s^2 */
    const real drift_u_zdot = udot[2]; /* rad/s^2 */
    const real drift_u_pxdot = udot[3]; /* m/s^2 */
    const real drift_u_pydot = udot[4]; /* m/s^2 */
    const real drift_u_pzdot = udot[5]; /* m/s^2 */
    const wreal hub_base_moment_x = w[10];
    const wreal hub_base_second_moment_xx = w[21];
    const wreal hub_base_second_moment_yy = w[22];
    const real hub_a_x = drift_u_pydot * drift_R_yx + drift_u_pzdot * drift_R_zx
        + drift_u_pxdot * drift_R_xx;
    const real hub_a_y = drift_u_pxdot * drift_R_xy + drift_u_pzdot * drift_R_zy
        + drift_u_pydot * drift_R_yy;
    const real hub_a_z = drift_u_pxdot * drift_R_xz + drift_u_pydot * drift_R_yz
        + drift_u_pzdot * drift_R_zz;
    const real hub_U = drift_u_y * drift_u_y + drift_u_z * drift_u_z;
    const real hub_U_2 = drift_u_x * drift_u_y;
    const real hub_U_3 = drift_u_x * drift_u_z;
    const real hub_U_4 = drift_u_y * drift_u_z;
    const real hub_U_xy = hub_U_2 - drift_u_zdot;
    const real hub_U_yx = drift_u_zdot + hub_U_2;
    const real hub_U_xz = drift_u_ydot + hub_U_3;
    const real hub_U_zx = hub_U_3 - drift_u_ydot;
    const real hub_U_yz = hub_U_4 - drift_u_xdot;
    const real hub_U_zy = drift_u_xdot + hub_U_4;
    const real hub_n = hub_base_second_moment_xx * hub_U_yx
        - hub_base_second_moment_yy * hub_U_xy + hub_base_moment_x * hub_a_y;

    /* panel0: omega, alpha, a, U, n */
    const real hinge0_u = u[6]; /* rad/s */
    const real hinge0_udot = udot[6]; /* rad/s^2 */
    const wreal hinge0_position_x = w[0]; /* m */
    const wreal panel0_base_moment_x = w[9];
    const wreal panel0_base_second_moment_zz = w[13];
    const wreal panel0_base_second_moment_xx = w[20];
    const real panel0_omega_x = drift_u_x * hinge0_cos - drift_u_z * hinge0_sin;
    const real panel0_omega_z = drift_u_x * hinge0_sin + drift_u_z * hinge0_cos;
    const real panel0_omega_y = drift_u_y + hinge0_u;
    const real panel0_alpha_x = drift_u_xdot * hinge0_cos - drift_u_zdot * hinge0_sin
        - hinge0_u * panel0_omega_z;
    const real panel0_alpha_z = drift_u_xdot * hinge0_sin + drift_u_zdot * hinge0_cos
        + hinge0_u * panel0_omega_x;
    const real panel0_alpha_y = drift_u_ydot + hinge0_udot;
    const real panel0_a = hub_a_x - hinge0_position_x * hub_U;
    const real panel0_a_y = hub_a_y + hinge0_position_x * hub_U_yx;
    const real panel0_a_2 = hub_a_z + hinge0_position_x * hub_U_zx;
    const real panel0_a_x = hinge0_cos * panel0_a - hinge0_sin * panel0_a_2;
    const real panel0_a_z = hinge0_sin * panel0_a + hinge0_cos * panel0_a_2;
    const real panel0_U = panel0_omega_y * panel0_omega_y + panel0_omega_z * panel0_omega_z;
    const real panel0_U_2 = panel0_omega_x * panel0_omega_z;
    const real panel0_U_yx = panel0_alpha_z + panel0_omega_x * panel0_omega_y;
    const real panel0_U_yz = panel0_omega_z * panel0_omega_y - panel0_alpha_x;
    const real panel0_U_xz = panel0_alpha_y + panel0_U_2;
    const real panel0_U_zx = panel0_U_2 - panel0_alpha_y;
    const real panel0_n = panel0_base_second_moment_zz * panel0_U_xz
        - panel0_base_moment_x * panel0_a_z - panel0_base_second_moment_xx * panel0_U_zx;

    /* panel1: omega, alpha, a, U, n */
    const real hinge1_u = u[7]; /* rad/s */
    const real hinge1_udot = udot[7]; /* rad/s^2 */
    const wreal hinge1_position_x = w[1]; /* m */
    const wreal panel1_base_moment_x = w[8];
    const wreal panel1_base_second_moment_zz = w[14];
    const wreal panel1_base_second_moment_xx = w[19];
    const real panel1_omega_x = panel0_omega_x * hinge1_cos - panel0_omega_z * hinge1_sin;
    const real panel1_omega_z = panel0_omega_x * hinge1_sin + panel0_omega_z * hinge1_cos;
    const real panel1_omega_y = hinge1_u + panel0_omega_y;
    const real panel1_alpha_y = hinge1_udot + panel0_alpha_y;
    const real panel1_alpha_x = hinge1_cos * panel0_alpha_x - hinge1_sin * panel0_alpha_z
        - hinge1_u * panel1_omega_z;
    const real panel1_alpha_z = hinge1_u * panel1_omega_x + hinge1_sin * panel0_alpha_x
        + hinge1_cos * panel0_alpha_z;
    const real panel1_a = panel0_a_x - hinge1_position_x * panel0_U;
    const real panel1_a_y = panel0_a_y + hinge1_position_x * panel0_U_yx;
    const real panel1_a_2 = panel0_a_z + hinge1_position_x * panel0_U_zx;
    const real panel1_a_x = hinge1_cos * panel1_a - hinge1_sin * panel1_a_2;
    const real panel1_a_z = hinge1_sin * panel1_a + hinge1_cos * panel1_a_2;
    const real panel1_U = panel1_omega_y * panel1_omega_y + panel1_omega_z * panel1_omega_z;
    const real panel1_U_2 = panel1_omega_x * panel1_omega_z;
    const real panel1_U_yx = panel1_alpha_z + panel1_omega_x * panel1_omega_y;
    const real panel1_U_yz = panel1_omega_z * panel1_omega_y - panel1_alpha_x;
    const real panel1_U_xz = panel1_alpha_y + panel1_U_2;
    const real panel1_U_zx = panel1_U_2 - panel1_alpha_y;
    const real panel1_n = panel1_base_second_moment_zz * panel1_U_xz
        - panel1_base_second_moment_xx * panel1_U_zx - panel1_base_moment_x * panel1_a_z;

    /* panel2: omega, alpha, a, U, n */
    const real hinge2_u = u[8]; /* rad/s */
    const real hinge2_udot = udot[8]; /* rad/s^2 */
    const wreal hinge2_position_x = w[2]; /* m */
    const wreal panel2_base_moment_x = w[7];
    const wreal panel2_base_second_moment_zz = w[15];
    const wreal panel2_base_second_moment_xx = w[18];
    const real panel2_omega_x = panel1_omega_x * hinge2_cos - panel1_omega_z * hinge2_sin;
    const real panel2_omega_z = panel1_omega_x * hinge2_sin + panel1_omega_z * hinge2_cos;
    const real panel2_omega_y = hinge2_u + panel1_omega_y;
    const real panel2_alpha_y = hinge2_udot + panel1_alpha_y;
    const real panel2_alpha_x = hinge2_cos * panel1_alpha_x - hinge2_u * panel2_omega_z
        - hinge2_sin * panel1_alpha_z;
    const real panel2_alpha_z = hinge2_u * panel2_omega_x + hinge2_sin * panel1_alpha_x
        + hinge2_cos * panel1_alpha_z;
    const real panel2_a = panel1_a_x - hinge2_position_x * panel1_U;
    const real panel2_a_y = panel1_a_y + hinge2_position_x * panel1_U_yx;
    const real panel2_a_2 = panel1_a_z + hinge2_position_x * panel1_U_zx;
    const real panel2_a_x = hinge2_cos * panel2_a - hinge2_sin * panel2_a_2;
    const real panel2_a_z = hinge2_sin * panel2_a + hinge2_cos * panel2_a_2;
    const real panel2_U = panel2_omega_y * panel2_omega_y + panel2_omega_z * panel2_omega_z;
    const real panel2_U_2 = panel2_omega_x * panel2_omega_z;
    const real panel2_U_yx = panel2_alpha_z + panel2_omega_x * panel2_omega_y;
    const real panel2_U_yz = panel2_omega_z * panel2_omega_y - panel2_alpha_x;
    const real panel2_U_xz = panel2_alpha_y + panel2_U_2;
    const real panel2_U_zx = panel2_U_2 - panel2_alpha_y;
    const real panel2_n = panel2_base_second_moment_zz * panel2_U_xz
        - panel2_base_second_moment_xx * panel2_U_zx - panel2_base_moment_x * panel2_a_z;

    /* panel3: omega, alpha, a, inertia force, U, n, f */
    const real hinge3_u = u[9]; /* rad/s */
    const real hinge3_udot = udot[9]; /* rad/s^2 */
    const wreal hinge3_position_x = w[3]; /* m */
    const wreal panel3_first_moment_x = w[4];
    const wreal panel3_base_second_moment_xx = w[16];
    const wreal panel3_base_second_moment_zz = w[17];
    const real panel3_omega_x = panel2_omega_x * hinge3_cos - panel2_omega_z * hinge3_sin;
    const real panel3_omega_z = panel2_omega_x * hinge3_sin + panel2_omega_z * hinge3_cos;
    const real panel3_omega_y = hinge3_u + panel2_omega_y;
    const real panel3_alpha_y = hinge3_udot + panel2_alpha_y;
    const real panel3_alpha_x = hinge3_cos * panel2_alpha_x - hinge3_u * panel3_omega_z
        - hinge3_sin * panel2_alpha_z;
    const real panel3_alpha_z = hinge3_u * panel3_omega_x + hinge3_sin * panel2_alpha_x
        + hinge3_cos * panel2_alpha_z;
    const real panel3_a_y = panel2_a_y + hinge3_position_x * panel2_U_yx;
    const real panel3_a_z = hinge3_sin * (panel2_a_x - hinge3_position_x * panel2_U)
        + hinge3_cos * (panel2_a_z + hinge3_position_x * panel2_U_zx);
    const real panel3_inertia_force = panel3_first_moment_x * (panel3_omega_y * panel3_omega_y
        + panel3_omega_z * panel3_omega_z);
    const real panel3_U_yx = panel3_alpha_z + panel3_omega_x * panel3_omega_y;
    const real panel3_U = panel3_omega_x * panel3_omega_z;
    const real panel3_U_yz = panel3_omega_z * panel3_omega_y - panel3_alpha_x;
    const real panel3_inertia_force_2 = panel3_base_second_moment_zz * panel3_U_yz;
    const real panel3_U_xz = panel3_alpha_y + panel3_U;
    const real panel3_U_zx = panel3_U - panel3_alpha_y;
    const real panel3_n_y = panel3_base_second_moment_zz * panel3_U_xz
        - panel3_base_second_moment_xx * panel3_U_zx - panel3_first_moment_x * panel3_a_z;
    const real panel3_f_z = panel3_first_moment_x * panel3_U_zx;
    const real panel3_n_z = panel3_base_second_moment_xx * panel3_U_yx
        + panel3_first_moment_x * panel3_a_y;
    const real panel3_f_y = panel3_first_moment_x * panel3_U_yx;
    const real panel3_f = hinge3_sin * panel3_inertia_force + hinge3_cos * panel3_f_z;
    out[9] = panel3_n_y; /* tau: hinge3.u.tau [N*m] */

    /* panel2: f, n */
    const real panel2_f_y = panel2_base_moment_x * panel2_U_yx + panel3_f_y;
    const real panel2_f_x = hinge3_sin * panel3_f_z - panel2_base_moment_x * panel2_U
        - hinge3_cos * panel3_inertia_force;
    const real panel2_f_z = panel2_base_moment_x * panel2_U_zx + panel3_f;
    const real panel2_n_y = panel2_n - hinge3_position_x * panel3_f + panel3_n_y;
    const real panel2_n_2 = panel2_base_second_moment_xx * panel2_U_yx
        + panel2_base_moment_x * panel2_a_y + hinge3_sin * panel3_inertia_force_2;
    const real panel2_n_x = hinge3_sin * panel3_n_z - (panel2_base_second_moment_zz * panel2_U_yz
        + hinge3_cos * panel3_inertia_force_2);
    const real panel2_n_z = hinge3_cos * panel3_n_z + hinge3_position_x * panel3_f_y + panel2_n_2;
    const real panel2_f = hinge2_cos * panel2_f_z - hinge2_sin * panel2_f_x;
    out[8] = panel2_n_y; /* tau: hinge2.u.tau [N*m] */

    /* panel1: f, n */
    const real panel1_f_y = panel1_base_moment_x * panel1_U_yx + panel2_f_y;
    const real panel1_n_2 = panel1_base_second_moment_xx * panel1_U_yx
        + panel1_base_moment_x * panel1_a_y + hinge2_position_x * panel2_f_y;
    const real panel1_f_x = hinge2_cos * panel2_f_x - panel1_base_moment_x * panel1_U
        + hinge2_sin * panel2_f_z;
    const real panel1_f_z = panel1_base_moment_x * panel1_U_zx + panel2_f;
    const real panel1_n_y = panel2_n_y + panel1_n - hinge2_position_x * panel2_f;
    const real panel1_n_x = hinge2_cos * panel2_n_x - panel1_base_second_moment_zz * panel1_U_yz
        + hinge2_sin * panel2_n_z;
    const real panel1_n_z = panel1_n_2 - hinge2_sin * panel2_n_x + hinge2_cos * panel2_n_z;
    const real panel1_f = hinge1_cos * panel1_f_z - hinge1_sin * panel1_f_x;
    out[7] = panel1_n_y; /* tau: hinge1.u.tau [N*m] */

    /* panel0: f, n */
    const real panel0_f_y = panel0_base_moment_x * panel0_U_yx + panel1_f_y;
    const real panel0_n_2 = panel0_base_second_moment_xx * panel0_U_yx
        + panel0_base_moment_x * panel0_a_y + hinge1_position_x * panel1_f_y;
    const real panel0_f_x = hinge1_cos * panel1_f_x - panel0_base_moment_x * panel0_U
        + hinge1_sin * panel1_f_z;
    const real panel0_f_z = panel0_base_moment_x * panel0_U_zx + panel1_f;
    const real panel0_n_y = panel1_n_y + panel0_n - hinge1_position_x * panel1_f;
    const real panel0_n_x = hinge1_cos * panel1_n_x - panel0_base_second_moment_zz * panel0_U_yz
        + hinge1_sin * panel1_n_z;
    const real panel0_n_z = hinge1_cos * panel1_n_z + panel0_n_2 - hinge1_sin * panel1_n_x;
    const real panel0_f = hinge0_cos * panel0_f_z - hinge0_sin * panel0_f_x;

    /* hub: f, n */
    const wreal hub_base_mass = w[11];
    const wreal hub_base_second_moment_zz = w[12];
    const real hub_f_y = hub_base_mass * hub_a_y + hub_base_moment_x * hub_U_yx + panel0_f_y;
    const real hub_n_2 = hub_base_second_moment_zz * hub_U_xz
        - hub_base_second_moment_xx * hub_U_zx - hub_base_moment_x * hub_a_z + panel0_n_y;
    const real hub_f_x = hub_base_mass * hub_a_x - hub_base_moment_x * hub_U
        + hinge0_cos * panel0_f_x + hinge0_sin * panel0_f_z;
    const real hub_f_z = hub_base_mass * hub_a_z + hub_base_moment_x * hub_U_zx + panel0_f;
    const real hub_n_3 = hub_base_second_moment_yy * hub_U_zy
        - hub_base_second_moment_zz * hub_U_yz + hinge0_cos * panel0_n_x;
    out[1] = hub_n_2 - hinge0_position_x * panel0_f; /* tau: drift.u.y.tau [N*m] */
    out[0] = hinge0_sin * panel0_n_z + hub_n_3; /* tau: drift.u.x.tau [N*m] */
    /* tau: drift.u.z.tau [N*m] */
    out[2] = hinge0_position_x * panel0_f_y + hub_n + hinge0_cos * panel0_n_z
        - hinge0_sin * panel0_n_x;

    /* hinge0: tau */
    const wreal spring_stiffness = w[5]; /* N*m/rad */
    const wreal spring_damping = w[6]; /* N*m*s/rad */
    /* tau: hinge0.u.tau [N*m] */
    out[6] = hinge0_q * spring_stiffness + hinge0_u * spring_damping + panel0_n_y;

    /* drift: tau px, tau py, tau pz */
    /* tau: drift.u.px.tau [N] */
    out[3] = drift_R_xx * hub_f_x + drift_R_xy * hub_f_y + drift_R_xz * hub_f_z;
    /* tau: drift.u.py.tau [N] */
    out[4] = drift_R_yx * hub_f_x + drift_R_yy * hub_f_y + drift_R_yz * hub_f_z;
    /* tau: drift.u.pz.tau [N] */
    out[5] = drift_R_zx * hub_f_x + drift_R_zy * hub_f_y + drift_R_zz * hub_f_z;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {10, 0, 23, 0, 11, 10, 0, 0, 0, 30, 0, 10, 0, 0, 0, 0, 0, 0, 0};
#endif
