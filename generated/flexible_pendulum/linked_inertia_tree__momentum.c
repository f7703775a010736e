/*
 * linked_inertia_tree__momentum
 * Mass of the cubic through both ends along their tangents, and of rotations between them
 * Source: Archer, J. Structural Division ASCE 89 (1963); Przemieniecki,
 *     Theory of Matrix Structural Analysis (1968), section 11.4,
 *     for small displacements; its finite form is our own
 * passes: reassociate
 *
 * Sizes: out 6, work 0, w 10
 * Operations per call: 156 = 91 mul, 37 sub, 26 add, 1 cos, 1 sin
 * Operations of prepare: 38 = 15 mul, 10 add, 9 div, 4 sub
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
 * Input p (11): parameters, read by prepare_ only
 *
 * Output momentum (6)
 *   out[0]  hx [N*m*s]
 *   out[1]  hy [N*m*s]
 *   out[2]  hz [N*m*s]
 *   out[3]  px [N*s]
 *   out[4]  py [N*s]
 *   out[5]  pz [N*s]
 */
#include "cardan.h"

CARDAN_API void prepare_linked_inertia_tree__momentum(const wreal *p, wreal *CARDAN_RESTRICT w)
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
    const wreal mass_pt = length_times_mass * (mixed + 0.041666666666666664);
    const wreal mass_pu = length_times_mass * (mixed - 0.041666666666666664);
    const wreal mass_tt = length_times_times_mass * (cubic + 0.008333333333333333);
    const wreal mass_tu = length_times_times_mass * (cubic - 0.008333333333333333);
    const wreal length_times_c0p3333333333333333 = 0.3333333333333333 * length;
    const wreal end_spin_y_by_u_node_u_y = length_times_c0p3333333333333333 * rhoI2;
    const wreal end_spin_z_by_u_node_u_z = length_times_c0p3333333333333333 * rhoI3;
    const wreal end_spin_x_by_u_node_u_x = end_spin_y_by_u_node_u_y + end_spin_z_by_u_node_u_z;
    const wreal mass_pp_plus_mass_pq = mass_pp + mass * (0.25 - odd);
    const wreal mass_pt_minus_mass_pu = mass_pt - mass_pu;
    w[0] = mass_pp;
    w[1] = mass_pt;
    w[2] = mass_pu;
    w[3] = mass_tt;
    w[4] = mass_tu;
    w[5] = end_spin_y_by_u_node_u_y;
    w[6] = end_spin_z_by_u_node_u_z;
    w[7] = end_spin_x_by_u_node_u_x;
    w[8] = mass_pp_plus_mass_pq;
    w[9] = mass_pt_minus_mass_pu;
}

#include "lanes.h"

/* Mass of the cubic through both ends along their tangents, and of rotations between them */
CARDAN_API int linked_inertia_tree__momentum(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    (void)work;

    /* joint1: R */
    /* R = R_fixed R_joint(q) */
    const real joint1_q = q[0]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {joint1_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real joint1_cos = cosine[0];
    const real joint1_sin = sine[0];

    /* node: R */
    /* R = R_fixed R_joint(q) */
    const real node_qw = q[1];
    const real node_qx = q[2];
    const real node_qy = q[3];
    const real node_qz = q[4];
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

    /* loads */
    const real joint1_u = u[0]; /* rad/s */
    const real node_u_x = u[1]; /* rad/s */
    const real node_u_y = u[2]; /* rad/s */
    const real node_u_z = u[3]; /* rad/s */
    const wreal end_spin_y_by_u_node_u_y = w[5];
    const wreal end_spin_z_by_u_node_u_z = w[6];
    const wreal end_spin_x_by_u_node_u_x = w[7];
    const real start_spin_x = 0.5 * node_u_x * end_spin_x_by_u_node_u_x;
    const real start_spin_z = 0.5 * node_u_z * end_spin_z_by_u_node_u_z;
    const real end_spin_y = end_spin_y_by_u_node_u_y * (node_u_y + 0.5 * joint1_u);

    /* energy */
    const real node_u_px = u[4]; /* m/s */
    const real node_u_py = u[5]; /* m/s */
    const real node_u_pz = u[6]; /* m/s */
    const wreal mass_pp = w[0];
    const wreal mass_pt = w[1];
    const wreal mass_pu = w[2];
    const wreal mass_tt = w[3];
    const wreal mass_tu = w[4];
    const real end_spin_x = node_u_x * end_spin_x_by_u_node_u_x;
    const real end_spin_z = node_u_z * end_spin_z_by_u_node_u_z;
    const real minus_start_tangent_rate_x = joint1_sin * joint1_u;
    const real minus_start_tangent_rate_z = joint1_cos * joint1_u;
    const real end_tangent_rate_x = node_R_xy * node_u_z - node_R_xz * node_u_y;
    const real end_tangent_rate_y = node_R_yy * node_u_z - node_R_yz * node_u_y;
    const real end_tangent_rate_z = node_R_zy * node_u_z - node_R_zz * node_u_y;
    const real momentum_end_x = node_u_px * mass_pp - mass_pt * end_tangent_rate_x
        + mass_pu * minus_start_tangent_rate_x;
    const real momentum_end_y = node_u_py * mass_pp - mass_pt * end_tangent_rate_y;
    const real momentum_end_z = node_u_pz * mass_pp - mass_pt * end_tangent_rate_z
        + mass_pu * minus_start_tangent_rate_z;
    const real momentum_start_tangent_y = mass_tu * end_tangent_rate_y - node_u_py * mass_pu;
    const real momentum_end_tangent_x = mass_tt * end_tangent_rate_x - node_u_px * mass_pt
        - mass_tu * minus_start_tangent_rate_x;
    const real momentum_end_tangent_y = mass_tt * end_tangent_rate_y - node_u_py * mass_pt;
    const real momentum_end_tangent_z = mass_tt * end_tangent_rate_z - node_u_pz * mass_pt
        - mass_tu * minus_start_tangent_rate_z;

    /* momentum */
    const real node_px = q[5]; /* m */
    const real node_py = q[6]; /* m */
    const real node_pz = q[7]; /* m */
    const wreal mass_pp_plus_mass_pq = w[8];
    const wreal mass_pt_minus_mass_pu = w[9];
    const real momentum_hx_part = joint1_sin * momentum_start_tangent_y
        + joint1_cos * start_spin_x + (node_R_xy * end_spin_y + node_R_xz * end_spin_z
        + node_R_xx * end_spin_x - node_pz * momentum_end_y - node_R_zx * momentum_end_tangent_y
        + joint1_sin * start_spin_z);
    const real momentum_hy_part = node_R_zx * momentum_end_tangent_x
        - joint1_cos * (mass_tu * end_tangent_rate_z - node_u_pz * mass_pu
        - mass_tt * minus_start_tangent_rate_z) - (node_px * momentum_end_z
        + joint1_sin * (mass_tu * end_tangent_rate_x - node_u_px * mass_pu
        - mass_tt * minus_start_tangent_rate_x));
    const real momentum_hz_part = joint1_cos * momentum_start_tangent_y
        + joint1_cos * start_spin_z + (node_R_zx * end_spin_x + node_R_zy * end_spin_y
        + node_R_zz * end_spin_z + node_px * momentum_end_y + node_R_xx * momentum_end_tangent_y
        - joint1_sin * start_spin_x);
    /* momentum: hx [N*m*s] */
    out[0] = node_py * momentum_end_z + momentum_hx_part + node_R_yx * momentum_end_tangent_z;
    /* momentum: hy [N*m*s] */
    out[1] = end_spin_y_by_u_node_u_y * (joint1_u + 0.5 * node_u_y) + node_R_yx * end_spin_x
        + (node_R_yy * end_spin_y + node_R_yz * end_spin_z) + node_pz * momentum_end_x
        - node_R_xx * momentum_end_tangent_z + momentum_hy_part;
    /* momentum: hz [N*m*s] */
    out[2] = momentum_hz_part - node_py * momentum_end_x - node_R_yx * momentum_end_tangent_x;
    /* momentum: px [N*s] */
    out[3] = node_u_px * mass_pp_plus_mass_pq - end_tangent_rate_x * mass_pt_minus_mass_pu
        - minus_start_tangent_rate_x * mass_pt_minus_mass_pu;
    /* momentum: py [N*s] */
    out[4] = node_u_py * mass_pp_plus_mass_pq - end_tangent_rate_y * mass_pt_minus_mass_pu;
    /* momentum: pz [N*s] */
    out[5] = node_u_pz * mass_pp_plus_mass_pq - end_tangent_rate_z * mass_pt_minus_mass_pu
        - minus_start_tangent_rate_z * mass_pt_minus_mass_pu;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int linked_inertia_tree__momentum_sizes[] = {6, 0, 10, 0, 8, 7, 0, 0, 0, 11, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
