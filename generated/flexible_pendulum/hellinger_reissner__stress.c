/*
 * hellinger_reissner__stress
 * Geometrically exact beam with a stress field in equilibrium and helicoidal strain
 * energy = y·s - s·F s / 2, F s = y, F = c + Aᵀ c A / 12, A = d(stress end to end) / ds
 * Source: Sonneville, Cardona and Brüls, CMAME 268 (2014) for the strain; Pian and Sumihara,
 *     IJNME 20 (1984) for stress fields; their union on SE(3) is our own
 * passes: reassociate
 *
 * Sizes: out 24, work 0, w 24
 * Operations per call: 514 = 288 mul, 118 add, 92 sub, 7 div, 4 neg, 4 select, 1 lt
 * Operations of prepare: 30 = 18 div, 6 add, 6 mul
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
 * Input p (19): parameters, read by prepare_ only
 *
 * Output stress (4 x 6): out[0 ... 23], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_hellinger_reissner__stress(const wreal *p, wreal *CARDAN_RESTRICT w)
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
    const wreal GJ_inverse = 1.0 / GJ;
    const wreal EI2_inverse = 1.0 / EI2;
    const wreal EI3_inverse = 1.0 / EI3;
    const wreal EA_inverse = 1.0 / EA;
    const wreal GA2_inverse = 1.0 / GA2;
    const wreal GA3_inverse = 1.0 / GA3;
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
    w[18] = GJ_inverse;
    w[19] = EI2_inverse;
    w[20] = EI3_inverse;
    w[21] = EA_inverse;
    w[22] = GA2_inverse;
    w[23] = GA3_inverse;
}

#include "lanes.h"

/* Geometrically exact beam with a stress field in equilibrium and helicoidal strain */
CARDAN_API int hellinger_reissner__stress(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
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
    const real one_minus_start_qx_times_twice_start_qx = 1.0 - start_qx * twice_start_qx;
    const real relative_w = start_qw * end_qw + start_qx * end_qx + (start_qy * end_qy
        + start_qz * end_qz);
    const real relative_x = start_qw * end_qx - start_qx * end_qw + (start_qz * end_qy
        - start_qy * end_qz);
    const real relative_y = start_qw * end_qy + start_qx * end_qz - (start_qy * end_qw
        + start_qz * end_qx);
    const real relative_z = start_qw * end_qz - start_qx * end_qy + (start_qy * end_qx
        - start_qz * end_qw);
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
    const real half_theta_z = 0.5 * theta_z;
    const real half_theta_y = 0.5 * theta_y;
    const real half_theta_x = 0.5 * theta_x;
    const real a_times_theta_skew_squared_xy = theta_x * theta_y * a;
    const real a_times_theta_skew_squared_xz = theta_x * theta_z * a;
    const real a_times_theta_skew_squared_yz = theta_y * theta_z * a;
    const real apart_x = end_px - start_px;
    const real apart_y = end_py - start_py;
    const real apart_z = end_pz - start_pz;
    const real d_x = (start_qw_times_twice_start_qz + start_qx_times_twice_start_qy) * apart_y
        + (start_qx_times_twice_start_qz - start_qw_times_twice_start_qy) * apart_z + (1.0
        - start_qy_times_twice_start_qy - start_qz_times_twice_start_qz) * apart_x;
    const real d_y = (start_qx_times_twice_start_qy - start_qw_times_twice_start_qz) * apart_x
        + (start_qw_times_twice_start_qx + start_qy_times_twice_start_qz) * apart_z
        + (one_minus_start_qx_times_twice_start_qx - start_qz_times_twice_start_qz) * apart_y;
    const real d_z = (start_qw_times_twice_start_qy + start_qx_times_twice_start_qz) * apart_x
        + (start_qy_times_twice_start_qz - start_qw_times_twice_start_qx) * apart_y
        + (one_minus_start_qx_times_twice_start_qx - start_qy_times_twice_start_qy) * apart_z;

    /* strain */
    /* strain = e: U d, U = 1 + first [theta] + second [theta]² */
    const real e_x = (1.0 + a * (theta_x_squared - theta_squared)) * d_x + (half_theta_z
        + a_times_theta_skew_squared_xy) * d_y + (a_times_theta_skew_squared_xz
        - half_theta_y) * d_z;
    const real e_y = (a_times_theta_skew_squared_xy - half_theta_z) * d_x + (1.0
        + a * (theta_y_squared - theta_squared)) * d_y + (half_theta_x
        + a_times_theta_skew_squared_yz) * d_z;
    const real e_z = (half_theta_y + a_times_theta_skew_squared_xz) * d_x
        + (a_times_theta_skew_squared_yz - half_theta_x) * d_y + (1.0 + a * (theta_z_squared
        - theta_squared)) * d_z;

    /* stress */
    /* stress = s: F s = y, y = (theta, e) - free */
    const wreal free_K1 = w[0];
    const wreal free_K2 = w[1];
    const wreal free_K3 = w[2];
    const wreal free_E1 = w[3];
    const wreal free_E2 = w[4];
    const wreal free_E3 = w[5];
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
    const wreal GJ_inverse = w[18];
    const wreal EI2_inverse = w[19];
    const wreal EI3_inverse = w[20];
    const wreal EA_inverse = w[21];
    const wreal GA2_inverse = w[22];
    const wreal GA3_inverse = w[23];
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
    const real minus_F_1_6 = e_x * half_turned_1_2;
    const real minus_F_2_6 = e_y * minus_half_turned_2_1;
    const real F_3_6 = e_y * half_turned_3_1 + e_x * minus_half_turned_3_2;
    const real minus_F_4_6 = e_x * half_turned_4_2 + theta_x * half_turned_4_5;
    const real minus_F_5_6 = e_y * minus_half_turned_5_1 + theta_y * minus_half_turned_5_4;
    const real y_E3 = e_z - free_E3;
    const real F_factor_D_inverse_n3 = 1.0 / (c_6_6 + theta_y * twelfth_4_4 * theta_y
        + theta_x * twelfth_5_5 * theta_x + e_y * twelfth_1_1 * e_y + e_x * twelfth_2_2 * e_x);
    const real F_minus_factor_L_n3_n2 = minus_F_5_6 * F_factor_D_inverse_n3;
    const real F_minus_factor_DL_n2_m1 = e_x * minus_half_turned_1_3
        + minus_F_1_6 * F_minus_factor_L_n3_n2;
    const real F_factor_DL_n2_m2 = e_z * minus_half_turned_2_1 + e_x * half_turned_2_3
        - minus_F_2_6 * F_minus_factor_L_n3_n2;
    const real F_factor_DL_n2_m3 = F_3_6 * F_minus_factor_L_n3_n2 - e_z * half_turned_3_1;
    const real F_minus_factor_DL_n2_n1 = e_x * minus_half_turned_4_3
        + theta_x * minus_half_turned_4_6 + minus_F_4_6 * F_minus_factor_L_n3_n2;
    const real F_minus_factor_L_n3_n1 = minus_F_4_6 * F_factor_D_inverse_n3;
    const real F_factor_L_n3_m3 = F_3_6 * F_factor_D_inverse_n3;
    const real F_minus_factor_L_n3_m2 = minus_F_2_6 * F_factor_D_inverse_n3;
    const real F_minus_factor_L_n3_m1 = minus_F_1_6 * F_factor_D_inverse_n3;
    const real F_factor_D_inverse_n2 = 1.0 / (c_5_5 + theta_z * minus_half_turned_5_4
        + theta_x * twelfth_6_6 * theta_x + e_z * minus_half_turned_5_1 + e_x * twelfth_3_3 * e_x
        - minus_F_5_6 * F_minus_factor_L_n3_n2);
    const real F_minus_factor_L_n2_n1 = F_minus_factor_DL_n2_n1 * F_factor_D_inverse_n2;
    const real F_factor_DL_n1_m1 = e_z * half_turned_1_2 + e_y * minus_half_turned_1_3
        - minus_F_1_6 * F_minus_factor_L_n3_n1 - F_minus_factor_DL_n2_m1 * F_minus_factor_L_n2_n1;
    const real F_factor_DL_n1_m2 = F_factor_DL_n2_m2 * F_minus_factor_L_n2_n1
        - (e_y * half_turned_2_3 + minus_F_2_6 * F_minus_factor_L_n3_n1);
    const real F_factor_DL_n1_m3 = F_3_6 * F_minus_factor_L_n3_n1 - e_z * minus_half_turned_3_2
        + F_factor_DL_n2_m3 * F_minus_factor_L_n2_n1;
    const real F_factor_L_n2_m3 = F_factor_DL_n2_m3 * F_factor_D_inverse_n2;
    const real F_factor_L_n2_m2 = F_factor_DL_n2_m2 * F_factor_D_inverse_n2;
    const real F_minus_factor_L_n2_m1 = F_minus_factor_DL_n2_m1 * F_factor_D_inverse_n2;
    const real F_factor_D_inverse_n1 = 1.0 / (c_4_4 + theta_z * half_turned_4_5
        + theta_y * minus_half_turned_4_6 + e_z * half_turned_4_2 + e_y * minus_half_turned_4_3
        - minus_F_4_6 * F_minus_factor_L_n3_n1 - F_minus_factor_DL_n2_n1 * F_minus_factor_L_n2_n1);
    const real F_factor_L_n1_m3 = F_factor_DL_n1_m3 * F_factor_D_inverse_n1;
    const real F_factor_DL_m3_m1 = minus_F_1_6 * F_factor_L_n3_m3 - theta_x * half_turned_1_2
        + F_minus_factor_DL_n2_m1 * F_factor_L_n2_m3 - F_factor_DL_n1_m1 * F_factor_L_n1_m3;
    const real F_factor_DL_m3_m2 = minus_F_2_6 * F_factor_L_n3_m3
        - theta_y * minus_half_turned_2_1 - F_factor_DL_n2_m2 * F_factor_L_n2_m3
        - F_factor_DL_n1_m2 * F_factor_L_n1_m3;
    const real F_factor_L_n1_m2 = F_factor_DL_n1_m2 * F_factor_D_inverse_n1;
    const real F_factor_L_n1_m1 = F_factor_DL_n1_m1 * F_factor_D_inverse_n1;
    const real F_factor_D_inverse_m3 = 1.0 / (c_3_3 + theta_y * half_turned_3_1
        + theta_x * minus_half_turned_3_2 - F_3_6 * F_factor_L_n3_m3
        - F_factor_DL_n2_m3 * F_factor_L_n2_m3 - F_factor_DL_n1_m3 * F_factor_L_n1_m3);
    const real F_factor_L_m3_m2 = F_factor_DL_m3_m2 * F_factor_D_inverse_m3;
    const real F_factor_DL_m2_m1 = F_minus_factor_DL_n2_m1 * F_factor_L_n2_m2
        - (theta_x * minus_half_turned_1_3 + minus_F_1_6 * F_minus_factor_L_n3_m2)
        - F_factor_DL_n1_m1 * F_factor_L_n1_m2 - F_factor_DL_m3_m1 * F_factor_L_m3_m2;
    const real F_factor_L_m3_m1 = F_factor_DL_m3_m1 * F_factor_D_inverse_m3;
    const real F_factor_D_inverse_m2 = 1.0 / (c_2_2 + theta_z * minus_half_turned_2_1
        + theta_x * half_turned_2_3 - minus_F_2_6 * F_minus_factor_L_n3_m2
        - F_factor_DL_n2_m2 * F_factor_L_n2_m2 - F_factor_DL_n1_m2 * F_factor_L_n1_m2
        - F_factor_DL_m3_m2 * F_factor_L_m3_m2);
    const real F_factor_L_m2_m1 = F_factor_DL_m2_m1 * F_factor_D_inverse_m2;
    const real F_factor_D_m1_part = c_1_1 + theta_z * half_turned_1_2
        + theta_y * minus_half_turned_1_3 - minus_F_1_6 * F_minus_factor_L_n3_m1
        - F_minus_factor_DL_n2_m1 * F_minus_factor_L_n2_m1 - F_factor_DL_n1_m1 * F_factor_L_n1_m1
        - F_factor_DL_m3_m1 * F_factor_L_m3_m1;
    const real y_E3_times_F_minus_factor_L_n3_n2_plus_e_y_minus_free_E2 = e_y - free_E2
        + y_E3 * F_minus_factor_L_n3_n2;
    const real s_m1_part = e_x - free_E1 + y_E3 * F_minus_factor_L_n3_n1
        + F_minus_factor_L_n2_n1 * y_E3_times_F_minus_factor_L_n3_n2_plus_e_y_minus_free_E2;
    const real s_m1_part_2 = theta_z - free_K3 - y_E3 * F_factor_L_n3_m3
        - F_factor_L_n2_m3 * y_E3_times_F_minus_factor_L_n3_n2_plus_e_y_minus_free_E2
        - F_factor_L_n1_m3 * s_m1_part;
    const real s_m1_part_3 = theta_y - free_K2 + y_E3 * F_minus_factor_L_n3_m2
        - F_factor_L_n2_m2 * y_E3_times_F_minus_factor_L_n3_n2_plus_e_y_minus_free_E2
        - F_factor_L_n1_m2 * s_m1_part - F_factor_L_m3_m2 * s_m1_part_2;
    const real s_m1_part_4 = theta_x - free_K1 + y_E3 * F_minus_factor_L_n3_m1
        + F_minus_factor_L_n2_m1 * y_E3_times_F_minus_factor_L_n3_n2_plus_e_y_minus_free_E2
        - F_factor_L_n1_m1 * s_m1_part - F_factor_L_m3_m1 * s_m1_part_2
        - F_factor_L_m2_m1 * s_m1_part_3;
    const real s_m1 = 1.0 / (F_factor_D_m1_part
        - F_factor_DL_m2_m1 * F_factor_L_m2_m1) * s_m1_part_4;
    const real s_m2 = F_factor_D_inverse_m2 * s_m1_part_3 - F_factor_L_m2_m1 * s_m1;
    const real s_m3 = F_factor_D_inverse_m3 * s_m1_part_2 - F_factor_L_m3_m1 * s_m1
        - F_factor_L_m3_m2 * s_m2;
    const real s_n1 = F_factor_D_inverse_n1 * s_m1_part - F_factor_L_n1_m1 * s_m1
        - F_factor_L_n1_m2 * s_m2 - F_factor_L_n1_m3 * s_m3;
    const real s_n2 = F_factor_D_inverse_n2 *
        y_E3_times_F_minus_factor_L_n3_n2_plus_e_y_minus_free_E2 + F_minus_factor_L_n2_m1 * s_m1
        - F_factor_L_n2_m2 * s_m2 - F_factor_L_n2_m3 * s_m3 + F_minus_factor_L_n2_n1 * s_n1;
    const real s_n3 = y_E3 * F_factor_D_inverse_n3 + F_minus_factor_L_n3_m1 * s_m1
        + F_minus_factor_L_n3_m2 * s_m2 - F_factor_L_n3_m3 * s_m3 + F_minus_factor_L_n3_n1 * s_n1
        + F_minus_factor_L_n3_n2 * s_n2;
    const real half_t_m1 = 0.5 * (theta_y * s_m3 - theta_z * s_m2 - e_z * s_n2 + e_y * s_n3);
    const real half_t_m2 = 0.5 * (theta_z * s_m1 - theta_x * s_m3 + e_z * s_n1 - e_x * s_n3);
    const real half_t_m3 = 0.5 * (theta_x * s_m2 - theta_y * s_m1 - e_y * s_n1 + e_x * s_n2);
    const real half_t_n1 = 0.5 * (theta_y * s_n3 - theta_z * s_n2);
    const real half_t_n2 = 0.5 * (theta_z * s_n1 - theta_x * s_n3);
    const real half_t_n3 = 0.5 * (theta_x * s_n2 - theta_y * s_n1);
    const real s_m1_plus_half_t_m1 = s_m1 + half_t_m1;
    const real s_m2_plus_half_t_m2 = s_m2 + half_t_m2;
    const real s_m3_plus_half_t_m3 = s_m3 + half_t_m3;
    const real s_n1_plus_half_t_n1 = s_n1 + half_t_n1;
    const real s_n2_plus_half_t_n2 = s_n2 + half_t_n2;
    const real s_n3_plus_half_t_n3 = s_n3 + half_t_n3;
    const real s_m1_minus_half_t_m1 = s_m1 - half_t_m1;
    const real s_m2_minus_half_t_m2 = s_m2 - half_t_m2;
    const real s_m3_minus_half_t_m3 = s_m3 - half_t_m3;
    const real s_n1_minus_half_t_n1 = s_n1 - half_t_n1;
    const real s_n2_minus_half_t_n2 = s_n2 - half_t_n2;
    const real s_n3_minus_half_t_n3 = s_n3 - half_t_n3;
    out[0] = s_m1_plus_half_t_m1; /* stress: start.m1 [N*m] */
    out[1] = s_m2_plus_half_t_m2; /* stress: start.m2 [N*m] */
    out[2] = s_m3_plus_half_t_m3; /* stress: start.m3 [N*m] */
    out[3] = s_n1_plus_half_t_n1; /* stress: start.n1 [N] */
    out[4] = s_n2_plus_half_t_n2; /* stress: start.n2 [N] */
    out[5] = s_n3_plus_half_t_n3; /* stress: start.n3 [N] */
    out[6] = s_m1_minus_half_t_m1; /* stress: end.m1 [N*m] */
    out[7] = s_m2_minus_half_t_m2; /* stress: end.m2 [N*m] */
    out[8] = s_m3_minus_half_t_m3; /* stress: end.m3 [N*m] */
    out[9] = s_n1_minus_half_t_n1; /* stress: end.n1 [N] */
    out[10] = s_n2_minus_half_t_n2; /* stress: end.n2 [N] */
    out[11] = s_n3_minus_half_t_n3; /* stress: end.n3 [N] */
    out[12] = s_m1_plus_half_t_m1 * GJ_inverse; /* stress: start.K1 [rad/m] */
    out[13] = s_m2_plus_half_t_m2 * EI2_inverse; /* stress: start.K2 [rad/m] */
    out[14] = s_m3_plus_half_t_m3 * EI3_inverse; /* stress: start.K3 [rad/m] */
    out[15] = s_n1_plus_half_t_n1 * EA_inverse; /* stress: start.E1 */
    out[16] = s_n2_plus_half_t_n2 * GA2_inverse; /* stress: start.E2 */
    out[17] = s_n3_plus_half_t_n3 * GA3_inverse; /* stress: start.E3 */
    out[18] = s_m1_minus_half_t_m1 * GJ_inverse; /* stress: end.K1 [rad/m] */
    out[19] = s_m2_minus_half_t_m2 * EI2_inverse; /* stress: end.K2 [rad/m] */
    out[20] = s_m3_minus_half_t_m3 * EI3_inverse; /* stress: end.K3 [rad/m] */
    out[21] = s_n1_minus_half_t_n1 * EA_inverse; /* stress: end.E1 */
    out[22] = s_n2_minus_half_t_n2 * GA2_inverse; /* stress: end.E2 */
    out[23] = s_n3_minus_half_t_n3 * GA3_inverse; /* stress: end.E3 */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int hellinger_reissner__stress_sizes[] = {24, 0, 24, 0, 14, 0, 0, 0, 0, 19, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
