/*
 * mass_matrix of andrews
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 49, work 0, w 13
 * Operations per call: 18 = 9 mul, 4 add, 2 sin, 2 sub, 1 cos
 * Operations of prepare: 42 = 26 mul, 16 add
 *
 * Input q (7): generalized coordinates
 *   q[0]  beta [rad]
 *   q[1]  theta [rad]
 *   q[2]  gamma [rad]
 *   q[3]  delta [rad]
 *   q[4]  phi [rad]
 *   q[5]  epsilon [rad]
 *   q[6]  omega [rad]
 *
 * Input p (58): parameters, read by prepare_ only
 *
 * Output M (7 x 7): out[0 ... 48], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* K1: first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal K1_mass = p[0]; /* kg */
    const wreal K1_com_x = p[1]; /* m */
    const wreal K1_inertia_zz = p[4]; /* kg m^2 */
    const wreal theta_position_x = p[5]; /* m */
    const wreal K2_mass = p[6]; /* kg */
    const wreal K1_first_moment_x = K1_mass * K1_com_x;
    const wreal K1_origin_inertia_zz = K1_inertia_zz + K1_com_x * K1_first_moment_x;
    const wreal K1_base_inertia_zz = K1_origin_inertia_zz
        + theta_position_x * K2_mass * theta_position_x;

    /* K2: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal K2_com_x = p[7]; /* m */
    const wreal K2_inertia_zz = p[10]; /* kg m^2 */
    const wreal K2_first_moment_x = K2_mass * K2_com_x;
    const wreal K2_origin_inertia_zz = K2_inertia_zz + K2_com_x * K2_first_moment_x;
    w[1] = K2_first_moment_x;
    w[2] = K2_origin_inertia_zz;

    /* K3: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal K3_mass = p[13]; /* kg */
    const wreal K3_com_x = p[14]; /* m */
    const wreal K3_com_y = p[15]; /* m */
    const wreal K3_inertia_zz = p[18]; /* kg m^2 */
    const wreal K3_first_moment_x = K3_mass * K3_com_x;
    const wreal K3_first_moment_y = K3_mass * K3_com_y;
    const wreal K3_origin_inertia_zz = K3_inertia_zz + K3_com_x * K3_first_moment_x
        + K3_com_y * K3_first_moment_y;
    w[3] = K3_origin_inertia_zz;

    /* K5: first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal K5_mass = p[21]; /* kg */
    const wreal K5_com_x = p[22]; /* m */
    const wreal K5_com_y = p[23]; /* m */
    const wreal K5_inertia_zz = p[26]; /* kg m^2 */
    const wreal phi_position_x = p[27]; /* m */
    const wreal K4_mass = p[28]; /* kg */
    const wreal K5_first_moment_x = K5_mass * K5_com_x;
    const wreal K5_first_moment_y = K5_mass * K5_com_y;
    const wreal K5_origin_inertia_zz = K5_inertia_zz + K5_com_x * K5_first_moment_x
        + K5_com_y * K5_first_moment_y;
    const wreal K5_base_inertia_zz = K5_origin_inertia_zz
        + phi_position_x * K4_mass * phi_position_x;

    /* K4: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal K4_com_y = p[29]; /* m */
    const wreal K4_inertia_zz = p[32]; /* kg m^2 */
    const wreal K4_first_moment_y = K4_mass * K4_com_y;
    const wreal K4_origin_inertia_zz = K4_inertia_zz + K4_com_y * K4_first_moment_y;
    w[5] = K4_first_moment_y;
    w[6] = K4_origin_inertia_zz;

    /* K7: first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal K7_mass = p[35]; /* kg */
    const wreal K7_com_x = p[36]; /* m */
    const wreal K7_com_y = p[37]; /* m */
    const wreal K7_inertia_zz = p[40]; /* kg m^2 */
    const wreal omega_position_y = p[41]; /* m */
    const wreal K6_mass = p[42]; /* kg */
    const wreal K7_first_moment_x = K7_mass * K7_com_x;
    const wreal K7_first_moment_y = K7_mass * K7_com_y;
    const wreal K7_origin_inertia_zz = K7_inertia_zz + K7_com_x * K7_first_moment_x
        + K7_com_y * K7_first_moment_y;
    const wreal K7_base_inertia_zz = K7_origin_inertia_zz
        + omega_position_y * K6_mass * omega_position_y;

    /* K6: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal K6_com_x = p[43]; /* m */
    const wreal K6_inertia_zz = p[46]; /* kg m^2 */
    const wreal K6_first_moment_x = K6_mass * K6_com_x;
    const wreal K6_origin_inertia_zz = K6_inertia_zz + K6_com_x * K6_first_moment_x;
    w[8] = K6_first_moment_x;
    w[9] = K6_origin_inertia_zz;

    /* K7: inertia */
    const wreal K6_origin_inertia_zz_plus_K7_base_inertia_zz = K6_origin_inertia_zz
        + K7_base_inertia_zz;
    w[10] = K6_origin_inertia_zz_plus_K7_base_inertia_zz;

    /* K5: inertia */
    const wreal K4_origin_inertia_zz_plus_K5_base_inertia_zz = K4_origin_inertia_zz
        + K5_base_inertia_zz;
    w[11] = K4_origin_inertia_zz_plus_K5_base_inertia_zz;

    /* K1: inertia */
    const wreal K2_origin_inertia_zz_plus_K1_base_inertia_zz = K2_origin_inertia_zz
        + K1_base_inertia_zz;
    w[12] = K2_origin_inertia_zz_plus_K1_base_inertia_zz;

    /* parameters as they are */
    w[0] = p[5]; /* theta.position.x [m] */
    w[4] = p[27]; /* phi.position.x [m] */
    w[7] = p[41]; /* omega.position.y [m] */
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
    memset(out + 2, 0, 45 * sizeof(real));

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
    const real theta_q = q[1]; /* rad */
    const real phi_q = q[4]; /* rad */
    const real omega_q = q[6]; /* rad */
    const real angle[CARDAN_PADDED(3)] = {omega_q, phi_q, theta_q};
    real sine[CARDAN_PADDED(3)], cosine[CARDAN_PADDED(3)];
    cardan_sincos(3, angle, sine, cosine);
    const real omega_sin = sine[0];
    const real phi_sin = sine[1];
    const real theta_cos = cosine[2];

    /* shared by several: inertia */
    const wreal theta_position_x = w[0]; /* m */
    const wreal K2_first_moment_x = w[1];
    const wreal phi_position_x = w[4]; /* m */
    const wreal K4_first_moment_y = w[5];
    const wreal omega_position_y = w[7]; /* m */
    const wreal K6_first_moment_x = w[8];
    const real omega_position_y_times_K7_inertia_mean_moment_y = K6_first_moment_x * omega_sin *
        omega_position_y;
    const real phi_position_x_times_K5_minus_inertia_mean_moment_x = K4_first_moment_y * phi_sin *
        phi_position_x;
    const real theta_position_x_times_K1_inertia_mean_moment_x = K2_first_moment_x * theta_cos *
        theta_position_x;

    /* K7: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal K6_origin_inertia_zz_plus_K7_base_inertia_zz = w[10];
    /* M: epsilon.u,epsilon.u */
    out[40] = 2.0 * omega_position_y_times_K7_inertia_mean_moment_y
        + K6_origin_inertia_zz_plus_K7_base_inertia_zz;

    /* M */
    /* M = S . momentum */
    const wreal K2_origin_inertia_zz = w[2];
    const wreal K4_origin_inertia_zz = w[6];
    const wreal K6_origin_inertia_zz = w[9];
    const real M_omega_epsilon = K6_origin_inertia_zz
        + omega_position_y_times_K7_inertia_mean_moment_y;
    const real M_phi_delta = K4_origin_inertia_zz
        - phi_position_x_times_K5_minus_inertia_mean_moment_x;
    const real M_theta_beta = K2_origin_inertia_zz
        + theta_position_x_times_K1_inertia_mean_moment_x;
    out[41] = M_omega_epsilon; /* M: epsilon.u,omega.u */
    out[47] = M_omega_epsilon; /* M: omega.u,epsilon.u */
    out[25] = M_phi_delta; /* M: delta.u,phi.u */
    out[31] = M_phi_delta; /* M: phi.u,delta.u */
    out[1] = M_theta_beta; /* M: beta.u,theta.u */
    out[7] = M_theta_beta; /* M: theta.u,beta.u */

    /* K5: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal K4_origin_inertia_zz_plus_K5_base_inertia_zz = w[11];
    /* M: delta.u,delta.u */
    out[24] = K4_origin_inertia_zz_plus_K5_base_inertia_zz
        - 2.0 * phi_position_x_times_K5_minus_inertia_mean_moment_x;

    /* K1: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal K2_origin_inertia_zz_plus_K1_base_inertia_zz = w[12];
    /* M: beta.u,beta.u */
    out[0] = 2.0 * theta_position_x_times_K1_inertia_mean_moment_x
        + K2_origin_inertia_zz_plus_K1_base_inertia_zz;

    /* results that are numbers or inputs */
    out[8] = CARDAN_REAL(w[2]); /* M: theta.u,theta.u */
    out[16] = CARDAN_REAL(w[3]); /* M: gamma.u,gamma.u */
    out[32] = CARDAN_REAL(w[6]); /* M: phi.u,phi.u */
    out[48] = CARDAN_REAL(w[9]); /* M: omega.u,omega.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {49, 0, 13, 0, 7, 0, 0, 0, 0, 58, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
