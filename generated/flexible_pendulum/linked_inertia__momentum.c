/*
 * linked_inertia__momentum
 * Mass of the cubic through both ends along their tangents, and of rotations between them
 * kinetic = 1/2 sum mass_ij x_i'·x_j' + 1/2 integral omega·rhoI omega
 * Source: Archer, J. Structural Division ASCE 89 (1963); Przemieniecki,
 *     Theory of Matrix Structural Analysis (1968), section 11.4,
 *     for small displacements; its finite form is our own
 * passes: reassociate
 *
 * Sizes: out 6, work 0, w 11
 * Operations per call: 268 = 150 mul, 71 add, 47 sub
 * Operations of prepare: 38 = 15 mul, 10 add, 9 div, 4 sub
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

CARDAN_API void prepare_linked_inertia__momentum(const wreal *p, wreal *CARDAN_RESTRICT w)
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
    const wreal mass_pp_plus_mass_pq = mass_pp + mass_pq;
    const wreal mass_pt_minus_mass_pu = mass_pt - mass_pu;
    w[0] = mass_pp;
    w[1] = mass_pq;
    w[2] = mass_pt;
    w[3] = mass_pu;
    w[4] = mass_tt;
    w[5] = mass_tu;
    w[6] = start_spin_y_by_u_start_wy;
    w[7] = start_spin_z_by_u_start_wz;
    w[8] = start_spin_x_by_u_start_wx;
    w[9] = mass_pp_plus_mass_pq;
    w[10] = mass_pt_minus_mass_pu;
}

#include "lanes.h"

/* Mass of the cubic through both ends along their tangents, and of rotations between them */
CARDAN_API int linked_inertia__momentum(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
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
    const real start_wy = u[1]; /* rad/s */
    const real start_wz = u[2]; /* rad/s */
    const real start_vx = u[3]; /* m/s */
    const real end_wy = u[7]; /* rad/s */
    const real end_wz = u[8]; /* rad/s */
    const real end_vx = u[9]; /* m/s */
    const wreal mass_pp = w[0];
    const wreal mass_pq = w[1];
    const wreal mass_pt = w[2];
    const wreal mass_pu = w[3];
    const wreal mass_tt = w[4];
    const wreal mass_tu = w[5];
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
    const real start_tangent_rate_x = start_R_xy * start_wz - start_R_xz * start_wy;
    const real end_tangent_rate_x = end_R_xy * end_wz - end_R_xz * end_wy;
    const real momentum_start_x = start_vx * mass_pp + end_vx * mass_pq
        + mass_pt * start_tangent_rate_x + mass_pu * end_tangent_rate_x;
    const real momentum_end_x = start_vx * mass_pq + end_vx * mass_pp
        - mass_pu * start_tangent_rate_x - mass_pt * end_tangent_rate_x;
    const real momentum_start_tangent_x = start_vx * mass_pt - end_vx * mass_pu
        + mass_tt * start_tangent_rate_x + mass_tu * end_tangent_rate_x;
    const real momentum_end_tangent_x = start_vx * mass_pu - end_vx * mass_pt
        + mass_tu * start_tangent_rate_x + mass_tt * end_tangent_rate_x;

    /* loads */
    const real start_wx = u[0]; /* rad/s */
    const real end_wx = u[6]; /* rad/s */
    const wreal start_spin_y_by_u_start_wy = w[6];
    const wreal start_spin_z_by_u_start_wz = w[7];
    const wreal start_spin_x_by_u_start_wx = w[8];
    const real one_minus_start_qx_times_twice_start_qx = 1.0 - start_qx * twice_start_qx;
    const real one_minus_end_qx_times_twice_end_qx = 1.0 - end_qx * twice_end_qx;
    const real start_spin_x = start_spin_x_by_u_start_wx * (start_wx + 0.5 * end_wx);
    const real start_spin_y = start_spin_y_by_u_start_wy * (start_wy + 0.5 * end_wy);
    const real start_spin_z = start_spin_z_by_u_start_wz * (start_wz + 0.5 * end_wz);
    const real end_spin_x = start_spin_x_by_u_start_wx * (end_wx + 0.5 * start_wx);
    const real end_spin_y = start_spin_y_by_u_start_wy * (end_wy + 0.5 * start_wy);
    const real end_spin_z = start_spin_z_by_u_start_wz * (end_wz + 0.5 * start_wz);

    /* energy */
    const real start_vy = u[4]; /* m/s */
    const real start_vz = u[5]; /* m/s */
    const real end_vy = u[10]; /* m/s */
    const real end_vz = u[11]; /* m/s */
    const real start_R_yy = one_minus_start_qx_times_twice_start_qx - start_qz_times_twice_start_qz;
    const real start_R_zz = one_minus_start_qx_times_twice_start_qx - start_qy_times_twice_start_qy;
    const real end_R_yy = one_minus_end_qx_times_twice_end_qx - end_qz_times_twice_end_qz;
    const real end_R_zz = one_minus_end_qx_times_twice_end_qx - end_qy_times_twice_end_qy;
    const real start_tangent_rate_y = start_R_yy * start_wz - start_R_yz * start_wy;
    const real start_tangent_rate_z = start_R_zy * start_wz - start_R_zz * start_wy;
    const real end_tangent_rate_y = end_R_yy * end_wz - end_R_yz * end_wy;
    const real end_tangent_rate_z = end_R_zy * end_wz - end_R_zz * end_wy;
    const real momentum_start_y = start_vy * mass_pp + end_vy * mass_pq
        + mass_pt * start_tangent_rate_y + mass_pu * end_tangent_rate_y;
    const real momentum_start_z = start_vz * mass_pp + end_vz * mass_pq
        + mass_pt * start_tangent_rate_z + mass_pu * end_tangent_rate_z;
    const real momentum_end_y = start_vy * mass_pq + end_vy * mass_pp
        - mass_pu * start_tangent_rate_y - mass_pt * end_tangent_rate_y;
    const real momentum_end_z = start_vz * mass_pq + end_vz * mass_pp
        - mass_pu * start_tangent_rate_z - mass_pt * end_tangent_rate_z;
    const real momentum_start_tangent_y = start_vy * mass_pt - end_vy * mass_pu
        + mass_tt * start_tangent_rate_y + mass_tu * end_tangent_rate_y;
    const real momentum_start_tangent_z = start_vz * mass_pt - end_vz * mass_pu
        + mass_tt * start_tangent_rate_z + mass_tu * end_tangent_rate_z;
    const real momentum_end_tangent_y = start_vy * mass_pu - end_vy * mass_pt
        + mass_tu * start_tangent_rate_y + mass_tt * end_tangent_rate_y;
    const real momentum_end_tangent_z = start_vz * mass_pu - end_vz * mass_pt
        + mass_tu * start_tangent_rate_z + mass_tt * end_tangent_rate_z;

    /* momentum */
    const real start_px = q[4]; /* m */
    const real start_py = q[5]; /* m */
    const real start_pz = q[6]; /* m */
    const real end_px = q[11]; /* m */
    const real end_py = q[12]; /* m */
    const real end_pz = q[13]; /* m */
    const wreal mass_pp_plus_mass_pq = w[9];
    const wreal mass_pt_minus_mass_pu = w[10];
    const real momentum_hx_part = start_R_xx * start_spin_x + end_R_xx * end_spin_x
        + (start_R_xy * start_spin_y + start_R_xz * start_spin_z + (end_R_xy * end_spin_y
        + end_R_xz * end_spin_z)) + start_py * momentum_start_z - end_R_zx * momentum_end_tangent_y;
    const real momentum_hy_part = start_R_yy * start_spin_y + end_R_yy * end_spin_y
        + (start_R_yx * start_spin_x + start_R_yz * start_spin_z + (end_R_yx * end_spin_x
        + end_R_yz * end_spin_z)) + start_pz * momentum_start_x - end_R_xx * momentum_end_tangent_z;
    const real momentum_hz_part = start_R_zz * start_spin_z + end_R_zz * end_spin_z
        + (start_R_zx * start_spin_x + start_R_zy * start_spin_y + (end_R_zx * end_spin_x
        + end_R_zy * end_spin_y)) - start_py * momentum_start_x + end_R_xx * momentum_end_tangent_y;
    /* momentum: hx [N*m*s] */
    out[0] = end_py * momentum_end_z - start_pz * momentum_start_y
        + (start_R_yx * momentum_start_tangent_z - end_pz * momentum_end_y)
        + (end_R_yx * momentum_end_tangent_z - start_R_zx * momentum_start_tangent_y
        + momentum_hx_part);
    /* momentum: hy [N*m*s] */
    out[1] = end_pz * momentum_end_x + start_R_zx * momentum_start_tangent_x
        + (end_R_zx * momentum_end_tangent_x - start_px * momentum_start_z) + (momentum_hy_part
        - (end_px * momentum_end_z + start_R_xx * momentum_start_tangent_z));
    /* momentum: hz [N*m*s] */
    out[2] = start_px * momentum_start_y - end_R_yx * momentum_end_tangent_x
        - (end_py * momentum_end_x + start_R_yx * momentum_start_tangent_x)
        + (end_px * momentum_end_y + start_R_xx * momentum_start_tangent_y + momentum_hz_part);
    /* momentum: px [N*s] */
    out[3] = start_vx * mass_pp_plus_mass_pq + end_vx * mass_pp_plus_mass_pq
        + start_tangent_rate_x * mass_pt_minus_mass_pu - end_tangent_rate_x * mass_pt_minus_mass_pu;
    /* momentum: py [N*s] */
    out[4] = start_vy * mass_pp_plus_mass_pq + end_vy * mass_pp_plus_mass_pq
        + start_tangent_rate_y * mass_pt_minus_mass_pu - end_tangent_rate_y * mass_pt_minus_mass_pu;
    /* momentum: pz [N*s] */
    out[5] = start_vz * mass_pp_plus_mass_pq + end_vz * mass_pp_plus_mass_pq
        + start_tangent_rate_z * mass_pt_minus_mass_pu - end_tangent_rate_z * mass_pt_minus_mass_pu;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int linked_inertia__momentum_sizes[] = {6, 0, 11, 0, 14, 12, 0, 0, 0, 11, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
