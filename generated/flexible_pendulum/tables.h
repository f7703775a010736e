/*
 * tables.h: elements of model 'flexible_pendulum', which places they
 * couple, and the plan of its matrices.
 */
#ifndef CARDAN_TABLES_H
#define CARDAN_TABLES_H

#include "functions.h"

CARDAN_API int revolute__balance(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_revolute__balance(const wreal *p, wreal *w);
CARDAN_API int revolute__balance_tangent(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_revolute__balance_tangent(const wreal *p, wreal *w);
CARDAN_API int revolute__gamma(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_revolute__gamma(const wreal *p, wreal *w);
CARDAN_API int revolute__reaction(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_revolute__reaction(const wreal *p, wreal *w);
CARDAN_API int hellinger_reissner__balance(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_hellinger_reissner__balance(const wreal *p, wreal *w);
CARDAN_API int hellinger_reissner__balance_tangent(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_hellinger_reissner__balance_tangent(const wreal *p, wreal *w);
CARDAN_API int hellinger_reissner__energy(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_hellinger_reissner__energy(const wreal *p, wreal *w);
CARDAN_API int hellinger_reissner__stress(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_hellinger_reissner__stress(const wreal *p, wreal *w);
CARDAN_API int hellinger_reissner__mixed(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_hellinger_reissner__mixed(const wreal *p, wreal *w);
CARDAN_API int hellinger_reissner__mixed_step(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_hellinger_reissner__mixed_step(const wreal *p, wreal *w);
CARDAN_API int linked_inertia__balance(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_linked_inertia__balance(const wreal *p, wreal *w);
CARDAN_API int linked_inertia__balance_tangent(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_linked_inertia__balance_tangent(const wreal *p, wreal *w);
CARDAN_API int linked_inertia__energy(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_linked_inertia__energy(const wreal *p, wreal *w);
CARDAN_API int linked_inertia__momentum(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_linked_inertia__momentum(const wreal *p, wreal *w);
CARDAN_API int data_1__hellinger_reissner(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_data_1__hellinger_reissner(const wreal *p, wreal *w);
CARDAN_API int data_2__linked_inertia(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_data_2__linked_inertia(const wreal *p, wreal *w);

/* what 1 of kind revolute are given */

/* what 10 of kind hellinger_reissner are given */
static const double attributes_1[] = {
    0.1, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 1.0,
    0.0, 0.0, 0.10000000000000003, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.09999999999999998, 0.0, 0.0,
    0.0, 1.0, 0.0, 0.0, 0.09999999999999998, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.10000000000000009,
    0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.09999999999999998, 0.0, 0.0, 0.0, 1.0, 0.0,
    0.0, 0.09999999999999998, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.09999999999999998, 0.0, 0.0, 0.0,
    1.0, 0.0, 0.0, 0.09999999999999998, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0,
};

/* what 10 of kind linked_inertia are given */
static const double attributes_2[] = {
    0.1, 0.1, 0.10000000000000003, 0.09999999999999998, 0.09999999999999998, 0.10000000000000009, 0.09999999999999998, 0.09999999999999998, 0.09999999999999998, 0.09999999999999998,
};

/* the groups, then places that are not poses, the plan, the whole */
static const ptrdiff_t place_0[] = {
    1, 0,
};
static const ptrdiff_t rows_0[] = {
    0, 6,
};
static const ptrdiff_t spots_0[] = {
    14, 13, 26, 19, 1, 0, 7, 13, 1172, 1171, -1, 7,
};
static const ptrdiff_t parts_0[] = {
    0, -1, -1, 49, 91, -1,
};
static const ptrdiff_t place_1[] = {
    1, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 8,
    8, 9, 9, 10, 10, 11, 11, 2,
};
static const ptrdiff_t rows_1[] = {
    6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6,
    6, 6, 6, 6, 6, 6, 6, 6,
};
static const ptrdiff_t spots_1[] = {
    14, 20, 19, 199, 205, 18, 205, 211, 18, 307, 313, 18,
    313, 319, 18, 415, 421, 18, 421, 427, 18, 523, 529, 18,
    529, 535, 18, 631, 637, 18, 637, 643, 18, 739, 745, 18,
    745, 751, 18, 847, 853, 18, 853, 859, 18, 955, 961, 18,
    961, 967, 18, 1069, 1075, 18, 1075, 1063, 18, 133, 127, 12,
};
static const ptrdiff_t parts_1[] = {
    0, -1, -1, -1, -1, -1,
};
static const ptrdiff_t place_2[] = {
    1, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 8,
    8, 9, 9, 10, 10, 11, 11, 2,
};
static const ptrdiff_t rows_2[] = {
    6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6,
    6, 6, 6, 6, 6, 6, 6, 6,
};
static const ptrdiff_t spots_2[] = {
    14, 20, 19, 199, 205, 18, 205, 211, 18, 307, 313, 18,
    313, 319, 18, 415, 421, 18, 421, 427, 18, 523, 529, 18,
    529, 535, 18, 631, 637, 18, 637, 643, 18, 739, 745, 18,
    745, 751, 18, 847, 853, 18, 853, 859, 18, 955, 961, 18,
    961, 967, 18, 1069, 1075, 18, 1075, 1063, 18, 133, 127, 12,
};
static const ptrdiff_t parts_2[] = {
    0, 144, 288, -1, -1, -1,
};
static const ptrdiff_t place_of_mover_0[] = {
    0,
};
static const int32_t first_of_plan[] = {
    0, 1, 7, 13, 19, 25, 31, 37, 43, 49, 55, 61,
    67, 73,
};
static const int32_t row_of_plan[] = {
    0, 3, 7, 9, 12, 15, 18, 21, 24, 27, 30, 33,
    36, 38,
};
static const int32_t column_of_plan[] = {
    0, 1, 12, 0, 1, 3, 12, 2, 11, 1, 3, 4,
    3, 4, 5, 4, 5, 6, 5, 6, 7, 6, 7, 8,
    7, 8, 9, 8, 9, 10, 9, 10, 11, 2, 10, 11,
    0, 1,
};
static const int32_t at_of_plan[] = {
    0, 13, 127, 199, 307, 415, 523, 631, 739, 847, 955, 1063,
    1171,
};
static const int32_t stride_of_plan[] = {
    13, 19, 12, 18, 18, 18, 18, 18, 18, 18, 18, 18,
    7,
};
static const int32_t order_of_plan[] = {
    1, 2, 3, 4, 5, 6, 67, 68, 69, 70, 71, 72,
    0, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23,
    24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35,
    36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47,
    48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59,
    60, 7, 8, 9, 10, 11, 12, 61, 62, 63, 64, 65,
    66,
};
static const int32_t multiplier_of_plan[] = {
    0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0,
};
static const int32_t start_of_plan[] = {
    0, 13, 19, 25, 31, 37, 43, 49, 55, 61, 73,
};
static const int32_t panel_of_plan[] = {
    0, 364, 484, 604, 724, 844, 964, 1084, 1204, 1324,
};
static const int32_t width_of_plan[] = {
    28, 20, 20, 20, 20, 20, 20, 20, 20, 12,
};
static const int32_t later_of_plan[] = {
    6, 6, 6, 6, 6, 6, 6, 6, 6, 0,
};
static const int32_t transposed_of_plan[] = {
    20, 12, 12, 12, 12, 12, 12, 12, 12, 12,
};
static const int32_t open_start_of_plan[] = {
    0, 2, 3, 4, 5, 6, 7, 8, 9, 10, 10,
};
static const int32_t open_of_plan[] = {
    0, 1, 2, 3, 4, 5, 6, 7, 8, 9,
};
static const int32_t load_start_of_plan[] = {
    0, 10, 13, 16, 19, 22, 25, 28, 31, 34, 38,
};
static const cardan_sparse_load load_of_plan[] = {
    {0, 13, 348, 1, 1, 0, 0, 0}, {1, 13, 336, 1, 6, 0, 1, 0}, {7, 13, 342, 1, 6, 0, 67, 0}, {13, 19, 12, 6, 1, 1, 0, 0}, {14, 19, 0, 6, 6, 1, 1, 0}, {20, 19, 13, 6, 6, 1, 13, 0}, {26, 19, 6, 6, 6, 1, 67, 0}, {199, 18, 20, 6, 6, 13, 1, 1}, {1171, 7, 180, 6, 1, 67, 0, 0}, {1172, 7, 168, 6, 6, 67, 1, 0}, {205, 18, 364, 6, 6, 13, 13, 0}, {211, 18, 370, 6, 6, 13, 19, 0},
    {307, 18, 376, 6, 6, 19, 13, 1}, {313, 18, 484, 6, 6, 19, 19, 0}, {319, 18, 490, 6, 6, 19, 25, 0}, {415, 18, 496, 6, 6, 25, 19, 1}, {421, 18, 604, 6, 6, 25, 25, 0}, {427, 18, 610, 6, 6, 25, 31, 0}, {523, 18, 616, 6, 6, 31, 25, 1}, {529, 18, 724, 6, 6, 31, 31, 0}, {535, 18, 730, 6, 6, 31, 37, 0}, {631, 18, 736, 6, 6, 37, 31, 1}, {637, 18, 844, 6, 6, 37, 37, 0}, {643, 18, 850, 6, 6, 37, 43, 0},
    {739, 18, 856, 6, 6, 43, 37, 1}, {745, 18, 964, 6, 6, 43, 43, 0}, {751, 18, 970, 6, 6, 43, 49, 0}, {847, 18, 976, 6, 6, 49, 43, 1}, {853, 18, 1084, 6, 6, 49, 49, 0}, {859, 18, 1090, 6, 6, 49, 55, 0}, {955, 18, 1096, 6, 6, 55, 49, 1}, {961, 18, 1204, 6, 6, 55, 55, 0}, {967, 18, 1210, 6, 6, 55, 61, 0}, {1069, 18, 1216, 6, 6, 61, 55, 1}, {127, 12, 1324, 6, 6, 7, 7, 0}, {133, 12, 1330, 6, 6, 7, 61, 0},
    {1063, 18, 1396, 6, 6, 61, 7, 0}, {1075, 18, 1402, 6, 6, 61, 61, 0},
};
static const int32_t run_start_of_plan[] = {
    0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 9,
};
static const cardan_sparse_run run_of_plan[] = {
    {0, 6, 13, 1}, {0, 6, 19, 2}, {0, 6, 25, 3}, {0, 6, 31, 4}, {0, 6, 37, 5}, {0, 6, 43, 6}, {0, 6, 49, 7}, {0, 6, 55, 8}, {0, 6, 67, 9},
};
static const int32_t target_start_of_plan[] = {
    0, 1, 2, 3, 4, 5, 6, 7, 8, 9,
};
static const int32_t target_of_plan[] = {
    364, 484, 604, 724, 844, 964, 1084, 1204, 1402,
};
static const cardan_sparse plan = {
    .n = 73,
    .blocks = 13,
    .values = 1213,
    .supernodes = 10,
    .factors = 1468,
    .widest = 13,
    .first = first_of_plan,
    .row = row_of_plan,
    .column = column_of_plan,
    .at = at_of_plan,
    .stride = stride_of_plan,
    .order = order_of_plan,
    .multiplier = multiplier_of_plan,
    .start = start_of_plan,
    .panel = panel_of_plan,
    .width = width_of_plan,
    .later = later_of_plan,
    .transposed = transposed_of_plan,
    .open_start = open_start_of_plan,
    .open = open_of_plan,
    .load_start = load_start_of_plan,
    .load = load_of_plan,
    .run_start = run_start_of_plan,
    .run = run_of_plan,
    .target_start = target_start_of_plan,
    .target = target_of_plan,
};
static const ptrdiff_t q_of_mesh[] = {
    0, 1, 8, 15, 22, 29, 36, 43, 50, 57, 64, 71,
    78,
};
static const ptrdiff_t u_of_mesh[] = {
    0, 1, 7, 13, 19, 25, 31, 37, 43, 49, 55, 61,
    67,
};
static const ptrdiff_t node_of_mesh[] = {
    1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11,
};
static const ptrdiff_t unknown_of_mesh[] = {
    67, 68, 69, 70, 71, 72,
};
static const ptrdiff_t diagonal_of_mesh[] = {
    0, 14, 34, 54, 74, 94, 114, 127, 140, 153, 166, 179,
    192, 205, 224, 243, 262, 281, 300, 313, 332, 351, 370, 389,
    408, 421, 440, 459, 478, 497, 516, 529, 548, 567, 586, 605,
    624, 637, 656, 675, 694, 713, 732, 745, 764, 783, 802, 821,
    840, 853, 872, 891, 910, 929, 948, 961, 980, 999, 1018, 1037,
    1056, 1075, 1094, 1113, 1132, 1151, 1170,
};
static const cardan_group groups[] = {
    {.count = 1, .places = 2, .nq = 8, .nu = 7, .nz = 0, .ns = 0, .mp = 6, .m = 6, .z_states = 0, .s_states = 0, .ne = 0, .jumps = 0, .responses = 0, .inner = 0, .inner_start = 0, .place = place_0, .rows = rows_0, .spots = spots_0, .z = NULL, .s = NULL, .events = NULL, .powers = NULL, .outputs = NULL, .parts = parts_0},
    {.count = 10, .places = 2, .nq = 14, .nu = 12, .nz = 0, .ns = 0, .mp = 0, .m = 0, .z_states = 0, .s_states = 0, .ne = 0, .jumps = 0, .responses = 0, .inner = 6, .inner_start = 0, .place = place_1, .rows = rows_1, .spots = spots_1, .z = NULL, .s = NULL, .events = NULL, .powers = NULL, .outputs = NULL, .parts = parts_1},
    {.count = 10, .places = 2, .nq = 14, .nu = 12, .nz = 0, .ns = 0, .mp = 0, .m = 0, .z_states = 0, .s_states = 0, .ne = 0, .jumps = 0, .responses = 0, .inner = 0, .inner_start = 0, .place = place_2, .rows = rows_2, .spots = spots_2, .z = NULL, .s = NULL, .events = NULL, .powers = NULL, .outputs = NULL, .parts = parts_2},
};
static const cardan_movers movers[] = {
    {.count = 1, .nq = 1, .nu = 1, .place = place_of_mover_0},
};
static const cardan_mesh mesh = {
    .nq = 78,
    .nu = 67,
    .nz = 0,
    .ns = 0,
    .mp = 6,
    .m = 6,
    .nr = 0,
    .q = q_of_mesh,
    .u = u_of_mesh,
    .places = 12,
    .nodes = 11,
    .node = node_of_mesh,
    .flats = 0,
    .flat = NULL,
    .unknown = unknown_of_mesh,
    .diagonal = diagonal_of_mesh,
    .work = 0,
    .local = 488,
    .powers = 0,
    .driven = 0,
    .outputs = 0,
    .solved = 0,
    .ne = 0,
    .jumps = 0,
    .responses = 0,
    .groups = groups,
    .group_count = 3,
    .movers = movers,
    .mover_count = 1,
    .plan = &plan,
    .lanes = 1,
};
static const cardan_element_function element_functions[] = {
    {.group = 0, .form = CARDAN_BALANCE, .function = revolute__balance, .prepare = prepare_revolute__balance, .nw = 0, .size = 19},
    {.group = 0, .form = CARDAN_TANGENT, .function = revolute__balance_tangent, .prepare = prepare_revolute__balance_tangent, .nw = 0, .size = 133},
    {.group = 0, .form = CARDAN_GAMMA, .function = revolute__gamma, .prepare = prepare_revolute__gamma, .nw = 0, .size = 6},
    {.group = 0, .form = CARDAN_REACTION, .function = revolute__reaction, .prepare = prepare_revolute__reaction, .nw = 0, .size = 6},
    {.group = 1, .form = CARDAN_BALANCE, .function = hellinger_reissner__balance, .prepare = prepare_hellinger_reissner__balance, .nw = 18, .size = 12},
    {.group = 1, .form = CARDAN_TANGENT, .function = hellinger_reissner__balance_tangent, .prepare = prepare_hellinger_reissner__balance_tangent, .nw = 18, .size = 144},
    {.group = 1, .form = CARDAN_ENERGY, .function = hellinger_reissner__energy, .prepare = prepare_hellinger_reissner__energy, .nw = 18, .size = 2},
    {.group = 1, .form = CARDAN_STRESS, .function = hellinger_reissner__stress, .prepare = prepare_hellinger_reissner__stress, .nw = 24, .size = 24},
    {.group = 1, .form = CARDAN_MIXED, .function = hellinger_reissner__mixed, .prepare = prepare_hellinger_reissner__mixed, .nw = 18, .size = 156},
    {.group = 1, .form = CARDAN_MIXED_STEP, .function = hellinger_reissner__mixed_step, .prepare = prepare_hellinger_reissner__mixed_step, .nw = 18, .size = 6},
    {.group = 2, .form = CARDAN_BALANCE, .function = linked_inertia__balance, .prepare = prepare_linked_inertia__balance, .nw = 12, .size = 12},
    {.group = 2, .form = CARDAN_TANGENT, .function = linked_inertia__balance_tangent, .prepare = prepare_linked_inertia__balance_tangent, .nw = 15, .size = 432},
    {.group = 2, .form = CARDAN_ENERGY, .function = linked_inertia__energy, .prepare = prepare_linked_inertia__energy, .nw = 14, .size = 2},
    {.group = 2, .form = CARDAN_MOMENTUM, .function = linked_inertia__momentum, .prepare = prepare_linked_inertia__momentum, .nw = 11, .size = 6},
};
static const cardan_element_data element_data[] = {
    {.size = 0},
    {.function = data_1__hellinger_reissner, .prepare = prepare_data_1__hellinger_reissner, .size = 12, .nw = 5, .each = 12, .alike = 1, .attributes = attributes_1, .more = 7},
    {.function = data_2__linked_inertia, .prepare = prepare_data_2__linked_inertia, .size = 10, .nw = 7, .each = 10, .alike = 1, .attributes = attributes_2, .more = 1},
};
static const double locked[] = {
    1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    1.0,
};
static const cardan_elements elements = {
    .mesh = &mesh,
    .functions = element_functions,
    .function_count = 14,
    .data = element_data,
    .data_room = 207,
    .nw = 1660,
    .locked = locked,
};

#endif
