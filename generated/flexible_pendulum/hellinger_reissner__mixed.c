/*
 * hellinger_reissner__mixed
 * Geometrically exact beam with a stress field in equilibrium and helicoidal strain
 * energy = y·s - s·F s / 2, F s = y, F = c + Aᵀ c A / 12, A = d(stress end to end) / ds
 * Source: Sonneville, Cardona and Brüls, CMAME 268 (2014) for the strain; Pian and Sumihara,
 *     IJNME 20 (1984) for stress fields; their union on SE(3) is our own
 * passes: reassociate
 *
 * Sizes: out 156, work 0, w 18
 * Operations per call: 2750 = 1507 mul, 808 add, 392 sub, 31 neg, 7 div, 4 select, 1 lt
 * Operations of prepare: 24 = 12 div, 6 add, 6 mul
 *
 * Input q (14): generalized coordinates
 *   q[0]  start.qw
 *   q[1]  start.qx
 *   q[2]  start.qy
 *   q[3]  start.qz
 *   q[4]  start.px [m]
 *   q[5]  start.py [m]
 *   q[6]  start.pz [m]
 *   q[7]  end.qw
 *   q[8]  end.qx
 *   q[9]  end.qy
 *   q[10]  end.qz
 *   q[11]  end.px [m]
 *   q[12]  end.py [m]
 *   q[13]  end.pz [m]
 *
 * Input z (6): internal continuous states
 *   z[0]  m1 [N*m]
 *   z[1]  m2 [N*m]
 *   z[2]  m3 [N*m]
 *   z[3]  n1 [N]
 *   z[4]  n2 [N]
 *   z[5]  n3 [N]
 *
 * Input p (19): parameters, read by prepare_ only
 *
 * Output balance (12)
 *   out[0]  start.wx [N*m]
 *   out[1]  start.wy [N*m]
 *   out[2]  start.wz [N*m]
 *   out[3]  start.vx [N]
 *   out[4]  start.vy [N]
 *   out[5]  start.vz [N]
 *   out[6]  end.wx [N*m]
 *   out[7]  end.wy [N*m]
 *   out[8]  end.wz [N*m]
 *   out[9]  end.vx [N]
 *   out[10]  end.vy [N]
 *   out[11]  end.vz [N]
 *
 * Output K (12 x 12): out[12 ... 155], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_hellinger_reissner__mixed(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* stress */
    /* stress = s: F s = y, y = (theta, e) - free */
    const wreal GJ = p[0];
    const wreal EI2 = p[1];
    const wreal EI3 = p[2];
    const wreal EA = p[3];
    const wreal GA2 = p[4];
    const wreal GA3 = p[5];
    const wreal strain_1 = p[6];
    const wreal strain_2 = p[7];
    const wreal strain_3 = p[8];
    const wreal strain_4 = p[9];
    const wreal strain_5 = p[10];
    const wreal strain_6 = p[11];
    const wreal length = p[12];
    const wreal K1 = p[13];
    const wreal K2 = p[14];
    const wreal K3 = p[15];
    const wreal E1 = p[16];
    const wreal E2 = p[17];
    const wreal E3 = p[18];
    const wreal free_K1 = length * (K1 + strain_1);
    const wreal free_K2 = length * (K2 + strain_2);
    const wreal free_K3 = length * (K3 + strain_3);
    const wreal free_E1 = length * (E1 + strain_4);
    const wreal free_E2 = length * (E2 + strain_5);
    const wreal free_E3 = length * (E3 + strain_6);
    const wreal c_1_1 = length / GJ;
    const wreal c_2_2 = length / EI2;
    const wreal c_3_3 = length / EI3;
    const wreal c_4_4 = length / EA;
    const wreal c_5_5 = length / GA2;
    const wreal c_6_6 = length / GA3;
    const wreal twelfth_1_1 = c_1_1 / 12.0;
    const wreal twelfth_2_2 = c_2_2 / 12.0;
    const wreal twelfth_3_3 = c_3_3 / 12.0;
    const wreal twelfth_4_4 = c_4_4 / 12.0;
    const wreal twelfth_5_5 = c_5_5 / 12.0;
    const wreal twelfth_6_6 = c_6_6 / 12.0;
    w[0] = free_K1;
    w[1] = free_K2;
    w[2] = free_K3;
    w[3] = free_E1;
    w[4] = free_E2;
    w[5] = free_E3;
    w[6] = c_1_1;
    w[7] = c_2_2;
    w[8] = c_3_3;
    w[9] = c_4_4;
    w[10] = c_5_5;
    w[11] = c_6_6;
    w[12] = twelfth_1_1;
    w[13] = twelfth_2_2;
    w[14] = twelfth_3_3;
    w[15] = twelfth_4_4;
    w[16] = twelfth_5_5;
    w[17] = twelfth_6_6;
}

#include "lanes.h"

/* Geometrically exact beam with a stress field in equilibrium and helicoidal strain */
CARDAN_API int hellinger_reissner__mixed(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const z = in->z;
    const wreal *const w = in->w;
    (void)work;

    /* pose */
    /* pose = theta, d: exp[theta] = R_1ᵀ R_2 = r, d = R_1ᵀ (p_2 - p_1) */
    const real start_qw = q[0];
    const real start_qx = q[1];
    const real start_qy = q[2];
    const real start_qz = q[3];
    const real start_px = q[4]; /* m */
    const real start_py = q[5]; /* m */
    const real start_pz = q[6]; /* m */
    const real end_qw = q[7];
    const real end_qx = q[8];
    const real end_qy = q[9];
    const real end_qz = q[10];
    const real end_px = q[11]; /* m */
    const real end_py = q[12]; /* m */
    const real end_pz = q[13]; /* m */
    const real twice_start_qx = 2.0 * start_qx;
    const real twice_start_qy = 2.0 * start_qy;
    const real twice_start_qz = 2.0 * start_qz;
    const real start_qw_times_twice_start_qx = start_qw * twice_start_qx;
    const real start_qw_times_twice_start_qy = start_qw * twice_start_qy;
    const real start_qw_times_twice_start_qz = start_qw * twice_start_qz;
    const real start_qx_times_twice_start_qy = start_qx * twice_start_qy;
    const real start_qx_times_twice_start_qz = start_qx * twice_start_qz;
    const real start_qy_times_twice_start_qy = start_qy * twice_start_qy;
    const real start_qy_times_twice_start_qz = start_qy * twice_start_qz;
    const real start_qz_times_twice_start_qz = start_qz * twice_start_qz;
    const real start_R_xx = 1.0 - start_qy_times_twice_start_qy - start_qz_times_twice_start_qz;
    const real start_R_xy = start_qx_times_twice_start_qy - start_qw_times_twice_start_qz;
    const real start_R_xz = start_qw_times_twice_start_qy + start_qx_times_twice_start_qz;
    const real start_R_yx = start_qw_times_twice_start_qz + start_qx_times_twice_start_qy;
    const real one_minus_start_qx_times_twice_start_qx = 1.0 - start_qx * twice_start_qx;
    const real start_R_yy = one_minus_start_qx_times_twice_start_qx - start_qz_times_twice_start_qz;
    const real start_R_yz = start_qy_times_twice_start_qz - start_qw_times_twice_start_qx;
    const real start_R_zx = start_qx_times_twice_start_qz - start_qw_times_twice_start_qy;
    const real start_R_zy = start_qw_times_twice_start_qx + start_qy_times_twice_start_qz;
    const real start_R_zz = one_minus_start_qx_times_twice_start_qx - start_qy_times_twice_start_qy;
    const real relative_w = start_qw * end_qw + start_qx * end_qx + (start_qy * end_qy
        + start_qz * end_qz);
    const real relative_x = start_qw * end_qx - start_qx * end_qw + (start_qz * end_qy
        - start_qy * end_qz);
    const real relative_y = start_qw * end_qy + start_qx * end_qz - (start_qy * end_qw
        + start_qz * end_qx);
    const real relative_z = start_qw * end_qz - start_qx * end_qy + (start_qy * end_qx
        - start_qz * end_qw);
    const real twice_relative_x = 2.0 * relative_x;
    const real twice_relative_y = 2.0 * relative_y;
    const real twice_relative_z = 2.0 * relative_z;
    const real relative_w_times_twice_relative_x = relative_w * twice_relative_x;
    const real relative_w_times_twice_relative_y = relative_w * twice_relative_y;
    const real relative_w_times_twice_relative_z = relative_w * twice_relative_z;
    const real relative_x_times_twice_relative_y = relative_x * twice_relative_y;
    const real relative_x_times_twice_relative_z = relative_x * twice_relative_z;
    const real relative_y_times_twice_relative_y = relative_y * twice_relative_y;
    const real relative_y_times_twice_relative_z = relative_y * twice_relative_z;
    const real relative_z_times_twice_relative_z = relative_z * twice_relative_z;
    const real r_xx = 1.0 - relative_y_times_twice_relative_y - relative_z_times_twice_relative_z;
    const real r_xy = relative_x_times_twice_relative_y - relative_w_times_twice_relative_z;
    const real r_xz = relative_w_times_twice_relative_y + relative_x_times_twice_relative_z;
    const real r_yx = relative_w_times_twice_relative_z + relative_x_times_twice_relative_y;
    const real one_minus_relative_x_times_twice_relative_x = 1.0 - relative_x * twice_relative_x;
    const real r_yy = one_minus_relative_x_times_twice_relative_x
        - relative_z_times_twice_relative_z;
    const real r_yz = relative_y_times_twice_relative_z - relative_w_times_twice_relative_x;
    const real r_zx = relative_x_times_twice_relative_z - relative_w_times_twice_relative_y;
    const real r_zy = relative_w_times_twice_relative_x + relative_y_times_twice_relative_z;
    const real r_zz = one_minus_relative_x_times_twice_relative_x
        - relative_y_times_twice_relative_y;
    const real relative_w_lt_zero = cardan_lt(relative_w, 0.0);
    const real short_x = cardan_select(relative_w_lt_zero, -relative_x, relative_x);
    const real short_y = cardan_select(relative_w_lt_zero, -relative_y, relative_y);
    const real short_z = cardan_select(relative_w_lt_zero, -relative_z, relative_z);
    const real sum_one_plus_short_w_inverse = 1.0 / (1.0
        + cardan_select(relative_w_lt_zero, -relative_w, relative_w));
    const real tan_quarter_x = short_x * sum_one_plus_short_w_inverse;
    const real tan_quarter_y = short_y * sum_one_plus_short_w_inverse;
    const real tan_quarter_z = short_z * sum_one_plus_short_w_inverse;
    const real tan_quarter_squared = tan_quarter_x * tan_quarter_x
        + tan_quarter_y * tan_quarter_y + tan_quarter_z * tan_quarter_z;
    const real tan_quarter_squared_squared = tan_quarter_squared * tan_quarter_squared;
    const real theta_x_part = tan_quarter_squared_squared * (tan_quarter_squared_squared *
        (tan_quarter_squared_squared * (tan_quarter_squared_squared * (1.263117843040284e-05 *
        tan_quarter_squared_squared + 0.0008033604181592972) + 0.007038646202972334)
        + 0.021740213830732918) + 0.03651081352719787) + 0.047197239923208865;
    const real theta_x_part_2 = tan_quarter_squared_squared * (tan_quarter_squared_squared *
        (tan_quarter_squared_squared * (tan_quarter_squared_squared * (-0.002804765553160955
        - 0.00014617088163551987 * tan_quarter_squared_squared) - 0.013674139288375268)
        - 0.029700717736214088) - 0.0421257239638493) - 0.052527255573225094;
    const real theta_x_part_3 = 1.0
        + tan_quarter_squared_squared * (tan_quarter_squared_squared * (tan_quarter_squared_squared
        * (tan_quarter_squared_squared * (tan_quarter_squared_squared * theta_x_part
        + 0.058803420024015285) + 0.0769227555520563) + 0.11111110982087126) + 0.19999999999929946);
    const real theta_x_part_4 = tan_quarter_squared * (tan_quarter_squared_squared *
        (tan_quarter_squared_squared * (tan_quarter_squared_squared * (tan_quarter_squared_squared *
        theta_x_part_2 - 0.06666371187721096) - 0.09090906605656898) - 0.14285714281592693)
        - 0.3333333333333286) + theta_x_part_3;
    const real theta_x_part_5 = 2.0 * (1.0 + tan_quarter_squared) * theta_x_part_4;
    const real theta_x = short_x * theta_x_part_5;
    const real theta_y = short_y * theta_x_part_5;
    const real theta_z = short_z * theta_x_part_5;
    const real theta_x_squared = theta_x * theta_x;
    const real theta_y_squared = theta_y * theta_y;
    const real theta_z_squared = theta_z * theta_z;
    const real theta_squared = theta_x_squared + theta_y_squared + theta_z_squared;
    const real theta_squared_squared = theta_squared * theta_squared;
    const real a_part = theta_squared_squared * (theta_squared_squared * (theta_squared_squared *
        (theta_squared_squared * (theta_squared_squared * (-5.5868211676655105e-21
        - 2.085606351045793e-23 * theta_squared_squared) + 4.758716543236575e-18)
        + 8.569275711864078e-15) + 1.3382434933444688e-11) + 2.087675685246588e-08);
    const real a_part_2 = theta_squared_squared * (theta_squared_squared * (theta_squared_squared *
        (theta_squared_squared * (theta_squared_squared * (5.282901546587776e-25 *
        theta_squared_squared + 6.689835630876281e-22) + 2.3763321286520025e-19)
        + 2.2164599237362465e-16) + 3.390170284017489e-13) + 5.284191588637453e-10);
    const real a = theta_squared_squared * (a_part + 3.306878306876057e-05) + 0.08333333333333333
        + theta_squared * (theta_squared_squared * (a_part_2 + 8.267195767958328e-07)
        + 0.0013888888888888915);
    const real a_slope_part = theta_squared_squared * (theta_squared_squared *
        (theta_squared_squared * (theta_squared_squared * (7.924352319881665e-24 *
        theta_squared_squared + 8.696786320139165e-21) + 2.613965341517203e-18)
        + 1.9948139313626218e-15) + 2.3731191988122424e-12) + 2.6420957943187264e-09;
    const real a_slope_part_2 = theta_squared_squared * (theta_squared_squared *
        (theta_squared_squared * (theta_squared_squared * (theta_squared_squared *
        (-6.704185401198613e-20 - 2.91984889146411e-22 * theta_squared_squared)
        + 4.7587165432365756e-17) + 6.855420569491262e-14) + 8.029460960066813e-11)
        + 8.350702740986352e-08);
    const real a_slope = 0.0013888888888888915
        + theta_squared_squared * (theta_squared_squared * a_slope_part + 2.4801587303874985e-06)
        + theta_squared * (a_slope_part_2 + 6.613756613752113e-05);
    const real a_bend_part = theta_squared_squared * (theta_squared_squared * (theta_squared_squared
        * (theta_squared_squared * (-7.374603941318475e-19
        - 3.7958035589033434e-21 * theta_squared_squared) + 4.282844888912918e-16)
        + 4.798794398643884e-13) + 4.0147304800334063e-10) + 2.5052108222959056e-07;
    const real a_bend_part_2 = theta_squared_squared * (theta_squared_squared *
        (theta_squared_squared * (theta_squared_squared * (1.109409324783433e-22 *
        theta_squared_squared + 1.0436143584166998e-19) + 2.6139653415172027e-17)
        + 1.5958511450900974e-14) + 1.4238715192873453e-11) + 1.0568383177274906e-08;
    const real half_theta_z = 0.5 * theta_z;
    const real half_theta_y = 0.5 * theta_y;
    const real half_theta_x = 0.5 * theta_x;
    const real a_times_theta_skew_squared_xy = theta_x * theta_y * a;
    const real a_times_theta_skew_squared_xz = theta_x * theta_z * a;
    const real a_times_theta_skew_squared_yz = theta_y * theta_z * a;
    const real D_xx = 1.0 + a * (theta_x_squared - theta_squared);
    const real D_xy = a_times_theta_skew_squared_xy - half_theta_z;
    const real D_xz = half_theta_y + a_times_theta_skew_squared_xz;
    const real D_yx = half_theta_z + a_times_theta_skew_squared_xy;
    const real D_yy = 1.0 + a * (theta_y_squared - theta_squared);
    const real D_yz = a_times_theta_skew_squared_yz - half_theta_x;
    const real D_zx = a_times_theta_skew_squared_xz - half_theta_y;
    const real D_zy = half_theta_x + a_times_theta_skew_squared_yz;
    const real D_zz = 1.0 + a * (theta_z_squared - theta_squared);
    const real apart_x = end_px - start_px;
    const real apart_y = end_py - start_py;
    const real apart_z = end_pz - start_pz;
    const real d_x = start_R_yx * apart_y + start_R_zx * apart_z + start_R_xx * apart_x;
    const real d_y = start_R_xy * apart_x + start_R_zy * apart_z + start_R_yy * apart_y;
    const real d_z = start_R_xz * apart_x + start_R_yz * apart_y + start_R_zz * apart_z;

    /* strain */
    /* strain = e: U d, U = 1 + first [theta] + second [theta]² */
    const real e_x = D_xx * d_x + D_yx * d_y + D_zx * d_z;
    const real e_y = D_xy * d_x + D_yy * d_y + D_zy * d_z;
    const real e_z = D_xz * d_x + D_yz * d_y + D_zz * d_z;

    /* stress */
    /* stress = s: F s = y, y = (theta, e) - free */
    const wreal c_1_1 = w[6];
    const wreal c_2_2 = w[7];
    const wreal c_3_3 = w[8];
    const wreal c_4_4 = w[9];
    const wreal c_5_5 = w[10];
    const wreal c_6_6 = w[11];
    const wreal twelfth_1_1 = w[12];
    const wreal twelfth_2_2 = w[13];
    const wreal twelfth_3_3 = w[14];
    const wreal twelfth_4_4 = w[15];
    const wreal twelfth_5_5 = w[16];
    const wreal twelfth_6_6 = w[17];
    const real half_turned_1_2 = theta_z * twelfth_2_2;
    const real minus_half_turned_1_3 = theta_y * twelfth_3_3;
    const real minus_half_turned_2_1 = theta_z * twelfth_1_1;
    const real half_turned_2_3 = theta_x * twelfth_3_3;
    const real half_turned_3_1 = theta_y * twelfth_1_1;
    const real minus_half_turned_3_2 = theta_x * twelfth_2_2;
    const real half_turned_4_2 = e_z * twelfth_2_2;
    const real minus_half_turned_4_3 = e_y * twelfth_3_3;
    const real half_turned_4_5 = theta_z * twelfth_5_5;
    const real minus_half_turned_4_6 = theta_y * twelfth_6_6;
    const real minus_half_turned_5_1 = e_z * twelfth_1_1;
    const real minus_half_turned_5_4 = theta_z * twelfth_4_4;
    const real minus_F_1_2 = theta_x * minus_half_turned_1_3;
    const real minus_F_1_3 = theta_x * half_turned_1_2;
    const real F_1_4 = e_z * half_turned_1_2 + e_y * minus_half_turned_1_3;
    const real minus_F_1_5 = e_x * minus_half_turned_1_3;
    const real minus_F_1_6 = e_x * half_turned_1_2;
    const real minus_F_2_3 = theta_y * minus_half_turned_2_1;
    const real minus_F_2_4 = e_y * half_turned_2_3;
    const real F_2_5 = e_z * minus_half_turned_2_1 + e_x * half_turned_2_3;
    const real minus_F_2_6 = e_y * minus_half_turned_2_1;
    const real minus_F_3_4 = e_z * minus_half_turned_3_2;
    const real minus_F_3_5 = e_z * half_turned_3_1;
    const real F_3_6 = e_y * half_turned_3_1 + e_x * minus_half_turned_3_2;
    const real minus_F_4_5 = e_x * minus_half_turned_4_3 + theta_x * minus_half_turned_4_6;
    const real minus_F_4_6 = e_x * half_turned_4_2 + theta_x * half_turned_4_5;
    const real minus_F_5_6 = e_y * minus_half_turned_5_1 + theta_y * minus_half_turned_5_4;
    const real F_1_1 = c_1_1 + theta_z * half_turned_1_2 + theta_y * minus_half_turned_1_3;
    const real F_2_2 = c_2_2 + theta_z * minus_half_turned_2_1 + theta_x * half_turned_2_3;
    const real F_3_3 = c_3_3 + theta_y * half_turned_3_1 + theta_x * minus_half_turned_3_2;
    const real F_4_4 = c_4_4 + theta_z * half_turned_4_5 + theta_y * minus_half_turned_4_6
        + e_z * half_turned_4_2 + e_y * minus_half_turned_4_3;
    const real F_5_5 = c_5_5 + theta_z * minus_half_turned_5_4 + theta_x * twelfth_6_6 * theta_x
        + e_z * minus_half_turned_5_1 + e_x * twelfth_3_3 * e_x;
    const real F_6_6 = c_6_6 + theta_y * twelfth_4_4 * theta_y + theta_x * twelfth_5_5 * theta_x
        + e_y * twelfth_1_1 * e_y + e_x * twelfth_2_2 * e_x;
    const real F_factor_D_inverse_n3 = 1.0 / F_6_6;
    const real F_minus_factor_L_n3_n2 = minus_F_5_6 * F_factor_D_inverse_n3;
    const real F_minus_factor_DL_n2_m1 = minus_F_1_5 + minus_F_1_6 * F_minus_factor_L_n3_n2;
    const real F_factor_DL_n2_m2 = F_2_5 - minus_F_2_6 * F_minus_factor_L_n3_n2;
    const real F_factor_DL_n2_m3 = F_3_6 * F_minus_factor_L_n3_n2 - minus_F_3_5;
    const real F_minus_factor_DL_n2_n1 = minus_F_4_5 + minus_F_4_6 * F_minus_factor_L_n3_n2;
    const real F_minus_factor_L_n3_n1 = minus_F_4_6 * F_factor_D_inverse_n3;
    const real F_factor_L_n3_m3 = F_3_6 * F_factor_D_inverse_n3;
    const real F_minus_factor_L_n3_m2 = minus_F_2_6 * F_factor_D_inverse_n3;
    const real F_minus_factor_L_n3_m1 = minus_F_1_6 * F_factor_D_inverse_n3;
    const real F_factor_D_inverse_n2 = 1.0 / (F_5_5 - minus_F_5_6 * F_minus_factor_L_n3_n2);
    const real F_minus_factor_L_n2_n1 = F_minus_factor_DL_n2_n1 * F_factor_D_inverse_n2;
    const real F_factor_DL_n1_m1 = F_1_4 - minus_F_1_6 * F_minus_factor_L_n3_n1
        - F_minus_factor_DL_n2_m1 * F_minus_factor_L_n2_n1;
    const real F_factor_DL_n1_m2 = F_factor_DL_n2_m2 * F_minus_factor_L_n2_n1 - (minus_F_2_4
        + minus_F_2_6 * F_minus_factor_L_n3_n1);
    const real F_factor_DL_n1_m3 = F_3_6 * F_minus_factor_L_n3_n1 - minus_F_3_4
        + F_factor_DL_n2_m3 * F_minus_factor_L_n2_n1;
    const real F_factor_L_n2_m3 = F_factor_DL_n2_m3 * F_factor_D_inverse_n2;
    const real F_factor_L_n2_m2 = F_factor_DL_n2_m2 * F_factor_D_inverse_n2;
    const real F_minus_factor_L_n2_m1 = F_minus_factor_DL_n2_m1 * F_factor_D_inverse_n2;
    const real F_factor_D_inverse_n1 = 1.0 / (F_4_4 - minus_F_4_6 * F_minus_factor_L_n3_n1
        - F_minus_factor_DL_n2_n1 * F_minus_factor_L_n2_n1);
    const real F_factor_L_n1_m3 = F_factor_DL_n1_m3 * F_factor_D_inverse_n1;
    const real F_factor_DL_m3_m1 = minus_F_1_6 * F_factor_L_n3_m3 - minus_F_1_3
        + F_minus_factor_DL_n2_m1 * F_factor_L_n2_m3 - F_factor_DL_n1_m1 * F_factor_L_n1_m3;
    const real F_factor_DL_m3_m2 = minus_F_2_6 * F_factor_L_n3_m3 - minus_F_2_3
        - F_factor_DL_n2_m2 * F_factor_L_n2_m3 - F_factor_DL_n1_m2 * F_factor_L_n1_m3;
    const real F_factor_L_n1_m2 = F_factor_DL_n1_m2 * F_factor_D_inverse_n1;
    const real F_factor_L_n1_m1 = F_factor_DL_n1_m1 * F_factor_D_inverse_n1;
    const real F_factor_D_inverse_m3 = 1.0 / (F_3_3 - F_3_6 * F_factor_L_n3_m3
        - F_factor_DL_n2_m3 * F_factor_L_n2_m3 - F_factor_DL_n1_m3 * F_factor_L_n1_m3);
    const real F_factor_L_m3_m2 = F_factor_DL_m3_m2 * F_factor_D_inverse_m3;
    const real F_factor_DL_m2_m1 = F_minus_factor_DL_n2_m1 * F_factor_L_n2_m2 - (minus_F_1_2
        + minus_F_1_6 * F_minus_factor_L_n3_m2) - F_factor_DL_n1_m1 * F_factor_L_n1_m2
        - F_factor_DL_m3_m1 * F_factor_L_m3_m2;
    const real F_factor_L_m3_m1 = F_factor_DL_m3_m1 * F_factor_D_inverse_m3;
    const real F_factor_D_inverse_m2 = 1.0 / (F_2_2 - minus_F_2_6 * F_minus_factor_L_n3_m2
        - F_factor_DL_n2_m2 * F_factor_L_n2_m2 - F_factor_DL_n1_m2 * F_factor_L_n1_m2
        - F_factor_DL_m3_m2 * F_factor_L_m3_m2);
    const real F_factor_L_m2_m1 = F_factor_DL_m2_m1 * F_factor_D_inverse_m2;
    const real F_factor_D_inverse_m1 = 1.0 / (F_1_1 - minus_F_1_6 * F_minus_factor_L_n3_m1
        - F_minus_factor_DL_n2_m1 * F_minus_factor_L_n2_m1 - F_factor_DL_n1_m1 * F_factor_L_n1_m1
        - F_factor_DL_m3_m1 * F_factor_L_m3_m1 - F_factor_DL_m2_m1 * F_factor_L_m2_m1);

    /* response */
    /* response = m, n: Dᵀ (by_theta + e_by_thetaᵀ by_e), Uᵀ by_e */
    const real theta_y_times_d_z = theta_y * d_z;
    const real theta_z_times_d_y = theta_z * d_y;
    const real theta_cross_d_x = theta_y_times_d_z - theta_z_times_d_y;
    const real theta_z_times_d_x = theta_z * d_x;
    const real theta_x_times_d_z = theta_x * d_z;
    const real theta_cross_d_y = theta_z_times_d_x - theta_x_times_d_z;
    const real theta_x_times_d_y = theta_x * d_y;
    const real theta_y_times_d_x = theta_y * d_x;
    const real theta_cross_d_z = theta_x_times_d_y - theta_y_times_d_x;
    const real theta_x_times_d_x = theta_x * d_x;
    const real theta_y_times_d_y = theta_y * d_y;
    const real theta_z_times_d_z = theta_z * d_z;
    const real theta_dot_d = theta_x_times_d_x + theta_y_times_d_y + theta_z_times_d_z;
    const real twice_a_slope = 2.0 * a_slope;
    const real U_d_slope_by_squared_x = (theta_y * theta_cross_d_z
        - theta_z * theta_cross_d_y) * twice_a_slope;
    const real U_d_slope_by_squared_y = (theta_z * theta_cross_d_x
        - theta_x * theta_cross_d_z) * twice_a_slope;
    const real U_d_slope_by_squared_z = (theta_x * theta_cross_d_y
        - theta_y * theta_cross_d_x) * twice_a_slope;
    const real half_d_z = 0.5 * d_z;
    const real half_d_y = 0.5 * d_y;
    const real half_d_x = 0.5 * d_x;
    const real e_by_theta_xx = a * (theta_x_times_d_x - 2.0 * theta_x_times_d_x + theta_dot_d)
        + theta_x * U_d_slope_by_squared_x;
    const real e_by_theta_xy = a * (theta_x_times_d_y - 2.0 * theta_y_times_d_x) - half_d_z
        + theta_y * U_d_slope_by_squared_x;
    const real e_by_theta_xz = a * (theta_x_times_d_z - 2.0 * theta_z_times_d_x) + half_d_y
        + theta_z * U_d_slope_by_squared_x;
    const real e_by_theta_yx = a * (theta_y_times_d_x - 2.0 * theta_x_times_d_y) + half_d_z
        + theta_x * U_d_slope_by_squared_y;
    const real e_by_theta_yy = a * (theta_y_times_d_y - 2.0 * theta_y_times_d_y + theta_dot_d)
        + theta_y * U_d_slope_by_squared_y;
    const real e_by_theta_yz = a * (theta_y_times_d_z - 2.0 * theta_z_times_d_y) - half_d_x
        + theta_z * U_d_slope_by_squared_y;
    const real e_by_theta_zx = a * (theta_z_times_d_x - 2.0 * theta_x_times_d_z) - half_d_y
        + theta_x * U_d_slope_by_squared_z;
    const real e_by_theta_zy = a * (theta_z_times_d_y - 2.0 * theta_y_times_d_z) + half_d_x
        + theta_y * U_d_slope_by_squared_z;
    const real e_by_theta_zz = a * (theta_z_times_d_z - 2.0 * theta_z_times_d_z + theta_dot_d)
        + theta_z * U_d_slope_by_squared_z;

    /* common */
    const wreal free_K1 = w[0];
    const wreal free_K2 = w[1];
    const wreal free_K3 = w[2];
    const wreal free_E1 = w[3];
    const wreal free_E2 = w[4];
    const wreal free_E3 = w[5];
    const real m1 = z[0]; /* N*m */
    const real m2 = z[1]; /* N*m */
    const real m3 = z[2]; /* N*m */
    const real n1 = z[3]; /* N */
    const real n2 = z[4]; /* N */
    const real n3 = z[5]; /* N */
    const real gap_E3 = minus_F_2_6 * m2 - F_3_6 * m3 + minus_F_5_6 * n2 + (e_z - free_E3
        + minus_F_1_6 * m1 + minus_F_4_6 * n1 - F_6_6 * n3);
    const real tau_K1 = twelfth_1_1 * (theta_y * m3 - theta_z * m2 - e_z * n2 + e_y * n3);
    const real tau_K2 = twelfth_2_2 * (theta_z * m1 - theta_x * m3 + e_z * n1 - e_x * n3);
    const real tau_K3 = twelfth_3_3 * (theta_x * m2 - theta_y * m1 - e_y * n1 + e_x * n2);
    const real tau_E1 = twelfth_4_4 * (theta_y * n3 - theta_z * n2);
    const real tau_E2 = twelfth_5_5 * (theta_z * n1 - theta_x * n3);
    const real tau_E3 = twelfth_6_6 * (theta_x * n2 - theta_y * n1);
    const real tau_by_strain_1_2 = twelfth_1_1 * m3;
    const real minus_tau_by_strain_1_3 = twelfth_1_1 * m2;
    const real tau_by_strain_1_5 = twelfth_1_1 * n3;
    const real minus_tau_by_strain_1_6 = twelfth_1_1 * n2;
    const real minus_tau_by_strain_2_1 = twelfth_2_2 * m3;
    const real tau_by_strain_2_3 = twelfth_2_2 * m1;
    const real minus_tau_by_strain_2_4 = twelfth_2_2 * n3;
    const real tau_by_strain_2_6 = twelfth_2_2 * n1;
    const real tau_by_strain_3_1 = twelfth_3_3 * m2;
    const real minus_tau_by_strain_3_2 = twelfth_3_3 * m1;
    const real tau_by_strain_3_4 = twelfth_3_3 * n2;
    const real minus_tau_by_strain_3_5 = twelfth_3_3 * n1;
    const real tau_by_strain_4_2 = twelfth_4_4 * n3;
    const real minus_tau_by_strain_4_3 = twelfth_4_4 * n2;
    const real minus_tau_by_strain_5_1 = twelfth_5_5 * n3;
    const real tau_by_strain_5_3 = twelfth_5_5 * n1;
    const real tau_by_strain_6_1 = twelfth_6_6 * n2;
    const real minus_tau_by_strain_6_2 = twelfth_6_6 * n1;
    const real B_1_4 = theta_z * minus_tau_by_strain_2_4 + theta_y * tau_by_strain_3_4;
    const real minus_B_1_5 = theta_y * minus_tau_by_strain_3_5;
    const real minus_B_1_6 = theta_z * tau_by_strain_2_6;
    const real minus_B_2_4 = theta_x * tau_by_strain_3_4;
    const real B_2_5 = theta_z * tau_by_strain_1_5 + theta_x * minus_tau_by_strain_3_5;
    const real minus_B_2_6 = theta_z * minus_tau_by_strain_1_6;
    const real minus_B_3_4 = theta_x * minus_tau_by_strain_2_4;
    const real minus_B_3_5 = theta_y * tau_by_strain_1_5;
    const real B_3_6 = theta_y * minus_tau_by_strain_1_6 + theta_x * tau_by_strain_2_6;
    const real B_4_1 = theta_z * minus_tau_by_strain_5_1 + theta_y * tau_by_strain_6_1
        + e_z * minus_tau_by_strain_2_1 + e_y * tau_by_strain_3_1;
    const real B_5_2 = theta_z * tau_by_strain_4_2 + theta_x * minus_tau_by_strain_6_2
        + e_z * tau_by_strain_1_2 + e_x * minus_tau_by_strain_3_2;
    const real B_6_3 = theta_y * minus_tau_by_strain_4_3 + theta_x * tau_by_strain_5_3
        + e_y * minus_tau_by_strain_1_3 + e_x * tau_by_strain_2_3;
    const real B_1_1 = 1.0 + theta_z * minus_tau_by_strain_2_1 + theta_y * tau_by_strain_3_1;
    const real B_1_2 = tau_K3 - theta_y * minus_tau_by_strain_3_2;
    const real minus_B_1_3 = tau_K2 + theta_z * tau_by_strain_2_3;
    const real minus_B_2_1 = tau_K3 + theta_x * tau_by_strain_3_1;
    const real B_2_2 = 1.0 + theta_z * tau_by_strain_1_2 + theta_x * minus_tau_by_strain_3_2;
    const real B_2_3 = tau_K1 - theta_z * minus_tau_by_strain_1_3;
    const real B_3_1 = tau_K2 - theta_x * minus_tau_by_strain_2_1;
    const real minus_B_3_2 = tau_K1 + theta_y * tau_by_strain_1_2;
    const real B_3_3 = 1.0 + theta_y * minus_tau_by_strain_1_3 + theta_x * tau_by_strain_2_3;
    const real B_4_2 = tau_E3 - theta_y * minus_tau_by_strain_6_2 - e_y * minus_tau_by_strain_3_2;
    const real minus_B_4_3 = tau_E2 + theta_z * tau_by_strain_5_3 + e_z * tau_by_strain_2_3;
    const real B_4_4 = 1.0 + e_z * minus_tau_by_strain_2_4 + e_y * tau_by_strain_3_4;
    const real B_4_5 = tau_K3 - e_y * minus_tau_by_strain_3_5;
    const real minus_B_4_6 = tau_K2 + e_z * tau_by_strain_2_6;
    const real minus_B_5_1 = tau_E3 + theta_x * tau_by_strain_6_1 + e_x * tau_by_strain_3_1;
    const real B_5_3 = tau_E1 - theta_z * minus_tau_by_strain_4_3 - e_z * minus_tau_by_strain_1_3;
    const real minus_B_5_4 = tau_K3 + e_x * tau_by_strain_3_4;
    const real B_5_5 = 1.0 + e_z * tau_by_strain_1_5 + e_x * minus_tau_by_strain_3_5;
    const real B_5_6 = tau_K1 - e_z * minus_tau_by_strain_1_6;
    const real B_6_1 = tau_E2 - theta_x * minus_tau_by_strain_5_1 - e_x * minus_tau_by_strain_2_1;
    const real minus_B_6_2 = tau_E1 + theta_y * tau_by_strain_4_2 + e_y * tau_by_strain_1_2;
    const real B_6_4 = tau_K2 - e_x * minus_tau_by_strain_2_4;
    const real minus_B_6_5 = tau_K1 + e_y * tau_by_strain_1_5;
    const real B_6_6 = 1.0 + e_y * minus_tau_by_strain_1_6 + e_x * tau_by_strain_2_6;
    const real LB_1_5 = F_minus_factor_L_n3_n2 * B_6_1 - minus_B_5_1;
    const real LB_1_4 = B_4_1 + F_minus_factor_L_n3_n1 * B_6_1 + F_minus_factor_L_n2_n1 * LB_1_5;
    const real LB_1_3 = B_3_1 - F_factor_L_n3_m3 * B_6_1 - F_factor_L_n2_m3 * LB_1_5
        - F_factor_L_n1_m3 * LB_1_4;
    const real LB_1_2 = F_minus_factor_L_n3_m2 * B_6_1 - minus_B_2_1 - F_factor_L_n2_m2 * LB_1_5
        - F_factor_L_n1_m2 * LB_1_4 - F_factor_L_m3_m2 * LB_1_3;
    const real LB_1_1 = B_1_1 + F_minus_factor_L_n3_m1 * B_6_1 + F_minus_factor_L_n2_m1 * LB_1_5
        - F_factor_L_n1_m1 * LB_1_4 - F_factor_L_m3_m1 * LB_1_3 - F_factor_L_m2_m1 * LB_1_2;
    const real LB_2_5 = B_5_2 - F_minus_factor_L_n3_n2 * minus_B_6_2;
    const real LB_2_4 = B_4_2 - F_minus_factor_L_n3_n1 * minus_B_6_2
        + F_minus_factor_L_n2_n1 * LB_2_5;
    const real LB_2_3 = F_factor_L_n3_m3 * minus_B_6_2 - minus_B_3_2 - F_factor_L_n2_m3 * LB_2_5
        - F_factor_L_n1_m3 * LB_2_4;
    const real LB_2_2 = B_2_2 - F_minus_factor_L_n3_m2 * minus_B_6_2 - F_factor_L_n2_m2 * LB_2_5
        - F_factor_L_n1_m2 * LB_2_4 - F_factor_L_m3_m2 * LB_2_3;
    const real LB_2_1 = B_1_2 - F_minus_factor_L_n3_m1 * minus_B_6_2
        + F_minus_factor_L_n2_m1 * LB_2_5 - F_factor_L_n1_m1 * LB_2_4 - F_factor_L_m3_m1 * LB_2_3
        - F_factor_L_m2_m1 * LB_2_2;
    const real LB_3_5 = B_5_3 + F_minus_factor_L_n3_n2 * B_6_3;
    const real LB_3_4 = F_minus_factor_L_n3_n1 * B_6_3 - minus_B_4_3
        + F_minus_factor_L_n2_n1 * LB_3_5;
    const real LB_3_3 = B_3_3 - F_factor_L_n3_m3 * B_6_3 - F_factor_L_n2_m3 * LB_3_5
        - F_factor_L_n1_m3 * LB_3_4;
    const real LB_3_2 = B_2_3 + F_minus_factor_L_n3_m2 * B_6_3 - F_factor_L_n2_m2 * LB_3_5
        - F_factor_L_n1_m2 * LB_3_4 - F_factor_L_m3_m2 * LB_3_3;
    const real LB_3_1 = F_minus_factor_L_n3_m1 * B_6_3 - minus_B_1_3
        + F_minus_factor_L_n2_m1 * LB_3_5 - F_factor_L_n1_m1 * LB_3_4 - F_factor_L_m3_m1 * LB_3_3
        - F_factor_L_m2_m1 * LB_3_2;
    const real LB_4_5 = F_minus_factor_L_n3_n2 * B_6_4 - minus_B_5_4;
    const real LB_4_4 = B_4_4 + F_minus_factor_L_n3_n1 * B_6_4 + F_minus_factor_L_n2_n1 * LB_4_5;
    const real minus_LB_4_3 = minus_B_3_4 + F_factor_L_n3_m3 * B_6_4 + F_factor_L_n2_m3 * LB_4_5
        + F_factor_L_n1_m3 * LB_4_4;
    const real LB_4_2 = F_minus_factor_L_n3_m2 * B_6_4 - minus_B_2_4 - F_factor_L_n2_m2 * LB_4_5
        - F_factor_L_n1_m2 * LB_4_4 + F_factor_L_m3_m2 * minus_LB_4_3;
    const real LB_4_1 = B_1_4 + F_minus_factor_L_n3_m1 * B_6_4 + F_minus_factor_L_n2_m1 * LB_4_5
        - F_factor_L_n1_m1 * LB_4_4 + F_factor_L_m3_m1 * minus_LB_4_3 - F_factor_L_m2_m1 * LB_4_2;
    const real LB_5_5 = B_5_5 - F_minus_factor_L_n3_n2 * minus_B_6_5;
    const real LB_5_4 = B_4_5 - F_minus_factor_L_n3_n1 * minus_B_6_5
        + F_minus_factor_L_n2_n1 * LB_5_5;
    const real LB_5_3 = F_factor_L_n3_m3 * minus_B_6_5 - minus_B_3_5 - F_factor_L_n2_m3 * LB_5_5
        - F_factor_L_n1_m3 * LB_5_4;
    const real LB_5_2 = B_2_5 - F_minus_factor_L_n3_m2 * minus_B_6_5 - F_factor_L_n2_m2 * LB_5_5
        - F_factor_L_n1_m2 * LB_5_4 - F_factor_L_m3_m2 * LB_5_3;
    const real LB_5_1 = F_minus_factor_L_n2_m1 * LB_5_5 - (minus_B_1_5
        + F_minus_factor_L_n3_m1 * minus_B_6_5) - F_factor_L_n1_m1 * LB_5_4
        - F_factor_L_m3_m1 * LB_5_3 - F_factor_L_m2_m1 * LB_5_2;
    const real LB_6_5 = B_5_6 + F_minus_factor_L_n3_n2 * B_6_6;
    const real LB_6_4 = F_minus_factor_L_n3_n1 * B_6_6 - minus_B_4_6
        + F_minus_factor_L_n2_n1 * LB_6_5;
    const real LB_6_3 = B_3_6 - F_factor_L_n3_m3 * B_6_6 - F_factor_L_n2_m3 * LB_6_5
        - F_factor_L_n1_m3 * LB_6_4;
    const real LB_6_2 = F_minus_factor_L_n3_m2 * B_6_6 - minus_B_2_6 - F_factor_L_n2_m2 * LB_6_5
        - F_factor_L_n1_m2 * LB_6_4 - F_factor_L_m3_m2 * LB_6_3;
    const real LB_6_1 = F_minus_factor_L_n3_m1 * B_6_6 - minus_B_1_6
        + F_minus_factor_L_n2_m1 * LB_6_5 - F_factor_L_n1_m1 * LB_6_4 - F_factor_L_m3_m1 * LB_6_3
        - F_factor_L_m2_m1 * LB_6_2;
    const real DLB_2_1 = F_factor_D_inverse_m1 * LB_2_1;
    const real DLB_2_2 = F_factor_D_inverse_m2 * LB_2_2;
    const real DLB_2_3 = F_factor_D_inverse_m3 * LB_2_3;
    const real DLB_2_4 = F_factor_D_inverse_n1 * LB_2_4;
    const real DLB_2_5 = F_factor_D_inverse_n2 * LB_2_5;
    const real minus_DLB_2_6 = F_factor_D_inverse_n3 * minus_B_6_2;
    const real DLB_3_1 = F_factor_D_inverse_m1 * LB_3_1;
    const real DLB_3_2 = F_factor_D_inverse_m2 * LB_3_2;
    const real DLB_3_3 = F_factor_D_inverse_m3 * LB_3_3;
    const real DLB_3_4 = F_factor_D_inverse_n1 * LB_3_4;
    const real DLB_3_5 = F_factor_D_inverse_n2 * LB_3_5;
    const real DLB_3_6 = F_factor_D_inverse_n3 * B_6_3;
    const real DLB_4_1 = F_factor_D_inverse_m1 * LB_4_1;
    const real DLB_4_2 = F_factor_D_inverse_m2 * LB_4_2;
    const real minus_DLB_4_3 = F_factor_D_inverse_m3 * minus_LB_4_3;
    const real DLB_4_4 = F_factor_D_inverse_n1 * LB_4_4;
    const real DLB_4_5 = F_factor_D_inverse_n2 * LB_4_5;
    const real DLB_4_6 = F_factor_D_inverse_n3 * B_6_4;
    const real DLB_5_1 = F_factor_D_inverse_m1 * LB_5_1;
    const real DLB_5_2 = F_factor_D_inverse_m2 * LB_5_2;
    const real DLB_5_3 = F_factor_D_inverse_m3 * LB_5_3;
    const real DLB_5_4 = F_factor_D_inverse_n1 * LB_5_4;
    const real DLB_5_5 = F_factor_D_inverse_n2 * LB_5_5;
    const real minus_DLB_5_6 = F_factor_D_inverse_n3 * minus_B_6_5;
    const real DLB_6_1 = F_factor_D_inverse_m1 * LB_6_1;
    const real DLB_6_2 = F_factor_D_inverse_m2 * LB_6_2;
    const real DLB_6_3 = F_factor_D_inverse_m3 * LB_6_3;
    const real DLB_6_4 = F_factor_D_inverse_n1 * LB_6_4;
    const real DLB_6_5 = F_factor_D_inverse_n2 * LB_6_5;
    const real DLB_6_6 = F_factor_D_inverse_n3 * B_6_6;
    const real by_strain_strain_1_4 = B_6_1 * DLB_4_6 - (m3 * minus_tau_by_strain_2_4
        + m2 * tau_by_strain_3_4) + LB_1_5 * DLB_4_5 + LB_1_4 * DLB_4_4 - LB_1_3 * minus_DLB_4_3
        + LB_1_2 * DLB_4_2 + LB_1_1 * DLB_4_1;
    const real by_strain_strain_1_5 = m2 * minus_tau_by_strain_3_5 - B_6_1 * minus_DLB_5_6
        + LB_1_5 * DLB_5_5 + LB_1_4 * DLB_5_4 + LB_1_3 * DLB_5_3 + LB_1_2 * DLB_5_2
        + LB_1_1 * DLB_5_1;
    const real by_strain_strain_1_6 = m3 * tau_by_strain_2_6 + B_6_1 * DLB_6_6 + LB_1_5 * DLB_6_5
        + LB_1_4 * DLB_6_4 + LB_1_3 * DLB_6_3 + LB_1_2 * DLB_6_2 + LB_1_1 * DLB_6_1;
    const real by_strain_strain_2_4 = m1 * tau_by_strain_3_4 - minus_B_6_2 * DLB_4_6
        + LB_2_5 * DLB_4_5 + LB_2_4 * DLB_4_4 - LB_2_3 * minus_DLB_4_3 + LB_2_2 * DLB_4_2
        + LB_2_1 * DLB_4_1;
    const real by_strain_strain_2_5 = minus_B_6_2 * minus_DLB_5_6 - (m3 * tau_by_strain_1_5
        + m1 * minus_tau_by_strain_3_5) + LB_2_5 * DLB_5_5 + LB_2_4 * DLB_5_4 + LB_2_3 * DLB_5_3
        + LB_2_2 * DLB_5_2 + LB_2_1 * DLB_5_1;
    const real by_strain_strain_2_6 = m3 * minus_tau_by_strain_1_6 - minus_B_6_2 * DLB_6_6
        + LB_2_5 * DLB_6_5 + LB_2_4 * DLB_6_4 + LB_2_3 * DLB_6_3 + LB_2_2 * DLB_6_2
        + LB_2_1 * DLB_6_1;
    const real by_strain_strain_3_4 = m1 * minus_tau_by_strain_2_4 + B_6_3 * DLB_4_6
        + LB_3_5 * DLB_4_5 + LB_3_4 * DLB_4_4 - LB_3_3 * minus_DLB_4_3 + LB_3_2 * DLB_4_2
        + LB_3_1 * DLB_4_1;
    const real by_strain_strain_3_5 = m2 * tau_by_strain_1_5 - B_6_3 * minus_DLB_5_6
        + LB_3_5 * DLB_5_5 + LB_3_4 * DLB_5_4 + LB_3_3 * DLB_5_3 + LB_3_2 * DLB_5_2
        + LB_3_1 * DLB_5_1;
    const real by_strain_strain_3_6 = B_6_3 * DLB_6_6 - (m2 * minus_tau_by_strain_1_6
        + m1 * tau_by_strain_2_6) + LB_3_5 * DLB_6_5 + LB_3_4 * DLB_6_4 + LB_3_3 * DLB_6_3
        + LB_3_2 * DLB_6_2 + LB_3_1 * DLB_6_1;
    const real by_strain_strain_4_4 = B_6_4 * DLB_4_6 - (n3 * minus_tau_by_strain_2_4
        + n2 * tau_by_strain_3_4) + LB_4_5 * DLB_4_5 + LB_4_4 * DLB_4_4
        + minus_LB_4_3 * minus_DLB_4_3 + LB_4_2 * DLB_4_2 + LB_4_1 * DLB_4_1;
    const real by_strain_strain_4_5 = n2 * minus_tau_by_strain_3_5 - B_6_4 * minus_DLB_5_6
        + LB_4_5 * DLB_5_5 + LB_4_4 * DLB_5_4 - minus_LB_4_3 * DLB_5_3 + LB_4_2 * DLB_5_2
        + LB_4_1 * DLB_5_1;
    const real by_strain_strain_4_6 = n3 * tau_by_strain_2_6 + B_6_4 * DLB_6_6 + LB_4_5 * DLB_6_5
        + LB_4_4 * DLB_6_4 - minus_LB_4_3 * DLB_6_3 + LB_4_2 * DLB_6_2 + LB_4_1 * DLB_6_1;
    const real by_strain_strain_5_5 = minus_B_6_5 * minus_DLB_5_6 - (n3 * tau_by_strain_1_5
        + n1 * minus_tau_by_strain_3_5) + LB_5_5 * DLB_5_5 + LB_5_4 * DLB_5_4 + LB_5_3 * DLB_5_3
        + LB_5_2 * DLB_5_2 + LB_5_1 * DLB_5_1;
    const real by_strain_strain_5_6 = n3 * minus_tau_by_strain_1_6 - minus_B_6_5 * DLB_6_6
        + LB_5_5 * DLB_6_5 + LB_5_4 * DLB_6_4 + LB_5_3 * DLB_6_3 + LB_5_2 * DLB_6_2
        + LB_5_1 * DLB_6_1;
    const real by_strain_strain_6_6 = B_6_6 * DLB_6_6 - (n2 * minus_tau_by_strain_1_6
        + n1 * tau_by_strain_2_6) + LB_6_5 * DLB_6_5 + LB_6_4 * DLB_6_4 + LB_6_3 * DLB_6_3
        + LB_6_2 * DLB_6_2 + LB_6_1 * DLB_6_1;
    const real m_x = m1 - n2 * tau_E3 + n3 * tau_E2 - m2 * tau_K3 + m3 * tau_K2;
    const real m_y = m2 - n3 * tau_E1 + n1 * tau_E3 - m3 * tau_K1 + m1 * tau_K3;
    const real m_z = m3 - n1 * tau_E2 + n2 * tau_E1 - m1 * tau_K2 + m2 * tau_K1;
    const real n_x = n1 - n2 * tau_K3 + n3 * tau_K2;
    const real n_y = n2 - n3 * tau_K1 + n1 * tau_K3;
    const real n_z = n3 - n1 * tau_K2 + n2 * tau_K1;
    const real by_theta_x = m_x + e_by_theta_xx * n_x + (e_by_theta_yx * n_y + e_by_theta_zx * n_z);
    const real by_theta_y = m_y + e_by_theta_xy * n_x + (e_by_theta_yy * n_y + e_by_theta_zy * n_z);
    const real by_theta_z = m_z + e_by_theta_xz * n_x + (e_by_theta_yz * n_y + e_by_theta_zz * n_z);
    const real by_d_x = D_xx * n_x + D_xy * n_y + D_xz * n_z;
    const real by_d_y = D_yx * n_x + D_yy * n_y + D_yz * n_z;
    const real by_d_z = D_zx * n_x + D_zy * n_y + D_zz * n_z;
    const real across_xx = by_strain_strain_1_4 + e_by_theta_xx * by_strain_strain_4_4
        + (e_by_theta_yx * by_strain_strain_4_5 + e_by_theta_zx * by_strain_strain_4_6);
    const real across_xy = by_strain_strain_1_5 + e_by_theta_xx * by_strain_strain_4_5
        + (e_by_theta_yx * by_strain_strain_5_5 + e_by_theta_zx * by_strain_strain_5_6);
    const real across_xz = by_strain_strain_1_6 + e_by_theta_xx * by_strain_strain_4_6
        + (e_by_theta_yx * by_strain_strain_5_6 + e_by_theta_zx * by_strain_strain_6_6);
    const real across_yx = by_strain_strain_2_4 + e_by_theta_xy * by_strain_strain_4_4
        + (e_by_theta_yy * by_strain_strain_4_5 + e_by_theta_zy * by_strain_strain_4_6);
    const real across_yy = by_strain_strain_2_5 + e_by_theta_xy * by_strain_strain_4_5
        + (e_by_theta_yy * by_strain_strain_5_5 + e_by_theta_zy * by_strain_strain_5_6);
    const real across_yz = by_strain_strain_2_6 + e_by_theta_xy * by_strain_strain_4_6
        + (e_by_theta_yy * by_strain_strain_5_6 + e_by_theta_zy * by_strain_strain_6_6);
    const real across_zx = by_strain_strain_3_4 + e_by_theta_xz * by_strain_strain_4_4
        + (e_by_theta_yz * by_strain_strain_4_5 + e_by_theta_zz * by_strain_strain_4_6);
    const real across_zy = by_strain_strain_3_5 + e_by_theta_xz * by_strain_strain_4_5
        + (e_by_theta_yz * by_strain_strain_5_5 + e_by_theta_zz * by_strain_strain_5_6);
    const real across_zz = by_strain_strain_3_6 + e_by_theta_xz * by_strain_strain_4_6
        + (e_by_theta_yz * by_strain_strain_5_6 + e_by_theta_zz * by_strain_strain_6_6);
    const real half_turned_xx = D_xx * by_strain_strain_4_4 + D_xy * by_strain_strain_4_5
        + D_xz * by_strain_strain_4_6;
    const real half_turned_xy = D_xx * by_strain_strain_4_5 + D_xy * by_strain_strain_5_5
        + D_xz * by_strain_strain_5_6;
    const real half_turned_xz = D_xx * by_strain_strain_4_6 + D_xy * by_strain_strain_5_6
        + D_xz * by_strain_strain_6_6;
    const real half_turned_yx = D_yx * by_strain_strain_4_4 + D_yy * by_strain_strain_4_5
        + D_yz * by_strain_strain_4_6;
    const real half_turned_yy = D_yx * by_strain_strain_4_5 + D_yy * by_strain_strain_5_5
        + D_yz * by_strain_strain_5_6;
    const real half_turned_yz = D_yx * by_strain_strain_4_6 + D_yy * by_strain_strain_5_6
        + D_yz * by_strain_strain_6_6;
    const real by_d_d_xx = D_xx * half_turned_xx + D_xy * half_turned_xy + D_xz * half_turned_xz;
    const real by_d_d_xy = D_yx * half_turned_xx + D_yy * half_turned_xy + D_yz * half_turned_xz;
    const real by_d_d_xz = D_zx * half_turned_xx + D_zy * half_turned_xy + D_zz * half_turned_xz;
    const real by_d_d_yy = D_yx * half_turned_yx + D_yy * half_turned_yy + D_yz * half_turned_yz;
    const real by_d_d_yz = D_zx * half_turned_yx + D_zy * half_turned_yy + D_zz * half_turned_yz;
    const real D_zx_times_half_turned_zx_plus_D_zy_times_half_turned_zy = D_zx * (D_zx *
        by_strain_strain_4_4 + D_zy * by_strain_strain_4_5 + D_zz * by_strain_strain_4_6)
        + D_zy * (D_zx * by_strain_strain_4_5 + D_zy * by_strain_strain_5_5
        + D_zz * by_strain_strain_5_6);
    const real by_d_d_zz = D_zz * (D_zx * by_strain_strain_4_6 + D_zy * by_strain_strain_5_6
        + D_zz * by_strain_strain_6_6) + D_zx_times_half_turned_zx_plus_D_zy_times_half_turned_zy;
    const real d_x_times_n_x = d_x * n_x;
    const real d_y_times_n_y = d_y * n_y;
    const real d_z_times_n_z = d_z * n_z;
    const real force_dot_d = d_x_times_n_x + d_y_times_n_y + d_z_times_n_z;
    const real theta_x_times_n_x = theta_x * n_x;
    const real theta_y_times_n_y = theta_y * n_y;
    const real theta_z_times_n_z = theta_z * n_z;
    const real theta_dot_force = theta_x_times_n_x + theta_y_times_n_y + theta_z_times_n_z;
    const real force_dot_theta_cross_theta_cross_d = theta_dot_d * theta_dot_force
        - theta_squared * force_dot_d;
    const real twice_force_dot_d = 2.0 * force_dot_d;
    const real twice_a_bend_times_force_dot_theta_cross_theta_cross_d = (6.613756613752113e-05
        + theta_squared_squared * a_bend_part
        + theta_squared * (theta_squared_squared * a_bend_part_2
        + 4.960317460774997e-06)) * force_dot_theta_cross_theta_cross_d * 2.0;
    const real bend_side_x = twice_a_slope * (theta_dot_d * n_x + d_x * theta_dot_force
        - theta_x * twice_force_dot_d)
        + theta_x * twice_a_bend_times_force_dot_theta_cross_theta_cross_d;
    const real bend_side_y = twice_a_slope * (theta_dot_d * n_y + d_y * theta_dot_force
        - theta_y * twice_force_dot_d)
        + theta_y * twice_a_bend_times_force_dot_theta_cross_theta_cross_d;
    const real bend_side_z = twice_a_slope * (theta_dot_d * n_z + d_z * theta_dot_force
        - theta_z * twice_force_dot_d)
        + theta_z * twice_a_bend_times_force_dot_theta_cross_theta_cross_d;
    const real bend_diagonal = a_slope * force_dot_theta_cross_theta_cross_d * 2.0
        - 2.0 * a * force_dot_d;
    const real bend_pair_xx = a * d_x_times_n_x + theta_x * bend_side_x;
    const real bend_pair_yy = a * d_y_times_n_y + theta_y * bend_side_y;
    const real bend_pair_zz = a * d_z_times_n_z + theta_z * bend_side_z;
    const real by_theta_theta_xx_part = F_factor_D_inverse_n3 * B_6_1 * B_6_1
        - (m3 * minus_tau_by_strain_2_1 + m2 * tau_by_strain_3_1 + (n3 * minus_tau_by_strain_5_1
        + n2 * tau_by_strain_6_1)) + bend_diagonal + F_factor_D_inverse_n2 * LB_1_5 * LB_1_5
        + bend_pair_xx + bend_pair_xx;
    const real by_theta_theta_xx_part_2 = F_factor_D_inverse_n1 * LB_1_4 * LB_1_4
        + by_theta_theta_xx_part + F_factor_D_inverse_m3 * LB_1_3 * LB_1_3
        + F_factor_D_inverse_m2 * LB_1_2 * LB_1_2 + F_factor_D_inverse_m1 * LB_1_1 * LB_1_1
        + e_by_theta_xx * by_strain_strain_1_4;
    const real by_theta_theta_xx = e_by_theta_yx * by_strain_strain_1_5
        + e_by_theta_zx * by_strain_strain_1_6 + by_theta_theta_xx_part_2
        + e_by_theta_xx * across_xx + (e_by_theta_yx * across_xy + e_by_theta_zx * across_xz);
    const real by_theta_theta_xy_part = m2 * minus_tau_by_strain_3_2
        + n2 * minus_tau_by_strain_6_2 + d_y * n_x * a + (d_x * n_y * a - B_6_1 * minus_DLB_2_6)
        + LB_1_5 * DLB_2_5 + theta_x * bend_side_y + theta_y * bend_side_x + LB_1_4 * DLB_2_4
        + LB_1_3 * DLB_2_3;
    const real by_theta_theta_xy_part_2 = LB_1_2 * DLB_2_2 + by_theta_theta_xy_part
        + LB_1_1 * DLB_2_1 + e_by_theta_xy * by_strain_strain_1_4
        + (e_by_theta_yy * by_strain_strain_1_5 + e_by_theta_zy * by_strain_strain_1_6)
        + e_by_theta_xx * across_yx;
    const real by_theta_theta_xy = e_by_theta_yx * across_yy + e_by_theta_zx * across_yz
        + by_theta_theta_xy_part_2;
    const real by_theta_theta_xz_part = m3 * tau_by_strain_2_3 + n3 * tau_by_strain_5_3
        + d_z * n_x * a + (B_6_1 * DLB_3_6 + d_x * n_z * a) + LB_1_5 * DLB_3_5
        + theta_x * bend_side_z + theta_z * bend_side_x + LB_1_4 * DLB_3_4 + LB_1_3 * DLB_3_3
        + LB_1_2 * DLB_3_2;
    const real by_theta_theta_xz = LB_1_1 * DLB_3_1 + by_theta_theta_xz_part
        + e_by_theta_xz * by_strain_strain_1_4 + (e_by_theta_yz * by_strain_strain_1_5
        + e_by_theta_zz * by_strain_strain_1_6) + e_by_theta_xx * across_zx
        + (e_by_theta_yx * across_zy + e_by_theta_zx * across_zz);
    const real by_theta_theta_yy_part = minus_B_6_2 * minus_DLB_2_6 - (m3 * tau_by_strain_1_2
        + m1 * minus_tau_by_strain_3_2 + (n3 * tau_by_strain_4_2 + n1 * minus_tau_by_strain_6_2))
        + bend_diagonal + LB_2_5 * DLB_2_5 + bend_pair_yy + bend_pair_yy + LB_2_4 * DLB_2_4
        + LB_2_3 * DLB_2_3;
    const real by_theta_theta_yy_part_2 = LB_2_2 * DLB_2_2 + by_theta_theta_yy_part
        + LB_2_1 * DLB_2_1 + e_by_theta_xy * by_strain_strain_2_4
        + (e_by_theta_yy * by_strain_strain_2_5 + e_by_theta_zy * by_strain_strain_2_6)
        + e_by_theta_xy * across_yx;
    const real by_theta_theta_yy = e_by_theta_yy * across_yy + e_by_theta_zy * across_yz
        + by_theta_theta_yy_part_2;
    const real by_theta_theta_yz_part = m3 * minus_tau_by_strain_1_3
        + n3 * minus_tau_by_strain_4_3 + d_z * n_y * a + (d_y * n_z * a - minus_B_6_2 * DLB_3_6)
        + LB_2_5 * DLB_3_5 + theta_y * bend_side_z + theta_z * bend_side_y + LB_2_4 * DLB_3_4
        + LB_2_3 * DLB_3_3;
    const real by_theta_theta_yz_part_2 = LB_2_2 * DLB_3_2 + by_theta_theta_yz_part
        + LB_2_1 * DLB_3_1 + e_by_theta_xz * by_strain_strain_2_4
        + (e_by_theta_yz * by_strain_strain_2_5 + e_by_theta_zz * by_strain_strain_2_6)
        + e_by_theta_xy * across_zx;
    const real by_theta_theta_yz = e_by_theta_yy * across_zy + e_by_theta_zy * across_zz
        + by_theta_theta_yz_part_2;
    const real by_theta_theta_zz_part = B_6_3 * DLB_3_6 - (m2 * minus_tau_by_strain_1_3
        + m1 * tau_by_strain_2_3 + (n2 * minus_tau_by_strain_4_3 + n1 * tau_by_strain_5_3))
        + bend_diagonal + LB_3_5 * DLB_3_5 + bend_pair_zz + bend_pair_zz + LB_3_4 * DLB_3_4
        + LB_3_3 * DLB_3_3;
    const real by_theta_theta_zz_part_2 = LB_3_2 * DLB_3_2 + by_theta_theta_zz_part
        + LB_3_1 * DLB_3_1 + e_by_theta_xz * by_strain_strain_3_4
        + (e_by_theta_yz * by_strain_strain_3_5 + e_by_theta_zz * by_strain_strain_3_6)
        + e_by_theta_xz * across_zx;
    const real by_theta_theta_zz = e_by_theta_yz * across_zy + e_by_theta_zz * across_zz
        + by_theta_theta_zz_part_2;
    const real theta_y_times_n_z = theta_y * n_z;
    const real theta_z_times_n_y = theta_z * n_y;
    const real theta_cross_n_x = theta_y_times_n_z - theta_z_times_n_y;
    const real theta_z_times_n_x = theta_z * n_x;
    const real theta_x_times_n_z = theta_x * n_z;
    const real theta_cross_n_y = theta_z_times_n_x - theta_x_times_n_z;
    const real theta_x_times_n_y = theta_x * n_y;
    const real theta_y_times_n_x = theta_y * n_x;
    const real theta_cross_n_z = theta_x_times_n_y - theta_y_times_n_x;
    const real U_n_slope_by_squared_x = twice_a_slope * (theta_y * theta_cross_n_z
        - theta_z * theta_cross_n_y);
    const real U_n_slope_by_squared_y = twice_a_slope * (theta_z * theta_cross_n_x
        - theta_x * theta_cross_n_z);
    const real U_n_slope_by_squared_z = twice_a_slope * (theta_x * theta_cross_n_y
        - theta_y * theta_cross_n_x);
    const real half_n_z = 0.5 * n_z;
    const real half_n_y = 0.5 * n_y;
    const real half_n_x = 0.5 * n_x;
    const real by_d_theta_xx = a * (theta_x_times_n_x - 2.0 * theta_x_times_n_x
        + theta_dot_force) + theta_x * U_n_slope_by_squared_x + D_xx * across_xx
        + (D_xy * across_xy + D_xz * across_xz);
    const real by_d_theta_xy = a * (theta_x_times_n_y - 2.0 * theta_y_times_n_x) + half_n_z
        + theta_y * U_n_slope_by_squared_x + D_xx * across_yx + (D_xy * across_yy
        + D_xz * across_yz);
    const real by_d_theta_xz = a * (theta_x_times_n_z - 2.0 * theta_z_times_n_x) - half_n_y
        + theta_z * U_n_slope_by_squared_x + D_xx * across_zx + (D_xy * across_zy
        + D_xz * across_zz);
    const real by_d_theta_yx = a * (theta_y_times_n_x - 2.0 * theta_x_times_n_y) - half_n_z
        + theta_x * U_n_slope_by_squared_y + D_yx * across_xx + (D_yy * across_xy
        + D_yz * across_xz);
    const real by_d_theta_yy = a * (theta_y_times_n_y - 2.0 * theta_y_times_n_y
        + theta_dot_force) + theta_y * U_n_slope_by_squared_y + D_yx * across_yx
        + (D_yy * across_yy + D_yz * across_yz);
    const real by_d_theta_yz = a * (theta_y_times_n_z - 2.0 * theta_z_times_n_y) + half_n_x
        + theta_z * U_n_slope_by_squared_y + D_yx * across_zx + (D_yy * across_zy
        + D_yz * across_zz);
    const real by_d_theta_zx = a * (theta_z_times_n_x - 2.0 * theta_x_times_n_z) + half_n_y
        + theta_x * U_n_slope_by_squared_z + D_zx * across_xx + (D_zy * across_xy
        + D_zz * across_xz);
    const real by_d_theta_zy = a * (theta_z_times_n_y - 2.0 * theta_y_times_n_z) - half_n_x
        + theta_y * U_n_slope_by_squared_z + D_zx * across_yx + (D_zy * across_yy
        + D_zz * across_yz);
    const real by_d_theta_zz = a * (theta_z_times_n_z - 2.0 * theta_z_times_n_z
        + theta_dot_force) + theta_z * U_n_slope_by_squared_z + D_zx * across_zx
        + (D_zy * across_zy + D_zz * across_zz);
    const real by_rho_x = D_xx * by_theta_x + D_yx * by_theta_y + D_zx * by_theta_z;
    const real by_rho_y = D_xy * by_theta_x + D_yy * by_theta_y + D_zy * by_theta_z;
    const real by_rho_z = D_xz * by_theta_x + D_yz * by_theta_y + D_zz * by_theta_z;
    const real theta_y_times_by_theta_z = theta_y * by_theta_z;
    const real theta_z_times_by_theta_y = theta_z * by_theta_y;
    const real theta_cross_by_theta_x = theta_y_times_by_theta_z - theta_z_times_by_theta_y;
    const real theta_z_times_by_theta_x = theta_z * by_theta_x;
    const real theta_x_times_by_theta_z = theta_x * by_theta_z;
    const real theta_cross_by_theta_y = theta_z_times_by_theta_x - theta_x_times_by_theta_z;
    const real theta_x_times_by_theta_y = theta_x * by_theta_y;
    const real theta_y_times_by_theta_x = theta_y * by_theta_x;
    const real theta_cross_by_theta_z = theta_x_times_by_theta_y - theta_y_times_by_theta_x;
    const real theta_x_times_by_theta_x = theta_x * by_theta_x;
    const real theta_y_times_by_theta_y = theta_y * by_theta_y;
    const real theta_z_times_by_theta_z = theta_z * by_theta_z;
    const real theta_dot_by_theta = theta_x_times_by_theta_x + theta_y_times_by_theta_y
        + theta_z_times_by_theta_z;
    const real U_by_theta_slope_by_squared_x = twice_a_slope * (theta_y * theta_cross_by_theta_z
        - theta_z * theta_cross_by_theta_y);
    const real U_by_theta_slope_by_squared_y = twice_a_slope * (theta_z * theta_cross_by_theta_x
        - theta_x * theta_cross_by_theta_z);
    const real U_by_theta_slope_by_squared_z = twice_a_slope * (theta_x * theta_cross_by_theta_y
        - theta_y * theta_cross_by_theta_x);
    const real half_by_theta_z = 0.5 * by_theta_z;
    const real half_by_theta_y = 0.5 * by_theta_y;
    const real half_by_theta_x = 0.5 * by_theta_x;
    const real by_theta_rho_xx = a * (theta_x_times_by_theta_x - 2.0 * theta_x_times_by_theta_x
        + theta_dot_by_theta) + theta_x * U_by_theta_slope_by_squared_x
        + D_xx * by_theta_theta_xx + (D_yx * by_theta_theta_xy + D_zx * by_theta_theta_xz);
    const real by_theta_rho_xy = a * (theta_x_times_by_theta_y - 2.0 * theta_y_times_by_theta_x)
        - half_by_theta_z + theta_y * U_by_theta_slope_by_squared_x + D_xx * by_theta_theta_xy
        + (D_yx * by_theta_theta_yy + D_zx * by_theta_theta_yz);
    const real by_theta_rho_xz = a * (theta_x_times_by_theta_z - 2.0 * theta_z_times_by_theta_x)
        + half_by_theta_y + theta_z * U_by_theta_slope_by_squared_x + D_xx * by_theta_theta_xz
        + (D_yx * by_theta_theta_yz + D_zx * by_theta_theta_zz);
    const real by_theta_rho_yx = a * (theta_y_times_by_theta_x - 2.0 * theta_x_times_by_theta_y)
        + half_by_theta_z + theta_x * U_by_theta_slope_by_squared_y + D_xy * by_theta_theta_xx
        + (D_yy * by_theta_theta_xy + D_zy * by_theta_theta_xz);
    const real by_theta_rho_yy = a * (theta_y_times_by_theta_y - 2.0 * theta_y_times_by_theta_y
        + theta_dot_by_theta) + theta_y * U_by_theta_slope_by_squared_y
        + D_xy * by_theta_theta_xy + (D_yy * by_theta_theta_yy + D_zy * by_theta_theta_yz);
    const real by_theta_rho_yz = a * (theta_y_times_by_theta_z - 2.0 * theta_z_times_by_theta_y)
        - half_by_theta_x + theta_z * U_by_theta_slope_by_squared_y + D_xy * by_theta_theta_xz
        + (D_yy * by_theta_theta_yz + D_zy * by_theta_theta_zz);
    const real by_rho_rho_xx = D_xx * by_theta_rho_xx + D_yx * by_theta_rho_xy
        + D_zx * by_theta_rho_xz;
    const real by_rho_rho_xy = D_xy * by_theta_rho_xx + D_yy * by_theta_rho_xy
        + D_zy * by_theta_rho_xz;
    const real by_rho_rho_xz = D_xz * by_theta_rho_xx + D_yz * by_theta_rho_xy
        + D_zz * by_theta_rho_xz;
    const real by_rho_rho_yy = D_xy * by_theta_rho_yx + D_yy * by_theta_rho_yy
        + D_zy * by_theta_rho_yz;
    const real by_rho_rho_yz = D_xz * by_theta_rho_yx + D_yz * by_theta_rho_yy
        + D_zz * by_theta_rho_yz;
    const real D_xz_times_by_theta_rho_zx = D_xz * (a * (theta_z_times_by_theta_x
        - 2.0 * theta_x_times_by_theta_z) - half_by_theta_y
        + theta_x * U_by_theta_slope_by_squared_z + D_xz * by_theta_theta_xx
        + (D_yz * by_theta_theta_xy + D_zz * by_theta_theta_xz));
    const real D_yz_times_by_theta_rho_zy = D_yz * (a * (theta_z_times_by_theta_y
        - 2.0 * theta_y_times_by_theta_z) + half_by_theta_x
        + theta_y * U_by_theta_slope_by_squared_z + D_xz * by_theta_theta_xy
        + (D_yz * by_theta_theta_yy + D_zz * by_theta_theta_yz));
    const real D_zz_times_by_theta_rho_zz = D_zz * (a * (theta_z_times_by_theta_z
        - 2.0 * theta_z_times_by_theta_z + theta_dot_by_theta)
        + theta_z * U_by_theta_slope_by_squared_z + D_xz * by_theta_theta_xz
        + (D_yz * by_theta_theta_yz + D_zz * by_theta_theta_zz));
    const real by_rho_rho_zz = D_xz_times_by_theta_rho_zx + D_yz_times_by_theta_rho_zy
        + D_zz_times_by_theta_rho_zz;
    const real by_rho_rho_yx = by_rho_z + by_rho_rho_xy;
    const real by_rho_rho_zx = by_rho_rho_xz - by_rho_y;
    const real by_rho_rho_zy = by_rho_x + by_rho_rho_yz;
    const real by_d_rho_xx = D_xx * by_d_theta_xx + D_yx * by_d_theta_xy + D_zx * by_d_theta_xz;
    const real by_d_rho_xy = D_xy * by_d_theta_xx + D_yy * by_d_theta_xy + D_zy * by_d_theta_xz;
    const real by_d_rho_xz = D_xz * by_d_theta_xx + D_yz * by_d_theta_xy + D_zz * by_d_theta_xz;
    const real by_d_rho_yx = D_xx * by_d_theta_yx + D_yx * by_d_theta_yy + D_zx * by_d_theta_yz;
    const real by_d_rho_yy = D_xy * by_d_theta_yx + D_yy * by_d_theta_yy + D_zy * by_d_theta_yz;
    const real by_d_rho_yz = D_xz * by_d_theta_yx + D_yz * by_d_theta_yy + D_zz * by_d_theta_yz;
    const real by_d_rho_zx = D_xx * by_d_theta_zx + D_yx * by_d_theta_zy + D_zx * by_d_theta_zz;
    const real by_d_rho_zy = D_xy * by_d_theta_zx + D_yy * by_d_theta_zy + D_zy * by_d_theta_zz;
    const real by_d_rho_zz = D_xz * by_d_theta_zx + D_yz * by_d_theta_zy + D_zz * by_d_theta_zz;
    const real d_y_times_by_d_z = d_y * by_d_z;
    const real d_x_times_by_d_z = d_x * by_d_z;
    const real d_x_times_by_d_y = d_x * by_d_y;
    const real d_z_times_by_d_d_xy = d_z * by_d_d_xy;
    const real d_y_times_by_d_d_xz = d_y * by_d_d_xz;
    const real d_x_times_by_d_d_yz = d_x * by_d_d_yz;
    const real force_by_start_xx = d_z_times_by_d_d_xy - d_y_times_by_d_d_xz - r_xx * by_d_rho_xx
        - (r_xy * by_d_rho_xy + r_xz * by_d_rho_xz);
    const real force_by_start_xy = d_x * by_d_d_xz - d_z * by_d_d_xx - r_yx * by_d_rho_xx
        - (r_yy * by_d_rho_xy + r_yz * by_d_rho_xz);
    const real force_by_start_xz = d_y * by_d_d_xx - d_x * by_d_d_xy - r_zx * by_d_rho_xx
        - (r_zy * by_d_rho_xy + r_zz * by_d_rho_xz);
    const real force_by_start_yx = d_z * by_d_d_yy - d_y * by_d_d_yz - r_xx * by_d_rho_yx
        - (r_xy * by_d_rho_yy + r_xz * by_d_rho_yz);
    const real force_by_start_yy = d_x_times_by_d_d_yz - d_z_times_by_d_d_xy - r_yx * by_d_rho_yx
        - (r_yy * by_d_rho_yy + r_yz * by_d_rho_yz);
    const real force_by_start_yz = d_y * by_d_d_xy - d_x * by_d_d_yy - r_zx * by_d_rho_yx
        - (r_zy * by_d_rho_yy + r_zz * by_d_rho_yz);
    const real force_by_start_zx = d_z * by_d_d_yz - d_y * by_d_d_zz - r_xx * by_d_rho_zx
        - (r_xy * by_d_rho_zy + r_xz * by_d_rho_zz);
    const real force_by_start_zy = d_x * by_d_d_zz - d_z * by_d_d_xz - r_yx * by_d_rho_zx
        - (r_yy * by_d_rho_zy + r_yz * by_d_rho_zz);
    const real force_by_start_zz = d_y_times_by_d_d_xz - d_x_times_by_d_d_yz - r_zx * by_d_rho_zx
        - (r_zy * by_d_rho_zy + r_zz * by_d_rho_zz);
    const real moment_by_start_xx = d_z * by_d_rho_yx - d_y * by_d_rho_zx - r_xx * by_rho_rho_xx
        - (r_xy * by_rho_rho_xy + r_xz * by_rho_rho_xz);
    const real moment_by_start_xy = d_x * by_d_rho_zx - d_z * by_d_rho_xx - r_yx * by_rho_rho_xx
        - (r_yy * by_rho_rho_xy + r_yz * by_rho_rho_xz);
    const real moment_by_start_xz = d_y * by_d_rho_xx - d_x * by_d_rho_yx - r_zx * by_rho_rho_xx
        - (r_zy * by_rho_rho_xy + r_zz * by_rho_rho_xz);
    const real moment_by_start_yx = d_z * by_d_rho_yy - d_y * by_d_rho_zy - r_xy * by_rho_rho_yy
        - (r_xx * by_rho_rho_yx + r_xz * by_rho_rho_yz);
    const real moment_by_start_yy = d_x * by_d_rho_zy - d_z * by_d_rho_xy - r_yy * by_rho_rho_yy
        - (r_yx * by_rho_rho_yx + r_yz * by_rho_rho_yz);
    const real moment_by_start_yz = d_y * by_d_rho_xy - d_x * by_d_rho_yy - r_zy * by_rho_rho_yy
        - (r_zx * by_rho_rho_yx + r_zz * by_rho_rho_yz);
    const real moment_by_start_zx = d_z * by_d_rho_yz - d_y * by_d_rho_zz - r_xz * by_rho_rho_zz
        - (r_xx * by_rho_rho_zx + r_xy * by_rho_rho_zy);
    const real moment_by_start_zy = d_x * by_d_rho_zz - d_z * by_d_rho_xz - r_yz * by_rho_rho_zz
        - (r_yx * by_rho_rho_zx + r_yy * by_rho_rho_zy);
    const real moment_by_start_zz = d_y * by_d_rho_xz - d_x * by_d_rho_yz - r_zz * by_rho_rho_zz
        - (r_zx * by_rho_rho_zx + r_zy * by_rho_rho_zy);
    const real half_turned_xx_2 = start_R_xx * by_d_d_xx + start_R_xy * by_d_d_xy
        + start_R_xz * by_d_d_xz;
    const real half_turned_xy_2 = start_R_xx * by_d_d_xy + start_R_xy * by_d_d_yy
        + start_R_xz * by_d_d_yz;
    const real half_turned_xz_2 = start_R_xx * by_d_d_xz + start_R_xy * by_d_d_yz
        + start_R_xz * by_d_d_zz;
    const real half_turned_yx_2 = start_R_yx * by_d_d_xx + start_R_yy * by_d_d_xy
        + start_R_yz * by_d_d_xz;
    const real half_turned_yy_2 = start_R_yx * by_d_d_xy + start_R_yy * by_d_d_yy
        + start_R_yz * by_d_d_yz;
    const real half_turned_yz_2 = start_R_yx * by_d_d_xz + start_R_yy * by_d_d_yz
        + start_R_yz * by_d_d_zz;
    const real K_pp_xx = start_R_xx * half_turned_xx_2 + start_R_xy * half_turned_xy_2
        + start_R_xz * half_turned_xz_2;
    const real K_pp_xy = start_R_yx * half_turned_xx_2 + start_R_yy * half_turned_xy_2
        + start_R_yz * half_turned_xz_2;
    const real K_pp_xz = start_R_zx * half_turned_xx_2 + start_R_zy * half_turned_xy_2
        + start_R_zz * half_turned_xz_2;
    const real K_pp_yy = start_R_yx * half_turned_yx_2 + start_R_yy * half_turned_yy_2
        + start_R_yz * half_turned_yz_2;
    const real K_pp_yz = start_R_zx * half_turned_yx_2 + start_R_zy * half_turned_yy_2
        + start_R_zz * half_turned_yz_2;
    const real K_pp_zz_part = start_R_zx * (start_R_zx * by_d_d_xx + start_R_zy * by_d_d_xy
        + start_R_zz * by_d_d_xz) + start_R_zy * (start_R_zx * by_d_d_xy + start_R_zy * by_d_d_yy
        + start_R_zz * by_d_d_yz);
    const real K_pp_zz = start_R_zz * (start_R_zx * by_d_d_xz + start_R_zy * by_d_d_yz
        + start_R_zz * by_d_d_zz) + K_pp_zz_part;
    const real K_p2_xx = start_R_xx * by_d_rho_xx + start_R_xy * by_d_rho_yx
        + start_R_xz * by_d_rho_zx;
    const real K_p2_xy = start_R_xx * by_d_rho_xy + start_R_xy * by_d_rho_yy
        + start_R_xz * by_d_rho_zy;
    const real K_p2_xz = start_R_xx * by_d_rho_xz + start_R_xy * by_d_rho_yz
        + start_R_xz * by_d_rho_zz;
    const real K_p2_yx = start_R_yx * by_d_rho_xx + start_R_yy * by_d_rho_yx
        + start_R_yz * by_d_rho_zx;
    const real K_p2_yy = start_R_yx * by_d_rho_xy + start_R_yy * by_d_rho_yy
        + start_R_yz * by_d_rho_zy;
    const real K_p2_yz = start_R_yx * by_d_rho_xz + start_R_yy * by_d_rho_yz
        + start_R_yz * by_d_rho_zz;
    const real K_p2_zx = start_R_zx * by_d_rho_xx + start_R_zy * by_d_rho_yx
        + start_R_zz * by_d_rho_zx;
    const real K_p2_zy = start_R_zx * by_d_rho_xy + start_R_zy * by_d_rho_yy
        + start_R_zz * by_d_rho_zy;
    const real K_p2_zz = start_R_zx * by_d_rho_xz + start_R_zy * by_d_rho_yz
        + start_R_zz * by_d_rho_zz;
    const real force_turned_by_start_xy = by_d_z + force_by_start_xy;
    const real force_turned_by_start_xz = force_by_start_xz - by_d_y;
    const real force_turned_by_start_yx = force_by_start_yx - by_d_z;
    const real force_turned_by_start_yz = by_d_x + force_by_start_yz;
    const real force_turned_by_start_zx = by_d_y + force_by_start_zx;
    const real force_turned_by_start_zy = force_by_start_zy - by_d_x;
    const real K_p1_xx = start_R_xx * force_by_start_xx + start_R_xy * force_turned_by_start_yx
        + start_R_xz * force_turned_by_start_zx;
    const real K_p1_xy = start_R_xx * force_turned_by_start_xy + start_R_xy * force_by_start_yy
        + start_R_xz * force_turned_by_start_zy;
    const real K_p1_xz = start_R_xx * force_turned_by_start_xz + start_R_xz * force_by_start_zz
        + start_R_xy * force_turned_by_start_yz;
    const real K_p1_yx = start_R_yx * force_by_start_xx + start_R_yy * force_turned_by_start_yx
        + start_R_yz * force_turned_by_start_zx;
    const real K_p1_yy = start_R_yx * force_turned_by_start_xy + start_R_yy * force_by_start_yy
        + start_R_yz * force_turned_by_start_zy;
    const real K_p1_yz = start_R_yx * force_turned_by_start_xz + start_R_yz * force_by_start_zz
        + start_R_yy * force_turned_by_start_yz;
    const real K_p1_zx = start_R_zx * force_by_start_xx + start_R_zy * force_turned_by_start_yx
        + start_R_zz * force_turned_by_start_zx;
    const real K_p1_zy = start_R_zx * force_turned_by_start_xy + start_R_zy * force_by_start_yy
        + start_R_zz * force_turned_by_start_zy;
    const real K_p1_zz = start_R_zx * force_turned_by_start_xz + start_R_zz * force_by_start_zz
        + start_R_zy * force_turned_by_start_yz;
    const real moment_turned_by_start_xy = r_yz * by_rho_y - r_yy * by_rho_z + moment_by_start_xy;
    const real moment_turned_by_start_xz = r_zz * by_rho_y - r_zy * by_rho_z + moment_by_start_xz;
    const real moment_turned_by_start_yy = r_yx * by_rho_z - r_yz * by_rho_x + moment_by_start_yy;
    const real moment_turned_by_start_yz = r_zx * by_rho_z - r_zz * by_rho_x + moment_by_start_yz;
    const real moment_turned_by_start_zy = r_yy * by_rho_x - r_yx * by_rho_y + moment_by_start_zy;
    const real moment_turned_by_start_zz = r_zy * by_rho_x - r_zx * by_rho_y + moment_by_start_zz;
    const real d_z_times_by_d_z = d_z * by_d_z;
    const real d_y_times_by_d_y = d_y * by_d_y;
    const real d_x_times_by_d_x = d_x * by_d_x;
    const real K_start_wx_start_wx_part = d_z * force_by_start_yx - (d_z_times_by_d_z
        + d_y_times_by_d_y + d_y * force_by_start_zx) - r_xx * (r_xz * by_rho_y - r_xy * by_rho_z
        + moment_by_start_xx);
    const real K_start_wy_start_wx_part = d_x_times_by_d_y - d_y * force_by_start_zy
        + d_z * force_by_start_yy - r_xx * moment_turned_by_start_xy
        - (r_xy * moment_turned_by_start_yy + r_xz * moment_turned_by_start_zy);
    const real K_start_wz_start_wx_part = d_x_times_by_d_z - d_y * force_by_start_zz
        + d_z * force_by_start_yz - r_xx * moment_turned_by_start_xz
        - (r_xy * moment_turned_by_start_yz + r_xz * moment_turned_by_start_zz);
    const real K_start_wz_start_wy_part = d_y_times_by_d_z - d_z * force_by_start_xz
        + d_x * force_by_start_zz - r_yx * moment_turned_by_start_xz
        - (r_yy * moment_turned_by_start_yz + r_yz * moment_turned_by_start_zz);
    const real minus_K_p1_xx = -K_p1_xx;
    const real minus_K_p1_yx = -K_p1_yx;
    const real minus_K_p1_zx = -K_p1_zx;
    const real minus_K_p1_xy = -K_p1_xy;
    const real minus_K_p1_yy = -K_p1_yy;
    const real minus_K_p1_zy = -K_p1_zy;
    const real minus_K_p1_xz = -K_p1_xz;
    const real minus_K_p1_yz = -K_p1_yz;
    const real minus_K_p1_zz = -K_p1_zz;
    const real minus_K_p2_xx = -K_p2_xx;
    const real minus_K_p2_xy = -K_p2_xy;
    const real minus_K_p2_xz = -K_p2_xz;
    const real minus_K_p2_yx = -K_p2_yx;
    const real minus_K_p2_yy = -K_p2_yy;
    const real minus_K_p2_yz = -K_p2_yz;
    const real minus_K_p2_zx = -K_p2_zx;
    const real minus_K_p2_zy = -K_p2_zy;
    const real minus_K_p2_zz = -K_p2_zz;
    const real minus_K_pp_xx = -K_pp_xx;
    const real minus_K_pp_xy = -K_pp_xy;
    const real minus_K_pp_xz = -K_pp_xz;
    const real minus_K_pp_yy = -K_pp_yy;
    const real minus_K_pp_yz = -K_pp_yz;
    const real minus_K_pp_zz = -K_pp_zz;
    const real s_m1_part = minus_F_3_5 * m3 - F_2_5 * m2 + minus_F_5_6 * n3 + (e_y - free_E2
        + minus_F_1_5 * m1 + minus_F_4_5 * n1 - F_5_5 * n2) + F_minus_factor_L_n3_n2 * gap_E3;
    const real s_m1_part_2 = minus_F_3_4 * m3 - F_1_4 * m1 + minus_F_4_6 * n3 + (e_x - free_E1
        + minus_F_2_4 * m2 + minus_F_4_5 * n2 - F_4_4 * n1) + F_minus_factor_L_n3_n1 * gap_E3
        + F_minus_factor_L_n2_n1 * s_m1_part;
    const real s_m1_part_3 = theta_z - free_K3 + minus_F_1_3 * m1 + minus_F_2_3 * m2 - F_3_3 * m3
        + minus_F_3_4 * n1 + (minus_F_3_5 * n2 - F_3_6 * n3) - F_factor_L_n3_m3 * gap_E3
        - F_factor_L_n2_m3 * s_m1_part - F_factor_L_n1_m3 * s_m1_part_2;
    const real s_m1_part_4 = theta_y - free_K2 + minus_F_1_2 * m1 + minus_F_2_3 * m3 - F_2_2 * m2
        + minus_F_2_4 * n1 + (minus_F_2_6 * n3 - F_2_5 * n2) + F_minus_factor_L_n3_m2 * gap_E3
        - F_factor_L_n2_m2 * s_m1_part - F_factor_L_n1_m2 * s_m1_part_2
        - F_factor_L_m3_m2 * s_m1_part_3;
    const real s_m1_part_5 = theta_x - free_K1 + minus_F_1_2 * m2 + minus_F_1_3 * m3 - F_1_1 * m1
        + minus_F_1_5 * n2 + (minus_F_1_6 * n3 - F_1_4 * n1) + F_minus_factor_L_n3_m1 * gap_E3
        + F_minus_factor_L_n2_m1 * s_m1_part - F_factor_L_n1_m1 * s_m1_part_2
        - F_factor_L_m3_m1 * s_m1_part_3;
    const real s_m1 = F_factor_D_inverse_m1 * (s_m1_part_5 - F_factor_L_m2_m1 * s_m1_part_4);
    const real s_m2 = F_factor_D_inverse_m2 * s_m1_part_4 - F_factor_L_m2_m1 * s_m1;
    const real s_m3 = F_factor_D_inverse_m3 * s_m1_part_3 - F_factor_L_m3_m1 * s_m1
        - F_factor_L_m3_m2 * s_m2;
    const real s_n1 = F_factor_D_inverse_n1 * s_m1_part_2 - F_factor_L_n1_m1 * s_m1
        - F_factor_L_n1_m2 * s_m2 - F_factor_L_n1_m3 * s_m3;
    const real s_n2 = F_factor_D_inverse_n2 * s_m1_part + F_minus_factor_L_n2_m1 * s_m1
        - F_factor_L_n2_m2 * s_m2 - F_factor_L_n2_m3 * s_m3 + F_minus_factor_L_n2_n1 * s_n1;
    const real s_n3 = F_factor_D_inverse_n3 * gap_E3 + F_minus_factor_L_n3_m1 * s_m1
        + F_minus_factor_L_n3_m2 * s_m2 - F_factor_L_n3_m3 * s_m3 + F_minus_factor_L_n3_n1 * s_n1
        + F_minus_factor_L_n3_n2 * s_n2;
    const real by_theta_x_part = n_x + B_1_4 * s_m1 - minus_B_2_4 * s_m2 - minus_B_3_4 * s_m3
        + B_4_4 * s_n1 - minus_B_5_4 * s_n2 + B_6_4 * s_n3;
    const real by_theta_x_part_2 = n_y - minus_B_1_5 * s_m1 + B_2_5 * s_m2 - minus_B_3_5 * s_m3
        + B_4_5 * s_n1 + B_5_5 * s_n2 - minus_B_6_5 * s_n3;
    const real by_theta_x_part_3 = n_z - minus_B_1_6 * s_m1 - minus_B_2_6 * s_m2 + B_3_6 * s_m3
        - minus_B_4_6 * s_n1 + B_5_6 * s_n2 + B_6_6 * s_n3;
    const real by_theta_x_2 = m_x + B_1_1 * s_m1 - minus_B_2_1 * s_m2 + B_3_1 * s_m3
        + B_4_1 * s_n1 - minus_B_5_1 * s_n2 + B_6_1 * s_n3 + e_by_theta_xx * by_theta_x_part
        + (e_by_theta_yx * by_theta_x_part_2 + e_by_theta_zx * by_theta_x_part_3);
    const real by_theta_y_2 = m_y + B_1_2 * s_m1 + B_2_2 * s_m2 - minus_B_3_2 * s_m3
        + B_4_2 * s_n1 + B_5_2 * s_n2 - minus_B_6_2 * s_n3 + e_by_theta_xy * by_theta_x_part
        + (e_by_theta_yy * by_theta_x_part_2 + e_by_theta_zy * by_theta_x_part_3);
    const real by_theta_z_2 = m_z - minus_B_1_3 * s_m1 + B_2_3 * s_m2 + B_3_3 * s_m3
        - minus_B_4_3 * s_n1 + B_5_3 * s_n2 + B_6_3 * s_n3 + e_by_theta_xz * by_theta_x_part
        + (e_by_theta_yz * by_theta_x_part_2 + e_by_theta_zz * by_theta_x_part_3);
    const real by_d_x_2 = D_xx * by_theta_x_part + D_xy * by_theta_x_part_2
        + D_xz * by_theta_x_part_3;
    const real by_d_y_2 = D_yx * by_theta_x_part + D_yy * by_theta_x_part_2
        + D_yz * by_theta_x_part_3;
    const real by_d_z_2 = D_zx * by_theta_x_part + D_zy * by_theta_x_part_2
        + D_zz * by_theta_x_part_3;
    const real by_rho_x_2 = D_xx * by_theta_x_2 + D_yx * by_theta_y_2 + D_zx * by_theta_z_2;
    const real by_rho_y_2 = D_xy * by_theta_x_2 + D_yy * by_theta_y_2 + D_zy * by_theta_z_2;
    const real by_rho_z_2 = D_xz * by_theta_x_2 + D_yz * by_theta_y_2 + D_zz * by_theta_z_2;
    const real force_on_end_x = start_R_xx * by_d_x_2 + start_R_xy * by_d_y_2
        + start_R_xz * by_d_z_2;
    const real force_on_end_y = start_R_yx * by_d_x_2 + start_R_yy * by_d_y_2
        + start_R_yz * by_d_z_2;
    const real force_on_end_z = start_R_zx * by_d_x_2 + start_R_zy * by_d_y_2
        + start_R_zz * by_d_z_2;
    out[90] = by_rho_rho_xx; /* K: end.wx,end.wx */
    out[91] = by_rho_rho_xy; /* K: end.wx,end.wy */
    out[92] = by_rho_rho_xz; /* K: end.wx,end.wz */
    out[103] = by_rho_rho_yy; /* K: end.wy,end.wy */
    out[104] = by_rho_rho_yz; /* K: end.wy,end.wz */
    out[116] = by_rho_rho_zz; /* K: end.wz,end.wz */
    out[102] = by_rho_rho_yx; /* K: end.wy,end.wx */
    out[114] = by_rho_rho_zx; /* K: end.wz,end.wx */
    out[115] = by_rho_rho_zy; /* K: end.wz,end.wy */
    out[18] = moment_by_start_xx; /* K: start.wx,end.wx */
    out[84] = moment_by_start_xx; /* K: end.wx,start.wx */
    out[30] = moment_by_start_xy; /* K: start.wy,end.wx */
    out[85] = moment_by_start_xy; /* K: end.wx,start.wy */
    out[42] = moment_by_start_xz; /* K: start.wz,end.wx */
    out[86] = moment_by_start_xz; /* K: end.wx,start.wz */
    out[19] = moment_by_start_yx; /* K: start.wx,end.wy */
    out[96] = moment_by_start_yx; /* K: end.wy,start.wx */
    out[31] = moment_by_start_yy; /* K: start.wy,end.wy */
    out[97] = moment_by_start_yy; /* K: end.wy,start.wy */
    out[43] = moment_by_start_yz; /* K: start.wz,end.wy */
    out[98] = moment_by_start_yz; /* K: end.wy,start.wz */
    out[20] = moment_by_start_zx; /* K: start.wx,end.wz */
    out[108] = moment_by_start_zx; /* K: end.wz,start.wx */
    out[32] = moment_by_start_zy; /* K: start.wy,end.wz */
    out[109] = moment_by_start_zy; /* K: end.wz,start.wy */
    out[44] = moment_by_start_zz; /* K: start.wz,end.wz */
    out[110] = moment_by_start_zz; /* K: end.wz,start.wz */
    out[51] = K_pp_xx; /* K: start.vx,start.vx */
    out[129] = K_pp_xx; /* K: end.vx,end.vx */
    out[52] = K_pp_xy; /* K: start.vx,start.vy */
    out[63] = K_pp_xy; /* K: start.vy,start.vx */
    out[130] = K_pp_xy; /* K: end.vx,end.vy */
    out[141] = K_pp_xy; /* K: end.vy,end.vx */
    out[53] = K_pp_xz; /* K: start.vx,start.vz */
    out[75] = K_pp_xz; /* K: start.vz,start.vx */
    out[131] = K_pp_xz; /* K: end.vx,end.vz */
    out[153] = K_pp_xz; /* K: end.vz,end.vx */
    out[64] = K_pp_yy; /* K: start.vy,start.vy */
    out[142] = K_pp_yy; /* K: end.vy,end.vy */
    out[65] = K_pp_yz; /* K: start.vy,start.vz */
    out[76] = K_pp_yz; /* K: start.vz,start.vy */
    out[143] = K_pp_yz; /* K: end.vy,end.vz */
    out[154] = K_pp_yz; /* K: end.vz,end.vy */
    out[77] = K_pp_zz; /* K: start.vz,start.vz */
    out[155] = K_pp_zz; /* K: end.vz,end.vz */
    out[93] = K_p2_xx; /* K: end.wx,end.vx */
    out[126] = K_p2_xx; /* K: end.vx,end.wx */
    out[105] = K_p2_xy; /* K: end.wy,end.vx */
    out[127] = K_p2_xy; /* K: end.vx,end.wy */
    out[117] = K_p2_xz; /* K: end.wz,end.vx */
    out[128] = K_p2_xz; /* K: end.vx,end.wz */
    out[94] = K_p2_yx; /* K: end.wx,end.vy */
    out[138] = K_p2_yx; /* K: end.vy,end.wx */
    out[106] = K_p2_yy; /* K: end.wy,end.vy */
    out[139] = K_p2_yy; /* K: end.vy,end.wy */
    out[118] = K_p2_yz; /* K: end.wz,end.vy */
    out[140] = K_p2_yz; /* K: end.vy,end.wz */
    out[95] = K_p2_zx; /* K: end.wx,end.vz */
    out[150] = K_p2_zx; /* K: end.vz,end.wx */
    out[107] = K_p2_zy; /* K: end.wy,end.vz */
    out[151] = K_p2_zy; /* K: end.vz,end.wy */
    out[119] = K_p2_zz; /* K: end.wz,end.vz */
    out[152] = K_p2_zz; /* K: end.vz,end.wz */
    out[21] = K_p1_xx; /* K: start.wx,end.vx */
    out[120] = K_p1_xx; /* K: end.vx,start.wx */
    out[33] = K_p1_xy; /* K: start.wy,end.vx */
    out[121] = K_p1_xy; /* K: end.vx,start.wy */
    out[45] = K_p1_xz; /* K: start.wz,end.vx */
    out[122] = K_p1_xz; /* K: end.vx,start.wz */
    out[22] = K_p1_yx; /* K: start.wx,end.vy */
    out[132] = K_p1_yx; /* K: end.vy,start.wx */
    out[34] = K_p1_yy; /* K: start.wy,end.vy */
    out[133] = K_p1_yy; /* K: end.vy,start.wy */
    out[46] = K_p1_yz; /* K: start.wz,end.vy */
    out[134] = K_p1_yz; /* K: end.vy,start.wz */
    out[23] = K_p1_zx; /* K: start.wx,end.vz */
    out[144] = K_p1_zx; /* K: end.vz,start.wx */
    out[35] = K_p1_zy; /* K: start.wy,end.vz */
    out[145] = K_p1_zy; /* K: end.vz,start.wy */
    out[47] = K_p1_zz; /* K: start.wz,end.vz */
    out[146] = K_p1_zz; /* K: end.vz,start.wz */
    /* K: start.wx,start.wx */
    out[12] = K_start_wx_start_wx_part - (r_xy * (r_xx * by_rho_z - r_xz * by_rho_x
        + moment_by_start_yx) + r_xz * (r_xy * by_rho_x - r_xx * by_rho_y + moment_by_start_zx));
    out[13] = K_start_wy_start_wx_part; /* K: start.wx,start.wy */
    out[14] = K_start_wz_start_wx_part; /* K: start.wx,start.wz */
    /* K: start.wy,start.wy */
    out[25] = d_x * force_by_start_zy - (d_z_times_by_d_z + d_x_times_by_d_x
        + d_z * force_by_start_xy) - r_yx * moment_turned_by_start_xy
        - (r_yy * moment_turned_by_start_yy + r_yz * moment_turned_by_start_zy);
    out[26] = K_start_wz_start_wy_part; /* K: start.wy,start.wz */
    /* K: start.wz,start.wz */
    out[38] = d_y * force_by_start_xz - (d_y_times_by_d_y + d_x_times_by_d_x
        + d_x * force_by_start_yz) - r_zx * moment_turned_by_start_xz
        - (r_zy * moment_turned_by_start_yz + r_zz * moment_turned_by_start_zz);
    /* K: start.wy,start.wx */
    out[24] = d_y * by_d_x - d_x_times_by_d_y - r_zx * by_rho_x - (r_zy * by_rho_y
        + r_zz * by_rho_z) + K_start_wy_start_wx_part;
    /* K: start.wz,start.wx */
    out[36] = d_z * by_d_x - d_x_times_by_d_z + r_yx * by_rho_x + (r_yy * by_rho_y
        + r_yz * by_rho_z) + K_start_wz_start_wx_part;
    /* K: start.wz,start.wy */
    out[37] = d_z * by_d_y - d_y_times_by_d_z - r_xx * by_rho_x - (r_xy * by_rho_y
        + r_xz * by_rho_z) + K_start_wz_start_wy_part;
    out[15] = minus_K_p1_xx; /* K: start.wx,start.vx */
    out[48] = minus_K_p1_xx; /* K: start.vx,start.wx */
    out[16] = minus_K_p1_yx; /* K: start.wx,start.vy */
    out[60] = minus_K_p1_yx; /* K: start.vy,start.wx */
    out[17] = minus_K_p1_zx; /* K: start.wx,start.vz */
    out[72] = minus_K_p1_zx; /* K: start.vz,start.wx */
    out[27] = minus_K_p1_xy; /* K: start.wy,start.vx */
    out[49] = minus_K_p1_xy; /* K: start.vx,start.wy */
    out[28] = minus_K_p1_yy; /* K: start.wy,start.vy */
    out[61] = minus_K_p1_yy; /* K: start.vy,start.wy */
    out[29] = minus_K_p1_zy; /* K: start.wy,start.vz */
    out[73] = minus_K_p1_zy; /* K: start.vz,start.wy */
    out[39] = minus_K_p1_xz; /* K: start.wz,start.vx */
    out[50] = minus_K_p1_xz; /* K: start.vx,start.wz */
    out[40] = minus_K_p1_yz; /* K: start.wz,start.vy */
    out[62] = minus_K_p1_yz; /* K: start.vy,start.wz */
    out[41] = minus_K_p1_zz; /* K: start.wz,start.vz */
    out[74] = minus_K_p1_zz; /* K: start.vz,start.wz */
    out[54] = minus_K_p2_xx; /* K: start.vx,end.wx */
    out[87] = minus_K_p2_xx; /* K: end.wx,start.vx */
    out[55] = minus_K_p2_xy; /* K: start.vx,end.wy */
    out[99] = minus_K_p2_xy; /* K: end.wy,start.vx */
    out[56] = minus_K_p2_xz; /* K: start.vx,end.wz */
    out[111] = minus_K_p2_xz; /* K: end.wz,start.vx */
    out[66] = minus_K_p2_yx; /* K: start.vy,end.wx */
    out[88] = minus_K_p2_yx; /* K: end.wx,start.vy */
    out[67] = minus_K_p2_yy; /* K: start.vy,end.wy */
    out[100] = minus_K_p2_yy; /* K: end.wy,start.vy */
    out[68] = minus_K_p2_yz; /* K: start.vy,end.wz */
    out[112] = minus_K_p2_yz; /* K: end.wz,start.vy */
    out[78] = minus_K_p2_zx; /* K: start.vz,end.wx */
    out[89] = minus_K_p2_zx; /* K: end.wx,start.vz */
    out[79] = minus_K_p2_zy; /* K: start.vz,end.wy */
    out[101] = minus_K_p2_zy; /* K: end.wy,start.vz */
    out[80] = minus_K_p2_zz; /* K: start.vz,end.wz */
    out[113] = minus_K_p2_zz; /* K: end.wz,start.vz */
    out[57] = minus_K_pp_xx; /* K: start.vx,end.vx */
    out[123] = minus_K_pp_xx; /* K: end.vx,start.vx */
    out[58] = minus_K_pp_xy; /* K: start.vx,end.vy */
    out[69] = minus_K_pp_xy; /* K: start.vy,end.vx */
    out[124] = minus_K_pp_xy; /* K: end.vx,start.vy */
    out[135] = minus_K_pp_xy; /* K: end.vy,start.vx */
    out[59] = minus_K_pp_xz; /* K: start.vx,end.vz */
    out[81] = minus_K_pp_xz; /* K: start.vz,end.vx */
    out[125] = minus_K_pp_xz; /* K: end.vx,start.vz */
    out[147] = minus_K_pp_xz; /* K: end.vz,start.vx */
    out[70] = minus_K_pp_yy; /* K: start.vy,end.vy */
    out[136] = minus_K_pp_yy; /* K: end.vy,start.vy */
    out[71] = minus_K_pp_yz; /* K: start.vy,end.vz */
    out[82] = minus_K_pp_yz; /* K: start.vz,end.vy */
    out[137] = minus_K_pp_yz; /* K: end.vy,start.vz */
    out[148] = minus_K_pp_yz; /* K: end.vz,start.vy */
    out[83] = minus_K_pp_zz; /* K: start.vz,end.vz */
    out[149] = minus_K_pp_zz; /* K: end.vz,start.vz */
    out[6] = by_rho_x_2; /* balance: end.wx [N*m] */
    out[7] = by_rho_y_2; /* balance: end.wy [N*m] */
    out[8] = by_rho_z_2; /* balance: end.wz [N*m] */
    out[9] = force_on_end_x; /* balance: end.vx [N] */
    out[10] = force_on_end_y; /* balance: end.vy [N] */
    out[11] = force_on_end_z; /* balance: end.vz [N] */
    /* balance: start.wx [N*m] */
    out[0] = d_z * by_d_y_2 - d_y * by_d_z_2 - r_xx * by_rho_x_2 - (r_xy * by_rho_y_2
        + r_xz * by_rho_z_2);
    /* balance: start.wy [N*m] */
    out[1] = d_x * by_d_z_2 - d_z * by_d_x_2 - r_yx * by_rho_x_2 - (r_yy * by_rho_y_2
        + r_yz * by_rho_z_2);
    /* balance: start.wz [N*m] */
    out[2] = d_y * by_d_x_2 - d_x * by_d_y_2 - r_zx * by_rho_x_2 - (r_zy * by_rho_y_2
        + r_zz * by_rho_z_2);
    out[3] = -force_on_end_x; /* balance: start.vx [N] */
    out[4] = -force_on_end_y; /* balance: start.vy [N] */
    out[5] = -force_on_end_z; /* balance: start.vz [N] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int hellinger_reissner__mixed_sizes[] = {156, 0, 18, 0, 14, 0, 6, 0, 0, 19, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
