/*
 * linked_inertia__balance
 * Mass of the cubic through both ends along their tangents, and of rotations between them
 * kinetic = 1/2 sum mass_ij x_i'·x_j' + 1/2 integral omega·rhoI omega
 * b = (tau_1; f_1; tau_2; f_2)
 * Source: Archer, J. Structural Division ASCE 89 (1963); Przemieniecki,
 *     Theory of Matrix Structural Analysis (1968), section 11.4,
 *     for small displacements; its finite form is our own
 * passes: reassociate
 *
 * Sizes: out 12, work 0, w 12
 * Operations per call: 264 = 146 mul, 66 add, 52 sub
 * Operations of prepare: 36 = 15 mul, 9 add, 9 div, 3 sub
 *
 * Input q (14): generalized coordinates
 *   q[0]  start.qw
 *   q[1]  start.qx
 *   q[2]  start.qy
 *   q[3]  start.qz
 *   q[4]  start.px [m]
 *   q[5]  start.py [m]
 *   q[6]  start.pz [m]
 *   q[7]  end.qw
 *   q[8]  end.qx
 *   q[9]  end.qy
 *   q[10]  end.qz
 *   q[11]  end.px [m]
 *   q[12]  end.py [m]
 *   q[13]  end.pz [m]
 *
 * Input u (12): generalized speeds
 *   u[0]  start.wx [rad/s]
 *   u[1]  start.wy [rad/s]
 *   u[2]  start.wz [rad/s]
 *   u[3]  start.vx [m/s]
 *   u[4]  start.vy [m/s]
 *   u[5]  start.vz [m/s]
 *   u[6]  end.wx [rad/s]
 *   u[7]  end.wy [rad/s]
 *   u[8]  end.wz [rad/s]
 *   u[9]  end.vx [m/s]
 *   u[10]  end.vy [m/s]
 *   u[11]  end.vz [m/s]
 *
 * Input udot (12): derivatives of the speeds
 *   udot[0]  start.wx [rad/s^2]
 *   udot[1]  start.wy [rad/s^2]
 *   udot[2]  start.wz [rad/s^2]
 *   udot[3]  start.vx [m/s^2]
 *   udot[4]  start.vy [m/s^2]
 *   udot[5]  start.vz [m/s^2]
 *   udot[6]  end.wx [rad/s^2]
 *   udot[7]  end.wy [rad/s^2]
 *   udot[8]  end.wz [rad/s^2]
 *   udot[9]  end.vx [m/s^2]
 *   udot[10]  end.vy [m/s^2]
 *   udot[11]  end.vz [m/s^2]
 *
 * Input p (11): parameters, read by prepare_ only
 *
 * Output balance (12)
 *   out[0]  start.wx [N*m]
 *   out[1]  start.wy [N*m]
 *   out[2]  start.wz [N*m]
 *   out[3]  start.vx [N]
 *   out[4]  start.vy [N]
 *   out[5]  start.vz [N]
 *   out[6]  end.wx [N*m]
 *   out[7]  end.wy [N*m]
 *   out[8]  end.wz [N*m]
 *   out[9]  end.vx [N]
 *   out[10]  end.vy [N]
 *   out[11]  end.vz [N]
 */
#include "cardan.h"

CARDAN_API void prepare_linked_inertia__balance(const wreal *p, wreal *CARDAN_RESTRICT w)
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
    const wreal start_spin_y_by_u_start_wy = length_times_c0p3333333333333333 * rhoI2;
    const wreal start_spin_z_by_u_start_wz = length_times_c0p3333333333333333 * rhoI3;
    const wreal start_spin_x_by_u_start_wx = start_spin_y_by_u_start_wy
        + start_spin_z_by_u_start_wz;
    w[3] = mass_pp;
    w[4] = mass_pq;
    w[5] = mass_pt;
    w[6] = mass_pu;
    w[7] = mass_tt;
    w[8] = mass_tu;
    w[9] = start_spin_y_by_u_start_wy;
    w[10] = start_spin_z_by_u_start_wz;
    w[11] = start_spin_x_by_u_start_wx;

    /* parameters as they are */
    w[0] = p[7]; /* gravity_1 */
    w[1] = p[8]; /* gravity_2 */
    w[2] = p[9]; /* gravity_3 */
}

#include "lanes.h"

/* Mass of the cubic through both ends along their tangents, and of rotations between them */
CARDAN_API int linked_inertia__balance(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    const real *const udot = in->udot;
    (void)work;

    /* energy */
    const real start_qw = q[0];
    const real start_qx = q[1];
    const real start_qy = q[2];
    const real start_qz = q[3];
    const real end_qw = q[7];
    const real end_qx = q[8];
    const real end_qy = q[9];
    const real end_qz = q[10];
    const real twice_start_qx = 2.0 * start_qx;
    const real twice_start_qy = 2.0 * start_qy;
    const real twice_start_qz = 2.0 * start_qz;
    const real start_qw_times_twice_start_qx = start_qw * twice_start_qx;
    const real start_qw_times_twice_start_qy = start_qw * twice_start_qy;
    const real start_qw_times_twice_start_qz = start_qw * twice_start_qz;
    const real start_qx_times_twice_start_qy = start_qx * twice_start_qy;
    const real start_qx_times_twice_start_qz = start_qx * twice_start_qz;
    const real start_qy_times_twice_start_qy = start_qy * twice_start_qy;
    const real start_qy_times_twice_start_qz = start_qy * twice_start_qz;
    const real start_qz_times_twice_start_qz = start_qz * twice_start_qz;
    const real start_R_xy = start_qx_times_twice_start_qy - start_qw_times_twice_start_qz;
    const real start_R_xz = start_qw_times_twice_start_qy + start_qx_times_twice_start_qz;
    const real start_R_yz = start_qy_times_twice_start_qz - start_qw_times_twice_start_qx;
    const real start_R_zy = start_qw_times_twice_start_qx + start_qy_times_twice_start_qz;
    const real twice_end_qx = 2.0 * end_qx;
    const real twice_end_qy = 2.0 * end_qy;
    const real twice_end_qz = 2.0 * end_qz;
    const real end_qw_times_twice_end_qx = end_qw * twice_end_qx;
    const real end_qw_times_twice_end_qy = end_qw * twice_end_qy;
    const real end_qw_times_twice_end_qz = end_qw * twice_end_qz;
    const real end_qx_times_twice_end_qy = end_qx * twice_end_qy;
    const real end_qx_times_twice_end_qz = end_qx * twice_end_qz;
    const real end_qy_times_twice_end_qy = end_qy * twice_end_qy;
    const real end_qy_times_twice_end_qz = end_qy * twice_end_qz;
    const real end_qz_times_twice_end_qz = end_qz * twice_end_qz;
    const real end_R_xy = end_qx_times_twice_end_qy - end_qw_times_twice_end_qz;
    const real end_R_xz = end_qw_times_twice_end_qy + end_qx_times_twice_end_qz;
    const real end_R_yz = end_qy_times_twice_end_qz - end_qw_times_twice_end_qx;
    const real end_R_zy = end_qw_times_twice_end_qx + end_qy_times_twice_end_qz;

    /* loads */
    const real start_wx = u[0]; /* rad/s */
    const real start_wy = u[1]; /* rad/s */
    const real start_wz = u[2]; /* rad/s */
    const real end_wx = u[6]; /* rad/s */
    const real end_wy = u[7]; /* rad/s */
    const real end_wz = u[8]; /* rad/s */
    const real start_wx_2 = udot[0]; /* rad/s^2 */
    const real start_wy_2 = udot[1]; /* rad/s^2 */
    const real start_wz_2 = udot[2]; /* rad/s^2 */
    const real start_vx = udot[3]; /* m/s^2 */
    const real start_vy = udot[4]; /* m/s^2 */
    const real start_vz = udot[5]; /* m/s^2 */
    const real end_wx_2 = udot[6]; /* rad/s^2 */
    const real end_wy_2 = udot[7]; /* rad/s^2 */
    const real end_wz_2 = udot[8]; /* rad/s^2 */
    const real end_vx = udot[9]; /* m/s^2 */
    const real end_vy = udot[10]; /* m/s^2 */
    const real end_vz = udot[11]; /* m/s^2 */
    const wreal gravity_1 = w[0];
    const wreal gravity_2 = w[1];
    const wreal gravity_3 = w[2];
    const wreal mass_pp = w[3];
    const wreal mass_pq = w[4];
    const wreal mass_pt = w[5];
    const wreal mass_pu = w[6];
    const wreal mass_tt = w[7];
    const wreal mass_tu = w[8];
    const wreal start_spin_y_by_u_start_wy = w[9];
    const wreal start_spin_z_by_u_start_wz = w[10];
    const wreal start_spin_x_by_u_start_wx = w[11];
    const real one_minus_start_qx_times_twice_start_qx = 1.0 - start_qx * twice_start_qx;
    const real one_minus_end_qx_times_twice_end_qx = 1.0 - end_qx * twice_end_qx;
    const real start_a_x = start_vx - gravity_1;
    const real start_a_y = start_vy - gravity_2;
    const real start_a_z = start_vz - gravity_3;
    const real end_a_x = end_vx - gravity_1;
    const real end_a_y = end_vy - gravity_2;
    const real end_a_z = end_vz - gravity_3;
    const real minus_start_own_tangent_a_x = start_wy * start_wy + start_wz * start_wz;
    const real start_own_tangent_a_y = start_wz_2 + start_wx * start_wy;
    const real start_own_tangent_a_z = start_wx * start_wz - start_wy_2;
    const real minus_end_own_tangent_a_x = end_wy * end_wy + end_wz * end_wz;
    const real end_own_tangent_a_y = end_wz_2 + end_wx * end_wy;
    const real end_own_tangent_a_z = end_wx * end_wz - end_wy_2;
    const real start_tangent_a_x = start_R_xy * start_own_tangent_a_y
        + start_R_xz * start_own_tangent_a_z - (1.0 - start_qy_times_twice_start_qy
        - start_qz_times_twice_start_qz) * minus_start_own_tangent_a_x;
    const real end_tangent_a_x = end_R_xy * end_own_tangent_a_y + end_R_xz * end_own_tangent_a_z
        - (1.0 - end_qy_times_twice_end_qy - end_qz_times_twice_end_qz) * minus_end_own_tangent_a_x;
    const real start_tangent_force_x = start_a_x * mass_pt - end_a_x * mass_pu
        + start_tangent_a_x * mass_tt + end_tangent_a_x * mass_tu;
    const real start_spin_x = start_spin_x_by_u_start_wx * (start_wx + 0.5 * end_wx);
    const real start_spin_y = start_spin_y_by_u_start_wy * (start_wy + 0.5 * end_wy);
    const real start_spin_z = start_spin_z_by_u_start_wz * (start_wz + 0.5 * end_wz);
    const real end_tangent_force_x = start_a_x * mass_pu - end_a_x * mass_pt
        + start_tangent_a_x * mass_tu + end_tangent_a_x * mass_tt;
    const real end_spin_x = start_spin_x_by_u_start_wx * (end_wx + 0.5 * start_wx);
    const real end_spin_y = start_spin_y_by_u_start_wy * (end_wy + 0.5 * start_wy);
    const real end_spin_z = start_spin_z_by_u_start_wz * (end_wz + 0.5 * start_wz);
    /* balance: start.wx [N*m] */
    out[0] = start_spin_x_by_u_start_wx * (start_wx_2 + 0.5 * end_wx_2) + start_wy * start_spin_z
        - start_wz * start_spin_y;
    /* balance: start.vx [N] */
    out[3] = start_a_x * mass_pp + end_a_x * mass_pq + start_tangent_a_x * mass_pt
        + end_tangent_a_x * mass_pu;
    /* balance: end.wx [N*m] */
    out[6] = start_spin_x_by_u_start_wx * (end_wx_2 + 0.5 * start_wx_2) + end_wy * end_spin_z
        - end_wz * end_spin_y;
    /* balance: end.vx [N] */
    out[9] = start_a_x * mass_pq + end_a_x * mass_pp - start_tangent_a_x * mass_pu
        - end_tangent_a_x * mass_pt;

    /* energy */
    const real start_R_yy = one_minus_start_qx_times_twice_start_qx - start_qz_times_twice_start_qz;
    const real start_R_zz = one_minus_start_qx_times_twice_start_qx - start_qy_times_twice_start_qy;
    const real end_R_yy = one_minus_end_qx_times_twice_end_qx - end_qz_times_twice_end_qz;
    const real end_R_zz = one_minus_end_qx_times_twice_end_qx - end_qy_times_twice_end_qy;

    /* loads */
    const real start_tangent_a_y = start_R_yz * start_own_tangent_a_z
        - (start_qw_times_twice_start_qz
        + start_qx_times_twice_start_qy) * minus_start_own_tangent_a_x
        + start_R_yy * start_own_tangent_a_y;
    const real start_tangent_a_z = start_R_zy * start_own_tangent_a_y
        - (start_qx_times_twice_start_qz
        - start_qw_times_twice_start_qy) * minus_start_own_tangent_a_x
        + start_R_zz * start_own_tangent_a_z;
    const real end_tangent_a_y = end_R_yz * end_own_tangent_a_z - (end_qw_times_twice_end_qz
        + end_qx_times_twice_end_qy) * minus_end_own_tangent_a_x + end_R_yy * end_own_tangent_a_y;
    const real end_tangent_a_z = end_R_zy * end_own_tangent_a_y - (end_qx_times_twice_end_qz
        - end_qw_times_twice_end_qy) * minus_end_own_tangent_a_x + end_R_zz * end_own_tangent_a_z;
    const real start_tangent_force_y = start_a_y * mass_pt - end_a_y * mass_pu
        + start_tangent_a_y * mass_tt + end_tangent_a_y * mass_tu;
    const real start_tangent_force_z = start_a_z * mass_pt - end_a_z * mass_pu
        + start_tangent_a_z * mass_tt + end_tangent_a_z * mass_tu;
    const real end_tangent_force_y = start_a_y * mass_pu - end_a_y * mass_pt
        + start_tangent_a_y * mass_tu + end_tangent_a_y * mass_tt;
    const real end_tangent_force_z = start_a_z * mass_pu - end_a_z * mass_pt
        + start_tangent_a_z * mass_tu + end_tangent_a_z * mass_tt;
    /* balance: start.wy [N*m] */
    out[1] = start_spin_y_by_u_start_wy * (start_wy_2 + 0.5 * end_wy_2) + start_wz * start_spin_x
        - start_wx * start_spin_z - start_R_xz * start_tangent_force_x
        - (start_R_yz * start_tangent_force_y + start_R_zz * start_tangent_force_z);
    /* balance: start.wz [N*m] */
    out[2] = start_spin_z_by_u_start_wz * (start_wz_2 + 0.5 * end_wz_2) + start_wx * start_spin_y
        - start_wy * start_spin_x + start_R_xy * start_tangent_force_x
        + (start_R_yy * start_tangent_force_y + start_R_zy * start_tangent_force_z);
    /* balance: start.vy [N] */
    out[4] = start_a_y * mass_pp + end_a_y * mass_pq + start_tangent_a_y * mass_pt
        + end_tangent_a_y * mass_pu;
    /* balance: start.vz [N] */
    out[5] = start_a_z * mass_pp + end_a_z * mass_pq + start_tangent_a_z * mass_pt
        + end_tangent_a_z * mass_pu;
    /* balance: end.wy [N*m] */
    out[7] = start_spin_y_by_u_start_wy * (end_wy_2 + 0.5 * start_wy_2) + end_wz * end_spin_x
        - end_wx * end_spin_z - end_R_xz * end_tangent_force_x - (end_R_yz * end_tangent_force_y
        + end_R_zz * end_tangent_force_z);
    /* balance: end.wz [N*m] */
    out[8] = start_spin_z_by_u_start_wz * (end_wz_2 + 0.5 * start_wz_2) + end_wx * end_spin_y
        - end_wy * end_spin_x + end_R_xy * end_tangent_force_x + (end_R_yy * end_tangent_force_y
        + end_R_zy * end_tangent_force_z);
    /* balance: end.vy [N] */
    out[10] = start_a_y * mass_pq + end_a_y * mass_pp - start_tangent_a_y * mass_pu
        - end_tangent_a_y * mass_pt;
    /* balance: end.vz [N] */
    out[11] = start_a_z * mass_pq + end_a_z * mass_pp - start_tangent_a_z * mass_pu
        - end_tangent_a_z * mass_pt;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int linked_inertia__balance_sizes[] = {12, 0, 12, 0, 14, 12, 0, 0, 0, 11, 0, 12, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
