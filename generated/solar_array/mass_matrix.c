/*
 * mass_matrix of solar_array
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: parallel, base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 100, work 0, w 22
 * Operations per call: 259 = 131 mul, 87 add, 18 sub, 15 neg, 4 cos, 4 sin
 * Operations of prepare: 53 = 33 add, 16 mul, 4 sub
 *
 * Input q (11): generalized coordinates
 *   q[0]  drift.qw
 *   q[1]  drift.qx
 *   q[2]  drift.qy
 *   q[3]  drift.qz
 *   q[4]  drift.px [m]
 *   q[5]  drift.py [m]
 *   q[6]  drift.pz [m]
 *   q[7]  hinge0 [rad]
 *   q[8]  hinge1 [rad]
 *   q[9]  hinge2 [rad]
 *   q[10]  hinge3 [rad]
 *
 * Input p (30): parameters, read by prepare_ only
 *
 * Output M (10 x 10): out[0 ... 99], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* panel0: first moment, mass, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal panel0_mass = p[5]; /* kg */
    const wreal panel0_com_x = p[6]; /* m */
    const wreal panel0_inertia_yy = p[8]; /* kg m^2 */
    const wreal panel0_inertia_zz = p[9]; /* kg m^2 */
    const wreal panel0_first_moment_x = panel0_mass * panel0_com_x;
    const wreal panel0_com_x_times_first_moment_x = panel0_com_x * panel0_first_moment_x;
    const wreal panel0_origin_inertia_yy = panel0_inertia_yy + panel0_com_x_times_first_moment_x;
    const wreal panel0_origin_inertia_zz = panel0_inertia_zz + panel0_com_x_times_first_moment_x;

    /* panel1: first moment, mass, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal panel1_mass = p[11]; /* kg */
    const wreal panel1_com_x = p[12]; /* m */
    const wreal panel1_inertia_yy = p[14]; /* kg m^2 */
    const wreal panel1_inertia_zz = p[15]; /* kg m^2 */
    const wreal panel1_first_moment_x = panel1_mass * panel1_com_x;
    const wreal panel1_com_x_times_first_moment_x = panel1_com_x * panel1_first_moment_x;
    const wreal panel1_origin_inertia_yy = panel1_inertia_yy + panel1_com_x_times_first_moment_x;
    const wreal panel1_origin_inertia_zz = panel1_inertia_zz + panel1_com_x_times_first_moment_x;

    /* panel2: first moment, mass, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal panel2_mass = p[17]; /* kg */
    const wreal panel2_com_x = p[18]; /* m */
    const wreal panel2_inertia_yy = p[20]; /* kg m^2 */
    const wreal panel2_inertia_zz = p[21]; /* kg m^2 */
    const wreal panel2_first_moment_x = panel2_mass * panel2_com_x;
    const wreal panel2_com_x_times_first_moment_x = panel2_com_x * panel2_first_moment_x;
    const wreal panel2_origin_inertia_yy = panel2_inertia_yy + panel2_com_x_times_first_moment_x;
    const wreal panel2_origin_inertia_zz = panel2_inertia_zz + panel2_com_x_times_first_moment_x;

    /* panel3: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal panel2_inertia_xx = p[19]; /* kg m^2 */
    const wreal hinge3_position_x = p[22]; /* m */
    const wreal panel3_mass = p[23]; /* kg */
    const wreal panel3_com_x = p[24]; /* m */
    const wreal panel3_inertia_xx = p[25]; /* kg m^2 */
    const wreal panel3_inertia_yy = p[26]; /* kg m^2 */
    const wreal panel3_inertia_zz = p[27]; /* kg m^2 */
    const wreal panel3_first_moment_x = panel3_mass * panel3_com_x;
    const wreal panel3_com_x_times_first_moment_x = panel3_com_x * panel3_first_moment_x;
    const wreal panel3_origin_inertia_yy = panel3_inertia_yy + panel3_com_x_times_first_moment_x;
    const wreal panel3_origin_inertia_zz = panel3_inertia_zz + panel3_com_x_times_first_moment_x;
    const wreal panel3_base_inertia_zz = panel3_origin_inertia_zz - panel3_inertia_xx;
    const wreal panel3_base_mass_moment_x = hinge3_position_x * panel3_mass;
    const wreal panel3_base_inertia_yy = hinge3_position_x * panel3_base_mass_moment_x;
    const wreal panel2_mass_plus_panel3_mass = panel2_mass + panel3_mass;
    const wreal panel2_base_inertia_xx = panel2_inertia_xx + panel3_inertia_xx;
    w[4] = panel3_first_moment_x;
    w[5] = panel3_origin_inertia_yy;
    w[6] = panel3_base_inertia_zz;

    /* panel2: base, inertia */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal panel1_inertia_xx = p[13]; /* kg m^2 */
    const wreal hinge2_position_x = p[16]; /* m */
    const wreal panel2_base_moment_x = panel2_first_moment_x + panel3_base_mass_moment_x;
    const wreal panel2_base_inertia_yy = panel2_origin_inertia_yy + panel3_base_inertia_yy;
    const wreal panel2_base_inertia_zz = panel2_origin_inertia_zz + panel3_inertia_xx
        + (panel3_base_inertia_yy - panel2_base_inertia_xx);
    const wreal panel2_base_mass_moment_x = hinge2_position_x * panel2_mass_plus_panel3_mass;
    const wreal panel2_base_inertia_yy_2 = hinge2_position_x * panel2_base_mass_moment_x;
    const wreal panel1_mass_plus_panel2_mass_plus_panel3_mass = panel1_mass
        + panel2_mass_plus_panel3_mass;
    const wreal panel1_base_inertia_xx = panel1_inertia_xx + panel2_base_inertia_xx;
    const wreal panel3_origin_inertia_yy_plus_panel2_base_inertia_yy = panel3_origin_inertia_yy
        + panel2_base_inertia_yy;
    const wreal panel3_base_inertia_zz_plus_panel2_base_inertia_zz = panel3_base_inertia_zz
        + panel2_base_inertia_zz;
    w[7] = panel2_base_moment_x;
    w[8] = panel2_base_inertia_zz;
    w[20] = panel3_origin_inertia_yy_plus_panel2_base_inertia_yy;
    w[21] = panel3_base_inertia_zz_plus_panel2_base_inertia_zz;

    /* panel1: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal panel0_inertia_xx = p[7]; /* kg m^2 */
    const wreal hinge1_position_x = p[10]; /* m */
    const wreal panel1_base_moment_x = panel1_first_moment_x + panel2_base_mass_moment_x;
    const wreal panel1_base_inertia_yy = panel1_origin_inertia_yy + panel2_base_inertia_yy_2;
    const wreal panel1_base_inertia_zz = panel1_origin_inertia_zz + panel2_base_inertia_xx
        + (panel2_base_inertia_yy_2 - panel1_base_inertia_xx);
    const wreal panel1_base_mass_moment_x = hinge1_position_x *
        panel1_mass_plus_panel2_mass_plus_panel3_mass;
    const wreal panel1_base_inertia_yy_2 = hinge1_position_x * panel1_base_mass_moment_x;
    const wreal hub_base_moment_x_part = panel0_mass
        + panel1_mass_plus_panel2_mass_plus_panel3_mass;
    const wreal panel0_base_inertia_xx = panel0_inertia_xx + panel1_base_inertia_xx;
    w[9] = panel1_base_moment_x;
    w[10] = panel1_base_inertia_yy;
    w[11] = panel1_base_inertia_zz;

    /* panel0: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal panel0_base_moment_x = panel0_first_moment_x + panel1_base_mass_moment_x;
    const wreal panel0_base_inertia_yy = panel0_origin_inertia_yy + panel1_base_inertia_yy_2;
    const wreal panel0_base_inertia_zz = panel0_origin_inertia_zz + panel1_base_inertia_xx
        + (panel1_base_inertia_yy_2 - panel0_base_inertia_xx);
    w[12] = panel0_base_moment_x;
    w[13] = panel0_base_inertia_yy;
    w[14] = panel0_base_inertia_zz;

    /* hub: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal hub_mass = p[0]; /* kg */
    const wreal hub_inertia_xx = p[1]; /* kg m^2 */
    const wreal hinge0_position_x = p[4]; /* m */
    const wreal hub_base_moment_x = hinge0_position_x * hub_base_moment_x_part;
    const wreal hub_base_mass = hub_mass + hub_base_moment_x_part;
    const wreal hub_base_inertia_xx = hub_inertia_xx + panel0_base_inertia_xx;
    w[15] = hub_base_moment_x;
    w[16] = hub_base_mass;
    w[17] = hub_base_inertia_xx;

    /* panel0: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal panel0_base_inertia_yy_2 = hinge0_position_x * hub_base_moment_x;

    /* hub: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal hub_inertia_yy = p[2]; /* kg m^2 */
    const wreal hub_inertia_zz = p[3]; /* kg m^2 */
    const wreal hub_base_inertia_yy = hub_inertia_yy + panel0_base_inertia_yy_2;
    const wreal hub_base_inertia_zz = hub_inertia_zz + panel0_base_inertia_xx
        + panel0_base_inertia_yy_2;
    w[18] = hub_base_inertia_yy;
    w[19] = hub_base_inertia_zz;

    /* parameters as they are */
    w[0] = p[4]; /* hinge0.position.x [m] */
    w[1] = p[10]; /* hinge1.position.x [m] */
    w[2] = p[16]; /* hinge2.position.x [m] */
    w[3] = p[22]; /* hinge3.position.x [m] */
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
    memset(out + 1, 0, 92 * sizeof(real));

    /* shared by several: turn, R */
    /* turn = sum of their angles */
    /* R = R_fixed R_joint(q) */
    const real hinge0_q = q[7]; /* rad */
    const real hinge1_q = q[8]; /* rad */
    const real hinge2_q = q[9]; /* rad */
    const real hinge3_q = q[10]; /* rad */
    const real hinge1_turn = hinge0_q + hinge1_q;
    const real hinge2_turn = hinge2_q + hinge1_turn;
    const real hinge3_turn = hinge3_q + hinge2_turn;
    const real angle[CARDAN_PADDED(4)] = {hinge0_q, hinge1_turn, hinge2_turn, hinge3_turn};
    real sine[CARDAN_PADDED(4)], cosine[CARDAN_PADDED(4)];
    cardan_sincos(4, angle, sine, cosine);
    const real hinge0_cos = cosine[0];
    const real hinge0_sin = sine[0];
    const real hinge1_turn_cos = cosine[1];
    const real hinge1_turn_sin = sine[1];
    const real hinge2_turn_cos = cosine[2];
    const real hinge2_turn_sin = sine[2];
    const real hinge3_turn_cos = cosine[3];
    const real hinge3_turn_sin = sine[3];

    /* panel0: turned */
    /* turned = R(turn) inertia R(turn)ᵀ */
    const wreal panel0_base_inertia_zz = w[14];
    const real panel0_turned_shear = panel0_base_inertia_zz * hinge0_sin;
    const real hinge0_sin_times_panel0_turned_shear = hinge0_sin * panel0_turned_shear;

    /* hinge1: p */
    /* p = p_fixed + R_fixed p_joint(q) */
    const wreal hinge1_position_x = w[1]; /* m */
    const real hinge1_p_x = hinge1_position_x * hinge0_cos;
    const real hinge1_minus_p_z = hinge1_position_x * hinge0_sin;

    /* panel1: turned */
    /* turned = R(turn) inertia R(turn)ᵀ */
    const wreal panel1_base_inertia_zz = w[11];
    const real panel1_turned_shear = panel1_base_inertia_zz * hinge1_turn_sin;
    const real hinge1_turn_sin_times_panel1_turned_shear = hinge1_turn_sin * panel1_turned_shear;

    /* hinge2: p */
    /* p = p_fixed + R_fixed p_joint(q) */
    const wreal hinge2_position_x = w[2]; /* m */
    const real hinge2_p_x = hinge2_position_x * hinge1_turn_cos;
    const real hinge2_minus_p_z = hinge2_position_x * hinge1_turn_sin;

    /* panel2: turned, inertia */
    /* turned = R(turn) inertia R(turn)ᵀ */
    const wreal panel3_base_inertia_zz = w[6];
    const wreal panel2_base_inertia_zz = w[8];
    const real panel2_turned_shear = panel2_base_inertia_zz * hinge2_turn_sin;
    const real hinge2_turn_sin_times_panel2_turned_shear = hinge2_turn_sin * panel2_turned_shear;
    const real panel2_inertia_shear = panel3_base_inertia_zz * hinge3_turn_sin;
    const real hinge3_turn_sin_times_panel2_inertia_shear = hinge3_turn_sin * panel2_inertia_shear;

    /* hinge3: p */
    /* p = p_fixed + R_fixed p_joint(q) */
    const wreal hinge3_position_x = w[3]; /* m */
    const real hinge3_p_x = hinge3_position_x * hinge2_turn_cos;
    const real hinge3_minus_p_z = hinge3_position_x * hinge2_turn_sin;

    /* shared by several: inertia */
    const wreal panel3_first_moment_x = w[4];
    const real panel2_inertia_mean_moment_x = panel3_first_moment_x * hinge3_turn_cos;
    const real panel2_minus_inertia_mean_moment_z = panel3_first_moment_x * hinge3_turn_sin;
    const real hinge3_p_x_times_panel2_inertia_mean_moment_x = hinge3_p_x *
        panel2_inertia_mean_moment_x;
    const real hinge3_minus_p_z_times_panel2_minus_inertia_mean_moment_z = hinge3_minus_p_z *
        panel2_minus_inertia_mean_moment_z;
    const real panel2_inertia_shift_part = hinge3_p_x_times_panel2_inertia_mean_moment_x
        + hinge3_minus_p_z_times_panel2_minus_inertia_mean_moment_z;

    /* panel2: composite, inertia */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal panel2_base_moment_x = w[7];
    const wreal panel3_origin_inertia_yy_plus_panel2_base_inertia_yy = w[20];
    const wreal panel3_base_inertia_zz_plus_panel2_base_inertia_zz = w[21];
    const real panel2_composite_moment_x = panel2_base_moment_x * hinge2_turn_cos
        + panel2_inertia_mean_moment_x;
    const real panel2_minus_composite_moment_z = panel2_base_moment_x * hinge2_turn_sin
        + panel2_minus_inertia_mean_moment_z;
    const real panel2_composite_inertia_xz = hinge2_turn_cos * panel2_turned_shear
        + hinge3_turn_cos * panel2_inertia_shear
        + (hinge3_minus_p_z * panel2_inertia_mean_moment_x
        + hinge3_p_x * panel2_minus_inertia_mean_moment_z);
    const real panel2_inertia_shift = 2.0 * panel2_inertia_shift_part;
    const real panel2_composite_inertia_xx = hinge2_turn_sin_times_panel2_turned_shear
        + hinge3_turn_sin_times_panel2_inertia_shear
        - 2.0 * hinge3_p_x_times_panel2_inertia_mean_moment_x + panel2_inertia_shift;
    const real panel2_composite_inertia_zz = panel3_base_inertia_zz_plus_panel2_base_inertia_zz
        - hinge2_turn_sin_times_panel2_turned_shear - hinge3_turn_sin_times_panel2_inertia_shear
        - 2.0 * hinge3_minus_p_z_times_panel2_minus_inertia_mean_moment_z + panel2_inertia_shift;
    const real panel2_composite_inertia_yy = panel2_inertia_shift
        + panel3_origin_inertia_yy_plus_panel2_base_inertia_yy;
    out[88] = panel2_composite_inertia_yy; /* M: hinge2.u,hinge2.u */

    /* panel1: composite, inertia */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal panel1_base_moment_x = w[9];
    const real panel1_composite_moment_x = panel1_base_moment_x * hinge1_turn_cos
        + panel2_composite_moment_x;
    const real panel1_minus_composite_moment_z = panel1_base_moment_x * hinge1_turn_sin
        + panel2_minus_composite_moment_z;
    const real panel1_composite_inertia_xz = hinge1_turn_cos * panel1_turned_shear
        + panel2_composite_moment_x * hinge2_minus_p_z + (panel2_composite_inertia_xz
        + panel2_minus_composite_moment_z * hinge2_p_x);

    /* panel0: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal panel0_base_moment_x = w[12];
    const real panel0_composite_moment_x = panel0_base_moment_x * hinge0_cos
        + panel1_composite_moment_x;
    const real panel0_composite_inertia_xz = hinge0_cos * panel0_turned_shear
        + panel1_composite_moment_x * hinge1_minus_p_z
        + panel1_minus_composite_moment_z * hinge1_p_x + panel1_composite_inertia_xz;

    /* momentum */
    /* momentum = composite inertia S */
    const real momentum_drift_x_fy = panel0_base_moment_x * hinge0_sin
        + panel1_minus_composite_moment_z;

    /* M */
    /* M = S . momentum */
    const wreal hinge0_position_x = w[0]; /* m */
    const wreal panel3_origin_inertia_yy = w[5];
    const real M_hinge3_hinge2 = panel3_origin_inertia_yy + panel2_inertia_shift_part;
    const real M_hinge3_hinge1 = panel2_minus_inertia_mean_moment_z * hinge2_minus_p_z
        + panel2_inertia_mean_moment_x * hinge2_p_x + M_hinge3_hinge2;
    const real M_hinge3_hinge0 = panel2_minus_inertia_mean_moment_z * hinge1_minus_p_z
        + panel2_inertia_mean_moment_x * hinge1_p_x + M_hinge3_hinge1;
    const real M_hinge3_drift_y = M_hinge3_hinge0
        + hinge0_position_x * panel2_inertia_mean_moment_x;
    out[89] = M_hinge3_hinge2; /* M: hinge2.u,hinge3.u */
    out[98] = M_hinge3_hinge2; /* M: hinge3.u,hinge2.u */
    out[79] = M_hinge3_hinge1; /* M: hinge1.u,hinge3.u */
    out[97] = M_hinge3_hinge1; /* M: hinge3.u,hinge1.u */
    out[69] = M_hinge3_hinge0; /* M: hinge0.u,hinge3.u */
    out[96] = M_hinge3_hinge0; /* M: hinge3.u,hinge0.u */
    out[19] = M_hinge3_drift_y; /* M: drift.u.y,hinge3.u */
    out[91] = M_hinge3_drift_y; /* M: hinge3.u,drift.u.y */

    /* shared by several: inertia */
    const real panel2_composite_moment_x_times_hinge2_p_x = panel2_composite_moment_x * hinge2_p_x;
    const real panel2_minus_composite_moment_z_times_hinge2_minus_p_z =
        panel2_minus_composite_moment_z * hinge2_minus_p_z;
    const real panel1_inertia_shift_part = panel2_composite_moment_x_times_hinge2_p_x
        + panel2_minus_composite_moment_z_times_hinge2_minus_p_z;
    const real panel1_composite_moment_x_times_hinge1_p_x = panel1_composite_moment_x * hinge1_p_x;
    const real panel1_minus_composite_moment_z_times_hinge1_minus_p_z =
        panel1_minus_composite_moment_z * hinge1_minus_p_z;
    const real panel0_inertia_shift_part = panel1_composite_moment_x_times_hinge1_p_x
        + panel1_minus_composite_moment_z_times_hinge1_minus_p_z;
    const real hinge0_position_x_times_panel0_composite_moment_x = hinge0_position_x *
        panel0_composite_moment_x;

    /* panel1: inertia, composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal panel1_base_inertia_yy = w[10];
    const real panel1_inertia_shift = 2.0 * panel1_inertia_shift_part;
    const real panel1_composite_inertia_xx = hinge1_turn_sin_times_panel1_turned_shear
        - 2.0 * panel2_composite_moment_x_times_hinge2_p_x + (panel2_composite_inertia_xx
        + panel1_inertia_shift);
    const real panel1_composite_inertia_zz = panel1_base_inertia_zz
        - hinge1_turn_sin_times_panel1_turned_shear
        - 2.0 * panel2_minus_composite_moment_z_times_hinge2_minus_p_z
        + (panel2_composite_inertia_zz + panel1_inertia_shift);
    const real panel1_composite_inertia_yy = panel1_base_inertia_yy + panel2_composite_inertia_yy
        + panel1_inertia_shift;
    out[77] = panel1_composite_inertia_yy; /* M: hinge1.u,hinge1.u */

    /* M */
    /* M = S . momentum */
    const real M_hinge2_hinge1 = panel2_composite_inertia_yy + panel1_inertia_shift_part;
    const real M_hinge1_hinge0 = panel1_composite_inertia_yy + panel0_inertia_shift_part;
    const real M_hinge2_hinge0 = panel2_minus_composite_moment_z * hinge1_minus_p_z
        + panel2_composite_moment_x * hinge1_p_x + M_hinge2_hinge1;
    const real M_hinge2_drift_y = M_hinge2_hinge0 + hinge0_position_x * panel2_composite_moment_x;
    const real M_hinge1_drift_y = M_hinge1_hinge0 + hinge0_position_x * panel1_composite_moment_x;
    out[78] = M_hinge2_hinge1; /* M: hinge1.u,hinge2.u */
    out[87] = M_hinge2_hinge1; /* M: hinge2.u,hinge1.u */
    out[67] = M_hinge1_hinge0; /* M: hinge0.u,hinge1.u */
    out[76] = M_hinge1_hinge0; /* M: hinge1.u,hinge0.u */
    out[68] = M_hinge2_hinge0; /* M: hinge0.u,hinge2.u */
    out[86] = M_hinge2_hinge0; /* M: hinge2.u,hinge0.u */
    out[18] = M_hinge2_drift_y; /* M: drift.u.y,hinge2.u */
    out[81] = M_hinge2_drift_y; /* M: hinge2.u,drift.u.y */
    out[17] = M_hinge1_drift_y; /* M: drift.u.y,hinge1.u */
    out[71] = M_hinge1_drift_y; /* M: hinge1.u,drift.u.y */

    /* panel0: inertia, composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal panel0_base_inertia_yy = w[13];
    const real panel0_inertia_shift = 2.0 * panel0_inertia_shift_part;
    const real panel0_composite_inertia_xx = hinge0_sin_times_panel0_turned_shear
        - 2.0 * panel1_composite_moment_x_times_hinge1_p_x + panel0_inertia_shift
        + panel1_composite_inertia_xx;
    const real panel0_composite_inertia_zz = panel0_base_inertia_zz
        - hinge0_sin_times_panel0_turned_shear
        - 2.0 * panel1_minus_composite_moment_z_times_hinge1_minus_p_z + panel0_inertia_shift
        + panel1_composite_inertia_zz;
    const real panel0_composite_inertia_yy = panel0_base_inertia_yy + panel0_inertia_shift
        + panel1_composite_inertia_yy;
    out[66] = panel0_composite_inertia_yy; /* M: hinge0.u,hinge0.u */

    /* hub: composite, inertia */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal hub_base_moment_x = w[15];
    const wreal hub_base_inertia_xx = w[17];
    const wreal hub_base_inertia_yy = w[18];
    const wreal hub_base_inertia_zz = w[19];
    const real hub_inertia_shift = 2.0 * hinge0_position_x_times_panel0_composite_moment_x;
    const real hub_composite_inertia_xz = panel0_composite_inertia_xz
        + hinge0_position_x * momentum_drift_x_fy;
    const real hub_composite_moment_x = hub_base_moment_x + panel0_composite_moment_x;
    out[0] = hub_base_inertia_xx + panel0_composite_inertia_xx; /* M: drift.u.x,drift.u.x */
    out[2] = hub_composite_inertia_xz; /* M: drift.u.x,drift.u.z */
    out[20] = hub_composite_inertia_xz; /* M: drift.u.z,drift.u.x */
    /* M: drift.u.y,drift.u.y */
    out[11] = hub_base_inertia_yy + hub_inertia_shift + panel0_composite_inertia_yy;
    /* M: drift.u.z,drift.u.z */
    out[22] = hub_base_inertia_zz + hub_inertia_shift + panel0_composite_inertia_zz;

    /* M */
    /* M = S . momentum */
    const real M_hinge0_drift_y = panel0_composite_inertia_yy
        + hinge0_position_x_times_panel0_composite_moment_x;
    out[16] = M_hinge0_drift_y; /* M: drift.u.y,hinge0.u */
    out[61] = M_hinge0_drift_y; /* M: hinge0.u,drift.u.y */

    /* drift: R */
    /* R = R_fixed R_joint(q) */
    const real drift_qw = q[0];
    const real drift_qx = q[1];
    const real drift_qy = q[2];
    const real drift_qz = q[3];
    const real twice_drift_qx = 2.0 * drift_qx;
    const real twice_drift_qy = 2.0 * drift_qy;
    const real twice_drift_qz = 2.0 * drift_qz;
    const real drift_qw_times_twice_drift_qx = drift_qw * twice_drift_qx;
    const real one_minus_drift_qx_times_twice_drift_qx = 1.0 - drift_qx * twice_drift_qx;
    const real drift_qw_times_twice_drift_qy = drift_qw * twice_drift_qy;
    const real drift_qw_times_twice_drift_qz = drift_qw * twice_drift_qz;
    const real drift_qx_times_twice_drift_qy = drift_qx * twice_drift_qy;
    const real drift_qy_times_twice_drift_qy = drift_qy * twice_drift_qy;
    const real drift_qx_times_twice_drift_qz = drift_qx * twice_drift_qz;
    const real drift_qy_times_twice_drift_qz = drift_qy * twice_drift_qz;
    const real drift_qz_times_twice_drift_qz = drift_qz * twice_drift_qz;
    const real drift_R_xx = 1.0 - drift_qy_times_twice_drift_qy - drift_qz_times_twice_drift_qz;
    const real drift_R_yy = one_minus_drift_qx_times_twice_drift_qx - drift_qz_times_twice_drift_qz;
    const real drift_R_zz = one_minus_drift_qx_times_twice_drift_qx - drift_qy_times_twice_drift_qy;
    const real drift_R_xy = drift_qx_times_twice_drift_qy - drift_qw_times_twice_drift_qz;
    const real drift_R_yx = drift_qw_times_twice_drift_qz + drift_qx_times_twice_drift_qy;
    const real drift_R_xz = drift_qw_times_twice_drift_qy + drift_qx_times_twice_drift_qz;
    const real drift_R_zx = drift_qx_times_twice_drift_qz - drift_qw_times_twice_drift_qy;
    const real drift_R_yz = drift_qy_times_twice_drift_qz - drift_qw_times_twice_drift_qx;
    const real drift_R_zy = drift_qw_times_twice_drift_qx + drift_qy_times_twice_drift_qz;

    /* shared by several: momentum, M */
    /* momentum = composite inertia S */
    /* M = S . momentum */
    const real momentum_hinge3_about_ground_fx = -(panel2_minus_inertia_mean_moment_z * drift_R_xx +
        panel2_inertia_mean_moment_x * drift_R_xz);
    const real momentum_hinge3_about_ground_fy = -(panel2_minus_inertia_mean_moment_z * drift_R_yx +
        panel2_inertia_mean_moment_x * drift_R_yz);
    const real momentum_hinge3_about_ground_fz = -(panel2_minus_inertia_mean_moment_z * drift_R_zx +
        panel2_inertia_mean_moment_x * drift_R_zz);
    const real momentum_hinge2_about_ground_fx = -(panel2_minus_composite_moment_z * drift_R_xx
        + panel2_composite_moment_x * drift_R_xz);
    const real momentum_hinge2_about_ground_fy = -(panel2_minus_composite_moment_z * drift_R_yx
        + panel2_composite_moment_x * drift_R_yz);
    const real momentum_hinge2_about_ground_fz = -(panel2_minus_composite_moment_z * drift_R_zx
        + panel2_composite_moment_x * drift_R_zz);
    const real momentum_hinge1_about_ground_fx = -(panel1_minus_composite_moment_z * drift_R_xx
        + panel1_composite_moment_x * drift_R_xz);
    const real momentum_hinge1_about_ground_fy = -(panel1_minus_composite_moment_z * drift_R_yx
        + panel1_composite_moment_x * drift_R_yz);
    const real momentum_hinge1_about_ground_fz = -(panel1_minus_composite_moment_z * drift_R_zx
        + panel1_composite_moment_x * drift_R_zz);
    const real momentum_drift_x_fy_times_drift_R_xx = momentum_drift_x_fy * drift_R_xx;
    const real momentum_hinge0_about_ground_fx = -(momentum_drift_x_fy_times_drift_R_xx
        + panel0_composite_moment_x * drift_R_xz);
    const real momentum_drift_x_fy_times_drift_R_yx = momentum_drift_x_fy * drift_R_yx;
    const real momentum_hinge0_about_ground_fy = -(momentum_drift_x_fy_times_drift_R_yx
        + panel0_composite_moment_x * drift_R_yz);
    const real momentum_drift_x_fy_times_drift_R_zx = momentum_drift_x_fy * drift_R_zx;
    const real momentum_hinge0_about_ground_fz = -(momentum_drift_x_fy_times_drift_R_zx
        + panel0_composite_moment_x * drift_R_zz);
    const real momentum_drift_y_about_ground_fx = -(momentum_drift_x_fy_times_drift_R_xx
        + hub_composite_moment_x * drift_R_xz);
    const real momentum_drift_y_about_ground_fy = -(momentum_drift_x_fy_times_drift_R_yx
        + hub_composite_moment_x * drift_R_yz);
    const real momentum_drift_y_about_ground_fz = -(momentum_drift_x_fy_times_drift_R_zx
        + hub_composite_moment_x * drift_R_zz);
    out[39] = momentum_hinge3_about_ground_fx; /* M: drift.u.px,hinge3.u */
    out[93] = momentum_hinge3_about_ground_fx; /* M: hinge3.u,drift.u.px */
    out[49] = momentum_hinge3_about_ground_fy; /* M: drift.u.py,hinge3.u */
    out[94] = momentum_hinge3_about_ground_fy; /* M: hinge3.u,drift.u.py */
    out[59] = momentum_hinge3_about_ground_fz; /* M: drift.u.pz,hinge3.u */
    out[95] = momentum_hinge3_about_ground_fz; /* M: hinge3.u,drift.u.pz */
    out[38] = momentum_hinge2_about_ground_fx; /* M: drift.u.px,hinge2.u */
    out[83] = momentum_hinge2_about_ground_fx; /* M: hinge2.u,drift.u.px */
    out[48] = momentum_hinge2_about_ground_fy; /* M: drift.u.py,hinge2.u */
    out[84] = momentum_hinge2_about_ground_fy; /* M: hinge2.u,drift.u.py */
    out[58] = momentum_hinge2_about_ground_fz; /* M: drift.u.pz,hinge2.u */
    out[85] = momentum_hinge2_about_ground_fz; /* M: hinge2.u,drift.u.pz */
    out[37] = momentum_hinge1_about_ground_fx; /* M: drift.u.px,hinge1.u */
    out[73] = momentum_hinge1_about_ground_fx; /* M: hinge1.u,drift.u.px */
    out[47] = momentum_hinge1_about_ground_fy; /* M: drift.u.py,hinge1.u */
    out[74] = momentum_hinge1_about_ground_fy; /* M: hinge1.u,drift.u.py */
    out[57] = momentum_hinge1_about_ground_fz; /* M: drift.u.pz,hinge1.u */
    out[75] = momentum_hinge1_about_ground_fz; /* M: hinge1.u,drift.u.pz */
    out[36] = momentum_hinge0_about_ground_fx; /* M: drift.u.px,hinge0.u */
    out[63] = momentum_hinge0_about_ground_fx; /* M: hinge0.u,drift.u.px */
    out[46] = momentum_hinge0_about_ground_fy; /* M: drift.u.py,hinge0.u */
    out[64] = momentum_hinge0_about_ground_fy; /* M: hinge0.u,drift.u.py */
    out[56] = momentum_hinge0_about_ground_fz; /* M: drift.u.pz,hinge0.u */
    out[65] = momentum_hinge0_about_ground_fz; /* M: hinge0.u,drift.u.pz */
    out[13] = momentum_drift_y_about_ground_fx; /* M: drift.u.y,drift.u.px */
    out[31] = momentum_drift_y_about_ground_fx; /* M: drift.u.px,drift.u.y */
    out[14] = momentum_drift_y_about_ground_fy; /* M: drift.u.y,drift.u.py */
    out[41] = momentum_drift_y_about_ground_fy; /* M: drift.u.py,drift.u.y */
    out[15] = momentum_drift_y_about_ground_fz; /* M: drift.u.y,drift.u.pz */
    out[51] = momentum_drift_y_about_ground_fz; /* M: drift.u.pz,drift.u.y */

    /* momentum */
    /* momentum = composite inertia S */
    const wreal hub_base_mass = w[16];
    const real momentum_drift_px_mx = momentum_drift_x_fy * drift_R_xy;
    const real momentum_drift_py_mx = momentum_drift_x_fy * drift_R_yy;
    const real momentum_drift_pz_mx = momentum_drift_x_fy * drift_R_zy;
    const real momentum_drift_px_mz = hub_composite_moment_x * drift_R_xy;
    const real momentum_drift_py_mz = hub_composite_moment_x * drift_R_yy;
    const real momentum_drift_pz_mz = hub_composite_moment_x * drift_R_zy;
    const real momentum_drift_px_fx = hub_base_mass * drift_R_xx;
    const real momentum_drift_px_fy = hub_base_mass * drift_R_xy;
    const real momentum_drift_px_fz = hub_base_mass * drift_R_xz;
    const real momentum_drift_py_fx = hub_base_mass * drift_R_yx;
    const real momentum_drift_py_fy = hub_base_mass * drift_R_yy;
    const real momentum_drift_py_fz = hub_base_mass * drift_R_yz;
    const real momentum_drift_pz_fx = hub_base_mass * drift_R_zx;
    const real momentum_drift_pz_fy = hub_base_mass * drift_R_zy;
    const real momentum_drift_pz_fz = hub_base_mass * drift_R_zz;
    out[3] = momentum_drift_px_mx; /* M: drift.u.x,drift.u.px */
    out[30] = momentum_drift_px_mx; /* M: drift.u.px,drift.u.x */
    out[4] = momentum_drift_py_mx; /* M: drift.u.x,drift.u.py */
    out[40] = momentum_drift_py_mx; /* M: drift.u.py,drift.u.x */
    out[5] = momentum_drift_pz_mx; /* M: drift.u.x,drift.u.pz */
    out[50] = momentum_drift_pz_mx; /* M: drift.u.pz,drift.u.x */
    out[23] = momentum_drift_px_mz; /* M: drift.u.z,drift.u.px */
    out[32] = momentum_drift_px_mz; /* M: drift.u.px,drift.u.z */
    out[24] = momentum_drift_py_mz; /* M: drift.u.z,drift.u.py */
    out[42] = momentum_drift_py_mz; /* M: drift.u.py,drift.u.z */
    out[25] = momentum_drift_pz_mz; /* M: drift.u.z,drift.u.pz */
    out[52] = momentum_drift_pz_mz; /* M: drift.u.pz,drift.u.z */

    /* M */
    /* M = S . momentum */
    const real M_drift_py_drift_px = drift_R_xx * momentum_drift_py_fx
        + drift_R_xz * momentum_drift_py_fz + drift_R_xy * momentum_drift_py_fy;
    const real M_drift_pz_drift_px = drift_R_xx * momentum_drift_pz_fx
        + drift_R_xy * momentum_drift_pz_fy + drift_R_xz * momentum_drift_pz_fz;
    const real M_drift_pz_drift_py = drift_R_yx * momentum_drift_pz_fx
        + drift_R_yy * momentum_drift_pz_fy + drift_R_yz * momentum_drift_pz_fz;
    /* M: drift.u.px,drift.u.px */
    out[33] = drift_R_xy * momentum_drift_px_fy + drift_R_xz * momentum_drift_px_fz
        + drift_R_xx * momentum_drift_px_fx;
    out[34] = M_drift_py_drift_px; /* M: drift.u.px,drift.u.py */
    out[43] = M_drift_py_drift_px; /* M: drift.u.py,drift.u.px */
    /* M: drift.u.py,drift.u.py */
    out[44] = drift_R_yx * momentum_drift_py_fx + drift_R_yz * momentum_drift_py_fz
        + drift_R_yy * momentum_drift_py_fy;
    out[35] = M_drift_pz_drift_px; /* M: drift.u.px,drift.u.pz */
    out[53] = M_drift_pz_drift_px; /* M: drift.u.pz,drift.u.px */
    out[45] = M_drift_pz_drift_py; /* M: drift.u.py,drift.u.pz */
    out[54] = M_drift_pz_drift_py; /* M: drift.u.pz,drift.u.py */
    /* M: drift.u.pz,drift.u.pz */
    out[55] = drift_R_zx * momentum_drift_pz_fx + drift_R_zy * momentum_drift_pz_fy
        + drift_R_zz * momentum_drift_pz_fz;

    /* results that are numbers or inputs */
    out[99] = CARDAN_REAL(w[5]); /* M: hinge3.u,hinge3.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {100, 0, 22, 0, 11, 0, 0, 0, 0, 30, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
