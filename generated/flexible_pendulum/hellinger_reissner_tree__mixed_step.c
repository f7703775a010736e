/*
 * hellinger_reissner_tree__mixed_step
 * Geometrically exact beam with a stress field in equilibrium and helicoidal strain
 * Source: Sonneville, Cardona and Brüls, CMAME 268 (2014) for the strain; Pian and Sumihara,
 *     IJNME 20 (1984) for stress fields; their union on SE(3) is our own
 * passes: reassociate
 *
 * Sizes: out 6, work 0, w 18
 * Operations per call: 931 = 512 mul, 245 add, 139 sub, 13 select, 9 div, 5 lt, 5 neg, 1 cos,
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
 * Input du (7): finite increment along the speeds
 *   du[0]  joint1.u.step [rad]
 *   du[1]  node.u.x.step [rad]
 *   du[2]  node.u.y.step [rad]
 *   du[3]  node.u.z.step [rad]
 *   du[4]  node.u.px.step [m]
 *   du[5]  node.u.py.step [m]
 *   du[6]  node.u.pz.step [m]
 *
 * Output z (6)
 *   out[0]  m1 [N*m]
 *   out[1]  m2 [N*m]
 *   out[2]  m3 [N*m]
 *   out[3]  n1 [N]
 *   out[4]  n2 [N]
 *   out[5]  n3 [N]
 */
#include "cardan.h"

CARDAN_API void prepare_hellinger_reissner_tree__mixed_step(const wreal *p,
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
CARDAN_API int hellinger_reissner_tree__mixed_step(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const z = in->z;
    const wreal *const w = in->w;
    const real *const du = in->du;
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
    const real twice_a_slope = 2.0 * (0.0013888888888888915
        + theta_squared_squared * (theta_squared_squared * a_slope_part + 2.4801587303874985e-06)
        + theta_squared * (a_slope_part_2 + 6.613756613752113e-05));
    const real U_d_slope_by_squared_x = (theta_y * theta_cross_d_z
        - theta_z * theta_cross_d_y) * twice_a_slope;
    const real U_d_slope_by_squared_y = (theta_z * theta_cross_d_x
        - theta_x * theta_cross_d_z) * twice_a_slope;
    const real U_d_slope_by_squared_z = (theta_x * theta_cross_d_y
        - theta_y * theta_cross_d_x) * twice_a_slope;
    const real half_d_z = 0.5 * d_z;
    const real half_node_py = 0.5 * node_py;
    const real half_d_x = 0.5 * d_x;

    /* common */
    const real joint1_u_step = du[0]; /* rad */
    const real node_u_x_step = du[1]; /* rad */
    const real node_u_y_step = du[2]; /* rad */
    const real node_u_z_step = du[3]; /* rad */
    const real node_u_px_step = du[4]; /* m */
    const real node_u_py_step = du[5]; /* m */
    const real node_u_pz_step = du[6]; /* m */
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
    const real rho_x = node_u_x_step - (relative_w * twice_relative_z
        + 2.0 * relative_y * relative_x) * joint1_u_step;
    const real rho_y = node_u_y_step - (1.0 - relative_x * twice_relative_x
        - relative_z * twice_relative_z) * joint1_u_step;
    const real rho_z = node_u_z_step - (relative_y * twice_relative_z
        - relative_w * twice_relative_x) * joint1_u_step;
    const real d_step_x = joint1_cos * node_u_px_step - joint1_sin * node_u_pz_step
        - d_z * joint1_u_step;
    const real d_step_z = joint1_sin * node_u_px_step + joint1_cos * node_u_pz_step
        + d_x * joint1_u_step;
    const real theta_step_x = D_xx * rho_x + D_xy * rho_y + D_xz * rho_z;
    const real theta_step_y = D_yx * rho_x + D_yy * rho_y + D_yz * rho_z;
    const real theta_step_z = D_zx * rho_x + D_zy * rho_y + D_zz * rho_z;
    const real e_step_x_part = (a * (node_py_times_theta_x - 2.0 * theta_y_times_d_x) - half_d_z
        + theta_y * U_d_slope_by_squared_x) * theta_step_y + (a * (theta_x_times_d_z
        - 2.0 * theta_z_times_d_x) + half_node_py
        + theta_z * U_d_slope_by_squared_x) * theta_step_z;
    const real e_step_x = D_xx * d_step_x + D_yx * node_u_py_step + D_zx * d_step_z
        + (a * (theta_x_times_d_x - 2.0 * theta_x_times_d_x + theta_dot_d)
        + theta_x * U_d_slope_by_squared_x) * theta_step_x + e_step_x_part;
    const real e_step_y_part = (a * (node_py_times_theta_y - 2.0 * node_py_times_theta_y
        + theta_dot_d) + theta_y * U_d_slope_by_squared_y) * theta_step_y
        + (a * (theta_y_times_d_z - 2.0 * node_py_times_theta_z) - half_d_x
        + theta_z * U_d_slope_by_squared_y) * theta_step_z;
    const real e_step_y = D_xy * d_step_x + D_yy * node_u_py_step + D_zy * d_step_z
        + (a * (theta_y_times_d_x - 2.0 * node_py_times_theta_x) + half_d_z
        + theta_x * U_d_slope_by_squared_y) * theta_step_x + e_step_y_part;
    const real e_step_z_part = (a * (node_py_times_theta_z - 2.0 * theta_y_times_d_z) + half_d_x
        + theta_y * U_d_slope_by_squared_z) * theta_step_y + (a * (theta_z_times_d_z
        - 2.0 * theta_z_times_d_z + theta_dot_d) + theta_z * U_d_slope_by_squared_z) * theta_step_z;
    const real e_step_z = D_xz * d_step_x + D_yz * node_u_py_step + D_zz * d_step_z
        + (a * (theta_z_times_d_x - 2.0 * theta_x_times_d_z) - half_node_py
        + theta_x * U_d_slope_by_squared_z) * theta_step_x + e_step_z_part;
    const real missing_strain_E3_part = e_z - free_E3 + minus_F_1_6 * m1 + minus_F_4_6 * n1
        + (minus_F_5_6 * n2 + (theta_y * minus_tau_by_strain_4_3 + theta_x * tau_by_strain_5_3
        + e_y * minus_tau_by_strain_1_3 + e_x * tau_by_strain_2_3) * theta_step_z);
    const real missing_strain_E3_part_2 = (tau_E2 - theta_x * minus_tau_by_strain_5_1
        - e_x * minus_tau_by_strain_2_1) * theta_step_x - (tau_E1 + theta_y * tau_by_strain_4_2
        + e_y * tau_by_strain_1_2) * theta_step_y - F_6_6 * n3 - (tau_K1
        + e_y * tau_by_strain_1_5) * e_step_y;
    const real missing_strain_E3 = minus_F_2_6 * m2 - F_3_6 * m3 + (1.0
        + e_y * minus_tau_by_strain_1_6 + e_x * tau_by_strain_2_6) * e_step_z + (tau_K2
        - e_x * minus_tau_by_strain_2_4) * e_step_x + missing_strain_E3_part
        + missing_strain_E3_part_2;
    const real s_m1_part = e_y - free_E2 + minus_F_1_5 * m1 + minus_F_4_5 * n1
        + (minus_F_5_6 * n3 + (theta_z * tau_by_strain_4_2 + theta_x * minus_tau_by_strain_6_2
        + e_z * tau_by_strain_1_2 + e_x * minus_tau_by_strain_3_2) * theta_step_y);
    const real s_m1_part_2 = (tau_E1 - theta_z * minus_tau_by_strain_4_3
        - e_z * minus_tau_by_strain_1_3) * theta_step_z - (tau_E3 + theta_x * tau_by_strain_6_1
        + e_x * tau_by_strain_3_1) * theta_step_x - F_5_5 * n2 + (tau_K1
        - e_z * minus_tau_by_strain_1_6) * e_step_z;
    const real s_m1_part_3 = minus_F_3_5 * m3 - F_2_5 * m2 + (1.0 + e_z * tau_by_strain_1_5
        + e_x * minus_tau_by_strain_3_5) * e_step_y - (tau_K3
        + e_x * tau_by_strain_3_4) * e_step_x + s_m1_part + s_m1_part_2
        + F_minus_factor_L_n3_n2 * missing_strain_E3;
    const real s_m1_part_4 = e_x - free_E1 + minus_F_2_4 * m2 + minus_F_4_5 * n2
        + (minus_F_4_6 * n3 + (theta_z * minus_tau_by_strain_5_1 + theta_y * tau_by_strain_6_1
        + e_z * minus_tau_by_strain_2_1 + e_y * tau_by_strain_3_1) * theta_step_x);
    const real s_m1_part_5 = (tau_E3 - theta_y * minus_tau_by_strain_6_2
        - e_y * minus_tau_by_strain_3_2) * theta_step_y - (tau_E2 + theta_z * tau_by_strain_5_3
        + e_z * tau_by_strain_2_3) * theta_step_z - F_4_4 * n1 - (tau_K2
        + e_z * tau_by_strain_2_6) * e_step_z;
    const real s_m1_part_6 = minus_F_3_4 * m3 - F_1_4 * m1 + (1.0 + e_z * minus_tau_by_strain_2_4
        + e_y * tau_by_strain_3_4) * e_step_x + (tau_K3
        - e_y * minus_tau_by_strain_3_5) * e_step_y + s_m1_part_4 + s_m1_part_5
        + F_minus_factor_L_n3_n1 * missing_strain_E3;
    const real s_m1_part_7 = F_minus_factor_L_n2_n1 * s_m1_part_3 + s_m1_part_6;
    const real s_m1_part_8 = theta_z - free_K3 + minus_F_1_3 * m1 + minus_F_2_3 * m2 - F_3_3 * m3
        + (1.0 + theta_y * minus_tau_by_strain_1_3 + theta_x * tau_by_strain_2_3) * theta_step_z
        - F_3_6 * n3 + (minus_F_3_4 * n1 + minus_F_3_5 * n2
        - theta_x * minus_tau_by_strain_2_4 * e_step_x);
    const real s_m1_part_9 = (theta_y * minus_tau_by_strain_1_6
        + theta_x * tau_by_strain_2_6) * e_step_z - theta_y * tau_by_strain_1_5 * e_step_y
        + (tau_K2 - theta_x * minus_tau_by_strain_2_1) * theta_step_x + (s_m1_part_8 - (tau_K1
        + theta_y * tau_by_strain_1_2) * theta_step_y);
    const real s_m1_part_10 = s_m1_part_9 - F_factor_L_n3_m3 * missing_strain_E3
        - F_factor_L_n2_m3 * s_m1_part_3 - F_factor_L_n1_m3 * s_m1_part_7;
    const real s_m1_part_11 = theta_y - free_K2 + minus_F_1_2 * m1 + minus_F_2_3 * m3
        - F_2_2 * m2 + (1.0 + theta_z * tau_by_strain_1_2
        + theta_x * minus_tau_by_strain_3_2) * theta_step_y - F_2_5 * n2 + (minus_F_2_4 * n1
        + minus_F_2_6 * n3 - theta_x * tau_by_strain_3_4 * e_step_x);
    const real s_m1_part_12 = (theta_z * tau_by_strain_1_5
        + theta_x * minus_tau_by_strain_3_5) * e_step_y
        - theta_z * minus_tau_by_strain_1_6 * e_step_z - (tau_K3
        + theta_x * tau_by_strain_3_1) * theta_step_x + ((tau_K1
        - theta_z * minus_tau_by_strain_1_3) * theta_step_z + s_m1_part_11);
    const real s_m1_part_13 = F_minus_factor_L_n3_m2 * missing_strain_E3 + s_m1_part_12
        - F_factor_L_n2_m2 * s_m1_part_3 - F_factor_L_n1_m2 * s_m1_part_7
        - F_factor_L_m3_m2 * s_m1_part_10;
    const real s_m1_part_14 = theta_x - free_K1 + minus_F_1_2 * m2 + minus_F_1_3 * m3
        - F_1_1 * m1 + (1.0 + theta_z * minus_tau_by_strain_2_1
        + theta_y * tau_by_strain_3_1) * theta_step_x - F_1_4 * n1;
    const real s_m1_part_15 = minus_F_1_5 * n2 + minus_F_1_6 * n3
        + (theta_z * minus_tau_by_strain_2_4 + theta_y * tau_by_strain_3_4) * e_step_x
        + s_m1_part_14 - (tau_K2 + theta_z * tau_by_strain_2_3) * theta_step_z;
    const real s_m1_part_16 = (tau_K3 - theta_y * minus_tau_by_strain_3_2) * theta_step_y
        - (theta_y * minus_tau_by_strain_3_5 * e_step_y + theta_z * tau_by_strain_2_6 * e_step_z)
        + s_m1_part_15 + F_minus_factor_L_n3_m1 * missing_strain_E3
        + F_minus_factor_L_n2_m1 * s_m1_part_3;
    const real s_m1 = F_factor_D_inverse_m1 * (s_m1_part_16 - F_factor_L_n1_m1 * s_m1_part_7
        - F_factor_L_m3_m1 * s_m1_part_10 - F_factor_L_m2_m1 * s_m1_part_13);
    const real s_m2 = F_factor_D_inverse_m2 * s_m1_part_13 - F_factor_L_m2_m1 * s_m1;
    const real s_m3 = F_factor_D_inverse_m3 * s_m1_part_10 - F_factor_L_m3_m1 * s_m1
        - F_factor_L_m3_m2 * s_m2;
    const real s_n1 = F_factor_D_inverse_n1 * s_m1_part_7 - F_factor_L_n1_m1 * s_m1
        - F_factor_L_n1_m2 * s_m2 - F_factor_L_n1_m3 * s_m3;
    const real s_n2 = F_factor_D_inverse_n2 * s_m1_part_3 + F_minus_factor_L_n2_m1 * s_m1
        - F_factor_L_n2_m2 * s_m2 - F_factor_L_n2_m3 * s_m3 + F_minus_factor_L_n2_n1 * s_n1;
    out[0] = m1 + s_m1; /* z: m1 [N*m] */
    out[1] = m2 + s_m2; /* z: m2 [N*m] */
    out[2] = m3 + s_m3; /* z: m3 [N*m] */
    out[3] = n1 + s_n1; /* z: n1 [N] */
    out[4] = n2 + s_n2; /* z: n2 [N] */
    /* z: n3 [N] */
    out[5] = n3 + F_factor_D_inverse_n3 * missing_strain_E3 + F_minus_factor_L_n3_m1 * s_m1
        + F_minus_factor_L_n3_m2 * s_m2 - F_factor_L_n3_m3 * s_m3 + F_minus_factor_L_n3_n1 * s_n1
        + F_minus_factor_L_n3_n2 * s_n2;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int hellinger_reissner_tree__mixed_step_sizes[] = {6, 0, 18, 0, 8, 0, 6, 0, 0, 19, 0, 0, 0, 0, 0, 0, 7, 0, 0, 0};
#endif
