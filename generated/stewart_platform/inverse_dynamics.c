/*
 * inverse_dynamics of stewart_platform
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: origins, base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 21, work 0, w 47
 * Operations per call: 666 = 368 mul, 156 add, 118 sub, 12 cos, 12 sin
 * Operations of prepare: 218 = 101 add, 78 mul, 39 sub
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
 * Input u (21): generalized speeds
 *   u[0]  hooke0.u.angle1 [rad/s]
 *   u[1]  hooke0.u.angle2 [rad/s]
 *   u[2]  slide0.u [m/s]
 *   u[3]  ball0.u.x [rad/s]
 *   u[4]  ball0.u.y [rad/s]
 *   u[5]  ball0.u.z [rad/s]
 *   u[6]  hooke1.u.angle1 [rad/s]
 *   u[7]  hooke1.u.angle2 [rad/s]
 *   u[8]  slide1.u [m/s]
 *   u[9]  hooke2.u.angle1 [rad/s]
 *   u[10]  hooke2.u.angle2 [rad/s]
 *   u[11]  slide2.u [m/s]
 *   u[12]  hooke3.u.angle1 [rad/s]
 *   u[13]  hooke3.u.angle2 [rad/s]
 *   u[14]  slide3.u [m/s]
 *   u[15]  hooke4.u.angle1 [rad/s]
 *   u[16]  hooke4.u.angle2 [rad/s]
 *   u[17]  slide4.u [m/s]
 *   u[18]  hooke5.u.angle1 [rad/s]
 *   u[19]  hooke5.u.angle2 [rad/s]
 *   u[20]  slide5.u [m/s]
 *
 * Input r (6): inputs of the model
 *   r[0]  drive0
 *   r[1]  drive1
 *   r[2]  drive2
 *   r[3]  drive3
 *   r[4]  drive4
 *   r[5]  drive5
 *
 * Input p (96): parameters, read by prepare_ only
 *
 * Input udot (21): derivatives of the speeds
 *   udot[0]  hooke0.u.angle1dot [rad/s^2]
 *   udot[1]  hooke0.u.angle2dot [rad/s^2]
 *   udot[2]  slide0.udot [m/s^2]
 *   udot[3]  ball0.u.xdot [rad/s^2]
 *   udot[4]  ball0.u.ydot [rad/s^2]
 *   udot[5]  ball0.u.zdot [rad/s^2]
 *   udot[6]  hooke1.u.angle1dot [rad/s^2]
 *   udot[7]  hooke1.u.angle2dot [rad/s^2]
 *   udot[8]  slide1.udot [m/s^2]
 *   udot[9]  hooke2.u.angle1dot [rad/s^2]
 *   udot[10]  hooke2.u.angle2dot [rad/s^2]
 *   udot[11]  slide2.udot [m/s^2]
 *   udot[12]  hooke3.u.angle1dot [rad/s^2]
 *   udot[13]  hooke3.u.angle2dot [rad/s^2]
 *   udot[14]  slide3.udot [m/s^2]
 *   udot[15]  hooke4.u.angle1dot [rad/s^2]
 *   udot[16]  hooke4.u.angle2dot [rad/s^2]
 *   udot[17]  slide4.udot [m/s^2]
 *   udot[18]  hooke5.u.angle1dot [rad/s^2]
 *   udot[19]  hooke5.u.angle2dot [rad/s^2]
 *   udot[20]  slide5.udot [m/s^2]
 *
 * Output tau (21)
 *   out[0]  hooke0.u.angle1.tau [N*m]
 *   out[1]  hooke0.u.angle2.tau [N*m]
 *   out[2]  slide0.u.tau [N]
 *   out[3]  ball0.u.x.tau [N*m]
 *   out[4]  ball0.u.y.tau [N*m]
 *   out[5]  ball0.u.z.tau [N*m]
 *   out[6]  hooke1.u.angle1.tau [N*m]
 *   out[7]  hooke1.u.angle2.tau [N*m]
 *   out[8]  slide1.u.tau [N]
 *   out[9]  hooke2.u.angle1.tau [N*m]
 *   out[10]  hooke2.u.angle2.tau [N*m]
 *   out[11]  slide2.u.tau [N]
 *   out[12]  hooke3.u.angle1.tau [N*m]
 *   out[13]  hooke3.u.angle2.tau [N*m]
 *   out[14]  slide3.u.tau [N]
 *   out[15]  hooke4.u.angle1.tau [N*m]
 *   out[16]  hooke4.u.angle2.tau [N*m]
 *   out[17]  slide4.u.tau [N]
 *   out[18]  hooke5.u.angle1.tau [N*m]
 *   out[19]  hooke5.u.angle2.tau [N*m]
 *   out[20]  slide5.u.tau [N]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
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
    const wreal tube0_first_moment_z = tube0_mass * tube0_com_z;
    const wreal tube0_com_z_times_first_moment_z = tube0_com_z * tube0_first_moment_z;
    const wreal tube0_origin_inertia_xx = tube0_inertia_xx + tube0_com_z_times_first_moment_z;
    const wreal tube0_origin_inertia_yy = tube0_inertia_yy + tube0_com_z_times_first_moment_z;
    const wreal tube0_base_half_trace = 0.5 * (tube0_inertia_zz + tube0_origin_inertia_xx
        + tube0_origin_inertia_yy);
    w[1] = tube0_first_moment_z;

    /* rod0: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal slide0_position_z = p[8]; /* m */
    const wreal rod0_mass = p[9]; /* kg */
    const wreal rod0_com_z = p[10]; /* m */
    const wreal rod0_inertia_xx = p[11]; /* kg m^2 */
    const wreal rod0_inertia_yy = p[12]; /* kg m^2 */
    const wreal rod0_inertia_zz = p[13]; /* kg m^2 */
    const wreal platform_mass = p[16]; /* kg */
    const wreal rod0_first_moment_z = rod0_mass * rod0_com_z;
    const wreal rod0_com_z_times_first_moment_z = rod0_com_z * rod0_first_moment_z;
    const wreal rod0_origin_inertia_xx = rod0_inertia_xx + rod0_com_z_times_first_moment_z;
    const wreal rod0_origin_inertia_yy = rod0_inertia_yy + rod0_com_z_times_first_moment_z;
    const wreal rod0_mass_shift = slide0_position_z * (rod0_first_moment_z
        + 0.5 * rod0_mass * slide0_position_z) * 2.0;
    const wreal rod0_origin_inertia_xx_plus_mass_shift = rod0_origin_inertia_xx + rod0_mass_shift;
    const wreal rod0_origin_inertia_yy_plus_mass_shift = rod0_origin_inertia_yy + rod0_mass_shift;
    const wreal rod0_base_mass = rod0_mass + platform_mass;
    const wreal rod0_base_half_trace = 0.5 * (rod0_inertia_zz
        + rod0_origin_inertia_xx_plus_mass_shift + rod0_origin_inertia_yy_plus_mass_shift);
    w[24] = rod0_base_mass;

    /* platform: mass, first moment, base, origin inertia */
    /* first_moment = sum m c */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal ball0_child_position_x = p[14]; /* m */
    const wreal ball0_child_position_y = p[15]; /* m */
    const wreal platform_com_z = p[17]; /* m */
    const wreal platform_inertia_xx = p[18]; /* kg m^2 */
    const wreal platform_inertia_yy = p[19]; /* kg m^2 */
    const wreal platform_inertia_zz = p[20]; /* kg m^2 */
    const wreal platform_minus_first_moment_x = ball0_child_position_x * platform_mass;
    const wreal platform_minus_first_moment_y = ball0_child_position_y * platform_mass;
    const wreal platform_first_moment_z = platform_mass * platform_com_z;
    const wreal ball0_child_position_x_times_platform_minus_first_moment_x = ball0_child_position_x
        * platform_minus_first_moment_x;
    const wreal ball0_child_position_y_times_platform_minus_first_moment_y = ball0_child_position_y
        * platform_minus_first_moment_y;
    const wreal platform_com_z_times_first_moment_z = platform_com_z * platform_first_moment_z;
    const wreal platform_base_second_moment_xy = ball0_child_position_y *
        platform_minus_first_moment_x;
    const wreal platform_origin_inertia_xz = platform_com_z * platform_minus_first_moment_x;
    const wreal platform_origin_inertia_yz = platform_com_z * platform_minus_first_moment_y;
    const wreal platform_origin_inertia_xx = platform_inertia_xx
        + ball0_child_position_y_times_platform_minus_first_moment_y
        + platform_com_z_times_first_moment_z;
    const wreal platform_origin_inertia_yy = platform_inertia_yy
        + ball0_child_position_x_times_platform_minus_first_moment_x
        + platform_com_z_times_first_moment_z;
    const wreal platform_origin_inertia_zz = platform_inertia_zz
        + ball0_child_position_x_times_platform_minus_first_moment_x
        + ball0_child_position_y_times_platform_minus_first_moment_y;
    const wreal platform_base_mass_moment_z = slide0_position_z * platform_mass;
    const wreal platform_base_half_trace = 0.5 * (platform_origin_inertia_xx
        + platform_origin_inertia_zz + platform_origin_inertia_yy);
    const wreal platform_base_second_moment_xx = platform_base_half_trace
        - platform_origin_inertia_xx;
    const wreal platform_base_second_moment_yy = platform_base_half_trace
        - platform_origin_inertia_yy;
    const wreal platform_base_second_moment_zz = platform_base_half_trace
        - platform_origin_inertia_zz;
    w[3] = platform_minus_first_moment_x;
    w[4] = platform_minus_first_moment_y;
    w[5] = platform_first_moment_z;
    w[6] = platform_base_second_moment_xy;
    w[7] = platform_origin_inertia_xz;
    w[8] = platform_origin_inertia_yz;
    w[26] = platform_base_second_moment_xx;
    w[27] = platform_base_second_moment_yy;
    w[28] = platform_base_second_moment_zz;

    /* tube1: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube1_mass = p[23]; /* kg */
    const wreal tube1_com_z = p[24]; /* m */
    const wreal tube1_inertia_xx = p[25]; /* kg m^2 */
    const wreal tube1_inertia_yy = p[26]; /* kg m^2 */
    const wreal tube1_inertia_zz = p[27]; /* kg m^2 */
    const wreal tube1_first_moment_z = tube1_mass * tube1_com_z;
    const wreal tube1_com_z_times_first_moment_z = tube1_com_z * tube1_first_moment_z;
    const wreal tube1_origin_inertia_xx = tube1_inertia_xx + tube1_com_z_times_first_moment_z;
    const wreal tube1_origin_inertia_yy = tube1_inertia_yy + tube1_com_z_times_first_moment_z;
    const wreal tube1_base_half_trace = 0.5 * (tube1_inertia_zz + tube1_origin_inertia_xx
        + tube1_origin_inertia_yy);
    w[9] = tube1_first_moment_z;

    /* rod1: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal slide1_position_z = p[28]; /* m */
    const wreal rod1_mass = p[29]; /* kg */
    const wreal rod1_com_z = p[30]; /* m */
    const wreal rod1_inertia_xx = p[31]; /* kg m^2 */
    const wreal rod1_inertia_yy = p[32]; /* kg m^2 */
    const wreal rod1_inertia_zz = p[33]; /* kg m^2 */
    const wreal rod1_first_moment_z = rod1_mass * rod1_com_z;
    const wreal rod1_com_z_times_first_moment_z = rod1_com_z * rod1_first_moment_z;
    const wreal rod1_origin_inertia_xx = rod1_inertia_xx + rod1_com_z_times_first_moment_z;
    const wreal rod1_origin_inertia_yy = rod1_inertia_yy + rod1_com_z_times_first_moment_z;
    const wreal rod1_mass_shift = slide1_position_z * (rod1_first_moment_z
        + 0.5 * rod1_mass * slide1_position_z) * 2.0;
    const wreal rod1_base_moment_z = rod1_first_moment_z + slide1_position_z * rod1_mass;
    const wreal rod1_base_inertia_xx = rod1_origin_inertia_xx + rod1_mass_shift;
    const wreal rod1_base_inertia_yy = rod1_origin_inertia_yy + rod1_mass_shift;
    const wreal rod1_base_half_trace = 0.5 * (rod1_inertia_zz + rod1_base_inertia_xx
        + rod1_base_inertia_yy);
    w[19] = rod1_base_moment_z;

    /* tube2: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube2_mass = p[36]; /* kg */
    const wreal tube2_com_z = p[37]; /* m */
    const wreal tube2_inertia_xx = p[38]; /* kg m^2 */
    const wreal tube2_inertia_yy = p[39]; /* kg m^2 */
    const wreal tube2_inertia_zz = p[40]; /* kg m^2 */
    const wreal tube2_first_moment_z = tube2_mass * tube2_com_z;
    const wreal tube2_com_z_times_first_moment_z = tube2_com_z * tube2_first_moment_z;
    const wreal tube2_origin_inertia_xx = tube2_inertia_xx + tube2_com_z_times_first_moment_z;
    const wreal tube2_origin_inertia_yy = tube2_inertia_yy + tube2_com_z_times_first_moment_z;
    const wreal tube2_base_half_trace = 0.5 * (tube2_inertia_zz + tube2_origin_inertia_xx
        + tube2_origin_inertia_yy);
    w[11] = tube2_first_moment_z;

    /* rod2: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal slide2_position_z = p[41]; /* m */
    const wreal rod2_mass = p[42]; /* kg */
    const wreal rod2_com_z = p[43]; /* m */
    const wreal rod2_inertia_xx = p[44]; /* kg m^2 */
    const wreal rod2_inertia_yy = p[45]; /* kg m^2 */
    const wreal rod2_inertia_zz = p[46]; /* kg m^2 */
    const wreal rod2_first_moment_z = rod2_mass * rod2_com_z;
    const wreal rod2_com_z_times_first_moment_z = rod2_com_z * rod2_first_moment_z;
    const wreal rod2_origin_inertia_xx = rod2_inertia_xx + rod2_com_z_times_first_moment_z;
    const wreal rod2_origin_inertia_yy = rod2_inertia_yy + rod2_com_z_times_first_moment_z;
    const wreal rod2_mass_shift = slide2_position_z * (rod2_first_moment_z
        + 0.5 * rod2_mass * slide2_position_z) * 2.0;
    const wreal rod2_base_moment_z = rod2_first_moment_z + slide2_position_z * rod2_mass;
    const wreal rod2_base_inertia_xx = rod2_origin_inertia_xx + rod2_mass_shift;
    const wreal rod2_base_inertia_yy = rod2_origin_inertia_yy + rod2_mass_shift;
    const wreal rod2_base_half_trace = 0.5 * (rod2_inertia_zz + rod2_base_inertia_xx
        + rod2_base_inertia_yy);
    w[20] = rod2_base_moment_z;

    /* tube3: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube3_mass = p[49]; /* kg */
    const wreal tube3_com_z = p[50]; /* m */
    const wreal tube3_inertia_xx = p[51]; /* kg m^2 */
    const wreal tube3_inertia_yy = p[52]; /* kg m^2 */
    const wreal tube3_inertia_zz = p[53]; /* kg m^2 */
    const wreal tube3_first_moment_z = tube3_mass * tube3_com_z;
    const wreal tube3_com_z_times_first_moment_z = tube3_com_z * tube3_first_moment_z;
    const wreal tube3_origin_inertia_xx = tube3_inertia_xx + tube3_com_z_times_first_moment_z;
    const wreal tube3_origin_inertia_yy = tube3_inertia_yy + tube3_com_z_times_first_moment_z;
    const wreal tube3_base_half_trace = 0.5 * (tube3_inertia_zz + tube3_origin_inertia_xx
        + tube3_origin_inertia_yy);
    w[13] = tube3_first_moment_z;

    /* rod3: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal slide3_position_z = p[54]; /* m */
    const wreal rod3_mass = p[55]; /* kg */
    const wreal rod3_com_z = p[56]; /* m */
    const wreal rod3_inertia_xx = p[57]; /* kg m^2 */
    const wreal rod3_inertia_yy = p[58]; /* kg m^2 */
    const wreal rod3_inertia_zz = p[59]; /* kg m^2 */
    const wreal rod3_first_moment_z = rod3_mass * rod3_com_z;
    const wreal rod3_com_z_times_first_moment_z = rod3_com_z * rod3_first_moment_z;
    const wreal rod3_origin_inertia_xx = rod3_inertia_xx + rod3_com_z_times_first_moment_z;
    const wreal rod3_origin_inertia_yy = rod3_inertia_yy + rod3_com_z_times_first_moment_z;
    const wreal rod3_mass_shift = slide3_position_z * (rod3_first_moment_z
        + 0.5 * rod3_mass * slide3_position_z) * 2.0;
    const wreal rod3_base_moment_z = rod3_first_moment_z + slide3_position_z * rod3_mass;
    const wreal rod3_base_inertia_xx = rod3_origin_inertia_xx + rod3_mass_shift;
    const wreal rod3_base_inertia_yy = rod3_origin_inertia_yy + rod3_mass_shift;
    const wreal rod3_base_half_trace = 0.5 * (rod3_inertia_zz + rod3_base_inertia_xx
        + rod3_base_inertia_yy);
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
    const wreal tube4_first_moment_z = tube4_mass * tube4_com_z;
    const wreal tube4_com_z_times_first_moment_z = tube4_com_z * tube4_first_moment_z;
    const wreal tube4_origin_inertia_xx = tube4_inertia_xx + tube4_com_z_times_first_moment_z;
    const wreal tube4_origin_inertia_yy = tube4_inertia_yy + tube4_com_z_times_first_moment_z;
    const wreal tube4_base_half_trace = 0.5 * (tube4_inertia_zz + tube4_origin_inertia_xx
        + tube4_origin_inertia_yy);
    w[15] = tube4_first_moment_z;

    /* rod4: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal slide4_position_z = p[67]; /* m */
    const wreal rod4_mass = p[68]; /* kg */
    const wreal rod4_com_z = p[69]; /* m */
    const wreal rod4_inertia_xx = p[70]; /* kg m^2 */
    const wreal rod4_inertia_yy = p[71]; /* kg m^2 */
    const wreal rod4_inertia_zz = p[72]; /* kg m^2 */
    const wreal rod4_first_moment_z = rod4_mass * rod4_com_z;
    const wreal rod4_com_z_times_first_moment_z = rod4_com_z * rod4_first_moment_z;
    const wreal rod4_origin_inertia_xx = rod4_inertia_xx + rod4_com_z_times_first_moment_z;
    const wreal rod4_origin_inertia_yy = rod4_inertia_yy + rod4_com_z_times_first_moment_z;
    const wreal rod4_mass_shift = slide4_position_z * (rod4_first_moment_z
        + 0.5 * rod4_mass * slide4_position_z) * 2.0;
    const wreal rod4_base_moment_z = rod4_first_moment_z + slide4_position_z * rod4_mass;
    const wreal rod4_base_inertia_xx = rod4_origin_inertia_xx + rod4_mass_shift;
    const wreal rod4_base_inertia_yy = rod4_origin_inertia_yy + rod4_mass_shift;
    const wreal rod4_base_half_trace = 0.5 * (rod4_inertia_zz + rod4_base_inertia_xx
        + rod4_base_inertia_yy);
    w[22] = rod4_base_moment_z;

    /* tube5: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube5_mass = p[75]; /* kg */
    const wreal tube5_com_z = p[76]; /* m */
    const wreal tube5_inertia_xx = p[77]; /* kg m^2 */
    const wreal tube5_inertia_yy = p[78]; /* kg m^2 */
    const wreal tube5_inertia_zz = p[79]; /* kg m^2 */
    const wreal tube5_first_moment_z = tube5_mass * tube5_com_z;
    const wreal tube5_com_z_times_first_moment_z = tube5_com_z * tube5_first_moment_z;
    const wreal tube5_origin_inertia_xx = tube5_inertia_xx + tube5_com_z_times_first_moment_z;
    const wreal tube5_origin_inertia_yy = tube5_inertia_yy + tube5_com_z_times_first_moment_z;
    const wreal tube5_base_half_trace = 0.5 * (tube5_inertia_zz + tube5_origin_inertia_xx
        + tube5_origin_inertia_yy);
    w[17] = tube5_first_moment_z;

    /* rod5: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal slide5_position_z = p[80]; /* m */
    const wreal rod5_mass = p[81]; /* kg */
    const wreal rod5_com_z = p[82]; /* m */
    const wreal rod5_inertia_xx = p[83]; /* kg m^2 */
    const wreal rod5_inertia_yy = p[84]; /* kg m^2 */
    const wreal rod5_inertia_zz = p[85]; /* kg m^2 */
    const wreal rod5_first_moment_z = rod5_mass * rod5_com_z;
    const wreal rod5_com_z_times_first_moment_z = rod5_com_z * rod5_first_moment_z;
    const wreal rod5_origin_inertia_xx = rod5_inertia_xx + rod5_com_z_times_first_moment_z;
    const wreal rod5_origin_inertia_yy = rod5_inertia_yy + rod5_com_z_times_first_moment_z;
    const wreal rod5_mass_shift = slide5_position_z * (rod5_first_moment_z
        + 0.5 * rod5_mass * slide5_position_z) * 2.0;
    const wreal rod5_base_moment_z = rod5_first_moment_z + slide5_position_z * rod5_mass;
    const wreal rod5_base_inertia_xx = rod5_origin_inertia_xx + rod5_mass_shift;
    const wreal rod5_base_inertia_yy = rod5_origin_inertia_yy + rod5_mass_shift;
    const wreal rod5_base_half_trace = 0.5 * (rod5_inertia_zz + rod5_base_inertia_xx
        + rod5_base_inertia_yy);
    w[23] = rod5_base_moment_z;

    /* rod0: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal rod0_base_moment_z = rod0_first_moment_z + slide0_position_z * rod0_mass
        + platform_base_mass_moment_z;
    w[25] = rod0_base_moment_z;

    /* tube5: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube5_base_second_moment_xx = tube5_base_half_trace - tube5_origin_inertia_xx
        + (rod5_base_half_trace - rod5_base_inertia_xx);
    const wreal tube5_base_second_moment_yy = tube5_base_half_trace - tube5_origin_inertia_yy
        + (rod5_base_half_trace - rod5_base_inertia_yy);
    const wreal tube5_base_second_moment_zz = tube5_base_half_trace - tube5_inertia_zz
        + (rod5_base_half_trace - rod5_inertia_zz);
    w[29] = tube5_base_second_moment_xx;
    w[30] = tube5_base_second_moment_yy;
    w[31] = tube5_base_second_moment_zz;

    /* tube4: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube4_base_second_moment_xx = tube4_base_half_trace - tube4_origin_inertia_xx
        + (rod4_base_half_trace - rod4_base_inertia_xx);
    const wreal tube4_base_second_moment_yy = tube4_base_half_trace - tube4_origin_inertia_yy
        + (rod4_base_half_trace - rod4_base_inertia_yy);
    const wreal tube4_base_second_moment_zz = tube4_base_half_trace - tube4_inertia_zz
        + (rod4_base_half_trace - rod4_inertia_zz);
    w[32] = tube4_base_second_moment_xx;
    w[33] = tube4_base_second_moment_yy;
    w[34] = tube4_base_second_moment_zz;

    /* tube3: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube3_base_second_moment_xx = tube3_base_half_trace - tube3_origin_inertia_xx
        + (rod3_base_half_trace - rod3_base_inertia_xx);
    const wreal tube3_base_second_moment_yy = tube3_base_half_trace - tube3_origin_inertia_yy
        + (rod3_base_half_trace - rod3_base_inertia_yy);
    const wreal tube3_base_second_moment_zz = tube3_base_half_trace - tube3_inertia_zz
        + (rod3_base_half_trace - rod3_inertia_zz);
    w[35] = tube3_base_second_moment_xx;
    w[36] = tube3_base_second_moment_yy;
    w[37] = tube3_base_second_moment_zz;

    /* tube2: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube2_base_second_moment_xx = tube2_base_half_trace - tube2_origin_inertia_xx
        + (rod2_base_half_trace - rod2_base_inertia_xx);
    const wreal tube2_base_second_moment_yy = tube2_base_half_trace - tube2_origin_inertia_yy
        + (rod2_base_half_trace - rod2_base_inertia_yy);
    const wreal tube2_base_second_moment_zz = tube2_base_half_trace - tube2_inertia_zz
        + (rod2_base_half_trace - rod2_inertia_zz);
    w[38] = tube2_base_second_moment_xx;
    w[39] = tube2_base_second_moment_yy;
    w[40] = tube2_base_second_moment_zz;

    /* tube1: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube1_base_second_moment_xx = tube1_base_half_trace - tube1_origin_inertia_xx
        + (rod1_base_half_trace - rod1_base_inertia_xx);
    const wreal tube1_base_second_moment_yy = tube1_base_half_trace - tube1_origin_inertia_yy
        + (rod1_base_half_trace - rod1_base_inertia_yy);
    const wreal tube1_base_second_moment_zz = tube1_base_half_trace - tube1_inertia_zz
        + (rod1_base_half_trace - rod1_inertia_zz);
    w[41] = tube1_base_second_moment_xx;
    w[42] = tube1_base_second_moment_yy;
    w[43] = tube1_base_second_moment_zz;

    /* tube0: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube0_base_second_moment_xx = tube0_base_half_trace - tube0_origin_inertia_xx
        + (rod0_base_half_trace - rod0_origin_inertia_xx_plus_mass_shift);
    const wreal tube0_base_second_moment_yy = tube0_base_half_trace - tube0_origin_inertia_yy
        + (rod0_base_half_trace - rod0_origin_inertia_yy_plus_mass_shift);
    const wreal tube0_base_second_moment_zz = slide0_position_z * platform_base_mass_moment_z
        + rod0_base_half_trace + (tube0_base_half_trace - tube0_inertia_zz - rod0_inertia_zz);
    w[44] = tube0_base_second_moment_xx;
    w[45] = tube0_base_second_moment_yy;
    w[46] = tube0_base_second_moment_zz;

    /* parameters as they are */
    w[0] = p[0]; /* gravity.z [m/s^2] */
    w[2] = p[8]; /* slide0.position.z [m] */
    w[10] = p[29]; /* rod1.mass [kg] */
    w[12] = p[42]; /* rod2.mass [kg] */
    w[14] = p[55]; /* rod3.mass [kg] */
    w[16] = p[68]; /* rod4.mass [kg] */
    w[18] = p[81]; /* rod5.mass [kg] */
}

#include "lanes.h"

/* tau with M udot + h = f + tau */
CARDAN_API int inverse_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const real *const r = in->r;
    const wreal *const w = in->w;
    const real *const udot = in->udot;
    (void)work;

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
    const real hooke0_angle1 = q[0]; /* rad */
    const real hooke0_angle2 = q[1]; /* rad */
    const real hooke1_angle1 = q[7]; /* rad */
    const real hooke1_angle2 = q[8]; /* rad */
    const real hooke2_angle1 = q[10]; /* rad */
    const real hooke2_angle2 = q[11]; /* rad */
    const real hooke3_angle1 = q[13]; /* rad */
    const real hooke3_angle2 = q[14]; /* rad */
    const real hooke4_angle1 = q[16]; /* rad */
    const real hooke4_angle2 = q[17]; /* rad */
    const real hooke5_angle1 = q[19]; /* rad */
    const real hooke5_angle2 = q[20]; /* rad */
    const real angle[CARDAN_PADDED(12)] = {hooke0_angle1, hooke0_angle2, hooke1_angle1,
        hooke1_angle2, hooke2_angle1, hooke2_angle2, hooke3_angle1, hooke3_angle2, hooke4_angle1,
        hooke4_angle2, hooke5_angle1, hooke5_angle2};
    real sine[CARDAN_PADDED(12)], cosine[CARDAN_PADDED(12)];
    cardan_sincos(12, angle, sine, cosine);
    const real hooke0_angle1_cos = cosine[0];
    const real hooke0_angle1_sin = sine[0];
    const real hooke0_angle2_cos = cosine[1];
    const real hooke0_angle2_sin = sine[1];
    const real hooke1_angle1_cos = cosine[2];
    const real hooke1_angle1_sin = sine[2];
    const real hooke1_angle2_cos = cosine[3];
    const real hooke1_angle2_sin = sine[3];
    const real hooke2_angle1_cos = cosine[4];
    const real hooke2_angle1_sin = sine[4];
    const real hooke2_angle2_cos = cosine[5];
    const real hooke2_angle2_sin = sine[5];
    const real hooke3_angle1_cos = cosine[6];
    const real hooke3_angle1_sin = sine[6];
    const real hooke3_angle2_cos = cosine[7];
    const real hooke3_angle2_sin = sine[7];
    const real hooke4_angle1_cos = cosine[8];
    const real hooke4_angle1_sin = sine[8];
    const real hooke4_angle2_cos = cosine[9];
    const real hooke4_angle2_sin = sine[9];
    const real hooke5_angle1_cos = cosine[10];
    const real hooke5_angle1_sin = sine[10];
    const real hooke5_angle2_cos = cosine[11];
    const real hooke5_angle2_sin = sine[11];

    /* tube0: a, omega */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* omega = Rᵀ omega_parent + S_w u */
    const real hooke0_u_angle1 = u[0]; /* rad/s */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const real tube0_minus_a_y = gravity_z * hooke0_angle1_sin;
    const real tube0_a_x = hooke0_angle1_cos * hooke0_angle2_sin * gravity_z;
    const real tube0_omega_x = hooke0_u_angle1 * hooke0_angle2_cos;
    const real tube0_omega_z = hooke0_u_angle1 * hooke0_angle2_sin;

    /* hooke0: R, drift */
    /* R = R_fixed R_joint(q) */
    /* drift = S' u + [0; omega x v] */
    const real hooke0_u_angle2 = u[1]; /* rad/s */
    const real hooke0_R_zz = hooke0_angle1_cos * hooke0_angle2_cos;
    const real hooke0_u_angle1_times_u_angle2 = hooke0_u_angle1 * hooke0_u_angle2;

    /* tube0: alpha */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    const real hooke0_u_angle1dot = udot[0]; /* rad/s^2 */
    const real tube0_alpha_x = hooke0_u_angle1dot * hooke0_angle2_cos
        - hooke0_angle2_sin * hooke0_u_angle1_times_u_angle2;
    const real tube0_alpha_z = hooke0_angle2_cos * hooke0_u_angle1_times_u_angle2
        + hooke0_u_angle1dot * hooke0_angle2_sin;

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

    /* platform: alpha, omega, U, inertia force, f */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* omega = Rᵀ omega_parent + S_w u */
    /* U = [alpha] + [omega][omega] */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real ball0_u_x = u[3]; /* rad/s */
    const real ball0_u_y = u[4]; /* rad/s */
    const real ball0_u_z = u[5]; /* rad/s */
    const real hooke0_u_angle2dot = udot[1]; /* rad/s^2 */
    const real ball0_u_xdot = udot[3]; /* rad/s^2 */
    const real ball0_u_ydot = udot[4]; /* rad/s^2 */
    const real ball0_u_zdot = udot[5]; /* rad/s^2 */
    const wreal platform_minus_first_moment_x = w[3];
    const wreal platform_minus_first_moment_y = w[4];
    const wreal platform_first_moment_z = w[5];
    const real platform_alpha_parent_omega_x = tube0_omega_x * ball0_R_xx
        + hooke0_u_angle2 * ball0_R_yx + tube0_omega_z * ball0_R_zx;
    const real platform_alpha_parent_omega_y = tube0_omega_x * ball0_R_xy
        + hooke0_u_angle2 * ball0_R_yy + tube0_omega_z * ball0_R_zy;
    const real platform_alpha_parent_omega_z = tube0_omega_x * ball0_R_xz
        + hooke0_u_angle2 * ball0_R_yz + tube0_omega_z * ball0_R_zz;
    const real platform_omega_x = ball0_u_x + platform_alpha_parent_omega_x;
    const real platform_omega_y = ball0_u_y + platform_alpha_parent_omega_y;
    const real platform_omega_z = ball0_u_z + platform_alpha_parent_omega_z;
    const real platform_alpha_x = ball0_u_xdot + hooke0_u_angle2dot * ball0_R_yx
        + tube0_alpha_x * ball0_R_xx + tube0_alpha_z * ball0_R_zx
        + (ball0_u_z * platform_alpha_parent_omega_y - ball0_u_y * platform_alpha_parent_omega_z);
    const real platform_alpha_y = ball0_u_ydot + hooke0_u_angle2dot * ball0_R_yy
        + tube0_alpha_x * ball0_R_xy + tube0_alpha_z * ball0_R_zy
        + (ball0_u_x * platform_alpha_parent_omega_z - ball0_u_z * platform_alpha_parent_omega_x);
    const real platform_alpha_z = ball0_u_zdot + hooke0_u_angle2dot * ball0_R_yz
        + tube0_alpha_x * ball0_R_xz + tube0_alpha_z * ball0_R_zz
        + (ball0_u_y * platform_alpha_parent_omega_x - ball0_u_x * platform_alpha_parent_omega_y);
    const real platform_omega_x_squared = platform_omega_x * platform_omega_x;
    const real platform_omega_y_squared = platform_omega_y * platform_omega_y;
    const real platform_omega_z_squared = platform_omega_z * platform_omega_z;
    const real platform_omega_x_times_omega_y = platform_omega_x * platform_omega_y;
    const real platform_omega_x_times_omega_z = platform_omega_x * platform_omega_z;
    const real platform_omega_y_times_omega_z = platform_omega_y * platform_omega_z;
    const real platform_minus_U_xx = platform_omega_y_squared + platform_omega_z_squared;
    const real platform_minus_U_yy = platform_omega_x_squared + platform_omega_z_squared;
    const real platform_minus_U_zz = platform_omega_x_squared + platform_omega_y_squared;
    const real platform_U_xy = platform_omega_x_times_omega_y - platform_alpha_z;
    const real platform_U_yx = platform_alpha_z + platform_omega_x_times_omega_y;
    const real platform_U_xz = platform_alpha_y + platform_omega_x_times_omega_z;
    const real platform_U_zx = platform_omega_x_times_omega_z - platform_alpha_y;
    const real platform_U_yz = platform_omega_y_times_omega_z - platform_alpha_x;
    const real platform_U_zy = platform_alpha_x + platform_omega_y_times_omega_z;
    const real platform_minus_f_z = platform_minus_first_moment_x * platform_U_zx
        + platform_first_moment_z * platform_minus_U_zz
        + platform_minus_first_moment_y * platform_U_zy;
    const real platform_f_y = platform_minus_first_moment_y * platform_minus_U_yy
        - platform_minus_first_moment_x * platform_U_yx + platform_first_moment_z * platform_U_yz;
    const real platform_f_x = platform_minus_first_moment_x * platform_minus_U_xx
        - platform_minus_first_moment_y * platform_U_xy + platform_first_moment_z * platform_U_xz;
    const real rod0_f_x_part = ball0_R_xx * platform_f_x + ball0_R_xy * platform_f_y
        - ball0_R_xz * platform_minus_f_z;
    const real rod0_f_y_part = ball0_R_yx * platform_f_x + ball0_R_yy * platform_f_y
        - ball0_R_yz * platform_minus_f_z;

    /* tube1: a, omega */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* omega = Rᵀ omega_parent + S_w u */
    const real hooke1_u_angle1 = u[6]; /* rad/s */
    const real tube1_minus_a_y = gravity_z * hooke1_angle1_sin;
    const real tube1_a_x = hooke1_angle1_cos * hooke1_angle2_sin * gravity_z;
    const real tube1_omega_x = hooke1_u_angle1 * hooke1_angle2_cos;
    const real tube1_omega_z = hooke1_u_angle1 * hooke1_angle2_sin;

    /* hooke1: R, drift */
    /* R = R_fixed R_joint(q) */
    /* drift = S' u + [0; omega x v] */
    const real hooke1_u_angle2 = u[7]; /* rad/s */
    const real hooke1_R_zz = hooke1_angle1_cos * hooke1_angle2_cos;
    const real hooke1_u_angle1_times_u_angle2 = hooke1_u_angle1 * hooke1_u_angle2;

    /* tube2: a, omega */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* omega = Rᵀ omega_parent + S_w u */
    const real hooke2_u_angle1 = u[9]; /* rad/s */
    const real tube2_minus_a_y = gravity_z * hooke2_angle1_sin;
    const real tube2_a_x = hooke2_angle1_cos * hooke2_angle2_sin * gravity_z;
    const real tube2_omega_x = hooke2_u_angle1 * hooke2_angle2_cos;
    const real tube2_omega_z = hooke2_u_angle1 * hooke2_angle2_sin;

    /* hooke2: R, drift */
    /* R = R_fixed R_joint(q) */
    /* drift = S' u + [0; omega x v] */
    const real hooke2_u_angle2 = u[10]; /* rad/s */
    const real hooke2_R_zz = hooke2_angle1_cos * hooke2_angle2_cos;
    const real hooke2_u_angle1_times_u_angle2 = hooke2_u_angle1 * hooke2_u_angle2;

    /* tube3: a, omega */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* omega = Rᵀ omega_parent + S_w u */
    const real hooke3_u_angle1 = u[12]; /* rad/s */
    const real tube3_minus_a_y = gravity_z * hooke3_angle1_sin;
    const real tube3_a_x = hooke3_angle1_cos * hooke3_angle2_sin * gravity_z;
    const real tube3_omega_x = hooke3_u_angle1 * hooke3_angle2_cos;
    const real tube3_omega_z = hooke3_u_angle1 * hooke3_angle2_sin;

    /* hooke3: R, drift */
    /* R = R_fixed R_joint(q) */
    /* drift = S' u + [0; omega x v] */
    const real hooke3_u_angle2 = u[13]; /* rad/s */
    const real hooke3_R_zz = hooke3_angle1_cos * hooke3_angle2_cos;
    const real hooke3_u_angle1_times_u_angle2 = hooke3_u_angle1 * hooke3_u_angle2;

    /* tube4: a, omega */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* omega = Rᵀ omega_parent + S_w u */
    const real hooke4_u_angle1 = u[15]; /* rad/s */
    const real tube4_minus_a_y = gravity_z * hooke4_angle1_sin;
    const real tube4_a_x = hooke4_angle1_cos * hooke4_angle2_sin * gravity_z;
    const real tube4_omega_x = hooke4_u_angle1 * hooke4_angle2_cos;
    const real tube4_omega_z = hooke4_u_angle1 * hooke4_angle2_sin;

    /* hooke4: R, drift */
    /* R = R_fixed R_joint(q) */
    /* drift = S' u + [0; omega x v] */
    const real hooke4_u_angle2 = u[16]; /* rad/s */
    const real hooke4_R_zz = hooke4_angle1_cos * hooke4_angle2_cos;
    const real hooke4_u_angle1_times_u_angle2 = hooke4_u_angle1 * hooke4_u_angle2;

    /* tube5: a, omega */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* omega = Rᵀ omega_parent + S_w u */
    const real hooke5_u_angle1 = u[18]; /* rad/s */
    const real tube5_minus_a_y = gravity_z * hooke5_angle1_sin;
    const real tube5_a_x = hooke5_angle1_cos * hooke5_angle2_sin * gravity_z;
    const real tube5_omega_x = hooke5_u_angle1 * hooke5_angle2_cos;
    const real tube5_omega_z = hooke5_u_angle1 * hooke5_angle2_sin;

    /* hooke5: R, drift */
    /* R = R_fixed R_joint(q) */
    /* drift = S' u + [0; omega x v] */
    const real hooke5_u_angle2 = u[19]; /* rad/s */
    const real hooke5_R_zz = hooke5_angle1_cos * hooke5_angle2_cos;
    const real hooke5_u_angle1_times_u_angle2 = hooke5_u_angle1 * hooke5_u_angle2;

    /* shared by several: U */
    /* U = [alpha] + [omega][omega] */
    const real tube0_minus_U_zz = tube0_omega_x * tube0_omega_x + hooke0_u_angle2 * hooke0_u_angle2;
    const real hooke0_u_angle2_times_tube0_omega_x = hooke0_u_angle2 * tube0_omega_x;
    const real tube0_omega_x_times_omega_z = tube0_omega_x * tube0_omega_z;
    const real hooke0_u_angle2_times_tube0_omega_z = hooke0_u_angle2 * tube0_omega_z;
    const real tube1_minus_U_zz = tube1_omega_x * tube1_omega_x + hooke1_u_angle2 * hooke1_u_angle2;
    const real hooke1_u_angle2_times_tube1_omega_x = hooke1_u_angle2 * tube1_omega_x;
    const real tube1_omega_x_times_omega_z = tube1_omega_x * tube1_omega_z;
    const real hooke1_u_angle2_times_tube1_omega_z = hooke1_u_angle2 * tube1_omega_z;
    const real tube2_minus_U_zz = tube2_omega_x * tube2_omega_x + hooke2_u_angle2 * hooke2_u_angle2;
    const real hooke2_u_angle2_times_tube2_omega_x = hooke2_u_angle2 * tube2_omega_x;
    const real tube2_omega_x_times_omega_z = tube2_omega_x * tube2_omega_z;
    const real hooke2_u_angle2_times_tube2_omega_z = hooke2_u_angle2 * tube2_omega_z;
    const real tube3_minus_U_zz = tube3_omega_x * tube3_omega_x + hooke3_u_angle2 * hooke3_u_angle2;
    const real hooke3_u_angle2_times_tube3_omega_x = hooke3_u_angle2 * tube3_omega_x;
    const real tube3_omega_x_times_omega_z = tube3_omega_x * tube3_omega_z;
    const real hooke3_u_angle2_times_tube3_omega_z = hooke3_u_angle2 * tube3_omega_z;
    const real tube4_minus_U_zz = tube4_omega_x * tube4_omega_x + hooke4_u_angle2 * hooke4_u_angle2;
    const real hooke4_u_angle2_times_tube4_omega_x = hooke4_u_angle2 * tube4_omega_x;
    const real tube4_omega_x_times_omega_z = tube4_omega_x * tube4_omega_z;
    const real hooke4_u_angle2_times_tube4_omega_z = hooke4_u_angle2 * tube4_omega_z;
    const real tube5_minus_U_zz = tube5_omega_x * tube5_omega_x + hooke5_u_angle2 * hooke5_u_angle2;
    const real hooke5_u_angle2_times_tube5_omega_x = hooke5_u_angle2 * tube5_omega_x;
    const real tube5_omega_x_times_omega_z = tube5_omega_x * tube5_omega_z;
    const real hooke5_u_angle2_times_tube5_omega_z = hooke5_u_angle2 * tube5_omega_z;

    /* tube0: U */
    /* U = [alpha] + [omega][omega] */
    const real tube0_U_xy = hooke0_u_angle2_times_tube0_omega_x - tube0_alpha_z;
    const real tube0_U_yx = tube0_alpha_z + hooke0_u_angle2_times_tube0_omega_x;
    const real tube0_U_xz = hooke0_u_angle2dot + tube0_omega_x_times_omega_z;
    const real tube0_U_zx = tube0_omega_x_times_omega_z - hooke0_u_angle2dot;
    const real tube0_U_yz = hooke0_u_angle2_times_tube0_omega_z - tube0_alpha_x;
    const real tube0_U_zy = tube0_alpha_x + hooke0_u_angle2_times_tube0_omega_z;

    /* rod0: a, f */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real slide0_q = q[2]; /* m */
    const real slide0_u = u[2]; /* m/s */
    const real slide0_udot = udot[2]; /* m/s^2 */
    const wreal rod0_base_mass = w[24];
    const wreal rod0_base_moment_z = w[25];
    const real rod0_a_x = tube0_a_x + hooke0_u_angle2 * slide0_u * 2.0 + slide0_q * tube0_U_xz;
    const real rod0_a_y = slide0_q * tube0_U_yz - (tube0_minus_a_y
        + slide0_u * tube0_omega_x * 2.0);
    const real rod0_a_z = slide0_udot - gravity_z * hooke0_R_zz - slide0_q * tube0_minus_U_zz;
    const real rod0_f_x = rod0_base_mass * rod0_a_x + rod0_base_moment_z * tube0_U_xz
        + rod0_f_x_part;
    const real rod0_f_z = rod0_base_mass * rod0_a_z - rod0_base_moment_z * tube0_minus_U_zz
        + ball0_R_zx * platform_f_x + (ball0_R_zy * platform_f_y - ball0_R_zz * platform_minus_f_z);
    const real rod0_f_y = rod0_base_mass * rod0_a_y + rod0_base_moment_z * tube0_U_yz
        + rod0_f_y_part;

    /* platform: a, inertia force, n */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal slide0_position_z = w[2]; /* m */
    const wreal platform_base_second_moment_xy = w[6];
    const wreal platform_origin_inertia_xz = w[7];
    const wreal platform_origin_inertia_yz = w[8];
    const wreal platform_base_second_moment_xx = w[26];
    const wreal platform_base_second_moment_yy = w[27];
    const wreal platform_base_second_moment_zz = w[28];
    const real rod0_a_x_plus_slide0_position_z_times_tube0_U_xz = rod0_a_x
        + slide0_position_z * tube0_U_xz;
    const real rod0_a_y_plus_slide0_position_z_times_tube0_U_yz = rod0_a_y
        + slide0_position_z * tube0_U_yz;
    const real rod0_a_z_minus_slide0_position_z_times_tube0_minus_U_zz = rod0_a_z
        - slide0_position_z * tube0_minus_U_zz;
    const real platform_a_x = ball0_R_xx * rod0_a_x_plus_slide0_position_z_times_tube0_U_xz
        + ball0_R_yx * rod0_a_y_plus_slide0_position_z_times_tube0_U_yz
        + ball0_R_zx * rod0_a_z_minus_slide0_position_z_times_tube0_minus_U_zz;
    const real platform_a_y = ball0_R_xy * rod0_a_x_plus_slide0_position_z_times_tube0_U_xz
        + ball0_R_yy * rod0_a_y_plus_slide0_position_z_times_tube0_U_yz
        + ball0_R_zy * rod0_a_z_minus_slide0_position_z_times_tube0_minus_U_zz;
    const real platform_a_z = ball0_R_xz * rod0_a_x_plus_slide0_position_z_times_tube0_U_xz
        + ball0_R_yz * rod0_a_y_plus_slide0_position_z_times_tube0_U_yz
        + ball0_R_zz * rod0_a_z_minus_slide0_position_z_times_tube0_minus_U_zz;
    const real platform_n_x_part = platform_base_second_moment_xy * platform_U_zx
        - platform_origin_inertia_yz * (platform_minus_U_yy - platform_minus_U_zz)
        + (platform_origin_inertia_xz * platform_U_yx
        - platform_minus_first_moment_y * platform_a_z);
    const real platform_n_x = platform_base_second_moment_yy * platform_U_zy
        - platform_base_second_moment_zz * platform_U_yz - platform_first_moment_z * platform_a_y
        + platform_n_x_part;
    const real platform_n_y_part = platform_first_moment_z * platform_a_x
        - platform_base_second_moment_xy * platform_U_zy
        - (platform_origin_inertia_xz * (platform_minus_U_zz - platform_minus_U_xx)
        + platform_origin_inertia_yz * platform_U_xy);
    const real platform_n_y = platform_base_second_moment_zz * platform_U_xz
        - platform_base_second_moment_xx * platform_U_zx
        + platform_minus_first_moment_x * platform_a_z + platform_n_y_part;
    const real platform_n_z_part = platform_base_second_moment_xy * (platform_minus_U_xx
        - platform_minus_U_yy) - platform_origin_inertia_xz * platform_U_yz
        + (platform_origin_inertia_yz * platform_U_xz
        + platform_minus_first_moment_y * platform_a_x);
    const real platform_n_z = platform_base_second_moment_xx * platform_U_yx
        - platform_base_second_moment_yy * platform_U_xy
        - platform_minus_first_moment_x * platform_a_y + platform_n_z_part;
    out[3] = platform_n_x; /* tau: ball0.u.x.tau [N*m] */
    out[4] = platform_n_y; /* tau: ball0.u.y.tau [N*m] */
    out[5] = platform_n_z; /* tau: ball0.u.z.tau [N*m] */

    /* tube1: alpha, U, n */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* U = [alpha] + [omega][omega] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real hooke1_u_angle1dot = udot[6]; /* rad/s^2 */
    const real hooke1_u_angle2dot = udot[7]; /* rad/s^2 */
    const wreal tube1_base_second_moment_xx = w[41];
    const wreal tube1_base_second_moment_yy = w[42];
    const real tube1_alpha_x = hooke1_u_angle1dot * hooke1_angle2_cos
        - hooke1_angle2_sin * hooke1_u_angle1_times_u_angle2;
    const real tube1_alpha_z = hooke1_angle2_cos * hooke1_u_angle1_times_u_angle2
        + hooke1_u_angle1dot * hooke1_angle2_sin;
    const real tube1_U_xy = hooke1_u_angle2_times_tube1_omega_x - tube1_alpha_z;
    const real tube1_U_yx = tube1_alpha_z + hooke1_u_angle2_times_tube1_omega_x;
    const real tube1_n_z = tube1_base_second_moment_xx * tube1_U_yx
        - tube1_base_second_moment_yy * tube1_U_xy;
    const real tube1_U_xz = hooke1_u_angle2dot + tube1_omega_x_times_omega_z;
    const real tube1_U_zx = tube1_omega_x_times_omega_z - hooke1_u_angle2dot;
    const real tube1_U_yz = hooke1_u_angle2_times_tube1_omega_z - tube1_alpha_x;
    const real tube1_U_zy = tube1_alpha_x + hooke1_u_angle2_times_tube1_omega_z;

    /* rod1: a, f, n */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* f = inertia_force_f - applied_f + sum R f_child */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real slide1_q = q[9]; /* m */
    const real slide1_u = u[8]; /* m/s */
    const real slide1_udot = udot[8]; /* m/s^2 */
    const wreal rod1_mass = w[10]; /* kg */
    const wreal rod1_base_moment_z = w[19];
    const real rod1_a_x = tube1_a_x + hooke1_u_angle2 * slide1_u * 2.0 + slide1_q * tube1_U_xz;
    const real rod1_a_y = slide1_q * tube1_U_yz - (tube1_minus_a_y
        + slide1_u * tube1_omega_x * 2.0);
    const real rod1_a_z = slide1_udot - gravity_z * hooke1_R_zz - slide1_q * tube1_minus_U_zz;
    const real rod1_f_z = rod1_mass * rod1_a_z - rod1_base_moment_z * tube1_minus_U_zz;
    const real rod1_f_y = rod1_mass * rod1_a_y + rod1_base_moment_z * tube1_U_yz;
    const real rod1_n_y = rod1_base_moment_z * rod1_a_x;
    const real rod1_f_x = rod1_mass * rod1_a_x + rod1_base_moment_z * tube1_U_xz;

    /* slide1: tau */
    /* tau = S . [n; f] - force on the joint */
    const real drive1 = r[1];
    out[8] = rod1_f_z - drive1; /* tau: slide1.u.tau [N] */

    /* tube2: alpha, U, n */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* U = [alpha] + [omega][omega] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real hooke2_u_angle1dot = udot[9]; /* rad/s^2 */
    const real hooke2_u_angle2dot = udot[10]; /* rad/s^2 */
    const wreal tube2_base_second_moment_xx = w[38];
    const wreal tube2_base_second_moment_yy = w[39];
    const real tube2_alpha_x = hooke2_u_angle1dot * hooke2_angle2_cos
        - hooke2_angle2_sin * hooke2_u_angle1_times_u_angle2;
    const real tube2_alpha_z = hooke2_angle2_cos * hooke2_u_angle1_times_u_angle2
        + hooke2_u_angle1dot * hooke2_angle2_sin;
    const real tube2_U_xy = hooke2_u_angle2_times_tube2_omega_x - tube2_alpha_z;
    const real tube2_U_yx = tube2_alpha_z + hooke2_u_angle2_times_tube2_omega_x;
    const real tube2_n_z = tube2_base_second_moment_xx * tube2_U_yx
        - tube2_base_second_moment_yy * tube2_U_xy;
    const real tube2_U_xz = hooke2_u_angle2dot + tube2_omega_x_times_omega_z;
    const real tube2_U_zx = tube2_omega_x_times_omega_z - hooke2_u_angle2dot;
    const real tube2_U_yz = hooke2_u_angle2_times_tube2_omega_z - tube2_alpha_x;
    const real tube2_U_zy = tube2_alpha_x + hooke2_u_angle2_times_tube2_omega_z;

    /* rod2: a, f, n */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* f = inertia_force_f - applied_f + sum R f_child */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real slide2_q = q[12]; /* m */
    const real slide2_u = u[11]; /* m/s */
    const real slide2_udot = udot[11]; /* m/s^2 */
    const wreal rod2_mass = w[12]; /* kg */
    const wreal rod2_base_moment_z = w[20];
    const real rod2_a_x = tube2_a_x + hooke2_u_angle2 * slide2_u * 2.0 + slide2_q * tube2_U_xz;
    const real rod2_a_y = slide2_q * tube2_U_yz - (tube2_minus_a_y
        + slide2_u * tube2_omega_x * 2.0);
    const real rod2_a_z = slide2_udot - gravity_z * hooke2_R_zz - slide2_q * tube2_minus_U_zz;
    const real rod2_f_z = rod2_mass * rod2_a_z - rod2_base_moment_z * tube2_minus_U_zz;
    const real rod2_f_y = rod2_mass * rod2_a_y + rod2_base_moment_z * tube2_U_yz;
    const real rod2_n_y = rod2_base_moment_z * rod2_a_x;
    const real rod2_f_x = rod2_mass * rod2_a_x + rod2_base_moment_z * tube2_U_xz;

    /* slide2: tau */
    /* tau = S . [n; f] - force on the joint */
    const real drive2 = r[2];
    out[11] = rod2_f_z - drive2; /* tau: slide2.u.tau [N] */

    /* tube3: alpha, U, n */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* U = [alpha] + [omega][omega] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real hooke3_u_angle1dot = udot[12]; /* rad/s^2 */
    const real hooke3_u_angle2dot = udot[13]; /* rad/s^2 */
    const wreal tube3_base_second_moment_xx = w[35];
    const wreal tube3_base_second_moment_yy = w[36];
    const real tube3_alpha_x = hooke3_u_angle1dot * hooke3_angle2_cos
        - hooke3_angle2_sin * hooke3_u_angle1_times_u_angle2;
    const real tube3_alpha_z = hooke3_angle2_cos * hooke3_u_angle1_times_u_angle2
        + hooke3_u_angle1dot * hooke3_angle2_sin;
    const real tube3_U_xy = hooke3_u_angle2_times_tube3_omega_x - tube3_alpha_z;
    const real tube3_U_yx = tube3_alpha_z + hooke3_u_angle2_times_tube3_omega_x;
    const real tube3_n_z = tube3_base_second_moment_xx * tube3_U_yx
        - tube3_base_second_moment_yy * tube3_U_xy;
    const real tube3_U_xz = hooke3_u_angle2dot + tube3_omega_x_times_omega_z;
    const real tube3_U_zx = tube3_omega_x_times_omega_z - hooke3_u_angle2dot;
    const real tube3_U_yz = hooke3_u_angle2_times_tube3_omega_z - tube3_alpha_x;
    const real tube3_U_zy = tube3_alpha_x + hooke3_u_angle2_times_tube3_omega_z;

    /* rod3: a, f, n */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* f = inertia_force_f - applied_f + sum R f_child */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real slide3_q = q[15]; /* m */
    const real slide3_u = u[14]; /* m/s */
    const real slide3_udot = udot[14]; /* m/s^2 */
    const wreal rod3_mass = w[14]; /* kg */
    const wreal rod3_base_moment_z = w[21];
    const real rod3_a_x = tube3_a_x + hooke3_u_angle2 * slide3_u * 2.0 + slide3_q * tube3_U_xz;
    const real rod3_a_y = slide3_q * tube3_U_yz - (tube3_minus_a_y
        + slide3_u * tube3_omega_x * 2.0);
    const real rod3_a_z = slide3_udot - gravity_z * hooke3_R_zz - slide3_q * tube3_minus_U_zz;
    const real rod3_f_z = rod3_mass * rod3_a_z - rod3_base_moment_z * tube3_minus_U_zz;
    const real rod3_f_y = rod3_mass * rod3_a_y + rod3_base_moment_z * tube3_U_yz;
    const real rod3_n_y = rod3_base_moment_z * rod3_a_x;
    const real rod3_f_x = rod3_mass * rod3_a_x + rod3_base_moment_z * tube3_U_xz;

    /* slide3: tau */
    /* tau = S . [n; f] - force on the joint */
    const real drive3 = r[3];
    out[14] = rod3_f_z - drive3; /* tau: slide3.u.tau [N] */

    /* tube4: alpha, U, n */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* U = [alpha] + [omega][omega] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real hooke4_u_angle1dot = udot[15]; /* rad/s^2 */
    const real hooke4_u_angle2dot = udot[16]; /* rad/s^2 */
    const wreal tube4_base_second_moment_xx = w[32];
    const wreal tube4_base_second_moment_yy = w[33];
    const real tube4_alpha_x = hooke4_u_angle1dot * hooke4_angle2_cos
        - hooke4_angle2_sin * hooke4_u_angle1_times_u_angle2;
    const real tube4_alpha_z = hooke4_angle2_cos * hooke4_u_angle1_times_u_angle2
        + hooke4_u_angle1dot * hooke4_angle2_sin;
    const real tube4_U_xy = hooke4_u_angle2_times_tube4_omega_x - tube4_alpha_z;
    const real tube4_U_yx = tube4_alpha_z + hooke4_u_angle2_times_tube4_omega_x;
    const real tube4_n_z = tube4_base_second_moment_xx * tube4_U_yx
        - tube4_base_second_moment_yy * tube4_U_xy;
    const real tube4_U_xz = hooke4_u_angle2dot + tube4_omega_x_times_omega_z;
    const real tube4_U_zx = tube4_omega_x_times_omega_z - hooke4_u_angle2dot;
    const real tube4_U_yz = hooke4_u_angle2_times_tube4_omega_z - tube4_alpha_x;
    const real tube4_U_zy = tube4_alpha_x + hooke4_u_angle2_times_tube4_omega_z;

    /* rod4: a, f, n */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* f = inertia_force_f - applied_f + sum R f_child */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real slide4_q = q[18]; /* m */
    const real slide4_u = u[17]; /* m/s */
    const real slide4_udot = udot[17]; /* m/s^2 */
    const wreal rod4_mass = w[16]; /* kg */
    const wreal rod4_base_moment_z = w[22];
    const real rod4_a_x = tube4_a_x + hooke4_u_angle2 * slide4_u * 2.0 + slide4_q * tube4_U_xz;
    const real rod4_a_y = slide4_q * tube4_U_yz - (tube4_minus_a_y
        + slide4_u * tube4_omega_x * 2.0);
    const real rod4_a_z = slide4_udot - gravity_z * hooke4_R_zz - slide4_q * tube4_minus_U_zz;
    const real rod4_f_z = rod4_mass * rod4_a_z - rod4_base_moment_z * tube4_minus_U_zz;
    const real rod4_f_y = rod4_mass * rod4_a_y + rod4_base_moment_z * tube4_U_yz;
    const real rod4_n_y = rod4_base_moment_z * rod4_a_x;
    const real rod4_f_x = rod4_mass * rod4_a_x + rod4_base_moment_z * tube4_U_xz;

    /* slide4: tau */
    /* tau = S . [n; f] - force on the joint */
    const real drive4 = r[4];
    out[17] = rod4_f_z - drive4; /* tau: slide4.u.tau [N] */

    /* tube5: alpha, U, n */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* U = [alpha] + [omega][omega] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real hooke5_u_angle1dot = udot[18]; /* rad/s^2 */
    const real hooke5_u_angle2dot = udot[19]; /* rad/s^2 */
    const wreal tube5_base_second_moment_xx = w[29];
    const wreal tube5_base_second_moment_yy = w[30];
    const real tube5_alpha_x = hooke5_u_angle1dot * hooke5_angle2_cos
        - hooke5_angle2_sin * hooke5_u_angle1_times_u_angle2;
    const real tube5_alpha_z = hooke5_angle2_cos * hooke5_u_angle1_times_u_angle2
        + hooke5_u_angle1dot * hooke5_angle2_sin;
    const real tube5_U_xy = hooke5_u_angle2_times_tube5_omega_x - tube5_alpha_z;
    const real tube5_U_yx = tube5_alpha_z + hooke5_u_angle2_times_tube5_omega_x;
    const real tube5_n_z = tube5_base_second_moment_xx * tube5_U_yx
        - tube5_base_second_moment_yy * tube5_U_xy;
    const real tube5_U_xz = hooke5_u_angle2dot + tube5_omega_x_times_omega_z;
    const real tube5_U_zx = tube5_omega_x_times_omega_z - hooke5_u_angle2dot;
    const real tube5_U_yz = hooke5_u_angle2_times_tube5_omega_z - tube5_alpha_x;
    const real tube5_U_zy = tube5_alpha_x + hooke5_u_angle2_times_tube5_omega_z;

    /* rod5: a, f, n */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* f = inertia_force_f - applied_f + sum R f_child */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real slide5_q = q[21]; /* m */
    const real slide5_u = u[20]; /* m/s */
    const real slide5_udot = udot[20]; /* m/s^2 */
    const wreal rod5_mass = w[18]; /* kg */
    const wreal rod5_base_moment_z = w[23];
    const real rod5_a_x = tube5_a_x + hooke5_u_angle2 * slide5_u * 2.0 + slide5_q * tube5_U_xz;
    const real rod5_a_y = slide5_q * tube5_U_yz - (tube5_minus_a_y
        + slide5_u * tube5_omega_x * 2.0);
    const real rod5_a_z = slide5_udot - gravity_z * hooke5_R_zz - slide5_q * tube5_minus_U_zz;
    const real rod5_f_z = rod5_mass * rod5_a_z - rod5_base_moment_z * tube5_minus_U_zz;
    const real rod5_f_y = rod5_mass * rod5_a_y + rod5_base_moment_z * tube5_U_yz;
    const real rod5_n_y = rod5_base_moment_z * rod5_a_x;
    const real rod5_f_x = rod5_mass * rod5_a_x + rod5_base_moment_z * tube5_U_xz;

    /* slide5: tau */
    /* tau = S . [n; f] - force on the joint */
    const real drive5 = r[5];
    out[20] = rod5_f_z - drive5; /* tau: slide5.u.tau [N] */

    /* tube1: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal tube1_first_moment_z = w[9];
    const wreal tube1_base_second_moment_zz = w[43];
    const real tube1_n_x = tube1_base_second_moment_yy * tube1_U_zy
        + tube1_first_moment_z * tube1_minus_a_y - tube1_base_second_moment_zz * tube1_U_yz
        - rod1_base_moment_z * rod1_a_y - slide1_q * rod1_f_y;
    /* tau: hooke1.u.angle2.tau [N*m] */
    out[7] = tube1_base_second_moment_zz * tube1_U_xz + tube1_first_moment_z * tube1_a_x
        - tube1_base_second_moment_xx * tube1_U_zx + rod1_n_y + slide1_q * rod1_f_x;

    /* hooke1: tau */
    /* tau = S . [n; f] - force on the joint */
    /* tau: hooke1.u.angle1.tau [N*m] */
    out[6] = hooke1_angle2_cos * tube1_n_x + hooke1_angle2_sin * tube1_n_z;

    /* tube2: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal tube2_first_moment_z = w[11];
    const wreal tube2_base_second_moment_zz = w[40];
    const real tube2_n_x = tube2_base_second_moment_yy * tube2_U_zy
        + tube2_first_moment_z * tube2_minus_a_y - tube2_base_second_moment_zz * tube2_U_yz
        - rod2_base_moment_z * rod2_a_y - slide2_q * rod2_f_y;
    /* tau: hooke2.u.angle2.tau [N*m] */
    out[10] = tube2_base_second_moment_zz * tube2_U_xz + tube2_first_moment_z * tube2_a_x
        - tube2_base_second_moment_xx * tube2_U_zx + rod2_n_y + slide2_q * rod2_f_x;

    /* hooke2: tau */
    /* tau = S . [n; f] - force on the joint */
    /* tau: hooke2.u.angle1.tau [N*m] */
    out[9] = hooke2_angle2_cos * tube2_n_x + hooke2_angle2_sin * tube2_n_z;

    /* tube3: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal tube3_first_moment_z = w[13];
    const wreal tube3_base_second_moment_zz = w[37];
    const real tube3_n_x = tube3_base_second_moment_yy * tube3_U_zy
        + tube3_first_moment_z * tube3_minus_a_y - tube3_base_second_moment_zz * tube3_U_yz
        - rod3_base_moment_z * rod3_a_y - slide3_q * rod3_f_y;
    /* tau: hooke3.u.angle2.tau [N*m] */
    out[13] = tube3_base_second_moment_zz * tube3_U_xz + tube3_first_moment_z * tube3_a_x
        - tube3_base_second_moment_xx * tube3_U_zx + rod3_n_y + slide3_q * rod3_f_x;

    /* hooke3: tau */
    /* tau = S . [n; f] - force on the joint */
    /* tau: hooke3.u.angle1.tau [N*m] */
    out[12] = hooke3_angle2_cos * tube3_n_x + hooke3_angle2_sin * tube3_n_z;

    /* tube4: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal tube4_first_moment_z = w[15];
    const wreal tube4_base_second_moment_zz = w[34];
    const real tube4_n_x = tube4_base_second_moment_yy * tube4_U_zy
        + tube4_first_moment_z * tube4_minus_a_y - tube4_base_second_moment_zz * tube4_U_yz
        - rod4_base_moment_z * rod4_a_y - slide4_q * rod4_f_y;
    /* tau: hooke4.u.angle2.tau [N*m] */
    out[16] = tube4_base_second_moment_zz * tube4_U_xz + tube4_first_moment_z * tube4_a_x
        - tube4_base_second_moment_xx * tube4_U_zx + rod4_n_y + slide4_q * rod4_f_x;

    /* hooke4: tau */
    /* tau = S . [n; f] - force on the joint */
    /* tau: hooke4.u.angle1.tau [N*m] */
    out[15] = hooke4_angle2_cos * tube4_n_x + hooke4_angle2_sin * tube4_n_z;

    /* tube5: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal tube5_first_moment_z = w[17];
    const wreal tube5_base_second_moment_zz = w[31];
    const real tube5_n_x = tube5_base_second_moment_yy * tube5_U_zy
        + tube5_first_moment_z * tube5_minus_a_y - tube5_base_second_moment_zz * tube5_U_yz
        - rod5_base_moment_z * rod5_a_y - slide5_q * rod5_f_y;
    /* tau: hooke5.u.angle2.tau [N*m] */
    out[19] = tube5_base_second_moment_zz * tube5_U_xz + tube5_first_moment_z * tube5_a_x
        - tube5_base_second_moment_xx * tube5_U_zx + rod5_n_y + slide5_q * rod5_f_x;

    /* hooke5: tau */
    /* tau = S . [n; f] - force on the joint */
    /* tau: hooke5.u.angle1.tau [N*m] */
    out[18] = hooke5_angle2_cos * tube5_n_x + hooke5_angle2_sin * tube5_n_z;

    /* rod0: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real rod0_n_y = ball0_R_yy * platform_n_y + ball0_R_yz * platform_n_z
        + (rod0_base_moment_z * rod0_a_x + ball0_R_yx * platform_n_x
        + slide0_position_z * rod0_f_x_part);
    const real rod0_n_z = ball0_R_zx * platform_n_x + ball0_R_zy * platform_n_y
        + ball0_R_zz * platform_n_z;
    const real rod0_n_x = ball0_R_xy * platform_n_y + ball0_R_xz * platform_n_z
        + (ball0_R_xx * platform_n_x - rod0_base_moment_z * rod0_a_y
        - slide0_position_z * rod0_f_y_part);

    /* tube0: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal tube0_first_moment_z = w[1];
    const wreal tube0_base_second_moment_xx = w[44];
    const wreal tube0_base_second_moment_yy = w[45];
    const wreal tube0_base_second_moment_zz = w[46];
    const real tube0_n_z = tube0_base_second_moment_xx * tube0_U_yx
        - tube0_base_second_moment_yy * tube0_U_xy + rod0_n_z;
    const real tube0_n_x = tube0_base_second_moment_yy * tube0_U_zy
        + tube0_first_moment_z * tube0_minus_a_y - tube0_base_second_moment_zz * tube0_U_yz
        - slide0_q * rod0_f_y + rod0_n_x;
    /* tau: hooke0.u.angle2.tau [N*m] */
    out[1] = tube0_base_second_moment_zz * tube0_U_xz + tube0_first_moment_z * tube0_a_x
        - tube0_base_second_moment_xx * tube0_U_zx + slide0_q * rod0_f_x + rod0_n_y;

    /* hooke0: tau */
    /* tau = S . [n; f] - force on the joint */
    /* tau: hooke0.u.angle1.tau [N*m] */
    out[0] = hooke0_angle2_cos * tube0_n_x + hooke0_angle2_sin * tube0_n_z;

    /* slide0: tau */
    /* tau = S . [n; f] - force on the joint */
    const real drive0 = r[0];
    out[2] = rod0_f_z - drive0; /* tau: slide0.u.tau [N] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {21, 0, 47, 0, 22, 21, 0, 0, 6, 96, 0, 21, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
