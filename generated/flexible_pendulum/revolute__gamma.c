/*
 * revolute__gamma
 * G udot = gamma
 * Source: R. Featherstone, Rigid Body Dynamics Algorithms, 2008, table 4.1
 * passes: reassociate, schedule
 *
 * Sizes: out 6, work 0, w 0
 * Operations per call: 112 = 62 mul, 27 sub, 21 add, 1 cos, 1 sin
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
 * Output gamma (6): out[0 ... 5]
 */
#include "cardan.h"

CARDAN_API void prepare_revolute__gamma(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    (void)p;
    (void)w;
}

#include "lanes.h"

/* G udot = gamma */
CARDAN_API int revolute__gamma(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
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

    /* joint: R */
    /* R = R_fixed R_joint(q) */
    const real joint_u = u[6]; /* rad/s */
    const real joint_sin_times_u = joint_sin * joint_u;
    const real joint_cos_times_u = joint_cos * joint_u;
    const real joint_u_times_cos_times_u = joint_u * joint_cos_times_u;
    const real joint_u_times_sin_times_u = joint_u * joint_sin_times_u;

    /* common */
    const real body1_px = q[4]; /* m */
    const real body1_pz = q[6]; /* m */
    const real body1_u_x = u[0]; /* rad/s */
    const real body1_u_y = u[1]; /* rad/s */
    const real body1_u_z = u[2]; /* rad/s */
    const real body1_u_px = u[3]; /* m/s */
    const real body1_u_pz = u[5]; /* m/s */
    const real body1_R_xz_times_u_x_minus_R_xx_times_u_z = body1_R_xz * body1_u_x
        - body1_R_xx * body1_u_z;
    const real body1_R_xx_times_u_y_minus_R_xy_times_u_x = body1_R_xx * body1_u_y
        - body1_R_xy * body1_u_x;
    const real body1_R_zz_times_u_x_minus_R_zx_times_u_z = body1_R_zz * body1_u_x
        - body1_R_zx * body1_u_z;
    const real body1_R_zx_times_u_y_minus_R_zy_times_u_x = body1_R_zx * body1_u_y
        - body1_R_zy * body1_u_x;
    const real body1_u_px_times_joint_sin_times_u = body1_u_px * joint_sin_times_u;
    const real body1_u_pz_times_joint_cos_times_u = body1_u_pz * joint_cos_times_u;
    const real body1_u_px_times_joint_cos_times_u = body1_u_px * joint_cos_times_u;
    const real body1_u_pz_times_joint_sin_times_u = body1_u_pz * joint_sin_times_u;
    const real body1_R_xy_times_u_z_minus_R_xz_times_u_y = body1_R_xy * body1_u_z
        - body1_R_xz * body1_u_y;
    const real body1_R_zy_times_u_z_minus_R_zz_times_u_y = body1_R_zy * body1_u_z
        - body1_R_zz * body1_u_y;
    const real gamma_part = joint_sin_times_u * body1_R_xx_times_u_y_minus_R_xy_times_u_x;
    const real gamma_part_2 = joint_sin_times_u * body1_R_zz_times_u_x_minus_R_zx_times_u_z;
    const real gamma_part_3 = joint_cos_times_u * body1_R_xz_times_u_x_minus_R_xx_times_u_z;
    const real gamma_part_4 = joint_cos_times_u * body1_R_zx_times_u_y_minus_R_zy_times_u_x;
    const real gamma_part_5 = joint_sin * (body1_u_x * body1_R_xx_times_u_y_minus_R_xy_times_u_x
        - body1_u_z * body1_R_xy_times_u_z_minus_R_xz_times_u_y)
        + joint_cos * (body1_u_x * body1_R_zx_times_u_y_minus_R_zy_times_u_x
        - body1_u_z * body1_R_zy_times_u_z_minus_R_zz_times_u_y);
    const real gamma_part_6 = joint_sin * (body1_u_y * body1_R_zy_times_u_z_minus_R_zz_times_u_y
        - body1_u_x * body1_R_zz_times_u_x_minus_R_zx_times_u_z)
        - joint_cos * (body1_u_y * body1_R_xy_times_u_z_minus_R_xz_times_u_y
        - body1_u_x * body1_R_xz_times_u_x_minus_R_xx_times_u_z);
    /* gamma[2] */
    out[2] = body1_u_y * (body1_R_yx * body1_u_y - body1_R_yy * body1_u_x)
        - body1_u_z * (body1_R_yz * body1_u_x - body1_R_yx * body1_u_z);
    /* gamma[0] */
    out[0] = body1_R_zy * joint_u_times_cos_times_u - (gamma_part_3 + gamma_part_3)
        + (gamma_part_2 + gamma_part_2 + (body1_R_xy * joint_u_times_sin_times_u - gamma_part_5));
    /* gamma[1] */
    out[1] = gamma_part + gamma_part - body1_R_zz * joint_u_times_sin_times_u + (gamma_part_4
        + gamma_part_4 + (body1_R_xz * joint_u_times_cos_times_u + gamma_part_6));
    /* gamma[3] */
    out[3] = body1_px * joint_u_times_cos_times_u - body1_pz * joint_u_times_sin_times_u
        + (body1_u_px_times_joint_sin_times_u + body1_u_px_times_joint_sin_times_u
        + (body1_u_pz_times_joint_cos_times_u + body1_u_pz_times_joint_cos_times_u));
    /* gamma[5] */
    out[5] = body1_px * joint_u_times_sin_times_u + body1_pz * joint_u_times_cos_times_u
        + (body1_u_pz_times_joint_sin_times_u + body1_u_pz_times_joint_sin_times_u
        - (body1_u_px_times_joint_cos_times_u + body1_u_px_times_joint_cos_times_u));

    /* results that are numbers or inputs */
    out[4] = CARDAN_REAL(0.0); /* gamma[4] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int revolute__gamma_sizes[] = {6, 0, 0, 0, 8, 7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
