/*
 * forward_dynamics of stewart_platform
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: origins, base_parameters
 * passes: unroll
 *
 * Sizes: out 21, work 847, w 107
 * Operations per call: 8086 = 4527 mul, 2359 add, 1147 sub, 15 neg, 13 div, 12 cos, 12 sin, 1 solve
 * Operations of prepare: 272 = 123 add, 89 mul, 52 sub, 8 div
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
    w[3] = tube0_first_moment_z; /* tube0_first_moment_z */
    w[73] = tube0_inertia_zz + rod0_inertia_zz; /* tube0_base_inertia_zz */

    /* rod0: first moment, mass, inertia, base mass, base moment */
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
    const wreal rod0_mass_4 = rod0_inertia_xx_2 + rod0_mass_3;
    const wreal rod0_mass_5 = rod0_inertia_yy_2 + rod0_mass_3;
    const wreal rod0_base_mass = rod0_mass + platform_mass;
    w[69] = rod0_base_mass; /* rod0_base_mass */
    /* rod0_base_moment_z */
    w[70] = rod0_first_moment_z + slide0_position_z * rod0_mass + slide0_position_z * platform_mass;

    /* ball0: momentum fz, momentum fx */
    const wreal ball0_child_position_x = p[14]; /* m */
    const wreal ball0_child_position_y = p[15]; /* m */
    const wreal ball0_momentum_fz = ball0_child_position_x * platform_mass;
    const wreal ball0_momentum_fx = ball0_child_position_y * platform_mass;
    w[5] = ball0_momentum_fz; /* ball0_momentum_fz */
    w[6] = ball0_momentum_fx; /* ball0_momentum_fx */

    /* platform: first moment, mass, base second moment, inertia, base */
    const wreal platform_com_z = p[17]; /* m */
    const wreal platform_inertia_xx = p[18]; /* kg m^2 */
    const wreal platform_inertia_yy = p[19]; /* kg m^2 */
    const wreal platform_inertia_zz = p[20]; /* kg m^2 */
    const wreal platform_first_moment_z = platform_mass * platform_com_z;
    const wreal platform_mass_2 = ball0_child_position_x * ball0_momentum_fz;
    const wreal platform_mass_3 = ball0_child_position_y * ball0_momentum_fx;
    const wreal platform_mass_4 = platform_com_z * platform_first_moment_z;
    const wreal platform_base_second_moment_xy = ball0_child_position_y * ball0_momentum_fz;
    const wreal platform_inertia_xz = platform_com_z * ball0_momentum_fz;
    const wreal platform_inertia_yz = platform_com_z * ball0_momentum_fx;
    const wreal platform_inertia_xx_2 = platform_mass_3 + platform_mass_4 + platform_inertia_xx;
    const wreal platform_inertia_yy_2 = platform_mass_2 + platform_mass_4 + platform_inertia_yy;
    const wreal platform_inertia_zz_2 = platform_mass_2 + platform_mass_3 + platform_inertia_zz;
    const wreal platform_base = 0.5 * platform_mass * slide0_position_z * slide0_position_z;
    const wreal platform_base_2 = 2.0 * platform_base;
    w[7] = platform_first_moment_z; /* platform_first_moment_z */
    w[8] = platform_base_second_moment_xy; /* platform_base_second_moment_xy */
    w[9] = platform_inertia_xz; /* platform_inertia_xz */
    w[10] = platform_inertia_yz; /* platform_inertia_yz */
    w[11] = platform_inertia_xx_2; /* platform_inertia_xx_2 */
    w[12] = platform_inertia_yy_2; /* platform_inertia_yy_2 */
    w[13] = platform_inertia_zz_2; /* platform_inertia_zz_2 */

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
    w[16] = tube1_first_moment_z; /* tube1_first_moment_z */
    w[68] = tube1_inertia_zz + rod1_inertia_zz; /* tube1_base_inertia_zz */

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
    w[45] = rod1_first_moment_z + slide1_position_z * rod1_mass; /* rod1_base_moment_z */

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
    w[20] = tube2_first_moment_z; /* tube2_first_moment_z */
    w[65] = tube2_inertia_zz + rod2_inertia_zz; /* tube2_base_inertia_zz */

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
    w[47] = rod2_first_moment_z + slide2_position_z * rod2_mass; /* rod2_base_moment_z */

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
    w[24] = tube3_first_moment_z; /* tube3_first_moment_z */
    w[62] = tube3_inertia_zz + rod3_inertia_zz; /* tube3_base_inertia_zz */

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
    w[49] = rod3_first_moment_z + slide3_position_z * rod3_mass; /* rod3_base_moment_z */

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
    w[28] = tube4_first_moment_z; /* tube4_first_moment_z */
    w[59] = tube4_inertia_zz + rod4_inertia_zz; /* tube4_base_inertia_zz */

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
    w[51] = rod4_first_moment_z + slide4_position_z * rod4_mass; /* rod4_base_moment_z */

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
    w[32] = tube5_first_moment_z; /* tube5_first_moment_z */
    w[56] = tube5_inertia_zz + rod5_inertia_zz; /* tube5_base_inertia_zz */

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
    w[53] = rod5_first_moment_z + slide5_position_z * rod5_mass; /* rod5_base_moment_z */

    /* ball1: placement */
    const wreal ball1_child_position_x = p[86]; /* m */
    const wreal ball1_child_position_y = p[87]; /* m */
    w[34] = ball1_child_position_x - ball0_child_position_x; /* ball1_placement */
    w[35] = ball1_child_position_y - ball0_child_position_y; /* ball1_placement_2 */

    /* ball2: placement */
    const wreal ball2_child_position_x = p[88]; /* m */
    const wreal ball2_child_position_y = p[89]; /* m */
    w[36] = ball2_child_position_x - ball0_child_position_x; /* ball2_placement */
    w[37] = ball2_child_position_y - ball0_child_position_y; /* ball2_placement_2 */

    /* ball3: placement */
    const wreal ball3_child_position_x = p[90]; /* m */
    const wreal ball3_child_position_y = p[91]; /* m */
    w[38] = ball3_child_position_x - ball0_child_position_x; /* ball3_placement */
    w[39] = ball3_child_position_y - ball0_child_position_y; /* ball3_placement_2 */

    /* ball4: placement */
    const wreal ball4_child_position_x = p[92]; /* m */
    const wreal ball4_child_position_y = p[93]; /* m */
    w[40] = ball4_child_position_x - ball0_child_position_x; /* ball4_placement */
    w[41] = ball4_child_position_y - ball0_child_position_y; /* ball4_placement_2 */

    /* ball5: placement */
    const wreal ball5_child_position_x = p[94]; /* m */
    const wreal ball5_child_position_y = p[95]; /* m */
    w[42] = ball5_child_position_x - ball0_child_position_x; /* ball5_placement */
    w[43] = ball5_child_position_y - ball0_child_position_y; /* ball5_placement_2 */

    /* shared by several: inertia */
    const wreal tube1_inertia = 0.5 * rod1_mass;
    const wreal tube2_inertia = 0.5 * rod2_mass;
    const wreal tube3_inertia = 0.5 * rod3_mass;
    const wreal tube4_inertia = 0.5 * rod4_mass;
    const wreal tube5_inertia = 0.5 * rod5_mass;
    w[44] = tube1_inertia; /* tube1_inertia */
    w[46] = tube2_inertia; /* tube2_inertia */
    w[48] = tube3_inertia; /* tube3_inertia */
    w[50] = tube4_inertia; /* tube4_inertia */
    w[52] = tube5_inertia; /* tube5_inertia */

    /* rod1: mass */
    const wreal rod1_mass_3 = slide1_position_z * (rod1_first_moment_z
        + slide1_position_z * tube1_inertia) * 2.0;
    const wreal rod1_mass_4 = rod1_inertia_xx_2 + rod1_mass_3;
    const wreal rod1_mass_5 = rod1_inertia_yy_2 + rod1_mass_3;

    /* rod2: mass */
    const wreal rod2_mass_3 = slide2_position_z * (rod2_first_moment_z
        + slide2_position_z * tube2_inertia) * 2.0;
    const wreal rod2_mass_4 = rod2_inertia_xx_2 + rod2_mass_3;
    const wreal rod2_mass_5 = rod2_inertia_yy_2 + rod2_mass_3;

    /* rod3: mass */
    const wreal rod3_mass_3 = slide3_position_z * (rod3_first_moment_z
        + slide3_position_z * tube3_inertia) * 2.0;
    const wreal rod3_mass_4 = rod3_inertia_xx_2 + rod3_mass_3;
    const wreal rod3_mass_5 = rod3_inertia_yy_2 + rod3_mass_3;

    /* rod4: mass */
    const wreal rod4_mass_3 = slide4_position_z * (rod4_first_moment_z
        + slide4_position_z * tube4_inertia) * 2.0;
    const wreal rod4_mass_4 = rod4_inertia_xx_2 + rod4_mass_3;
    const wreal rod4_mass_5 = rod4_inertia_yy_2 + rod4_mass_3;

    /* rod5: mass */
    const wreal rod5_mass_3 = slide5_position_z * (rod5_first_moment_z
        + slide5_position_z * tube5_inertia) * 2.0;
    const wreal rod5_mass_4 = rod5_inertia_xx_2 + rod5_mass_3;
    const wreal rod5_mass_5 = rod5_inertia_yy_2 + rod5_mass_3;

    /* tube5: base inertia */
    w[54] = tube5_inertia_xx_2 + rod5_mass_4; /* tube5_base_inertia_xx */
    w[55] = tube5_inertia_yy_2 + rod5_mass_5; /* tube5_base_inertia_yy */

    /* tube4: base inertia */
    w[57] = tube4_inertia_xx_2 + rod4_mass_4; /* tube4_base_inertia_xx */
    w[58] = tube4_inertia_yy_2 + rod4_mass_5; /* tube4_base_inertia_yy */

    /* tube3: base inertia */
    w[60] = tube3_inertia_xx_2 + rod3_mass_4; /* tube3_base_inertia_xx */
    w[61] = tube3_inertia_yy_2 + rod3_mass_5; /* tube3_base_inertia_yy */

    /* tube2: base inertia */
    w[63] = tube2_inertia_xx_2 + rod2_mass_4; /* tube2_base_inertia_xx */
    w[64] = tube2_inertia_yy_2 + rod2_mass_5; /* tube2_base_inertia_yy */

    /* tube1: base inertia */
    w[66] = tube1_inertia_xx_2 + rod1_mass_4; /* tube1_base_inertia_xx */
    w[67] = tube1_inertia_yy_2 + rod1_mass_5; /* tube1_base_inertia_yy */

    /* tube0: base inertia, inertia */
    w[71] = rod0_mass_4 + platform_base_2 + tube0_inertia_xx_2; /* tube0_base_inertia_xx */
    w[72] = rod0_mass_5 + platform_base_2 + tube0_inertia_yy_2; /* tube0_base_inertia_yy */
    w[95] = 0.5 * rod0_base_mass; /* tube0_inertia */

    /* common */
    const wreal mul_1 = 0.5 * (tube0_inertia_xx_2 + tube0_inertia_yy_2 + tube0_inertia_zz);
    const wreal mul_1_2 = 0.5 * (rod0_mass_4 + rod0_mass_5 + rod0_inertia_zz);
    const wreal mul_1_3 = 0.5 * (platform_inertia_xx_2 + platform_inertia_yy_2
        + platform_inertia_zz_2);
    const wreal mul_1_4 = 0.5 * (tube1_inertia_xx_2 + tube1_inertia_yy_2 + tube1_inertia_zz);
    const wreal mul_1_5 = 0.5 * (rod1_mass_4 + rod1_mass_5 + rod1_inertia_zz);
    const wreal mul_1_6 = 0.5 * (tube2_inertia_xx_2 + tube2_inertia_yy_2 + tube2_inertia_zz);
    const wreal mul_1_7 = 0.5 * (rod2_mass_4 + rod2_mass_5 + rod2_inertia_zz);
    const wreal mul_1_8 = 0.5 * (tube3_inertia_xx_2 + tube3_inertia_yy_2 + tube3_inertia_zz);
    const wreal mul_1_9 = 0.5 * (rod3_mass_4 + rod3_mass_5 + rod3_inertia_zz);
    const wreal mul_1_10 = 0.5 * (tube4_inertia_xx_2 + tube4_inertia_yy_2 + tube4_inertia_zz);
    const wreal mul_1_11 = 0.5 * (rod4_mass_4 + rod4_mass_5 + rod4_inertia_zz);
    const wreal mul_1_12 = 0.5 * (tube5_inertia_xx_2 + tube5_inertia_yy_2 + tube5_inertia_zz);
    const wreal mul_1_13 = 0.5 * (rod5_mass_4 + rod5_mass_5 + rod5_inertia_zz);

    /* platform: base second moment */
    w[74] = mul_1_3 - platform_inertia_xx_2; /* platform_base_second_moment_xx */
    w[75] = mul_1_3 - platform_inertia_yy_2; /* platform_base_second_moment_yy */
    w[76] = mul_1_3 - platform_inertia_zz_2; /* platform_base_second_moment_zz */

    /* tube5: base second moment */
    /* tube5_base_second_moment_xx */
    w[77] = mul_1_12 - tube5_inertia_xx_2 + (mul_1_13 - rod5_mass_4);
    /* tube5_base_second_moment_yy */
    w[78] = mul_1_12 - tube5_inertia_yy_2 + (mul_1_13 - rod5_mass_5);
    /* tube5_base_second_moment_zz */
    w[79] = mul_1_12 - tube5_inertia_zz + (mul_1_13 - rod5_inertia_zz);

    /* tube4: base second moment */
    /* tube4_base_second_moment_xx */
    w[80] = mul_1_10 - tube4_inertia_xx_2 + (mul_1_11 - rod4_mass_4);
    /* tube4_base_second_moment_yy */
    w[81] = mul_1_10 - tube4_inertia_yy_2 + (mul_1_11 - rod4_mass_5);
    /* tube4_base_second_moment_zz */
    w[82] = mul_1_10 - tube4_inertia_zz + (mul_1_11 - rod4_inertia_zz);

    /* tube3: base second moment */
    /* tube3_base_second_moment_xx */
    w[83] = mul_1_8 - tube3_inertia_xx_2 + (mul_1_9 - rod3_mass_4);
    /* tube3_base_second_moment_yy */
    w[84] = mul_1_8 - tube3_inertia_yy_2 + (mul_1_9 - rod3_mass_5);
    /* tube3_base_second_moment_zz */
    w[85] = mul_1_8 - tube3_inertia_zz + (mul_1_9 - rod3_inertia_zz);

    /* tube2: base second moment */
    /* tube2_base_second_moment_xx */
    w[86] = mul_1_6 - tube2_inertia_xx_2 + (mul_1_7 - rod2_mass_4);
    /* tube2_base_second_moment_yy */
    w[87] = mul_1_6 - tube2_inertia_yy_2 + (mul_1_7 - rod2_mass_5);
    /* tube2_base_second_moment_zz */
    w[88] = mul_1_6 - tube2_inertia_zz + (mul_1_7 - rod2_inertia_zz);

    /* tube1: base second moment */
    /* tube1_base_second_moment_xx */
    w[89] = mul_1_4 - tube1_inertia_xx_2 + (mul_1_5 - rod1_mass_4);
    /* tube1_base_second_moment_yy */
    w[90] = mul_1_4 - tube1_inertia_yy_2 + (mul_1_5 - rod1_mass_5);
    /* tube1_base_second_moment_zz */
    w[91] = mul_1_4 - tube1_inertia_zz + (mul_1_5 - rod1_inertia_zz);

    /* tube0: base second moment */
    w[92] = mul_1 - tube0_inertia_xx_2 + (mul_1_2 - rod0_mass_4); /* tube0_base_second_moment_xx */
    w[93] = mul_1 - tube0_inertia_yy_2 + (mul_1_2 - rod0_mass_5); /* tube0_base_second_moment_yy */
    /* tube0_base_second_moment_zz */
    w[94] = mul_1 - tube0_inertia_zz + (mul_1_2 - rod0_inertia_zz + (platform_base
        + platform_base));

    /* constraints: D inverse, L, multipliers */
    const wreal constraints_D_inverse_6 = 1.0 / platform_inertia_zz_2;
    const wreal constraints_L_6_5 = platform_inertia_yz * constraints_D_inverse_6;
    const wreal constraints_multipliers_2 = platform_base_second_moment_xy
        + platform_inertia_xz * constraints_L_6_5;
    const wreal constraints_L_6_4 = platform_inertia_xz * constraints_D_inverse_6;
    const wreal constraints_multipliers_3 = platform_inertia_xx_2
        - platform_inertia_xz * constraints_L_6_4;
    const wreal constraints_D_inverse_5 = 1.0 / (platform_inertia_yy_2
        - platform_inertia_yz * constraints_L_6_5);
    const wreal constraints_multipliers = constraints_multipliers_2 * constraints_D_inverse_5;
    w[96] = 1.0 / rod5_mass; /* constraints_D_inverse_21 */
    w[97] = 1.0 / rod4_mass; /* constraints_D_inverse_18 */
    w[98] = 1.0 / rod3_mass; /* constraints_D_inverse_15 */
    w[99] = 1.0 / rod2_mass; /* constraints_D_inverse_12 */
    w[100] = 1.0 / rod1_mass; /* constraints_D_inverse_9 */
    w[101] = constraints_D_inverse_6; /* constraints_D_inverse_6 */
    w[102] = constraints_L_6_5; /* constraints_L_6_5 */
    w[103] = constraints_L_6_4; /* constraints_L_6_4 */
    w[104] = constraints_D_inverse_5; /* constraints_D_inverse_5 */
    w[105] = constraints_multipliers; /* constraints_multipliers */
    /* constraints_D_inverse_4 */
    w[106] = 1.0 / (constraints_multipliers_3
        - constraints_multipliers_2 * constraints_multipliers);

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

    /* shared by several: cos, sin */
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
    const real hooke0_cos = cosine[0];
    work[390] = hooke0_cos;
    const real hooke0_sin = sine[0];
    work[391] = hooke0_sin;
    const real hooke0_cos_2 = cosine[1];
    work[392] = hooke0_cos_2;
    const real hooke0_sin_2 = sine[1];
    work[393] = hooke0_sin_2;
    const real hooke1_cos = cosine[2];
    work[394] = hooke1_cos;
    const real hooke1_sin = sine[2];
    work[395] = hooke1_sin;
    const real hooke1_cos_2 = cosine[3];
    work[396] = hooke1_cos_2;
    const real hooke1_sin_2 = sine[3];
    work[397] = hooke1_sin_2;
    const real hooke2_cos = cosine[4];
    work[398] = hooke2_cos;
    const real hooke2_sin = sine[4];
    work[399] = hooke2_sin;
    const real hooke2_cos_2 = cosine[5];
    work[400] = hooke2_cos_2;
    const real hooke2_sin_2 = sine[5];
    work[401] = hooke2_sin_2;
    const real hooke3_cos = cosine[6];
    work[402] = hooke3_cos;
    const real hooke3_sin = sine[6];
    work[403] = hooke3_sin;
    const real hooke3_cos_2 = cosine[7];
    work[404] = hooke3_cos_2;
    const real hooke3_sin_2 = sine[7];
    work[405] = hooke3_sin_2;
    const real hooke4_cos = cosine[8];
    work[406] = hooke4_cos;
    const real hooke4_sin = sine[8];
    work[407] = hooke4_sin;
    const real hooke4_cos_2 = cosine[9];
    work[408] = hooke4_cos_2;
    const real hooke4_sin_2 = sine[9];
    work[409] = hooke4_sin_2;
    const real hooke5_cos = cosine[10];
    work[410] = hooke5_cos;
    const real hooke5_sin = sine[10];
    work[411] = hooke5_sin;
    const real hooke5_cos_2 = cosine[11];
    work[412] = hooke5_cos_2;
    const real hooke5_sin_2 = sine[11];
    work[413] = hooke5_sin_2;

    /* hooke0: R, drift */
    const real hooke0_u_angle1 = u[0]; /* rad/s */
    const real hooke0_u_angle2 = u[1]; /* rad/s */
    const real hooke0_R_yx = hooke0_sin * hooke0_sin_2;
    work[414] = hooke0_R_yx;
    const real hooke0_R = hooke0_sin * hooke0_cos_2;
    work[415] = hooke0_R;
    const real hooke0_R_2 = hooke0_cos * hooke0_sin_2;
    work[416] = hooke0_R_2;
    const real hooke0_R_zz = hooke0_cos * hooke0_cos_2;
    work[417] = hooke0_R_zz;
    const real hooke0_drift = hooke0_u_angle1 * hooke0_u_angle2;
    const real hooke0_drift_2 = hooke0_sin_2 * hooke0_drift;
    work[418] = hooke0_drift_2;

    /* ball0: R, qdot */
    const real ball0_w = q[3];
    const real ball0_x = q[4];
    const real ball0_y = q[5];
    const real ball0_z = q[6];
    const real ball0_u_x = u[3]; /* rad/s */
    const real ball0_u_y = u[4]; /* rad/s */
    const real ball0_u_z = u[5]; /* rad/s */
    const real ball0_R = 2.0 * ball0_x;
    work[419] = ball0_R;
    const real ball0_R_2 = 2.0 * ball0_y;
    work[420] = ball0_R_2;
    const real ball0_R_3 = 2.0 * ball0_z;
    work[421] = ball0_R_3;
    const real ball0_R_4 = ball0_w * ball0_R;
    const real ball0_R_5 = ball0_w * ball0_R_2;
    const real ball0_R_6 = ball0_w * ball0_R_3;
    const real ball0_R_7 = ball0_x * ball0_R;
    const real ball0_R_8 = ball0_x * ball0_R_2;
    const real ball0_R_9 = ball0_x * ball0_R_3;
    const real ball0_R_10 = ball0_y * ball0_R_2;
    const real ball0_R_11 = ball0_y * ball0_R_3;
    const real ball0_R_12 = ball0_z * ball0_R_3;
    const real ball0_R_xx = 1.0 - (ball0_R_10 + ball0_R_12);
    work[422] = ball0_R_xx;
    const real ball0_R_xy = ball0_R_8 - ball0_R_6;
    work[423] = ball0_R_xy;
    const real ball0_R_xz = ball0_R_5 + ball0_R_9;
    work[424] = ball0_R_xz;
    const real ball0_R_yx = ball0_R_6 + ball0_R_8;
    work[425] = ball0_R_yx;
    const real ball0_R_yy = 1.0 - (ball0_R_7 + ball0_R_12);
    work[426] = ball0_R_yy;
    const real ball0_R_yz = ball0_R_11 - ball0_R_4;
    work[427] = ball0_R_yz;
    const real ball0_R_zx = ball0_R_9 - ball0_R_5;
    work[428] = ball0_R_zx;
    const real ball0_R_zy = ball0_R_4 + ball0_R_11;
    work[429] = ball0_R_zy;
    const real ball0_R_zz = 1.0 - (ball0_R_7 + ball0_R_10);
    work[430] = ball0_R_zz;
    const real ball0_qdot = 0.5 * ball0_u_x;
    const real ball0_qdot_2 = 0.5 * ball0_u_y;
    const real ball0_qdot_3 = 0.5 * ball0_u_z;
    const real ball0_qdot_4 = ball0_x * ball0_qdot + ball0_y * ball0_qdot_2
        + ball0_z * ball0_qdot_3;
    work[431] = ball0_qdot_4;
    const real ball0_qdot_5 = ball0_w * ball0_qdot - ball0_z * ball0_qdot_2
        + ball0_y * ball0_qdot_3;
    work[432] = ball0_qdot_5;
    const real ball0_qdot_6 = ball0_z * ball0_qdot + ball0_w * ball0_qdot_2
        - ball0_x * ball0_qdot_3;
    work[433] = ball0_qdot_6;
    const real ball0_qdot_7 = ball0_w * ball0_qdot_3 - ball0_y * ball0_qdot
        + ball0_x * ball0_qdot_2;
    work[434] = ball0_qdot_7;

    /* shared by several: pose, twist, inertia */
    const real slide0_q = q[2]; /* m */
    const real slide0_u = u[2]; /* m/s */
    const wreal hooke0_position_x = w[1]; /* m */
    const wreal hooke0_position_y = w[2]; /* m */
    const wreal slide0_position_z = w[4]; /* m */
    const wreal platform_base_second_moment_xy = w[8];
    const wreal platform_inertia_xz = w[9];
    const wreal platform_inertia_yz = w[10];
    const wreal platform_inertia_xx_2 = w[11];
    const wreal platform_inertia_yy_2 = w[12];
    const wreal platform_inertia_zz_2 = w[13];
    const real ball1_pose = hooke0_cos_2 * ball0_R_xx + hooke0_sin_2 * ball0_R_zx;
    work[435] = ball1_pose;
    const real ball1_pose_2 = hooke0_cos_2 * ball0_R_xy + hooke0_sin_2 * ball0_R_zy;
    work[436] = ball1_pose_2;
    const real ball1_pose_3 = hooke0_cos_2 * ball0_R_xz + hooke0_sin_2 * ball0_R_zz;
    work[437] = ball1_pose_3;
    const real ball1_pose_4 = hooke0_R_yx * ball0_R_xx + hooke0_cos * ball0_R_yx
        - hooke0_R * ball0_R_zx;
    work[438] = ball1_pose_4;
    const real ball1_pose_5 = hooke0_R_yx * ball0_R_xy + hooke0_cos * ball0_R_yy
        - hooke0_R * ball0_R_zy;
    work[439] = ball1_pose_5;
    const real ball1_pose_6 = hooke0_R_yx * ball0_R_xz + hooke0_cos * ball0_R_yz
        - hooke0_R * ball0_R_zz;
    work[440] = ball1_pose_6;
    const real ball1_pose_7 = hooke0_sin * ball0_R_yx - hooke0_R_2 * ball0_R_xx
        + hooke0_R_zz * ball0_R_zx;
    work[441] = ball1_pose_7;
    const real ball1_pose_8 = hooke0_sin * ball0_R_yy - hooke0_R_2 * ball0_R_xy
        + hooke0_R_zz * ball0_R_zy;
    work[442] = ball1_pose_8;
    const real ball1_pose_9 = hooke0_sin * ball0_R_yz - hooke0_R_2 * ball0_R_xz
        + hooke0_R_zz * ball0_R_zz;
    work[443] = ball1_pose_9;
    const real ball1_pose_10 = hooke0_position_x + slide0_q * hooke0_sin_2
        + slide0_position_z * hooke0_sin_2;
    work[444] = ball1_pose_10;
    const real ball1_pose_11 = hooke0_position_y - slide0_q * hooke0_R
        - slide0_position_z * hooke0_R;
    work[445] = ball1_pose_11;
    const real ball1_pose_12 = slide0_q * hooke0_R_zz + slide0_position_z * hooke0_R_zz;
    work[446] = ball1_pose_12;
    const real ball1_twist = hooke0_cos_2 * hooke0_cos_2 + hooke0_sin_2 * hooke0_sin_2;
    work[447] = ball1_twist;
    const real ball1_twist_2 = hooke0_cos_2 * hooke0_R_yx - hooke0_sin_2 * hooke0_R;
    work[448] = ball1_twist_2;
    const real ball1_twist_3 = hooke0_sin_2 * hooke0_R_zz - hooke0_cos_2 * hooke0_R_2;
    work[449] = ball1_twist_3;
    const real ball1_twist_4 = slide0_u * hooke0_sin_2;
    work[450] = ball1_twist_4;
    const real ball1_twist_5 = slide0_u * hooke0_R;
    work[451] = ball1_twist_5;
    const real ball1_twist_6 = slide0_u * hooke0_R_zz;
    work[452] = ball1_twist_6;
    const real ball1_twist_7 = ball0_u_x * ball1_pose + ball0_u_y * ball1_pose_2
        + ball0_u_z * ball1_pose_3;
    work[453] = ball1_twist_7;
    const real ball1_twist_8 = ball0_u_x * ball1_pose_4 + ball0_u_y * ball1_pose_5
        + ball0_u_z * ball1_pose_6;
    work[454] = ball1_twist_8;
    const real ball1_twist_9 = ball0_u_x * ball1_pose_7 + ball0_u_y * ball1_pose_8
        + ball0_u_z * ball1_pose_9;
    work[455] = ball1_twist_9;
    const real ball1_twist_10 = hooke0_sin_2 * ball1_pose - hooke0_R * ball1_pose_4
        + hooke0_R_zz * ball1_pose_7;
    work[456] = ball1_twist_10;
    const real ball1_twist_11 = hooke0_sin_2 * ball1_pose_2 - hooke0_R * ball1_pose_5
        + hooke0_R_zz * ball1_pose_8;
    work[457] = ball1_twist_11;
    const real ball1_twist_12 = hooke0_sin_2 * ball1_pose_3 - hooke0_R * ball1_pose_6
        + hooke0_R_zz * ball1_pose_9;
    work[458] = ball1_twist_12;
    const real rod0_inertia = platform_inertia_xx_2 * ball0_R_xx
        - platform_base_second_moment_xy * ball0_R_xy + platform_inertia_xz * ball0_R_xz;
    work[459] = rod0_inertia;
    const real rod0_inertia_2 = platform_inertia_yy_2 * ball0_R_xy
        - platform_base_second_moment_xy * ball0_R_xx + platform_inertia_yz * ball0_R_xz;
    work[460] = rod0_inertia_2;
    const real rod0_inertia_3 = platform_inertia_xz * ball0_R_xx
        + platform_inertia_yz * ball0_R_xy + platform_inertia_zz_2 * ball0_R_xz;
    work[461] = rod0_inertia_3;
    const real rod0_inertia_4 = platform_inertia_xx_2 * ball0_R_yx
        - platform_base_second_moment_xy * ball0_R_yy + platform_inertia_xz * ball0_R_yz;
    work[462] = rod0_inertia_4;
    const real rod0_inertia_5 = platform_inertia_yy_2 * ball0_R_yy
        - platform_base_second_moment_xy * ball0_R_yx + platform_inertia_yz * ball0_R_yz;
    work[463] = rod0_inertia_5;
    const real rod0_inertia_6 = platform_inertia_xz * ball0_R_yx
        + platform_inertia_yz * ball0_R_yy + platform_inertia_zz_2 * ball0_R_yz;
    work[464] = rod0_inertia_6;
    const real rod0_inertia_7 = platform_inertia_xx_2 * ball0_R_zx
        - platform_base_second_moment_xy * ball0_R_zy + platform_inertia_xz * ball0_R_zz;
    work[465] = rod0_inertia_7;
    const real rod0_inertia_8 = platform_inertia_yy_2 * ball0_R_zy
        - platform_base_second_moment_xy * ball0_R_zx + platform_inertia_yz * ball0_R_zz;
    work[466] = rod0_inertia_8;
    const real rod0_inertia_9 = platform_inertia_xz * ball0_R_zx
        + platform_inertia_yz * ball0_R_zy + platform_inertia_zz_2 * ball0_R_zz;
    work[467] = rod0_inertia_9;

    /* hooke1: R, drift, momentum mz */
    const real hooke1_u_angle1 = u[6]; /* rad/s */
    const real hooke1_u_angle2 = u[7]; /* rad/s */
    const wreal tube1_base_inertia_zz = w[68];
    const real hooke1_R_yx = hooke1_sin * hooke1_sin_2;
    work[468] = hooke1_R_yx;
    const real hooke1_R = hooke1_sin * hooke1_cos_2;
    work[469] = hooke1_R;
    const real hooke1_R_2 = hooke1_cos * hooke1_sin_2;
    work[470] = hooke1_R_2;
    const real hooke1_R_zz = hooke1_cos * hooke1_cos_2;
    work[471] = hooke1_R_zz;
    const real hooke1_drift = hooke1_u_angle1 * hooke1_u_angle2;
    const real hooke1_drift_2 = hooke1_sin_2 * hooke1_drift;
    work[472] = hooke1_drift_2;
    const real hooke1_momentum_mz = tube1_base_inertia_zz * hooke1_sin_2;
    work[473] = hooke1_momentum_mz;

    /* ball1: pose, twist, G */
    const wreal hooke1_position_x = w[14]; /* m */
    const wreal hooke1_position_y = w[15]; /* m */
    const wreal ball1_placement = w[34];
    const wreal ball1_placement_2 = w[35];
    const real ball1_pose_13 = ball1_placement * ball1_pose + ball1_placement_2 * ball1_pose_2
        + ball1_pose_10;
    const real ball1_pose_14 = ball1_placement * ball1_pose_4 + ball1_placement_2 * ball1_pose_5
        + ball1_pose_11;
    const real ball1_pose_15 = ball1_placement * ball1_pose_7 + ball1_placement_2 * ball1_pose_8
        + ball1_pose_12;
    work[474] = ball1_pose_15;
    const real ball1_pose_16 = ball1_pose * hooke1_cos_2 + ball1_pose_4 * hooke1_R_yx
        - ball1_pose_7 * hooke1_R_2;
    work[475] = ball1_pose_16;
    const real ball1_pose_17 = ball1_pose_2 * hooke1_cos_2 + ball1_pose_5 * hooke1_R_yx
        - ball1_pose_8 * hooke1_R_2;
    work[476] = ball1_pose_17;
    const real ball1_pose_18 = ball1_pose_3 * hooke1_cos_2 + ball1_pose_6 * hooke1_R_yx
        - ball1_pose_9 * hooke1_R_2;
    work[477] = ball1_pose_18;
    const real ball1_pose_19 = ball1_pose_4 * hooke1_cos + ball1_pose_7 * hooke1_sin;
    work[478] = ball1_pose_19;
    const real ball1_pose_20 = ball1_pose_5 * hooke1_cos + ball1_pose_8 * hooke1_sin;
    work[479] = ball1_pose_20;
    const real ball1_pose_21 = ball1_pose_6 * hooke1_cos + ball1_pose_9 * hooke1_sin;
    work[480] = ball1_pose_21;
    const real ball1_pose_22 = ball1_pose * hooke1_sin_2 - ball1_pose_4 * hooke1_R
        + ball1_pose_7 * hooke1_R_zz;
    work[481] = ball1_pose_22;
    const real ball1_pose_23 = ball1_pose_2 * hooke1_sin_2 - ball1_pose_5 * hooke1_R
        + ball1_pose_8 * hooke1_R_zz;
    work[482] = ball1_pose_23;
    const real ball1_pose_24 = ball1_pose_3 * hooke1_sin_2 - ball1_pose_6 * hooke1_R
        + ball1_pose_9 * hooke1_R_zz;
    work[483] = ball1_pose_24;
    const real ball1_twist_13 = ball1_pose_13 - hooke0_position_x;
    work[484] = ball1_twist_13;
    const real ball1_twist_14 = ball1_pose_14 - hooke0_position_y;
    work[485] = ball1_twist_14;
    const real ball1_twist_15 = ball1_pose_15 * ball1_twist_2 - ball1_twist_14 * ball1_twist_3;
    const real ball1_twist_16 = ball1_twist_13 * ball1_twist_3 - ball1_pose_15 * ball1_twist;
    const real ball1_twist_17 = ball1_twist_14 * ball1_twist - ball1_twist_13 * ball1_twist_2;
    const real ball1_twist_18 = hooke0_cos * ball1_pose_15 - hooke0_sin * ball1_twist_14;
    const real ball1_twist_19 = hooke0_sin * ball1_twist_13;
    const real ball1_twist_20 = hooke0_cos * ball1_twist_13;
    const real ball1_twist_21 = ball1_pose_13 - ball1_pose_10;
    work[486] = ball1_twist_21;
    const real ball1_twist_22 = ball1_pose_14 - ball1_pose_11;
    work[487] = ball1_twist_22;
    const real ball1_twist_23 = ball1_pose_15 - ball1_pose_12;
    work[488] = ball1_twist_23;
    const real ball1_twist_24 = ball1_pose_4 * ball1_twist_23 - ball1_pose_7 * ball1_twist_22;
    const real ball1_twist_25 = ball1_pose_7 * ball1_twist_21 - ball1_pose * ball1_twist_23;
    const real ball1_twist_26 = ball1_pose * ball1_twist_22 - ball1_pose_4 * ball1_twist_21;
    const real ball1_twist_27 = ball1_pose_5 * ball1_twist_23 - ball1_pose_8 * ball1_twist_22;
    const real ball1_twist_28 = ball1_pose_8 * ball1_twist_21 - ball1_pose_2 * ball1_twist_23;
    const real ball1_twist_29 = ball1_pose_2 * ball1_twist_22 - ball1_pose_5 * ball1_twist_21;
    const real ball1_twist_30 = ball1_pose_6 * ball1_twist_23 - ball1_pose_9 * ball1_twist_22;
    const real ball1_twist_31 = ball1_pose_9 * ball1_twist_21 - ball1_pose_3 * ball1_twist_23;
    const real ball1_twist_32 = ball1_pose_3 * ball1_twist_22 - ball1_pose_6 * ball1_twist_21;
    const real ball1_twist_33 = ball1_pose_13 - hooke1_position_x;
    work[489] = ball1_twist_33;
    const real ball1_twist_34 = ball1_pose_14 - hooke1_position_y;
    work[490] = ball1_twist_34;
    const real ball1_twist_35 = hooke1_cos_2 * hooke1_cos_2 + hooke1_sin_2 * hooke1_sin_2;
    const real ball1_twist_36 = hooke1_cos_2 * hooke1_R_yx - hooke1_sin_2 * hooke1_R;
    const real ball1_twist_37 = hooke1_sin_2 * hooke1_R_zz - hooke1_cos_2 * hooke1_R_2;
    const real ball1_twist_38 = ball1_pose_15 * ball1_twist_36 - ball1_twist_34 * ball1_twist_37;
    const real ball1_twist_39 = ball1_twist_33 * ball1_twist_37 - ball1_pose_15 * ball1_twist_35;
    const real ball1_twist_40 = ball1_twist_34 * ball1_twist_35 - ball1_twist_33 * ball1_twist_36;
    const real ball1_twist_41 = hooke1_cos * ball1_pose_15 - hooke1_sin * ball1_twist_34;
    const real ball1_twist_42 = hooke1_sin * ball1_twist_33;
    const real ball1_twist_43 = hooke1_cos * ball1_twist_33;
    const real ball1_twist_44 = ball1_pose * ball1_twist_15 + ball1_pose_4 * ball1_twist_16
        + ball1_pose_7 * ball1_twist_17;
    const real ball1_twist_45 = ball1_pose_2 * ball1_twist_15 + ball1_pose_5 * ball1_twist_16
        + ball1_pose_8 * ball1_twist_17;
    const real ball1_twist_46 = ball1_pose_3 * ball1_twist_15 + ball1_pose_6 * ball1_twist_16
        + ball1_pose_9 * ball1_twist_17;
    const real ball1_twist_47 = ball1_pose * ball1_twist_18 + ball1_pose_4 * ball1_twist_19
        - ball1_pose_7 * ball1_twist_20;
    const real ball1_twist_48 = ball1_pose_2 * ball1_twist_18 + ball1_pose_5 * ball1_twist_19
        - ball1_pose_8 * ball1_twist_20;
    const real ball1_twist_49 = ball1_pose_3 * ball1_twist_18 + ball1_pose_6 * ball1_twist_19
        - ball1_pose_9 * ball1_twist_20;
    const real ball1_twist_50 = ball1_pose * ball1_twist_24 + ball1_pose_4 * ball1_twist_25
        + ball1_pose_7 * ball1_twist_26;
    const real ball1_twist_51 = ball1_pose_2 * ball1_twist_24 + ball1_pose_5 * ball1_twist_25
        + ball1_pose_8 * ball1_twist_26;
    const real ball1_twist_52 = ball1_pose_3 * ball1_twist_24 + ball1_pose_6 * ball1_twist_25
        + ball1_pose_9 * ball1_twist_26;
    const real ball1_twist_53 = ball1_pose * ball1_twist_27 + ball1_pose_4 * ball1_twist_28
        + ball1_pose_7 * ball1_twist_29;
    const real ball1_twist_54 = ball1_pose_2 * ball1_twist_27 + ball1_pose_5 * ball1_twist_28
        + ball1_pose_8 * ball1_twist_29;
    const real ball1_twist_55 = ball1_pose_3 * ball1_twist_27 + ball1_pose_6 * ball1_twist_28
        + ball1_pose_9 * ball1_twist_29;
    const real ball1_twist_56 = ball1_pose * ball1_twist_30 + ball1_pose_4 * ball1_twist_31
        + ball1_pose_7 * ball1_twist_32;
    const real ball1_twist_57 = ball1_pose_2 * ball1_twist_30 + ball1_pose_5 * ball1_twist_31
        + ball1_pose_8 * ball1_twist_32;
    const real ball1_twist_58 = ball1_pose_3 * ball1_twist_30 + ball1_pose_6 * ball1_twist_31
        + ball1_pose_9 * ball1_twist_32;
    const real ball1_twist_59 = ball1_pose * ball1_twist_38 + ball1_pose_4 * ball1_twist_39
        + ball1_pose_7 * ball1_twist_40;
    const real ball1_twist_60 = ball1_pose_2 * ball1_twist_38 + ball1_pose_5 * ball1_twist_39
        + ball1_pose_8 * ball1_twist_40;
    const real ball1_twist_61 = ball1_pose_3 * ball1_twist_38 + ball1_pose_6 * ball1_twist_39
        + ball1_pose_9 * ball1_twist_40;
    const real ball1_twist_62 = ball1_pose_7 * ball1_twist_43 - (ball1_pose * ball1_twist_41
        + ball1_pose_4 * ball1_twist_42);
    const real ball1_twist_63 = ball1_pose_8 * ball1_twist_43 - (ball1_pose_2 * ball1_twist_41
        + ball1_pose_5 * ball1_twist_42);
    const real ball1_twist_64 = ball1_pose_9 * ball1_twist_43 - (ball1_pose_3 * ball1_twist_41
        + ball1_pose_6 * ball1_twist_42);
    const real ball1_G = ball1_pose_16 * ball1_twist_44 + ball1_pose_17 * ball1_twist_45
        + ball1_pose_18 * ball1_twist_46;
    work[491] = ball1_G;
    const real ball1_G_2 = ball1_pose_16 * ball1_twist_47 + ball1_pose_17 * ball1_twist_48
        + ball1_pose_18 * ball1_twist_49;
    work[492] = ball1_G_2;
    const real ball1_G_3 = ball1_pose_16 * ball1_twist_10 + ball1_pose_17 * ball1_twist_11
        + ball1_pose_18 * ball1_twist_12;
    work[493] = ball1_G_3;
    const real ball1_G_4 = ball1_pose_16 * ball1_twist_50 + ball1_pose_17 * ball1_twist_51
        + ball1_pose_18 * ball1_twist_52;
    work[494] = ball1_G_4;
    const real ball1_G_5 = ball1_pose_16 * ball1_twist_53 + ball1_pose_17 * ball1_twist_54
        + ball1_pose_18 * ball1_twist_55;
    work[495] = ball1_G_5;
    const real ball1_G_6 = ball1_pose_16 * ball1_twist_56 + ball1_pose_17 * ball1_twist_57
        + ball1_pose_18 * ball1_twist_58;
    work[496] = ball1_G_6;
    const real ball1_G_7 = ball1_pose_16 * ball1_twist_59 + ball1_pose_17 * ball1_twist_60
        + ball1_pose_18 * ball1_twist_61;
    work[497] = ball1_G_7;
    const real ball1_G_8 = ball1_pose_16 * ball1_twist_62 + ball1_pose_17 * ball1_twist_63
        + ball1_pose_18 * ball1_twist_64;
    work[498] = ball1_G_8;
    const real ball1_G_9 = ball1_pose_16 * ball1_pose_22 + ball1_pose_17 * ball1_pose_23
        + ball1_pose_18 * ball1_pose_24;
    work[499] = ball1_G_9;
    const real ball1_G_10 = ball1_pose_19 * ball1_twist_44 + ball1_pose_20 * ball1_twist_45
        + ball1_pose_21 * ball1_twist_46;
    work[500] = ball1_G_10;
    const real ball1_G_11 = ball1_pose_19 * ball1_twist_47 + ball1_pose_20 * ball1_twist_48
        + ball1_pose_21 * ball1_twist_49;
    work[501] = ball1_G_11;
    const real ball1_G_12 = ball1_pose_19 * ball1_twist_10 + ball1_pose_20 * ball1_twist_11
        + ball1_pose_21 * ball1_twist_12;
    work[502] = ball1_G_12;
    const real ball1_G_13 = ball1_pose_19 * ball1_twist_50 + ball1_pose_20 * ball1_twist_51
        + ball1_pose_21 * ball1_twist_52;
    work[503] = ball1_G_13;
    const real ball1_G_14 = ball1_pose_19 * ball1_twist_53 + ball1_pose_20 * ball1_twist_54
        + ball1_pose_21 * ball1_twist_55;
    work[504] = ball1_G_14;
    const real ball1_G_15 = ball1_pose_19 * ball1_twist_56 + ball1_pose_20 * ball1_twist_57
        + ball1_pose_21 * ball1_twist_58;
    work[505] = ball1_G_15;
    const real ball1_G_16 = ball1_pose_19 * ball1_twist_59 + ball1_pose_20 * ball1_twist_60
        + ball1_pose_21 * ball1_twist_61;
    work[506] = ball1_G_16;
    const real ball1_G_17 = ball1_pose_19 * ball1_twist_62 + ball1_pose_20 * ball1_twist_63
        + ball1_pose_21 * ball1_twist_64;
    work[507] = ball1_G_17;
    const real ball1_G_18 = ball1_pose_19 * ball1_pose_22 + ball1_pose_20 * ball1_pose_23
        + ball1_pose_21 * ball1_pose_24;
    work[508] = ball1_G_18;
    const real ball1_G_19 = ball1_pose_22 * ball1_twist_44 + ball1_pose_23 * ball1_twist_45
        + ball1_pose_24 * ball1_twist_46;
    work[509] = ball1_G_19;
    const real ball1_G_20 = ball1_pose_22 * ball1_twist_47 + ball1_pose_23 * ball1_twist_48
        + ball1_pose_24 * ball1_twist_49;
    work[510] = ball1_G_20;
    const real ball1_G_21 = ball1_pose_22 * ball1_twist_10 + ball1_pose_23 * ball1_twist_11
        + ball1_pose_24 * ball1_twist_12;
    work[511] = ball1_G_21;
    const real ball1_G_22 = ball1_pose_22 * ball1_twist_50 + ball1_pose_23 * ball1_twist_51
        + ball1_pose_24 * ball1_twist_52;
    work[512] = ball1_G_22;
    const real ball1_G_23 = ball1_pose_22 * ball1_twist_53 + ball1_pose_23 * ball1_twist_54
        + ball1_pose_24 * ball1_twist_55;
    work[513] = ball1_G_23;
    const real ball1_G_24 = ball1_pose_22 * ball1_twist_56 + ball1_pose_23 * ball1_twist_57
        + ball1_pose_24 * ball1_twist_58;
    work[514] = ball1_G_24;
    const real ball1_G_25 = ball1_pose_22 * ball1_twist_59 + ball1_pose_23 * ball1_twist_60
        + ball1_pose_24 * ball1_twist_61;
    work[515] = ball1_G_25;
    const real ball1_G_26 = ball1_pose_22 * ball1_twist_62 + ball1_pose_23 * ball1_twist_63
        + ball1_pose_24 * ball1_twist_64;
    work[516] = ball1_G_26;
    const real ball1_G_27 = ball1_pose_22 * ball1_pose_22 + ball1_pose_23 * ball1_pose_23
        + ball1_pose_24 * ball1_pose_24;
    work[517] = ball1_G_27;

    /* tube0: omega, alpha, a, U, inertia force */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const wreal tube0_first_moment_z = w[3];
    const wreal tube0_base_second_moment_xx = w[92];
    const wreal tube0_base_second_moment_zz = w[94];
    const real tube0_omega_x = hooke0_u_angle1 * hooke0_cos_2;
    work[518] = tube0_omega_x;
    const real tube0_omega_z = hooke0_u_angle1 * hooke0_sin_2;
    work[519] = tube0_omega_z;
    const real tube0_alpha_z = hooke0_cos_2 * hooke0_drift;
    work[520] = tube0_alpha_z;
    const real tube0_a_x = gravity_z * hooke0_R_2;
    work[521] = tube0_a_x;
    const real tube0_a = gravity_z * hooke0_sin;
    work[522] = tube0_a;
    const real tube0_U_xz = tube0_omega_x * tube0_omega_z;
    work[523] = tube0_U_xz;
    const real tube0_inertia_force = tube0_base_second_moment_zz * tube0_U_xz
        - tube0_base_second_moment_xx * tube0_U_xz + tube0_first_moment_z * tube0_a_x;
    work[524] = tube0_inertia_force;

    /* shared by several: twist, U */
    const real ball1_twist_65 = hooke0_cos_2 * tube0_omega_x + hooke0_sin_2 * tube0_omega_z;
    work[525] = ball1_twist_65;
    const real ball1_twist_66 = hooke0_R_yx * tube0_omega_x + hooke0_u_angle2 * hooke0_cos
        - hooke0_R * tube0_omega_z;
    work[526] = ball1_twist_66;
    const real ball1_twist_67 = hooke0_u_angle2 * hooke0_sin - hooke0_R_2 * tube0_omega_x
        + hooke0_R_zz * tube0_omega_z;
    work[527] = ball1_twist_67;
    const real tube0_U = hooke0_u_angle2 * tube0_omega_x;
    work[528] = tube0_U;
    const real tube0_U_2 = hooke0_u_angle2 * tube0_omega_z;
    work[529] = tube0_U_2;
    const real tube0_U_3 = tube0_omega_x * tube0_omega_x + hooke0_u_angle2 * hooke0_u_angle2;
    work[530] = tube0_U_3;

    /* ball1: twist */
    const real ball1_twist_68 = ball1_pose_15 * ball1_twist_66 - ball1_twist_14 * ball1_twist_67
        + ball1_twist_4;
    const real ball1_twist_69 = ball1_twist_13 * ball1_twist_67 - ball1_pose_15 * ball1_twist_65
        - ball1_twist_5;
    const real ball1_twist_70 = ball1_twist_14 * ball1_twist_65 - ball1_twist_13 * ball1_twist_66
        + ball1_twist_6;
    const real ball1_twist_71 = ball1_twist_23 * ball1_twist_8 - ball1_twist_22 * ball1_twist_9
        + ball1_twist_68;
    const real ball1_twist_72 = ball1_twist_21 * ball1_twist_9 - ball1_twist_23 * ball1_twist_7
        + ball1_twist_69;
    const real ball1_twist_73 = ball1_twist_22 * ball1_twist_7 - ball1_twist_21 * ball1_twist_8
        + ball1_twist_70;

    /* tube1: omega, alpha, inertia, composite inertia, a, U, inertia force */
    const real slide1_q = q[9]; /* m */
    const wreal tube1_first_moment_z = w[16];
    const wreal tube1_inertia = w[44];
    const wreal rod1_base_moment_z = w[45];
    const wreal tube1_base_inertia_xx = w[66];
    const wreal tube1_base_inertia_yy = w[67];
    const wreal tube1_base_second_moment_xx = w[89];
    const wreal tube1_base_second_moment_zz = w[91];
    const real tube1_omega_x = hooke1_u_angle1 * hooke1_cos_2;
    work[531] = tube1_omega_x;
    const real tube1_omega_z = hooke1_u_angle1 * hooke1_sin_2;
    work[532] = tube1_omega_z;
    const real tube1_alpha_z = hooke1_cos_2 * hooke1_drift;
    work[533] = tube1_alpha_z;
    const real tube1_inertia_2 = slide1_q * (rod1_base_moment_z + slide1_q * tube1_inertia) * 2.0;
    const real tube1_composite_inertia_xx = tube1_base_inertia_xx + tube1_inertia_2;
    work[534] = tube1_composite_inertia_xx;
    const real tube1_composite_inertia_yy = tube1_base_inertia_yy + tube1_inertia_2;
    work[535] = tube1_composite_inertia_yy;
    const real tube1_a_x = gravity_z * hooke1_R_2;
    work[536] = tube1_a_x;
    const real tube1_a = gravity_z * hooke1_sin;
    work[537] = tube1_a;
    const real tube1_U_xz = tube1_omega_x * tube1_omega_z;
    work[538] = tube1_U_xz;
    const real tube1_inertia_force = tube1_base_second_moment_zz * tube1_U_xz
        - tube1_base_second_moment_xx * tube1_U_xz + tube1_first_moment_z * tube1_a_x;
    work[539] = tube1_inertia_force;

    /* ball1: twist */
    const real slide1_u = u[8]; /* m/s */
    const real ball1_twist_74 = hooke1_cos_2 * tube1_omega_x + hooke1_sin_2 * tube1_omega_z;
    work[540] = ball1_twist_74;
    const real ball1_twist_75 = hooke1_R_yx * tube1_omega_x + hooke1_u_angle2 * hooke1_cos
        - hooke1_R * tube1_omega_z;
    work[541] = ball1_twist_75;
    const real ball1_twist_76 = hooke1_u_angle2 * hooke1_sin - hooke1_R_2 * tube1_omega_x
        + hooke1_R_zz * tube1_omega_z;
    work[542] = ball1_twist_76;
    const real ball1_twist_77 = ball1_twist_71 - (ball1_pose_15 * ball1_twist_75
        - ball1_twist_34 * ball1_twist_76) - slide1_u * hooke1_sin_2;
    work[543] = ball1_twist_77;
    const real ball1_twist_78 = ball1_twist_72 - (ball1_twist_33 * ball1_twist_76
        - ball1_pose_15 * ball1_twist_74) + slide1_u * hooke1_R;
    work[544] = ball1_twist_78;
    const real ball1_twist_79 = ball1_twist_73 - (ball1_twist_34 * ball1_twist_74
        - ball1_twist_33 * ball1_twist_75) - slide1_u * hooke1_R_zz;
    work[545] = ball1_twist_79;
    const real ball1_twist_80 = ball1_pose * ball1_twist_77 + ball1_pose_4 * ball1_twist_78
        + ball1_pose_7 * ball1_twist_79;
    work[546] = ball1_twist_80;
    const real ball1_twist_81 = ball1_pose_2 * ball1_twist_77 + ball1_pose_5 * ball1_twist_78
        + ball1_pose_8 * ball1_twist_79;
    work[547] = ball1_twist_81;
    const real ball1_twist_82 = ball1_pose_3 * ball1_twist_77 + ball1_pose_6 * ball1_twist_78
        + ball1_pose_9 * ball1_twist_79;
    work[548] = ball1_twist_82;

    /* hooke2: R, drift, momentum mz */
    const real hooke2_u_angle1 = u[9]; /* rad/s */
    const real hooke2_u_angle2 = u[10]; /* rad/s */
    const wreal tube2_base_inertia_zz = w[65];
    const real hooke2_R_yx = hooke2_sin * hooke2_sin_2;
    work[549] = hooke2_R_yx;
    const real hooke2_R = hooke2_sin * hooke2_cos_2;
    work[550] = hooke2_R;
    const real hooke2_R_2 = hooke2_cos * hooke2_sin_2;
    work[551] = hooke2_R_2;
    const real hooke2_R_zz = hooke2_cos * hooke2_cos_2;
    work[552] = hooke2_R_zz;
    const real hooke2_drift = hooke2_u_angle1 * hooke2_u_angle2;
    const real hooke2_drift_2 = hooke2_sin_2 * hooke2_drift;
    work[553] = hooke2_drift_2;
    const real hooke2_momentum_mz = tube2_base_inertia_zz * hooke2_sin_2;
    work[554] = hooke2_momentum_mz;

    /* ball2: pose, twist, G */
    const wreal hooke2_position_x = w[18]; /* m */
    const wreal hooke2_position_y = w[19]; /* m */
    const wreal ball2_placement = w[36];
    const wreal ball2_placement_2 = w[37];
    const real ball2_pose = ball2_placement * ball1_pose + ball2_placement_2 * ball1_pose_2
        + ball1_pose_10;
    const real ball2_pose_2 = ball2_placement * ball1_pose_4 + ball2_placement_2 * ball1_pose_5
        + ball1_pose_11;
    const real ball2_pose_3 = ball2_placement * ball1_pose_7 + ball2_placement_2 * ball1_pose_8
        + ball1_pose_12;
    work[555] = ball2_pose_3;
    const real ball2_pose_4 = ball1_pose * hooke2_cos_2 + ball1_pose_4 * hooke2_R_yx
        - ball1_pose_7 * hooke2_R_2;
    work[556] = ball2_pose_4;
    const real ball2_pose_5 = ball1_pose_2 * hooke2_cos_2 + ball1_pose_5 * hooke2_R_yx
        - ball1_pose_8 * hooke2_R_2;
    work[557] = ball2_pose_5;
    const real ball2_pose_6 = ball1_pose_3 * hooke2_cos_2 + ball1_pose_6 * hooke2_R_yx
        - ball1_pose_9 * hooke2_R_2;
    work[558] = ball2_pose_6;
    const real ball2_pose_7 = ball1_pose_4 * hooke2_cos + ball1_pose_7 * hooke2_sin;
    work[559] = ball2_pose_7;
    const real ball2_pose_8 = ball1_pose_5 * hooke2_cos + ball1_pose_8 * hooke2_sin;
    work[560] = ball2_pose_8;
    const real ball2_pose_9 = ball1_pose_6 * hooke2_cos + ball1_pose_9 * hooke2_sin;
    work[561] = ball2_pose_9;
    const real ball2_pose_10 = ball1_pose * hooke2_sin_2 - ball1_pose_4 * hooke2_R
        + ball1_pose_7 * hooke2_R_zz;
    work[562] = ball2_pose_10;
    const real ball2_pose_11 = ball1_pose_2 * hooke2_sin_2 - ball1_pose_5 * hooke2_R
        + ball1_pose_8 * hooke2_R_zz;
    work[563] = ball2_pose_11;
    const real ball2_pose_12 = ball1_pose_3 * hooke2_sin_2 - ball1_pose_6 * hooke2_R
        + ball1_pose_9 * hooke2_R_zz;
    work[564] = ball2_pose_12;
    const real ball2_twist = ball2_pose - hooke0_position_x;
    work[565] = ball2_twist;
    const real ball2_twist_2 = ball2_pose_2 - hooke0_position_y;
    work[566] = ball2_twist_2;
    const real ball2_twist_3 = ball1_twist_2 * ball2_pose_3 - ball1_twist_3 * ball2_twist_2;
    const real ball2_twist_4 = ball1_twist_3 * ball2_twist - ball1_twist * ball2_pose_3;
    const real ball2_twist_5 = ball1_twist * ball2_twist_2 - ball1_twist_2 * ball2_twist;
    const real ball2_twist_6 = hooke0_cos * ball2_pose_3 - hooke0_sin * ball2_twist_2;
    const real ball2_twist_7 = hooke0_sin * ball2_twist;
    const real ball2_twist_8 = hooke0_cos * ball2_twist;
    const real ball2_twist_9 = ball1_twist_66 * ball2_pose_3 - ball1_twist_67 * ball2_twist_2
        + ball1_twist_4;
    const real ball2_twist_10 = ball1_twist_67 * ball2_twist - ball1_twist_65 * ball2_pose_3
        - ball1_twist_5;
    const real ball2_twist_11 = ball1_twist_65 * ball2_twist_2 - ball1_twist_66 * ball2_twist
        + ball1_twist_6;
    const real ball2_twist_12 = ball2_pose - ball1_pose_10;
    work[567] = ball2_twist_12;
    const real ball2_twist_13 = ball2_pose_2 - ball1_pose_11;
    work[568] = ball2_twist_13;
    const real ball2_twist_14 = ball2_pose_3 - ball1_pose_12;
    work[569] = ball2_twist_14;
    const real ball2_twist_15 = ball1_pose_4 * ball2_twist_14 - ball1_pose_7 * ball2_twist_13;
    const real ball2_twist_16 = ball1_pose_7 * ball2_twist_12 - ball1_pose * ball2_twist_14;
    const real ball2_twist_17 = ball1_pose * ball2_twist_13 - ball1_pose_4 * ball2_twist_12;
    const real ball2_twist_18 = ball1_pose_5 * ball2_twist_14 - ball1_pose_8 * ball2_twist_13;
    const real ball2_twist_19 = ball1_pose_8 * ball2_twist_12 - ball1_pose_2 * ball2_twist_14;
    const real ball2_twist_20 = ball1_pose_2 * ball2_twist_13 - ball1_pose_5 * ball2_twist_12;
    const real ball2_twist_21 = ball1_pose_6 * ball2_twist_14 - ball1_pose_9 * ball2_twist_13;
    const real ball2_twist_22 = ball1_pose_9 * ball2_twist_12 - ball1_pose_3 * ball2_twist_14;
    const real ball2_twist_23 = ball1_pose_3 * ball2_twist_13 - ball1_pose_6 * ball2_twist_12;
    const real ball2_twist_24 = ball1_twist_8 * ball2_twist_14 - ball1_twist_9 * ball2_twist_13
        + ball2_twist_9;
    const real ball2_twist_25 = ball1_twist_9 * ball2_twist_12 - ball1_twist_7 * ball2_twist_14
        + ball2_twist_10;
    const real ball2_twist_26 = ball1_twist_7 * ball2_twist_13 - ball1_twist_8 * ball2_twist_12
        + ball2_twist_11;
    const real ball2_twist_27 = ball2_pose - hooke2_position_x;
    work[570] = ball2_twist_27;
    const real ball2_twist_28 = ball2_pose_2 - hooke2_position_y;
    work[571] = ball2_twist_28;
    const real ball2_twist_29 = hooke2_cos_2 * hooke2_cos_2 + hooke2_sin_2 * hooke2_sin_2;
    const real ball2_twist_30 = hooke2_cos_2 * hooke2_R_yx - hooke2_sin_2 * hooke2_R;
    const real ball2_twist_31 = hooke2_sin_2 * hooke2_R_zz - hooke2_cos_2 * hooke2_R_2;
    const real ball2_twist_32 = ball2_pose_3 * ball2_twist_30 - ball2_twist_28 * ball2_twist_31;
    const real ball2_twist_33 = ball2_twist_27 * ball2_twist_31 - ball2_pose_3 * ball2_twist_29;
    const real ball2_twist_34 = ball2_twist_28 * ball2_twist_29 - ball2_twist_27 * ball2_twist_30;
    const real ball2_twist_35 = hooke2_cos * ball2_pose_3 - hooke2_sin * ball2_twist_28;
    const real ball2_twist_36 = hooke2_sin * ball2_twist_27;
    const real ball2_twist_37 = hooke2_cos * ball2_twist_27;
    const real ball2_twist_38 = ball1_pose * ball2_twist_3 + ball1_pose_4 * ball2_twist_4
        + ball1_pose_7 * ball2_twist_5;
    const real ball2_twist_39 = ball1_pose_2 * ball2_twist_3 + ball1_pose_5 * ball2_twist_4
        + ball1_pose_8 * ball2_twist_5;
    const real ball2_twist_40 = ball1_pose_3 * ball2_twist_3 + ball1_pose_6 * ball2_twist_4
        + ball1_pose_9 * ball2_twist_5;
    const real ball2_twist_41 = ball1_pose * ball2_twist_6 + ball1_pose_4 * ball2_twist_7
        - ball1_pose_7 * ball2_twist_8;
    const real ball2_twist_42 = ball1_pose_2 * ball2_twist_6 + ball1_pose_5 * ball2_twist_7
        - ball1_pose_8 * ball2_twist_8;
    const real ball2_twist_43 = ball1_pose_3 * ball2_twist_6 + ball1_pose_6 * ball2_twist_7
        - ball1_pose_9 * ball2_twist_8;
    const real ball2_twist_44 = ball1_pose * ball2_twist_15 + ball1_pose_4 * ball2_twist_16
        + ball1_pose_7 * ball2_twist_17;
    const real ball2_twist_45 = ball1_pose_2 * ball2_twist_15 + ball1_pose_5 * ball2_twist_16
        + ball1_pose_8 * ball2_twist_17;
    const real ball2_twist_46 = ball1_pose_3 * ball2_twist_15 + ball1_pose_6 * ball2_twist_16
        + ball1_pose_9 * ball2_twist_17;
    const real ball2_twist_47 = ball1_pose * ball2_twist_18 + ball1_pose_4 * ball2_twist_19
        + ball1_pose_7 * ball2_twist_20;
    const real ball2_twist_48 = ball1_pose_2 * ball2_twist_18 + ball1_pose_5 * ball2_twist_19
        + ball1_pose_8 * ball2_twist_20;
    const real ball2_twist_49 = ball1_pose_3 * ball2_twist_18 + ball1_pose_6 * ball2_twist_19
        + ball1_pose_9 * ball2_twist_20;
    const real ball2_twist_50 = ball1_pose * ball2_twist_21 + ball1_pose_4 * ball2_twist_22
        + ball1_pose_7 * ball2_twist_23;
    const real ball2_twist_51 = ball1_pose_2 * ball2_twist_21 + ball1_pose_5 * ball2_twist_22
        + ball1_pose_8 * ball2_twist_23;
    const real ball2_twist_52 = ball1_pose_3 * ball2_twist_21 + ball1_pose_6 * ball2_twist_22
        + ball1_pose_9 * ball2_twist_23;
    const real ball2_twist_53 = ball1_pose * ball2_twist_32 + ball1_pose_4 * ball2_twist_33
        + ball1_pose_7 * ball2_twist_34;
    const real ball2_twist_54 = ball1_pose_2 * ball2_twist_32 + ball1_pose_5 * ball2_twist_33
        + ball1_pose_8 * ball2_twist_34;
    const real ball2_twist_55 = ball1_pose_3 * ball2_twist_32 + ball1_pose_6 * ball2_twist_33
        + ball1_pose_9 * ball2_twist_34;
    const real ball2_twist_56 = ball1_pose_7 * ball2_twist_37 - (ball1_pose * ball2_twist_35
        + ball1_pose_4 * ball2_twist_36);
    const real ball2_twist_57 = ball1_pose_8 * ball2_twist_37 - (ball1_pose_2 * ball2_twist_35
        + ball1_pose_5 * ball2_twist_36);
    const real ball2_twist_58 = ball1_pose_9 * ball2_twist_37 - (ball1_pose_3 * ball2_twist_35
        + ball1_pose_6 * ball2_twist_36);
    const real ball2_G = ball2_pose_4 * ball2_twist_38 + ball2_pose_5 * ball2_twist_39
        + ball2_pose_6 * ball2_twist_40;
    work[572] = ball2_G;
    const real ball2_G_2 = ball2_pose_4 * ball2_twist_41 + ball2_pose_5 * ball2_twist_42
        + ball2_pose_6 * ball2_twist_43;
    work[573] = ball2_G_2;
    const real ball2_G_3 = ball1_twist_10 * ball2_pose_4 + ball1_twist_11 * ball2_pose_5
        + ball1_twist_12 * ball2_pose_6;
    work[574] = ball2_G_3;
    const real ball2_G_4 = ball2_pose_4 * ball2_twist_44 + ball2_pose_5 * ball2_twist_45
        + ball2_pose_6 * ball2_twist_46;
    work[575] = ball2_G_4;
    const real ball2_G_5 = ball2_pose_4 * ball2_twist_47 + ball2_pose_5 * ball2_twist_48
        + ball2_pose_6 * ball2_twist_49;
    work[576] = ball2_G_5;
    const real ball2_G_6 = ball2_pose_4 * ball2_twist_50 + ball2_pose_5 * ball2_twist_51
        + ball2_pose_6 * ball2_twist_52;
    work[577] = ball2_G_6;
    const real ball2_G_7 = ball2_pose_4 * ball2_twist_53 + ball2_pose_5 * ball2_twist_54
        + ball2_pose_6 * ball2_twist_55;
    work[578] = ball2_G_7;
    const real ball2_G_8 = ball2_pose_4 * ball2_twist_56 + ball2_pose_5 * ball2_twist_57
        + ball2_pose_6 * ball2_twist_58;
    work[579] = ball2_G_8;
    const real ball2_G_9 = ball2_pose_4 * ball2_pose_10 + ball2_pose_5 * ball2_pose_11
        + ball2_pose_6 * ball2_pose_12;
    work[580] = ball2_G_9;
    const real ball2_G_10 = ball2_pose_7 * ball2_twist_38 + ball2_pose_8 * ball2_twist_39
        + ball2_pose_9 * ball2_twist_40;
    work[581] = ball2_G_10;
    const real ball2_G_11 = ball2_pose_7 * ball2_twist_41 + ball2_pose_8 * ball2_twist_42
        + ball2_pose_9 * ball2_twist_43;
    work[582] = ball2_G_11;
    const real ball2_G_12 = ball1_twist_10 * ball2_pose_7 + ball1_twist_11 * ball2_pose_8
        + ball1_twist_12 * ball2_pose_9;
    work[583] = ball2_G_12;
    const real ball2_G_13 = ball2_pose_7 * ball2_twist_44 + ball2_pose_8 * ball2_twist_45
        + ball2_pose_9 * ball2_twist_46;
    work[584] = ball2_G_13;
    const real ball2_G_14 = ball2_pose_7 * ball2_twist_47 + ball2_pose_8 * ball2_twist_48
        + ball2_pose_9 * ball2_twist_49;
    work[585] = ball2_G_14;
    const real ball2_G_15 = ball2_pose_7 * ball2_twist_50 + ball2_pose_8 * ball2_twist_51
        + ball2_pose_9 * ball2_twist_52;
    work[586] = ball2_G_15;
    const real ball2_G_16 = ball2_pose_7 * ball2_twist_53 + ball2_pose_8 * ball2_twist_54
        + ball2_pose_9 * ball2_twist_55;
    work[587] = ball2_G_16;
    const real ball2_G_17 = ball2_pose_7 * ball2_twist_56 + ball2_pose_8 * ball2_twist_57
        + ball2_pose_9 * ball2_twist_58;
    work[588] = ball2_G_17;
    const real ball2_G_18 = ball2_pose_7 * ball2_pose_10 + ball2_pose_8 * ball2_pose_11
        + ball2_pose_9 * ball2_pose_12;
    work[589] = ball2_G_18;
    const real ball2_G_19 = ball2_pose_10 * ball2_twist_38 + ball2_pose_11 * ball2_twist_39
        + ball2_pose_12 * ball2_twist_40;
    work[590] = ball2_G_19;
    const real ball2_G_20 = ball2_pose_10 * ball2_twist_41 + ball2_pose_11 * ball2_twist_42
        + ball2_pose_12 * ball2_twist_43;
    work[591] = ball2_G_20;
    const real ball2_G_21 = ball1_twist_10 * ball2_pose_10 + ball1_twist_11 * ball2_pose_11
        + ball1_twist_12 * ball2_pose_12;
    work[592] = ball2_G_21;
    const real ball2_G_22 = ball2_pose_10 * ball2_twist_44 + ball2_pose_11 * ball2_twist_45
        + ball2_pose_12 * ball2_twist_46;
    work[593] = ball2_G_22;
    const real ball2_G_23 = ball2_pose_10 * ball2_twist_47 + ball2_pose_11 * ball2_twist_48
        + ball2_pose_12 * ball2_twist_49;
    work[594] = ball2_G_23;
    const real ball2_G_24 = ball2_pose_10 * ball2_twist_50 + ball2_pose_11 * ball2_twist_51
        + ball2_pose_12 * ball2_twist_52;
    work[595] = ball2_G_24;
    const real ball2_G_25 = ball2_pose_10 * ball2_twist_53 + ball2_pose_11 * ball2_twist_54
        + ball2_pose_12 * ball2_twist_55;
    work[596] = ball2_G_25;
    const real ball2_G_26 = ball2_pose_10 * ball2_twist_56 + ball2_pose_11 * ball2_twist_57
        + ball2_pose_12 * ball2_twist_58;
    work[597] = ball2_G_26;
    const real ball2_G_27 = ball2_pose_10 * ball2_pose_10 + ball2_pose_11 * ball2_pose_11
        + ball2_pose_12 * ball2_pose_12;
    work[598] = ball2_G_27;

    /* tube2: omega, alpha, inertia, composite inertia, a, U, inertia force */
    const real slide2_q = q[12]; /* m */
    const wreal tube2_first_moment_z = w[20];
    const wreal tube2_inertia = w[46];
    const wreal rod2_base_moment_z = w[47];
    const wreal tube2_base_inertia_xx = w[63];
    const wreal tube2_base_inertia_yy = w[64];
    const wreal tube2_base_second_moment_xx = w[86];
    const wreal tube2_base_second_moment_zz = w[88];
    const real tube2_omega_x = hooke2_u_angle1 * hooke2_cos_2;
    work[599] = tube2_omega_x;
    const real tube2_omega_z = hooke2_u_angle1 * hooke2_sin_2;
    work[600] = tube2_omega_z;
    const real tube2_alpha_z = hooke2_cos_2 * hooke2_drift;
    work[601] = tube2_alpha_z;
    const real tube2_inertia_2 = slide2_q * (rod2_base_moment_z + slide2_q * tube2_inertia) * 2.0;
    const real tube2_composite_inertia_xx = tube2_base_inertia_xx + tube2_inertia_2;
    work[602] = tube2_composite_inertia_xx;
    const real tube2_composite_inertia_yy = tube2_base_inertia_yy + tube2_inertia_2;
    work[603] = tube2_composite_inertia_yy;
    const real tube2_a_x = gravity_z * hooke2_R_2;
    work[604] = tube2_a_x;
    const real tube2_a = gravity_z * hooke2_sin;
    work[605] = tube2_a;
    const real tube2_U_xz = tube2_omega_x * tube2_omega_z;
    work[606] = tube2_U_xz;
    const real tube2_inertia_force = tube2_base_second_moment_zz * tube2_U_xz
        - tube2_base_second_moment_xx * tube2_U_xz + tube2_first_moment_z * tube2_a_x;
    work[607] = tube2_inertia_force;

    /* ball2: twist */
    const real slide2_u = u[11]; /* m/s */
    const real ball2_twist_59 = hooke2_cos_2 * tube2_omega_x + hooke2_sin_2 * tube2_omega_z;
    work[608] = ball2_twist_59;
    const real ball2_twist_60 = hooke2_R_yx * tube2_omega_x + hooke2_u_angle2 * hooke2_cos
        - hooke2_R * tube2_omega_z;
    work[609] = ball2_twist_60;
    const real ball2_twist_61 = hooke2_u_angle2 * hooke2_sin - hooke2_R_2 * tube2_omega_x
        + hooke2_R_zz * tube2_omega_z;
    work[610] = ball2_twist_61;
    const real ball2_twist_62 = ball2_twist_24 - (ball2_pose_3 * ball2_twist_60
        - ball2_twist_28 * ball2_twist_61) - slide2_u * hooke2_sin_2;
    work[611] = ball2_twist_62;
    const real ball2_twist_63 = ball2_twist_25 - (ball2_twist_27 * ball2_twist_61
        - ball2_pose_3 * ball2_twist_59) + slide2_u * hooke2_R;
    work[612] = ball2_twist_63;
    const real ball2_twist_64 = ball2_twist_26 - (ball2_twist_28 * ball2_twist_59
        - ball2_twist_27 * ball2_twist_60) - slide2_u * hooke2_R_zz;
    work[613] = ball2_twist_64;
    const real ball2_twist_65 = ball1_pose * ball2_twist_62 + ball1_pose_4 * ball2_twist_63
        + ball1_pose_7 * ball2_twist_64;
    work[614] = ball2_twist_65;
    const real ball2_twist_66 = ball1_pose_2 * ball2_twist_62 + ball1_pose_5 * ball2_twist_63
        + ball1_pose_8 * ball2_twist_64;
    work[615] = ball2_twist_66;
    const real ball2_twist_67 = ball1_pose_3 * ball2_twist_62 + ball1_pose_6 * ball2_twist_63
        + ball1_pose_9 * ball2_twist_64;
    work[616] = ball2_twist_67;

    /* hooke3: R, drift, momentum mz */
    const real hooke3_u_angle1 = u[12]; /* rad/s */
    const real hooke3_u_angle2 = u[13]; /* rad/s */
    const wreal tube3_base_inertia_zz = w[62];
    const real hooke3_R_yx = hooke3_sin * hooke3_sin_2;
    work[617] = hooke3_R_yx;
    const real hooke3_R = hooke3_sin * hooke3_cos_2;
    work[618] = hooke3_R;
    const real hooke3_R_2 = hooke3_cos * hooke3_sin_2;
    work[619] = hooke3_R_2;
    const real hooke3_R_zz = hooke3_cos * hooke3_cos_2;
    work[620] = hooke3_R_zz;
    const real hooke3_drift = hooke3_u_angle1 * hooke3_u_angle2;
    const real hooke3_drift_2 = hooke3_sin_2 * hooke3_drift;
    work[621] = hooke3_drift_2;
    const real hooke3_momentum_mz = tube3_base_inertia_zz * hooke3_sin_2;
    work[622] = hooke3_momentum_mz;

    /* ball3: pose, twist, G */
    const wreal hooke3_position_x = w[22]; /* m */
    const wreal hooke3_position_y = w[23]; /* m */
    const wreal ball3_placement = w[38];
    const wreal ball3_placement_2 = w[39];
    const real ball3_pose = ball3_placement * ball1_pose + ball3_placement_2 * ball1_pose_2
        + ball1_pose_10;
    const real ball3_pose_2 = ball3_placement * ball1_pose_4 + ball3_placement_2 * ball1_pose_5
        + ball1_pose_11;
    const real ball3_pose_3 = ball3_placement * ball1_pose_7 + ball3_placement_2 * ball1_pose_8
        + ball1_pose_12;
    work[623] = ball3_pose_3;
    const real ball3_pose_4 = ball1_pose * hooke3_cos_2 + ball1_pose_4 * hooke3_R_yx
        - ball1_pose_7 * hooke3_R_2;
    work[624] = ball3_pose_4;
    const real ball3_pose_5 = ball1_pose_2 * hooke3_cos_2 + ball1_pose_5 * hooke3_R_yx
        - ball1_pose_8 * hooke3_R_2;
    work[625] = ball3_pose_5;
    const real ball3_pose_6 = ball1_pose_3 * hooke3_cos_2 + ball1_pose_6 * hooke3_R_yx
        - ball1_pose_9 * hooke3_R_2;
    work[626] = ball3_pose_6;
    const real ball3_pose_7 = ball1_pose_4 * hooke3_cos + ball1_pose_7 * hooke3_sin;
    work[627] = ball3_pose_7;
    const real ball3_pose_8 = ball1_pose_5 * hooke3_cos + ball1_pose_8 * hooke3_sin;
    work[628] = ball3_pose_8;
    const real ball3_pose_9 = ball1_pose_6 * hooke3_cos + ball1_pose_9 * hooke3_sin;
    work[629] = ball3_pose_9;
    const real ball3_pose_10 = ball1_pose * hooke3_sin_2 - ball1_pose_4 * hooke3_R
        + ball1_pose_7 * hooke3_R_zz;
    work[630] = ball3_pose_10;
    const real ball3_pose_11 = ball1_pose_2 * hooke3_sin_2 - ball1_pose_5 * hooke3_R
        + ball1_pose_8 * hooke3_R_zz;
    work[631] = ball3_pose_11;
    const real ball3_pose_12 = ball1_pose_3 * hooke3_sin_2 - ball1_pose_6 * hooke3_R
        + ball1_pose_9 * hooke3_R_zz;
    work[632] = ball3_pose_12;
    const real ball3_twist = ball3_pose - hooke0_position_x;
    work[633] = ball3_twist;
    const real ball3_twist_2 = ball3_pose_2 - hooke0_position_y;
    work[634] = ball3_twist_2;
    const real ball3_twist_3 = ball1_twist_2 * ball3_pose_3 - ball1_twist_3 * ball3_twist_2;
    const real ball3_twist_4 = ball1_twist_3 * ball3_twist - ball1_twist * ball3_pose_3;
    const real ball3_twist_5 = ball1_twist * ball3_twist_2 - ball1_twist_2 * ball3_twist;
    const real ball3_twist_6 = hooke0_cos * ball3_pose_3 - hooke0_sin * ball3_twist_2;
    const real ball3_twist_7 = hooke0_sin * ball3_twist;
    const real ball3_twist_8 = hooke0_cos * ball3_twist;
    const real ball3_twist_9 = ball1_twist_66 * ball3_pose_3 - ball1_twist_67 * ball3_twist_2
        + ball1_twist_4;
    const real ball3_twist_10 = ball1_twist_67 * ball3_twist - ball1_twist_65 * ball3_pose_3
        - ball1_twist_5;
    const real ball3_twist_11 = ball1_twist_65 * ball3_twist_2 - ball1_twist_66 * ball3_twist
        + ball1_twist_6;
    const real ball3_twist_12 = ball3_pose - ball1_pose_10;
    work[635] = ball3_twist_12;
    const real ball3_twist_13 = ball3_pose_2 - ball1_pose_11;
    work[636] = ball3_twist_13;
    const real ball3_twist_14 = ball3_pose_3 - ball1_pose_12;
    work[637] = ball3_twist_14;
    const real ball3_twist_15 = ball1_pose_4 * ball3_twist_14 - ball1_pose_7 * ball3_twist_13;
    const real ball3_twist_16 = ball1_pose_7 * ball3_twist_12 - ball1_pose * ball3_twist_14;
    const real ball3_twist_17 = ball1_pose * ball3_twist_13 - ball1_pose_4 * ball3_twist_12;
    const real ball3_twist_18 = ball1_pose_5 * ball3_twist_14 - ball1_pose_8 * ball3_twist_13;
    const real ball3_twist_19 = ball1_pose_8 * ball3_twist_12 - ball1_pose_2 * ball3_twist_14;
    const real ball3_twist_20 = ball1_pose_2 * ball3_twist_13 - ball1_pose_5 * ball3_twist_12;
    const real ball3_twist_21 = ball1_pose_6 * ball3_twist_14 - ball1_pose_9 * ball3_twist_13;
    const real ball3_twist_22 = ball1_pose_9 * ball3_twist_12 - ball1_pose_3 * ball3_twist_14;
    const real ball3_twist_23 = ball1_pose_3 * ball3_twist_13 - ball1_pose_6 * ball3_twist_12;
    const real ball3_twist_24 = ball1_twist_8 * ball3_twist_14 - ball1_twist_9 * ball3_twist_13
        + ball3_twist_9;
    const real ball3_twist_25 = ball1_twist_9 * ball3_twist_12 - ball1_twist_7 * ball3_twist_14
        + ball3_twist_10;
    const real ball3_twist_26 = ball1_twist_7 * ball3_twist_13 - ball1_twist_8 * ball3_twist_12
        + ball3_twist_11;
    const real ball3_twist_27 = ball3_pose - hooke3_position_x;
    work[638] = ball3_twist_27;
    const real ball3_twist_28 = ball3_pose_2 - hooke3_position_y;
    work[639] = ball3_twist_28;
    const real ball3_twist_29 = hooke3_cos_2 * hooke3_cos_2 + hooke3_sin_2 * hooke3_sin_2;
    const real ball3_twist_30 = hooke3_cos_2 * hooke3_R_yx - hooke3_sin_2 * hooke3_R;
    const real ball3_twist_31 = hooke3_sin_2 * hooke3_R_zz - hooke3_cos_2 * hooke3_R_2;
    const real ball3_twist_32 = ball3_pose_3 * ball3_twist_30 - ball3_twist_28 * ball3_twist_31;
    const real ball3_twist_33 = ball3_twist_27 * ball3_twist_31 - ball3_pose_3 * ball3_twist_29;
    const real ball3_twist_34 = ball3_twist_28 * ball3_twist_29 - ball3_twist_27 * ball3_twist_30;
    const real ball3_twist_35 = hooke3_cos * ball3_pose_3 - hooke3_sin * ball3_twist_28;
    const real ball3_twist_36 = hooke3_sin * ball3_twist_27;
    const real ball3_twist_37 = hooke3_cos * ball3_twist_27;
    const real ball3_twist_38 = ball1_pose * ball3_twist_3 + ball1_pose_4 * ball3_twist_4
        + ball1_pose_7 * ball3_twist_5;
    const real ball3_twist_39 = ball1_pose_2 * ball3_twist_3 + ball1_pose_5 * ball3_twist_4
        + ball1_pose_8 * ball3_twist_5;
    const real ball3_twist_40 = ball1_pose_3 * ball3_twist_3 + ball1_pose_6 * ball3_twist_4
        + ball1_pose_9 * ball3_twist_5;
    const real ball3_twist_41 = ball1_pose * ball3_twist_6 + ball1_pose_4 * ball3_twist_7
        - ball1_pose_7 * ball3_twist_8;
    const real ball3_twist_42 = ball1_pose_2 * ball3_twist_6 + ball1_pose_5 * ball3_twist_7
        - ball1_pose_8 * ball3_twist_8;
    const real ball3_twist_43 = ball1_pose_3 * ball3_twist_6 + ball1_pose_6 * ball3_twist_7
        - ball1_pose_9 * ball3_twist_8;
    const real ball3_twist_44 = ball1_pose * ball3_twist_15 + ball1_pose_4 * ball3_twist_16
        + ball1_pose_7 * ball3_twist_17;
    const real ball3_twist_45 = ball1_pose_2 * ball3_twist_15 + ball1_pose_5 * ball3_twist_16
        + ball1_pose_8 * ball3_twist_17;
    const real ball3_twist_46 = ball1_pose_3 * ball3_twist_15 + ball1_pose_6 * ball3_twist_16
        + ball1_pose_9 * ball3_twist_17;
    const real ball3_twist_47 = ball1_pose * ball3_twist_18 + ball1_pose_4 * ball3_twist_19
        + ball1_pose_7 * ball3_twist_20;
    const real ball3_twist_48 = ball1_pose_2 * ball3_twist_18 + ball1_pose_5 * ball3_twist_19
        + ball1_pose_8 * ball3_twist_20;
    const real ball3_twist_49 = ball1_pose_3 * ball3_twist_18 + ball1_pose_6 * ball3_twist_19
        + ball1_pose_9 * ball3_twist_20;
    const real ball3_twist_50 = ball1_pose * ball3_twist_21 + ball1_pose_4 * ball3_twist_22
        + ball1_pose_7 * ball3_twist_23;
    const real ball3_twist_51 = ball1_pose_2 * ball3_twist_21 + ball1_pose_5 * ball3_twist_22
        + ball1_pose_8 * ball3_twist_23;
    const real ball3_twist_52 = ball1_pose_3 * ball3_twist_21 + ball1_pose_6 * ball3_twist_22
        + ball1_pose_9 * ball3_twist_23;
    const real ball3_twist_53 = ball1_pose * ball3_twist_32 + ball1_pose_4 * ball3_twist_33
        + ball1_pose_7 * ball3_twist_34;
    const real ball3_twist_54 = ball1_pose_2 * ball3_twist_32 + ball1_pose_5 * ball3_twist_33
        + ball1_pose_8 * ball3_twist_34;
    const real ball3_twist_55 = ball1_pose_3 * ball3_twist_32 + ball1_pose_6 * ball3_twist_33
        + ball1_pose_9 * ball3_twist_34;
    const real ball3_twist_56 = ball1_pose_7 * ball3_twist_37 - (ball1_pose * ball3_twist_35
        + ball1_pose_4 * ball3_twist_36);
    const real ball3_twist_57 = ball1_pose_8 * ball3_twist_37 - (ball1_pose_2 * ball3_twist_35
        + ball1_pose_5 * ball3_twist_36);
    const real ball3_twist_58 = ball1_pose_9 * ball3_twist_37 - (ball1_pose_3 * ball3_twist_35
        + ball1_pose_6 * ball3_twist_36);
    const real ball3_G = ball3_pose_4 * ball3_twist_38 + ball3_pose_5 * ball3_twist_39
        + ball3_pose_6 * ball3_twist_40;
    work[640] = ball3_G;
    const real ball3_G_2 = ball3_pose_4 * ball3_twist_41 + ball3_pose_5 * ball3_twist_42
        + ball3_pose_6 * ball3_twist_43;
    work[641] = ball3_G_2;
    const real ball3_G_3 = ball1_twist_10 * ball3_pose_4 + ball1_twist_11 * ball3_pose_5
        + ball1_twist_12 * ball3_pose_6;
    work[642] = ball3_G_3;
    const real ball3_G_4 = ball3_pose_4 * ball3_twist_44 + ball3_pose_5 * ball3_twist_45
        + ball3_pose_6 * ball3_twist_46;
    work[643] = ball3_G_4;
    const real ball3_G_5 = ball3_pose_4 * ball3_twist_47 + ball3_pose_5 * ball3_twist_48
        + ball3_pose_6 * ball3_twist_49;
    work[644] = ball3_G_5;
    const real ball3_G_6 = ball3_pose_4 * ball3_twist_50 + ball3_pose_5 * ball3_twist_51
        + ball3_pose_6 * ball3_twist_52;
    work[645] = ball3_G_6;
    const real ball3_G_7 = ball3_pose_4 * ball3_twist_53 + ball3_pose_5 * ball3_twist_54
        + ball3_pose_6 * ball3_twist_55;
    work[646] = ball3_G_7;
    const real ball3_G_8 = ball3_pose_4 * ball3_twist_56 + ball3_pose_5 * ball3_twist_57
        + ball3_pose_6 * ball3_twist_58;
    work[647] = ball3_G_8;
    const real ball3_G_9 = ball3_pose_4 * ball3_pose_10 + ball3_pose_5 * ball3_pose_11
        + ball3_pose_6 * ball3_pose_12;
    work[648] = ball3_G_9;
    const real ball3_G_10 = ball3_pose_7 * ball3_twist_38 + ball3_pose_8 * ball3_twist_39
        + ball3_pose_9 * ball3_twist_40;
    work[649] = ball3_G_10;
    const real ball3_G_11 = ball3_pose_7 * ball3_twist_41 + ball3_pose_8 * ball3_twist_42
        + ball3_pose_9 * ball3_twist_43;
    work[650] = ball3_G_11;
    const real ball3_G_12 = ball1_twist_10 * ball3_pose_7 + ball1_twist_11 * ball3_pose_8
        + ball1_twist_12 * ball3_pose_9;
    work[651] = ball3_G_12;
    const real ball3_G_13 = ball3_pose_7 * ball3_twist_44 + ball3_pose_8 * ball3_twist_45
        + ball3_pose_9 * ball3_twist_46;
    work[652] = ball3_G_13;
    const real ball3_G_14 = ball3_pose_7 * ball3_twist_47 + ball3_pose_8 * ball3_twist_48
        + ball3_pose_9 * ball3_twist_49;
    work[653] = ball3_G_14;
    const real ball3_G_15 = ball3_pose_7 * ball3_twist_50 + ball3_pose_8 * ball3_twist_51
        + ball3_pose_9 * ball3_twist_52;
    work[654] = ball3_G_15;
    const real ball3_G_16 = ball3_pose_7 * ball3_twist_53 + ball3_pose_8 * ball3_twist_54
        + ball3_pose_9 * ball3_twist_55;
    work[655] = ball3_G_16;
    const real ball3_G_17 = ball3_pose_7 * ball3_twist_56 + ball3_pose_8 * ball3_twist_57
        + ball3_pose_9 * ball3_twist_58;
    work[656] = ball3_G_17;
    const real ball3_G_18 = ball3_pose_7 * ball3_pose_10 + ball3_pose_8 * ball3_pose_11
        + ball3_pose_9 * ball3_pose_12;
    work[657] = ball3_G_18;
    const real ball3_G_19 = ball3_pose_10 * ball3_twist_38 + ball3_pose_11 * ball3_twist_39
        + ball3_pose_12 * ball3_twist_40;
    work[658] = ball3_G_19;
    const real ball3_G_20 = ball3_pose_10 * ball3_twist_41 + ball3_pose_11 * ball3_twist_42
        + ball3_pose_12 * ball3_twist_43;
    work[659] = ball3_G_20;
    const real ball3_G_21 = ball1_twist_10 * ball3_pose_10 + ball1_twist_11 * ball3_pose_11
        + ball1_twist_12 * ball3_pose_12;
    work[660] = ball3_G_21;
    const real ball3_G_22 = ball3_pose_10 * ball3_twist_44 + ball3_pose_11 * ball3_twist_45
        + ball3_pose_12 * ball3_twist_46;
    work[661] = ball3_G_22;
    const real ball3_G_23 = ball3_pose_10 * ball3_twist_47 + ball3_pose_11 * ball3_twist_48
        + ball3_pose_12 * ball3_twist_49;
    work[662] = ball3_G_23;
    const real ball3_G_24 = ball3_pose_10 * ball3_twist_50 + ball3_pose_11 * ball3_twist_51
        + ball3_pose_12 * ball3_twist_52;
    work[663] = ball3_G_24;
    const real ball3_G_25 = ball3_pose_10 * ball3_twist_53 + ball3_pose_11 * ball3_twist_54
        + ball3_pose_12 * ball3_twist_55;
    work[664] = ball3_G_25;
    const real ball3_G_26 = ball3_pose_10 * ball3_twist_56 + ball3_pose_11 * ball3_twist_57
        + ball3_pose_12 * ball3_twist_58;
    work[665] = ball3_G_26;
    const real ball3_G_27 = ball3_pose_10 * ball3_pose_10 + ball3_pose_11 * ball3_pose_11
        + ball3_pose_12 * ball3_pose_12;
    work[666] = ball3_G_27;

    /* tube3: omega, alpha, inertia, composite inertia, a, U, inertia force */
    const real slide3_q = q[15]; /* m */
    const wreal tube3_first_moment_z = w[24];
    const wreal tube3_inertia = w[48];
    const wreal rod3_base_moment_z = w[49];
    const wreal tube3_base_inertia_xx = w[60];
    const wreal tube3_base_inertia_yy = w[61];
    const wreal tube3_base_second_moment_xx = w[83];
    const wreal tube3_base_second_moment_zz = w[85];
    const real tube3_omega_x = hooke3_u_angle1 * hooke3_cos_2;
    work[667] = tube3_omega_x;
    const real tube3_omega_z = hooke3_u_angle1 * hooke3_sin_2;
    work[668] = tube3_omega_z;
    const real tube3_alpha_z = hooke3_cos_2 * hooke3_drift;
    work[669] = tube3_alpha_z;
    const real tube3_inertia_2 = slide3_q * (rod3_base_moment_z + slide3_q * tube3_inertia) * 2.0;
    const real tube3_composite_inertia_xx = tube3_base_inertia_xx + tube3_inertia_2;
    work[670] = tube3_composite_inertia_xx;
    const real tube3_composite_inertia_yy = tube3_base_inertia_yy + tube3_inertia_2;
    work[671] = tube3_composite_inertia_yy;
    const real tube3_a_x = gravity_z * hooke3_R_2;
    work[672] = tube3_a_x;
    const real tube3_a = gravity_z * hooke3_sin;
    work[673] = tube3_a;
    const real tube3_U_xz = tube3_omega_x * tube3_omega_z;
    work[674] = tube3_U_xz;
    const real tube3_inertia_force = tube3_base_second_moment_zz * tube3_U_xz
        - tube3_base_second_moment_xx * tube3_U_xz + tube3_first_moment_z * tube3_a_x;
    work[675] = tube3_inertia_force;

    /* ball3: twist */
    const real slide3_u = u[14]; /* m/s */
    const real ball3_twist_59 = hooke3_cos_2 * tube3_omega_x + hooke3_sin_2 * tube3_omega_z;
    work[676] = ball3_twist_59;
    const real ball3_twist_60 = hooke3_R_yx * tube3_omega_x + hooke3_u_angle2 * hooke3_cos
        - hooke3_R * tube3_omega_z;
    work[677] = ball3_twist_60;
    const real ball3_twist_61 = hooke3_u_angle2 * hooke3_sin - hooke3_R_2 * tube3_omega_x
        + hooke3_R_zz * tube3_omega_z;
    work[678] = ball3_twist_61;
    const real ball3_twist_62 = ball3_twist_24 - (ball3_pose_3 * ball3_twist_60
        - ball3_twist_28 * ball3_twist_61) - slide3_u * hooke3_sin_2;
    work[679] = ball3_twist_62;
    const real ball3_twist_63 = ball3_twist_25 - (ball3_twist_27 * ball3_twist_61
        - ball3_pose_3 * ball3_twist_59) + slide3_u * hooke3_R;
    work[680] = ball3_twist_63;
    const real ball3_twist_64 = ball3_twist_26 - (ball3_twist_28 * ball3_twist_59
        - ball3_twist_27 * ball3_twist_60) - slide3_u * hooke3_R_zz;
    work[681] = ball3_twist_64;
    const real ball3_twist_65 = ball1_pose * ball3_twist_62 + ball1_pose_4 * ball3_twist_63
        + ball1_pose_7 * ball3_twist_64;
    work[682] = ball3_twist_65;
    const real ball3_twist_66 = ball1_pose_2 * ball3_twist_62 + ball1_pose_5 * ball3_twist_63
        + ball1_pose_8 * ball3_twist_64;
    work[683] = ball3_twist_66;
    const real ball3_twist_67 = ball1_pose_3 * ball3_twist_62 + ball1_pose_6 * ball3_twist_63
        + ball1_pose_9 * ball3_twist_64;
    work[684] = ball3_twist_67;

    /* hooke4: R, drift, momentum mz */
    const real hooke4_u_angle1 = u[15]; /* rad/s */
    const real hooke4_u_angle2 = u[16]; /* rad/s */
    const wreal tube4_base_inertia_zz = w[59];
    const real hooke4_R_yx = hooke4_sin * hooke4_sin_2;
    work[685] = hooke4_R_yx;
    const real hooke4_R = hooke4_sin * hooke4_cos_2;
    work[686] = hooke4_R;
    const real hooke4_R_2 = hooke4_cos * hooke4_sin_2;
    work[687] = hooke4_R_2;
    const real hooke4_R_zz = hooke4_cos * hooke4_cos_2;
    work[688] = hooke4_R_zz;
    const real hooke4_drift = hooke4_u_angle1 * hooke4_u_angle2;
    work[689] = hooke4_drift;
    const real hooke4_drift_2 = hooke4_sin_2 * hooke4_drift;
    work[690] = hooke4_drift_2;
    const real hooke4_momentum_mz = tube4_base_inertia_zz * hooke4_sin_2;
    work[691] = hooke4_momentum_mz;
    return CARDAN_OK;
}

CARDAN_PART int forward_dynamics_part2(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const real *const r = in->r;
    const wreal *const w = in->w;
    const real *const tau = in->tau;
    (void)out;

    /* ball4: pose, twist, G */
    const wreal hooke0_position_x = w[1]; /* m */
    const wreal hooke0_position_y = w[2]; /* m */
    const wreal hooke4_position_x = w[26]; /* m */
    const wreal hooke4_position_y = w[27]; /* m */
    const wreal ball4_placement = w[40];
    const wreal ball4_placement_2 = w[41];
    const real ball1_pose_10 = work[444];
    const real ball1_pose = work[435];
    const real ball1_pose_2 = work[436];
    const real ball4_pose = ball4_placement * ball1_pose + ball4_placement_2 * ball1_pose_2
        + ball1_pose_10;
    const real ball1_pose_11 = work[445];
    const real ball1_pose_4 = work[438];
    const real ball1_pose_5 = work[439];
    const real ball4_pose_2 = ball4_placement * ball1_pose_4 + ball4_placement_2 * ball1_pose_5
        + ball1_pose_11;
    const real ball1_pose_12 = work[446];
    const real ball1_pose_7 = work[441];
    const real ball1_pose_8 = work[442];
    const real ball4_pose_3 = ball4_placement * ball1_pose_7 + ball4_placement_2 * ball1_pose_8
        + ball1_pose_12;
    work[692] = ball4_pose_3;
    const real hooke4_cos_2 = work[408];
    const real hooke4_R_yx = work[685];
    const real hooke4_R_2 = work[687];
    const real ball4_pose_4 = ball1_pose * hooke4_cos_2 + ball1_pose_4 * hooke4_R_yx
        - ball1_pose_7 * hooke4_R_2;
    work[693] = ball4_pose_4;
    const real ball4_pose_5 = ball1_pose_2 * hooke4_cos_2 + ball1_pose_5 * hooke4_R_yx
        - ball1_pose_8 * hooke4_R_2;
    work[694] = ball4_pose_5;
    const real ball1_pose_3 = work[437];
    const real ball1_pose_6 = work[440];
    const real ball1_pose_9 = work[443];
    const real ball4_pose_6 = ball1_pose_3 * hooke4_cos_2 + ball1_pose_6 * hooke4_R_yx
        - ball1_pose_9 * hooke4_R_2;
    work[695] = ball4_pose_6;
    const real hooke4_cos = work[406];
    const real hooke4_sin = work[407];
    const real ball4_pose_7 = ball1_pose_4 * hooke4_cos + ball1_pose_7 * hooke4_sin;
    work[696] = ball4_pose_7;
    const real ball4_pose_8 = ball1_pose_5 * hooke4_cos + ball1_pose_8 * hooke4_sin;
    work[697] = ball4_pose_8;
    const real ball4_pose_9 = ball1_pose_6 * hooke4_cos + ball1_pose_9 * hooke4_sin;
    work[698] = ball4_pose_9;
    const real hooke4_sin_2 = work[409];
    const real hooke4_R = work[686];
    const real hooke4_R_zz = work[688];
    const real ball4_pose_10 = ball1_pose * hooke4_sin_2 - ball1_pose_4 * hooke4_R
        + ball1_pose_7 * hooke4_R_zz;
    work[699] = ball4_pose_10;
    const real ball4_pose_11 = ball1_pose_2 * hooke4_sin_2 - ball1_pose_5 * hooke4_R
        + ball1_pose_8 * hooke4_R_zz;
    work[700] = ball4_pose_11;
    const real ball4_pose_12 = ball1_pose_3 * hooke4_sin_2 - ball1_pose_6 * hooke4_R
        + ball1_pose_9 * hooke4_R_zz;
    work[701] = ball4_pose_12;
    const real ball4_twist = ball4_pose - hooke0_position_x;
    work[702] = ball4_twist;
    const real ball4_twist_2 = ball4_pose_2 - hooke0_position_y;
    work[703] = ball4_twist_2;
    const real ball1_twist_2 = work[448];
    const real ball1_twist_3 = work[449];
    const real ball4_twist_3 = ball1_twist_2 * ball4_pose_3 - ball1_twist_3 * ball4_twist_2;
    const real ball1_twist = work[447];
    const real ball4_twist_4 = ball1_twist_3 * ball4_twist - ball1_twist * ball4_pose_3;
    const real ball4_twist_5 = ball1_twist * ball4_twist_2 - ball1_twist_2 * ball4_twist;
    const real hooke0_cos = work[390];
    const real hooke0_sin = work[391];
    const real ball4_twist_6 = hooke0_cos * ball4_pose_3 - hooke0_sin * ball4_twist_2;
    const real ball4_twist_7 = hooke0_sin * ball4_twist;
    const real ball4_twist_8 = hooke0_cos * ball4_twist;
    const real ball1_twist_4 = work[450];
    const real ball1_twist_66 = work[526];
    const real ball1_twist_67 = work[527];
    const real ball4_twist_9 = ball1_twist_66 * ball4_pose_3 - ball1_twist_67 * ball4_twist_2
        + ball1_twist_4;
    const real ball1_twist_65 = work[525];
    const real ball1_twist_5 = work[451];
    const real ball4_twist_10 = ball1_twist_67 * ball4_twist - ball1_twist_65 * ball4_pose_3
        - ball1_twist_5;
    const real ball1_twist_6 = work[452];
    const real ball4_twist_11 = ball1_twist_65 * ball4_twist_2 - ball1_twist_66 * ball4_twist
        + ball1_twist_6;
    const real ball4_twist_12 = ball4_pose - ball1_pose_10;
    work[704] = ball4_twist_12;
    const real ball4_twist_13 = ball4_pose_2 - ball1_pose_11;
    work[705] = ball4_twist_13;
    const real ball4_twist_14 = ball4_pose_3 - ball1_pose_12;
    work[706] = ball4_twist_14;
    const real ball4_twist_15 = ball1_pose_4 * ball4_twist_14 - ball1_pose_7 * ball4_twist_13;
    const real ball4_twist_16 = ball1_pose_7 * ball4_twist_12 - ball1_pose * ball4_twist_14;
    const real ball4_twist_17 = ball1_pose * ball4_twist_13 - ball1_pose_4 * ball4_twist_12;
    const real ball4_twist_18 = ball1_pose_5 * ball4_twist_14 - ball1_pose_8 * ball4_twist_13;
    const real ball4_twist_19 = ball1_pose_8 * ball4_twist_12 - ball1_pose_2 * ball4_twist_14;
    const real ball4_twist_20 = ball1_pose_2 * ball4_twist_13 - ball1_pose_5 * ball4_twist_12;
    const real ball4_twist_21 = ball1_pose_6 * ball4_twist_14 - ball1_pose_9 * ball4_twist_13;
    const real ball4_twist_22 = ball1_pose_9 * ball4_twist_12 - ball1_pose_3 * ball4_twist_14;
    const real ball4_twist_23 = ball1_pose_3 * ball4_twist_13 - ball1_pose_6 * ball4_twist_12;
    const real ball1_twist_8 = work[454];
    const real ball1_twist_9 = work[455];
    const real ball4_twist_24 = ball1_twist_8 * ball4_twist_14 - ball1_twist_9 * ball4_twist_13
        + ball4_twist_9;
    const real ball1_twist_7 = work[453];
    const real ball4_twist_25 = ball1_twist_9 * ball4_twist_12 - ball1_twist_7 * ball4_twist_14
        + ball4_twist_10;
    const real ball4_twist_26 = ball1_twist_7 * ball4_twist_13 - ball1_twist_8 * ball4_twist_12
        + ball4_twist_11;
    const real ball4_twist_27 = ball4_pose - hooke4_position_x;
    work[707] = ball4_twist_27;
    const real ball4_twist_28 = ball4_pose_2 - hooke4_position_y;
    work[708] = ball4_twist_28;
    const real ball4_twist_29 = hooke4_cos_2 * hooke4_cos_2 + hooke4_sin_2 * hooke4_sin_2;
    const real ball4_twist_30 = hooke4_cos_2 * hooke4_R_yx - hooke4_sin_2 * hooke4_R;
    const real ball4_twist_31 = hooke4_sin_2 * hooke4_R_zz - hooke4_cos_2 * hooke4_R_2;
    const real ball4_twist_32 = ball4_pose_3 * ball4_twist_30 - ball4_twist_28 * ball4_twist_31;
    const real ball4_twist_33 = ball4_twist_27 * ball4_twist_31 - ball4_pose_3 * ball4_twist_29;
    const real ball4_twist_34 = ball4_twist_28 * ball4_twist_29 - ball4_twist_27 * ball4_twist_30;
    const real ball4_twist_35 = hooke4_cos * ball4_pose_3 - hooke4_sin * ball4_twist_28;
    const real ball4_twist_36 = hooke4_sin * ball4_twist_27;
    const real ball4_twist_37 = hooke4_cos * ball4_twist_27;
    const real ball4_twist_38 = ball1_pose * ball4_twist_3 + ball1_pose_4 * ball4_twist_4
        + ball1_pose_7 * ball4_twist_5;
    const real ball4_twist_39 = ball1_pose_2 * ball4_twist_3 + ball1_pose_5 * ball4_twist_4
        + ball1_pose_8 * ball4_twist_5;
    const real ball4_twist_40 = ball1_pose_3 * ball4_twist_3 + ball1_pose_6 * ball4_twist_4
        + ball1_pose_9 * ball4_twist_5;
    const real ball4_twist_41 = ball1_pose * ball4_twist_6 + ball1_pose_4 * ball4_twist_7
        - ball1_pose_7 * ball4_twist_8;
    const real ball4_twist_42 = ball1_pose_2 * ball4_twist_6 + ball1_pose_5 * ball4_twist_7
        - ball1_pose_8 * ball4_twist_8;
    const real ball4_twist_43 = ball1_pose_3 * ball4_twist_6 + ball1_pose_6 * ball4_twist_7
        - ball1_pose_9 * ball4_twist_8;
    const real ball4_twist_44 = ball1_pose * ball4_twist_15 + ball1_pose_4 * ball4_twist_16
        + ball1_pose_7 * ball4_twist_17;
    const real ball4_twist_45 = ball1_pose_2 * ball4_twist_15 + ball1_pose_5 * ball4_twist_16
        + ball1_pose_8 * ball4_twist_17;
    const real ball4_twist_46 = ball1_pose_3 * ball4_twist_15 + ball1_pose_6 * ball4_twist_16
        + ball1_pose_9 * ball4_twist_17;
    const real ball4_twist_47 = ball1_pose * ball4_twist_18 + ball1_pose_4 * ball4_twist_19
        + ball1_pose_7 * ball4_twist_20;
    const real ball4_twist_48 = ball1_pose_2 * ball4_twist_18 + ball1_pose_5 * ball4_twist_19
        + ball1_pose_8 * ball4_twist_20;
    const real ball4_twist_49 = ball1_pose_3 * ball4_twist_18 + ball1_pose_6 * ball4_twist_19
        + ball1_pose_9 * ball4_twist_20;
    const real ball4_twist_50 = ball1_pose * ball4_twist_21 + ball1_pose_4 * ball4_twist_22
        + ball1_pose_7 * ball4_twist_23;
    const real ball4_twist_51 = ball1_pose_2 * ball4_twist_21 + ball1_pose_5 * ball4_twist_22
        + ball1_pose_8 * ball4_twist_23;
    const real ball4_twist_52 = ball1_pose_3 * ball4_twist_21 + ball1_pose_6 * ball4_twist_22
        + ball1_pose_9 * ball4_twist_23;
    const real ball4_twist_53 = ball1_pose * ball4_twist_32 + ball1_pose_4 * ball4_twist_33
        + ball1_pose_7 * ball4_twist_34;
    const real ball4_twist_54 = ball1_pose_2 * ball4_twist_32 + ball1_pose_5 * ball4_twist_33
        + ball1_pose_8 * ball4_twist_34;
    const real ball4_twist_55 = ball1_pose_3 * ball4_twist_32 + ball1_pose_6 * ball4_twist_33
        + ball1_pose_9 * ball4_twist_34;
    const real ball4_twist_56 = ball1_pose_7 * ball4_twist_37 - (ball1_pose * ball4_twist_35
        + ball1_pose_4 * ball4_twist_36);
    const real ball4_twist_57 = ball1_pose_8 * ball4_twist_37 - (ball1_pose_2 * ball4_twist_35
        + ball1_pose_5 * ball4_twist_36);
    const real ball4_twist_58 = ball1_pose_9 * ball4_twist_37 - (ball1_pose_3 * ball4_twist_35
        + ball1_pose_6 * ball4_twist_36);
    const real ball4_G = ball4_pose_4 * ball4_twist_38 + ball4_pose_5 * ball4_twist_39
        + ball4_pose_6 * ball4_twist_40;
    work[709] = ball4_G;
    const real ball4_G_2 = ball4_pose_4 * ball4_twist_41 + ball4_pose_5 * ball4_twist_42
        + ball4_pose_6 * ball4_twist_43;
    work[710] = ball4_G_2;
    const real ball1_twist_10 = work[456];
    const real ball1_twist_11 = work[457];
    const real ball1_twist_12 = work[458];
    const real ball4_G_3 = ball1_twist_10 * ball4_pose_4 + ball1_twist_11 * ball4_pose_5
        + ball1_twist_12 * ball4_pose_6;
    work[711] = ball4_G_3;
    const real ball4_G_4 = ball4_pose_4 * ball4_twist_44 + ball4_pose_5 * ball4_twist_45
        + ball4_pose_6 * ball4_twist_46;
    work[712] = ball4_G_4;
    const real ball4_G_5 = ball4_pose_4 * ball4_twist_47 + ball4_pose_5 * ball4_twist_48
        + ball4_pose_6 * ball4_twist_49;
    work[713] = ball4_G_5;
    const real ball4_G_6 = ball4_pose_4 * ball4_twist_50 + ball4_pose_5 * ball4_twist_51
        + ball4_pose_6 * ball4_twist_52;
    work[714] = ball4_G_6;
    const real ball4_G_7 = ball4_pose_4 * ball4_twist_53 + ball4_pose_5 * ball4_twist_54
        + ball4_pose_6 * ball4_twist_55;
    work[715] = ball4_G_7;
    const real ball4_G_8 = ball4_pose_4 * ball4_twist_56 + ball4_pose_5 * ball4_twist_57
        + ball4_pose_6 * ball4_twist_58;
    work[716] = ball4_G_8;
    const real ball4_G_9 = ball4_pose_4 * ball4_pose_10 + ball4_pose_5 * ball4_pose_11
        + ball4_pose_6 * ball4_pose_12;
    work[717] = ball4_G_9;
    const real ball4_G_10 = ball4_pose_7 * ball4_twist_38 + ball4_pose_8 * ball4_twist_39
        + ball4_pose_9 * ball4_twist_40;
    work[718] = ball4_G_10;
    const real ball4_G_11 = ball4_pose_7 * ball4_twist_41 + ball4_pose_8 * ball4_twist_42
        + ball4_pose_9 * ball4_twist_43;
    work[719] = ball4_G_11;
    const real ball4_G_12 = ball1_twist_10 * ball4_pose_7 + ball1_twist_11 * ball4_pose_8
        + ball1_twist_12 * ball4_pose_9;
    work[720] = ball4_G_12;
    const real ball4_G_13 = ball4_pose_7 * ball4_twist_44 + ball4_pose_8 * ball4_twist_45
        + ball4_pose_9 * ball4_twist_46;
    work[721] = ball4_G_13;
    const real ball4_G_14 = ball4_pose_7 * ball4_twist_47 + ball4_pose_8 * ball4_twist_48
        + ball4_pose_9 * ball4_twist_49;
    work[722] = ball4_G_14;
    const real ball4_G_15 = ball4_pose_7 * ball4_twist_50 + ball4_pose_8 * ball4_twist_51
        + ball4_pose_9 * ball4_twist_52;
    work[723] = ball4_G_15;
    const real ball4_G_16 = ball4_pose_7 * ball4_twist_53 + ball4_pose_8 * ball4_twist_54
        + ball4_pose_9 * ball4_twist_55;
    work[724] = ball4_G_16;
    const real ball4_G_17 = ball4_pose_7 * ball4_twist_56 + ball4_pose_8 * ball4_twist_57
        + ball4_pose_9 * ball4_twist_58;
    work[725] = ball4_G_17;
    const real ball4_G_18 = ball4_pose_7 * ball4_pose_10 + ball4_pose_8 * ball4_pose_11
        + ball4_pose_9 * ball4_pose_12;
    work[726] = ball4_G_18;
    const real ball4_G_19 = ball4_pose_10 * ball4_twist_38 + ball4_pose_11 * ball4_twist_39
        + ball4_pose_12 * ball4_twist_40;
    work[727] = ball4_G_19;
    const real ball4_G_20 = ball4_pose_10 * ball4_twist_41 + ball4_pose_11 * ball4_twist_42
        + ball4_pose_12 * ball4_twist_43;
    work[728] = ball4_G_20;
    const real ball4_G_21 = ball1_twist_10 * ball4_pose_10 + ball1_twist_11 * ball4_pose_11
        + ball1_twist_12 * ball4_pose_12;
    work[729] = ball4_G_21;
    const real ball4_G_22 = ball4_pose_10 * ball4_twist_44 + ball4_pose_11 * ball4_twist_45
        + ball4_pose_12 * ball4_twist_46;
    work[730] = ball4_G_22;
    const real ball4_G_23 = ball4_pose_10 * ball4_twist_47 + ball4_pose_11 * ball4_twist_48
        + ball4_pose_12 * ball4_twist_49;
    work[731] = ball4_G_23;
    const real ball4_G_24 = ball4_pose_10 * ball4_twist_50 + ball4_pose_11 * ball4_twist_51
        + ball4_pose_12 * ball4_twist_52;
    work[732] = ball4_G_24;
    const real ball4_G_25 = ball4_pose_10 * ball4_twist_53 + ball4_pose_11 * ball4_twist_54
        + ball4_pose_12 * ball4_twist_55;
    work[733] = ball4_G_25;
    const real ball4_G_26 = ball4_pose_10 * ball4_twist_56 + ball4_pose_11 * ball4_twist_57
        + ball4_pose_12 * ball4_twist_58;
    work[734] = ball4_G_26;
    const real ball4_G_27 = ball4_pose_10 * ball4_pose_10 + ball4_pose_11 * ball4_pose_11
        + ball4_pose_12 * ball4_pose_12;
    work[735] = ball4_G_27;

    /* tube4: omega, alpha, inertia, composite inertia, a, U, inertia force */
    const real slide4_q = q[18]; /* m */
    const real hooke4_u_angle1 = u[15]; /* rad/s */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const wreal tube4_first_moment_z = w[28];
    const wreal tube4_inertia = w[50];
    const wreal rod4_base_moment_z = w[51];
    const wreal tube4_base_inertia_xx = w[57];
    const wreal tube4_base_inertia_yy = w[58];
    const wreal tube4_base_second_moment_xx = w[80];
    const wreal tube4_base_second_moment_zz = w[82];
    const real tube4_omega_x = hooke4_u_angle1 * hooke4_cos_2;
    work[736] = tube4_omega_x;
    const real tube4_omega_z = hooke4_u_angle1 * hooke4_sin_2;
    work[737] = tube4_omega_z;
    const real hooke4_drift = work[689];
    const real tube4_alpha_z = hooke4_cos_2 * hooke4_drift;
    const real tube4_inertia_2 = slide4_q * (rod4_base_moment_z + slide4_q * tube4_inertia) * 2.0;
    const real tube4_composite_inertia_xx = tube4_base_inertia_xx + tube4_inertia_2;
    const real tube4_composite_inertia_yy = tube4_base_inertia_yy + tube4_inertia_2;
    work[738] = tube4_composite_inertia_yy;
    const real tube4_a_x = gravity_z * hooke4_R_2;
    const real tube4_a = gravity_z * hooke4_sin;
    const real tube4_U_xz = tube4_omega_x * tube4_omega_z;
    const real tube4_inertia_force = tube4_base_second_moment_zz * tube4_U_xz
        - tube4_base_second_moment_xx * tube4_U_xz + tube4_first_moment_z * tube4_a_x;

    /* ball4: twist */
    const real hooke4_u_angle2 = u[16]; /* rad/s */
    const real slide4_u = u[17]; /* m/s */
    const real ball4_twist_59 = hooke4_cos_2 * tube4_omega_x + hooke4_sin_2 * tube4_omega_z;
    work[739] = ball4_twist_59;
    const real ball4_twist_60 = hooke4_R_yx * tube4_omega_x + hooke4_u_angle2 * hooke4_cos
        - hooke4_R * tube4_omega_z;
    work[740] = ball4_twist_60;
    const real ball4_twist_61 = hooke4_u_angle2 * hooke4_sin - hooke4_R_2 * tube4_omega_x
        + hooke4_R_zz * tube4_omega_z;
    work[741] = ball4_twist_61;
    const real ball4_twist_62 = ball4_twist_24 - (ball4_pose_3 * ball4_twist_60
        - ball4_twist_28 * ball4_twist_61) - slide4_u * hooke4_sin_2;
    work[742] = ball4_twist_62;
    const real ball4_twist_63 = ball4_twist_25 - (ball4_twist_27 * ball4_twist_61
        - ball4_pose_3 * ball4_twist_59) + slide4_u * hooke4_R;
    work[743] = ball4_twist_63;
    const real ball4_twist_64 = ball4_twist_26 - (ball4_twist_28 * ball4_twist_59
        - ball4_twist_27 * ball4_twist_60) - slide4_u * hooke4_R_zz;
    work[744] = ball4_twist_64;
    const real ball4_twist_65 = ball1_pose * ball4_twist_62 + ball1_pose_4 * ball4_twist_63
        + ball1_pose_7 * ball4_twist_64;
    work[745] = ball4_twist_65;
    const real ball4_twist_66 = ball1_pose_2 * ball4_twist_62 + ball1_pose_5 * ball4_twist_63
        + ball1_pose_8 * ball4_twist_64;
    work[746] = ball4_twist_66;
    const real ball4_twist_67 = ball1_pose_3 * ball4_twist_62 + ball1_pose_6 * ball4_twist_63
        + ball1_pose_9 * ball4_twist_64;
    work[747] = ball4_twist_67;

    /* hooke5: R, drift, momentum mz */
    const real hooke5_u_angle1 = u[18]; /* rad/s */
    const real hooke5_u_angle2 = u[19]; /* rad/s */
    const wreal tube5_base_inertia_zz = w[56];
    const real hooke5_sin = work[411];
    const real hooke5_sin_2 = work[413];
    const real hooke5_R_yx = hooke5_sin * hooke5_sin_2;
    work[748] = hooke5_R_yx;
    const real hooke5_cos_2 = work[412];
    const real hooke5_R = hooke5_sin * hooke5_cos_2;
    work[749] = hooke5_R;
    const real hooke5_cos = work[410];
    const real hooke5_R_2 = hooke5_cos * hooke5_sin_2;
    work[750] = hooke5_R_2;
    const real hooke5_R_zz = hooke5_cos * hooke5_cos_2;
    work[751] = hooke5_R_zz;
    const real hooke5_drift = hooke5_u_angle1 * hooke5_u_angle2;
    const real hooke5_drift_2 = hooke5_sin_2 * hooke5_drift;
    const real hooke5_momentum_mz = tube5_base_inertia_zz * hooke5_sin_2;

    /* ball5: pose, twist, G */
    const wreal hooke5_position_x = w[30]; /* m */
    const wreal hooke5_position_y = w[31]; /* m */
    const wreal ball5_placement = w[42];
    const wreal ball5_placement_2 = w[43];
    const real ball5_pose = ball5_placement * ball1_pose + ball5_placement_2 * ball1_pose_2
        + ball1_pose_10;
    const real ball5_pose_2 = ball5_placement * ball1_pose_4 + ball5_placement_2 * ball1_pose_5
        + ball1_pose_11;
    const real ball5_pose_3 = ball5_placement * ball1_pose_7 + ball5_placement_2 * ball1_pose_8
        + ball1_pose_12;
    work[752] = ball5_pose_3;
    const real ball5_pose_4 = ball1_pose * hooke5_cos_2 + ball1_pose_4 * hooke5_R_yx
        - ball1_pose_7 * hooke5_R_2;
    work[753] = ball5_pose_4;
    const real ball5_pose_5 = ball1_pose_2 * hooke5_cos_2 + ball1_pose_5 * hooke5_R_yx
        - ball1_pose_8 * hooke5_R_2;
    work[754] = ball5_pose_5;
    const real ball5_pose_6 = ball1_pose_3 * hooke5_cos_2 + ball1_pose_6 * hooke5_R_yx
        - ball1_pose_9 * hooke5_R_2;
    work[755] = ball5_pose_6;
    const real ball5_pose_7 = ball1_pose_4 * hooke5_cos + ball1_pose_7 * hooke5_sin;
    work[756] = ball5_pose_7;
    const real ball5_pose_8 = ball1_pose_5 * hooke5_cos + ball1_pose_8 * hooke5_sin;
    work[757] = ball5_pose_8;
    const real ball5_pose_9 = ball1_pose_6 * hooke5_cos + ball1_pose_9 * hooke5_sin;
    work[758] = ball5_pose_9;
    const real ball5_pose_10 = ball1_pose * hooke5_sin_2 - ball1_pose_4 * hooke5_R
        + ball1_pose_7 * hooke5_R_zz;
    work[759] = ball5_pose_10;
    const real ball5_pose_11 = ball1_pose_2 * hooke5_sin_2 - ball1_pose_5 * hooke5_R
        + ball1_pose_8 * hooke5_R_zz;
    work[760] = ball5_pose_11;
    const real ball5_pose_12 = ball1_pose_3 * hooke5_sin_2 - ball1_pose_6 * hooke5_R
        + ball1_pose_9 * hooke5_R_zz;
    work[761] = ball5_pose_12;
    const real ball5_twist = ball5_pose - hooke0_position_x;
    work[762] = ball5_twist;
    const real ball5_twist_2 = ball5_pose_2 - hooke0_position_y;
    work[763] = ball5_twist_2;
    const real ball5_twist_3 = ball1_twist_2 * ball5_pose_3 - ball1_twist_3 * ball5_twist_2;
    const real ball5_twist_4 = ball1_twist_3 * ball5_twist - ball1_twist * ball5_pose_3;
    const real ball5_twist_5 = ball1_twist * ball5_twist_2 - ball1_twist_2 * ball5_twist;
    const real ball5_twist_6 = hooke0_cos * ball5_pose_3 - hooke0_sin * ball5_twist_2;
    const real ball5_twist_7 = hooke0_sin * ball5_twist;
    const real ball5_twist_8 = hooke0_cos * ball5_twist;
    const real ball5_twist_9 = ball1_twist_66 * ball5_pose_3 - ball1_twist_67 * ball5_twist_2
        + ball1_twist_4;
    const real ball5_twist_10 = ball1_twist_67 * ball5_twist - ball1_twist_65 * ball5_pose_3
        - ball1_twist_5;
    const real ball5_twist_11 = ball1_twist_65 * ball5_twist_2 - ball1_twist_66 * ball5_twist
        + ball1_twist_6;
    const real ball5_twist_12 = ball5_pose - ball1_pose_10;
    work[764] = ball5_twist_12;
    const real ball5_twist_13 = ball5_pose_2 - ball1_pose_11;
    work[765] = ball5_twist_13;
    const real ball5_twist_14 = ball5_pose_3 - ball1_pose_12;
    work[766] = ball5_twist_14;
    const real ball5_twist_15 = ball1_pose_4 * ball5_twist_14 - ball1_pose_7 * ball5_twist_13;
    const real ball5_twist_16 = ball1_pose_7 * ball5_twist_12 - ball1_pose * ball5_twist_14;
    const real ball5_twist_17 = ball1_pose * ball5_twist_13 - ball1_pose_4 * ball5_twist_12;
    const real ball5_twist_18 = ball1_pose_5 * ball5_twist_14 - ball1_pose_8 * ball5_twist_13;
    const real ball5_twist_19 = ball1_pose_8 * ball5_twist_12 - ball1_pose_2 * ball5_twist_14;
    const real ball5_twist_20 = ball1_pose_2 * ball5_twist_13 - ball1_pose_5 * ball5_twist_12;
    const real ball5_twist_21 = ball1_pose_6 * ball5_twist_14 - ball1_pose_9 * ball5_twist_13;
    const real ball5_twist_22 = ball1_pose_9 * ball5_twist_12 - ball1_pose_3 * ball5_twist_14;
    const real ball5_twist_23 = ball1_pose_3 * ball5_twist_13 - ball1_pose_6 * ball5_twist_12;
    const real ball5_twist_24 = ball1_twist_8 * ball5_twist_14 - ball1_twist_9 * ball5_twist_13
        + ball5_twist_9;
    const real ball5_twist_25 = ball1_twist_9 * ball5_twist_12 - ball1_twist_7 * ball5_twist_14
        + ball5_twist_10;
    const real ball5_twist_26 = ball1_twist_7 * ball5_twist_13 - ball1_twist_8 * ball5_twist_12
        + ball5_twist_11;
    const real ball5_twist_27 = ball5_pose - hooke5_position_x;
    work[767] = ball5_twist_27;
    const real ball5_twist_28 = ball5_pose_2 - hooke5_position_y;
    work[768] = ball5_twist_28;
    const real ball5_twist_29 = hooke5_cos_2 * hooke5_cos_2 + hooke5_sin_2 * hooke5_sin_2;
    const real ball5_twist_30 = hooke5_cos_2 * hooke5_R_yx - hooke5_sin_2 * hooke5_R;
    const real ball5_twist_31 = hooke5_sin_2 * hooke5_R_zz - hooke5_cos_2 * hooke5_R_2;
    const real ball5_twist_32 = ball5_pose_3 * ball5_twist_30 - ball5_twist_28 * ball5_twist_31;
    const real ball5_twist_33 = ball5_twist_27 * ball5_twist_31 - ball5_pose_3 * ball5_twist_29;
    const real ball5_twist_34 = ball5_twist_28 * ball5_twist_29 - ball5_twist_27 * ball5_twist_30;
    const real ball5_twist_35 = hooke5_cos * ball5_pose_3 - hooke5_sin * ball5_twist_28;
    const real ball5_twist_36 = hooke5_sin * ball5_twist_27;
    const real ball5_twist_37 = hooke5_cos * ball5_twist_27;
    const real ball5_twist_38 = ball1_pose * ball5_twist_3 + ball1_pose_4 * ball5_twist_4
        + ball1_pose_7 * ball5_twist_5;
    const real ball5_twist_39 = ball1_pose_2 * ball5_twist_3 + ball1_pose_5 * ball5_twist_4
        + ball1_pose_8 * ball5_twist_5;
    const real ball5_twist_40 = ball1_pose_3 * ball5_twist_3 + ball1_pose_6 * ball5_twist_4
        + ball1_pose_9 * ball5_twist_5;
    const real ball5_twist_41 = ball1_pose * ball5_twist_6 + ball1_pose_4 * ball5_twist_7
        - ball1_pose_7 * ball5_twist_8;
    const real ball5_twist_42 = ball1_pose_2 * ball5_twist_6 + ball1_pose_5 * ball5_twist_7
        - ball1_pose_8 * ball5_twist_8;
    const real ball5_twist_43 = ball1_pose_3 * ball5_twist_6 + ball1_pose_6 * ball5_twist_7
        - ball1_pose_9 * ball5_twist_8;
    const real ball5_twist_44 = ball1_pose * ball5_twist_15 + ball1_pose_4 * ball5_twist_16
        + ball1_pose_7 * ball5_twist_17;
    const real ball5_twist_45 = ball1_pose_2 * ball5_twist_15 + ball1_pose_5 * ball5_twist_16
        + ball1_pose_8 * ball5_twist_17;
    const real ball5_twist_46 = ball1_pose_3 * ball5_twist_15 + ball1_pose_6 * ball5_twist_16
        + ball1_pose_9 * ball5_twist_17;
    const real ball5_twist_47 = ball1_pose * ball5_twist_18 + ball1_pose_4 * ball5_twist_19
        + ball1_pose_7 * ball5_twist_20;
    const real ball5_twist_48 = ball1_pose_2 * ball5_twist_18 + ball1_pose_5 * ball5_twist_19
        + ball1_pose_8 * ball5_twist_20;
    const real ball5_twist_49 = ball1_pose_3 * ball5_twist_18 + ball1_pose_6 * ball5_twist_19
        + ball1_pose_9 * ball5_twist_20;
    const real ball5_twist_50 = ball1_pose * ball5_twist_21 + ball1_pose_4 * ball5_twist_22
        + ball1_pose_7 * ball5_twist_23;
    const real ball5_twist_51 = ball1_pose_2 * ball5_twist_21 + ball1_pose_5 * ball5_twist_22
        + ball1_pose_8 * ball5_twist_23;
    const real ball5_twist_52 = ball1_pose_3 * ball5_twist_21 + ball1_pose_6 * ball5_twist_22
        + ball1_pose_9 * ball5_twist_23;
    const real ball5_twist_53 = ball1_pose * ball5_twist_32 + ball1_pose_4 * ball5_twist_33
        + ball1_pose_7 * ball5_twist_34;
    const real ball5_twist_54 = ball1_pose_2 * ball5_twist_32 + ball1_pose_5 * ball5_twist_33
        + ball1_pose_8 * ball5_twist_34;
    const real ball5_twist_55 = ball1_pose_3 * ball5_twist_32 + ball1_pose_6 * ball5_twist_33
        + ball1_pose_9 * ball5_twist_34;
    const real ball5_twist_56 = ball1_pose_7 * ball5_twist_37 - (ball1_pose * ball5_twist_35
        + ball1_pose_4 * ball5_twist_36);
    const real ball5_twist_57 = ball1_pose_8 * ball5_twist_37 - (ball1_pose_2 * ball5_twist_35
        + ball1_pose_5 * ball5_twist_36);
    const real ball5_twist_58 = ball1_pose_9 * ball5_twist_37 - (ball1_pose_3 * ball5_twist_35
        + ball1_pose_6 * ball5_twist_36);
    const real ball5_G = ball5_pose_4 * ball5_twist_38 + ball5_pose_5 * ball5_twist_39
        + ball5_pose_6 * ball5_twist_40;
    work[769] = ball5_G;
    const real ball5_G_2 = ball5_pose_4 * ball5_twist_41 + ball5_pose_5 * ball5_twist_42
        + ball5_pose_6 * ball5_twist_43;
    work[770] = ball5_G_2;
    const real ball5_G_3 = ball1_twist_10 * ball5_pose_4 + ball1_twist_11 * ball5_pose_5
        + ball1_twist_12 * ball5_pose_6;
    work[771] = ball5_G_3;
    const real ball5_G_4 = ball5_pose_4 * ball5_twist_44 + ball5_pose_5 * ball5_twist_45
        + ball5_pose_6 * ball5_twist_46;
    work[772] = ball5_G_4;
    const real ball5_G_5 = ball5_pose_4 * ball5_twist_47 + ball5_pose_5 * ball5_twist_48
        + ball5_pose_6 * ball5_twist_49;
    work[773] = ball5_G_5;
    const real ball5_G_6 = ball5_pose_4 * ball5_twist_50 + ball5_pose_5 * ball5_twist_51
        + ball5_pose_6 * ball5_twist_52;
    work[774] = ball5_G_6;
    const real ball5_G_7 = ball5_pose_4 * ball5_twist_53 + ball5_pose_5 * ball5_twist_54
        + ball5_pose_6 * ball5_twist_55;
    work[775] = ball5_G_7;
    const real ball5_G_8 = ball5_pose_4 * ball5_twist_56 + ball5_pose_5 * ball5_twist_57
        + ball5_pose_6 * ball5_twist_58;
    work[776] = ball5_G_8;
    const real ball5_G_9 = ball5_pose_4 * ball5_pose_10 + ball5_pose_5 * ball5_pose_11
        + ball5_pose_6 * ball5_pose_12;
    work[777] = ball5_G_9;
    const real ball5_G_10 = ball5_pose_7 * ball5_twist_38 + ball5_pose_8 * ball5_twist_39
        + ball5_pose_9 * ball5_twist_40;
    work[778] = ball5_G_10;
    const real ball5_G_11 = ball5_pose_7 * ball5_twist_41 + ball5_pose_8 * ball5_twist_42
        + ball5_pose_9 * ball5_twist_43;
    work[779] = ball5_G_11;
    const real ball5_G_12 = ball1_twist_10 * ball5_pose_7 + ball1_twist_11 * ball5_pose_8
        + ball1_twist_12 * ball5_pose_9;
    work[780] = ball5_G_12;
    const real ball5_G_13 = ball5_pose_7 * ball5_twist_44 + ball5_pose_8 * ball5_twist_45
        + ball5_pose_9 * ball5_twist_46;
    work[781] = ball5_G_13;
    const real ball5_G_14 = ball5_pose_7 * ball5_twist_47 + ball5_pose_8 * ball5_twist_48
        + ball5_pose_9 * ball5_twist_49;
    work[782] = ball5_G_14;
    const real ball5_G_15 = ball5_pose_7 * ball5_twist_50 + ball5_pose_8 * ball5_twist_51
        + ball5_pose_9 * ball5_twist_52;
    work[783] = ball5_G_15;
    const real ball5_G_16 = ball5_pose_7 * ball5_twist_53 + ball5_pose_8 * ball5_twist_54
        + ball5_pose_9 * ball5_twist_55;
    work[784] = ball5_G_16;
    const real ball5_G_17 = ball5_pose_7 * ball5_twist_56 + ball5_pose_8 * ball5_twist_57
        + ball5_pose_9 * ball5_twist_58;
    work[785] = ball5_G_17;
    const real ball5_G_18 = ball5_pose_7 * ball5_pose_10 + ball5_pose_8 * ball5_pose_11
        + ball5_pose_9 * ball5_pose_12;
    work[786] = ball5_G_18;
    const real ball5_G_19 = ball5_pose_10 * ball5_twist_38 + ball5_pose_11 * ball5_twist_39
        + ball5_pose_12 * ball5_twist_40;
    work[787] = ball5_G_19;
    const real ball5_G_20 = ball5_pose_10 * ball5_twist_41 + ball5_pose_11 * ball5_twist_42
        + ball5_pose_12 * ball5_twist_43;
    work[788] = ball5_G_20;
    const real ball5_G_21 = ball1_twist_10 * ball5_pose_10 + ball1_twist_11 * ball5_pose_11
        + ball1_twist_12 * ball5_pose_12;
    work[789] = ball5_G_21;
    const real ball5_G_22 = ball5_pose_10 * ball5_twist_44 + ball5_pose_11 * ball5_twist_45
        + ball5_pose_12 * ball5_twist_46;
    work[790] = ball5_G_22;
    const real ball5_G_23 = ball5_pose_10 * ball5_twist_47 + ball5_pose_11 * ball5_twist_48
        + ball5_pose_12 * ball5_twist_49;
    work[791] = ball5_G_23;
    const real ball5_G_24 = ball5_pose_10 * ball5_twist_50 + ball5_pose_11 * ball5_twist_51
        + ball5_pose_12 * ball5_twist_52;
    work[792] = ball5_G_24;
    const real ball5_G_25 = ball5_pose_10 * ball5_twist_53 + ball5_pose_11 * ball5_twist_54
        + ball5_pose_12 * ball5_twist_55;
    work[793] = ball5_G_25;
    const real ball5_G_26 = ball5_pose_10 * ball5_twist_56 + ball5_pose_11 * ball5_twist_57
        + ball5_pose_12 * ball5_twist_58;
    work[794] = ball5_G_26;
    const real ball5_G_27 = ball5_pose_10 * ball5_pose_10 + ball5_pose_11 * ball5_pose_11
        + ball5_pose_12 * ball5_pose_12;
    work[795] = ball5_G_27;

    /* tube5: omega, alpha, inertia, composite inertia, a, U, inertia force */
    const real slide5_q = q[21]; /* m */
    const wreal tube5_first_moment_z = w[32];
    const wreal tube5_inertia = w[52];
    const wreal rod5_base_moment_z = w[53];
    const wreal tube5_base_inertia_xx = w[54];
    const wreal tube5_base_inertia_yy = w[55];
    const wreal tube5_base_second_moment_xx = w[77];
    const wreal tube5_base_second_moment_zz = w[79];
    const real tube5_omega_x = hooke5_u_angle1 * hooke5_cos_2;
    work[796] = tube5_omega_x;
    const real tube5_omega_z = hooke5_u_angle1 * hooke5_sin_2;
    work[797] = tube5_omega_z;
    const real tube5_alpha_z = hooke5_cos_2 * hooke5_drift;
    const real tube5_inertia_2 = slide5_q * (rod5_base_moment_z + slide5_q * tube5_inertia) * 2.0;
    const real tube5_composite_inertia_xx = tube5_base_inertia_xx + tube5_inertia_2;
    const real tube5_composite_inertia_yy = tube5_base_inertia_yy + tube5_inertia_2;
    work[798] = tube5_composite_inertia_yy;
    const real tube5_a_x = gravity_z * hooke5_R_2;
    const real tube5_a = gravity_z * hooke5_sin;
    const real tube5_U_xz = tube5_omega_x * tube5_omega_z;
    const real tube5_inertia_force = tube5_base_second_moment_zz * tube5_U_xz
        - tube5_base_second_moment_xx * tube5_U_xz + tube5_first_moment_z * tube5_a_x;

    /* ball5: twist */
    const real slide5_u = u[20]; /* m/s */
    const real ball5_twist_59 = hooke5_cos_2 * tube5_omega_x + hooke5_sin_2 * tube5_omega_z;
    work[799] = ball5_twist_59;
    const real ball5_twist_60 = hooke5_R_yx * tube5_omega_x + hooke5_u_angle2 * hooke5_cos
        - hooke5_R * tube5_omega_z;
    work[800] = ball5_twist_60;
    const real ball5_twist_61 = hooke5_u_angle2 * hooke5_sin - hooke5_R_2 * tube5_omega_x
        + hooke5_R_zz * tube5_omega_z;
    work[801] = ball5_twist_61;
    const real ball5_twist_62 = ball5_twist_24 - (ball5_pose_3 * ball5_twist_60
        - ball5_twist_28 * ball5_twist_61) - slide5_u * hooke5_sin_2;
    work[802] = ball5_twist_62;
    const real ball5_twist_63 = ball5_twist_25 - (ball5_twist_27 * ball5_twist_61
        - ball5_pose_3 * ball5_twist_59) + slide5_u * hooke5_R;
    work[803] = ball5_twist_63;
    const real ball5_twist_64 = ball5_twist_26 - (ball5_twist_28 * ball5_twist_59
        - ball5_twist_27 * ball5_twist_60) - slide5_u * hooke5_R_zz;
    work[804] = ball5_twist_64;
    const real ball5_twist_65 = ball1_pose * ball5_twist_62 + ball1_pose_4 * ball5_twist_63
        + ball1_pose_7 * ball5_twist_64;
    work[805] = ball5_twist_65;
    const real ball5_twist_66 = ball1_pose_2 * ball5_twist_62 + ball1_pose_5 * ball5_twist_63
        + ball1_pose_8 * ball5_twist_64;
    work[806] = ball5_twist_66;
    const real ball5_twist_67 = ball1_pose_3 * ball5_twist_62 + ball1_pose_6 * ball5_twist_63
        + ball1_pose_9 * ball5_twist_64;
    work[807] = ball5_twist_67;

    /* rod0: composite inertia, inertia, composite moment, a */
    const real slide0_q = q[2]; /* m */
    const real hooke0_u_angle2 = u[1]; /* rad/s */
    const real slide0_u = u[2]; /* m/s */
    const wreal slide0_position_z = w[4]; /* m */
    const wreal ball0_momentum_fz = w[5];
    const wreal ball0_momentum_fx = w[6];
    const wreal platform_first_moment_z = w[7];
    const wreal rod0_base_moment_z = w[70];
    const real ball0_R_yx = work[425];
    const real rod0_inertia = work[459];
    const real ball0_R_yy = work[426];
    const real rod0_inertia_2 = work[460];
    const real ball0_R_yz = work[427];
    const real rod0_inertia_3 = work[461];
    const real rod0_composite_inertia_xy = ball0_R_yx * rod0_inertia
        + ball0_R_yy * rod0_inertia_2 + ball0_R_yz * rod0_inertia_3;
    const real ball0_R_zx = work[428];
    const real ball0_R_zy = work[429];
    const real ball0_R_zz = work[430];
    const real rod0_inertia_10 = ball0_R_zx * rod0_inertia + ball0_R_zy * rod0_inertia_2
        + ball0_R_zz * rod0_inertia_3;
    const real rod0_inertia_4 = work[462];
    const real rod0_inertia_5 = work[463];
    const real rod0_inertia_6 = work[464];
    const real rod0_inertia_11 = ball0_R_zx * rod0_inertia_4 + ball0_R_zy * rod0_inertia_5
        + ball0_R_zz * rod0_inertia_6;
    const real rod0_inertia_7 = work[465];
    const real rod0_inertia_8 = work[466];
    const real rod0_inertia_9 = work[467];
    const real rod0_composite_inertia_zz = ball0_R_zx * rod0_inertia_7
        + ball0_R_zy * rod0_inertia_8 + ball0_R_zz * rod0_inertia_9;
    const real ball0_R_xz = work[424];
    const real ball0_R_xx = work[422];
    const real ball0_R_xy = work[423];
    const real rod0_composite_moment_x = platform_first_moment_z * ball0_R_xz
        - (ball0_momentum_fz * ball0_R_xx + ball0_momentum_fx * ball0_R_xy);
    work[808] = rod0_composite_moment_x;
    const real rod0_composite_moment_y = platform_first_moment_z * ball0_R_yz
        - (ball0_momentum_fz * ball0_R_yx + ball0_momentum_fx * ball0_R_yy);
    const real rod0_inertia_12 = platform_first_moment_z * ball0_R_zz
        - (ball0_momentum_fz * ball0_R_zx + ball0_momentum_fx * ball0_R_zy);
    const real rod0_inertia_13 = slide0_position_z * rod0_inertia_12 * 2.0;
    const real rod0_composite_inertia_xx = ball0_R_xx * rod0_inertia
        + ball0_R_xy * rod0_inertia_2 + ball0_R_xz * rod0_inertia_3 + rod0_inertia_13;
    const real rod0_composite_inertia_xz = rod0_inertia_10
        - slide0_position_z * rod0_composite_moment_x;
    const real rod0_composite_inertia_yy = ball0_R_yx * rod0_inertia_4
        + ball0_R_yy * rod0_inertia_5 + ball0_R_yz * rod0_inertia_6 + rod0_inertia_13;
    const real rod0_composite_inertia_yz = rod0_inertia_11 + rod0_inertia_11 - rod0_inertia_11
        - slide0_position_z * rod0_composite_moment_y;
    const real rod0_composite_moment_z = rod0_base_moment_z + rod0_inertia_12;
    const real hooke0_R_zz = work[417];
    const real tube0_U_3 = work[530];
    const real rod0_a = gravity_z * hooke0_R_zz + slide0_q * tube0_U_3;
    const real tube0_a_x = work[521];
    const real tube0_U_xz = work[523];
    const real rod0_a_x = tube0_a_x + slide0_q * tube0_U_xz + hooke0_u_angle2 * slide0_u * 2.0;

    /* tube0: inertia, composite inertia, U, inertia force */
    const wreal tube0_first_moment_z = w[3];
    const wreal tube0_base_inertia_xx = w[71];
    const wreal tube0_base_inertia_yy = w[72];
    const wreal tube0_base_inertia_zz = w[73];
    const wreal tube0_base_second_moment_yy = w[93];
    const wreal tube0_base_second_moment_zz = w[94];
    const wreal tube0_inertia = w[95];
    const real tube0_inertia_2 = rod0_composite_inertia_yz + rod0_composite_inertia_yz
        - rod0_composite_inertia_yz;
    const real tube0_inertia_3 = slide0_q * (rod0_composite_moment_z
        + slide0_q * tube0_inertia) * 2.0;
    const real tube0_composite_inertia_xz = rod0_composite_inertia_xz
        - slide0_q * rod0_composite_moment_x;
    const real tube0_composite_inertia_yz = tube0_inertia_2 + tube0_inertia_2 - tube0_inertia_2
        - slide0_q * rod0_composite_moment_y;
    const real tube0_composite_inertia_xx = rod0_composite_inertia_xx + tube0_inertia_3
        + tube0_base_inertia_xx;
    const real tube0_composite_inertia_yy = rod0_composite_inertia_yy + tube0_inertia_3
        + tube0_base_inertia_yy;
    work[809] = tube0_composite_inertia_yy;
    const real tube0_composite_inertia_zz = tube0_base_inertia_zz + rod0_composite_inertia_zz;
    const real tube0_U = work[528];
    const real tube0_alpha_z = work[520];
    const real tube0_U_xy = tube0_U - tube0_alpha_z;
    const real tube0_U_yx = tube0_alpha_z + tube0_U;
    const real hooke0_drift_2 = work[418];
    const real tube0_U_2 = work[529];
    const real tube0_U_yz = hooke0_drift_2 + tube0_U_2;
    const real tube0_U_zy = tube0_U_2 - hooke0_drift_2;
    const real tube0_a = work[522];
    const real tube0_inertia_force_2 = tube0_base_second_moment_yy * tube0_U_zy
        - tube0_base_second_moment_zz * tube0_U_yz + tube0_first_moment_z * tube0_a;

    /* hooke5: momentum mx */
    const real hooke5_momentum_mx = hooke5_cos_2 * tube5_composite_inertia_xx;

    /* M */
    const real M_19_19 = hooke5_cos_2 * hooke5_momentum_mx + hooke5_sin_2 * hooke5_momentum_mz;
    work[810] = M_19_19;
    const real M_5_3 = platform_first_moment_z * ball0_R_zx + ball0_momentum_fz * ball0_R_zz;
    work[811] = M_5_3;
    const real M_6_3 = ball0_momentum_fx * ball0_R_zx - ball0_momentum_fz * ball0_R_zy;
    work[812] = M_6_3;

    /* hooke4: momentum mx */
    const real hooke4_momentum_mx = hooke4_cos_2 * tube4_composite_inertia_xx;

    /* M */
    const real hooke4_momentum_mz = work[691];
    const real M_16_16 = hooke4_cos_2 * hooke4_momentum_mx + hooke4_sin_2 * hooke4_momentum_mz;
    work[813] = M_16_16;

    /* hooke3: momentum mx */
    const real hooke3_cos_2 = work[404];
    const real tube3_composite_inertia_xx = work[670];
    const real hooke3_momentum_mx = hooke3_cos_2 * tube3_composite_inertia_xx;

    /* M */
    const real hooke3_sin_2 = work[405];
    const real hooke3_momentum_mz = work[622];
    const real M_13_13 = hooke3_cos_2 * hooke3_momentum_mx + hooke3_sin_2 * hooke3_momentum_mz;
    work[814] = M_13_13;

    /* hooke2: momentum mx */
    const real hooke2_cos_2 = work[400];
    const real tube2_composite_inertia_xx = work[602];
    const real hooke2_momentum_mx = hooke2_cos_2 * tube2_composite_inertia_xx;

    /* M */
    const real hooke2_sin_2 = work[401];
    const real hooke2_momentum_mz = work[554];
    const real M_10_10 = hooke2_cos_2 * hooke2_momentum_mx + hooke2_sin_2 * hooke2_momentum_mz;
    work[815] = M_10_10;

    /* hooke1: momentum mx */
    const real hooke1_cos_2 = work[396];
    const real tube1_composite_inertia_xx = work[534];
    const real hooke1_momentum_mx = hooke1_cos_2 * tube1_composite_inertia_xx;

    /* M */
    const real hooke1_sin_2 = work[397];
    const real hooke1_momentum_mz = work[473];
    const real M_7_7 = hooke1_cos_2 * hooke1_momentum_mx + hooke1_sin_2 * hooke1_momentum_mz;
    work[816] = M_7_7;

    /* platform: momentum, alpha, omega, a, U, inertia force, f */
    const real ball0_u_x = u[3]; /* rad/s */
    const real ball0_u_y = u[4]; /* rad/s */
    const real ball0_u_z = u[5]; /* rad/s */
    const wreal platform_base_second_moment_xy = w[8];
    const wreal platform_inertia_xz = w[9];
    const wreal platform_inertia_yz = w[10];
    const wreal platform_base_second_moment_xx = w[74];
    const wreal platform_base_second_moment_yy = w[75];
    const wreal platform_base_second_moment_zz = w[76];
    const real platform_momentum = platform_first_moment_z * ball0_R_xy
        + ball0_momentum_fx * ball0_R_xz;
    const real platform_momentum_2 = platform_first_moment_z * ball0_R_yy
        + ball0_momentum_fx * ball0_R_yz;
    const real platform_momentum_3 = platform_first_moment_z * ball0_R_xx
        + ball0_momentum_fz * ball0_R_xz;
    const real platform_momentum_4 = platform_first_moment_z * ball0_R_yx
        + ball0_momentum_fz * ball0_R_yz;
    const real platform_momentum_5 = ball0_momentum_fx * ball0_R_xx
        - ball0_momentum_fz * ball0_R_xy;
    const real platform_momentum_6 = ball0_momentum_fx * ball0_R_yx
        - ball0_momentum_fz * ball0_R_yy;
    const real tube0_omega_x = work[518];
    const real tube0_omega_z = work[519];
    const real platform_alpha = ball0_R_xx * tube0_omega_x + hooke0_u_angle2 * ball0_R_yx
        + ball0_R_zx * tube0_omega_z;
    const real platform_alpha_2 = ball0_R_xy * tube0_omega_x + hooke0_u_angle2 * ball0_R_yy
        + ball0_R_zy * tube0_omega_z;
    const real platform_alpha_3 = ball0_R_xz * tube0_omega_x + hooke0_u_angle2 * ball0_R_yz
        + ball0_R_zz * tube0_omega_z;
    const real platform_omega_x = ball0_u_x + platform_alpha;
    const real platform_omega_y = ball0_u_y + platform_alpha_2;
    const real platform_omega_z = ball0_u_z + platform_alpha_3;
    const real platform_alpha_x = ball0_u_z * platform_alpha_2 - ball0_u_y * platform_alpha_3
        + (ball0_R_zx * tube0_alpha_z - ball0_R_xx * hooke0_drift_2);
    const real platform_alpha_y = ball0_u_x * platform_alpha_3 - ball0_u_z * platform_alpha
        + (ball0_R_zy * tube0_alpha_z - ball0_R_xy * hooke0_drift_2);
    const real platform_alpha_z = ball0_u_y * platform_alpha - ball0_u_x * platform_alpha_2
        + (ball0_R_zz * tube0_alpha_z - ball0_R_xz * hooke0_drift_2);
    const real platform_a = rod0_a_x + slide0_position_z * tube0_U_xz;
    const real platform_a_2 = rod0_a + slide0_position_z * tube0_U_3;
    const real platform_U = platform_omega_x * platform_omega_x;
    const real platform_U_2 = platform_omega_y * platform_omega_y;
    const real platform_U_3 = platform_omega_z * platform_omega_z;
    const real platform_U_4 = platform_omega_x * platform_omega_y;
    const real platform_U_5 = platform_omega_x * platform_omega_z;
    const real platform_U_6 = platform_omega_y * platform_omega_z;
    const real platform_U_7 = platform_U_2 + platform_U_3;
    const real platform_U_xy = platform_U_4 - platform_alpha_z;
    const real platform_U_xz = platform_alpha_y + platform_U_5;
    const real platform_U_yx = platform_alpha_z + platform_U_4;
    const real platform_U_8 = platform_U + platform_U_3;
    const real platform_U_yz = platform_U_6 - platform_alpha_x;
    const real platform_U_zx = platform_U_5 - platform_alpha_y;
    const real platform_U_zy = platform_alpha_x + platform_U_6;
    const real platform_U_9 = platform_U + platform_U_2;
    const real platform_inertia_force = platform_base_second_moment_yy * platform_U_zy
        - platform_base_second_moment_zz * platform_U_yz;
    const real platform_inertia_force_2 = platform_base_second_moment_xy * platform_U_zx
        - platform_inertia_yz * (platform_U_8 - platform_U_9);
    const real platform_inertia_force_3 = platform_inertia_force_2
        + platform_inertia_xz * platform_U_yx + platform_inertia_force;
    const real platform_inertia_force_4 = platform_base_second_moment_zz * platform_U_xz
        - platform_base_second_moment_xx * platform_U_zx;
    const real platform_inertia_force_5 = platform_inertia_xz * (platform_U_9 - platform_U_7)
        + platform_inertia_yz * platform_U_xy;
    const real platform_inertia_force_6 = platform_inertia_force_4 - (platform_inertia_force_5
        + platform_base_second_moment_xy * platform_U_zy);
    const real platform_inertia_force_7 = platform_base_second_moment_xx * platform_U_yx
        - platform_base_second_moment_yy * platform_U_xy;
    const real platform_inertia_force_8 = platform_base_second_moment_xy * (platform_U_7
        - platform_U_8) - platform_inertia_xz * platform_U_yz;
    const real platform_inertia_force_9 = platform_inertia_force_8
        + platform_inertia_yz * platform_U_xz + platform_inertia_force_7;
    const real platform_f_x = ball0_momentum_fz * platform_U_7
        - ball0_momentum_fx * platform_U_xy + platform_first_moment_z * platform_U_xz;
    const real platform_f_y = ball0_momentum_fx * platform_U_8
        - ball0_momentum_fz * platform_U_yx + platform_first_moment_z * platform_U_yz;
    const real platform_inertia_force_10 = ball0_momentum_fz * platform_U_zx
        + ball0_momentum_fx * platform_U_zy + platform_first_moment_z * platform_U_9;
    const real platform_f = ball0_R_xx * platform_f_x + ball0_R_xy * platform_f_y
        - ball0_R_xz * platform_inertia_force_10;
    const real platform_f_2 = ball0_R_yx * platform_f_x + ball0_R_yy * platform_f_y
        - ball0_R_yz * platform_inertia_force_10;
    const real platform_f_3 = ball0_R_zx * platform_f_x + ball0_R_zy * platform_f_y
        - ball0_R_zz * platform_inertia_force_10;

    /* M */
    const real M_4_2 = rod0_inertia_4 - slide0_position_z * platform_momentum
        - slide0_q * platform_momentum;
    work[817] = M_4_2;
    const real hooke0_cos_2 = work[392];
    const real hooke0_sin_2 = work[393];
    const real M_4_1 = hooke0_cos_2 * (rod0_inertia + slide0_position_z * platform_momentum_2
        + slide0_q * platform_momentum_2) + hooke0_sin_2 * rod0_inertia_7;
    work[818] = M_4_1;
    const real M_5_2 = rod0_inertia_5 + slide0_position_z * platform_momentum_3
        + slide0_q * platform_momentum_3;
    work[819] = M_5_2;
    const real M_5_1 = hooke0_cos_2 * (rod0_inertia_2 - slide0_position_z * platform_momentum_4
        - slide0_q * platform_momentum_4) + hooke0_sin_2 * rod0_inertia_8;
    work[820] = M_5_1;
    const real M_6_2 = rod0_inertia_6 + slide0_position_z * platform_momentum_5
        + slide0_q * platform_momentum_5;
    work[821] = M_6_2;
    const real M_6_1 = hooke0_cos_2 * (rod0_inertia_3 - slide0_position_z * platform_momentum_6
        - slide0_q * platform_momentum_6) + hooke0_sin_2 * rod0_inertia_9;
    work[822] = M_6_1;

    /* hooke0: momentum fz, momentum mx, momentum my, momentum mz */
    const real hooke0_momentum_fz = hooke0_cos_2 * rod0_composite_moment_y;
    work[823] = hooke0_momentum_fz;
    const real hooke0_momentum_mx = hooke0_cos_2 * tube0_composite_inertia_xx
        + hooke0_sin_2 * tube0_composite_inertia_xz;
    const real hooke0_momentum_my = hooke0_cos_2 * rod0_composite_inertia_xy
        + hooke0_sin_2 * tube0_composite_inertia_yz;
    work[824] = hooke0_momentum_my;
    const real hooke0_momentum_mz = hooke0_cos_2 * tube0_composite_inertia_xz
        + hooke0_sin_2 * tube0_composite_inertia_zz;

    /* M */
    const real M_1_1 = hooke0_cos_2 * hooke0_momentum_mx + hooke0_sin_2 * hooke0_momentum_mz;
    work[825] = M_1_1;

    /* rod0: a, f */
    const wreal rod0_base_mass = w[69];
    const real rod0_a_y = slide0_q * tube0_U_yz - tube0_a - slide0_u * tube0_omega_x * 2.0;
    const real rod0_f_x = rod0_base_mass * rod0_a_x + rod0_base_moment_z * tube0_U_xz + platform_f;
    const real rod0_f_y = rod0_base_mass * rod0_a_y + rod0_base_moment_z * tube0_U_yz
        + platform_f_2;
    const real rod0_f_z = platform_f_3 - (rod0_base_mass * rod0_a + rod0_base_moment_z * tube0_U_3);

    /* platform: a, n, f */
    const real platform_a_3 = rod0_a_y + slide0_position_z * tube0_U_yz;
    const real platform_a_x = ball0_R_xx * platform_a + ball0_R_yx * platform_a_3
        - ball0_R_zx * platform_a_2;
    const real platform_a_y = ball0_R_xy * platform_a + ball0_R_yy * platform_a_3
        - ball0_R_zy * platform_a_2;
    const real platform_a_z = ball0_R_xz * platform_a + ball0_R_yz * platform_a_3
        - ball0_R_zz * platform_a_2;
    const real platform_n_x = platform_inertia_force_3 - (ball0_momentum_fx * platform_a_z
        + platform_first_moment_z * platform_a_y);
    const real platform_n_y = platform_first_moment_z * platform_a_x
        + ball0_momentum_fz * platform_a_z + platform_inertia_force_6;
    const real platform_n_z = ball0_momentum_fx * platform_a_x - ball0_momentum_fz * platform_a_y
        + platform_inertia_force_9;
    const real platform_f_4 = ball0_R_xx * platform_n_x + ball0_R_xy * platform_n_y
        + ball0_R_xz * platform_n_z - slide0_position_z * platform_f_2;
    const real platform_f_5 = ball0_R_yx * platform_n_x + ball0_R_yy * platform_n_y
        + ball0_R_yz * platform_n_z + slide0_position_z * platform_f;

    /* shared by several: U */
    const real hooke1_u_angle2 = u[7]; /* rad/s */
    const real hooke2_u_angle2 = u[10]; /* rad/s */
    const real hooke3_u_angle2 = u[13]; /* rad/s */
    const real tube1_omega_x = work[531];
    const real tube1_U = hooke1_u_angle2 * tube1_omega_x;
    const real tube1_omega_z = work[532];
    const real tube1_U_2 = hooke1_u_angle2 * tube1_omega_z;
    const real tube1_U_3 = tube1_omega_x * tube1_omega_x + hooke1_u_angle2 * hooke1_u_angle2;
    const real tube2_omega_x = work[599];
    const real tube2_U = hooke2_u_angle2 * tube2_omega_x;
    const real tube2_omega_z = work[600];
    const real tube2_U_2 = hooke2_u_angle2 * tube2_omega_z;
    const real tube2_U_3 = tube2_omega_x * tube2_omega_x + hooke2_u_angle2 * hooke2_u_angle2;
    const real tube3_omega_x = work[667];
    const real tube3_U = hooke3_u_angle2 * tube3_omega_x;
    const real tube3_omega_z = work[668];
    const real tube3_U_2 = hooke3_u_angle2 * tube3_omega_z;
    const real tube3_U_3 = tube3_omega_x * tube3_omega_x + hooke3_u_angle2 * hooke3_u_angle2;
    const real tube4_U = hooke4_u_angle2 * tube4_omega_x;
    const real tube4_U_2 = hooke4_u_angle2 * tube4_omega_z;
    const real tube4_U_3 = tube4_omega_x * tube4_omega_x + hooke4_u_angle2 * hooke4_u_angle2;
    const real tube5_U = hooke5_u_angle2 * tube5_omega_x;
    const real tube5_U_2 = hooke5_u_angle2 * tube5_omega_z;
    const real tube5_U_3 = tube5_omega_x * tube5_omega_x + hooke5_u_angle2 * hooke5_u_angle2;

    /* tube1: U, n, inertia force */
    const wreal tube1_first_moment_z = w[16];
    const wreal tube1_base_second_moment_xx = w[89];
    const wreal tube1_base_second_moment_yy = w[90];
    const wreal tube1_base_second_moment_zz = w[91];
    const real tube1_alpha_z = work[533];
    const real tube1_U_xy = tube1_U - tube1_alpha_z;
    const real tube1_U_yx = tube1_alpha_z + tube1_U;
    const real hooke1_drift_2 = work[472];
    const real tube1_U_yz = hooke1_drift_2 + tube1_U_2;
    const real tube1_U_zy = tube1_U_2 - hooke1_drift_2;
    const real tube1_n_z = tube1_base_second_moment_xx * tube1_U_yx
        - tube1_base_second_moment_yy * tube1_U_xy;
    const real tube1_a = work[537];
    const real tube1_inertia_force_2 = tube1_base_second_moment_yy * tube1_U_zy
        - tube1_base_second_moment_zz * tube1_U_yz + tube1_first_moment_z * tube1_a;

    /* rod1: a, n, f */
    const real slide1_q = q[9]; /* m */
    const real slide1_u = u[8]; /* m/s */
    const wreal rod1_mass = w[17]; /* kg */
    const wreal rod1_base_moment_z = w[45];
    const real tube1_a_x = work[536];
    const real tube1_U_xz = work[538];
    const real rod1_a_x = tube1_a_x + slide1_q * tube1_U_xz + hooke1_u_angle2 * slide1_u * 2.0;
    const real rod1_a_y = slide1_q * tube1_U_yz - tube1_a - slide1_u * tube1_omega_x * 2.0;
    const real rod1_n_y = rod1_base_moment_z * rod1_a_x;
    const real rod1_f_x = rod1_mass * rod1_a_x + rod1_base_moment_z * tube1_U_xz;
    const real rod1_f_y = rod1_mass * rod1_a_y + rod1_base_moment_z * tube1_U_yz;

    /* tube2: U, n, inertia force */
    const wreal tube2_first_moment_z = w[20];
    const wreal tube2_base_second_moment_xx = w[86];
    const wreal tube2_base_second_moment_yy = w[87];
    const wreal tube2_base_second_moment_zz = w[88];
    const real tube2_alpha_z = work[601];
    const real tube2_U_xy = tube2_U - tube2_alpha_z;
    const real tube2_U_yx = tube2_alpha_z + tube2_U;
    const real hooke2_drift_2 = work[553];
    const real tube2_U_yz = hooke2_drift_2 + tube2_U_2;
    const real tube2_U_zy = tube2_U_2 - hooke2_drift_2;
    const real tube2_n_z = tube2_base_second_moment_xx * tube2_U_yx
        - tube2_base_second_moment_yy * tube2_U_xy;
    const real tube2_a = work[605];
    const real tube2_inertia_force_2 = tube2_base_second_moment_yy * tube2_U_zy
        - tube2_base_second_moment_zz * tube2_U_yz + tube2_first_moment_z * tube2_a;

    /* rod2: a, n, f */
    const real slide2_q = q[12]; /* m */
    const real slide2_u = u[11]; /* m/s */
    const wreal rod2_mass = w[21]; /* kg */
    const wreal rod2_base_moment_z = w[47];
    const real tube2_a_x = work[604];
    const real tube2_U_xz = work[606];
    const real rod2_a_x = tube2_a_x + slide2_q * tube2_U_xz + hooke2_u_angle2 * slide2_u * 2.0;
    const real rod2_a_y = slide2_q * tube2_U_yz - tube2_a - slide2_u * tube2_omega_x * 2.0;
    const real rod2_n_y = rod2_base_moment_z * rod2_a_x;
    const real rod2_f_x = rod2_mass * rod2_a_x + rod2_base_moment_z * tube2_U_xz;
    const real rod2_f_y = rod2_mass * rod2_a_y + rod2_base_moment_z * tube2_U_yz;

    /* tube3: U, n, inertia force */
    const wreal tube3_first_moment_z = w[24];
    const wreal tube3_base_second_moment_xx = w[83];
    const wreal tube3_base_second_moment_yy = w[84];
    const wreal tube3_base_second_moment_zz = w[85];
    const real tube3_alpha_z = work[669];
    const real tube3_U_xy = tube3_U - tube3_alpha_z;
    const real tube3_U_yx = tube3_alpha_z + tube3_U;
    const real hooke3_drift_2 = work[621];
    const real tube3_U_yz = hooke3_drift_2 + tube3_U_2;
    const real tube3_U_zy = tube3_U_2 - hooke3_drift_2;
    const real tube3_n_z = tube3_base_second_moment_xx * tube3_U_yx
        - tube3_base_second_moment_yy * tube3_U_xy;
    const real tube3_a = work[673];
    const real tube3_inertia_force_2 = tube3_base_second_moment_yy * tube3_U_zy
        - tube3_base_second_moment_zz * tube3_U_yz + tube3_first_moment_z * tube3_a;

    /* rod3: a, n, f */
    const real slide3_q = q[15]; /* m */
    const real slide3_u = u[14]; /* m/s */
    const wreal rod3_mass = w[25]; /* kg */
    const wreal rod3_base_moment_z = w[49];
    const real tube3_a_x = work[672];
    const real tube3_U_xz = work[674];
    const real rod3_a_x = tube3_a_x + slide3_q * tube3_U_xz + hooke3_u_angle2 * slide3_u * 2.0;
    const real rod3_a_y = slide3_q * tube3_U_yz - tube3_a - slide3_u * tube3_omega_x * 2.0;
    const real rod3_n_y = rod3_base_moment_z * rod3_a_x;
    const real rod3_f_x = rod3_mass * rod3_a_x + rod3_base_moment_z * tube3_U_xz;
    const real rod3_f_y = rod3_mass * rod3_a_y + rod3_base_moment_z * tube3_U_yz;

    /* tube4: U, n, inertia force */
    const wreal tube4_base_second_moment_yy = w[81];
    const real tube4_U_xy = tube4_U - tube4_alpha_z;
    const real tube4_U_yx = tube4_alpha_z + tube4_U;
    const real hooke4_drift_2 = work[690];
    const real tube4_U_yz = hooke4_drift_2 + tube4_U_2;
    const real tube4_U_zy = tube4_U_2 - hooke4_drift_2;
    const real tube4_n_z = tube4_base_second_moment_xx * tube4_U_yx
        - tube4_base_second_moment_yy * tube4_U_xy;
    const real tube4_inertia_force_2 = tube4_base_second_moment_yy * tube4_U_zy
        - tube4_base_second_moment_zz * tube4_U_yz + tube4_first_moment_z * tube4_a;

    /* rod4: a, n, f */
    const wreal rod4_mass = w[29]; /* kg */
    const real rod4_a_x = tube4_a_x + slide4_q * tube4_U_xz + hooke4_u_angle2 * slide4_u * 2.0;
    const real rod4_a_y = slide4_q * tube4_U_yz - tube4_a - slide4_u * tube4_omega_x * 2.0;
    const real rod4_n_y = rod4_base_moment_z * rod4_a_x;
    const real rod4_f_x = rod4_mass * rod4_a_x + rod4_base_moment_z * tube4_U_xz;
    const real rod4_f_y = rod4_mass * rod4_a_y + rod4_base_moment_z * tube4_U_yz;

    /* tube5: U, n, inertia force */
    const wreal tube5_base_second_moment_yy = w[78];
    const real tube5_U_xy = tube5_U - tube5_alpha_z;
    const real tube5_U_yx = tube5_alpha_z + tube5_U;
    const real tube5_U_yz = hooke5_drift_2 + tube5_U_2;
    const real tube5_U_zy = tube5_U_2 - hooke5_drift_2;
    const real tube5_n_z = tube5_base_second_moment_xx * tube5_U_yx
        - tube5_base_second_moment_yy * tube5_U_xy;
    const real tube5_inertia_force_2 = tube5_base_second_moment_yy * tube5_U_zy
        - tube5_base_second_moment_zz * tube5_U_yz + tube5_first_moment_z * tube5_a;

    /* rod5: a, n, f */
    const wreal rod5_mass = w[33]; /* kg */
    const real rod5_a_x = tube5_a_x + slide5_q * tube5_U_xz + hooke5_u_angle2 * slide5_u * 2.0;
    const real rod5_a_y = slide5_q * tube5_U_yz - tube5_a - slide5_u * tube5_omega_x * 2.0;
    const real rod5_n_y = rod5_base_moment_z * rod5_a_x;
    const real rod5_f_x = rod5_mass * rod5_a_x + rod5_base_moment_z * tube5_U_xz;
    const real rod5_f_y = rod5_mass * rod5_a_y + rod5_base_moment_z * tube5_U_yz;

    /* tube5: n */
    const real tube5_n_x = tube5_inertia_force_2 - (rod5_base_moment_z * rod5_a_y
        + slide5_q * rod5_f_y);
    const real tube5_n_y = rod5_n_y + slide5_q * rod5_f_x + tube5_inertia_force;

    /* tube4: n */
    const real tube4_n_x = tube4_inertia_force_2 - (rod4_base_moment_z * rod4_a_y
        + slide4_q * rod4_f_y);
    const real tube4_n_y = rod4_n_y + slide4_q * rod4_f_x + tube4_inertia_force;

    /* tube3: n */
    const real tube3_n_x = tube3_inertia_force_2 - (rod3_base_moment_z * rod3_a_y
        + slide3_q * rod3_f_y);
    const real tube3_inertia_force = work[675];
    const real tube3_n_y = rod3_n_y + slide3_q * rod3_f_x + tube3_inertia_force;

    /* tube2: n */
    const real tube2_n_x = tube2_inertia_force_2 - (rod2_base_moment_z * rod2_a_y
        + slide2_q * rod2_f_y);
    const real tube2_inertia_force = work[607];
    const real tube2_n_y = rod2_n_y + slide2_q * rod2_f_x + tube2_inertia_force;

    /* tube1: n */
    const real tube1_n_x = tube1_inertia_force_2 - (rod1_base_moment_z * rod1_a_y
        + slide1_q * rod1_f_y);
    const real tube1_inertia_force = work[539];
    const real tube1_n_y = rod1_n_y + slide1_q * rod1_f_x + tube1_inertia_force;

    /* rod0: n */
    const real rod0_n_z = ball0_R_zx * platform_n_x + ball0_R_zy * platform_n_y
        + ball0_R_zz * platform_n_z;
    const real rod0_n_x = platform_f_4 - rod0_base_moment_z * rod0_a_y;
    const real rod0_n_y = rod0_base_moment_z * rod0_a_x + platform_f_5;

    /* tube0: n */
    const wreal tube0_base_second_moment_xx = w[92];
    const real tube0_n_x = rod0_n_x - slide0_q * rod0_f_y + tube0_inertia_force_2;
    const real tube0_inertia_force = work[524];
    const real tube0_n_y = rod0_n_y + slide0_q * rod0_f_x + tube0_inertia_force;
    const real tube0_n_z = tube0_base_second_moment_xx * tube0_U_yx
        - tube0_base_second_moment_yy * tube0_U_xy + rod0_n_z;

    /* hooke5: tau angle, drive angle */
    const real hooke5_u_angle1_tau = tau[18]; /* N*m */
    const real hooke5_u_angle2_tau = tau[19]; /* N*m */
    const real hooke5_tau_angle1 = hooke5_cos_2 * tube5_n_x + hooke5_sin_2 * tube5_n_z;
    const real hooke5_drive_angle1 = hooke5_u_angle1_tau - hooke5_tau_angle1;
    work[826] = hooke5_drive_angle1;
    const real hooke5_drive_angle2 = hooke5_u_angle2_tau - tube5_n_y;
    work[827] = hooke5_drive_angle2;

    /* hooke4: tau angle, drive angle */
    const real hooke4_u_angle1_tau = tau[15]; /* N*m */
    const real hooke4_u_angle2_tau = tau[16]; /* N*m */
    const real hooke4_tau_angle1 = hooke4_cos_2 * tube4_n_x + hooke4_sin_2 * tube4_n_z;
    const real hooke4_drive_angle1 = hooke4_u_angle1_tau - hooke4_tau_angle1;
    work[828] = hooke4_drive_angle1;
    const real hooke4_drive_angle2 = hooke4_u_angle2_tau - tube4_n_y;
    work[829] = hooke4_drive_angle2;

    /* hooke3: tau angle, drive angle */
    const real hooke3_u_angle1_tau = tau[12]; /* N*m */
    const real hooke3_u_angle2_tau = tau[13]; /* N*m */
    const real hooke3_tau_angle1 = hooke3_cos_2 * tube3_n_x + hooke3_sin_2 * tube3_n_z;
    const real hooke3_drive_angle1 = hooke3_u_angle1_tau - hooke3_tau_angle1;
    work[830] = hooke3_drive_angle1;
    const real hooke3_drive_angle2 = hooke3_u_angle2_tau - tube3_n_y;
    work[831] = hooke3_drive_angle2;

    /* hooke2: tau angle, drive angle */
    const real hooke2_u_angle1_tau = tau[9]; /* N*m */
    const real hooke2_u_angle2_tau = tau[10]; /* N*m */
    const real hooke2_tau_angle1 = hooke2_cos_2 * tube2_n_x + hooke2_sin_2 * tube2_n_z;
    const real hooke2_drive_angle1 = hooke2_u_angle1_tau - hooke2_tau_angle1;
    work[832] = hooke2_drive_angle1;
    const real hooke2_drive_angle2 = hooke2_u_angle2_tau - tube2_n_y;
    work[833] = hooke2_drive_angle2;

    /* hooke1: tau angle, drive angle */
    const real hooke1_u_angle1_tau = tau[6]; /* N*m */
    const real hooke1_u_angle2_tau = tau[7]; /* N*m */
    const real hooke1_tau_angle1 = hooke1_cos_2 * tube1_n_x + hooke1_sin_2 * tube1_n_z;
    const real hooke1_drive_angle1 = hooke1_u_angle1_tau - hooke1_tau_angle1;
    work[834] = hooke1_drive_angle1;
    const real hooke1_drive_angle2 = hooke1_u_angle2_tau - tube1_n_y;
    work[835] = hooke1_drive_angle2;

    /* slide0: tau, drive */
    const real drive0 = r[0];
    const real slide0_u_tau = tau[2]; /* N */
    const real slide0_tau = rod0_f_z - drive0;
    const real slide0_drive = slide0_u_tau - slide0_tau;
    work[836] = slide0_drive;

    /* hooke0: tau angle, drive angle */
    const real hooke0_u_angle1_tau = tau[0]; /* N*m */
    const real hooke0_u_angle2_tau = tau[1]; /* N*m */
    const real hooke0_tau_angle1 = hooke0_cos_2 * tube0_n_x + hooke0_sin_2 * tube0_n_z;
    const real hooke0_drive_angle1 = hooke0_u_angle1_tau - hooke0_tau_angle1;
    work[837] = hooke0_drive_angle1;
    const real hooke0_drive_angle2 = hooke0_u_angle2_tau - tube0_n_y;
    work[838] = hooke0_drive_angle2;

    /* ball0: drive */
    const real ball0_u_x_tau = tau[3]; /* N*m */
    const real ball0_u_y_tau = tau[4]; /* N*m */
    const real ball0_u_z_tau = tau[5]; /* N*m */
    const real ball0_drive_x = ball0_u_x_tau - platform_n_x;
    work[839] = ball0_drive_x;
    const real ball0_drive_y = ball0_u_y_tau - platform_n_y;
    work[840] = ball0_drive_y;
    const real ball0_drive_z = ball0_u_z_tau - platform_n_z;
    work[841] = ball0_drive_z;

    /* slide1: drive */
    const real drive1 = r[1];
    const real slide1_u_tau = tau[8]; /* N */
    const real hooke1_R_zz = work[471];
    const real slide1_drive = rod1_mass * (gravity_z * hooke1_R_zz + slide1_q * tube1_U_3)
        + rod1_base_moment_z * tube1_U_3 + drive1 + slide1_u_tau;
    work[842] = slide1_drive;

    /* slide2: drive */
    const real drive2 = r[2];
    const real slide2_u_tau = tau[11]; /* N */
    const real hooke2_R_zz = work[552];
    const real slide2_drive = rod2_mass * (gravity_z * hooke2_R_zz + slide2_q * tube2_U_3)
        + rod2_base_moment_z * tube2_U_3 + drive2 + slide2_u_tau;
    work[843] = slide2_drive;

    /* slide3: drive */
    const real drive3 = r[3];
    const real slide3_u_tau = tau[14]; /* N */
    const real hooke3_R_zz = work[620];
    const real slide3_drive = rod3_mass * (gravity_z * hooke3_R_zz + slide3_q * tube3_U_3)
        + rod3_base_moment_z * tube3_U_3 + drive3 + slide3_u_tau;
    work[844] = slide3_drive;

    /* slide4: drive */
    const real drive4 = r[4];
    const real slide4_u_tau = tau[17]; /* N */
    const real slide4_drive = rod4_mass * (gravity_z * hooke4_R_zz + slide4_q * tube4_U_3)
        + rod4_base_moment_z * tube4_U_3 + drive4 + slide4_u_tau;
    work[845] = slide4_drive;

    /* slide5: drive */
    const real drive5 = r[5];
    const real slide5_u_tau = tau[20]; /* N */
    const real slide5_drive = rod5_mass * (gravity_z * hooke5_R_zz + slide5_q * tube5_U_3)
        + rod5_base_moment_z * tube5_U_3 + drive5 + slide5_u_tau;
    work[846] = slide5_drive;
    return CARDAN_OK;
}

CARDAN_PART int forward_dynamics_part3(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    (void)out;

    /* constraints: multipliers */
    const real slide0_q = q[2]; /* m */
    const real ball0_w = q[3];
    const real ball0_x = q[4];
    const real ball0_y = q[5];
    const real ball0_z = q[6];
    const real hooke0_u_angle1 = u[0]; /* rad/s */
    const real hooke0_u_angle2 = u[1]; /* rad/s */
    const real slide0_u = u[2]; /* m/s */
    const real ball0_u_x = u[3]; /* rad/s */
    const real ball0_u_y = u[4]; /* rad/s */
    const real ball0_u_z = u[5]; /* rad/s */
    const real hooke1_u_angle1 = u[6]; /* rad/s */
    const real hooke1_u_angle2 = u[7]; /* rad/s */
    const real slide1_u = u[8]; /* m/s */
    const real hooke2_u_angle1 = u[9]; /* rad/s */
    const real hooke2_u_angle2 = u[10]; /* rad/s */
    const real slide2_u = u[11]; /* m/s */
    const real hooke3_u_angle1 = u[12]; /* rad/s */
    const real hooke3_u_angle2 = u[13]; /* rad/s */
    const real slide3_u = u[14]; /* m/s */
    const real hooke4_u_angle1 = u[15]; /* rad/s */
    const real hooke4_u_angle2 = u[16]; /* rad/s */
    const real slide4_u = u[17]; /* m/s */
    const real hooke5_u_angle1 = u[18]; /* rad/s */
    const real hooke5_u_angle2 = u[19]; /* rad/s */
    const real slide5_u = u[20]; /* m/s */
    const wreal slide0_position_z = w[4]; /* m */
    const wreal ball1_placement = w[34];
    const wreal ball1_placement_2 = w[35];
    const wreal ball2_placement = w[36];
    const wreal ball2_placement_2 = w[37];
    const wreal ball3_placement = w[38];
    const wreal ball3_placement_2 = w[39];
    const wreal ball4_placement = w[40];
    const wreal ball4_placement_2 = w[41];
    const wreal ball5_placement = w[42];
    const wreal ball5_placement_2 = w[43];
    const real hooke0_sin = work[391];
    const real constraints_multipliers_4 = hooke0_u_angle1 * hooke0_sin;
    const real hooke0_cos = work[390];
    const real constraints_multipliers_5 = hooke0_u_angle1 * hooke0_cos;
    const real hooke0_sin_2 = work[393];
    const real constraints_multipliers_6 = hooke0_u_angle2 * hooke0_sin_2;
    const real hooke0_cos_2 = work[392];
    const real constraints_multipliers_7 = hooke0_u_angle2 * hooke0_cos_2;
    const real constraints_multipliers_8 = hooke0_sin_2 * constraints_multipliers_5
        + hooke0_sin * constraints_multipliers_7;
    const real constraints_multipliers_9 = hooke0_cos_2 * constraints_multipliers_5
        - hooke0_sin * constraints_multipliers_6;
    const real constraints_multipliers_10 = hooke0_cos * constraints_multipliers_7
        - hooke0_sin_2 * constraints_multipliers_4;
    const real constraints_multipliers_11 = hooke0_cos_2 * constraints_multipliers_4
        + hooke0_cos * constraints_multipliers_6;
    const real ball0_qdot_5 = work[432];
    const real constraints_multipliers_12 = 2.0 * ball0_qdot_5;
    const real ball0_qdot_6 = work[433];
    const real constraints_multipliers_13 = 2.0 * ball0_qdot_6;
    const real ball0_qdot_7 = work[434];
    const real constraints_multipliers_14 = 2.0 * ball0_qdot_7;
    const real ball0_R = work[419];
    const real ball0_qdot_4 = work[431];
    const real constraints_multipliers_15 = ball0_w * constraints_multipliers_12
        - ball0_R * ball0_qdot_4;
    const real ball0_R_2 = work[420];
    const real constraints_multipliers_16 = ball0_w * constraints_multipliers_13
        - ball0_R_2 * ball0_qdot_4;
    const real ball0_R_3 = work[421];
    const real constraints_multipliers_17 = ball0_w * constraints_multipliers_14
        - ball0_R_3 * ball0_qdot_4;
    const real constraints_multipliers_18 = ball0_R * ball0_qdot_5
        + ball0_x * constraints_multipliers_12;
    const real constraints_multipliers_19 = ball0_R_2 * ball0_qdot_5
        + ball0_x * constraints_multipliers_13;
    const real constraints_multipliers_20 = ball0_R_3 * ball0_qdot_5
        + ball0_x * constraints_multipliers_14;
    const real constraints_multipliers_21 = ball0_R_2 * ball0_qdot_6
        + ball0_y * constraints_multipliers_13;
    const real constraints_multipliers_22 = ball0_R_3 * ball0_qdot_6
        + ball0_y * constraints_multipliers_14;
    const real constraints_multipliers_23 = ball0_R_3 * ball0_qdot_7
        + ball0_z * constraints_multipliers_14;
    const real constraints_multipliers_24 = constraints_multipliers_21 + constraints_multipliers_23;
    const real constraints_multipliers_25 = constraints_multipliers_19 - constraints_multipliers_17;
    const real constraints_multipliers_26 = constraints_multipliers_16 + constraints_multipliers_20;
    const real constraints_multipliers_27 = constraints_multipliers_17 + constraints_multipliers_19;
    const real constraints_multipliers_28 = constraints_multipliers_18 + constraints_multipliers_23;
    const real constraints_multipliers_29 = constraints_multipliers_22 - constraints_multipliers_15;
    const real constraints_multipliers_30 = constraints_multipliers_20 - constraints_multipliers_16;
    const real constraints_multipliers_31 = constraints_multipliers_15 + constraints_multipliers_22;
    const real constraints_multipliers_32 = constraints_multipliers_18 + constraints_multipliers_21;
    const real ball0_R_zx = work[428];
    const real constraints_multipliers_33 = ball0_R_zx * constraints_multipliers_7
        + hooke0_sin_2 * constraints_multipliers_30;
    const real ball0_R_xx = work[422];
    const real constraints_multipliers_34 = constraints_multipliers_33
        - (ball0_R_xx * constraints_multipliers_6 + hooke0_cos_2 * constraints_multipliers_24);
    const real ball0_R_xy = work[423];
    const real constraints_multipliers_35 = hooke0_cos_2 * constraints_multipliers_25
        - ball0_R_xy * constraints_multipliers_6;
    const real ball0_R_zy = work[429];
    const real constraints_multipliers_36 = ball0_R_zy * constraints_multipliers_7
        + hooke0_sin_2 * constraints_multipliers_31 + constraints_multipliers_35;
    const real ball0_R_xz = work[424];
    const real constraints_multipliers_37 = hooke0_cos_2 * constraints_multipliers_26
        - ball0_R_xz * constraints_multipliers_6;
    const real ball0_R_zz = work[430];
    const real constraints_multipliers_38 = ball0_R_zz * constraints_multipliers_7
        - hooke0_sin_2 * constraints_multipliers_32 + constraints_multipliers_37;
    const real hooke0_R_yx = work[414];
    const real constraints_multipliers_39 = ball0_R_xx * constraints_multipliers_8
        - hooke0_R_yx * constraints_multipliers_24;
    const real ball0_R_yx = work[425];
    const real constraints_multipliers_40 = hooke0_cos * constraints_multipliers_27
        - ball0_R_yx * constraints_multipliers_4 + constraints_multipliers_39;
    const real hooke0_R = work[415];
    const real constraints_multipliers_41 = constraints_multipliers_40
        - (ball0_R_zx * constraints_multipliers_9 + hooke0_R * constraints_multipliers_30);
    const real constraints_multipliers_42 = ball0_R_xy * constraints_multipliers_8
        + hooke0_R_yx * constraints_multipliers_25;
    const real ball0_R_yy = work[426];
    const real constraints_multipliers_43 = constraints_multipliers_42
        - (ball0_R_yy * constraints_multipliers_4 + hooke0_cos * constraints_multipliers_28);
    const real constraints_multipliers_44 = constraints_multipliers_43
        - (ball0_R_zy * constraints_multipliers_9 + hooke0_R * constraints_multipliers_31);
    const real constraints_multipliers_45 = ball0_R_xz * constraints_multipliers_8
        + hooke0_R_yx * constraints_multipliers_26;
    const real ball0_R_yz = work[427];
    const real constraints_multipliers_46 = hooke0_cos * constraints_multipliers_29
        - ball0_R_yz * constraints_multipliers_4 + constraints_multipliers_45;
    const real constraints_multipliers_47 = constraints_multipliers_46
        - (ball0_R_zz * constraints_multipliers_9 - hooke0_R * constraints_multipliers_32);
    const real constraints_multipliers_48 = ball0_R_yx * constraints_multipliers_5
        + hooke0_sin * constraints_multipliers_27;
    const real hooke0_R_2 = work[416];
    const real constraints_multipliers_49 = constraints_multipliers_48
        - (ball0_R_xx * constraints_multipliers_10 - hooke0_R_2 * constraints_multipliers_24);
    const real hooke0_R_zz = work[417];
    const real constraints_multipliers_50 = hooke0_R_zz * constraints_multipliers_30
        - ball0_R_zx * constraints_multipliers_11 + constraints_multipliers_49;
    const real constraints_multipliers_51 = ball0_R_yy * constraints_multipliers_5
        - hooke0_sin * constraints_multipliers_28;
    const real constraints_multipliers_52 = constraints_multipliers_51
        - (ball0_R_xy * constraints_multipliers_10 + hooke0_R_2 * constraints_multipliers_25);
    const real constraints_multipliers_53 = hooke0_R_zz * constraints_multipliers_31
        - ball0_R_zy * constraints_multipliers_11 + constraints_multipliers_52;
    const real constraints_multipliers_54 = ball0_R_yz * constraints_multipliers_5
        + hooke0_sin * constraints_multipliers_29;
    const real constraints_multipliers_55 = constraints_multipliers_54
        - (ball0_R_xz * constraints_multipliers_10 + hooke0_R_2 * constraints_multipliers_26);
    const real constraints_multipliers_56 = constraints_multipliers_55
        - (ball0_R_zz * constraints_multipliers_11 + hooke0_R_zz * constraints_multipliers_32);
    const real ball1_twist_4 = work[450];
    const real constraints_multipliers_57 = ball1_twist_4 + slide0_q * constraints_multipliers_7
        + slide0_position_z * constraints_multipliers_7;
    const real ball1_twist_5 = work[451];
    const real constraints_multipliers_58 = ball1_twist_5 + slide0_q * constraints_multipliers_9
        + slide0_position_z * constraints_multipliers_9;
    const real ball1_twist_6 = work[452];
    const real constraints_multipliers_59 = ball1_twist_6 - slide0_q * constraints_multipliers_11
        - slide0_position_z * constraints_multipliers_11;
    const real hooke1_sin = work[395];
    const real constraints_multipliers_60 = hooke1_u_angle1 * hooke1_sin;
    const real hooke1_cos = work[394];
    const real constraints_multipliers_61 = hooke1_u_angle1 * hooke1_cos;
    const real hooke1_sin_2 = work[397];
    const real constraints_multipliers_62 = hooke1_u_angle2 * hooke1_sin_2;
    const real hooke1_cos_2 = work[396];
    const real constraints_multipliers_63 = hooke1_u_angle2 * hooke1_cos_2;
    const real constraints_multipliers_64 = hooke1_sin_2 * constraints_multipliers_61
        + hooke1_sin * constraints_multipliers_63;
    const real constraints_multipliers_65 = hooke1_cos_2 * constraints_multipliers_61
        - hooke1_sin * constraints_multipliers_62;
    const real constraints_multipliers_66 = hooke1_cos * constraints_multipliers_63
        - hooke1_sin_2 * constraints_multipliers_60;
    const real constraints_multipliers_67 = hooke1_cos_2 * constraints_multipliers_60
        + hooke1_cos * constraints_multipliers_62;
    const real constraints_multipliers_68 = ball1_placement * constraints_multipliers_34
        + ball1_placement_2 * constraints_multipliers_36 + constraints_multipliers_57;
    const real constraints_multipliers_69 = ball1_placement * constraints_multipliers_41
        + ball1_placement_2 * constraints_multipliers_44 - constraints_multipliers_58;
    const real constraints_multipliers_70 = ball1_placement * constraints_multipliers_50
        + ball1_placement_2 * constraints_multipliers_53 + constraints_multipliers_59;
    const real hooke1_R_yx = work[468];
    const real ball1_pose_4 = work[438];
    const real constraints_multipliers_71 = hooke1_R_yx * constraints_multipliers_41
        + ball1_pose_4 * constraints_multipliers_64;
    const real ball1_pose = work[435];
    const real constraints_multipliers_72 = hooke1_cos_2 * constraints_multipliers_34
        - ball1_pose * constraints_multipliers_62 + constraints_multipliers_71;
    const real hooke1_R_2 = work[470];
    const real ball1_pose_7 = work[441];
    const real constraints_multipliers_73 = constraints_multipliers_72
        - (hooke1_R_2 * constraints_multipliers_50 + ball1_pose_7 * constraints_multipliers_66);
    const real ball1_pose_5 = work[439];
    const real constraints_multipliers_74 = hooke1_R_yx * constraints_multipliers_44
        + ball1_pose_5 * constraints_multipliers_64;
    const real ball1_pose_2 = work[436];
    const real constraints_multipliers_75 = hooke1_cos_2 * constraints_multipliers_36
        - ball1_pose_2 * constraints_multipliers_62 + constraints_multipliers_74;
    const real ball1_pose_8 = work[442];
    const real constraints_multipliers_76 = constraints_multipliers_75
        - (hooke1_R_2 * constraints_multipliers_53 + ball1_pose_8 * constraints_multipliers_66);
    const real ball1_pose_6 = work[440];
    const real constraints_multipliers_77 = hooke1_R_yx * constraints_multipliers_47
        + ball1_pose_6 * constraints_multipliers_64;
    const real ball1_pose_3 = work[437];
    const real constraints_multipliers_78 = hooke1_cos_2 * constraints_multipliers_38
        - ball1_pose_3 * constraints_multipliers_62 + constraints_multipliers_77;
    const real ball1_pose_9 = work[443];
    const real constraints_multipliers_79 = constraints_multipliers_78
        - (hooke1_R_2 * constraints_multipliers_56 + ball1_pose_9 * constraints_multipliers_66);
    const real constraints_multipliers_80 = hooke1_cos * constraints_multipliers_41
        - ball1_pose_4 * constraints_multipliers_60;
    const real constraints_multipliers_81 = hooke1_sin * constraints_multipliers_50
        + ball1_pose_7 * constraints_multipliers_61 + constraints_multipliers_80;
    const real constraints_multipliers_82 = hooke1_cos * constraints_multipliers_44
        - ball1_pose_5 * constraints_multipliers_60;
    const real constraints_multipliers_83 = hooke1_sin * constraints_multipliers_53
        + ball1_pose_8 * constraints_multipliers_61 + constraints_multipliers_82;
    const real constraints_multipliers_84 = hooke1_cos * constraints_multipliers_47
        - ball1_pose_6 * constraints_multipliers_60;
    const real constraints_multipliers_85 = hooke1_sin * constraints_multipliers_56
        + ball1_pose_9 * constraints_multipliers_61 + constraints_multipliers_84;
    const real constraints_multipliers_86 = hooke1_sin_2 * constraints_multipliers_34
        + ball1_pose * constraints_multipliers_63;
    const real hooke1_R = work[469];
    const real constraints_multipliers_87 = constraints_multipliers_86
        - (hooke1_R * constraints_multipliers_41 + ball1_pose_4 * constraints_multipliers_65);
    const real hooke1_R_zz = work[471];
    const real constraints_multipliers_88 = hooke1_R_zz * constraints_multipliers_50
        - ball1_pose_7 * constraints_multipliers_67 + constraints_multipliers_87;
    const real constraints_multipliers_89 = hooke1_sin_2 * constraints_multipliers_36
        + ball1_pose_2 * constraints_multipliers_63;
    const real constraints_multipliers_90 = constraints_multipliers_89
        - (hooke1_R * constraints_multipliers_44 + ball1_pose_5 * constraints_multipliers_65);
    const real constraints_multipliers_91 = hooke1_R_zz * constraints_multipliers_53
        - ball1_pose_8 * constraints_multipliers_67 + constraints_multipliers_90;
    const real constraints_multipliers_92 = hooke1_sin_2 * constraints_multipliers_38
        + ball1_pose_3 * constraints_multipliers_63;
    const real constraints_multipliers_93 = constraints_multipliers_92
        - (hooke1_R * constraints_multipliers_47 + ball1_pose_6 * constraints_multipliers_65);
    const real constraints_multipliers_94 = hooke1_R_zz * constraints_multipliers_56
        - ball1_pose_9 * constraints_multipliers_67 + constraints_multipliers_93;
    const real constraints_multipliers_95 = hooke0_u_angle1 * constraints_multipliers_6;
    const real constraints_multipliers_96 = hooke0_u_angle1 * constraints_multipliers_7;
    const real tube0_omega_z = work[519];
    const real constraints_multipliers_97 = tube0_omega_z * constraints_multipliers_7
        + hooke0_sin_2 * constraints_multipliers_96;
    const real tube0_omega_x = work[518];
    const real constraints_multipliers_98 = constraints_multipliers_97
        - (tube0_omega_x * constraints_multipliers_6 + hooke0_cos_2 * constraints_multipliers_95);
    const real constraints_multipliers_99 = tube0_omega_x * constraints_multipliers_8
        - hooke0_R_yx * constraints_multipliers_95;
    const real constraints_multipliers_100 = tube0_omega_z * constraints_multipliers_9
        + hooke0_R * constraints_multipliers_96;
    const real constraints_multipliers_101 = constraints_multipliers_99
        - hooke0_u_angle2 * constraints_multipliers_4 - constraints_multipliers_100;
    const real constraints_multipliers_102 = tube0_omega_x * constraints_multipliers_10
        - hooke0_R_2 * constraints_multipliers_95;
    const real constraints_multipliers_103 = hooke0_R_zz * constraints_multipliers_96
        - tube0_omega_z * constraints_multipliers_11;
    const real constraints_multipliers_104 = hooke0_u_angle2 * constraints_multipliers_5
        - constraints_multipliers_102 + constraints_multipliers_103;
    const real ball1_twist_67 = work[527];
    const real ball1_twist_14 = work[485];
    const real constraints_multipliers_105 = ball1_twist_67 * constraints_multipliers_69
        + ball1_twist_14 * constraints_multipliers_104;
    const real ball1_twist_66 = work[526];
    const real ball1_pose_15 = work[474];
    const real constraints_multipliers_106 = ball1_twist_66 * constraints_multipliers_70
        + ball1_pose_15 * constraints_multipliers_101 - constraints_multipliers_105;
    const real ball1_twist_13 = work[484];
    const real constraints_multipliers_107 = ball1_twist_67 * constraints_multipliers_68
        + ball1_twist_13 * constraints_multipliers_104;
    const real ball1_twist_65 = work[525];
    const real constraints_multipliers_108 = constraints_multipliers_107
        - (ball1_twist_65 * constraints_multipliers_70
        + ball1_pose_15 * constraints_multipliers_98);
    const real constraints_multipliers_109 = ball1_twist_65 * constraints_multipliers_69
        + ball1_twist_14 * constraints_multipliers_98;
    const real constraints_multipliers_110 = constraints_multipliers_109
        - (ball1_twist_66 * constraints_multipliers_68
        + ball1_twist_13 * constraints_multipliers_101);
    const real constraints_multipliers_111 = slide0_u * constraints_multipliers_7;
    const real constraints_multipliers_112 = slide0_u * constraints_multipliers_9;
    const real constraints_multipliers_113 = slide0_u * constraints_multipliers_11;
    const real constraints_multipliers_114 = constraints_multipliers_68
        - constraints_multipliers_57;
    const real constraints_multipliers_115 = constraints_multipliers_58
        + constraints_multipliers_69;
    const real constraints_multipliers_116 = constraints_multipliers_70
        - constraints_multipliers_59;
    const real constraints_multipliers_117 = ball0_u_x * constraints_multipliers_34
        + ball0_u_y * constraints_multipliers_36 + ball0_u_z * constraints_multipliers_38;
    const real constraints_multipliers_118 = ball0_u_x * constraints_multipliers_41
        + ball0_u_y * constraints_multipliers_44 + ball0_u_z * constraints_multipliers_47;
    const real constraints_multipliers_119 = ball0_u_x * constraints_multipliers_50
        + ball0_u_y * constraints_multipliers_53 + ball0_u_z * constraints_multipliers_56;
    const real ball1_twist_8 = work[454];
    const real ball1_twist_23 = work[488];
    const real constraints_multipliers_120 = ball1_twist_8 * constraints_multipliers_116
        + ball1_twist_23 * constraints_multipliers_118;
    const real ball1_twist_9 = work[455];
    const real ball1_twist_22 = work[487];
    const real constraints_multipliers_121 = constraints_multipliers_120
        - (ball1_twist_9 * constraints_multipliers_115
        + ball1_twist_22 * constraints_multipliers_119);
    const real ball1_twist_21 = work[486];
    const real constraints_multipliers_122 = ball1_twist_9 * constraints_multipliers_114
        + ball1_twist_21 * constraints_multipliers_119;
    const real ball1_twist_7 = work[453];
    const real constraints_multipliers_123 = constraints_multipliers_122
        - (ball1_twist_7 * constraints_multipliers_116
        + ball1_twist_23 * constraints_multipliers_117);
    const real constraints_multipliers_124 = ball1_twist_7 * constraints_multipliers_115
        + ball1_twist_22 * constraints_multipliers_117;
    const real constraints_multipliers_125 = constraints_multipliers_124
        - (ball1_twist_8 * constraints_multipliers_114
        + ball1_twist_21 * constraints_multipliers_118);
    const real constraints_multipliers_126 = hooke1_u_angle1 * constraints_multipliers_62;
    const real constraints_multipliers_127 = hooke1_u_angle1 * constraints_multipliers_63;
    const real tube1_omega_z = work[532];
    const real constraints_multipliers_128 = tube1_omega_z * constraints_multipliers_63
        + hooke1_sin_2 * constraints_multipliers_127;
    const real tube1_omega_x = work[531];
    const real constraints_multipliers_129 = constraints_multipliers_128
        - (tube1_omega_x * constraints_multipliers_62 + hooke1_cos_2 * constraints_multipliers_126);
    const real constraints_multipliers_130 = tube1_omega_x * constraints_multipliers_64
        - hooke1_R_yx * constraints_multipliers_126;
    const real constraints_multipliers_131 = tube1_omega_z * constraints_multipliers_65
        + hooke1_R * constraints_multipliers_127;
    const real constraints_multipliers_132 = constraints_multipliers_130
        - hooke1_u_angle2 * constraints_multipliers_60 - constraints_multipliers_131;
    const real constraints_multipliers_133 = tube1_omega_x * constraints_multipliers_66
        - hooke1_R_2 * constraints_multipliers_126;
    const real constraints_multipliers_134 = hooke1_R_zz * constraints_multipliers_127
        - tube1_omega_z * constraints_multipliers_67;
    const real constraints_multipliers_135 = hooke1_u_angle2 * constraints_multipliers_61
        - constraints_multipliers_133 + constraints_multipliers_134;
    const real ball1_twist_76 = work[542];
    const real ball1_twist_34 = work[490];
    const real constraints_multipliers_136 = ball1_twist_76 * constraints_multipliers_69
        + ball1_twist_34 * constraints_multipliers_135;
    const real ball1_twist_75 = work[541];
    const real constraints_multipliers_137 = ball1_twist_75 * constraints_multipliers_70
        + ball1_pose_15 * constraints_multipliers_132 - constraints_multipliers_136;
    const real ball1_twist_33 = work[489];
    const real constraints_multipliers_138 = ball1_twist_76 * constraints_multipliers_68
        + ball1_twist_33 * constraints_multipliers_135;
    const real ball1_twist_74 = work[540];
    const real constraints_multipliers_139 = constraints_multipliers_138
        - (ball1_twist_74 * constraints_multipliers_70
        + ball1_pose_15 * constraints_multipliers_129);
    const real constraints_multipliers_140 = ball1_twist_74 * constraints_multipliers_69
        + ball1_twist_34 * constraints_multipliers_129;
    const real constraints_multipliers_141 = constraints_multipliers_140
        - (ball1_twist_75 * constraints_multipliers_68
        + ball1_twist_33 * constraints_multipliers_132);
    const real constraints_multipliers_142 = constraints_multipliers_106
        + constraints_multipliers_111 + constraints_multipliers_121 - constraints_multipliers_137;
    const real constraints_multipliers_143 = constraints_multipliers_108
        - constraints_multipliers_112 + constraints_multipliers_123 - constraints_multipliers_139;
    const real constraints_multipliers_144 = constraints_multipliers_110
        - constraints_multipliers_113 + constraints_multipliers_125 - constraints_multipliers_141;
    const real constraints_multipliers_145 = constraints_multipliers_142
        - slide1_u * constraints_multipliers_63;
    const real constraints_multipliers_146 = constraints_multipliers_143
        + slide1_u * constraints_multipliers_65;
    const real constraints_multipliers_147 = constraints_multipliers_144
        + slide1_u * constraints_multipliers_67;
    const real ball1_twist_77 = work[543];
    const real constraints_multipliers_148 = ball1_twist_77 * constraints_multipliers_34
        + ball1_pose * constraints_multipliers_145;
    const real ball1_twist_78 = work[544];
    const real constraints_multipliers_149 = ball1_twist_78 * constraints_multipliers_41
        + ball1_pose_4 * constraints_multipliers_146 + constraints_multipliers_148;
    const real ball1_twist_79 = work[545];
    const real constraints_multipliers_150 = ball1_twist_79 * constraints_multipliers_50
        + ball1_pose_7 * constraints_multipliers_147 + constraints_multipliers_149;
    const real constraints_multipliers_151 = ball1_twist_77 * constraints_multipliers_36
        + ball1_pose_2 * constraints_multipliers_145;
    const real constraints_multipliers_152 = ball1_twist_78 * constraints_multipliers_44
        + ball1_pose_5 * constraints_multipliers_146 + constraints_multipliers_151;
    const real constraints_multipliers_153 = ball1_twist_79 * constraints_multipliers_53
        + ball1_pose_8 * constraints_multipliers_147 + constraints_multipliers_152;
    const real constraints_multipliers_154 = ball1_twist_77 * constraints_multipliers_38
        + ball1_pose_3 * constraints_multipliers_145;
    const real constraints_multipliers_155 = ball1_twist_78 * constraints_multipliers_47
        + ball1_pose_6 * constraints_multipliers_146 + constraints_multipliers_154;
    const real constraints_multipliers_156 = ball1_twist_79 * constraints_multipliers_56
        + ball1_pose_9 * constraints_multipliers_147 + constraints_multipliers_155;
    const real hooke2_sin = work[399];
    const real constraints_multipliers_157 = hooke2_u_angle1 * hooke2_sin;
    const real hooke2_cos = work[398];
    const real constraints_multipliers_158 = hooke2_u_angle1 * hooke2_cos;
    const real hooke2_sin_2 = work[401];
    const real constraints_multipliers_159 = hooke2_u_angle2 * hooke2_sin_2;
    const real hooke2_cos_2 = work[400];
    const real constraints_multipliers_160 = hooke2_u_angle2 * hooke2_cos_2;
    const real constraints_multipliers_161 = hooke2_sin_2 * constraints_multipliers_158
        + hooke2_sin * constraints_multipliers_160;
    const real constraints_multipliers_162 = hooke2_cos_2 * constraints_multipliers_158
        - hooke2_sin * constraints_multipliers_159;
    const real constraints_multipliers_163 = hooke2_cos * constraints_multipliers_160
        - hooke2_sin_2 * constraints_multipliers_157;
    const real constraints_multipliers_164 = hooke2_cos_2 * constraints_multipliers_157
        + hooke2_cos * constraints_multipliers_159;
    const real constraints_multipliers_165 = ball2_placement * constraints_multipliers_34
        + ball2_placement_2 * constraints_multipliers_36 + constraints_multipliers_57;
    const real constraints_multipliers_166 = ball2_placement * constraints_multipliers_41
        + ball2_placement_2 * constraints_multipliers_44 - constraints_multipliers_58;
    const real constraints_multipliers_167 = ball2_placement * constraints_multipliers_50
        + ball2_placement_2 * constraints_multipliers_53 + constraints_multipliers_59;
    const real hooke2_R_yx = work[549];
    const real constraints_multipliers_168 = hooke2_R_yx * constraints_multipliers_41
        + ball1_pose_4 * constraints_multipliers_161;
    const real constraints_multipliers_169 = hooke2_cos_2 * constraints_multipliers_34
        - ball1_pose * constraints_multipliers_159 + constraints_multipliers_168;
    const real hooke2_R_2 = work[551];
    const real constraints_multipliers_170 = constraints_multipliers_169
        - (hooke2_R_2 * constraints_multipliers_50 + ball1_pose_7 * constraints_multipliers_163);
    const real constraints_multipliers_171 = hooke2_R_yx * constraints_multipliers_44
        + ball1_pose_5 * constraints_multipliers_161;
    const real constraints_multipliers_172 = hooke2_cos_2 * constraints_multipliers_36
        - ball1_pose_2 * constraints_multipliers_159 + constraints_multipliers_171;
    const real constraints_multipliers_173 = constraints_multipliers_172
        - (hooke2_R_2 * constraints_multipliers_53 + ball1_pose_8 * constraints_multipliers_163);
    const real constraints_multipliers_174 = hooke2_R_yx * constraints_multipliers_47
        + ball1_pose_6 * constraints_multipliers_161;
    const real constraints_multipliers_175 = hooke2_cos_2 * constraints_multipliers_38
        - ball1_pose_3 * constraints_multipliers_159 + constraints_multipliers_174;
    const real constraints_multipliers_176 = constraints_multipliers_175
        - (hooke2_R_2 * constraints_multipliers_56 + ball1_pose_9 * constraints_multipliers_163);
    const real constraints_multipliers_177 = hooke2_cos * constraints_multipliers_41
        - ball1_pose_4 * constraints_multipliers_157;
    const real constraints_multipliers_178 = hooke2_sin * constraints_multipliers_50
        + ball1_pose_7 * constraints_multipliers_158 + constraints_multipliers_177;
    const real constraints_multipliers_179 = hooke2_cos * constraints_multipliers_44
        - ball1_pose_5 * constraints_multipliers_157;
    const real constraints_multipliers_180 = hooke2_sin * constraints_multipliers_53
        + ball1_pose_8 * constraints_multipliers_158 + constraints_multipliers_179;
    const real constraints_multipliers_181 = hooke2_cos * constraints_multipliers_47
        - ball1_pose_6 * constraints_multipliers_157;
    const real constraints_multipliers_182 = hooke2_sin * constraints_multipliers_56
        + ball1_pose_9 * constraints_multipliers_158 + constraints_multipliers_181;
    const real constraints_multipliers_183 = hooke2_sin_2 * constraints_multipliers_34
        + ball1_pose * constraints_multipliers_160;
    const real hooke2_R = work[550];
    const real constraints_multipliers_184 = constraints_multipliers_183
        - (hooke2_R * constraints_multipliers_41 + ball1_pose_4 * constraints_multipliers_162);
    const real hooke2_R_zz = work[552];
    const real constraints_multipliers_185 = hooke2_R_zz * constraints_multipliers_50
        - ball1_pose_7 * constraints_multipliers_164 + constraints_multipliers_184;
    const real constraints_multipliers_186 = hooke2_sin_2 * constraints_multipliers_36
        + ball1_pose_2 * constraints_multipliers_160;
    const real constraints_multipliers_187 = constraints_multipliers_186
        - (hooke2_R * constraints_multipliers_44 + ball1_pose_5 * constraints_multipliers_162);
    const real constraints_multipliers_188 = hooke2_R_zz * constraints_multipliers_53
        - ball1_pose_8 * constraints_multipliers_164 + constraints_multipliers_187;
    const real constraints_multipliers_189 = hooke2_sin_2 * constraints_multipliers_38
        + ball1_pose_3 * constraints_multipliers_160;
    const real constraints_multipliers_190 = constraints_multipliers_189
        - (hooke2_R * constraints_multipliers_47 + ball1_pose_6 * constraints_multipliers_162);
    const real constraints_multipliers_191 = hooke2_R_zz * constraints_multipliers_56
        - ball1_pose_9 * constraints_multipliers_164 + constraints_multipliers_190;
    const real ball2_twist_2 = work[566];
    const real constraints_multipliers_192 = ball2_twist_2 * constraints_multipliers_104
        + ball1_twist_67 * constraints_multipliers_166;
    const real ball2_pose_3 = work[555];
    const real constraints_multipliers_193 = ball2_pose_3 * constraints_multipliers_101
        + ball1_twist_66 * constraints_multipliers_167 - constraints_multipliers_192;
    const real ball2_twist = work[565];
    const real constraints_multipliers_194 = ball2_twist * constraints_multipliers_104
        + ball1_twist_67 * constraints_multipliers_165;
    const real constraints_multipliers_195 = constraints_multipliers_194
        - (ball2_pose_3 * constraints_multipliers_98
        + ball1_twist_65 * constraints_multipliers_167);
    const real constraints_multipliers_196 = ball2_twist_2 * constraints_multipliers_98
        + ball1_twist_65 * constraints_multipliers_166;
    const real constraints_multipliers_197 = constraints_multipliers_196
        - (ball2_twist * constraints_multipliers_101
        + ball1_twist_66 * constraints_multipliers_165);
    const real constraints_multipliers_198 = constraints_multipliers_165
        - constraints_multipliers_57;
    const real constraints_multipliers_199 = constraints_multipliers_58
        + constraints_multipliers_166;
    const real constraints_multipliers_200 = constraints_multipliers_167
        - constraints_multipliers_59;
    const real ball2_twist_14 = work[569];
    const real constraints_multipliers_201 = ball2_twist_14 * constraints_multipliers_118
        + ball1_twist_8 * constraints_multipliers_200;
    const real ball2_twist_13 = work[568];
    const real constraints_multipliers_202 = constraints_multipliers_201
        - (ball2_twist_13 * constraints_multipliers_119
        + ball1_twist_9 * constraints_multipliers_199);
    const real ball2_twist_12 = work[567];
    const real constraints_multipliers_203 = ball2_twist_12 * constraints_multipliers_119
        + ball1_twist_9 * constraints_multipliers_198;
    const real constraints_multipliers_204 = constraints_multipliers_203
        - (ball2_twist_14 * constraints_multipliers_117
        + ball1_twist_7 * constraints_multipliers_200);
    const real constraints_multipliers_205 = ball2_twist_13 * constraints_multipliers_117
        + ball1_twist_7 * constraints_multipliers_199;
    const real constraints_multipliers_206 = constraints_multipliers_205
        - (ball2_twist_12 * constraints_multipliers_118
        + ball1_twist_8 * constraints_multipliers_198);
    const real constraints_multipliers_207 = hooke2_u_angle1 * constraints_multipliers_159;
    const real constraints_multipliers_208 = hooke2_u_angle1 * constraints_multipliers_160;
    const real tube2_omega_z = work[600];
    const real constraints_multipliers_209 = tube2_omega_z * constraints_multipliers_160
        + hooke2_sin_2 * constraints_multipliers_208;
    const real tube2_omega_x = work[599];
    const real constraints_multipliers_210 = constraints_multipliers_209
        - (tube2_omega_x * constraints_multipliers_159
        + hooke2_cos_2 * constraints_multipliers_207);
    const real constraints_multipliers_211 = tube2_omega_x * constraints_multipliers_161
        - hooke2_R_yx * constraints_multipliers_207;
    const real constraints_multipliers_212 = tube2_omega_z * constraints_multipliers_162
        + hooke2_R * constraints_multipliers_208;
    const real constraints_multipliers_213 = constraints_multipliers_211
        - hooke2_u_angle2 * constraints_multipliers_157 - constraints_multipliers_212;
    const real constraints_multipliers_214 = tube2_omega_x * constraints_multipliers_163
        - hooke2_R_2 * constraints_multipliers_207;
    const real constraints_multipliers_215 = hooke2_R_zz * constraints_multipliers_208
        - tube2_omega_z * constraints_multipliers_164;
    const real constraints_multipliers_216 = hooke2_u_angle2 * constraints_multipliers_158
        - constraints_multipliers_214 + constraints_multipliers_215;
    const real ball2_twist_61 = work[610];
    const real ball2_twist_28 = work[571];
    const real constraints_multipliers_217 = ball2_twist_61 * constraints_multipliers_166
        + ball2_twist_28 * constraints_multipliers_216;
    const real ball2_twist_60 = work[609];
    const real constraints_multipliers_218 = ball2_twist_60 * constraints_multipliers_167
        + ball2_pose_3 * constraints_multipliers_213 - constraints_multipliers_217;
    const real ball2_twist_27 = work[570];
    const real constraints_multipliers_219 = ball2_twist_61 * constraints_multipliers_165
        + ball2_twist_27 * constraints_multipliers_216;
    const real ball2_twist_59 = work[608];
    const real constraints_multipliers_220 = constraints_multipliers_219
        - (ball2_twist_59 * constraints_multipliers_167
        + ball2_pose_3 * constraints_multipliers_210);
    const real constraints_multipliers_221 = ball2_twist_59 * constraints_multipliers_166
        + ball2_twist_28 * constraints_multipliers_210;
    const real constraints_multipliers_222 = constraints_multipliers_221
        - (ball2_twist_60 * constraints_multipliers_165
        + ball2_twist_27 * constraints_multipliers_213);
    const real constraints_multipliers_223 = constraints_multipliers_111
        + constraints_multipliers_193 + constraints_multipliers_202 - constraints_multipliers_218;
    const real constraints_multipliers_224 = constraints_multipliers_195
        - constraints_multipliers_112 + constraints_multipliers_204 - constraints_multipliers_220;
    const real constraints_multipliers_225 = constraints_multipliers_197
        - constraints_multipliers_113 + constraints_multipliers_206 - constraints_multipliers_222;
    const real constraints_multipliers_226 = constraints_multipliers_223
        - slide2_u * constraints_multipliers_160;
    const real constraints_multipliers_227 = constraints_multipliers_224
        + slide2_u * constraints_multipliers_162;
    const real constraints_multipliers_228 = constraints_multipliers_225
        + slide2_u * constraints_multipliers_164;
    const real ball2_twist_62 = work[611];
    const real constraints_multipliers_229 = ball2_twist_62 * constraints_multipliers_34
        + ball1_pose * constraints_multipliers_226;
    const real ball2_twist_63 = work[612];
    const real constraints_multipliers_230 = ball2_twist_63 * constraints_multipliers_41
        + ball1_pose_4 * constraints_multipliers_227 + constraints_multipliers_229;
    const real ball2_twist_64 = work[613];
    const real constraints_multipliers_231 = ball2_twist_64 * constraints_multipliers_50
        + ball1_pose_7 * constraints_multipliers_228 + constraints_multipliers_230;
    const real constraints_multipliers_232 = ball2_twist_62 * constraints_multipliers_36
        + ball1_pose_2 * constraints_multipliers_226;
    const real constraints_multipliers_233 = ball2_twist_63 * constraints_multipliers_44
        + ball1_pose_5 * constraints_multipliers_227 + constraints_multipliers_232;
    const real constraints_multipliers_234 = ball2_twist_64 * constraints_multipliers_53
        + ball1_pose_8 * constraints_multipliers_228 + constraints_multipliers_233;
    const real constraints_multipliers_235 = ball2_twist_62 * constraints_multipliers_38
        + ball1_pose_3 * constraints_multipliers_226;
    const real constraints_multipliers_236 = ball2_twist_63 * constraints_multipliers_47
        + ball1_pose_6 * constraints_multipliers_227 + constraints_multipliers_235;
    const real constraints_multipliers_237 = ball2_twist_64 * constraints_multipliers_56
        + ball1_pose_9 * constraints_multipliers_228 + constraints_multipliers_236;
    const real hooke3_sin = work[403];
    const real constraints_multipliers_238 = hooke3_u_angle1 * hooke3_sin;
    const real hooke3_cos = work[402];
    const real constraints_multipliers_239 = hooke3_u_angle1 * hooke3_cos;
    const real hooke3_sin_2 = work[405];
    const real constraints_multipliers_240 = hooke3_u_angle2 * hooke3_sin_2;
    const real hooke3_cos_2 = work[404];
    const real constraints_multipliers_241 = hooke3_u_angle2 * hooke3_cos_2;
    const real constraints_multipliers_242 = hooke3_sin_2 * constraints_multipliers_239
        + hooke3_sin * constraints_multipliers_241;
    const real constraints_multipliers_243 = hooke3_cos_2 * constraints_multipliers_239
        - hooke3_sin * constraints_multipliers_240;
    const real constraints_multipliers_244 = hooke3_cos * constraints_multipliers_241
        - hooke3_sin_2 * constraints_multipliers_238;
    const real constraints_multipliers_245 = hooke3_cos_2 * constraints_multipliers_238
        + hooke3_cos * constraints_multipliers_240;
    const real constraints_multipliers_246 = ball3_placement * constraints_multipliers_34
        + ball3_placement_2 * constraints_multipliers_36 + constraints_multipliers_57;
    const real constraints_multipliers_247 = ball3_placement * constraints_multipliers_41
        + ball3_placement_2 * constraints_multipliers_44 - constraints_multipliers_58;
    const real constraints_multipliers_248 = ball3_placement * constraints_multipliers_50
        + ball3_placement_2 * constraints_multipliers_53 + constraints_multipliers_59;
    const real hooke3_R_yx = work[617];
    const real constraints_multipliers_249 = hooke3_R_yx * constraints_multipliers_41
        + ball1_pose_4 * constraints_multipliers_242;
    const real constraints_multipliers_250 = hooke3_cos_2 * constraints_multipliers_34
        - ball1_pose * constraints_multipliers_240 + constraints_multipliers_249;
    const real hooke3_R_2 = work[619];
    const real constraints_multipliers_251 = constraints_multipliers_250
        - (hooke3_R_2 * constraints_multipliers_50 + ball1_pose_7 * constraints_multipliers_244);
    const real constraints_multipliers_252 = hooke3_R_yx * constraints_multipliers_44
        + ball1_pose_5 * constraints_multipliers_242;
    const real constraints_multipliers_253 = hooke3_cos_2 * constraints_multipliers_36
        - ball1_pose_2 * constraints_multipliers_240 + constraints_multipliers_252;
    const real constraints_multipliers_254 = constraints_multipliers_253
        - (hooke3_R_2 * constraints_multipliers_53 + ball1_pose_8 * constraints_multipliers_244);
    const real constraints_multipliers_255 = hooke3_R_yx * constraints_multipliers_47
        + ball1_pose_6 * constraints_multipliers_242;
    const real constraints_multipliers_256 = hooke3_cos_2 * constraints_multipliers_38
        - ball1_pose_3 * constraints_multipliers_240 + constraints_multipliers_255;
    const real constraints_multipliers_257 = constraints_multipliers_256
        - (hooke3_R_2 * constraints_multipliers_56 + ball1_pose_9 * constraints_multipliers_244);
    const real constraints_multipliers_258 = hooke3_cos * constraints_multipliers_41
        - ball1_pose_4 * constraints_multipliers_238;
    const real constraints_multipliers_259 = hooke3_sin * constraints_multipliers_50
        + ball1_pose_7 * constraints_multipliers_239 + constraints_multipliers_258;
    const real constraints_multipliers_260 = hooke3_cos * constraints_multipliers_44
        - ball1_pose_5 * constraints_multipliers_238;
    const real constraints_multipliers_261 = hooke3_sin * constraints_multipliers_53
        + ball1_pose_8 * constraints_multipliers_239 + constraints_multipliers_260;
    const real constraints_multipliers_262 = hooke3_cos * constraints_multipliers_47
        - ball1_pose_6 * constraints_multipliers_238;
    const real constraints_multipliers_263 = hooke3_sin * constraints_multipliers_56
        + ball1_pose_9 * constraints_multipliers_239 + constraints_multipliers_262;
    const real constraints_multipliers_264 = hooke3_sin_2 * constraints_multipliers_34
        + ball1_pose * constraints_multipliers_241;
    const real hooke3_R = work[618];
    const real constraints_multipliers_265 = constraints_multipliers_264
        - (hooke3_R * constraints_multipliers_41 + ball1_pose_4 * constraints_multipliers_243);
    const real hooke3_R_zz = work[620];
    const real constraints_multipliers_266 = hooke3_R_zz * constraints_multipliers_50
        - ball1_pose_7 * constraints_multipliers_245 + constraints_multipliers_265;
    const real constraints_multipliers_267 = hooke3_sin_2 * constraints_multipliers_36
        + ball1_pose_2 * constraints_multipliers_241;
    const real constraints_multipliers_268 = constraints_multipliers_267
        - (hooke3_R * constraints_multipliers_44 + ball1_pose_5 * constraints_multipliers_243);
    const real constraints_multipliers_269 = hooke3_R_zz * constraints_multipliers_53
        - ball1_pose_8 * constraints_multipliers_245 + constraints_multipliers_268;
    const real constraints_multipliers_270 = hooke3_sin_2 * constraints_multipliers_38
        + ball1_pose_3 * constraints_multipliers_241;
    const real constraints_multipliers_271 = constraints_multipliers_270
        - (hooke3_R * constraints_multipliers_47 + ball1_pose_6 * constraints_multipliers_243);
    const real constraints_multipliers_272 = hooke3_R_zz * constraints_multipliers_56
        - ball1_pose_9 * constraints_multipliers_245 + constraints_multipliers_271;
    const real ball3_twist_2 = work[634];
    const real constraints_multipliers_273 = ball3_twist_2 * constraints_multipliers_104
        + ball1_twist_67 * constraints_multipliers_247;
    const real ball3_pose_3 = work[623];
    const real constraints_multipliers_274 = ball3_pose_3 * constraints_multipliers_101
        + ball1_twist_66 * constraints_multipliers_248 - constraints_multipliers_273;
    const real ball3_twist = work[633];
    const real constraints_multipliers_275 = ball3_twist * constraints_multipliers_104
        + ball1_twist_67 * constraints_multipliers_246;
    const real constraints_multipliers_276 = constraints_multipliers_275
        - (ball3_pose_3 * constraints_multipliers_98
        + ball1_twist_65 * constraints_multipliers_248);
    const real constraints_multipliers_277 = ball3_twist_2 * constraints_multipliers_98
        + ball1_twist_65 * constraints_multipliers_247;
    const real constraints_multipliers_278 = constraints_multipliers_277
        - (ball3_twist * constraints_multipliers_101
        + ball1_twist_66 * constraints_multipliers_246);
    const real constraints_multipliers_279 = constraints_multipliers_246
        - constraints_multipliers_57;
    const real constraints_multipliers_280 = constraints_multipliers_58
        + constraints_multipliers_247;
    const real constraints_multipliers_281 = constraints_multipliers_248
        - constraints_multipliers_59;
    const real ball3_twist_14 = work[637];
    const real constraints_multipliers_282 = ball3_twist_14 * constraints_multipliers_118
        + ball1_twist_8 * constraints_multipliers_281;
    const real ball3_twist_13 = work[636];
    const real constraints_multipliers_283 = constraints_multipliers_282
        - (ball3_twist_13 * constraints_multipliers_119
        + ball1_twist_9 * constraints_multipliers_280);
    const real ball3_twist_12 = work[635];
    const real constraints_multipliers_284 = ball3_twist_12 * constraints_multipliers_119
        + ball1_twist_9 * constraints_multipliers_279;
    const real constraints_multipliers_285 = constraints_multipliers_284
        - (ball3_twist_14 * constraints_multipliers_117
        + ball1_twist_7 * constraints_multipliers_281);
    const real constraints_multipliers_286 = ball3_twist_13 * constraints_multipliers_117
        + ball1_twist_7 * constraints_multipliers_280;
    const real constraints_multipliers_287 = constraints_multipliers_286
        - (ball3_twist_12 * constraints_multipliers_118
        + ball1_twist_8 * constraints_multipliers_279);
    const real constraints_multipliers_288 = hooke3_u_angle1 * constraints_multipliers_240;
    const real constraints_multipliers_289 = hooke3_u_angle1 * constraints_multipliers_241;
    const real tube3_omega_z = work[668];
    const real constraints_multipliers_290 = tube3_omega_z * constraints_multipliers_241
        + hooke3_sin_2 * constraints_multipliers_289;
    const real tube3_omega_x = work[667];
    const real constraints_multipliers_291 = constraints_multipliers_290
        - (tube3_omega_x * constraints_multipliers_240
        + hooke3_cos_2 * constraints_multipliers_288);
    const real constraints_multipliers_292 = tube3_omega_x * constraints_multipliers_242
        - hooke3_R_yx * constraints_multipliers_288;
    const real constraints_multipliers_293 = tube3_omega_z * constraints_multipliers_243
        + hooke3_R * constraints_multipliers_289;
    const real constraints_multipliers_294 = constraints_multipliers_292
        - hooke3_u_angle2 * constraints_multipliers_238 - constraints_multipliers_293;
    const real constraints_multipliers_295 = tube3_omega_x * constraints_multipliers_244
        - hooke3_R_2 * constraints_multipliers_288;
    const real constraints_multipliers_296 = hooke3_R_zz * constraints_multipliers_289
        - tube3_omega_z * constraints_multipliers_245;
    const real constraints_multipliers_297 = hooke3_u_angle2 * constraints_multipliers_239
        - constraints_multipliers_295 + constraints_multipliers_296;
    const real ball3_twist_61 = work[678];
    const real ball3_twist_28 = work[639];
    const real constraints_multipliers_298 = ball3_twist_61 * constraints_multipliers_247
        + ball3_twist_28 * constraints_multipliers_297;
    const real ball3_twist_60 = work[677];
    const real constraints_multipliers_299 = ball3_twist_60 * constraints_multipliers_248
        + ball3_pose_3 * constraints_multipliers_294 - constraints_multipliers_298;
    const real ball3_twist_27 = work[638];
    const real constraints_multipliers_300 = ball3_twist_61 * constraints_multipliers_246
        + ball3_twist_27 * constraints_multipliers_297;
    const real ball3_twist_59 = work[676];
    const real constraints_multipliers_301 = constraints_multipliers_300
        - (ball3_twist_59 * constraints_multipliers_248
        + ball3_pose_3 * constraints_multipliers_291);
    const real constraints_multipliers_302 = ball3_twist_59 * constraints_multipliers_247
        + ball3_twist_28 * constraints_multipliers_291;
    const real constraints_multipliers_303 = constraints_multipliers_302
        - (ball3_twist_60 * constraints_multipliers_246
        + ball3_twist_27 * constraints_multipliers_294);
    const real constraints_multipliers_304 = constraints_multipliers_111
        + constraints_multipliers_274 + constraints_multipliers_283 - constraints_multipliers_299;
    const real constraints_multipliers_305 = constraints_multipliers_276
        - constraints_multipliers_112 + constraints_multipliers_285 - constraints_multipliers_301;
    const real constraints_multipliers_306 = constraints_multipliers_278
        - constraints_multipliers_113 + constraints_multipliers_287 - constraints_multipliers_303;
    const real constraints_multipliers_307 = constraints_multipliers_304
        - slide3_u * constraints_multipliers_241;
    const real constraints_multipliers_308 = constraints_multipliers_305
        + slide3_u * constraints_multipliers_243;
    const real constraints_multipliers_309 = constraints_multipliers_306
        + slide3_u * constraints_multipliers_245;
    const real ball3_twist_62 = work[679];
    const real constraints_multipliers_310 = ball3_twist_62 * constraints_multipliers_34
        + ball1_pose * constraints_multipliers_307;
    const real ball3_twist_63 = work[680];
    const real constraints_multipliers_311 = ball3_twist_63 * constraints_multipliers_41
        + ball1_pose_4 * constraints_multipliers_308 + constraints_multipliers_310;
    const real ball3_twist_64 = work[681];
    const real constraints_multipliers_312 = ball3_twist_64 * constraints_multipliers_50
        + ball1_pose_7 * constraints_multipliers_309 + constraints_multipliers_311;
    const real constraints_multipliers_313 = ball3_twist_62 * constraints_multipliers_36
        + ball1_pose_2 * constraints_multipliers_307;
    const real constraints_multipliers_314 = ball3_twist_63 * constraints_multipliers_44
        + ball1_pose_5 * constraints_multipliers_308 + constraints_multipliers_313;
    const real constraints_multipliers_315 = ball3_twist_64 * constraints_multipliers_53
        + ball1_pose_8 * constraints_multipliers_309 + constraints_multipliers_314;
    const real constraints_multipliers_316 = ball3_twist_62 * constraints_multipliers_38
        + ball1_pose_3 * constraints_multipliers_307;
    const real constraints_multipliers_317 = ball3_twist_63 * constraints_multipliers_47
        + ball1_pose_6 * constraints_multipliers_308 + constraints_multipliers_316;
    const real constraints_multipliers_318 = ball3_twist_64 * constraints_multipliers_56
        + ball1_pose_9 * constraints_multipliers_309 + constraints_multipliers_317;
    const real hooke4_sin = work[407];
    const real constraints_multipliers_319 = hooke4_u_angle1 * hooke4_sin;
    const real hooke4_cos = work[406];
    const real constraints_multipliers_320 = hooke4_u_angle1 * hooke4_cos;
    const real hooke4_sin_2 = work[409];
    const real constraints_multipliers_321 = hooke4_u_angle2 * hooke4_sin_2;
    const real hooke4_cos_2 = work[408];
    const real constraints_multipliers_322 = hooke4_u_angle2 * hooke4_cos_2;
    const real constraints_multipliers_323 = hooke4_sin_2 * constraints_multipliers_320
        + hooke4_sin * constraints_multipliers_322;
    const real constraints_multipliers_324 = hooke4_cos_2 * constraints_multipliers_320
        - hooke4_sin * constraints_multipliers_321;
    const real constraints_multipliers_325 = hooke4_cos * constraints_multipliers_322
        - hooke4_sin_2 * constraints_multipliers_319;
    const real constraints_multipliers_326 = hooke4_cos_2 * constraints_multipliers_319
        + hooke4_cos * constraints_multipliers_321;
    const real constraints_multipliers_327 = ball4_placement * constraints_multipliers_34
        + ball4_placement_2 * constraints_multipliers_36 + constraints_multipliers_57;
    const real constraints_multipliers_328 = ball4_placement * constraints_multipliers_41
        + ball4_placement_2 * constraints_multipliers_44 - constraints_multipliers_58;
    const real constraints_multipliers_329 = ball4_placement * constraints_multipliers_50
        + ball4_placement_2 * constraints_multipliers_53 + constraints_multipliers_59;
    const real hooke4_R_yx = work[685];
    const real constraints_multipliers_330 = hooke4_R_yx * constraints_multipliers_41
        + ball1_pose_4 * constraints_multipliers_323;
    const real constraints_multipliers_331 = hooke4_cos_2 * constraints_multipliers_34
        - ball1_pose * constraints_multipliers_321 + constraints_multipliers_330;
    const real hooke4_R_2 = work[687];
    const real constraints_multipliers_332 = constraints_multipliers_331
        - (hooke4_R_2 * constraints_multipliers_50 + ball1_pose_7 * constraints_multipliers_325);
    const real constraints_multipliers_333 = hooke4_R_yx * constraints_multipliers_44
        + ball1_pose_5 * constraints_multipliers_323;
    const real constraints_multipliers_334 = hooke4_cos_2 * constraints_multipliers_36
        - ball1_pose_2 * constraints_multipliers_321 + constraints_multipliers_333;
    const real constraints_multipliers_335 = constraints_multipliers_334
        - (hooke4_R_2 * constraints_multipliers_53 + ball1_pose_8 * constraints_multipliers_325);
    const real constraints_multipliers_336 = hooke4_R_yx * constraints_multipliers_47
        + ball1_pose_6 * constraints_multipliers_323;
    const real constraints_multipliers_337 = hooke4_cos_2 * constraints_multipliers_38
        - ball1_pose_3 * constraints_multipliers_321 + constraints_multipliers_336;
    const real constraints_multipliers_338 = constraints_multipliers_337
        - (hooke4_R_2 * constraints_multipliers_56 + ball1_pose_9 * constraints_multipliers_325);
    const real constraints_multipliers_339 = hooke4_cos * constraints_multipliers_41
        - ball1_pose_4 * constraints_multipliers_319;
    const real constraints_multipliers_340 = hooke4_sin * constraints_multipliers_50
        + ball1_pose_7 * constraints_multipliers_320 + constraints_multipliers_339;
    const real constraints_multipliers_341 = hooke4_cos * constraints_multipliers_44
        - ball1_pose_5 * constraints_multipliers_319;
    const real constraints_multipliers_342 = hooke4_sin * constraints_multipliers_53
        + ball1_pose_8 * constraints_multipliers_320 + constraints_multipliers_341;
    const real constraints_multipliers_343 = hooke4_cos * constraints_multipliers_47
        - ball1_pose_6 * constraints_multipliers_319;
    const real constraints_multipliers_344 = hooke4_sin * constraints_multipliers_56
        + ball1_pose_9 * constraints_multipliers_320 + constraints_multipliers_343;
    const real constraints_multipliers_345 = hooke4_sin_2 * constraints_multipliers_34
        + ball1_pose * constraints_multipliers_322;
    const real hooke4_R = work[686];
    const real constraints_multipliers_346 = constraints_multipliers_345
        - (hooke4_R * constraints_multipliers_41 + ball1_pose_4 * constraints_multipliers_324);
    const real hooke4_R_zz = work[688];
    const real constraints_multipliers_347 = hooke4_R_zz * constraints_multipliers_50
        - ball1_pose_7 * constraints_multipliers_326 + constraints_multipliers_346;
    const real constraints_multipliers_348 = hooke4_sin_2 * constraints_multipliers_36
        + ball1_pose_2 * constraints_multipliers_322;
    const real constraints_multipliers_349 = constraints_multipliers_348
        - (hooke4_R * constraints_multipliers_44 + ball1_pose_5 * constraints_multipliers_324);
    const real constraints_multipliers_350 = hooke4_R_zz * constraints_multipliers_53
        - ball1_pose_8 * constraints_multipliers_326 + constraints_multipliers_349;
    const real constraints_multipliers_351 = hooke4_sin_2 * constraints_multipliers_38
        + ball1_pose_3 * constraints_multipliers_322;
    const real constraints_multipliers_352 = constraints_multipliers_351
        - (hooke4_R * constraints_multipliers_47 + ball1_pose_6 * constraints_multipliers_324);
    const real constraints_multipliers_353 = hooke4_R_zz * constraints_multipliers_56
        - ball1_pose_9 * constraints_multipliers_326 + constraints_multipliers_352;
    const real ball4_twist_2 = work[703];
    const real constraints_multipliers_354 = ball4_twist_2 * constraints_multipliers_104
        + ball1_twist_67 * constraints_multipliers_328;
    const real ball4_pose_3 = work[692];
    const real constraints_multipliers_355 = ball4_pose_3 * constraints_multipliers_101
        + ball1_twist_66 * constraints_multipliers_329 - constraints_multipliers_354;
    const real ball4_twist = work[702];
    const real constraints_multipliers_356 = ball4_twist * constraints_multipliers_104
        + ball1_twist_67 * constraints_multipliers_327;
    const real constraints_multipliers_357 = constraints_multipliers_356
        - (ball4_pose_3 * constraints_multipliers_98
        + ball1_twist_65 * constraints_multipliers_329);
    const real constraints_multipliers_358 = ball4_twist_2 * constraints_multipliers_98
        + ball1_twist_65 * constraints_multipliers_328;
    const real constraints_multipliers_359 = constraints_multipliers_358
        - (ball4_twist * constraints_multipliers_101
        + ball1_twist_66 * constraints_multipliers_327);
    const real constraints_multipliers_360 = constraints_multipliers_327
        - constraints_multipliers_57;
    const real constraints_multipliers_361 = constraints_multipliers_58
        + constraints_multipliers_328;
    const real constraints_multipliers_362 = constraints_multipliers_329
        - constraints_multipliers_59;
    const real ball4_twist_14 = work[706];
    const real constraints_multipliers_363 = ball4_twist_14 * constraints_multipliers_118
        + ball1_twist_8 * constraints_multipliers_362;
    const real ball4_twist_13 = work[705];
    const real constraints_multipliers_364 = constraints_multipliers_363
        - (ball4_twist_13 * constraints_multipliers_119
        + ball1_twist_9 * constraints_multipliers_361);
    const real ball4_twist_12 = work[704];
    const real constraints_multipliers_365 = ball4_twist_12 * constraints_multipliers_119
        + ball1_twist_9 * constraints_multipliers_360;
    const real constraints_multipliers_366 = constraints_multipliers_365
        - (ball4_twist_14 * constraints_multipliers_117
        + ball1_twist_7 * constraints_multipliers_362);
    const real constraints_multipliers_367 = ball4_twist_13 * constraints_multipliers_117
        + ball1_twist_7 * constraints_multipliers_361;
    const real constraints_multipliers_368 = constraints_multipliers_367
        - (ball4_twist_12 * constraints_multipliers_118
        + ball1_twist_8 * constraints_multipliers_360);
    const real constraints_multipliers_369 = hooke4_u_angle1 * constraints_multipliers_321;
    const real constraints_multipliers_370 = hooke4_u_angle1 * constraints_multipliers_322;
    const real tube4_omega_z = work[737];
    const real constraints_multipliers_371 = tube4_omega_z * constraints_multipliers_322
        + hooke4_sin_2 * constraints_multipliers_370;
    const real tube4_omega_x = work[736];
    const real constraints_multipliers_372 = constraints_multipliers_371
        - (tube4_omega_x * constraints_multipliers_321
        + hooke4_cos_2 * constraints_multipliers_369);
    const real constraints_multipliers_373 = tube4_omega_x * constraints_multipliers_323
        - hooke4_R_yx * constraints_multipliers_369;
    const real constraints_multipliers_374 = tube4_omega_z * constraints_multipliers_324
        + hooke4_R * constraints_multipliers_370;
    const real constraints_multipliers_375 = constraints_multipliers_373
        - hooke4_u_angle2 * constraints_multipliers_319 - constraints_multipliers_374;
    const real constraints_multipliers_376 = tube4_omega_x * constraints_multipliers_325
        - hooke4_R_2 * constraints_multipliers_369;
    const real constraints_multipliers_377 = hooke4_R_zz * constraints_multipliers_370
        - tube4_omega_z * constraints_multipliers_326;
    const real constraints_multipliers_378 = hooke4_u_angle2 * constraints_multipliers_320
        - constraints_multipliers_376 + constraints_multipliers_377;
    const real ball4_twist_61 = work[741];
    const real ball4_twist_28 = work[708];
    const real constraints_multipliers_379 = ball4_twist_61 * constraints_multipliers_328
        + ball4_twist_28 * constraints_multipliers_378;
    const real ball4_twist_60 = work[740];
    const real constraints_multipliers_380 = ball4_twist_60 * constraints_multipliers_329
        + ball4_pose_3 * constraints_multipliers_375 - constraints_multipliers_379;
    const real ball4_twist_27 = work[707];
    const real constraints_multipliers_381 = ball4_twist_61 * constraints_multipliers_327
        + ball4_twist_27 * constraints_multipliers_378;
    const real ball4_twist_59 = work[739];
    const real constraints_multipliers_382 = constraints_multipliers_381
        - (ball4_twist_59 * constraints_multipliers_329
        + ball4_pose_3 * constraints_multipliers_372);
    const real constraints_multipliers_383 = ball4_twist_59 * constraints_multipliers_328
        + ball4_twist_28 * constraints_multipliers_372;
    const real constraints_multipliers_384 = constraints_multipliers_383
        - (ball4_twist_60 * constraints_multipliers_327
        + ball4_twist_27 * constraints_multipliers_375);
    const real constraints_multipliers_385 = constraints_multipliers_111
        + constraints_multipliers_355 + constraints_multipliers_364 - constraints_multipliers_380;
    const real constraints_multipliers_386 = constraints_multipliers_357
        - constraints_multipliers_112 + constraints_multipliers_366 - constraints_multipliers_382;
    const real constraints_multipliers_387 = constraints_multipliers_359
        - constraints_multipliers_113 + constraints_multipliers_368 - constraints_multipliers_384;
    const real constraints_multipliers_388 = constraints_multipliers_385
        - slide4_u * constraints_multipliers_322;
    const real constraints_multipliers_389 = constraints_multipliers_386
        + slide4_u * constraints_multipliers_324;
    const real constraints_multipliers_390 = constraints_multipliers_387
        + slide4_u * constraints_multipliers_326;
    const real ball4_twist_62 = work[742];
    const real constraints_multipliers_391 = ball4_twist_62 * constraints_multipliers_34
        + ball1_pose * constraints_multipliers_388;
    const real ball4_twist_63 = work[743];
    const real constraints_multipliers_392 = ball4_twist_63 * constraints_multipliers_41
        + ball1_pose_4 * constraints_multipliers_389 + constraints_multipliers_391;
    const real ball4_twist_64 = work[744];
    const real constraints_multipliers_393 = ball4_twist_64 * constraints_multipliers_50
        + ball1_pose_7 * constraints_multipliers_390 + constraints_multipliers_392;
    const real constraints_multipliers_394 = ball4_twist_62 * constraints_multipliers_36
        + ball1_pose_2 * constraints_multipliers_388;
    const real constraints_multipliers_395 = ball4_twist_63 * constraints_multipliers_44
        + ball1_pose_5 * constraints_multipliers_389 + constraints_multipliers_394;
    const real constraints_multipliers_396 = ball4_twist_64 * constraints_multipliers_53
        + ball1_pose_8 * constraints_multipliers_390 + constraints_multipliers_395;
    const real constraints_multipliers_397 = ball4_twist_62 * constraints_multipliers_38
        + ball1_pose_3 * constraints_multipliers_388;
    const real constraints_multipliers_398 = ball4_twist_63 * constraints_multipliers_47
        + ball1_pose_6 * constraints_multipliers_389 + constraints_multipliers_397;
    const real constraints_multipliers_399 = ball4_twist_64 * constraints_multipliers_56
        + ball1_pose_9 * constraints_multipliers_390 + constraints_multipliers_398;
    const real hooke5_sin = work[411];
    const real constraints_multipliers_400 = hooke5_u_angle1 * hooke5_sin;
    const real hooke5_cos = work[410];
    const real constraints_multipliers_401 = hooke5_u_angle1 * hooke5_cos;
    const real hooke5_sin_2 = work[413];
    const real constraints_multipliers_402 = hooke5_u_angle2 * hooke5_sin_2;
    const real hooke5_cos_2 = work[412];
    const real constraints_multipliers_403 = hooke5_u_angle2 * hooke5_cos_2;
    const real constraints_multipliers_404 = hooke5_sin_2 * constraints_multipliers_401
        + hooke5_sin * constraints_multipliers_403;
    const real constraints_multipliers_405 = hooke5_cos_2 * constraints_multipliers_401
        - hooke5_sin * constraints_multipliers_402;
    const real constraints_multipliers_406 = hooke5_cos * constraints_multipliers_403
        - hooke5_sin_2 * constraints_multipliers_400;
    const real constraints_multipliers_407 = hooke5_cos_2 * constraints_multipliers_400
        + hooke5_cos * constraints_multipliers_402;
    const real constraints_multipliers_408 = ball5_placement * constraints_multipliers_34
        + ball5_placement_2 * constraints_multipliers_36 + constraints_multipliers_57;
    const real constraints_multipliers_409 = ball5_placement * constraints_multipliers_41
        + ball5_placement_2 * constraints_multipliers_44 - constraints_multipliers_58;
    const real constraints_multipliers_410 = ball5_placement * constraints_multipliers_50
        + ball5_placement_2 * constraints_multipliers_53 + constraints_multipliers_59;
    const real hooke5_R_yx = work[748];
    const real constraints_multipliers_411 = hooke5_R_yx * constraints_multipliers_41
        + ball1_pose_4 * constraints_multipliers_404;
    const real constraints_multipliers_412 = hooke5_cos_2 * constraints_multipliers_34
        - ball1_pose * constraints_multipliers_402 + constraints_multipliers_411;
    const real hooke5_R_2 = work[750];
    const real constraints_multipliers_413 = constraints_multipliers_412
        - (hooke5_R_2 * constraints_multipliers_50 + ball1_pose_7 * constraints_multipliers_406);
    work[418] = constraints_multipliers_413;
    const real constraints_multipliers_414 = hooke5_R_yx * constraints_multipliers_44
        + ball1_pose_5 * constraints_multipliers_404;
    const real constraints_multipliers_415 = hooke5_cos_2 * constraints_multipliers_36
        - ball1_pose_2 * constraints_multipliers_402 + constraints_multipliers_414;
    const real constraints_multipliers_416 = constraints_multipliers_415
        - (hooke5_R_2 * constraints_multipliers_53 + ball1_pose_8 * constraints_multipliers_406);
    work[444] = constraints_multipliers_416;
    const real constraints_multipliers_417 = hooke5_R_yx * constraints_multipliers_47
        + ball1_pose_6 * constraints_multipliers_404;
    const real constraints_multipliers_418 = hooke5_cos_2 * constraints_multipliers_38
        - ball1_pose_3 * constraints_multipliers_402 + constraints_multipliers_417;
    const real constraints_multipliers_419 = constraints_multipliers_418
        - (hooke5_R_2 * constraints_multipliers_56 + ball1_pose_9 * constraints_multipliers_406);
    work[445] = constraints_multipliers_419;
    const real constraints_multipliers_420 = hooke5_cos * constraints_multipliers_41
        - ball1_pose_4 * constraints_multipliers_400;
    const real constraints_multipliers_421 = hooke5_sin * constraints_multipliers_50
        + ball1_pose_7 * constraints_multipliers_401 + constraints_multipliers_420;
    work[446] = constraints_multipliers_421;
    const real constraints_multipliers_422 = hooke5_cos * constraints_multipliers_44
        - ball1_pose_5 * constraints_multipliers_400;
    const real constraints_multipliers_423 = hooke5_sin * constraints_multipliers_53
        + ball1_pose_8 * constraints_multipliers_401 + constraints_multipliers_422;
    work[447] = constraints_multipliers_423;
    const real constraints_multipliers_424 = hooke5_cos * constraints_multipliers_47
        - ball1_pose_6 * constraints_multipliers_400;
    const real constraints_multipliers_425 = hooke5_sin * constraints_multipliers_56
        + ball1_pose_9 * constraints_multipliers_401 + constraints_multipliers_424;
    work[448] = constraints_multipliers_425;
    const real constraints_multipliers_426 = hooke5_sin_2 * constraints_multipliers_34
        + ball1_pose * constraints_multipliers_403;
    const real hooke5_R = work[749];
    const real constraints_multipliers_427 = constraints_multipliers_426
        - (hooke5_R * constraints_multipliers_41 + ball1_pose_4 * constraints_multipliers_405);
    const real hooke5_R_zz = work[751];
    const real constraints_multipliers_428 = hooke5_R_zz * constraints_multipliers_50
        - ball1_pose_7 * constraints_multipliers_407 + constraints_multipliers_427;
    work[449] = constraints_multipliers_428;
    const real constraints_multipliers_429 = hooke5_sin_2 * constraints_multipliers_36
        + ball1_pose_2 * constraints_multipliers_403;
    const real constraints_multipliers_430 = constraints_multipliers_429
        - (hooke5_R * constraints_multipliers_44 + ball1_pose_5 * constraints_multipliers_405);
    const real constraints_multipliers_431 = hooke5_R_zz * constraints_multipliers_53
        - ball1_pose_8 * constraints_multipliers_407 + constraints_multipliers_430;
    work[456] = constraints_multipliers_431;
    const real constraints_multipliers_432 = hooke5_sin_2 * constraints_multipliers_38
        + ball1_pose_3 * constraints_multipliers_403;
    const real constraints_multipliers_433 = constraints_multipliers_432
        - (hooke5_R * constraints_multipliers_47 + ball1_pose_6 * constraints_multipliers_405);
    const real constraints_multipliers_434 = hooke5_R_zz * constraints_multipliers_56
        - ball1_pose_9 * constraints_multipliers_407 + constraints_multipliers_433;
    work[457] = constraints_multipliers_434;
    const real ball5_twist_2 = work[763];
    const real constraints_multipliers_435 = ball5_twist_2 * constraints_multipliers_104
        + ball1_twist_67 * constraints_multipliers_409;
    const real ball5_pose_3 = work[752];
    const real constraints_multipliers_436 = ball5_pose_3 * constraints_multipliers_101
        + ball1_twist_66 * constraints_multipliers_410 - constraints_multipliers_435;
    const real ball5_twist = work[762];
    const real constraints_multipliers_437 = ball5_twist * constraints_multipliers_104
        + ball1_twist_67 * constraints_multipliers_408;
    const real constraints_multipliers_438 = constraints_multipliers_437
        - (ball5_pose_3 * constraints_multipliers_98
        + ball1_twist_65 * constraints_multipliers_410);
    const real constraints_multipliers_439 = ball5_twist_2 * constraints_multipliers_98
        + ball1_twist_65 * constraints_multipliers_409;
    const real constraints_multipliers_440 = constraints_multipliers_439
        - (ball5_twist * constraints_multipliers_101
        + ball1_twist_66 * constraints_multipliers_408);
    const real constraints_multipliers_441 = constraints_multipliers_408
        - constraints_multipliers_57;
    const real constraints_multipliers_442 = constraints_multipliers_58
        + constraints_multipliers_409;
    const real constraints_multipliers_443 = constraints_multipliers_410
        - constraints_multipliers_59;
    const real ball5_twist_14 = work[766];
    const real constraints_multipliers_444 = ball5_twist_14 * constraints_multipliers_118
        + ball1_twist_8 * constraints_multipliers_443;
    const real ball5_twist_13 = work[765];
    const real constraints_multipliers_445 = constraints_multipliers_444
        - (ball5_twist_13 * constraints_multipliers_119
        + ball1_twist_9 * constraints_multipliers_442);
    const real ball5_twist_12 = work[764];
    const real constraints_multipliers_446 = ball5_twist_12 * constraints_multipliers_119
        + ball1_twist_9 * constraints_multipliers_441;
    const real constraints_multipliers_447 = constraints_multipliers_446
        - (ball5_twist_14 * constraints_multipliers_117
        + ball1_twist_7 * constraints_multipliers_443);
    const real constraints_multipliers_448 = ball5_twist_13 * constraints_multipliers_117
        + ball1_twist_7 * constraints_multipliers_442;
    const real constraints_multipliers_449 = constraints_multipliers_448
        - (ball5_twist_12 * constraints_multipliers_118
        + ball1_twist_8 * constraints_multipliers_441);
    const real constraints_multipliers_450 = hooke5_u_angle1 * constraints_multipliers_402;
    const real constraints_multipliers_451 = hooke5_u_angle1 * constraints_multipliers_403;
    const real tube5_omega_z = work[797];
    const real constraints_multipliers_452 = tube5_omega_z * constraints_multipliers_403
        + hooke5_sin_2 * constraints_multipliers_451;
    const real tube5_omega_x = work[796];
    const real constraints_multipliers_453 = constraints_multipliers_452
        - (tube5_omega_x * constraints_multipliers_402
        + hooke5_cos_2 * constraints_multipliers_450);
    const real constraints_multipliers_454 = tube5_omega_x * constraints_multipliers_404
        - hooke5_R_yx * constraints_multipliers_450;
    const real constraints_multipliers_455 = tube5_omega_z * constraints_multipliers_405
        + hooke5_R * constraints_multipliers_451;
    const real constraints_multipliers_456 = constraints_multipliers_454
        - hooke5_u_angle2 * constraints_multipliers_400 - constraints_multipliers_455;
    const real constraints_multipliers_457 = tube5_omega_x * constraints_multipliers_406
        - hooke5_R_2 * constraints_multipliers_450;
    const real constraints_multipliers_458 = hooke5_R_zz * constraints_multipliers_451
        - tube5_omega_z * constraints_multipliers_407;
    const real constraints_multipliers_459 = hooke5_u_angle2 * constraints_multipliers_401
        - constraints_multipliers_457 + constraints_multipliers_458;
    const real ball5_twist_61 = work[801];
    const real ball5_twist_28 = work[768];
    const real constraints_multipliers_460 = ball5_twist_61 * constraints_multipliers_409
        + ball5_twist_28 * constraints_multipliers_459;
    const real ball5_twist_60 = work[800];
    const real constraints_multipliers_461 = ball5_twist_60 * constraints_multipliers_410
        + ball5_pose_3 * constraints_multipliers_456 - constraints_multipliers_460;
    const real ball5_twist_27 = work[767];
    const real constraints_multipliers_462 = ball5_twist_61 * constraints_multipliers_408
        + ball5_twist_27 * constraints_multipliers_459;
    const real ball5_twist_59 = work[799];
    const real constraints_multipliers_463 = constraints_multipliers_462
        - (ball5_twist_59 * constraints_multipliers_410
        + ball5_pose_3 * constraints_multipliers_453);
    const real constraints_multipliers_464 = ball5_twist_59 * constraints_multipliers_409
        + ball5_twist_28 * constraints_multipliers_453;
    const real constraints_multipliers_465 = constraints_multipliers_464
        - (ball5_twist_60 * constraints_multipliers_408
        + ball5_twist_27 * constraints_multipliers_456);
    const real constraints_multipliers_466 = constraints_multipliers_111
        + constraints_multipliers_436 + constraints_multipliers_445 - constraints_multipliers_461;
    const real constraints_multipliers_467 = constraints_multipliers_438
        - constraints_multipliers_112 + constraints_multipliers_447 - constraints_multipliers_463;
    const real constraints_multipliers_468 = constraints_multipliers_440
        - constraints_multipliers_113 + constraints_multipliers_449 - constraints_multipliers_465;
    const real constraints_multipliers_469 = constraints_multipliers_466
        - slide5_u * constraints_multipliers_403;
    const real constraints_multipliers_470 = constraints_multipliers_467
        + slide5_u * constraints_multipliers_405;
    const real constraints_multipliers_471 = constraints_multipliers_468
        + slide5_u * constraints_multipliers_407;
    const real ball5_twist_62 = work[802];
    const real constraints_multipliers_472 = ball5_twist_62 * constraints_multipliers_34
        + ball1_pose * constraints_multipliers_469;
    const real ball5_twist_63 = work[803];
    const real constraints_multipliers_473 = ball5_twist_63 * constraints_multipliers_41
        + ball1_pose_4 * constraints_multipliers_470 + constraints_multipliers_472;
    const real ball5_twist_64 = work[804];
    const real constraints_multipliers_474 = ball5_twist_64 * constraints_multipliers_50
        + ball1_pose_7 * constraints_multipliers_471 + constraints_multipliers_473;
    work[458] = constraints_multipliers_474;
    const real constraints_multipliers_475 = ball5_twist_62 * constraints_multipliers_36
        + ball1_pose_2 * constraints_multipliers_469;
    const real constraints_multipliers_476 = ball5_twist_63 * constraints_multipliers_44
        + ball1_pose_5 * constraints_multipliers_470 + constraints_multipliers_475;
    const real constraints_multipliers_477 = ball5_twist_64 * constraints_multipliers_53
        + ball1_pose_8 * constraints_multipliers_471 + constraints_multipliers_476;
    work[459] = constraints_multipliers_477;
    const real constraints_multipliers_478 = ball5_twist_62 * constraints_multipliers_38
        + ball1_pose_3 * constraints_multipliers_469;
    const real constraints_multipliers_479 = ball5_twist_63 * constraints_multipliers_47
        + ball1_pose_6 * constraints_multipliers_470 + constraints_multipliers_478;
    const real constraints_multipliers_480 = ball5_twist_64 * constraints_multipliers_56
        + ball1_pose_9 * constraints_multipliers_471 + constraints_multipliers_479;
    work[460] = constraints_multipliers_480;
    const real ball1_twist_80 = work[546];
    const real ball1_pose_16 = work[475];
    const real constraints_multipliers_481 = ball1_twist_80 * constraints_multipliers_73
        + ball1_pose_16 * constraints_multipliers_150;
    const real ball1_twist_81 = work[547];
    const real ball1_pose_17 = work[476];
    const real constraints_multipliers_482 = ball1_twist_81 * constraints_multipliers_76
        + ball1_pose_17 * constraints_multipliers_153 + constraints_multipliers_481;
    const real ball1_twist_82 = work[548];
    const real ball1_pose_18 = work[477];
    const real constraints_multipliers_483 = ball1_twist_82 * constraints_multipliers_79
        + ball1_pose_18 * constraints_multipliers_156 + constraints_multipliers_482;
    work[461] = constraints_multipliers_483;
    const real ball1_pose_19 = work[478];
    const real constraints_multipliers_484 = ball1_twist_80 * constraints_multipliers_81
        + ball1_pose_19 * constraints_multipliers_150;
    const real ball1_pose_20 = work[479];
    const real constraints_multipliers_485 = ball1_twist_81 * constraints_multipliers_83
        + ball1_pose_20 * constraints_multipliers_153 + constraints_multipliers_484;
    const real ball1_pose_21 = work[480];
    const real constraints_multipliers_486 = ball1_twist_82 * constraints_multipliers_85
        + ball1_pose_21 * constraints_multipliers_156 + constraints_multipliers_485;
    work[462] = constraints_multipliers_486;
    const real ball1_pose_22 = work[481];
    const real constraints_multipliers_487 = ball1_twist_80 * constraints_multipliers_88
        + ball1_pose_22 * constraints_multipliers_150;
    const real ball1_pose_23 = work[482];
    const real constraints_multipliers_488 = ball1_twist_81 * constraints_multipliers_91
        + ball1_pose_23 * constraints_multipliers_153 + constraints_multipliers_487;
    const real ball1_pose_24 = work[483];
    const real constraints_multipliers_489 = ball1_twist_82 * constraints_multipliers_94
        + ball1_pose_24 * constraints_multipliers_156 + constraints_multipliers_488;
    work[463] = constraints_multipliers_489;
    const real ball2_twist_65 = work[614];
    const real ball2_pose_4 = work[556];
    const real constraints_multipliers_490 = ball2_twist_65 * constraints_multipliers_170
        + ball2_pose_4 * constraints_multipliers_231;
    const real ball2_twist_66 = work[615];
    const real ball2_pose_5 = work[557];
    const real constraints_multipliers_491 = ball2_twist_66 * constraints_multipliers_173
        + ball2_pose_5 * constraints_multipliers_234 + constraints_multipliers_490;
    const real ball2_twist_67 = work[616];
    const real ball2_pose_6 = work[558];
    const real constraints_multipliers_492 = ball2_twist_67 * constraints_multipliers_176
        + ball2_pose_6 * constraints_multipliers_237 + constraints_multipliers_491;
    work[464] = constraints_multipliers_492;
    const real ball2_pose_7 = work[559];
    const real constraints_multipliers_493 = ball2_twist_65 * constraints_multipliers_178
        + ball2_pose_7 * constraints_multipliers_231;
    const real ball2_pose_8 = work[560];
    const real constraints_multipliers_494 = ball2_twist_66 * constraints_multipliers_180
        + ball2_pose_8 * constraints_multipliers_234 + constraints_multipliers_493;
    const real ball2_pose_9 = work[561];
    const real constraints_multipliers_495 = ball2_twist_67 * constraints_multipliers_182
        + ball2_pose_9 * constraints_multipliers_237 + constraints_multipliers_494;
    work[465] = constraints_multipliers_495;
    const real ball2_pose_10 = work[562];
    const real constraints_multipliers_496 = ball2_twist_65 * constraints_multipliers_185
        + ball2_pose_10 * constraints_multipliers_231;
    const real ball2_pose_11 = work[563];
    const real constraints_multipliers_497 = ball2_twist_66 * constraints_multipliers_188
        + ball2_pose_11 * constraints_multipliers_234 + constraints_multipliers_496;
    const real ball2_pose_12 = work[564];
    const real constraints_multipliers_498 = ball2_twist_67 * constraints_multipliers_191
        + ball2_pose_12 * constraints_multipliers_237 + constraints_multipliers_497;
    work[466] = constraints_multipliers_498;
    const real ball3_twist_65 = work[682];
    const real ball3_pose_4 = work[624];
    const real constraints_multipliers_499 = ball3_twist_65 * constraints_multipliers_251
        + ball3_pose_4 * constraints_multipliers_312;
    const real ball3_twist_66 = work[683];
    const real ball3_pose_5 = work[625];
    const real constraints_multipliers_500 = ball3_twist_66 * constraints_multipliers_254
        + ball3_pose_5 * constraints_multipliers_315 + constraints_multipliers_499;
    const real ball3_twist_67 = work[684];
    const real ball3_pose_6 = work[626];
    const real constraints_multipliers_501 = ball3_twist_67 * constraints_multipliers_257
        + ball3_pose_6 * constraints_multipliers_318 + constraints_multipliers_500;
    work[467] = constraints_multipliers_501;
    const real ball3_pose_7 = work[627];
    const real constraints_multipliers_502 = ball3_twist_65 * constraints_multipliers_259
        + ball3_pose_7 * constraints_multipliers_312;
    const real ball3_pose_8 = work[628];
    const real constraints_multipliers_503 = ball3_twist_66 * constraints_multipliers_261
        + ball3_pose_8 * constraints_multipliers_315 + constraints_multipliers_502;
    const real ball3_pose_9 = work[629];
    const real constraints_multipliers_504 = ball3_twist_67 * constraints_multipliers_263
        + ball3_pose_9 * constraints_multipliers_318 + constraints_multipliers_503;
    work[472] = constraints_multipliers_504;
    const real ball3_pose_10 = work[630];
    const real constraints_multipliers_505 = ball3_twist_65 * constraints_multipliers_266
        + ball3_pose_10 * constraints_multipliers_312;
    const real ball3_pose_11 = work[631];
    const real constraints_multipliers_506 = ball3_twist_66 * constraints_multipliers_269
        + ball3_pose_11 * constraints_multipliers_315 + constraints_multipliers_505;
    const real ball3_pose_12 = work[632];
    const real constraints_multipliers_507 = ball3_twist_67 * constraints_multipliers_272
        + ball3_pose_12 * constraints_multipliers_318 + constraints_multipliers_506;
    work[473] = constraints_multipliers_507;
    const real ball4_twist_65 = work[745];
    const real ball4_pose_4 = work[693];
    const real constraints_multipliers_508 = ball4_twist_65 * constraints_multipliers_332
        + ball4_pose_4 * constraints_multipliers_393;
    const real ball4_twist_66 = work[746];
    const real ball4_pose_5 = work[694];
    const real constraints_multipliers_509 = ball4_twist_66 * constraints_multipliers_335
        + ball4_pose_5 * constraints_multipliers_396 + constraints_multipliers_508;
    const real ball4_twist_67 = work[747];
    const real ball4_pose_6 = work[695];
    const real constraints_multipliers_510 = ball4_twist_67 * constraints_multipliers_338
        + ball4_pose_6 * constraints_multipliers_399 + constraints_multipliers_509;
    work[520] = constraints_multipliers_510;
    const real ball4_pose_7 = work[696];
    const real constraints_multipliers_511 = ball4_twist_65 * constraints_multipliers_340
        + ball4_pose_7 * constraints_multipliers_393;
    const real ball4_pose_8 = work[697];
    const real constraints_multipliers_512 = ball4_twist_66 * constraints_multipliers_342
        + ball4_pose_8 * constraints_multipliers_396 + constraints_multipliers_511;
    const real ball4_pose_9 = work[698];
    const real constraints_multipliers_513 = ball4_twist_67 * constraints_multipliers_344
        + ball4_pose_9 * constraints_multipliers_399 + constraints_multipliers_512;
    work[521] = constraints_multipliers_513;
    const real ball4_pose_10 = work[699];
    const real constraints_multipliers_514 = ball4_twist_65 * constraints_multipliers_347
        + ball4_pose_10 * constraints_multipliers_393;
    const real ball4_pose_11 = work[700];
    const real constraints_multipliers_515 = ball4_twist_66 * constraints_multipliers_350
        + ball4_pose_11 * constraints_multipliers_396 + constraints_multipliers_514;
    const real ball4_pose_12 = work[701];
    const real constraints_multipliers_516 = ball4_twist_67 * constraints_multipliers_353
        + ball4_pose_12 * constraints_multipliers_399 + constraints_multipliers_515;
    work[522] = constraints_multipliers_516;
    return CARDAN_OK;
}

CARDAN_PART int forward_dynamics_part4(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const wreal *const w = in->w;
    (void)out;

    /* constraints: multipliers, D inverse, L */
    const wreal ball0_momentum_fx = w[6];
    const wreal platform_first_moment_z = w[7];
    const wreal rod0_base_mass = w[69];
    const wreal constraints_D_inverse_21 = w[96];
    const wreal constraints_D_inverse_18 = w[97];
    const wreal constraints_D_inverse_15 = w[98];
    const wreal constraints_D_inverse_12 = w[99];
    const wreal constraints_D_inverse_9 = w[100];
    const wreal constraints_D_inverse_6 = w[101];
    const wreal constraints_L_6_5 = w[102];
    const wreal constraints_L_6_4 = w[103];
    const wreal constraints_D_inverse_5 = w[104];
    const wreal constraints_multipliers = w[105];
    const wreal constraints_D_inverse_4 = w[106];
    const real ball5_twist_65 = work[805];
    const real constraints_multipliers_413 = work[418];
    const real ball5_pose_4 = work[753];
    const real constraints_multipliers_474 = work[458];
    const real constraints_multipliers_517 = ball5_twist_65 * constraints_multipliers_413
        + ball5_pose_4 * constraints_multipliers_474;
    const real ball5_twist_66 = work[806];
    const real constraints_multipliers_416 = work[444];
    const real ball5_pose_5 = work[754];
    const real constraints_multipliers_477 = work[459];
    const real constraints_multipliers_518 = ball5_twist_66 * constraints_multipliers_416
        + ball5_pose_5 * constraints_multipliers_477 + constraints_multipliers_517;
    const real ball5_twist_67 = work[807];
    const real constraints_multipliers_419 = work[445];
    const real ball5_pose_6 = work[755];
    const real constraints_multipliers_480 = work[460];
    const real constraints_multipliers_519 = ball5_twist_67 * constraints_multipliers_419
        + ball5_pose_6 * constraints_multipliers_480 + constraints_multipliers_518;
    work[390] = constraints_multipliers_519;
    const real constraints_multipliers_421 = work[446];
    const real ball5_pose_7 = work[756];
    const real constraints_multipliers_520 = ball5_twist_65 * constraints_multipliers_421
        + ball5_pose_7 * constraints_multipliers_474;
    const real constraints_multipliers_423 = work[447];
    const real ball5_pose_8 = work[757];
    const real constraints_multipliers_521 = ball5_twist_66 * constraints_multipliers_423
        + ball5_pose_8 * constraints_multipliers_477 + constraints_multipliers_520;
    const real constraints_multipliers_425 = work[448];
    const real ball5_pose_9 = work[758];
    const real constraints_multipliers_522 = ball5_twist_67 * constraints_multipliers_425
        + ball5_pose_9 * constraints_multipliers_480 + constraints_multipliers_521;
    work[391] = constraints_multipliers_522;
    const real constraints_multipliers_428 = work[449];
    const real ball5_pose_10 = work[759];
    const real constraints_multipliers_523 = ball5_twist_65 * constraints_multipliers_428
        + ball5_pose_10 * constraints_multipliers_474;
    const real constraints_multipliers_431 = work[456];
    const real ball5_pose_11 = work[760];
    const real constraints_multipliers_524 = ball5_twist_66 * constraints_multipliers_431
        + ball5_pose_11 * constraints_multipliers_477 + constraints_multipliers_523;
    const real constraints_multipliers_434 = work[457];
    const real ball5_pose_12 = work[761];
    const real constraints_multipliers_525 = ball5_twist_67 * constraints_multipliers_434
        + ball5_pose_12 * constraints_multipliers_480 + constraints_multipliers_524;
    work[392] = constraints_multipliers_525;
    const real tube5_composite_inertia_yy = work[798];
    const real constraints_D_inverse_20 = 1.0 / tube5_composite_inertia_yy;
    const real M_19_19 = work[810];
    const real constraints_D_inverse_19 = 1.0 / M_19_19;
    const real tube4_composite_inertia_yy = work[738];
    const real constraints_D_inverse_17 = 1.0 / tube4_composite_inertia_yy;
    const real M_16_16 = work[813];
    const real constraints_D_inverse_16 = 1.0 / M_16_16;
    const real tube3_composite_inertia_yy = work[671];
    const real constraints_D_inverse_14 = 1.0 / tube3_composite_inertia_yy;
    const real M_13_13 = work[814];
    const real constraints_D_inverse_13 = 1.0 / M_13_13;
    const real tube2_composite_inertia_yy = work[603];
    const real constraints_D_inverse_11 = 1.0 / tube2_composite_inertia_yy;
    const real M_10_10 = work[815];
    const real constraints_D_inverse_10 = 1.0 / M_10_10;
    const real tube1_composite_inertia_yy = work[535];
    const real constraints_D_inverse_8 = 1.0 / tube1_composite_inertia_yy;
    const real M_7_7 = work[816];
    const real constraints_D_inverse_7 = 1.0 / M_7_7;
    const real M_5_1 = work[820];
    const real M_6_1 = work[822];
    const real constraints_multipliers_526 = M_5_1 - M_6_1 * constraints_L_6_5;
    const real M_5_2 = work[819];
    const real M_6_2 = work[821];
    const real constraints_multipliers_527 = M_5_2 - M_6_2 * constraints_L_6_5;
    const real M_5_3 = work[811];
    const real M_6_3 = work[812];
    const real constraints_multipliers_528 = M_5_3 - M_6_3 * constraints_L_6_5;
    const real ball0_R_zy = work[429];
    const real ball0_R_zz = work[430];
    const real constraints_multipliers_529 = platform_first_moment_z * ball0_R_zy
        + ball0_momentum_fx * ball0_R_zz + M_6_3 * constraints_L_6_4;
    const real constraints_L_6_3 = M_6_3 * constraints_D_inverse_6;
    const real constraints_L_6_2 = M_6_2 * constraints_D_inverse_6;
    const real constraints_L_6_1 = M_6_1 * constraints_D_inverse_6;
    const real M_4_1 = work[818];
    const real constraints_multipliers_530 = M_4_1 - M_6_1 * constraints_L_6_4
        + constraints_multipliers_526 * constraints_multipliers;
    const real M_4_2 = work[817];
    const real constraints_multipliers_531 = M_4_2 - M_6_2 * constraints_L_6_4
        + constraints_multipliers_527 * constraints_multipliers;
    const real constraints_multipliers_532 = constraints_multipliers_528 * constraints_multipliers -
        constraints_multipliers_529;
    const real constraints_L_5_3 = constraints_multipliers_528 * constraints_D_inverse_5;
    const real hooke0_momentum_fz = work[823];
    const real constraints_multipliers_533 = hooke0_momentum_fz - M_6_1 * constraints_L_6_3
        - constraints_multipliers_526 * constraints_L_5_3;
    const real rod0_composite_moment_x = work[808];
    const real constraints_multipliers_534 = rod0_composite_moment_x + M_6_2 * constraints_L_6_3
        + constraints_multipliers_527 * constraints_L_5_3;
    const real constraints_multipliers_535 = rod0_base_mass - M_6_3 * constraints_L_6_3
        - constraints_multipliers_528 * constraints_L_5_3;
    const real constraints_L_5_2 = constraints_multipliers_527 * constraints_D_inverse_5;
    const real hooke0_momentum_my = work[824];
    const real constraints_multipliers_536 = hooke0_momentum_my - M_6_1 * constraints_L_6_2
        - constraints_multipliers_526 * constraints_L_5_2;
    const real tube0_composite_inertia_yy = work[809];
    const real constraints_multipliers_537 = tube0_composite_inertia_yy
        - M_6_2 * constraints_L_6_2 - constraints_multipliers_527 * constraints_L_5_2;
    const real constraints_L_5_1 = constraints_multipliers_526 * constraints_D_inverse_5;
    const real M_1_1 = work[825];
    const real constraints_multipliers_538 = M_1_1 - M_6_1 * constraints_L_6_1
        - constraints_multipliers_526 * constraints_L_5_1;
    const real constraints_L_4_3 = constraints_multipliers_532 * constraints_D_inverse_4;
    const real constraints_multipliers_539 = constraints_multipliers_533
        - constraints_multipliers_530 * constraints_L_4_3;
    const real constraints_multipliers_540 = constraints_multipliers_534
        + constraints_multipliers_531 * constraints_L_4_3;
    const real constraints_L_4_2 = constraints_multipliers_531 * constraints_D_inverse_4;
    const real constraints_multipliers_541 = constraints_multipliers_536
        - constraints_multipliers_530 * constraints_L_4_2;
    const real constraints_multipliers_542 = constraints_multipliers_537
        - constraints_multipliers_531 * constraints_L_4_2;
    const real constraints_L_4_1 = constraints_multipliers_530 * constraints_D_inverse_4;
    const real constraints_multipliers_543 = constraints_multipliers_538
        - constraints_multipliers_530 * constraints_L_4_1;
    const real constraints_D_inverse_3 = 1.0 / (constraints_multipliers_535
        - constraints_multipliers_532 * constraints_L_4_3);
    const real constraints_multipliers_544 = constraints_multipliers_540 * constraints_D_inverse_3;
    const real constraints_multipliers_545 = constraints_multipliers_541
        + constraints_multipliers_539 * constraints_multipliers_544;
    const real constraints_L_3_1 = constraints_multipliers_539 * constraints_D_inverse_3;
    const real constraints_multipliers_546 = constraints_multipliers_543
        - constraints_multipliers_539 * constraints_L_3_1;
    const real constraints_D_inverse_2 = 1.0 / (constraints_multipliers_542
        - constraints_multipliers_540 * constraints_multipliers_544);
    const real constraints_L_2_1 = constraints_multipliers_545 * constraints_D_inverse_2;
    const real constraints_D_inverse_1 = 1.0 / (constraints_multipliers_546
        - constraints_multipliers_545 * constraints_L_2_1);
    const real ball0_drive_y = work[840];
    const real ball0_drive_z = work[841];
    const real constraints_multipliers_547 = ball0_drive_y - ball0_drive_z * constraints_L_6_5;
    const real hooke0_drive_angle1 = work[837];
    const real constraints_multipliers_548 = hooke0_drive_angle1
        - ball0_drive_z * constraints_L_6_1 - constraints_L_5_1 * constraints_multipliers_547;
    const real hooke0_drive_angle2 = work[838];
    const real constraints_multipliers_549 = hooke0_drive_angle2
        - ball0_drive_z * constraints_L_6_2 - constraints_L_5_2 * constraints_multipliers_547;
    const real slide0_drive = work[836];
    const real constraints_multipliers_550 = slide0_drive - ball0_drive_z * constraints_L_6_3
        - constraints_L_5_3 * constraints_multipliers_547;
    const real ball0_drive_x = work[839];
    const real constraints_multipliers_551 = ball0_drive_x - ball0_drive_z * constraints_L_6_4
        + constraints_multipliers * constraints_multipliers_547;
    const real constraints_multipliers_552 = constraints_multipliers_548
        - constraints_L_4_1 * constraints_multipliers_551;
    const real constraints_multipliers_553 = constraints_multipliers_549
        - constraints_L_4_2 * constraints_multipliers_551;
    const real constraints_multipliers_554 = constraints_multipliers_550
        - constraints_L_4_3 * constraints_multipliers_551;
    const real constraints_multipliers_555 = constraints_multipliers_552
        - constraints_L_3_1 * constraints_multipliers_554;
    const real constraints_multipliers_556 = constraints_multipliers_553
        + constraints_multipliers_544 * constraints_multipliers_554;
    const real constraints_multipliers_557 = constraints_D_inverse_1 * (constraints_multipliers_555
        - constraints_L_2_1 * constraints_multipliers_556);
    work[393] = constraints_multipliers_557;
    const real hooke1_drive_angle1 = work[834];
    const real constraints_multipliers_558 = hooke1_drive_angle1 * constraints_D_inverse_7;
    work[394] = constraints_multipliers_558;
    const real hooke1_drive_angle2 = work[835];
    const real constraints_multipliers_559 = hooke1_drive_angle2 * constraints_D_inverse_8;
    work[395] = constraints_multipliers_559;
    const real slide1_drive = work[842];
    const real constraints_multipliers_560 = slide1_drive * constraints_D_inverse_9;
    work[396] = constraints_multipliers_560;
    const real hooke2_drive_angle1 = work[832];
    const real constraints_multipliers_561 = hooke2_drive_angle1 * constraints_D_inverse_10;
    work[397] = constraints_multipliers_561;
    const real hooke2_drive_angle2 = work[833];
    const real constraints_multipliers_562 = hooke2_drive_angle2 * constraints_D_inverse_11;
    work[398] = constraints_multipliers_562;
    const real slide2_drive = work[843];
    const real constraints_multipliers_563 = slide2_drive * constraints_D_inverse_12;
    work[399] = constraints_multipliers_563;
    const real hooke3_drive_angle1 = work[830];
    const real constraints_multipliers_564 = hooke3_drive_angle1 * constraints_D_inverse_13;
    work[400] = constraints_multipliers_564;
    const real hooke3_drive_angle2 = work[831];
    const real constraints_multipliers_565 = hooke3_drive_angle2 * constraints_D_inverse_14;
    work[401] = constraints_multipliers_565;
    const real slide3_drive = work[844];
    const real constraints_multipliers_566 = slide3_drive * constraints_D_inverse_15;
    work[402] = constraints_multipliers_566;
    const real hooke4_drive_angle1 = work[828];
    const real constraints_multipliers_567 = hooke4_drive_angle1 * constraints_D_inverse_16;
    work[403] = constraints_multipliers_567;
    const real hooke4_drive_angle2 = work[829];
    const real constraints_multipliers_568 = hooke4_drive_angle2 * constraints_D_inverse_17;
    work[404] = constraints_multipliers_568;
    const real slide4_drive = work[845];
    const real constraints_multipliers_569 = slide4_drive * constraints_D_inverse_18;
    work[405] = constraints_multipliers_569;
    const real hooke5_drive_angle1 = work[826];
    const real constraints_multipliers_570 = hooke5_drive_angle1 * constraints_D_inverse_19;
    work[406] = constraints_multipliers_570;
    const real hooke5_drive_angle2 = work[827];
    const real constraints_multipliers_571 = hooke5_drive_angle2 * constraints_D_inverse_20;
    work[407] = constraints_multipliers_571;
    const real slide5_drive = work[846];
    const real constraints_multipliers_572 = slide5_drive * constraints_D_inverse_21;
    work[408] = constraints_multipliers_572;
    const real constraints_multipliers_573 = constraints_D_inverse_2 * constraints_multipliers_556 -
        constraints_L_2_1 * constraints_multipliers_557;
    work[409] = constraints_multipliers_573;
    const real constraints_multipliers_574 = constraints_D_inverse_3 * constraints_multipliers_554 -
        constraints_L_3_1 * constraints_multipliers_557;
    const real constraints_multipliers_575 = constraints_multipliers_574
        + constraints_multipliers_544 * constraints_multipliers_573;
    work[410] = constraints_multipliers_575;
    const real constraints_multipliers_576 = constraints_D_inverse_4 * constraints_multipliers_551 -
        constraints_L_4_1 * constraints_multipliers_557;
    const real constraints_multipliers_577 = constraints_multipliers_576
        - constraints_L_4_2 * constraints_multipliers_573;
    const real constraints_multipliers_578 = constraints_multipliers_577
        - constraints_L_4_3 * constraints_multipliers_575;
    work[411] = constraints_multipliers_578;
    const real constraints_multipliers_579 = constraints_D_inverse_5 * constraints_multipliers_547 -
        constraints_L_5_1 * constraints_multipliers_557;
    const real constraints_multipliers_580 = constraints_multipliers_579
        - constraints_L_5_2 * constraints_multipliers_573;
    const real constraints_multipliers_581 = constraints_multipliers_580
        - constraints_L_5_3 * constraints_multipliers_575;
    const real constraints_multipliers_582 = constraints_multipliers_581
        + constraints_multipliers * constraints_multipliers_578;
    work[412] = constraints_multipliers_582;
    const real constraints_multipliers_583 = ball0_drive_z * constraints_D_inverse_6
        - constraints_L_6_1 * constraints_multipliers_557;
    const real constraints_multipliers_584 = constraints_multipliers_583
        - constraints_L_6_2 * constraints_multipliers_573;
    const real constraints_multipliers_585 = constraints_multipliers_584
        - constraints_L_6_3 * constraints_multipliers_575;
    const real constraints_multipliers_586 = constraints_multipliers_585
        - constraints_L_6_4 * constraints_multipliers_578
        - constraints_L_6_5 * constraints_multipliers_582;
    work[413] = constraints_multipliers_586;
    const real ball1_G_5 = work[495];
    const real ball1_G_6 = work[496];
    const real constraints_multipliers_587 = ball1_G_5 - ball1_G_6 * constraints_L_6_5;
    const real ball1_G = work[491];
    const real constraints_multipliers_588 = ball1_G - ball1_G_6 * constraints_L_6_1
        - constraints_L_5_1 * constraints_multipliers_587;
    const real ball1_G_2 = work[492];
    const real constraints_multipliers_589 = ball1_G_2 - ball1_G_6 * constraints_L_6_2
        - constraints_L_5_2 * constraints_multipliers_587;
    const real ball1_G_3 = work[493];
    const real constraints_multipliers_590 = ball1_G_3 - ball1_G_6 * constraints_L_6_3
        - constraints_L_5_3 * constraints_multipliers_587;
    const real ball1_G_4 = work[494];
    const real constraints_multipliers_591 = ball1_G_4 - ball1_G_6 * constraints_L_6_4
        + constraints_multipliers * constraints_multipliers_587;
    const real constraints_multipliers_592 = constraints_multipliers_588
        - constraints_L_4_1 * constraints_multipliers_591;
    const real constraints_multipliers_593 = constraints_multipliers_589
        - constraints_L_4_2 * constraints_multipliers_591;
    const real constraints_multipliers_594 = constraints_multipliers_590
        - constraints_L_4_3 * constraints_multipliers_591;
    const real constraints_multipliers_595 = constraints_multipliers_592
        - constraints_L_3_1 * constraints_multipliers_594;
    const real constraints_multipliers_596 = constraints_multipliers_593
        + constraints_multipliers_544 * constraints_multipliers_594;
    const real constraints_multipliers_597 = constraints_D_inverse_1 * (constraints_multipliers_595
        - constraints_L_2_1 * constraints_multipliers_596);
    work[414] = constraints_multipliers_597;
    const real ball1_G_7 = work[497];
    const real constraints_multipliers_598 = ball1_G_7 * constraints_D_inverse_7;
    work[415] = constraints_multipliers_598;
    const real ball1_G_8 = work[498];
    const real constraints_multipliers_599 = ball1_G_8 * constraints_D_inverse_8;
    work[416] = constraints_multipliers_599;
    const real ball1_G_9 = work[499];
    const real constraints_multipliers_600 = ball1_G_9 * constraints_D_inverse_9;
    work[417] = constraints_multipliers_600;
    const real constraints_multipliers_601 = constraints_D_inverse_2 * constraints_multipliers_596 -
        constraints_L_2_1 * constraints_multipliers_597;
    work[419] = constraints_multipliers_601;
    const real constraints_multipliers_602 = constraints_D_inverse_3 * constraints_multipliers_594 -
        constraints_L_3_1 * constraints_multipliers_597;
    const real constraints_multipliers_603 = constraints_multipliers_602
        + constraints_multipliers_544 * constraints_multipliers_601;
    work[420] = constraints_multipliers_603;
    const real constraints_multipliers_604 = constraints_D_inverse_4 * constraints_multipliers_591 -
        constraints_L_4_1 * constraints_multipliers_597;
    const real constraints_multipliers_605 = constraints_multipliers_604
        - constraints_L_4_2 * constraints_multipliers_601;
    const real constraints_multipliers_606 = constraints_multipliers_605
        - constraints_L_4_3 * constraints_multipliers_603;
    work[421] = constraints_multipliers_606;
    const real constraints_multipliers_607 = constraints_D_inverse_5 * constraints_multipliers_587 -
        constraints_L_5_1 * constraints_multipliers_597;
    const real constraints_multipliers_608 = constraints_multipliers_607
        - constraints_L_5_2 * constraints_multipliers_601;
    const real constraints_multipliers_609 = constraints_multipliers_608
        - constraints_L_5_3 * constraints_multipliers_603;
    const real constraints_multipliers_610 = constraints_multipliers_609
        + constraints_multipliers * constraints_multipliers_606;
    work[422] = constraints_multipliers_610;
    const real constraints_multipliers_611 = ball1_G_6 * constraints_D_inverse_6
        - constraints_L_6_1 * constraints_multipliers_597;
    const real constraints_multipliers_612 = constraints_multipliers_611
        - constraints_L_6_2 * constraints_multipliers_601;
    const real constraints_multipliers_613 = constraints_multipliers_612
        - constraints_L_6_3 * constraints_multipliers_603;
    const real constraints_multipliers_614 = constraints_multipliers_613
        - constraints_L_6_4 * constraints_multipliers_606
        - constraints_L_6_5 * constraints_multipliers_610;
    work[423] = constraints_multipliers_614;
    const real ball1_G_14 = work[504];
    const real ball1_G_15 = work[505];
    const real constraints_multipliers_615 = ball1_G_14 - ball1_G_15 * constraints_L_6_5;
    const real ball1_G_10 = work[500];
    const real constraints_multipliers_616 = ball1_G_10 - ball1_G_15 * constraints_L_6_1
        - constraints_L_5_1 * constraints_multipliers_615;
    const real ball1_G_11 = work[501];
    const real constraints_multipliers_617 = ball1_G_11 - ball1_G_15 * constraints_L_6_2
        - constraints_L_5_2 * constraints_multipliers_615;
    const real ball1_G_12 = work[502];
    const real constraints_multipliers_618 = ball1_G_12 - ball1_G_15 * constraints_L_6_3
        - constraints_L_5_3 * constraints_multipliers_615;
    const real ball1_G_13 = work[503];
    const real constraints_multipliers_619 = ball1_G_13 - ball1_G_15 * constraints_L_6_4
        + constraints_multipliers * constraints_multipliers_615;
    const real constraints_multipliers_620 = constraints_multipliers_616
        - constraints_L_4_1 * constraints_multipliers_619;
    const real constraints_multipliers_621 = constraints_multipliers_617
        - constraints_L_4_2 * constraints_multipliers_619;
    const real constraints_multipliers_622 = constraints_multipliers_618
        - constraints_L_4_3 * constraints_multipliers_619;
    const real constraints_multipliers_623 = constraints_multipliers_620
        - constraints_L_3_1 * constraints_multipliers_622;
    const real constraints_multipliers_624 = constraints_multipliers_621
        + constraints_multipliers_544 * constraints_multipliers_622;
    const real constraints_multipliers_625 = constraints_D_inverse_1 * (constraints_multipliers_623
        - constraints_L_2_1 * constraints_multipliers_624);
    work[424] = constraints_multipliers_625;
    const real ball1_G_16 = work[506];
    const real constraints_multipliers_626 = ball1_G_16 * constraints_D_inverse_7;
    work[425] = constraints_multipliers_626;
    const real ball1_G_17 = work[507];
    const real constraints_multipliers_627 = ball1_G_17 * constraints_D_inverse_8;
    work[426] = constraints_multipliers_627;
    const real ball1_G_18 = work[508];
    const real constraints_multipliers_628 = ball1_G_18 * constraints_D_inverse_9;
    work[427] = constraints_multipliers_628;
    const real constraints_multipliers_629 = constraints_D_inverse_2 * constraints_multipliers_624 -
        constraints_L_2_1 * constraints_multipliers_625;
    work[428] = constraints_multipliers_629;
    const real constraints_multipliers_630 = constraints_D_inverse_3 * constraints_multipliers_622 -
        constraints_L_3_1 * constraints_multipliers_625;
    const real constraints_multipliers_631 = constraints_multipliers_630
        + constraints_multipliers_544 * constraints_multipliers_629;
    work[431] = constraints_multipliers_631;
    const real constraints_multipliers_632 = constraints_D_inverse_4 * constraints_multipliers_619 -
        constraints_L_4_1 * constraints_multipliers_625;
    const real constraints_multipliers_633 = constraints_multipliers_632
        - constraints_L_4_2 * constraints_multipliers_629;
    const real constraints_multipliers_634 = constraints_multipliers_633
        - constraints_L_4_3 * constraints_multipliers_631;
    work[432] = constraints_multipliers_634;
    const real constraints_multipliers_635 = constraints_D_inverse_5 * constraints_multipliers_615 -
        constraints_L_5_1 * constraints_multipliers_625;
    const real constraints_multipliers_636 = constraints_multipliers_635
        - constraints_L_5_2 * constraints_multipliers_629;
    const real constraints_multipliers_637 = constraints_multipliers_636
        - constraints_L_5_3 * constraints_multipliers_631;
    const real constraints_multipliers_638 = constraints_multipliers_637
        + constraints_multipliers * constraints_multipliers_634;
    work[433] = constraints_multipliers_638;
    const real constraints_multipliers_639 = ball1_G_15 * constraints_D_inverse_6
        - constraints_L_6_1 * constraints_multipliers_625;
    const real constraints_multipliers_640 = constraints_multipliers_639
        - constraints_L_6_2 * constraints_multipliers_629;
    const real constraints_multipliers_641 = constraints_multipliers_640
        - constraints_L_6_3 * constraints_multipliers_631;
    const real constraints_multipliers_642 = constraints_multipliers_641
        - constraints_L_6_4 * constraints_multipliers_634
        - constraints_L_6_5 * constraints_multipliers_638;
    work[434] = constraints_multipliers_642;
    const real ball1_G_23 = work[513];
    const real ball1_G_24 = work[514];
    const real constraints_multipliers_643 = ball1_G_23 - ball1_G_24 * constraints_L_6_5;
    const real ball1_G_19 = work[509];
    const real constraints_multipliers_644 = ball1_G_19 - ball1_G_24 * constraints_L_6_1
        - constraints_L_5_1 * constraints_multipliers_643;
    const real ball1_G_20 = work[510];
    const real constraints_multipliers_645 = ball1_G_20 - ball1_G_24 * constraints_L_6_2
        - constraints_L_5_2 * constraints_multipliers_643;
    const real ball1_G_21 = work[511];
    const real constraints_multipliers_646 = ball1_G_21 - ball1_G_24 * constraints_L_6_3
        - constraints_L_5_3 * constraints_multipliers_643;
    const real ball1_G_22 = work[512];
    const real constraints_multipliers_647 = ball1_G_22 - ball1_G_24 * constraints_L_6_4
        + constraints_multipliers * constraints_multipliers_643;
    const real constraints_multipliers_648 = constraints_multipliers_644
        - constraints_L_4_1 * constraints_multipliers_647;
    const real constraints_multipliers_649 = constraints_multipliers_645
        - constraints_L_4_2 * constraints_multipliers_647;
    const real constraints_multipliers_650 = constraints_multipliers_646
        - constraints_L_4_3 * constraints_multipliers_647;
    const real constraints_multipliers_651 = constraints_multipliers_648
        - constraints_L_3_1 * constraints_multipliers_650;
    const real constraints_multipliers_652 = constraints_multipliers_649
        + constraints_multipliers_544 * constraints_multipliers_650;
    const real constraints_multipliers_653 = constraints_D_inverse_1 * (constraints_multipliers_651
        - constraints_L_2_1 * constraints_multipliers_652);
    work[435] = constraints_multipliers_653;
    const real ball1_G_25 = work[515];
    const real constraints_multipliers_654 = ball1_G_25 * constraints_D_inverse_7;
    work[436] = constraints_multipliers_654;
    const real ball1_G_26 = work[516];
    const real constraints_multipliers_655 = ball1_G_26 * constraints_D_inverse_8;
    work[437] = constraints_multipliers_655;
    const real ball1_G_27 = work[517];
    const real constraints_multipliers_656 = ball1_G_27 * constraints_D_inverse_9;
    work[438] = constraints_multipliers_656;
    const real constraints_multipliers_657 = constraints_D_inverse_2 * constraints_multipliers_652 -
        constraints_L_2_1 * constraints_multipliers_653;
    work[439] = constraints_multipliers_657;
    const real constraints_multipliers_658 = constraints_D_inverse_3 * constraints_multipliers_650 -
        constraints_L_3_1 * constraints_multipliers_653;
    const real constraints_multipliers_659 = constraints_multipliers_658
        + constraints_multipliers_544 * constraints_multipliers_657;
    work[440] = constraints_multipliers_659;
    const real constraints_multipliers_660 = constraints_D_inverse_4 * constraints_multipliers_647 -
        constraints_L_4_1 * constraints_multipliers_653;
    const real constraints_multipliers_661 = constraints_multipliers_660
        - constraints_L_4_2 * constraints_multipliers_657;
    const real constraints_multipliers_662 = constraints_multipliers_661
        - constraints_L_4_3 * constraints_multipliers_659;
    work[441] = constraints_multipliers_662;
    const real constraints_multipliers_663 = constraints_D_inverse_5 * constraints_multipliers_643 -
        constraints_L_5_1 * constraints_multipliers_653;
    const real constraints_multipliers_664 = constraints_multipliers_663
        - constraints_L_5_2 * constraints_multipliers_657;
    const real constraints_multipliers_665 = constraints_multipliers_664
        - constraints_L_5_3 * constraints_multipliers_659;
    const real constraints_multipliers_666 = constraints_multipliers_665
        + constraints_multipliers * constraints_multipliers_662;
    work[442] = constraints_multipliers_666;
    const real constraints_multipliers_667 = ball1_G_24 * constraints_D_inverse_6
        - constraints_L_6_1 * constraints_multipliers_653;
    const real constraints_multipliers_668 = constraints_multipliers_667
        - constraints_L_6_2 * constraints_multipliers_657;
    const real constraints_multipliers_669 = constraints_multipliers_668
        - constraints_L_6_3 * constraints_multipliers_659;
    const real constraints_multipliers_670 = constraints_multipliers_669
        - constraints_L_6_4 * constraints_multipliers_662
        - constraints_L_6_5 * constraints_multipliers_666;
    work[443] = constraints_multipliers_670;
    const real ball2_G_5 = work[576];
    const real ball2_G_6 = work[577];
    const real constraints_multipliers_671 = ball2_G_5 - ball2_G_6 * constraints_L_6_5;
    const real ball2_G = work[572];
    const real constraints_multipliers_672 = ball2_G - ball2_G_6 * constraints_L_6_1
        - constraints_L_5_1 * constraints_multipliers_671;
    const real ball2_G_2 = work[573];
    const real constraints_multipliers_673 = ball2_G_2 - ball2_G_6 * constraints_L_6_2
        - constraints_L_5_2 * constraints_multipliers_671;
    const real ball2_G_3 = work[574];
    const real constraints_multipliers_674 = ball2_G_3 - ball2_G_6 * constraints_L_6_3
        - constraints_L_5_3 * constraints_multipliers_671;
    const real ball2_G_4 = work[575];
    const real constraints_multipliers_675 = ball2_G_4 - ball2_G_6 * constraints_L_6_4
        + constraints_multipliers * constraints_multipliers_671;
    const real constraints_multipliers_676 = constraints_multipliers_672
        - constraints_L_4_1 * constraints_multipliers_675;
    const real constraints_multipliers_677 = constraints_multipliers_673
        - constraints_L_4_2 * constraints_multipliers_675;
    const real constraints_multipliers_678 = constraints_multipliers_674
        - constraints_L_4_3 * constraints_multipliers_675;
    const real constraints_multipliers_679 = constraints_multipliers_676
        - constraints_L_3_1 * constraints_multipliers_678;
    const real constraints_multipliers_680 = constraints_multipliers_677
        + constraints_multipliers_544 * constraints_multipliers_678;
    const real constraints_multipliers_681 = constraints_D_inverse_1 * (constraints_multipliers_679
        - constraints_L_2_1 * constraints_multipliers_680);
    work[450] = constraints_multipliers_681;
    const real ball2_G_7 = work[578];
    const real constraints_multipliers_682 = ball2_G_7 * constraints_D_inverse_10;
    work[451] = constraints_multipliers_682;
    const real ball2_G_8 = work[579];
    const real constraints_multipliers_683 = ball2_G_8 * constraints_D_inverse_11;
    work[452] = constraints_multipliers_683;
    const real ball2_G_9 = work[580];
    const real constraints_multipliers_684 = ball2_G_9 * constraints_D_inverse_12;
    work[453] = constraints_multipliers_684;
    const real constraints_multipliers_685 = constraints_D_inverse_2 * constraints_multipliers_680 -
        constraints_L_2_1 * constraints_multipliers_681;
    work[454] = constraints_multipliers_685;
    const real constraints_multipliers_686 = constraints_D_inverse_3 * constraints_multipliers_678 -
        constraints_L_3_1 * constraints_multipliers_681;
    const real constraints_multipliers_687 = constraints_multipliers_686
        + constraints_multipliers_544 * constraints_multipliers_685;
    work[455] = constraints_multipliers_687;
    const real constraints_multipliers_688 = constraints_D_inverse_4 * constraints_multipliers_675 -
        constraints_L_4_1 * constraints_multipliers_681;
    const real constraints_multipliers_689 = constraints_multipliers_688
        - constraints_L_4_2 * constraints_multipliers_685;
    const real constraints_multipliers_690 = constraints_multipliers_689
        - constraints_L_4_3 * constraints_multipliers_687;
    work[468] = constraints_multipliers_690;
    const real constraints_multipliers_691 = constraints_D_inverse_5 * constraints_multipliers_671 -
        constraints_L_5_1 * constraints_multipliers_681;
    const real constraints_multipliers_692 = constraints_multipliers_691
        - constraints_L_5_2 * constraints_multipliers_685;
    const real constraints_multipliers_693 = constraints_multipliers_692
        - constraints_L_5_3 * constraints_multipliers_687;
    const real constraints_multipliers_694 = constraints_multipliers_693
        + constraints_multipliers * constraints_multipliers_690;
    work[469] = constraints_multipliers_694;
    const real constraints_multipliers_695 = ball2_G_6 * constraints_D_inverse_6
        - constraints_L_6_1 * constraints_multipliers_681;
    const real constraints_multipliers_696 = constraints_multipliers_695
        - constraints_L_6_2 * constraints_multipliers_685;
    const real constraints_multipliers_697 = constraints_multipliers_696
        - constraints_L_6_3 * constraints_multipliers_687;
    const real constraints_multipliers_698 = constraints_multipliers_697
        - constraints_L_6_4 * constraints_multipliers_690
        - constraints_L_6_5 * constraints_multipliers_694;
    work[470] = constraints_multipliers_698;
    const real ball2_G_14 = work[585];
    const real ball2_G_15 = work[586];
    const real constraints_multipliers_699 = ball2_G_14 - ball2_G_15 * constraints_L_6_5;
    const real ball2_G_10 = work[581];
    const real constraints_multipliers_700 = ball2_G_10 - ball2_G_15 * constraints_L_6_1
        - constraints_L_5_1 * constraints_multipliers_699;
    const real ball2_G_11 = work[582];
    const real constraints_multipliers_701 = ball2_G_11 - ball2_G_15 * constraints_L_6_2
        - constraints_L_5_2 * constraints_multipliers_699;
    const real ball2_G_12 = work[583];
    const real constraints_multipliers_702 = ball2_G_12 - ball2_G_15 * constraints_L_6_3
        - constraints_L_5_3 * constraints_multipliers_699;
    const real ball2_G_13 = work[584];
    const real constraints_multipliers_703 = ball2_G_13 - ball2_G_15 * constraints_L_6_4
        + constraints_multipliers * constraints_multipliers_699;
    const real constraints_multipliers_704 = constraints_multipliers_700
        - constraints_L_4_1 * constraints_multipliers_703;
    const real constraints_multipliers_705 = constraints_multipliers_701
        - constraints_L_4_2 * constraints_multipliers_703;
    const real constraints_multipliers_706 = constraints_multipliers_702
        - constraints_L_4_3 * constraints_multipliers_703;
    const real constraints_multipliers_707 = constraints_multipliers_704
        - constraints_L_3_1 * constraints_multipliers_706;
    const real constraints_multipliers_708 = constraints_multipliers_705
        + constraints_multipliers_544 * constraints_multipliers_706;
    const real constraints_multipliers_709 = constraints_D_inverse_1 * (constraints_multipliers_707
        - constraints_L_2_1 * constraints_multipliers_708);
    work[471] = constraints_multipliers_709;
    const real ball2_G_16 = work[587];
    const real constraints_multipliers_710 = ball2_G_16 * constraints_D_inverse_10;
    work[474] = constraints_multipliers_710;
    const real ball2_G_17 = work[588];
    const real constraints_multipliers_711 = ball2_G_17 * constraints_D_inverse_11;
    work[475] = constraints_multipliers_711;
    const real ball2_G_18 = work[589];
    const real constraints_multipliers_712 = ball2_G_18 * constraints_D_inverse_12;
    work[476] = constraints_multipliers_712;
    const real constraints_multipliers_713 = constraints_D_inverse_2 * constraints_multipliers_708 -
        constraints_L_2_1 * constraints_multipliers_709;
    work[477] = constraints_multipliers_713;
    const real constraints_multipliers_714 = constraints_D_inverse_3 * constraints_multipliers_706 -
        constraints_L_3_1 * constraints_multipliers_709;
    const real constraints_multipliers_715 = constraints_multipliers_714
        + constraints_multipliers_544 * constraints_multipliers_713;
    work[478] = constraints_multipliers_715;
    const real constraints_multipliers_716 = constraints_D_inverse_4 * constraints_multipliers_703 -
        constraints_L_4_1 * constraints_multipliers_709;
    const real constraints_multipliers_717 = constraints_multipliers_716
        - constraints_L_4_2 * constraints_multipliers_713;
    const real constraints_multipliers_718 = constraints_multipliers_717
        - constraints_L_4_3 * constraints_multipliers_715;
    work[479] = constraints_multipliers_718;
    const real constraints_multipliers_719 = constraints_D_inverse_5 * constraints_multipliers_699 -
        constraints_L_5_1 * constraints_multipliers_709;
    const real constraints_multipliers_720 = constraints_multipliers_719
        - constraints_L_5_2 * constraints_multipliers_713;
    const real constraints_multipliers_721 = constraints_multipliers_720
        - constraints_L_5_3 * constraints_multipliers_715;
    const real constraints_multipliers_722 = constraints_multipliers_721
        + constraints_multipliers * constraints_multipliers_718;
    work[480] = constraints_multipliers_722;
    const real constraints_multipliers_723 = ball2_G_15 * constraints_D_inverse_6
        - constraints_L_6_1 * constraints_multipliers_709;
    const real constraints_multipliers_724 = constraints_multipliers_723
        - constraints_L_6_2 * constraints_multipliers_713;
    const real constraints_multipliers_725 = constraints_multipliers_724
        - constraints_L_6_3 * constraints_multipliers_715;
    const real constraints_multipliers_726 = constraints_multipliers_725
        - constraints_L_6_4 * constraints_multipliers_718
        - constraints_L_6_5 * constraints_multipliers_722;
    work[481] = constraints_multipliers_726;
    const real ball2_G_23 = work[594];
    const real ball2_G_24 = work[595];
    const real constraints_multipliers_727 = ball2_G_23 - ball2_G_24 * constraints_L_6_5;
    const real ball2_G_19 = work[590];
    const real constraints_multipliers_728 = ball2_G_19 - ball2_G_24 * constraints_L_6_1
        - constraints_L_5_1 * constraints_multipliers_727;
    const real ball2_G_20 = work[591];
    const real constraints_multipliers_729 = ball2_G_20 - ball2_G_24 * constraints_L_6_2
        - constraints_L_5_2 * constraints_multipliers_727;
    const real ball2_G_21 = work[592];
    const real constraints_multipliers_730 = ball2_G_21 - ball2_G_24 * constraints_L_6_3
        - constraints_L_5_3 * constraints_multipliers_727;
    const real ball2_G_22 = work[593];
    const real constraints_multipliers_731 = ball2_G_22 - ball2_G_24 * constraints_L_6_4
        + constraints_multipliers * constraints_multipliers_727;
    const real constraints_multipliers_732 = constraints_multipliers_728
        - constraints_L_4_1 * constraints_multipliers_731;
    const real constraints_multipliers_733 = constraints_multipliers_729
        - constraints_L_4_2 * constraints_multipliers_731;
    const real constraints_multipliers_734 = constraints_multipliers_730
        - constraints_L_4_3 * constraints_multipliers_731;
    const real constraints_multipliers_735 = constraints_multipliers_732
        - constraints_L_3_1 * constraints_multipliers_734;
    const real constraints_multipliers_736 = constraints_multipliers_733
        + constraints_multipliers_544 * constraints_multipliers_734;
    const real constraints_multipliers_737 = constraints_D_inverse_1 * (constraints_multipliers_735
        - constraints_L_2_1 * constraints_multipliers_736);
    work[482] = constraints_multipliers_737;
    const real ball2_G_25 = work[596];
    const real constraints_multipliers_738 = ball2_G_25 * constraints_D_inverse_10;
    work[483] = constraints_multipliers_738;
    const real ball2_G_26 = work[597];
    const real constraints_multipliers_739 = ball2_G_26 * constraints_D_inverse_11;
    work[484] = constraints_multipliers_739;
    const real ball2_G_27 = work[598];
    const real constraints_multipliers_740 = ball2_G_27 * constraints_D_inverse_12;
    work[485] = constraints_multipliers_740;
    const real constraints_multipliers_741 = constraints_D_inverse_2 * constraints_multipliers_736 -
        constraints_L_2_1 * constraints_multipliers_737;
    work[486] = constraints_multipliers_741;
    const real constraints_multipliers_742 = constraints_D_inverse_3 * constraints_multipliers_734 -
        constraints_L_3_1 * constraints_multipliers_737;
    const real constraints_multipliers_743 = constraints_multipliers_742
        + constraints_multipliers_544 * constraints_multipliers_741;
    work[487] = constraints_multipliers_743;
    const real constraints_multipliers_744 = constraints_D_inverse_4 * constraints_multipliers_731 -
        constraints_L_4_1 * constraints_multipliers_737;
    const real constraints_multipliers_745 = constraints_multipliers_744
        - constraints_L_4_2 * constraints_multipliers_741;
    const real constraints_multipliers_746 = constraints_multipliers_745
        - constraints_L_4_3 * constraints_multipliers_743;
    work[488] = constraints_multipliers_746;
    const real constraints_multipliers_747 = constraints_D_inverse_5 * constraints_multipliers_727 -
        constraints_L_5_1 * constraints_multipliers_737;
    const real constraints_multipliers_748 = constraints_multipliers_747
        - constraints_L_5_2 * constraints_multipliers_741;
    const real constraints_multipliers_749 = constraints_multipliers_748
        - constraints_L_5_3 * constraints_multipliers_743;
    const real constraints_multipliers_750 = constraints_multipliers_749
        + constraints_multipliers * constraints_multipliers_746;
    work[489] = constraints_multipliers_750;
    const real constraints_multipliers_751 = ball2_G_24 * constraints_D_inverse_6
        - constraints_L_6_1 * constraints_multipliers_737;
    const real constraints_multipliers_752 = constraints_multipliers_751
        - constraints_L_6_2 * constraints_multipliers_741;
    const real constraints_multipliers_753 = constraints_multipliers_752
        - constraints_L_6_3 * constraints_multipliers_743;
    const real constraints_multipliers_754 = constraints_multipliers_753
        - constraints_L_6_4 * constraints_multipliers_746
        - constraints_L_6_5 * constraints_multipliers_750;
    work[490] = constraints_multipliers_754;
    const real ball3_G_5 = work[644];
    const real ball3_G_6 = work[645];
    const real constraints_multipliers_755 = ball3_G_5 - ball3_G_6 * constraints_L_6_5;
    const real ball3_G = work[640];
    const real constraints_multipliers_756 = ball3_G - ball3_G_6 * constraints_L_6_1
        - constraints_L_5_1 * constraints_multipliers_755;
    const real ball3_G_2 = work[641];
    const real constraints_multipliers_757 = ball3_G_2 - ball3_G_6 * constraints_L_6_2
        - constraints_L_5_2 * constraints_multipliers_755;
    const real ball3_G_3 = work[642];
    const real constraints_multipliers_758 = ball3_G_3 - ball3_G_6 * constraints_L_6_3
        - constraints_L_5_3 * constraints_multipliers_755;
    const real ball3_G_4 = work[643];
    const real constraints_multipliers_759 = ball3_G_4 - ball3_G_6 * constraints_L_6_4
        + constraints_multipliers * constraints_multipliers_755;
    const real constraints_multipliers_760 = constraints_multipliers_756
        - constraints_L_4_1 * constraints_multipliers_759;
    const real constraints_multipliers_761 = constraints_multipliers_757
        - constraints_L_4_2 * constraints_multipliers_759;
    const real constraints_multipliers_762 = constraints_multipliers_758
        - constraints_L_4_3 * constraints_multipliers_759;
    const real constraints_multipliers_763 = constraints_multipliers_760
        - constraints_L_3_1 * constraints_multipliers_762;
    const real constraints_multipliers_764 = constraints_multipliers_761
        + constraints_multipliers_544 * constraints_multipliers_762;
    const real constraints_multipliers_765 = constraints_D_inverse_1 * (constraints_multipliers_763
        - constraints_L_2_1 * constraints_multipliers_764);
    work[518] = constraints_multipliers_765;
    const real ball3_G_7 = work[646];
    const real constraints_multipliers_766 = ball3_G_7 * constraints_D_inverse_13;
    work[519] = constraints_multipliers_766;
    const real ball3_G_8 = work[647];
    const real constraints_multipliers_767 = ball3_G_8 * constraints_D_inverse_14;
    work[523] = constraints_multipliers_767;
    const real ball3_G_9 = work[648];
    const real constraints_multipliers_768 = ball3_G_9 * constraints_D_inverse_15;
    work[524] = constraints_multipliers_768;
    const real constraints_multipliers_769 = constraints_D_inverse_2 * constraints_multipliers_764 -
        constraints_L_2_1 * constraints_multipliers_765;
    work[525] = constraints_multipliers_769;
    const real constraints_multipliers_770 = constraints_D_inverse_3 * constraints_multipliers_762 -
        constraints_L_3_1 * constraints_multipliers_765;
    const real constraints_multipliers_771 = constraints_multipliers_770
        + constraints_multipliers_544 * constraints_multipliers_769;
    work[526] = constraints_multipliers_771;
    const real constraints_multipliers_772 = constraints_D_inverse_4 * constraints_multipliers_759 -
        constraints_L_4_1 * constraints_multipliers_765;
    const real constraints_multipliers_773 = constraints_multipliers_772
        - constraints_L_4_2 * constraints_multipliers_769;
    const real constraints_multipliers_774 = constraints_multipliers_773
        - constraints_L_4_3 * constraints_multipliers_771;
    work[527] = constraints_multipliers_774;
    const real constraints_multipliers_775 = constraints_D_inverse_5 * constraints_multipliers_755 -
        constraints_L_5_1 * constraints_multipliers_765;
    const real constraints_multipliers_776 = constraints_multipliers_775
        - constraints_L_5_2 * constraints_multipliers_769;
    const real constraints_multipliers_777 = constraints_multipliers_776
        - constraints_L_5_3 * constraints_multipliers_771;
    const real constraints_multipliers_778 = constraints_multipliers_777
        + constraints_multipliers * constraints_multipliers_774;
    work[528] = constraints_multipliers_778;
    const real constraints_multipliers_779 = ball3_G_6 * constraints_D_inverse_6
        - constraints_L_6_1 * constraints_multipliers_765;
    const real constraints_multipliers_780 = constraints_multipliers_779
        - constraints_L_6_2 * constraints_multipliers_769;
    const real constraints_multipliers_781 = constraints_multipliers_780
        - constraints_L_6_3 * constraints_multipliers_771;
    const real constraints_multipliers_782 = constraints_multipliers_781
        - constraints_L_6_4 * constraints_multipliers_774
        - constraints_L_6_5 * constraints_multipliers_778;
    work[529] = constraints_multipliers_782;
    const real ball3_G_14 = work[653];
    const real ball3_G_15 = work[654];
    const real constraints_multipliers_783 = ball3_G_14 - ball3_G_15 * constraints_L_6_5;
    const real ball3_G_10 = work[649];
    const real constraints_multipliers_784 = ball3_G_10 - ball3_G_15 * constraints_L_6_1
        - constraints_L_5_1 * constraints_multipliers_783;
    const real ball3_G_11 = work[650];
    const real constraints_multipliers_785 = ball3_G_11 - ball3_G_15 * constraints_L_6_2
        - constraints_L_5_2 * constraints_multipliers_783;
    const real ball3_G_12 = work[651];
    const real constraints_multipliers_786 = ball3_G_12 - ball3_G_15 * constraints_L_6_3
        - constraints_L_5_3 * constraints_multipliers_783;
    const real ball3_G_13 = work[652];
    const real constraints_multipliers_787 = ball3_G_13 - ball3_G_15 * constraints_L_6_4
        + constraints_multipliers * constraints_multipliers_783;
    const real constraints_multipliers_788 = constraints_multipliers_784
        - constraints_L_4_1 * constraints_multipliers_787;
    const real constraints_multipliers_789 = constraints_multipliers_785
        - constraints_L_4_2 * constraints_multipliers_787;
    const real constraints_multipliers_790 = constraints_multipliers_786
        - constraints_L_4_3 * constraints_multipliers_787;
    const real constraints_multipliers_791 = constraints_multipliers_788
        - constraints_L_3_1 * constraints_multipliers_790;
    const real constraints_multipliers_792 = constraints_multipliers_789
        + constraints_multipliers_544 * constraints_multipliers_790;
    const real constraints_multipliers_793 = constraints_D_inverse_1 * (constraints_multipliers_791
        - constraints_L_2_1 * constraints_multipliers_792);
    work[530] = constraints_multipliers_793;
    const real ball3_G_16 = work[655];
    const real constraints_multipliers_794 = ball3_G_16 * constraints_D_inverse_13;
    work[531] = constraints_multipliers_794;
    const real ball3_G_17 = work[656];
    const real constraints_multipliers_795 = ball3_G_17 * constraints_D_inverse_14;
    work[532] = constraints_multipliers_795;
    const real ball3_G_18 = work[657];
    const real constraints_multipliers_796 = ball3_G_18 * constraints_D_inverse_15;
    work[533] = constraints_multipliers_796;
    const real constraints_multipliers_797 = constraints_D_inverse_2 * constraints_multipliers_792 -
        constraints_L_2_1 * constraints_multipliers_793;
    work[534] = constraints_multipliers_797;
    const real constraints_multipliers_798 = constraints_D_inverse_3 * constraints_multipliers_790 -
        constraints_L_3_1 * constraints_multipliers_793;
    const real constraints_multipliers_799 = constraints_multipliers_798
        + constraints_multipliers_544 * constraints_multipliers_797;
    work[536] = constraints_multipliers_799;
    const real constraints_multipliers_800 = constraints_D_inverse_4 * constraints_multipliers_787 -
        constraints_L_4_1 * constraints_multipliers_793;
    const real constraints_multipliers_801 = constraints_multipliers_800
        - constraints_L_4_2 * constraints_multipliers_797;
    const real constraints_multipliers_802 = constraints_multipliers_801
        - constraints_L_4_3 * constraints_multipliers_799;
    work[537] = constraints_multipliers_802;
    const real constraints_multipliers_803 = constraints_D_inverse_5 * constraints_multipliers_783 -
        constraints_L_5_1 * constraints_multipliers_793;
    const real constraints_multipliers_804 = constraints_multipliers_803
        - constraints_L_5_2 * constraints_multipliers_797;
    const real constraints_multipliers_805 = constraints_multipliers_804
        - constraints_L_5_3 * constraints_multipliers_799;
    const real constraints_multipliers_806 = constraints_multipliers_805
        + constraints_multipliers * constraints_multipliers_802;
    work[538] = constraints_multipliers_806;
    const real constraints_multipliers_807 = ball3_G_15 * constraints_D_inverse_6
        - constraints_L_6_1 * constraints_multipliers_793;
    const real constraints_multipliers_808 = constraints_multipliers_807
        - constraints_L_6_2 * constraints_multipliers_797;
    const real constraints_multipliers_809 = constraints_multipliers_808
        - constraints_L_6_3 * constraints_multipliers_799;
    const real constraints_multipliers_810 = constraints_multipliers_809
        - constraints_L_6_4 * constraints_multipliers_802
        - constraints_L_6_5 * constraints_multipliers_806;
    work[539] = constraints_multipliers_810;
    const real ball3_G_23 = work[662];
    const real ball3_G_24 = work[663];
    const real constraints_multipliers_811 = ball3_G_23 - ball3_G_24 * constraints_L_6_5;
    const real ball3_G_19 = work[658];
    const real constraints_multipliers_812 = ball3_G_19 - ball3_G_24 * constraints_L_6_1
        - constraints_L_5_1 * constraints_multipliers_811;
    const real ball3_G_20 = work[659];
    const real constraints_multipliers_813 = ball3_G_20 - ball3_G_24 * constraints_L_6_2
        - constraints_L_5_2 * constraints_multipliers_811;
    const real ball3_G_21 = work[660];
    const real constraints_multipliers_814 = ball3_G_21 - ball3_G_24 * constraints_L_6_3
        - constraints_L_5_3 * constraints_multipliers_811;
    const real ball3_G_22 = work[661];
    const real constraints_multipliers_815 = ball3_G_22 - ball3_G_24 * constraints_L_6_4
        + constraints_multipliers * constraints_multipliers_811;
    const real constraints_multipliers_816 = constraints_multipliers_812
        - constraints_L_4_1 * constraints_multipliers_815;
    const real constraints_multipliers_817 = constraints_multipliers_813
        - constraints_L_4_2 * constraints_multipliers_815;
    const real constraints_multipliers_818 = constraints_multipliers_814
        - constraints_L_4_3 * constraints_multipliers_815;
    const real constraints_multipliers_819 = constraints_multipliers_816
        - constraints_L_3_1 * constraints_multipliers_818;
    const real constraints_multipliers_820 = constraints_multipliers_817
        + constraints_multipliers_544 * constraints_multipliers_818;
    const real constraints_multipliers_821 = constraints_D_inverse_1 * (constraints_multipliers_819
        - constraints_L_2_1 * constraints_multipliers_820);
    work[540] = constraints_multipliers_821;
    const real ball3_G_25 = work[664];
    const real constraints_multipliers_822 = ball3_G_25 * constraints_D_inverse_13;
    work[541] = constraints_multipliers_822;
    const real ball3_G_26 = work[665];
    const real constraints_multipliers_823 = ball3_G_26 * constraints_D_inverse_14;
    work[542] = constraints_multipliers_823;
    const real ball3_G_27 = work[666];
    const real constraints_multipliers_824 = ball3_G_27 * constraints_D_inverse_15;
    work[543] = constraints_multipliers_824;
    const real constraints_multipliers_825 = constraints_D_inverse_2 * constraints_multipliers_820 -
        constraints_L_2_1 * constraints_multipliers_821;
    work[544] = constraints_multipliers_825;
    const real constraints_multipliers_826 = constraints_D_inverse_3 * constraints_multipliers_818 -
        constraints_L_3_1 * constraints_multipliers_821;
    const real constraints_multipliers_827 = constraints_multipliers_826
        + constraints_multipliers_544 * constraints_multipliers_825;
    work[545] = constraints_multipliers_827;
    const real constraints_multipliers_828 = constraints_D_inverse_4 * constraints_multipliers_815 -
        constraints_L_4_1 * constraints_multipliers_821;
    const real constraints_multipliers_829 = constraints_multipliers_828
        - constraints_L_4_2 * constraints_multipliers_825;
    const real constraints_multipliers_830 = constraints_multipliers_829
        - constraints_L_4_3 * constraints_multipliers_827;
    work[546] = constraints_multipliers_830;
    const real constraints_multipliers_831 = constraints_D_inverse_5 * constraints_multipliers_811 -
        constraints_L_5_1 * constraints_multipliers_821;
    const real constraints_multipliers_832 = constraints_multipliers_831
        - constraints_L_5_2 * constraints_multipliers_825;
    const real constraints_multipliers_833 = constraints_multipliers_832
        - constraints_L_5_3 * constraints_multipliers_827;
    const real constraints_multipliers_834 = constraints_multipliers_833
        + constraints_multipliers * constraints_multipliers_830;
    work[547] = constraints_multipliers_834;
    const real constraints_multipliers_835 = ball3_G_24 * constraints_D_inverse_6
        - constraints_L_6_1 * constraints_multipliers_821;
    const real constraints_multipliers_836 = constraints_multipliers_835
        - constraints_L_6_2 * constraints_multipliers_825;
    const real constraints_multipliers_837 = constraints_multipliers_836
        - constraints_L_6_3 * constraints_multipliers_827;
    const real constraints_multipliers_838 = constraints_multipliers_837
        - constraints_L_6_4 * constraints_multipliers_830
        - constraints_L_6_5 * constraints_multipliers_834;
    work[548] = constraints_multipliers_838;
    const real ball4_G_5 = work[713];
    const real ball4_G_6 = work[714];
    const real constraints_multipliers_839 = ball4_G_5 - ball4_G_6 * constraints_L_6_5;
    const real ball4_G = work[709];
    const real constraints_multipliers_840 = ball4_G - ball4_G_6 * constraints_L_6_1
        - constraints_L_5_1 * constraints_multipliers_839;
    const real ball4_G_2 = work[710];
    const real constraints_multipliers_841 = ball4_G_2 - ball4_G_6 * constraints_L_6_2
        - constraints_L_5_2 * constraints_multipliers_839;
    const real ball4_G_3 = work[711];
    const real constraints_multipliers_842 = ball4_G_3 - ball4_G_6 * constraints_L_6_3
        - constraints_L_5_3 * constraints_multipliers_839;
    const real ball4_G_4 = work[712];
    const real constraints_multipliers_843 = ball4_G_4 - ball4_G_6 * constraints_L_6_4
        + constraints_multipliers * constraints_multipliers_839;
    const real constraints_multipliers_844 = constraints_multipliers_840
        - constraints_L_4_1 * constraints_multipliers_843;
    const real constraints_multipliers_845 = constraints_multipliers_841
        - constraints_L_4_2 * constraints_multipliers_843;
    const real constraints_multipliers_846 = constraints_multipliers_842
        - constraints_L_4_3 * constraints_multipliers_843;
    const real constraints_multipliers_847 = constraints_multipliers_844
        - constraints_L_3_1 * constraints_multipliers_846;
    const real constraints_multipliers_848 = constraints_multipliers_845
        + constraints_multipliers_544 * constraints_multipliers_846;
    const real constraints_multipliers_849 = constraints_D_inverse_1 * (constraints_multipliers_847
        - constraints_L_2_1 * constraints_multipliers_848);
    work[549] = constraints_multipliers_849;
    const real ball4_G_7 = work[715];
    const real constraints_multipliers_850 = ball4_G_7 * constraints_D_inverse_16;
    work[550] = constraints_multipliers_850;
    const real ball4_G_8 = work[716];
    const real constraints_multipliers_851 = ball4_G_8 * constraints_D_inverse_17;
    work[551] = constraints_multipliers_851;
    const real ball4_G_9 = work[717];
    const real constraints_multipliers_852 = ball4_G_9 * constraints_D_inverse_18;
    work[552] = constraints_multipliers_852;
    const real constraints_multipliers_853 = constraints_D_inverse_2 * constraints_multipliers_848 -
        constraints_L_2_1 * constraints_multipliers_849;
    work[553] = constraints_multipliers_853;
    const real constraints_multipliers_854 = constraints_D_inverse_3 * constraints_multipliers_846 -
        constraints_L_3_1 * constraints_multipliers_849;
    const real constraints_multipliers_855 = constraints_multipliers_854
        + constraints_multipliers_544 * constraints_multipliers_853;
    work[554] = constraints_multipliers_855;
    const real constraints_multipliers_856 = constraints_D_inverse_4 * constraints_multipliers_843 -
        constraints_L_4_1 * constraints_multipliers_849;
    const real constraints_multipliers_857 = constraints_multipliers_856
        - constraints_L_4_2 * constraints_multipliers_853;
    const real constraints_multipliers_858 = constraints_multipliers_857
        - constraints_L_4_3 * constraints_multipliers_855;
    work[555] = constraints_multipliers_858;
    const real constraints_multipliers_859 = constraints_D_inverse_5 * constraints_multipliers_839 -
        constraints_L_5_1 * constraints_multipliers_849;
    const real constraints_multipliers_860 = constraints_multipliers_859
        - constraints_L_5_2 * constraints_multipliers_853;
    const real constraints_multipliers_861 = constraints_multipliers_860
        - constraints_L_5_3 * constraints_multipliers_855;
    const real constraints_multipliers_862 = constraints_multipliers_861
        + constraints_multipliers * constraints_multipliers_858;
    work[556] = constraints_multipliers_862;
    const real constraints_multipliers_863 = ball4_G_6 * constraints_D_inverse_6
        - constraints_L_6_1 * constraints_multipliers_849;
    const real constraints_multipliers_864 = constraints_multipliers_863
        - constraints_L_6_2 * constraints_multipliers_853;
    const real constraints_multipliers_865 = constraints_multipliers_864
        - constraints_L_6_3 * constraints_multipliers_855;
    const real constraints_multipliers_866 = constraints_multipliers_865
        - constraints_L_6_4 * constraints_multipliers_858
        - constraints_L_6_5 * constraints_multipliers_862;
    work[557] = constraints_multipliers_866;
    const real ball4_G_14 = work[722];
    const real ball4_G_15 = work[723];
    const real constraints_multipliers_867 = ball4_G_14 - ball4_G_15 * constraints_L_6_5;
    const real ball4_G_10 = work[718];
    const real constraints_multipliers_868 = ball4_G_10 - ball4_G_15 * constraints_L_6_1
        - constraints_L_5_1 * constraints_multipliers_867;
    const real ball4_G_11 = work[719];
    const real constraints_multipliers_869 = ball4_G_11 - ball4_G_15 * constraints_L_6_2
        - constraints_L_5_2 * constraints_multipliers_867;
    const real ball4_G_12 = work[720];
    const real constraints_multipliers_870 = ball4_G_12 - ball4_G_15 * constraints_L_6_3
        - constraints_L_5_3 * constraints_multipliers_867;
    const real ball4_G_13 = work[721];
    const real constraints_multipliers_871 = ball4_G_13 - ball4_G_15 * constraints_L_6_4
        + constraints_multipliers * constraints_multipliers_867;
    const real constraints_multipliers_872 = constraints_multipliers_868
        - constraints_L_4_1 * constraints_multipliers_871;
    const real constraints_multipliers_873 = constraints_multipliers_869
        - constraints_L_4_2 * constraints_multipliers_871;
    const real constraints_multipliers_874 = constraints_multipliers_870
        - constraints_L_4_3 * constraints_multipliers_871;
    const real constraints_multipliers_875 = constraints_multipliers_872
        - constraints_L_3_1 * constraints_multipliers_874;
    const real constraints_multipliers_876 = constraints_multipliers_873
        + constraints_multipliers_544 * constraints_multipliers_874;
    const real constraints_multipliers_877 = constraints_D_inverse_1 * (constraints_multipliers_875
        - constraints_L_2_1 * constraints_multipliers_876);
    work[558] = constraints_multipliers_877;
    const real ball4_G_16 = work[724];
    const real constraints_multipliers_878 = ball4_G_16 * constraints_D_inverse_16;
    work[559] = constraints_multipliers_878;
    const real ball4_G_17 = work[725];
    const real constraints_multipliers_879 = ball4_G_17 * constraints_D_inverse_17;
    work[560] = constraints_multipliers_879;
    const real ball4_G_18 = work[726];
    const real constraints_multipliers_880 = ball4_G_18 * constraints_D_inverse_18;
    work[561] = constraints_multipliers_880;
    const real constraints_multipliers_881 = constraints_D_inverse_2 * constraints_multipliers_876 -
        constraints_L_2_1 * constraints_multipliers_877;
    work[562] = constraints_multipliers_881;
    const real constraints_multipliers_882 = constraints_D_inverse_3 * constraints_multipliers_874 -
        constraints_L_3_1 * constraints_multipliers_877;
    const real constraints_multipliers_883 = constraints_multipliers_882
        + constraints_multipliers_544 * constraints_multipliers_881;
    work[563] = constraints_multipliers_883;
    const real constraints_multipliers_884 = constraints_D_inverse_4 * constraints_multipliers_871 -
        constraints_L_4_1 * constraints_multipliers_877;
    const real constraints_multipliers_885 = constraints_multipliers_884
        - constraints_L_4_2 * constraints_multipliers_881;
    const real constraints_multipliers_886 = constraints_multipliers_885
        - constraints_L_4_3 * constraints_multipliers_883;
    work[564] = constraints_multipliers_886;
    const real constraints_multipliers_887 = constraints_D_inverse_5 * constraints_multipliers_867 -
        constraints_L_5_1 * constraints_multipliers_877;
    const real constraints_multipliers_888 = constraints_multipliers_887
        - constraints_L_5_2 * constraints_multipliers_881;
    const real constraints_multipliers_889 = constraints_multipliers_888
        - constraints_L_5_3 * constraints_multipliers_883;
    const real constraints_multipliers_890 = constraints_multipliers_889
        + constraints_multipliers * constraints_multipliers_886;
    work[565] = constraints_multipliers_890;
    const real constraints_multipliers_891 = ball4_G_15 * constraints_D_inverse_6
        - constraints_L_6_1 * constraints_multipliers_877;
    const real constraints_multipliers_892 = constraints_multipliers_891
        - constraints_L_6_2 * constraints_multipliers_881;
    const real constraints_multipliers_893 = constraints_multipliers_892
        - constraints_L_6_3 * constraints_multipliers_883;
    const real constraints_multipliers_894 = constraints_multipliers_893
        - constraints_L_6_4 * constraints_multipliers_886
        - constraints_L_6_5 * constraints_multipliers_890;
    work[566] = constraints_multipliers_894;
    const real ball4_G_23 = work[731];
    const real ball4_G_24 = work[732];
    const real constraints_multipliers_895 = ball4_G_23 - ball4_G_24 * constraints_L_6_5;
    const real ball4_G_19 = work[727];
    const real constraints_multipliers_896 = ball4_G_19 - ball4_G_24 * constraints_L_6_1
        - constraints_L_5_1 * constraints_multipliers_895;
    const real ball4_G_20 = work[728];
    const real constraints_multipliers_897 = ball4_G_20 - ball4_G_24 * constraints_L_6_2
        - constraints_L_5_2 * constraints_multipliers_895;
    const real ball4_G_21 = work[729];
    const real constraints_multipliers_898 = ball4_G_21 - ball4_G_24 * constraints_L_6_3
        - constraints_L_5_3 * constraints_multipliers_895;
    const real ball4_G_22 = work[730];
    const real constraints_multipliers_899 = ball4_G_22 - ball4_G_24 * constraints_L_6_4
        + constraints_multipliers * constraints_multipliers_895;
    const real constraints_multipliers_900 = constraints_multipliers_896
        - constraints_L_4_1 * constraints_multipliers_899;
    const real constraints_multipliers_901 = constraints_multipliers_897
        - constraints_L_4_2 * constraints_multipliers_899;
    const real constraints_multipliers_902 = constraints_multipliers_898
        - constraints_L_4_3 * constraints_multipliers_899;
    const real constraints_multipliers_903 = constraints_multipliers_900
        - constraints_L_3_1 * constraints_multipliers_902;
    const real constraints_multipliers_904 = constraints_multipliers_901
        + constraints_multipliers_544 * constraints_multipliers_902;
    const real constraints_multipliers_905 = constraints_D_inverse_1 * (constraints_multipliers_903
        - constraints_L_2_1 * constraints_multipliers_904);
    work[567] = constraints_multipliers_905;
    const real ball4_G_25 = work[733];
    const real constraints_multipliers_906 = ball4_G_25 * constraints_D_inverse_16;
    work[568] = constraints_multipliers_906;
    const real ball4_G_26 = work[734];
    const real constraints_multipliers_907 = ball4_G_26 * constraints_D_inverse_17;
    work[569] = constraints_multipliers_907;
    const real ball4_G_27 = work[735];
    const real constraints_multipliers_908 = ball4_G_27 * constraints_D_inverse_18;
    work[570] = constraints_multipliers_908;
    const real constraints_multipliers_909 = constraints_D_inverse_2 * constraints_multipliers_904 -
        constraints_L_2_1 * constraints_multipliers_905;
    work[571] = constraints_multipliers_909;
    const real constraints_multipliers_910 = constraints_D_inverse_3 * constraints_multipliers_902 -
        constraints_L_3_1 * constraints_multipliers_905;
    const real constraints_multipliers_911 = constraints_multipliers_910
        + constraints_multipliers_544 * constraints_multipliers_909;
    work[599] = constraints_multipliers_911;
    const real constraints_multipliers_912 = constraints_D_inverse_4 * constraints_multipliers_899 -
        constraints_L_4_1 * constraints_multipliers_905;
    const real constraints_multipliers_913 = constraints_multipliers_912
        - constraints_L_4_2 * constraints_multipliers_909;
    const real constraints_multipliers_914 = constraints_multipliers_913
        - constraints_L_4_3 * constraints_multipliers_911;
    work[600] = constraints_multipliers_914;
    const real constraints_multipliers_915 = constraints_D_inverse_5 * constraints_multipliers_895 -
        constraints_L_5_1 * constraints_multipliers_905;
    const real constraints_multipliers_916 = constraints_multipliers_915
        - constraints_L_5_2 * constraints_multipliers_909;
    const real constraints_multipliers_917 = constraints_multipliers_916
        - constraints_L_5_3 * constraints_multipliers_911;
    const real constraints_multipliers_918 = constraints_multipliers_917
        + constraints_multipliers * constraints_multipliers_914;
    work[601] = constraints_multipliers_918;
    const real constraints_multipliers_919 = ball4_G_24 * constraints_D_inverse_6
        - constraints_L_6_1 * constraints_multipliers_905;
    const real constraints_multipliers_920 = constraints_multipliers_919
        - constraints_L_6_2 * constraints_multipliers_909;
    const real constraints_multipliers_921 = constraints_multipliers_920
        - constraints_L_6_3 * constraints_multipliers_911;
    const real constraints_multipliers_922 = constraints_multipliers_921
        - constraints_L_6_4 * constraints_multipliers_914
        - constraints_L_6_5 * constraints_multipliers_918;
    work[602] = constraints_multipliers_922;
    const real ball5_G_5 = work[773];
    const real ball5_G_6 = work[774];
    const real constraints_multipliers_923 = ball5_G_5 - ball5_G_6 * constraints_L_6_5;
    const real ball5_G = work[769];
    const real constraints_multipliers_924 = ball5_G - ball5_G_6 * constraints_L_6_1
        - constraints_L_5_1 * constraints_multipliers_923;
    const real ball5_G_2 = work[770];
    const real constraints_multipliers_925 = ball5_G_2 - ball5_G_6 * constraints_L_6_2
        - constraints_L_5_2 * constraints_multipliers_923;
    const real ball5_G_3 = work[771];
    const real constraints_multipliers_926 = ball5_G_3 - ball5_G_6 * constraints_L_6_3
        - constraints_L_5_3 * constraints_multipliers_923;
    const real ball5_G_4 = work[772];
    const real constraints_multipliers_927 = ball5_G_4 - ball5_G_6 * constraints_L_6_4
        + constraints_multipliers * constraints_multipliers_923;
    const real constraints_multipliers_928 = constraints_multipliers_924
        - constraints_L_4_1 * constraints_multipliers_927;
    const real constraints_multipliers_929 = constraints_multipliers_925
        - constraints_L_4_2 * constraints_multipliers_927;
    const real constraints_multipliers_930 = constraints_multipliers_926
        - constraints_L_4_3 * constraints_multipliers_927;
    const real constraints_multipliers_931 = constraints_multipliers_928
        - constraints_L_3_1 * constraints_multipliers_930;
    const real constraints_multipliers_932 = constraints_multipliers_929
        + constraints_multipliers_544 * constraints_multipliers_930;
    const real constraints_multipliers_933 = constraints_D_inverse_1 * (constraints_multipliers_931
        - constraints_L_2_1 * constraints_multipliers_932);
    work[604] = constraints_multipliers_933;
    const real ball5_G_7 = work[775];
    const real constraints_multipliers_934 = ball5_G_7 * constraints_D_inverse_19;
    work[605] = constraints_multipliers_934;
    const real ball5_G_8 = work[776];
    const real constraints_multipliers_935 = ball5_G_8 * constraints_D_inverse_20;
    work[606] = constraints_multipliers_935;
    const real ball5_G_9 = work[777];
    const real constraints_multipliers_936 = ball5_G_9 * constraints_D_inverse_21;
    work[607] = constraints_multipliers_936;
    const real constraints_multipliers_937 = constraints_D_inverse_2 * constraints_multipliers_932 -
        constraints_L_2_1 * constraints_multipliers_933;
    work[608] = constraints_multipliers_937;
    const real constraints_multipliers_938 = constraints_D_inverse_3 * constraints_multipliers_930 -
        constraints_L_3_1 * constraints_multipliers_933;
    const real constraints_multipliers_939 = constraints_multipliers_938
        + constraints_multipliers_544 * constraints_multipliers_937;
    work[609] = constraints_multipliers_939;
    const real constraints_multipliers_940 = constraints_D_inverse_4 * constraints_multipliers_927 -
        constraints_L_4_1 * constraints_multipliers_933;
    const real constraints_multipliers_941 = constraints_multipliers_940
        - constraints_L_4_2 * constraints_multipliers_937;
    const real constraints_multipliers_942 = constraints_multipliers_941
        - constraints_L_4_3 * constraints_multipliers_939;
    work[610] = constraints_multipliers_942;
    const real constraints_multipliers_943 = constraints_D_inverse_5 * constraints_multipliers_923 -
        constraints_L_5_1 * constraints_multipliers_933;
    const real constraints_multipliers_944 = constraints_multipliers_943
        - constraints_L_5_2 * constraints_multipliers_937;
    const real constraints_multipliers_945 = constraints_multipliers_944
        - constraints_L_5_3 * constraints_multipliers_939;
    const real constraints_multipliers_946 = constraints_multipliers_945
        + constraints_multipliers * constraints_multipliers_942;
    work[611] = constraints_multipliers_946;
    const real constraints_multipliers_947 = ball5_G_6 * constraints_D_inverse_6
        - constraints_L_6_1 * constraints_multipliers_933;
    const real constraints_multipliers_948 = constraints_multipliers_947
        - constraints_L_6_2 * constraints_multipliers_937;
    const real constraints_multipliers_949 = constraints_multipliers_948
        - constraints_L_6_3 * constraints_multipliers_939;
    const real constraints_multipliers_950 = constraints_multipliers_949
        - constraints_L_6_4 * constraints_multipliers_942
        - constraints_L_6_5 * constraints_multipliers_946;
    work[612] = constraints_multipliers_950;
    const real ball5_G_14 = work[782];
    const real ball5_G_15 = work[783];
    const real constraints_multipliers_951 = ball5_G_14 - ball5_G_15 * constraints_L_6_5;
    const real ball5_G_10 = work[778];
    const real constraints_multipliers_952 = ball5_G_10 - ball5_G_15 * constraints_L_6_1
        - constraints_L_5_1 * constraints_multipliers_951;
    const real ball5_G_11 = work[779];
    const real constraints_multipliers_953 = ball5_G_11 - ball5_G_15 * constraints_L_6_2
        - constraints_L_5_2 * constraints_multipliers_951;
    const real ball5_G_12 = work[780];
    const real constraints_multipliers_954 = ball5_G_12 - ball5_G_15 * constraints_L_6_3
        - constraints_L_5_3 * constraints_multipliers_951;
    const real ball5_G_13 = work[781];
    const real constraints_multipliers_955 = ball5_G_13 - ball5_G_15 * constraints_L_6_4
        + constraints_multipliers * constraints_multipliers_951;
    const real constraints_multipliers_956 = constraints_multipliers_952
        - constraints_L_4_1 * constraints_multipliers_955;
    const real constraints_multipliers_957 = constraints_multipliers_953
        - constraints_L_4_2 * constraints_multipliers_955;
    const real constraints_multipliers_958 = constraints_multipliers_954
        - constraints_L_4_3 * constraints_multipliers_955;
    const real constraints_multipliers_959 = constraints_multipliers_956
        - constraints_L_3_1 * constraints_multipliers_958;
    const real constraints_multipliers_960 = constraints_multipliers_957
        + constraints_multipliers_544 * constraints_multipliers_958;
    const real constraints_multipliers_961 = constraints_D_inverse_1 * (constraints_multipliers_959
        - constraints_L_2_1 * constraints_multipliers_960);
    work[613] = constraints_multipliers_961;
    const real ball5_G_16 = work[784];
    const real constraints_multipliers_962 = ball5_G_16 * constraints_D_inverse_19;
    work[614] = constraints_multipliers_962;
    const real ball5_G_17 = work[785];
    const real constraints_multipliers_963 = ball5_G_17 * constraints_D_inverse_20;
    work[615] = constraints_multipliers_963;
    const real ball5_G_18 = work[786];
    const real constraints_multipliers_964 = ball5_G_18 * constraints_D_inverse_21;
    work[616] = constraints_multipliers_964;
    const real constraints_multipliers_965 = constraints_D_inverse_2 * constraints_multipliers_960 -
        constraints_L_2_1 * constraints_multipliers_961;
    work[617] = constraints_multipliers_965;
    const real constraints_multipliers_966 = constraints_D_inverse_3 * constraints_multipliers_958 -
        constraints_L_3_1 * constraints_multipliers_961;
    const real constraints_multipliers_967 = constraints_multipliers_966
        + constraints_multipliers_544 * constraints_multipliers_965;
    work[618] = constraints_multipliers_967;
    const real constraints_multipliers_968 = constraints_D_inverse_4 * constraints_multipliers_955 -
        constraints_L_4_1 * constraints_multipliers_961;
    const real constraints_multipliers_969 = constraints_multipliers_968
        - constraints_L_4_2 * constraints_multipliers_965;
    const real constraints_multipliers_970 = constraints_multipliers_969
        - constraints_L_4_3 * constraints_multipliers_967;
    work[619] = constraints_multipliers_970;
    const real constraints_multipliers_971 = constraints_D_inverse_5 * constraints_multipliers_951 -
        constraints_L_5_1 * constraints_multipliers_961;
    const real constraints_multipliers_972 = constraints_multipliers_971
        - constraints_L_5_2 * constraints_multipliers_965;
    const real constraints_multipliers_973 = constraints_multipliers_972
        - constraints_L_5_3 * constraints_multipliers_967;
    const real constraints_multipliers_974 = constraints_multipliers_973
        + constraints_multipliers * constraints_multipliers_970;
    work[620] = constraints_multipliers_974;
    const real constraints_multipliers_975 = ball5_G_15 * constraints_D_inverse_6
        - constraints_L_6_1 * constraints_multipliers_961;
    const real constraints_multipliers_976 = constraints_multipliers_975
        - constraints_L_6_2 * constraints_multipliers_965;
    const real constraints_multipliers_977 = constraints_multipliers_976
        - constraints_L_6_3 * constraints_multipliers_967;
    const real constraints_multipliers_978 = constraints_multipliers_977
        - constraints_L_6_4 * constraints_multipliers_970
        - constraints_L_6_5 * constraints_multipliers_974;
    work[621] = constraints_multipliers_978;
    const real ball5_G_23 = work[791];
    const real ball5_G_24 = work[792];
    const real constraints_multipliers_979 = ball5_G_23 - ball5_G_24 * constraints_L_6_5;
    const real ball5_G_19 = work[787];
    const real constraints_multipliers_980 = ball5_G_19 - ball5_G_24 * constraints_L_6_1
        - constraints_L_5_1 * constraints_multipliers_979;
    const real ball5_G_20 = work[788];
    const real constraints_multipliers_981 = ball5_G_20 - ball5_G_24 * constraints_L_6_2
        - constraints_L_5_2 * constraints_multipliers_979;
    const real ball5_G_21 = work[789];
    const real constraints_multipliers_982 = ball5_G_21 - ball5_G_24 * constraints_L_6_3
        - constraints_L_5_3 * constraints_multipliers_979;
    const real ball5_G_22 = work[790];
    const real constraints_multipliers_983 = ball5_G_22 - ball5_G_24 * constraints_L_6_4
        + constraints_multipliers * constraints_multipliers_979;
    const real constraints_multipliers_984 = constraints_multipliers_980
        - constraints_L_4_1 * constraints_multipliers_983;
    const real constraints_multipliers_985 = constraints_multipliers_981
        - constraints_L_4_2 * constraints_multipliers_983;
    const real constraints_multipliers_986 = constraints_multipliers_982
        - constraints_L_4_3 * constraints_multipliers_983;
    const real constraints_multipliers_987 = constraints_multipliers_984
        - constraints_L_3_1 * constraints_multipliers_986;
    const real constraints_multipliers_988 = constraints_multipliers_985
        + constraints_multipliers_544 * constraints_multipliers_986;
    const real constraints_multipliers_989 = constraints_D_inverse_1 * (constraints_multipliers_987
        - constraints_L_2_1 * constraints_multipliers_988);
    work[622] = constraints_multipliers_989;
    const real ball5_G_25 = work[793];
    const real constraints_multipliers_990 = ball5_G_25 * constraints_D_inverse_19;
    work[623] = constraints_multipliers_990;
    const real ball5_G_26 = work[794];
    const real constraints_multipliers_991 = ball5_G_26 * constraints_D_inverse_20;
    work[624] = constraints_multipliers_991;
    const real ball5_G_27 = work[795];
    const real constraints_multipliers_992 = ball5_G_27 * constraints_D_inverse_21;
    work[625] = constraints_multipliers_992;
    const real constraints_multipliers_993 = constraints_D_inverse_2 * constraints_multipliers_988 -
        constraints_L_2_1 * constraints_multipliers_989;
    work[626] = constraints_multipliers_993;
    const real constraints_multipliers_994 = constraints_D_inverse_3 * constraints_multipliers_986 -
        constraints_L_3_1 * constraints_multipliers_989;
    const real constraints_multipliers_995 = constraints_multipliers_994
        + constraints_multipliers_544 * constraints_multipliers_993;
    work[627] = constraints_multipliers_995;
    const real constraints_multipliers_996 = constraints_D_inverse_4 * constraints_multipliers_983 -
        constraints_L_4_1 * constraints_multipliers_989;
    const real constraints_multipliers_997 = constraints_multipliers_996
        - constraints_L_4_2 * constraints_multipliers_993;
    const real constraints_multipliers_998 = constraints_multipliers_997
        - constraints_L_4_3 * constraints_multipliers_995;
    work[628] = constraints_multipliers_998;
    const real constraints_multipliers_999 = constraints_D_inverse_5 * constraints_multipliers_979 -
        constraints_L_5_1 * constraints_multipliers_989;
    const real constraints_multipliers_1000 = constraints_multipliers_999
        - constraints_L_5_2 * constraints_multipliers_993;
    const real constraints_multipliers_1001 = constraints_multipliers_1000
        - constraints_L_5_3 * constraints_multipliers_995;
    const real constraints_multipliers_1002 = constraints_multipliers_1001
        + constraints_multipliers * constraints_multipliers_998;
    work[629] = constraints_multipliers_1002;
    const real constraints_multipliers_1003 = ball5_G_24 * constraints_D_inverse_6
        - constraints_L_6_1 * constraints_multipliers_989;
    const real constraints_multipliers_1004 = constraints_multipliers_1003
        - constraints_L_6_2 * constraints_multipliers_993;
    const real constraints_multipliers_1005 = constraints_multipliers_1004
        - constraints_L_6_3 * constraints_multipliers_995;
    work[630] = constraints_multipliers_1005;
    return CARDAN_OK;
}

CARDAN_PART int forward_dynamics_part5(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const wreal *const w = in->w;
    (void)out;
    int status = CARDAN_OK;

    /* constraints: multipliers */
    const wreal constraints_L_6_5 = w[102];
    const wreal constraints_L_6_4 = w[103];
    const real constraints_multipliers_1005 = work[630];
    const real constraints_multipliers_998 = work[628];
    const real constraints_multipliers_1002 = work[629];
    const real constraints_multipliers_1006 = constraints_multipliers_1005
        - constraints_L_6_4 * constraints_multipliers_998
        - constraints_L_6_5 * constraints_multipliers_1002;
    work[418] = constraints_multipliers_1006;
    const real ball1_G = work[491];
    const real constraints_multipliers_597 = work[414];
    const real ball1_G_2 = work[492];
    const real constraints_multipliers_601 = work[419];
    const real ball1_G_3 = work[493];
    const real constraints_multipliers_603 = work[420];
    const real constraints_multipliers_1007 = ball1_G * constraints_multipliers_597
        + ball1_G_2 * constraints_multipliers_601 + ball1_G_3 * constraints_multipliers_603;
    const real ball1_G_4 = work[494];
    const real constraints_multipliers_606 = work[421];
    const real ball1_G_5 = work[495];
    const real constraints_multipliers_610 = work[422];
    const real constraints_multipliers_1008 = constraints_multipliers_1007
        + ball1_G_4 * constraints_multipliers_606 + ball1_G_5 * constraints_multipliers_610;
    const real ball1_G_6 = work[496];
    const real constraints_multipliers_614 = work[423];
    const real ball1_G_7 = work[497];
    const real constraints_multipliers_598 = work[415];
    const real constraints_multipliers_1009 = constraints_multipliers_1008
        + ball1_G_6 * constraints_multipliers_614 + ball1_G_7 * constraints_multipliers_598;
    const real ball1_G_8 = work[498];
    const real constraints_multipliers_599 = work[416];
    const real ball1_G_9 = work[499];
    const real constraints_multipliers_600 = work[417];
    const real constraints_multipliers_1010 = constraints_multipliers_1009
        + ball1_G_8 * constraints_multipliers_599 + ball1_G_9 * constraints_multipliers_600;
    work[0] = constraints_multipliers_1010;
    const real ball1_G_10 = work[500];
    const real ball1_G_11 = work[501];
    const real ball1_G_12 = work[502];
    const real constraints_multipliers_1011 = ball1_G_10 * constraints_multipliers_597
        + ball1_G_11 * constraints_multipliers_601 + ball1_G_12 * constraints_multipliers_603;
    const real ball1_G_13 = work[503];
    const real ball1_G_14 = work[504];
    const real constraints_multipliers_1012 = constraints_multipliers_1011
        + ball1_G_13 * constraints_multipliers_606 + ball1_G_14 * constraints_multipliers_610;
    const real ball1_G_15 = work[505];
    const real ball1_G_16 = work[506];
    const real constraints_multipliers_1013 = constraints_multipliers_1012
        + ball1_G_15 * constraints_multipliers_614 + ball1_G_16 * constraints_multipliers_598;
    const real ball1_G_17 = work[507];
    const real ball1_G_18 = work[508];
    const real constraints_multipliers_1014 = constraints_multipliers_1013
        + ball1_G_17 * constraints_multipliers_599 + ball1_G_18 * constraints_multipliers_600;
    work[1] = constraints_multipliers_1014;
    work[15] = constraints_multipliers_1014;
    const real constraints_multipliers_625 = work[424];
    const real constraints_multipliers_629 = work[428];
    const real constraints_multipliers_631 = work[431];
    const real constraints_multipliers_1015 = ball1_G_10 * constraints_multipliers_625
        + ball1_G_11 * constraints_multipliers_629 + ball1_G_12 * constraints_multipliers_631;
    const real constraints_multipliers_634 = work[432];
    const real constraints_multipliers_638 = work[433];
    const real constraints_multipliers_1016 = constraints_multipliers_1015
        + ball1_G_13 * constraints_multipliers_634 + ball1_G_14 * constraints_multipliers_638;
    const real constraints_multipliers_642 = work[434];
    const real constraints_multipliers_626 = work[425];
    const real constraints_multipliers_1017 = constraints_multipliers_1016
        + ball1_G_15 * constraints_multipliers_642 + ball1_G_16 * constraints_multipliers_626;
    const real constraints_multipliers_627 = work[426];
    const real constraints_multipliers_628 = work[427];
    const real constraints_multipliers_1018 = constraints_multipliers_1017
        + ball1_G_17 * constraints_multipliers_627 + ball1_G_18 * constraints_multipliers_628;
    work[16] = constraints_multipliers_1018;
    const real ball1_G_19 = work[509];
    const real ball1_G_20 = work[510];
    const real ball1_G_21 = work[511];
    const real constraints_multipliers_1019 = ball1_G_19 * constraints_multipliers_597
        + ball1_G_20 * constraints_multipliers_601 + ball1_G_21 * constraints_multipliers_603;
    const real ball1_G_22 = work[512];
    const real ball1_G_23 = work[513];
    const real constraints_multipliers_1020 = constraints_multipliers_1019
        + ball1_G_22 * constraints_multipliers_606 + ball1_G_23 * constraints_multipliers_610;
    const real ball1_G_24 = work[514];
    const real ball1_G_25 = work[515];
    const real constraints_multipliers_1021 = constraints_multipliers_1020
        + ball1_G_24 * constraints_multipliers_614 + ball1_G_25 * constraints_multipliers_598;
    const real ball1_G_26 = work[516];
    const real ball1_G_27 = work[517];
    const real constraints_multipliers_1022 = constraints_multipliers_1021
        + ball1_G_26 * constraints_multipliers_599 + ball1_G_27 * constraints_multipliers_600;
    work[2] = constraints_multipliers_1022;
    work[30] = constraints_multipliers_1022;
    const real constraints_multipliers_1023 = ball1_G_19 * constraints_multipliers_625
        + ball1_G_20 * constraints_multipliers_629 + ball1_G_21 * constraints_multipliers_631;
    const real constraints_multipliers_1024 = constraints_multipliers_1023
        + ball1_G_22 * constraints_multipliers_634 + ball1_G_23 * constraints_multipliers_638;
    const real constraints_multipliers_1025 = constraints_multipliers_1024
        + ball1_G_24 * constraints_multipliers_642 + ball1_G_25 * constraints_multipliers_626;
    const real constraints_multipliers_1026 = constraints_multipliers_1025
        + ball1_G_26 * constraints_multipliers_627 + ball1_G_27 * constraints_multipliers_628;
    work[17] = constraints_multipliers_1026;
    work[31] = constraints_multipliers_1026;
    const real constraints_multipliers_653 = work[435];
    const real constraints_multipliers_657 = work[439];
    const real constraints_multipliers_659 = work[440];
    const real constraints_multipliers_1027 = ball1_G_19 * constraints_multipliers_653
        + ball1_G_20 * constraints_multipliers_657 + ball1_G_21 * constraints_multipliers_659;
    const real constraints_multipliers_662 = work[441];
    const real constraints_multipliers_666 = work[442];
    const real constraints_multipliers_1028 = constraints_multipliers_1027
        + ball1_G_22 * constraints_multipliers_662 + ball1_G_23 * constraints_multipliers_666;
    const real constraints_multipliers_670 = work[443];
    const real constraints_multipliers_654 = work[436];
    const real constraints_multipliers_1029 = constraints_multipliers_1028
        + ball1_G_24 * constraints_multipliers_670 + ball1_G_25 * constraints_multipliers_654;
    const real constraints_multipliers_655 = work[437];
    const real constraints_multipliers_656 = work[438];
    const real constraints_multipliers_1030 = constraints_multipliers_1029
        + ball1_G_26 * constraints_multipliers_655 + ball1_G_27 * constraints_multipliers_656;
    work[32] = constraints_multipliers_1030;
    const real ball2_G = work[572];
    const real ball2_G_2 = work[573];
    const real ball2_G_3 = work[574];
    const real constraints_multipliers_1031 = ball2_G * constraints_multipliers_597
        + ball2_G_2 * constraints_multipliers_601 + ball2_G_3 * constraints_multipliers_603;
    const real ball2_G_4 = work[575];
    const real ball2_G_5 = work[576];
    const real constraints_multipliers_1032 = constraints_multipliers_1031
        + ball2_G_4 * constraints_multipliers_606 + ball2_G_5 * constraints_multipliers_610;
    const real ball2_G_6 = work[577];
    const real constraints_multipliers_1033 = constraints_multipliers_1032
        + ball2_G_6 * constraints_multipliers_614;
    work[3] = constraints_multipliers_1033;
    work[45] = constraints_multipliers_1033;
    const real constraints_multipliers_1034 = ball2_G * constraints_multipliers_625
        + ball2_G_2 * constraints_multipliers_629 + ball2_G_3 * constraints_multipliers_631;
    const real constraints_multipliers_1035 = constraints_multipliers_1034
        + ball2_G_4 * constraints_multipliers_634 + ball2_G_5 * constraints_multipliers_638;
    const real constraints_multipliers_1036 = constraints_multipliers_1035
        + ball2_G_6 * constraints_multipliers_642;
    work[18] = constraints_multipliers_1036;
    work[46] = constraints_multipliers_1036;
    const real constraints_multipliers_1037 = ball2_G * constraints_multipliers_653
        + ball2_G_2 * constraints_multipliers_657 + ball2_G_3 * constraints_multipliers_659;
    const real constraints_multipliers_1038 = constraints_multipliers_1037
        + ball2_G_4 * constraints_multipliers_662 + ball2_G_5 * constraints_multipliers_666;
    const real constraints_multipliers_1039 = constraints_multipliers_1038
        + ball2_G_6 * constraints_multipliers_670;
    work[33] = constraints_multipliers_1039;
    work[47] = constraints_multipliers_1039;
    const real constraints_multipliers_681 = work[450];
    const real constraints_multipliers_685 = work[454];
    const real constraints_multipliers_687 = work[455];
    const real constraints_multipliers_1040 = ball2_G * constraints_multipliers_681
        + ball2_G_2 * constraints_multipliers_685 + ball2_G_3 * constraints_multipliers_687;
    const real constraints_multipliers_690 = work[468];
    const real constraints_multipliers_694 = work[469];
    const real constraints_multipliers_1041 = constraints_multipliers_1040
        + ball2_G_4 * constraints_multipliers_690 + ball2_G_5 * constraints_multipliers_694;
    const real constraints_multipliers_698 = work[470];
    const real ball2_G_7 = work[578];
    const real constraints_multipliers_682 = work[451];
    const real constraints_multipliers_1042 = constraints_multipliers_1041
        + ball2_G_6 * constraints_multipliers_698 + ball2_G_7 * constraints_multipliers_682;
    const real ball2_G_8 = work[579];
    const real constraints_multipliers_683 = work[452];
    const real ball2_G_9 = work[580];
    const real constraints_multipliers_684 = work[453];
    const real constraints_multipliers_1043 = constraints_multipliers_1042
        + ball2_G_8 * constraints_multipliers_683 + ball2_G_9 * constraints_multipliers_684;
    work[48] = constraints_multipliers_1043;
    const real ball2_G_10 = work[581];
    const real ball2_G_11 = work[582];
    const real ball2_G_12 = work[583];
    const real constraints_multipliers_1044 = ball2_G_10 * constraints_multipliers_597
        + ball2_G_11 * constraints_multipliers_601 + ball2_G_12 * constraints_multipliers_603;
    const real ball2_G_13 = work[584];
    const real ball2_G_14 = work[585];
    const real constraints_multipliers_1045 = constraints_multipliers_1044
        + ball2_G_13 * constraints_multipliers_606 + ball2_G_14 * constraints_multipliers_610;
    const real ball2_G_15 = work[586];
    const real constraints_multipliers_1046 = constraints_multipliers_1045
        + ball2_G_15 * constraints_multipliers_614;
    work[4] = constraints_multipliers_1046;
    work[60] = constraints_multipliers_1046;
    const real constraints_multipliers_1047 = ball2_G_10 * constraints_multipliers_625
        + ball2_G_11 * constraints_multipliers_629 + ball2_G_12 * constraints_multipliers_631;
    const real constraints_multipliers_1048 = constraints_multipliers_1047
        + ball2_G_13 * constraints_multipliers_634 + ball2_G_14 * constraints_multipliers_638;
    const real constraints_multipliers_1049 = constraints_multipliers_1048
        + ball2_G_15 * constraints_multipliers_642;
    work[19] = constraints_multipliers_1049;
    work[61] = constraints_multipliers_1049;
    const real constraints_multipliers_1050 = ball2_G_10 * constraints_multipliers_653
        + ball2_G_11 * constraints_multipliers_657 + ball2_G_12 * constraints_multipliers_659;
    const real constraints_multipliers_1051 = constraints_multipliers_1050
        + ball2_G_13 * constraints_multipliers_662 + ball2_G_14 * constraints_multipliers_666;
    const real constraints_multipliers_1052 = constraints_multipliers_1051
        + ball2_G_15 * constraints_multipliers_670;
    work[34] = constraints_multipliers_1052;
    work[62] = constraints_multipliers_1052;
    const real constraints_multipliers_1053 = ball2_G_10 * constraints_multipliers_681
        + ball2_G_11 * constraints_multipliers_685 + ball2_G_12 * constraints_multipliers_687;
    const real constraints_multipliers_1054 = constraints_multipliers_1053
        + ball2_G_13 * constraints_multipliers_690 + ball2_G_14 * constraints_multipliers_694;
    const real ball2_G_16 = work[587];
    const real constraints_multipliers_1055 = constraints_multipliers_1054
        + ball2_G_15 * constraints_multipliers_698 + ball2_G_16 * constraints_multipliers_682;
    const real ball2_G_17 = work[588];
    const real ball2_G_18 = work[589];
    const real constraints_multipliers_1056 = constraints_multipliers_1055
        + ball2_G_17 * constraints_multipliers_683 + ball2_G_18 * constraints_multipliers_684;
    work[49] = constraints_multipliers_1056;
    work[63] = constraints_multipliers_1056;
    const real constraints_multipliers_709 = work[471];
    const real constraints_multipliers_713 = work[477];
    const real constraints_multipliers_715 = work[478];
    const real constraints_multipliers_1057 = ball2_G_10 * constraints_multipliers_709
        + ball2_G_11 * constraints_multipliers_713 + ball2_G_12 * constraints_multipliers_715;
    const real constraints_multipliers_718 = work[479];
    const real constraints_multipliers_722 = work[480];
    const real constraints_multipliers_1058 = constraints_multipliers_1057
        + ball2_G_13 * constraints_multipliers_718 + ball2_G_14 * constraints_multipliers_722;
    const real constraints_multipliers_726 = work[481];
    const real constraints_multipliers_710 = work[474];
    const real constraints_multipliers_1059 = constraints_multipliers_1058
        + ball2_G_15 * constraints_multipliers_726 + ball2_G_16 * constraints_multipliers_710;
    const real constraints_multipliers_711 = work[475];
    const real constraints_multipliers_712 = work[476];
    const real constraints_multipliers_1060 = constraints_multipliers_1059
        + ball2_G_17 * constraints_multipliers_711 + ball2_G_18 * constraints_multipliers_712;
    work[64] = constraints_multipliers_1060;
    const real ball2_G_19 = work[590];
    const real ball2_G_20 = work[591];
    const real ball2_G_21 = work[592];
    const real constraints_multipliers_1061 = ball2_G_19 * constraints_multipliers_597
        + ball2_G_20 * constraints_multipliers_601 + ball2_G_21 * constraints_multipliers_603;
    const real ball2_G_22 = work[593];
    const real ball2_G_23 = work[594];
    const real constraints_multipliers_1062 = constraints_multipliers_1061
        + ball2_G_22 * constraints_multipliers_606 + ball2_G_23 * constraints_multipliers_610;
    const real ball2_G_24 = work[595];
    const real constraints_multipliers_1063 = constraints_multipliers_1062
        + ball2_G_24 * constraints_multipliers_614;
    work[5] = constraints_multipliers_1063;
    work[75] = constraints_multipliers_1063;
    const real constraints_multipliers_1064 = ball2_G_19 * constraints_multipliers_625
        + ball2_G_20 * constraints_multipliers_629 + ball2_G_21 * constraints_multipliers_631;
    const real constraints_multipliers_1065 = constraints_multipliers_1064
        + ball2_G_22 * constraints_multipliers_634 + ball2_G_23 * constraints_multipliers_638;
    const real constraints_multipliers_1066 = constraints_multipliers_1065
        + ball2_G_24 * constraints_multipliers_642;
    work[20] = constraints_multipliers_1066;
    work[76] = constraints_multipliers_1066;
    const real constraints_multipliers_1067 = ball2_G_19 * constraints_multipliers_653
        + ball2_G_20 * constraints_multipliers_657 + ball2_G_21 * constraints_multipliers_659;
    const real constraints_multipliers_1068 = constraints_multipliers_1067
        + ball2_G_22 * constraints_multipliers_662 + ball2_G_23 * constraints_multipliers_666;
    const real constraints_multipliers_1069 = constraints_multipliers_1068
        + ball2_G_24 * constraints_multipliers_670;
    work[35] = constraints_multipliers_1069;
    work[77] = constraints_multipliers_1069;
    const real constraints_multipliers_1070 = ball2_G_19 * constraints_multipliers_681
        + ball2_G_20 * constraints_multipliers_685 + ball2_G_21 * constraints_multipliers_687;
    const real constraints_multipliers_1071 = constraints_multipliers_1070
        + ball2_G_22 * constraints_multipliers_690 + ball2_G_23 * constraints_multipliers_694;
    const real ball2_G_25 = work[596];
    const real constraints_multipliers_1072 = constraints_multipliers_1071
        + ball2_G_24 * constraints_multipliers_698 + ball2_G_25 * constraints_multipliers_682;
    const real ball2_G_26 = work[597];
    const real ball2_G_27 = work[598];
    const real constraints_multipliers_1073 = constraints_multipliers_1072
        + ball2_G_26 * constraints_multipliers_683 + ball2_G_27 * constraints_multipliers_684;
    work[50] = constraints_multipliers_1073;
    work[78] = constraints_multipliers_1073;
    const real constraints_multipliers_1074 = ball2_G_19 * constraints_multipliers_709
        + ball2_G_20 * constraints_multipliers_713 + ball2_G_21 * constraints_multipliers_715;
    const real constraints_multipliers_1075 = constraints_multipliers_1074
        + ball2_G_22 * constraints_multipliers_718 + ball2_G_23 * constraints_multipliers_722;
    const real constraints_multipliers_1076 = constraints_multipliers_1075
        + ball2_G_24 * constraints_multipliers_726 + ball2_G_25 * constraints_multipliers_710;
    const real constraints_multipliers_1077 = constraints_multipliers_1076
        + ball2_G_26 * constraints_multipliers_711 + ball2_G_27 * constraints_multipliers_712;
    work[65] = constraints_multipliers_1077;
    work[79] = constraints_multipliers_1077;
    const real constraints_multipliers_737 = work[482];
    const real constraints_multipliers_741 = work[486];
    const real constraints_multipliers_743 = work[487];
    const real constraints_multipliers_1078 = ball2_G_19 * constraints_multipliers_737
        + ball2_G_20 * constraints_multipliers_741 + ball2_G_21 * constraints_multipliers_743;
    const real constraints_multipliers_746 = work[488];
    const real constraints_multipliers_750 = work[489];
    const real constraints_multipliers_1079 = constraints_multipliers_1078
        + ball2_G_22 * constraints_multipliers_746 + ball2_G_23 * constraints_multipliers_750;
    const real constraints_multipliers_754 = work[490];
    const real constraints_multipliers_738 = work[483];
    const real constraints_multipliers_1080 = constraints_multipliers_1079
        + ball2_G_24 * constraints_multipliers_754 + ball2_G_25 * constraints_multipliers_738;
    const real constraints_multipliers_739 = work[484];
    const real constraints_multipliers_740 = work[485];
    const real constraints_multipliers_1081 = constraints_multipliers_1080
        + ball2_G_26 * constraints_multipliers_739 + ball2_G_27 * constraints_multipliers_740;
    work[80] = constraints_multipliers_1081;
    const real ball3_G = work[640];
    const real ball3_G_2 = work[641];
    const real ball3_G_3 = work[642];
    const real constraints_multipliers_1082 = ball3_G * constraints_multipliers_597
        + ball3_G_2 * constraints_multipliers_601 + ball3_G_3 * constraints_multipliers_603;
    const real ball3_G_4 = work[643];
    const real ball3_G_5 = work[644];
    const real constraints_multipliers_1083 = constraints_multipliers_1082
        + ball3_G_4 * constraints_multipliers_606 + ball3_G_5 * constraints_multipliers_610;
    const real ball3_G_6 = work[645];
    const real constraints_multipliers_1084 = constraints_multipliers_1083
        + ball3_G_6 * constraints_multipliers_614;
    work[6] = constraints_multipliers_1084;
    work[90] = constraints_multipliers_1084;
    const real constraints_multipliers_1085 = ball3_G * constraints_multipliers_625
        + ball3_G_2 * constraints_multipliers_629 + ball3_G_3 * constraints_multipliers_631;
    const real constraints_multipliers_1086 = constraints_multipliers_1085
        + ball3_G_4 * constraints_multipliers_634 + ball3_G_5 * constraints_multipliers_638;
    const real constraints_multipliers_1087 = constraints_multipliers_1086
        + ball3_G_6 * constraints_multipliers_642;
    work[21] = constraints_multipliers_1087;
    work[91] = constraints_multipliers_1087;
    const real constraints_multipliers_1088 = ball3_G * constraints_multipliers_653
        + ball3_G_2 * constraints_multipliers_657 + ball3_G_3 * constraints_multipliers_659;
    const real constraints_multipliers_1089 = constraints_multipliers_1088
        + ball3_G_4 * constraints_multipliers_662 + ball3_G_5 * constraints_multipliers_666;
    const real constraints_multipliers_1090 = constraints_multipliers_1089
        + ball3_G_6 * constraints_multipliers_670;
    work[36] = constraints_multipliers_1090;
    work[92] = constraints_multipliers_1090;
    const real constraints_multipliers_1091 = ball3_G * constraints_multipliers_681
        + ball3_G_2 * constraints_multipliers_685 + ball3_G_3 * constraints_multipliers_687;
    const real constraints_multipliers_1092 = constraints_multipliers_1091
        + ball3_G_4 * constraints_multipliers_690 + ball3_G_5 * constraints_multipliers_694;
    const real constraints_multipliers_1093 = constraints_multipliers_1092
        + ball3_G_6 * constraints_multipliers_698;
    work[51] = constraints_multipliers_1093;
    work[93] = constraints_multipliers_1093;
    const real constraints_multipliers_1094 = ball3_G * constraints_multipliers_709
        + ball3_G_2 * constraints_multipliers_713 + ball3_G_3 * constraints_multipliers_715;
    const real constraints_multipliers_1095 = constraints_multipliers_1094
        + ball3_G_4 * constraints_multipliers_718 + ball3_G_5 * constraints_multipliers_722;
    const real constraints_multipliers_1096 = constraints_multipliers_1095
        + ball3_G_6 * constraints_multipliers_726;
    work[66] = constraints_multipliers_1096;
    work[94] = constraints_multipliers_1096;
    const real constraints_multipliers_1097 = ball3_G * constraints_multipliers_737
        + ball3_G_2 * constraints_multipliers_741 + ball3_G_3 * constraints_multipliers_743;
    const real constraints_multipliers_1098 = constraints_multipliers_1097
        + ball3_G_4 * constraints_multipliers_746 + ball3_G_5 * constraints_multipliers_750;
    const real constraints_multipliers_1099 = constraints_multipliers_1098
        + ball3_G_6 * constraints_multipliers_754;
    work[81] = constraints_multipliers_1099;
    work[95] = constraints_multipliers_1099;
    const real constraints_multipliers_765 = work[518];
    const real constraints_multipliers_769 = work[525];
    const real constraints_multipliers_771 = work[526];
    const real constraints_multipliers_1100 = ball3_G * constraints_multipliers_765
        + ball3_G_2 * constraints_multipliers_769 + ball3_G_3 * constraints_multipliers_771;
    const real constraints_multipliers_774 = work[527];
    const real constraints_multipliers_778 = work[528];
    const real constraints_multipliers_1101 = constraints_multipliers_1100
        + ball3_G_4 * constraints_multipliers_774 + ball3_G_5 * constraints_multipliers_778;
    const real constraints_multipliers_782 = work[529];
    const real ball3_G_7 = work[646];
    const real constraints_multipliers_766 = work[519];
    const real constraints_multipliers_1102 = constraints_multipliers_1101
        + ball3_G_6 * constraints_multipliers_782 + ball3_G_7 * constraints_multipliers_766;
    const real ball3_G_8 = work[647];
    const real constraints_multipliers_767 = work[523];
    const real ball3_G_9 = work[648];
    const real constraints_multipliers_768 = work[524];
    const real constraints_multipliers_1103 = constraints_multipliers_1102
        + ball3_G_8 * constraints_multipliers_767 + ball3_G_9 * constraints_multipliers_768;
    work[96] = constraints_multipliers_1103;
    const real ball3_G_10 = work[649];
    const real ball3_G_11 = work[650];
    const real ball3_G_12 = work[651];
    const real constraints_multipliers_1104 = ball3_G_10 * constraints_multipliers_597
        + ball3_G_11 * constraints_multipliers_601 + ball3_G_12 * constraints_multipliers_603;
    const real ball3_G_13 = work[652];
    const real ball3_G_14 = work[653];
    const real constraints_multipliers_1105 = constraints_multipliers_1104
        + ball3_G_13 * constraints_multipliers_606 + ball3_G_14 * constraints_multipliers_610;
    const real ball3_G_15 = work[654];
    const real constraints_multipliers_1106 = constraints_multipliers_1105
        + ball3_G_15 * constraints_multipliers_614;
    work[7] = constraints_multipliers_1106;
    work[105] = constraints_multipliers_1106;
    const real constraints_multipliers_1107 = ball3_G_10 * constraints_multipliers_625
        + ball3_G_11 * constraints_multipliers_629 + ball3_G_12 * constraints_multipliers_631;
    const real constraints_multipliers_1108 = constraints_multipliers_1107
        + ball3_G_13 * constraints_multipliers_634 + ball3_G_14 * constraints_multipliers_638;
    const real constraints_multipliers_1109 = constraints_multipliers_1108
        + ball3_G_15 * constraints_multipliers_642;
    work[22] = constraints_multipliers_1109;
    work[106] = constraints_multipliers_1109;
    const real constraints_multipliers_1110 = ball3_G_10 * constraints_multipliers_653
        + ball3_G_11 * constraints_multipliers_657 + ball3_G_12 * constraints_multipliers_659;
    const real constraints_multipliers_1111 = constraints_multipliers_1110
        + ball3_G_13 * constraints_multipliers_662 + ball3_G_14 * constraints_multipliers_666;
    const real constraints_multipliers_1112 = constraints_multipliers_1111
        + ball3_G_15 * constraints_multipliers_670;
    work[37] = constraints_multipliers_1112;
    work[107] = constraints_multipliers_1112;
    const real constraints_multipliers_1113 = ball3_G_10 * constraints_multipliers_681
        + ball3_G_11 * constraints_multipliers_685 + ball3_G_12 * constraints_multipliers_687;
    const real constraints_multipliers_1114 = constraints_multipliers_1113
        + ball3_G_13 * constraints_multipliers_690 + ball3_G_14 * constraints_multipliers_694;
    const real constraints_multipliers_1115 = constraints_multipliers_1114
        + ball3_G_15 * constraints_multipliers_698;
    work[52] = constraints_multipliers_1115;
    work[108] = constraints_multipliers_1115;
    const real constraints_multipliers_1116 = ball3_G_10 * constraints_multipliers_709
        + ball3_G_11 * constraints_multipliers_713 + ball3_G_12 * constraints_multipliers_715;
    const real constraints_multipliers_1117 = constraints_multipliers_1116
        + ball3_G_13 * constraints_multipliers_718 + ball3_G_14 * constraints_multipliers_722;
    const real constraints_multipliers_1118 = constraints_multipliers_1117
        + ball3_G_15 * constraints_multipliers_726;
    work[67] = constraints_multipliers_1118;
    work[109] = constraints_multipliers_1118;
    const real constraints_multipliers_1119 = ball3_G_10 * constraints_multipliers_737
        + ball3_G_11 * constraints_multipliers_741 + ball3_G_12 * constraints_multipliers_743;
    const real constraints_multipliers_1120 = constraints_multipliers_1119
        + ball3_G_13 * constraints_multipliers_746 + ball3_G_14 * constraints_multipliers_750;
    const real constraints_multipliers_1121 = constraints_multipliers_1120
        + ball3_G_15 * constraints_multipliers_754;
    work[82] = constraints_multipliers_1121;
    work[110] = constraints_multipliers_1121;
    const real constraints_multipliers_1122 = ball3_G_10 * constraints_multipliers_765
        + ball3_G_11 * constraints_multipliers_769 + ball3_G_12 * constraints_multipliers_771;
    const real constraints_multipliers_1123 = constraints_multipliers_1122
        + ball3_G_13 * constraints_multipliers_774 + ball3_G_14 * constraints_multipliers_778;
    const real ball3_G_16 = work[655];
    const real constraints_multipliers_1124 = constraints_multipliers_1123
        + ball3_G_15 * constraints_multipliers_782 + ball3_G_16 * constraints_multipliers_766;
    const real ball3_G_17 = work[656];
    const real ball3_G_18 = work[657];
    const real constraints_multipliers_1125 = constraints_multipliers_1124
        + ball3_G_17 * constraints_multipliers_767 + ball3_G_18 * constraints_multipliers_768;
    work[97] = constraints_multipliers_1125;
    work[111] = constraints_multipliers_1125;
    const real constraints_multipliers_793 = work[530];
    const real constraints_multipliers_797 = work[534];
    const real constraints_multipliers_799 = work[536];
    const real constraints_multipliers_1126 = ball3_G_10 * constraints_multipliers_793
        + ball3_G_11 * constraints_multipliers_797 + ball3_G_12 * constraints_multipliers_799;
    const real constraints_multipliers_802 = work[537];
    const real constraints_multipliers_806 = work[538];
    const real constraints_multipliers_1127 = constraints_multipliers_1126
        + ball3_G_13 * constraints_multipliers_802 + ball3_G_14 * constraints_multipliers_806;
    const real constraints_multipliers_810 = work[539];
    const real constraints_multipliers_794 = work[531];
    const real constraints_multipliers_1128 = constraints_multipliers_1127
        + ball3_G_15 * constraints_multipliers_810 + ball3_G_16 * constraints_multipliers_794;
    const real constraints_multipliers_795 = work[532];
    const real constraints_multipliers_796 = work[533];
    const real constraints_multipliers_1129 = constraints_multipliers_1128
        + ball3_G_17 * constraints_multipliers_795 + ball3_G_18 * constraints_multipliers_796;
    work[112] = constraints_multipliers_1129;
    const real ball3_G_19 = work[658];
    const real ball3_G_20 = work[659];
    const real ball3_G_21 = work[660];
    const real constraints_multipliers_1130 = ball3_G_19 * constraints_multipliers_597
        + ball3_G_20 * constraints_multipliers_601 + ball3_G_21 * constraints_multipliers_603;
    const real ball3_G_22 = work[661];
    const real ball3_G_23 = work[662];
    const real constraints_multipliers_1131 = constraints_multipliers_1130
        + ball3_G_22 * constraints_multipliers_606 + ball3_G_23 * constraints_multipliers_610;
    const real ball3_G_24 = work[663];
    const real constraints_multipliers_1132 = constraints_multipliers_1131
        + ball3_G_24 * constraints_multipliers_614;
    work[8] = constraints_multipliers_1132;
    work[120] = constraints_multipliers_1132;
    const real constraints_multipliers_1133 = ball3_G_19 * constraints_multipliers_625
        + ball3_G_20 * constraints_multipliers_629 + ball3_G_21 * constraints_multipliers_631;
    const real constraints_multipliers_1134 = constraints_multipliers_1133
        + ball3_G_22 * constraints_multipliers_634 + ball3_G_23 * constraints_multipliers_638;
    const real constraints_multipliers_1135 = constraints_multipliers_1134
        + ball3_G_24 * constraints_multipliers_642;
    work[23] = constraints_multipliers_1135;
    work[121] = constraints_multipliers_1135;
    const real constraints_multipliers_1136 = ball3_G_19 * constraints_multipliers_653
        + ball3_G_20 * constraints_multipliers_657 + ball3_G_21 * constraints_multipliers_659;
    const real constraints_multipliers_1137 = constraints_multipliers_1136
        + ball3_G_22 * constraints_multipliers_662 + ball3_G_23 * constraints_multipliers_666;
    const real constraints_multipliers_1138 = constraints_multipliers_1137
        + ball3_G_24 * constraints_multipliers_670;
    work[38] = constraints_multipliers_1138;
    work[122] = constraints_multipliers_1138;
    const real constraints_multipliers_1139 = ball3_G_19 * constraints_multipliers_681
        + ball3_G_20 * constraints_multipliers_685 + ball3_G_21 * constraints_multipliers_687;
    const real constraints_multipliers_1140 = constraints_multipliers_1139
        + ball3_G_22 * constraints_multipliers_690 + ball3_G_23 * constraints_multipliers_694;
    const real constraints_multipliers_1141 = constraints_multipliers_1140
        + ball3_G_24 * constraints_multipliers_698;
    work[53] = constraints_multipliers_1141;
    work[123] = constraints_multipliers_1141;
    const real constraints_multipliers_1142 = ball3_G_19 * constraints_multipliers_709
        + ball3_G_20 * constraints_multipliers_713 + ball3_G_21 * constraints_multipliers_715;
    const real constraints_multipliers_1143 = constraints_multipliers_1142
        + ball3_G_22 * constraints_multipliers_718 + ball3_G_23 * constraints_multipliers_722;
    const real constraints_multipliers_1144 = constraints_multipliers_1143
        + ball3_G_24 * constraints_multipliers_726;
    work[68] = constraints_multipliers_1144;
    work[124] = constraints_multipliers_1144;
    const real constraints_multipliers_1145 = ball3_G_19 * constraints_multipliers_737
        + ball3_G_20 * constraints_multipliers_741 + ball3_G_21 * constraints_multipliers_743;
    const real constraints_multipliers_1146 = constraints_multipliers_1145
        + ball3_G_22 * constraints_multipliers_746 + ball3_G_23 * constraints_multipliers_750;
    const real constraints_multipliers_1147 = constraints_multipliers_1146
        + ball3_G_24 * constraints_multipliers_754;
    work[83] = constraints_multipliers_1147;
    work[125] = constraints_multipliers_1147;
    const real constraints_multipliers_1148 = ball3_G_19 * constraints_multipliers_765
        + ball3_G_20 * constraints_multipliers_769 + ball3_G_21 * constraints_multipliers_771;
    const real constraints_multipliers_1149 = constraints_multipliers_1148
        + ball3_G_22 * constraints_multipliers_774 + ball3_G_23 * constraints_multipliers_778;
    const real ball3_G_25 = work[664];
    const real constraints_multipliers_1150 = constraints_multipliers_1149
        + ball3_G_24 * constraints_multipliers_782 + ball3_G_25 * constraints_multipliers_766;
    const real ball3_G_26 = work[665];
    const real ball3_G_27 = work[666];
    const real constraints_multipliers_1151 = constraints_multipliers_1150
        + ball3_G_26 * constraints_multipliers_767 + ball3_G_27 * constraints_multipliers_768;
    work[98] = constraints_multipliers_1151;
    work[126] = constraints_multipliers_1151;
    const real constraints_multipliers_1152 = ball3_G_19 * constraints_multipliers_793
        + ball3_G_20 * constraints_multipliers_797 + ball3_G_21 * constraints_multipliers_799;
    const real constraints_multipliers_1153 = constraints_multipliers_1152
        + ball3_G_22 * constraints_multipliers_802 + ball3_G_23 * constraints_multipliers_806;
    const real constraints_multipliers_1154 = constraints_multipliers_1153
        + ball3_G_24 * constraints_multipliers_810 + ball3_G_25 * constraints_multipliers_794;
    const real constraints_multipliers_1155 = constraints_multipliers_1154
        + ball3_G_26 * constraints_multipliers_795 + ball3_G_27 * constraints_multipliers_796;
    work[113] = constraints_multipliers_1155;
    work[127] = constraints_multipliers_1155;
    const real constraints_multipliers_821 = work[540];
    const real constraints_multipliers_825 = work[544];
    const real constraints_multipliers_827 = work[545];
    const real constraints_multipliers_1156 = ball3_G_19 * constraints_multipliers_821
        + ball3_G_20 * constraints_multipliers_825 + ball3_G_21 * constraints_multipliers_827;
    const real constraints_multipliers_830 = work[546];
    const real constraints_multipliers_834 = work[547];
    const real constraints_multipliers_1157 = constraints_multipliers_1156
        + ball3_G_22 * constraints_multipliers_830 + ball3_G_23 * constraints_multipliers_834;
    const real constraints_multipliers_838 = work[548];
    const real constraints_multipliers_822 = work[541];
    const real constraints_multipliers_1158 = constraints_multipliers_1157
        + ball3_G_24 * constraints_multipliers_838 + ball3_G_25 * constraints_multipliers_822;
    const real constraints_multipliers_823 = work[542];
    const real constraints_multipliers_824 = work[543];
    const real constraints_multipliers_1159 = constraints_multipliers_1158
        + ball3_G_26 * constraints_multipliers_823 + ball3_G_27 * constraints_multipliers_824;
    work[128] = constraints_multipliers_1159;
    const real ball4_G = work[709];
    const real ball4_G_2 = work[710];
    const real ball4_G_3 = work[711];
    const real constraints_multipliers_1160 = ball4_G * constraints_multipliers_597
        + ball4_G_2 * constraints_multipliers_601 + ball4_G_3 * constraints_multipliers_603;
    const real ball4_G_4 = work[712];
    const real ball4_G_5 = work[713];
    const real constraints_multipliers_1161 = constraints_multipliers_1160
        + ball4_G_4 * constraints_multipliers_606 + ball4_G_5 * constraints_multipliers_610;
    const real ball4_G_6 = work[714];
    const real constraints_multipliers_1162 = constraints_multipliers_1161
        + ball4_G_6 * constraints_multipliers_614;
    work[9] = constraints_multipliers_1162;
    work[135] = constraints_multipliers_1162;
    const real constraints_multipliers_1163 = ball4_G * constraints_multipliers_625
        + ball4_G_2 * constraints_multipliers_629 + ball4_G_3 * constraints_multipliers_631;
    const real constraints_multipliers_1164 = constraints_multipliers_1163
        + ball4_G_4 * constraints_multipliers_634 + ball4_G_5 * constraints_multipliers_638;
    const real constraints_multipliers_1165 = constraints_multipliers_1164
        + ball4_G_6 * constraints_multipliers_642;
    work[24] = constraints_multipliers_1165;
    work[136] = constraints_multipliers_1165;
    const real constraints_multipliers_1166 = ball4_G * constraints_multipliers_653
        + ball4_G_2 * constraints_multipliers_657 + ball4_G_3 * constraints_multipliers_659;
    const real constraints_multipliers_1167 = constraints_multipliers_1166
        + ball4_G_4 * constraints_multipliers_662 + ball4_G_5 * constraints_multipliers_666;
    const real constraints_multipliers_1168 = constraints_multipliers_1167
        + ball4_G_6 * constraints_multipliers_670;
    work[39] = constraints_multipliers_1168;
    work[137] = constraints_multipliers_1168;
    const real constraints_multipliers_1169 = ball4_G * constraints_multipliers_681
        + ball4_G_2 * constraints_multipliers_685 + ball4_G_3 * constraints_multipliers_687;
    const real constraints_multipliers_1170 = constraints_multipliers_1169
        + ball4_G_4 * constraints_multipliers_690 + ball4_G_5 * constraints_multipliers_694;
    const real constraints_multipliers_1171 = constraints_multipliers_1170
        + ball4_G_6 * constraints_multipliers_698;
    work[54] = constraints_multipliers_1171;
    work[138] = constraints_multipliers_1171;
    const real constraints_multipliers_1172 = ball4_G * constraints_multipliers_709
        + ball4_G_2 * constraints_multipliers_713 + ball4_G_3 * constraints_multipliers_715;
    const real constraints_multipliers_1173 = constraints_multipliers_1172
        + ball4_G_4 * constraints_multipliers_718 + ball4_G_5 * constraints_multipliers_722;
    const real constraints_multipliers_1174 = constraints_multipliers_1173
        + ball4_G_6 * constraints_multipliers_726;
    work[69] = constraints_multipliers_1174;
    work[139] = constraints_multipliers_1174;
    const real constraints_multipliers_1175 = ball4_G * constraints_multipliers_737
        + ball4_G_2 * constraints_multipliers_741 + ball4_G_3 * constraints_multipliers_743;
    const real constraints_multipliers_1176 = constraints_multipliers_1175
        + ball4_G_4 * constraints_multipliers_746 + ball4_G_5 * constraints_multipliers_750;
    const real constraints_multipliers_1177 = constraints_multipliers_1176
        + ball4_G_6 * constraints_multipliers_754;
    work[84] = constraints_multipliers_1177;
    work[140] = constraints_multipliers_1177;
    const real constraints_multipliers_1178 = ball4_G * constraints_multipliers_765
        + ball4_G_2 * constraints_multipliers_769 + ball4_G_3 * constraints_multipliers_771;
    const real constraints_multipliers_1179 = constraints_multipliers_1178
        + ball4_G_4 * constraints_multipliers_774 + ball4_G_5 * constraints_multipliers_778;
    const real constraints_multipliers_1180 = constraints_multipliers_1179
        + ball4_G_6 * constraints_multipliers_782;
    work[99] = constraints_multipliers_1180;
    work[141] = constraints_multipliers_1180;
    const real constraints_multipliers_1181 = ball4_G * constraints_multipliers_793
        + ball4_G_2 * constraints_multipliers_797 + ball4_G_3 * constraints_multipliers_799;
    const real constraints_multipliers_1182 = constraints_multipliers_1181
        + ball4_G_4 * constraints_multipliers_802 + ball4_G_5 * constraints_multipliers_806;
    const real constraints_multipliers_1183 = constraints_multipliers_1182
        + ball4_G_6 * constraints_multipliers_810;
    work[114] = constraints_multipliers_1183;
    work[142] = constraints_multipliers_1183;
    const real constraints_multipliers_1184 = ball4_G * constraints_multipliers_821
        + ball4_G_2 * constraints_multipliers_825 + ball4_G_3 * constraints_multipliers_827;
    const real constraints_multipliers_1185 = constraints_multipliers_1184
        + ball4_G_4 * constraints_multipliers_830 + ball4_G_5 * constraints_multipliers_834;
    const real constraints_multipliers_1186 = constraints_multipliers_1185
        + ball4_G_6 * constraints_multipliers_838;
    work[129] = constraints_multipliers_1186;
    work[143] = constraints_multipliers_1186;
    const real constraints_multipliers_849 = work[549];
    const real constraints_multipliers_853 = work[553];
    const real constraints_multipliers_855 = work[554];
    const real constraints_multipliers_1187 = ball4_G * constraints_multipliers_849
        + ball4_G_2 * constraints_multipliers_853 + ball4_G_3 * constraints_multipliers_855;
    const real constraints_multipliers_858 = work[555];
    const real constraints_multipliers_862 = work[556];
    const real constraints_multipliers_1188 = constraints_multipliers_1187
        + ball4_G_4 * constraints_multipliers_858 + ball4_G_5 * constraints_multipliers_862;
    const real constraints_multipliers_866 = work[557];
    const real ball4_G_7 = work[715];
    const real constraints_multipliers_850 = work[550];
    const real constraints_multipliers_1189 = constraints_multipliers_1188
        + ball4_G_6 * constraints_multipliers_866 + ball4_G_7 * constraints_multipliers_850;
    const real ball4_G_8 = work[716];
    const real constraints_multipliers_851 = work[551];
    const real ball4_G_9 = work[717];
    const real constraints_multipliers_852 = work[552];
    const real constraints_multipliers_1190 = constraints_multipliers_1189
        + ball4_G_8 * constraints_multipliers_851 + ball4_G_9 * constraints_multipliers_852;
    work[144] = constraints_multipliers_1190;
    const real ball4_G_10 = work[718];
    const real ball4_G_11 = work[719];
    const real ball4_G_12 = work[720];
    const real constraints_multipliers_1191 = ball4_G_10 * constraints_multipliers_597
        + ball4_G_11 * constraints_multipliers_601 + ball4_G_12 * constraints_multipliers_603;
    const real ball4_G_13 = work[721];
    const real ball4_G_14 = work[722];
    const real constraints_multipliers_1192 = constraints_multipliers_1191
        + ball4_G_13 * constraints_multipliers_606 + ball4_G_14 * constraints_multipliers_610;
    const real ball4_G_15 = work[723];
    const real constraints_multipliers_1193 = constraints_multipliers_1192
        + ball4_G_15 * constraints_multipliers_614;
    work[10] = constraints_multipliers_1193;
    work[150] = constraints_multipliers_1193;
    const real constraints_multipliers_1194 = ball4_G_10 * constraints_multipliers_625
        + ball4_G_11 * constraints_multipliers_629 + ball4_G_12 * constraints_multipliers_631;
    const real constraints_multipliers_1195 = constraints_multipliers_1194
        + ball4_G_13 * constraints_multipliers_634 + ball4_G_14 * constraints_multipliers_638;
    const real constraints_multipliers_1196 = constraints_multipliers_1195
        + ball4_G_15 * constraints_multipliers_642;
    work[25] = constraints_multipliers_1196;
    work[151] = constraints_multipliers_1196;
    const real constraints_multipliers_1197 = ball4_G_10 * constraints_multipliers_653
        + ball4_G_11 * constraints_multipliers_657 + ball4_G_12 * constraints_multipliers_659;
    const real constraints_multipliers_1198 = constraints_multipliers_1197
        + ball4_G_13 * constraints_multipliers_662 + ball4_G_14 * constraints_multipliers_666;
    const real constraints_multipliers_1199 = constraints_multipliers_1198
        + ball4_G_15 * constraints_multipliers_670;
    work[40] = constraints_multipliers_1199;
    work[152] = constraints_multipliers_1199;
    const real constraints_multipliers_1200 = ball4_G_10 * constraints_multipliers_681
        + ball4_G_11 * constraints_multipliers_685 + ball4_G_12 * constraints_multipliers_687;
    const real constraints_multipliers_1201 = constraints_multipliers_1200
        + ball4_G_13 * constraints_multipliers_690 + ball4_G_14 * constraints_multipliers_694;
    const real constraints_multipliers_1202 = constraints_multipliers_1201
        + ball4_G_15 * constraints_multipliers_698;
    work[55] = constraints_multipliers_1202;
    work[153] = constraints_multipliers_1202;
    const real constraints_multipliers_1203 = ball4_G_10 * constraints_multipliers_709
        + ball4_G_11 * constraints_multipliers_713 + ball4_G_12 * constraints_multipliers_715;
    const real constraints_multipliers_1204 = constraints_multipliers_1203
        + ball4_G_13 * constraints_multipliers_718 + ball4_G_14 * constraints_multipliers_722;
    const real constraints_multipliers_1205 = constraints_multipliers_1204
        + ball4_G_15 * constraints_multipliers_726;
    work[70] = constraints_multipliers_1205;
    work[154] = constraints_multipliers_1205;
    const real constraints_multipliers_1206 = ball4_G_10 * constraints_multipliers_737
        + ball4_G_11 * constraints_multipliers_741 + ball4_G_12 * constraints_multipliers_743;
    const real constraints_multipliers_1207 = constraints_multipliers_1206
        + ball4_G_13 * constraints_multipliers_746 + ball4_G_14 * constraints_multipliers_750;
    const real constraints_multipliers_1208 = constraints_multipliers_1207
        + ball4_G_15 * constraints_multipliers_754;
    work[85] = constraints_multipliers_1208;
    work[155] = constraints_multipliers_1208;
    const real constraints_multipliers_1209 = ball4_G_10 * constraints_multipliers_765
        + ball4_G_11 * constraints_multipliers_769 + ball4_G_12 * constraints_multipliers_771;
    const real constraints_multipliers_1210 = constraints_multipliers_1209
        + ball4_G_13 * constraints_multipliers_774 + ball4_G_14 * constraints_multipliers_778;
    const real constraints_multipliers_1211 = constraints_multipliers_1210
        + ball4_G_15 * constraints_multipliers_782;
    work[100] = constraints_multipliers_1211;
    work[156] = constraints_multipliers_1211;
    const real constraints_multipliers_1212 = ball4_G_10 * constraints_multipliers_793
        + ball4_G_11 * constraints_multipliers_797 + ball4_G_12 * constraints_multipliers_799;
    const real constraints_multipliers_1213 = constraints_multipliers_1212
        + ball4_G_13 * constraints_multipliers_802 + ball4_G_14 * constraints_multipliers_806;
    const real constraints_multipliers_1214 = constraints_multipliers_1213
        + ball4_G_15 * constraints_multipliers_810;
    work[115] = constraints_multipliers_1214;
    work[157] = constraints_multipliers_1214;
    const real constraints_multipliers_1215 = ball4_G_10 * constraints_multipliers_821
        + ball4_G_11 * constraints_multipliers_825 + ball4_G_12 * constraints_multipliers_827;
    const real constraints_multipliers_1216 = constraints_multipliers_1215
        + ball4_G_13 * constraints_multipliers_830 + ball4_G_14 * constraints_multipliers_834;
    const real constraints_multipliers_1217 = constraints_multipliers_1216
        + ball4_G_15 * constraints_multipliers_838;
    work[130] = constraints_multipliers_1217;
    work[158] = constraints_multipliers_1217;
    const real constraints_multipliers_1218 = ball4_G_10 * constraints_multipliers_849
        + ball4_G_11 * constraints_multipliers_853 + ball4_G_12 * constraints_multipliers_855;
    const real constraints_multipliers_1219 = constraints_multipliers_1218
        + ball4_G_13 * constraints_multipliers_858 + ball4_G_14 * constraints_multipliers_862;
    const real ball4_G_16 = work[724];
    const real constraints_multipliers_1220 = constraints_multipliers_1219
        + ball4_G_15 * constraints_multipliers_866 + ball4_G_16 * constraints_multipliers_850;
    const real ball4_G_17 = work[725];
    const real ball4_G_18 = work[726];
    const real constraints_multipliers_1221 = constraints_multipliers_1220
        + ball4_G_17 * constraints_multipliers_851 + ball4_G_18 * constraints_multipliers_852;
    work[145] = constraints_multipliers_1221;
    work[159] = constraints_multipliers_1221;
    const real constraints_multipliers_877 = work[558];
    const real constraints_multipliers_881 = work[562];
    const real constraints_multipliers_883 = work[563];
    const real constraints_multipliers_1222 = ball4_G_10 * constraints_multipliers_877
        + ball4_G_11 * constraints_multipliers_881 + ball4_G_12 * constraints_multipliers_883;
    const real constraints_multipliers_886 = work[564];
    const real constraints_multipliers_890 = work[565];
    const real constraints_multipliers_1223 = constraints_multipliers_1222
        + ball4_G_13 * constraints_multipliers_886 + ball4_G_14 * constraints_multipliers_890;
    const real constraints_multipliers_894 = work[566];
    const real constraints_multipliers_878 = work[559];
    const real constraints_multipliers_1224 = constraints_multipliers_1223
        + ball4_G_15 * constraints_multipliers_894 + ball4_G_16 * constraints_multipliers_878;
    const real constraints_multipliers_879 = work[560];
    const real constraints_multipliers_880 = work[561];
    const real constraints_multipliers_1225 = constraints_multipliers_1224
        + ball4_G_17 * constraints_multipliers_879 + ball4_G_18 * constraints_multipliers_880;
    work[160] = constraints_multipliers_1225;
    const real ball4_G_19 = work[727];
    const real ball4_G_20 = work[728];
    const real ball4_G_21 = work[729];
    const real constraints_multipliers_1226 = ball4_G_19 * constraints_multipliers_597
        + ball4_G_20 * constraints_multipliers_601 + ball4_G_21 * constraints_multipliers_603;
    const real ball4_G_22 = work[730];
    const real ball4_G_23 = work[731];
    const real constraints_multipliers_1227 = constraints_multipliers_1226
        + ball4_G_22 * constraints_multipliers_606 + ball4_G_23 * constraints_multipliers_610;
    const real ball4_G_24 = work[732];
    const real constraints_multipliers_1228 = constraints_multipliers_1227
        + ball4_G_24 * constraints_multipliers_614;
    work[11] = constraints_multipliers_1228;
    work[165] = constraints_multipliers_1228;
    const real constraints_multipliers_1229 = ball4_G_19 * constraints_multipliers_625
        + ball4_G_20 * constraints_multipliers_629 + ball4_G_21 * constraints_multipliers_631;
    const real constraints_multipliers_1230 = constraints_multipliers_1229
        + ball4_G_22 * constraints_multipliers_634 + ball4_G_23 * constraints_multipliers_638;
    const real constraints_multipliers_1231 = constraints_multipliers_1230
        + ball4_G_24 * constraints_multipliers_642;
    work[26] = constraints_multipliers_1231;
    work[166] = constraints_multipliers_1231;
    const real constraints_multipliers_1232 = ball4_G_19 * constraints_multipliers_653
        + ball4_G_20 * constraints_multipliers_657 + ball4_G_21 * constraints_multipliers_659;
    const real constraints_multipliers_1233 = constraints_multipliers_1232
        + ball4_G_22 * constraints_multipliers_662 + ball4_G_23 * constraints_multipliers_666;
    const real constraints_multipliers_1234 = constraints_multipliers_1233
        + ball4_G_24 * constraints_multipliers_670;
    work[41] = constraints_multipliers_1234;
    work[167] = constraints_multipliers_1234;
    const real constraints_multipliers_1235 = ball4_G_19 * constraints_multipliers_681
        + ball4_G_20 * constraints_multipliers_685 + ball4_G_21 * constraints_multipliers_687;
    const real constraints_multipliers_1236 = constraints_multipliers_1235
        + ball4_G_22 * constraints_multipliers_690 + ball4_G_23 * constraints_multipliers_694;
    const real constraints_multipliers_1237 = constraints_multipliers_1236
        + ball4_G_24 * constraints_multipliers_698;
    work[56] = constraints_multipliers_1237;
    work[168] = constraints_multipliers_1237;
    const real constraints_multipliers_1238 = ball4_G_19 * constraints_multipliers_709
        + ball4_G_20 * constraints_multipliers_713 + ball4_G_21 * constraints_multipliers_715;
    const real constraints_multipliers_1239 = constraints_multipliers_1238
        + ball4_G_22 * constraints_multipliers_718 + ball4_G_23 * constraints_multipliers_722;
    const real constraints_multipliers_1240 = constraints_multipliers_1239
        + ball4_G_24 * constraints_multipliers_726;
    work[71] = constraints_multipliers_1240;
    work[169] = constraints_multipliers_1240;
    const real constraints_multipliers_1241 = ball4_G_19 * constraints_multipliers_737
        + ball4_G_20 * constraints_multipliers_741 + ball4_G_21 * constraints_multipliers_743;
    const real constraints_multipliers_1242 = constraints_multipliers_1241
        + ball4_G_22 * constraints_multipliers_746 + ball4_G_23 * constraints_multipliers_750;
    const real constraints_multipliers_1243 = constraints_multipliers_1242
        + ball4_G_24 * constraints_multipliers_754;
    work[86] = constraints_multipliers_1243;
    work[170] = constraints_multipliers_1243;
    const real constraints_multipliers_1244 = ball4_G_19 * constraints_multipliers_765
        + ball4_G_20 * constraints_multipliers_769 + ball4_G_21 * constraints_multipliers_771;
    const real constraints_multipliers_1245 = constraints_multipliers_1244
        + ball4_G_22 * constraints_multipliers_774 + ball4_G_23 * constraints_multipliers_778;
    const real constraints_multipliers_1246 = constraints_multipliers_1245
        + ball4_G_24 * constraints_multipliers_782;
    work[101] = constraints_multipliers_1246;
    work[171] = constraints_multipliers_1246;
    const real constraints_multipliers_1247 = ball4_G_19 * constraints_multipliers_793
        + ball4_G_20 * constraints_multipliers_797 + ball4_G_21 * constraints_multipliers_799;
    const real constraints_multipliers_1248 = constraints_multipliers_1247
        + ball4_G_22 * constraints_multipliers_802 + ball4_G_23 * constraints_multipliers_806;
    const real constraints_multipliers_1249 = constraints_multipliers_1248
        + ball4_G_24 * constraints_multipliers_810;
    work[116] = constraints_multipliers_1249;
    work[172] = constraints_multipliers_1249;
    const real constraints_multipliers_1250 = ball4_G_19 * constraints_multipliers_821
        + ball4_G_20 * constraints_multipliers_825 + ball4_G_21 * constraints_multipliers_827;
    const real constraints_multipliers_1251 = constraints_multipliers_1250
        + ball4_G_22 * constraints_multipliers_830 + ball4_G_23 * constraints_multipliers_834;
    const real constraints_multipliers_1252 = constraints_multipliers_1251
        + ball4_G_24 * constraints_multipliers_838;
    work[131] = constraints_multipliers_1252;
    work[173] = constraints_multipliers_1252;
    const real constraints_multipliers_1253 = ball4_G_19 * constraints_multipliers_849
        + ball4_G_20 * constraints_multipliers_853 + ball4_G_21 * constraints_multipliers_855;
    const real constraints_multipliers_1254 = constraints_multipliers_1253
        + ball4_G_22 * constraints_multipliers_858 + ball4_G_23 * constraints_multipliers_862;
    const real ball4_G_25 = work[733];
    const real constraints_multipliers_1255 = constraints_multipliers_1254
        + ball4_G_24 * constraints_multipliers_866 + ball4_G_25 * constraints_multipliers_850;
    const real ball4_G_26 = work[734];
    const real ball4_G_27 = work[735];
    const real constraints_multipliers_1256 = constraints_multipliers_1255
        + ball4_G_26 * constraints_multipliers_851 + ball4_G_27 * constraints_multipliers_852;
    work[146] = constraints_multipliers_1256;
    work[174] = constraints_multipliers_1256;
    const real constraints_multipliers_1257 = ball4_G_19 * constraints_multipliers_877
        + ball4_G_20 * constraints_multipliers_881 + ball4_G_21 * constraints_multipliers_883;
    const real constraints_multipliers_1258 = constraints_multipliers_1257
        + ball4_G_22 * constraints_multipliers_886 + ball4_G_23 * constraints_multipliers_890;
    const real constraints_multipliers_1259 = constraints_multipliers_1258
        + ball4_G_24 * constraints_multipliers_894 + ball4_G_25 * constraints_multipliers_878;
    const real constraints_multipliers_1260 = constraints_multipliers_1259
        + ball4_G_26 * constraints_multipliers_879 + ball4_G_27 * constraints_multipliers_880;
    work[161] = constraints_multipliers_1260;
    work[175] = constraints_multipliers_1260;
    const real constraints_multipliers_905 = work[567];
    const real constraints_multipliers_909 = work[571];
    const real constraints_multipliers_911 = work[599];
    const real constraints_multipliers_1261 = ball4_G_19 * constraints_multipliers_905
        + ball4_G_20 * constraints_multipliers_909 + ball4_G_21 * constraints_multipliers_911;
    const real constraints_multipliers_914 = work[600];
    const real constraints_multipliers_918 = work[601];
    const real constraints_multipliers_1262 = constraints_multipliers_1261
        + ball4_G_22 * constraints_multipliers_914 + ball4_G_23 * constraints_multipliers_918;
    const real constraints_multipliers_922 = work[602];
    const real constraints_multipliers_906 = work[568];
    const real constraints_multipliers_1263 = constraints_multipliers_1262
        + ball4_G_24 * constraints_multipliers_922 + ball4_G_25 * constraints_multipliers_906;
    const real constraints_multipliers_907 = work[569];
    const real constraints_multipliers_908 = work[570];
    const real constraints_multipliers_1264 = constraints_multipliers_1263
        + ball4_G_26 * constraints_multipliers_907 + ball4_G_27 * constraints_multipliers_908;
    work[176] = constraints_multipliers_1264;
    const real ball5_G = work[769];
    const real ball5_G_2 = work[770];
    const real ball5_G_3 = work[771];
    const real constraints_multipliers_1265 = ball5_G * constraints_multipliers_597
        + ball5_G_2 * constraints_multipliers_601 + ball5_G_3 * constraints_multipliers_603;
    const real ball5_G_4 = work[772];
    const real ball5_G_5 = work[773];
    const real constraints_multipliers_1266 = constraints_multipliers_1265
        + ball5_G_4 * constraints_multipliers_606 + ball5_G_5 * constraints_multipliers_610;
    const real ball5_G_6 = work[774];
    const real constraints_multipliers_1267 = constraints_multipliers_1266
        + ball5_G_6 * constraints_multipliers_614;
    work[12] = constraints_multipliers_1267;
    work[180] = constraints_multipliers_1267;
    const real constraints_multipliers_1268 = ball5_G * constraints_multipliers_625
        + ball5_G_2 * constraints_multipliers_629 + ball5_G_3 * constraints_multipliers_631;
    const real constraints_multipliers_1269 = constraints_multipliers_1268
        + ball5_G_4 * constraints_multipliers_634 + ball5_G_5 * constraints_multipliers_638;
    const real constraints_multipliers_1270 = constraints_multipliers_1269
        + ball5_G_6 * constraints_multipliers_642;
    work[27] = constraints_multipliers_1270;
    work[181] = constraints_multipliers_1270;
    const real constraints_multipliers_1271 = ball5_G * constraints_multipliers_653
        + ball5_G_2 * constraints_multipliers_657 + ball5_G_3 * constraints_multipliers_659;
    const real constraints_multipliers_1272 = constraints_multipliers_1271
        + ball5_G_4 * constraints_multipliers_662 + ball5_G_5 * constraints_multipliers_666;
    const real constraints_multipliers_1273 = constraints_multipliers_1272
        + ball5_G_6 * constraints_multipliers_670;
    work[42] = constraints_multipliers_1273;
    work[182] = constraints_multipliers_1273;
    const real constraints_multipliers_1274 = ball5_G * constraints_multipliers_681
        + ball5_G_2 * constraints_multipliers_685 + ball5_G_3 * constraints_multipliers_687;
    const real constraints_multipliers_1275 = constraints_multipliers_1274
        + ball5_G_4 * constraints_multipliers_690 + ball5_G_5 * constraints_multipliers_694;
    const real constraints_multipliers_1276 = constraints_multipliers_1275
        + ball5_G_6 * constraints_multipliers_698;
    work[57] = constraints_multipliers_1276;
    work[183] = constraints_multipliers_1276;
    const real constraints_multipliers_1277 = ball5_G * constraints_multipliers_709
        + ball5_G_2 * constraints_multipliers_713 + ball5_G_3 * constraints_multipliers_715;
    const real constraints_multipliers_1278 = constraints_multipliers_1277
        + ball5_G_4 * constraints_multipliers_718 + ball5_G_5 * constraints_multipliers_722;
    const real constraints_multipliers_1279 = constraints_multipliers_1278
        + ball5_G_6 * constraints_multipliers_726;
    work[72] = constraints_multipliers_1279;
    work[184] = constraints_multipliers_1279;
    const real constraints_multipliers_1280 = ball5_G * constraints_multipliers_737
        + ball5_G_2 * constraints_multipliers_741 + ball5_G_3 * constraints_multipliers_743;
    const real constraints_multipliers_1281 = constraints_multipliers_1280
        + ball5_G_4 * constraints_multipliers_746 + ball5_G_5 * constraints_multipliers_750;
    const real constraints_multipliers_1282 = constraints_multipliers_1281
        + ball5_G_6 * constraints_multipliers_754;
    work[87] = constraints_multipliers_1282;
    work[185] = constraints_multipliers_1282;
    const real constraints_multipliers_1283 = ball5_G * constraints_multipliers_765
        + ball5_G_2 * constraints_multipliers_769 + ball5_G_3 * constraints_multipliers_771;
    const real constraints_multipliers_1284 = constraints_multipliers_1283
        + ball5_G_4 * constraints_multipliers_774 + ball5_G_5 * constraints_multipliers_778;
    const real constraints_multipliers_1285 = constraints_multipliers_1284
        + ball5_G_6 * constraints_multipliers_782;
    work[102] = constraints_multipliers_1285;
    work[186] = constraints_multipliers_1285;
    const real constraints_multipliers_1286 = ball5_G * constraints_multipliers_793
        + ball5_G_2 * constraints_multipliers_797 + ball5_G_3 * constraints_multipliers_799;
    const real constraints_multipliers_1287 = constraints_multipliers_1286
        + ball5_G_4 * constraints_multipliers_802 + ball5_G_5 * constraints_multipliers_806;
    const real constraints_multipliers_1288 = constraints_multipliers_1287
        + ball5_G_6 * constraints_multipliers_810;
    work[117] = constraints_multipliers_1288;
    work[187] = constraints_multipliers_1288;
    const real constraints_multipliers_1289 = ball5_G * constraints_multipliers_821
        + ball5_G_2 * constraints_multipliers_825 + ball5_G_3 * constraints_multipliers_827;
    const real constraints_multipliers_1290 = constraints_multipliers_1289
        + ball5_G_4 * constraints_multipliers_830 + ball5_G_5 * constraints_multipliers_834;
    const real constraints_multipliers_1291 = constraints_multipliers_1290
        + ball5_G_6 * constraints_multipliers_838;
    work[132] = constraints_multipliers_1291;
    work[188] = constraints_multipliers_1291;
    const real constraints_multipliers_1292 = ball5_G * constraints_multipliers_849
        + ball5_G_2 * constraints_multipliers_853 + ball5_G_3 * constraints_multipliers_855;
    const real constraints_multipliers_1293 = constraints_multipliers_1292
        + ball5_G_4 * constraints_multipliers_858 + ball5_G_5 * constraints_multipliers_862;
    const real constraints_multipliers_1294 = constraints_multipliers_1293
        + ball5_G_6 * constraints_multipliers_866;
    work[147] = constraints_multipliers_1294;
    work[189] = constraints_multipliers_1294;
    const real constraints_multipliers_1295 = ball5_G * constraints_multipliers_877
        + ball5_G_2 * constraints_multipliers_881 + ball5_G_3 * constraints_multipliers_883;
    const real constraints_multipliers_1296 = constraints_multipliers_1295
        + ball5_G_4 * constraints_multipliers_886 + ball5_G_5 * constraints_multipliers_890;
    const real constraints_multipliers_1297 = constraints_multipliers_1296
        + ball5_G_6 * constraints_multipliers_894;
    work[162] = constraints_multipliers_1297;
    work[190] = constraints_multipliers_1297;
    const real constraints_multipliers_1298 = ball5_G * constraints_multipliers_905
        + ball5_G_2 * constraints_multipliers_909 + ball5_G_3 * constraints_multipliers_911;
    const real constraints_multipliers_1299 = constraints_multipliers_1298
        + ball5_G_4 * constraints_multipliers_914 + ball5_G_5 * constraints_multipliers_918;
    const real constraints_multipliers_1300 = constraints_multipliers_1299
        + ball5_G_6 * constraints_multipliers_922;
    work[177] = constraints_multipliers_1300;
    work[191] = constraints_multipliers_1300;
    const real constraints_multipliers_933 = work[604];
    const real constraints_multipliers_937 = work[608];
    const real constraints_multipliers_939 = work[609];
    const real constraints_multipliers_1301 = ball5_G * constraints_multipliers_933
        + ball5_G_2 * constraints_multipliers_937 + ball5_G_3 * constraints_multipliers_939;
    const real constraints_multipliers_942 = work[610];
    const real constraints_multipliers_946 = work[611];
    const real constraints_multipliers_1302 = constraints_multipliers_1301
        + ball5_G_4 * constraints_multipliers_942 + ball5_G_5 * constraints_multipliers_946;
    const real constraints_multipliers_950 = work[612];
    const real ball5_G_7 = work[775];
    const real constraints_multipliers_934 = work[605];
    const real constraints_multipliers_1303 = constraints_multipliers_1302
        + ball5_G_6 * constraints_multipliers_950 + ball5_G_7 * constraints_multipliers_934;
    const real ball5_G_8 = work[776];
    const real constraints_multipliers_935 = work[606];
    const real ball5_G_9 = work[777];
    const real constraints_multipliers_936 = work[607];
    const real constraints_multipliers_1304 = constraints_multipliers_1303
        + ball5_G_8 * constraints_multipliers_935 + ball5_G_9 * constraints_multipliers_936;
    work[192] = constraints_multipliers_1304;
    const real ball5_G_10 = work[778];
    const real ball5_G_11 = work[779];
    const real ball5_G_12 = work[780];
    const real constraints_multipliers_1305 = ball5_G_10 * constraints_multipliers_597
        + ball5_G_11 * constraints_multipliers_601 + ball5_G_12 * constraints_multipliers_603;
    const real ball5_G_13 = work[781];
    const real ball5_G_14 = work[782];
    const real constraints_multipliers_1306 = constraints_multipliers_1305
        + ball5_G_13 * constraints_multipliers_606 + ball5_G_14 * constraints_multipliers_610;
    const real ball5_G_15 = work[783];
    const real constraints_multipliers_1307 = constraints_multipliers_1306
        + ball5_G_15 * constraints_multipliers_614;
    work[13] = constraints_multipliers_1307;
    work[195] = constraints_multipliers_1307;
    const real constraints_multipliers_1308 = ball5_G_10 * constraints_multipliers_625
        + ball5_G_11 * constraints_multipliers_629 + ball5_G_12 * constraints_multipliers_631;
    const real constraints_multipliers_1309 = constraints_multipliers_1308
        + ball5_G_13 * constraints_multipliers_634 + ball5_G_14 * constraints_multipliers_638;
    const real constraints_multipliers_1310 = constraints_multipliers_1309
        + ball5_G_15 * constraints_multipliers_642;
    work[28] = constraints_multipliers_1310;
    work[196] = constraints_multipliers_1310;
    const real constraints_multipliers_1311 = ball5_G_10 * constraints_multipliers_653
        + ball5_G_11 * constraints_multipliers_657 + ball5_G_12 * constraints_multipliers_659;
    const real constraints_multipliers_1312 = constraints_multipliers_1311
        + ball5_G_13 * constraints_multipliers_662 + ball5_G_14 * constraints_multipliers_666;
    const real constraints_multipliers_1313 = constraints_multipliers_1312
        + ball5_G_15 * constraints_multipliers_670;
    work[43] = constraints_multipliers_1313;
    work[197] = constraints_multipliers_1313;
    const real constraints_multipliers_1314 = ball5_G_10 * constraints_multipliers_681
        + ball5_G_11 * constraints_multipliers_685 + ball5_G_12 * constraints_multipliers_687;
    const real constraints_multipliers_1315 = constraints_multipliers_1314
        + ball5_G_13 * constraints_multipliers_690 + ball5_G_14 * constraints_multipliers_694;
    const real constraints_multipliers_1316 = constraints_multipliers_1315
        + ball5_G_15 * constraints_multipliers_698;
    work[58] = constraints_multipliers_1316;
    work[198] = constraints_multipliers_1316;
    const real constraints_multipliers_1317 = ball5_G_10 * constraints_multipliers_709
        + ball5_G_11 * constraints_multipliers_713 + ball5_G_12 * constraints_multipliers_715;
    const real constraints_multipliers_1318 = constraints_multipliers_1317
        + ball5_G_13 * constraints_multipliers_718 + ball5_G_14 * constraints_multipliers_722;
    const real constraints_multipliers_1319 = constraints_multipliers_1318
        + ball5_G_15 * constraints_multipliers_726;
    work[73] = constraints_multipliers_1319;
    work[199] = constraints_multipliers_1319;
    const real constraints_multipliers_1320 = ball5_G_10 * constraints_multipliers_737
        + ball5_G_11 * constraints_multipliers_741 + ball5_G_12 * constraints_multipliers_743;
    const real constraints_multipliers_1321 = constraints_multipliers_1320
        + ball5_G_13 * constraints_multipliers_746 + ball5_G_14 * constraints_multipliers_750;
    const real constraints_multipliers_1322 = constraints_multipliers_1321
        + ball5_G_15 * constraints_multipliers_754;
    work[88] = constraints_multipliers_1322;
    work[200] = constraints_multipliers_1322;
    const real constraints_multipliers_1323 = ball5_G_10 * constraints_multipliers_765
        + ball5_G_11 * constraints_multipliers_769 + ball5_G_12 * constraints_multipliers_771;
    const real constraints_multipliers_1324 = constraints_multipliers_1323
        + ball5_G_13 * constraints_multipliers_774 + ball5_G_14 * constraints_multipliers_778;
    const real constraints_multipliers_1325 = constraints_multipliers_1324
        + ball5_G_15 * constraints_multipliers_782;
    work[103] = constraints_multipliers_1325;
    work[201] = constraints_multipliers_1325;
    const real constraints_multipliers_1326 = ball5_G_10 * constraints_multipliers_793
        + ball5_G_11 * constraints_multipliers_797 + ball5_G_12 * constraints_multipliers_799;
    const real constraints_multipliers_1327 = constraints_multipliers_1326
        + ball5_G_13 * constraints_multipliers_802 + ball5_G_14 * constraints_multipliers_806;
    const real constraints_multipliers_1328 = constraints_multipliers_1327
        + ball5_G_15 * constraints_multipliers_810;
    work[118] = constraints_multipliers_1328;
    work[202] = constraints_multipliers_1328;
    const real constraints_multipliers_1329 = ball5_G_10 * constraints_multipliers_821
        + ball5_G_11 * constraints_multipliers_825 + ball5_G_12 * constraints_multipliers_827;
    const real constraints_multipliers_1330 = constraints_multipliers_1329
        + ball5_G_13 * constraints_multipliers_830 + ball5_G_14 * constraints_multipliers_834;
    const real constraints_multipliers_1331 = constraints_multipliers_1330
        + ball5_G_15 * constraints_multipliers_838;
    work[133] = constraints_multipliers_1331;
    work[203] = constraints_multipliers_1331;
    const real constraints_multipliers_1332 = ball5_G_10 * constraints_multipliers_849
        + ball5_G_11 * constraints_multipliers_853 + ball5_G_12 * constraints_multipliers_855;
    const real constraints_multipliers_1333 = constraints_multipliers_1332
        + ball5_G_13 * constraints_multipliers_858 + ball5_G_14 * constraints_multipliers_862;
    const real constraints_multipliers_1334 = constraints_multipliers_1333
        + ball5_G_15 * constraints_multipliers_866;
    work[148] = constraints_multipliers_1334;
    work[204] = constraints_multipliers_1334;
    const real constraints_multipliers_1335 = ball5_G_10 * constraints_multipliers_877
        + ball5_G_11 * constraints_multipliers_881 + ball5_G_12 * constraints_multipliers_883;
    const real constraints_multipliers_1336 = constraints_multipliers_1335
        + ball5_G_13 * constraints_multipliers_886 + ball5_G_14 * constraints_multipliers_890;
    const real constraints_multipliers_1337 = constraints_multipliers_1336
        + ball5_G_15 * constraints_multipliers_894;
    work[163] = constraints_multipliers_1337;
    work[205] = constraints_multipliers_1337;
    const real constraints_multipliers_1338 = ball5_G_10 * constraints_multipliers_905
        + ball5_G_11 * constraints_multipliers_909 + ball5_G_12 * constraints_multipliers_911;
    const real constraints_multipliers_1339 = constraints_multipliers_1338
        + ball5_G_13 * constraints_multipliers_914 + ball5_G_14 * constraints_multipliers_918;
    const real constraints_multipliers_1340 = constraints_multipliers_1339
        + ball5_G_15 * constraints_multipliers_922;
    work[178] = constraints_multipliers_1340;
    work[206] = constraints_multipliers_1340;
    const real constraints_multipliers_1341 = ball5_G_10 * constraints_multipliers_933
        + ball5_G_11 * constraints_multipliers_937 + ball5_G_12 * constraints_multipliers_939;
    const real constraints_multipliers_1342 = constraints_multipliers_1341
        + ball5_G_13 * constraints_multipliers_942 + ball5_G_14 * constraints_multipliers_946;
    const real ball5_G_16 = work[784];
    const real constraints_multipliers_1343 = constraints_multipliers_1342
        + ball5_G_15 * constraints_multipliers_950 + ball5_G_16 * constraints_multipliers_934;
    const real ball5_G_17 = work[785];
    const real ball5_G_18 = work[786];
    const real constraints_multipliers_1344 = constraints_multipliers_1343
        + ball5_G_17 * constraints_multipliers_935 + ball5_G_18 * constraints_multipliers_936;
    work[193] = constraints_multipliers_1344;
    work[207] = constraints_multipliers_1344;
    const real constraints_multipliers_961 = work[613];
    const real constraints_multipliers_965 = work[617];
    const real constraints_multipliers_967 = work[618];
    const real constraints_multipliers_1345 = ball5_G_10 * constraints_multipliers_961
        + ball5_G_11 * constraints_multipliers_965 + ball5_G_12 * constraints_multipliers_967;
    const real constraints_multipliers_970 = work[619];
    const real constraints_multipliers_974 = work[620];
    const real constraints_multipliers_1346 = constraints_multipliers_1345
        + ball5_G_13 * constraints_multipliers_970 + ball5_G_14 * constraints_multipliers_974;
    const real constraints_multipliers_978 = work[621];
    const real constraints_multipliers_962 = work[614];
    const real constraints_multipliers_1347 = constraints_multipliers_1346
        + ball5_G_15 * constraints_multipliers_978 + ball5_G_16 * constraints_multipliers_962;
    const real constraints_multipliers_963 = work[615];
    const real constraints_multipliers_964 = work[616];
    const real constraints_multipliers_1348 = constraints_multipliers_1347
        + ball5_G_17 * constraints_multipliers_963 + ball5_G_18 * constraints_multipliers_964;
    work[208] = constraints_multipliers_1348;
    const real ball5_G_19 = work[787];
    const real ball5_G_20 = work[788];
    const real ball5_G_21 = work[789];
    const real constraints_multipliers_1349 = ball5_G_19 * constraints_multipliers_597
        + ball5_G_20 * constraints_multipliers_601 + ball5_G_21 * constraints_multipliers_603;
    const real ball5_G_22 = work[790];
    const real ball5_G_23 = work[791];
    const real constraints_multipliers_1350 = constraints_multipliers_1349
        + ball5_G_22 * constraints_multipliers_606 + ball5_G_23 * constraints_multipliers_610;
    const real ball5_G_24 = work[792];
    const real constraints_multipliers_1351 = constraints_multipliers_1350
        + ball5_G_24 * constraints_multipliers_614;
    work[14] = constraints_multipliers_1351;
    work[210] = constraints_multipliers_1351;
    const real constraints_multipliers_1352 = ball5_G_19 * constraints_multipliers_625
        + ball5_G_20 * constraints_multipliers_629 + ball5_G_21 * constraints_multipliers_631;
    const real constraints_multipliers_1353 = constraints_multipliers_1352
        + ball5_G_22 * constraints_multipliers_634 + ball5_G_23 * constraints_multipliers_638;
    const real constraints_multipliers_1354 = constraints_multipliers_1353
        + ball5_G_24 * constraints_multipliers_642;
    work[29] = constraints_multipliers_1354;
    work[211] = constraints_multipliers_1354;
    const real constraints_multipliers_1355 = ball5_G_19 * constraints_multipliers_653
        + ball5_G_20 * constraints_multipliers_657 + ball5_G_21 * constraints_multipliers_659;
    const real constraints_multipliers_1356 = constraints_multipliers_1355
        + ball5_G_22 * constraints_multipliers_662 + ball5_G_23 * constraints_multipliers_666;
    const real constraints_multipliers_1357 = constraints_multipliers_1356
        + ball5_G_24 * constraints_multipliers_670;
    work[44] = constraints_multipliers_1357;
    work[212] = constraints_multipliers_1357;
    const real constraints_multipliers_1358 = ball5_G_19 * constraints_multipliers_681
        + ball5_G_20 * constraints_multipliers_685 + ball5_G_21 * constraints_multipliers_687;
    const real constraints_multipliers_1359 = constraints_multipliers_1358
        + ball5_G_22 * constraints_multipliers_690 + ball5_G_23 * constraints_multipliers_694;
    const real constraints_multipliers_1360 = constraints_multipliers_1359
        + ball5_G_24 * constraints_multipliers_698;
    work[59] = constraints_multipliers_1360;
    work[213] = constraints_multipliers_1360;
    const real constraints_multipliers_1361 = ball5_G_19 * constraints_multipliers_709
        + ball5_G_20 * constraints_multipliers_713 + ball5_G_21 * constraints_multipliers_715;
    const real constraints_multipliers_1362 = constraints_multipliers_1361
        + ball5_G_22 * constraints_multipliers_718 + ball5_G_23 * constraints_multipliers_722;
    const real constraints_multipliers_1363 = constraints_multipliers_1362
        + ball5_G_24 * constraints_multipliers_726;
    work[74] = constraints_multipliers_1363;
    work[214] = constraints_multipliers_1363;
    const real constraints_multipliers_1364 = ball5_G_19 * constraints_multipliers_737
        + ball5_G_20 * constraints_multipliers_741 + ball5_G_21 * constraints_multipliers_743;
    const real constraints_multipliers_1365 = constraints_multipliers_1364
        + ball5_G_22 * constraints_multipliers_746 + ball5_G_23 * constraints_multipliers_750;
    const real constraints_multipliers_1366 = constraints_multipliers_1365
        + ball5_G_24 * constraints_multipliers_754;
    work[89] = constraints_multipliers_1366;
    work[215] = constraints_multipliers_1366;
    const real constraints_multipliers_1367 = ball5_G_19 * constraints_multipliers_765
        + ball5_G_20 * constraints_multipliers_769 + ball5_G_21 * constraints_multipliers_771;
    const real constraints_multipliers_1368 = constraints_multipliers_1367
        + ball5_G_22 * constraints_multipliers_774 + ball5_G_23 * constraints_multipliers_778;
    const real constraints_multipliers_1369 = constraints_multipliers_1368
        + ball5_G_24 * constraints_multipliers_782;
    work[104] = constraints_multipliers_1369;
    work[216] = constraints_multipliers_1369;
    const real constraints_multipliers_1370 = ball5_G_19 * constraints_multipliers_793
        + ball5_G_20 * constraints_multipliers_797 + ball5_G_21 * constraints_multipliers_799;
    const real constraints_multipliers_1371 = constraints_multipliers_1370
        + ball5_G_22 * constraints_multipliers_802 + ball5_G_23 * constraints_multipliers_806;
    const real constraints_multipliers_1372 = constraints_multipliers_1371
        + ball5_G_24 * constraints_multipliers_810;
    work[119] = constraints_multipliers_1372;
    work[217] = constraints_multipliers_1372;
    const real constraints_multipliers_1373 = ball5_G_19 * constraints_multipliers_821
        + ball5_G_20 * constraints_multipliers_825 + ball5_G_21 * constraints_multipliers_827;
    const real constraints_multipliers_1374 = constraints_multipliers_1373
        + ball5_G_22 * constraints_multipliers_830 + ball5_G_23 * constraints_multipliers_834;
    const real constraints_multipliers_1375 = constraints_multipliers_1374
        + ball5_G_24 * constraints_multipliers_838;
    work[134] = constraints_multipliers_1375;
    work[218] = constraints_multipliers_1375;
    const real constraints_multipliers_1376 = ball5_G_19 * constraints_multipliers_849
        + ball5_G_20 * constraints_multipliers_853 + ball5_G_21 * constraints_multipliers_855;
    const real constraints_multipliers_1377 = constraints_multipliers_1376
        + ball5_G_22 * constraints_multipliers_858 + ball5_G_23 * constraints_multipliers_862;
    const real constraints_multipliers_1378 = constraints_multipliers_1377
        + ball5_G_24 * constraints_multipliers_866;
    work[149] = constraints_multipliers_1378;
    work[219] = constraints_multipliers_1378;
    const real constraints_multipliers_1379 = ball5_G_19 * constraints_multipliers_877
        + ball5_G_20 * constraints_multipliers_881 + ball5_G_21 * constraints_multipliers_883;
    const real constraints_multipliers_1380 = constraints_multipliers_1379
        + ball5_G_22 * constraints_multipliers_886 + ball5_G_23 * constraints_multipliers_890;
    const real constraints_multipliers_1381 = constraints_multipliers_1380
        + ball5_G_24 * constraints_multipliers_894;
    work[164] = constraints_multipliers_1381;
    work[220] = constraints_multipliers_1381;
    const real constraints_multipliers_1382 = ball5_G_19 * constraints_multipliers_905
        + ball5_G_20 * constraints_multipliers_909 + ball5_G_21 * constraints_multipliers_911;
    const real constraints_multipliers_1383 = constraints_multipliers_1382
        + ball5_G_22 * constraints_multipliers_914 + ball5_G_23 * constraints_multipliers_918;
    const real constraints_multipliers_1384 = constraints_multipliers_1383
        + ball5_G_24 * constraints_multipliers_922;
    work[179] = constraints_multipliers_1384;
    work[221] = constraints_multipliers_1384;
    const real constraints_multipliers_1385 = ball5_G_19 * constraints_multipliers_933
        + ball5_G_20 * constraints_multipliers_937 + ball5_G_21 * constraints_multipliers_939;
    const real constraints_multipliers_1386 = constraints_multipliers_1385
        + ball5_G_22 * constraints_multipliers_942 + ball5_G_23 * constraints_multipliers_946;
    const real ball5_G_25 = work[793];
    const real constraints_multipliers_1387 = constraints_multipliers_1386
        + ball5_G_24 * constraints_multipliers_950 + ball5_G_25 * constraints_multipliers_934;
    const real ball5_G_26 = work[794];
    const real ball5_G_27 = work[795];
    const real constraints_multipliers_1388 = constraints_multipliers_1387
        + ball5_G_26 * constraints_multipliers_935 + ball5_G_27 * constraints_multipliers_936;
    work[194] = constraints_multipliers_1388;
    work[222] = constraints_multipliers_1388;
    const real constraints_multipliers_1389 = ball5_G_19 * constraints_multipliers_961
        + ball5_G_20 * constraints_multipliers_965 + ball5_G_21 * constraints_multipliers_967;
    const real constraints_multipliers_1390 = constraints_multipliers_1389
        + ball5_G_22 * constraints_multipliers_970 + ball5_G_23 * constraints_multipliers_974;
    const real constraints_multipliers_1391 = constraints_multipliers_1390
        + ball5_G_24 * constraints_multipliers_978 + ball5_G_25 * constraints_multipliers_962;
    const real constraints_multipliers_1392 = constraints_multipliers_1391
        + ball5_G_26 * constraints_multipliers_963 + ball5_G_27 * constraints_multipliers_964;
    work[209] = constraints_multipliers_1392;
    work[223] = constraints_multipliers_1392;
    const real constraints_multipliers_989 = work[622];
    const real constraints_multipliers_993 = work[626];
    const real constraints_multipliers_995 = work[627];
    const real constraints_multipliers_1393 = ball5_G_19 * constraints_multipliers_989
        + ball5_G_20 * constraints_multipliers_993 + ball5_G_21 * constraints_multipliers_995;
    const real constraints_multipliers_1394 = constraints_multipliers_1393
        + ball5_G_22 * constraints_multipliers_998 + ball5_G_23 * constraints_multipliers_1002;
    const real constraints_multipliers_990 = work[623];
    const real constraints_multipliers_1395 = constraints_multipliers_1394
        + ball5_G_24 * constraints_multipliers_1006 + ball5_G_25 * constraints_multipliers_990;
    const real constraints_multipliers_991 = work[624];
    const real constraints_multipliers_992 = work[625];
    const real constraints_multipliers_1396 = constraints_multipliers_1395
        + ball5_G_26 * constraints_multipliers_991 + ball5_G_27 * constraints_multipliers_992;
    work[224] = constraints_multipliers_1396;
    const real constraints_multipliers_557 = work[393];
    const real constraints_multipliers_573 = work[409];
    const real constraints_multipliers_575 = work[410];
    const real constraints_multipliers_1397 = ball1_G * constraints_multipliers_557
        + ball1_G_2 * constraints_multipliers_573 + ball1_G_3 * constraints_multipliers_575;
    const real constraints_multipliers_578 = work[411];
    const real constraints_multipliers_582 = work[412];
    const real constraints_multipliers_1398 = constraints_multipliers_1397
        + ball1_G_4 * constraints_multipliers_578 + ball1_G_5 * constraints_multipliers_582;
    const real constraints_multipliers_586 = work[413];
    const real constraints_multipliers_558 = work[394];
    const real constraints_multipliers_1399 = constraints_multipliers_1398
        + ball1_G_6 * constraints_multipliers_586 - ball1_G_7 * constraints_multipliers_558;
    const real constraints_multipliers_559 = work[395];
    const real constraints_multipliers_560 = work[396];
    const real constraints_multipliers_1400 = constraints_multipliers_1399
        + ball1_G_8 * constraints_multipliers_559 - ball1_G_9 * constraints_multipliers_560;
    const real constraints_multipliers_1401 = ball1_G_10 * constraints_multipliers_557
        + ball1_G_11 * constraints_multipliers_573 + ball1_G_12 * constraints_multipliers_575;
    const real constraints_multipliers_1402 = constraints_multipliers_1401
        + ball1_G_13 * constraints_multipliers_578 + ball1_G_14 * constraints_multipliers_582;
    const real constraints_multipliers_1403 = constraints_multipliers_1402
        + ball1_G_15 * constraints_multipliers_586 - ball1_G_16 * constraints_multipliers_558;
    const real constraints_multipliers_1404 = constraints_multipliers_1403
        + ball1_G_17 * constraints_multipliers_559 - ball1_G_18 * constraints_multipliers_560;
    const real constraints_multipliers_1405 = ball1_G_19 * constraints_multipliers_557
        + ball1_G_20 * constraints_multipliers_573 + ball1_G_21 * constraints_multipliers_575;
    const real constraints_multipliers_1406 = constraints_multipliers_1405
        + ball1_G_22 * constraints_multipliers_578 + ball1_G_23 * constraints_multipliers_582;
    const real constraints_multipliers_1407 = constraints_multipliers_1406
        + ball1_G_24 * constraints_multipliers_586 - ball1_G_25 * constraints_multipliers_558;
    const real constraints_multipliers_1408 = constraints_multipliers_1407
        + ball1_G_26 * constraints_multipliers_559 - ball1_G_27 * constraints_multipliers_560;
    const real constraints_multipliers_1409 = ball2_G * constraints_multipliers_557
        + ball2_G_2 * constraints_multipliers_573 + ball2_G_3 * constraints_multipliers_575;
    const real constraints_multipliers_1410 = constraints_multipliers_1409
        + ball2_G_4 * constraints_multipliers_578 + ball2_G_5 * constraints_multipliers_582;
    const real constraints_multipliers_561 = work[397];
    const real constraints_multipliers_1411 = constraints_multipliers_1410
        + ball2_G_6 * constraints_multipliers_586 - ball2_G_7 * constraints_multipliers_561;
    const real constraints_multipliers_562 = work[398];
    const real constraints_multipliers_563 = work[399];
    const real constraints_multipliers_1412 = constraints_multipliers_1411
        + ball2_G_8 * constraints_multipliers_562 - ball2_G_9 * constraints_multipliers_563;
    const real constraints_multipliers_1413 = ball2_G_10 * constraints_multipliers_557
        + ball2_G_11 * constraints_multipliers_573 + ball2_G_12 * constraints_multipliers_575;
    const real constraints_multipliers_1414 = constraints_multipliers_1413
        + ball2_G_13 * constraints_multipliers_578 + ball2_G_14 * constraints_multipliers_582;
    const real constraints_multipliers_1415 = constraints_multipliers_1414
        + ball2_G_15 * constraints_multipliers_586 - ball2_G_16 * constraints_multipliers_561;
    const real constraints_multipliers_1416 = constraints_multipliers_1415
        + ball2_G_17 * constraints_multipliers_562 - ball2_G_18 * constraints_multipliers_563;
    const real constraints_multipliers_1417 = ball2_G_19 * constraints_multipliers_557
        + ball2_G_20 * constraints_multipliers_573 + ball2_G_21 * constraints_multipliers_575;
    const real constraints_multipliers_1418 = constraints_multipliers_1417
        + ball2_G_22 * constraints_multipliers_578 + ball2_G_23 * constraints_multipliers_582;
    const real constraints_multipliers_1419 = constraints_multipliers_1418
        + ball2_G_24 * constraints_multipliers_586 - ball2_G_25 * constraints_multipliers_561;
    const real constraints_multipliers_1420 = constraints_multipliers_1419
        + ball2_G_26 * constraints_multipliers_562 - ball2_G_27 * constraints_multipliers_563;
    const real constraints_multipliers_1421 = ball3_G * constraints_multipliers_557
        + ball3_G_2 * constraints_multipliers_573 + ball3_G_3 * constraints_multipliers_575;
    const real constraints_multipliers_1422 = constraints_multipliers_1421
        + ball3_G_4 * constraints_multipliers_578 + ball3_G_5 * constraints_multipliers_582;
    const real constraints_multipliers_564 = work[400];
    const real constraints_multipliers_1423 = constraints_multipliers_1422
        + ball3_G_6 * constraints_multipliers_586 - ball3_G_7 * constraints_multipliers_564;
    const real constraints_multipliers_565 = work[401];
    const real constraints_multipliers_566 = work[402];
    const real constraints_multipliers_1424 = constraints_multipliers_1423
        + ball3_G_8 * constraints_multipliers_565 - ball3_G_9 * constraints_multipliers_566;
    const real constraints_multipliers_1425 = ball3_G_10 * constraints_multipliers_557
        + ball3_G_11 * constraints_multipliers_573 + ball3_G_12 * constraints_multipliers_575;
    const real constraints_multipliers_1426 = constraints_multipliers_1425
        + ball3_G_13 * constraints_multipliers_578 + ball3_G_14 * constraints_multipliers_582;
    const real constraints_multipliers_1427 = constraints_multipliers_1426
        + ball3_G_15 * constraints_multipliers_586 - ball3_G_16 * constraints_multipliers_564;
    const real constraints_multipliers_1428 = constraints_multipliers_1427
        + ball3_G_17 * constraints_multipliers_565 - ball3_G_18 * constraints_multipliers_566;
    const real constraints_multipliers_1429 = ball3_G_19 * constraints_multipliers_557
        + ball3_G_20 * constraints_multipliers_573 + ball3_G_21 * constraints_multipliers_575;
    const real constraints_multipliers_1430 = constraints_multipliers_1429
        + ball3_G_22 * constraints_multipliers_578 + ball3_G_23 * constraints_multipliers_582;
    const real constraints_multipliers_1431 = constraints_multipliers_1430
        + ball3_G_24 * constraints_multipliers_586 - ball3_G_25 * constraints_multipliers_564;
    const real constraints_multipliers_1432 = constraints_multipliers_1431
        + ball3_G_26 * constraints_multipliers_565 - ball3_G_27 * constraints_multipliers_566;
    const real constraints_multipliers_1433 = ball4_G * constraints_multipliers_557
        + ball4_G_2 * constraints_multipliers_573 + ball4_G_3 * constraints_multipliers_575;
    const real constraints_multipliers_1434 = constraints_multipliers_1433
        + ball4_G_4 * constraints_multipliers_578 + ball4_G_5 * constraints_multipliers_582;
    const real constraints_multipliers_567 = work[403];
    const real constraints_multipliers_1435 = constraints_multipliers_1434
        + ball4_G_6 * constraints_multipliers_586 - ball4_G_7 * constraints_multipliers_567;
    const real constraints_multipliers_568 = work[404];
    const real constraints_multipliers_569 = work[405];
    const real constraints_multipliers_1436 = constraints_multipliers_1435
        + ball4_G_8 * constraints_multipliers_568 - ball4_G_9 * constraints_multipliers_569;
    const real constraints_multipliers_1437 = ball4_G_10 * constraints_multipliers_557
        + ball4_G_11 * constraints_multipliers_573 + ball4_G_12 * constraints_multipliers_575;
    const real constraints_multipliers_1438 = constraints_multipliers_1437
        + ball4_G_13 * constraints_multipliers_578 + ball4_G_14 * constraints_multipliers_582;
    const real constraints_multipliers_1439 = constraints_multipliers_1438
        + ball4_G_15 * constraints_multipliers_586 - ball4_G_16 * constraints_multipliers_567;
    const real constraints_multipliers_1440 = constraints_multipliers_1439
        + ball4_G_17 * constraints_multipliers_568 - ball4_G_18 * constraints_multipliers_569;
    const real constraints_multipliers_1441 = ball4_G_19 * constraints_multipliers_557
        + ball4_G_20 * constraints_multipliers_573 + ball4_G_21 * constraints_multipliers_575;
    const real constraints_multipliers_1442 = constraints_multipliers_1441
        + ball4_G_22 * constraints_multipliers_578 + ball4_G_23 * constraints_multipliers_582;
    const real constraints_multipliers_1443 = constraints_multipliers_1442
        + ball4_G_24 * constraints_multipliers_586 - ball4_G_25 * constraints_multipliers_567;
    const real constraints_multipliers_1444 = constraints_multipliers_1443
        + ball4_G_26 * constraints_multipliers_568 - ball4_G_27 * constraints_multipliers_569;
    const real constraints_multipliers_1445 = ball5_G * constraints_multipliers_557
        + ball5_G_2 * constraints_multipliers_573 + ball5_G_3 * constraints_multipliers_575;
    const real constraints_multipliers_1446 = constraints_multipliers_1445
        + ball5_G_4 * constraints_multipliers_578 + ball5_G_5 * constraints_multipliers_582;
    const real constraints_multipliers_570 = work[406];
    const real constraints_multipliers_1447 = constraints_multipliers_1446
        + ball5_G_6 * constraints_multipliers_586 - ball5_G_7 * constraints_multipliers_570;
    const real constraints_multipliers_571 = work[407];
    const real constraints_multipliers_572 = work[408];
    const real constraints_multipliers_1448 = constraints_multipliers_1447
        + ball5_G_8 * constraints_multipliers_571 - ball5_G_9 * constraints_multipliers_572;
    const real constraints_multipliers_1449 = ball5_G_10 * constraints_multipliers_557
        + ball5_G_11 * constraints_multipliers_573 + ball5_G_12 * constraints_multipliers_575;
    const real constraints_multipliers_1450 = constraints_multipliers_1449
        + ball5_G_13 * constraints_multipliers_578 + ball5_G_14 * constraints_multipliers_582;
    const real constraints_multipliers_1451 = constraints_multipliers_1450
        + ball5_G_15 * constraints_multipliers_586 - ball5_G_16 * constraints_multipliers_570;
    const real constraints_multipliers_1452 = constraints_multipliers_1451
        + ball5_G_17 * constraints_multipliers_571 - ball5_G_18 * constraints_multipliers_572;
    const real constraints_multipliers_1453 = ball5_G_19 * constraints_multipliers_557
        + ball5_G_20 * constraints_multipliers_573 + ball5_G_21 * constraints_multipliers_575;
    const real constraints_multipliers_1454 = constraints_multipliers_1453
        + ball5_G_22 * constraints_multipliers_578 + ball5_G_23 * constraints_multipliers_582;
    const real constraints_multipliers_1455 = constraints_multipliers_1454
        + ball5_G_24 * constraints_multipliers_586 - ball5_G_25 * constraints_multipliers_570;
    const real constraints_multipliers_1456 = constraints_multipliers_1455
        + ball5_G_26 * constraints_multipliers_571 - ball5_G_27 * constraints_multipliers_572;
    const real constraints_multipliers_483 = work[461];
    const real constraints_multipliers_1457 = -(constraints_multipliers_483
        + constraints_multipliers_1400);
    work[225] = constraints_multipliers_1457;
    const real constraints_multipliers_486 = work[462];
    const real constraints_multipliers_1458 = -(constraints_multipliers_486
        + constraints_multipliers_1404);
    work[226] = constraints_multipliers_1458;
    const real constraints_multipliers_489 = work[463];
    const real constraints_multipliers_1459 = -(constraints_multipliers_489
        + constraints_multipliers_1408);
    work[227] = constraints_multipliers_1459;
    const real constraints_multipliers_492 = work[464];
    const real constraints_multipliers_1460 = -(constraints_multipliers_492
        + constraints_multipliers_1412);
    work[228] = constraints_multipliers_1460;
    const real constraints_multipliers_495 = work[465];
    const real constraints_multipliers_1461 = -(constraints_multipliers_495
        + constraints_multipliers_1416);
    work[229] = constraints_multipliers_1461;
    const real constraints_multipliers_498 = work[466];
    const real constraints_multipliers_1462 = -(constraints_multipliers_498
        + constraints_multipliers_1420);
    work[230] = constraints_multipliers_1462;
    const real constraints_multipliers_501 = work[467];
    const real constraints_multipliers_1463 = -(constraints_multipliers_501
        + constraints_multipliers_1424);
    work[231] = constraints_multipliers_1463;
    const real constraints_multipliers_504 = work[472];
    const real constraints_multipliers_1464 = -(constraints_multipliers_504
        + constraints_multipliers_1428);
    work[232] = constraints_multipliers_1464;
    const real constraints_multipliers_507 = work[473];
    const real constraints_multipliers_1465 = -(constraints_multipliers_507
        + constraints_multipliers_1432);
    work[233] = constraints_multipliers_1465;
    const real constraints_multipliers_510 = work[520];
    const real constraints_multipliers_1466 = -(constraints_multipliers_510
        + constraints_multipliers_1436);
    work[234] = constraints_multipliers_1466;
    const real constraints_multipliers_513 = work[521];
    const real constraints_multipliers_1467 = -(constraints_multipliers_513
        + constraints_multipliers_1440);
    work[235] = constraints_multipliers_1467;
    const real constraints_multipliers_516 = work[522];
    const real constraints_multipliers_1468 = -(constraints_multipliers_516
        + constraints_multipliers_1444);
    work[236] = constraints_multipliers_1468;
    const real constraints_multipliers_519 = work[390];
    const real constraints_multipliers_1469 = -(constraints_multipliers_519
        + constraints_multipliers_1448);
    work[237] = constraints_multipliers_1469;
    const real constraints_multipliers_522 = work[391];
    const real constraints_multipliers_1470 = -(constraints_multipliers_522
        + constraints_multipliers_1452);
    work[238] = constraints_multipliers_1470;
    const real constraints_multipliers_525 = work[392];
    const real constraints_multipliers_1471 = -(constraints_multipliers_525
        + constraints_multipliers_1456);
    work[239] = constraints_multipliers_1471;
    status |= CARDAN_SOLVE(semidefinite, 15, 1, work + 0, work + 225, work + 240);

    /* ball1: multiplier px, multiplier py, multiplier pz */
    const real ball1_multiplier_px = work[225];
    work[429] = ball1_multiplier_px;
    const real ball1_multiplier_py = work[226];
    work[430] = ball1_multiplier_py;
    const real ball1_multiplier_pz = work[227];
    work[444] = ball1_multiplier_pz;

    /* ball2: multiplier px, multiplier py, multiplier pz */
    const real ball2_multiplier_px = work[228];
    work[445] = ball2_multiplier_px;
    const real ball2_multiplier_py = work[229];
    work[446] = ball2_multiplier_py;
    const real ball2_multiplier_pz = work[230];
    work[447] = ball2_multiplier_pz;

    /* ball3: multiplier px, multiplier py, multiplier pz */
    const real ball3_multiplier_px = work[231];
    work[448] = ball3_multiplier_px;
    const real ball3_multiplier_py = work[232];
    work[449] = ball3_multiplier_py;
    const real ball3_multiplier_pz = work[233];
    work[456] = ball3_multiplier_pz;

    /* ball4: multiplier px, multiplier py, multiplier pz */
    const real ball4_multiplier_px = work[234];
    work[457] = ball4_multiplier_px;
    const real ball4_multiplier_py = work[235];
    work[458] = ball4_multiplier_py;
    const real ball4_multiplier_pz = work[236];
    work[459] = ball4_multiplier_pz;

    /* ball5: multiplier px, multiplier py, multiplier pz */
    const real ball5_multiplier_px = work[237];
    work[460] = ball5_multiplier_px;
    const real ball5_multiplier_py = work[238];
    work[535] = ball5_multiplier_py;
    const real ball5_multiplier_pz = work[239];
    work[603] = ball5_multiplier_pz;
    return status;
}

CARDAN_PART int forward_dynamics_part6(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    (void)in;

    /* constraints: multipliers */
    const real constraints_multipliers_597 = work[414];
    const real ball1_multiplier_px = work[429];
    const real constraints_multipliers_625 = work[424];
    const real ball1_multiplier_py = work[430];
    const real constraints_multipliers_1472 = constraints_multipliers_597 * ball1_multiplier_px
        + constraints_multipliers_625 * ball1_multiplier_py;
    const real constraints_multipliers_653 = work[435];
    const real ball1_multiplier_pz = work[444];
    const real constraints_multipliers_1473 = constraints_multipliers_1472
        + constraints_multipliers_653 * ball1_multiplier_pz;
    const real constraints_multipliers_681 = work[450];
    const real ball2_multiplier_px = work[445];
    const real constraints_multipliers_1474 = constraints_multipliers_1473
        + constraints_multipliers_681 * ball2_multiplier_px;
    const real constraints_multipliers_709 = work[471];
    const real ball2_multiplier_py = work[446];
    const real constraints_multipliers_1475 = constraints_multipliers_1474
        + constraints_multipliers_709 * ball2_multiplier_py;
    const real constraints_multipliers_737 = work[482];
    const real ball2_multiplier_pz = work[447];
    const real constraints_multipliers_1476 = constraints_multipliers_1475
        + constraints_multipliers_737 * ball2_multiplier_pz;
    const real constraints_multipliers_765 = work[518];
    const real ball3_multiplier_px = work[448];
    const real constraints_multipliers_1477 = constraints_multipliers_1476
        + constraints_multipliers_765 * ball3_multiplier_px;
    const real constraints_multipliers_793 = work[530];
    const real ball3_multiplier_py = work[449];
    const real constraints_multipliers_1478 = constraints_multipliers_1477
        + constraints_multipliers_793 * ball3_multiplier_py;
    const real constraints_multipliers_821 = work[540];
    const real ball3_multiplier_pz = work[456];
    const real constraints_multipliers_1479 = constraints_multipliers_1478
        + constraints_multipliers_821 * ball3_multiplier_pz;
    const real constraints_multipliers_849 = work[549];
    const real ball4_multiplier_px = work[457];
    const real constraints_multipliers_1480 = constraints_multipliers_1479
        + constraints_multipliers_849 * ball4_multiplier_px;
    const real constraints_multipliers_877 = work[558];
    const real ball4_multiplier_py = work[458];
    const real constraints_multipliers_1481 = constraints_multipliers_1480
        + constraints_multipliers_877 * ball4_multiplier_py;
    const real constraints_multipliers_905 = work[567];
    const real ball4_multiplier_pz = work[459];
    const real constraints_multipliers_1482 = constraints_multipliers_1481
        + constraints_multipliers_905 * ball4_multiplier_pz;
    const real constraints_multipliers_933 = work[604];
    const real ball5_multiplier_px = work[460];
    const real constraints_multipliers_1483 = constraints_multipliers_1482
        + constraints_multipliers_933 * ball5_multiplier_px;
    const real constraints_multipliers_961 = work[613];
    const real ball5_multiplier_py = work[535];
    const real constraints_multipliers_1484 = constraints_multipliers_1483
        + constraints_multipliers_961 * ball5_multiplier_py;
    const real constraints_multipliers_601 = work[419];
    const real constraints_multipliers_629 = work[428];
    const real constraints_multipliers_1485 = constraints_multipliers_601 * ball1_multiplier_px
        + constraints_multipliers_629 * ball1_multiplier_py;
    const real constraints_multipliers_657 = work[439];
    const real constraints_multipliers_1486 = constraints_multipliers_1485
        + constraints_multipliers_657 * ball1_multiplier_pz;
    const real constraints_multipliers_685 = work[454];
    const real constraints_multipliers_1487 = constraints_multipliers_1486
        + constraints_multipliers_685 * ball2_multiplier_px;
    const real constraints_multipliers_713 = work[477];
    const real constraints_multipliers_1488 = constraints_multipliers_1487
        + constraints_multipliers_713 * ball2_multiplier_py;
    const real constraints_multipliers_741 = work[486];
    const real constraints_multipliers_1489 = constraints_multipliers_1488
        + constraints_multipliers_741 * ball2_multiplier_pz;
    const real constraints_multipliers_769 = work[525];
    const real constraints_multipliers_1490 = constraints_multipliers_1489
        + constraints_multipliers_769 * ball3_multiplier_px;
    const real constraints_multipliers_797 = work[534];
    const real constraints_multipliers_1491 = constraints_multipliers_1490
        + constraints_multipliers_797 * ball3_multiplier_py;
    const real constraints_multipliers_825 = work[544];
    const real constraints_multipliers_1492 = constraints_multipliers_1491
        + constraints_multipliers_825 * ball3_multiplier_pz;
    const real constraints_multipliers_853 = work[553];
    const real constraints_multipliers_1493 = constraints_multipliers_1492
        + constraints_multipliers_853 * ball4_multiplier_px;
    const real constraints_multipliers_881 = work[562];
    const real constraints_multipliers_1494 = constraints_multipliers_1493
        + constraints_multipliers_881 * ball4_multiplier_py;
    const real constraints_multipliers_909 = work[571];
    const real constraints_multipliers_1495 = constraints_multipliers_1494
        + constraints_multipliers_909 * ball4_multiplier_pz;
    const real constraints_multipliers_937 = work[608];
    const real constraints_multipliers_1496 = constraints_multipliers_1495
        + constraints_multipliers_937 * ball5_multiplier_px;
    const real constraints_multipliers_965 = work[617];
    const real constraints_multipliers_1497 = constraints_multipliers_1496
        + constraints_multipliers_965 * ball5_multiplier_py;
    const real constraints_multipliers_603 = work[420];
    const real constraints_multipliers_631 = work[431];
    const real constraints_multipliers_1498 = constraints_multipliers_603 * ball1_multiplier_px
        + constraints_multipliers_631 * ball1_multiplier_py;
    const real constraints_multipliers_659 = work[440];
    const real constraints_multipliers_1499 = constraints_multipliers_1498
        + constraints_multipliers_659 * ball1_multiplier_pz;
    const real constraints_multipliers_687 = work[455];
    const real constraints_multipliers_1500 = constraints_multipliers_1499
        + constraints_multipliers_687 * ball2_multiplier_px;
    const real constraints_multipliers_715 = work[478];
    const real constraints_multipliers_1501 = constraints_multipliers_1500
        + constraints_multipliers_715 * ball2_multiplier_py;
    const real constraints_multipliers_743 = work[487];
    const real constraints_multipliers_1502 = constraints_multipliers_1501
        + constraints_multipliers_743 * ball2_multiplier_pz;
    const real constraints_multipliers_771 = work[526];
    const real constraints_multipliers_1503 = constraints_multipliers_1502
        + constraints_multipliers_771 * ball3_multiplier_px;
    const real constraints_multipliers_799 = work[536];
    const real constraints_multipliers_1504 = constraints_multipliers_1503
        + constraints_multipliers_799 * ball3_multiplier_py;
    const real constraints_multipliers_827 = work[545];
    const real constraints_multipliers_1505 = constraints_multipliers_1504
        + constraints_multipliers_827 * ball3_multiplier_pz;
    const real constraints_multipliers_855 = work[554];
    const real constraints_multipliers_1506 = constraints_multipliers_1505
        + constraints_multipliers_855 * ball4_multiplier_px;
    const real constraints_multipliers_883 = work[563];
    const real constraints_multipliers_1507 = constraints_multipliers_1506
        + constraints_multipliers_883 * ball4_multiplier_py;
    const real constraints_multipliers_911 = work[599];
    const real constraints_multipliers_1508 = constraints_multipliers_1507
        + constraints_multipliers_911 * ball4_multiplier_pz;
    const real constraints_multipliers_939 = work[609];
    const real constraints_multipliers_1509 = constraints_multipliers_1508
        + constraints_multipliers_939 * ball5_multiplier_px;
    const real constraints_multipliers_967 = work[618];
    const real constraints_multipliers_1510 = constraints_multipliers_1509
        + constraints_multipliers_967 * ball5_multiplier_py;
    const real constraints_multipliers_606 = work[421];
    const real constraints_multipliers_634 = work[432];
    const real constraints_multipliers_1511 = constraints_multipliers_606 * ball1_multiplier_px
        + constraints_multipliers_634 * ball1_multiplier_py;
    const real constraints_multipliers_662 = work[441];
    const real constraints_multipliers_1512 = constraints_multipliers_1511
        + constraints_multipliers_662 * ball1_multiplier_pz;
    const real constraints_multipliers_690 = work[468];
    const real constraints_multipliers_1513 = constraints_multipliers_1512
        + constraints_multipliers_690 * ball2_multiplier_px;
    const real constraints_multipliers_718 = work[479];
    const real constraints_multipliers_1514 = constraints_multipliers_1513
        + constraints_multipliers_718 * ball2_multiplier_py;
    const real constraints_multipliers_746 = work[488];
    const real constraints_multipliers_1515 = constraints_multipliers_1514
        + constraints_multipliers_746 * ball2_multiplier_pz;
    const real constraints_multipliers_774 = work[527];
    const real constraints_multipliers_1516 = constraints_multipliers_1515
        + constraints_multipliers_774 * ball3_multiplier_px;
    const real constraints_multipliers_802 = work[537];
    const real constraints_multipliers_1517 = constraints_multipliers_1516
        + constraints_multipliers_802 * ball3_multiplier_py;
    const real constraints_multipliers_830 = work[546];
    const real constraints_multipliers_1518 = constraints_multipliers_1517
        + constraints_multipliers_830 * ball3_multiplier_pz;
    const real constraints_multipliers_858 = work[555];
    const real constraints_multipliers_1519 = constraints_multipliers_1518
        + constraints_multipliers_858 * ball4_multiplier_px;
    const real constraints_multipliers_886 = work[564];
    const real constraints_multipliers_1520 = constraints_multipliers_1519
        + constraints_multipliers_886 * ball4_multiplier_py;
    const real constraints_multipliers_914 = work[600];
    const real constraints_multipliers_1521 = constraints_multipliers_1520
        + constraints_multipliers_914 * ball4_multiplier_pz;
    const real constraints_multipliers_942 = work[610];
    const real constraints_multipliers_1522 = constraints_multipliers_1521
        + constraints_multipliers_942 * ball5_multiplier_px;
    const real constraints_multipliers_970 = work[619];
    const real constraints_multipliers_1523 = constraints_multipliers_1522
        + constraints_multipliers_970 * ball5_multiplier_py;
    const real constraints_multipliers_610 = work[422];
    const real constraints_multipliers_638 = work[433];
    const real constraints_multipliers_1524 = constraints_multipliers_610 * ball1_multiplier_px
        + constraints_multipliers_638 * ball1_multiplier_py;
    const real constraints_multipliers_666 = work[442];
    const real constraints_multipliers_1525 = constraints_multipliers_1524
        + constraints_multipliers_666 * ball1_multiplier_pz;
    const real constraints_multipliers_694 = work[469];
    const real constraints_multipliers_1526 = constraints_multipliers_1525
        + constraints_multipliers_694 * ball2_multiplier_px;
    const real constraints_multipliers_722 = work[480];
    const real constraints_multipliers_1527 = constraints_multipliers_1526
        + constraints_multipliers_722 * ball2_multiplier_py;
    const real constraints_multipliers_750 = work[489];
    const real constraints_multipliers_1528 = constraints_multipliers_1527
        + constraints_multipliers_750 * ball2_multiplier_pz;
    const real constraints_multipliers_778 = work[528];
    const real constraints_multipliers_1529 = constraints_multipliers_1528
        + constraints_multipliers_778 * ball3_multiplier_px;
    const real constraints_multipliers_806 = work[538];
    const real constraints_multipliers_1530 = constraints_multipliers_1529
        + constraints_multipliers_806 * ball3_multiplier_py;
    const real constraints_multipliers_834 = work[547];
    const real constraints_multipliers_1531 = constraints_multipliers_1530
        + constraints_multipliers_834 * ball3_multiplier_pz;
    const real constraints_multipliers_862 = work[556];
    const real constraints_multipliers_1532 = constraints_multipliers_1531
        + constraints_multipliers_862 * ball4_multiplier_px;
    const real constraints_multipliers_890 = work[565];
    const real constraints_multipliers_1533 = constraints_multipliers_1532
        + constraints_multipliers_890 * ball4_multiplier_py;
    const real constraints_multipliers_918 = work[601];
    const real constraints_multipliers_1534 = constraints_multipliers_1533
        + constraints_multipliers_918 * ball4_multiplier_pz;
    const real constraints_multipliers_946 = work[611];
    const real constraints_multipliers_1535 = constraints_multipliers_1534
        + constraints_multipliers_946 * ball5_multiplier_px;
    const real constraints_multipliers_974 = work[620];
    const real constraints_multipliers_1536 = constraints_multipliers_1535
        + constraints_multipliers_974 * ball5_multiplier_py;
    const real constraints_multipliers_614 = work[423];
    const real constraints_multipliers_642 = work[434];
    const real constraints_multipliers_1537 = constraints_multipliers_614 * ball1_multiplier_px
        + constraints_multipliers_642 * ball1_multiplier_py;
    const real constraints_multipliers_670 = work[443];
    const real constraints_multipliers_1538 = constraints_multipliers_1537
        + constraints_multipliers_670 * ball1_multiplier_pz;
    const real constraints_multipliers_698 = work[470];
    const real constraints_multipliers_1539 = constraints_multipliers_1538
        + constraints_multipliers_698 * ball2_multiplier_px;
    const real constraints_multipliers_726 = work[481];
    const real constraints_multipliers_1540 = constraints_multipliers_1539
        + constraints_multipliers_726 * ball2_multiplier_py;
    const real constraints_multipliers_754 = work[490];
    const real constraints_multipliers_1541 = constraints_multipliers_1540
        + constraints_multipliers_754 * ball2_multiplier_pz;
    const real constraints_multipliers_782 = work[529];
    const real constraints_multipliers_1542 = constraints_multipliers_1541
        + constraints_multipliers_782 * ball3_multiplier_px;
    const real constraints_multipliers_810 = work[539];
    const real constraints_multipliers_1543 = constraints_multipliers_1542
        + constraints_multipliers_810 * ball3_multiplier_py;
    const real constraints_multipliers_838 = work[548];
    const real constraints_multipliers_1544 = constraints_multipliers_1543
        + constraints_multipliers_838 * ball3_multiplier_pz;
    const real constraints_multipliers_866 = work[557];
    const real constraints_multipliers_1545 = constraints_multipliers_1544
        + constraints_multipliers_866 * ball4_multiplier_px;
    const real constraints_multipliers_894 = work[566];
    const real constraints_multipliers_1546 = constraints_multipliers_1545
        + constraints_multipliers_894 * ball4_multiplier_py;
    const real constraints_multipliers_922 = work[602];
    const real constraints_multipliers_1547 = constraints_multipliers_1546
        + constraints_multipliers_922 * ball4_multiplier_pz;
    const real constraints_multipliers_950 = work[612];
    const real constraints_multipliers_1548 = constraints_multipliers_1547
        + constraints_multipliers_950 * ball5_multiplier_px;
    const real constraints_multipliers_978 = work[621];
    const real constraints_multipliers_1549 = constraints_multipliers_1548
        + constraints_multipliers_978 * ball5_multiplier_py;
    const real constraints_multipliers_598 = work[415];
    const real constraints_multipliers_626 = work[425];
    const real constraints_multipliers_1550 = constraints_multipliers_598 * ball1_multiplier_px
        + constraints_multipliers_626 * ball1_multiplier_py;
    const real constraints_multipliers_599 = work[416];
    const real constraints_multipliers_627 = work[426];
    const real constraints_multipliers_1551 = constraints_multipliers_599 * ball1_multiplier_px
        + constraints_multipliers_627 * ball1_multiplier_py;
    const real constraints_multipliers_600 = work[417];
    const real constraints_multipliers_628 = work[427];
    const real constraints_multipliers_1552 = constraints_multipliers_600 * ball1_multiplier_px
        + constraints_multipliers_628 * ball1_multiplier_py;
    const real constraints_multipliers_682 = work[451];
    const real constraints_multipliers_710 = work[474];
    const real constraints_multipliers_1553 = constraints_multipliers_682 * ball2_multiplier_px
        + constraints_multipliers_710 * ball2_multiplier_py;
    const real constraints_multipliers_683 = work[452];
    const real constraints_multipliers_711 = work[475];
    const real constraints_multipliers_1554 = constraints_multipliers_683 * ball2_multiplier_px
        + constraints_multipliers_711 * ball2_multiplier_py;
    const real constraints_multipliers_684 = work[453];
    const real constraints_multipliers_712 = work[476];
    const real constraints_multipliers_1555 = constraints_multipliers_684 * ball2_multiplier_px
        + constraints_multipliers_712 * ball2_multiplier_py;
    const real constraints_multipliers_766 = work[519];
    const real constraints_multipliers_794 = work[531];
    const real constraints_multipliers_1556 = constraints_multipliers_766 * ball3_multiplier_px
        + constraints_multipliers_794 * ball3_multiplier_py;
    const real constraints_multipliers_767 = work[523];
    const real constraints_multipliers_795 = work[532];
    const real constraints_multipliers_1557 = constraints_multipliers_767 * ball3_multiplier_px
        + constraints_multipliers_795 * ball3_multiplier_py;
    const real constraints_multipliers_768 = work[524];
    const real constraints_multipliers_796 = work[533];
    const real constraints_multipliers_1558 = constraints_multipliers_768 * ball3_multiplier_px
        + constraints_multipliers_796 * ball3_multiplier_py;
    const real constraints_multipliers_850 = work[550];
    const real constraints_multipliers_878 = work[559];
    const real constraints_multipliers_1559 = constraints_multipliers_850 * ball4_multiplier_px
        + constraints_multipliers_878 * ball4_multiplier_py;
    const real constraints_multipliers_851 = work[551];
    const real constraints_multipliers_879 = work[560];
    const real constraints_multipliers_1560 = constraints_multipliers_851 * ball4_multiplier_px
        + constraints_multipliers_879 * ball4_multiplier_py;
    const real constraints_multipliers_852 = work[552];
    const real constraints_multipliers_880 = work[561];
    const real constraints_multipliers_1561 = constraints_multipliers_852 * ball4_multiplier_px
        + constraints_multipliers_880 * ball4_multiplier_py;
    const real constraints_multipliers_934 = work[605];
    const real constraints_multipliers_962 = work[614];
    const real constraints_multipliers_1562 = constraints_multipliers_934 * ball5_multiplier_px
        + constraints_multipliers_962 * ball5_multiplier_py;
    const real constraints_multipliers_935 = work[606];
    const real constraints_multipliers_963 = work[615];
    const real constraints_multipliers_1563 = constraints_multipliers_935 * ball5_multiplier_px
        + constraints_multipliers_963 * ball5_multiplier_py;
    const real constraints_multipliers_936 = work[607];
    const real constraints_multipliers_964 = work[616];
    const real constraints_multipliers_1564 = constraints_multipliers_936 * ball5_multiplier_px
        + constraints_multipliers_964 * ball5_multiplier_py;

    /* hooke0: udot angle */
    const real constraints_multipliers_557 = work[393];
    const real constraints_multipliers_989 = work[622];
    const real ball5_multiplier_pz = work[603];
    const real constraints_multipliers_573 = work[409];
    const real constraints_multipliers_993 = work[626];
    /* udot: hooke0.u.angle1dot [rad/s^2] */
    out[0] = constraints_multipliers_1484 + constraints_multipliers_989 * ball5_multiplier_pz
        + constraints_multipliers_557;
    /* udot: hooke0.u.angle2dot [rad/s^2] */
    out[1] = constraints_multipliers_1497 + constraints_multipliers_993 * ball5_multiplier_pz
        + constraints_multipliers_573;

    /* slide0: udot */
    const real constraints_multipliers_575 = work[410];
    const real constraints_multipliers_995 = work[627];
    /* udot: slide0.udot [m/s^2] */
    out[2] = constraints_multipliers_1510 + constraints_multipliers_995 * ball5_multiplier_pz
        + constraints_multipliers_575;

    /* ball0: udot */
    const real constraints_multipliers_578 = work[411];
    const real constraints_multipliers_998 = work[628];
    const real constraints_multipliers_582 = work[412];
    const real constraints_multipliers_1002 = work[629];
    const real constraints_multipliers_586 = work[413];
    const real constraints_multipliers_1006 = work[418];
    /* udot: ball0.u.xdot [rad/s^2] */
    out[3] = constraints_multipliers_1523 + constraints_multipliers_998 * ball5_multiplier_pz
        + constraints_multipliers_578;
    /* udot: ball0.u.ydot [rad/s^2] */
    out[4] = constraints_multipliers_1536 + constraints_multipliers_1002 * ball5_multiplier_pz
        + constraints_multipliers_582;
    /* udot: ball0.u.zdot [rad/s^2] */
    out[5] = constraints_multipliers_1549 + constraints_multipliers_1006 * ball5_multiplier_pz
        + constraints_multipliers_586;

    /* hooke1: udot angle */
    const real constraints_multipliers_558 = work[394];
    const real constraints_multipliers_654 = work[436];
    const real constraints_multipliers_559 = work[395];
    const real constraints_multipliers_655 = work[437];
    /* udot: hooke1.u.angle1dot [rad/s^2] */
    out[6] = constraints_multipliers_558 - (constraints_multipliers_1550
        + constraints_multipliers_654 * ball1_multiplier_pz);
    /* udot: hooke1.u.angle2dot [rad/s^2] */
    out[7] = constraints_multipliers_1551 + constraints_multipliers_655 * ball1_multiplier_pz
        + constraints_multipliers_559;

    /* slide1: udot */
    const real constraints_multipliers_560 = work[396];
    const real constraints_multipliers_656 = work[438];
    /* udot: slide1.udot [m/s^2] */
    out[8] = constraints_multipliers_560 - (constraints_multipliers_1552
        + constraints_multipliers_656 * ball1_multiplier_pz);

    /* hooke2: udot angle */
    const real constraints_multipliers_561 = work[397];
    const real constraints_multipliers_738 = work[483];
    const real constraints_multipliers_562 = work[398];
    const real constraints_multipliers_739 = work[484];
    /* udot: hooke2.u.angle1dot [rad/s^2] */
    out[9] = constraints_multipliers_561 - (constraints_multipliers_1553
        + constraints_multipliers_738 * ball2_multiplier_pz);
    /* udot: hooke2.u.angle2dot [rad/s^2] */
    out[10] = constraints_multipliers_1554 + constraints_multipliers_739 * ball2_multiplier_pz
        + constraints_multipliers_562;

    /* slide2: udot */
    const real constraints_multipliers_563 = work[399];
    const real constraints_multipliers_740 = work[485];
    /* udot: slide2.udot [m/s^2] */
    out[11] = constraints_multipliers_563 - (constraints_multipliers_1555
        + constraints_multipliers_740 * ball2_multiplier_pz);

    /* hooke3: udot angle */
    const real constraints_multipliers_564 = work[400];
    const real constraints_multipliers_822 = work[541];
    const real constraints_multipliers_565 = work[401];
    const real constraints_multipliers_823 = work[542];
    /* udot: hooke3.u.angle1dot [rad/s^2] */
    out[12] = constraints_multipliers_564 - (constraints_multipliers_1556
        + constraints_multipliers_822 * ball3_multiplier_pz);
    /* udot: hooke3.u.angle2dot [rad/s^2] */
    out[13] = constraints_multipliers_1557 + constraints_multipliers_823 * ball3_multiplier_pz
        + constraints_multipliers_565;

    /* slide3: udot */
    const real constraints_multipliers_566 = work[402];
    const real constraints_multipliers_824 = work[543];
    /* udot: slide3.udot [m/s^2] */
    out[14] = constraints_multipliers_566 - (constraints_multipliers_1558
        + constraints_multipliers_824 * ball3_multiplier_pz);

    /* hooke4: udot angle */
    const real constraints_multipliers_567 = work[403];
    const real constraints_multipliers_906 = work[568];
    const real constraints_multipliers_568 = work[404];
    const real constraints_multipliers_907 = work[569];
    /* udot: hooke4.u.angle1dot [rad/s^2] */
    out[15] = constraints_multipliers_567 - (constraints_multipliers_1559
        + constraints_multipliers_906 * ball4_multiplier_pz);
    /* udot: hooke4.u.angle2dot [rad/s^2] */
    out[16] = constraints_multipliers_1560 + constraints_multipliers_907 * ball4_multiplier_pz
        + constraints_multipliers_568;

    /* slide4: udot */
    const real constraints_multipliers_569 = work[405];
    const real constraints_multipliers_908 = work[570];
    /* udot: slide4.udot [m/s^2] */
    out[17] = constraints_multipliers_569 - (constraints_multipliers_1561
        + constraints_multipliers_908 * ball4_multiplier_pz);

    /* hooke5: udot angle */
    const real constraints_multipliers_570 = work[406];
    const real constraints_multipliers_990 = work[623];
    const real constraints_multipliers_571 = work[407];
    const real constraints_multipliers_991 = work[624];
    /* udot: hooke5.u.angle1dot [rad/s^2] */
    out[18] = constraints_multipliers_570 - (constraints_multipliers_1562
        + constraints_multipliers_990 * ball5_multiplier_pz);
    /* udot: hooke5.u.angle2dot [rad/s^2] */
    out[19] = constraints_multipliers_1563 + constraints_multipliers_991 * ball5_multiplier_pz
        + constraints_multipliers_571;

    /* slide5: udot */
    const real constraints_multipliers_572 = work[408];
    const real constraints_multipliers_992 = work[625];
    /* udot: slide5.udot [m/s^2] */
    out[20] = constraints_multipliers_572 - (constraints_multipliers_1564
        + constraints_multipliers_992 * ball5_multiplier_pz);
    return CARDAN_OK;
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
const int forward_dynamics_sizes[] = {21, 847, 107, 0, 22, 21, 0, 0, 6, 96, 0, 0, 0, 0, 21, 0, 0, 0, 0};
#endif
