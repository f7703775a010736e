/*
 * tables.h: elements of model 'flexible_pendulum', which places they
 * couple, and the plan of its matrices.
 */
#ifndef CARDAN_TABLES_H
#define CARDAN_TABLES_H

#include "functions.h"

CARDAN_API int tree__bodies(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_tree__bodies(const wreal *p, wreal *w);
CARDAN_API int hellinger_reissner_tree__balance(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_hellinger_reissner_tree__balance(const wreal *p, wreal *w);
CARDAN_API int hellinger_reissner_tree__balance_tangent(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_hellinger_reissner_tree__balance_tangent(const wreal *p, wreal *w);
CARDAN_API int hellinger_reissner_tree__energy(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_hellinger_reissner_tree__energy(const wreal *p, wreal *w);
CARDAN_API int hellinger_reissner_tree__stress(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_hellinger_reissner_tree__stress(const wreal *p, wreal *w);
CARDAN_API int hellinger_reissner_tree__mixed(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_hellinger_reissner_tree__mixed(const wreal *p, wreal *w);
CARDAN_API int hellinger_reissner_tree__mixed_step(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_hellinger_reissner_tree__mixed_step(const wreal *p, wreal *w);
CARDAN_API int hellinger_reissner_tree__reactions(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_hellinger_reissner_tree__reactions(const wreal *p, wreal *w);
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
CARDAN_API int linked_inertia_tree__balance(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_linked_inertia_tree__balance(const wreal *p, wreal *w);
CARDAN_API int linked_inertia_tree__balance_tangent(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_linked_inertia_tree__balance_tangent(const wreal *p, wreal *w);
CARDAN_API int linked_inertia_tree__energy(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_linked_inertia_tree__energy(const wreal *p, wreal *w);
CARDAN_API int linked_inertia_tree__momentum(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_linked_inertia_tree__momentum(const wreal *p, wreal *w);
CARDAN_API int linked_inertia_tree__reactions(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_linked_inertia_tree__reactions(const wreal *p, wreal *w);
CARDAN_API int linked_inertia__balance(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_linked_inertia__balance(const wreal *p, wreal *w);
CARDAN_API int linked_inertia__balance_tangent(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_linked_inertia__balance_tangent(const wreal *p, wreal *w);
CARDAN_API int linked_inertia__energy(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_linked_inertia__energy(const wreal *p, wreal *w);
CARDAN_API int linked_inertia__momentum(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_linked_inertia__momentum(const wreal *p, wreal *w);
CARDAN_API int data_0__tree(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_data_0__tree(const wreal *p, wreal *w);
CARDAN_API int data_1__hellinger_reissner_tree(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_data_1__hellinger_reissner_tree(const wreal *p, wreal *w);
CARDAN_API int data_2__hellinger_reissner(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_data_2__hellinger_reissner(const wreal *p, wreal *w);
CARDAN_API int data_3__linked_inertia_tree(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_data_3__linked_inertia_tree(const wreal *p, wreal *w);
CARDAN_API int data_4__linked_inertia(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_data_4__linked_inertia(const wreal *p, wreal *w);

/* what 1 of kind tree are given */

/* what 1 of kind hellinger_reissner_tree are given */
static const double attributes_1[] = {
    0.1, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0,
};

/* what 9 of kind hellinger_reissner are given */
static const double attributes_2[] = {
    0.1, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.10000000000000003, 0.0, 0.0, 0.0, 1.0,
    0.0, 0.0, 0.09999999999999998, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.09999999999999998, 0.0, 0.0,
    0.0, 1.0, 0.0, 0.0, 0.10000000000000009, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.09999999999999998,
    0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.09999999999999998, 0.0, 0.0, 0.0, 1.0, 0.0,
    0.0, 0.09999999999999998, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.09999999999999998, 0.0, 0.0, 0.0,
    1.0, 0.0, 0.0,
};

/* what 1 of kind linked_inertia_tree are given */
static const double attributes_3[] = {
    0.1,
};

/* what 9 of kind linked_inertia are given */
static const double attributes_4[] = {
    0.1, 0.10000000000000003, 0.09999999999999998, 0.09999999999999998, 0.10000000000000009, 0.09999999999999998, 0.09999999999999998, 0.09999999999999998, 0.09999999999999998,
};

/* the groups, then places that are not poses, the plan, the whole */
static const ptrdiff_t place_0[] = {
    0,
};
static const ptrdiff_t rows_0[] = {
    0, 0,
};
static const ptrdiff_t spots_0[] = {
    0, 7,
};
static const ptrdiff_t parts_0[] = {
    -1, -1, -1, -1, -1, -1, -1,
};
static const ptrdiff_t place_1[] = {
    0, 2,
};
static const ptrdiff_t rows_1[] = {
    0, 0,
};
static const ptrdiff_t spots_1[] = {
    0, 1, 7, 79, 80, 13,
};
static const ptrdiff_t parts_1[] = {
    0, -1, -1, -1, -1, -1, -1,
};
static const ptrdiff_t place_2[] = {
    2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 8,
    8, 9, 9, 10, 10, 1,
};
static const ptrdiff_t rows_2[] = {
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0,
};
static const ptrdiff_t spots_2[] = {
    80, 86, 13, 157, 163, 18, 163, 169, 18, 265, 271, 18,
    271, 277, 18, 373, 379, 18, 379, 385, 18, 481, 487, 18,
    487, 493, 18, 589, 595, 18, 595, 601, 18, 697, 703, 18,
    703, 709, 18, 805, 811, 18, 811, 817, 18, 919, 925, 18,
    925, 913, 18, 13, 7, 12,
};
static const ptrdiff_t parts_2[] = {
    0, -1, -1, -1, -1, -1, -1,
};
static const ptrdiff_t place_3[] = {
    0, 2,
};
static const ptrdiff_t rows_3[] = {
    0, 0,
};
static const ptrdiff_t spots_3[] = {
    0, 1, 7, 79, 80, 13,
};
static const ptrdiff_t parts_3[] = {
    0, 49, 98, -1, -1, -1, -1,
};
static const ptrdiff_t place_4[] = {
    2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 8,
    8, 9, 9, 10, 10, 1,
};
static const ptrdiff_t rows_4[] = {
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0,
};
static const ptrdiff_t spots_4[] = {
    80, 86, 13, 157, 163, 18, 163, 169, 18, 265, 271, 18,
    271, 277, 18, 373, 379, 18, 379, 385, 18, 481, 487, 18,
    487, 493, 18, 589, 595, 18, 595, 601, 18, 697, 703, 18,
    703, 709, 18, 805, 811, 18, 811, 817, 18, 919, 925, 18,
    925, 913, 18, 13, 7, 12,
};
static const ptrdiff_t parts_4[] = {
    0, 144, 288, -1, -1, -1, -1,
};
static const ptrdiff_t place_of_mover_0[] = {
    0,
};
static const int32_t first_of_plan[] = {
    0, 1, 7, 13, 19, 25, 31, 37, 43, 49, 55, 61,
};
static const int32_t row_of_plan[] = {
    0, 2, 4, 7, 10, 13, 16, 19, 22, 25, 28, 31,
};
static const int32_t column_of_plan[] = {
    0, 2, 1, 10, 0, 2, 3, 2, 3, 4, 3, 4,
    5, 4, 5, 6, 5, 6, 7, 6, 7, 8, 7, 8,
    9, 8, 9, 10, 1, 9, 10,
};
static const int32_t at_of_plan[] = {
    0, 7, 79, 157, 265, 373, 481, 589, 697, 805, 913,
};
static const int32_t stride_of_plan[] = {
    7, 12, 13, 18, 18, 18, 18, 18, 18, 18, 18,
};
static const int32_t order_of_plan[] = {
    7, 8, 9, 10, 11, 12, 0, 13, 14, 15, 16, 17,
    18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29,
    30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41,
    42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53,
    54, 1, 2, 3, 4, 5, 6, 55, 56, 57, 58, 59,
    60,
};
static const int32_t multiplier_of_plan[] = {
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0,
};
static const int32_t start_of_plan[] = {
    0, 7, 13, 19, 25, 31, 37, 43, 49, 61,
};
static const int32_t panel_of_plan[] = {
    0, 133, 241, 349, 457, 565, 673, 781, 889,
};
static const int32_t later_of_plan[] = {
    6, 6, 6, 6, 6, 6, 6, 6, 0,
};
static const int32_t open_start_of_plan[] = {
    0, 2, 3, 4, 5, 6, 7, 8, 9, 9,
};
static const int32_t open_of_plan[] = {
    0, 1, 2, 3, 4, 5, 6, 7, 8,
};
static const int32_t load_start_of_plan[] = {
    0, 6, 9, 12, 15, 18, 21, 24, 27, 31,
};
static const cardan_sparse_load load_of_plan[] = {
    {0, 7, 48, 1, 1, 0, 0, 0}, {1, 7, 42, 1, 6, 0, 7, 0}, {79, 13, 6, 6, 1, 7, 0, 0}, {80, 13, 0, 6, 6, 7, 7, 0}, {86, 13, 49, 6, 6, 7, 13, 0}, {157, 18, 91, 6, 6, 13, 7, 1}, {163, 18, 133, 6, 6, 13, 13, 0}, {169, 18, 169, 6, 6, 13, 19, 0}, {265, 18, 205, 6, 6, 19, 13, 1}, {271, 18, 241, 6, 6, 19, 19, 0}, {277, 18, 277, 6, 6, 19, 25, 0}, {373, 18, 313, 6, 6, 25, 19, 1},
    {379, 18, 349, 6, 6, 25, 25, 0}, {385, 18, 385, 6, 6, 25, 31, 0}, {481, 18, 421, 6, 6, 31, 25, 1}, {487, 18, 457, 6, 6, 31, 31, 0}, {493, 18, 493, 6, 6, 31, 37, 0}, {589, 18, 529, 6, 6, 37, 31, 1}, {595, 18, 565, 6, 6, 37, 37, 0}, {601, 18, 601, 6, 6, 37, 43, 0}, {697, 18, 637, 6, 6, 43, 37, 1}, {703, 18, 673, 6, 6, 43, 43, 0}, {709, 18, 709, 6, 6, 43, 49, 0}, {805, 18, 745, 6, 6, 49, 43, 1},
    {811, 18, 781, 6, 6, 49, 49, 0}, {817, 18, 817, 6, 6, 49, 55, 0}, {919, 18, 853, 6, 6, 55, 49, 1}, {7, 12, 889, 6, 6, 1, 1, 0}, {13, 12, 895, 6, 6, 1, 55, 0}, {913, 18, 961, 6, 6, 55, 1, 0}, {925, 18, 967, 6, 6, 55, 55, 0},
};
static const int32_t run_start_of_plan[] = {
    0, 1, 2, 3, 4, 5, 6, 7, 8, 8,
};
static const cardan_sparse_run run_of_plan[] = {
    {0, 6, 7, 1}, {0, 6, 13, 2}, {0, 6, 19, 3}, {0, 6, 25, 4}, {0, 6, 31, 5}, {0, 6, 37, 6}, {0, 6, 43, 7}, {0, 6, 55, 8},
};
static const int32_t target_start_of_plan[] = {
    0, 1, 2, 3, 4, 5, 6, 7, 8,
};
static const int32_t target_of_plan[] = {
    133, 241, 349, 457, 565, 673, 781, 967,
};
static const cardan_sparse plan = {
    .n = 61,
    .blocks = 11,
    .values = 1021,
    .supernodes = 9,
    .factors = 1033,
    .widest = 12,
    .first = first_of_plan,
    .row = row_of_plan,
    .column = column_of_plan,
    .at = at_of_plan,
    .stride = stride_of_plan,
    .order = order_of_plan,
    .multiplier = multiplier_of_plan,
    .start = start_of_plan,
    .panel = panel_of_plan,
    .later = later_of_plan,
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
};
static const ptrdiff_t u_of_mesh[] = {
    0, 1, 7, 13, 19, 25, 31, 37, 43, 49, 55, 61,
};
static const ptrdiff_t node_of_mesh[] = {
    1, 2, 3, 4, 5, 6, 7, 8, 9, 10,
};
static const ptrdiff_t diagonal_of_mesh[] = {
    0, 7, 20, 33, 46, 59, 72, 80, 94, 108, 122, 136,
    150, 163, 182, 201, 220, 239, 258, 271, 290, 309, 328, 347,
    366, 379, 398, 417, 436, 455, 474, 487, 506, 525, 544, 563,
    582, 595, 614, 633, 652, 671, 690, 703, 722, 741, 760, 779,
    798, 811, 830, 849, 868, 887, 906, 925, 944, 963, 982, 1001,
    1020,
};
static const cardan_group groups[] = {
    {.count = 1, .places = 1, .nq = 1, .nu = 1, .nz = 0, .ns = 0, .mp = 0, .m = 0, .switched = 0, .z_states = 0, .s_states = 0, .ne = 0, .jumps = 0, .responses = 0, .frictions = 0, .inner = 0, .inner_start = 0, .place = place_0, .rows = rows_0, .spots = spots_0, .z = NULL, .s = NULL, .events = NULL, .powers = NULL, .outputs = NULL, .parts = parts_0},
    {.count = 1, .places = 2, .nq = 8, .nu = 7, .nz = 0, .ns = 0, .mp = 0, .m = 0, .switched = 0, .z_states = 0, .s_states = 0, .ne = 0, .jumps = 0, .responses = 0, .frictions = 0, .inner = 6, .inner_start = 0, .place = place_1, .rows = rows_1, .spots = spots_1, .z = NULL, .s = NULL, .events = NULL, .powers = NULL, .outputs = NULL, .parts = parts_1},
    {.count = 9, .places = 2, .nq = 14, .nu = 12, .nz = 0, .ns = 0, .mp = 0, .m = 0, .switched = 0, .z_states = 0, .s_states = 0, .ne = 0, .jumps = 0, .responses = 0, .frictions = 0, .inner = 6, .inner_start = 6, .place = place_2, .rows = rows_2, .spots = spots_2, .z = NULL, .s = NULL, .events = NULL, .powers = NULL, .outputs = NULL, .parts = parts_2},
    {.count = 1, .places = 2, .nq = 8, .nu = 7, .nz = 0, .ns = 0, .mp = 0, .m = 0, .switched = 0, .z_states = 0, .s_states = 0, .ne = 0, .jumps = 0, .responses = 0, .frictions = 0, .inner = 0, .inner_start = 0, .place = place_3, .rows = rows_3, .spots = spots_3, .z = NULL, .s = NULL, .events = NULL, .powers = NULL, .outputs = NULL, .parts = parts_3},
    {.count = 9, .places = 2, .nq = 14, .nu = 12, .nz = 0, .ns = 0, .mp = 0, .m = 0, .switched = 0, .z_states = 0, .s_states = 0, .ne = 0, .jumps = 0, .responses = 0, .frictions = 0, .inner = 0, .inner_start = 0, .place = place_4, .rows = rows_4, .spots = spots_4, .z = NULL, .s = NULL, .events = NULL, .powers = NULL, .outputs = NULL, .parts = parts_4},
};
static const cardan_movers movers[] = {
    {.count = 1, .nq = 1, .nu = 1, .place = place_of_mover_0},
};
static const cardan_mesh mesh = {
    .nq = 71,
    .nu = 61,
    .nz = 0,
    .ns = 0,
    .mp = 0,
    .m = 0,
    .nr = 0,
    .q = q_of_mesh,
    .u = u_of_mesh,
    .places = 11,
    .nodes = 10,
    .node = node_of_mesh,
    .flats = 0,
    .flat = NULL,
    .unknown = NULL,
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
    .frictions = 0,
    .groups = groups,
    .group_count = 5,
    .movers = movers,
    .mover_count = 1,
    .plan = &plan,
    .lanes = 1,
};
static const cardan_element_function element_functions[] = {
    {.group = 0, .form = CARDAN_BODIES, .function = tree__bodies, .prepare = prepare_tree__bodies, .nw = 1, .size = 24},
    {.group = 1, .form = CARDAN_BALANCE, .function = hellinger_reissner_tree__balance, .prepare = prepare_hellinger_reissner_tree__balance, .nw = 18, .size = 7},
    {.group = 1, .form = CARDAN_TANGENT, .function = hellinger_reissner_tree__balance_tangent, .prepare = prepare_hellinger_reissner_tree__balance_tangent, .nw = 18, .size = 49},
    {.group = 1, .form = CARDAN_ENERGY, .function = hellinger_reissner_tree__energy, .prepare = prepare_hellinger_reissner_tree__energy, .nw = 18, .size = 2},
    {.group = 1, .form = CARDAN_STRESS, .function = hellinger_reissner_tree__stress, .prepare = prepare_hellinger_reissner_tree__stress, .nw = 24, .size = 24},
    {.group = 1, .form = CARDAN_MIXED, .function = hellinger_reissner_tree__mixed, .prepare = prepare_hellinger_reissner_tree__mixed, .nw = 18, .size = 56},
    {.group = 1, .form = CARDAN_MIXED_STEP, .function = hellinger_reissner_tree__mixed_step, .prepare = prepare_hellinger_reissner_tree__mixed_step, .nw = 18, .size = 6},
    {.group = 1, .form = CARDAN_REACTIONS, .function = hellinger_reissner_tree__reactions, .prepare = prepare_hellinger_reissner_tree__reactions, .nw = 18, .size = 6},
    {.group = 2, .form = CARDAN_BALANCE, .function = hellinger_reissner__balance, .prepare = prepare_hellinger_reissner__balance, .nw = 18, .size = 12},
    {.group = 2, .form = CARDAN_TANGENT, .function = hellinger_reissner__balance_tangent, .prepare = prepare_hellinger_reissner__balance_tangent, .nw = 18, .size = 144},
    {.group = 2, .form = CARDAN_ENERGY, .function = hellinger_reissner__energy, .prepare = prepare_hellinger_reissner__energy, .nw = 18, .size = 2},
    {.group = 2, .form = CARDAN_STRESS, .function = hellinger_reissner__stress, .prepare = prepare_hellinger_reissner__stress, .nw = 24, .size = 24},
    {.group = 2, .form = CARDAN_MIXED, .function = hellinger_reissner__mixed, .prepare = prepare_hellinger_reissner__mixed, .nw = 18, .size = 156},
    {.group = 2, .form = CARDAN_MIXED_STEP, .function = hellinger_reissner__mixed_step, .prepare = prepare_hellinger_reissner__mixed_step, .nw = 18, .size = 6},
    {.group = 3, .form = CARDAN_BALANCE, .function = linked_inertia_tree__balance, .prepare = prepare_linked_inertia_tree__balance, .nw = 19, .size = 7},
    {.group = 3, .form = CARDAN_TANGENT, .function = linked_inertia_tree__balance_tangent, .prepare = prepare_linked_inertia_tree__balance_tangent, .nw = 17, .size = 147},
    {.group = 3, .form = CARDAN_ENERGY, .function = linked_inertia_tree__energy, .prepare = prepare_linked_inertia_tree__energy, .nw = 13, .size = 2},
    {.group = 3, .form = CARDAN_MOMENTUM, .function = linked_inertia_tree__momentum, .prepare = prepare_linked_inertia_tree__momentum, .nw = 10, .size = 6},
    {.group = 3, .form = CARDAN_REACTIONS, .function = linked_inertia_tree__reactions, .prepare = prepare_linked_inertia_tree__reactions, .nw = 17, .size = 6},
    {.group = 4, .form = CARDAN_BALANCE, .function = linked_inertia__balance, .prepare = prepare_linked_inertia__balance, .nw = 12, .size = 12},
    {.group = 4, .form = CARDAN_TANGENT, .function = linked_inertia__balance_tangent, .prepare = prepare_linked_inertia__balance_tangent, .nw = 15, .size = 432},
    {.group = 4, .form = CARDAN_ENERGY, .function = linked_inertia__energy, .prepare = prepare_linked_inertia__energy, .nw = 14, .size = 2},
    {.group = 4, .form = CARDAN_MOMENTUM, .function = linked_inertia__momentum, .prepare = prepare_linked_inertia__momentum, .nw = 11, .size = 6},
};
static const cardan_element_data element_data[] = {
    {.function = data_0__tree, .prepare = prepare_data_0__tree, .size = 1, .nw = 1, .each = 1, .alike = 1},
    {.function = data_1__hellinger_reissner_tree, .prepare = prepare_data_1__hellinger_reissner_tree, .size = 12, .nw = 5, .each = 12, .alike = 1, .attributes = attributes_1, .more = 7},
    {.function = data_2__hellinger_reissner, .prepare = prepare_data_2__hellinger_reissner, .size = 12, .nw = 5, .each = 12, .alike = 1, .attributes = attributes_2, .more = 7},
    {.function = data_3__linked_inertia_tree, .prepare = prepare_data_3__linked_inertia_tree, .size = 10, .nw = 7, .each = 10, .alike = 1, .attributes = attributes_3, .more = 1},
    {.function = data_4__linked_inertia, .prepare = prepare_data_4__linked_inertia, .size = 10, .nw = 7, .each = 10, .alike = 1, .attributes = attributes_4, .more = 1},
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
};
static const cardan_elements elements = {
    .mesh = &mesh,
    .functions = element_functions,
    .function_count = 23,
    .data = element_data,
    .data_room = 188,
    .nw = 1703,
    .locked = locked,
};

#endif
