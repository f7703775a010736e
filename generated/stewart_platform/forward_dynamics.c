/*
 * forward_dynamics of stewart_platform
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: origins, base_parameters
 * passes: unroll
 *
 * Sizes: out 21, work 867, w 107
 * Operations per call: 8086 = 4527 mul, 2359 add, 1147 sub, 15 neg, 13 div, 12 cos, 12 sin, 1 solve
 * Operations of prepare: 268 = 122 add, 86 mul, 52 sub, 8 div
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
 * Input tau (21): applied generalized forces
 *   tau[0]  hooke0.u.angle1.tau [N*m]
 *   tau[1]  hooke0.u.angle2.tau [N*m]
 *   tau[2]  slide0.u.tau [N]
 *   tau[3]  ball0.u.x.tau [N*m]
 *   tau[4]  ball0.u.y.tau [N*m]
 *   tau[5]  ball0.u.z.tau [N*m]
 *   tau[6]  hooke1.u.angle1.tau [N*m]
 *   tau[7]  hooke1.u.angle2.tau [N*m]
 *   tau[8]  slide1.u.tau [N]
 *   tau[9]  hooke2.u.angle1.tau [N*m]
 *   tau[10]  hooke2.u.angle2.tau [N*m]
 *   tau[11]  slide2.u.tau [N]
 *   tau[12]  hooke3.u.angle1.tau [N*m]
 *   tau[13]  hooke3.u.angle2.tau [N*m]
 *   tau[14]  slide3.u.tau [N]
 *   tau[15]  hooke4.u.angle1.tau [N*m]
 *   tau[16]  hooke4.u.angle2.tau [N*m]
 *   tau[17]  slide4.u.tau [N]
 *   tau[18]  hooke5.u.angle1.tau [N*m]
 *   tau[19]  hooke5.u.angle2.tau [N*m]
 *   tau[20]  slide5.u.tau [N]
 *
 * Output udot (21)
 *   out[0]  hooke0.u.angle1dot [rad/s^2]
 *   out[1]  hooke0.u.angle2dot [rad/s^2]
 *   out[2]  slide0.udot [m/s^2]
 *   out[3]  ball0.u.xdot [rad/s^2]
 *   out[4]  ball0.u.ydot [rad/s^2]
 *   out[5]  ball0.u.zdot [rad/s^2]
 *   out[6]  hooke1.u.angle1dot [rad/s^2]
 *   out[7]  hooke1.u.angle2dot [rad/s^2]
 *   out[8]  slide1.udot [m/s^2]
 *   out[9]  hooke2.u.angle1dot [rad/s^2]
 *   out[10]  hooke2.u.angle2dot [rad/s^2]
 *   out[11]  slide2.udot [m/s^2]
 *   out[12]  hooke3.u.angle1dot [rad/s^2]
 *   out[13]  hooke3.u.angle2dot [rad/s^2]
 *   out[14]  slide3.udot [m/s^2]
 *   out[15]  hooke4.u.angle1dot [rad/s^2]
 *   out[16]  hooke4.u.angle2dot [rad/s^2]
 *   out[17]  slide4.udot [m/s^2]
 *   out[18]  hooke5.u.angle1dot [rad/s^2]
 *   out[19]  hooke5.u.angle2dot [rad/s^2]
 *   out[20]  slide5.udot [m/s^2]
 */
#include "cardan.h"
#include "solve.h"
#include "dependent.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
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
    const wreal tube0_base_half_trace = 0.5 * (tube0_origin_inertia_xx + tube0_origin_inertia_yy
        + tube0_inertia_zz);
    w[3] = tube0_first_moment_z;
    w[73] = tube0_base_inertia_zz;

    /* rod0: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal slide0_position_z = p[8]; /* m */
    const wreal rod0_mass = p[9]; /* kg */
    const wreal rod0_com_z = p[10]; /* m */
    const wreal rod0_inertia_xx = p[11]; /* kg m^2 */
    const wreal rod0_inertia_yy = p[12]; /* kg m^2 */
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
    const wreal rod0_base_half_trace = 0.5 * (rod0_origin_inertia_xx_plus_mass_shift
        + rod0_origin_inertia_yy_plus_mass_shift + rod0_inertia_zz);
    w[69] = rod0_base_mass;

    /* momentum */
    /* momentum = composite inertia S */
    const wreal ball0_child_position_x = p[14]; /* m */
    const wreal ball0_child_position_y = p[15]; /* m */
    const wreal momentum_ball0_y_fz = ball0_child_position_x * platform_mass;
    const wreal momentum_ball0_z_fx = ball0_child_position_y * platform_mass;
    w[5] = momentum_ball0_y_fz;
    w[6] = momentum_ball0_z_fx;

    /* platform: first moment, mass, base, origin inertia */
    /* first_moment = sum m c */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
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
    const wreal platform_origin_inertia_xz = platform_com_z * momentum_ball0_y_fz;
    const wreal platform_origin_inertia_yz = platform_com_z * momentum_ball0_z_fx;
    const wreal platform_origin_inertia_xx = ball0_child_position_y_times_momentum_ball0_z_fx
        + platform_com_z_times_first_moment_z + platform_inertia_xx;
    const wreal platform_origin_inertia_yy = ball0_child_position_x_times_momentum_ball0_y_fz
        + platform_com_z_times_first_moment_z + platform_inertia_yy;
    const wreal platform_origin_inertia_zz = ball0_child_position_x_times_momentum_ball0_y_fz
        + ball0_child_position_y_times_momentum_ball0_z_fx + platform_inertia_zz;
    const wreal platform_base_mass_moment_z = slide0_position_z * platform_mass;
    const wreal platform_base_inertia_xx = slide0_position_z * platform_base_mass_moment_z;
    const wreal platform_base_half_trace = 0.5 * (platform_origin_inertia_xx
        + platform_origin_inertia_yy + platform_origin_inertia_zz);
    const wreal platform_base_second_moment_xx = platform_base_half_trace
        - platform_origin_inertia_xx;
    const wreal platform_base_second_moment_yy = platform_base_half_trace
        - platform_origin_inertia_yy;
    const wreal platform_base_second_moment_zz = platform_base_half_trace
        - platform_origin_inertia_zz;
    w[7] = platform_first_moment_z;
    w[8] = platform_base_second_moment_xy;
    w[9] = platform_origin_inertia_xz;
    w[10] = platform_origin_inertia_yz;
    w[11] = platform_origin_inertia_xx;
    w[12] = platform_origin_inertia_yy;
    w[13] = platform_origin_inertia_zz;
    w[74] = platform_base_second_moment_xx;
    w[75] = platform_base_second_moment_yy;
    w[76] = platform_base_second_moment_zz;

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
    const wreal tube1_base_half_trace = 0.5 * (tube1_origin_inertia_xx + tube1_origin_inertia_yy
        + tube1_inertia_zz);
    w[16] = tube1_first_moment_z;
    w[68] = tube1_base_inertia_zz;

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
    w[45] = rod1_base_moment_z;

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
    const wreal tube2_base_half_trace = 0.5 * (tube2_origin_inertia_xx + tube2_origin_inertia_yy
        + tube2_inertia_zz);
    w[20] = tube2_first_moment_z;
    w[65] = tube2_base_inertia_zz;

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
    w[47] = rod2_base_moment_z;

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
    const wreal tube3_base_half_trace = 0.5 * (tube3_origin_inertia_xx + tube3_origin_inertia_yy
        + tube3_inertia_zz);
    w[24] = tube3_first_moment_z;
    w[62] = tube3_base_inertia_zz;

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
    w[49] = rod3_base_moment_z;

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
    const wreal tube4_base_half_trace = 0.5 * (tube4_origin_inertia_xx + tube4_origin_inertia_yy
        + tube4_inertia_zz);
    w[28] = tube4_first_moment_z;
    w[59] = tube4_base_inertia_zz;

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
    w[51] = rod4_base_moment_z;

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
    const wreal tube5_base_half_trace = 0.5 * (tube5_origin_inertia_xx + tube5_origin_inertia_yy
        + tube5_inertia_zz);
    w[32] = tube5_first_moment_z;
    w[56] = tube5_base_inertia_zz;

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
    w[53] = rod5_base_moment_z;

    /* ball1: placement */
    const wreal ball1_child_position_x = p[86]; /* m */
    const wreal ball1_child_position_y = p[87]; /* m */
    const wreal ball1_child_position_x_minus_ball0_child_position_x = ball1_child_position_x
        - ball0_child_position_x;
    const wreal ball1_child_position_y_minus_ball0_child_position_y = ball1_child_position_y
        - ball0_child_position_y;
    w[34] = ball1_child_position_x_minus_ball0_child_position_x;
    w[35] = ball1_child_position_y_minus_ball0_child_position_y;

    /* ball2: placement */
    const wreal ball2_child_position_x = p[88]; /* m */
    const wreal ball2_child_position_y = p[89]; /* m */
    const wreal ball2_child_position_x_minus_ball0_child_position_x = ball2_child_position_x
        - ball0_child_position_x;
    const wreal ball2_child_position_y_minus_ball0_child_position_y = ball2_child_position_y
        - ball0_child_position_y;
    w[36] = ball2_child_position_x_minus_ball0_child_position_x;
    w[37] = ball2_child_position_y_minus_ball0_child_position_y;

    /* ball3: placement */
    const wreal ball3_child_position_x = p[90]; /* m */
    const wreal ball3_child_position_y = p[91]; /* m */
    const wreal ball3_child_position_x_minus_ball0_child_position_x = ball3_child_position_x
        - ball0_child_position_x;
    const wreal ball3_child_position_y_minus_ball0_child_position_y = ball3_child_position_y
        - ball0_child_position_y;
    w[38] = ball3_child_position_x_minus_ball0_child_position_x;
    w[39] = ball3_child_position_y_minus_ball0_child_position_y;

    /* ball4: placement */
    const wreal ball4_child_position_x = p[92]; /* m */
    const wreal ball4_child_position_y = p[93]; /* m */
    const wreal ball4_child_position_x_minus_ball0_child_position_x = ball4_child_position_x
        - ball0_child_position_x;
    const wreal ball4_child_position_y_minus_ball0_child_position_y = ball4_child_position_y
        - ball0_child_position_y;
    w[40] = ball4_child_position_x_minus_ball0_child_position_x;
    w[41] = ball4_child_position_y_minus_ball0_child_position_y;

    /* ball5: placement */
    const wreal ball5_child_position_x = p[94]; /* m */
    const wreal ball5_child_position_y = p[95]; /* m */
    const wreal ball5_child_position_x_minus_ball0_child_position_x = ball5_child_position_x
        - ball0_child_position_x;
    const wreal ball5_child_position_y_minus_ball0_child_position_y = ball5_child_position_y
        - ball0_child_position_y;
    w[42] = ball5_child_position_x_minus_ball0_child_position_x;
    w[43] = ball5_child_position_y_minus_ball0_child_position_y;

    /* shared by several: inertia */
    const wreal half_rod1_mass = 0.5 * rod1_mass;
    const wreal half_rod2_mass = 0.5 * rod2_mass;
    const wreal half_rod3_mass = 0.5 * rod3_mass;
    const wreal half_rod4_mass = 0.5 * rod4_mass;
    const wreal half_rod5_mass = 0.5 * rod5_mass;
    w[44] = half_rod1_mass;
    w[46] = half_rod2_mass;
    w[48] = half_rod3_mass;
    w[50] = half_rod4_mass;
    w[52] = half_rod5_mass;

    /* rod1: mass, base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal rod1_mass_shift = slide1_position_z * (rod1_first_moment_z
        + slide1_position_z * half_rod1_mass) * 2.0;
    const wreal rod1_base_inertia_xx = rod1_origin_inertia_xx + rod1_mass_shift;
    const wreal rod1_base_inertia_yy = rod1_origin_inertia_yy + rod1_mass_shift;
    const wreal rod1_base_half_trace = 0.5 * (rod1_base_inertia_xx + rod1_base_inertia_yy
        + rod1_inertia_zz);

    /* rod2: mass, base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal rod2_mass_shift = slide2_position_z * (rod2_first_moment_z
        + slide2_position_z * half_rod2_mass) * 2.0;
    const wreal rod2_base_inertia_xx = rod2_origin_inertia_xx + rod2_mass_shift;
    const wreal rod2_base_inertia_yy = rod2_origin_inertia_yy + rod2_mass_shift;
    const wreal rod2_base_half_trace = 0.5 * (rod2_base_inertia_xx + rod2_base_inertia_yy
        + rod2_inertia_zz);

    /* rod3: mass, base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal rod3_mass_shift = slide3_position_z * (rod3_first_moment_z
        + slide3_position_z * half_rod3_mass) * 2.0;
    const wreal rod3_base_inertia_xx = rod3_origin_inertia_xx + rod3_mass_shift;
    const wreal rod3_base_inertia_yy = rod3_origin_inertia_yy + rod3_mass_shift;
    const wreal rod3_base_half_trace = 0.5 * (rod3_base_inertia_xx + rod3_base_inertia_yy
        + rod3_inertia_zz);

    /* rod4: mass, base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal rod4_mass_shift = slide4_position_z * (rod4_first_moment_z
        + slide4_position_z * half_rod4_mass) * 2.0;
    const wreal rod4_base_inertia_xx = rod4_origin_inertia_xx + rod4_mass_shift;
    const wreal rod4_base_inertia_yy = rod4_origin_inertia_yy + rod4_mass_shift;
    const wreal rod4_base_half_trace = 0.5 * (rod4_base_inertia_xx + rod4_base_inertia_yy
        + rod4_inertia_zz);

    /* rod5: mass, base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal rod5_mass_shift = slide5_position_z * (rod5_first_moment_z
        + slide5_position_z * half_rod5_mass) * 2.0;
    const wreal rod5_base_inertia_xx = rod5_origin_inertia_xx + rod5_mass_shift;
    const wreal rod5_base_inertia_yy = rod5_origin_inertia_yy + rod5_mass_shift;
    const wreal rod5_base_half_trace = 0.5 * (rod5_base_inertia_xx + rod5_base_inertia_yy
        + rod5_inertia_zz);

    /* tube5: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube5_base_inertia_xx = tube5_origin_inertia_xx + rod5_base_inertia_xx;
    const wreal tube5_base_inertia_yy = tube5_origin_inertia_yy + rod5_base_inertia_yy;
    const wreal tube5_base_second_moment_xx = tube5_base_half_trace - tube5_origin_inertia_xx
        + (rod5_base_half_trace - rod5_base_inertia_xx);
    const wreal tube5_base_second_moment_yy = tube5_base_half_trace - tube5_origin_inertia_yy
        + (rod5_base_half_trace - rod5_base_inertia_yy);
    const wreal tube5_base_second_moment_zz = tube5_base_half_trace - tube5_inertia_zz
        + (rod5_base_half_trace - rod5_inertia_zz);
    w[54] = tube5_base_inertia_xx;
    w[55] = tube5_base_inertia_yy;
    w[77] = tube5_base_second_moment_xx;
    w[78] = tube5_base_second_moment_yy;
    w[79] = tube5_base_second_moment_zz;

    /* tube4: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube4_base_inertia_xx = tube4_origin_inertia_xx + rod4_base_inertia_xx;
    const wreal tube4_base_inertia_yy = tube4_origin_inertia_yy + rod4_base_inertia_yy;
    const wreal tube4_base_second_moment_xx = tube4_base_half_trace - tube4_origin_inertia_xx
        + (rod4_base_half_trace - rod4_base_inertia_xx);
    const wreal tube4_base_second_moment_yy = tube4_base_half_trace - tube4_origin_inertia_yy
        + (rod4_base_half_trace - rod4_base_inertia_yy);
    const wreal tube4_base_second_moment_zz = tube4_base_half_trace - tube4_inertia_zz
        + (rod4_base_half_trace - rod4_inertia_zz);
    w[57] = tube4_base_inertia_xx;
    w[58] = tube4_base_inertia_yy;
    w[80] = tube4_base_second_moment_xx;
    w[81] = tube4_base_second_moment_yy;
    w[82] = tube4_base_second_moment_zz;

    /* tube3: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube3_base_inertia_xx = tube3_origin_inertia_xx + rod3_base_inertia_xx;
    const wreal tube3_base_inertia_yy = tube3_origin_inertia_yy + rod3_base_inertia_yy;
    const wreal tube3_base_second_moment_xx = tube3_base_half_trace - tube3_origin_inertia_xx
        + (rod3_base_half_trace - rod3_base_inertia_xx);
    const wreal tube3_base_second_moment_yy = tube3_base_half_trace - tube3_origin_inertia_yy
        + (rod3_base_half_trace - rod3_base_inertia_yy);
    const wreal tube3_base_second_moment_zz = tube3_base_half_trace - tube3_inertia_zz
        + (rod3_base_half_trace - rod3_inertia_zz);
    w[60] = tube3_base_inertia_xx;
    w[61] = tube3_base_inertia_yy;
    w[83] = tube3_base_second_moment_xx;
    w[84] = tube3_base_second_moment_yy;
    w[85] = tube3_base_second_moment_zz;

    /* tube2: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube2_base_inertia_xx = tube2_origin_inertia_xx + rod2_base_inertia_xx;
    const wreal tube2_base_inertia_yy = tube2_origin_inertia_yy + rod2_base_inertia_yy;
    const wreal tube2_base_second_moment_xx = tube2_base_half_trace - tube2_origin_inertia_xx
        + (rod2_base_half_trace - rod2_base_inertia_xx);
    const wreal tube2_base_second_moment_yy = tube2_base_half_trace - tube2_origin_inertia_yy
        + (rod2_base_half_trace - rod2_base_inertia_yy);
    const wreal tube2_base_second_moment_zz = tube2_base_half_trace - tube2_inertia_zz
        + (rod2_base_half_trace - rod2_inertia_zz);
    w[63] = tube2_base_inertia_xx;
    w[64] = tube2_base_inertia_yy;
    w[86] = tube2_base_second_moment_xx;
    w[87] = tube2_base_second_moment_yy;
    w[88] = tube2_base_second_moment_zz;

    /* tube1: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube1_base_inertia_xx = tube1_origin_inertia_xx + rod1_base_inertia_xx;
    const wreal tube1_base_inertia_yy = tube1_origin_inertia_yy + rod1_base_inertia_yy;
    const wreal tube1_base_second_moment_xx = tube1_base_half_trace - tube1_origin_inertia_xx
        + (rod1_base_half_trace - rod1_base_inertia_xx);
    const wreal tube1_base_second_moment_yy = tube1_base_half_trace - tube1_origin_inertia_yy
        + (rod1_base_half_trace - rod1_base_inertia_yy);
    const wreal tube1_base_second_moment_zz = tube1_base_half_trace - tube1_inertia_zz
        + (rod1_base_half_trace - rod1_inertia_zz);
    w[66] = tube1_base_inertia_xx;
    w[67] = tube1_base_inertia_yy;
    w[89] = tube1_base_second_moment_xx;
    w[90] = tube1_base_second_moment_yy;
    w[91] = tube1_base_second_moment_zz;

    /* rod0: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal rod0_base_moment_z = rod0_first_moment_z + slide0_position_z * rod0_mass
        + platform_base_mass_moment_z;
    w[70] = rod0_base_moment_z;

    /* tube0: base, inertia */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal tube0_base_inertia_xx = rod0_origin_inertia_xx_plus_mass_shift
        + platform_base_inertia_xx + tube0_origin_inertia_xx;
    const wreal tube0_base_inertia_yy = rod0_origin_inertia_yy_plus_mass_shift
        + platform_base_inertia_xx + tube0_origin_inertia_yy;
    const wreal tube0_base_second_moment_xx = tube0_base_half_trace - tube0_origin_inertia_xx
        + (rod0_base_half_trace - rod0_origin_inertia_xx_plus_mass_shift);
    const wreal tube0_base_second_moment_yy = tube0_base_half_trace - tube0_origin_inertia_yy
        + (rod0_base_half_trace - rod0_origin_inertia_yy_plus_mass_shift);
    const wreal tube0_base_second_moment_zz = tube0_base_half_trace - tube0_inertia_zz
        + (rod0_base_half_trace - rod0_inertia_zz + platform_base_inertia_xx);
    const wreal half_rod0_base_mass = 0.5 * rod0_base_mass;
    w[71] = tube0_base_inertia_xx;
    w[72] = tube0_base_inertia_yy;
    w[92] = tube0_base_second_moment_xx;
    w[93] = tube0_base_second_moment_yy;
    w[94] = tube0_base_second_moment_zz;
    w[95] = half_rod0_base_mass;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal M_factor_D_inverse_slide5 = 1.0 / rod5_mass;
    const wreal M_factor_D_inverse_slide4 = 1.0 / rod4_mass;
    const wreal M_factor_D_inverse_slide3 = 1.0 / rod3_mass;
    const wreal M_factor_D_inverse_slide2 = 1.0 / rod2_mass;
    const wreal M_factor_D_inverse_slide1 = 1.0 / rod1_mass;
    const wreal M_factor_D_inverse_ball0_z = 1.0 / platform_origin_inertia_zz;
    const wreal M_factor_L_ball0_z_ball0_y = platform_origin_inertia_yz *
        M_factor_D_inverse_ball0_z;
    const wreal M_minus_factor_DL_ball0_y_ball0_x = platform_base_second_moment_xy
        + platform_origin_inertia_xz * M_factor_L_ball0_z_ball0_y;
    const wreal M_factor_L_ball0_z_ball0_x = platform_origin_inertia_xz *
        M_factor_D_inverse_ball0_z;
    const wreal M_factor_D_inverse_ball0_y = 1.0 / (platform_origin_inertia_yy
        - platform_origin_inertia_yz * M_factor_L_ball0_z_ball0_y);
    const wreal M_minus_factor_L_ball0_y_ball0_x = M_minus_factor_DL_ball0_y_ball0_x *
        M_factor_D_inverse_ball0_y;
    const wreal M_factor_D_inverse_ball0_x = 1.0 / (platform_origin_inertia_xx
        - platform_origin_inertia_xz * M_factor_L_ball0_z_ball0_x
        - M_minus_factor_DL_ball0_y_ball0_x * M_minus_factor_L_ball0_y_ball0_x);
    w[96] = M_factor_D_inverse_slide5;
    w[97] = M_factor_D_inverse_slide4;
    w[98] = M_factor_D_inverse_slide3;
    w[99] = M_factor_D_inverse_slide2;
    w[100] = M_factor_D_inverse_slide1;
    w[101] = M_factor_D_inverse_ball0_z;
    w[102] = M_factor_L_ball0_z_ball0_y;
    w[103] = M_factor_L_ball0_z_ball0_x;
    w[104] = M_factor_D_inverse_ball0_y;
    w[105] = M_minus_factor_L_ball0_y_ball0_x;
    w[106] = M_factor_D_inverse_ball0_x;

    /* parameters as they are */
    w[0] = p[0]; /* gravity.z [m/s^2] */
    w[1] = p[1]; /* hooke0.position.x [m] */
    w[2] = p[2]; /* hooke0.position.y [m] */
    w[4] = p[8]; /* slide0.position.z [m] */
    w[14] = p[21]; /* hooke1.position.x [m] */
    w[15] = p[22]; /* hooke1.position.y [m] */
    w[17] = p[29]; /* rod1.mass [kg] */
    w[18] = p[34]; /* hooke2.position.x [m] */
    w[19] = p[35]; /* hooke2.position.y [m] */
    w[21] = p[42]; /* rod2.mass [kg] */
    w[22] = p[47]; /* hooke3.position.x [m] */
    w[23] = p[48]; /* hooke3.position.y [m] */
    w[25] = p[55]; /* rod3.mass [kg] */
    w[26] = p[60]; /* hooke4.position.x [m] */
    w[27] = p[61]; /* hooke4.position.y [m] */
    w[29] = p[68]; /* rod4.mass [kg] */
    w[30] = p[73]; /* hooke5.position.x [m] */
    w[31] = p[74]; /* hooke5.position.y [m] */
    w[33] = p[81]; /* rod5.mass [kg] */
}

#include "lanes.h"

CARDAN_PART int forward_dynamics_part1(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    (void)out;

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
    work[390] = hooke0_angle1_cos;
    const real hooke0_angle1_sin = sine[0];
    work[391] = hooke0_angle1_sin;
    const real hooke0_angle2_cos = cosine[1];
    work[392] = hooke0_angle2_cos;
    const real hooke0_angle2_sin = sine[1];
    work[393] = hooke0_angle2_sin;
    const real hooke1_angle1_cos = cosine[2];
    work[394] = hooke1_angle1_cos;
    const real hooke1_angle1_sin = sine[2];
    work[395] = hooke1_angle1_sin;
    const real hooke1_angle2_cos = cosine[3];
    work[396] = hooke1_angle2_cos;
    const real hooke1_angle2_sin = sine[3];
    work[397] = hooke1_angle2_sin;
    const real hooke2_angle1_cos = cosine[4];
    work[398] = hooke2_angle1_cos;
    const real hooke2_angle1_sin = sine[4];
    work[399] = hooke2_angle1_sin;
    const real hooke2_angle2_cos = cosine[5];
    work[400] = hooke2_angle2_cos;
    const real hooke2_angle2_sin = sine[5];
    work[401] = hooke2_angle2_sin;
    const real hooke3_angle1_cos = cosine[6];
    work[402] = hooke3_angle1_cos;
    const real hooke3_angle1_sin = sine[6];
    work[403] = hooke3_angle1_sin;
    const real hooke3_angle2_cos = cosine[7];
    work[404] = hooke3_angle2_cos;
    const real hooke3_angle2_sin = sine[7];
    work[405] = hooke3_angle2_sin;
    const real hooke4_angle1_cos = cosine[8];
    work[406] = hooke4_angle1_cos;
    const real hooke4_angle1_sin = sine[8];
    work[407] = hooke4_angle1_sin;
    const real hooke4_angle2_cos = cosine[9];
    work[408] = hooke4_angle2_cos;
    const real hooke4_angle2_sin = sine[9];
    work[409] = hooke4_angle2_sin;
    const real hooke5_angle1_cos = cosine[10];
    work[410] = hooke5_angle1_cos;
    const real hooke5_angle1_sin = sine[10];
    work[411] = hooke5_angle1_sin;
    const real hooke5_angle2_cos = cosine[11];
    work[412] = hooke5_angle2_cos;
    const real hooke5_angle2_sin = sine[11];
    work[413] = hooke5_angle2_sin;

    /* hooke0: R, drift, velocity */
    /* R = R_fixed R_joint(q) */
    /* drift = S' u + [0; omega x v] */
    /* velocity = S u */
    const real hooke0_u_angle1 = u[0]; /* rad/s */
    const real hooke0_u_angle2 = u[1]; /* rad/s */
    const real hooke0_R_yx = hooke0_angle1_sin * hooke0_angle2_sin;
    const real hooke0_minus_R_yz = hooke0_angle1_sin * hooke0_angle2_cos;
    const real hooke0_minus_R_zx = hooke0_angle1_cos * hooke0_angle2_sin;
    const real hooke0_R_zz = hooke0_angle1_cos * hooke0_angle2_cos;
    work[414] = hooke0_R_zz;
    const real hooke0_u_angle1_times_u_angle2 = hooke0_u_angle1 * hooke0_u_angle2;
    const real hooke0_minus_drift_relative_wx = hooke0_angle2_sin * hooke0_u_angle1_times_u_angle2;
    work[415] = hooke0_minus_drift_relative_wx;
    const real hooke0_u_angle1_times_angle1_sin = hooke0_u_angle1 * hooke0_angle1_sin;
    const real hooke0_u_angle1_times_angle1_cos = hooke0_u_angle1 * hooke0_angle1_cos;
    const real hooke0_u_angle2_times_angle2_sin = hooke0_u_angle2 * hooke0_angle2_sin;
    const real hooke0_u_angle2_times_angle2_cos = hooke0_u_angle2 * hooke0_angle2_cos;
    const real hooke0_R_yx_rate = hooke0_angle2_sin * hooke0_u_angle1_times_angle1_cos
        + hooke0_angle1_sin * hooke0_u_angle2_times_angle2_cos;
    const real hooke0_minus_R_yz_rate = hooke0_angle2_cos * hooke0_u_angle1_times_angle1_cos
        - hooke0_angle1_sin * hooke0_u_angle2_times_angle2_sin;
    const real hooke0_minus_R_zx_rate = hooke0_angle1_cos * hooke0_u_angle2_times_angle2_cos
        - hooke0_angle2_sin * hooke0_u_angle1_times_angle1_sin;
    const real hooke0_minus_R_zz_rate = hooke0_angle2_cos * hooke0_u_angle1_times_angle1_sin
        + hooke0_angle1_cos * hooke0_u_angle2_times_angle2_sin;
    const real tube0_minus_omega_x_rate = hooke0_u_angle1 * hooke0_u_angle2_times_angle2_sin;
    const real tube0_omega_z_rate = hooke0_u_angle1 * hooke0_u_angle2_times_angle2_cos;

    /* ball0: R, qdot */
    /* R = R_fixed R_joint(q) */
    const real ball0_qw = q[3];
    const real ball0_qx = q[4];
    const real ball0_qy = q[5];
    const real ball0_qz = q[6];
    const real ball0_u_x = u[3]; /* rad/s */
    const real ball0_u_y = u[4]; /* rad/s */
    const real ball0_u_z = u[5]; /* rad/s */
    const real twice_ball0_qx = 2.0 * ball0_qx;
    const real twice_ball0_qy = 2.0 * ball0_qy;
    const real twice_ball0_qz = 2.0 * ball0_qz;
    const real ball0_qw_times_twice_ball0_qx = ball0_qw * twice_ball0_qx;
    const real ball0_qw_times_twice_ball0_qy = ball0_qw * twice_ball0_qy;
    const real ball0_qw_times_twice_ball0_qz = ball0_qw * twice_ball0_qz;
    const real ball0_qx_times_twice_ball0_qx = ball0_qx * twice_ball0_qx;
    const real ball0_qx_times_twice_ball0_qy = ball0_qx * twice_ball0_qy;
    const real ball0_qx_times_twice_ball0_qz = ball0_qx * twice_ball0_qz;
    const real ball0_qy_times_twice_ball0_qy = ball0_qy * twice_ball0_qy;
    const real ball0_qy_times_twice_ball0_qz = ball0_qy * twice_ball0_qz;
    const real ball0_qz_times_twice_ball0_qz = ball0_qz * twice_ball0_qz;
    const real ball0_R_xx = 1.0 - (ball0_qy_times_twice_ball0_qy + ball0_qz_times_twice_ball0_qz);
    work[416] = ball0_R_xx;
    const real ball0_R_xy = ball0_qx_times_twice_ball0_qy - ball0_qw_times_twice_ball0_qz;
    work[417] = ball0_R_xy;
    const real ball0_R_xz = ball0_qw_times_twice_ball0_qy + ball0_qx_times_twice_ball0_qz;
    work[418] = ball0_R_xz;
    const real ball0_R_yx = ball0_qw_times_twice_ball0_qz + ball0_qx_times_twice_ball0_qy;
    work[419] = ball0_R_yx;
    const real ball0_R_yy = 1.0 - (ball0_qx_times_twice_ball0_qx + ball0_qz_times_twice_ball0_qz);
    work[420] = ball0_R_yy;
    const real ball0_R_yz = ball0_qy_times_twice_ball0_qz - ball0_qw_times_twice_ball0_qx;
    work[421] = ball0_R_yz;
    const real ball0_R_zx = ball0_qx_times_twice_ball0_qz - ball0_qw_times_twice_ball0_qy;
    work[422] = ball0_R_zx;
    const real ball0_R_zy = ball0_qw_times_twice_ball0_qx + ball0_qy_times_twice_ball0_qz;
    work[423] = ball0_R_zy;
    const real ball0_R_zz = 1.0 - (ball0_qx_times_twice_ball0_qx + ball0_qy_times_twice_ball0_qy);
    work[424] = ball0_R_zz;
    const real half_ball0_u_x = 0.5 * ball0_u_x;
    const real half_ball0_u_y = 0.5 * ball0_u_y;
    const real half_ball0_u_z = 0.5 * ball0_u_z;
    const real ball0_minus_qdot_qw = ball0_qx * half_ball0_u_x + ball0_qy * half_ball0_u_y
        + ball0_qz * half_ball0_u_z;
    const real ball0_qdot_qx = ball0_qw * half_ball0_u_x - ball0_qz * half_ball0_u_y
        + ball0_qy * half_ball0_u_z;
    const real ball0_qdot_qy = ball0_qz * half_ball0_u_x + ball0_qw * half_ball0_u_y
        - ball0_qx * half_ball0_u_z;
    const real ball0_qdot_qz = ball0_qw * half_ball0_u_z - ball0_qy * half_ball0_u_x
        + ball0_qx * half_ball0_u_y;
    const real twice_ball0_qdot_qx = 2.0 * ball0_qdot_qx;
    const real twice_ball0_qdot_qy = 2.0 * ball0_qdot_qy;
    const real twice_ball0_qdot_qz = 2.0 * ball0_qdot_qz;
    const real ball0_R_yz_rate_part = ball0_qw * twice_ball0_qdot_qx
        - twice_ball0_qx * ball0_minus_qdot_qw;
    const real ball0_R_xz_rate_part = ball0_qw * twice_ball0_qdot_qy
        - twice_ball0_qy * ball0_minus_qdot_qw;
    const real ball0_R_xy_rate_part = ball0_qw * twice_ball0_qdot_qz
        - twice_ball0_qz * ball0_minus_qdot_qw;
    const real ball0_minus_R_yy_rate_part = twice_ball0_qx * ball0_qdot_qx
        + ball0_qx * twice_ball0_qdot_qx;
    const real ball0_R_xy_rate_part_2 = twice_ball0_qy * ball0_qdot_qx
        + ball0_qx * twice_ball0_qdot_qy;
    const real ball0_R_xz_rate_part_2 = twice_ball0_qz * ball0_qdot_qx
        + ball0_qx * twice_ball0_qdot_qz;
    const real ball0_minus_R_xx_rate_part = twice_ball0_qy * ball0_qdot_qy
        + ball0_qy * twice_ball0_qdot_qy;
    const real ball0_R_yz_rate_part_2 = twice_ball0_qz * ball0_qdot_qy
        + ball0_qy * twice_ball0_qdot_qz;
    const real ball0_minus_R_xx_rate_part_2 = twice_ball0_qz * ball0_qdot_qz
        + ball0_qz * twice_ball0_qdot_qz;
    const real ball0_minus_R_xx_rate = ball0_minus_R_xx_rate_part + ball0_minus_R_xx_rate_part_2;
    const real ball0_R_xy_rate = ball0_R_xy_rate_part_2 - ball0_R_xy_rate_part;
    const real ball0_R_xz_rate = ball0_R_xz_rate_part + ball0_R_xz_rate_part_2;
    const real ball0_R_yx_rate = ball0_R_xy_rate_part + ball0_R_xy_rate_part_2;
    const real ball0_minus_R_yy_rate = ball0_minus_R_yy_rate_part + ball0_minus_R_xx_rate_part_2;
    const real ball0_R_yz_rate = ball0_R_yz_rate_part_2 - ball0_R_yz_rate_part;
    const real ball0_R_zx_rate = ball0_R_xz_rate_part_2 - ball0_R_xz_rate_part;
    const real ball0_R_zy_rate = ball0_R_yz_rate_part + ball0_R_yz_rate_part_2;
    const real ball0_minus_R_zz_rate = ball0_minus_R_yy_rate_part + ball0_minus_R_xx_rate_part;

    /* shared by several: pose, twist, inertia */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    const real slide0_q = q[2]; /* m */
    const real slide0_u = u[2]; /* m/s */
    const wreal hooke0_position_x = w[1]; /* m */
    const wreal hooke0_position_y = w[2]; /* m */
    const wreal slide0_position_z = w[4]; /* m */
    const wreal platform_base_second_moment_xy = w[8];
    const wreal platform_origin_inertia_xz = w[9];
    const wreal platform_origin_inertia_yz = w[10];
    const wreal platform_origin_inertia_xx = w[11];
    const wreal platform_origin_inertia_yy = w[12];
    const wreal platform_origin_inertia_zz = w[13];
    const real ball1_platform_R_xx = hooke0_angle2_cos * ball0_R_xx
        + hooke0_angle2_sin * ball0_R_zx;
    work[425] = ball1_platform_R_xx;
    const real ball1_platform_R_xy = hooke0_angle2_cos * ball0_R_xy
        + hooke0_angle2_sin * ball0_R_zy;
    work[426] = ball1_platform_R_xy;
    const real ball1_platform_R_xz = hooke0_angle2_cos * ball0_R_xz
        + hooke0_angle2_sin * ball0_R_zz;
    work[427] = ball1_platform_R_xz;
    const real ball1_platform_R_yx = hooke0_R_yx * ball0_R_xx + hooke0_angle1_cos * ball0_R_yx
        - hooke0_minus_R_yz * ball0_R_zx;
    work[428] = ball1_platform_R_yx;
    const real ball1_platform_R_yy = hooke0_R_yx * ball0_R_xy + hooke0_angle1_cos * ball0_R_yy
        - hooke0_minus_R_yz * ball0_R_zy;
    work[429] = ball1_platform_R_yy;
    const real ball1_platform_R_yz = hooke0_R_yx * ball0_R_xz + hooke0_angle1_cos * ball0_R_yz
        - hooke0_minus_R_yz * ball0_R_zz;
    work[430] = ball1_platform_R_yz;
    const real ball1_platform_R_zx = hooke0_angle1_sin * ball0_R_yx
        - hooke0_minus_R_zx * ball0_R_xx + hooke0_R_zz * ball0_R_zx;
    work[431] = ball1_platform_R_zx;
    const real ball1_platform_R_zy = hooke0_angle1_sin * ball0_R_yy
        - hooke0_minus_R_zx * ball0_R_xy + hooke0_R_zz * ball0_R_zy;
    work[432] = ball1_platform_R_zy;
    const real ball1_platform_R_zz = hooke0_angle1_sin * ball0_R_yz
        - hooke0_minus_R_zx * ball0_R_xz + hooke0_R_zz * ball0_R_zz;
    work[433] = ball1_platform_R_zz;
    const real ball1_platform_p_x = hooke0_position_x + slide0_q * hooke0_angle2_sin
        + slide0_position_z * hooke0_angle2_sin;
    work[434] = ball1_platform_p_x;
    const real ball1_platform_p_y = hooke0_position_y - slide0_q * hooke0_minus_R_yz
        - slide0_position_z * hooke0_minus_R_yz;
    work[435] = ball1_platform_p_y;
    const real ball1_platform_p_z = slide0_q * hooke0_R_zz + slide0_position_z * hooke0_R_zz;
    work[436] = ball1_platform_p_z;
    const real ball1_base_twist_hooke0_angle1_wx = hooke0_angle2_cos * hooke0_angle2_cos
        + hooke0_angle2_sin * hooke0_angle2_sin;
    work[437] = ball1_base_twist_hooke0_angle1_wx;
    const real ball1_base_twist_hooke0_angle1_wy = hooke0_angle2_cos * hooke0_R_yx
        - hooke0_angle2_sin * hooke0_minus_R_yz;
    work[438] = ball1_base_twist_hooke0_angle1_wy;
    const real ball1_base_twist_hooke0_angle1_wz = hooke0_angle2_sin * hooke0_R_zz
        - hooke0_angle2_cos * hooke0_minus_R_zx;
    work[439] = ball1_base_twist_hooke0_angle1_wz;
    const real ball1_base_twist_by_slide0_vx = slide0_u * hooke0_angle2_sin;
    work[440] = ball1_base_twist_by_slide0_vx;
    const real ball1_minus_base_twist_by_slide0_vy = slide0_u * hooke0_minus_R_yz;
    work[441] = ball1_minus_base_twist_by_slide0_vy;
    const real ball1_base_twist_by_slide0_vz = slide0_u * hooke0_R_zz;
    work[442] = ball1_base_twist_by_slide0_vz;
    const real ball1_base_twist_by_ball0_wx = ball0_u_x * ball1_platform_R_xx
        + ball0_u_y * ball1_platform_R_xy + ball0_u_z * ball1_platform_R_xz;
    work[443] = ball1_base_twist_by_ball0_wx;
    const real ball1_base_twist_by_ball0_wy = ball0_u_x * ball1_platform_R_yx
        + ball0_u_y * ball1_platform_R_yy + ball0_u_z * ball1_platform_R_yz;
    work[444] = ball1_base_twist_by_ball0_wy;
    const real ball1_base_twist_by_ball0_wz = ball0_u_x * ball1_platform_R_zx
        + ball0_u_y * ball1_platform_R_zy + ball0_u_z * ball1_platform_R_zz;
    work[445] = ball1_base_twist_by_ball0_wz;
    const real ball1_twist_slide0_vx = hooke0_angle2_sin * ball1_platform_R_xx
        - hooke0_minus_R_yz * ball1_platform_R_yx + hooke0_R_zz * ball1_platform_R_zx;
    work[446] = ball1_twist_slide0_vx;
    const real ball1_twist_slide0_vy = hooke0_angle2_sin * ball1_platform_R_xy
        - hooke0_minus_R_yz * ball1_platform_R_yy + hooke0_R_zz * ball1_platform_R_zy;
    work[447] = ball1_twist_slide0_vy;
    const real ball1_twist_slide0_vz = hooke0_angle2_sin * ball1_platform_R_xz
        - hooke0_minus_R_yz * ball1_platform_R_yz + hooke0_R_zz * ball1_platform_R_zz;
    work[448] = ball1_twist_slide0_vz;
    const real rod0_inertia_half_turned_xx = platform_origin_inertia_xx * ball0_R_xx
        - platform_base_second_moment_xy * ball0_R_xy + platform_origin_inertia_xz * ball0_R_xz;
    work[449] = rod0_inertia_half_turned_xx;
    const real rod0_inertia_half_turned_xy = platform_origin_inertia_yy * ball0_R_xy
        - platform_base_second_moment_xy * ball0_R_xx + platform_origin_inertia_yz * ball0_R_xz;
    work[450] = rod0_inertia_half_turned_xy;
    const real rod0_inertia_half_turned_xz = platform_origin_inertia_xz * ball0_R_xx
        + platform_origin_inertia_yz * ball0_R_xy + platform_origin_inertia_zz * ball0_R_xz;
    work[451] = rod0_inertia_half_turned_xz;
    const real rod0_inertia_half_turned_yx = platform_origin_inertia_xx * ball0_R_yx
        - platform_base_second_moment_xy * ball0_R_yy + platform_origin_inertia_xz * ball0_R_yz;
    work[452] = rod0_inertia_half_turned_yx;
    const real rod0_inertia_half_turned_yy = platform_origin_inertia_yy * ball0_R_yy
        - platform_base_second_moment_xy * ball0_R_yx + platform_origin_inertia_yz * ball0_R_yz;
    work[453] = rod0_inertia_half_turned_yy;
    const real rod0_inertia_half_turned_yz = platform_origin_inertia_xz * ball0_R_yx
        + platform_origin_inertia_yz * ball0_R_yy + platform_origin_inertia_zz * ball0_R_yz;
    work[454] = rod0_inertia_half_turned_yz;
    const real rod0_inertia_half_turned_zx = platform_origin_inertia_xx * ball0_R_zx
        - platform_base_second_moment_xy * ball0_R_zy + platform_origin_inertia_xz * ball0_R_zz;
    work[455] = rod0_inertia_half_turned_zx;
    const real rod0_inertia_half_turned_zy = platform_origin_inertia_yy * ball0_R_zy
        - platform_base_second_moment_xy * ball0_R_zx + platform_origin_inertia_yz * ball0_R_zz;
    work[456] = rod0_inertia_half_turned_zy;
    const real rod0_inertia_half_turned_zz = platform_origin_inertia_xz * ball0_R_zx
        + platform_origin_inertia_yz * ball0_R_zy + platform_origin_inertia_zz * ball0_R_zz;
    work[457] = rod0_inertia_half_turned_zz;

    /* hooke1: R, drift, velocity */
    /* R = R_fixed R_joint(q) */
    /* drift = S' u + [0; omega x v] */
    /* velocity = S u */
    const real hooke1_u_angle1 = u[6]; /* rad/s */
    const real hooke1_u_angle2 = u[7]; /* rad/s */
    const real hooke1_R_yx = hooke1_angle1_sin * hooke1_angle2_sin;
    const real hooke1_minus_R_yz = hooke1_angle1_sin * hooke1_angle2_cos;
    const real hooke1_minus_R_zx = hooke1_angle1_cos * hooke1_angle2_sin;
    work[458] = hooke1_minus_R_zx;
    const real hooke1_R_zz = hooke1_angle1_cos * hooke1_angle2_cos;
    work[459] = hooke1_R_zz;
    const real hooke1_u_angle1_times_u_angle2 = hooke1_u_angle1 * hooke1_u_angle2;
    const real hooke1_minus_drift_relative_wx = hooke1_angle2_sin * hooke1_u_angle1_times_u_angle2;
    work[460] = hooke1_minus_drift_relative_wx;
    const real hooke1_u_angle1_times_angle1_sin = hooke1_u_angle1 * hooke1_angle1_sin;
    work[461] = hooke1_u_angle1_times_angle1_sin;
    const real hooke1_u_angle1_times_angle1_cos = hooke1_u_angle1 * hooke1_angle1_cos;
    work[462] = hooke1_u_angle1_times_angle1_cos;
    const real hooke1_u_angle2_times_angle2_sin = hooke1_u_angle2 * hooke1_angle2_sin;
    const real hooke1_u_angle2_times_angle2_cos = hooke1_u_angle2 * hooke1_angle2_cos;
    const real hooke1_R_yx_rate = hooke1_angle2_sin * hooke1_u_angle1_times_angle1_cos
        + hooke1_angle1_sin * hooke1_u_angle2_times_angle2_cos;
    const real hooke1_minus_R_yz_rate = hooke1_angle2_cos * hooke1_u_angle1_times_angle1_cos
        - hooke1_angle1_sin * hooke1_u_angle2_times_angle2_sin;
    const real hooke1_minus_R_zx_rate = hooke1_angle1_cos * hooke1_u_angle2_times_angle2_cos
        - hooke1_angle2_sin * hooke1_u_angle1_times_angle1_sin;
    work[463] = hooke1_minus_R_zx_rate;
    const real hooke1_minus_R_zz_rate = hooke1_angle2_cos * hooke1_u_angle1_times_angle1_sin
        + hooke1_angle1_cos * hooke1_u_angle2_times_angle2_sin;
    work[464] = hooke1_minus_R_zz_rate;
    const real tube1_minus_omega_x_rate = hooke1_u_angle1 * hooke1_u_angle2_times_angle2_sin;
    const real tube1_omega_z_rate = hooke1_u_angle1 * hooke1_u_angle2_times_angle2_cos;

    /* ball1: pose, twist, G */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* G = d(rate) / du */
    const wreal hooke1_position_x = w[14]; /* m */
    const wreal hooke1_position_y = w[15]; /* m */
    const wreal ball1_child_position_x_minus_ball0_child_position_x = w[34];
    const wreal ball1_child_position_y_minus_ball0_child_position_y = w[35];
    const real ball1_child_p_x = ball1_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_xx
        + ball1_child_position_y_minus_ball0_child_position_y * ball1_platform_R_xy
        + ball1_platform_p_x;
    const real ball1_child_p_y = ball1_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_yx
        + ball1_child_position_y_minus_ball0_child_position_y * ball1_platform_R_yy
        + ball1_platform_p_y;
    const real ball1_child_p_z = ball1_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_zx
        + ball1_child_position_y_minus_ball0_child_position_y * ball1_platform_R_zy
        + ball1_platform_p_z;
    const real ball1_R_xx = ball1_platform_R_xx * hooke1_angle2_cos
        + ball1_platform_R_yx * hooke1_R_yx - ball1_platform_R_zx * hooke1_minus_R_zx;
    work[465] = ball1_R_xx;
    const real ball1_R_xy = ball1_platform_R_xy * hooke1_angle2_cos
        + ball1_platform_R_yy * hooke1_R_yx - ball1_platform_R_zy * hooke1_minus_R_zx;
    work[466] = ball1_R_xy;
    const real ball1_R_xz = ball1_platform_R_xz * hooke1_angle2_cos
        + ball1_platform_R_yz * hooke1_R_yx - ball1_platform_R_zz * hooke1_minus_R_zx;
    work[467] = ball1_R_xz;
    const real ball1_R_yx = ball1_platform_R_yx * hooke1_angle1_cos
        + ball1_platform_R_zx * hooke1_angle1_sin;
    work[468] = ball1_R_yx;
    const real ball1_R_yy = ball1_platform_R_yy * hooke1_angle1_cos
        + ball1_platform_R_zy * hooke1_angle1_sin;
    work[469] = ball1_R_yy;
    const real ball1_R_yz = ball1_platform_R_yz * hooke1_angle1_cos
        + ball1_platform_R_zz * hooke1_angle1_sin;
    work[470] = ball1_R_yz;
    const real ball1_R_zx = ball1_platform_R_xx * hooke1_angle2_sin
        - ball1_platform_R_yx * hooke1_minus_R_yz + ball1_platform_R_zx * hooke1_R_zz;
    work[471] = ball1_R_zx;
    const real ball1_R_zy = ball1_platform_R_xy * hooke1_angle2_sin
        - ball1_platform_R_yy * hooke1_minus_R_yz + ball1_platform_R_zy * hooke1_R_zz;
    work[472] = ball1_R_zy;
    const real ball1_R_zz = ball1_platform_R_xz * hooke1_angle2_sin
        - ball1_platform_R_yz * hooke1_minus_R_yz + ball1_platform_R_zz * hooke1_R_zz;
    work[473] = ball1_R_zz;
    const real ball1_arm_hooke0_x = ball1_child_p_x - hooke0_position_x;
    const real ball1_arm_hooke0_y = ball1_child_p_y - hooke0_position_y;
    const real ball1_base_twist_hooke0_angle1_vx = ball1_child_p_z *
        ball1_base_twist_hooke0_angle1_wy - ball1_arm_hooke0_y * ball1_base_twist_hooke0_angle1_wz;
    const real ball1_base_twist_hooke0_angle1_vy = ball1_arm_hooke0_x *
        ball1_base_twist_hooke0_angle1_wz - ball1_child_p_z * ball1_base_twist_hooke0_angle1_wx;
    const real ball1_base_twist_hooke0_angle1_vz = ball1_arm_hooke0_y *
        ball1_base_twist_hooke0_angle1_wx - ball1_arm_hooke0_x * ball1_base_twist_hooke0_angle1_wy;
    const real ball1_base_twist_hooke0_angle2_vx = hooke0_angle1_cos * ball1_child_p_z
        - hooke0_angle1_sin * ball1_arm_hooke0_y;
    const real ball1_base_twist_hooke0_angle2_vy = hooke0_angle1_sin * ball1_arm_hooke0_x;
    const real ball1_minus_base_twist_hooke0_angle2_vz = hooke0_angle1_cos * ball1_arm_hooke0_x;
    const real ball1_arm_ball0_x = ball1_child_p_x - ball1_platform_p_x;
    const real ball1_arm_ball0_y = ball1_child_p_y - ball1_platform_p_y;
    const real ball1_arm_ball0_z = ball1_child_p_z - ball1_platform_p_z;
    const real ball1_base_twist_ball0_x_vx = ball1_platform_R_yx * ball1_arm_ball0_z
        - ball1_platform_R_zx * ball1_arm_ball0_y;
    const real ball1_base_twist_ball0_x_vy = ball1_platform_R_zx * ball1_arm_ball0_x
        - ball1_platform_R_xx * ball1_arm_ball0_z;
    const real ball1_base_twist_ball0_x_vz = ball1_platform_R_xx * ball1_arm_ball0_y
        - ball1_platform_R_yx * ball1_arm_ball0_x;
    const real ball1_base_twist_ball0_y_vx = ball1_platform_R_yy * ball1_arm_ball0_z
        - ball1_platform_R_zy * ball1_arm_ball0_y;
    const real ball1_base_twist_ball0_y_vy = ball1_platform_R_zy * ball1_arm_ball0_x
        - ball1_platform_R_xy * ball1_arm_ball0_z;
    const real ball1_base_twist_ball0_y_vz = ball1_platform_R_xy * ball1_arm_ball0_y
        - ball1_platform_R_yy * ball1_arm_ball0_x;
    const real ball1_base_twist_ball0_z_vx = ball1_platform_R_yz * ball1_arm_ball0_z
        - ball1_platform_R_zz * ball1_arm_ball0_y;
    const real ball1_base_twist_ball0_z_vy = ball1_platform_R_zz * ball1_arm_ball0_x
        - ball1_platform_R_xz * ball1_arm_ball0_z;
    const real ball1_base_twist_ball0_z_vz = ball1_platform_R_xz * ball1_arm_ball0_y
        - ball1_platform_R_yz * ball1_arm_ball0_x;
    const real ball1_arm_hooke1_x = ball1_child_p_x - hooke1_position_x;
    const real ball1_arm_hooke1_y = ball1_child_p_y - hooke1_position_y;
    const real ball1_minus_base_twist_hooke1_angle1_wx = hooke1_angle2_cos * hooke1_angle2_cos
        + hooke1_angle2_sin * hooke1_angle2_sin;
    const real ball1_minus_base_twist_hooke1_angle1_wy = hooke1_angle2_cos * hooke1_R_yx
        - hooke1_angle2_sin * hooke1_minus_R_yz;
    const real ball1_minus_base_twist_hooke1_angle1_wz = hooke1_angle2_sin * hooke1_R_zz
        - hooke1_angle2_cos * hooke1_minus_R_zx;
    const real ball1_minus_base_twist_hooke1_angle1_vx = ball1_child_p_z *
        ball1_minus_base_twist_hooke1_angle1_wy
        - ball1_arm_hooke1_y * ball1_minus_base_twist_hooke1_angle1_wz;
    const real ball1_minus_base_twist_hooke1_angle1_vy = ball1_arm_hooke1_x *
        ball1_minus_base_twist_hooke1_angle1_wz
        - ball1_child_p_z * ball1_minus_base_twist_hooke1_angle1_wx;
    const real ball1_minus_base_twist_hooke1_angle1_vz = ball1_arm_hooke1_y *
        ball1_minus_base_twist_hooke1_angle1_wx
        - ball1_arm_hooke1_x * ball1_minus_base_twist_hooke1_angle1_wy;
    const real ball1_minus_base_twist_hooke1_angle2_vx = hooke1_angle1_cos * ball1_child_p_z
        - hooke1_angle1_sin * ball1_arm_hooke1_y;
    const real ball1_minus_base_twist_hooke1_angle2_vy = hooke1_angle1_sin * ball1_arm_hooke1_x;
    const real ball1_base_twist_hooke1_angle2_vz = hooke1_angle1_cos * ball1_arm_hooke1_x;
    const real ball1_twist_hooke0_angle1_vx = ball1_platform_R_xx *
        ball1_base_twist_hooke0_angle1_vx
        + ball1_platform_R_yx * ball1_base_twist_hooke0_angle1_vy
        + ball1_platform_R_zx * ball1_base_twist_hooke0_angle1_vz;
    const real ball1_twist_hooke0_angle1_vy = ball1_platform_R_xy *
        ball1_base_twist_hooke0_angle1_vx
        + ball1_platform_R_yy * ball1_base_twist_hooke0_angle1_vy
        + ball1_platform_R_zy * ball1_base_twist_hooke0_angle1_vz;
    const real ball1_twist_hooke0_angle1_vz = ball1_platform_R_xz *
        ball1_base_twist_hooke0_angle1_vx
        + ball1_platform_R_yz * ball1_base_twist_hooke0_angle1_vy
        + ball1_platform_R_zz * ball1_base_twist_hooke0_angle1_vz;
    const real ball1_twist_hooke0_angle2_vx = ball1_platform_R_xx *
        ball1_base_twist_hooke0_angle2_vx
        + ball1_platform_R_yx * ball1_base_twist_hooke0_angle2_vy
        - ball1_platform_R_zx * ball1_minus_base_twist_hooke0_angle2_vz;
    const real ball1_twist_hooke0_angle2_vy = ball1_platform_R_xy *
        ball1_base_twist_hooke0_angle2_vx
        + ball1_platform_R_yy * ball1_base_twist_hooke0_angle2_vy
        - ball1_platform_R_zy * ball1_minus_base_twist_hooke0_angle2_vz;
    const real ball1_twist_hooke0_angle2_vz = ball1_platform_R_xz *
        ball1_base_twist_hooke0_angle2_vx
        + ball1_platform_R_yz * ball1_base_twist_hooke0_angle2_vy
        - ball1_platform_R_zz * ball1_minus_base_twist_hooke0_angle2_vz;
    const real ball1_twist_ball0_x_vx = ball1_platform_R_xx * ball1_base_twist_ball0_x_vx
        + ball1_platform_R_yx * ball1_base_twist_ball0_x_vy
        + ball1_platform_R_zx * ball1_base_twist_ball0_x_vz;
    const real ball1_twist_ball0_x_vy = ball1_platform_R_xy * ball1_base_twist_ball0_x_vx
        + ball1_platform_R_yy * ball1_base_twist_ball0_x_vy
        + ball1_platform_R_zy * ball1_base_twist_ball0_x_vz;
    const real ball1_twist_ball0_x_vz = ball1_platform_R_xz * ball1_base_twist_ball0_x_vx
        + ball1_platform_R_yz * ball1_base_twist_ball0_x_vy
        + ball1_platform_R_zz * ball1_base_twist_ball0_x_vz;
    const real ball1_twist_ball0_y_vx = ball1_platform_R_xx * ball1_base_twist_ball0_y_vx
        + ball1_platform_R_yx * ball1_base_twist_ball0_y_vy
        + ball1_platform_R_zx * ball1_base_twist_ball0_y_vz;
    const real ball1_twist_ball0_y_vy = ball1_platform_R_xy * ball1_base_twist_ball0_y_vx
        + ball1_platform_R_yy * ball1_base_twist_ball0_y_vy
        + ball1_platform_R_zy * ball1_base_twist_ball0_y_vz;
    const real ball1_twist_ball0_y_vz = ball1_platform_R_xz * ball1_base_twist_ball0_y_vx
        + ball1_platform_R_yz * ball1_base_twist_ball0_y_vy
        + ball1_platform_R_zz * ball1_base_twist_ball0_y_vz;
    const real ball1_twist_ball0_z_vx = ball1_platform_R_xx * ball1_base_twist_ball0_z_vx
        + ball1_platform_R_yx * ball1_base_twist_ball0_z_vy
        + ball1_platform_R_zx * ball1_base_twist_ball0_z_vz;
    const real ball1_twist_ball0_z_vy = ball1_platform_R_xy * ball1_base_twist_ball0_z_vx
        + ball1_platform_R_yy * ball1_base_twist_ball0_z_vy
        + ball1_platform_R_zy * ball1_base_twist_ball0_z_vz;
    const real ball1_twist_ball0_z_vz = ball1_platform_R_xz * ball1_base_twist_ball0_z_vx
        + ball1_platform_R_yz * ball1_base_twist_ball0_z_vy
        + ball1_platform_R_zz * ball1_base_twist_ball0_z_vz;
    const real ball1_minus_twist_hooke1_angle1_vx = ball1_platform_R_xx *
        ball1_minus_base_twist_hooke1_angle1_vx
        + ball1_platform_R_yx * ball1_minus_base_twist_hooke1_angle1_vy
        + ball1_platform_R_zx * ball1_minus_base_twist_hooke1_angle1_vz;
    const real ball1_minus_twist_hooke1_angle1_vy = ball1_platform_R_xy *
        ball1_minus_base_twist_hooke1_angle1_vx
        + ball1_platform_R_yy * ball1_minus_base_twist_hooke1_angle1_vy
        + ball1_platform_R_zy * ball1_minus_base_twist_hooke1_angle1_vz;
    const real ball1_minus_twist_hooke1_angle1_vz = ball1_platform_R_xz *
        ball1_minus_base_twist_hooke1_angle1_vx
        + ball1_platform_R_yz * ball1_minus_base_twist_hooke1_angle1_vy
        + ball1_platform_R_zz * ball1_minus_base_twist_hooke1_angle1_vz;
    const real ball1_twist_hooke1_angle2_vx = ball1_platform_R_zx *
        ball1_base_twist_hooke1_angle2_vz
        - (ball1_platform_R_xx * ball1_minus_base_twist_hooke1_angle2_vx
        + ball1_platform_R_yx * ball1_minus_base_twist_hooke1_angle2_vy);
    const real ball1_twist_hooke1_angle2_vy = ball1_platform_R_zy *
        ball1_base_twist_hooke1_angle2_vz
        - (ball1_platform_R_xy * ball1_minus_base_twist_hooke1_angle2_vx
        + ball1_platform_R_yy * ball1_minus_base_twist_hooke1_angle2_vy);
    const real ball1_twist_hooke1_angle2_vz = ball1_platform_R_zz *
        ball1_base_twist_hooke1_angle2_vz
        - (ball1_platform_R_xz * ball1_minus_base_twist_hooke1_angle2_vx
        + ball1_platform_R_yz * ball1_minus_base_twist_hooke1_angle2_vy);
    const real ball1_G_px_hooke0_angle1 = ball1_R_xx * ball1_twist_hooke0_angle1_vx
        + ball1_R_xy * ball1_twist_hooke0_angle1_vy + ball1_R_xz * ball1_twist_hooke0_angle1_vz;
    work[474] = ball1_G_px_hooke0_angle1;
    const real ball1_G_px_hooke0_angle2 = ball1_R_xx * ball1_twist_hooke0_angle2_vx
        + ball1_R_xy * ball1_twist_hooke0_angle2_vy + ball1_R_xz * ball1_twist_hooke0_angle2_vz;
    work[475] = ball1_G_px_hooke0_angle2;
    const real ball1_G_px_slide0 = ball1_R_xx * ball1_twist_slide0_vx
        + ball1_R_xy * ball1_twist_slide0_vy + ball1_R_xz * ball1_twist_slide0_vz;
    work[476] = ball1_G_px_slide0;
    const real ball1_G_px_ball0_x = ball1_R_xx * ball1_twist_ball0_x_vx
        + ball1_R_xy * ball1_twist_ball0_x_vy + ball1_R_xz * ball1_twist_ball0_x_vz;
    work[477] = ball1_G_px_ball0_x;
    const real ball1_G_px_ball0_y = ball1_R_xx * ball1_twist_ball0_y_vx
        + ball1_R_xy * ball1_twist_ball0_y_vy + ball1_R_xz * ball1_twist_ball0_y_vz;
    work[478] = ball1_G_px_ball0_y;
    const real ball1_G_px_ball0_z = ball1_R_xx * ball1_twist_ball0_z_vx
        + ball1_R_xy * ball1_twist_ball0_z_vy + ball1_R_xz * ball1_twist_ball0_z_vz;
    work[479] = ball1_G_px_ball0_z;
    const real ball1_minus_G_px_hooke1_angle1 = ball1_R_xx * ball1_minus_twist_hooke1_angle1_vx
        + ball1_R_xy * ball1_minus_twist_hooke1_angle1_vy
        + ball1_R_xz * ball1_minus_twist_hooke1_angle1_vz;
    work[480] = ball1_minus_G_px_hooke1_angle1;
    const real ball1_G_px_hooke1_angle2 = ball1_R_xx * ball1_twist_hooke1_angle2_vx
        + ball1_R_xy * ball1_twist_hooke1_angle2_vy + ball1_R_xz * ball1_twist_hooke1_angle2_vz;
    work[481] = ball1_G_px_hooke1_angle2;
    const real ball1_minus_G_px_slide1 = ball1_R_xx * ball1_R_zx + ball1_R_xy * ball1_R_zy
        + ball1_R_xz * ball1_R_zz;
    work[482] = ball1_minus_G_px_slide1;
    const real ball1_G_py_hooke0_angle1 = ball1_R_yx * ball1_twist_hooke0_angle1_vx
        + ball1_R_yy * ball1_twist_hooke0_angle1_vy + ball1_R_yz * ball1_twist_hooke0_angle1_vz;
    work[483] = ball1_G_py_hooke0_angle1;
    const real ball1_G_py_hooke0_angle2 = ball1_R_yx * ball1_twist_hooke0_angle2_vx
        + ball1_R_yy * ball1_twist_hooke0_angle2_vy + ball1_R_yz * ball1_twist_hooke0_angle2_vz;
    work[484] = ball1_G_py_hooke0_angle2;
    const real ball1_G_py_slide0 = ball1_R_yx * ball1_twist_slide0_vx
        + ball1_R_yy * ball1_twist_slide0_vy + ball1_R_yz * ball1_twist_slide0_vz;
    work[485] = ball1_G_py_slide0;
    const real ball1_G_py_ball0_x = ball1_R_yx * ball1_twist_ball0_x_vx
        + ball1_R_yy * ball1_twist_ball0_x_vy + ball1_R_yz * ball1_twist_ball0_x_vz;
    work[486] = ball1_G_py_ball0_x;
    const real ball1_G_py_ball0_y = ball1_R_yx * ball1_twist_ball0_y_vx
        + ball1_R_yy * ball1_twist_ball0_y_vy + ball1_R_yz * ball1_twist_ball0_y_vz;
    work[487] = ball1_G_py_ball0_y;
    const real ball1_G_py_ball0_z = ball1_R_yx * ball1_twist_ball0_z_vx
        + ball1_R_yy * ball1_twist_ball0_z_vy + ball1_R_yz * ball1_twist_ball0_z_vz;
    work[488] = ball1_G_py_ball0_z;
    const real ball1_minus_G_py_hooke1_angle1 = ball1_R_yx * ball1_minus_twist_hooke1_angle1_vx
        + ball1_R_yy * ball1_minus_twist_hooke1_angle1_vy
        + ball1_R_yz * ball1_minus_twist_hooke1_angle1_vz;
    work[489] = ball1_minus_G_py_hooke1_angle1;
    const real ball1_G_py_hooke1_angle2 = ball1_R_yx * ball1_twist_hooke1_angle2_vx
        + ball1_R_yy * ball1_twist_hooke1_angle2_vy + ball1_R_yz * ball1_twist_hooke1_angle2_vz;
    work[490] = ball1_G_py_hooke1_angle2;
    const real ball1_minus_G_py_slide1 = ball1_R_yx * ball1_R_zx + ball1_R_yy * ball1_R_zy
        + ball1_R_yz * ball1_R_zz;
    work[491] = ball1_minus_G_py_slide1;
    const real ball1_G_pz_hooke0_angle1 = ball1_R_zx * ball1_twist_hooke0_angle1_vx
        + ball1_R_zy * ball1_twist_hooke0_angle1_vy + ball1_R_zz * ball1_twist_hooke0_angle1_vz;
    work[492] = ball1_G_pz_hooke0_angle1;
    const real ball1_G_pz_hooke0_angle2 = ball1_R_zx * ball1_twist_hooke0_angle2_vx
        + ball1_R_zy * ball1_twist_hooke0_angle2_vy + ball1_R_zz * ball1_twist_hooke0_angle2_vz;
    work[493] = ball1_G_pz_hooke0_angle2;
    const real ball1_G_pz_slide0 = ball1_R_zx * ball1_twist_slide0_vx
        + ball1_R_zy * ball1_twist_slide0_vy + ball1_R_zz * ball1_twist_slide0_vz;
    work[494] = ball1_G_pz_slide0;
    const real ball1_G_pz_ball0_x = ball1_R_zx * ball1_twist_ball0_x_vx
        + ball1_R_zy * ball1_twist_ball0_x_vy + ball1_R_zz * ball1_twist_ball0_x_vz;
    work[495] = ball1_G_pz_ball0_x;
    const real ball1_G_pz_ball0_y = ball1_R_zx * ball1_twist_ball0_y_vx
        + ball1_R_zy * ball1_twist_ball0_y_vy + ball1_R_zz * ball1_twist_ball0_y_vz;
    work[496] = ball1_G_pz_ball0_y;
    const real ball1_G_pz_ball0_z = ball1_R_zx * ball1_twist_ball0_z_vx
        + ball1_R_zy * ball1_twist_ball0_z_vy + ball1_R_zz * ball1_twist_ball0_z_vz;
    work[497] = ball1_G_pz_ball0_z;
    const real ball1_minus_G_pz_hooke1_angle1 = ball1_R_zx * ball1_minus_twist_hooke1_angle1_vx
        + ball1_R_zy * ball1_minus_twist_hooke1_angle1_vy
        + ball1_R_zz * ball1_minus_twist_hooke1_angle1_vz;
    work[498] = ball1_minus_G_pz_hooke1_angle1;
    const real ball1_G_pz_hooke1_angle2 = ball1_R_zx * ball1_twist_hooke1_angle2_vx
        + ball1_R_zy * ball1_twist_hooke1_angle2_vy + ball1_R_zz * ball1_twist_hooke1_angle2_vz;
    work[499] = ball1_G_pz_hooke1_angle2;
    const real ball1_minus_G_pz_slide1 = ball1_R_zx * ball1_R_zx + ball1_R_zy * ball1_R_zy
        + ball1_R_zz * ball1_R_zz;
    work[500] = ball1_minus_G_pz_slide1;
    const real ball1_platform_R_xx_rate = ball0_R_zx * hooke0_u_angle2_times_angle2_cos
        + hooke0_angle2_sin * ball0_R_zx_rate - (ball0_R_xx * hooke0_u_angle2_times_angle2_sin
        + hooke0_angle2_cos * ball0_minus_R_xx_rate);
    work[501] = ball1_platform_R_xx_rate;
    const real ball1_platform_R_xy_rate = hooke0_angle2_cos * ball0_R_xy_rate
        - ball0_R_xy * hooke0_u_angle2_times_angle2_sin
        + (ball0_R_zy * hooke0_u_angle2_times_angle2_cos + hooke0_angle2_sin * ball0_R_zy_rate);
    work[502] = ball1_platform_R_xy_rate;
    const real ball1_platform_R_xz_rate = hooke0_angle2_cos * ball0_R_xz_rate
        - ball0_R_xz * hooke0_u_angle2_times_angle2_sin
        + (ball0_R_zz * hooke0_u_angle2_times_angle2_cos
        - hooke0_angle2_sin * ball0_minus_R_zz_rate);
    work[503] = ball1_platform_R_xz_rate;
    const real ball1_platform_R_yx_rate = ball0_R_xx * hooke0_R_yx_rate
        - hooke0_R_yx * ball0_minus_R_xx_rate + (hooke0_angle1_cos * ball0_R_yx_rate
        - ball0_R_yx * hooke0_u_angle1_times_angle1_sin) - (ball0_R_zx * hooke0_minus_R_yz_rate
        + hooke0_minus_R_yz * ball0_R_zx_rate);
    work[504] = ball1_platform_R_yx_rate;
    const real ball1_platform_R_yy_rate = ball0_R_xy * hooke0_R_yx_rate
        + hooke0_R_yx * ball0_R_xy_rate - (ball0_R_yy * hooke0_u_angle1_times_angle1_sin
        + hooke0_angle1_cos * ball0_minus_R_yy_rate) - (ball0_R_zy * hooke0_minus_R_yz_rate
        + hooke0_minus_R_yz * ball0_R_zy_rate);
    work[505] = ball1_platform_R_yy_rate;
    const real ball1_platform_R_yz_rate = ball0_R_xz * hooke0_R_yx_rate
        + hooke0_R_yx * ball0_R_xz_rate + (hooke0_angle1_cos * ball0_R_yz_rate
        - ball0_R_yz * hooke0_u_angle1_times_angle1_sin) - (ball0_R_zz * hooke0_minus_R_yz_rate
        - hooke0_minus_R_yz * ball0_minus_R_zz_rate);
    work[506] = ball1_platform_R_yz_rate;
    const real ball1_platform_R_zx_rate = ball0_R_yx * hooke0_u_angle1_times_angle1_cos
        + hooke0_angle1_sin * ball0_R_yx_rate - (ball0_R_xx * hooke0_minus_R_zx_rate
        - hooke0_minus_R_zx * ball0_minus_R_xx_rate) + (hooke0_R_zz * ball0_R_zx_rate
        - ball0_R_zx * hooke0_minus_R_zz_rate);
    work[507] = ball1_platform_R_zx_rate;
    const real ball1_platform_R_zy_rate = ball0_R_yy * hooke0_u_angle1_times_angle1_cos
        - hooke0_angle1_sin * ball0_minus_R_yy_rate - (ball0_R_xy * hooke0_minus_R_zx_rate
        + hooke0_minus_R_zx * ball0_R_xy_rate) + (hooke0_R_zz * ball0_R_zy_rate
        - ball0_R_zy * hooke0_minus_R_zz_rate);
    work[508] = ball1_platform_R_zy_rate;
    const real ball1_platform_R_zz_rate = ball0_R_yz * hooke0_u_angle1_times_angle1_cos
        + hooke0_angle1_sin * ball0_R_yz_rate - (ball0_R_xz * hooke0_minus_R_zx_rate
        + hooke0_minus_R_zx * ball0_R_xz_rate) - (ball0_R_zz * hooke0_minus_R_zz_rate
        + hooke0_R_zz * ball0_minus_R_zz_rate);
    work[509] = ball1_platform_R_zz_rate;
    const real ball1_platform_p_x_rate = ball1_base_twist_by_slide0_vx
        + slide0_q * hooke0_u_angle2_times_angle2_cos
        + slide0_position_z * hooke0_u_angle2_times_angle2_cos;
    work[510] = ball1_platform_p_x_rate;
    const real ball1_minus_platform_p_y_rate = ball1_minus_base_twist_by_slide0_vy
        + slide0_q * hooke0_minus_R_yz_rate + slide0_position_z * hooke0_minus_R_yz_rate;
    work[511] = ball1_minus_platform_p_y_rate;
    const real ball1_platform_p_z_rate = ball1_base_twist_by_slide0_vz
        - slide0_q * hooke0_minus_R_zz_rate - slide0_position_z * hooke0_minus_R_zz_rate;
    work[512] = ball1_platform_p_z_rate;
    const real ball1_child_p_x_rate = ball1_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_xx_rate
        + ball1_child_position_y_minus_ball0_child_position_y * ball1_platform_R_xy_rate
        + ball1_platform_p_x_rate;
    const real ball1_child_p_y_rate = ball1_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_yx_rate
        + ball1_child_position_y_minus_ball0_child_position_y * ball1_platform_R_yy_rate
        - ball1_minus_platform_p_y_rate;
    const real ball1_child_p_z_rate = ball1_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_zx_rate
        + ball1_child_position_y_minus_ball0_child_position_y * ball1_platform_R_zy_rate
        + ball1_platform_p_z_rate;
    const real ball1_R_xx_rate_part = hooke1_angle2_cos * ball1_platform_R_xx_rate
        - ball1_platform_R_xx * hooke1_u_angle2_times_angle2_sin
        + (hooke1_R_yx * ball1_platform_R_yx_rate + ball1_platform_R_yx * hooke1_R_yx_rate);
    work[513] = ball1_R_xx_rate_part;
    const real ball1_R_xy_rate_part = hooke1_angle2_cos * ball1_platform_R_xy_rate
        - ball1_platform_R_xy * hooke1_u_angle2_times_angle2_sin
        + (hooke1_R_yx * ball1_platform_R_yy_rate + ball1_platform_R_yy * hooke1_R_yx_rate);
    work[514] = ball1_R_xy_rate_part;
    const real ball1_R_xz_rate_part = hooke1_angle2_cos * ball1_platform_R_xz_rate
        - ball1_platform_R_xz * hooke1_u_angle2_times_angle2_sin
        + (hooke1_R_yx * ball1_platform_R_yz_rate + ball1_platform_R_yz * hooke1_R_yx_rate);
    work[515] = ball1_R_xz_rate_part;
    const real ball1_R_zx_rate_part = hooke1_angle2_sin * ball1_platform_R_xx_rate
        + ball1_platform_R_xx * hooke1_u_angle2_times_angle2_cos
        - (hooke1_minus_R_yz * ball1_platform_R_yx_rate
        + ball1_platform_R_yx * hooke1_minus_R_yz_rate);
    work[516] = ball1_R_zx_rate_part;
    const real ball1_R_zy_rate_part = hooke1_angle2_sin * ball1_platform_R_xy_rate
        + ball1_platform_R_xy * hooke1_u_angle2_times_angle2_cos
        - (hooke1_minus_R_yz * ball1_platform_R_yy_rate
        + ball1_platform_R_yy * hooke1_minus_R_yz_rate);
    work[517] = ball1_R_zy_rate_part;
    const real ball1_R_zz_rate_part = hooke1_angle2_sin * ball1_platform_R_xz_rate
        + ball1_platform_R_xz * hooke1_u_angle2_times_angle2_cos
        - (hooke1_minus_R_yz * ball1_platform_R_yz_rate
        + ball1_platform_R_yz * hooke1_minus_R_yz_rate);
    work[518] = ball1_R_zz_rate_part;
    const real ball1_base_twist_by_slide0_vx_rate = slide0_u * hooke0_u_angle2_times_angle2_cos;
    work[519] = ball1_base_twist_by_slide0_vx_rate;
    const real ball1_minus_base_twist_by_slide0_vy_rate = slide0_u * hooke0_minus_R_yz_rate;
    work[520] = ball1_minus_base_twist_by_slide0_vy_rate;
    const real ball1_minus_base_twist_by_slide0_vz_rate = slide0_u * hooke0_minus_R_zz_rate;
    work[521] = ball1_minus_base_twist_by_slide0_vz_rate;
    const real ball1_arm_ball0_x_rate = ball1_child_p_x_rate - ball1_platform_p_x_rate;
    const real ball1_arm_ball0_y_rate = ball1_minus_platform_p_y_rate + ball1_child_p_y_rate;
    const real ball1_arm_ball0_z_rate = ball1_child_p_z_rate - ball1_platform_p_z_rate;
    const real ball1_base_twist_by_ball0_wx_rate = ball0_u_x * ball1_platform_R_xx_rate
        + ball0_u_y * ball1_platform_R_xy_rate + ball0_u_z * ball1_platform_R_xz_rate;
    work[522] = ball1_base_twist_by_ball0_wx_rate;
    const real ball1_base_twist_by_ball0_wy_rate = ball0_u_x * ball1_platform_R_yx_rate
        + ball0_u_y * ball1_platform_R_yy_rate + ball0_u_z * ball1_platform_R_yz_rate;
    work[523] = ball1_base_twist_by_ball0_wy_rate;
    const real ball1_base_twist_by_ball0_wz_rate = ball0_u_x * ball1_platform_R_zx_rate
        + ball0_u_y * ball1_platform_R_zy_rate + ball0_u_z * ball1_platform_R_zz_rate;
    work[524] = ball1_base_twist_by_ball0_wz_rate;
    const real ball1_base_twist_by_ball0_vy_rate = ball1_base_twist_by_ball0_wz *
        ball1_arm_ball0_x_rate + ball1_arm_ball0_x * ball1_base_twist_by_ball0_wz_rate
        - (ball1_base_twist_by_ball0_wx * ball1_arm_ball0_z_rate
        + ball1_arm_ball0_z * ball1_base_twist_by_ball0_wx_rate);
    const real ball1_base_twist_by_ball0_vz_rate = ball1_base_twist_by_ball0_wx *
        ball1_arm_ball0_y_rate + ball1_arm_ball0_y * ball1_base_twist_by_ball0_wx_rate
        - (ball1_base_twist_by_ball0_wy * ball1_arm_ball0_x_rate
        + ball1_arm_ball0_x * ball1_base_twist_by_ball0_wy_rate);

    /* tube0: omega, alpha, a, U */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const real tube0_omega_x = hooke0_u_angle1 * hooke0_angle2_cos;
    work[525] = tube0_omega_x;
    const real tube0_omega_z = hooke0_u_angle1 * hooke0_angle2_sin;
    work[526] = tube0_omega_z;
    const real tube0_alpha_z = hooke0_angle2_cos * hooke0_u_angle1_times_u_angle2;
    work[527] = tube0_alpha_z;
    const real tube0_a_x = gravity_z * hooke0_minus_R_zx;
    work[528] = tube0_a_x;
    const real tube0_minus_a_y = gravity_z * hooke0_angle1_sin;
    work[529] = tube0_minus_a_y;
    const real tube0_U_xz = tube0_omega_x * tube0_omega_z;
    work[530] = tube0_U_xz;

    /* shared by several: twist, U */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* U = [alpha] + [omega][omega] */
    const real ball1_base_twist_by_hooke0_wx = hooke0_angle2_cos * tube0_omega_x
        + hooke0_angle2_sin * tube0_omega_z;
    work[531] = ball1_base_twist_by_hooke0_wx;
    const real ball1_base_twist_by_hooke0_wy = hooke0_R_yx * tube0_omega_x
        + hooke0_u_angle2 * hooke0_angle1_cos - hooke0_minus_R_yz * tube0_omega_z;
    work[532] = ball1_base_twist_by_hooke0_wy;
    const real ball1_base_twist_by_hooke0_wz = hooke0_u_angle2 * hooke0_angle1_sin
        - hooke0_minus_R_zx * tube0_omega_x + hooke0_R_zz * tube0_omega_z;
    work[533] = ball1_base_twist_by_hooke0_wz;
    const real hooke0_u_angle2_times_tube0_omega_x = hooke0_u_angle2 * tube0_omega_x;
    work[534] = hooke0_u_angle2_times_tube0_omega_x;
    const real hooke0_u_angle2_times_tube0_omega_z = hooke0_u_angle2 * tube0_omega_z;
    work[535] = hooke0_u_angle2_times_tube0_omega_z;
    const real tube0_minus_U_zz = tube0_omega_x * tube0_omega_x + hooke0_u_angle2 * hooke0_u_angle2;
    work[536] = tube0_minus_U_zz;

    /* ball1: twist */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    const real ball1_base_twist_vx_part = ball1_child_p_z * ball1_base_twist_by_hooke0_wy
        - ball1_arm_hooke0_y * ball1_base_twist_by_hooke0_wz + ball1_base_twist_by_slide0_vx
        + (ball1_arm_ball0_z * ball1_base_twist_by_ball0_wy
        - ball1_arm_ball0_y * ball1_base_twist_by_ball0_wz);
    const real ball1_base_twist_vy_part = ball1_arm_hooke0_x * ball1_base_twist_by_hooke0_wz
        - ball1_child_p_z * ball1_base_twist_by_hooke0_wx - ball1_minus_base_twist_by_slide0_vy
        + (ball1_arm_ball0_x * ball1_base_twist_by_ball0_wz
        - ball1_arm_ball0_z * ball1_base_twist_by_ball0_wx);
    const real ball1_base_twist_vz_part = ball1_arm_hooke0_y * ball1_base_twist_by_hooke0_wx
        - ball1_arm_hooke0_x * ball1_base_twist_by_hooke0_wy + ball1_base_twist_by_slide0_vz
        + (ball1_arm_ball0_y * ball1_base_twist_by_ball0_wx
        - ball1_arm_ball0_x * ball1_base_twist_by_ball0_wy);
    const real ball1_base_twist_by_hooke0_wx_rate = tube0_omega_z * hooke0_u_angle2_times_angle2_cos
        + hooke0_angle2_sin * tube0_omega_z_rate
        - (tube0_omega_x * hooke0_u_angle2_times_angle2_sin
        + hooke0_angle2_cos * tube0_minus_omega_x_rate);
    work[537] = ball1_base_twist_by_hooke0_wx_rate;
    const real ball1_base_twist_by_hooke0_wy_rate = tube0_omega_x * hooke0_R_yx_rate
        - hooke0_R_yx * tube0_minus_omega_x_rate
        - hooke0_u_angle2 * hooke0_u_angle1_times_angle1_sin
        - (tube0_omega_z * hooke0_minus_R_yz_rate + hooke0_minus_R_yz * tube0_omega_z_rate);
    work[538] = ball1_base_twist_by_hooke0_wy_rate;
    const real ball1_base_twist_by_hooke0_wz_rate = hooke0_u_angle2 *
        hooke0_u_angle1_times_angle1_cos - (tube0_omega_x * hooke0_minus_R_zx_rate
        - hooke0_minus_R_zx * tube0_minus_omega_x_rate) + (hooke0_R_zz * tube0_omega_z_rate
        - tube0_omega_z * hooke0_minus_R_zz_rate);
    work[539] = ball1_base_twist_by_hooke0_wz_rate;
    const real ball1_base_twist_by_hooke0_vy_rate = ball1_base_twist_by_hooke0_wz *
        ball1_child_p_x_rate + ball1_arm_hooke0_x * ball1_base_twist_by_hooke0_wz_rate
        - (ball1_base_twist_by_hooke0_wx * ball1_child_p_z_rate
        + ball1_child_p_z * ball1_base_twist_by_hooke0_wx_rate);
    const real ball1_base_twist_by_hooke0_vz_rate = ball1_base_twist_by_hooke0_wx *
        ball1_child_p_y_rate + ball1_arm_hooke0_y * ball1_base_twist_by_hooke0_wx_rate
        - (ball1_base_twist_by_hooke0_wy * ball1_child_p_x_rate
        + ball1_arm_hooke0_x * ball1_base_twist_by_hooke0_wy_rate);
    const real ball1_base_twist_vx_rate_part = ball1_base_twist_by_hooke0_wy * ball1_child_p_z_rate
        + ball1_child_p_z * ball1_base_twist_by_hooke0_wy_rate
        - (ball1_base_twist_by_hooke0_wz * ball1_child_p_y_rate
        + ball1_arm_hooke0_y * ball1_base_twist_by_hooke0_wz_rate)
        + ball1_base_twist_by_slide0_vx_rate;
    const real ball1_base_twist_vx_rate_part_2 = ball1_base_twist_by_ball0_wy *
        ball1_arm_ball0_z_rate + ball1_arm_ball0_z * ball1_base_twist_by_ball0_wy_rate
        - (ball1_base_twist_by_ball0_wz * ball1_arm_ball0_y_rate
        + ball1_arm_ball0_y * ball1_base_twist_by_ball0_wz_rate) + ball1_base_twist_vx_rate_part;

    /* tube1: omega, alpha, inertia, composite, a, U */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    const real slide1_q = q[9]; /* m */
    const wreal half_rod1_mass = w[44];
    const wreal rod1_base_moment_z = w[45];
    const wreal tube1_base_inertia_xx = w[66];
    const wreal tube1_base_inertia_yy = w[67];
    const real tube1_omega_x = hooke1_u_angle1 * hooke1_angle2_cos;
    work[540] = tube1_omega_x;
    const real tube1_omega_z = hooke1_u_angle1 * hooke1_angle2_sin;
    work[541] = tube1_omega_z;
    const real tube1_alpha_z = hooke1_angle2_cos * hooke1_u_angle1_times_u_angle2;
    work[542] = tube1_alpha_z;
    const real tube1_inertia_shift = slide1_q * (rod1_base_moment_z
        + slide1_q * half_rod1_mass) * 2.0;
    const real tube1_composite_inertia_xx = tube1_base_inertia_xx + tube1_inertia_shift;
    work[543] = tube1_composite_inertia_xx;
    const real tube1_composite_inertia_yy = tube1_base_inertia_yy + tube1_inertia_shift;
    work[544] = tube1_composite_inertia_yy;
    const real tube1_a_x = gravity_z * hooke1_minus_R_zx;
    work[545] = tube1_a_x;
    const real tube1_minus_a_y = gravity_z * hooke1_angle1_sin;
    work[546] = tube1_minus_a_y;
    const real tube1_U_xz = tube1_omega_x * tube1_omega_z;
    work[547] = tube1_U_xz;

    /* ball1: twist */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    const real slide1_u = u[8]; /* m/s */
    const real ball1_minus_base_twist_by_hooke1_wx = hooke1_angle2_cos * tube1_omega_x
        + hooke1_angle2_sin * tube1_omega_z;
    const real ball1_minus_base_twist_by_hooke1_wy = hooke1_R_yx * tube1_omega_x
        + hooke1_u_angle2 * hooke1_angle1_cos - hooke1_minus_R_yz * tube1_omega_z;
    const real ball1_minus_base_twist_by_hooke1_wz = hooke1_u_angle2 * hooke1_angle1_sin
        - hooke1_minus_R_zx * tube1_omega_x + hooke1_R_zz * tube1_omega_z;
    const real ball1_base_twist_vx = ball1_base_twist_vx_part
        - (ball1_child_p_z * ball1_minus_base_twist_by_hooke1_wy
        - ball1_arm_hooke1_y * ball1_minus_base_twist_by_hooke1_wz) - slide1_u * hooke1_angle2_sin;
    const real ball1_base_twist_vy = ball1_base_twist_vy_part
        - (ball1_arm_hooke1_x * ball1_minus_base_twist_by_hooke1_wz
        - ball1_child_p_z * ball1_minus_base_twist_by_hooke1_wx) + slide1_u * hooke1_minus_R_yz;
    const real ball1_base_twist_vz = ball1_base_twist_vz_part
        - (ball1_arm_hooke1_y * ball1_minus_base_twist_by_hooke1_wx
        - ball1_arm_hooke1_x * ball1_minus_base_twist_by_hooke1_wy) - slide1_u * hooke1_R_zz;
    const real ball1_twist_vx = ball1_platform_R_xx * ball1_base_twist_vx
        + ball1_platform_R_yx * ball1_base_twist_vy + ball1_platform_R_zx * ball1_base_twist_vz;
    work[548] = ball1_twist_vx;
    const real ball1_twist_vy = ball1_platform_R_xy * ball1_base_twist_vx
        + ball1_platform_R_yy * ball1_base_twist_vy + ball1_platform_R_zy * ball1_base_twist_vz;
    work[549] = ball1_twist_vy;
    const real ball1_twist_vz = ball1_platform_R_xz * ball1_base_twist_vx
        + ball1_platform_R_yz * ball1_base_twist_vy + ball1_platform_R_zz * ball1_base_twist_vz;
    work[550] = ball1_twist_vz;
    const real ball1_minus_base_twist_by_hooke1_wx_rate = tube1_omega_z *
        hooke1_u_angle2_times_angle2_cos + hooke1_angle2_sin * tube1_omega_z_rate
        - (tube1_omega_x * hooke1_u_angle2_times_angle2_sin
        + hooke1_angle2_cos * tube1_minus_omega_x_rate);
    const real ball1_minus_base_twist_by_hooke1_wy_rate = tube1_omega_x * hooke1_R_yx_rate
        - hooke1_R_yx * tube1_minus_omega_x_rate
        - hooke1_u_angle2 * hooke1_u_angle1_times_angle1_sin
        - (tube1_omega_z * hooke1_minus_R_yz_rate + hooke1_minus_R_yz * tube1_omega_z_rate);
    const real ball1_minus_base_twist_by_hooke1_wz_rate = hooke1_u_angle2 *
        hooke1_u_angle1_times_angle1_cos - (tube1_omega_x * hooke1_minus_R_zx_rate
        - hooke1_minus_R_zx * tube1_minus_omega_x_rate) + (hooke1_R_zz * tube1_omega_z_rate
        - tube1_omega_z * hooke1_minus_R_zz_rate);
    const real ball1_minus_base_twist_by_hooke1_vx_rate = ball1_minus_base_twist_by_hooke1_wy *
        ball1_child_p_z_rate + ball1_child_p_z * ball1_minus_base_twist_by_hooke1_wy_rate
        - (ball1_minus_base_twist_by_hooke1_wz * ball1_child_p_y_rate
        + ball1_arm_hooke1_y * ball1_minus_base_twist_by_hooke1_wz_rate);
    const real ball1_minus_base_twist_by_hooke1_vy_rate = ball1_minus_base_twist_by_hooke1_wz *
        ball1_child_p_x_rate + ball1_arm_hooke1_x * ball1_minus_base_twist_by_hooke1_wz_rate
        - (ball1_minus_base_twist_by_hooke1_wx * ball1_child_p_z_rate
        + ball1_child_p_z * ball1_minus_base_twist_by_hooke1_wx_rate);
    const real ball1_minus_base_twist_by_hooke1_vz_rate = ball1_minus_base_twist_by_hooke1_wx *
        ball1_child_p_y_rate + ball1_arm_hooke1_y * ball1_minus_base_twist_by_hooke1_wx_rate
        - (ball1_minus_base_twist_by_hooke1_wy * ball1_child_p_x_rate
        + ball1_arm_hooke1_x * ball1_minus_base_twist_by_hooke1_wy_rate);
    const real ball1_base_twist_vx_rate = ball1_base_twist_vx_rate_part_2
        - ball1_minus_base_twist_by_hooke1_vx_rate - slide1_u * hooke1_u_angle2_times_angle2_cos;
    const real ball1_base_twist_vy_rate = ball1_base_twist_by_hooke0_vy_rate
        - ball1_minus_base_twist_by_slide0_vy_rate + ball1_base_twist_by_ball0_vy_rate
        - ball1_minus_base_twist_by_hooke1_vy_rate + slide1_u * hooke1_minus_R_yz_rate;
    const real ball1_base_twist_vz_rate = ball1_base_twist_by_hooke0_vz_rate
        - ball1_minus_base_twist_by_slide0_vz_rate + ball1_base_twist_by_ball0_vz_rate
        - ball1_minus_base_twist_by_hooke1_vz_rate + slide1_u * hooke1_minus_R_zz_rate;
    const real ball1_twist_vx_rate_part = ball1_base_twist_vx * ball1_platform_R_xx_rate
        + ball1_platform_R_xx * ball1_base_twist_vx_rate
        + (ball1_base_twist_vy * ball1_platform_R_yx_rate
        + ball1_platform_R_yx * ball1_base_twist_vy_rate);
    const real ball1_twist_vx_rate = ball1_base_twist_vz * ball1_platform_R_zx_rate
        + ball1_platform_R_zx * ball1_base_twist_vz_rate + ball1_twist_vx_rate_part;
    work[551] = ball1_twist_vx_rate;
    const real ball1_twist_vy_rate_part = ball1_base_twist_vx * ball1_platform_R_xy_rate
        + ball1_platform_R_xy * ball1_base_twist_vx_rate
        + (ball1_base_twist_vy * ball1_platform_R_yy_rate
        + ball1_platform_R_yy * ball1_base_twist_vy_rate);
    const real ball1_twist_vy_rate = ball1_base_twist_vz * ball1_platform_R_zy_rate
        + ball1_platform_R_zy * ball1_base_twist_vz_rate + ball1_twist_vy_rate_part;
    work[552] = ball1_twist_vy_rate;
    const real ball1_twist_vz_rate_part = ball1_base_twist_vx * ball1_platform_R_xz_rate
        + ball1_platform_R_xz * ball1_base_twist_vx_rate
        + (ball1_base_twist_vy * ball1_platform_R_yz_rate
        + ball1_platform_R_yz * ball1_base_twist_vy_rate);
    const real ball1_twist_vz_rate = ball1_base_twist_vz * ball1_platform_R_zz_rate
        + ball1_platform_R_zz * ball1_base_twist_vz_rate + ball1_twist_vz_rate_part;
    work[553] = ball1_twist_vz_rate;

    /* hooke2: R, drift, velocity */
    /* R = R_fixed R_joint(q) */
    /* drift = S' u + [0; omega x v] */
    /* velocity = S u */
    const real hooke2_u_angle1 = u[9]; /* rad/s */
    const real hooke2_u_angle2 = u[10]; /* rad/s */
    const real hooke2_R_yx = hooke2_angle1_sin * hooke2_angle2_sin;
    work[554] = hooke2_R_yx;
    const real hooke2_minus_R_yz = hooke2_angle1_sin * hooke2_angle2_cos;
    work[555] = hooke2_minus_R_yz;
    const real hooke2_minus_R_zx = hooke2_angle1_cos * hooke2_angle2_sin;
    work[556] = hooke2_minus_R_zx;
    const real hooke2_R_zz = hooke2_angle1_cos * hooke2_angle2_cos;
    work[557] = hooke2_R_zz;
    const real hooke2_u_angle1_times_u_angle2 = hooke2_u_angle1 * hooke2_u_angle2;
    work[558] = hooke2_u_angle1_times_u_angle2;
    const real hooke2_minus_drift_relative_wx = hooke2_angle2_sin * hooke2_u_angle1_times_u_angle2;
    work[559] = hooke2_minus_drift_relative_wx;
    const real hooke2_u_angle1_times_angle1_sin = hooke2_u_angle1 * hooke2_angle1_sin;
    work[560] = hooke2_u_angle1_times_angle1_sin;
    const real hooke2_u_angle1_times_angle1_cos = hooke2_u_angle1 * hooke2_angle1_cos;
    work[561] = hooke2_u_angle1_times_angle1_cos;
    const real hooke2_u_angle2_times_angle2_sin = hooke2_u_angle2 * hooke2_angle2_sin;
    work[562] = hooke2_u_angle2_times_angle2_sin;
    const real hooke2_u_angle2_times_angle2_cos = hooke2_u_angle2 * hooke2_angle2_cos;
    work[563] = hooke2_u_angle2_times_angle2_cos;
    const real hooke2_R_yx_rate = hooke2_angle2_sin * hooke2_u_angle1_times_angle1_cos
        + hooke2_angle1_sin * hooke2_u_angle2_times_angle2_cos;
    work[564] = hooke2_R_yx_rate;
    const real hooke2_minus_R_yz_rate = hooke2_angle2_cos * hooke2_u_angle1_times_angle1_cos
        - hooke2_angle1_sin * hooke2_u_angle2_times_angle2_sin;
    work[565] = hooke2_minus_R_yz_rate;
    const real hooke2_minus_R_zx_rate = hooke2_angle1_cos * hooke2_u_angle2_times_angle2_cos
        - hooke2_angle2_sin * hooke2_u_angle1_times_angle1_sin;
    work[566] = hooke2_minus_R_zx_rate;
    const real hooke2_minus_R_zz_rate = hooke2_angle2_cos * hooke2_u_angle1_times_angle1_sin
        + hooke2_angle1_cos * hooke2_u_angle2_times_angle2_sin;
    work[567] = hooke2_minus_R_zz_rate;
    const real tube2_minus_omega_x_rate = hooke2_u_angle1 * hooke2_u_angle2_times_angle2_sin;
    work[568] = tube2_minus_omega_x_rate;
    const real tube2_omega_z_rate = hooke2_u_angle1 * hooke2_u_angle2_times_angle2_cos;
    work[569] = tube2_omega_z_rate;
    return CARDAN_OK;
}

CARDAN_PART int forward_dynamics_part2(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    (void)out;

    /* ball2: pose, twist, G */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* G = d(rate) / du */
    const wreal hooke0_position_x = w[1]; /* m */
    const wreal hooke0_position_y = w[2]; /* m */
    const wreal hooke2_position_x = w[18]; /* m */
    const wreal hooke2_position_y = w[19]; /* m */
    const wreal ball2_child_position_x_minus_ball0_child_position_x = w[36];
    const wreal ball2_child_position_y_minus_ball0_child_position_y = w[37];
    const real ball1_platform_p_x = work[434];
    const real ball1_platform_R_xx = work[425];
    const real ball1_platform_R_xy = work[426];
    const real ball2_child_p_x = ball2_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_xx
        + ball2_child_position_y_minus_ball0_child_position_y * ball1_platform_R_xy
        + ball1_platform_p_x;
    const real ball1_platform_p_y = work[435];
    const real ball1_platform_R_yx = work[428];
    const real ball1_platform_R_yy = work[429];
    const real ball2_child_p_y = ball2_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_yx
        + ball2_child_position_y_minus_ball0_child_position_y * ball1_platform_R_yy
        + ball1_platform_p_y;
    const real ball1_platform_p_z = work[436];
    const real ball1_platform_R_zx = work[431];
    const real ball1_platform_R_zy = work[432];
    const real ball2_child_p_z = ball2_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_zx
        + ball2_child_position_y_minus_ball0_child_position_y * ball1_platform_R_zy
        + ball1_platform_p_z;
    const real hooke2_angle2_cos = work[400];
    const real hooke2_R_yx = work[554];
    const real hooke2_minus_R_zx = work[556];
    const real ball2_R_xx = ball1_platform_R_xx * hooke2_angle2_cos
        + ball1_platform_R_yx * hooke2_R_yx - ball1_platform_R_zx * hooke2_minus_R_zx;
    const real ball2_R_xy = ball1_platform_R_xy * hooke2_angle2_cos
        + ball1_platform_R_yy * hooke2_R_yx - ball1_platform_R_zy * hooke2_minus_R_zx;
    const real ball1_platform_R_xz = work[427];
    const real ball1_platform_R_yz = work[430];
    const real ball1_platform_R_zz = work[433];
    const real ball2_R_xz = ball1_platform_R_xz * hooke2_angle2_cos
        + ball1_platform_R_yz * hooke2_R_yx - ball1_platform_R_zz * hooke2_minus_R_zx;
    work[570] = ball2_R_xz;
    const real hooke2_angle1_cos = work[398];
    const real hooke2_angle1_sin = work[399];
    const real ball2_R_yx = ball1_platform_R_yx * hooke2_angle1_cos
        + ball1_platform_R_zx * hooke2_angle1_sin;
    work[571] = ball2_R_yx;
    const real ball2_R_yy = ball1_platform_R_yy * hooke2_angle1_cos
        + ball1_platform_R_zy * hooke2_angle1_sin;
    work[572] = ball2_R_yy;
    const real ball2_R_yz = ball1_platform_R_yz * hooke2_angle1_cos
        + ball1_platform_R_zz * hooke2_angle1_sin;
    work[573] = ball2_R_yz;
    const real hooke2_angle2_sin = work[401];
    const real hooke2_minus_R_yz = work[555];
    const real hooke2_R_zz = work[557];
    const real ball2_R_zx = ball1_platform_R_xx * hooke2_angle2_sin
        - ball1_platform_R_yx * hooke2_minus_R_yz + ball1_platform_R_zx * hooke2_R_zz;
    const real ball2_R_zy = ball1_platform_R_xy * hooke2_angle2_sin
        - ball1_platform_R_yy * hooke2_minus_R_yz + ball1_platform_R_zy * hooke2_R_zz;
    const real ball2_R_zz = ball1_platform_R_xz * hooke2_angle2_sin
        - ball1_platform_R_yz * hooke2_minus_R_yz + ball1_platform_R_zz * hooke2_R_zz;
    work[574] = ball2_R_zz;
    const real ball2_arm_hooke0_x = ball2_child_p_x - hooke0_position_x;
    const real ball2_arm_hooke0_y = ball2_child_p_y - hooke0_position_y;
    const real ball1_base_twist_hooke0_angle1_wy = work[438];
    const real ball1_base_twist_hooke0_angle1_wz = work[439];
    const real ball2_base_twist_hooke0_angle1_vx = ball1_base_twist_hooke0_angle1_wy *
        ball2_child_p_z - ball1_base_twist_hooke0_angle1_wz * ball2_arm_hooke0_y;
    const real ball1_base_twist_hooke0_angle1_wx = work[437];
    const real ball2_base_twist_hooke0_angle1_vy = ball1_base_twist_hooke0_angle1_wz *
        ball2_arm_hooke0_x - ball1_base_twist_hooke0_angle1_wx * ball2_child_p_z;
    const real ball2_base_twist_hooke0_angle1_vz = ball1_base_twist_hooke0_angle1_wx *
        ball2_arm_hooke0_y - ball1_base_twist_hooke0_angle1_wy * ball2_arm_hooke0_x;
    const real hooke0_angle1_cos = work[390];
    const real hooke0_angle1_sin = work[391];
    const real ball2_base_twist_hooke0_angle2_vx = hooke0_angle1_cos * ball2_child_p_z
        - hooke0_angle1_sin * ball2_arm_hooke0_y;
    const real ball2_base_twist_hooke0_angle2_vy = hooke0_angle1_sin * ball2_arm_hooke0_x;
    const real ball2_minus_base_twist_hooke0_angle2_vz = hooke0_angle1_cos * ball2_arm_hooke0_x;
    const real ball2_arm_ball0_x = ball2_child_p_x - ball1_platform_p_x;
    const real ball2_arm_ball0_y = ball2_child_p_y - ball1_platform_p_y;
    const real ball2_arm_ball0_z = ball2_child_p_z - ball1_platform_p_z;
    const real ball2_base_twist_ball0_x_vx = ball1_platform_R_yx * ball2_arm_ball0_z
        - ball1_platform_R_zx * ball2_arm_ball0_y;
    const real ball2_base_twist_ball0_x_vy = ball1_platform_R_zx * ball2_arm_ball0_x
        - ball1_platform_R_xx * ball2_arm_ball0_z;
    const real ball2_base_twist_ball0_x_vz = ball1_platform_R_xx * ball2_arm_ball0_y
        - ball1_platform_R_yx * ball2_arm_ball0_x;
    const real ball2_base_twist_ball0_y_vx = ball1_platform_R_yy * ball2_arm_ball0_z
        - ball1_platform_R_zy * ball2_arm_ball0_y;
    const real ball2_base_twist_ball0_y_vy = ball1_platform_R_zy * ball2_arm_ball0_x
        - ball1_platform_R_xy * ball2_arm_ball0_z;
    const real ball2_base_twist_ball0_y_vz = ball1_platform_R_xy * ball2_arm_ball0_y
        - ball1_platform_R_yy * ball2_arm_ball0_x;
    const real ball2_base_twist_ball0_z_vx = ball1_platform_R_yz * ball2_arm_ball0_z
        - ball1_platform_R_zz * ball2_arm_ball0_y;
    const real ball2_base_twist_ball0_z_vy = ball1_platform_R_zz * ball2_arm_ball0_x
        - ball1_platform_R_xz * ball2_arm_ball0_z;
    const real ball2_base_twist_ball0_z_vz = ball1_platform_R_xz * ball2_arm_ball0_y
        - ball1_platform_R_yz * ball2_arm_ball0_x;
    const real ball1_base_twist_by_slide0_vx = work[440];
    const real ball1_base_twist_by_hooke0_wy = work[532];
    const real ball1_base_twist_by_hooke0_wz = work[533];
    const real ball1_base_twist_by_ball0_wy = work[444];
    const real ball1_base_twist_by_ball0_wz = work[445];
    const real ball2_base_twist_vx_part = ball1_base_twist_by_hooke0_wy * ball2_child_p_z
        - ball1_base_twist_by_hooke0_wz * ball2_arm_hooke0_y + ball1_base_twist_by_slide0_vx
        + (ball1_base_twist_by_ball0_wy * ball2_arm_ball0_z
        - ball1_base_twist_by_ball0_wz * ball2_arm_ball0_y);
    const real ball1_base_twist_by_hooke0_wx = work[531];
    const real ball1_minus_base_twist_by_slide0_vy = work[441];
    const real ball1_base_twist_by_ball0_wx = work[443];
    const real ball2_base_twist_vy_part = ball1_base_twist_by_hooke0_wz * ball2_arm_hooke0_x
        - ball1_base_twist_by_hooke0_wx * ball2_child_p_z - ball1_minus_base_twist_by_slide0_vy
        + (ball1_base_twist_by_ball0_wz * ball2_arm_ball0_x
        - ball1_base_twist_by_ball0_wx * ball2_arm_ball0_z);
    const real ball1_base_twist_by_slide0_vz = work[442];
    const real ball2_base_twist_vz_part = ball1_base_twist_by_hooke0_wx * ball2_arm_hooke0_y
        - ball1_base_twist_by_hooke0_wy * ball2_arm_hooke0_x + ball1_base_twist_by_slide0_vz
        + (ball1_base_twist_by_ball0_wx * ball2_arm_ball0_y
        - ball1_base_twist_by_ball0_wy * ball2_arm_ball0_x);
    const real ball2_arm_hooke2_x = ball2_child_p_x - hooke2_position_x;
    const real ball2_arm_hooke2_y = ball2_child_p_y - hooke2_position_y;
    const real ball2_minus_base_twist_hooke2_angle1_wx = hooke2_angle2_cos * hooke2_angle2_cos
        + hooke2_angle2_sin * hooke2_angle2_sin;
    const real ball2_minus_base_twist_hooke2_angle1_wy = hooke2_angle2_cos * hooke2_R_yx
        - hooke2_angle2_sin * hooke2_minus_R_yz;
    const real ball2_minus_base_twist_hooke2_angle1_wz = hooke2_angle2_sin * hooke2_R_zz
        - hooke2_angle2_cos * hooke2_minus_R_zx;
    const real ball2_minus_base_twist_hooke2_angle1_vx = ball2_child_p_z *
        ball2_minus_base_twist_hooke2_angle1_wy
        - ball2_arm_hooke2_y * ball2_minus_base_twist_hooke2_angle1_wz;
    const real ball2_minus_base_twist_hooke2_angle1_vy = ball2_arm_hooke2_x *
        ball2_minus_base_twist_hooke2_angle1_wz
        - ball2_child_p_z * ball2_minus_base_twist_hooke2_angle1_wx;
    const real ball2_minus_base_twist_hooke2_angle1_vz = ball2_arm_hooke2_y *
        ball2_minus_base_twist_hooke2_angle1_wx
        - ball2_arm_hooke2_x * ball2_minus_base_twist_hooke2_angle1_wy;
    const real ball2_minus_base_twist_hooke2_angle2_vx = hooke2_angle1_cos * ball2_child_p_z
        - hooke2_angle1_sin * ball2_arm_hooke2_y;
    const real ball2_minus_base_twist_hooke2_angle2_vy = hooke2_angle1_sin * ball2_arm_hooke2_x;
    const real ball2_base_twist_hooke2_angle2_vz = hooke2_angle1_cos * ball2_arm_hooke2_x;
    const real ball2_twist_hooke0_angle1_vx = ball1_platform_R_xx *
        ball2_base_twist_hooke0_angle1_vx
        + ball1_platform_R_yx * ball2_base_twist_hooke0_angle1_vy
        + ball1_platform_R_zx * ball2_base_twist_hooke0_angle1_vz;
    const real ball2_twist_hooke0_angle1_vy = ball1_platform_R_xy *
        ball2_base_twist_hooke0_angle1_vx
        + ball1_platform_R_yy * ball2_base_twist_hooke0_angle1_vy
        + ball1_platform_R_zy * ball2_base_twist_hooke0_angle1_vz;
    const real ball2_twist_hooke0_angle1_vz = ball1_platform_R_xz *
        ball2_base_twist_hooke0_angle1_vx
        + ball1_platform_R_yz * ball2_base_twist_hooke0_angle1_vy
        + ball1_platform_R_zz * ball2_base_twist_hooke0_angle1_vz;
    const real ball2_twist_hooke0_angle2_vx = ball1_platform_R_xx *
        ball2_base_twist_hooke0_angle2_vx
        + ball1_platform_R_yx * ball2_base_twist_hooke0_angle2_vy
        - ball1_platform_R_zx * ball2_minus_base_twist_hooke0_angle2_vz;
    const real ball2_twist_hooke0_angle2_vy = ball1_platform_R_xy *
        ball2_base_twist_hooke0_angle2_vx
        + ball1_platform_R_yy * ball2_base_twist_hooke0_angle2_vy
        - ball1_platform_R_zy * ball2_minus_base_twist_hooke0_angle2_vz;
    const real ball2_twist_hooke0_angle2_vz = ball1_platform_R_xz *
        ball2_base_twist_hooke0_angle2_vx
        + ball1_platform_R_yz * ball2_base_twist_hooke0_angle2_vy
        - ball1_platform_R_zz * ball2_minus_base_twist_hooke0_angle2_vz;
    const real ball2_twist_ball0_x_vx = ball1_platform_R_xx * ball2_base_twist_ball0_x_vx
        + ball1_platform_R_yx * ball2_base_twist_ball0_x_vy
        + ball1_platform_R_zx * ball2_base_twist_ball0_x_vz;
    const real ball2_twist_ball0_x_vy = ball1_platform_R_xy * ball2_base_twist_ball0_x_vx
        + ball1_platform_R_yy * ball2_base_twist_ball0_x_vy
        + ball1_platform_R_zy * ball2_base_twist_ball0_x_vz;
    const real ball2_twist_ball0_x_vz = ball1_platform_R_xz * ball2_base_twist_ball0_x_vx
        + ball1_platform_R_yz * ball2_base_twist_ball0_x_vy
        + ball1_platform_R_zz * ball2_base_twist_ball0_x_vz;
    const real ball2_twist_ball0_y_vx = ball1_platform_R_xx * ball2_base_twist_ball0_y_vx
        + ball1_platform_R_yx * ball2_base_twist_ball0_y_vy
        + ball1_platform_R_zx * ball2_base_twist_ball0_y_vz;
    const real ball2_twist_ball0_y_vy = ball1_platform_R_xy * ball2_base_twist_ball0_y_vx
        + ball1_platform_R_yy * ball2_base_twist_ball0_y_vy
        + ball1_platform_R_zy * ball2_base_twist_ball0_y_vz;
    const real ball2_twist_ball0_y_vz = ball1_platform_R_xz * ball2_base_twist_ball0_y_vx
        + ball1_platform_R_yz * ball2_base_twist_ball0_y_vy
        + ball1_platform_R_zz * ball2_base_twist_ball0_y_vz;
    const real ball2_twist_ball0_z_vx = ball1_platform_R_xx * ball2_base_twist_ball0_z_vx
        + ball1_platform_R_yx * ball2_base_twist_ball0_z_vy
        + ball1_platform_R_zx * ball2_base_twist_ball0_z_vz;
    const real ball2_twist_ball0_z_vy = ball1_platform_R_xy * ball2_base_twist_ball0_z_vx
        + ball1_platform_R_yy * ball2_base_twist_ball0_z_vy
        + ball1_platform_R_zy * ball2_base_twist_ball0_z_vz;
    const real ball2_twist_ball0_z_vz = ball1_platform_R_xz * ball2_base_twist_ball0_z_vx
        + ball1_platform_R_yz * ball2_base_twist_ball0_z_vy
        + ball1_platform_R_zz * ball2_base_twist_ball0_z_vz;
    const real ball2_minus_twist_hooke2_angle1_vx = ball1_platform_R_xx *
        ball2_minus_base_twist_hooke2_angle1_vx
        + ball1_platform_R_yx * ball2_minus_base_twist_hooke2_angle1_vy
        + ball1_platform_R_zx * ball2_minus_base_twist_hooke2_angle1_vz;
    const real ball2_minus_twist_hooke2_angle1_vy = ball1_platform_R_xy *
        ball2_minus_base_twist_hooke2_angle1_vx
        + ball1_platform_R_yy * ball2_minus_base_twist_hooke2_angle1_vy
        + ball1_platform_R_zy * ball2_minus_base_twist_hooke2_angle1_vz;
    const real ball2_minus_twist_hooke2_angle1_vz = ball1_platform_R_xz *
        ball2_minus_base_twist_hooke2_angle1_vx
        + ball1_platform_R_yz * ball2_minus_base_twist_hooke2_angle1_vy
        + ball1_platform_R_zz * ball2_minus_base_twist_hooke2_angle1_vz;
    const real ball2_twist_hooke2_angle2_vx = ball1_platform_R_zx *
        ball2_base_twist_hooke2_angle2_vz
        - (ball1_platform_R_xx * ball2_minus_base_twist_hooke2_angle2_vx
        + ball1_platform_R_yx * ball2_minus_base_twist_hooke2_angle2_vy);
    const real ball2_twist_hooke2_angle2_vy = ball1_platform_R_zy *
        ball2_base_twist_hooke2_angle2_vz
        - (ball1_platform_R_xy * ball2_minus_base_twist_hooke2_angle2_vx
        + ball1_platform_R_yy * ball2_minus_base_twist_hooke2_angle2_vy);
    const real ball2_twist_hooke2_angle2_vz = ball1_platform_R_zz *
        ball2_base_twist_hooke2_angle2_vz
        - (ball1_platform_R_xz * ball2_minus_base_twist_hooke2_angle2_vx
        + ball1_platform_R_yz * ball2_minus_base_twist_hooke2_angle2_vy);
    const real ball2_G_px_hooke0_angle1 = ball2_R_xx * ball2_twist_hooke0_angle1_vx
        + ball2_R_xy * ball2_twist_hooke0_angle1_vy + ball2_R_xz * ball2_twist_hooke0_angle1_vz;
    work[575] = ball2_G_px_hooke0_angle1;
    const real ball2_G_px_hooke0_angle2 = ball2_R_xx * ball2_twist_hooke0_angle2_vx
        + ball2_R_xy * ball2_twist_hooke0_angle2_vy + ball2_R_xz * ball2_twist_hooke0_angle2_vz;
    work[576] = ball2_G_px_hooke0_angle2;
    const real ball1_twist_slide0_vx = work[446];
    const real ball1_twist_slide0_vy = work[447];
    const real ball1_twist_slide0_vz = work[448];
    const real ball2_G_px_slide0 = ball1_twist_slide0_vx * ball2_R_xx
        + ball1_twist_slide0_vy * ball2_R_xy + ball1_twist_slide0_vz * ball2_R_xz;
    work[577] = ball2_G_px_slide0;
    const real ball2_G_px_ball0_x = ball2_R_xx * ball2_twist_ball0_x_vx
        + ball2_R_xy * ball2_twist_ball0_x_vy + ball2_R_xz * ball2_twist_ball0_x_vz;
    work[578] = ball2_G_px_ball0_x;
    const real ball2_G_px_ball0_y = ball2_R_xx * ball2_twist_ball0_y_vx
        + ball2_R_xy * ball2_twist_ball0_y_vy + ball2_R_xz * ball2_twist_ball0_y_vz;
    work[579] = ball2_G_px_ball0_y;
    const real ball2_G_px_ball0_z = ball2_R_xx * ball2_twist_ball0_z_vx
        + ball2_R_xy * ball2_twist_ball0_z_vy + ball2_R_xz * ball2_twist_ball0_z_vz;
    work[580] = ball2_G_px_ball0_z;
    const real ball2_minus_G_px_hooke2_angle1 = ball2_R_xx * ball2_minus_twist_hooke2_angle1_vx
        + ball2_R_xy * ball2_minus_twist_hooke2_angle1_vy
        + ball2_R_xz * ball2_minus_twist_hooke2_angle1_vz;
    work[581] = ball2_minus_G_px_hooke2_angle1;
    const real ball2_G_px_hooke2_angle2 = ball2_R_xx * ball2_twist_hooke2_angle2_vx
        + ball2_R_xy * ball2_twist_hooke2_angle2_vy + ball2_R_xz * ball2_twist_hooke2_angle2_vz;
    work[582] = ball2_G_px_hooke2_angle2;
    const real ball2_minus_G_px_slide2 = ball2_R_xx * ball2_R_zx + ball2_R_xy * ball2_R_zy
        + ball2_R_xz * ball2_R_zz;
    work[583] = ball2_minus_G_px_slide2;
    const real ball2_G_py_hooke0_angle1 = ball2_R_yx * ball2_twist_hooke0_angle1_vx
        + ball2_R_yy * ball2_twist_hooke0_angle1_vy + ball2_R_yz * ball2_twist_hooke0_angle1_vz;
    work[584] = ball2_G_py_hooke0_angle1;
    const real ball2_G_py_hooke0_angle2 = ball2_R_yx * ball2_twist_hooke0_angle2_vx
        + ball2_R_yy * ball2_twist_hooke0_angle2_vy + ball2_R_yz * ball2_twist_hooke0_angle2_vz;
    work[585] = ball2_G_py_hooke0_angle2;
    const real ball2_G_py_slide0 = ball1_twist_slide0_vx * ball2_R_yx
        + ball1_twist_slide0_vy * ball2_R_yy + ball1_twist_slide0_vz * ball2_R_yz;
    work[586] = ball2_G_py_slide0;
    const real ball2_G_py_ball0_x = ball2_R_yx * ball2_twist_ball0_x_vx
        + ball2_R_yy * ball2_twist_ball0_x_vy + ball2_R_yz * ball2_twist_ball0_x_vz;
    work[587] = ball2_G_py_ball0_x;
    const real ball2_G_py_ball0_y = ball2_R_yx * ball2_twist_ball0_y_vx
        + ball2_R_yy * ball2_twist_ball0_y_vy + ball2_R_yz * ball2_twist_ball0_y_vz;
    work[588] = ball2_G_py_ball0_y;
    const real ball2_G_py_ball0_z = ball2_R_yx * ball2_twist_ball0_z_vx
        + ball2_R_yy * ball2_twist_ball0_z_vy + ball2_R_yz * ball2_twist_ball0_z_vz;
    work[589] = ball2_G_py_ball0_z;
    const real ball2_minus_G_py_hooke2_angle1 = ball2_R_yx * ball2_minus_twist_hooke2_angle1_vx
        + ball2_R_yy * ball2_minus_twist_hooke2_angle1_vy
        + ball2_R_yz * ball2_minus_twist_hooke2_angle1_vz;
    work[590] = ball2_minus_G_py_hooke2_angle1;
    const real ball2_G_py_hooke2_angle2 = ball2_R_yx * ball2_twist_hooke2_angle2_vx
        + ball2_R_yy * ball2_twist_hooke2_angle2_vy + ball2_R_yz * ball2_twist_hooke2_angle2_vz;
    work[591] = ball2_G_py_hooke2_angle2;
    const real ball2_minus_G_py_slide2 = ball2_R_yx * ball2_R_zx + ball2_R_yy * ball2_R_zy
        + ball2_R_yz * ball2_R_zz;
    work[592] = ball2_minus_G_py_slide2;
    const real ball2_G_pz_hooke0_angle1 = ball2_R_zx * ball2_twist_hooke0_angle1_vx
        + ball2_R_zy * ball2_twist_hooke0_angle1_vy + ball2_R_zz * ball2_twist_hooke0_angle1_vz;
    work[593] = ball2_G_pz_hooke0_angle1;
    const real ball2_G_pz_hooke0_angle2 = ball2_R_zx * ball2_twist_hooke0_angle2_vx
        + ball2_R_zy * ball2_twist_hooke0_angle2_vy + ball2_R_zz * ball2_twist_hooke0_angle2_vz;
    work[594] = ball2_G_pz_hooke0_angle2;
    const real ball2_G_pz_slide0 = ball1_twist_slide0_vx * ball2_R_zx
        + ball1_twist_slide0_vy * ball2_R_zy + ball1_twist_slide0_vz * ball2_R_zz;
    work[595] = ball2_G_pz_slide0;
    const real ball2_G_pz_ball0_x = ball2_R_zx * ball2_twist_ball0_x_vx
        + ball2_R_zy * ball2_twist_ball0_x_vy + ball2_R_zz * ball2_twist_ball0_x_vz;
    work[596] = ball2_G_pz_ball0_x;
    const real ball2_G_pz_ball0_y = ball2_R_zx * ball2_twist_ball0_y_vx
        + ball2_R_zy * ball2_twist_ball0_y_vy + ball2_R_zz * ball2_twist_ball0_y_vz;
    work[597] = ball2_G_pz_ball0_y;
    const real ball2_G_pz_ball0_z = ball2_R_zx * ball2_twist_ball0_z_vx
        + ball2_R_zy * ball2_twist_ball0_z_vy + ball2_R_zz * ball2_twist_ball0_z_vz;
    work[598] = ball2_G_pz_ball0_z;
    const real ball2_minus_G_pz_hooke2_angle1 = ball2_R_zx * ball2_minus_twist_hooke2_angle1_vx
        + ball2_R_zy * ball2_minus_twist_hooke2_angle1_vy
        + ball2_R_zz * ball2_minus_twist_hooke2_angle1_vz;
    work[599] = ball2_minus_G_pz_hooke2_angle1;
    const real ball2_G_pz_hooke2_angle2 = ball2_R_zx * ball2_twist_hooke2_angle2_vx
        + ball2_R_zy * ball2_twist_hooke2_angle2_vy + ball2_R_zz * ball2_twist_hooke2_angle2_vz;
    work[600] = ball2_G_pz_hooke2_angle2;
    const real ball2_minus_G_pz_slide2 = ball2_R_zx * ball2_R_zx + ball2_R_zy * ball2_R_zy
        + ball2_R_zz * ball2_R_zz;
    work[601] = ball2_minus_G_pz_slide2;
    const real ball1_platform_p_x_rate = work[510];
    const real ball1_platform_R_xx_rate = work[501];
    const real ball1_platform_R_xy_rate = work[502];
    const real ball2_child_p_x_rate = ball2_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_xx_rate
        + ball2_child_position_y_minus_ball0_child_position_y * ball1_platform_R_xy_rate
        + ball1_platform_p_x_rate;
    const real ball1_platform_R_yx_rate = work[504];
    const real ball1_platform_R_yy_rate = work[505];
    const real ball1_minus_platform_p_y_rate = work[511];
    const real ball2_child_p_y_rate = ball2_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_yx_rate
        + ball2_child_position_y_minus_ball0_child_position_y * ball1_platform_R_yy_rate
        - ball1_minus_platform_p_y_rate;
    const real ball1_platform_p_z_rate = work[512];
    const real ball1_platform_R_zx_rate = work[507];
    const real ball1_platform_R_zy_rate = work[508];
    const real ball2_child_p_z_rate = ball2_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_zx_rate
        + ball2_child_position_y_minus_ball0_child_position_y * ball1_platform_R_zy_rate
        + ball1_platform_p_z_rate;
    const real hooke2_u_angle2_times_angle2_sin = work[562];
    const real hooke2_R_yx_rate = work[564];
    const real ball2_R_xx_rate_part = hooke2_angle2_cos * ball1_platform_R_xx_rate
        - ball1_platform_R_xx * hooke2_u_angle2_times_angle2_sin
        + (hooke2_R_yx * ball1_platform_R_yx_rate + ball1_platform_R_yx * hooke2_R_yx_rate);
    const real ball2_R_xy_rate_part = hooke2_angle2_cos * ball1_platform_R_xy_rate
        - ball1_platform_R_xy * hooke2_u_angle2_times_angle2_sin
        + (hooke2_R_yx * ball1_platform_R_yy_rate + ball1_platform_R_yy * hooke2_R_yx_rate);
    const real ball1_platform_R_xz_rate = work[503];
    const real ball1_platform_R_yz_rate = work[506];
    const real ball2_R_xz_rate_part = hooke2_angle2_cos * ball1_platform_R_xz_rate
        - ball1_platform_R_xz * hooke2_u_angle2_times_angle2_sin
        + (hooke2_R_yx * ball1_platform_R_yz_rate + ball1_platform_R_yz * hooke2_R_yx_rate);
    work[602] = ball2_R_xz_rate_part;
    const real hooke2_u_angle2_times_angle2_cos = work[563];
    const real hooke2_minus_R_yz_rate = work[565];
    const real ball2_R_zx_rate_part = hooke2_angle2_sin * ball1_platform_R_xx_rate
        + ball1_platform_R_xx * hooke2_u_angle2_times_angle2_cos
        - (hooke2_minus_R_yz * ball1_platform_R_yx_rate
        + ball1_platform_R_yx * hooke2_minus_R_yz_rate);
    const real ball2_R_zy_rate_part = hooke2_angle2_sin * ball1_platform_R_xy_rate
        + ball1_platform_R_xy * hooke2_u_angle2_times_angle2_cos
        - (hooke2_minus_R_yz * ball1_platform_R_yy_rate
        + ball1_platform_R_yy * hooke2_minus_R_yz_rate);
    const real ball2_R_zz_rate_part = hooke2_angle2_sin * ball1_platform_R_xz_rate
        + ball1_platform_R_xz * hooke2_u_angle2_times_angle2_cos
        - (hooke2_minus_R_yz * ball1_platform_R_yz_rate
        + ball1_platform_R_yz * hooke2_minus_R_yz_rate);
    work[603] = ball2_R_zz_rate_part;
    const real ball1_base_twist_by_hooke0_wz_rate = work[539];
    const real ball1_base_twist_by_hooke0_wx_rate = work[537];
    const real ball2_base_twist_by_hooke0_vy_rate = ball2_arm_hooke0_x *
        ball1_base_twist_by_hooke0_wz_rate + ball1_base_twist_by_hooke0_wz * ball2_child_p_x_rate
        - (ball2_child_p_z * ball1_base_twist_by_hooke0_wx_rate
        + ball1_base_twist_by_hooke0_wx * ball2_child_p_z_rate);
    const real ball1_base_twist_by_hooke0_wy_rate = work[538];
    const real ball2_base_twist_by_hooke0_vz_rate = ball2_arm_hooke0_y *
        ball1_base_twist_by_hooke0_wx_rate + ball1_base_twist_by_hooke0_wx * ball2_child_p_y_rate
        - (ball2_arm_hooke0_x * ball1_base_twist_by_hooke0_wy_rate
        + ball1_base_twist_by_hooke0_wy * ball2_child_p_x_rate);
    const real ball1_base_twist_by_slide0_vx_rate = work[519];
    const real ball2_base_twist_vx_rate_part = ball2_child_p_z * ball1_base_twist_by_hooke0_wy_rate
        + ball1_base_twist_by_hooke0_wy * ball2_child_p_z_rate
        - (ball2_arm_hooke0_y * ball1_base_twist_by_hooke0_wz_rate
        + ball1_base_twist_by_hooke0_wz * ball2_child_p_y_rate)
        + ball1_base_twist_by_slide0_vx_rate;
    const real ball2_arm_ball0_x_rate = ball2_child_p_x_rate - ball1_platform_p_x_rate;
    const real ball2_arm_ball0_y_rate = ball1_minus_platform_p_y_rate + ball2_child_p_y_rate;
    const real ball2_arm_ball0_z_rate = ball2_child_p_z_rate - ball1_platform_p_z_rate;
    const real ball1_base_twist_by_ball0_wz_rate = work[524];
    const real ball1_base_twist_by_ball0_wx_rate = work[522];
    const real ball2_base_twist_by_ball0_vy_rate = ball2_arm_ball0_x *
        ball1_base_twist_by_ball0_wz_rate + ball1_base_twist_by_ball0_wz * ball2_arm_ball0_x_rate
        - (ball2_arm_ball0_z * ball1_base_twist_by_ball0_wx_rate
        + ball1_base_twist_by_ball0_wx * ball2_arm_ball0_z_rate);
    const real ball1_base_twist_by_ball0_wy_rate = work[523];
    const real ball2_base_twist_by_ball0_vz_rate = ball2_arm_ball0_y *
        ball1_base_twist_by_ball0_wx_rate + ball1_base_twist_by_ball0_wx * ball2_arm_ball0_y_rate
        - (ball2_arm_ball0_x * ball1_base_twist_by_ball0_wy_rate
        + ball1_base_twist_by_ball0_wy * ball2_arm_ball0_x_rate);
    const real ball2_base_twist_vx_rate_part_2 = ball2_arm_ball0_z *
        ball1_base_twist_by_ball0_wy_rate + ball1_base_twist_by_ball0_wy * ball2_arm_ball0_z_rate
        - (ball2_arm_ball0_y * ball1_base_twist_by_ball0_wz_rate
        + ball1_base_twist_by_ball0_wz * ball2_arm_ball0_y_rate) + ball2_base_twist_vx_rate_part;

    /* tube2: omega, alpha, inertia, composite, a, U */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    const real slide2_q = q[12]; /* m */
    const real hooke2_u_angle1 = u[9]; /* rad/s */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const wreal half_rod2_mass = w[46];
    const wreal rod2_base_moment_z = w[47];
    const wreal tube2_base_inertia_xx = w[63];
    const wreal tube2_base_inertia_yy = w[64];
    const real tube2_omega_x = hooke2_u_angle1 * hooke2_angle2_cos;
    work[604] = tube2_omega_x;
    const real tube2_omega_z = hooke2_u_angle1 * hooke2_angle2_sin;
    work[605] = tube2_omega_z;
    const real hooke2_u_angle1_times_u_angle2 = work[558];
    const real tube2_alpha_z = hooke2_angle2_cos * hooke2_u_angle1_times_u_angle2;
    work[606] = tube2_alpha_z;
    const real tube2_inertia_shift = slide2_q * (rod2_base_moment_z
        + slide2_q * half_rod2_mass) * 2.0;
    const real tube2_composite_inertia_xx = tube2_base_inertia_xx + tube2_inertia_shift;
    work[607] = tube2_composite_inertia_xx;
    const real tube2_composite_inertia_yy = tube2_base_inertia_yy + tube2_inertia_shift;
    work[608] = tube2_composite_inertia_yy;
    const real tube2_a_x = gravity_z * hooke2_minus_R_zx;
    work[609] = tube2_a_x;
    const real tube2_minus_a_y = gravity_z * hooke2_angle1_sin;
    work[610] = tube2_minus_a_y;
    const real tube2_U_xz = tube2_omega_x * tube2_omega_z;
    work[611] = tube2_U_xz;

    /* ball2: twist, rate */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* rate = G u + g_t */
    const real hooke2_u_angle2 = u[10]; /* rad/s */
    const real slide2_u = u[11]; /* m/s */
    const real ball2_minus_base_twist_by_hooke2_wx = hooke2_angle2_cos * tube2_omega_x
        + hooke2_angle2_sin * tube2_omega_z;
    const real ball2_minus_base_twist_by_hooke2_wy = hooke2_R_yx * tube2_omega_x
        + hooke2_u_angle2 * hooke2_angle1_cos - hooke2_minus_R_yz * tube2_omega_z;
    const real ball2_minus_base_twist_by_hooke2_wz = hooke2_u_angle2 * hooke2_angle1_sin
        - hooke2_minus_R_zx * tube2_omega_x + hooke2_R_zz * tube2_omega_z;
    const real ball2_base_twist_vx = ball2_base_twist_vx_part
        - (ball2_child_p_z * ball2_minus_base_twist_by_hooke2_wy
        - ball2_arm_hooke2_y * ball2_minus_base_twist_by_hooke2_wz) - slide2_u * hooke2_angle2_sin;
    const real ball2_base_twist_vy = ball2_base_twist_vy_part
        - (ball2_arm_hooke2_x * ball2_minus_base_twist_by_hooke2_wz
        - ball2_child_p_z * ball2_minus_base_twist_by_hooke2_wx) + slide2_u * hooke2_minus_R_yz;
    const real ball2_base_twist_vz = ball2_base_twist_vz_part
        - (ball2_arm_hooke2_y * ball2_minus_base_twist_by_hooke2_wx
        - ball2_arm_hooke2_x * ball2_minus_base_twist_by_hooke2_wy) - slide2_u * hooke2_R_zz;
    const real ball2_twist_vx = ball1_platform_R_xx * ball2_base_twist_vx
        + ball1_platform_R_yx * ball2_base_twist_vy + ball1_platform_R_zx * ball2_base_twist_vz;
    const real ball2_twist_vy = ball1_platform_R_xy * ball2_base_twist_vx
        + ball1_platform_R_yy * ball2_base_twist_vy + ball1_platform_R_zy * ball2_base_twist_vz;
    const real ball2_twist_vz = ball1_platform_R_xz * ball2_base_twist_vx
        + ball1_platform_R_yz * ball2_base_twist_vy + ball1_platform_R_zz * ball2_base_twist_vz;
    work[612] = ball2_twist_vz;
    const real tube2_omega_z_rate = work[569];
    const real tube2_minus_omega_x_rate = work[568];
    const real ball2_minus_base_twist_by_hooke2_wx_rate = tube2_omega_z *
        hooke2_u_angle2_times_angle2_cos + hooke2_angle2_sin * tube2_omega_z_rate
        - (tube2_omega_x * hooke2_u_angle2_times_angle2_sin
        + hooke2_angle2_cos * tube2_minus_omega_x_rate);
    const real hooke2_u_angle1_times_angle1_sin = work[560];
    const real ball2_minus_base_twist_by_hooke2_wy_rate = tube2_omega_x * hooke2_R_yx_rate
        - hooke2_R_yx * tube2_minus_omega_x_rate
        - hooke2_u_angle2 * hooke2_u_angle1_times_angle1_sin
        - (tube2_omega_z * hooke2_minus_R_yz_rate + hooke2_minus_R_yz * tube2_omega_z_rate);
    const real hooke2_u_angle1_times_angle1_cos = work[561];
    const real hooke2_minus_R_zx_rate = work[566];
    const real hooke2_minus_R_zz_rate = work[567];
    const real ball2_minus_base_twist_by_hooke2_wz_rate = hooke2_u_angle2 *
        hooke2_u_angle1_times_angle1_cos - (tube2_omega_x * hooke2_minus_R_zx_rate
        - hooke2_minus_R_zx * tube2_minus_omega_x_rate) + (hooke2_R_zz * tube2_omega_z_rate
        - tube2_omega_z * hooke2_minus_R_zz_rate);
    const real ball2_minus_base_twist_by_hooke2_vx_rate = ball2_minus_base_twist_by_hooke2_wy *
        ball2_child_p_z_rate + ball2_child_p_z * ball2_minus_base_twist_by_hooke2_wy_rate
        - (ball2_minus_base_twist_by_hooke2_wz * ball2_child_p_y_rate
        + ball2_arm_hooke2_y * ball2_minus_base_twist_by_hooke2_wz_rate);
    const real ball2_minus_base_twist_by_hooke2_vy_rate = ball2_minus_base_twist_by_hooke2_wz *
        ball2_child_p_x_rate + ball2_arm_hooke2_x * ball2_minus_base_twist_by_hooke2_wz_rate
        - (ball2_minus_base_twist_by_hooke2_wx * ball2_child_p_z_rate
        + ball2_child_p_z * ball2_minus_base_twist_by_hooke2_wx_rate);
    const real ball2_minus_base_twist_by_hooke2_vz_rate = ball2_minus_base_twist_by_hooke2_wx *
        ball2_child_p_y_rate + ball2_arm_hooke2_y * ball2_minus_base_twist_by_hooke2_wx_rate
        - (ball2_minus_base_twist_by_hooke2_wy * ball2_child_p_x_rate
        + ball2_arm_hooke2_x * ball2_minus_base_twist_by_hooke2_wy_rate);
    const real ball2_base_twist_vx_rate = ball2_base_twist_vx_rate_part_2
        - ball2_minus_base_twist_by_hooke2_vx_rate - slide2_u * hooke2_u_angle2_times_angle2_cos;
    const real ball1_minus_base_twist_by_slide0_vy_rate = work[520];
    const real ball2_base_twist_vy_rate = ball2_base_twist_by_hooke0_vy_rate
        - ball1_minus_base_twist_by_slide0_vy_rate + ball2_base_twist_by_ball0_vy_rate
        - ball2_minus_base_twist_by_hooke2_vy_rate + slide2_u * hooke2_minus_R_yz_rate;
    const real ball1_minus_base_twist_by_slide0_vz_rate = work[521];
    const real ball2_base_twist_vz_rate = ball2_base_twist_by_hooke0_vz_rate
        - ball1_minus_base_twist_by_slide0_vz_rate + ball2_base_twist_by_ball0_vz_rate
        - ball2_minus_base_twist_by_hooke2_vz_rate + slide2_u * hooke2_minus_R_zz_rate;
    const real ball2_twist_vx_rate_part = ball2_base_twist_vx * ball1_platform_R_xx_rate
        + ball1_platform_R_xx * ball2_base_twist_vx_rate
        + (ball2_base_twist_vy * ball1_platform_R_yx_rate
        + ball1_platform_R_yx * ball2_base_twist_vy_rate);
    const real ball2_twist_vx_rate = ball2_base_twist_vz * ball1_platform_R_zx_rate
        + ball1_platform_R_zx * ball2_base_twist_vz_rate + ball2_twist_vx_rate_part;
    work[613] = ball2_twist_vx_rate;
    const real ball2_twist_vy_rate_part = ball2_base_twist_vx * ball1_platform_R_xy_rate
        + ball1_platform_R_xy * ball2_base_twist_vx_rate
        + (ball2_base_twist_vy * ball1_platform_R_yy_rate
        + ball1_platform_R_yy * ball2_base_twist_vy_rate);
    const real ball2_twist_vy_rate = ball2_base_twist_vz * ball1_platform_R_zy_rate
        + ball1_platform_R_zy * ball2_base_twist_vz_rate + ball2_twist_vy_rate_part;
    work[614] = ball2_twist_vy_rate;
    const real ball2_twist_vz_rate_part = ball2_base_twist_vx * ball1_platform_R_xz_rate
        + ball1_platform_R_xz * ball2_base_twist_vx_rate
        + (ball2_base_twist_vy * ball1_platform_R_yz_rate
        + ball1_platform_R_yz * ball2_base_twist_vy_rate);
    const real ball1_platform_R_zz_rate = work[509];
    const real ball2_twist_vz_rate = ball2_base_twist_vz * ball1_platform_R_zz_rate
        + ball1_platform_R_zz * ball2_base_twist_vz_rate + ball2_twist_vz_rate_part;
    work[615] = ball2_twist_vz_rate;
    const real ball2_twist_vx_times_R_xx_rate_plus_R_xx_times_twist_vx_rate = ball2_twist_vx *
        (ball2_R_xx_rate_part - (hooke2_minus_R_zx * ball1_platform_R_zx_rate
        + ball1_platform_R_zx * hooke2_minus_R_zx_rate)) + ball2_R_xx * ball2_twist_vx_rate;
    const real ball2_rate_px_rate_part = ball2_twist_vy * (ball2_R_xy_rate_part
        - (hooke2_minus_R_zx * ball1_platform_R_zy_rate
        + ball1_platform_R_zy * hooke2_minus_R_zx_rate)) + ball2_R_xy * ball2_twist_vy_rate
        + ball2_twist_vx_times_R_xx_rate_plus_R_xx_times_twist_vx_rate;
    work[616] = ball2_rate_px_rate_part;
    const real ball2_twist_vx_times_R_yx_rate = ball2_twist_vx * (hooke2_angle1_cos *
        ball1_platform_R_yx_rate - ball1_platform_R_yx * hooke2_u_angle1_times_angle1_sin
        + (hooke2_angle1_sin * ball1_platform_R_zx_rate
        + ball1_platform_R_zx * hooke2_u_angle1_times_angle1_cos));
    work[617] = ball2_twist_vx_times_R_yx_rate;
    const real ball2_twist_vy_times_R_yy_rate = ball2_twist_vy * (hooke2_angle1_cos *
        ball1_platform_R_yy_rate - ball1_platform_R_yy * hooke2_u_angle1_times_angle1_sin
        + (hooke2_angle1_sin * ball1_platform_R_zy_rate
        + ball1_platform_R_zy * hooke2_u_angle1_times_angle1_cos));
    work[618] = ball2_twist_vy_times_R_yy_rate;
    const real ball2_twist_vz_times_R_yz_rate = ball2_twist_vz * (hooke2_angle1_cos *
        ball1_platform_R_yz_rate - ball1_platform_R_yz * hooke2_u_angle1_times_angle1_sin
        + (hooke2_angle1_sin * ball1_platform_R_zz_rate
        + ball1_platform_R_zz * hooke2_u_angle1_times_angle1_cos));
    work[619] = ball2_twist_vz_times_R_yz_rate;
    const real ball2_twist_vx_times_R_zx_rate_plus_R_zx_times_twist_vx_rate = ball2_twist_vx *
        (hooke2_R_zz * ball1_platform_R_zx_rate - ball1_platform_R_zx * hooke2_minus_R_zz_rate
        + ball2_R_zx_rate_part) + ball2_R_zx * ball2_twist_vx_rate;
    const real ball2_rate_pz_rate_part = ball2_twist_vy * (hooke2_R_zz * ball1_platform_R_zy_rate
        - ball1_platform_R_zy * hooke2_minus_R_zz_rate + ball2_R_zy_rate_part)
        + ball2_R_zy * ball2_twist_vy_rate
        + ball2_twist_vx_times_R_zx_rate_plus_R_zx_times_twist_vx_rate;
    work[620] = ball2_rate_pz_rate_part;

    /* hooke3: R, drift, velocity */
    /* R = R_fixed R_joint(q) */
    /* drift = S' u + [0; omega x v] */
    /* velocity = S u */
    const real hooke3_u_angle1 = u[12]; /* rad/s */
    const real hooke3_u_angle2 = u[13]; /* rad/s */
    const real hooke3_angle1_sin = work[403];
    const real hooke3_angle2_sin = work[405];
    const real hooke3_R_yx = hooke3_angle1_sin * hooke3_angle2_sin;
    const real hooke3_angle2_cos = work[404];
    const real hooke3_minus_R_yz = hooke3_angle1_sin * hooke3_angle2_cos;
    const real hooke3_angle1_cos = work[402];
    const real hooke3_minus_R_zx = hooke3_angle1_cos * hooke3_angle2_sin;
    work[621] = hooke3_minus_R_zx;
    const real hooke3_R_zz = hooke3_angle1_cos * hooke3_angle2_cos;
    work[622] = hooke3_R_zz;
    const real hooke3_u_angle1_times_u_angle2 = hooke3_u_angle1 * hooke3_u_angle2;
    const real hooke3_minus_drift_relative_wx = hooke3_angle2_sin * hooke3_u_angle1_times_u_angle2;
    work[623] = hooke3_minus_drift_relative_wx;
    const real hooke3_u_angle1_times_angle1_sin = hooke3_u_angle1 * hooke3_angle1_sin;
    const real hooke3_u_angle1_times_angle1_cos = hooke3_u_angle1 * hooke3_angle1_cos;
    const real hooke3_u_angle2_times_angle2_sin = hooke3_u_angle2 * hooke3_angle2_sin;
    const real hooke3_u_angle2_times_angle2_cos = hooke3_u_angle2 * hooke3_angle2_cos;
    const real hooke3_R_yx_rate = hooke3_angle2_sin * hooke3_u_angle1_times_angle1_cos
        + hooke3_angle1_sin * hooke3_u_angle2_times_angle2_cos;
    const real hooke3_minus_R_yz_rate = hooke3_angle2_cos * hooke3_u_angle1_times_angle1_cos
        - hooke3_angle1_sin * hooke3_u_angle2_times_angle2_sin;
    const real hooke3_minus_R_zx_rate = hooke3_angle1_cos * hooke3_u_angle2_times_angle2_cos
        - hooke3_angle2_sin * hooke3_u_angle1_times_angle1_sin;
    work[624] = hooke3_minus_R_zx_rate;
    const real hooke3_minus_R_zz_rate = hooke3_angle2_cos * hooke3_u_angle1_times_angle1_sin
        + hooke3_angle1_cos * hooke3_u_angle2_times_angle2_sin;
    work[625] = hooke3_minus_R_zz_rate;
    const real tube3_minus_omega_x_rate = hooke3_u_angle1 * hooke3_u_angle2_times_angle2_sin;
    const real tube3_omega_z_rate = hooke3_u_angle1 * hooke3_u_angle2_times_angle2_cos;

    /* ball3: pose, twist, G */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* G = d(rate) / du */
    const wreal hooke3_position_x = w[22]; /* m */
    const wreal hooke3_position_y = w[23]; /* m */
    const wreal ball3_child_position_x_minus_ball0_child_position_x = w[38];
    const wreal ball3_child_position_y_minus_ball0_child_position_y = w[39];
    const real ball3_child_p_x = ball3_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_xx
        + ball3_child_position_y_minus_ball0_child_position_y * ball1_platform_R_xy
        + ball1_platform_p_x;
    const real ball3_child_p_y = ball3_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_yx
        + ball3_child_position_y_minus_ball0_child_position_y * ball1_platform_R_yy
        + ball1_platform_p_y;
    const real ball3_child_p_z = ball3_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_zx
        + ball3_child_position_y_minus_ball0_child_position_y * ball1_platform_R_zy
        + ball1_platform_p_z;
    const real ball3_R_xx = ball1_platform_R_xx * hooke3_angle2_cos
        + ball1_platform_R_yx * hooke3_R_yx - ball1_platform_R_zx * hooke3_minus_R_zx;
    const real ball3_R_xy = ball1_platform_R_xy * hooke3_angle2_cos
        + ball1_platform_R_yy * hooke3_R_yx - ball1_platform_R_zy * hooke3_minus_R_zx;
    const real ball3_R_xz = ball1_platform_R_xz * hooke3_angle2_cos
        + ball1_platform_R_yz * hooke3_R_yx - ball1_platform_R_zz * hooke3_minus_R_zx;
    work[626] = ball3_R_xz;
    const real ball3_R_yx = ball1_platform_R_yx * hooke3_angle1_cos
        + ball1_platform_R_zx * hooke3_angle1_sin;
    work[627] = ball3_R_yx;
    const real ball3_R_yy = ball1_platform_R_yy * hooke3_angle1_cos
        + ball1_platform_R_zy * hooke3_angle1_sin;
    work[628] = ball3_R_yy;
    const real ball3_R_yz = ball1_platform_R_yz * hooke3_angle1_cos
        + ball1_platform_R_zz * hooke3_angle1_sin;
    work[629] = ball3_R_yz;
    const real ball3_R_zx = ball1_platform_R_xx * hooke3_angle2_sin
        - ball1_platform_R_yx * hooke3_minus_R_yz + ball1_platform_R_zx * hooke3_R_zz;
    const real ball3_R_zy = ball1_platform_R_xy * hooke3_angle2_sin
        - ball1_platform_R_yy * hooke3_minus_R_yz + ball1_platform_R_zy * hooke3_R_zz;
    const real ball3_R_zz = ball1_platform_R_xz * hooke3_angle2_sin
        - ball1_platform_R_yz * hooke3_minus_R_yz + ball1_platform_R_zz * hooke3_R_zz;
    work[630] = ball3_R_zz;
    const real ball3_arm_hooke0_x = ball3_child_p_x - hooke0_position_x;
    const real ball3_arm_hooke0_y = ball3_child_p_y - hooke0_position_y;
    const real ball3_base_twist_hooke0_angle1_vx = ball1_base_twist_hooke0_angle1_wy *
        ball3_child_p_z - ball1_base_twist_hooke0_angle1_wz * ball3_arm_hooke0_y;
    const real ball3_base_twist_hooke0_angle1_vy = ball1_base_twist_hooke0_angle1_wz *
        ball3_arm_hooke0_x - ball1_base_twist_hooke0_angle1_wx * ball3_child_p_z;
    const real ball3_base_twist_hooke0_angle1_vz = ball1_base_twist_hooke0_angle1_wx *
        ball3_arm_hooke0_y - ball1_base_twist_hooke0_angle1_wy * ball3_arm_hooke0_x;
    const real ball3_base_twist_hooke0_angle2_vx = hooke0_angle1_cos * ball3_child_p_z
        - hooke0_angle1_sin * ball3_arm_hooke0_y;
    const real ball3_base_twist_hooke0_angle2_vy = hooke0_angle1_sin * ball3_arm_hooke0_x;
    const real ball3_minus_base_twist_hooke0_angle2_vz = hooke0_angle1_cos * ball3_arm_hooke0_x;
    const real ball3_arm_ball0_x = ball3_child_p_x - ball1_platform_p_x;
    const real ball3_arm_ball0_y = ball3_child_p_y - ball1_platform_p_y;
    const real ball3_arm_ball0_z = ball3_child_p_z - ball1_platform_p_z;
    const real ball3_base_twist_ball0_x_vx = ball1_platform_R_yx * ball3_arm_ball0_z
        - ball1_platform_R_zx * ball3_arm_ball0_y;
    const real ball3_base_twist_ball0_x_vy = ball1_platform_R_zx * ball3_arm_ball0_x
        - ball1_platform_R_xx * ball3_arm_ball0_z;
    const real ball3_base_twist_ball0_x_vz = ball1_platform_R_xx * ball3_arm_ball0_y
        - ball1_platform_R_yx * ball3_arm_ball0_x;
    const real ball3_base_twist_ball0_y_vx = ball1_platform_R_yy * ball3_arm_ball0_z
        - ball1_platform_R_zy * ball3_arm_ball0_y;
    const real ball3_base_twist_ball0_y_vy = ball1_platform_R_zy * ball3_arm_ball0_x
        - ball1_platform_R_xy * ball3_arm_ball0_z;
    const real ball3_base_twist_ball0_y_vz = ball1_platform_R_xy * ball3_arm_ball0_y
        - ball1_platform_R_yy * ball3_arm_ball0_x;
    const real ball3_base_twist_ball0_z_vx = ball1_platform_R_yz * ball3_arm_ball0_z
        - ball1_platform_R_zz * ball3_arm_ball0_y;
    const real ball3_base_twist_ball0_z_vy = ball1_platform_R_zz * ball3_arm_ball0_x
        - ball1_platform_R_xz * ball3_arm_ball0_z;
    const real ball3_base_twist_ball0_z_vz = ball1_platform_R_xz * ball3_arm_ball0_y
        - ball1_platform_R_yz * ball3_arm_ball0_x;
    const real ball3_base_twist_vx_part = ball1_base_twist_by_hooke0_wy * ball3_child_p_z
        - ball1_base_twist_by_hooke0_wz * ball3_arm_hooke0_y + ball1_base_twist_by_slide0_vx
        + (ball1_base_twist_by_ball0_wy * ball3_arm_ball0_z
        - ball1_base_twist_by_ball0_wz * ball3_arm_ball0_y);
    const real ball3_base_twist_vy_part = ball1_base_twist_by_hooke0_wz * ball3_arm_hooke0_x
        - ball1_base_twist_by_hooke0_wx * ball3_child_p_z - ball1_minus_base_twist_by_slide0_vy
        + (ball1_base_twist_by_ball0_wz * ball3_arm_ball0_x
        - ball1_base_twist_by_ball0_wx * ball3_arm_ball0_z);
    const real ball3_base_twist_vz_part = ball1_base_twist_by_hooke0_wx * ball3_arm_hooke0_y
        - ball1_base_twist_by_hooke0_wy * ball3_arm_hooke0_x + ball1_base_twist_by_slide0_vz
        + (ball1_base_twist_by_ball0_wx * ball3_arm_ball0_y
        - ball1_base_twist_by_ball0_wy * ball3_arm_ball0_x);
    const real ball3_arm_hooke3_x = ball3_child_p_x - hooke3_position_x;
    const real ball3_arm_hooke3_y = ball3_child_p_y - hooke3_position_y;
    const real ball3_minus_base_twist_hooke3_angle1_wx = hooke3_angle2_cos * hooke3_angle2_cos
        + hooke3_angle2_sin * hooke3_angle2_sin;
    const real ball3_minus_base_twist_hooke3_angle1_wy = hooke3_angle2_cos * hooke3_R_yx
        - hooke3_angle2_sin * hooke3_minus_R_yz;
    const real ball3_minus_base_twist_hooke3_angle1_wz = hooke3_angle2_sin * hooke3_R_zz
        - hooke3_angle2_cos * hooke3_minus_R_zx;
    const real ball3_minus_base_twist_hooke3_angle1_vx = ball3_child_p_z *
        ball3_minus_base_twist_hooke3_angle1_wy
        - ball3_arm_hooke3_y * ball3_minus_base_twist_hooke3_angle1_wz;
    const real ball3_minus_base_twist_hooke3_angle1_vy = ball3_arm_hooke3_x *
        ball3_minus_base_twist_hooke3_angle1_wz
        - ball3_child_p_z * ball3_minus_base_twist_hooke3_angle1_wx;
    const real ball3_minus_base_twist_hooke3_angle1_vz = ball3_arm_hooke3_y *
        ball3_minus_base_twist_hooke3_angle1_wx
        - ball3_arm_hooke3_x * ball3_minus_base_twist_hooke3_angle1_wy;
    const real ball3_minus_base_twist_hooke3_angle2_vx = hooke3_angle1_cos * ball3_child_p_z
        - hooke3_angle1_sin * ball3_arm_hooke3_y;
    const real ball3_minus_base_twist_hooke3_angle2_vy = hooke3_angle1_sin * ball3_arm_hooke3_x;
    const real ball3_base_twist_hooke3_angle2_vz = hooke3_angle1_cos * ball3_arm_hooke3_x;
    const real ball3_twist_hooke0_angle1_vx = ball1_platform_R_xx *
        ball3_base_twist_hooke0_angle1_vx
        + ball1_platform_R_yx * ball3_base_twist_hooke0_angle1_vy
        + ball1_platform_R_zx * ball3_base_twist_hooke0_angle1_vz;
    const real ball3_twist_hooke0_angle1_vy = ball1_platform_R_xy *
        ball3_base_twist_hooke0_angle1_vx
        + ball1_platform_R_yy * ball3_base_twist_hooke0_angle1_vy
        + ball1_platform_R_zy * ball3_base_twist_hooke0_angle1_vz;
    const real ball3_twist_hooke0_angle1_vz = ball1_platform_R_xz *
        ball3_base_twist_hooke0_angle1_vx
        + ball1_platform_R_yz * ball3_base_twist_hooke0_angle1_vy
        + ball1_platform_R_zz * ball3_base_twist_hooke0_angle1_vz;
    const real ball3_twist_hooke0_angle2_vx = ball1_platform_R_xx *
        ball3_base_twist_hooke0_angle2_vx
        + ball1_platform_R_yx * ball3_base_twist_hooke0_angle2_vy
        - ball1_platform_R_zx * ball3_minus_base_twist_hooke0_angle2_vz;
    const real ball3_twist_hooke0_angle2_vy = ball1_platform_R_xy *
        ball3_base_twist_hooke0_angle2_vx
        + ball1_platform_R_yy * ball3_base_twist_hooke0_angle2_vy
        - ball1_platform_R_zy * ball3_minus_base_twist_hooke0_angle2_vz;
    const real ball3_twist_hooke0_angle2_vz = ball1_platform_R_xz *
        ball3_base_twist_hooke0_angle2_vx
        + ball1_platform_R_yz * ball3_base_twist_hooke0_angle2_vy
        - ball1_platform_R_zz * ball3_minus_base_twist_hooke0_angle2_vz;
    const real ball3_twist_ball0_x_vx = ball1_platform_R_xx * ball3_base_twist_ball0_x_vx
        + ball1_platform_R_yx * ball3_base_twist_ball0_x_vy
        + ball1_platform_R_zx * ball3_base_twist_ball0_x_vz;
    const real ball3_twist_ball0_x_vy = ball1_platform_R_xy * ball3_base_twist_ball0_x_vx
        + ball1_platform_R_yy * ball3_base_twist_ball0_x_vy
        + ball1_platform_R_zy * ball3_base_twist_ball0_x_vz;
    const real ball3_twist_ball0_x_vz = ball1_platform_R_xz * ball3_base_twist_ball0_x_vx
        + ball1_platform_R_yz * ball3_base_twist_ball0_x_vy
        + ball1_platform_R_zz * ball3_base_twist_ball0_x_vz;
    const real ball3_twist_ball0_y_vx = ball1_platform_R_xx * ball3_base_twist_ball0_y_vx
        + ball1_platform_R_yx * ball3_base_twist_ball0_y_vy
        + ball1_platform_R_zx * ball3_base_twist_ball0_y_vz;
    const real ball3_twist_ball0_y_vy = ball1_platform_R_xy * ball3_base_twist_ball0_y_vx
        + ball1_platform_R_yy * ball3_base_twist_ball0_y_vy
        + ball1_platform_R_zy * ball3_base_twist_ball0_y_vz;
    const real ball3_twist_ball0_y_vz = ball1_platform_R_xz * ball3_base_twist_ball0_y_vx
        + ball1_platform_R_yz * ball3_base_twist_ball0_y_vy
        + ball1_platform_R_zz * ball3_base_twist_ball0_y_vz;
    const real ball3_twist_ball0_z_vx = ball1_platform_R_xx * ball3_base_twist_ball0_z_vx
        + ball1_platform_R_yx * ball3_base_twist_ball0_z_vy
        + ball1_platform_R_zx * ball3_base_twist_ball0_z_vz;
    const real ball3_twist_ball0_z_vy = ball1_platform_R_xy * ball3_base_twist_ball0_z_vx
        + ball1_platform_R_yy * ball3_base_twist_ball0_z_vy
        + ball1_platform_R_zy * ball3_base_twist_ball0_z_vz;
    const real ball3_twist_ball0_z_vz = ball1_platform_R_xz * ball3_base_twist_ball0_z_vx
        + ball1_platform_R_yz * ball3_base_twist_ball0_z_vy
        + ball1_platform_R_zz * ball3_base_twist_ball0_z_vz;
    const real ball3_minus_twist_hooke3_angle1_vx = ball1_platform_R_xx *
        ball3_minus_base_twist_hooke3_angle1_vx
        + ball1_platform_R_yx * ball3_minus_base_twist_hooke3_angle1_vy
        + ball1_platform_R_zx * ball3_minus_base_twist_hooke3_angle1_vz;
    const real ball3_minus_twist_hooke3_angle1_vy = ball1_platform_R_xy *
        ball3_minus_base_twist_hooke3_angle1_vx
        + ball1_platform_R_yy * ball3_minus_base_twist_hooke3_angle1_vy
        + ball1_platform_R_zy * ball3_minus_base_twist_hooke3_angle1_vz;
    const real ball3_minus_twist_hooke3_angle1_vz = ball1_platform_R_xz *
        ball3_minus_base_twist_hooke3_angle1_vx
        + ball1_platform_R_yz * ball3_minus_base_twist_hooke3_angle1_vy
        + ball1_platform_R_zz * ball3_minus_base_twist_hooke3_angle1_vz;
    const real ball3_twist_hooke3_angle2_vx = ball1_platform_R_zx *
        ball3_base_twist_hooke3_angle2_vz
        - (ball1_platform_R_xx * ball3_minus_base_twist_hooke3_angle2_vx
        + ball1_platform_R_yx * ball3_minus_base_twist_hooke3_angle2_vy);
    const real ball3_twist_hooke3_angle2_vy = ball1_platform_R_zy *
        ball3_base_twist_hooke3_angle2_vz
        - (ball1_platform_R_xy * ball3_minus_base_twist_hooke3_angle2_vx
        + ball1_platform_R_yy * ball3_minus_base_twist_hooke3_angle2_vy);
    const real ball3_twist_hooke3_angle2_vz = ball1_platform_R_zz *
        ball3_base_twist_hooke3_angle2_vz
        - (ball1_platform_R_xz * ball3_minus_base_twist_hooke3_angle2_vx
        + ball1_platform_R_yz * ball3_minus_base_twist_hooke3_angle2_vy);
    const real ball3_G_px_hooke0_angle1 = ball3_R_xx * ball3_twist_hooke0_angle1_vx
        + ball3_R_xy * ball3_twist_hooke0_angle1_vy + ball3_R_xz * ball3_twist_hooke0_angle1_vz;
    work[631] = ball3_G_px_hooke0_angle1;
    const real ball3_G_px_hooke0_angle2 = ball3_R_xx * ball3_twist_hooke0_angle2_vx
        + ball3_R_xy * ball3_twist_hooke0_angle2_vy + ball3_R_xz * ball3_twist_hooke0_angle2_vz;
    work[632] = ball3_G_px_hooke0_angle2;
    const real ball3_G_px_slide0 = ball1_twist_slide0_vx * ball3_R_xx
        + ball1_twist_slide0_vy * ball3_R_xy + ball1_twist_slide0_vz * ball3_R_xz;
    work[633] = ball3_G_px_slide0;
    const real ball3_G_px_ball0_x = ball3_R_xx * ball3_twist_ball0_x_vx
        + ball3_R_xy * ball3_twist_ball0_x_vy + ball3_R_xz * ball3_twist_ball0_x_vz;
    work[634] = ball3_G_px_ball0_x;
    const real ball3_G_px_ball0_y = ball3_R_xx * ball3_twist_ball0_y_vx
        + ball3_R_xy * ball3_twist_ball0_y_vy + ball3_R_xz * ball3_twist_ball0_y_vz;
    work[635] = ball3_G_px_ball0_y;
    const real ball3_G_px_ball0_z = ball3_R_xx * ball3_twist_ball0_z_vx
        + ball3_R_xy * ball3_twist_ball0_z_vy + ball3_R_xz * ball3_twist_ball0_z_vz;
    work[636] = ball3_G_px_ball0_z;
    const real ball3_minus_G_px_hooke3_angle1 = ball3_R_xx * ball3_minus_twist_hooke3_angle1_vx
        + ball3_R_xy * ball3_minus_twist_hooke3_angle1_vy
        + ball3_R_xz * ball3_minus_twist_hooke3_angle1_vz;
    work[637] = ball3_minus_G_px_hooke3_angle1;
    const real ball3_G_px_hooke3_angle2 = ball3_R_xx * ball3_twist_hooke3_angle2_vx
        + ball3_R_xy * ball3_twist_hooke3_angle2_vy + ball3_R_xz * ball3_twist_hooke3_angle2_vz;
    work[638] = ball3_G_px_hooke3_angle2;
    const real ball3_minus_G_px_slide3 = ball3_R_xx * ball3_R_zx + ball3_R_xy * ball3_R_zy
        + ball3_R_xz * ball3_R_zz;
    work[639] = ball3_minus_G_px_slide3;
    const real ball3_G_py_hooke0_angle1 = ball3_R_yx * ball3_twist_hooke0_angle1_vx
        + ball3_R_yy * ball3_twist_hooke0_angle1_vy + ball3_R_yz * ball3_twist_hooke0_angle1_vz;
    work[640] = ball3_G_py_hooke0_angle1;
    const real ball3_G_py_hooke0_angle2 = ball3_R_yx * ball3_twist_hooke0_angle2_vx
        + ball3_R_yy * ball3_twist_hooke0_angle2_vy + ball3_R_yz * ball3_twist_hooke0_angle2_vz;
    work[641] = ball3_G_py_hooke0_angle2;
    const real ball3_G_py_slide0 = ball1_twist_slide0_vx * ball3_R_yx
        + ball1_twist_slide0_vy * ball3_R_yy + ball1_twist_slide0_vz * ball3_R_yz;
    work[642] = ball3_G_py_slide0;
    const real ball3_G_py_ball0_x = ball3_R_yx * ball3_twist_ball0_x_vx
        + ball3_R_yy * ball3_twist_ball0_x_vy + ball3_R_yz * ball3_twist_ball0_x_vz;
    work[643] = ball3_G_py_ball0_x;
    const real ball3_G_py_ball0_y = ball3_R_yx * ball3_twist_ball0_y_vx
        + ball3_R_yy * ball3_twist_ball0_y_vy + ball3_R_yz * ball3_twist_ball0_y_vz;
    work[644] = ball3_G_py_ball0_y;
    const real ball3_G_py_ball0_z = ball3_R_yx * ball3_twist_ball0_z_vx
        + ball3_R_yy * ball3_twist_ball0_z_vy + ball3_R_yz * ball3_twist_ball0_z_vz;
    work[645] = ball3_G_py_ball0_z;
    const real ball3_minus_G_py_hooke3_angle1 = ball3_R_yx * ball3_minus_twist_hooke3_angle1_vx
        + ball3_R_yy * ball3_minus_twist_hooke3_angle1_vy
        + ball3_R_yz * ball3_minus_twist_hooke3_angle1_vz;
    work[646] = ball3_minus_G_py_hooke3_angle1;
    const real ball3_G_py_hooke3_angle2 = ball3_R_yx * ball3_twist_hooke3_angle2_vx
        + ball3_R_yy * ball3_twist_hooke3_angle2_vy + ball3_R_yz * ball3_twist_hooke3_angle2_vz;
    work[647] = ball3_G_py_hooke3_angle2;
    const real ball3_minus_G_py_slide3 = ball3_R_yx * ball3_R_zx + ball3_R_yy * ball3_R_zy
        + ball3_R_yz * ball3_R_zz;
    work[648] = ball3_minus_G_py_slide3;
    const real ball3_G_pz_hooke0_angle1 = ball3_R_zx * ball3_twist_hooke0_angle1_vx
        + ball3_R_zy * ball3_twist_hooke0_angle1_vy + ball3_R_zz * ball3_twist_hooke0_angle1_vz;
    work[649] = ball3_G_pz_hooke0_angle1;
    const real ball3_G_pz_hooke0_angle2 = ball3_R_zx * ball3_twist_hooke0_angle2_vx
        + ball3_R_zy * ball3_twist_hooke0_angle2_vy + ball3_R_zz * ball3_twist_hooke0_angle2_vz;
    work[650] = ball3_G_pz_hooke0_angle2;
    const real ball3_G_pz_slide0 = ball1_twist_slide0_vx * ball3_R_zx
        + ball1_twist_slide0_vy * ball3_R_zy + ball1_twist_slide0_vz * ball3_R_zz;
    work[651] = ball3_G_pz_slide0;
    const real ball3_G_pz_ball0_x = ball3_R_zx * ball3_twist_ball0_x_vx
        + ball3_R_zy * ball3_twist_ball0_x_vy + ball3_R_zz * ball3_twist_ball0_x_vz;
    work[652] = ball3_G_pz_ball0_x;
    const real ball3_G_pz_ball0_y = ball3_R_zx * ball3_twist_ball0_y_vx
        + ball3_R_zy * ball3_twist_ball0_y_vy + ball3_R_zz * ball3_twist_ball0_y_vz;
    work[653] = ball3_G_pz_ball0_y;
    const real ball3_G_pz_ball0_z = ball3_R_zx * ball3_twist_ball0_z_vx
        + ball3_R_zy * ball3_twist_ball0_z_vy + ball3_R_zz * ball3_twist_ball0_z_vz;
    work[654] = ball3_G_pz_ball0_z;
    const real ball3_minus_G_pz_hooke3_angle1 = ball3_R_zx * ball3_minus_twist_hooke3_angle1_vx
        + ball3_R_zy * ball3_minus_twist_hooke3_angle1_vy
        + ball3_R_zz * ball3_minus_twist_hooke3_angle1_vz;
    work[655] = ball3_minus_G_pz_hooke3_angle1;
    const real ball3_G_pz_hooke3_angle2 = ball3_R_zx * ball3_twist_hooke3_angle2_vx
        + ball3_R_zy * ball3_twist_hooke3_angle2_vy + ball3_R_zz * ball3_twist_hooke3_angle2_vz;
    work[656] = ball3_G_pz_hooke3_angle2;
    const real ball3_minus_G_pz_slide3 = ball3_R_zx * ball3_R_zx + ball3_R_zy * ball3_R_zy
        + ball3_R_zz * ball3_R_zz;
    work[657] = ball3_minus_G_pz_slide3;
    const real ball3_child_p_x_rate = ball3_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_xx_rate
        + ball3_child_position_y_minus_ball0_child_position_y * ball1_platform_R_xy_rate
        + ball1_platform_p_x_rate;
    const real ball3_child_p_y_rate = ball3_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_yx_rate
        + ball3_child_position_y_minus_ball0_child_position_y * ball1_platform_R_yy_rate
        - ball1_minus_platform_p_y_rate;
    const real ball3_child_p_z_rate = ball3_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_zx_rate
        + ball3_child_position_y_minus_ball0_child_position_y * ball1_platform_R_zy_rate
        + ball1_platform_p_z_rate;
    const real ball3_R_xx_rate_part = hooke3_angle2_cos * ball1_platform_R_xx_rate
        - ball1_platform_R_xx * hooke3_u_angle2_times_angle2_sin
        + (hooke3_R_yx * ball1_platform_R_yx_rate + ball1_platform_R_yx * hooke3_R_yx_rate);
    const real ball3_R_xy_rate_part = hooke3_angle2_cos * ball1_platform_R_xy_rate
        - ball1_platform_R_xy * hooke3_u_angle2_times_angle2_sin
        + (hooke3_R_yx * ball1_platform_R_yy_rate + ball1_platform_R_yy * hooke3_R_yx_rate);
    const real ball3_R_xz_rate_part = hooke3_angle2_cos * ball1_platform_R_xz_rate
        - ball1_platform_R_xz * hooke3_u_angle2_times_angle2_sin
        + (hooke3_R_yx * ball1_platform_R_yz_rate + ball1_platform_R_yz * hooke3_R_yx_rate);
    work[658] = ball3_R_xz_rate_part;
    const real ball3_R_zx_rate_part = hooke3_angle2_sin * ball1_platform_R_xx_rate
        + ball1_platform_R_xx * hooke3_u_angle2_times_angle2_cos
        - (hooke3_minus_R_yz * ball1_platform_R_yx_rate
        + ball1_platform_R_yx * hooke3_minus_R_yz_rate);
    const real ball3_R_zy_rate_part = hooke3_angle2_sin * ball1_platform_R_xy_rate
        + ball1_platform_R_xy * hooke3_u_angle2_times_angle2_cos
        - (hooke3_minus_R_yz * ball1_platform_R_yy_rate
        + ball1_platform_R_yy * hooke3_minus_R_yz_rate);
    const real ball3_R_zz_rate_part = hooke3_angle2_sin * ball1_platform_R_xz_rate
        + ball1_platform_R_xz * hooke3_u_angle2_times_angle2_cos
        - (hooke3_minus_R_yz * ball1_platform_R_yz_rate
        + ball1_platform_R_yz * hooke3_minus_R_yz_rate);
    work[659] = ball3_R_zz_rate_part;
    const real ball3_base_twist_by_hooke0_vy_rate = ball3_arm_hooke0_x *
        ball1_base_twist_by_hooke0_wz_rate + ball1_base_twist_by_hooke0_wz * ball3_child_p_x_rate
        - (ball3_child_p_z * ball1_base_twist_by_hooke0_wx_rate
        + ball1_base_twist_by_hooke0_wx * ball3_child_p_z_rate);
    const real ball3_base_twist_by_hooke0_vz_rate = ball3_arm_hooke0_y *
        ball1_base_twist_by_hooke0_wx_rate + ball1_base_twist_by_hooke0_wx * ball3_child_p_y_rate
        - (ball3_arm_hooke0_x * ball1_base_twist_by_hooke0_wy_rate
        + ball1_base_twist_by_hooke0_wy * ball3_child_p_x_rate);
    const real ball3_base_twist_vx_rate_part = ball3_child_p_z * ball1_base_twist_by_hooke0_wy_rate
        + ball1_base_twist_by_hooke0_wy * ball3_child_p_z_rate
        - (ball3_arm_hooke0_y * ball1_base_twist_by_hooke0_wz_rate
        + ball1_base_twist_by_hooke0_wz * ball3_child_p_y_rate)
        + ball1_base_twist_by_slide0_vx_rate;
    const real ball3_arm_ball0_x_rate = ball3_child_p_x_rate - ball1_platform_p_x_rate;
    const real ball3_arm_ball0_y_rate = ball1_minus_platform_p_y_rate + ball3_child_p_y_rate;
    const real ball3_arm_ball0_z_rate = ball3_child_p_z_rate - ball1_platform_p_z_rate;
    const real ball3_base_twist_by_ball0_vy_rate = ball3_arm_ball0_x *
        ball1_base_twist_by_ball0_wz_rate + ball1_base_twist_by_ball0_wz * ball3_arm_ball0_x_rate
        - (ball3_arm_ball0_z * ball1_base_twist_by_ball0_wx_rate
        + ball1_base_twist_by_ball0_wx * ball3_arm_ball0_z_rate);
    const real ball3_base_twist_by_ball0_vz_rate = ball3_arm_ball0_y *
        ball1_base_twist_by_ball0_wx_rate + ball1_base_twist_by_ball0_wx * ball3_arm_ball0_y_rate
        - (ball3_arm_ball0_x * ball1_base_twist_by_ball0_wy_rate
        + ball1_base_twist_by_ball0_wy * ball3_arm_ball0_x_rate);
    const real ball3_base_twist_vx_rate_part_2 = ball3_arm_ball0_z *
        ball1_base_twist_by_ball0_wy_rate + ball1_base_twist_by_ball0_wy * ball3_arm_ball0_z_rate
        - (ball3_arm_ball0_y * ball1_base_twist_by_ball0_wz_rate
        + ball1_base_twist_by_ball0_wz * ball3_arm_ball0_y_rate) + ball3_base_twist_vx_rate_part;

    /* tube3: omega, alpha, inertia, composite, a, U */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    const real slide3_q = q[15]; /* m */
    const wreal half_rod3_mass = w[48];
    const wreal rod3_base_moment_z = w[49];
    const wreal tube3_base_inertia_xx = w[60];
    const wreal tube3_base_inertia_yy = w[61];
    const real tube3_omega_x = hooke3_u_angle1 * hooke3_angle2_cos;
    work[660] = tube3_omega_x;
    const real tube3_omega_z = hooke3_u_angle1 * hooke3_angle2_sin;
    work[661] = tube3_omega_z;
    const real tube3_alpha_z = hooke3_angle2_cos * hooke3_u_angle1_times_u_angle2;
    work[662] = tube3_alpha_z;
    const real tube3_inertia_shift = slide3_q * (rod3_base_moment_z
        + slide3_q * half_rod3_mass) * 2.0;
    const real tube3_composite_inertia_xx = tube3_base_inertia_xx + tube3_inertia_shift;
    work[663] = tube3_composite_inertia_xx;
    const real tube3_composite_inertia_yy = tube3_base_inertia_yy + tube3_inertia_shift;
    work[664] = tube3_composite_inertia_yy;
    const real tube3_a_x = gravity_z * hooke3_minus_R_zx;
    work[665] = tube3_a_x;
    const real tube3_minus_a_y = gravity_z * hooke3_angle1_sin;
    work[666] = tube3_minus_a_y;
    const real tube3_U_xz = tube3_omega_x * tube3_omega_z;
    work[667] = tube3_U_xz;

    /* ball3: twist, rate */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* rate = G u + g_t */
    const real slide3_u = u[14]; /* m/s */
    const real ball3_minus_base_twist_by_hooke3_wx = hooke3_angle2_cos * tube3_omega_x
        + hooke3_angle2_sin * tube3_omega_z;
    const real ball3_minus_base_twist_by_hooke3_wy = hooke3_R_yx * tube3_omega_x
        + hooke3_u_angle2 * hooke3_angle1_cos - hooke3_minus_R_yz * tube3_omega_z;
    const real ball3_minus_base_twist_by_hooke3_wz = hooke3_u_angle2 * hooke3_angle1_sin
        - hooke3_minus_R_zx * tube3_omega_x + hooke3_R_zz * tube3_omega_z;
    const real ball3_base_twist_vx = ball3_base_twist_vx_part
        - (ball3_child_p_z * ball3_minus_base_twist_by_hooke3_wy
        - ball3_arm_hooke3_y * ball3_minus_base_twist_by_hooke3_wz) - slide3_u * hooke3_angle2_sin;
    const real ball3_base_twist_vy = ball3_base_twist_vy_part
        - (ball3_arm_hooke3_x * ball3_minus_base_twist_by_hooke3_wz
        - ball3_child_p_z * ball3_minus_base_twist_by_hooke3_wx) + slide3_u * hooke3_minus_R_yz;
    const real ball3_base_twist_vz = ball3_base_twist_vz_part
        - (ball3_arm_hooke3_y * ball3_minus_base_twist_by_hooke3_wx
        - ball3_arm_hooke3_x * ball3_minus_base_twist_by_hooke3_wy) - slide3_u * hooke3_R_zz;
    const real ball3_twist_vx = ball1_platform_R_xx * ball3_base_twist_vx
        + ball1_platform_R_yx * ball3_base_twist_vy + ball1_platform_R_zx * ball3_base_twist_vz;
    const real ball3_twist_vy = ball1_platform_R_xy * ball3_base_twist_vx
        + ball1_platform_R_yy * ball3_base_twist_vy + ball1_platform_R_zy * ball3_base_twist_vz;
    const real ball3_twist_vz = ball1_platform_R_xz * ball3_base_twist_vx
        + ball1_platform_R_yz * ball3_base_twist_vy + ball1_platform_R_zz * ball3_base_twist_vz;
    work[668] = ball3_twist_vz;
    const real ball3_minus_base_twist_by_hooke3_wx_rate = tube3_omega_z *
        hooke3_u_angle2_times_angle2_cos + hooke3_angle2_sin * tube3_omega_z_rate
        - (tube3_omega_x * hooke3_u_angle2_times_angle2_sin
        + hooke3_angle2_cos * tube3_minus_omega_x_rate);
    const real ball3_minus_base_twist_by_hooke3_wy_rate = tube3_omega_x * hooke3_R_yx_rate
        - hooke3_R_yx * tube3_minus_omega_x_rate
        - hooke3_u_angle2 * hooke3_u_angle1_times_angle1_sin
        - (tube3_omega_z * hooke3_minus_R_yz_rate + hooke3_minus_R_yz * tube3_omega_z_rate);
    const real ball3_minus_base_twist_by_hooke3_wz_rate = hooke3_u_angle2 *
        hooke3_u_angle1_times_angle1_cos - (tube3_omega_x * hooke3_minus_R_zx_rate
        - hooke3_minus_R_zx * tube3_minus_omega_x_rate) + (hooke3_R_zz * tube3_omega_z_rate
        - tube3_omega_z * hooke3_minus_R_zz_rate);
    const real ball3_minus_base_twist_by_hooke3_vx_rate = ball3_minus_base_twist_by_hooke3_wy *
        ball3_child_p_z_rate + ball3_child_p_z * ball3_minus_base_twist_by_hooke3_wy_rate
        - (ball3_minus_base_twist_by_hooke3_wz * ball3_child_p_y_rate
        + ball3_arm_hooke3_y * ball3_minus_base_twist_by_hooke3_wz_rate);
    const real ball3_minus_base_twist_by_hooke3_vy_rate = ball3_minus_base_twist_by_hooke3_wz *
        ball3_child_p_x_rate + ball3_arm_hooke3_x * ball3_minus_base_twist_by_hooke3_wz_rate
        - (ball3_minus_base_twist_by_hooke3_wx * ball3_child_p_z_rate
        + ball3_child_p_z * ball3_minus_base_twist_by_hooke3_wx_rate);
    const real ball3_minus_base_twist_by_hooke3_vz_rate = ball3_minus_base_twist_by_hooke3_wx *
        ball3_child_p_y_rate + ball3_arm_hooke3_y * ball3_minus_base_twist_by_hooke3_wx_rate
        - (ball3_minus_base_twist_by_hooke3_wy * ball3_child_p_x_rate
        + ball3_arm_hooke3_x * ball3_minus_base_twist_by_hooke3_wy_rate);
    const real ball3_base_twist_vx_rate = ball3_base_twist_vx_rate_part_2
        - ball3_minus_base_twist_by_hooke3_vx_rate - slide3_u * hooke3_u_angle2_times_angle2_cos;
    const real ball3_base_twist_vy_rate = ball3_base_twist_by_hooke0_vy_rate
        - ball1_minus_base_twist_by_slide0_vy_rate + ball3_base_twist_by_ball0_vy_rate
        - ball3_minus_base_twist_by_hooke3_vy_rate + slide3_u * hooke3_minus_R_yz_rate;
    const real ball3_base_twist_vz_rate = ball3_base_twist_by_hooke0_vz_rate
        - ball1_minus_base_twist_by_slide0_vz_rate + ball3_base_twist_by_ball0_vz_rate
        - ball3_minus_base_twist_by_hooke3_vz_rate + slide3_u * hooke3_minus_R_zz_rate;
    const real ball3_twist_vx_rate_part = ball3_base_twist_vx * ball1_platform_R_xx_rate
        + ball1_platform_R_xx * ball3_base_twist_vx_rate
        + (ball3_base_twist_vy * ball1_platform_R_yx_rate
        + ball1_platform_R_yx * ball3_base_twist_vy_rate);
    const real ball3_twist_vx_rate = ball3_base_twist_vz * ball1_platform_R_zx_rate
        + ball1_platform_R_zx * ball3_base_twist_vz_rate + ball3_twist_vx_rate_part;
    work[669] = ball3_twist_vx_rate;
    const real ball3_twist_vy_rate_part = ball3_base_twist_vx * ball1_platform_R_xy_rate
        + ball1_platform_R_xy * ball3_base_twist_vx_rate
        + (ball3_base_twist_vy * ball1_platform_R_yy_rate
        + ball1_platform_R_yy * ball3_base_twist_vy_rate);
    const real ball3_twist_vy_rate = ball3_base_twist_vz * ball1_platform_R_zy_rate
        + ball1_platform_R_zy * ball3_base_twist_vz_rate + ball3_twist_vy_rate_part;
    work[670] = ball3_twist_vy_rate;
    const real ball3_twist_vz_rate_part = ball3_base_twist_vx * ball1_platform_R_xz_rate
        + ball1_platform_R_xz * ball3_base_twist_vx_rate
        + (ball3_base_twist_vy * ball1_platform_R_yz_rate
        + ball1_platform_R_yz * ball3_base_twist_vy_rate);
    const real ball3_twist_vz_rate = ball3_base_twist_vz * ball1_platform_R_zz_rate
        + ball1_platform_R_zz * ball3_base_twist_vz_rate + ball3_twist_vz_rate_part;
    work[671] = ball3_twist_vz_rate;
    const real ball3_twist_vx_times_R_xx_rate_plus_R_xx_times_twist_vx_rate = ball3_twist_vx *
        (ball3_R_xx_rate_part - (hooke3_minus_R_zx * ball1_platform_R_zx_rate
        + ball1_platform_R_zx * hooke3_minus_R_zx_rate)) + ball3_R_xx * ball3_twist_vx_rate;
    const real ball3_rate_px_rate_part = ball3_twist_vy * (ball3_R_xy_rate_part
        - (hooke3_minus_R_zx * ball1_platform_R_zy_rate
        + ball1_platform_R_zy * hooke3_minus_R_zx_rate)) + ball3_R_xy * ball3_twist_vy_rate
        + ball3_twist_vx_times_R_xx_rate_plus_R_xx_times_twist_vx_rate;
    work[672] = ball3_rate_px_rate_part;
    const real ball3_twist_vx_times_R_yx_rate = ball3_twist_vx * (hooke3_angle1_cos *
        ball1_platform_R_yx_rate - ball1_platform_R_yx * hooke3_u_angle1_times_angle1_sin
        + (hooke3_angle1_sin * ball1_platform_R_zx_rate
        + ball1_platform_R_zx * hooke3_u_angle1_times_angle1_cos));
    work[673] = ball3_twist_vx_times_R_yx_rate;
    const real ball3_twist_vy_times_R_yy_rate = ball3_twist_vy * (hooke3_angle1_cos *
        ball1_platform_R_yy_rate - ball1_platform_R_yy * hooke3_u_angle1_times_angle1_sin
        + (hooke3_angle1_sin * ball1_platform_R_zy_rate
        + ball1_platform_R_zy * hooke3_u_angle1_times_angle1_cos));
    work[674] = ball3_twist_vy_times_R_yy_rate;
    const real ball3_twist_vz_times_R_yz_rate = ball3_twist_vz * (hooke3_angle1_cos *
        ball1_platform_R_yz_rate - ball1_platform_R_yz * hooke3_u_angle1_times_angle1_sin
        + (hooke3_angle1_sin * ball1_platform_R_zz_rate
        + ball1_platform_R_zz * hooke3_u_angle1_times_angle1_cos));
    work[675] = ball3_twist_vz_times_R_yz_rate;
    const real ball3_twist_vx_times_R_zx_rate_plus_R_zx_times_twist_vx_rate = ball3_twist_vx *
        (hooke3_R_zz * ball1_platform_R_zx_rate - ball1_platform_R_zx * hooke3_minus_R_zz_rate
        + ball3_R_zx_rate_part) + ball3_R_zx * ball3_twist_vx_rate;
    const real ball3_rate_pz_rate_part = ball3_twist_vy * (hooke3_R_zz * ball1_platform_R_zy_rate
        - ball1_platform_R_zy * hooke3_minus_R_zz_rate + ball3_R_zy_rate_part)
        + ball3_R_zy * ball3_twist_vy_rate
        + ball3_twist_vx_times_R_zx_rate_plus_R_zx_times_twist_vx_rate;
    work[676] = ball3_rate_pz_rate_part;

    /* hooke4: R, drift, velocity */
    /* R = R_fixed R_joint(q) */
    /* drift = S' u + [0; omega x v] */
    /* velocity = S u */
    const real hooke4_u_angle1 = u[15]; /* rad/s */
    const real hooke4_u_angle2 = u[16]; /* rad/s */
    const real hooke4_angle1_sin = work[407];
    const real hooke4_angle2_sin = work[409];
    const real hooke4_R_yx = hooke4_angle1_sin * hooke4_angle2_sin;
    work[677] = hooke4_R_yx;
    const real hooke4_angle2_cos = work[408];
    const real hooke4_minus_R_yz = hooke4_angle1_sin * hooke4_angle2_cos;
    work[678] = hooke4_minus_R_yz;
    const real hooke4_angle1_cos = work[406];
    const real hooke4_minus_R_zx = hooke4_angle1_cos * hooke4_angle2_sin;
    work[679] = hooke4_minus_R_zx;
    const real hooke4_R_zz = hooke4_angle1_cos * hooke4_angle2_cos;
    work[680] = hooke4_R_zz;
    const real hooke4_u_angle1_times_u_angle2 = hooke4_u_angle1 * hooke4_u_angle2;
    work[681] = hooke4_u_angle1_times_u_angle2;
    const real hooke4_minus_drift_relative_wx = hooke4_angle2_sin * hooke4_u_angle1_times_u_angle2;
    work[682] = hooke4_minus_drift_relative_wx;
    const real hooke4_u_angle1_times_angle1_sin = hooke4_u_angle1 * hooke4_angle1_sin;
    work[683] = hooke4_u_angle1_times_angle1_sin;
    const real hooke4_u_angle1_times_angle1_cos = hooke4_u_angle1 * hooke4_angle1_cos;
    work[684] = hooke4_u_angle1_times_angle1_cos;
    const real hooke4_u_angle2_times_angle2_sin = hooke4_u_angle2 * hooke4_angle2_sin;
    work[685] = hooke4_u_angle2_times_angle2_sin;
    const real hooke4_u_angle2_times_angle2_cos = hooke4_u_angle2 * hooke4_angle2_cos;
    work[686] = hooke4_u_angle2_times_angle2_cos;
    const real hooke4_R_yx_rate = hooke4_angle2_sin * hooke4_u_angle1_times_angle1_cos
        + hooke4_angle1_sin * hooke4_u_angle2_times_angle2_cos;
    work[687] = hooke4_R_yx_rate;
    const real hooke4_minus_R_yz_rate = hooke4_angle2_cos * hooke4_u_angle1_times_angle1_cos
        - hooke4_angle1_sin * hooke4_u_angle2_times_angle2_sin;
    work[688] = hooke4_minus_R_yz_rate;
    const real hooke4_minus_R_zx_rate = hooke4_angle1_cos * hooke4_u_angle2_times_angle2_cos
        - hooke4_angle2_sin * hooke4_u_angle1_times_angle1_sin;
    work[689] = hooke4_minus_R_zx_rate;
    const real hooke4_minus_R_zz_rate = hooke4_angle2_cos * hooke4_u_angle1_times_angle1_sin
        + hooke4_angle1_cos * hooke4_u_angle2_times_angle2_sin;
    work[690] = hooke4_minus_R_zz_rate;
    const real tube4_minus_omega_x_rate = hooke4_u_angle1 * hooke4_u_angle2_times_angle2_sin;
    work[691] = tube4_minus_omega_x_rate;
    const real tube4_omega_z_rate = hooke4_u_angle1 * hooke4_u_angle2_times_angle2_cos;
    work[692] = tube4_omega_z_rate;
    return CARDAN_OK;
}

CARDAN_PART int forward_dynamics_part3(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    (void)out;

    /* ball4: pose, twist, G */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* G = d(rate) / du */
    const wreal hooke0_position_x = w[1]; /* m */
    const wreal hooke0_position_y = w[2]; /* m */
    const wreal hooke4_position_x = w[26]; /* m */
    const wreal hooke4_position_y = w[27]; /* m */
    const wreal ball4_child_position_x_minus_ball0_child_position_x = w[40];
    const wreal ball4_child_position_y_minus_ball0_child_position_y = w[41];
    const real ball1_platform_p_x = work[434];
    const real ball1_platform_R_xx = work[425];
    const real ball1_platform_R_xy = work[426];
    const real ball4_child_p_x = ball4_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_xx
        + ball4_child_position_y_minus_ball0_child_position_y * ball1_platform_R_xy
        + ball1_platform_p_x;
    const real ball1_platform_p_y = work[435];
    const real ball1_platform_R_yx = work[428];
    const real ball1_platform_R_yy = work[429];
    const real ball4_child_p_y = ball4_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_yx
        + ball4_child_position_y_minus_ball0_child_position_y * ball1_platform_R_yy
        + ball1_platform_p_y;
    const real ball1_platform_p_z = work[436];
    const real ball1_platform_R_zx = work[431];
    const real ball1_platform_R_zy = work[432];
    const real ball4_child_p_z = ball4_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_zx
        + ball4_child_position_y_minus_ball0_child_position_y * ball1_platform_R_zy
        + ball1_platform_p_z;
    const real hooke4_angle2_cos = work[408];
    const real hooke4_R_yx = work[677];
    const real hooke4_minus_R_zx = work[679];
    const real ball4_R_xx = ball1_platform_R_xx * hooke4_angle2_cos
        + ball1_platform_R_yx * hooke4_R_yx - ball1_platform_R_zx * hooke4_minus_R_zx;
    const real ball4_R_xy = ball1_platform_R_xy * hooke4_angle2_cos
        + ball1_platform_R_yy * hooke4_R_yx - ball1_platform_R_zy * hooke4_minus_R_zx;
    const real ball1_platform_R_xz = work[427];
    const real ball1_platform_R_yz = work[430];
    const real ball1_platform_R_zz = work[433];
    const real ball4_R_xz = ball1_platform_R_xz * hooke4_angle2_cos
        + ball1_platform_R_yz * hooke4_R_yx - ball1_platform_R_zz * hooke4_minus_R_zx;
    work[398] = ball4_R_xz;
    const real hooke4_angle1_cos = work[406];
    const real hooke4_angle1_sin = work[407];
    const real ball4_R_yx = ball1_platform_R_yx * hooke4_angle1_cos
        + ball1_platform_R_zx * hooke4_angle1_sin;
    work[399] = ball4_R_yx;
    const real ball4_R_yy = ball1_platform_R_yy * hooke4_angle1_cos
        + ball1_platform_R_zy * hooke4_angle1_sin;
    work[402] = ball4_R_yy;
    const real ball4_R_yz = ball1_platform_R_yz * hooke4_angle1_cos
        + ball1_platform_R_zz * hooke4_angle1_sin;
    work[403] = ball4_R_yz;
    const real hooke4_angle2_sin = work[409];
    const real hooke4_minus_R_yz = work[678];
    const real hooke4_R_zz = work[680];
    const real ball4_R_zx = ball1_platform_R_xx * hooke4_angle2_sin
        - ball1_platform_R_yx * hooke4_minus_R_yz + ball1_platform_R_zx * hooke4_R_zz;
    const real ball4_R_zy = ball1_platform_R_xy * hooke4_angle2_sin
        - ball1_platform_R_yy * hooke4_minus_R_yz + ball1_platform_R_zy * hooke4_R_zz;
    const real ball4_R_zz = ball1_platform_R_xz * hooke4_angle2_sin
        - ball1_platform_R_yz * hooke4_minus_R_yz + ball1_platform_R_zz * hooke4_R_zz;
    work[554] = ball4_R_zz;
    const real ball4_arm_hooke0_x = ball4_child_p_x - hooke0_position_x;
    const real ball4_arm_hooke0_y = ball4_child_p_y - hooke0_position_y;
    const real ball1_base_twist_hooke0_angle1_wy = work[438];
    const real ball1_base_twist_hooke0_angle1_wz = work[439];
    const real ball4_base_twist_hooke0_angle1_vx = ball1_base_twist_hooke0_angle1_wy *
        ball4_child_p_z - ball1_base_twist_hooke0_angle1_wz * ball4_arm_hooke0_y;
    const real ball1_base_twist_hooke0_angle1_wx = work[437];
    const real ball4_base_twist_hooke0_angle1_vy = ball1_base_twist_hooke0_angle1_wz *
        ball4_arm_hooke0_x - ball1_base_twist_hooke0_angle1_wx * ball4_child_p_z;
    const real ball4_base_twist_hooke0_angle1_vz = ball1_base_twist_hooke0_angle1_wx *
        ball4_arm_hooke0_y - ball1_base_twist_hooke0_angle1_wy * ball4_arm_hooke0_x;
    const real hooke0_angle1_cos = work[390];
    const real hooke0_angle1_sin = work[391];
    const real ball4_base_twist_hooke0_angle2_vx = hooke0_angle1_cos * ball4_child_p_z
        - hooke0_angle1_sin * ball4_arm_hooke0_y;
    const real ball4_base_twist_hooke0_angle2_vy = hooke0_angle1_sin * ball4_arm_hooke0_x;
    const real ball4_minus_base_twist_hooke0_angle2_vz = hooke0_angle1_cos * ball4_arm_hooke0_x;
    const real ball4_arm_ball0_x = ball4_child_p_x - ball1_platform_p_x;
    const real ball4_arm_ball0_y = ball4_child_p_y - ball1_platform_p_y;
    const real ball4_arm_ball0_z = ball4_child_p_z - ball1_platform_p_z;
    const real ball4_base_twist_ball0_x_vx = ball1_platform_R_yx * ball4_arm_ball0_z
        - ball1_platform_R_zx * ball4_arm_ball0_y;
    const real ball4_base_twist_ball0_x_vy = ball1_platform_R_zx * ball4_arm_ball0_x
        - ball1_platform_R_xx * ball4_arm_ball0_z;
    const real ball4_base_twist_ball0_x_vz = ball1_platform_R_xx * ball4_arm_ball0_y
        - ball1_platform_R_yx * ball4_arm_ball0_x;
    const real ball4_base_twist_ball0_y_vx = ball1_platform_R_yy * ball4_arm_ball0_z
        - ball1_platform_R_zy * ball4_arm_ball0_y;
    const real ball4_base_twist_ball0_y_vy = ball1_platform_R_zy * ball4_arm_ball0_x
        - ball1_platform_R_xy * ball4_arm_ball0_z;
    const real ball4_base_twist_ball0_y_vz = ball1_platform_R_xy * ball4_arm_ball0_y
        - ball1_platform_R_yy * ball4_arm_ball0_x;
    const real ball4_base_twist_ball0_z_vx = ball1_platform_R_yz * ball4_arm_ball0_z
        - ball1_platform_R_zz * ball4_arm_ball0_y;
    const real ball4_base_twist_ball0_z_vy = ball1_platform_R_zz * ball4_arm_ball0_x
        - ball1_platform_R_xz * ball4_arm_ball0_z;
    const real ball4_base_twist_ball0_z_vz = ball1_platform_R_xz * ball4_arm_ball0_y
        - ball1_platform_R_yz * ball4_arm_ball0_x;
    const real ball1_base_twist_by_slide0_vx = work[440];
    const real ball1_base_twist_by_hooke0_wy = work[532];
    const real ball1_base_twist_by_hooke0_wz = work[533];
    const real ball1_base_twist_by_ball0_wy = work[444];
    const real ball1_base_twist_by_ball0_wz = work[445];
    const real ball4_base_twist_vx_part = ball1_base_twist_by_hooke0_wy * ball4_child_p_z
        - ball1_base_twist_by_hooke0_wz * ball4_arm_hooke0_y + ball1_base_twist_by_slide0_vx
        + (ball1_base_twist_by_ball0_wy * ball4_arm_ball0_z
        - ball1_base_twist_by_ball0_wz * ball4_arm_ball0_y);
    const real ball1_base_twist_by_hooke0_wx = work[531];
    const real ball1_minus_base_twist_by_slide0_vy = work[441];
    const real ball1_base_twist_by_ball0_wx = work[443];
    const real ball4_base_twist_vy_part = ball1_base_twist_by_hooke0_wz * ball4_arm_hooke0_x
        - ball1_base_twist_by_hooke0_wx * ball4_child_p_z - ball1_minus_base_twist_by_slide0_vy
        + (ball1_base_twist_by_ball0_wz * ball4_arm_ball0_x
        - ball1_base_twist_by_ball0_wx * ball4_arm_ball0_z);
    const real ball1_base_twist_by_slide0_vz = work[442];
    const real ball4_base_twist_vz_part = ball1_base_twist_by_hooke0_wx * ball4_arm_hooke0_y
        - ball1_base_twist_by_hooke0_wy * ball4_arm_hooke0_x + ball1_base_twist_by_slide0_vz
        + (ball1_base_twist_by_ball0_wx * ball4_arm_ball0_y
        - ball1_base_twist_by_ball0_wy * ball4_arm_ball0_x);
    const real ball4_arm_hooke4_x = ball4_child_p_x - hooke4_position_x;
    const real ball4_arm_hooke4_y = ball4_child_p_y - hooke4_position_y;
    const real ball4_minus_base_twist_hooke4_angle1_wx = hooke4_angle2_cos * hooke4_angle2_cos
        + hooke4_angle2_sin * hooke4_angle2_sin;
    const real ball4_minus_base_twist_hooke4_angle1_wy = hooke4_angle2_cos * hooke4_R_yx
        - hooke4_angle2_sin * hooke4_minus_R_yz;
    const real ball4_minus_base_twist_hooke4_angle1_wz = hooke4_angle2_sin * hooke4_R_zz
        - hooke4_angle2_cos * hooke4_minus_R_zx;
    const real ball4_minus_base_twist_hooke4_angle1_vx = ball4_child_p_z *
        ball4_minus_base_twist_hooke4_angle1_wy
        - ball4_arm_hooke4_y * ball4_minus_base_twist_hooke4_angle1_wz;
    const real ball4_minus_base_twist_hooke4_angle1_vy = ball4_arm_hooke4_x *
        ball4_minus_base_twist_hooke4_angle1_wz
        - ball4_child_p_z * ball4_minus_base_twist_hooke4_angle1_wx;
    const real ball4_minus_base_twist_hooke4_angle1_vz = ball4_arm_hooke4_y *
        ball4_minus_base_twist_hooke4_angle1_wx
        - ball4_arm_hooke4_x * ball4_minus_base_twist_hooke4_angle1_wy;
    const real ball4_minus_base_twist_hooke4_angle2_vx = hooke4_angle1_cos * ball4_child_p_z
        - hooke4_angle1_sin * ball4_arm_hooke4_y;
    const real ball4_minus_base_twist_hooke4_angle2_vy = hooke4_angle1_sin * ball4_arm_hooke4_x;
    const real ball4_base_twist_hooke4_angle2_vz = hooke4_angle1_cos * ball4_arm_hooke4_x;
    const real ball4_twist_hooke0_angle1_vx = ball1_platform_R_xx *
        ball4_base_twist_hooke0_angle1_vx
        + ball1_platform_R_yx * ball4_base_twist_hooke0_angle1_vy
        + ball1_platform_R_zx * ball4_base_twist_hooke0_angle1_vz;
    const real ball4_twist_hooke0_angle1_vy = ball1_platform_R_xy *
        ball4_base_twist_hooke0_angle1_vx
        + ball1_platform_R_yy * ball4_base_twist_hooke0_angle1_vy
        + ball1_platform_R_zy * ball4_base_twist_hooke0_angle1_vz;
    const real ball4_twist_hooke0_angle1_vz = ball1_platform_R_xz *
        ball4_base_twist_hooke0_angle1_vx
        + ball1_platform_R_yz * ball4_base_twist_hooke0_angle1_vy
        + ball1_platform_R_zz * ball4_base_twist_hooke0_angle1_vz;
    const real ball4_twist_hooke0_angle2_vx = ball1_platform_R_xx *
        ball4_base_twist_hooke0_angle2_vx
        + ball1_platform_R_yx * ball4_base_twist_hooke0_angle2_vy
        - ball1_platform_R_zx * ball4_minus_base_twist_hooke0_angle2_vz;
    const real ball4_twist_hooke0_angle2_vy = ball1_platform_R_xy *
        ball4_base_twist_hooke0_angle2_vx
        + ball1_platform_R_yy * ball4_base_twist_hooke0_angle2_vy
        - ball1_platform_R_zy * ball4_minus_base_twist_hooke0_angle2_vz;
    const real ball4_twist_hooke0_angle2_vz = ball1_platform_R_xz *
        ball4_base_twist_hooke0_angle2_vx
        + ball1_platform_R_yz * ball4_base_twist_hooke0_angle2_vy
        - ball1_platform_R_zz * ball4_minus_base_twist_hooke0_angle2_vz;
    const real ball4_twist_ball0_x_vx = ball1_platform_R_xx * ball4_base_twist_ball0_x_vx
        + ball1_platform_R_yx * ball4_base_twist_ball0_x_vy
        + ball1_platform_R_zx * ball4_base_twist_ball0_x_vz;
    const real ball4_twist_ball0_x_vy = ball1_platform_R_xy * ball4_base_twist_ball0_x_vx
        + ball1_platform_R_yy * ball4_base_twist_ball0_x_vy
        + ball1_platform_R_zy * ball4_base_twist_ball0_x_vz;
    const real ball4_twist_ball0_x_vz = ball1_platform_R_xz * ball4_base_twist_ball0_x_vx
        + ball1_platform_R_yz * ball4_base_twist_ball0_x_vy
        + ball1_platform_R_zz * ball4_base_twist_ball0_x_vz;
    const real ball4_twist_ball0_y_vx = ball1_platform_R_xx * ball4_base_twist_ball0_y_vx
        + ball1_platform_R_yx * ball4_base_twist_ball0_y_vy
        + ball1_platform_R_zx * ball4_base_twist_ball0_y_vz;
    const real ball4_twist_ball0_y_vy = ball1_platform_R_xy * ball4_base_twist_ball0_y_vx
        + ball1_platform_R_yy * ball4_base_twist_ball0_y_vy
        + ball1_platform_R_zy * ball4_base_twist_ball0_y_vz;
    const real ball4_twist_ball0_y_vz = ball1_platform_R_xz * ball4_base_twist_ball0_y_vx
        + ball1_platform_R_yz * ball4_base_twist_ball0_y_vy
        + ball1_platform_R_zz * ball4_base_twist_ball0_y_vz;
    const real ball4_twist_ball0_z_vx = ball1_platform_R_xx * ball4_base_twist_ball0_z_vx
        + ball1_platform_R_yx * ball4_base_twist_ball0_z_vy
        + ball1_platform_R_zx * ball4_base_twist_ball0_z_vz;
    const real ball4_twist_ball0_z_vy = ball1_platform_R_xy * ball4_base_twist_ball0_z_vx
        + ball1_platform_R_yy * ball4_base_twist_ball0_z_vy
        + ball1_platform_R_zy * ball4_base_twist_ball0_z_vz;
    const real ball4_twist_ball0_z_vz = ball1_platform_R_xz * ball4_base_twist_ball0_z_vx
        + ball1_platform_R_yz * ball4_base_twist_ball0_z_vy
        + ball1_platform_R_zz * ball4_base_twist_ball0_z_vz;
    const real ball4_minus_twist_hooke4_angle1_vx = ball1_platform_R_xx *
        ball4_minus_base_twist_hooke4_angle1_vx
        + ball1_platform_R_yx * ball4_minus_base_twist_hooke4_angle1_vy
        + ball1_platform_R_zx * ball4_minus_base_twist_hooke4_angle1_vz;
    const real ball4_minus_twist_hooke4_angle1_vy = ball1_platform_R_xy *
        ball4_minus_base_twist_hooke4_angle1_vx
        + ball1_platform_R_yy * ball4_minus_base_twist_hooke4_angle1_vy
        + ball1_platform_R_zy * ball4_minus_base_twist_hooke4_angle1_vz;
    const real ball4_minus_twist_hooke4_angle1_vz = ball1_platform_R_xz *
        ball4_minus_base_twist_hooke4_angle1_vx
        + ball1_platform_R_yz * ball4_minus_base_twist_hooke4_angle1_vy
        + ball1_platform_R_zz * ball4_minus_base_twist_hooke4_angle1_vz;
    const real ball4_twist_hooke4_angle2_vx = ball1_platform_R_zx *
        ball4_base_twist_hooke4_angle2_vz
        - (ball1_platform_R_xx * ball4_minus_base_twist_hooke4_angle2_vx
        + ball1_platform_R_yx * ball4_minus_base_twist_hooke4_angle2_vy);
    const real ball4_twist_hooke4_angle2_vy = ball1_platform_R_zy *
        ball4_base_twist_hooke4_angle2_vz
        - (ball1_platform_R_xy * ball4_minus_base_twist_hooke4_angle2_vx
        + ball1_platform_R_yy * ball4_minus_base_twist_hooke4_angle2_vy);
    const real ball4_twist_hooke4_angle2_vz = ball1_platform_R_zz *
        ball4_base_twist_hooke4_angle2_vz
        - (ball1_platform_R_xz * ball4_minus_base_twist_hooke4_angle2_vx
        + ball1_platform_R_yz * ball4_minus_base_twist_hooke4_angle2_vy);
    const real ball4_G_px_hooke0_angle1 = ball4_R_xx * ball4_twist_hooke0_angle1_vx
        + ball4_R_xy * ball4_twist_hooke0_angle1_vy + ball4_R_xz * ball4_twist_hooke0_angle1_vz;
    work[555] = ball4_G_px_hooke0_angle1;
    const real ball4_G_px_hooke0_angle2 = ball4_R_xx * ball4_twist_hooke0_angle2_vx
        + ball4_R_xy * ball4_twist_hooke0_angle2_vy + ball4_R_xz * ball4_twist_hooke0_angle2_vz;
    work[558] = ball4_G_px_hooke0_angle2;
    const real ball1_twist_slide0_vx = work[446];
    const real ball1_twist_slide0_vy = work[447];
    const real ball1_twist_slide0_vz = work[448];
    const real ball4_G_px_slide0 = ball1_twist_slide0_vx * ball4_R_xx
        + ball1_twist_slide0_vy * ball4_R_xy + ball1_twist_slide0_vz * ball4_R_xz;
    work[560] = ball4_G_px_slide0;
    const real ball4_G_px_ball0_x = ball4_R_xx * ball4_twist_ball0_x_vx
        + ball4_R_xy * ball4_twist_ball0_x_vy + ball4_R_xz * ball4_twist_ball0_x_vz;
    work[561] = ball4_G_px_ball0_x;
    const real ball4_G_px_ball0_y = ball4_R_xx * ball4_twist_ball0_y_vx
        + ball4_R_xy * ball4_twist_ball0_y_vy + ball4_R_xz * ball4_twist_ball0_y_vz;
    work[562] = ball4_G_px_ball0_y;
    const real ball4_G_px_ball0_z = ball4_R_xx * ball4_twist_ball0_z_vx
        + ball4_R_xy * ball4_twist_ball0_z_vy + ball4_R_xz * ball4_twist_ball0_z_vz;
    work[563] = ball4_G_px_ball0_z;
    const real ball4_minus_G_px_hooke4_angle1 = ball4_R_xx * ball4_minus_twist_hooke4_angle1_vx
        + ball4_R_xy * ball4_minus_twist_hooke4_angle1_vy
        + ball4_R_xz * ball4_minus_twist_hooke4_angle1_vz;
    work[564] = ball4_minus_G_px_hooke4_angle1;
    const real ball4_G_px_hooke4_angle2 = ball4_R_xx * ball4_twist_hooke4_angle2_vx
        + ball4_R_xy * ball4_twist_hooke4_angle2_vy + ball4_R_xz * ball4_twist_hooke4_angle2_vz;
    work[565] = ball4_G_px_hooke4_angle2;
    const real ball4_minus_G_px_slide4 = ball4_R_xx * ball4_R_zx + ball4_R_xy * ball4_R_zy
        + ball4_R_xz * ball4_R_zz;
    work[568] = ball4_minus_G_px_slide4;
    const real ball4_G_py_hooke0_angle1 = ball4_R_yx * ball4_twist_hooke0_angle1_vx
        + ball4_R_yy * ball4_twist_hooke0_angle1_vy + ball4_R_yz * ball4_twist_hooke0_angle1_vz;
    work[569] = ball4_G_py_hooke0_angle1;
    const real ball4_G_py_hooke0_angle2 = ball4_R_yx * ball4_twist_hooke0_angle2_vx
        + ball4_R_yy * ball4_twist_hooke0_angle2_vy + ball4_R_yz * ball4_twist_hooke0_angle2_vz;
    work[693] = ball4_G_py_hooke0_angle2;
    const real ball4_G_py_slide0 = ball1_twist_slide0_vx * ball4_R_yx
        + ball1_twist_slide0_vy * ball4_R_yy + ball1_twist_slide0_vz * ball4_R_yz;
    work[694] = ball4_G_py_slide0;
    const real ball4_G_py_ball0_x = ball4_R_yx * ball4_twist_ball0_x_vx
        + ball4_R_yy * ball4_twist_ball0_x_vy + ball4_R_yz * ball4_twist_ball0_x_vz;
    work[695] = ball4_G_py_ball0_x;
    const real ball4_G_py_ball0_y = ball4_R_yx * ball4_twist_ball0_y_vx
        + ball4_R_yy * ball4_twist_ball0_y_vy + ball4_R_yz * ball4_twist_ball0_y_vz;
    work[696] = ball4_G_py_ball0_y;
    const real ball4_G_py_ball0_z = ball4_R_yx * ball4_twist_ball0_z_vx
        + ball4_R_yy * ball4_twist_ball0_z_vy + ball4_R_yz * ball4_twist_ball0_z_vz;
    work[697] = ball4_G_py_ball0_z;
    const real ball4_minus_G_py_hooke4_angle1 = ball4_R_yx * ball4_minus_twist_hooke4_angle1_vx
        + ball4_R_yy * ball4_minus_twist_hooke4_angle1_vy
        + ball4_R_yz * ball4_minus_twist_hooke4_angle1_vz;
    work[698] = ball4_minus_G_py_hooke4_angle1;
    const real ball4_G_py_hooke4_angle2 = ball4_R_yx * ball4_twist_hooke4_angle2_vx
        + ball4_R_yy * ball4_twist_hooke4_angle2_vy + ball4_R_yz * ball4_twist_hooke4_angle2_vz;
    work[699] = ball4_G_py_hooke4_angle2;
    const real ball4_minus_G_py_slide4 = ball4_R_yx * ball4_R_zx + ball4_R_yy * ball4_R_zy
        + ball4_R_yz * ball4_R_zz;
    work[700] = ball4_minus_G_py_slide4;
    const real ball4_G_pz_hooke0_angle1 = ball4_R_zx * ball4_twist_hooke0_angle1_vx
        + ball4_R_zy * ball4_twist_hooke0_angle1_vy + ball4_R_zz * ball4_twist_hooke0_angle1_vz;
    work[701] = ball4_G_pz_hooke0_angle1;
    const real ball4_G_pz_hooke0_angle2 = ball4_R_zx * ball4_twist_hooke0_angle2_vx
        + ball4_R_zy * ball4_twist_hooke0_angle2_vy + ball4_R_zz * ball4_twist_hooke0_angle2_vz;
    work[702] = ball4_G_pz_hooke0_angle2;
    const real ball4_G_pz_slide0 = ball1_twist_slide0_vx * ball4_R_zx
        + ball1_twist_slide0_vy * ball4_R_zy + ball1_twist_slide0_vz * ball4_R_zz;
    work[703] = ball4_G_pz_slide0;
    const real ball4_G_pz_ball0_x = ball4_R_zx * ball4_twist_ball0_x_vx
        + ball4_R_zy * ball4_twist_ball0_x_vy + ball4_R_zz * ball4_twist_ball0_x_vz;
    work[704] = ball4_G_pz_ball0_x;
    const real ball4_G_pz_ball0_y = ball4_R_zx * ball4_twist_ball0_y_vx
        + ball4_R_zy * ball4_twist_ball0_y_vy + ball4_R_zz * ball4_twist_ball0_y_vz;
    work[705] = ball4_G_pz_ball0_y;
    const real ball4_G_pz_ball0_z = ball4_R_zx * ball4_twist_ball0_z_vx
        + ball4_R_zy * ball4_twist_ball0_z_vy + ball4_R_zz * ball4_twist_ball0_z_vz;
    work[706] = ball4_G_pz_ball0_z;
    const real ball4_minus_G_pz_hooke4_angle1 = ball4_R_zx * ball4_minus_twist_hooke4_angle1_vx
        + ball4_R_zy * ball4_minus_twist_hooke4_angle1_vy
        + ball4_R_zz * ball4_minus_twist_hooke4_angle1_vz;
    work[707] = ball4_minus_G_pz_hooke4_angle1;
    const real ball4_G_pz_hooke4_angle2 = ball4_R_zx * ball4_twist_hooke4_angle2_vx
        + ball4_R_zy * ball4_twist_hooke4_angle2_vy + ball4_R_zz * ball4_twist_hooke4_angle2_vz;
    work[708] = ball4_G_pz_hooke4_angle2;
    const real ball4_minus_G_pz_slide4 = ball4_R_zx * ball4_R_zx + ball4_R_zy * ball4_R_zy
        + ball4_R_zz * ball4_R_zz;
    work[709] = ball4_minus_G_pz_slide4;
    const real ball1_platform_p_x_rate = work[510];
    const real ball1_platform_R_xx_rate = work[501];
    const real ball1_platform_R_xy_rate = work[502];
    const real ball4_child_p_x_rate = ball4_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_xx_rate
        + ball4_child_position_y_minus_ball0_child_position_y * ball1_platform_R_xy_rate
        + ball1_platform_p_x_rate;
    const real ball1_platform_R_yx_rate = work[504];
    const real ball1_platform_R_yy_rate = work[505];
    const real ball1_minus_platform_p_y_rate = work[511];
    const real ball4_child_p_y_rate = ball4_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_yx_rate
        + ball4_child_position_y_minus_ball0_child_position_y * ball1_platform_R_yy_rate
        - ball1_minus_platform_p_y_rate;
    const real ball1_platform_p_z_rate = work[512];
    const real ball1_platform_R_zx_rate = work[507];
    const real ball1_platform_R_zy_rate = work[508];
    const real ball4_child_p_z_rate = ball4_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_zx_rate
        + ball4_child_position_y_minus_ball0_child_position_y * ball1_platform_R_zy_rate
        + ball1_platform_p_z_rate;
    const real hooke4_u_angle2_times_angle2_sin = work[685];
    const real hooke4_R_yx_rate = work[687];
    const real ball4_R_xx_rate_part = hooke4_angle2_cos * ball1_platform_R_xx_rate
        - ball1_platform_R_xx * hooke4_u_angle2_times_angle2_sin
        + (hooke4_R_yx * ball1_platform_R_yx_rate + ball1_platform_R_yx * hooke4_R_yx_rate);
    const real ball4_R_xy_rate_part = hooke4_angle2_cos * ball1_platform_R_xy_rate
        - ball1_platform_R_xy * hooke4_u_angle2_times_angle2_sin
        + (hooke4_R_yx * ball1_platform_R_yy_rate + ball1_platform_R_yy * hooke4_R_yx_rate);
    const real ball1_platform_R_xz_rate = work[503];
    const real ball1_platform_R_yz_rate = work[506];
    const real ball4_R_xz_rate_part = hooke4_angle2_cos * ball1_platform_R_xz_rate
        - ball1_platform_R_xz * hooke4_u_angle2_times_angle2_sin
        + (hooke4_R_yx * ball1_platform_R_yz_rate + ball1_platform_R_yz * hooke4_R_yx_rate);
    work[710] = ball4_R_xz_rate_part;
    const real hooke4_u_angle2_times_angle2_cos = work[686];
    const real hooke4_minus_R_yz_rate = work[688];
    const real ball4_R_zx_rate_part = hooke4_angle2_sin * ball1_platform_R_xx_rate
        + ball1_platform_R_xx * hooke4_u_angle2_times_angle2_cos
        - (hooke4_minus_R_yz * ball1_platform_R_yx_rate
        + ball1_platform_R_yx * hooke4_minus_R_yz_rate);
    const real ball4_R_zy_rate_part = hooke4_angle2_sin * ball1_platform_R_xy_rate
        + ball1_platform_R_xy * hooke4_u_angle2_times_angle2_cos
        - (hooke4_minus_R_yz * ball1_platform_R_yy_rate
        + ball1_platform_R_yy * hooke4_minus_R_yz_rate);
    const real ball4_R_zz_rate_part = hooke4_angle2_sin * ball1_platform_R_xz_rate
        + ball1_platform_R_xz * hooke4_u_angle2_times_angle2_cos
        - (hooke4_minus_R_yz * ball1_platform_R_yz_rate
        + ball1_platform_R_yz * hooke4_minus_R_yz_rate);
    work[711] = ball4_R_zz_rate_part;
    const real ball1_base_twist_by_hooke0_wz_rate = work[539];
    const real ball1_base_twist_by_hooke0_wx_rate = work[537];
    const real ball4_base_twist_by_hooke0_vy_rate = ball4_arm_hooke0_x *
        ball1_base_twist_by_hooke0_wz_rate + ball1_base_twist_by_hooke0_wz * ball4_child_p_x_rate
        - (ball4_child_p_z * ball1_base_twist_by_hooke0_wx_rate
        + ball1_base_twist_by_hooke0_wx * ball4_child_p_z_rate);
    const real ball1_base_twist_by_hooke0_wy_rate = work[538];
    const real ball4_base_twist_by_hooke0_vz_rate = ball4_arm_hooke0_y *
        ball1_base_twist_by_hooke0_wx_rate + ball1_base_twist_by_hooke0_wx * ball4_child_p_y_rate
        - (ball4_arm_hooke0_x * ball1_base_twist_by_hooke0_wy_rate
        + ball1_base_twist_by_hooke0_wy * ball4_child_p_x_rate);
    const real ball1_base_twist_by_slide0_vx_rate = work[519];
    const real ball4_base_twist_vx_rate_part = ball4_child_p_z * ball1_base_twist_by_hooke0_wy_rate
        + ball1_base_twist_by_hooke0_wy * ball4_child_p_z_rate
        - (ball4_arm_hooke0_y * ball1_base_twist_by_hooke0_wz_rate
        + ball1_base_twist_by_hooke0_wz * ball4_child_p_y_rate)
        + ball1_base_twist_by_slide0_vx_rate;
    const real ball4_arm_ball0_x_rate = ball4_child_p_x_rate - ball1_platform_p_x_rate;
    const real ball4_arm_ball0_y_rate = ball1_minus_platform_p_y_rate + ball4_child_p_y_rate;
    const real ball4_arm_ball0_z_rate = ball4_child_p_z_rate - ball1_platform_p_z_rate;
    const real ball1_base_twist_by_ball0_wz_rate = work[524];
    const real ball1_base_twist_by_ball0_wx_rate = work[522];
    const real ball4_base_twist_by_ball0_vy_rate = ball4_arm_ball0_x *
        ball1_base_twist_by_ball0_wz_rate + ball1_base_twist_by_ball0_wz * ball4_arm_ball0_x_rate
        - (ball4_arm_ball0_z * ball1_base_twist_by_ball0_wx_rate
        + ball1_base_twist_by_ball0_wx * ball4_arm_ball0_z_rate);
    const real ball1_base_twist_by_ball0_wy_rate = work[523];
    const real ball4_base_twist_by_ball0_vz_rate = ball4_arm_ball0_y *
        ball1_base_twist_by_ball0_wx_rate + ball1_base_twist_by_ball0_wx * ball4_arm_ball0_y_rate
        - (ball4_arm_ball0_x * ball1_base_twist_by_ball0_wy_rate
        + ball1_base_twist_by_ball0_wy * ball4_arm_ball0_x_rate);
    const real ball4_base_twist_vx_rate_part_2 = ball4_arm_ball0_z *
        ball1_base_twist_by_ball0_wy_rate + ball1_base_twist_by_ball0_wy * ball4_arm_ball0_z_rate
        - (ball4_arm_ball0_y * ball1_base_twist_by_ball0_wz_rate
        + ball1_base_twist_by_ball0_wz * ball4_arm_ball0_y_rate) + ball4_base_twist_vx_rate_part;

    /* tube4: omega, alpha, inertia, composite, a, U */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    const real slide4_q = q[18]; /* m */
    const real hooke4_u_angle1 = u[15]; /* rad/s */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const wreal half_rod4_mass = w[50];
    const wreal rod4_base_moment_z = w[51];
    const wreal tube4_base_inertia_xx = w[57];
    const wreal tube4_base_inertia_yy = w[58];
    const real tube4_omega_x = hooke4_u_angle1 * hooke4_angle2_cos;
    work[712] = tube4_omega_x;
    const real tube4_omega_z = hooke4_u_angle1 * hooke4_angle2_sin;
    work[713] = tube4_omega_z;
    const real hooke4_u_angle1_times_u_angle2 = work[681];
    const real tube4_alpha_z = hooke4_angle2_cos * hooke4_u_angle1_times_u_angle2;
    work[714] = tube4_alpha_z;
    const real tube4_inertia_shift = slide4_q * (rod4_base_moment_z
        + slide4_q * half_rod4_mass) * 2.0;
    const real tube4_composite_inertia_xx = tube4_base_inertia_xx + tube4_inertia_shift;
    const real tube4_composite_inertia_yy = tube4_base_inertia_yy + tube4_inertia_shift;
    work[715] = tube4_composite_inertia_yy;
    const real tube4_a_x = gravity_z * hooke4_minus_R_zx;
    work[716] = tube4_a_x;
    const real tube4_minus_a_y = gravity_z * hooke4_angle1_sin;
    work[717] = tube4_minus_a_y;
    const real tube4_U_xz = tube4_omega_x * tube4_omega_z;
    work[718] = tube4_U_xz;

    /* ball4: twist, rate */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* rate = G u + g_t */
    const real hooke4_u_angle2 = u[16]; /* rad/s */
    const real slide4_u = u[17]; /* m/s */
    const real ball4_minus_base_twist_by_hooke4_wx = hooke4_angle2_cos * tube4_omega_x
        + hooke4_angle2_sin * tube4_omega_z;
    const real ball4_minus_base_twist_by_hooke4_wy = hooke4_R_yx * tube4_omega_x
        + hooke4_u_angle2 * hooke4_angle1_cos - hooke4_minus_R_yz * tube4_omega_z;
    const real ball4_minus_base_twist_by_hooke4_wz = hooke4_u_angle2 * hooke4_angle1_sin
        - hooke4_minus_R_zx * tube4_omega_x + hooke4_R_zz * tube4_omega_z;
    const real ball4_base_twist_vx = ball4_base_twist_vx_part
        - (ball4_child_p_z * ball4_minus_base_twist_by_hooke4_wy
        - ball4_arm_hooke4_y * ball4_minus_base_twist_by_hooke4_wz) - slide4_u * hooke4_angle2_sin;
    const real ball4_base_twist_vy = ball4_base_twist_vy_part
        - (ball4_arm_hooke4_x * ball4_minus_base_twist_by_hooke4_wz
        - ball4_child_p_z * ball4_minus_base_twist_by_hooke4_wx) + slide4_u * hooke4_minus_R_yz;
    const real ball4_base_twist_vz = ball4_base_twist_vz_part
        - (ball4_arm_hooke4_y * ball4_minus_base_twist_by_hooke4_wx
        - ball4_arm_hooke4_x * ball4_minus_base_twist_by_hooke4_wy) - slide4_u * hooke4_R_zz;
    const real ball4_twist_vx = ball1_platform_R_xx * ball4_base_twist_vx
        + ball1_platform_R_yx * ball4_base_twist_vy + ball1_platform_R_zx * ball4_base_twist_vz;
    const real ball4_twist_vy = ball1_platform_R_xy * ball4_base_twist_vx
        + ball1_platform_R_yy * ball4_base_twist_vy + ball1_platform_R_zy * ball4_base_twist_vz;
    const real ball4_twist_vz = ball1_platform_R_xz * ball4_base_twist_vx
        + ball1_platform_R_yz * ball4_base_twist_vy + ball1_platform_R_zz * ball4_base_twist_vz;
    work[719] = ball4_twist_vz;
    const real tube4_omega_z_rate = work[692];
    const real tube4_minus_omega_x_rate = work[691];
    const real ball4_minus_base_twist_by_hooke4_wx_rate = tube4_omega_z *
        hooke4_u_angle2_times_angle2_cos + hooke4_angle2_sin * tube4_omega_z_rate
        - (tube4_omega_x * hooke4_u_angle2_times_angle2_sin
        + hooke4_angle2_cos * tube4_minus_omega_x_rate);
    const real hooke4_u_angle1_times_angle1_sin = work[683];
    const real ball4_minus_base_twist_by_hooke4_wy_rate = tube4_omega_x * hooke4_R_yx_rate
        - hooke4_R_yx * tube4_minus_omega_x_rate
        - hooke4_u_angle2 * hooke4_u_angle1_times_angle1_sin
        - (tube4_omega_z * hooke4_minus_R_yz_rate + hooke4_minus_R_yz * tube4_omega_z_rate);
    const real hooke4_u_angle1_times_angle1_cos = work[684];
    const real hooke4_minus_R_zx_rate = work[689];
    const real hooke4_minus_R_zz_rate = work[690];
    const real ball4_minus_base_twist_by_hooke4_wz_rate = hooke4_u_angle2 *
        hooke4_u_angle1_times_angle1_cos - (tube4_omega_x * hooke4_minus_R_zx_rate
        - hooke4_minus_R_zx * tube4_minus_omega_x_rate) + (hooke4_R_zz * tube4_omega_z_rate
        - tube4_omega_z * hooke4_minus_R_zz_rate);
    const real ball4_minus_base_twist_by_hooke4_vx_rate = ball4_minus_base_twist_by_hooke4_wy *
        ball4_child_p_z_rate + ball4_child_p_z * ball4_minus_base_twist_by_hooke4_wy_rate
        - (ball4_minus_base_twist_by_hooke4_wz * ball4_child_p_y_rate
        + ball4_arm_hooke4_y * ball4_minus_base_twist_by_hooke4_wz_rate);
    const real ball4_minus_base_twist_by_hooke4_vy_rate = ball4_minus_base_twist_by_hooke4_wz *
        ball4_child_p_x_rate + ball4_arm_hooke4_x * ball4_minus_base_twist_by_hooke4_wz_rate
        - (ball4_minus_base_twist_by_hooke4_wx * ball4_child_p_z_rate
        + ball4_child_p_z * ball4_minus_base_twist_by_hooke4_wx_rate);
    const real ball4_minus_base_twist_by_hooke4_vz_rate = ball4_minus_base_twist_by_hooke4_wx *
        ball4_child_p_y_rate + ball4_arm_hooke4_y * ball4_minus_base_twist_by_hooke4_wx_rate
        - (ball4_minus_base_twist_by_hooke4_wy * ball4_child_p_x_rate
        + ball4_arm_hooke4_x * ball4_minus_base_twist_by_hooke4_wy_rate);
    const real ball4_base_twist_vx_rate = ball4_base_twist_vx_rate_part_2
        - ball4_minus_base_twist_by_hooke4_vx_rate - slide4_u * hooke4_u_angle2_times_angle2_cos;
    const real ball1_minus_base_twist_by_slide0_vy_rate = work[520];
    const real ball4_base_twist_vy_rate = ball4_base_twist_by_hooke0_vy_rate
        - ball1_minus_base_twist_by_slide0_vy_rate + ball4_base_twist_by_ball0_vy_rate
        - ball4_minus_base_twist_by_hooke4_vy_rate + slide4_u * hooke4_minus_R_yz_rate;
    const real ball1_minus_base_twist_by_slide0_vz_rate = work[521];
    const real ball4_base_twist_vz_rate = ball4_base_twist_by_hooke0_vz_rate
        - ball1_minus_base_twist_by_slide0_vz_rate + ball4_base_twist_by_ball0_vz_rate
        - ball4_minus_base_twist_by_hooke4_vz_rate + slide4_u * hooke4_minus_R_zz_rate;
    const real ball4_twist_vx_rate_part = ball4_base_twist_vx * ball1_platform_R_xx_rate
        + ball1_platform_R_xx * ball4_base_twist_vx_rate
        + (ball4_base_twist_vy * ball1_platform_R_yx_rate
        + ball1_platform_R_yx * ball4_base_twist_vy_rate);
    const real ball4_twist_vx_rate = ball4_base_twist_vz * ball1_platform_R_zx_rate
        + ball1_platform_R_zx * ball4_base_twist_vz_rate + ball4_twist_vx_rate_part;
    work[720] = ball4_twist_vx_rate;
    const real ball4_twist_vy_rate_part = ball4_base_twist_vx * ball1_platform_R_xy_rate
        + ball1_platform_R_xy * ball4_base_twist_vx_rate
        + (ball4_base_twist_vy * ball1_platform_R_yy_rate
        + ball1_platform_R_yy * ball4_base_twist_vy_rate);
    const real ball4_twist_vy_rate = ball4_base_twist_vz * ball1_platform_R_zy_rate
        + ball1_platform_R_zy * ball4_base_twist_vz_rate + ball4_twist_vy_rate_part;
    work[721] = ball4_twist_vy_rate;
    const real ball4_twist_vz_rate_part = ball4_base_twist_vx * ball1_platform_R_xz_rate
        + ball1_platform_R_xz * ball4_base_twist_vx_rate
        + (ball4_base_twist_vy * ball1_platform_R_yz_rate
        + ball1_platform_R_yz * ball4_base_twist_vy_rate);
    const real ball1_platform_R_zz_rate = work[509];
    const real ball4_twist_vz_rate = ball4_base_twist_vz * ball1_platform_R_zz_rate
        + ball1_platform_R_zz * ball4_base_twist_vz_rate + ball4_twist_vz_rate_part;
    work[722] = ball4_twist_vz_rate;
    const real ball4_twist_vx_times_R_xx_rate_plus_R_xx_times_twist_vx_rate = ball4_twist_vx *
        (ball4_R_xx_rate_part - (hooke4_minus_R_zx * ball1_platform_R_zx_rate
        + ball1_platform_R_zx * hooke4_minus_R_zx_rate)) + ball4_R_xx * ball4_twist_vx_rate;
    const real ball4_rate_px_rate_part = ball4_twist_vy * (ball4_R_xy_rate_part
        - (hooke4_minus_R_zx * ball1_platform_R_zy_rate
        + ball1_platform_R_zy * hooke4_minus_R_zx_rate)) + ball4_R_xy * ball4_twist_vy_rate
        + ball4_twist_vx_times_R_xx_rate_plus_R_xx_times_twist_vx_rate;
    work[723] = ball4_rate_px_rate_part;
    const real ball4_twist_vx_times_R_yx_rate = ball4_twist_vx * (hooke4_angle1_cos *
        ball1_platform_R_yx_rate - ball1_platform_R_yx * hooke4_u_angle1_times_angle1_sin
        + (hooke4_angle1_sin * ball1_platform_R_zx_rate
        + ball1_platform_R_zx * hooke4_u_angle1_times_angle1_cos));
    work[724] = ball4_twist_vx_times_R_yx_rate;
    const real ball4_twist_vy_times_R_yy_rate = ball4_twist_vy * (hooke4_angle1_cos *
        ball1_platform_R_yy_rate - ball1_platform_R_yy * hooke4_u_angle1_times_angle1_sin
        + (hooke4_angle1_sin * ball1_platform_R_zy_rate
        + ball1_platform_R_zy * hooke4_u_angle1_times_angle1_cos));
    work[725] = ball4_twist_vy_times_R_yy_rate;
    const real ball4_twist_vz_times_R_yz_rate = ball4_twist_vz * (hooke4_angle1_cos *
        ball1_platform_R_yz_rate - ball1_platform_R_yz * hooke4_u_angle1_times_angle1_sin
        + (hooke4_angle1_sin * ball1_platform_R_zz_rate
        + ball1_platform_R_zz * hooke4_u_angle1_times_angle1_cos));
    work[726] = ball4_twist_vz_times_R_yz_rate;
    const real ball4_twist_vx_times_R_zx_rate_plus_R_zx_times_twist_vx_rate = ball4_twist_vx *
        (hooke4_R_zz * ball1_platform_R_zx_rate - ball1_platform_R_zx * hooke4_minus_R_zz_rate
        + ball4_R_zx_rate_part) + ball4_R_zx * ball4_twist_vx_rate;
    const real ball4_rate_pz_rate_part = ball4_twist_vy * (hooke4_R_zz * ball1_platform_R_zy_rate
        - ball1_platform_R_zy * hooke4_minus_R_zz_rate + ball4_R_zy_rate_part)
        + ball4_R_zy * ball4_twist_vy_rate
        + ball4_twist_vx_times_R_zx_rate_plus_R_zx_times_twist_vx_rate;
    work[727] = ball4_rate_pz_rate_part;

    /* hooke5: R, drift, velocity */
    /* R = R_fixed R_joint(q) */
    /* drift = S' u + [0; omega x v] */
    /* velocity = S u */
    const real hooke5_u_angle1 = u[18]; /* rad/s */
    const real hooke5_u_angle2 = u[19]; /* rad/s */
    const real hooke5_angle1_sin = work[411];
    const real hooke5_angle2_sin = work[413];
    const real hooke5_R_yx = hooke5_angle1_sin * hooke5_angle2_sin;
    const real hooke5_angle2_cos = work[412];
    const real hooke5_minus_R_yz = hooke5_angle1_sin * hooke5_angle2_cos;
    const real hooke5_angle1_cos = work[410];
    const real hooke5_minus_R_zx = hooke5_angle1_cos * hooke5_angle2_sin;
    work[728] = hooke5_minus_R_zx;
    const real hooke5_R_zz = hooke5_angle1_cos * hooke5_angle2_cos;
    work[729] = hooke5_R_zz;
    const real hooke5_u_angle1_times_u_angle2 = hooke5_u_angle1 * hooke5_u_angle2;
    const real hooke5_minus_drift_relative_wx = hooke5_angle2_sin * hooke5_u_angle1_times_u_angle2;
    work[730] = hooke5_minus_drift_relative_wx;
    const real hooke5_u_angle1_times_angle1_sin = hooke5_u_angle1 * hooke5_angle1_sin;
    const real hooke5_u_angle1_times_angle1_cos = hooke5_u_angle1 * hooke5_angle1_cos;
    const real hooke5_u_angle2_times_angle2_sin = hooke5_u_angle2 * hooke5_angle2_sin;
    const real hooke5_u_angle2_times_angle2_cos = hooke5_u_angle2 * hooke5_angle2_cos;
    const real hooke5_R_yx_rate = hooke5_angle2_sin * hooke5_u_angle1_times_angle1_cos
        + hooke5_angle1_sin * hooke5_u_angle2_times_angle2_cos;
    const real hooke5_minus_R_yz_rate = hooke5_angle2_cos * hooke5_u_angle1_times_angle1_cos
        - hooke5_angle1_sin * hooke5_u_angle2_times_angle2_sin;
    const real hooke5_minus_R_zx_rate = hooke5_angle1_cos * hooke5_u_angle2_times_angle2_cos
        - hooke5_angle2_sin * hooke5_u_angle1_times_angle1_sin;
    work[731] = hooke5_minus_R_zx_rate;
    const real hooke5_minus_R_zz_rate = hooke5_angle2_cos * hooke5_u_angle1_times_angle1_sin
        + hooke5_angle1_cos * hooke5_u_angle2_times_angle2_sin;
    work[732] = hooke5_minus_R_zz_rate;
    const real tube5_minus_omega_x_rate = hooke5_u_angle1 * hooke5_u_angle2_times_angle2_sin;
    const real tube5_omega_z_rate = hooke5_u_angle1 * hooke5_u_angle2_times_angle2_cos;

    /* ball5: pose, twist, G */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* G = d(rate) / du */
    const wreal hooke5_position_x = w[30]; /* m */
    const wreal hooke5_position_y = w[31]; /* m */
    const wreal ball5_child_position_x_minus_ball0_child_position_x = w[42];
    const wreal ball5_child_position_y_minus_ball0_child_position_y = w[43];
    const real ball5_child_p_x = ball5_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_xx
        + ball5_child_position_y_minus_ball0_child_position_y * ball1_platform_R_xy
        + ball1_platform_p_x;
    const real ball5_child_p_y = ball5_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_yx
        + ball5_child_position_y_minus_ball0_child_position_y * ball1_platform_R_yy
        + ball1_platform_p_y;
    const real ball5_child_p_z = ball5_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_zx
        + ball5_child_position_y_minus_ball0_child_position_y * ball1_platform_R_zy
        + ball1_platform_p_z;
    const real ball5_R_xx = ball1_platform_R_xx * hooke5_angle2_cos
        + ball1_platform_R_yx * hooke5_R_yx - ball1_platform_R_zx * hooke5_minus_R_zx;
    const real ball5_R_xy = ball1_platform_R_xy * hooke5_angle2_cos
        + ball1_platform_R_yy * hooke5_R_yx - ball1_platform_R_zy * hooke5_minus_R_zx;
    const real ball5_R_xz = ball1_platform_R_xz * hooke5_angle2_cos
        + ball1_platform_R_yz * hooke5_R_yx - ball1_platform_R_zz * hooke5_minus_R_zx;
    work[733] = ball5_R_xz;
    const real ball5_R_yx = ball1_platform_R_yx * hooke5_angle1_cos
        + ball1_platform_R_zx * hooke5_angle1_sin;
    work[734] = ball5_R_yx;
    const real ball5_R_yy = ball1_platform_R_yy * hooke5_angle1_cos
        + ball1_platform_R_zy * hooke5_angle1_sin;
    work[735] = ball5_R_yy;
    const real ball5_R_yz = ball1_platform_R_yz * hooke5_angle1_cos
        + ball1_platform_R_zz * hooke5_angle1_sin;
    work[736] = ball5_R_yz;
    const real ball5_R_zx = ball1_platform_R_xx * hooke5_angle2_sin
        - ball1_platform_R_yx * hooke5_minus_R_yz + ball1_platform_R_zx * hooke5_R_zz;
    const real ball5_R_zy = ball1_platform_R_xy * hooke5_angle2_sin
        - ball1_platform_R_yy * hooke5_minus_R_yz + ball1_platform_R_zy * hooke5_R_zz;
    const real ball5_R_zz = ball1_platform_R_xz * hooke5_angle2_sin
        - ball1_platform_R_yz * hooke5_minus_R_yz + ball1_platform_R_zz * hooke5_R_zz;
    work[737] = ball5_R_zz;
    const real ball5_arm_hooke0_x = ball5_child_p_x - hooke0_position_x;
    const real ball5_arm_hooke0_y = ball5_child_p_y - hooke0_position_y;
    const real ball5_base_twist_hooke0_angle1_vx = ball1_base_twist_hooke0_angle1_wy *
        ball5_child_p_z - ball1_base_twist_hooke0_angle1_wz * ball5_arm_hooke0_y;
    const real ball5_base_twist_hooke0_angle1_vy = ball1_base_twist_hooke0_angle1_wz *
        ball5_arm_hooke0_x - ball1_base_twist_hooke0_angle1_wx * ball5_child_p_z;
    const real ball5_base_twist_hooke0_angle1_vz = ball1_base_twist_hooke0_angle1_wx *
        ball5_arm_hooke0_y - ball1_base_twist_hooke0_angle1_wy * ball5_arm_hooke0_x;
    const real ball5_base_twist_hooke0_angle2_vx = hooke0_angle1_cos * ball5_child_p_z
        - hooke0_angle1_sin * ball5_arm_hooke0_y;
    const real ball5_base_twist_hooke0_angle2_vy = hooke0_angle1_sin * ball5_arm_hooke0_x;
    const real ball5_minus_base_twist_hooke0_angle2_vz = hooke0_angle1_cos * ball5_arm_hooke0_x;
    const real ball5_arm_ball0_x = ball5_child_p_x - ball1_platform_p_x;
    const real ball5_arm_ball0_y = ball5_child_p_y - ball1_platform_p_y;
    const real ball5_arm_ball0_z = ball5_child_p_z - ball1_platform_p_z;
    const real ball5_base_twist_ball0_x_vx = ball1_platform_R_yx * ball5_arm_ball0_z
        - ball1_platform_R_zx * ball5_arm_ball0_y;
    const real ball5_base_twist_ball0_x_vy = ball1_platform_R_zx * ball5_arm_ball0_x
        - ball1_platform_R_xx * ball5_arm_ball0_z;
    const real ball5_base_twist_ball0_x_vz = ball1_platform_R_xx * ball5_arm_ball0_y
        - ball1_platform_R_yx * ball5_arm_ball0_x;
    const real ball5_base_twist_ball0_y_vx = ball1_platform_R_yy * ball5_arm_ball0_z
        - ball1_platform_R_zy * ball5_arm_ball0_y;
    const real ball5_base_twist_ball0_y_vy = ball1_platform_R_zy * ball5_arm_ball0_x
        - ball1_platform_R_xy * ball5_arm_ball0_z;
    const real ball5_base_twist_ball0_y_vz = ball1_platform_R_xy * ball5_arm_ball0_y
        - ball1_platform_R_yy * ball5_arm_ball0_x;
    const real ball5_base_twist_ball0_z_vx = ball1_platform_R_yz * ball5_arm_ball0_z
        - ball1_platform_R_zz * ball5_arm_ball0_y;
    const real ball5_base_twist_ball0_z_vy = ball1_platform_R_zz * ball5_arm_ball0_x
        - ball1_platform_R_xz * ball5_arm_ball0_z;
    const real ball5_base_twist_ball0_z_vz = ball1_platform_R_xz * ball5_arm_ball0_y
        - ball1_platform_R_yz * ball5_arm_ball0_x;
    const real ball5_base_twist_vx_part = ball1_base_twist_by_hooke0_wy * ball5_child_p_z
        - ball1_base_twist_by_hooke0_wz * ball5_arm_hooke0_y + ball1_base_twist_by_slide0_vx
        + (ball1_base_twist_by_ball0_wy * ball5_arm_ball0_z
        - ball1_base_twist_by_ball0_wz * ball5_arm_ball0_y);
    const real ball5_base_twist_vy_part = ball1_base_twist_by_hooke0_wz * ball5_arm_hooke0_x
        - ball1_base_twist_by_hooke0_wx * ball5_child_p_z - ball1_minus_base_twist_by_slide0_vy
        + (ball1_base_twist_by_ball0_wz * ball5_arm_ball0_x
        - ball1_base_twist_by_ball0_wx * ball5_arm_ball0_z);
    const real ball5_base_twist_vz_part = ball1_base_twist_by_hooke0_wx * ball5_arm_hooke0_y
        - ball1_base_twist_by_hooke0_wy * ball5_arm_hooke0_x + ball1_base_twist_by_slide0_vz
        + (ball1_base_twist_by_ball0_wx * ball5_arm_ball0_y
        - ball1_base_twist_by_ball0_wy * ball5_arm_ball0_x);
    const real ball5_arm_hooke5_x = ball5_child_p_x - hooke5_position_x;
    const real ball5_arm_hooke5_y = ball5_child_p_y - hooke5_position_y;
    const real ball5_minus_base_twist_hooke5_angle1_wx = hooke5_angle2_cos * hooke5_angle2_cos
        + hooke5_angle2_sin * hooke5_angle2_sin;
    const real ball5_minus_base_twist_hooke5_angle1_wy = hooke5_angle2_cos * hooke5_R_yx
        - hooke5_angle2_sin * hooke5_minus_R_yz;
    const real ball5_minus_base_twist_hooke5_angle1_wz = hooke5_angle2_sin * hooke5_R_zz
        - hooke5_angle2_cos * hooke5_minus_R_zx;
    const real ball5_minus_base_twist_hooke5_angle1_vx = ball5_child_p_z *
        ball5_minus_base_twist_hooke5_angle1_wy
        - ball5_arm_hooke5_y * ball5_minus_base_twist_hooke5_angle1_wz;
    const real ball5_minus_base_twist_hooke5_angle1_vy = ball5_arm_hooke5_x *
        ball5_minus_base_twist_hooke5_angle1_wz
        - ball5_child_p_z * ball5_minus_base_twist_hooke5_angle1_wx;
    const real ball5_minus_base_twist_hooke5_angle1_vz = ball5_arm_hooke5_y *
        ball5_minus_base_twist_hooke5_angle1_wx
        - ball5_arm_hooke5_x * ball5_minus_base_twist_hooke5_angle1_wy;
    const real ball5_minus_base_twist_hooke5_angle2_vx = hooke5_angle1_cos * ball5_child_p_z
        - hooke5_angle1_sin * ball5_arm_hooke5_y;
    const real ball5_minus_base_twist_hooke5_angle2_vy = hooke5_angle1_sin * ball5_arm_hooke5_x;
    const real ball5_base_twist_hooke5_angle2_vz = hooke5_angle1_cos * ball5_arm_hooke5_x;
    const real ball5_twist_hooke0_angle1_vx = ball1_platform_R_xx *
        ball5_base_twist_hooke0_angle1_vx
        + ball1_platform_R_yx * ball5_base_twist_hooke0_angle1_vy
        + ball1_platform_R_zx * ball5_base_twist_hooke0_angle1_vz;
    const real ball5_twist_hooke0_angle1_vy = ball1_platform_R_xy *
        ball5_base_twist_hooke0_angle1_vx
        + ball1_platform_R_yy * ball5_base_twist_hooke0_angle1_vy
        + ball1_platform_R_zy * ball5_base_twist_hooke0_angle1_vz;
    const real ball5_twist_hooke0_angle1_vz = ball1_platform_R_xz *
        ball5_base_twist_hooke0_angle1_vx
        + ball1_platform_R_yz * ball5_base_twist_hooke0_angle1_vy
        + ball1_platform_R_zz * ball5_base_twist_hooke0_angle1_vz;
    const real ball5_twist_hooke0_angle2_vx = ball1_platform_R_xx *
        ball5_base_twist_hooke0_angle2_vx
        + ball1_platform_R_yx * ball5_base_twist_hooke0_angle2_vy
        - ball1_platform_R_zx * ball5_minus_base_twist_hooke0_angle2_vz;
    const real ball5_twist_hooke0_angle2_vy = ball1_platform_R_xy *
        ball5_base_twist_hooke0_angle2_vx
        + ball1_platform_R_yy * ball5_base_twist_hooke0_angle2_vy
        - ball1_platform_R_zy * ball5_minus_base_twist_hooke0_angle2_vz;
    const real ball5_twist_hooke0_angle2_vz = ball1_platform_R_xz *
        ball5_base_twist_hooke0_angle2_vx
        + ball1_platform_R_yz * ball5_base_twist_hooke0_angle2_vy
        - ball1_platform_R_zz * ball5_minus_base_twist_hooke0_angle2_vz;
    const real ball5_twist_ball0_x_vx = ball1_platform_R_xx * ball5_base_twist_ball0_x_vx
        + ball1_platform_R_yx * ball5_base_twist_ball0_x_vy
        + ball1_platform_R_zx * ball5_base_twist_ball0_x_vz;
    const real ball5_twist_ball0_x_vy = ball1_platform_R_xy * ball5_base_twist_ball0_x_vx
        + ball1_platform_R_yy * ball5_base_twist_ball0_x_vy
        + ball1_platform_R_zy * ball5_base_twist_ball0_x_vz;
    const real ball5_twist_ball0_x_vz = ball1_platform_R_xz * ball5_base_twist_ball0_x_vx
        + ball1_platform_R_yz * ball5_base_twist_ball0_x_vy
        + ball1_platform_R_zz * ball5_base_twist_ball0_x_vz;
    const real ball5_twist_ball0_y_vx = ball1_platform_R_xx * ball5_base_twist_ball0_y_vx
        + ball1_platform_R_yx * ball5_base_twist_ball0_y_vy
        + ball1_platform_R_zx * ball5_base_twist_ball0_y_vz;
    const real ball5_twist_ball0_y_vy = ball1_platform_R_xy * ball5_base_twist_ball0_y_vx
        + ball1_platform_R_yy * ball5_base_twist_ball0_y_vy
        + ball1_platform_R_zy * ball5_base_twist_ball0_y_vz;
    const real ball5_twist_ball0_y_vz = ball1_platform_R_xz * ball5_base_twist_ball0_y_vx
        + ball1_platform_R_yz * ball5_base_twist_ball0_y_vy
        + ball1_platform_R_zz * ball5_base_twist_ball0_y_vz;
    const real ball5_twist_ball0_z_vx = ball1_platform_R_xx * ball5_base_twist_ball0_z_vx
        + ball1_platform_R_yx * ball5_base_twist_ball0_z_vy
        + ball1_platform_R_zx * ball5_base_twist_ball0_z_vz;
    const real ball5_twist_ball0_z_vy = ball1_platform_R_xy * ball5_base_twist_ball0_z_vx
        + ball1_platform_R_yy * ball5_base_twist_ball0_z_vy
        + ball1_platform_R_zy * ball5_base_twist_ball0_z_vz;
    const real ball5_twist_ball0_z_vz = ball1_platform_R_xz * ball5_base_twist_ball0_z_vx
        + ball1_platform_R_yz * ball5_base_twist_ball0_z_vy
        + ball1_platform_R_zz * ball5_base_twist_ball0_z_vz;
    const real ball5_minus_twist_hooke5_angle1_vx = ball1_platform_R_xx *
        ball5_minus_base_twist_hooke5_angle1_vx
        + ball1_platform_R_yx * ball5_minus_base_twist_hooke5_angle1_vy
        + ball1_platform_R_zx * ball5_minus_base_twist_hooke5_angle1_vz;
    const real ball5_minus_twist_hooke5_angle1_vy = ball1_platform_R_xy *
        ball5_minus_base_twist_hooke5_angle1_vx
        + ball1_platform_R_yy * ball5_minus_base_twist_hooke5_angle1_vy
        + ball1_platform_R_zy * ball5_minus_base_twist_hooke5_angle1_vz;
    const real ball5_minus_twist_hooke5_angle1_vz = ball1_platform_R_xz *
        ball5_minus_base_twist_hooke5_angle1_vx
        + ball1_platform_R_yz * ball5_minus_base_twist_hooke5_angle1_vy
        + ball1_platform_R_zz * ball5_minus_base_twist_hooke5_angle1_vz;
    const real ball5_twist_hooke5_angle2_vx = ball1_platform_R_zx *
        ball5_base_twist_hooke5_angle2_vz
        - (ball1_platform_R_xx * ball5_minus_base_twist_hooke5_angle2_vx
        + ball1_platform_R_yx * ball5_minus_base_twist_hooke5_angle2_vy);
    const real ball5_twist_hooke5_angle2_vy = ball1_platform_R_zy *
        ball5_base_twist_hooke5_angle2_vz
        - (ball1_platform_R_xy * ball5_minus_base_twist_hooke5_angle2_vx
        + ball1_platform_R_yy * ball5_minus_base_twist_hooke5_angle2_vy);
    const real ball5_twist_hooke5_angle2_vz = ball1_platform_R_zz *
        ball5_base_twist_hooke5_angle2_vz
        - (ball1_platform_R_xz * ball5_minus_base_twist_hooke5_angle2_vx
        + ball1_platform_R_yz * ball5_minus_base_twist_hooke5_angle2_vy);
    const real ball5_G_px_hooke0_angle1 = ball5_R_xx * ball5_twist_hooke0_angle1_vx
        + ball5_R_xy * ball5_twist_hooke0_angle1_vy + ball5_R_xz * ball5_twist_hooke0_angle1_vz;
    work[738] = ball5_G_px_hooke0_angle1;
    const real ball5_G_px_hooke0_angle2 = ball5_R_xx * ball5_twist_hooke0_angle2_vx
        + ball5_R_xy * ball5_twist_hooke0_angle2_vy + ball5_R_xz * ball5_twist_hooke0_angle2_vz;
    work[739] = ball5_G_px_hooke0_angle2;
    const real ball5_G_px_slide0 = ball1_twist_slide0_vx * ball5_R_xx
        + ball1_twist_slide0_vy * ball5_R_xy + ball1_twist_slide0_vz * ball5_R_xz;
    work[740] = ball5_G_px_slide0;
    const real ball5_G_px_ball0_x = ball5_R_xx * ball5_twist_ball0_x_vx
        + ball5_R_xy * ball5_twist_ball0_x_vy + ball5_R_xz * ball5_twist_ball0_x_vz;
    work[741] = ball5_G_px_ball0_x;
    const real ball5_G_px_ball0_y = ball5_R_xx * ball5_twist_ball0_y_vx
        + ball5_R_xy * ball5_twist_ball0_y_vy + ball5_R_xz * ball5_twist_ball0_y_vz;
    work[742] = ball5_G_px_ball0_y;
    const real ball5_G_px_ball0_z = ball5_R_xx * ball5_twist_ball0_z_vx
        + ball5_R_xy * ball5_twist_ball0_z_vy + ball5_R_xz * ball5_twist_ball0_z_vz;
    work[743] = ball5_G_px_ball0_z;
    const real ball5_minus_G_px_hooke5_angle1 = ball5_R_xx * ball5_minus_twist_hooke5_angle1_vx
        + ball5_R_xy * ball5_minus_twist_hooke5_angle1_vy
        + ball5_R_xz * ball5_minus_twist_hooke5_angle1_vz;
    work[744] = ball5_minus_G_px_hooke5_angle1;
    const real ball5_G_px_hooke5_angle2 = ball5_R_xx * ball5_twist_hooke5_angle2_vx
        + ball5_R_xy * ball5_twist_hooke5_angle2_vy + ball5_R_xz * ball5_twist_hooke5_angle2_vz;
    work[745] = ball5_G_px_hooke5_angle2;
    const real ball5_minus_G_px_slide5 = ball5_R_xx * ball5_R_zx + ball5_R_xy * ball5_R_zy
        + ball5_R_xz * ball5_R_zz;
    work[746] = ball5_minus_G_px_slide5;
    const real ball5_G_py_hooke0_angle1 = ball5_R_yx * ball5_twist_hooke0_angle1_vx
        + ball5_R_yy * ball5_twist_hooke0_angle1_vy + ball5_R_yz * ball5_twist_hooke0_angle1_vz;
    work[747] = ball5_G_py_hooke0_angle1;
    const real ball5_G_py_hooke0_angle2 = ball5_R_yx * ball5_twist_hooke0_angle2_vx
        + ball5_R_yy * ball5_twist_hooke0_angle2_vy + ball5_R_yz * ball5_twist_hooke0_angle2_vz;
    work[748] = ball5_G_py_hooke0_angle2;
    const real ball5_G_py_slide0 = ball1_twist_slide0_vx * ball5_R_yx
        + ball1_twist_slide0_vy * ball5_R_yy + ball1_twist_slide0_vz * ball5_R_yz;
    work[749] = ball5_G_py_slide0;
    const real ball5_G_py_ball0_x = ball5_R_yx * ball5_twist_ball0_x_vx
        + ball5_R_yy * ball5_twist_ball0_x_vy + ball5_R_yz * ball5_twist_ball0_x_vz;
    work[750] = ball5_G_py_ball0_x;
    const real ball5_G_py_ball0_y = ball5_R_yx * ball5_twist_ball0_y_vx
        + ball5_R_yy * ball5_twist_ball0_y_vy + ball5_R_yz * ball5_twist_ball0_y_vz;
    work[751] = ball5_G_py_ball0_y;
    const real ball5_G_py_ball0_z = ball5_R_yx * ball5_twist_ball0_z_vx
        + ball5_R_yy * ball5_twist_ball0_z_vy + ball5_R_yz * ball5_twist_ball0_z_vz;
    work[752] = ball5_G_py_ball0_z;
    const real ball5_minus_G_py_hooke5_angle1 = ball5_R_yx * ball5_minus_twist_hooke5_angle1_vx
        + ball5_R_yy * ball5_minus_twist_hooke5_angle1_vy
        + ball5_R_yz * ball5_minus_twist_hooke5_angle1_vz;
    work[753] = ball5_minus_G_py_hooke5_angle1;
    const real ball5_G_py_hooke5_angle2 = ball5_R_yx * ball5_twist_hooke5_angle2_vx
        + ball5_R_yy * ball5_twist_hooke5_angle2_vy + ball5_R_yz * ball5_twist_hooke5_angle2_vz;
    work[754] = ball5_G_py_hooke5_angle2;
    const real ball5_minus_G_py_slide5 = ball5_R_yx * ball5_R_zx + ball5_R_yy * ball5_R_zy
        + ball5_R_yz * ball5_R_zz;
    work[755] = ball5_minus_G_py_slide5;
    const real ball5_G_pz_hooke0_angle1 = ball5_R_zx * ball5_twist_hooke0_angle1_vx
        + ball5_R_zy * ball5_twist_hooke0_angle1_vy + ball5_R_zz * ball5_twist_hooke0_angle1_vz;
    work[756] = ball5_G_pz_hooke0_angle1;
    const real ball5_G_pz_hooke0_angle2 = ball5_R_zx * ball5_twist_hooke0_angle2_vx
        + ball5_R_zy * ball5_twist_hooke0_angle2_vy + ball5_R_zz * ball5_twist_hooke0_angle2_vz;
    work[757] = ball5_G_pz_hooke0_angle2;
    const real ball5_G_pz_slide0 = ball1_twist_slide0_vx * ball5_R_zx
        + ball1_twist_slide0_vy * ball5_R_zy + ball1_twist_slide0_vz * ball5_R_zz;
    work[758] = ball5_G_pz_slide0;
    const real ball5_G_pz_ball0_x = ball5_R_zx * ball5_twist_ball0_x_vx
        + ball5_R_zy * ball5_twist_ball0_x_vy + ball5_R_zz * ball5_twist_ball0_x_vz;
    work[759] = ball5_G_pz_ball0_x;
    const real ball5_G_pz_ball0_y = ball5_R_zx * ball5_twist_ball0_y_vx
        + ball5_R_zy * ball5_twist_ball0_y_vy + ball5_R_zz * ball5_twist_ball0_y_vz;
    work[760] = ball5_G_pz_ball0_y;
    const real ball5_G_pz_ball0_z = ball5_R_zx * ball5_twist_ball0_z_vx
        + ball5_R_zy * ball5_twist_ball0_z_vy + ball5_R_zz * ball5_twist_ball0_z_vz;
    work[761] = ball5_G_pz_ball0_z;
    const real ball5_minus_G_pz_hooke5_angle1 = ball5_R_zx * ball5_minus_twist_hooke5_angle1_vx
        + ball5_R_zy * ball5_minus_twist_hooke5_angle1_vy
        + ball5_R_zz * ball5_minus_twist_hooke5_angle1_vz;
    work[762] = ball5_minus_G_pz_hooke5_angle1;
    const real ball5_G_pz_hooke5_angle2 = ball5_R_zx * ball5_twist_hooke5_angle2_vx
        + ball5_R_zy * ball5_twist_hooke5_angle2_vy + ball5_R_zz * ball5_twist_hooke5_angle2_vz;
    work[763] = ball5_G_pz_hooke5_angle2;
    const real ball5_minus_G_pz_slide5 = ball5_R_zx * ball5_R_zx + ball5_R_zy * ball5_R_zy
        + ball5_R_zz * ball5_R_zz;
    work[764] = ball5_minus_G_pz_slide5;
    const real ball5_child_p_x_rate = ball5_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_xx_rate
        + ball5_child_position_y_minus_ball0_child_position_y * ball1_platform_R_xy_rate
        + ball1_platform_p_x_rate;
    const real ball5_child_p_y_rate = ball5_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_yx_rate
        + ball5_child_position_y_minus_ball0_child_position_y * ball1_platform_R_yy_rate
        - ball1_minus_platform_p_y_rate;
    const real ball5_child_p_z_rate = ball5_child_position_x_minus_ball0_child_position_x *
        ball1_platform_R_zx_rate
        + ball5_child_position_y_minus_ball0_child_position_y * ball1_platform_R_zy_rate
        + ball1_platform_p_z_rate;
    const real ball5_R_xx_rate_part = hooke5_angle2_cos * ball1_platform_R_xx_rate
        - ball1_platform_R_xx * hooke5_u_angle2_times_angle2_sin
        + (hooke5_R_yx * ball1_platform_R_yx_rate + ball1_platform_R_yx * hooke5_R_yx_rate);
    const real ball5_R_xy_rate_part = hooke5_angle2_cos * ball1_platform_R_xy_rate
        - ball1_platform_R_xy * hooke5_u_angle2_times_angle2_sin
        + (hooke5_R_yx * ball1_platform_R_yy_rate + ball1_platform_R_yy * hooke5_R_yx_rate);
    const real ball5_R_xz_rate_part = hooke5_angle2_cos * ball1_platform_R_xz_rate
        - ball1_platform_R_xz * hooke5_u_angle2_times_angle2_sin
        + (hooke5_R_yx * ball1_platform_R_yz_rate + ball1_platform_R_yz * hooke5_R_yx_rate);
    work[765] = ball5_R_xz_rate_part;
    const real ball5_R_zx_rate_part = hooke5_angle2_sin * ball1_platform_R_xx_rate
        + ball1_platform_R_xx * hooke5_u_angle2_times_angle2_cos
        - (hooke5_minus_R_yz * ball1_platform_R_yx_rate
        + ball1_platform_R_yx * hooke5_minus_R_yz_rate);
    const real ball5_R_zy_rate_part = hooke5_angle2_sin * ball1_platform_R_xy_rate
        + ball1_platform_R_xy * hooke5_u_angle2_times_angle2_cos
        - (hooke5_minus_R_yz * ball1_platform_R_yy_rate
        + ball1_platform_R_yy * hooke5_minus_R_yz_rate);
    const real ball5_R_zz_rate_part = hooke5_angle2_sin * ball1_platform_R_xz_rate
        + ball1_platform_R_xz * hooke5_u_angle2_times_angle2_cos
        - (hooke5_minus_R_yz * ball1_platform_R_yz_rate
        + ball1_platform_R_yz * hooke5_minus_R_yz_rate);
    work[766] = ball5_R_zz_rate_part;
    const real ball5_base_twist_by_hooke0_vy_rate = ball5_arm_hooke0_x *
        ball1_base_twist_by_hooke0_wz_rate + ball1_base_twist_by_hooke0_wz * ball5_child_p_x_rate
        - (ball5_child_p_z * ball1_base_twist_by_hooke0_wx_rate
        + ball1_base_twist_by_hooke0_wx * ball5_child_p_z_rate);
    const real ball5_base_twist_by_hooke0_vz_rate = ball5_arm_hooke0_y *
        ball1_base_twist_by_hooke0_wx_rate + ball1_base_twist_by_hooke0_wx * ball5_child_p_y_rate
        - (ball5_arm_hooke0_x * ball1_base_twist_by_hooke0_wy_rate
        + ball1_base_twist_by_hooke0_wy * ball5_child_p_x_rate);
    const real ball5_base_twist_vx_rate_part = ball5_child_p_z * ball1_base_twist_by_hooke0_wy_rate
        + ball1_base_twist_by_hooke0_wy * ball5_child_p_z_rate
        - (ball5_arm_hooke0_y * ball1_base_twist_by_hooke0_wz_rate
        + ball1_base_twist_by_hooke0_wz * ball5_child_p_y_rate)
        + ball1_base_twist_by_slide0_vx_rate;
    const real ball5_arm_ball0_x_rate = ball5_child_p_x_rate - ball1_platform_p_x_rate;
    const real ball5_arm_ball0_y_rate = ball1_minus_platform_p_y_rate + ball5_child_p_y_rate;
    const real ball5_arm_ball0_z_rate = ball5_child_p_z_rate - ball1_platform_p_z_rate;
    const real ball5_base_twist_by_ball0_vy_rate = ball5_arm_ball0_x *
        ball1_base_twist_by_ball0_wz_rate + ball1_base_twist_by_ball0_wz * ball5_arm_ball0_x_rate
        - (ball5_arm_ball0_z * ball1_base_twist_by_ball0_wx_rate
        + ball1_base_twist_by_ball0_wx * ball5_arm_ball0_z_rate);
    const real ball5_base_twist_by_ball0_vz_rate = ball5_arm_ball0_y *
        ball1_base_twist_by_ball0_wx_rate + ball1_base_twist_by_ball0_wx * ball5_arm_ball0_y_rate
        - (ball5_arm_ball0_x * ball1_base_twist_by_ball0_wy_rate
        + ball1_base_twist_by_ball0_wy * ball5_arm_ball0_x_rate);
    const real ball5_base_twist_vx_rate_part_2 = ball5_arm_ball0_z *
        ball1_base_twist_by_ball0_wy_rate + ball1_base_twist_by_ball0_wy * ball5_arm_ball0_z_rate
        - (ball5_arm_ball0_y * ball1_base_twist_by_ball0_wz_rate
        + ball1_base_twist_by_ball0_wz * ball5_arm_ball0_y_rate) + ball5_base_twist_vx_rate_part;

    /* tube5: omega, alpha, inertia, composite, a, U */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    const real slide5_q = q[21]; /* m */
    const wreal half_rod5_mass = w[52];
    const wreal rod5_base_moment_z = w[53];
    const wreal tube5_base_inertia_xx = w[54];
    const wreal tube5_base_inertia_yy = w[55];
    const real tube5_omega_x = hooke5_u_angle1 * hooke5_angle2_cos;
    work[767] = tube5_omega_x;
    const real tube5_omega_z = hooke5_u_angle1 * hooke5_angle2_sin;
    work[768] = tube5_omega_z;
    const real tube5_alpha_z = hooke5_angle2_cos * hooke5_u_angle1_times_u_angle2;
    work[769] = tube5_alpha_z;
    const real tube5_inertia_shift = slide5_q * (rod5_base_moment_z
        + slide5_q * half_rod5_mass) * 2.0;
    const real tube5_composite_inertia_xx = tube5_base_inertia_xx + tube5_inertia_shift;
    const real tube5_composite_inertia_yy = tube5_base_inertia_yy + tube5_inertia_shift;
    work[770] = tube5_composite_inertia_yy;
    const real tube5_a_x = gravity_z * hooke5_minus_R_zx;
    work[771] = tube5_a_x;
    const real tube5_minus_a_y = gravity_z * hooke5_angle1_sin;
    work[772] = tube5_minus_a_y;
    const real tube5_U_xz = tube5_omega_x * tube5_omega_z;
    work[773] = tube5_U_xz;

    /* ball5: twist, rate */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* rate = G u + g_t */
    const real slide5_u = u[20]; /* m/s */
    const real ball5_minus_base_twist_by_hooke5_wx = hooke5_angle2_cos * tube5_omega_x
        + hooke5_angle2_sin * tube5_omega_z;
    const real ball5_minus_base_twist_by_hooke5_wy = hooke5_R_yx * tube5_omega_x
        + hooke5_u_angle2 * hooke5_angle1_cos - hooke5_minus_R_yz * tube5_omega_z;
    const real ball5_minus_base_twist_by_hooke5_wz = hooke5_u_angle2 * hooke5_angle1_sin
        - hooke5_minus_R_zx * tube5_omega_x + hooke5_R_zz * tube5_omega_z;
    const real ball5_base_twist_vx = ball5_base_twist_vx_part
        - (ball5_child_p_z * ball5_minus_base_twist_by_hooke5_wy
        - ball5_arm_hooke5_y * ball5_minus_base_twist_by_hooke5_wz) - slide5_u * hooke5_angle2_sin;
    const real ball5_base_twist_vy = ball5_base_twist_vy_part
        - (ball5_arm_hooke5_x * ball5_minus_base_twist_by_hooke5_wz
        - ball5_child_p_z * ball5_minus_base_twist_by_hooke5_wx) + slide5_u * hooke5_minus_R_yz;
    const real ball5_base_twist_vz = ball5_base_twist_vz_part
        - (ball5_arm_hooke5_y * ball5_minus_base_twist_by_hooke5_wx
        - ball5_arm_hooke5_x * ball5_minus_base_twist_by_hooke5_wy) - slide5_u * hooke5_R_zz;
    const real ball5_twist_vx = ball1_platform_R_xx * ball5_base_twist_vx
        + ball1_platform_R_yx * ball5_base_twist_vy + ball1_platform_R_zx * ball5_base_twist_vz;
    const real ball5_twist_vy = ball1_platform_R_xy * ball5_base_twist_vx
        + ball1_platform_R_yy * ball5_base_twist_vy + ball1_platform_R_zy * ball5_base_twist_vz;
    const real ball5_twist_vz = ball1_platform_R_xz * ball5_base_twist_vx
        + ball1_platform_R_yz * ball5_base_twist_vy + ball1_platform_R_zz * ball5_base_twist_vz;
    work[774] = ball5_twist_vz;
    const real ball5_minus_base_twist_by_hooke5_wx_rate = tube5_omega_z *
        hooke5_u_angle2_times_angle2_cos + hooke5_angle2_sin * tube5_omega_z_rate
        - (tube5_omega_x * hooke5_u_angle2_times_angle2_sin
        + hooke5_angle2_cos * tube5_minus_omega_x_rate);
    const real ball5_minus_base_twist_by_hooke5_wy_rate = tube5_omega_x * hooke5_R_yx_rate
        - hooke5_R_yx * tube5_minus_omega_x_rate
        - hooke5_u_angle2 * hooke5_u_angle1_times_angle1_sin
        - (tube5_omega_z * hooke5_minus_R_yz_rate + hooke5_minus_R_yz * tube5_omega_z_rate);
    const real ball5_minus_base_twist_by_hooke5_wz_rate = hooke5_u_angle2 *
        hooke5_u_angle1_times_angle1_cos - (tube5_omega_x * hooke5_minus_R_zx_rate
        - hooke5_minus_R_zx * tube5_minus_omega_x_rate) + (hooke5_R_zz * tube5_omega_z_rate
        - tube5_omega_z * hooke5_minus_R_zz_rate);
    const real ball5_minus_base_twist_by_hooke5_vx_rate = ball5_minus_base_twist_by_hooke5_wy *
        ball5_child_p_z_rate + ball5_child_p_z * ball5_minus_base_twist_by_hooke5_wy_rate
        - (ball5_minus_base_twist_by_hooke5_wz * ball5_child_p_y_rate
        + ball5_arm_hooke5_y * ball5_minus_base_twist_by_hooke5_wz_rate);
    const real ball5_minus_base_twist_by_hooke5_vy_rate = ball5_minus_base_twist_by_hooke5_wz *
        ball5_child_p_x_rate + ball5_arm_hooke5_x * ball5_minus_base_twist_by_hooke5_wz_rate
        - (ball5_minus_base_twist_by_hooke5_wx * ball5_child_p_z_rate
        + ball5_child_p_z * ball5_minus_base_twist_by_hooke5_wx_rate);
    const real ball5_minus_base_twist_by_hooke5_vz_rate = ball5_minus_base_twist_by_hooke5_wx *
        ball5_child_p_y_rate + ball5_arm_hooke5_y * ball5_minus_base_twist_by_hooke5_wx_rate
        - (ball5_minus_base_twist_by_hooke5_wy * ball5_child_p_x_rate
        + ball5_arm_hooke5_x * ball5_minus_base_twist_by_hooke5_wy_rate);
    const real ball5_base_twist_vx_rate = ball5_base_twist_vx_rate_part_2
        - ball5_minus_base_twist_by_hooke5_vx_rate - slide5_u * hooke5_u_angle2_times_angle2_cos;
    const real ball5_base_twist_vy_rate = ball5_base_twist_by_hooke0_vy_rate
        - ball1_minus_base_twist_by_slide0_vy_rate + ball5_base_twist_by_ball0_vy_rate
        - ball5_minus_base_twist_by_hooke5_vy_rate + slide5_u * hooke5_minus_R_yz_rate;
    const real ball5_base_twist_vz_rate = ball5_base_twist_by_hooke0_vz_rate
        - ball1_minus_base_twist_by_slide0_vz_rate + ball5_base_twist_by_ball0_vz_rate
        - ball5_minus_base_twist_by_hooke5_vz_rate + slide5_u * hooke5_minus_R_zz_rate;
    const real ball5_twist_vx_rate_part = ball5_base_twist_vx * ball1_platform_R_xx_rate
        + ball1_platform_R_xx * ball5_base_twist_vx_rate
        + (ball5_base_twist_vy * ball1_platform_R_yx_rate
        + ball1_platform_R_yx * ball5_base_twist_vy_rate);
    const real ball5_twist_vx_rate = ball5_base_twist_vz * ball1_platform_R_zx_rate
        + ball1_platform_R_zx * ball5_base_twist_vz_rate + ball5_twist_vx_rate_part;
    work[775] = ball5_twist_vx_rate;
    const real ball5_twist_vy_rate_part = ball5_base_twist_vx * ball1_platform_R_xy_rate
        + ball1_platform_R_xy * ball5_base_twist_vx_rate
        + (ball5_base_twist_vy * ball1_platform_R_yy_rate
        + ball1_platform_R_yy * ball5_base_twist_vy_rate);
    const real ball5_twist_vy_rate = ball5_base_twist_vz * ball1_platform_R_zy_rate
        + ball1_platform_R_zy * ball5_base_twist_vz_rate + ball5_twist_vy_rate_part;
    work[776] = ball5_twist_vy_rate;
    const real ball5_twist_vz_rate_part = ball5_base_twist_vx * ball1_platform_R_xz_rate
        + ball1_platform_R_xz * ball5_base_twist_vx_rate
        + (ball5_base_twist_vy * ball1_platform_R_yz_rate
        + ball1_platform_R_yz * ball5_base_twist_vy_rate);
    const real ball5_twist_vz_rate = ball5_base_twist_vz * ball1_platform_R_zz_rate
        + ball1_platform_R_zz * ball5_base_twist_vz_rate + ball5_twist_vz_rate_part;
    work[777] = ball5_twist_vz_rate;
    const real ball5_twist_vx_times_R_xx_rate_plus_R_xx_times_twist_vx_rate = ball5_twist_vx *
        (ball5_R_xx_rate_part - (hooke5_minus_R_zx * ball1_platform_R_zx_rate
        + ball1_platform_R_zx * hooke5_minus_R_zx_rate)) + ball5_R_xx * ball5_twist_vx_rate;
    const real ball5_rate_px_rate_part = ball5_twist_vy * (ball5_R_xy_rate_part
        - (hooke5_minus_R_zx * ball1_platform_R_zy_rate
        + ball1_platform_R_zy * hooke5_minus_R_zx_rate)) + ball5_R_xy * ball5_twist_vy_rate
        + ball5_twist_vx_times_R_xx_rate_plus_R_xx_times_twist_vx_rate;
    work[778] = ball5_rate_px_rate_part;
    const real ball5_twist_vx_times_R_yx_rate = ball5_twist_vx * (hooke5_angle1_cos *
        ball1_platform_R_yx_rate - ball1_platform_R_yx * hooke5_u_angle1_times_angle1_sin
        + (hooke5_angle1_sin * ball1_platform_R_zx_rate
        + ball1_platform_R_zx * hooke5_u_angle1_times_angle1_cos));
    work[779] = ball5_twist_vx_times_R_yx_rate;
    const real ball5_twist_vy_times_R_yy_rate = ball5_twist_vy * (hooke5_angle1_cos *
        ball1_platform_R_yy_rate - ball1_platform_R_yy * hooke5_u_angle1_times_angle1_sin
        + (hooke5_angle1_sin * ball1_platform_R_zy_rate
        + ball1_platform_R_zy * hooke5_u_angle1_times_angle1_cos));
    work[780] = ball5_twist_vy_times_R_yy_rate;
    const real ball5_twist_vz_times_R_yz_rate = ball5_twist_vz * (hooke5_angle1_cos *
        ball1_platform_R_yz_rate - ball1_platform_R_yz * hooke5_u_angle1_times_angle1_sin
        + (hooke5_angle1_sin * ball1_platform_R_zz_rate
        + ball1_platform_R_zz * hooke5_u_angle1_times_angle1_cos));
    work[781] = ball5_twist_vz_times_R_yz_rate;
    const real ball5_twist_vx_times_R_zx_rate_plus_R_zx_times_twist_vx_rate = ball5_twist_vx *
        (hooke5_R_zz * ball1_platform_R_zx_rate - ball1_platform_R_zx * hooke5_minus_R_zz_rate
        + ball5_R_zx_rate_part) + ball5_R_zx * ball5_twist_vx_rate;
    const real ball5_rate_pz_rate_part = ball5_twist_vy * (hooke5_R_zz * ball1_platform_R_zy_rate
        - ball1_platform_R_zy * hooke5_minus_R_zz_rate + ball5_R_zy_rate_part)
        + ball5_R_zy * ball5_twist_vy_rate
        + ball5_twist_vx_times_R_zx_rate_plus_R_zx_times_twist_vx_rate;
    work[782] = ball5_rate_pz_rate_part;

    /* rod0: composite, inertia, a */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    const real slide0_q = q[2]; /* m */
    const real hooke0_u_angle2 = u[1]; /* rad/s */
    const real slide0_u = u[2]; /* m/s */
    const wreal slide0_position_z = w[4]; /* m */
    const wreal momentum_ball0_y_fz = w[5];
    const wreal momentum_ball0_z_fx = w[6];
    const wreal platform_first_moment_z = w[7];
    const wreal rod0_base_moment_z = w[70];
    const real ball0_R_yx = work[419];
    const real rod0_inertia_half_turned_xx = work[449];
    const real ball0_R_yy = work[420];
    const real rod0_inertia_half_turned_xy = work[450];
    const real ball0_R_yz = work[421];
    const real rod0_inertia_half_turned_xz = work[451];
    const real rod0_composite_inertia_xy = ball0_R_yx * rod0_inertia_half_turned_xx
        + ball0_R_yy * rod0_inertia_half_turned_xy + ball0_R_yz * rod0_inertia_half_turned_xz;
    const real ball0_R_zx = work[422];
    const real rod0_inertia_half_turned_yx = work[452];
    const real ball0_R_zy = work[423];
    const real rod0_inertia_half_turned_yy = work[453];
    const real ball0_R_zz = work[424];
    const real rod0_inertia_half_turned_yz = work[454];
    const real rod0_inertia_shear_part = ball0_R_zx * rod0_inertia_half_turned_yx
        + ball0_R_zy * rod0_inertia_half_turned_yy + ball0_R_zz * rod0_inertia_half_turned_yz;
    const real rod0_inertia_half_turned_zx = work[455];
    const real rod0_inertia_half_turned_zy = work[456];
    const real rod0_inertia_half_turned_zz = work[457];
    const real rod0_composite_inertia_zz = ball0_R_zx * rod0_inertia_half_turned_zx
        + ball0_R_zy * rod0_inertia_half_turned_zy + ball0_R_zz * rod0_inertia_half_turned_zz;
    const real ball0_R_xz = work[418];
    const real ball0_R_xx = work[416];
    const real ball0_R_xy = work[417];
    const real rod0_composite_moment_x = platform_first_moment_z * ball0_R_xz
        - (momentum_ball0_y_fz * ball0_R_xx + momentum_ball0_z_fx * ball0_R_xy);
    work[783] = rod0_composite_moment_x;
    const real rod0_composite_moment_y = platform_first_moment_z * ball0_R_yz
        - (momentum_ball0_y_fz * ball0_R_yx + momentum_ball0_z_fx * ball0_R_yy);
    const real rod0_inertia_mean_moment_z = platform_first_moment_z * ball0_R_zz
        - (momentum_ball0_y_fz * ball0_R_zx + momentum_ball0_z_fx * ball0_R_zy);
    const real rod0_inertia_shift = slide0_position_z * rod0_inertia_mean_moment_z * 2.0;
    const real rod0_composite_inertia_xx = ball0_R_xx * rod0_inertia_half_turned_xx
        + ball0_R_xy * rod0_inertia_half_turned_xy + ball0_R_xz * rod0_inertia_half_turned_xz
        + rod0_inertia_shift;
    const real rod0_composite_inertia_xz = ball0_R_zx * rod0_inertia_half_turned_xx
        + ball0_R_zy * rod0_inertia_half_turned_xy + ball0_R_zz * rod0_inertia_half_turned_xz
        - slide0_position_z * rod0_composite_moment_x;
    const real rod0_composite_inertia_yy = ball0_R_yx * rod0_inertia_half_turned_yx
        + ball0_R_yy * rod0_inertia_half_turned_yy + ball0_R_yz * rod0_inertia_half_turned_yz
        + rod0_inertia_shift;
    const real rod0_composite_inertia_yz = rod0_inertia_shear_part + rod0_inertia_shear_part
        - rod0_inertia_shear_part - slide0_position_z * rod0_composite_moment_y;
    const real rod0_composite_moment_z = rod0_base_moment_z + rod0_inertia_mean_moment_z;
    const real hooke0_R_zz = work[414];
    const real tube0_minus_U_zz = work[536];
    const real rod0_minus_a_z = gravity_z * hooke0_R_zz + slide0_q * tube0_minus_U_zz;
    work[784] = rod0_minus_a_z;
    const real tube0_a_x = work[528];
    const real tube0_U_xz = work[530];
    const real rod0_a_x = tube0_a_x + slide0_q * tube0_U_xz + hooke0_u_angle2 * slide0_u * 2.0;
    work[785] = rod0_a_x;

    /* tube0: inertia, composite, U */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* U = [alpha] + [omega][omega] */
    const wreal tube0_base_inertia_xx = w[71];
    const wreal tube0_base_inertia_yy = w[72];
    const wreal tube0_base_inertia_zz = w[73];
    const wreal half_rod0_base_mass = w[95];
    const real tube0_inertia_shear_minus_rod0_composite_inertia_yz = rod0_composite_inertia_yz
        + rod0_composite_inertia_yz - rod0_composite_inertia_yz;
    const real tube0_inertia_shift = slide0_q * (rod0_composite_moment_z
        + slide0_q * half_rod0_base_mass) * 2.0;
    const real tube0_composite_inertia_xz = rod0_composite_inertia_xz
        - slide0_q * rod0_composite_moment_x;
    const real tube0_composite_inertia_yz = tube0_inertia_shear_minus_rod0_composite_inertia_yz
        + tube0_inertia_shear_minus_rod0_composite_inertia_yz
        - tube0_inertia_shear_minus_rod0_composite_inertia_yz - slide0_q * rod0_composite_moment_y;
    const real tube0_composite_inertia_xx = rod0_composite_inertia_xx + tube0_inertia_shift
        + tube0_base_inertia_xx;
    const real tube0_composite_inertia_yy = rod0_composite_inertia_yy + tube0_inertia_shift
        + tube0_base_inertia_yy;
    work[786] = tube0_composite_inertia_yy;
    const real tube0_composite_inertia_zz = tube0_base_inertia_zz + rod0_composite_inertia_zz;
    const real hooke0_u_angle2_times_tube0_omega_x = work[534];
    const real tube0_alpha_z = work[527];
    const real tube0_U_xy = hooke0_u_angle2_times_tube0_omega_x - tube0_alpha_z;
    work[787] = tube0_U_xy;
    const real tube0_U_yx = tube0_alpha_z + hooke0_u_angle2_times_tube0_omega_x;
    work[788] = tube0_U_yx;
    const real hooke0_minus_drift_relative_wx = work[415];
    const real hooke0_u_angle2_times_tube0_omega_z = work[535];
    const real tube0_U_yz = hooke0_minus_drift_relative_wx + hooke0_u_angle2_times_tube0_omega_z;
    work[789] = tube0_U_yz;
    const real tube0_U_zy = hooke0_u_angle2_times_tube0_omega_z - hooke0_minus_drift_relative_wx;
    work[790] = tube0_U_zy;

    /* momentum */
    /* momentum = composite inertia S */
    const wreal tube5_base_inertia_zz = w[56];
    const wreal tube4_base_inertia_zz = w[59];
    const wreal tube3_base_inertia_zz = w[62];
    const wreal tube2_base_inertia_zz = w[65];
    const wreal tube1_base_inertia_zz = w[68];
    const real momentum_hooke5_angle1_mx = hooke5_angle2_cos * tube5_composite_inertia_xx;
    const real momentum_hooke5_angle1_mz = tube5_base_inertia_zz * hooke5_angle2_sin;
    const real momentum_hooke4_angle1_mx = hooke4_angle2_cos * tube4_composite_inertia_xx;
    const real momentum_hooke4_angle1_mz = tube4_base_inertia_zz * hooke4_angle2_sin;
    const real hooke3_angle2_cos = work[404];
    const real tube3_composite_inertia_xx = work[663];
    const real momentum_hooke3_angle1_mx = hooke3_angle2_cos * tube3_composite_inertia_xx;
    const real hooke3_angle2_sin = work[405];
    const real momentum_hooke3_angle1_mz = tube3_base_inertia_zz * hooke3_angle2_sin;
    const real hooke2_angle2_cos = work[400];
    const real tube2_composite_inertia_xx = work[607];
    const real momentum_hooke2_angle1_mx = hooke2_angle2_cos * tube2_composite_inertia_xx;
    const real hooke2_angle2_sin = work[401];
    const real momentum_hooke2_angle1_mz = tube2_base_inertia_zz * hooke2_angle2_sin;
    const real hooke1_angle2_cos = work[396];
    const real tube1_composite_inertia_xx = work[543];
    const real momentum_hooke1_angle1_mx = hooke1_angle2_cos * tube1_composite_inertia_xx;
    const real hooke1_angle2_sin = work[397];
    const real momentum_hooke1_angle1_mz = tube1_base_inertia_zz * hooke1_angle2_sin;
    const real hooke0_angle2_cos = work[392];
    const real momentum_hooke0_angle1_fz = hooke0_angle2_cos * rod0_composite_moment_y;
    work[791] = momentum_hooke0_angle1_fz;
    const real hooke0_angle2_sin = work[393];
    const real momentum_hooke0_angle1_mx = hooke0_angle2_cos * tube0_composite_inertia_xx
        + hooke0_angle2_sin * tube0_composite_inertia_xz;
    const real momentum_hooke0_angle1_my = hooke0_angle2_cos * rod0_composite_inertia_xy
        + hooke0_angle2_sin * tube0_composite_inertia_yz;
    work[792] = momentum_hooke0_angle1_my;
    const real momentum_hooke0_angle1_mz = hooke0_angle2_cos * tube0_composite_inertia_xz
        + hooke0_angle2_sin * tube0_composite_inertia_zz;

    /* M */
    /* M = S . momentum */
    const real M_hooke5_angle1_hooke5_angle1 = hooke5_angle2_cos * momentum_hooke5_angle1_mx
        + hooke5_angle2_sin * momentum_hooke5_angle1_mz;
    work[793] = M_hooke5_angle1_hooke5_angle1;
    const real M_hooke4_angle1_hooke4_angle1 = hooke4_angle2_cos * momentum_hooke4_angle1_mx
        + hooke4_angle2_sin * momentum_hooke4_angle1_mz;
    work[794] = M_hooke4_angle1_hooke4_angle1;
    const real M_hooke3_angle1_hooke3_angle1 = hooke3_angle2_cos * momentum_hooke3_angle1_mx
        + hooke3_angle2_sin * momentum_hooke3_angle1_mz;
    work[795] = M_hooke3_angle1_hooke3_angle1;
    const real M_hooke2_angle1_hooke2_angle1 = hooke2_angle2_cos * momentum_hooke2_angle1_mx
        + hooke2_angle2_sin * momentum_hooke2_angle1_mz;
    work[796] = M_hooke2_angle1_hooke2_angle1;
    const real M_hooke1_angle1_hooke1_angle1 = hooke1_angle2_cos * momentum_hooke1_angle1_mx
        + hooke1_angle2_sin * momentum_hooke1_angle1_mz;
    work[797] = M_hooke1_angle1_hooke1_angle1;
    const real M_ball0_y_slide0 = platform_first_moment_z * ball0_R_zx
        + momentum_ball0_y_fz * ball0_R_zz;
    work[798] = M_ball0_y_slide0;
    const real M_ball0_z_slide0 = momentum_ball0_z_fx * ball0_R_zx
        - momentum_ball0_y_fz * ball0_R_zy;
    work[799] = M_ball0_z_slide0;
    const real M_hooke0_angle1_hooke0_angle1 = hooke0_angle2_cos * momentum_hooke0_angle1_mx
        + hooke0_angle2_sin * momentum_hooke0_angle1_mz;
    work[800] = M_hooke0_angle1_hooke0_angle1;
    return CARDAN_OK;
}

CARDAN_PART int forward_dynamics_part4(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const real *const r = in->r;
    const wreal *const w = in->w;
    const real *const tau = in->tau;
    (void)out;

    /* platform: momentum, alpha, omega, a, U, inertia force, f */
    /* momentum = composite inertia S */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* omega = Rᵀ omega_parent + S_w u */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real hooke0_u_angle2 = u[1]; /* rad/s */
    const real ball0_u_x = u[3]; /* rad/s */
    const real ball0_u_y = u[4]; /* rad/s */
    const real ball0_u_z = u[5]; /* rad/s */
    const wreal slide0_position_z = w[4]; /* m */
    const wreal momentum_ball0_y_fz = w[5];
    const wreal momentum_ball0_z_fx = w[6];
    const wreal platform_first_moment_z = w[7];
    const wreal platform_base_second_moment_xy = w[8];
    const wreal platform_origin_inertia_xz = w[9];
    const wreal platform_origin_inertia_yz = w[10];
    const wreal platform_base_second_moment_xx = w[74];
    const wreal platform_base_second_moment_yy = w[75];
    const wreal platform_base_second_moment_zz = w[76];
    const real ball0_R_xy = work[417];
    const real ball0_R_xz = work[418];
    const real momentum_minus_ball0_x_about_rod0_fx = platform_first_moment_z * ball0_R_xy
        + momentum_ball0_z_fx * ball0_R_xz;
    const real ball0_R_yy = work[420];
    const real ball0_R_yz = work[421];
    const real momentum_minus_ball0_x_about_rod0_fy = platform_first_moment_z * ball0_R_yy
        + momentum_ball0_z_fx * ball0_R_yz;
    const real ball0_R_xx = work[416];
    const real momentum_ball0_y_about_rod0_fx = platform_first_moment_z * ball0_R_xx
        + momentum_ball0_y_fz * ball0_R_xz;
    const real ball0_R_yx = work[419];
    const real momentum_ball0_y_about_rod0_fy = platform_first_moment_z * ball0_R_yx
        + momentum_ball0_y_fz * ball0_R_yz;
    const real momentum_ball0_z_about_rod0_fx = momentum_ball0_z_fx * ball0_R_xx
        - momentum_ball0_y_fz * ball0_R_xy;
    const real momentum_ball0_z_about_rod0_fy = momentum_ball0_z_fx * ball0_R_yx
        - momentum_ball0_y_fz * ball0_R_yy;
    const real tube0_omega_x = work[525];
    const real ball0_R_zx = work[422];
    const real tube0_omega_z = work[526];
    const real platform_alpha_parent_omega_x = ball0_R_xx * tube0_omega_x
        + hooke0_u_angle2 * ball0_R_yx + ball0_R_zx * tube0_omega_z;
    const real ball0_R_zy = work[423];
    const real platform_alpha_parent_omega_y = ball0_R_xy * tube0_omega_x
        + hooke0_u_angle2 * ball0_R_yy + ball0_R_zy * tube0_omega_z;
    const real ball0_R_zz = work[424];
    const real platform_alpha_parent_omega_z = ball0_R_xz * tube0_omega_x
        + hooke0_u_angle2 * ball0_R_yz + ball0_R_zz * tube0_omega_z;
    const real platform_omega_x = ball0_u_x + platform_alpha_parent_omega_x;
    const real platform_omega_y = ball0_u_y + platform_alpha_parent_omega_y;
    const real platform_omega_z = ball0_u_z + platform_alpha_parent_omega_z;
    const real tube0_alpha_z = work[527];
    const real hooke0_minus_drift_relative_wx = work[415];
    const real platform_alpha_x = ball0_u_z * platform_alpha_parent_omega_y
        - ball0_u_y * platform_alpha_parent_omega_z + (ball0_R_zx * tube0_alpha_z
        - ball0_R_xx * hooke0_minus_drift_relative_wx);
    const real platform_alpha_y = ball0_u_x * platform_alpha_parent_omega_z
        - ball0_u_z * platform_alpha_parent_omega_x + (ball0_R_zy * tube0_alpha_z
        - ball0_R_xy * hooke0_minus_drift_relative_wx);
    const real platform_alpha_z = ball0_u_y * platform_alpha_parent_omega_x
        - ball0_u_x * platform_alpha_parent_omega_y + (ball0_R_zz * tube0_alpha_z
        - ball0_R_xz * hooke0_minus_drift_relative_wx);
    const real rod0_a_x = work[785];
    const real tube0_U_xz = work[530];
    const real rod0_a_x_plus_slide0_position_z_times_tube0_U_xz = rod0_a_x
        + slide0_position_z * tube0_U_xz;
    const real rod0_minus_a_z = work[784];
    const real tube0_minus_U_zz = work[536];
    const real rod0_minus_a_z_plus_slide0_position_z_times_tube0_minus_U_zz = rod0_minus_a_z
        + slide0_position_z * tube0_minus_U_zz;
    const real platform_omega_x_squared = platform_omega_x * platform_omega_x;
    const real platform_omega_y_squared = platform_omega_y * platform_omega_y;
    const real platform_omega_z_squared = platform_omega_z * platform_omega_z;
    const real platform_omega_x_times_omega_y = platform_omega_x * platform_omega_y;
    const real platform_omega_x_times_omega_z = platform_omega_x * platform_omega_z;
    const real platform_omega_y_times_omega_z = platform_omega_y * platform_omega_z;
    const real platform_minus_U_xx = platform_omega_y_squared + platform_omega_z_squared;
    const real platform_U_xy = platform_omega_x_times_omega_y - platform_alpha_z;
    const real platform_U_xz = platform_alpha_y + platform_omega_x_times_omega_z;
    const real platform_U_yx = platform_alpha_z + platform_omega_x_times_omega_y;
    const real platform_minus_U_yy = platform_omega_x_squared + platform_omega_z_squared;
    const real platform_U_yz = platform_omega_y_times_omega_z - platform_alpha_x;
    const real platform_U_zx = platform_omega_x_times_omega_z - platform_alpha_y;
    const real platform_U_zy = platform_alpha_x + platform_omega_y_times_omega_z;
    const real platform_minus_U_zz = platform_omega_x_squared + platform_omega_y_squared;
    const real platform_n_x_part = platform_base_second_moment_yy * platform_U_zy
        - platform_base_second_moment_zz * platform_U_yz
        + (platform_base_second_moment_xy * platform_U_zx
        - platform_origin_inertia_yz * (platform_minus_U_yy - platform_minus_U_zz)
        + platform_origin_inertia_xz * platform_U_yx);
    const real platform_n_y_part = platform_base_second_moment_zz * platform_U_xz
        - platform_base_second_moment_xx * platform_U_zx
        - (platform_origin_inertia_xz * (platform_minus_U_zz - platform_minus_U_xx)
        + platform_origin_inertia_yz * platform_U_xy
        + platform_base_second_moment_xy * platform_U_zy);
    const real platform_n_z_part = platform_base_second_moment_xx * platform_U_yx
        - platform_base_second_moment_yy * platform_U_xy
        + (platform_base_second_moment_xy * (platform_minus_U_xx - platform_minus_U_yy)
        - platform_origin_inertia_xz * platform_U_yz + platform_origin_inertia_yz * platform_U_xz);
    const real platform_f_x = momentum_ball0_y_fz * platform_minus_U_xx
        - momentum_ball0_z_fx * platform_U_xy + platform_first_moment_z * platform_U_xz;
    const real platform_f_y = momentum_ball0_z_fx * platform_minus_U_yy
        - momentum_ball0_y_fz * platform_U_yx + platform_first_moment_z * platform_U_yz;
    const real platform_minus_f_z = momentum_ball0_y_fz * platform_U_zx
        + momentum_ball0_z_fx * platform_U_zy + platform_first_moment_z * platform_minus_U_zz;
    const real rod0_n_y_part = ball0_R_xx * platform_f_x + ball0_R_xy * platform_f_y
        - ball0_R_xz * platform_minus_f_z;
    const real rod0_n_x_part = ball0_R_yx * platform_f_x + ball0_R_yy * platform_f_y
        - ball0_R_yz * platform_minus_f_z;

    /* M */
    /* M = S . momentum */
    const real slide0_q = q[2]; /* m */
    const real rod0_inertia_half_turned_yx = work[452];
    const real M_ball0_x_hooke0_angle2 = rod0_inertia_half_turned_yx
        - slide0_position_z * momentum_minus_ball0_x_about_rod0_fx
        - slide0_q * momentum_minus_ball0_x_about_rod0_fx;
    const real hooke0_angle2_cos = work[392];
    const real rod0_inertia_half_turned_xx = work[449];
    const real hooke0_angle2_sin = work[393];
    const real rod0_inertia_half_turned_zx = work[455];
    const real M_ball0_x_hooke0_angle1 = hooke0_angle2_cos * (rod0_inertia_half_turned_xx
        + slide0_position_z * momentum_minus_ball0_x_about_rod0_fy
        + slide0_q * momentum_minus_ball0_x_about_rod0_fy)
        + hooke0_angle2_sin * rod0_inertia_half_turned_zx;
    const real rod0_inertia_half_turned_yy = work[453];
    const real M_ball0_y_hooke0_angle2 = rod0_inertia_half_turned_yy
        + slide0_position_z * momentum_ball0_y_about_rod0_fx
        + slide0_q * momentum_ball0_y_about_rod0_fx;
    const real rod0_inertia_half_turned_xy = work[450];
    const real rod0_inertia_half_turned_zy = work[456];
    const real M_ball0_y_hooke0_angle1 = hooke0_angle2_cos * (rod0_inertia_half_turned_xy
        - slide0_position_z * momentum_ball0_y_about_rod0_fy
        - slide0_q * momentum_ball0_y_about_rod0_fy)
        + hooke0_angle2_sin * rod0_inertia_half_turned_zy;
    const real rod0_inertia_half_turned_yz = work[454];
    const real M_ball0_z_hooke0_angle2 = rod0_inertia_half_turned_yz
        + slide0_position_z * momentum_ball0_z_about_rod0_fx
        + slide0_q * momentum_ball0_z_about_rod0_fx;
    const real rod0_inertia_half_turned_xz = work[451];
    const real rod0_inertia_half_turned_zz = work[457];
    const real M_ball0_z_hooke0_angle1 = hooke0_angle2_cos * (rod0_inertia_half_turned_xz
        - slide0_position_z * momentum_ball0_z_about_rod0_fy
        - slide0_q * momentum_ball0_z_about_rod0_fy)
        + hooke0_angle2_sin * rod0_inertia_half_turned_zz;

    /* rod0: a, f */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real slide0_u = u[2]; /* m/s */
    const wreal rod0_base_mass = w[69];
    const wreal rod0_base_moment_z = w[70];
    const real tube0_U_yz = work[789];
    const real tube0_minus_a_y = work[529];
    const real rod0_a_y = slide0_q * tube0_U_yz - tube0_minus_a_y - slide0_u * tube0_omega_x * 2.0;
    const real rod0_f_x = rod0_base_mass * rod0_a_x + rod0_base_moment_z * tube0_U_xz
        + rod0_n_y_part;
    const real rod0_f_y = rod0_base_mass * rod0_a_y + rod0_base_moment_z * tube0_U_yz
        + rod0_n_x_part;
    const real rod0_f_z = ball0_R_zx * platform_f_x + ball0_R_zy * platform_f_y
        - ball0_R_zz * platform_minus_f_z - (rod0_base_mass * rod0_minus_a_z
        + rod0_base_moment_z * tube0_minus_U_zz);

    /* platform: a, n */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real rod0_a_y_plus_slide0_position_z_times_tube0_U_yz = rod0_a_y
        + slide0_position_z * tube0_U_yz;
    const real platform_a_x = ball0_R_xx * rod0_a_x_plus_slide0_position_z_times_tube0_U_xz
        + ball0_R_yx * rod0_a_y_plus_slide0_position_z_times_tube0_U_yz
        - ball0_R_zx * rod0_minus_a_z_plus_slide0_position_z_times_tube0_minus_U_zz;
    const real platform_a_y = ball0_R_xy * rod0_a_x_plus_slide0_position_z_times_tube0_U_xz
        + ball0_R_yy * rod0_a_y_plus_slide0_position_z_times_tube0_U_yz
        - ball0_R_zy * rod0_minus_a_z_plus_slide0_position_z_times_tube0_minus_U_zz;
    const real platform_a_z = ball0_R_xz * rod0_a_x_plus_slide0_position_z_times_tube0_U_xz
        + ball0_R_yz * rod0_a_y_plus_slide0_position_z_times_tube0_U_yz
        - ball0_R_zz * rod0_minus_a_z_plus_slide0_position_z_times_tube0_minus_U_zz;
    const real platform_n_x = platform_n_x_part - (momentum_ball0_z_fx * platform_a_z
        + platform_first_moment_z * platform_a_y);
    const real platform_n_y = platform_first_moment_z * platform_a_x
        + momentum_ball0_y_fz * platform_a_z + platform_n_y_part;
    const real platform_n_z = momentum_ball0_z_fx * platform_a_x
        - momentum_ball0_y_fz * platform_a_y + platform_n_z_part;

    /* shared by several: U */
    /* U = [alpha] + [omega][omega] */
    const real hooke1_u_angle2 = u[7]; /* rad/s */
    const real hooke2_u_angle2 = u[10]; /* rad/s */
    const real hooke3_u_angle2 = u[13]; /* rad/s */
    const real hooke4_u_angle2 = u[16]; /* rad/s */
    const real hooke5_u_angle2 = u[19]; /* rad/s */
    const real tube1_omega_x = work[540];
    const real hooke1_u_angle2_times_tube1_omega_x = hooke1_u_angle2 * tube1_omega_x;
    const real tube1_omega_z = work[541];
    const real hooke1_u_angle2_times_tube1_omega_z = hooke1_u_angle2 * tube1_omega_z;
    const real tube1_minus_U_zz = tube1_omega_x * tube1_omega_x + hooke1_u_angle2 * hooke1_u_angle2;
    const real tube2_omega_x = work[604];
    const real hooke2_u_angle2_times_tube2_omega_x = hooke2_u_angle2 * tube2_omega_x;
    const real tube2_omega_z = work[605];
    const real hooke2_u_angle2_times_tube2_omega_z = hooke2_u_angle2 * tube2_omega_z;
    const real tube2_minus_U_zz = tube2_omega_x * tube2_omega_x + hooke2_u_angle2 * hooke2_u_angle2;
    const real tube3_omega_x = work[660];
    const real hooke3_u_angle2_times_tube3_omega_x = hooke3_u_angle2 * tube3_omega_x;
    const real tube3_omega_z = work[661];
    const real hooke3_u_angle2_times_tube3_omega_z = hooke3_u_angle2 * tube3_omega_z;
    const real tube3_minus_U_zz = tube3_omega_x * tube3_omega_x + hooke3_u_angle2 * hooke3_u_angle2;
    const real tube4_omega_x = work[712];
    const real hooke4_u_angle2_times_tube4_omega_x = hooke4_u_angle2 * tube4_omega_x;
    const real tube4_omega_z = work[713];
    const real hooke4_u_angle2_times_tube4_omega_z = hooke4_u_angle2 * tube4_omega_z;
    const real tube4_minus_U_zz = tube4_omega_x * tube4_omega_x + hooke4_u_angle2 * hooke4_u_angle2;
    const real tube5_omega_x = work[767];
    const real hooke5_u_angle2_times_tube5_omega_x = hooke5_u_angle2 * tube5_omega_x;
    const real tube5_omega_z = work[768];
    const real hooke5_u_angle2_times_tube5_omega_z = hooke5_u_angle2 * tube5_omega_z;
    const real tube5_minus_U_zz = tube5_omega_x * tube5_omega_x + hooke5_u_angle2 * hooke5_u_angle2;

    /* tube1: U, n */
    /* U = [alpha] + [omega][omega] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal tube1_base_second_moment_xx = w[89];
    const wreal tube1_base_second_moment_yy = w[90];
    const real tube1_alpha_z = work[542];
    const real tube1_U_xy = hooke1_u_angle2_times_tube1_omega_x - tube1_alpha_z;
    const real tube1_U_yx = tube1_alpha_z + hooke1_u_angle2_times_tube1_omega_x;
    const real hooke1_minus_drift_relative_wx = work[460];
    const real tube1_U_yz = hooke1_minus_drift_relative_wx + hooke1_u_angle2_times_tube1_omega_z;
    const real tube1_U_zy = hooke1_u_angle2_times_tube1_omega_z - hooke1_minus_drift_relative_wx;
    const real tube1_n_z = tube1_base_second_moment_xx * tube1_U_yx
        - tube1_base_second_moment_yy * tube1_U_xy;

    /* rod1: a, n, f */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real slide1_q = q[9]; /* m */
    const real slide1_u = u[8]; /* m/s */
    const wreal rod1_mass = w[17]; /* kg */
    const wreal rod1_base_moment_z = w[45];
    const real tube1_a_x = work[545];
    const real tube1_U_xz = work[547];
    const real rod1_a_x = tube1_a_x + slide1_q * tube1_U_xz + hooke1_u_angle2 * slide1_u * 2.0;
    const real tube1_minus_a_y = work[546];
    const real rod1_a_y = slide1_q * tube1_U_yz - tube1_minus_a_y - slide1_u * tube1_omega_x * 2.0;
    const real rod1_n_y = rod1_base_moment_z * rod1_a_x;
    const real rod1_f_x = rod1_mass * rod1_a_x + rod1_base_moment_z * tube1_U_xz;
    const real rod1_f_y = rod1_mass * rod1_a_y + rod1_base_moment_z * tube1_U_yz;

    /* tube2: U, n */
    /* U = [alpha] + [omega][omega] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal tube2_base_second_moment_xx = w[86];
    const wreal tube2_base_second_moment_yy = w[87];
    const real tube2_alpha_z = work[606];
    const real tube2_U_xy = hooke2_u_angle2_times_tube2_omega_x - tube2_alpha_z;
    const real tube2_U_yx = tube2_alpha_z + hooke2_u_angle2_times_tube2_omega_x;
    const real hooke2_minus_drift_relative_wx = work[559];
    const real tube2_U_yz = hooke2_minus_drift_relative_wx + hooke2_u_angle2_times_tube2_omega_z;
    const real tube2_U_zy = hooke2_u_angle2_times_tube2_omega_z - hooke2_minus_drift_relative_wx;
    const real tube2_n_z = tube2_base_second_moment_xx * tube2_U_yx
        - tube2_base_second_moment_yy * tube2_U_xy;

    /* rod2: a, n, f */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real slide2_q = q[12]; /* m */
    const real slide2_u = u[11]; /* m/s */
    const wreal rod2_mass = w[21]; /* kg */
    const wreal rod2_base_moment_z = w[47];
    const real tube2_a_x = work[609];
    const real tube2_U_xz = work[611];
    const real rod2_a_x = tube2_a_x + slide2_q * tube2_U_xz + hooke2_u_angle2 * slide2_u * 2.0;
    const real tube2_minus_a_y = work[610];
    const real rod2_a_y = slide2_q * tube2_U_yz - tube2_minus_a_y - slide2_u * tube2_omega_x * 2.0;
    const real rod2_n_y = rod2_base_moment_z * rod2_a_x;
    const real rod2_f_x = rod2_mass * rod2_a_x + rod2_base_moment_z * tube2_U_xz;
    const real rod2_f_y = rod2_mass * rod2_a_y + rod2_base_moment_z * tube2_U_yz;

    /* tube3: U, n */
    /* U = [alpha] + [omega][omega] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal tube3_base_second_moment_xx = w[83];
    const wreal tube3_base_second_moment_yy = w[84];
    const real tube3_alpha_z = work[662];
    const real tube3_U_xy = hooke3_u_angle2_times_tube3_omega_x - tube3_alpha_z;
    const real tube3_U_yx = tube3_alpha_z + hooke3_u_angle2_times_tube3_omega_x;
    const real hooke3_minus_drift_relative_wx = work[623];
    const real tube3_U_yz = hooke3_minus_drift_relative_wx + hooke3_u_angle2_times_tube3_omega_z;
    const real tube3_U_zy = hooke3_u_angle2_times_tube3_omega_z - hooke3_minus_drift_relative_wx;
    const real tube3_n_z = tube3_base_second_moment_xx * tube3_U_yx
        - tube3_base_second_moment_yy * tube3_U_xy;

    /* rod3: a, n, f */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real slide3_q = q[15]; /* m */
    const real slide3_u = u[14]; /* m/s */
    const wreal rod3_mass = w[25]; /* kg */
    const wreal rod3_base_moment_z = w[49];
    const real tube3_a_x = work[665];
    const real tube3_U_xz = work[667];
    const real rod3_a_x = tube3_a_x + slide3_q * tube3_U_xz + hooke3_u_angle2 * slide3_u * 2.0;
    const real tube3_minus_a_y = work[666];
    const real rod3_a_y = slide3_q * tube3_U_yz - tube3_minus_a_y - slide3_u * tube3_omega_x * 2.0;
    const real rod3_n_y = rod3_base_moment_z * rod3_a_x;
    const real rod3_f_x = rod3_mass * rod3_a_x + rod3_base_moment_z * tube3_U_xz;
    const real rod3_f_y = rod3_mass * rod3_a_y + rod3_base_moment_z * tube3_U_yz;

    /* tube4: U, n */
    /* U = [alpha] + [omega][omega] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal tube4_base_second_moment_xx = w[80];
    const wreal tube4_base_second_moment_yy = w[81];
    const real tube4_alpha_z = work[714];
    const real tube4_U_xy = hooke4_u_angle2_times_tube4_omega_x - tube4_alpha_z;
    const real tube4_U_yx = tube4_alpha_z + hooke4_u_angle2_times_tube4_omega_x;
    const real hooke4_minus_drift_relative_wx = work[682];
    const real tube4_U_yz = hooke4_minus_drift_relative_wx + hooke4_u_angle2_times_tube4_omega_z;
    const real tube4_U_zy = hooke4_u_angle2_times_tube4_omega_z - hooke4_minus_drift_relative_wx;
    const real tube4_n_z = tube4_base_second_moment_xx * tube4_U_yx
        - tube4_base_second_moment_yy * tube4_U_xy;

    /* rod4: a, n, f */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real slide4_q = q[18]; /* m */
    const real slide4_u = u[17]; /* m/s */
    const wreal rod4_mass = w[29]; /* kg */
    const wreal rod4_base_moment_z = w[51];
    const real tube4_a_x = work[716];
    const real tube4_U_xz = work[718];
    const real rod4_a_x = tube4_a_x + slide4_q * tube4_U_xz + hooke4_u_angle2 * slide4_u * 2.0;
    const real tube4_minus_a_y = work[717];
    const real rod4_a_y = slide4_q * tube4_U_yz - tube4_minus_a_y - slide4_u * tube4_omega_x * 2.0;
    const real rod4_n_y = rod4_base_moment_z * rod4_a_x;
    const real rod4_f_x = rod4_mass * rod4_a_x + rod4_base_moment_z * tube4_U_xz;
    const real rod4_f_y = rod4_mass * rod4_a_y + rod4_base_moment_z * tube4_U_yz;

    /* tube5: U, n */
    /* U = [alpha] + [omega][omega] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal tube5_base_second_moment_xx = w[77];
    const wreal tube5_base_second_moment_yy = w[78];
    const real tube5_alpha_z = work[769];
    const real tube5_U_xy = hooke5_u_angle2_times_tube5_omega_x - tube5_alpha_z;
    const real tube5_U_yx = tube5_alpha_z + hooke5_u_angle2_times_tube5_omega_x;
    const real hooke5_minus_drift_relative_wx = work[730];
    const real tube5_U_yz = hooke5_minus_drift_relative_wx + hooke5_u_angle2_times_tube5_omega_z;
    const real tube5_U_zy = hooke5_u_angle2_times_tube5_omega_z - hooke5_minus_drift_relative_wx;
    const real tube5_n_z = tube5_base_second_moment_xx * tube5_U_yx
        - tube5_base_second_moment_yy * tube5_U_xy;

    /* rod5: a, n, f */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real slide5_q = q[21]; /* m */
    const real slide5_u = u[20]; /* m/s */
    const wreal rod5_mass = w[33]; /* kg */
    const wreal rod5_base_moment_z = w[53];
    const real tube5_a_x = work[771];
    const real tube5_U_xz = work[773];
    const real rod5_a_x = tube5_a_x + slide5_q * tube5_U_xz + hooke5_u_angle2 * slide5_u * 2.0;
    const real tube5_minus_a_y = work[772];
    const real rod5_a_y = slide5_q * tube5_U_yz - tube5_minus_a_y - slide5_u * tube5_omega_x * 2.0;
    const real rod5_n_y = rod5_base_moment_z * rod5_a_x;
    const real rod5_f_x = rod5_mass * rod5_a_x + rod5_base_moment_z * tube5_U_xz;
    const real rod5_f_y = rod5_mass * rod5_a_y + rod5_base_moment_z * tube5_U_yz;

    /* tube5: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal tube5_first_moment_z = w[32];
    const wreal tube5_base_second_moment_zz = w[79];
    const real tube5_n_x = tube5_base_second_moment_yy * tube5_U_zy
        - tube5_base_second_moment_zz * tube5_U_yz + tube5_first_moment_z * tube5_minus_a_y
        - (rod5_base_moment_z * rod5_a_y + slide5_q * rod5_f_y);
    const real tube5_n_y = tube5_base_second_moment_zz * tube5_U_xz
        - tube5_base_second_moment_xx * tube5_U_xz + tube5_first_moment_z * tube5_a_x + (rod5_n_y
        + slide5_q * rod5_f_x);

    /* tube4: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal tube4_first_moment_z = w[28];
    const wreal tube4_base_second_moment_zz = w[82];
    const real tube4_n_x = tube4_base_second_moment_yy * tube4_U_zy
        - tube4_base_second_moment_zz * tube4_U_yz + tube4_first_moment_z * tube4_minus_a_y
        - (rod4_base_moment_z * rod4_a_y + slide4_q * rod4_f_y);
    const real tube4_n_y = tube4_base_second_moment_zz * tube4_U_xz
        - tube4_base_second_moment_xx * tube4_U_xz + tube4_first_moment_z * tube4_a_x + (rod4_n_y
        + slide4_q * rod4_f_x);

    /* tube3: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal tube3_first_moment_z = w[24];
    const wreal tube3_base_second_moment_zz = w[85];
    const real tube3_n_x = tube3_base_second_moment_yy * tube3_U_zy
        - tube3_base_second_moment_zz * tube3_U_yz + tube3_first_moment_z * tube3_minus_a_y
        - (rod3_base_moment_z * rod3_a_y + slide3_q * rod3_f_y);
    const real tube3_n_y = tube3_base_second_moment_zz * tube3_U_xz
        - tube3_base_second_moment_xx * tube3_U_xz + tube3_first_moment_z * tube3_a_x + (rod3_n_y
        + slide3_q * rod3_f_x);

    /* tube2: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal tube2_first_moment_z = w[20];
    const wreal tube2_base_second_moment_zz = w[88];
    const real tube2_n_x = tube2_base_second_moment_yy * tube2_U_zy
        - tube2_base_second_moment_zz * tube2_U_yz + tube2_first_moment_z * tube2_minus_a_y
        - (rod2_base_moment_z * rod2_a_y + slide2_q * rod2_f_y);
    const real tube2_n_y = tube2_base_second_moment_zz * tube2_U_xz
        - tube2_base_second_moment_xx * tube2_U_xz + tube2_first_moment_z * tube2_a_x + (rod2_n_y
        + slide2_q * rod2_f_x);

    /* tube1: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal tube1_first_moment_z = w[16];
    const wreal tube1_base_second_moment_zz = w[91];
    const real tube1_n_x = tube1_base_second_moment_yy * tube1_U_zy
        - tube1_base_second_moment_zz * tube1_U_yz + tube1_first_moment_z * tube1_minus_a_y
        - (rod1_base_moment_z * rod1_a_y + slide1_q * rod1_f_y);
    const real tube1_n_y = tube1_base_second_moment_zz * tube1_U_xz
        - tube1_base_second_moment_xx * tube1_U_xz + tube1_first_moment_z * tube1_a_x + (rod1_n_y
        + slide1_q * rod1_f_x);

    /* rod0: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real rod0_n_z = ball0_R_zx * platform_n_x + ball0_R_zy * platform_n_y
        + ball0_R_zz * platform_n_z;
    const real rod0_n_x = ball0_R_xx * platform_n_x + ball0_R_xy * platform_n_y
        + ball0_R_xz * platform_n_z - slide0_position_z * rod0_n_x_part
        - rod0_base_moment_z * rod0_a_y;
    const real rod0_n_y = ball0_R_yx * platform_n_x + ball0_R_yy * platform_n_y
        + ball0_R_yz * platform_n_z + slide0_position_z * rod0_n_y_part
        + rod0_base_moment_z * rod0_a_x;

    /* tube0: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal tube0_first_moment_z = w[3];
    const wreal tube0_base_second_moment_xx = w[92];
    const wreal tube0_base_second_moment_yy = w[93];
    const wreal tube0_base_second_moment_zz = w[94];
    const real tube0_U_zy = work[790];
    const real tube0_n_x = tube0_base_second_moment_yy * tube0_U_zy
        - tube0_base_second_moment_zz * tube0_U_yz + tube0_first_moment_z * tube0_minus_a_y
        + (rod0_n_x - slide0_q * rod0_f_y);
    const real tube0_a_x = work[528];
    const real tube0_n_y = tube0_base_second_moment_zz * tube0_U_xz
        - tube0_base_second_moment_xx * tube0_U_xz + tube0_first_moment_z * tube0_a_x + (rod0_n_y
        + slide0_q * rod0_f_x);
    const real tube0_U_yx = work[788];
    const real tube0_U_xy = work[787];
    const real tube0_n_z = tube0_base_second_moment_xx * tube0_U_yx
        - tube0_base_second_moment_yy * tube0_U_xy + rod0_n_z;

    /* hooke5: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real hooke5_u_angle1_tau = tau[18]; /* N*m */
    const real hooke5_u_angle2_tau = tau[19]; /* N*m */
    const real hooke5_angle2_cos = work[412];
    const real hooke5_angle2_sin = work[413];
    const real hooke5_tau_angle1 = hooke5_angle2_cos * tube5_n_x + hooke5_angle2_sin * tube5_n_z;
    const real hooke5_drive_angle1 = hooke5_u_angle1_tau - hooke5_tau_angle1;
    const real hooke5_drive_angle2 = hooke5_u_angle2_tau - tube5_n_y;

    /* hooke4: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real hooke4_u_angle1_tau = tau[15]; /* N*m */
    const real hooke4_u_angle2_tau = tau[16]; /* N*m */
    const real hooke4_angle2_cos = work[408];
    const real hooke4_angle2_sin = work[409];
    const real hooke4_tau_angle1 = hooke4_angle2_cos * tube4_n_x + hooke4_angle2_sin * tube4_n_z;
    const real hooke4_drive_angle1 = hooke4_u_angle1_tau - hooke4_tau_angle1;
    const real hooke4_drive_angle2 = hooke4_u_angle2_tau - tube4_n_y;

    /* hooke3: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real hooke3_u_angle1_tau = tau[12]; /* N*m */
    const real hooke3_u_angle2_tau = tau[13]; /* N*m */
    const real hooke3_angle2_cos = work[404];
    const real hooke3_angle2_sin = work[405];
    const real hooke3_tau_angle1 = hooke3_angle2_cos * tube3_n_x + hooke3_angle2_sin * tube3_n_z;
    const real hooke3_drive_angle1 = hooke3_u_angle1_tau - hooke3_tau_angle1;
    const real hooke3_drive_angle2 = hooke3_u_angle2_tau - tube3_n_y;

    /* hooke2: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real hooke2_u_angle1_tau = tau[9]; /* N*m */
    const real hooke2_u_angle2_tau = tau[10]; /* N*m */
    const real hooke2_angle2_cos = work[400];
    const real hooke2_angle2_sin = work[401];
    const real hooke2_tau_angle1 = hooke2_angle2_cos * tube2_n_x + hooke2_angle2_sin * tube2_n_z;
    const real hooke2_drive_angle1 = hooke2_u_angle1_tau - hooke2_tau_angle1;
    const real hooke2_drive_angle2 = hooke2_u_angle2_tau - tube2_n_y;

    /* hooke1: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real hooke1_u_angle1_tau = tau[6]; /* N*m */
    const real hooke1_u_angle2_tau = tau[7]; /* N*m */
    const real hooke1_angle2_cos = work[396];
    const real hooke1_angle2_sin = work[397];
    const real hooke1_tau_angle1 = hooke1_angle2_cos * tube1_n_x + hooke1_angle2_sin * tube1_n_z;
    const real hooke1_drive_angle1 = hooke1_u_angle1_tau - hooke1_tau_angle1;
    const real hooke1_drive_angle2 = hooke1_u_angle2_tau - tube1_n_y;

    /* slide0: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real drive0 = r[0];
    const real slide0_u_tau = tau[2]; /* N */
    const real slide0_tau = rod0_f_z - drive0;
    const real slide0_drive = slide0_u_tau - slide0_tau;

    /* hooke0: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real hooke0_u_angle1_tau = tau[0]; /* N*m */
    const real hooke0_u_angle2_tau = tau[1]; /* N*m */
    const real hooke0_tau_angle1 = hooke0_angle2_cos * tube0_n_x + hooke0_angle2_sin * tube0_n_z;
    const real hooke0_drive_angle1 = hooke0_u_angle1_tau - hooke0_tau_angle1;
    const real hooke0_drive_angle2 = hooke0_u_angle2_tau - tube0_n_y;

    /* ball0: drive */
    /* drive = tau + f - h */
    const real ball0_u_x_tau = tau[3]; /* N*m */
    const real ball0_u_y_tau = tau[4]; /* N*m */
    const real ball0_u_z_tau = tau[5]; /* N*m */
    const real ball0_drive_x = ball0_u_x_tau - platform_n_x;
    const real ball0_drive_y = ball0_u_y_tau - platform_n_y;
    const real ball0_drive_z = ball0_u_z_tau - platform_n_z;

    /* slide1: drive */
    /* drive = tau + f - h */
    const real drive1 = r[1];
    const real slide1_u_tau = tau[8]; /* N */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const real hooke1_R_zz = work[459];
    const real slide1_drive = rod1_mass * (gravity_z * hooke1_R_zz + slide1_q * tube1_minus_U_zz)
        + rod1_base_moment_z * tube1_minus_U_zz + drive1 + slide1_u_tau;

    /* slide2: drive */
    /* drive = tau + f - h */
    const real drive2 = r[2];
    const real slide2_u_tau = tau[11]; /* N */
    const real hooke2_R_zz = work[557];
    const real slide2_drive = rod2_mass * (gravity_z * hooke2_R_zz + slide2_q * tube2_minus_U_zz)
        + rod2_base_moment_z * tube2_minus_U_zz + drive2 + slide2_u_tau;

    /* slide3: drive */
    /* drive = tau + f - h */
    const real drive3 = r[3];
    const real slide3_u_tau = tau[14]; /* N */
    const real hooke3_R_zz = work[622];
    const real slide3_drive = rod3_mass * (gravity_z * hooke3_R_zz + slide3_q * tube3_minus_U_zz)
        + rod3_base_moment_z * tube3_minus_U_zz + drive3 + slide3_u_tau;

    /* slide4: drive */
    /* drive = tau + f - h */
    const real drive4 = r[4];
    const real slide4_u_tau = tau[17]; /* N */
    const real hooke4_R_zz = work[680];
    const real slide4_drive = rod4_mass * (gravity_z * hooke4_R_zz + slide4_q * tube4_minus_U_zz)
        + rod4_base_moment_z * tube4_minus_U_zz + drive4 + slide4_u_tau;

    /* slide5: drive */
    /* drive = tau + f - h */
    const real drive5 = r[5];
    const real slide5_u_tau = tau[20]; /* N */
    const real hooke5_R_zz = work[729];
    const real slide5_drive = rod5_mass * (gravity_z * hooke5_R_zz + slide5_q * tube5_minus_U_zz)
        + rod5_base_moment_z * tube5_minus_U_zz + drive5 + slide5_u_tau;

    /* ball1: rate */
    /* rate = G u + g_t */
    const real ball1_twist_vx = work[548];
    const real ball1_R_xx_rate_part = work[513];
    const real hooke1_minus_R_zx = work[458];
    const real ball1_platform_R_zx_rate = work[507];
    const real ball1_platform_R_zx = work[431];
    const real hooke1_minus_R_zx_rate = work[463];
    const real ball1_R_xx = work[465];
    const real ball1_twist_vx_rate = work[551];
    const real ball1_twist_vx_times_R_xx_rate_plus_R_xx_times_twist_vx_rate = ball1_twist_vx *
        (ball1_R_xx_rate_part - (hooke1_minus_R_zx * ball1_platform_R_zx_rate
        + ball1_platform_R_zx * hooke1_minus_R_zx_rate)) + ball1_R_xx * ball1_twist_vx_rate;
    const real ball1_twist_vy = work[549];
    const real ball1_R_xy_rate_part = work[514];
    const real ball1_platform_R_zy_rate = work[508];
    const real ball1_platform_R_zy = work[432];
    const real ball1_R_xy = work[466];
    const real ball1_twist_vy_rate = work[552];
    const real ball1_rate_px_rate_part = ball1_twist_vy * (ball1_R_xy_rate_part
        - (hooke1_minus_R_zx * ball1_platform_R_zy_rate
        + ball1_platform_R_zy * hooke1_minus_R_zx_rate)) + ball1_R_xy * ball1_twist_vy_rate
        + ball1_twist_vx_times_R_xx_rate_plus_R_xx_times_twist_vx_rate;
    work[390] = ball1_rate_px_rate_part;
    const real hooke1_angle1_cos = work[394];
    const real ball1_platform_R_yx_rate = work[504];
    const real ball1_platform_R_yx = work[428];
    const real hooke1_u_angle1_times_angle1_sin = work[461];
    const real hooke1_angle1_sin = work[395];
    const real hooke1_u_angle1_times_angle1_cos = work[462];
    const real ball1_twist_vx_times_R_yx_rate = ball1_twist_vx * (hooke1_angle1_cos *
        ball1_platform_R_yx_rate - ball1_platform_R_yx * hooke1_u_angle1_times_angle1_sin
        + (hooke1_angle1_sin * ball1_platform_R_zx_rate
        + ball1_platform_R_zx * hooke1_u_angle1_times_angle1_cos));
    work[391] = ball1_twist_vx_times_R_yx_rate;
    const real ball1_platform_R_yy_rate = work[505];
    const real ball1_platform_R_yy = work[429];
    const real ball1_twist_vy_times_R_yy_rate = ball1_twist_vy * (hooke1_angle1_cos *
        ball1_platform_R_yy_rate - ball1_platform_R_yy * hooke1_u_angle1_times_angle1_sin
        + (hooke1_angle1_sin * ball1_platform_R_zy_rate
        + ball1_platform_R_zy * hooke1_u_angle1_times_angle1_cos));
    work[406] = ball1_twist_vy_times_R_yy_rate;
    const real ball1_twist_vz = work[550];
    const real ball1_platform_R_yz_rate = work[506];
    const real ball1_platform_R_yz = work[430];
    const real ball1_platform_R_zz_rate = work[509];
    const real ball1_platform_R_zz = work[433];
    const real ball1_twist_vz_times_R_yz_rate = ball1_twist_vz * (hooke1_angle1_cos *
        ball1_platform_R_yz_rate - ball1_platform_R_yz * hooke1_u_angle1_times_angle1_sin
        + (hooke1_angle1_sin * ball1_platform_R_zz_rate
        + ball1_platform_R_zz * hooke1_u_angle1_times_angle1_cos));
    work[407] = ball1_twist_vz_times_R_yz_rate;
    const real ball1_R_zx_rate_part = work[516];
    const real hooke1_minus_R_zz_rate = work[464];
    const real ball1_R_zx = work[471];
    const real ball1_twist_vx_times_R_zx_rate_plus_R_zx_times_twist_vx_rate = ball1_twist_vx *
        (hooke1_R_zz * ball1_platform_R_zx_rate - ball1_platform_R_zx * hooke1_minus_R_zz_rate
        + ball1_R_zx_rate_part) + ball1_R_zx * ball1_twist_vx_rate;
    const real ball1_R_zy_rate_part = work[517];
    const real ball1_R_zy = work[472];
    const real ball1_rate_pz_rate_part = ball1_twist_vy * (hooke1_R_zz * ball1_platform_R_zy_rate
        - ball1_platform_R_zy * hooke1_minus_R_zz_rate + ball1_R_zy_rate_part)
        + ball1_R_zy * ball1_twist_vy_rate
        + ball1_twist_vx_times_R_zx_rate_plus_R_zx_times_twist_vx_rate;
    work[410] = ball1_rate_pz_rate_part;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal M_factor_D_inverse_slide5 = w[96];
    const wreal M_factor_D_inverse_slide4 = w[97];
    const wreal M_factor_D_inverse_slide3 = w[98];
    const wreal M_factor_D_inverse_slide2 = w[99];
    const wreal M_factor_D_inverse_slide1 = w[100];
    const wreal M_factor_D_inverse_ball0_z = w[101];
    const wreal M_factor_L_ball0_z_ball0_y = w[102];
    const wreal M_factor_L_ball0_z_ball0_x = w[103];
    const wreal M_factor_D_inverse_ball0_y = w[104];
    const wreal M_minus_factor_L_ball0_y_ball0_x = w[105];
    const wreal M_factor_D_inverse_ball0_x = w[106];
    const real tube5_composite_inertia_yy = work[770];
    const real M_factor_D_inverse_hooke5_angle2 = 1.0 / tube5_composite_inertia_yy;
    work[411] = M_factor_D_inverse_hooke5_angle2;
    const real M_hooke5_angle1_hooke5_angle1 = work[793];
    const real M_factor_D_inverse_hooke5_angle1 = 1.0 / M_hooke5_angle1_hooke5_angle1;
    work[414] = M_factor_D_inverse_hooke5_angle1;
    const real tube4_composite_inertia_yy = work[715];
    const real M_factor_D_inverse_hooke4_angle2 = 1.0 / tube4_composite_inertia_yy;
    work[425] = M_factor_D_inverse_hooke4_angle2;
    const real M_hooke4_angle1_hooke4_angle1 = work[794];
    const real M_factor_D_inverse_hooke4_angle1 = 1.0 / M_hooke4_angle1_hooke4_angle1;
    work[426] = M_factor_D_inverse_hooke4_angle1;
    const real tube3_composite_inertia_yy = work[664];
    const real M_factor_D_inverse_hooke3_angle2 = 1.0 / tube3_composite_inertia_yy;
    const real M_hooke3_angle1_hooke3_angle1 = work[795];
    const real M_factor_D_inverse_hooke3_angle1 = 1.0 / M_hooke3_angle1_hooke3_angle1;
    const real tube2_composite_inertia_yy = work[608];
    const real M_factor_D_inverse_hooke2_angle2 = 1.0 / tube2_composite_inertia_yy;
    const real M_hooke2_angle1_hooke2_angle1 = work[796];
    const real M_factor_D_inverse_hooke2_angle1 = 1.0 / M_hooke2_angle1_hooke2_angle1;
    const real tube1_composite_inertia_yy = work[544];
    const real M_factor_D_inverse_hooke1_angle2 = 1.0 / tube1_composite_inertia_yy;
    const real M_hooke1_angle1_hooke1_angle1 = work[797];
    const real M_factor_D_inverse_hooke1_angle1 = 1.0 / M_hooke1_angle1_hooke1_angle1;
    const real M_factor_DL_ball0_y_hooke0_angle1 = M_ball0_y_hooke0_angle1
        - M_ball0_z_hooke0_angle1 * M_factor_L_ball0_z_ball0_y;
    const real M_factor_DL_ball0_y_hooke0_angle2 = M_ball0_y_hooke0_angle2
        - M_ball0_z_hooke0_angle2 * M_factor_L_ball0_z_ball0_y;
    const real M_ball0_y_slide0 = work[798];
    const real M_ball0_z_slide0 = work[799];
    const real M_factor_DL_ball0_y_slide0 = M_ball0_y_slide0
        - M_ball0_z_slide0 * M_factor_L_ball0_z_ball0_y;
    const real M_factor_L_ball0_z_slide0 = M_ball0_z_slide0 * M_factor_D_inverse_ball0_z;
    work[427] = M_factor_L_ball0_z_slide0;
    const real M_factor_L_ball0_z_hooke0_angle2 = M_ball0_z_hooke0_angle2 *
        M_factor_D_inverse_ball0_z;
    work[434] = M_factor_L_ball0_z_hooke0_angle2;
    const real M_factor_L_ball0_z_hooke0_angle1 = M_ball0_z_hooke0_angle1 *
        M_factor_D_inverse_ball0_z;
    work[435] = M_factor_L_ball0_z_hooke0_angle1;
    const real M_factor_DL_ball0_x_hooke0_angle1 = M_ball0_x_hooke0_angle1
        - M_ball0_z_hooke0_angle1 * M_factor_L_ball0_z_ball0_x
        + M_factor_DL_ball0_y_hooke0_angle1 * M_minus_factor_L_ball0_y_ball0_x;
    const real M_factor_DL_ball0_x_hooke0_angle2 = M_ball0_x_hooke0_angle2
        - M_ball0_z_hooke0_angle2 * M_factor_L_ball0_z_ball0_x
        + M_factor_DL_ball0_y_hooke0_angle2 * M_minus_factor_L_ball0_y_ball0_x;
    const real M_factor_DL_ball0_x_slide0 = M_factor_DL_ball0_y_slide0 *
        M_minus_factor_L_ball0_y_ball0_x - (platform_first_moment_z * ball0_R_zy
        + momentum_ball0_z_fx * ball0_R_zz + M_ball0_z_slide0 * M_factor_L_ball0_z_ball0_x);
    const real M_factor_L_ball0_y_slide0 = M_factor_DL_ball0_y_slide0 * M_factor_D_inverse_ball0_y;
    work[436] = M_factor_L_ball0_y_slide0;
    const real M_factor_L_ball0_y_hooke0_angle2 = M_factor_DL_ball0_y_hooke0_angle2 *
        M_factor_D_inverse_ball0_y;
    work[437] = M_factor_L_ball0_y_hooke0_angle2;
    const real M_factor_L_ball0_y_hooke0_angle1 = M_factor_DL_ball0_y_hooke0_angle1 *
        M_factor_D_inverse_ball0_y;
    work[438] = M_factor_L_ball0_y_hooke0_angle1;
    const real M_factor_L_ball0_x_slide0 = M_factor_DL_ball0_x_slide0 * M_factor_D_inverse_ball0_x;
    work[439] = M_factor_L_ball0_x_slide0;
    const real momentum_hooke0_angle1_fz = work[791];
    const real M_factor_DL_slide0_hooke0_angle1 = momentum_hooke0_angle1_fz
        - M_ball0_z_hooke0_angle1 * M_factor_L_ball0_z_slide0
        - M_factor_DL_ball0_y_hooke0_angle1 * M_factor_L_ball0_y_slide0
        - M_factor_DL_ball0_x_hooke0_angle1 * M_factor_L_ball0_x_slide0;
    const real rod0_composite_moment_x = work[783];
    const real M_minus_factor_DL_slide0_hooke0_angle2 = rod0_composite_moment_x
        + M_ball0_z_hooke0_angle2 * M_factor_L_ball0_z_slide0
        + M_factor_DL_ball0_y_hooke0_angle2 * M_factor_L_ball0_y_slide0
        + M_factor_DL_ball0_x_hooke0_angle2 * M_factor_L_ball0_x_slide0;
    const real M_factor_L_ball0_x_hooke0_angle2 = M_factor_DL_ball0_x_hooke0_angle2 *
        M_factor_D_inverse_ball0_x;
    work[440] = M_factor_L_ball0_x_hooke0_angle2;
    const real momentum_hooke0_angle1_my = work[792];
    const real M_factor_DL_hooke0_angle2_hooke0_angle1_part = momentum_hooke0_angle1_my
        - M_ball0_z_hooke0_angle1 * M_factor_L_ball0_z_hooke0_angle2
        - M_factor_DL_ball0_y_hooke0_angle1 * M_factor_L_ball0_y_hooke0_angle2
        - M_factor_DL_ball0_x_hooke0_angle1 * M_factor_L_ball0_x_hooke0_angle2;
    const real tube0_composite_inertia_yy = work[786];
    const real M_factor_D_hooke0_angle2_part = tube0_composite_inertia_yy
        - M_ball0_z_hooke0_angle2 * M_factor_L_ball0_z_hooke0_angle2
        - M_factor_DL_ball0_y_hooke0_angle2 * M_factor_L_ball0_y_hooke0_angle2
        - M_factor_DL_ball0_x_hooke0_angle2 * M_factor_L_ball0_x_hooke0_angle2;
    const real M_factor_L_ball0_x_hooke0_angle1 = M_factor_DL_ball0_x_hooke0_angle1 *
        M_factor_D_inverse_ball0_x;
    work[441] = M_factor_L_ball0_x_hooke0_angle1;
    const real M_hooke0_angle1_hooke0_angle1 = work[800];
    const real M_factor_D_hooke0_angle1_part = M_hooke0_angle1_hooke0_angle1
        - M_ball0_z_hooke0_angle1 * M_factor_L_ball0_z_hooke0_angle1
        - M_factor_DL_ball0_y_hooke0_angle1 * M_factor_L_ball0_y_hooke0_angle1
        - M_factor_DL_ball0_x_hooke0_angle1 * M_factor_L_ball0_x_hooke0_angle1;
    const real M_factor_D_inverse_slide0 = 1.0 / (rod0_base_mass
        - M_ball0_z_slide0 * M_factor_L_ball0_z_slide0
        - M_factor_DL_ball0_y_slide0 * M_factor_L_ball0_y_slide0
        - M_factor_DL_ball0_x_slide0 * M_factor_L_ball0_x_slide0);
    work[442] = M_factor_D_inverse_slide0;
    const real M_minus_factor_L_slide0_hooke0_angle2 = M_minus_factor_DL_slide0_hooke0_angle2 *
        M_factor_D_inverse_slide0;
    work[443] = M_minus_factor_L_slide0_hooke0_angle2;
    const real M_factor_DL_hooke0_angle2_hooke0_angle1 =
        M_factor_DL_hooke0_angle2_hooke0_angle1_part
        + M_factor_DL_slide0_hooke0_angle1 * M_minus_factor_L_slide0_hooke0_angle2;
    const real M_factor_L_slide0_hooke0_angle1 = M_factor_DL_slide0_hooke0_angle1 *
        M_factor_D_inverse_slide0;
    work[444] = M_factor_L_slide0_hooke0_angle1;
    const real M_factor_D_inverse_hooke0_angle2 = 1.0 / (M_factor_D_hooke0_angle2_part
        - M_minus_factor_DL_slide0_hooke0_angle2 * M_minus_factor_L_slide0_hooke0_angle2);
    work[445] = M_factor_D_inverse_hooke0_angle2;
    const real M_factor_L_hooke0_angle2_hooke0_angle1 = M_factor_DL_hooke0_angle2_hooke0_angle1 *
        M_factor_D_inverse_hooke0_angle2;
    work[446] = M_factor_L_hooke0_angle2_hooke0_angle1;
    const real M_factor_D_inverse_hooke0_angle1 = 1.0 / (M_factor_D_hooke0_angle1_part
        - M_factor_DL_slide0_hooke0_angle1 * M_factor_L_slide0_hooke0_angle1
        - M_factor_DL_hooke0_angle2_hooke0_angle1 * M_factor_L_hooke0_angle2_hooke0_angle1);
    work[447] = M_factor_D_inverse_hooke0_angle1;
    const real free_y_ball0_y = ball0_drive_y - ball0_drive_z * M_factor_L_ball0_z_ball0_y;
    const real free_y_ball0_x = ball0_drive_x - ball0_drive_z * M_factor_L_ball0_z_ball0_x
        + M_minus_factor_L_ball0_y_ball0_x * free_y_ball0_y;
    const real free_y_slide0 = slide0_drive - ball0_drive_z * M_factor_L_ball0_z_slide0
        - M_factor_L_ball0_y_slide0 * free_y_ball0_y - M_factor_L_ball0_x_slide0 * free_y_ball0_x;
    const real free_y_hooke0_angle1_part = hooke0_drive_angle1
        - ball0_drive_z * M_factor_L_ball0_z_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle1 * free_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle1 * free_y_ball0_x
        - M_factor_L_slide0_hooke0_angle1 * free_y_slide0;
    const real free_y_hooke0_angle2 = hooke0_drive_angle2
        - ball0_drive_z * M_factor_L_ball0_z_hooke0_angle2
        - M_factor_L_ball0_y_hooke0_angle2 * free_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle2 * free_y_ball0_x
        + M_minus_factor_L_slide0_hooke0_angle2 * free_y_slide0;
    const real free_udot_hooke0_angle1 = M_factor_D_inverse_hooke0_angle1 *
        (free_y_hooke0_angle1_part - M_factor_L_hooke0_angle2_hooke0_angle1 * free_y_hooke0_angle2);
    work[448] = free_udot_hooke0_angle1;
    const real free_udot_hooke1_angle1 = hooke1_drive_angle1 * M_factor_D_inverse_hooke1_angle1;
    work[501] = free_udot_hooke1_angle1;
    const real free_udot_hooke1_angle2 = hooke1_drive_angle2 * M_factor_D_inverse_hooke1_angle2;
    work[502] = free_udot_hooke1_angle2;
    const real free_udot_slide1 = slide1_drive * M_factor_D_inverse_slide1;
    work[503] = free_udot_slide1;
    const real free_udot_hooke2_angle1 = hooke2_drive_angle1 * M_factor_D_inverse_hooke2_angle1;
    work[510] = free_udot_hooke2_angle1;
    const real free_udot_hooke2_angle2 = hooke2_drive_angle2 * M_factor_D_inverse_hooke2_angle2;
    work[511] = free_udot_hooke2_angle2;
    const real free_udot_slide2 = slide2_drive * M_factor_D_inverse_slide2;
    work[512] = free_udot_slide2;
    const real free_udot_hooke3_angle1 = hooke3_drive_angle1 * M_factor_D_inverse_hooke3_angle1;
    work[519] = free_udot_hooke3_angle1;
    const real free_udot_hooke3_angle2 = hooke3_drive_angle2 * M_factor_D_inverse_hooke3_angle2;
    work[520] = free_udot_hooke3_angle2;
    const real free_udot_slide3 = slide3_drive * M_factor_D_inverse_slide3;
    work[521] = free_udot_slide3;
    const real free_udot_hooke4_angle1 = hooke4_drive_angle1 * M_factor_D_inverse_hooke4_angle1;
    work[522] = free_udot_hooke4_angle1;
    const real free_udot_hooke4_angle2 = hooke4_drive_angle2 * M_factor_D_inverse_hooke4_angle2;
    work[523] = free_udot_hooke4_angle2;
    const real free_udot_slide4 = slide4_drive * M_factor_D_inverse_slide4;
    work[524] = free_udot_slide4;
    const real free_udot_hooke5_angle1 = hooke5_drive_angle1 * M_factor_D_inverse_hooke5_angle1;
    work[531] = free_udot_hooke5_angle1;
    const real free_udot_hooke5_angle2 = hooke5_drive_angle2 * M_factor_D_inverse_hooke5_angle2;
    work[532] = free_udot_hooke5_angle2;
    const real free_udot_slide5 = slide5_drive * M_factor_D_inverse_slide5;
    work[533] = free_udot_slide5;
    const real free_udot_hooke0_angle2 = M_factor_D_inverse_hooke0_angle2 * free_y_hooke0_angle2
        - M_factor_L_hooke0_angle2_hooke0_angle1 * free_udot_hooke0_angle1;
    work[534] = free_udot_hooke0_angle2;
    const real free_udot_slide0 = M_factor_D_inverse_slide0 * free_y_slide0
        - M_factor_L_slide0_hooke0_angle1 * free_udot_hooke0_angle1
        + M_minus_factor_L_slide0_hooke0_angle2 * free_udot_hooke0_angle2;
    work[535] = free_udot_slide0;
    const real free_udot_ball0_x = M_factor_D_inverse_ball0_x * free_y_ball0_x
        - M_factor_L_ball0_x_hooke0_angle1 * free_udot_hooke0_angle1
        - M_factor_L_ball0_x_hooke0_angle2 * free_udot_hooke0_angle2
        - M_factor_L_ball0_x_slide0 * free_udot_slide0;
    work[537] = free_udot_ball0_x;
    const real free_udot_ball0_y = M_factor_D_inverse_ball0_y * free_y_ball0_y
        - M_factor_L_ball0_y_hooke0_angle1 * free_udot_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle2 * free_udot_hooke0_angle2
        - M_factor_L_ball0_y_slide0 * free_udot_slide0
        + M_minus_factor_L_ball0_y_ball0_x * free_udot_ball0_x;
    work[538] = free_udot_ball0_y;
    const real free_udot_ball0_z_part = ball0_drive_z * M_factor_D_inverse_ball0_z
        - M_factor_L_ball0_z_hooke0_angle1 * free_udot_hooke0_angle1
        - M_factor_L_ball0_z_hooke0_angle2 * free_udot_hooke0_angle2
        - M_factor_L_ball0_z_slide0 * free_udot_slide0
        - M_factor_L_ball0_z_ball0_x * free_udot_ball0_x;
    const real free_udot_ball0_z = free_udot_ball0_z_part
        - M_factor_L_ball0_z_ball0_y * free_udot_ball0_y;
    work[539] = free_udot_ball0_z;
    const real ball1_G_px_ball0_y = work[478];
    const real ball1_G_px_ball0_z = work[479];
    const real ball1_px_y_ball0_y = ball1_G_px_ball0_y
        - ball1_G_px_ball0_z * M_factor_L_ball0_z_ball0_y;
    const real ball1_G_px_ball0_x = work[477];
    const real ball1_px_y_ball0_x = ball1_G_px_ball0_x
        - ball1_G_px_ball0_z * M_factor_L_ball0_z_ball0_x
        + M_minus_factor_L_ball0_y_ball0_x * ball1_px_y_ball0_y;
    const real ball1_G_px_slide0 = work[476];
    const real ball1_px_y_slide0 = ball1_G_px_slide0
        - ball1_G_px_ball0_z * M_factor_L_ball0_z_slide0
        - M_factor_L_ball0_y_slide0 * ball1_px_y_ball0_y
        - M_factor_L_ball0_x_slide0 * ball1_px_y_ball0_x;
    const real ball1_G_px_hooke0_angle1 = work[474];
    const real ball1_px_y_hooke0_angle1_part = ball1_G_px_hooke0_angle1
        - ball1_G_px_ball0_z * M_factor_L_ball0_z_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle1 * ball1_px_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle1 * ball1_px_y_ball0_x
        - M_factor_L_slide0_hooke0_angle1 * ball1_px_y_slide0;
    const real ball1_G_px_hooke0_angle2 = work[475];
    const real ball1_px_y_hooke0_angle2 = ball1_G_px_hooke0_angle2
        - ball1_G_px_ball0_z * M_factor_L_ball0_z_hooke0_angle2
        - M_factor_L_ball0_y_hooke0_angle2 * ball1_px_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle2 * ball1_px_y_ball0_x
        + M_minus_factor_L_slide0_hooke0_angle2 * ball1_px_y_slide0;
    const real ball1_px_response_hooke0_angle1 = M_factor_D_inverse_hooke0_angle1 *
        (ball1_px_y_hooke0_angle1_part
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball1_px_y_hooke0_angle2);
    work[543] = ball1_px_response_hooke0_angle1;
    const real ball1_minus_G_px_hooke1_angle1 = work[480];
    const real ball1_px_minus_response_hooke1_angle1 = ball1_minus_G_px_hooke1_angle1 *
        M_factor_D_inverse_hooke1_angle1;
    work[607] = ball1_px_minus_response_hooke1_angle1;
    const real ball1_G_px_hooke1_angle2 = work[481];
    const real ball1_px_response_hooke1_angle2 = ball1_G_px_hooke1_angle2 *
        M_factor_D_inverse_hooke1_angle2;
    work[663] = ball1_px_response_hooke1_angle2;
    const real ball1_minus_G_px_slide1 = work[482];
    const real ball1_px_minus_response_slide1 = ball1_minus_G_px_slide1 * M_factor_D_inverse_slide1;
    work[677] = ball1_px_minus_response_slide1;
    const real ball1_px_response_hooke0_angle2 = M_factor_D_inverse_hooke0_angle2 *
        ball1_px_y_hooke0_angle2
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball1_px_response_hooke0_angle1;
    work[678] = ball1_px_response_hooke0_angle2;
    const real ball1_px_response_slide0 = M_factor_D_inverse_slide0 * ball1_px_y_slide0
        - M_factor_L_slide0_hooke0_angle1 * ball1_px_response_hooke0_angle1
        + M_minus_factor_L_slide0_hooke0_angle2 * ball1_px_response_hooke0_angle2;
    work[681] = ball1_px_response_slide0;
    const real ball1_px_response_ball0_x = M_factor_D_inverse_ball0_x * ball1_px_y_ball0_x
        - M_factor_L_ball0_x_hooke0_angle1 * ball1_px_response_hooke0_angle1
        - M_factor_L_ball0_x_hooke0_angle2 * ball1_px_response_hooke0_angle2
        - M_factor_L_ball0_x_slide0 * ball1_px_response_slide0;
    work[683] = ball1_px_response_ball0_x;
    const real ball1_px_response_ball0_y_part = M_factor_D_inverse_ball0_y * ball1_px_y_ball0_y
        - M_factor_L_ball0_y_hooke0_angle1 * ball1_px_response_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle2 * ball1_px_response_hooke0_angle2
        - M_factor_L_ball0_y_slide0 * ball1_px_response_slide0;
    const real ball1_px_response_ball0_y = ball1_px_response_ball0_y_part
        + M_minus_factor_L_ball0_y_ball0_x * ball1_px_response_ball0_x;
    work[684] = ball1_px_response_ball0_y;
    const real ball1_px_response_ball0_z_part = ball1_G_px_ball0_z * M_factor_D_inverse_ball0_z
        - M_factor_L_ball0_z_hooke0_angle1 * ball1_px_response_hooke0_angle1
        - M_factor_L_ball0_z_hooke0_angle2 * ball1_px_response_hooke0_angle2
        - M_factor_L_ball0_z_slide0 * ball1_px_response_slide0;
    const real ball1_px_response_ball0_z = ball1_px_response_ball0_z_part
        - M_factor_L_ball0_z_ball0_x * ball1_px_response_ball0_x
        - M_factor_L_ball0_z_ball0_y * ball1_px_response_ball0_y;
    work[685] = ball1_px_response_ball0_z;
    const real ball1_G_py_ball0_y = work[487];
    const real ball1_G_py_ball0_z = work[488];
    const real ball1_py_y_ball0_y = ball1_G_py_ball0_y
        - ball1_G_py_ball0_z * M_factor_L_ball0_z_ball0_y;
    const real ball1_G_py_ball0_x = work[486];
    const real ball1_py_y_ball0_x = ball1_G_py_ball0_x
        - ball1_G_py_ball0_z * M_factor_L_ball0_z_ball0_x
        + M_minus_factor_L_ball0_y_ball0_x * ball1_py_y_ball0_y;
    const real ball1_G_py_slide0 = work[485];
    const real ball1_py_y_slide0 = ball1_G_py_slide0
        - ball1_G_py_ball0_z * M_factor_L_ball0_z_slide0
        - M_factor_L_ball0_y_slide0 * ball1_py_y_ball0_y
        - M_factor_L_ball0_x_slide0 * ball1_py_y_ball0_x;
    const real ball1_G_py_hooke0_angle1 = work[483];
    const real ball1_py_y_hooke0_angle1_part = ball1_G_py_hooke0_angle1
        - ball1_G_py_ball0_z * M_factor_L_ball0_z_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle1 * ball1_py_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle1 * ball1_py_y_ball0_x
        - M_factor_L_slide0_hooke0_angle1 * ball1_py_y_slide0;
    const real ball1_G_py_hooke0_angle2 = work[484];
    const real ball1_py_y_hooke0_angle2 = ball1_G_py_hooke0_angle2
        - ball1_G_py_ball0_z * M_factor_L_ball0_z_hooke0_angle2
        - M_factor_L_ball0_y_hooke0_angle2 * ball1_py_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle2 * ball1_py_y_ball0_x
        + M_minus_factor_L_slide0_hooke0_angle2 * ball1_py_y_slide0;
    const real ball1_py_response_hooke0_angle1 = M_factor_D_inverse_hooke0_angle1 *
        (ball1_py_y_hooke0_angle1_part
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball1_py_y_hooke0_angle2);
    work[686] = ball1_py_response_hooke0_angle1;
    const real ball1_minus_G_py_hooke1_angle1 = work[489];
    const real ball1_py_minus_response_hooke1_angle1 = ball1_minus_G_py_hooke1_angle1 *
        M_factor_D_inverse_hooke1_angle1;
    work[687] = ball1_py_minus_response_hooke1_angle1;
    const real ball1_G_py_hooke1_angle2 = work[490];
    const real ball1_py_response_hooke1_angle2 = ball1_G_py_hooke1_angle2 *
        M_factor_D_inverse_hooke1_angle2;
    work[688] = ball1_py_response_hooke1_angle2;
    const real ball1_minus_G_py_slide1 = work[491];
    const real ball1_py_minus_response_slide1 = ball1_minus_G_py_slide1 * M_factor_D_inverse_slide1;
    work[691] = ball1_py_minus_response_slide1;
    const real ball1_py_response_hooke0_angle2 = M_factor_D_inverse_hooke0_angle2 *
        ball1_py_y_hooke0_angle2
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball1_py_response_hooke0_angle1;
    work[692] = ball1_py_response_hooke0_angle2;
    const real ball1_py_response_slide0 = M_factor_D_inverse_slide0 * ball1_py_y_slide0
        - M_factor_L_slide0_hooke0_angle1 * ball1_py_response_hooke0_angle1
        + M_minus_factor_L_slide0_hooke0_angle2 * ball1_py_response_hooke0_angle2;
    work[801] = ball1_py_response_slide0;
    const real ball1_py_response_ball0_x = M_factor_D_inverse_ball0_x * ball1_py_y_ball0_x
        - M_factor_L_ball0_x_hooke0_angle1 * ball1_py_response_hooke0_angle1
        - M_factor_L_ball0_x_hooke0_angle2 * ball1_py_response_hooke0_angle2
        - M_factor_L_ball0_x_slide0 * ball1_py_response_slide0;
    work[802] = ball1_py_response_ball0_x;
    const real ball1_py_response_ball0_y_part = M_factor_D_inverse_ball0_y * ball1_py_y_ball0_y
        - M_factor_L_ball0_y_hooke0_angle1 * ball1_py_response_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle2 * ball1_py_response_hooke0_angle2
        - M_factor_L_ball0_y_slide0 * ball1_py_response_slide0;
    const real ball1_py_response_ball0_y = ball1_py_response_ball0_y_part
        + M_minus_factor_L_ball0_y_ball0_x * ball1_py_response_ball0_x;
    work[803] = ball1_py_response_ball0_y;
    const real ball1_py_response_ball0_z_part = ball1_G_py_ball0_z * M_factor_D_inverse_ball0_z
        - M_factor_L_ball0_z_hooke0_angle1 * ball1_py_response_hooke0_angle1
        - M_factor_L_ball0_z_hooke0_angle2 * ball1_py_response_hooke0_angle2
        - M_factor_L_ball0_z_slide0 * ball1_py_response_slide0;
    const real ball1_py_response_ball0_z = ball1_py_response_ball0_z_part
        - M_factor_L_ball0_z_ball0_x * ball1_py_response_ball0_x
        - M_factor_L_ball0_z_ball0_y * ball1_py_response_ball0_y;
    work[804] = ball1_py_response_ball0_z;
    const real ball1_G_pz_ball0_y = work[496];
    const real ball1_G_pz_ball0_z = work[497];
    const real ball1_pz_y_ball0_y = ball1_G_pz_ball0_y
        - ball1_G_pz_ball0_z * M_factor_L_ball0_z_ball0_y;
    const real ball1_G_pz_ball0_x = work[495];
    const real ball1_pz_y_ball0_x = ball1_G_pz_ball0_x
        - ball1_G_pz_ball0_z * M_factor_L_ball0_z_ball0_x
        + M_minus_factor_L_ball0_y_ball0_x * ball1_pz_y_ball0_y;
    const real ball1_G_pz_slide0 = work[494];
    const real ball1_pz_y_slide0 = ball1_G_pz_slide0
        - ball1_G_pz_ball0_z * M_factor_L_ball0_z_slide0
        - M_factor_L_ball0_y_slide0 * ball1_pz_y_ball0_y
        - M_factor_L_ball0_x_slide0 * ball1_pz_y_ball0_x;
    const real ball1_G_pz_hooke0_angle1 = work[492];
    const real ball1_pz_y_hooke0_angle1_part = ball1_G_pz_hooke0_angle1
        - ball1_G_pz_ball0_z * M_factor_L_ball0_z_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle1 * ball1_pz_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle1 * ball1_pz_y_ball0_x
        - M_factor_L_slide0_hooke0_angle1 * ball1_pz_y_slide0;
    const real ball1_G_pz_hooke0_angle2 = work[493];
    const real ball1_pz_y_hooke0_angle2 = ball1_G_pz_hooke0_angle2
        - ball1_G_pz_ball0_z * M_factor_L_ball0_z_hooke0_angle2
        - M_factor_L_ball0_y_hooke0_angle2 * ball1_pz_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle2 * ball1_pz_y_ball0_x
        + M_minus_factor_L_slide0_hooke0_angle2 * ball1_pz_y_slide0;
    const real ball1_pz_response_hooke0_angle1 = M_factor_D_inverse_hooke0_angle1 *
        (ball1_pz_y_hooke0_angle1_part
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball1_pz_y_hooke0_angle2);
    work[805] = ball1_pz_response_hooke0_angle1;
    const real ball1_minus_G_pz_hooke1_angle1 = work[498];
    const real ball1_pz_minus_response_hooke1_angle1 = ball1_minus_G_pz_hooke1_angle1 *
        M_factor_D_inverse_hooke1_angle1;
    work[806] = ball1_pz_minus_response_hooke1_angle1;
    const real ball1_G_pz_hooke1_angle2 = work[499];
    const real ball1_pz_response_hooke1_angle2 = ball1_G_pz_hooke1_angle2 *
        M_factor_D_inverse_hooke1_angle2;
    work[807] = ball1_pz_response_hooke1_angle2;
    const real ball1_minus_G_pz_slide1 = work[500];
    const real ball1_pz_minus_response_slide1 = ball1_minus_G_pz_slide1 * M_factor_D_inverse_slide1;
    work[808] = ball1_pz_minus_response_slide1;
    const real ball1_pz_response_hooke0_angle2 = M_factor_D_inverse_hooke0_angle2 *
        ball1_pz_y_hooke0_angle2
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball1_pz_response_hooke0_angle1;
    work[809] = ball1_pz_response_hooke0_angle2;
    const real ball1_pz_response_slide0 = M_factor_D_inverse_slide0 * ball1_pz_y_slide0
        - M_factor_L_slide0_hooke0_angle1 * ball1_pz_response_hooke0_angle1
        + M_minus_factor_L_slide0_hooke0_angle2 * ball1_pz_response_hooke0_angle2;
    work[810] = ball1_pz_response_slide0;
    const real ball1_pz_response_ball0_x = M_factor_D_inverse_ball0_x * ball1_pz_y_ball0_x
        - M_factor_L_ball0_x_hooke0_angle1 * ball1_pz_response_hooke0_angle1
        - M_factor_L_ball0_x_hooke0_angle2 * ball1_pz_response_hooke0_angle2
        - M_factor_L_ball0_x_slide0 * ball1_pz_response_slide0;
    work[811] = ball1_pz_response_ball0_x;
    const real ball1_pz_response_ball0_y_part = M_factor_D_inverse_ball0_y * ball1_pz_y_ball0_y
        - M_factor_L_ball0_y_hooke0_angle1 * ball1_pz_response_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle2 * ball1_pz_response_hooke0_angle2
        - M_factor_L_ball0_y_slide0 * ball1_pz_response_slide0;
    const real ball1_pz_response_ball0_y = ball1_pz_response_ball0_y_part
        + M_minus_factor_L_ball0_y_ball0_x * ball1_pz_response_ball0_x;
    work[812] = ball1_pz_response_ball0_y;
    const real ball1_pz_response_ball0_z_part = ball1_G_pz_ball0_z * M_factor_D_inverse_ball0_z
        - M_factor_L_ball0_z_hooke0_angle1 * ball1_pz_response_hooke0_angle1
        - M_factor_L_ball0_z_hooke0_angle2 * ball1_pz_response_hooke0_angle2
        - M_factor_L_ball0_z_slide0 * ball1_pz_response_slide0;
    const real ball1_pz_response_ball0_z = ball1_pz_response_ball0_z_part
        - M_factor_L_ball0_z_ball0_x * ball1_pz_response_ball0_x
        - M_factor_L_ball0_z_ball0_y * ball1_pz_response_ball0_y;
    work[813] = ball1_pz_response_ball0_z;
    const real ball2_G_px_ball0_y = work[579];
    const real ball2_G_px_ball0_z = work[580];
    const real ball2_px_y_ball0_y = ball2_G_px_ball0_y
        - ball2_G_px_ball0_z * M_factor_L_ball0_z_ball0_y;
    const real ball2_G_px_ball0_x = work[578];
    const real ball2_px_y_ball0_x = ball2_G_px_ball0_x
        - ball2_G_px_ball0_z * M_factor_L_ball0_z_ball0_x
        + M_minus_factor_L_ball0_y_ball0_x * ball2_px_y_ball0_y;
    const real ball2_G_px_slide0 = work[577];
    const real ball2_px_y_slide0 = ball2_G_px_slide0
        - ball2_G_px_ball0_z * M_factor_L_ball0_z_slide0
        - M_factor_L_ball0_y_slide0 * ball2_px_y_ball0_y
        - M_factor_L_ball0_x_slide0 * ball2_px_y_ball0_x;
    const real ball2_G_px_hooke0_angle1 = work[575];
    const real ball2_px_y_hooke0_angle1_part = ball2_G_px_hooke0_angle1
        - ball2_G_px_ball0_z * M_factor_L_ball0_z_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle1 * ball2_px_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle1 * ball2_px_y_ball0_x
        - M_factor_L_slide0_hooke0_angle1 * ball2_px_y_slide0;
    const real ball2_G_px_hooke0_angle2 = work[576];
    const real ball2_px_y_hooke0_angle2 = ball2_G_px_hooke0_angle2
        - ball2_G_px_ball0_z * M_factor_L_ball0_z_hooke0_angle2
        - M_factor_L_ball0_y_hooke0_angle2 * ball2_px_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle2 * ball2_px_y_ball0_x
        + M_minus_factor_L_slide0_hooke0_angle2 * ball2_px_y_slide0;
    const real ball2_px_response_hooke0_angle1 = M_factor_D_inverse_hooke0_angle1 *
        (ball2_px_y_hooke0_angle1_part
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball2_px_y_hooke0_angle2);
    work[814] = ball2_px_response_hooke0_angle1;
    const real ball2_minus_G_px_hooke2_angle1 = work[581];
    const real ball2_px_minus_response_hooke2_angle1 = ball2_minus_G_px_hooke2_angle1 *
        M_factor_D_inverse_hooke2_angle1;
    work[815] = ball2_px_minus_response_hooke2_angle1;
    const real ball2_G_px_hooke2_angle2 = work[582];
    const real ball2_px_response_hooke2_angle2 = ball2_G_px_hooke2_angle2 *
        M_factor_D_inverse_hooke2_angle2;
    work[816] = ball2_px_response_hooke2_angle2;
    const real ball2_minus_G_px_slide2 = work[583];
    const real ball2_px_minus_response_slide2 = ball2_minus_G_px_slide2 * M_factor_D_inverse_slide2;
    work[817] = ball2_px_minus_response_slide2;
    const real ball2_px_response_hooke0_angle2 = M_factor_D_inverse_hooke0_angle2 *
        ball2_px_y_hooke0_angle2
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball2_px_response_hooke0_angle1;
    work[818] = ball2_px_response_hooke0_angle2;
    const real ball2_px_response_slide0 = M_factor_D_inverse_slide0 * ball2_px_y_slide0
        - M_factor_L_slide0_hooke0_angle1 * ball2_px_response_hooke0_angle1
        + M_minus_factor_L_slide0_hooke0_angle2 * ball2_px_response_hooke0_angle2;
    work[819] = ball2_px_response_slide0;
    const real ball2_px_response_ball0_x = M_factor_D_inverse_ball0_x * ball2_px_y_ball0_x
        - M_factor_L_ball0_x_hooke0_angle1 * ball2_px_response_hooke0_angle1
        - M_factor_L_ball0_x_hooke0_angle2 * ball2_px_response_hooke0_angle2
        - M_factor_L_ball0_x_slide0 * ball2_px_response_slide0;
    work[820] = ball2_px_response_ball0_x;
    const real ball2_px_response_ball0_y_part = M_factor_D_inverse_ball0_y * ball2_px_y_ball0_y
        - M_factor_L_ball0_y_hooke0_angle1 * ball2_px_response_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle2 * ball2_px_response_hooke0_angle2
        - M_factor_L_ball0_y_slide0 * ball2_px_response_slide0;
    const real ball2_px_response_ball0_y = ball2_px_response_ball0_y_part
        + M_minus_factor_L_ball0_y_ball0_x * ball2_px_response_ball0_x;
    work[821] = ball2_px_response_ball0_y;
    const real ball2_px_response_ball0_z_part = ball2_G_px_ball0_z * M_factor_D_inverse_ball0_z
        - M_factor_L_ball0_z_hooke0_angle1 * ball2_px_response_hooke0_angle1
        - M_factor_L_ball0_z_hooke0_angle2 * ball2_px_response_hooke0_angle2
        - M_factor_L_ball0_z_slide0 * ball2_px_response_slide0;
    const real ball2_px_response_ball0_z = ball2_px_response_ball0_z_part
        - M_factor_L_ball0_z_ball0_x * ball2_px_response_ball0_x
        - M_factor_L_ball0_z_ball0_y * ball2_px_response_ball0_y;
    work[822] = ball2_px_response_ball0_z;
    const real ball2_G_py_ball0_y = work[588];
    const real ball2_G_py_ball0_z = work[589];
    const real ball2_py_y_ball0_y = ball2_G_py_ball0_y
        - ball2_G_py_ball0_z * M_factor_L_ball0_z_ball0_y;
    const real ball2_G_py_ball0_x = work[587];
    const real ball2_py_y_ball0_x = ball2_G_py_ball0_x
        - ball2_G_py_ball0_z * M_factor_L_ball0_z_ball0_x
        + M_minus_factor_L_ball0_y_ball0_x * ball2_py_y_ball0_y;
    const real ball2_G_py_slide0 = work[586];
    const real ball2_py_y_slide0 = ball2_G_py_slide0
        - ball2_G_py_ball0_z * M_factor_L_ball0_z_slide0
        - M_factor_L_ball0_y_slide0 * ball2_py_y_ball0_y
        - M_factor_L_ball0_x_slide0 * ball2_py_y_ball0_x;
    const real ball2_G_py_hooke0_angle1 = work[584];
    const real ball2_py_y_hooke0_angle1_part = ball2_G_py_hooke0_angle1
        - ball2_G_py_ball0_z * M_factor_L_ball0_z_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle1 * ball2_py_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle1 * ball2_py_y_ball0_x
        - M_factor_L_slide0_hooke0_angle1 * ball2_py_y_slide0;
    const real ball2_G_py_hooke0_angle2 = work[585];
    const real ball2_py_y_hooke0_angle2 = ball2_G_py_hooke0_angle2
        - ball2_G_py_ball0_z * M_factor_L_ball0_z_hooke0_angle2
        - M_factor_L_ball0_y_hooke0_angle2 * ball2_py_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle2 * ball2_py_y_ball0_x
        + M_minus_factor_L_slide0_hooke0_angle2 * ball2_py_y_slide0;
    const real ball2_py_response_hooke0_angle1 = M_factor_D_inverse_hooke0_angle1 *
        (ball2_py_y_hooke0_angle1_part
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball2_py_y_hooke0_angle2);
    work[823] = ball2_py_response_hooke0_angle1;
    const real ball2_minus_G_py_hooke2_angle1 = work[590];
    const real ball2_py_minus_response_hooke2_angle1 = ball2_minus_G_py_hooke2_angle1 *
        M_factor_D_inverse_hooke2_angle1;
    work[824] = ball2_py_minus_response_hooke2_angle1;
    const real ball2_G_py_hooke2_angle2 = work[591];
    const real ball2_py_response_hooke2_angle2 = ball2_G_py_hooke2_angle2 *
        M_factor_D_inverse_hooke2_angle2;
    work[825] = ball2_py_response_hooke2_angle2;
    const real ball2_minus_G_py_slide2 = work[592];
    const real ball2_py_minus_response_slide2 = ball2_minus_G_py_slide2 * M_factor_D_inverse_slide2;
    work[826] = ball2_py_minus_response_slide2;
    const real ball2_py_response_hooke0_angle2 = M_factor_D_inverse_hooke0_angle2 *
        ball2_py_y_hooke0_angle2
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball2_py_response_hooke0_angle1;
    work[827] = ball2_py_response_hooke0_angle2;
    const real ball2_py_response_slide0 = M_factor_D_inverse_slide0 * ball2_py_y_slide0
        - M_factor_L_slide0_hooke0_angle1 * ball2_py_response_hooke0_angle1
        + M_minus_factor_L_slide0_hooke0_angle2 * ball2_py_response_hooke0_angle2;
    work[828] = ball2_py_response_slide0;
    const real ball2_py_response_ball0_x = M_factor_D_inverse_ball0_x * ball2_py_y_ball0_x
        - M_factor_L_ball0_x_hooke0_angle1 * ball2_py_response_hooke0_angle1
        - M_factor_L_ball0_x_hooke0_angle2 * ball2_py_response_hooke0_angle2
        - M_factor_L_ball0_x_slide0 * ball2_py_response_slide0;
    work[829] = ball2_py_response_ball0_x;
    const real ball2_py_response_ball0_y_part = M_factor_D_inverse_ball0_y * ball2_py_y_ball0_y
        - M_factor_L_ball0_y_hooke0_angle1 * ball2_py_response_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle2 * ball2_py_response_hooke0_angle2
        - M_factor_L_ball0_y_slide0 * ball2_py_response_slide0;
    const real ball2_py_response_ball0_y = ball2_py_response_ball0_y_part
        + M_minus_factor_L_ball0_y_ball0_x * ball2_py_response_ball0_x;
    work[830] = ball2_py_response_ball0_y;
    const real ball2_py_response_ball0_z_part = ball2_G_py_ball0_z * M_factor_D_inverse_ball0_z
        - M_factor_L_ball0_z_hooke0_angle1 * ball2_py_response_hooke0_angle1
        - M_factor_L_ball0_z_hooke0_angle2 * ball2_py_response_hooke0_angle2
        - M_factor_L_ball0_z_slide0 * ball2_py_response_slide0;
    const real ball2_py_response_ball0_z = ball2_py_response_ball0_z_part
        - M_factor_L_ball0_z_ball0_x * ball2_py_response_ball0_x
        - M_factor_L_ball0_z_ball0_y * ball2_py_response_ball0_y;
    work[831] = ball2_py_response_ball0_z;
    const real ball2_G_pz_ball0_y = work[597];
    const real ball2_G_pz_ball0_z = work[598];
    const real ball2_pz_y_ball0_y = ball2_G_pz_ball0_y
        - ball2_G_pz_ball0_z * M_factor_L_ball0_z_ball0_y;
    const real ball2_G_pz_ball0_x = work[596];
    const real ball2_pz_y_ball0_x = ball2_G_pz_ball0_x
        - ball2_G_pz_ball0_z * M_factor_L_ball0_z_ball0_x
        + M_minus_factor_L_ball0_y_ball0_x * ball2_pz_y_ball0_y;
    const real ball2_G_pz_slide0 = work[595];
    const real ball2_pz_y_slide0 = ball2_G_pz_slide0
        - ball2_G_pz_ball0_z * M_factor_L_ball0_z_slide0
        - M_factor_L_ball0_y_slide0 * ball2_pz_y_ball0_y
        - M_factor_L_ball0_x_slide0 * ball2_pz_y_ball0_x;
    const real ball2_G_pz_hooke0_angle1 = work[593];
    const real ball2_pz_y_hooke0_angle1_part = ball2_G_pz_hooke0_angle1
        - ball2_G_pz_ball0_z * M_factor_L_ball0_z_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle1 * ball2_pz_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle1 * ball2_pz_y_ball0_x
        - M_factor_L_slide0_hooke0_angle1 * ball2_pz_y_slide0;
    const real ball2_G_pz_hooke0_angle2 = work[594];
    const real ball2_pz_y_hooke0_angle2 = ball2_G_pz_hooke0_angle2
        - ball2_G_pz_ball0_z * M_factor_L_ball0_z_hooke0_angle2
        - M_factor_L_ball0_y_hooke0_angle2 * ball2_pz_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle2 * ball2_pz_y_ball0_x
        + M_minus_factor_L_slide0_hooke0_angle2 * ball2_pz_y_slide0;
    const real ball2_pz_response_hooke0_angle1 = M_factor_D_inverse_hooke0_angle1 *
        (ball2_pz_y_hooke0_angle1_part
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball2_pz_y_hooke0_angle2);
    work[832] = ball2_pz_response_hooke0_angle1;
    const real ball2_minus_G_pz_hooke2_angle1 = work[599];
    const real ball2_pz_minus_response_hooke2_angle1 = ball2_minus_G_pz_hooke2_angle1 *
        M_factor_D_inverse_hooke2_angle1;
    work[833] = ball2_pz_minus_response_hooke2_angle1;
    const real ball2_G_pz_hooke2_angle2 = work[600];
    const real ball2_pz_response_hooke2_angle2 = ball2_G_pz_hooke2_angle2 *
        M_factor_D_inverse_hooke2_angle2;
    work[834] = ball2_pz_response_hooke2_angle2;
    const real ball2_minus_G_pz_slide2 = work[601];
    const real ball2_pz_minus_response_slide2 = ball2_minus_G_pz_slide2 * M_factor_D_inverse_slide2;
    work[835] = ball2_pz_minus_response_slide2;
    const real ball2_pz_response_hooke0_angle2 = M_factor_D_inverse_hooke0_angle2 *
        ball2_pz_y_hooke0_angle2
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball2_pz_response_hooke0_angle1;
    work[836] = ball2_pz_response_hooke0_angle2;
    const real ball2_pz_response_slide0 = M_factor_D_inverse_slide0 * ball2_pz_y_slide0
        - M_factor_L_slide0_hooke0_angle1 * ball2_pz_response_hooke0_angle1
        + M_minus_factor_L_slide0_hooke0_angle2 * ball2_pz_response_hooke0_angle2;
    work[837] = ball2_pz_response_slide0;
    const real ball2_pz_response_ball0_x = M_factor_D_inverse_ball0_x * ball2_pz_y_ball0_x
        - M_factor_L_ball0_x_hooke0_angle1 * ball2_pz_response_hooke0_angle1
        - M_factor_L_ball0_x_hooke0_angle2 * ball2_pz_response_hooke0_angle2
        - M_factor_L_ball0_x_slide0 * ball2_pz_response_slide0;
    work[838] = ball2_pz_response_ball0_x;
    const real ball2_pz_response_ball0_y_part = M_factor_D_inverse_ball0_y * ball2_pz_y_ball0_y
        - M_factor_L_ball0_y_hooke0_angle1 * ball2_pz_response_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle2 * ball2_pz_response_hooke0_angle2
        - M_factor_L_ball0_y_slide0 * ball2_pz_response_slide0;
    const real ball2_pz_response_ball0_y = ball2_pz_response_ball0_y_part
        + M_minus_factor_L_ball0_y_ball0_x * ball2_pz_response_ball0_x;
    work[839] = ball2_pz_response_ball0_y;
    const real ball2_pz_response_ball0_z_part = ball2_G_pz_ball0_z * M_factor_D_inverse_ball0_z
        - M_factor_L_ball0_z_hooke0_angle1 * ball2_pz_response_hooke0_angle1
        - M_factor_L_ball0_z_hooke0_angle2 * ball2_pz_response_hooke0_angle2
        - M_factor_L_ball0_z_slide0 * ball2_pz_response_slide0;
    const real ball2_pz_response_ball0_z = ball2_pz_response_ball0_z_part
        - M_factor_L_ball0_z_ball0_x * ball2_pz_response_ball0_x
        - M_factor_L_ball0_z_ball0_y * ball2_pz_response_ball0_y;
    work[840] = ball2_pz_response_ball0_z;
    const real ball3_G_px_ball0_y = work[635];
    const real ball3_G_px_ball0_z = work[636];
    const real ball3_px_y_ball0_y = ball3_G_px_ball0_y
        - ball3_G_px_ball0_z * M_factor_L_ball0_z_ball0_y;
    const real ball3_G_px_ball0_x = work[634];
    const real ball3_px_y_ball0_x = ball3_G_px_ball0_x
        - ball3_G_px_ball0_z * M_factor_L_ball0_z_ball0_x
        + M_minus_factor_L_ball0_y_ball0_x * ball3_px_y_ball0_y;
    const real ball3_G_px_slide0 = work[633];
    const real ball3_px_y_slide0 = ball3_G_px_slide0
        - ball3_G_px_ball0_z * M_factor_L_ball0_z_slide0
        - M_factor_L_ball0_y_slide0 * ball3_px_y_ball0_y
        - M_factor_L_ball0_x_slide0 * ball3_px_y_ball0_x;
    const real ball3_G_px_hooke0_angle1 = work[631];
    const real ball3_px_y_hooke0_angle1_part = ball3_G_px_hooke0_angle1
        - ball3_G_px_ball0_z * M_factor_L_ball0_z_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle1 * ball3_px_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle1 * ball3_px_y_ball0_x
        - M_factor_L_slide0_hooke0_angle1 * ball3_px_y_slide0;
    const real ball3_G_px_hooke0_angle2 = work[632];
    const real ball3_px_y_hooke0_angle2 = ball3_G_px_hooke0_angle2
        - ball3_G_px_ball0_z * M_factor_L_ball0_z_hooke0_angle2
        - M_factor_L_ball0_y_hooke0_angle2 * ball3_px_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle2 * ball3_px_y_ball0_x
        + M_minus_factor_L_slide0_hooke0_angle2 * ball3_px_y_slide0;
    const real ball3_px_response_hooke0_angle1 = M_factor_D_inverse_hooke0_angle1 *
        (ball3_px_y_hooke0_angle1_part
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball3_px_y_hooke0_angle2);
    work[841] = ball3_px_response_hooke0_angle1;
    const real ball3_minus_G_px_hooke3_angle1 = work[637];
    const real ball3_px_minus_response_hooke3_angle1 = ball3_minus_G_px_hooke3_angle1 *
        M_factor_D_inverse_hooke3_angle1;
    work[842] = ball3_px_minus_response_hooke3_angle1;
    const real ball3_G_px_hooke3_angle2 = work[638];
    const real ball3_px_response_hooke3_angle2 = ball3_G_px_hooke3_angle2 *
        M_factor_D_inverse_hooke3_angle2;
    work[843] = ball3_px_response_hooke3_angle2;
    const real ball3_minus_G_px_slide3 = work[639];
    const real ball3_px_minus_response_slide3 = ball3_minus_G_px_slide3 * M_factor_D_inverse_slide3;
    work[844] = ball3_px_minus_response_slide3;
    const real ball3_px_response_hooke0_angle2 = M_factor_D_inverse_hooke0_angle2 *
        ball3_px_y_hooke0_angle2
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball3_px_response_hooke0_angle1;
    work[845] = ball3_px_response_hooke0_angle2;
    const real ball3_px_response_slide0 = M_factor_D_inverse_slide0 * ball3_px_y_slide0
        - M_factor_L_slide0_hooke0_angle1 * ball3_px_response_hooke0_angle1
        + M_minus_factor_L_slide0_hooke0_angle2 * ball3_px_response_hooke0_angle2;
    work[846] = ball3_px_response_slide0;
    const real ball3_px_response_ball0_x = M_factor_D_inverse_ball0_x * ball3_px_y_ball0_x
        - M_factor_L_ball0_x_hooke0_angle1 * ball3_px_response_hooke0_angle1
        - M_factor_L_ball0_x_hooke0_angle2 * ball3_px_response_hooke0_angle2
        - M_factor_L_ball0_x_slide0 * ball3_px_response_slide0;
    work[847] = ball3_px_response_ball0_x;
    const real ball3_px_response_ball0_y_part = M_factor_D_inverse_ball0_y * ball3_px_y_ball0_y
        - M_factor_L_ball0_y_hooke0_angle1 * ball3_px_response_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle2 * ball3_px_response_hooke0_angle2
        - M_factor_L_ball0_y_slide0 * ball3_px_response_slide0;
    const real ball3_px_response_ball0_y = ball3_px_response_ball0_y_part
        + M_minus_factor_L_ball0_y_ball0_x * ball3_px_response_ball0_x;
    work[848] = ball3_px_response_ball0_y;
    const real ball3_px_response_ball0_z_part = ball3_G_px_ball0_z * M_factor_D_inverse_ball0_z
        - M_factor_L_ball0_z_hooke0_angle1 * ball3_px_response_hooke0_angle1
        - M_factor_L_ball0_z_hooke0_angle2 * ball3_px_response_hooke0_angle2
        - M_factor_L_ball0_z_slide0 * ball3_px_response_slide0;
    const real ball3_px_response_ball0_z = ball3_px_response_ball0_z_part
        - M_factor_L_ball0_z_ball0_x * ball3_px_response_ball0_x
        - M_factor_L_ball0_z_ball0_y * ball3_px_response_ball0_y;
    work[849] = ball3_px_response_ball0_z;
    const real ball3_G_py_ball0_y = work[644];
    const real ball3_G_py_ball0_z = work[645];
    const real ball3_py_y_ball0_y = ball3_G_py_ball0_y
        - ball3_G_py_ball0_z * M_factor_L_ball0_z_ball0_y;
    const real ball3_G_py_ball0_x = work[643];
    const real ball3_py_y_ball0_x = ball3_G_py_ball0_x
        - ball3_G_py_ball0_z * M_factor_L_ball0_z_ball0_x
        + M_minus_factor_L_ball0_y_ball0_x * ball3_py_y_ball0_y;
    const real ball3_G_py_slide0 = work[642];
    const real ball3_py_y_slide0 = ball3_G_py_slide0
        - ball3_G_py_ball0_z * M_factor_L_ball0_z_slide0
        - M_factor_L_ball0_y_slide0 * ball3_py_y_ball0_y
        - M_factor_L_ball0_x_slide0 * ball3_py_y_ball0_x;
    const real ball3_G_py_hooke0_angle1 = work[640];
    const real ball3_py_y_hooke0_angle1_part = ball3_G_py_hooke0_angle1
        - ball3_G_py_ball0_z * M_factor_L_ball0_z_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle1 * ball3_py_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle1 * ball3_py_y_ball0_x
        - M_factor_L_slide0_hooke0_angle1 * ball3_py_y_slide0;
    const real ball3_G_py_hooke0_angle2 = work[641];
    const real ball3_py_y_hooke0_angle2 = ball3_G_py_hooke0_angle2
        - ball3_G_py_ball0_z * M_factor_L_ball0_z_hooke0_angle2
        - M_factor_L_ball0_y_hooke0_angle2 * ball3_py_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle2 * ball3_py_y_ball0_x
        + M_minus_factor_L_slide0_hooke0_angle2 * ball3_py_y_slide0;
    const real ball3_py_response_hooke0_angle1 = M_factor_D_inverse_hooke0_angle1 *
        (ball3_py_y_hooke0_angle1_part
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball3_py_y_hooke0_angle2);
    work[850] = ball3_py_response_hooke0_angle1;
    const real ball3_minus_G_py_hooke3_angle1 = work[646];
    const real ball3_py_minus_response_hooke3_angle1 = ball3_minus_G_py_hooke3_angle1 *
        M_factor_D_inverse_hooke3_angle1;
    work[851] = ball3_py_minus_response_hooke3_angle1;
    const real ball3_G_py_hooke3_angle2 = work[647];
    const real ball3_py_response_hooke3_angle2 = ball3_G_py_hooke3_angle2 *
        M_factor_D_inverse_hooke3_angle2;
    work[852] = ball3_py_response_hooke3_angle2;
    const real ball3_minus_G_py_slide3 = work[648];
    const real ball3_py_minus_response_slide3 = ball3_minus_G_py_slide3 * M_factor_D_inverse_slide3;
    work[853] = ball3_py_minus_response_slide3;
    const real ball3_py_response_hooke0_angle2 = M_factor_D_inverse_hooke0_angle2 *
        ball3_py_y_hooke0_angle2
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball3_py_response_hooke0_angle1;
    work[854] = ball3_py_response_hooke0_angle2;
    const real ball3_py_response_slide0 = M_factor_D_inverse_slide0 * ball3_py_y_slide0
        - M_factor_L_slide0_hooke0_angle1 * ball3_py_response_hooke0_angle1
        + M_minus_factor_L_slide0_hooke0_angle2 * ball3_py_response_hooke0_angle2;
    work[855] = ball3_py_response_slide0;
    const real ball3_py_response_ball0_x = M_factor_D_inverse_ball0_x * ball3_py_y_ball0_x
        - M_factor_L_ball0_x_hooke0_angle1 * ball3_py_response_hooke0_angle1
        - M_factor_L_ball0_x_hooke0_angle2 * ball3_py_response_hooke0_angle2
        - M_factor_L_ball0_x_slide0 * ball3_py_response_slide0;
    work[856] = ball3_py_response_ball0_x;
    const real ball3_py_response_ball0_y_part = M_factor_D_inverse_ball0_y * ball3_py_y_ball0_y
        - M_factor_L_ball0_y_hooke0_angle1 * ball3_py_response_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle2 * ball3_py_response_hooke0_angle2
        - M_factor_L_ball0_y_slide0 * ball3_py_response_slide0;
    const real ball3_py_response_ball0_y = ball3_py_response_ball0_y_part
        + M_minus_factor_L_ball0_y_ball0_x * ball3_py_response_ball0_x;
    work[857] = ball3_py_response_ball0_y;
    const real ball3_py_response_ball0_z_part = ball3_G_py_ball0_z * M_factor_D_inverse_ball0_z
        - M_factor_L_ball0_z_hooke0_angle1 * ball3_py_response_hooke0_angle1
        - M_factor_L_ball0_z_hooke0_angle2 * ball3_py_response_hooke0_angle2
        - M_factor_L_ball0_z_slide0 * ball3_py_response_slide0;
    const real ball3_py_response_ball0_z = ball3_py_response_ball0_z_part
        - M_factor_L_ball0_z_ball0_x * ball3_py_response_ball0_x
        - M_factor_L_ball0_z_ball0_y * ball3_py_response_ball0_y;
    work[858] = ball3_py_response_ball0_z;
    const real ball3_G_pz_ball0_y = work[653];
    const real ball3_G_pz_ball0_z = work[654];
    const real ball3_pz_y_ball0_y = ball3_G_pz_ball0_y
        - ball3_G_pz_ball0_z * M_factor_L_ball0_z_ball0_y;
    work[859] = ball3_pz_y_ball0_y;
    const real ball3_G_pz_ball0_x = work[652];
    const real ball3_pz_y_ball0_x = ball3_G_pz_ball0_x
        - ball3_G_pz_ball0_z * M_factor_L_ball0_z_ball0_x
        + M_minus_factor_L_ball0_y_ball0_x * ball3_pz_y_ball0_y;
    const real ball3_G_pz_slide0 = work[651];
    const real ball3_pz_y_slide0 = ball3_G_pz_slide0
        - ball3_G_pz_ball0_z * M_factor_L_ball0_z_slide0
        - M_factor_L_ball0_y_slide0 * ball3_pz_y_ball0_y
        - M_factor_L_ball0_x_slide0 * ball3_pz_y_ball0_x;
    const real ball3_G_pz_hooke0_angle1 = work[649];
    const real ball3_pz_y_hooke0_angle1_part = ball3_G_pz_hooke0_angle1
        - ball3_G_pz_ball0_z * M_factor_L_ball0_z_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle1 * ball3_pz_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle1 * ball3_pz_y_ball0_x
        - M_factor_L_slide0_hooke0_angle1 * ball3_pz_y_slide0;
    const real ball3_G_pz_hooke0_angle2 = work[650];
    const real ball3_pz_y_hooke0_angle2 = ball3_G_pz_hooke0_angle2
        - ball3_G_pz_ball0_z * M_factor_L_ball0_z_hooke0_angle2
        - M_factor_L_ball0_y_hooke0_angle2 * ball3_pz_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle2 * ball3_pz_y_ball0_x
        + M_minus_factor_L_slide0_hooke0_angle2 * ball3_pz_y_slide0;
    const real ball3_pz_response_hooke0_angle1 = M_factor_D_inverse_hooke0_angle1 *
        (ball3_pz_y_hooke0_angle1_part
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball3_pz_y_hooke0_angle2);
    work[860] = ball3_pz_response_hooke0_angle1;
    const real ball3_minus_G_pz_hooke3_angle1 = work[655];
    const real ball3_pz_minus_response_hooke3_angle1 = ball3_minus_G_pz_hooke3_angle1 *
        M_factor_D_inverse_hooke3_angle1;
    work[861] = ball3_pz_minus_response_hooke3_angle1;
    const real ball3_G_pz_hooke3_angle2 = work[656];
    const real ball3_pz_response_hooke3_angle2 = ball3_G_pz_hooke3_angle2 *
        M_factor_D_inverse_hooke3_angle2;
    work[862] = ball3_pz_response_hooke3_angle2;
    const real ball3_minus_G_pz_slide3 = work[657];
    const real ball3_pz_minus_response_slide3 = ball3_minus_G_pz_slide3 * M_factor_D_inverse_slide3;
    work[863] = ball3_pz_minus_response_slide3;
    const real ball3_pz_response_hooke0_angle2 = M_factor_D_inverse_hooke0_angle2 *
        ball3_pz_y_hooke0_angle2
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball3_pz_response_hooke0_angle1;
    work[864] = ball3_pz_response_hooke0_angle2;
    const real ball3_pz_response_slide0 = M_factor_D_inverse_slide0 * ball3_pz_y_slide0
        - M_factor_L_slide0_hooke0_angle1 * ball3_pz_response_hooke0_angle1
        + M_minus_factor_L_slide0_hooke0_angle2 * ball3_pz_response_hooke0_angle2;
    work[865] = ball3_pz_response_slide0;
    const real ball3_pz_response_ball0_x = M_factor_D_inverse_ball0_x * ball3_pz_y_ball0_x
        - M_factor_L_ball0_x_hooke0_angle1 * ball3_pz_response_hooke0_angle1
        - M_factor_L_ball0_x_hooke0_angle2 * ball3_pz_response_hooke0_angle2
        - M_factor_L_ball0_x_slide0 * ball3_pz_response_slide0;
    work[866] = ball3_pz_response_ball0_x;
    return CARDAN_OK;
}

CARDAN_PART int forward_dynamics_part5(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const wreal *const w = in->w;
    (void)out;
    real (*const circuit_matrix)[15] = (real (*)[15])(work + 0);

    /* constraints: factor, multipliers */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const wreal M_factor_D_inverse_slide5 = w[96];
    const wreal M_factor_D_inverse_slide4 = w[97];
    const wreal M_factor_D_inverse_ball0_z = w[101];
    const wreal M_factor_L_ball0_z_ball0_y = w[102];
    const wreal M_factor_L_ball0_z_ball0_x = w[103];
    const wreal M_factor_D_inverse_ball0_y = w[104];
    const wreal M_minus_factor_L_ball0_y_ball0_x = w[105];
    const wreal M_factor_D_inverse_ball0_x = w[106];
    const real ball3_pz_y_ball0_y = work[859];
    const real M_factor_L_ball0_y_hooke0_angle1 = work[438];
    const real ball3_pz_response_hooke0_angle1 = work[860];
    const real M_factor_L_ball0_y_hooke0_angle2 = work[437];
    const real ball3_pz_response_hooke0_angle2 = work[864];
    const real M_factor_L_ball0_y_slide0 = work[436];
    const real ball3_pz_response_slide0 = work[865];
    const real ball3_pz_response_ball0_y_part = M_factor_D_inverse_ball0_y * ball3_pz_y_ball0_y
        - M_factor_L_ball0_y_hooke0_angle1 * ball3_pz_response_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle2 * ball3_pz_response_hooke0_angle2
        - M_factor_L_ball0_y_slide0 * ball3_pz_response_slide0;
    const real ball3_pz_response_ball0_x = work[866];
    const real ball3_pz_response_ball0_y = ball3_pz_response_ball0_y_part
        + M_minus_factor_L_ball0_y_ball0_x * ball3_pz_response_ball0_x;
    work[392] = ball3_pz_response_ball0_y;
    const real ball3_G_pz_ball0_z = work[654];
    const real M_factor_L_ball0_z_hooke0_angle1 = work[435];
    const real M_factor_L_ball0_z_hooke0_angle2 = work[434];
    const real M_factor_L_ball0_z_slide0 = work[427];
    const real ball3_pz_response_ball0_z_part = ball3_G_pz_ball0_z * M_factor_D_inverse_ball0_z
        - M_factor_L_ball0_z_hooke0_angle1 * ball3_pz_response_hooke0_angle1
        - M_factor_L_ball0_z_hooke0_angle2 * ball3_pz_response_hooke0_angle2
        - M_factor_L_ball0_z_slide0 * ball3_pz_response_slide0;
    const real ball3_pz_response_ball0_z = ball3_pz_response_ball0_z_part
        - M_factor_L_ball0_z_ball0_x * ball3_pz_response_ball0_x
        - M_factor_L_ball0_z_ball0_y * ball3_pz_response_ball0_y;
    work[393] = ball3_pz_response_ball0_z;
    const real ball4_G_px_ball0_y = work[562];
    const real ball4_G_px_ball0_z = work[563];
    const real ball4_px_y_ball0_y = ball4_G_px_ball0_y
        - ball4_G_px_ball0_z * M_factor_L_ball0_z_ball0_y;
    const real ball4_G_px_ball0_x = work[561];
    const real ball4_px_y_ball0_x = ball4_G_px_ball0_x
        - ball4_G_px_ball0_z * M_factor_L_ball0_z_ball0_x
        + M_minus_factor_L_ball0_y_ball0_x * ball4_px_y_ball0_y;
    const real ball4_G_px_slide0 = work[560];
    const real M_factor_L_ball0_x_slide0 = work[439];
    const real ball4_px_y_slide0 = ball4_G_px_slide0
        - ball4_G_px_ball0_z * M_factor_L_ball0_z_slide0
        - M_factor_L_ball0_y_slide0 * ball4_px_y_ball0_y
        - M_factor_L_ball0_x_slide0 * ball4_px_y_ball0_x;
    const real ball4_G_px_hooke0_angle1 = work[555];
    const real M_factor_L_ball0_x_hooke0_angle1 = work[441];
    const real M_factor_L_slide0_hooke0_angle1 = work[444];
    const real ball4_px_y_hooke0_angle1_part = ball4_G_px_hooke0_angle1
        - ball4_G_px_ball0_z * M_factor_L_ball0_z_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle1 * ball4_px_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle1 * ball4_px_y_ball0_x
        - M_factor_L_slide0_hooke0_angle1 * ball4_px_y_slide0;
    const real ball4_G_px_hooke0_angle2 = work[558];
    const real M_factor_L_ball0_x_hooke0_angle2 = work[440];
    const real M_minus_factor_L_slide0_hooke0_angle2 = work[443];
    const real ball4_px_y_hooke0_angle2 = ball4_G_px_hooke0_angle2
        - ball4_G_px_ball0_z * M_factor_L_ball0_z_hooke0_angle2
        - M_factor_L_ball0_y_hooke0_angle2 * ball4_px_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle2 * ball4_px_y_ball0_x
        + M_minus_factor_L_slide0_hooke0_angle2 * ball4_px_y_slide0;
    const real M_factor_D_inverse_hooke0_angle1 = work[447];
    const real M_factor_L_hooke0_angle2_hooke0_angle1 = work[446];
    const real ball4_px_response_hooke0_angle1 = M_factor_D_inverse_hooke0_angle1 *
        (ball4_px_y_hooke0_angle1_part
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball4_px_y_hooke0_angle2);
    work[394] = ball4_px_response_hooke0_angle1;
    const real ball4_minus_G_px_hooke4_angle1 = work[564];
    const real M_factor_D_inverse_hooke4_angle1 = work[426];
    const real ball4_px_minus_response_hooke4_angle1 = ball4_minus_G_px_hooke4_angle1 *
        M_factor_D_inverse_hooke4_angle1;
    work[395] = ball4_px_minus_response_hooke4_angle1;
    const real ball4_G_px_hooke4_angle2 = work[565];
    const real M_factor_D_inverse_hooke4_angle2 = work[425];
    const real ball4_px_response_hooke4_angle2 = ball4_G_px_hooke4_angle2 *
        M_factor_D_inverse_hooke4_angle2;
    work[396] = ball4_px_response_hooke4_angle2;
    const real ball4_minus_G_px_slide4 = work[568];
    const real ball4_px_minus_response_slide4 = ball4_minus_G_px_slide4 * M_factor_D_inverse_slide4;
    work[397] = ball4_px_minus_response_slide4;
    const real M_factor_D_inverse_hooke0_angle2 = work[445];
    const real ball4_px_response_hooke0_angle2 = M_factor_D_inverse_hooke0_angle2 *
        ball4_px_y_hooke0_angle2
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball4_px_response_hooke0_angle1;
    work[400] = ball4_px_response_hooke0_angle2;
    const real M_factor_D_inverse_slide0 = work[442];
    const real ball4_px_response_slide0 = M_factor_D_inverse_slide0 * ball4_px_y_slide0
        - M_factor_L_slide0_hooke0_angle1 * ball4_px_response_hooke0_angle1
        + M_minus_factor_L_slide0_hooke0_angle2 * ball4_px_response_hooke0_angle2;
    work[401] = ball4_px_response_slide0;
    const real ball4_px_response_ball0_x = M_factor_D_inverse_ball0_x * ball4_px_y_ball0_x
        - M_factor_L_ball0_x_hooke0_angle1 * ball4_px_response_hooke0_angle1
        - M_factor_L_ball0_x_hooke0_angle2 * ball4_px_response_hooke0_angle2
        - M_factor_L_ball0_x_slide0 * ball4_px_response_slide0;
    work[404] = ball4_px_response_ball0_x;
    const real ball4_px_response_ball0_y_part = M_factor_D_inverse_ball0_y * ball4_px_y_ball0_y
        - M_factor_L_ball0_y_hooke0_angle1 * ball4_px_response_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle2 * ball4_px_response_hooke0_angle2
        - M_factor_L_ball0_y_slide0 * ball4_px_response_slide0;
    const real ball4_px_response_ball0_y = ball4_px_response_ball0_y_part
        + M_minus_factor_L_ball0_y_ball0_x * ball4_px_response_ball0_x;
    work[405] = ball4_px_response_ball0_y;
    const real ball4_px_response_ball0_z_part = ball4_G_px_ball0_z * M_factor_D_inverse_ball0_z
        - M_factor_L_ball0_z_hooke0_angle1 * ball4_px_response_hooke0_angle1
        - M_factor_L_ball0_z_hooke0_angle2 * ball4_px_response_hooke0_angle2
        - M_factor_L_ball0_z_slide0 * ball4_px_response_slide0;
    const real ball4_px_response_ball0_z = ball4_px_response_ball0_z_part
        - M_factor_L_ball0_z_ball0_x * ball4_px_response_ball0_x
        - M_factor_L_ball0_z_ball0_y * ball4_px_response_ball0_y;
    work[408] = ball4_px_response_ball0_z;
    const real ball4_G_py_ball0_y = work[696];
    const real ball4_G_py_ball0_z = work[697];
    const real ball4_py_y_ball0_y = ball4_G_py_ball0_y
        - ball4_G_py_ball0_z * M_factor_L_ball0_z_ball0_y;
    const real ball4_G_py_ball0_x = work[695];
    const real ball4_py_y_ball0_x = ball4_G_py_ball0_x
        - ball4_G_py_ball0_z * M_factor_L_ball0_z_ball0_x
        + M_minus_factor_L_ball0_y_ball0_x * ball4_py_y_ball0_y;
    const real ball4_G_py_slide0 = work[694];
    const real ball4_py_y_slide0 = ball4_G_py_slide0
        - ball4_G_py_ball0_z * M_factor_L_ball0_z_slide0
        - M_factor_L_ball0_y_slide0 * ball4_py_y_ball0_y
        - M_factor_L_ball0_x_slide0 * ball4_py_y_ball0_x;
    const real ball4_G_py_hooke0_angle1 = work[569];
    const real ball4_py_y_hooke0_angle1_part = ball4_G_py_hooke0_angle1
        - ball4_G_py_ball0_z * M_factor_L_ball0_z_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle1 * ball4_py_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle1 * ball4_py_y_ball0_x
        - M_factor_L_slide0_hooke0_angle1 * ball4_py_y_slide0;
    const real ball4_G_py_hooke0_angle2 = work[693];
    const real ball4_py_y_hooke0_angle2 = ball4_G_py_hooke0_angle2
        - ball4_G_py_ball0_z * M_factor_L_ball0_z_hooke0_angle2
        - M_factor_L_ball0_y_hooke0_angle2 * ball4_py_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle2 * ball4_py_y_ball0_x
        + M_minus_factor_L_slide0_hooke0_angle2 * ball4_py_y_slide0;
    const real ball4_py_response_hooke0_angle1 = M_factor_D_inverse_hooke0_angle1 *
        (ball4_py_y_hooke0_angle1_part
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball4_py_y_hooke0_angle2);
    work[409] = ball4_py_response_hooke0_angle1;
    const real ball4_minus_G_py_hooke4_angle1 = work[698];
    const real ball4_py_minus_response_hooke4_angle1 = ball4_minus_G_py_hooke4_angle1 *
        M_factor_D_inverse_hooke4_angle1;
    work[412] = ball4_py_minus_response_hooke4_angle1;
    const real ball4_G_py_hooke4_angle2 = work[699];
    const real ball4_py_response_hooke4_angle2 = ball4_G_py_hooke4_angle2 *
        M_factor_D_inverse_hooke4_angle2;
    work[413] = ball4_py_response_hooke4_angle2;
    const real ball4_minus_G_py_slide4 = work[700];
    const real ball4_py_minus_response_slide4 = ball4_minus_G_py_slide4 * M_factor_D_inverse_slide4;
    work[415] = ball4_py_minus_response_slide4;
    const real ball4_py_response_hooke0_angle2 = M_factor_D_inverse_hooke0_angle2 *
        ball4_py_y_hooke0_angle2
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball4_py_response_hooke0_angle1;
    work[416] = ball4_py_response_hooke0_angle2;
    const real ball4_py_response_slide0 = M_factor_D_inverse_slide0 * ball4_py_y_slide0
        - M_factor_L_slide0_hooke0_angle1 * ball4_py_response_hooke0_angle1
        + M_minus_factor_L_slide0_hooke0_angle2 * ball4_py_response_hooke0_angle2;
    work[417] = ball4_py_response_slide0;
    const real ball4_py_response_ball0_x = M_factor_D_inverse_ball0_x * ball4_py_y_ball0_x
        - M_factor_L_ball0_x_hooke0_angle1 * ball4_py_response_hooke0_angle1
        - M_factor_L_ball0_x_hooke0_angle2 * ball4_py_response_hooke0_angle2
        - M_factor_L_ball0_x_slide0 * ball4_py_response_slide0;
    work[418] = ball4_py_response_ball0_x;
    const real ball4_py_response_ball0_y_part = M_factor_D_inverse_ball0_y * ball4_py_y_ball0_y
        - M_factor_L_ball0_y_hooke0_angle1 * ball4_py_response_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle2 * ball4_py_response_hooke0_angle2
        - M_factor_L_ball0_y_slide0 * ball4_py_response_slide0;
    const real ball4_py_response_ball0_y = ball4_py_response_ball0_y_part
        + M_minus_factor_L_ball0_y_ball0_x * ball4_py_response_ball0_x;
    work[419] = ball4_py_response_ball0_y;
    const real ball4_py_response_ball0_z_part = ball4_G_py_ball0_z * M_factor_D_inverse_ball0_z
        - M_factor_L_ball0_z_hooke0_angle1 * ball4_py_response_hooke0_angle1
        - M_factor_L_ball0_z_hooke0_angle2 * ball4_py_response_hooke0_angle2
        - M_factor_L_ball0_z_slide0 * ball4_py_response_slide0;
    const real ball4_py_response_ball0_z = ball4_py_response_ball0_z_part
        - M_factor_L_ball0_z_ball0_x * ball4_py_response_ball0_x
        - M_factor_L_ball0_z_ball0_y * ball4_py_response_ball0_y;
    work[420] = ball4_py_response_ball0_z;
    const real ball4_G_pz_ball0_y = work[705];
    const real ball4_G_pz_ball0_z = work[706];
    const real ball4_pz_y_ball0_y = ball4_G_pz_ball0_y
        - ball4_G_pz_ball0_z * M_factor_L_ball0_z_ball0_y;
    const real ball4_G_pz_ball0_x = work[704];
    const real ball4_pz_y_ball0_x = ball4_G_pz_ball0_x
        - ball4_G_pz_ball0_z * M_factor_L_ball0_z_ball0_x
        + M_minus_factor_L_ball0_y_ball0_x * ball4_pz_y_ball0_y;
    const real ball4_G_pz_slide0 = work[703];
    const real ball4_pz_y_slide0 = ball4_G_pz_slide0
        - ball4_G_pz_ball0_z * M_factor_L_ball0_z_slide0
        - M_factor_L_ball0_y_slide0 * ball4_pz_y_ball0_y
        - M_factor_L_ball0_x_slide0 * ball4_pz_y_ball0_x;
    const real ball4_G_pz_hooke0_angle1 = work[701];
    const real ball4_pz_y_hooke0_angle1_part = ball4_G_pz_hooke0_angle1
        - ball4_G_pz_ball0_z * M_factor_L_ball0_z_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle1 * ball4_pz_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle1 * ball4_pz_y_ball0_x
        - M_factor_L_slide0_hooke0_angle1 * ball4_pz_y_slide0;
    const real ball4_G_pz_hooke0_angle2 = work[702];
    const real ball4_pz_y_hooke0_angle2 = ball4_G_pz_hooke0_angle2
        - ball4_G_pz_ball0_z * M_factor_L_ball0_z_hooke0_angle2
        - M_factor_L_ball0_y_hooke0_angle2 * ball4_pz_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle2 * ball4_pz_y_ball0_x
        + M_minus_factor_L_slide0_hooke0_angle2 * ball4_pz_y_slide0;
    const real ball4_pz_response_hooke0_angle1 = M_factor_D_inverse_hooke0_angle1 *
        (ball4_pz_y_hooke0_angle1_part
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball4_pz_y_hooke0_angle2);
    work[421] = ball4_pz_response_hooke0_angle1;
    const real ball4_minus_G_pz_hooke4_angle1 = work[707];
    const real ball4_pz_minus_response_hooke4_angle1 = ball4_minus_G_pz_hooke4_angle1 *
        M_factor_D_inverse_hooke4_angle1;
    work[422] = ball4_pz_minus_response_hooke4_angle1;
    const real ball4_G_pz_hooke4_angle2 = work[708];
    const real ball4_pz_response_hooke4_angle2 = ball4_G_pz_hooke4_angle2 *
        M_factor_D_inverse_hooke4_angle2;
    work[423] = ball4_pz_response_hooke4_angle2;
    const real ball4_minus_G_pz_slide4 = work[709];
    const real ball4_pz_minus_response_slide4 = ball4_minus_G_pz_slide4 * M_factor_D_inverse_slide4;
    work[424] = ball4_pz_minus_response_slide4;
    const real ball4_pz_response_hooke0_angle2 = M_factor_D_inverse_hooke0_angle2 *
        ball4_pz_y_hooke0_angle2
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball4_pz_response_hooke0_angle1;
    work[428] = ball4_pz_response_hooke0_angle2;
    const real ball4_pz_response_slide0 = M_factor_D_inverse_slide0 * ball4_pz_y_slide0
        - M_factor_L_slide0_hooke0_angle1 * ball4_pz_response_hooke0_angle1
        + M_minus_factor_L_slide0_hooke0_angle2 * ball4_pz_response_hooke0_angle2;
    work[429] = ball4_pz_response_slide0;
    const real ball4_pz_response_ball0_x = M_factor_D_inverse_ball0_x * ball4_pz_y_ball0_x
        - M_factor_L_ball0_x_hooke0_angle1 * ball4_pz_response_hooke0_angle1
        - M_factor_L_ball0_x_hooke0_angle2 * ball4_pz_response_hooke0_angle2
        - M_factor_L_ball0_x_slide0 * ball4_pz_response_slide0;
    work[430] = ball4_pz_response_ball0_x;
    const real ball4_pz_response_ball0_y_part = M_factor_D_inverse_ball0_y * ball4_pz_y_ball0_y
        - M_factor_L_ball0_y_hooke0_angle1 * ball4_pz_response_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle2 * ball4_pz_response_hooke0_angle2
        - M_factor_L_ball0_y_slide0 * ball4_pz_response_slide0;
    const real ball4_pz_response_ball0_y = ball4_pz_response_ball0_y_part
        + M_minus_factor_L_ball0_y_ball0_x * ball4_pz_response_ball0_x;
    work[431] = ball4_pz_response_ball0_y;
    const real ball4_pz_response_ball0_z_part = ball4_G_pz_ball0_z * M_factor_D_inverse_ball0_z
        - M_factor_L_ball0_z_hooke0_angle1 * ball4_pz_response_hooke0_angle1
        - M_factor_L_ball0_z_hooke0_angle2 * ball4_pz_response_hooke0_angle2
        - M_factor_L_ball0_z_slide0 * ball4_pz_response_slide0;
    const real ball4_pz_response_ball0_z = ball4_pz_response_ball0_z_part
        - M_factor_L_ball0_z_ball0_x * ball4_pz_response_ball0_x
        - M_factor_L_ball0_z_ball0_y * ball4_pz_response_ball0_y;
    work[432] = ball4_pz_response_ball0_z;
    const real ball5_G_px_ball0_y = work[742];
    const real ball5_G_px_ball0_z = work[743];
    const real ball5_px_y_ball0_y = ball5_G_px_ball0_y
        - ball5_G_px_ball0_z * M_factor_L_ball0_z_ball0_y;
    const real ball5_G_px_ball0_x = work[741];
    const real ball5_px_y_ball0_x = ball5_G_px_ball0_x
        - ball5_G_px_ball0_z * M_factor_L_ball0_z_ball0_x
        + M_minus_factor_L_ball0_y_ball0_x * ball5_px_y_ball0_y;
    const real ball5_G_px_slide0 = work[740];
    const real ball5_px_y_slide0 = ball5_G_px_slide0
        - ball5_G_px_ball0_z * M_factor_L_ball0_z_slide0
        - M_factor_L_ball0_y_slide0 * ball5_px_y_ball0_y
        - M_factor_L_ball0_x_slide0 * ball5_px_y_ball0_x;
    const real ball5_G_px_hooke0_angle1 = work[738];
    const real ball5_px_y_hooke0_angle1_part = ball5_G_px_hooke0_angle1
        - ball5_G_px_ball0_z * M_factor_L_ball0_z_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle1 * ball5_px_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle1 * ball5_px_y_ball0_x
        - M_factor_L_slide0_hooke0_angle1 * ball5_px_y_slide0;
    const real ball5_G_px_hooke0_angle2 = work[739];
    const real ball5_px_y_hooke0_angle2 = ball5_G_px_hooke0_angle2
        - ball5_G_px_ball0_z * M_factor_L_ball0_z_hooke0_angle2
        - M_factor_L_ball0_y_hooke0_angle2 * ball5_px_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle2 * ball5_px_y_ball0_x
        + M_minus_factor_L_slide0_hooke0_angle2 * ball5_px_y_slide0;
    const real ball5_px_response_hooke0_angle1 = M_factor_D_inverse_hooke0_angle1 *
        (ball5_px_y_hooke0_angle1_part
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball5_px_y_hooke0_angle2);
    work[449] = ball5_px_response_hooke0_angle1;
    const real ball5_minus_G_px_hooke5_angle1 = work[744];
    const real M_factor_D_inverse_hooke5_angle1 = work[414];
    const real ball5_px_minus_response_hooke5_angle1 = ball5_minus_G_px_hooke5_angle1 *
        M_factor_D_inverse_hooke5_angle1;
    work[450] = ball5_px_minus_response_hooke5_angle1;
    const real ball5_G_px_hooke5_angle2 = work[745];
    const real M_factor_D_inverse_hooke5_angle2 = work[411];
    const real ball5_px_response_hooke5_angle2 = ball5_G_px_hooke5_angle2 *
        M_factor_D_inverse_hooke5_angle2;
    work[451] = ball5_px_response_hooke5_angle2;
    const real ball5_minus_G_px_slide5 = work[746];
    const real ball5_px_minus_response_slide5 = ball5_minus_G_px_slide5 * M_factor_D_inverse_slide5;
    work[452] = ball5_px_minus_response_slide5;
    const real ball5_px_response_hooke0_angle2 = M_factor_D_inverse_hooke0_angle2 *
        ball5_px_y_hooke0_angle2
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball5_px_response_hooke0_angle1;
    work[453] = ball5_px_response_hooke0_angle2;
    const real ball5_px_response_slide0 = M_factor_D_inverse_slide0 * ball5_px_y_slide0
        - M_factor_L_slide0_hooke0_angle1 * ball5_px_response_hooke0_angle1
        + M_minus_factor_L_slide0_hooke0_angle2 * ball5_px_response_hooke0_angle2;
    work[454] = ball5_px_response_slide0;
    const real ball5_px_response_ball0_x = M_factor_D_inverse_ball0_x * ball5_px_y_ball0_x
        - M_factor_L_ball0_x_hooke0_angle1 * ball5_px_response_hooke0_angle1
        - M_factor_L_ball0_x_hooke0_angle2 * ball5_px_response_hooke0_angle2
        - M_factor_L_ball0_x_slide0 * ball5_px_response_slide0;
    work[455] = ball5_px_response_ball0_x;
    const real ball5_px_response_ball0_y_part = M_factor_D_inverse_ball0_y * ball5_px_y_ball0_y
        - M_factor_L_ball0_y_hooke0_angle1 * ball5_px_response_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle2 * ball5_px_response_hooke0_angle2
        - M_factor_L_ball0_y_slide0 * ball5_px_response_slide0;
    const real ball5_px_response_ball0_y = ball5_px_response_ball0_y_part
        + M_minus_factor_L_ball0_y_ball0_x * ball5_px_response_ball0_x;
    work[456] = ball5_px_response_ball0_y;
    const real ball5_px_response_ball0_z_part = ball5_G_px_ball0_z * M_factor_D_inverse_ball0_z
        - M_factor_L_ball0_z_hooke0_angle1 * ball5_px_response_hooke0_angle1
        - M_factor_L_ball0_z_hooke0_angle2 * ball5_px_response_hooke0_angle2
        - M_factor_L_ball0_z_slide0 * ball5_px_response_slide0;
    const real ball5_px_response_ball0_z = ball5_px_response_ball0_z_part
        - M_factor_L_ball0_z_ball0_x * ball5_px_response_ball0_x
        - M_factor_L_ball0_z_ball0_y * ball5_px_response_ball0_y;
    work[457] = ball5_px_response_ball0_z;
    const real ball5_G_py_ball0_y = work[751];
    const real ball5_G_py_ball0_z = work[752];
    const real ball5_py_y_ball0_y = ball5_G_py_ball0_y
        - ball5_G_py_ball0_z * M_factor_L_ball0_z_ball0_y;
    const real ball5_G_py_ball0_x = work[750];
    const real ball5_py_y_ball0_x = ball5_G_py_ball0_x
        - ball5_G_py_ball0_z * M_factor_L_ball0_z_ball0_x
        + M_minus_factor_L_ball0_y_ball0_x * ball5_py_y_ball0_y;
    const real ball5_G_py_slide0 = work[749];
    const real ball5_py_y_slide0 = ball5_G_py_slide0
        - ball5_G_py_ball0_z * M_factor_L_ball0_z_slide0
        - M_factor_L_ball0_y_slide0 * ball5_py_y_ball0_y
        - M_factor_L_ball0_x_slide0 * ball5_py_y_ball0_x;
    const real ball5_G_py_hooke0_angle1 = work[747];
    const real ball5_py_y_hooke0_angle1_part = ball5_G_py_hooke0_angle1
        - ball5_G_py_ball0_z * M_factor_L_ball0_z_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle1 * ball5_py_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle1 * ball5_py_y_ball0_x
        - M_factor_L_slide0_hooke0_angle1 * ball5_py_y_slide0;
    const real ball5_G_py_hooke0_angle2 = work[748];
    const real ball5_py_y_hooke0_angle2 = ball5_G_py_hooke0_angle2
        - ball5_G_py_ball0_z * M_factor_L_ball0_z_hooke0_angle2
        - M_factor_L_ball0_y_hooke0_angle2 * ball5_py_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle2 * ball5_py_y_ball0_x
        + M_minus_factor_L_slide0_hooke0_angle2 * ball5_py_y_slide0;
    const real ball5_py_response_hooke0_angle1 = M_factor_D_inverse_hooke0_angle1 *
        (ball5_py_y_hooke0_angle1_part
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball5_py_y_hooke0_angle2);
    work[460] = ball5_py_response_hooke0_angle1;
    const real ball5_minus_G_py_hooke5_angle1 = work[753];
    const real ball5_py_minus_response_hooke5_angle1 = ball5_minus_G_py_hooke5_angle1 *
        M_factor_D_inverse_hooke5_angle1;
    work[461] = ball5_py_minus_response_hooke5_angle1;
    const real ball5_G_py_hooke5_angle2 = work[754];
    const real ball5_py_response_hooke5_angle2 = ball5_G_py_hooke5_angle2 *
        M_factor_D_inverse_hooke5_angle2;
    work[462] = ball5_py_response_hooke5_angle2;
    const real ball5_minus_G_py_slide5 = work[755];
    const real ball5_py_minus_response_slide5 = ball5_minus_G_py_slide5 * M_factor_D_inverse_slide5;
    work[465] = ball5_py_minus_response_slide5;
    const real ball5_py_response_hooke0_angle2 = M_factor_D_inverse_hooke0_angle2 *
        ball5_py_y_hooke0_angle2
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball5_py_response_hooke0_angle1;
    work[466] = ball5_py_response_hooke0_angle2;
    const real ball5_py_response_slide0 = M_factor_D_inverse_slide0 * ball5_py_y_slide0
        - M_factor_L_slide0_hooke0_angle1 * ball5_py_response_hooke0_angle1
        + M_minus_factor_L_slide0_hooke0_angle2 * ball5_py_response_hooke0_angle2;
    work[471] = ball5_py_response_slide0;
    const real ball5_py_response_ball0_x = M_factor_D_inverse_ball0_x * ball5_py_y_ball0_x
        - M_factor_L_ball0_x_hooke0_angle1 * ball5_py_response_hooke0_angle1
        - M_factor_L_ball0_x_hooke0_angle2 * ball5_py_response_hooke0_angle2
        - M_factor_L_ball0_x_slide0 * ball5_py_response_slide0;
    work[472] = ball5_py_response_ball0_x;
    const real ball5_py_response_ball0_y_part = M_factor_D_inverse_ball0_y * ball5_py_y_ball0_y
        - M_factor_L_ball0_y_hooke0_angle1 * ball5_py_response_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle2 * ball5_py_response_hooke0_angle2
        - M_factor_L_ball0_y_slide0 * ball5_py_response_slide0;
    const real ball5_py_response_ball0_y = ball5_py_response_ball0_y_part
        + M_minus_factor_L_ball0_y_ball0_x * ball5_py_response_ball0_x;
    work[504] = ball5_py_response_ball0_y;
    const real ball5_py_response_ball0_z_part = ball5_G_py_ball0_z * M_factor_D_inverse_ball0_z
        - M_factor_L_ball0_z_hooke0_angle1 * ball5_py_response_hooke0_angle1
        - M_factor_L_ball0_z_hooke0_angle2 * ball5_py_response_hooke0_angle2
        - M_factor_L_ball0_z_slide0 * ball5_py_response_slide0;
    const real ball5_py_response_ball0_z = ball5_py_response_ball0_z_part
        - M_factor_L_ball0_z_ball0_x * ball5_py_response_ball0_x
        - M_factor_L_ball0_z_ball0_y * ball5_py_response_ball0_y;
    work[505] = ball5_py_response_ball0_z;
    const real ball5_G_pz_ball0_y = work[760];
    const real ball5_G_pz_ball0_z = work[761];
    const real ball5_pz_y_ball0_y = ball5_G_pz_ball0_y
        - ball5_G_pz_ball0_z * M_factor_L_ball0_z_ball0_y;
    const real ball5_G_pz_ball0_x = work[759];
    const real ball5_pz_y_ball0_x = ball5_G_pz_ball0_x
        - ball5_G_pz_ball0_z * M_factor_L_ball0_z_ball0_x
        + M_minus_factor_L_ball0_y_ball0_x * ball5_pz_y_ball0_y;
    const real ball5_G_pz_slide0 = work[758];
    const real ball5_pz_y_slide0 = ball5_G_pz_slide0
        - ball5_G_pz_ball0_z * M_factor_L_ball0_z_slide0
        - M_factor_L_ball0_y_slide0 * ball5_pz_y_ball0_y
        - M_factor_L_ball0_x_slide0 * ball5_pz_y_ball0_x;
    const real ball5_G_pz_hooke0_angle1 = work[756];
    const real ball5_pz_y_hooke0_angle1_part = ball5_G_pz_hooke0_angle1
        - ball5_G_pz_ball0_z * M_factor_L_ball0_z_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle1 * ball5_pz_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle1 * ball5_pz_y_ball0_x
        - M_factor_L_slide0_hooke0_angle1 * ball5_pz_y_slide0;
    const real ball5_G_pz_hooke0_angle2 = work[757];
    const real ball5_pz_y_hooke0_angle2 = ball5_G_pz_hooke0_angle2
        - ball5_G_pz_ball0_z * M_factor_L_ball0_z_hooke0_angle2
        - M_factor_L_ball0_y_hooke0_angle2 * ball5_pz_y_ball0_y
        - M_factor_L_ball0_x_hooke0_angle2 * ball5_pz_y_ball0_x
        + M_minus_factor_L_slide0_hooke0_angle2 * ball5_pz_y_slide0;
    const real ball5_pz_response_hooke0_angle1 = M_factor_D_inverse_hooke0_angle1 *
        (ball5_pz_y_hooke0_angle1_part
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball5_pz_y_hooke0_angle2);
    work[506] = ball5_pz_response_hooke0_angle1;
    const real ball5_minus_G_pz_hooke5_angle1 = work[762];
    const real ball5_pz_minus_response_hooke5_angle1 = ball5_minus_G_pz_hooke5_angle1 *
        M_factor_D_inverse_hooke5_angle1;
    work[507] = ball5_pz_minus_response_hooke5_angle1;
    const real ball5_G_pz_hooke5_angle2 = work[763];
    const real ball5_pz_response_hooke5_angle2 = ball5_G_pz_hooke5_angle2 *
        M_factor_D_inverse_hooke5_angle2;
    work[508] = ball5_pz_response_hooke5_angle2;
    const real ball5_minus_G_pz_slide5 = work[764];
    const real ball5_pz_minus_response_slide5 = ball5_minus_G_pz_slide5 * M_factor_D_inverse_slide5;
    work[513] = ball5_pz_minus_response_slide5;
    const real ball5_pz_response_hooke0_angle2 = M_factor_D_inverse_hooke0_angle2 *
        ball5_pz_y_hooke0_angle2
        - M_factor_L_hooke0_angle2_hooke0_angle1 * ball5_pz_response_hooke0_angle1;
    work[514] = ball5_pz_response_hooke0_angle2;
    const real ball5_pz_response_slide0 = M_factor_D_inverse_slide0 * ball5_pz_y_slide0
        - M_factor_L_slide0_hooke0_angle1 * ball5_pz_response_hooke0_angle1
        + M_minus_factor_L_slide0_hooke0_angle2 * ball5_pz_response_hooke0_angle2;
    work[516] = ball5_pz_response_slide0;
    const real ball5_pz_response_ball0_x = M_factor_D_inverse_ball0_x * ball5_pz_y_ball0_x
        - M_factor_L_ball0_x_hooke0_angle1 * ball5_pz_response_hooke0_angle1
        - M_factor_L_ball0_x_hooke0_angle2 * ball5_pz_response_hooke0_angle2
        - M_factor_L_ball0_x_slide0 * ball5_pz_response_slide0;
    work[517] = ball5_pz_response_ball0_x;
    const real ball5_pz_response_ball0_y_part = M_factor_D_inverse_ball0_y * ball5_pz_y_ball0_y
        - M_factor_L_ball0_y_hooke0_angle1 * ball5_pz_response_hooke0_angle1
        - M_factor_L_ball0_y_hooke0_angle2 * ball5_pz_response_hooke0_angle2
        - M_factor_L_ball0_y_slide0 * ball5_pz_response_slide0;
    const real ball5_pz_response_ball0_y = ball5_pz_response_ball0_y_part
        + M_minus_factor_L_ball0_y_ball0_x * ball5_pz_response_ball0_x;
    work[525] = ball5_pz_response_ball0_y;
    const real ball5_pz_response_ball0_z_part = ball5_G_pz_ball0_z * M_factor_D_inverse_ball0_z
        - M_factor_L_ball0_z_hooke0_angle1 * ball5_pz_response_hooke0_angle1
        - M_factor_L_ball0_z_hooke0_angle2 * ball5_pz_response_hooke0_angle2
        - M_factor_L_ball0_z_slide0 * ball5_pz_response_slide0;
    const real ball5_pz_response_ball0_z = ball5_pz_response_ball0_z_part
        - M_factor_L_ball0_z_ball0_x * ball5_pz_response_ball0_x
        - M_factor_L_ball0_z_ball0_y * ball5_pz_response_ball0_y;
    work[526] = ball5_pz_response_ball0_z;
    const real ball1_G_px_hooke0_angle1 = work[474];
    const real ball1_px_response_hooke0_angle1 = work[543];
    const real ball1_G_px_hooke0_angle2 = work[475];
    const real ball1_px_response_hooke0_angle2 = work[678];
    const real ball1_G_px_slide0 = work[476];
    const real ball1_px_response_slide0 = work[681];
    const real ball1_G_px_ball0_x = work[477];
    const real ball1_px_response_ball0_x = work[683];
    const real circuit_ball1_px_ball1_px_part = ball1_G_px_hooke0_angle1 *
        ball1_px_response_hooke0_angle1
        + ball1_G_px_hooke0_angle2 * ball1_px_response_hooke0_angle2
        + ball1_G_px_slide0 * ball1_px_response_slide0
        + ball1_G_px_ball0_x * ball1_px_response_ball0_x;
    const real ball1_G_px_ball0_y = work[478];
    const real ball1_px_response_ball0_y = work[684];
    const real ball1_G_px_ball0_z = work[479];
    const real ball1_px_response_ball0_z = work[685];
    const real ball1_minus_G_px_hooke1_angle1 = work[480];
    const real ball1_px_minus_response_hooke1_angle1 = work[607];
    const real circuit_ball1_px_ball1_px_part_2 = circuit_ball1_px_ball1_px_part
        + ball1_G_px_ball0_y * ball1_px_response_ball0_y
        + ball1_G_px_ball0_z * ball1_px_response_ball0_z
        + ball1_minus_G_px_hooke1_angle1 * ball1_px_minus_response_hooke1_angle1;
    const real ball1_G_px_hooke1_angle2 = work[481];
    const real ball1_px_response_hooke1_angle2 = work[663];
    const real ball1_minus_G_px_slide1 = work[482];
    const real ball1_px_minus_response_slide1 = work[677];
    const real circuit_ball1_px_ball1_px = circuit_ball1_px_ball1_px_part_2
        + ball1_G_px_hooke1_angle2 * ball1_px_response_hooke1_angle2
        + ball1_minus_G_px_slide1 * ball1_px_minus_response_slide1;
    circuit_matrix[0][0] = circuit_ball1_px_ball1_px;
    const real ball1_G_py_hooke0_angle1 = work[483];
    const real ball1_G_py_hooke0_angle2 = work[484];
    const real ball1_G_py_slide0 = work[485];
    const real ball1_G_py_ball0_x = work[486];
    const real circuit_ball1_py_ball1_px_part = ball1_G_py_hooke0_angle1 *
        ball1_px_response_hooke0_angle1
        + ball1_G_py_hooke0_angle2 * ball1_px_response_hooke0_angle2
        + ball1_G_py_slide0 * ball1_px_response_slide0
        + ball1_G_py_ball0_x * ball1_px_response_ball0_x;
    const real ball1_G_py_ball0_y = work[487];
    const real ball1_G_py_ball0_z = work[488];
    const real ball1_minus_G_py_hooke1_angle1 = work[489];
    const real circuit_ball1_py_ball1_px_part_2 = circuit_ball1_py_ball1_px_part
        + ball1_G_py_ball0_y * ball1_px_response_ball0_y
        + ball1_G_py_ball0_z * ball1_px_response_ball0_z
        + ball1_minus_G_py_hooke1_angle1 * ball1_px_minus_response_hooke1_angle1;
    const real ball1_G_py_hooke1_angle2 = work[490];
    const real ball1_minus_G_py_slide1 = work[491];
    const real circuit_ball1_py_ball1_px = circuit_ball1_py_ball1_px_part_2
        + ball1_G_py_hooke1_angle2 * ball1_px_response_hooke1_angle2
        + ball1_minus_G_py_slide1 * ball1_px_minus_response_slide1;
    circuit_matrix[0][1] = circuit_ball1_py_ball1_px;
    circuit_matrix[1][0] = circuit_ball1_py_ball1_px;
    const real ball1_py_response_hooke0_angle1 = work[686];
    const real ball1_py_response_hooke0_angle2 = work[692];
    const real ball1_py_response_slide0 = work[801];
    const real ball1_py_response_ball0_x = work[802];
    const real circuit_ball1_py_ball1_py_part = ball1_G_py_hooke0_angle1 *
        ball1_py_response_hooke0_angle1
        + ball1_G_py_hooke0_angle2 * ball1_py_response_hooke0_angle2
        + ball1_G_py_slide0 * ball1_py_response_slide0
        + ball1_G_py_ball0_x * ball1_py_response_ball0_x;
    const real ball1_py_response_ball0_y = work[803];
    const real ball1_py_response_ball0_z = work[804];
    const real ball1_py_minus_response_hooke1_angle1 = work[687];
    const real circuit_ball1_py_ball1_py_part_2 = circuit_ball1_py_ball1_py_part
        + ball1_G_py_ball0_y * ball1_py_response_ball0_y
        + ball1_G_py_ball0_z * ball1_py_response_ball0_z
        + ball1_minus_G_py_hooke1_angle1 * ball1_py_minus_response_hooke1_angle1;
    const real ball1_py_response_hooke1_angle2 = work[688];
    const real ball1_py_minus_response_slide1 = work[691];
    const real circuit_ball1_py_ball1_py = circuit_ball1_py_ball1_py_part_2
        + ball1_G_py_hooke1_angle2 * ball1_py_response_hooke1_angle2
        + ball1_minus_G_py_slide1 * ball1_py_minus_response_slide1;
    circuit_matrix[1][1] = circuit_ball1_py_ball1_py;
    const real ball1_G_pz_hooke0_angle1 = work[492];
    const real ball1_G_pz_hooke0_angle2 = work[493];
    const real ball1_G_pz_slide0 = work[494];
    const real ball1_G_pz_ball0_x = work[495];
    const real circuit_ball1_pz_ball1_px_part = ball1_G_pz_hooke0_angle1 *
        ball1_px_response_hooke0_angle1
        + ball1_G_pz_hooke0_angle2 * ball1_px_response_hooke0_angle2
        + ball1_G_pz_slide0 * ball1_px_response_slide0
        + ball1_G_pz_ball0_x * ball1_px_response_ball0_x;
    const real ball1_G_pz_ball0_y = work[496];
    const real ball1_G_pz_ball0_z = work[497];
    const real ball1_minus_G_pz_hooke1_angle1 = work[498];
    const real circuit_ball1_pz_ball1_px_part_2 = circuit_ball1_pz_ball1_px_part
        + ball1_G_pz_ball0_y * ball1_px_response_ball0_y
        + ball1_G_pz_ball0_z * ball1_px_response_ball0_z
        + ball1_minus_G_pz_hooke1_angle1 * ball1_px_minus_response_hooke1_angle1;
    const real ball1_G_pz_hooke1_angle2 = work[499];
    const real ball1_minus_G_pz_slide1 = work[500];
    const real circuit_ball1_pz_ball1_px = circuit_ball1_pz_ball1_px_part_2
        + ball1_G_pz_hooke1_angle2 * ball1_px_response_hooke1_angle2
        + ball1_minus_G_pz_slide1 * ball1_px_minus_response_slide1;
    circuit_matrix[0][2] = circuit_ball1_pz_ball1_px;
    circuit_matrix[2][0] = circuit_ball1_pz_ball1_px;
    const real circuit_ball1_pz_ball1_py_part = ball1_G_pz_hooke0_angle1 *
        ball1_py_response_hooke0_angle1
        + ball1_G_pz_hooke0_angle2 * ball1_py_response_hooke0_angle2
        + ball1_G_pz_slide0 * ball1_py_response_slide0
        + ball1_G_pz_ball0_x * ball1_py_response_ball0_x;
    const real circuit_ball1_pz_ball1_py_part_2 = circuit_ball1_pz_ball1_py_part
        + ball1_G_pz_ball0_y * ball1_py_response_ball0_y
        + ball1_G_pz_ball0_z * ball1_py_response_ball0_z
        + ball1_minus_G_pz_hooke1_angle1 * ball1_py_minus_response_hooke1_angle1;
    const real circuit_ball1_pz_ball1_py = circuit_ball1_pz_ball1_py_part_2
        + ball1_G_pz_hooke1_angle2 * ball1_py_response_hooke1_angle2
        + ball1_minus_G_pz_slide1 * ball1_py_minus_response_slide1;
    circuit_matrix[1][2] = circuit_ball1_pz_ball1_py;
    circuit_matrix[2][1] = circuit_ball1_pz_ball1_py;
    const real ball1_pz_response_hooke0_angle1 = work[805];
    const real ball1_pz_response_hooke0_angle2 = work[809];
    const real ball1_pz_response_slide0 = work[810];
    const real ball1_pz_response_ball0_x = work[811];
    const real circuit_ball1_pz_ball1_pz_part = ball1_G_pz_hooke0_angle1 *
        ball1_pz_response_hooke0_angle1
        + ball1_G_pz_hooke0_angle2 * ball1_pz_response_hooke0_angle2
        + ball1_G_pz_slide0 * ball1_pz_response_slide0
        + ball1_G_pz_ball0_x * ball1_pz_response_ball0_x;
    const real ball1_pz_response_ball0_y = work[812];
    const real ball1_pz_response_ball0_z = work[813];
    const real ball1_pz_minus_response_hooke1_angle1 = work[806];
    const real circuit_ball1_pz_ball1_pz_part_2 = circuit_ball1_pz_ball1_pz_part
        + ball1_G_pz_ball0_y * ball1_pz_response_ball0_y
        + ball1_G_pz_ball0_z * ball1_pz_response_ball0_z
        + ball1_minus_G_pz_hooke1_angle1 * ball1_pz_minus_response_hooke1_angle1;
    const real ball1_pz_response_hooke1_angle2 = work[807];
    const real ball1_pz_minus_response_slide1 = work[808];
    const real circuit_ball1_pz_ball1_pz = circuit_ball1_pz_ball1_pz_part_2
        + ball1_G_pz_hooke1_angle2 * ball1_pz_response_hooke1_angle2
        + ball1_minus_G_pz_slide1 * ball1_pz_minus_response_slide1;
    circuit_matrix[2][2] = circuit_ball1_pz_ball1_pz;
    const real ball2_G_px_hooke0_angle1 = work[575];
    const real ball2_G_px_hooke0_angle2 = work[576];
    const real ball2_G_px_slide0 = work[577];
    const real ball2_G_px_ball0_x = work[578];
    const real circuit_ball2_px_ball1_px_part = ball2_G_px_hooke0_angle1 *
        ball1_px_response_hooke0_angle1
        + ball2_G_px_hooke0_angle2 * ball1_px_response_hooke0_angle2
        + ball2_G_px_slide0 * ball1_px_response_slide0
        + ball2_G_px_ball0_x * ball1_px_response_ball0_x;
    const real ball2_G_px_ball0_y = work[579];
    const real ball2_G_px_ball0_z = work[580];
    const real circuit_ball2_px_ball1_px = circuit_ball2_px_ball1_px_part
        + ball2_G_px_ball0_y * ball1_px_response_ball0_y
        + ball2_G_px_ball0_z * ball1_px_response_ball0_z;
    circuit_matrix[0][3] = circuit_ball2_px_ball1_px;
    circuit_matrix[3][0] = circuit_ball2_px_ball1_px;
    const real circuit_ball2_px_ball1_py_part = ball2_G_px_hooke0_angle1 *
        ball1_py_response_hooke0_angle1
        + ball2_G_px_hooke0_angle2 * ball1_py_response_hooke0_angle2
        + ball2_G_px_slide0 * ball1_py_response_slide0
        + ball2_G_px_ball0_x * ball1_py_response_ball0_x;
    const real circuit_ball2_px_ball1_py = circuit_ball2_px_ball1_py_part
        + ball2_G_px_ball0_y * ball1_py_response_ball0_y
        + ball2_G_px_ball0_z * ball1_py_response_ball0_z;
    circuit_matrix[1][3] = circuit_ball2_px_ball1_py;
    circuit_matrix[3][1] = circuit_ball2_px_ball1_py;
    const real circuit_ball2_px_ball1_pz_part = ball2_G_px_hooke0_angle1 *
        ball1_pz_response_hooke0_angle1
        + ball2_G_px_hooke0_angle2 * ball1_pz_response_hooke0_angle2
        + ball2_G_px_slide0 * ball1_pz_response_slide0
        + ball2_G_px_ball0_x * ball1_pz_response_ball0_x;
    const real circuit_ball2_px_ball1_pz = circuit_ball2_px_ball1_pz_part
        + ball2_G_px_ball0_y * ball1_pz_response_ball0_y
        + ball2_G_px_ball0_z * ball1_pz_response_ball0_z;
    circuit_matrix[2][3] = circuit_ball2_px_ball1_pz;
    circuit_matrix[3][2] = circuit_ball2_px_ball1_pz;
    const real ball2_px_response_hooke0_angle1 = work[814];
    const real ball2_px_response_hooke0_angle2 = work[818];
    const real ball2_px_response_slide0 = work[819];
    const real ball2_px_response_ball0_x = work[820];
    const real circuit_ball2_px_ball2_px_part = ball2_G_px_hooke0_angle1 *
        ball2_px_response_hooke0_angle1
        + ball2_G_px_hooke0_angle2 * ball2_px_response_hooke0_angle2
        + ball2_G_px_slide0 * ball2_px_response_slide0
        + ball2_G_px_ball0_x * ball2_px_response_ball0_x;
    const real ball2_px_response_ball0_y = work[821];
    const real ball2_px_response_ball0_z = work[822];
    const real ball2_minus_G_px_hooke2_angle1 = work[581];
    const real ball2_px_minus_response_hooke2_angle1 = work[815];
    const real circuit_ball2_px_ball2_px_part_2 = circuit_ball2_px_ball2_px_part
        + ball2_G_px_ball0_y * ball2_px_response_ball0_y
        + ball2_G_px_ball0_z * ball2_px_response_ball0_z
        + ball2_minus_G_px_hooke2_angle1 * ball2_px_minus_response_hooke2_angle1;
    const real ball2_G_px_hooke2_angle2 = work[582];
    const real ball2_px_response_hooke2_angle2 = work[816];
    const real ball2_minus_G_px_slide2 = work[583];
    const real ball2_px_minus_response_slide2 = work[817];
    const real circuit_ball2_px_ball2_px = circuit_ball2_px_ball2_px_part_2
        + ball2_G_px_hooke2_angle2 * ball2_px_response_hooke2_angle2
        + ball2_minus_G_px_slide2 * ball2_px_minus_response_slide2;
    circuit_matrix[3][3] = circuit_ball2_px_ball2_px;
    const real ball2_G_py_hooke0_angle1 = work[584];
    const real ball2_G_py_hooke0_angle2 = work[585];
    const real ball2_G_py_slide0 = work[586];
    const real ball2_G_py_ball0_x = work[587];
    const real circuit_ball2_py_ball1_px_part = ball2_G_py_hooke0_angle1 *
        ball1_px_response_hooke0_angle1
        + ball2_G_py_hooke0_angle2 * ball1_px_response_hooke0_angle2
        + ball2_G_py_slide0 * ball1_px_response_slide0
        + ball2_G_py_ball0_x * ball1_px_response_ball0_x;
    const real ball2_G_py_ball0_y = work[588];
    const real ball2_G_py_ball0_z = work[589];
    const real circuit_ball2_py_ball1_px = circuit_ball2_py_ball1_px_part
        + ball2_G_py_ball0_y * ball1_px_response_ball0_y
        + ball2_G_py_ball0_z * ball1_px_response_ball0_z;
    circuit_matrix[0][4] = circuit_ball2_py_ball1_px;
    circuit_matrix[4][0] = circuit_ball2_py_ball1_px;
    const real circuit_ball2_py_ball1_py_part = ball2_G_py_hooke0_angle1 *
        ball1_py_response_hooke0_angle1
        + ball2_G_py_hooke0_angle2 * ball1_py_response_hooke0_angle2
        + ball2_G_py_slide0 * ball1_py_response_slide0
        + ball2_G_py_ball0_x * ball1_py_response_ball0_x;
    const real circuit_ball2_py_ball1_py = circuit_ball2_py_ball1_py_part
        + ball2_G_py_ball0_y * ball1_py_response_ball0_y
        + ball2_G_py_ball0_z * ball1_py_response_ball0_z;
    circuit_matrix[1][4] = circuit_ball2_py_ball1_py;
    circuit_matrix[4][1] = circuit_ball2_py_ball1_py;
    const real circuit_ball2_py_ball1_pz_part = ball2_G_py_hooke0_angle1 *
        ball1_pz_response_hooke0_angle1
        + ball2_G_py_hooke0_angle2 * ball1_pz_response_hooke0_angle2
        + ball2_G_py_slide0 * ball1_pz_response_slide0
        + ball2_G_py_ball0_x * ball1_pz_response_ball0_x;
    const real circuit_ball2_py_ball1_pz = circuit_ball2_py_ball1_pz_part
        + ball2_G_py_ball0_y * ball1_pz_response_ball0_y
        + ball2_G_py_ball0_z * ball1_pz_response_ball0_z;
    circuit_matrix[2][4] = circuit_ball2_py_ball1_pz;
    circuit_matrix[4][2] = circuit_ball2_py_ball1_pz;
    const real circuit_ball2_py_ball2_px_part = ball2_G_py_hooke0_angle1 *
        ball2_px_response_hooke0_angle1
        + ball2_G_py_hooke0_angle2 * ball2_px_response_hooke0_angle2
        + ball2_G_py_slide0 * ball2_px_response_slide0
        + ball2_G_py_ball0_x * ball2_px_response_ball0_x;
    const real ball2_minus_G_py_hooke2_angle1 = work[590];
    const real circuit_ball2_py_ball2_px_part_2 = circuit_ball2_py_ball2_px_part
        + ball2_G_py_ball0_y * ball2_px_response_ball0_y
        + ball2_G_py_ball0_z * ball2_px_response_ball0_z
        + ball2_minus_G_py_hooke2_angle1 * ball2_px_minus_response_hooke2_angle1;
    const real ball2_G_py_hooke2_angle2 = work[591];
    const real ball2_minus_G_py_slide2 = work[592];
    const real circuit_ball2_py_ball2_px = circuit_ball2_py_ball2_px_part_2
        + ball2_G_py_hooke2_angle2 * ball2_px_response_hooke2_angle2
        + ball2_minus_G_py_slide2 * ball2_px_minus_response_slide2;
    circuit_matrix[3][4] = circuit_ball2_py_ball2_px;
    circuit_matrix[4][3] = circuit_ball2_py_ball2_px;
    const real ball2_py_response_hooke0_angle1 = work[823];
    const real ball2_py_response_hooke0_angle2 = work[827];
    const real ball2_py_response_slide0 = work[828];
    const real ball2_py_response_ball0_x = work[829];
    const real circuit_ball2_py_ball2_py_part = ball2_G_py_hooke0_angle1 *
        ball2_py_response_hooke0_angle1
        + ball2_G_py_hooke0_angle2 * ball2_py_response_hooke0_angle2
        + ball2_G_py_slide0 * ball2_py_response_slide0
        + ball2_G_py_ball0_x * ball2_py_response_ball0_x;
    const real ball2_py_response_ball0_y = work[830];
    const real ball2_py_response_ball0_z = work[831];
    const real ball2_py_minus_response_hooke2_angle1 = work[824];
    const real circuit_ball2_py_ball2_py_part_2 = circuit_ball2_py_ball2_py_part
        + ball2_G_py_ball0_y * ball2_py_response_ball0_y
        + ball2_G_py_ball0_z * ball2_py_response_ball0_z
        + ball2_minus_G_py_hooke2_angle1 * ball2_py_minus_response_hooke2_angle1;
    const real ball2_py_response_hooke2_angle2 = work[825];
    const real ball2_py_minus_response_slide2 = work[826];
    const real circuit_ball2_py_ball2_py = circuit_ball2_py_ball2_py_part_2
        + ball2_G_py_hooke2_angle2 * ball2_py_response_hooke2_angle2
        + ball2_minus_G_py_slide2 * ball2_py_minus_response_slide2;
    circuit_matrix[4][4] = circuit_ball2_py_ball2_py;
    const real ball2_G_pz_hooke0_angle1 = work[593];
    const real ball2_G_pz_hooke0_angle2 = work[594];
    const real ball2_G_pz_slide0 = work[595];
    const real ball2_G_pz_ball0_x = work[596];
    const real circuit_ball2_pz_ball1_px_part = ball2_G_pz_hooke0_angle1 *
        ball1_px_response_hooke0_angle1
        + ball2_G_pz_hooke0_angle2 * ball1_px_response_hooke0_angle2
        + ball2_G_pz_slide0 * ball1_px_response_slide0
        + ball2_G_pz_ball0_x * ball1_px_response_ball0_x;
    const real ball2_G_pz_ball0_y = work[597];
    const real ball2_G_pz_ball0_z = work[598];
    const real circuit_ball2_pz_ball1_px = circuit_ball2_pz_ball1_px_part
        + ball2_G_pz_ball0_y * ball1_px_response_ball0_y
        + ball2_G_pz_ball0_z * ball1_px_response_ball0_z;
    circuit_matrix[0][5] = circuit_ball2_pz_ball1_px;
    circuit_matrix[5][0] = circuit_ball2_pz_ball1_px;
    const real circuit_ball2_pz_ball1_py_part = ball2_G_pz_hooke0_angle1 *
        ball1_py_response_hooke0_angle1
        + ball2_G_pz_hooke0_angle2 * ball1_py_response_hooke0_angle2
        + ball2_G_pz_slide0 * ball1_py_response_slide0
        + ball2_G_pz_ball0_x * ball1_py_response_ball0_x;
    const real circuit_ball2_pz_ball1_py = circuit_ball2_pz_ball1_py_part
        + ball2_G_pz_ball0_y * ball1_py_response_ball0_y
        + ball2_G_pz_ball0_z * ball1_py_response_ball0_z;
    circuit_matrix[1][5] = circuit_ball2_pz_ball1_py;
    circuit_matrix[5][1] = circuit_ball2_pz_ball1_py;
    const real circuit_ball2_pz_ball1_pz_part = ball2_G_pz_hooke0_angle1 *
        ball1_pz_response_hooke0_angle1
        + ball2_G_pz_hooke0_angle2 * ball1_pz_response_hooke0_angle2
        + ball2_G_pz_slide0 * ball1_pz_response_slide0
        + ball2_G_pz_ball0_x * ball1_pz_response_ball0_x;
    const real circuit_ball2_pz_ball1_pz = circuit_ball2_pz_ball1_pz_part
        + ball2_G_pz_ball0_y * ball1_pz_response_ball0_y
        + ball2_G_pz_ball0_z * ball1_pz_response_ball0_z;
    circuit_matrix[2][5] = circuit_ball2_pz_ball1_pz;
    circuit_matrix[5][2] = circuit_ball2_pz_ball1_pz;
    const real circuit_ball2_pz_ball2_px_part = ball2_G_pz_hooke0_angle1 *
        ball2_px_response_hooke0_angle1
        + ball2_G_pz_hooke0_angle2 * ball2_px_response_hooke0_angle2
        + ball2_G_pz_slide0 * ball2_px_response_slide0
        + ball2_G_pz_ball0_x * ball2_px_response_ball0_x;
    const real ball2_minus_G_pz_hooke2_angle1 = work[599];
    const real circuit_ball2_pz_ball2_px_part_2 = circuit_ball2_pz_ball2_px_part
        + ball2_G_pz_ball0_y * ball2_px_response_ball0_y
        + ball2_G_pz_ball0_z * ball2_px_response_ball0_z
        + ball2_minus_G_pz_hooke2_angle1 * ball2_px_minus_response_hooke2_angle1;
    const real ball2_G_pz_hooke2_angle2 = work[600];
    const real ball2_minus_G_pz_slide2 = work[601];
    const real circuit_ball2_pz_ball2_px = circuit_ball2_pz_ball2_px_part_2
        + ball2_G_pz_hooke2_angle2 * ball2_px_response_hooke2_angle2
        + ball2_minus_G_pz_slide2 * ball2_px_minus_response_slide2;
    circuit_matrix[3][5] = circuit_ball2_pz_ball2_px;
    circuit_matrix[5][3] = circuit_ball2_pz_ball2_px;
    const real circuit_ball2_pz_ball2_py_part = ball2_G_pz_hooke0_angle1 *
        ball2_py_response_hooke0_angle1
        + ball2_G_pz_hooke0_angle2 * ball2_py_response_hooke0_angle2
        + ball2_G_pz_slide0 * ball2_py_response_slide0
        + ball2_G_pz_ball0_x * ball2_py_response_ball0_x;
    const real circuit_ball2_pz_ball2_py_part_2 = circuit_ball2_pz_ball2_py_part
        + ball2_G_pz_ball0_y * ball2_py_response_ball0_y
        + ball2_G_pz_ball0_z * ball2_py_response_ball0_z
        + ball2_minus_G_pz_hooke2_angle1 * ball2_py_minus_response_hooke2_angle1;
    const real circuit_ball2_pz_ball2_py = circuit_ball2_pz_ball2_py_part_2
        + ball2_G_pz_hooke2_angle2 * ball2_py_response_hooke2_angle2
        + ball2_minus_G_pz_slide2 * ball2_py_minus_response_slide2;
    circuit_matrix[4][5] = circuit_ball2_pz_ball2_py;
    circuit_matrix[5][4] = circuit_ball2_pz_ball2_py;
    const real ball2_pz_response_hooke0_angle1 = work[832];
    const real ball2_pz_response_hooke0_angle2 = work[836];
    const real ball2_pz_response_slide0 = work[837];
    const real ball2_pz_response_ball0_x = work[838];
    const real circuit_ball2_pz_ball2_pz_part = ball2_G_pz_hooke0_angle1 *
        ball2_pz_response_hooke0_angle1
        + ball2_G_pz_hooke0_angle2 * ball2_pz_response_hooke0_angle2
        + ball2_G_pz_slide0 * ball2_pz_response_slide0
        + ball2_G_pz_ball0_x * ball2_pz_response_ball0_x;
    const real ball2_pz_response_ball0_y = work[839];
    const real ball2_pz_response_ball0_z = work[840];
    const real ball2_pz_minus_response_hooke2_angle1 = work[833];
    const real circuit_ball2_pz_ball2_pz_part_2 = circuit_ball2_pz_ball2_pz_part
        + ball2_G_pz_ball0_y * ball2_pz_response_ball0_y
        + ball2_G_pz_ball0_z * ball2_pz_response_ball0_z
        + ball2_minus_G_pz_hooke2_angle1 * ball2_pz_minus_response_hooke2_angle1;
    const real ball2_pz_response_hooke2_angle2 = work[834];
    const real ball2_pz_minus_response_slide2 = work[835];
    const real circuit_ball2_pz_ball2_pz = circuit_ball2_pz_ball2_pz_part_2
        + ball2_G_pz_hooke2_angle2 * ball2_pz_response_hooke2_angle2
        + ball2_minus_G_pz_slide2 * ball2_pz_minus_response_slide2;
    circuit_matrix[5][5] = circuit_ball2_pz_ball2_pz;
    const real ball3_G_px_hooke0_angle1 = work[631];
    const real ball3_G_px_hooke0_angle2 = work[632];
    const real ball3_G_px_slide0 = work[633];
    const real ball3_G_px_ball0_x = work[634];
    const real circuit_ball3_px_ball1_px_part = ball3_G_px_hooke0_angle1 *
        ball1_px_response_hooke0_angle1
        + ball3_G_px_hooke0_angle2 * ball1_px_response_hooke0_angle2
        + ball3_G_px_slide0 * ball1_px_response_slide0
        + ball3_G_px_ball0_x * ball1_px_response_ball0_x;
    const real ball3_G_px_ball0_y = work[635];
    const real ball3_G_px_ball0_z = work[636];
    const real circuit_ball3_px_ball1_px = circuit_ball3_px_ball1_px_part
        + ball3_G_px_ball0_y * ball1_px_response_ball0_y
        + ball3_G_px_ball0_z * ball1_px_response_ball0_z;
    circuit_matrix[0][6] = circuit_ball3_px_ball1_px;
    circuit_matrix[6][0] = circuit_ball3_px_ball1_px;
    const real circuit_ball3_px_ball1_py_part = ball3_G_px_hooke0_angle1 *
        ball1_py_response_hooke0_angle1
        + ball3_G_px_hooke0_angle2 * ball1_py_response_hooke0_angle2
        + ball3_G_px_slide0 * ball1_py_response_slide0
        + ball3_G_px_ball0_x * ball1_py_response_ball0_x;
    const real circuit_ball3_px_ball1_py = circuit_ball3_px_ball1_py_part
        + ball3_G_px_ball0_y * ball1_py_response_ball0_y
        + ball3_G_px_ball0_z * ball1_py_response_ball0_z;
    circuit_matrix[1][6] = circuit_ball3_px_ball1_py;
    circuit_matrix[6][1] = circuit_ball3_px_ball1_py;
    const real circuit_ball3_px_ball1_pz_part = ball3_G_px_hooke0_angle1 *
        ball1_pz_response_hooke0_angle1
        + ball3_G_px_hooke0_angle2 * ball1_pz_response_hooke0_angle2
        + ball3_G_px_slide0 * ball1_pz_response_slide0
        + ball3_G_px_ball0_x * ball1_pz_response_ball0_x;
    const real circuit_ball3_px_ball1_pz = circuit_ball3_px_ball1_pz_part
        + ball3_G_px_ball0_y * ball1_pz_response_ball0_y
        + ball3_G_px_ball0_z * ball1_pz_response_ball0_z;
    circuit_matrix[2][6] = circuit_ball3_px_ball1_pz;
    circuit_matrix[6][2] = circuit_ball3_px_ball1_pz;
    const real circuit_ball3_px_ball2_px_part = ball3_G_px_hooke0_angle1 *
        ball2_px_response_hooke0_angle1
        + ball3_G_px_hooke0_angle2 * ball2_px_response_hooke0_angle2
        + ball3_G_px_slide0 * ball2_px_response_slide0
        + ball3_G_px_ball0_x * ball2_px_response_ball0_x;
    const real circuit_ball3_px_ball2_px = circuit_ball3_px_ball2_px_part
        + ball3_G_px_ball0_y * ball2_px_response_ball0_y
        + ball3_G_px_ball0_z * ball2_px_response_ball0_z;
    circuit_matrix[3][6] = circuit_ball3_px_ball2_px;
    circuit_matrix[6][3] = circuit_ball3_px_ball2_px;
    const real circuit_ball3_px_ball2_py_part = ball3_G_px_hooke0_angle1 *
        ball2_py_response_hooke0_angle1
        + ball3_G_px_hooke0_angle2 * ball2_py_response_hooke0_angle2
        + ball3_G_px_slide0 * ball2_py_response_slide0
        + ball3_G_px_ball0_x * ball2_py_response_ball0_x;
    const real circuit_ball3_px_ball2_py = circuit_ball3_px_ball2_py_part
        + ball3_G_px_ball0_y * ball2_py_response_ball0_y
        + ball3_G_px_ball0_z * ball2_py_response_ball0_z;
    circuit_matrix[4][6] = circuit_ball3_px_ball2_py;
    circuit_matrix[6][4] = circuit_ball3_px_ball2_py;
    const real circuit_ball3_px_ball2_pz_part = ball3_G_px_hooke0_angle1 *
        ball2_pz_response_hooke0_angle1
        + ball3_G_px_hooke0_angle2 * ball2_pz_response_hooke0_angle2
        + ball3_G_px_slide0 * ball2_pz_response_slide0
        + ball3_G_px_ball0_x * ball2_pz_response_ball0_x;
    const real circuit_ball3_px_ball2_pz = circuit_ball3_px_ball2_pz_part
        + ball3_G_px_ball0_y * ball2_pz_response_ball0_y
        + ball3_G_px_ball0_z * ball2_pz_response_ball0_z;
    circuit_matrix[5][6] = circuit_ball3_px_ball2_pz;
    circuit_matrix[6][5] = circuit_ball3_px_ball2_pz;
    const real ball3_px_response_hooke0_angle1 = work[841];
    const real ball3_px_response_hooke0_angle2 = work[845];
    const real ball3_px_response_slide0 = work[846];
    const real ball3_px_response_ball0_x = work[847];
    const real circuit_ball3_px_ball3_px_part = ball3_G_px_hooke0_angle1 *
        ball3_px_response_hooke0_angle1
        + ball3_G_px_hooke0_angle2 * ball3_px_response_hooke0_angle2
        + ball3_G_px_slide0 * ball3_px_response_slide0
        + ball3_G_px_ball0_x * ball3_px_response_ball0_x;
    const real ball3_px_response_ball0_y = work[848];
    const real ball3_px_response_ball0_z = work[849];
    const real ball3_minus_G_px_hooke3_angle1 = work[637];
    const real ball3_px_minus_response_hooke3_angle1 = work[842];
    const real circuit_ball3_px_ball3_px_part_2 = circuit_ball3_px_ball3_px_part
        + ball3_G_px_ball0_y * ball3_px_response_ball0_y
        + ball3_G_px_ball0_z * ball3_px_response_ball0_z
        + ball3_minus_G_px_hooke3_angle1 * ball3_px_minus_response_hooke3_angle1;
    const real ball3_G_px_hooke3_angle2 = work[638];
    const real ball3_px_response_hooke3_angle2 = work[843];
    const real ball3_minus_G_px_slide3 = work[639];
    const real ball3_px_minus_response_slide3 = work[844];
    const real circuit_ball3_px_ball3_px = circuit_ball3_px_ball3_px_part_2
        + ball3_G_px_hooke3_angle2 * ball3_px_response_hooke3_angle2
        + ball3_minus_G_px_slide3 * ball3_px_minus_response_slide3;
    circuit_matrix[6][6] = circuit_ball3_px_ball3_px;
    const real ball3_G_py_hooke0_angle1 = work[640];
    const real ball3_G_py_hooke0_angle2 = work[641];
    const real ball3_G_py_slide0 = work[642];
    const real ball3_G_py_ball0_x = work[643];
    const real circuit_ball3_py_ball1_px_part = ball3_G_py_hooke0_angle1 *
        ball1_px_response_hooke0_angle1
        + ball3_G_py_hooke0_angle2 * ball1_px_response_hooke0_angle2
        + ball3_G_py_slide0 * ball1_px_response_slide0
        + ball3_G_py_ball0_x * ball1_px_response_ball0_x;
    const real ball3_G_py_ball0_y = work[644];
    const real ball3_G_py_ball0_z = work[645];
    const real circuit_ball3_py_ball1_px = circuit_ball3_py_ball1_px_part
        + ball3_G_py_ball0_y * ball1_px_response_ball0_y
        + ball3_G_py_ball0_z * ball1_px_response_ball0_z;
    circuit_matrix[0][7] = circuit_ball3_py_ball1_px;
    circuit_matrix[7][0] = circuit_ball3_py_ball1_px;
    const real circuit_ball3_py_ball1_py_part = ball3_G_py_hooke0_angle1 *
        ball1_py_response_hooke0_angle1
        + ball3_G_py_hooke0_angle2 * ball1_py_response_hooke0_angle2
        + ball3_G_py_slide0 * ball1_py_response_slide0
        + ball3_G_py_ball0_x * ball1_py_response_ball0_x;
    const real circuit_ball3_py_ball1_py = circuit_ball3_py_ball1_py_part
        + ball3_G_py_ball0_y * ball1_py_response_ball0_y
        + ball3_G_py_ball0_z * ball1_py_response_ball0_z;
    circuit_matrix[1][7] = circuit_ball3_py_ball1_py;
    circuit_matrix[7][1] = circuit_ball3_py_ball1_py;
    const real circuit_ball3_py_ball1_pz_part = ball3_G_py_hooke0_angle1 *
        ball1_pz_response_hooke0_angle1
        + ball3_G_py_hooke0_angle2 * ball1_pz_response_hooke0_angle2
        + ball3_G_py_slide0 * ball1_pz_response_slide0
        + ball3_G_py_ball0_x * ball1_pz_response_ball0_x;
    const real circuit_ball3_py_ball1_pz = circuit_ball3_py_ball1_pz_part
        + ball3_G_py_ball0_y * ball1_pz_response_ball0_y
        + ball3_G_py_ball0_z * ball1_pz_response_ball0_z;
    circuit_matrix[2][7] = circuit_ball3_py_ball1_pz;
    circuit_matrix[7][2] = circuit_ball3_py_ball1_pz;
    const real circuit_ball3_py_ball2_px_part = ball3_G_py_hooke0_angle1 *
        ball2_px_response_hooke0_angle1
        + ball3_G_py_hooke0_angle2 * ball2_px_response_hooke0_angle2
        + ball3_G_py_slide0 * ball2_px_response_slide0
        + ball3_G_py_ball0_x * ball2_px_response_ball0_x;
    const real circuit_ball3_py_ball2_px = circuit_ball3_py_ball2_px_part
        + ball3_G_py_ball0_y * ball2_px_response_ball0_y
        + ball3_G_py_ball0_z * ball2_px_response_ball0_z;
    circuit_matrix[3][7] = circuit_ball3_py_ball2_px;
    circuit_matrix[7][3] = circuit_ball3_py_ball2_px;
    const real circuit_ball3_py_ball2_py_part = ball3_G_py_hooke0_angle1 *
        ball2_py_response_hooke0_angle1
        + ball3_G_py_hooke0_angle2 * ball2_py_response_hooke0_angle2
        + ball3_G_py_slide0 * ball2_py_response_slide0
        + ball3_G_py_ball0_x * ball2_py_response_ball0_x;
    const real circuit_ball3_py_ball2_py = circuit_ball3_py_ball2_py_part
        + ball3_G_py_ball0_y * ball2_py_response_ball0_y
        + ball3_G_py_ball0_z * ball2_py_response_ball0_z;
    circuit_matrix[4][7] = circuit_ball3_py_ball2_py;
    circuit_matrix[7][4] = circuit_ball3_py_ball2_py;
    const real circuit_ball3_py_ball2_pz_part = ball3_G_py_hooke0_angle1 *
        ball2_pz_response_hooke0_angle1
        + ball3_G_py_hooke0_angle2 * ball2_pz_response_hooke0_angle2
        + ball3_G_py_slide0 * ball2_pz_response_slide0
        + ball3_G_py_ball0_x * ball2_pz_response_ball0_x;
    const real circuit_ball3_py_ball2_pz = circuit_ball3_py_ball2_pz_part
        + ball3_G_py_ball0_y * ball2_pz_response_ball0_y
        + ball3_G_py_ball0_z * ball2_pz_response_ball0_z;
    circuit_matrix[5][7] = circuit_ball3_py_ball2_pz;
    circuit_matrix[7][5] = circuit_ball3_py_ball2_pz;
    const real circuit_ball3_py_ball3_px_part = ball3_G_py_hooke0_angle1 *
        ball3_px_response_hooke0_angle1
        + ball3_G_py_hooke0_angle2 * ball3_px_response_hooke0_angle2
        + ball3_G_py_slide0 * ball3_px_response_slide0
        + ball3_G_py_ball0_x * ball3_px_response_ball0_x;
    const real ball3_minus_G_py_hooke3_angle1 = work[646];
    const real circuit_ball3_py_ball3_px_part_2 = circuit_ball3_py_ball3_px_part
        + ball3_G_py_ball0_y * ball3_px_response_ball0_y
        + ball3_G_py_ball0_z * ball3_px_response_ball0_z
        + ball3_minus_G_py_hooke3_angle1 * ball3_px_minus_response_hooke3_angle1;
    const real ball3_G_py_hooke3_angle2 = work[647];
    const real ball3_minus_G_py_slide3 = work[648];
    const real circuit_ball3_py_ball3_px = circuit_ball3_py_ball3_px_part_2
        + ball3_G_py_hooke3_angle2 * ball3_px_response_hooke3_angle2
        + ball3_minus_G_py_slide3 * ball3_px_minus_response_slide3;
    circuit_matrix[6][7] = circuit_ball3_py_ball3_px;
    circuit_matrix[7][6] = circuit_ball3_py_ball3_px;
    const real ball3_py_response_hooke0_angle1 = work[850];
    const real ball3_py_response_hooke0_angle2 = work[854];
    const real ball3_py_response_slide0 = work[855];
    const real ball3_py_response_ball0_x = work[856];
    const real circuit_ball3_py_ball3_py_part = ball3_G_py_hooke0_angle1 *
        ball3_py_response_hooke0_angle1
        + ball3_G_py_hooke0_angle2 * ball3_py_response_hooke0_angle2
        + ball3_G_py_slide0 * ball3_py_response_slide0
        + ball3_G_py_ball0_x * ball3_py_response_ball0_x;
    const real ball3_py_response_ball0_y = work[857];
    const real ball3_py_response_ball0_z = work[858];
    const real ball3_py_minus_response_hooke3_angle1 = work[851];
    const real circuit_ball3_py_ball3_py_part_2 = circuit_ball3_py_ball3_py_part
        + ball3_G_py_ball0_y * ball3_py_response_ball0_y
        + ball3_G_py_ball0_z * ball3_py_response_ball0_z
        + ball3_minus_G_py_hooke3_angle1 * ball3_py_minus_response_hooke3_angle1;
    const real ball3_py_response_hooke3_angle2 = work[852];
    const real ball3_py_minus_response_slide3 = work[853];
    const real circuit_ball3_py_ball3_py = circuit_ball3_py_ball3_py_part_2
        + ball3_G_py_hooke3_angle2 * ball3_py_response_hooke3_angle2
        + ball3_minus_G_py_slide3 * ball3_py_minus_response_slide3;
    circuit_matrix[7][7] = circuit_ball3_py_ball3_py;
    const real ball3_G_pz_hooke0_angle1 = work[649];
    const real ball3_G_pz_hooke0_angle2 = work[650];
    const real ball3_G_pz_slide0 = work[651];
    const real ball3_G_pz_ball0_x = work[652];
    const real circuit_ball3_pz_ball1_px_part = ball3_G_pz_hooke0_angle1 *
        ball1_px_response_hooke0_angle1
        + ball3_G_pz_hooke0_angle2 * ball1_px_response_hooke0_angle2
        + ball3_G_pz_slide0 * ball1_px_response_slide0
        + ball3_G_pz_ball0_x * ball1_px_response_ball0_x;
    const real ball3_G_pz_ball0_y = work[653];
    const real circuit_ball3_pz_ball1_px = circuit_ball3_pz_ball1_px_part
        + ball3_G_pz_ball0_y * ball1_px_response_ball0_y
        + ball3_G_pz_ball0_z * ball1_px_response_ball0_z;
    circuit_matrix[0][8] = circuit_ball3_pz_ball1_px;
    circuit_matrix[8][0] = circuit_ball3_pz_ball1_px;
    const real circuit_ball3_pz_ball1_py_part = ball3_G_pz_hooke0_angle1 *
        ball1_py_response_hooke0_angle1
        + ball3_G_pz_hooke0_angle2 * ball1_py_response_hooke0_angle2
        + ball3_G_pz_slide0 * ball1_py_response_slide0
        + ball3_G_pz_ball0_x * ball1_py_response_ball0_x;
    const real circuit_ball3_pz_ball1_py = circuit_ball3_pz_ball1_py_part
        + ball3_G_pz_ball0_y * ball1_py_response_ball0_y
        + ball3_G_pz_ball0_z * ball1_py_response_ball0_z;
    circuit_matrix[1][8] = circuit_ball3_pz_ball1_py;
    circuit_matrix[8][1] = circuit_ball3_pz_ball1_py;
    const real circuit_ball3_pz_ball1_pz_part = ball3_G_pz_hooke0_angle1 *
        ball1_pz_response_hooke0_angle1
        + ball3_G_pz_hooke0_angle2 * ball1_pz_response_hooke0_angle2
        + ball3_G_pz_slide0 * ball1_pz_response_slide0
        + ball3_G_pz_ball0_x * ball1_pz_response_ball0_x;
    const real circuit_ball3_pz_ball1_pz = circuit_ball3_pz_ball1_pz_part
        + ball3_G_pz_ball0_y * ball1_pz_response_ball0_y
        + ball3_G_pz_ball0_z * ball1_pz_response_ball0_z;
    circuit_matrix[2][8] = circuit_ball3_pz_ball1_pz;
    circuit_matrix[8][2] = circuit_ball3_pz_ball1_pz;
    const real circuit_ball3_pz_ball2_px_part = ball3_G_pz_hooke0_angle1 *
        ball2_px_response_hooke0_angle1
        + ball3_G_pz_hooke0_angle2 * ball2_px_response_hooke0_angle2
        + ball3_G_pz_slide0 * ball2_px_response_slide0
        + ball3_G_pz_ball0_x * ball2_px_response_ball0_x;
    const real circuit_ball3_pz_ball2_px = circuit_ball3_pz_ball2_px_part
        + ball3_G_pz_ball0_y * ball2_px_response_ball0_y
        + ball3_G_pz_ball0_z * ball2_px_response_ball0_z;
    circuit_matrix[3][8] = circuit_ball3_pz_ball2_px;
    circuit_matrix[8][3] = circuit_ball3_pz_ball2_px;
    const real circuit_ball3_pz_ball2_py_part = ball3_G_pz_hooke0_angle1 *
        ball2_py_response_hooke0_angle1
        + ball3_G_pz_hooke0_angle2 * ball2_py_response_hooke0_angle2
        + ball3_G_pz_slide0 * ball2_py_response_slide0
        + ball3_G_pz_ball0_x * ball2_py_response_ball0_x;
    const real circuit_ball3_pz_ball2_py = circuit_ball3_pz_ball2_py_part
        + ball3_G_pz_ball0_y * ball2_py_response_ball0_y
        + ball3_G_pz_ball0_z * ball2_py_response_ball0_z;
    circuit_matrix[4][8] = circuit_ball3_pz_ball2_py;
    circuit_matrix[8][4] = circuit_ball3_pz_ball2_py;
    const real circuit_ball3_pz_ball2_pz_part = ball3_G_pz_hooke0_angle1 *
        ball2_pz_response_hooke0_angle1
        + ball3_G_pz_hooke0_angle2 * ball2_pz_response_hooke0_angle2
        + ball3_G_pz_slide0 * ball2_pz_response_slide0
        + ball3_G_pz_ball0_x * ball2_pz_response_ball0_x;
    const real circuit_ball3_pz_ball2_pz = circuit_ball3_pz_ball2_pz_part
        + ball3_G_pz_ball0_y * ball2_pz_response_ball0_y
        + ball3_G_pz_ball0_z * ball2_pz_response_ball0_z;
    circuit_matrix[5][8] = circuit_ball3_pz_ball2_pz;
    circuit_matrix[8][5] = circuit_ball3_pz_ball2_pz;
    const real circuit_ball3_pz_ball3_px_part = ball3_G_pz_hooke0_angle1 *
        ball3_px_response_hooke0_angle1
        + ball3_G_pz_hooke0_angle2 * ball3_px_response_hooke0_angle2
        + ball3_G_pz_slide0 * ball3_px_response_slide0
        + ball3_G_pz_ball0_x * ball3_px_response_ball0_x;
    const real ball3_minus_G_pz_hooke3_angle1 = work[655];
    const real circuit_ball3_pz_ball3_px_part_2 = circuit_ball3_pz_ball3_px_part
        + ball3_G_pz_ball0_y * ball3_px_response_ball0_y
        + ball3_G_pz_ball0_z * ball3_px_response_ball0_z
        + ball3_minus_G_pz_hooke3_angle1 * ball3_px_minus_response_hooke3_angle1;
    const real ball3_G_pz_hooke3_angle2 = work[656];
    const real ball3_minus_G_pz_slide3 = work[657];
    const real circuit_ball3_pz_ball3_px = circuit_ball3_pz_ball3_px_part_2
        + ball3_G_pz_hooke3_angle2 * ball3_px_response_hooke3_angle2
        + ball3_minus_G_pz_slide3 * ball3_px_minus_response_slide3;
    circuit_matrix[6][8] = circuit_ball3_pz_ball3_px;
    circuit_matrix[8][6] = circuit_ball3_pz_ball3_px;
    const real circuit_ball3_pz_ball3_py_part = ball3_G_pz_hooke0_angle1 *
        ball3_py_response_hooke0_angle1
        + ball3_G_pz_hooke0_angle2 * ball3_py_response_hooke0_angle2
        + ball3_G_pz_slide0 * ball3_py_response_slide0
        + ball3_G_pz_ball0_x * ball3_py_response_ball0_x;
    const real circuit_ball3_pz_ball3_py_part_2 = circuit_ball3_pz_ball3_py_part
        + ball3_G_pz_ball0_y * ball3_py_response_ball0_y
        + ball3_G_pz_ball0_z * ball3_py_response_ball0_z
        + ball3_minus_G_pz_hooke3_angle1 * ball3_py_minus_response_hooke3_angle1;
    const real circuit_ball3_pz_ball3_py = circuit_ball3_pz_ball3_py_part_2
        + ball3_G_pz_hooke3_angle2 * ball3_py_response_hooke3_angle2
        + ball3_minus_G_pz_slide3 * ball3_py_minus_response_slide3;
    circuit_matrix[7][8] = circuit_ball3_pz_ball3_py;
    circuit_matrix[8][7] = circuit_ball3_pz_ball3_py;
    const real circuit_ball3_pz_ball3_pz_part = ball3_G_pz_hooke0_angle1 *
        ball3_pz_response_hooke0_angle1
        + ball3_G_pz_hooke0_angle2 * ball3_pz_response_hooke0_angle2
        + ball3_G_pz_slide0 * ball3_pz_response_slide0
        + ball3_G_pz_ball0_x * ball3_pz_response_ball0_x;
    const real ball3_pz_minus_response_hooke3_angle1 = work[861];
    const real circuit_ball3_pz_ball3_pz_part_2 = circuit_ball3_pz_ball3_pz_part
        + ball3_G_pz_ball0_y * ball3_pz_response_ball0_y
        + ball3_G_pz_ball0_z * ball3_pz_response_ball0_z
        + ball3_minus_G_pz_hooke3_angle1 * ball3_pz_minus_response_hooke3_angle1;
    const real ball3_pz_response_hooke3_angle2 = work[862];
    const real ball3_pz_minus_response_slide3 = work[863];
    const real circuit_ball3_pz_ball3_pz = circuit_ball3_pz_ball3_pz_part_2
        + ball3_G_pz_hooke3_angle2 * ball3_pz_response_hooke3_angle2
        + ball3_minus_G_pz_slide3 * ball3_pz_minus_response_slide3;
    circuit_matrix[8][8] = circuit_ball3_pz_ball3_pz;
    const real circuit_ball4_px_ball1_px_part = ball4_G_px_hooke0_angle1 *
        ball1_px_response_hooke0_angle1
        + ball4_G_px_hooke0_angle2 * ball1_px_response_hooke0_angle2
        + ball4_G_px_slide0 * ball1_px_response_slide0
        + ball4_G_px_ball0_x * ball1_px_response_ball0_x;
    const real circuit_ball4_px_ball1_px = circuit_ball4_px_ball1_px_part
        + ball4_G_px_ball0_y * ball1_px_response_ball0_y
        + ball4_G_px_ball0_z * ball1_px_response_ball0_z;
    circuit_matrix[0][9] = circuit_ball4_px_ball1_px;
    circuit_matrix[9][0] = circuit_ball4_px_ball1_px;
    const real circuit_ball4_px_ball1_py_part = ball4_G_px_hooke0_angle1 *
        ball1_py_response_hooke0_angle1
        + ball4_G_px_hooke0_angle2 * ball1_py_response_hooke0_angle2
        + ball4_G_px_slide0 * ball1_py_response_slide0
        + ball4_G_px_ball0_x * ball1_py_response_ball0_x;
    const real circuit_ball4_px_ball1_py = circuit_ball4_px_ball1_py_part
        + ball4_G_px_ball0_y * ball1_py_response_ball0_y
        + ball4_G_px_ball0_z * ball1_py_response_ball0_z;
    circuit_matrix[1][9] = circuit_ball4_px_ball1_py;
    circuit_matrix[9][1] = circuit_ball4_px_ball1_py;
    const real circuit_ball4_px_ball1_pz_part = ball4_G_px_hooke0_angle1 *
        ball1_pz_response_hooke0_angle1
        + ball4_G_px_hooke0_angle2 * ball1_pz_response_hooke0_angle2
        + ball4_G_px_slide0 * ball1_pz_response_slide0
        + ball4_G_px_ball0_x * ball1_pz_response_ball0_x;
    const real circuit_ball4_px_ball1_pz = circuit_ball4_px_ball1_pz_part
        + ball4_G_px_ball0_y * ball1_pz_response_ball0_y
        + ball4_G_px_ball0_z * ball1_pz_response_ball0_z;
    circuit_matrix[2][9] = circuit_ball4_px_ball1_pz;
    circuit_matrix[9][2] = circuit_ball4_px_ball1_pz;
    const real circuit_ball4_px_ball2_px_part = ball4_G_px_hooke0_angle1 *
        ball2_px_response_hooke0_angle1
        + ball4_G_px_hooke0_angle2 * ball2_px_response_hooke0_angle2
        + ball4_G_px_slide0 * ball2_px_response_slide0
        + ball4_G_px_ball0_x * ball2_px_response_ball0_x;
    const real circuit_ball4_px_ball2_px = circuit_ball4_px_ball2_px_part
        + ball4_G_px_ball0_y * ball2_px_response_ball0_y
        + ball4_G_px_ball0_z * ball2_px_response_ball0_z;
    circuit_matrix[3][9] = circuit_ball4_px_ball2_px;
    circuit_matrix[9][3] = circuit_ball4_px_ball2_px;
    const real circuit_ball4_px_ball2_py_part = ball4_G_px_hooke0_angle1 *
        ball2_py_response_hooke0_angle1
        + ball4_G_px_hooke0_angle2 * ball2_py_response_hooke0_angle2
        + ball4_G_px_slide0 * ball2_py_response_slide0
        + ball4_G_px_ball0_x * ball2_py_response_ball0_x;
    const real circuit_ball4_px_ball2_py = circuit_ball4_px_ball2_py_part
        + ball4_G_px_ball0_y * ball2_py_response_ball0_y
        + ball4_G_px_ball0_z * ball2_py_response_ball0_z;
    circuit_matrix[4][9] = circuit_ball4_px_ball2_py;
    circuit_matrix[9][4] = circuit_ball4_px_ball2_py;
    const real circuit_ball4_px_ball2_pz_part = ball4_G_px_hooke0_angle1 *
        ball2_pz_response_hooke0_angle1
        + ball4_G_px_hooke0_angle2 * ball2_pz_response_hooke0_angle2
        + ball4_G_px_slide0 * ball2_pz_response_slide0
        + ball4_G_px_ball0_x * ball2_pz_response_ball0_x;
    const real circuit_ball4_px_ball2_pz = circuit_ball4_px_ball2_pz_part
        + ball4_G_px_ball0_y * ball2_pz_response_ball0_y
        + ball4_G_px_ball0_z * ball2_pz_response_ball0_z;
    circuit_matrix[5][9] = circuit_ball4_px_ball2_pz;
    circuit_matrix[9][5] = circuit_ball4_px_ball2_pz;
    const real circuit_ball4_px_ball3_px_part = ball4_G_px_hooke0_angle1 *
        ball3_px_response_hooke0_angle1
        + ball4_G_px_hooke0_angle2 * ball3_px_response_hooke0_angle2
        + ball4_G_px_slide0 * ball3_px_response_slide0
        + ball4_G_px_ball0_x * ball3_px_response_ball0_x;
    const real circuit_ball4_px_ball3_px = circuit_ball4_px_ball3_px_part
        + ball4_G_px_ball0_y * ball3_px_response_ball0_y
        + ball4_G_px_ball0_z * ball3_px_response_ball0_z;
    circuit_matrix[6][9] = circuit_ball4_px_ball3_px;
    circuit_matrix[9][6] = circuit_ball4_px_ball3_px;
    const real circuit_ball4_px_ball3_py_part = ball4_G_px_hooke0_angle1 *
        ball3_py_response_hooke0_angle1
        + ball4_G_px_hooke0_angle2 * ball3_py_response_hooke0_angle2
        + ball4_G_px_slide0 * ball3_py_response_slide0
        + ball4_G_px_ball0_x * ball3_py_response_ball0_x;
    const real circuit_ball4_px_ball3_py = circuit_ball4_px_ball3_py_part
        + ball4_G_px_ball0_y * ball3_py_response_ball0_y
        + ball4_G_px_ball0_z * ball3_py_response_ball0_z;
    circuit_matrix[7][9] = circuit_ball4_px_ball3_py;
    circuit_matrix[9][7] = circuit_ball4_px_ball3_py;
    const real circuit_ball4_px_ball3_pz_part = ball4_G_px_hooke0_angle1 *
        ball3_pz_response_hooke0_angle1
        + ball4_G_px_hooke0_angle2 * ball3_pz_response_hooke0_angle2
        + ball4_G_px_slide0 * ball3_pz_response_slide0
        + ball4_G_px_ball0_x * ball3_pz_response_ball0_x;
    const real circuit_ball4_px_ball3_pz = circuit_ball4_px_ball3_pz_part
        + ball4_G_px_ball0_y * ball3_pz_response_ball0_y
        + ball4_G_px_ball0_z * ball3_pz_response_ball0_z;
    circuit_matrix[8][9] = circuit_ball4_px_ball3_pz;
    circuit_matrix[9][8] = circuit_ball4_px_ball3_pz;
    const real circuit_ball4_px_ball4_px_part = ball4_G_px_hooke0_angle1 *
        ball4_px_response_hooke0_angle1
        + ball4_G_px_hooke0_angle2 * ball4_px_response_hooke0_angle2
        + ball4_G_px_slide0 * ball4_px_response_slide0
        + ball4_G_px_ball0_x * ball4_px_response_ball0_x;
    const real circuit_ball4_px_ball4_px_part_2 = circuit_ball4_px_ball4_px_part
        + ball4_G_px_ball0_y * ball4_px_response_ball0_y
        + ball4_G_px_ball0_z * ball4_px_response_ball0_z
        + ball4_minus_G_px_hooke4_angle1 * ball4_px_minus_response_hooke4_angle1;
    const real circuit_ball4_px_ball4_px = circuit_ball4_px_ball4_px_part_2
        + ball4_G_px_hooke4_angle2 * ball4_px_response_hooke4_angle2
        + ball4_minus_G_px_slide4 * ball4_px_minus_response_slide4;
    circuit_matrix[9][9] = circuit_ball4_px_ball4_px;
    const real circuit_ball4_py_ball1_px_part = ball4_G_py_hooke0_angle1 *
        ball1_px_response_hooke0_angle1
        + ball4_G_py_hooke0_angle2 * ball1_px_response_hooke0_angle2
        + ball4_G_py_slide0 * ball1_px_response_slide0
        + ball4_G_py_ball0_x * ball1_px_response_ball0_x;
    const real circuit_ball4_py_ball1_px = circuit_ball4_py_ball1_px_part
        + ball4_G_py_ball0_y * ball1_px_response_ball0_y
        + ball4_G_py_ball0_z * ball1_px_response_ball0_z;
    circuit_matrix[0][10] = circuit_ball4_py_ball1_px;
    circuit_matrix[10][0] = circuit_ball4_py_ball1_px;
    const real circuit_ball4_py_ball1_py_part = ball4_G_py_hooke0_angle1 *
        ball1_py_response_hooke0_angle1
        + ball4_G_py_hooke0_angle2 * ball1_py_response_hooke0_angle2
        + ball4_G_py_slide0 * ball1_py_response_slide0
        + ball4_G_py_ball0_x * ball1_py_response_ball0_x;
    const real circuit_ball4_py_ball1_py = circuit_ball4_py_ball1_py_part
        + ball4_G_py_ball0_y * ball1_py_response_ball0_y
        + ball4_G_py_ball0_z * ball1_py_response_ball0_z;
    circuit_matrix[1][10] = circuit_ball4_py_ball1_py;
    circuit_matrix[10][1] = circuit_ball4_py_ball1_py;
    const real circuit_ball4_py_ball1_pz_part = ball4_G_py_hooke0_angle1 *
        ball1_pz_response_hooke0_angle1
        + ball4_G_py_hooke0_angle2 * ball1_pz_response_hooke0_angle2
        + ball4_G_py_slide0 * ball1_pz_response_slide0
        + ball4_G_py_ball0_x * ball1_pz_response_ball0_x;
    const real circuit_ball4_py_ball1_pz = circuit_ball4_py_ball1_pz_part
        + ball4_G_py_ball0_y * ball1_pz_response_ball0_y
        + ball4_G_py_ball0_z * ball1_pz_response_ball0_z;
    circuit_matrix[2][10] = circuit_ball4_py_ball1_pz;
    circuit_matrix[10][2] = circuit_ball4_py_ball1_pz;
    const real circuit_ball4_py_ball2_px_part = ball4_G_py_hooke0_angle1 *
        ball2_px_response_hooke0_angle1
        + ball4_G_py_hooke0_angle2 * ball2_px_response_hooke0_angle2
        + ball4_G_py_slide0 * ball2_px_response_slide0
        + ball4_G_py_ball0_x * ball2_px_response_ball0_x;
    const real circuit_ball4_py_ball2_px = circuit_ball4_py_ball2_px_part
        + ball4_G_py_ball0_y * ball2_px_response_ball0_y
        + ball4_G_py_ball0_z * ball2_px_response_ball0_z;
    circuit_matrix[3][10] = circuit_ball4_py_ball2_px;
    circuit_matrix[10][3] = circuit_ball4_py_ball2_px;
    const real circuit_ball4_py_ball2_py_part = ball4_G_py_hooke0_angle1 *
        ball2_py_response_hooke0_angle1
        + ball4_G_py_hooke0_angle2 * ball2_py_response_hooke0_angle2
        + ball4_G_py_slide0 * ball2_py_response_slide0
        + ball4_G_py_ball0_x * ball2_py_response_ball0_x;
    const real circuit_ball4_py_ball2_py = circuit_ball4_py_ball2_py_part
        + ball4_G_py_ball0_y * ball2_py_response_ball0_y
        + ball4_G_py_ball0_z * ball2_py_response_ball0_z;
    circuit_matrix[4][10] = circuit_ball4_py_ball2_py;
    circuit_matrix[10][4] = circuit_ball4_py_ball2_py;
    const real circuit_ball4_py_ball2_pz_part = ball4_G_py_hooke0_angle1 *
        ball2_pz_response_hooke0_angle1
        + ball4_G_py_hooke0_angle2 * ball2_pz_response_hooke0_angle2
        + ball4_G_py_slide0 * ball2_pz_response_slide0
        + ball4_G_py_ball0_x * ball2_pz_response_ball0_x;
    const real circuit_ball4_py_ball2_pz = circuit_ball4_py_ball2_pz_part
        + ball4_G_py_ball0_y * ball2_pz_response_ball0_y
        + ball4_G_py_ball0_z * ball2_pz_response_ball0_z;
    circuit_matrix[5][10] = circuit_ball4_py_ball2_pz;
    circuit_matrix[10][5] = circuit_ball4_py_ball2_pz;
    const real circuit_ball4_py_ball3_px_part = ball4_G_py_hooke0_angle1 *
        ball3_px_response_hooke0_angle1
        + ball4_G_py_hooke0_angle2 * ball3_px_response_hooke0_angle2
        + ball4_G_py_slide0 * ball3_px_response_slide0
        + ball4_G_py_ball0_x * ball3_px_response_ball0_x;
    const real circuit_ball4_py_ball3_px = circuit_ball4_py_ball3_px_part
        + ball4_G_py_ball0_y * ball3_px_response_ball0_y
        + ball4_G_py_ball0_z * ball3_px_response_ball0_z;
    circuit_matrix[6][10] = circuit_ball4_py_ball3_px;
    circuit_matrix[10][6] = circuit_ball4_py_ball3_px;
    const real circuit_ball4_py_ball3_py_part = ball4_G_py_hooke0_angle1 *
        ball3_py_response_hooke0_angle1
        + ball4_G_py_hooke0_angle2 * ball3_py_response_hooke0_angle2
        + ball4_G_py_slide0 * ball3_py_response_slide0
        + ball4_G_py_ball0_x * ball3_py_response_ball0_x;
    const real circuit_ball4_py_ball3_py = circuit_ball4_py_ball3_py_part
        + ball4_G_py_ball0_y * ball3_py_response_ball0_y
        + ball4_G_py_ball0_z * ball3_py_response_ball0_z;
    circuit_matrix[7][10] = circuit_ball4_py_ball3_py;
    circuit_matrix[10][7] = circuit_ball4_py_ball3_py;
    const real circuit_ball4_py_ball3_pz_part = ball4_G_py_hooke0_angle1 *
        ball3_pz_response_hooke0_angle1
        + ball4_G_py_hooke0_angle2 * ball3_pz_response_hooke0_angle2
        + ball4_G_py_slide0 * ball3_pz_response_slide0
        + ball4_G_py_ball0_x * ball3_pz_response_ball0_x;
    const real circuit_ball4_py_ball3_pz = circuit_ball4_py_ball3_pz_part
        + ball4_G_py_ball0_y * ball3_pz_response_ball0_y
        + ball4_G_py_ball0_z * ball3_pz_response_ball0_z;
    circuit_matrix[8][10] = circuit_ball4_py_ball3_pz;
    circuit_matrix[10][8] = circuit_ball4_py_ball3_pz;
    const real circuit_ball4_py_ball4_px_part = ball4_G_py_hooke0_angle1 *
        ball4_px_response_hooke0_angle1
        + ball4_G_py_hooke0_angle2 * ball4_px_response_hooke0_angle2
        + ball4_G_py_slide0 * ball4_px_response_slide0
        + ball4_G_py_ball0_x * ball4_px_response_ball0_x;
    const real circuit_ball4_py_ball4_px_part_2 = circuit_ball4_py_ball4_px_part
        + ball4_G_py_ball0_y * ball4_px_response_ball0_y
        + ball4_G_py_ball0_z * ball4_px_response_ball0_z
        + ball4_minus_G_py_hooke4_angle1 * ball4_px_minus_response_hooke4_angle1;
    const real circuit_ball4_py_ball4_px = circuit_ball4_py_ball4_px_part_2
        + ball4_G_py_hooke4_angle2 * ball4_px_response_hooke4_angle2
        + ball4_minus_G_py_slide4 * ball4_px_minus_response_slide4;
    circuit_matrix[9][10] = circuit_ball4_py_ball4_px;
    circuit_matrix[10][9] = circuit_ball4_py_ball4_px;
    const real circuit_ball4_py_ball4_py_part = ball4_G_py_hooke0_angle1 *
        ball4_py_response_hooke0_angle1
        + ball4_G_py_hooke0_angle2 * ball4_py_response_hooke0_angle2
        + ball4_G_py_slide0 * ball4_py_response_slide0
        + ball4_G_py_ball0_x * ball4_py_response_ball0_x;
    const real circuit_ball4_py_ball4_py_part_2 = circuit_ball4_py_ball4_py_part
        + ball4_G_py_ball0_y * ball4_py_response_ball0_y
        + ball4_G_py_ball0_z * ball4_py_response_ball0_z
        + ball4_minus_G_py_hooke4_angle1 * ball4_py_minus_response_hooke4_angle1;
    const real circuit_ball4_py_ball4_py = circuit_ball4_py_ball4_py_part_2
        + ball4_G_py_hooke4_angle2 * ball4_py_response_hooke4_angle2
        + ball4_minus_G_py_slide4 * ball4_py_minus_response_slide4;
    circuit_matrix[10][10] = circuit_ball4_py_ball4_py;
    const real circuit_ball4_pz_ball1_px_part = ball4_G_pz_hooke0_angle1 *
        ball1_px_response_hooke0_angle1
        + ball4_G_pz_hooke0_angle2 * ball1_px_response_hooke0_angle2
        + ball4_G_pz_slide0 * ball1_px_response_slide0
        + ball4_G_pz_ball0_x * ball1_px_response_ball0_x;
    const real circuit_ball4_pz_ball1_px = circuit_ball4_pz_ball1_px_part
        + ball4_G_pz_ball0_y * ball1_px_response_ball0_y
        + ball4_G_pz_ball0_z * ball1_px_response_ball0_z;
    circuit_matrix[0][11] = circuit_ball4_pz_ball1_px;
    circuit_matrix[11][0] = circuit_ball4_pz_ball1_px;
    const real circuit_ball4_pz_ball1_py_part = ball4_G_pz_hooke0_angle1 *
        ball1_py_response_hooke0_angle1
        + ball4_G_pz_hooke0_angle2 * ball1_py_response_hooke0_angle2
        + ball4_G_pz_slide0 * ball1_py_response_slide0
        + ball4_G_pz_ball0_x * ball1_py_response_ball0_x;
    const real circuit_ball4_pz_ball1_py = circuit_ball4_pz_ball1_py_part
        + ball4_G_pz_ball0_y * ball1_py_response_ball0_y
        + ball4_G_pz_ball0_z * ball1_py_response_ball0_z;
    circuit_matrix[1][11] = circuit_ball4_pz_ball1_py;
    circuit_matrix[11][1] = circuit_ball4_pz_ball1_py;
    const real circuit_ball4_pz_ball1_pz_part = ball4_G_pz_hooke0_angle1 *
        ball1_pz_response_hooke0_angle1
        + ball4_G_pz_hooke0_angle2 * ball1_pz_response_hooke0_angle2
        + ball4_G_pz_slide0 * ball1_pz_response_slide0
        + ball4_G_pz_ball0_x * ball1_pz_response_ball0_x;
    const real circuit_ball4_pz_ball1_pz = circuit_ball4_pz_ball1_pz_part
        + ball4_G_pz_ball0_y * ball1_pz_response_ball0_y
        + ball4_G_pz_ball0_z * ball1_pz_response_ball0_z;
    circuit_matrix[2][11] = circuit_ball4_pz_ball1_pz;
    circuit_matrix[11][2] = circuit_ball4_pz_ball1_pz;
    const real circuit_ball4_pz_ball2_px_part = ball4_G_pz_hooke0_angle1 *
        ball2_px_response_hooke0_angle1
        + ball4_G_pz_hooke0_angle2 * ball2_px_response_hooke0_angle2
        + ball4_G_pz_slide0 * ball2_px_response_slide0
        + ball4_G_pz_ball0_x * ball2_px_response_ball0_x;
    const real circuit_ball4_pz_ball2_px = circuit_ball4_pz_ball2_px_part
        + ball4_G_pz_ball0_y * ball2_px_response_ball0_y
        + ball4_G_pz_ball0_z * ball2_px_response_ball0_z;
    circuit_matrix[3][11] = circuit_ball4_pz_ball2_px;
    circuit_matrix[11][3] = circuit_ball4_pz_ball2_px;
    const real circuit_ball4_pz_ball2_py_part = ball4_G_pz_hooke0_angle1 *
        ball2_py_response_hooke0_angle1
        + ball4_G_pz_hooke0_angle2 * ball2_py_response_hooke0_angle2
        + ball4_G_pz_slide0 * ball2_py_response_slide0
        + ball4_G_pz_ball0_x * ball2_py_response_ball0_x;
    const real circuit_ball4_pz_ball2_py = circuit_ball4_pz_ball2_py_part
        + ball4_G_pz_ball0_y * ball2_py_response_ball0_y
        + ball4_G_pz_ball0_z * ball2_py_response_ball0_z;
    circuit_matrix[4][11] = circuit_ball4_pz_ball2_py;
    circuit_matrix[11][4] = circuit_ball4_pz_ball2_py;
    const real circuit_ball4_pz_ball2_pz_part = ball4_G_pz_hooke0_angle1 *
        ball2_pz_response_hooke0_angle1
        + ball4_G_pz_hooke0_angle2 * ball2_pz_response_hooke0_angle2
        + ball4_G_pz_slide0 * ball2_pz_response_slide0
        + ball4_G_pz_ball0_x * ball2_pz_response_ball0_x;
    const real circuit_ball4_pz_ball2_pz = circuit_ball4_pz_ball2_pz_part
        + ball4_G_pz_ball0_y * ball2_pz_response_ball0_y
        + ball4_G_pz_ball0_z * ball2_pz_response_ball0_z;
    circuit_matrix[5][11] = circuit_ball4_pz_ball2_pz;
    circuit_matrix[11][5] = circuit_ball4_pz_ball2_pz;
    const real circuit_ball4_pz_ball3_px_part = ball4_G_pz_hooke0_angle1 *
        ball3_px_response_hooke0_angle1
        + ball4_G_pz_hooke0_angle2 * ball3_px_response_hooke0_angle2
        + ball4_G_pz_slide0 * ball3_px_response_slide0
        + ball4_G_pz_ball0_x * ball3_px_response_ball0_x;
    const real circuit_ball4_pz_ball3_px = circuit_ball4_pz_ball3_px_part
        + ball4_G_pz_ball0_y * ball3_px_response_ball0_y
        + ball4_G_pz_ball0_z * ball3_px_response_ball0_z;
    circuit_matrix[6][11] = circuit_ball4_pz_ball3_px;
    circuit_matrix[11][6] = circuit_ball4_pz_ball3_px;
    const real circuit_ball4_pz_ball3_py_part = ball4_G_pz_hooke0_angle1 *
        ball3_py_response_hooke0_angle1
        + ball4_G_pz_hooke0_angle2 * ball3_py_response_hooke0_angle2
        + ball4_G_pz_slide0 * ball3_py_response_slide0
        + ball4_G_pz_ball0_x * ball3_py_response_ball0_x;
    const real circuit_ball4_pz_ball3_py = circuit_ball4_pz_ball3_py_part
        + ball4_G_pz_ball0_y * ball3_py_response_ball0_y
        + ball4_G_pz_ball0_z * ball3_py_response_ball0_z;
    circuit_matrix[7][11] = circuit_ball4_pz_ball3_py;
    circuit_matrix[11][7] = circuit_ball4_pz_ball3_py;
    const real circuit_ball4_pz_ball3_pz_part = ball4_G_pz_hooke0_angle1 *
        ball3_pz_response_hooke0_angle1
        + ball4_G_pz_hooke0_angle2 * ball3_pz_response_hooke0_angle2
        + ball4_G_pz_slide0 * ball3_pz_response_slide0
        + ball4_G_pz_ball0_x * ball3_pz_response_ball0_x;
    const real circuit_ball4_pz_ball3_pz = circuit_ball4_pz_ball3_pz_part
        + ball4_G_pz_ball0_y * ball3_pz_response_ball0_y
        + ball4_G_pz_ball0_z * ball3_pz_response_ball0_z;
    circuit_matrix[8][11] = circuit_ball4_pz_ball3_pz;
    circuit_matrix[11][8] = circuit_ball4_pz_ball3_pz;
    const real circuit_ball4_pz_ball4_px_part = ball4_G_pz_hooke0_angle1 *
        ball4_px_response_hooke0_angle1
        + ball4_G_pz_hooke0_angle2 * ball4_px_response_hooke0_angle2
        + ball4_G_pz_slide0 * ball4_px_response_slide0
        + ball4_G_pz_ball0_x * ball4_px_response_ball0_x;
    const real circuit_ball4_pz_ball4_px_part_2 = circuit_ball4_pz_ball4_px_part
        + ball4_G_pz_ball0_y * ball4_px_response_ball0_y
        + ball4_G_pz_ball0_z * ball4_px_response_ball0_z
        + ball4_minus_G_pz_hooke4_angle1 * ball4_px_minus_response_hooke4_angle1;
    const real circuit_ball4_pz_ball4_px = circuit_ball4_pz_ball4_px_part_2
        + ball4_G_pz_hooke4_angle2 * ball4_px_response_hooke4_angle2
        + ball4_minus_G_pz_slide4 * ball4_px_minus_response_slide4;
    circuit_matrix[9][11] = circuit_ball4_pz_ball4_px;
    circuit_matrix[11][9] = circuit_ball4_pz_ball4_px;
    const real circuit_ball4_pz_ball4_py_part = ball4_G_pz_hooke0_angle1 *
        ball4_py_response_hooke0_angle1
        + ball4_G_pz_hooke0_angle2 * ball4_py_response_hooke0_angle2
        + ball4_G_pz_slide0 * ball4_py_response_slide0
        + ball4_G_pz_ball0_x * ball4_py_response_ball0_x;
    const real circuit_ball4_pz_ball4_py_part_2 = circuit_ball4_pz_ball4_py_part
        + ball4_G_pz_ball0_y * ball4_py_response_ball0_y
        + ball4_G_pz_ball0_z * ball4_py_response_ball0_z
        + ball4_minus_G_pz_hooke4_angle1 * ball4_py_minus_response_hooke4_angle1;
    const real circuit_ball4_pz_ball4_py = circuit_ball4_pz_ball4_py_part_2
        + ball4_G_pz_hooke4_angle2 * ball4_py_response_hooke4_angle2
        + ball4_minus_G_pz_slide4 * ball4_py_minus_response_slide4;
    circuit_matrix[10][11] = circuit_ball4_pz_ball4_py;
    circuit_matrix[11][10] = circuit_ball4_pz_ball4_py;
    const real circuit_ball4_pz_ball4_pz_part = ball4_G_pz_hooke0_angle1 *
        ball4_pz_response_hooke0_angle1
        + ball4_G_pz_hooke0_angle2 * ball4_pz_response_hooke0_angle2
        + ball4_G_pz_slide0 * ball4_pz_response_slide0
        + ball4_G_pz_ball0_x * ball4_pz_response_ball0_x;
    const real circuit_ball4_pz_ball4_pz_part_2 = circuit_ball4_pz_ball4_pz_part
        + ball4_G_pz_ball0_y * ball4_pz_response_ball0_y
        + ball4_G_pz_ball0_z * ball4_pz_response_ball0_z
        + ball4_minus_G_pz_hooke4_angle1 * ball4_pz_minus_response_hooke4_angle1;
    const real circuit_ball4_pz_ball4_pz = circuit_ball4_pz_ball4_pz_part_2
        + ball4_G_pz_hooke4_angle2 * ball4_pz_response_hooke4_angle2
        + ball4_minus_G_pz_slide4 * ball4_pz_minus_response_slide4;
    circuit_matrix[11][11] = circuit_ball4_pz_ball4_pz;
    const real circuit_ball5_px_ball1_px_part = ball5_G_px_hooke0_angle1 *
        ball1_px_response_hooke0_angle1
        + ball5_G_px_hooke0_angle2 * ball1_px_response_hooke0_angle2
        + ball5_G_px_slide0 * ball1_px_response_slide0
        + ball5_G_px_ball0_x * ball1_px_response_ball0_x;
    const real circuit_ball5_px_ball1_px = circuit_ball5_px_ball1_px_part
        + ball5_G_px_ball0_y * ball1_px_response_ball0_y
        + ball5_G_px_ball0_z * ball1_px_response_ball0_z;
    circuit_matrix[0][12] = circuit_ball5_px_ball1_px;
    circuit_matrix[12][0] = circuit_ball5_px_ball1_px;
    const real circuit_ball5_px_ball1_py_part = ball5_G_px_hooke0_angle1 *
        ball1_py_response_hooke0_angle1
        + ball5_G_px_hooke0_angle2 * ball1_py_response_hooke0_angle2
        + ball5_G_px_slide0 * ball1_py_response_slide0
        + ball5_G_px_ball0_x * ball1_py_response_ball0_x;
    const real circuit_ball5_px_ball1_py = circuit_ball5_px_ball1_py_part
        + ball5_G_px_ball0_y * ball1_py_response_ball0_y
        + ball5_G_px_ball0_z * ball1_py_response_ball0_z;
    circuit_matrix[1][12] = circuit_ball5_px_ball1_py;
    circuit_matrix[12][1] = circuit_ball5_px_ball1_py;
    const real circuit_ball5_px_ball1_pz_part = ball5_G_px_hooke0_angle1 *
        ball1_pz_response_hooke0_angle1
        + ball5_G_px_hooke0_angle2 * ball1_pz_response_hooke0_angle2
        + ball5_G_px_slide0 * ball1_pz_response_slide0
        + ball5_G_px_ball0_x * ball1_pz_response_ball0_x;
    const real circuit_ball5_px_ball1_pz = circuit_ball5_px_ball1_pz_part
        + ball5_G_px_ball0_y * ball1_pz_response_ball0_y
        + ball5_G_px_ball0_z * ball1_pz_response_ball0_z;
    circuit_matrix[2][12] = circuit_ball5_px_ball1_pz;
    circuit_matrix[12][2] = circuit_ball5_px_ball1_pz;
    const real circuit_ball5_px_ball2_px_part = ball5_G_px_hooke0_angle1 *
        ball2_px_response_hooke0_angle1
        + ball5_G_px_hooke0_angle2 * ball2_px_response_hooke0_angle2
        + ball5_G_px_slide0 * ball2_px_response_slide0
        + ball5_G_px_ball0_x * ball2_px_response_ball0_x;
    const real circuit_ball5_px_ball2_px = circuit_ball5_px_ball2_px_part
        + ball5_G_px_ball0_y * ball2_px_response_ball0_y
        + ball5_G_px_ball0_z * ball2_px_response_ball0_z;
    circuit_matrix[3][12] = circuit_ball5_px_ball2_px;
    circuit_matrix[12][3] = circuit_ball5_px_ball2_px;
    const real circuit_ball5_px_ball2_py_part = ball5_G_px_hooke0_angle1 *
        ball2_py_response_hooke0_angle1
        + ball5_G_px_hooke0_angle2 * ball2_py_response_hooke0_angle2
        + ball5_G_px_slide0 * ball2_py_response_slide0
        + ball5_G_px_ball0_x * ball2_py_response_ball0_x;
    const real circuit_ball5_px_ball2_py = circuit_ball5_px_ball2_py_part
        + ball5_G_px_ball0_y * ball2_py_response_ball0_y
        + ball5_G_px_ball0_z * ball2_py_response_ball0_z;
    circuit_matrix[4][12] = circuit_ball5_px_ball2_py;
    circuit_matrix[12][4] = circuit_ball5_px_ball2_py;
    const real circuit_ball5_px_ball2_pz_part = ball5_G_px_hooke0_angle1 *
        ball2_pz_response_hooke0_angle1
        + ball5_G_px_hooke0_angle2 * ball2_pz_response_hooke0_angle2
        + ball5_G_px_slide0 * ball2_pz_response_slide0
        + ball5_G_px_ball0_x * ball2_pz_response_ball0_x;
    const real circuit_ball5_px_ball2_pz = circuit_ball5_px_ball2_pz_part
        + ball5_G_px_ball0_y * ball2_pz_response_ball0_y
        + ball5_G_px_ball0_z * ball2_pz_response_ball0_z;
    circuit_matrix[5][12] = circuit_ball5_px_ball2_pz;
    circuit_matrix[12][5] = circuit_ball5_px_ball2_pz;
    const real circuit_ball5_px_ball3_px_part = ball5_G_px_hooke0_angle1 *
        ball3_px_response_hooke0_angle1
        + ball5_G_px_hooke0_angle2 * ball3_px_response_hooke0_angle2
        + ball5_G_px_slide0 * ball3_px_response_slide0
        + ball5_G_px_ball0_x * ball3_px_response_ball0_x;
    const real circuit_ball5_px_ball3_px = circuit_ball5_px_ball3_px_part
        + ball5_G_px_ball0_y * ball3_px_response_ball0_y
        + ball5_G_px_ball0_z * ball3_px_response_ball0_z;
    circuit_matrix[6][12] = circuit_ball5_px_ball3_px;
    circuit_matrix[12][6] = circuit_ball5_px_ball3_px;
    const real circuit_ball5_px_ball3_py_part = ball5_G_px_hooke0_angle1 *
        ball3_py_response_hooke0_angle1
        + ball5_G_px_hooke0_angle2 * ball3_py_response_hooke0_angle2
        + ball5_G_px_slide0 * ball3_py_response_slide0
        + ball5_G_px_ball0_x * ball3_py_response_ball0_x;
    const real circuit_ball5_px_ball3_py = circuit_ball5_px_ball3_py_part
        + ball5_G_px_ball0_y * ball3_py_response_ball0_y
        + ball5_G_px_ball0_z * ball3_py_response_ball0_z;
    circuit_matrix[7][12] = circuit_ball5_px_ball3_py;
    circuit_matrix[12][7] = circuit_ball5_px_ball3_py;
    const real circuit_ball5_px_ball3_pz_part = ball5_G_px_hooke0_angle1 *
        ball3_pz_response_hooke0_angle1
        + ball5_G_px_hooke0_angle2 * ball3_pz_response_hooke0_angle2
        + ball5_G_px_slide0 * ball3_pz_response_slide0
        + ball5_G_px_ball0_x * ball3_pz_response_ball0_x;
    const real circuit_ball5_px_ball3_pz = circuit_ball5_px_ball3_pz_part
        + ball5_G_px_ball0_y * ball3_pz_response_ball0_y
        + ball5_G_px_ball0_z * ball3_pz_response_ball0_z;
    circuit_matrix[8][12] = circuit_ball5_px_ball3_pz;
    circuit_matrix[12][8] = circuit_ball5_px_ball3_pz;
    const real circuit_ball5_px_ball4_px_part = ball5_G_px_hooke0_angle1 *
        ball4_px_response_hooke0_angle1
        + ball5_G_px_hooke0_angle2 * ball4_px_response_hooke0_angle2
        + ball5_G_px_slide0 * ball4_px_response_slide0
        + ball5_G_px_ball0_x * ball4_px_response_ball0_x;
    const real circuit_ball5_px_ball4_px = circuit_ball5_px_ball4_px_part
        + ball5_G_px_ball0_y * ball4_px_response_ball0_y
        + ball5_G_px_ball0_z * ball4_px_response_ball0_z;
    circuit_matrix[9][12] = circuit_ball5_px_ball4_px;
    circuit_matrix[12][9] = circuit_ball5_px_ball4_px;
    const real circuit_ball5_px_ball4_py_part = ball5_G_px_hooke0_angle1 *
        ball4_py_response_hooke0_angle1
        + ball5_G_px_hooke0_angle2 * ball4_py_response_hooke0_angle2
        + ball5_G_px_slide0 * ball4_py_response_slide0
        + ball5_G_px_ball0_x * ball4_py_response_ball0_x;
    const real circuit_ball5_px_ball4_py = circuit_ball5_px_ball4_py_part
        + ball5_G_px_ball0_y * ball4_py_response_ball0_y
        + ball5_G_px_ball0_z * ball4_py_response_ball0_z;
    circuit_matrix[10][12] = circuit_ball5_px_ball4_py;
    circuit_matrix[12][10] = circuit_ball5_px_ball4_py;
    const real circuit_ball5_px_ball4_pz_part = ball5_G_px_hooke0_angle1 *
        ball4_pz_response_hooke0_angle1
        + ball5_G_px_hooke0_angle2 * ball4_pz_response_hooke0_angle2
        + ball5_G_px_slide0 * ball4_pz_response_slide0
        + ball5_G_px_ball0_x * ball4_pz_response_ball0_x;
    const real circuit_ball5_px_ball4_pz = circuit_ball5_px_ball4_pz_part
        + ball5_G_px_ball0_y * ball4_pz_response_ball0_y
        + ball5_G_px_ball0_z * ball4_pz_response_ball0_z;
    circuit_matrix[11][12] = circuit_ball5_px_ball4_pz;
    circuit_matrix[12][11] = circuit_ball5_px_ball4_pz;
    const real circuit_ball5_px_ball5_px_part = ball5_G_px_hooke0_angle1 *
        ball5_px_response_hooke0_angle1
        + ball5_G_px_hooke0_angle2 * ball5_px_response_hooke0_angle2
        + ball5_G_px_slide0 * ball5_px_response_slide0
        + ball5_G_px_ball0_x * ball5_px_response_ball0_x;
    const real circuit_ball5_px_ball5_px_part_2 = circuit_ball5_px_ball5_px_part
        + ball5_G_px_ball0_y * ball5_px_response_ball0_y
        + ball5_G_px_ball0_z * ball5_px_response_ball0_z
        + ball5_minus_G_px_hooke5_angle1 * ball5_px_minus_response_hooke5_angle1;
    const real circuit_ball5_px_ball5_px = circuit_ball5_px_ball5_px_part_2
        + ball5_G_px_hooke5_angle2 * ball5_px_response_hooke5_angle2
        + ball5_minus_G_px_slide5 * ball5_px_minus_response_slide5;
    circuit_matrix[12][12] = circuit_ball5_px_ball5_px;
    const real circuit_ball5_py_ball1_px_part = ball5_G_py_hooke0_angle1 *
        ball1_px_response_hooke0_angle1
        + ball5_G_py_hooke0_angle2 * ball1_px_response_hooke0_angle2
        + ball5_G_py_slide0 * ball1_px_response_slide0
        + ball5_G_py_ball0_x * ball1_px_response_ball0_x;
    const real circuit_ball5_py_ball1_px = circuit_ball5_py_ball1_px_part
        + ball5_G_py_ball0_y * ball1_px_response_ball0_y
        + ball5_G_py_ball0_z * ball1_px_response_ball0_z;
    circuit_matrix[0][13] = circuit_ball5_py_ball1_px;
    circuit_matrix[13][0] = circuit_ball5_py_ball1_px;
    const real circuit_ball5_py_ball1_py_part = ball5_G_py_hooke0_angle1 *
        ball1_py_response_hooke0_angle1
        + ball5_G_py_hooke0_angle2 * ball1_py_response_hooke0_angle2
        + ball5_G_py_slide0 * ball1_py_response_slide0
        + ball5_G_py_ball0_x * ball1_py_response_ball0_x;
    const real circuit_ball5_py_ball1_py = circuit_ball5_py_ball1_py_part
        + ball5_G_py_ball0_y * ball1_py_response_ball0_y
        + ball5_G_py_ball0_z * ball1_py_response_ball0_z;
    circuit_matrix[1][13] = circuit_ball5_py_ball1_py;
    circuit_matrix[13][1] = circuit_ball5_py_ball1_py;
    const real circuit_ball5_py_ball1_pz_part = ball5_G_py_hooke0_angle1 *
        ball1_pz_response_hooke0_angle1
        + ball5_G_py_hooke0_angle2 * ball1_pz_response_hooke0_angle2
        + ball5_G_py_slide0 * ball1_pz_response_slide0
        + ball5_G_py_ball0_x * ball1_pz_response_ball0_x;
    const real circuit_ball5_py_ball1_pz = circuit_ball5_py_ball1_pz_part
        + ball5_G_py_ball0_y * ball1_pz_response_ball0_y
        + ball5_G_py_ball0_z * ball1_pz_response_ball0_z;
    circuit_matrix[2][13] = circuit_ball5_py_ball1_pz;
    circuit_matrix[13][2] = circuit_ball5_py_ball1_pz;
    const real circuit_ball5_py_ball2_px_part = ball5_G_py_hooke0_angle1 *
        ball2_px_response_hooke0_angle1
        + ball5_G_py_hooke0_angle2 * ball2_px_response_hooke0_angle2
        + ball5_G_py_slide0 * ball2_px_response_slide0
        + ball5_G_py_ball0_x * ball2_px_response_ball0_x;
    const real circuit_ball5_py_ball2_px = circuit_ball5_py_ball2_px_part
        + ball5_G_py_ball0_y * ball2_px_response_ball0_y
        + ball5_G_py_ball0_z * ball2_px_response_ball0_z;
    circuit_matrix[3][13] = circuit_ball5_py_ball2_px;
    circuit_matrix[13][3] = circuit_ball5_py_ball2_px;
    const real circuit_ball5_py_ball2_py_part = ball5_G_py_hooke0_angle1 *
        ball2_py_response_hooke0_angle1
        + ball5_G_py_hooke0_angle2 * ball2_py_response_hooke0_angle2
        + ball5_G_py_slide0 * ball2_py_response_slide0
        + ball5_G_py_ball0_x * ball2_py_response_ball0_x;
    const real circuit_ball5_py_ball2_py = circuit_ball5_py_ball2_py_part
        + ball5_G_py_ball0_y * ball2_py_response_ball0_y
        + ball5_G_py_ball0_z * ball2_py_response_ball0_z;
    circuit_matrix[4][13] = circuit_ball5_py_ball2_py;
    circuit_matrix[13][4] = circuit_ball5_py_ball2_py;
    const real circuit_ball5_py_ball2_pz_part = ball5_G_py_hooke0_angle1 *
        ball2_pz_response_hooke0_angle1
        + ball5_G_py_hooke0_angle2 * ball2_pz_response_hooke0_angle2
        + ball5_G_py_slide0 * ball2_pz_response_slide0
        + ball5_G_py_ball0_x * ball2_pz_response_ball0_x;
    const real circuit_ball5_py_ball2_pz = circuit_ball5_py_ball2_pz_part
        + ball5_G_py_ball0_y * ball2_pz_response_ball0_y
        + ball5_G_py_ball0_z * ball2_pz_response_ball0_z;
    circuit_matrix[5][13] = circuit_ball5_py_ball2_pz;
    circuit_matrix[13][5] = circuit_ball5_py_ball2_pz;
    const real circuit_ball5_py_ball3_px_part = ball5_G_py_hooke0_angle1 *
        ball3_px_response_hooke0_angle1
        + ball5_G_py_hooke0_angle2 * ball3_px_response_hooke0_angle2
        + ball5_G_py_slide0 * ball3_px_response_slide0
        + ball5_G_py_ball0_x * ball3_px_response_ball0_x;
    const real circuit_ball5_py_ball3_px = circuit_ball5_py_ball3_px_part
        + ball5_G_py_ball0_y * ball3_px_response_ball0_y
        + ball5_G_py_ball0_z * ball3_px_response_ball0_z;
    circuit_matrix[6][13] = circuit_ball5_py_ball3_px;
    circuit_matrix[13][6] = circuit_ball5_py_ball3_px;
    const real circuit_ball5_py_ball3_py_part = ball5_G_py_hooke0_angle1 *
        ball3_py_response_hooke0_angle1
        + ball5_G_py_hooke0_angle2 * ball3_py_response_hooke0_angle2
        + ball5_G_py_slide0 * ball3_py_response_slide0
        + ball5_G_py_ball0_x * ball3_py_response_ball0_x;
    const real circuit_ball5_py_ball3_py = circuit_ball5_py_ball3_py_part
        + ball5_G_py_ball0_y * ball3_py_response_ball0_y
        + ball5_G_py_ball0_z * ball3_py_response_ball0_z;
    circuit_matrix[7][13] = circuit_ball5_py_ball3_py;
    circuit_matrix[13][7] = circuit_ball5_py_ball3_py;
    const real circuit_ball5_py_ball3_pz_part = ball5_G_py_hooke0_angle1 *
        ball3_pz_response_hooke0_angle1
        + ball5_G_py_hooke0_angle2 * ball3_pz_response_hooke0_angle2
        + ball5_G_py_slide0 * ball3_pz_response_slide0
        + ball5_G_py_ball0_x * ball3_pz_response_ball0_x;
    const real circuit_ball5_py_ball3_pz = circuit_ball5_py_ball3_pz_part
        + ball5_G_py_ball0_y * ball3_pz_response_ball0_y
        + ball5_G_py_ball0_z * ball3_pz_response_ball0_z;
    circuit_matrix[8][13] = circuit_ball5_py_ball3_pz;
    circuit_matrix[13][8] = circuit_ball5_py_ball3_pz;
    const real circuit_ball5_py_ball4_px_part = ball5_G_py_hooke0_angle1 *
        ball4_px_response_hooke0_angle1
        + ball5_G_py_hooke0_angle2 * ball4_px_response_hooke0_angle2
        + ball5_G_py_slide0 * ball4_px_response_slide0
        + ball5_G_py_ball0_x * ball4_px_response_ball0_x;
    const real circuit_ball5_py_ball4_px = circuit_ball5_py_ball4_px_part
        + ball5_G_py_ball0_y * ball4_px_response_ball0_y
        + ball5_G_py_ball0_z * ball4_px_response_ball0_z;
    circuit_matrix[9][13] = circuit_ball5_py_ball4_px;
    circuit_matrix[13][9] = circuit_ball5_py_ball4_px;
    const real circuit_ball5_py_ball4_py_part = ball5_G_py_hooke0_angle1 *
        ball4_py_response_hooke0_angle1
        + ball5_G_py_hooke0_angle2 * ball4_py_response_hooke0_angle2
        + ball5_G_py_slide0 * ball4_py_response_slide0
        + ball5_G_py_ball0_x * ball4_py_response_ball0_x;
    const real circuit_ball5_py_ball4_py = circuit_ball5_py_ball4_py_part
        + ball5_G_py_ball0_y * ball4_py_response_ball0_y
        + ball5_G_py_ball0_z * ball4_py_response_ball0_z;
    circuit_matrix[10][13] = circuit_ball5_py_ball4_py;
    circuit_matrix[13][10] = circuit_ball5_py_ball4_py;
    const real circuit_ball5_py_ball4_pz_part = ball5_G_py_hooke0_angle1 *
        ball4_pz_response_hooke0_angle1
        + ball5_G_py_hooke0_angle2 * ball4_pz_response_hooke0_angle2
        + ball5_G_py_slide0 * ball4_pz_response_slide0
        + ball5_G_py_ball0_x * ball4_pz_response_ball0_x;
    const real circuit_ball5_py_ball4_pz = circuit_ball5_py_ball4_pz_part
        + ball5_G_py_ball0_y * ball4_pz_response_ball0_y
        + ball5_G_py_ball0_z * ball4_pz_response_ball0_z;
    circuit_matrix[11][13] = circuit_ball5_py_ball4_pz;
    circuit_matrix[13][11] = circuit_ball5_py_ball4_pz;
    const real circuit_ball5_py_ball5_px_part = ball5_G_py_hooke0_angle1 *
        ball5_px_response_hooke0_angle1
        + ball5_G_py_hooke0_angle2 * ball5_px_response_hooke0_angle2
        + ball5_G_py_slide0 * ball5_px_response_slide0
        + ball5_G_py_ball0_x * ball5_px_response_ball0_x;
    const real circuit_ball5_py_ball5_px_part_2 = circuit_ball5_py_ball5_px_part
        + ball5_G_py_ball0_y * ball5_px_response_ball0_y
        + ball5_G_py_ball0_z * ball5_px_response_ball0_z
        + ball5_minus_G_py_hooke5_angle1 * ball5_px_minus_response_hooke5_angle1;
    const real circuit_ball5_py_ball5_px = circuit_ball5_py_ball5_px_part_2
        + ball5_G_py_hooke5_angle2 * ball5_px_response_hooke5_angle2
        + ball5_minus_G_py_slide5 * ball5_px_minus_response_slide5;
    circuit_matrix[12][13] = circuit_ball5_py_ball5_px;
    circuit_matrix[13][12] = circuit_ball5_py_ball5_px;
    const real circuit_ball5_py_ball5_py_part = ball5_G_py_hooke0_angle1 *
        ball5_py_response_hooke0_angle1
        + ball5_G_py_hooke0_angle2 * ball5_py_response_hooke0_angle2
        + ball5_G_py_slide0 * ball5_py_response_slide0
        + ball5_G_py_ball0_x * ball5_py_response_ball0_x;
    const real circuit_ball5_py_ball5_py_part_2 = circuit_ball5_py_ball5_py_part
        + ball5_G_py_ball0_y * ball5_py_response_ball0_y
        + ball5_G_py_ball0_z * ball5_py_response_ball0_z
        + ball5_minus_G_py_hooke5_angle1 * ball5_py_minus_response_hooke5_angle1;
    const real circuit_ball5_py_ball5_py = circuit_ball5_py_ball5_py_part_2
        + ball5_G_py_hooke5_angle2 * ball5_py_response_hooke5_angle2
        + ball5_minus_G_py_slide5 * ball5_py_minus_response_slide5;
    circuit_matrix[13][13] = circuit_ball5_py_ball5_py;
    const real circuit_ball5_pz_ball1_px_part = ball5_G_pz_hooke0_angle1 *
        ball1_px_response_hooke0_angle1
        + ball5_G_pz_hooke0_angle2 * ball1_px_response_hooke0_angle2
        + ball5_G_pz_slide0 * ball1_px_response_slide0
        + ball5_G_pz_ball0_x * ball1_px_response_ball0_x;
    const real circuit_ball5_pz_ball1_px = circuit_ball5_pz_ball1_px_part
        + ball5_G_pz_ball0_y * ball1_px_response_ball0_y
        + ball5_G_pz_ball0_z * ball1_px_response_ball0_z;
    circuit_matrix[0][14] = circuit_ball5_pz_ball1_px;
    circuit_matrix[14][0] = circuit_ball5_pz_ball1_px;
    const real circuit_ball5_pz_ball1_py_part = ball5_G_pz_hooke0_angle1 *
        ball1_py_response_hooke0_angle1
        + ball5_G_pz_hooke0_angle2 * ball1_py_response_hooke0_angle2
        + ball5_G_pz_slide0 * ball1_py_response_slide0
        + ball5_G_pz_ball0_x * ball1_py_response_ball0_x;
    const real circuit_ball5_pz_ball1_py = circuit_ball5_pz_ball1_py_part
        + ball5_G_pz_ball0_y * ball1_py_response_ball0_y
        + ball5_G_pz_ball0_z * ball1_py_response_ball0_z;
    circuit_matrix[1][14] = circuit_ball5_pz_ball1_py;
    circuit_matrix[14][1] = circuit_ball5_pz_ball1_py;
    const real circuit_ball5_pz_ball1_pz_part = ball5_G_pz_hooke0_angle1 *
        ball1_pz_response_hooke0_angle1
        + ball5_G_pz_hooke0_angle2 * ball1_pz_response_hooke0_angle2
        + ball5_G_pz_slide0 * ball1_pz_response_slide0
        + ball5_G_pz_ball0_x * ball1_pz_response_ball0_x;
    const real circuit_ball5_pz_ball1_pz = circuit_ball5_pz_ball1_pz_part
        + ball5_G_pz_ball0_y * ball1_pz_response_ball0_y
        + ball5_G_pz_ball0_z * ball1_pz_response_ball0_z;
    circuit_matrix[2][14] = circuit_ball5_pz_ball1_pz;
    circuit_matrix[14][2] = circuit_ball5_pz_ball1_pz;
    const real circuit_ball5_pz_ball2_px_part = ball5_G_pz_hooke0_angle1 *
        ball2_px_response_hooke0_angle1
        + ball5_G_pz_hooke0_angle2 * ball2_px_response_hooke0_angle2
        + ball5_G_pz_slide0 * ball2_px_response_slide0
        + ball5_G_pz_ball0_x * ball2_px_response_ball0_x;
    const real circuit_ball5_pz_ball2_px = circuit_ball5_pz_ball2_px_part
        + ball5_G_pz_ball0_y * ball2_px_response_ball0_y
        + ball5_G_pz_ball0_z * ball2_px_response_ball0_z;
    circuit_matrix[3][14] = circuit_ball5_pz_ball2_px;
    circuit_matrix[14][3] = circuit_ball5_pz_ball2_px;
    const real circuit_ball5_pz_ball2_py_part = ball5_G_pz_hooke0_angle1 *
        ball2_py_response_hooke0_angle1
        + ball5_G_pz_hooke0_angle2 * ball2_py_response_hooke0_angle2
        + ball5_G_pz_slide0 * ball2_py_response_slide0
        + ball5_G_pz_ball0_x * ball2_py_response_ball0_x;
    const real circuit_ball5_pz_ball2_py = circuit_ball5_pz_ball2_py_part
        + ball5_G_pz_ball0_y * ball2_py_response_ball0_y
        + ball5_G_pz_ball0_z * ball2_py_response_ball0_z;
    circuit_matrix[4][14] = circuit_ball5_pz_ball2_py;
    circuit_matrix[14][4] = circuit_ball5_pz_ball2_py;
    const real circuit_ball5_pz_ball2_pz_part = ball5_G_pz_hooke0_angle1 *
        ball2_pz_response_hooke0_angle1
        + ball5_G_pz_hooke0_angle2 * ball2_pz_response_hooke0_angle2
        + ball5_G_pz_slide0 * ball2_pz_response_slide0
        + ball5_G_pz_ball0_x * ball2_pz_response_ball0_x;
    const real circuit_ball5_pz_ball2_pz = circuit_ball5_pz_ball2_pz_part
        + ball5_G_pz_ball0_y * ball2_pz_response_ball0_y
        + ball5_G_pz_ball0_z * ball2_pz_response_ball0_z;
    circuit_matrix[5][14] = circuit_ball5_pz_ball2_pz;
    circuit_matrix[14][5] = circuit_ball5_pz_ball2_pz;
    const real circuit_ball5_pz_ball3_px_part = ball5_G_pz_hooke0_angle1 *
        ball3_px_response_hooke0_angle1
        + ball5_G_pz_hooke0_angle2 * ball3_px_response_hooke0_angle2
        + ball5_G_pz_slide0 * ball3_px_response_slide0
        + ball5_G_pz_ball0_x * ball3_px_response_ball0_x;
    const real circuit_ball5_pz_ball3_px = circuit_ball5_pz_ball3_px_part
        + ball5_G_pz_ball0_y * ball3_px_response_ball0_y
        + ball5_G_pz_ball0_z * ball3_px_response_ball0_z;
    circuit_matrix[6][14] = circuit_ball5_pz_ball3_px;
    circuit_matrix[14][6] = circuit_ball5_pz_ball3_px;
    const real circuit_ball5_pz_ball3_py_part = ball5_G_pz_hooke0_angle1 *
        ball3_py_response_hooke0_angle1
        + ball5_G_pz_hooke0_angle2 * ball3_py_response_hooke0_angle2
        + ball5_G_pz_slide0 * ball3_py_response_slide0
        + ball5_G_pz_ball0_x * ball3_py_response_ball0_x;
    const real circuit_ball5_pz_ball3_py = circuit_ball5_pz_ball3_py_part
        + ball5_G_pz_ball0_y * ball3_py_response_ball0_y
        + ball5_G_pz_ball0_z * ball3_py_response_ball0_z;
    circuit_matrix[7][14] = circuit_ball5_pz_ball3_py;
    circuit_matrix[14][7] = circuit_ball5_pz_ball3_py;
    const real circuit_ball5_pz_ball3_pz_part = ball5_G_pz_hooke0_angle1 *
        ball3_pz_response_hooke0_angle1
        + ball5_G_pz_hooke0_angle2 * ball3_pz_response_hooke0_angle2
        + ball5_G_pz_slide0 * ball3_pz_response_slide0
        + ball5_G_pz_ball0_x * ball3_pz_response_ball0_x;
    const real circuit_ball5_pz_ball3_pz = circuit_ball5_pz_ball3_pz_part
        + ball5_G_pz_ball0_y * ball3_pz_response_ball0_y
        + ball5_G_pz_ball0_z * ball3_pz_response_ball0_z;
    circuit_matrix[8][14] = circuit_ball5_pz_ball3_pz;
    circuit_matrix[14][8] = circuit_ball5_pz_ball3_pz;
    const real circuit_ball5_pz_ball4_px_part = ball5_G_pz_hooke0_angle1 *
        ball4_px_response_hooke0_angle1
        + ball5_G_pz_hooke0_angle2 * ball4_px_response_hooke0_angle2
        + ball5_G_pz_slide0 * ball4_px_response_slide0
        + ball5_G_pz_ball0_x * ball4_px_response_ball0_x;
    const real circuit_ball5_pz_ball4_px = circuit_ball5_pz_ball4_px_part
        + ball5_G_pz_ball0_y * ball4_px_response_ball0_y
        + ball5_G_pz_ball0_z * ball4_px_response_ball0_z;
    circuit_matrix[9][14] = circuit_ball5_pz_ball4_px;
    circuit_matrix[14][9] = circuit_ball5_pz_ball4_px;
    const real circuit_ball5_pz_ball4_py_part = ball5_G_pz_hooke0_angle1 *
        ball4_py_response_hooke0_angle1
        + ball5_G_pz_hooke0_angle2 * ball4_py_response_hooke0_angle2
        + ball5_G_pz_slide0 * ball4_py_response_slide0
        + ball5_G_pz_ball0_x * ball4_py_response_ball0_x;
    const real circuit_ball5_pz_ball4_py = circuit_ball5_pz_ball4_py_part
        + ball5_G_pz_ball0_y * ball4_py_response_ball0_y
        + ball5_G_pz_ball0_z * ball4_py_response_ball0_z;
    circuit_matrix[10][14] = circuit_ball5_pz_ball4_py;
    circuit_matrix[14][10] = circuit_ball5_pz_ball4_py;
    const real circuit_ball5_pz_ball4_pz_part = ball5_G_pz_hooke0_angle1 *
        ball4_pz_response_hooke0_angle1
        + ball5_G_pz_hooke0_angle2 * ball4_pz_response_hooke0_angle2
        + ball5_G_pz_slide0 * ball4_pz_response_slide0
        + ball5_G_pz_ball0_x * ball4_pz_response_ball0_x;
    const real circuit_ball5_pz_ball4_pz = circuit_ball5_pz_ball4_pz_part
        + ball5_G_pz_ball0_y * ball4_pz_response_ball0_y
        + ball5_G_pz_ball0_z * ball4_pz_response_ball0_z;
    circuit_matrix[11][14] = circuit_ball5_pz_ball4_pz;
    circuit_matrix[14][11] = circuit_ball5_pz_ball4_pz;
    const real circuit_ball5_pz_ball5_px_part = ball5_G_pz_hooke0_angle1 *
        ball5_px_response_hooke0_angle1
        + ball5_G_pz_hooke0_angle2 * ball5_px_response_hooke0_angle2
        + ball5_G_pz_slide0 * ball5_px_response_slide0
        + ball5_G_pz_ball0_x * ball5_px_response_ball0_x;
    const real circuit_ball5_pz_ball5_px_part_2 = circuit_ball5_pz_ball5_px_part
        + ball5_G_pz_ball0_y * ball5_px_response_ball0_y
        + ball5_G_pz_ball0_z * ball5_px_response_ball0_z
        + ball5_minus_G_pz_hooke5_angle1 * ball5_px_minus_response_hooke5_angle1;
    const real circuit_ball5_pz_ball5_px = circuit_ball5_pz_ball5_px_part_2
        + ball5_G_pz_hooke5_angle2 * ball5_px_response_hooke5_angle2
        + ball5_minus_G_pz_slide5 * ball5_px_minus_response_slide5;
    circuit_matrix[12][14] = circuit_ball5_pz_ball5_px;
    circuit_matrix[14][12] = circuit_ball5_pz_ball5_px;
    const real circuit_ball5_pz_ball5_py_part = ball5_G_pz_hooke0_angle1 *
        ball5_py_response_hooke0_angle1
        + ball5_G_pz_hooke0_angle2 * ball5_py_response_hooke0_angle2
        + ball5_G_pz_slide0 * ball5_py_response_slide0
        + ball5_G_pz_ball0_x * ball5_py_response_ball0_x;
    const real circuit_ball5_pz_ball5_py_part_2 = circuit_ball5_pz_ball5_py_part
        + ball5_G_pz_ball0_y * ball5_py_response_ball0_y
        + ball5_G_pz_ball0_z * ball5_py_response_ball0_z
        + ball5_minus_G_pz_hooke5_angle1 * ball5_py_minus_response_hooke5_angle1;
    const real circuit_ball5_pz_ball5_py = circuit_ball5_pz_ball5_py_part_2
        + ball5_G_pz_hooke5_angle2 * ball5_py_response_hooke5_angle2
        + ball5_minus_G_pz_slide5 * ball5_py_minus_response_slide5;
    circuit_matrix[13][14] = circuit_ball5_pz_ball5_py;
    circuit_matrix[14][13] = circuit_ball5_pz_ball5_py;
    const real circuit_ball5_pz_ball5_pz_part = ball5_G_pz_hooke0_angle1 *
        ball5_pz_response_hooke0_angle1
        + ball5_G_pz_hooke0_angle2 * ball5_pz_response_hooke0_angle2
        + ball5_G_pz_slide0 * ball5_pz_response_slide0
        + ball5_G_pz_ball0_x * ball5_pz_response_ball0_x;
    const real circuit_ball5_pz_ball5_pz_part_2 = circuit_ball5_pz_ball5_pz_part
        + ball5_G_pz_ball0_y * ball5_pz_response_ball0_y
        + ball5_G_pz_ball0_z * ball5_pz_response_ball0_z
        + ball5_minus_G_pz_hooke5_angle1 * ball5_pz_minus_response_hooke5_angle1;
    const real circuit_ball5_pz_ball5_pz = circuit_ball5_pz_ball5_pz_part_2
        + ball5_G_pz_hooke5_angle2 * ball5_pz_response_hooke5_angle2
        + ball5_minus_G_pz_slide5 * ball5_pz_minus_response_slide5;
    circuit_matrix[14][14] = circuit_ball5_pz_ball5_pz;
    const real free_udot_hooke0_angle1 = work[448];
    const real free_udot_hooke0_angle2 = work[534];
    const real free_udot_slide0 = work[535];
    const real free_udot_ball0_x = work[537];
    const real free_udot_ball0_y = work[538];
    const real free_gamma_minus_ball1_px_part = ball1_G_px_hooke0_angle1 * free_udot_hooke0_angle1 +
        ball1_G_px_hooke0_angle2 * free_udot_hooke0_angle2 + ball1_G_px_slide0 * free_udot_slide0
        + ball1_G_px_ball0_x * free_udot_ball0_x + ball1_G_px_ball0_y * free_udot_ball0_y;
    const real free_udot_ball0_z = work[539];
    const real free_udot_hooke1_angle1 = work[501];
    const real free_udot_hooke1_angle2 = work[502];
    const real free_udot_slide1 = work[503];
    const real free_gamma_minus_ball1_px_part_2 = free_gamma_minus_ball1_px_part
        + ball1_G_px_ball0_z * free_udot_ball0_z
        - ball1_minus_G_px_hooke1_angle1 * free_udot_hooke1_angle1
        + ball1_G_px_hooke1_angle2 * free_udot_hooke1_angle2
        - ball1_minus_G_px_slide1 * free_udot_slide1;
    work[527] = free_gamma_minus_ball1_px_part_2;
    const real free_gamma_minus_ball1_py_part = ball1_G_py_hooke0_angle1 * free_udot_hooke0_angle1 +
        ball1_G_py_hooke0_angle2 * free_udot_hooke0_angle2 + ball1_G_py_slide0 * free_udot_slide0
        + ball1_G_py_ball0_x * free_udot_ball0_x + ball1_G_py_ball0_y * free_udot_ball0_y;
    const real free_gamma_minus_ball1_py_part_2 = free_gamma_minus_ball1_py_part
        + ball1_G_py_ball0_z * free_udot_ball0_z
        - ball1_minus_G_py_hooke1_angle1 * free_udot_hooke1_angle1
        + ball1_G_py_hooke1_angle2 * free_udot_hooke1_angle2
        - ball1_minus_G_py_slide1 * free_udot_slide1;
    work[528] = free_gamma_minus_ball1_py_part_2;
    const real free_gamma_minus_ball1_pz_part = ball1_G_pz_hooke0_angle1 * free_udot_hooke0_angle1 +
        ball1_G_pz_hooke0_angle2 * free_udot_hooke0_angle2 + ball1_G_pz_slide0 * free_udot_slide0
        + ball1_G_pz_ball0_x * free_udot_ball0_x + ball1_G_pz_ball0_y * free_udot_ball0_y;
    const real free_gamma_minus_ball1_pz_part_2 = free_gamma_minus_ball1_pz_part
        + ball1_G_pz_ball0_z * free_udot_ball0_z
        - ball1_minus_G_pz_hooke1_angle1 * free_udot_hooke1_angle1
        + ball1_G_pz_hooke1_angle2 * free_udot_hooke1_angle2
        - ball1_minus_G_pz_slide1 * free_udot_slide1;
    work[529] = free_gamma_minus_ball1_pz_part_2;
    const real free_gamma_minus_ball2_px_part = ball2_G_px_hooke0_angle1 * free_udot_hooke0_angle1 +
        ball2_G_px_hooke0_angle2 * free_udot_hooke0_angle2 + ball2_G_px_slide0 * free_udot_slide0
        + ball2_G_px_ball0_x * free_udot_ball0_x + ball2_G_px_ball0_y * free_udot_ball0_y;
    work[530] = free_gamma_minus_ball2_px_part;
    return CARDAN_OK;
}

CARDAN_PART int forward_dynamics_part6(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    (void)in;
    real (*const circuit_matrix)[15] = (real (*)[15])(work + 0);
    real *const circuit_right = work + 225;
    real *const circuit_scratch = work + 240;
    int status = CARDAN_OK;

    /* constraints: multipliers */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const real free_gamma_minus_ball2_px_part = work[530];
    const real ball2_G_px_ball0_z = work[580];
    const real free_udot_ball0_z = work[539];
    const real ball2_minus_G_px_hooke2_angle1 = work[581];
    const real free_udot_hooke2_angle1 = work[510];
    const real ball2_G_px_hooke2_angle2 = work[582];
    const real free_udot_hooke2_angle2 = work[511];
    const real ball2_minus_G_px_slide2 = work[583];
    const real free_udot_slide2 = work[512];
    const real free_gamma_minus_ball2_px_part_2 = free_gamma_minus_ball2_px_part
        + ball2_G_px_ball0_z * free_udot_ball0_z
        - ball2_minus_G_px_hooke2_angle1 * free_udot_hooke2_angle1
        + ball2_G_px_hooke2_angle2 * free_udot_hooke2_angle2
        - ball2_minus_G_px_slide2 * free_udot_slide2;
    const real ball2_G_py_hooke0_angle1 = work[584];
    const real free_udot_hooke0_angle1 = work[448];
    const real ball2_G_py_hooke0_angle2 = work[585];
    const real free_udot_hooke0_angle2 = work[534];
    const real ball2_G_py_slide0 = work[586];
    const real free_udot_slide0 = work[535];
    const real ball2_G_py_ball0_x = work[587];
    const real free_udot_ball0_x = work[537];
    const real ball2_G_py_ball0_y = work[588];
    const real free_udot_ball0_y = work[538];
    const real free_gamma_minus_ball2_py_part = ball2_G_py_hooke0_angle1 * free_udot_hooke0_angle1 +
        ball2_G_py_hooke0_angle2 * free_udot_hooke0_angle2 + ball2_G_py_slide0 * free_udot_slide0
        + ball2_G_py_ball0_x * free_udot_ball0_x + ball2_G_py_ball0_y * free_udot_ball0_y;
    const real ball2_G_py_ball0_z = work[589];
    const real ball2_minus_G_py_hooke2_angle1 = work[590];
    const real ball2_G_py_hooke2_angle2 = work[591];
    const real ball2_minus_G_py_slide2 = work[592];
    const real free_gamma_minus_ball2_py_part_2 = free_gamma_minus_ball2_py_part
        + ball2_G_py_ball0_z * free_udot_ball0_z
        - ball2_minus_G_py_hooke2_angle1 * free_udot_hooke2_angle1
        + ball2_G_py_hooke2_angle2 * free_udot_hooke2_angle2
        - ball2_minus_G_py_slide2 * free_udot_slide2;
    const real ball2_G_pz_hooke0_angle1 = work[593];
    const real ball2_G_pz_hooke0_angle2 = work[594];
    const real ball2_G_pz_slide0 = work[595];
    const real ball2_G_pz_ball0_x = work[596];
    const real ball2_G_pz_ball0_y = work[597];
    const real free_gamma_minus_ball2_pz_part = ball2_G_pz_hooke0_angle1 * free_udot_hooke0_angle1 +
        ball2_G_pz_hooke0_angle2 * free_udot_hooke0_angle2 + ball2_G_pz_slide0 * free_udot_slide0
        + ball2_G_pz_ball0_x * free_udot_ball0_x + ball2_G_pz_ball0_y * free_udot_ball0_y;
    const real ball2_G_pz_ball0_z = work[598];
    const real ball2_minus_G_pz_hooke2_angle1 = work[599];
    const real ball2_G_pz_hooke2_angle2 = work[600];
    const real ball2_minus_G_pz_slide2 = work[601];
    const real free_gamma_minus_ball2_pz_part_2 = free_gamma_minus_ball2_pz_part
        + ball2_G_pz_ball0_z * free_udot_ball0_z
        - ball2_minus_G_pz_hooke2_angle1 * free_udot_hooke2_angle1
        + ball2_G_pz_hooke2_angle2 * free_udot_hooke2_angle2
        - ball2_minus_G_pz_slide2 * free_udot_slide2;
    const real ball3_G_px_hooke0_angle1 = work[631];
    const real ball3_G_px_hooke0_angle2 = work[632];
    const real ball3_G_px_slide0 = work[633];
    const real ball3_G_px_ball0_x = work[634];
    const real ball3_G_px_ball0_y = work[635];
    const real free_gamma_minus_ball3_px_part = ball3_G_px_hooke0_angle1 * free_udot_hooke0_angle1 +
        ball3_G_px_hooke0_angle2 * free_udot_hooke0_angle2 + ball3_G_px_slide0 * free_udot_slide0
        + ball3_G_px_ball0_x * free_udot_ball0_x + ball3_G_px_ball0_y * free_udot_ball0_y;
    const real ball3_G_px_ball0_z = work[636];
    const real ball3_minus_G_px_hooke3_angle1 = work[637];
    const real free_udot_hooke3_angle1 = work[519];
    const real ball3_G_px_hooke3_angle2 = work[638];
    const real free_udot_hooke3_angle2 = work[520];
    const real ball3_minus_G_px_slide3 = work[639];
    const real free_udot_slide3 = work[521];
    const real free_gamma_minus_ball3_px_part_2 = free_gamma_minus_ball3_px_part
        + ball3_G_px_ball0_z * free_udot_ball0_z
        - ball3_minus_G_px_hooke3_angle1 * free_udot_hooke3_angle1
        + ball3_G_px_hooke3_angle2 * free_udot_hooke3_angle2
        - ball3_minus_G_px_slide3 * free_udot_slide3;
    const real ball3_G_py_hooke0_angle1 = work[640];
    const real ball3_G_py_hooke0_angle2 = work[641];
    const real ball3_G_py_slide0 = work[642];
    const real ball3_G_py_ball0_x = work[643];
    const real ball3_G_py_ball0_y = work[644];
    const real free_gamma_minus_ball3_py_part = ball3_G_py_hooke0_angle1 * free_udot_hooke0_angle1 +
        ball3_G_py_hooke0_angle2 * free_udot_hooke0_angle2 + ball3_G_py_slide0 * free_udot_slide0
        + ball3_G_py_ball0_x * free_udot_ball0_x + ball3_G_py_ball0_y * free_udot_ball0_y;
    const real ball3_G_py_ball0_z = work[645];
    const real ball3_minus_G_py_hooke3_angle1 = work[646];
    const real ball3_G_py_hooke3_angle2 = work[647];
    const real ball3_minus_G_py_slide3 = work[648];
    const real free_gamma_minus_ball3_py_part_2 = free_gamma_minus_ball3_py_part
        + ball3_G_py_ball0_z * free_udot_ball0_z
        - ball3_minus_G_py_hooke3_angle1 * free_udot_hooke3_angle1
        + ball3_G_py_hooke3_angle2 * free_udot_hooke3_angle2
        - ball3_minus_G_py_slide3 * free_udot_slide3;
    const real ball3_G_pz_hooke0_angle1 = work[649];
    const real ball3_G_pz_hooke0_angle2 = work[650];
    const real ball3_G_pz_slide0 = work[651];
    const real ball3_G_pz_ball0_x = work[652];
    const real ball3_G_pz_ball0_y = work[653];
    const real free_gamma_minus_ball3_pz_part = ball3_G_pz_hooke0_angle1 * free_udot_hooke0_angle1 +
        ball3_G_pz_hooke0_angle2 * free_udot_hooke0_angle2 + ball3_G_pz_slide0 * free_udot_slide0
        + ball3_G_pz_ball0_x * free_udot_ball0_x + ball3_G_pz_ball0_y * free_udot_ball0_y;
    const real ball3_G_pz_ball0_z = work[654];
    const real ball3_minus_G_pz_hooke3_angle1 = work[655];
    const real ball3_G_pz_hooke3_angle2 = work[656];
    const real ball3_minus_G_pz_slide3 = work[657];
    const real free_gamma_minus_ball3_pz_part_2 = free_gamma_minus_ball3_pz_part
        + ball3_G_pz_ball0_z * free_udot_ball0_z
        - ball3_minus_G_pz_hooke3_angle1 * free_udot_hooke3_angle1
        + ball3_G_pz_hooke3_angle2 * free_udot_hooke3_angle2
        - ball3_minus_G_pz_slide3 * free_udot_slide3;
    const real ball4_G_px_hooke0_angle1 = work[555];
    const real ball4_G_px_hooke0_angle2 = work[558];
    const real ball4_G_px_slide0 = work[560];
    const real ball4_G_px_ball0_x = work[561];
    const real ball4_G_px_ball0_y = work[562];
    const real free_gamma_minus_ball4_px_part = ball4_G_px_hooke0_angle1 * free_udot_hooke0_angle1 +
        ball4_G_px_hooke0_angle2 * free_udot_hooke0_angle2 + ball4_G_px_slide0 * free_udot_slide0
        + ball4_G_px_ball0_x * free_udot_ball0_x + ball4_G_px_ball0_y * free_udot_ball0_y;
    const real ball4_G_px_ball0_z = work[563];
    const real ball4_minus_G_px_hooke4_angle1 = work[564];
    const real free_udot_hooke4_angle1 = work[522];
    const real ball4_G_px_hooke4_angle2 = work[565];
    const real free_udot_hooke4_angle2 = work[523];
    const real ball4_minus_G_px_slide4 = work[568];
    const real free_udot_slide4 = work[524];
    const real free_gamma_minus_ball4_px_part_2 = free_gamma_minus_ball4_px_part
        + ball4_G_px_ball0_z * free_udot_ball0_z
        - ball4_minus_G_px_hooke4_angle1 * free_udot_hooke4_angle1
        + ball4_G_px_hooke4_angle2 * free_udot_hooke4_angle2
        - ball4_minus_G_px_slide4 * free_udot_slide4;
    const real ball4_G_py_hooke0_angle1 = work[569];
    const real ball4_G_py_hooke0_angle2 = work[693];
    const real ball4_G_py_slide0 = work[694];
    const real ball4_G_py_ball0_x = work[695];
    const real ball4_G_py_ball0_y = work[696];
    const real free_gamma_minus_ball4_py_part = ball4_G_py_hooke0_angle1 * free_udot_hooke0_angle1 +
        ball4_G_py_hooke0_angle2 * free_udot_hooke0_angle2 + ball4_G_py_slide0 * free_udot_slide0
        + ball4_G_py_ball0_x * free_udot_ball0_x + ball4_G_py_ball0_y * free_udot_ball0_y;
    const real ball4_G_py_ball0_z = work[697];
    const real ball4_minus_G_py_hooke4_angle1 = work[698];
    const real ball4_G_py_hooke4_angle2 = work[699];
    const real ball4_minus_G_py_slide4 = work[700];
    const real free_gamma_minus_ball4_py_part_2 = free_gamma_minus_ball4_py_part
        + ball4_G_py_ball0_z * free_udot_ball0_z
        - ball4_minus_G_py_hooke4_angle1 * free_udot_hooke4_angle1
        + ball4_G_py_hooke4_angle2 * free_udot_hooke4_angle2
        - ball4_minus_G_py_slide4 * free_udot_slide4;
    const real ball4_G_pz_hooke0_angle1 = work[701];
    const real ball4_G_pz_hooke0_angle2 = work[702];
    const real ball4_G_pz_slide0 = work[703];
    const real ball4_G_pz_ball0_x = work[704];
    const real ball4_G_pz_ball0_y = work[705];
    const real free_gamma_minus_ball4_pz_part = ball4_G_pz_hooke0_angle1 * free_udot_hooke0_angle1 +
        ball4_G_pz_hooke0_angle2 * free_udot_hooke0_angle2 + ball4_G_pz_slide0 * free_udot_slide0
        + ball4_G_pz_ball0_x * free_udot_ball0_x + ball4_G_pz_ball0_y * free_udot_ball0_y;
    const real ball4_G_pz_ball0_z = work[706];
    const real ball4_minus_G_pz_hooke4_angle1 = work[707];
    const real ball4_G_pz_hooke4_angle2 = work[708];
    const real ball4_minus_G_pz_slide4 = work[709];
    const real free_gamma_minus_ball4_pz_part_2 = free_gamma_minus_ball4_pz_part
        + ball4_G_pz_ball0_z * free_udot_ball0_z
        - ball4_minus_G_pz_hooke4_angle1 * free_udot_hooke4_angle1
        + ball4_G_pz_hooke4_angle2 * free_udot_hooke4_angle2
        - ball4_minus_G_pz_slide4 * free_udot_slide4;
    const real ball5_G_px_hooke0_angle1 = work[738];
    const real ball5_G_px_hooke0_angle2 = work[739];
    const real ball5_G_px_slide0 = work[740];
    const real ball5_G_px_ball0_x = work[741];
    const real ball5_G_px_ball0_y = work[742];
    const real free_gamma_minus_ball5_px_part = ball5_G_px_hooke0_angle1 * free_udot_hooke0_angle1 +
        ball5_G_px_hooke0_angle2 * free_udot_hooke0_angle2 + ball5_G_px_slide0 * free_udot_slide0
        + ball5_G_px_ball0_x * free_udot_ball0_x + ball5_G_px_ball0_y * free_udot_ball0_y;
    const real ball5_G_px_ball0_z = work[743];
    const real ball5_minus_G_px_hooke5_angle1 = work[744];
    const real free_udot_hooke5_angle1 = work[531];
    const real ball5_G_px_hooke5_angle2 = work[745];
    const real free_udot_hooke5_angle2 = work[532];
    const real ball5_minus_G_px_slide5 = work[746];
    const real free_udot_slide5 = work[533];
    const real free_gamma_minus_ball5_px_part_2 = free_gamma_minus_ball5_px_part
        + ball5_G_px_ball0_z * free_udot_ball0_z
        - ball5_minus_G_px_hooke5_angle1 * free_udot_hooke5_angle1
        + ball5_G_px_hooke5_angle2 * free_udot_hooke5_angle2
        - ball5_minus_G_px_slide5 * free_udot_slide5;
    const real ball5_G_py_hooke0_angle1 = work[747];
    const real ball5_G_py_hooke0_angle2 = work[748];
    const real ball5_G_py_slide0 = work[749];
    const real ball5_G_py_ball0_x = work[750];
    const real ball5_G_py_ball0_y = work[751];
    const real free_gamma_minus_ball5_py_part = ball5_G_py_hooke0_angle1 * free_udot_hooke0_angle1 +
        ball5_G_py_hooke0_angle2 * free_udot_hooke0_angle2 + ball5_G_py_slide0 * free_udot_slide0
        + ball5_G_py_ball0_x * free_udot_ball0_x + ball5_G_py_ball0_y * free_udot_ball0_y;
    const real ball5_G_py_ball0_z = work[752];
    const real ball5_minus_G_py_hooke5_angle1 = work[753];
    const real ball5_G_py_hooke5_angle2 = work[754];
    const real ball5_minus_G_py_slide5 = work[755];
    const real free_gamma_minus_ball5_py_part_2 = free_gamma_minus_ball5_py_part
        + ball5_G_py_ball0_z * free_udot_ball0_z
        - ball5_minus_G_py_hooke5_angle1 * free_udot_hooke5_angle1
        + ball5_G_py_hooke5_angle2 * free_udot_hooke5_angle2
        - ball5_minus_G_py_slide5 * free_udot_slide5;
    const real ball5_G_pz_hooke0_angle1 = work[756];
    const real ball5_G_pz_hooke0_angle2 = work[757];
    const real ball5_G_pz_slide0 = work[758];
    const real ball5_G_pz_ball0_x = work[759];
    const real ball5_G_pz_ball0_y = work[760];
    const real free_gamma_minus_ball5_pz_part = ball5_G_pz_hooke0_angle1 * free_udot_hooke0_angle1 +
        ball5_G_pz_hooke0_angle2 * free_udot_hooke0_angle2 + ball5_G_pz_slide0 * free_udot_slide0
        + ball5_G_pz_ball0_x * free_udot_ball0_x + ball5_G_pz_ball0_y * free_udot_ball0_y;
    const real ball5_G_pz_ball0_z = work[761];
    const real ball5_minus_G_pz_hooke5_angle1 = work[762];
    const real ball5_G_pz_hooke5_angle2 = work[763];
    const real ball5_minus_G_pz_slide5 = work[764];
    const real free_gamma_minus_ball5_pz_part_2 = free_gamma_minus_ball5_pz_part
        + ball5_G_pz_ball0_z * free_udot_ball0_z
        - ball5_minus_G_pz_hooke5_angle1 * free_udot_hooke5_angle1
        + ball5_G_pz_hooke5_angle2 * free_udot_hooke5_angle2
        - ball5_minus_G_pz_slide5 * free_udot_slide5;
    const real ball1_rate_px_rate_part = work[390];
    const real ball1_twist_vz = work[550];
    const real ball1_R_xz_rate_part = work[515];
    const real hooke1_minus_R_zx = work[458];
    const real ball1_platform_R_zz_rate = work[509];
    const real ball1_platform_R_zz = work[433];
    const real hooke1_minus_R_zx_rate = work[463];
    const real ball1_R_xz = work[467];
    const real ball1_twist_vz_rate = work[553];
    const real free_gamma_minus_ball1_px_part_2 = work[527];
    const real free_gamma_ball1_px = -(ball1_twist_vz * (ball1_R_xz_rate_part
        - (hooke1_minus_R_zx * ball1_platform_R_zz_rate
        + ball1_platform_R_zz * hooke1_minus_R_zx_rate)) + ball1_R_xz * ball1_twist_vz_rate
        + ball1_rate_px_rate_part + free_gamma_minus_ball1_px_part_2);
    circuit_right[0] = free_gamma_ball1_px;
    const real ball1_twist_vx_times_R_yx_rate = work[391];
    const real ball1_R_yx = work[468];
    const real ball1_twist_vx_rate = work[551];
    const real ball1_twist_vy_times_R_yy_rate = work[406];
    const real ball1_R_yy = work[469];
    const real ball1_twist_vy_rate = work[552];
    const real ball1_twist_vz_times_R_yz_rate = work[407];
    const real ball1_R_yz = work[470];
    const real free_gamma_minus_ball1_py_part_2 = work[528];
    const real free_gamma_ball1_py = -(ball1_twist_vx_times_R_yx_rate
        + ball1_R_yx * ball1_twist_vx_rate + (ball1_twist_vy_times_R_yy_rate
        + ball1_R_yy * ball1_twist_vy_rate) + (ball1_twist_vz_times_R_yz_rate
        + ball1_R_yz * ball1_twist_vz_rate) + free_gamma_minus_ball1_py_part_2);
    circuit_right[1] = free_gamma_ball1_py;
    const real ball1_rate_pz_rate_part = work[410];
    const real ball1_R_zz_rate_part = work[518];
    const real hooke1_R_zz = work[459];
    const real hooke1_minus_R_zz_rate = work[464];
    const real ball1_R_zz = work[473];
    const real free_gamma_minus_ball1_pz_part_2 = work[529];
    const real free_gamma_ball1_pz = -(ball1_twist_vz * (hooke1_R_zz * ball1_platform_R_zz_rate
        - ball1_platform_R_zz * hooke1_minus_R_zz_rate + ball1_R_zz_rate_part)
        + ball1_R_zz * ball1_twist_vz_rate + ball1_rate_pz_rate_part
        + free_gamma_minus_ball1_pz_part_2);
    circuit_right[2] = free_gamma_ball1_pz;
    const real ball2_rate_px_rate_part = work[616];
    const real ball2_twist_vz = work[612];
    const real ball2_R_xz_rate_part = work[602];
    const real hooke2_minus_R_zx = work[556];
    const real hooke2_minus_R_zx_rate = work[566];
    const real ball2_R_xz = work[570];
    const real ball2_twist_vz_rate = work[615];
    const real free_gamma_ball2_px = -(ball2_twist_vz * (ball2_R_xz_rate_part
        - (hooke2_minus_R_zx * ball1_platform_R_zz_rate
        + ball1_platform_R_zz * hooke2_minus_R_zx_rate)) + ball2_R_xz * ball2_twist_vz_rate
        + ball2_rate_px_rate_part + free_gamma_minus_ball2_px_part_2);
    circuit_right[3] = free_gamma_ball2_px;
    const real ball2_twist_vx_times_R_yx_rate = work[617];
    const real ball2_R_yx = work[571];
    const real ball2_twist_vx_rate = work[613];
    const real ball2_twist_vy_times_R_yy_rate = work[618];
    const real ball2_R_yy = work[572];
    const real ball2_twist_vy_rate = work[614];
    const real ball2_twist_vz_times_R_yz_rate = work[619];
    const real ball2_R_yz = work[573];
    const real free_gamma_ball2_py = -(ball2_twist_vx_times_R_yx_rate
        + ball2_R_yx * ball2_twist_vx_rate + (ball2_twist_vy_times_R_yy_rate
        + ball2_R_yy * ball2_twist_vy_rate) + (ball2_twist_vz_times_R_yz_rate
        + ball2_R_yz * ball2_twist_vz_rate) + free_gamma_minus_ball2_py_part_2);
    circuit_right[4] = free_gamma_ball2_py;
    const real ball2_rate_pz_rate_part = work[620];
    const real ball2_R_zz_rate_part = work[603];
    const real hooke2_R_zz = work[557];
    const real hooke2_minus_R_zz_rate = work[567];
    const real ball2_R_zz = work[574];
    const real free_gamma_ball2_pz = -(ball2_twist_vz * (hooke2_R_zz * ball1_platform_R_zz_rate
        - ball1_platform_R_zz * hooke2_minus_R_zz_rate + ball2_R_zz_rate_part)
        + ball2_R_zz * ball2_twist_vz_rate + ball2_rate_pz_rate_part
        + free_gamma_minus_ball2_pz_part_2);
    circuit_right[5] = free_gamma_ball2_pz;
    const real ball3_rate_px_rate_part = work[672];
    const real ball3_twist_vz = work[668];
    const real ball3_R_xz_rate_part = work[658];
    const real hooke3_minus_R_zx = work[621];
    const real hooke3_minus_R_zx_rate = work[624];
    const real ball3_R_xz = work[626];
    const real ball3_twist_vz_rate = work[671];
    const real free_gamma_ball3_px = -(ball3_twist_vz * (ball3_R_xz_rate_part
        - (hooke3_minus_R_zx * ball1_platform_R_zz_rate
        + ball1_platform_R_zz * hooke3_minus_R_zx_rate)) + ball3_R_xz * ball3_twist_vz_rate
        + ball3_rate_px_rate_part + free_gamma_minus_ball3_px_part_2);
    circuit_right[6] = free_gamma_ball3_px;
    const real ball3_twist_vx_times_R_yx_rate = work[673];
    const real ball3_R_yx = work[627];
    const real ball3_twist_vx_rate = work[669];
    const real ball3_twist_vy_times_R_yy_rate = work[674];
    const real ball3_R_yy = work[628];
    const real ball3_twist_vy_rate = work[670];
    const real ball3_twist_vz_times_R_yz_rate = work[675];
    const real ball3_R_yz = work[629];
    const real free_gamma_ball3_py = -(ball3_twist_vx_times_R_yx_rate
        + ball3_R_yx * ball3_twist_vx_rate + (ball3_twist_vy_times_R_yy_rate
        + ball3_R_yy * ball3_twist_vy_rate) + (ball3_twist_vz_times_R_yz_rate
        + ball3_R_yz * ball3_twist_vz_rate) + free_gamma_minus_ball3_py_part_2);
    circuit_right[7] = free_gamma_ball3_py;
    const real ball3_rate_pz_rate_part = work[676];
    const real ball3_R_zz_rate_part = work[659];
    const real hooke3_R_zz = work[622];
    const real hooke3_minus_R_zz_rate = work[625];
    const real ball3_R_zz = work[630];
    const real free_gamma_ball3_pz = -(ball3_twist_vz * (hooke3_R_zz * ball1_platform_R_zz_rate
        - ball1_platform_R_zz * hooke3_minus_R_zz_rate + ball3_R_zz_rate_part)
        + ball3_R_zz * ball3_twist_vz_rate + ball3_rate_pz_rate_part
        + free_gamma_minus_ball3_pz_part_2);
    circuit_right[8] = free_gamma_ball3_pz;
    const real ball4_rate_px_rate_part = work[723];
    const real ball4_twist_vz = work[719];
    const real ball4_R_xz_rate_part = work[710];
    const real hooke4_minus_R_zx = work[679];
    const real hooke4_minus_R_zx_rate = work[689];
    const real ball4_R_xz = work[398];
    const real ball4_twist_vz_rate = work[722];
    const real free_gamma_ball4_px = -(ball4_twist_vz * (ball4_R_xz_rate_part
        - (hooke4_minus_R_zx * ball1_platform_R_zz_rate
        + ball1_platform_R_zz * hooke4_minus_R_zx_rate)) + ball4_R_xz * ball4_twist_vz_rate
        + ball4_rate_px_rate_part + free_gamma_minus_ball4_px_part_2);
    circuit_right[9] = free_gamma_ball4_px;
    const real ball4_twist_vx_times_R_yx_rate = work[724];
    const real ball4_R_yx = work[399];
    const real ball4_twist_vx_rate = work[720];
    const real ball4_twist_vy_times_R_yy_rate = work[725];
    const real ball4_R_yy = work[402];
    const real ball4_twist_vy_rate = work[721];
    const real ball4_twist_vz_times_R_yz_rate = work[726];
    const real ball4_R_yz = work[403];
    const real free_gamma_ball4_py = -(ball4_twist_vx_times_R_yx_rate
        + ball4_R_yx * ball4_twist_vx_rate + (ball4_twist_vy_times_R_yy_rate
        + ball4_R_yy * ball4_twist_vy_rate) + (ball4_twist_vz_times_R_yz_rate
        + ball4_R_yz * ball4_twist_vz_rate) + free_gamma_minus_ball4_py_part_2);
    circuit_right[10] = free_gamma_ball4_py;
    const real ball4_rate_pz_rate_part = work[727];
    const real ball4_R_zz_rate_part = work[711];
    const real hooke4_R_zz = work[680];
    const real hooke4_minus_R_zz_rate = work[690];
    const real ball4_R_zz = work[554];
    const real free_gamma_ball4_pz = -(ball4_twist_vz * (hooke4_R_zz * ball1_platform_R_zz_rate
        - ball1_platform_R_zz * hooke4_minus_R_zz_rate + ball4_R_zz_rate_part)
        + ball4_R_zz * ball4_twist_vz_rate + ball4_rate_pz_rate_part
        + free_gamma_minus_ball4_pz_part_2);
    circuit_right[11] = free_gamma_ball4_pz;
    const real ball5_rate_px_rate_part = work[778];
    const real ball5_twist_vz = work[774];
    const real ball5_R_xz_rate_part = work[765];
    const real hooke5_minus_R_zx = work[728];
    const real hooke5_minus_R_zx_rate = work[731];
    const real ball5_R_xz = work[733];
    const real ball5_twist_vz_rate = work[777];
    const real free_gamma_ball5_px = -(ball5_twist_vz * (ball5_R_xz_rate_part
        - (hooke5_minus_R_zx * ball1_platform_R_zz_rate
        + ball1_platform_R_zz * hooke5_minus_R_zx_rate)) + ball5_R_xz * ball5_twist_vz_rate
        + ball5_rate_px_rate_part + free_gamma_minus_ball5_px_part_2);
    circuit_right[12] = free_gamma_ball5_px;
    const real ball5_twist_vx_times_R_yx_rate = work[779];
    const real ball5_R_yx = work[734];
    const real ball5_twist_vx_rate = work[775];
    const real ball5_twist_vy_times_R_yy_rate = work[780];
    const real ball5_R_yy = work[735];
    const real ball5_twist_vy_rate = work[776];
    const real ball5_twist_vz_times_R_yz_rate = work[781];
    const real ball5_R_yz = work[736];
    const real free_gamma_ball5_py = -(ball5_twist_vx_times_R_yx_rate
        + ball5_R_yx * ball5_twist_vx_rate + (ball5_twist_vy_times_R_yy_rate
        + ball5_R_yy * ball5_twist_vy_rate) + (ball5_twist_vz_times_R_yz_rate
        + ball5_R_yz * ball5_twist_vz_rate) + free_gamma_minus_ball5_py_part_2);
    circuit_right[13] = free_gamma_ball5_py;
    const real ball5_rate_pz_rate_part = work[782];
    const real ball5_R_zz_rate_part = work[766];
    const real hooke5_R_zz = work[729];
    const real hooke5_minus_R_zz_rate = work[732];
    const real ball5_R_zz = work[737];
    const real free_gamma_ball5_pz = -(ball5_twist_vz * (hooke5_R_zz * ball1_platform_R_zz_rate
        - ball1_platform_R_zz * hooke5_minus_R_zz_rate + ball5_R_zz_rate_part)
        + ball5_R_zz * ball5_twist_vz_rate + ball5_rate_pz_rate_part
        + free_gamma_minus_ball5_pz_part_2);
    circuit_right[14] = free_gamma_ball5_pz;
    /* circuit_matrix lam = circuit_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 15, 1, circuit_matrix[0], circuit_right, circuit_scratch);

    /* ball1: multiplier px, multiplier py, multiplier pz */
    const real ball1_multiplier_px = circuit_right[0];
    const real ball1_multiplier_py = circuit_right[1];
    const real ball1_multiplier_pz = circuit_right[2];

    /* ball2: multiplier px, multiplier py, multiplier pz */
    const real ball2_multiplier_px = circuit_right[3];
    const real ball2_multiplier_py = circuit_right[4];
    const real ball2_multiplier_pz = circuit_right[5];

    /* ball3: multiplier px, multiplier py, multiplier pz */
    const real ball3_multiplier_px = circuit_right[6];
    const real ball3_multiplier_py = circuit_right[7];
    const real ball3_multiplier_pz = circuit_right[8];

    /* ball4: multiplier px, multiplier py, multiplier pz */
    const real ball4_multiplier_px = circuit_right[9];
    const real ball4_multiplier_py = circuit_right[10];
    const real ball4_multiplier_pz = circuit_right[11];

    /* ball5: multiplier px, multiplier py, multiplier pz */
    const real ball5_multiplier_px = circuit_right[12];
    const real ball5_multiplier_py = circuit_right[13];
    const real ball5_multiplier_pz = circuit_right[14];

    /* constraints: multipliers */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const real ball1_px_response_hooke0_angle1 = work[543];
    const real ball1_py_response_hooke0_angle1 = work[686];
    const real ball1_pz_response_hooke0_angle1 = work[805];
    const real ball2_px_response_hooke0_angle1 = work[814];
    const real hooke0_udot_angle1_part = ball1_px_response_hooke0_angle1 * ball1_multiplier_px
        + ball1_py_response_hooke0_angle1 * ball1_multiplier_py
        + ball1_pz_response_hooke0_angle1 * ball1_multiplier_pz
        + ball2_px_response_hooke0_angle1 * ball2_multiplier_px;
    const real ball2_py_response_hooke0_angle1 = work[823];
    const real ball2_pz_response_hooke0_angle1 = work[832];
    const real ball3_px_response_hooke0_angle1 = work[841];
    const real ball3_py_response_hooke0_angle1 = work[850];
    const real hooke0_udot_angle1_part_2 = hooke0_udot_angle1_part
        + ball2_py_response_hooke0_angle1 * ball2_multiplier_py
        + ball2_pz_response_hooke0_angle1 * ball2_multiplier_pz
        + ball3_px_response_hooke0_angle1 * ball3_multiplier_px
        + ball3_py_response_hooke0_angle1 * ball3_multiplier_py;
    const real ball3_pz_response_hooke0_angle1 = work[860];
    const real ball4_px_response_hooke0_angle1 = work[394];
    const real ball4_py_response_hooke0_angle1 = work[409];
    const real ball4_pz_response_hooke0_angle1 = work[421];
    const real hooke0_udot_angle1_part_3 = hooke0_udot_angle1_part_2
        + ball3_pz_response_hooke0_angle1 * ball3_multiplier_pz
        + ball4_px_response_hooke0_angle1 * ball4_multiplier_px
        + ball4_py_response_hooke0_angle1 * ball4_multiplier_py
        + ball4_pz_response_hooke0_angle1 * ball4_multiplier_pz;
    const real ball1_px_response_hooke0_angle2 = work[678];
    const real ball1_py_response_hooke0_angle2 = work[692];
    const real ball1_pz_response_hooke0_angle2 = work[809];
    const real ball2_px_response_hooke0_angle2 = work[818];
    const real hooke0_udot_angle2_part = ball1_px_response_hooke0_angle2 * ball1_multiplier_px
        + ball1_py_response_hooke0_angle2 * ball1_multiplier_py
        + ball1_pz_response_hooke0_angle2 * ball1_multiplier_pz
        + ball2_px_response_hooke0_angle2 * ball2_multiplier_px;
    const real ball2_py_response_hooke0_angle2 = work[827];
    const real ball2_pz_response_hooke0_angle2 = work[836];
    const real ball3_px_response_hooke0_angle2 = work[845];
    const real ball3_py_response_hooke0_angle2 = work[854];
    const real hooke0_udot_angle2_part_2 = hooke0_udot_angle2_part
        + ball2_py_response_hooke0_angle2 * ball2_multiplier_py
        + ball2_pz_response_hooke0_angle2 * ball2_multiplier_pz
        + ball3_px_response_hooke0_angle2 * ball3_multiplier_px
        + ball3_py_response_hooke0_angle2 * ball3_multiplier_py;
    const real ball3_pz_response_hooke0_angle2 = work[864];
    const real ball4_px_response_hooke0_angle2 = work[400];
    const real ball4_py_response_hooke0_angle2 = work[416];
    const real ball4_pz_response_hooke0_angle2 = work[428];
    const real hooke0_udot_angle2_part_3 = hooke0_udot_angle2_part_2
        + ball3_pz_response_hooke0_angle2 * ball3_multiplier_pz
        + ball4_px_response_hooke0_angle2 * ball4_multiplier_px
        + ball4_py_response_hooke0_angle2 * ball4_multiplier_py
        + ball4_pz_response_hooke0_angle2 * ball4_multiplier_pz;
    const real ball1_px_response_slide0 = work[681];
    const real ball1_py_response_slide0 = work[801];
    const real ball1_pz_response_slide0 = work[810];
    const real ball2_px_response_slide0 = work[819];
    const real ball2_py_response_slide0 = work[828];
    const real slide0_udot_part = ball1_px_response_slide0 * ball1_multiplier_px
        + ball1_py_response_slide0 * ball1_multiplier_py
        + ball1_pz_response_slide0 * ball1_multiplier_pz
        + ball2_px_response_slide0 * ball2_multiplier_px
        + ball2_py_response_slide0 * ball2_multiplier_py;
    const real ball2_pz_response_slide0 = work[837];
    const real ball3_px_response_slide0 = work[846];
    const real ball3_py_response_slide0 = work[855];
    const real ball3_pz_response_slide0 = work[865];
    const real ball4_px_response_slide0 = work[401];
    const real slide0_udot_part_2 = slide0_udot_part
        + ball2_pz_response_slide0 * ball2_multiplier_pz
        + ball3_px_response_slide0 * ball3_multiplier_px
        + ball3_py_response_slide0 * ball3_multiplier_py
        + ball3_pz_response_slide0 * ball3_multiplier_pz
        + ball4_px_response_slide0 * ball4_multiplier_px;
    const real ball4_py_response_slide0 = work[417];
    const real ball4_pz_response_slide0 = work[429];
    const real ball5_px_response_slide0 = work[454];
    const real ball5_py_response_slide0 = work[471];
    const real ball5_pz_response_slide0 = work[516];
    const real slide0_udot_part_3 = slide0_udot_part_2
        + ball4_py_response_slide0 * ball4_multiplier_py
        + ball4_pz_response_slide0 * ball4_multiplier_pz
        + ball5_px_response_slide0 * ball5_multiplier_px
        + ball5_py_response_slide0 * ball5_multiplier_py
        + ball5_pz_response_slide0 * ball5_multiplier_pz;
    const real ball1_px_response_ball0_x = work[683];
    const real ball1_py_response_ball0_x = work[802];
    const real ball1_pz_response_ball0_x = work[811];
    const real ball2_px_response_ball0_x = work[820];
    const real ball2_py_response_ball0_x = work[829];
    const real ball0_udot_x_part = ball1_px_response_ball0_x * ball1_multiplier_px
        + ball1_py_response_ball0_x * ball1_multiplier_py
        + ball1_pz_response_ball0_x * ball1_multiplier_pz
        + ball2_px_response_ball0_x * ball2_multiplier_px
        + ball2_py_response_ball0_x * ball2_multiplier_py;
    const real ball2_pz_response_ball0_x = work[838];
    const real ball3_px_response_ball0_x = work[847];
    const real ball3_py_response_ball0_x = work[856];
    const real ball3_pz_response_ball0_x = work[866];
    const real ball4_px_response_ball0_x = work[404];
    const real ball0_udot_x_part_2 = ball0_udot_x_part
        + ball2_pz_response_ball0_x * ball2_multiplier_pz
        + ball3_px_response_ball0_x * ball3_multiplier_px
        + ball3_py_response_ball0_x * ball3_multiplier_py
        + ball3_pz_response_ball0_x * ball3_multiplier_pz
        + ball4_px_response_ball0_x * ball4_multiplier_px;
    const real ball4_py_response_ball0_x = work[418];
    const real ball4_pz_response_ball0_x = work[430];
    const real ball5_px_response_ball0_x = work[455];
    const real ball5_py_response_ball0_x = work[472];
    const real ball5_pz_response_ball0_x = work[517];
    const real ball0_udot_x_part_3 = ball0_udot_x_part_2
        + ball4_py_response_ball0_x * ball4_multiplier_py
        + ball4_pz_response_ball0_x * ball4_multiplier_pz
        + ball5_px_response_ball0_x * ball5_multiplier_px
        + ball5_py_response_ball0_x * ball5_multiplier_py
        + ball5_pz_response_ball0_x * ball5_multiplier_pz;
    const real ball1_px_response_ball0_y = work[684];
    const real ball1_py_response_ball0_y = work[803];
    const real ball1_pz_response_ball0_y = work[812];
    const real ball2_px_response_ball0_y = work[821];
    const real ball2_py_response_ball0_y = work[830];
    const real ball0_udot_y_part = ball1_px_response_ball0_y * ball1_multiplier_px
        + ball1_py_response_ball0_y * ball1_multiplier_py
        + ball1_pz_response_ball0_y * ball1_multiplier_pz
        + ball2_px_response_ball0_y * ball2_multiplier_px
        + ball2_py_response_ball0_y * ball2_multiplier_py;
    const real ball2_pz_response_ball0_y = work[839];
    const real ball3_px_response_ball0_y = work[848];
    const real ball3_py_response_ball0_y = work[857];
    const real ball3_pz_response_ball0_y = work[392];
    const real ball4_px_response_ball0_y = work[405];
    const real ball0_udot_y_part_2 = ball0_udot_y_part
        + ball2_pz_response_ball0_y * ball2_multiplier_pz
        + ball3_px_response_ball0_y * ball3_multiplier_px
        + ball3_py_response_ball0_y * ball3_multiplier_py
        + ball3_pz_response_ball0_y * ball3_multiplier_pz
        + ball4_px_response_ball0_y * ball4_multiplier_px;
    const real ball4_py_response_ball0_y = work[419];
    const real ball4_pz_response_ball0_y = work[431];
    const real ball5_px_response_ball0_y = work[456];
    const real ball5_py_response_ball0_y = work[504];
    const real ball5_pz_response_ball0_y = work[525];
    const real ball0_udot_y_part_3 = ball0_udot_y_part_2
        + ball4_py_response_ball0_y * ball4_multiplier_py
        + ball4_pz_response_ball0_y * ball4_multiplier_pz
        + ball5_px_response_ball0_y * ball5_multiplier_px
        + ball5_py_response_ball0_y * ball5_multiplier_py
        + ball5_pz_response_ball0_y * ball5_multiplier_pz;
    const real ball1_px_response_ball0_z = work[685];
    const real ball1_py_response_ball0_z = work[804];
    const real ball1_pz_response_ball0_z = work[813];
    const real ball2_px_response_ball0_z = work[822];
    const real ball2_py_response_ball0_z = work[831];
    const real ball0_udot_z_part = ball1_px_response_ball0_z * ball1_multiplier_px
        + ball1_py_response_ball0_z * ball1_multiplier_py
        + ball1_pz_response_ball0_z * ball1_multiplier_pz
        + ball2_px_response_ball0_z * ball2_multiplier_px
        + ball2_py_response_ball0_z * ball2_multiplier_py;
    const real ball2_pz_response_ball0_z = work[840];
    const real ball3_px_response_ball0_z = work[849];
    const real ball3_py_response_ball0_z = work[858];
    const real ball3_pz_response_ball0_z = work[393];
    const real ball4_px_response_ball0_z = work[408];
    const real ball0_udot_z_part_2 = ball0_udot_z_part
        + ball2_pz_response_ball0_z * ball2_multiplier_pz
        + ball3_px_response_ball0_z * ball3_multiplier_px
        + ball3_py_response_ball0_z * ball3_multiplier_py
        + ball3_pz_response_ball0_z * ball3_multiplier_pz
        + ball4_px_response_ball0_z * ball4_multiplier_px;
    const real ball4_py_response_ball0_z = work[420];
    const real ball4_pz_response_ball0_z = work[432];
    const real ball5_px_response_ball0_z = work[457];
    const real ball5_py_response_ball0_z = work[505];
    const real ball5_pz_response_ball0_z = work[526];
    const real ball0_udot_z_part_3 = ball0_udot_z_part_2
        + ball4_py_response_ball0_z * ball4_multiplier_py
        + ball4_pz_response_ball0_z * ball4_multiplier_pz
        + ball5_px_response_ball0_z * ball5_multiplier_px
        + ball5_py_response_ball0_z * ball5_multiplier_py
        + ball5_pz_response_ball0_z * ball5_multiplier_pz;

    /* hooke0: udot */
    /* udot = free_udot + response multipliers */
    const real ball5_px_response_hooke0_angle1 = work[449];
    const real ball5_py_response_hooke0_angle1 = work[460];
    const real ball5_pz_response_hooke0_angle1 = work[506];
    const real ball5_px_response_hooke0_angle2 = work[453];
    const real ball5_py_response_hooke0_angle2 = work[466];
    const real ball5_pz_response_hooke0_angle2 = work[514];
    /* udot: hooke0.u.angle1dot [rad/s^2] */
    out[0] = hooke0_udot_angle1_part_3 + ball5_px_response_hooke0_angle1 * ball5_multiplier_px
        + ball5_py_response_hooke0_angle1 * ball5_multiplier_py
        + ball5_pz_response_hooke0_angle1 * ball5_multiplier_pz + free_udot_hooke0_angle1;
    /* udot: hooke0.u.angle2dot [rad/s^2] */
    out[1] = hooke0_udot_angle2_part_3 + ball5_px_response_hooke0_angle2 * ball5_multiplier_px
        + ball5_py_response_hooke0_angle2 * ball5_multiplier_py
        + ball5_pz_response_hooke0_angle2 * ball5_multiplier_pz + free_udot_hooke0_angle2;

    /* slide0: udot */
    /* udot = free_udot + response multipliers */
    out[2] = free_udot_slide0 + slide0_udot_part_3; /* udot: slide0.udot [m/s^2] */

    /* ball0: udot */
    /* udot = free_udot + response multipliers */
    out[3] = free_udot_ball0_x + ball0_udot_x_part_3; /* udot: ball0.u.xdot [rad/s^2] */
    out[4] = free_udot_ball0_y + ball0_udot_y_part_3; /* udot: ball0.u.ydot [rad/s^2] */
    out[5] = free_udot_ball0_z + ball0_udot_z_part_3; /* udot: ball0.u.zdot [rad/s^2] */

    /* hooke1: udot */
    /* udot = free_udot + response multipliers */
    const real free_udot_hooke1_angle1 = work[501];
    const real ball1_px_minus_response_hooke1_angle1 = work[607];
    const real ball1_py_minus_response_hooke1_angle1 = work[687];
    const real ball1_pz_minus_response_hooke1_angle1 = work[806];
    const real free_udot_hooke1_angle2 = work[502];
    const real ball1_px_response_hooke1_angle2 = work[663];
    const real ball1_py_response_hooke1_angle2 = work[688];
    const real ball1_pz_response_hooke1_angle2 = work[807];
    /* udot: hooke1.u.angle1dot [rad/s^2] */
    out[6] = free_udot_hooke1_angle1
        - (ball1_px_minus_response_hooke1_angle1 * ball1_multiplier_px
        + ball1_py_minus_response_hooke1_angle1 * ball1_multiplier_py
        + ball1_pz_minus_response_hooke1_angle1 * ball1_multiplier_pz);
    /* udot: hooke1.u.angle2dot [rad/s^2] */
    out[7] = ball1_px_response_hooke1_angle2 * ball1_multiplier_px
        + ball1_py_response_hooke1_angle2 * ball1_multiplier_py
        + ball1_pz_response_hooke1_angle2 * ball1_multiplier_pz + free_udot_hooke1_angle2;

    /* slide1: udot */
    /* udot = free_udot + response multipliers */
    const real free_udot_slide1 = work[503];
    const real ball1_px_minus_response_slide1 = work[677];
    const real ball1_py_minus_response_slide1 = work[691];
    const real ball1_pz_minus_response_slide1 = work[808];
    /* udot: slide1.udot [m/s^2] */
    out[8] = free_udot_slide1 - (ball1_px_minus_response_slide1 * ball1_multiplier_px
        + ball1_py_minus_response_slide1 * ball1_multiplier_py
        + ball1_pz_minus_response_slide1 * ball1_multiplier_pz);

    /* hooke2: udot */
    /* udot = free_udot + response multipliers */
    const real ball2_px_minus_response_hooke2_angle1 = work[815];
    const real ball2_py_minus_response_hooke2_angle1 = work[824];
    const real ball2_pz_minus_response_hooke2_angle1 = work[833];
    const real ball2_px_response_hooke2_angle2 = work[816];
    const real ball2_py_response_hooke2_angle2 = work[825];
    const real ball2_pz_response_hooke2_angle2 = work[834];
    /* udot: hooke2.u.angle1dot [rad/s^2] */
    out[9] = free_udot_hooke2_angle1
        - (ball2_px_minus_response_hooke2_angle1 * ball2_multiplier_px
        + ball2_py_minus_response_hooke2_angle1 * ball2_multiplier_py
        + ball2_pz_minus_response_hooke2_angle1 * ball2_multiplier_pz);
    /* udot: hooke2.u.angle2dot [rad/s^2] */
    out[10] = ball2_px_response_hooke2_angle2 * ball2_multiplier_px
        + ball2_py_response_hooke2_angle2 * ball2_multiplier_py
        + ball2_pz_response_hooke2_angle2 * ball2_multiplier_pz + free_udot_hooke2_angle2;

    /* slide2: udot */
    /* udot = free_udot + response multipliers */
    const real ball2_px_minus_response_slide2 = work[817];
    const real ball2_py_minus_response_slide2 = work[826];
    const real ball2_pz_minus_response_slide2 = work[835];
    /* udot: slide2.udot [m/s^2] */
    out[11] = free_udot_slide2 - (ball2_px_minus_response_slide2 * ball2_multiplier_px
        + ball2_py_minus_response_slide2 * ball2_multiplier_py
        + ball2_pz_minus_response_slide2 * ball2_multiplier_pz);

    /* hooke3: udot */
    /* udot = free_udot + response multipliers */
    const real ball3_px_minus_response_hooke3_angle1 = work[842];
    const real ball3_py_minus_response_hooke3_angle1 = work[851];
    const real ball3_pz_minus_response_hooke3_angle1 = work[861];
    const real ball3_px_response_hooke3_angle2 = work[843];
    const real ball3_py_response_hooke3_angle2 = work[852];
    const real ball3_pz_response_hooke3_angle2 = work[862];
    /* udot: hooke3.u.angle1dot [rad/s^2] */
    out[12] = free_udot_hooke3_angle1
        - (ball3_px_minus_response_hooke3_angle1 * ball3_multiplier_px
        + ball3_py_minus_response_hooke3_angle1 * ball3_multiplier_py
        + ball3_pz_minus_response_hooke3_angle1 * ball3_multiplier_pz);
    /* udot: hooke3.u.angle2dot [rad/s^2] */
    out[13] = ball3_px_response_hooke3_angle2 * ball3_multiplier_px
        + ball3_py_response_hooke3_angle2 * ball3_multiplier_py
        + ball3_pz_response_hooke3_angle2 * ball3_multiplier_pz + free_udot_hooke3_angle2;

    /* slide3: udot */
    /* udot = free_udot + response multipliers */
    const real ball3_px_minus_response_slide3 = work[844];
    const real ball3_py_minus_response_slide3 = work[853];
    const real ball3_pz_minus_response_slide3 = work[863];
    /* udot: slide3.udot [m/s^2] */
    out[14] = free_udot_slide3 - (ball3_px_minus_response_slide3 * ball3_multiplier_px
        + ball3_py_minus_response_slide3 * ball3_multiplier_py
        + ball3_pz_minus_response_slide3 * ball3_multiplier_pz);

    /* hooke4: udot */
    /* udot = free_udot + response multipliers */
    const real ball4_px_minus_response_hooke4_angle1 = work[395];
    const real ball4_py_minus_response_hooke4_angle1 = work[412];
    const real ball4_pz_minus_response_hooke4_angle1 = work[422];
    const real ball4_px_response_hooke4_angle2 = work[396];
    const real ball4_py_response_hooke4_angle2 = work[413];
    const real ball4_pz_response_hooke4_angle2 = work[423];
    /* udot: hooke4.u.angle1dot [rad/s^2] */
    out[15] = free_udot_hooke4_angle1
        - (ball4_px_minus_response_hooke4_angle1 * ball4_multiplier_px
        + ball4_py_minus_response_hooke4_angle1 * ball4_multiplier_py
        + ball4_pz_minus_response_hooke4_angle1 * ball4_multiplier_pz);
    /* udot: hooke4.u.angle2dot [rad/s^2] */
    out[16] = ball4_px_response_hooke4_angle2 * ball4_multiplier_px
        + ball4_py_response_hooke4_angle2 * ball4_multiplier_py
        + ball4_pz_response_hooke4_angle2 * ball4_multiplier_pz + free_udot_hooke4_angle2;

    /* slide4: udot */
    /* udot = free_udot + response multipliers */
    const real ball4_px_minus_response_slide4 = work[397];
    const real ball4_py_minus_response_slide4 = work[415];
    const real ball4_pz_minus_response_slide4 = work[424];
    /* udot: slide4.udot [m/s^2] */
    out[17] = free_udot_slide4 - (ball4_px_minus_response_slide4 * ball4_multiplier_px
        + ball4_py_minus_response_slide4 * ball4_multiplier_py
        + ball4_pz_minus_response_slide4 * ball4_multiplier_pz);

    /* hooke5: udot */
    /* udot = free_udot + response multipliers */
    const real ball5_px_minus_response_hooke5_angle1 = work[450];
    const real ball5_py_minus_response_hooke5_angle1 = work[461];
    const real ball5_pz_minus_response_hooke5_angle1 = work[507];
    const real ball5_px_response_hooke5_angle2 = work[451];
    const real ball5_py_response_hooke5_angle2 = work[462];
    const real ball5_pz_response_hooke5_angle2 = work[508];
    /* udot: hooke5.u.angle1dot [rad/s^2] */
    out[18] = free_udot_hooke5_angle1
        - (ball5_px_minus_response_hooke5_angle1 * ball5_multiplier_px
        + ball5_py_minus_response_hooke5_angle1 * ball5_multiplier_py
        + ball5_pz_minus_response_hooke5_angle1 * ball5_multiplier_pz);
    /* udot: hooke5.u.angle2dot [rad/s^2] */
    out[19] = ball5_px_response_hooke5_angle2 * ball5_multiplier_px
        + ball5_py_response_hooke5_angle2 * ball5_multiplier_py
        + ball5_pz_response_hooke5_angle2 * ball5_multiplier_pz + free_udot_hooke5_angle2;

    /* slide5: udot */
    /* udot = free_udot + response multipliers */
    const real ball5_px_minus_response_slide5 = work[452];
    const real ball5_py_minus_response_slide5 = work[465];
    const real ball5_pz_minus_response_slide5 = work[513];
    /* udot: slide5.udot [m/s^2] */
    out[20] = free_udot_slide5 - (ball5_px_minus_response_slide5 * ball5_multiplier_px
        + ball5_py_minus_response_slide5 * ball5_multiplier_py
        + ball5_pz_minus_response_slide5 * ball5_multiplier_pz);
    return status;
}

/* udot with M udot + h = f + tau */
CARDAN_API int forward_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    int status = CARDAN_OK;
    status |= forward_dynamics_part1(in, out, work);
    status |= forward_dynamics_part2(in, out, work);
    status |= forward_dynamics_part3(in, out, work);
    status |= forward_dynamics_part4(in, out, work);
    status |= forward_dynamics_part5(in, out, work);
    status |= forward_dynamics_part6(in, out, work);
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {21, 867, 107, 0, 22, 21, 0, 0, 6, 96, 0, 0, 0, 0, 21, 0, 0, 0, 0, 0};
#endif
