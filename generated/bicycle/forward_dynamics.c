/*
 * forward_dynamics of bicycle
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: axes, base_parameters
 * passes: unroll
 *
 * Sizes: out 8, work 55, w 38
 * Operations per call: 3131 = 1755 mul, 669 add, 669 sub, 19 div, 6 cos, 6 sin, 3 neg, 2 select,
 *     1 solve, 1 sqrt
 * Operations of prepare: 220 = 92 mul, 62 add, 42 sub, 7 div, 4 neg, 4 select, 3 sqrt, 2 atan2,
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
    const wreal tilt_sin = sine[0];
    const wreal tilt_cos = cosine[0];

    /* frame: mass, first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
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
    const wreal frame_origin_inertia_yy = frame_com_x_times_first_moment_x
        + sum_c0p9_minus_rear_radius_times_frame_first_moment_z + frame_inertia_yy;
    const wreal frame_origin_inertia_zz = frame_inertia_zz + frame_com_x_times_first_moment_x;
    const wreal frame_base_half_trace = 0.5 * (frame_origin_inertia_xx + frame_origin_inertia_yy
        + frame_origin_inertia_zz);

    /* steer: place */
    const wreal wheelbase = p[0]; /* m */
    const wreal trail = p[1]; /* m */
    const wreal steer_place_x = wheelbase + trail;
    w[4] = steer_place_x;

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
    const wreal fork_origin_inertia_yy = fork_origin_inertia_yy_part
        + fork_com_z_times_first_moment_z + fork_inertia_yy;
    const wreal fork_origin_inertia_zz = fork_inertia_zz + fork_origin_inertia_yy_part;

    /* common */
    const wreal sqrt_of_tilt_sin_squared_plus_cos_squared = cardan_sqrt(tilt_sin * tilt_sin
        + tilt_cos * tilt_cos);
    const wreal steer_minus_R_xz = tilt_sin / sqrt_of_tilt_sin_squared_plus_cos_squared;
    w[5] = steer_minus_R_xz;

    /* steer: R */
    /* R = R_fixed R_joint(q) */
    const wreal steer_R_zz = tilt_cos / sqrt_of_tilt_sin_squared_plus_cos_squared;
    w[6] = steer_R_zz;

    /* fork: axes, mass */
    const wreal fork_axes_side = cardan_select(cardan_lt(steer_R_zz, 0.0), -1.0, 1.0);
    const wreal steer_minus_R_xz_times_fork_axes_side = steer_minus_R_xz * fork_axes_side;
    const wreal fork_base_inertia_zz_part = steer_R_zz * (fork_origin_inertia_zz * steer_R_zz
        - fork_origin_inertia_xz * steer_minus_R_xz)
        - steer_minus_R_xz * (fork_origin_inertia_xz * steer_R_zz
        - fork_origin_inertia_xx * steer_minus_R_xz);

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
    const wreal fork_base_half_turned_yx_part = fork_axes_unit_x * fork_mass_half_turned_xx
        + fork_axes_unit_z * fork_mass_half_turned_xz;

    /* front_hub: R, p, place */
    /* R = R_fixed R_joint(q) */
    /* p = p_fixed + R_fixed p_joint(q) */
    const wreal front_radius = p[4]; /* m */
    const wreal front_hub_R_yy = steer_R_zz * fork_axes_unit_x
        + steer_minus_R_xz * fork_axes_unit_z;
    const wreal front_hub_p_x = front_radius * fork_axes_unit_z - trail * fork_axes_unit_x;
    const wreal front_hub_p_z = trail * steer_minus_R_xz + front_radius * steer_R_zz;
    const wreal front_hub_offset = cardan_atan2(-steer_R_zz * front_hub_R_yy, fork_axes_unit_z);
    w[7] = front_hub_R_yy;
    w[9] = front_hub_p_x;
    w[10] = front_hub_p_z;
    w[11] = front_hub_offset;

    /* steer: place */
    const wreal steer_offset = cardan_atan2(-front_hub_R_yy, 0.0);
    w[8] = steer_offset;

    /* fork: mass, base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal front_hub_R_yy_times_fork_mass_half_turned_yy = fork_origin_inertia_yy *
        front_hub_R_yy * front_hub_R_yy;
    const wreal fork_base_half_trace = 0.5 * (fork_base_half_turned_yx_part
        + front_hub_R_yy_times_fork_mass_half_turned_yy + fork_base_inertia_zz_part);

    /* front_wheel: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal front_wheel_mass = p[22]; /* kg */
    const wreal front_wheel_inertia_xx = p[23]; /* kg m^2 */
    const wreal front_wheel_inertia_yy = p[24]; /* kg m^2 */
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
    const wreal fork_base_half_turned_yx = front_wheel_base_inertia_yy
        - front_wheel_base_second_xx + front_wheel_inertia_xx + fork_base_half_turned_yx_part;
    const wreal front_wheel_base_half_trace = 0.5 * (front_wheel_inertia_xx
        + front_wheel_inertia_yy + front_wheel_inertia_zz);
    const wreal front_wheel_base_second_moment_xx = front_wheel_base_half_trace
        - front_wheel_inertia_xx;
    const wreal front_wheel_base_second_moment_zz = front_wheel_base_half_trace
        - front_wheel_inertia_zz;
    const wreal fork_minus_base_half_turned_xz_part = fork_base_half_trace
        - fork_base_inertia_zz_part + front_wheel_base_second_zz;
    w[12] = front_wheel_base_inertia_zz;
    w[26] = front_wheel_base_second_moment_xx;
    w[27] = front_wheel_base_second_moment_zz;

    /* fork: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal fork_base_moment_x = fork_first_moment_x * fork_axes_unit_x
        + fork_first_moment_z * fork_axes_unit_z + front_wheel_base_mass_moment_x;
    const wreal fork_base_inertia_xz = steer_R_zz * fork_mass_half_turned_xz
        - steer_minus_R_xz * fork_mass_half_turned_xx
        - front_hub_p_z * front_wheel_base_mass_moment_x;
    const wreal fork_base_inertia_zz = front_wheel_base_inertia_yy - front_wheel_base_second_zz
        + front_wheel_inertia_xx * front_hub_R_yy * front_hub_R_yy + fork_base_inertia_zz_part;
    const wreal fork_base_inertia_yy = front_hub_R_yy_times_fork_mass_half_turned_yy
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
    const wreal fork_base_inertia_xz_part = steer_place_x * fork_base_mean_moment_z
        - rear_radius * fork_base_mean_moment_x;
    const wreal frame_base_inertia_xx = fork_base_shift
        - 2.0 * steer_place_x_times_fork_base_mean_moment_x
        + steer_R_zz * fork_minus_base_half_turned_xy + frame_origin_inertia_xx;
    const wreal fork_base_second_moment_xx = fork_base_half_trace - fork_base_half_turned_yx_part
        + front_wheel_base_second_xx;
    const wreal fork_base_second_moment_yy = fork_base_half_trace
        - front_hub_R_yy_times_fork_mass_half_turned_yy
        + front_hub_R_yy * (front_wheel_base_half_trace - front_wheel_inertia_yy) * front_hub_R_yy;
    const wreal fork_minus_base_half_turned_xz = steer_minus_R_xz *
        fork_minus_base_half_turned_xz_part;
    w[13] = fork_base_moment_x;
    w[14] = fork_base_inertia_xz;
    w[15] = fork_base_inertia_zz;
    w[28] = fork_base_second_moment_xx;
    w[29] = fork_base_second_moment_yy;

    /* frame: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal frame_base_moment_x = steer_place_x * fork_mass_plus_front_wheel_mass
        - fork_base_mean_moment_x_part_2 + frame_first_moment_x;
    const wreal frame_base_moment_z = fork_base_mean_moment_z_part
        - rear_radius * fork_mass_plus_front_wheel_mass + frame_first_moment_z;
    const wreal frame_base_inertia_xz = steer_minus_R_xz * fork_minus_base_half_turned_xy
        - fork_base_inertia_xz_part + frame_origin_inertia_xz;
    const wreal frame_base_inertia_yy = fork_base_half_turned_yx + fork_base_shift
        + frame_origin_inertia_yy;
    const wreal frame_base_inertia_zz = fork_base_shift
        + 2.0 * rear_radius_times_fork_base_mean_moment_z
        + steer_minus_R_xz * fork_base_half_turned_yx * steer_minus_R_xz
        + frame_origin_inertia_zz - frame_base_inertia_xx;
    const wreal frame_base_second_moment_xx = frame_base_half_trace - frame_origin_inertia_xx
        + (steer_place_x_times_fork_base_mean_moment_x
        + steer_place_x_times_fork_base_mean_moment_x
        + steer_minus_R_xz * fork_minus_base_half_turned_xz);
    const wreal frame_base_second_moment_xz = fork_base_inertia_xz_part
        - steer_R_zz * fork_minus_base_half_turned_xz - frame_origin_inertia_xz;
    const wreal frame_base_second_moment_zz = frame_base_half_trace - frame_origin_inertia_zz
        + (steer_R_zz * fork_minus_base_half_turned_xz_part * steer_R_zz
        - (rear_radius_times_fork_base_mean_moment_z + rear_radius_times_fork_base_mean_moment_z));
    w[16] = frame_base_moment_x;
    w[17] = frame_base_moment_z;
    w[18] = frame_base_inertia_xz;
    w[19] = frame_base_inertia_yy;
    w[20] = frame_base_inertia_zz;
    w[30] = frame_base_second_moment_xx;
    w[31] = frame_base_second_moment_xz;
    w[32] = frame_base_second_moment_zz;

    /* rear_wheel: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal rear_wheel_mass = p[6]; /* kg */
    const wreal rear_wheel_inertia_xx = p[7]; /* kg m^2 */
    const wreal rear_wheel_inertia_yy = p[8]; /* kg m^2 */
    const wreal rear_wheel_inertia_zz = p[9]; /* kg m^2 */
    const wreal rear_wheel_base_mass = frame_mass + fork_mass_plus_front_wheel_mass
        + rear_wheel_mass;
    const wreal rear_wheel_base_inertia_xx = rear_wheel_inertia_xx + frame_base_inertia_xx;
    const wreal rear_wheel_base_inertia_zz = rear_wheel_inertia_zz + frame_base_inertia_xx;
    const wreal rear_wheel_base_half_trace = 0.5 * (rear_wheel_inertia_xx + rear_wheel_inertia_yy
        + rear_wheel_inertia_zz);
    const wreal rear_wheel_base_second_moment_xx = rear_wheel_base_half_trace
        - rear_wheel_inertia_xx;
    const wreal rear_wheel_base_second_moment_zz = rear_wheel_base_half_trace
        - rear_wheel_inertia_zz;
    const wreal rear_wheel_base_second_moment_yy = rear_wheel_base_half_trace
        - rear_wheel_inertia_yy + (frame_base_half_trace - frame_origin_inertia_yy);
    w[21] = rear_wheel_base_mass;
    w[22] = rear_wheel_base_inertia_xx;
    w[23] = rear_wheel_base_inertia_zz;
    w[24] = rear_wheel_base_second_moment_xx;
    w[25] = rear_wheel_base_second_moment_zz;
    w[33] = rear_wheel_base_second_moment_yy;

    /* shared by several: inertia */
    const wreal fork_inertia_half_turned_yy = front_wheel_inertia_yy * front_hub_R_yy;
    w[34] = fork_inertia_half_turned_yy;

    /* fork: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal fork_composite_inertia_yy = fork_base_inertia_yy
        + front_hub_R_yy * fork_inertia_half_turned_yy;
    w[35] = fork_composite_inertia_yy;

    /* rear_contact: M */
    /* M = S . momentum */
    const wreal rear_radius_times_rear_wheel_base_mass = rear_radius * rear_wheel_base_mass;
    w[36] = rear_radius_times_rear_wheel_base_mass;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal M_factor_D_inverse_front_hub = 1.0 / front_wheel_inertia_yy;
    w[37] = M_factor_D_inverse_front_hub;

    /* parameters as they are */
    w[0] = p[3]; /* rear_radius [m] */
    w[1] = p[4]; /* front_radius [m] */
    w[2] = p[5]; /* gravity.z [m/s^2] */
    w[3] = p[8]; /* rear_wheel.inertia.yy [kg m^2] */
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
    real (*const circuit_matrix)[5] = (real (*)[5])(work + 0);
    real *const circuit_right = work + 25;
    real *const circuit_scratch = work + 30;
    int status = CARDAN_OK;

    /* shared by several: R, G */
    /* R = R_fixed R_joint(q) */
    /* G = d(rate) / du */
    const real rear_contact_yaw = q[2]; /* rad */
    const real rear_contact_lean = q[3]; /* rad */
    const real rear_contact_spin = q[4]; /* rad */
    const real rear_hub_q = q[5]; /* rad */
    const real steer_q = q[6]; /* rad */
    const real front_hub_q = q[7]; /* rad */
    const wreal steer_offset = w[8];
    const wreal front_hub_offset = w[11];
    const real steer_angle = steer_q + steer_offset;
    const real front_hub_angle = front_hub_q + front_hub_offset;
    const real angle[CARDAN_PADDED(6)] = {rear_contact_yaw, rear_contact_lean, rear_contact_spin,
        rear_hub_q, steer_angle, front_hub_angle};
    real sine[CARDAN_PADDED(6)], cosine[CARDAN_PADDED(6)];
    cardan_sincos(6, angle, sine, cosine);
    const real rear_contact_yaw_cos = cosine[0];
    const real rear_contact_yaw_sin = sine[0];
    const real rear_contact_lean_cos = cosine[1];
    const real rear_contact_lean_sin = sine[1];
    const real rear_contact_spin_cos = cosine[2];
    const real rear_contact_spin_sin = sine[2];
    const real rear_hub_cos = cosine[3];
    const real rear_hub_sin = sine[3];
    const real steer_angle_cos = cosine[4];
    const real steer_angle_sin = sine[4];
    const real front_hub_angle_cos = cosine[5];
    const real front_hub_angle_sin = sine[5];

    /* rear_contact: R, p, drift, velocity, S, gamma */
    /* R = R_fixed R_joint(q) */
    /* p = p_fixed + R_fixed p_joint(q) */
    /* drift = S' u + [0; omega x v] */
    /* velocity = S u */
    /* S = d(twist of the child) / du */
    /* gamma = -d(rate)/dt at udot = 0 */
    const real rear_contact_x = q[0]; /* m */
    const real rear_contact_y = q[1]; /* m */
    const real rear_contact_u_x = u[0]; /* m/s */
    const real rear_contact_u_y = u[1]; /* m/s */
    const real rear_contact_u_yaw = u[2]; /* rad/s */
    const real rear_contact_u_lean = u[3]; /* rad/s */
    const real rear_contact_u_spin = u[4]; /* rad/s */
    const wreal rear_radius = w[0]; /* m */
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
    const real rear_contact_p_z = rear_radius * rear_contact_lean_cos;
    const real rear_contact_p_x = rear_contact_x
        + rear_radius * rear_contact_yaw_sin_times_lean_sin;
    const real rear_contact_p_y = rear_contact_y
        - rear_radius * rear_contact_yaw_cos_times_lean_sin;
    const real rear_contact_u_yaw_times_lean_sin = rear_contact_u_yaw * rear_contact_lean_sin;
    const real rear_contact_velocity_relative_vy = rear_contact_u_y * rear_contact_R_yy
        - rear_contact_u_x * rear_contact_minus_R_xy - rear_radius * rear_contact_u_lean;
    const real rear_contact_u_yaw_times_lean_cos = rear_contact_u_yaw * rear_contact_lean_cos;
    const real rear_contact_u_spin_times_u_yaw_times_lean_cos = rear_contact_u_spin *
        rear_contact_u_yaw_times_lean_cos;
    const real rear_contact_minus_drift_relative_wx_part = rear_contact_u_lean * rear_contact_u_spin
        - rear_contact_u_lean * rear_contact_u_yaw_times_lean_sin;
    const real rear_contact_minus_drift_relative_wx = rear_contact_spin_cos *
        rear_contact_u_spin_times_u_yaw_times_lean_cos
        + rear_contact_spin_sin * rear_contact_minus_drift_relative_wx_part;
    const real rear_contact_drift_relative_vx_part = 2.0 * rear_contact_u_lean *
        rear_contact_u_yaw_times_lean_cos * rear_radius;
    const real rear_contact_drift_relative_vx_part_2 = rear_radius * (rear_contact_u_lean *
        rear_contact_u_lean
        + rear_contact_u_yaw_times_lean_sin * rear_contact_u_yaw_times_lean_sin);
    const real rear_contact_u_yaw_times_yaw_sin = rear_contact_u_yaw * rear_contact_yaw_sin;
    const real rear_contact_u_yaw_times_yaw_cos = rear_contact_u_yaw * rear_contact_yaw_cos;
    const real rear_contact_u_lean_times_lean_sin = rear_contact_u_lean * rear_contact_lean_sin;
    const real rear_contact_u_lean_times_lean_cos = rear_contact_u_lean * rear_contact_lean_cos;
    const real rear_contact_minus_R_xy_rate = rear_contact_lean_cos *
        rear_contact_u_yaw_times_yaw_cos
        - rear_contact_yaw_sin * rear_contact_u_lean_times_lean_sin;
    const real rear_contact_minus_R_xx_rate_part = rear_contact_lean_sin *
        rear_contact_u_yaw_times_yaw_cos
        + rear_contact_yaw_sin * rear_contact_u_lean_times_lean_cos;
    const real rear_contact_minus_R_yy_rate = rear_contact_lean_cos *
        rear_contact_u_yaw_times_yaw_sin
        + rear_contact_yaw_cos * rear_contact_u_lean_times_lean_sin;
    const real rear_contact_R_yx_rate_part = rear_contact_yaw_cos *
        rear_contact_u_lean_times_lean_cos
        - rear_contact_lean_sin * rear_contact_u_yaw_times_yaw_sin;
    const real rear_contact_u_spin_times_spin_sin = rear_contact_u_spin * rear_contact_spin_sin;
    const real rear_contact_u_spin_times_spin_cos = rear_contact_u_spin * rear_contact_spin_cos;
    const real rear_contact_minus_R_xx_rate = rear_contact_spin_cos *
        rear_contact_u_yaw_times_yaw_sin
        + rear_contact_yaw_cos * rear_contact_u_spin_times_spin_sin
        + (rear_contact_spin_sin * rear_contact_minus_R_xx_rate_part
        + rear_contact_yaw_sin_times_lean_sin * rear_contact_u_spin_times_spin_cos);
    const real rear_contact_R_xz_rate = rear_contact_yaw_cos * rear_contact_u_spin_times_spin_cos
        - rear_contact_spin_sin * rear_contact_u_yaw_times_yaw_sin
        + (rear_contact_spin_cos * rear_contact_minus_R_xx_rate_part
        - rear_contact_yaw_sin_times_lean_sin * rear_contact_u_spin_times_spin_sin);
    const real rear_contact_R_yx_rate = rear_contact_spin_cos * rear_contact_u_yaw_times_yaw_cos
        - rear_contact_yaw_sin * rear_contact_u_spin_times_spin_sin
        + (rear_contact_spin_sin * rear_contact_R_yx_rate_part
        + rear_contact_yaw_cos_times_lean_sin * rear_contact_u_spin_times_spin_cos);
    const real rear_contact_R_yz_rate = rear_contact_spin_sin * rear_contact_u_yaw_times_yaw_cos
        + rear_contact_yaw_sin * rear_contact_u_spin_times_spin_cos
        - (rear_contact_spin_cos * rear_contact_R_yx_rate_part
        - rear_contact_yaw_cos_times_lean_sin * rear_contact_u_spin_times_spin_sin);
    const real rear_contact_minus_R_zx_rate = rear_contact_lean_cos *
        rear_contact_u_spin_times_spin_cos
        - rear_contact_spin_sin * rear_contact_u_lean_times_lean_sin;
    const real rear_contact_minus_R_zz_rate = rear_contact_spin_cos *
        rear_contact_u_lean_times_lean_sin
        + rear_contact_lean_cos * rear_contact_u_spin_times_spin_sin;
    const real rear_contact_minus_p_z_rate = rear_radius * rear_contact_u_lean_times_lean_sin;
    const real rear_contact_p_x_rate = rear_contact_u_x
        + rear_radius * rear_contact_minus_R_xx_rate_part;
    const real rear_contact_p_y_rate = rear_contact_u_y - rear_radius * rear_contact_R_yx_rate_part;
    const real rear_radius_times_rear_contact_u_lean_times_lean_cos = rear_radius *
        rear_contact_u_lean_times_lean_cos;
    const real rear_wheel_minus_omega_x_rate = rear_contact_u_yaw * rear_contact_minus_R_zx_rate
        + rear_contact_u_lean * rear_contact_u_spin_times_spin_sin;
    const real rear_wheel_omega_y_rate = rear_contact_u_yaw * rear_contact_u_lean_times_lean_cos;
    const real rear_wheel_omega_z_rate = rear_contact_u_lean * rear_contact_u_spin_times_spin_cos
        - rear_contact_u_yaw * rear_contact_minus_R_zz_rate;
    const real rear_contact_minus_velocity_relative_vy_rate = rear_contact_u_x *
        rear_contact_minus_R_xy_rate + rear_contact_u_y * rear_contact_minus_R_yy_rate;
    const real rear_contact_gamma_lateral = rear_contact_u_y * rear_contact_u_yaw_times_yaw_sin
        + rear_contact_u_x * rear_contact_u_yaw_times_yaw_cos;
    const real rear_contact_gamma_longitudinal = rear_contact_u_x * rear_contact_u_yaw_times_yaw_sin
        - rear_contact_u_y * rear_contact_u_yaw_times_yaw_cos;

    /* shared by several: S */
    /* S = d(twist of the child) / du */
    const real rear_radius_times_rear_contact_lean_sin = rear_radius * rear_contact_lean_sin;

    /* rear_contact: S, velocity */
    /* S = d(twist of the child) / du */
    /* velocity = S u */
    const real rear_contact_velocity_relative_vx_part = rear_contact_spin_cos *
        rear_radius_times_rear_contact_lean_sin;
    const real rear_contact_velocity_relative_vz_part = rear_contact_spin_sin *
        rear_radius_times_rear_contact_lean_sin;
    const real rear_contact_velocity_relative_vx = rear_contact_u_x * rear_contact_R_xx
        + rear_contact_u_y * rear_contact_R_yx
        + rear_contact_u_yaw * rear_contact_velocity_relative_vx_part;
    const real rear_contact_velocity_relative_vz = rear_contact_u_x * rear_contact_R_xz
        + rear_contact_u_y * rear_contact_R_yz
        + rear_contact_u_yaw * rear_contact_velocity_relative_vz_part;
    const real rear_contact_velocity_relative_vx_rate_part = rear_contact_u_yaw *
        (rear_contact_spin_cos * rear_radius_times_rear_contact_u_lean_times_lean_cos
        - rear_radius_times_rear_contact_lean_sin * rear_contact_u_spin_times_spin_sin);
    const real rear_contact_velocity_relative_vx_rate = rear_contact_u_y * rear_contact_R_yx_rate
        - rear_contact_u_x * rear_contact_minus_R_xx_rate
        + rear_contact_velocity_relative_vx_rate_part;
    const real rear_contact_velocity_relative_vz_rate_part = rear_contact_u_yaw *
        (rear_radius_times_rear_contact_lean_sin * rear_contact_u_spin_times_spin_cos
        + rear_contact_spin_sin * rear_radius_times_rear_contact_u_lean_times_lean_cos);
    const real rear_contact_velocity_relative_vz_rate = rear_contact_u_x * rear_contact_R_xz_rate
        + rear_contact_u_y * rear_contact_R_yz_rate + rear_contact_velocity_relative_vz_rate_part;

    /* front_contact: pose, twist */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    const real rear_hub_u = u[5]; /* rad/s */
    const real steer_u = u[6]; /* rad/s */
    const wreal steer_place_x = w[4];
    const wreal steer_minus_R_xz = w[5];
    const wreal steer_R_zz = w[6];
    const real front_contact_frame_R_xx = rear_contact_R_xx * rear_hub_cos
        - rear_contact_R_xz * rear_hub_sin;
    const real front_contact_frame_R_xz = rear_contact_R_xx * rear_hub_sin
        + rear_contact_R_xz * rear_hub_cos;
    const real front_contact_frame_R_yx = rear_contact_R_yx * rear_hub_cos
        - rear_contact_R_yz * rear_hub_sin;
    const real front_contact_frame_R_yz = rear_contact_R_yx * rear_hub_sin
        + rear_contact_R_yz * rear_hub_cos;
    const real front_contact_minus_frame_R_zx = rear_contact_minus_R_zx * rear_hub_cos
        + rear_contact_R_zz * rear_hub_sin;
    const real front_contact_frame_R_zz = rear_contact_R_zz * rear_hub_cos
        - rear_contact_minus_R_zx * rear_hub_sin;
    const real front_contact_fork_R_xz = steer_R_zz * front_contact_frame_R_xz
        - steer_minus_R_xz * front_contact_frame_R_xx;
    const real front_contact_fork_R_yz = steer_R_zz * front_contact_frame_R_yz
        - steer_minus_R_xz * front_contact_frame_R_yx;
    const real front_contact_fork_R_zz = steer_minus_R_xz * front_contact_minus_frame_R_zx
        + steer_R_zz * front_contact_frame_R_zz;
    const real front_contact_fork_p_x = steer_place_x * front_contact_frame_R_xx
        - rear_radius * front_contact_frame_R_xz + rear_contact_p_x;
    const real front_contact_fork_p_y = steer_place_x * front_contact_frame_R_yx
        - rear_radius * front_contact_frame_R_yz + rear_contact_p_y;
    const real front_contact_fork_p_z = rear_contact_p_z
        - (steer_place_x * front_contact_minus_frame_R_zx + rear_radius * front_contact_frame_R_zz);
    const real front_contact_base_twist_rear_contact_x_vx = rear_contact_R_xx * rear_contact_R_xx
        + rear_contact_minus_R_xy * rear_contact_minus_R_xy + rear_contact_R_xz * rear_contact_R_xz;
    const real front_contact_base_twist_rear_contact_x_vy = rear_contact_R_xx * rear_contact_R_yx
        - rear_contact_minus_R_xy * rear_contact_R_yy + rear_contact_R_xz * rear_contact_R_yz;
    const real front_contact_base_twist_rear_contact_x_vz = rear_contact_R_xz * rear_contact_R_zz
        - (rear_contact_R_xx * rear_contact_minus_R_zx
        + rear_contact_lean_sin * rear_contact_minus_R_xy);
    const real front_contact_base_twist_rear_contact_y_vy = rear_contact_R_yx * rear_contact_R_yx
        + rear_contact_R_yy * rear_contact_R_yy + rear_contact_R_yz * rear_contact_R_yz;
    const real front_contact_base_twist_rear_contact_y_vz = rear_contact_lean_sin *
        rear_contact_R_yy - rear_contact_R_yx * rear_contact_minus_R_zx
        + rear_contact_R_yz * rear_contact_R_zz;
    const real front_contact_base_twist_rear_contact_yaw_wz = rear_contact_minus_R_zx *
        rear_contact_minus_R_zx + rear_contact_lean_sin * rear_contact_lean_sin
        + rear_contact_R_zz * rear_contact_R_zz;
    const real front_contact_base_twist_rear_contact_lean_wx = rear_contact_spin_cos *
        rear_contact_R_xx + rear_contact_spin_sin * rear_contact_R_xz;
    const real front_contact_base_twist_rear_contact_lean_wy = rear_contact_spin_cos *
        rear_contact_R_yx + rear_contact_spin_sin * rear_contact_R_yz;
    const real front_contact_base_twist_rear_contact_lean_wz = rear_contact_spin_sin *
        rear_contact_R_zz - rear_contact_spin_cos * rear_contact_minus_R_zx;
    const real front_contact_base_twist_by_rear_contact_vx_part = rear_contact_R_xx *
        rear_contact_velocity_relative_vx
        - rear_contact_minus_R_xy * rear_contact_velocity_relative_vy
        + rear_contact_R_xz * rear_contact_velocity_relative_vz;
    const real front_contact_base_twist_by_rear_contact_vy_part = rear_contact_R_yx *
        rear_contact_velocity_relative_vx + rear_contact_R_yy * rear_contact_velocity_relative_vy
        + rear_contact_R_yz * rear_contact_velocity_relative_vz;
    const real front_contact_base_twist_by_rear_contact_vz_part = rear_contact_lean_sin *
        rear_contact_velocity_relative_vy
        - rear_contact_minus_R_zx * rear_contact_velocity_relative_vx
        + rear_contact_R_zz * rear_contact_velocity_relative_vz;
    const real front_contact_minus_base_twist_by_rear_hub_wx = rear_hub_u * rear_contact_minus_R_xy;
    const real front_contact_base_twist_by_rear_hub_wy = rear_hub_u * rear_contact_R_yy;
    const real front_contact_base_twist_by_rear_hub_wz = rear_hub_u * rear_contact_lean_sin;
    const real front_contact_base_twist_by_steer_wx = steer_u * front_contact_fork_R_xz;
    const real front_contact_base_twist_by_steer_wy = steer_u * front_contact_fork_R_yz;
    const real front_contact_base_twist_by_steer_wz = steer_u * front_contact_fork_R_zz;
    const real front_contact_base_twist_by_rear_contact_vx_rate_part =
        rear_contact_velocity_relative_vy * rear_contact_minus_R_xy_rate
        - rear_contact_minus_R_xy * rear_contact_minus_velocity_relative_vy_rate;
    const real front_contact_base_twist_by_rear_contact_vx_rate_part_2 = rear_contact_R_xx *
        rear_contact_velocity_relative_vx_rate
        - rear_contact_velocity_relative_vx * rear_contact_minus_R_xx_rate
        - front_contact_base_twist_by_rear_contact_vx_rate_part;
    const real front_contact_base_twist_by_rear_contact_vy_rate_part =
        rear_contact_velocity_relative_vy * rear_contact_minus_R_yy_rate
        + rear_contact_R_yy * rear_contact_minus_velocity_relative_vy_rate;
    const real front_contact_base_twist_by_rear_contact_vy_rate_part_2 =
        rear_contact_velocity_relative_vx * rear_contact_R_yx_rate
        + rear_contact_R_yx * rear_contact_velocity_relative_vx_rate
        - front_contact_base_twist_by_rear_contact_vy_rate_part;
    const real front_contact_base_twist_by_rear_contact_vz_rate_part =
        rear_contact_velocity_relative_vy * rear_contact_u_lean_times_lean_cos
        - rear_contact_lean_sin * rear_contact_minus_velocity_relative_vy_rate;
    const real front_contact_base_twist_by_rear_contact_vz_rate_part_2 =
        front_contact_base_twist_by_rear_contact_vz_rate_part
        - (rear_contact_velocity_relative_vx * rear_contact_minus_R_zx_rate
        + rear_contact_minus_R_zx * rear_contact_velocity_relative_vx_rate);
    const real front_contact_minus_base_twist_by_rear_hub_wx_rate = rear_hub_u *
        rear_contact_minus_R_xy_rate;
    const real front_contact_minus_base_twist_by_rear_hub_wy_rate = rear_hub_u *
        rear_contact_minus_R_yy_rate;
    const real front_contact_base_twist_by_rear_hub_wz_rate = rear_hub_u *
        rear_contact_u_lean_times_lean_cos;

    /* steer: R */
    /* R = R_fixed R_joint(q) */
    const real steer_minus_R_xx = steer_R_zz * steer_angle_sin;
    const real steer_minus_R_xy = steer_R_zz * steer_angle_cos;
    const real steer_minus_R_zx = steer_minus_R_xz * steer_angle_sin;
    const real steer_minus_R_zy = steer_minus_R_xz * steer_angle_cos;
    const real steer_u_times_angle_sin = steer_u * steer_angle_sin;
    const real steer_u_times_angle_cos = steer_u * steer_angle_cos;
    const real steer_minus_R_xx_rate = steer_R_zz * steer_u_times_angle_cos;
    const real steer_R_xy_rate = steer_R_zz * steer_u_times_angle_sin;
    const real steer_minus_R_zx_rate = steer_minus_R_xz * steer_u_times_angle_cos;
    const real steer_R_zy_rate = steer_minus_R_xz * steer_u_times_angle_sin;

    /* front_contact: pose, twist, rate */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* rate = G u + g_t */
    const wreal front_radius = w[1]; /* m */
    const wreal front_hub_R_yy = w[7];
    const wreal front_hub_p_x = w[9];
    const wreal front_hub_p_z = w[10];
    const real front_contact_minus_fork_R_xx = front_contact_frame_R_xx * steer_minus_R_xx
        + rear_contact_minus_R_xy * steer_angle_cos + front_contact_frame_R_xz * steer_minus_R_zx;
    const real front_contact_fork_R_yx = rear_contact_R_yy * steer_angle_cos
        - front_contact_frame_R_yx * steer_minus_R_xx - front_contact_frame_R_yz * steer_minus_R_zx;
    const real front_contact_fork_R_zx = front_contact_minus_frame_R_zx * steer_minus_R_xx
        + rear_contact_lean_sin * steer_angle_cos - front_contact_frame_R_zz * steer_minus_R_zx;
    const real front_contact_front_wheel_R_xy = front_hub_R_yy * (rear_contact_minus_R_xy *
        steer_angle_sin - front_contact_frame_R_xx * steer_minus_R_xy
        - front_contact_frame_R_xz * steer_minus_R_zy);
    const real front_contact_minus_front_wheel_R_yy = front_hub_R_yy * (front_contact_frame_R_yx *
        steer_minus_R_xy + rear_contact_R_yy * steer_angle_sin
        + front_contact_frame_R_yz * steer_minus_R_zy);
    const real front_contact_front_wheel_R_zy = front_hub_R_yy * (front_contact_minus_frame_R_zx *
        steer_minus_R_xy - rear_contact_lean_sin * steer_angle_sin
        - front_contact_frame_R_zz * steer_minus_R_zy);
    const real front_contact_front_wheel_p_x = front_hub_p_z * front_contact_fork_R_xz
        - front_hub_p_x * front_contact_minus_fork_R_xx + front_contact_fork_p_x;
    const real front_contact_front_wheel_p_y = front_hub_p_x * front_contact_fork_R_yx
        + front_hub_p_z * front_contact_fork_R_yz + front_contact_fork_p_y;
    const real front_contact_front_wheel_p_z = front_hub_p_x * front_contact_fork_R_zx
        + front_hub_p_z * front_contact_fork_R_zz + front_contact_fork_p_z;
    const real front_contact_arm_rear_contact_x = front_contact_front_wheel_p_x - rear_contact_p_x;
    const real front_contact_arm_rear_contact_y = front_contact_front_wheel_p_y - rear_contact_p_y;
    const real front_contact_arm_rear_contact_z = front_contact_front_wheel_p_z - rear_contact_p_z;
    const real front_contact_base_twist_rear_contact_yaw_vx_part = front_contact_arm_rear_contact_z
        * front_contact_base_twist_rear_contact_y_vz
        - front_contact_arm_rear_contact_y * front_contact_base_twist_rear_contact_yaw_wz;
    const real front_contact_base_twist_rear_contact_yaw_vy_part = front_contact_arm_rear_contact_x
        * front_contact_base_twist_rear_contact_yaw_wz
        - front_contact_arm_rear_contact_z * front_contact_base_twist_rear_contact_x_vz;
    const real front_contact_base_twist_rear_contact_yaw_vz_part = front_contact_arm_rear_contact_y
        * front_contact_base_twist_rear_contact_x_vz
        - front_contact_arm_rear_contact_x * front_contact_base_twist_rear_contact_y_vz;
    const real front_contact_base_twist_rear_contact_yaw_vx = rear_contact_R_xx *
        rear_contact_velocity_relative_vx_part
        + rear_contact_R_xz * rear_contact_velocity_relative_vz_part
        + front_contact_base_twist_rear_contact_yaw_vx_part;
    const real front_contact_base_twist_rear_contact_yaw_vy = rear_contact_R_yx *
        rear_contact_velocity_relative_vx_part
        + rear_contact_R_yz * rear_contact_velocity_relative_vz_part
        + front_contact_base_twist_rear_contact_yaw_vy_part;
    const real front_contact_base_twist_rear_contact_yaw_vz = rear_contact_R_zz *
        rear_contact_velocity_relative_vz_part
        - rear_contact_minus_R_zx * rear_contact_velocity_relative_vx_part
        + front_contact_base_twist_rear_contact_yaw_vz_part;
    const real front_contact_base_twist_rear_contact_lean_vx = front_contact_arm_rear_contact_z *
        front_contact_base_twist_rear_contact_lean_wy
        - front_contact_arm_rear_contact_y * front_contact_base_twist_rear_contact_lean_wz
        + rear_radius * rear_contact_minus_R_xy;
    const real front_contact_base_twist_rear_contact_lean_vy = front_contact_arm_rear_contact_x *
        front_contact_base_twist_rear_contact_lean_wz
        - front_contact_arm_rear_contact_z * front_contact_base_twist_rear_contact_lean_wx
        - rear_radius * rear_contact_R_yy;
    const real front_contact_base_twist_rear_contact_lean_vz = front_contact_arm_rear_contact_y *
        front_contact_base_twist_rear_contact_lean_wx
        - front_contact_arm_rear_contact_x * front_contact_base_twist_rear_contact_lean_wy
        - rear_radius_times_rear_contact_lean_sin;
    const real front_contact_base_twist_rear_contact_spin_vx = rear_contact_R_yy *
        front_contact_arm_rear_contact_z - rear_contact_lean_sin * front_contact_arm_rear_contact_y;
    const real front_contact_base_twist_rear_contact_spin_vy = rear_contact_lean_sin *
        front_contact_arm_rear_contact_x
        + rear_contact_minus_R_xy * front_contact_arm_rear_contact_z;
    const real front_contact_minus_base_twist_rear_contact_spin_vz = rear_contact_minus_R_xy *
        front_contact_arm_rear_contact_y + rear_contact_R_yy * front_contact_arm_rear_contact_x;
    const real front_contact_arm_steer_x = front_contact_front_wheel_p_x - front_contact_fork_p_x;
    const real front_contact_arm_steer_y = front_contact_front_wheel_p_y - front_contact_fork_p_y;
    const real front_contact_arm_steer_z = front_contact_front_wheel_p_z - front_contact_fork_p_z;
    const real front_contact_base_twist_steer_vx = front_contact_fork_R_yz *
        front_contact_arm_steer_z - front_contact_fork_R_zz * front_contact_arm_steer_y;
    const real front_contact_base_twist_steer_vy = front_contact_fork_R_zz *
        front_contact_arm_steer_x - front_contact_fork_R_xz * front_contact_arm_steer_z;
    const real front_contact_base_twist_steer_vz = front_contact_fork_R_xz *
        front_contact_arm_steer_y - front_contact_fork_R_yz * front_contact_arm_steer_x;
    const real front_contact_twist_rear_contact_x_vy = front_contact_front_wheel_R_xy *
        front_contact_base_twist_rear_contact_x_vx
        - front_contact_minus_front_wheel_R_yy * front_contact_base_twist_rear_contact_x_vy
        + front_contact_front_wheel_R_zy * front_contact_base_twist_rear_contact_x_vz;
    const real front_contact_twist_rear_contact_y_vy = front_contact_front_wheel_R_xy *
        front_contact_base_twist_rear_contact_x_vy
        - front_contact_minus_front_wheel_R_yy * front_contact_base_twist_rear_contact_y_vy
        + front_contact_front_wheel_R_zy * front_contact_base_twist_rear_contact_y_vz;
    const real front_contact_twist_rear_contact_yaw_wy = front_contact_front_wheel_R_xy *
        front_contact_base_twist_rear_contact_x_vz
        - front_contact_minus_front_wheel_R_yy * front_contact_base_twist_rear_contact_y_vz
        + front_contact_front_wheel_R_zy * front_contact_base_twist_rear_contact_yaw_wz;
    const real front_contact_twist_rear_contact_yaw_vy = front_contact_front_wheel_R_xy *
        front_contact_base_twist_rear_contact_yaw_vx
        - front_contact_minus_front_wheel_R_yy * front_contact_base_twist_rear_contact_yaw_vy
        + front_contact_front_wheel_R_zy * front_contact_base_twist_rear_contact_yaw_vz;
    const real front_contact_twist_rear_contact_lean_wy = front_contact_front_wheel_R_xy *
        front_contact_base_twist_rear_contact_lean_wx
        - front_contact_minus_front_wheel_R_yy * front_contact_base_twist_rear_contact_lean_wy
        + front_contact_front_wheel_R_zy * front_contact_base_twist_rear_contact_lean_wz;
    const real front_contact_twist_rear_contact_lean_vy = front_contact_front_wheel_R_xy *
        front_contact_base_twist_rear_contact_lean_vx
        - front_contact_minus_front_wheel_R_yy * front_contact_base_twist_rear_contact_lean_vy
        + front_contact_front_wheel_R_zy * front_contact_base_twist_rear_contact_lean_vz;
    const real front_contact_twist_rear_contact_spin_wy = rear_contact_lean_sin *
        front_contact_front_wheel_R_zy
        - (rear_contact_minus_R_xy * front_contact_front_wheel_R_xy
        + rear_contact_R_yy * front_contact_minus_front_wheel_R_yy);
    const real front_contact_twist_rear_contact_spin_vy = front_contact_front_wheel_R_xy *
        front_contact_base_twist_rear_contact_spin_vx
        - front_contact_minus_front_wheel_R_yy * front_contact_base_twist_rear_contact_spin_vy
        - front_contact_front_wheel_R_zy * front_contact_minus_base_twist_rear_contact_spin_vz;
    const real front_contact_twist_steer_wy = front_contact_fork_R_xz *
        front_contact_front_wheel_R_xy
        - front_contact_fork_R_yz * front_contact_minus_front_wheel_R_yy
        + front_contact_fork_R_zz * front_contact_front_wheel_R_zy;
    const real front_contact_twist_steer_vy = front_contact_front_wheel_R_xy *
        front_contact_base_twist_steer_vx
        - front_contact_minus_front_wheel_R_yy * front_contact_base_twist_steer_vy
        + front_contact_front_wheel_R_zy * front_contact_base_twist_steer_vz;
    const real front_contact_twist_front_hub_wy_part = front_contact_front_wheel_R_xy *
        front_contact_front_wheel_R_xy
        + front_contact_minus_front_wheel_R_yy * front_contact_minus_front_wheel_R_yy;
    const real front_contact_front_wheel_R_zy_squared = front_contact_front_wheel_R_zy *
        front_contact_front_wheel_R_zy;
    const real front_contact_twist_front_hub_wy = front_contact_twist_front_hub_wy_part
        + front_contact_front_wheel_R_zy_squared;
    const real front_contact_slip_rear_contact_x_upright =
        cardan_sqrt(front_contact_twist_front_hub_wy_part);
    const real front_contact_minus_slip_rear_contact_x_heading_x =
        front_contact_minus_front_wheel_R_yy / front_contact_slip_rear_contact_x_upright;
    const real front_contact_minus_slip_rear_contact_x_heading_y = front_contact_front_wheel_R_xy /
        front_contact_slip_rear_contact_x_upright;
    const real front_contact_minus_slip_rear_contact_x_up_x = front_contact_front_wheel_R_xy *
        front_contact_front_wheel_R_zy / front_contact_slip_rear_contact_x_upright;
    const real front_contact_slip_rear_contact_x_up_y = front_contact_minus_front_wheel_R_yy *
        front_contact_front_wheel_R_zy / front_contact_slip_rear_contact_x_upright;
    const real front_contact_slip_rear_contact_x_up_z = (1.0
        - front_contact_front_wheel_R_zy_squared) / front_contact_slip_rear_contact_x_upright;
    const real front_contact_slip_rear_contact_x_arm_x = front_radius *
        front_contact_minus_slip_rear_contact_x_up_x;
    const real front_contact_minus_slip_rear_contact_x_arm_y = front_radius *
        front_contact_slip_rear_contact_x_up_y;
    const real front_contact_minus_slip_rear_contact_x_arm_z = front_radius *
        front_contact_slip_rear_contact_x_up_z;

    /* front_hub: R */
    /* R = R_fixed R_joint(q) */
    const real front_hub_u = u[7]; /* rad/s */
    const real front_hub_minus_R_zx = front_hub_R_yy * front_hub_angle_cos;
    const real front_hub_minus_R_zz = front_hub_R_yy * front_hub_angle_sin;
    const real front_hub_u_times_angle_sin = front_hub_u * front_hub_angle_sin;
    const real front_hub_u_times_angle_cos = front_hub_u * front_hub_angle_cos;
    const real front_hub_R_zx_rate = front_hub_R_yy * front_hub_u_times_angle_sin;
    const real front_hub_minus_R_zz_rate = front_hub_R_yy * front_hub_u_times_angle_cos;

    /* front_contact: pose, twist, G, slip rear contact, slip rear contact yaw, ... */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* G = d(rate) / du */
    const real front_contact_front_wheel_R_xx = front_contact_minus_fork_R_xx * front_hub_angle_sin
        - front_contact_fork_R_xz * front_hub_minus_R_zx;
    const real front_contact_minus_front_wheel_R_xz = front_contact_minus_fork_R_xx *
        front_hub_angle_cos + front_contact_fork_R_xz * front_hub_minus_R_zz;
    const real front_contact_minus_front_wheel_R_yx = front_contact_fork_R_yx * front_hub_angle_sin
        + front_contact_fork_R_yz * front_hub_minus_R_zx;
    const real front_contact_front_wheel_R_yz = front_contact_fork_R_yx * front_hub_angle_cos
        - front_contact_fork_R_yz * front_hub_minus_R_zz;
    const real front_contact_minus_front_wheel_R_zx = front_contact_fork_R_zx * front_hub_angle_sin
        + front_contact_fork_R_zz * front_hub_minus_R_zx;
    const real front_contact_front_wheel_R_zz = front_contact_fork_R_zx * front_hub_angle_cos
        - front_contact_fork_R_zz * front_hub_minus_R_zz;
    const real front_contact_twist_rear_contact_x_vx = front_contact_front_wheel_R_xx *
        front_contact_base_twist_rear_contact_x_vx
        - front_contact_minus_front_wheel_R_yx * front_contact_base_twist_rear_contact_x_vy
        - front_contact_minus_front_wheel_R_zx * front_contact_base_twist_rear_contact_x_vz;
    const real front_contact_twist_rear_contact_x_vz = front_contact_front_wheel_R_yz *
        front_contact_base_twist_rear_contact_x_vy
        - front_contact_minus_front_wheel_R_xz * front_contact_base_twist_rear_contact_x_vx
        + front_contact_front_wheel_R_zz * front_contact_base_twist_rear_contact_x_vz;
    const real front_contact_twist_rear_contact_y_vx = front_contact_front_wheel_R_xx *
        front_contact_base_twist_rear_contact_x_vy
        - front_contact_minus_front_wheel_R_yx * front_contact_base_twist_rear_contact_y_vy
        - front_contact_minus_front_wheel_R_zx * front_contact_base_twist_rear_contact_y_vz;
    const real front_contact_twist_rear_contact_y_vz = front_contact_front_wheel_R_yz *
        front_contact_base_twist_rear_contact_y_vy
        - front_contact_minus_front_wheel_R_xz * front_contact_base_twist_rear_contact_x_vy
        + front_contact_front_wheel_R_zz * front_contact_base_twist_rear_contact_y_vz;
    const real front_contact_twist_rear_contact_yaw_wx = front_contact_front_wheel_R_xx *
        front_contact_base_twist_rear_contact_x_vz
        - front_contact_minus_front_wheel_R_yx * front_contact_base_twist_rear_contact_y_vz
        - front_contact_minus_front_wheel_R_zx * front_contact_base_twist_rear_contact_yaw_wz;
    const real front_contact_twist_rear_contact_yaw_wz = front_contact_front_wheel_R_yz *
        front_contact_base_twist_rear_contact_y_vz
        - front_contact_minus_front_wheel_R_xz * front_contact_base_twist_rear_contact_x_vz
        + front_contact_front_wheel_R_zz * front_contact_base_twist_rear_contact_yaw_wz;
    const real front_contact_twist_rear_contact_yaw_vx = front_contact_front_wheel_R_xx *
        front_contact_base_twist_rear_contact_yaw_vx
        - front_contact_minus_front_wheel_R_yx * front_contact_base_twist_rear_contact_yaw_vy
        - front_contact_minus_front_wheel_R_zx * front_contact_base_twist_rear_contact_yaw_vz;
    const real front_contact_twist_rear_contact_yaw_vz = front_contact_front_wheel_R_yz *
        front_contact_base_twist_rear_contact_yaw_vy
        - front_contact_minus_front_wheel_R_xz * front_contact_base_twist_rear_contact_yaw_vx
        + front_contact_front_wheel_R_zz * front_contact_base_twist_rear_contact_yaw_vz;
    const real front_contact_twist_rear_contact_lean_wx = front_contact_front_wheel_R_xx *
        front_contact_base_twist_rear_contact_lean_wx
        - front_contact_minus_front_wheel_R_yx * front_contact_base_twist_rear_contact_lean_wy
        - front_contact_minus_front_wheel_R_zx * front_contact_base_twist_rear_contact_lean_wz;
    const real front_contact_twist_rear_contact_lean_wz = front_contact_front_wheel_R_yz *
        front_contact_base_twist_rear_contact_lean_wy
        - front_contact_minus_front_wheel_R_xz * front_contact_base_twist_rear_contact_lean_wx
        + front_contact_front_wheel_R_zz * front_contact_base_twist_rear_contact_lean_wz;
    const real front_contact_twist_rear_contact_lean_vx = front_contact_front_wheel_R_xx *
        front_contact_base_twist_rear_contact_lean_vx
        - front_contact_minus_front_wheel_R_yx * front_contact_base_twist_rear_contact_lean_vy
        - front_contact_minus_front_wheel_R_zx * front_contact_base_twist_rear_contact_lean_vz;
    const real front_contact_twist_rear_contact_lean_vz = front_contact_front_wheel_R_yz *
        front_contact_base_twist_rear_contact_lean_vy
        - front_contact_minus_front_wheel_R_xz * front_contact_base_twist_rear_contact_lean_vx
        + front_contact_front_wheel_R_zz * front_contact_base_twist_rear_contact_lean_vz;
    const real front_contact_minus_twist_rear_contact_spin_wx = rear_contact_minus_R_xy *
        front_contact_front_wheel_R_xx + rear_contact_R_yy * front_contact_minus_front_wheel_R_yx
        + rear_contact_lean_sin * front_contact_minus_front_wheel_R_zx;
    const real front_contact_twist_rear_contact_spin_wz = rear_contact_minus_R_xy *
        front_contact_minus_front_wheel_R_xz + rear_contact_R_yy * front_contact_front_wheel_R_yz
        + rear_contact_lean_sin * front_contact_front_wheel_R_zz;
    const real front_contact_twist_rear_contact_spin_vx = front_contact_front_wheel_R_xx *
        front_contact_base_twist_rear_contact_spin_vx
        - front_contact_minus_front_wheel_R_yx * front_contact_base_twist_rear_contact_spin_vy
        + front_contact_minus_front_wheel_R_zx *
        front_contact_minus_base_twist_rear_contact_spin_vz;
    const real front_contact_twist_rear_contact_spin_vz = front_contact_front_wheel_R_yz *
        front_contact_base_twist_rear_contact_spin_vy
        - front_contact_minus_front_wheel_R_xz * front_contact_base_twist_rear_contact_spin_vx
        - front_contact_front_wheel_R_zz * front_contact_minus_base_twist_rear_contact_spin_vz;
    const real front_contact_twist_steer_wx = front_contact_fork_R_xz *
        front_contact_front_wheel_R_xx
        - front_contact_fork_R_yz * front_contact_minus_front_wheel_R_yx
        - front_contact_fork_R_zz * front_contact_minus_front_wheel_R_zx;
    const real front_contact_twist_steer_wz = front_contact_fork_R_yz *
        front_contact_front_wheel_R_yz
        - front_contact_fork_R_xz * front_contact_minus_front_wheel_R_xz
        + front_contact_fork_R_zz * front_contact_front_wheel_R_zz;
    const real front_contact_twist_steer_vx = front_contact_front_wheel_R_xx *
        front_contact_base_twist_steer_vx
        - front_contact_minus_front_wheel_R_yx * front_contact_base_twist_steer_vy
        - front_contact_minus_front_wheel_R_zx * front_contact_base_twist_steer_vz;
    const real front_contact_twist_steer_vz = front_contact_front_wheel_R_yz *
        front_contact_base_twist_steer_vy
        - front_contact_minus_front_wheel_R_xz * front_contact_base_twist_steer_vx
        + front_contact_front_wheel_R_zz * front_contact_base_twist_steer_vz;
    const real front_contact_front_wheel_R_xx_times_front_wheel_R_xy =
        front_contact_front_wheel_R_xx * front_contact_front_wheel_R_xy;
    const real front_contact_twist_front_hub_wx_part = front_contact_minus_front_wheel_R_yx *
        front_contact_minus_front_wheel_R_yy;
    const real front_contact_twist_front_hub_wx =
        front_contact_front_wheel_R_xx_times_front_wheel_R_xy
        + front_contact_twist_front_hub_wx_part
        - front_contact_minus_front_wheel_R_zx * front_contact_front_wheel_R_zy;
    const real front_contact_front_wheel_R_xy_times_minus_front_wheel_R_xz =
        front_contact_front_wheel_R_xy * front_contact_minus_front_wheel_R_xz;
    const real front_contact_minus_front_wheel_R_yy_times_front_wheel_R_yz =
        front_contact_minus_front_wheel_R_yy * front_contact_front_wheel_R_yz;
    const real front_contact_twist_front_hub_wz = front_contact_front_wheel_R_zy *
        front_contact_front_wheel_R_zz
        - (front_contact_front_wheel_R_xy_times_minus_front_wheel_R_xz
        + front_contact_minus_front_wheel_R_yy_times_front_wheel_R_yz);
    const real front_contact_G_pz_rear_contact_x = front_contact_front_wheel_R_zy *
        front_contact_twist_rear_contact_x_vy
        - front_contact_minus_front_wheel_R_zx * front_contact_twist_rear_contact_x_vx
        + front_contact_front_wheel_R_zz * front_contact_twist_rear_contact_x_vz;
    const real front_contact_G_pz_rear_contact_y = front_contact_front_wheel_R_zy *
        front_contact_twist_rear_contact_y_vy
        - front_contact_minus_front_wheel_R_zx * front_contact_twist_rear_contact_y_vx
        + front_contact_front_wheel_R_zz * front_contact_twist_rear_contact_y_vz;
    const real front_contact_slip_rear_contact_x_sliding_x = front_contact_front_wheel_R_xx *
        front_contact_twist_rear_contact_x_vx
        + front_contact_front_wheel_R_xy * front_contact_twist_rear_contact_x_vy
        - front_contact_minus_front_wheel_R_xz * front_contact_twist_rear_contact_x_vz;
    const real front_contact_slip_rear_contact_x_sliding_y = front_contact_front_wheel_R_yz *
        front_contact_twist_rear_contact_x_vz
        - (front_contact_minus_front_wheel_R_yx * front_contact_twist_rear_contact_x_vx
        + front_contact_minus_front_wheel_R_yy * front_contact_twist_rear_contact_x_vy);
    const real front_contact_minus_G_longitudinal_rear_contact_x =
        front_contact_minus_slip_rear_contact_x_heading_x *
        front_contact_slip_rear_contact_x_sliding_x
        + front_contact_minus_slip_rear_contact_x_heading_y *
        front_contact_slip_rear_contact_x_sliding_y;
    const real front_contact_G_lateral_rear_contact_x =
        front_contact_minus_slip_rear_contact_x_heading_y *
        front_contact_slip_rear_contact_x_sliding_x
        - front_contact_minus_slip_rear_contact_x_heading_x *
        front_contact_slip_rear_contact_x_sliding_y;
    const real front_contact_slip_rear_contact_y_sliding_x = front_contact_front_wheel_R_xx *
        front_contact_twist_rear_contact_y_vx
        + front_contact_front_wheel_R_xy * front_contact_twist_rear_contact_y_vy
        - front_contact_minus_front_wheel_R_xz * front_contact_twist_rear_contact_y_vz;
    const real front_contact_slip_rear_contact_y_sliding_y = front_contact_front_wheel_R_yz *
        front_contact_twist_rear_contact_y_vz
        - (front_contact_minus_front_wheel_R_yx * front_contact_twist_rear_contact_y_vx
        + front_contact_minus_front_wheel_R_yy * front_contact_twist_rear_contact_y_vy);
    const real front_contact_minus_G_longitudinal_rear_contact_y =
        front_contact_minus_slip_rear_contact_x_heading_x *
        front_contact_slip_rear_contact_y_sliding_x
        + front_contact_minus_slip_rear_contact_x_heading_y *
        front_contact_slip_rear_contact_y_sliding_y;
    const real front_contact_G_lateral_rear_contact_y =
        front_contact_minus_slip_rear_contact_x_heading_y *
        front_contact_slip_rear_contact_y_sliding_x
        - front_contact_minus_slip_rear_contact_x_heading_x *
        front_contact_slip_rear_contact_y_sliding_y;
    const real front_contact_slip_rear_contact_yaw_turning_x = front_contact_front_wheel_R_xx *
        front_contact_twist_rear_contact_yaw_wx
        + front_contact_front_wheel_R_xy * front_contact_twist_rear_contact_yaw_wy
        - front_contact_minus_front_wheel_R_xz * front_contact_twist_rear_contact_yaw_wz;
    const real front_contact_slip_rear_contact_yaw_turning_y = front_contact_front_wheel_R_yz *
        front_contact_twist_rear_contact_yaw_wz
        - (front_contact_minus_front_wheel_R_yx * front_contact_twist_rear_contact_yaw_wx
        + front_contact_minus_front_wheel_R_yy * front_contact_twist_rear_contact_yaw_wy);
    const real front_contact_slip_rear_contact_yaw_turning_z = front_contact_front_wheel_R_zy *
        front_contact_twist_rear_contact_yaw_wy
        - front_contact_minus_front_wheel_R_zx * front_contact_twist_rear_contact_yaw_wx
        + front_contact_front_wheel_R_zz * front_contact_twist_rear_contact_yaw_wz;
    const real front_contact_slip_rear_contact_yaw_sliding_x = front_contact_front_wheel_R_xx *
        front_contact_twist_rear_contact_yaw_vx
        + front_contact_front_wheel_R_xy * front_contact_twist_rear_contact_yaw_vy
        - front_contact_minus_front_wheel_R_xz * front_contact_twist_rear_contact_yaw_vz;
    const real front_contact_slip_rear_contact_yaw_sliding_y = front_contact_front_wheel_R_yz *
        front_contact_twist_rear_contact_yaw_vz
        - (front_contact_minus_front_wheel_R_yx * front_contact_twist_rear_contact_yaw_vx
        + front_contact_minus_front_wheel_R_yy * front_contact_twist_rear_contact_yaw_vy);
    const real front_contact_slip_rear_contact_yaw_velocity_x =
        front_contact_minus_slip_rear_contact_x_arm_y *
        front_contact_slip_rear_contact_yaw_turning_z
        - front_contact_minus_slip_rear_contact_x_arm_z *
        front_contact_slip_rear_contact_yaw_turning_y
        + front_contact_slip_rear_contact_yaw_sliding_x;
    const real front_contact_slip_rear_contact_yaw_velocity_y =
        front_contact_slip_rear_contact_x_arm_x * front_contact_slip_rear_contact_yaw_turning_z
        + front_contact_minus_slip_rear_contact_x_arm_z *
        front_contact_slip_rear_contact_yaw_turning_x
        + front_contact_slip_rear_contact_yaw_sliding_y;
    const real front_contact_minus_G_longitudinal_rear_contact_yaw =
        front_contact_minus_slip_rear_contact_x_heading_x *
        front_contact_slip_rear_contact_yaw_velocity_x
        + front_contact_minus_slip_rear_contact_x_heading_y *
        front_contact_slip_rear_contact_yaw_velocity_y;
    const real front_contact_G_lateral_rear_contact_yaw =
        front_contact_minus_slip_rear_contact_x_heading_y *
        front_contact_slip_rear_contact_yaw_velocity_x
        - front_contact_minus_slip_rear_contact_x_heading_x *
        front_contact_slip_rear_contact_yaw_velocity_y;
    const real front_contact_slip_rear_contact_lean_turning_x = front_contact_front_wheel_R_xx *
        front_contact_twist_rear_contact_lean_wx
        + front_contact_front_wheel_R_xy * front_contact_twist_rear_contact_lean_wy
        - front_contact_minus_front_wheel_R_xz * front_contact_twist_rear_contact_lean_wz;
    const real front_contact_slip_rear_contact_lean_turning_y = front_contact_front_wheel_R_yz *
        front_contact_twist_rear_contact_lean_wz
        - (front_contact_minus_front_wheel_R_yx * front_contact_twist_rear_contact_lean_wx
        + front_contact_minus_front_wheel_R_yy * front_contact_twist_rear_contact_lean_wy);
    const real front_contact_slip_rear_contact_lean_turning_z = front_contact_front_wheel_R_zy *
        front_contact_twist_rear_contact_lean_wy
        - front_contact_minus_front_wheel_R_zx * front_contact_twist_rear_contact_lean_wx
        + front_contact_front_wheel_R_zz * front_contact_twist_rear_contact_lean_wz;
    const real front_contact_slip_rear_contact_lean_sliding_x = front_contact_front_wheel_R_xx *
        front_contact_twist_rear_contact_lean_vx
        + front_contact_front_wheel_R_xy * front_contact_twist_rear_contact_lean_vy
        - front_contact_minus_front_wheel_R_xz * front_contact_twist_rear_contact_lean_vz;
    const real front_contact_slip_rear_contact_lean_sliding_y = front_contact_front_wheel_R_yz *
        front_contact_twist_rear_contact_lean_vz
        - (front_contact_minus_front_wheel_R_yx * front_contact_twist_rear_contact_lean_vx
        + front_contact_minus_front_wheel_R_yy * front_contact_twist_rear_contact_lean_vy);
    const real front_contact_slip_rear_contact_lean_velocity_x =
        front_contact_minus_slip_rear_contact_x_arm_y *
        front_contact_slip_rear_contact_lean_turning_z
        - front_contact_minus_slip_rear_contact_x_arm_z *
        front_contact_slip_rear_contact_lean_turning_y
        + front_contact_slip_rear_contact_lean_sliding_x;
    const real front_contact_slip_rear_contact_lean_velocity_y =
        front_contact_slip_rear_contact_x_arm_x * front_contact_slip_rear_contact_lean_turning_z
        + front_contact_minus_slip_rear_contact_x_arm_z *
        front_contact_slip_rear_contact_lean_turning_x
        + front_contact_slip_rear_contact_lean_sliding_y;
    const real front_contact_minus_G_longitudinal_rear_contact_lean =
        front_contact_minus_slip_rear_contact_x_heading_x *
        front_contact_slip_rear_contact_lean_velocity_x
        + front_contact_minus_slip_rear_contact_x_heading_y *
        front_contact_slip_rear_contact_lean_velocity_y;
    const real front_contact_G_lateral_rear_contact_lean =
        front_contact_minus_slip_rear_contact_x_heading_y *
        front_contact_slip_rear_contact_lean_velocity_x
        - front_contact_minus_slip_rear_contact_x_heading_x *
        front_contact_slip_rear_contact_lean_velocity_y;
    const real front_contact_slip_rear_contact_spin_turning_x = front_contact_front_wheel_R_xy *
        front_contact_twist_rear_contact_spin_wy
        - front_contact_front_wheel_R_xx * front_contact_minus_twist_rear_contact_spin_wx
        - front_contact_minus_front_wheel_R_xz * front_contact_twist_rear_contact_spin_wz;
    const real front_contact_slip_rear_contact_spin_turning_y = front_contact_minus_front_wheel_R_yx
        * front_contact_minus_twist_rear_contact_spin_wx
        - front_contact_minus_front_wheel_R_yy * front_contact_twist_rear_contact_spin_wy
        + front_contact_front_wheel_R_yz * front_contact_twist_rear_contact_spin_wz;
    const real front_contact_slip_rear_contact_spin_turning_z = front_contact_minus_front_wheel_R_zx
        * front_contact_minus_twist_rear_contact_spin_wx
        + front_contact_front_wheel_R_zy * front_contact_twist_rear_contact_spin_wy
        + front_contact_front_wheel_R_zz * front_contact_twist_rear_contact_spin_wz;
    const real front_contact_slip_rear_contact_spin_sliding_x = front_contact_front_wheel_R_xx *
        front_contact_twist_rear_contact_spin_vx
        + front_contact_front_wheel_R_xy * front_contact_twist_rear_contact_spin_vy
        - front_contact_minus_front_wheel_R_xz * front_contact_twist_rear_contact_spin_vz;
    const real front_contact_slip_rear_contact_spin_sliding_y = front_contact_front_wheel_R_yz *
        front_contact_twist_rear_contact_spin_vz
        - (front_contact_minus_front_wheel_R_yx * front_contact_twist_rear_contact_spin_vx
        + front_contact_minus_front_wheel_R_yy * front_contact_twist_rear_contact_spin_vy);
    const real front_contact_slip_rear_contact_spin_velocity_x =
        front_contact_minus_slip_rear_contact_x_arm_y *
        front_contact_slip_rear_contact_spin_turning_z
        - front_contact_minus_slip_rear_contact_x_arm_z *
        front_contact_slip_rear_contact_spin_turning_y
        + front_contact_slip_rear_contact_spin_sliding_x;
    const real front_contact_slip_rear_contact_spin_velocity_y =
        front_contact_slip_rear_contact_x_arm_x * front_contact_slip_rear_contact_spin_turning_z
        + front_contact_minus_slip_rear_contact_x_arm_z *
        front_contact_slip_rear_contact_spin_turning_x
        + front_contact_slip_rear_contact_spin_sliding_y;
    const real front_contact_minus_G_longitudinal_rear_contact_spin =
        front_contact_minus_slip_rear_contact_x_heading_x *
        front_contact_slip_rear_contact_spin_velocity_x
        + front_contact_minus_slip_rear_contact_x_heading_y *
        front_contact_slip_rear_contact_spin_velocity_y;
    const real front_contact_G_lateral_rear_contact_spin =
        front_contact_minus_slip_rear_contact_x_heading_y *
        front_contact_slip_rear_contact_spin_velocity_x
        - front_contact_minus_slip_rear_contact_x_heading_x *
        front_contact_slip_rear_contact_spin_velocity_y;
    const real front_contact_slip_steer_turning_z = front_contact_front_wheel_R_zy *
        front_contact_twist_steer_wy
        - front_contact_minus_front_wheel_R_zx * front_contact_twist_steer_wx
        + front_contact_front_wheel_R_zz * front_contact_twist_steer_wz;
    const real front_contact_slip_steer_sliding_x = front_contact_front_wheel_R_xx *
        front_contact_twist_steer_vx
        + front_contact_front_wheel_R_xy * front_contact_twist_steer_vy
        - front_contact_minus_front_wheel_R_xz * front_contact_twist_steer_vz;
    const real front_contact_slip_steer_sliding_y = front_contact_front_wheel_R_yz *
        front_contact_twist_steer_vz
        - (front_contact_minus_front_wheel_R_yx * front_contact_twist_steer_vx
        + front_contact_minus_front_wheel_R_yy * front_contact_twist_steer_vy);
    const real front_contact_slip_steer_velocity_x_part =
        front_contact_minus_slip_rear_contact_x_arm_z * (front_contact_front_wheel_R_yz *
        front_contact_twist_steer_wz
        - (front_contact_minus_front_wheel_R_yx * front_contact_twist_steer_wx
        + front_contact_minus_front_wheel_R_yy * front_contact_twist_steer_wy));
    const real front_contact_slip_steer_velocity_y_part =
        front_contact_minus_slip_rear_contact_x_arm_z * (front_contact_front_wheel_R_xx *
        front_contact_twist_steer_wx
        + front_contact_front_wheel_R_xy * front_contact_twist_steer_wy
        - front_contact_minus_front_wheel_R_xz * front_contact_twist_steer_wz);
    const real front_contact_slip_steer_velocity_x = front_contact_minus_slip_rear_contact_x_arm_y *
        front_contact_slip_steer_turning_z - front_contact_slip_steer_velocity_x_part
        + front_contact_slip_steer_sliding_x;
    const real front_contact_slip_steer_velocity_y = front_contact_slip_rear_contact_x_arm_x *
        front_contact_slip_steer_turning_z + front_contact_slip_steer_velocity_y_part
        + front_contact_slip_steer_sliding_y;
    const real front_contact_minus_G_longitudinal_steer =
        front_contact_minus_slip_rear_contact_x_heading_x * front_contact_slip_steer_velocity_x
        + front_contact_minus_slip_rear_contact_x_heading_y * front_contact_slip_steer_velocity_y;
    const real front_contact_G_lateral_steer = front_contact_minus_slip_rear_contact_x_heading_y *
        front_contact_slip_steer_velocity_x
        - front_contact_minus_slip_rear_contact_x_heading_x * front_contact_slip_steer_velocity_y;
    const real front_contact_slip_front_hub_turning_x = front_contact_front_wheel_R_xx *
        front_contact_twist_front_hub_wx
        + front_contact_front_wheel_R_xy * front_contact_twist_front_hub_wy
        - front_contact_minus_front_wheel_R_xz * front_contact_twist_front_hub_wz;
    const real front_contact_slip_front_hub_turning_y = front_contact_front_wheel_R_yz *
        front_contact_twist_front_hub_wz
        - (front_contact_minus_front_wheel_R_yx * front_contact_twist_front_hub_wx
        + front_contact_minus_front_wheel_R_yy * front_contact_twist_front_hub_wy);
    const real front_contact_slip_front_hub_turning_z = front_contact_front_wheel_R_zy *
        front_contact_twist_front_hub_wy
        - front_contact_minus_front_wheel_R_zx * front_contact_twist_front_hub_wx
        + front_contact_front_wheel_R_zz * front_contact_twist_front_hub_wz;
    const real front_contact_slip_front_hub_velocity_x =
        front_contact_minus_slip_rear_contact_x_arm_y * front_contact_slip_front_hub_turning_z
        - front_contact_minus_slip_rear_contact_x_arm_z * front_contact_slip_front_hub_turning_y;
    const real front_contact_slip_front_hub_velocity_y = front_contact_slip_rear_contact_x_arm_x *
        front_contact_slip_front_hub_turning_z
        + front_contact_minus_slip_rear_contact_x_arm_z * front_contact_slip_front_hub_turning_x;
    const real front_contact_minus_G_longitudinal_front_hub =
        front_contact_minus_slip_rear_contact_x_heading_x * front_contact_slip_front_hub_velocity_x
        + front_contact_minus_slip_rear_contact_x_heading_y *
        front_contact_slip_front_hub_velocity_y;
    const real front_contact_G_lateral_front_hub = front_contact_minus_slip_rear_contact_x_heading_y
        * front_contact_slip_front_hub_velocity_x
        - front_contact_minus_slip_rear_contact_x_heading_x *
        front_contact_slip_front_hub_velocity_y;

    /* rear_wheel: omega, alpha, a, U */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    const wreal gravity_z = w[2]; /* m/s^2 */
    const real rear_wheel_omega_x = rear_contact_u_lean * rear_contact_spin_cos
        - rear_contact_u_yaw * rear_contact_minus_R_zx;
    const real rear_wheel_omega_y = rear_contact_u_spin + rear_contact_u_yaw_times_lean_sin;
    const real rear_wheel_omega_z = rear_contact_u_yaw * rear_contact_R_zz
        + rear_contact_u_lean * rear_contact_spin_sin;
    const real rear_wheel_alpha_y = rear_contact_u_lean * rear_contact_u_yaw_times_lean_cos;
    const real rear_wheel_alpha_z = rear_contact_spin_cos *
        rear_contact_minus_drift_relative_wx_part
        - rear_contact_spin_sin * rear_contact_u_spin_times_u_yaw_times_lean_cos;
    const real rear_wheel_a_x = rear_contact_spin_cos * rear_contact_drift_relative_vx_part
        + rear_contact_spin_sin * rear_contact_drift_relative_vx_part_2
        + gravity_z * rear_contact_minus_R_zx;
    const real rear_wheel_a_y = rear_contact_u_yaw_times_lean_sin *
        rear_contact_u_yaw_times_lean_cos * rear_radius - gravity_z * rear_contact_lean_sin;
    const real rear_wheel_a_z = rear_contact_spin_sin * rear_contact_drift_relative_vx_part
        - rear_contact_spin_cos * rear_contact_drift_relative_vx_part_2
        - gravity_z * rear_contact_R_zz;
    const real rear_wheel_omega_x_times_omega_y = rear_wheel_omega_x * rear_wheel_omega_y;
    const real rear_wheel_omega_x_times_omega_z = rear_wheel_omega_x * rear_wheel_omega_z;
    const real rear_wheel_omega_y_times_omega_z = rear_wheel_omega_y * rear_wheel_omega_z;
    const real rear_wheel_U_xy = rear_wheel_omega_x_times_omega_y - rear_wheel_alpha_z;
    const real rear_wheel_U_xz = rear_wheel_alpha_y + rear_wheel_omega_x_times_omega_z;
    const real rear_wheel_U_yx = rear_wheel_alpha_z + rear_wheel_omega_x_times_omega_y;
    const real rear_wheel_U_yz = rear_contact_minus_drift_relative_wx
        + rear_wheel_omega_y_times_omega_z;
    const real rear_wheel_U_zx = rear_wheel_omega_x_times_omega_z - rear_wheel_alpha_y;
    const real rear_wheel_U_zy = rear_wheel_omega_y_times_omega_z
        - rear_contact_minus_drift_relative_wx;

    /* front_contact: twist, rate */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* rate = G u + g_t */
    const real front_contact_base_twist_by_rear_contact_wx = rear_contact_R_xx * rear_wheel_omega_x
        - rear_contact_minus_R_xy * rear_wheel_omega_y + rear_contact_R_xz * rear_wheel_omega_z;
    const real front_contact_base_twist_by_rear_contact_wy = rear_contact_R_yx * rear_wheel_omega_x
        + rear_contact_R_yy * rear_wheel_omega_y + rear_contact_R_yz * rear_wheel_omega_z;
    const real front_contact_base_twist_by_rear_contact_wz = rear_contact_lean_sin *
        rear_wheel_omega_y - rear_contact_minus_R_zx * rear_wheel_omega_x
        + rear_contact_R_zz * rear_wheel_omega_z;
    const real front_contact_base_twist_by_rear_contact_vx = front_contact_arm_rear_contact_z *
        front_contact_base_twist_by_rear_contact_wy
        - front_contact_arm_rear_contact_y * front_contact_base_twist_by_rear_contact_wz
        + front_contact_base_twist_by_rear_contact_vx_part;
    const real front_contact_base_twist_by_rear_contact_vy = front_contact_arm_rear_contact_x *
        front_contact_base_twist_by_rear_contact_wz
        - front_contact_arm_rear_contact_z * front_contact_base_twist_by_rear_contact_wx
        + front_contact_base_twist_by_rear_contact_vy_part;
    const real front_contact_base_twist_by_rear_contact_vz = front_contact_arm_rear_contact_y *
        front_contact_base_twist_by_rear_contact_wx
        - front_contact_arm_rear_contact_x * front_contact_base_twist_by_rear_contact_wy
        + front_contact_base_twist_by_rear_contact_vz_part;
    const real front_contact_base_twist_vx_part = front_contact_arm_rear_contact_z *
        front_contact_base_twist_by_rear_hub_wy
        - front_contact_arm_rear_contact_y * front_contact_base_twist_by_rear_hub_wz
        + front_contact_base_twist_by_rear_contact_vx;
    const real front_contact_base_twist_vy_part = front_contact_arm_rear_contact_x *
        front_contact_base_twist_by_rear_hub_wz
        + front_contact_arm_rear_contact_z * front_contact_minus_base_twist_by_rear_hub_wx
        + front_contact_base_twist_by_rear_contact_vy;
    const real front_contact_base_twist_vz_part = front_contact_base_twist_by_rear_contact_vz
        - (front_contact_arm_rear_contact_y * front_contact_minus_base_twist_by_rear_hub_wx
        + front_contact_arm_rear_contact_x * front_contact_base_twist_by_rear_hub_wy);
    const real front_contact_base_twist_vx = front_contact_arm_steer_z *
        front_contact_base_twist_by_steer_wy
        - front_contact_arm_steer_y * front_contact_base_twist_by_steer_wz
        + front_contact_base_twist_vx_part;
    const real front_contact_base_twist_vy = front_contact_arm_steer_x *
        front_contact_base_twist_by_steer_wz
        - front_contact_arm_steer_z * front_contact_base_twist_by_steer_wx
        + front_contact_base_twist_vy_part;
    const real front_contact_base_twist_vz = front_contact_arm_steer_y *
        front_contact_base_twist_by_steer_wx
        - front_contact_arm_steer_x * front_contact_base_twist_by_steer_wy
        + front_contact_base_twist_vz_part;
    const real front_contact_base_twist_wx = front_contact_base_twist_by_rear_contact_wx
        - front_contact_minus_base_twist_by_rear_hub_wx + front_contact_base_twist_by_steer_wx
        + front_hub_u * front_contact_front_wheel_R_xy;
    const real front_contact_base_twist_wy = front_contact_base_twist_by_rear_contact_wy
        + front_contact_base_twist_by_rear_hub_wy + front_contact_base_twist_by_steer_wy
        - front_hub_u * front_contact_minus_front_wheel_R_yy;
    const real front_contact_base_twist_wz = front_contact_base_twist_by_rear_contact_wz
        + front_contact_base_twist_by_rear_hub_wz + front_contact_base_twist_by_steer_wz
        + front_hub_u * front_contact_front_wheel_R_zy;
    const real front_contact_twist_wx = front_contact_front_wheel_R_xx * front_contact_base_twist_wx
        - front_contact_minus_front_wheel_R_yx * front_contact_base_twist_wy
        - front_contact_minus_front_wheel_R_zx * front_contact_base_twist_wz;
    const real front_contact_twist_wy = front_contact_front_wheel_R_xy * front_contact_base_twist_wx
        - front_contact_minus_front_wheel_R_yy * front_contact_base_twist_wy
        + front_contact_front_wheel_R_zy * front_contact_base_twist_wz;
    const real front_contact_twist_wz = front_contact_front_wheel_R_yz * front_contact_base_twist_wy
        - front_contact_minus_front_wheel_R_xz * front_contact_base_twist_wx
        + front_contact_front_wheel_R_zz * front_contact_base_twist_wz;
    const real front_contact_twist_vx = front_contact_front_wheel_R_xx * front_contact_base_twist_vx
        - front_contact_minus_front_wheel_R_yx * front_contact_base_twist_vy
        - front_contact_minus_front_wheel_R_zx * front_contact_base_twist_vz;
    const real front_contact_twist_vy = front_contact_front_wheel_R_xy * front_contact_base_twist_vx
        - front_contact_minus_front_wheel_R_yy * front_contact_base_twist_vy
        + front_contact_front_wheel_R_zy * front_contact_base_twist_vz;
    const real front_contact_twist_vz = front_contact_front_wheel_R_yz * front_contact_base_twist_vy
        - front_contact_minus_front_wheel_R_xz * front_contact_base_twist_vx
        + front_contact_front_wheel_R_zz * front_contact_base_twist_vz;
    const real front_contact_rate_turning_x = front_contact_front_wheel_R_xx *
        front_contact_twist_wx + front_contact_front_wheel_R_xy * front_contact_twist_wy
        - front_contact_minus_front_wheel_R_xz * front_contact_twist_wz;
    const real front_contact_rate_turning_y = front_contact_front_wheel_R_yz *
        front_contact_twist_wz - (front_contact_minus_front_wheel_R_yx * front_contact_twist_wx
        + front_contact_minus_front_wheel_R_yy * front_contact_twist_wy);
    const real front_contact_rate_turning_z = front_contact_front_wheel_R_zy *
        front_contact_twist_wy - front_contact_minus_front_wheel_R_zx * front_contact_twist_wx
        + front_contact_front_wheel_R_zz * front_contact_twist_wz;
    const real front_contact_rate_sliding_x = front_contact_front_wheel_R_xx *
        front_contact_twist_vx + front_contact_front_wheel_R_xy * front_contact_twist_vy
        - front_contact_minus_front_wheel_R_xz * front_contact_twist_vz;
    const real front_contact_rate_sliding_y = front_contact_front_wheel_R_yz *
        front_contact_twist_vz - (front_contact_minus_front_wheel_R_yx * front_contact_twist_vx
        + front_contact_minus_front_wheel_R_yy * front_contact_twist_vy);
    const real front_contact_rate_velocity_x = front_contact_minus_slip_rear_contact_x_arm_y *
        front_contact_rate_turning_z
        - front_contact_minus_slip_rear_contact_x_arm_z * front_contact_rate_turning_y
        + front_contact_rate_sliding_x;
    const real front_contact_rate_velocity_y = front_contact_slip_rear_contact_x_arm_x *
        front_contact_rate_turning_z
        + front_contact_minus_slip_rear_contact_x_arm_z * front_contact_rate_turning_x
        + front_contact_rate_sliding_y;
    const real front_contact_base_twist_by_rear_contact_wx_rate_part = rear_wheel_omega_x *
        rear_contact_minus_R_xx_rate + rear_contact_R_xx * rear_wheel_minus_omega_x_rate
        + (rear_wheel_omega_y * rear_contact_minus_R_xy_rate
        + rear_contact_minus_R_xy * rear_wheel_omega_y_rate);
    const real front_contact_base_twist_by_rear_contact_wx_rate = rear_wheel_omega_z *
        rear_contact_R_xz_rate + rear_contact_R_xz * rear_wheel_omega_z_rate
        - front_contact_base_twist_by_rear_contact_wx_rate_part;
    const real front_contact_base_twist_by_rear_contact_wy_rate_part = rear_wheel_omega_x *
        rear_contact_R_yx_rate - rear_contact_R_yx * rear_wheel_minus_omega_x_rate
        + (rear_contact_R_yy * rear_wheel_omega_y_rate
        - rear_wheel_omega_y * rear_contact_minus_R_yy_rate);
    const real front_contact_base_twist_by_rear_contact_wy_rate = rear_wheel_omega_z *
        rear_contact_R_yz_rate + rear_contact_R_yz * rear_wheel_omega_z_rate
        + front_contact_base_twist_by_rear_contact_wy_rate_part;
    const real front_contact_base_twist_by_rear_contact_wz_rate_part = rear_wheel_omega_y *
        rear_contact_u_lean_times_lean_cos + rear_contact_lean_sin * rear_wheel_omega_y_rate
        - (rear_wheel_omega_x * rear_contact_minus_R_zx_rate
        - rear_contact_minus_R_zx * rear_wheel_minus_omega_x_rate);
    const real front_contact_base_twist_by_rear_contact_wz_rate = rear_contact_R_zz *
        rear_wheel_omega_z_rate - rear_wheel_omega_z * rear_contact_minus_R_zz_rate
        + front_contact_base_twist_by_rear_contact_wz_rate_part;

    /* common */
    const real front_contact_G_pz_rear_contact_yaw_part =
        front_contact_front_wheel_R_xy_times_minus_front_wheel_R_xz
        + front_contact_front_wheel_R_xy_times_minus_front_wheel_R_xz
        + (front_contact_minus_front_wheel_R_yy_times_front_wheel_R_yz
        + front_contact_minus_front_wheel_R_yy_times_front_wheel_R_yz);
    const real c0p5_per_front_contact_slip_rear_contact_x_upright = 0.5 /
        front_contact_slip_rear_contact_x_upright;
    const real front_contact_G_pz_rear_contact_yaw_part_2 =
        cardan_select(front_contact_slip_rear_contact_x_upright,
        c0p5_per_front_contact_slip_rear_contact_x_upright, 0.0);
    const real front_contact_G_pz_rear_contact_yaw_part_3 = front_contact_G_pz_rear_contact_yaw_part
        * front_contact_G_pz_rear_contact_yaw_part_2 * front_radius;
    const real front_contact_G_pz_rear_contact_yaw_part_4 =
        front_contact_front_wheel_R_xx_times_front_wheel_R_xy
        + front_contact_front_wheel_R_xx_times_front_wheel_R_xy
        + (front_contact_twist_front_hub_wx_part + front_contact_twist_front_hub_wx_part);
    const real front_contact_G_pz_rear_contact_yaw_part_5 =
        front_contact_G_pz_rear_contact_yaw_part_2 * front_contact_G_pz_rear_contact_yaw_part_4 *
        front_radius;

    /* fork: inertia, composite, momentum */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* momentum = composite inertia S */
    const wreal front_wheel_base_inertia_zz = w[12];
    const wreal fork_base_moment_x = w[13];
    const wreal fork_base_inertia_xz = w[14];
    const wreal fork_base_inertia_zz = w[15];
    const wreal fork_inertia_half_turned_yy = w[34];
    const real fork_inertia_shear = front_wheel_base_inertia_zz * front_hub_angle_sin;
    const real front_hub_angle_sin_times_fork_inertia_shear = front_hub_angle_sin *
        fork_inertia_shear;
    const real fork_composite_inertia_xx = front_wheel_base_inertia_zz
        - front_hub_angle_sin_times_fork_inertia_shear;
    const real fork_composite_inertia_xz = fork_base_inertia_xz
        - front_hub_angle_cos * fork_inertia_shear * front_hub_R_yy;
    const real fork_composite_inertia_zz = fork_base_inertia_zz
        + front_hub_R_yy * front_hub_angle_sin_times_fork_inertia_shear * front_hub_R_yy;
    const real momentum_minus_front_hub_about_frame_mx = steer_minus_R_xy *
        fork_inertia_half_turned_yy;
    const real momentum_minus_front_hub_about_frame_my = steer_angle_sin *
        fork_inertia_half_turned_yy;
    const real momentum_minus_front_hub_about_frame_mz = steer_minus_R_zy *
        fork_inertia_half_turned_yy;
    const real momentum_minus_steer_about_frame_fx = fork_base_moment_x * steer_minus_R_xy;
    const real momentum_minus_steer_about_frame_fy = fork_base_moment_x * steer_angle_sin;
    const real momentum_minus_steer_about_frame_fz = fork_base_moment_x * steer_minus_R_zy;

    /* frame: inertia, composite, momentum, omega, alpha, a, U, inertia force */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* momentum = composite inertia S */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal frame_base_moment_x = w[16];
    const wreal frame_base_moment_z = w[17];
    const wreal frame_base_inertia_yy = w[19];
    const wreal frame_base_second_moment_xx = w[30];
    const wreal frame_base_second_moment_xz = w[31];
    const wreal frame_base_second_moment_zz = w[32];
    const wreal fork_composite_inertia_yy = w[35];
    const real frame_inertia_shear = steer_angle_sin * (fork_composite_inertia_xx
        - fork_composite_inertia_yy);
    const real steer_angle_sin_times_frame_inertia_shear = steer_angle_sin * frame_inertia_shear;
    const real frame_minus_inertia_half_turned_xy_part = fork_composite_inertia_yy
        + steer_angle_sin_times_frame_inertia_shear;
    const real frame_inertia_half_turned_yy = steer_angle_cos * frame_inertia_shear;
    const real steer_angle_sin_times_fork_composite_inertia_xz = steer_angle_sin *
        fork_composite_inertia_xz;
    const real frame_minus_inertia_half_turned_xy_part_2 = steer_minus_R_xz *
        steer_angle_sin_times_fork_composite_inertia_xz;
    const real frame_minus_inertia_half_turned_xy = steer_R_zz *
        frame_minus_inertia_half_turned_xy_part + frame_minus_inertia_half_turned_xy_part_2;
    const real steer_R_zz_times_angle_sin_times_fork_composite_inertia_xz = steer_R_zz *
        steer_angle_sin_times_fork_composite_inertia_xz;
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
    const real frame_composite_inertia_yy = fork_composite_inertia_xx
        - steer_angle_sin_times_frame_inertia_shear + frame_inertia_shift + frame_base_inertia_yy;
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
    const real frame_omega_x = rear_hub_cos * rear_wheel_omega_x
        - rear_hub_sin * rear_wheel_omega_z;
    const real frame_omega_z = rear_hub_sin * rear_wheel_omega_x
        + rear_hub_cos * rear_wheel_omega_z;
    const real frame_omega_y = rear_hub_u + rear_wheel_omega_y;
    const real frame_minus_alpha_x = rear_hub_cos * rear_contact_minus_drift_relative_wx
        + rear_hub_sin * rear_wheel_alpha_z + rear_hub_u * frame_omega_z;
    const real frame_alpha_z = rear_hub_cos * rear_wheel_alpha_z
        - rear_hub_sin * rear_contact_minus_drift_relative_wx + rear_hub_u * frame_omega_x;
    const real frame_a_x = rear_hub_cos * rear_wheel_a_x - rear_hub_sin * rear_wheel_a_z;
    const real frame_a_z = rear_hub_sin * rear_wheel_a_x + rear_hub_cos * rear_wheel_a_z;
    const real frame_omega_y_squared = frame_omega_y * frame_omega_y;
    const real frame_omega_x_times_omega_z = frame_omega_x * frame_omega_z;
    const real frame_minus_U_xx = frame_omega_y_squared + frame_omega_z * frame_omega_z;
    const real frame_U_xz = rear_wheel_alpha_y + frame_omega_x_times_omega_z;
    const real frame_U_yx = frame_alpha_z + frame_omega_x * frame_omega_y;
    const real frame_U_yz = frame_minus_alpha_x + frame_omega_z * frame_omega_y;
    const real frame_U_zx = frame_omega_x_times_omega_z - rear_wheel_alpha_y;
    const real frame_minus_U_zz = frame_omega_x * frame_omega_x + frame_omega_y_squared;
    const real frame_n_y_part = frame_base_second_moment_zz * frame_U_xz
        - frame_base_second_moment_xx * frame_U_zx
        + frame_base_second_moment_xz * (frame_minus_U_zz - frame_minus_U_xx)
        + (frame_base_moment_z * frame_a_x - frame_base_moment_x * frame_a_z);

    /* shared by several: inertia, M */
    /* M = S . momentum */
    const real frame_inertia_half_turned_yz = steer_angle_cos * fork_composite_inertia_xz;
    const real steer_minus_R_xz_times_fork_composite_inertia_zz = steer_minus_R_xz *
        fork_composite_inertia_zz;
    const real steer_R_zz_times_fork_composite_inertia_zz = steer_R_zz * fork_composite_inertia_zz;
    const real rear_radius_times_momentum_minus_steer_about_frame_fy = rear_radius *
        momentum_minus_steer_about_frame_fy;

    /* frame: inertia, composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal frame_base_inertia_xz = w[18];
    const wreal frame_base_inertia_zz = w[20];
    const real frame_minus_inertia_half_turned_xz =
        steer_R_zz_times_angle_sin_times_fork_composite_inertia_xz
        + steer_minus_R_xz_times_fork_composite_inertia_zz;
    const real frame_composite_inertia_zz_part = steer_R_zz *
        (steer_R_zz_times_fork_composite_inertia_zz - frame_minus_inertia_half_turned_xy_part_2)
        - steer_minus_R_xz * (steer_R_zz_times_angle_sin_times_fork_composite_inertia_xz
        - steer_minus_R_xz * frame_minus_inertia_half_turned_xy_part);
    const real frame_composite_inertia_xx = steer_R_zz * frame_minus_inertia_half_turned_xy
        + steer_minus_R_xz * frame_minus_inertia_half_turned_xz + (frame_inertia_shift
        + 2.0 * steer_place_x_times_frame_minus_inertia_mean_moment_x);
    const real frame_minus_composite_inertia_xy = steer_R_zz * frame_inertia_half_turned_yy
        + steer_minus_R_xz * frame_inertia_half_turned_yz
        + steer_place_x * frame_composite_moment_y;
    const real frame_composite_inertia_yz = steer_R_zz * frame_inertia_half_turned_yz
        - steer_minus_R_xz * frame_inertia_half_turned_yy + rear_radius * frame_composite_moment_y;
    const real frame_composite_inertia_xz = steer_minus_R_xz * frame_minus_inertia_half_turned_xy
        - steer_R_zz * frame_minus_inertia_half_turned_xz
        - (rear_radius * frame_minus_inertia_mean_moment_x
        - steer_place_x * frame_minus_inertia_mean_moment_z) + frame_base_inertia_xz;
    const real frame_composite_inertia_zz = frame_inertia_shift
        - 2.0 * rear_radius_times_frame_minus_inertia_mean_moment_z
        + frame_composite_inertia_zz_part + frame_base_inertia_zz;

    /* rear_wheel: inertia, composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal rear_wheel_inertia_yy = w[3]; /* kg m^2 */
    const wreal rear_wheel_base_inertia_xx = w[22];
    const wreal rear_wheel_base_inertia_zz = w[23];
    const real rear_wheel_inertia_shear = rear_hub_sin * (frame_composite_inertia_zz
        - frame_composite_inertia_xx) + rear_hub_cos * (frame_composite_inertia_xz
        + frame_composite_inertia_xz);
    const real rear_hub_sin_times_rear_wheel_inertia_shear = rear_hub_sin *
        rear_wheel_inertia_shear;
    const real rear_wheel_composite_inertia_xz = rear_hub_cos * rear_wheel_inertia_shear
        - frame_composite_inertia_xz;
    const real rear_wheel_composite_inertia_xy = rear_hub_sin * frame_composite_inertia_yz
        - rear_hub_cos * frame_minus_composite_inertia_xy;
    const real rear_wheel_composite_moment_x = rear_hub_cos * frame_composite_moment_x
        + rear_hub_sin * frame_composite_moment_z;
    const real rear_wheel_composite_moment_z = rear_hub_cos * frame_composite_moment_z
        - rear_hub_sin * frame_composite_moment_x;
    const real rear_wheel_composite_inertia_xx = frame_composite_inertia_xx
        + rear_hub_sin_times_rear_wheel_inertia_shear + rear_wheel_base_inertia_xx;
    const real rear_wheel_composite_inertia_yy = rear_wheel_inertia_yy + frame_composite_inertia_yy;
    const real rear_wheel_composite_inertia_zz = frame_composite_inertia_zz
        - rear_hub_sin_times_rear_wheel_inertia_shear + rear_wheel_base_inertia_zz;

    /* shared by several: inertia, M */
    /* M = S . momentum */
    const real momentum_rear_hub_about_rear_wheel_mz = rear_hub_cos * frame_composite_inertia_yz
        + rear_hub_sin * frame_minus_composite_inertia_xy;
    const real M_rear_hub_rear_contact_yaw_part = rear_contact_minus_R_zx *
        rear_wheel_composite_inertia_xy;
    const real M_rear_hub_rear_contact_yaw_part_2 = rear_contact_velocity_relative_vx_part *
        rear_wheel_composite_moment_z;
    const real M_rear_hub_rear_contact_yaw_part_3 = rear_contact_velocity_relative_vz_part *
        rear_wheel_composite_moment_x;
    const real rear_contact_spin_cos_times_rear_wheel_composite_inertia_xy = rear_contact_spin_cos *
        rear_wheel_composite_inertia_xy;

    /* rear_wheel: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const real rear_wheel_composite_inertia_yz = momentum_rear_hub_about_rear_wheel_mz
        + momentum_rear_hub_about_rear_wheel_mz - momentum_rear_hub_about_rear_wheel_mz;

    /* M */
    /* M = S . momentum */
    const real M_front_hub_rear_contact_yaw = rear_contact_minus_R_zx *
        momentum_minus_front_hub_about_rear_wheel_mx
        - rear_contact_lean_sin * momentum_minus_front_hub_about_frame_my
        + rear_contact_R_zz * momentum_front_hub_about_rear_wheel_mz;
    const real M_front_hub_rear_contact_lean = rear_contact_spin_sin *
        momentum_front_hub_about_rear_wheel_mz
        - rear_contact_spin_cos * momentum_minus_front_hub_about_rear_wheel_mx;
    const real M_steer_rear_contact_spin = rear_radius * momentum_minus_steer_about_frame_fx
        + steer_place_x * momentum_minus_steer_about_frame_fz + frame_inertia_half_turned_yz;
    const real M_steer_rear_contact_x = rear_contact_minus_R_xy *
        momentum_minus_steer_about_frame_fy
        - rear_contact_R_xx * momentum_minus_steer_about_rear_wheel_fx
        + rear_contact_R_xz * momentum_steer_about_rear_wheel_fz;
    const real M_steer_rear_contact_y = rear_contact_R_yz * momentum_steer_about_rear_wheel_fz
        - (rear_contact_R_yx * momentum_minus_steer_about_rear_wheel_fx
        + rear_contact_R_yy * momentum_minus_steer_about_frame_fy);
    const real M_rear_hub_rear_contact_yaw = rear_contact_lean_sin * frame_composite_inertia_yy
        - M_rear_hub_rear_contact_yaw_part
        + rear_contact_R_zz * momentum_rear_hub_about_rear_wheel_mz
        + M_rear_hub_rear_contact_yaw_part_2 - M_rear_hub_rear_contact_yaw_part_3;
    const real M_rear_hub_rear_contact_lean =
        rear_contact_spin_cos_times_rear_wheel_composite_inertia_xy
        + rear_contact_spin_sin * momentum_rear_hub_about_rear_wheel_mz;

    /* fork: momentum, omega, alpha, a, U, inertia force, f */
    /* momentum = composite inertia S */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const wreal fork_base_second_moment_xx = w[28];
    const wreal fork_base_second_moment_yy = w[29];
    const real momentum_minus_steer_about_frame_mx =
        steer_minus_R_xz_times_fork_composite_inertia_zz
        + steer_minus_R_xx * fork_composite_inertia_xz
        + rear_radius_times_momentum_minus_steer_about_frame_fy;
    const real momentum_steer_about_frame_mz = steer_R_zz_times_fork_composite_inertia_zz
        - steer_minus_R_zx * fork_composite_inertia_xz
        - steer_place_x * momentum_minus_steer_about_frame_fy;
    const real fork_omega_x = steer_angle_cos * frame_omega_y - steer_minus_R_xx * frame_omega_x
        - steer_minus_R_zx * frame_omega_z;
    const real fork_minus_omega_y = steer_minus_R_xy * frame_omega_x
        + steer_angle_sin * frame_omega_y + steer_minus_R_zy * frame_omega_z;
    const real fork_omega_z = steer_R_zz * frame_omega_z - steer_minus_R_xz * frame_omega_x
        + steer_u;
    const real fork_alpha_z = steer_minus_R_xz * frame_minus_alpha_x + steer_R_zz * frame_alpha_z;
    const real fork_alpha_x = steer_minus_R_xx * frame_minus_alpha_x
        + steer_angle_cos * rear_wheel_alpha_y - steer_minus_R_zx * frame_alpha_z
        - steer_u * fork_minus_omega_y;
    const real fork_alpha_y = steer_minus_R_xy * frame_minus_alpha_x
        - steer_angle_sin * rear_wheel_alpha_y - steer_minus_R_zy * frame_alpha_z
        - steer_u * fork_omega_x;
    const real fork_minus_a_y_part = frame_a_x - (steer_place_x * frame_minus_U_xx
        + rear_radius * frame_U_xz);
    const real fork_minus_a_y_part_2 = steer_place_x * frame_U_zx
        + rear_radius * frame_minus_U_zz + frame_a_z;
    const real fork_a_z = steer_R_zz * fork_minus_a_y_part_2
        - steer_minus_R_xz * fork_minus_a_y_part;
    const real fork_minus_omega_y_squared = fork_minus_omega_y * fork_minus_omega_y;
    const real fork_omega_x_times_minus_omega_y = fork_omega_x * fork_minus_omega_y;
    const real fork_minus_omega_y_times_omega_z = fork_minus_omega_y * fork_omega_z;
    const real fork_minus_U_xx = fork_minus_omega_y_squared + fork_omega_z * fork_omega_z;
    const real fork_U_yx = fork_alpha_z - fork_omega_x_times_minus_omega_y;
    const real fork_U_zx = fork_omega_x * fork_omega_z - fork_alpha_y;
    const real fork_U_zy = fork_alpha_x - fork_minus_omega_y_times_omega_z;
    const real fork_base_moment_x_times_minus_a_y = fork_base_moment_x * (steer_minus_R_xy *
        fork_minus_a_y_part + steer_angle_sin * (steer_place_x * frame_U_yx
        - rear_radius * frame_U_yz + rear_wheel_a_y) + steer_minus_R_zy * fork_minus_a_y_part_2);
    const real fork_n_z_part = fork_base_second_moment_xx * fork_U_yx
        + fork_base_second_moment_yy * (fork_alpha_z + fork_omega_x_times_minus_omega_y)
        + fork_base_inertia_xz * (fork_alpha_x + fork_minus_omega_y_times_omega_z)
        - fork_base_moment_x_times_minus_a_y;
    const real fork_minus_f_x = fork_base_moment_x * fork_minus_U_xx;
    const real fork_f_y = fork_base_moment_x * fork_U_yx;
    const real fork_f_z = fork_base_moment_x * fork_U_zx;
    const real frame_n_y_part_2 = steer_minus_R_xx * fork_minus_f_x - steer_minus_R_xy * fork_f_y
        - steer_minus_R_xz * fork_f_z;
    const real frame_minus_n_x_part = steer_angle_cos * fork_minus_f_x + steer_angle_sin * fork_f_y;
    const real frame_n_y_part_3 = steer_minus_R_zx * fork_minus_f_x - steer_minus_R_zy * fork_f_y
        + steer_R_zz * fork_f_z;

    /* frame: momentum, f */
    /* momentum = composite inertia S */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real momentum_steer_about_rear_wheel_mx = rear_hub_sin * momentum_steer_about_frame_mz
        - rear_hub_cos * momentum_minus_steer_about_frame_mx;
    const real momentum_steer_about_rear_wheel_mz = rear_hub_sin *
        momentum_minus_steer_about_frame_mx + rear_hub_cos * momentum_steer_about_frame_mz;
    const real frame_f_x = frame_base_moment_z * frame_U_xz
        - frame_base_moment_x * frame_minus_U_xx + frame_n_y_part_2;
    const real frame_f_y = frame_base_moment_x * frame_U_yx + frame_base_moment_z * frame_U_yz
        - frame_minus_n_x_part;
    const real frame_f_z = frame_base_moment_x * frame_U_zx
        - frame_base_moment_z * frame_minus_U_zz + frame_n_y_part_3;

    /* steer: M */
    /* M = S . momentum */
    const real M_steer_rear_contact_yaw_part = rear_contact_lean_sin * M_steer_rear_contact_spin
        - rear_contact_minus_R_zx * momentum_steer_about_rear_wheel_mx
        + rear_contact_R_zz * momentum_steer_about_rear_wheel_mz
        - rear_contact_velocity_relative_vx_part * momentum_minus_steer_about_rear_wheel_fx;

    /* M */
    /* M = S . momentum */
    const real M_steer_rear_contact_yaw = M_steer_rear_contact_yaw_part
        + rear_contact_velocity_relative_vz_part * momentum_steer_about_rear_wheel_fz;
    const real M_steer_rear_contact_lean = rear_contact_spin_cos *
        momentum_steer_about_rear_wheel_mx
        + rear_contact_spin_sin * momentum_steer_about_rear_wheel_mz
        + rear_radius_times_momentum_minus_steer_about_frame_fy;

    /* momentum */
    /* momentum = composite inertia S */
    const wreal rear_wheel_base_mass = w[21];
    const real momentum_rear_contact_x_my = rear_contact_R_xx * rear_wheel_composite_moment_z
        - rear_contact_R_xz * rear_wheel_composite_moment_x;
    const real momentum_rear_contact_y_my = rear_contact_R_yx * rear_wheel_composite_moment_z
        - rear_contact_R_yz * rear_wheel_composite_moment_x;
    const real momentum_rear_contact_yaw_fy = rear_contact_minus_R_zx *
        rear_wheel_composite_moment_z + rear_contact_R_zz * rear_wheel_composite_moment_x;
    const real momentum_rear_contact_x_fx = rear_wheel_base_mass * rear_contact_R_xx;
    const real momentum_rear_contact_x_fz = rear_wheel_base_mass * rear_contact_R_xz;
    const real momentum_rear_contact_y_fx = rear_wheel_base_mass * rear_contact_R_yx;
    const real momentum_rear_contact_y_fy = rear_wheel_base_mass * rear_contact_R_yy;
    const real momentum_rear_contact_y_fz = rear_wheel_base_mass * rear_contact_R_yz;
    const real momentum_rear_contact_yaw_mx = rear_contact_lean_sin *
        rear_wheel_composite_inertia_xy
        - rear_contact_minus_R_zx * rear_wheel_composite_inertia_xx
        + rear_contact_R_zz * rear_wheel_composite_inertia_xz
        + rear_contact_velocity_relative_vz_part * frame_composite_moment_y;
    const real momentum_rear_contact_yaw_mz = rear_contact_lean_sin *
        rear_wheel_composite_inertia_yz
        - rear_contact_minus_R_zx * rear_wheel_composite_inertia_xz
        + rear_contact_R_zz * rear_wheel_composite_inertia_zz
        - rear_contact_velocity_relative_vx_part * frame_composite_moment_y;
    const real momentum_rear_contact_yaw_fx = rear_wheel_base_mass *
        rear_contact_velocity_relative_vx_part - (rear_contact_R_zz * frame_composite_moment_y
        - rear_contact_lean_sin * rear_wheel_composite_moment_z);
    const real momentum_rear_contact_yaw_fz = rear_wheel_base_mass *
        rear_contact_velocity_relative_vz_part
        - (rear_contact_lean_sin * rear_wheel_composite_moment_x
        + rear_contact_minus_R_zx * frame_composite_moment_y);
    const real momentum_rear_contact_lean_my =
        rear_contact_spin_cos_times_rear_wheel_composite_inertia_xy
        + rear_contact_spin_sin * rear_wheel_composite_inertia_yz;
    const real momentum_rear_contact_lean_mx = rear_contact_spin_cos *
        rear_wheel_composite_inertia_xx + rear_contact_spin_sin * rear_wheel_composite_inertia_xz
        + rear_radius * rear_wheel_composite_moment_z;
    const real momentum_rear_contact_lean_mz = rear_contact_spin_cos *
        rear_wheel_composite_inertia_xz + rear_contact_spin_sin * rear_wheel_composite_inertia_zz
        - rear_radius * rear_wheel_composite_moment_x;
    const real momentum_rear_contact_lean_fz = rear_contact_spin_cos * frame_composite_moment_y;

    /* M */
    /* M = S . momentum */
    const real M_rear_contact_x_rear_contact_x = rear_contact_R_xx * momentum_rear_contact_x_fx
        + rear_wheel_base_mass * rear_contact_minus_R_xy * rear_contact_minus_R_xy
        + rear_contact_R_xz * momentum_rear_contact_x_fz;
    const real M_rear_contact_y_rear_contact_x = rear_contact_R_xx * momentum_rear_contact_y_fx
        - rear_contact_minus_R_xy * momentum_rear_contact_y_fy
        + rear_contact_R_xz * momentum_rear_contact_y_fz;
    const real M_rear_contact_y_rear_contact_y = rear_contact_R_yx * momentum_rear_contact_y_fx
        + rear_contact_R_yy * momentum_rear_contact_y_fy
        + rear_contact_R_yz * momentum_rear_contact_y_fz;
    const real M_rear_contact_yaw_rear_contact_x = rear_contact_R_xx * momentum_rear_contact_yaw_fx
        - rear_contact_minus_R_xy * momentum_rear_contact_yaw_fy
        + rear_contact_R_xz * momentum_rear_contact_yaw_fz;
    const real M_rear_contact_yaw_rear_contact_y = rear_contact_R_yx * momentum_rear_contact_yaw_fx
        + rear_contact_R_yy * momentum_rear_contact_yaw_fy
        + rear_contact_R_yz * momentum_rear_contact_yaw_fz;

    /* shared by several: M */
    /* M = S . momentum */
    const real momentum_rear_contact_yaw_my_part = rear_contact_lean_sin *
        rear_wheel_composite_inertia_yy - M_rear_hub_rear_contact_yaw_part
        + rear_contact_R_zz * rear_wheel_composite_inertia_yz;

    /* momentum */
    /* momentum = composite inertia S */
    const real momentum_rear_contact_yaw_my = M_rear_hub_rear_contact_yaw_part_2
        - M_rear_hub_rear_contact_yaw_part_3 + momentum_rear_contact_yaw_my_part;

    /* rear_contact: M */
    /* M = S . momentum */
    const wreal rear_radius_times_rear_wheel_base_mass = w[36];
    const real M_rear_contact_yaw_rear_contact_yaw_part = rear_contact_lean_sin *
        momentum_rear_contact_yaw_my - rear_contact_minus_R_zx * momentum_rear_contact_yaw_mx
        + rear_contact_R_zz * momentum_rear_contact_yaw_mz
        + rear_contact_velocity_relative_vx_part * momentum_rear_contact_yaw_fx;
    const real momentum_minus_rear_contact_lean_fx = rear_contact_spin_sin *
        frame_composite_moment_y;
    const real momentum_minus_rear_contact_lean_fy = rear_contact_spin_cos *
        rear_wheel_composite_moment_z - rear_contact_spin_sin * rear_wheel_composite_moment_x
        + rear_radius_times_rear_wheel_base_mass;
    const real M_rear_contact_lean_rear_contact_yaw_part = rear_contact_lean_sin *
        momentum_rear_contact_lean_my - rear_contact_minus_R_zx * momentum_rear_contact_lean_mx
        + rear_contact_R_zz * momentum_rear_contact_lean_mz
        - rear_contact_velocity_relative_vx_part * momentum_minus_rear_contact_lean_fx;

    /* M */
    /* M = S . momentum */
    const real M_rear_contact_yaw_rear_contact_yaw = M_rear_contact_yaw_rear_contact_yaw_part
        + rear_contact_velocity_relative_vz_part * momentum_rear_contact_yaw_fz;
    const real M_rear_contact_lean_rear_contact_x = rear_contact_minus_R_xy *
        momentum_minus_rear_contact_lean_fy
        - rear_contact_R_xx * momentum_minus_rear_contact_lean_fx
        + rear_contact_R_xz * momentum_rear_contact_lean_fz;
    const real M_rear_contact_lean_rear_contact_y = rear_contact_R_yz *
        momentum_rear_contact_lean_fz - (rear_contact_R_yx * momentum_minus_rear_contact_lean_fx
        + rear_contact_R_yy * momentum_minus_rear_contact_lean_fy);
    const real M_rear_contact_lean_rear_contact_yaw = M_rear_contact_lean_rear_contact_yaw_part
        + rear_contact_velocity_relative_vz_part * momentum_rear_contact_lean_fz;
    const real M_rear_contact_lean_rear_contact_lean = rear_contact_spin_cos *
        momentum_rear_contact_lean_mx + rear_contact_spin_sin * momentum_rear_contact_lean_mz
        + rear_radius * momentum_minus_rear_contact_lean_fy;
    const real M_rear_contact_spin_rear_contact_yaw = M_rear_hub_rear_contact_yaw_part_2
        + momentum_rear_contact_yaw_my_part - M_rear_hub_rear_contact_yaw_part_3;

    /* front_wheel: alpha, omega, U, inertia force, n */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* omega = Rᵀ omega_parent + S_w u */
    /* U = [alpha] + [omega][omega] */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal front_wheel_base_second_moment_xx = w[26];
    const wreal front_wheel_base_second_moment_zz = w[27];
    const real front_wheel_minus_omega_x = front_hub_angle_sin * fork_omega_x
        + front_hub_minus_R_zx * fork_omega_z;
    const real front_wheel_omega_z = front_hub_angle_cos * fork_omega_x
        - front_hub_minus_R_zz * fork_omega_z;
    const real front_wheel_omega_y = front_hub_u - front_hub_R_yy * fork_minus_omega_y;
    const real front_wheel_alpha_y = front_hub_R_yy * fork_alpha_y;
    const real front_wheel_alpha_z = front_hub_angle_cos * fork_alpha_x
        - front_hub_minus_R_zz * fork_alpha_z - front_hub_u * front_wheel_minus_omega_x;
    const real front_wheel_minus_omega_x_times_omega_z = front_wheel_minus_omega_x *
        front_wheel_omega_z;
    const real front_wheel_U_xz = front_wheel_alpha_y - front_wheel_minus_omega_x_times_omega_z;
    const real front_wheel_U_yx = front_wheel_alpha_z
        - front_wheel_minus_omega_x * front_wheel_omega_y;
    const real front_wheel_U_yz = front_hub_angle_sin * fork_alpha_x
        + front_hub_minus_R_zx * fork_alpha_z + front_hub_u * front_wheel_omega_z
        + front_wheel_omega_z * front_wheel_omega_y;
    const real front_wheel_minus_n_x = front_wheel_base_second_moment_zz * front_wheel_U_yz;
    const real front_wheel_n_y = front_wheel_base_second_moment_zz * front_wheel_U_xz
        + front_wheel_base_second_moment_xx * (front_wheel_alpha_y
        + front_wheel_minus_omega_x_times_omega_z);
    const real front_wheel_n_z = front_wheel_base_second_moment_xx * front_wheel_U_yx;

    /* fork: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real fork_n_x = fork_base_second_moment_yy * fork_U_zy
        + fork_base_inertia_xz * fork_U_yx + (front_hub_angle_sin * front_wheel_minus_n_x
        + front_hub_angle_cos * front_wheel_n_z);
    const real fork_n_y = front_hub_R_yy * front_wheel_n_y
        - (fork_base_second_moment_xx * fork_U_zx
        + fork_base_inertia_xz * (fork_omega_x * fork_omega_x + fork_minus_omega_y_squared
        - fork_minus_U_xx) + fork_base_moment_x * fork_a_z);
    const real fork_n_z = front_hub_minus_R_zx * front_wheel_minus_n_x
        - front_hub_minus_R_zz * front_wheel_n_z + fork_n_z_part;

    /* frame: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real frame_minus_n_x = frame_base_second_moment_zz * frame_U_yz
        + frame_base_second_moment_xz * frame_U_yx + frame_base_moment_z * rear_wheel_a_y
        + (steer_minus_R_xx * fork_n_x + steer_minus_R_xy * fork_n_y
        + steer_minus_R_xz * fork_n_z + rear_radius * frame_minus_n_x_part);
    const real frame_n_y = steer_angle_cos * fork_n_x - steer_angle_sin * fork_n_y
        - (rear_radius * frame_n_y_part_2 + steer_place_x * frame_n_y_part_3) + frame_n_y_part;
    const real frame_n_z = frame_base_second_moment_xx * frame_U_yx
        + frame_base_second_moment_xz * frame_U_yz + frame_base_moment_x * rear_wheel_a_y
        + (steer_R_zz * fork_n_z - (steer_minus_R_zx * fork_n_x + steer_minus_R_zy * fork_n_y)
        - steer_place_x * frame_minus_n_x_part);

    /* rear_wheel: n, f */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const wreal rear_wheel_base_second_moment_xx = w[24];
    const wreal rear_wheel_base_second_moment_zz = w[25];
    const wreal rear_wheel_base_second_moment_yy = w[33];
    const real rear_wheel_n_x = rear_wheel_base_second_moment_yy * rear_wheel_U_zy
        - rear_wheel_base_second_moment_zz * rear_wheel_U_yz + (rear_hub_sin * frame_n_z
        - rear_hub_cos * frame_minus_n_x);
    const real rear_wheel_n_y = rear_wheel_base_second_moment_zz * rear_wheel_U_xz
        - rear_wheel_base_second_moment_xx * rear_wheel_U_zx + frame_n_y;
    const real rear_wheel_n_z = rear_wheel_base_second_moment_xx * rear_wheel_U_yx
        - rear_wheel_base_second_moment_yy * rear_wheel_U_xy + (rear_hub_sin * frame_minus_n_x
        + rear_hub_cos * frame_n_z);
    const real rear_wheel_f_x = rear_hub_cos * frame_f_x + rear_hub_sin * frame_f_z
        + rear_wheel_base_mass * rear_wheel_a_x;
    const real rear_wheel_f_y = rear_wheel_base_mass * rear_wheel_a_y + frame_f_y;
    const real rear_wheel_f_z = rear_hub_cos * frame_f_z - rear_hub_sin * frame_f_x
        + rear_wheel_base_mass * rear_wheel_a_z;

    /* rear_contact: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real rear_contact_u_x_tau = tau[0]; /* N */
    const real rear_contact_u_y_tau = tau[1]; /* N */
    const real rear_contact_u_yaw_tau = tau[2]; /* N*m */
    const real rear_contact_u_lean_tau = tau[3]; /* N*m */
    const real rear_contact_u_spin_tau = tau[4]; /* N*m */
    const real rear_contact_tau_x = rear_contact_R_xx * rear_wheel_f_x
        - rear_contact_minus_R_xy * rear_wheel_f_y + rear_contact_R_xz * rear_wheel_f_z;
    const real rear_contact_tau_y = rear_contact_R_yx * rear_wheel_f_x
        + rear_contact_R_yy * rear_wheel_f_y + rear_contact_R_yz * rear_wheel_f_z;
    const real rear_contact_tau_yaw = rear_contact_lean_sin * rear_wheel_n_y
        - rear_contact_minus_R_zx * rear_wheel_n_x + rear_contact_R_zz * rear_wheel_n_z
        + rear_contact_velocity_relative_vx_part * rear_wheel_f_x
        + rear_contact_velocity_relative_vz_part * rear_wheel_f_z;
    const real rear_contact_tau_lean = rear_contact_spin_cos * rear_wheel_n_x
        + rear_contact_spin_sin * rear_wheel_n_z - rear_radius * rear_wheel_f_y;
    const real rear_contact_drive_x = rear_contact_u_x_tau - rear_contact_tau_x;
    const real rear_contact_drive_y = rear_contact_u_y_tau - rear_contact_tau_y;
    const real rear_contact_drive_yaw = rear_contact_u_yaw_tau - rear_contact_tau_yaw;
    const real rear_contact_drive_lean = rear_contact_u_lean_tau - rear_contact_tau_lean;
    const real rear_contact_drive_spin = rear_contact_u_spin_tau - rear_wheel_n_y;

    /* rear_hub: drive, R */
    /* drive = tau + f - h */
    /* R = R_fixed R_joint(q) */
    const real rear_hub_u_tau = tau[5]; /* N*m */
    const real rear_hub_drive = rear_hub_u_tau - frame_n_y;
    const real rear_hub_u_times_sin = rear_hub_u * rear_hub_sin;
    const real rear_hub_u_times_cos = rear_hub_u * rear_hub_cos;

    /* steer: drive */
    /* drive = tau + f - h */
    const real steer_u_tau = tau[6]; /* N*m */
    const real steer_drive = steer_u_tau - fork_n_z;

    /* front_hub: drive */
    /* drive = tau + f - h */
    const real front_hub_u_tau = tau[7]; /* N*m */
    const real front_hub_drive = front_hub_u_tau - front_wheel_n_y;

    /* front_contact: G, pose, twist, rate */
    /* G = d(rate) / du */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* rate = G u + g_t */
    const real front_contact_G_pz_rear_contact_yaw_part_6 = front_contact_twist_rear_contact_yaw_wx
        * front_contact_G_pz_rear_contact_yaw_part_3
        + front_contact_twist_rear_contact_yaw_wz * front_contact_G_pz_rear_contact_yaw_part_5
        - front_contact_minus_front_wheel_R_zx * front_contact_twist_rear_contact_yaw_vx;
    const real front_contact_G_pz_rear_contact_yaw = front_contact_G_pz_rear_contact_yaw_part_6
        + front_contact_front_wheel_R_zy * front_contact_twist_rear_contact_yaw_vy
        + front_contact_front_wheel_R_zz * front_contact_twist_rear_contact_yaw_vz;
    const real front_contact_G_pz_rear_contact_lean_part = front_contact_twist_rear_contact_lean_wx
        * front_contact_G_pz_rear_contact_yaw_part_3
        + front_contact_twist_rear_contact_lean_wz * front_contact_G_pz_rear_contact_yaw_part_5
        - front_contact_minus_front_wheel_R_zx * front_contact_twist_rear_contact_lean_vx;
    const real front_contact_G_pz_rear_contact_lean = front_contact_G_pz_rear_contact_lean_part
        + front_contact_front_wheel_R_zy * front_contact_twist_rear_contact_lean_vy
        + front_contact_front_wheel_R_zz * front_contact_twist_rear_contact_lean_vz;
    const real front_contact_G_pz_rear_contact_spin_part = front_contact_twist_rear_contact_spin_wz
        * front_contact_G_pz_rear_contact_yaw_part_5
        - front_contact_minus_twist_rear_contact_spin_wx *
        front_contact_G_pz_rear_contact_yaw_part_3
        - front_contact_minus_front_wheel_R_zx * front_contact_twist_rear_contact_spin_vx;
    const real front_contact_G_pz_rear_contact_spin = front_contact_G_pz_rear_contact_spin_part
        + front_contact_front_wheel_R_zy * front_contact_twist_rear_contact_spin_vy
        + front_contact_front_wheel_R_zz * front_contact_twist_rear_contact_spin_vz;
    const real front_contact_G_pz_steer_part = front_contact_twist_steer_wx *
        front_contact_G_pz_rear_contact_yaw_part_3
        + front_contact_twist_steer_wz * front_contact_G_pz_rear_contact_yaw_part_5
        - front_contact_minus_front_wheel_R_zx * front_contact_twist_steer_vx;
    const real front_contact_G_pz_steer = front_contact_G_pz_steer_part
        + front_contact_front_wheel_R_zy * front_contact_twist_steer_vy
        + front_contact_front_wheel_R_zz * front_contact_twist_steer_vz;
    const real front_contact_G_pz_front_hub = front_contact_twist_front_hub_wx *
        front_contact_G_pz_rear_contact_yaw_part_3
        + front_contact_twist_front_hub_wz * front_contact_G_pz_rear_contact_yaw_part_5;
    const real front_contact_minus_frame_R_xx_rate = rear_hub_cos * rear_contact_minus_R_xx_rate
        + rear_contact_R_xx * rear_hub_u_times_sin + (rear_hub_sin * rear_contact_R_xz_rate
        + rear_contact_R_xz * rear_hub_u_times_cos);
    const real front_contact_frame_R_xz_rate = rear_contact_R_xx * rear_hub_u_times_cos
        - rear_hub_sin * rear_contact_minus_R_xx_rate + (rear_hub_cos * rear_contact_R_xz_rate
        - rear_contact_R_xz * rear_hub_u_times_sin);
    const real front_contact_frame_R_yx_rate = rear_hub_cos * rear_contact_R_yx_rate
        - rear_contact_R_yx * rear_hub_u_times_sin - (rear_hub_sin * rear_contact_R_yz_rate
        + rear_contact_R_yz * rear_hub_u_times_cos);
    const real front_contact_frame_R_yz_rate = rear_hub_sin * rear_contact_R_yx_rate
        + rear_contact_R_yx * rear_hub_u_times_cos + (rear_hub_cos * rear_contact_R_yz_rate
        - rear_contact_R_yz * rear_hub_u_times_sin);
    const real front_contact_minus_frame_R_zx_rate = rear_hub_cos * rear_contact_minus_R_zx_rate
        - rear_contact_minus_R_zx * rear_hub_u_times_sin
        + (rear_contact_R_zz * rear_hub_u_times_cos - rear_hub_sin * rear_contact_minus_R_zz_rate);
    const real front_contact_minus_frame_R_zz_rate = rear_hub_sin * rear_contact_minus_R_zx_rate
        + rear_contact_minus_R_zx * rear_hub_u_times_cos
        + (rear_hub_cos * rear_contact_minus_R_zz_rate + rear_contact_R_zz * rear_hub_u_times_sin);
    const real front_contact_minus_fork_R_xx_rate_part = front_contact_frame_R_xx *
        steer_minus_R_xx_rate - steer_minus_R_xx * front_contact_minus_frame_R_xx_rate
        + (steer_angle_cos * rear_contact_minus_R_xy_rate
        - rear_contact_minus_R_xy * steer_u_times_angle_sin);
    const real front_contact_minus_fork_R_xx_rate = steer_minus_R_zx * front_contact_frame_R_xz_rate
        + front_contact_frame_R_xz * steer_minus_R_zx_rate
        + front_contact_minus_fork_R_xx_rate_part;
    const real front_contact_fork_R_xy_rate_part = steer_minus_R_xy *
        front_contact_minus_frame_R_xx_rate + front_contact_frame_R_xx * steer_R_xy_rate
        + (steer_angle_sin * rear_contact_minus_R_xy_rate
        + rear_contact_minus_R_xy * steer_u_times_angle_cos);
    const real front_contact_fork_R_xz_rate = steer_minus_R_xz * front_contact_minus_frame_R_xx_rate
        + steer_R_zz * front_contact_frame_R_xz_rate;
    const real front_contact_minus_fork_R_yx_rate_part = steer_minus_R_xx *
        front_contact_frame_R_yx_rate + front_contact_frame_R_yx * steer_minus_R_xx_rate
        + (steer_angle_cos * rear_contact_minus_R_yy_rate
        + rear_contact_R_yy * steer_u_times_angle_sin);
    const real front_contact_minus_fork_R_yx_rate = steer_minus_R_zx * front_contact_frame_R_yz_rate
        + front_contact_frame_R_yz * steer_minus_R_zx_rate
        + front_contact_minus_fork_R_yx_rate_part;
    const real front_contact_minus_fork_R_yy_rate_part = steer_minus_R_xy *
        front_contact_frame_R_yx_rate - front_contact_frame_R_yx * steer_R_xy_rate
        + (rear_contact_R_yy * steer_u_times_angle_cos
        - steer_angle_sin * rear_contact_minus_R_yy_rate);
    const real front_contact_fork_R_yz_rate = steer_R_zz * front_contact_frame_R_yz_rate
        - steer_minus_R_xz * front_contact_frame_R_yx_rate;
    const real front_contact_fork_R_zx_rate_part = steer_minus_R_xx *
        front_contact_minus_frame_R_zx_rate
        + front_contact_minus_frame_R_zx * steer_minus_R_xx_rate
        + (steer_angle_cos * rear_contact_u_lean_times_lean_cos
        - rear_contact_lean_sin * steer_u_times_angle_sin);
    const real front_contact_fork_R_zx_rate = front_contact_fork_R_zx_rate_part
        - (front_contact_frame_R_zz * steer_minus_R_zx_rate
        - steer_minus_R_zx * front_contact_minus_frame_R_zz_rate);
    const real front_contact_fork_R_zy_rate_part = steer_minus_R_xy *
        front_contact_minus_frame_R_zx_rate - front_contact_minus_frame_R_zx * steer_R_xy_rate
        - (steer_angle_sin * rear_contact_u_lean_times_lean_cos
        + rear_contact_lean_sin * steer_u_times_angle_cos);
    const real front_contact_fork_R_zz_rate = steer_minus_R_xz * front_contact_minus_frame_R_zx_rate
        - steer_R_zz * front_contact_minus_frame_R_zz_rate;
    const real front_contact_fork_p_x_rate = rear_contact_p_x_rate
        - (steer_place_x * front_contact_minus_frame_R_xx_rate
        + rear_radius * front_contact_frame_R_xz_rate);
    const real front_contact_fork_p_y_rate = steer_place_x * front_contact_frame_R_yx_rate
        - rear_radius * front_contact_frame_R_yz_rate + rear_contact_p_y_rate;
    const real front_contact_minus_fork_p_z_rate = steer_place_x *
        front_contact_minus_frame_R_zx_rate - rear_radius * front_contact_minus_frame_R_zz_rate
        + rear_contact_minus_p_z_rate;
    const real front_contact_front_wheel_R_xx_rate = front_hub_angle_sin *
        front_contact_minus_fork_R_xx_rate
        + front_contact_minus_fork_R_xx * front_hub_u_times_angle_cos
        - (front_hub_minus_R_zx * front_contact_fork_R_xz_rate
        - front_contact_fork_R_xz * front_hub_R_zx_rate);
    const real front_contact_front_wheel_R_xy_rate = front_hub_R_yy *
        (front_contact_fork_R_xy_rate_part - (steer_minus_R_zy * front_contact_frame_R_xz_rate
        - front_contact_frame_R_xz * steer_R_zy_rate));
    const real front_contact_minus_front_wheel_R_xz_rate = front_hub_angle_cos *
        front_contact_minus_fork_R_xx_rate
        - front_contact_minus_fork_R_xx * front_hub_u_times_angle_sin
        + (front_hub_minus_R_zz * front_contact_fork_R_xz_rate
        + front_contact_fork_R_xz * front_hub_minus_R_zz_rate);
    const real front_contact_minus_front_wheel_R_yx_rate = front_contact_fork_R_yx *
        front_hub_u_times_angle_cos - front_hub_angle_sin * front_contact_minus_fork_R_yx_rate
        + (front_hub_minus_R_zx * front_contact_fork_R_yz_rate
        - front_contact_fork_R_yz * front_hub_R_zx_rate);
    const real front_contact_minus_front_wheel_R_yy_rate = front_hub_R_yy * (steer_minus_R_zy *
        front_contact_frame_R_yz_rate - front_contact_frame_R_yz * steer_R_zy_rate
        + front_contact_minus_fork_R_yy_rate_part);
    const real front_contact_minus_front_wheel_R_yz_rate = front_hub_angle_cos *
        front_contact_minus_fork_R_yx_rate
        + front_contact_fork_R_yx * front_hub_u_times_angle_sin
        + (front_hub_minus_R_zz * front_contact_fork_R_yz_rate
        + front_contact_fork_R_yz * front_hub_minus_R_zz_rate);
    const real front_contact_minus_front_wheel_R_zx_rate = front_hub_angle_sin *
        front_contact_fork_R_zx_rate + front_contact_fork_R_zx * front_hub_u_times_angle_cos
        + (front_hub_minus_R_zx * front_contact_fork_R_zz_rate
        - front_contact_fork_R_zz * front_hub_R_zx_rate);
    const real front_contact_front_wheel_R_zy_rate = front_hub_R_yy * (steer_minus_R_zy *
        front_contact_minus_frame_R_zz_rate + front_contact_frame_R_zz * steer_R_zy_rate
        + front_contact_fork_R_zy_rate_part);
    const real front_contact_front_wheel_R_zz_rate = front_hub_angle_cos *
        front_contact_fork_R_zx_rate - front_contact_fork_R_zx * front_hub_u_times_angle_sin
        - (front_hub_minus_R_zz * front_contact_fork_R_zz_rate
        + front_contact_fork_R_zz * front_hub_minus_R_zz_rate);
    const real front_contact_front_wheel_p_x_rate = front_hub_p_z * front_contact_fork_R_xz_rate
        - front_hub_p_x * front_contact_minus_fork_R_xx_rate + front_contact_fork_p_x_rate;
    const real front_contact_front_wheel_p_y_rate = front_hub_p_z * front_contact_fork_R_yz_rate
        - front_hub_p_x * front_contact_minus_fork_R_yx_rate + front_contact_fork_p_y_rate;
    const real front_contact_front_wheel_p_z_rate = front_hub_p_x * front_contact_fork_R_zx_rate
        + front_hub_p_z * front_contact_fork_R_zz_rate - front_contact_minus_fork_p_z_rate;
    const real front_contact_arm_rear_contact_x_rate = front_contact_front_wheel_p_x_rate
        - rear_contact_p_x_rate;
    const real front_contact_arm_rear_contact_y_rate = front_contact_front_wheel_p_y_rate
        - rear_contact_p_y_rate;
    const real front_contact_arm_rear_contact_z_rate = rear_contact_minus_p_z_rate
        + front_contact_front_wheel_p_z_rate;
    const real front_contact_base_twist_by_rear_contact_vx_rate_part_3 =
        front_contact_base_twist_by_rear_contact_wy * front_contact_arm_rear_contact_z_rate
        + front_contact_arm_rear_contact_z * front_contact_base_twist_by_rear_contact_wy_rate;
    const real front_contact_base_twist_by_rear_contact_vx_rate_part_4 =
        front_contact_base_twist_by_rear_contact_vx_rate_part_3
        - (front_contact_base_twist_by_rear_contact_wz * front_contact_arm_rear_contact_y_rate
        + front_contact_arm_rear_contact_y * front_contact_base_twist_by_rear_contact_wz_rate);
    const real front_contact_base_twist_by_rear_contact_vy_rate_part_3 =
        front_contact_base_twist_by_rear_contact_wz * front_contact_arm_rear_contact_x_rate
        + front_contact_arm_rear_contact_x * front_contact_base_twist_by_rear_contact_wz_rate;
    const real front_contact_base_twist_by_rear_contact_vy_rate_part_4 =
        front_contact_base_twist_by_rear_contact_vy_rate_part_3
        - (front_contact_base_twist_by_rear_contact_wx * front_contact_arm_rear_contact_z_rate
        + front_contact_arm_rear_contact_z * front_contact_base_twist_by_rear_contact_wx_rate);
    const real front_contact_base_twist_by_rear_contact_vz_rate_part_3 =
        front_contact_base_twist_by_rear_contact_wx * front_contact_arm_rear_contact_y_rate
        + front_contact_arm_rear_contact_y * front_contact_base_twist_by_rear_contact_wx_rate;
    const real front_contact_base_twist_by_rear_contact_vz_rate_part_4 =
        front_contact_base_twist_by_rear_contact_vz_rate_part_3
        - (front_contact_base_twist_by_rear_contact_wy * front_contact_arm_rear_contact_x_rate
        + front_contact_arm_rear_contact_x * front_contact_base_twist_by_rear_contact_wy_rate);
    const real front_contact_base_twist_by_rear_contact_vx_rate = rear_contact_velocity_relative_vz
        * rear_contact_R_xz_rate + rear_contact_R_xz * rear_contact_velocity_relative_vz_rate
        + front_contact_base_twist_by_rear_contact_vx_rate_part_2
        + front_contact_base_twist_by_rear_contact_vx_rate_part_4;
    const real front_contact_base_twist_by_rear_contact_vy_rate = rear_contact_velocity_relative_vz
        * rear_contact_R_yz_rate + rear_contact_R_yz * rear_contact_velocity_relative_vz_rate
        + front_contact_base_twist_by_rear_contact_vy_rate_part_2
        + front_contact_base_twist_by_rear_contact_vy_rate_part_4;
    const real front_contact_base_twist_by_rear_contact_vz_rate = rear_contact_R_zz *
        rear_contact_velocity_relative_vz_rate
        - rear_contact_velocity_relative_vz * rear_contact_minus_R_zz_rate
        + front_contact_base_twist_by_rear_contact_vz_rate_part_2
        + front_contact_base_twist_by_rear_contact_vz_rate_part_4;
    const real front_contact_base_twist_by_rear_hub_vx_rate_part =
        front_contact_base_twist_by_rear_hub_wy * front_contact_arm_rear_contact_z_rate
        - front_contact_arm_rear_contact_z * front_contact_minus_base_twist_by_rear_hub_wy_rate;
    const real front_contact_base_twist_by_rear_hub_vx_rate =
        front_contact_base_twist_by_rear_hub_vx_rate_part
        - (front_contact_base_twist_by_rear_hub_wz * front_contact_arm_rear_contact_y_rate
        + front_contact_arm_rear_contact_y * front_contact_base_twist_by_rear_hub_wz_rate);
    const real front_contact_base_twist_by_rear_hub_vy_rate_part =
        front_contact_minus_base_twist_by_rear_hub_wx * front_contact_arm_rear_contact_z_rate
        + front_contact_arm_rear_contact_z * front_contact_minus_base_twist_by_rear_hub_wx_rate;
    const real front_contact_base_twist_by_rear_hub_vy_rate =
        front_contact_base_twist_by_rear_hub_wz * front_contact_arm_rear_contact_x_rate
        + front_contact_arm_rear_contact_x * front_contact_base_twist_by_rear_hub_wz_rate
        + front_contact_base_twist_by_rear_hub_vy_rate_part;
    const real front_contact_minus_base_twist_by_rear_hub_vz_rate_part =
        front_contact_minus_base_twist_by_rear_hub_wx * front_contact_arm_rear_contact_y_rate
        + front_contact_arm_rear_contact_y * front_contact_minus_base_twist_by_rear_hub_wx_rate;
    const real front_contact_minus_base_twist_by_rear_hub_vz_rate =
        front_contact_base_twist_by_rear_hub_wy * front_contact_arm_rear_contact_x_rate
        - front_contact_arm_rear_contact_x * front_contact_minus_base_twist_by_rear_hub_wy_rate
        + front_contact_minus_base_twist_by_rear_hub_vz_rate_part;
    const real front_contact_arm_steer_x_rate = front_contact_front_wheel_p_x_rate
        - front_contact_fork_p_x_rate;
    const real front_contact_arm_steer_y_rate = front_contact_front_wheel_p_y_rate
        - front_contact_fork_p_y_rate;
    const real front_contact_arm_steer_z_rate = front_contact_minus_fork_p_z_rate
        + front_contact_front_wheel_p_z_rate;
    const real front_contact_base_twist_by_steer_wx_rate = steer_u * front_contact_fork_R_xz_rate;
    const real front_contact_base_twist_by_steer_wy_rate = steer_u * front_contact_fork_R_yz_rate;
    const real front_contact_base_twist_by_steer_wz_rate = steer_u * front_contact_fork_R_zz_rate;
    const real front_contact_base_twist_by_steer_vx_rate_part = front_contact_base_twist_by_steer_wy
        * front_contact_arm_steer_z_rate
        + front_contact_arm_steer_z * front_contact_base_twist_by_steer_wy_rate;
    const real front_contact_base_twist_by_steer_vx_rate =
        front_contact_base_twist_by_steer_vx_rate_part
        - (front_contact_base_twist_by_steer_wz * front_contact_arm_steer_y_rate
        + front_contact_arm_steer_y * front_contact_base_twist_by_steer_wz_rate);
    const real front_contact_base_twist_by_steer_vy_rate_part = front_contact_base_twist_by_steer_wz
        * front_contact_arm_steer_x_rate
        + front_contact_arm_steer_x * front_contact_base_twist_by_steer_wz_rate;
    const real front_contact_base_twist_by_steer_vy_rate =
        front_contact_base_twist_by_steer_vy_rate_part
        - (front_contact_base_twist_by_steer_wx * front_contact_arm_steer_z_rate
        + front_contact_arm_steer_z * front_contact_base_twist_by_steer_wx_rate);
    const real front_contact_base_twist_by_steer_vz_rate_part = front_contact_base_twist_by_steer_wx
        * front_contact_arm_steer_y_rate
        + front_contact_arm_steer_y * front_contact_base_twist_by_steer_wx_rate;
    const real front_contact_base_twist_by_steer_vz_rate =
        front_contact_base_twist_by_steer_vz_rate_part
        - (front_contact_base_twist_by_steer_wy * front_contact_arm_steer_x_rate
        + front_contact_arm_steer_x * front_contact_base_twist_by_steer_wy_rate);
    const real front_contact_base_twist_vx_rate = front_contact_base_twist_by_rear_contact_vx_rate +
        front_contact_base_twist_by_rear_hub_vx_rate + front_contact_base_twist_by_steer_vx_rate;
    const real front_contact_base_twist_vy_rate = front_contact_base_twist_by_rear_contact_vy_rate +
        front_contact_base_twist_by_rear_hub_vy_rate + front_contact_base_twist_by_steer_vy_rate;
    const real front_contact_base_twist_vz_rate = front_contact_base_twist_by_rear_contact_vz_rate -
        front_contact_minus_base_twist_by_rear_hub_vz_rate
        + front_contact_base_twist_by_steer_vz_rate;
    const real front_contact_base_twist_wx_rate = front_contact_base_twist_by_rear_contact_wx_rate -
        front_contact_minus_base_twist_by_rear_hub_wx_rate
        + front_contact_base_twist_by_steer_wx_rate
        + front_hub_u * front_contact_front_wheel_R_xy_rate;
    const real front_contact_base_twist_wy_rate = front_contact_base_twist_by_rear_contact_wy_rate -
        front_contact_minus_base_twist_by_rear_hub_wy_rate
        + front_contact_base_twist_by_steer_wy_rate
        - front_hub_u * front_contact_minus_front_wheel_R_yy_rate;
    const real front_contact_base_twist_wz_rate = front_contact_base_twist_by_rear_contact_wz_rate +
        front_contact_base_twist_by_rear_hub_wz_rate + front_contact_base_twist_by_steer_wz_rate
        + front_hub_u * front_contact_front_wheel_R_zy_rate;
    const real front_contact_gamma_pz_part = front_contact_front_wheel_R_xy *
        front_contact_front_wheel_R_xx_rate
        + front_contact_front_wheel_R_xx * front_contact_front_wheel_R_xy_rate;
    const real front_contact_gamma_pz_part_2 = front_contact_minus_front_wheel_R_yy *
        front_contact_minus_front_wheel_R_yx_rate
        + front_contact_minus_front_wheel_R_yx * front_contact_minus_front_wheel_R_yy_rate;
    const real front_contact_front_wheel_R_xy_times_front_wheel_R_xy_rate =
        front_contact_front_wheel_R_xy * front_contact_front_wheel_R_xy_rate;
    const real front_contact_slip_rear_contact_x_upright_rate_part =
        front_contact_minus_front_wheel_R_yy * front_contact_minus_front_wheel_R_yy_rate;
    const real front_contact_slip_rear_contact_x_upright_rate_part_2 =
        front_contact_front_wheel_R_xy_times_front_wheel_R_xy_rate
        + front_contact_front_wheel_R_xy_times_front_wheel_R_xy_rate
        + (front_contact_slip_rear_contact_x_upright_rate_part
        + front_contact_slip_rear_contact_x_upright_rate_part);
    const real front_contact_front_wheel_R_zy_times_front_wheel_R_zy_rate =
        front_contact_front_wheel_R_zy * front_contact_front_wheel_R_zy_rate;
    const real front_contact_gamma_pz_part_3 = front_contact_minus_front_wheel_R_xz *
        front_contact_front_wheel_R_xy_rate
        + front_contact_front_wheel_R_xy * front_contact_minus_front_wheel_R_xz_rate;
    const real front_contact_gamma_pz_part_4 = front_contact_front_wheel_R_yz *
        front_contact_minus_front_wheel_R_yy_rate
        - front_contact_minus_front_wheel_R_yy * front_contact_minus_front_wheel_R_yz_rate;
    const real front_contact_twist_wx_rate_part = front_contact_base_twist_wy *
        front_contact_minus_front_wheel_R_yx_rate
        + front_contact_minus_front_wheel_R_yx * front_contact_base_twist_wy_rate;
    const real front_contact_twist_wx_rate_part_2 = front_contact_base_twist_wx *
        front_contact_front_wheel_R_xx_rate
        + front_contact_front_wheel_R_xx * front_contact_base_twist_wx_rate
        - front_contact_twist_wx_rate_part;
    const real front_contact_twist_wx_rate = front_contact_twist_wx_rate_part_2
        - (front_contact_base_twist_wz * front_contact_minus_front_wheel_R_zx_rate
        + front_contact_minus_front_wheel_R_zx * front_contact_base_twist_wz_rate);
    const real front_contact_twist_wy_rate_part = front_contact_base_twist_wy *
        front_contact_minus_front_wheel_R_yy_rate
        + front_contact_minus_front_wheel_R_yy * front_contact_base_twist_wy_rate;
    const real front_contact_twist_wy_rate_part_2 = front_contact_base_twist_wx *
        front_contact_front_wheel_R_xy_rate
        + front_contact_front_wheel_R_xy * front_contact_base_twist_wx_rate
        - front_contact_twist_wy_rate_part;
    const real front_contact_twist_wy_rate = front_contact_base_twist_wz *
        front_contact_front_wheel_R_zy_rate
        + front_contact_front_wheel_R_zy * front_contact_base_twist_wz_rate
        + front_contact_twist_wy_rate_part_2;
    const real front_contact_twist_wz_rate_part = front_contact_base_twist_wx *
        front_contact_minus_front_wheel_R_xz_rate
        + front_contact_minus_front_wheel_R_xz * front_contact_base_twist_wx_rate;
    const real front_contact_twist_wz_rate_part_2 = front_contact_front_wheel_R_yz *
        front_contact_base_twist_wy_rate
        - front_contact_base_twist_wy * front_contact_minus_front_wheel_R_yz_rate
        - front_contact_twist_wz_rate_part;
    const real front_contact_twist_wz_rate = front_contact_base_twist_wz *
        front_contact_front_wheel_R_zz_rate
        + front_contact_front_wheel_R_zz * front_contact_base_twist_wz_rate
        + front_contact_twist_wz_rate_part_2;
    const real front_contact_twist_vx_rate_part = front_contact_base_twist_vy *
        front_contact_minus_front_wheel_R_yx_rate
        + front_contact_minus_front_wheel_R_yx * front_contact_base_twist_vy_rate;
    const real front_contact_twist_vx_rate_part_2 = front_contact_base_twist_vx *
        front_contact_front_wheel_R_xx_rate
        + front_contact_front_wheel_R_xx * front_contact_base_twist_vx_rate
        - front_contact_twist_vx_rate_part;
    const real front_contact_twist_vx_rate = front_contact_twist_vx_rate_part_2
        - (front_contact_base_twist_vz * front_contact_minus_front_wheel_R_zx_rate
        + front_contact_minus_front_wheel_R_zx * front_contact_base_twist_vz_rate);
    const real front_contact_twist_vy_rate_part = front_contact_base_twist_vy *
        front_contact_minus_front_wheel_R_yy_rate
        + front_contact_minus_front_wheel_R_yy * front_contact_base_twist_vy_rate;
    const real front_contact_twist_vy_rate_part_2 = front_contact_base_twist_vx *
        front_contact_front_wheel_R_xy_rate
        + front_contact_front_wheel_R_xy * front_contact_base_twist_vx_rate
        - front_contact_twist_vy_rate_part;
    const real front_contact_twist_vy_rate = front_contact_base_twist_vz *
        front_contact_front_wheel_R_zy_rate
        + front_contact_front_wheel_R_zy * front_contact_base_twist_vz_rate
        + front_contact_twist_vy_rate_part_2;
    const real front_contact_twist_vz_rate_part = front_contact_base_twist_vx *
        front_contact_minus_front_wheel_R_xz_rate
        + front_contact_minus_front_wheel_R_xz * front_contact_base_twist_vx_rate;
    const real front_contact_twist_vz_rate_part_2 = front_contact_front_wheel_R_yz *
        front_contact_base_twist_vy_rate
        - front_contact_base_twist_vy * front_contact_minus_front_wheel_R_yz_rate
        - front_contact_twist_vz_rate_part;
    const real front_contact_twist_vz_rate = front_contact_base_twist_vz *
        front_contact_front_wheel_R_zz_rate
        + front_contact_front_wheel_R_zz * front_contact_base_twist_vz_rate
        + front_contact_twist_vz_rate_part_2;
    const real front_contact_rate_turning_x_rate_part = front_contact_twist_wx *
        front_contact_front_wheel_R_xx_rate
        + front_contact_front_wheel_R_xx * front_contact_twist_wx_rate
        + (front_contact_twist_wy * front_contact_front_wheel_R_xy_rate
        + front_contact_front_wheel_R_xy * front_contact_twist_wy_rate);
    const real front_contact_rate_turning_y_rate_part = front_contact_twist_wx *
        front_contact_minus_front_wheel_R_yx_rate
        + front_contact_minus_front_wheel_R_yx * front_contact_twist_wx_rate;
    const real front_contact_rate_turning_y_rate_part_2 = front_contact_twist_wy *
        front_contact_minus_front_wheel_R_yy_rate
        + front_contact_minus_front_wheel_R_yy * front_contact_twist_wy_rate
        + front_contact_rate_turning_y_rate_part;
    const real front_contact_rate_turning_z_rate_part = front_contact_twist_wx *
        front_contact_minus_front_wheel_R_zx_rate
        + front_contact_minus_front_wheel_R_zx * front_contact_twist_wx_rate;
    const real front_contact_rate_turning_z_rate_part_2 = front_contact_twist_wy *
        front_contact_front_wheel_R_zy_rate
        + front_contact_front_wheel_R_zy * front_contact_twist_wy_rate
        - front_contact_rate_turning_z_rate_part;
    const real front_contact_rate_turning_z_rate = front_contact_twist_wz *
        front_contact_front_wheel_R_zz_rate
        + front_contact_front_wheel_R_zz * front_contact_twist_wz_rate
        + front_contact_rate_turning_z_rate_part_2;
    const real front_contact_rate_sliding_x_rate_part = front_contact_twist_vx *
        front_contact_front_wheel_R_xx_rate
        + front_contact_front_wheel_R_xx * front_contact_twist_vx_rate
        + (front_contact_twist_vy * front_contact_front_wheel_R_xy_rate
        + front_contact_front_wheel_R_xy * front_contact_twist_vy_rate);
    const real front_contact_rate_sliding_x_rate = front_contact_rate_sliding_x_rate_part
        - (front_contact_twist_vz * front_contact_minus_front_wheel_R_xz_rate
        + front_contact_minus_front_wheel_R_xz * front_contact_twist_vz_rate);
    const real front_contact_rate_sliding_y_rate_part = front_contact_twist_vx *
        front_contact_minus_front_wheel_R_yx_rate
        + front_contact_minus_front_wheel_R_yx * front_contact_twist_vx_rate;
    const real front_contact_rate_sliding_y_rate_part_2 = front_contact_twist_vy *
        front_contact_minus_front_wheel_R_yy_rate
        + front_contact_minus_front_wheel_R_yy * front_contact_twist_vy_rate
        + front_contact_rate_sliding_y_rate_part;
    const real front_contact_rate_sliding_y_rate = front_contact_front_wheel_R_yz *
        front_contact_twist_vz_rate
        - front_contact_twist_vz * front_contact_minus_front_wheel_R_yz_rate
        - front_contact_rate_sliding_y_rate_part_2;
    const real front_contact_rate_velocity_x_rate_part =
        front_contact_minus_slip_rear_contact_x_arm_z * (front_contact_front_wheel_R_yz *
        front_contact_twist_wz_rate
        - front_contact_twist_wz * front_contact_minus_front_wheel_R_yz_rate
        - front_contact_rate_turning_y_rate_part_2);
    const real front_contact_rate_velocity_y_rate_part =
        front_contact_minus_slip_rear_contact_x_arm_z * (front_contact_rate_turning_x_rate_part
        - (front_contact_twist_wz * front_contact_minus_front_wheel_R_xz_rate
        + front_contact_minus_front_wheel_R_xz * front_contact_twist_wz_rate));

    /* common */
    const real front_contact_slip_rear_contact_x_upright_rate =
        front_contact_G_pz_rear_contact_yaw_part_2 *
        front_contact_slip_rear_contact_x_upright_rate_part_2;
    const real front_contact_gamma_pz_part_5 =
        cardan_select(front_contact_slip_rear_contact_x_upright,
        -c0p5_per_front_contact_slip_rear_contact_x_upright *
        front_contact_slip_rear_contact_x_upright_rate / front_contact_slip_rear_contact_x_upright,
        0.0);
    const real front_contact_gamma_pz_part_6 = front_radius *
        (front_contact_G_pz_rear_contact_yaw_part_2 * (front_contact_gamma_pz_part_3
        + front_contact_gamma_pz_part_3 + (front_contact_gamma_pz_part_4
        + front_contact_gamma_pz_part_4))
        + front_contact_G_pz_rear_contact_yaw_part * front_contact_gamma_pz_part_5);
    const real front_contact_gamma_pz_part_7 = front_radius *
        (front_contact_G_pz_rear_contact_yaw_part_4 * front_contact_gamma_pz_part_5
        + front_contact_G_pz_rear_contact_yaw_part_2 * (front_contact_gamma_pz_part
        + front_contact_gamma_pz_part + (front_contact_gamma_pz_part_2
        + front_contact_gamma_pz_part_2)));

    /* front_contact: slip rear contact, rate, gamma */
    /* rate = G u + g_t */
    /* gamma = -d(rate)/dt at udot = 0 */
    const real front_contact_minus_slip_rear_contact_x_heading_x_rate =
        (front_contact_minus_front_wheel_R_yy_rate
        - front_contact_minus_slip_rear_contact_x_heading_x *
        front_contact_slip_rear_contact_x_upright_rate) / front_contact_slip_rear_contact_x_upright;
    const real front_contact_minus_slip_rear_contact_x_heading_y_rate =
        (front_contact_front_wheel_R_xy_rate
        - front_contact_minus_slip_rear_contact_x_heading_y *
        front_contact_slip_rear_contact_x_upright_rate) / front_contact_slip_rear_contact_x_upright;
    const real front_contact_minus_slip_rear_contact_x_up_x_rate_part =
        front_contact_front_wheel_R_zy * front_contact_front_wheel_R_xy_rate
        + front_contact_front_wheel_R_xy * front_contact_front_wheel_R_zy_rate
        - front_contact_minus_slip_rear_contact_x_up_x *
        front_contact_slip_rear_contact_x_upright_rate;
    const real front_contact_slip_rear_contact_x_up_y_rate_part = front_contact_front_wheel_R_zy *
        front_contact_minus_front_wheel_R_yy_rate
        + front_contact_minus_front_wheel_R_yy * front_contact_front_wheel_R_zy_rate
        - front_contact_slip_rear_contact_x_up_y * front_contact_slip_rear_contact_x_upright_rate;
    const real front_contact_minus_slip_rear_contact_x_up_z_rate =
        (front_contact_front_wheel_R_zy_times_front_wheel_R_zy_rate
        + front_contact_front_wheel_R_zy_times_front_wheel_R_zy_rate
        + front_contact_slip_rear_contact_x_up_z * front_contact_slip_rear_contact_x_upright_rate) /
        front_contact_slip_rear_contact_x_upright;
    const real front_contact_slip_rear_contact_x_arm_z_rate = front_radius *
        front_contact_minus_slip_rear_contact_x_up_z_rate;
    const real front_contact_gamma_pz_part_8 = front_contact_G_pz_rear_contact_yaw_part_3 *
        front_contact_twist_wx_rate + front_contact_twist_wx * front_contact_gamma_pz_part_6
        + (front_contact_G_pz_rear_contact_yaw_part_5 * front_contact_twist_wz_rate
        + front_contact_twist_wz * front_contact_gamma_pz_part_7);
    const real front_contact_rate_velocity_x_rate_part_2 =
        front_contact_slip_rear_contact_x_up_y_rate_part / front_contact_slip_rear_contact_x_upright
        * front_radius * front_contact_rate_turning_z
        + front_contact_minus_slip_rear_contact_x_arm_y * front_contact_rate_turning_z_rate;
    const real front_contact_rate_velocity_y_rate_part_2 =
        front_contact_minus_slip_rear_contact_x_up_x_rate_part /
        front_contact_slip_rear_contact_x_upright * front_radius * front_contact_rate_turning_z
        + front_contact_slip_rear_contact_x_arm_x * front_contact_rate_turning_z_rate;
    const real front_contact_rate_velocity_x_rate = front_contact_rate_velocity_x_rate_part_2
        - (front_contact_rate_velocity_x_rate_part
        - front_contact_rate_turning_y * front_contact_slip_rear_contact_x_arm_z_rate)
        + front_contact_rate_sliding_x_rate;
    const real front_contact_rate_velocity_y_rate = front_contact_rate_velocity_y_rate_part
        - front_contact_rate_turning_x * front_contact_slip_rear_contact_x_arm_z_rate
        + front_contact_rate_velocity_y_rate_part_2 + front_contact_rate_sliding_y_rate;
    const real front_contact_gamma_longitudinal_part = front_contact_rate_velocity_x *
        front_contact_minus_slip_rear_contact_x_heading_x_rate
        + front_contact_minus_slip_rear_contact_x_heading_x * front_contact_rate_velocity_x_rate;
    const real front_contact_gamma_longitudinal = front_contact_rate_velocity_y *
        front_contact_minus_slip_rear_contact_x_heading_y_rate
        + front_contact_minus_slip_rear_contact_x_heading_y * front_contact_rate_velocity_y_rate
        + front_contact_gamma_longitudinal_part;
    const real front_contact_gamma_lateral_part = front_contact_rate_velocity_y *
        front_contact_minus_slip_rear_contact_x_heading_x_rate
        + front_contact_minus_slip_rear_contact_x_heading_x * front_contact_rate_velocity_y_rate;
    const real front_contact_gamma_lateral = front_contact_gamma_lateral_part
        - (front_contact_rate_velocity_x * front_contact_minus_slip_rear_contact_x_heading_y_rate
        + front_contact_minus_slip_rear_contact_x_heading_y * front_contact_rate_velocity_x_rate);

    /* common */
    const real front_contact_gamma_pz_part_9 = front_contact_twist_vx *
        front_contact_minus_front_wheel_R_zx_rate
        + front_contact_minus_front_wheel_R_zx * front_contact_twist_vx_rate
        - front_contact_gamma_pz_part_8;
    const real front_contact_gamma_pz_part_10 = front_contact_gamma_pz_part_9
        - (front_contact_twist_vy * front_contact_front_wheel_R_zy_rate
        + front_contact_front_wheel_R_zy * front_contact_twist_vy_rate);

    /* front_contact: gamma */
    /* gamma = -d(rate)/dt at udot = 0 */
    const real front_contact_gamma_pz = front_contact_gamma_pz_part_10
        - (front_contact_twist_vz * front_contact_front_wheel_R_zz_rate
        + front_contact_front_wheel_R_zz * front_contact_twist_vz_rate);

    /* constraints: factor, multipliers */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const wreal M_factor_D_inverse_front_hub = w[37];
    const real M_minus_factor_L_front_hub_rear_contact_spin =
        momentum_minus_front_hub_about_frame_my * M_factor_D_inverse_front_hub;
    const real M_factor_DL_rear_hub_rear_contact_yaw_part = M_front_hub_rear_contact_yaw *
        M_minus_factor_L_front_hub_rear_contact_spin;
    const real M_factor_DL_rear_hub_rear_contact_lean_part = M_front_hub_rear_contact_lean *
        M_minus_factor_L_front_hub_rear_contact_spin;
    const real M_factor_D_rear_hub_part = momentum_minus_front_hub_about_frame_my *
        M_minus_factor_L_front_hub_rear_contact_spin;
    const real M_factor_L_front_hub_rear_contact_lean = M_front_hub_rear_contact_lean *
        M_factor_D_inverse_front_hub;
    const real M_factor_L_front_hub_rear_contact_yaw = M_front_hub_rear_contact_yaw *
        M_factor_D_inverse_front_hub;
    const real M_factor_D_inverse_steer = 1.0 / fork_composite_inertia_zz;
    const real M_factor_L_steer_rear_contact_spin = M_steer_rear_contact_spin *
        M_factor_D_inverse_steer;
    const real M_factor_DL_rear_hub_rear_contact_x = momentum_rear_contact_x_my
        - M_steer_rear_contact_x * M_factor_L_steer_rear_contact_spin;
    const real M_factor_DL_rear_hub_rear_contact_y = momentum_rear_contact_y_my
        - M_steer_rear_contact_y * M_factor_L_steer_rear_contact_spin;
    const real M_factor_DL_rear_hub_rear_contact_yaw_part_2 = M_steer_rear_contact_yaw *
        M_factor_L_steer_rear_contact_spin;
    const real M_factor_DL_rear_hub_rear_contact_yaw = M_rear_hub_rear_contact_yaw
        + M_factor_DL_rear_hub_rear_contact_yaw_part - M_factor_DL_rear_hub_rear_contact_yaw_part_2;
    const real M_factor_DL_rear_hub_rear_contact_lean_part_2 = M_steer_rear_contact_lean *
        M_factor_L_steer_rear_contact_spin;
    const real M_factor_DL_rear_hub_rear_contact_lean = M_rear_hub_rear_contact_lean
        + M_factor_DL_rear_hub_rear_contact_lean_part
        - M_factor_DL_rear_hub_rear_contact_lean_part_2;
    const real M_factor_D_rear_hub_part_2 = M_steer_rear_contact_spin *
        M_factor_L_steer_rear_contact_spin;
    const real M_factor_D_rear_hub = frame_composite_inertia_yy - M_factor_D_rear_hub_part
        - M_factor_D_rear_hub_part_2;
    const real M_factor_L_steer_rear_contact_lean = M_steer_rear_contact_lean *
        M_factor_D_inverse_steer;
    const real M_factor_DL_rear_contact_lean_rear_contact_yaw_part =
        M_rear_contact_lean_rear_contact_yaw
        - M_front_hub_rear_contact_yaw * M_factor_L_front_hub_rear_contact_lean
        - M_steer_rear_contact_yaw * M_factor_L_steer_rear_contact_lean;
    const real M_factor_L_steer_rear_contact_yaw = M_steer_rear_contact_yaw *
        M_factor_D_inverse_steer;
    const real M_factor_L_steer_rear_contact_y = M_steer_rear_contact_y * M_factor_D_inverse_steer;
    const real M_factor_L_steer_rear_contact_x = M_steer_rear_contact_x * M_factor_D_inverse_steer;
    const real M_factor_D_inverse_rear_hub = 1.0 / M_factor_D_rear_hub;
    const real M_factor_L_rear_hub_rear_contact_spin = M_factor_D_rear_hub *
        M_factor_D_inverse_rear_hub;
    const real M_factor_DL_rear_contact_spin_rear_contact_x = M_factor_DL_rear_hub_rear_contact_x
        - M_factor_DL_rear_hub_rear_contact_x * M_factor_L_rear_hub_rear_contact_spin;
    const real M_factor_DL_rear_contact_spin_rear_contact_y = M_factor_DL_rear_hub_rear_contact_y
        - M_factor_DL_rear_hub_rear_contact_y * M_factor_L_rear_hub_rear_contact_spin;
    const real M_factor_DL_rear_contact_spin_rear_contact_yaw = M_rear_contact_spin_rear_contact_yaw
        + M_factor_DL_rear_hub_rear_contact_yaw_part
        - M_factor_DL_rear_hub_rear_contact_yaw_part_2
        - M_factor_DL_rear_hub_rear_contact_yaw * M_factor_L_rear_hub_rear_contact_spin;
    const real M_factor_DL_rear_contact_spin_rear_contact_lean = momentum_rear_contact_lean_my
        + M_factor_DL_rear_hub_rear_contact_lean_part
        - M_factor_DL_rear_hub_rear_contact_lean_part_2
        - M_factor_DL_rear_hub_rear_contact_lean * M_factor_L_rear_hub_rear_contact_spin;
    const real M_factor_L_rear_hub_rear_contact_lean = M_factor_DL_rear_hub_rear_contact_lean *
        M_factor_D_inverse_rear_hub;
    const real M_factor_DL_rear_contact_lean_rear_contact_x_part =
        M_rear_contact_lean_rear_contact_x
        - M_steer_rear_contact_x * M_factor_L_steer_rear_contact_lean
        - M_factor_DL_rear_hub_rear_contact_x * M_factor_L_rear_hub_rear_contact_lean;
    const real M_factor_DL_rear_contact_lean_rear_contact_y_part =
        M_rear_contact_lean_rear_contact_y
        - M_steer_rear_contact_y * M_factor_L_steer_rear_contact_lean
        - M_factor_DL_rear_hub_rear_contact_y * M_factor_L_rear_hub_rear_contact_lean;
    const real M_factor_D_rear_contact_lean_part = M_rear_contact_lean_rear_contact_lean
        - M_front_hub_rear_contact_lean * M_factor_L_front_hub_rear_contact_lean
        - M_steer_rear_contact_lean * M_factor_L_steer_rear_contact_lean
        - M_factor_DL_rear_hub_rear_contact_lean * M_factor_L_rear_hub_rear_contact_lean;
    const real M_factor_L_rear_hub_rear_contact_yaw = M_factor_DL_rear_hub_rear_contact_yaw *
        M_factor_D_inverse_rear_hub;
    const real M_factor_DL_rear_contact_yaw_rear_contact_x_part = M_rear_contact_yaw_rear_contact_x
        - M_steer_rear_contact_x * M_factor_L_steer_rear_contact_yaw
        - M_factor_DL_rear_hub_rear_contact_x * M_factor_L_rear_hub_rear_contact_yaw;
    const real M_factor_DL_rear_contact_yaw_rear_contact_y_part = M_rear_contact_yaw_rear_contact_y
        - M_steer_rear_contact_y * M_factor_L_steer_rear_contact_yaw
        - M_factor_DL_rear_hub_rear_contact_y * M_factor_L_rear_hub_rear_contact_yaw;
    const real M_factor_D_rear_contact_yaw_part = M_rear_contact_yaw_rear_contact_yaw
        - M_front_hub_rear_contact_yaw * M_factor_L_front_hub_rear_contact_yaw
        - M_steer_rear_contact_yaw * M_factor_L_steer_rear_contact_yaw
        - M_factor_DL_rear_hub_rear_contact_yaw * M_factor_L_rear_hub_rear_contact_yaw;
    const real M_factor_L_rear_hub_rear_contact_y = M_factor_DL_rear_hub_rear_contact_y *
        M_factor_D_inverse_rear_hub;
    const real M_factor_DL_rear_contact_y_rear_contact_x_part = M_rear_contact_y_rear_contact_x
        - M_steer_rear_contact_x * M_factor_L_steer_rear_contact_y
        - M_factor_DL_rear_hub_rear_contact_x * M_factor_L_rear_hub_rear_contact_y;
    const real M_factor_L_rear_hub_rear_contact_x = M_factor_DL_rear_hub_rear_contact_x *
        M_factor_D_inverse_rear_hub;
    const real M_factor_D_inverse_rear_contact_spin = 1.0 / (rear_wheel_composite_inertia_yy
        - M_factor_D_rear_hub_part - M_factor_D_rear_hub_part_2
        - M_factor_D_rear_hub * M_factor_L_rear_hub_rear_contact_spin);
    const real M_factor_L_rear_contact_spin_rear_contact_lean =
        M_factor_DL_rear_contact_spin_rear_contact_lean * M_factor_D_inverse_rear_contact_spin;
    const real M_factor_DL_rear_contact_lean_rear_contact_x =
        M_factor_DL_rear_contact_lean_rear_contact_x_part
        - M_factor_DL_rear_contact_spin_rear_contact_x *
        M_factor_L_rear_contact_spin_rear_contact_lean;
    const real M_factor_DL_rear_contact_lean_rear_contact_y =
        M_factor_DL_rear_contact_lean_rear_contact_y_part
        - M_factor_DL_rear_contact_spin_rear_contact_y *
        M_factor_L_rear_contact_spin_rear_contact_lean;
    const real M_factor_DL_rear_contact_lean_rear_contact_yaw =
        M_factor_DL_rear_contact_lean_rear_contact_yaw_part
        - M_factor_DL_rear_hub_rear_contact_yaw * M_factor_L_rear_hub_rear_contact_lean
        - M_factor_DL_rear_contact_spin_rear_contact_yaw *
        M_factor_L_rear_contact_spin_rear_contact_lean;
    const real M_factor_L_rear_contact_spin_rear_contact_yaw =
        M_factor_DL_rear_contact_spin_rear_contact_yaw * M_factor_D_inverse_rear_contact_spin;
    const real M_factor_L_rear_contact_spin_rear_contact_y =
        M_factor_DL_rear_contact_spin_rear_contact_y * M_factor_D_inverse_rear_contact_spin;
    const real M_factor_D_rear_contact_y_part = M_rear_contact_y_rear_contact_y
        - M_steer_rear_contact_y * M_factor_L_steer_rear_contact_y
        - M_factor_DL_rear_hub_rear_contact_y * M_factor_L_rear_hub_rear_contact_y
        - M_factor_DL_rear_contact_spin_rear_contact_y *
        M_factor_L_rear_contact_spin_rear_contact_y;
    const real M_factor_L_rear_contact_spin_rear_contact_x =
        M_factor_DL_rear_contact_spin_rear_contact_x * M_factor_D_inverse_rear_contact_spin;
    const real M_factor_D_rear_contact_x_part = M_rear_contact_x_rear_contact_x
        - M_steer_rear_contact_x * M_factor_L_steer_rear_contact_x
        - M_factor_DL_rear_hub_rear_contact_x * M_factor_L_rear_hub_rear_contact_x
        - M_factor_DL_rear_contact_spin_rear_contact_x *
        M_factor_L_rear_contact_spin_rear_contact_x;
    const real M_factor_D_inverse_rear_contact_lean = 1.0 / (M_factor_D_rear_contact_lean_part
        - M_factor_DL_rear_contact_spin_rear_contact_lean *
        M_factor_L_rear_contact_spin_rear_contact_lean);
    const real M_factor_L_rear_contact_lean_rear_contact_yaw =
        M_factor_DL_rear_contact_lean_rear_contact_yaw * M_factor_D_inverse_rear_contact_lean;
    const real M_factor_DL_rear_contact_yaw_rear_contact_x =
        M_factor_DL_rear_contact_yaw_rear_contact_x_part
        - M_factor_DL_rear_contact_spin_rear_contact_x *
        M_factor_L_rear_contact_spin_rear_contact_yaw
        - M_factor_DL_rear_contact_lean_rear_contact_x *
        M_factor_L_rear_contact_lean_rear_contact_yaw;
    const real M_factor_DL_rear_contact_yaw_rear_contact_y =
        M_factor_DL_rear_contact_yaw_rear_contact_y_part
        - M_factor_DL_rear_contact_spin_rear_contact_y *
        M_factor_L_rear_contact_spin_rear_contact_yaw
        - M_factor_DL_rear_contact_lean_rear_contact_y *
        M_factor_L_rear_contact_lean_rear_contact_yaw;
    const real M_factor_L_rear_contact_lean_rear_contact_y =
        M_factor_DL_rear_contact_lean_rear_contact_y * M_factor_D_inverse_rear_contact_lean;
    const real M_factor_DL_rear_contact_y_rear_contact_x_part_2 =
        M_factor_DL_rear_contact_y_rear_contact_x_part
        - M_factor_DL_rear_contact_spin_rear_contact_x * M_factor_L_rear_contact_spin_rear_contact_y
        - M_factor_DL_rear_contact_lean_rear_contact_x *
        M_factor_L_rear_contact_lean_rear_contact_y;
    const real M_factor_L_rear_contact_lean_rear_contact_x =
        M_factor_DL_rear_contact_lean_rear_contact_x * M_factor_D_inverse_rear_contact_lean;
    const real M_factor_D_inverse_rear_contact_yaw = 1.0 / (M_factor_D_rear_contact_yaw_part
        - M_factor_DL_rear_contact_spin_rear_contact_yaw *
        M_factor_L_rear_contact_spin_rear_contact_yaw
        - M_factor_DL_rear_contact_lean_rear_contact_yaw *
        M_factor_L_rear_contact_lean_rear_contact_yaw);
    const real M_factor_L_rear_contact_yaw_rear_contact_y =
        M_factor_DL_rear_contact_yaw_rear_contact_y * M_factor_D_inverse_rear_contact_yaw;
    const real M_factor_DL_rear_contact_y_rear_contact_x =
        M_factor_DL_rear_contact_y_rear_contact_x_part_2
        - M_factor_DL_rear_contact_yaw_rear_contact_x * M_factor_L_rear_contact_yaw_rear_contact_y;
    const real M_factor_L_rear_contact_yaw_rear_contact_x =
        M_factor_DL_rear_contact_yaw_rear_contact_x * M_factor_D_inverse_rear_contact_yaw;
    const real M_factor_D_rear_contact_x_part_2 = M_factor_D_rear_contact_x_part
        - M_factor_DL_rear_contact_lean_rear_contact_x * M_factor_L_rear_contact_lean_rear_contact_x
        - M_factor_DL_rear_contact_yaw_rear_contact_x * M_factor_L_rear_contact_yaw_rear_contact_x;
    const real M_factor_D_inverse_rear_contact_y = 1.0 / (M_factor_D_rear_contact_y_part
        - M_factor_DL_rear_contact_lean_rear_contact_y * M_factor_L_rear_contact_lean_rear_contact_y
        - M_factor_DL_rear_contact_yaw_rear_contact_y * M_factor_L_rear_contact_yaw_rear_contact_y);
    const real M_factor_L_rear_contact_y_rear_contact_x = M_factor_DL_rear_contact_y_rear_contact_x
        * M_factor_D_inverse_rear_contact_y;
    const real M_factor_D_inverse_rear_contact_x = 1.0 / (M_factor_D_rear_contact_x_part_2
        - M_factor_DL_rear_contact_y_rear_contact_x * M_factor_L_rear_contact_y_rear_contact_x);
    const real free_y_rear_contact_spin_part = front_hub_drive *
        M_minus_factor_L_front_hub_rear_contact_spin;
    const real steer_drive_times_M_factor_L_steer_rear_contact_spin = steer_drive *
        M_factor_L_steer_rear_contact_spin;
    const real free_y_rear_hub = rear_hub_drive + free_y_rear_contact_spin_part
        - steer_drive_times_M_factor_L_steer_rear_contact_spin;
    const real free_y_rear_contact_lean_part = rear_contact_drive_lean
        - front_hub_drive * M_factor_L_front_hub_rear_contact_lean
        - steer_drive * M_factor_L_steer_rear_contact_lean
        - M_factor_L_rear_hub_rear_contact_lean * free_y_rear_hub;
    const real free_y_rear_contact_spin = rear_contact_drive_spin + free_y_rear_contact_spin_part
        - steer_drive_times_M_factor_L_steer_rear_contact_spin
        - M_factor_L_rear_hub_rear_contact_spin * free_y_rear_hub;
    const real free_y_rear_contact_x_part = rear_contact_drive_x
        - steer_drive * M_factor_L_steer_rear_contact_x
        - M_factor_L_rear_hub_rear_contact_x * free_y_rear_hub
        - M_factor_L_rear_contact_spin_rear_contact_x * free_y_rear_contact_spin;
    const real free_y_rear_contact_y_part = rear_contact_drive_y
        - steer_drive * M_factor_L_steer_rear_contact_y
        - M_factor_L_rear_hub_rear_contact_y * free_y_rear_hub
        - M_factor_L_rear_contact_spin_rear_contact_y * free_y_rear_contact_spin;
    const real free_y_rear_contact_yaw_part = rear_contact_drive_yaw
        - front_hub_drive * M_factor_L_front_hub_rear_contact_yaw
        - steer_drive * M_factor_L_steer_rear_contact_yaw
        - M_factor_L_rear_hub_rear_contact_yaw * free_y_rear_hub
        - M_factor_L_rear_contact_spin_rear_contact_yaw * free_y_rear_contact_spin;
    const real free_y_rear_contact_lean = free_y_rear_contact_lean_part
        - M_factor_L_rear_contact_spin_rear_contact_lean * free_y_rear_contact_spin;
    const real free_y_rear_contact_yaw = free_y_rear_contact_yaw_part
        - M_factor_L_rear_contact_lean_rear_contact_yaw * free_y_rear_contact_lean;
    const real free_y_rear_contact_y = free_y_rear_contact_y_part
        - M_factor_L_rear_contact_lean_rear_contact_y * free_y_rear_contact_lean
        - M_factor_L_rear_contact_yaw_rear_contact_y * free_y_rear_contact_yaw;
    const real free_y_rear_contact_x = free_y_rear_contact_x_part
        - M_factor_L_rear_contact_lean_rear_contact_x * free_y_rear_contact_lean
        - M_factor_L_rear_contact_yaw_rear_contact_x * free_y_rear_contact_yaw
        - M_factor_L_rear_contact_y_rear_contact_x * free_y_rear_contact_y;
    const real free_udot_rear_contact_x = M_factor_D_inverse_rear_contact_x * free_y_rear_contact_x;
    const real free_udot_rear_contact_y = M_factor_D_inverse_rear_contact_y * free_y_rear_contact_y
        - M_factor_L_rear_contact_y_rear_contact_x * free_udot_rear_contact_x;
    const real free_udot_rear_contact_yaw = M_factor_D_inverse_rear_contact_yaw *
        free_y_rear_contact_yaw
        - M_factor_L_rear_contact_yaw_rear_contact_x * free_udot_rear_contact_x
        - M_factor_L_rear_contact_yaw_rear_contact_y * free_udot_rear_contact_y;
    const real free_udot_rear_contact_lean_part = M_factor_D_inverse_rear_contact_lean *
        free_y_rear_contact_lean
        - M_factor_L_rear_contact_lean_rear_contact_x * free_udot_rear_contact_x
        - M_factor_L_rear_contact_lean_rear_contact_y * free_udot_rear_contact_y;
    const real free_udot_rear_contact_lean = free_udot_rear_contact_lean_part
        - M_factor_L_rear_contact_lean_rear_contact_yaw * free_udot_rear_contact_yaw;
    const real free_udot_rear_contact_spin_part = M_factor_D_inverse_rear_contact_spin *
        free_y_rear_contact_spin
        - M_factor_L_rear_contact_spin_rear_contact_x * free_udot_rear_contact_x
        - M_factor_L_rear_contact_spin_rear_contact_y * free_udot_rear_contact_y;
    const real free_udot_rear_contact_spin = free_udot_rear_contact_spin_part
        - M_factor_L_rear_contact_spin_rear_contact_yaw * free_udot_rear_contact_yaw
        - M_factor_L_rear_contact_spin_rear_contact_lean * free_udot_rear_contact_lean;
    const real free_udot_rear_hub_part = M_factor_D_inverse_rear_hub * free_y_rear_hub
        - M_factor_L_rear_hub_rear_contact_x * free_udot_rear_contact_x
        - M_factor_L_rear_hub_rear_contact_y * free_udot_rear_contact_y
        - M_factor_L_rear_hub_rear_contact_yaw * free_udot_rear_contact_yaw;
    const real free_udot_rear_hub = free_udot_rear_hub_part
        - M_factor_L_rear_hub_rear_contact_lean * free_udot_rear_contact_lean
        - M_factor_L_rear_hub_rear_contact_spin * free_udot_rear_contact_spin;
    const real free_udot_steer_part = steer_drive * M_factor_D_inverse_steer
        - M_factor_L_steer_rear_contact_x * free_udot_rear_contact_x
        - M_factor_L_steer_rear_contact_y * free_udot_rear_contact_y
        - M_factor_L_steer_rear_contact_yaw * free_udot_rear_contact_yaw;
    const real free_udot_steer = free_udot_steer_part
        - M_factor_L_steer_rear_contact_lean * free_udot_rear_contact_lean
        - M_factor_L_steer_rear_contact_spin * free_udot_rear_contact_spin
        - M_factor_L_steer_rear_contact_spin * free_udot_rear_hub;
    const real free_udot_front_hub_part = front_hub_drive * M_factor_D_inverse_front_hub
        - M_factor_L_front_hub_rear_contact_yaw * free_udot_rear_contact_yaw
        - M_factor_L_front_hub_rear_contact_lean * free_udot_rear_contact_lean
        + M_minus_factor_L_front_hub_rear_contact_spin * free_udot_rear_contact_spin;
    const real free_udot_front_hub = free_udot_front_hub_part
        + M_minus_factor_L_front_hub_rear_contact_spin * free_udot_rear_hub;
    const real front_contact_pz_y_rear_hub = front_contact_G_pz_rear_contact_spin
        + front_contact_G_pz_front_hub * M_minus_factor_L_front_hub_rear_contact_spin
        - front_contact_G_pz_steer * M_factor_L_steer_rear_contact_spin;
    const real front_contact_pz_y_rear_contact_yaw_part = front_contact_G_pz_rear_contact_yaw
        - front_contact_G_pz_front_hub * M_factor_L_front_hub_rear_contact_yaw
        - front_contact_G_pz_steer * M_factor_L_steer_rear_contact_yaw
        - M_factor_L_rear_hub_rear_contact_yaw * front_contact_pz_y_rear_hub;
    const real front_contact_pz_y_rear_contact_lean_part = front_contact_G_pz_rear_contact_lean
        - front_contact_G_pz_front_hub * M_factor_L_front_hub_rear_contact_lean
        - front_contact_G_pz_steer * M_factor_L_steer_rear_contact_lean
        - M_factor_L_rear_hub_rear_contact_lean * front_contact_pz_y_rear_hub;
    const real front_contact_pz_y_rear_contact_spin = front_contact_pz_y_rear_hub
        - M_factor_L_rear_hub_rear_contact_spin * front_contact_pz_y_rear_hub;
    const real front_contact_pz_y_rear_contact_x_part = front_contact_G_pz_rear_contact_x
        - front_contact_G_pz_steer * M_factor_L_steer_rear_contact_x
        - M_factor_L_rear_hub_rear_contact_x * front_contact_pz_y_rear_hub
        - M_factor_L_rear_contact_spin_rear_contact_x * front_contact_pz_y_rear_contact_spin;
    const real front_contact_pz_y_rear_contact_y_part = front_contact_G_pz_rear_contact_y
        - front_contact_G_pz_steer * M_factor_L_steer_rear_contact_y
        - M_factor_L_rear_hub_rear_contact_y * front_contact_pz_y_rear_hub
        - M_factor_L_rear_contact_spin_rear_contact_y * front_contact_pz_y_rear_contact_spin;
    const real front_contact_pz_y_rear_contact_lean = front_contact_pz_y_rear_contact_lean_part
        - M_factor_L_rear_contact_spin_rear_contact_lean * front_contact_pz_y_rear_contact_spin;
    const real front_contact_pz_y_rear_contact_yaw = front_contact_pz_y_rear_contact_yaw_part
        - M_factor_L_rear_contact_spin_rear_contact_yaw * front_contact_pz_y_rear_contact_spin
        - M_factor_L_rear_contact_lean_rear_contact_yaw * front_contact_pz_y_rear_contact_lean;
    const real front_contact_pz_y_rear_contact_x_part_2 = front_contact_pz_y_rear_contact_x_part
        - M_factor_L_rear_contact_lean_rear_contact_x * front_contact_pz_y_rear_contact_lean
        - M_factor_L_rear_contact_yaw_rear_contact_x * front_contact_pz_y_rear_contact_yaw;
    const real front_contact_pz_y_rear_contact_y = front_contact_pz_y_rear_contact_y_part
        - M_factor_L_rear_contact_lean_rear_contact_y * front_contact_pz_y_rear_contact_lean
        - M_factor_L_rear_contact_yaw_rear_contact_y * front_contact_pz_y_rear_contact_yaw;
    const real front_contact_pz_response_rear_contact_x = M_factor_D_inverse_rear_contact_x *
        (front_contact_pz_y_rear_contact_x_part_2
        - M_factor_L_rear_contact_y_rear_contact_x * front_contact_pz_y_rear_contact_y);
    const real front_contact_pz_response_rear_contact_y = M_factor_D_inverse_rear_contact_y *
        front_contact_pz_y_rear_contact_y
        - M_factor_L_rear_contact_y_rear_contact_x * front_contact_pz_response_rear_contact_x;
    const real front_contact_pz_response_rear_contact_yaw = M_factor_D_inverse_rear_contact_yaw *
        front_contact_pz_y_rear_contact_yaw
        - M_factor_L_rear_contact_yaw_rear_contact_x * front_contact_pz_response_rear_contact_x
        - M_factor_L_rear_contact_yaw_rear_contact_y * front_contact_pz_response_rear_contact_y;
    const real front_contact_pz_response_rear_contact_lean_part =
        M_factor_D_inverse_rear_contact_lean * front_contact_pz_y_rear_contact_lean
        - M_factor_L_rear_contact_lean_rear_contact_x * front_contact_pz_response_rear_contact_x;
    const real front_contact_pz_response_rear_contact_lean =
        front_contact_pz_response_rear_contact_lean_part
        - M_factor_L_rear_contact_lean_rear_contact_y * front_contact_pz_response_rear_contact_y
        - M_factor_L_rear_contact_lean_rear_contact_yaw *
        front_contact_pz_response_rear_contact_yaw;
    const real front_contact_pz_response_rear_contact_spin_part =
        M_factor_D_inverse_rear_contact_spin * front_contact_pz_y_rear_contact_spin
        - M_factor_L_rear_contact_spin_rear_contact_x * front_contact_pz_response_rear_contact_x;
    const real front_contact_pz_response_rear_contact_spin_part_2 =
        front_contact_pz_response_rear_contact_spin_part
        - M_factor_L_rear_contact_spin_rear_contact_y * front_contact_pz_response_rear_contact_y
        - M_factor_L_rear_contact_spin_rear_contact_yaw *
        front_contact_pz_response_rear_contact_yaw;
    const real front_contact_pz_response_rear_contact_spin =
        front_contact_pz_response_rear_contact_spin_part_2
        - M_factor_L_rear_contact_spin_rear_contact_lean *
        front_contact_pz_response_rear_contact_lean;
    const real front_contact_pz_response_rear_hub_part = M_factor_D_inverse_rear_hub *
        front_contact_pz_y_rear_hub
        - M_factor_L_rear_hub_rear_contact_x * front_contact_pz_response_rear_contact_x
        - M_factor_L_rear_hub_rear_contact_y * front_contact_pz_response_rear_contact_y;
    const real front_contact_pz_response_rear_hub_part_2 = front_contact_pz_response_rear_hub_part -
        M_factor_L_rear_hub_rear_contact_yaw * front_contact_pz_response_rear_contact_yaw
        - M_factor_L_rear_hub_rear_contact_lean * front_contact_pz_response_rear_contact_lean;
    const real front_contact_pz_response_rear_hub = front_contact_pz_response_rear_hub_part_2
        - M_factor_L_rear_hub_rear_contact_spin * front_contact_pz_response_rear_contact_spin;
    const real front_contact_pz_response_steer_part = front_contact_G_pz_steer *
        M_factor_D_inverse_steer
        - M_factor_L_steer_rear_contact_x * front_contact_pz_response_rear_contact_x
        - M_factor_L_steer_rear_contact_y * front_contact_pz_response_rear_contact_y;
    const real front_contact_pz_response_steer_part_2 = front_contact_pz_response_steer_part
        - M_factor_L_steer_rear_contact_yaw * front_contact_pz_response_rear_contact_yaw
        - M_factor_L_steer_rear_contact_lean * front_contact_pz_response_rear_contact_lean;
    const real front_contact_pz_response_steer = front_contact_pz_response_steer_part_2
        - M_factor_L_steer_rear_contact_spin * front_contact_pz_response_rear_contact_spin
        - M_factor_L_steer_rear_contact_spin * front_contact_pz_response_rear_hub;
    const real front_contact_pz_response_front_hub_part = front_contact_G_pz_front_hub *
        M_factor_D_inverse_front_hub
        - M_factor_L_front_hub_rear_contact_yaw * front_contact_pz_response_rear_contact_yaw
        - M_factor_L_front_hub_rear_contact_lean * front_contact_pz_response_rear_contact_lean;
    const real front_contact_pz_response_front_hub = front_contact_pz_response_front_hub_part
        + M_minus_factor_L_front_hub_rear_contact_spin * front_contact_pz_response_rear_contact_spin
        + M_minus_factor_L_front_hub_rear_contact_spin * front_contact_pz_response_rear_hub;
    const real front_contact_longitudinal_y_rear_contact_yaw_part =
        front_contact_minus_G_longitudinal_front_hub * M_factor_L_front_hub_rear_contact_yaw
        - front_contact_minus_G_longitudinal_rear_contact_yaw
        + front_contact_minus_G_longitudinal_steer * M_factor_L_steer_rear_contact_yaw;
    const real front_contact_longitudinal_y_rear_contact_lean_part =
        front_contact_minus_G_longitudinal_front_hub * M_factor_L_front_hub_rear_contact_lean
        - front_contact_minus_G_longitudinal_rear_contact_lean
        + front_contact_minus_G_longitudinal_steer * M_factor_L_steer_rear_contact_lean;
    const real front_contact_longitudinal_y_rear_hub = front_contact_minus_G_longitudinal_steer *
        M_factor_L_steer_rear_contact_spin
        - (front_contact_minus_G_longitudinal_rear_contact_spin
        + front_contact_minus_G_longitudinal_front_hub *
        M_minus_factor_L_front_hub_rear_contact_spin);
    const real front_contact_longitudinal_y_rear_contact_x_part =
        front_contact_minus_G_longitudinal_steer * M_factor_L_steer_rear_contact_x
        - front_contact_minus_G_longitudinal_rear_contact_x
        - M_factor_L_rear_hub_rear_contact_x * front_contact_longitudinal_y_rear_hub;
    const real front_contact_longitudinal_y_rear_contact_y_part =
        front_contact_minus_G_longitudinal_steer * M_factor_L_steer_rear_contact_y
        - front_contact_minus_G_longitudinal_rear_contact_y
        - M_factor_L_rear_hub_rear_contact_y * front_contact_longitudinal_y_rear_hub;
    const real front_contact_longitudinal_y_rear_contact_spin =
        front_contact_longitudinal_y_rear_hub
        - M_factor_L_rear_hub_rear_contact_spin * front_contact_longitudinal_y_rear_hub;
    const real front_contact_longitudinal_y_rear_contact_yaw_part_2 =
        front_contact_longitudinal_y_rear_contact_yaw_part
        - M_factor_L_rear_hub_rear_contact_yaw * front_contact_longitudinal_y_rear_hub
        - M_factor_L_rear_contact_spin_rear_contact_yaw *
        front_contact_longitudinal_y_rear_contact_spin;
    const real front_contact_longitudinal_y_rear_contact_lean =
        front_contact_longitudinal_y_rear_contact_lean_part
        - M_factor_L_rear_hub_rear_contact_lean * front_contact_longitudinal_y_rear_hub
        - M_factor_L_rear_contact_spin_rear_contact_lean *
        front_contact_longitudinal_y_rear_contact_spin;
    const real front_contact_longitudinal_y_rear_contact_x_part_2 =
        front_contact_longitudinal_y_rear_contact_x_part
        - M_factor_L_rear_contact_spin_rear_contact_x *
        front_contact_longitudinal_y_rear_contact_spin
        - M_factor_L_rear_contact_lean_rear_contact_x *
        front_contact_longitudinal_y_rear_contact_lean;
    const real front_contact_longitudinal_y_rear_contact_y_part_2 =
        front_contact_longitudinal_y_rear_contact_y_part
        - M_factor_L_rear_contact_spin_rear_contact_y *
        front_contact_longitudinal_y_rear_contact_spin
        - M_factor_L_rear_contact_lean_rear_contact_y *
        front_contact_longitudinal_y_rear_contact_lean;
    const real front_contact_longitudinal_y_rear_contact_yaw =
        front_contact_longitudinal_y_rear_contact_yaw_part_2
        - M_factor_L_rear_contact_lean_rear_contact_yaw *
        front_contact_longitudinal_y_rear_contact_lean;
    const real front_contact_longitudinal_y_rear_contact_y =
        front_contact_longitudinal_y_rear_contact_y_part_2
        - M_factor_L_rear_contact_yaw_rear_contact_y *
        front_contact_longitudinal_y_rear_contact_yaw;
    const real front_contact_longitudinal_y_rear_contact_x =
        front_contact_longitudinal_y_rear_contact_x_part_2
        - M_factor_L_rear_contact_yaw_rear_contact_x * front_contact_longitudinal_y_rear_contact_yaw
        - M_factor_L_rear_contact_y_rear_contact_x * front_contact_longitudinal_y_rear_contact_y;
    const real front_contact_longitudinal_response_rear_contact_x =
        M_factor_D_inverse_rear_contact_x * front_contact_longitudinal_y_rear_contact_x;
    const real front_contact_longitudinal_response_rear_contact_y =
        M_factor_D_inverse_rear_contact_y * front_contact_longitudinal_y_rear_contact_y
        - M_factor_L_rear_contact_y_rear_contact_x *
        front_contact_longitudinal_response_rear_contact_x;
    const real front_contact_longitudinal_response_rear_contact_yaw_part =
        M_factor_D_inverse_rear_contact_yaw * front_contact_longitudinal_y_rear_contact_yaw
        - M_factor_L_rear_contact_yaw_rear_contact_x *
        front_contact_longitudinal_response_rear_contact_x;
    const real front_contact_longitudinal_response_rear_contact_yaw =
        front_contact_longitudinal_response_rear_contact_yaw_part
        - M_factor_L_rear_contact_yaw_rear_contact_y *
        front_contact_longitudinal_response_rear_contact_y;
    const real front_contact_longitudinal_response_rear_contact_lean_part =
        M_factor_D_inverse_rear_contact_lean * front_contact_longitudinal_y_rear_contact_lean
        - M_factor_L_rear_contact_lean_rear_contact_x *
        front_contact_longitudinal_response_rear_contact_x;
    const real front_contact_longitudinal_response_rear_contact_lean_part_2 =
        front_contact_longitudinal_response_rear_contact_lean_part
        - M_factor_L_rear_contact_lean_rear_contact_y *
        front_contact_longitudinal_response_rear_contact_y;
    const real front_contact_longitudinal_response_rear_contact_lean =
        front_contact_longitudinal_response_rear_contact_lean_part_2
        - M_factor_L_rear_contact_lean_rear_contact_yaw *
        front_contact_longitudinal_response_rear_contact_yaw;
    const real front_contact_longitudinal_response_rear_contact_spin_part =
        M_factor_D_inverse_rear_contact_spin * front_contact_longitudinal_y_rear_contact_spin
        - M_factor_L_rear_contact_spin_rear_contact_x *
        front_contact_longitudinal_response_rear_contact_x;
    const real front_contact_longitudinal_response_rear_contact_spin_part_2 =
        front_contact_longitudinal_response_rear_contact_spin_part
        - M_factor_L_rear_contact_spin_rear_contact_y *
        front_contact_longitudinal_response_rear_contact_y;
    const real front_contact_longitudinal_response_rear_contact_spin_part_3 =
        front_contact_longitudinal_response_rear_contact_spin_part_2
        - M_factor_L_rear_contact_spin_rear_contact_yaw *
        front_contact_longitudinal_response_rear_contact_yaw;
    const real front_contact_longitudinal_response_rear_contact_spin =
        front_contact_longitudinal_response_rear_contact_spin_part_3
        - M_factor_L_rear_contact_spin_rear_contact_lean *
        front_contact_longitudinal_response_rear_contact_lean;
    const real front_contact_longitudinal_response_rear_hub_part = M_factor_D_inverse_rear_hub *
        front_contact_longitudinal_y_rear_hub
        - M_factor_L_rear_hub_rear_contact_x * front_contact_longitudinal_response_rear_contact_x
        - M_factor_L_rear_hub_rear_contact_y * front_contact_longitudinal_response_rear_contact_y;
    const real front_contact_longitudinal_response_rear_hub_part_2 =
        front_contact_longitudinal_response_rear_hub_part
        - M_factor_L_rear_hub_rear_contact_yaw *
        front_contact_longitudinal_response_rear_contact_yaw
        - M_factor_L_rear_hub_rear_contact_lean *
        front_contact_longitudinal_response_rear_contact_lean;
    const real front_contact_longitudinal_response_rear_hub =
        front_contact_longitudinal_response_rear_hub_part_2
        - M_factor_L_rear_hub_rear_contact_spin *
        front_contact_longitudinal_response_rear_contact_spin;
    const real front_contact_longitudinal_minus_response_steer_part =
        front_contact_minus_G_longitudinal_steer * M_factor_D_inverse_steer
        + M_factor_L_steer_rear_contact_x * front_contact_longitudinal_response_rear_contact_x
        + M_factor_L_steer_rear_contact_y * front_contact_longitudinal_response_rear_contact_y;
    const real front_contact_longitudinal_minus_response_steer_part_2 =
        front_contact_longitudinal_minus_response_steer_part
        + M_factor_L_steer_rear_contact_yaw * front_contact_longitudinal_response_rear_contact_yaw +
        M_factor_L_steer_rear_contact_lean * front_contact_longitudinal_response_rear_contact_lean;
    const real front_contact_longitudinal_minus_response_steer =
        front_contact_longitudinal_minus_response_steer_part_2
        + M_factor_L_steer_rear_contact_spin * front_contact_longitudinal_response_rear_contact_spin
        + M_factor_L_steer_rear_contact_spin * front_contact_longitudinal_response_rear_hub;
    const real front_contact_longitudinal_response_front_hub_part =
        front_contact_minus_G_longitudinal_front_hub * M_factor_D_inverse_front_hub
        + M_factor_L_front_hub_rear_contact_yaw *
        front_contact_longitudinal_response_rear_contact_yaw;
    const real front_contact_longitudinal_response_front_hub_part_2 =
        M_minus_factor_L_front_hub_rear_contact_spin *
        front_contact_longitudinal_response_rear_contact_spin
        - (front_contact_longitudinal_response_front_hub_part
        + M_factor_L_front_hub_rear_contact_lean *
        front_contact_longitudinal_response_rear_contact_lean);
    const real front_contact_longitudinal_response_front_hub =
        front_contact_longitudinal_response_front_hub_part_2
        + M_minus_factor_L_front_hub_rear_contact_spin *
        front_contact_longitudinal_response_rear_hub;
    const real front_contact_lateral_y_rear_contact_yaw_part =
        front_contact_G_lateral_rear_contact_yaw
        - front_contact_G_lateral_front_hub * M_factor_L_front_hub_rear_contact_yaw
        - front_contact_G_lateral_steer * M_factor_L_steer_rear_contact_yaw;
    const real front_contact_lateral_y_rear_contact_lean_part =
        front_contact_G_lateral_rear_contact_lean
        - front_contact_G_lateral_front_hub * M_factor_L_front_hub_rear_contact_lean
        - front_contact_G_lateral_steer * M_factor_L_steer_rear_contact_lean;
    const real front_contact_lateral_y_rear_hub = front_contact_G_lateral_rear_contact_spin
        + front_contact_G_lateral_front_hub * M_minus_factor_L_front_hub_rear_contact_spin
        - front_contact_G_lateral_steer * M_factor_L_steer_rear_contact_spin;
    const real front_contact_lateral_y_rear_contact_x_part = front_contact_G_lateral_rear_contact_x
        - front_contact_G_lateral_steer * M_factor_L_steer_rear_contact_x
        - M_factor_L_rear_hub_rear_contact_x * front_contact_lateral_y_rear_hub;
    const real front_contact_lateral_y_rear_contact_y_part = front_contact_G_lateral_rear_contact_y
        - front_contact_G_lateral_steer * M_factor_L_steer_rear_contact_y
        - M_factor_L_rear_hub_rear_contact_y * front_contact_lateral_y_rear_hub;
    const real front_contact_lateral_y_rear_contact_spin = front_contact_lateral_y_rear_hub
        - M_factor_L_rear_hub_rear_contact_spin * front_contact_lateral_y_rear_hub;
    const real front_contact_lateral_y_rear_contact_yaw_part_2 =
        front_contact_lateral_y_rear_contact_yaw_part
        - M_factor_L_rear_hub_rear_contact_yaw * front_contact_lateral_y_rear_hub
        - M_factor_L_rear_contact_spin_rear_contact_yaw * front_contact_lateral_y_rear_contact_spin;
    const real front_contact_lateral_y_rear_contact_lean =
        front_contact_lateral_y_rear_contact_lean_part
        - M_factor_L_rear_hub_rear_contact_lean * front_contact_lateral_y_rear_hub
        - M_factor_L_rear_contact_spin_rear_contact_lean *
        front_contact_lateral_y_rear_contact_spin;
    const real front_contact_lateral_y_rear_contact_x_part_2 =
        front_contact_lateral_y_rear_contact_x_part
        - M_factor_L_rear_contact_spin_rear_contact_x * front_contact_lateral_y_rear_contact_spin
        - M_factor_L_rear_contact_lean_rear_contact_x * front_contact_lateral_y_rear_contact_lean;
    const real front_contact_lateral_y_rear_contact_y_part_2 =
        front_contact_lateral_y_rear_contact_y_part
        - M_factor_L_rear_contact_spin_rear_contact_y * front_contact_lateral_y_rear_contact_spin
        - M_factor_L_rear_contact_lean_rear_contact_y * front_contact_lateral_y_rear_contact_lean;
    const real front_contact_lateral_y_rear_contact_yaw =
        front_contact_lateral_y_rear_contact_yaw_part_2
        - M_factor_L_rear_contact_lean_rear_contact_yaw * front_contact_lateral_y_rear_contact_lean;
    const real front_contact_lateral_y_rear_contact_y =
        front_contact_lateral_y_rear_contact_y_part_2
        - M_factor_L_rear_contact_yaw_rear_contact_y * front_contact_lateral_y_rear_contact_yaw;
    const real front_contact_lateral_response_rear_contact_x = M_factor_D_inverse_rear_contact_x *
        (front_contact_lateral_y_rear_contact_x_part_2
        - M_factor_L_rear_contact_yaw_rear_contact_x * front_contact_lateral_y_rear_contact_yaw
        - M_factor_L_rear_contact_y_rear_contact_x * front_contact_lateral_y_rear_contact_y);
    const real front_contact_lateral_response_rear_contact_y = M_factor_D_inverse_rear_contact_y *
        front_contact_lateral_y_rear_contact_y
        - M_factor_L_rear_contact_y_rear_contact_x * front_contact_lateral_response_rear_contact_x;
    const real front_contact_lateral_response_rear_contact_yaw_part =
        M_factor_D_inverse_rear_contact_yaw * front_contact_lateral_y_rear_contact_yaw
        - M_factor_L_rear_contact_yaw_rear_contact_x *
        front_contact_lateral_response_rear_contact_x;
    const real front_contact_lateral_response_rear_contact_yaw =
        front_contact_lateral_response_rear_contact_yaw_part
        - M_factor_L_rear_contact_yaw_rear_contact_y *
        front_contact_lateral_response_rear_contact_y;
    const real front_contact_lateral_response_rear_contact_lean_part =
        M_factor_D_inverse_rear_contact_lean * front_contact_lateral_y_rear_contact_lean
        - M_factor_L_rear_contact_lean_rear_contact_x *
        front_contact_lateral_response_rear_contact_x;
    const real front_contact_lateral_response_rear_contact_lean =
        front_contact_lateral_response_rear_contact_lean_part
        - M_factor_L_rear_contact_lean_rear_contact_y *
        front_contact_lateral_response_rear_contact_y
        - M_factor_L_rear_contact_lean_rear_contact_yaw *
        front_contact_lateral_response_rear_contact_yaw;
    const real front_contact_lateral_response_rear_contact_spin_part =
        M_factor_D_inverse_rear_contact_spin * front_contact_lateral_y_rear_contact_spin
        - M_factor_L_rear_contact_spin_rear_contact_x *
        front_contact_lateral_response_rear_contact_x;
    const real front_contact_lateral_response_rear_contact_spin_part_2 =
        front_contact_lateral_response_rear_contact_spin_part
        - M_factor_L_rear_contact_spin_rear_contact_y *
        front_contact_lateral_response_rear_contact_y
        - M_factor_L_rear_contact_spin_rear_contact_yaw *
        front_contact_lateral_response_rear_contact_yaw;
    const real front_contact_lateral_response_rear_contact_spin =
        front_contact_lateral_response_rear_contact_spin_part_2
        - M_factor_L_rear_contact_spin_rear_contact_lean *
        front_contact_lateral_response_rear_contact_lean;
    const real front_contact_lateral_response_rear_hub_part = M_factor_D_inverse_rear_hub *
        front_contact_lateral_y_rear_hub
        - M_factor_L_rear_hub_rear_contact_x * front_contact_lateral_response_rear_contact_x
        - M_factor_L_rear_hub_rear_contact_y * front_contact_lateral_response_rear_contact_y;
    const real front_contact_lateral_response_rear_hub_part_2 =
        front_contact_lateral_response_rear_hub_part
        - M_factor_L_rear_hub_rear_contact_yaw * front_contact_lateral_response_rear_contact_yaw
        - M_factor_L_rear_hub_rear_contact_lean * front_contact_lateral_response_rear_contact_lean;
    const real front_contact_lateral_response_rear_hub =
        front_contact_lateral_response_rear_hub_part_2
        - M_factor_L_rear_hub_rear_contact_spin * front_contact_lateral_response_rear_contact_spin;
    const real front_contact_lateral_response_steer_part = front_contact_G_lateral_steer *
        M_factor_D_inverse_steer
        - M_factor_L_steer_rear_contact_x * front_contact_lateral_response_rear_contact_x
        - M_factor_L_steer_rear_contact_y * front_contact_lateral_response_rear_contact_y;
    const real front_contact_lateral_response_steer_part_2 =
        front_contact_lateral_response_steer_part
        - M_factor_L_steer_rear_contact_yaw * front_contact_lateral_response_rear_contact_yaw
        - M_factor_L_steer_rear_contact_lean * front_contact_lateral_response_rear_contact_lean;
    const real front_contact_lateral_response_steer = front_contact_lateral_response_steer_part_2
        - M_factor_L_steer_rear_contact_spin * front_contact_lateral_response_rear_contact_spin
        - M_factor_L_steer_rear_contact_spin * front_contact_lateral_response_rear_hub;
    const real front_contact_lateral_response_front_hub_part = front_contact_G_lateral_front_hub *
        M_factor_D_inverse_front_hub
        - M_factor_L_front_hub_rear_contact_yaw * front_contact_lateral_response_rear_contact_yaw
        - M_factor_L_front_hub_rear_contact_lean * front_contact_lateral_response_rear_contact_lean;
    const real front_contact_lateral_response_front_hub =
        front_contact_lateral_response_front_hub_part
        + M_minus_factor_L_front_hub_rear_contact_spin *
        front_contact_lateral_response_rear_contact_spin
        + M_minus_factor_L_front_hub_rear_contact_spin * front_contact_lateral_response_rear_hub;
    const real rear_contact_longitudinal_y_rear_contact_lean = rear_radius *
        M_factor_L_rear_contact_spin_rear_contact_lean;
    const real rear_contact_longitudinal_y_rear_contact_x_part = rear_contact_yaw_cos
        + rear_radius * M_factor_L_rear_contact_spin_rear_contact_x
        - M_factor_L_rear_contact_lean_rear_contact_x *
        rear_contact_longitudinal_y_rear_contact_lean;
    const real rear_contact_longitudinal_y_rear_contact_y_part = rear_contact_yaw_sin
        + rear_radius * M_factor_L_rear_contact_spin_rear_contact_y
        - M_factor_L_rear_contact_lean_rear_contact_y *
        rear_contact_longitudinal_y_rear_contact_lean;
    const real rear_contact_longitudinal_y_rear_contact_yaw = rear_radius *
        M_factor_L_rear_contact_spin_rear_contact_yaw
        - M_factor_L_rear_contact_lean_rear_contact_yaw *
        rear_contact_longitudinal_y_rear_contact_lean;
    const real rear_contact_longitudinal_y_rear_contact_y =
        rear_contact_longitudinal_y_rear_contact_y_part
        - M_factor_L_rear_contact_yaw_rear_contact_y * rear_contact_longitudinal_y_rear_contact_yaw;
    const real rear_contact_longitudinal_y_rear_contact_x =
        rear_contact_longitudinal_y_rear_contact_x_part
        - M_factor_L_rear_contact_yaw_rear_contact_x * rear_contact_longitudinal_y_rear_contact_yaw
        - M_factor_L_rear_contact_y_rear_contact_x * rear_contact_longitudinal_y_rear_contact_y;
    const real rear_contact_longitudinal_response_rear_contact_x = M_factor_D_inverse_rear_contact_x
        * rear_contact_longitudinal_y_rear_contact_x;
    const real rear_contact_longitudinal_response_rear_contact_y = M_factor_D_inverse_rear_contact_y
        * rear_contact_longitudinal_y_rear_contact_y
        - M_factor_L_rear_contact_y_rear_contact_x *
        rear_contact_longitudinal_response_rear_contact_x;
    const real rear_contact_longitudinal_response_rear_contact_yaw_part =
        M_factor_D_inverse_rear_contact_yaw * rear_contact_longitudinal_y_rear_contact_yaw
        - M_factor_L_rear_contact_yaw_rear_contact_x *
        rear_contact_longitudinal_response_rear_contact_x;
    const real rear_contact_longitudinal_response_rear_contact_yaw =
        rear_contact_longitudinal_response_rear_contact_yaw_part
        - M_factor_L_rear_contact_yaw_rear_contact_y *
        rear_contact_longitudinal_response_rear_contact_y;
    const real rear_contact_longitudinal_response_rear_contact_lean_part =
        M_factor_D_inverse_rear_contact_lean * rear_contact_longitudinal_y_rear_contact_lean
        - M_factor_L_rear_contact_lean_rear_contact_x *
        rear_contact_longitudinal_response_rear_contact_x;
    const real rear_contact_longitudinal_response_rear_contact_lean_part_2 =
        rear_contact_longitudinal_response_rear_contact_lean_part
        - M_factor_L_rear_contact_lean_rear_contact_y *
        rear_contact_longitudinal_response_rear_contact_y;
    const real rear_contact_longitudinal_response_rear_contact_lean =
        rear_contact_longitudinal_response_rear_contact_lean_part_2
        - M_factor_L_rear_contact_lean_rear_contact_yaw *
        rear_contact_longitudinal_response_rear_contact_yaw;
    const real rear_contact_longitudinal_minus_response_rear_contact_spin_part = rear_radius *
        M_factor_D_inverse_rear_contact_spin
        + M_factor_L_rear_contact_spin_rear_contact_x *
        rear_contact_longitudinal_response_rear_contact_x;
    const real rear_contact_longitudinal_minus_response_rear_contact_spin_part_2 =
        rear_contact_longitudinal_minus_response_rear_contact_spin_part
        + M_factor_L_rear_contact_spin_rear_contact_y *
        rear_contact_longitudinal_response_rear_contact_y;
    const real rear_contact_longitudinal_minus_response_rear_contact_spin_part_3 =
        rear_contact_longitudinal_minus_response_rear_contact_spin_part_2
        + M_factor_L_rear_contact_spin_rear_contact_yaw *
        rear_contact_longitudinal_response_rear_contact_yaw;
    const real rear_contact_longitudinal_minus_response_rear_contact_spin =
        rear_contact_longitudinal_minus_response_rear_contact_spin_part_3
        + M_factor_L_rear_contact_spin_rear_contact_lean *
        rear_contact_longitudinal_response_rear_contact_lean;
    const real rear_contact_longitudinal_response_rear_hub_part = M_factor_L_rear_hub_rear_contact_x
        * rear_contact_longitudinal_response_rear_contact_x
        + M_factor_L_rear_hub_rear_contact_y * rear_contact_longitudinal_response_rear_contact_y;
    const real rear_contact_longitudinal_response_rear_hub_part_2 =
        rear_contact_longitudinal_response_rear_hub_part
        + M_factor_L_rear_hub_rear_contact_yaw * rear_contact_longitudinal_response_rear_contact_yaw
        + M_factor_L_rear_hub_rear_contact_lean *
        rear_contact_longitudinal_response_rear_contact_lean;
    const real rear_contact_longitudinal_response_rear_hub = M_factor_L_rear_hub_rear_contact_spin *
        rear_contact_longitudinal_minus_response_rear_contact_spin
        - rear_contact_longitudinal_response_rear_hub_part_2;
    const real rear_contact_longitudinal_response_steer_part = M_factor_L_steer_rear_contact_x *
        rear_contact_longitudinal_response_rear_contact_x
        + M_factor_L_steer_rear_contact_y * rear_contact_longitudinal_response_rear_contact_y;
    const real rear_contact_longitudinal_response_steer_part_2 =
        rear_contact_longitudinal_response_steer_part
        + M_factor_L_steer_rear_contact_yaw * rear_contact_longitudinal_response_rear_contact_yaw
        + M_factor_L_steer_rear_contact_lean * rear_contact_longitudinal_response_rear_contact_lean;
    const real rear_contact_longitudinal_response_front_hub_part =
        M_factor_L_front_hub_rear_contact_yaw * rear_contact_longitudinal_response_rear_contact_yaw
        + M_factor_L_front_hub_rear_contact_lean *
        rear_contact_longitudinal_response_rear_contact_lean;
    const real rear_contact_longitudinal_response_front_hub =
        M_minus_factor_L_front_hub_rear_contact_spin * rear_contact_longitudinal_response_rear_hub -
        (rear_contact_longitudinal_response_front_hub_part
        + M_minus_factor_L_front_hub_rear_contact_spin *
        rear_contact_longitudinal_minus_response_rear_contact_spin);
    const real rear_contact_lateral_minus_response_rear_contact_x =
        M_factor_D_inverse_rear_contact_x * (rear_contact_yaw_sin
        + rear_contact_yaw_cos * M_factor_L_rear_contact_y_rear_contact_x);
    const real rear_contact_lateral_response_rear_contact_y = rear_contact_yaw_cos *
        M_factor_D_inverse_rear_contact_y
        + M_factor_L_rear_contact_y_rear_contact_x *
        rear_contact_lateral_minus_response_rear_contact_x;
    const real rear_contact_lateral_response_rear_contact_yaw =
        M_factor_L_rear_contact_yaw_rear_contact_x *
        rear_contact_lateral_minus_response_rear_contact_x
        - M_factor_L_rear_contact_yaw_rear_contact_y * rear_contact_lateral_response_rear_contact_y;
    const real rear_contact_lateral_response_rear_contact_lean_part =
        M_factor_L_rear_contact_lean_rear_contact_x *
        rear_contact_lateral_minus_response_rear_contact_x
        - M_factor_L_rear_contact_lean_rear_contact_y *
        rear_contact_lateral_response_rear_contact_y;
    const real rear_contact_lateral_response_rear_contact_lean =
        rear_contact_lateral_response_rear_contact_lean_part
        - M_factor_L_rear_contact_lean_rear_contact_yaw *
        rear_contact_lateral_response_rear_contact_yaw;
    const real rear_contact_lateral_response_rear_contact_spin_part =
        M_factor_L_rear_contact_spin_rear_contact_x *
        rear_contact_lateral_minus_response_rear_contact_x
        - M_factor_L_rear_contact_spin_rear_contact_y *
        rear_contact_lateral_response_rear_contact_y;
    const real rear_contact_lateral_response_rear_contact_spin =
        rear_contact_lateral_response_rear_contact_spin_part
        - M_factor_L_rear_contact_spin_rear_contact_yaw *
        rear_contact_lateral_response_rear_contact_yaw
        - M_factor_L_rear_contact_spin_rear_contact_lean *
        rear_contact_lateral_response_rear_contact_lean;
    const real rear_contact_lateral_response_rear_hub_part = M_factor_L_rear_hub_rear_contact_x *
        rear_contact_lateral_minus_response_rear_contact_x
        - M_factor_L_rear_hub_rear_contact_y * rear_contact_lateral_response_rear_contact_y;
    const real rear_contact_lateral_response_rear_hub_part_2 =
        rear_contact_lateral_response_rear_hub_part
        - M_factor_L_rear_hub_rear_contact_yaw * rear_contact_lateral_response_rear_contact_yaw
        - M_factor_L_rear_hub_rear_contact_lean * rear_contact_lateral_response_rear_contact_lean;
    const real rear_contact_lateral_response_rear_hub =
        rear_contact_lateral_response_rear_hub_part_2
        - M_factor_L_rear_hub_rear_contact_spin * rear_contact_lateral_response_rear_contact_spin;
    const real rear_contact_lateral_response_steer_part = M_factor_L_steer_rear_contact_x *
        rear_contact_lateral_minus_response_rear_contact_x
        - M_factor_L_steer_rear_contact_y * rear_contact_lateral_response_rear_contact_y
        - M_factor_L_steer_rear_contact_yaw * rear_contact_lateral_response_rear_contact_yaw;
    const real rear_contact_lateral_response_steer_part_2 = rear_contact_lateral_response_steer_part
        - M_factor_L_steer_rear_contact_lean * rear_contact_lateral_response_rear_contact_lean
        - M_factor_L_steer_rear_contact_spin * rear_contact_lateral_response_rear_contact_spin;
    const real rear_contact_lateral_response_front_hub_part = M_factor_L_front_hub_rear_contact_yaw
        * rear_contact_lateral_response_rear_contact_yaw
        + M_factor_L_front_hub_rear_contact_lean * rear_contact_lateral_response_rear_contact_lean;
    const real circuit_front_contact_pz_front_contact_pz_part = front_contact_G_pz_rear_contact_x *
        front_contact_pz_response_rear_contact_x
        + front_contact_G_pz_rear_contact_y * front_contact_pz_response_rear_contact_y
        + front_contact_G_pz_rear_contact_yaw * front_contact_pz_response_rear_contact_yaw;
    const real circuit_front_contact_pz_front_contact_pz_part_2 =
        circuit_front_contact_pz_front_contact_pz_part
        + front_contact_G_pz_rear_contact_lean * front_contact_pz_response_rear_contact_lean
        + front_contact_G_pz_rear_contact_spin * front_contact_pz_response_rear_contact_spin;
    const real circuit_front_contact_pz_front_contact_pz =
        circuit_front_contact_pz_front_contact_pz_part_2
        + front_contact_G_pz_rear_contact_spin * front_contact_pz_response_rear_hub
        + front_contact_G_pz_steer * front_contact_pz_response_steer
        + front_contact_G_pz_front_hub * front_contact_pz_response_front_hub;
    circuit_matrix[0][0] = circuit_front_contact_pz_front_contact_pz;
    const real circuit_minus_front_contact_longitudinal_front_contact_pz_part =
        front_contact_minus_G_longitudinal_rear_contact_x * front_contact_pz_response_rear_contact_x
        + front_contact_minus_G_longitudinal_rear_contact_y *
        front_contact_pz_response_rear_contact_y;
    const real circuit_minus_front_contact_longitudinal_front_contact_pz_part_2 =
        circuit_minus_front_contact_longitudinal_front_contact_pz_part
        + front_contact_minus_G_longitudinal_rear_contact_yaw *
        front_contact_pz_response_rear_contact_yaw;
    const real circuit_minus_front_contact_longitudinal_front_contact_pz_part_3 =
        circuit_minus_front_contact_longitudinal_front_contact_pz_part_2
        + front_contact_minus_G_longitudinal_rear_contact_lean *
        front_contact_pz_response_rear_contact_lean;
    const real circuit_minus_front_contact_longitudinal_front_contact_pz_part_4 =
        circuit_minus_front_contact_longitudinal_front_contact_pz_part_3
        + front_contact_minus_G_longitudinal_rear_contact_spin *
        front_contact_pz_response_rear_contact_spin;
    const real circuit_minus_front_contact_longitudinal_front_contact_pz_part_5 =
        circuit_minus_front_contact_longitudinal_front_contact_pz_part_4
        + front_contact_minus_G_longitudinal_rear_contact_spin * front_contact_pz_response_rear_hub
        + front_contact_minus_G_longitudinal_steer * front_contact_pz_response_steer;
    const real circuit_front_contact_longitudinal_front_contact_pz =
        -(circuit_minus_front_contact_longitudinal_front_contact_pz_part_5
        + front_contact_minus_G_longitudinal_front_hub * front_contact_pz_response_front_hub);
    circuit_matrix[0][1] = circuit_front_contact_longitudinal_front_contact_pz;
    circuit_matrix[1][0] = circuit_front_contact_longitudinal_front_contact_pz;
    const real circuit_minus_front_contact_longitudinal_front_contact_longitud_part =
        front_contact_minus_G_longitudinal_rear_contact_x *
        front_contact_longitudinal_response_rear_contact_x
        + front_contact_minus_G_longitudinal_rear_contact_y *
        front_contact_longitudinal_response_rear_contact_y;
    const real circuit_minus_front_contact_longitudinal_front_contact_longitud_part_2 =
        circuit_minus_front_contact_longitudinal_front_contact_longitud_part
        + front_contact_minus_G_longitudinal_rear_contact_yaw *
        front_contact_longitudinal_response_rear_contact_yaw;
    const real circuit_minus_front_contact_longitudinal_front_contact_longitud_part_3 =
        circuit_minus_front_contact_longitudinal_front_contact_longitud_part_2
        + front_contact_minus_G_longitudinal_rear_contact_lean *
        front_contact_longitudinal_response_rear_contact_lean;
    const real circuit_minus_front_contact_longitudinal_front_contact_longitud_part_4 =
        circuit_minus_front_contact_longitudinal_front_contact_longitud_part_3
        + front_contact_minus_G_longitudinal_rear_contact_spin *
        front_contact_longitudinal_response_rear_contact_spin;
    const real circuit_minus_front_contact_longitudinal_front_contact_longitud_part_5 =
        circuit_minus_front_contact_longitudinal_front_contact_longitud_part_4
        + front_contact_minus_G_longitudinal_rear_contact_spin *
        front_contact_longitudinal_response_rear_hub;
    const real circuit_minus_front_contact_longitudinal_front_contact_longitud_part_6 =
        circuit_minus_front_contact_longitudinal_front_contact_longitud_part_5
        - front_contact_minus_G_longitudinal_steer *
        front_contact_longitudinal_minus_response_steer;
    const real circuit_front_contact_longitudinal_front_contact_longitudinal =
        -(circuit_minus_front_contact_longitudinal_front_contact_longitud_part_6
        + front_contact_minus_G_longitudinal_front_hub *
        front_contact_longitudinal_response_front_hub);
    circuit_matrix[1][1] = circuit_front_contact_longitudinal_front_contact_longitudinal;
    const real circuit_front_contact_lateral_front_contact_pz_part =
        front_contact_G_lateral_rear_contact_x * front_contact_pz_response_rear_contact_x
        + front_contact_G_lateral_rear_contact_y * front_contact_pz_response_rear_contact_y;
    const real circuit_front_contact_lateral_front_contact_pz_part_2 =
        circuit_front_contact_lateral_front_contact_pz_part
        + front_contact_G_lateral_rear_contact_yaw * front_contact_pz_response_rear_contact_yaw
        + front_contact_G_lateral_rear_contact_lean * front_contact_pz_response_rear_contact_lean;
    const real circuit_front_contact_lateral_front_contact_pz_part_3 =
        circuit_front_contact_lateral_front_contact_pz_part_2
        + front_contact_G_lateral_rear_contact_spin * front_contact_pz_response_rear_contact_spin
        + front_contact_G_lateral_rear_contact_spin * front_contact_pz_response_rear_hub;
    const real circuit_front_contact_lateral_front_contact_pz =
        circuit_front_contact_lateral_front_contact_pz_part_3
        + front_contact_G_lateral_steer * front_contact_pz_response_steer
        + front_contact_G_lateral_front_hub * front_contact_pz_response_front_hub;
    circuit_matrix[0][2] = circuit_front_contact_lateral_front_contact_pz;
    circuit_matrix[2][0] = circuit_front_contact_lateral_front_contact_pz;
    const real circuit_front_contact_lateral_front_contact_longitudinal_part =
        front_contact_G_lateral_rear_contact_x * front_contact_longitudinal_response_rear_contact_x
        + front_contact_G_lateral_rear_contact_y *
        front_contact_longitudinal_response_rear_contact_y;
    const real circuit_front_contact_lateral_front_contact_longitudinal_part_2 =
        circuit_front_contact_lateral_front_contact_longitudinal_part
        + front_contact_G_lateral_rear_contact_yaw *
        front_contact_longitudinal_response_rear_contact_yaw;
    const real circuit_front_contact_lateral_front_contact_longitudinal_part_3 =
        circuit_front_contact_lateral_front_contact_longitudinal_part_2
        + front_contact_G_lateral_rear_contact_lean *
        front_contact_longitudinal_response_rear_contact_lean;
    const real circuit_front_contact_lateral_front_contact_longitudinal_part_4 =
        circuit_front_contact_lateral_front_contact_longitudinal_part_3
        + front_contact_G_lateral_rear_contact_spin *
        front_contact_longitudinal_response_rear_contact_spin;
    const real circuit_front_contact_lateral_front_contact_longitudinal_part_5 =
        circuit_front_contact_lateral_front_contact_longitudinal_part_4
        + front_contact_G_lateral_rear_contact_spin * front_contact_longitudinal_response_rear_hub -
        front_contact_G_lateral_steer * front_contact_longitudinal_minus_response_steer;
    const real circuit_front_contact_lateral_front_contact_longitudinal =
        circuit_front_contact_lateral_front_contact_longitudinal_part_5
        + front_contact_G_lateral_front_hub * front_contact_longitudinal_response_front_hub;
    circuit_matrix[1][2] = circuit_front_contact_lateral_front_contact_longitudinal;
    circuit_matrix[2][1] = circuit_front_contact_lateral_front_contact_longitudinal;
    const real circuit_front_contact_lateral_front_contact_lateral_part =
        front_contact_G_lateral_rear_contact_x * front_contact_lateral_response_rear_contact_x
        + front_contact_G_lateral_rear_contact_y * front_contact_lateral_response_rear_contact_y;
    const real circuit_front_contact_lateral_front_contact_lateral_part_2 =
        circuit_front_contact_lateral_front_contact_lateral_part
        + front_contact_G_lateral_rear_contact_yaw * front_contact_lateral_response_rear_contact_yaw
        + front_contact_G_lateral_rear_contact_lean *
        front_contact_lateral_response_rear_contact_lean;
    const real circuit_front_contact_lateral_front_contact_lateral_part_3 =
        circuit_front_contact_lateral_front_contact_lateral_part_2
        + front_contact_G_lateral_rear_contact_spin *
        front_contact_lateral_response_rear_contact_spin
        + front_contact_G_lateral_rear_contact_spin * front_contact_lateral_response_rear_hub;
    const real circuit_front_contact_lateral_front_contact_lateral =
        circuit_front_contact_lateral_front_contact_lateral_part_3
        + front_contact_G_lateral_steer * front_contact_lateral_response_steer
        + front_contact_G_lateral_front_hub * front_contact_lateral_response_front_hub;
    circuit_matrix[2][2] = circuit_front_contact_lateral_front_contact_lateral;
    const real circuit_rear_contact_longitudinal_front_contact_pz = rear_contact_yaw_cos *
        front_contact_pz_response_rear_contact_x
        + rear_contact_yaw_sin * front_contact_pz_response_rear_contact_y
        - rear_radius * front_contact_pz_response_rear_contact_spin;
    circuit_matrix[0][3] = circuit_rear_contact_longitudinal_front_contact_pz;
    circuit_matrix[3][0] = circuit_rear_contact_longitudinal_front_contact_pz;
    const real circuit_rear_contact_longitudinal_front_contact_longitudinal = rear_contact_yaw_cos *
        front_contact_longitudinal_response_rear_contact_x
        + rear_contact_yaw_sin * front_contact_longitudinal_response_rear_contact_y
        - rear_radius * front_contact_longitudinal_response_rear_contact_spin;
    circuit_matrix[1][3] = circuit_rear_contact_longitudinal_front_contact_longitudinal;
    circuit_matrix[3][1] = circuit_rear_contact_longitudinal_front_contact_longitudinal;
    const real circuit_rear_contact_longitudinal_front_contact_lateral = rear_contact_yaw_cos *
        front_contact_lateral_response_rear_contact_x
        + rear_contact_yaw_sin * front_contact_lateral_response_rear_contact_y
        - rear_radius * front_contact_lateral_response_rear_contact_spin;
    circuit_matrix[2][3] = circuit_rear_contact_longitudinal_front_contact_lateral;
    circuit_matrix[3][2] = circuit_rear_contact_longitudinal_front_contact_lateral;
    const real circuit_rear_contact_longitudinal_rear_contact_longitudinal = rear_contact_yaw_cos *
        rear_contact_longitudinal_response_rear_contact_x
        + rear_contact_yaw_sin * rear_contact_longitudinal_response_rear_contact_y
        + rear_radius * rear_contact_longitudinal_minus_response_rear_contact_spin;
    circuit_matrix[3][3] = circuit_rear_contact_longitudinal_rear_contact_longitudinal;
    const real circuit_rear_contact_lateral_front_contact_pz = rear_contact_yaw_cos *
        front_contact_pz_response_rear_contact_y
        - rear_contact_yaw_sin * front_contact_pz_response_rear_contact_x;
    circuit_matrix[0][4] = circuit_rear_contact_lateral_front_contact_pz;
    circuit_matrix[4][0] = circuit_rear_contact_lateral_front_contact_pz;
    const real circuit_rear_contact_lateral_front_contact_longitudinal = rear_contact_yaw_cos *
        front_contact_longitudinal_response_rear_contact_y
        - rear_contact_yaw_sin * front_contact_longitudinal_response_rear_contact_x;
    circuit_matrix[1][4] = circuit_rear_contact_lateral_front_contact_longitudinal;
    circuit_matrix[4][1] = circuit_rear_contact_lateral_front_contact_longitudinal;
    const real circuit_rear_contact_lateral_front_contact_lateral = rear_contact_yaw_cos *
        front_contact_lateral_response_rear_contact_y
        - rear_contact_yaw_sin * front_contact_lateral_response_rear_contact_x;
    circuit_matrix[2][4] = circuit_rear_contact_lateral_front_contact_lateral;
    circuit_matrix[4][2] = circuit_rear_contact_lateral_front_contact_lateral;
    const real circuit_rear_contact_lateral_rear_contact_longitudinal = rear_contact_yaw_cos *
        rear_contact_longitudinal_response_rear_contact_y
        - rear_contact_yaw_sin * rear_contact_longitudinal_response_rear_contact_x;
    circuit_matrix[3][4] = circuit_rear_contact_lateral_rear_contact_longitudinal;
    circuit_matrix[4][3] = circuit_rear_contact_lateral_rear_contact_longitudinal;
    const real circuit_rear_contact_lateral_rear_contact_lateral = rear_contact_yaw_sin *
        rear_contact_lateral_minus_response_rear_contact_x
        + rear_contact_yaw_cos * rear_contact_lateral_response_rear_contact_y;
    circuit_matrix[4][4] = circuit_rear_contact_lateral_rear_contact_lateral;
    const real free_gamma_front_contact_pz_part = front_contact_G_pz_rear_contact_x *
        free_udot_rear_contact_x + front_contact_G_pz_rear_contact_y * free_udot_rear_contact_y
        + front_contact_G_pz_rear_contact_yaw * free_udot_rear_contact_yaw
        + front_contact_G_pz_rear_contact_lean * free_udot_rear_contact_lean;
    const real free_gamma_front_contact_pz_part_2 = free_gamma_front_contact_pz_part
        + front_contact_G_pz_rear_contact_spin * free_udot_rear_contact_spin
        + front_contact_G_pz_rear_contact_spin * free_udot_rear_hub
        + front_contact_G_pz_steer * free_udot_steer;
    const real free_gamma_front_contact_longitudinal_part =
        front_contact_minus_G_longitudinal_rear_contact_x * free_udot_rear_contact_x
        + front_contact_minus_G_longitudinal_rear_contact_y * free_udot_rear_contact_y
        + front_contact_minus_G_longitudinal_rear_contact_yaw * free_udot_rear_contact_yaw;
    const real free_gamma_front_contact_longitudinal_part_2 =
        free_gamma_front_contact_longitudinal_part
        + front_contact_minus_G_longitudinal_rear_contact_lean * free_udot_rear_contact_lean
        + front_contact_minus_G_longitudinal_rear_contact_spin * free_udot_rear_contact_spin;
    const real free_gamma_front_contact_longitudinal_part_3 =
        free_gamma_front_contact_longitudinal_part_2
        + front_contact_minus_G_longitudinal_rear_contact_spin * free_udot_rear_hub
        + front_contact_minus_G_longitudinal_steer * free_udot_steer
        + front_contact_minus_G_longitudinal_front_hub * free_udot_front_hub;
    const real free_gamma_front_contact_lateral_part = front_contact_G_lateral_rear_contact_x *
        free_udot_rear_contact_x
        + front_contact_G_lateral_rear_contact_y * free_udot_rear_contact_y
        + front_contact_G_lateral_rear_contact_yaw * free_udot_rear_contact_yaw;
    const real free_gamma_front_contact_lateral_part_2 = free_gamma_front_contact_lateral_part
        + front_contact_G_lateral_rear_contact_lean * free_udot_rear_contact_lean
        + front_contact_G_lateral_rear_contact_spin * free_udot_rear_contact_spin
        + front_contact_G_lateral_rear_contact_spin * free_udot_rear_hub;
    const real free_gamma_front_contact_pz = front_contact_gamma_pz
        - (free_gamma_front_contact_pz_part_2 + front_contact_G_pz_front_hub * free_udot_front_hub);
    circuit_right[0] = free_gamma_front_contact_pz;
    const real free_gamma_front_contact_longitudinal = front_contact_gamma_longitudinal
        + free_gamma_front_contact_longitudinal_part_3;
    circuit_right[1] = free_gamma_front_contact_longitudinal;
    const real free_gamma_front_contact_lateral = front_contact_gamma_lateral
        - (free_gamma_front_contact_lateral_part_2
        + front_contact_G_lateral_steer * free_udot_steer
        + front_contact_G_lateral_front_hub * free_udot_front_hub);
    circuit_right[2] = free_gamma_front_contact_lateral;
    const real free_gamma_rear_contact_longitudinal = rear_contact_gamma_longitudinal
        - (rear_contact_yaw_cos * free_udot_rear_contact_x
        + rear_contact_yaw_sin * free_udot_rear_contact_y
        - rear_radius * free_udot_rear_contact_spin);
    circuit_right[3] = free_gamma_rear_contact_longitudinal;
    const real free_gamma_rear_contact_lateral = rear_contact_gamma_lateral
        - (rear_contact_yaw_cos * free_udot_rear_contact_y
        - rear_contact_yaw_sin * free_udot_rear_contact_x);
    circuit_right[4] = free_gamma_rear_contact_lateral;
    /* circuit_matrix lam = circuit_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 5, 1, circuit_matrix[0], circuit_right, circuit_scratch);

    /* front_contact: multiplier pz, multiplier longitudinal, multiplier lateral */
    const real front_contact_multiplier_pz = circuit_right[0];
    const real front_contact_multiplier_longitudinal = circuit_right[1];
    const real front_contact_multiplier_lateral = circuit_right[2];

    /* rear_contact: multiplier longitudinal, multiplier lateral */
    const real rear_contact_multiplier_longitudinal = circuit_right[3];
    const real rear_contact_multiplier_lateral = circuit_right[4];

    /* constraints: multipliers */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const real rear_contact_udot_x_part = front_contact_pz_response_rear_contact_x *
        front_contact_multiplier_pz
        + front_contact_longitudinal_response_rear_contact_x * front_contact_multiplier_longitudinal
        + front_contact_lateral_response_rear_contact_x * front_contact_multiplier_lateral;
    const real rear_contact_udot_y_part = front_contact_pz_response_rear_contact_y *
        front_contact_multiplier_pz
        + front_contact_longitudinal_response_rear_contact_y * front_contact_multiplier_longitudinal
        + front_contact_lateral_response_rear_contact_y * front_contact_multiplier_lateral;
    const real rear_contact_udot_yaw_part = front_contact_pz_response_rear_contact_yaw *
        front_contact_multiplier_pz
        + front_contact_longitudinal_response_rear_contact_yaw *
        front_contact_multiplier_longitudinal
        + front_contact_lateral_response_rear_contact_yaw * front_contact_multiplier_lateral;
    const real rear_contact_udot_lean_part = front_contact_pz_response_rear_contact_lean *
        front_contact_multiplier_pz
        + front_contact_longitudinal_response_rear_contact_lean *
        front_contact_multiplier_longitudinal
        + front_contact_lateral_response_rear_contact_lean * front_contact_multiplier_lateral;
    const real rear_contact_udot_spin_part = front_contact_pz_response_rear_contact_spin *
        front_contact_multiplier_pz
        + front_contact_longitudinal_response_rear_contact_spin *
        front_contact_multiplier_longitudinal
        + front_contact_lateral_response_rear_contact_spin * front_contact_multiplier_lateral;
    const real rear_hub_udot_part = front_contact_pz_response_rear_hub * front_contact_multiplier_pz
        + front_contact_longitudinal_response_rear_hub * front_contact_multiplier_longitudinal
        + front_contact_lateral_response_rear_hub * front_contact_multiplier_lateral;
    const real steer_udot_part = (M_factor_L_steer_rear_contact_spin *
        rear_contact_longitudinal_minus_response_rear_contact_spin
        - rear_contact_longitudinal_response_steer_part_2
        - M_factor_L_steer_rear_contact_spin * rear_contact_longitudinal_response_rear_hub) *
        rear_contact_multiplier_longitudinal;
    const real steer_udot_part_2 = front_contact_pz_response_steer * front_contact_multiplier_pz
        - front_contact_longitudinal_minus_response_steer * front_contact_multiplier_longitudinal
        + front_contact_lateral_response_steer * front_contact_multiplier_lateral + steer_udot_part;
    const real front_hub_udot_part = front_contact_pz_response_front_hub *
        front_contact_multiplier_pz
        + front_contact_longitudinal_response_front_hub * front_contact_multiplier_longitudinal
        + front_contact_lateral_response_front_hub * front_contact_multiplier_lateral;
    const real front_hub_udot_part_2 = (M_minus_factor_L_front_hub_rear_contact_spin *
        rear_contact_lateral_response_rear_contact_spin
        - rear_contact_lateral_response_front_hub_part
        + M_minus_factor_L_front_hub_rear_contact_spin * rear_contact_lateral_response_rear_hub) *
        rear_contact_multiplier_lateral;

    /* rear_contact: udot */
    /* udot = free_udot + response multipliers */
    /* udot: rear_contact.u.xdot [m/s^2] */
    out[0] = rear_contact_udot_x_part
        + rear_contact_longitudinal_response_rear_contact_x * rear_contact_multiplier_longitudinal -
        rear_contact_lateral_minus_response_rear_contact_x * rear_contact_multiplier_lateral
        + free_udot_rear_contact_x;
    /* udot: rear_contact.u.ydot [m/s^2] */
    out[1] = rear_contact_udot_y_part
        + rear_contact_longitudinal_response_rear_contact_y * rear_contact_multiplier_longitudinal +
        rear_contact_lateral_response_rear_contact_y * rear_contact_multiplier_lateral
        + free_udot_rear_contact_y;
    /* udot: rear_contact.u.yawdot [rad/s^2] */
    out[2] = rear_contact_udot_yaw_part
        + rear_contact_longitudinal_response_rear_contact_yaw * rear_contact_multiplier_longitudinal
        + rear_contact_lateral_response_rear_contact_yaw * rear_contact_multiplier_lateral
        + free_udot_rear_contact_yaw;
    /* udot: rear_contact.u.leandot [rad/s^2] */
    out[3] = rear_contact_udot_lean_part
        + rear_contact_longitudinal_response_rear_contact_lean *
        rear_contact_multiplier_longitudinal
        + rear_contact_lateral_response_rear_contact_lean * rear_contact_multiplier_lateral
        + free_udot_rear_contact_lean;
    /* udot: rear_contact.u.spindot [rad/s^2] */
    out[4] = rear_contact_udot_spin_part
        - rear_contact_longitudinal_minus_response_rear_contact_spin *
        rear_contact_multiplier_longitudinal
        + rear_contact_lateral_response_rear_contact_spin * rear_contact_multiplier_lateral
        + free_udot_rear_contact_spin;

    /* rear_hub: udot */
    /* udot = free_udot + response multipliers */
    /* udot: rear_hub.udot [rad/s^2] */
    out[5] = rear_hub_udot_part
        + rear_contact_longitudinal_response_rear_hub * rear_contact_multiplier_longitudinal
        + rear_contact_lateral_response_rear_hub * rear_contact_multiplier_lateral
        + free_udot_rear_hub;

    /* steer: udot */
    /* udot = free_udot + response multipliers */
    /* udot: steer.udot [rad/s^2] */
    out[6] = steer_udot_part_2 + (rear_contact_lateral_response_steer_part_2
        - M_factor_L_steer_rear_contact_spin * rear_contact_lateral_response_rear_hub) *
        rear_contact_multiplier_lateral + free_udot_steer;

    /* front_hub: udot */
    /* udot = free_udot + response multipliers */
    /* udot: front_hub.udot [rad/s^2] */
    out[7] = front_hub_udot_part
        + rear_contact_longitudinal_response_front_hub * rear_contact_multiplier_longitudinal
        + front_hub_udot_part_2 + free_udot_front_hub;
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {8, 55, 38, 0, 8, 8, 0, 0, 0, 26, 0, 0, 0, 0, 8, 0, 0, 0, 0, 0};
#endif
