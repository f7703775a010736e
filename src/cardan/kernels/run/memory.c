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
 * with cardan_run_length(&run, rest, rhs_work_size) numbers of memory. `tail` is how many zeros
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
#include "events.h"
#include "run.h"

/* Point every array of a run into the block; returns how many numbers that takes. */
static size_t lay(cardan_run *run, real *block, size_t tail, size_t work)
{
    ptrdiff_t used = 0;

    run->y = cardan_reserve(block, &used, run->n);
    run->y_old = cardan_reserve(block, &used, run->n);
    run->trial = cardan_reserve(block, &used, run->n);
    run->f = cardan_reserve(block, &used, run->n);
    run->k = cardan_reserve(block, &used, run->stages * run->n);
    run->interpolant = cardan_reserve(block, &used, run->dense_rows * run->n);
    run->r = cardan_reserve(block, &used, run->nr);
    run->s = cardan_reserve(block, &used, run->ns);
    run->zeros = cardan_reserve(block, &used, (ptrdiff_t)tail);
    run->work = cardan_reserve(block, &used, (ptrdiff_t)work);
    run->closing = cardan_reserve(block, &used, cardan_closing_length(run));
    run->chart = cardan_reserve(block, &used, cardan_chart_length(run));
    run->rank_memory = cardan_reserve(block, &used, cardan_rank_length(run));
    run->crossing = cardan_reserve(block, &used, cardan_crossing_length(run));
    run->method_memory = cardan_reserve(block, &used, run->length(run));
    run->e = cardan_reserve(block, &used, run->ne + run->watched);
    run->board = cardan_reserve(block, &used, cardan_board_length(run));
    run->ledger = cardan_reserve(block, &used, 4 * (run->positions + run->rates));
    return (size_t)used;
}

/* How many numbers cardan_run_lay needs. */
size_t cardan_run_length(const cardan_run *run, size_t tail, size_t work)
{
    cardan_run measured = *run;

    return lay(&measured, NULL, tail, work);
}

/* Point every array of the run into a block of zeros, and want no rows. */
void cardan_run_place(cardan_run *run, real *memory, size_t tail, size_t work)
{
    (void)lay(run, memory, tail, work);
    run->times = run->stops;
    run->time_count = 0;
}

/* The same for a block of any numbers: it is filled with zeros first. */
void cardan_run_lay(cardan_run *run, real *memory, size_t tail, size_t work)
{
    const size_t length = cardan_run_length(run, tail, work);

    for (size_t i = 0; i < length; i++)
        memory[i] = 0;
    cardan_run_place(run, memory, tail, work);
}

/* The length of the memory of methods that have none. */
ptrdiff_t cardan_no_memory(const cardan_run *run)
{
    (void)run;
    return 0;
}
