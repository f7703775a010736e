/*
 * inverse_dynamics of bicycle
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: axes, base_parameters
 * passes: reassociate
 *
 * Sizes: out 8, work 0, w 23
 * Operations per call: 405 = 228 mul, 100 add, 65 sub, 6 cos, 6 sin
 * Operations of prepare: 181 = 79 mul, 45 add, 34 sub, 6 div, 4 neg, 4 select, 3 sqrt, 2 atan2,
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
    const wreal frame_origin_inertia_yy = frame_inertia_yy + frame_com_x_times_first_moment_x
        + sum_c0p9_minus_rear_radius_times_frame_first_moment_z;
    const wreal frame_origin_inertia_zz = frame_inertia_zz + frame_com_x_times_first_moment_x;
    const wreal frame_base_half_trace = 0.5 * (frame_origin_inertia_xx + frame_origin_inertia_zz
        + frame_origin_inertia_yy);

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
    w[3] = steer_minus_R_xz;

    /* steer: R */
    /* R = R_fixed R_joint(q) */
    const wreal steer_R_zz = tilt_cos / sqrt_of_tilt_sin_squared_plus_cos_squared;
    w[4] = steer_R_zz;

    /* fork: axes, mass */
    const wreal fork_axes_side = cardan_select(cardan_lt(steer_R_zz, 0.0), -1.0, 1.0);
    const wreal steer_minus_R_xz_times_fork_axes_side = steer_minus_R_xz * fork_axes_side;
    const wreal fork_base_half_trace_part = steer_R_zz * (fork_origin_inertia_zz * steer_R_zz
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
    const wreal fork_base_half_trace_part_2 = fork_axes_unit_x * fork_mass_half_turned_xx
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
    w[5] = front_hub_R_yy;
    w[7] = front_hub_offset;

    /* steer: place */
    const wreal steer_offset = cardan_atan2(-front_hub_R_yy, 0.0);
    w[6] = steer_offset;

    /* fork: mass, base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal front_hub_R_yy_times_fork_mass_half_turned_yy = fork_origin_inertia_yy *
        front_hub_R_yy * front_hub_R_yy;
    const wreal fork_base_half_trace = 0.5 * (fork_base_half_trace_part_2
        + fork_base_half_trace_part + front_hub_R_yy_times_fork_mass_half_turned_yy);

    /* front_wheel: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal front_wheel_mass = p[22]; /* kg */
    const wreal front_wheel_inertia_xx = p[23]; /* kg m^2 */
    const wreal front_wheel_inertia_yy = p[24]; /* kg m^2 */
    const wreal front_wheel_inertia_zz = p[25]; /* kg m^2 */
    const wreal front_wheel_base_mass_moment_x = front_wheel_mass * front_hub_p_x;
    const wreal front_wheel_base_mass_moment_z = front_wheel_mass * front_hub_p_z;
    const wreal fork_mass_plus_front_wheel_mass = fork_mass + front_wheel_mass;
    const wreal fork_base_mean_moment_x_part = fork_first_moment_z * steer_R_zz
        - fork_first_moment_x * steer_minus_R_xz + front_wheel_base_mass_moment_z;
    const wreal front_wheel_base_half_trace = 0.5 * (front_wheel_inertia_xx
        + front_wheel_inertia_zz + front_wheel_inertia_yy);
    const wreal front_wheel_base_second_moment_xx = front_wheel_base_half_trace
        - front_wheel_inertia_xx;
    const wreal front_wheel_base_second_moment_zz = front_wheel_base_half_trace
        - front_wheel_inertia_zz;
    const wreal fork_minus_base_half_turned_xz_part = front_hub_p_z * front_wheel_base_mass_moment_z
        + fork_base_half_trace - fork_base_half_trace_part;
    w[15] = front_wheel_base_second_moment_xx;
    w[16] = front_wheel_base_second_moment_zz;

    /* fork: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal fork_base_moment_x = fork_first_moment_x * fork_axes_unit_x
        + fork_first_moment_z * fork_axes_unit_z + front_wheel_base_mass_moment_x;
    const wreal fork_base_inertia_xz = steer_R_zz * fork_mass_half_turned_xz
        - steer_minus_R_xz * fork_mass_half_turned_xx
        - front_hub_p_z * front_wheel_base_mass_moment_x;
    const wreal fork_base_mean_moment_x_part_2 = steer_minus_R_xz * fork_base_mean_moment_x_part;
    const wreal fork_base_mean_moment_z_part = steer_R_zz * fork_base_mean_moment_x_part;
    const wreal half_sum_fork_mass_plus_front_wheel_mass = 0.5 * fork_mass_plus_front_wheel_mass;
    const wreal fork_base_mean_moment_x = steer_place_x * half_sum_fork_mass_plus_front_wheel_mass -
        fork_base_mean_moment_x_part_2;
    const wreal fork_base_mean_moment_z = fork_base_mean_moment_z_part
        - rear_radius * half_sum_fork_mass_plus_front_wheel_mass;
    const wreal steer_place_x_times_fork_base_mean_moment_x = steer_place_x *
        fork_base_mean_moment_x;
    const wreal rear_radius_times_fork_base_mean_moment_z = rear_radius * fork_base_mean_moment_z;
    const wreal fork_base_second_moment_xx = front_hub_p_x * front_wheel_base_mass_moment_x
        + fork_base_half_trace - fork_base_half_trace_part_2;
    const wreal fork_base_second_moment_yy = fork_base_half_trace
        - front_hub_R_yy_times_fork_mass_half_turned_yy
        + front_hub_R_yy * (front_wheel_base_half_trace - front_wheel_inertia_yy) * front_hub_R_yy;
    const wreal fork_minus_base_half_turned_xz = steer_minus_R_xz *
        fork_minus_base_half_turned_xz_part;
    w[8] = fork_base_moment_x;
    w[9] = fork_base_inertia_xz;
    w[17] = fork_base_second_moment_xx;
    w[18] = fork_base_second_moment_yy;

    /* frame: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal frame_base_moment_x = frame_first_moment_x
        + steer_place_x * fork_mass_plus_front_wheel_mass - fork_base_mean_moment_x_part_2;
    const wreal frame_base_moment_z = frame_first_moment_z + fork_base_mean_moment_z_part
        - rear_radius * fork_mass_plus_front_wheel_mass;
    const wreal frame_base_second_moment_xx = steer_place_x_times_fork_base_mean_moment_x
        + steer_minus_R_xz * fork_minus_base_half_turned_xz + (frame_base_half_trace
        - frame_origin_inertia_xx + steer_place_x_times_fork_base_mean_moment_x);
    const wreal frame_base_second_moment_xz = steer_place_x * fork_base_mean_moment_z
        - rear_radius * fork_base_mean_moment_x - (frame_origin_inertia_xz
        + steer_R_zz * fork_minus_base_half_turned_xz);
    const wreal frame_base_second_moment_zz = steer_R_zz * fork_minus_base_half_turned_xz_part *
        steer_R_zz - rear_radius_times_fork_base_mean_moment_z + (frame_base_half_trace
        - frame_origin_inertia_zz - rear_radius_times_fork_base_mean_moment_z);
    w[10] = frame_base_moment_x;
    w[11] = frame_base_moment_z;
    w[19] = frame_base_second_moment_xx;
    w[20] = frame_base_second_moment_xz;
    w[21] = frame_base_second_moment_zz;

    /* rear_wheel: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal rear_wheel_mass = p[6]; /* kg */
    const wreal rear_wheel_inertia_xx = p[7]; /* kg m^2 */
    const wreal rear_wheel_inertia_yy = p[8]; /* kg m^2 */
    const wreal rear_wheel_inertia_zz = p[9]; /* kg m^2 */
    const wreal rear_wheel_base_mass = rear_wheel_mass + frame_mass
        + fork_mass_plus_front_wheel_mass;
    const wreal rear_wheel_base_half_trace = 0.5 * (rear_wheel_inertia_xx + rear_wheel_inertia_zz
        + rear_wheel_inertia_yy);
    const wreal rear_wheel_base_second_moment_xx = rear_wheel_base_half_trace
        - rear_wheel_inertia_xx;
    const wreal rear_wheel_base_second_moment_zz = rear_wheel_base_half_trace
        - rear_wheel_inertia_zz;
    const wreal rear_wheel_base_second_moment_yy = rear_wheel_base_half_trace
        - rear_wheel_inertia_yy + (frame_base_half_trace - frame_origin_inertia_yy);
    w[12] = rear_wheel_base_mass;
    w[13] = rear_wheel_base_second_moment_xx;
    w[14] = rear_wheel_base_second_moment_zz;
    w[22] = rear_wheel_base_second_moment_yy;

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

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
    const real rear_contact_yaw = q[2]; /* rad */
    const real rear_contact_lean = q[3]; /* rad */
    const real rear_contact_spin = q[4]; /* rad */
    const real rear_hub_q = q[5]; /* rad */
    const real steer_q = q[6]; /* rad */
    const real front_hub_q = q[7]; /* rad */
    const wreal steer_offset = w[6];
    const wreal front_hub_offset = w[7];
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

    /* rear_contact: R, S, drift */
    /* R = R_fixed R_joint(q) */
    /* S = d(twist of the child) / du */
    /* drift = S' u + [0; omega x v] */
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
    const real rear_radius_times_rear_contact_lean_sin = rear_radius * rear_contact_lean_sin;
    const real rear_wheel_a_x_part = rear_contact_spin_cos *
        rear_radius_times_rear_contact_lean_sin;
    const real rear_wheel_a_z_part = rear_contact_spin_sin *
        rear_radius_times_rear_contact_lean_sin;
    const real rear_contact_u_yaw_times_lean_sin = rear_contact_u_yaw * rear_contact_lean_sin;
    const real rear_contact_u_yaw_times_lean_cos = rear_contact_u_yaw * rear_contact_lean_cos;
    const real rear_contact_u_spin_times_u_yaw_times_lean_cos = rear_contact_u_spin *
        rear_contact_u_yaw_times_lean_cos;
    const real rear_wheel_alpha_x_part = rear_contact_u_lean * rear_contact_u_spin
        - rear_contact_u_lean * rear_contact_u_yaw_times_lean_sin;
    const real rear_wheel_a_x_part_2 = 2.0 * rear_contact_u_lean * rear_contact_u_yaw_times_lean_cos
        * rear_radius;
    const real rear_wheel_a_x_part_3 = rear_radius * (rear_contact_u_lean * rear_contact_u_lean
        + rear_contact_u_yaw_times_lean_sin * rear_contact_u_yaw_times_lean_sin);

    /* rear_wheel: omega, alpha, a, U */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    const real rear_contact_u_xdot = udot[0]; /* m/s^2 */
    const real rear_contact_u_ydot = udot[1]; /* m/s^2 */
    const real rear_contact_u_yawdot = udot[2]; /* rad/s^2 */
    const real rear_contact_u_leandot = udot[3]; /* rad/s^2 */
    const real rear_contact_u_spindot = udot[4]; /* rad/s^2 */
    const wreal gravity_z = w[1]; /* m/s^2 */
    const real rear_wheel_omega_x = rear_contact_u_lean * rear_contact_spin_cos
        - rear_contact_u_yaw * rear_contact_minus_R_zx;
    const real rear_wheel_omega_y = rear_contact_u_spin + rear_contact_u_yaw_times_lean_sin;
    const real rear_wheel_omega_z = rear_contact_u_yaw * rear_contact_R_zz
        + rear_contact_u_lean * rear_contact_spin_sin;
    const real rear_wheel_alpha_x = rear_contact_u_leandot * rear_contact_spin_cos
        - rear_contact_u_yawdot * rear_contact_minus_R_zx
        - rear_contact_spin_cos * rear_contact_u_spin_times_u_yaw_times_lean_cos
        - rear_contact_spin_sin * rear_wheel_alpha_x_part;
    const real rear_wheel_alpha_y = rear_contact_u_spindot
        + rear_contact_u_yawdot * rear_contact_lean_sin
        + rear_contact_u_lean * rear_contact_u_yaw_times_lean_cos;
    const real rear_wheel_alpha_z = rear_contact_u_yawdot * rear_contact_R_zz
        + rear_contact_u_leandot * rear_contact_spin_sin
        - rear_contact_spin_sin * rear_contact_u_spin_times_u_yaw_times_lean_cos
        + rear_contact_spin_cos * rear_wheel_alpha_x_part;
    const real rear_wheel_a_x = rear_contact_u_yawdot * rear_wheel_a_x_part
        + gravity_z * rear_contact_minus_R_zx + rear_contact_u_ydot * rear_contact_R_yx
        + (rear_contact_spin_cos * rear_wheel_a_x_part_2
        + rear_contact_u_xdot * rear_contact_R_xx + rear_contact_spin_sin * rear_wheel_a_x_part_3);
    const real rear_wheel_a_y = rear_contact_u_ydot * rear_contact_R_yy
        - rear_contact_u_xdot * rear_contact_minus_R_xy
        + (rear_contact_u_yaw_times_lean_sin * rear_contact_u_yaw_times_lean_cos * rear_radius
        - (rear_radius * rear_contact_u_leandot + gravity_z * rear_contact_lean_sin));
    const real rear_wheel_a_z = rear_contact_u_yawdot * rear_wheel_a_z_part
        - gravity_z * rear_contact_R_zz + rear_contact_u_ydot * rear_contact_R_yz
        + (rear_contact_spin_sin * rear_wheel_a_x_part_2
        + rear_contact_u_xdot * rear_contact_R_xz - rear_contact_spin_cos * rear_wheel_a_x_part_3);
    const real rear_wheel_omega_x_times_omega_y = rear_wheel_omega_x * rear_wheel_omega_y;
    const real rear_wheel_omega_x_times_omega_z = rear_wheel_omega_x * rear_wheel_omega_z;
    const real rear_wheel_omega_y_times_omega_z = rear_wheel_omega_y * rear_wheel_omega_z;
    const real rear_wheel_U_xy = rear_wheel_omega_x_times_omega_y - rear_wheel_alpha_z;
    const real rear_wheel_U_xz = rear_wheel_alpha_y + rear_wheel_omega_x_times_omega_z;
    const real rear_wheel_U_yx = rear_wheel_alpha_z + rear_wheel_omega_x_times_omega_y;
    const real rear_wheel_U_yz = rear_wheel_omega_y_times_omega_z - rear_wheel_alpha_x;
    const real rear_wheel_U_zx = rear_wheel_omega_x_times_omega_z - rear_wheel_alpha_y;
    const real rear_wheel_U_zy = rear_wheel_alpha_x + rear_wheel_omega_y_times_omega_z;

    /* frame: omega, alpha, a, U */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    const real rear_hub_u = u[5]; /* rad/s */
    const real rear_hub_udot = udot[5]; /* rad/s^2 */
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
    const real frame_omega_y_squared = frame_omega_y * frame_omega_y;
    const real frame_omega_x_times_omega_z = frame_omega_x * frame_omega_z;
    const real frame_minus_U_xx = frame_omega_y_squared + frame_omega_z * frame_omega_z;
    const real frame_U_xz = frame_alpha_y + frame_omega_x_times_omega_z;
    const real frame_U_yx = frame_alpha_z + frame_omega_x * frame_omega_y;
    const real frame_U_yz = frame_omega_z * frame_omega_y - frame_alpha_x;
    const real frame_U_zx = frame_omega_x_times_omega_z - frame_alpha_y;
    const real frame_minus_U_zz = frame_omega_x * frame_omega_x + frame_omega_y_squared;

    /* steer: R */
    /* R = R_fixed R_joint(q) */
    const wreal steer_minus_R_xz = w[3];
    const wreal steer_R_zz = w[4];
    const real steer_minus_R_xx = steer_R_zz * steer_angle_sin;
    const real steer_minus_R_xy = steer_R_zz * steer_angle_cos;
    const real steer_minus_R_zx = steer_minus_R_xz * steer_angle_sin;
    const real steer_minus_R_zy = steer_minus_R_xz * steer_angle_cos;

    /* fork: omega, alpha, a, U, inertia force, f */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real steer_u = u[6]; /* rad/s */
    const real steer_udot = udot[6]; /* rad/s^2 */
    const wreal steer_place_x = w[2];
    const wreal fork_base_moment_x = w[8];
    const real fork_omega_x = frame_omega_y * steer_angle_cos - frame_omega_x * steer_minus_R_xx
        - frame_omega_z * steer_minus_R_zx;
    const real fork_minus_omega_y = frame_omega_x * steer_minus_R_xy
        + frame_omega_y * steer_angle_sin + frame_omega_z * steer_minus_R_zy;
    const real fork_omega_z = steer_u + steer_R_zz * frame_omega_z
        - steer_minus_R_xz * frame_omega_x;
    const real fork_alpha_x = steer_angle_cos * frame_alpha_y - steer_minus_R_xx * frame_alpha_x
        - (steer_u * fork_minus_omega_y + steer_minus_R_zx * frame_alpha_z);
    const real fork_minus_alpha_y = steer_u * fork_omega_x + steer_angle_sin * frame_alpha_y
        + (steer_minus_R_xy * frame_alpha_x + steer_minus_R_zy * frame_alpha_z);
    const real fork_alpha_z = steer_udot + steer_R_zz * frame_alpha_z
        - steer_minus_R_xz * frame_alpha_x;
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
    const real fork_U_zx = fork_minus_alpha_y + fork_omega_x * fork_omega_z;
    const real fork_U_zy = fork_alpha_x - fork_minus_omega_y_times_omega_z;
    const real fork_base_moment_x_times_minus_a_y = fork_base_moment_x * (steer_minus_R_xy *
        fork_minus_a_y_part + steer_minus_R_zy * fork_minus_a_y_part_2
        + steer_angle_sin * (rear_wheel_a_y + steer_place_x * frame_U_yx
        - rear_radius * frame_U_yz));
    const real fork_minus_f_x = fork_base_moment_x * fork_minus_U_xx;
    const real fork_f_y = fork_base_moment_x * fork_U_yx;
    const real fork_f_z = fork_base_moment_x * fork_U_zx;
    const real frame_n_y_part = steer_minus_R_xx * fork_minus_f_x - steer_minus_R_xy * fork_f_y
        - steer_minus_R_xz * fork_f_z;
    const real frame_minus_n_x_part = steer_angle_cos * fork_minus_f_x + steer_angle_sin * fork_f_y;
    const real frame_n_y_part_2 = steer_minus_R_zx * fork_minus_f_x - steer_minus_R_zy * fork_f_y
        + steer_R_zz * fork_f_z;

    /* front_hub: R */
    /* R = R_fixed R_joint(q) */
    const wreal front_hub_R_yy = w[5];
    const real front_hub_minus_R_zx = front_hub_R_yy * front_hub_angle_cos;
    const real front_hub_minus_R_zz = front_hub_R_yy * front_hub_angle_sin;

    /* front_wheel: alpha, omega, U, inertia force, n */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* omega = Rᵀ omega_parent + S_w u */
    /* U = [alpha] + [omega][omega] */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real front_hub_u = u[7]; /* rad/s */
    const real front_hub_udot = udot[7]; /* rad/s^2 */
    const wreal front_wheel_base_second_moment_xx = w[15];
    const wreal front_wheel_base_second_moment_zz = w[16];
    const real front_wheel_minus_omega_x = fork_omega_x * front_hub_angle_sin
        + fork_omega_z * front_hub_minus_R_zx;
    const real front_wheel_omega_z = fork_omega_x * front_hub_angle_cos
        - fork_omega_z * front_hub_minus_R_zz;
    const real front_wheel_omega_y = front_hub_u - front_hub_R_yy * fork_minus_omega_y;
    const real front_wheel_alpha_y = front_hub_udot - front_hub_R_yy * fork_minus_alpha_y;
    const real front_wheel_alpha_z = front_hub_angle_cos * fork_alpha_x
        - front_hub_u * front_wheel_minus_omega_x - front_hub_minus_R_zz * fork_alpha_z;
    const real front_wheel_minus_omega_x_times_omega_z = front_wheel_minus_omega_x *
        front_wheel_omega_z;
    const real front_wheel_U_xz = front_wheel_alpha_y - front_wheel_minus_omega_x_times_omega_z;
    const real front_wheel_U_yx = front_wheel_alpha_z
        - front_wheel_minus_omega_x * front_wheel_omega_y;
    const real front_wheel_U_yz = front_hub_u * front_wheel_omega_z
        + front_wheel_omega_z * front_wheel_omega_y + (front_hub_angle_sin * fork_alpha_x
        + front_hub_minus_R_zx * fork_alpha_z);
    const real front_wheel_minus_n_x = front_wheel_base_second_moment_zz * front_wheel_U_yz;
    const real front_wheel_n_y = front_wheel_base_second_moment_zz * front_wheel_U_xz
        + front_wheel_base_second_moment_xx * (front_wheel_alpha_y
        + front_wheel_minus_omega_x_times_omega_z);
    const real front_wheel_n_z = front_wheel_base_second_moment_xx * front_wheel_U_yx;
    out[7] = front_wheel_n_y; /* tau: front_hub.u.tau [N*m] */

    /* fork: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal fork_base_inertia_xz = w[9];
    const wreal fork_base_second_moment_xx = w[17];
    const wreal fork_base_second_moment_yy = w[18];
    const real fork_n_x = fork_base_second_moment_yy * fork_U_zy
        + fork_base_inertia_xz * fork_U_yx + front_hub_angle_sin * front_wheel_minus_n_x
        + front_hub_angle_cos * front_wheel_n_z;
    const real fork_n_y = front_hub_R_yy * front_wheel_n_y
        - (fork_base_second_moment_xx * fork_U_zx
        + fork_base_inertia_xz * (fork_omega_x * fork_omega_x + fork_minus_omega_y_squared
        - fork_minus_U_xx) + fork_base_moment_x * fork_a_z);
    const real fork_n_z_part = fork_base_second_moment_xx * fork_U_yx
        + fork_base_second_moment_yy * (fork_alpha_z + fork_omega_x_times_minus_omega_y)
        + fork_base_inertia_xz * (fork_alpha_x + fork_minus_omega_y_times_omega_z)
        - fork_base_moment_x_times_minus_a_y + front_hub_minus_R_zx * front_wheel_minus_n_x;
    const real fork_n_z = fork_n_z_part - front_hub_minus_R_zz * front_wheel_n_z;
    out[6] = fork_n_z; /* tau: steer.u.tau [N*m] */

    /* frame: n, f */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const wreal frame_base_moment_x = w[10];
    const wreal frame_base_moment_z = w[11];
    const wreal frame_base_second_moment_xx = w[19];
    const wreal frame_base_second_moment_xz = w[20];
    const wreal frame_base_second_moment_zz = w[21];
    const real frame_minus_n_x = frame_base_second_moment_zz * frame_U_yz
        + frame_base_moment_z * rear_wheel_a_y + frame_base_second_moment_xz * frame_U_yx
        + rear_radius * frame_minus_n_x_part + steer_minus_R_xx * fork_n_x
        + (steer_minus_R_xy * fork_n_y + steer_minus_R_xz * fork_n_z);
    const real frame_n_y_part_3 = frame_base_second_moment_zz * frame_U_xz
        - frame_base_second_moment_xx * frame_U_zx
        + frame_base_second_moment_xz * (frame_minus_U_zz - frame_minus_U_xx)
        + (frame_base_moment_z * frame_a_x - frame_base_moment_x * frame_a_z)
        - rear_radius * frame_n_y_part;
    const real frame_n_y = frame_n_y_part_3 - steer_place_x * frame_n_y_part_2
        + (steer_angle_cos * fork_n_x - steer_angle_sin * fork_n_y);
    const real frame_n_z = frame_base_second_moment_xx * frame_U_yx
        + frame_base_moment_x * rear_wheel_a_y + frame_base_second_moment_xz * frame_U_yz
        - steer_place_x * frame_minus_n_x_part + steer_R_zz * fork_n_z
        - (steer_minus_R_zx * fork_n_x + steer_minus_R_zy * fork_n_y);
    const real frame_f_x = frame_base_moment_z * frame_U_xz
        - frame_base_moment_x * frame_minus_U_xx + frame_n_y_part;
    const real frame_f_y = frame_base_moment_x * frame_U_yx + frame_base_moment_z * frame_U_yz
        - frame_minus_n_x_part;
    const real frame_f_z = frame_base_moment_x * frame_U_zx
        - frame_base_moment_z * frame_minus_U_zz + frame_n_y_part_2;
    out[5] = frame_n_y; /* tau: rear_hub.u.tau [N*m] */

    /* rear_wheel: n, f */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const wreal rear_wheel_base_mass = w[12];
    const wreal rear_wheel_base_second_moment_xx = w[13];
    const wreal rear_wheel_base_second_moment_zz = w[14];
    const wreal rear_wheel_base_second_moment_yy = w[22];
    const real rear_wheel_n_x = rear_wheel_base_second_moment_yy * rear_wheel_U_zy
        - rear_wheel_base_second_moment_zz * rear_wheel_U_yz + rear_hub_sin * frame_n_z
        - rear_hub_cos * frame_minus_n_x;
    const real rear_wheel_n_y = rear_wheel_base_second_moment_zz * rear_wheel_U_xz
        - rear_wheel_base_second_moment_xx * rear_wheel_U_zx + frame_n_y;
    const real rear_wheel_n_z = rear_wheel_base_second_moment_xx * rear_wheel_U_yx
        - rear_wheel_base_second_moment_yy * rear_wheel_U_xy + rear_hub_sin * frame_minus_n_x
        + rear_hub_cos * frame_n_z;
    const real rear_wheel_f_x = rear_wheel_base_mass * rear_wheel_a_x + rear_hub_cos * frame_f_x
        + rear_hub_sin * frame_f_z;
    const real rear_wheel_f_y = rear_wheel_base_mass * rear_wheel_a_y + frame_f_y;
    const real rear_wheel_f_z = rear_wheel_base_mass * rear_wheel_a_z + rear_hub_cos * frame_f_z
        - rear_hub_sin * frame_f_x;
    out[4] = rear_wheel_n_y; /* tau: rear_contact.u.spin.tau [N*m] */

    /* rear_contact: tau */
    /* tau = S . [n; f] - force on the joint */
    /* tau: rear_contact.u.x.tau [N] */
    out[0] = rear_contact_R_xx * rear_wheel_f_x - rear_contact_minus_R_xy * rear_wheel_f_y
        + rear_contact_R_xz * rear_wheel_f_z;
    /* tau: rear_contact.u.y.tau [N] */
    out[1] = rear_contact_R_yx * rear_wheel_f_x + rear_contact_R_yy * rear_wheel_f_y
        + rear_contact_R_yz * rear_wheel_f_z;
    /* tau: rear_contact.u.yaw.tau [N*m] */
    out[2] = rear_wheel_a_x_part * rear_wheel_f_x + rear_wheel_a_z_part * rear_wheel_f_z
        + rear_contact_lean_sin * rear_wheel_n_y - rear_contact_minus_R_zx * rear_wheel_n_x
        + rear_contact_R_zz * rear_wheel_n_z;
    /* tau: rear_contact.u.lean.tau [N*m] */
    out[3] = rear_contact_spin_cos * rear_wheel_n_x - rear_radius * rear_wheel_f_y
        + rear_contact_spin_sin * rear_wheel_n_z;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {8, 0, 23, 0, 8, 8, 0, 0, 0, 26, 0, 8, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
