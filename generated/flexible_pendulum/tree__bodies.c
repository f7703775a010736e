/*
 * tree__bodies
 * of bodies of a rigid tree R (9), p (3), velocity (6), acceleration (6), ground axes
 * Source: Roberson and Schwertassek, Dynamics of Multibody Systems, 1988, chapter 12
 * passes: reassociate, schedule
 *
 * Sizes: out 24, work 0, w 1
 * Operations per call: 12 = 6 mul, 3 sub, 1 cos, 1 neg, 1 sin
 * Operations of prepare: none
 *
 * Input q (1): generalized coordinates
 *   q[0]  joint1 [rad]
 *
 * Input u (1): generalized speeds
 *   u[0]  joint1.u [rad/s]
 *
 * Input p (1): parameters, read by prepare_ only
 *
 * Input udot (1): derivatives of the speeds
 *   udot[0]  joint1.udot [rad/s^2]
 *
 * Output bodies (1 x 24): out[0 ... 23], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_tree__bodies(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* parameters as they are */
    w[0] = p[0]; /* gravity.1 */
}

#include "lanes.h"

/* of bodies of a rigid tree R (9), p (3), velocity (6), acceleration (6), ground axes */
CARDAN_API int tree__bodies(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    const real *const udot = in->udot;
    (void)work;

    /* joint1: R */
    /* R = R_fixed R_joint(q) */
    const real joint1_q = q[0]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {joint1_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real joint1_cos = cosine[0];
    const real joint1_sin = sine[0];
    out[0] = joint1_cos; /* bodies[0][0] */
    out[8] = joint1_cos; /* bodies[0][8] */
    out[2] = joint1_sin; /* bodies[0][2] */

    /* joint1: R, a */
    /* R = R_fixed R_joint(q) */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    const wreal gravity_1 = w[0];
    const real joint1_a_x = gravity_1 * joint1_sin;
    const real joint1_minus_a_z = gravity_1 * joint1_cos;
    out[6] = -joint1_sin; /* bodies[0][6] */

    /* common */
    out[21] = joint1_cos * joint1_a_x - joint1_sin * joint1_minus_a_z; /* bodies[0][21] */
    /* bodies[0][23] */
    out[23] = gravity_1 - joint1_sin * joint1_a_x - joint1_cos * joint1_minus_a_z;

    /* results that are numbers or inputs */
    out[1] = CARDAN_REAL(0.0); /* bodies[0][1] */
    out[3] = CARDAN_REAL(0.0); /* bodies[0][3] */
    out[4] = CARDAN_REAL(1.0); /* bodies[0][4] */
    out[5] = CARDAN_REAL(0.0); /* bodies[0][5] */
    out[7] = CARDAN_REAL(0.0); /* bodies[0][7] */
    out[9] = CARDAN_REAL(0.0); /* bodies[0][9] */
    out[10] = CARDAN_REAL(0.0); /* bodies[0][10] */
    out[11] = CARDAN_REAL(0.0); /* bodies[0][11] */
    out[12] = CARDAN_REAL(0.0); /* bodies[0][12] */
    out[13] = u[0]; /* bodies[0][13] */
    out[14] = CARDAN_REAL(0.0); /* bodies[0][14] */
    out[15] = CARDAN_REAL(0.0); /* bodies[0][15] */
    out[16] = CARDAN_REAL(0.0); /* bodies[0][16] */
    out[17] = CARDAN_REAL(0.0); /* bodies[0][17] */
    out[18] = CARDAN_REAL(0.0); /* bodies[0][18] */
    out[19] = udot[0]; /* bodies[0][19] */
    out[20] = CARDAN_REAL(0.0); /* bodies[0][20] */
    out[22] = CARDAN_REAL(0.0); /* bodies[0][22] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int tree__bodies_sizes[] = {24, 0, 1, 0, 1, 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
