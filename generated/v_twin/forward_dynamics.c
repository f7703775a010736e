/*
 * forward_dynamics of v_twin
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: axes, parallel, base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 6, work 55, w 29
 * Operations per call: 413 = 244 mul, 87 add, 69 sub, 4 cos, 4 sin, 2 div, 2 neg, 1 solve
 * Operations of prepare: 64 = 40 mul, 12 add, 4 div, 2 atan2, 2 cos, 2 neg, 2 sin
 *
 * Input q (6): generalized coordinates
 *   q[0]  right.crank [rad]
 *   q[1]  right.rod [rad]
 *   q[2]  right.piston [m]
 *   q[3]  left.crank [rad]
 *   q[4]  left.rod [rad]
 *   q[5]  left.piston [m]
 *
 * Input u (6): generalized speeds
 *   u[0]  right.crank.u [rad/s]
 *   u[1]  right.rod.u [rad/s]
 *   u[2]  right.piston.u [m/s]
 *   u[3]  left.crank.u [rad/s]
 *   u[4]  left.rod.u [rad/s]
 *   u[5]  left.piston.u [m/s]
 *
 * Input r (4): inputs of the model
 *   r[0]  right.torque [N m]
 *   r[1]  right.force [N]
 *   r[2]  left.torque [N m]
 *   r[3]  left.force [N]
 *
 * Input p (18): parameters, read by prepare_ only
 *
 * Input tau (6): applied generalized forces
 *   tau[0]  right.crank.u.tau [N*m]
 *   tau[1]  right.rod.u.tau [N*m]
 *   tau[2]  right.piston.u.tau [N]
 *   tau[3]  left.crank.u.tau [N*m]
 *   tau[4]  left.rod.u.tau [N*m]
 *   tau[5]  left.piston.u.tau [N]
 *
 * Output udot (6)
 *   out[0]  right.crank.udot [rad/s^2]
 *   out[1]  right.rod.udot [rad/s^2]
 *   out[2]  right.piston.udot [m/s^2]
 *   out[3]  left.crank.udot [rad/s^2]
 *   out[4]  left.rod.udot [rad/s^2]
 *   out[5]  left.piston.udot [m/s^2]
 */
#include "cardan.h"
#include "solve.h"
#include "dependent.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* shared by several: placement */
    const wreal right_ground_rotation_angle2 = p[15]; /* rad */
    const wreal left_ground_rotation_angle2 = p[17]; /* rad */
    const wreal angle[CARDAN_PADDED(2)] = {right_ground_rotation_angle2,
        left_ground_rotation_angle2};
    wreal sine[CARDAN_PADDED(2)], cosine[CARDAN_PADDED(2)];
    cardan_sincos(2, angle, sine, cosine);
    const wreal right_ground_rotation_angle2_cos = cosine[0];
    const wreal right_ground_rotation_angle2_sin = sine[0];
    const wreal left_ground_rotation_angle2_cos = cosine[1];
    const wreal left_ground_rotation_angle2_sin = sine[1];
    w[3] = right_ground_rotation_angle2_cos;
    w[4] = right_ground_rotation_angle2_sin;
    w[9] = left_ground_rotation_angle2_cos;
    w[10] = left_ground_rotation_angle2_sin;

    /* right.crank: mass, first moment, origin inertia, place */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal right_crank_length = p[0]; /* m */
    const wreal right_crank_mass = p[4]; /* kg */
    const wreal half_right_crank_length = 0.5 * right_crank_length;
    const wreal right_crank_first_moment_x = right_crank_mass * half_right_crank_length;
    const wreal right_crank_origin_inertia_yy = right_crank_length * right_crank_length *
        (0.08333333333333333 * right_crank_mass)
        + half_right_crank_length * right_crank_first_moment_x;
    const wreal right_crank_minus_offset = cardan_atan2(-right_ground_rotation_angle2_cos,
        right_ground_rotation_angle2_sin);
    w[15] = right_crank_minus_offset;

    /* right.rod: mass, first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal right_rod_length = p[1]; /* m */
    const wreal right_rod_mass = p[5]; /* kg */
    const wreal half_right_rod_length = 0.5 * right_rod_length;
    const wreal right_rod_first_moment_x = right_rod_mass * half_right_rod_length;
    const wreal right_rod_origin_inertia_yy = right_rod_length * right_rod_length *
        (0.08333333333333333 * right_rod_mass) + half_right_rod_length * right_rod_first_moment_x;
    const wreal right_rod_base_mass_moment_x = right_crank_length * right_rod_mass;
    w[5] = right_rod_first_moment_x;
    w[6] = right_rod_origin_inertia_yy;

    /* right.piston: place, a, f */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const wreal right_offset = p[2]; /* m */
    const wreal right_piston_mass = p[6]; /* kg */
    const wreal gravity_z = p[14]; /* m/s^2 */
    const wreal right_piston_place_x = right_offset * right_ground_rotation_angle2_sin;
    const wreal right_piston_place_z = right_offset * right_ground_rotation_angle2_cos;
    const wreal right_piston_a_x = gravity_z * right_ground_rotation_angle2_sin;
    const wreal right_piston_f_x = right_piston_mass * right_piston_a_x;
    w[7] = right_piston_place_x;
    w[8] = right_piston_place_z;
    w[23] = right_piston_f_x;

    /* left.crank: mass, first moment, origin inertia, place */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal left_crank_length = p[7]; /* m */
    const wreal left_crank_mass = p[11]; /* kg */
    const wreal half_left_crank_length = 0.5 * left_crank_length;
    const wreal left_crank_first_moment_x = left_crank_mass * half_left_crank_length;
    const wreal left_crank_origin_inertia_yy = left_crank_length * left_crank_length *
        (0.08333333333333333 * left_crank_mass)
        + half_left_crank_length * left_crank_first_moment_x;
    const wreal left_crank_minus_offset = cardan_atan2(-left_ground_rotation_angle2_cos,
        left_ground_rotation_angle2_sin);
    w[16] = left_crank_minus_offset;

    /* left.rod: mass, first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal left_rod_length = p[8]; /* m */
    const wreal left_rod_mass = p[12]; /* kg */
    const wreal half_left_rod_length = 0.5 * left_rod_length;
    const wreal left_rod_first_moment_x = left_rod_mass * half_left_rod_length;
    const wreal left_rod_origin_inertia_yy = left_rod_length * left_rod_length *
        (0.08333333333333333 * left_rod_mass) + half_left_rod_length * left_rod_first_moment_x;
    const wreal left_rod_base_mass_moment_x = left_crank_length * left_rod_mass;
    w[11] = left_rod_first_moment_x;
    w[12] = left_rod_origin_inertia_yy;

    /* left.piston: place, a, f */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const wreal left_offset = p[9]; /* m */
    const wreal left_piston_mass = p[13]; /* kg */
    const wreal left_piston_place_x = left_offset * left_ground_rotation_angle2_sin;
    const wreal left_piston_place_z = left_offset * left_ground_rotation_angle2_cos;
    const wreal left_piston_a_x = gravity_z * left_ground_rotation_angle2_sin;
    const wreal left_piston_f_x = left_piston_mass * left_piston_a_x;
    w[13] = left_piston_place_x;
    w[14] = left_piston_place_z;
    w[24] = left_piston_f_x;

    /* left.crank: base, inertia */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal left_crank_base_moment_x = left_crank_first_moment_x + left_rod_base_mass_moment_x;
    const wreal left_crank_base_inertia_yy = left_crank_origin_inertia_yy
        + left_crank_length * left_rod_base_mass_moment_x;
    const wreal left_rod_origin_inertia_yy_plus_left_crank_base_inertia_yy =
        left_rod_origin_inertia_yy + left_crank_base_inertia_yy;
    w[17] = left_crank_base_moment_x;
    w[21] = left_rod_origin_inertia_yy_plus_left_crank_base_inertia_yy;

    /* right.crank: base, inertia */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal right_crank_base_moment_x = right_crank_first_moment_x
        + right_rod_base_mass_moment_x;
    const wreal right_crank_base_inertia_yy = right_crank_origin_inertia_yy
        + right_crank_length * right_rod_base_mass_moment_x;
    const wreal right_rod_origin_inertia_yy_plus_right_crank_base_inertia_yy =
        right_rod_origin_inertia_yy + right_crank_base_inertia_yy;
    w[18] = right_crank_base_moment_x;
    w[22] = right_rod_origin_inertia_yy_plus_right_crank_base_inertia_yy;

    /* right.pin: twist */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    const wreal right_pin_twist_right_piston_vx = right_ground_rotation_angle2_cos *
        right_ground_rotation_angle2_cos
        + right_ground_rotation_angle2_sin * right_ground_rotation_angle2_sin;
    w[19] = right_pin_twist_right_piston_vx;

    /* left.pin: twist */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    const wreal left_pin_twist_left_piston_vx = left_ground_rotation_angle2_cos *
        left_ground_rotation_angle2_cos
        + left_ground_rotation_angle2_sin * left_ground_rotation_angle2_sin;
    w[20] = left_pin_twist_left_piston_vx;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal M_factor_D_inverse_left_piston = 1.0 / left_piston_mass;
    const wreal M_factor_D_inverse_left_rod = 1.0 / left_rod_origin_inertia_yy;
    const wreal M_factor_D_inverse_right_piston = 1.0 / right_piston_mass;
    const wreal M_factor_D_inverse_right_rod = 1.0 / right_rod_origin_inertia_yy;
    w[25] = M_factor_D_inverse_left_piston;
    w[26] = M_factor_D_inverse_left_rod;
    w[27] = M_factor_D_inverse_right_piston;
    w[28] = M_factor_D_inverse_right_rod;

    /* parameters as they are */
    w[0] = p[0]; /* right.crank_length [m] */
    w[1] = p[7]; /* left.crank_length [m] */
    w[2] = p[14]; /* gravity.z [m/s^2] */
}

#include "lanes.h"

/* udot with M udot + h = f + tau */
CARDAN_API int forward_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const real *const r = in->r;
    const wreal *const w = in->w;
    const real *const tau = in->tau;
    real (*const circuit_matrix)[5] = (real (*)[5])(work + 0);
    real *const circuit_right = work + 25;
    real *const circuit_scratch = work + 30;
    int status = CARDAN_OK;

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
    const real right_crank = q[0]; /* rad */
    const real right_rod = q[1]; /* rad */
    const real left_crank = q[3]; /* rad */
    const real left_rod = q[4]; /* rad */
    const wreal right_crank_minus_offset = w[15];
    const wreal left_crank_minus_offset = w[16];
    const real right_crank_angle = right_crank - right_crank_minus_offset;
    const real left_crank_angle = left_crank - left_crank_minus_offset;
    const real right_rod_minus_turn = right_rod + right_crank_angle;
    const real left_rod_minus_turn = left_rod + left_crank_angle;
    const real angle[CARDAN_PADDED(4)] = {right_crank_angle, left_crank_angle,
        right_rod_minus_turn, left_rod_minus_turn};
    real sine[CARDAN_PADDED(4)], cosine[CARDAN_PADDED(4)];
    cardan_sincos(4, angle, sine, cosine);
    const real right_crank_angle_cos = cosine[0];
    const real right_crank_angle_sin = sine[0];
    const real left_crank_angle_cos = cosine[1];
    const real left_crank_angle_sin = sine[1];
    const real right_rod_minus_turn_cos = cosine[2];
    const real right_rod_minus_turn_sin = sine[2];
    const real left_rod_minus_turn_cos = cosine[3];
    const real left_rod_minus_turn_sin = sine[3];

    /* right.rod: p */
    /* p = p_fixed + R_fixed p_joint(q) */
    const wreal right_crank_length = w[0]; /* m */
    const real right_rod_p_x = right_crank_length * right_crank_angle_cos;
    const real right_rod_p_z = right_crank_length * right_crank_angle_sin;

    /* right.piston: p, tau, drive */
    /* p = p_fixed + R_fixed p_joint(q) */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real right_piston = q[2]; /* m */
    const real right_force = r[1]; /* N */
    const real right_piston_u_tau = tau[2]; /* N */
    const wreal right_ground_rotation_angle2_cos = w[3];
    const wreal right_ground_rotation_angle2_sin = w[4];
    const wreal right_piston_place_x = w[7];
    const wreal right_piston_place_z = w[8];
    const wreal right_piston_f_x = w[23];
    const real right_piston_p_x = right_piston_place_x
        + right_ground_rotation_angle2_cos * right_piston;
    const real right_piston_p_z = right_piston_place_z
        - right_ground_rotation_angle2_sin * right_piston;
    const real right_piston_tau = right_piston_f_x - right_force;
    const real right_piston_drive = right_piston_u_tau - right_piston_tau;

    /* right.pin: pose, twist, G */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* G = d(rate) / du */
    const wreal right_pin_twist_right_piston_vx = w[19];
    const real right_pin_R_xx = right_ground_rotation_angle2_cos * right_rod_minus_turn_sin
        + right_ground_rotation_angle2_sin * right_rod_minus_turn_cos;
    const real right_pin_R_xz = right_ground_rotation_angle2_sin * right_rod_minus_turn_sin
        - right_ground_rotation_angle2_cos * right_rod_minus_turn_cos;
    const real right_pin_arm_right_rod_x = right_piston_p_x - right_rod_p_z;
    const real right_pin_arm_right_rod_z = right_rod_p_x + right_piston_p_z;
    const real right_pin_twist_right_crank_vx = right_ground_rotation_angle2_cos * right_piston_p_z
        + right_ground_rotation_angle2_sin * right_piston_p_x;
    const real right_pin_twist_right_crank_vz = right_ground_rotation_angle2_sin * right_piston_p_z
        - right_ground_rotation_angle2_cos * right_piston_p_x;
    const real right_pin_twist_right_rod_vx = right_ground_rotation_angle2_cos *
        right_pin_arm_right_rod_z + right_ground_rotation_angle2_sin * right_pin_arm_right_rod_x;
    const real right_pin_twist_right_rod_vz = right_ground_rotation_angle2_sin *
        right_pin_arm_right_rod_z - right_ground_rotation_angle2_cos * right_pin_arm_right_rod_x;
    const real right_pin_G_px_right_crank = right_pin_R_xx * right_pin_twist_right_crank_vx
        + right_pin_R_xz * right_pin_twist_right_crank_vz;
    const real right_pin_G_px_right_rod = right_pin_R_xx * right_pin_twist_right_rod_vx
        + right_pin_R_xz * right_pin_twist_right_rod_vz;
    const real right_pin_G_px_right_piston = right_pin_R_xx * right_pin_twist_right_piston_vx;
    const real right_pin_G_pz_right_crank = right_pin_R_xx * right_pin_twist_right_crank_vz
        - right_pin_R_xz * right_pin_twist_right_crank_vx;
    const real right_pin_G_pz_right_rod = right_pin_R_xx * right_pin_twist_right_rod_vz
        - right_pin_R_xz * right_pin_twist_right_rod_vx;
    const real right_pin_minus_G_pz_right_piston = right_pin_R_xz * right_pin_twist_right_piston_vx;

    /* shared by several: R, p, inertia */
    /* R = R_fixed R_joint(q) */
    /* p = p_fixed + R_fixed p_joint(q) */
    const real right_crank_u = u[0]; /* rad/s */
    const real right_rod_u = u[1]; /* rad/s */
    const real right_piston_u = u[2]; /* m/s */
    const real left_crank_u = u[3]; /* rad/s */
    const real left_rod_u = u[4]; /* rad/s */
    const real left_piston_u = u[5]; /* m/s */
    const wreal right_rod_first_moment_x = w[5];
    const wreal left_ground_rotation_angle2_cos = w[9];
    const wreal left_ground_rotation_angle2_sin = w[10];
    const real right_pin_base_twist_wy = right_crank_u + right_rod_u;
    const real right_pin_base_twist_by_right_piston_vx = right_ground_rotation_angle2_cos *
        right_piston_u;
    const real right_pin_minus_base_twist_by_right_piston_vz = right_ground_rotation_angle2_sin *
        right_piston_u;
    const real left_pin_base_twist_wy = left_crank_u + left_rod_u;
    const real left_pin_base_twist_by_left_piston_vx = left_ground_rotation_angle2_cos *
        left_piston_u;
    const real left_pin_minus_base_twist_by_left_piston_vz = left_ground_rotation_angle2_sin *
        left_piston_u;
    const real right_crank_inertia_shift_part = right_rod_first_moment_x * right_rod_minus_turn_cos
        * right_rod_p_x + right_rod_first_moment_x * right_rod_minus_turn_sin * right_rod_p_z;

    /* right.pin: twist */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    const real right_pin_base_twist_vx = right_crank_u * right_piston_p_z
        + right_pin_base_twist_by_right_piston_vx + right_rod_u * right_pin_arm_right_rod_z;
    const real right_pin_minus_base_twist_vz = right_crank_u * right_piston_p_x
        + right_pin_minus_base_twist_by_right_piston_vz + right_rod_u * right_pin_arm_right_rod_x;
    const real right_pin_twist_vx = right_ground_rotation_angle2_cos * right_pin_base_twist_vx
        + right_ground_rotation_angle2_sin * right_pin_minus_base_twist_vz;
    const real right_pin_twist_vz = right_ground_rotation_angle2_sin * right_pin_base_twist_vx
        - right_ground_rotation_angle2_cos * right_pin_minus_base_twist_vz;
    const real right_pin_minus_base_twist_vx_rate = right_crank_u *
        right_pin_minus_base_twist_by_right_piston_vz
        + right_rod_u * (right_pin_minus_base_twist_by_right_piston_vz
        + right_crank_u * right_crank_angle_sin * right_crank_length);
    const real right_pin_minus_base_twist_vz_rate = right_crank_u *
        right_pin_base_twist_by_right_piston_vx
        + right_rod_u * (right_pin_base_twist_by_right_piston_vx
        - right_crank_u * right_crank_angle_cos * right_crank_length);
    const real right_pin_twist_vx_rate = right_ground_rotation_angle2_sin *
        right_pin_minus_base_twist_vz_rate
        - right_ground_rotation_angle2_cos * right_pin_minus_base_twist_vx_rate;
    const real right_pin_minus_twist_vz_rate = right_ground_rotation_angle2_sin *
        right_pin_minus_base_twist_vx_rate
        + right_ground_rotation_angle2_cos * right_pin_minus_base_twist_vz_rate;

    /* left.rod: p, inertia force, R */
    /* p = p_fixed + R_fixed p_joint(q) */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    /* R = R_fixed R_joint(q) */
    const wreal left_crank_length = w[1]; /* m */
    const wreal left_rod_first_moment_x = w[11];
    const real left_rod_p_x = left_crank_length * left_crank_angle_cos;
    const real left_rod_p_z = left_crank_length * left_crank_angle_sin;
    const real left_rod_minus_f_x = left_pin_base_twist_wy * left_pin_base_twist_wy *
        left_rod_first_moment_x;
    const real left_rod_minus_turn_sin_times_left_pin_base_twist_wy = left_rod_minus_turn_sin *
        left_pin_base_twist_wy;
    const real left_rod_minus_turn_cos_times_left_pin_base_twist_wy = left_rod_minus_turn_cos *
        left_pin_base_twist_wy;

    /* left.piston: p, tau, drive */
    /* p = p_fixed + R_fixed p_joint(q) */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real left_piston = q[5]; /* m */
    const real left_force = r[3]; /* N */
    const real left_piston_u_tau = tau[5]; /* N */
    const wreal left_piston_place_x = w[13];
    const wreal left_piston_place_z = w[14];
    const wreal left_piston_f_x = w[24];
    const real left_piston_p_x = left_piston_place_x
        + left_ground_rotation_angle2_cos * left_piston;
    const real left_piston_p_z = left_piston_place_z
        - left_ground_rotation_angle2_sin * left_piston;
    const real left_piston_tau = left_piston_f_x - left_force;
    const real left_piston_drive = left_piston_u_tau - left_piston_tau;

    /* left.pin: pose, twist, G, gamma */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* G = d(rate) / du */
    /* gamma = -d(rate)/dt at udot = 0 */
    const wreal left_pin_twist_left_piston_vx = w[20];
    const real left_pin_R_xx = left_ground_rotation_angle2_cos * left_rod_minus_turn_sin
        + left_ground_rotation_angle2_sin * left_rod_minus_turn_cos;
    const real left_pin_R_xz = left_ground_rotation_angle2_sin * left_rod_minus_turn_sin
        - left_ground_rotation_angle2_cos * left_rod_minus_turn_cos;
    const real left_pin_arm_left_rod_x = left_piston_p_x - left_rod_p_z;
    const real left_pin_arm_left_rod_z = left_rod_p_x + left_piston_p_z;
    const real left_pin_base_twist_vx = left_crank_u * left_piston_p_z
        + left_pin_base_twist_by_left_piston_vx + left_rod_u * left_pin_arm_left_rod_z;
    const real left_pin_minus_base_twist_vz = left_crank_u * left_piston_p_x
        + left_pin_minus_base_twist_by_left_piston_vz + left_rod_u * left_pin_arm_left_rod_x;
    const real left_pin_twist_left_crank_vx = left_ground_rotation_angle2_cos * left_piston_p_z
        + left_ground_rotation_angle2_sin * left_piston_p_x;
    const real left_pin_twist_left_crank_vz = left_ground_rotation_angle2_sin * left_piston_p_z
        - left_ground_rotation_angle2_cos * left_piston_p_x;
    const real left_pin_twist_left_rod_vx = left_ground_rotation_angle2_cos *
        left_pin_arm_left_rod_z + left_ground_rotation_angle2_sin * left_pin_arm_left_rod_x;
    const real left_pin_twist_left_rod_vz = left_ground_rotation_angle2_sin *
        left_pin_arm_left_rod_z - left_ground_rotation_angle2_cos * left_pin_arm_left_rod_x;
    const real left_pin_twist_vx = left_ground_rotation_angle2_cos * left_pin_base_twist_vx
        + left_ground_rotation_angle2_sin * left_pin_minus_base_twist_vz;
    const real left_pin_twist_vz = left_ground_rotation_angle2_sin * left_pin_base_twist_vx
        - left_ground_rotation_angle2_cos * left_pin_minus_base_twist_vz;
    const real left_pin_G_px_left_crank = left_pin_R_xx * left_pin_twist_left_crank_vx
        + left_pin_R_xz * left_pin_twist_left_crank_vz;
    const real left_pin_G_px_left_rod = left_pin_R_xx * left_pin_twist_left_rod_vx
        + left_pin_R_xz * left_pin_twist_left_rod_vz;
    const real left_pin_G_px_left_piston = left_pin_R_xx * left_pin_twist_left_piston_vx;
    const real left_pin_G_pz_left_crank = left_pin_R_xx * left_pin_twist_left_crank_vz
        - left_pin_R_xz * left_pin_twist_left_crank_vx;
    const real left_pin_G_pz_left_rod = left_pin_R_xx * left_pin_twist_left_rod_vz
        - left_pin_R_xz * left_pin_twist_left_rod_vx;
    const real left_pin_minus_G_pz_left_piston = left_pin_R_xz * left_pin_twist_left_piston_vx;
    const real left_pin_R_xx_rate = left_ground_rotation_angle2_cos *
        left_rod_minus_turn_cos_times_left_pin_base_twist_wy
        - left_ground_rotation_angle2_sin * left_rod_minus_turn_sin_times_left_pin_base_twist_wy;
    const real left_pin_R_xz_rate = left_ground_rotation_angle2_sin *
        left_rod_minus_turn_cos_times_left_pin_base_twist_wy
        + left_ground_rotation_angle2_cos * left_rod_minus_turn_sin_times_left_pin_base_twist_wy;
    const real left_pin_minus_base_twist_vx_rate = left_crank_u *
        left_pin_minus_base_twist_by_left_piston_vz
        + left_rod_u * (left_pin_minus_base_twist_by_left_piston_vz
        + left_crank_u * left_crank_angle_sin * left_crank_length);
    const real left_pin_minus_base_twist_vz_rate = left_crank_u *
        left_pin_base_twist_by_left_piston_vx
        + left_rod_u * (left_pin_base_twist_by_left_piston_vx
        - left_crank_u * left_crank_angle_cos * left_crank_length);
    const real left_pin_twist_vx_rate = left_ground_rotation_angle2_sin *
        left_pin_minus_base_twist_vz_rate
        - left_ground_rotation_angle2_cos * left_pin_minus_base_twist_vx_rate;
    const real left_pin_minus_twist_vz_rate = left_ground_rotation_angle2_sin *
        left_pin_minus_base_twist_vx_rate
        + left_ground_rotation_angle2_cos * left_pin_minus_base_twist_vz_rate;
    const real left_pin_gamma_px = left_pin_R_xz * left_pin_minus_twist_vz_rate
        - left_pin_R_xx * left_pin_twist_vx_rate - (left_pin_twist_vx * left_pin_R_xx_rate
        + left_pin_twist_vz * left_pin_R_xz_rate);
    const real left_pin_gamma_pz = left_pin_twist_vx * left_pin_R_xz_rate
        - left_pin_twist_vz * left_pin_R_xx_rate + (left_pin_R_xz * left_pin_twist_vx_rate
        + left_pin_R_xx * left_pin_minus_twist_vz_rate);

    /* shared by several: inertia */
    const real left_crank_inertia_shift_part = left_rod_first_moment_x * left_rod_minus_turn_cos *
        left_rod_p_x + left_rod_first_moment_x * left_rod_minus_turn_sin * left_rod_p_z;

    /* left.crank: composite, U */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* U = [alpha] + [omega][omega] */
    const wreal left_rod_origin_inertia_yy_plus_left_crank_base_inertia_yy = w[21];
    const real left_crank_composite_inertia_yy = 2.0 * left_crank_inertia_shift_part
        + left_rod_origin_inertia_yy_plus_left_crank_base_inertia_yy;
    const real left_crank_minus_U_xx = left_crank_u * left_crank_u;

    /* right.crank: composite, U */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* U = [alpha] + [omega][omega] */
    const wreal right_rod_origin_inertia_yy_plus_right_crank_base_inertia_yy = w[22];
    const real right_crank_composite_inertia_yy = 2.0 * right_crank_inertia_shift_part
        + right_rod_origin_inertia_yy_plus_right_crank_base_inertia_yy;
    const real right_crank_minus_U_xx = right_crank_u * right_crank_u;

    /* M */
    /* M = S . momentum */
    const wreal right_rod_origin_inertia_yy = w[6];
    const wreal left_rod_origin_inertia_yy = w[12];
    const real M_left_rod_left_crank = left_rod_origin_inertia_yy + left_crank_inertia_shift_part;
    const real M_right_rod_right_crank = right_rod_origin_inertia_yy
        + right_crank_inertia_shift_part;

    /* right.rod: n, inertia force, drive, R */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    /* drive = tau + f - h */
    /* R = R_fixed R_joint(q) */
    const real right_rod_u_tau = tau[1]; /* N*m */
    const wreal gravity_z = w[2]; /* m/s^2 */
    const real right_rod_n_y = right_rod_first_moment_x * (right_rod_minus_turn_sin * (gravity_z
        - right_rod_p_x * right_crank_minus_U_xx)
        + right_rod_p_z * right_crank_minus_U_xx * right_rod_minus_turn_cos);
    const real right_rod_minus_f_x = right_pin_base_twist_wy * right_pin_base_twist_wy *
        right_rod_first_moment_x;
    const real right_rod_drive = right_rod_u_tau + right_rod_n_y;
    const real right_rod_minus_turn_sin_times_right_pin_base_twist_wy = right_rod_minus_turn_sin *
        right_pin_base_twist_wy;
    const real right_rod_minus_turn_cos_times_right_pin_base_twist_wy = right_rod_minus_turn_cos *
        right_pin_base_twist_wy;

    /* left.rod: n, drive */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* drive = tau + f - h */
    const real left_rod_u_tau = tau[4]; /* N*m */
    const real left_rod_n_y = left_rod_first_moment_x * (left_rod_minus_turn_sin * (gravity_z
        - left_rod_p_x * left_crank_minus_U_xx)
        + left_rod_p_z * left_crank_minus_U_xx * left_rod_minus_turn_cos);
    const real left_rod_drive = left_rod_u_tau + left_rod_n_y;

    /* left.crank: n, drive */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* drive = tau + f - h */
    const real left_torque = r[2]; /* N m */
    const real left_crank_u_tau = tau[3]; /* N*m */
    const wreal left_crank_base_moment_x = w[17];
    const real left_crank_n_y = left_crank_base_moment_x * left_crank_angle_sin * gravity_z
        + left_rod_minus_turn_sin * left_rod_minus_f_x * left_rod_p_x
        - left_rod_minus_turn_cos * left_rod_minus_f_x * left_rod_p_z + left_rod_n_y;
    const real left_crank_drive = left_torque + left_crank_u_tau + left_crank_n_y;

    /* right.crank: n, drive */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* drive = tau + f - h */
    const real right_torque = r[0]; /* N m */
    const real right_crank_u_tau = tau[0]; /* N*m */
    const wreal right_crank_base_moment_x = w[18];
    const real right_crank_n_y = right_crank_base_moment_x * right_crank_angle_sin * gravity_z
        + right_rod_minus_turn_sin * right_rod_minus_f_x * right_rod_p_x
        - right_rod_minus_turn_cos * right_rod_minus_f_x * right_rod_p_z + right_rod_n_y;
    const real right_crank_drive = right_torque + right_crank_u_tau + right_crank_n_y;

    /* right.pin: pose, gamma */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* gamma = -d(rate)/dt at udot = 0 */
    const real right_pin_R_xx_rate = right_ground_rotation_angle2_cos *
        right_rod_minus_turn_cos_times_right_pin_base_twist_wy
        - right_ground_rotation_angle2_sin * right_rod_minus_turn_sin_times_right_pin_base_twist_wy;
    const real right_pin_R_xz_rate = right_ground_rotation_angle2_sin *
        right_rod_minus_turn_cos_times_right_pin_base_twist_wy
        + right_ground_rotation_angle2_cos * right_rod_minus_turn_sin_times_right_pin_base_twist_wy;
    const real right_pin_gamma_px = right_pin_R_xz * right_pin_minus_twist_vz_rate
        - right_pin_R_xx * right_pin_twist_vx_rate - (right_pin_twist_vx * right_pin_R_xx_rate
        + right_pin_twist_vz * right_pin_R_xz_rate);
    const real right_pin_gamma_pz = right_pin_twist_vx * right_pin_R_xz_rate
        - right_pin_twist_vz * right_pin_R_xx_rate + (right_pin_R_xz * right_pin_twist_vx_rate
        + right_pin_R_xx * right_pin_minus_twist_vz_rate);

    /* constraints: factor, multipliers */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const wreal M_factor_D_inverse_left_piston = w[25];
    const wreal M_factor_D_inverse_left_rod = w[26];
    const wreal M_factor_D_inverse_right_piston = w[27];
    const wreal M_factor_D_inverse_right_rod = w[28];
    const real M_factor_L_left_rod_left_crank = M_left_rod_left_crank * M_factor_D_inverse_left_rod;
    const real M_factor_D_inverse_left_crank = 1.0 / (left_crank_composite_inertia_yy
        - M_left_rod_left_crank * M_factor_L_left_rod_left_crank);
    const real M_factor_L_right_rod_right_crank = M_right_rod_right_crank *
        M_factor_D_inverse_right_rod;
    const real M_factor_D_inverse_right_crank = 1.0 / (right_crank_composite_inertia_yy
        - M_right_rod_right_crank * M_factor_L_right_rod_right_crank);
    const real free_udot_right_crank = M_factor_D_inverse_right_crank * (right_crank_drive
        - right_rod_drive * M_factor_L_right_rod_right_crank);
    const real free_udot_right_piston = right_piston_drive * M_factor_D_inverse_right_piston;
    const real free_udot_left_crank = M_factor_D_inverse_left_crank * (left_crank_drive
        - left_rod_drive * M_factor_L_left_rod_left_crank);
    const real free_udot_left_piston = left_piston_drive * M_factor_D_inverse_left_piston;
    const real free_udot_right_rod = right_rod_drive * M_factor_D_inverse_right_rod
        - M_factor_L_right_rod_right_crank * free_udot_right_crank;
    const real free_udot_left_rod = left_rod_drive * M_factor_D_inverse_left_rod
        - M_factor_L_left_rod_left_crank * free_udot_left_crank;
    const real right_pin_px_response_right_crank = M_factor_D_inverse_right_crank *
        (right_pin_G_px_right_crank - right_pin_G_px_right_rod * M_factor_L_right_rod_right_crank);
    circuit_matrix[0][4] = right_pin_px_response_right_crank;
    circuit_matrix[4][0] = right_pin_px_response_right_crank;
    const real right_pin_px_response_right_piston = right_pin_G_px_right_piston *
        M_factor_D_inverse_right_piston;
    const real right_pin_px_response_right_rod = right_pin_G_px_right_rod *
        M_factor_D_inverse_right_rod
        - M_factor_L_right_rod_right_crank * right_pin_px_response_right_crank;
    const real right_pin_pz_response_right_crank = M_factor_D_inverse_right_crank *
        (right_pin_G_pz_right_crank - right_pin_G_pz_right_rod * M_factor_L_right_rod_right_crank);
    circuit_matrix[1][4] = right_pin_pz_response_right_crank;
    circuit_matrix[4][1] = right_pin_pz_response_right_crank;
    const real right_pin_pz_minus_response_right_piston = right_pin_minus_G_pz_right_piston *
        M_factor_D_inverse_right_piston;
    const real right_pin_pz_response_right_rod = right_pin_G_pz_right_rod *
        M_factor_D_inverse_right_rod
        - M_factor_L_right_rod_right_crank * right_pin_pz_response_right_crank;
    const real left_pin_px_response_left_crank = M_factor_D_inverse_left_crank *
        (left_pin_G_px_left_crank - left_pin_G_px_left_rod * M_factor_L_left_rod_left_crank);
    const real left_pin_px_response_left_piston = left_pin_G_px_left_piston *
        M_factor_D_inverse_left_piston;
    const real left_pin_px_response_left_rod = left_pin_G_px_left_rod * M_factor_D_inverse_left_rod
        - M_factor_L_left_rod_left_crank * left_pin_px_response_left_crank;
    const real left_pin_pz_response_left_crank = M_factor_D_inverse_left_crank *
        (left_pin_G_pz_left_crank - left_pin_G_pz_left_rod * M_factor_L_left_rod_left_crank);
    const real left_pin_pz_minus_response_left_piston = left_pin_minus_G_pz_left_piston *
        M_factor_D_inverse_left_piston;
    const real left_pin_pz_response_left_rod = left_pin_G_pz_left_rod * M_factor_D_inverse_left_rod
        - M_factor_L_left_rod_left_crank * left_pin_pz_response_left_crank;
    const real circuit_right_pin_px_right_pin_px = right_pin_G_px_right_crank *
        right_pin_px_response_right_crank
        + right_pin_G_px_right_piston * right_pin_px_response_right_piston
        + right_pin_G_px_right_rod * right_pin_px_response_right_rod;
    circuit_matrix[0][0] = circuit_right_pin_px_right_pin_px;
    const real circuit_right_pin_pz_right_pin_px = right_pin_G_pz_right_crank *
        right_pin_px_response_right_crank
        - right_pin_minus_G_pz_right_piston * right_pin_px_response_right_piston
        + right_pin_G_pz_right_rod * right_pin_px_response_right_rod;
    circuit_matrix[0][1] = circuit_right_pin_pz_right_pin_px;
    circuit_matrix[1][0] = circuit_right_pin_pz_right_pin_px;
    const real circuit_right_pin_pz_right_pin_pz = right_pin_G_pz_right_crank *
        right_pin_pz_response_right_crank
        + right_pin_minus_G_pz_right_piston * right_pin_pz_minus_response_right_piston
        + right_pin_G_pz_right_rod * right_pin_pz_response_right_rod;
    circuit_matrix[1][1] = circuit_right_pin_pz_right_pin_pz;
    const real circuit_left_pin_px_left_pin_px = left_pin_G_px_left_crank *
        left_pin_px_response_left_crank
        + left_pin_G_px_left_piston * left_pin_px_response_left_piston
        + left_pin_G_px_left_rod * left_pin_px_response_left_rod;
    circuit_matrix[2][2] = circuit_left_pin_px_left_pin_px;
    const real circuit_left_pin_pz_left_pin_px = left_pin_G_pz_left_crank *
        left_pin_px_response_left_crank
        - left_pin_minus_G_pz_left_piston * left_pin_px_response_left_piston
        + left_pin_G_pz_left_rod * left_pin_px_response_left_rod;
    circuit_matrix[2][3] = circuit_left_pin_pz_left_pin_px;
    circuit_matrix[3][2] = circuit_left_pin_pz_left_pin_px;
    const real circuit_left_pin_pz_left_pin_pz = left_pin_G_pz_left_crank *
        left_pin_pz_response_left_crank
        + left_pin_minus_G_pz_left_piston * left_pin_pz_minus_response_left_piston
        + left_pin_G_pz_left_rod * left_pin_pz_response_left_rod;
    circuit_matrix[3][3] = circuit_left_pin_pz_left_pin_pz;
    const real circuit_shaft_left_pin_px = -left_pin_px_response_left_crank;
    circuit_matrix[2][4] = circuit_shaft_left_pin_px;
    circuit_matrix[4][2] = circuit_shaft_left_pin_px;
    const real circuit_shaft_left_pin_pz = -left_pin_pz_response_left_crank;
    circuit_matrix[3][4] = circuit_shaft_left_pin_pz;
    circuit_matrix[4][3] = circuit_shaft_left_pin_pz;
    const real circuit_shaft_shaft = M_factor_D_inverse_left_crank + M_factor_D_inverse_right_crank;
    circuit_matrix[4][4] = circuit_shaft_shaft;
    const real free_gamma_right_pin_px = right_pin_gamma_px
        - right_pin_G_px_right_piston * free_udot_right_piston
        - right_pin_G_px_right_crank * free_udot_right_crank
        - right_pin_G_px_right_rod * free_udot_right_rod;
    circuit_right[0] = free_gamma_right_pin_px;
    const real free_gamma_right_pin_pz = right_pin_gamma_pz
        + right_pin_minus_G_pz_right_piston * free_udot_right_piston
        - right_pin_G_pz_right_crank * free_udot_right_crank
        - right_pin_G_pz_right_rod * free_udot_right_rod;
    circuit_right[1] = free_gamma_right_pin_pz;
    const real free_gamma_left_pin_px = left_pin_gamma_px
        - left_pin_G_px_left_piston * free_udot_left_piston
        - left_pin_G_px_left_crank * free_udot_left_crank
        - left_pin_G_px_left_rod * free_udot_left_rod;
    circuit_right[2] = free_gamma_left_pin_px;
    const real free_gamma_left_pin_pz = left_pin_gamma_pz
        + left_pin_minus_G_pz_left_piston * free_udot_left_piston
        - left_pin_G_pz_left_crank * free_udot_left_crank
        - left_pin_G_pz_left_rod * free_udot_left_rod;
    circuit_right[3] = free_gamma_left_pin_pz;
    const real free_gamma_shaft = free_udot_left_crank - free_udot_right_crank;
    circuit_right[4] = free_gamma_shaft;
    circuit_matrix[0][2] = CARDAN_REAL(0.0);
    circuit_matrix[0][3] = CARDAN_REAL(0.0);
    circuit_matrix[1][2] = CARDAN_REAL(0.0);
    circuit_matrix[1][3] = CARDAN_REAL(0.0);
    circuit_matrix[2][0] = CARDAN_REAL(0.0);
    circuit_matrix[2][1] = CARDAN_REAL(0.0);
    circuit_matrix[3][0] = CARDAN_REAL(0.0);
    circuit_matrix[3][1] = CARDAN_REAL(0.0);
    /* circuit_matrix lam = circuit_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 5, 1, circuit_matrix[0], circuit_right, circuit_scratch);

    /* right.pin: multiplier px, multiplier pz */
    const real right_pin_multiplier_px = circuit_right[0];
    const real right_pin_multiplier_pz = circuit_right[1];

    /* left.pin: multiplier px, multiplier pz */
    const real left_pin_multiplier_px = circuit_right[2];
    const real left_pin_multiplier_pz = circuit_right[3];

    /* shaft: multiplier */
    const real shaft_multiplier = circuit_right[4];

    /* right.crank: udot */
    /* udot = free_udot + response multipliers */
    /* udot: right.crank.udot [rad/s^2] */
    out[0] = free_udot_right_crank + right_pin_px_response_right_crank * right_pin_multiplier_px
        + (right_pin_pz_response_right_crank * right_pin_multiplier_pz
        + M_factor_D_inverse_right_crank * shaft_multiplier);

    /* right.rod: udot */
    /* udot = free_udot + response multipliers */
    /* udot: right.rod.udot [rad/s^2] */
    out[1] = free_udot_right_rod + right_pin_px_response_right_rod * right_pin_multiplier_px
        + (right_pin_pz_response_right_rod * right_pin_multiplier_pz
        - M_factor_L_right_rod_right_crank * M_factor_D_inverse_right_crank * shaft_multiplier);

    /* right.piston: udot */
    /* udot = free_udot + response multipliers */
    /* udot: right.piston.udot [m/s^2] */
    out[2] = free_udot_right_piston
        + right_pin_px_response_right_piston * right_pin_multiplier_px
        - right_pin_pz_minus_response_right_piston * right_pin_multiplier_pz;

    /* left.crank: udot */
    /* udot = free_udot + response multipliers */
    /* udot: left.crank.udot [rad/s^2] */
    out[3] = free_udot_left_crank + left_pin_px_response_left_crank * left_pin_multiplier_px
        + (left_pin_pz_response_left_crank * left_pin_multiplier_pz
        - M_factor_D_inverse_left_crank * shaft_multiplier);

    /* left.rod: udot */
    /* udot = free_udot + response multipliers */
    /* udot: left.rod.udot [rad/s^2] */
    out[4] = free_udot_left_rod + left_pin_px_response_left_rod * left_pin_multiplier_px
        + (left_pin_pz_response_left_rod * left_pin_multiplier_pz
        + M_factor_L_left_rod_left_crank * M_factor_D_inverse_left_crank * shaft_multiplier);

    /* left.piston: udot */
    /* udot = free_udot + response multipliers */
    /* udot: left.piston.udot [m/s^2] */
    out[5] = free_udot_left_piston + left_pin_px_response_left_piston * left_pin_multiplier_px
        - left_pin_pz_minus_response_left_piston * left_pin_multiplier_pz;
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {6, 55, 29, 0, 6, 6, 0, 0, 4, 18, 0, 0, 0, 0, 6, 0, 0, 0, 0, 0};
#endif
