/*
 * hellinger_reissner_tree__balance_tangent
 * Geometrically exact beam with a stress field in equilibrium and helicoidal strain
 * Source: Sonneville, Cardona and Brüls, CMAME 268 (2014) for the strain; Pian and Sumihara,
 *     IJNME 20 (1984) for stress fields; their union on SE(3) is our own
 * passes: reassociate
 *
 * Sizes: out 49, work 0, w 18
 * Operations per call: 2118 = 1179 mul, 623 add, 281 sub, 13 select, 9 div, 5 lt, 5 neg, 1 cos,
 *     1 sin, 1 sqrt
 * Operations of prepare: 24 = 12 div, 6 add, 6 mul
 *
 * Input q (8): generalized coordinates
 *   q[0]  joint1 [rad]
 *   q[1]  node.qw
 *   q[2]  node.qx
 *   q[3]  node.qy
 *   q[4]  node.qz
 *   q[5]  node.px [m]
 *   q[6]  node.py [m]
 *   q[7]  node.pz [m]
 *
 * Input p (19): parameters, read by prepare_ only
 *
 * Output K (7 x 7): out[0 ... 48], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_hellinger_reissner_tree__balance_tangent(const wreal *p,
    wreal *CARDAN_RESTRICT w)
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
CARDAN_API int hellinger_reissner_tree__balance_tangent(const cardan_in *in,
    real *CARDAN_RESTRICT out, real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const wreal *const w = in->w;
    (void)work;

    /* joint1: R */
    /* R = R_fixed R_joint(q) */
    const real joint1_q = q[0]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {joint1_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real joint1_cos = cosine[0];
    const real joint1_sin = sine[0];

    /* pose */
    /* pose = theta, d: exp[theta] = R_1ᵀ R_2 = r, d = R_1ᵀ (p_2 - p_1) */
    const real node_qw = q[1];
    const real node_qx = q[2];
    const real node_qy = q[3];
    const real node_qz = q[4];
    const real node_px = q[5]; /* m */
    const real node_pz = q[7]; /* m */
    const real joint1_cos_plus_cos_plus_two = joint1_cos + 2.0 + joint1_cos;
    const real joint1_cos_minus_one = joint1_cos - 1.0;
    const real minus_twice_sum_joint1_cos_minus_one = -(joint1_cos_minus_one
        + joint1_cos_minus_one);
    const real twice_joint1_sin = joint1_sin + joint1_sin;
    const real joint1_cos_plus_cos_plus_two_lt_zero = cardan_lt(joint1_cos_plus_cos_plus_two, 0.0);
    const real relative_w_part = cardan_select(joint1_cos_plus_cos_plus_two_lt_zero, 0.0,
        joint1_cos_plus_cos_plus_two);
    const real relative_w_part_2 = cardan_lt(relative_w_part, minus_twice_sum_joint1_cos_minus_one);
    const real relative_w_part_3 = cardan_select(relative_w_part_2,
        minus_twice_sum_joint1_cos_minus_one, relative_w_part);
    const real relative_w_part_4 = cardan_lt(relative_w_part_3, 0.0);
    const real relative_w_part_5 = cardan_select(relative_w_part_4, 0.0,
        cardan_select(relative_w_part_2, twice_joint1_sin, relative_w_part));
    const real relative_w_part_6 = 2.0 * cardan_sqrt(cardan_select(relative_w_part_4, 0.0,
        relative_w_part_3));
    const real relative_w_part_7 = cardan_select(cardan_lt(relative_w_part_5, 0.0),
        -1.0 / relative_w_part_6, 1.0 / relative_w_part_6);
    const real relative_w_part_8 = relative_w_part_5 * relative_w_part_7;
    const real relative_w_part_9 = cardan_select(relative_w_part_4, 0.0,
        cardan_select(relative_w_part_2, minus_twice_sum_joint1_cos_minus_one,
        cardan_select(joint1_cos_plus_cos_plus_two_lt_zero, 0.0,
        twice_joint1_sin))) * relative_w_part_7;
    const real relative_w = node_qw * relative_w_part_8 + node_qy * relative_w_part_9;
    const real relative_x = node_qx * relative_w_part_8 - node_qz * relative_w_part_9;
    const real relative_y = node_qy * relative_w_part_8 - node_qw * relative_w_part_9;
    const real relative_z = node_qz * relative_w_part_8 + node_qx * relative_w_part_9;
    const real twice_relative_x = 2.0 * relative_x;
    const real twice_relative_z = 2.0 * relative_z;
    const real r_yx = relative_w * twice_relative_z + 2.0 * relative_y * relative_x;
    const real r_yy = 1.0 - relative_x * twice_relative_x - relative_z * twice_relative_z;
    const real r_yz = relative_y * twice_relative_z - relative_w * twice_relative_x;
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
    const real d_x = joint1_cos * node_px - joint1_sin * node_pz;
    const real d_z = joint1_sin * node_px + joint1_cos * node_pz;

    /* strain */
    /* strain = e: U d, U = 1 + first [theta] + second [theta]² */
    const real node_py = q[6]; /* m */
    const real e_x = D_xx * d_x + node_py * D_yx + D_zx * d_z;
    const real e_y = D_xy * d_x + node_py * D_yy + D_zy * d_z;
    const real e_z = D_xz * d_x + node_py * D_yz + D_zz * d_z;

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
    const real F_factor_D_inverse_m1 = 1.0 / (F_factor_D_m1_part
        - F_factor_DL_m2_m1 * F_factor_L_m2_m1);
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
    const real s_m1 = F_factor_D_inverse_m1 * (theta_x - free_K1 + y_E3 * F_minus_factor_L_n3_m1
        + F_minus_factor_L_n2_m1 * y_E3_times_F_minus_factor_L_n3_n2_plus_e_y_minus_free_E2
        - F_factor_L_n1_m1 * s_m1_part - F_factor_L_m3_m1 * s_m1_part_2
        - F_factor_L_m2_m1 * s_m1_part_3);
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
    const real tau_K1 = twelfth_1_1 * (theta_y * s_m3 - theta_z * s_m2 - e_z * s_n2 + e_y * s_n3);
    const real tau_K2 = twelfth_2_2 * (theta_z * s_m1 - theta_x * s_m3 + e_z * s_n1 - e_x * s_n3);
    const real tau_K3 = twelfth_3_3 * (theta_x * s_m2 - theta_y * s_m1 - e_y * s_n1 + e_x * s_n2);
    const real tau_E1 = twelfth_4_4 * (theta_y * s_n3 - theta_z * s_n2);
    const real tau_E2 = twelfth_5_5 * (theta_z * s_n1 - theta_x * s_n3);
    const real tau_E3 = twelfth_6_6 * (theta_x * s_n2 - theta_y * s_n1);
    const real tau_by_strain_1_2 = twelfth_1_1 * s_m3;
    const real minus_tau_by_strain_1_3 = twelfth_1_1 * s_m2;
    const real tau_by_strain_1_5 = twelfth_1_1 * s_n3;
    const real minus_tau_by_strain_1_6 = twelfth_1_1 * s_n2;
    const real minus_tau_by_strain_2_1 = twelfth_2_2 * s_m3;
    const real tau_by_strain_2_3 = twelfth_2_2 * s_m1;
    const real minus_tau_by_strain_2_4 = twelfth_2_2 * s_n3;
    const real tau_by_strain_2_6 = twelfth_2_2 * s_n1;
    const real tau_by_strain_3_1 = twelfth_3_3 * s_m2;
    const real minus_tau_by_strain_3_2 = twelfth_3_3 * s_m1;
    const real tau_by_strain_3_4 = twelfth_3_3 * s_n2;
    const real minus_tau_by_strain_3_5 = twelfth_3_3 * s_n1;
    const real tau_by_strain_4_2 = twelfth_4_4 * s_n3;
    const real minus_tau_by_strain_4_3 = twelfth_4_4 * s_n2;
    const real minus_tau_by_strain_5_1 = twelfth_5_5 * s_n3;
    const real tau_by_strain_5_3 = twelfth_5_5 * s_n1;
    const real tau_by_strain_6_1 = twelfth_6_6 * s_n2;
    const real minus_tau_by_strain_6_2 = twelfth_6_6 * s_n1;
    const real B_6_3 = e_y * minus_tau_by_strain_1_3 + e_x * tau_by_strain_2_3
        + theta_x * tau_by_strain_5_3 + theta_y * minus_tau_by_strain_4_3;
    const real B_6_1 = tau_E2 - (e_x * minus_tau_by_strain_2_1 + theta_x * minus_tau_by_strain_5_1);
    const real minus_B_6_2 = e_y * tau_by_strain_1_2 + theta_y * tau_by_strain_4_2 + tau_E1;
    const real B_6_4 = tau_K2 - e_x * minus_tau_by_strain_2_4;
    const real minus_B_6_5 = tau_K1 + e_y * tau_by_strain_1_5;
    const real B_6_6 = 1.0 + e_x * tau_by_strain_2_6 + e_y * minus_tau_by_strain_1_6;
    const real LB_1_5 = F_minus_factor_L_n3_n2 * B_6_1 - (e_x * tau_by_strain_3_1
        + theta_x * tau_by_strain_6_1 + tau_E3);
    const real LB_1_4 = e_z * minus_tau_by_strain_2_1 + e_y * tau_by_strain_3_1
        + theta_y * tau_by_strain_6_1 + theta_z * minus_tau_by_strain_5_1
        + F_minus_factor_L_n3_n1 * B_6_1 + F_minus_factor_L_n2_n1 * LB_1_5;
    const real LB_1_3 = tau_K2 - theta_x * minus_tau_by_strain_2_1 - F_factor_L_n3_m3 * B_6_1
        - F_factor_L_n2_m3 * LB_1_5 - F_factor_L_n1_m3 * LB_1_4;
    const real LB_1_2 = F_minus_factor_L_n3_m2 * B_6_1 - (tau_K3 + theta_x * tau_by_strain_3_1)
        - F_factor_L_n2_m2 * LB_1_5 - F_factor_L_n1_m2 * LB_1_4 - F_factor_L_m3_m2 * LB_1_3;
    const real LB_1_1 = 1.0 + theta_y * tau_by_strain_3_1 + theta_z * minus_tau_by_strain_2_1
        + F_minus_factor_L_n3_m1 * B_6_1 + F_minus_factor_L_n2_m1 * LB_1_5
        - F_factor_L_n1_m1 * LB_1_4 - F_factor_L_m3_m1 * LB_1_3 - F_factor_L_m2_m1 * LB_1_2;
    const real LB_2_5 = e_z * tau_by_strain_1_2 + e_x * minus_tau_by_strain_3_2
        + theta_x * minus_tau_by_strain_6_2 + theta_z * tau_by_strain_4_2
        - F_minus_factor_L_n3_n2 * minus_B_6_2;
    const real LB_2_4 = tau_E3 - (e_y * minus_tau_by_strain_3_2
        + theta_y * minus_tau_by_strain_6_2) - F_minus_factor_L_n3_n1 * minus_B_6_2
        + F_minus_factor_L_n2_n1 * LB_2_5;
    const real LB_2_3 = F_factor_L_n3_m3 * minus_B_6_2 - (tau_K1 + theta_y * tau_by_strain_1_2)
        - F_factor_L_n2_m3 * LB_2_5 - F_factor_L_n1_m3 * LB_2_4;
    const real LB_2_2 = 1.0 + theta_x * minus_tau_by_strain_3_2 + theta_z * tau_by_strain_1_2
        - F_minus_factor_L_n3_m2 * minus_B_6_2 - F_factor_L_n2_m2 * LB_2_5
        - F_factor_L_n1_m2 * LB_2_4 - F_factor_L_m3_m2 * LB_2_3;
    const real LB_2_1 = tau_K3 - theta_y * minus_tau_by_strain_3_2
        - F_minus_factor_L_n3_m1 * minus_B_6_2 + F_minus_factor_L_n2_m1 * LB_2_5
        - F_factor_L_n1_m1 * LB_2_4 - F_factor_L_m3_m1 * LB_2_3 - F_factor_L_m2_m1 * LB_2_2;
    const real LB_3_5 = F_minus_factor_L_n3_n2 * B_6_3 - (e_z * minus_tau_by_strain_1_3
        + theta_z * minus_tau_by_strain_4_3) + tau_E1;
    const real LB_3_4 = F_minus_factor_L_n3_n1 * B_6_3 - (e_z * tau_by_strain_2_3
        + theta_z * tau_by_strain_5_3) - tau_E2 + F_minus_factor_L_n2_n1 * LB_3_5;
    const real LB_3_3 = 1.0 + theta_x * tau_by_strain_2_3 + theta_y * minus_tau_by_strain_1_3
        - F_factor_L_n3_m3 * B_6_3 - F_factor_L_n2_m3 * LB_3_5 - F_factor_L_n1_m3 * LB_3_4;
    const real LB_3_2 = F_minus_factor_L_n3_m2 * B_6_3 - theta_z * minus_tau_by_strain_1_3
        + tau_K1 - F_factor_L_n2_m2 * LB_3_5 - F_factor_L_n1_m2 * LB_3_4
        - F_factor_L_m3_m2 * LB_3_3;
    const real LB_3_1 = F_minus_factor_L_n3_m1 * B_6_3 - theta_z * tau_by_strain_2_3 - tau_K2
        + F_minus_factor_L_n2_m1 * LB_3_5 - F_factor_L_n1_m1 * LB_3_4 - F_factor_L_m3_m1 * LB_3_3
        - F_factor_L_m2_m1 * LB_3_2;
    const real LB_4_5 = F_minus_factor_L_n3_n2 * B_6_4 - (tau_K3 + e_x * tau_by_strain_3_4);
    const real LB_4_4 = 1.0 + e_y * tau_by_strain_3_4 + e_z * minus_tau_by_strain_2_4
        + F_minus_factor_L_n3_n1 * B_6_4 + F_minus_factor_L_n2_n1 * LB_4_5;
    const real minus_LB_4_3 = theta_x * minus_tau_by_strain_2_4 + F_factor_L_n3_m3 * B_6_4
        + F_factor_L_n2_m3 * LB_4_5 + F_factor_L_n1_m3 * LB_4_4;
    const real LB_4_2 = F_minus_factor_L_n3_m2 * B_6_4 - theta_x * tau_by_strain_3_4
        - F_factor_L_n2_m2 * LB_4_5 - F_factor_L_n1_m2 * LB_4_4 + F_factor_L_m3_m2 * minus_LB_4_3;
    const real LB_4_1 = theta_z * minus_tau_by_strain_2_4 + theta_y * tau_by_strain_3_4
        + F_minus_factor_L_n3_m1 * B_6_4 + F_minus_factor_L_n2_m1 * LB_4_5
        - F_factor_L_n1_m1 * LB_4_4 + F_factor_L_m3_m1 * minus_LB_4_3 - F_factor_L_m2_m1 * LB_4_2;
    const real LB_5_5 = 1.0 + e_x * minus_tau_by_strain_3_5 + e_z * tau_by_strain_1_5
        - F_minus_factor_L_n3_n2 * minus_B_6_5;
    const real LB_5_4 = tau_K3 - e_y * minus_tau_by_strain_3_5
        - F_minus_factor_L_n3_n1 * minus_B_6_5 + F_minus_factor_L_n2_n1 * LB_5_5;
    const real LB_5_3 = F_factor_L_n3_m3 * minus_B_6_5 - theta_y * tau_by_strain_1_5
        - F_factor_L_n2_m3 * LB_5_5 - F_factor_L_n1_m3 * LB_5_4;
    const real LB_5_2 = theta_z * tau_by_strain_1_5 + theta_x * minus_tau_by_strain_3_5
        - F_minus_factor_L_n3_m2 * minus_B_6_5 - F_factor_L_n2_m2 * LB_5_5
        - F_factor_L_n1_m2 * LB_5_4 - F_factor_L_m3_m2 * LB_5_3;
    const real LB_5_1 = F_minus_factor_L_n2_m1 * LB_5_5 - (theta_y * minus_tau_by_strain_3_5
        + F_minus_factor_L_n3_m1 * minus_B_6_5) - F_factor_L_n1_m1 * LB_5_4
        - F_factor_L_m3_m1 * LB_5_3 - F_factor_L_m2_m1 * LB_5_2;
    const real LB_6_5 = F_minus_factor_L_n3_n2 * B_6_6 - e_z * minus_tau_by_strain_1_6 + tau_K1;
    const real LB_6_4 = F_minus_factor_L_n3_n1 * B_6_6 - e_z * tau_by_strain_2_6 - tau_K2
        + F_minus_factor_L_n2_n1 * LB_6_5;
    const real LB_6_3 = theta_y * minus_tau_by_strain_1_6 + theta_x * tau_by_strain_2_6
        - F_factor_L_n3_m3 * B_6_6 - F_factor_L_n2_m3 * LB_6_5 - F_factor_L_n1_m3 * LB_6_4;
    const real LB_6_2 = F_minus_factor_L_n3_m2 * B_6_6 - theta_z * minus_tau_by_strain_1_6
        - F_factor_L_n2_m2 * LB_6_5 - F_factor_L_n1_m2 * LB_6_4 - F_factor_L_m3_m2 * LB_6_3;
    const real LB_6_1 = F_minus_factor_L_n3_m1 * B_6_6 - theta_z * tau_by_strain_2_6
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
    const real by_strain_strain_1_4 = B_6_1 * DLB_4_6 - (s_m3 * minus_tau_by_strain_2_4
        + s_m2 * tau_by_strain_3_4) + LB_1_5 * DLB_4_5 + LB_1_4 * DLB_4_4
        - LB_1_3 * minus_DLB_4_3 + LB_1_2 * DLB_4_2 + LB_1_1 * DLB_4_1;
    const real by_strain_strain_1_5 = s_m2 * minus_tau_by_strain_3_5 - B_6_1 * minus_DLB_5_6
        + LB_1_5 * DLB_5_5 + LB_1_4 * DLB_5_4 + LB_1_3 * DLB_5_3 + LB_1_2 * DLB_5_2
        + LB_1_1 * DLB_5_1;
    const real by_strain_strain_1_6 = s_m3 * tau_by_strain_2_6 + B_6_1 * DLB_6_6
        + LB_1_5 * DLB_6_5 + LB_1_4 * DLB_6_4 + LB_1_3 * DLB_6_3 + LB_1_2 * DLB_6_2
        + LB_1_1 * DLB_6_1;
    const real by_strain_strain_2_4 = s_m1 * tau_by_strain_3_4 - minus_B_6_2 * DLB_4_6
        + LB_2_5 * DLB_4_5 + LB_2_4 * DLB_4_4 - LB_2_3 * minus_DLB_4_3 + LB_2_2 * DLB_4_2
        + LB_2_1 * DLB_4_1;
    const real by_strain_strain_2_5 = minus_B_6_2 * minus_DLB_5_6 - (s_m3 * tau_by_strain_1_5
        + s_m1 * minus_tau_by_strain_3_5) + LB_2_5 * DLB_5_5 + LB_2_4 * DLB_5_4
        + LB_2_3 * DLB_5_3 + LB_2_2 * DLB_5_2 + LB_2_1 * DLB_5_1;
    const real by_strain_strain_2_6 = s_m3 * minus_tau_by_strain_1_6 - minus_B_6_2 * DLB_6_6
        + LB_2_5 * DLB_6_5 + LB_2_4 * DLB_6_4 + LB_2_3 * DLB_6_3 + LB_2_2 * DLB_6_2
        + LB_2_1 * DLB_6_1;
    const real by_strain_strain_3_4 = s_m1 * minus_tau_by_strain_2_4 + B_6_3 * DLB_4_6
        + LB_3_5 * DLB_4_5 + LB_3_4 * DLB_4_4 - LB_3_3 * minus_DLB_4_3 + LB_3_2 * DLB_4_2
        + LB_3_1 * DLB_4_1;
    const real by_strain_strain_3_5 = s_m2 * tau_by_strain_1_5 - B_6_3 * minus_DLB_5_6
        + LB_3_5 * DLB_5_5 + LB_3_4 * DLB_5_4 + LB_3_3 * DLB_5_3 + LB_3_2 * DLB_5_2
        + LB_3_1 * DLB_5_1;
    const real by_strain_strain_3_6 = B_6_3 * DLB_6_6 - (s_m2 * minus_tau_by_strain_1_6
        + s_m1 * tau_by_strain_2_6) + LB_3_5 * DLB_6_5 + LB_3_4 * DLB_6_4 + LB_3_3 * DLB_6_3
        + LB_3_2 * DLB_6_2 + LB_3_1 * DLB_6_1;
    const real by_strain_strain_4_4 = B_6_4 * DLB_4_6 - (s_n3 * minus_tau_by_strain_2_4
        + s_n2 * tau_by_strain_3_4) + LB_4_5 * DLB_4_5 + LB_4_4 * DLB_4_4
        + minus_LB_4_3 * minus_DLB_4_3 + LB_4_2 * DLB_4_2 + LB_4_1 * DLB_4_1;
    const real by_strain_strain_4_5 = s_n2 * minus_tau_by_strain_3_5 - B_6_4 * minus_DLB_5_6
        + LB_4_5 * DLB_5_5 + LB_4_4 * DLB_5_4 - minus_LB_4_3 * DLB_5_3 + LB_4_2 * DLB_5_2
        + LB_4_1 * DLB_5_1;
    const real by_strain_strain_4_6 = s_n3 * tau_by_strain_2_6 + B_6_4 * DLB_6_6
        + LB_4_5 * DLB_6_5 + LB_4_4 * DLB_6_4 - minus_LB_4_3 * DLB_6_3 + LB_4_2 * DLB_6_2
        + LB_4_1 * DLB_6_1;
    const real by_strain_strain_5_5 = minus_B_6_5 * minus_DLB_5_6 - (s_n3 * tau_by_strain_1_5
        + s_n1 * minus_tau_by_strain_3_5) + LB_5_5 * DLB_5_5 + LB_5_4 * DLB_5_4
        + LB_5_3 * DLB_5_3 + LB_5_2 * DLB_5_2 + LB_5_1 * DLB_5_1;
    const real by_strain_strain_5_6 = s_n3 * minus_tau_by_strain_1_6 - minus_B_6_5 * DLB_6_6
        + LB_5_5 * DLB_6_5 + LB_5_4 * DLB_6_4 + LB_5_3 * DLB_6_3 + LB_5_2 * DLB_6_2
        + LB_5_1 * DLB_6_1;
    const real by_strain_strain_6_6 = B_6_6 * DLB_6_6 - (s_n2 * minus_tau_by_strain_1_6
        + s_n1 * tau_by_strain_2_6) + LB_6_5 * DLB_6_5 + LB_6_4 * DLB_6_4 + LB_6_3 * DLB_6_3
        + LB_6_2 * DLB_6_2 + LB_6_1 * DLB_6_1;
    const real n_x = s_n1 - s_n2 * tau_K3 + s_n3 * tau_K2;
    const real n_y = s_n2 + s_n1 * tau_K3 - s_n3 * tau_K1;
    const real n_z = s_n3 - s_n1 * tau_K2 + s_n2 * tau_K1;

    /* response */
    /* response = m, n: Dᵀ (by_theta + e_by_thetaᵀ by_e), Uᵀ by_e */
    const real theta_y_times_d_z = theta_y * d_z;
    const real node_py_times_theta_z = node_py * theta_z;
    const real theta_cross_d_x = theta_y_times_d_z - node_py_times_theta_z;
    const real theta_z_times_d_x = theta_z * d_x;
    const real theta_x_times_d_z = theta_x * d_z;
    const real theta_cross_d_y = theta_z_times_d_x - theta_x_times_d_z;
    const real node_py_times_theta_x = node_py * theta_x;
    const real theta_y_times_d_x = theta_y * d_x;
    const real theta_cross_d_z = node_py_times_theta_x - theta_y_times_d_x;
    const real theta_x_times_d_x = theta_x * d_x;
    const real node_py_times_theta_y = node_py * theta_y;
    const real theta_z_times_d_z = theta_z * d_z;
    const real theta_dot_d = theta_x_times_d_x + node_py_times_theta_y + theta_z_times_d_z;
    const real twice_a_slope = 2.0 * a_slope;
    const real U_d_slope_by_squared_x = (theta_y * theta_cross_d_z
        - theta_z * theta_cross_d_y) * twice_a_slope;
    const real U_d_slope_by_squared_y = (theta_z * theta_cross_d_x
        - theta_x * theta_cross_d_z) * twice_a_slope;
    const real U_d_slope_by_squared_z = (theta_x * theta_cross_d_y
        - theta_y * theta_cross_d_x) * twice_a_slope;
    const real half_d_z = 0.5 * d_z;
    const real half_node_py = 0.5 * node_py;
    const real half_d_x = 0.5 * d_x;
    const real e_by_theta_xx = a * (theta_x_times_d_x - 2.0 * theta_x_times_d_x + theta_dot_d)
        + theta_x * U_d_slope_by_squared_x;
    const real e_by_theta_xy = a * (node_py_times_theta_x - 2.0 * theta_y_times_d_x) - half_d_z
        + theta_y * U_d_slope_by_squared_x;
    const real e_by_theta_xz = a * (theta_x_times_d_z - 2.0 * theta_z_times_d_x) + half_node_py
        + theta_z * U_d_slope_by_squared_x;
    const real e_by_theta_yx = a * (theta_y_times_d_x - 2.0 * node_py_times_theta_x) + half_d_z
        + theta_x * U_d_slope_by_squared_y;
    const real e_by_theta_yy = a * (node_py_times_theta_y - 2.0 * node_py_times_theta_y
        + theta_dot_d) + theta_y * U_d_slope_by_squared_y;
    const real e_by_theta_yz = a * (theta_y_times_d_z - 2.0 * node_py_times_theta_z) - half_d_x
        + theta_z * U_d_slope_by_squared_y;
    const real e_by_theta_zx = a * (theta_z_times_d_x - 2.0 * theta_x_times_d_z) - half_node_py
        + theta_x * U_d_slope_by_squared_z;
    const real e_by_theta_zy = a * (node_py_times_theta_z - 2.0 * theta_y_times_d_z) + half_d_x
        + theta_y * U_d_slope_by_squared_z;
    const real e_by_theta_zz = a * (theta_z_times_d_z - 2.0 * theta_z_times_d_z + theta_dot_d)
        + theta_z * U_d_slope_by_squared_z;
    const real by_theta_x = n_x * e_by_theta_xx + n_y * e_by_theta_yx + (s_m1 - s_m2 * tau_K3
        - s_n2 * tau_E3 + (s_m3 * tau_K2 + s_n3 * tau_E2) + n_z * e_by_theta_zx);
    const real by_theta_y = n_x * e_by_theta_xy + n_y * e_by_theta_yy + (s_m2 + s_m1 * tau_K3
        + s_n1 * tau_E3 - (s_m3 * tau_K1 + s_n3 * tau_E1) + n_z * e_by_theta_zy);
    const real by_theta_z = s_m3 - s_m1 * tau_K2 + s_n2 * tau_E1 + n_y * e_by_theta_yz
        + (s_m2 * tau_K1 - s_n1 * tau_E2 + n_x * e_by_theta_xz + n_z * e_by_theta_zz);
    const real by_d_x = D_xx * n_x + D_xy * n_y + D_xz * n_z;
    const real by_d_z = D_zx * n_x + D_zy * n_y + D_zz * n_z;
    const real across_xx = by_strain_strain_1_4 + by_strain_strain_4_6 * e_by_theta_zx
        + (by_strain_strain_4_4 * e_by_theta_xx + by_strain_strain_4_5 * e_by_theta_yx);
    const real across_xy = by_strain_strain_1_5 + by_strain_strain_5_6 * e_by_theta_zx
        + (by_strain_strain_4_5 * e_by_theta_xx + by_strain_strain_5_5 * e_by_theta_yx);
    const real across_xz = by_strain_strain_1_6 + by_strain_strain_6_6 * e_by_theta_zx
        + (by_strain_strain_4_6 * e_by_theta_xx + by_strain_strain_5_6 * e_by_theta_yx);
    const real across_yx = by_strain_strain_2_4 + by_strain_strain_4_6 * e_by_theta_zy
        + (by_strain_strain_4_4 * e_by_theta_xy + by_strain_strain_4_5 * e_by_theta_yy);
    const real across_yy = by_strain_strain_2_5 + by_strain_strain_5_6 * e_by_theta_zy
        + (by_strain_strain_4_5 * e_by_theta_xy + by_strain_strain_5_5 * e_by_theta_yy);
    const real across_yz = by_strain_strain_2_6 + by_strain_strain_6_6 * e_by_theta_zy
        + (by_strain_strain_4_6 * e_by_theta_xy + by_strain_strain_5_6 * e_by_theta_yy);
    const real across_zx = by_strain_strain_3_4 + by_strain_strain_4_6 * e_by_theta_zz
        + (by_strain_strain_4_4 * e_by_theta_xz + by_strain_strain_4_5 * e_by_theta_yz);
    const real across_zy = by_strain_strain_3_5 + by_strain_strain_5_6 * e_by_theta_zz
        + (by_strain_strain_4_5 * e_by_theta_xz + by_strain_strain_5_5 * e_by_theta_yz);
    const real across_zz = by_strain_strain_3_6 + by_strain_strain_6_6 * e_by_theta_zz
        + (by_strain_strain_4_6 * e_by_theta_xz + by_strain_strain_5_6 * e_by_theta_yz);
    const real half_turned_xx = D_xx * by_strain_strain_4_4 + D_xz * by_strain_strain_4_6
        + D_xy * by_strain_strain_4_5;
    const real half_turned_xy = D_xx * by_strain_strain_4_5 + D_xz * by_strain_strain_5_6
        + D_xy * by_strain_strain_5_5;
    const real half_turned_xz = D_xx * by_strain_strain_4_6 + D_xz * by_strain_strain_6_6
        + D_xy * by_strain_strain_5_6;
    const real half_turned_yx = D_yx * by_strain_strain_4_4 + D_yz * by_strain_strain_4_6
        + D_yy * by_strain_strain_4_5;
    const real half_turned_yy = D_yx * by_strain_strain_4_5 + D_yz * by_strain_strain_5_6
        + D_yy * by_strain_strain_5_5;
    const real half_turned_yz = D_yx * by_strain_strain_4_6 + D_yz * by_strain_strain_6_6
        + D_yy * by_strain_strain_5_6;
    const real by_d_d_xx = D_xx * half_turned_xx + D_xz * half_turned_xz + D_xy * half_turned_xy;
    const real by_d_d_xy = D_yx * half_turned_xx + D_yz * half_turned_xz + D_yy * half_turned_xy;
    const real by_d_d_xz = D_zx * half_turned_xx + D_zz * half_turned_xz + D_zy * half_turned_xy;
    const real by_d_d_yz = D_zx * half_turned_yx + D_zz * half_turned_yz + D_zy * half_turned_yy;
    const real D_zx_times_half_turned_zx_plus_D_zz_times_half_turned_zz = D_zx * (D_zx *
        by_strain_strain_4_4 + D_zz * by_strain_strain_4_6 + D_zy * by_strain_strain_4_5)
        + D_zz * (D_zx * by_strain_strain_4_6 + D_zz * by_strain_strain_6_6
        + D_zy * by_strain_strain_5_6);
    const real by_d_d_zz = D_zy * (D_zx * by_strain_strain_4_5 + D_zz * by_strain_strain_5_6
        + D_zy * by_strain_strain_5_5) + D_zx_times_half_turned_zx_plus_D_zz_times_half_turned_zz;
    const real d_x_times_n_x = d_x * n_x;
    const real node_py_times_n_y = node_py * n_y;
    const real d_z_times_n_z = d_z * n_z;
    const real force_dot_d = d_x_times_n_x + node_py_times_n_y + d_z_times_n_z;
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
    const real bend_side_x = twice_a_slope * (n_x * theta_dot_d + d_x * theta_dot_force
        - theta_x * twice_force_dot_d)
        + theta_x * twice_a_bend_times_force_dot_theta_cross_theta_cross_d;
    const real bend_side_y = twice_a_slope * (n_y * theta_dot_d + node_py * theta_dot_force
        - theta_y * twice_force_dot_d)
        + theta_y * twice_a_bend_times_force_dot_theta_cross_theta_cross_d;
    const real bend_side_z = twice_a_slope * (n_z * theta_dot_d + d_z * theta_dot_force
        - theta_z * twice_force_dot_d)
        + theta_z * twice_a_bend_times_force_dot_theta_cross_theta_cross_d;
    const real bend_diagonal = a_slope * force_dot_theta_cross_theta_cross_d * 2.0
        - 2.0 * a * force_dot_d;
    const real bend_pair_xx = a * d_x_times_n_x + theta_x * bend_side_x;
    const real bend_pair_yy = a * node_py_times_n_y + theta_y * bend_side_y;
    const real bend_pair_zz = a * d_z_times_n_z + theta_z * bend_side_z;
    const real by_theta_theta_xx_part = F_factor_D_inverse_n3 * B_6_1 * B_6_1
        - (s_m3 * minus_tau_by_strain_2_1 + s_m2 * tau_by_strain_3_1 + s_n2 * tau_by_strain_6_1
        + s_n3 * minus_tau_by_strain_5_1) + F_factor_D_inverse_n2 * LB_1_5 * LB_1_5
        + F_factor_D_inverse_n1 * LB_1_4 * LB_1_4;
    const real by_theta_theta_xx_part_2 = F_factor_D_inverse_m3 * LB_1_3 * LB_1_3
        + by_theta_theta_xx_part + bend_diagonal + F_factor_D_inverse_m2 * LB_1_2 * LB_1_2
        + bend_pair_xx + by_strain_strain_1_6 * e_by_theta_zx
        + by_strain_strain_1_5 * e_by_theta_yx;
    const real by_theta_theta_xx = F_factor_D_inverse_m1 * LB_1_1 * LB_1_1 + bend_pair_xx
        + by_strain_strain_1_4 * e_by_theta_xx + by_theta_theta_xx_part_2
        + e_by_theta_zx * across_xz + (e_by_theta_xx * across_xx + e_by_theta_yx * across_xy);
    const real by_theta_theta_xy_part = node_py * n_x * a + d_x * n_y * a
        + (s_m2 * minus_tau_by_strain_3_2 + s_n2 * minus_tau_by_strain_6_2
        - B_6_1 * minus_DLB_2_6 + LB_1_5 * DLB_2_5) + LB_1_4 * DLB_2_4 + LB_1_3 * DLB_2_3
        + LB_1_2 * DLB_2_2 + LB_1_1 * DLB_2_1;
    const real by_theta_theta_xy_part_2 = by_strain_strain_1_4 * e_by_theta_xy
        + by_theta_theta_xy_part + (theta_x * bend_side_y + theta_y * bend_side_x
        + by_strain_strain_1_6 * e_by_theta_zy + by_strain_strain_1_5 * e_by_theta_yy)
        + e_by_theta_zx * across_yz;
    const real by_theta_theta_xy = e_by_theta_xx * across_yx + e_by_theta_yx * across_yy
        + by_theta_theta_xy_part_2;
    const real by_theta_theta_xz_part = LB_1_5 * DLB_3_5 + d_x * n_z * a
        + (s_m3 * tau_by_strain_2_3 + s_n3 * tau_by_strain_5_3 + B_6_1 * DLB_3_6 + d_z * n_x * a
        + LB_1_4 * DLB_3_4) + LB_1_3 * DLB_3_3 + LB_1_2 * DLB_3_2 + theta_x * bend_side_z;
    const real by_theta_theta_xz_part_2 = LB_1_1 * DLB_3_1 + theta_z * bend_side_x
        + by_theta_theta_xz_part + by_strain_strain_1_6 * e_by_theta_zz
        + (by_strain_strain_1_4 * e_by_theta_xz + by_strain_strain_1_5 * e_by_theta_yz)
        + e_by_theta_zx * across_zz;
    const real by_theta_theta_xz = e_by_theta_xx * across_zx + e_by_theta_yx * across_zy
        + by_theta_theta_xz_part_2;
    const real by_theta_theta_yy_part = minus_B_6_2 * minus_DLB_2_6 - (s_m3 * tau_by_strain_1_2
        + s_m1 * minus_tau_by_strain_3_2 + s_n1 * minus_tau_by_strain_6_2
        + s_n3 * tau_by_strain_4_2) + LB_2_5 * DLB_2_5 + LB_2_4 * DLB_2_4 + LB_2_3 * DLB_2_3
        + bend_diagonal;
    const real by_theta_theta_yy_part_2 = LB_2_1 * DLB_2_1 + bend_pair_yy
        + by_strain_strain_2_4 * e_by_theta_xy + (LB_2_2 * DLB_2_2 + by_theta_theta_yy_part
        + bend_pair_yy + by_strain_strain_2_6 * e_by_theta_zy
        + by_strain_strain_2_5 * e_by_theta_yy) + e_by_theta_zy * across_yz;
    const real by_theta_theta_yy = e_by_theta_xy * across_yx + e_by_theta_yy * across_yy
        + by_theta_theta_yy_part_2;
    const real by_theta_theta_yz_part = LB_2_5 * DLB_3_5 + node_py * n_z * a
        + (s_m3 * minus_tau_by_strain_1_3 + s_n3 * minus_tau_by_strain_4_3
        - minus_B_6_2 * DLB_3_6 + d_z * n_y * a + LB_2_4 * DLB_3_4) + LB_2_3 * DLB_3_3
        + LB_2_2 * DLB_3_2 + theta_y * bend_side_z;
    const real by_theta_theta_yz_part_2 = LB_2_1 * DLB_3_1 + theta_z * bend_side_y
        + by_theta_theta_yz_part + by_strain_strain_2_6 * e_by_theta_zz
        + (by_strain_strain_2_4 * e_by_theta_xz + by_strain_strain_2_5 * e_by_theta_yz)
        + e_by_theta_zy * across_zz;
    const real by_theta_theta_yz = e_by_theta_xy * across_zx + e_by_theta_yy * across_zy
        + by_theta_theta_yz_part_2;
    const real by_theta_theta_zz_part = B_6_3 * DLB_3_6 - (s_m2 * minus_tau_by_strain_1_3
        + s_m1 * tau_by_strain_2_3 + s_n1 * tau_by_strain_5_3 + s_n2 * minus_tau_by_strain_4_3)
        + LB_3_5 * DLB_3_5 + LB_3_4 * DLB_3_4 + LB_3_3 * DLB_3_3 + LB_3_2 * DLB_3_2 + bend_diagonal;
    const real by_theta_theta_zz_part_2 = LB_3_1 * DLB_3_1 + by_theta_theta_zz_part
        + bend_pair_zz + (bend_pair_zz + by_strain_strain_3_6 * e_by_theta_zz)
        + (by_strain_strain_3_4 * e_by_theta_xz + by_strain_strain_3_5 * e_by_theta_yz)
        + e_by_theta_zz * across_zz;
    const real by_theta_theta_zz = e_by_theta_xz * across_zx + e_by_theta_yz * across_zy
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
        + theta_dot_force) + theta_x * U_n_slope_by_squared_x + D_xz * across_xz
        + (D_xx * across_xx + D_xy * across_xy);
    const real by_d_theta_xy = a * (theta_x_times_n_y - 2.0 * theta_y_times_n_x) + half_n_z
        + theta_y * U_n_slope_by_squared_x + D_xz * across_yz + (D_xx * across_yx
        + D_xy * across_yy);
    const real by_d_theta_xz = a * (theta_x_times_n_z - 2.0 * theta_z_times_n_x) - half_n_y
        + theta_z * U_n_slope_by_squared_x + D_xz * across_zz + (D_xx * across_zx
        + D_xy * across_zy);
    const real by_d_theta_yx = a * (theta_y_times_n_x - 2.0 * theta_x_times_n_y) - half_n_z
        + theta_x * U_n_slope_by_squared_y + D_yz * across_xz + (D_yx * across_xx
        + D_yy * across_xy);
    const real by_d_theta_yy = a * (theta_y_times_n_y - 2.0 * theta_y_times_n_y
        + theta_dot_force) + theta_y * U_n_slope_by_squared_y + D_yz * across_yz
        + (D_yx * across_yx + D_yy * across_yy);
    const real by_d_theta_yz = a * (theta_y_times_n_z - 2.0 * theta_z_times_n_y) + half_n_x
        + theta_z * U_n_slope_by_squared_y + D_yz * across_zz + (D_yx * across_zx
        + D_yy * across_zy);
    const real by_d_theta_zx = a * (theta_z_times_n_x - 2.0 * theta_x_times_n_z) + half_n_y
        + theta_x * U_n_slope_by_squared_z + D_zz * across_xz + (D_zx * across_xx
        + D_zy * across_xy);
    const real by_d_theta_zy = a * (theta_z_times_n_y - 2.0 * theta_y_times_n_z) - half_n_x
        + theta_y * U_n_slope_by_squared_z + D_zz * across_yz + (D_zx * across_yx
        + D_zy * across_yy);
    const real by_d_theta_zz = a * (theta_z_times_n_z + theta_dot_force
        - 2.0 * theta_z_times_n_z) + theta_z * U_n_slope_by_squared_z + D_zz * across_zz
        + (D_zx * across_zx + D_zy * across_zy);
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
    /* K: node.u.py,node.u.py */
    out[40] = D_yx * half_turned_yx + D_yz * half_turned_yz + D_yy * half_turned_yy;
    out[8] = by_rho_rho_xx; /* K: node.u.x,node.u.x */
    out[9] = by_rho_rho_xy; /* K: node.u.x,node.u.y */
    out[10] = by_rho_rho_xz; /* K: node.u.x,node.u.z */
    out[16] = by_rho_rho_yy; /* K: node.u.y,node.u.y */
    out[17] = by_rho_rho_yz; /* K: node.u.y,node.u.z */
    out[24] = by_rho_rho_zz; /* K: node.u.z,node.u.z */
    out[15] = by_rho_rho_yx; /* K: node.u.y,node.u.x */
    out[22] = by_rho_rho_zx; /* K: node.u.z,node.u.x */
    out[23] = by_rho_rho_zy; /* K: node.u.z,node.u.y */
    out[12] = by_d_rho_yx; /* K: node.u.x,node.u.py */
    out[36] = by_d_rho_yx; /* K: node.u.py,node.u.x */
    out[19] = by_d_rho_yy; /* K: node.u.y,node.u.py */
    out[37] = by_d_rho_yy; /* K: node.u.py,node.u.y */
    out[26] = by_d_rho_yz; /* K: node.u.z,node.u.py */
    out[38] = by_d_rho_yz; /* K: node.u.py,node.u.z */

    /* tangent */
    /* tangent = d(loads) along theta_1, p_1, theta_2, p_2: rho = theta_2 - rᵀ theta_1 */
    const real force_by_start_xy = d_x * by_d_d_xz - d_z * by_d_d_xx - r_yx * by_d_rho_xx
        - (r_yy * by_d_rho_xy + r_yz * by_d_rho_xz);
    const real force_by_start_yy = d_x * by_d_d_yz - d_z * by_d_d_xy - r_yx * by_d_rho_yx
        - (r_yy * by_d_rho_yy + r_yz * by_d_rho_yz);
    const real force_by_start_zy = d_x * by_d_d_zz - d_z * by_d_d_xz - r_yx * by_d_rho_zx
        - (r_yy * by_d_rho_zy + r_yz * by_d_rho_zz);
    const real moment_by_start_xy = d_x * by_d_rho_zx - d_z * by_d_rho_xx - r_yx * by_rho_rho_xx
        - (r_yy * by_rho_rho_xy + r_yz * by_rho_rho_xz);
    const real moment_by_start_yy = d_x * by_d_rho_zy - d_z * by_d_rho_xy - r_yy * by_rho_rho_yy
        - (r_yx * by_rho_rho_yx + r_yz * by_rho_rho_yz);
    const real moment_by_start_zy = d_x * by_d_rho_zz - d_z * by_d_rho_xz - r_yz * by_rho_rho_zz
        - (r_yx * by_rho_rho_zx + r_yy * by_rho_rho_zy);
    const real joint1_sin_times_by_d_d_xz = joint1_sin * by_d_d_xz;
    const real half_turned_xx_2 = joint1_cos * by_d_d_xx + joint1_sin_times_by_d_d_xz;
    const real half_turned_xy_2 = joint1_cos * by_d_d_xy + joint1_sin * by_d_d_yz;
    const real joint1_cos_times_by_d_d_xz = joint1_cos * by_d_d_xz;
    const real half_turned_xz_2 = joint1_cos_times_by_d_d_xz + joint1_sin * by_d_d_zz;
    const real half_turned_zy = joint1_cos * by_d_d_yz - joint1_sin * by_d_d_xy;
    const real K_pp_xz = joint1_cos * half_turned_xz_2 - joint1_sin * half_turned_xx_2;
    const real K_p2_xx = joint1_cos * by_d_rho_xx + joint1_sin * by_d_rho_zx;
    const real K_p2_xy = joint1_cos * by_d_rho_xy + joint1_sin * by_d_rho_zy;
    const real K_p2_xz = joint1_cos * by_d_rho_xz + joint1_sin * by_d_rho_zz;
    const real K_p2_zx = joint1_cos * by_d_rho_zx - joint1_sin * by_d_rho_xx;
    const real K_p2_zy = joint1_cos * by_d_rho_zy - joint1_sin * by_d_rho_xy;
    const real K_p2_zz = joint1_cos * by_d_rho_zz - joint1_sin * by_d_rho_xz;
    const real force_turned_by_start_xy = by_d_z + force_by_start_xy;
    const real force_turned_by_start_zy = force_by_start_zy - by_d_x;
    const real K_p1_xy = joint1_cos * force_turned_by_start_xy
        + joint1_sin * force_turned_by_start_zy;
    const real K_p1_zy = joint1_cos * force_turned_by_start_zy
        - joint1_sin * force_turned_by_start_xy;
    const real K_joint1_u_joint1_u_part = d_x * force_by_start_zy - (d_z * by_d_z + d_x * by_d_x
        + d_z * force_by_start_xy) - r_yx * (r_yz * by_rho_y - r_yy * by_rho_z
        + moment_by_start_xy);
    out[5] = force_by_start_yy; /* K: joint1.u,node.u.py */
    out[35] = force_by_start_yy; /* K: node.u.py,joint1.u */
    out[1] = moment_by_start_xy; /* K: joint1.u,node.u.x */
    out[7] = moment_by_start_xy; /* K: node.u.x,joint1.u */
    out[2] = moment_by_start_yy; /* K: joint1.u,node.u.y */
    out[14] = moment_by_start_yy; /* K: node.u.y,joint1.u */
    out[3] = moment_by_start_zy; /* K: joint1.u,node.u.z */
    out[21] = moment_by_start_zy; /* K: node.u.z,joint1.u */
    out[33] = half_turned_xy_2; /* K: node.u.px,node.u.py */
    out[39] = half_turned_xy_2; /* K: node.u.py,node.u.px */
    out[41] = half_turned_zy; /* K: node.u.py,node.u.pz */
    out[47] = half_turned_zy; /* K: node.u.pz,node.u.py */
    /* K: node.u.px,node.u.px */
    out[32] = joint1_cos * half_turned_xx_2 + joint1_sin * half_turned_xz_2;
    out[34] = K_pp_xz; /* K: node.u.px,node.u.pz */
    out[46] = K_pp_xz; /* K: node.u.pz,node.u.px */
    /* K: node.u.pz,node.u.pz */
    out[48] = joint1_cos * (joint1_cos * by_d_d_zz - joint1_sin_times_by_d_d_xz)
        - joint1_sin * (joint1_cos_times_by_d_d_xz - joint1_sin * by_d_d_xx);
    out[11] = K_p2_xx; /* K: node.u.x,node.u.px */
    out[29] = K_p2_xx; /* K: node.u.px,node.u.x */
    out[18] = K_p2_xy; /* K: node.u.y,node.u.px */
    out[30] = K_p2_xy; /* K: node.u.px,node.u.y */
    out[25] = K_p2_xz; /* K: node.u.z,node.u.px */
    out[31] = K_p2_xz; /* K: node.u.px,node.u.z */
    out[13] = K_p2_zx; /* K: node.u.x,node.u.pz */
    out[43] = K_p2_zx; /* K: node.u.pz,node.u.x */
    out[20] = K_p2_zy; /* K: node.u.y,node.u.pz */
    out[44] = K_p2_zy; /* K: node.u.pz,node.u.y */
    out[27] = K_p2_zz; /* K: node.u.z,node.u.pz */
    out[45] = K_p2_zz; /* K: node.u.pz,node.u.z */
    out[4] = K_p1_xy; /* K: joint1.u,node.u.px */
    out[28] = K_p1_xy; /* K: node.u.px,joint1.u */
    out[6] = K_p1_zy; /* K: joint1.u,node.u.pz */
    out[42] = K_p1_zy; /* K: node.u.pz,joint1.u */
    /* K: joint1.u,joint1.u */
    out[0] = K_joint1_u_joint1_u_part - (r_yy * (r_yx * by_rho_z - r_yz * by_rho_x
        + moment_by_start_yy) + r_yz * (r_yy * by_rho_x - r_yx * by_rho_y + moment_by_start_zy));
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int hellinger_reissner_tree__balance_tangent_sizes[] = {49, 0, 18, 0, 8, 0, 0, 0, 0, 19, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
