/*
 * events of bay
 * numbers that fall through zero where an event happens
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 2, work 5, w 49
 * Operations per call: 537 = 297 mul, 80 add, 64 sub, 27 select, 21 div, 15 lt, 12 max, 9 sqrt,
 *     8 neg, 1 cos, 1 eq, 1 sin, 1 solve
 * Operations of prepare: 7 = 6 mul, 1 div
 *
 * Input q (2): generalized coordinates
 *   q[0]  height [m]
 *   q[1]  twist [rad]
 *
 * Input u (2): generalized speeds
 *   u[0]  height.u [m/s]
 *   u[1]  twist.u [rad/s]
 *
 * Input s (1): discrete states
 *   s[0]  end
 *
 * Input p (55): parameters, read by prepare_ only
 *
 * Output events (2)
 *   out[0]  end.upper
 *   out[1]  end.release
 */
#include "cardan.h"
#include "solve.h"
#include "dependent.h"

CARDAN_API void prepare_events(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* cable0 */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal cable0_EA = p[1]; /* N */
    const wreal cable0_damping = p[3]; /* s */
    const wreal cable0_EA_times_damping = cable0_EA * cable0_damping;
    w[42] = cable0_EA_times_damping;

    /* counter0: cable */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal counter0_EA = p[4]; /* N */
    const wreal counter0_damping = p[6]; /* s */
    const wreal counter0_EA_times_damping = counter0_EA * counter0_damping;
    w[43] = counter0_EA_times_damping;

    /* cable1 */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal cable1_EA = p[7]; /* N */
    const wreal cable1_damping = p[9]; /* s */
    const wreal cable1_EA_times_damping = cable1_EA * cable1_damping;
    w[44] = cable1_EA_times_damping;

    /* counter1: cable */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal counter1_EA = p[10]; /* N */
    const wreal counter1_damping = p[12]; /* s */
    const wreal counter1_EA_times_damping = counter1_EA * counter1_damping;
    w[45] = counter1_EA_times_damping;

    /* cable2 */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal cable2_EA = p[13]; /* N */
    const wreal cable2_damping = p[15]; /* s */
    const wreal cable2_EA_times_damping = cable2_EA * cable2_damping;
    w[46] = cable2_EA_times_damping;

    /* counter2: cable */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal counter2_EA = p[16]; /* N */
    const wreal counter2_damping = p[18]; /* s */
    const wreal counter2_EA_times_damping = counter2_EA * counter2_damping;
    w[47] = counter2_EA_times_damping;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal top_inertia_zz = p[22]; /* kg m^2 */
    const wreal M_factor_D_inverse_twist = 1.0 / top_inertia_zz;
    w[48] = M_factor_D_inverse_twist;

    /* parameters as they are */
    w[0] = p[1]; /* cable0.EA [N] */
    w[1] = p[2]; /* cable0.length [m] */
    w[2] = p[4]; /* counter0.EA [N] */
    w[3] = p[5]; /* counter0.length [m] */
    w[4] = p[7]; /* cable1.EA [N] */
    w[5] = p[8]; /* cable1.length [m] */
    w[6] = p[10]; /* counter1.EA [N] */
    w[7] = p[11]; /* counter1.length [m] */
    w[8] = p[13]; /* cable2.EA [N] */
    w[9] = p[14]; /* cable2.length [m] */
    w[10] = p[16]; /* counter2.EA [N] */
    w[11] = p[17]; /* counter2.length [m] */
    w[12] = p[23]; /* bar0.stiffness [N/m] */
    w[13] = p[24]; /* bar0.damping [N*s/m] */
    w[14] = p[25]; /* bar0.rest_length [m] */
    w[15] = p[26]; /* bar0.a.position.x [m] */
    w[16] = p[27]; /* bar0.b.position.x [m] */
    w[17] = p[28]; /* bar1.stiffness [N/m] */
    w[18] = p[29]; /* bar1.damping [N*s/m] */
    w[19] = p[30]; /* bar1.rest_length [m] */
    w[20] = p[31]; /* bar1.a.position.x [m] */
    w[21] = p[32]; /* bar1.a.position.y [m] */
    w[22] = p[33]; /* bar1.b.position.x [m] */
    w[23] = p[34]; /* bar1.b.position.y [m] */
    w[24] = p[35]; /* bar2.stiffness [N/m] */
    w[25] = p[36]; /* bar2.damping [N*s/m] */
    w[26] = p[37]; /* bar2.rest_length [m] */
    w[27] = p[38]; /* bar2.a.position.x [m] */
    w[28] = p[39]; /* bar2.a.position.y [m] */
    w[29] = p[40]; /* bar2.b.position.x [m] */
    w[30] = p[41]; /* bar2.b.position.y [m] */
    w[31] = p[42]; /* end.upper [rad] */
    w[32] = p[45]; /* cable0.b.position.x [m] */
    w[33] = p[46]; /* cable0.b.position.y [m] */
    w[34] = p[47]; /* counter0.b.position.x [m] */
    w[35] = p[48]; /* counter0.b.position.y [m] */
    w[36] = p[49]; /* cable1.b.position.x [m] */
    w[37] = p[50]; /* cable1.b.position.y [m] */
    w[38] = p[51]; /* counter1.b.position.x [m] */
    w[39] = p[52]; /* cable2.b.position.x [m] */
    w[40] = p[53]; /* counter2.b.position.x [m] */
    w[41] = p[54]; /* counter2.b.position.y [m] */
}

#include "lanes.h"

/* numbers that fall through zero where an event happens */
CARDAN_API int events(const cardan_in *in, real *CARDAN_RESTRICT out, real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const real *const s = in->s;
    const wreal *const w = in->w;
    real *const circuit_matrix = work + 0;
    real *const circuit_right = work + 1;
    real *const circuit_scratch = work + 2;
    int status = CARDAN_OK;

    /* twist: R */
    /* R = R_fixed R_joint(q) */
    const real twist_q = q[1]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {twist_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real twist_cos = cosine[0];
    const real twist_sin = sine[0];

    /* bar0: spring damper */
    /* force = stiffness (distance - rest_length) + damping d(distance)/dt */
    const real twist_u = u[1]; /* rad/s */
    const wreal bar0_a_position_x = w[15]; /* m */
    const wreal bar0_b_position_x = w[16]; /* m */
    const real bar0_spring_damper_span_y = bar0_b_position_x * twist_sin;
    const real bar0_spring_damper_span_x = bar0_b_position_x * twist_cos - bar0_a_position_x;
    const real twist_u_times_bar0_b_position_x = twist_u * bar0_b_position_x;

    /* shared by several: spring damper */
    /* force = stiffness (distance - rest_length) + damping d(distance)/dt */
    const real height_q = q[0]; /* m */
    const real height_squared = height_q * height_q;

    /* bar0: spring damper */
    /* force = stiffness (distance - rest_length) + damping d(distance)/dt */
    const real height_u = u[0]; /* m/s */
    const wreal bar0_stiffness = w[12]; /* N/m */
    const wreal bar0_damping = w[13]; /* N*s/m */
    const wreal bar0_rest_length = w[14]; /* m */
    const real bar0_spring_damper_distance = cardan_sqrt(bar0_spring_damper_span_y *
        bar0_spring_damper_span_y + height_squared
        + bar0_spring_damper_span_x * bar0_spring_damper_span_x);
    const real bar0_spring_damper_apart = cardan_lt(0.0, bar0_spring_damper_distance);
    const real bar0_spring_damper_inverse_distance = cardan_select(bar0_spring_damper_apart, 1.0,
        0.0) / cardan_select(bar0_spring_damper_apart, bar0_spring_damper_distance, 1.0);
    const real bar0_spring_damper_direction_x = bar0_spring_damper_span_x *
        bar0_spring_damper_inverse_distance;
    const real bar0_spring_damper_direction_y = bar0_spring_damper_span_y *
        bar0_spring_damper_inverse_distance;
    const real bar0_force_on_bar0_a_x_part = bar0_stiffness * (bar0_spring_damper_distance
        - bar0_rest_length);
    const real bar0_force_on_bar0_a_x_part_2 = bar0_damping * (twist_cos *
        twist_u_times_bar0_b_position_x * bar0_spring_damper_direction_y
        - twist_sin * twist_u_times_bar0_b_position_x * bar0_spring_damper_direction_x
        + height_q * bar0_spring_damper_inverse_distance * height_u);

    /* bar1: spring damper */
    /* force = stiffness (distance - rest_length) + damping d(distance)/dt */
    const wreal bar1_stiffness = w[17]; /* N/m */
    const wreal bar1_damping = w[18]; /* N*s/m */
    const wreal bar1_rest_length = w[19]; /* m */
    const wreal bar1_a_position_x = w[20]; /* m */
    const wreal bar1_a_position_y = w[21]; /* m */
    const wreal bar1_b_position_x = w[22]; /* m */
    const wreal bar1_b_position_y = w[23]; /* m */
    const real bar1_spring_damper_span_x = bar1_b_position_x * twist_cos - bar1_a_position_x
        - bar1_b_position_y * twist_sin;
    const real bar1_spring_damper_span_y = bar1_b_position_x * twist_sin - bar1_a_position_y
        + bar1_b_position_y * twist_cos;
    const real bar1_spring_damper_distance = cardan_sqrt(height_squared
        + bar1_spring_damper_span_x * bar1_spring_damper_span_x
        + bar1_spring_damper_span_y * bar1_spring_damper_span_y);
    const real bar1_spring_damper_apart = cardan_lt(0.0, bar1_spring_damper_distance);
    const real bar1_spring_damper_inverse_distance = cardan_select(bar1_spring_damper_apart, 1.0,
        0.0) / cardan_select(bar1_spring_damper_apart, bar1_spring_damper_distance, 1.0);
    const real bar1_spring_damper_direction_x = bar1_spring_damper_span_x *
        bar1_spring_damper_inverse_distance;
    const real bar1_spring_damper_direction_y = bar1_spring_damper_span_y *
        bar1_spring_damper_inverse_distance;
    const real bar1_force_on_bar1_a_x_part = bar1_stiffness * (bar1_spring_damper_distance
        - bar1_rest_length);
    const real bar1_force_on_bar1_a_x = bar1_spring_damper_direction_x *
        bar1_force_on_bar1_a_x_part;
    const real bar1_force_on_bar1_a_y = bar1_spring_damper_direction_y *
        bar1_force_on_bar1_a_x_part;
    const real twist_u_times_bar1_b_position_y = twist_u * bar1_b_position_y;
    const real twist_u_times_bar1_b_position_x = twist_u * bar1_b_position_x;
    const real bar1_force_on_bar1_a_x_part_2 = bar1_spring_damper_direction_y * (twist_cos *
        twist_u_times_bar1_b_position_x - twist_sin * twist_u_times_bar1_b_position_y)
        - bar1_spring_damper_direction_x * (twist_cos * twist_u_times_bar1_b_position_y
        + twist_sin * twist_u_times_bar1_b_position_x);
    const real bar1_force_on_bar1_a_x_part_3 = bar1_damping * (height_q *
        bar1_spring_damper_inverse_distance * height_u + bar1_force_on_bar1_a_x_part_2);
    const real bar1_force_on_bar1_a_x_2 = bar1_spring_damper_direction_x *
        bar1_force_on_bar1_a_x_part_3;
    const real bar1_force_on_bar1_a_y_2 = bar1_spring_damper_direction_y *
        bar1_force_on_bar1_a_x_part_3;

    /* bar2: spring damper */
    /* force = stiffness (distance - rest_length) + damping d(distance)/dt */
    const wreal bar2_stiffness = w[24]; /* N/m */
    const wreal bar2_damping = w[25]; /* N*s/m */
    const wreal bar2_rest_length = w[26]; /* m */
    const wreal bar2_a_position_x = w[27]; /* m */
    const wreal bar2_a_position_y = w[28]; /* m */
    const wreal bar2_b_position_x = w[29]; /* m */
    const wreal bar2_b_position_y = w[30]; /* m */
    const real bar2_spring_damper_span_x = bar2_b_position_x * twist_cos - bar2_a_position_x
        - bar2_b_position_y * twist_sin;
    const real bar2_spring_damper_span_y = bar2_b_position_x * twist_sin - bar2_a_position_y
        + bar2_b_position_y * twist_cos;
    const real bar2_spring_damper_distance = cardan_sqrt(height_squared
        + bar2_spring_damper_span_x * bar2_spring_damper_span_x
        + bar2_spring_damper_span_y * bar2_spring_damper_span_y);
    const real bar2_spring_damper_apart = cardan_lt(0.0, bar2_spring_damper_distance);
    const real bar2_spring_damper_inverse_distance = cardan_select(bar2_spring_damper_apart, 1.0,
        0.0) / cardan_select(bar2_spring_damper_apart, bar2_spring_damper_distance, 1.0);
    const real bar2_spring_damper_direction_x = bar2_spring_damper_span_x *
        bar2_spring_damper_inverse_distance;
    const real bar2_spring_damper_direction_y = bar2_spring_damper_span_y *
        bar2_spring_damper_inverse_distance;
    const real bar2_force_on_bar2_a_x_part = bar2_stiffness * (bar2_spring_damper_distance
        - bar2_rest_length);
    const real bar2_force_on_bar2_a_x = bar2_spring_damper_direction_x *
        bar2_force_on_bar2_a_x_part;
    const real bar2_force_on_bar2_a_y = bar2_spring_damper_direction_y *
        bar2_force_on_bar2_a_x_part;
    const real twist_u_times_bar2_b_position_y = twist_u * bar2_b_position_y;
    const real twist_u_times_bar2_b_position_x = twist_u * bar2_b_position_x;
    const real bar2_force_on_bar2_a_x_part_2 = bar2_spring_damper_direction_y * (twist_cos *
        twist_u_times_bar2_b_position_x - twist_sin * twist_u_times_bar2_b_position_y)
        - bar2_spring_damper_direction_x * (twist_cos * twist_u_times_bar2_b_position_y
        + twist_sin * twist_u_times_bar2_b_position_x);
    const real bar2_force_on_bar2_a_x_part_3 = bar2_damping * (height_q *
        bar2_spring_damper_inverse_distance * height_u + bar2_force_on_bar2_a_x_part_2);
    const real bar2_force_on_bar2_a_x_2 = bar2_spring_damper_direction_x *
        bar2_force_on_bar2_a_x_part_3;
    const real bar2_force_on_bar2_a_y_2 = bar2_spring_damper_direction_y *
        bar2_force_on_bar2_a_x_part_3;

    /* cable0 */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal cable0_EA = w[0]; /* N */
    const wreal cable0_length = w[1]; /* m */
    const wreal cable0_b_position_x = w[32]; /* m */
    const wreal cable0_b_position_y = w[33]; /* m */
    const wreal cable0_EA_times_damping = w[42];
    const real cable0_cable_span_y = cable0_b_position_x * twist_sin
        + cable0_b_position_y * twist_cos;
    const real cable0_cable_span_x = cable0_b_position_x * twist_cos - bar0_a_position_x
        - cable0_b_position_y * twist_sin;
    const real cable0_cable_distance = cardan_sqrt(height_squared
        + cable0_cable_span_y * cable0_cable_span_y + cable0_cable_span_x * cable0_cable_span_x);
    const real cable0_cable_apart = cardan_lt(0.0, cable0_cable_distance);
    const real cable0_cable_inverse_distance = cardan_select(cable0_cable_apart, 1.0,
        0.0) / cardan_select(cable0_cable_apart, cable0_cable_distance, 1.0);
    const real cable0_cable_direction_x = cable0_cable_span_x * cable0_cable_inverse_distance;
    const real cable0_cable_direction_y = cable0_cable_span_y * cable0_cable_inverse_distance;
    const real cable0_force_on_bar0_a_x_part = cable0_EA * cardan_max(0.0,
        cable0_cable_distance / cable0_length - 1.0);
    const real cable0_force_on_bar0_a_x = cable0_cable_direction_x * cable0_force_on_bar0_a_x_part;
    const real cable0_force_on_bar0_a_y = cable0_cable_direction_y * cable0_force_on_bar0_a_x_part;
    const real twist_u_times_cable0_b_position_y = twist_u * cable0_b_position_y;
    const real twist_u_times_cable0_b_position_x = twist_u * cable0_b_position_x;
    const real cable0_force_on_bar0_a_x_part_2 = cable0_cable_direction_y * (twist_cos *
        twist_u_times_cable0_b_position_x - twist_sin * twist_u_times_cable0_b_position_y)
        - cable0_cable_direction_x * (twist_cos * twist_u_times_cable0_b_position_y
        + twist_sin * twist_u_times_cable0_b_position_x);
    const real cable0_force_on_bar0_a_x_part_3 = cardan_select(cardan_lt(0.0,
        cable0_force_on_bar0_a_x_part),
        cardan_max((height_q * cable0_cable_inverse_distance * height_u
        + cable0_force_on_bar0_a_x_part_2) / cable0_length * cable0_EA_times_damping,
        -cable0_force_on_bar0_a_x_part), 0.0);
    const real cable0_force_on_bar0_a_x_2 = cable0_cable_direction_x *
        cable0_force_on_bar0_a_x_part_3;
    const real cable0_force_on_bar0_a_y_2 = cable0_cable_direction_y *
        cable0_force_on_bar0_a_x_part_3;

    /* counter0: cable */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal counter0_EA = w[2]; /* N */
    const wreal counter0_length = w[3]; /* m */
    const wreal counter0_b_position_x = w[34]; /* m */
    const wreal counter0_b_position_y = w[35]; /* m */
    const wreal counter0_EA_times_damping = w[43];
    const real counter0_cable_span_y = counter0_b_position_x * twist_sin
        + counter0_b_position_y * twist_cos;
    const real counter0_cable_span_x = counter0_b_position_x * twist_cos - bar0_a_position_x
        - counter0_b_position_y * twist_sin;
    const real counter0_cable_distance = cardan_sqrt(height_squared
        + counter0_cable_span_y * counter0_cable_span_y
        + counter0_cable_span_x * counter0_cable_span_x);
    const real counter0_cable_apart = cardan_lt(0.0, counter0_cable_distance);
    const real counter0_cable_inverse_distance = cardan_select(counter0_cable_apart, 1.0,
        0.0) / cardan_select(counter0_cable_apart, counter0_cable_distance, 1.0);
    const real counter0_cable_direction_x = counter0_cable_span_x * counter0_cable_inverse_distance;
    const real counter0_cable_direction_y = counter0_cable_span_y * counter0_cable_inverse_distance;
    const real counter0_force_on_bar0_a_x_part = counter0_EA * cardan_max(0.0,
        counter0_cable_distance / counter0_length - 1.0);
    const real counter0_force_on_bar0_a_x = counter0_cable_direction_x *
        counter0_force_on_bar0_a_x_part;
    const real counter0_force_on_bar0_a_y = counter0_cable_direction_y *
        counter0_force_on_bar0_a_x_part;
    const real twist_u_times_counter0_b_position_y = twist_u * counter0_b_position_y;
    const real twist_u_times_counter0_b_position_x = twist_u * counter0_b_position_x;
    const real counter0_force_on_bar0_a_x_part_2 = counter0_cable_direction_y * (twist_cos *
        twist_u_times_counter0_b_position_x - twist_sin * twist_u_times_counter0_b_position_y)
        - counter0_cable_direction_x * (twist_cos * twist_u_times_counter0_b_position_y
        + twist_sin * twist_u_times_counter0_b_position_x);
    const real counter0_force_on_bar0_a_x_part_3 = cardan_select(cardan_lt(0.0,
        counter0_force_on_bar0_a_x_part),
        cardan_max((height_q * counter0_cable_inverse_distance * height_u
        + counter0_force_on_bar0_a_x_part_2) / counter0_length * counter0_EA_times_damping,
        -counter0_force_on_bar0_a_x_part), 0.0);
    const real counter0_force_on_bar0_a_x_2 = counter0_cable_direction_x *
        counter0_force_on_bar0_a_x_part_3;
    const real counter0_force_on_bar0_a_y_2 = counter0_cable_direction_y *
        counter0_force_on_bar0_a_x_part_3;

    /* cable1 */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal cable1_EA = w[4]; /* N */
    const wreal cable1_length = w[5]; /* m */
    const wreal cable1_b_position_x = w[36]; /* m */
    const wreal cable1_b_position_y = w[37]; /* m */
    const wreal cable1_EA_times_damping = w[44];
    const real cable1_cable_span_x = cable1_b_position_x * twist_cos - bar1_a_position_x
        - cable1_b_position_y * twist_sin;
    const real cable1_cable_span_y = cable1_b_position_x * twist_sin - bar1_a_position_y
        + cable1_b_position_y * twist_cos;
    const real cable1_cable_distance = cardan_sqrt(height_squared
        + cable1_cable_span_x * cable1_cable_span_x + cable1_cable_span_y * cable1_cable_span_y);
    const real cable1_cable_apart = cardan_lt(0.0, cable1_cable_distance);
    const real cable1_cable_inverse_distance = cardan_select(cable1_cable_apart, 1.0,
        0.0) / cardan_select(cable1_cable_apart, cable1_cable_distance, 1.0);
    const real cable1_cable_direction_x = cable1_cable_span_x * cable1_cable_inverse_distance;
    const real cable1_cable_direction_y = cable1_cable_span_y * cable1_cable_inverse_distance;
    const real cable1_force_on_bar1_a_x_part = cable1_EA * cardan_max(0.0,
        cable1_cable_distance / cable1_length - 1.0);
    const real cable1_force_on_bar1_a_x = cable1_cable_direction_x * cable1_force_on_bar1_a_x_part;
    const real cable1_force_on_bar1_a_y = cable1_cable_direction_y * cable1_force_on_bar1_a_x_part;
    const real twist_u_times_cable1_b_position_y = twist_u * cable1_b_position_y;
    const real twist_u_times_cable1_b_position_x = twist_u * cable1_b_position_x;
    const real cable1_force_on_bar1_a_x_part_2 = cable1_cable_direction_y * (twist_cos *
        twist_u_times_cable1_b_position_x - twist_sin * twist_u_times_cable1_b_position_y)
        - cable1_cable_direction_x * (twist_cos * twist_u_times_cable1_b_position_y
        + twist_sin * twist_u_times_cable1_b_position_x);
    const real cable1_force_on_bar1_a_x_part_3 = cardan_select(cardan_lt(0.0,
        cable1_force_on_bar1_a_x_part),
        cardan_max((height_q * cable1_cable_inverse_distance * height_u
        + cable1_force_on_bar1_a_x_part_2) / cable1_length * cable1_EA_times_damping,
        -cable1_force_on_bar1_a_x_part), 0.0);
    const real cable1_force_on_bar1_a_x_2 = cable1_cable_direction_x *
        cable1_force_on_bar1_a_x_part_3;
    const real cable1_force_on_bar1_a_y_2 = cable1_cable_direction_y *
        cable1_force_on_bar1_a_x_part_3;

    /* counter1: cable */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal counter1_EA = w[6]; /* N */
    const wreal counter1_length = w[7]; /* m */
    const wreal counter1_b_position_x = w[38]; /* m */
    const wreal counter1_EA_times_damping = w[45];
    const real counter1_cable_span_x = counter1_b_position_x * twist_cos - bar1_a_position_x;
    const real counter1_cable_span_y = counter1_b_position_x * twist_sin - bar1_a_position_y;
    const real counter1_cable_distance = cardan_sqrt(height_squared
        + counter1_cable_span_x * counter1_cable_span_x
        + counter1_cable_span_y * counter1_cable_span_y);
    const real counter1_cable_apart = cardan_lt(0.0, counter1_cable_distance);
    const real counter1_cable_inverse_distance = cardan_select(counter1_cable_apart, 1.0,
        0.0) / cardan_select(counter1_cable_apart, counter1_cable_distance, 1.0);
    const real counter1_cable_direction_x = counter1_cable_span_x * counter1_cable_inverse_distance;
    const real counter1_cable_direction_y = counter1_cable_span_y * counter1_cable_inverse_distance;
    const real counter1_force_on_bar1_a_x_part = counter1_EA * cardan_max(0.0,
        counter1_cable_distance / counter1_length - 1.0);
    const real twist_u_times_counter1_b_position_x = twist_u * counter1_b_position_x;
    const real counter1_force_on_bar1_a_x_part_2 = (twist_cos * twist_u_times_counter1_b_position_x
        * counter1_cable_direction_y
        - twist_sin * twist_u_times_counter1_b_position_x * counter1_cable_direction_x
        + height_q * counter1_cable_inverse_distance * height_u) / counter1_length *
        counter1_EA_times_damping;
    const real counter1_force_on_bar1_a_x_part_3 = cardan_select(cardan_lt(0.0,
        counter1_force_on_bar1_a_x_part), cardan_max(counter1_force_on_bar1_a_x_part_2,
        -counter1_force_on_bar1_a_x_part), 0.0);
    const real twist_drive_part = counter1_b_position_x * (counter1_cable_direction_x *
        counter1_force_on_bar1_a_x_part * twist_sin
        - counter1_cable_direction_y * counter1_force_on_bar1_a_x_part * twist_cos);
    const real twist_drive_part_2 = counter1_b_position_x * (counter1_cable_direction_x *
        counter1_force_on_bar1_a_x_part_3 * twist_sin
        - counter1_cable_direction_y * counter1_force_on_bar1_a_x_part_3 * twist_cos);

    /* cable2 */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal cable2_EA = w[8]; /* N */
    const wreal cable2_length = w[9]; /* m */
    const wreal cable2_b_position_x = w[39]; /* m */
    const wreal cable2_EA_times_damping = w[46];
    const real cable2_cable_span_x = cable2_b_position_x * twist_cos - bar2_a_position_x;
    const real cable2_cable_span_y = cable2_b_position_x * twist_sin - bar2_a_position_y;
    const real cable2_cable_distance = cardan_sqrt(height_squared
        + cable2_cable_span_x * cable2_cable_span_x + cable2_cable_span_y * cable2_cable_span_y);
    const real cable2_cable_apart = cardan_lt(0.0, cable2_cable_distance);
    const real cable2_cable_inverse_distance = cardan_select(cable2_cable_apart, 1.0,
        0.0) / cardan_select(cable2_cable_apart, cable2_cable_distance, 1.0);
    const real cable2_cable_direction_x = cable2_cable_span_x * cable2_cable_inverse_distance;
    const real cable2_cable_direction_y = cable2_cable_span_y * cable2_cable_inverse_distance;
    const real cable2_force_on_bar2_a_x_part = cable2_EA * cardan_max(0.0,
        cable2_cable_distance / cable2_length - 1.0);
    const real twist_u_times_cable2_b_position_x = twist_u * cable2_b_position_x;
    const real cable2_force_on_bar2_a_x_part_2 = (twist_cos * twist_u_times_cable2_b_position_x *
        cable2_cable_direction_y
        - twist_sin * twist_u_times_cable2_b_position_x * cable2_cable_direction_x
        + height_q * cable2_cable_inverse_distance * height_u) / cable2_length *
        cable2_EA_times_damping;
    const real cable2_force_on_bar2_a_x_part_3 = cardan_select(cardan_lt(0.0,
        cable2_force_on_bar2_a_x_part), cardan_max(cable2_force_on_bar2_a_x_part_2,
        -cable2_force_on_bar2_a_x_part), 0.0);

    /* counter2: cable */
    /* tension = EA (strain + damping d(strain)/dt) */
    const wreal counter2_EA = w[10]; /* N */
    const wreal counter2_length = w[11]; /* m */
    const wreal counter2_b_position_x = w[40]; /* m */
    const wreal counter2_b_position_y = w[41]; /* m */
    const wreal counter2_EA_times_damping = w[47];
    const real counter2_cable_span_x = counter2_b_position_x * twist_cos - bar2_a_position_x
        - counter2_b_position_y * twist_sin;
    const real counter2_cable_span_y = counter2_b_position_x * twist_sin - bar2_a_position_y
        + counter2_b_position_y * twist_cos;
    const real counter2_cable_distance = cardan_sqrt(height_squared
        + counter2_cable_span_x * counter2_cable_span_x
        + counter2_cable_span_y * counter2_cable_span_y);
    const real counter2_cable_apart = cardan_lt(0.0, counter2_cable_distance);
    const real counter2_cable_inverse_distance = cardan_select(counter2_cable_apart, 1.0,
        0.0) / cardan_select(counter2_cable_apart, counter2_cable_distance, 1.0);
    const real counter2_cable_direction_x = counter2_cable_span_x * counter2_cable_inverse_distance;
    const real counter2_cable_direction_y = counter2_cable_span_y * counter2_cable_inverse_distance;
    const real counter2_force_on_bar2_a_x_part = counter2_EA * cardan_max(0.0,
        counter2_cable_distance / counter2_length - 1.0);
    const real counter2_force_on_bar2_a_x = counter2_cable_direction_x *
        counter2_force_on_bar2_a_x_part;
    const real counter2_force_on_bar2_a_y = counter2_cable_direction_y *
        counter2_force_on_bar2_a_x_part;
    const real twist_u_times_counter2_b_position_y = twist_u * counter2_b_position_y;
    const real twist_u_times_counter2_b_position_x = twist_u * counter2_b_position_x;
    const real counter2_force_on_bar2_a_x_part_2 = counter2_cable_direction_y * (twist_cos *
        twist_u_times_counter2_b_position_x - twist_sin * twist_u_times_counter2_b_position_y)
        - counter2_cable_direction_x * (twist_cos * twist_u_times_counter2_b_position_y
        + twist_sin * twist_u_times_counter2_b_position_x);
    const real counter2_force_on_bar2_a_x_part_3 = cardan_select(cardan_lt(0.0,
        counter2_force_on_bar2_a_x_part),
        cardan_max((height_q * counter2_cable_inverse_distance * height_u
        + counter2_force_on_bar2_a_x_part_2) / counter2_length * counter2_EA_times_damping,
        -counter2_force_on_bar2_a_x_part), 0.0);
    const real counter2_force_on_bar2_a_x_2 = counter2_cable_direction_x *
        counter2_force_on_bar2_a_x_part_3;
    const real counter2_force_on_bar2_a_y_2 = counter2_cable_direction_y *
        counter2_force_on_bar2_a_x_part_3;
    const real twist_drive_part_3 = bar0_b_position_x * (bar0_spring_damper_direction_x *
        bar0_force_on_bar0_a_x_part * twist_sin
        - bar0_spring_damper_direction_y * bar0_force_on_bar0_a_x_part * twist_cos)
        + cable0_b_position_x * (twist_sin * cable0_force_on_bar0_a_x
        - twist_cos * cable0_force_on_bar0_a_y);
    const real twist_drive_part_4 = cable0_b_position_y * (twist_cos * cable0_force_on_bar0_a_x
        + twist_sin * cable0_force_on_bar0_a_y)
        + counter0_b_position_x * (twist_sin * counter0_force_on_bar0_a_x
        - twist_cos * counter0_force_on_bar0_a_y);
    const real twist_drive_part_5 = bar1_b_position_x * (twist_sin * bar1_force_on_bar1_a_x
        - twist_cos * bar1_force_on_bar1_a_y)
        + cable2_b_position_x * (cable2_cable_direction_x * cable2_force_on_bar2_a_x_part *
        twist_sin - cable2_cable_direction_y * cable2_force_on_bar2_a_x_part * twist_cos);
    const real twist_drive_part_6 = cable1_b_position_y * (twist_cos * cable1_force_on_bar1_a_x
        + twist_sin * cable1_force_on_bar1_a_y)
        + counter2_b_position_x * (twist_sin * counter2_force_on_bar2_a_x
        - twist_cos * counter2_force_on_bar2_a_y);
    const real twist_drive_part_7 = bar1_b_position_y * (twist_cos * bar1_force_on_bar1_a_x
        + twist_sin * bar1_force_on_bar1_a_y)
        + bar2_b_position_x * (twist_sin * bar2_force_on_bar2_a_x
        - twist_cos * bar2_force_on_bar2_a_y) + twist_drive_part_5;
    const real twist_drive_part_8 = counter2_b_position_y * (twist_cos * counter2_force_on_bar2_a_x
        + twist_sin * counter2_force_on_bar2_a_y) + twist_drive_part_3
        + (counter0_b_position_y * (twist_cos * counter0_force_on_bar0_a_x
        + twist_sin * counter0_force_on_bar0_a_y) + twist_drive_part + twist_drive_part_4);
    const real twist_drive_part_9 = bar2_b_position_y * (twist_cos * bar2_force_on_bar2_a_x
        + twist_sin * bar2_force_on_bar2_a_y)
        + cable1_b_position_x * (twist_sin * cable1_force_on_bar1_a_x
        - twist_cos * cable1_force_on_bar1_a_y) + twist_drive_part_6 + twist_drive_part_8;
    const real twist_drive_part_10 = bar0_b_position_x * (bar0_spring_damper_direction_x *
        bar0_force_on_bar0_a_x_part_2 * twist_sin
        - bar0_spring_damper_direction_y * bar0_force_on_bar0_a_x_part_2 * twist_cos)
        + twist_drive_part_7 + twist_drive_part_9;
    const real twist_drive_part_11 = bar1_b_position_x * (twist_sin * bar1_force_on_bar1_a_x_2
        - twist_cos * bar1_force_on_bar1_a_y_2)
        + bar1_b_position_y * (twist_cos * bar1_force_on_bar1_a_x_2
        + twist_sin * bar1_force_on_bar1_a_y_2) + twist_drive_part_10;
    const real twist_drive_part_12 = bar2_b_position_x * (twist_sin * bar2_force_on_bar2_a_x_2
        - twist_cos * bar2_force_on_bar2_a_y_2)
        + bar2_b_position_y * (twist_cos * bar2_force_on_bar2_a_x_2
        + twist_sin * bar2_force_on_bar2_a_y_2) + twist_drive_part_11;
    const real twist_drive_part_13 = cable0_b_position_y * (twist_cos * cable0_force_on_bar0_a_x_2 +
        twist_sin * cable0_force_on_bar0_a_y_2)
        + counter0_b_position_x * (twist_sin * counter0_force_on_bar0_a_x_2
        - twist_cos * counter0_force_on_bar0_a_y_2);
    const real twist_drive_part_14 = cable1_b_position_x * (twist_sin * cable1_force_on_bar1_a_x_2 -
        twist_cos * cable1_force_on_bar1_a_y_2)
        + cable2_b_position_x * (cable2_cable_direction_x * cable2_force_on_bar2_a_x_part_3 *
        twist_sin - cable2_cable_direction_y * cable2_force_on_bar2_a_x_part_3 * twist_cos);
    const real twist_drive_part_15 = cable0_b_position_x * (twist_sin * cable0_force_on_bar0_a_x_2 -
        twist_cos * cable0_force_on_bar0_a_y_2) + twist_drive_part_12
        + counter2_b_position_y * (twist_cos * counter2_force_on_bar2_a_x_2
        + twist_sin * counter2_force_on_bar2_a_y_2);
    const real twist_drive_part_16 = cable1_b_position_y * (twist_cos * cable1_force_on_bar1_a_x_2 +
        twist_sin * cable1_force_on_bar1_a_y_2)
        + counter2_b_position_x * (twist_sin * counter2_force_on_bar2_a_x_2
        - twist_cos * counter2_force_on_bar2_a_y_2) + twist_drive_part_14;

    /* twist: drive */
    /* drive = tau + f - h */
    const real twist_drive = counter0_b_position_y * (twist_cos * counter0_force_on_bar0_a_x_2
        + twist_sin * counter0_force_on_bar0_a_y_2) + twist_drive_part_2 + twist_drive_part_13
        + twist_drive_part_15 + twist_drive_part_16;

    /* end: event, G */
    /* event = value that falls through zero */
    /* G = d(rate) / du */
    const real end = s[0];
    const wreal end_upper = w[31]; /* rad */
    const real end_eq_zero = cardan_eq(0.0, end);
    const real end_G_stop_twist = cardan_select(end_eq_zero, 0.0, 1.0);
    out[0] = cardan_select(end_eq_zero, end_upper - twist_q, 1.0); /* events: end.upper */

    /* constraints: multipliers */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const wreal M_factor_D_inverse_twist = w[48];
    const real circuit_end_stop_end_stop = end_G_stop_twist * M_factor_D_inverse_twist *
        end_G_stop_twist;
    circuit_matrix[0] = circuit_end_stop_end_stop;
    const real free_gamma_end_stop = -twist_drive * M_factor_D_inverse_twist * end_G_stop_twist;
    circuit_right[0] = free_gamma_end_stop;
    /* circuit_matrix lam = circuit_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 1, 1, circuit_matrix, circuit_right, circuit_scratch);

    /* end: multiplier stop, event */
    /* event = value that falls through zero */
    const real end_multiplier_stop = circuit_right[0];
    out[1] = cardan_select(end_eq_zero, 1.0, -end * end_multiplier_stop); /* events: end.release */
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int events_sizes[] = {2, 5, 49, 0, 2, 2, 0, 1, 0, 55, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
