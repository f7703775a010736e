/*
 * linked_inertia__energy
 * Mass of the cubic through both ends along their tangents, and of rotations between them
 * kinetic = 1/2 sum mass_ij x_i'·x_j' + 1/2 integral omega·rhoI omega
 * T = T_1 + T_2
 * V = -g · (mu L / 2 (p_1 + p_2) + (m_13 - m_14) (R_1 i - R_2 i))
 * Source: Archer, J. Structural Division ASCE 89 (1963); Przemieniecki,
 *     Theory of Matrix Structural Analysis (1968), section 11.4,
 *     for small displacements; its finite form is our own
 * passes: reassociate
 *
 * Sizes: out 2, work 0, w 14
 * Operations per call: 220 = 124 mul, 58 add, 37 sub, 1 neg
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
 * Output energy (2)
 *   out[0]  kinetic [J]
 *   out[1]  potential [J]
 */
#include "cardan.h"

CARDAN_API void prepare_linked_inertia__energy(const wreal *p, wreal *CARDAN_RESTRICT w)
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
    w[3] = mass_pp;
    w[4] = mass_pq;
    w[5] = mass_pt;
    w[6] = mass_pu;
    w[7] = mass_tt;
    w[8] = mass_tu;
    w[9] = start_spin_y_by_u_start_wy;
    w[10] = start_spin_z_by_u_start_wz;
    w[11] = start_spin_x_by_u_start_wx;
    w[12] = mass_pp_plus_mass_pq;
    w[13] = mass_pt_minus_mass_pu;

    /* parameters as they are */
    w[0] = p[7]; /* gravity_1 */
    w[1] = p[8]; /* gravity_2 */
    w[2] = p[9]; /* gravity_3 */
}

#include "lanes.h"

/* Mass of the cubic through both ends along their tangents, and of rotations between them */
CARDAN_API int linked_inertia__energy(const cardan_in *in, real *CARDAN_RESTRICT out,
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
    const real start_px = q[4]; /* m */
    const real start_py = q[5]; /* m */
    const real start_pz = q[6]; /* m */
    const real end_qw = q[7];
    const real end_qx = q[8];
    const real end_qy = q[9];
    const real end_qz = q[10];
    const real end_px = q[11]; /* m */
    const real end_py = q[12]; /* m */
    const real end_pz = q[13]; /* m */
    const real start_wx = u[0]; /* rad/s */
    const real start_wy = u[1]; /* rad/s */
    const real start_wz = u[2]; /* rad/s */
    const real start_vx = u[3]; /* m/s */
    const real end_wx = u[6]; /* rad/s */
    const real end_wy = u[7]; /* rad/s */
    const real end_wz = u[8]; /* rad/s */
    const real end_vx = u[9]; /* m/s */
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
    const wreal mass_pp_plus_mass_pq = w[12];
    const wreal mass_pt_minus_mass_pu = w[13];
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
    const real start_tangent_rate_x = (start_qx_times_twice_start_qy
        - start_qw_times_twice_start_qz) * start_wz - (start_qw_times_twice_start_qy
        + start_qx_times_twice_start_qz) * start_wy;
    const real end_tangent_rate_x = (end_qx_times_twice_end_qy
        - end_qw_times_twice_end_qz) * end_wz - (end_qw_times_twice_end_qy
        + end_qx_times_twice_end_qz) * end_wy;
    const real energy_kinetic_part = end_wx * start_spin_x_by_u_start_wx * end_wx
        + end_wy * start_spin_y_by_u_start_wy * end_wy + (start_spin_x_by_u_start_wx * (start_wx
        + end_wx) * start_wx + end_wz * start_spin_z_by_u_start_wz * end_wz);
    const real energy_kinetic_part_2 = start_spin_y_by_u_start_wy * (start_wy
        + end_wy) * start_wy + start_spin_z_by_u_start_wz * (start_wz + end_wz) * start_wz
        + energy_kinetic_part + start_vx * (start_vx * mass_pp + end_vx * mass_pq
        + mass_pt * start_tangent_rate_x + mass_pu * end_tangent_rate_x);
    const real energy_kinetic_part_3 = end_vx * (start_vx * mass_pq + end_vx * mass_pp
        - mass_pu * start_tangent_rate_x - mass_pt * end_tangent_rate_x)
        + start_tangent_rate_x * (start_vx * mass_pt - end_vx * mass_pu
        + mass_tt * start_tangent_rate_x + mass_tu * end_tangent_rate_x);
    const real gravity_2_times_first_moment_y = gravity_2 * (start_py * mass_pp_plus_mass_pq
        + end_py * mass_pp_plus_mass_pq + (start_qw_times_twice_start_qz
        + start_qx_times_twice_start_qy) * mass_pt_minus_mass_pu - (end_qw_times_twice_end_qz
        + end_qx_times_twice_end_qy) * mass_pt_minus_mass_pu);
    const real energy_potential_part = gravity_2_times_first_moment_y
        + gravity_3 * (start_pz * mass_pp_plus_mass_pq + end_pz * mass_pp_plus_mass_pq
        + (start_qx_times_twice_start_qz - start_qw_times_twice_start_qy) * mass_pt_minus_mass_pu
        - (end_qx_times_twice_end_qz - end_qw_times_twice_end_qy) * mass_pt_minus_mass_pu);
    /* energy: potential [J] */
    out[1] = -(gravity_1 * (start_px * mass_pp_plus_mass_pq + end_px * mass_pp_plus_mass_pq
        + (1.0 - start_qy_times_twice_start_qy
        - start_qz_times_twice_start_qz) * mass_pt_minus_mass_pu - (1.0
        - end_qy_times_twice_end_qy - end_qz_times_twice_end_qz) * mass_pt_minus_mass_pu)
        + energy_potential_part);

    /* loads */
    const real one_minus_start_qx_times_twice_start_qx = 1.0 - start_qx * twice_start_qx;
    const real one_minus_end_qx_times_twice_end_qx = 1.0 - end_qx * twice_end_qx;

    /* energy */
    const real start_vy = u[4]; /* m/s */
    const real start_vz = u[5]; /* m/s */
    const real end_vy = u[10]; /* m/s */
    const real end_vz = u[11]; /* m/s */
    const real start_tangent_rate_y = (one_minus_start_qx_times_twice_start_qx
        - start_qz_times_twice_start_qz) * start_wz - (start_qy_times_twice_start_qz
        - start_qw_times_twice_start_qx) * start_wy;
    const real start_tangent_rate_z = (start_qw_times_twice_start_qx
        + start_qy_times_twice_start_qz) * start_wz - (one_minus_start_qx_times_twice_start_qx
        - start_qy_times_twice_start_qy) * start_wy;
    const real end_tangent_rate_y = (one_minus_end_qx_times_twice_end_qx
        - end_qz_times_twice_end_qz) * end_wz - (end_qy_times_twice_end_qz
        - end_qw_times_twice_end_qx) * end_wy;
    const real end_tangent_rate_z = (end_qw_times_twice_end_qx
        + end_qy_times_twice_end_qz) * end_wz - (one_minus_end_qx_times_twice_end_qx
        - end_qy_times_twice_end_qy) * end_wy;
    const real energy_kinetic_part_4 = end_vz * (start_vz * mass_pq + end_vz * mass_pp
        - mass_pu * start_tangent_rate_z - mass_pt * end_tangent_rate_z)
        + start_tangent_rate_y * (start_vy * mass_pt - end_vy * mass_pu
        + mass_tt * start_tangent_rate_y + mass_tu * end_tangent_rate_y);
    const real energy_kinetic_part_5 = start_tangent_rate_z * (start_vz * mass_pt
        - end_vz * mass_pu + mass_tt * start_tangent_rate_z + mass_tu * end_tangent_rate_z)
        + end_tangent_rate_y * (start_vy * mass_pu - end_vy * mass_pt
        + mass_tu * start_tangent_rate_y + mass_tt * end_tangent_rate_y);
    const real energy_kinetic_part_6 = start_vy * (start_vy * mass_pp + end_vy * mass_pq
        + mass_pt * start_tangent_rate_y + mass_pu * end_tangent_rate_y)
        + end_tangent_rate_x * (start_vx * mass_pu - end_vx * mass_pt
        + mass_tu * start_tangent_rate_x + mass_tt * end_tangent_rate_x) + energy_kinetic_part_3;
    const real energy_kinetic_part_7 = start_vz * (start_vz * mass_pp + end_vz * mass_pq
        + mass_pt * start_tangent_rate_z + mass_pu * end_tangent_rate_z)
        + end_vy * (start_vy * mass_pq + end_vy * mass_pp - mass_pu * start_tangent_rate_y
        - mass_pt * end_tangent_rate_y) + energy_kinetic_part_4 + energy_kinetic_part_6;
    /* energy: kinetic [J] */
    out[0] = 0.5 * (end_tangent_rate_z * (start_vz * mass_pu - end_vz * mass_pt
        + mass_tu * start_tangent_rate_z + mass_tt * end_tangent_rate_z) + energy_kinetic_part_2
        + energy_kinetic_part_5 + energy_kinetic_part_7);
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int linked_inertia__energy_sizes[] = {2, 0, 14, 0, 14, 12, 0, 0, 0, 11, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
