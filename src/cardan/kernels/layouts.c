/* Sizes of the records that Python shares, then where their fields begin [bytes].
 *
 * Part of cardan, written by cardan.schema.records from the headers.
 */
#include <stddef.h>

#if CARDAN_LANES > 1
#include "simd_steps.h"
extern const size_t cardan_simd_layout[47];
const size_t cardan_simd_layout[47] = {
    sizeof(cardan_simd), offsetof(cardan_simd, rhs), offsetof(cardan_simd, w), offsetof(cardan_simd,
    owner), offsetof(cardan_simd, inputs), offsetof(cardan_simd, alone), offsetof(cardan_simd,
    quaternions), offsetof(cardan_simd, quaternion_count), offsetof(cardan_simd, n),
    offsetof(cardan_simd, nq), offsetof(cardan_simd, nu), offsetof(cardan_simd, nr),
    offsetof(cardan_simd, trial_step), offsetof(cardan_simd, dense), offsetof(cardan_simd, worst),
    offsetof(cardan_simd, rtol), offsetof(cardan_simd, atol), offsetof(cardan_simd, max_step),
    offsetof(cardan_simd, order), offsetof(cardan_simd, last_stage), offsetof(cardan_simd, t),
    offsetof(cardan_simd, size), offsetof(cardan_simd, until), offsetof(cardan_simd, error_before),
    offsetof(cardan_simd, span), offsetof(cardan_simd, idle), offsetof(cardan_simd, rejected),
    offsetof(cardan_simd, steps), offsetof(cardan_simd, rejections), offsetof(cardan_simd,
    evaluations), offsetof(cardan_simd, h), offsetof(cardan_simd, t_new), offsetof(cardan_simd, at),
    offsetof(cardan_simd, error), offsetof(cardan_simd, culprit), offsetof(cardan_simd, taken),
    offsetof(cardan_simd, failed), offsetof(cardan_simd, ended), offsetof(cardan_simd, y),
    offsetof(cardan_simd, trial), offsetof(cardan_simd, next), offsetof(cardan_simd, k),
    offsetof(cardan_simd, interpolant), offsetof(cardan_simd, r), offsetof(cardan_simd, s),
    offsetof(cardan_simd, zeros), offsetof(cardan_simd, work)
};
extern const size_t cardan_lane_method_layout[4];
const size_t cardan_lane_method_layout[4] = {
    sizeof(cardan_lane_method), offsetof(cardan_lane_method, trial_step),
    offsetof(cardan_lane_method, dense), offsetof(cardan_lane_method, worst)
};
#else
#include "run.h"
#include "short_runs.h"
#include "account.h"
#include "steps.h"
#include "adjoint.h"
#include "tangent.h"
#include "input_functions.h"
#include "ensemble.h"
#include "mesh.h"
#include "mesh_product.h"
#include "sparse.h"
#include "position.h"
#include "solids.h"
#include "wasm_calls.h"
extern const size_t cardan_run_layout[148];
const size_t cardan_run_layout[148] = {
    sizeof(cardan_run), offsetof(cardan_run, init), offsetof(cardan_run, step), offsetof(cardan_run,
    dense), offsetof(cardan_run, length), offsetof(cardan_run, rhs.function), offsetof(cardan_run,
    rhs.w), offsetof(cardan_run, power.function), offsetof(cardan_run, power.w),
    offsetof(cardan_run, energy.function), offsetof(cardan_run, energy.w), offsetof(cardan_run,
    rhs_jacobian.function), offsetof(cardan_run, rhs_jacobian.w), offsetof(cardan_run,
    balance.function), offsetof(cardan_run, balance.w), offsetof(cardan_run,
    balance_tangent.function), offsetof(cardan_run, balance_tangent.w), offsetof(cardan_run,
    internal_rates.function), offsetof(cardan_run, internal_rates.w), offsetof(cardan_run,
    move.function), offsetof(cardan_run, move.w), offsetof(cardan_run, qdot.function),
    offsetof(cardan_run, qdot.w), offsetof(cardan_run, mesh), offsetof(cardan_run, options),
    offsetof(cardan_run, inputs), offsetof(cardan_run, input_context), offsetof(cardan_run,
    signals), offsetof(cardan_run, quaternions), offsetof(cardan_run, nq), offsetof(cardan_run, nu),
    offsetof(cardan_run, nz), offsetof(cardan_run, nx), offsetof(cardan_run, n),
    offsetof(cardan_run, nr), offsetof(cardan_run, ns), offsetof(cardan_run, signal_count),
    offsetof(cardan_run, quaternion_count), offsetof(cardan_run, bounded), offsetof(cardan_run,
    bounded_count), offsetof(cardan_run, sampled), offsetof(cardan_run, charted),
    offsetof(cardan_run, close_position.function), offsetof(cardan_run, close_position.w),
    offsetof(cardan_run, close_velocity.function), offsetof(cardan_run, close_velocity.w),
    offsetof(cardan_run, constraint_jacobian.function), offsetof(cardan_run, constraint_jacobian.w),
    offsetof(cardan_run, columns), offsetof(cardan_run, positions), offsetof(cardan_run, rates),
    offsetof(cardan_run, size), offsetof(cardan_run, events.function), offsetof(cardan_run,
    events.w), offsetof(cardan_run, transition.function), offsetof(cardan_run, transition.w),
    offsetof(cardan_run, watch), offsetof(cardan_run, kinds), offsetof(cardan_run, ticks),
    offsetof(cardan_run, ne), offsetof(cardan_run, watched), offsetof(cardan_run, tick_count),
    offsetof(cardan_run, y), offsetof(cardan_run, y_old), offsetof(cardan_run, trial),
    offsetof(cardan_run, k), offsetof(cardan_run, f), offsetof(cardan_run, r), offsetof(cardan_run,
    s), offsetof(cardan_run, interpolant), offsetof(cardan_run, zeros), offsetof(cardan_run, work),
    offsetof(cardan_run, closing), offsetof(cardan_run, chart), offsetof(cardan_run, rank_memory),
    offsetof(cardan_run, crossing), offsetof(cardan_run, method_memory), offsetof(cardan_run, e),
    offsetof(cardan_run, board), offsetof(cardan_run, ledger), offsetof(cardan_run, stages),
    offsetof(cardan_run, dense_rows), offsetof(cardan_run, stops), offsetof(cardan_run, stop_count),
    offsetof(cardan_run, next_stop), offsetof(cardan_run, t), offsetof(cardan_run, t_old),
    offsetof(cardan_run, t_start), offsetof(cardan_run, segment), offsetof(cardan_run, until),
    offsetof(cardan_run, early), offsetof(cardan_run, late), offsetof(cardan_run, jumps),
    offsetof(cardan_run, in_segment), offsetof(cardan_run, begun), offsetof(cardan_run, rtol),
    offsetof(cardan_run, atol), offsetof(cardan_run, max_step), offsetof(cardan_run, h),
    offsetof(cardan_run, moment), offsetof(cardan_run, error_before), offsetof(cardan_run,
    correction), offsetof(cardan_run, fresh), offsetof(cardan_run, is_dense), offsetof(cardan_run,
    rejected), offsetof(cardan_run, on_grid), offsetof(cardan_run, rank_margin),
    offsetof(cardan_run, best_rank_margin), offsetof(cardan_run, pass_start), offsetof(cardan_run,
    pass_length), offsetof(cardan_run, constraint_rank), offsetof(cardan_run, ranks),
    offsetof(cardan_run, pass_points), offsetof(cardan_run, pass_part), offsetof(cardan_run,
    pass_parts), offsetof(cardan_run, passes), offsetof(cardan_run, pass_capacity),
    offsetof(cardan_run, pass_count), offsetof(cardan_run, rows), offsetof(cardan_run, nlam),
    offsetof(cardan_run, spreads), offsetof(cardan_run, later), offsetof(cardan_run, times),
    offsetof(cardan_run, time_count), offsetof(cardan_run, next_time), offsetof(cardan_run,
    capacity), offsetof(cardan_run, count), offsetof(cardan_run, row_open), offsetof(cardan_run,
    log), offsetof(cardan_run, log_capacity), offsetof(cardan_run, log_count), offsetof(cardan_run,
    event_pending), offsetof(cardan_run, at_once), offsetof(cardan_run, occurred),
    offsetof(cardan_run, steps), offsetof(cardan_run, rejections), offsetof(cardan_run,
    evaluations), offsetof(cardan_run, budget), offsetof(cardan_run, culprit), offsetof(cardan_run,
    model_status), offsetof(cardan_run, open_row), offsetof(cardan_run, projections),
    offsetof(cardan_run, passed), offsetof(cardan_run, looked), offsetof(cardan_run, limited),
    offsetof(cardan_run, jacobians), offsetof(cardan_run, factorizations), offsetof(cardan_run,
    stop)
};
extern const size_t cardan_method_layout[10];
const size_t cardan_method_layout[10] = {
    sizeof(cardan_method), offsetof(cardan_method, init), offsetof(cardan_method, step),
    offsetof(cardan_method, dense), offsetof(cardan_method, length), offsetof(cardan_method, sound),
    offsetof(cardan_method, stages), offsetof(cardan_method, dense_rows), offsetof(cardan_method,
    sources), offsetof(cardan_method, source_rows)
};
extern const size_t cardan_signal_layout[6];
const size_t cardan_signal_layout[6] = {
    sizeof(cardan_signal), offsetof(cardan_signal, input), offsetof(cardan_signal, pieces),
    offsetof(cardan_signal, where), offsetof(cardan_signal, breaks), offsetof(cardan_signal,
    coefficients)
};
extern const size_t cardan_tick_layout[6];
const size_t cardan_tick_layout[6] = {
    sizeof(cardan_tick), offsetof(cardan_tick, event), offsetof(cardan_tick, period),
    offsetof(cardan_tick, phase), offsetof(cardan_tick, count), offsetof(cardan_tick, next)
};
extern const size_t cardan_short_runs_layout[15];
const size_t cardan_short_runs_layout[15] = {
    sizeof(cardan_short_runs), offsetof(cardan_short_runs, run), offsetof(cardan_short_runs, begun),
    offsetof(cardan_short_runs, length), offsetof(cardan_short_runs, r), offsetof(cardan_short_runs,
    s), offsetof(cardan_short_runs, t), offsetof(cardan_short_runs, far),
    offsetof(cardan_short_runs, stops), offsetof(cardan_short_runs, stop_count),
    offsetof(cardan_short_runs, x), offsetof(cardan_short_runs, ends), offsetof(cardan_short_runs,
    count), offsetof(cardan_short_runs, done), offsetof(cardan_short_runs, going)
};
extern const size_t cardan_account_layout[17];
const size_t cardan_account_layout[17] = {
    sizeof(cardan_account), offsetof(cardan_account, u), offsetof(cardan_account, count),
    offsetof(cardan_account, nu), offsetof(cardan_account, stride), offsetof(cardan_account,
    every_step), offsetof(cardan_account, least), offsetof(cardan_account, energy),
    offsetof(cardan_account, supplied), offsetof(cardan_account, looked), offsetof(cardan_account,
    sources), offsetof(cardan_account, fastest), offsetof(cardan_account, turns),
    offsetof(cardan_account, kinetic), offsetof(cardan_account, potential), offsetof(cardan_account,
    exchanged), offsetof(cardan_account, missed)
};
extern const size_t cardan_steps_layout[25];
const size_t cardan_steps_layout[25] = {
    sizeof(cardan_steps), offsetof(cardan_steps, run), offsetof(cardan_steps, stages),
    offsetof(cardan_steps, kind), offsetof(cardan_steps, coupled), offsetof(cardan_steps,
    jacobian.function), offsetof(cardan_steps, jacobian.w), offsetof(cardan_steps, nodes),
    offsetof(cardan_steps, weights), offsetof(cardan_steps, matrix), offsetof(cardan_steps, rows),
    offsetof(cardan_steps, count), offsetof(cardan_steps, failed), offsetof(cardan_steps, states),
    offsetof(cardan_steps, slopes), offsetof(cardan_steps, open), offsetof(cardan_steps, end),
    offsetof(cardan_steps, place), offsetof(cardan_steps, lengths), offsetof(cardan_steps, system),
    offsetof(cardan_steps, jacobians), offsetof(cardan_steps, repeated), offsetof(cardan_steps,
    factored), offsetof(cardan_steps, factored_length), offsetof(cardan_steps, work)
};
extern const size_t cardan_adjoint_layout[23];
const size_t cardan_adjoint_layout[23] = {
    sizeof(cardan_adjoint), offsetof(cardan_adjoint, steps), offsetof(cardan_adjoint,
    rates.function), offsetof(cardan_adjoint, rates.w), offsetof(cardan_adjoint,
    close_position.function), offsetof(cardan_adjoint, close_position.w), offsetof(cardan_adjoint,
    close_velocity.function), offsetof(cardan_adjoint, close_velocity.w), offsetof(cardan_adjoint,
    integrand.function), offsetof(cardan_adjoint, integrand.w), offsetof(cardan_adjoint,
    integrand_value.function), offsetof(cardan_adjoint, integrand_value.w), offsetof(cardan_adjoint,
    np), offsetof(cardan_adjoint, lam), offsetof(cardan_adjoint, by_p), offsetof(cardan_adjoint,
    by_s), offsetof(cardan_adjoint, by_r), offsetof(cardan_adjoint, by_coefficients),
    offsetof(cardan_adjoint, cost), offsetof(cardan_adjoint, pulled), offsetof(cardan_adjoint,
    weights), offsetof(cardan_adjoint, v), offsetof(cardan_adjoint, out)
};
extern const size_t cardan_tangent_layout[27];
const size_t cardan_tangent_layout[27] = {
    sizeof(cardan_tangent), offsetof(cardan_tangent, steps), offsetof(cardan_tangent, pushed),
    offsetof(cardan_tangent, rates.function), offsetof(cardan_tangent, rates.w),
    offsetof(cardan_tangent, close_position.function), offsetof(cardan_tangent, close_position.w),
    offsetof(cardan_tangent, close_velocity.function), offsetof(cardan_tangent, close_velocity.w),
    offsetof(cardan_tangent, columns), offsetof(cardan_tangent, named), offsetof(cardan_tangent,
    wide), offsetof(cardan_tangent, named_ends), offsetof(cardan_tangent, named_columns),
    offsetof(cardan_tangent, named_changes), offsetof(cardan_tangent, by_input),
    offsetof(cardan_tangent, by_coefficients), offsetof(cardan_tangent, by_s),
    offsetof(cardan_tangent, segments), offsetof(cardan_tangent, changes), offsetof(cardan_tangent,
    before), offsetof(cardan_tangent, moved), offsetof(cardan_tangent, changed),
    offsetof(cardan_tangent, along), offsetof(cardan_tangent, rising), offsetof(cardan_tangent,
    coupled), offsetof(cardan_tangent, out)
};
extern const size_t cardan_input_function_layout[6];
const size_t cardan_input_function_layout[6] = {
    sizeof(cardan_input_function), offsetof(cardan_input_function, function),
    offsetof(cardan_input_function, reads), offsetof(cardan_input_function, gives),
    offsetof(cardan_input_function, read_count), offsetof(cardan_input_function, give_count)
};
extern const size_t cardan_input_functions_layout[13];
const size_t cardan_input_functions_layout[13] = {
    sizeof(cardan_input_functions), offsetof(cardan_input_functions, run),
    offsetof(cardan_input_functions, outputs.function), offsetof(cardan_input_functions, outputs.w),
    offsetof(cardan_input_functions, python), offsetof(cardan_input_functions, functions),
    offsetof(cardan_input_functions, count), offsetof(cardan_input_functions, values),
    offsetof(cardan_input_functions, work), offsetof(cardan_input_functions, reads),
    offsetof(cardan_input_functions, gives), offsetof(cardan_input_functions, failed),
    offsetof(cardan_input_functions, status)
};
extern const size_t cardan_run_pointer_layout[4];
const size_t cardan_run_pointer_layout[4] = {
    sizeof(cardan_run_pointer), offsetof(cardan_run_pointer, offset), offsetof(cardan_run_pointer,
    base), offsetof(cardan_run_pointer, stride)
};
extern const size_t cardan_lane_layout[7];
const size_t cardan_lane_layout[7] = {
    sizeof(cardan_lane), offsetof(cardan_lane, run), offsetof(cardan_lane, memory),
    offsetof(cardan_lane, fresh), offsetof(cardan_lane, fresh_memory), offsetof(cardan_lane,
    number), offsetof(cardan_lane, parked)
};
extern const size_t cardan_ensemble_layout[24];
const size_t cardan_ensemble_layout[24] = {
    sizeof(cardan_ensemble), offsetof(cardan_ensemble, lanes), offsetof(cardan_ensemble, simd),
    offsetof(cardan_ensemble, attempt), offsetof(cardan_ensemble, move), offsetof(cardan_ensemble,
    lane_count), offsetof(cardan_ensemble, memory_length), offsetof(cardan_ensemble, x0),
    offsetof(cardan_ensemble, r), offsetof(cardan_ensemble, pointers), offsetof(cardan_ensemble, w),
    offsetof(cardan_ensemble, count), offsetof(cardan_ensemble, pointer_count),
    offsetof(cardan_ensemble, w_size), offsetof(cardan_ensemble, timed), offsetof(cardan_ensemble,
    rows), offsetof(cardan_ensemble, x), offsetof(cardan_ensemble, numbers),
    offsetof(cardan_ensemble, ends), offsetof(cardan_ensemble, answers), offsetof(cardan_ensemble,
    next), offsetof(cardan_ensemble, finished), offsetof(cardan_ensemble, vacant),
    offsetof(cardan_ensemble, stop)
};
extern const size_t cardan_form_layout[6];
const size_t cardan_form_layout[6] = {
    sizeof(cardan_form), offsetof(cardan_form, call), offsetof(cardan_form, lanes),
    offsetof(cardan_form, w), offsetof(cardan_form, nw), offsetof(cardan_form, size)
};
extern const size_t cardan_group_layout[28];
const size_t cardan_group_layout[28] = {
    sizeof(cardan_group), offsetof(cardan_group, count), offsetof(cardan_group, places),
    offsetof(cardan_group, nq), offsetof(cardan_group, nu), offsetof(cardan_group, nz),
    offsetof(cardan_group, ns), offsetof(cardan_group, mp), offsetof(cardan_group, m),
    offsetof(cardan_group, switched), offsetof(cardan_group, z_states), offsetof(cardan_group,
    s_states), offsetof(cardan_group, ne), offsetof(cardan_group, jumps), offsetof(cardan_group,
    responses), offsetof(cardan_group, frictions), offsetof(cardan_group, inner),
    offsetof(cardan_group, inner_start), offsetof(cardan_group, place), offsetof(cardan_group,
    rows), offsetof(cardan_group, z), offsetof(cardan_group, s), offsetof(cardan_group, events),
    offsetof(cardan_group, parts), offsetof(cardan_group, spots), offsetof(cardan_group, powers),
    offsetof(cardan_group, outputs), offsetof(cardan_group, forms)
};
extern const size_t cardan_movers_layout[9];
const size_t cardan_movers_layout[9] = {
    sizeof(cardan_movers), offsetof(cardan_movers, count), offsetof(cardan_movers, nq),
    offsetof(cardan_movers, nu), offsetof(cardan_movers, place), offsetof(cardan_movers, move),
    offsetof(cardan_movers, rates), offsetof(cardan_movers, w_move), offsetof(cardan_movers,
    w_rates)
};
extern const size_t cardan_mesh_layout[33];
const size_t cardan_mesh_layout[33] = {
    sizeof(cardan_mesh), offsetof(cardan_mesh, nq), offsetof(cardan_mesh, nu), offsetof(cardan_mesh,
    nz), offsetof(cardan_mesh, ns), offsetof(cardan_mesh, nr), offsetof(cardan_mesh, mp),
    offsetof(cardan_mesh, m), offsetof(cardan_mesh, places), offsetof(cardan_mesh, nodes),
    offsetof(cardan_mesh, flats), offsetof(cardan_mesh, q), offsetof(cardan_mesh, u),
    offsetof(cardan_mesh, node), offsetof(cardan_mesh, flat), offsetof(cardan_mesh, group_count),
    offsetof(cardan_mesh, mover_count), offsetof(cardan_mesh, groups), offsetof(cardan_mesh,
    movers), offsetof(cardan_mesh, plan), offsetof(cardan_mesh, unknown), offsetof(cardan_mesh,
    diagonal), offsetof(cardan_mesh, lanes), offsetof(cardan_mesh, work), offsetof(cardan_mesh,
    local), offsetof(cardan_mesh, powers), offsetof(cardan_mesh, driven), offsetof(cardan_mesh, ne),
    offsetof(cardan_mesh, jumps), offsetof(cardan_mesh, responses), offsetof(cardan_mesh,
    frictions), offsetof(cardan_mesh, outputs), offsetof(cardan_mesh, solved)
};
extern const size_t cardan_state_layout[16];
const size_t cardan_state_layout[16] = {
    sizeof(cardan_state), offsetof(cardan_state, t), offsetof(cardan_state, q),
    offsetof(cardan_state, u), offsetof(cardan_state, udot), offsetof(cardan_state, lam),
    offsetof(cardan_state, z), offsetof(cardan_state, s), offsetof(cardan_state, r),
    offsetof(cardan_state, du), offsetof(cardan_state, inner), offsetof(cardan_state, behind),
    offsetof(cardan_state, e), offsetof(cardan_state, responses), offsetof(cardan_state, certainty),
    offsetof(cardan_state, gift)
};
extern const size_t cardan_data_slopes_layout[11];
const size_t cardan_data_slopes_layout[11] = {
    sizeof(cardan_data_slopes), offsetof(cardan_data_slopes, count), offsetof(cardan_data_slopes,
    shared), offsetof(cardan_data_slopes, start), offsetof(cardan_data_slopes, parameter),
    offsetof(cardan_data_slopes, slope), offsetof(cardan_data_slopes, first_row),
    offsetof(cardan_data_slopes, rows), offsetof(cardan_data_slopes, second_start),
    offsetof(cardan_data_slopes, second_parameters), offsetof(cardan_data_slopes, second)
};
extern const size_t cardan_summands_layout[3];
const size_t cardan_summands_layout[3] = {
    sizeof(cardan_summands), offsetof(cardan_summands, size), offsetof(cardan_summands, which)
};
extern const size_t cardan_frame_layout[9];
const size_t cardan_frame_layout[9] = {
    sizeof(cardan_frame), offsetof(cardan_frame, q), offsetof(cardan_frame, u),
    offsetof(cardan_frame, home), offsetof(cardan_frame, to_space), offsetof(cardan_frame, local),
    offsetof(cardan_frame, data), offsetof(cardan_frame, speeds), offsetof(cardan_frame, speed)
};
extern const size_t cardan_mesh_product_layout[26];
const size_t cardan_mesh_product_layout[26] = {
    sizeof(cardan_mesh_product), offsetof(cardan_mesh_product, mesh), offsetof(cardan_mesh_product,
    function), offsetof(cardan_mesh_product, results), offsetof(cardan_mesh_product, solved),
    offsetof(cardan_mesh_product, dynamics), offsetof(cardan_mesh_product, direct),
    offsetof(cardan_mesh_product, summands), offsetof(cardan_mesh_product, sums),
    offsetof(cardan_mesh_product, frame), offsetof(cardan_mesh_product, impulse),
    offsetof(cardan_mesh_product, jumps), offsetof(cardan_mesh_product, friction),
    offsetof(cardan_mesh_product, rates), offsetof(cardan_mesh_product, formula),
    offsetof(cardan_mesh_product, data), offsetof(cardan_mesh_product, np),
    offsetof(cardan_mesh_product, quaternion), offsetof(cardan_mesh_product, quaternions),
    offsetof(cardan_mesh_product, columns), offsetof(cardan_mesh_product, column),
    offsetof(cardan_mesh_product, parts), offsetof(cardan_mesh_product, part),
    offsetof(cardan_mesh_product, change), offsetof(cardan_mesh_product, curvature),
    offsetof(cardan_mesh_product, data_rows)
};
extern const size_t cardan_sparse_layout[25];
const size_t cardan_sparse_layout[25] = {
    sizeof(cardan_sparse), offsetof(cardan_sparse, n), offsetof(cardan_sparse, blocks),
    offsetof(cardan_sparse, values), offsetof(cardan_sparse, supernodes), offsetof(cardan_sparse,
    factors), offsetof(cardan_sparse, widest), offsetof(cardan_sparse, first),
    offsetof(cardan_sparse, row), offsetof(cardan_sparse, column), offsetof(cardan_sparse, at),
    offsetof(cardan_sparse, stride), offsetof(cardan_sparse, order), offsetof(cardan_sparse,
    multiplier), offsetof(cardan_sparse, start), offsetof(cardan_sparse, panel),
    offsetof(cardan_sparse, later), offsetof(cardan_sparse, open_start), offsetof(cardan_sparse,
    open), offsetof(cardan_sparse, load_start), offsetof(cardan_sparse, load),
    offsetof(cardan_sparse, run_start), offsetof(cardan_sparse, run), offsetof(cardan_sparse,
    target_start), offsetof(cardan_sparse, target)
};
extern const size_t cardan_sparse_factors_layout[18];
const size_t cardan_sparse_factors_layout[18] = {
    sizeof(cardan_sparse_factors), offsetof(cardan_sparse_factors, values),
    offsetof(cardan_sparse_factors, scale), offsetof(cardan_sparse_factors, work),
    offsetof(cardan_sparse_factors, shift), offsetof(cardan_sparse_factors, pivot),
    offsetof(cardan_sparse_factors, exchanged), offsetof(cardan_sparse_factors, replaced),
    offsetof(cardan_sparse_factors, rows), offsetof(cardan_sparse_factors, columns),
    offsetof(cardan_sparse_factors, certainty), offsetof(cardan_sparse_factors, hidden),
    offsetof(cardan_sparse_factors, compliance), offsetof(cardan_sparse_factors, count),
    offsetof(cardan_sparse_factors, weak), offsetof(cardan_sparse_factors, singular),
    offsetof(cardan_sparse_factors, positive), offsetof(cardan_sparse_factors, negative)
};
extern const size_t cardan_target_layout[10];
const size_t cardan_target_layout[10] = {
    sizeof(cardan_target), offsetof(cardan_target, rows), offsetof(cardan_target, weight),
    offsetof(cardan_target, entries), offsetof(cardan_target, value), offsetof(cardan_target,
    scale), offsetof(cardan_target, residual.function), offsetof(cardan_target, residual.w),
    offsetof(cardan_target, jacobian.function), offsetof(cardan_target, jacobian.w)
};
extern const size_t cardan_position_layout[44];
const size_t cardan_position_layout[44] = {
    sizeof(cardan_position), offsetof(cardan_position, nq), offsetof(cardan_position, nu),
    offsetof(cardan_position, positions), offsetof(cardan_position, hard_count),
    offsetof(cardan_position, hard_rows), offsetof(cardan_position, rows), offsetof(cardan_position,
    columns), offsetof(cardan_position, quaternions), offsetof(cardan_position, quaternion_count),
    offsetof(cardan_position, constraints.function), offsetof(cardan_position, constraints.w),
    offsetof(cardan_position, constraint_jacobian.function), offsetof(cardan_position,
    constraint_jacobian.w), offsetof(cardan_position, integrate.function), offsetof(cardan_position,
    integrate.w), offsetof(cardan_position, qdot.function), offsetof(cardan_position, qdot.w),
    offsetof(cardan_position, kinematics.function), offsetof(cardan_position, kinematics.w),
    offsetof(cardan_position, assembly_signs.function), offsetof(cardan_position, assembly_signs.w),
    offsetof(cardan_position, assembly_sign_count), offsetof(cardan_position, t),
    offsetof(cardan_position, z), offsetof(cardan_position, s), offsetof(cardan_position, r),
    offsetof(cardan_position, targets), offsetof(cardan_position, target_count),
    offsetof(cardan_position, rank), offsetof(cardan_position, residual_noise),
    offsetof(cardan_position, hard), offsetof(cardan_position, soft), offsetof(cardan_position,
    iteration), offsetof(cardan_position, damping), offsetof(cardan_position, q),
    offsetof(cardan_position, residuals), offsetof(cardan_position, jacobian),
    offsetof(cardan_position, memory), offsetof(cardan_position, work), offsetof(cardan_position,
    open), offsetof(cardan_position, cost), offsetof(cardan_position, freedoms),
    offsetof(cardan_position, wrong_sign)
};
extern const size_t cardan_solid_layout[17];
const size_t cardan_solid_layout[17] = {
    sizeof(cardan_solid), offsetof(cardan_solid, cells), offsetof(cardan_solid, nodes),
    offsetof(cardan_solid, points), offsetof(cardan_solid, cell), offsetof(cardan_solid, position),
    offsetof(cardan_solid, weight), offsetof(cardan_solid, shape), offsetof(cardan_solid, slope),
    offsetof(cardan_solid, elasticity), offsetof(cardan_solid, density), offsetof(cardan_solid,
    first), offsetof(cardan_solid, column), offsetof(cardan_solid, gradient), offsetof(cardan_solid,
    product), offsetof(cardan_solid, block), offsetof(cardan_solid, culprit)
};
extern const size_t cardan_wasm_function_layout[19];
const size_t cardan_wasm_function_layout[19] = {
    sizeof(cardan_wasm_function), offsetof(cardan_wasm_function, call),
    offsetof(cardan_wasm_function, delete_error), offsetof(cardan_wasm_function, delete_trap),
    offsetof(cardan_wasm_function, store), offsetof(cardan_wasm_function, run),
    offsetof(cardan_wasm_function, prepare), offsetof(cardan_wasm_function, memory),
    offsetof(cardan_wasm_function, lock), offsetof(cardan_wasm_function, at_in),
    offsetof(cardan_wasm_function, at_out), offsetof(cardan_wasm_function, at_work),
    offsetof(cardan_wasm_function, at_p), offsetof(cardan_wasm_function, at_w),
    offsetof(cardan_wasm_function, np), offsetof(cardan_wasm_function, nw),
    offsetof(cardan_wasm_function, size), offsetof(cardan_wasm_function, at),
    offsetof(cardan_wasm_function, sizes)
};
#endif
