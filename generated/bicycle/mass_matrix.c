/*
 * mass_matrix of bicycle
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: axes, base_parameters
 * passes: reassociate
 *
 * Sizes: out 64, work 0, w 24
 * Operations per call: 335 = 194 mul, 74 add, 54 sub, 6 cos, 6 sin, 1 neg
 * Operations of prepare: 176 = 81 mul, 46 add, 26 sub, 6 div, 4 neg, 4 select, 3 sqrt, 2 atan2,
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
    const wreal tilt_sin = sine[0];
    const wreal tilt_cos = cosine[0];

    /* frame: mass, first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal rear_radius = p[3]; /* m */
    const wreal frame_mass = p[10]; /* kg */
    const wreal frame_com_x = p[11]; /* m */
    const wreal frame_inertia_xx = p[12]; /* kg m^2 */
    const wreal frame_inertia_xz = p[13]; /* kg m^2 */
    const wreal frame_inertia_yy = p[14]; /* kg m^2 */
    const wreal frame_inertia_zz = p[15]; /* kg m^2 */
    const wreal c0p9_minus_rear_radius = 0.9 - rear_radius;
    const wreal frame_first_moment_x = frame_mass * frame_com_x;
    const wreal frame_first_moment_z = frame_mass * c0p9_minus_rear_radius;
    const wreal frame_com_x_times_first_moment_x = frame_com_x * frame_first_moment_x;
    const wreal sum_c0p9_minus_rear_radius_times_frame_first_moment_z = c0p9_minus_rear_radius *
        frame_first_moment_z;
    const wreal frame_origin_inertia_xz = frame_inertia_xz
        - c0p9_minus_rear_radius * frame_first_moment_x;
    const wreal frame_origin_inertia_xx = frame_inertia_xx
        + sum_c0p9_minus_rear_radius_times_frame_first_moment_z;
    const wreal frame_origin_inertia_yy = frame_inertia_yy + frame_com_x_times_first_moment_x
        + sum_c0p9_minus_rear_radius_times_frame_first_moment_z;
    const wreal frame_origin_inertia_zz = frame_inertia_zz + frame_com_x_times_first_moment_x;

    /* steer: place */
    const wreal wheelbase = p[0]; /* m */
    const wreal trail = p[1]; /* m */
    const wreal steer_place_x = wheelbase + trail;
    w[2] = steer_place_x;

    /* fork: mass, first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal fork_mass = p[16]; /* kg */
    const wreal fork_com_z = p[17]; /* m */
    const wreal fork_inertia_xx = p[18]; /* kg m^2 */
    const wreal fork_inertia_xz = p[19]; /* kg m^2 */
    const wreal fork_inertia_yy = p[20]; /* kg m^2 */
    const wreal fork_inertia_zz = p[21]; /* kg m^2 */
    const wreal c0p9_minus_trail_minus_wheelbase = 0.9 - trail - wheelbase;
    const wreal fork_first_moment_x = fork_mass * c0p9_minus_trail_minus_wheelbase;
    const wreal fork_first_moment_z = fork_mass * fork_com_z;
    const wreal fork_origin_inertia_yy_part = c0p9_minus_trail_minus_wheelbase *
        fork_first_moment_x;
    const wreal fork_com_z_times_first_moment_z = fork_com_z * fork_first_moment_z;
    const wreal fork_origin_inertia_xz = fork_inertia_xz - fork_com_z * fork_first_moment_x;
    const wreal fork_origin_inertia_xx = fork_inertia_xx + fork_com_z_times_first_moment_z;
    const wreal fork_origin_inertia_yy = fork_inertia_yy + fork_origin_inertia_yy_part
        + fork_com_z_times_first_moment_z;
    const wreal fork_origin_inertia_zz = fork_inertia_zz + fork_origin_inertia_yy_part;

    /* common */
    const wreal sqrt_of_tilt_sin_squared_plus_cos_squared = cardan_sqrt(tilt_sin * tilt_sin
        + tilt_cos * tilt_cos);
    const wreal steer_minus_R_xz = tilt_sin / sqrt_of_tilt_sin_squared_plus_cos_squared;
    w[4] = steer_minus_R_xz;

    /* steer: R */
    /* R = R_fixed R_joint(q) */
    const wreal steer_R_zz = tilt_cos / sqrt_of_tilt_sin_squared_plus_cos_squared;
    w[5] = steer_R_zz;

    /* fork: axes */
    const wreal fork_axes_side = cardan_select(cardan_lt(steer_R_zz, 0.0), -1.0, 1.0);
    const wreal steer_minus_R_xz_times_fork_axes_side = steer_minus_R_xz * fork_axes_side;

    /* shared by several: place */
    const wreal fork_axes_size = steer_R_zz * steer_R_zz + steer_minus_R_xz * steer_minus_R_xz;

    /* fork: axes, mass */
    const wreal fork_axes_parallel = cardan_lt(fork_axes_size, 1e-24);
    const wreal fork_axes_scale = 1.0 / cardan_sqrt(cardan_select(fork_axes_parallel, 1.0,
        fork_axes_size));
    const wreal fork_axes_across_x = cardan_select(fork_axes_parallel, 1.0 - 1.0 / (steer_R_zz
        + fork_axes_side) * (steer_minus_R_xz * steer_minus_R_xz_times_fork_axes_side),
        -steer_R_zz * fork_axes_scale);
    const wreal fork_axes_across_z = cardan_select(fork_axes_parallel,
        steer_minus_R_xz_times_fork_axes_side, -steer_minus_R_xz * fork_axes_scale);
    const wreal fork_axes_normal_x_part = steer_R_zz * fork_axes_across_z
        - steer_minus_R_xz * fork_axes_across_x;
    const wreal fork_axes_normal_x = fork_axes_across_x
        + steer_minus_R_xz * fork_axes_normal_x_part;
    const wreal fork_axes_normal_z = fork_axes_across_z - steer_R_zz * fork_axes_normal_x_part;
    const wreal fork_axes_length = cardan_sqrt(fork_axes_normal_x * fork_axes_normal_x
        + fork_axes_normal_z * fork_axes_normal_z);
    const wreal fork_axes_unit_x = fork_axes_normal_x / fork_axes_length;
    const wreal fork_axes_unit_z = fork_axes_normal_z / fork_axes_length;
    const wreal fork_mass_half_turned_xx = fork_origin_inertia_xx * fork_axes_unit_x
        + fork_origin_inertia_xz * fork_axes_unit_z;
    const wreal fork_mass_half_turned_xz = fork_origin_inertia_xz * fork_axes_unit_x
        + fork_origin_inertia_zz * fork_axes_unit_z;

    /* front_hub: R, p, place */
    /* R = R_fixed R_joint(q) */
    /* p = p_fixed + R_fixed p_joint(q) */
    const wreal front_radius = p[4]; /* m */
    const wreal front_hub_R_yy = steer_R_zz * fork_axes_unit_x
        + steer_minus_R_xz * fork_axes_unit_z;
    const wreal front_hub_p_x = front_radius * fork_axes_unit_z - trail * fork_axes_unit_x;
    const wreal front_hub_p_z = trail * steer_minus_R_xz + front_radius * steer_R_zz;
    const wreal front_hub_offset = cardan_atan2(-steer_R_zz * front_hub_R_yy, fork_axes_unit_z);
    w[6] = front_hub_R_yy;
    w[8] = front_hub_offset;

    /* steer: place */
    const wreal steer_offset = cardan_atan2(-front_hub_R_yy, 0.0);
    w[7] = steer_offset;

    /* front_wheel: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal front_wheel_mass = p[22]; /* kg */
    const wreal front_wheel_inertia_xx = p[23]; /* kg m^2 */
    const wreal front_wheel_inertia_zz = p[25]; /* kg m^2 */
    const wreal front_wheel_base_inertia_zz = front_wheel_inertia_zz - front_wheel_inertia_xx;
    const wreal front_wheel_base_mass_moment_x = front_wheel_mass * front_hub_p_x;
    const wreal front_wheel_base_mass_moment_z = front_wheel_mass * front_hub_p_z;
    const wreal front_wheel_base_second_xx = front_hub_p_x * front_wheel_base_mass_moment_x;
    const wreal front_wheel_base_second_zz = front_hub_p_z * front_wheel_base_mass_moment_z;
    const wreal front_wheel_base_inertia_yy = front_wheel_base_second_xx
        + front_wheel_base_second_zz;
    const wreal fork_mass_plus_front_wheel_mass = fork_mass + front_wheel_mass;
    const wreal fork_base_mean_moment_x_part = fork_first_moment_z * steer_R_zz
        - fork_first_moment_x * steer_minus_R_xz + front_wheel_base_mass_moment_z;
    const wreal fork_base_half_turned_yx = front_wheel_inertia_xx + front_wheel_base_inertia_yy
        + (fork_axes_unit_x * fork_mass_half_turned_xx
        + fork_axes_unit_z * fork_mass_half_turned_xz - front_wheel_base_second_xx);
    const wreal fork_base_inertia_zz_part = steer_R_zz * (fork_origin_inertia_zz * steer_R_zz
        - fork_origin_inertia_xz * steer_minus_R_xz)
        - steer_minus_R_xz * (fork_origin_inertia_xz * steer_R_zz
        - fork_origin_inertia_xx * steer_minus_R_xz) - front_wheel_base_second_zz;
    w[9] = front_wheel_base_inertia_zz;

    /* fork: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal fork_base_moment_x = fork_first_moment_x * fork_axes_unit_x
        + fork_first_moment_z * fork_axes_unit_z + front_wheel_base_mass_moment_x;
    const wreal fork_base_inertia_xz = steer_R_zz * fork_mass_half_turned_xz
        - steer_minus_R_xz * fork_mass_half_turned_xx
        - front_hub_p_z * front_wheel_base_mass_moment_x;
    const wreal fork_base_inertia_zz = front_wheel_inertia_xx * front_hub_R_yy * front_hub_R_yy
        + front_wheel_base_inertia_yy + fork_base_inertia_zz_part;
    const wreal fork_base_inertia_yy = fork_origin_inertia_yy * front_hub_R_yy * front_hub_R_yy
        + front_wheel_base_inertia_yy - fork_base_half_turned_yx;
    const wreal fork_base_mean_moment_x_part_2 = steer_minus_R_xz * fork_base_mean_moment_x_part;
    const wreal fork_base_mean_moment_z_part = steer_R_zz * fork_base_mean_moment_x_part;
    const wreal fork_minus_base_half_turned_xy = steer_R_zz * fork_base_half_turned_yx;
    const wreal half_sum_fork_mass_plus_front_wheel_mass = 0.5 * fork_mass_plus_front_wheel_mass;
    const wreal fork_base_mean_moment_x = steer_place_x * half_sum_fork_mass_plus_front_wheel_mass -
        fork_base_mean_moment_x_part_2;
    const wreal fork_base_mean_moment_z = fork_base_mean_moment_z_part
        - rear_radius * half_sum_fork_mass_plus_front_wheel_mass;
    const wreal steer_place_x_times_fork_base_mean_moment_x = steer_place_x *
        fork_base_mean_moment_x;
    const wreal rear_radius_times_fork_base_mean_moment_z = rear_radius * fork_base_mean_moment_z;
    const wreal fork_base_shift = 2.0 * (steer_place_x_times_fork_base_mean_moment_x
        - rear_radius_times_fork_base_mean_moment_z);
    const wreal frame_base_inertia_xx = frame_origin_inertia_xx
        + steer_R_zz * fork_minus_base_half_turned_xy + (fork_base_shift
        - 2.0 * steer_place_x_times_fork_base_mean_moment_x);
    w[10] = fork_base_moment_x;
    w[11] = fork_base_inertia_xz;
    w[12] = fork_base_inertia_zz;

    /* frame: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal frame_base_moment_x = frame_first_moment_x
        + steer_place_x * fork_mass_plus_front_wheel_mass - fork_base_mean_moment_x_part_2;
    const wreal frame_base_moment_z = frame_first_moment_z + fork_base_mean_moment_z_part
        - rear_radius * fork_mass_plus_front_wheel_mass;
    const wreal frame_base_inertia_xz = frame_origin_inertia_xz
        + steer_minus_R_xz * fork_minus_base_half_turned_xy
        + (rear_radius * fork_base_mean_moment_x - steer_place_x * fork_base_mean_moment_z);
    const wreal frame_base_inertia_yy = frame_origin_inertia_yy + fork_base_half_turned_yx
        + fork_base_shift;
    const wreal frame_base_inertia_zz = fork_base_shift
        + 2.0 * rear_radius_times_fork_base_mean_moment_z + (frame_origin_inertia_zz
        + steer_minus_R_xz * fork_base_half_turned_yx * steer_minus_R_xz - frame_base_inertia_xx);
    w[13] = frame_base_moment_x;
    w[14] = frame_base_moment_z;
    w[15] = frame_base_inertia_xz;
    w[16] = frame_base_inertia_yy;
    w[17] = frame_base_inertia_zz;

    /* rear_wheel: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal rear_wheel_mass = p[6]; /* kg */
    const wreal rear_wheel_inertia_xx = p[7]; /* kg m^2 */
    const wreal rear_wheel_inertia_zz = p[9]; /* kg m^2 */
    const wreal rear_wheel_base_mass = rear_wheel_mass + frame_mass
        + fork_mass_plus_front_wheel_mass;
    const wreal rear_wheel_base_inertia_xx = rear_wheel_inertia_xx + frame_base_inertia_xx;
    const wreal rear_wheel_base_inertia_zz = rear_wheel_inertia_zz + frame_base_inertia_xx;
    w[18] = rear_wheel_base_mass;
    w[19] = rear_wheel_base_inertia_xx;
    w[20] = rear_wheel_base_inertia_zz;

    /* shared by several: inertia */
    const wreal front_wheel_inertia_yy = p[24]; /* kg m^2 */
    const wreal fork_inertia_half_turned_yy = front_wheel_inertia_yy * front_hub_R_yy;
    w[21] = fork_inertia_half_turned_yy;

    /* fork: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal fork_composite_inertia_yy = fork_base_inertia_yy
        + front_hub_R_yy * fork_inertia_half_turned_yy;
    w[22] = fork_composite_inertia_yy;

    /* rear_contact: M */
    /* M = S . momentum */
    const wreal rear_radius_times_rear_wheel_base_mass = rear_radius * rear_wheel_base_mass;
    w[23] = rear_radius_times_rear_wheel_base_mass;

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

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
    const real rear_contact_yaw = q[2]; /* rad */
    const real rear_contact_lean = q[3]; /* rad */
    const real rear_contact_spin = q[4]; /* rad */
    const real rear_hub_q = q[5]; /* rad */
    const real steer_q = q[6]; /* rad */
    const real front_hub_q = q[7]; /* rad */
    const wreal steer_offset = w[7];
    const wreal front_hub_offset = w[8];
    const real front_hub_angle = front_hub_q + front_hub_offset;
    const real steer_angle = steer_q + steer_offset;
    const real angle[CARDAN_PADDED(6)] = {front_hub_angle, steer_angle, rear_hub_q,
        rear_contact_yaw, rear_contact_lean, rear_contact_spin};
    real sine[CARDAN_PADDED(6)], cosine[CARDAN_PADDED(6)];
    cardan_sincos(6, angle, sine, cosine);
    const real front_hub_angle_cos = cosine[0];
    const real front_hub_angle_sin = sine[0];
    const real steer_angle_cos = cosine[1];
    const real steer_angle_sin = sine[1];
    const real rear_hub_cos = cosine[2];
    const real rear_hub_sin = sine[2];
    const real rear_contact_yaw_cos = cosine[3];
    const real rear_contact_yaw_sin = sine[3];
    const real rear_contact_lean_cos = cosine[4];
    const real rear_contact_lean_sin = sine[4];
    const real rear_contact_spin_cos = cosine[5];
    const real rear_contact_spin_sin = sine[5];

    /* fork: inertia, composite, momentum */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* momentum = composite inertia S */
    const wreal front_hub_R_yy = w[6];
    const wreal front_wheel_base_inertia_zz = w[9];
    const wreal fork_base_moment_x = w[10];
    const wreal fork_base_inertia_xz = w[11];
    const wreal fork_base_inertia_zz = w[12];
    const wreal fork_inertia_half_turned_yy = w[21];
    const real fork_inertia_shear = front_wheel_base_inertia_zz * front_hub_angle_sin;
    const real front_hub_angle_sin_times_fork_inertia_shear = front_hub_angle_sin *
        fork_inertia_shear;
    const real fork_composite_inertia_xx = front_wheel_base_inertia_zz
        - front_hub_angle_sin_times_fork_inertia_shear;
    const real fork_composite_inertia_xz = fork_base_inertia_xz
        - front_hub_angle_cos * fork_inertia_shear * front_hub_R_yy;
    const real fork_composite_inertia_zz = fork_base_inertia_zz
        + front_hub_R_yy * front_hub_angle_sin_times_fork_inertia_shear * front_hub_R_yy;
    const real momentum_minus_front_hub_about_frame_my = fork_inertia_half_turned_yy *
        steer_angle_sin;
    const real momentum_front_hub_about_frame_my = -momentum_minus_front_hub_about_frame_my;
    const real momentum_minus_steer_about_frame_fy = fork_base_moment_x * steer_angle_sin;
    out[54] = fork_composite_inertia_zz; /* M: steer.u,steer.u */
    out[39] = momentum_front_hub_about_frame_my; /* M: rear_contact.u.spin,front_hub.u */
    out[47] = momentum_front_hub_about_frame_my; /* M: rear_hub.u,front_hub.u */
    out[60] = momentum_front_hub_about_frame_my; /* M: front_hub.u,rear_contact.u.spin */
    out[61] = momentum_front_hub_about_frame_my; /* M: front_hub.u,rear_hub.u */

    /* steer: R */
    /* R = R_fixed R_joint(q) */
    const wreal steer_minus_R_xz = w[4];
    const wreal steer_R_zz = w[5];
    const real steer_minus_R_xx = steer_R_zz * steer_angle_sin;
    const real steer_minus_R_xy = steer_R_zz * steer_angle_cos;
    const real steer_minus_R_zx = steer_minus_R_xz * steer_angle_sin;
    const real steer_minus_R_zy = steer_minus_R_xz * steer_angle_cos;

    /* frame: inertia, composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal rear_radius = w[0]; /* m */
    const wreal steer_place_x = w[2];
    const wreal frame_base_moment_x = w[13];
    const wreal frame_base_moment_z = w[14];
    const wreal frame_base_inertia_yy = w[16];
    const wreal fork_composite_inertia_yy = w[22];
    const real frame_inertia_shear = steer_angle_sin * (fork_composite_inertia_xx
        - fork_composite_inertia_yy);
    const real steer_angle_sin_times_frame_inertia_shear = steer_angle_sin * frame_inertia_shear;
    const real frame_minus_inertia_half_turned_xy_part = fork_composite_inertia_yy
        + steer_angle_sin_times_frame_inertia_shear;
    const real frame_inertia_half_turned_yy = steer_angle_cos * frame_inertia_shear;
    const real fork_composite_inertia_xz_times_steer_angle_sin = fork_composite_inertia_xz *
        steer_angle_sin;
    const real frame_minus_inertia_half_turned_xy_part_2 = steer_minus_R_xz *
        fork_composite_inertia_xz_times_steer_angle_sin;
    const real frame_minus_inertia_half_turned_xy = steer_R_zz *
        frame_minus_inertia_half_turned_xy_part + frame_minus_inertia_half_turned_xy_part_2;
    const real frame_minus_inertia_half_turned_xz_part = steer_R_zz *
        fork_composite_inertia_xz_times_steer_angle_sin;
    const real frame_minus_inertia_mean_moment_x = fork_base_moment_x * steer_minus_R_xx;
    const real frame_composite_moment_y = fork_base_moment_x * steer_angle_cos;
    const real frame_minus_inertia_mean_moment_z = fork_base_moment_x * steer_minus_R_zx;
    const real steer_place_x_times_frame_minus_inertia_mean_moment_x = steer_place_x *
        frame_minus_inertia_mean_moment_x;
    const real rear_radius_times_frame_minus_inertia_mean_moment_z = rear_radius *
        frame_minus_inertia_mean_moment_z;
    const real frame_inertia_shift = 2.0 * (rear_radius_times_frame_minus_inertia_mean_moment_z
        - steer_place_x_times_frame_minus_inertia_mean_moment_x);
    const real frame_composite_moment_x = frame_base_moment_x - frame_minus_inertia_mean_moment_x;
    const real frame_composite_moment_z = frame_base_moment_z - frame_minus_inertia_mean_moment_z;
    const real frame_composite_inertia_yy = frame_base_inertia_yy + fork_composite_inertia_xx
        + frame_inertia_shift - steer_angle_sin_times_frame_inertia_shear;
    out[37] = frame_composite_inertia_yy; /* M: rear_contact.u.spin,rear_hub.u */
    out[44] = frame_composite_inertia_yy; /* M: rear_hub.u,rear_contact.u.spin */
    out[45] = frame_composite_inertia_yy; /* M: rear_hub.u,rear_hub.u */

    /* shared by several: inertia, M */
    /* M = S . momentum */
    const real frame_inertia_half_turned_yz = fork_composite_inertia_xz * steer_angle_cos;
    const real steer_minus_R_xz_times_fork_composite_inertia_zz = steer_minus_R_xz *
        fork_composite_inertia_zz;
    const real steer_R_zz_times_fork_composite_inertia_zz = steer_R_zz * fork_composite_inertia_zz;
    const real rear_radius_times_momentum_minus_steer_about_frame_fy = rear_radius *
        momentum_minus_steer_about_frame_fy;

    /* frame: inertia, composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal frame_base_inertia_xz = w[15];
    const wreal frame_base_inertia_zz = w[17];
    const real frame_minus_inertia_half_turned_xz = frame_minus_inertia_half_turned_xz_part
        + steer_minus_R_xz_times_fork_composite_inertia_zz;
    const real frame_composite_inertia_xx = frame_inertia_shift
        + 2.0 * steer_place_x_times_frame_minus_inertia_mean_moment_x
        + steer_minus_R_xz * frame_minus_inertia_half_turned_xz
        + steer_R_zz * frame_minus_inertia_half_turned_xy;
    const real frame_minus_composite_inertia_xy = steer_minus_R_xz * frame_inertia_half_turned_yz
        + steer_place_x * frame_composite_moment_y + steer_R_zz * frame_inertia_half_turned_yy;
    const real frame_composite_inertia_yz = steer_R_zz * frame_inertia_half_turned_yz
        + rear_radius * frame_composite_moment_y - steer_minus_R_xz * frame_inertia_half_turned_yy;
    const real frame_composite_inertia_xz = frame_base_inertia_xz
        - rear_radius * frame_minus_inertia_mean_moment_x
        + steer_place_x * frame_minus_inertia_mean_moment_z
        - steer_R_zz * frame_minus_inertia_half_turned_xz
        + steer_minus_R_xz * frame_minus_inertia_half_turned_xy;
    const real frame_composite_inertia_zz_part = frame_base_inertia_zz
        - 2.0 * rear_radius_times_frame_minus_inertia_mean_moment_z + frame_inertia_shift
        + steer_R_zz * (steer_R_zz_times_fork_composite_inertia_zz
        - frame_minus_inertia_half_turned_xy_part_2);
    const real frame_composite_inertia_zz = frame_composite_inertia_zz_part
        - steer_minus_R_xz * (frame_minus_inertia_half_turned_xz_part
        - steer_minus_R_xz * frame_minus_inertia_half_turned_xy_part);

    /* rear_wheel: inertia, composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal rear_wheel_inertia_yy = w[1]; /* kg m^2 */
    const wreal rear_wheel_base_inertia_xx = w[19];
    const wreal rear_wheel_base_inertia_zz = w[20];
    const real rear_wheel_inertia_shear = rear_hub_sin * (frame_composite_inertia_zz
        - frame_composite_inertia_xx) + rear_hub_cos * (frame_composite_inertia_xz
        + frame_composite_inertia_xz);
    const real rear_hub_sin_times_rear_wheel_inertia_shear = rear_hub_sin *
        rear_wheel_inertia_shear;
    const real rear_wheel_composite_inertia_xz = rear_hub_cos * rear_wheel_inertia_shear
        - frame_composite_inertia_xz;
    const real rear_wheel_composite_inertia_xy = frame_composite_inertia_yz * rear_hub_sin
        - frame_minus_composite_inertia_xy * rear_hub_cos;
    const real rear_wheel_composite_moment_x = frame_composite_moment_x * rear_hub_cos
        + frame_composite_moment_z * rear_hub_sin;
    const real rear_wheel_composite_moment_z = frame_composite_moment_z * rear_hub_cos
        - frame_composite_moment_x * rear_hub_sin;
    const real rear_wheel_composite_inertia_xx = rear_wheel_base_inertia_xx
        + frame_composite_inertia_xx + rear_hub_sin_times_rear_wheel_inertia_shear;
    const real rear_wheel_composite_inertia_yy = rear_wheel_inertia_yy + frame_composite_inertia_yy;
    const real rear_wheel_composite_inertia_zz = rear_wheel_base_inertia_zz
        + frame_composite_inertia_zz - rear_hub_sin_times_rear_wheel_inertia_shear;
    out[36] = rear_wheel_composite_inertia_yy; /* M: rear_contact.u.spin,rear_contact.u.spin */

    /* shared by several: inertia, M */
    /* M = S . momentum */
    const real momentum_rear_hub_about_rear_wheel_mz = frame_composite_inertia_yz * rear_hub_cos
        + frame_minus_composite_inertia_xy * rear_hub_sin;
    const real rear_wheel_composite_inertia_xy_times_rear_contact_spin_cos =
        rear_wheel_composite_inertia_xy * rear_contact_spin_cos;

    /* rear_wheel: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const real rear_wheel_composite_inertia_yz = momentum_rear_hub_about_rear_wheel_mz
        + momentum_rear_hub_about_rear_wheel_mz - momentum_rear_hub_about_rear_wheel_mz;

    /* fork: momentum */
    /* momentum = composite inertia S */
    const real momentum_minus_front_hub_about_frame_mx = fork_inertia_half_turned_yy *
        steer_minus_R_xy;
    const real momentum_minus_front_hub_about_frame_mz = fork_inertia_half_turned_yy *
        steer_minus_R_zy;
    const real momentum_minus_steer_about_frame_fx = fork_base_moment_x * steer_minus_R_xy;
    const real momentum_minus_steer_about_frame_fz = fork_base_moment_x * steer_minus_R_zy;
    const real momentum_minus_steer_about_frame_mx = fork_composite_inertia_xz * steer_minus_R_xx
        + rear_radius_times_momentum_minus_steer_about_frame_fy
        + steer_minus_R_xz_times_fork_composite_inertia_zz;
    const real momentum_steer_about_frame_mz = steer_R_zz_times_fork_composite_inertia_zz
        - (fork_composite_inertia_xz * steer_minus_R_zx
        + steer_place_x * momentum_minus_steer_about_frame_fy);

    /* frame: momentum */
    /* momentum = composite inertia S */
    const real momentum_minus_front_hub_about_rear_wheel_mx = rear_hub_cos *
        momentum_minus_front_hub_about_frame_mx
        + rear_hub_sin * momentum_minus_front_hub_about_frame_mz;
    const real momentum_front_hub_about_rear_wheel_mz = rear_hub_sin *
        momentum_minus_front_hub_about_frame_mx
        - rear_hub_cos * momentum_minus_front_hub_about_frame_mz;
    const real momentum_minus_steer_about_rear_wheel_fx = rear_hub_cos *
        momentum_minus_steer_about_frame_fx + rear_hub_sin * momentum_minus_steer_about_frame_fz;
    const real momentum_steer_about_rear_wheel_fz = rear_hub_sin *
        momentum_minus_steer_about_frame_fx - rear_hub_cos * momentum_minus_steer_about_frame_fz;
    const real momentum_steer_about_rear_wheel_mx = rear_hub_sin * momentum_steer_about_frame_mz
        - rear_hub_cos * momentum_minus_steer_about_frame_mx;
    const real momentum_steer_about_rear_wheel_mz = rear_hub_sin *
        momentum_minus_steer_about_frame_mx + rear_hub_cos * momentum_steer_about_frame_mz;

    /* rear_contact: R, S, M */
    /* R = R_fixed R_joint(q) */
    /* S = d(twist of the child) / du */
    /* M = S . momentum */
    const wreal rear_radius_times_rear_wheel_base_mass = w[23];
    const real rear_contact_minus_R_xy = rear_contact_yaw_sin * rear_contact_lean_cos;
    const real rear_contact_yaw_sin_times_lean_sin = rear_contact_yaw_sin * rear_contact_lean_sin;
    const real rear_contact_R_yy = rear_contact_yaw_cos * rear_contact_lean_cos;
    const real rear_contact_yaw_cos_times_lean_sin = rear_contact_yaw_cos * rear_contact_lean_sin;
    const real rear_contact_R_xx = rear_contact_yaw_cos * rear_contact_spin_cos
        - rear_contact_yaw_sin_times_lean_sin * rear_contact_spin_sin;
    const real rear_contact_R_xz = rear_contact_yaw_cos * rear_contact_spin_sin
        + rear_contact_yaw_sin_times_lean_sin * rear_contact_spin_cos;
    const real rear_contact_R_yx = rear_contact_yaw_sin * rear_contact_spin_cos
        + rear_contact_yaw_cos_times_lean_sin * rear_contact_spin_sin;
    const real rear_contact_R_yz = rear_contact_yaw_sin * rear_contact_spin_sin
        - rear_contact_yaw_cos_times_lean_sin * rear_contact_spin_cos;
    const real rear_contact_minus_R_zx = rear_contact_lean_cos * rear_contact_spin_sin;
    const real rear_contact_R_zz = rear_contact_lean_cos * rear_contact_spin_cos;
    const real rear_radius_times_rear_contact_lean_sin = rear_radius * rear_contact_lean_sin;
    const real M_steer_rear_contact_yaw_part = rear_contact_spin_cos *
        rear_radius_times_rear_contact_lean_sin;
    const real M_steer_rear_contact_yaw_part_2 = rear_contact_spin_sin *
        rear_radius_times_rear_contact_lean_sin;
    const real momentum_minus_rear_contact_lean_fx = frame_composite_moment_y *
        rear_contact_spin_sin;
    const real momentum_minus_rear_contact_lean_fy = rear_radius_times_rear_wheel_base_mass
        + rear_wheel_composite_moment_z * rear_contact_spin_cos
        - rear_wheel_composite_moment_x * rear_contact_spin_sin;

    /* M */
    /* M = S . momentum */
    const real M_front_hub_rear_contact_yaw = momentum_minus_front_hub_about_rear_wheel_mx *
        rear_contact_minus_R_zx - momentum_minus_front_hub_about_frame_my * rear_contact_lean_sin
        + momentum_front_hub_about_rear_wheel_mz * rear_contact_R_zz;
    const real M_front_hub_rear_contact_lean = momentum_front_hub_about_rear_wheel_mz *
        rear_contact_spin_sin
        - momentum_minus_front_hub_about_rear_wheel_mx * rear_contact_spin_cos;
    const real M_steer_rear_contact_spin = rear_radius * momentum_minus_steer_about_frame_fx
        + steer_place_x * momentum_minus_steer_about_frame_fz + frame_inertia_half_turned_yz;
    const real M_steer_rear_contact_x = rear_contact_minus_R_xy *
        momentum_minus_steer_about_frame_fy
        - rear_contact_R_xx * momentum_minus_steer_about_rear_wheel_fx
        + rear_contact_R_xz * momentum_steer_about_rear_wheel_fz;
    const real M_steer_rear_contact_y = rear_contact_R_yz * momentum_steer_about_rear_wheel_fz
        - rear_contact_R_yy * momentum_minus_steer_about_frame_fy
        - rear_contact_R_yx * momentum_minus_steer_about_rear_wheel_fx;
    const real M_steer_rear_contact_lean = rear_radius_times_momentum_minus_steer_about_frame_fy
        + rear_contact_spin_cos * momentum_steer_about_rear_wheel_mx
        + rear_contact_spin_sin * momentum_steer_about_rear_wheel_mz;
    const real M_rear_hub_rear_contact_lean =
        rear_wheel_composite_inertia_xy_times_rear_contact_spin_cos
        + momentum_rear_hub_about_rear_wheel_mz * rear_contact_spin_sin;
    out[23] = M_front_hub_rear_contact_yaw; /* M: rear_contact.u.yaw,front_hub.u */
    out[58] = M_front_hub_rear_contact_yaw; /* M: front_hub.u,rear_contact.u.yaw */
    out[31] = M_front_hub_rear_contact_lean; /* M: rear_contact.u.lean,front_hub.u */
    out[59] = M_front_hub_rear_contact_lean; /* M: front_hub.u,rear_contact.u.lean */
    out[38] = M_steer_rear_contact_spin; /* M: rear_contact.u.spin,steer.u */
    out[46] = M_steer_rear_contact_spin; /* M: rear_hub.u,steer.u */
    out[52] = M_steer_rear_contact_spin; /* M: steer.u,rear_contact.u.spin */
    out[53] = M_steer_rear_contact_spin; /* M: steer.u,rear_hub.u */
    out[6] = M_steer_rear_contact_x; /* M: rear_contact.u.x,steer.u */
    out[48] = M_steer_rear_contact_x; /* M: steer.u,rear_contact.u.x */
    out[14] = M_steer_rear_contact_y; /* M: rear_contact.u.y,steer.u */
    out[49] = M_steer_rear_contact_y; /* M: steer.u,rear_contact.u.y */
    out[30] = M_steer_rear_contact_lean; /* M: rear_contact.u.lean,steer.u */
    out[51] = M_steer_rear_contact_lean; /* M: steer.u,rear_contact.u.lean */
    out[29] = M_rear_hub_rear_contact_lean; /* M: rear_contact.u.lean,rear_hub.u */
    out[43] = M_rear_hub_rear_contact_lean; /* M: rear_hub.u,rear_contact.u.lean */

    /* steer: M */
    /* M = S . momentum */
    const real M_steer_rear_contact_yaw_part_3 = M_steer_rear_contact_yaw_part_2 *
        momentum_steer_about_rear_wheel_fz
        - M_steer_rear_contact_yaw_part * momentum_minus_steer_about_rear_wheel_fx
        + rear_contact_lean_sin * M_steer_rear_contact_spin
        - rear_contact_minus_R_zx * momentum_steer_about_rear_wheel_mx;

    /* M */
    /* M = S . momentum */
    const real M_steer_rear_contact_yaw = rear_contact_R_zz * momentum_steer_about_rear_wheel_mz
        + M_steer_rear_contact_yaw_part_3;
    out[22] = M_steer_rear_contact_yaw; /* M: rear_contact.u.yaw,steer.u */
    out[50] = M_steer_rear_contact_yaw; /* M: steer.u,rear_contact.u.yaw */

    /* momentum */
    /* momentum = composite inertia S */
    const wreal rear_wheel_base_mass = w[18];
    const real momentum_rear_contact_x_my = rear_wheel_composite_moment_z * rear_contact_R_xx
        - rear_wheel_composite_moment_x * rear_contact_R_xz;
    const real momentum_rear_contact_y_my = rear_wheel_composite_moment_z * rear_contact_R_yx
        - rear_wheel_composite_moment_x * rear_contact_R_yz;
    const real momentum_rear_contact_yaw_fy = rear_wheel_composite_moment_z *
        rear_contact_minus_R_zx + rear_wheel_composite_moment_x * rear_contact_R_zz;
    const real momentum_rear_contact_x_fx = rear_wheel_base_mass * rear_contact_R_xx;
    const real momentum_rear_contact_x_fz = rear_wheel_base_mass * rear_contact_R_xz;
    const real momentum_rear_contact_y_fx = rear_wheel_base_mass * rear_contact_R_yx;
    const real momentum_rear_contact_y_fy = rear_wheel_base_mass * rear_contact_R_yy;
    const real momentum_rear_contact_y_fz = rear_wheel_base_mass * rear_contact_R_yz;
    const real momentum_rear_contact_yaw_mx = rear_wheel_composite_inertia_xy *
        rear_contact_lean_sin + frame_composite_moment_y * M_steer_rear_contact_yaw_part_2
        - rear_wheel_composite_inertia_xx * rear_contact_minus_R_zx
        + rear_wheel_composite_inertia_xz * rear_contact_R_zz;
    const real momentum_rear_contact_yaw_mz = rear_wheel_composite_inertia_yz *
        rear_contact_lean_sin - frame_composite_moment_y * M_steer_rear_contact_yaw_part
        - rear_wheel_composite_inertia_xz * rear_contact_minus_R_zx
        + rear_wheel_composite_inertia_zz * rear_contact_R_zz;
    const real momentum_rear_contact_yaw_fx = rear_wheel_base_mass * M_steer_rear_contact_yaw_part -
        frame_composite_moment_y * rear_contact_R_zz
        + rear_wheel_composite_moment_z * rear_contact_lean_sin;
    const real momentum_rear_contact_yaw_fz = rear_wheel_base_mass * M_steer_rear_contact_yaw_part_2
        - frame_composite_moment_y * rear_contact_minus_R_zx
        - rear_wheel_composite_moment_x * rear_contact_lean_sin;
    const real momentum_rear_contact_lean_my =
        rear_wheel_composite_inertia_xy_times_rear_contact_spin_cos
        + rear_wheel_composite_inertia_yz * rear_contact_spin_sin;
    const real momentum_rear_contact_lean_mx = rear_wheel_composite_inertia_xx *
        rear_contact_spin_cos + rear_radius * rear_wheel_composite_moment_z
        + rear_wheel_composite_inertia_xz * rear_contact_spin_sin;
    const real momentum_rear_contact_lean_mz = rear_wheel_composite_inertia_xz *
        rear_contact_spin_cos - rear_radius * rear_wheel_composite_moment_x
        + rear_wheel_composite_inertia_zz * rear_contact_spin_sin;
    const real momentum_rear_contact_lean_fz = frame_composite_moment_y * rear_contact_spin_cos;
    out[4] = momentum_rear_contact_x_my; /* M: rear_contact.u.x,rear_contact.u.spin */
    out[5] = momentum_rear_contact_x_my; /* M: rear_contact.u.x,rear_hub.u */
    out[32] = momentum_rear_contact_x_my; /* M: rear_contact.u.spin,rear_contact.u.x */
    out[40] = momentum_rear_contact_x_my; /* M: rear_hub.u,rear_contact.u.x */
    out[12] = momentum_rear_contact_y_my; /* M: rear_contact.u.y,rear_contact.u.spin */
    out[13] = momentum_rear_contact_y_my; /* M: rear_contact.u.y,rear_hub.u */
    out[33] = momentum_rear_contact_y_my; /* M: rear_contact.u.spin,rear_contact.u.y */
    out[41] = momentum_rear_contact_y_my; /* M: rear_hub.u,rear_contact.u.y */
    out[28] = momentum_rear_contact_lean_my; /* M: rear_contact.u.lean,rear_contact.u.spin */
    out[35] = momentum_rear_contact_lean_my; /* M: rear_contact.u.spin,rear_contact.u.lean */

    /* shared by several: M */
    /* M = S . momentum */
    const real M_rear_hub_rear_contact_yaw_part = rear_wheel_composite_inertia_xy *
        rear_contact_minus_R_zx;
    const real M_rear_hub_rear_contact_yaw_part_2 = rear_wheel_composite_moment_z *
        M_steer_rear_contact_yaw_part
        - rear_wheel_composite_moment_x * M_steer_rear_contact_yaw_part_2;

    /* M */
    /* M = S . momentum */
    const real M_rear_hub_rear_contact_yaw = frame_composite_inertia_yy * rear_contact_lean_sin
        + M_rear_hub_rear_contact_yaw_part_2 - M_rear_hub_rear_contact_yaw_part
        + momentum_rear_hub_about_rear_wheel_mz * rear_contact_R_zz;
    const real M_rear_contact_y_rear_contact_x = rear_contact_R_xx * momentum_rear_contact_y_fx
        - rear_contact_minus_R_xy * momentum_rear_contact_y_fy
        + rear_contact_R_xz * momentum_rear_contact_y_fz;
    const real M_rear_contact_yaw_rear_contact_x = rear_contact_R_xx * momentum_rear_contact_yaw_fx
        - rear_contact_minus_R_xy * momentum_rear_contact_yaw_fy
        + rear_contact_R_xz * momentum_rear_contact_yaw_fz;
    const real M_rear_contact_yaw_rear_contact_y = rear_contact_R_yx * momentum_rear_contact_yaw_fx
        + rear_contact_R_yy * momentum_rear_contact_yaw_fy
        + rear_contact_R_yz * momentum_rear_contact_yaw_fz;
    const real M_rear_contact_lean_rear_contact_x = rear_contact_R_xz *
        momentum_rear_contact_lean_fz - rear_contact_R_xx * momentum_minus_rear_contact_lean_fx
        + rear_contact_minus_R_xy * momentum_minus_rear_contact_lean_fy;
    const real M_rear_contact_lean_rear_contact_y = rear_contact_R_yz *
        momentum_rear_contact_lean_fz - rear_contact_R_yx * momentum_minus_rear_contact_lean_fx
        - rear_contact_R_yy * momentum_minus_rear_contact_lean_fy;
    out[21] = M_rear_hub_rear_contact_yaw; /* M: rear_contact.u.yaw,rear_hub.u */
    out[42] = M_rear_hub_rear_contact_yaw; /* M: rear_hub.u,rear_contact.u.yaw */
    /* M: rear_contact.u.x,rear_contact.u.x */
    out[0] = rear_contact_R_xx * momentum_rear_contact_x_fx
        + rear_wheel_base_mass * rear_contact_minus_R_xy * rear_contact_minus_R_xy
        + rear_contact_R_xz * momentum_rear_contact_x_fz;
    out[1] = M_rear_contact_y_rear_contact_x; /* M: rear_contact.u.x,rear_contact.u.y */
    out[8] = M_rear_contact_y_rear_contact_x; /* M: rear_contact.u.y,rear_contact.u.x */
    /* M: rear_contact.u.y,rear_contact.u.y */
    out[9] = rear_contact_R_yx * momentum_rear_contact_y_fx
        + rear_contact_R_yy * momentum_rear_contact_y_fy
        + rear_contact_R_yz * momentum_rear_contact_y_fz;
    out[2] = M_rear_contact_yaw_rear_contact_x; /* M: rear_contact.u.x,rear_contact.u.yaw */
    out[16] = M_rear_contact_yaw_rear_contact_x; /* M: rear_contact.u.yaw,rear_contact.u.x */
    out[10] = M_rear_contact_yaw_rear_contact_y; /* M: rear_contact.u.y,rear_contact.u.yaw */
    out[17] = M_rear_contact_yaw_rear_contact_y; /* M: rear_contact.u.yaw,rear_contact.u.y */
    out[3] = M_rear_contact_lean_rear_contact_x; /* M: rear_contact.u.x,rear_contact.u.lean */
    out[24] = M_rear_contact_lean_rear_contact_x; /* M: rear_contact.u.lean,rear_contact.u.x */
    out[11] = M_rear_contact_lean_rear_contact_y; /* M: rear_contact.u.y,rear_contact.u.lean */
    out[25] = M_rear_contact_lean_rear_contact_y; /* M: rear_contact.u.lean,rear_contact.u.y */
    /* M: rear_contact.u.lean,rear_contact.u.lean */
    out[27] = rear_contact_spin_cos * momentum_rear_contact_lean_mx
        + rear_radius * momentum_minus_rear_contact_lean_fy
        + rear_contact_spin_sin * momentum_rear_contact_lean_mz;

    /* momentum */
    /* momentum = composite inertia S */
    const real momentum_rear_contact_yaw_my = rear_wheel_composite_inertia_yy *
        rear_contact_lean_sin - M_rear_hub_rear_contact_yaw_part
        + rear_wheel_composite_inertia_yz * rear_contact_R_zz + M_rear_hub_rear_contact_yaw_part_2;
    out[20] = momentum_rear_contact_yaw_my; /* M: rear_contact.u.yaw,rear_contact.u.spin */
    out[34] = momentum_rear_contact_yaw_my; /* M: rear_contact.u.spin,rear_contact.u.yaw */

    /* rear_contact: M */
    /* M = S . momentum */
    const real M_rear_contact_yaw_rear_contact_yaw_part = M_steer_rear_contact_yaw_part *
        momentum_rear_contact_yaw_fx
        + M_steer_rear_contact_yaw_part_2 * momentum_rear_contact_yaw_fz
        + rear_contact_lean_sin * momentum_rear_contact_yaw_my
        - rear_contact_minus_R_zx * momentum_rear_contact_yaw_mx;
    const real M_rear_contact_lean_rear_contact_yaw_part = M_steer_rear_contact_yaw_part_2 *
        momentum_rear_contact_lean_fz
        - M_steer_rear_contact_yaw_part * momentum_minus_rear_contact_lean_fx
        + rear_contact_lean_sin * momentum_rear_contact_lean_my
        - rear_contact_minus_R_zx * momentum_rear_contact_lean_mx;

    /* M */
    /* M = S . momentum */
    const real M_rear_contact_lean_rear_contact_yaw = rear_contact_R_zz *
        momentum_rear_contact_lean_mz + M_rear_contact_lean_rear_contact_yaw_part;
    /* M: rear_contact.u.yaw,rear_contact.u.yaw */
    out[18] = rear_contact_R_zz * momentum_rear_contact_yaw_mz
        + M_rear_contact_yaw_rear_contact_yaw_part;
    out[19] = M_rear_contact_lean_rear_contact_yaw; /* M: rear_contact.u.yaw,rear_contact.u.lean */
    out[26] = M_rear_contact_lean_rear_contact_yaw; /* M: rear_contact.u.lean,rear_contact.u.yaw */

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
const int mass_matrix_sizes[] = {64, 0, 24, 0, 8, 0, 0, 0, 0, 26, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
