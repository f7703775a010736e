/*
 * linked_inertia__balance_tangent
 * Mass of the cubic through both ends along their tangents, and of rotations between them
 * kinetic = 1/2 sum mass_ij x_i'·x_j' + 1/2 integral omega·rhoI omega
 * Source: Archer, J. Structural Division ASCE 89 (1963); Przemieniecki,
 *     Theory of Matrix Structural Analysis (1968), section 11.4,
 *     for small displacements; its finite form is our own
 * passes: reassociate
 *
 * Sizes: out 432, work 0, w 15
 * Operations per call: 954 = 584 mul, 214 add, 82 sub, 74 neg
 * Operations of prepare: 39 = 18 mul, 9 add, 9 div, 3 sub
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
 * Output K (12 x 12): out[0 ... 143], row by row
 *
 * Output C (12 x 12): out[144 ... 287], row by row
 *
 * Output M (12 x 12): out[288 ... 431], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_linked_inertia__balance_tangent(const wreal *p, wreal *CARDAN_RESTRICT w)
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

    /* loads */
    const wreal end_spin_x_by_u_start_wx = 0.5 * start_spin_x_by_u_start_wx;
    const wreal end_spin_y_by_u_start_wy = 0.5 * start_spin_y_by_u_start_wy;
    const wreal end_spin_z_by_u_start_wz = 0.5 * start_spin_z_by_u_start_wz;
    w[12] = end_spin_x_by_u_start_wx;
    w[13] = end_spin_y_by_u_start_wy;
    w[14] = end_spin_z_by_u_start_wz;

    /* parameters as they are */
    w[0] = p[7]; /* gravity_1 */
    w[1] = p[8]; /* gravity_2 */
    w[2] = p[9]; /* gravity_3 */
}

#include "lanes.h"

/* Mass of the cubic through both ends along their tangents, and of rotations between them */
CARDAN_API int linked_inertia__balance_tangent(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    const real *const udot = in->udot;
    (void)work;

    /* zeros among the results; what stands between them follows */
    memset(out, 0, 431 * sizeof(real));

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
    const real start_R_xx = 1.0 - start_qy_times_twice_start_qy - start_qz_times_twice_start_qz;
    const real start_R_xy = start_qx_times_twice_start_qy - start_qw_times_twice_start_qz;
    const real start_R_xz = start_qw_times_twice_start_qy + start_qx_times_twice_start_qz;
    const real start_R_yx = start_qw_times_twice_start_qz + start_qx_times_twice_start_qy;
    const real start_R_yz = start_qy_times_twice_start_qz - start_qw_times_twice_start_qx;
    const real start_R_zx = start_qx_times_twice_start_qz - start_qw_times_twice_start_qy;
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
    const real end_R_xx = 1.0 - end_qy_times_twice_end_qy - end_qz_times_twice_end_qz;
    const real end_R_xy = end_qx_times_twice_end_qy - end_qw_times_twice_end_qz;
    const real end_R_xz = end_qw_times_twice_end_qy + end_qx_times_twice_end_qz;
    const real end_R_yx = end_qw_times_twice_end_qz + end_qx_times_twice_end_qy;
    const real end_R_yz = end_qy_times_twice_end_qz - end_qw_times_twice_end_qx;
    const real end_R_zx = end_qx_times_twice_end_qz - end_qw_times_twice_end_qy;
    const real end_R_zy = end_qw_times_twice_end_qx + end_qy_times_twice_end_qz;

    /* loads */
    const real start_wx = u[0]; /* rad/s */
    const real start_wy = u[1]; /* rad/s */
    const real start_wz = u[2]; /* rad/s */
    const real end_wx = u[6]; /* rad/s */
    const real end_wy = u[7]; /* rad/s */
    const real end_wz = u[8]; /* rad/s */
    const real start_wy_2 = udot[1]; /* rad/s^2 */
    const real start_wz_2 = udot[2]; /* rad/s^2 */
    const real start_vx = udot[3]; /* m/s^2 */
    const real start_vy = udot[4]; /* m/s^2 */
    const real start_vz = udot[5]; /* m/s^2 */
    const real end_wy_2 = udot[7]; /* rad/s^2 */
    const real end_wz_2 = udot[8]; /* rad/s^2 */
    const real end_vx = udot[9]; /* m/s^2 */
    const real end_vy = udot[10]; /* m/s^2 */
    const real end_vz = udot[11]; /* m/s^2 */
    const wreal gravity_1 = w[0];
    const wreal gravity_2 = w[1];
    const wreal gravity_3 = w[2];
    const wreal mass_pt = w[5];
    const wreal mass_pu = w[6];
    const wreal mass_tt = w[7];
    const wreal mass_tu = w[8];
    const wreal start_spin_y_by_u_start_wy = w[9];
    const wreal start_spin_z_by_u_start_wz = w[10];
    const wreal start_spin_x_by_u_start_wx = w[11];
    const wreal end_spin_y_by_u_start_wy = w[13];
    const wreal end_spin_z_by_u_start_wz = w[14];
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
        + start_R_xz * start_own_tangent_a_z - start_R_xx * minus_start_own_tangent_a_x;
    const real end_tangent_a_x = end_R_xy * end_own_tangent_a_y + end_R_xz * end_own_tangent_a_z
        - end_R_xx * minus_end_own_tangent_a_x;
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
    const real start_tangent_a_x_by_start_wx = start_R_xz * start_own_tangent_a_y
        - start_R_xy * start_own_tangent_a_z;
    const real start_tangent_force_x_by_start_wx = mass_tt * start_tangent_a_x_by_start_wx;
    const real end_tangent_force_x_by_start_wx = mass_tu * start_tangent_a_x_by_start_wx;
    const real start_tangent_a_x_by_start_wy = start_R_xz * minus_start_own_tangent_a_x
        + start_R_xx * start_own_tangent_a_z;
    const real start_tangent_a_y_by_start_wy = start_R_yz * minus_start_own_tangent_a_x
        + start_R_yx * start_own_tangent_a_z;
    const real start_tangent_force_x_by_start_wy = mass_tt * start_tangent_a_x_by_start_wy;
    const real start_tangent_force_y_by_start_wy = mass_tt * start_tangent_a_y_by_start_wy;
    const real end_tangent_force_x_by_start_wy = mass_tu * start_tangent_a_x_by_start_wy;
    const real end_tangent_force_y_by_start_wy = mass_tu * start_tangent_a_y_by_start_wy;
    const real minus_start_tangent_a_x_by_start_wz = start_R_xy * minus_start_own_tangent_a_x
        + start_R_xx * start_own_tangent_a_y;
    const real minus_start_tangent_a_z_by_start_wz = start_R_zy * minus_start_own_tangent_a_x
        + start_R_zx * start_own_tangent_a_y;
    const real minus_start_tangent_force_x_by_start_wz = mass_tt *
        minus_start_tangent_a_x_by_start_wz;
    const real minus_start_tangent_force_z_by_start_wz = mass_tt *
        minus_start_tangent_a_z_by_start_wz;
    const real minus_end_tangent_force_x_by_start_wz = mass_tu *
        minus_start_tangent_a_x_by_start_wz;
    const real minus_end_tangent_force_z_by_start_wz = mass_tu *
        minus_start_tangent_a_z_by_start_wz;
    const real end_tangent_a_x_by_end_wx = end_R_xz * end_own_tangent_a_y
        - end_R_xy * end_own_tangent_a_z;
    const real start_tangent_force_x_by_end_wx = mass_tu * end_tangent_a_x_by_end_wx;
    const real end_tangent_force_x_by_end_wx = mass_tt * end_tangent_a_x_by_end_wx;
    const real end_tangent_a_x_by_end_wy = end_R_xz * minus_end_own_tangent_a_x
        + end_R_xx * end_own_tangent_a_z;
    const real end_tangent_a_y_by_end_wy = end_R_yz * minus_end_own_tangent_a_x
        + end_R_yx * end_own_tangent_a_z;
    const real start_tangent_force_x_by_end_wy = mass_tu * end_tangent_a_x_by_end_wy;
    const real start_tangent_force_y_by_end_wy = mass_tu * end_tangent_a_y_by_end_wy;
    const real end_tangent_force_x_by_end_wy = mass_tt * end_tangent_a_x_by_end_wy;
    const real end_tangent_force_y_by_end_wy = mass_tt * end_tangent_a_y_by_end_wy;
    const real minus_end_tangent_a_x_by_end_wz = end_R_xy * minus_end_own_tangent_a_x
        + end_R_xx * end_own_tangent_a_y;
    const real minus_end_tangent_a_z_by_end_wz = end_R_zy * minus_end_own_tangent_a_x
        + end_R_zx * end_own_tangent_a_y;
    const real minus_start_tangent_force_x_by_end_wz = mass_tu * minus_end_tangent_a_x_by_end_wz;
    const real minus_start_tangent_force_z_by_end_wz = mass_tu * minus_end_tangent_a_z_by_end_wz;
    const real minus_end_tangent_force_x_by_end_wz = mass_tt * minus_end_tangent_a_x_by_end_wz;
    const real minus_end_tangent_force_z_by_end_wz = mass_tt * minus_end_tangent_a_z_by_end_wz;
    const real start_tangent_a_x_by_u_start_wx = start_R_xy * start_wy + start_R_xz * start_wz;
    const real start_tangent_force_x_by_u_start_wx = mass_tt * start_tangent_a_x_by_u_start_wx;
    const real end_tangent_force_x_by_u_start_wx = mass_tu * start_tangent_a_x_by_u_start_wx;
    const real minus_start_own_tangent_a_x_by_u_start_wy = start_wy + start_wy;
    const real start_tangent_a_x_by_u_start_wy = start_R_xy * start_wx
        - start_R_xx * minus_start_own_tangent_a_x_by_u_start_wy;
    const real start_tangent_a_z_by_u_start_wy = start_R_zy * start_wx
        - start_R_zx * minus_start_own_tangent_a_x_by_u_start_wy;
    const real start_tangent_force_x_by_u_start_wy = mass_tt * start_tangent_a_x_by_u_start_wy;
    const real start_tangent_force_z_by_u_start_wy = mass_tt * start_tangent_a_z_by_u_start_wy;
    const real end_tangent_force_x_by_u_start_wy = mass_tu * start_tangent_a_x_by_u_start_wy;
    const real end_tangent_force_z_by_u_start_wy = mass_tu * start_tangent_a_z_by_u_start_wy;
    const real minus_start_own_tangent_a_x_by_u_start_wz = start_wz + start_wz;
    const real start_tangent_a_x_by_u_start_wz = start_R_xz * start_wx
        - start_R_xx * minus_start_own_tangent_a_x_by_u_start_wz;
    const real start_tangent_a_y_by_u_start_wz = start_R_yz * start_wx
        - start_R_yx * minus_start_own_tangent_a_x_by_u_start_wz;
    const real start_tangent_force_x_by_u_start_wz = mass_tt * start_tangent_a_x_by_u_start_wz;
    const real start_tangent_force_y_by_u_start_wz = mass_tt * start_tangent_a_y_by_u_start_wz;
    const real end_tangent_force_x_by_u_start_wz = mass_tu * start_tangent_a_x_by_u_start_wz;
    const real end_tangent_force_y_by_u_start_wz = mass_tu * start_tangent_a_y_by_u_start_wz;
    const real end_tangent_a_x_by_u_end_wx = end_R_xy * end_wy + end_R_xz * end_wz;
    const real start_tangent_force_x_by_u_end_wx = mass_tu * end_tangent_a_x_by_u_end_wx;
    const real end_tangent_force_x_by_u_end_wx = mass_tt * end_tangent_a_x_by_u_end_wx;
    const real minus_end_own_tangent_a_x_by_u_end_wy = end_wy + end_wy;
    const real end_tangent_a_x_by_u_end_wy = end_R_xy * end_wx
        - end_R_xx * minus_end_own_tangent_a_x_by_u_end_wy;
    const real end_tangent_a_z_by_u_end_wy = end_R_zy * end_wx
        - end_R_zx * minus_end_own_tangent_a_x_by_u_end_wy;
    const real start_tangent_force_x_by_u_end_wy = mass_tu * end_tangent_a_x_by_u_end_wy;
    const real start_tangent_force_z_by_u_end_wy = mass_tu * end_tangent_a_z_by_u_end_wy;
    const real end_tangent_force_x_by_u_end_wy = mass_tt * end_tangent_a_x_by_u_end_wy;
    const real end_tangent_force_z_by_u_end_wy = mass_tt * end_tangent_a_z_by_u_end_wy;
    const real minus_end_own_tangent_a_x_by_u_end_wz = end_wz + end_wz;
    const real end_tangent_a_x_by_u_end_wz = end_R_xz * end_wx
        - end_R_xx * minus_end_own_tangent_a_x_by_u_end_wz;
    const real end_tangent_a_y_by_u_end_wz = end_R_yz * end_wx
        - end_R_yx * minus_end_own_tangent_a_x_by_u_end_wz;
    const real start_tangent_force_x_by_u_end_wz = mass_tu * end_tangent_a_x_by_u_end_wz;
    const real start_tangent_force_y_by_u_end_wz = mass_tu * end_tangent_a_y_by_u_end_wz;
    const real end_tangent_force_x_by_u_end_wz = mass_tt * end_tangent_a_x_by_u_end_wz;
    const real end_tangent_force_y_by_u_end_wz = mass_tt * end_tangent_a_y_by_u_end_wz;
    const real minus_start_tangent_force_x_by_udot_start_wy = start_R_xz * mass_tt;
    const real minus_start_tangent_force_y_by_udot_start_wy = start_R_yz * mass_tt;
    const real start_force_x_by_udot_start_wy = -start_R_xz * mass_pt;
    const real start_force_y_by_udot_start_wy = -start_R_yz * mass_pt;
    const real minus_end_tangent_force_x_by_udot_start_wy = start_R_xz * mass_tu;
    const real minus_end_tangent_force_y_by_udot_start_wy = start_R_yz * mass_tu;
    const real end_force_x_by_udot_start_wy = start_R_xz * mass_pu;
    const real end_force_y_by_udot_start_wy = start_R_yz * mass_pu;
    const real start_tangent_force_x_by_udot_start_wz = start_R_xy * mass_tt;
    const real start_tangent_force_z_by_udot_start_wz = start_R_zy * mass_tt;
    const real start_force_x_by_udot_start_wz = start_R_xy * mass_pt;
    const real start_force_z_by_udot_start_wz = start_R_zy * mass_pt;
    const real end_tangent_force_x_by_udot_start_wz = start_R_xy * mass_tu;
    const real end_tangent_force_z_by_udot_start_wz = start_R_zy * mass_tu;
    const real end_force_x_by_udot_start_wz = -start_R_xy * mass_pu;
    const real end_force_z_by_udot_start_wz = -start_R_zy * mass_pu;
    const real end_own_tangent_force_y_by_udot_start_vx = end_R_xy * mass_pu;
    const real end_moment_y_by_udot_start_vx = -end_R_xz * mass_pu;
    const real end_moment_y_by_udot_start_vy = -end_R_yz * mass_pu;
    const real end_own_tangent_force_y_by_udot_start_vz = end_R_zy * mass_pu;
    const real minus_start_tangent_force_x_by_udot_end_wy = end_R_xz * mass_tu;
    const real minus_start_tangent_force_y_by_udot_end_wy = end_R_yz * mass_tu;
    const real minus_end_tangent_force_x_by_udot_end_wy = end_R_xz * mass_tt;
    const real minus_end_tangent_force_y_by_udot_end_wy = end_R_yz * mass_tt;
    const real end_force_x_by_udot_end_wy = end_R_xz * mass_pt;
    const real end_force_y_by_udot_end_wy = end_R_yz * mass_pt;
    const real start_tangent_force_x_by_udot_end_wz = end_R_xy * mass_tu;
    const real start_tangent_force_z_by_udot_end_wz = end_R_zy * mass_tu;
    const real end_tangent_force_x_by_udot_end_wz = end_R_xy * mass_tt;
    const real end_tangent_force_z_by_udot_end_wz = end_R_zy * mass_tt;
    const real end_force_x_by_udot_end_wz = -end_R_xy * mass_pt;
    const real end_force_z_by_udot_end_wz = -end_R_zy * mass_pt;
    out[36] = mass_pt * start_tangent_a_x_by_start_wx; /* K: start.vx,start.wx */
    out[108] = -mass_pu * start_tangent_a_x_by_start_wx; /* K: end.vx,start.wx */
    out[37] = mass_pt * start_tangent_a_x_by_start_wy; /* K: start.vx,start.wy */
    out[49] = mass_pt * start_tangent_a_y_by_start_wy; /* K: start.vy,start.wy */
    out[109] = -mass_pu * start_tangent_a_x_by_start_wy; /* K: end.vx,start.wy */
    out[121] = -mass_pu * start_tangent_a_y_by_start_wy; /* K: end.vy,start.wy */
    out[38] = -mass_pt * minus_start_tangent_a_x_by_start_wz; /* K: start.vx,start.wz */
    out[62] = -mass_pt * minus_start_tangent_a_z_by_start_wz; /* K: start.vz,start.wz */
    out[110] = mass_pu * minus_start_tangent_a_x_by_start_wz; /* K: end.vx,start.wz */
    out[134] = mass_pu * minus_start_tangent_a_z_by_start_wz; /* K: end.vz,start.wz */
    out[42] = mass_pu * end_tangent_a_x_by_end_wx; /* K: start.vx,end.wx */
    out[114] = -mass_pt * end_tangent_a_x_by_end_wx; /* K: end.vx,end.wx */
    out[43] = mass_pu * end_tangent_a_x_by_end_wy; /* K: start.vx,end.wy */
    out[55] = mass_pu * end_tangent_a_y_by_end_wy; /* K: start.vy,end.wy */
    out[115] = -mass_pt * end_tangent_a_x_by_end_wy; /* K: end.vx,end.wy */
    out[127] = -mass_pt * end_tangent_a_y_by_end_wy; /* K: end.vy,end.wy */
    out[44] = -mass_pu * minus_end_tangent_a_x_by_end_wz; /* K: start.vx,end.wz */
    out[68] = -mass_pu * minus_end_tangent_a_z_by_end_wz; /* K: start.vz,end.wz */
    out[116] = mass_pt * minus_end_tangent_a_x_by_end_wz; /* K: end.vx,end.wz */
    out[140] = mass_pt * minus_end_tangent_a_z_by_end_wz; /* K: end.vz,end.wz */
    out[180] = mass_pt * start_tangent_a_x_by_u_start_wx; /* C: start.vx,start.wx */
    out[252] = -mass_pu * start_tangent_a_x_by_u_start_wx; /* C: end.vx,start.wx */
    out[145] = start_spin_z - start_wz * start_spin_y_by_u_start_wy; /* C: start.wx,start.wy */
    out[181] = mass_pt * start_tangent_a_x_by_u_start_wy; /* C: start.vx,start.wy */
    out[205] = mass_pt * start_tangent_a_z_by_u_start_wy; /* C: start.vz,start.wy */
    out[217] = -end_wz * end_spin_y_by_u_start_wy; /* C: end.wx,start.wy */
    out[253] = -mass_pu * start_tangent_a_x_by_u_start_wy; /* C: end.vx,start.wy */
    out[277] = -mass_pu * start_tangent_a_z_by_u_start_wy; /* C: end.vz,start.wy */
    out[146] = start_wy * start_spin_z_by_u_start_wz - start_spin_y; /* C: start.wx,start.wz */
    out[182] = mass_pt * start_tangent_a_x_by_u_start_wz; /* C: start.vx,start.wz */
    out[194] = mass_pt * start_tangent_a_y_by_u_start_wz; /* C: start.vy,start.wz */
    out[218] = end_wy * end_spin_z_by_u_start_wz; /* C: end.wx,start.wz */
    out[254] = -mass_pu * start_tangent_a_x_by_u_start_wz; /* C: end.vx,start.wz */
    out[266] = -mass_pu * start_tangent_a_y_by_u_start_wz; /* C: end.vy,start.wz */
    out[186] = mass_pu * end_tangent_a_x_by_u_end_wx; /* C: start.vx,end.wx */
    out[258] = -mass_pt * end_tangent_a_x_by_u_end_wx; /* C: end.vx,end.wx */
    out[151] = -start_wz * end_spin_y_by_u_start_wy; /* C: start.wx,end.wy */
    out[187] = mass_pu * end_tangent_a_x_by_u_end_wy; /* C: start.vx,end.wy */
    out[211] = mass_pu * end_tangent_a_z_by_u_end_wy; /* C: start.vz,end.wy */
    out[223] = end_spin_z - end_wz * start_spin_y_by_u_start_wy; /* C: end.wx,end.wy */
    out[259] = -mass_pt * end_tangent_a_x_by_u_end_wy; /* C: end.vx,end.wy */
    out[283] = -mass_pt * end_tangent_a_z_by_u_end_wy; /* C: end.vz,end.wy */
    out[152] = start_wy * end_spin_z_by_u_start_wz; /* C: start.wx,end.wz */
    out[188] = mass_pu * end_tangent_a_x_by_u_end_wz; /* C: start.vx,end.wz */
    out[200] = mass_pu * end_tangent_a_y_by_u_end_wz; /* C: start.vy,end.wz */
    out[224] = end_wy * start_spin_z_by_u_start_wz - end_spin_y; /* C: end.wx,end.wz */
    out[260] = -mass_pt * end_tangent_a_x_by_u_end_wz; /* C: end.vx,end.wz */
    out[272] = -mass_pt * end_tangent_a_y_by_u_end_wz; /* C: end.vy,end.wz */
    out[303] = start_force_x_by_udot_start_wy; /* M: start.wy,start.vx */
    out[325] = start_force_x_by_udot_start_wy; /* M: start.vx,start.wy */
    out[304] = start_force_y_by_udot_start_wy; /* M: start.wy,start.vy */
    out[337] = start_force_y_by_udot_start_wy; /* M: start.vy,start.wy */
    out[309] = end_force_x_by_udot_start_wy; /* M: start.wy,end.vx */
    out[397] = end_force_x_by_udot_start_wy; /* M: end.vx,start.wy */
    out[310] = end_force_y_by_udot_start_wy; /* M: start.wy,end.vy */
    out[409] = end_force_y_by_udot_start_wy; /* M: end.vy,start.wy */
    out[315] = start_force_x_by_udot_start_wz; /* M: start.wz,start.vx */
    out[326] = start_force_x_by_udot_start_wz; /* M: start.vx,start.wz */
    out[317] = start_force_z_by_udot_start_wz; /* M: start.wz,start.vz */
    out[350] = start_force_z_by_udot_start_wz; /* M: start.vz,start.wz */
    out[321] = end_force_x_by_udot_start_wz; /* M: start.wz,end.vx */
    out[398] = end_force_x_by_udot_start_wz; /* M: end.vx,start.wz */
    out[323] = end_force_z_by_udot_start_wz; /* M: start.wz,end.vz */
    out[422] = end_force_z_by_udot_start_wz; /* M: end.vz,start.wz */
    out[332] = end_own_tangent_force_y_by_udot_start_vx; /* M: start.vx,end.wz */
    out[387] = end_own_tangent_force_y_by_udot_start_vx; /* M: end.wz,start.vx */
    out[331] = end_moment_y_by_udot_start_vx; /* M: start.vx,end.wy */
    out[375] = end_moment_y_by_udot_start_vx; /* M: end.wy,start.vx */
    out[343] = end_moment_y_by_udot_start_vy; /* M: start.vy,end.wy */
    out[376] = end_moment_y_by_udot_start_vy; /* M: end.wy,start.vy */
    out[356] = end_own_tangent_force_y_by_udot_start_vz; /* M: start.vz,end.wz */
    out[389] = end_own_tangent_force_y_by_udot_start_vz; /* M: end.wz,start.vz */
    out[381] = end_force_x_by_udot_end_wy; /* M: end.wy,end.vx */
    out[403] = end_force_x_by_udot_end_wy; /* M: end.vx,end.wy */
    out[382] = end_force_y_by_udot_end_wy; /* M: end.wy,end.vy */
    out[415] = end_force_y_by_udot_end_wy; /* M: end.vy,end.wy */
    out[393] = end_force_x_by_udot_end_wz; /* M: end.wz,end.vx */
    out[404] = end_force_x_by_udot_end_wz; /* M: end.vx,end.wz */
    out[395] = end_force_z_by_udot_end_wz; /* M: end.wz,end.vz */
    out[428] = end_force_z_by_udot_end_wz; /* M: end.vz,end.wz */

    /* energy */
    const real start_R_yy = one_minus_start_qx_times_twice_start_qx - start_qz_times_twice_start_qz;
    const real start_R_zz = one_minus_start_qx_times_twice_start_qx - start_qy_times_twice_start_qy;
    const real end_R_yy = one_minus_end_qx_times_twice_end_qx - end_qz_times_twice_end_qz;
    const real end_R_zz = one_minus_end_qx_times_twice_end_qx - end_qy_times_twice_end_qy;

    /* loads */
    const wreal end_spin_x_by_u_start_wx = w[12];
    const real start_tangent_a_y = start_R_yz * start_own_tangent_a_z
        - start_R_yx * minus_start_own_tangent_a_x + start_R_yy * start_own_tangent_a_y;
    const real start_tangent_a_z = start_R_zy * start_own_tangent_a_y
        - start_R_zx * minus_start_own_tangent_a_x + start_R_zz * start_own_tangent_a_z;
    const real end_tangent_a_y = end_R_yz * end_own_tangent_a_z
        - end_R_yx * minus_end_own_tangent_a_x + end_R_yy * end_own_tangent_a_y;
    const real end_tangent_a_z = end_R_zy * end_own_tangent_a_y
        - end_R_zx * minus_end_own_tangent_a_x + end_R_zz * end_own_tangent_a_z;
    const real start_tangent_force_y = start_a_y * mass_pt - end_a_y * mass_pu
        + start_tangent_a_y * mass_tt + end_tangent_a_y * mass_tu;
    const real start_tangent_force_z = start_a_z * mass_pt - end_a_z * mass_pu
        + start_tangent_a_z * mass_tt + end_tangent_a_z * mass_tu;
    const real start_R_zx_times_start_tangent_force_z = start_R_zx * start_tangent_force_z;
    const real end_tangent_force_y = start_a_y * mass_pu - end_a_y * mass_pt
        + start_tangent_a_y * mass_tu + end_tangent_a_y * mass_tt;
    const real end_tangent_force_z = start_a_z * mass_pu - end_a_z * mass_pt
        + start_tangent_a_z * mass_tu + end_tangent_a_z * mass_tt;
    const real end_R_zx_times_end_tangent_force_z = end_R_zx * end_tangent_force_z;
    const real start_tangent_a_y_by_start_wx = start_R_yz * start_own_tangent_a_y
        - start_R_yy * start_own_tangent_a_z;
    const real start_tangent_a_z_by_start_wx = start_R_zz * start_own_tangent_a_y
        - start_R_zy * start_own_tangent_a_z;
    const real start_tangent_force_y_by_start_wx = mass_tt * start_tangent_a_y_by_start_wx;
    const real start_tangent_force_z_by_start_wx = mass_tt * start_tangent_a_z_by_start_wx;
    const real start_own_tangent_force_y_by_start_wx_part = start_R_xy *
        start_tangent_force_x_by_start_wx + start_R_yy * start_tangent_force_y_by_start_wx
        + start_R_zy * start_tangent_force_z_by_start_wx + start_R_zz * start_tangent_force_z;
    const real end_tangent_force_y_by_start_wx = mass_tu * start_tangent_a_y_by_start_wx;
    const real end_tangent_force_z_by_start_wx = mass_tu * start_tangent_a_z_by_start_wx;
    const real start_tangent_a_z_by_start_wy = start_R_zz * minus_start_own_tangent_a_x
        + start_R_zx * start_own_tangent_a_z;
    const real start_tangent_force_z_by_start_wy = mass_tt * start_tangent_a_z_by_start_wy;
    const real minus_start_moment_y_by_start_wy_part = start_R_xx * start_tangent_force_x
        + start_R_yx * start_tangent_force_y;
    const real end_tangent_force_z_by_start_wy = mass_tu * start_tangent_a_z_by_start_wy;
    const real minus_start_tangent_a_y_by_start_wz = start_R_yy * minus_start_own_tangent_a_x
        + start_R_yx * start_own_tangent_a_y;
    const real minus_start_tangent_force_y_by_start_wz = mass_tt *
        minus_start_tangent_a_y_by_start_wz;
    const real minus_end_tangent_force_y_by_start_wz = mass_tu *
        minus_start_tangent_a_y_by_start_wz;
    const real end_tangent_a_y_by_end_wx = end_R_yz * end_own_tangent_a_y
        - end_R_yy * end_own_tangent_a_z;
    const real end_tangent_a_z_by_end_wx = end_R_zz * end_own_tangent_a_y
        - end_R_zy * end_own_tangent_a_z;
    const real start_tangent_force_y_by_end_wx = mass_tu * end_tangent_a_y_by_end_wx;
    const real start_tangent_force_z_by_end_wx = mass_tu * end_tangent_a_z_by_end_wx;
    const real end_tangent_force_y_by_end_wx = mass_tt * end_tangent_a_y_by_end_wx;
    const real end_tangent_force_z_by_end_wx = mass_tt * end_tangent_a_z_by_end_wx;
    const real end_tangent_a_z_by_end_wy = end_R_zz * minus_end_own_tangent_a_x
        + end_R_zx * end_own_tangent_a_z;
    const real start_tangent_force_z_by_end_wy = mass_tu * end_tangent_a_z_by_end_wy;
    const real end_tangent_force_z_by_end_wy = mass_tt * end_tangent_a_z_by_end_wy;
    const real minus_end_moment_y_by_end_wy_part = end_R_xx * end_tangent_force_x
        + end_R_yx * end_tangent_force_y;
    const real minus_end_tangent_a_y_by_end_wz = end_R_yy * minus_end_own_tangent_a_x
        + end_R_yx * end_own_tangent_a_y;
    const real minus_start_tangent_force_y_by_end_wz = mass_tu * minus_end_tangent_a_y_by_end_wz;
    const real minus_end_tangent_force_y_by_end_wz = mass_tt * minus_end_tangent_a_y_by_end_wz;
    const real start_tangent_a_y_by_u_start_wx = start_R_yy * start_wy + start_R_yz * start_wz;
    const real start_tangent_a_z_by_u_start_wx = start_R_zy * start_wy + start_R_zz * start_wz;
    const real start_tangent_force_y_by_u_start_wx = mass_tt * start_tangent_a_y_by_u_start_wx;
    const real start_tangent_force_z_by_u_start_wx = mass_tt * start_tangent_a_z_by_u_start_wx;
    const real end_tangent_force_y_by_u_start_wx = mass_tu * start_tangent_a_y_by_u_start_wx;
    const real end_tangent_force_z_by_u_start_wx = mass_tu * start_tangent_a_z_by_u_start_wx;
    const real start_tangent_a_y_by_u_start_wy = start_R_yy * start_wx
        - start_R_yx * minus_start_own_tangent_a_x_by_u_start_wy;
    const real start_tangent_force_y_by_u_start_wy = mass_tt * start_tangent_a_y_by_u_start_wy;
    const real end_tangent_force_y_by_u_start_wy = mass_tu * start_tangent_a_y_by_u_start_wy;
    const real start_tangent_a_z_by_u_start_wz = start_R_zz * start_wx
        - start_R_zx * minus_start_own_tangent_a_x_by_u_start_wz;
    const real start_tangent_force_z_by_u_start_wz = mass_tt * start_tangent_a_z_by_u_start_wz;
    const real end_tangent_force_z_by_u_start_wz = mass_tu * start_tangent_a_z_by_u_start_wz;
    const real end_tangent_a_y_by_u_end_wx = end_R_yy * end_wy + end_R_yz * end_wz;
    const real end_tangent_a_z_by_u_end_wx = end_R_zy * end_wy + end_R_zz * end_wz;
    const real start_tangent_force_y_by_u_end_wx = mass_tu * end_tangent_a_y_by_u_end_wx;
    const real start_tangent_force_z_by_u_end_wx = mass_tu * end_tangent_a_z_by_u_end_wx;
    const real end_tangent_force_y_by_u_end_wx = mass_tt * end_tangent_a_y_by_u_end_wx;
    const real end_tangent_force_z_by_u_end_wx = mass_tt * end_tangent_a_z_by_u_end_wx;
    const real end_tangent_a_y_by_u_end_wy = end_R_yy * end_wx
        - end_R_yx * minus_end_own_tangent_a_x_by_u_end_wy;
    const real start_tangent_force_y_by_u_end_wy = mass_tu * end_tangent_a_y_by_u_end_wy;
    const real end_tangent_force_y_by_u_end_wy = mass_tt * end_tangent_a_y_by_u_end_wy;
    const real end_tangent_a_z_by_u_end_wz = end_R_zz * end_wx
        - end_R_zx * minus_end_own_tangent_a_x_by_u_end_wz;
    const real start_tangent_force_z_by_u_end_wz = mass_tu * end_tangent_a_z_by_u_end_wz;
    const real end_tangent_force_z_by_u_end_wz = mass_tt * end_tangent_a_z_by_u_end_wz;
    const real minus_start_tangent_force_z_by_udot_start_wy = start_R_zz * mass_tt;
    const real start_force_z_by_udot_start_wy = -start_R_zz * mass_pt;
    const real minus_end_tangent_force_z_by_udot_start_wy = start_R_zz * mass_tu;
    const real end_force_z_by_udot_start_wy = start_R_zz * mass_pu;
    const real start_tangent_force_y_by_udot_start_wz = start_R_yy * mass_tt;
    const real start_force_y_by_udot_start_wz = start_R_yy * mass_pt;
    const real end_tangent_force_y_by_udot_start_wz = start_R_yy * mass_tu;
    const real end_force_y_by_udot_start_wz = -start_R_yy * mass_pu;
    const real end_own_tangent_force_y_by_udot_start_vy = end_R_yy * mass_pu;
    const real end_moment_y_by_udot_start_vz = -end_R_zz * mass_pu;
    const real minus_start_tangent_force_z_by_udot_end_wy = end_R_zz * mass_tu;
    const real minus_end_tangent_force_z_by_udot_end_wy = end_R_zz * mass_tt;
    const real end_force_z_by_udot_end_wy = end_R_zz * mass_pt;
    const real start_tangent_force_y_by_udot_end_wz = end_R_yy * mass_tu;
    const real end_tangent_force_y_by_udot_end_wz = end_R_yy * mass_tt;
    const real end_force_y_by_udot_end_wz = -end_R_yy * mass_pt;
    /* K: start.wz,start.wx */
    out[24] = start_R_xz * start_tangent_force_x + start_R_yz * start_tangent_force_y
        + start_own_tangent_force_y_by_start_wx_part;
    /* K: start.wy,start.wx */
    out[12] = start_R_xy * start_tangent_force_x + start_R_yy * start_tangent_force_y
        + (start_R_zy * start_tangent_force_z - (start_R_xz * start_tangent_force_x_by_start_wx
        + start_R_yz * start_tangent_force_y_by_start_wx
        + start_R_zz * start_tangent_force_z_by_start_wx));
    out[48] = mass_pt * start_tangent_a_y_by_start_wx; /* K: start.vy,start.wx */
    out[60] = mass_pt * start_tangent_a_z_by_start_wx; /* K: start.vz,start.wx */
    /* K: end.wz,start.wx */
    out[96] = end_R_xy * end_tangent_force_x_by_start_wx
        + end_R_yy * end_tangent_force_y_by_start_wx + end_R_zy * end_tangent_force_z_by_start_wx;
    /* K: end.wy,start.wx */
    out[84] = -(end_R_xz * end_tangent_force_x_by_start_wx
        + end_R_yz * end_tangent_force_y_by_start_wx + end_R_zz * end_tangent_force_z_by_start_wx);
    out[120] = -mass_pu * start_tangent_a_y_by_start_wx; /* K: end.vy,start.wx */
    out[132] = -mass_pu * start_tangent_a_z_by_start_wx; /* K: end.vz,start.wx */
    /* K: start.wz,start.wy */
    out[25] = start_R_xy * start_tangent_force_x_by_start_wy
        + start_R_yy * start_tangent_force_y_by_start_wy
        + start_R_zy * start_tangent_force_z_by_start_wy;
    /* K: start.wy,start.wy */
    out[13] = -(start_R_xz * start_tangent_force_x_by_start_wy
        + start_R_yz * start_tangent_force_y_by_start_wy
        + start_R_zz * start_tangent_force_z_by_start_wy + start_R_zx_times_start_tangent_force_z
        + minus_start_moment_y_by_start_wy_part);
    out[61] = mass_pt * start_tangent_a_z_by_start_wy; /* K: start.vz,start.wy */
    /* K: end.wz,start.wy */
    out[97] = end_R_xy * end_tangent_force_x_by_start_wy
        + end_R_yy * end_tangent_force_y_by_start_wy + end_R_zy * end_tangent_force_z_by_start_wy;
    /* K: end.wy,start.wy */
    out[85] = -(end_R_xz * end_tangent_force_x_by_start_wy
        + end_R_yz * end_tangent_force_y_by_start_wy + end_R_zz * end_tangent_force_z_by_start_wy);
    out[133] = -mass_pu * start_tangent_a_z_by_start_wy; /* K: end.vz,start.wy */
    /* K: start.wz,start.wz */
    out[26] = -(start_R_xy * minus_start_tangent_force_x_by_start_wz
        + start_R_zy * minus_start_tangent_force_z_by_start_wz
        + start_R_yy * minus_start_tangent_force_y_by_start_wz
        + start_R_zx_times_start_tangent_force_z + minus_start_moment_y_by_start_wy_part);
    /* K: start.wy,start.wz */
    out[14] = start_R_xz * minus_start_tangent_force_x_by_start_wz
        + start_R_zz * minus_start_tangent_force_z_by_start_wz
        + start_R_yz * minus_start_tangent_force_y_by_start_wz;
    out[50] = -mass_pt * minus_start_tangent_a_y_by_start_wz; /* K: start.vy,start.wz */
    /* K: end.wz,start.wz */
    out[98] = -(end_R_xy * minus_end_tangent_force_x_by_start_wz
        + end_R_zy * minus_end_tangent_force_z_by_start_wz
        + end_R_yy * minus_end_tangent_force_y_by_start_wz);
    /* K: end.wy,start.wz */
    out[86] = end_R_xz * minus_end_tangent_force_x_by_start_wz
        + end_R_zz * minus_end_tangent_force_z_by_start_wz
        + end_R_yz * minus_end_tangent_force_y_by_start_wz;
    out[122] = mass_pu * minus_start_tangent_a_y_by_start_wz; /* K: end.vy,start.wz */
    /* K: start.wz,end.wx */
    out[30] = start_R_xy * start_tangent_force_x_by_end_wx
        + start_R_yy * start_tangent_force_y_by_end_wx
        + start_R_zy * start_tangent_force_z_by_end_wx;
    /* K: start.wy,end.wx */
    out[18] = -(start_R_xz * start_tangent_force_x_by_end_wx
        + start_R_yz * start_tangent_force_y_by_end_wx
        + start_R_zz * start_tangent_force_z_by_end_wx);
    out[54] = mass_pu * end_tangent_a_y_by_end_wx; /* K: start.vy,end.wx */
    out[66] = mass_pu * end_tangent_a_z_by_end_wx; /* K: start.vz,end.wx */
    /* K: end.wz,end.wx */
    out[102] = end_R_xz * end_tangent_force_x + end_R_yz * end_tangent_force_y
        + (end_R_xy * end_tangent_force_x_by_end_wx + end_R_yy * end_tangent_force_y_by_end_wx
        + end_R_zy * end_tangent_force_z_by_end_wx + end_R_zz * end_tangent_force_z);
    /* K: end.wy,end.wx */
    out[90] = end_R_xy * end_tangent_force_x + end_R_yy * end_tangent_force_y
        + (end_R_zy * end_tangent_force_z - (end_R_xz * end_tangent_force_x_by_end_wx
        + end_R_yz * end_tangent_force_y_by_end_wx + end_R_zz * end_tangent_force_z_by_end_wx));
    out[126] = -mass_pt * end_tangent_a_y_by_end_wx; /* K: end.vy,end.wx */
    out[138] = -mass_pt * end_tangent_a_z_by_end_wx; /* K: end.vz,end.wx */
    /* K: start.wz,end.wy */
    out[31] = start_R_xy * start_tangent_force_x_by_end_wy
        + start_R_yy * start_tangent_force_y_by_end_wy
        + start_R_zy * start_tangent_force_z_by_end_wy;
    /* K: start.wy,end.wy */
    out[19] = -(start_R_xz * start_tangent_force_x_by_end_wy
        + start_R_yz * start_tangent_force_y_by_end_wy
        + start_R_zz * start_tangent_force_z_by_end_wy);
    out[67] = mass_pu * end_tangent_a_z_by_end_wy; /* K: start.vz,end.wy */
    /* K: end.wz,end.wy */
    out[103] = end_R_xy * end_tangent_force_x_by_end_wy
        + end_R_yy * end_tangent_force_y_by_end_wy + end_R_zy * end_tangent_force_z_by_end_wy;
    /* K: end.wy,end.wy */
    out[91] = -(end_R_xz * end_tangent_force_x_by_end_wy
        + end_R_yz * end_tangent_force_y_by_end_wy + end_R_zz * end_tangent_force_z_by_end_wy
        + end_R_zx_times_end_tangent_force_z + minus_end_moment_y_by_end_wy_part);
    out[139] = -mass_pt * end_tangent_a_z_by_end_wy; /* K: end.vz,end.wy */
    /* K: start.wz,end.wz */
    out[32] = -(start_R_xy * minus_start_tangent_force_x_by_end_wz
        + start_R_zy * minus_start_tangent_force_z_by_end_wz
        + start_R_yy * minus_start_tangent_force_y_by_end_wz);
    /* K: start.wy,end.wz */
    out[20] = start_R_xz * minus_start_tangent_force_x_by_end_wz
        + start_R_zz * minus_start_tangent_force_z_by_end_wz
        + start_R_yz * minus_start_tangent_force_y_by_end_wz;
    out[56] = -mass_pu * minus_end_tangent_a_y_by_end_wz; /* K: start.vy,end.wz */
    /* K: end.wz,end.wz */
    out[104] = -(end_R_xy * minus_end_tangent_force_x_by_end_wz
        + end_R_zy * minus_end_tangent_force_z_by_end_wz
        + end_R_yy * minus_end_tangent_force_y_by_end_wz + end_R_zx_times_end_tangent_force_z
        + minus_end_moment_y_by_end_wy_part);
    /* K: end.wy,end.wz */
    out[92] = end_R_xz * minus_end_tangent_force_x_by_end_wz
        + end_R_zz * minus_end_tangent_force_z_by_end_wz
        + end_R_yz * minus_end_tangent_force_y_by_end_wz;
    out[128] = mass_pt * minus_end_tangent_a_y_by_end_wz; /* K: end.vy,end.wz */
    /* C: start.wy,start.wx */
    out[156] = start_wz * start_spin_x_by_u_start_wx - start_spin_z
        - start_R_xz * start_tangent_force_x_by_u_start_wx
        - (start_R_yz * start_tangent_force_y_by_u_start_wx
        + start_R_zz * start_tangent_force_z_by_u_start_wx);
    /* C: start.wz,start.wx */
    out[168] = start_spin_y - start_wy * start_spin_x_by_u_start_wx
        + start_R_xy * start_tangent_force_x_by_u_start_wx
        + (start_R_yy * start_tangent_force_y_by_u_start_wx
        + start_R_zy * start_tangent_force_z_by_u_start_wx);
    out[192] = mass_pt * start_tangent_a_y_by_u_start_wx; /* C: start.vy,start.wx */
    out[204] = mass_pt * start_tangent_a_z_by_u_start_wx; /* C: start.vz,start.wx */
    /* C: end.wy,start.wx */
    out[228] = end_wz * end_spin_x_by_u_start_wx - end_R_xz * end_tangent_force_x_by_u_start_wx
        - (end_R_yz * end_tangent_force_y_by_u_start_wx
        + end_R_zz * end_tangent_force_z_by_u_start_wx);
    /* C: end.wz,start.wx */
    out[240] = end_R_xy * end_tangent_force_x_by_u_start_wx - end_wy * end_spin_x_by_u_start_wx
        + (end_R_yy * end_tangent_force_y_by_u_start_wx
        + end_R_zy * end_tangent_force_z_by_u_start_wx);
    out[264] = -mass_pu * start_tangent_a_y_by_u_start_wx; /* C: end.vy,start.wx */
    out[276] = -mass_pu * start_tangent_a_z_by_u_start_wx; /* C: end.vz,start.wx */
    /* C: start.wy,start.wy */
    out[157] = -(start_R_xz * start_tangent_force_x_by_u_start_wy
        + start_R_zz * start_tangent_force_z_by_u_start_wy
        + start_R_yz * start_tangent_force_y_by_u_start_wy);
    /* C: start.wz,start.wy */
    out[169] = start_wx * start_spin_y_by_u_start_wy - start_spin_x
        + start_R_zy * start_tangent_force_z_by_u_start_wy
        + (start_R_xy * start_tangent_force_x_by_u_start_wy
        + start_R_yy * start_tangent_force_y_by_u_start_wy);
    out[193] = mass_pt * start_tangent_a_y_by_u_start_wy; /* C: start.vy,start.wy */
    /* C: end.wy,start.wy */
    out[229] = -(end_R_xz * end_tangent_force_x_by_u_start_wy
        + end_R_zz * end_tangent_force_z_by_u_start_wy
        + end_R_yz * end_tangent_force_y_by_u_start_wy);
    /* C: end.wz,start.wy */
    out[241] = end_R_zy * end_tangent_force_z_by_u_start_wy + end_wx * end_spin_y_by_u_start_wy
        + (end_R_xy * end_tangent_force_x_by_u_start_wy
        + end_R_yy * end_tangent_force_y_by_u_start_wy);
    out[265] = -mass_pu * start_tangent_a_y_by_u_start_wy; /* C: end.vy,start.wy */
    /* C: start.wz,start.wz */
    out[170] = start_R_xy * start_tangent_force_x_by_u_start_wz
        + start_R_yy * start_tangent_force_y_by_u_start_wz
        + start_R_zy * start_tangent_force_z_by_u_start_wz;
    /* C: start.wy,start.wz */
    out[158] = start_spin_x - start_wx * start_spin_z_by_u_start_wz
        - start_R_yz * start_tangent_force_y_by_u_start_wz
        - (start_R_xz * start_tangent_force_x_by_u_start_wz
        + start_R_zz * start_tangent_force_z_by_u_start_wz);
    out[206] = mass_pt * start_tangent_a_z_by_u_start_wz; /* C: start.vz,start.wz */
    /* C: end.wz,start.wz */
    out[242] = end_R_xy * end_tangent_force_x_by_u_start_wz
        + end_R_yy * end_tangent_force_y_by_u_start_wz
        + end_R_zy * end_tangent_force_z_by_u_start_wz;
    /* C: end.wy,start.wz */
    out[230] = -(end_R_yz * end_tangent_force_y_by_u_start_wz + end_wx * end_spin_z_by_u_start_wz
        + (end_R_xz * end_tangent_force_x_by_u_start_wz
        + end_R_zz * end_tangent_force_z_by_u_start_wz));
    out[278] = -mass_pu * start_tangent_a_z_by_u_start_wz; /* C: end.vz,start.wz */
    /* C: start.wy,end.wx */
    out[162] = start_wz * end_spin_x_by_u_start_wx
        - start_R_xz * start_tangent_force_x_by_u_end_wx
        - (start_R_yz * start_tangent_force_y_by_u_end_wx
        + start_R_zz * start_tangent_force_z_by_u_end_wx);
    /* C: start.wz,end.wx */
    out[174] = start_R_xy * start_tangent_force_x_by_u_end_wx
        - start_wy * end_spin_x_by_u_start_wx + (start_R_yy * start_tangent_force_y_by_u_end_wx
        + start_R_zy * start_tangent_force_z_by_u_end_wx);
    out[198] = mass_pu * end_tangent_a_y_by_u_end_wx; /* C: start.vy,end.wx */
    out[210] = mass_pu * end_tangent_a_z_by_u_end_wx; /* C: start.vz,end.wx */
    /* C: end.wy,end.wx */
    out[234] = end_wz * start_spin_x_by_u_start_wx - end_spin_z
        - end_R_xz * end_tangent_force_x_by_u_end_wx
        - (end_R_yz * end_tangent_force_y_by_u_end_wx + end_R_zz * end_tangent_force_z_by_u_end_wx);
    /* C: end.wz,end.wx */
    out[246] = end_spin_y - end_wy * start_spin_x_by_u_start_wx
        + end_R_xy * end_tangent_force_x_by_u_end_wx
        + (end_R_yy * end_tangent_force_y_by_u_end_wx + end_R_zy * end_tangent_force_z_by_u_end_wx);
    out[270] = -mass_pt * end_tangent_a_y_by_u_end_wx; /* C: end.vy,end.wx */
    out[282] = -mass_pt * end_tangent_a_z_by_u_end_wx; /* C: end.vz,end.wx */
    /* C: start.wy,end.wy */
    out[163] = -(start_R_xz * start_tangent_force_x_by_u_end_wy
        + start_R_zz * start_tangent_force_z_by_u_end_wy
        + start_R_yz * start_tangent_force_y_by_u_end_wy);
    /* C: start.wz,end.wy */
    out[175] = start_R_zy * start_tangent_force_z_by_u_end_wy
        + start_wx * end_spin_y_by_u_start_wy + (start_R_xy * start_tangent_force_x_by_u_end_wy
        + start_R_yy * start_tangent_force_y_by_u_end_wy);
    out[199] = mass_pu * end_tangent_a_y_by_u_end_wy; /* C: start.vy,end.wy */
    /* C: end.wy,end.wy */
    out[235] = -(end_R_xz * end_tangent_force_x_by_u_end_wy
        + end_R_zz * end_tangent_force_z_by_u_end_wy + end_R_yz * end_tangent_force_y_by_u_end_wy);
    /* C: end.wz,end.wy */
    out[247] = end_wx * start_spin_y_by_u_start_wy - end_spin_x
        + end_R_zy * end_tangent_force_z_by_u_end_wy
        + (end_R_xy * end_tangent_force_x_by_u_end_wy + end_R_yy * end_tangent_force_y_by_u_end_wy);
    out[271] = -mass_pt * end_tangent_a_y_by_u_end_wy; /* C: end.vy,end.wy */
    /* C: start.wz,end.wz */
    out[176] = start_R_xy * start_tangent_force_x_by_u_end_wz
        + start_R_yy * start_tangent_force_y_by_u_end_wz
        + start_R_zy * start_tangent_force_z_by_u_end_wz;
    /* C: start.wy,end.wz */
    out[164] = -(start_R_yz * start_tangent_force_y_by_u_end_wz
        + start_wx * end_spin_z_by_u_start_wz + (start_R_xz * start_tangent_force_x_by_u_end_wz
        + start_R_zz * start_tangent_force_z_by_u_end_wz));
    out[212] = mass_pu * end_tangent_a_z_by_u_end_wz; /* C: start.vz,end.wz */
    /* C: end.wz,end.wz */
    out[248] = end_R_xy * end_tangent_force_x_by_u_end_wz
        + end_R_yy * end_tangent_force_y_by_u_end_wz + end_R_zy * end_tangent_force_z_by_u_end_wz;
    /* C: end.wy,end.wz */
    out[236] = end_spin_x - end_wx * start_spin_z_by_u_start_wz
        - end_R_yz * end_tangent_force_y_by_u_end_wz
        - (end_R_xz * end_tangent_force_x_by_u_end_wz + end_R_zz * end_tangent_force_z_by_u_end_wz);
    out[284] = -mass_pt * end_tangent_a_z_by_u_end_wz; /* C: end.vz,end.wz */
    /* M: start.wz,start.wy */
    out[313] = -(start_R_xy * minus_start_tangent_force_x_by_udot_start_wy
        + start_R_yy * minus_start_tangent_force_y_by_udot_start_wy
        + start_R_zy * minus_start_tangent_force_z_by_udot_start_wy);
    /* M: start.wy,start.wy */
    out[301] = start_spin_y_by_u_start_wy
        + start_R_xz * minus_start_tangent_force_x_by_udot_start_wy
        + (start_R_yz * minus_start_tangent_force_y_by_udot_start_wy
        + start_R_zz * minus_start_tangent_force_z_by_udot_start_wy);
    out[305] = start_force_z_by_udot_start_wy; /* M: start.wy,start.vz */
    out[349] = start_force_z_by_udot_start_wy; /* M: start.vz,start.wy */
    /* M: end.wz,start.wy */
    out[385] = -(end_R_xy * minus_end_tangent_force_x_by_udot_start_wy
        + end_R_yy * minus_end_tangent_force_y_by_udot_start_wy
        + end_R_zy * minus_end_tangent_force_z_by_udot_start_wy);
    /* M: end.wy,start.wy */
    out[373] = end_spin_y_by_u_start_wy + end_R_xz * minus_end_tangent_force_x_by_udot_start_wy
        + (end_R_yz * minus_end_tangent_force_y_by_udot_start_wy
        + end_R_zz * minus_end_tangent_force_z_by_udot_start_wy);
    out[311] = end_force_z_by_udot_start_wy; /* M: start.wy,end.vz */
    out[421] = end_force_z_by_udot_start_wy; /* M: end.vz,start.wy */
    /* M: start.wy,start.wz */
    out[302] = -(start_R_xz * start_tangent_force_x_by_udot_start_wz
        + start_R_zz * start_tangent_force_z_by_udot_start_wz
        + start_R_yz * start_tangent_force_y_by_udot_start_wz);
    /* M: start.wz,start.wz */
    out[314] = start_spin_z_by_u_start_wz + start_R_xy * start_tangent_force_x_by_udot_start_wz
        + (start_R_yy * start_tangent_force_y_by_udot_start_wz
        + start_R_zy * start_tangent_force_z_by_udot_start_wz);
    out[316] = start_force_y_by_udot_start_wz; /* M: start.wz,start.vy */
    out[338] = start_force_y_by_udot_start_wz; /* M: start.vy,start.wz */
    /* M: end.wy,start.wz */
    out[374] = -(end_R_xz * end_tangent_force_x_by_udot_start_wz
        + end_R_zz * end_tangent_force_z_by_udot_start_wz
        + end_R_yz * end_tangent_force_y_by_udot_start_wz);
    /* M: end.wz,start.wz */
    out[386] = end_spin_z_by_u_start_wz + end_R_xy * end_tangent_force_x_by_udot_start_wz
        + (end_R_yy * end_tangent_force_y_by_udot_start_wz
        + end_R_zy * end_tangent_force_z_by_udot_start_wz);
    out[322] = end_force_y_by_udot_start_wz; /* M: start.wz,end.vy */
    out[410] = end_force_y_by_udot_start_wz; /* M: end.vy,start.wz */
    out[344] = end_own_tangent_force_y_by_udot_start_vy; /* M: start.vy,end.wz */
    out[388] = end_own_tangent_force_y_by_udot_start_vy; /* M: end.wz,start.vy */
    out[355] = end_moment_y_by_udot_start_vz; /* M: start.vz,end.wy */
    out[377] = end_moment_y_by_udot_start_vz; /* M: end.wy,start.vz */
    /* M: start.wz,end.wy */
    out[319] = -(start_R_xy * minus_start_tangent_force_x_by_udot_end_wy
        + start_R_yy * minus_start_tangent_force_y_by_udot_end_wy
        + start_R_zy * minus_start_tangent_force_z_by_udot_end_wy);
    /* M: start.wy,end.wy */
    out[307] = end_spin_y_by_u_start_wy + start_R_xz * minus_start_tangent_force_x_by_udot_end_wy
        + (start_R_yz * minus_start_tangent_force_y_by_udot_end_wy
        + start_R_zz * minus_start_tangent_force_z_by_udot_end_wy);
    /* M: end.wz,end.wy */
    out[391] = -(end_R_xy * minus_end_tangent_force_x_by_udot_end_wy
        + end_R_yy * minus_end_tangent_force_y_by_udot_end_wy
        + end_R_zy * minus_end_tangent_force_z_by_udot_end_wy);
    /* M: end.wy,end.wy */
    out[379] = start_spin_y_by_u_start_wy + end_R_xz * minus_end_tangent_force_x_by_udot_end_wy
        + (end_R_yz * minus_end_tangent_force_y_by_udot_end_wy
        + end_R_zz * minus_end_tangent_force_z_by_udot_end_wy);
    out[383] = end_force_z_by_udot_end_wy; /* M: end.wy,end.vz */
    out[427] = end_force_z_by_udot_end_wy; /* M: end.vz,end.wy */
    /* M: start.wy,end.wz */
    out[308] = -(start_R_xz * start_tangent_force_x_by_udot_end_wz
        + start_R_zz * start_tangent_force_z_by_udot_end_wz
        + start_R_yz * start_tangent_force_y_by_udot_end_wz);
    /* M: start.wz,end.wz */
    out[320] = end_spin_z_by_u_start_wz + start_R_xy * start_tangent_force_x_by_udot_end_wz
        + (start_R_yy * start_tangent_force_y_by_udot_end_wz
        + start_R_zy * start_tangent_force_z_by_udot_end_wz);
    /* M: end.wy,end.wz */
    out[380] = -(end_R_xz * end_tangent_force_x_by_udot_end_wz
        + end_R_zz * end_tangent_force_z_by_udot_end_wz
        + end_R_yz * end_tangent_force_y_by_udot_end_wz);
    /* M: end.wz,end.wz */
    out[392] = start_spin_z_by_u_start_wz + end_R_xy * end_tangent_force_x_by_udot_end_wz
        + (end_R_yy * end_tangent_force_y_by_udot_end_wz
        + end_R_zy * end_tangent_force_z_by_udot_end_wz);
    out[394] = end_force_y_by_udot_end_wz; /* M: end.wz,end.vy */
    out[416] = end_force_y_by_udot_end_wz; /* M: end.vy,end.wz */

    /* results that are numbers or inputs */
    out[288] = CARDAN_REAL(w[11]); /* M: start.wx,start.wx */
    out[294] = CARDAN_REAL(w[12]); /* M: start.wx,end.wx */
    out[327] = CARDAN_REAL(w[3]); /* M: start.vx,start.vx */
    out[333] = CARDAN_REAL(w[4]); /* M: start.vx,end.vx */
    out[340] = CARDAN_REAL(w[3]); /* M: start.vy,start.vy */
    out[346] = CARDAN_REAL(w[4]); /* M: start.vy,end.vy */
    out[353] = CARDAN_REAL(w[3]); /* M: start.vz,start.vz */
    out[359] = CARDAN_REAL(w[4]); /* M: start.vz,end.vz */
    out[360] = CARDAN_REAL(w[12]); /* M: end.wx,start.wx */
    out[366] = CARDAN_REAL(w[11]); /* M: end.wx,end.wx */
    out[399] = CARDAN_REAL(w[4]); /* M: end.vx,start.vx */
    out[405] = CARDAN_REAL(w[3]); /* M: end.vx,end.vx */
    out[412] = CARDAN_REAL(w[4]); /* M: end.vy,start.vy */
    out[418] = CARDAN_REAL(w[3]); /* M: end.vy,end.vy */
    out[425] = CARDAN_REAL(w[4]); /* M: end.vz,start.vz */
    out[431] = CARDAN_REAL(w[3]); /* M: end.vz,end.vz */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int linked_inertia__balance_tangent_sizes[] = {432, 0, 15, 0, 14, 12, 0, 0, 0, 11, 0, 12, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
