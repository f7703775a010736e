/*
 * linked_inertia_tree__balance
 * Mass of the cubic through both ends along their tangents, and of rotations between them
 * b = (tau_1; f_1; tau_2; f_2)
 * Source: Archer, J. Structural Division ASCE 89 (1963); Przemieniecki,
 *     Theory of Matrix Structural Analysis (1968), section 11.4,
 *     for small displacements; its finite form is our own
 * passes: reassociate
 *
 * Sizes: out 7, work 0, w 19
 * Operations per call: 142 = 76 mul, 38 sub, 26 add, 1 cos, 1 sin
 * Operations of prepare: 44 = 23 mul, 9 add, 9 div, 3 sub
 *
 * Input q (8): generalized coordinates
 *   q[0]  joint1 [rad]
 *   q[1]  node.qw
 *   q[2]  node.qx
 *   q[3]  node.qy
 *   q[4]  node.qz
 *   q[5]  node.px [m]
 *   q[6]  node.py [m]
 *   q[7]  node.pz [m]
 *
 * Input u (7): generalized speeds
 *   u[0]  joint1.u [rad/s]
 *   u[1]  node.u.x [rad/s]
 *   u[2]  node.u.y [rad/s]
 *   u[3]  node.u.z [rad/s]
 *   u[4]  node.u.px [m/s]
 *   u[5]  node.u.py [m/s]
 *   u[6]  node.u.pz [m/s]
 *
 * Input udot (7): derivatives of the speeds
 *   udot[0]  joint1.udot [rad/s^2]
 *   udot[1]  node.u.xdot [rad/s^2]
 *   udot[2]  node.u.ydot [rad/s^2]
 *   udot[3]  node.u.zdot [rad/s^2]
 *   udot[4]  node.u.pxdot [m/s^2]
 *   udot[5]  node.u.pydot [m/s^2]
 *   udot[6]  node.u.pzdot [m/s^2]
 *
 * Input p (11): parameters, read by prepare_ only
 *
 * Output balance (7)
 *   out[0]  joint1.u [N*m]
 *   out[1]  node.u.x [N*m]
 *   out[2]  node.u.y [N*m]
 *   out[3]  node.u.z [N*m]
 *   out[4]  node.u.px [N]
 *   out[5]  node.u.py [N]
 *   out[6]  node.u.pz [N]
 */
#include "cardan.h"

CARDAN_API void prepare_linked_inertia_tree__balance(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* energy */
    const wreal rhoA = p[0];
    const wreal rhoI2 = p[1];
    const wreal rhoI3 = p[2];
    const wreal EI2 = p[3];
    const wreal EI3 = p[4];
    const wreal GA2 = p[5];
    const wreal GA3 = p[6];
    const wreal length = p[10];
    const wreal mass = length * rhoA;
    const wreal share = 1.0 / (1.0 + 6.0 * (EI2 / GA3 + EI3 / GA2) / (length * length));
    const wreal share_squared = share * share;
    const wreal odd = share / 30.0 + 0.08333333333333333 + share_squared / 210.0;
    const wreal mixed = share / 120.0 + share_squared / 420.0;
    const wreal cubic = share_squared / 840.0;
    const wreal length_times_mass = length * mass;
    const wreal length_times_times_mass = length * length_times_mass;
    const wreal mass_pp = mass * (odd + 0.25);
    const wreal mass_pq = mass * (0.25 - odd);
    const wreal mass_pt = length_times_mass * (mixed + 0.041666666666666664);
    const wreal mass_pu = length_times_mass * (mixed - 0.041666666666666664);
    const wreal mass_tt = length_times_times_mass * (cubic + 0.008333333333333333);
    const wreal mass_tu = length_times_times_mass * (cubic - 0.008333333333333333);
    const wreal length_times_c0p3333333333333333 = 0.3333333333333333 * length;
    const wreal end_spin_y_by_u_node_u_y = length_times_c0p3333333333333333 * rhoI2;
    const wreal end_spin_z_by_u_node_u_z = length_times_c0p3333333333333333 * rhoI3;
    const wreal end_spin_x_by_u_node_u_x = end_spin_y_by_u_node_u_y + end_spin_z_by_u_node_u_z;
    w[3] = mass_pp;
    w[4] = mass_pt;
    w[5] = mass_pu;
    w[6] = mass_tt;
    w[7] = mass_tu;
    w[8] = end_spin_y_by_u_node_u_y;
    w[9] = end_spin_z_by_u_node_u_z;
    w[10] = end_spin_x_by_u_node_u_x;

    /* loads */
    const wreal gravity_1 = p[7];
    const wreal gravity_2 = p[8];
    const wreal gravity_3 = p[9];
    const wreal gravity_1_times_mass_pt = gravity_1 * mass_pt;
    const wreal gravity_3_times_mass_pt = gravity_3 * mass_pt;
    const wreal gravity_1_times_mass_pu = gravity_1 * mass_pu;
    const wreal gravity_2_times_mass_pu = gravity_2 * mass_pu;
    const wreal gravity_3_times_mass_pu = gravity_3 * mass_pu;
    const wreal gravity_1_times_mass_pq = gravity_1 * mass_pq;
    const wreal gravity_2_times_mass_pq = gravity_2 * mass_pq;
    const wreal gravity_3_times_mass_pq = gravity_3 * mass_pq;
    w[11] = gravity_1_times_mass_pt;
    w[12] = gravity_3_times_mass_pt;
    w[13] = gravity_1_times_mass_pu;
    w[14] = gravity_2_times_mass_pu;
    w[15] = gravity_3_times_mass_pu;
    w[16] = gravity_1_times_mass_pq;
    w[17] = gravity_2_times_mass_pq;
    w[18] = gravity_3_times_mass_pq;

    /* parameters as they are */
    w[0] = p[7]; /* gravity_1 */
    w[1] = p[8]; /* gravity_2 */
    w[2] = p[9]; /* gravity_3 */
}

#include "lanes.h"

/* Mass of the cubic through both ends along their tangents, and of rotations between them */
CARDAN_API int linked_inertia_tree__balance(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    const real *const udot = in->udot;
    (void)work;

    /* joint1: R */
    /* R = R_fixed R_joint(q) */
    const real joint1_q = q[0]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {joint1_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real joint1_cos = cosine[0];
    const real joint1_sin = sine[0];

    /* node: R, U */
    /* R = R_fixed R_joint(q) */
    /* U = [alpha] + [omega][omega] */
    const real node_qw = q[1];
    const real node_qx = q[2];
    const real node_qy = q[3];
    const real node_qz = q[4];
    const real node_u_x = u[1]; /* rad/s */
    const real node_u_y = u[2]; /* rad/s */
    const real node_u_z = u[3]; /* rad/s */
    const real node_u_ydot = udot[2]; /* rad/s^2 */
    const real node_u_zdot = udot[3]; /* rad/s^2 */
    const real twice_node_qx = 2.0 * node_qx;
    const real twice_node_qy = 2.0 * node_qy;
    const real twice_node_qz = 2.0 * node_qz;
    const real node_qw_times_twice_node_qx = node_qw * twice_node_qx;
    const real node_qw_times_twice_node_qy = node_qw * twice_node_qy;
    const real node_qw_times_twice_node_qz = node_qw * twice_node_qz;
    const real node_qx_times_twice_node_qy = node_qx * twice_node_qy;
    const real node_qx_times_twice_node_qz = node_qx * twice_node_qz;
    const real node_qy_times_twice_node_qy = node_qy * twice_node_qy;
    const real node_qy_times_twice_node_qz = node_qy * twice_node_qz;
    const real node_qz_times_twice_node_qz = node_qz * twice_node_qz;
    const real node_R_xx = 1.0 - node_qy_times_twice_node_qy - node_qz_times_twice_node_qz;
    const real node_R_xy = node_qx_times_twice_node_qy - node_qw_times_twice_node_qz;
    const real node_R_xz = node_qw_times_twice_node_qy + node_qx_times_twice_node_qz;
    const real node_R_yx = node_qw_times_twice_node_qz + node_qx_times_twice_node_qy;
    const real one_minus_node_qx_times_twice_node_qx = 1.0 - node_qx * twice_node_qx;
    const real node_R_yy = one_minus_node_qx_times_twice_node_qx - node_qz_times_twice_node_qz;
    const real node_R_yz = node_qy_times_twice_node_qz - node_qw_times_twice_node_qx;
    const real node_R_zx = node_qx_times_twice_node_qz - node_qw_times_twice_node_qy;
    const real node_R_zy = node_qw_times_twice_node_qx + node_qy_times_twice_node_qz;
    const real node_R_zz = one_minus_node_qx_times_twice_node_qx - node_qy_times_twice_node_qy;
    const real node_minus_U_xx = node_u_y * node_u_y + node_u_z * node_u_z;
    const real node_U_yx = node_u_zdot + node_u_x * node_u_y;
    const real node_U_zx = node_u_x * node_u_z - node_u_ydot;

    /* joint1: U */
    /* U = [alpha] + [omega][omega] */
    const real joint1_u = u[0]; /* rad/s */
    const real joint1_minus_U_xx = joint1_u * joint1_u;

    /* loads */
    const real joint1_udot = udot[0]; /* rad/s^2 */
    const real node_u_pxdot = udot[4]; /* m/s^2 */
    const real node_u_pydot = udot[5]; /* m/s^2 */
    const real node_u_pzdot = udot[6]; /* m/s^2 */
    const wreal gravity_1 = w[0];
    const wreal gravity_2 = w[1];
    const wreal gravity_3 = w[2];
    const wreal mass_pp = w[3];
    const wreal mass_pt = w[4];
    const wreal mass_pu = w[5];
    const wreal mass_tt = w[6];
    const wreal mass_tu = w[7];
    const wreal end_spin_y_by_u_node_u_y = w[8];
    const wreal gravity_1_times_mass_pt = w[11];
    const wreal gravity_1_times_mass_pu = w[13];
    const wreal gravity_2_times_mass_pu = w[14];
    const wreal gravity_3_times_mass_pu = w[15];
    const wreal gravity_1_times_mass_pq = w[16];
    const wreal gravity_2_times_mass_pq = w[17];
    const wreal gravity_3_times_mass_pq = w[18];
    const real end_a_x = node_u_pxdot - gravity_1;
    const real end_a_y = node_u_pydot - gravity_2;
    const real end_a_z = node_u_pzdot - gravity_3;
    const real minus_start_tangent_a_x = joint1_cos * joint1_minus_U_xx + joint1_sin * joint1_udot;
    const real start_tangent_a_z = joint1_sin * joint1_minus_U_xx - joint1_cos * joint1_udot;
    const real end_tangent_a_x = node_R_xy * node_U_yx + node_R_xz * node_U_zx
        - node_R_xx * node_minus_U_xx;
    const real end_tangent_a_y = node_R_yz * node_U_zx - node_R_yx * node_minus_U_xx
        + node_R_yy * node_U_yx;
    const real end_tangent_a_z = node_R_zy * node_U_yx - node_R_zx * node_minus_U_xx
        + node_R_zz * node_U_zx;
    const real joint1_n_y_part = end_spin_y_by_u_node_u_y * (joint1_udot + 0.5 * node_u_ydot)
        - joint1_sin * (end_tangent_a_x * mass_tu - (gravity_1_times_mass_pt + end_a_x * mass_pu)
        - minus_start_tangent_a_x * mass_tt);
    const real end_tangent_force_x = end_tangent_a_x * mass_tt - (gravity_1_times_mass_pu
        + end_a_x * mass_pt) - minus_start_tangent_a_x * mass_tu;
    const real end_tangent_force_y = end_tangent_a_y * mass_tt - (gravity_2_times_mass_pu
        + end_a_y * mass_pt);
    const real end_tangent_force_z = end_tangent_a_z * mass_tt - (gravity_3_times_mass_pu
        + end_a_z * mass_pt) + start_tangent_a_z * mass_tu;
    const real end_spin_y = end_spin_y_by_u_node_u_y * (node_u_y + 0.5 * joint1_u);
    /* balance: node.u.px [N] */
    out[4] = end_a_x * mass_pp - gravity_1_times_mass_pq - end_tangent_a_x * mass_pt
        + minus_start_tangent_a_x * mass_pu;
    /* balance: node.u.py [N] */
    out[5] = end_a_y * mass_pp - gravity_2_times_mass_pq - end_tangent_a_y * mass_pt;
    /* balance: node.u.pz [N] */
    out[6] = end_a_z * mass_pp - gravity_3_times_mass_pq - end_tangent_a_z * mass_pt
        - start_tangent_a_z * mass_pu;

    /* joint1: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal gravity_3_times_mass_pt = w[12];
    /* balance: joint1.u [N*m] */
    out[0] = joint1_n_y_part - joint1_cos * (end_tangent_a_z * mass_tu - (gravity_3_times_mass_pt
        + end_a_z * mass_pu) + start_tangent_a_z * mass_tt);

    /* energy */
    const wreal end_spin_z_by_u_node_u_z = w[9];
    const wreal end_spin_x_by_u_node_u_x = w[10];
    const real end_spin_x = node_u_x * end_spin_x_by_u_node_u_x;
    const real end_spin_z = node_u_z * end_spin_z_by_u_node_u_z;

    /* loads */
    const real node_u_xdot = udot[1]; /* rad/s^2 */
    /* balance: node.u.x [N*m] */
    out[1] = node_u_xdot * end_spin_x_by_u_node_u_x + node_u_y * end_spin_z - node_u_z * end_spin_y;
    /* balance: node.u.y [N*m] */
    out[2] = node_u_z * end_spin_x - node_u_x * end_spin_z
        + end_spin_y_by_u_node_u_y * (node_u_ydot + 0.5 * joint1_udot)
        - node_R_yz * end_tangent_force_y - node_R_xz * end_tangent_force_x
        - node_R_zz * end_tangent_force_z;
    /* balance: node.u.z [N*m] */
    out[3] = node_u_zdot * end_spin_z_by_u_node_u_z - node_u_y * end_spin_x
        + node_u_x * end_spin_y + node_R_yy * end_tangent_force_y
        + node_R_xy * end_tangent_force_x + node_R_zy * end_tangent_force_z;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int linked_inertia_tree__balance_sizes[] = {7, 0, 19, 0, 8, 7, 0, 0, 0, 11, 0, 7, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
