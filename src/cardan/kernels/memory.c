/* Memory of a run out of one block, for programs that lay none out themselves.
 *
 * Part of cardan. The caller owns the block. To simulate from C:
 *
 *     cardan_run run = {0};
 *     CARDAN_METHOD(&run, dop853);
 *     run.rhs.function = rhs, run.rhs.w = w;
 *     run.nq = cardan_nq, run.nu = cardan_nu, run.nr = cardan_nr;
 *     run.nx = run.n = cardan_nq + cardan_nu;
 *     run.rtol = 1e-9, run.atol = 1e-12, run.max_step = INFINITY, run.budget = 1000000;
 *     run.stops = &end, run.stop_count = 1;
 *     cardan_run_lay(&run, memory, rest, rhs_work_size);
 *     run.y[q_hinge] = 0.5;
 *     status = cardan_run_start(&run);
 *     if (status == 0)
 *         status = cardan_run_drive(&run);
 *
 * with cardan_run_length(&run, rest, rhs_work_size) numbers of memory. `rest` is how many zeros
 * stand for outer forces: at least the number of speeds, and 6 per body where wrenches are read.
 * With constraints the work is that of the largest function, and before anything is laid out
 *
 *     run.close_position.function = close_position, run.close_position.w = w_of_it;
 *     run.close_velocity.function = close_velocity, run.close_velocity.w = w_of_it;
 *     run.constraint_jacobian.function = constraint_jacobian;
 *     run.constraint_jacobian.w = w_of_it, run.positions = ..., run.rates = ...;
 *     run.size = 1.0;
 *
 * With events `kinds` says what each is, and where one changes something
 *
 *     run.events.function = events, run.events.w = w_of_it;
 *     run.transition.function = transition, run.transition.w = w_of_it;
 *     run.ne = ..., run.kinds = ..., run.log = ..., run.log_capacity = ...;
 *     run.ns = ...;
 */
#include "run.h"

/* How many numbers cardan_run_lay needs. */
size_t cardan_run_length(const cardan_run *run, size_t rest, size_t work)
{
    size_t n = (size_t)run->n, rows = (size_t)(run->stages + run->dense_rows);

    size_t closing = (size_t)(cardan_closing_length(run) + cardan_hold_length(run)
                              + cardan_passing_length(run));
    size_t own = (size_t)run->length(run);
    size_t ledger = 4 * (size_t)(run->positions + run->rates);
    size_t chart = (size_t)cardan_chart_length(run);
    size_t events = (size_t)(run->ne + run->watched + cardan_board_length(run));

    return (4 + rows) * n + (size_t)(run->nr + run->ns) + rest + work + closing + chart + own
           + ledger + events;
}

/* The next piece of a block. */
static real *take(real **next, ptrdiff_t size)
{
    real *piece = *next;

    *next += size;
    return piece;
}

/* Point every array of the run into the block, fill it with zeros, and want no rows. */
void cardan_run_lay(cardan_run *run, real *memory, size_t rest, size_t work)
{
    size_t length = cardan_run_length(run, rest, work);
    real *next = memory;

    for (size_t i = 0; i < length; i++)
        memory[i] = 0;
    run->y = take(&next, run->n);
    run->y_old = take(&next, run->n);
    run->trial = take(&next, run->n);
    run->f = take(&next, run->n);
    run->k = take(&next, run->stages * run->n);
    run->spread = take(&next, run->dense_rows * run->n);
    run->r = take(&next, run->nr);
    run->s = take(&next, run->ns);
    run->at_rest = take(&next, (ptrdiff_t)rest);
    run->work = take(&next, (ptrdiff_t)work);
    run->closing = take(&next, cardan_closing_length(run));
    run->chart = take(&next, cardan_chart_length(run));
    run->holding = take(&next, cardan_hold_length(run));
    run->passing = take(&next, cardan_passing_length(run));
    run->own = take(&next, run->length(run));
    run->e = take(&next, run->ne + run->watched);
    run->board = take(&next, cardan_board_length(run));
    run->ledger = take(&next, 4 * (run->positions + run->rates));
    run->times = run->stops;
    run->time_count = 0;
}

/* The length of the memory of methods that have none. */
ptrdiff_t cardan_no_memory(const cardan_run *run)
{
    (void)run;
    return 0;
}
