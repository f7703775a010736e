/*
 * mass_matrix of bicycle
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: axes, base_parameters
 * passes: reassociate
 *
 * Sizes: out 64, work 0, w 24
 * Operations per call: 335 = 194 mul, 74 add, 54 sub, 6 cos, 6 sin, 1 neg
 * Operations of prepare: 184 = 88 mul, 47 add, 26 sub, 6 div, 4 neg, 4 select, 3 sqrt, 2 atan2,
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
 * Input p (26): parameters, read by prepare_ only
 *
 * Output M (8 x 8): out[0 ... 63], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
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
    const wreal sqrt_1 = cardan_sqrt(steer_data * steer_data + steer_data_2 * steer_data_2);
    const wreal div_1 = steer_data / sqrt_1;
    w[4] = div_1; /* div_1 */

    /* steer: R */
    const wreal steer_R_zz = steer_data_2 / sqrt_1;
    w[5] = steer_R_zz; /* steer_R_zz */

    /* fork: axes, mass */
    const wreal fork_axes = cardan_select(cardan_lt(steer_R_zz, 0.0), -1.0, 1.0);
    const wreal fork_axes_2 = div_1 * fork_axes;
    const wreal fork_mass_5 = steer_R_zz * (fork_inertia_zz_2 * steer_R_zz
        - fork_inertia_xz_2 * div_1);

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
    const wreal fork_mass_6 = fork_inertia_xx_2 * fork_axes_11 + fork_inertia_xz_2 * fork_axes_12;
    const wreal fork_mass_7 = fork_inertia_xz_2 * fork_axes_11 + fork_inertia_zz_2 * fork_axes_12;

    /* front_hub: R, p, place */
    const wreal front_radius = p[4]; /* m */
    const wreal front_hub_R_yy = steer_R_zz * fork_axes_11 + div_1 * fork_axes_12;
    const wreal front_hub_p_x = front_radius * fork_axes_12 - trail * fork_axes_11;
    const wreal front_hub_p_z = trail * div_1 + front_radius * steer_R_zz;
    w[6] = front_hub_R_yy; /* front_hub_R_yy */
    w[8] = cardan_atan2(-steer_R_zz * front_hub_R_yy, fork_axes_12); /* front_hub_place */

    /* steer: place */
    w[7] = cardan_atan2(-front_hub_R_yy, 0.0); /* steer_place */

    /* front_wheel: base inertia, base */
    const wreal front_wheel_mass = p[22]; /* kg */
    const wreal front_wheel_inertia_xx = p[23]; /* kg m^2 */
    const wreal front_wheel_inertia_zz = p[25]; /* kg m^2 */
    const wreal front_wheel_base = 0.5 * front_wheel_mass;
    const wreal front_wheel_base_2 = front_hub_p_x * front_wheel_base;
    const wreal front_wheel_base_3 = front_hub_p_z * front_wheel_base;
    const wreal front_wheel_base_4 = front_hub_p_x * front_wheel_base_2;
    const wreal front_wheel_base_5 = front_hub_p_z * front_wheel_base_3;
    const wreal front_wheel_base_6 = 2.0 * (front_wheel_base_4 + front_wheel_base_5);
    const wreal front_wheel_base_7 = fork_mass + front_wheel_mass;
    const wreal front_wheel_base_8 = fork_first_moment_z * steer_R_zz
        - fork_first_moment_x * div_1 + front_wheel_mass * front_hub_p_z;
    const wreal front_wheel_base_9 = fork_axes_11 * fork_mass_6 + fork_axes_12 * fork_mass_7
        - 2.0 * front_wheel_base_4;
    const wreal front_wheel_base_10 = front_wheel_inertia_xx + front_wheel_base_6
        + front_wheel_base_9;
    const wreal front_wheel_base_11 = front_hub_p_z * front_wheel_base_2
        + front_hub_p_x * front_wheel_base_3;
    const wreal front_wheel_base_12 = fork_mass_5 - div_1 * (fork_inertia_xz_2 * steer_R_zz
        - fork_inertia_xx_2 * div_1) - 2.0 * front_wheel_base_5;
    w[9] = front_wheel_inertia_zz - front_wheel_inertia_xx; /* front_wheel_base_inertia_zz */

    /* fork: base moment, base inertia, base */
    const wreal fork_base_inertia_yy = fork_inertia_yy_2 * front_hub_R_yy * front_hub_R_yy
        + front_wheel_base_6 - front_wheel_base_10;
    const wreal fork_base = div_1 * front_wheel_base_8;
    const wreal fork_base_2 = steer_R_zz * front_wheel_base_8;
    const wreal fork_base_3 = steer_R_zz * front_wheel_base_10;
    const wreal fork_base_4 = 0.5 * front_wheel_base_7;
    const wreal fork_base_5 = steer_place_x * fork_base_4 - fork_base;
    const wreal fork_base_6 = fork_base_2 - rear_radius * fork_base_4;
    const wreal fork_base_7 = steer_place_x * fork_base_5;
    const wreal fork_base_8 = rear_radius * fork_base_6;
    const wreal fork_base_9 = 2.0 * (fork_base_7 - fork_base_8);
    const wreal fork_base_10 = frame_inertia_xx_2 + steer_R_zz * fork_base_3 + (fork_base_9
        - 2.0 * fork_base_7);
    /* fork_base_moment_x */
    w[10] = fork_first_moment_x * fork_axes_11 + fork_first_moment_z * fork_axes_12
        + front_wheel_mass * front_hub_p_x;
    /* fork_base_inertia_xz */
    w[11] = steer_R_zz * fork_mass_7 - div_1 * fork_mass_6 - front_wheel_base_11;
    /* fork_base_inertia_zz */
    w[12] = front_wheel_inertia_xx * front_hub_R_yy * front_hub_R_yy + front_wheel_base_6
        + front_wheel_base_12;

    /* frame: base moment, base inertia */
    /* frame_base_moment_x */
    w[13] = frame_first_moment_x + steer_place_x * front_wheel_base_7 - fork_base;
    /* frame_base_moment_z */
    w[14] = frame_first_moment_z + fork_base_2 - rear_radius * front_wheel_base_7;
    /* frame_base_inertia_xz */
    w[15] = frame_inertia_xz_2 + div_1 * fork_base_3 + (rear_radius * fork_base_5
        - steer_place_x * fork_base_6);
    w[16] = frame_inertia_yy_2 + front_wheel_base_10 + fork_base_9; /* frame_base_inertia_yy */
    /* frame_base_inertia_zz */
    w[17] = fork_base_9 + 2.0 * fork_base_8 + (frame_inertia_zz_2
        + div_1 * front_wheel_base_10 * div_1 - fork_base_10);

    /* rear_wheel: base mass, base inertia */
    const wreal rear_wheel_mass = p[6]; /* kg */
    const wreal rear_wheel_inertia_xx = p[7]; /* kg m^2 */
    const wreal rear_wheel_inertia_zz = p[9]; /* kg m^2 */
    const wreal rear_wheel_base_mass = rear_wheel_mass + frame_mass + front_wheel_base_7;
    w[18] = rear_wheel_base_mass; /* rear_wheel_base_mass */
    w[19] = rear_wheel_inertia_xx + fork_base_10; /* rear_wheel_base_inertia_xx */
    w[20] = rear_wheel_inertia_zz + fork_base_10; /* rear_wheel_base_inertia_zz */

    /* shared by several: inertia */
    const wreal front_wheel_inertia_yy = p[24]; /* kg m^2 */
    const wreal fork_inertia = front_wheel_inertia_yy * front_hub_R_yy;
    w[21] = fork_inertia; /* fork_inertia */

    /* fork: composite inertia */
    w[22] = fork_base_inertia_yy + front_hub_R_yy * fork_inertia; /* fork_composite_inertia_yy */

    /* rear_contact: M */
    w[23] = rear_radius * rear_wheel_base_mass; /* rear_contact_M */

    /* parameters as they are */
    w[0] = p[3]; /* rear_radius [m] */
    w[1] = p[8]; /* rear_wheel.inertia.yy [kg m^2] */
    w[3] = p[24]; /* front_wheel.inertia.yy [kg m^2] */
}

#include "lanes.h"

/* M: kinetic energy is 1/2 uᵀ M u */
CARDAN_API int mass_matrix(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const wreal *const w = in->w;
    (void)work;

    /* shared by several: R, cos, sin */
    const real rear_contact_yaw = q[2]; /* rad */
    const real rear_contact_lean = q[3]; /* rad */
    const real rear_contact_spin = q[4]; /* rad */
    const real rear_hub_q = q[5]; /* rad */
    const real steer_q = q[6]; /* rad */
    const real front_hub_q = q[7]; /* rad */
    const wreal steer_place = w[7];
    const wreal front_hub_place = w[8];
    const real front_hub_R = front_hub_q + front_hub_place;
    const real steer_R = steer_q + steer_place;
    const real angle_2[CARDAN_PADDED(6)] = {front_hub_R, steer_R, rear_hub_q, rear_contact_yaw,
        rear_contact_lean, rear_contact_spin};
    real sine_2[CARDAN_PADDED(6)], cosine_2[CARDAN_PADDED(6)];
    cardan_sincos(6, angle_2, sine_2, cosine_2);
    const real front_hub_cos = cosine_2[0];
    const real front_hub_sin = sine_2[0];
    const real steer_cos = cosine_2[1];
    const real steer_sin = sine_2[1];
    const real rear_hub_cos = cosine_2[2];
    const real rear_hub_sin = sine_2[2];
    const real rear_contact_R = cosine_2[3];
    const real rear_contact_R_2 = sine_2[3];
    const real rear_contact_R_3 = cosine_2[4];
    const real rear_contact_sin = sine_2[4];
    const real rear_contact_R_4 = cosine_2[5];
    const real rear_contact_R_5 = sine_2[5];

    /* fork: inertia, composite inertia, momentum */
    const wreal front_hub_R_yy = w[6];
    const wreal front_wheel_base_inertia_zz = w[9];
    const wreal fork_base_moment_x = w[10];
    const wreal fork_base_inertia_xz = w[11];
    const wreal fork_base_inertia_zz = w[12];
    const wreal fork_inertia = w[21];
    const real fork_inertia_2 = front_wheel_base_inertia_zz * front_hub_sin;
    const real fork_inertia_3 = front_hub_sin * fork_inertia_2;
    const real fork_composite_inertia_xx = front_wheel_base_inertia_zz - fork_inertia_3;
    const real fork_composite_inertia_xz = fork_base_inertia_xz
        - front_hub_cos * fork_inertia_2 * front_hub_R_yy;
    const real fork_composite_inertia_zz = fork_base_inertia_zz
        + front_hub_R_yy * fork_inertia_3 * front_hub_R_yy;
    const real fork_momentum = fork_inertia * steer_sin;
    const real fork_momentum_2 = fork_base_moment_x * steer_sin;
    out[54] = fork_composite_inertia_zz; /* M: steer.u,steer.u */

    /* steer: R */
    const wreal div_1 = w[4];
    const wreal steer_R_zz = w[5];
    const real steer_R_2 = steer_R_zz * steer_sin;
    const real steer_R_3 = steer_R_zz * steer_cos;
    const real steer_R_4 = div_1 * steer_sin;
    const real steer_R_5 = div_1 * steer_cos;

    /* frame: inertia, composite moment, composite inertia */
    const wreal rear_radius = w[0]; /* m */
    const wreal steer_place_x = w[2];
    const wreal frame_base_moment_x = w[13];
    const wreal frame_base_moment_z = w[14];
    const wreal frame_base_inertia_yy = w[16];
    const wreal fork_composite_inertia_yy = w[22];
    const real frame_inertia = steer_sin * (fork_composite_inertia_xx - fork_composite_inertia_yy);
    const real frame_inertia_2 = steer_sin * frame_inertia;
    const real frame_inertia_3 = fork_composite_inertia_yy + frame_inertia_2;
    const real frame_inertia_4 = steer_cos * frame_inertia;
    const real frame_inertia_5 = fork_composite_inertia_xz * steer_sin;
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
    const real frame_composite_inertia_yy = frame_base_inertia_yy + fork_composite_inertia_xx
        + frame_inertia_13 - frame_inertia_2;
    out[37] = frame_composite_inertia_yy; /* M: rear_contact.u.spin,rear_hub.u */
    out[44] = frame_composite_inertia_yy; /* M: rear_hub.u,rear_contact.u.spin */
    out[45] = frame_composite_inertia_yy; /* M: rear_hub.u,rear_hub.u */

    /* shared by several: inertia, M */
    const real frame_inertia_14 = fork_composite_inertia_xz * steer_cos;
    const real frame_inertia_15 = div_1 * fork_composite_inertia_zz;
    const real frame_inertia_16 = steer_R_zz * fork_composite_inertia_zz;
    const real steer_M = rear_radius * fork_momentum_2;

    /* frame: inertia, composite inertia */
    const wreal frame_base_inertia_xz = w[15];
    const wreal frame_base_inertia_zz = w[17];
    const real frame_inertia_17 = frame_inertia_8 + frame_inertia_15;
    const real frame_composite_inertia_xx = frame_inertia_13 + 2.0 * frame_inertia_11
        + div_1 * frame_inertia_17 + steer_R_zz * frame_inertia_7;
    const real frame_inertia_18 = div_1 * frame_inertia_14
        + steer_place_x * frame_composite_moment_y + steer_R_zz * frame_inertia_4;
    const real frame_composite_inertia_yz = steer_R_zz * frame_inertia_14
        + rear_radius * frame_composite_moment_y - div_1 * frame_inertia_4;
    const real frame_inertia_19 = frame_base_inertia_xz - rear_radius * frame_inertia_9
        + steer_place_x * frame_inertia_10 - steer_R_zz * frame_inertia_17;
    const real frame_composite_inertia_xz = div_1 * frame_inertia_7 + frame_inertia_19;
    const real frame_inertia_20 = frame_base_inertia_zz - 2.0 * frame_inertia_12
        + frame_inertia_13 + steer_R_zz * (frame_inertia_16 - frame_inertia_6);
    const real frame_composite_inertia_zz = frame_inertia_20 - div_1 * (frame_inertia_8
        - div_1 * frame_inertia_3);

    /* rear_wheel: inertia, composite inertia, composite moment */
    const wreal rear_wheel_inertia_yy = w[1]; /* kg m^2 */
    const wreal rear_wheel_base_inertia_xx = w[19];
    const wreal rear_wheel_base_inertia_zz = w[20];
    const real rear_wheel_inertia = rear_hub_sin * (frame_composite_inertia_zz
        - frame_composite_inertia_xx);
    const real rear_wheel_inertia_2 = rear_wheel_inertia
        + rear_hub_cos * (frame_composite_inertia_xz + frame_composite_inertia_xz);
    const real rear_wheel_inertia_3 = rear_hub_sin * rear_wheel_inertia_2;
    const real rear_wheel_composite_inertia_xz = rear_hub_cos * rear_wheel_inertia_2
        - frame_composite_inertia_xz;
    const real rear_wheel_composite_inertia_xy = frame_composite_inertia_yz * rear_hub_sin
        - frame_inertia_18 * rear_hub_cos;
    const real rear_wheel_composite_moment_x = frame_composite_moment_x * rear_hub_cos
        + frame_composite_moment_z * rear_hub_sin;
    const real rear_wheel_composite_moment_z = frame_composite_moment_z * rear_hub_cos
        - frame_composite_moment_x * rear_hub_sin;
    const real rear_wheel_composite_inertia_xx = rear_wheel_base_inertia_xx
        + frame_composite_inertia_xx + rear_wheel_inertia_3;
    const real rear_wheel_composite_inertia_yy = rear_wheel_inertia_yy + frame_composite_inertia_yy;
    const real rear_wheel_composite_inertia_zz = rear_wheel_base_inertia_zz
        + frame_composite_inertia_zz - rear_wheel_inertia_3;
    out[36] = rear_wheel_composite_inertia_yy; /* M: rear_contact.u.spin,rear_contact.u.spin */

    /* shared by several: inertia, M */
    const real rear_wheel_inertia_4 = frame_composite_inertia_yz * rear_hub_cos
        + frame_inertia_18 * rear_hub_sin;
    const real rear_contact_M_2 = rear_wheel_composite_inertia_xy * rear_contact_R_4;

    /* rear_wheel: composite inertia */
    const real rear_wheel_composite_inertia_yz = rear_wheel_inertia_4 + rear_wheel_inertia_4
        - rear_wheel_inertia_4;

    /* fork: momentum */
    const real fork_momentum_3 = fork_inertia * steer_R_3;
    const real fork_momentum_4 = fork_inertia * steer_R_5;
    const real fork_momentum_5 = fork_base_moment_x * steer_R_3;
    const real fork_momentum_6 = fork_base_moment_x * steer_R_5;
    const real fork_momentum_7 = fork_composite_inertia_xz * steer_R_2 + steer_M + frame_inertia_15;
    const real fork_momentum_8 = frame_inertia_16 - (fork_composite_inertia_xz * steer_R_4
        + steer_place_x * fork_momentum_2);

    /* M */
    const real M_8_5 = -fork_momentum;
    const real M_7_5 = rear_radius * fork_momentum_5 + steer_place_x * fork_momentum_6
        + frame_inertia_14;
    const real M_6_4 = rear_contact_M_2 + rear_wheel_inertia_4 * rear_contact_R_5;
    out[39] = M_8_5; /* M: rear_contact.u.spin,front_hub.u */
    out[47] = M_8_5; /* M: rear_hub.u,front_hub.u */
    out[60] = M_8_5; /* M: front_hub.u,rear_contact.u.spin */
    out[61] = M_8_5; /* M: front_hub.u,rear_hub.u */
    out[38] = M_7_5; /* M: rear_contact.u.spin,steer.u */
    out[46] = M_7_5; /* M: rear_hub.u,steer.u */
    out[52] = M_7_5; /* M: steer.u,rear_contact.u.spin */
    out[53] = M_7_5; /* M: steer.u,rear_hub.u */
    out[29] = M_6_4; /* M: rear_contact.u.lean,rear_hub.u */
    out[43] = M_6_4; /* M: rear_hub.u,rear_contact.u.lean */

    /* frame: momentum */
    const real frame_momentum = rear_hub_cos * fork_momentum_3 + rear_hub_sin * fork_momentum_4;
    const real frame_momentum_2 = rear_hub_sin * fork_momentum_3 - rear_hub_cos * fork_momentum_4;
    const real frame_momentum_3 = rear_hub_cos * fork_momentum_5 + rear_hub_sin * fork_momentum_6;
    const real frame_momentum_4 = rear_hub_sin * fork_momentum_5 - rear_hub_cos * fork_momentum_6;
    const real frame_momentum_5 = rear_hub_sin * fork_momentum_8 - rear_hub_cos * fork_momentum_7;
    const real frame_momentum_6 = rear_hub_sin * fork_momentum_7 + rear_hub_cos * fork_momentum_8;

    /* rear_contact: R, S, momentum my, momentum fy, momentum fx, momentum fz, M, ... */
    const wreal rear_wheel_base_mass = w[18];
    const wreal rear_contact_M = w[23];
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
    const real rear_contact_momentum_my = rear_wheel_composite_moment_z * rear_contact_R_xx
        - rear_wheel_composite_moment_x * rear_contact_R_xz;
    const real rear_contact_momentum_my_2 = rear_wheel_composite_moment_z * rear_contact_R_yx
        - rear_wheel_composite_moment_x * rear_contact_R_yz;
    const real rear_contact_momentum_fy = rear_wheel_composite_moment_z * rear_contact_R_9
        + rear_wheel_composite_moment_x * rear_contact_R_zz;
    const real rear_contact_momentum_fx = rear_wheel_base_mass * rear_contact_R_xx;
    const real rear_contact_momentum_fz = rear_wheel_base_mass * rear_contact_R_xz;
    const real rear_contact_M_3 = rear_contact_R_xx * rear_contact_momentum_fx
        + rear_wheel_base_mass * rear_contact_R_6 * rear_contact_R_6;
    const real rear_contact_momentum_fx_2 = rear_wheel_base_mass * rear_contact_R_yx;
    const real rear_contact_momentum_fy_2 = rear_wheel_base_mass * rear_contact_R_yy;
    const real rear_contact_momentum_fz_2 = rear_wheel_base_mass * rear_contact_R_yz;
    const real rear_contact_M_4 = rear_contact_R_xx * rear_contact_momentum_fx_2
        - rear_contact_R_6 * rear_contact_momentum_fy_2;
    const real rear_contact_M_5 = rear_contact_R_yx * rear_contact_momentum_fx_2
        + rear_contact_R_yy * rear_contact_momentum_fy_2;
    const real rear_contact_M_6 = rear_wheel_composite_inertia_xy * rear_contact_sin
        + frame_composite_moment_y * rear_contact_S_3;
    const real rear_contact_M_7 = rear_contact_M_6
        - rear_wheel_composite_inertia_xx * rear_contact_R_9;
    const real rear_contact_momentum_mx = rear_wheel_composite_inertia_xz * rear_contact_R_zz
        + rear_contact_M_7;
    const real rear_contact_M_8 = rear_wheel_composite_inertia_yz * rear_contact_sin
        - frame_composite_moment_y * rear_contact_S_2;
    const real rear_contact_M_9 = rear_contact_M_8
        - rear_wheel_composite_inertia_xz * rear_contact_R_9;
    const real rear_contact_momentum_mz = rear_wheel_composite_inertia_zz * rear_contact_R_zz
        + rear_contact_M_9;
    const real rear_contact_M_10 = rear_wheel_base_mass * rear_contact_S_2
        - frame_composite_moment_y * rear_contact_R_zz;
    const real rear_contact_momentum_fx_3 = rear_wheel_composite_moment_z * rear_contact_sin
        + rear_contact_M_10;
    const real rear_contact_M_11 = rear_wheel_base_mass * rear_contact_S_3
        - frame_composite_moment_y * rear_contact_R_9;
    const real rear_contact_momentum_fz_3 = rear_contact_M_11
        - rear_wheel_composite_moment_x * rear_contact_sin;
    const real rear_contact_M_12 = rear_contact_R_xx * rear_contact_momentum_fx_3
        - rear_contact_R_6 * rear_contact_momentum_fy;
    const real rear_contact_M_13 = rear_contact_R_yx * rear_contact_momentum_fx_3
        + rear_contact_R_yy * rear_contact_momentum_fy;
    const real rear_contact_M_14 = rear_contact_S_2 * rear_contact_momentum_fx_3
        + rear_contact_S_3 * rear_contact_momentum_fz_3;
    const real rear_contact_momentum_my_3 = rear_contact_M_2
        + rear_wheel_composite_inertia_yz * rear_contact_R_5;
    const real rear_contact_M_15 = rear_wheel_composite_inertia_xx * rear_contact_R_4
        + rear_radius * rear_wheel_composite_moment_z;
    const real rear_contact_momentum_mx_2 = rear_wheel_composite_inertia_xz * rear_contact_R_5
        + rear_contact_M_15;
    const real rear_contact_M_16 = rear_wheel_composite_inertia_xz * rear_contact_R_4
        - rear_radius * rear_wheel_composite_moment_x;
    const real rear_contact_momentum_mz_2 = rear_wheel_composite_inertia_zz * rear_contact_R_5
        + rear_contact_M_16;
    const real rear_contact_M_17 = frame_composite_moment_y * rear_contact_R_5;
    const real rear_contact_momentum_fz_4 = frame_composite_moment_y * rear_contact_R_4;
    const real rear_contact_M_18 = rear_contact_M
        + rear_wheel_composite_moment_z * rear_contact_R_4
        - rear_wheel_composite_moment_x * rear_contact_R_5;
    const real rear_contact_M_19 = rear_contact_S_3 * rear_contact_momentum_fz_4
        - rear_contact_S_2 * rear_contact_M_17;
    const real rear_contact_M_20 = rear_contact_sin * rear_contact_momentum_my_3
        + rear_contact_M_19 - rear_contact_R_9 * rear_contact_momentum_mx_2;
    out[4] = rear_contact_momentum_my; /* M: rear_contact.u.x,rear_contact.u.spin */
    out[5] = rear_contact_momentum_my; /* M: rear_contact.u.x,rear_hub.u */
    out[32] = rear_contact_momentum_my; /* M: rear_contact.u.spin,rear_contact.u.x */
    out[40] = rear_contact_momentum_my; /* M: rear_hub.u,rear_contact.u.x */
    out[12] = rear_contact_momentum_my_2; /* M: rear_contact.u.y,rear_contact.u.spin */
    out[13] = rear_contact_momentum_my_2; /* M: rear_contact.u.y,rear_hub.u */
    out[33] = rear_contact_momentum_my_2; /* M: rear_contact.u.spin,rear_contact.u.y */
    out[41] = rear_contact_momentum_my_2; /* M: rear_hub.u,rear_contact.u.y */
    out[28] = rear_contact_momentum_my_3; /* M: rear_contact.u.lean,rear_contact.u.spin */
    out[35] = rear_contact_momentum_my_3; /* M: rear_contact.u.spin,rear_contact.u.lean */

    /* M */
    const real M_8_3 = frame_momentum * rear_contact_R_9 - fork_momentum * rear_contact_sin
        + frame_momentum_2 * rear_contact_R_zz;
    const real M_8_4 = frame_momentum_2 * rear_contact_R_5 - frame_momentum * rear_contact_R_4;
    const real M_7_1 = rear_contact_R_6 * fork_momentum_2 - rear_contact_R_xx * frame_momentum_3
        + rear_contact_R_xz * frame_momentum_4;
    const real M_7_2 = rear_contact_R_yz * frame_momentum_4 - rear_contact_R_yy * fork_momentum_2
        - rear_contact_R_yx * frame_momentum_3;
    const real M_7_4 = steer_M + rear_contact_R_4 * frame_momentum_5
        + rear_contact_R_5 * frame_momentum_6;
    const real M_2_1 = rear_contact_R_xz * rear_contact_momentum_fz_2 + rear_contact_M_4;
    const real M_3_1 = rear_contact_R_xz * rear_contact_momentum_fz_3 + rear_contact_M_12;
    const real M_3_2 = rear_contact_R_yz * rear_contact_momentum_fz_3 + rear_contact_M_13;
    const real M_4_1 = rear_contact_R_xz * rear_contact_momentum_fz_4
        - rear_contact_R_xx * rear_contact_M_17 + rear_contact_R_6 * rear_contact_M_18;
    const real M_4_2 = rear_contact_R_yz * rear_contact_momentum_fz_4
        - rear_contact_R_yx * rear_contact_M_17 - rear_contact_R_yy * rear_contact_M_18;
    const real M_4_3 = rear_contact_R_zz * rear_contact_momentum_mz_2 + rear_contact_M_20;
    out[23] = M_8_3; /* M: rear_contact.u.yaw,front_hub.u */
    out[58] = M_8_3; /* M: front_hub.u,rear_contact.u.yaw */
    out[31] = M_8_4; /* M: rear_contact.u.lean,front_hub.u */
    out[59] = M_8_4; /* M: front_hub.u,rear_contact.u.lean */
    out[6] = M_7_1; /* M: rear_contact.u.x,steer.u */
    out[48] = M_7_1; /* M: steer.u,rear_contact.u.x */
    out[14] = M_7_2; /* M: rear_contact.u.y,steer.u */
    out[49] = M_7_2; /* M: steer.u,rear_contact.u.y */
    out[30] = M_7_4; /* M: rear_contact.u.lean,steer.u */
    out[51] = M_7_4; /* M: steer.u,rear_contact.u.lean */
    /* M: rear_contact.u.x,rear_contact.u.x */
    out[0] = rear_contact_R_xz * rear_contact_momentum_fz + rear_contact_M_3;
    out[1] = M_2_1; /* M: rear_contact.u.x,rear_contact.u.y */
    out[8] = M_2_1; /* M: rear_contact.u.y,rear_contact.u.x */
    /* M: rear_contact.u.y,rear_contact.u.y */
    out[9] = rear_contact_R_yz * rear_contact_momentum_fz_2 + rear_contact_M_5;
    out[2] = M_3_1; /* M: rear_contact.u.x,rear_contact.u.yaw */
    out[16] = M_3_1; /* M: rear_contact.u.yaw,rear_contact.u.x */
    out[10] = M_3_2; /* M: rear_contact.u.y,rear_contact.u.yaw */
    out[17] = M_3_2; /* M: rear_contact.u.yaw,rear_contact.u.y */
    out[3] = M_4_1; /* M: rear_contact.u.x,rear_contact.u.lean */
    out[24] = M_4_1; /* M: rear_contact.u.lean,rear_contact.u.x */
    out[11] = M_4_2; /* M: rear_contact.u.y,rear_contact.u.lean */
    out[25] = M_4_2; /* M: rear_contact.u.lean,rear_contact.u.y */
    out[19] = M_4_3; /* M: rear_contact.u.yaw,rear_contact.u.lean */
    out[26] = M_4_3; /* M: rear_contact.u.lean,rear_contact.u.yaw */
    /* M: rear_contact.u.lean,rear_contact.u.lean */
    out[27] = rear_contact_R_4 * rear_contact_momentum_mx_2 + rear_radius * rear_contact_M_18
        + rear_contact_R_5 * rear_contact_momentum_mz_2;

    /* steer: M */
    const real steer_M_2 = rear_contact_S_3 * frame_momentum_4
        - rear_contact_S_2 * frame_momentum_3 + rear_contact_sin * M_7_5;

    /* M */
    const real M_7_3 = steer_M_2 - rear_contact_R_9 * frame_momentum_5
        + rear_contact_R_zz * frame_momentum_6;
    out[22] = M_7_3; /* M: rear_contact.u.yaw,steer.u */
    out[50] = M_7_3; /* M: steer.u,rear_contact.u.yaw */

    /* shared by several: M */
    const real rear_contact_M_21 = rear_wheel_composite_inertia_xy * rear_contact_R_9;
    const real rear_contact_M_22 = rear_wheel_composite_moment_z * rear_contact_S_2
        - rear_wheel_composite_moment_x * rear_contact_S_3;
    const real rear_contact_M_23 = rear_wheel_composite_inertia_yy * rear_contact_sin
        - rear_contact_M_21 + rear_wheel_composite_inertia_yz * rear_contact_R_zz;

    /* M */
    const real M_6_3 = frame_composite_inertia_yy * rear_contact_sin + rear_contact_M_22
        - rear_contact_M_21 + rear_wheel_inertia_4 * rear_contact_R_zz;
    out[21] = M_6_3; /* M: rear_contact.u.yaw,rear_hub.u */
    out[42] = M_6_3; /* M: rear_hub.u,rear_contact.u.yaw */

    /* rear_contact: momentum my, M */
    const real rear_contact_momentum_my_4 = rear_contact_M_22 + rear_contact_M_23;
    const real rear_contact_M_24 = rear_contact_sin * rear_contact_momentum_my_4
        + rear_contact_M_14 - rear_contact_R_9 * rear_contact_momentum_mx;
    out[20] = rear_contact_momentum_my_4; /* M: rear_contact.u.yaw,rear_contact.u.spin */
    out[34] = rear_contact_momentum_my_4; /* M: rear_contact.u.spin,rear_contact.u.yaw */

    /* M */
    /* M: rear_contact.u.yaw,rear_contact.u.yaw */
    out[18] = rear_contact_R_zz * rear_contact_momentum_mz + rear_contact_M_24;

    /* results that are numbers or inputs */
    out[7] = CARDAN_REAL(0.0); /* M: rear_contact.u.x,front_hub.u */
    out[15] = CARDAN_REAL(0.0); /* M: rear_contact.u.y,front_hub.u */
    out[55] = CARDAN_REAL(0.0); /* M: steer.u,front_hub.u */
    out[56] = CARDAN_REAL(0.0); /* M: front_hub.u,rear_contact.u.x */
    out[57] = CARDAN_REAL(0.0); /* M: front_hub.u,rear_contact.u.y */
    out[62] = CARDAN_REAL(0.0); /* M: front_hub.u,steer.u */
    out[63] = CARDAN_REAL(w[3]); /* M: front_hub.u,front_hub.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {64, 0, 24, 0, 8, 0, 0, 0, 0, 26, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
