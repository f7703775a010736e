/*
 * revolute__reaction
 * wrench of parent on child at the child joint frame, in its axes
 * passes: reassociate, schedule
 *
 * Sizes: out 6, work 0, w 0
 * Operations per call: 67 = 39 mul, 14 sub, 12 add, 1 cos, 1 sin
 * Operations of prepare: none
 *
 * Input q (8): generalized coordinates
 *   q[0]  body1.w
 *   q[1]  body1.x
 *   q[2]  body1.y
 *   q[3]  body1.z
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
    const real body1_w = q[0];
    const real body1_x = q[1];
    const real body1_y = q[2];
    const real body1_z = q[3];
    const real twice_body1_x = 2.0 * body1_x;
    const real twice_body1_y = 2.0 * body1_y;
    const real twice_body1_z = 2.0 * body1_z;
    const real body1_w_times_twice_body1_x = body1_w * twice_body1_x;
    const real one_minus_body1_x_times_twice_body1_x = 1.0 - body1_x * twice_body1_x;
    const real body1_w_times_twice_body1_y = body1_w * twice_body1_y;
    const real body1_w_times_twice_body1_z = body1_w * twice_body1_z;
    const real body1_x_times_twice_body1_y = body1_x * twice_body1_y;
    const real body1_y_times_twice_body1_y = body1_y * twice_body1_y;
    const real body1_x_times_twice_body1_z = body1_x * twice_body1_z;
    const real body1_y_times_twice_body1_z = body1_y * twice_body1_z;
    const real body1_z_times_twice_body1_z = body1_z * twice_body1_z;
    const real body1_R_xx = 1.0 - body1_y_times_twice_body1_y - body1_z_times_twice_body1_z;
    const real body1_R_yy = one_minus_body1_x_times_twice_body1_x - body1_z_times_twice_body1_z;
    const real body1_R_zz = one_minus_body1_x_times_twice_body1_x - body1_y_times_twice_body1_y;
    const real body1_R_xy = body1_x_times_twice_body1_y - body1_w_times_twice_body1_z;
    const real body1_R_yx = body1_w_times_twice_body1_z + body1_x_times_twice_body1_y;
    const real body1_R_xz = body1_w_times_twice_body1_y + body1_x_times_twice_body1_z;
    const real body1_R_zx = body1_x_times_twice_body1_z - body1_w_times_twice_body1_y;
    const real body1_R_yz = body1_y_times_twice_body1_z - body1_w_times_twice_body1_x;
    const real body1_R_zy = body1_w_times_twice_body1_x + body1_y_times_twice_body1_z;

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
