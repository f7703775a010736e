/* Times at which an exported model jumps: comparisons of t, such as of Piecewise, that change there.
 *
 * Part of cardan. Caller owns all memory; see jumps.h.
 */
#include "jumps.h"

/* times of a span at which every comparison is looked at: what changes twice between two of them is
 * not seen */
enum { LOOKS = 4097, HALVINGS = 200 };

/* Comparisons of the model over a span, and room for their results at three times. */
typedef struct comparisons {
    const cardan_exported_function *function;
    const wreal *w;
    ptrdiff_t count;
    real start, end;
    real *before, *after, *halfway, *work;
} comparisons;

static ptrdiff_t number_of(const cardan_export *model)
{
    for (ptrdiff_t k = 0; k < model->function_count; k++)
        if (strcmp(model->functions[k].name, "time_jumps") == 0)
            return k;
    return -1;
}

size_t cardan_jumps_capacity(const cardan_export *model)
{
    const ptrdiff_t k = number_of(model);

    return k < 0 ? 0 : (size_t)(LOOKS - 1) * (size_t)model->functions[k].out;
}

size_t cardan_jumps_work_length(const cardan_export *model)
{
    const ptrdiff_t k = number_of(model);

    return k < 0 ? 0 : (size_t)(3 * model->functions[k].out + model->functions[k].work);
}

/* Evaluate what comparisons compare with zero: they hold below it. */
static int evaluate(const comparisons *all, real t, real *out)
{
    const cardan_in in = {.t = &t, .w = all->w};

    return all->function->function(&in, out, all->work);
}

/* Find where comparison i, which changes between two times, does so: to the last bit. Where its sides
 * are equal neither neighbor is on the wrong one, whether < or <= is asked. */
static int bisect(const comparisons *all, ptrdiff_t i, real low, real high, real *jump)
{
    const int holds = all->before[i] < 0;
    int status = 0;

    for (int k = 0; k < HALVINGS && status == 0; k++) {
        const real middle = 0.5 * (low + high);

        if (middle == low || middle == high)
            break;
        status = evaluate(all, middle, all->halfway);
        if ((all->halfway[i] < 0) == holds)
            low = middle;
        else
            high = middle;
    }
    if (status == 0)
        status = evaluate(all, low, all->halfway);
    *jump = all->halfway[i] == 0 ? low : high;
    return status;
}

/* Put a time among others in their order, unless it is there or an end; returns how many there are. */
static ptrdiff_t insert(const comparisons *all, real jump, real *jumps, ptrdiff_t count)
{
    const real ahead = all->end > all->start ? 1 : -1;
    ptrdiff_t place = count;

    while (place > 0 && ahead * (jumps[place - 1] - jump) > 0)
        place--;
    if (jump == all->start || jump == all->end || (place > 0 && jumps[place - 1] == jump))
        return count;
    for (ptrdiff_t k = count; k > place; k--)
        jumps[k] = jumps[k - 1];
    jumps[place] = jump;
    return count + 1;
}

/* Add the jumps between two neighboring looks to those before them. */
static int look_in(const comparisons *all, real low, real high, real *jumps, ptrdiff_t *count)
{
    int status = evaluate(all, low, all->before);

    if (status == 0)
        status = evaluate(all, high, all->after);
    for (ptrdiff_t i = 0; i < all->count && status == 0; i++) {
        real jump = high;

        if ((all->before[i] < 0) == (all->after[i] < 0))
            continue;
        status = bisect(all, i, low, high, &jump);
        *count = insert(all, jump, jumps, *count);
    }
    return status;
}

int cardan_time_jumps(const cardan_export *model, const void *prepared, real start, real end,
                      real *jumps, ptrdiff_t *count, real *work)
{
    const ptrdiff_t k = number_of(model), n = k < 0 ? 0 : model->functions[k].out;
    const comparisons all = {
        .function = model->functions + (k < 0 ? 0 : k),
        .w = cardan_prepared_w(model, prepared, k < 0 ? 0 : k),
        .count = n, .start = start, .end = end,
        .before = work, .after = work + n, .halfway = work + 2 * n, .work = work + 3 * n,
    };
    const real interval = (end - start) / (LOOKS - 1);
    int status = 0;

    *count = 0;
    for (ptrdiff_t i = 0; i < LOOKS - 1 && n > 0 && interval != 0 && status == 0; i++)
        status = look_in(&all, start + (real)i * interval,
                              i == LOOKS - 2 ? end : start + (real)(i + 1) * interval, jumps, count);
    return status;
}
