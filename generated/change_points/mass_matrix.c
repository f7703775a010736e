/*
 * mass_matrix of change_points
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 25, work 0, w 9
 * Operations per call: 12 = 6 mul, 4 add, 2 cos
 * Operations of prepare: 23 = 14 mul, 9 add
 *
 * Input q (5): generalized coordinates
 *   q[0]  A0 [rad]
 *   q[1]  A1 [rad]
 *   q[2]  A2 [rad]
 *   q[3]  B0 [rad]
 *   q[4]  B1 [rad]
 *
 * Input p (28): parameters, read by prepare_ only
 *
 * Output M (5 x 5): out[0 ... 24], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* crank0: first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal crank0_mass = p[0]; /* kg */
    const wreal crank0_com_x = p[1]; /* m */
    const wreal crank0_inertia_zz = p[3]; /* kg m^2 */
    const wreal B0_position_x = p[14]; /* m */
    const wreal coupler0_mass = p[15]; /* kg */
    const wreal crank0_first_moment_x = crank0_mass * crank0_com_x;
    const wreal crank0_origin_inertia_zz = crank0_inertia_zz + crank0_com_x * crank0_first_moment_x;
    const wreal crank0_base_inertia_zz = crank0_origin_inertia_zz
        + B0_position_x * coupler0_mass * B0_position_x;

    /* crank1: first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal crank1_mass = p[5]; /* kg */
    const wreal crank1_com_x = p[6]; /* m */
    const wreal crank1_inertia_zz = p[8]; /* kg m^2 */
    const wreal B1_position_x = p[19]; /* m */
    const wreal coupler1_mass = p[20]; /* kg */
    const wreal crank1_first_moment_x = crank1_mass * crank1_com_x;
    const wreal crank1_origin_inertia_zz = crank1_inertia_zz + crank1_com_x * crank1_first_moment_x;
    const wreal crank1_base_inertia_zz = crank1_origin_inertia_zz
        + B1_position_x * coupler1_mass * B1_position_x;

    /* crank2: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal crank2_mass = p[10]; /* kg */
    const wreal crank2_com_x = p[11]; /* m */
    const wreal crank2_inertia_zz = p[13]; /* kg m^2 */
    const wreal crank2_first_moment_x = crank2_mass * crank2_com_x;
    const wreal crank2_origin_inertia_zz = crank2_inertia_zz + crank2_com_x * crank2_first_moment_x;
    w[0] = crank2_origin_inertia_zz;

    /* coupler0: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal coupler0_com_x = p[16]; /* m */
    const wreal coupler0_inertia_zz = p[18]; /* kg m^2 */
    const wreal coupler0_first_moment_x = coupler0_mass * coupler0_com_x;
    const wreal coupler0_origin_inertia_zz = coupler0_inertia_zz
        + coupler0_com_x * coupler0_first_moment_x;
    w[2] = coupler0_first_moment_x;
    w[3] = coupler0_origin_inertia_zz;

    /* coupler1: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal coupler1_com_x = p[21]; /* m */
    const wreal coupler1_inertia_zz = p[23]; /* kg m^2 */
    const wreal coupler1_first_moment_x = coupler1_mass * coupler1_com_x;
    const wreal coupler1_origin_inertia_zz = coupler1_inertia_zz
        + coupler1_com_x * coupler1_first_moment_x;
    w[5] = coupler1_first_moment_x;
    w[6] = coupler1_origin_inertia_zz;

    /* crank1: inertia */
    const wreal coupler1_origin_inertia_zz_plus_crank1_base_inertia_zz = coupler1_origin_inertia_zz
        + crank1_base_inertia_zz;
    w[7] = coupler1_origin_inertia_zz_plus_crank1_base_inertia_zz;

    /* crank0: inertia */
    const wreal coupler0_origin_inertia_zz_plus_crank0_base_inertia_zz = coupler0_origin_inertia_zz
        + crank0_base_inertia_zz;
    w[8] = coupler0_origin_inertia_zz_plus_crank0_base_inertia_zz;

    /* parameters as they are */
    w[1] = p[14]; /* B0.position.x [m] */
    w[4] = p[19]; /* B1.position.x [m] */
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
    const real B0_q = q[3]; /* rad */
    const real B1_q = q[4]; /* rad */
    const real angle[CARDAN_PADDED(2)] = {B1_q, B0_q};
    real sine[CARDAN_PADDED(2)], cosine[CARDAN_PADDED(2)];
    cardan_sincos(2, angle, sine, cosine);
    const real B1_cos = cosine[0];
    const real B0_cos = cosine[1];

    /* shared by several: inertia */
    const wreal B0_position_x = w[1]; /* m */
    const wreal coupler0_first_moment_x = w[2];
    const wreal B1_position_x = w[4]; /* m */
    const wreal coupler1_first_moment_x = w[5];
    const real B1_position_x_times_crank1_inertia_mean_moment_x = coupler1_first_moment_x * B1_cos *
        B1_position_x;
    const real B0_position_x_times_crank0_inertia_mean_moment_x = coupler0_first_moment_x * B0_cos *
        B0_position_x;

    /* crank1: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal coupler1_origin_inertia_zz_plus_crank1_base_inertia_zz = w[7];
    /* M: A1.u,A1.u */
    out[6] = 2.0 * B1_position_x_times_crank1_inertia_mean_moment_x
        + coupler1_origin_inertia_zz_plus_crank1_base_inertia_zz;

    /* M */
    /* M = S . momentum */
    const wreal coupler0_origin_inertia_zz = w[3];
    const wreal coupler1_origin_inertia_zz = w[6];
    const real M_B1_A1 = coupler1_origin_inertia_zz
        + B1_position_x_times_crank1_inertia_mean_moment_x;
    const real M_B0_A0 = coupler0_origin_inertia_zz
        + B0_position_x_times_crank0_inertia_mean_moment_x;
    out[9] = M_B1_A1; /* M: A1.u,B1.u */
    out[21] = M_B1_A1; /* M: B1.u,A1.u */
    out[3] = M_B0_A0; /* M: A0.u,B0.u */
    out[15] = M_B0_A0; /* M: B0.u,A0.u */

    /* crank0: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal coupler0_origin_inertia_zz_plus_crank0_base_inertia_zz = w[8];
    /* M: A0.u,A0.u */
    out[0] = 2.0 * B0_position_x_times_crank0_inertia_mean_moment_x
        + coupler0_origin_inertia_zz_plus_crank0_base_inertia_zz;

    /* results that are numbers or inputs */
    out[12] = CARDAN_REAL(w[0]); /* M: A2.u,A2.u */
    out[18] = CARDAN_REAL(w[3]); /* M: B0.u,B0.u */
    out[24] = CARDAN_REAL(w[6]); /* M: B1.u,B1.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {25, 0, 9, 0, 5, 0, 0, 0, 0, 28, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
