/*
 * forward_dynamics of satellite
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 3, work 0, w 15
 * Operations per call: 159 = 95 mul, 37 sub, 14 add, 4 cos, 4 div, 4 sin, 1 sqrt
 * Operations of prepare: 13 = 3 div, 3 sub, 2 add, 2 mul, 1 cos, 1 sin, 1 sqrt
 *
 * Input t (1): time
 *   t[0]  t [s]
 *
 * Input q (3): generalized coordinates
 *   q[0]  attitude.angle1 [rad]
 *   q[1]  attitude.angle2 [rad]
 *   q[2]  attitude.angle3 [rad]
 *
 * Input u (3): generalized speeds
 *   u[0]  attitude.u.x [rad/s]
 *   u[1]  attitude.u.y [rad/s]
 *   u[2]  attitude.u.z [rad/s]
 *
 * Input p (7): parameters, read by prepare_ only
 *
 * Input tau (3): applied generalized forces
 *   tau[0]  attitude.u.x.tau [N*m]
 *   tau[1]  attitude.u.y.tau [N*m]
 *   tau[2]  attitude.u.z.tau [N*m]
 *
 * Output udot (3)
 *   out[0]  attitude.u.xdot [rad/s^2]
 *   out[1]  attitude.u.ydot [rad/s^2]
 *   out[2]  attitude.u.zdot [rad/s^2]
 */
#include "cardan.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* orbit.plane: placement */
    const wreal orbit_plane_child_rotation_angle2 = p[1]; /* rad */
    const wreal angle[CARDAN_PADDED(1)] = {orbit_plane_child_rotation_angle2};
    wreal sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const wreal orbit_plane_child_rotation_angle2_cos = cosine[0];
    const wreal orbit_plane_child_rotation_angle2_sin = sine[0];
    w[1] = orbit_plane_child_rotation_angle2_cos;
    w[2] = orbit_plane_child_rotation_angle2_sin;

    /* orbit: motion */
    const wreal mu = p[0]; /* m^3/s^2 */
    const wreal mu_sqrt = cardan_sqrt(mu);
    w[7] = mu_sqrt;

    /* orbit.carrier: omega */
    /* omega = Rᵀ omega_parent + S_w u */
    const wreal orbit_carrier_omega_z = 5.1997490667489175e-11 * mu_sqrt;
    w[8] = orbit_carrier_omega_z;

    /* sat: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal sat_inertia_xx = p[4]; /* kg m^2 */
    const wreal sat_inertia_yy = p[5]; /* kg m^2 */
    const wreal sat_inertia_zz = p[6]; /* kg m^2 */
    const wreal sat_base_half_trace = 0.5 * (sat_inertia_xx + sat_inertia_zz + sat_inertia_yy);
    const wreal sat_base_second_moment_xx = sat_base_half_trace - sat_inertia_xx;
    const wreal sat_base_second_moment_yy = sat_base_half_trace - sat_inertia_yy;
    const wreal sat_base_second_moment_zz = sat_base_half_trace - sat_inertia_zz;
    w[9] = sat_base_second_moment_xx;
    w[10] = sat_base_second_moment_yy;
    w[11] = sat_base_second_moment_zz;

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const wreal M_factor_D_inverse_attitude_z = 1.0 / sat_inertia_zz;
    const wreal M_factor_D_inverse_attitude_y = 1.0 / sat_inertia_yy;
    const wreal M_factor_D_inverse_attitude_x = 1.0 / sat_inertia_xx;
    w[12] = M_factor_D_inverse_attitude_z;
    w[13] = M_factor_D_inverse_attitude_y;
    w[14] = M_factor_D_inverse_attitude_x;

    /* parameters as they are */
    w[0] = p[0]; /* mu [m^3/s^2] */
    w[3] = p[2]; /* orbit.position.x [m] */
    w[4] = p[4]; /* sat.inertia.xx [kg m^2] */
    w[5] = p[5]; /* sat.inertia.yy [kg m^2] */
    w[6] = p[6]; /* sat.inertia.zz [kg m^2] */
}

#include "lanes.h"

/* udot with M udot + h = f + tau */
CARDAN_API int forward_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const t = in->t;
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    const real *const tau = in->tau;
    (void)work;

    /* shared by several: motion, R */
    /* R = R_fixed R_joint(q) */
    const real attitude_angle1 = q[0]; /* rad */
    const real attitude_angle2 = q[1]; /* rad */
    const real attitude_angle3 = q[2]; /* rad */
    const real t_value = t[0]; /* s */
    const wreal mu_sqrt = w[7];
    const real mu_sqrt_times_t_times_c5p1997490667489175em11 = 5.1997490667489175e-11 * t_value *
        mu_sqrt;
    const real angle[CARDAN_PADDED(4)] = {attitude_angle1, attitude_angle2, attitude_angle3,
        mu_sqrt_times_t_times_c5p1997490667489175em11};
    real sine[CARDAN_PADDED(4)], cosine[CARDAN_PADDED(4)];
    cardan_sincos(4, angle, sine, cosine);
    const real attitude_angle1_cos = cosine[0];
    const real attitude_angle1_sin = sine[0];
    const real attitude_angle2_cos = cosine[1];
    const real attitude_angle2_sin = sine[1];
    const real attitude_angle3_cos = cosine[2];
    const real attitude_angle3_sin = sine[2];
    const real cos_of_mu_sqrt_times_t_times_c5p1997490667489175em11 = cosine[3];
    const real sin_of_mu_sqrt_times_t_times_c5p1997490667489175em11 = sine[3];

    /* attitude: R */
    /* R = R_fixed R_joint(q) */
    const real attitude_R_yx = attitude_angle1_cos * attitude_angle2_cos;
    const real attitude_angle1_cos_times_angle2_sin = attitude_angle1_cos * attitude_angle2_sin;
    const real attitude_minus_R_zx = attitude_angle1_sin * attitude_angle2_cos;
    const real attitude_angle1_sin_times_angle2_sin = attitude_angle1_sin * attitude_angle2_sin;
    const real attitude_R_yy = attitude_angle3_sin * attitude_angle1_cos_times_angle2_sin
        - attitude_angle1_sin * attitude_angle3_cos;
    const real attitude_R_yz = attitude_angle1_sin * attitude_angle3_sin
        + attitude_angle3_cos * attitude_angle1_cos_times_angle2_sin;
    const real attitude_minus_R_zy = attitude_angle1_cos * attitude_angle3_cos
        + attitude_angle3_sin * attitude_angle1_sin_times_angle2_sin;
    const real attitude_minus_R_zz = attitude_angle3_cos * attitude_angle1_sin_times_angle2_sin
        - attitude_angle1_cos * attitude_angle3_sin;
    const real attitude_minus_R_xy = attitude_angle2_cos * attitude_angle3_sin;
    const real attitude_minus_R_xz = attitude_angle2_cos * attitude_angle3_cos;

    /* orbit: R */
    /* R = R_fixed R_joint(q) */
    const wreal orbit_plane_child_rotation_angle2_cos = w[1];
    const wreal orbit_plane_child_rotation_angle2_sin = w[2];
    const real orbit_R_yx = orbit_plane_child_rotation_angle2_cos *
        sin_of_mu_sqrt_times_t_times_c5p1997490667489175em11;
    const real orbit_R_yy = orbit_plane_child_rotation_angle2_cos *
        cos_of_mu_sqrt_times_t_times_c5p1997490667489175em11;
    const real orbit_minus_R_zx = orbit_plane_child_rotation_angle2_sin *
        sin_of_mu_sqrt_times_t_times_c5p1997490667489175em11;
    const real orbit_minus_R_zy = orbit_plane_child_rotation_angle2_sin *
        cos_of_mu_sqrt_times_t_times_c5p1997490667489175em11;

    /* sat: position, alpha, omega, U */
    /* position = position_parent + orientation_parent p */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* omega = Rᵀ omega_parent + S_w u */
    /* U = [alpha] + [omega][omega] */
    const real attitude_u_x = u[0]; /* rad/s */
    const real attitude_u_y = u[1]; /* rad/s */
    const real attitude_u_z = u[2]; /* rad/s */
    const wreal orbit_position_x = w[3]; /* m */
    const wreal orbit_carrier_omega_z = w[8];
    const real sat_position_x = orbit_position_x *
        cos_of_mu_sqrt_times_t_times_c5p1997490667489175em11;
    const real sat_position_y = orbit_position_x * orbit_R_yx;
    const real sat_minus_position_z = orbit_position_x * orbit_minus_R_zx;
    const real sat_minus_alpha_parent_omega_x = orbit_carrier_omega_z * attitude_minus_R_zx;
    const real sat_minus_alpha_parent_omega_y = orbit_carrier_omega_z * attitude_minus_R_zy;
    const real sat_minus_alpha_parent_omega_z = orbit_carrier_omega_z * attitude_minus_R_zz;
    const real sat_omega_x = attitude_u_x - sat_minus_alpha_parent_omega_x;
    const real sat_omega_y = attitude_u_y - sat_minus_alpha_parent_omega_y;
    const real sat_omega_z = attitude_u_z - sat_minus_alpha_parent_omega_z;
    const real sat_alpha_x = attitude_u_y * sat_minus_alpha_parent_omega_z
        - attitude_u_z * sat_minus_alpha_parent_omega_y;
    const real sat_alpha_y = attitude_u_z * sat_minus_alpha_parent_omega_x
        - attitude_u_x * sat_minus_alpha_parent_omega_z;
    const real sat_alpha_z = attitude_u_x * sat_minus_alpha_parent_omega_y
        - attitude_u_y * sat_minus_alpha_parent_omega_x;
    const real sat_omega_x_times_omega_y = sat_omega_x * sat_omega_y;
    const real sat_omega_x_times_omega_z = sat_omega_x * sat_omega_z;
    const real sat_omega_y_times_omega_z = sat_omega_y * sat_omega_z;
    const real sat_U_xy = sat_omega_x_times_omega_y - sat_alpha_z;
    const real sat_U_xz = sat_alpha_y + sat_omega_x_times_omega_z;
    const real sat_U_yx = sat_alpha_z + sat_omega_x_times_omega_y;
    const real sat_U_yz = sat_omega_y_times_omega_z - sat_alpha_x;
    const real sat_U_zx = sat_omega_x_times_omega_z - sat_alpha_y;
    const real sat_U_zy = sat_alpha_x + sat_omega_y_times_omega_z;

    /* gradient: gravity gradient */
    /* torque = 3 mu / r^5 r x I r */
    const wreal mu = w[0]; /* m^3/s^2 */
    const wreal sat_inertia_xx = w[4]; /* kg m^2 */
    const wreal sat_inertia_yy = w[5]; /* kg m^2 */
    const wreal sat_inertia_zz = w[6]; /* kg m^2 */
    const real sat_orientation_xx_times_position_x = (attitude_angle2_sin *
        cos_of_mu_sqrt_times_t_times_c5p1997490667489175em11
        - attitude_R_yx * sin_of_mu_sqrt_times_t_times_c5p1997490667489175em11) * sat_position_x;
    const real gradient_gravity_gradient_r_x_part = sat_orientation_xx_times_position_x
        + (attitude_angle2_sin * orbit_R_yx
        - orbit_plane_child_rotation_angle2_sin * attitude_minus_R_zx
        + attitude_R_yx * orbit_R_yy) * sat_position_y;
    const real gradient_gravity_gradient_r_x = (attitude_angle2_sin * orbit_minus_R_zx
        + orbit_plane_child_rotation_angle2_cos * attitude_minus_R_zx
        + attitude_R_yx * orbit_minus_R_zy) * sat_minus_position_z
        + gradient_gravity_gradient_r_x_part;
    const real sat_minus_orientation_xy_times_position_x = (attitude_minus_R_xy *
        cos_of_mu_sqrt_times_t_times_c5p1997490667489175em11
        + attitude_R_yy * sin_of_mu_sqrt_times_t_times_c5p1997490667489175em11) * sat_position_x;
    const real gradient_gravity_gradient_r_y_part = (attitude_R_yy * orbit_R_yy
        - attitude_minus_R_xy * orbit_R_yx
        - orbit_plane_child_rotation_angle2_sin * attitude_minus_R_zy) * sat_position_y
        - sat_minus_orientation_xy_times_position_x;
    const real gradient_gravity_gradient_r_y = gradient_gravity_gradient_r_y_part
        - (attitude_minus_R_xy * orbit_minus_R_zx - attitude_R_yy * orbit_minus_R_zy
        - orbit_plane_child_rotation_angle2_cos * attitude_minus_R_zy) * sat_minus_position_z;
    const real sat_minus_orientation_xz_times_position_x = (attitude_minus_R_xz *
        cos_of_mu_sqrt_times_t_times_c5p1997490667489175em11
        + attitude_R_yz * sin_of_mu_sqrt_times_t_times_c5p1997490667489175em11) * sat_position_x;
    const real gradient_gravity_gradient_r_z_part = (attitude_R_yz * orbit_R_yy
        - attitude_minus_R_xz * orbit_R_yx
        - orbit_plane_child_rotation_angle2_sin * attitude_minus_R_zz) * sat_position_y
        - sat_minus_orientation_xz_times_position_x;
    const real gradient_gravity_gradient_r_z = gradient_gravity_gradient_r_z_part
        - (attitude_minus_R_xz * orbit_minus_R_zx - attitude_R_yz * orbit_minus_R_zy
        - orbit_plane_child_rotation_angle2_cos * attitude_minus_R_zz) * sat_minus_position_z;
    const real gradient_gravity_gradient_distance = cardan_sqrt(gradient_gravity_gradient_r_x *
        gradient_gravity_gradient_r_x
        + gradient_gravity_gradient_r_z * gradient_gravity_gradient_r_z
        + gradient_gravity_gradient_r_y * gradient_gravity_gradient_r_y);
    const real gradient_gravity_gradient_direction_x = gradient_gravity_gradient_r_x /
        gradient_gravity_gradient_distance;
    const real gradient_gravity_gradient_direction_y = gradient_gravity_gradient_r_y /
        gradient_gravity_gradient_distance;
    const real gradient_gravity_gradient_direction_z = gradient_gravity_gradient_r_z /
        gradient_gravity_gradient_distance;
    const real gradient_gravity_gradient_leaning_x = sat_inertia_xx *
        gradient_gravity_gradient_direction_x;
    const real gradient_gravity_gradient_leaning_y = sat_inertia_yy *
        gradient_gravity_gradient_direction_y;
    const real gradient_gravity_gradient_leaning_z = sat_inertia_zz *
        gradient_gravity_gradient_direction_z;
    const real gradient_gravity_gradient_strength_times_c3 = mu /
        (gradient_gravity_gradient_distance * gradient_gravity_gradient_distance *
        gradient_gravity_gradient_distance) * 3.0;

    /* sat: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal sat_base_second_moment_xx = w[9];
    const wreal sat_base_second_moment_yy = w[10];
    const wreal sat_base_second_moment_zz = w[11];
    const real sat_n_x = sat_base_second_moment_yy * sat_U_zy
        - sat_base_second_moment_zz * sat_U_yz
        - (gradient_gravity_gradient_direction_y * gradient_gravity_gradient_leaning_z
        - gradient_gravity_gradient_direction_z * gradient_gravity_gradient_leaning_y) *
        gradient_gravity_gradient_strength_times_c3;
    const real sat_n_y = sat_base_second_moment_zz * sat_U_xz
        - sat_base_second_moment_xx * sat_U_zx
        - (gradient_gravity_gradient_direction_z * gradient_gravity_gradient_leaning_x
        - gradient_gravity_gradient_direction_x * gradient_gravity_gradient_leaning_z) *
        gradient_gravity_gradient_strength_times_c3;
    const real sat_n_z = sat_base_second_moment_xx * sat_U_yx
        - sat_base_second_moment_yy * sat_U_xy
        - (gradient_gravity_gradient_direction_x * gradient_gravity_gradient_leaning_y
        - gradient_gravity_gradient_direction_y * gradient_gravity_gradient_leaning_x) *
        gradient_gravity_gradient_strength_times_c3;

    /* attitude: drive, udot */
    /* drive = tau + f - h */
    /* udot = M⁻¹ drive */
    const real attitude_u_x_tau = tau[0]; /* N*m */
    const real attitude_u_y_tau = tau[1]; /* N*m */
    const real attitude_u_z_tau = tau[2]; /* N*m */
    const wreal M_factor_D_inverse_attitude_z = w[12];
    const wreal M_factor_D_inverse_attitude_y = w[13];
    const wreal M_factor_D_inverse_attitude_x = w[14];
    const real attitude_drive_x = attitude_u_x_tau - sat_n_x;
    const real attitude_drive_y = attitude_u_y_tau - sat_n_y;
    const real attitude_drive_z = attitude_u_z_tau - sat_n_z;
    out[0] = attitude_drive_x * M_factor_D_inverse_attitude_x; /* udot: attitude.u.xdot [rad/s^2] */
    out[1] = attitude_drive_y * M_factor_D_inverse_attitude_y; /* udot: attitude.u.ydot [rad/s^2] */
    out[2] = attitude_drive_z * M_factor_D_inverse_attitude_z; /* udot: attitude.u.zdot [rad/s^2] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {3, 0, 15, 1, 3, 3, 0, 0, 0, 7, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0};
#endif
