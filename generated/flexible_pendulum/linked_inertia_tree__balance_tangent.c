/*
 * linked_inertia_tree__balance_tangent
 * Mass of the cubic through both ends along their tangents, and of rotations between them
 * Source: Archer, J. Structural Division ASCE 89 (1963); Przemieniecki,
 *     Theory of Matrix Structural Analysis (1968), section 11.4,
 *     for small displacements; its finite form is our own
 * passes: reassociate
 *
 * Sizes: out 147, work 0, w 17
 * Operations per call: 442 = 265 mul, 91 add, 49 sub, 35 neg, 1 cos, 1 sin
 * Operations of prepare: 40 = 20 mul, 9 add, 9 div, 2 sub
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
 * Output K (7 x 7): out[0 ... 48], row by row
 *
 * Output C (7 x 7): out[49 ... 97], row by row
 *
 * Output M (7 x 7): out[98 ... 146], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_linked_inertia_tree__balance_tangent(const wreal *p,
    wreal *CARDAN_RESTRICT w)
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
    const wreal mixed = share / 120.0 + share_squared / 420.0;
    const wreal cubic = share_squared / 840.0;
    const wreal length_times_mass = length * mass;
    const wreal length_times_times_mass = length * length_times_mass;
    const wreal mass_pp = mass * (share / 30.0 + 0.08333333333333333 + (share_squared / 210.0
        + 0.25));
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
    const wreal end_spin_y_by_u_joint1_u = 0.5 * end_spin_y_by_u_node_u_y;
    w[11] = gravity_1_times_mass_pt;
    w[12] = gravity_3_times_mass_pt;
    w[13] = gravity_1_times_mass_pu;
    w[14] = gravity_2_times_mass_pu;
    w[15] = gravity_3_times_mass_pu;
    w[16] = end_spin_y_by_u_joint1_u;

    /* parameters as they are */
    w[0] = p[7]; /* gravity_1 */
    w[1] = p[8]; /* gravity_2 */
    w[2] = p[9]; /* gravity_3 */
}

#include "lanes.h"

/* Mass of the cubic through both ends along their tangents, and of rotations between them */
CARDAN_API int linked_inertia_tree__balance_tangent(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    const real *const udot = in->udot;
    (void)work;

    /* zeros among the results; what stands between them follows */
    memset(out + 4, 0, 142 * sizeof(real));

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
    const real node_minus_U_xx_by_u_node_u_y = node_u_y + node_u_y;
    const real node_minus_U_xx_by_u_node_u_z = node_u_z + node_u_z;

    /* joint1: U */
    /* U = [alpha] + [omega][omega] */
    const real joint1_u = u[0]; /* rad/s */
    const real joint1_minus_U_xx = joint1_u * joint1_u;
    const real joint1_minus_U_xx_by_u_joint1_u = joint1_u + joint1_u;

    /* loads */
    const real joint1_udot = udot[0]; /* rad/s^2 */
    const real node_u_pxdot = udot[4]; /* m/s^2 */
    const real node_u_pydot = udot[5]; /* m/s^2 */
    const real node_u_pzdot = udot[6]; /* m/s^2 */
    const wreal gravity_1 = w[0];
    const wreal gravity_2 = w[1];
    const wreal gravity_3 = w[2];
    const wreal mass_pt = w[4];
    const wreal mass_pu = w[5];
    const wreal mass_tt = w[6];
    const wreal mass_tu = w[7];
    const wreal end_spin_y_by_u_node_u_y = w[8];
    const wreal end_spin_z_by_u_node_u_z = w[9];
    const wreal end_spin_x_by_u_node_u_x = w[10];
    const wreal gravity_1_times_mass_pt = w[11];
    const wreal gravity_3_times_mass_pt = w[12];
    const wreal gravity_1_times_mass_pu = w[13];
    const wreal gravity_2_times_mass_pu = w[14];
    const wreal gravity_3_times_mass_pu = w[15];
    const wreal end_spin_y_by_u_joint1_u = w[16];
    const real end_a_x = node_u_pxdot - gravity_1;
    const real end_a_z = node_u_pzdot - gravity_3;
    const real minus_start_tangent_a_x = joint1_cos * joint1_minus_U_xx + joint1_sin * joint1_udot;
    const real start_tangent_a_z = joint1_sin * joint1_minus_U_xx - joint1_cos * joint1_udot;
    const real end_tangent_a_x = node_R_xy * node_U_yx + node_R_xz * node_U_zx
        - node_R_xx * node_minus_U_xx;
    const real end_tangent_a_z = node_R_zy * node_U_yx - node_R_zx * node_minus_U_xx
        + node_R_zz * node_U_zx;
    const real start_tangent_force_z_by_joint1_u = minus_start_tangent_a_x * mass_tt;
    const real start_tangent_force_x_by_joint1_u = start_tangent_a_z * mass_tt;
    const real end_tangent_force_z_by_joint1_u = minus_start_tangent_a_x * mass_tu;
    const real end_tangent_force_x_by_joint1_u = start_tangent_a_z * mass_tu;
    const real end_tangent_force_x = end_tangent_a_x * mass_tt - (gravity_1_times_mass_pu
        + end_a_x * mass_pt) - end_tangent_force_z_by_joint1_u;
    const real end_tangent_force_y = (node_R_yz * node_U_zx - node_R_yx * node_minus_U_xx
        + node_R_yy * node_U_yx) * mass_tt - (gravity_2_times_mass_pu + (node_u_pydot
        - gravity_2) * mass_pt);
    const real end_tangent_force_z = end_tangent_a_z * mass_tt - (gravity_3_times_mass_pu
        + end_a_z * mass_pt) + end_tangent_force_x_by_joint1_u;
    const real end_spin_y = end_spin_y_by_u_node_u_y * (node_u_y + 0.5 * joint1_u);
    const real node_R_xx_times_end_tangent_force_x = node_R_xx * end_tangent_force_x;
    const real node_R_yx_times_end_tangent_force_y = node_R_yx * end_tangent_force_y;
    const real node_R_zx_times_end_tangent_force_z = node_R_zx * end_tangent_force_z;
    const real start_moment_y_by_joint1_u_part = joint1_sin * (end_tangent_a_z * mass_tu
        - (gravity_3_times_mass_pt + end_a_z * mass_pu) + start_tangent_force_x_by_joint1_u)
        - joint1_cos * (end_tangent_a_x * mass_tu - (gravity_1_times_mass_pt + end_a_x * mass_pu)
        - start_tangent_force_z_by_joint1_u);
    const real end_tangent_a_x_by_node_u_x = node_R_xz * node_U_yx - node_R_xy * node_U_zx;
    const real end_tangent_a_y_by_node_u_x = node_R_yz * node_U_yx - node_R_yy * node_U_zx;
    const real end_tangent_a_z_by_node_u_x = node_R_zz * node_U_yx - node_R_zy * node_U_zx;
    const real end_tangent_force_x_by_node_u_x = mass_tt * end_tangent_a_x_by_node_u_x;
    const real end_tangent_force_y_by_node_u_x = mass_tt * end_tangent_a_y_by_node_u_x;
    const real end_tangent_force_z_by_node_u_x = mass_tt * end_tangent_a_z_by_node_u_x;
    const real end_tangent_a_x_by_node_u_y = node_R_xz * node_minus_U_xx + node_R_xx * node_U_zx;
    const real end_tangent_a_y_by_node_u_y = node_R_yz * node_minus_U_xx + node_R_yx * node_U_zx;
    const real end_tangent_a_z_by_node_u_y = node_R_zz * node_minus_U_xx + node_R_zx * node_U_zx;
    const real end_tangent_force_x_by_node_u_y = mass_tt * end_tangent_a_x_by_node_u_y;
    const real end_tangent_force_y_by_node_u_y = mass_tt * end_tangent_a_y_by_node_u_y;
    const real end_tangent_force_z_by_node_u_y = mass_tt * end_tangent_a_z_by_node_u_y;
    const real minus_end_tangent_a_x_by_node_u_z = node_R_xy * node_minus_U_xx
        + node_R_xx * node_U_yx;
    const real minus_end_tangent_a_y_by_node_u_z = node_R_yy * node_minus_U_xx
        + node_R_yx * node_U_yx;
    const real minus_end_tangent_a_z_by_node_u_z = node_R_zy * node_minus_U_xx
        + node_R_zx * node_U_yx;
    const real minus_end_tangent_force_x_by_node_u_z = mass_tt * minus_end_tangent_a_x_by_node_u_z;
    const real minus_end_tangent_force_y_by_node_u_z = mass_tt * minus_end_tangent_a_y_by_node_u_z;
    const real minus_end_tangent_force_z_by_node_u_z = mass_tt * minus_end_tangent_a_z_by_node_u_z;
    const real minus_end_own_tangent_force_y_by_node_u_z_part = node_R_xy *
        minus_end_tangent_force_x_by_node_u_z + node_R_zy * minus_end_tangent_force_z_by_node_u_z
        + (node_R_yx_times_end_tangent_force_y
        + node_R_yy * minus_end_tangent_force_y_by_node_u_z) + node_R_xx_times_end_tangent_force_x;
    const real minus_start_tangent_a_x_by_u_joint1_u = joint1_cos * joint1_minus_U_xx_by_u_joint1_u;
    const real start_tangent_a_z_by_u_joint1_u = joint1_sin * joint1_minus_U_xx_by_u_joint1_u;
    const real end_tangent_force_z_by_joint1_u_by_u_joint1_u = mass_tu *
        minus_start_tangent_a_x_by_u_joint1_u;
    const real end_tangent_force_x_by_joint1_u_by_u_joint1_u = mass_tu *
        start_tangent_a_z_by_u_joint1_u;
    const real end_tangent_a_x_by_u_node_u_x = node_R_xy * node_u_y + node_R_xz * node_u_z;
    const real end_tangent_a_y_by_u_node_u_x = node_R_yy * node_u_y + node_R_yz * node_u_z;
    const real end_tangent_a_z_by_u_node_u_x = node_R_zy * node_u_y + node_R_zz * node_u_z;
    const real end_tangent_force_x_by_u_node_u_x = mass_tt * end_tangent_a_x_by_u_node_u_x;
    const real end_tangent_force_y_by_u_node_u_x = mass_tt * end_tangent_a_y_by_u_node_u_x;
    const real end_tangent_force_z_by_u_node_u_x = mass_tt * end_tangent_a_z_by_u_node_u_x;
    const real end_tangent_a_x_by_u_node_u_y = node_R_xy * node_u_x
        - node_R_xx * node_minus_U_xx_by_u_node_u_y;
    const real end_tangent_a_y_by_u_node_u_y = node_R_yy * node_u_x
        - node_R_yx * node_minus_U_xx_by_u_node_u_y;
    const real end_tangent_a_z_by_u_node_u_y = node_R_zy * node_u_x
        - node_R_zx * node_minus_U_xx_by_u_node_u_y;
    const real end_tangent_force_x_by_u_node_u_y = mass_tt * end_tangent_a_x_by_u_node_u_y;
    const real end_tangent_force_y_by_u_node_u_y = mass_tt * end_tangent_a_y_by_u_node_u_y;
    const real end_tangent_force_z_by_u_node_u_y = mass_tt * end_tangent_a_z_by_u_node_u_y;
    const real end_tangent_a_x_by_u_node_u_z = node_R_xz * node_u_x
        - node_R_xx * node_minus_U_xx_by_u_node_u_z;
    const real end_tangent_a_y_by_u_node_u_z = node_R_yz * node_u_x
        - node_R_yx * node_minus_U_xx_by_u_node_u_z;
    const real end_tangent_a_z_by_u_node_u_z = node_R_zz * node_u_x
        - node_R_zx * node_minus_U_xx_by_u_node_u_z;
    const real end_tangent_force_x_by_u_node_u_z = mass_tt * end_tangent_a_x_by_u_node_u_z;
    const real end_tangent_force_y_by_u_node_u_z = mass_tt * end_tangent_a_y_by_u_node_u_z;
    const real end_tangent_force_z_by_u_node_u_z = mass_tt * end_tangent_a_z_by_u_node_u_z;
    const real end_tangent_force_z_by_joint1_u_by_udot_joint1_u = joint1_sin * mass_tu;
    const real minus_end_tangent_force_x_by_joint1_u_by_udot_joint1_u = joint1_cos * mass_tu;
    const real minus_end_force_z_by_joint1_u_by_udot_joint1_u = joint1_sin * mass_pu;
    const real end_force_x_by_joint1_u_by_udot_joint1_u = joint1_cos * mass_pu;
    const real minus_end_tangent_force_x_by_udot_node_u_y = node_R_xz * mass_tt;
    const real minus_end_tangent_force_y_by_udot_node_u_y = node_R_yz * mass_tt;
    const real minus_end_tangent_force_z_by_udot_node_u_y = node_R_zz * mass_tt;
    const real end_force_x_by_udot_node_u_y = node_R_xz * mass_pt;
    const real end_force_y_by_udot_node_u_y = node_R_yz * mass_pt;
    const real end_force_z_by_udot_node_u_y = node_R_zz * mass_pt;
    const real end_tangent_force_x_by_udot_node_u_z = node_R_xy * mass_tt;
    const real end_tangent_force_y_by_udot_node_u_z = node_R_yy * mass_tt;
    const real end_tangent_force_z_by_udot_node_u_z = node_R_zy * mass_tt;
    const real end_force_x_by_udot_node_u_z = -node_R_xy * mass_pt;
    const real end_force_y_by_udot_node_u_z = -node_R_yy * mass_pt;
    const real end_force_z_by_udot_node_u_z = -node_R_zy * mass_pt;
    out[42] = -minus_start_tangent_a_x * mass_pu; /* K: node.u.pz,joint1.u */
    out[28] = -start_tangent_a_z * mass_pu; /* K: node.u.px,joint1.u */
    /* K: joint1.u,joint1.u */
    out[0] = start_moment_y_by_joint1_u_part - (joint1_sin * start_tangent_force_x_by_joint1_u
        + joint1_cos * start_tangent_force_z_by_joint1_u);
    /* K: node.u.z,joint1.u */
    out[21] = node_R_xy * end_tangent_force_x_by_joint1_u
        + node_R_zy * end_tangent_force_z_by_joint1_u;
    /* K: node.u.y,joint1.u */
    out[14] = -(node_R_xz * end_tangent_force_x_by_joint1_u
        + node_R_zz * end_tangent_force_z_by_joint1_u);
    /* K: joint1.u,node.u.x */
    out[1] = -(mass_tu * end_tangent_a_x_by_node_u_x * joint1_sin
        + mass_tu * end_tangent_a_z_by_node_u_x * joint1_cos);
    /* K: node.u.z,node.u.x */
    out[22] = node_R_xy * end_tangent_force_x_by_node_u_x
        + node_R_yy * end_tangent_force_y_by_node_u_x + (node_R_yz * end_tangent_force_y
        + node_R_zy * end_tangent_force_z_by_node_u_x) + node_R_xz * end_tangent_force_x
        + node_R_zz * end_tangent_force_z;
    /* K: node.u.y,node.u.x */
    out[15] = node_R_yy * end_tangent_force_y - node_R_zz * end_tangent_force_z_by_node_u_x
        - (node_R_xz * end_tangent_force_x_by_node_u_x
        + node_R_yz * end_tangent_force_y_by_node_u_x) + node_R_xy * end_tangent_force_x
        + node_R_zy * end_tangent_force_z;
    out[29] = -mass_pt * end_tangent_a_x_by_node_u_x; /* K: node.u.px,node.u.x */
    out[36] = -mass_pt * end_tangent_a_y_by_node_u_x; /* K: node.u.py,node.u.x */
    out[43] = -mass_pt * end_tangent_a_z_by_node_u_x; /* K: node.u.pz,node.u.x */
    /* K: joint1.u,node.u.y */
    out[2] = -(mass_tu * end_tangent_a_x_by_node_u_y * joint1_sin
        + mass_tu * end_tangent_a_z_by_node_u_y * joint1_cos);
    /* K: node.u.z,node.u.y */
    out[23] = node_R_xy * end_tangent_force_x_by_node_u_y
        + node_R_yy * end_tangent_force_y_by_node_u_y + node_R_zy * end_tangent_force_z_by_node_u_y;
    /* K: node.u.y,node.u.y */
    out[16] = -(node_R_xz * end_tangent_force_x_by_node_u_y
        + node_R_yz * end_tangent_force_y_by_node_u_y + (node_R_yx_times_end_tangent_force_y
        + node_R_zz * end_tangent_force_z_by_node_u_y) + node_R_xx_times_end_tangent_force_x
        + node_R_zx_times_end_tangent_force_z);
    out[30] = -mass_pt * end_tangent_a_x_by_node_u_y; /* K: node.u.px,node.u.y */
    out[37] = -mass_pt * end_tangent_a_y_by_node_u_y; /* K: node.u.py,node.u.y */
    out[44] = -mass_pt * end_tangent_a_z_by_node_u_y; /* K: node.u.pz,node.u.y */
    /* K: joint1.u,node.u.z */
    out[3] = mass_tu * minus_end_tangent_a_x_by_node_u_z * joint1_sin
        + mass_tu * minus_end_tangent_a_z_by_node_u_z * joint1_cos;
    /* K: node.u.z,node.u.z */
    out[24] = -(node_R_zx_times_end_tangent_force_z
        + minus_end_own_tangent_force_y_by_node_u_z_part);
    /* K: node.u.y,node.u.z */
    out[17] = node_R_xz * minus_end_tangent_force_x_by_node_u_z
        + node_R_zz * minus_end_tangent_force_z_by_node_u_z
        + node_R_yz * minus_end_tangent_force_y_by_node_u_z;
    out[31] = mass_pt * minus_end_tangent_a_x_by_node_u_z; /* K: node.u.px,node.u.z */
    out[38] = mass_pt * minus_end_tangent_a_y_by_node_u_z; /* K: node.u.py,node.u.z */
    out[45] = mass_pt * minus_end_tangent_a_z_by_node_u_z; /* K: node.u.pz,node.u.z */
    /* C: joint1.u,joint1.u */
    out[49] = mass_tt * minus_start_tangent_a_x_by_u_joint1_u * joint1_sin
        - mass_tt * start_tangent_a_z_by_u_joint1_u * joint1_cos;
    /* C: node.u.y,joint1.u */
    out[63] = node_R_xz * end_tangent_force_z_by_joint1_u_by_u_joint1_u
        - node_R_zz * end_tangent_force_x_by_joint1_u_by_u_joint1_u;
    out[56] = -node_u_z * end_spin_y_by_u_joint1_u; /* C: node.u.x,joint1.u */
    /* C: node.u.z,joint1.u */
    out[70] = node_R_zy * end_tangent_force_x_by_joint1_u_by_u_joint1_u
        + node_u_x * end_spin_y_by_u_joint1_u
        - node_R_xy * end_tangent_force_z_by_joint1_u_by_u_joint1_u;
    out[77] = mass_pu * minus_start_tangent_a_x_by_u_joint1_u; /* C: node.u.px,joint1.u */
    out[91] = -mass_pu * start_tangent_a_z_by_u_joint1_u; /* C: node.u.pz,joint1.u */
    /* C: joint1.u,node.u.x */
    out[50] = -(mass_tu * end_tangent_a_x_by_u_node_u_x * joint1_sin
        + mass_tu * end_tangent_a_z_by_u_node_u_x * joint1_cos);
    /* C: node.u.z,node.u.x */
    out[71] = end_spin_y - node_u_y * end_spin_x_by_u_node_u_x
        + node_R_xy * end_tangent_force_x_by_u_node_u_x
        + (node_R_yy * end_tangent_force_y_by_u_node_u_x
        + node_R_zy * end_tangent_force_z_by_u_node_u_x);
    out[78] = -mass_pt * end_tangent_a_x_by_u_node_u_x; /* C: node.u.px,node.u.x */
    out[85] = -mass_pt * end_tangent_a_y_by_u_node_u_x; /* C: node.u.py,node.u.x */
    out[92] = -mass_pt * end_tangent_a_z_by_u_node_u_x; /* C: node.u.pz,node.u.x */
    /* C: joint1.u,node.u.y */
    out[51] = -(mass_tu * end_tangent_a_x_by_u_node_u_y * joint1_sin
        + mass_tu * end_tangent_a_z_by_u_node_u_y * joint1_cos);
    /* C: node.u.y,node.u.y */
    out[65] = -(node_R_xz * end_tangent_force_x_by_u_node_u_y
        + node_R_zz * end_tangent_force_z_by_u_node_u_y
        + node_R_yz * end_tangent_force_y_by_u_node_u_y);
    out[79] = -mass_pt * end_tangent_a_x_by_u_node_u_y; /* C: node.u.px,node.u.y */
    out[86] = -mass_pt * end_tangent_a_y_by_u_node_u_y; /* C: node.u.py,node.u.y */
    out[93] = -mass_pt * end_tangent_a_z_by_u_node_u_y; /* C: node.u.pz,node.u.y */
    /* C: joint1.u,node.u.z */
    out[52] = -(mass_tu * end_tangent_a_x_by_u_node_u_z * joint1_sin
        + mass_tu * end_tangent_a_z_by_u_node_u_z * joint1_cos);
    /* C: node.u.z,node.u.z */
    out[73] = node_R_xy * end_tangent_force_x_by_u_node_u_z
        + node_R_yy * end_tangent_force_y_by_u_node_u_z
        + node_R_zy * end_tangent_force_z_by_u_node_u_z;
    out[59] = node_u_y * end_spin_z_by_u_node_u_z - end_spin_y; /* C: node.u.x,node.u.z */
    out[80] = -mass_pt * end_tangent_a_x_by_u_node_u_z; /* C: node.u.px,node.u.z */
    out[87] = -mass_pt * end_tangent_a_y_by_u_node_u_z; /* C: node.u.py,node.u.z */
    out[94] = -mass_pt * end_tangent_a_z_by_u_node_u_z; /* C: node.u.pz,node.u.z */
    /* M: joint1.u,joint1.u */
    out[98] = end_spin_y_by_u_node_u_y + joint1_sin * mass_tt * joint1_sin
        + joint1_cos * mass_tt * joint1_cos;
    /* M: node.u.z,joint1.u */
    out[119] = -(node_R_xy * end_tangent_force_z_by_joint1_u_by_udot_joint1_u
        + node_R_zy * minus_end_tangent_force_x_by_joint1_u_by_udot_joint1_u);
    /* M: node.u.y,joint1.u */
    out[112] = end_spin_y_by_u_joint1_u
        + node_R_xz * end_tangent_force_z_by_joint1_u_by_udot_joint1_u
        + node_R_zz * minus_end_tangent_force_x_by_joint1_u_by_udot_joint1_u;
    out[102] = minus_end_force_z_by_joint1_u_by_udot_joint1_u; /* M: joint1.u,node.u.px */
    out[126] = minus_end_force_z_by_joint1_u_by_udot_joint1_u; /* M: node.u.px,joint1.u */
    out[104] = end_force_x_by_joint1_u_by_udot_joint1_u; /* M: joint1.u,node.u.pz */
    out[140] = end_force_x_by_joint1_u_by_udot_joint1_u; /* M: node.u.pz,joint1.u */
    /* M: joint1.u,node.u.y */
    out[100] = end_spin_y_by_u_joint1_u + node_R_xz * mass_tu * joint1_sin
        + node_R_zz * mass_tu * joint1_cos;
    /* M: node.u.z,node.u.y */
    out[121] = -(node_R_xy * minus_end_tangent_force_x_by_udot_node_u_y
        + node_R_yy * minus_end_tangent_force_y_by_udot_node_u_y
        + node_R_zy * minus_end_tangent_force_z_by_udot_node_u_y);
    /* M: node.u.y,node.u.y */
    out[114] = end_spin_y_by_u_node_u_y + node_R_xz * minus_end_tangent_force_x_by_udot_node_u_y
        + (node_R_yz * minus_end_tangent_force_y_by_udot_node_u_y
        + node_R_zz * minus_end_tangent_force_z_by_udot_node_u_y);
    out[116] = end_force_x_by_udot_node_u_y; /* M: node.u.y,node.u.px */
    out[128] = end_force_x_by_udot_node_u_y; /* M: node.u.px,node.u.y */
    out[117] = end_force_y_by_udot_node_u_y; /* M: node.u.y,node.u.py */
    out[135] = end_force_y_by_udot_node_u_y; /* M: node.u.py,node.u.y */
    out[118] = end_force_z_by_udot_node_u_y; /* M: node.u.y,node.u.pz */
    out[142] = end_force_z_by_udot_node_u_y; /* M: node.u.pz,node.u.y */
    /* M: joint1.u,node.u.z */
    out[101] = -(node_R_xy * mass_tu * joint1_sin + node_R_zy * mass_tu * joint1_cos);
    /* M: node.u.y,node.u.z */
    out[115] = -(node_R_xz * end_tangent_force_x_by_udot_node_u_z
        + node_R_zz * end_tangent_force_z_by_udot_node_u_z
        + node_R_yz * end_tangent_force_y_by_udot_node_u_z);
    /* M: node.u.z,node.u.z */
    out[122] = end_spin_z_by_u_node_u_z + node_R_xy * end_tangent_force_x_by_udot_node_u_z
        + (node_R_yy * end_tangent_force_y_by_udot_node_u_z
        + node_R_zy * end_tangent_force_z_by_udot_node_u_z);
    out[123] = end_force_x_by_udot_node_u_z; /* M: node.u.z,node.u.px */
    out[129] = end_force_x_by_udot_node_u_z; /* M: node.u.px,node.u.z */
    out[124] = end_force_y_by_udot_node_u_z; /* M: node.u.z,node.u.py */
    out[136] = end_force_y_by_udot_node_u_z; /* M: node.u.py,node.u.z */
    out[125] = end_force_z_by_udot_node_u_z; /* M: node.u.z,node.u.pz */
    out[143] = end_force_z_by_udot_node_u_z; /* M: node.u.pz,node.u.z */

    /* energy */
    const real end_spin_x = node_u_x * end_spin_x_by_u_node_u_x;
    const real end_spin_z = node_u_z * end_spin_z_by_u_node_u_z;

    /* loads */
    /* C: node.u.y,node.u.x */
    out[64] = node_u_z * end_spin_x_by_u_node_u_x - end_spin_z
        - node_R_xz * end_tangent_force_x_by_u_node_u_x
        - (node_R_yz * end_tangent_force_y_by_u_node_u_x
        + node_R_zz * end_tangent_force_z_by_u_node_u_x);
    out[58] = end_spin_z - node_u_z * end_spin_y_by_u_node_u_y; /* C: node.u.x,node.u.y */
    /* C: node.u.z,node.u.y */
    out[72] = node_u_x * end_spin_y_by_u_node_u_y - end_spin_x
        + node_R_zy * end_tangent_force_z_by_u_node_u_y
        + (node_R_xy * end_tangent_force_x_by_u_node_u_y
        + node_R_yy * end_tangent_force_y_by_u_node_u_y);
    /* C: node.u.y,node.u.z */
    out[66] = end_spin_x - node_u_x * end_spin_z_by_u_node_u_z
        - node_R_yz * end_tangent_force_y_by_u_node_u_z
        - (node_R_xz * end_tangent_force_x_by_u_node_u_z
        + node_R_zz * end_tangent_force_z_by_u_node_u_z);

    /* results that are numbers or inputs */
    out[106] = CARDAN_REAL(w[10]); /* M: node.u.x,node.u.x */
    out[130] = CARDAN_REAL(w[3]); /* M: node.u.px,node.u.px */
    out[138] = CARDAN_REAL(w[3]); /* M: node.u.py,node.u.py */
    out[146] = CARDAN_REAL(w[3]); /* M: node.u.pz,node.u.pz */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int linked_inertia_tree__balance_tangent_sizes[] = {147, 0, 17, 0, 8, 7, 0, 0, 0, 11, 0, 7, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
