/*
 * mass_matrix of v_twin
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: axes, base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 36, work 0, w 10
 * Operations per call: 12 = 6 mul, 4 add, 2 cos
 * Operations of prepare: 36 = 28 mul, 8 add
 *
 * Input q (6): generalized coordinates
 *   q[0]  right.crank [rad]
 *   q[1]  right.rod [rad]
 *   q[2]  right.piston [m]
 *   q[3]  left.crank [rad]
 *   q[4]  left.rod [rad]
 *   q[5]  left.piston [m]
 *
 * Input p (18): parameters, read by prepare_ only
 *
 * Output M (6 x 6): out[0 ... 35], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* right.crank: mass, first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal right_crank_length = p[0]; /* m */
    const wreal right_crank_mass = p[4]; /* kg */
    const wreal right_rod_mass = p[5]; /* kg */
    const wreal half_right_crank_length = 0.5 * right_crank_length;
    const wreal right_crank_first_moment_x = right_crank_mass * half_right_crank_length;
    const wreal right_crank_origin_inertia_yy = right_crank_length * right_crank_length *
        (0.08333333333333333 * right_crank_mass)
        + half_right_crank_length * right_crank_first_moment_x;
    const wreal right_crank_base_inertia_yy = right_crank_origin_inertia_yy
        + right_crank_length * right_rod_mass * right_crank_length;

    /* right.rod: mass, first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal right_rod_length = p[1]; /* m */
    const wreal half_right_rod_length = 0.5 * right_rod_length;
    const wreal right_rod_first_moment_x = right_rod_mass * half_right_rod_length;
    const wreal right_rod_origin_inertia_yy = right_rod_length * right_rod_length *
        (0.08333333333333333 * right_rod_mass) + half_right_rod_length * right_rod_first_moment_x;
    w[4] = right_rod_first_moment_x;
    w[5] = right_rod_origin_inertia_yy;

    /* left.crank: mass, first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal left_crank_length = p[7]; /* m */
    const wreal left_crank_mass = p[11]; /* kg */
    const wreal left_rod_mass = p[12]; /* kg */
    const wreal half_left_crank_length = 0.5 * left_crank_length;
    const wreal left_crank_first_moment_x = left_crank_mass * half_left_crank_length;
    const wreal left_crank_origin_inertia_yy = left_crank_length * left_crank_length *
        (0.08333333333333333 * left_crank_mass)
        + half_left_crank_length * left_crank_first_moment_x;
    const wreal left_crank_base_inertia_yy = left_crank_origin_inertia_yy
        + left_crank_length * left_rod_mass * left_crank_length;

    /* left.rod: mass, first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal left_rod_length = p[8]; /* m */
    const wreal half_left_rod_length = 0.5 * left_rod_length;
    const wreal left_rod_first_moment_x = left_rod_mass * half_left_rod_length;
    const wreal left_rod_origin_inertia_yy = left_rod_length * left_rod_length *
        (0.08333333333333333 * left_rod_mass) + half_left_rod_length * left_rod_first_moment_x;
    w[6] = left_rod_first_moment_x;
    w[7] = left_rod_origin_inertia_yy;

    /* left.crank: inertia */
    const wreal left_rod_origin_inertia_yy_plus_left_crank_base_inertia_yy =
        left_rod_origin_inertia_yy + left_crank_base_inertia_yy;
    w[8] = left_rod_origin_inertia_yy_plus_left_crank_base_inertia_yy;

    /* right.crank: inertia */
    const wreal right_rod_origin_inertia_yy_plus_right_crank_base_inertia_yy =
        right_rod_origin_inertia_yy + right_crank_base_inertia_yy;
    w[9] = right_rod_origin_inertia_yy_plus_right_crank_base_inertia_yy;

    /* parameters as they are */
    w[0] = p[0]; /* right.crank_length [m] */
    w[1] = p[6]; /* right.piston_mass [kg] */
    w[2] = p[7]; /* left.crank_length [m] */
    w[3] = p[13]; /* left.piston_mass [kg] */
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
    memset(out + 2, 0, 33 * sizeof(real));

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
    const real right_rod = q[1]; /* rad */
    const real left_rod = q[4]; /* rad */
    const real angle[CARDAN_PADDED(2)] = {left_rod, right_rod};
    real sine[CARDAN_PADDED(2)], cosine[CARDAN_PADDED(2)];
    cardan_sincos(2, angle, sine, cosine);
    const real left_rod_cos = cosine[0];
    const real right_rod_cos = cosine[1];

    /* shared by several: inertia */
    const wreal right_crank_length = w[0]; /* m */
    const wreal left_crank_length = w[2]; /* m */
    const wreal right_rod_first_moment_x = w[4];
    const wreal left_rod_first_moment_x = w[6];
    const real left_crank_length_times_left_crank_inertia_mean_moment_x = left_rod_first_moment_x *
        left_rod_cos * left_crank_length;
    const real right_crank_length_times_right_crank_inertia_mean_moment_x = right_rod_first_moment_x
        * right_rod_cos * right_crank_length;

    /* left.crank: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal left_rod_origin_inertia_yy_plus_left_crank_base_inertia_yy = w[8];
    /* M: left.crank.u,left.crank.u */
    out[21] = 2.0 * left_crank_length_times_left_crank_inertia_mean_moment_x
        + left_rod_origin_inertia_yy_plus_left_crank_base_inertia_yy;

    /* M */
    /* M = S . momentum */
    const wreal right_rod_origin_inertia_yy = w[5];
    const wreal left_rod_origin_inertia_yy = w[7];
    const real M_left_rod_left_crank = left_rod_origin_inertia_yy
        + left_crank_length_times_left_crank_inertia_mean_moment_x;
    const real M_right_rod_right_crank = right_rod_origin_inertia_yy
        + right_crank_length_times_right_crank_inertia_mean_moment_x;
    out[22] = M_left_rod_left_crank; /* M: left.crank.u,left.rod.u */
    out[27] = M_left_rod_left_crank; /* M: left.rod.u,left.crank.u */
    out[1] = M_right_rod_right_crank; /* M: right.crank.u,right.rod.u */
    out[6] = M_right_rod_right_crank; /* M: right.rod.u,right.crank.u */

    /* right.crank: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal right_rod_origin_inertia_yy_plus_right_crank_base_inertia_yy = w[9];
    /* M: right.crank.u,right.crank.u */
    out[0] = 2.0 * right_crank_length_times_right_crank_inertia_mean_moment_x
        + right_rod_origin_inertia_yy_plus_right_crank_base_inertia_yy;

    /* results that are numbers or inputs */
    out[7] = CARDAN_REAL(w[5]); /* M: right.rod.u,right.rod.u */
    out[14] = CARDAN_REAL(w[1]); /* M: right.piston.u,right.piston.u */
    out[28] = CARDAN_REAL(w[7]); /* M: left.rod.u,left.rod.u */
    out[35] = CARDAN_REAL(w[3]); /* M: left.piston.u,left.piston.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {36, 0, 10, 0, 6, 0, 0, 0, 0, 18, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
