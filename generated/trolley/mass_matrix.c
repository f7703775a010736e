/*
 * mass_matrix of trolley
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate
 *
 * Sizes: out 25, work 0, w 7
 * Operations per call: 18 = 10 mul, 2 add, 2 cos, 2 neg, 2 sin
 * Operations of prepare: 26 = 19 mul, 6 add, 1 div
 *
 * Input q (5): generalized coordinates
 *   q[0]  track [m]
 *   q[1]  left.hang.angle1 [rad]
 *   q[2]  left.hang.angle2 [rad]
 *   q[3]  right.hang.angle1 [rad]
 *   q[4]  right.hang.angle2 [rad]
 *
 * Input p (13): parameters, read by prepare_ only
 *
 * Output M (5 x 5): out[0 ... 24], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* left.bucket: mass, origin inertia */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal left_load = p[3]; /* kg */
    const wreal left_rope = p[4]; /* m */
    const wreal left_size = p[5]; /* m */
    const wreal left_size_squared = left_size * left_size;
    const wreal left_bucket_origin_inertia_zz = 0.5 * left_load * left_size_squared;
    const wreal left_bucket_minus_first_moment_z = left_load * left_rope;
    const wreal left_bucket_origin_inertia_xx = 0.3333333333333333 * left_load * left_size_squared +
        left_rope * left_bucket_minus_first_moment_z;
    w[0] = left_bucket_origin_inertia_zz;
    w[1] = left_bucket_minus_first_moment_z;
    w[2] = left_bucket_origin_inertia_xx;

    /* right.bucket: mass, origin inertia */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal right_load = p[6]; /* kg */
    const wreal right_rope = p[7]; /* m */
    const wreal right_size = p[8]; /* m */
    const wreal right_size_squared = right_size * right_size;
    const wreal right_bucket_origin_inertia_zz = 0.5 * right_load * right_size_squared;
    const wreal right_bucket_minus_first_moment_z = right_load * right_rope;
    const wreal right_bucket_origin_inertia_xx = 0.3333333333333333 * right_load *
        right_size_squared + right_rope * right_bucket_minus_first_moment_z;
    w[3] = right_bucket_origin_inertia_zz;
    w[4] = right_bucket_minus_first_moment_z;
    w[5] = right_bucket_origin_inertia_xx;

    /* wheel: origin inertia */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal wheel = p[1]; /* kg */
    const wreal radius = p[2]; /* m */
    const wreal wheel_origin_inertia_yy = radius * radius * (0.5 * wheel);

    /* axle: coupling */
    const wreal radius_inverse = 1.0 / radius;

    /* trolley: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal trolley_mass = p[10]; /* kg */
    const wreal trolley_base_mass = left_load + right_load + (wheel + trolley_mass);

    /* momentum */
    /* momentum = composite inertia S */
    const wreal momentum_track_my = wheel_origin_inertia_yy * radius_inverse;

    /* M */
    /* M = S . momentum */
    const wreal M_track_track = trolley_base_mass + radius_inverse * momentum_track_my;
    w[6] = M_track_track;
}

#include "lanes.h"

/* M: kinetic energy is 1/2 uᵀ M u */
CARDAN_API int mass_matrix(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const wreal *const w = in->w;
    (void)work;

    /* zeros among the results; what stands between them follows */
    memset(out + 1, 0, 23 * sizeof(real));

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
    const real left_hang_angle2 = q[2]; /* rad */
    const real right_hang_angle2 = q[4]; /* rad */
    const real angle[CARDAN_PADDED(2)] = {left_hang_angle2, right_hang_angle2};
    real sine[CARDAN_PADDED(2)], cosine[CARDAN_PADDED(2)];
    cardan_sincos(2, angle, sine, cosine);
    const real left_hang_angle2_cos = cosine[0];
    const real left_hang_angle2_sin = sine[0];
    const real right_hang_angle2_cos = cosine[1];
    const real right_hang_angle2_sin = sine[1];

    /* momentum */
    /* momentum = composite inertia S */
    const wreal left_bucket_origin_inertia_zz = w[0];
    const wreal left_bucket_minus_first_moment_z = w[1];
    const wreal left_bucket_origin_inertia_xx = w[2];
    const wreal right_bucket_origin_inertia_zz = w[3];
    const wreal right_bucket_minus_first_moment_z = w[4];
    const wreal right_bucket_origin_inertia_xx = w[5];
    const real momentum_right_hang_angle1_mx = right_bucket_origin_inertia_xx *
        right_hang_angle2_cos;
    const real momentum_right_hang_angle1_mz = right_bucket_origin_inertia_zz *
        right_hang_angle2_sin;
    const real momentum_left_hang_angle1_mx = left_bucket_origin_inertia_xx * left_hang_angle2_cos;
    const real momentum_left_hang_angle1_mz = left_bucket_origin_inertia_zz * left_hang_angle2_sin;
    const real momentum_right_hang_angle1_fy = right_bucket_minus_first_moment_z *
        right_hang_angle2_cos;
    const real momentum_left_hang_angle1_fy = left_bucket_minus_first_moment_z *
        left_hang_angle2_cos;

    /* M */
    /* M = S . momentum */
    /* M: right.hang.u.angle1,right.hang.u.angle1 */
    out[18] = right_hang_angle2_cos * momentum_right_hang_angle1_mx
        + right_hang_angle2_sin * momentum_right_hang_angle1_mz;
    /* M: left.hang.u.angle1,left.hang.u.angle1 */
    out[6] = left_hang_angle2_cos * momentum_left_hang_angle1_mx
        + left_hang_angle2_sin * momentum_left_hang_angle1_mz;

    /* shared by several: M */
    /* M = S . momentum */
    const real momentum_right_hang_angle2_about_trolley_fx = -momentum_right_hang_angle1_fy;
    const real momentum_left_hang_angle2_about_trolley_fx = -momentum_left_hang_angle1_fy;
    out[4] = momentum_right_hang_angle2_about_trolley_fx; /* M: track.u,right.hang.u.angle2 */
    out[20] = momentum_right_hang_angle2_about_trolley_fx; /* M: right.hang.u.angle2,track.u */
    out[2] = momentum_left_hang_angle2_about_trolley_fx; /* M: track.u,left.hang.u.angle2 */
    out[10] = momentum_left_hang_angle2_about_trolley_fx; /* M: left.hang.u.angle2,track.u */

    /* results that are numbers or inputs */
    out[0] = CARDAN_REAL(w[6]); /* M: track.u,track.u */
    out[12] = CARDAN_REAL(w[2]); /* M: left.hang.u.angle2,left.hang.u.angle2 */
    out[24] = CARDAN_REAL(w[5]); /* M: right.hang.u.angle2,right.hang.u.angle2 */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {25, 0, 7, 0, 5, 0, 0, 0, 0, 13, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
