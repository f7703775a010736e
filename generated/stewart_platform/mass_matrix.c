/*
 * mass_matrix of stewart_platform
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: origins, base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 441, work 0, w 47
 * Operations per call: 279 = 155 mul, 77 add, 33 sub, 6 cos, 6 sin, 2 neg
 * Operations of prepare: 142 = 75 add, 66 mul, 1 neg
 *
 * Input q (22): generalized coordinates
 *   q[0]  hooke0.angle1 [rad]
 *   q[1]  hooke0.angle2 [rad]
 *   q[2]  slide0 [m]
 *   q[3]  ball0.qw
 *   q[4]  ball0.qx
 *   q[5]  ball0.qy
 *   q[6]  ball0.qz
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
    /* tube0: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube0_mass = p[3]; /* kg */
    const wreal tube0_com_z = p[4]; /* m */
    const wreal tube0_inertia_xx = p[5]; /* kg m^2 */
    const wreal tube0_inertia_yy = p[6]; /* kg m^2 */
    const wreal tube0_inertia_zz = p[7]; /* kg m^2 */
    const wreal rod0_inertia_zz = p[13]; /* kg m^2 */
    const wreal tube0_first_moment_z = tube0_mass * tube0_com_z;
    const wreal tube0_com_z_times_first_moment_z = tube0_com_z * tube0_first_moment_z;
    const wreal tube0_origin_inertia_xx = tube0_inertia_xx + tube0_com_z_times_first_moment_z;
    const wreal tube0_origin_inertia_yy = tube0_inertia_yy + tube0_com_z_times_first_moment_z;
    const wreal tube0_base_inertia_zz = tube0_inertia_zz + rod0_inertia_zz;
    w[45] = tube0_base_inertia_zz;

    /* rod0: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal rod0_mass = p[9]; /* kg */
    const wreal rod0_com_z = p[10]; /* m */
    const wreal rod0_inertia_xx = p[11]; /* kg m^2 */
    const wreal rod0_inertia_yy = p[12]; /* kg m^2 */
    const wreal platform_mass = p[16]; /* kg */
    const wreal rod0_first_moment_z = rod0_mass * rod0_com_z;
    const wreal rod0_com_z_times_first_moment_z = rod0_com_z * rod0_first_moment_z;
    const wreal rod0_origin_inertia_xx = rod0_inertia_xx + rod0_com_z_times_first_moment_z;
    const wreal rod0_origin_inertia_yy = rod0_inertia_yy + rod0_com_z_times_first_moment_z;
    const wreal rod0_base_mass = rod0_mass + platform_mass;
    w[41] = rod0_base_mass;

    /* momentum */
    /* momentum = composite inertia S */
    const wreal ball0_child_position_x = p[14]; /* m */
    const wreal ball0_child_position_y = p[15]; /* m */
    const wreal momentum_ball0_y_fz = ball0_child_position_x * platform_mass;
    const wreal momentum_ball0_z_fx = ball0_child_position_y * platform_mass;
    w[1] = momentum_ball0_y_fz;
    w[2] = momentum_ball0_z_fx;

    /* platform: first moment, mass, base, origin inertia */
    /* first_moment = sum m c */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal slide0_position_z = p[8]; /* m */
    const wreal platform_com_z = p[17]; /* m */
    const wreal platform_inertia_xx = p[18]; /* kg m^2 */
    const wreal platform_inertia_yy = p[19]; /* kg m^2 */
    const wreal platform_inertia_zz = p[20]; /* kg m^2 */
    const wreal platform_first_moment_z = platform_mass * platform_com_z;
    const wreal ball0_child_position_x_times_momentum_ball0_y_fz = ball0_child_position_x *
        momentum_ball0_y_fz;
    const wreal ball0_child_position_y_times_momentum_ball0_z_fx = ball0_child_position_y *
        momentum_ball0_z_fx;
    const wreal platform_com_z_times_first_moment_z = platform_com_z * platform_first_moment_z;
    const wreal platform_base_second_moment_xy = ball0_child_position_y * momentum_ball0_y_fz;
    const wreal platform_origin_inertia_xy = -platform_base_second_moment_xy;
    const wreal platform_origin_inertia_xz = platform_com_z * momentum_ball0_y_fz;
    const wreal platform_origin_inertia_yz = platform_com_z * momentum_ball0_z_fx;
    const wreal platform_origin_inertia_xx = platform_inertia_xx
        + ball0_child_position_y_times_momentum_ball0_z_fx + platform_com_z_times_first_moment_z;
    const wreal platform_origin_inertia_yy = platform_inertia_yy
        + ball0_child_position_x_times_momentum_ball0_y_fz + platform_com_z_times_first_moment_z;
    const wreal platform_origin_inertia_zz = platform_inertia_zz
        + ball0_child_position_x_times_momentum_ball0_y_fz
        + ball0_child_position_y_times_momentum_ball0_z_fx;
    const wreal platform_base_mass_moment_z = slide0_position_z * platform_mass;
    w[3] = platform_first_moment_z;
    w[4] = platform_base_second_moment_xy;
    w[5] = platform_origin_inertia_xy;
    w[6] = platform_origin_inertia_xz;
    w[7] = platform_origin_inertia_yz;
    w[8] = platform_origin_inertia_xx;
    w[9] = platform_origin_inertia_yy;
    w[10] = platform_origin_inertia_zz;

    /* tube1: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube1_mass = p[23]; /* kg */
    const wreal tube1_com_z = p[24]; /* m */
    const wreal tube1_inertia_xx = p[25]; /* kg m^2 */
    const wreal tube1_inertia_yy = p[26]; /* kg m^2 */
    const wreal tube1_inertia_zz = p[27]; /* kg m^2 */
    const wreal rod1_inertia_zz = p[33]; /* kg m^2 */
    const wreal tube1_first_moment_z = tube1_mass * tube1_com_z;
    const wreal tube1_com_z_times_first_moment_z = tube1_com_z * tube1_first_moment_z;
    const wreal tube1_origin_inertia_xx = tube1_inertia_xx + tube1_com_z_times_first_moment_z;
    const wreal tube1_origin_inertia_yy = tube1_inertia_yy + tube1_com_z_times_first_moment_z;
    const wreal tube1_base_inertia_zz = tube1_inertia_zz + rod1_inertia_zz;
    w[40] = tube1_base_inertia_zz;

    /* rod1: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal slide1_position_z = p[28]; /* m */
    const wreal rod1_mass = p[29]; /* kg */
    const wreal rod1_com_z = p[30]; /* m */
    const wreal rod1_inertia_xx = p[31]; /* kg m^2 */
    const wreal rod1_inertia_yy = p[32]; /* kg m^2 */
    const wreal rod1_first_moment_z = rod1_mass * rod1_com_z;
    const wreal rod1_com_z_times_first_moment_z = rod1_com_z * rod1_first_moment_z;
    const wreal rod1_origin_inertia_xx = rod1_inertia_xx + rod1_com_z_times_first_moment_z;
    const wreal rod1_origin_inertia_yy = rod1_inertia_yy + rod1_com_z_times_first_moment_z;
    const wreal rod1_base_moment_z = rod1_first_moment_z + slide1_position_z * rod1_mass;
    w[17] = rod1_base_moment_z;

    /* tube2: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube2_mass = p[36]; /* kg */
    const wreal tube2_com_z = p[37]; /* m */
    const wreal tube2_inertia_xx = p[38]; /* kg m^2 */
    const wreal tube2_inertia_yy = p[39]; /* kg m^2 */
    const wreal tube2_inertia_zz = p[40]; /* kg m^2 */
    const wreal rod2_inertia_zz = p[46]; /* kg m^2 */
    const wreal tube2_first_moment_z = tube2_mass * tube2_com_z;
    const wreal tube2_com_z_times_first_moment_z = tube2_com_z * tube2_first_moment_z;
    const wreal tube2_origin_inertia_xx = tube2_inertia_xx + tube2_com_z_times_first_moment_z;
    const wreal tube2_origin_inertia_yy = tube2_inertia_yy + tube2_com_z_times_first_moment_z;
    const wreal tube2_base_inertia_zz = tube2_inertia_zz + rod2_inertia_zz;
    w[37] = tube2_base_inertia_zz;

    /* rod2: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal slide2_position_z = p[41]; /* m */
    const wreal rod2_mass = p[42]; /* kg */
    const wreal rod2_com_z = p[43]; /* m */
    const wreal rod2_inertia_xx = p[44]; /* kg m^2 */
    const wreal rod2_inertia_yy = p[45]; /* kg m^2 */
    const wreal rod2_first_moment_z = rod2_mass * rod2_com_z;
    const wreal rod2_com_z_times_first_moment_z = rod2_com_z * rod2_first_moment_z;
    const wreal rod2_origin_inertia_xx = rod2_inertia_xx + rod2_com_z_times_first_moment_z;
    const wreal rod2_origin_inertia_yy = rod2_inertia_yy + rod2_com_z_times_first_moment_z;
    const wreal rod2_base_moment_z = rod2_first_moment_z + slide2_position_z * rod2_mass;
    w[19] = rod2_base_moment_z;

    /* tube3: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube3_mass = p[49]; /* kg */
    const wreal tube3_com_z = p[50]; /* m */
    const wreal tube3_inertia_xx = p[51]; /* kg m^2 */
    const wreal tube3_inertia_yy = p[52]; /* kg m^2 */
    const wreal tube3_inertia_zz = p[53]; /* kg m^2 */
    const wreal rod3_inertia_zz = p[59]; /* kg m^2 */
    const wreal tube3_first_moment_z = tube3_mass * tube3_com_z;
    const wreal tube3_com_z_times_first_moment_z = tube3_com_z * tube3_first_moment_z;
    const wreal tube3_origin_inertia_xx = tube3_inertia_xx + tube3_com_z_times_first_moment_z;
    const wreal tube3_origin_inertia_yy = tube3_inertia_yy + tube3_com_z_times_first_moment_z;
    const wreal tube3_base_inertia_zz = tube3_inertia_zz + rod3_inertia_zz;
    w[34] = tube3_base_inertia_zz;

    /* rod3: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal slide3_position_z = p[54]; /* m */
    const wreal rod3_mass = p[55]; /* kg */
    const wreal rod3_com_z = p[56]; /* m */
    const wreal rod3_inertia_xx = p[57]; /* kg m^2 */
    const wreal rod3_inertia_yy = p[58]; /* kg m^2 */
    const wreal rod3_first_moment_z = rod3_mass * rod3_com_z;
    const wreal rod3_com_z_times_first_moment_z = rod3_com_z * rod3_first_moment_z;
    const wreal rod3_origin_inertia_xx = rod3_inertia_xx + rod3_com_z_times_first_moment_z;
    const wreal rod3_origin_inertia_yy = rod3_inertia_yy + rod3_com_z_times_first_moment_z;
    const wreal rod3_base_moment_z = rod3_first_moment_z + slide3_position_z * rod3_mass;
    w[21] = rod3_base_moment_z;

    /* tube4: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube4_mass = p[62]; /* kg */
    const wreal tube4_com_z = p[63]; /* m */
    const wreal tube4_inertia_xx = p[64]; /* kg m^2 */
    const wreal tube4_inertia_yy = p[65]; /* kg m^2 */
    const wreal tube4_inertia_zz = p[66]; /* kg m^2 */
    const wreal rod4_inertia_zz = p[72]; /* kg m^2 */
    const wreal tube4_first_moment_z = tube4_mass * tube4_com_z;
    const wreal tube4_com_z_times_first_moment_z = tube4_com_z * tube4_first_moment_z;
    const wreal tube4_origin_inertia_xx = tube4_inertia_xx + tube4_com_z_times_first_moment_z;
    const wreal tube4_origin_inertia_yy = tube4_inertia_yy + tube4_com_z_times_first_moment_z;
    const wreal tube4_base_inertia_zz = tube4_inertia_zz + rod4_inertia_zz;
    w[31] = tube4_base_inertia_zz;

    /* rod4: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal slide4_position_z = p[67]; /* m */
    const wreal rod4_mass = p[68]; /* kg */
    const wreal rod4_com_z = p[69]; /* m */
    const wreal rod4_inertia_xx = p[70]; /* kg m^2 */
    const wreal rod4_inertia_yy = p[71]; /* kg m^2 */
    const wreal rod4_first_moment_z = rod4_mass * rod4_com_z;
    const wreal rod4_com_z_times_first_moment_z = rod4_com_z * rod4_first_moment_z;
    const wreal rod4_origin_inertia_xx = rod4_inertia_xx + rod4_com_z_times_first_moment_z;
    const wreal rod4_origin_inertia_yy = rod4_inertia_yy + rod4_com_z_times_first_moment_z;
    const wreal rod4_base_moment_z = rod4_first_moment_z + slide4_position_z * rod4_mass;
    w[23] = rod4_base_moment_z;

    /* tube5: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube5_mass = p[75]; /* kg */
    const wreal tube5_com_z = p[76]; /* m */
    const wreal tube5_inertia_xx = p[77]; /* kg m^2 */
    const wreal tube5_inertia_yy = p[78]; /* kg m^2 */
    const wreal tube5_inertia_zz = p[79]; /* kg m^2 */
    const wreal rod5_inertia_zz = p[85]; /* kg m^2 */
    const wreal tube5_first_moment_z = tube5_mass * tube5_com_z;
    const wreal tube5_com_z_times_first_moment_z = tube5_com_z * tube5_first_moment_z;
    const wreal tube5_origin_inertia_xx = tube5_inertia_xx + tube5_com_z_times_first_moment_z;
    const wreal tube5_origin_inertia_yy = tube5_inertia_yy + tube5_com_z_times_first_moment_z;
    const wreal tube5_base_inertia_zz = tube5_inertia_zz + rod5_inertia_zz;
    w[28] = tube5_base_inertia_zz;

    /* rod5: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal slide5_position_z = p[80]; /* m */
    const wreal rod5_mass = p[81]; /* kg */
    const wreal rod5_com_z = p[82]; /* m */
    const wreal rod5_inertia_xx = p[83]; /* kg m^2 */
    const wreal rod5_inertia_yy = p[84]; /* kg m^2 */
    const wreal rod5_first_moment_z = rod5_mass * rod5_com_z;
    const wreal rod5_com_z_times_first_moment_z = rod5_com_z * rod5_first_moment_z;
    const wreal rod5_origin_inertia_xx = rod5_inertia_xx + rod5_com_z_times_first_moment_z;
    const wreal rod5_origin_inertia_yy = rod5_inertia_yy + rod5_com_z_times_first_moment_z;
    const wreal rod5_base_moment_z = rod5_first_moment_z + slide5_position_z * rod5_mass;
    w[25] = rod5_base_moment_z;

    /* shared by several: inertia */
    const wreal half_rod1_mass = 0.5 * rod1_mass;
    const wreal half_rod2_mass = 0.5 * rod2_mass;
    const wreal half_rod3_mass = 0.5 * rod3_mass;
    const wreal half_rod4_mass = 0.5 * rod4_mass;
    const wreal half_rod5_mass = 0.5 * rod5_mass;
    w[16] = half_rod1_mass;
    w[18] = half_rod2_mass;
    w[20] = half_rod3_mass;
    w[22] = half_rod4_mass;
    w[24] = half_rod5_mass;

    /* rod1: mass */
    const wreal rod1_mass_shift = slide1_position_z * (rod1_first_moment_z
        + slide1_position_z * half_rod1_mass) * 2.0;

    /* rod2: mass */
    const wreal rod2_mass_shift = slide2_position_z * (rod2_first_moment_z
        + slide2_position_z * half_rod2_mass) * 2.0;

    /* rod3: mass */
    const wreal rod3_mass_shift = slide3_position_z * (rod3_first_moment_z
        + slide3_position_z * half_rod3_mass) * 2.0;

    /* rod4: mass */
    const wreal rod4_mass_shift = slide4_position_z * (rod4_first_moment_z
        + slide4_position_z * half_rod4_mass) * 2.0;

    /* rod5: mass */
    const wreal rod5_mass_shift = slide5_position_z * (rod5_first_moment_z
        + slide5_position_z * half_rod5_mass) * 2.0;

    /* tube5: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube5_base_inertia_xx = tube5_origin_inertia_xx + rod5_origin_inertia_xx
        + rod5_mass_shift;
    const wreal tube5_base_inertia_yy = tube5_origin_inertia_yy + rod5_origin_inertia_yy
        + rod5_mass_shift;
    w[26] = tube5_base_inertia_xx;
    w[27] = tube5_base_inertia_yy;

    /* tube4: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube4_base_inertia_xx = tube4_origin_inertia_xx + rod4_origin_inertia_xx
        + rod4_mass_shift;
    const wreal tube4_base_inertia_yy = tube4_origin_inertia_yy + rod4_origin_inertia_yy
        + rod4_mass_shift;
    w[29] = tube4_base_inertia_xx;
    w[30] = tube4_base_inertia_yy;

    /* tube3: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube3_base_inertia_xx = tube3_origin_inertia_xx + rod3_origin_inertia_xx
        + rod3_mass_shift;
    const wreal tube3_base_inertia_yy = tube3_origin_inertia_yy + rod3_origin_inertia_yy
        + rod3_mass_shift;
    w[32] = tube3_base_inertia_xx;
    w[33] = tube3_base_inertia_yy;

    /* tube2: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube2_base_inertia_xx = tube2_origin_inertia_xx + rod2_origin_inertia_xx
        + rod2_mass_shift;
    const wreal tube2_base_inertia_yy = tube2_origin_inertia_yy + rod2_origin_inertia_yy
        + rod2_mass_shift;
    w[35] = tube2_base_inertia_xx;
    w[36] = tube2_base_inertia_yy;

    /* tube1: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube1_base_inertia_xx = tube1_origin_inertia_xx + rod1_origin_inertia_xx
        + rod1_mass_shift;
    const wreal tube1_base_inertia_yy = tube1_origin_inertia_yy + rod1_origin_inertia_yy
        + rod1_mass_shift;
    w[38] = tube1_base_inertia_xx;
    w[39] = tube1_base_inertia_yy;

    /* rod0: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal rod0_base_moment_z = rod0_first_moment_z + slide0_position_z * rod0_mass
        + platform_base_mass_moment_z;
    const wreal rod0_mass_shift_plus_platform_base_inertia_xx = slide0_position_z *
        (rod0_first_moment_z + 0.5 * rod0_mass * slide0_position_z) * 2.0
        + slide0_position_z * platform_base_mass_moment_z;
    w[42] = rod0_base_moment_z;

    /* tube0: base, inertia */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube0_base_inertia_xx = tube0_origin_inertia_xx + rod0_origin_inertia_xx
        + rod0_mass_shift_plus_platform_base_inertia_xx;
    const wreal tube0_base_inertia_yy = tube0_origin_inertia_yy + rod0_origin_inertia_yy
        + rod0_mass_shift_plus_platform_base_inertia_xx;
    const wreal half_rod0_base_mass = 0.5 * rod0_base_mass;
    w[43] = tube0_base_inertia_xx;
    w[44] = tube0_base_inertia_yy;
    w[46] = half_rod0_base_mass;

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

    /* zeros among the results; what stands between them follows */
    memset(out + 6, 0, 434 * sizeof(real));

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
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
    const real hooke5_angle2_cos = cosine[0];
    const real hooke5_angle2_sin = sine[0];
    const real hooke4_angle2_cos = cosine[1];
    const real hooke4_angle2_sin = sine[1];
    const real hooke3_angle2_cos = cosine[2];
    const real hooke3_angle2_sin = sine[2];
    const real hooke2_angle2_cos = cosine[3];
    const real hooke2_angle2_sin = sine[3];
    const real hooke1_angle2_cos = cosine[4];
    const real hooke1_angle2_sin = sine[4];
    const real hooke0_angle2_cos = cosine[5];
    const real hooke0_angle2_sin = sine[5];

    /* tube5: inertia, composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const real slide5_q = q[21]; /* m */
    const wreal half_rod5_mass = w[24];
    const wreal rod5_base_moment_z = w[25];
    const wreal tube5_base_inertia_xx = w[26];
    const wreal tube5_base_inertia_yy = w[27];
    const real tube5_inertia_shift = slide5_q * (rod5_base_moment_z
        + slide5_q * half_rod5_mass) * 2.0;
    const real tube5_composite_inertia_xx = tube5_base_inertia_xx + tube5_inertia_shift;
    out[418] = tube5_base_inertia_yy + tube5_inertia_shift; /* M: hooke5.u.angle2,hooke5.u.angle2 */

    /* tube4: inertia, composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const real slide4_q = q[18]; /* m */
    const wreal half_rod4_mass = w[22];
    const wreal rod4_base_moment_z = w[23];
    const wreal tube4_base_inertia_xx = w[29];
    const wreal tube4_base_inertia_yy = w[30];
    const real tube4_inertia_shift = slide4_q * (rod4_base_moment_z
        + slide4_q * half_rod4_mass) * 2.0;
    const real tube4_composite_inertia_xx = tube4_base_inertia_xx + tube4_inertia_shift;
    out[352] = tube4_base_inertia_yy + tube4_inertia_shift; /* M: hooke4.u.angle2,hooke4.u.angle2 */

    /* tube3: inertia, composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const real slide3_q = q[15]; /* m */
    const wreal half_rod3_mass = w[20];
    const wreal rod3_base_moment_z = w[21];
    const wreal tube3_base_inertia_xx = w[32];
    const wreal tube3_base_inertia_yy = w[33];
    const real tube3_inertia_shift = slide3_q * (rod3_base_moment_z
        + slide3_q * half_rod3_mass) * 2.0;
    const real tube3_composite_inertia_xx = tube3_base_inertia_xx + tube3_inertia_shift;
    out[286] = tube3_base_inertia_yy + tube3_inertia_shift; /* M: hooke3.u.angle2,hooke3.u.angle2 */

    /* tube2: inertia, composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const real slide2_q = q[12]; /* m */
    const wreal half_rod2_mass = w[18];
    const wreal rod2_base_moment_z = w[19];
    const wreal tube2_base_inertia_xx = w[35];
    const wreal tube2_base_inertia_yy = w[36];
    const real tube2_inertia_shift = slide2_q * (rod2_base_moment_z
        + slide2_q * half_rod2_mass) * 2.0;
    const real tube2_composite_inertia_xx = tube2_base_inertia_xx + tube2_inertia_shift;
    out[220] = tube2_base_inertia_yy + tube2_inertia_shift; /* M: hooke2.u.angle2,hooke2.u.angle2 */

    /* tube1: inertia, composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const real slide1_q = q[9]; /* m */
    const wreal half_rod1_mass = w[16];
    const wreal rod1_base_moment_z = w[17];
    const wreal tube1_base_inertia_xx = w[38];
    const wreal tube1_base_inertia_yy = w[39];
    const real tube1_inertia_shift = slide1_q * (rod1_base_moment_z
        + slide1_q * half_rod1_mass) * 2.0;
    const real tube1_composite_inertia_xx = tube1_base_inertia_xx + tube1_inertia_shift;
    out[154] = tube1_base_inertia_yy + tube1_inertia_shift; /* M: hooke1.u.angle2,hooke1.u.angle2 */

    /* ball0: R */
    /* R = R_fixed R_joint(q) */
    const real ball0_qw = q[3];
    const real ball0_qx = q[4];
    const real ball0_qy = q[5];
    const real ball0_qz = q[6];
    const real twice_ball0_qx = 2.0 * ball0_qx;
    const real twice_ball0_qy = 2.0 * ball0_qy;
    const real twice_ball0_qz = 2.0 * ball0_qz;
    const real ball0_qw_times_twice_ball0_qx = ball0_qw * twice_ball0_qx;
    const real one_minus_ball0_qx_times_twice_ball0_qx = 1.0 - ball0_qx * twice_ball0_qx;
    const real ball0_qw_times_twice_ball0_qy = ball0_qw * twice_ball0_qy;
    const real ball0_qw_times_twice_ball0_qz = ball0_qw * twice_ball0_qz;
    const real ball0_qx_times_twice_ball0_qy = ball0_qx * twice_ball0_qy;
    const real ball0_qy_times_twice_ball0_qy = ball0_qy * twice_ball0_qy;
    const real ball0_qx_times_twice_ball0_qz = ball0_qx * twice_ball0_qz;
    const real ball0_qy_times_twice_ball0_qz = ball0_qy * twice_ball0_qz;
    const real ball0_qz_times_twice_ball0_qz = ball0_qz * twice_ball0_qz;
    const real ball0_R_xx = 1.0 - ball0_qy_times_twice_ball0_qy - ball0_qz_times_twice_ball0_qz;
    const real ball0_R_yy = one_minus_ball0_qx_times_twice_ball0_qx - ball0_qz_times_twice_ball0_qz;
    const real ball0_R_zz = one_minus_ball0_qx_times_twice_ball0_qx - ball0_qy_times_twice_ball0_qy;
    const real ball0_R_xy = ball0_qx_times_twice_ball0_qy - ball0_qw_times_twice_ball0_qz;
    const real ball0_R_yx = ball0_qw_times_twice_ball0_qz + ball0_qx_times_twice_ball0_qy;
    const real ball0_R_xz = ball0_qw_times_twice_ball0_qy + ball0_qx_times_twice_ball0_qz;
    const real ball0_R_zx = ball0_qx_times_twice_ball0_qz - ball0_qw_times_twice_ball0_qy;
    const real ball0_R_yz = ball0_qy_times_twice_ball0_qz - ball0_qw_times_twice_ball0_qx;
    const real ball0_R_zy = ball0_qw_times_twice_ball0_qx + ball0_qy_times_twice_ball0_qz;

    /* shared by several: inertia */
    const wreal platform_base_second_moment_xy = w[4];
    const wreal platform_origin_inertia_xz = w[6];
    const wreal platform_origin_inertia_yz = w[7];
    const wreal platform_origin_inertia_xx = w[8];
    const wreal platform_origin_inertia_yy = w[9];
    const wreal platform_origin_inertia_zz = w[10];
    const real rod0_inertia_half_turned_xx = platform_origin_inertia_xz * ball0_R_xz
        - platform_base_second_moment_xy * ball0_R_xy + platform_origin_inertia_xx * ball0_R_xx;
    const real rod0_inertia_half_turned_xy = platform_origin_inertia_yy * ball0_R_xy
        + platform_origin_inertia_yz * ball0_R_xz - platform_base_second_moment_xy * ball0_R_xx;
    const real rod0_inertia_half_turned_xz = platform_origin_inertia_yz * ball0_R_xy
        + platform_origin_inertia_zz * ball0_R_xz + platform_origin_inertia_xz * ball0_R_xx;
    const real rod0_inertia_half_turned_yx = platform_origin_inertia_xx * ball0_R_yx
        + platform_origin_inertia_xz * ball0_R_yz - platform_base_second_moment_xy * ball0_R_yy;
    const real rod0_inertia_half_turned_yy = platform_origin_inertia_yz * ball0_R_yz
        - platform_base_second_moment_xy * ball0_R_yx + platform_origin_inertia_yy * ball0_R_yy;
    const real rod0_inertia_half_turned_yz = platform_origin_inertia_xz * ball0_R_yx
        + platform_origin_inertia_zz * ball0_R_yz + platform_origin_inertia_yz * ball0_R_yy;
    const real rod0_inertia_half_turned_zx = platform_origin_inertia_xx * ball0_R_zx
        - platform_base_second_moment_xy * ball0_R_zy + platform_origin_inertia_xz * ball0_R_zz;
    const real rod0_inertia_half_turned_zy = platform_origin_inertia_yy * ball0_R_zy
        - platform_base_second_moment_xy * ball0_R_zx + platform_origin_inertia_yz * ball0_R_zz;
    const real rod0_inertia_half_turned_zz = platform_origin_inertia_xz * ball0_R_zx
        + platform_origin_inertia_yz * ball0_R_zy + platform_origin_inertia_zz * ball0_R_zz;

    /* rod0: composite, inertia */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal slide0_position_z = w[0]; /* m */
    const wreal momentum_ball0_y_fz = w[1];
    const wreal momentum_ball0_z_fx = w[2];
    const wreal platform_first_moment_z = w[3];
    const wreal rod0_base_moment_z = w[42];
    const real rod0_composite_inertia_xy = ball0_R_yx * rod0_inertia_half_turned_xx
        + ball0_R_yy * rod0_inertia_half_turned_xy + ball0_R_yz * rod0_inertia_half_turned_xz;
    const real rod0_composite_inertia_zz = ball0_R_zx * rod0_inertia_half_turned_zx
        + ball0_R_zy * rod0_inertia_half_turned_zy + ball0_R_zz * rod0_inertia_half_turned_zz;
    const real rod0_composite_moment_x = platform_first_moment_z * ball0_R_xz
        - momentum_ball0_z_fx * ball0_R_xy - momentum_ball0_y_fz * ball0_R_xx;
    const real rod0_composite_moment_y = platform_first_moment_z * ball0_R_yz
        - momentum_ball0_y_fz * ball0_R_yx - momentum_ball0_z_fx * ball0_R_yy;
    const real rod0_inertia_mean_moment_z = platform_first_moment_z * ball0_R_zz
        - (momentum_ball0_y_fz * ball0_R_zx + momentum_ball0_z_fx * ball0_R_zy);
    const real rod0_inertia_shift = slide0_position_z * rod0_inertia_mean_moment_z * 2.0;
    const real rod0_composite_inertia_xx = ball0_R_xx * rod0_inertia_half_turned_xx
        + ball0_R_xy * rod0_inertia_half_turned_xy + (ball0_R_xz * rod0_inertia_half_turned_xz
        + rod0_inertia_shift);
    const real rod0_composite_inertia_yy = ball0_R_yx * rod0_inertia_half_turned_yx
        + ball0_R_yy * rod0_inertia_half_turned_yy + (ball0_R_yz * rod0_inertia_half_turned_yz
        + rod0_inertia_shift);
    const real rod0_composite_moment_z = rod0_base_moment_z + rod0_inertia_mean_moment_z;
    const real rod0_composite_inertia_xz = ball0_R_zx * rod0_inertia_half_turned_xx
        + ball0_R_zy * rod0_inertia_half_turned_xy + (ball0_R_zz * rod0_inertia_half_turned_xz
        - slide0_position_z * rod0_composite_moment_x);
    const real rod0_composite_inertia_yz = ball0_R_zx * rod0_inertia_half_turned_yx
        + ball0_R_zy * rod0_inertia_half_turned_yy + ball0_R_zz * rod0_inertia_half_turned_yz
        - slide0_position_z * rod0_composite_moment_y;

    /* tube0: composite, inertia */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const real slide0_q = q[2]; /* m */
    const wreal tube0_base_inertia_xx = w[43];
    const wreal tube0_base_inertia_yy = w[44];
    const wreal tube0_base_inertia_zz = w[45];
    const wreal half_rod0_base_mass = w[46];
    const real tube0_composite_inertia_zz = tube0_base_inertia_zz + rod0_composite_inertia_zz;
    const real tube0_inertia_shift = slide0_q * (rod0_composite_moment_z
        + slide0_q * half_rod0_base_mass) * 2.0;
    const real tube0_composite_inertia_xx = tube0_base_inertia_xx + rod0_composite_inertia_xx
        + tube0_inertia_shift;
    const real tube0_composite_inertia_xz = rod0_composite_inertia_xz
        - slide0_q * rod0_composite_moment_x;
    const real tube0_composite_inertia_yz = rod0_composite_inertia_yz + rod0_composite_inertia_yz
        - rod0_composite_inertia_yz - slide0_q * rod0_composite_moment_y;
    /* M: hooke0.u.angle2,hooke0.u.angle2 */
    out[22] = tube0_base_inertia_yy + rod0_composite_inertia_yy + tube0_inertia_shift;

    /* shared by several: M */
    /* M = S . momentum */
    const real momentum_slide0_my = -rod0_composite_moment_x;
    out[23] = momentum_slide0_my; /* M: hooke0.u.angle2,slide0.u */
    out[43] = momentum_slide0_my; /* M: slide0.u,hooke0.u.angle2 */

    /* momentum */
    /* momentum = composite inertia S */
    const wreal tube5_base_inertia_zz = w[28];
    const wreal tube4_base_inertia_zz = w[31];
    const wreal tube3_base_inertia_zz = w[34];
    const wreal tube2_base_inertia_zz = w[37];
    const wreal tube1_base_inertia_zz = w[40];
    const real momentum_hooke5_angle1_mx = tube5_composite_inertia_xx * hooke5_angle2_cos;
    const real momentum_hooke5_angle1_mz = tube5_base_inertia_zz * hooke5_angle2_sin;
    const real momentum_hooke4_angle1_mx = tube4_composite_inertia_xx * hooke4_angle2_cos;
    const real momentum_hooke4_angle1_mz = tube4_base_inertia_zz * hooke4_angle2_sin;
    const real momentum_hooke3_angle1_mx = tube3_composite_inertia_xx * hooke3_angle2_cos;
    const real momentum_hooke3_angle1_mz = tube3_base_inertia_zz * hooke3_angle2_sin;
    const real momentum_hooke2_angle1_mx = tube2_composite_inertia_xx * hooke2_angle2_cos;
    const real momentum_hooke2_angle1_mz = tube2_base_inertia_zz * hooke2_angle2_sin;
    const real momentum_hooke1_angle1_mx = tube1_composite_inertia_xx * hooke1_angle2_cos;
    const real momentum_hooke1_angle1_mz = tube1_base_inertia_zz * hooke1_angle2_sin;
    const real momentum_hooke0_angle1_fz = rod0_composite_moment_y * hooke0_angle2_cos;
    const real momentum_hooke0_angle1_my = rod0_composite_inertia_xy * hooke0_angle2_cos
        + tube0_composite_inertia_yz * hooke0_angle2_sin;
    const real momentum_hooke0_angle1_mx = tube0_composite_inertia_xx * hooke0_angle2_cos
        + tube0_composite_inertia_xz * hooke0_angle2_sin;
    const real momentum_hooke0_angle1_mz = tube0_composite_inertia_xz * hooke0_angle2_cos
        + tube0_composite_inertia_zz * hooke0_angle2_sin;
    out[2] = momentum_hooke0_angle1_fz; /* M: hooke0.u.angle1,slide0.u */
    out[42] = momentum_hooke0_angle1_fz; /* M: slide0.u,hooke0.u.angle1 */
    out[1] = momentum_hooke0_angle1_my; /* M: hooke0.u.angle1,hooke0.u.angle2 */
    out[21] = momentum_hooke0_angle1_my; /* M: hooke0.u.angle2,hooke0.u.angle1 */

    /* M */
    /* M = S . momentum */
    const real M_ball0_y_slide0 = platform_first_moment_z * ball0_R_zx
        + momentum_ball0_y_fz * ball0_R_zz;
    const real M_ball0_z_slide0 = momentum_ball0_z_fx * ball0_R_zx
        - momentum_ball0_y_fz * ball0_R_zy;
    /* M: hooke5.u.angle1,hooke5.u.angle1 */
    out[396] = hooke5_angle2_cos * momentum_hooke5_angle1_mx
        + hooke5_angle2_sin * momentum_hooke5_angle1_mz;
    /* M: hooke4.u.angle1,hooke4.u.angle1 */
    out[330] = hooke4_angle2_cos * momentum_hooke4_angle1_mx
        + hooke4_angle2_sin * momentum_hooke4_angle1_mz;
    /* M: hooke3.u.angle1,hooke3.u.angle1 */
    out[264] = hooke3_angle2_cos * momentum_hooke3_angle1_mx
        + hooke3_angle2_sin * momentum_hooke3_angle1_mz;
    /* M: hooke2.u.angle1,hooke2.u.angle1 */
    out[198] = hooke2_angle2_cos * momentum_hooke2_angle1_mx
        + hooke2_angle2_sin * momentum_hooke2_angle1_mz;
    /* M: hooke1.u.angle1,hooke1.u.angle1 */
    out[132] = hooke1_angle2_cos * momentum_hooke1_angle1_mx
        + hooke1_angle2_sin * momentum_hooke1_angle1_mz;
    out[46] = M_ball0_y_slide0; /* M: slide0.u,ball0.u.y */
    out[86] = M_ball0_y_slide0; /* M: ball0.u.y,slide0.u */
    out[47] = M_ball0_z_slide0; /* M: slide0.u,ball0.u.z */
    out[107] = M_ball0_z_slide0; /* M: ball0.u.z,slide0.u */
    /* M: hooke0.u.angle1,hooke0.u.angle1 */
    out[0] = hooke0_angle2_cos * momentum_hooke0_angle1_mx
        + hooke0_angle2_sin * momentum_hooke0_angle1_mz;

    /* platform: momentum */
    /* momentum = composite inertia S */
    const real momentum_minus_ball0_x_about_rod0_fx = platform_first_moment_z * ball0_R_xy
        + momentum_ball0_z_fx * ball0_R_xz;
    const real momentum_minus_ball0_x_about_rod0_fy = platform_first_moment_z * ball0_R_yy
        + momentum_ball0_z_fx * ball0_R_yz;
    const real momentum_ball0_x_about_rod0_fz = -(platform_first_moment_z * ball0_R_zy
        + momentum_ball0_z_fx * ball0_R_zz);
    const real momentum_ball0_y_about_rod0_fx = platform_first_moment_z * ball0_R_xx
        + momentum_ball0_y_fz * ball0_R_xz;
    const real momentum_ball0_z_about_rod0_fx = momentum_ball0_z_fx * ball0_R_xx
        - momentum_ball0_y_fz * ball0_R_xy;
    const real momentum_ball0_y_about_rod0_fy = platform_first_moment_z * ball0_R_yx
        + momentum_ball0_y_fz * ball0_R_yz;
    const real momentum_ball0_z_about_rod0_fy = momentum_ball0_z_fx * ball0_R_yx
        - momentum_ball0_y_fz * ball0_R_yy;
    out[45] = momentum_ball0_x_about_rod0_fz; /* M: slide0.u,ball0.u.x */
    out[65] = momentum_ball0_x_about_rod0_fz; /* M: ball0.u.x,slide0.u */

    /* M */
    /* M = S . momentum */
    const real M_ball0_x_hooke0_angle2 = rod0_inertia_half_turned_yx
        - slide0_position_z * momentum_minus_ball0_x_about_rod0_fx
        - slide0_q * momentum_minus_ball0_x_about_rod0_fx;
    const real M_ball0_x_hooke0_angle1 = (rod0_inertia_half_turned_xx
        + slide0_position_z * momentum_minus_ball0_x_about_rod0_fy
        + slide0_q * momentum_minus_ball0_x_about_rod0_fy) * hooke0_angle2_cos
        + rod0_inertia_half_turned_zx * hooke0_angle2_sin;
    const real M_ball0_y_hooke0_angle1 = hooke0_angle2_cos * (rod0_inertia_half_turned_xy
        - slide0_position_z * momentum_ball0_y_about_rod0_fy
        - slide0_q * momentum_ball0_y_about_rod0_fy)
        + rod0_inertia_half_turned_zy * hooke0_angle2_sin;
    const real M_ball0_y_hooke0_angle2 = rod0_inertia_half_turned_yy
        + slide0_position_z * momentum_ball0_y_about_rod0_fx
        + slide0_q * momentum_ball0_y_about_rod0_fx;
    const real M_ball0_z_hooke0_angle1 = hooke0_angle2_cos * (rod0_inertia_half_turned_xz
        - slide0_position_z * momentum_ball0_z_about_rod0_fy
        - slide0_q * momentum_ball0_z_about_rod0_fy)
        + rod0_inertia_half_turned_zz * hooke0_angle2_sin;
    const real M_ball0_z_hooke0_angle2 = rod0_inertia_half_turned_yz
        + slide0_position_z * momentum_ball0_z_about_rod0_fx
        + slide0_q * momentum_ball0_z_about_rod0_fx;
    out[24] = M_ball0_x_hooke0_angle2; /* M: hooke0.u.angle2,ball0.u.x */
    out[64] = M_ball0_x_hooke0_angle2; /* M: ball0.u.x,hooke0.u.angle2 */
    out[3] = M_ball0_x_hooke0_angle1; /* M: hooke0.u.angle1,ball0.u.x */
    out[63] = M_ball0_x_hooke0_angle1; /* M: ball0.u.x,hooke0.u.angle1 */
    out[4] = M_ball0_y_hooke0_angle1; /* M: hooke0.u.angle1,ball0.u.y */
    out[84] = M_ball0_y_hooke0_angle1; /* M: ball0.u.y,hooke0.u.angle1 */
    out[25] = M_ball0_y_hooke0_angle2; /* M: hooke0.u.angle2,ball0.u.y */
    out[85] = M_ball0_y_hooke0_angle2; /* M: ball0.u.y,hooke0.u.angle2 */
    out[5] = M_ball0_z_hooke0_angle1; /* M: hooke0.u.angle1,ball0.u.z */
    out[105] = M_ball0_z_hooke0_angle1; /* M: ball0.u.z,hooke0.u.angle1 */
    out[26] = M_ball0_z_hooke0_angle2; /* M: hooke0.u.angle2,ball0.u.z */
    out[106] = M_ball0_z_hooke0_angle2; /* M: ball0.u.z,hooke0.u.angle2 */

    /* results that are numbers or inputs */
    out[44] = CARDAN_REAL(w[41]); /* M: slide0.u,slide0.u */
    out[66] = CARDAN_REAL(w[8]); /* M: ball0.u.x,ball0.u.x */
    out[67] = CARDAN_REAL(w[5]); /* M: ball0.u.x,ball0.u.y */
    out[68] = CARDAN_REAL(w[6]); /* M: ball0.u.x,ball0.u.z */
    out[87] = CARDAN_REAL(w[5]); /* M: ball0.u.y,ball0.u.x */
    out[88] = CARDAN_REAL(w[9]); /* M: ball0.u.y,ball0.u.y */
    out[89] = CARDAN_REAL(w[7]); /* M: ball0.u.y,ball0.u.z */
    out[108] = CARDAN_REAL(w[6]); /* M: ball0.u.z,ball0.u.x */
    out[109] = CARDAN_REAL(w[7]); /* M: ball0.u.z,ball0.u.y */
    out[110] = CARDAN_REAL(w[10]); /* M: ball0.u.z,ball0.u.z */
    out[176] = CARDAN_REAL(w[11]); /* M: slide1.u,slide1.u */
    out[242] = CARDAN_REAL(w[12]); /* M: slide2.u,slide2.u */
    out[308] = CARDAN_REAL(w[13]); /* M: slide3.u,slide3.u */
    out[374] = CARDAN_REAL(w[14]); /* M: slide4.u,slide4.u */
    out[440] = CARDAN_REAL(w[15]); /* M: slide5.u,slide5.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {441, 0, 47, 0, 22, 0, 0, 0, 0, 96, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
