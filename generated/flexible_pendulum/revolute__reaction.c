/*
 * revolute__reaction
 * wrench of parent on child at the child joint frame, in its axes
 * Source: R. Featherstone, Rigid Body Dynamics Algorithms, 2008, table 4.1
 * passes: reassociate, schedule
 *
 * Sizes: out 6, work 0, w 0
 * Operations per call: 67 = 39 mul, 14 sub, 12 add, 1 cos, 1 sin
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
 * Input lam (6): Lagrange multipliers
 *   lam[0]  joint.rx [N*m]
 *   lam[1]  joint.ry [N*m]
 *   lam[2]  joint.rz [N*m]
 *   lam[3]  joint.px [N]
 *   lam[4]  joint.py [N]
 *   lam[5]  joint.pz [N]
 *
 * Output reaction (6)
 *   out[0]  mx [N*m]
 *   out[1]  my [N*m]
 *   out[2]  mz [N*m]
 *   out[3]  fx [N]
 *   out[4]  fy [N]
 *   out[5]  fz [N]
 */
#include "cardan.h"

CARDAN_API void prepare_revolute__reaction(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    (void)p;
    (void)w;
}

#include "lanes.h"

/* wrench of parent on child at the child joint frame, in its axes */
CARDAN_API int revolute__reaction(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
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
    const real body1_R_yx = body1_qw_times_twice_body1_qz + body1_qx_times_twice_body1_qy;
    const real body1_R_xz = body1_qw_times_twice_body1_qy + body1_qx_times_twice_body1_qz;
    const real body1_R_zx = body1_qx_times_twice_body1_qz - body1_qw_times_twice_body1_qy;
    const real body1_R_yz = body1_qy_times_twice_body1_qz - body1_qw_times_twice_body1_qx;
    const real body1_R_zy = body1_qw_times_twice_body1_qx + body1_qy_times_twice_body1_qz;

    /* common */
    const real joint_rx = lam[0]; /* N*m */
    const real joint_ry = lam[1]; /* N*m */
    const real joint_rz = lam[2]; /* N*m */
    const real joint_px = lam[3]; /* N */
    const real joint_py = lam[4]; /* N */
    const real joint_pz = lam[5]; /* N */
    const real joint_sin_times_body1_R_xz_plus_cos_times_body1_R_zz = joint_sin * body1_R_xz
        + joint_cos * body1_R_zz;
    const real joint_cos_times_body1_R_xy_minus_sin_times_body1_R_zy = joint_cos * body1_R_xy
        - joint_sin * body1_R_zy;
    const real joint_cos_times_body1_R_xx_minus_sin_times_body1_R_zx = joint_cos * body1_R_xx
        - joint_sin * body1_R_zx;
    const real joint_sin_times_body1_R_xx_plus_cos_times_body1_R_zx = joint_sin * body1_R_xx
        + joint_cos * body1_R_zx;
    /* reaction: fz [N] */
    out[5] = joint_px * (joint_cos * body1_R_xz - joint_sin * body1_R_zz) + joint_py * body1_R_yz
        + joint_pz * joint_sin_times_body1_R_xz_plus_cos_times_body1_R_zz;
    /* reaction: mx [N*m] */
    out[0] = joint_rx * joint_sin_times_body1_R_xz_plus_cos_times_body1_R_zz
        - joint_ry * joint_cos_times_body1_R_xy_minus_sin_times_body1_R_zy;
    /* reaction: fy [N] */
    out[4] = joint_px * joint_cos_times_body1_R_xy_minus_sin_times_body1_R_zy
        + joint_py * body1_R_yy + joint_pz * (joint_sin * body1_R_xy + joint_cos * body1_R_zy);
    /* reaction: my [N*m] */
    out[1] = joint_ry * joint_cos_times_body1_R_xx_minus_sin_times_body1_R_zx
        - joint_rz * body1_R_yz;
    /* reaction: mz [N*m] */
    out[2] = joint_rz * body1_R_yy
        - joint_rx * joint_sin_times_body1_R_xx_plus_cos_times_body1_R_zx;
    /* reaction: fx [N] */
    out[3] = joint_px * joint_cos_times_body1_R_xx_minus_sin_times_body1_R_zx
        + joint_py * body1_R_yx + joint_pz * joint_sin_times_body1_R_xx_plus_cos_times_body1_R_zx;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int revolute__reaction_sizes[] = {6, 0, 0, 0, 8, 0, 0, 0, 0, 0, 0, 0, 0, 6, 0, 0, 0, 0, 0};
#endif
