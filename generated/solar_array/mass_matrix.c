/*
 * mass_matrix of solar_array
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: parallel, base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 100, work 0, w 22
 * Operations per call: 259 = 131 mul, 87 add, 18 sub, 15 neg, 4 cos, 4 sin
 * Operations of prepare: 65 = 33 add, 28 mul, 4 sub
 *
 * Input q (11): generalized coordinates
 *   q[0]  drift.w
 *   q[1]  drift.x
 *   q[2]  drift.y
 *   q[3]  drift.z
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
    /* panel0: first moment, mass, inertia */
    const wreal panel0_mass = p[5]; /* kg */
    const wreal panel0_com_x = p[6]; /* m */
    const wreal panel0_inertia_yy = p[8]; /* kg m^2 */
    const wreal panel0_inertia_zz = p[9]; /* kg m^2 */
    const wreal panel0_first_moment_x = panel0_mass * panel0_com_x;
    const wreal panel0_mass_2 = panel0_com_x * panel0_first_moment_x;
    const wreal panel0_inertia_yy_2 = panel0_inertia_yy + panel0_mass_2;
    const wreal panel0_inertia_zz_2 = panel0_inertia_zz + panel0_mass_2;

    /* panel1: first moment, mass, inertia */
    const wreal panel1_mass = p[11]; /* kg */
    const wreal panel1_com_x = p[12]; /* m */
    const wreal panel1_inertia_yy = p[14]; /* kg m^2 */
    const wreal panel1_inertia_zz = p[15]; /* kg m^2 */
    const wreal panel1_first_moment_x = panel1_mass * panel1_com_x;
    const wreal panel1_mass_2 = panel1_com_x * panel1_first_moment_x;
    const wreal panel1_inertia_yy_2 = panel1_inertia_yy + panel1_mass_2;
    const wreal panel1_inertia_zz_2 = panel1_inertia_zz + panel1_mass_2;

    /* panel2: first moment, mass, inertia, base moment */
    const wreal panel2_mass = p[17]; /* kg */
    const wreal panel2_com_x = p[18]; /* m */
    const wreal panel2_inertia_yy = p[20]; /* kg m^2 */
    const wreal panel2_inertia_zz = p[21]; /* kg m^2 */
    const wreal hinge3_position_x = p[22]; /* m */
    const wreal panel3_mass = p[23]; /* kg */
    const wreal panel2_first_moment_x = panel2_mass * panel2_com_x;
    const wreal panel2_mass_2 = panel2_com_x * panel2_first_moment_x;
    const wreal panel2_inertia_yy_2 = panel2_inertia_yy + panel2_mass_2;
    const wreal panel2_inertia_zz_2 = panel2_inertia_zz + panel2_mass_2;
    w[7] = panel2_first_moment_x + hinge3_position_x * panel3_mass; /* panel2_base_moment_x */

    /* panel3: first moment, mass, inertia, base inertia, base */
    const wreal panel2_inertia_xx = p[19]; /* kg m^2 */
    const wreal panel3_com_x = p[24]; /* m */
    const wreal panel3_inertia_xx = p[25]; /* kg m^2 */
    const wreal panel3_inertia_yy = p[26]; /* kg m^2 */
    const wreal panel3_inertia_zz = p[27]; /* kg m^2 */
    const wreal panel3_first_moment_x = panel3_mass * panel3_com_x;
    const wreal panel3_mass_2 = panel3_com_x * panel3_first_moment_x;
    const wreal panel3_inertia_yy_2 = panel3_inertia_yy + panel3_mass_2;
    const wreal panel3_inertia_zz_2 = panel3_inertia_zz + panel3_mass_2;
    const wreal panel3_base_inertia_zz = panel3_inertia_zz_2 - panel3_inertia_xx;
    const wreal panel3_base = 0.5 * panel3_mass * hinge3_position_x * hinge3_position_x * 2.0;
    const wreal panel3_base_2 = panel2_mass + panel3_mass;
    const wreal panel3_base_3 = panel2_inertia_xx + panel3_inertia_xx;
    w[4] = panel3_first_moment_x; /* panel3_first_moment_x */
    w[5] = panel3_inertia_yy_2; /* panel3_inertia_yy_2 */
    w[6] = panel3_base_inertia_zz; /* panel3_base_inertia_zz */

    /* panel2: base inertia, base, inertia */
    const wreal panel1_inertia_xx = p[13]; /* kg m^2 */
    const wreal hinge2_position_x = p[16]; /* m */
    const wreal panel2_base_inertia_yy = panel2_inertia_yy_2 + panel3_base;
    const wreal panel2_base_inertia_zz = panel2_inertia_zz_2 + panel3_inertia_xx + (panel3_base
        - panel3_base_3);
    const wreal panel2_base = 0.5 * panel3_base_2 * hinge2_position_x * hinge2_position_x * 2.0;
    const wreal panel2_base_2 = panel1_mass + panel3_base_2;
    const wreal panel2_base_3 = panel1_inertia_xx + panel3_base_3;
    w[8] = panel2_base_inertia_zz; /* panel2_base_inertia_zz */
    w[20] = panel3_inertia_yy_2 + panel2_base_inertia_yy; /* panel2_inertia */
    w[21] = panel3_base_inertia_zz + panel2_base_inertia_zz; /* panel2_inertia_2 */

    /* panel1: base moment, base inertia, base */
    const wreal panel0_inertia_xx = p[7]; /* kg m^2 */
    const wreal hinge1_position_x = p[10]; /* m */
    const wreal panel1_base = 0.5 * panel2_base_2 * hinge1_position_x * hinge1_position_x * 2.0;
    const wreal panel1_base_2 = panel0_mass + panel2_base_2;
    const wreal panel1_base_3 = panel0_inertia_xx + panel2_base_3;
    w[9] = panel1_first_moment_x + hinge2_position_x * panel3_base_2; /* panel1_base_moment_x */
    w[10] = panel1_inertia_yy_2 + panel2_base; /* panel1_base_inertia_yy */
    /* panel1_base_inertia_zz */
    w[11] = panel1_inertia_zz_2 + panel3_base_3 + (panel2_base - panel2_base_3);

    /* panel0: base moment, base inertia, base */
    const wreal hinge0_position_x = p[4]; /* m */
    const wreal panel0_base = 0.5 * panel1_base_2 * hinge0_position_x * hinge0_position_x * 2.0;
    w[12] = panel0_first_moment_x + hinge1_position_x * panel2_base_2; /* panel0_base_moment_x */
    w[13] = panel0_inertia_yy_2 + panel1_base; /* panel0_base_inertia_yy */
    /* panel0_base_inertia_zz */
    w[14] = panel0_inertia_zz_2 + panel2_base_3 + (panel1_base - panel1_base_3);

    /* hub: base moment, base mass, base inertia */
    const wreal hub_mass = p[0]; /* kg */
    const wreal hub_inertia_xx = p[1]; /* kg m^2 */
    const wreal hub_inertia_yy = p[2]; /* kg m^2 */
    const wreal hub_inertia_zz = p[3]; /* kg m^2 */
    w[15] = hinge0_position_x * panel1_base_2; /* hub_base_moment_x */
    w[16] = hub_mass + panel1_base_2; /* hub_base_mass */
    w[17] = hub_inertia_xx + panel1_base_3; /* hub_base_inertia_xx */
    w[18] = hub_inertia_yy + panel0_base; /* hub_base_inertia_yy */
    w[19] = hub_inertia_zz + panel1_base_3 + panel0_base; /* hub_base_inertia_zz */

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

    /* shared by several: turn, R, cos, sin */
    const real hinge0_q = q[7]; /* rad */
    const real hinge1_q = q[8]; /* rad */
    const real hinge2_q = q[9]; /* rad */
    const real hinge3_q = q[10]; /* rad */
    const real hinge1_turn = hinge0_q + hinge1_q;
    const real hinge2_turn = hinge2_q + hinge1_turn;
    const real hinge3_R = hinge3_q + hinge2_turn;
    const real angle[CARDAN_PADDED(4)] = {hinge0_q, hinge1_turn, hinge2_turn, hinge3_R};
    real sine[CARDAN_PADDED(4)], cosine[CARDAN_PADDED(4)];
    cardan_sincos(4, angle, sine, cosine);
    const real hinge0_cos = cosine[0];
    const real hinge0_sin = sine[0];
    const real hinge1_cos = cosine[1];
    const real hinge1_sin = sine[1];
    const real hinge2_cos = cosine[2];
    const real hinge2_sin = sine[2];
    const real hinge3_cos = cosine[3];
    const real hinge3_sin = sine[3];

    /* panel0: turned */
    const wreal panel0_base_inertia_zz = w[14];
    const real panel0_turned = panel0_base_inertia_zz * hinge0_sin;
    const real panel0_turned_2 = hinge0_sin * panel0_turned;

    /* hinge1: p */
    const wreal hinge1_position_x = w[1]; /* m */
    const real hinge1_p_x = hinge1_position_x * hinge0_cos;
    const real hinge1_p = hinge1_position_x * hinge0_sin;

    /* panel1: turned */
    const wreal panel1_base_inertia_zz = w[11];
    const real panel1_turned = panel1_base_inertia_zz * hinge1_sin;
    const real panel1_turned_2 = hinge1_sin * panel1_turned;

    /* hinge2: p */
    const wreal hinge2_position_x = w[2]; /* m */
    const real hinge2_p_x = hinge2_position_x * hinge1_cos;
    const real hinge2_p = hinge2_position_x * hinge1_sin;

    /* panel2: turned, inertia */
    const wreal panel3_base_inertia_zz = w[6];
    const wreal panel2_base_inertia_zz = w[8];
    const real panel2_turned = panel2_base_inertia_zz * hinge2_sin;
    const real panel2_turned_2 = hinge2_sin * panel2_turned;
    const real panel2_inertia_3 = panel3_base_inertia_zz * hinge3_sin;
    const real panel2_inertia_4 = hinge3_sin * panel2_inertia_3;
    const real panel2_inertia_5 = hinge2_cos * panel2_turned + hinge3_cos * panel2_inertia_3;

    /* hinge3: p */
    const wreal hinge3_position_x = w[3]; /* m */
    const real hinge3_p_x = hinge3_position_x * hinge2_cos;
    const real hinge3_p = hinge3_position_x * hinge2_sin;

    /* shared by several: inertia */
    const wreal panel3_first_moment_x = w[4];
    const real panel2_inertia_6 = panel3_first_moment_x * hinge3_cos;
    const real panel2_inertia_7 = panel3_first_moment_x * hinge3_sin;
    const real panel2_inertia_8 = hinge3_p_x * panel2_inertia_6;
    const real panel2_inertia_9 = hinge3_p * panel2_inertia_7;
    const real panel2_inertia_10 = panel2_inertia_8 + panel2_inertia_9;

    /* panel2: composite moment, inertia, composite inertia */
    const wreal panel2_base_moment_x = w[7];
    const wreal panel2_inertia = w[20];
    const wreal panel2_inertia_2 = w[21];
    const real panel2_composite_moment_x = panel2_base_moment_x * hinge2_cos + panel2_inertia_6;
    const real panel2_inertia_11 = panel2_base_moment_x * hinge2_sin + panel2_inertia_7;
    const real panel2_composite_inertia_xz = hinge3_p * panel2_inertia_6
        + hinge3_p_x * panel2_inertia_7 + panel2_inertia_5;
    const real panel2_inertia_12 = 2.0 * panel2_inertia_10;
    const real panel2_composite_inertia_xx = panel2_turned_2 + panel2_inertia_4
        - 2.0 * panel2_inertia_8 + panel2_inertia_12;
    const real panel2_composite_inertia_zz = panel2_inertia_2 - panel2_turned_2
        - panel2_inertia_4 - 2.0 * panel2_inertia_9 + panel2_inertia_12;
    const real panel2_composite_inertia_yy = panel2_inertia_12 + panel2_inertia;
    out[88] = panel2_composite_inertia_yy; /* M: hinge2.u,hinge2.u */

    /* panel1: composite moment, inertia, composite inertia */
    const wreal panel1_base_moment_x = w[9];
    const real panel1_composite_moment_x = panel1_base_moment_x * hinge1_cos
        + panel2_composite_moment_x;
    const real panel1_inertia = panel1_base_moment_x * hinge1_sin + panel2_inertia_11;
    const real panel1_inertia_2 = hinge1_cos * panel1_turned + panel2_composite_moment_x * hinge2_p;
    const real panel1_composite_inertia_xz = panel2_composite_inertia_xz
        + panel2_inertia_11 * hinge2_p_x + panel1_inertia_2;

    /* panel0: composite moment, inertia, composite inertia */
    const wreal panel0_base_moment_x = w[12];
    const real panel0_composite_moment_x = panel0_base_moment_x * hinge0_cos
        + panel1_composite_moment_x;
    const real panel0_inertia = hinge0_cos * panel0_turned + panel1_composite_moment_x * hinge1_p
        + panel1_inertia * hinge1_p_x;
    const real panel0_composite_inertia_xz = panel1_composite_inertia_xz + panel0_inertia;

    /* drift: momentum fy, R, momentum mx, momentum fx, momentum fz */
    const real drift_w = q[0];
    const real drift_x = q[1];
    const real drift_y = q[2];
    const real drift_z = q[3];
    const wreal hub_base_mass = w[16];
    const real drift_momentum_fy = panel0_base_moment_x * hinge0_sin + panel1_inertia;
    const real drift_R = 2.0 * drift_x;
    const real drift_R_2 = 2.0 * drift_y;
    const real drift_R_3 = 2.0 * drift_z;
    const real drift_R_4 = drift_w * drift_R;
    const real drift_R_5 = 1.0 - drift_x * drift_R;
    const real drift_R_6 = drift_w * drift_R_2;
    const real drift_R_7 = drift_w * drift_R_3;
    const real drift_R_8 = drift_x * drift_R_2;
    const real drift_R_9 = drift_y * drift_R_2;
    const real drift_R_10 = drift_x * drift_R_3;
    const real drift_R_11 = drift_y * drift_R_3;
    const real drift_R_12 = drift_z * drift_R_3;
    const real drift_R_xx = 1.0 - drift_R_9 - drift_R_12;
    const real drift_R_yy = drift_R_5 - drift_R_12;
    const real drift_R_zz = drift_R_5 - drift_R_9;
    const real drift_R_xy = drift_R_8 - drift_R_7;
    const real drift_R_yx = drift_R_7 + drift_R_8;
    const real drift_R_xz = drift_R_6 + drift_R_10;
    const real drift_R_zx = drift_R_10 - drift_R_6;
    const real drift_R_yz = drift_R_11 - drift_R_4;
    const real drift_R_zy = drift_R_4 + drift_R_11;
    const real drift_momentum_mx = drift_momentum_fy * drift_R_xy;
    const real drift_momentum_mx_2 = drift_momentum_fy * drift_R_yy;
    const real drift_momentum_mx_3 = drift_momentum_fy * drift_R_zy;
    const real drift_momentum_fx = hub_base_mass * drift_R_xx;
    const real drift_momentum_fy_2 = hub_base_mass * drift_R_xy;
    const real drift_momentum_fz = hub_base_mass * drift_R_xz;
    const real drift_momentum_fx_2 = hub_base_mass * drift_R_yx;
    const real drift_momentum_fy_3 = hub_base_mass * drift_R_yy;
    const real drift_momentum_fz_2 = hub_base_mass * drift_R_yz;
    const real drift_momentum_fx_3 = hub_base_mass * drift_R_zx;
    const real drift_momentum_fy_4 = hub_base_mass * drift_R_zy;
    const real drift_momentum_fz_3 = hub_base_mass * drift_R_zz;
    out[3] = drift_momentum_mx; /* M: drift.u.x,drift.u.px */
    out[30] = drift_momentum_mx; /* M: drift.u.px,drift.u.x */
    out[4] = drift_momentum_mx_2; /* M: drift.u.x,drift.u.py */
    out[40] = drift_momentum_mx_2; /* M: drift.u.py,drift.u.x */
    out[5] = drift_momentum_mx_3; /* M: drift.u.x,drift.u.pz */
    out[50] = drift_momentum_mx_3; /* M: drift.u.pz,drift.u.x */

    /* M */
    const wreal hinge0_position_x = w[0]; /* m */
    const wreal panel3_inertia_yy_2 = w[5];
    const real M_10_9 = panel3_inertia_yy_2 + panel2_inertia_10;
    const real M_10_8 = panel2_inertia_7 * hinge2_p + panel2_inertia_6 * hinge2_p_x + M_10_9;
    const real M_10_7 = panel2_inertia_7 * hinge1_p + panel2_inertia_6 * hinge1_p_x + M_10_8;
    const real M_10_2 = M_10_7 + hinge0_position_x * panel2_inertia_6;
    const real M_10_4 = -(panel2_inertia_7 * drift_R_xx + panel2_inertia_6 * drift_R_xz);
    const real M_10_5 = -(panel2_inertia_7 * drift_R_yx + panel2_inertia_6 * drift_R_yz);
    const real M_10_6 = -(panel2_inertia_7 * drift_R_zx + panel2_inertia_6 * drift_R_zz);
    const real M_9_4 = -(panel2_inertia_11 * drift_R_xx + panel2_composite_moment_x * drift_R_xz);
    const real M_9_5 = -(panel2_inertia_11 * drift_R_yx + panel2_composite_moment_x * drift_R_yz);
    const real M_9_6 = -(panel2_inertia_11 * drift_R_zx + panel2_composite_moment_x * drift_R_zz);
    const real M_8_4 = -(panel1_inertia * drift_R_xx + panel1_composite_moment_x * drift_R_xz);
    const real M_8_5 = -(panel1_inertia * drift_R_yx + panel1_composite_moment_x * drift_R_yz);
    const real M_8_6 = -(panel1_inertia * drift_R_zx + panel1_composite_moment_x * drift_R_zz);
    const real M_5_4 = drift_R_xx * drift_momentum_fx_2 + drift_R_xz * drift_momentum_fz_2
        + drift_R_xy * drift_momentum_fy_3;
    const real M_6_4 = drift_R_xx * drift_momentum_fx_3 + drift_R_xy * drift_momentum_fy_4
        + drift_R_xz * drift_momentum_fz_3;
    const real M_6_5 = drift_R_yx * drift_momentum_fx_3 + drift_R_yy * drift_momentum_fy_4
        + drift_R_yz * drift_momentum_fz_3;
    out[89] = M_10_9; /* M: hinge2.u,hinge3.u */
    out[98] = M_10_9; /* M: hinge3.u,hinge2.u */
    out[79] = M_10_8; /* M: hinge1.u,hinge3.u */
    out[97] = M_10_8; /* M: hinge3.u,hinge1.u */
    out[69] = M_10_7; /* M: hinge0.u,hinge3.u */
    out[96] = M_10_7; /* M: hinge3.u,hinge0.u */
    out[19] = M_10_2; /* M: drift.u.y,hinge3.u */
    out[91] = M_10_2; /* M: hinge3.u,drift.u.y */
    out[39] = M_10_4; /* M: drift.u.px,hinge3.u */
    out[93] = M_10_4; /* M: hinge3.u,drift.u.px */
    out[49] = M_10_5; /* M: drift.u.py,hinge3.u */
    out[94] = M_10_5; /* M: hinge3.u,drift.u.py */
    out[59] = M_10_6; /* M: drift.u.pz,hinge3.u */
    out[95] = M_10_6; /* M: hinge3.u,drift.u.pz */
    out[38] = M_9_4; /* M: drift.u.px,hinge2.u */
    out[83] = M_9_4; /* M: hinge2.u,drift.u.px */
    out[48] = M_9_5; /* M: drift.u.py,hinge2.u */
    out[84] = M_9_5; /* M: hinge2.u,drift.u.py */
    out[58] = M_9_6; /* M: drift.u.pz,hinge2.u */
    out[85] = M_9_6; /* M: hinge2.u,drift.u.pz */
    out[37] = M_8_4; /* M: drift.u.px,hinge1.u */
    out[73] = M_8_4; /* M: hinge1.u,drift.u.px */
    out[47] = M_8_5; /* M: drift.u.py,hinge1.u */
    out[74] = M_8_5; /* M: hinge1.u,drift.u.py */
    out[57] = M_8_6; /* M: drift.u.pz,hinge1.u */
    out[75] = M_8_6; /* M: hinge1.u,drift.u.pz */
    /* M: drift.u.px,drift.u.px */
    out[33] = drift_R_xy * drift_momentum_fy_2 + drift_R_xz * drift_momentum_fz
        + drift_R_xx * drift_momentum_fx;
    out[34] = M_5_4; /* M: drift.u.px,drift.u.py */
    out[43] = M_5_4; /* M: drift.u.py,drift.u.px */
    /* M: drift.u.py,drift.u.py */
    out[44] = drift_R_yx * drift_momentum_fx_2 + drift_R_yz * drift_momentum_fz_2
        + drift_R_yy * drift_momentum_fy_3;
    out[35] = M_6_4; /* M: drift.u.px,drift.u.pz */
    out[53] = M_6_4; /* M: drift.u.pz,drift.u.px */
    out[45] = M_6_5; /* M: drift.u.py,drift.u.pz */
    out[54] = M_6_5; /* M: drift.u.pz,drift.u.py */
    /* M: drift.u.pz,drift.u.pz */
    out[55] = drift_R_zx * drift_momentum_fx_3 + drift_R_zy * drift_momentum_fy_4
        + drift_R_zz * drift_momentum_fz_3;

    /* shared by several: inertia, M */
    const real panel1_inertia_3 = panel2_composite_moment_x * hinge2_p_x;
    const real panel1_inertia_4 = panel2_inertia_11 * hinge2_p;
    const real panel1_inertia_5 = panel1_inertia_3 + panel1_inertia_4;
    const real panel0_inertia_2 = panel1_composite_moment_x * hinge1_p_x;
    const real panel0_inertia_3 = panel1_inertia * hinge1_p;
    const real panel0_inertia_4 = panel0_inertia_2 + panel0_inertia_3;
    const real hub_inertia = hinge0_position_x * panel0_composite_moment_x;
    const real drift_M = drift_momentum_fy * drift_R_xx;
    const real drift_M_2 = drift_momentum_fy * drift_R_yx;
    const real drift_M_3 = drift_momentum_fy * drift_R_zx;

    /* panel1: inertia, composite inertia */
    const wreal panel1_base_inertia_yy = w[10];
    const real panel1_inertia_6 = 2.0 * panel1_inertia_5;
    const real panel1_composite_inertia_xx = panel1_turned_2 - 2.0 * panel1_inertia_3
        + (panel2_composite_inertia_xx + panel1_inertia_6);
    const real panel1_composite_inertia_zz = panel1_base_inertia_zz - panel1_turned_2
        - 2.0 * panel1_inertia_4 + (panel2_composite_inertia_zz + panel1_inertia_6);
    const real panel1_composite_inertia_yy = panel1_base_inertia_yy + panel2_composite_inertia_yy
        + panel1_inertia_6;
    out[77] = panel1_composite_inertia_yy; /* M: hinge1.u,hinge1.u */

    /* M */
    const real M_9_8 = panel2_composite_inertia_yy + panel1_inertia_5;
    const real M_8_7 = panel1_composite_inertia_yy + panel0_inertia_4;
    const real M_9_7 = panel2_inertia_11 * hinge1_p + panel2_composite_moment_x * hinge1_p_x
        + M_9_8;
    const real M_9_2 = M_9_7 + hinge0_position_x * panel2_composite_moment_x;
    const real M_8_2 = M_8_7 + hinge0_position_x * panel1_composite_moment_x;
    const real M_7_4 = -(drift_M + panel0_composite_moment_x * drift_R_xz);
    const real M_7_5 = -(drift_M_2 + panel0_composite_moment_x * drift_R_yz);
    const real M_7_6 = -(drift_M_3 + panel0_composite_moment_x * drift_R_zz);
    out[78] = M_9_8; /* M: hinge1.u,hinge2.u */
    out[87] = M_9_8; /* M: hinge2.u,hinge1.u */
    out[67] = M_8_7; /* M: hinge0.u,hinge1.u */
    out[76] = M_8_7; /* M: hinge1.u,hinge0.u */
    out[68] = M_9_7; /* M: hinge0.u,hinge2.u */
    out[86] = M_9_7; /* M: hinge2.u,hinge0.u */
    out[18] = M_9_2; /* M: drift.u.y,hinge2.u */
    out[81] = M_9_2; /* M: hinge2.u,drift.u.y */
    out[17] = M_8_2; /* M: drift.u.y,hinge1.u */
    out[71] = M_8_2; /* M: hinge1.u,drift.u.y */
    out[36] = M_7_4; /* M: drift.u.px,hinge0.u */
    out[63] = M_7_4; /* M: hinge0.u,drift.u.px */
    out[46] = M_7_5; /* M: drift.u.py,hinge0.u */
    out[64] = M_7_5; /* M: hinge0.u,drift.u.py */
    out[56] = M_7_6; /* M: drift.u.pz,hinge0.u */
    out[65] = M_7_6; /* M: hinge0.u,drift.u.pz */

    /* panel0: inertia, composite inertia */
    const wreal panel0_base_inertia_yy = w[13];
    const real panel0_inertia_5 = 2.0 * panel0_inertia_4;
    const real panel0_composite_inertia_xx = panel0_turned_2 - 2.0 * panel0_inertia_2
        + panel0_inertia_5 + panel1_composite_inertia_xx;
    const real panel0_composite_inertia_zz = panel0_base_inertia_zz - panel0_turned_2
        - 2.0 * panel0_inertia_3 + panel0_inertia_5 + panel1_composite_inertia_zz;
    const real panel0_composite_inertia_yy = panel0_base_inertia_yy + panel0_inertia_5
        + panel1_composite_inertia_yy;
    out[66] = panel0_composite_inertia_yy; /* M: hinge0.u,hinge0.u */

    /* hub: composite inertia, inertia, composite moment */
    const wreal hub_base_moment_x = w[15];
    const wreal hub_base_inertia_xx = w[17];
    const wreal hub_base_inertia_yy = w[18];
    const wreal hub_base_inertia_zz = w[19];
    const real hub_inertia_2 = 2.0 * hub_inertia;
    const real hub_composite_inertia_xz = panel0_composite_inertia_xz
        + hinge0_position_x * drift_momentum_fy;
    const real hub_composite_moment_x = hub_base_moment_x + panel0_composite_moment_x;
    out[0] = hub_base_inertia_xx + panel0_composite_inertia_xx; /* M: drift.u.x,drift.u.x */
    out[2] = hub_composite_inertia_xz; /* M: drift.u.x,drift.u.z */
    out[20] = hub_composite_inertia_xz; /* M: drift.u.z,drift.u.x */
    /* M: drift.u.y,drift.u.y */
    out[11] = hub_base_inertia_yy + hub_inertia_2 + panel0_composite_inertia_yy;
    /* M: drift.u.z,drift.u.z */
    out[22] = hub_base_inertia_zz + hub_inertia_2 + panel0_composite_inertia_zz;

    /* M */
    const real M_7_2 = panel0_composite_inertia_yy + hub_inertia;
    out[16] = M_7_2; /* M: drift.u.y,hinge0.u */
    out[61] = M_7_2; /* M: hinge0.u,drift.u.y */

    /* drift: momentum my, momentum mz */
    const real drift_momentum_my = -(drift_M + hub_composite_moment_x * drift_R_xz);
    const real drift_momentum_my_2 = -(drift_M_2 + hub_composite_moment_x * drift_R_yz);
    const real drift_momentum_my_3 = -(drift_M_3 + hub_composite_moment_x * drift_R_zz);
    const real drift_momentum_mz = hub_composite_moment_x * drift_R_xy;
    const real drift_momentum_mz_2 = hub_composite_moment_x * drift_R_yy;
    const real drift_momentum_mz_3 = hub_composite_moment_x * drift_R_zy;
    out[13] = drift_momentum_my; /* M: drift.u.y,drift.u.px */
    out[31] = drift_momentum_my; /* M: drift.u.px,drift.u.y */
    out[14] = drift_momentum_my_2; /* M: drift.u.y,drift.u.py */
    out[41] = drift_momentum_my_2; /* M: drift.u.py,drift.u.y */
    out[15] = drift_momentum_my_3; /* M: drift.u.y,drift.u.pz */
    out[51] = drift_momentum_my_3; /* M: drift.u.pz,drift.u.y */
    out[23] = drift_momentum_mz; /* M: drift.u.z,drift.u.px */
    out[32] = drift_momentum_mz; /* M: drift.u.px,drift.u.z */
    out[24] = drift_momentum_mz_2; /* M: drift.u.z,drift.u.py */
    out[42] = drift_momentum_mz_2; /* M: drift.u.py,drift.u.z */
    out[25] = drift_momentum_mz_3; /* M: drift.u.z,drift.u.pz */
    out[52] = drift_momentum_mz_3; /* M: drift.u.pz,drift.u.z */

    /* results that are numbers or inputs */
    out[1] = CARDAN_REAL(0.0); /* M: drift.u.x,drift.u.y */
    out[6] = CARDAN_REAL(0.0); /* M: drift.u.x,hinge0.u */
    out[7] = CARDAN_REAL(0.0); /* M: drift.u.x,hinge1.u */
    out[8] = CARDAN_REAL(0.0); /* M: drift.u.x,hinge2.u */
    out[9] = CARDAN_REAL(0.0); /* M: drift.u.x,hinge3.u */
    out[10] = CARDAN_REAL(0.0); /* M: drift.u.y,drift.u.x */
    out[12] = CARDAN_REAL(0.0); /* M: drift.u.y,drift.u.z */
    out[21] = CARDAN_REAL(0.0); /* M: drift.u.z,drift.u.y */
    out[26] = CARDAN_REAL(0.0); /* M: drift.u.z,hinge0.u */
    out[27] = CARDAN_REAL(0.0); /* M: drift.u.z,hinge1.u */
    out[28] = CARDAN_REAL(0.0); /* M: drift.u.z,hinge2.u */
    out[29] = CARDAN_REAL(0.0); /* M: drift.u.z,hinge3.u */
    out[60] = CARDAN_REAL(0.0); /* M: hinge0.u,drift.u.x */
    out[62] = CARDAN_REAL(0.0); /* M: hinge0.u,drift.u.z */
    out[70] = CARDAN_REAL(0.0); /* M: hinge1.u,drift.u.x */
    out[72] = CARDAN_REAL(0.0); /* M: hinge1.u,drift.u.z */
    out[80] = CARDAN_REAL(0.0); /* M: hinge2.u,drift.u.x */
    out[82] = CARDAN_REAL(0.0); /* M: hinge2.u,drift.u.z */
    out[90] = CARDAN_REAL(0.0); /* M: hinge3.u,drift.u.x */
    out[92] = CARDAN_REAL(0.0); /* M: hinge3.u,drift.u.z */
    out[99] = CARDAN_REAL(w[5]); /* M: hinge3.u,hinge3.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {100, 0, 22, 0, 11, 0, 0, 0, 0, 30, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
