/*
 * mass_matrix of rolling_disk
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 25, work 0, w 6
 * Operations per call: 80 = 54 mul, 15 add, 4 sub, 3 cos, 3 sin, 1 neg
 * Operations of prepare: 7 = 7 mul
 *
 * Input q (5): generalized coordinates
 *   q[0]  rolling.x [m]
 *   q[1]  rolling.y [m]
 *   q[2]  rolling.yaw [rad]
 *   q[3]  rolling.lean [rad]
 *   q[4]  rolling.spin [rad]
 *
 * Input p (3): parameters, read by prepare_ only
 *
 * Output M (5 x 5): out[0 ... 24], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* coin: mass, inertia */
    const wreal m = p[0]; /* kg */
    const wreal r_1 = p[1]; /* m */
    const wreal coin_mass = r_1 * r_1;
    w[2] = 0.25 * m * coin_mass; /* coin_inertia_xx */
    w[3] = 0.5 * m * coin_mass; /* coin_inertia_yy */

    /* rolling: M */
    const wreal rolling_M = m * r_1;
    w[4] = rolling_M; /* rolling_M */
    w[5] = r_1 * rolling_M; /* rolling_M_2 */

    /* parameters as they are */
    w[0] = p[0]; /* m [kg] */
    w[1] = p[1]; /* r [m] */
}

#include "lanes.h"

/* M: kinetic energy is 1/2 uᵀ M u */
CARDAN_API int mass_matrix(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const wreal *const w = in->w;
    (void)work;

    /* rolling: R, sin */
    const real rolling_yaw = q[2]; /* rad */
    const real rolling_lean = q[3]; /* rad */
    const real rolling_spin = q[4]; /* rad */
    const real angle[CARDAN_PADDED(3)] = {rolling_yaw, rolling_lean, rolling_spin};
    real sine[CARDAN_PADDED(3)], cosine[CARDAN_PADDED(3)];
    cardan_sincos(3, angle, sine, cosine);
    const real rolling_R = cosine[0];
    const real rolling_R_2 = sine[0];
    const real rolling_R_3 = cosine[1];
    const real rolling_sin = sine[1];
    const real rolling_R_4 = cosine[2];
    const real rolling_R_5 = sine[2];

    /* rolling: R, S, momentum fx, momentum fz, momentum fy, momentum my, momentum mz, M, ... */
    const wreal m = w[0]; /* kg */
    const wreal r_1 = w[1]; /* m */
    const wreal coin_inertia_xx = w[2];
    const wreal coin_inertia_yy = w[3];
    const real rolling_R_6 = rolling_R_2 * rolling_R_3;
    const real rolling_R_7 = rolling_R_2 * rolling_sin;
    const real rolling_R_yy = rolling_R * rolling_R_3;
    const real rolling_R_8 = rolling_R * rolling_sin;
    const real rolling_R_xx = rolling_R * rolling_R_4 - rolling_R_7 * rolling_R_5;
    const real rolling_R_xz = rolling_R * rolling_R_5 + rolling_R_7 * rolling_R_4;
    const real rolling_R_yx = rolling_R_2 * rolling_R_4 + rolling_R_8 * rolling_R_5;
    const real rolling_R_yz = rolling_R_2 * rolling_R_5 - rolling_R_8 * rolling_R_4;
    const real rolling_R_9 = rolling_R_3 * rolling_R_5;
    const real rolling_R_zz = rolling_R_3 * rolling_R_4;
    const real rolling_S = r_1 * rolling_sin;
    const real rolling_S_2 = rolling_R_4 * rolling_S;
    const real rolling_S_3 = rolling_R_5 * rolling_S;
    const real rolling_momentum_fx = m * rolling_R_xx;
    const real rolling_momentum_fz = m * rolling_R_xz;
    const real rolling_momentum_fx_2 = m * rolling_R_yx;
    const real rolling_momentum_fy = m * rolling_R_yy;
    const real rolling_momentum_fz_2 = m * rolling_R_yz;
    const real rolling_momentum_my = coin_inertia_yy * rolling_sin;
    const real rolling_momentum_mz = coin_inertia_xx * rolling_R_zz;
    const real rolling_momentum_fx_3 = m * rolling_S_2;
    const real rolling_momentum_fz_3 = m * rolling_S_3;
    const real rolling_M_3 = coin_inertia_xx * rolling_R_9 * rolling_R_9
        + rolling_sin * rolling_momentum_my + rolling_S_3 * rolling_momentum_fz_3;
    const real rolling_momentum_mx = coin_inertia_xx * rolling_R_4;
    const real rolling_momentum_mz_2 = coin_inertia_xx * rolling_R_5;
    out[14] = rolling_momentum_my; /* M: rolling.u.yaw,rolling.u.spin */
    out[22] = rolling_momentum_my; /* M: rolling.u.spin,rolling.u.yaw */

    /* M */
    const wreal rolling_M = w[4];
    const wreal rolling_M_2 = w[5];
    const real M_4_1 = rolling_R_6 * rolling_M;
    const real M_4_2 = -rolling_R_yy * rolling_M;
    const real M_2_1 = rolling_R_xx * rolling_momentum_fx_2 - rolling_R_6 * rolling_momentum_fy
        + rolling_R_xz * rolling_momentum_fz_2;
    const real M_3_1 = rolling_R_xx * rolling_momentum_fx_3 + rolling_R_xz * rolling_momentum_fz_3;
    const real M_3_2 = rolling_R_yx * rolling_momentum_fx_3 + rolling_R_yz * rolling_momentum_fz_3;
    const real M_4_3 = rolling_R_zz * rolling_momentum_mz_2 - rolling_R_9 * rolling_momentum_mx;
    /* M: rolling.u.x,rolling.u.x */
    out[0] = rolling_R_xx * rolling_momentum_fx + m * rolling_R_6 * rolling_R_6
        + rolling_R_xz * rolling_momentum_fz;
    out[3] = M_4_1; /* M: rolling.u.x,rolling.u.lean */
    out[15] = M_4_1; /* M: rolling.u.lean,rolling.u.x */
    out[8] = M_4_2; /* M: rolling.u.y,rolling.u.lean */
    out[16] = M_4_2; /* M: rolling.u.lean,rolling.u.y */
    out[1] = M_2_1; /* M: rolling.u.x,rolling.u.y */
    out[5] = M_2_1; /* M: rolling.u.y,rolling.u.x */
    /* M: rolling.u.y,rolling.u.y */
    out[6] = rolling_R_yx * rolling_momentum_fx_2 + rolling_R_yy * rolling_momentum_fy
        + rolling_R_yz * rolling_momentum_fz_2;
    out[2] = M_3_1; /* M: rolling.u.x,rolling.u.yaw */
    out[10] = M_3_1; /* M: rolling.u.yaw,rolling.u.x */
    out[7] = M_3_2; /* M: rolling.u.y,rolling.u.yaw */
    out[11] = M_3_2; /* M: rolling.u.yaw,rolling.u.y */
    /* M: rolling.u.yaw,rolling.u.yaw */
    out[12] = rolling_R_zz * rolling_momentum_mz + rolling_S_2 * rolling_momentum_fx_3
        + rolling_M_3;
    out[13] = M_4_3; /* M: rolling.u.yaw,rolling.u.lean */
    out[17] = M_4_3; /* M: rolling.u.lean,rolling.u.yaw */
    /* M: rolling.u.lean,rolling.u.lean */
    out[18] = rolling_R_4 * rolling_momentum_mx + rolling_M_2 + rolling_R_5 * rolling_momentum_mz_2;

    /* results that are numbers or inputs */
    out[4] = CARDAN_REAL(0.0); /* M: rolling.u.x,rolling.u.spin */
    out[9] = CARDAN_REAL(0.0); /* M: rolling.u.y,rolling.u.spin */
    out[19] = CARDAN_REAL(0.0); /* M: rolling.u.lean,rolling.u.spin */
    out[20] = CARDAN_REAL(0.0); /* M: rolling.u.spin,rolling.u.x */
    out[21] = CARDAN_REAL(0.0); /* M: rolling.u.spin,rolling.u.y */
    out[23] = CARDAN_REAL(0.0); /* M: rolling.u.spin,rolling.u.lean */
    out[24] = CARDAN_REAL(w[3]); /* M: rolling.u.spin,rolling.u.spin */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {25, 0, 6, 0, 5, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
