/*
 * inverse_dynamics of solar_array
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 10, work 0, w 23
 * Operations per call: 392 = 213 mul, 103 add, 68 sub, 4 cos, 4 sin
 * Operations of prepare: 69 = 33 add, 21 mul, 15 sub
 *
 * Input q (11): generalized coordinates
 *   q[0]  drift.qw
 *   q[1]  drift.qx
 *   q[2]  drift.qy
 *   q[3]  drift.qz
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
    /* panel0: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal panel0_mass = p[5]; /* kg */
    const wreal panel0_com_x = p[6]; /* m */
    const wreal panel0_inertia_xx = p[7]; /* kg m^2 */
    const wreal panel0_inertia_yy = p[8]; /* kg m^2 */
    const wreal panel0_inertia_zz = p[9]; /* kg m^2 */
    const wreal panel0_first_moment_x = panel0_mass * panel0_com_x;
    const wreal panel0_com_x_times_first_moment_x = panel0_com_x * panel0_first_moment_x;
    const wreal panel0_origin_inertia_yy = panel0_inertia_yy + panel0_com_x_times_first_moment_x;
    const wreal panel0_origin_inertia_zz = panel0_inertia_zz + panel0_com_x_times_first_moment_x;
    const wreal panel0_base_half_trace = 0.5 * (panel0_inertia_xx + panel0_origin_inertia_zz
        + panel0_origin_inertia_yy);
    const wreal panel0_base_second_moment_zz = panel0_base_half_trace - panel0_origin_inertia_zz;
    w[13] = panel0_base_second_moment_zz;

    /* panel1: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal panel1_mass = p[11]; /* kg */
    const wreal panel1_com_x = p[12]; /* m */
    const wreal panel1_inertia_xx = p[13]; /* kg m^2 */
    const wreal panel1_inertia_yy = p[14]; /* kg m^2 */
    const wreal panel1_inertia_zz = p[15]; /* kg m^2 */
    const wreal panel1_first_moment_x = panel1_mass * panel1_com_x;
    const wreal panel1_com_x_times_first_moment_x = panel1_com_x * panel1_first_moment_x;
    const wreal panel1_origin_inertia_yy = panel1_inertia_yy + panel1_com_x_times_first_moment_x;
    const wreal panel1_origin_inertia_zz = panel1_inertia_zz + panel1_com_x_times_first_moment_x;
    const wreal panel1_base_half_trace = 0.5 * (panel1_inertia_xx + panel1_origin_inertia_zz
        + panel1_origin_inertia_yy);
    const wreal panel1_base_second_moment_zz = panel1_base_half_trace - panel1_origin_inertia_zz;
    w[14] = panel1_base_second_moment_zz;

    /* panel2: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal panel2_mass = p[17]; /* kg */
    const wreal panel2_com_x = p[18]; /* m */
    const wreal panel2_inertia_xx = p[19]; /* kg m^2 */
    const wreal panel2_inertia_yy = p[20]; /* kg m^2 */
    const wreal panel2_inertia_zz = p[21]; /* kg m^2 */
    const wreal panel2_first_moment_x = panel2_mass * panel2_com_x;
    const wreal panel2_com_x_times_first_moment_x = panel2_com_x * panel2_first_moment_x;
    const wreal panel2_origin_inertia_yy = panel2_inertia_yy + panel2_com_x_times_first_moment_x;
    const wreal panel2_origin_inertia_zz = panel2_inertia_zz + panel2_com_x_times_first_moment_x;
    const wreal panel2_base_half_trace = 0.5 * (panel2_inertia_xx + panel2_origin_inertia_zz
        + panel2_origin_inertia_yy);
    const wreal panel2_base_second_moment_zz = panel2_base_half_trace - panel2_origin_inertia_zz;
    w[15] = panel2_base_second_moment_zz;

    /* panel3: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal hinge3_position_x = p[22]; /* m */
    const wreal panel3_mass = p[23]; /* kg */
    const wreal panel3_com_x = p[24]; /* m */
    const wreal panel3_inertia_xx = p[25]; /* kg m^2 */
    const wreal panel3_inertia_yy = p[26]; /* kg m^2 */
    const wreal panel3_inertia_zz = p[27]; /* kg m^2 */
    const wreal panel3_first_moment_x = panel3_mass * panel3_com_x;
    const wreal panel3_com_x_times_first_moment_x = panel3_com_x * panel3_first_moment_x;
    const wreal panel3_origin_inertia_yy = panel3_inertia_yy + panel3_com_x_times_first_moment_x;
    const wreal panel3_origin_inertia_zz = panel3_inertia_zz + panel3_com_x_times_first_moment_x;
    const wreal panel3_base_mass_moment_x = hinge3_position_x * panel3_mass;
    const wreal panel2_mass_plus_panel3_mass = panel2_mass + panel3_mass;
    const wreal panel3_base_half_trace = 0.5 * (panel3_inertia_xx + panel3_origin_inertia_zz
        + panel3_origin_inertia_yy);
    const wreal panel3_base_second_moment_xx = panel3_base_half_trace - panel3_inertia_xx;
    const wreal panel3_base_second_moment_zz = panel3_base_half_trace - panel3_origin_inertia_zz;
    w[4] = panel3_first_moment_x;
    w[16] = panel3_base_second_moment_xx;
    w[17] = panel3_base_second_moment_zz;

    /* panel2: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal hinge2_position_x = p[16]; /* m */
    const wreal panel2_base_moment_x = panel2_first_moment_x + panel3_base_mass_moment_x;
    const wreal panel2_base_mass_moment_x = hinge2_position_x * panel2_mass_plus_panel3_mass;
    const wreal panel1_mass_plus_panel2_mass_plus_panel3_mass = panel1_mass
        + panel2_mass_plus_panel3_mass;
    const wreal panel2_base_second_moment_xx = hinge3_position_x * panel3_base_mass_moment_x
        + panel2_base_half_trace - panel2_inertia_xx;
    w[7] = panel2_base_moment_x;
    w[18] = panel2_base_second_moment_xx;

    /* panel1: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal hinge1_position_x = p[10]; /* m */
    const wreal panel1_base_moment_x = panel1_first_moment_x + panel2_base_mass_moment_x;
    const wreal panel1_base_mass_moment_x = hinge1_position_x *
        panel1_mass_plus_panel2_mass_plus_panel3_mass;
    const wreal hub_base_moment_x_part = panel0_mass
        + panel1_mass_plus_panel2_mass_plus_panel3_mass;
    const wreal panel1_base_second_moment_xx = hinge2_position_x * panel2_base_mass_moment_x
        + panel1_base_half_trace - panel1_inertia_xx;
    w[8] = panel1_base_moment_x;
    w[19] = panel1_base_second_moment_xx;

    /* panel0: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal panel0_base_moment_x = panel0_first_moment_x + panel1_base_mass_moment_x;
    const wreal panel0_base_second_moment_xx = hinge1_position_x * panel1_base_mass_moment_x
        + panel0_base_half_trace - panel0_inertia_xx;
    w[9] = panel0_base_moment_x;
    w[20] = panel0_base_second_moment_xx;

    /* hub: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal hub_mass = p[0]; /* kg */
    const wreal hub_inertia_xx = p[1]; /* kg m^2 */
    const wreal hub_inertia_yy = p[2]; /* kg m^2 */
    const wreal hub_inertia_zz = p[3]; /* kg m^2 */
    const wreal hinge0_position_x = p[4]; /* m */
    const wreal hub_base_moment_x = hinge0_position_x * hub_base_moment_x_part;
    const wreal hub_base_mass = hub_mass + hub_base_moment_x_part;
    const wreal hub_base_half_trace = 0.5 * (hub_inertia_xx + hub_inertia_zz + hub_inertia_yy);
    const wreal hub_base_second_moment_zz = hub_base_half_trace - hub_inertia_zz;
    const wreal hub_base_second_moment_xx = hinge0_position_x * hub_base_moment_x
        + hub_base_half_trace - hub_inertia_xx;
    const wreal hub_base_second_moment_yy = panel1_base_half_trace - panel1_origin_inertia_yy
        + (panel2_base_half_trace - panel2_origin_inertia_yy) + (panel3_base_half_trace
        - panel3_origin_inertia_yy + (hub_base_half_trace - hub_inertia_yy
        + (panel0_base_half_trace - panel0_origin_inertia_yy)));
    w[10] = hub_base_moment_x;
    w[11] = hub_base_mass;
    w[12] = hub_base_second_moment_zz;
    w[21] = hub_base_second_moment_xx;
    w[22] = hub_base_second_moment_yy;

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

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
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
    /* R = R_fixed R_joint(q) */
    const real drift_qw = q[0];
    const real drift_qx = q[1];
    const real drift_qy = q[2];
    const real drift_qz = q[3];
    const real twice_drift_qx = 2.0 * drift_qx;
    const real twice_drift_qy = 2.0 * drift_qy;
    const real twice_drift_qz = 2.0 * drift_qz;
    const real drift_qw_times_twice_drift_qx = drift_qw * twice_drift_qx;
    const real one_minus_drift_qx_times_twice_drift_qx = 1.0 - drift_qx * twice_drift_qx;
    const real drift_qw_times_twice_drift_qy = drift_qw * twice_drift_qy;
    const real drift_qw_times_twice_drift_qz = drift_qw * twice_drift_qz;
    const real drift_qx_times_twice_drift_qy = drift_qx * twice_drift_qy;
    const real drift_qy_times_twice_drift_qy = drift_qy * twice_drift_qy;
    const real drift_qx_times_twice_drift_qz = drift_qx * twice_drift_qz;
    const real drift_qy_times_twice_drift_qz = drift_qy * twice_drift_qz;
    const real drift_qz_times_twice_drift_qz = drift_qz * twice_drift_qz;
    const real drift_R_xx = 1.0 - drift_qy_times_twice_drift_qy - drift_qz_times_twice_drift_qz;
    const real drift_R_yy = one_minus_drift_qx_times_twice_drift_qx - drift_qz_times_twice_drift_qz;
    const real drift_R_zz = one_minus_drift_qx_times_twice_drift_qx - drift_qy_times_twice_drift_qy;
    const real drift_R_xy = drift_qx_times_twice_drift_qy - drift_qw_times_twice_drift_qz;
    const real drift_R_yx = drift_qw_times_twice_drift_qz + drift_qx_times_twice_drift_qy;
    const real drift_R_xz = drift_qw_times_twice_drift_qy + drift_qx_times_twice_drift_qz;
    const real drift_R_zx = drift_qx_times_twice_drift_qz - drift_qw_times_twice_drift_qy;
    const real drift_R_yz = drift_qy_times_twice_drift_qz - drift_qw_times_twice_drift_qx;
    const real drift_R_zy = drift_qw_times_twice_drift_qx + drift_qy_times_twice_drift_qz;

    /* hub: a, U */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    const real drift_u_x = u[0]; /* rad/s */
    const real drift_u_y = u[1]; /* rad/s */
    const real drift_u_z = u[2]; /* rad/s */
    const real drift_u_xdot = udot[0]; /* rad/s^2 */
    const real drift_u_ydot = udot[1]; /* rad/s^2 */
    const real drift_u_zdot = udot[2]; /* rad/s^2 */
    const real drift_u_pxdot = udot[3]; /* m/s^2 */
    const real drift_u_pydot = udot[4]; /* m/s^2 */
    const real drift_u_pzdot = udot[5]; /* m/s^2 */
    const real hub_a_x = drift_u_pydot * drift_R_yx + drift_u_pzdot * drift_R_zx
        + drift_u_pxdot * drift_R_xx;
    const real hub_a_y = drift_u_pxdot * drift_R_xy + drift_u_pzdot * drift_R_zy
        + drift_u_pydot * drift_R_yy;
    const real hub_a_z = drift_u_pxdot * drift_R_xz + drift_u_pydot * drift_R_yz
        + drift_u_pzdot * drift_R_zz;
    const real hub_minus_U_xx = drift_u_y * drift_u_y + drift_u_z * drift_u_z;
    const real drift_u_x_times_u_y = drift_u_x * drift_u_y;
    const real drift_u_x_times_u_z = drift_u_x * drift_u_z;
    const real drift_u_y_times_u_z = drift_u_y * drift_u_z;
    const real hub_U_xy = drift_u_x_times_u_y - drift_u_zdot;
    const real hub_U_yx = drift_u_zdot + drift_u_x_times_u_y;
    const real hub_U_xz = drift_u_ydot + drift_u_x_times_u_z;
    const real hub_U_zx = drift_u_x_times_u_z - drift_u_ydot;
    const real hub_U_yz = drift_u_y_times_u_z - drift_u_xdot;
    const real hub_U_zy = drift_u_xdot + drift_u_y_times_u_z;

    /* panel0: omega, alpha, a, U */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    const real hinge0_u = u[6]; /* rad/s */
    const real hinge0_udot = udot[6]; /* rad/s^2 */
    const wreal hinge0_position_x = w[0]; /* m */
    const real panel0_omega_x = drift_u_x * hinge0_cos - drift_u_z * hinge0_sin;
    const real panel0_omega_z = drift_u_x * hinge0_sin + drift_u_z * hinge0_cos;
    const real panel0_omega_y = drift_u_y + hinge0_u;
    const real panel0_alpha_x = drift_u_xdot * hinge0_cos - drift_u_zdot * hinge0_sin
        - hinge0_u * panel0_omega_z;
    const real panel0_alpha_z = drift_u_xdot * hinge0_sin + drift_u_zdot * hinge0_cos
        + hinge0_u * panel0_omega_x;
    const real panel0_alpha_y = drift_u_ydot + hinge0_udot;
    const real hub_a_x_minus_hinge0_position_x_times_hub_minus_U_xx = hub_a_x
        - hinge0_position_x * hub_minus_U_xx;
    const real panel0_a_y = hub_a_y + hinge0_position_x * hub_U_yx;
    const real hub_a_z_plus_hinge0_position_x_times_hub_U_zx = hub_a_z
        + hinge0_position_x * hub_U_zx;
    const real panel0_a_x = hinge0_cos * hub_a_x_minus_hinge0_position_x_times_hub_minus_U_xx
        - hinge0_sin * hub_a_z_plus_hinge0_position_x_times_hub_U_zx;
    const real panel0_a_z = hinge0_sin * hub_a_x_minus_hinge0_position_x_times_hub_minus_U_xx
        + hinge0_cos * hub_a_z_plus_hinge0_position_x_times_hub_U_zx;
    const real panel0_minus_U_xx = panel0_omega_y * panel0_omega_y
        + panel0_omega_z * panel0_omega_z;
    const real panel0_omega_x_times_omega_z = panel0_omega_x * panel0_omega_z;
    const real panel0_U_yx = panel0_alpha_z + panel0_omega_x * panel0_omega_y;
    const real panel0_U_yz = panel0_omega_z * panel0_omega_y - panel0_alpha_x;
    const real panel0_U_xz = panel0_alpha_y + panel0_omega_x_times_omega_z;
    const real panel0_U_zx = panel0_omega_x_times_omega_z - panel0_alpha_y;

    /* panel1: omega, alpha, a, U */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    const real hinge1_u = u[7]; /* rad/s */
    const real hinge1_udot = udot[7]; /* rad/s^2 */
    const wreal hinge1_position_x = w[1]; /* m */
    const real panel1_omega_x = panel0_omega_x * hinge1_cos - panel0_omega_z * hinge1_sin;
    const real panel1_omega_z = panel0_omega_x * hinge1_sin + panel0_omega_z * hinge1_cos;
    const real panel1_omega_y = hinge1_u + panel0_omega_y;
    const real panel1_alpha_y = hinge1_udot + panel0_alpha_y;
    const real panel1_alpha_x = hinge1_cos * panel0_alpha_x - hinge1_sin * panel0_alpha_z
        - hinge1_u * panel1_omega_z;
    const real panel1_alpha_z = hinge1_u * panel1_omega_x + hinge1_sin * panel0_alpha_x
        + hinge1_cos * panel0_alpha_z;
    const real panel0_a_x_minus_hinge1_position_x_times_panel0_minus_U_xx = panel0_a_x
        - hinge1_position_x * panel0_minus_U_xx;
    const real panel1_a_y = panel0_a_y + hinge1_position_x * panel0_U_yx;
    const real panel0_a_z_plus_hinge1_position_x_times_panel0_U_zx = panel0_a_z
        + hinge1_position_x * panel0_U_zx;
    const real panel1_a_x = hinge1_cos * panel0_a_x_minus_hinge1_position_x_times_panel0_minus_U_xx
        - hinge1_sin * panel0_a_z_plus_hinge1_position_x_times_panel0_U_zx;
    const real panel1_a_z = hinge1_sin * panel0_a_x_minus_hinge1_position_x_times_panel0_minus_U_xx
        + hinge1_cos * panel0_a_z_plus_hinge1_position_x_times_panel0_U_zx;
    const real panel1_minus_U_xx = panel1_omega_y * panel1_omega_y
        + panel1_omega_z * panel1_omega_z;
    const real panel1_omega_x_times_omega_z = panel1_omega_x * panel1_omega_z;
    const real panel1_U_yx = panel1_alpha_z + panel1_omega_x * panel1_omega_y;
    const real panel1_U_yz = panel1_omega_z * panel1_omega_y - panel1_alpha_x;
    const real panel1_U_xz = panel1_alpha_y + panel1_omega_x_times_omega_z;
    const real panel1_U_zx = panel1_omega_x_times_omega_z - panel1_alpha_y;

    /* panel2: omega, alpha, a, U */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    const real hinge2_u = u[8]; /* rad/s */
    const real hinge2_udot = udot[8]; /* rad/s^2 */
    const wreal hinge2_position_x = w[2]; /* m */
    const real panel2_omega_x = panel1_omega_x * hinge2_cos - panel1_omega_z * hinge2_sin;
    const real panel2_omega_z = panel1_omega_x * hinge2_sin + panel1_omega_z * hinge2_cos;
    const real panel2_omega_y = hinge2_u + panel1_omega_y;
    const real panel2_alpha_y = hinge2_udot + panel1_alpha_y;
    const real panel2_alpha_x = hinge2_cos * panel1_alpha_x - hinge2_u * panel2_omega_z
        - hinge2_sin * panel1_alpha_z;
    const real panel2_alpha_z = hinge2_u * panel2_omega_x + hinge2_sin * panel1_alpha_x
        + hinge2_cos * panel1_alpha_z;
    const real panel1_a_x_minus_hinge2_position_x_times_panel1_minus_U_xx = panel1_a_x
        - hinge2_position_x * panel1_minus_U_xx;
    const real panel2_a_y = panel1_a_y + hinge2_position_x * panel1_U_yx;
    const real panel1_a_z_plus_hinge2_position_x_times_panel1_U_zx = panel1_a_z
        + hinge2_position_x * panel1_U_zx;
    const real panel2_a_x = hinge2_cos * panel1_a_x_minus_hinge2_position_x_times_panel1_minus_U_xx
        - hinge2_sin * panel1_a_z_plus_hinge2_position_x_times_panel1_U_zx;
    const real panel2_a_z = hinge2_sin * panel1_a_x_minus_hinge2_position_x_times_panel1_minus_U_xx
        + hinge2_cos * panel1_a_z_plus_hinge2_position_x_times_panel1_U_zx;
    const real panel2_minus_U_xx = panel2_omega_y * panel2_omega_y
        + panel2_omega_z * panel2_omega_z;
    const real panel2_omega_x_times_omega_z = panel2_omega_x * panel2_omega_z;
    const real panel2_U_yx = panel2_alpha_z + panel2_omega_x * panel2_omega_y;
    const real panel2_U_yz = panel2_omega_z * panel2_omega_y - panel2_alpha_x;
    const real panel2_U_xz = panel2_alpha_y + panel2_omega_x_times_omega_z;
    const real panel2_U_zx = panel2_omega_x_times_omega_z - panel2_alpha_y;

    /* panel3: omega, alpha, a, inertia force, U, n, f */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    /* U = [alpha] + [omega][omega] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
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
    const real panel3_a_z = hinge3_sin * (panel2_a_x - hinge3_position_x * panel2_minus_U_xx)
        + hinge3_cos * (panel2_a_z + hinge3_position_x * panel2_U_zx);
    const real panel3_minus_f_x = panel3_first_moment_x * (panel3_omega_y * panel3_omega_y
        + panel3_omega_z * panel3_omega_z);
    const real panel3_U_yx = panel3_alpha_z + panel3_omega_x * panel3_omega_y;
    const real panel3_omega_x_times_omega_z = panel3_omega_x * panel3_omega_z;
    const real panel3_U_yz = panel3_omega_z * panel3_omega_y - panel3_alpha_x;
    const real panel3_minus_n_x = panel3_base_second_moment_zz * panel3_U_yz;
    const real panel3_U_xz = panel3_alpha_y + panel3_omega_x_times_omega_z;
    const real panel3_U_zx = panel3_omega_x_times_omega_z - panel3_alpha_y;
    const real panel3_n_y = panel3_base_second_moment_zz * panel3_U_xz
        - panel3_base_second_moment_xx * panel3_U_zx - panel3_first_moment_x * panel3_a_z;
    const real panel3_f_z = panel3_first_moment_x * panel3_U_zx;
    const real panel3_n_z = panel3_base_second_moment_xx * panel3_U_yx
        + panel3_first_moment_x * panel3_a_y;
    const real panel3_f_y = panel3_first_moment_x * panel3_U_yx;
    const real hinge3_sin_times_panel3_minus_f_x_plus_cos_times_panel3_f_z = hinge3_sin *
        panel3_minus_f_x + hinge3_cos * panel3_f_z;
    out[9] = panel3_n_y; /* tau: hinge3.u.tau [N*m] */

    /* panel2: f, n */
    /* f = inertia_force_f - applied_f + sum R f_child */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal panel2_base_moment_x = w[7];
    const wreal panel2_base_second_moment_zz = w[15];
    const wreal panel2_base_second_moment_xx = w[18];
    const real panel2_f_y = panel2_base_moment_x * panel2_U_yx + panel3_f_y;
    const real panel2_f_x = hinge3_sin * panel3_f_z - panel2_base_moment_x * panel2_minus_U_xx
        - hinge3_cos * panel3_minus_f_x;
    const real panel2_f_z = panel2_base_moment_x * panel2_U_zx
        + hinge3_sin_times_panel3_minus_f_x_plus_cos_times_panel3_f_z;
    const real panel2_n_y = panel2_base_second_moment_zz * panel2_U_xz
        - panel2_base_second_moment_xx * panel2_U_zx - panel2_base_moment_x * panel2_a_z
        - hinge3_position_x * hinge3_sin_times_panel3_minus_f_x_plus_cos_times_panel3_f_z
        + panel3_n_y;
    const real panel2_n_x = hinge3_sin * panel3_n_z - (panel2_base_second_moment_zz * panel2_U_yz
        + hinge3_cos * panel3_minus_n_x);
    const real panel2_n_z = panel2_base_second_moment_xx * panel2_U_yx
        + panel2_base_moment_x * panel2_a_y + hinge3_sin * panel3_minus_n_x
        + (hinge3_cos * panel3_n_z + hinge3_position_x * panel3_f_y);
    const real hinge2_cos_times_panel2_f_z_minus_sin_times_panel2_f_x = hinge2_cos * panel2_f_z
        - hinge2_sin * panel2_f_x;
    out[8] = panel2_n_y; /* tau: hinge2.u.tau [N*m] */

    /* panel1: f, n */
    /* f = inertia_force_f - applied_f + sum R f_child */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal panel1_base_moment_x = w[8];
    const wreal panel1_base_second_moment_zz = w[14];
    const wreal panel1_base_second_moment_xx = w[19];
    const real panel1_f_y = panel1_base_moment_x * panel1_U_yx + panel2_f_y;
    const real panel1_f_x = hinge2_cos * panel2_f_x - panel1_base_moment_x * panel1_minus_U_xx
        + hinge2_sin * panel2_f_z;
    const real panel1_f_z = panel1_base_moment_x * panel1_U_zx
        + hinge2_cos_times_panel2_f_z_minus_sin_times_panel2_f_x;
    const real panel1_n_y = panel1_base_second_moment_zz * panel1_U_xz
        - panel1_base_second_moment_xx * panel1_U_zx - panel1_base_moment_x * panel1_a_z
        + panel2_n_y - hinge2_position_x * hinge2_cos_times_panel2_f_z_minus_sin_times_panel2_f_x;
    const real panel1_n_x = hinge2_cos * panel2_n_x - panel1_base_second_moment_zz * panel1_U_yz
        + hinge2_sin * panel2_n_z;
    const real panel1_n_z = panel1_base_second_moment_xx * panel1_U_yx
        + panel1_base_moment_x * panel1_a_y + hinge2_position_x * panel2_f_y
        - hinge2_sin * panel2_n_x + hinge2_cos * panel2_n_z;
    const real hinge1_cos_times_panel1_f_z_minus_sin_times_panel1_f_x = hinge1_cos * panel1_f_z
        - hinge1_sin * panel1_f_x;
    out[7] = panel1_n_y; /* tau: hinge1.u.tau [N*m] */

    /* panel0: f, n */
    /* f = inertia_force_f - applied_f + sum R f_child */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal panel0_base_moment_x = w[9];
    const wreal panel0_base_second_moment_zz = w[13];
    const wreal panel0_base_second_moment_xx = w[20];
    const real panel0_f_y = panel0_base_moment_x * panel0_U_yx + panel1_f_y;
    const real panel0_f_x = hinge1_cos * panel1_f_x - panel0_base_moment_x * panel0_minus_U_xx
        + hinge1_sin * panel1_f_z;
    const real panel0_f_z = panel0_base_moment_x * panel0_U_zx
        + hinge1_cos_times_panel1_f_z_minus_sin_times_panel1_f_x;
    const real panel0_n_y = panel0_base_second_moment_zz * panel0_U_xz
        - panel0_base_moment_x * panel0_a_z - panel0_base_second_moment_xx * panel0_U_zx
        + panel1_n_y - hinge1_position_x * hinge1_cos_times_panel1_f_z_minus_sin_times_panel1_f_x;
    const real panel0_n_x = hinge1_cos * panel1_n_x - panel0_base_second_moment_zz * panel0_U_yz
        + hinge1_sin * panel1_n_z;
    const real panel0_n_z = panel0_base_second_moment_xx * panel0_U_yx
        + panel0_base_moment_x * panel0_a_y + hinge1_position_x * panel1_f_y
        + hinge1_cos * panel1_n_z - hinge1_sin * panel1_n_x;
    const real hinge0_cos_times_panel0_f_z_minus_sin_times_panel0_f_x = hinge0_cos * panel0_f_z
        - hinge0_sin * panel0_f_x;

    /* hub: f, n */
    /* f = inertia_force_f - applied_f + sum R f_child */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal hub_base_moment_x = w[10];
    const wreal hub_base_mass = w[11];
    const wreal hub_base_second_moment_zz = w[12];
    const wreal hub_base_second_moment_xx = w[21];
    const wreal hub_base_second_moment_yy = w[22];
    const real hub_f_y = hub_base_mass * hub_a_y + hub_base_moment_x * hub_U_yx + panel0_f_y;
    const real hub_f_x = hub_base_mass * hub_a_x - hub_base_moment_x * hub_minus_U_xx
        + hinge0_cos * panel0_f_x + hinge0_sin * panel0_f_z;
    const real hub_f_z = hub_base_mass * hub_a_z + hub_base_moment_x * hub_U_zx
        + hinge0_cos_times_panel0_f_z_minus_sin_times_panel0_f_x;
    /* tau: drift.u.y.tau [N*m] */
    out[1] = hub_base_second_moment_zz * hub_U_xz - hub_base_second_moment_xx * hub_U_zx
        - hub_base_moment_x * hub_a_z + panel0_n_y
        - hinge0_position_x * hinge0_cos_times_panel0_f_z_minus_sin_times_panel0_f_x;
    /* tau: drift.u.x.tau [N*m] */
    out[0] = hub_base_second_moment_yy * hub_U_zy - hub_base_second_moment_zz * hub_U_yz
        + hinge0_cos * panel0_n_x + hinge0_sin * panel0_n_z;
    /* tau: drift.u.z.tau [N*m] */
    out[2] = hub_base_second_moment_xx * hub_U_yx - hub_base_second_moment_yy * hub_U_xy
        + hub_base_moment_x * hub_a_y + hinge0_position_x * panel0_f_y + hinge0_cos * panel0_n_z
        - hinge0_sin * panel0_n_x;

    /* hinge0: tau */
    /* tau = S . [n; f] - force on the joint */
    const wreal spring_stiffness = w[5]; /* N*m/rad */
    const wreal spring_damping = w[6]; /* N*m*s/rad */
    /* tau: hinge0.u.tau [N*m] */
    out[6] = hinge0_q * spring_stiffness + hinge0_u * spring_damping + panel0_n_y;

    /* drift: tau */
    /* tau = S . [n; f] - force on the joint */
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
const int inverse_dynamics_sizes[] = {10, 0, 23, 0, 11, 10, 0, 0, 0, 30, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
