/*
 * forward_dynamics of bicycle
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: axes, base_parameters
 * passes: unroll
 *
 * Sizes: out 8, work 282, w 38
 * Operations per call: 3134 = 1755 mul, 674 add, 664 sub, 19 div, 6 cos, 6 neg, 6 sin, 2 select,
 *     1 solve, 1 sqrt
 * Operations of prepare: 230 = 99 mul, 65 add, 42 sub, 7 div, 4 neg, 4 select, 3 sqrt, 2 atan2,
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
 * Input tau (8): applied generalized forces
 *   tau[0]  rear_contact.u.x.tau [N]
 *   tau[1]  rear_contact.u.y.tau [N]
 *   tau[2]  rear_contact.u.yaw.tau [N*m]
 *   tau[3]  rear_contact.u.lean.tau [N*m]
 *   tau[4]  rear_contact.u.spin.tau [N*m]
 *   tau[5]  rear_hub.u.tau [N*m]
 *   tau[6]  steer.u.tau [N*m]
 *   tau[7]  front_hub.u.tau [N*m]
 *
 * Output udot (8)
 *   out[0]  rear_contact.u.xdot [m/s^2]
 *   out[1]  rear_contact.u.ydot [m/s^2]
 *   out[2]  rear_contact.u.yawdot [rad/s^2]
 *   out[3]  rear_contact.u.leandot [rad/s^2]
 *   out[4]  rear_contact.u.spindot [rad/s^2]
 *   out[5]  rear_hub.udot [rad/s^2]
 *   out[6]  steer.udot [rad/s^2]
 *   out[7]  front_hub.udot [rad/s^2]
 */
#include "cardan.h"
#include "solve.h"
#include "dependent.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
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
    const wreal frame_inertia_yy_2 = frame_mass_3 + frame_mass_4 + frame_inertia_yy;
    const wreal frame_inertia_zz_2 = frame_inertia_zz + frame_mass_3;

    /* steer: place */
    const wreal wheelbase = p[0]; /* m */
    const wreal trail = p[1]; /* m */
    const wreal steer_place_x = wheelbase + trail;
    w[4] = steer_place_x; /* steer_place_x */

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
    const wreal fork_inertia_yy_2 = fork_mass_3 + fork_mass_4 + fork_inertia_yy;
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
    const wreal mul_1 = 0.5 * (rear_wheel_inertia_xx + rear_wheel_inertia_yy
        + rear_wheel_inertia_zz);
    const wreal mul_1_2 = 0.5 * (frame_inertia_xx_2 + frame_inertia_yy_2 + frame_inertia_zz_2);
    const wreal mul_1_3 = 0.5 * (front_wheel_inertia_xx + front_wheel_inertia_yy
        + front_wheel_inertia_zz);
    w[5] = div_1; /* div_1 */

    /* steer: R */
    const wreal steer_R_zz = steer_data_2 / sqrt_1;
    w[6] = steer_R_zz; /* steer_R_zz */

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
    w[7] = front_hub_R_yy; /* front_hub_R_yy */
    w[9] = front_hub_p_x; /* front_hub_p_x */
    w[10] = front_hub_p_z; /* front_hub_p_z */
    w[11] = cardan_atan2(-steer_R_zz * front_hub_R_yy, fork_axes_12); /* front_hub_place */

    /* steer: place */
    w[8] = cardan_atan2(-front_hub_R_yy, 0.0); /* steer_place */

    /* fork: mass, base moment */
    const wreal front_wheel_mass = p[22]; /* kg */
    const wreal fork_mass_10 = fork_inertia_yy_2 * front_hub_R_yy * front_hub_R_yy;
    /* fork_base_moment_x */
    w[13] = fork_first_moment_x * fork_axes_11 + fork_first_moment_z * fork_axes_12
        + front_wheel_mass * front_hub_p_x;

    /* front_wheel: base inertia, base, base second moment */
    const wreal front_wheel_base = 0.5 * front_wheel_mass;
    const wreal front_wheel_base_2 = front_hub_p_x * front_wheel_base;
    const wreal front_wheel_base_3 = front_hub_p_z * front_wheel_base;
    const wreal front_wheel_base_4 = front_hub_p_x * front_wheel_base_2;
    const wreal front_wheel_base_5 = front_hub_p_z * front_wheel_base_3;
    const wreal front_wheel_base_6 = 2.0 * (front_wheel_base_4 + front_wheel_base_5);
    const wreal front_wheel_base_7 = front_hub_p_z * front_wheel_base_2
        + front_hub_p_x * front_wheel_base_3;
    const wreal front_wheel_base_8 = fork_mass + front_wheel_mass;
    const wreal front_wheel_base_9 = fork_first_moment_z * steer_R_zz
        - fork_first_moment_x * div_1 + front_wheel_mass * front_hub_p_z;
    const wreal front_wheel_base_10 = front_wheel_base_6 - 2.0 * front_wheel_base_4
        + front_wheel_inertia_xx + fork_mass_9;
    w[12] = front_wheel_inertia_zz - front_wheel_inertia_xx; /* front_wheel_base_inertia_zz */
    w[26] = mul_1_3 - front_wheel_inertia_xx; /* front_wheel_base_second_moment_xx */
    w[27] = mul_1_3 - front_wheel_inertia_zz; /* front_wheel_base_second_moment_zz */

    /* fork: base inertia, base */
    const wreal fork_base_inertia_yy = fork_mass_10 + front_wheel_base_6 - front_wheel_base_10;
    const wreal fork_base = div_1 * front_wheel_base_9;
    const wreal fork_base_2 = steer_R_zz * front_wheel_base_9;
    const wreal fork_base_3 = steer_R_zz * front_wheel_base_10;
    const wreal fork_base_4 = 0.5 * front_wheel_base_8;
    const wreal fork_base_5 = steer_place_x * fork_base_4 - fork_base;
    const wreal fork_base_6 = fork_base_2 - rear_radius * fork_base_4;
    const wreal fork_base_7 = steer_place_x * fork_base_5;
    const wreal fork_base_8 = rear_radius * fork_base_6;
    const wreal fork_base_9 = 2.0 * (fork_base_7 - fork_base_8);
    const wreal fork_base_10 = steer_place_x * fork_base_6 - rear_radius * fork_base_5;
    const wreal fork_base_11 = fork_base_9 - 2.0 * fork_base_7 + steer_R_zz * fork_base_3
        + frame_inertia_xx_2;
    /* fork_base_inertia_xz */
    w[14] = steer_R_zz * fork_mass_8 - div_1 * fork_mass_7 - front_wheel_base_7;
    /* fork_base_inertia_zz */
    w[15] = front_wheel_base_6 - 2.0 * front_wheel_base_5
        + front_wheel_inertia_xx * front_hub_R_yy * front_hub_R_yy + fork_mass_6;

    /* frame: base moment, base inertia */
    /* frame_base_moment_x */
    w[16] = steer_place_x * front_wheel_base_8 - fork_base + frame_first_moment_x;
    /* frame_base_moment_z */
    w[17] = fork_base_2 - rear_radius * front_wheel_base_8 + frame_first_moment_z;
    w[18] = div_1 * fork_base_3 - fork_base_10 + frame_inertia_xz_2; /* frame_base_inertia_xz */
    w[19] = front_wheel_base_10 + fork_base_9 + frame_inertia_yy_2; /* frame_base_inertia_yy */
    /* frame_base_inertia_zz */
    w[20] = fork_base_9 + 2.0 * fork_base_8 + div_1 * front_wheel_base_10 * div_1
        + frame_inertia_zz_2 - fork_base_11;

    /* rear_wheel: base mass, base inertia, base second moment */
    const wreal rear_wheel_mass = p[6]; /* kg */
    const wreal rear_wheel_base_mass = frame_mass + front_wheel_base_8 + rear_wheel_mass;
    w[21] = rear_wheel_base_mass; /* rear_wheel_base_mass */
    w[22] = rear_wheel_inertia_xx + fork_base_11; /* rear_wheel_base_inertia_xx */
    w[23] = rear_wheel_inertia_zz + fork_base_11; /* rear_wheel_base_inertia_zz */
    w[24] = mul_1 - rear_wheel_inertia_xx; /* rear_wheel_base_second_moment_xx */
    w[25] = mul_1 - rear_wheel_inertia_zz; /* rear_wheel_base_second_moment_zz */
    /* rear_wheel_base_second_moment_yy */
    w[33] = mul_1 - rear_wheel_inertia_yy + (mul_1_2 - frame_inertia_yy_2);

    /* common */
    const wreal mul_1_4 = 0.5 * (fork_mass_9 + fork_mass_10 + fork_mass_6);

    /* fork: base second moment */
    /* fork_base_second_moment_xx */
    w[28] = mul_1_4 - fork_mass_9 + (front_wheel_base_4 + front_wheel_base_4);
    /* fork_base_second_moment_yy */
    w[29] = mul_1_4 - fork_mass_10 + front_hub_R_yy * (mul_1_3
        - front_wheel_inertia_yy) * front_hub_R_yy;

    /* front_wheel: base */
    const wreal front_wheel_base_11 = mul_1_4 - fork_mass_6 + (front_wheel_base_5
        + front_wheel_base_5);

    /* fork: base */
    const wreal fork_base_12 = div_1 * front_wheel_base_11;

    /* frame: base second moment */
    /* frame_base_second_moment_xx */
    w[30] = mul_1_2 - frame_inertia_xx_2 + (fork_base_7 + fork_base_7 + div_1 * fork_base_12);
    /* frame_base_second_moment_xz */
    w[31] = fork_base_10 - steer_R_zz * fork_base_12 - frame_inertia_xz_2;
    /* frame_base_second_moment_zz */
    w[32] = mul_1_2 - frame_inertia_zz_2 + (steer_R_zz * front_wheel_base_11 * steer_R_zz
        - (fork_base_8 + fork_base_8));

    /* shared by several: inertia */
    const wreal fork_inertia = front_wheel_inertia_yy * front_hub_R_yy;
    w[34] = fork_inertia; /* fork_inertia */

    /* fork: composite inertia */
    w[35] = fork_base_inertia_yy + front_hub_R_yy * fork_inertia; /* fork_composite_inertia_yy */

    /* rear_contact: M */
    w[36] = rear_radius * rear_wheel_base_mass; /* rear_contact_M */

    /* constraints: D inverse */
    w[37] = 1.0 / front_wheel_inertia_yy; /* constraints_D_inverse_8 */

    /* parameters as they are */
    w[0] = p[3]; /* rear_radius [m] */
    w[1] = p[4]; /* front_radius [m] */
    w[2] = p[5]; /* gravity.z [m/s^2] */
    w[3] = p[8]; /* rear_wheel.inertia.yy [kg m^2] */
}

#include "lanes.h"

CARDAN_PART int forward_dynamics_part1(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    (void)out;

    /* shared by several: R, G, sin, cos */
    const real rear_contact_yaw = q[2]; /* rad */
    const real rear_contact_lean = q[3]; /* rad */
    const real rear_contact_spin = q[4]; /* rad */
    const real rear_hub_q = q[5]; /* rad */
    const real steer_q = q[6]; /* rad */
    const real front_hub_q = q[7]; /* rad */
    const wreal steer_place = w[8];
    const wreal front_hub_place = w[11];
    const real steer_R = steer_q + steer_place;
    const real front_hub_R = front_hub_q + front_hub_place;
    const real angle_2[CARDAN_PADDED(6)] = {rear_contact_yaw, rear_contact_lean, rear_contact_spin,
        rear_hub_q, steer_R, front_hub_R};
    real sine_2[CARDAN_PADDED(6)], cosine_2[CARDAN_PADDED(6)];
    cardan_sincos(6, angle_2, sine_2, cosine_2);
    const real rear_contact_G = cosine_2[0];
    work[55] = rear_contact_G;
    const real rear_contact_G_2 = sine_2[0];
    work[56] = rear_contact_G_2;
    const real rear_contact_G_3 = cosine_2[1];
    work[57] = rear_contact_G_3;
    const real rear_contact_sin = sine_2[1];
    work[58] = rear_contact_sin;
    const real rear_contact_R = cosine_2[2];
    work[59] = rear_contact_R;
    const real rear_contact_R_2 = sine_2[2];
    work[60] = rear_contact_R_2;
    const real rear_hub_cos = cosine_2[3];
    work[61] = rear_hub_cos;
    const real rear_hub_sin = sine_2[3];
    work[62] = rear_hub_sin;
    const real steer_cos = cosine_2[4];
    work[63] = steer_cos;
    const real steer_sin = sine_2[4];
    work[64] = steer_sin;
    const real front_hub_cos = cosine_2[5];
    work[65] = front_hub_cos;
    const real front_hub_sin = sine_2[5];
    work[66] = front_hub_sin;

    /* rear_contact: R, p, drift, velocity, momentum fx, momentum fz, momentum fy */
    const real rear_contact_x = q[0]; /* m */
    const real rear_contact_y = q[1]; /* m */
    const real rear_contact_u_x = u[0]; /* m/s */
    const real rear_contact_u_y = u[1]; /* m/s */
    const real rear_contact_u_yaw = u[2]; /* rad/s */
    const real rear_contact_u_lean = u[3]; /* rad/s */
    const real rear_contact_u_spin = u[4]; /* rad/s */
    const wreal rear_radius = w[0]; /* m */
    const wreal rear_wheel_base_mass = w[21];
    const real rear_contact_R_3 = rear_contact_G_2 * rear_contact_G_3;
    work[67] = rear_contact_R_3;
    const real rear_contact_R_4 = rear_contact_G_2 * rear_contact_sin;
    work[68] = rear_contact_R_4;
    const real rear_contact_R_yy = rear_contact_G * rear_contact_G_3;
    work[69] = rear_contact_R_yy;
    const real rear_contact_R_5 = rear_contact_G * rear_contact_sin;
    work[70] = rear_contact_R_5;
    const real rear_contact_R_xx = rear_contact_G * rear_contact_R
        - rear_contact_R_4 * rear_contact_R_2;
    work[71] = rear_contact_R_xx;
    const real rear_contact_R_xz = rear_contact_G * rear_contact_R_2
        + rear_contact_R_4 * rear_contact_R;
    work[72] = rear_contact_R_xz;
    const real rear_contact_R_yx = rear_contact_G_2 * rear_contact_R
        + rear_contact_R_5 * rear_contact_R_2;
    work[73] = rear_contact_R_yx;
    const real rear_contact_R_yz = rear_contact_G_2 * rear_contact_R_2
        - rear_contact_R_5 * rear_contact_R;
    work[74] = rear_contact_R_yz;
    const real rear_contact_R_6 = rear_contact_G_3 * rear_contact_R_2;
    work[75] = rear_contact_R_6;
    const real rear_contact_R_zz = rear_contact_G_3 * rear_contact_R;
    work[76] = rear_contact_R_zz;
    const real rear_contact_p_z = rear_radius * rear_contact_G_3;
    const real rear_contact_p_x = rear_contact_x + rear_radius * rear_contact_R_4;
    const real rear_contact_p_y = rear_contact_y - rear_radius * rear_contact_R_5;
    const real rear_contact_drift = rear_contact_u_yaw * rear_contact_sin;
    const real rear_contact_velocity = rear_contact_u_y * rear_contact_R_yy
        - rear_contact_u_x * rear_contact_R_3 - rear_radius * rear_contact_u_lean;
    work[77] = rear_contact_velocity;
    const real rear_contact_drift_2 = rear_contact_u_yaw * rear_contact_G_3;
    const real rear_contact_drift_3 = rear_contact_u_spin * rear_contact_drift_2;
    const real rear_contact_drift_4 = rear_contact_u_lean * rear_contact_u_spin
        - rear_contact_u_lean * rear_contact_drift;
    const real rear_contact_drift_5 = rear_contact_R * rear_contact_drift_3
        + rear_contact_R_2 * rear_contact_drift_4;
    work[78] = rear_contact_drift_5;
    const real rear_contact_drift_6 = 2.0 * rear_contact_u_lean * rear_contact_drift_2 *
        rear_radius;
    const real rear_contact_drift_7 = rear_radius * (rear_contact_u_lean * rear_contact_u_lean
        + rear_contact_drift * rear_contact_drift);
    const real rear_contact_momentum_fx = rear_wheel_base_mass * rear_contact_R_xx;
    const real rear_contact_momentum_fz = rear_wheel_base_mass * rear_contact_R_xz;
    work[79] = rear_contact_momentum_fz;
    const real rear_contact_momentum_fx_2 = rear_wheel_base_mass * rear_contact_R_yx;
    const real rear_contact_momentum_fy = rear_wheel_base_mass * rear_contact_R_yy;
    const real rear_contact_momentum_fz_2 = rear_wheel_base_mass * rear_contact_R_yz;
    work[80] = rear_contact_momentum_fz_2;

    /* shared by several: S, M */
    const real rear_contact_S = rear_radius * rear_contact_sin;
    work[81] = rear_contact_S;
    const real rear_contact_M_2 = rear_contact_R_xx * rear_contact_momentum_fx
        + rear_wheel_base_mass * rear_contact_R_3 * rear_contact_R_3;
    work[82] = rear_contact_M_2;
    const real rear_contact_M_3 = rear_contact_R_xx * rear_contact_momentum_fx_2
        - rear_contact_R_3 * rear_contact_momentum_fy;
    work[83] = rear_contact_M_3;
    const real rear_contact_M_4 = rear_contact_R_yx * rear_contact_momentum_fx_2
        + rear_contact_R_yy * rear_contact_momentum_fy;
    work[84] = rear_contact_M_4;

    /* rear_contact: S, velocity */
    const real rear_contact_S_2 = rear_contact_R * rear_contact_S;
    work[85] = rear_contact_S_2;
    const real rear_contact_S_3 = rear_contact_R_2 * rear_contact_S;
    work[86] = rear_contact_S_3;
    const real rear_contact_velocity_2 = rear_contact_u_x * rear_contact_R_xx
        + rear_contact_u_y * rear_contact_R_yx + rear_contact_u_yaw * rear_contact_S_2;
    work[87] = rear_contact_velocity_2;
    const real rear_contact_velocity_3 = rear_contact_u_x * rear_contact_R_xz
        + rear_contact_u_y * rear_contact_R_yz + rear_contact_u_yaw * rear_contact_S_3;
    work[88] = rear_contact_velocity_3;

    /* front_contact: pose, twist */
    const real rear_hub_u = u[5]; /* rad/s */
    const real steer_u = u[6]; /* rad/s */
    const wreal steer_place_x = w[4];
    const wreal div_1 = w[5];
    const wreal steer_R_zz = w[6];
    const real front_contact_pose = rear_contact_R_xx * rear_hub_cos
        - rear_contact_R_xz * rear_hub_sin;
    work[89] = front_contact_pose;
    const real front_contact_pose_2 = rear_contact_R_xx * rear_hub_sin
        + rear_contact_R_xz * rear_hub_cos;
    work[90] = front_contact_pose_2;
    const real front_contact_pose_3 = rear_contact_R_yx * rear_hub_cos
        - rear_contact_R_yz * rear_hub_sin;
    work[91] = front_contact_pose_3;
    const real front_contact_pose_4 = rear_contact_R_yx * rear_hub_sin
        + rear_contact_R_yz * rear_hub_cos;
    work[92] = front_contact_pose_4;
    const real front_contact_pose_5 = rear_contact_R_6 * rear_hub_cos
        + rear_contact_R_zz * rear_hub_sin;
    work[93] = front_contact_pose_5;
    const real front_contact_pose_6 = rear_contact_R_zz * rear_hub_cos
        - rear_contact_R_6 * rear_hub_sin;
    work[94] = front_contact_pose_6;
    const real front_contact_pose_7 = steer_R_zz * front_contact_pose_2
        - div_1 * front_contact_pose;
    work[95] = front_contact_pose_7;
    const real front_contact_pose_8 = steer_R_zz * front_contact_pose_4
        - div_1 * front_contact_pose_3;
    work[96] = front_contact_pose_8;
    const real front_contact_pose_9 = div_1 * front_contact_pose_5
        + steer_R_zz * front_contact_pose_6;
    work[97] = front_contact_pose_9;
    const real front_contact_pose_10 = steer_place_x * front_contact_pose
        - rear_radius * front_contact_pose_2 + rear_contact_p_x;
    const real front_contact_pose_11 = steer_place_x * front_contact_pose_3
        - rear_radius * front_contact_pose_4 + rear_contact_p_y;
    const real front_contact_pose_12 = rear_contact_p_z - (steer_place_x * front_contact_pose_5
        + rear_radius * front_contact_pose_6);
    const real front_contact_twist = rear_contact_R_xx * rear_contact_R_xx
        + rear_contact_R_3 * rear_contact_R_3;
    const real front_contact_twist_2 = front_contact_twist + rear_contact_R_xz * rear_contact_R_xz;
    const real front_contact_twist_3 = rear_contact_R_xx * rear_contact_R_yx
        - rear_contact_R_3 * rear_contact_R_yy;
    const real front_contact_twist_4 = front_contact_twist_3
        + rear_contact_R_xz * rear_contact_R_yz;
    const real front_contact_twist_5 = rear_contact_R_xz * rear_contact_R_zz
        - (rear_contact_R_xx * rear_contact_R_6 + rear_contact_sin * rear_contact_R_3);
    const real front_contact_twist_6 = rear_contact_R_yx * rear_contact_R_yx
        + rear_contact_R_yy * rear_contact_R_yy;
    const real front_contact_twist_7 = front_contact_twist_6
        + rear_contact_R_yz * rear_contact_R_yz;
    const real front_contact_twist_8 = rear_contact_sin * rear_contact_R_yy
        - rear_contact_R_yx * rear_contact_R_6;
    const real front_contact_twist_9 = front_contact_twist_8
        + rear_contact_R_yz * rear_contact_R_zz;
    const real front_contact_twist_10 = rear_contact_R_6 * rear_contact_R_6
        + rear_contact_sin * rear_contact_sin + rear_contact_R_zz * rear_contact_R_zz;
    const real front_contact_twist_11 = rear_contact_R * rear_contact_R_xx
        + rear_contact_R_2 * rear_contact_R_xz;
    const real front_contact_twist_12 = rear_contact_R * rear_contact_R_yx
        + rear_contact_R_2 * rear_contact_R_yz;
    const real front_contact_twist_13 = rear_contact_R_2 * rear_contact_R_zz
        - rear_contact_R * rear_contact_R_6;
    const real front_contact_twist_14 = rear_contact_R_xx * rear_contact_velocity_2
        - rear_contact_R_3 * rear_contact_velocity;
    const real front_contact_twist_15 = rear_contact_R_yx * rear_contact_velocity_2
        + rear_contact_R_yy * rear_contact_velocity;
    const real front_contact_twist_16 = rear_contact_sin * rear_contact_velocity
        - rear_contact_R_6 * rear_contact_velocity_2;
    const real front_contact_twist_17 = rear_hub_u * rear_contact_R_3;
    work[98] = front_contact_twist_17;
    const real front_contact_twist_18 = rear_hub_u * rear_contact_R_yy;
    work[99] = front_contact_twist_18;
    const real front_contact_twist_19 = rear_hub_u * rear_contact_sin;
    work[100] = front_contact_twist_19;
    const real front_contact_twist_20 = steer_u * front_contact_pose_7;
    work[101] = front_contact_twist_20;
    const real front_contact_twist_21 = steer_u * front_contact_pose_8;
    work[102] = front_contact_twist_21;
    const real front_contact_twist_22 = steer_u * front_contact_pose_9;
    work[103] = front_contact_twist_22;

    /* steer: R */
    const real steer_R_2 = steer_R_zz * steer_sin;
    work[104] = steer_R_2;
    const real steer_R_3 = steer_R_zz * steer_cos;
    work[105] = steer_R_3;
    const real steer_R_4 = div_1 * steer_sin;
    work[106] = steer_R_4;
    const real steer_R_5 = div_1 * steer_cos;
    work[107] = steer_R_5;

    /* front_contact: pose, twist, G */
    const wreal front_radius = w[1]; /* m */
    const wreal front_hub_R_yy = w[7];
    const wreal front_hub_p_x = w[9];
    const wreal front_hub_p_z = w[10];
    const real front_contact_pose_13 = front_contact_pose * steer_R_2
        + rear_contact_R_3 * steer_cos + front_contact_pose_2 * steer_R_4;
    work[108] = front_contact_pose_13;
    const real front_contact_pose_14 = rear_contact_R_yy * steer_cos
        - front_contact_pose_3 * steer_R_2 - front_contact_pose_4 * steer_R_4;
    work[109] = front_contact_pose_14;
    const real front_contact_pose_15 = front_contact_pose_5 * steer_R_2
        + rear_contact_sin * steer_cos - front_contact_pose_6 * steer_R_4;
    work[110] = front_contact_pose_15;
    const real front_contact_pose_16 = front_hub_R_yy * (rear_contact_R_3 * steer_sin
        - front_contact_pose * steer_R_3 - front_contact_pose_2 * steer_R_5);
    work[111] = front_contact_pose_16;
    const real front_contact_pose_17 = front_hub_R_yy * (front_contact_pose_3 * steer_R_3
        + rear_contact_R_yy * steer_sin + front_contact_pose_4 * steer_R_5);
    work[112] = front_contact_pose_17;
    const real front_contact_pose_18 = front_hub_R_yy * (front_contact_pose_5 * steer_R_3
        - rear_contact_sin * steer_sin - front_contact_pose_6 * steer_R_5);
    work[113] = front_contact_pose_18;
    const real front_contact_pose_19 = front_hub_p_z * front_contact_pose_7
        - front_hub_p_x * front_contact_pose_13 + front_contact_pose_10;
    const real front_contact_pose_20 = front_hub_p_x * front_contact_pose_14
        + front_hub_p_z * front_contact_pose_8 + front_contact_pose_11;
    const real front_contact_pose_21 = front_hub_p_x * front_contact_pose_15
        + front_hub_p_z * front_contact_pose_9 + front_contact_pose_12;
    const real front_contact_twist_23 = front_contact_pose_19 - rear_contact_p_x;
    work[114] = front_contact_twist_23;
    const real front_contact_twist_24 = front_contact_pose_20 - rear_contact_p_y;
    work[115] = front_contact_twist_24;
    const real front_contact_twist_25 = front_contact_pose_21 - rear_contact_p_z;
    work[116] = front_contact_twist_25;
    const real front_contact_twist_26 = front_contact_twist_25 * front_contact_twist_9
        - front_contact_twist_24 * front_contact_twist_10;
    const real front_contact_twist_27 = front_contact_twist_23 * front_contact_twist_10
        - front_contact_twist_25 * front_contact_twist_5;
    const real front_contact_twist_28 = front_contact_twist_24 * front_contact_twist_5
        - front_contact_twist_23 * front_contact_twist_9;
    const real front_contact_twist_29 = rear_contact_R_xx * rear_contact_S_2
        + rear_contact_R_xz * rear_contact_S_3 + front_contact_twist_26;
    const real front_contact_twist_30 = rear_contact_R_yx * rear_contact_S_2
        + rear_contact_R_yz * rear_contact_S_3 + front_contact_twist_27;
    const real front_contact_twist_31 = rear_contact_R_zz * rear_contact_S_3
        - rear_contact_R_6 * rear_contact_S_2 + front_contact_twist_28;
    const real front_contact_twist_32 = front_contact_twist_25 * front_contact_twist_12
        - front_contact_twist_24 * front_contact_twist_13;
    const real front_contact_twist_33 = front_contact_twist_23 * front_contact_twist_13
        - front_contact_twist_25 * front_contact_twist_11;
    const real front_contact_twist_34 = rear_radius * rear_contact_R_3 + front_contact_twist_32;
    const real front_contact_twist_35 = front_contact_twist_33 - rear_radius * rear_contact_R_yy;
    const real front_contact_twist_36 = front_contact_twist_24 * front_contact_twist_11
        - front_contact_twist_23 * front_contact_twist_12 - rear_contact_S;
    const real front_contact_twist_37 = rear_contact_R_yy * front_contact_twist_25
        - rear_contact_sin * front_contact_twist_24;
    const real front_contact_twist_38 = rear_contact_sin * front_contact_twist_23
        + rear_contact_R_3 * front_contact_twist_25;
    const real front_contact_twist_39 = rear_contact_R_3 * front_contact_twist_24
        + rear_contact_R_yy * front_contact_twist_23;
    const real front_contact_twist_40 = front_contact_pose_19 - front_contact_pose_10;
    work[117] = front_contact_twist_40;
    const real front_contact_twist_41 = front_contact_pose_20 - front_contact_pose_11;
    work[118] = front_contact_twist_41;
    const real front_contact_twist_42 = front_contact_pose_21 - front_contact_pose_12;
    work[119] = front_contact_twist_42;
    const real front_contact_twist_43 = front_contact_pose_8 * front_contact_twist_42
        - front_contact_pose_9 * front_contact_twist_41;
    const real front_contact_twist_44 = front_contact_pose_9 * front_contact_twist_40
        - front_contact_pose_7 * front_contact_twist_42;
    const real front_contact_twist_45 = front_contact_pose_7 * front_contact_twist_41
        - front_contact_pose_8 * front_contact_twist_40;
    const real front_contact_twist_46 = front_contact_pose_16 * front_contact_twist_2
        - front_contact_pose_17 * front_contact_twist_4;
    const real front_contact_twist_47 = front_contact_twist_46
        + front_contact_pose_18 * front_contact_twist_5;
    const real front_contact_twist_48 = front_contact_pose_16 * front_contact_twist_4
        - front_contact_pose_17 * front_contact_twist_7;
    const real front_contact_twist_49 = front_contact_twist_48
        + front_contact_pose_18 * front_contact_twist_9;
    const real front_contact_twist_50 = front_contact_pose_16 * front_contact_twist_5
        - front_contact_pose_17 * front_contact_twist_9;
    const real front_contact_twist_51 = front_contact_twist_50
        + front_contact_pose_18 * front_contact_twist_10;
    const real front_contact_twist_52 = front_contact_pose_16 * front_contact_twist_29
        - front_contact_pose_17 * front_contact_twist_30;
    const real front_contact_twist_53 = front_contact_twist_52
        + front_contact_pose_18 * front_contact_twist_31;
    work[120] = front_contact_twist_53;
    const real front_contact_twist_54 = front_contact_pose_16 * front_contact_twist_11
        - front_contact_pose_17 * front_contact_twist_12;
    const real front_contact_twist_55 = front_contact_twist_54
        + front_contact_pose_18 * front_contact_twist_13;
    const real front_contact_twist_56 = front_contact_pose_16 * front_contact_twist_34
        - front_contact_pose_17 * front_contact_twist_35;
    const real front_contact_twist_57 = front_contact_twist_56
        + front_contact_pose_18 * front_contact_twist_36;
    work[121] = front_contact_twist_57;
    const real front_contact_twist_58 = rear_contact_R_3 * front_contact_pose_16
        + rear_contact_R_yy * front_contact_pose_17;
    const real front_contact_twist_59 = rear_contact_sin * front_contact_pose_18
        - front_contact_twist_58;
    const real front_contact_twist_60 = front_contact_pose_16 * front_contact_twist_37
        - front_contact_pose_17 * front_contact_twist_38;
    const real front_contact_twist_61 = front_contact_twist_60
        - front_contact_pose_18 * front_contact_twist_39;
    work[122] = front_contact_twist_61;
    const real front_contact_twist_62 = front_contact_pose_7 * front_contact_pose_16
        - front_contact_pose_8 * front_contact_pose_17;
    const real front_contact_twist_63 = front_contact_twist_62
        + front_contact_pose_9 * front_contact_pose_18;
    const real front_contact_twist_64 = front_contact_pose_16 * front_contact_twist_43
        - front_contact_pose_17 * front_contact_twist_44;
    const real front_contact_twist_65 = front_contact_twist_64
        + front_contact_pose_18 * front_contact_twist_45;
    work[123] = front_contact_twist_65;
    const real front_contact_G = front_contact_pose_16 * front_contact_pose_16
        + front_contact_pose_17 * front_contact_pose_17;
    const real front_contact_G_2 = front_contact_pose_18 * front_contact_pose_18;
    const real front_contact_twist_66 = front_contact_G + front_contact_G_2;
    const real front_contact_G_3 = cardan_sqrt(front_contact_G);
    work[124] = front_contact_G_3;
    const real front_contact_G_4 = front_contact_pose_17 / front_contact_G_3;
    work[125] = front_contact_G_4;
    const real front_contact_G_5 = front_contact_pose_16 / front_contact_G_3;
    work[126] = front_contact_G_5;
    const real front_contact_G_6 = front_contact_pose_16 * front_contact_pose_18 /
        front_contact_G_3;
    work[127] = front_contact_G_6;
    const real front_contact_G_7 = front_contact_pose_17 * front_contact_pose_18 /
        front_contact_G_3;
    work[128] = front_contact_G_7;
    const real front_contact_G_8 = (1.0 - front_contact_G_2) / front_contact_G_3;
    work[129] = front_contact_G_8;
    const real front_contact_G_9 = front_radius * front_contact_G_6;
    work[130] = front_contact_G_9;
    const real front_contact_G_10 = front_radius * front_contact_G_7;
    work[131] = front_contact_G_10;
    const real front_contact_G_11 = front_radius * front_contact_G_8;
    work[132] = front_contact_G_11;

    /* front_hub: R */
    const real front_hub_R_2 = front_hub_R_yy * front_hub_cos;
    work[133] = front_hub_R_2;
    const real front_hub_R_3 = front_hub_R_yy * front_hub_sin;
    work[134] = front_hub_R_3;

    /* front_contact: pose, twist, G */
    const real front_contact_pose_22 = front_contact_pose_13 * front_hub_sin
        - front_contact_pose_7 * front_hub_R_2;
    work[135] = front_contact_pose_22;
    const real front_contact_pose_23 = front_contact_pose_13 * front_hub_cos
        + front_contact_pose_7 * front_hub_R_3;
    work[136] = front_contact_pose_23;
    const real front_contact_pose_24 = front_contact_pose_14 * front_hub_sin
        + front_contact_pose_8 * front_hub_R_2;
    work[137] = front_contact_pose_24;
    const real front_contact_pose_25 = front_contact_pose_14 * front_hub_cos
        - front_contact_pose_8 * front_hub_R_3;
    work[138] = front_contact_pose_25;
    const real front_contact_pose_26 = front_contact_pose_15 * front_hub_sin
        + front_contact_pose_9 * front_hub_R_2;
    work[139] = front_contact_pose_26;
    const real front_contact_pose_27 = front_contact_pose_15 * front_hub_cos
        - front_contact_pose_9 * front_hub_R_3;
    work[140] = front_contact_pose_27;
    const real front_contact_twist_67 = front_contact_pose_22 * front_contact_twist_2
        - front_contact_pose_24 * front_contact_twist_4;
    const real front_contact_twist_68 = front_contact_twist_67
        - front_contact_pose_26 * front_contact_twist_5;
    const real front_contact_twist_69 = front_contact_pose_25 * front_contact_twist_4
        - front_contact_pose_23 * front_contact_twist_2;
    const real front_contact_twist_70 = front_contact_twist_69
        + front_contact_pose_27 * front_contact_twist_5;
    const real front_contact_twist_71 = front_contact_pose_22 * front_contact_twist_4
        - front_contact_pose_24 * front_contact_twist_7;
    const real front_contact_twist_72 = front_contact_twist_71
        - front_contact_pose_26 * front_contact_twist_9;
    const real front_contact_twist_73 = front_contact_pose_25 * front_contact_twist_7
        - front_contact_pose_23 * front_contact_twist_4;
    const real front_contact_twist_74 = front_contact_twist_73
        + front_contact_pose_27 * front_contact_twist_9;
    const real front_contact_twist_75 = front_contact_pose_22 * front_contact_twist_5
        - front_contact_pose_24 * front_contact_twist_9;
    const real front_contact_twist_76 = front_contact_twist_75
        - front_contact_pose_26 * front_contact_twist_10;
    work[141] = front_contact_twist_76;
    const real front_contact_twist_77 = front_contact_pose_25 * front_contact_twist_9
        - front_contact_pose_23 * front_contact_twist_5;
    const real front_contact_twist_78 = front_contact_twist_77
        + front_contact_pose_27 * front_contact_twist_10;
    work[142] = front_contact_twist_78;
    const real front_contact_twist_79 = front_contact_pose_22 * front_contact_twist_29
        - front_contact_pose_24 * front_contact_twist_30;
    const real front_contact_twist_80 = front_contact_twist_79
        - front_contact_pose_26 * front_contact_twist_31;
    work[143] = front_contact_twist_80;
    const real front_contact_twist_81 = front_contact_pose_25 * front_contact_twist_30
        - front_contact_pose_23 * front_contact_twist_29;
    const real front_contact_twist_82 = front_contact_twist_81
        + front_contact_pose_27 * front_contact_twist_31;
    work[144] = front_contact_twist_82;
    const real front_contact_twist_83 = front_contact_pose_22 * front_contact_twist_11
        - front_contact_pose_24 * front_contact_twist_12;
    const real front_contact_twist_84 = front_contact_twist_83
        - front_contact_pose_26 * front_contact_twist_13;
    work[145] = front_contact_twist_84;
    const real front_contact_twist_85 = front_contact_pose_25 * front_contact_twist_12
        - front_contact_pose_23 * front_contact_twist_11;
    const real front_contact_twist_86 = front_contact_twist_85
        + front_contact_pose_27 * front_contact_twist_13;
    work[146] = front_contact_twist_86;
    const real front_contact_twist_87 = front_contact_pose_22 * front_contact_twist_34
        - front_contact_pose_24 * front_contact_twist_35;
    const real front_contact_twist_88 = front_contact_twist_87
        - front_contact_pose_26 * front_contact_twist_36;
    work[147] = front_contact_twist_88;
    const real front_contact_twist_89 = front_contact_pose_25 * front_contact_twist_35
        - front_contact_pose_23 * front_contact_twist_34;
    const real front_contact_twist_90 = front_contact_twist_89
        + front_contact_pose_27 * front_contact_twist_36;
    work[148] = front_contact_twist_90;
    const real front_contact_twist_91 = rear_contact_R_3 * front_contact_pose_22
        + rear_contact_R_yy * front_contact_pose_24;
    const real front_contact_twist_92 = front_contact_twist_91
        + rear_contact_sin * front_contact_pose_26;
    work[149] = front_contact_twist_92;
    const real front_contact_twist_93 = rear_contact_R_3 * front_contact_pose_23
        + rear_contact_R_yy * front_contact_pose_25;
    const real front_contact_twist_94 = front_contact_twist_93
        + rear_contact_sin * front_contact_pose_27;
    work[150] = front_contact_twist_94;
    const real front_contact_twist_95 = front_contact_pose_22 * front_contact_twist_37
        - front_contact_pose_24 * front_contact_twist_38;
    const real front_contact_twist_96 = front_contact_twist_95
        + front_contact_pose_26 * front_contact_twist_39;
    work[151] = front_contact_twist_96;
    const real front_contact_twist_97 = front_contact_pose_25 * front_contact_twist_38
        - front_contact_pose_23 * front_contact_twist_37;
    const real front_contact_twist_98 = front_contact_twist_97
        - front_contact_pose_27 * front_contact_twist_39;
    work[152] = front_contact_twist_98;
    const real front_contact_twist_99 = front_contact_pose_7 * front_contact_pose_22
        - front_contact_pose_8 * front_contact_pose_24;
    const real front_contact_twist_100 = front_contact_twist_99
        - front_contact_pose_9 * front_contact_pose_26;
    work[153] = front_contact_twist_100;
    const real front_contact_twist_101 = front_contact_pose_8 * front_contact_pose_25
        - front_contact_pose_7 * front_contact_pose_23;
    const real front_contact_twist_102 = front_contact_twist_101
        + front_contact_pose_9 * front_contact_pose_27;
    work[154] = front_contact_twist_102;
    const real front_contact_twist_103 = front_contact_pose_22 * front_contact_twist_43
        - front_contact_pose_24 * front_contact_twist_44;
    const real front_contact_twist_104 = front_contact_twist_103
        - front_contact_pose_26 * front_contact_twist_45;
    work[155] = front_contact_twist_104;
    const real front_contact_twist_105 = front_contact_pose_25 * front_contact_twist_44
        - front_contact_pose_23 * front_contact_twist_43;
    const real front_contact_twist_106 = front_contact_twist_105
        + front_contact_pose_27 * front_contact_twist_45;
    work[156] = front_contact_twist_106;
    const real front_contact_twist_107 = front_contact_pose_22 * front_contact_pose_16;
    const real front_contact_twist_108 = front_contact_pose_24 * front_contact_pose_17;
    const real front_contact_twist_109 = front_contact_twist_107 + front_contact_twist_108
        - front_contact_pose_26 * front_contact_pose_18;
    work[157] = front_contact_twist_109;
    const real front_contact_twist_110 = front_contact_pose_16 * front_contact_pose_23;
    const real front_contact_twist_111 = front_contact_pose_17 * front_contact_pose_25;
    const real front_contact_twist_112 = front_contact_pose_18 * front_contact_pose_27
        - (front_contact_twist_110 + front_contact_twist_111);
    work[158] = front_contact_twist_112;
    const real front_contact_G_12 = front_contact_pose_18 * front_contact_twist_47
        - front_contact_pose_26 * front_contact_twist_68;
    const real front_contact_G_13 = front_contact_G_12
        + front_contact_pose_27 * front_contact_twist_70;
    work[159] = front_contact_G_13;
    const real front_contact_G_14 = front_contact_pose_18 * front_contact_twist_49
        - front_contact_pose_26 * front_contact_twist_72;
    const real front_contact_G_15 = front_contact_G_14
        + front_contact_pose_27 * front_contact_twist_74;
    work[160] = front_contact_G_15;
    const real front_contact_G_16 = front_contact_pose_22 * front_contact_twist_68
        + front_contact_pose_16 * front_contact_twist_47;
    const real front_contact_G_17 = front_contact_G_16
        - front_contact_pose_23 * front_contact_twist_70;
    const real front_contact_G_18 = front_contact_pose_24 * front_contact_twist_68
        + front_contact_pose_17 * front_contact_twist_47;
    const real front_contact_G_19 = front_contact_pose_25 * front_contact_twist_70
        - front_contact_G_18;
    const real front_contact_G_20 = front_contact_G_4 * front_contact_G_17
        + front_contact_G_5 * front_contact_G_19;
    work[161] = front_contact_G_20;
    const real front_contact_G_21 = front_contact_G_5 * front_contact_G_17
        - front_contact_G_4 * front_contact_G_19;
    work[162] = front_contact_G_21;
    const real front_contact_G_22 = front_contact_pose_22 * front_contact_twist_72
        + front_contact_pose_16 * front_contact_twist_49;
    const real front_contact_G_23 = front_contact_G_22
        - front_contact_pose_23 * front_contact_twist_74;
    const real front_contact_G_24 = front_contact_pose_24 * front_contact_twist_72
        + front_contact_pose_17 * front_contact_twist_49;
    const real front_contact_G_25 = front_contact_pose_25 * front_contact_twist_74
        - front_contact_G_24;
    const real front_contact_G_26 = front_contact_G_4 * front_contact_G_23
        + front_contact_G_5 * front_contact_G_25;
    work[163] = front_contact_G_26;
    const real front_contact_G_27 = front_contact_G_5 * front_contact_G_23
        - front_contact_G_4 * front_contact_G_25;
    work[164] = front_contact_G_27;
    const real front_contact_G_28 = front_contact_pose_22 * front_contact_twist_80
        + front_contact_pose_16 * front_contact_twist_53;
    const real front_contact_G_29 = front_contact_pose_24 * front_contact_twist_80
        + front_contact_pose_17 * front_contact_twist_53;
    const real front_contact_G_30 = front_contact_pose_22 * front_contact_twist_76
        + front_contact_pose_16 * front_contact_twist_51;
    const real front_contact_G_31 = front_contact_pose_24 * front_contact_twist_76
        + front_contact_pose_17 * front_contact_twist_51;
    const real front_contact_G_32 = front_contact_pose_18 * front_contact_twist_51
        - front_contact_pose_26 * front_contact_twist_76;
    const real front_contact_G_33 = front_contact_G_32
        + front_contact_pose_27 * front_contact_twist_78;
    const real front_contact_G_34 = front_contact_G_10 * front_contact_G_33
        - front_contact_G_11 * (front_contact_pose_25 * front_contact_twist_78
        - front_contact_G_31);
    const real front_contact_G_35 = front_contact_G_9 * front_contact_G_33
        + front_contact_G_11 * (front_contact_G_30
        - front_contact_pose_23 * front_contact_twist_78);
    const real front_contact_G_36 = front_contact_G_28
        - front_contact_pose_23 * front_contact_twist_82 + front_contact_G_34;
    const real front_contact_G_37 = front_contact_pose_25 * front_contact_twist_82
        - front_contact_G_29 + front_contact_G_35;
    const real front_contact_G_38 = front_contact_G_4 * front_contact_G_36
        + front_contact_G_5 * front_contact_G_37;
    work[165] = front_contact_G_38;
    const real front_contact_G_39 = front_contact_G_5 * front_contact_G_36
        - front_contact_G_4 * front_contact_G_37;
    work[166] = front_contact_G_39;
    const real front_contact_G_40 = front_contact_pose_22 * front_contact_twist_88
        + front_contact_pose_16 * front_contact_twist_57;
    const real front_contact_G_41 = front_contact_pose_24 * front_contact_twist_88
        + front_contact_pose_17 * front_contact_twist_57;
    const real front_contact_G_42 = front_contact_pose_22 * front_contact_twist_84
        + front_contact_pose_16 * front_contact_twist_55;
    const real front_contact_G_43 = front_contact_pose_24 * front_contact_twist_84
        + front_contact_pose_17 * front_contact_twist_55;
    const real front_contact_G_44 = front_contact_pose_18 * front_contact_twist_55
        - front_contact_pose_26 * front_contact_twist_84;
    const real front_contact_G_45 = front_contact_G_44
        + front_contact_pose_27 * front_contact_twist_86;
    const real front_contact_G_46 = front_contact_G_10 * front_contact_G_45
        - front_contact_G_11 * (front_contact_pose_25 * front_contact_twist_86
        - front_contact_G_43);
    const real front_contact_G_47 = front_contact_G_9 * front_contact_G_45
        + front_contact_G_11 * (front_contact_G_42
        - front_contact_pose_23 * front_contact_twist_86);
    const real front_contact_G_48 = front_contact_G_40
        - front_contact_pose_23 * front_contact_twist_90 + front_contact_G_46;
    const real front_contact_G_49 = front_contact_pose_25 * front_contact_twist_90
        - front_contact_G_41 + front_contact_G_47;
    const real front_contact_G_50 = front_contact_G_4 * front_contact_G_48
        + front_contact_G_5 * front_contact_G_49;
    work[167] = front_contact_G_50;
    const real front_contact_G_51 = front_contact_G_5 * front_contact_G_48
        - front_contact_G_4 * front_contact_G_49;
    work[168] = front_contact_G_51;
    const real front_contact_G_52 = front_contact_pose_22 * front_contact_twist_96
        + front_contact_pose_16 * front_contact_twist_61;
    const real front_contact_G_53 = front_contact_pose_24 * front_contact_twist_96
        + front_contact_pose_17 * front_contact_twist_61;
    const real front_contact_G_54 = front_contact_pose_16 * front_contact_twist_59
        - front_contact_pose_22 * front_contact_twist_92;
    const real front_contact_G_55 = front_contact_pose_24 * front_contact_twist_92
        - front_contact_pose_17 * front_contact_twist_59;
    const real front_contact_G_56 = front_contact_pose_26 * front_contact_twist_92
        + front_contact_pose_18 * front_contact_twist_59;
    const real front_contact_G_57 = front_contact_G_56
        + front_contact_pose_27 * front_contact_twist_94;
    const real front_contact_G_58 = front_contact_G_10 * front_contact_G_57
        - front_contact_G_11 * (front_contact_G_55
        + front_contact_pose_25 * front_contact_twist_94);
    const real front_contact_G_59 = front_contact_G_9 * front_contact_G_57
        + front_contact_G_11 * (front_contact_G_54
        - front_contact_pose_23 * front_contact_twist_94);
    const real front_contact_G_60 = front_contact_G_52
        - front_contact_pose_23 * front_contact_twist_98 + front_contact_G_58;
    const real front_contact_G_61 = front_contact_pose_25 * front_contact_twist_98
        - front_contact_G_53 + front_contact_G_59;
    const real front_contact_G_62 = front_contact_G_4 * front_contact_G_60
        + front_contact_G_5 * front_contact_G_61;
    work[169] = front_contact_G_62;
    const real front_contact_G_63 = front_contact_G_5 * front_contact_G_60
        - front_contact_G_4 * front_contact_G_61;
    work[170] = front_contact_G_63;
    const real front_contact_G_64 = front_contact_pose_22 * front_contact_twist_104
        + front_contact_pose_16 * front_contact_twist_65;
    const real front_contact_G_65 = front_contact_pose_24 * front_contact_twist_104
        + front_contact_pose_17 * front_contact_twist_65;
    const real front_contact_G_66 = front_contact_pose_22 * front_contact_twist_100
        + front_contact_pose_16 * front_contact_twist_63;
    const real front_contact_G_67 = front_contact_pose_24 * front_contact_twist_100
        + front_contact_pose_17 * front_contact_twist_63;
    const real front_contact_G_68 = front_contact_pose_18 * front_contact_twist_63
        - front_contact_pose_26 * front_contact_twist_100;
    const real front_contact_G_69 = front_contact_G_68
        + front_contact_pose_27 * front_contact_twist_102;
    const real front_contact_G_70 = front_contact_G_10 * front_contact_G_69
        - front_contact_G_11 * (front_contact_pose_25 * front_contact_twist_102
        - front_contact_G_67);
    const real front_contact_G_71 = front_contact_G_9 * front_contact_G_69
        + front_contact_G_11 * (front_contact_G_66
        - front_contact_pose_23 * front_contact_twist_102);
    const real front_contact_G_72 = front_contact_G_64
        - front_contact_pose_23 * front_contact_twist_106 + front_contact_G_70;
    const real front_contact_G_73 = front_contact_pose_25 * front_contact_twist_106
        - front_contact_G_65 + front_contact_G_71;
    const real front_contact_G_74 = front_contact_G_4 * front_contact_G_72
        + front_contact_G_5 * front_contact_G_73;
    work[171] = front_contact_G_74;
    const real front_contact_G_75 = front_contact_G_5 * front_contact_G_72
        - front_contact_G_4 * front_contact_G_73;
    work[172] = front_contact_G_75;
    const real front_contact_G_76 = front_contact_pose_22 * front_contact_twist_109
        + front_contact_pose_16 * front_contact_twist_66;
    const real front_contact_G_77 = front_contact_pose_24 * front_contact_twist_109
        + front_contact_pose_17 * front_contact_twist_66;
    const real front_contact_G_78 = front_contact_pose_18 * front_contact_twist_66
        - front_contact_pose_26 * front_contact_twist_109;
    const real front_contact_G_79 = front_contact_G_78
        + front_contact_pose_27 * front_contact_twist_112;
    const real front_contact_G_80 = front_contact_G_10 * front_contact_G_79
        - front_contact_G_11 * (front_contact_pose_25 * front_contact_twist_112
        - front_contact_G_77);
    const real front_contact_G_81 = front_contact_G_9 * front_contact_G_79
        + front_contact_G_11 * (front_contact_G_76
        - front_contact_pose_23 * front_contact_twist_112);
    const real front_contact_G_82 = front_contact_G_4 * front_contact_G_80
        + front_contact_G_5 * front_contact_G_81;
    work[173] = front_contact_G_82;
    const real front_contact_G_83 = front_contact_G_5 * front_contact_G_80
        - front_contact_G_4 * front_contact_G_81;
    work[174] = front_contact_G_83;

    /* rear_wheel: omega, alpha, a, U, inertia force */
    const wreal gravity_z = w[2]; /* m/s^2 */
    const wreal rear_wheel_base_second_moment_xx = w[24];
    const wreal rear_wheel_base_second_moment_zz = w[25];
    const wreal rear_wheel_base_second_moment_yy = w[33];
    const real rear_wheel_omega_x = rear_contact_u_lean * rear_contact_R
        - rear_contact_u_yaw * rear_contact_R_6;
    work[175] = rear_wheel_omega_x;
    const real rear_wheel_omega_y = rear_contact_u_spin + rear_contact_drift;
    work[176] = rear_wheel_omega_y;
    const real rear_wheel_omega_z = rear_contact_u_yaw * rear_contact_R_zz
        + rear_contact_u_lean * rear_contact_R_2;
    work[177] = rear_wheel_omega_z;
    const real rear_wheel_alpha_y = rear_contact_u_lean * rear_contact_drift_2;
    work[178] = rear_wheel_alpha_y;
    const real rear_wheel_alpha_z = rear_contact_R * rear_contact_drift_4
        - rear_contact_R_2 * rear_contact_drift_3;
    work[179] = rear_wheel_alpha_z;
    const real rear_wheel_a_x = rear_contact_R * rear_contact_drift_6
        + rear_contact_R_2 * rear_contact_drift_7 + gravity_z * rear_contact_R_6;
    work[180] = rear_wheel_a_x;
    const real rear_wheel_a_y = rear_contact_drift * rear_contact_drift_2 * rear_radius
        - gravity_z * rear_contact_sin;
    work[181] = rear_wheel_a_y;
    const real rear_wheel_a_z = rear_contact_R_2 * rear_contact_drift_6
        - rear_contact_R * rear_contact_drift_7 - gravity_z * rear_contact_R_zz;
    work[182] = rear_wheel_a_z;
    const real rear_wheel_U = rear_wheel_omega_x * rear_wheel_omega_y;
    const real rear_wheel_U_2 = rear_wheel_omega_x * rear_wheel_omega_z;
    const real rear_wheel_U_3 = rear_wheel_omega_y * rear_wheel_omega_z;
    const real rear_wheel_U_xy = rear_wheel_U - rear_wheel_alpha_z;
    const real rear_wheel_U_xz = rear_wheel_alpha_y + rear_wheel_U_2;
    work[183] = rear_wheel_U_xz;
    const real rear_wheel_U_yx = rear_wheel_alpha_z + rear_wheel_U;
    const real rear_wheel_U_yz = rear_contact_drift_5 + rear_wheel_U_3;
    const real rear_wheel_U_zx = rear_wheel_U_2 - rear_wheel_alpha_y;
    work[184] = rear_wheel_U_zx;
    const real rear_wheel_U_zy = rear_wheel_U_3 - rear_contact_drift_5;
    const real rear_wheel_inertia_force = rear_wheel_base_second_moment_yy * rear_wheel_U_zy
        - rear_wheel_base_second_moment_zz * rear_wheel_U_yz;
    work[185] = rear_wheel_inertia_force;
    const real rear_wheel_inertia_force_2 = rear_wheel_base_second_moment_xx * rear_wheel_U_yx
        - rear_wheel_base_second_moment_yy * rear_wheel_U_xy;
    work[186] = rear_wheel_inertia_force_2;

    /* front_contact: twist, rate */
    const real front_hub_u = u[7]; /* rad/s */
    const real front_contact_twist_113 = rear_contact_R_xx * rear_wheel_omega_x
        - rear_contact_R_3 * rear_wheel_omega_y;
    const real front_contact_twist_114 = front_contact_twist_113
        + rear_contact_R_xz * rear_wheel_omega_z;
    work[187] = front_contact_twist_114;
    const real front_contact_twist_115 = rear_contact_R_yx * rear_wheel_omega_x
        + rear_contact_R_yy * rear_wheel_omega_y;
    const real front_contact_twist_116 = front_contact_twist_115
        + rear_contact_R_yz * rear_wheel_omega_z;
    work[188] = front_contact_twist_116;
    const real front_contact_twist_117 = rear_contact_sin * rear_wheel_omega_y
        - rear_contact_R_6 * rear_wheel_omega_x;
    const real front_contact_twist_118 = front_contact_twist_117
        + rear_contact_R_zz * rear_wheel_omega_z;
    work[189] = front_contact_twist_118;
    const real front_contact_twist_119 = front_contact_twist_25 * front_contact_twist_116
        - front_contact_twist_24 * front_contact_twist_118;
    const real front_contact_twist_120 = front_contact_twist_23 * front_contact_twist_118
        - front_contact_twist_25 * front_contact_twist_114;
    const real front_contact_twist_121 = front_contact_twist_24 * front_contact_twist_114
        - front_contact_twist_23 * front_contact_twist_116;
    const real front_contact_twist_122 = front_contact_twist_14
        + rear_contact_R_xz * rear_contact_velocity_3 + front_contact_twist_119;
    const real front_contact_twist_123 = front_contact_twist_15
        + rear_contact_R_yz * rear_contact_velocity_3 + front_contact_twist_120;
    const real front_contact_twist_124 = front_contact_twist_16
        + rear_contact_R_zz * rear_contact_velocity_3 + front_contact_twist_121;
    const real front_contact_twist_125 = front_contact_twist_25 * front_contact_twist_18
        - front_contact_twist_24 * front_contact_twist_19 + front_contact_twist_122;
    const real front_contact_twist_126 = front_contact_twist_23 * front_contact_twist_19
        + front_contact_twist_25 * front_contact_twist_17 + front_contact_twist_123;
    const real front_contact_twist_127 = front_contact_twist_124
        - (front_contact_twist_24 * front_contact_twist_17
        + front_contact_twist_23 * front_contact_twist_18);
    const real front_contact_twist_128 = front_contact_twist_42 * front_contact_twist_21
        - front_contact_twist_41 * front_contact_twist_22 + front_contact_twist_125;
    work[190] = front_contact_twist_128;
    const real front_contact_twist_129 = front_contact_twist_40 * front_contact_twist_22
        - front_contact_twist_42 * front_contact_twist_20 + front_contact_twist_126;
    work[191] = front_contact_twist_129;
    const real front_contact_twist_130 = front_contact_twist_41 * front_contact_twist_20
        - front_contact_twist_40 * front_contact_twist_21 + front_contact_twist_127;
    work[192] = front_contact_twist_130;
    const real front_contact_twist_131 = front_contact_twist_114 - front_contact_twist_17
        + front_contact_twist_20 + front_hub_u * front_contact_pose_16;
    work[193] = front_contact_twist_131;
    const real front_contact_twist_132 = front_contact_twist_116 + front_contact_twist_18
        + front_contact_twist_21 - front_hub_u * front_contact_pose_17;
    work[194] = front_contact_twist_132;
    const real front_contact_twist_133 = front_contact_twist_118 + front_contact_twist_19
        + front_contact_twist_22 + front_hub_u * front_contact_pose_18;
    work[195] = front_contact_twist_133;
    const real front_contact_twist_134 = front_contact_pose_22 * front_contact_twist_131
        - front_contact_pose_24 * front_contact_twist_132;
    const real front_contact_twist_135 = front_contact_twist_134
        - front_contact_pose_26 * front_contact_twist_133;
    work[196] = front_contact_twist_135;
    const real front_contact_twist_136 = front_contact_pose_16 * front_contact_twist_131
        - front_contact_pose_17 * front_contact_twist_132;
    const real front_contact_twist_137 = front_contact_twist_136
        + front_contact_pose_18 * front_contact_twist_133;
    work[197] = front_contact_twist_137;
    const real front_contact_twist_138 = front_contact_pose_25 * front_contact_twist_132
        - front_contact_pose_23 * front_contact_twist_131;
    const real front_contact_twist_139 = front_contact_twist_138
        + front_contact_pose_27 * front_contact_twist_133;
    work[198] = front_contact_twist_139;
    const real front_contact_twist_140 = front_contact_pose_22 * front_contact_twist_128
        - front_contact_pose_24 * front_contact_twist_129;
    const real front_contact_twist_141 = front_contact_twist_140
        - front_contact_pose_26 * front_contact_twist_130;
    work[199] = front_contact_twist_141;
    const real front_contact_twist_142 = front_contact_pose_16 * front_contact_twist_128
        - front_contact_pose_17 * front_contact_twist_129;
    const real front_contact_twist_143 = front_contact_twist_142
        + front_contact_pose_18 * front_contact_twist_130;
    work[200] = front_contact_twist_143;
    const real front_contact_twist_144 = front_contact_pose_25 * front_contact_twist_129
        - front_contact_pose_23 * front_contact_twist_128;
    const real front_contact_twist_145 = front_contact_twist_144
        + front_contact_pose_27 * front_contact_twist_130;
    work[201] = front_contact_twist_145;
    const real front_contact_rate = front_contact_pose_22 * front_contact_twist_141
        + front_contact_pose_16 * front_contact_twist_143;
    const real front_contact_rate_2 = front_contact_pose_24 * front_contact_twist_141
        + front_contact_pose_17 * front_contact_twist_143;
    const real front_contact_rate_3 = front_contact_pose_22 * front_contact_twist_135
        + front_contact_pose_16 * front_contact_twist_137;
    const real front_contact_rate_4 = front_contact_rate_3
        - front_contact_pose_23 * front_contact_twist_139;
    work[202] = front_contact_rate_4;
    const real front_contact_rate_5 = front_contact_pose_24 * front_contact_twist_135
        + front_contact_pose_17 * front_contact_twist_137;
    const real front_contact_rate_6 = front_contact_pose_25 * front_contact_twist_139
        - front_contact_rate_5;
    work[203] = front_contact_rate_6;
    const real front_contact_rate_7 = front_contact_pose_18 * front_contact_twist_137
        - front_contact_pose_26 * front_contact_twist_135;
    const real front_contact_rate_8 = front_contact_rate_7
        + front_contact_pose_27 * front_contact_twist_139;
    work[204] = front_contact_rate_8;
    const real front_contact_rate_9 = front_contact_G_10 * front_contact_rate_8
        - front_contact_G_11 * front_contact_rate_6;
    const real front_contact_rate_10 = front_contact_G_9 * front_contact_rate_8
        + front_contact_G_11 * front_contact_rate_4;
    const real front_contact_rate_11 = front_contact_rate
        - front_contact_pose_23 * front_contact_twist_145 + front_contact_rate_9;
    work[205] = front_contact_rate_11;
    const real front_contact_rate_12 = front_contact_pose_25 * front_contact_twist_145
        - front_contact_rate_2 + front_contact_rate_10;
    work[206] = front_contact_rate_12;

    /* common */
    const real add_1 = front_contact_twist_110 + front_contact_twist_110
        + (front_contact_twist_111 + front_contact_twist_111);
    work[207] = add_1;
    const real add_1_2 = front_contact_twist_107 + front_contact_twist_107
        + (front_contact_twist_108 + front_contact_twist_108);
    work[208] = add_1_2;
    return CARDAN_OK;
}

CARDAN_PART int forward_dynamics_part2(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const u = in->u;
    const wreal *const w = in->w;
    (void)out;

    /* constraints: multipliers */
    const real rear_contact_u_x = u[0]; /* m/s */
    const real rear_contact_u_y = u[1]; /* m/s */
    const real rear_contact_u_yaw = u[2]; /* rad/s */
    const real rear_contact_u_lean = u[3]; /* rad/s */
    const real rear_contact_u_spin = u[4]; /* rad/s */
    const real rear_hub_u = u[5]; /* rad/s */
    const real steer_u = u[6]; /* rad/s */
    const real front_hub_u = u[7]; /* rad/s */
    const wreal rear_radius = w[0]; /* m */
    const wreal front_radius = w[1]; /* m */
    const wreal steer_place_x = w[4];
    const wreal div_1 = w[5];
    const wreal steer_R_zz = w[6];
    const wreal front_hub_R_yy = w[7];
    const wreal front_hub_p_x = w[9];
    const wreal front_hub_p_z = w[10];
    const real front_contact_G_3 = work[124];
    const real constraints_multipliers = 0.5 / front_contact_G_3;
    const real constraints_multipliers_2 = cardan_select(front_contact_G_3,
        constraints_multipliers, 0.0);
    const real rear_contact_G_2 = work[56];
    const real constraints_multipliers_3 = rear_contact_u_yaw * rear_contact_G_2;
    work[209] = constraints_multipliers_3;
    const real rear_contact_G = work[55];
    const real constraints_multipliers_4 = rear_contact_u_yaw * rear_contact_G;
    work[210] = constraints_multipliers_4;
    const real rear_contact_sin = work[58];
    const real constraints_multipliers_5 = rear_contact_u_lean * rear_contact_sin;
    const real rear_contact_G_3 = work[57];
    const real constraints_multipliers_6 = rear_contact_u_lean * rear_contact_G_3;
    const real constraints_multipliers_7 = rear_contact_G_3 * constraints_multipliers_4
        - rear_contact_G_2 * constraints_multipliers_5;
    const real constraints_multipliers_8 = rear_contact_sin * constraints_multipliers_4
        + rear_contact_G_2 * constraints_multipliers_6;
    const real constraints_multipliers_9 = rear_contact_G_3 * constraints_multipliers_3
        + rear_contact_G * constraints_multipliers_5;
    const real constraints_multipliers_10 = rear_contact_G * constraints_multipliers_6
        - rear_contact_sin * constraints_multipliers_3;
    const real rear_contact_R_2 = work[60];
    const real constraints_multipliers_11 = rear_contact_u_spin * rear_contact_R_2;
    const real rear_contact_R = work[59];
    const real constraints_multipliers_12 = rear_contact_u_spin * rear_contact_R;
    const real constraints_multipliers_13 = rear_contact_R * constraints_multipliers_3
        + rear_contact_G * constraints_multipliers_11;
    const real rear_contact_R_4 = work[68];
    const real constraints_multipliers_14 = rear_contact_R_2 * constraints_multipliers_8
        + rear_contact_R_4 * constraints_multipliers_12 + constraints_multipliers_13;
    const real constraints_multipliers_15 = rear_contact_G * constraints_multipliers_12
        - rear_contact_R_2 * constraints_multipliers_3;
    const real constraints_multipliers_16 = rear_contact_R * constraints_multipliers_8
        - rear_contact_R_4 * constraints_multipliers_11 + constraints_multipliers_15;
    const real constraints_multipliers_17 = rear_contact_R * constraints_multipliers_4
        - rear_contact_G_2 * constraints_multipliers_11;
    const real rear_contact_R_5 = work[70];
    const real constraints_multipliers_18 = rear_contact_R_2 * constraints_multipliers_10
        + rear_contact_R_5 * constraints_multipliers_12 + constraints_multipliers_17;
    const real constraints_multipliers_19 = rear_contact_R_2 * constraints_multipliers_4
        + rear_contact_G_2 * constraints_multipliers_12;
    const real constraints_multipliers_20 = constraints_multipliers_19
        - (rear_contact_R * constraints_multipliers_10
        - rear_contact_R_5 * constraints_multipliers_11);
    const real constraints_multipliers_21 = rear_contact_G_3 * constraints_multipliers_12
        - rear_contact_R_2 * constraints_multipliers_5;
    const real constraints_multipliers_22 = rear_contact_R * constraints_multipliers_5
        + rear_contact_G_3 * constraints_multipliers_11;
    const real constraints_multipliers_23 = rear_radius * constraints_multipliers_5;
    const real constraints_multipliers_24 = rear_contact_u_x
        + rear_radius * constraints_multipliers_8;
    const real constraints_multipliers_25 = rear_contact_u_y
        - rear_radius * constraints_multipliers_10;
    const real constraints_multipliers_26 = rear_radius * constraints_multipliers_6;
    const real rear_hub_sin = work[62];
    const real constraints_multipliers_27 = rear_hub_u * rear_hub_sin;
    const real rear_hub_cos = work[61];
    const real constraints_multipliers_28 = rear_hub_u * rear_hub_cos;
    const real rear_contact_R_xx = work[71];
    const real constraints_multipliers_29 = rear_hub_cos * constraints_multipliers_14
        + rear_contact_R_xx * constraints_multipliers_27;
    const real rear_contact_R_xz = work[72];
    const real constraints_multipliers_30 = rear_hub_sin * constraints_multipliers_16
        + rear_contact_R_xz * constraints_multipliers_28;
    const real constraints_multipliers_31 = constraints_multipliers_29 + constraints_multipliers_30;
    const real constraints_multipliers_32 = rear_contact_R_xx * constraints_multipliers_28
        - rear_hub_sin * constraints_multipliers_14;
    const real constraints_multipliers_33 = rear_hub_cos * constraints_multipliers_16
        - rear_contact_R_xz * constraints_multipliers_27;
    const real constraints_multipliers_34 = constraints_multipliers_32 + constraints_multipliers_33;
    const real rear_contact_R_yx = work[73];
    const real constraints_multipliers_35 = rear_hub_cos * constraints_multipliers_18
        - rear_contact_R_yx * constraints_multipliers_27;
    const real rear_contact_R_yz = work[74];
    const real constraints_multipliers_36 = rear_hub_sin * constraints_multipliers_20
        + rear_contact_R_yz * constraints_multipliers_28;
    const real constraints_multipliers_37 = constraints_multipliers_35 - constraints_multipliers_36;
    const real constraints_multipliers_38 = rear_hub_sin * constraints_multipliers_18
        + rear_contact_R_yx * constraints_multipliers_28;
    const real constraints_multipliers_39 = rear_hub_cos * constraints_multipliers_20
        - rear_contact_R_yz * constraints_multipliers_27;
    const real constraints_multipliers_40 = constraints_multipliers_38 + constraints_multipliers_39;
    const real rear_contact_R_zz = work[76];
    const real constraints_multipliers_41 = rear_contact_R_zz * constraints_multipliers_28
        - rear_hub_sin * constraints_multipliers_22;
    const real rear_contact_R_6 = work[75];
    const real constraints_multipliers_42 = rear_hub_cos * constraints_multipliers_21
        - rear_contact_R_6 * constraints_multipliers_27 + constraints_multipliers_41;
    const real constraints_multipliers_43 = rear_hub_cos * constraints_multipliers_22
        + rear_contact_R_zz * constraints_multipliers_27;
    const real constraints_multipliers_44 = rear_hub_sin * constraints_multipliers_21
        + rear_contact_R_6 * constraints_multipliers_28 + constraints_multipliers_43;
    const real steer_sin = work[64];
    const real constraints_multipliers_45 = steer_u * steer_sin;
    const real steer_cos = work[63];
    const real constraints_multipliers_46 = steer_u * steer_cos;
    const real constraints_multipliers_47 = steer_R_zz * constraints_multipliers_46;
    const real constraints_multipliers_48 = steer_R_zz * constraints_multipliers_45;
    const real constraints_multipliers_49 = div_1 * constraints_multipliers_46;
    const real constraints_multipliers_50 = div_1 * constraints_multipliers_45;
    const real front_contact_pose = work[89];
    const real steer_R_2 = work[104];
    const real constraints_multipliers_51 = front_contact_pose * constraints_multipliers_47
        - steer_R_2 * constraints_multipliers_31;
    const real rear_contact_R_3 = work[67];
    const real constraints_multipliers_52 = steer_cos * constraints_multipliers_7
        - rear_contact_R_3 * constraints_multipliers_45 + constraints_multipliers_51;
    const real steer_R_4 = work[106];
    const real front_contact_pose_2 = work[90];
    const real constraints_multipliers_53 = steer_R_4 * constraints_multipliers_34
        + front_contact_pose_2 * constraints_multipliers_49 + constraints_multipliers_52;
    const real steer_R_3 = work[105];
    const real constraints_multipliers_54 = steer_R_3 * constraints_multipliers_31
        + front_contact_pose * constraints_multipliers_48;
    const real constraints_multipliers_55 = steer_sin * constraints_multipliers_7
        + rear_contact_R_3 * constraints_multipliers_46 + constraints_multipliers_54;
    const real steer_R_5 = work[107];
    const real constraints_multipliers_56 = constraints_multipliers_55
        - (steer_R_5 * constraints_multipliers_34
        - front_contact_pose_2 * constraints_multipliers_50);
    const real constraints_multipliers_57 = div_1 * constraints_multipliers_31
        + steer_R_zz * constraints_multipliers_34;
    const real rear_contact_R_yy = work[69];
    const real constraints_multipliers_58 = steer_cos * constraints_multipliers_9
        + rear_contact_R_yy * constraints_multipliers_45;
    const real front_contact_pose_3 = work[91];
    const real constraints_multipliers_59 = steer_R_2 * constraints_multipliers_37
        + front_contact_pose_3 * constraints_multipliers_47 + constraints_multipliers_58;
    const real front_contact_pose_4 = work[92];
    const real constraints_multipliers_60 = steer_R_4 * constraints_multipliers_40
        + front_contact_pose_4 * constraints_multipliers_49 + constraints_multipliers_59;
    const real constraints_multipliers_61 = rear_contact_R_yy * constraints_multipliers_46
        - steer_sin * constraints_multipliers_9;
    const real constraints_multipliers_62 = steer_R_3 * constraints_multipliers_37
        - front_contact_pose_3 * constraints_multipliers_48 + constraints_multipliers_61;
    const real constraints_multipliers_63 = steer_R_5 * constraints_multipliers_40
        - front_contact_pose_4 * constraints_multipliers_50 + constraints_multipliers_62;
    const real constraints_multipliers_64 = steer_R_zz * constraints_multipliers_40
        - div_1 * constraints_multipliers_37;
    const real front_contact_pose_5 = work[93];
    const real constraints_multipliers_65 = steer_R_2 * constraints_multipliers_42
        + front_contact_pose_5 * constraints_multipliers_47;
    const real constraints_multipliers_66 = steer_cos * constraints_multipliers_6
        - rear_contact_sin * constraints_multipliers_45 + constraints_multipliers_65;
    const real front_contact_pose_6 = work[94];
    const real constraints_multipliers_67 = constraints_multipliers_66
        - (front_contact_pose_6 * constraints_multipliers_49
        - steer_R_4 * constraints_multipliers_44);
    const real constraints_multipliers_68 = steer_R_3 * constraints_multipliers_42
        - front_contact_pose_5 * constraints_multipliers_48;
    const real constraints_multipliers_69 = constraints_multipliers_68
        - (steer_sin * constraints_multipliers_6 + rear_contact_sin * constraints_multipliers_46);
    const real constraints_multipliers_70 = steer_R_5 * constraints_multipliers_44
        + front_contact_pose_6 * constraints_multipliers_50 + constraints_multipliers_69;
    const real constraints_multipliers_71 = div_1 * constraints_multipliers_42
        - steer_R_zz * constraints_multipliers_44;
    const real constraints_multipliers_72 = constraints_multipliers_24
        - (steer_place_x * constraints_multipliers_31 + rear_radius * constraints_multipliers_34);
    const real constraints_multipliers_73 = steer_place_x * constraints_multipliers_37
        - rear_radius * constraints_multipliers_40 + constraints_multipliers_25;
    const real constraints_multipliers_74 = steer_place_x * constraints_multipliers_42
        - rear_radius * constraints_multipliers_44 + constraints_multipliers_23;
    const real front_hub_sin = work[66];
    const real constraints_multipliers_75 = front_hub_u * front_hub_sin;
    const real front_hub_cos = work[65];
    const real constraints_multipliers_76 = front_hub_u * front_hub_cos;
    const real constraints_multipliers_77 = front_hub_R_yy * constraints_multipliers_75;
    const real constraints_multipliers_78 = front_hub_R_yy * constraints_multipliers_76;
    const real front_contact_pose_13 = work[108];
    const real constraints_multipliers_79 = front_hub_sin * constraints_multipliers_53
        + front_contact_pose_13 * constraints_multipliers_76;
    const real front_hub_R_2 = work[133];
    const real front_contact_pose_7 = work[95];
    const real constraints_multipliers_80 = front_hub_R_2 * constraints_multipliers_57
        - front_contact_pose_7 * constraints_multipliers_77;
    const real constraints_multipliers_81 = constraints_multipliers_79 - constraints_multipliers_80;
    const real constraints_multipliers_82 = front_hub_R_yy * constraints_multipliers_56;
    const real constraints_multipliers_83 = front_hub_cos * constraints_multipliers_53
        - front_contact_pose_13 * constraints_multipliers_75;
    const real front_hub_R_3 = work[134];
    const real constraints_multipliers_84 = front_hub_R_3 * constraints_multipliers_57
        + front_contact_pose_7 * constraints_multipliers_78;
    const real constraints_multipliers_85 = constraints_multipliers_83 + constraints_multipliers_84;
    const real front_contact_pose_14 = work[109];
    const real constraints_multipliers_86 = front_contact_pose_14 * constraints_multipliers_76
        - front_hub_sin * constraints_multipliers_60;
    const real front_contact_pose_8 = work[96];
    const real constraints_multipliers_87 = front_hub_R_2 * constraints_multipliers_64
        - front_contact_pose_8 * constraints_multipliers_77;
    const real constraints_multipliers_88 = constraints_multipliers_86 + constraints_multipliers_87;
    const real constraints_multipliers_89 = front_hub_R_yy * constraints_multipliers_63;
    const real constraints_multipliers_90 = front_hub_cos * constraints_multipliers_60
        + front_contact_pose_14 * constraints_multipliers_75;
    const real constraints_multipliers_91 = front_hub_R_3 * constraints_multipliers_64
        + front_contact_pose_8 * constraints_multipliers_78;
    const real constraints_multipliers_92 = constraints_multipliers_90 + constraints_multipliers_91;
    const real front_contact_pose_15 = work[110];
    const real constraints_multipliers_93 = front_hub_sin * constraints_multipliers_67
        + front_contact_pose_15 * constraints_multipliers_76;
    const real front_contact_pose_9 = work[97];
    const real constraints_multipliers_94 = front_hub_R_2 * constraints_multipliers_71
        - front_contact_pose_9 * constraints_multipliers_77;
    const real constraints_multipliers_95 = constraints_multipliers_93 + constraints_multipliers_94;
    const real constraints_multipliers_96 = front_hub_R_yy * constraints_multipliers_70;
    const real constraints_multipliers_97 = front_hub_cos * constraints_multipliers_67
        - front_contact_pose_15 * constraints_multipliers_75;
    const real constraints_multipliers_98 = front_hub_R_3 * constraints_multipliers_71
        + front_contact_pose_9 * constraints_multipliers_78;
    const real constraints_multipliers_99 = constraints_multipliers_97 - constraints_multipliers_98;
    const real constraints_multipliers_100 = front_hub_p_z * constraints_multipliers_57
        - front_hub_p_x * constraints_multipliers_53 + constraints_multipliers_72;
    const real constraints_multipliers_101 = front_hub_p_z * constraints_multipliers_64
        - front_hub_p_x * constraints_multipliers_60 + constraints_multipliers_73;
    const real constraints_multipliers_102 = front_hub_p_x * constraints_multipliers_67
        + front_hub_p_z * constraints_multipliers_71 - constraints_multipliers_74;
    const real constraints_multipliers_103 = constraints_multipliers_100
        - constraints_multipliers_24;
    const real constraints_multipliers_104 = constraints_multipliers_101
        - constraints_multipliers_25;
    const real constraints_multipliers_105 = constraints_multipliers_23
        + constraints_multipliers_102;
    const real constraints_multipliers_106 = rear_contact_u_yaw * constraints_multipliers_21
        + rear_contact_u_lean * constraints_multipliers_11;
    const real constraints_multipliers_107 = rear_contact_u_yaw * constraints_multipliers_6;
    const real constraints_multipliers_108 = rear_contact_u_lean * constraints_multipliers_12
        - rear_contact_u_yaw * constraints_multipliers_22;
    const real rear_contact_S = work[81];
    const real constraints_multipliers_109 = rear_contact_u_yaw * (rear_contact_R *
        constraints_multipliers_26 - rear_contact_S * constraints_multipliers_11);
    const real constraints_multipliers_110 = rear_contact_u_y * constraints_multipliers_18
        - rear_contact_u_x * constraints_multipliers_14 + constraints_multipliers_109;
    const real constraints_multipliers_111 = rear_contact_u_x * constraints_multipliers_7
        + rear_contact_u_y * constraints_multipliers_9;
    const real constraints_multipliers_112 = rear_contact_u_yaw * (rear_contact_S *
        constraints_multipliers_12 + rear_contact_R_2 * constraints_multipliers_26);
    const real constraints_multipliers_113 = rear_contact_u_x * constraints_multipliers_16
        + rear_contact_u_y * constraints_multipliers_20 + constraints_multipliers_112;
    const real rear_wheel_omega_x = work[175];
    const real constraints_multipliers_114 = rear_wheel_omega_x * constraints_multipliers_14
        + rear_contact_R_xx * constraints_multipliers_106;
    const real rear_wheel_omega_y = work[176];
    const real constraints_multipliers_115 = rear_wheel_omega_y * constraints_multipliers_7
        + rear_contact_R_3 * constraints_multipliers_107;
    const real rear_wheel_omega_z = work[177];
    const real constraints_multipliers_116 = rear_wheel_omega_z * constraints_multipliers_16
        + rear_contact_R_xz * constraints_multipliers_108;
    const real constraints_multipliers_117 = constraints_multipliers_116
        - (constraints_multipliers_114 + constraints_multipliers_115);
    const real constraints_multipliers_118 = rear_wheel_omega_x * constraints_multipliers_18
        - rear_contact_R_yx * constraints_multipliers_106;
    const real constraints_multipliers_119 = rear_contact_R_yy * constraints_multipliers_107
        - rear_wheel_omega_y * constraints_multipliers_9;
    const real constraints_multipliers_120 = rear_wheel_omega_z * constraints_multipliers_20
        + rear_contact_R_yz * constraints_multipliers_108;
    const real constraints_multipliers_121 = constraints_multipliers_118
        + constraints_multipliers_119 + constraints_multipliers_120;
    const real constraints_multipliers_122 = rear_wheel_omega_x * constraints_multipliers_21
        - rear_contact_R_6 * constraints_multipliers_106;
    const real constraints_multipliers_123 = rear_wheel_omega_y * constraints_multipliers_6
        + rear_contact_sin * constraints_multipliers_107;
    const real constraints_multipliers_124 = rear_contact_R_zz * constraints_multipliers_108
        - rear_wheel_omega_z * constraints_multipliers_22;
    const real constraints_multipliers_125 = constraints_multipliers_123
        - constraints_multipliers_122 + constraints_multipliers_124;
    const real rear_contact_velocity_2 = work[87];
    const real constraints_multipliers_126 = rear_contact_R_xx * constraints_multipliers_110
        - rear_contact_velocity_2 * constraints_multipliers_14;
    const real rear_contact_velocity = work[77];
    const real constraints_multipliers_127 = rear_contact_velocity * constraints_multipliers_7
        - rear_contact_R_3 * constraints_multipliers_111;
    const real rear_contact_velocity_3 = work[88];
    const real constraints_multipliers_128 = rear_contact_velocity_3 * constraints_multipliers_16
        + rear_contact_R_xz * constraints_multipliers_113;
    const real constraints_multipliers_129 = constraints_multipliers_126
        - constraints_multipliers_127 + constraints_multipliers_128;
    const real constraints_multipliers_130 = rear_contact_velocity_2 * constraints_multipliers_18
        + rear_contact_R_yx * constraints_multipliers_110;
    const real constraints_multipliers_131 = rear_contact_velocity * constraints_multipliers_9
        + rear_contact_R_yy * constraints_multipliers_111;
    const real constraints_multipliers_132 = rear_contact_velocity_3 * constraints_multipliers_20
        + rear_contact_R_yz * constraints_multipliers_113;
    const real constraints_multipliers_133 = constraints_multipliers_130
        - constraints_multipliers_131 + constraints_multipliers_132;
    const real constraints_multipliers_134 = rear_contact_velocity_2 * constraints_multipliers_21
        + rear_contact_R_6 * constraints_multipliers_110;
    const real constraints_multipliers_135 = rear_contact_velocity * constraints_multipliers_6
        - rear_contact_sin * constraints_multipliers_111;
    const real constraints_multipliers_136 = rear_contact_R_zz * constraints_multipliers_113
        - rear_contact_velocity_3 * constraints_multipliers_22;
    const real constraints_multipliers_137 = constraints_multipliers_135
        - constraints_multipliers_134 + constraints_multipliers_136;
    const real front_contact_twist_116 = work[188];
    const real front_contact_twist_25 = work[116];
    const real constraints_multipliers_138 = front_contact_twist_116 * constraints_multipliers_105 +
        front_contact_twist_25 * constraints_multipliers_121;
    const real front_contact_twist_118 = work[189];
    const real front_contact_twist_24 = work[115];
    const real constraints_multipliers_139 = front_contact_twist_118 * constraints_multipliers_104 +
        front_contact_twist_24 * constraints_multipliers_125;
    const real front_contact_twist_23 = work[114];
    const real constraints_multipliers_140 = front_contact_twist_118 * constraints_multipliers_103 +
        front_contact_twist_23 * constraints_multipliers_125;
    const real front_contact_twist_114 = work[187];
    const real constraints_multipliers_141 = front_contact_twist_114 * constraints_multipliers_105 +
        front_contact_twist_25 * constraints_multipliers_117;
    const real constraints_multipliers_142 = front_contact_twist_114 * constraints_multipliers_104 +
        front_contact_twist_24 * constraints_multipliers_117;
    const real constraints_multipliers_143 = front_contact_twist_116 * constraints_multipliers_103 +
        front_contact_twist_23 * constraints_multipliers_121;
    const real constraints_multipliers_144 = constraints_multipliers_138
        - constraints_multipliers_139 + constraints_multipliers_129;
    const real constraints_multipliers_145 = constraints_multipliers_140
        - constraints_multipliers_141 + constraints_multipliers_133;
    const real constraints_multipliers_146 = constraints_multipliers_142
        - constraints_multipliers_143 + constraints_multipliers_137;
    const real constraints_multipliers_147 = rear_hub_u * constraints_multipliers_7;
    const real constraints_multipliers_148 = rear_hub_u * constraints_multipliers_9;
    const real constraints_multipliers_149 = rear_hub_u * constraints_multipliers_6;
    const real front_contact_twist_18 = work[99];
    const real constraints_multipliers_150 = front_contact_twist_18 * constraints_multipliers_105
        - front_contact_twist_25 * constraints_multipliers_148;
    const real front_contact_twist_19 = work[100];
    const real constraints_multipliers_151 = front_contact_twist_19 * constraints_multipliers_104
        + front_contact_twist_24 * constraints_multipliers_149;
    const real constraints_multipliers_152 = front_contact_twist_19 * constraints_multipliers_103
        + front_contact_twist_23 * constraints_multipliers_149;
    const real front_contact_twist_17 = work[98];
    const real constraints_multipliers_153 = front_contact_twist_17 * constraints_multipliers_105
        + front_contact_twist_25 * constraints_multipliers_147;
    const real constraints_multipliers_154 = front_contact_twist_17 * constraints_multipliers_104
        + front_contact_twist_24 * constraints_multipliers_147;
    const real constraints_multipliers_155 = front_contact_twist_18 * constraints_multipliers_103
        - front_contact_twist_23 * constraints_multipliers_148;
    const real constraints_multipliers_156 = constraints_multipliers_150
        - constraints_multipliers_151 + constraints_multipliers_144;
    const real constraints_multipliers_157 = constraints_multipliers_152
        + constraints_multipliers_153 + constraints_multipliers_145;
    const real constraints_multipliers_158 = constraints_multipliers_146
        - (constraints_multipliers_154 + constraints_multipliers_155);
    const real constraints_multipliers_159 = constraints_multipliers_100
        - constraints_multipliers_72;
    const real constraints_multipliers_160 = constraints_multipliers_101
        - constraints_multipliers_73;
    const real constraints_multipliers_161 = constraints_multipliers_74
        + constraints_multipliers_102;
    const real constraints_multipliers_162 = steer_u * constraints_multipliers_57;
    const real constraints_multipliers_163 = steer_u * constraints_multipliers_64;
    const real constraints_multipliers_164 = steer_u * constraints_multipliers_71;
    const real front_contact_twist_21 = work[102];
    const real front_contact_twist_42 = work[119];
    const real constraints_multipliers_165 = front_contact_twist_21 * constraints_multipliers_161
        + front_contact_twist_42 * constraints_multipliers_163;
    const real front_contact_twist_22 = work[103];
    const real front_contact_twist_41 = work[118];
    const real constraints_multipliers_166 = front_contact_twist_22 * constraints_multipliers_160
        + front_contact_twist_41 * constraints_multipliers_164;
    const real front_contact_twist_40 = work[117];
    const real constraints_multipliers_167 = front_contact_twist_22 * constraints_multipliers_159
        + front_contact_twist_40 * constraints_multipliers_164;
    const real front_contact_twist_20 = work[101];
    const real constraints_multipliers_168 = front_contact_twist_20 * constraints_multipliers_161
        + front_contact_twist_42 * constraints_multipliers_162;
    const real constraints_multipliers_169 = front_contact_twist_20 * constraints_multipliers_160
        + front_contact_twist_41 * constraints_multipliers_162;
    const real constraints_multipliers_170 = front_contact_twist_21 * constraints_multipliers_159
        + front_contact_twist_40 * constraints_multipliers_163;
    const real constraints_multipliers_171 = constraints_multipliers_117
        - constraints_multipliers_147 + constraints_multipliers_162;
    const real constraints_multipliers_172 = constraints_multipliers_121
        - constraints_multipliers_148 + constraints_multipliers_163;
    const real constraints_multipliers_173 = constraints_multipliers_125
        + constraints_multipliers_149 + constraints_multipliers_164;
    const real constraints_multipliers_174 = constraints_multipliers_165
        - constraints_multipliers_166 + constraints_multipliers_156;
    const real constraints_multipliers_175 = constraints_multipliers_167
        - constraints_multipliers_168 + constraints_multipliers_157;
    const real constraints_multipliers_176 = constraints_multipliers_169
        - constraints_multipliers_170 + constraints_multipliers_158;
    const real constraints_multipliers_177 = constraints_multipliers_171
        + front_hub_u * constraints_multipliers_82;
    const real constraints_multipliers_178 = constraints_multipliers_172
        - front_hub_u * constraints_multipliers_89;
    const real constraints_multipliers_179 = constraints_multipliers_173
        + front_hub_u * constraints_multipliers_96;
    const real front_contact_pose_16 = work[111];
    const real front_contact_pose_22 = work[135];
    const real constraints_multipliers_180 = front_contact_pose_16 * constraints_multipliers_81
        + front_contact_pose_22 * constraints_multipliers_82;
    const real front_contact_pose_17 = work[112];
    const real front_contact_pose_24 = work[137];
    const real constraints_multipliers_181 = front_contact_pose_17 * constraints_multipliers_88
        + front_contact_pose_24 * constraints_multipliers_89;
    const real constraints_multipliers_182 = front_contact_pose_16 * constraints_multipliers_82;
    const real constraints_multipliers_183 = front_contact_pose_17 * constraints_multipliers_89;
    const real front_contact_pose_18 = work[113];
    const real constraints_multipliers_184 = front_contact_pose_18 * constraints_multipliers_96;
    const real front_contact_pose_23 = work[136];
    const real constraints_multipliers_185 = front_contact_pose_23 * constraints_multipliers_82
        + front_contact_pose_16 * constraints_multipliers_85;
    const real front_contact_pose_25 = work[138];
    const real constraints_multipliers_186 = front_contact_pose_25 * constraints_multipliers_89
        - front_contact_pose_17 * constraints_multipliers_92;
    const real front_contact_twist_131 = work[193];
    const real constraints_multipliers_187 = front_contact_twist_131 * constraints_multipliers_81
        + front_contact_pose_22 * constraints_multipliers_177;
    const real front_contact_twist_132 = work[194];
    const real constraints_multipliers_188 = front_contact_twist_132 * constraints_multipliers_88
        + front_contact_pose_24 * constraints_multipliers_178;
    const real front_contact_twist_133 = work[195];
    const real front_contact_pose_26 = work[139];
    const real constraints_multipliers_189 = front_contact_twist_133 * constraints_multipliers_95
        + front_contact_pose_26 * constraints_multipliers_179;
    const real constraints_multipliers_190 = constraints_multipliers_187
        - constraints_multipliers_188 - constraints_multipliers_189;
    work[211] = constraints_multipliers_190;
    const real constraints_multipliers_191 = front_contact_twist_131 * constraints_multipliers_82
        + front_contact_pose_16 * constraints_multipliers_177;
    const real constraints_multipliers_192 = front_contact_twist_132 * constraints_multipliers_89
        + front_contact_pose_17 * constraints_multipliers_178;
    const real constraints_multipliers_193 = front_contact_twist_133 * constraints_multipliers_96
        + front_contact_pose_18 * constraints_multipliers_179;
    const real constraints_multipliers_194 = constraints_multipliers_191
        - constraints_multipliers_192 + constraints_multipliers_193;
    const real constraints_multipliers_195 = front_contact_twist_131 * constraints_multipliers_85
        + front_contact_pose_23 * constraints_multipliers_177;
    const real constraints_multipliers_196 = front_contact_pose_25 * constraints_multipliers_178
        - front_contact_twist_132 * constraints_multipliers_92;
    const real front_contact_pose_27 = work[140];
    const real constraints_multipliers_197 = front_contact_twist_133 * constraints_multipliers_99
        + front_contact_pose_27 * constraints_multipliers_179;
    const real constraints_multipliers_198 = constraints_multipliers_196
        - constraints_multipliers_195 + constraints_multipliers_197;
    work[212] = constraints_multipliers_198;
    const real front_contact_twist_128 = work[190];
    const real constraints_multipliers_199 = front_contact_twist_128 * constraints_multipliers_81
        + front_contact_pose_22 * constraints_multipliers_174;
    const real front_contact_twist_129 = work[191];
    const real constraints_multipliers_200 = front_contact_twist_129 * constraints_multipliers_88
        + front_contact_pose_24 * constraints_multipliers_175;
    const real front_contact_twist_130 = work[192];
    const real constraints_multipliers_201 = front_contact_twist_130 * constraints_multipliers_95
        + front_contact_pose_26 * constraints_multipliers_176;
    const real constraints_multipliers_202 = constraints_multipliers_199
        - constraints_multipliers_200 - constraints_multipliers_201;
    const real constraints_multipliers_203 = front_contact_twist_128 * constraints_multipliers_82
        + front_contact_pose_16 * constraints_multipliers_174;
    const real constraints_multipliers_204 = front_contact_twist_129 * constraints_multipliers_89
        + front_contact_pose_17 * constraints_multipliers_175;
    const real constraints_multipliers_205 = front_contact_twist_130 * constraints_multipliers_96
        + front_contact_pose_18 * constraints_multipliers_176;
    const real constraints_multipliers_206 = constraints_multipliers_203
        - constraints_multipliers_204 + constraints_multipliers_205;
    const real constraints_multipliers_207 = front_contact_twist_128 * constraints_multipliers_85
        + front_contact_pose_23 * constraints_multipliers_174;
    const real constraints_multipliers_208 = front_contact_pose_25 * constraints_multipliers_175
        - front_contact_twist_129 * constraints_multipliers_92;
    const real constraints_multipliers_209 = front_contact_twist_130 * constraints_multipliers_99
        + front_contact_pose_27 * constraints_multipliers_176;
    const real constraints_multipliers_210 = constraints_multipliers_208
        - constraints_multipliers_207 + constraints_multipliers_209;
    const real constraints_multipliers_211 = constraints_multipliers_2 *
        (constraints_multipliers_182 + constraints_multipliers_182 + (constraints_multipliers_183
        + constraints_multipliers_183));
    const real constraints_multipliers_212 = cardan_select(front_contact_G_3,
        -constraints_multipliers * constraints_multipliers_211 / front_contact_G_3, 0.0);
    const real constraints_multipliers_213 = constraints_multipliers_2 *
        (constraints_multipliers_185 + constraints_multipliers_185 + (constraints_multipliers_186
        + constraints_multipliers_186));
    const real constraints_multipliers_214 = constraints_multipliers_2 *
        (constraints_multipliers_180 + constraints_multipliers_180 + (constraints_multipliers_181
        + constraints_multipliers_181));
    const real front_contact_G_4 = work[125];
    const real constraints_multipliers_215 = (constraints_multipliers_89
        - front_contact_G_4 * constraints_multipliers_211) / front_contact_G_3;
    const real front_contact_G_5 = work[126];
    const real constraints_multipliers_216 = (constraints_multipliers_82
        - front_contact_G_5 * constraints_multipliers_211) / front_contact_G_3;
    const real constraints_multipliers_217 = front_contact_pose_18 * constraints_multipliers_82
        + front_contact_pose_16 * constraints_multipliers_96;
    const real constraints_multipliers_218 = front_contact_pose_18 * constraints_multipliers_89
        + front_contact_pose_17 * constraints_multipliers_96;
    const real front_contact_G_8 = work[129];
    const real constraints_multipliers_219 = (constraints_multipliers_184
        + constraints_multipliers_184
        + front_contact_G_8 * constraints_multipliers_211) / front_contact_G_3;
    const real constraints_multipliers_220 = front_radius * constraints_multipliers_219;
    const real front_contact_twist_135 = work[196];
    const real add_1 = work[207];
    const real constraints_multipliers_221 = front_radius * (constraints_multipliers_213
        + add_1 * constraints_multipliers_212) * front_contact_twist_135;
    work[213] = constraints_multipliers_221;
    const real front_contact_twist_139 = work[198];
    const real add_1_2 = work[208];
    const real constraints_multipliers_222 = front_radius * (add_1_2 * constraints_multipliers_212 +
        constraints_multipliers_214) * front_contact_twist_139;
    work[214] = constraints_multipliers_222;
    const real front_contact_twist_141 = work[199];
    const real constraints_multipliers_223 = front_contact_twist_141 * constraints_multipliers_95
        + front_contact_pose_26 * constraints_multipliers_202;
    work[215] = constraints_multipliers_223;
    const real front_contact_twist_143 = work[200];
    const real constraints_multipliers_224 = front_contact_twist_143 * constraints_multipliers_96
        + front_contact_pose_18 * constraints_multipliers_206;
    work[216] = constraints_multipliers_224;
    const real front_contact_twist_145 = work[201];
    const real constraints_multipliers_225 = front_contact_twist_145 * constraints_multipliers_99
        + front_contact_pose_27 * constraints_multipliers_210;
    work[217] = constraints_multipliers_225;
    const real constraints_multipliers_226 = front_contact_twist_141 * constraints_multipliers_81
        + front_contact_pose_22 * constraints_multipliers_202;
    const real constraints_multipliers_227 = front_contact_twist_143 * constraints_multipliers_82
        + front_contact_pose_16 * constraints_multipliers_206;
    const real constraints_multipliers_228 = front_contact_twist_145 * constraints_multipliers_85
        + front_contact_pose_23 * constraints_multipliers_210;
    const real constraints_multipliers_229 = front_contact_twist_141 * constraints_multipliers_88
        + front_contact_pose_24 * constraints_multipliers_202;
    const real constraints_multipliers_230 = front_contact_twist_143 * constraints_multipliers_89
        + front_contact_pose_17 * constraints_multipliers_206;
    const real constraints_multipliers_231 = front_contact_pose_25 * constraints_multipliers_210
        - front_contact_twist_145 * constraints_multipliers_92;
    const real constraints_multipliers_232 = front_contact_twist_135 * constraints_multipliers_81
        + front_contact_pose_22 * constraints_multipliers_190;
    const real front_contact_twist_137 = work[197];
    const real constraints_multipliers_233 = front_contact_twist_137 * constraints_multipliers_82
        + front_contact_pose_16 * constraints_multipliers_194;
    const real constraints_multipliers_234 = front_contact_twist_139 * constraints_multipliers_85
        + front_contact_pose_23 * constraints_multipliers_198;
    const real constraints_multipliers_235 = front_contact_twist_135 * constraints_multipliers_88
        + front_contact_pose_24 * constraints_multipliers_190;
    const real constraints_multipliers_236 = front_contact_twist_137 * constraints_multipliers_89
        + front_contact_pose_17 * constraints_multipliers_194;
    const real constraints_multipliers_237 = front_contact_pose_25 * constraints_multipliers_198
        - front_contact_twist_139 * constraints_multipliers_92;
    const real constraints_multipliers_238 = front_contact_twist_135 * constraints_multipliers_95
        + front_contact_pose_26 * constraints_multipliers_190;
    const real constraints_multipliers_239 = front_contact_twist_137 * constraints_multipliers_96
        + front_contact_pose_18 * constraints_multipliers_194;
    const real constraints_multipliers_240 = front_contact_twist_139 * constraints_multipliers_99
        + front_contact_pose_27 * constraints_multipliers_198;
    const real constraints_multipliers_241 = constraints_multipliers_239
        - constraints_multipliers_238 + constraints_multipliers_240;
    const real front_contact_G_11 = work[132];
    const real constraints_multipliers_242 = front_contact_G_11 * (constraints_multipliers_237
        - (constraints_multipliers_235 + constraints_multipliers_236));
    const real front_contact_rate_6 = work[203];
    const real constraints_multipliers_243 = constraints_multipliers_242
        - front_contact_rate_6 * constraints_multipliers_220;
    const real front_contact_rate_8 = work[204];
    const real front_contact_G_7 = work[128];
    const real constraints_multipliers_244 = (constraints_multipliers_218
        - front_contact_G_7 * constraints_multipliers_211) / front_contact_G_3 * front_radius *
        front_contact_rate_8;
    const real front_contact_G_10 = work[131];
    const real constraints_multipliers_245 = constraints_multipliers_244
        + front_contact_G_10 * constraints_multipliers_241 - constraints_multipliers_243;
    const real front_contact_G_6 = work[127];
    const real constraints_multipliers_246 = (constraints_multipliers_217
        - front_contact_G_6 * constraints_multipliers_211) / front_contact_G_3 * front_radius *
        front_contact_rate_8;
    const real constraints_multipliers_247 = front_contact_G_11 * (constraints_multipliers_232
        + constraints_multipliers_233 - constraints_multipliers_234);
    const real front_contact_rate_4 = work[202];
    const real constraints_multipliers_248 = constraints_multipliers_247
        - front_contact_rate_4 * constraints_multipliers_220;
    const real front_contact_G_9 = work[130];
    const real constraints_multipliers_249 = constraints_multipliers_246
        + front_contact_G_9 * constraints_multipliers_241 + constraints_multipliers_248;
    const real constraints_multipliers_250 = constraints_multipliers_226
        + constraints_multipliers_227 - constraints_multipliers_228 + constraints_multipliers_245;
    const real constraints_multipliers_251 = constraints_multipliers_231
        - (constraints_multipliers_229 + constraints_multipliers_230) + constraints_multipliers_249;
    const real front_contact_rate_11 = work[205];
    const real constraints_multipliers_252 = front_contact_rate_11 * constraints_multipliers_215
        + front_contact_G_4 * constraints_multipliers_250;
    work[218] = constraints_multipliers_252;
    const real front_contact_rate_12 = work[206];
    const real constraints_multipliers_253 = front_contact_rate_12 * constraints_multipliers_216
        + front_contact_G_5 * constraints_multipliers_251;
    work[219] = constraints_multipliers_253;
    const real constraints_multipliers_254 = front_contact_rate_11 * constraints_multipliers_216
        + front_contact_G_5 * constraints_multipliers_250;
    work[220] = constraints_multipliers_254;
    const real constraints_multipliers_255 = front_contact_rate_12 * constraints_multipliers_215
        + front_contact_G_4 * constraints_multipliers_251;
    work[221] = constraints_multipliers_255;
    const real constraints_multipliers_256 = rear_contact_u_y * constraints_multipliers_4
        - rear_contact_u_x * constraints_multipliers_3;
    work[222] = constraints_multipliers_256;

    /* common */
    const real mul_1_5 = add_1 * constraints_multipliers_2 * front_radius;
    work[223] = mul_1_5;
    const real mul_1_6 = constraints_multipliers_2 * add_1_2 * front_radius;
    work[224] = mul_1_6;

    /* fork: inertia, composite inertia, momentum */
    const wreal front_wheel_base_inertia_zz = w[12];
    const wreal fork_base_moment_x = w[13];
    const wreal fork_base_inertia_xz = w[14];
    const wreal fork_base_inertia_zz = w[15];
    const wreal fork_inertia = w[34];
    const real fork_inertia_2 = front_wheel_base_inertia_zz * front_hub_sin;
    const real fork_inertia_3 = front_hub_sin * fork_inertia_2;
    const real fork_composite_inertia_xx = front_wheel_base_inertia_zz - fork_inertia_3;
    const real fork_composite_inertia_xz = fork_base_inertia_xz
        - front_hub_cos * fork_inertia_2 * front_hub_R_yy;
    const real fork_composite_inertia_zz = fork_base_inertia_zz
        + front_hub_R_yy * fork_inertia_3 * front_hub_R_yy;
    work[225] = fork_composite_inertia_zz;
    const real fork_momentum = steer_R_3 * fork_inertia;
    const real fork_momentum_2 = steer_sin * fork_inertia;
    work[226] = fork_momentum_2;
    const real fork_momentum_3 = steer_R_5 * fork_inertia;
    const real fork_momentum_4 = fork_base_moment_x * steer_R_3;
    const real fork_momentum_5 = fork_base_moment_x * steer_sin;
    const real fork_momentum_6 = fork_base_moment_x * steer_R_5;

    /* frame: inertia, composite moment, composite inertia, momentum, omega, alpha, a, U, ... */
    const wreal frame_base_moment_x = w[16];
    const wreal frame_base_moment_z = w[17];
    const wreal frame_base_inertia_yy = w[19];
    const wreal frame_base_second_moment_xx = w[30];
    const wreal frame_base_second_moment_xz = w[31];
    const wreal frame_base_second_moment_zz = w[32];
    const wreal fork_composite_inertia_yy = w[35];
    const real frame_inertia = steer_sin * (fork_composite_inertia_xx - fork_composite_inertia_yy);
    const real frame_inertia_2 = steer_sin * frame_inertia;
    const real frame_inertia_3 = fork_composite_inertia_yy + frame_inertia_2;
    const real frame_inertia_4 = steer_cos * frame_inertia;
    const real frame_inertia_5 = steer_sin * fork_composite_inertia_xz;
    const real frame_inertia_6 = div_1 * frame_inertia_5;
    const real frame_inertia_7 = steer_R_zz * frame_inertia_3 + frame_inertia_6;
    const real frame_inertia_8 = steer_R_zz * frame_inertia_5;
    const real frame_inertia_9 = fork_base_moment_x * steer_R_2;
    const real frame_composite_moment_y = fork_base_moment_x * steer_cos;
    const real frame_inertia_10 = fork_base_moment_x * steer_R_4;
    const real frame_inertia_11 = steer_place_x * frame_inertia_9;
    const real frame_inertia_12 = rear_radius * frame_inertia_10;
    const real frame_inertia_13 = 2.0 * (frame_inertia_12 - frame_inertia_11);
    const real frame_composite_moment_x = frame_base_moment_x - frame_inertia_9;
    const real frame_composite_moment_z = frame_base_moment_z - frame_inertia_10;
    const real frame_composite_inertia_yy = fork_composite_inertia_xx - frame_inertia_2
        + frame_inertia_13 + frame_base_inertia_yy;
    work[227] = frame_composite_inertia_yy;
    const real frame_momentum = rear_hub_cos * fork_momentum + rear_hub_sin * fork_momentum_3;
    const real frame_momentum_2 = rear_hub_sin * fork_momentum - rear_hub_cos * fork_momentum_3;
    const real frame_momentum_3 = rear_hub_cos * fork_momentum_4 + rear_hub_sin * fork_momentum_6;
    const real frame_momentum_4 = rear_hub_sin * fork_momentum_4 - rear_hub_cos * fork_momentum_6;
    const real frame_omega_x = rear_hub_cos * rear_wheel_omega_x
        - rear_hub_sin * rear_wheel_omega_z;
    const real frame_omega_z = rear_hub_sin * rear_wheel_omega_x
        + rear_hub_cos * rear_wheel_omega_z;
    const real frame_omega_y = rear_hub_u + rear_wheel_omega_y;
    const real rear_contact_drift_5 = work[78];
    const real rear_wheel_alpha_z = work[179];
    const real frame_alpha = rear_hub_cos * rear_contact_drift_5
        + rear_hub_sin * rear_wheel_alpha_z + rear_hub_u * frame_omega_z;
    const real frame_alpha_z = rear_hub_cos * rear_wheel_alpha_z
        - rear_hub_sin * rear_contact_drift_5 + rear_hub_u * frame_omega_x;
    const real rear_wheel_a_x = work[180];
    const real rear_wheel_a_z = work[182];
    const real frame_a_x = rear_hub_cos * rear_wheel_a_x - rear_hub_sin * rear_wheel_a_z;
    work[228] = frame_a_x;
    const real frame_a_z = rear_hub_sin * rear_wheel_a_x + rear_hub_cos * rear_wheel_a_z;
    work[229] = frame_a_z;
    const real frame_U = frame_omega_y * frame_omega_y;
    const real frame_U_2 = frame_omega_x * frame_omega_z;
    const real frame_U_3 = frame_U + frame_omega_z * frame_omega_z;
    const real rear_wheel_alpha_y = work[178];
    const real frame_U_xz = rear_wheel_alpha_y + frame_U_2;
    const real frame_U_yx = frame_alpha_z + frame_omega_x * frame_omega_y;
    const real frame_U_yz = frame_alpha + frame_omega_z * frame_omega_y;
    const real frame_U_zx = frame_U_2 - rear_wheel_alpha_y;
    const real frame_U_4 = frame_omega_x * frame_omega_x + frame_U;
    const real frame_inertia_force = frame_base_second_moment_zz * frame_U_yz
        + frame_base_second_moment_xz * frame_U_yx;
    work[230] = frame_inertia_force;
    const real frame_inertia_force_2 = frame_base_second_moment_zz * frame_U_xz
        - frame_base_second_moment_xx * frame_U_zx;
    const real frame_inertia_force_3 = frame_inertia_force_2
        + frame_base_second_moment_xz * (frame_U_4 - frame_U_3);
    work[231] = frame_inertia_force_3;
    const real frame_inertia_force_4 = frame_base_second_moment_xx * frame_U_yx
        + frame_base_second_moment_xz * frame_U_yz;
    work[232] = frame_inertia_force_4;

    /* shared by several: inertia, M */
    const real frame_inertia_14 = steer_cos * fork_composite_inertia_xz;
    const real frame_inertia_15 = div_1 * fork_composite_inertia_zz;
    const real frame_inertia_16 = steer_R_zz * fork_composite_inertia_zz;
    const real steer_M = rear_radius * fork_momentum_5;

    /* frame: inertia, composite inertia */
    const wreal frame_base_inertia_xz = w[18];
    const wreal frame_base_inertia_zz = w[20];
    const real frame_inertia_17 = frame_inertia_8 + frame_inertia_15;
    const real frame_inertia_18 = steer_R_zz * (frame_inertia_16 - frame_inertia_6)
        - div_1 * (frame_inertia_8 - div_1 * frame_inertia_3);
    const real frame_composite_inertia_xx = steer_R_zz * frame_inertia_7
        + div_1 * frame_inertia_17 + (frame_inertia_13 + 2.0 * frame_inertia_11);
    const real frame_inertia_19 = steer_R_zz * frame_inertia_4 + div_1 * frame_inertia_14
        + steer_place_x * frame_composite_moment_y;
    const real frame_inertia_20 = div_1 * frame_inertia_7 - steer_R_zz * frame_inertia_17
        - (rear_radius * frame_inertia_9 - steer_place_x * frame_inertia_10);
    const real frame_composite_inertia_yz = steer_R_zz * frame_inertia_14
        - div_1 * frame_inertia_4 + rear_radius * frame_composite_moment_y;
    const real frame_composite_inertia_xz = frame_base_inertia_xz + frame_inertia_20;
    const real frame_composite_inertia_zz = frame_inertia_13 - 2.0 * frame_inertia_12
        + frame_inertia_18 + frame_base_inertia_zz;

    /* rear_wheel: inertia, composite inertia, composite moment */
    const wreal rear_wheel_inertia_yy = w[3]; /* kg m^2 */
    const wreal rear_wheel_base_inertia_xx = w[22];
    const wreal rear_wheel_base_inertia_zz = w[23];
    const real rear_wheel_inertia = rear_hub_sin * (frame_composite_inertia_zz
        - frame_composite_inertia_xx);
    const real rear_wheel_inertia_2 = rear_wheel_inertia
        + rear_hub_cos * (frame_composite_inertia_xz + frame_composite_inertia_xz);
    const real rear_wheel_inertia_3 = rear_hub_sin * rear_wheel_inertia_2;
    const real rear_wheel_composite_inertia_xz = rear_hub_cos * rear_wheel_inertia_2
        - frame_composite_inertia_xz;
    const real rear_wheel_composite_inertia_xy = rear_hub_sin * frame_composite_inertia_yz
        - rear_hub_cos * frame_inertia_19;
    const real rear_wheel_composite_moment_x = rear_hub_cos * frame_composite_moment_x
        + rear_hub_sin * frame_composite_moment_z;
    const real rear_wheel_composite_moment_z = rear_hub_cos * frame_composite_moment_z
        - rear_hub_sin * frame_composite_moment_x;
    const real rear_wheel_composite_inertia_xx = frame_composite_inertia_xx
        + rear_wheel_inertia_3 + rear_wheel_base_inertia_xx;
    const real rear_wheel_composite_inertia_yy = rear_wheel_inertia_yy + frame_composite_inertia_yy;
    work[233] = rear_wheel_composite_inertia_yy;
    const real rear_wheel_composite_inertia_zz = frame_composite_inertia_zz
        - rear_wheel_inertia_3 + rear_wheel_base_inertia_zz;

    /* shared by several: inertia, M */
    const real rear_wheel_inertia_4 = rear_hub_cos * frame_composite_inertia_yz
        + rear_hub_sin * frame_inertia_19;
    const real rear_contact_M_5 = rear_contact_R_6 * rear_wheel_composite_inertia_xy;
    const real rear_contact_S_2 = work[85];
    const real rear_contact_M_6 = rear_contact_S_2 * rear_wheel_composite_moment_z;
    const real rear_contact_S_3 = work[86];
    const real rear_contact_M_7 = rear_contact_S_3 * rear_wheel_composite_moment_x;
    const real rear_contact_M_8 = rear_contact_R * rear_wheel_composite_inertia_xy;

    /* rear_wheel: composite inertia */
    const real rear_wheel_composite_inertia_yz = rear_wheel_inertia_4 + rear_wheel_inertia_4
        - rear_wheel_inertia_4;

    /* M */
    const real M_8_3 = rear_contact_R_6 * frame_momentum - rear_contact_sin * fork_momentum_2
        + rear_contact_R_zz * frame_momentum_2;
    work[234] = M_8_3;
    const real M_8_4 = rear_contact_R_2 * frame_momentum_2 - rear_contact_R * frame_momentum;
    work[235] = M_8_4;
    const real M_7_5 = rear_radius * fork_momentum_4 + steer_place_x * fork_momentum_6
        + frame_inertia_14;
    work[236] = M_7_5;
    const real M_7_1 = rear_contact_R_3 * fork_momentum_5 - rear_contact_R_xx * frame_momentum_3
        + rear_contact_R_xz * frame_momentum_4;
    work[237] = M_7_1;
    const real M_7_2 = rear_contact_R_yz * frame_momentum_4
        - (rear_contact_R_yx * frame_momentum_3 + rear_contact_R_yy * fork_momentum_5);
    work[238] = M_7_2;
    const real M_6_4 = rear_contact_M_8 + rear_contact_R_2 * rear_wheel_inertia_4;
    work[239] = M_6_4;
    const real rear_contact_M_2 = work[82];
    const real rear_contact_momentum_fz = work[79];
    const real M_1_1 = rear_contact_M_2 + rear_contact_R_xz * rear_contact_momentum_fz;
    work[240] = M_1_1;
    const real rear_contact_M_3 = work[83];
    const real rear_contact_momentum_fz_2 = work[80];
    const real M_2_1 = rear_contact_M_3 + rear_contact_R_xz * rear_contact_momentum_fz_2;
    work[241] = M_2_1;
    const real rear_contact_M_4 = work[84];
    const real M_2_2 = rear_contact_M_4 + rear_contact_R_yz * rear_contact_momentum_fz_2;
    work[242] = M_2_2;

    /* fork: momentum, omega, alpha, a, U, inertia force, f */
    const wreal fork_base_second_moment_xx = w[28];
    const wreal fork_base_second_moment_yy = w[29];
    const real fork_momentum_7 = frame_inertia_15 + steer_R_2 * fork_composite_inertia_xz + steer_M;
    const real fork_momentum_8 = frame_inertia_16 - steer_R_4 * fork_composite_inertia_xz
        - steer_place_x * fork_momentum_5;
    const real fork_omega_x = steer_cos * frame_omega_y - steer_R_2 * frame_omega_x
        - steer_R_4 * frame_omega_z;
    work[243] = fork_omega_x;
    const real fork_alpha = steer_R_3 * frame_omega_x + steer_sin * frame_omega_y
        + steer_R_5 * frame_omega_z;
    work[244] = fork_alpha;
    const real fork_omega_z = steer_R_zz * frame_omega_z - div_1 * frame_omega_x + steer_u;
    work[245] = fork_omega_z;
    const real fork_alpha_z = div_1 * frame_alpha + steer_R_zz * frame_alpha_z;
    work[246] = fork_alpha_z;
    const real fork_alpha_x = steer_R_2 * frame_alpha + steer_cos * rear_wheel_alpha_y
        - steer_R_4 * frame_alpha_z - steer_u * fork_alpha;
    work[247] = fork_alpha_x;
    const real fork_alpha_y = steer_R_3 * frame_alpha - steer_sin * rear_wheel_alpha_y
        - steer_R_5 * frame_alpha_z - steer_u * fork_omega_x;
    work[248] = fork_alpha_y;
    const real fork_a = frame_a_x - (steer_place_x * frame_U_3 + rear_radius * frame_U_xz);
    const real fork_a_2 = steer_place_x * frame_U_zx + rear_radius * frame_U_4 + frame_a_z;
    work[249] = fork_a_2;
    const real rear_wheel_a_y = work[181];
    const real fork_a_3 = steer_R_3 * fork_a + steer_sin * (steer_place_x * frame_U_yx
        - rear_radius * frame_U_yz + rear_wheel_a_y);
    work[250] = fork_a_3;
    const real fork_a_z = steer_R_zz * fork_a_2 - div_1 * fork_a;
    work[251] = fork_a_z;
    const real fork_U = fork_alpha * fork_alpha;
    const real fork_U_2 = fork_omega_x * fork_alpha;
    const real fork_U_3 = fork_alpha * fork_omega_z;
    const real fork_U_4 = fork_U + fork_omega_z * fork_omega_z;
    const real fork_U_yx = fork_alpha_z - fork_U_2;
    work[252] = fork_U_yx;
    const real fork_U_zx = fork_omega_x * fork_omega_z - fork_alpha_y;
    const real fork_U_zy = fork_alpha_x - fork_U_3;
    work[253] = fork_U_zy;
    const real fork_inertia_force = fork_base_second_moment_xx * fork_U_zx
        + fork_base_inertia_xz * (fork_omega_x * fork_omega_x + fork_U - fork_U_4);
    work[254] = fork_inertia_force;
    const real fork_inertia_force_2 = fork_base_second_moment_xx * fork_U_yx
        + fork_base_second_moment_yy * (fork_alpha_z + fork_U_2);
    const real fork_inertia_force_3 = fork_inertia_force_2 + fork_base_inertia_xz * (fork_alpha_x
        + fork_U_3);
    work[255] = fork_inertia_force_3;
    const real fork_inertia_force_4 = fork_base_moment_x * fork_U_4;
    const real fork_f_y = fork_base_moment_x * fork_U_yx;
    const real fork_f_z = fork_base_moment_x * fork_U_zx;
    const real fork_f = steer_R_2 * fork_inertia_force_4 - steer_R_3 * fork_f_y - div_1 * fork_f_z;
    work[256] = fork_f;
    const real fork_f_2 = steer_cos * fork_inertia_force_4 + steer_sin * fork_f_y;
    work[257] = fork_f_2;
    const real fork_f_3 = steer_R_4 * fork_inertia_force_4 - steer_R_5 * fork_f_y
        + steer_R_zz * fork_f_z;
    work[258] = fork_f_3;

    /* frame: momentum, f */
    const real frame_momentum_5 = rear_hub_sin * fork_momentum_8 - rear_hub_cos * fork_momentum_7;
    const real frame_momentum_6 = rear_hub_sin * fork_momentum_7 + rear_hub_cos * fork_momentum_8;
    const real frame_f_x = frame_base_moment_z * frame_U_xz - frame_base_moment_x * frame_U_3
        + fork_f;
    work[259] = frame_f_x;
    const real frame_f_y = frame_base_moment_x * frame_U_yx + frame_base_moment_z * frame_U_yz
        - fork_f_2;
    work[260] = frame_f_y;
    const real frame_f_z = frame_base_moment_x * frame_U_zx - frame_base_moment_z * frame_U_4
        + fork_f_3;
    work[261] = frame_f_z;

    /* shared by several: momentum, M */
    const real rear_wheel_momentum = rear_contact_sin * M_7_5
        - rear_contact_R_6 * frame_momentum_5 + rear_contact_R_zz * frame_momentum_6;
    const real rear_contact_M_9 = rear_contact_sin * rear_wheel_composite_inertia_yy
        - rear_contact_M_5 + rear_contact_R_zz * rear_wheel_composite_inertia_yz;

    /* M */
    const real M_7_3 = rear_wheel_momentum - rear_contact_S_2 * frame_momentum_3
        + rear_contact_S_3 * frame_momentum_4;
    work[262] = M_7_3;
    const real M_7_4 = rear_contact_R * frame_momentum_5 + rear_contact_R_2 * frame_momentum_6
        + steer_M;
    work[263] = M_7_4;
    const real M_5_3 = rear_contact_M_6 + rear_contact_M_9 - rear_contact_M_7;
    work[264] = M_5_3;

    /* rear_contact: momentum my, momentum fy, M, momentum mx, momentum mz, momentum fx, ... */
    const wreal rear_wheel_base_mass = w[21];
    const wreal rear_contact_M = w[36];
    const real rear_contact_momentum_my = rear_contact_R_xx * rear_wheel_composite_moment_z
        - rear_contact_R_xz * rear_wheel_composite_moment_x;
    work[265] = rear_contact_momentum_my;
    const real rear_contact_momentum_my_2 = rear_contact_R_yx * rear_wheel_composite_moment_z
        - rear_contact_R_yz * rear_wheel_composite_moment_x;
    work[266] = rear_contact_momentum_my_2;
    const real rear_contact_momentum_fy_2 = rear_contact_R_6 * rear_wheel_composite_moment_z
        + rear_contact_R_zz * rear_wheel_composite_moment_x;
    const real rear_contact_M_10 = rear_contact_sin * rear_wheel_composite_inertia_xy
        - rear_contact_R_6 * rear_wheel_composite_inertia_xx;
    const real rear_contact_M_11 = rear_contact_M_10
        + rear_contact_R_zz * rear_wheel_composite_inertia_xz;
    const real rear_contact_M_12 = rear_contact_sin * rear_wheel_composite_inertia_yz
        - rear_contact_R_6 * rear_wheel_composite_inertia_xz;
    const real rear_contact_M_13 = rear_contact_M_12
        + rear_contact_R_zz * rear_wheel_composite_inertia_zz;
    const real rear_contact_momentum_mx = rear_contact_M_11
        + rear_contact_S_3 * frame_composite_moment_y;
    const real rear_contact_momentum_my_3 = rear_contact_M_6 - rear_contact_M_7 + rear_contact_M_9;
    const real rear_contact_momentum_mz = rear_contact_M_13
        - rear_contact_S_2 * frame_composite_moment_y;
    work[267] = rear_contact_momentum_mz;
    const real rear_contact_M_14 = rear_contact_R_zz * frame_composite_moment_y
        - rear_contact_sin * rear_wheel_composite_moment_z;
    const real rear_contact_M_15 = rear_contact_sin * rear_wheel_composite_moment_x
        + rear_contact_R_6 * frame_composite_moment_y;
    const real rear_contact_momentum_fx_3 = rear_wheel_base_mass * rear_contact_S_2
        - rear_contact_M_14;
    work[268] = rear_contact_momentum_fx_3;
    const real rear_contact_momentum_fz_3 = rear_wheel_base_mass * rear_contact_S_3
        - rear_contact_M_15;
    work[269] = rear_contact_momentum_fz_3;
    const real rear_contact_M_16 = rear_contact_R * rear_wheel_composite_inertia_xx
        + rear_contact_R_2 * rear_wheel_composite_inertia_xz;
    const real rear_contact_momentum_my_4 = rear_contact_M_8
        + rear_contact_R_2 * rear_wheel_composite_inertia_yz;
    work[270] = rear_contact_momentum_my_4;
    const real rear_contact_M_17 = rear_contact_R * rear_wheel_composite_inertia_xz
        + rear_contact_R_2 * rear_wheel_composite_inertia_zz;
    const real rear_contact_momentum_mx_2 = rear_contact_M_16
        + rear_radius * rear_wheel_composite_moment_z;
    const real rear_contact_momentum_mz_2 = rear_contact_M_17
        - rear_radius * rear_wheel_composite_moment_x;
    work[271] = rear_contact_momentum_mz_2;
    const real rear_contact_M_18 = rear_contact_R_2 * frame_composite_moment_y;
    work[272] = rear_contact_M_18;
    const real rear_contact_momentum_fz_4 = rear_contact_R * frame_composite_moment_y;
    work[273] = rear_contact_momentum_fz_4;
    const real rear_contact_M_19 = rear_contact_R * rear_wheel_composite_moment_z
        - rear_contact_R_2 * rear_wheel_composite_moment_x + rear_contact_M;

    /* rear_hub: M */
    const real rear_hub_M = rear_contact_sin * frame_composite_inertia_yy - rear_contact_M_5
        + rear_contact_R_zz * rear_wheel_inertia_4 + rear_contact_M_6;

    /* M */
    const real M_6_3 = rear_hub_M - rear_contact_M_7;
    work[274] = M_6_3;
    const real M_4_1 = rear_contact_R_3 * rear_contact_M_19
        - rear_contact_R_xx * rear_contact_M_18 + rear_contact_R_xz * rear_contact_momentum_fz_4;
    work[275] = M_4_1;
    const real M_4_2 = rear_contact_R_yz * rear_contact_momentum_fz_4
        - (rear_contact_R_yx * rear_contact_M_18 + rear_contact_R_yy * rear_contact_M_19);
    work[276] = M_4_2;
    const real M_4_4 = rear_contact_R * rear_contact_momentum_mx_2
        + rear_contact_R_2 * rear_contact_momentum_mz_2 + rear_radius * rear_contact_M_19;
    work[277] = M_4_4;

    /* shared by several: M */
    const real rear_contact_M_20 = rear_contact_R_xx * rear_contact_momentum_fx_3
        - rear_contact_R_3 * rear_contact_momentum_fy_2;
    work[278] = rear_contact_M_20;
    const real rear_contact_M_21 = rear_contact_R_yx * rear_contact_momentum_fx_3
        + rear_contact_R_yy * rear_contact_momentum_fy_2;
    work[279] = rear_contact_M_21;
    const real rear_contact_M_22 = rear_contact_sin * rear_contact_momentum_my_3
        - rear_contact_R_6 * rear_contact_momentum_mx;
    work[280] = rear_contact_M_22;
    const real rear_contact_M_23 = rear_contact_sin * rear_contact_momentum_my_4
        - rear_contact_R_6 * rear_contact_momentum_mx_2;
    work[281] = rear_contact_M_23;
    return CARDAN_OK;
}

CARDAN_PART int forward_dynamics_part3(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const u = in->u;
    const wreal *const w = in->w;
    const real *const tau = in->tau;
    (void)out;

    /* M */
    const real rear_contact_M_20 = work[278];
    const real rear_contact_R_xz = work[72];
    const real rear_contact_momentum_fz_3 = work[269];
    const real M_3_1 = rear_contact_M_20 + rear_contact_R_xz * rear_contact_momentum_fz_3;
    const real rear_contact_M_21 = work[279];
    const real rear_contact_R_yz = work[74];
    const real M_3_2 = rear_contact_M_21 + rear_contact_R_yz * rear_contact_momentum_fz_3;

    /* rear_contact: M */
    const real rear_contact_M_22 = work[280];
    const real rear_contact_R_zz = work[76];
    const real rear_contact_momentum_mz = work[267];
    const real rear_contact_S_2 = work[85];
    const real rear_contact_momentum_fx_3 = work[268];
    const real rear_contact_M_24 = rear_contact_M_22
        + rear_contact_R_zz * rear_contact_momentum_mz
        + rear_contact_S_2 * rear_contact_momentum_fx_3;
    const real rear_contact_M_23 = work[281];
    const real rear_contact_momentum_mz_2 = work[271];
    const real rear_contact_M_18 = work[272];
    const real rear_contact_M_25 = rear_contact_M_23
        + rear_contact_R_zz * rear_contact_momentum_mz_2 - rear_contact_S_2 * rear_contact_M_18;

    /* M */
    const real rear_contact_S_3 = work[86];
    const real M_3_3 = rear_contact_M_24 + rear_contact_S_3 * rear_contact_momentum_fz_3;
    const real rear_contact_momentum_fz_4 = work[273];
    const real M_4_3 = rear_contact_M_25 + rear_contact_S_3 * rear_contact_momentum_fz_4;

    /* front_wheel: alpha, omega, U, inertia force, n, f */
    const real front_hub_u = u[7]; /* rad/s */
    const wreal front_hub_R_yy = w[7];
    const wreal front_wheel_base_second_moment_xx = w[26];
    const wreal front_wheel_base_second_moment_zz = w[27];
    const real front_hub_sin = work[66];
    const real fork_omega_x = work[243];
    const real front_hub_R_2 = work[133];
    const real fork_omega_z = work[245];
    const real front_wheel_alpha = front_hub_sin * fork_omega_x + front_hub_R_2 * fork_omega_z;
    const real front_hub_cos = work[65];
    const real front_hub_R_3 = work[134];
    const real front_wheel_omega_z = front_hub_cos * fork_omega_x - front_hub_R_3 * fork_omega_z;
    const real fork_alpha = work[244];
    const real front_wheel_omega_y = front_hub_u - front_hub_R_yy * fork_alpha;
    const real fork_alpha_y = work[248];
    const real front_wheel_alpha_y = front_hub_R_yy * fork_alpha_y;
    const real fork_alpha_x = work[247];
    const real fork_alpha_z = work[246];
    const real front_wheel_alpha_2 = front_hub_sin * fork_alpha_x + front_hub_R_2 * fork_alpha_z
        + front_hub_u * front_wheel_omega_z;
    const real front_wheel_alpha_z = front_hub_cos * fork_alpha_x - front_hub_R_3 * fork_alpha_z
        - front_hub_u * front_wheel_alpha;
    const real front_wheel_U = front_wheel_alpha * front_wheel_omega_z;
    const real front_wheel_U_xz = front_wheel_alpha_y - front_wheel_U;
    const real front_wheel_U_yx = front_wheel_alpha_z - front_wheel_alpha * front_wheel_omega_y;
    const real front_wheel_U_yz = front_wheel_alpha_2 + front_wheel_omega_z * front_wheel_omega_y;
    const real front_wheel_inertia_force = front_wheel_base_second_moment_zz * front_wheel_U_yz;
    const real front_wheel_inertia_force_2 = front_wheel_base_second_moment_xx *
        (front_wheel_alpha_y + front_wheel_U);
    const real front_wheel_n_y = front_wheel_base_second_moment_zz * front_wheel_U_xz
        + front_wheel_inertia_force_2;
    const real front_wheel_n_z = front_wheel_base_second_moment_xx * front_wheel_U_yx;
    const real front_wheel_f = front_hub_sin * front_wheel_inertia_force
        + front_hub_cos * front_wheel_n_z;
    const real front_wheel_f_2 = front_hub_R_2 * front_wheel_inertia_force
        - front_hub_R_3 * front_wheel_n_z;

    /* fork: n, f */
    const wreal rear_radius = w[0]; /* m */
    const wreal steer_place_x = w[4];
    const wreal div_1 = w[5];
    const wreal steer_R_zz = w[6];
    const wreal fork_base_moment_x = w[13];
    const wreal fork_base_inertia_xz = w[14];
    const wreal fork_base_second_moment_yy = w[29];
    const real fork_U_zy = work[253];
    const real fork_U_yx = work[252];
    const real fork_n_x = fork_base_second_moment_yy * fork_U_zy
        + fork_base_inertia_xz * fork_U_yx + front_wheel_f;
    const real fork_inertia_force = work[254];
    const real fork_a_z = work[251];
    const real fork_n_y = front_hub_R_yy * front_wheel_n_y - (fork_inertia_force
        + fork_base_moment_x * fork_a_z);
    const real fork_inertia_force_3 = work[255];
    const real fork_a_3 = work[250];
    const real steer_R_5 = work[107];
    const real fork_a_2 = work[249];
    const real fork_n_z = fork_inertia_force_3 - fork_base_moment_x * (fork_a_3
        + steer_R_5 * fork_a_2) + front_wheel_f_2;
    const real steer_R_2 = work[104];
    const real steer_R_3 = work[105];
    const real fork_f_2 = work[257];
    const real fork_f_4 = steer_R_2 * fork_n_x + steer_R_3 * fork_n_y + div_1 * fork_n_z
        + rear_radius * fork_f_2;
    const real steer_cos = work[63];
    const real steer_sin = work[64];
    const real fork_f = work[256];
    const real fork_f_3 = work[258];
    const real fork_f_5 = steer_cos * fork_n_x - steer_sin * fork_n_y - (rear_radius * fork_f
        + steer_place_x * fork_f_3);
    const real steer_R_4 = work[106];
    const real fork_f_6 = steer_R_zz * fork_n_z - (steer_R_4 * fork_n_x + steer_R_5 * fork_n_y)
        - steer_place_x * fork_f_2;

    /* frame: n */
    const wreal frame_base_moment_x = w[16];
    const wreal frame_base_moment_z = w[17];
    const real frame_inertia_force = work[230];
    const real rear_wheel_a_y = work[181];
    const real frame_n = frame_inertia_force + frame_base_moment_z * rear_wheel_a_y + fork_f_4;
    const real frame_inertia_force_3 = work[231];
    const real frame_a_x = work[228];
    const real frame_a_z = work[229];
    const real frame_n_y = frame_base_moment_z * frame_a_x - frame_base_moment_x * frame_a_z
        + frame_inertia_force_3 + fork_f_5;
    const real frame_inertia_force_4 = work[232];
    const real frame_n_z = frame_inertia_force_4 + frame_base_moment_x * rear_wheel_a_y + fork_f_6;

    /* rear_wheel: n, f */
    const wreal rear_wheel_base_mass = w[21];
    const wreal rear_wheel_base_second_moment_xx = w[24];
    const wreal rear_wheel_base_second_moment_zz = w[25];
    const real rear_wheel_inertia_force = work[185];
    const real rear_hub_sin = work[62];
    const real rear_hub_cos = work[61];
    const real rear_wheel_n_x = rear_hub_sin * frame_n_z - rear_hub_cos * frame_n
        + rear_wheel_inertia_force;
    const real rear_wheel_U_xz = work[183];
    const real rear_wheel_U_zx = work[184];
    const real rear_wheel_n_y = rear_wheel_base_second_moment_zz * rear_wheel_U_xz
        - rear_wheel_base_second_moment_xx * rear_wheel_U_zx + frame_n_y;
    const real rear_wheel_inertia_force_2 = work[186];
    const real rear_wheel_n_z = rear_hub_sin * frame_n + rear_hub_cos * frame_n_z
        + rear_wheel_inertia_force_2;
    const real rear_wheel_a_x = work[180];
    const real frame_f_x = work[259];
    const real frame_f_z = work[261];
    const real rear_wheel_f_x = rear_hub_cos * frame_f_x + rear_hub_sin * frame_f_z
        + rear_wheel_base_mass * rear_wheel_a_x;
    const real frame_f_y = work[260];
    const real rear_wheel_f_y = rear_wheel_base_mass * rear_wheel_a_y + frame_f_y;
    const real rear_wheel_a_z = work[182];
    const real rear_wheel_f_z = rear_hub_cos * frame_f_z - rear_hub_sin * frame_f_x
        + rear_wheel_base_mass * rear_wheel_a_z;

    /* rear_contact: tau, tau yaw, tau lean, drive, drive yaw, drive lean, drive spin */
    const real rear_contact_u_x_tau = tau[0]; /* N */
    const real rear_contact_u_y_tau = tau[1]; /* N */
    const real rear_contact_u_yaw_tau = tau[2]; /* N*m */
    const real rear_contact_u_lean_tau = tau[3]; /* N*m */
    const real rear_contact_u_spin_tau = tau[4]; /* N*m */
    const real rear_contact_R_xx = work[71];
    const real rear_contact_R_3 = work[67];
    const real rear_contact_tau_x = rear_contact_R_xx * rear_wheel_f_x
        - rear_contact_R_3 * rear_wheel_f_y + rear_contact_R_xz * rear_wheel_f_z;
    const real rear_contact_R_yx = work[73];
    const real rear_contact_R_yy = work[69];
    const real rear_contact_tau_y = rear_contact_R_yx * rear_wheel_f_x
        + rear_contact_R_yy * rear_wheel_f_y + rear_contact_R_yz * rear_wheel_f_z;
    const real rear_contact_sin = work[58];
    const real rear_contact_R_6 = work[75];
    const real rear_contact_tau = rear_contact_sin * rear_wheel_n_y
        - rear_contact_R_6 * rear_wheel_n_x + rear_contact_R_zz * rear_wheel_n_z;
    const real rear_contact_tau_yaw = rear_contact_tau + rear_contact_S_2 * rear_wheel_f_x
        + rear_contact_S_3 * rear_wheel_f_z;
    const real rear_contact_R = work[59];
    const real rear_contact_R_2 = work[60];
    const real rear_contact_tau_lean = rear_contact_R * rear_wheel_n_x
        + rear_contact_R_2 * rear_wheel_n_z - rear_radius * rear_wheel_f_y;
    const real rear_contact_drive_x = rear_contact_u_x_tau - rear_contact_tau_x;
    const real rear_contact_drive_y = rear_contact_u_y_tau - rear_contact_tau_y;
    const real rear_contact_drive_yaw = rear_contact_u_yaw_tau - rear_contact_tau_yaw;
    const real rear_contact_drive_lean = rear_contact_u_lean_tau - rear_contact_tau_lean;
    const real rear_contact_drive_spin = rear_contact_u_spin_tau - rear_wheel_n_y;

    /* rear_hub: drive */
    const real rear_hub_u_tau = tau[5]; /* N*m */
    const real rear_hub_drive = rear_hub_u_tau - frame_n_y;

    /* steer: drive */
    const real steer_u_tau = tau[6]; /* N*m */
    const real steer_drive = steer_u_tau - fork_n_z;

    /* front_hub: drive */
    const real front_hub_u_tau = tau[7]; /* N*m */
    const real front_hub_drive = front_hub_u_tau - front_wheel_n_y;

    /* front_contact: G */
    const real front_contact_twist_76 = work[141];
    const real mul_1_5 = work[223];
    const real front_contact_twist_78 = work[142];
    const real mul_1_6 = work[224];
    const real front_contact_pose_26 = work[139];
    const real front_contact_twist_80 = work[143];
    const real front_contact_G_84 = front_contact_twist_76 * mul_1_5
        + front_contact_twist_78 * mul_1_6 - front_contact_pose_26 * front_contact_twist_80;
    const real front_contact_pose_18 = work[113];
    const real front_contact_twist_53 = work[120];
    const real front_contact_pose_27 = work[140];
    const real front_contact_twist_82 = work[144];
    const real front_contact_G_85 = front_contact_G_84
        + front_contact_pose_18 * front_contact_twist_53
        + front_contact_pose_27 * front_contact_twist_82;
    const real front_contact_twist_84 = work[145];
    const real front_contact_twist_86 = work[146];
    const real front_contact_twist_88 = work[147];
    const real front_contact_G_86 = front_contact_twist_84 * mul_1_5
        + front_contact_twist_86 * mul_1_6 - front_contact_pose_26 * front_contact_twist_88;
    const real front_contact_twist_57 = work[121];
    const real front_contact_twist_90 = work[148];
    const real front_contact_G_87 = front_contact_G_86
        + front_contact_pose_18 * front_contact_twist_57
        + front_contact_pose_27 * front_contact_twist_90;
    work[57] = front_contact_G_87;
    const real front_contact_twist_94 = work[150];
    const real front_contact_twist_92 = work[149];
    const real front_contact_twist_96 = work[151];
    const real front_contact_G_88 = front_contact_twist_94 * mul_1_6
        - front_contact_twist_92 * mul_1_5 - front_contact_pose_26 * front_contact_twist_96;
    const real front_contact_twist_61 = work[122];
    const real front_contact_twist_98 = work[152];
    const real front_contact_G_89 = front_contact_G_88
        + front_contact_pose_18 * front_contact_twist_61
        + front_contact_pose_27 * front_contact_twist_98;
    work[68] = front_contact_G_89;
    const real front_contact_twist_100 = work[153];
    const real front_contact_twist_102 = work[154];
    const real front_contact_twist_104 = work[155];
    const real front_contact_G_90 = front_contact_twist_100 * mul_1_5
        + front_contact_twist_102 * mul_1_6 - front_contact_pose_26 * front_contact_twist_104;
    const real front_contact_twist_65 = work[123];
    const real front_contact_twist_106 = work[156];
    const real front_contact_G_91 = front_contact_G_90
        + front_contact_pose_18 * front_contact_twist_65
        + front_contact_pose_27 * front_contact_twist_106;
    work[70] = front_contact_G_91;
    const real front_contact_twist_109 = work[157];
    const real front_contact_twist_112 = work[158];
    const real front_contact_G_92 = front_contact_twist_109 * mul_1_5
        + front_contact_twist_112 * mul_1_6;
    work[77] = front_contact_G_92;

    /* constraints: multipliers, L, D inverse */
    const wreal constraints_D_inverse_8 = w[37];
    const real constraints_multipliers_190 = work[211];
    const real constraints_multipliers_221 = work[213];
    const real constraints_multipliers_257 = mul_1_5 * constraints_multipliers_190
        + constraints_multipliers_221;
    const real constraints_multipliers_198 = work[212];
    const real constraints_multipliers_222 = work[214];
    const real constraints_multipliers_223 = work[215];
    const real constraints_multipliers_258 = mul_1_6 * constraints_multipliers_198
        + constraints_multipliers_222 + constraints_multipliers_257 - constraints_multipliers_223;
    const real constraints_multipliers_224 = work[216];
    const real constraints_multipliers_225 = work[217];
    const real constraints_multipliers_259 = constraints_multipliers_258
        + constraints_multipliers_224 + constraints_multipliers_225;
    work[78] = constraints_multipliers_259;
    const real fork_momentum_2 = work[226];
    const real constraints_multipliers_260 = fork_momentum_2 * constraints_D_inverse_8;
    work[79] = constraints_multipliers_260;
    const real M_8_3 = work[234];
    const real constraints_multipliers_261 = M_8_3 * constraints_multipliers_260;
    const real M_8_4 = work[235];
    const real constraints_multipliers_262 = M_8_4 * constraints_multipliers_260;
    const real constraints_multipliers_263 = fork_momentum_2 * constraints_multipliers_260;
    const real constraints_L_8_4 = M_8_4 * constraints_D_inverse_8;
    const real constraints_L_8_3 = M_8_3 * constraints_D_inverse_8;
    const real fork_composite_inertia_zz = work[225];
    const real constraints_D_inverse_7 = 1.0 / fork_composite_inertia_zz;
    const real M_7_5 = work[236];
    const real constraints_L_7_5 = M_7_5 * constraints_D_inverse_7;
    work[80] = constraints_L_7_5;
    const real rear_contact_momentum_my = work[265];
    const real M_7_1 = work[237];
    const real constraints_multipliers_264 = rear_contact_momentum_my - M_7_1 * constraints_L_7_5;
    const real rear_contact_momentum_my_2 = work[266];
    const real M_7_2 = work[238];
    const real constraints_multipliers_265 = rear_contact_momentum_my_2 - M_7_2 * constraints_L_7_5;
    const real M_7_3 = work[262];
    const real constraints_multipliers_266 = M_7_3 * constraints_L_7_5;
    const real M_6_3 = work[274];
    const real constraints_multipliers_267 = M_6_3 + constraints_multipliers_261
        - constraints_multipliers_266;
    const real M_7_4 = work[263];
    const real constraints_multipliers_268 = M_7_4 * constraints_L_7_5;
    const real M_6_4 = work[239];
    const real constraints_multipliers_269 = M_6_4 + constraints_multipliers_262
        - constraints_multipliers_268;
    const real constraints_multipliers_270 = M_7_5 * constraints_L_7_5;
    const real frame_composite_inertia_yy = work[227];
    const real constraints_multipliers_271 = frame_composite_inertia_yy
        - constraints_multipliers_263 - constraints_multipliers_270;
    const real rear_contact_momentum_my_4 = work[270];
    const real constraints_multipliers_272 = rear_contact_momentum_my_4
        + constraints_multipliers_262 - constraints_multipliers_268;
    const real rear_wheel_composite_inertia_yy = work[233];
    const real constraints_multipliers_273 = rear_wheel_composite_inertia_yy
        - constraints_multipliers_263 - constraints_multipliers_270;
    const real constraints_L_7_4 = M_7_4 * constraints_D_inverse_7;
    const real constraints_multipliers_274 = M_4_3 - M_8_3 * constraints_L_8_4
        - M_7_3 * constraints_L_7_4;
    const real M_4_4 = work[277];
    const real constraints_multipliers_275 = M_4_4 - M_8_4 * constraints_L_8_4
        - M_7_4 * constraints_L_7_4;
    const real constraints_L_7_3 = M_7_3 * constraints_D_inverse_7;
    const real constraints_multipliers_276 = M_3_3 - M_8_3 * constraints_L_8_3
        - M_7_3 * constraints_L_7_3;
    const real constraints_L_7_2 = M_7_2 * constraints_D_inverse_7;
    const real constraints_L_7_1 = M_7_1 * constraints_D_inverse_7;
    const real constraints_D_inverse_6 = 1.0 / constraints_multipliers_271;
    const real constraints_L_6_5 = constraints_multipliers_271 * constraints_D_inverse_6;
    const real constraints_multipliers_277 = constraints_multipliers_264
        - constraints_multipliers_264 * constraints_L_6_5;
    const real constraints_multipliers_278 = constraints_multipliers_265
        - constraints_multipliers_265 * constraints_L_6_5;
    const real M_5_3 = work[264];
    const real constraints_multipliers_279 = M_5_3 + constraints_multipliers_261
        - constraints_multipliers_266 - constraints_multipliers_267 * constraints_L_6_5;
    const real constraints_multipliers_280 = constraints_multipliers_272
        - constraints_multipliers_269 * constraints_L_6_5;
    const real constraints_L_6_4 = constraints_multipliers_269 * constraints_D_inverse_6;
    const real M_4_1 = work[275];
    const real constraints_multipliers_281 = M_4_1 - M_7_1 * constraints_L_7_4
        - constraints_multipliers_264 * constraints_L_6_4;
    const real M_4_2 = work[276];
    const real constraints_multipliers_282 = M_4_2 - M_7_2 * constraints_L_7_4
        - constraints_multipliers_265 * constraints_L_6_4;
    const real constraints_multipliers_283 = constraints_multipliers_274
        - constraints_multipliers_267 * constraints_L_6_4;
    const real constraints_multipliers_284 = constraints_multipliers_275
        - constraints_multipliers_269 * constraints_L_6_4;
    const real constraints_L_6_3 = constraints_multipliers_267 * constraints_D_inverse_6;
    const real constraints_multipliers_285 = M_3_1 - M_7_1 * constraints_L_7_3
        - constraints_multipliers_264 * constraints_L_6_3;
    const real constraints_multipliers_286 = M_3_2 - M_7_2 * constraints_L_7_3
        - constraints_multipliers_265 * constraints_L_6_3;
    const real constraints_multipliers_287 = constraints_multipliers_276
        - constraints_multipliers_267 * constraints_L_6_3;
    const real constraints_L_6_2 = constraints_multipliers_265 * constraints_D_inverse_6;
    const real M_2_1 = work[241];
    const real constraints_multipliers_288 = M_2_1 - M_7_1 * constraints_L_7_2
        - constraints_multipliers_264 * constraints_L_6_2;
    const real M_2_2 = work[242];
    const real constraints_multipliers_289 = M_2_2 - M_7_2 * constraints_L_7_2
        - constraints_multipliers_265 * constraints_L_6_2;
    const real constraints_L_6_1 = constraints_multipliers_264 * constraints_D_inverse_6;
    const real M_1_1 = work[240];
    const real constraints_multipliers_290 = M_1_1 - M_7_1 * constraints_L_7_1
        - constraints_multipliers_264 * constraints_L_6_1;
    const real constraints_D_inverse_5 = 1.0 / (constraints_multipliers_273
        - constraints_multipliers_271 * constraints_L_6_5);
    const real constraints_L_5_4 = constraints_multipliers_280 * constraints_D_inverse_5;
    const real constraints_multipliers_291 = constraints_multipliers_281
        - constraints_multipliers_277 * constraints_L_5_4;
    const real constraints_multipliers_292 = constraints_multipliers_282
        - constraints_multipliers_278 * constraints_L_5_4;
    const real constraints_multipliers_293 = constraints_multipliers_283
        - constraints_multipliers_279 * constraints_L_5_4;
    const real constraints_L_5_3 = constraints_multipliers_279 * constraints_D_inverse_5;
    const real constraints_multipliers_294 = constraints_multipliers_285
        - constraints_multipliers_277 * constraints_L_5_3;
    const real constraints_multipliers_295 = constraints_multipliers_286
        - constraints_multipliers_278 * constraints_L_5_3;
    const real constraints_multipliers_296 = constraints_multipliers_287
        - constraints_multipliers_279 * constraints_L_5_3;
    const real constraints_L_5_2 = constraints_multipliers_278 * constraints_D_inverse_5;
    const real constraints_multipliers_297 = constraints_multipliers_288
        - constraints_multipliers_277 * constraints_L_5_2;
    const real constraints_multipliers_298 = constraints_multipliers_289
        - constraints_multipliers_278 * constraints_L_5_2;
    const real constraints_L_5_1 = constraints_multipliers_277 * constraints_D_inverse_5;
    const real constraints_multipliers_299 = constraints_multipliers_290
        - constraints_multipliers_277 * constraints_L_5_1;
    const real constraints_D_inverse_4 = 1.0 / (constraints_multipliers_284
        - constraints_multipliers_280 * constraints_L_5_4);
    const real constraints_L_4_3 = constraints_multipliers_293 * constraints_D_inverse_4;
    const real constraints_multipliers_300 = constraints_multipliers_294
        - constraints_multipliers_291 * constraints_L_4_3;
    const real constraints_multipliers_301 = constraints_multipliers_295
        - constraints_multipliers_292 * constraints_L_4_3;
    const real constraints_L_4_2 = constraints_multipliers_292 * constraints_D_inverse_4;
    const real constraints_multipliers_302 = constraints_multipliers_297
        - constraints_multipliers_291 * constraints_L_4_2;
    const real constraints_multipliers_303 = constraints_multipliers_298
        - constraints_multipliers_292 * constraints_L_4_2;
    const real constraints_L_4_1 = constraints_multipliers_291 * constraints_D_inverse_4;
    const real constraints_multipliers_304 = constraints_multipliers_299
        - constraints_multipliers_291 * constraints_L_4_1;
    const real constraints_D_inverse_3 = 1.0 / (constraints_multipliers_296
        - constraints_multipliers_293 * constraints_L_4_3);
    const real constraints_L_3_2 = constraints_multipliers_301 * constraints_D_inverse_3;
    const real constraints_multipliers_305 = constraints_multipliers_302
        - constraints_multipliers_300 * constraints_L_3_2;
    const real constraints_L_3_1 = constraints_multipliers_300 * constraints_D_inverse_3;
    const real constraints_multipliers_306 = constraints_multipliers_304
        - constraints_multipliers_300 * constraints_L_3_1;
    const real constraints_D_inverse_2 = 1.0 / (constraints_multipliers_303
        - constraints_multipliers_301 * constraints_L_3_2);
    const real constraints_L_2_1 = constraints_multipliers_305 * constraints_D_inverse_2;
    const real constraints_D_inverse_1 = 1.0 / (constraints_multipliers_306
        - constraints_multipliers_305 * constraints_L_2_1);
    const real constraints_multipliers_307 = front_hub_drive * constraints_multipliers_260;
    const real constraints_multipliers_308 = rear_contact_drive_yaw
        - front_hub_drive * constraints_L_8_3 - steer_drive * constraints_L_7_3;
    const real constraints_multipliers_309 = rear_contact_drive_lean
        - front_hub_drive * constraints_L_8_4 - steer_drive * constraints_L_7_4;
    const real constraints_multipliers_310 = steer_drive * constraints_L_7_5;
    const real constraints_multipliers_311 = rear_contact_drive_spin
        + constraints_multipliers_307 - constraints_multipliers_310;
    const real constraints_multipliers_312 = rear_hub_drive + constraints_multipliers_307
        - constraints_multipliers_310;
    const real constraints_multipliers_313 = rear_contact_drive_x
        - steer_drive * constraints_L_7_1 - constraints_L_6_1 * constraints_multipliers_312;
    const real constraints_multipliers_314 = rear_contact_drive_y
        - steer_drive * constraints_L_7_2 - constraints_L_6_2 * constraints_multipliers_312;
    const real constraints_multipliers_315 = constraints_multipliers_308
        - constraints_L_6_3 * constraints_multipliers_312;
    const real constraints_multipliers_316 = constraints_multipliers_309
        - constraints_L_6_4 * constraints_multipliers_312;
    const real constraints_multipliers_317 = constraints_multipliers_311
        - constraints_L_6_5 * constraints_multipliers_312;
    const real constraints_multipliers_318 = constraints_multipliers_313
        - constraints_L_5_1 * constraints_multipliers_317;
    const real constraints_multipliers_319 = constraints_multipliers_314
        - constraints_L_5_2 * constraints_multipliers_317;
    const real constraints_multipliers_320 = constraints_multipliers_315
        - constraints_L_5_3 * constraints_multipliers_317;
    const real constraints_multipliers_321 = constraints_multipliers_316
        - constraints_L_5_4 * constraints_multipliers_317;
    const real constraints_multipliers_322 = constraints_multipliers_318
        - constraints_L_4_1 * constraints_multipliers_321;
    const real constraints_multipliers_323 = constraints_multipliers_319
        - constraints_L_4_2 * constraints_multipliers_321;
    const real constraints_multipliers_324 = constraints_multipliers_320
        - constraints_L_4_3 * constraints_multipliers_321;
    const real constraints_multipliers_325 = constraints_multipliers_322
        - constraints_L_3_1 * constraints_multipliers_324;
    const real constraints_multipliers_326 = constraints_multipliers_323
        - constraints_L_3_2 * constraints_multipliers_324;
    const real constraints_multipliers_327 = constraints_D_inverse_1 * (constraints_multipliers_325
        - constraints_L_2_1 * constraints_multipliers_326);
    work[81] = constraints_multipliers_327;
    const real constraints_multipliers_328 = constraints_D_inverse_2 * constraints_multipliers_326 -
        constraints_L_2_1 * constraints_multipliers_327;
    work[82] = constraints_multipliers_328;
    const real constraints_multipliers_329 = constraints_D_inverse_3 * constraints_multipliers_324 -
        constraints_L_3_1 * constraints_multipliers_327;
    const real constraints_multipliers_330 = constraints_multipliers_329
        - constraints_L_3_2 * constraints_multipliers_328;
    work[83] = constraints_multipliers_330;
    const real constraints_multipliers_331 = constraints_D_inverse_4 * constraints_multipliers_321 -
        constraints_L_4_1 * constraints_multipliers_327;
    const real constraints_multipliers_332 = constraints_multipliers_331
        - constraints_L_4_2 * constraints_multipliers_328;
    const real constraints_multipliers_333 = constraints_multipliers_332
        - constraints_L_4_3 * constraints_multipliers_330;
    work[84] = constraints_multipliers_333;
    const real constraints_multipliers_334 = constraints_D_inverse_5 * constraints_multipliers_317 -
        constraints_L_5_1 * constraints_multipliers_327;
    const real constraints_multipliers_335 = constraints_multipliers_334
        - constraints_L_5_2 * constraints_multipliers_328;
    const real constraints_multipliers_336 = constraints_multipliers_335
        - constraints_L_5_3 * constraints_multipliers_330;
    const real constraints_multipliers_337 = constraints_multipliers_336
        - constraints_L_5_4 * constraints_multipliers_333;
    work[87] = constraints_multipliers_337;
    const real constraints_multipliers_338 = constraints_D_inverse_6 * constraints_multipliers_312 -
        constraints_L_6_1 * constraints_multipliers_327;
    const real constraints_multipliers_339 = constraints_multipliers_338
        - constraints_L_6_2 * constraints_multipliers_328;
    const real constraints_multipliers_340 = constraints_multipliers_339
        - constraints_L_6_3 * constraints_multipliers_330;
    const real constraints_multipliers_341 = constraints_multipliers_340
        - constraints_L_6_4 * constraints_multipliers_333;
    const real constraints_multipliers_342 = constraints_multipliers_341
        - constraints_L_6_5 * constraints_multipliers_337;
    work[88] = constraints_multipliers_342;
    const real constraints_multipliers_343 = steer_drive * constraints_D_inverse_7
        - constraints_L_7_1 * constraints_multipliers_327;
    const real constraints_multipliers_344 = constraints_multipliers_343
        - constraints_L_7_2 * constraints_multipliers_328;
    const real constraints_multipliers_345 = constraints_multipliers_344
        - constraints_L_7_3 * constraints_multipliers_330;
    const real constraints_multipliers_346 = constraints_multipliers_345
        - constraints_L_7_4 * constraints_multipliers_333;
    const real constraints_multipliers_347 = constraints_multipliers_346
        - constraints_L_7_5 * constraints_multipliers_337;
    const real constraints_multipliers_348 = constraints_multipliers_347
        - constraints_L_7_5 * constraints_multipliers_342;
    work[89] = constraints_multipliers_348;
    const real constraints_multipliers_349 = front_hub_drive * constraints_D_inverse_8
        - constraints_L_8_3 * constraints_multipliers_330;
    const real constraints_multipliers_350 = constraints_multipliers_349
        - constraints_L_8_4 * constraints_multipliers_333;
    const real constraints_multipliers_351 = constraints_multipliers_350
        + constraints_multipliers_260 * constraints_multipliers_337;
    const real constraints_multipliers_352 = constraints_multipliers_351
        + constraints_multipliers_260 * constraints_multipliers_342;
    work[90] = constraints_multipliers_352;
    const real constraints_multipliers_353 = front_contact_G_85
        - front_contact_G_92 * constraints_L_8_3 - front_contact_G_91 * constraints_L_7_3;
    const real constraints_multipliers_354 = front_contact_G_87
        - front_contact_G_92 * constraints_L_8_4 - front_contact_G_91 * constraints_L_7_4;
    const real constraints_multipliers_355 = front_contact_G_89
        + front_contact_G_92 * constraints_multipliers_260 - front_contact_G_91 * constraints_L_7_5;
    const real front_contact_G_13 = work[159];
    const real constraints_multipliers_356 = front_contact_G_13
        - front_contact_G_91 * constraints_L_7_1 - constraints_L_6_1 * constraints_multipliers_355;
    const real front_contact_G_15 = work[160];
    const real constraints_multipliers_357 = front_contact_G_15
        - front_contact_G_91 * constraints_L_7_2 - constraints_L_6_2 * constraints_multipliers_355;
    const real constraints_multipliers_358 = constraints_multipliers_353
        - constraints_L_6_3 * constraints_multipliers_355;
    const real constraints_multipliers_359 = constraints_multipliers_354
        - constraints_L_6_4 * constraints_multipliers_355;
    const real constraints_multipliers_360 = constraints_multipliers_355
        - constraints_L_6_5 * constraints_multipliers_355;
    const real constraints_multipliers_361 = constraints_multipliers_356
        - constraints_L_5_1 * constraints_multipliers_360;
    const real constraints_multipliers_362 = constraints_multipliers_357
        - constraints_L_5_2 * constraints_multipliers_360;
    const real constraints_multipliers_363 = constraints_multipliers_358
        - constraints_L_5_3 * constraints_multipliers_360;
    const real constraints_multipliers_364 = constraints_multipliers_359
        - constraints_L_5_4 * constraints_multipliers_360;
    const real constraints_multipliers_365 = constraints_multipliers_361
        - constraints_L_4_1 * constraints_multipliers_364;
    const real constraints_multipliers_366 = constraints_multipliers_362
        - constraints_L_4_2 * constraints_multipliers_364;
    const real constraints_multipliers_367 = constraints_multipliers_363
        - constraints_L_4_3 * constraints_multipliers_364;
    const real constraints_multipliers_368 = constraints_multipliers_365
        - constraints_L_3_1 * constraints_multipliers_367;
    const real constraints_multipliers_369 = constraints_multipliers_366
        - constraints_L_3_2 * constraints_multipliers_367;
    const real constraints_multipliers_370 = constraints_D_inverse_1 * (constraints_multipliers_368
        - constraints_L_2_1 * constraints_multipliers_369);
    work[91] = constraints_multipliers_370;
    const real constraints_multipliers_371 = constraints_D_inverse_2 * constraints_multipliers_369 -
        constraints_L_2_1 * constraints_multipliers_370;
    work[92] = constraints_multipliers_371;
    const real constraints_multipliers_372 = constraints_D_inverse_3 * constraints_multipliers_367 -
        constraints_L_3_1 * constraints_multipliers_370;
    const real constraints_multipliers_373 = constraints_multipliers_372
        - constraints_L_3_2 * constraints_multipliers_371;
    work[93] = constraints_multipliers_373;
    const real constraints_multipliers_374 = constraints_D_inverse_4 * constraints_multipliers_364 -
        constraints_L_4_1 * constraints_multipliers_370;
    const real constraints_multipliers_375 = constraints_multipliers_374
        - constraints_L_4_2 * constraints_multipliers_371;
    const real constraints_multipliers_376 = constraints_multipliers_375
        - constraints_L_4_3 * constraints_multipliers_373;
    work[94] = constraints_multipliers_376;
    const real constraints_multipliers_377 = constraints_D_inverse_5 * constraints_multipliers_360 -
        constraints_L_5_1 * constraints_multipliers_370;
    const real constraints_multipliers_378 = constraints_multipliers_377
        - constraints_L_5_2 * constraints_multipliers_371;
    const real constraints_multipliers_379 = constraints_multipliers_378
        - constraints_L_5_3 * constraints_multipliers_373;
    const real constraints_multipliers_380 = constraints_multipliers_379
        - constraints_L_5_4 * constraints_multipliers_376;
    work[95] = constraints_multipliers_380;
    const real constraints_multipliers_381 = constraints_D_inverse_6 * constraints_multipliers_355 -
        constraints_L_6_1 * constraints_multipliers_370;
    const real constraints_multipliers_382 = constraints_multipliers_381
        - constraints_L_6_2 * constraints_multipliers_371;
    const real constraints_multipliers_383 = constraints_multipliers_382
        - constraints_L_6_3 * constraints_multipliers_373;
    const real constraints_multipliers_384 = constraints_multipliers_383
        - constraints_L_6_4 * constraints_multipliers_376;
    const real constraints_multipliers_385 = constraints_multipliers_384
        - constraints_L_6_5 * constraints_multipliers_380;
    work[96] = constraints_multipliers_385;
    const real constraints_multipliers_386 = front_contact_G_91 * constraints_D_inverse_7
        - constraints_L_7_1 * constraints_multipliers_370;
    const real constraints_multipliers_387 = constraints_multipliers_386
        - constraints_L_7_2 * constraints_multipliers_371;
    const real constraints_multipliers_388 = constraints_multipliers_387
        - constraints_L_7_3 * constraints_multipliers_373;
    const real constraints_multipliers_389 = constraints_multipliers_388
        - constraints_L_7_4 * constraints_multipliers_376;
    const real constraints_multipliers_390 = constraints_multipliers_389
        - constraints_L_7_5 * constraints_multipliers_380;
    const real constraints_multipliers_391 = constraints_multipliers_390
        - constraints_L_7_5 * constraints_multipliers_385;
    work[97] = constraints_multipliers_391;
    const real constraints_multipliers_392 = front_contact_G_92 * constraints_D_inverse_8
        - constraints_L_8_3 * constraints_multipliers_373;
    const real constraints_multipliers_393 = constraints_multipliers_392
        - constraints_L_8_4 * constraints_multipliers_376;
    const real constraints_multipliers_394 = constraints_multipliers_393
        + constraints_multipliers_260 * constraints_multipliers_380;
    const real constraints_multipliers_395 = constraints_multipliers_394
        + constraints_multipliers_260 * constraints_multipliers_385;
    work[98] = constraints_multipliers_395;
    const real front_contact_G_82 = work[173];
    const real front_contact_G_38 = work[165];
    const real front_contact_G_74 = work[171];
    const real constraints_multipliers_396 = front_contact_G_82 * constraints_L_8_3
        - front_contact_G_38 + front_contact_G_74 * constraints_L_7_3;
    const real front_contact_G_50 = work[167];
    const real constraints_multipliers_397 = front_contact_G_82 * constraints_L_8_4
        - front_contact_G_50 + front_contact_G_74 * constraints_L_7_4;
    const real front_contact_G_62 = work[169];
    const real constraints_multipliers_398 = front_contact_G_74 * constraints_L_7_5
        - (front_contact_G_62 + front_contact_G_82 * constraints_multipliers_260);
    const real front_contact_G_20 = work[161];
    const real constraints_multipliers_399 = front_contact_G_74 * constraints_L_7_1
        - front_contact_G_20 - constraints_L_6_1 * constraints_multipliers_398;
    const real front_contact_G_26 = work[163];
    const real constraints_multipliers_400 = front_contact_G_74 * constraints_L_7_2
        - front_contact_G_26 - constraints_L_6_2 * constraints_multipliers_398;
    const real constraints_multipliers_401 = constraints_multipliers_396
        - constraints_L_6_3 * constraints_multipliers_398;
    const real constraints_multipliers_402 = constraints_multipliers_397
        - constraints_L_6_4 * constraints_multipliers_398;
    const real constraints_multipliers_403 = constraints_multipliers_398
        - constraints_L_6_5 * constraints_multipliers_398;
    const real constraints_multipliers_404 = constraints_multipliers_399
        - constraints_L_5_1 * constraints_multipliers_403;
    const real constraints_multipliers_405 = constraints_multipliers_400
        - constraints_L_5_2 * constraints_multipliers_403;
    const real constraints_multipliers_406 = constraints_multipliers_401
        - constraints_L_5_3 * constraints_multipliers_403;
    const real constraints_multipliers_407 = constraints_multipliers_402
        - constraints_L_5_4 * constraints_multipliers_403;
    const real constraints_multipliers_408 = constraints_multipliers_404
        - constraints_L_4_1 * constraints_multipliers_407;
    const real constraints_multipliers_409 = constraints_multipliers_405
        - constraints_L_4_2 * constraints_multipliers_407;
    const real constraints_multipliers_410 = constraints_multipliers_406
        - constraints_L_4_3 * constraints_multipliers_407;
    const real constraints_multipliers_411 = constraints_multipliers_408
        - constraints_L_3_1 * constraints_multipliers_410;
    const real constraints_multipliers_412 = constraints_multipliers_409
        - constraints_L_3_2 * constraints_multipliers_410;
    const real constraints_multipliers_413 = constraints_D_inverse_1 * (constraints_multipliers_411
        - constraints_L_2_1 * constraints_multipliers_412);
    work[99] = constraints_multipliers_413;
    const real constraints_multipliers_414 = constraints_D_inverse_2 * constraints_multipliers_412 -
        constraints_L_2_1 * constraints_multipliers_413;
    work[100] = constraints_multipliers_414;
    const real constraints_multipliers_415 = constraints_D_inverse_3 * constraints_multipliers_410 -
        constraints_L_3_1 * constraints_multipliers_413;
    const real constraints_multipliers_416 = constraints_multipliers_415
        - constraints_L_3_2 * constraints_multipliers_414;
    work[101] = constraints_multipliers_416;
    const real constraints_multipliers_417 = constraints_D_inverse_4 * constraints_multipliers_407 -
        constraints_L_4_1 * constraints_multipliers_413;
    const real constraints_multipliers_418 = constraints_multipliers_417
        - constraints_L_4_2 * constraints_multipliers_414;
    const real constraints_multipliers_419 = constraints_multipliers_418
        - constraints_L_4_3 * constraints_multipliers_416;
    work[102] = constraints_multipliers_419;
    const real constraints_multipliers_420 = constraints_D_inverse_5 * constraints_multipliers_403 -
        constraints_L_5_1 * constraints_multipliers_413;
    const real constraints_multipliers_421 = constraints_multipliers_420
        - constraints_L_5_2 * constraints_multipliers_414;
    const real constraints_multipliers_422 = constraints_multipliers_421
        - constraints_L_5_3 * constraints_multipliers_416;
    const real constraints_multipliers_423 = constraints_multipliers_422
        - constraints_L_5_4 * constraints_multipliers_419;
    work[103] = constraints_multipliers_423;
    const real constraints_multipliers_424 = constraints_D_inverse_6 * constraints_multipliers_398 -
        constraints_L_6_1 * constraints_multipliers_413;
    const real constraints_multipliers_425 = constraints_multipliers_424
        - constraints_L_6_2 * constraints_multipliers_414;
    const real constraints_multipliers_426 = constraints_multipliers_425
        - constraints_L_6_3 * constraints_multipliers_416;
    const real constraints_multipliers_427 = constraints_multipliers_426
        - constraints_L_6_4 * constraints_multipliers_419;
    const real constraints_multipliers_428 = constraints_multipliers_427
        - constraints_L_6_5 * constraints_multipliers_423;
    work[108] = constraints_multipliers_428;
    const real constraints_multipliers_429 = front_contact_G_74 * constraints_D_inverse_7
        + constraints_L_7_1 * constraints_multipliers_413;
    const real constraints_multipliers_430 = constraints_multipliers_429
        + constraints_L_7_2 * constraints_multipliers_414;
    const real constraints_multipliers_431 = constraints_multipliers_430
        + constraints_L_7_3 * constraints_multipliers_416;
    const real constraints_multipliers_432 = constraints_multipliers_431
        + constraints_L_7_4 * constraints_multipliers_419;
    const real constraints_multipliers_433 = constraints_multipliers_432
        + constraints_L_7_5 * constraints_multipliers_423;
    const real constraints_multipliers_434 = constraints_multipliers_433
        + constraints_L_7_5 * constraints_multipliers_428;
    work[109] = constraints_multipliers_434;
    const real constraints_multipliers_435 = front_contact_G_82 * constraints_D_inverse_8
        + constraints_L_8_3 * constraints_multipliers_416;
    const real constraints_multipliers_436 = constraints_multipliers_435
        + constraints_L_8_4 * constraints_multipliers_419;
    const real constraints_multipliers_437 = constraints_multipliers_260 *
        constraints_multipliers_423 - constraints_multipliers_436;
    const real constraints_multipliers_438 = constraints_multipliers_437
        + constraints_multipliers_260 * constraints_multipliers_428;
    work[110] = constraints_multipliers_438;
    const real front_contact_G_39 = work[166];
    const real front_contact_G_83 = work[174];
    const real front_contact_G_75 = work[172];
    const real constraints_multipliers_439 = front_contact_G_39
        - front_contact_G_83 * constraints_L_8_3 - front_contact_G_75 * constraints_L_7_3;
    const real front_contact_G_51 = work[168];
    const real constraints_multipliers_440 = front_contact_G_51
        - front_contact_G_83 * constraints_L_8_4 - front_contact_G_75 * constraints_L_7_4;
    const real front_contact_G_63 = work[170];
    const real constraints_multipliers_441 = front_contact_G_63
        + front_contact_G_83 * constraints_multipliers_260 - front_contact_G_75 * constraints_L_7_5;
    const real front_contact_G_21 = work[162];
    const real constraints_multipliers_442 = front_contact_G_21
        - front_contact_G_75 * constraints_L_7_1 - constraints_L_6_1 * constraints_multipliers_441;
    const real front_contact_G_27 = work[164];
    const real constraints_multipliers_443 = front_contact_G_27
        - front_contact_G_75 * constraints_L_7_2 - constraints_L_6_2 * constraints_multipliers_441;
    const real constraints_multipliers_444 = constraints_multipliers_439
        - constraints_L_6_3 * constraints_multipliers_441;
    const real constraints_multipliers_445 = constraints_multipliers_440
        - constraints_L_6_4 * constraints_multipliers_441;
    const real constraints_multipliers_446 = constraints_multipliers_441
        - constraints_L_6_5 * constraints_multipliers_441;
    const real constraints_multipliers_447 = constraints_multipliers_442
        - constraints_L_5_1 * constraints_multipliers_446;
    const real constraints_multipliers_448 = constraints_multipliers_443
        - constraints_L_5_2 * constraints_multipliers_446;
    const real constraints_multipliers_449 = constraints_multipliers_444
        - constraints_L_5_3 * constraints_multipliers_446;
    const real constraints_multipliers_450 = constraints_multipliers_445
        - constraints_L_5_4 * constraints_multipliers_446;
    const real constraints_multipliers_451 = constraints_multipliers_447
        - constraints_L_4_1 * constraints_multipliers_450;
    const real constraints_multipliers_452 = constraints_multipliers_448
        - constraints_L_4_2 * constraints_multipliers_450;
    const real constraints_multipliers_453 = constraints_multipliers_449
        - constraints_L_4_3 * constraints_multipliers_450;
    const real constraints_multipliers_454 = constraints_multipliers_451
        - constraints_L_3_1 * constraints_multipliers_453;
    const real constraints_multipliers_455 = constraints_multipliers_452
        - constraints_L_3_2 * constraints_multipliers_453;
    const real constraints_multipliers_456 = constraints_D_inverse_1 * (constraints_multipliers_454
        - constraints_L_2_1 * constraints_multipliers_455);
    work[111] = constraints_multipliers_456;
    const real constraints_multipliers_457 = constraints_D_inverse_2 * constraints_multipliers_455 -
        constraints_L_2_1 * constraints_multipliers_456;
    work[112] = constraints_multipliers_457;
    const real constraints_multipliers_458 = constraints_D_inverse_3 * constraints_multipliers_453 -
        constraints_L_3_1 * constraints_multipliers_456;
    const real constraints_multipliers_459 = constraints_multipliers_458
        - constraints_L_3_2 * constraints_multipliers_457;
    work[114] = constraints_multipliers_459;
    const real constraints_multipliers_460 = constraints_D_inverse_4 * constraints_multipliers_450 -
        constraints_L_4_1 * constraints_multipliers_456;
    const real constraints_multipliers_461 = constraints_multipliers_460
        - constraints_L_4_2 * constraints_multipliers_457;
    const real constraints_multipliers_462 = constraints_multipliers_461
        - constraints_L_4_3 * constraints_multipliers_459;
    work[115] = constraints_multipliers_462;
    const real constraints_multipliers_463 = constraints_D_inverse_5 * constraints_multipliers_446 -
        constraints_L_5_1 * constraints_multipliers_456;
    const real constraints_multipliers_464 = constraints_multipliers_463
        - constraints_L_5_2 * constraints_multipliers_457;
    const real constraints_multipliers_465 = constraints_multipliers_464
        - constraints_L_5_3 * constraints_multipliers_459;
    const real constraints_multipliers_466 = constraints_multipliers_465
        - constraints_L_5_4 * constraints_multipliers_462;
    work[116] = constraints_multipliers_466;
    const real constraints_multipliers_467 = constraints_D_inverse_6 * constraints_multipliers_441 -
        constraints_L_6_1 * constraints_multipliers_456;
    const real constraints_multipliers_468 = constraints_multipliers_467
        - constraints_L_6_2 * constraints_multipliers_457;
    const real constraints_multipliers_469 = constraints_multipliers_468
        - constraints_L_6_3 * constraints_multipliers_459;
    const real constraints_multipliers_470 = constraints_multipliers_469
        - constraints_L_6_4 * constraints_multipliers_462;
    const real constraints_multipliers_471 = constraints_multipliers_470
        - constraints_L_6_5 * constraints_multipliers_466;
    work[117] = constraints_multipliers_471;
    const real constraints_multipliers_472 = front_contact_G_75 * constraints_D_inverse_7
        - constraints_L_7_1 * constraints_multipliers_456;
    const real constraints_multipliers_473 = constraints_multipliers_472
        - constraints_L_7_2 * constraints_multipliers_457;
    const real constraints_multipliers_474 = constraints_multipliers_473
        - constraints_L_7_3 * constraints_multipliers_459;
    const real constraints_multipliers_475 = constraints_multipliers_474
        - constraints_L_7_4 * constraints_multipliers_462;
    const real constraints_multipliers_476 = constraints_multipliers_475
        - constraints_L_7_5 * constraints_multipliers_466;
    const real constraints_multipliers_477 = constraints_multipliers_476
        - constraints_L_7_5 * constraints_multipliers_471;
    work[118] = constraints_multipliers_477;
    const real constraints_multipliers_478 = front_contact_G_83 * constraints_D_inverse_8
        - constraints_L_8_3 * constraints_multipliers_459;
    const real constraints_multipliers_479 = constraints_multipliers_478
        - constraints_L_8_4 * constraints_multipliers_462;
    const real constraints_multipliers_480 = constraints_multipliers_479
        + constraints_multipliers_260 * constraints_multipliers_466;
    const real constraints_multipliers_481 = constraints_multipliers_480
        + constraints_multipliers_260 * constraints_multipliers_471;
    work[119] = constraints_multipliers_481;
    const real constraints_multipliers_482 = rear_radius * constraints_L_5_4;
    const real rear_contact_G = work[55];
    const real constraints_multipliers_483 = rear_contact_G + rear_radius * constraints_L_5_1
        - constraints_L_4_1 * constraints_multipliers_482;
    const real rear_contact_G_2 = work[56];
    const real constraints_multipliers_484 = rear_contact_G_2 + rear_radius * constraints_L_5_2
        - constraints_L_4_2 * constraints_multipliers_482;
    const real constraints_multipliers_485 = rear_radius * constraints_L_5_3
        - constraints_L_4_3 * constraints_multipliers_482;
    const real constraints_multipliers_486 = constraints_multipliers_483
        - constraints_L_3_1 * constraints_multipliers_485;
    const real constraints_multipliers_487 = constraints_multipliers_484
        - constraints_L_3_2 * constraints_multipliers_485;
    const real constraints_multipliers_488 = constraints_D_inverse_1 * (constraints_multipliers_486
        - constraints_L_2_1 * constraints_multipliers_487);
    work[124] = constraints_multipliers_488;
    const real constraints_multipliers_489 = constraints_D_inverse_2 * constraints_multipliers_487 -
        constraints_L_2_1 * constraints_multipliers_488;
    work[125] = constraints_multipliers_489;
    const real constraints_multipliers_490 = constraints_D_inverse_3 * constraints_multipliers_485 -
        constraints_L_3_1 * constraints_multipliers_488;
    const real constraints_multipliers_491 = constraints_multipliers_490
        - constraints_L_3_2 * constraints_multipliers_489;
    work[126] = constraints_multipliers_491;
    const real constraints_multipliers_492 = constraints_D_inverse_4 * constraints_multipliers_482 -
        constraints_L_4_1 * constraints_multipliers_488;
    const real constraints_multipliers_493 = constraints_multipliers_492
        - constraints_L_4_2 * constraints_multipliers_489;
    const real constraints_multipliers_494 = constraints_multipliers_493
        - constraints_L_4_3 * constraints_multipliers_491;
    work[127] = constraints_multipliers_494;
    const real constraints_multipliers_495 = rear_radius * constraints_D_inverse_5
        + constraints_L_5_1 * constraints_multipliers_488;
    const real constraints_multipliers_496 = constraints_multipliers_495
        + constraints_L_5_2 * constraints_multipliers_489;
    const real constraints_multipliers_497 = constraints_multipliers_496
        + constraints_L_5_3 * constraints_multipliers_491;
    const real constraints_multipliers_498 = constraints_multipliers_497
        + constraints_L_5_4 * constraints_multipliers_494;
    work[128] = constraints_multipliers_498;
    const real constraints_multipliers_499 = constraints_L_6_1 * constraints_multipliers_488
        + constraints_L_6_2 * constraints_multipliers_489;
    const real constraints_multipliers_500 = constraints_multipliers_499
        + constraints_L_6_3 * constraints_multipliers_491;
    const real constraints_multipliers_501 = constraints_multipliers_500
        + constraints_L_6_4 * constraints_multipliers_494;
    const real constraints_multipliers_502 = constraints_L_6_5 * constraints_multipliers_498
        - constraints_multipliers_501;
    work[129] = constraints_multipliers_502;
    const real constraints_multipliers_503 = constraints_L_7_1 * constraints_multipliers_488
        + constraints_L_7_2 * constraints_multipliers_489;
    const real constraints_multipliers_504 = constraints_multipliers_503
        + constraints_L_7_3 * constraints_multipliers_491;
    const real constraints_multipliers_505 = constraints_multipliers_504
        + constraints_L_7_4 * constraints_multipliers_494;
    const real constraints_multipliers_506 = constraints_L_7_5 * constraints_multipliers_498
        - constraints_multipliers_505;
    work[130] = constraints_multipliers_506;
    const real constraints_multipliers_507 = constraints_L_8_3 * constraints_multipliers_491
        + constraints_L_8_4 * constraints_multipliers_494;
    const real constraints_multipliers_508 = constraints_multipliers_507
        + constraints_multipliers_260 * constraints_multipliers_498;
    const real constraints_multipliers_509 = constraints_multipliers_260 *
        constraints_multipliers_502 - constraints_multipliers_508;
    work[131] = constraints_multipliers_509;
    const real constraints_multipliers_510 = constraints_D_inverse_1 * (rear_contact_G_2
        + rear_contact_G * constraints_L_2_1);
    work[132] = constraints_multipliers_510;
    const real constraints_multipliers_511 = rear_contact_G * constraints_D_inverse_2
        + constraints_L_2_1 * constraints_multipliers_510;
    work[135] = constraints_multipliers_511;
    const real constraints_multipliers_512 = constraints_L_3_1 * constraints_multipliers_510
        - constraints_L_3_2 * constraints_multipliers_511;
    work[136] = constraints_multipliers_512;
    const real constraints_multipliers_513 = constraints_L_4_1 * constraints_multipliers_510
        - constraints_L_4_2 * constraints_multipliers_511;
    const real constraints_multipliers_514 = constraints_multipliers_513
        - constraints_L_4_3 * constraints_multipliers_512;
    work[137] = constraints_multipliers_514;
    const real constraints_multipliers_515 = constraints_L_5_1 * constraints_multipliers_510
        - constraints_L_5_2 * constraints_multipliers_511;
    const real constraints_multipliers_516 = constraints_multipliers_515
        - constraints_L_5_3 * constraints_multipliers_512;
    const real constraints_multipliers_517 = constraints_multipliers_516
        - constraints_L_5_4 * constraints_multipliers_514;
    work[138] = constraints_multipliers_517;
    const real constraints_multipliers_518 = constraints_L_6_1 * constraints_multipliers_510
        - constraints_L_6_2 * constraints_multipliers_511;
    const real constraints_multipliers_519 = constraints_multipliers_518
        - constraints_L_6_3 * constraints_multipliers_512;
    const real constraints_multipliers_520 = constraints_multipliers_519
        - constraints_L_6_4 * constraints_multipliers_514;
    const real constraints_multipliers_521 = constraints_multipliers_520
        - constraints_L_6_5 * constraints_multipliers_517;
    work[175] = constraints_multipliers_521;
    const real constraints_multipliers_522 = constraints_L_7_1 * constraints_multipliers_510
        - constraints_L_7_2 * constraints_multipliers_511;
    const real constraints_multipliers_523 = constraints_multipliers_522
        - constraints_L_7_3 * constraints_multipliers_512;
    const real constraints_multipliers_524 = constraints_multipliers_523
        - constraints_L_7_4 * constraints_multipliers_514;
    const real constraints_multipliers_525 = constraints_multipliers_524
        - constraints_L_7_5 * constraints_multipliers_517;
    work[176] = constraints_multipliers_525;
    const real constraints_multipliers_526 = constraints_L_8_3 * constraints_multipliers_512
        + constraints_L_8_4 * constraints_multipliers_514;
    const real constraints_multipliers_527 = constraints_multipliers_260 *
        constraints_multipliers_517 - constraints_multipliers_526;
    work[177] = constraints_multipliers_527;
    const real constraints_multipliers_528 = front_contact_G_13 * constraints_multipliers_370
        + front_contact_G_15 * constraints_multipliers_371;
    const real constraints_multipliers_529 = constraints_multipliers_528
        + front_contact_G_85 * constraints_multipliers_373;
    const real constraints_multipliers_530 = constraints_multipliers_529
        + front_contact_G_87 * constraints_multipliers_376;
    const real constraints_multipliers_531 = constraints_multipliers_530
        + front_contact_G_89 * constraints_multipliers_380;
    const real constraints_multipliers_532 = constraints_multipliers_531
        + front_contact_G_89 * constraints_multipliers_385;
    const real constraints_multipliers_533 = constraints_multipliers_532
        + front_contact_G_91 * constraints_multipliers_391;
    const real constraints_multipliers_534 = constraints_multipliers_533
        + front_contact_G_92 * constraints_multipliers_395;
    work[0] = constraints_multipliers_534;
    const real constraints_multipliers_535 = front_contact_G_20 * constraints_multipliers_370
        + front_contact_G_26 * constraints_multipliers_371;
    const real constraints_multipliers_536 = constraints_multipliers_535
        + front_contact_G_38 * constraints_multipliers_373;
    const real constraints_multipliers_537 = constraints_multipliers_536
        + front_contact_G_50 * constraints_multipliers_376;
    const real constraints_multipliers_538 = constraints_multipliers_537
        + front_contact_G_62 * constraints_multipliers_380;
    const real constraints_multipliers_539 = constraints_multipliers_538
        + front_contact_G_62 * constraints_multipliers_385;
    const real constraints_multipliers_540 = constraints_multipliers_539
        + front_contact_G_74 * constraints_multipliers_391;
    const real constraints_multipliers_541 = -(constraints_multipliers_540
        + front_contact_G_82 * constraints_multipliers_395);
    work[1] = constraints_multipliers_541;
    work[5] = constraints_multipliers_541;
    const real constraints_multipliers_542 = front_contact_G_20 * constraints_multipliers_413
        + front_contact_G_26 * constraints_multipliers_414;
    const real constraints_multipliers_543 = constraints_multipliers_542
        + front_contact_G_38 * constraints_multipliers_416;
    const real constraints_multipliers_544 = constraints_multipliers_543
        + front_contact_G_50 * constraints_multipliers_419;
    const real constraints_multipliers_545 = constraints_multipliers_544
        + front_contact_G_62 * constraints_multipliers_423;
    const real constraints_multipliers_546 = constraints_multipliers_545
        + front_contact_G_62 * constraints_multipliers_428;
    const real constraints_multipliers_547 = constraints_multipliers_546
        - front_contact_G_74 * constraints_multipliers_434;
    const real constraints_multipliers_548 = -(constraints_multipliers_547
        + front_contact_G_82 * constraints_multipliers_438);
    work[6] = constraints_multipliers_548;
    const real constraints_multipliers_549 = front_contact_G_21 * constraints_multipliers_370
        + front_contact_G_27 * constraints_multipliers_371;
    const real constraints_multipliers_550 = constraints_multipliers_549
        + front_contact_G_39 * constraints_multipliers_373;
    const real constraints_multipliers_551 = constraints_multipliers_550
        + front_contact_G_51 * constraints_multipliers_376;
    const real constraints_multipliers_552 = constraints_multipliers_551
        + front_contact_G_63 * constraints_multipliers_380;
    const real constraints_multipliers_553 = constraints_multipliers_552
        + front_contact_G_63 * constraints_multipliers_385;
    const real constraints_multipliers_554 = constraints_multipliers_553
        + front_contact_G_75 * constraints_multipliers_391;
    const real constraints_multipliers_555 = constraints_multipliers_554
        + front_contact_G_83 * constraints_multipliers_395;
    work[2] = constraints_multipliers_555;
    work[10] = constraints_multipliers_555;
    const real constraints_multipliers_556 = front_contact_G_21 * constraints_multipliers_413
        + front_contact_G_27 * constraints_multipliers_414;
    const real constraints_multipliers_557 = constraints_multipliers_556
        + front_contact_G_39 * constraints_multipliers_416;
    const real constraints_multipliers_558 = constraints_multipliers_557
        + front_contact_G_51 * constraints_multipliers_419;
    const real constraints_multipliers_559 = constraints_multipliers_558
        + front_contact_G_63 * constraints_multipliers_423;
    const real constraints_multipliers_560 = constraints_multipliers_559
        + front_contact_G_63 * constraints_multipliers_428;
    const real constraints_multipliers_561 = constraints_multipliers_560
        - front_contact_G_75 * constraints_multipliers_434;
    const real constraints_multipliers_562 = constraints_multipliers_561
        + front_contact_G_83 * constraints_multipliers_438;
    work[7] = constraints_multipliers_562;
    work[11] = constraints_multipliers_562;
    const real constraints_multipliers_563 = front_contact_G_21 * constraints_multipliers_456
        + front_contact_G_27 * constraints_multipliers_457;
    const real constraints_multipliers_564 = constraints_multipliers_563
        + front_contact_G_39 * constraints_multipliers_459;
    const real constraints_multipliers_565 = constraints_multipliers_564
        + front_contact_G_51 * constraints_multipliers_462;
    const real constraints_multipliers_566 = constraints_multipliers_565
        + front_contact_G_63 * constraints_multipliers_466;
    const real constraints_multipliers_567 = constraints_multipliers_566
        + front_contact_G_63 * constraints_multipliers_471;
    const real constraints_multipliers_568 = constraints_multipliers_567
        + front_contact_G_75 * constraints_multipliers_477;
    const real constraints_multipliers_569 = constraints_multipliers_568
        + front_contact_G_83 * constraints_multipliers_481;
    work[12] = constraints_multipliers_569;
    const real constraints_multipliers_570 = rear_contact_G * constraints_multipliers_370
        + rear_contact_G_2 * constraints_multipliers_371;
    const real constraints_multipliers_571 = constraints_multipliers_570
        - rear_radius * constraints_multipliers_380;
    work[3] = constraints_multipliers_571;
    work[15] = constraints_multipliers_571;
    const real constraints_multipliers_572 = rear_contact_G * constraints_multipliers_413
        + rear_contact_G_2 * constraints_multipliers_414;
    const real constraints_multipliers_573 = constraints_multipliers_572
        - rear_radius * constraints_multipliers_423;
    work[8] = constraints_multipliers_573;
    work[16] = constraints_multipliers_573;
    const real constraints_multipliers_574 = rear_contact_G * constraints_multipliers_456
        + rear_contact_G_2 * constraints_multipliers_457;
    const real constraints_multipliers_575 = constraints_multipliers_574
        - rear_radius * constraints_multipliers_466;
    work[13] = constraints_multipliers_575;
    work[17] = constraints_multipliers_575;
    const real constraints_multipliers_576 = rear_contact_G * constraints_multipliers_488
        + rear_contact_G_2 * constraints_multipliers_489;
    const real constraints_multipliers_577 = constraints_multipliers_576
        + rear_radius * constraints_multipliers_498;
    work[18] = constraints_multipliers_577;
    const real constraints_multipliers_578 = rear_contact_G * constraints_multipliers_371
        - rear_contact_G_2 * constraints_multipliers_370;
    work[4] = constraints_multipliers_578;
    work[20] = constraints_multipliers_578;
    const real constraints_multipliers_579 = rear_contact_G * constraints_multipliers_414
        - rear_contact_G_2 * constraints_multipliers_413;
    work[9] = constraints_multipliers_579;
    work[21] = constraints_multipliers_579;
    const real constraints_multipliers_580 = rear_contact_G * constraints_multipliers_457
        - rear_contact_G_2 * constraints_multipliers_456;
    work[14] = constraints_multipliers_580;
    work[22] = constraints_multipliers_580;
    const real constraints_multipliers_581 = rear_contact_G * constraints_multipliers_489
        - rear_contact_G_2 * constraints_multipliers_488;
    work[19] = constraints_multipliers_581;
    work[23] = constraints_multipliers_581;
    const real constraints_multipliers_582 = rear_contact_G_2 * constraints_multipliers_510
        + rear_contact_G * constraints_multipliers_511;
    work[24] = constraints_multipliers_582;
    const real constraints_multipliers_583 = front_contact_G_13 * constraints_multipliers_327
        + front_contact_G_15 * constraints_multipliers_328;
    const real constraints_multipliers_584 = constraints_multipliers_583
        + front_contact_G_85 * constraints_multipliers_330;
    work[178] = constraints_multipliers_584;
    return CARDAN_OK;
}

CARDAN_PART int forward_dynamics_part4(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const u = in->u;
    const wreal *const w = in->w;
    int status = CARDAN_OK;

    /* constraints: multipliers */
    const real rear_contact_u_x = u[0]; /* m/s */
    const real rear_contact_u_y = u[1]; /* m/s */
    const wreal rear_radius = w[0]; /* m */
    const real constraints_multipliers_584 = work[178];
    const real front_contact_G_87 = work[57];
    const real constraints_multipliers_333 = work[84];
    const real constraints_multipliers_585 = constraints_multipliers_584
        + front_contact_G_87 * constraints_multipliers_333;
    const real front_contact_G_89 = work[68];
    const real constraints_multipliers_337 = work[87];
    const real constraints_multipliers_586 = constraints_multipliers_585
        + front_contact_G_89 * constraints_multipliers_337;
    const real constraints_multipliers_342 = work[88];
    const real constraints_multipliers_587 = constraints_multipliers_586
        + front_contact_G_89 * constraints_multipliers_342;
    const real front_contact_G_91 = work[70];
    const real constraints_multipliers_348 = work[89];
    const real constraints_multipliers_588 = constraints_multipliers_587
        + front_contact_G_91 * constraints_multipliers_348;
    const real front_contact_G_20 = work[161];
    const real constraints_multipliers_327 = work[81];
    const real front_contact_G_26 = work[163];
    const real constraints_multipliers_328 = work[82];
    const real constraints_multipliers_589 = front_contact_G_20 * constraints_multipliers_327
        + front_contact_G_26 * constraints_multipliers_328;
    const real front_contact_G_38 = work[165];
    const real constraints_multipliers_330 = work[83];
    const real constraints_multipliers_590 = constraints_multipliers_589
        + front_contact_G_38 * constraints_multipliers_330;
    const real front_contact_G_50 = work[167];
    const real constraints_multipliers_591 = constraints_multipliers_590
        + front_contact_G_50 * constraints_multipliers_333;
    const real front_contact_G_62 = work[169];
    const real constraints_multipliers_592 = constraints_multipliers_591
        + front_contact_G_62 * constraints_multipliers_337;
    const real constraints_multipliers_593 = constraints_multipliers_592
        + front_contact_G_62 * constraints_multipliers_342;
    const real front_contact_G_74 = work[171];
    const real constraints_multipliers_594 = constraints_multipliers_593
        + front_contact_G_74 * constraints_multipliers_348;
    const real front_contact_G_82 = work[173];
    const real constraints_multipliers_352 = work[90];
    const real constraints_multipliers_595 = constraints_multipliers_594
        + front_contact_G_82 * constraints_multipliers_352;
    const real front_contact_G_21 = work[162];
    const real front_contact_G_27 = work[164];
    const real constraints_multipliers_596 = front_contact_G_21 * constraints_multipliers_327
        + front_contact_G_27 * constraints_multipliers_328;
    const real front_contact_G_39 = work[166];
    const real constraints_multipliers_597 = constraints_multipliers_596
        + front_contact_G_39 * constraints_multipliers_330;
    const real front_contact_G_51 = work[168];
    const real constraints_multipliers_598 = constraints_multipliers_597
        + front_contact_G_51 * constraints_multipliers_333;
    const real front_contact_G_63 = work[170];
    const real constraints_multipliers_599 = constraints_multipliers_598
        + front_contact_G_63 * constraints_multipliers_337;
    const real constraints_multipliers_600 = constraints_multipliers_599
        + front_contact_G_63 * constraints_multipliers_342;
    const real front_contact_G_75 = work[172];
    const real constraints_multipliers_601 = constraints_multipliers_600
        + front_contact_G_75 * constraints_multipliers_348;
    const real front_contact_G_83 = work[174];
    const real constraints_multipliers_602 = constraints_multipliers_601
        + front_contact_G_83 * constraints_multipliers_352;
    const real rear_contact_G = work[55];
    const real rear_contact_G_2 = work[56];
    const real constraints_multipliers_603 = rear_contact_G * constraints_multipliers_327
        + rear_contact_G_2 * constraints_multipliers_328;
    const real constraints_multipliers_604 = rear_contact_G * constraints_multipliers_328
        - rear_contact_G_2 * constraints_multipliers_327;
    const real constraints_multipliers_259 = work[78];
    const real front_contact_G_92 = work[77];
    const real constraints_multipliers_605 = -(constraints_multipliers_588
        + front_contact_G_92 * constraints_multipliers_352 + constraints_multipliers_259);
    work[25] = constraints_multipliers_605;
    const real constraints_multipliers_252 = work[218];
    const real constraints_multipliers_253 = work[219];
    const real constraints_multipliers_606 = constraints_multipliers_252
        + constraints_multipliers_253 + constraints_multipliers_595;
    work[26] = constraints_multipliers_606;
    const real constraints_multipliers_254 = work[220];
    const real constraints_multipliers_255 = work[221];
    const real constraints_multipliers_607 = -(constraints_multipliers_254
        - constraints_multipliers_255 + constraints_multipliers_602);
    work[27] = constraints_multipliers_607;
    const real constraints_multipliers_256 = work[222];
    const real constraints_multipliers_608 = -(constraints_multipliers_603
        - rear_radius * constraints_multipliers_337 + constraints_multipliers_256);
    work[28] = constraints_multipliers_608;
    const real constraints_multipliers_3 = work[209];
    const real constraints_multipliers_4 = work[210];
    const real constraints_multipliers_609 = rear_contact_u_y * constraints_multipliers_3
        + rear_contact_u_x * constraints_multipliers_4 - constraints_multipliers_604;
    work[29] = constraints_multipliers_609;
    status |= CARDAN_SOLVE(semidefinite, 5, 1, work + 0, work + 25, work + 30);

    /* front_contact: multiplier pz, multiplier longitudinal, multiplier lateral */
    const real front_contact_multiplier_pz = work[25];
    const real front_contact_multiplier_longitudinal = work[26];
    const real front_contact_multiplier_lateral = work[27];

    /* rear_contact: multiplier longitudinal, multiplier lateral */
    const real rear_contact_multiplier_longitudinal = work[28];
    const real rear_contact_multiplier_lateral = work[29];

    /* constraints: multipliers */
    const real constraints_multipliers_413 = work[99];
    const real constraints_multipliers_610 = constraints_multipliers_413 *
        front_contact_multiplier_longitudinal;
    const real constraints_multipliers_370 = work[91];
    const real constraints_multipliers_611 = constraints_multipliers_370 *
        front_contact_multiplier_pz + constraints_multipliers_610;
    const real constraints_multipliers_456 = work[111];
    const real constraints_multipliers_612 = constraints_multipliers_611
        + constraints_multipliers_456 * front_contact_multiplier_lateral;
    const real constraints_multipliers_488 = work[124];
    const real constraints_multipliers_613 = constraints_multipliers_612
        + constraints_multipliers_488 * rear_contact_multiplier_longitudinal;
    const real constraints_multipliers_414 = work[100];
    const real constraints_multipliers_614 = constraints_multipliers_414 *
        front_contact_multiplier_longitudinal;
    const real constraints_multipliers_371 = work[92];
    const real constraints_multipliers_615 = constraints_multipliers_371 *
        front_contact_multiplier_pz + constraints_multipliers_614;
    const real constraints_multipliers_457 = work[112];
    const real constraints_multipliers_616 = constraints_multipliers_615
        + constraints_multipliers_457 * front_contact_multiplier_lateral;
    const real constraints_multipliers_489 = work[125];
    const real constraints_multipliers_617 = constraints_multipliers_616
        + constraints_multipliers_489 * rear_contact_multiplier_longitudinal;
    const real constraints_multipliers_416 = work[101];
    const real constraints_multipliers_618 = constraints_multipliers_416 *
        front_contact_multiplier_longitudinal;
    const real constraints_multipliers_373 = work[93];
    const real constraints_multipliers_619 = constraints_multipliers_373 *
        front_contact_multiplier_pz + constraints_multipliers_618;
    const real constraints_multipliers_459 = work[114];
    const real constraints_multipliers_620 = constraints_multipliers_619
        + constraints_multipliers_459 * front_contact_multiplier_lateral;
    const real constraints_multipliers_491 = work[126];
    const real constraints_multipliers_621 = constraints_multipliers_620
        + constraints_multipliers_491 * rear_contact_multiplier_longitudinal;
    const real constraints_multipliers_419 = work[102];
    const real constraints_multipliers_622 = constraints_multipliers_419 *
        front_contact_multiplier_longitudinal;
    const real constraints_multipliers_376 = work[94];
    const real constraints_multipliers_623 = constraints_multipliers_376 *
        front_contact_multiplier_pz + constraints_multipliers_622;
    const real constraints_multipliers_462 = work[115];
    const real constraints_multipliers_624 = constraints_multipliers_623
        + constraints_multipliers_462 * front_contact_multiplier_lateral;
    const real constraints_multipliers_494 = work[127];
    const real constraints_multipliers_625 = constraints_multipliers_624
        + constraints_multipliers_494 * rear_contact_multiplier_longitudinal;
    const real constraints_multipliers_423 = work[103];
    const real constraints_multipliers_626 = constraints_multipliers_423 *
        front_contact_multiplier_longitudinal;
    const real constraints_multipliers_380 = work[95];
    const real constraints_multipliers_627 = constraints_multipliers_380 *
        front_contact_multiplier_pz + constraints_multipliers_626;
    const real constraints_multipliers_466 = work[116];
    const real constraints_multipliers_628 = constraints_multipliers_627
        + constraints_multipliers_466 * front_contact_multiplier_lateral;
    const real constraints_multipliers_498 = work[128];
    const real constraints_multipliers_629 = constraints_multipliers_628
        - constraints_multipliers_498 * rear_contact_multiplier_longitudinal;
    const real constraints_multipliers_428 = work[108];
    const real constraints_multipliers_630 = constraints_multipliers_428 *
        front_contact_multiplier_longitudinal;
    const real constraints_multipliers_385 = work[96];
    const real constraints_multipliers_631 = constraints_multipliers_385 *
        front_contact_multiplier_pz + constraints_multipliers_630;
    const real constraints_multipliers_471 = work[117];
    const real constraints_multipliers_632 = constraints_multipliers_631
        + constraints_multipliers_471 * front_contact_multiplier_lateral;
    const real constraints_multipliers_502 = work[129];
    const real constraints_multipliers_633 = constraints_multipliers_632
        + constraints_multipliers_502 * rear_contact_multiplier_longitudinal;
    const real constraints_multipliers_434 = work[109];
    const real constraints_multipliers_634 = constraints_multipliers_434 *
        front_contact_multiplier_longitudinal;
    const real constraints_multipliers_391 = work[97];
    const real constraints_multipliers_635 = constraints_multipliers_391 *
        front_contact_multiplier_pz - constraints_multipliers_634;
    const real constraints_multipliers_506 = work[130];
    const real constraints_L_7_5 = work[80];
    const real constraints_multipliers_636 = (constraints_multipliers_506
        - constraints_L_7_5 * constraints_multipliers_502) * rear_contact_multiplier_longitudinal;
    const real constraints_multipliers_477 = work[118];
    const real constraints_multipliers_637 = constraints_multipliers_635
        + constraints_multipliers_477 * front_contact_multiplier_lateral
        + constraints_multipliers_636;
    const real constraints_multipliers_525 = work[176];
    const real constraints_multipliers_521 = work[175];
    const real constraints_multipliers_638 = (constraints_multipliers_525
        - constraints_L_7_5 * constraints_multipliers_521) * rear_contact_multiplier_lateral;
    const real constraints_multipliers_438 = work[110];
    const real constraints_multipliers_639 = constraints_multipliers_438 *
        front_contact_multiplier_longitudinal;
    const real constraints_multipliers_395 = work[98];
    const real constraints_multipliers_640 = constraints_multipliers_395 *
        front_contact_multiplier_pz + constraints_multipliers_639;
    const real constraints_multipliers_481 = work[119];
    const real constraints_multipliers_641 = constraints_multipliers_640
        + constraints_multipliers_481 * front_contact_multiplier_lateral;
    const real constraints_multipliers_509 = work[131];
    const real constraints_multipliers_642 = constraints_multipliers_641
        + constraints_multipliers_509 * rear_contact_multiplier_longitudinal;
    const real constraints_multipliers_527 = work[177];
    const real constraints_multipliers_260 = work[79];
    const real constraints_multipliers_643 = (constraints_multipliers_527
        + constraints_multipliers_260 * constraints_multipliers_521) *
        rear_contact_multiplier_lateral;

    /* rear_contact: udot, udot yaw, udot lean, udot spin */
    const real constraints_multipliers_510 = work[132];
    const real constraints_multipliers_511 = work[135];
    const real constraints_multipliers_512 = work[136];
    const real constraints_multipliers_514 = work[137];
    const real constraints_multipliers_517 = work[138];
    /* udot: rear_contact.u.xdot [m/s^2] */
    out[0] = constraints_multipliers_613
        - constraints_multipliers_510 * rear_contact_multiplier_lateral
        + constraints_multipliers_327;
    /* udot: rear_contact.u.ydot [m/s^2] */
    out[1] = constraints_multipliers_617
        + constraints_multipliers_511 * rear_contact_multiplier_lateral
        + constraints_multipliers_328;
    /* udot: rear_contact.u.yawdot [rad/s^2] */
    out[2] = constraints_multipliers_621
        + constraints_multipliers_512 * rear_contact_multiplier_lateral
        + constraints_multipliers_330;
    /* udot: rear_contact.u.leandot [rad/s^2] */
    out[3] = constraints_multipliers_625
        + constraints_multipliers_514 * rear_contact_multiplier_lateral
        + constraints_multipliers_333;
    /* udot: rear_contact.u.spindot [rad/s^2] */
    out[4] = constraints_multipliers_629
        + constraints_multipliers_517 * rear_contact_multiplier_lateral
        + constraints_multipliers_337;

    /* rear_hub: udot */
    /* udot: rear_hub.udot [rad/s^2] */
    out[5] = constraints_multipliers_633
        + constraints_multipliers_521 * rear_contact_multiplier_lateral
        + constraints_multipliers_342;

    /* steer: udot */
    /* udot: steer.udot [rad/s^2] */
    out[6] = constraints_multipliers_637 + constraints_multipliers_638
        + constraints_multipliers_348;

    /* front_hub: udot */
    /* udot: front_hub.udot [rad/s^2] */
    out[7] = constraints_multipliers_642 + constraints_multipliers_643
        + constraints_multipliers_352;
    return status;
}

/* udot with M udot + h = f + tau */
CARDAN_API int forward_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    int status = CARDAN_OK;
    status |= forward_dynamics_part1(in, out, work);
    status |= forward_dynamics_part2(in, out, work);
    status |= forward_dynamics_part3(in, out, work);
    status |= forward_dynamics_part4(in, out, work);
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {8, 282, 38, 0, 8, 8, 0, 0, 0, 26, 0, 0, 0, 0, 8, 0, 0, 0, 0};
#endif
