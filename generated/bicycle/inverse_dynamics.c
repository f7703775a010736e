/*
 * inverse_dynamics of bicycle
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: axes, base_parameters
 * passes: reassociate
 *
 * Sizes: out 8, work 0, w 23
 * Operations per call: 405 = 228 mul, 100 add, 65 sub, 6 cos, 6 sin
 * Operations of prepare: 188 = 83 mul, 48 add, 34 sub, 6 div, 4 neg, 4 select, 3 sqrt, 2 atan2,
 *     2 lt, 1 cos, 1 sin
 *
 * Input q (8): generalized coordinates
 *   q[0]  rear_contact.x [m]
 *   q[1]  rear_contact.y [m]
 *   q[2]  rear_contact.yaw [rad]
 *   q[3]  rear_contact.lean [rad]
 *   q[4]  rear_contact.spin [rad]
 *   q[5]  rear_hub [rad]
 *   q[6]  steer [rad]
 *   q[7]  front_hub [rad]
 *
 * Input u (8): generalized speeds
 *   u[0]  rear_contact.u.x [m/s]
 *   u[1]  rear_contact.u.y [m/s]
 *   u[2]  rear_contact.u.yaw [rad/s]
 *   u[3]  rear_contact.u.lean [rad/s]
 *   u[4]  rear_contact.u.spin [rad/s]
 *   u[5]  rear_hub.u [rad/s]
 *   u[6]  steer.u [rad/s]
 *   u[7]  front_hub.u [rad/s]
 *
 * Input p (26): parameters, read by prepare_ only
 *
 * Input udot (8): derivatives of the speeds
 *   udot[0]  rear_contact.u.xdot [m/s^2]
 *   udot[1]  rear_contact.u.ydot [m/s^2]
 *   udot[2]  rear_contact.u.yawdot [rad/s^2]
 *   udot[3]  rear_contact.u.leandot [rad/s^2]
 *   udot[4]  rear_contact.u.spindot [rad/s^2]
 *   udot[5]  rear_hub.udot [rad/s^2]
 *   udot[6]  steer.udot [rad/s^2]
 *   udot[7]  front_hub.udot [rad/s^2]
 *
 * Output tau (8)
 *   out[0]  rear_contact.u.x.tau [N]
 *   out[1]  rear_contact.u.y.tau [N]
 *   out[2]  rear_contact.u.yaw.tau [N*m]
 *   out[3]  rear_contact.u.lean.tau [N*m]
 *   out[4]  rear_contact.u.spin.tau [N*m]
 *   out[5]  rear_hub.u.tau [N*m]
 *   out[6]  steer.u.tau [N*m]
 *   out[7]  front_hub.u.tau [N*m]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* steer: data */
    const wreal tilt = p[2]; /* rad */
    const wreal angle[CARDAN_PADDED(1)] = {tilt};
    wreal sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const wreal steer_data = sine[0];
    const wreal steer_data_2 = cosine[0];

    /* frame: mass, first moment, inertia */
    const wreal rear_radius = p[3]; /* m */
    const wreal frame_mass = p[10]; /* kg */
    const wreal frame_com_x = p[11]; /* m */
    const wreal frame_inertia_xx = p[12]; /* kg m^2 */
    const wreal frame_inertia_xz = p[13]; /* kg m^2 */
    const wreal frame_inertia_yy = p[14]; /* kg m^2 */
    const wreal frame_inertia_zz = p[15]; /* kg m^2 */
    const wreal frame_mass_2 = 0.9 - rear_radius;
    const wreal frame_first_moment_x = frame_mass * frame_com_x;
    const wreal frame_first_moment_z = frame_mass * frame_mass_2;
    const wreal frame_mass_3 = frame_com_x * frame_first_moment_x;
    const wreal frame_mass_4 = frame_mass_2 * frame_first_moment_z;
    const wreal frame_inertia_xz_2 = frame_inertia_xz - frame_mass_2 * frame_first_moment_x;
    const wreal frame_inertia_xx_2 = frame_inertia_xx + frame_mass_4;
    const wreal frame_inertia_yy_2 = frame_inertia_yy + frame_mass_3 + frame_mass_4;
    const wreal frame_inertia_zz_2 = frame_inertia_zz + frame_mass_3;

    /* steer: place */
    const wreal wheelbase = p[0]; /* m */
    const wreal trail = p[1]; /* m */
    const wreal steer_place_x = wheelbase + trail;
    w[2] = steer_place_x; /* steer_place_x */

    /* fork: mass, first moment, inertia */
    const wreal fork_mass = p[16]; /* kg */
    const wreal fork_com_z = p[17]; /* m */
    const wreal fork_inertia_xx = p[18]; /* kg m^2 */
    const wreal fork_inertia_xz = p[19]; /* kg m^2 */
    const wreal fork_inertia_yy = p[20]; /* kg m^2 */
    const wreal fork_inertia_zz = p[21]; /* kg m^2 */
    const wreal fork_mass_2 = 0.9 - trail - wheelbase;
    const wreal fork_first_moment_x = fork_mass * fork_mass_2;
    const wreal fork_first_moment_z = fork_mass * fork_com_z;
    const wreal fork_mass_3 = fork_mass_2 * fork_first_moment_x;
    const wreal fork_mass_4 = fork_com_z * fork_first_moment_z;
    const wreal fork_inertia_xz_2 = fork_inertia_xz - fork_com_z * fork_first_moment_x;
    const wreal fork_inertia_xx_2 = fork_inertia_xx + fork_mass_4;
    const wreal fork_inertia_yy_2 = fork_inertia_yy + fork_mass_3 + fork_mass_4;
    const wreal fork_inertia_zz_2 = fork_inertia_zz + fork_mass_3;

    /* common */
    const wreal rear_wheel_inertia_xx = p[7]; /* kg m^2 */
    const wreal rear_wheel_inertia_yy = p[8]; /* kg m^2 */
    const wreal rear_wheel_inertia_zz = p[9]; /* kg m^2 */
    const wreal front_wheel_inertia_xx = p[23]; /* kg m^2 */
    const wreal front_wheel_inertia_yy = p[24]; /* kg m^2 */
    const wreal front_wheel_inertia_zz = p[25]; /* kg m^2 */
    const wreal sqrt_1 = cardan_sqrt(steer_data * steer_data + steer_data_2 * steer_data_2);
    const wreal div_1 = steer_data / sqrt_1;
    const wreal mul_1 = 0.5 * (rear_wheel_inertia_xx + rear_wheel_inertia_zz
        + rear_wheel_inertia_yy);
    const wreal mul_1_2 = 0.5 * (frame_inertia_xx_2 + frame_inertia_zz_2 + frame_inertia_yy_2);
    const wreal mul_1_3 = 0.5 * (front_wheel_inertia_xx + front_wheel_inertia_zz
        + front_wheel_inertia_yy);
    w[3] = div_1; /* div_1 */

    /* steer: R */
    const wreal steer_R_zz = steer_data_2 / sqrt_1;
    w[4] = steer_R_zz; /* steer_R_zz */

    /* fork: axes, mass */
    const wreal fork_axes = cardan_select(cardan_lt(steer_R_zz, 0.0), -1.0, 1.0);
    const wreal fork_axes_2 = div_1 * fork_axes;
    const wreal fork_mass_5 = steer_R_zz * (fork_inertia_zz_2 * steer_R_zz
        - fork_inertia_xz_2 * div_1);
    const wreal fork_mass_6 = fork_mass_5 - div_1 * (fork_inertia_xz_2 * steer_R_zz
        - fork_inertia_xx_2 * div_1);

    /* shared by several: place */
    const wreal steer_place_2 = steer_R_zz * steer_R_zz + div_1 * div_1;

    /* fork: axes, mass */
    const wreal fork_axes_3 = cardan_lt(steer_place_2, 1e-24);
    const wreal fork_axes_4 = 1.0 / cardan_sqrt(cardan_select(fork_axes_3, 1.0, steer_place_2));
    const wreal fork_axes_5 = cardan_select(fork_axes_3, 1.0 - 1.0 / (steer_R_zz
        + fork_axes) * (div_1 * fork_axes_2), -steer_R_zz * fork_axes_4);
    const wreal fork_axes_6 = cardan_select(fork_axes_3, fork_axes_2, -div_1 * fork_axes_4);
    const wreal fork_axes_7 = steer_R_zz * fork_axes_6 - div_1 * fork_axes_5;
    const wreal fork_axes_8 = fork_axes_5 + div_1 * fork_axes_7;
    const wreal fork_axes_9 = fork_axes_6 - steer_R_zz * fork_axes_7;
    const wreal fork_axes_10 = cardan_sqrt(fork_axes_8 * fork_axes_8 + fork_axes_9 * fork_axes_9);
    const wreal fork_axes_11 = fork_axes_8 / fork_axes_10;
    const wreal fork_axes_12 = fork_axes_9 / fork_axes_10;
    const wreal fork_mass_7 = fork_inertia_xx_2 * fork_axes_11 + fork_inertia_xz_2 * fork_axes_12;
    const wreal fork_mass_8 = fork_inertia_xz_2 * fork_axes_11 + fork_inertia_zz_2 * fork_axes_12;
    const wreal fork_mass_9 = fork_axes_11 * fork_mass_7 + fork_axes_12 * fork_mass_8;

    /* front_hub: R, p, place */
    const wreal front_radius = p[4]; /* m */
    const wreal front_hub_R_yy = steer_R_zz * fork_axes_11 + div_1 * fork_axes_12;
    const wreal front_hub_p_x = front_radius * fork_axes_12 - trail * fork_axes_11;
    const wreal front_hub_p_z = trail * div_1 + front_radius * steer_R_zz;
    w[5] = front_hub_R_yy; /* front_hub_R_yy */
    w[7] = cardan_atan2(-steer_R_zz * front_hub_R_yy, fork_axes_12); /* front_hub_place */

    /* steer: place */
    w[6] = cardan_atan2(-front_hub_R_yy, 0.0); /* steer_place */

    /* fork: mass, base moment */
    const wreal front_wheel_mass = p[22]; /* kg */
    const wreal fork_mass_10 = fork_inertia_yy_2 * front_hub_R_yy * front_hub_R_yy;
    /* fork_base_moment_x */
    w[8] = fork_first_moment_x * fork_axes_11 + fork_first_moment_z * fork_axes_12
        + front_wheel_mass * front_hub_p_x;

    /* front_wheel: base, base second moment */
    const wreal front_wheel_base = 0.5 * front_wheel_mass;
    const wreal front_wheel_base_2 = front_hub_p_x * front_wheel_base;
    const wreal front_wheel_base_3 = front_hub_p_z * front_wheel_base;
    const wreal front_wheel_base_4 = front_hub_p_x * front_wheel_base_2;
    const wreal front_wheel_base_5 = front_hub_p_z * front_wheel_base_3;
    const wreal front_wheel_base_6 = fork_mass + front_wheel_mass;
    const wreal front_wheel_base_7 = fork_first_moment_z * steer_R_zz
        - fork_first_moment_x * div_1 + front_wheel_mass * front_hub_p_z;
    const wreal front_wheel_base_8 = front_hub_p_z * front_wheel_base_2
        + front_hub_p_x * front_wheel_base_3;
    w[15] = mul_1_3 - front_wheel_inertia_xx; /* front_wheel_base_second_moment_xx */
    w[16] = mul_1_3 - front_wheel_inertia_zz; /* front_wheel_base_second_moment_zz */

    /* fork: base inertia, base */
    const wreal fork_base = div_1 * front_wheel_base_7;
    const wreal fork_base_2 = steer_R_zz * front_wheel_base_7;
    const wreal fork_base_3 = 0.5 * front_wheel_base_6;
    const wreal fork_base_4 = steer_place_x * fork_base_3 - fork_base;
    const wreal fork_base_5 = fork_base_2 - rear_radius * fork_base_3;
    const wreal fork_base_6 = steer_place_x * fork_base_4;
    const wreal fork_base_7 = rear_radius * fork_base_5;
    /* fork_base_inertia_xz */
    w[9] = steer_R_zz * fork_mass_8 - div_1 * fork_mass_7 - front_wheel_base_8;

    /* frame: base moment */
    /* frame_base_moment_x */
    w[10] = frame_first_moment_x + steer_place_x * front_wheel_base_6 - fork_base;
    /* frame_base_moment_z */
    w[11] = frame_first_moment_z + fork_base_2 - rear_radius * front_wheel_base_6;

    /* rear_wheel: base mass, base second moment */
    const wreal rear_wheel_mass = p[6]; /* kg */
    w[12] = rear_wheel_mass + frame_mass + front_wheel_base_6; /* rear_wheel_base_mass */
    w[13] = mul_1 - rear_wheel_inertia_xx; /* rear_wheel_base_second_moment_xx */
    w[14] = mul_1 - rear_wheel_inertia_zz; /* rear_wheel_base_second_moment_zz */
    /* rear_wheel_base_second_moment_yy */
    w[22] = mul_1 - rear_wheel_inertia_yy + (mul_1_2 - frame_inertia_yy_2);

    /* common */
    const wreal mul_1_4 = 0.5 * (fork_mass_9 + fork_mass_6 + fork_mass_10);

    /* fork: base second moment */
    /* fork_base_second_moment_xx */
    w[17] = mul_1_4 - fork_mass_9 + (front_wheel_base_4 + front_wheel_base_4);
    /* fork_base_second_moment_yy */
    w[18] = mul_1_4 - fork_mass_10 + front_hub_R_yy * (mul_1_3
        - front_wheel_inertia_yy) * front_hub_R_yy;

    /* front_wheel: base */
    const wreal front_wheel_base_9 = mul_1_4 - fork_mass_6 + (front_wheel_base_5
        + front_wheel_base_5);

    /* fork: base */
    const wreal fork_base_8 = div_1 * front_wheel_base_9;

    /* frame: base second moment */
    /* frame_base_second_moment_xx */
    w[19] = fork_base_6 + div_1 * fork_base_8 + (mul_1_2 - frame_inertia_xx_2 + fork_base_6);
    /* frame_base_second_moment_xz */
    w[20] = steer_place_x * fork_base_5 - rear_radius * fork_base_4 - (frame_inertia_xz_2
        + steer_R_zz * fork_base_8);
    /* frame_base_second_moment_zz */
    w[21] = steer_R_zz * front_wheel_base_9 * steer_R_zz - fork_base_7 + (mul_1_2
        - frame_inertia_zz_2 - fork_base_7);

    /* parameters as they are */
    w[0] = p[3]; /* rear_radius [m] */
    w[1] = p[5]; /* gravity.z [m/s^2] */
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

    /* shared by several: R, sin, cos */
    const real rear_contact_yaw = q[2]; /* rad */
    const real rear_contact_lean = q[3]; /* rad */
    const real rear_contact_spin = q[4]; /* rad */
    const real rear_hub_q = q[5]; /* rad */
    const real steer_q = q[6]; /* rad */
    const real front_hub_q = q[7]; /* rad */
    const wreal steer_place = w[6];
    const wreal front_hub_place = w[7];
    const real steer_R = steer_q + steer_place;
    const real front_hub_R = front_hub_q + front_hub_place;
    const real angle_2[CARDAN_PADDED(6)] = {rear_contact_yaw, rear_contact_lean, rear_contact_spin,
        rear_hub_q, steer_R, front_hub_R};
    real sine_2[CARDAN_PADDED(6)], cosine_2[CARDAN_PADDED(6)];
    cardan_sincos(6, angle_2, sine_2, cosine_2);
    const real rear_contact_R = cosine_2[0];
    const real rear_contact_R_2 = sine_2[0];
    const real rear_contact_R_3 = cosine_2[1];
    const real rear_contact_sin = sine_2[1];
    const real rear_contact_R_4 = cosine_2[2];
    const real rear_contact_R_5 = sine_2[2];
    const real rear_hub_cos = cosine_2[3];
    const real rear_hub_sin = sine_2[3];
    const real steer_cos = cosine_2[4];
    const real steer_sin = sine_2[4];
    const real front_hub_cos = cosine_2[5];
    const real front_hub_sin = sine_2[5];

    /* rear_contact: R, S, drift */
    const real rear_contact_u_yaw = u[2]; /* rad/s */
    const real rear_contact_u_lean = u[3]; /* rad/s */
    const real rear_contact_u_spin = u[4]; /* rad/s */
    const wreal rear_radius = w[0]; /* m */
    const real rear_contact_R_6 = rear_contact_R_2 * rear_contact_R_3;
    const real rear_contact_R_7 = rear_contact_R_2 * rear_contact_sin;
    const real rear_contact_R_yy = rear_contact_R * rear_contact_R_3;
    const real rear_contact_R_8 = rear_contact_R * rear_contact_sin;
    const real rear_contact_R_xx = rear_contact_R * rear_contact_R_4
        - rear_contact_R_7 * rear_contact_R_5;
    const real rear_contact_R_xz = rear_contact_R * rear_contact_R_5
        + rear_contact_R_7 * rear_contact_R_4;
    const real rear_contact_R_yx = rear_contact_R_2 * rear_contact_R_4
        + rear_contact_R_8 * rear_contact_R_5;
    const real rear_contact_R_yz = rear_contact_R_2 * rear_contact_R_5
        - rear_contact_R_8 * rear_contact_R_4;
    const real rear_contact_R_9 = rear_contact_R_3 * rear_contact_R_5;
    const real rear_contact_R_zz = rear_contact_R_3 * rear_contact_R_4;
    const real rear_contact_S = rear_radius * rear_contact_sin;
    const real rear_contact_S_2 = rear_contact_R_4 * rear_contact_S;
    const real rear_contact_S_3 = rear_contact_R_5 * rear_contact_S;
    const real rear_contact_drift = rear_contact_u_yaw * rear_contact_sin;
    const real rear_contact_drift_2 = rear_contact_u_yaw * rear_contact_R_3;
    const real rear_contact_drift_3 = rear_contact_u_spin * rear_contact_drift_2;
    const real rear_contact_drift_4 = rear_contact_u_lean * rear_contact_u_spin
        - rear_contact_u_lean * rear_contact_drift;
    const real rear_contact_drift_5 = 2.0 * rear_contact_u_lean * rear_contact_drift_2 *
        rear_radius;
    const real rear_contact_drift_6 = rear_radius * (rear_contact_u_lean * rear_contact_u_lean
        + rear_contact_drift * rear_contact_drift);

    /* rear_wheel: omega, alpha, a, U, n */
    const real rear_contact_u_xdot = udot[0]; /* m/s^2 */
    const real rear_contact_u_ydot = udot[1]; /* m/s^2 */
    const real rear_contact_u_yawdot = udot[2]; /* rad/s^2 */
    const real rear_contact_u_leandot = udot[3]; /* rad/s^2 */
    const real rear_contact_u_spindot = udot[4]; /* rad/s^2 */
    const wreal gravity_z = w[1]; /* m/s^2 */
    const wreal rear_wheel_base_second_moment_xx = w[13];
    const wreal rear_wheel_base_second_moment_zz = w[14];
    const wreal rear_wheel_base_second_moment_yy = w[22];
    const real rear_wheel_omega_x = rear_contact_u_lean * rear_contact_R_4
        - rear_contact_u_yaw * rear_contact_R_9;
    const real rear_wheel_omega_y = rear_contact_u_spin + rear_contact_drift;
    const real rear_wheel_omega_z = rear_contact_u_yaw * rear_contact_R_zz
        + rear_contact_u_lean * rear_contact_R_5;
    const real rear_wheel_alpha = rear_contact_u_leandot * rear_contact_R_4
        - rear_contact_u_yawdot * rear_contact_R_9 - rear_contact_R_4 * rear_contact_drift_3;
    const real rear_wheel_alpha_x = rear_wheel_alpha - rear_contact_R_5 * rear_contact_drift_4;
    const real rear_wheel_alpha_y = rear_contact_u_spindot
        + rear_contact_u_yawdot * rear_contact_sin + rear_contact_u_lean * rear_contact_drift_2;
    const real rear_wheel_alpha_2 = rear_contact_u_yawdot * rear_contact_R_zz
        + rear_contact_u_leandot * rear_contact_R_5;
    const real rear_wheel_alpha_z = rear_wheel_alpha_2 - rear_contact_R_5 * rear_contact_drift_3
        + rear_contact_R_4 * rear_contact_drift_4;
    const real rear_wheel_a = rear_contact_u_yawdot * rear_contact_S_2
        + gravity_z * rear_contact_R_9 + rear_contact_u_ydot * rear_contact_R_yx;
    const real rear_wheel_a_2 = rear_contact_R_4 * rear_contact_drift_5
        + rear_contact_u_xdot * rear_contact_R_xx + rear_contact_R_5 * rear_contact_drift_6;
    const real rear_wheel_a_x = rear_wheel_a + rear_wheel_a_2;
    const real rear_wheel_a_3 = rear_contact_drift * rear_contact_drift_2 * rear_radius
        - (rear_radius * rear_contact_u_leandot + gravity_z * rear_contact_sin);
    const real rear_wheel_a_y = rear_contact_u_ydot * rear_contact_R_yy
        - rear_contact_u_xdot * rear_contact_R_6 + rear_wheel_a_3;
    const real rear_wheel_a_4 = rear_contact_u_yawdot * rear_contact_S_3
        - gravity_z * rear_contact_R_zz + rear_contact_u_ydot * rear_contact_R_yz;
    const real rear_wheel_a_5 = rear_contact_R_5 * rear_contact_drift_5
        + rear_contact_u_xdot * rear_contact_R_xz - rear_contact_R_4 * rear_contact_drift_6;
    const real rear_wheel_a_z = rear_wheel_a_4 + rear_wheel_a_5;
    const real rear_wheel_U = rear_wheel_omega_x * rear_wheel_omega_y;
    const real rear_wheel_U_2 = rear_wheel_omega_x * rear_wheel_omega_z;
    const real rear_wheel_U_3 = rear_wheel_omega_y * rear_wheel_omega_z;
    const real rear_wheel_U_xy = rear_wheel_U - rear_wheel_alpha_z;
    const real rear_wheel_U_xz = rear_wheel_alpha_y + rear_wheel_U_2;
    const real rear_wheel_U_yx = rear_wheel_alpha_z + rear_wheel_U;
    const real rear_wheel_U_yz = rear_wheel_U_3 - rear_wheel_alpha_x;
    const real rear_wheel_U_zx = rear_wheel_U_2 - rear_wheel_alpha_y;
    const real rear_wheel_U_zy = rear_wheel_alpha_x + rear_wheel_U_3;
    const real rear_wheel_n = rear_wheel_base_second_moment_yy * rear_wheel_U_zy
        - rear_wheel_base_second_moment_zz * rear_wheel_U_yz;
    const real rear_wheel_n_2 = rear_wheel_base_second_moment_xx * rear_wheel_U_yx
        - rear_wheel_base_second_moment_yy * rear_wheel_U_xy;

    /* frame: omega, alpha, a, U, n */
    const real rear_hub_u = u[5]; /* rad/s */
    const real rear_hub_udot = udot[5]; /* rad/s^2 */
    const wreal frame_base_moment_x = w[10];
    const wreal frame_base_moment_z = w[11];
    const wreal frame_base_second_moment_xx = w[19];
    const wreal frame_base_second_moment_xz = w[20];
    const wreal frame_base_second_moment_zz = w[21];
    const real frame_omega_x = rear_wheel_omega_x * rear_hub_cos
        - rear_wheel_omega_z * rear_hub_sin;
    const real frame_omega_z = rear_wheel_omega_x * rear_hub_sin
        + rear_wheel_omega_z * rear_hub_cos;
    const real frame_omega_y = rear_hub_u + rear_wheel_omega_y;
    const real frame_alpha_x = rear_wheel_alpha_x * rear_hub_cos
        - rear_wheel_alpha_z * rear_hub_sin - rear_hub_u * frame_omega_z;
    const real frame_alpha_y = rear_hub_udot + rear_wheel_alpha_y;
    const real frame_alpha_z = rear_hub_u * frame_omega_x + rear_wheel_alpha_x * rear_hub_sin
        + rear_wheel_alpha_z * rear_hub_cos;
    const real frame_a_x = rear_wheel_a_x * rear_hub_cos - rear_wheel_a_z * rear_hub_sin;
    const real frame_a_z = rear_wheel_a_x * rear_hub_sin + rear_wheel_a_z * rear_hub_cos;
    const real frame_U = frame_omega_y * frame_omega_y;
    const real frame_U_2 = frame_omega_x * frame_omega_z;
    const real frame_U_3 = frame_U + frame_omega_z * frame_omega_z;
    const real frame_U_xz = frame_alpha_y + frame_U_2;
    const real frame_U_yx = frame_alpha_z + frame_omega_x * frame_omega_y;
    const real frame_U_yz = frame_omega_z * frame_omega_y - frame_alpha_x;
    const real frame_U_zx = frame_U_2 - frame_alpha_y;
    const real frame_U_4 = frame_omega_x * frame_omega_x + frame_U;
    const real frame_n = frame_base_second_moment_zz * frame_U_yz
        + frame_base_moment_z * rear_wheel_a_y + frame_base_second_moment_xz * frame_U_yx;
    const real frame_n_2 = frame_base_second_moment_zz * frame_U_xz
        - frame_base_second_moment_xx * frame_U_zx;
    const real frame_n_3 = frame_base_second_moment_xz * (frame_U_4 - frame_U_3) + frame_n_2
        + (frame_base_moment_z * frame_a_x - frame_base_moment_x * frame_a_z);
    const real frame_n_4 = frame_base_second_moment_xx * frame_U_yx
        + frame_base_moment_x * rear_wheel_a_y + frame_base_second_moment_xz * frame_U_yz;

    /* steer: R */
    const wreal div_1 = w[3];
    const wreal steer_R_zz = w[4];
    const real steer_R_2 = steer_R_zz * steer_sin;
    const real steer_R_3 = steer_R_zz * steer_cos;
    const real steer_R_4 = div_1 * steer_sin;
    const real steer_R_5 = div_1 * steer_cos;

    /* fork: omega, alpha, a, U, inertia force, f, n */
    const real steer_u = u[6]; /* rad/s */
    const real steer_udot = udot[6]; /* rad/s^2 */
    const wreal steer_place_x = w[2];
    const wreal fork_base_moment_x = w[8];
    const wreal fork_base_inertia_xz = w[9];
    const wreal fork_base_second_moment_xx = w[17];
    const wreal fork_base_second_moment_yy = w[18];
    const real fork_omega_x = frame_omega_y * steer_cos - frame_omega_x * steer_R_2
        - frame_omega_z * steer_R_4;
    const real fork_alpha = frame_omega_x * steer_R_3 + frame_omega_y * steer_sin
        + frame_omega_z * steer_R_5;
    const real fork_omega_z = steer_u + steer_R_zz * frame_omega_z - div_1 * frame_omega_x;
    const real fork_alpha_x = steer_cos * frame_alpha_y - steer_R_2 * frame_alpha_x
        - (steer_u * fork_alpha + steer_R_4 * frame_alpha_z);
    const real fork_alpha_2 = steer_u * fork_omega_x + steer_sin * frame_alpha_y
        + (steer_R_3 * frame_alpha_x + steer_R_5 * frame_alpha_z);
    const real fork_alpha_z = steer_udot + steer_R_zz * frame_alpha_z - div_1 * frame_alpha_x;
    const real fork_a = frame_a_x - (steer_place_x * frame_U_3 + rear_radius * frame_U_xz);
    const real fork_a_2 = steer_place_x * frame_U_zx + rear_radius * frame_U_4 + frame_a_z;
    const real fork_a_3 = steer_sin * (rear_wheel_a_y + steer_place_x * frame_U_yx
        - rear_radius * frame_U_yz);
    const real fork_a_z = steer_R_zz * fork_a_2 - div_1 * fork_a;
    const real fork_U = fork_alpha * fork_alpha;
    const real fork_U_2 = fork_omega_x * fork_alpha;
    const real fork_U_3 = fork_alpha * fork_omega_z;
    const real fork_U_4 = fork_U + fork_omega_z * fork_omega_z;
    const real fork_U_yx = fork_alpha_z - fork_U_2;
    const real fork_U_zx = fork_alpha_2 + fork_omega_x * fork_omega_z;
    const real fork_U_zy = fork_alpha_x - fork_U_3;
    const real fork_inertia_force = fork_base_moment_x * (steer_R_3 * fork_a
        + steer_R_5 * fork_a_2 + fork_a_3);
    const real fork_inertia_force_2 = fork_base_moment_x * fork_U_4;
    const real fork_f_y = fork_base_moment_x * fork_U_yx;
    const real fork_f_z = fork_base_moment_x * fork_U_zx;
    const real fork_n = fork_base_second_moment_xx * fork_U_zx
        + fork_base_inertia_xz * (fork_omega_x * fork_omega_x + fork_U - fork_U_4);
    const real fork_n_2 = fork_base_second_moment_xx * fork_U_yx
        + fork_base_second_moment_yy * (fork_alpha_z + fork_U_2);
    const real fork_f = steer_R_2 * fork_inertia_force_2 - steer_R_3 * fork_f_y - div_1 * fork_f_z;
    const real fork_f_2 = steer_cos * fork_inertia_force_2 + steer_sin * fork_f_y;
    const real fork_f_3 = steer_R_4 * fork_inertia_force_2 - steer_R_5 * fork_f_y
        + steer_R_zz * fork_f_z;

    /* front_hub: R */
    const wreal front_hub_R_yy = w[5];
    const real front_hub_R_2 = front_hub_R_yy * front_hub_cos;
    const real front_hub_R_3 = front_hub_R_yy * front_hub_sin;

    /* front_wheel: alpha, omega, U, inertia force, n */
    const real front_hub_u = u[7]; /* rad/s */
    const real front_hub_udot = udot[7]; /* rad/s^2 */
    const wreal front_wheel_base_second_moment_xx = w[15];
    const wreal front_wheel_base_second_moment_zz = w[16];
    const real front_wheel_alpha = fork_omega_x * front_hub_sin + fork_omega_z * front_hub_R_2;
    const real front_wheel_omega_z = fork_omega_x * front_hub_cos - fork_omega_z * front_hub_R_3;
    const real front_wheel_omega_y = front_hub_u - front_hub_R_yy * fork_alpha;
    const real front_wheel_alpha_y = front_hub_udot - front_hub_R_yy * fork_alpha_2;
    const real front_wheel_alpha_z = front_hub_cos * fork_alpha_x
        - front_hub_u * front_wheel_alpha - front_hub_R_3 * fork_alpha_z;
    const real front_wheel_U = front_wheel_alpha * front_wheel_omega_z;
    const real front_wheel_U_xz = front_wheel_alpha_y - front_wheel_U;
    const real front_wheel_U_yx = front_wheel_alpha_z - front_wheel_alpha * front_wheel_omega_y;
    const real front_wheel_U_2 = front_hub_u * front_wheel_omega_z
        + front_wheel_omega_z * front_wheel_omega_y;
    const real front_wheel_U_yz = front_hub_sin * fork_alpha_x + front_hub_R_2 * fork_alpha_z
        + front_wheel_U_2;
    const real front_wheel_inertia_force = front_wheel_base_second_moment_zz * front_wheel_U_yz;
    const real front_wheel_inertia_force_2 = front_wheel_base_second_moment_xx *
        (front_wheel_alpha_y + front_wheel_U);
    const real front_wheel_n_y = front_wheel_base_second_moment_zz * front_wheel_U_xz
        + front_wheel_inertia_force_2;
    const real front_wheel_n_z = front_wheel_base_second_moment_xx * front_wheel_U_yx;
    out[7] = front_wheel_n_y; /* tau: front_hub.u.tau [N*m] */

    /* fork: n */
    const real fork_n_3 = fork_base_second_moment_yy * fork_U_zy
        + fork_base_inertia_xz * fork_U_yx + front_hub_sin * front_wheel_inertia_force;
    const real fork_n_x = front_hub_cos * front_wheel_n_z + fork_n_3;
    const real fork_n_y = front_hub_R_yy * front_wheel_n_y - (fork_base_moment_x * fork_a_z
        + fork_n);
    const real fork_n_4 = fork_base_inertia_xz * (fork_alpha_x + fork_U_3) + fork_n_2
        - fork_inertia_force + front_hub_R_2 * front_wheel_inertia_force;
    const real fork_n_z = fork_n_4 - front_hub_R_3 * front_wheel_n_z;
    out[6] = fork_n_z; /* tau: steer.u.tau [N*m] */

    /* frame: n, f */
    const real frame_n_5 = rear_radius * fork_f_2 + frame_n + steer_R_2 * fork_n_x
        + (steer_R_3 * fork_n_y + div_1 * fork_n_z);
    const real frame_n_y = frame_n_3 - rear_radius * fork_f - steer_place_x * fork_f_3
        + (steer_cos * fork_n_x - steer_sin * fork_n_y);
    const real frame_n_z = frame_n_4 - steer_place_x * fork_f_2 + steer_R_zz * fork_n_z
        - (steer_R_4 * fork_n_x + steer_R_5 * fork_n_y);
    const real frame_f_x = frame_base_moment_z * frame_U_xz - frame_base_moment_x * frame_U_3
        + fork_f;
    const real frame_f_y = frame_base_moment_x * frame_U_yx + frame_base_moment_z * frame_U_yz
        - fork_f_2;
    const real frame_f_z = frame_base_moment_x * frame_U_zx - frame_base_moment_z * frame_U_4
        + fork_f_3;
    out[5] = frame_n_y; /* tau: rear_hub.u.tau [N*m] */

    /* rear_wheel: n, f */
    const wreal rear_wheel_base_mass = w[12];
    const real rear_wheel_n_x = rear_hub_sin * frame_n_z + rear_wheel_n - rear_hub_cos * frame_n_5;
    const real rear_wheel_n_y = rear_wheel_base_second_moment_zz * rear_wheel_U_xz
        - rear_wheel_base_second_moment_xx * rear_wheel_U_zx + frame_n_y;
    const real rear_wheel_n_z = rear_hub_sin * frame_n_5 + rear_wheel_n_2
        + rear_hub_cos * frame_n_z;
    const real rear_wheel_f_x = rear_wheel_base_mass * rear_wheel_a_x + rear_hub_cos * frame_f_x
        + rear_hub_sin * frame_f_z;
    const real rear_wheel_f_y = rear_wheel_base_mass * rear_wheel_a_y + frame_f_y;
    const real rear_wheel_f_z = rear_wheel_base_mass * rear_wheel_a_z + rear_hub_cos * frame_f_z
        - rear_hub_sin * frame_f_x;
    out[4] = rear_wheel_n_y; /* tau: rear_contact.u.spin.tau [N*m] */

    /* rear_contact: tau, tau yaw, tau lean */
    const real rear_contact_tau = rear_contact_S_2 * rear_wheel_f_x
        + rear_contact_S_3 * rear_wheel_f_z + rear_contact_sin * rear_wheel_n_y;
    /* tau: rear_contact.u.x.tau [N] */
    out[0] = rear_contact_R_xx * rear_wheel_f_x - rear_contact_R_6 * rear_wheel_f_y
        + rear_contact_R_xz * rear_wheel_f_z;
    /* tau: rear_contact.u.y.tau [N] */
    out[1] = rear_contact_R_yx * rear_wheel_f_x + rear_contact_R_yy * rear_wheel_f_y
        + rear_contact_R_yz * rear_wheel_f_z;
    /* tau: rear_contact.u.yaw.tau [N*m] */
    out[2] = rear_contact_tau - rear_contact_R_9 * rear_wheel_n_x
        + rear_contact_R_zz * rear_wheel_n_z;
    /* tau: rear_contact.u.lean.tau [N*m] */
    out[3] = rear_contact_R_4 * rear_wheel_n_x - rear_radius * rear_wheel_f_y
        + rear_contact_R_5 * rear_wheel_n_z;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {8, 0, 23, 0, 8, 8, 0, 0, 0, 26, 0, 8, 0, 0, 0, 0, 0, 0, 0};
#endif
