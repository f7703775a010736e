/*
 * forward_dynamics of solar_array
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll
 *
 * Sizes: out 10, work 24, w 35
 * Operations per call: 1456 = 792 mul, 356 sub, 287 add, 9 div, 4 cos, 4 sin, 3 neg, 1 solve
 * Operations of prepare: 90 = 49 add, 21 mul, 19 sub, 1 div
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
    const wreal panel0_base_half_trace = 0.5 * (panel0_inertia_xx + panel0_origin_inertia_yy
        + panel0_origin_inertia_zz);
    const wreal panel0_base_second_moment_zz = panel0_base_half_trace - panel0_origin_inertia_zz;
    w[24] = panel0_base_second_moment_zz;

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
    const wreal panel1_base_half_trace = 0.5 * (panel1_inertia_xx + panel1_origin_inertia_yy
        + panel1_origin_inertia_zz);
    const wreal panel1_base_second_moment_zz = panel1_base_half_trace - panel1_origin_inertia_zz;
    w[25] = panel1_base_second_moment_zz;

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
    const wreal panel2_base_half_trace = 0.5 * (panel2_inertia_xx + panel2_origin_inertia_yy
        + panel2_origin_inertia_zz);
    const wreal panel2_base_second_moment_zz = panel2_base_half_trace - panel2_origin_inertia_zz;
    w[26] = panel2_base_second_moment_zz;

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
    const wreal panel3_base_inertia_zz = panel3_origin_inertia_zz - panel3_inertia_xx;
    const wreal panel3_base_mass_moment_x = hinge3_position_x * panel3_mass;
    const wreal panel3_base_inertia_yy = hinge3_position_x * panel3_base_mass_moment_x;
    const wreal panel2_mass_plus_panel3_mass = panel2_mass + panel3_mass;
    const wreal panel2_base_inertia_xx = panel2_inertia_xx + panel3_inertia_xx;
    const wreal panel3_base_half_trace = 0.5 * (panel3_inertia_xx + panel3_origin_inertia_yy
        + panel3_origin_inertia_zz);
    const wreal panel3_base_second_moment_xx = panel3_base_half_trace - panel3_inertia_xx;
    const wreal panel3_base_second_moment_zz = panel3_base_half_trace - panel3_origin_inertia_zz;
    w[4] = panel3_first_moment_x;
    w[5] = panel3_origin_inertia_yy;
    w[8] = panel3_base_inertia_zz;
    w[27] = panel3_base_second_moment_xx;
    w[28] = panel3_base_second_moment_zz;

    /* panel2: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal hinge2_position_x = p[16]; /* m */
    const wreal panel2_base_moment_x = panel2_first_moment_x + panel3_base_mass_moment_x;
    const wreal panel2_base_inertia_yy = panel2_origin_inertia_yy + panel3_base_inertia_yy;
    const wreal panel2_base_inertia_zz = panel3_inertia_xx + panel3_base_inertia_yy
        + panel2_origin_inertia_zz - panel2_base_inertia_xx;
    const wreal panel2_base_mass_moment_x = hinge2_position_x * panel2_mass_plus_panel3_mass;
    const wreal panel2_base_inertia_yy_2 = hinge2_position_x * panel2_base_mass_moment_x;
    const wreal panel1_mass_plus_panel2_mass_plus_panel3_mass = panel1_mass
        + panel2_mass_plus_panel3_mass;
    const wreal panel1_base_inertia_xx = panel1_inertia_xx + panel2_base_inertia_xx;
    const wreal panel2_base_second_moment_xx = panel2_base_half_trace - panel2_inertia_xx
        + panel3_base_inertia_yy;
    w[9] = panel2_base_moment_x;
    w[10] = panel2_base_inertia_yy;
    w[11] = panel2_base_inertia_zz;
    w[29] = panel2_base_second_moment_xx;

    /* panel1: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal hinge1_position_x = p[10]; /* m */
    const wreal panel1_base_moment_x = panel1_first_moment_x + panel2_base_mass_moment_x;
    const wreal panel1_base_inertia_yy = panel1_origin_inertia_yy + panel2_base_inertia_yy_2;
    const wreal panel1_base_inertia_zz = panel2_base_inertia_xx + panel2_base_inertia_yy_2
        + panel1_origin_inertia_zz - panel1_base_inertia_xx;
    const wreal panel1_base_mass_moment_x = hinge1_position_x *
        panel1_mass_plus_panel2_mass_plus_panel3_mass;
    const wreal panel1_base_inertia_yy_2 = hinge1_position_x * panel1_base_mass_moment_x;
    const wreal hub_base_moment_x_part = panel0_mass
        + panel1_mass_plus_panel2_mass_plus_panel3_mass;
    const wreal panel0_base_inertia_xx = panel0_inertia_xx + panel1_base_inertia_xx;
    const wreal panel1_base_second_moment_xx = panel1_base_half_trace - panel1_inertia_xx
        + panel2_base_inertia_yy_2;
    w[12] = panel1_base_moment_x;
    w[13] = panel1_base_inertia_yy;
    w[14] = panel1_base_inertia_zz;
    w[30] = panel1_base_second_moment_xx;

    /* panel0: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal panel0_base_moment_x = panel0_first_moment_x + panel1_base_mass_moment_x;
    const wreal panel0_base_inertia_yy = panel0_origin_inertia_yy + panel1_base_inertia_yy_2;
    const wreal panel0_base_inertia_zz = panel1_base_inertia_xx + panel1_base_inertia_yy_2
        + panel0_origin_inertia_zz - panel0_base_inertia_xx;
    const wreal panel0_base_second_moment_xx = panel0_base_half_trace - panel0_inertia_xx
        + panel1_base_inertia_yy_2;
    w[15] = panel0_base_moment_x;
    w[16] = panel0_base_inertia_yy;
    w[17] = panel0_base_inertia_zz;
    w[31] = panel0_base_second_moment_xx;

    /* hub: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal hub_mass = p[0]; /* kg */
    const wreal hub_inertia_xx = p[1]; /* kg m^2 */
    const wreal hub_inertia_yy = p[2]; /* kg m^2 */
    const wreal hub_inertia_zz = p[3]; /* kg m^2 */
    const wreal hinge0_position_x = p[4]; /* m */
    const wreal hub_base_moment_x = hinge0_position_x * hub_base_moment_x_part;
    const wreal hub_base_mass = hub_mass + hub_base_moment_x_part;
    const wreal hub_base_inertia_xx = hub_inertia_xx + panel0_base_inertia_xx;
    const wreal hub_base_half_trace = 0.5 * (hub_inertia_xx + hub_inertia_yy + hub_inertia_zz);
    const wreal hub_base_second_moment_zz = hub_base_half_trace - hub_inertia_zz;
    const wreal hub_base_second_moment_yy = hub_base_half_trace - hub_inertia_yy
        + (panel0_base_half_trace - panel0_origin_inertia_yy + (panel1_base_half_trace
        - panel1_origin_inertia_yy + (panel2_base_half_trace - panel2_origin_inertia_yy
        + (panel3_base_half_trace - panel3_origin_inertia_yy))));
    w[18] = hub_base_moment_x;
    w[19] = hub_base_mass;
    w[20] = hub_base_inertia_xx;
    w[23] = hub_base_second_moment_zz;
    w[33] = hub_base_second_moment_yy;

    /* panel0: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal panel0_base_inertia_yy_2 = hinge0_position_x * hub_base_moment_x;

    /* hub: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal hub_base_inertia_yy = hub_inertia_yy + panel0_base_inertia_yy_2;
    const wreal hub_base_inertia_zz = panel0_base_inertia_xx + panel0_base_inertia_yy_2
        + hub_inertia_zz;
    const wreal hub_base_second_moment_xx = hub_base_half_trace - hub_inertia_xx
        + panel0_base_inertia_yy_2;
    w[21] = hub_base_inertia_yy;
    w[22] = hub_base_inertia_zz;
    w[32] = hub_base_second_moment_xx;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal M_factor_D_inverse_hinge3 = 1.0 / panel3_origin_inertia_yy;
    w[34] = M_factor_D_inverse_hinge3;

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
    real (*const circuit_matrix)[3] = (real (*)[3])(work + 0);
    real *const circuit_right = work + 9;
    real *const circuit_scratch = work + 12;
    int status = CARDAN_OK;

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
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

    /* panel2: inertia, composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal panel3_base_inertia_zz = w[8];
    const real panel2_inertia_shear = panel3_base_inertia_zz * hinge3_sin;
    const real panel2_composite_inertia_xx = hinge3_sin * panel2_inertia_shear;

    /* shared by several: inertia */
    const wreal hinge3_position_x = w[3]; /* m */
    const wreal panel3_first_moment_x = w[4];
    const real panel2_inertia_mean_moment_x = panel3_first_moment_x * hinge3_cos;
    const real panel2_minus_inertia_mean_moment_z = panel3_first_moment_x * hinge3_sin;
    const real hinge3_position_x_times_panel2_inertia_mean_moment_x = hinge3_position_x *
        panel2_inertia_mean_moment_x;
    const real panel2_minus_inertia_mean_moment_z_times_hinge2_sin =
        panel2_minus_inertia_mean_moment_z * hinge2_sin;
    const real panel2_minus_inertia_mean_moment_z_times_hinge2_cos =
        panel2_minus_inertia_mean_moment_z * hinge2_cos;

    /* panel2: inertia, composite, momentum */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* momentum = composite inertia S */
    const wreal panel3_origin_inertia_yy = w[5];
    const wreal panel2_base_moment_x = w[9];
    const wreal panel2_base_inertia_yy = w[10];
    const wreal panel2_base_inertia_zz = w[11];
    const real panel2_inertia_shift = 2.0 * hinge3_position_x_times_panel2_inertia_mean_moment_x;
    const real panel2_composite_inertia_xz = hinge3_cos * panel2_inertia_shear
        + hinge3_position_x * panel2_minus_inertia_mean_moment_z;
    const real panel2_composite_moment_x = panel2_base_moment_x + panel2_inertia_mean_moment_x;
    const real panel2_composite_inertia_yy = panel3_origin_inertia_yy + panel2_inertia_shift
        + panel2_base_inertia_yy;
    const real panel2_composite_inertia_zz = panel3_base_inertia_zz - panel2_composite_inertia_xx
        + panel2_inertia_shift + panel2_base_inertia_zz;
    const real momentum_minus_hinge3_about_panel1_fx =
        panel2_minus_inertia_mean_moment_z_times_hinge2_cos
        + panel2_inertia_mean_moment_x * hinge2_sin;
    const real momentum_hinge3_about_panel1_fz = panel2_minus_inertia_mean_moment_z_times_hinge2_sin
        - panel2_inertia_mean_moment_x * hinge2_cos;

    /* panel1: inertia, composite, momentum */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* momentum = composite inertia S */
    const real panel1_inertia_shear = hinge2_sin * (panel2_composite_inertia_zz
        - panel2_composite_inertia_xx) + hinge2_cos * (panel2_composite_inertia_xz
        + panel2_composite_inertia_xz);
    const real hinge2_sin_times_panel1_inertia_shear = hinge2_sin * panel1_inertia_shear;
    const real panel1_composite_inertia_xx = panel2_composite_inertia_xx
        + hinge2_sin_times_panel1_inertia_shear;
    const real momentum_hinge3_about_panel0_fx = hinge1_sin * momentum_hinge3_about_panel1_fz
        - hinge1_cos * momentum_minus_hinge3_about_panel1_fx;
    const real momentum_hinge3_about_panel0_fz = hinge1_sin * momentum_minus_hinge3_about_panel1_fx
        + hinge1_cos * momentum_hinge3_about_panel1_fz;

    /* shared by several: inertia */
    const wreal hinge2_position_x = w[2]; /* m */
    const real panel1_inertia_mean_moment_x = panel2_composite_moment_x * hinge2_cos
        - panel2_minus_inertia_mean_moment_z_times_hinge2_sin;
    const real panel1_minus_inertia_mean_moment_z = panel2_composite_moment_x * hinge2_sin
        + panel2_minus_inertia_mean_moment_z_times_hinge2_cos;
    const real hinge2_position_x_times_panel1_inertia_mean_moment_x = hinge2_position_x *
        panel1_inertia_mean_moment_x;
    const real panel1_minus_inertia_mean_moment_z_times_hinge1_sin =
        panel1_minus_inertia_mean_moment_z * hinge1_sin;
    const real panel1_minus_inertia_mean_moment_z_times_hinge1_cos =
        panel1_minus_inertia_mean_moment_z * hinge1_cos;

    /* panel1: inertia, composite, momentum */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* momentum = composite inertia S */
    const wreal panel1_base_moment_x = w[12];
    const wreal panel1_base_inertia_yy = w[13];
    const wreal panel1_base_inertia_zz = w[14];
    const real panel1_inertia_shift = 2.0 * hinge2_position_x_times_panel1_inertia_mean_moment_x;
    const real panel1_composite_inertia_xz = hinge2_cos * panel1_inertia_shear
        - panel2_composite_inertia_xz + hinge2_position_x * panel1_minus_inertia_mean_moment_z;
    const real panel1_composite_moment_x = panel1_base_moment_x + panel1_inertia_mean_moment_x;
    const real panel1_composite_inertia_yy = panel2_composite_inertia_yy + panel1_inertia_shift
        + panel1_base_inertia_yy;
    const real panel1_composite_inertia_zz = panel2_composite_inertia_zz
        - hinge2_sin_times_panel1_inertia_shear + panel1_inertia_shift + panel1_base_inertia_zz;
    const real momentum_minus_hinge2_about_panel0_fx =
        panel1_minus_inertia_mean_moment_z_times_hinge1_cos
        + panel1_inertia_mean_moment_x * hinge1_sin;
    const real momentum_hinge2_about_panel0_fz = panel1_minus_inertia_mean_moment_z_times_hinge1_sin
        - panel1_inertia_mean_moment_x * hinge1_cos;

    /* panel0: inertia, composite, momentum, omega, alpha, U */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* momentum = composite inertia S */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* U = [alpha] + [omega][omega] */
    const real drift_u_x = u[0]; /* rad/s */
    const real drift_u_y = u[1]; /* rad/s */
    const real drift_u_z = u[2]; /* rad/s */
    const real hinge0_u = u[6]; /* rad/s */
    const real panel0_inertia_shear = hinge1_sin * (panel1_composite_inertia_zz
        - panel1_composite_inertia_xx) + hinge1_cos * (panel1_composite_inertia_xz
        + panel1_composite_inertia_xz);
    const real hinge1_sin_times_panel0_inertia_shear = hinge1_sin * panel0_inertia_shear;
    const real panel0_composite_inertia_xx = panel1_composite_inertia_xx
        + hinge1_sin_times_panel0_inertia_shear;
    const real momentum_hinge3_about_hub_fx = hinge0_cos * momentum_hinge3_about_panel0_fx
        + hinge0_sin * momentum_hinge3_about_panel0_fz;
    const real momentum_hinge3_about_hub_fz = hinge0_cos * momentum_hinge3_about_panel0_fz
        - hinge0_sin * momentum_hinge3_about_panel0_fx;
    const real momentum_hinge2_about_hub_fx = hinge0_sin * momentum_hinge2_about_panel0_fz
        - hinge0_cos * momentum_minus_hinge2_about_panel0_fx;
    const real momentum_hinge2_about_hub_fz = hinge0_sin * momentum_minus_hinge2_about_panel0_fx
        + hinge0_cos * momentum_hinge2_about_panel0_fz;
    const real panel0_omega_x = drift_u_x * hinge0_cos - drift_u_z * hinge0_sin;
    const real panel0_omega_z = drift_u_x * hinge0_sin + drift_u_z * hinge0_cos;
    const real panel0_omega_y = drift_u_y + hinge0_u;
    const real panel0_minus_alpha_x = hinge0_u * panel0_omega_z;
    const real panel0_alpha_z = hinge0_u * panel0_omega_x;
    const real panel0_U_xz = panel0_omega_x * panel0_omega_z;
    const real panel0_minus_U_xx = panel0_omega_y * panel0_omega_y
        + panel0_omega_z * panel0_omega_z;
    const real panel0_U_yx = panel0_alpha_z + panel0_omega_x * panel0_omega_y;
    const real panel0_U_yz = panel0_minus_alpha_x + panel0_omega_z * panel0_omega_y;

    /* shared by several: inertia */
    const wreal hinge1_position_x = w[1]; /* m */
    const real panel0_inertia_mean_moment_x = panel1_composite_moment_x * hinge1_cos
        - panel1_minus_inertia_mean_moment_z_times_hinge1_sin;
    const real panel0_minus_inertia_mean_moment_z = panel1_composite_moment_x * hinge1_sin
        + panel1_minus_inertia_mean_moment_z_times_hinge1_cos;
    const real hinge1_position_x_times_panel0_inertia_mean_moment_x = hinge1_position_x *
        panel0_inertia_mean_moment_x;
    const real panel0_minus_inertia_mean_moment_z_times_hinge0_sin =
        panel0_minus_inertia_mean_moment_z * hinge0_sin;
    const real panel0_minus_inertia_mean_moment_z_times_hinge0_cos =
        panel0_minus_inertia_mean_moment_z * hinge0_cos;

    /* panel0: inertia, composite, momentum */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* momentum = composite inertia S */
    const wreal panel0_base_moment_x = w[15];
    const wreal panel0_base_inertia_yy = w[16];
    const wreal panel0_base_inertia_zz = w[17];
    const real panel0_inertia_shift = 2.0 * hinge1_position_x_times_panel0_inertia_mean_moment_x;
    const real panel0_composite_inertia_xz = hinge1_cos * panel0_inertia_shear
        - panel1_composite_inertia_xz + hinge1_position_x * panel0_minus_inertia_mean_moment_z;
    const real panel0_composite_moment_x = panel0_base_moment_x + panel0_inertia_mean_moment_x;
    const real panel0_composite_inertia_yy = panel1_composite_inertia_yy + panel0_inertia_shift
        + panel0_base_inertia_yy;
    const real panel0_composite_inertia_zz = panel1_composite_inertia_zz
        - hinge1_sin_times_panel0_inertia_shear + panel0_inertia_shift + panel0_base_inertia_zz;
    const real momentum_minus_hinge1_about_hub_fx =
        panel0_minus_inertia_mean_moment_z_times_hinge0_cos
        + panel0_inertia_mean_moment_x * hinge0_sin;
    const real momentum_hinge1_about_hub_fz = panel0_minus_inertia_mean_moment_z_times_hinge0_sin
        - panel0_inertia_mean_moment_x * hinge0_cos;

    /* hub: inertia, composite, U */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* U = [alpha] + [omega][omega] */
    const wreal hub_base_inertia_xx = w[20];
    const real hub_inertia_shear = hinge0_sin * (panel0_composite_inertia_zz
        - panel0_composite_inertia_xx) + hinge0_cos * (panel0_composite_inertia_xz
        + panel0_composite_inertia_xz);
    const real hinge0_sin_times_hub_inertia_shear = hinge0_sin * hub_inertia_shear;
    const real hub_composite_inertia_xx = panel0_composite_inertia_xx
        + hinge0_sin_times_hub_inertia_shear + hub_base_inertia_xx;
    const real hub_U_xy = drift_u_x * drift_u_y;
    const real hub_U_xz = drift_u_x * drift_u_z;
    const real hub_U_yz = drift_u_y * drift_u_z;
    const real hub_minus_U_xx = drift_u_y * drift_u_y + drift_u_z * drift_u_z;

    /* shared by several: inertia */
    const wreal hinge0_position_x = w[0]; /* m */
    const real hub_inertia_mean_moment_x = panel0_composite_moment_x * hinge0_cos
        - panel0_minus_inertia_mean_moment_z_times_hinge0_sin;
    const real hinge0_position_x_times_hub_inertia_mean_moment_x = hinge0_position_x *
        hub_inertia_mean_moment_x;

    /* momentum */
    /* momentum = composite inertia S */
    const real momentum_drift_x_fy = panel0_composite_moment_x * hinge0_sin
        + panel0_minus_inertia_mean_moment_z_times_hinge0_cos;

    /* hub: inertia, composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal hub_base_moment_x = w[18];
    const wreal hub_base_inertia_yy = w[21];
    const wreal hub_base_inertia_zz = w[22];
    const real hub_inertia_shift = 2.0 * hinge0_position_x_times_hub_inertia_mean_moment_x;
    const real hub_composite_inertia_xz = hinge0_cos * hub_inertia_shear
        - panel0_composite_inertia_xz + hinge0_position_x * momentum_drift_x_fy;
    const real hub_composite_moment_x = hub_base_moment_x + hub_inertia_mean_moment_x;
    const real hub_composite_inertia_yy = panel0_composite_inertia_yy + hub_inertia_shift
        + hub_base_inertia_yy;
    const real hub_composite_inertia_zz = panel0_composite_inertia_zz
        - hinge0_sin_times_hub_inertia_shear + hub_inertia_shift + hub_base_inertia_zz;

    /* M */
    /* M = S . momentum */
    const real M_hinge3_hinge2 = panel3_origin_inertia_yy
        + hinge3_position_x_times_panel2_inertia_mean_moment_x;
    const real M_hinge3_hinge1 = M_hinge3_hinge2
        - hinge2_position_x * momentum_hinge3_about_panel1_fz;
    const real M_hinge3_hinge0 = M_hinge3_hinge1
        - hinge1_position_x * momentum_hinge3_about_panel0_fz;
    const real M_hinge3_drift_y = M_hinge3_hinge0
        - hinge0_position_x * momentum_hinge3_about_hub_fz;
    const real M_hinge2_hinge1 = panel2_composite_inertia_yy
        + hinge2_position_x_times_panel1_inertia_mean_moment_x;
    const real M_hinge2_hinge0 = M_hinge2_hinge1
        - hinge1_position_x * momentum_hinge2_about_panel0_fz;
    const real M_hinge2_drift_y = M_hinge2_hinge0
        - hinge0_position_x * momentum_hinge2_about_hub_fz;
    const real M_hinge1_hinge0 = panel1_composite_inertia_yy
        + hinge1_position_x_times_panel0_inertia_mean_moment_x;
    const real M_hinge1_drift_y = M_hinge1_hinge0
        - hinge0_position_x * momentum_hinge1_about_hub_fz;
    const real M_hinge0_drift_y = panel0_composite_inertia_yy
        + hinge0_position_x_times_hub_inertia_mean_moment_x;

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
    const real drift_qw_times_twice_drift_qy = drift_qw * twice_drift_qy;
    const real drift_qw_times_twice_drift_qz = drift_qw * twice_drift_qz;
    const real drift_qx_times_twice_drift_qx = drift_qx * twice_drift_qx;
    const real drift_qx_times_twice_drift_qy = drift_qx * twice_drift_qy;
    const real drift_qx_times_twice_drift_qz = drift_qx * twice_drift_qz;
    const real drift_qy_times_twice_drift_qy = drift_qy * twice_drift_qy;
    const real drift_qy_times_twice_drift_qz = drift_qy * twice_drift_qz;
    const real drift_qz_times_twice_drift_qz = drift_qz * twice_drift_qz;
    const real drift_R_xx = 1.0 - (drift_qy_times_twice_drift_qy + drift_qz_times_twice_drift_qz);
    const real drift_R_xy = drift_qx_times_twice_drift_qy - drift_qw_times_twice_drift_qz;
    const real drift_R_xz = drift_qw_times_twice_drift_qy + drift_qx_times_twice_drift_qz;
    const real drift_R_yx = drift_qw_times_twice_drift_qz + drift_qx_times_twice_drift_qy;
    const real drift_R_yy = 1.0 - (drift_qx_times_twice_drift_qx + drift_qz_times_twice_drift_qz);
    const real drift_R_yz = drift_qy_times_twice_drift_qz - drift_qw_times_twice_drift_qx;
    const real drift_R_zx = drift_qx_times_twice_drift_qz - drift_qw_times_twice_drift_qy;
    const real drift_R_zy = drift_qw_times_twice_drift_qx + drift_qy_times_twice_drift_qz;
    const real drift_R_zz = 1.0 - (drift_qx_times_twice_drift_qx + drift_qy_times_twice_drift_qy);

    /* M */
    /* M = S . momentum */
    const real M_hinge3_drift_px = momentum_hinge3_about_hub_fx * drift_R_xx
        + momentum_hinge3_about_hub_fz * drift_R_xz;
    const real M_hinge3_drift_py = momentum_hinge3_about_hub_fx * drift_R_yx
        + momentum_hinge3_about_hub_fz * drift_R_yz;
    const real M_hinge3_drift_pz = momentum_hinge3_about_hub_fx * drift_R_zx
        + momentum_hinge3_about_hub_fz * drift_R_zz;
    const real M_hinge2_drift_px = drift_R_xx * momentum_hinge2_about_hub_fx
        + drift_R_xz * momentum_hinge2_about_hub_fz;
    const real M_hinge2_drift_py = drift_R_yx * momentum_hinge2_about_hub_fx
        + drift_R_yz * momentum_hinge2_about_hub_fz;
    const real M_hinge2_drift_pz = drift_R_zx * momentum_hinge2_about_hub_fx
        + drift_R_zz * momentum_hinge2_about_hub_fz;
    const real M_hinge1_drift_px = drift_R_xz * momentum_hinge1_about_hub_fz
        - drift_R_xx * momentum_minus_hinge1_about_hub_fx;
    const real M_hinge1_drift_py = drift_R_yz * momentum_hinge1_about_hub_fz
        - drift_R_yx * momentum_minus_hinge1_about_hub_fx;
    const real M_hinge1_drift_pz = drift_R_zz * momentum_hinge1_about_hub_fz
        - drift_R_zx * momentum_minus_hinge1_about_hub_fx;

    /* shared by several: M */
    /* M = S . momentum */
    const real momentum_drift_x_fy_times_drift_R_xx = momentum_drift_x_fy * drift_R_xx;
    const real momentum_drift_x_fy_times_drift_R_yx = momentum_drift_x_fy * drift_R_yx;
    const real momentum_drift_x_fy_times_drift_R_zx = momentum_drift_x_fy * drift_R_zx;

    /* momentum */
    /* momentum = composite inertia S */
    const wreal hub_base_mass = w[19];
    const real momentum_drift_px_mx = momentum_drift_x_fy * drift_R_xy;
    const real momentum_drift_py_mx = momentum_drift_x_fy * drift_R_yy;
    const real momentum_drift_pz_mx = momentum_drift_x_fy * drift_R_zy;
    const real momentum_drift_px_mz = hub_composite_moment_x * drift_R_xy;
    const real momentum_drift_py_mz = hub_composite_moment_x * drift_R_yy;
    const real momentum_drift_pz_mz = hub_composite_moment_x * drift_R_zy;
    const real momentum_drift_px_fx = hub_base_mass * drift_R_xx;
    const real momentum_drift_px_fy = hub_base_mass * drift_R_xy;
    const real momentum_drift_px_fz = hub_base_mass * drift_R_xz;
    const real momentum_drift_py_fx = hub_base_mass * drift_R_yx;
    const real momentum_drift_py_fy = hub_base_mass * drift_R_yy;
    const real momentum_drift_py_fz = hub_base_mass * drift_R_yz;
    const real momentum_drift_pz_fx = hub_base_mass * drift_R_zx;
    const real momentum_drift_pz_fy = hub_base_mass * drift_R_zy;
    const real momentum_drift_pz_fz = hub_base_mass * drift_R_zz;

    /* M */
    /* M = S . momentum */
    const real M_drift_px_drift_px = drift_R_xx * momentum_drift_px_fx
        + drift_R_xy * momentum_drift_px_fy + drift_R_xz * momentum_drift_px_fz;
    const real M_drift_py_drift_px = drift_R_xx * momentum_drift_py_fx
        + drift_R_xy * momentum_drift_py_fy + drift_R_xz * momentum_drift_py_fz;
    const real M_drift_py_drift_py = drift_R_yx * momentum_drift_py_fx
        + drift_R_yy * momentum_drift_py_fy + drift_R_yz * momentum_drift_py_fz;
    const real M_drift_pz_drift_px = drift_R_xx * momentum_drift_pz_fx
        + drift_R_xy * momentum_drift_pz_fy + drift_R_xz * momentum_drift_pz_fz;
    const real M_drift_pz_drift_py = drift_R_yx * momentum_drift_pz_fx
        + drift_R_yy * momentum_drift_pz_fy + drift_R_yz * momentum_drift_pz_fz;
    const real M_drift_pz_drift_pz = drift_R_zx * momentum_drift_pz_fx
        + drift_R_zy * momentum_drift_pz_fy + drift_R_zz * momentum_drift_pz_fz;

    /* panel1: omega, alpha, U */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* U = [alpha] + [omega][omega] */
    const real hinge1_u = u[7]; /* rad/s */
    const real panel1_omega_x = hinge1_cos * panel0_omega_x - hinge1_sin * panel0_omega_z;
    const real panel1_omega_z = hinge1_sin * panel0_omega_x + hinge1_cos * panel0_omega_z;
    const real panel1_omega_y = hinge1_u + panel0_omega_y;
    const real panel1_minus_alpha_x = hinge1_cos * panel0_minus_alpha_x
        + hinge1_sin * panel0_alpha_z + hinge1_u * panel1_omega_z;
    const real panel1_alpha_z = hinge1_cos * panel0_alpha_z - hinge1_sin * panel0_minus_alpha_x
        + hinge1_u * panel1_omega_x;
    const real panel1_U_xz = panel1_omega_x * panel1_omega_z;
    const real panel1_minus_U_xx = panel1_omega_y * panel1_omega_y
        + panel1_omega_z * panel1_omega_z;
    const real panel1_U_yx = panel1_alpha_z + panel1_omega_x * panel1_omega_y;
    const real panel1_U_yz = panel1_minus_alpha_x + panel1_omega_z * panel1_omega_y;

    /* panel2: omega, alpha, U */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* U = [alpha] + [omega][omega] */
    const real hinge2_u = u[8]; /* rad/s */
    const real panel2_omega_x = hinge2_cos * panel1_omega_x - hinge2_sin * panel1_omega_z;
    const real panel2_omega_z = hinge2_sin * panel1_omega_x + hinge2_cos * panel1_omega_z;
    const real panel2_omega_y = hinge2_u + panel1_omega_y;
    const real panel2_minus_alpha_x = hinge2_cos * panel1_minus_alpha_x
        + hinge2_sin * panel1_alpha_z + hinge2_u * panel2_omega_z;
    const real panel2_alpha_z = hinge2_cos * panel1_alpha_z - hinge2_sin * panel1_minus_alpha_x
        + hinge2_u * panel2_omega_x;
    const real panel2_U_xz = panel2_omega_x * panel2_omega_z;
    const real panel2_minus_U_xx = panel2_omega_y * panel2_omega_y
        + panel2_omega_z * panel2_omega_z;
    const real panel2_U_yx = panel2_alpha_z + panel2_omega_x * panel2_omega_y;
    const real panel2_U_yz = panel2_minus_alpha_x + panel2_omega_z * panel2_omega_y;

    /* panel3: omega, alpha, U, inertia force, f */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* U = [alpha] + [omega][omega] */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real hinge3_u = u[9]; /* rad/s */
    const wreal panel3_base_second_moment_zz = w[28];
    const real panel3_omega_x = hinge3_cos * panel2_omega_x - hinge3_sin * panel2_omega_z;
    const real panel3_omega_z = hinge3_sin * panel2_omega_x + hinge3_cos * panel2_omega_z;
    const real panel3_omega_y = hinge3_u + panel2_omega_y;
    const real panel3_alpha_z = hinge3_cos * panel2_alpha_z - hinge3_sin * panel2_minus_alpha_x
        + hinge3_u * panel3_omega_x;
    const real panel3_U_xz = panel3_omega_x * panel3_omega_z;
    const real panel3_U_yx = panel3_alpha_z + panel3_omega_x * panel3_omega_y;
    const real panel3_U_yz = hinge3_cos * panel2_minus_alpha_x + hinge3_sin * panel2_alpha_z
        + hinge3_u * panel3_omega_z + panel3_omega_z * panel3_omega_y;
    const real panel3_minus_n_x = panel3_base_second_moment_zz * panel3_U_yz;
    const real panel3_minus_f_x = panel3_first_moment_x * (panel3_omega_y * panel3_omega_y
        + panel3_omega_z * panel3_omega_z);
    const real panel3_f_y = panel3_first_moment_x * panel3_U_yx;
    const real panel3_f_z = panel3_first_moment_x * panel3_U_xz;
    const real hinge3_sin_times_panel3_minus_f_x_plus_cos_times_panel3_f_z = hinge3_sin *
        panel3_minus_f_x + hinge3_cos * panel3_f_z;

    /* panel0: a */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    const real hinge0_position_x_times_hub_minus_U_xx = hinge0_position_x * hub_minus_U_xx;
    const real panel0_a_y = hinge0_position_x * hub_U_xy;
    const real hinge0_position_x_times_hub_U_xz = hinge0_position_x * hub_U_xz;
    const real panel0_a_z = hinge0_cos * hinge0_position_x_times_hub_U_xz
        - hinge0_sin * hinge0_position_x_times_hub_minus_U_xx;

    /* panel1: a */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    const real panel1_minus_a_x_part = hinge0_cos * hinge0_position_x_times_hub_minus_U_xx
        + hinge0_sin * hinge0_position_x_times_hub_U_xz + hinge1_position_x * panel0_minus_U_xx;
    const real panel1_a_y = panel0_a_y + hinge1_position_x * panel0_U_yx;
    const real panel0_a_z_plus_hinge1_position_x_times_panel0_U_xz = panel0_a_z
        + hinge1_position_x * panel0_U_xz;
    const real panel1_a_z = hinge1_cos * panel0_a_z_plus_hinge1_position_x_times_panel0_U_xz
        - hinge1_sin * panel1_minus_a_x_part;

    /* panel2: a, f */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real panel2_minus_a_x_part = hinge1_cos * panel1_minus_a_x_part
        + hinge1_sin * panel0_a_z_plus_hinge1_position_x_times_panel0_U_xz
        + hinge2_position_x * panel1_minus_U_xx;
    const real panel2_a_y = panel1_a_y + hinge2_position_x * panel1_U_yx;
    const real panel1_a_z_plus_hinge2_position_x_times_panel1_U_xz = panel1_a_z
        + hinge2_position_x * panel1_U_xz;
    const real panel2_a_z = hinge2_cos * panel1_a_z_plus_hinge2_position_x_times_panel1_U_xz
        - hinge2_sin * panel2_minus_a_x_part;
    const real panel2_f_x = hinge3_sin * panel3_f_z - hinge3_cos * panel3_minus_f_x
        - panel2_base_moment_x * panel2_minus_U_xx;
    const real panel2_f_y = panel2_base_moment_x * panel2_U_yx + panel3_f_y;
    const real panel2_f_z = panel2_base_moment_x * panel2_U_xz
        + hinge3_sin_times_panel3_minus_f_x_plus_cos_times_panel3_f_z;
    const real hinge2_cos_times_panel2_f_z_minus_sin_times_panel2_f_x = hinge2_cos * panel2_f_z
        - hinge2_sin * panel2_f_x;

    /* panel3: a, n */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal panel3_base_second_moment_xx = w[27];
    const real panel3_a_y = panel2_a_y + hinge3_position_x * panel2_U_yx;
    const real panel3_a_z = hinge3_cos * (panel2_a_z + hinge3_position_x * panel2_U_xz)
        - hinge3_sin * (hinge2_cos * panel2_minus_a_x_part
        + hinge2_sin * panel1_a_z_plus_hinge2_position_x_times_panel1_U_xz
        + hinge3_position_x * panel2_minus_U_xx);
    const real panel3_n_y = panel3_base_second_moment_zz * panel3_U_xz
        - panel3_base_second_moment_xx * panel3_U_xz - panel3_first_moment_x * panel3_a_z;
    const real panel3_n_z = panel3_base_second_moment_xx * panel3_U_yx
        + panel3_first_moment_x * panel3_a_y;

    /* panel2: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal panel2_base_second_moment_zz = w[26];
    const wreal panel2_base_second_moment_xx = w[29];
    const real panel2_n_x = hinge3_sin * panel3_n_z - hinge3_cos * panel3_minus_n_x
        - panel2_base_second_moment_zz * panel2_U_yz;
    const real panel2_n_y = panel2_base_second_moment_zz * panel2_U_xz
        - panel2_base_second_moment_xx * panel2_U_xz - panel2_base_moment_x * panel2_a_z
        + (panel3_n_y
        - hinge3_position_x * hinge3_sin_times_panel3_minus_f_x_plus_cos_times_panel3_f_z);
    const real panel2_n_z = panel2_base_second_moment_xx * panel2_U_yx
        + panel2_base_moment_x * panel2_a_y + (hinge3_sin * panel3_minus_n_x
        + hinge3_cos * panel3_n_z + hinge3_position_x * panel3_f_y);

    /* panel1: n, f */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const wreal panel1_base_second_moment_zz = w[25];
    const wreal panel1_base_second_moment_xx = w[30];
    const real panel1_n_x = hinge2_cos * panel2_n_x + hinge2_sin * panel2_n_z
        - panel1_base_second_moment_zz * panel1_U_yz;
    const real panel1_n_y = panel1_base_second_moment_zz * panel1_U_xz
        - panel1_base_second_moment_xx * panel1_U_xz - panel1_base_moment_x * panel1_a_z
        + (panel2_n_y - hinge2_position_x * hinge2_cos_times_panel2_f_z_minus_sin_times_panel2_f_x);
    const real panel1_n_z = panel1_base_second_moment_xx * panel1_U_yx
        + panel1_base_moment_x * panel1_a_y + (hinge2_cos * panel2_n_z - hinge2_sin * panel2_n_x
        + hinge2_position_x * panel2_f_y);
    const real panel1_f_x = hinge2_cos * panel2_f_x + hinge2_sin * panel2_f_z
        - panel1_base_moment_x * panel1_minus_U_xx;
    const real panel1_f_y = panel1_base_moment_x * panel1_U_yx + panel2_f_y;
    const real panel1_f_z = panel1_base_moment_x * panel1_U_xz
        + hinge2_cos_times_panel2_f_z_minus_sin_times_panel2_f_x;
    const real hinge1_cos_times_panel1_f_z_minus_sin_times_panel1_f_x = hinge1_cos * panel1_f_z
        - hinge1_sin * panel1_f_x;

    /* panel0: n, f */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const wreal panel0_base_second_moment_zz = w[24];
    const wreal panel0_base_second_moment_xx = w[31];
    const real panel0_n_x = hinge1_cos * panel1_n_x + hinge1_sin * panel1_n_z
        - panel0_base_second_moment_zz * panel0_U_yz;
    const real panel0_n_y = panel0_base_second_moment_zz * panel0_U_xz
        - panel0_base_second_moment_xx * panel0_U_xz - panel0_base_moment_x * panel0_a_z
        + (panel1_n_y - hinge1_position_x * hinge1_cos_times_panel1_f_z_minus_sin_times_panel1_f_x);
    const real panel0_n_z = panel0_base_second_moment_xx * panel0_U_yx
        + panel0_base_moment_x * panel0_a_y + (hinge1_cos * panel1_n_z - hinge1_sin * panel1_n_x
        + hinge1_position_x * panel1_f_y);
    const real panel0_f_x = hinge1_cos * panel1_f_x + hinge1_sin * panel1_f_z
        - panel0_base_moment_x * panel0_minus_U_xx;
    const real panel0_f_y = panel0_base_moment_x * panel0_U_yx + panel1_f_y;
    const real panel0_f_z = panel0_base_moment_x * panel0_U_xz
        + hinge1_cos_times_panel1_f_z_minus_sin_times_panel1_f_x;
    const real hinge0_cos_times_panel0_f_z_minus_sin_times_panel0_f_x = hinge0_cos * panel0_f_z
        - hinge0_sin * panel0_f_x;

    /* hub: n, f */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const wreal hub_base_second_moment_zz = w[23];
    const wreal hub_base_second_moment_xx = w[32];
    const wreal hub_base_second_moment_yy = w[33];
    const real hub_n_x = hub_base_second_moment_yy * hub_U_yz
        - hub_base_second_moment_zz * hub_U_yz + (hinge0_cos * panel0_n_x
        + hinge0_sin * panel0_n_z);
    const real hub_n_y = hub_base_second_moment_zz * hub_U_xz
        - hub_base_second_moment_xx * hub_U_xz + (panel0_n_y
        - hinge0_position_x * hinge0_cos_times_panel0_f_z_minus_sin_times_panel0_f_x);
    const real hub_n_z = hub_base_second_moment_xx * hub_U_xy
        - hub_base_second_moment_yy * hub_U_xy + (hinge0_cos * panel0_n_z
        - hinge0_sin * panel0_n_x + hinge0_position_x * panel0_f_y);
    const real hub_f_x = hinge0_cos * panel0_f_x + hinge0_sin * panel0_f_z
        - hub_base_moment_x * hub_minus_U_xx;
    const real hub_f_y = hub_base_moment_x * hub_U_xy + panel0_f_y;
    const real hub_f_z = hub_base_moment_x * hub_U_xz
        + hinge0_cos_times_panel0_f_z_minus_sin_times_panel0_f_x;

    /* hinge0: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real hinge0_u_tau = tau[6]; /* N*m */
    const wreal spring_stiffness = w[6]; /* N*m/rad */
    const wreal spring_damping = w[7]; /* N*m*s/rad */
    const real hinge0_tau = hinge0_q * spring_stiffness + hinge0_u * spring_damping + panel0_n_y;
    const real hinge0_drive = hinge0_u_tau - hinge0_tau;

    /* drift: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
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
    /* drive = tau + f - h */
    const real hinge1_u_tau = tau[7]; /* N*m */
    const real hinge1_drive = hinge1_u_tau - panel1_n_y;

    /* hinge2: drive */
    /* drive = tau + f - h */
    const real hinge2_u_tau = tau[8]; /* N*m */
    const real hinge2_drive = hinge2_u_tau - panel2_n_y;

    /* hinge3: drive */
    /* drive = tau + f - h */
    const real hinge3_u_tau = tau[9]; /* N*m */
    const real hinge3_drive = hinge3_u_tau - panel3_n_y;

    /* constraints: factor, multipliers */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const wreal M_factor_D_inverse_hinge3 = w[34];
    const real M_factor_L_hinge3_hinge2 = M_hinge3_hinge2 * M_factor_D_inverse_hinge3;
    const real M_factor_DL_hinge2_drift_y = M_hinge2_drift_y
        - M_hinge3_drift_y * M_factor_L_hinge3_hinge2;
    const real M_factor_DL_hinge2_drift_px = M_hinge2_drift_px
        - M_hinge3_drift_px * M_factor_L_hinge3_hinge2;
    const real M_factor_DL_hinge2_drift_py = M_hinge2_drift_py
        - M_hinge3_drift_py * M_factor_L_hinge3_hinge2;
    const real M_factor_DL_hinge2_drift_pz = M_hinge2_drift_pz
        - M_hinge3_drift_pz * M_factor_L_hinge3_hinge2;
    const real M_factor_DL_hinge2_hinge0 = M_hinge2_hinge0
        - M_hinge3_hinge0 * M_factor_L_hinge3_hinge2;
    const real M_factor_DL_hinge2_hinge1 = M_hinge2_hinge1
        - M_hinge3_hinge1 * M_factor_L_hinge3_hinge2;
    const real M_factor_L_hinge3_hinge1 = M_hinge3_hinge1 * M_factor_D_inverse_hinge3;
    const real M_factor_L_hinge3_hinge0 = M_hinge3_hinge0 * M_factor_D_inverse_hinge3;
    const real M_factor_L_hinge3_drift_pz = M_hinge3_drift_pz * M_factor_D_inverse_hinge3;
    const real M_factor_L_hinge3_drift_py = M_hinge3_drift_py * M_factor_D_inverse_hinge3;
    const real M_factor_L_hinge3_drift_px = M_hinge3_drift_px * M_factor_D_inverse_hinge3;
    const real M_factor_L_hinge3_drift_y = M_hinge3_drift_y * M_factor_D_inverse_hinge3;
    const real M_factor_D_inverse_hinge2 = 1.0 / (panel2_composite_inertia_yy
        - M_hinge3_hinge2 * M_factor_L_hinge3_hinge2);
    const real M_factor_L_hinge2_hinge1 = M_factor_DL_hinge2_hinge1 * M_factor_D_inverse_hinge2;
    const real M_factor_DL_hinge1_drift_y = M_hinge1_drift_y
        - M_hinge3_drift_y * M_factor_L_hinge3_hinge1
        - M_factor_DL_hinge2_drift_y * M_factor_L_hinge2_hinge1;
    const real M_factor_DL_hinge1_drift_px = M_hinge1_drift_px
        - M_hinge3_drift_px * M_factor_L_hinge3_hinge1
        - M_factor_DL_hinge2_drift_px * M_factor_L_hinge2_hinge1;
    const real M_factor_DL_hinge1_drift_py = M_hinge1_drift_py
        - M_hinge3_drift_py * M_factor_L_hinge3_hinge1
        - M_factor_DL_hinge2_drift_py * M_factor_L_hinge2_hinge1;
    const real M_factor_DL_hinge1_drift_pz = M_hinge1_drift_pz
        - M_hinge3_drift_pz * M_factor_L_hinge3_hinge1
        - M_factor_DL_hinge2_drift_pz * M_factor_L_hinge2_hinge1;
    const real M_factor_DL_hinge1_hinge0 = M_hinge1_hinge0
        - M_hinge3_hinge0 * M_factor_L_hinge3_hinge1
        - M_factor_DL_hinge2_hinge0 * M_factor_L_hinge2_hinge1;
    const real M_factor_L_hinge2_hinge0 = M_factor_DL_hinge2_hinge0 * M_factor_D_inverse_hinge2;
    const real M_factor_L_hinge2_drift_pz = M_factor_DL_hinge2_drift_pz * M_factor_D_inverse_hinge2;
    const real M_factor_L_hinge2_drift_py = M_factor_DL_hinge2_drift_py * M_factor_D_inverse_hinge2;
    const real M_factor_L_hinge2_drift_px = M_factor_DL_hinge2_drift_px * M_factor_D_inverse_hinge2;
    const real M_factor_L_hinge2_drift_y = M_factor_DL_hinge2_drift_y * M_factor_D_inverse_hinge2;
    const real M_factor_D_inverse_hinge1 = 1.0 / (panel1_composite_inertia_yy
        - M_hinge3_hinge1 * M_factor_L_hinge3_hinge1
        - M_factor_DL_hinge2_hinge1 * M_factor_L_hinge2_hinge1);
    const real M_factor_L_hinge1_hinge0 = M_factor_DL_hinge1_hinge0 * M_factor_D_inverse_hinge1;
    const real M_factor_DL_hinge0_drift_y = M_hinge0_drift_y
        - M_hinge3_drift_y * M_factor_L_hinge3_hinge0
        - M_factor_DL_hinge2_drift_y * M_factor_L_hinge2_hinge0
        - M_factor_DL_hinge1_drift_y * M_factor_L_hinge1_hinge0;
    const real M_minus_factor_DL_hinge0_drift_px = momentum_drift_x_fy_times_drift_R_xx
        + hub_inertia_mean_moment_x * drift_R_xz + M_hinge3_drift_px * M_factor_L_hinge3_hinge0
        + M_factor_DL_hinge2_drift_px * M_factor_L_hinge2_hinge0
        + M_factor_DL_hinge1_drift_px * M_factor_L_hinge1_hinge0;
    const real M_minus_factor_DL_hinge0_drift_py = momentum_drift_x_fy_times_drift_R_yx
        + hub_inertia_mean_moment_x * drift_R_yz + M_hinge3_drift_py * M_factor_L_hinge3_hinge0
        + M_factor_DL_hinge2_drift_py * M_factor_L_hinge2_hinge0
        + M_factor_DL_hinge1_drift_py * M_factor_L_hinge1_hinge0;
    const real M_minus_factor_DL_hinge0_drift_pz = momentum_drift_x_fy_times_drift_R_zx
        + hub_inertia_mean_moment_x * drift_R_zz + M_hinge3_drift_pz * M_factor_L_hinge3_hinge0
        + M_factor_DL_hinge2_drift_pz * M_factor_L_hinge2_hinge0
        + M_factor_DL_hinge1_drift_pz * M_factor_L_hinge1_hinge0;
    const real M_factor_L_hinge1_drift_pz = M_factor_DL_hinge1_drift_pz * M_factor_D_inverse_hinge1;
    const real M_factor_DL_drift_pz_drift_y_part = momentum_drift_x_fy_times_drift_R_zx
        + hub_composite_moment_x * drift_R_zz + M_hinge3_drift_y * M_factor_L_hinge3_drift_pz
        + M_factor_DL_hinge2_drift_y * M_factor_L_hinge2_drift_pz
        + M_factor_DL_hinge1_drift_y * M_factor_L_hinge1_drift_pz;
    const real M_factor_L_hinge1_drift_py = M_factor_DL_hinge1_drift_py * M_factor_D_inverse_hinge1;
    const real M_factor_DL_drift_py_drift_y_part = momentum_drift_x_fy_times_drift_R_yx
        + hub_composite_moment_x * drift_R_yz + M_hinge3_drift_y * M_factor_L_hinge3_drift_py
        + M_factor_DL_hinge2_drift_y * M_factor_L_hinge2_drift_py
        + M_factor_DL_hinge1_drift_y * M_factor_L_hinge1_drift_py;
    const real M_factor_DL_drift_py_drift_px_part = M_drift_py_drift_px
        - M_hinge3_drift_px * M_factor_L_hinge3_drift_py
        - M_factor_DL_hinge2_drift_px * M_factor_L_hinge2_drift_py
        - M_factor_DL_hinge1_drift_px * M_factor_L_hinge1_drift_py;
    const real M_factor_L_hinge1_drift_px = M_factor_DL_hinge1_drift_px * M_factor_D_inverse_hinge1;
    const real M_factor_DL_drift_px_drift_y_part = momentum_drift_x_fy_times_drift_R_xx
        + hub_composite_moment_x * drift_R_xz + M_hinge3_drift_y * M_factor_L_hinge3_drift_px
        + M_factor_DL_hinge2_drift_y * M_factor_L_hinge2_drift_px
        + M_factor_DL_hinge1_drift_y * M_factor_L_hinge1_drift_px;
    const real M_factor_L_hinge1_drift_y = M_factor_DL_hinge1_drift_y * M_factor_D_inverse_hinge1;
    const real M_factor_D_inverse_hinge0 = 1.0 / (panel0_composite_inertia_yy
        - M_hinge3_hinge0 * M_factor_L_hinge3_hinge0
        - M_factor_DL_hinge2_hinge0 * M_factor_L_hinge2_hinge0
        - M_factor_DL_hinge1_hinge0 * M_factor_L_hinge1_hinge0);
    const real M_minus_factor_L_hinge0_drift_pz = M_minus_factor_DL_hinge0_drift_pz *
        M_factor_D_inverse_hinge0;
    const real M_factor_DL_drift_pz_drift_y = M_factor_DL_hinge0_drift_y *
        M_minus_factor_L_hinge0_drift_pz - M_factor_DL_drift_pz_drift_y_part;
    const real M_factor_DL_drift_pz_drift_px = M_drift_pz_drift_px
        - M_hinge3_drift_px * M_factor_L_hinge3_drift_pz
        - M_factor_DL_hinge2_drift_px * M_factor_L_hinge2_drift_pz
        - M_factor_DL_hinge1_drift_px * M_factor_L_hinge1_drift_pz
        - M_minus_factor_DL_hinge0_drift_px * M_minus_factor_L_hinge0_drift_pz;
    const real M_factor_DL_drift_pz_drift_py = M_drift_pz_drift_py
        - M_hinge3_drift_py * M_factor_L_hinge3_drift_pz
        - M_factor_DL_hinge2_drift_py * M_factor_L_hinge2_drift_pz
        - M_factor_DL_hinge1_drift_py * M_factor_L_hinge1_drift_pz
        - M_minus_factor_DL_hinge0_drift_py * M_minus_factor_L_hinge0_drift_pz;
    const real M_minus_factor_L_hinge0_drift_py = M_minus_factor_DL_hinge0_drift_py *
        M_factor_D_inverse_hinge0;
    const real M_factor_D_drift_py_part = M_drift_py_drift_py
        - M_hinge3_drift_py * M_factor_L_hinge3_drift_py
        - M_factor_DL_hinge2_drift_py * M_factor_L_hinge2_drift_py
        - M_factor_DL_hinge1_drift_py * M_factor_L_hinge1_drift_py
        - M_minus_factor_DL_hinge0_drift_py * M_minus_factor_L_hinge0_drift_py;
    const real M_minus_factor_L_hinge0_drift_px = M_minus_factor_DL_hinge0_drift_px *
        M_factor_D_inverse_hinge0;
    const real M_factor_D_drift_px_part = M_drift_px_drift_px
        - M_hinge3_drift_px * M_factor_L_hinge3_drift_px
        - M_factor_DL_hinge2_drift_px * M_factor_L_hinge2_drift_px
        - M_factor_DL_hinge1_drift_px * M_factor_L_hinge1_drift_px
        - M_minus_factor_DL_hinge0_drift_px * M_minus_factor_L_hinge0_drift_px;
    const real M_factor_L_hinge0_drift_y = M_factor_DL_hinge0_drift_y * M_factor_D_inverse_hinge0;
    const real M_factor_D_drift_y_part = hub_composite_inertia_yy
        - M_hinge3_drift_y * M_factor_L_hinge3_drift_y
        - M_factor_DL_hinge2_drift_y * M_factor_L_hinge2_drift_y
        - M_factor_DL_hinge1_drift_y * M_factor_L_hinge1_drift_y
        - M_factor_DL_hinge0_drift_y * M_factor_L_hinge0_drift_y;
    const real M_factor_D_inverse_drift_pz = 1.0 / (M_drift_pz_drift_pz
        - M_hinge3_drift_pz * M_factor_L_hinge3_drift_pz
        - M_factor_DL_hinge2_drift_pz * M_factor_L_hinge2_drift_pz
        - M_factor_DL_hinge1_drift_pz * M_factor_L_hinge1_drift_pz
        - M_minus_factor_DL_hinge0_drift_pz * M_minus_factor_L_hinge0_drift_pz);
    const real M_factor_L_drift_pz_drift_py = M_factor_DL_drift_pz_drift_py *
        M_factor_D_inverse_drift_pz;
    const real M_factor_DL_drift_py_drift_x = momentum_drift_py_mx
        - momentum_drift_pz_mx * M_factor_L_drift_pz_drift_py;
    const real M_factor_DL_drift_py_drift_y = M_factor_DL_hinge0_drift_y *
        M_minus_factor_L_hinge0_drift_py - M_factor_DL_drift_py_drift_y_part
        - M_factor_DL_drift_pz_drift_y * M_factor_L_drift_pz_drift_py;
    const real M_factor_DL_drift_py_drift_z = momentum_drift_py_mz
        - momentum_drift_pz_mz * M_factor_L_drift_pz_drift_py;
    const real M_factor_DL_drift_py_drift_px = M_factor_DL_drift_py_drift_px_part
        - M_minus_factor_DL_hinge0_drift_px * M_minus_factor_L_hinge0_drift_py
        - M_factor_DL_drift_pz_drift_px * M_factor_L_drift_pz_drift_py;
    const real M_factor_L_drift_pz_drift_px = M_factor_DL_drift_pz_drift_px *
        M_factor_D_inverse_drift_pz;
    const real M_factor_L_drift_pz_drift_z = momentum_drift_pz_mz * M_factor_D_inverse_drift_pz;
    const real M_factor_L_drift_pz_drift_y = M_factor_DL_drift_pz_drift_y *
        M_factor_D_inverse_drift_pz;
    const real M_factor_L_drift_pz_drift_x = momentum_drift_pz_mx * M_factor_D_inverse_drift_pz;
    const real M_factor_D_inverse_drift_py = 1.0 / (M_factor_D_drift_py_part
        - M_factor_DL_drift_pz_drift_py * M_factor_L_drift_pz_drift_py);
    const real M_factor_L_drift_py_drift_px = M_factor_DL_drift_py_drift_px *
        M_factor_D_inverse_drift_py;
    const real M_factor_DL_drift_px_drift_x = momentum_drift_px_mx
        - momentum_drift_pz_mx * M_factor_L_drift_pz_drift_px
        - M_factor_DL_drift_py_drift_x * M_factor_L_drift_py_drift_px;
    const real M_factor_DL_drift_px_drift_y = M_factor_DL_hinge0_drift_y *
        M_minus_factor_L_hinge0_drift_px - M_factor_DL_drift_px_drift_y_part
        - M_factor_DL_drift_pz_drift_y * M_factor_L_drift_pz_drift_px
        - M_factor_DL_drift_py_drift_y * M_factor_L_drift_py_drift_px;
    const real M_factor_DL_drift_px_drift_z = momentum_drift_px_mz
        - momentum_drift_pz_mz * M_factor_L_drift_pz_drift_px
        - M_factor_DL_drift_py_drift_z * M_factor_L_drift_py_drift_px;
    const real M_factor_L_drift_py_drift_z = M_factor_DL_drift_py_drift_z *
        M_factor_D_inverse_drift_py;
    const real M_factor_L_drift_py_drift_y = M_factor_DL_drift_py_drift_y *
        M_factor_D_inverse_drift_py;
    const real M_factor_L_drift_py_drift_x = M_factor_DL_drift_py_drift_x *
        M_factor_D_inverse_drift_py;
    const real M_factor_D_inverse_drift_px = 1.0 / (M_factor_D_drift_px_part
        - M_factor_DL_drift_pz_drift_px * M_factor_L_drift_pz_drift_px
        - M_factor_DL_drift_py_drift_px * M_factor_L_drift_py_drift_px);
    const real M_factor_L_drift_px_drift_z = M_factor_DL_drift_px_drift_z *
        M_factor_D_inverse_drift_px;
    const real M_factor_DL_drift_z_drift_x = hub_composite_inertia_xz
        - momentum_drift_pz_mx * M_factor_L_drift_pz_drift_z
        - M_factor_DL_drift_py_drift_x * M_factor_L_drift_py_drift_z
        - M_factor_DL_drift_px_drift_x * M_factor_L_drift_px_drift_z;
    const real M_minus_factor_DL_drift_z_drift_y = M_factor_DL_drift_pz_drift_y *
        M_factor_L_drift_pz_drift_z + M_factor_DL_drift_py_drift_y * M_factor_L_drift_py_drift_z
        + M_factor_DL_drift_px_drift_y * M_factor_L_drift_px_drift_z;
    const real M_factor_L_drift_px_drift_y = M_factor_DL_drift_px_drift_y *
        M_factor_D_inverse_drift_px;
    const real M_factor_D_drift_y_part_2 = M_factor_D_drift_y_part
        - M_factor_DL_drift_pz_drift_y * M_factor_L_drift_pz_drift_y
        - M_factor_DL_drift_py_drift_y * M_factor_L_drift_py_drift_y
        - M_factor_DL_drift_px_drift_y * M_factor_L_drift_px_drift_y;
    const real M_factor_L_drift_px_drift_x = M_factor_DL_drift_px_drift_x *
        M_factor_D_inverse_drift_px;
    const real M_factor_D_inverse_drift_z = 1.0 / (hub_composite_inertia_zz
        - momentum_drift_pz_mz * M_factor_L_drift_pz_drift_z
        - M_factor_DL_drift_py_drift_z * M_factor_L_drift_py_drift_z
        - M_factor_DL_drift_px_drift_z * M_factor_L_drift_px_drift_z);
    const real M_minus_factor_L_drift_z_drift_y = M_minus_factor_DL_drift_z_drift_y *
        M_factor_D_inverse_drift_z;
    const real M_factor_DL_drift_y_drift_x = M_factor_DL_drift_z_drift_x *
        M_minus_factor_L_drift_z_drift_y - (momentum_drift_pz_mx * M_factor_L_drift_pz_drift_y
        + M_factor_DL_drift_py_drift_x * M_factor_L_drift_py_drift_y
        + M_factor_DL_drift_px_drift_x * M_factor_L_drift_px_drift_y);
    const real M_factor_L_drift_z_drift_x = M_factor_DL_drift_z_drift_x *
        M_factor_D_inverse_drift_z;
    const real M_factor_D_drift_x_part = hub_composite_inertia_xx
        - momentum_drift_pz_mx * M_factor_L_drift_pz_drift_x
        - M_factor_DL_drift_py_drift_x * M_factor_L_drift_py_drift_x
        - M_factor_DL_drift_px_drift_x * M_factor_L_drift_px_drift_x
        - M_factor_DL_drift_z_drift_x * M_factor_L_drift_z_drift_x;
    const real M_factor_D_inverse_drift_y = 1.0 / (M_factor_D_drift_y_part_2
        - M_minus_factor_DL_drift_z_drift_y * M_minus_factor_L_drift_z_drift_y);
    const real M_factor_L_drift_y_drift_x = M_factor_DL_drift_y_drift_x *
        M_factor_D_inverse_drift_y;
    const real M_factor_D_inverse_drift_x = 1.0 / (M_factor_D_drift_x_part
        - M_factor_DL_drift_y_drift_x * M_factor_L_drift_y_drift_x);
    const real free_y_hinge2 = hinge2_drive - hinge3_drive * M_factor_L_hinge3_hinge2;
    const real free_y_hinge1 = hinge1_drive - hinge3_drive * M_factor_L_hinge3_hinge1
        - M_factor_L_hinge2_hinge1 * free_y_hinge2;
    const real free_y_hinge0 = hinge0_drive - hinge3_drive * M_factor_L_hinge3_hinge0
        - M_factor_L_hinge2_hinge0 * free_y_hinge2 - M_factor_L_hinge1_hinge0 * free_y_hinge1;
    const real free_y_drift_pz = drift_drive_pz - hinge3_drive * M_factor_L_hinge3_drift_pz
        - M_factor_L_hinge2_drift_pz * free_y_hinge2 - M_factor_L_hinge1_drift_pz * free_y_hinge1
        + M_minus_factor_L_hinge0_drift_pz * free_y_hinge0;
    const real free_y_drift_y_part = drift_drive_y - hinge3_drive * M_factor_L_hinge3_drift_y
        - M_factor_L_hinge2_drift_y * free_y_hinge2 - M_factor_L_hinge1_drift_y * free_y_hinge1
        - M_factor_L_hinge0_drift_y * free_y_hinge0 - M_factor_L_drift_pz_drift_y * free_y_drift_pz;
    const real free_y_drift_px_part = drift_drive_px - hinge3_drive * M_factor_L_hinge3_drift_px
        - M_factor_L_hinge2_drift_px * free_y_hinge2 - M_factor_L_hinge1_drift_px * free_y_hinge1
        + M_minus_factor_L_hinge0_drift_px * free_y_hinge0
        - M_factor_L_drift_pz_drift_px * free_y_drift_pz;
    const real free_y_drift_py = drift_drive_py - hinge3_drive * M_factor_L_hinge3_drift_py
        - M_factor_L_hinge2_drift_py * free_y_hinge2 - M_factor_L_hinge1_drift_py * free_y_hinge1
        + M_minus_factor_L_hinge0_drift_py * free_y_hinge0
        - M_factor_L_drift_pz_drift_py * free_y_drift_pz;
    const real free_y_drift_px = free_y_drift_px_part
        - M_factor_L_drift_py_drift_px * free_y_drift_py;
    const real free_y_drift_z = drift_drive_z - M_factor_L_drift_pz_drift_z * free_y_drift_pz
        - M_factor_L_drift_py_drift_z * free_y_drift_py
        - M_factor_L_drift_px_drift_z * free_y_drift_px;
    const real free_y_drift_y = free_y_drift_y_part
        - M_factor_L_drift_py_drift_y * free_y_drift_py
        - M_factor_L_drift_px_drift_y * free_y_drift_px
        + M_minus_factor_L_drift_z_drift_y * free_y_drift_z;
    const real free_y_drift_x = drift_drive_x - M_factor_L_drift_pz_drift_x * free_y_drift_pz
        - M_factor_L_drift_py_drift_x * free_y_drift_py
        - M_factor_L_drift_px_drift_x * free_y_drift_px
        - M_factor_L_drift_z_drift_x * free_y_drift_z - M_factor_L_drift_y_drift_x * free_y_drift_y;
    const real free_udot_drift_x = M_factor_D_inverse_drift_x * free_y_drift_x;
    const real free_udot_drift_y = M_factor_D_inverse_drift_y * free_y_drift_y
        - M_factor_L_drift_y_drift_x * free_udot_drift_x;
    const real free_udot_drift_z = M_factor_D_inverse_drift_z * free_y_drift_z
        - M_factor_L_drift_z_drift_x * free_udot_drift_x
        + M_minus_factor_L_drift_z_drift_y * free_udot_drift_y;
    const real free_udot_drift_px = M_factor_D_inverse_drift_px * free_y_drift_px
        - M_factor_L_drift_px_drift_x * free_udot_drift_x
        - M_factor_L_drift_px_drift_y * free_udot_drift_y
        - M_factor_L_drift_px_drift_z * free_udot_drift_z;
    const real free_udot_drift_py = M_factor_D_inverse_drift_py * free_y_drift_py
        - M_factor_L_drift_py_drift_x * free_udot_drift_x
        - M_factor_L_drift_py_drift_y * free_udot_drift_y
        - M_factor_L_drift_py_drift_z * free_udot_drift_z
        - M_factor_L_drift_py_drift_px * free_udot_drift_px;
    const real free_udot_drift_pz_part = M_factor_D_inverse_drift_pz * free_y_drift_pz
        - M_factor_L_drift_pz_drift_x * free_udot_drift_x
        - M_factor_L_drift_pz_drift_y * free_udot_drift_y
        - M_factor_L_drift_pz_drift_z * free_udot_drift_z
        - M_factor_L_drift_pz_drift_px * free_udot_drift_px;
    const real free_udot_drift_pz = free_udot_drift_pz_part
        - M_factor_L_drift_pz_drift_py * free_udot_drift_py;
    const real free_udot_hinge0 = M_factor_D_inverse_hinge0 * free_y_hinge0
        - M_factor_L_hinge0_drift_y * free_udot_drift_y
        + M_minus_factor_L_hinge0_drift_px * free_udot_drift_px
        + M_minus_factor_L_hinge0_drift_py * free_udot_drift_py
        + M_minus_factor_L_hinge0_drift_pz * free_udot_drift_pz;
    const real free_udot_hinge1_part = M_factor_D_inverse_hinge1 * free_y_hinge1
        - M_factor_L_hinge1_drift_y * free_udot_drift_y
        - M_factor_L_hinge1_drift_px * free_udot_drift_px
        - M_factor_L_hinge1_drift_py * free_udot_drift_py
        - M_factor_L_hinge1_drift_pz * free_udot_drift_pz;
    const real free_udot_hinge1 = free_udot_hinge1_part
        - M_factor_L_hinge1_hinge0 * free_udot_hinge0;
    const real free_udot_hinge2_part = M_factor_D_inverse_hinge2 * free_y_hinge2
        - M_factor_L_hinge2_drift_y * free_udot_drift_y
        - M_factor_L_hinge2_drift_px * free_udot_drift_px
        - M_factor_L_hinge2_drift_py * free_udot_drift_py
        - M_factor_L_hinge2_drift_pz * free_udot_drift_pz;
    const real free_udot_hinge2 = free_udot_hinge2_part
        - M_factor_L_hinge2_hinge0 * free_udot_hinge0 - M_factor_L_hinge2_hinge1 * free_udot_hinge1;
    const real free_udot_hinge3_part = hinge3_drive * M_factor_D_inverse_hinge3
        - M_factor_L_hinge3_drift_y * free_udot_drift_y
        - M_factor_L_hinge3_drift_px * free_udot_drift_px
        - M_factor_L_hinge3_drift_py * free_udot_drift_py
        - M_factor_L_hinge3_drift_pz * free_udot_drift_pz;
    const real free_udot_hinge3 = free_udot_hinge3_part
        - M_factor_L_hinge3_hinge0 * free_udot_hinge0
        - M_factor_L_hinge3_hinge1 * free_udot_hinge1 - M_factor_L_hinge3_hinge2 * free_udot_hinge2;
    const real cable1_y_hinge0 = 2.0 - M_factor_L_hinge1_hinge0;
    const real cable1_y_drift_pz = M_minus_factor_L_hinge0_drift_pz * cable1_y_hinge0
        - M_factor_L_hinge1_drift_pz;
    const real cable1_y_drift_py = M_minus_factor_L_hinge0_drift_py * cable1_y_hinge0
        - M_factor_L_hinge1_drift_py - M_factor_L_drift_pz_drift_py * cable1_y_drift_pz;
    const real cable1_y_drift_px = M_minus_factor_L_hinge0_drift_px * cable1_y_hinge0
        - M_factor_L_hinge1_drift_px - M_factor_L_drift_pz_drift_px * cable1_y_drift_pz
        - M_factor_L_drift_py_drift_px * cable1_y_drift_py;
    const real cable1_minus_y_drift_y_part = M_factor_L_hinge1_drift_y
        + M_factor_L_hinge0_drift_y * cable1_y_hinge0
        + M_factor_L_drift_pz_drift_y * cable1_y_drift_pz
        + M_factor_L_drift_py_drift_y * cable1_y_drift_py
        + M_factor_L_drift_px_drift_y * cable1_y_drift_px;
    const real cable1_minus_y_drift_z = M_factor_L_drift_pz_drift_z * cable1_y_drift_pz
        + M_factor_L_drift_py_drift_z * cable1_y_drift_py
        + M_factor_L_drift_px_drift_z * cable1_y_drift_px;
    const real cable1_minus_y_drift_y = cable1_minus_y_drift_y_part
        + M_minus_factor_L_drift_z_drift_y * cable1_minus_y_drift_z;
    const real cable1_y_drift_x = M_factor_L_drift_z_drift_x * cable1_minus_y_drift_z
        - (M_factor_L_drift_pz_drift_x * cable1_y_drift_pz
        + M_factor_L_drift_py_drift_x * cable1_y_drift_py
        + M_factor_L_drift_px_drift_x * cable1_y_drift_px)
        + M_factor_L_drift_y_drift_x * cable1_minus_y_drift_y;
    const real cable1_response_drift_x = M_factor_D_inverse_drift_x * cable1_y_drift_x;
    const real cable1_minus_response_drift_y = M_factor_D_inverse_drift_y * cable1_minus_y_drift_y +
        M_factor_L_drift_y_drift_x * cable1_response_drift_x;
    const real cable1_minus_response_drift_z = M_factor_D_inverse_drift_z * cable1_minus_y_drift_z +
        M_factor_L_drift_z_drift_x * cable1_response_drift_x
        + M_minus_factor_L_drift_z_drift_y * cable1_minus_response_drift_y;
    const real cable1_response_drift_px = M_factor_D_inverse_drift_px * cable1_y_drift_px
        - M_factor_L_drift_px_drift_x * cable1_response_drift_x
        + M_factor_L_drift_px_drift_y * cable1_minus_response_drift_y
        + M_factor_L_drift_px_drift_z * cable1_minus_response_drift_z;
    const real cable1_response_drift_py_part = M_factor_D_inverse_drift_py * cable1_y_drift_py
        - M_factor_L_drift_py_drift_x * cable1_response_drift_x
        + M_factor_L_drift_py_drift_y * cable1_minus_response_drift_y
        + M_factor_L_drift_py_drift_z * cable1_minus_response_drift_z;
    const real cable1_response_drift_py = cable1_response_drift_py_part
        - M_factor_L_drift_py_drift_px * cable1_response_drift_px;
    const real cable1_response_drift_pz_part = M_factor_D_inverse_drift_pz * cable1_y_drift_pz
        - M_factor_L_drift_pz_drift_x * cable1_response_drift_x
        + M_factor_L_drift_pz_drift_y * cable1_minus_response_drift_y
        + M_factor_L_drift_pz_drift_z * cable1_minus_response_drift_z;
    const real cable1_response_drift_pz = cable1_response_drift_pz_part
        - M_factor_L_drift_pz_drift_px * cable1_response_drift_px
        - M_factor_L_drift_pz_drift_py * cable1_response_drift_py;
    const real cable1_response_hinge0_part = M_factor_D_inverse_hinge0 * cable1_y_hinge0
        + M_factor_L_hinge0_drift_y * cable1_minus_response_drift_y
        + M_minus_factor_L_hinge0_drift_px * cable1_response_drift_px
        + M_minus_factor_L_hinge0_drift_py * cable1_response_drift_py;
    const real cable1_response_hinge0 = cable1_response_hinge0_part
        + M_minus_factor_L_hinge0_drift_pz * cable1_response_drift_pz;
    const real cable1_response_hinge1_part = M_factor_D_inverse_hinge1
        + M_factor_L_hinge1_drift_y * cable1_minus_response_drift_y
        - M_factor_L_hinge1_drift_px * cable1_response_drift_px
        - M_factor_L_hinge1_drift_py * cable1_response_drift_py
        - M_factor_L_hinge1_drift_pz * cable1_response_drift_pz;
    const real cable1_response_hinge1 = cable1_response_hinge1_part
        - M_factor_L_hinge1_hinge0 * cable1_response_hinge0;
    const real cable1_response_hinge2_part = M_factor_L_hinge2_drift_y *
        cable1_minus_response_drift_y - M_factor_L_hinge2_drift_px * cable1_response_drift_px
        - M_factor_L_hinge2_drift_py * cable1_response_drift_py
        - M_factor_L_hinge2_drift_pz * cable1_response_drift_pz;
    const real cable1_response_hinge2 = cable1_response_hinge2_part
        - M_factor_L_hinge2_hinge0 * cable1_response_hinge0
        - M_factor_L_hinge2_hinge1 * cable1_response_hinge1;
    const real cable1_response_hinge3_part = M_factor_L_hinge3_drift_y *
        cable1_minus_response_drift_y - M_factor_L_hinge3_drift_px * cable1_response_drift_px
        - M_factor_L_hinge3_drift_py * cable1_response_drift_py
        - M_factor_L_hinge3_drift_pz * cable1_response_drift_pz;
    const real cable1_response_hinge3 = cable1_response_hinge3_part
        - M_factor_L_hinge3_hinge0 * cable1_response_hinge0
        - M_factor_L_hinge3_hinge1 * cable1_response_hinge1
        - M_factor_L_hinge3_hinge2 * cable1_response_hinge2;
    const real cable2_y_hinge0 = -2.0 - M_factor_L_hinge2_hinge0
        + M_factor_L_hinge2_hinge1 * M_factor_L_hinge1_hinge0;
    const real cable2_y_drift_pz = M_factor_L_hinge2_hinge1 * M_factor_L_hinge1_drift_pz
        - M_factor_L_hinge2_drift_pz + M_minus_factor_L_hinge0_drift_pz * cable2_y_hinge0;
    const real cable2_y_drift_py = M_factor_L_hinge2_hinge1 * M_factor_L_hinge1_drift_py
        - M_factor_L_hinge2_drift_py + M_minus_factor_L_hinge0_drift_py * cable2_y_hinge0
        - M_factor_L_drift_pz_drift_py * cable2_y_drift_pz;
    const real cable2_y_drift_y_part = M_factor_L_hinge2_hinge1 * M_factor_L_hinge1_drift_y
        - M_factor_L_hinge2_drift_y - M_factor_L_hinge0_drift_y * cable2_y_hinge0
        - M_factor_L_drift_pz_drift_y * cable2_y_drift_pz
        - M_factor_L_drift_py_drift_y * cable2_y_drift_py;
    const real cable2_y_drift_px = M_factor_L_hinge2_hinge1 * M_factor_L_hinge1_drift_px
        - M_factor_L_hinge2_drift_px + M_minus_factor_L_hinge0_drift_px * cable2_y_hinge0
        - M_factor_L_drift_pz_drift_px * cable2_y_drift_pz
        - M_factor_L_drift_py_drift_px * cable2_y_drift_py;
    const real cable2_minus_y_drift_z = M_factor_L_drift_pz_drift_z * cable2_y_drift_pz
        + M_factor_L_drift_py_drift_z * cable2_y_drift_py
        + M_factor_L_drift_px_drift_z * cable2_y_drift_px;
    const real cable2_y_drift_y = cable2_y_drift_y_part
        - M_factor_L_drift_px_drift_y * cable2_y_drift_px
        - M_minus_factor_L_drift_z_drift_y * cable2_minus_y_drift_z;
    const real cable2_y_drift_x = M_factor_L_drift_z_drift_x * cable2_minus_y_drift_z
        - (M_factor_L_drift_pz_drift_x * cable2_y_drift_pz
        + M_factor_L_drift_py_drift_x * cable2_y_drift_py
        + M_factor_L_drift_px_drift_x * cable2_y_drift_px)
        - M_factor_L_drift_y_drift_x * cable2_y_drift_y;
    const real cable2_response_drift_x = M_factor_D_inverse_drift_x * cable2_y_drift_x;
    const real cable2_response_drift_y = M_factor_D_inverse_drift_y * cable2_y_drift_y
        - M_factor_L_drift_y_drift_x * cable2_response_drift_x;
    const real cable2_response_drift_z = M_minus_factor_L_drift_z_drift_y * cable2_response_drift_y
        - (M_factor_D_inverse_drift_z * cable2_minus_y_drift_z
        + M_factor_L_drift_z_drift_x * cable2_response_drift_x);
    const real cable2_response_drift_px = M_factor_D_inverse_drift_px * cable2_y_drift_px
        - M_factor_L_drift_px_drift_x * cable2_response_drift_x
        - M_factor_L_drift_px_drift_y * cable2_response_drift_y
        - M_factor_L_drift_px_drift_z * cable2_response_drift_z;
    const real cable2_response_drift_py_part = M_factor_D_inverse_drift_py * cable2_y_drift_py
        - M_factor_L_drift_py_drift_x * cable2_response_drift_x
        - M_factor_L_drift_py_drift_y * cable2_response_drift_y
        - M_factor_L_drift_py_drift_z * cable2_response_drift_z;
    const real cable2_response_drift_py = cable2_response_drift_py_part
        - M_factor_L_drift_py_drift_px * cable2_response_drift_px;
    const real cable2_response_drift_pz_part = M_factor_D_inverse_drift_pz * cable2_y_drift_pz
        - M_factor_L_drift_pz_drift_x * cable2_response_drift_x
        - M_factor_L_drift_pz_drift_y * cable2_response_drift_y
        - M_factor_L_drift_pz_drift_z * cable2_response_drift_z;
    const real cable2_response_drift_pz = cable2_response_drift_pz_part
        - M_factor_L_drift_pz_drift_px * cable2_response_drift_px
        - M_factor_L_drift_pz_drift_py * cable2_response_drift_py;
    const real cable2_response_hinge0_part = M_factor_D_inverse_hinge0 * cable2_y_hinge0
        - M_factor_L_hinge0_drift_y * cable2_response_drift_y
        + M_minus_factor_L_hinge0_drift_px * cable2_response_drift_px
        + M_minus_factor_L_hinge0_drift_py * cable2_response_drift_py;
    const real cable2_response_hinge0 = cable2_response_hinge0_part
        + M_minus_factor_L_hinge0_drift_pz * cable2_response_drift_pz;
    const real cable2_minus_response_hinge1_part = M_factor_L_hinge2_hinge1 *
        M_factor_D_inverse_hinge1 + M_factor_L_hinge1_drift_y * cable2_response_drift_y
        + M_factor_L_hinge1_drift_px * cable2_response_drift_px
        + M_factor_L_hinge1_drift_py * cable2_response_drift_py;
    const real cable2_minus_response_hinge1 = cable2_minus_response_hinge1_part
        + M_factor_L_hinge1_drift_pz * cable2_response_drift_pz
        + M_factor_L_hinge1_hinge0 * cable2_response_hinge0;
    const real cable2_response_hinge2_part = M_factor_D_inverse_hinge2
        - M_factor_L_hinge2_drift_y * cable2_response_drift_y
        - M_factor_L_hinge2_drift_px * cable2_response_drift_px
        - M_factor_L_hinge2_drift_py * cable2_response_drift_py
        - M_factor_L_hinge2_drift_pz * cable2_response_drift_pz;
    const real cable2_response_hinge2 = cable2_response_hinge2_part
        - M_factor_L_hinge2_hinge0 * cable2_response_hinge0
        + M_factor_L_hinge2_hinge1 * cable2_minus_response_hinge1;
    const real cable2_response_hinge3_part = M_factor_L_hinge3_drift_y * cable2_response_drift_y
        + M_factor_L_hinge3_drift_px * cable2_response_drift_px
        + M_factor_L_hinge3_drift_py * cable2_response_drift_py
        + M_factor_L_hinge3_drift_pz * cable2_response_drift_pz;
    const real cable2_response_hinge3 = M_factor_L_hinge3_hinge1 * cable2_minus_response_hinge1
        - (cable2_response_hinge3_part + M_factor_L_hinge3_hinge0 * cable2_response_hinge0)
        - M_factor_L_hinge3_hinge2 * cable2_response_hinge2;
    const real cable3_y_hinge1 = M_factor_L_hinge3_hinge2 * M_factor_L_hinge2_hinge1
        - M_factor_L_hinge3_hinge1;
    const real cable3_y_hinge0 = 2.0 - M_factor_L_hinge3_hinge0
        + M_factor_L_hinge3_hinge2 * M_factor_L_hinge2_hinge0
        - M_factor_L_hinge1_hinge0 * cable3_y_hinge1;
    const real cable3_y_drift_pz = M_factor_L_hinge3_hinge2 * M_factor_L_hinge2_drift_pz
        - M_factor_L_hinge3_drift_pz - M_factor_L_hinge1_drift_pz * cable3_y_hinge1
        + M_minus_factor_L_hinge0_drift_pz * cable3_y_hinge0;
    const real cable3_y_drift_y_part = M_factor_L_hinge3_hinge2 * M_factor_L_hinge2_drift_y
        - M_factor_L_hinge3_drift_y - M_factor_L_hinge1_drift_y * cable3_y_hinge1
        - M_factor_L_hinge0_drift_y * cable3_y_hinge0
        - M_factor_L_drift_pz_drift_y * cable3_y_drift_pz;
    const real cable3_y_drift_px_part = M_factor_L_hinge3_hinge2 * M_factor_L_hinge2_drift_px
        - M_factor_L_hinge3_drift_px - M_factor_L_hinge1_drift_px * cable3_y_hinge1
        + M_minus_factor_L_hinge0_drift_px * cable3_y_hinge0
        - M_factor_L_drift_pz_drift_px * cable3_y_drift_pz;
    const real cable3_y_drift_py = M_factor_L_hinge3_hinge2 * M_factor_L_hinge2_drift_py
        - M_factor_L_hinge3_drift_py - M_factor_L_hinge1_drift_py * cable3_y_hinge1
        + M_minus_factor_L_hinge0_drift_py * cable3_y_hinge0
        - M_factor_L_drift_pz_drift_py * cable3_y_drift_pz;
    const real cable3_y_drift_px = cable3_y_drift_px_part
        - M_factor_L_drift_py_drift_px * cable3_y_drift_py;
    const real cable3_minus_y_drift_z = M_factor_L_drift_pz_drift_z * cable3_y_drift_pz
        + M_factor_L_drift_py_drift_z * cable3_y_drift_py
        + M_factor_L_drift_px_drift_z * cable3_y_drift_px;
    const real cable3_y_drift_y = cable3_y_drift_y_part
        - M_factor_L_drift_py_drift_y * cable3_y_drift_py
        - M_factor_L_drift_px_drift_y * cable3_y_drift_px
        - M_minus_factor_L_drift_z_drift_y * cable3_minus_y_drift_z;
    const real cable3_y_drift_x = M_factor_L_drift_z_drift_x * cable3_minus_y_drift_z
        - (M_factor_L_drift_pz_drift_x * cable3_y_drift_pz
        + M_factor_L_drift_py_drift_x * cable3_y_drift_py
        + M_factor_L_drift_px_drift_x * cable3_y_drift_px)
        - M_factor_L_drift_y_drift_x * cable3_y_drift_y;
    const real cable3_response_drift_x = M_factor_D_inverse_drift_x * cable3_y_drift_x;
    const real cable3_response_drift_y = M_factor_D_inverse_drift_y * cable3_y_drift_y
        - M_factor_L_drift_y_drift_x * cable3_response_drift_x;
    const real cable3_response_drift_z = M_minus_factor_L_drift_z_drift_y * cable3_response_drift_y
        - (M_factor_D_inverse_drift_z * cable3_minus_y_drift_z
        + M_factor_L_drift_z_drift_x * cable3_response_drift_x);
    const real cable3_response_drift_px = M_factor_D_inverse_drift_px * cable3_y_drift_px
        - M_factor_L_drift_px_drift_x * cable3_response_drift_x
        - M_factor_L_drift_px_drift_y * cable3_response_drift_y
        - M_factor_L_drift_px_drift_z * cable3_response_drift_z;
    const real cable3_response_drift_py_part = M_factor_D_inverse_drift_py * cable3_y_drift_py
        - M_factor_L_drift_py_drift_x * cable3_response_drift_x
        - M_factor_L_drift_py_drift_y * cable3_response_drift_y
        - M_factor_L_drift_py_drift_z * cable3_response_drift_z;
    const real cable3_response_drift_py = cable3_response_drift_py_part
        - M_factor_L_drift_py_drift_px * cable3_response_drift_px;
    const real cable3_response_drift_pz_part = M_factor_D_inverse_drift_pz * cable3_y_drift_pz
        - M_factor_L_drift_pz_drift_x * cable3_response_drift_x
        - M_factor_L_drift_pz_drift_y * cable3_response_drift_y
        - M_factor_L_drift_pz_drift_z * cable3_response_drift_z;
    const real cable3_response_drift_pz = cable3_response_drift_pz_part
        - M_factor_L_drift_pz_drift_px * cable3_response_drift_px
        - M_factor_L_drift_pz_drift_py * cable3_response_drift_py;
    const real cable3_response_hinge0_part = M_factor_D_inverse_hinge0 * cable3_y_hinge0
        - M_factor_L_hinge0_drift_y * cable3_response_drift_y
        + M_minus_factor_L_hinge0_drift_px * cable3_response_drift_px
        + M_minus_factor_L_hinge0_drift_py * cable3_response_drift_py;
    const real cable3_response_hinge0 = cable3_response_hinge0_part
        + M_minus_factor_L_hinge0_drift_pz * cable3_response_drift_pz;
    const real cable3_response_hinge1_part = M_factor_D_inverse_hinge1 * cable3_y_hinge1
        - M_factor_L_hinge1_drift_y * cable3_response_drift_y
        - M_factor_L_hinge1_drift_px * cable3_response_drift_px
        - M_factor_L_hinge1_drift_py * cable3_response_drift_py;
    const real cable3_response_hinge1 = cable3_response_hinge1_part
        - M_factor_L_hinge1_drift_pz * cable3_response_drift_pz
        - M_factor_L_hinge1_hinge0 * cable3_response_hinge0;
    const real cable3_minus_response_hinge2_part = M_factor_L_hinge3_hinge2 *
        M_factor_D_inverse_hinge2 + M_factor_L_hinge2_drift_y * cable3_response_drift_y
        + M_factor_L_hinge2_drift_px * cable3_response_drift_px
        + M_factor_L_hinge2_drift_py * cable3_response_drift_py;
    const real cable3_minus_response_hinge2 = cable3_minus_response_hinge2_part
        + M_factor_L_hinge2_drift_pz * cable3_response_drift_pz
        + M_factor_L_hinge2_hinge0 * cable3_response_hinge0
        + M_factor_L_hinge2_hinge1 * cable3_response_hinge1;
    const real cable3_response_hinge3_part = M_factor_D_inverse_hinge3
        - M_factor_L_hinge3_drift_y * cable3_response_drift_y
        - M_factor_L_hinge3_drift_px * cable3_response_drift_px
        - M_factor_L_hinge3_drift_py * cable3_response_drift_py
        - M_factor_L_hinge3_drift_pz * cable3_response_drift_pz;
    const real cable3_response_hinge3 = cable3_response_hinge3_part
        - M_factor_L_hinge3_hinge0 * cable3_response_hinge0
        - M_factor_L_hinge3_hinge1 * cable3_response_hinge1
        + M_factor_L_hinge3_hinge2 * cable3_minus_response_hinge2;
    const real twice_cable1_response_hinge0 = 2.0 * cable1_response_hinge0;
    const real circuit_cable1_cable1 = cable1_response_hinge1 + twice_cable1_response_hinge0;
    circuit_matrix[0][0] = circuit_cable1_cable1;
    const real twice_cable2_response_hinge0 = 2.0 * cable2_response_hinge0;
    const real circuit_cable2_cable1 = cable1_response_hinge2 - twice_cable1_response_hinge0;
    circuit_matrix[0][1] = circuit_cable2_cable1;
    circuit_matrix[1][0] = circuit_cable2_cable1;
    const real circuit_cable2_cable2 = cable2_response_hinge2 - twice_cable2_response_hinge0;
    circuit_matrix[1][1] = circuit_cable2_cable2;
    const real circuit_cable3_cable1 = cable1_response_hinge3 + twice_cable1_response_hinge0;
    circuit_matrix[0][2] = circuit_cable3_cable1;
    circuit_matrix[2][0] = circuit_cable3_cable1;
    const real circuit_cable3_cable2 = cable2_response_hinge3 + twice_cable2_response_hinge0;
    circuit_matrix[1][2] = circuit_cable3_cable2;
    circuit_matrix[2][1] = circuit_cable3_cable2;
    const real circuit_cable3_cable3 = cable3_response_hinge3 + 2.0 * cable3_response_hinge0;
    circuit_matrix[2][2] = circuit_cable3_cable3;
    const real twice_free_udot_hinge0 = 2.0 * free_udot_hinge0;
    const real free_gamma_cable1 = -(free_udot_hinge1 + twice_free_udot_hinge0);
    circuit_right[0] = free_gamma_cable1;
    const real free_gamma_cable2 = -(free_udot_hinge2 - twice_free_udot_hinge0);
    circuit_right[1] = free_gamma_cable2;
    const real free_gamma_cable3 = -(free_udot_hinge3 + twice_free_udot_hinge0);
    circuit_right[2] = free_gamma_cable3;
    /* circuit_matrix lam = circuit_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 3, 1, circuit_matrix[0], circuit_right, circuit_scratch);

    /* cable1: multiplier */
    const real cable1_multiplier = circuit_right[0];

    /* cable2: multiplier */
    const real cable2_multiplier = circuit_right[1];

    /* cable3: multiplier */
    const real cable3_multiplier = circuit_right[2];

    /* drift: udot */
    /* udot = free_udot + response multipliers */
    /* udot: drift.u.xdot [rad/s^2] */
    out[0] = cable1_response_drift_x * cable1_multiplier
        + cable2_response_drift_x * cable2_multiplier
        + cable3_response_drift_x * cable3_multiplier + free_udot_drift_x;
    /* udot: drift.u.ydot [rad/s^2] */
    out[1] = cable2_response_drift_y * cable2_multiplier
        - cable1_minus_response_drift_y * cable1_multiplier
        + cable3_response_drift_y * cable3_multiplier + free_udot_drift_y;
    /* udot: drift.u.zdot [rad/s^2] */
    out[2] = cable2_response_drift_z * cable2_multiplier
        - cable1_minus_response_drift_z * cable1_multiplier
        + cable3_response_drift_z * cable3_multiplier + free_udot_drift_z;
    /* udot: drift.u.pxdot [m/s^2] */
    out[3] = cable1_response_drift_px * cable1_multiplier
        + cable2_response_drift_px * cable2_multiplier
        + cable3_response_drift_px * cable3_multiplier + free_udot_drift_px;
    /* udot: drift.u.pydot [m/s^2] */
    out[4] = cable1_response_drift_py * cable1_multiplier
        + cable2_response_drift_py * cable2_multiplier
        + cable3_response_drift_py * cable3_multiplier + free_udot_drift_py;
    /* udot: drift.u.pzdot [m/s^2] */
    out[5] = cable1_response_drift_pz * cable1_multiplier
        + cable2_response_drift_pz * cable2_multiplier
        + cable3_response_drift_pz * cable3_multiplier + free_udot_drift_pz;

    /* hinge0: udot */
    /* udot = free_udot + response multipliers */
    /* udot: hinge0.udot [rad/s^2] */
    out[6] = cable1_response_hinge0 * cable1_multiplier
        + cable2_response_hinge0 * cable2_multiplier + cable3_response_hinge0 * cable3_multiplier
        + free_udot_hinge0;

    /* hinge1: udot */
    /* udot = free_udot + response multipliers */
    /* udot: hinge1.udot [rad/s^2] */
    out[7] = cable1_response_hinge1 * cable1_multiplier
        - cable2_minus_response_hinge1 * cable2_multiplier
        + cable3_response_hinge1 * cable3_multiplier + free_udot_hinge1;

    /* hinge2: udot */
    /* udot = free_udot + response multipliers */
    /* udot: hinge2.udot [rad/s^2] */
    out[8] = cable1_response_hinge2 * cable1_multiplier
        + cable2_response_hinge2 * cable2_multiplier
        - cable3_minus_response_hinge2 * cable3_multiplier + free_udot_hinge2;

    /* hinge3: udot */
    /* udot = free_udot + response multipliers */
    /* udot: hinge3.udot [rad/s^2] */
    out[9] = cable1_response_hinge3 * cable1_multiplier
        + cable2_response_hinge3 * cable2_multiplier + cable3_response_hinge3 * cable3_multiplier
        + free_udot_hinge3;
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {10, 24, 35, 0, 11, 10, 0, 0, 0, 30, 0, 0, 0, 0, 10, 0, 0, 0, 0, 0};
#endif
