/*
 * mass_matrix of stewart_platform
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: origins, base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 441, work 0, w 47
 * Operations per call: 279 = 155 mul, 77 add, 33 sub, 6 cos, 6 sin, 2 neg
 * Operations of prepare: 145 = 75 add, 69 mul, 1 neg
 *
 * Input q (22): generalized coordinates
 *   q[0]  hooke0.angle1 [rad]
 *   q[1]  hooke0.angle2 [rad]
 *   q[2]  slide0 [m]
 *   q[3]  ball0.w
 *   q[4]  ball0.x
 *   q[5]  ball0.y
 *   q[6]  ball0.z
 *   q[7]  hooke1.angle1 [rad]
 *   q[8]  hooke1.angle2 [rad]
 *   q[9]  slide1 [m]
 *   q[10]  hooke2.angle1 [rad]
 *   q[11]  hooke2.angle2 [rad]
 *   q[12]  slide2 [m]
 *   q[13]  hooke3.angle1 [rad]
 *   q[14]  hooke3.angle2 [rad]
 *   q[15]  slide3 [m]
 *   q[16]  hooke4.angle1 [rad]
 *   q[17]  hooke4.angle2 [rad]
 *   q[18]  slide4 [m]
 *   q[19]  hooke5.angle1 [rad]
 *   q[20]  hooke5.angle2 [rad]
 *   q[21]  slide5 [m]
 *
 * Input p (96): parameters, read by prepare_ only
 *
 * Output M (21 x 21): out[0 ... 440], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* tube0: first moment, mass, inertia, base inertia */
    const wreal tube0_mass = p[3]; /* kg */
    const wreal tube0_com_z = p[4]; /* m */
    const wreal tube0_inertia_xx = p[5]; /* kg m^2 */
    const wreal tube0_inertia_yy = p[6]; /* kg m^2 */
    const wreal tube0_inertia_zz = p[7]; /* kg m^2 */
    const wreal rod0_inertia_zz = p[13]; /* kg m^2 */
    const wreal tube0_first_moment_z = tube0_mass * tube0_com_z;
    const wreal tube0_mass_2 = tube0_com_z * tube0_first_moment_z;
    const wreal tube0_inertia_xx_2 = tube0_inertia_xx + tube0_mass_2;
    const wreal tube0_inertia_yy_2 = tube0_inertia_yy + tube0_mass_2;
    w[45] = tube0_inertia_zz + rod0_inertia_zz; /* tube0_base_inertia_zz */

    /* rod0: first moment, mass, inertia, base mass, base moment, base */
    const wreal slide0_position_z = p[8]; /* m */
    const wreal rod0_mass = p[9]; /* kg */
    const wreal rod0_com_z = p[10]; /* m */
    const wreal rod0_inertia_xx = p[11]; /* kg m^2 */
    const wreal rod0_inertia_yy = p[12]; /* kg m^2 */
    const wreal platform_mass = p[16]; /* kg */
    const wreal rod0_first_moment_z = rod0_mass * rod0_com_z;
    const wreal rod0_mass_2 = rod0_com_z * rod0_first_moment_z;
    const wreal rod0_inertia_xx_2 = rod0_inertia_xx + rod0_mass_2;
    const wreal rod0_inertia_yy_2 = rod0_inertia_yy + rod0_mass_2;
    const wreal rod0_mass_3 = slide0_position_z * (rod0_first_moment_z
        + 0.5 * rod0_mass * slide0_position_z) * 2.0;
    const wreal rod0_base_mass = rod0_mass + platform_mass;
    const wreal rod0_base = rod0_mass_3
        + 0.5 * platform_mass * slide0_position_z * slide0_position_z * 2.0;
    w[41] = rod0_base_mass; /* rod0_base_mass */
    /* rod0_base_moment_z */
    w[42] = rod0_first_moment_z + slide0_position_z * rod0_mass + slide0_position_z * platform_mass;

    /* ball0: momentum fz, momentum fx */
    const wreal ball0_child_position_x = p[14]; /* m */
    const wreal ball0_child_position_y = p[15]; /* m */
    const wreal ball0_momentum_fz = ball0_child_position_x * platform_mass;
    const wreal ball0_momentum_fx = ball0_child_position_y * platform_mass;
    w[1] = ball0_momentum_fz; /* ball0_momentum_fz */
    w[2] = ball0_momentum_fx; /* ball0_momentum_fx */

    /* platform: first moment, mass, base second moment, inertia */
    const wreal platform_com_z = p[17]; /* m */
    const wreal platform_inertia_xx = p[18]; /* kg m^2 */
    const wreal platform_inertia_yy = p[19]; /* kg m^2 */
    const wreal platform_inertia_zz = p[20]; /* kg m^2 */
    const wreal platform_first_moment_z = platform_mass * platform_com_z;
    const wreal platform_mass_2 = ball0_child_position_x * ball0_momentum_fz;
    const wreal platform_mass_3 = ball0_child_position_y * ball0_momentum_fx;
    const wreal platform_mass_4 = platform_com_z * platform_first_moment_z;
    const wreal platform_base_second_moment_xy = ball0_child_position_y * ball0_momentum_fz;
    w[3] = platform_first_moment_z; /* platform_first_moment_z */
    w[4] = platform_base_second_moment_xy; /* platform_base_second_moment_xy */
    w[5] = -platform_base_second_moment_xy; /* platform_inertia_xy */
    w[6] = platform_com_z * ball0_momentum_fz; /* platform_inertia_xz */
    w[7] = platform_com_z * ball0_momentum_fx; /* platform_inertia_yz */
    w[8] = platform_inertia_xx + platform_mass_3 + platform_mass_4; /* platform_inertia_xx_2 */
    w[9] = platform_inertia_yy + platform_mass_2 + platform_mass_4; /* platform_inertia_yy_2 */
    w[10] = platform_inertia_zz + platform_mass_2 + platform_mass_3; /* platform_inertia_zz_2 */

    /* tube1: first moment, mass, inertia, base inertia */
    const wreal tube1_mass = p[23]; /* kg */
    const wreal tube1_com_z = p[24]; /* m */
    const wreal tube1_inertia_xx = p[25]; /* kg m^2 */
    const wreal tube1_inertia_yy = p[26]; /* kg m^2 */
    const wreal tube1_inertia_zz = p[27]; /* kg m^2 */
    const wreal rod1_inertia_zz = p[33]; /* kg m^2 */
    const wreal tube1_first_moment_z = tube1_mass * tube1_com_z;
    const wreal tube1_mass_2 = tube1_com_z * tube1_first_moment_z;
    const wreal tube1_inertia_xx_2 = tube1_inertia_xx + tube1_mass_2;
    const wreal tube1_inertia_yy_2 = tube1_inertia_yy + tube1_mass_2;
    w[40] = tube1_inertia_zz + rod1_inertia_zz; /* tube1_base_inertia_zz */

    /* rod1: first moment, mass, inertia, base moment */
    const wreal slide1_position_z = p[28]; /* m */
    const wreal rod1_mass = p[29]; /* kg */
    const wreal rod1_com_z = p[30]; /* m */
    const wreal rod1_inertia_xx = p[31]; /* kg m^2 */
    const wreal rod1_inertia_yy = p[32]; /* kg m^2 */
    const wreal rod1_first_moment_z = rod1_mass * rod1_com_z;
    const wreal rod1_mass_2 = rod1_com_z * rod1_first_moment_z;
    const wreal rod1_inertia_xx_2 = rod1_inertia_xx + rod1_mass_2;
    const wreal rod1_inertia_yy_2 = rod1_inertia_yy + rod1_mass_2;
    w[17] = rod1_first_moment_z + slide1_position_z * rod1_mass; /* rod1_base_moment_z */

    /* tube2: first moment, mass, inertia, base inertia */
    const wreal tube2_mass = p[36]; /* kg */
    const wreal tube2_com_z = p[37]; /* m */
    const wreal tube2_inertia_xx = p[38]; /* kg m^2 */
    const wreal tube2_inertia_yy = p[39]; /* kg m^2 */
    const wreal tube2_inertia_zz = p[40]; /* kg m^2 */
    const wreal rod2_inertia_zz = p[46]; /* kg m^2 */
    const wreal tube2_first_moment_z = tube2_mass * tube2_com_z;
    const wreal tube2_mass_2 = tube2_com_z * tube2_first_moment_z;
    const wreal tube2_inertia_xx_2 = tube2_inertia_xx + tube2_mass_2;
    const wreal tube2_inertia_yy_2 = tube2_inertia_yy + tube2_mass_2;
    w[37] = tube2_inertia_zz + rod2_inertia_zz; /* tube2_base_inertia_zz */

    /* rod2: first moment, mass, inertia, base moment */
    const wreal slide2_position_z = p[41]; /* m */
    const wreal rod2_mass = p[42]; /* kg */
    const wreal rod2_com_z = p[43]; /* m */
    const wreal rod2_inertia_xx = p[44]; /* kg m^2 */
    const wreal rod2_inertia_yy = p[45]; /* kg m^2 */
    const wreal rod2_first_moment_z = rod2_mass * rod2_com_z;
    const wreal rod2_mass_2 = rod2_com_z * rod2_first_moment_z;
    const wreal rod2_inertia_xx_2 = rod2_inertia_xx + rod2_mass_2;
    const wreal rod2_inertia_yy_2 = rod2_inertia_yy + rod2_mass_2;
    w[19] = rod2_first_moment_z + slide2_position_z * rod2_mass; /* rod2_base_moment_z */

    /* tube3: first moment, mass, inertia, base inertia */
    const wreal tube3_mass = p[49]; /* kg */
    const wreal tube3_com_z = p[50]; /* m */
    const wreal tube3_inertia_xx = p[51]; /* kg m^2 */
    const wreal tube3_inertia_yy = p[52]; /* kg m^2 */
    const wreal tube3_inertia_zz = p[53]; /* kg m^2 */
    const wreal rod3_inertia_zz = p[59]; /* kg m^2 */
    const wreal tube3_first_moment_z = tube3_mass * tube3_com_z;
    const wreal tube3_mass_2 = tube3_com_z * tube3_first_moment_z;
    const wreal tube3_inertia_xx_2 = tube3_inertia_xx + tube3_mass_2;
    const wreal tube3_inertia_yy_2 = tube3_inertia_yy + tube3_mass_2;
    w[34] = tube3_inertia_zz + rod3_inertia_zz; /* tube3_base_inertia_zz */

    /* rod3: first moment, mass, inertia, base moment */
    const wreal slide3_position_z = p[54]; /* m */
    const wreal rod3_mass = p[55]; /* kg */
    const wreal rod3_com_z = p[56]; /* m */
    const wreal rod3_inertia_xx = p[57]; /* kg m^2 */
    const wreal rod3_inertia_yy = p[58]; /* kg m^2 */
    const wreal rod3_first_moment_z = rod3_mass * rod3_com_z;
    const wreal rod3_mass_2 = rod3_com_z * rod3_first_moment_z;
    const wreal rod3_inertia_xx_2 = rod3_inertia_xx + rod3_mass_2;
    const wreal rod3_inertia_yy_2 = rod3_inertia_yy + rod3_mass_2;
    w[21] = rod3_first_moment_z + slide3_position_z * rod3_mass; /* rod3_base_moment_z */

    /* tube4: first moment, mass, inertia, base inertia */
    const wreal tube4_mass = p[62]; /* kg */
    const wreal tube4_com_z = p[63]; /* m */
    const wreal tube4_inertia_xx = p[64]; /* kg m^2 */
    const wreal tube4_inertia_yy = p[65]; /* kg m^2 */
    const wreal tube4_inertia_zz = p[66]; /* kg m^2 */
    const wreal rod4_inertia_zz = p[72]; /* kg m^2 */
    const wreal tube4_first_moment_z = tube4_mass * tube4_com_z;
    const wreal tube4_mass_2 = tube4_com_z * tube4_first_moment_z;
    const wreal tube4_inertia_xx_2 = tube4_inertia_xx + tube4_mass_2;
    const wreal tube4_inertia_yy_2 = tube4_inertia_yy + tube4_mass_2;
    w[31] = tube4_inertia_zz + rod4_inertia_zz; /* tube4_base_inertia_zz */

    /* rod4: first moment, mass, inertia, base moment */
    const wreal slide4_position_z = p[67]; /* m */
    const wreal rod4_mass = p[68]; /* kg */
    const wreal rod4_com_z = p[69]; /* m */
    const wreal rod4_inertia_xx = p[70]; /* kg m^2 */
    const wreal rod4_inertia_yy = p[71]; /* kg m^2 */
    const wreal rod4_first_moment_z = rod4_mass * rod4_com_z;
    const wreal rod4_mass_2 = rod4_com_z * rod4_first_moment_z;
    const wreal rod4_inertia_xx_2 = rod4_inertia_xx + rod4_mass_2;
    const wreal rod4_inertia_yy_2 = rod4_inertia_yy + rod4_mass_2;
    w[23] = rod4_first_moment_z + slide4_position_z * rod4_mass; /* rod4_base_moment_z */

    /* tube5: first moment, mass, inertia, base inertia */
    const wreal tube5_mass = p[75]; /* kg */
    const wreal tube5_com_z = p[76]; /* m */
    const wreal tube5_inertia_xx = p[77]; /* kg m^2 */
    const wreal tube5_inertia_yy = p[78]; /* kg m^2 */
    const wreal tube5_inertia_zz = p[79]; /* kg m^2 */
    const wreal rod5_inertia_zz = p[85]; /* kg m^2 */
    const wreal tube5_first_moment_z = tube5_mass * tube5_com_z;
    const wreal tube5_mass_2 = tube5_com_z * tube5_first_moment_z;
    const wreal tube5_inertia_xx_2 = tube5_inertia_xx + tube5_mass_2;
    const wreal tube5_inertia_yy_2 = tube5_inertia_yy + tube5_mass_2;
    w[28] = tube5_inertia_zz + rod5_inertia_zz; /* tube5_base_inertia_zz */

    /* rod5: first moment, mass, inertia, base moment */
    const wreal slide5_position_z = p[80]; /* m */
    const wreal rod5_mass = p[81]; /* kg */
    const wreal rod5_com_z = p[82]; /* m */
    const wreal rod5_inertia_xx = p[83]; /* kg m^2 */
    const wreal rod5_inertia_yy = p[84]; /* kg m^2 */
    const wreal rod5_first_moment_z = rod5_mass * rod5_com_z;
    const wreal rod5_mass_2 = rod5_com_z * rod5_first_moment_z;
    const wreal rod5_inertia_xx_2 = rod5_inertia_xx + rod5_mass_2;
    const wreal rod5_inertia_yy_2 = rod5_inertia_yy + rod5_mass_2;
    w[25] = rod5_first_moment_z + slide5_position_z * rod5_mass; /* rod5_base_moment_z */

    /* shared by several: inertia */
    const wreal tube1_inertia = 0.5 * rod1_mass;
    const wreal tube2_inertia = 0.5 * rod2_mass;
    const wreal tube3_inertia = 0.5 * rod3_mass;
    const wreal tube4_inertia = 0.5 * rod4_mass;
    const wreal tube5_inertia = 0.5 * rod5_mass;
    w[16] = tube1_inertia; /* tube1_inertia */
    w[18] = tube2_inertia; /* tube2_inertia */
    w[20] = tube3_inertia; /* tube3_inertia */
    w[22] = tube4_inertia; /* tube4_inertia */
    w[24] = tube5_inertia; /* tube5_inertia */

    /* rod1: mass */
    const wreal rod1_mass_3 = slide1_position_z * (rod1_first_moment_z
        + slide1_position_z * tube1_inertia) * 2.0;

    /* rod2: mass */
    const wreal rod2_mass_3 = slide2_position_z * (rod2_first_moment_z
        + slide2_position_z * tube2_inertia) * 2.0;

    /* rod3: mass */
    const wreal rod3_mass_3 = slide3_position_z * (rod3_first_moment_z
        + slide3_position_z * tube3_inertia) * 2.0;

    /* rod4: mass */
    const wreal rod4_mass_3 = slide4_position_z * (rod4_first_moment_z
        + slide4_position_z * tube4_inertia) * 2.0;

    /* rod5: mass */
    const wreal rod5_mass_3 = slide5_position_z * (rod5_first_moment_z
        + slide5_position_z * tube5_inertia) * 2.0;

    /* tube5: base inertia */
    w[26] = tube5_inertia_xx_2 + rod5_inertia_xx_2 + rod5_mass_3; /* tube5_base_inertia_xx */
    w[27] = tube5_inertia_yy_2 + rod5_inertia_yy_2 + rod5_mass_3; /* tube5_base_inertia_yy */

    /* tube4: base inertia */
    w[29] = tube4_inertia_xx_2 + rod4_inertia_xx_2 + rod4_mass_3; /* tube4_base_inertia_xx */
    w[30] = tube4_inertia_yy_2 + rod4_inertia_yy_2 + rod4_mass_3; /* tube4_base_inertia_yy */

    /* tube3: base inertia */
    w[32] = tube3_inertia_xx_2 + rod3_inertia_xx_2 + rod3_mass_3; /* tube3_base_inertia_xx */
    w[33] = tube3_inertia_yy_2 + rod3_inertia_yy_2 + rod3_mass_3; /* tube3_base_inertia_yy */

    /* tube2: base inertia */
    w[35] = tube2_inertia_xx_2 + rod2_inertia_xx_2 + rod2_mass_3; /* tube2_base_inertia_xx */
    w[36] = tube2_inertia_yy_2 + rod2_inertia_yy_2 + rod2_mass_3; /* tube2_base_inertia_yy */

    /* tube1: base inertia */
    w[38] = tube1_inertia_xx_2 + rod1_inertia_xx_2 + rod1_mass_3; /* tube1_base_inertia_xx */
    w[39] = tube1_inertia_yy_2 + rod1_inertia_yy_2 + rod1_mass_3; /* tube1_base_inertia_yy */

    /* tube0: base inertia, inertia */
    w[43] = tube0_inertia_xx_2 + rod0_inertia_xx_2 + rod0_base; /* tube0_base_inertia_xx */
    w[44] = tube0_inertia_yy_2 + rod0_inertia_yy_2 + rod0_base; /* tube0_base_inertia_yy */
    w[46] = 0.5 * rod0_base_mass; /* tube0_inertia */

    /* parameters as they are */
    w[0] = p[8]; /* slide0.position.z [m] */
    w[11] = p[29]; /* rod1.mass [kg] */
    w[12] = p[42]; /* rod2.mass [kg] */
    w[13] = p[55]; /* rod3.mass [kg] */
    w[14] = p[68]; /* rod4.mass [kg] */
    w[15] = p[81]; /* rod5.mass [kg] */
}

#include "lanes.h"

/* M: kinetic energy is 1/2 uᵀ M u */
CARDAN_API int mass_matrix(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const wreal *const w = in->w;
    (void)work;

    /* shared by several: cos, sin */
    const real hooke0_angle2 = q[1]; /* rad */
    const real hooke1_angle2 = q[8]; /* rad */
    const real hooke2_angle2 = q[11]; /* rad */
    const real hooke3_angle2 = q[14]; /* rad */
    const real hooke4_angle2 = q[17]; /* rad */
    const real hooke5_angle2 = q[20]; /* rad */
    const real angle[CARDAN_PADDED(6)] = {hooke5_angle2, hooke4_angle2, hooke3_angle2,
        hooke2_angle2, hooke1_angle2, hooke0_angle2};
    real sine[CARDAN_PADDED(6)], cosine[CARDAN_PADDED(6)];
    cardan_sincos(6, angle, sine, cosine);
    const real hooke5_cos = cosine[0];
    const real hooke5_sin = sine[0];
    const real hooke4_cos = cosine[1];
    const real hooke4_sin = sine[1];
    const real hooke3_cos = cosine[2];
    const real hooke3_sin = sine[2];
    const real hooke2_cos = cosine[3];
    const real hooke2_sin = sine[3];
    const real hooke1_cos = cosine[4];
    const real hooke1_sin = sine[4];
    const real hooke0_cos = cosine[5];
    const real hooke0_sin = sine[5];

    /* tube5: inertia, composite inertia */
    const real slide5_q = q[21]; /* m */
    const wreal tube5_inertia = w[24];
    const wreal rod5_base_moment_z = w[25];
    const wreal tube5_base_inertia_xx = w[26];
    const wreal tube5_base_inertia_yy = w[27];
    const real tube5_inertia_2 = slide5_q * (rod5_base_moment_z + slide5_q * tube5_inertia) * 2.0;
    const real tube5_composite_inertia_xx = tube5_base_inertia_xx + tube5_inertia_2;
    out[418] = tube5_base_inertia_yy + tube5_inertia_2; /* M: hooke5.u.angle2,hooke5.u.angle2 */

    /* tube4: inertia, composite inertia */
    const real slide4_q = q[18]; /* m */
    const wreal tube4_inertia = w[22];
    const wreal rod4_base_moment_z = w[23];
    const wreal tube4_base_inertia_xx = w[29];
    const wreal tube4_base_inertia_yy = w[30];
    const real tube4_inertia_2 = slide4_q * (rod4_base_moment_z + slide4_q * tube4_inertia) * 2.0;
    const real tube4_composite_inertia_xx = tube4_base_inertia_xx + tube4_inertia_2;
    out[352] = tube4_base_inertia_yy + tube4_inertia_2; /* M: hooke4.u.angle2,hooke4.u.angle2 */

    /* tube3: inertia, composite inertia */
    const real slide3_q = q[15]; /* m */
    const wreal tube3_inertia = w[20];
    const wreal rod3_base_moment_z = w[21];
    const wreal tube3_base_inertia_xx = w[32];
    const wreal tube3_base_inertia_yy = w[33];
    const real tube3_inertia_2 = slide3_q * (rod3_base_moment_z + slide3_q * tube3_inertia) * 2.0;
    const real tube3_composite_inertia_xx = tube3_base_inertia_xx + tube3_inertia_2;
    out[286] = tube3_base_inertia_yy + tube3_inertia_2; /* M: hooke3.u.angle2,hooke3.u.angle2 */

    /* tube2: inertia, composite inertia */
    const real slide2_q = q[12]; /* m */
    const wreal tube2_inertia = w[18];
    const wreal rod2_base_moment_z = w[19];
    const wreal tube2_base_inertia_xx = w[35];
    const wreal tube2_base_inertia_yy = w[36];
    const real tube2_inertia_2 = slide2_q * (rod2_base_moment_z + slide2_q * tube2_inertia) * 2.0;
    const real tube2_composite_inertia_xx = tube2_base_inertia_xx + tube2_inertia_2;
    out[220] = tube2_base_inertia_yy + tube2_inertia_2; /* M: hooke2.u.angle2,hooke2.u.angle2 */

    /* tube1: inertia, composite inertia */
    const real slide1_q = q[9]; /* m */
    const wreal tube1_inertia = w[16];
    const wreal rod1_base_moment_z = w[17];
    const wreal tube1_base_inertia_xx = w[38];
    const wreal tube1_base_inertia_yy = w[39];
    const real tube1_inertia_2 = slide1_q * (rod1_base_moment_z + slide1_q * tube1_inertia) * 2.0;
    const real tube1_composite_inertia_xx = tube1_base_inertia_xx + tube1_inertia_2;
    out[154] = tube1_base_inertia_yy + tube1_inertia_2; /* M: hooke1.u.angle2,hooke1.u.angle2 */

    /* ball0: R */
    const real ball0_w = q[3];
    const real ball0_x = q[4];
    const real ball0_y = q[5];
    const real ball0_z = q[6];
    const real ball0_R = 2.0 * ball0_x;
    const real ball0_R_2 = 2.0 * ball0_y;
    const real ball0_R_3 = 2.0 * ball0_z;
    const real ball0_R_4 = ball0_w * ball0_R;
    const real ball0_R_5 = 1.0 - ball0_x * ball0_R;
    const real ball0_R_6 = ball0_w * ball0_R_2;
    const real ball0_R_7 = ball0_w * ball0_R_3;
    const real ball0_R_8 = ball0_x * ball0_R_2;
    const real ball0_R_9 = ball0_y * ball0_R_2;
    const real ball0_R_10 = ball0_x * ball0_R_3;
    const real ball0_R_11 = ball0_y * ball0_R_3;
    const real ball0_R_12 = ball0_z * ball0_R_3;
    const real ball0_R_xx = 1.0 - ball0_R_9 - ball0_R_12;
    const real ball0_R_yy = ball0_R_5 - ball0_R_12;
    const real ball0_R_zz = ball0_R_5 - ball0_R_9;
    const real ball0_R_xy = ball0_R_8 - ball0_R_7;
    const real ball0_R_yx = ball0_R_7 + ball0_R_8;
    const real ball0_R_xz = ball0_R_6 + ball0_R_10;
    const real ball0_R_zx = ball0_R_10 - ball0_R_6;
    const real ball0_R_yz = ball0_R_11 - ball0_R_4;
    const real ball0_R_zy = ball0_R_4 + ball0_R_11;

    /* shared by several: inertia */
    const wreal platform_base_second_moment_xy = w[4];
    const wreal platform_inertia_xz = w[6];
    const wreal platform_inertia_yz = w[7];
    const wreal platform_inertia_xx_2 = w[8];
    const wreal platform_inertia_yy_2 = w[9];
    const wreal platform_inertia_zz_2 = w[10];
    const real rod0_inertia = platform_inertia_xz * ball0_R_xz
        - platform_base_second_moment_xy * ball0_R_xy + platform_inertia_xx_2 * ball0_R_xx;
    const real rod0_inertia_2 = platform_inertia_yy_2 * ball0_R_xy
        + platform_inertia_yz * ball0_R_xz - platform_base_second_moment_xy * ball0_R_xx;
    const real rod0_inertia_3 = platform_inertia_yz * ball0_R_xy
        + platform_inertia_zz_2 * ball0_R_xz + platform_inertia_xz * ball0_R_xx;
    const real rod0_inertia_4 = platform_inertia_xx_2 * ball0_R_yx
        + platform_inertia_xz * ball0_R_yz - platform_base_second_moment_xy * ball0_R_yy;
    const real rod0_inertia_5 = platform_inertia_yz * ball0_R_yz
        - platform_base_second_moment_xy * ball0_R_yx + platform_inertia_yy_2 * ball0_R_yy;
    const real rod0_inertia_6 = platform_inertia_xz * ball0_R_yx
        + platform_inertia_zz_2 * ball0_R_yz + platform_inertia_yz * ball0_R_yy;
    const real rod0_inertia_7 = platform_inertia_xx_2 * ball0_R_zx
        - platform_base_second_moment_xy * ball0_R_zy + platform_inertia_xz * ball0_R_zz;
    const real rod0_inertia_8 = platform_inertia_yy_2 * ball0_R_zy
        - platform_base_second_moment_xy * ball0_R_zx + platform_inertia_yz * ball0_R_zz;
    const real rod0_inertia_9 = platform_inertia_xz * ball0_R_zx
        + platform_inertia_yz * ball0_R_zy + platform_inertia_zz_2 * ball0_R_zz;

    /* rod0: composite inertia, inertia, composite moment */
    const wreal slide0_position_z = w[0]; /* m */
    const wreal ball0_momentum_fz = w[1];
    const wreal ball0_momentum_fx = w[2];
    const wreal platform_first_moment_z = w[3];
    const wreal rod0_base_moment_z = w[42];
    const real rod0_composite_inertia_xy = ball0_R_yx * rod0_inertia
        + ball0_R_yy * rod0_inertia_2 + ball0_R_yz * rod0_inertia_3;
    const real rod0_inertia_10 = ball0_R_zx * rod0_inertia_4 + ball0_R_zy * rod0_inertia_5
        + ball0_R_zz * rod0_inertia_6;
    const real rod0_composite_inertia_zz = ball0_R_zx * rod0_inertia_7
        + ball0_R_zy * rod0_inertia_8 + ball0_R_zz * rod0_inertia_9;
    const real rod0_composite_moment_x = platform_first_moment_z * ball0_R_xz
        - ball0_momentum_fx * ball0_R_xy - ball0_momentum_fz * ball0_R_xx;
    const real rod0_composite_moment_y = platform_first_moment_z * ball0_R_yz
        - ball0_momentum_fz * ball0_R_yx - ball0_momentum_fx * ball0_R_yy;
    const real rod0_inertia_11 = platform_first_moment_z * ball0_R_zz
        - (ball0_momentum_fz * ball0_R_zx + ball0_momentum_fx * ball0_R_zy);
    const real rod0_inertia_12 = slide0_position_z * rod0_inertia_11 * 2.0;
    const real rod0_composite_inertia_xx = ball0_R_xx * rod0_inertia
        + ball0_R_xy * rod0_inertia_2 + (ball0_R_xz * rod0_inertia_3 + rod0_inertia_12);
    const real rod0_composite_inertia_yy = ball0_R_yx * rod0_inertia_4
        + ball0_R_yy * rod0_inertia_5 + (ball0_R_yz * rod0_inertia_6 + rod0_inertia_12);
    const real rod0_composite_moment_z = rod0_base_moment_z + rod0_inertia_11;
    const real rod0_inertia_13 = ball0_R_zz * rod0_inertia_3
        - slide0_position_z * rod0_composite_moment_x;
    const real rod0_composite_inertia_xz = ball0_R_zx * rod0_inertia
        + ball0_R_zy * rod0_inertia_2 + rod0_inertia_13;
    const real rod0_composite_inertia_yz = rod0_inertia_10
        - slide0_position_z * rod0_composite_moment_y;

    /* tube0: composite inertia, inertia */
    const real slide0_q = q[2]; /* m */
    const wreal tube0_base_inertia_xx = w[43];
    const wreal tube0_base_inertia_yy = w[44];
    const wreal tube0_base_inertia_zz = w[45];
    const wreal tube0_inertia = w[46];
    const real tube0_composite_inertia_zz = tube0_base_inertia_zz + rod0_composite_inertia_zz;
    const real tube0_inertia_2 = rod0_composite_inertia_yz + rod0_composite_inertia_yz
        - rod0_composite_inertia_yz;
    const real tube0_inertia_3 = slide0_q * (rod0_composite_moment_z
        + slide0_q * tube0_inertia) * 2.0;
    const real tube0_composite_inertia_xx = tube0_base_inertia_xx + rod0_composite_inertia_xx
        + tube0_inertia_3;
    const real tube0_composite_inertia_xz = rod0_composite_inertia_xz
        - slide0_q * rod0_composite_moment_x;
    const real tube0_composite_inertia_yz = tube0_inertia_2 - slide0_q * rod0_composite_moment_y;
    /* M: hooke0.u.angle2,hooke0.u.angle2 */
    out[22] = tube0_base_inertia_yy + rod0_composite_inertia_yy + tube0_inertia_3;

    /* slide0: momentum my */
    const real slide0_momentum_my = -rod0_composite_moment_x;
    out[23] = slide0_momentum_my; /* M: hooke0.u.angle2,slide0.u */
    out[43] = slide0_momentum_my; /* M: slide0.u,hooke0.u.angle2 */

    /* hooke5: momentum mx, momentum mz */
    const wreal tube5_base_inertia_zz = w[28];
    const real hooke5_momentum_mx = tube5_composite_inertia_xx * hooke5_cos;
    const real hooke5_momentum_mz = tube5_base_inertia_zz * hooke5_sin;

    /* M */
    const real M_4_3 = -(platform_first_moment_z * ball0_R_zy + ball0_momentum_fx * ball0_R_zz);
    const real M_5_3 = platform_first_moment_z * ball0_R_zx + ball0_momentum_fz * ball0_R_zz;
    const real M_6_3 = ball0_momentum_fx * ball0_R_zx - ball0_momentum_fz * ball0_R_zy;
    /* M: hooke5.u.angle1,hooke5.u.angle1 */
    out[396] = hooke5_cos * hooke5_momentum_mx + hooke5_sin * hooke5_momentum_mz;
    out[45] = M_4_3; /* M: slide0.u,ball0.u.x */
    out[65] = M_4_3; /* M: ball0.u.x,slide0.u */
    out[46] = M_5_3; /* M: slide0.u,ball0.u.y */
    out[86] = M_5_3; /* M: ball0.u.y,slide0.u */
    out[47] = M_6_3; /* M: slide0.u,ball0.u.z */
    out[107] = M_6_3; /* M: ball0.u.z,slide0.u */

    /* hooke4: momentum mx, momentum mz */
    const wreal tube4_base_inertia_zz = w[31];
    const real hooke4_momentum_mx = tube4_composite_inertia_xx * hooke4_cos;
    const real hooke4_momentum_mz = tube4_base_inertia_zz * hooke4_sin;

    /* M */
    /* M: hooke4.u.angle1,hooke4.u.angle1 */
    out[330] = hooke4_cos * hooke4_momentum_mx + hooke4_sin * hooke4_momentum_mz;

    /* hooke3: momentum mx, momentum mz */
    const wreal tube3_base_inertia_zz = w[34];
    const real hooke3_momentum_mx = tube3_composite_inertia_xx * hooke3_cos;
    const real hooke3_momentum_mz = tube3_base_inertia_zz * hooke3_sin;

    /* M */
    /* M: hooke3.u.angle1,hooke3.u.angle1 */
    out[264] = hooke3_cos * hooke3_momentum_mx + hooke3_sin * hooke3_momentum_mz;

    /* hooke2: momentum mx, momentum mz */
    const wreal tube2_base_inertia_zz = w[37];
    const real hooke2_momentum_mx = tube2_composite_inertia_xx * hooke2_cos;
    const real hooke2_momentum_mz = tube2_base_inertia_zz * hooke2_sin;

    /* M */
    /* M: hooke2.u.angle1,hooke2.u.angle1 */
    out[198] = hooke2_cos * hooke2_momentum_mx + hooke2_sin * hooke2_momentum_mz;

    /* hooke1: momentum mx, momentum mz */
    const wreal tube1_base_inertia_zz = w[40];
    const real hooke1_momentum_mx = tube1_composite_inertia_xx * hooke1_cos;
    const real hooke1_momentum_mz = tube1_base_inertia_zz * hooke1_sin;

    /* M */
    /* M: hooke1.u.angle1,hooke1.u.angle1 */
    out[132] = hooke1_cos * hooke1_momentum_mx + hooke1_sin * hooke1_momentum_mz;

    /* platform: momentum */
    const real platform_momentum = platform_first_moment_z * ball0_R_xy
        + ball0_momentum_fx * ball0_R_xz;
    const real platform_momentum_2 = platform_first_moment_z * ball0_R_yy
        + ball0_momentum_fx * ball0_R_yz;
    const real platform_momentum_3 = platform_first_moment_z * ball0_R_xx
        + ball0_momentum_fz * ball0_R_xz;
    const real platform_momentum_4 = ball0_momentum_fx * ball0_R_xx
        - ball0_momentum_fz * ball0_R_xy;
    const real platform_momentum_5 = platform_first_moment_z * ball0_R_yx
        + ball0_momentum_fz * ball0_R_yz;
    const real platform_momentum_6 = ball0_momentum_fx * ball0_R_yx
        - ball0_momentum_fz * ball0_R_yy;

    /* M */
    const real M_4_2 = rod0_inertia_4 - slide0_position_z * platform_momentum
        - slide0_q * platform_momentum;
    const real M_4_1 = (rod0_inertia + slide0_position_z * platform_momentum_2
        + slide0_q * platform_momentum_2) * hooke0_cos + rod0_inertia_7 * hooke0_sin;
    const real M_5_1 = hooke0_cos * (rod0_inertia_2 - slide0_position_z * platform_momentum_5
        - slide0_q * platform_momentum_5) + rod0_inertia_8 * hooke0_sin;
    const real M_5_2 = rod0_inertia_5 + slide0_position_z * platform_momentum_3
        + slide0_q * platform_momentum_3;
    const real M_6_1 = hooke0_cos * (rod0_inertia_3 - slide0_position_z * platform_momentum_6
        - slide0_q * platform_momentum_6) + rod0_inertia_9 * hooke0_sin;
    const real M_6_2 = rod0_inertia_6 + slide0_position_z * platform_momentum_4
        + slide0_q * platform_momentum_4;
    out[24] = M_4_2; /* M: hooke0.u.angle2,ball0.u.x */
    out[64] = M_4_2; /* M: ball0.u.x,hooke0.u.angle2 */
    out[3] = M_4_1; /* M: hooke0.u.angle1,ball0.u.x */
    out[63] = M_4_1; /* M: ball0.u.x,hooke0.u.angle1 */
    out[4] = M_5_1; /* M: hooke0.u.angle1,ball0.u.y */
    out[84] = M_5_1; /* M: ball0.u.y,hooke0.u.angle1 */
    out[25] = M_5_2; /* M: hooke0.u.angle2,ball0.u.y */
    out[85] = M_5_2; /* M: ball0.u.y,hooke0.u.angle2 */
    out[5] = M_6_1; /* M: hooke0.u.angle1,ball0.u.z */
    out[105] = M_6_1; /* M: ball0.u.z,hooke0.u.angle1 */
    out[26] = M_6_2; /* M: hooke0.u.angle2,ball0.u.z */
    out[106] = M_6_2; /* M: ball0.u.z,hooke0.u.angle2 */

    /* hooke0: momentum fz, momentum my, momentum mx, momentum mz */
    const real hooke0_momentum_fz = rod0_composite_moment_y * hooke0_cos;
    const real hooke0_momentum_my = rod0_composite_inertia_xy * hooke0_cos
        + tube0_composite_inertia_yz * hooke0_sin;
    const real hooke0_momentum_mx = tube0_composite_inertia_xx * hooke0_cos
        + tube0_composite_inertia_xz * hooke0_sin;
    const real hooke0_momentum_mz = tube0_composite_inertia_xz * hooke0_cos
        + tube0_composite_inertia_zz * hooke0_sin;
    out[2] = hooke0_momentum_fz; /* M: hooke0.u.angle1,slide0.u */
    out[42] = hooke0_momentum_fz; /* M: slide0.u,hooke0.u.angle1 */
    out[1] = hooke0_momentum_my; /* M: hooke0.u.angle1,hooke0.u.angle2 */
    out[21] = hooke0_momentum_my; /* M: hooke0.u.angle2,hooke0.u.angle1 */

    /* M */
    /* M: hooke0.u.angle1,hooke0.u.angle1 */
    out[0] = hooke0_cos * hooke0_momentum_mx + hooke0_sin * hooke0_momentum_mz;

    /* results that are numbers or inputs */
    out[6] = CARDAN_REAL(0.0); /* M: hooke0.u.angle1,hooke1.u.angle1 */
    out[7] = CARDAN_REAL(0.0); /* M: hooke0.u.angle1,hooke1.u.angle2 */
    out[8] = CARDAN_REAL(0.0); /* M: hooke0.u.angle1,slide1.u */
    out[9] = CARDAN_REAL(0.0); /* M: hooke0.u.angle1,hooke2.u.angle1 */
    out[10] = CARDAN_REAL(0.0); /* M: hooke0.u.angle1,hooke2.u.angle2 */
    out[11] = CARDAN_REAL(0.0); /* M: hooke0.u.angle1,slide2.u */
    out[12] = CARDAN_REAL(0.0); /* M: hooke0.u.angle1,hooke3.u.angle1 */
    out[13] = CARDAN_REAL(0.0); /* M: hooke0.u.angle1,hooke3.u.angle2 */
    out[14] = CARDAN_REAL(0.0); /* M: hooke0.u.angle1,slide3.u */
    out[15] = CARDAN_REAL(0.0); /* M: hooke0.u.angle1,hooke4.u.angle1 */
    out[16] = CARDAN_REAL(0.0); /* M: hooke0.u.angle1,hooke4.u.angle2 */
    out[17] = CARDAN_REAL(0.0); /* M: hooke0.u.angle1,slide4.u */
    out[18] = CARDAN_REAL(0.0); /* M: hooke0.u.angle1,hooke5.u.angle1 */
    out[19] = CARDAN_REAL(0.0); /* M: hooke0.u.angle1,hooke5.u.angle2 */
    out[20] = CARDAN_REAL(0.0); /* M: hooke0.u.angle1,slide5.u */
    out[27] = CARDAN_REAL(0.0); /* M: hooke0.u.angle2,hooke1.u.angle1 */
    out[28] = CARDAN_REAL(0.0); /* M: hooke0.u.angle2,hooke1.u.angle2 */
    out[29] = CARDAN_REAL(0.0); /* M: hooke0.u.angle2,slide1.u */
    out[30] = CARDAN_REAL(0.0); /* M: hooke0.u.angle2,hooke2.u.angle1 */
    out[31] = CARDAN_REAL(0.0); /* M: hooke0.u.angle2,hooke2.u.angle2 */
    out[32] = CARDAN_REAL(0.0); /* M: hooke0.u.angle2,slide2.u */
    out[33] = CARDAN_REAL(0.0); /* M: hooke0.u.angle2,hooke3.u.angle1 */
    out[34] = CARDAN_REAL(0.0); /* M: hooke0.u.angle2,hooke3.u.angle2 */
    out[35] = CARDAN_REAL(0.0); /* M: hooke0.u.angle2,slide3.u */
    out[36] = CARDAN_REAL(0.0); /* M: hooke0.u.angle2,hooke4.u.angle1 */
    out[37] = CARDAN_REAL(0.0); /* M: hooke0.u.angle2,hooke4.u.angle2 */
    out[38] = CARDAN_REAL(0.0); /* M: hooke0.u.angle2,slide4.u */
    out[39] = CARDAN_REAL(0.0); /* M: hooke0.u.angle2,hooke5.u.angle1 */
    out[40] = CARDAN_REAL(0.0); /* M: hooke0.u.angle2,hooke5.u.angle2 */
    out[41] = CARDAN_REAL(0.0); /* M: hooke0.u.angle2,slide5.u */
    out[44] = CARDAN_REAL(w[41]); /* M: slide0.u,slide0.u */
    out[48] = CARDAN_REAL(0.0); /* M: slide0.u,hooke1.u.angle1 */
    out[49] = CARDAN_REAL(0.0); /* M: slide0.u,hooke1.u.angle2 */
    out[50] = CARDAN_REAL(0.0); /* M: slide0.u,slide1.u */
    out[51] = CARDAN_REAL(0.0); /* M: slide0.u,hooke2.u.angle1 */
    out[52] = CARDAN_REAL(0.0); /* M: slide0.u,hooke2.u.angle2 */
    out[53] = CARDAN_REAL(0.0); /* M: slide0.u,slide2.u */
    out[54] = CARDAN_REAL(0.0); /* M: slide0.u,hooke3.u.angle1 */
    out[55] = CARDAN_REAL(0.0); /* M: slide0.u,hooke3.u.angle2 */
    out[56] = CARDAN_REAL(0.0); /* M: slide0.u,slide3.u */
    out[57] = CARDAN_REAL(0.0); /* M: slide0.u,hooke4.u.angle1 */
    out[58] = CARDAN_REAL(0.0); /* M: slide0.u,hooke4.u.angle2 */
    out[59] = CARDAN_REAL(0.0); /* M: slide0.u,slide4.u */
    out[60] = CARDAN_REAL(0.0); /* M: slide0.u,hooke5.u.angle1 */
    out[61] = CARDAN_REAL(0.0); /* M: slide0.u,hooke5.u.angle2 */
    out[62] = CARDAN_REAL(0.0); /* M: slide0.u,slide5.u */
    out[66] = CARDAN_REAL(w[8]); /* M: ball0.u.x,ball0.u.x */
    out[67] = CARDAN_REAL(w[5]); /* M: ball0.u.x,ball0.u.y */
    out[68] = CARDAN_REAL(w[6]); /* M: ball0.u.x,ball0.u.z */
    out[69] = CARDAN_REAL(0.0); /* M: ball0.u.x,hooke1.u.angle1 */
    out[70] = CARDAN_REAL(0.0); /* M: ball0.u.x,hooke1.u.angle2 */
    out[71] = CARDAN_REAL(0.0); /* M: ball0.u.x,slide1.u */
    out[72] = CARDAN_REAL(0.0); /* M: ball0.u.x,hooke2.u.angle1 */
    out[73] = CARDAN_REAL(0.0); /* M: ball0.u.x,hooke2.u.angle2 */
    out[74] = CARDAN_REAL(0.0); /* M: ball0.u.x,slide2.u */
    out[75] = CARDAN_REAL(0.0); /* M: ball0.u.x,hooke3.u.angle1 */
    out[76] = CARDAN_REAL(0.0); /* M: ball0.u.x,hooke3.u.angle2 */
    out[77] = CARDAN_REAL(0.0); /* M: ball0.u.x,slide3.u */
    out[78] = CARDAN_REAL(0.0); /* M: ball0.u.x,hooke4.u.angle1 */
    out[79] = CARDAN_REAL(0.0); /* M: ball0.u.x,hooke4.u.angle2 */
    out[80] = CARDAN_REAL(0.0); /* M: ball0.u.x,slide4.u */
    out[81] = CARDAN_REAL(0.0); /* M: ball0.u.x,hooke5.u.angle1 */
    out[82] = CARDAN_REAL(0.0); /* M: ball0.u.x,hooke5.u.angle2 */
    out[83] = CARDAN_REAL(0.0); /* M: ball0.u.x,slide5.u */
    out[87] = CARDAN_REAL(w[5]); /* M: ball0.u.y,ball0.u.x */
    out[88] = CARDAN_REAL(w[9]); /* M: ball0.u.y,ball0.u.y */
    out[89] = CARDAN_REAL(w[7]); /* M: ball0.u.y,ball0.u.z */
    out[90] = CARDAN_REAL(0.0); /* M: ball0.u.y,hooke1.u.angle1 */
    out[91] = CARDAN_REAL(0.0); /* M: ball0.u.y,hooke1.u.angle2 */
    out[92] = CARDAN_REAL(0.0); /* M: ball0.u.y,slide1.u */
    out[93] = CARDAN_REAL(0.0); /* M: ball0.u.y,hooke2.u.angle1 */
    out[94] = CARDAN_REAL(0.0); /* M: ball0.u.y,hooke2.u.angle2 */
    out[95] = CARDAN_REAL(0.0); /* M: ball0.u.y,slide2.u */
    out[96] = CARDAN_REAL(0.0); /* M: ball0.u.y,hooke3.u.angle1 */
    out[97] = CARDAN_REAL(0.0); /* M: ball0.u.y,hooke3.u.angle2 */
    out[98] = CARDAN_REAL(0.0); /* M: ball0.u.y,slide3.u */
    out[99] = CARDAN_REAL(0.0); /* M: ball0.u.y,hooke4.u.angle1 */
    out[100] = CARDAN_REAL(0.0); /* M: ball0.u.y,hooke4.u.angle2 */
    out[101] = CARDAN_REAL(0.0); /* M: ball0.u.y,slide4.u */
    out[102] = CARDAN_REAL(0.0); /* M: ball0.u.y,hooke5.u.angle1 */
    out[103] = CARDAN_REAL(0.0); /* M: ball0.u.y,hooke5.u.angle2 */
    out[104] = CARDAN_REAL(0.0); /* M: ball0.u.y,slide5.u */
    out[108] = CARDAN_REAL(w[6]); /* M: ball0.u.z,ball0.u.x */
    out[109] = CARDAN_REAL(w[7]); /* M: ball0.u.z,ball0.u.y */
    out[110] = CARDAN_REAL(w[10]); /* M: ball0.u.z,ball0.u.z */
    out[111] = CARDAN_REAL(0.0); /* M: ball0.u.z,hooke1.u.angle1 */
    out[112] = CARDAN_REAL(0.0); /* M: ball0.u.z,hooke1.u.angle2 */
    out[113] = CARDAN_REAL(0.0); /* M: ball0.u.z,slide1.u */
    out[114] = CARDAN_REAL(0.0); /* M: ball0.u.z,hooke2.u.angle1 */
    out[115] = CARDAN_REAL(0.0); /* M: ball0.u.z,hooke2.u.angle2 */
    out[116] = CARDAN_REAL(0.0); /* M: ball0.u.z,slide2.u */
    out[117] = CARDAN_REAL(0.0); /* M: ball0.u.z,hooke3.u.angle1 */
    out[118] = CARDAN_REAL(0.0); /* M: ball0.u.z,hooke3.u.angle2 */
    out[119] = CARDAN_REAL(0.0); /* M: ball0.u.z,slide3.u */
    out[120] = CARDAN_REAL(0.0); /* M: ball0.u.z,hooke4.u.angle1 */
    out[121] = CARDAN_REAL(0.0); /* M: ball0.u.z,hooke4.u.angle2 */
    out[122] = CARDAN_REAL(0.0); /* M: ball0.u.z,slide4.u */
    out[123] = CARDAN_REAL(0.0); /* M: ball0.u.z,hooke5.u.angle1 */
    out[124] = CARDAN_REAL(0.0); /* M: ball0.u.z,hooke5.u.angle2 */
    out[125] = CARDAN_REAL(0.0); /* M: ball0.u.z,slide5.u */
    out[126] = CARDAN_REAL(0.0); /* M: hooke1.u.angle1,hooke0.u.angle1 */
    out[127] = CARDAN_REAL(0.0); /* M: hooke1.u.angle1,hooke0.u.angle2 */
    out[128] = CARDAN_REAL(0.0); /* M: hooke1.u.angle1,slide0.u */
    out[129] = CARDAN_REAL(0.0); /* M: hooke1.u.angle1,ball0.u.x */
    out[130] = CARDAN_REAL(0.0); /* M: hooke1.u.angle1,ball0.u.y */
    out[131] = CARDAN_REAL(0.0); /* M: hooke1.u.angle1,ball0.u.z */
    out[133] = CARDAN_REAL(0.0); /* M: hooke1.u.angle1,hooke1.u.angle2 */
    out[134] = CARDAN_REAL(0.0); /* M: hooke1.u.angle1,slide1.u */
    out[135] = CARDAN_REAL(0.0); /* M: hooke1.u.angle1,hooke2.u.angle1 */
    out[136] = CARDAN_REAL(0.0); /* M: hooke1.u.angle1,hooke2.u.angle2 */
    out[137] = CARDAN_REAL(0.0); /* M: hooke1.u.angle1,slide2.u */
    out[138] = CARDAN_REAL(0.0); /* M: hooke1.u.angle1,hooke3.u.angle1 */
    out[139] = CARDAN_REAL(0.0); /* M: hooke1.u.angle1,hooke3.u.angle2 */
    out[140] = CARDAN_REAL(0.0); /* M: hooke1.u.angle1,slide3.u */
    out[141] = CARDAN_REAL(0.0); /* M: hooke1.u.angle1,hooke4.u.angle1 */
    out[142] = CARDAN_REAL(0.0); /* M: hooke1.u.angle1,hooke4.u.angle2 */
    out[143] = CARDAN_REAL(0.0); /* M: hooke1.u.angle1,slide4.u */
    out[144] = CARDAN_REAL(0.0); /* M: hooke1.u.angle1,hooke5.u.angle1 */
    out[145] = CARDAN_REAL(0.0); /* M: hooke1.u.angle1,hooke5.u.angle2 */
    out[146] = CARDAN_REAL(0.0); /* M: hooke1.u.angle1,slide5.u */
    out[147] = CARDAN_REAL(0.0); /* M: hooke1.u.angle2,hooke0.u.angle1 */
    out[148] = CARDAN_REAL(0.0); /* M: hooke1.u.angle2,hooke0.u.angle2 */
    out[149] = CARDAN_REAL(0.0); /* M: hooke1.u.angle2,slide0.u */
    out[150] = CARDAN_REAL(0.0); /* M: hooke1.u.angle2,ball0.u.x */
    out[151] = CARDAN_REAL(0.0); /* M: hooke1.u.angle2,ball0.u.y */
    out[152] = CARDAN_REAL(0.0); /* M: hooke1.u.angle2,ball0.u.z */
    out[153] = CARDAN_REAL(0.0); /* M: hooke1.u.angle2,hooke1.u.angle1 */
    out[155] = CARDAN_REAL(0.0); /* M: hooke1.u.angle2,slide1.u */
    out[156] = CARDAN_REAL(0.0); /* M: hooke1.u.angle2,hooke2.u.angle1 */
    out[157] = CARDAN_REAL(0.0); /* M: hooke1.u.angle2,hooke2.u.angle2 */
    out[158] = CARDAN_REAL(0.0); /* M: hooke1.u.angle2,slide2.u */
    out[159] = CARDAN_REAL(0.0); /* M: hooke1.u.angle2,hooke3.u.angle1 */
    out[160] = CARDAN_REAL(0.0); /* M: hooke1.u.angle2,hooke3.u.angle2 */
    out[161] = CARDAN_REAL(0.0); /* M: hooke1.u.angle2,slide3.u */
    out[162] = CARDAN_REAL(0.0); /* M: hooke1.u.angle2,hooke4.u.angle1 */
    out[163] = CARDAN_REAL(0.0); /* M: hooke1.u.angle2,hooke4.u.angle2 */
    out[164] = CARDAN_REAL(0.0); /* M: hooke1.u.angle2,slide4.u */
    out[165] = CARDAN_REAL(0.0); /* M: hooke1.u.angle2,hooke5.u.angle1 */
    out[166] = CARDAN_REAL(0.0); /* M: hooke1.u.angle2,hooke5.u.angle2 */
    out[167] = CARDAN_REAL(0.0); /* M: hooke1.u.angle2,slide5.u */
    out[168] = CARDAN_REAL(0.0); /* M: slide1.u,hooke0.u.angle1 */
    out[169] = CARDAN_REAL(0.0); /* M: slide1.u,hooke0.u.angle2 */
    out[170] = CARDAN_REAL(0.0); /* M: slide1.u,slide0.u */
    out[171] = CARDAN_REAL(0.0); /* M: slide1.u,ball0.u.x */
    out[172] = CARDAN_REAL(0.0); /* M: slide1.u,ball0.u.y */
    out[173] = CARDAN_REAL(0.0); /* M: slide1.u,ball0.u.z */
    out[174] = CARDAN_REAL(0.0); /* M: slide1.u,hooke1.u.angle1 */
    out[175] = CARDAN_REAL(0.0); /* M: slide1.u,hooke1.u.angle2 */
    out[176] = CARDAN_REAL(w[11]); /* M: slide1.u,slide1.u */
    out[177] = CARDAN_REAL(0.0); /* M: slide1.u,hooke2.u.angle1 */
    out[178] = CARDAN_REAL(0.0); /* M: slide1.u,hooke2.u.angle2 */
    out[179] = CARDAN_REAL(0.0); /* M: slide1.u,slide2.u */
    out[180] = CARDAN_REAL(0.0); /* M: slide1.u,hooke3.u.angle1 */
    out[181] = CARDAN_REAL(0.0); /* M: slide1.u,hooke3.u.angle2 */
    out[182] = CARDAN_REAL(0.0); /* M: slide1.u,slide3.u */
    out[183] = CARDAN_REAL(0.0); /* M: slide1.u,hooke4.u.angle1 */
    out[184] = CARDAN_REAL(0.0); /* M: slide1.u,hooke4.u.angle2 */
    out[185] = CARDAN_REAL(0.0); /* M: slide1.u,slide4.u */
    out[186] = CARDAN_REAL(0.0); /* M: slide1.u,hooke5.u.angle1 */
    out[187] = CARDAN_REAL(0.0); /* M: slide1.u,hooke5.u.angle2 */
    out[188] = CARDAN_REAL(0.0); /* M: slide1.u,slide5.u */
    out[189] = CARDAN_REAL(0.0); /* M: hooke2.u.angle1,hooke0.u.angle1 */
    out[190] = CARDAN_REAL(0.0); /* M: hooke2.u.angle1,hooke0.u.angle2 */
    out[191] = CARDAN_REAL(0.0); /* M: hooke2.u.angle1,slide0.u */
    out[192] = CARDAN_REAL(0.0); /* M: hooke2.u.angle1,ball0.u.x */
    out[193] = CARDAN_REAL(0.0); /* M: hooke2.u.angle1,ball0.u.y */
    out[194] = CARDAN_REAL(0.0); /* M: hooke2.u.angle1,ball0.u.z */
    out[195] = CARDAN_REAL(0.0); /* M: hooke2.u.angle1,hooke1.u.angle1 */
    out[196] = CARDAN_REAL(0.0); /* M: hooke2.u.angle1,hooke1.u.angle2 */
    out[197] = CARDAN_REAL(0.0); /* M: hooke2.u.angle1,slide1.u */
    out[199] = CARDAN_REAL(0.0); /* M: hooke2.u.angle1,hooke2.u.angle2 */
    out[200] = CARDAN_REAL(0.0); /* M: hooke2.u.angle1,slide2.u */
    out[201] = CARDAN_REAL(0.0); /* M: hooke2.u.angle1,hooke3.u.angle1 */
    out[202] = CARDAN_REAL(0.0); /* M: hooke2.u.angle1,hooke3.u.angle2 */
    out[203] = CARDAN_REAL(0.0); /* M: hooke2.u.angle1,slide3.u */
    out[204] = CARDAN_REAL(0.0); /* M: hooke2.u.angle1,hooke4.u.angle1 */
    out[205] = CARDAN_REAL(0.0); /* M: hooke2.u.angle1,hooke4.u.angle2 */
    out[206] = CARDAN_REAL(0.0); /* M: hooke2.u.angle1,slide4.u */
    out[207] = CARDAN_REAL(0.0); /* M: hooke2.u.angle1,hooke5.u.angle1 */
    out[208] = CARDAN_REAL(0.0); /* M: hooke2.u.angle1,hooke5.u.angle2 */
    out[209] = CARDAN_REAL(0.0); /* M: hooke2.u.angle1,slide5.u */
    out[210] = CARDAN_REAL(0.0); /* M: hooke2.u.angle2,hooke0.u.angle1 */
    out[211] = CARDAN_REAL(0.0); /* M: hooke2.u.angle2,hooke0.u.angle2 */
    out[212] = CARDAN_REAL(0.0); /* M: hooke2.u.angle2,slide0.u */
    out[213] = CARDAN_REAL(0.0); /* M: hooke2.u.angle2,ball0.u.x */
    out[214] = CARDAN_REAL(0.0); /* M: hooke2.u.angle2,ball0.u.y */
    out[215] = CARDAN_REAL(0.0); /* M: hooke2.u.angle2,ball0.u.z */
    out[216] = CARDAN_REAL(0.0); /* M: hooke2.u.angle2,hooke1.u.angle1 */
    out[217] = CARDAN_REAL(0.0); /* M: hooke2.u.angle2,hooke1.u.angle2 */
    out[218] = CARDAN_REAL(0.0); /* M: hooke2.u.angle2,slide1.u */
    out[219] = CARDAN_REAL(0.0); /* M: hooke2.u.angle2,hooke2.u.angle1 */
    out[221] = CARDAN_REAL(0.0); /* M: hooke2.u.angle2,slide2.u */
    out[222] = CARDAN_REAL(0.0); /* M: hooke2.u.angle2,hooke3.u.angle1 */
    out[223] = CARDAN_REAL(0.0); /* M: hooke2.u.angle2,hooke3.u.angle2 */
    out[224] = CARDAN_REAL(0.0); /* M: hooke2.u.angle2,slide3.u */
    out[225] = CARDAN_REAL(0.0); /* M: hooke2.u.angle2,hooke4.u.angle1 */
    out[226] = CARDAN_REAL(0.0); /* M: hooke2.u.angle2,hooke4.u.angle2 */
    out[227] = CARDAN_REAL(0.0); /* M: hooke2.u.angle2,slide4.u */
    out[228] = CARDAN_REAL(0.0); /* M: hooke2.u.angle2,hooke5.u.angle1 */
    out[229] = CARDAN_REAL(0.0); /* M: hooke2.u.angle2,hooke5.u.angle2 */
    out[230] = CARDAN_REAL(0.0); /* M: hooke2.u.angle2,slide5.u */
    out[231] = CARDAN_REAL(0.0); /* M: slide2.u,hooke0.u.angle1 */
    out[232] = CARDAN_REAL(0.0); /* M: slide2.u,hooke0.u.angle2 */
    out[233] = CARDAN_REAL(0.0); /* M: slide2.u,slide0.u */
    out[234] = CARDAN_REAL(0.0); /* M: slide2.u,ball0.u.x */
    out[235] = CARDAN_REAL(0.0); /* M: slide2.u,ball0.u.y */
    out[236] = CARDAN_REAL(0.0); /* M: slide2.u,ball0.u.z */
    out[237] = CARDAN_REAL(0.0); /* M: slide2.u,hooke1.u.angle1 */
    out[238] = CARDAN_REAL(0.0); /* M: slide2.u,hooke1.u.angle2 */
    out[239] = CARDAN_REAL(0.0); /* M: slide2.u,slide1.u */
    out[240] = CARDAN_REAL(0.0); /* M: slide2.u,hooke2.u.angle1 */
    out[241] = CARDAN_REAL(0.0); /* M: slide2.u,hooke2.u.angle2 */
    out[242] = CARDAN_REAL(w[12]); /* M: slide2.u,slide2.u */
    out[243] = CARDAN_REAL(0.0); /* M: slide2.u,hooke3.u.angle1 */
    out[244] = CARDAN_REAL(0.0); /* M: slide2.u,hooke3.u.angle2 */
    out[245] = CARDAN_REAL(0.0); /* M: slide2.u,slide3.u */
    out[246] = CARDAN_REAL(0.0); /* M: slide2.u,hooke4.u.angle1 */
    out[247] = CARDAN_REAL(0.0); /* M: slide2.u,hooke4.u.angle2 */
    out[248] = CARDAN_REAL(0.0); /* M: slide2.u,slide4.u */
    out[249] = CARDAN_REAL(0.0); /* M: slide2.u,hooke5.u.angle1 */
    out[250] = CARDAN_REAL(0.0); /* M: slide2.u,hooke5.u.angle2 */
    out[251] = CARDAN_REAL(0.0); /* M: slide2.u,slide5.u */
    out[252] = CARDAN_REAL(0.0); /* M: hooke3.u.angle1,hooke0.u.angle1 */
    out[253] = CARDAN_REAL(0.0); /* M: hooke3.u.angle1,hooke0.u.angle2 */
    out[254] = CARDAN_REAL(0.0); /* M: hooke3.u.angle1,slide0.u */
    out[255] = CARDAN_REAL(0.0); /* M: hooke3.u.angle1,ball0.u.x */
    out[256] = CARDAN_REAL(0.0); /* M: hooke3.u.angle1,ball0.u.y */
    out[257] = CARDAN_REAL(0.0); /* M: hooke3.u.angle1,ball0.u.z */
    out[258] = CARDAN_REAL(0.0); /* M: hooke3.u.angle1,hooke1.u.angle1 */
    out[259] = CARDAN_REAL(0.0); /* M: hooke3.u.angle1,hooke1.u.angle2 */
    out[260] = CARDAN_REAL(0.0); /* M: hooke3.u.angle1,slide1.u */
    out[261] = CARDAN_REAL(0.0); /* M: hooke3.u.angle1,hooke2.u.angle1 */
    out[262] = CARDAN_REAL(0.0); /* M: hooke3.u.angle1,hooke2.u.angle2 */
    out[263] = CARDAN_REAL(0.0); /* M: hooke3.u.angle1,slide2.u */
    out[265] = CARDAN_REAL(0.0); /* M: hooke3.u.angle1,hooke3.u.angle2 */
    out[266] = CARDAN_REAL(0.0); /* M: hooke3.u.angle1,slide3.u */
    out[267] = CARDAN_REAL(0.0); /* M: hooke3.u.angle1,hooke4.u.angle1 */
    out[268] = CARDAN_REAL(0.0); /* M: hooke3.u.angle1,hooke4.u.angle2 */
    out[269] = CARDAN_REAL(0.0); /* M: hooke3.u.angle1,slide4.u */
    out[270] = CARDAN_REAL(0.0); /* M: hooke3.u.angle1,hooke5.u.angle1 */
    out[271] = CARDAN_REAL(0.0); /* M: hooke3.u.angle1,hooke5.u.angle2 */
    out[272] = CARDAN_REAL(0.0); /* M: hooke3.u.angle1,slide5.u */
    out[273] = CARDAN_REAL(0.0); /* M: hooke3.u.angle2,hooke0.u.angle1 */
    out[274] = CARDAN_REAL(0.0); /* M: hooke3.u.angle2,hooke0.u.angle2 */
    out[275] = CARDAN_REAL(0.0); /* M: hooke3.u.angle2,slide0.u */
    out[276] = CARDAN_REAL(0.0); /* M: hooke3.u.angle2,ball0.u.x */
    out[277] = CARDAN_REAL(0.0); /* M: hooke3.u.angle2,ball0.u.y */
    out[278] = CARDAN_REAL(0.0); /* M: hooke3.u.angle2,ball0.u.z */
    out[279] = CARDAN_REAL(0.0); /* M: hooke3.u.angle2,hooke1.u.angle1 */
    out[280] = CARDAN_REAL(0.0); /* M: hooke3.u.angle2,hooke1.u.angle2 */
    out[281] = CARDAN_REAL(0.0); /* M: hooke3.u.angle2,slide1.u */
    out[282] = CARDAN_REAL(0.0); /* M: hooke3.u.angle2,hooke2.u.angle1 */
    out[283] = CARDAN_REAL(0.0); /* M: hooke3.u.angle2,hooke2.u.angle2 */
    out[284] = CARDAN_REAL(0.0); /* M: hooke3.u.angle2,slide2.u */
    out[285] = CARDAN_REAL(0.0); /* M: hooke3.u.angle2,hooke3.u.angle1 */
    out[287] = CARDAN_REAL(0.0); /* M: hooke3.u.angle2,slide3.u */
    out[288] = CARDAN_REAL(0.0); /* M: hooke3.u.angle2,hooke4.u.angle1 */
    out[289] = CARDAN_REAL(0.0); /* M: hooke3.u.angle2,hooke4.u.angle2 */
    out[290] = CARDAN_REAL(0.0); /* M: hooke3.u.angle2,slide4.u */
    out[291] = CARDAN_REAL(0.0); /* M: hooke3.u.angle2,hooke5.u.angle1 */
    out[292] = CARDAN_REAL(0.0); /* M: hooke3.u.angle2,hooke5.u.angle2 */
    out[293] = CARDAN_REAL(0.0); /* M: hooke3.u.angle2,slide5.u */
    out[294] = CARDAN_REAL(0.0); /* M: slide3.u,hooke0.u.angle1 */
    out[295] = CARDAN_REAL(0.0); /* M: slide3.u,hooke0.u.angle2 */
    out[296] = CARDAN_REAL(0.0); /* M: slide3.u,slide0.u */
    out[297] = CARDAN_REAL(0.0); /* M: slide3.u,ball0.u.x */
    out[298] = CARDAN_REAL(0.0); /* M: slide3.u,ball0.u.y */
    out[299] = CARDAN_REAL(0.0); /* M: slide3.u,ball0.u.z */
    out[300] = CARDAN_REAL(0.0); /* M: slide3.u,hooke1.u.angle1 */
    out[301] = CARDAN_REAL(0.0); /* M: slide3.u,hooke1.u.angle2 */
    out[302] = CARDAN_REAL(0.0); /* M: slide3.u,slide1.u */
    out[303] = CARDAN_REAL(0.0); /* M: slide3.u,hooke2.u.angle1 */
    out[304] = CARDAN_REAL(0.0); /* M: slide3.u,hooke2.u.angle2 */
    out[305] = CARDAN_REAL(0.0); /* M: slide3.u,slide2.u */
    out[306] = CARDAN_REAL(0.0); /* M: slide3.u,hooke3.u.angle1 */
    out[307] = CARDAN_REAL(0.0); /* M: slide3.u,hooke3.u.angle2 */
    out[308] = CARDAN_REAL(w[13]); /* M: slide3.u,slide3.u */
    out[309] = CARDAN_REAL(0.0); /* M: slide3.u,hooke4.u.angle1 */
    out[310] = CARDAN_REAL(0.0); /* M: slide3.u,hooke4.u.angle2 */
    out[311] = CARDAN_REAL(0.0); /* M: slide3.u,slide4.u */
    out[312] = CARDAN_REAL(0.0); /* M: slide3.u,hooke5.u.angle1 */
    out[313] = CARDAN_REAL(0.0); /* M: slide3.u,hooke5.u.angle2 */
    out[314] = CARDAN_REAL(0.0); /* M: slide3.u,slide5.u */
    out[315] = CARDAN_REAL(0.0); /* M: hooke4.u.angle1,hooke0.u.angle1 */
    out[316] = CARDAN_REAL(0.0); /* M: hooke4.u.angle1,hooke0.u.angle2 */
    out[317] = CARDAN_REAL(0.0); /* M: hooke4.u.angle1,slide0.u */
    out[318] = CARDAN_REAL(0.0); /* M: hooke4.u.angle1,ball0.u.x */
    out[319] = CARDAN_REAL(0.0); /* M: hooke4.u.angle1,ball0.u.y */
    out[320] = CARDAN_REAL(0.0); /* M: hooke4.u.angle1,ball0.u.z */
    out[321] = CARDAN_REAL(0.0); /* M: hooke4.u.angle1,hooke1.u.angle1 */
    out[322] = CARDAN_REAL(0.0); /* M: hooke4.u.angle1,hooke1.u.angle2 */
    out[323] = CARDAN_REAL(0.0); /* M: hooke4.u.angle1,slide1.u */
    out[324] = CARDAN_REAL(0.0); /* M: hooke4.u.angle1,hooke2.u.angle1 */
    out[325] = CARDAN_REAL(0.0); /* M: hooke4.u.angle1,hooke2.u.angle2 */
    out[326] = CARDAN_REAL(0.0); /* M: hooke4.u.angle1,slide2.u */
    out[327] = CARDAN_REAL(0.0); /* M: hooke4.u.angle1,hooke3.u.angle1 */
    out[328] = CARDAN_REAL(0.0); /* M: hooke4.u.angle1,hooke3.u.angle2 */
    out[329] = CARDAN_REAL(0.0); /* M: hooke4.u.angle1,slide3.u */
    out[331] = CARDAN_REAL(0.0); /* M: hooke4.u.angle1,hooke4.u.angle2 */
    out[332] = CARDAN_REAL(0.0); /* M: hooke4.u.angle1,slide4.u */
    out[333] = CARDAN_REAL(0.0); /* M: hooke4.u.angle1,hooke5.u.angle1 */
    out[334] = CARDAN_REAL(0.0); /* M: hooke4.u.angle1,hooke5.u.angle2 */
    out[335] = CARDAN_REAL(0.0); /* M: hooke4.u.angle1,slide5.u */
    out[336] = CARDAN_REAL(0.0); /* M: hooke4.u.angle2,hooke0.u.angle1 */
    out[337] = CARDAN_REAL(0.0); /* M: hooke4.u.angle2,hooke0.u.angle2 */
    out[338] = CARDAN_REAL(0.0); /* M: hooke4.u.angle2,slide0.u */
    out[339] = CARDAN_REAL(0.0); /* M: hooke4.u.angle2,ball0.u.x */
    out[340] = CARDAN_REAL(0.0); /* M: hooke4.u.angle2,ball0.u.y */
    out[341] = CARDAN_REAL(0.0); /* M: hooke4.u.angle2,ball0.u.z */
    out[342] = CARDAN_REAL(0.0); /* M: hooke4.u.angle2,hooke1.u.angle1 */
    out[343] = CARDAN_REAL(0.0); /* M: hooke4.u.angle2,hooke1.u.angle2 */
    out[344] = CARDAN_REAL(0.0); /* M: hooke4.u.angle2,slide1.u */
    out[345] = CARDAN_REAL(0.0); /* M: hooke4.u.angle2,hooke2.u.angle1 */
    out[346] = CARDAN_REAL(0.0); /* M: hooke4.u.angle2,hooke2.u.angle2 */
    out[347] = CARDAN_REAL(0.0); /* M: hooke4.u.angle2,slide2.u */
    out[348] = CARDAN_REAL(0.0); /* M: hooke4.u.angle2,hooke3.u.angle1 */
    out[349] = CARDAN_REAL(0.0); /* M: hooke4.u.angle2,hooke3.u.angle2 */
    out[350] = CARDAN_REAL(0.0); /* M: hooke4.u.angle2,slide3.u */
    out[351] = CARDAN_REAL(0.0); /* M: hooke4.u.angle2,hooke4.u.angle1 */
    out[353] = CARDAN_REAL(0.0); /* M: hooke4.u.angle2,slide4.u */
    out[354] = CARDAN_REAL(0.0); /* M: hooke4.u.angle2,hooke5.u.angle1 */
    out[355] = CARDAN_REAL(0.0); /* M: hooke4.u.angle2,hooke5.u.angle2 */
    out[356] = CARDAN_REAL(0.0); /* M: hooke4.u.angle2,slide5.u */
    out[357] = CARDAN_REAL(0.0); /* M: slide4.u,hooke0.u.angle1 */
    out[358] = CARDAN_REAL(0.0); /* M: slide4.u,hooke0.u.angle2 */
    out[359] = CARDAN_REAL(0.0); /* M: slide4.u,slide0.u */
    out[360] = CARDAN_REAL(0.0); /* M: slide4.u,ball0.u.x */
    out[361] = CARDAN_REAL(0.0); /* M: slide4.u,ball0.u.y */
    out[362] = CARDAN_REAL(0.0); /* M: slide4.u,ball0.u.z */
    out[363] = CARDAN_REAL(0.0); /* M: slide4.u,hooke1.u.angle1 */
    out[364] = CARDAN_REAL(0.0); /* M: slide4.u,hooke1.u.angle2 */
    out[365] = CARDAN_REAL(0.0); /* M: slide4.u,slide1.u */
    out[366] = CARDAN_REAL(0.0); /* M: slide4.u,hooke2.u.angle1 */
    out[367] = CARDAN_REAL(0.0); /* M: slide4.u,hooke2.u.angle2 */
    out[368] = CARDAN_REAL(0.0); /* M: slide4.u,slide2.u */
    out[369] = CARDAN_REAL(0.0); /* M: slide4.u,hooke3.u.angle1 */
    out[370] = CARDAN_REAL(0.0); /* M: slide4.u,hooke3.u.angle2 */
    out[371] = CARDAN_REAL(0.0); /* M: slide4.u,slide3.u */
    out[372] = CARDAN_REAL(0.0); /* M: slide4.u,hooke4.u.angle1 */
    out[373] = CARDAN_REAL(0.0); /* M: slide4.u,hooke4.u.angle2 */
    out[374] = CARDAN_REAL(w[14]); /* M: slide4.u,slide4.u */
    out[375] = CARDAN_REAL(0.0); /* M: slide4.u,hooke5.u.angle1 */
    out[376] = CARDAN_REAL(0.0); /* M: slide4.u,hooke5.u.angle2 */
    out[377] = CARDAN_REAL(0.0); /* M: slide4.u,slide5.u */
    out[378] = CARDAN_REAL(0.0); /* M: hooke5.u.angle1,hooke0.u.angle1 */
    out[379] = CARDAN_REAL(0.0); /* M: hooke5.u.angle1,hooke0.u.angle2 */
    out[380] = CARDAN_REAL(0.0); /* M: hooke5.u.angle1,slide0.u */
    out[381] = CARDAN_REAL(0.0); /* M: hooke5.u.angle1,ball0.u.x */
    out[382] = CARDAN_REAL(0.0); /* M: hooke5.u.angle1,ball0.u.y */
    out[383] = CARDAN_REAL(0.0); /* M: hooke5.u.angle1,ball0.u.z */
    out[384] = CARDAN_REAL(0.0); /* M: hooke5.u.angle1,hooke1.u.angle1 */
    out[385] = CARDAN_REAL(0.0); /* M: hooke5.u.angle1,hooke1.u.angle2 */
    out[386] = CARDAN_REAL(0.0); /* M: hooke5.u.angle1,slide1.u */
    out[387] = CARDAN_REAL(0.0); /* M: hooke5.u.angle1,hooke2.u.angle1 */
    out[388] = CARDAN_REAL(0.0); /* M: hooke5.u.angle1,hooke2.u.angle2 */
    out[389] = CARDAN_REAL(0.0); /* M: hooke5.u.angle1,slide2.u */
    out[390] = CARDAN_REAL(0.0); /* M: hooke5.u.angle1,hooke3.u.angle1 */
    out[391] = CARDAN_REAL(0.0); /* M: hooke5.u.angle1,hooke3.u.angle2 */
    out[392] = CARDAN_REAL(0.0); /* M: hooke5.u.angle1,slide3.u */
    out[393] = CARDAN_REAL(0.0); /* M: hooke5.u.angle1,hooke4.u.angle1 */
    out[394] = CARDAN_REAL(0.0); /* M: hooke5.u.angle1,hooke4.u.angle2 */
    out[395] = CARDAN_REAL(0.0); /* M: hooke5.u.angle1,slide4.u */
    out[397] = CARDAN_REAL(0.0); /* M: hooke5.u.angle1,hooke5.u.angle2 */
    out[398] = CARDAN_REAL(0.0); /* M: hooke5.u.angle1,slide5.u */
    out[399] = CARDAN_REAL(0.0); /* M: hooke5.u.angle2,hooke0.u.angle1 */
    out[400] = CARDAN_REAL(0.0); /* M: hooke5.u.angle2,hooke0.u.angle2 */
    out[401] = CARDAN_REAL(0.0); /* M: hooke5.u.angle2,slide0.u */
    out[402] = CARDAN_REAL(0.0); /* M: hooke5.u.angle2,ball0.u.x */
    out[403] = CARDAN_REAL(0.0); /* M: hooke5.u.angle2,ball0.u.y */
    out[404] = CARDAN_REAL(0.0); /* M: hooke5.u.angle2,ball0.u.z */
    out[405] = CARDAN_REAL(0.0); /* M: hooke5.u.angle2,hooke1.u.angle1 */
    out[406] = CARDAN_REAL(0.0); /* M: hooke5.u.angle2,hooke1.u.angle2 */
    out[407] = CARDAN_REAL(0.0); /* M: hooke5.u.angle2,slide1.u */
    out[408] = CARDAN_REAL(0.0); /* M: hooke5.u.angle2,hooke2.u.angle1 */
    out[409] = CARDAN_REAL(0.0); /* M: hooke5.u.angle2,hooke2.u.angle2 */
    out[410] = CARDAN_REAL(0.0); /* M: hooke5.u.angle2,slide2.u */
    out[411] = CARDAN_REAL(0.0); /* M: hooke5.u.angle2,hooke3.u.angle1 */
    out[412] = CARDAN_REAL(0.0); /* M: hooke5.u.angle2,hooke3.u.angle2 */
    out[413] = CARDAN_REAL(0.0); /* M: hooke5.u.angle2,slide3.u */
    out[414] = CARDAN_REAL(0.0); /* M: hooke5.u.angle2,hooke4.u.angle1 */
    out[415] = CARDAN_REAL(0.0); /* M: hooke5.u.angle2,hooke4.u.angle2 */
    out[416] = CARDAN_REAL(0.0); /* M: hooke5.u.angle2,slide4.u */
    out[417] = CARDAN_REAL(0.0); /* M: hooke5.u.angle2,hooke5.u.angle1 */
    out[419] = CARDAN_REAL(0.0); /* M: hooke5.u.angle2,slide5.u */
    out[420] = CARDAN_REAL(0.0); /* M: slide5.u,hooke0.u.angle1 */
    out[421] = CARDAN_REAL(0.0); /* M: slide5.u,hooke0.u.angle2 */
    out[422] = CARDAN_REAL(0.0); /* M: slide5.u,slide0.u */
    out[423] = CARDAN_REAL(0.0); /* M: slide5.u,ball0.u.x */
    out[424] = CARDAN_REAL(0.0); /* M: slide5.u,ball0.u.y */
    out[425] = CARDAN_REAL(0.0); /* M: slide5.u,ball0.u.z */
    out[426] = CARDAN_REAL(0.0); /* M: slide5.u,hooke1.u.angle1 */
    out[427] = CARDAN_REAL(0.0); /* M: slide5.u,hooke1.u.angle2 */
    out[428] = CARDAN_REAL(0.0); /* M: slide5.u,slide1.u */
    out[429] = CARDAN_REAL(0.0); /* M: slide5.u,hooke2.u.angle1 */
    out[430] = CARDAN_REAL(0.0); /* M: slide5.u,hooke2.u.angle2 */
    out[431] = CARDAN_REAL(0.0); /* M: slide5.u,slide2.u */
    out[432] = CARDAN_REAL(0.0); /* M: slide5.u,hooke3.u.angle1 */
    out[433] = CARDAN_REAL(0.0); /* M: slide5.u,hooke3.u.angle2 */
    out[434] = CARDAN_REAL(0.0); /* M: slide5.u,slide3.u */
    out[435] = CARDAN_REAL(0.0); /* M: slide5.u,hooke4.u.angle1 */
    out[436] = CARDAN_REAL(0.0); /* M: slide5.u,hooke4.u.angle2 */
    out[437] = CARDAN_REAL(0.0); /* M: slide5.u,slide4.u */
    out[438] = CARDAN_REAL(0.0); /* M: slide5.u,hooke5.u.angle1 */
    out[439] = CARDAN_REAL(0.0); /* M: slide5.u,hooke5.u.angle2 */
    out[440] = CARDAN_REAL(w[15]); /* M: slide5.u,slide5.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {441, 0, 47, 0, 22, 0, 0, 0, 0, 96, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
