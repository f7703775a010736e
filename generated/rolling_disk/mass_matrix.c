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
    /* coin: mass, origin inertia */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal m = p[0]; /* kg */
    const wreal r_value = p[1]; /* m */
    const wreal r_squared = r_value * r_value;
    const wreal coin_origin_inertia_xx = 0.25 * m * r_squared;
    const wreal coin_origin_inertia_yy = 0.5 * m * r_squared;
    w[2] = coin_origin_inertia_xx;
    w[3] = coin_origin_inertia_yy;

    /* rolling: M */
    /* M = S . momentum */
    const wreal momentum_minus_rolling_lean_fy = m * r_value;
    const wreal r_times_momentum_minus_rolling_lean_fy = r_value * momentum_minus_rolling_lean_fy;
    w[4] = momentum_minus_rolling_lean_fy;
    w[5] = r_times_momentum_minus_rolling_lean_fy;

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

    /* rolling: R */
    /* R = R_fixed R_joint(q) */
    const real rolling_yaw = q[2]; /* rad */
    const real rolling_lean = q[3]; /* rad */
    const real rolling_spin = q[4]; /* rad */
    const real angle[CARDAN_PADDED(3)] = {rolling_yaw, rolling_lean, rolling_spin};
    real sine[CARDAN_PADDED(3)], cosine[CARDAN_PADDED(3)];
    cardan_sincos(3, angle, sine, cosine);
    const real rolling_yaw_cos = cosine[0];
    const real rolling_yaw_sin = sine[0];
    const real rolling_lean_cos = cosine[1];
    const real rolling_lean_sin = sine[1];
    const real rolling_spin_cos = cosine[2];
    const real rolling_spin_sin = sine[2];

    /* rolling: R, S */
    /* R = R_fixed R_joint(q) */
    /* S = d(twist of the child) / du */
    const wreal r_value = w[1]; /* m */
    const real rolling_minus_R_xy = rolling_yaw_sin * rolling_lean_cos;
    const real rolling_yaw_sin_times_lean_sin = rolling_yaw_sin * rolling_lean_sin;
    const real rolling_R_yy = rolling_yaw_cos * rolling_lean_cos;
    const real rolling_yaw_cos_times_lean_sin = rolling_yaw_cos * rolling_lean_sin;
    const real rolling_R_xx = rolling_yaw_cos * rolling_spin_cos
        - rolling_yaw_sin_times_lean_sin * rolling_spin_sin;
    const real rolling_R_xz = rolling_yaw_cos * rolling_spin_sin
        + rolling_yaw_sin_times_lean_sin * rolling_spin_cos;
    const real rolling_R_yx = rolling_yaw_sin * rolling_spin_cos
        + rolling_yaw_cos_times_lean_sin * rolling_spin_sin;
    const real rolling_R_yz = rolling_yaw_sin * rolling_spin_sin
        - rolling_yaw_cos_times_lean_sin * rolling_spin_cos;
    const real rolling_minus_R_zx = rolling_lean_cos * rolling_spin_sin;
    const real rolling_R_zz = rolling_lean_cos * rolling_spin_cos;
    const real r_times_rolling_lean_sin = r_value * rolling_lean_sin;
    const real rolling_spin_cos_times_r_times_rolling_lean_sin = rolling_spin_cos *
        r_times_rolling_lean_sin;
    const real rolling_spin_sin_times_r_times_rolling_lean_sin = rolling_spin_sin *
        r_times_rolling_lean_sin;

    /* momentum */
    /* momentum = composite inertia S */
    const wreal m = w[0]; /* kg */
    const wreal coin_origin_inertia_xx = w[2];
    const wreal coin_origin_inertia_yy = w[3];
    const real momentum_rolling_x_fx = m * rolling_R_xx;
    const real momentum_rolling_x_fz = m * rolling_R_xz;
    const real momentum_rolling_y_fx = m * rolling_R_yx;
    const real momentum_rolling_y_fy = m * rolling_R_yy;
    const real momentum_rolling_y_fz = m * rolling_R_yz;
    const real momentum_rolling_yaw_my = coin_origin_inertia_yy * rolling_lean_sin;
    const real momentum_rolling_yaw_mz = coin_origin_inertia_xx * rolling_R_zz;
    const real momentum_rolling_yaw_fx = m * rolling_spin_cos_times_r_times_rolling_lean_sin;
    const real momentum_rolling_yaw_fz = m * rolling_spin_sin_times_r_times_rolling_lean_sin;
    const real momentum_rolling_lean_mx = coin_origin_inertia_xx * rolling_spin_cos;
    const real momentum_rolling_lean_mz = coin_origin_inertia_xx * rolling_spin_sin;
    out[14] = momentum_rolling_yaw_my; /* M: rolling.u.yaw,rolling.u.spin */
    out[22] = momentum_rolling_yaw_my; /* M: rolling.u.spin,rolling.u.yaw */

    /* M */
    /* M = S . momentum */
    const wreal momentum_minus_rolling_lean_fy = w[4];
    const wreal r_times_momentum_minus_rolling_lean_fy = w[5];
    const real M_rolling_lean_rolling_x = rolling_minus_R_xy * momentum_minus_rolling_lean_fy;
    const real M_rolling_y_rolling_x = rolling_R_xx * momentum_rolling_y_fx
        - rolling_minus_R_xy * momentum_rolling_y_fy + rolling_R_xz * momentum_rolling_y_fz;
    const real M_rolling_yaw_rolling_x = rolling_R_xx * momentum_rolling_yaw_fx
        + rolling_R_xz * momentum_rolling_yaw_fz;
    const real M_rolling_yaw_rolling_y = rolling_R_yx * momentum_rolling_yaw_fx
        + rolling_R_yz * momentum_rolling_yaw_fz;
    const real M_rolling_lean_rolling_yaw = rolling_R_zz * momentum_rolling_lean_mz
        - rolling_minus_R_zx * momentum_rolling_lean_mx;
    /* M: rolling.u.x,rolling.u.x */
    out[0] = rolling_R_xx * momentum_rolling_x_fx + m * rolling_minus_R_xy * rolling_minus_R_xy
        + rolling_R_xz * momentum_rolling_x_fz;
    out[3] = M_rolling_lean_rolling_x; /* M: rolling.u.x,rolling.u.lean */
    out[15] = M_rolling_lean_rolling_x; /* M: rolling.u.lean,rolling.u.x */
    out[1] = M_rolling_y_rolling_x; /* M: rolling.u.x,rolling.u.y */
    out[5] = M_rolling_y_rolling_x; /* M: rolling.u.y,rolling.u.x */
    /* M: rolling.u.y,rolling.u.y */
    out[6] = rolling_R_yx * momentum_rolling_y_fx + rolling_R_yy * momentum_rolling_y_fy
        + rolling_R_yz * momentum_rolling_y_fz;
    out[2] = M_rolling_yaw_rolling_x; /* M: rolling.u.x,rolling.u.yaw */
    out[10] = M_rolling_yaw_rolling_x; /* M: rolling.u.yaw,rolling.u.x */
    out[7] = M_rolling_yaw_rolling_y; /* M: rolling.u.y,rolling.u.yaw */
    out[11] = M_rolling_yaw_rolling_y; /* M: rolling.u.yaw,rolling.u.y */
    out[13] = M_rolling_lean_rolling_yaw; /* M: rolling.u.yaw,rolling.u.lean */
    out[17] = M_rolling_lean_rolling_yaw; /* M: rolling.u.lean,rolling.u.yaw */
    /* M: rolling.u.lean,rolling.u.lean */
    out[18] = rolling_spin_cos * momentum_rolling_lean_mx
        + r_times_momentum_minus_rolling_lean_fy + rolling_spin_sin * momentum_rolling_lean_mz;

    /* shared by several: M */
    /* M = S . momentum */
    const real momentum_rolling_lean_about_ground_fy = -rolling_R_yy *
        momentum_minus_rolling_lean_fy;
    out[8] = momentum_rolling_lean_about_ground_fy; /* M: rolling.u.y,rolling.u.lean */
    out[16] = momentum_rolling_lean_about_ground_fy; /* M: rolling.u.lean,rolling.u.y */

    /* rolling: M */
    /* M = S . momentum */
    const real M_rolling_yaw_rolling_yaw_part = coin_origin_inertia_xx * rolling_minus_R_zx *
        rolling_minus_R_zx + rolling_lean_sin * momentum_rolling_yaw_my
        + rolling_spin_sin_times_r_times_rolling_lean_sin * momentum_rolling_yaw_fz;

    /* M */
    /* M = S . momentum */
    /* M: rolling.u.yaw,rolling.u.yaw */
    out[12] = rolling_R_zz * momentum_rolling_yaw_mz
        + rolling_spin_cos_times_r_times_rolling_lean_sin * momentum_rolling_yaw_fx
        + M_rolling_yaw_rolling_yaw_part;

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
const int mass_matrix_sizes[] = {25, 0, 6, 0, 5, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
