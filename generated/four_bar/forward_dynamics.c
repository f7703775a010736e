/*
 * forward_dynamics of four_bar
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: parallel, base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 3, work 13, w 11
 * Operations per call: 233 = 139 mul, 43 add, 43 sub, 3 cos, 3 sin, 1 div, 1 solve
 * Operations of prepare: 19 = 11 mul, 6 add, 2 div
 *
 * Input q (3): generalized coordinates
 *   q[0]  A [rad]
 *   q[1]  B [rad]
 *   q[2]  D [rad]
 *
 * Input u (3): generalized speeds
 *   u[0]  A.u [rad/s]
 *   u[1]  B.u [rad/s]
 *   u[2]  D.u [rad/s]
 *
 * Input p (20): parameters, read by prepare_ only
 *
 * Input tau (3): applied generalized forces
 *   tau[0]  A.u.tau [N*m]
 *   tau[1]  B.u.tau [N*m]
 *   tau[2]  D.u.tau [N*m]
 *
 * Output udot (3)
 *   out[0]  A.udot [rad/s^2]
 *   out[1]  B.udot [rad/s^2]
 *   out[2]  D.udot [rad/s^2]
 */
#include "cardan.h"
#include "solve.h"
#include "dependent.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* crank: first moment, inertia, base moment, base inertia */
    const wreal crank_mass = p[1]; /* kg */
    const wreal crank_com_x = p[2]; /* m */
    const wreal crank_inertia_zz = p[5]; /* kg m^2 */
    const wreal B_position_x = p[6]; /* m */
    const wreal coupler_mass = p[7]; /* kg */
    const wreal crank_first_moment_x = crank_mass * crank_com_x;
    const wreal crank_inertia_zz_2 = crank_inertia_zz + crank_com_x * crank_first_moment_x;
    const wreal crank_base_inertia_zz = crank_inertia_zz_2
        + 0.5 * coupler_mass * B_position_x * B_position_x * 2.0;
    w[7] = crank_first_moment_x + B_position_x * coupler_mass; /* crank_base_moment_x */

    /* coupler: first moment, inertia */
    const wreal coupler_com_x = p[8]; /* m */
    const wreal coupler_inertia_zz = p[11]; /* kg m^2 */
    const wreal coupler_first_moment_x = coupler_mass * coupler_com_x;
    const wreal coupler_inertia_zz_2 = coupler_inertia_zz + coupler_com_x * coupler_first_moment_x;
    w[2] = coupler_first_moment_x; /* coupler_first_moment_x */
    w[3] = coupler_inertia_zz_2; /* coupler_inertia_zz_2 */

    /* rocker: first moment, inertia */
    const wreal rocker_mass = p[13]; /* kg */
    const wreal rocker_com_x = p[14]; /* m */
    const wreal rocker_inertia_zz = p[17]; /* kg m^2 */
    const wreal rocker_first_moment_x = rocker_mass * rocker_com_x;
    const wreal rocker_inertia_zz_2 = rocker_inertia_zz + rocker_com_x * rocker_first_moment_x;
    w[5] = rocker_first_moment_x; /* rocker_first_moment_x */

    /* crank: inertia */
    w[8] = coupler_inertia_zz_2 + crank_base_inertia_zz; /* crank_inertia */

    /* constraints: D inverse */
    w[9] = 1.0 / rocker_inertia_zz_2; /* constraints_D_inverse_3 */
    w[10] = 1.0 / coupler_inertia_zz_2; /* constraints_D_inverse_2 */

    /* parameters as they are */
    w[0] = p[0]; /* gravity.y [m/s^2] */
    w[1] = p[6]; /* B.position.x [m] */
    w[4] = p[12]; /* D.position.x [m] */
    w[6] = p[19]; /* C.child.position.x [m] */
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
    int status = CARDAN_OK;

    /* shared by several: R, cos, sin */
    const real A_q = q[0]; /* rad */
    const real B_q = q[1]; /* rad */
    const real D_q = q[2]; /* rad */
    const real B_R = A_q + B_q;
    const real angle[CARDAN_PADDED(3)] = {A_q, B_R, D_q};
    real sine[CARDAN_PADDED(3)], cosine[CARDAN_PADDED(3)];
    cardan_sincos(3, angle, sine, cosine);
    const real A_cos = cosine[0];
    const real A_sin = sine[0];
    const real B_cos = cosine[1];
    const real B_sin = sine[1];
    const real D_cos = cosine[2];
    const real D_sin = sine[2];

    /* B: p */
    const wreal B_position_x = w[1]; /* m */
    const real B_p_x = B_position_x * A_cos;
    const real B_p_y = B_position_x * A_sin;

    /* C: pose, twist, G */
    const real A_u = u[0]; /* rad/s */
    const real B_u = u[1]; /* rad/s */
    const real D_u = u[2]; /* rad/s */
    const wreal D_position_x = w[4]; /* m */
    const wreal C_child_position_x = w[6]; /* m */
    const real C_pose = C_child_position_x * D_sin;
    const real C_pose_2 = D_position_x + C_child_position_x * D_cos;
    const real C_pose_3 = B_cos * D_cos + B_sin * D_sin;
    const real C_pose_4 = B_sin * D_cos - B_cos * D_sin;
    const real C_twist = C_pose_2 - B_p_x;
    const real C_twist_2 = C_pose - B_p_y;
    const real C_twist_3 = C_pose_2 - D_position_x;
    const real C_twist_4 = A_u * C_pose - D_u * C_pose + B_u * C_twist_2;
    const real C_twist_5 = D_u * C_twist_3 - A_u * C_pose_2 - B_u * C_twist;
    const real C_twist_6 = D_cos * C_pose;
    const real C_twist_7 = C_twist_6 - D_sin * C_pose_2;
    const real C_twist_8 = D_sin * C_pose;
    const real C_twist_9 = C_twist_8 + D_cos * C_pose_2;
    const real C_twist_10 = D_cos * C_twist_2 - D_sin * C_twist;
    const real C_twist_11 = D_sin * C_twist_2 + D_cos * C_twist;
    const real C_twist_12 = D_sin * C_twist_3 - C_twist_6;
    const real C_twist_13 = C_twist_8 + D_cos * C_twist_3;
    const real C_twist_14 = D_cos * C_twist_4 + D_sin * C_twist_5;
    const real C_twist_15 = D_cos * C_twist_5 - D_sin * C_twist_4;
    const real C_G = C_pose_3 * C_twist_7 - C_pose_4 * C_twist_9;
    const real C_G_2 = C_pose_3 * C_twist_10 - C_pose_4 * C_twist_11;
    const real C_G_3 = C_pose_3 * C_twist_12 + C_pose_4 * C_twist_13;
    const real C_G_4 = C_pose_4 * C_twist_7 + C_pose_3 * C_twist_9;
    const real C_G_5 = C_pose_4 * C_twist_10 + C_pose_3 * C_twist_11;
    const real C_G_6 = C_pose_3 * C_twist_13 - C_pose_4 * C_twist_12;

    /* coupler: omega, inertia force */
    const wreal coupler_first_moment_x = w[2];
    const real coupler_omega_z = A_u + B_u;
    const real coupler_inertia_force = coupler_omega_z * coupler_omega_z * coupler_first_moment_x;

    /* shared by several: inertia */
    const real crank_inertia_2 = coupler_first_moment_x * B_cos * B_p_x
        + coupler_first_moment_x * B_sin * B_p_y;

    /* crank: composite inertia, U, n */
    const wreal gravity_y = w[0]; /* m/s^2 */
    const wreal crank_base_moment_x = w[7];
    const wreal crank_inertia = w[8];
    const real crank_composite_inertia_zz = 2.0 * crank_inertia_2 + crank_inertia;
    const real crank_U = A_u * A_u;
    const real crank_n = B_cos * coupler_inertia_force * B_p_y
        - crank_base_moment_x * A_cos * gravity_y - B_sin * coupler_inertia_force * B_p_x;

    /* M */
    const wreal coupler_inertia_zz_2 = w[3];
    const real M_2_1 = coupler_inertia_zz_2 + crank_inertia_2;

    /* coupler: a, n */
    const real coupler_a_y = B_p_x * crank_U * B_sin - B_cos * (gravity_y + B_p_y * crank_U);
    const real coupler_n_z = coupler_first_moment_x * coupler_a_y;

    /* crank: n */
    const real crank_n_z = coupler_n_z + crank_n;

    /* A: drive */
    const real A_u_tau = tau[0]; /* N*m */
    const real A_drive = A_u_tau - crank_n_z;

    /* B: drive */
    const real B_u_tau = tau[1]; /* N*m */
    const real B_drive = B_u_tau - coupler_n_z;

    /* D: drive */
    const real D_u_tau = tau[2]; /* N*m */
    const wreal rocker_first_moment_x = w[5];
    const real D_drive = D_u_tau + gravity_y * D_cos * rocker_first_moment_x;

    /* constraints: multipliers, L, D inverse */
    const wreal constraints_D_inverse_3 = w[9];
    const wreal constraints_D_inverse_2 = w[10];
    const real constraints_multipliers = B_sin * coupler_omega_z;
    const real constraints_multipliers_2 = B_cos * coupler_omega_z;
    const real constraints_multipliers_3 = D_u * D_sin;
    const real constraints_multipliers_4 = D_u * D_cos;
    const real constraints_multipliers_5 = C_child_position_x * constraints_multipliers_3;
    const real constraints_multipliers_6 = C_child_position_x * constraints_multipliers_4;
    const real constraints_multipliers_7 = B_sin * constraints_multipliers_4
        - B_cos * constraints_multipliers_3;
    const real constraints_multipliers_8 = D_sin * constraints_multipliers_2
        - D_cos * constraints_multipliers + constraints_multipliers_7;
    const real constraints_multipliers_9 = D_sin * constraints_multipliers
        + D_cos * constraints_multipliers_2;
    const real constraints_multipliers_10 = constraints_multipliers_9
        - (B_cos * constraints_multipliers_4 + B_sin * constraints_multipliers_3);
    const real constraints_multipliers_11 = A_u * constraints_multipliers_6
        - D_u * constraints_multipliers_6;
    const real constraints_multipliers_12 = B_u * (constraints_multipliers_6
        - A_u * A_cos * B_position_x) + constraints_multipliers_11;
    const real constraints_multipliers_13 = D_u * constraints_multipliers_5
        - A_u * constraints_multipliers_5;
    const real constraints_multipliers_14 = B_u * (A_u * A_sin * B_position_x
        - constraints_multipliers_5) + constraints_multipliers_13;
    const real constraints_multipliers_15 = D_cos * constraints_multipliers_12
        - C_twist_4 * constraints_multipliers_3;
    const real constraints_multipliers_16 = C_twist_5 * constraints_multipliers_4
        - D_sin * constraints_multipliers_14 + constraints_multipliers_15;
    const real constraints_multipliers_17 = C_twist_4 * constraints_multipliers_4
        + D_sin * constraints_multipliers_12;
    const real constraints_multipliers_18 = C_twist_5 * constraints_multipliers_3
        + D_cos * constraints_multipliers_14 + constraints_multipliers_17;
    const real constraints_L_2_1 = M_2_1 * constraints_D_inverse_2;
    const real constraints_D_inverse_1 = 1.0 / (crank_composite_inertia_zz
        - M_2_1 * constraints_L_2_1);
    const real constraints_multipliers_19 = constraints_D_inverse_1 * (A_drive
        - B_drive * constraints_L_2_1);
    const real constraints_multipliers_20 = D_drive * constraints_D_inverse_3;
    const real constraints_multipliers_21 = B_drive * constraints_D_inverse_2
        - constraints_L_2_1 * constraints_multipliers_19;
    const real constraints_multipliers_22 = constraints_D_inverse_1 * (C_G
        - C_G_2 * constraints_L_2_1);
    const real constraints_multipliers_23 = C_G_3 * constraints_D_inverse_3;
    const real constraints_multipliers_24 = C_G_2 * constraints_D_inverse_2
        - constraints_L_2_1 * constraints_multipliers_22;
    const real constraints_multipliers_25 = constraints_D_inverse_1 * (C_G_5 * constraints_L_2_1
        - C_G_4);
    const real constraints_multipliers_26 = C_G_6 * constraints_D_inverse_3;
    const real constraints_multipliers_27 = C_G_5 * constraints_D_inverse_2
        + constraints_L_2_1 * constraints_multipliers_25;
    const real constraints_multipliers_28 = C_G * constraints_multipliers_22
        + C_G_3 * constraints_multipliers_23 + C_G_2 * constraints_multipliers_24;
    work[0] = constraints_multipliers_28;
    const real constraints_multipliers_29 = C_G_6 * constraints_multipliers_23
        - C_G_4 * constraints_multipliers_22 - C_G_5 * constraints_multipliers_24;
    work[1] = constraints_multipliers_29;
    work[2] = constraints_multipliers_29;
    const real constraints_multipliers_30 = C_G_6 * constraints_multipliers_26
        - C_G_4 * constraints_multipliers_25 + C_G_5 * constraints_multipliers_27;
    work[3] = constraints_multipliers_30;
    const real constraints_multipliers_31 = C_pose_4 * constraints_multipliers_18
        - (C_twist_14 * constraints_multipliers_8 + C_G_3 * constraints_multipliers_20);
    const real constraints_multipliers_32 = constraints_multipliers_31
        - (C_pose_3 * constraints_multipliers_16 + C_twist_15 * constraints_multipliers_10);
    const real constraints_multipliers_33 = constraints_multipliers_32
        - C_G * constraints_multipliers_19 - C_G_2 * constraints_multipliers_21;
    work[4] = constraints_multipliers_33;
    const real constraints_multipliers_34 = C_pose_4 * constraints_multipliers_16
        - (C_twist_15 * constraints_multipliers_8 + C_G_6 * constraints_multipliers_20);
    const real constraints_multipliers_35 = C_twist_14 * constraints_multipliers_10
        + C_pose_3 * constraints_multipliers_18 + constraints_multipliers_34;
    const real constraints_multipliers_36 = C_G_4 * constraints_multipliers_19
        + constraints_multipliers_35 + C_G_5 * constraints_multipliers_21;
    work[5] = constraints_multipliers_36;
    status |= CARDAN_SOLVE(semidefinite, 2, 1, work + 0, work + 4, work + 6);

    /* C: multiplier px, multiplier py */
    const real C_multiplier_px = work[4];
    const real C_multiplier_py = work[5];

    /* A: udot */
    /* udot: A.udot [rad/s^2] */
    out[0] = constraints_multipliers_19 + constraints_multipliers_22 * C_multiplier_px
        + constraints_multipliers_25 * C_multiplier_py;

    /* B: udot */
    /* udot: B.udot [rad/s^2] */
    out[1] = constraints_multipliers_21 + constraints_multipliers_24 * C_multiplier_px
        - constraints_multipliers_27 * C_multiplier_py;

    /* D: udot */
    /* udot: D.udot [rad/s^2] */
    out[2] = constraints_multipliers_20 + constraints_multipliers_23 * C_multiplier_px
        + constraints_multipliers_26 * C_multiplier_py;
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {3, 13, 11, 0, 3, 3, 0, 0, 0, 20, 0, 0, 0, 0, 3, 0, 0, 0, 0};
#endif
