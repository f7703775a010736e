/*
 * inverse_dynamics of satellite
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate
 *
 * Sizes: out 3, work 0, w 12
 * Operations per call: 156 = 92 mul, 34 sub, 17 add, 4 cos, 4 div, 4 sin, 1 sqrt
 * Operations of prepare: 10 = 3 sub, 2 add, 2 mul, 1 cos, 1 sin, 1 sqrt
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
 * Input udot (3): derivatives of the speeds
 *   udot[0]  attitude.u.xdot [rad/s^2]
 *   udot[1]  attitude.u.ydot [rad/s^2]
 *   udot[2]  attitude.u.zdot [rad/s^2]
 *
 * Output tau (3)
 *   out[0]  attitude.u.x.tau [N*m]
 *   out[1]  attitude.u.y.tau [N*m]
 *   out[2]  attitude.u.z.tau [N*m]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* orbit: place */
    const wreal orbit_plane_child_rotation_angle2 = p[1]; /* rad */
    const wreal angle[CARDAN_PADDED(1)] = {orbit_plane_child_rotation_angle2};
    wreal sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    w[1] = cosine[0]; /* orbit_place_yy */
    w[2] = sine[0]; /* orbit_place_yz */

    /* orbit: motion */
    const wreal mu = p[0]; /* m^3/s^2 */
    const wreal orbit_motion = cardan_sqrt(mu);
    w[7] = orbit_motion; /* orbit_motion */

    /* orbit.carrier: omega */
    w[8] = 5.1997490667489175e-11 * orbit_motion; /* orbit_carrier_omega_z */

    /* common */
    const wreal sat_inertia_xx = p[4]; /* kg m^2 */
    const wreal sat_inertia_yy = p[5]; /* kg m^2 */
    const wreal sat_inertia_zz = p[6]; /* kg m^2 */
    const wreal mul_1 = 0.5 * (sat_inertia_xx + sat_inertia_zz + sat_inertia_yy);

    /* sat: base second moment */
    w[9] = mul_1 - sat_inertia_xx; /* sat_base_second_moment_xx */
    w[10] = mul_1 - sat_inertia_yy; /* sat_base_second_moment_yy */
    w[11] = mul_1 - sat_inertia_zz; /* sat_base_second_moment_zz */

    /* parameters as they are */
    w[0] = p[0]; /* mu [m^3/s^2] */
    w[3] = p[2]; /* orbit.position.x [m] */
    w[4] = p[4]; /* sat.inertia.xx [kg m^2] */
    w[5] = p[5]; /* sat.inertia.yy [kg m^2] */
    w[6] = p[6]; /* sat.inertia.zz [kg m^2] */
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

    /* shared by several: motion, cos, sin, R */
    const real attitude_angle1 = q[0]; /* rad */
    const real attitude_angle2 = q[1]; /* rad */
    const real attitude_angle3 = q[2]; /* rad */
    const real t_1 = t[0]; /* s */
    const wreal orbit_motion = w[7];
    const real orbit_motion_2 = 5.1997490667489175e-11 * t_1 * orbit_motion;
    const real angle_2[CARDAN_PADDED(4)] = {orbit_motion_2, attitude_angle1, attitude_angle2,
        attitude_angle3};
    real sine_2[CARDAN_PADDED(4)], cosine_2[CARDAN_PADDED(4)];
    cardan_sincos(4, angle_2, sine_2, cosine_2);
    const real orbit_cos = cosine_2[0];
    const real orbit_sin = sine_2[0];
    const real attitude_R = cosine_2[1];
    const real attitude_R_2 = sine_2[1];
    const real attitude_R_3 = cosine_2[2];
    const real attitude_R_xx = sine_2[2];
    const real attitude_R_4 = cosine_2[3];
    const real attitude_R_5 = sine_2[3];

    /* orbit: R */
    const wreal orbit_place_yy = w[1];
    const wreal orbit_place_yz = w[2];
    const real orbit_R_yx = orbit_place_yy * orbit_sin;
    const real orbit_R_yy = orbit_place_yy * orbit_cos;
    const real orbit_R = orbit_place_yz * orbit_sin;
    const real orbit_R_2 = orbit_place_yz * orbit_cos;

    /* attitude: R */
    const real attitude_R_yx = attitude_R * attitude_R_3;
    const real attitude_R_6 = attitude_R * attitude_R_xx;
    const real attitude_R_7 = attitude_R_2 * attitude_R_3;
    const real attitude_R_8 = attitude_R_2 * attitude_R_xx;
    const real attitude_R_yy = attitude_R_5 * attitude_R_6 - attitude_R_2 * attitude_R_4;
    const real attitude_R_yz = attitude_R_2 * attitude_R_5 + attitude_R_4 * attitude_R_6;
    const real attitude_R_9 = attitude_R * attitude_R_4 + attitude_R_5 * attitude_R_8;
    const real attitude_R_10 = attitude_R_4 * attitude_R_8 - attitude_R * attitude_R_5;
    const real attitude_R_11 = attitude_R_3 * attitude_R_5;
    const real attitude_R_12 = attitude_R_3 * attitude_R_4;

    /* sat: position, alpha, omega, U */
    const real attitude_u_x = u[0]; /* rad/s */
    const real attitude_u_y = u[1]; /* rad/s */
    const real attitude_u_z = u[2]; /* rad/s */
    const real attitude_u_xdot = udot[0]; /* rad/s^2 */
    const real attitude_u_ydot = udot[1]; /* rad/s^2 */
    const real attitude_u_zdot = udot[2]; /* rad/s^2 */
    const wreal orbit_position_x = w[3]; /* m */
    const wreal orbit_carrier_omega_z = w[8];
    const real sat_position = orbit_position_x * orbit_cos;
    const real sat_position_2 = orbit_position_x * orbit_R_yx;
    const real sat_position_3 = orbit_position_x * orbit_R;
    const real sat_alpha = orbit_carrier_omega_z * attitude_R_7;
    const real sat_alpha_2 = orbit_carrier_omega_z * attitude_R_9;
    const real sat_alpha_3 = orbit_carrier_omega_z * attitude_R_10;
    const real sat_omega_x = attitude_u_x - sat_alpha;
    const real sat_omega_y = attitude_u_y - sat_alpha_2;
    const real sat_omega_z = attitude_u_z - sat_alpha_3;
    const real sat_alpha_x = attitude_u_xdot + attitude_u_y * sat_alpha_3
        - attitude_u_z * sat_alpha_2;
    const real sat_alpha_y = attitude_u_ydot + attitude_u_z * sat_alpha
        - attitude_u_x * sat_alpha_3;
    const real sat_alpha_z = attitude_u_zdot - attitude_u_y * sat_alpha
        + attitude_u_x * sat_alpha_2;
    const real sat_U = sat_omega_x * sat_omega_y;
    const real sat_U_2 = sat_omega_x * sat_omega_z;
    const real sat_U_3 = sat_omega_y * sat_omega_z;
    const real sat_U_xy = sat_U - sat_alpha_z;
    const real sat_U_xz = sat_alpha_y + sat_U_2;
    const real sat_U_yx = sat_alpha_z + sat_U;
    const real sat_U_yz = sat_U_3 - sat_alpha_x;
    const real sat_U_zx = sat_U_2 - sat_alpha_y;
    const real sat_U_zy = sat_alpha_x + sat_U_3;

    /* gradient: force */
    const wreal mu = w[0]; /* m^3/s^2 */
    const wreal sat_inertia_xx = w[4]; /* kg m^2 */
    const wreal sat_inertia_yy = w[5]; /* kg m^2 */
    const wreal sat_inertia_zz = w[6]; /* kg m^2 */
    const real gradient_force = (orbit_R_yx * attitude_R_xx - orbit_place_yz * attitude_R_7
        + orbit_R_yy * attitude_R_yx) * sat_position_2;
    const real gradient_force_2 = (orbit_R * attitude_R_xx + orbit_place_yy * attitude_R_7
        + orbit_R_2 * attitude_R_yx) * sat_position_3;
    const real gradient_force_3 = (orbit_cos * attitude_R_xx
        - orbit_sin * attitude_R_yx) * sat_position + gradient_force + gradient_force_2;
    const real gradient_force_4 = (orbit_R_yy * attitude_R_yy - orbit_R_yx * attitude_R_11
        - orbit_place_yz * attitude_R_9) * sat_position_2;
    const real gradient_force_5 = (orbit_R * attitude_R_11 - orbit_R_2 * attitude_R_yy
        - orbit_place_yy * attitude_R_9) * sat_position_3;
    const real gradient_force_6 = gradient_force_4 - (orbit_cos * attitude_R_11
        + orbit_sin * attitude_R_yy) * sat_position - gradient_force_5;
    const real gradient_force_7 = (orbit_R_yy * attitude_R_yz - orbit_R_yx * attitude_R_12
        - orbit_place_yz * attitude_R_10) * sat_position_2;
    const real gradient_force_8 = (orbit_R * attitude_R_12 - orbit_R_2 * attitude_R_yz
        - orbit_place_yy * attitude_R_10) * sat_position_3;
    const real gradient_force_9 = gradient_force_7 - (orbit_cos * attitude_R_12
        + orbit_sin * attitude_R_yz) * sat_position - gradient_force_8;
    const real gradient_force_10 = cardan_sqrt(gradient_force_3 * gradient_force_3
        + gradient_force_9 * gradient_force_9 + gradient_force_6 * gradient_force_6);
    const real gradient_force_11 = gradient_force_3 / gradient_force_10;
    const real gradient_force_12 = gradient_force_6 / gradient_force_10;
    const real gradient_force_13 = gradient_force_9 / gradient_force_10;
    const real gradient_force_14 = sat_inertia_xx * gradient_force_11;
    const real gradient_force_15 = sat_inertia_yy * gradient_force_12;
    const real gradient_force_16 = sat_inertia_zz * gradient_force_13;
    const real gradient_force_17 = mu / (gradient_force_10 * gradient_force_10 * gradient_force_10)
        * 3.0;
    const real gradient_force_18 = (gradient_force_12 * gradient_force_16
        - gradient_force_13 * gradient_force_15) * gradient_force_17;
    const real gradient_force_19 = (gradient_force_13 * gradient_force_14
        - gradient_force_11 * gradient_force_16) * gradient_force_17;
    const real gradient_force_20 = (gradient_force_11 * gradient_force_15
        - gradient_force_12 * gradient_force_14) * gradient_force_17;

    /* sat: n */
    const wreal sat_base_second_moment_xx = w[9];
    const wreal sat_base_second_moment_yy = w[10];
    const wreal sat_base_second_moment_zz = w[11];
    /* tau: attitude.u.x.tau [N*m] */
    out[0] = sat_base_second_moment_yy * sat_U_zy - sat_base_second_moment_zz * sat_U_yz
        - gradient_force_18;
    /* tau: attitude.u.y.tau [N*m] */
    out[1] = sat_base_second_moment_zz * sat_U_xz - sat_base_second_moment_xx * sat_U_zx
        - gradient_force_19;
    /* tau: attitude.u.z.tau [N*m] */
    out[2] = sat_base_second_moment_xx * sat_U_yx - sat_base_second_moment_yy * sat_U_xy
        - gradient_force_20;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {3, 0, 12, 1, 3, 3, 0, 0, 0, 7, 0, 3, 0, 0, 0, 0, 0, 0, 0};
#endif
