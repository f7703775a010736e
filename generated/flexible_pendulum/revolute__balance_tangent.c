/*
 * revolute__balance_tangent
 * derivatives of the balance along q, u, udot, of the rates along q, and G
 * Source: R. Featherstone, Rigid Body Dynamics Algorithms, 2008, table 4.1
 * passes: reassociate, schedule
 *
 * Sizes: out 133, work 0, w 0
 * Operations per call: 235 = 137 mul, 41 sub, 39 add, 16 neg, 1 cos, 1 sin
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
 * Output K (7 x 7): out[0 ... 48], row by row
 *
 * Output R (6 x 7): out[49 ... 90], row by row
 *
 * Output G (6 x 7): out[91 ... 132], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_revolute__balance_tangent(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    (void)p;
    (void)w;
}

#include "lanes.h"

/* derivatives of the balance along q, u, udot, of the rates along q, and G */
CARDAN_API int revolute__balance_tangent(const cardan_in *in, real *CARDAN_RESTRICT out,
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
    out[115] = joint_cos; /* G[3][3] */
    out[131] = joint_cos; /* G[5][5] */
    out[129] = joint_sin; /* G[5][3] */

    /* joint: R */
    /* R = R_fixed R_joint(q) */
    const real joint_px = lam[3]; /* N */
    const real joint_pz = lam[5]; /* N */
    const real body1_px = q[4]; /* m */
    const real body1_pz = q[6]; /* m */
    const real body1_u_px = u[3]; /* m/s */
    const real body1_u_pz = u[5]; /* m/s */
    const real joint_u = u[6]; /* rad/s */
    const real joint_pz_times_sin_plus_px_times_cos = joint_pz * joint_sin + joint_px * joint_cos;
    const real joint_sin_times_u = joint_sin * joint_u;
    const real minus_joint_sin_times_u = -joint_sin_times_u;
    const real joint_cos_times_u = joint_cos * joint_u;
    const real body1_u_px_minus_pz_times_joint_u = body1_u_px - body1_pz * joint_u;
    const real body1_u_pz_plus_px_times_joint_u = body1_u_pz + body1_px * joint_u;
    out[117] = -joint_sin; /* G[3][5] */
    out[41] = joint_pz_times_sin_plus_px_times_cos; /* K[5][6] */
    out[47] = joint_pz_times_sin_plus_px_times_cos; /* K[6][5] */
    out[118] = -(joint_sin * body1_px + joint_cos * body1_pz); /* G[3][6] */
    out[73] = minus_joint_sin_times_u; /* R[3][3] */
    out[89] = minus_joint_sin_times_u; /* R[5][5] */
    out[87] = joint_cos_times_u; /* R[5][3] */
    /* R[3][6] */
    out[76] = -(joint_cos * body1_u_pz_plus_px_times_joint_u
        + joint_sin * body1_u_px_minus_pz_times_joint_u);
    /* R[5][6] */
    out[90] = joint_cos * body1_u_px_minus_pz_times_joint_u
        - joint_sin * body1_u_pz_plus_px_times_joint_u;

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
    const real body1_R_yx = body1_qw_times_twice_body1_qz + body1_qx_times_twice_body1_qy;
    const real body1_R_xz = body1_qw_times_twice_body1_qy + body1_qx_times_twice_body1_qz;
    const real body1_R_zx = body1_qx_times_twice_body1_qz - body1_qw_times_twice_body1_qy;
    const real body1_R_yz = body1_qy_times_twice_body1_qz - body1_qw_times_twice_body1_qx;
    const real body1_R_zy = body1_qw_times_twice_body1_qx + body1_qy_times_twice_body1_qz;
    out[107] = body1_R_yy; /* G[2][2] */

    /* common */
    const real joint_rx = lam[0]; /* N*m */
    const real joint_ry = lam[1]; /* N*m */
    const real joint_rz = lam[2]; /* N*m */
    const real body1_u_x = u[0]; /* rad/s */
    const real body1_u_y = u[1]; /* rad/s */
    const real body1_u_z = u[2]; /* rad/s */
    const real joint_px_times_sin_minus_pz_times_cos = joint_px * joint_sin - joint_pz * joint_cos;
    const real joint_rx_times_cos = joint_rx * joint_cos;
    const real joint_rx_times_sin = joint_rx * joint_sin;
    const real joint_ry_times_sin = joint_ry * joint_sin;
    const real joint_ry_times_cos = joint_ry * joint_cos;
    const real joint_rz_times_body1_R_yx = joint_rz * body1_R_yx;
    const real body1_R_xy_times_joint_rx_times_sin = body1_R_xy * joint_rx_times_sin;
    const real body1_R_xz_times_joint_ry_times_cos = body1_R_xz * joint_ry_times_cos;
    const real body1_R_zy_times_joint_rx_times_cos = body1_R_zy * joint_rx_times_cos;
    const real body1_R_zz_times_joint_ry_times_sin = body1_R_zz * joint_ry_times_sin;
    const real joint_cos_times_body1_u_x = joint_cos * body1_u_x;
    const real joint_cos_times_body1_u_z = joint_cos * body1_u_z;
    const real joint_sin_times_body1_u_x = joint_sin * body1_u_x;
    const real joint_sin_times_body1_u_z = joint_sin * body1_u_z;
    const real joint_sin_times_body1_u_y = joint_sin * body1_u_y;
    const real joint_cos_times_body1_u_y = joint_cos * body1_u_y;
    const real joint_cos_times_body1_R_xy_minus_sin_times_body1_R_zy = joint_cos * body1_R_xy
        - joint_sin * body1_R_zy;
    const real joint_sin_times_body1_R_xz_plus_cos_times_body1_R_zz = joint_sin * body1_R_xz
        + joint_cos * body1_R_zz;
    out[106] = -body1_R_yz; /* G[2][1] */
    out[27] = joint_px_times_sin_minus_pz_times_cos; /* K[3][6] */
    out[45] = joint_px_times_sin_minus_pz_times_cos; /* K[6][3] */
    out[15] = -(body1_R_xz * joint_rx_times_sin + body1_R_zz * joint_rx_times_cos); /* K[2][1] */
    out[9] = body1_R_zy * joint_ry_times_sin - body1_R_xy * joint_ry_times_cos; /* K[1][2] */
    out[14] = -joint_rz * body1_R_yz; /* K[2][0] */
    out[2] = body1_R_zx * joint_ry_times_sin - body1_R_xx * joint_ry_times_cos; /* K[0][2] */
    out[7] = -joint_rz * body1_R_yy; /* K[1][0] */
    out[1] = -(body1_R_xx * joint_rx_times_sin + body1_R_zx * joint_rx_times_cos); /* K[0][1] */
    out[132] = joint_cos * body1_px - joint_sin * body1_pz; /* G[5][6] */
    /* K[6][0] */
    out[42] = joint_sin * (joint_rx * body1_R_zz - joint_ry * body1_R_xy)
        - joint_cos * (joint_rx * body1_R_xz + joint_ry * body1_R_zy);
    /* K[1][1] */
    out[8] = joint_rz_times_body1_R_yx - body1_R_zz_times_joint_ry_times_sin
        + body1_R_xz_times_joint_ry_times_cos;
    /* K[0][0] */
    out[0] = body1_R_xy_times_joint_rx_times_sin - body1_R_zz_times_joint_ry_times_sin
        + (body1_R_xz_times_joint_ry_times_cos + body1_R_zy_times_joint_rx_times_cos);
    /* K[2][2] */
    out[16] = joint_rz_times_body1_R_yx + body1_R_zy_times_joint_rx_times_cos
        + body1_R_xy_times_joint_rx_times_sin;
    out[44] = joint_rx * body1_R_xx * joint_cos - joint_rx * body1_R_zx * joint_sin; /* K[6][2] */
    out[20] = body1_R_xx * joint_rx_times_cos - body1_R_zx * joint_rx_times_sin; /* K[2][6] */
    /* K[0][6] */
    out[6] = body1_R_zz * joint_rx_times_sin - body1_R_zy * joint_ry_times_cos
        - (body1_R_xz * joint_rx_times_cos + body1_R_xy * joint_ry_times_sin);
    out[13] = body1_R_xx * joint_ry_times_sin + body1_R_zx * joint_ry_times_cos; /* K[1][6] */
    out[75] = -joint_cos_times_u; /* R[3][5] */
    out[65] = -body1_R_yx * body1_u_z; /* R[2][2] */
    out[64] = -body1_R_yx * body1_u_y; /* R[2][1] */
    /* R[0][0] */
    out[49] = body1_R_xz * joint_cos_times_u - body1_R_xy * joint_sin_times_body1_u_x
        - (body1_R_zz * joint_sin_times_u + body1_R_zy * joint_cos_times_body1_u_x);
    /* R[1][0] */
    out[56] = body1_R_xy * joint_sin_times_u - body1_R_xz * joint_cos_times_body1_u_x
        + (body1_R_zz * joint_sin_times_body1_u_x + body1_R_zy * joint_cos_times_u);
    out[63] = body1_R_yz * body1_u_z + body1_R_yy * body1_u_y; /* R[2][0] */
    /* R[0][1] */
    out[50] = body1_R_xz * joint_sin_times_body1_u_z + body1_R_xx * joint_sin_times_body1_u_x
        + (body1_R_zz * joint_cos_times_body1_u_z + body1_R_zx * joint_cos_times_body1_u_x);
    /* R[1][2] */
    out[58] = body1_R_xy * joint_cos_times_body1_u_y + body1_R_xx * joint_cos_times_body1_u_x
        - (body1_R_zy * joint_sin_times_body1_u_y + body1_R_zx * joint_sin_times_body1_u_x);
    out[97] = joint_cos_times_body1_R_xy_minus_sin_times_body1_R_zy; /* G[0][6] */
    out[91] = joint_sin_times_body1_R_xz_plus_cos_times_body1_R_zz; /* G[0][0] */
    /* R[1][1] */
    out[57] = body1_R_zz * joint_sin_times_body1_u_y - body1_R_xz * joint_cos_times_body1_u_y
        - (body1_R_xx * joint_sin_times_u + body1_R_zx * joint_cos_times_u);
    /* R[0][2] */
    out[51] = body1_R_zx * joint_sin_times_u - body1_R_xy * joint_sin_times_body1_u_z
        - (body1_R_xx * joint_cos_times_u + body1_R_zy * joint_cos_times_body1_u_z);
    out[99] = joint_cos * body1_R_xx - joint_sin * body1_R_zx; /* G[1][1] */
    out[93] = -(joint_sin * body1_R_xx + joint_cos * body1_R_zx); /* G[0][2] */
    out[98] = -joint_cos_times_body1_R_xy_minus_sin_times_body1_R_zy; /* G[1][0] */

    /* joint: R */
    /* R = R_fixed R_joint(q) */
    /* K[6][6] */
    out[48] = joint_sin * (joint_pz * body1_px - joint_px * body1_pz + joint_rx * body1_R_xy
        - joint_ry * body1_R_zz) + joint_cos * (joint_pz * body1_pz + joint_px * body1_px
        + joint_rx * body1_R_zy + joint_ry * body1_R_xz);
    out[43] = joint_ry * body1_R_zx * joint_cos + joint_ry * body1_R_xx * joint_sin; /* K[6][1] */
    /* R[0][6] */
    out[55] = joint_cos * (body1_R_xz * body1_u_x - body1_R_zy * joint_u
        - body1_R_xx * body1_u_z) - joint_sin * (body1_R_xy * joint_u - body1_R_zx * body1_u_z
        + body1_R_zz * body1_u_x);
    /* R[1][6] */
    out[62] = -(joint_cos * (body1_R_zx * body1_u_y - body1_R_zy * body1_u_x
        + body1_R_xz * joint_u) + joint_sin * (body1_R_xx * body1_u_y - body1_R_xy * body1_u_x
        - body1_R_zz * joint_u));
    out[104] = -joint_sin_times_body1_R_xz_plus_cos_times_body1_R_zz; /* G[1][6] */

    /* results that are numbers or inputs */
    out[3] = CARDAN_REAL(0.0); /* K[0][3] */
    out[4] = CARDAN_REAL(0.0); /* K[0][4] */
    out[5] = CARDAN_REAL(0.0); /* K[0][5] */
    out[10] = CARDAN_REAL(0.0); /* K[1][3] */
    out[11] = CARDAN_REAL(0.0); /* K[1][4] */
    out[12] = CARDAN_REAL(0.0); /* K[1][5] */
    out[17] = CARDAN_REAL(0.0); /* K[2][3] */
    out[18] = CARDAN_REAL(0.0); /* K[2][4] */
    out[19] = CARDAN_REAL(0.0); /* K[2][5] */
    out[21] = CARDAN_REAL(0.0); /* K[3][0] */
    out[22] = CARDAN_REAL(0.0); /* K[3][1] */
    out[23] = CARDAN_REAL(0.0); /* K[3][2] */
    out[24] = CARDAN_REAL(0.0); /* K[3][3] */
    out[25] = CARDAN_REAL(0.0); /* K[3][4] */
    out[26] = CARDAN_REAL(0.0); /* K[3][5] */
    out[28] = CARDAN_REAL(0.0); /* K[4][0] */
    out[29] = CARDAN_REAL(0.0); /* K[4][1] */
    out[30] = CARDAN_REAL(0.0); /* K[4][2] */
    out[31] = CARDAN_REAL(0.0); /* K[4][3] */
    out[32] = CARDAN_REAL(0.0); /* K[4][4] */
    out[33] = CARDAN_REAL(0.0); /* K[4][5] */
    out[34] = CARDAN_REAL(0.0); /* K[4][6] */
    out[35] = CARDAN_REAL(0.0); /* K[5][0] */
    out[36] = CARDAN_REAL(0.0); /* K[5][1] */
    out[37] = CARDAN_REAL(0.0); /* K[5][2] */
    out[38] = CARDAN_REAL(0.0); /* K[5][3] */
    out[39] = CARDAN_REAL(0.0); /* K[5][4] */
    out[40] = CARDAN_REAL(0.0); /* K[5][5] */
    out[46] = CARDAN_REAL(0.0); /* K[6][4] */
    out[52] = CARDAN_REAL(0.0); /* R[0][3] */
    out[53] = CARDAN_REAL(0.0); /* R[0][4] */
    out[54] = CARDAN_REAL(0.0); /* R[0][5] */
    out[59] = CARDAN_REAL(0.0); /* R[1][3] */
    out[60] = CARDAN_REAL(0.0); /* R[1][4] */
    out[61] = CARDAN_REAL(0.0); /* R[1][5] */
    out[66] = CARDAN_REAL(0.0); /* R[2][3] */
    out[67] = CARDAN_REAL(0.0); /* R[2][4] */
    out[68] = CARDAN_REAL(0.0); /* R[2][5] */
    out[69] = CARDAN_REAL(0.0); /* R[2][6] */
    out[70] = CARDAN_REAL(0.0); /* R[3][0] */
    out[71] = CARDAN_REAL(0.0); /* R[3][1] */
    out[72] = CARDAN_REAL(0.0); /* R[3][2] */
    out[74] = CARDAN_REAL(0.0); /* R[3][4] */
    out[77] = CARDAN_REAL(0.0); /* R[4][0] */
    out[78] = CARDAN_REAL(0.0); /* R[4][1] */
    out[79] = CARDAN_REAL(0.0); /* R[4][2] */
    out[80] = CARDAN_REAL(0.0); /* R[4][3] */
    out[81] = CARDAN_REAL(0.0); /* R[4][4] */
    out[82] = CARDAN_REAL(0.0); /* R[4][5] */
    out[83] = CARDAN_REAL(0.0); /* R[4][6] */
    out[84] = CARDAN_REAL(0.0); /* R[5][0] */
    out[85] = CARDAN_REAL(0.0); /* R[5][1] */
    out[86] = CARDAN_REAL(0.0); /* R[5][2] */
    out[88] = CARDAN_REAL(0.0); /* R[5][4] */
    out[92] = CARDAN_REAL(0.0); /* G[0][1] */
    out[94] = CARDAN_REAL(0.0); /* G[0][3] */
    out[95] = CARDAN_REAL(0.0); /* G[0][4] */
    out[96] = CARDAN_REAL(0.0); /* G[0][5] */
    out[100] = CARDAN_REAL(0.0); /* G[1][2] */
    out[101] = CARDAN_REAL(0.0); /* G[1][3] */
    out[102] = CARDAN_REAL(0.0); /* G[1][4] */
    out[103] = CARDAN_REAL(0.0); /* G[1][5] */
    out[105] = CARDAN_REAL(0.0); /* G[2][0] */
    out[108] = CARDAN_REAL(0.0); /* G[2][3] */
    out[109] = CARDAN_REAL(0.0); /* G[2][4] */
    out[110] = CARDAN_REAL(0.0); /* G[2][5] */
    out[111] = CARDAN_REAL(0.0); /* G[2][6] */
    out[112] = CARDAN_REAL(0.0); /* G[3][0] */
    out[113] = CARDAN_REAL(0.0); /* G[3][1] */
    out[114] = CARDAN_REAL(0.0); /* G[3][2] */
    out[116] = CARDAN_REAL(0.0); /* G[3][4] */
    out[119] = CARDAN_REAL(0.0); /* G[4][0] */
    out[120] = CARDAN_REAL(0.0); /* G[4][1] */
    out[121] = CARDAN_REAL(0.0); /* G[4][2] */
    out[122] = CARDAN_REAL(0.0); /* G[4][3] */
    out[123] = CARDAN_REAL(1.0); /* G[4][4] */
    out[124] = CARDAN_REAL(0.0); /* G[4][5] */
    out[125] = CARDAN_REAL(0.0); /* G[4][6] */
    out[126] = CARDAN_REAL(0.0); /* G[5][0] */
    out[127] = CARDAN_REAL(0.0); /* G[5][1] */
    out[128] = CARDAN_REAL(0.0); /* G[5][2] */
    out[130] = CARDAN_REAL(0.0); /* G[5][4] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int revolute__balance_tangent_sizes[] = {133, 0, 0, 0, 8, 7, 0, 0, 0, 0, 0, 0, 0, 6, 0, 0, 0, 0, 0};
#endif
