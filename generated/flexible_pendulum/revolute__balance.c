/*
 * revolute__balance
 * M udot + h - f - Gᵀ lam, then g and G u + g_t
 * R_q = (cos(q), 0, sin(q); 0, 1, 0; -sin(q), 0, cos(q))
 * R = (R_P R_q)ᵀ R_C
 * p = R_qᵀ R_Pᵀ (p_C - p_P)
 * g = (R_32; R_13; R_21; p_1; p_2; p_3)
 * b = -Gᵀ lam
 * Source: R. Featherstone, Rigid Body Dynamics Algorithms, 2008, table 4.1
 * passes: reassociate, schedule
 *
 * Sizes: out 19, work 0, w 0
 * Operations per call: 128 = 76 mul, 29 sub, 19 add, 2 neg, 1 cos, 1 sin
 * Operations of prepare: none
 *
 * Input q (8): generalized coordinates
 *   q[0]  body1.qw
 *   q[1]  body1.qx
 *   q[2]  body1.qy
 *   q[3]  body1.qz
 *   q[4]  body1.px [m]
 *   q[5]  body1.py [m]
 *   q[6]  body1.pz [m]
 *   q[7]  joint [rad]
 *
 * Input u (7): generalized speeds
 *   u[0]  body1.u.x [rad/s]
 *   u[1]  body1.u.y [rad/s]
 *   u[2]  body1.u.z [rad/s]
 *   u[3]  body1.u.px [m/s]
 *   u[4]  body1.u.py [m/s]
 *   u[5]  body1.u.pz [m/s]
 *   u[6]  joint.u [rad/s]
 *
 * Input lam (6): Lagrange multipliers
 *   lam[0]  joint.rx [N*m]
 *   lam[1]  joint.ry [N*m]
 *   lam[2]  joint.rz [N*m]
 *   lam[3]  joint.px [N]
 *   lam[4]  joint.py [N]
 *   lam[5]  joint.pz [N]
 *
 * Output balance (7)
 *   out[0]  body1.u.x.tau [N*m]
 *   out[1]  body1.u.y.tau [N*m]
 *   out[2]  body1.u.z.tau [N*m]
 *   out[3]  body1.u.px.tau [N]
 *   out[4]  body1.u.py.tau [N]
 *   out[5]  body1.u.pz.tau [N]
 *   out[6]  joint.u.tau [N*m]
 *
 * Output g (6): out[7 ... 12]
 *
 * Output rates (6): out[13 ... 18]
 */
#include "cardan.h"

CARDAN_API void prepare_revolute__balance(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    (void)p;
    (void)w;
}

#include "lanes.h"

/* M udot + h - f - Gᵀ lam, then g and G u + g_t */
CARDAN_API int revolute__balance(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const real *const lam = in->lam;
    (void)work;

    /* joint: R */
    /* R = R_fixed R_joint(q) */
    const real joint_q = q[7]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {joint_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real joint_cos = cosine[0];
    const real joint_sin = sine[0];

    /* body1: R */
    /* R = R_fixed R_joint(q) */
    const real body1_qw = q[0];
    const real body1_qx = q[1];
    const real body1_qy = q[2];
    const real body1_qz = q[3];
    const real twice_body1_qx = 2.0 * body1_qx;
    const real twice_body1_qy = 2.0 * body1_qy;
    const real twice_body1_qz = 2.0 * body1_qz;
    const real body1_qw_times_twice_body1_qx = body1_qw * twice_body1_qx;
    const real one_minus_body1_qx_times_twice_body1_qx = 1.0 - body1_qx * twice_body1_qx;
    const real body1_qw_times_twice_body1_qy = body1_qw * twice_body1_qy;
    const real body1_qw_times_twice_body1_qz = body1_qw * twice_body1_qz;
    const real body1_qx_times_twice_body1_qy = body1_qx * twice_body1_qy;
    const real body1_qy_times_twice_body1_qy = body1_qy * twice_body1_qy;
    const real body1_qx_times_twice_body1_qz = body1_qx * twice_body1_qz;
    const real body1_qy_times_twice_body1_qz = body1_qy * twice_body1_qz;
    const real body1_qz_times_twice_body1_qz = body1_qz * twice_body1_qz;
    const real body1_R_xx = 1.0 - body1_qy_times_twice_body1_qy - body1_qz_times_twice_body1_qz;
    const real body1_R_yy = one_minus_body1_qx_times_twice_body1_qx - body1_qz_times_twice_body1_qz;
    const real body1_R_zz = one_minus_body1_qx_times_twice_body1_qx - body1_qy_times_twice_body1_qy;
    const real body1_R_xy = body1_qx_times_twice_body1_qy - body1_qw_times_twice_body1_qz;
    const real body1_R_xz = body1_qw_times_twice_body1_qy + body1_qx_times_twice_body1_qz;
    const real body1_R_zx = body1_qx_times_twice_body1_qz - body1_qw_times_twice_body1_qy;
    const real body1_R_yz = body1_qy_times_twice_body1_qz - body1_qw_times_twice_body1_qx;
    const real body1_R_zy = body1_qw_times_twice_body1_qx + body1_qy_times_twice_body1_qz;
    out[9] = body1_qw_times_twice_body1_qz + body1_qx_times_twice_body1_qy; /* g[2] */

    /* common */
    const real joint_rx = lam[0]; /* N*m */
    const real joint_ry = lam[1]; /* N*m */
    const real joint_rz = lam[2]; /* N*m */
    const real joint_px = lam[3]; /* N */
    const real joint_py = lam[4]; /* N */
    const real joint_pz = lam[5]; /* N */
    const real body1_px = q[4]; /* m */
    const real body1_pz = q[6]; /* m */
    const real body1_u_y = u[1]; /* rad/s */
    const real body1_u_z = u[2]; /* rad/s */
    const real joint_rx_times_cos = joint_rx * joint_cos;
    const real joint_rx_times_sin = joint_rx * joint_sin;
    const real joint_ry_times_sin = joint_ry * joint_sin;
    const real joint_ry_times_cos = joint_ry * joint_cos;
    out[5] = joint_px * joint_sin - joint_pz * joint_cos; /* balance: body1.u.pz.tau [N] */
    out[4] = -joint_py; /* balance: body1.u.py.tau [N] */
    /* balance: joint.u.tau [N*m] */
    out[6] = joint_sin * (joint_pz * body1_pz + joint_px * body1_px + joint_rx * body1_R_zy
        + joint_ry * body1_R_xz) - joint_cos * (joint_pz * body1_px - joint_px * body1_pz
        + joint_rx * body1_R_xy - joint_ry * body1_R_zz);
    /* balance: body1.u.x.tau [N*m] */
    out[0] = body1_R_xy * joint_ry_times_cos - body1_R_xz * joint_rx_times_sin
        - (body1_R_zz * joint_rx_times_cos + body1_R_zy * joint_ry_times_sin);
    /* balance: body1.u.y.tau [N*m] */
    out[1] = joint_rz * body1_R_yz - body1_R_xx * joint_ry_times_cos
        + body1_R_zx * joint_ry_times_sin;
    /* balance: body1.u.z.tau [N*m] */
    out[2] = body1_R_xx * joint_rx_times_sin - joint_rz * body1_R_yy
        + body1_R_zx * joint_rx_times_cos;
    out[15] = body1_R_yy * body1_u_z - body1_R_yz * body1_u_y; /* rates[2] */
    out[8] = joint_cos * body1_R_xz - joint_sin * body1_R_zz; /* g[1] */
    out[7] = joint_sin * body1_R_xy + joint_cos * body1_R_zy; /* g[0] */
    out[10] = joint_cos * body1_px - joint_sin * body1_pz; /* g[3] */
    out[12] = joint_sin * body1_px + joint_cos * body1_pz; /* g[5] */

    /* joint: R */
    /* R = R_fixed R_joint(q) */
    const real joint_u = u[6]; /* rad/s */
    const real joint_sin_times_u = joint_sin * joint_u;
    const real joint_cos_times_u = joint_cos * joint_u;
    out[3] = -(joint_pz * joint_sin + joint_px * joint_cos); /* balance: body1.u.px.tau [N] */

    /* common */
    const real body1_u_x = u[0]; /* rad/s */
    const real body1_u_px = u[3]; /* m/s */
    const real body1_u_pz = u[5]; /* m/s */
    /* rates[1] */
    out[14] = joint_cos * (body1_R_xx * body1_u_y - body1_R_xy * body1_u_x)
        - joint_sin * (body1_R_zx * body1_u_y - body1_R_zy * body1_u_x)
        - (body1_R_xz * joint_sin_times_u + body1_R_zz * joint_cos_times_u);
    /* rates[0] */
    out[13] = joint_sin * (body1_R_xz * body1_u_x - body1_R_xx * body1_u_z)
        + joint_cos * (body1_R_zz * body1_u_x - body1_R_zx * body1_u_z)
        + (body1_R_xy * joint_cos_times_u - body1_R_zy * joint_sin_times_u);
    /* rates[3] */
    out[16] = joint_cos * body1_u_px - joint_sin * body1_u_pz - (body1_px * joint_sin_times_u
        + body1_pz * joint_cos_times_u);
    /* rates[5] */
    out[18] = joint_sin * body1_u_px + joint_cos * body1_u_pz + (body1_px * joint_cos_times_u
        - body1_pz * joint_sin_times_u);

    /* results that are numbers or inputs */
    out[11] = q[5]; /* g[4] */
    out[17] = u[4]; /* rates[4] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int revolute__balance_sizes[] = {19, 0, 0, 0, 8, 7, 0, 0, 0, 0, 0, 0, 0, 6, 0, 0, 0, 0, 0};
#endif
