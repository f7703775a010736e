/*
 * Complex systems by the factorization of real ones. Part of cardan.
 *
 * Every number a + i b is the block [a -b; b a], and every unknown a pair, so that the plan of a
 * complex matrix follows from that of the real one: the same blocks in the same order, twice as
 * wide. Its dense products are those of the vector code, which does twice the multiplications of
 * complex numbers, but eight at a time.
 */
#include "sparse.h"

/* loads and runs as they lie in tables of numbers */
enum {
    LOAD = sizeof(cardan_sparse_load) / sizeof(int32_t),
    RUN = sizeof(cardan_sparse_run) / sizeof(int32_t)
};

/* Sizes of the tables that double. */
typedef struct sizes {
    ptrdiff_t loads, runs, targets;
} sizes;

static sizes sizes_of(const cardan_sparse *plan)
{
    const ptrdiff_t last = plan->supernodes - 1;
    sizes n = {0, 0, 0};

    if (last < 0)
        return n;
    n.loads = plan->load_start[last + 1];
    n.runs = plan->run_start[last + 1];
    n.targets = n.runs - plan->run_start[last];
    n.targets = plan->target_start[last] + n.targets * n.targets;
    return n;
}

/* the tables that double */
enum {
    FIRST, AT, STRIDE, ORDER, MULTIPLIER, START, PANEL, LATER, LOADS, RUNS, TARGETS,
    TABLES
};

/* Point at tables one behind the other in `room`, NULL: only measure. Returns their length. */
static ptrdiff_t lay(const cardan_sparse *plan, int32_t *room, int32_t **at, cardan_sparse *pair)
{
    const sizes n = sizes_of(plan);
    const ptrdiff_t lengths[TABLES] = {plan->blocks + 1, plan->blocks, plan->blocks, 2 * plan->n, 2 * plan->n,
                                 plan->supernodes + 1, plan->supernodes, plan->supernodes,
                                 LOAD * n.loads, RUN * n.runs, n.targets};
    ptrdiff_t used = 0;

    for (int k = 0; k < TABLES; k++) {
        at[k] = room ? room + used : NULL;
        used += lengths[k];
    }
    *pair = *plan;
    pair->n = 2 * plan->n;
    pair->values = 4 * plan->values;
    pair->factors = 4 * plan->factors;
    pair->widest = 2 * plan->widest;
    pair->first = at[FIRST], pair->at = at[AT], pair->stride = at[STRIDE];
    pair->order = at[ORDER], pair->multiplier = at[MULTIPLIER];
    pair->start = at[START], pair->panel = at[PANEL], pair->later = at[LATER];
    pair->load = (const cardan_sparse_load *)(const void *)at[LOADS];
    pair->run = (const cardan_sparse_run *)(const void *)at[RUNS];
    pair->target = at[TARGETS];
    return used;
}

ptrdiff_t cardan_sparse_pair_length(const cardan_sparse *plan)
{
    cardan_sparse pair;
    int32_t *at[TABLES];

    /* two of them in the room of a number */
    return (lay(plan, NULL, at, &pair) + 1) / 2;
}

void cardan_sparse_pair(const cardan_sparse *plan, double *memory, cardan_sparse *pair)
{
    int32_t *at[TABLES];

    (void)lay(plan, (int32_t *)(void *)memory, at, pair);
}

/* Where a number of a panel is that stands at `place` among the factors. */
static int32_t in_panel(const cardan_sparse *plan, ptrdiff_t s, int32_t place)
{
    const int32_t n = plan->start[s + 1] - plan->start[s], later = plan->later[s];
    const int32_t offset = place - plan->panel[s], part = offset < n * n ? 0 : n * n;
    const int32_t width = part == 0 ? n : later, row = (offset - part) / width, column = (offset - part) % width;

    /* of D, or of U and Lt: rows of Lt follow those of U */
    return 4 * (plan->panel[s] + part + row * width) + 2 * column;
}

static void multiply(const int32_t *from, ptrdiff_t n, int32_t factor, int32_t *to)
{
    for (ptrdiff_t i = 0; i < n; i++)
        to[i] = factor * from[i];
}

/* Where the blocks of the matrix go. */
static void double_loads(const cardan_sparse *plan, cardan_sparse_load *to)
{
    for (ptrdiff_t s = 0; s < plan->supernodes; s++)
        for (ptrdiff_t k = plan->load_start[s]; k < plan->load_start[s + 1]; k++, to++) {
            const cardan_sparse_load *load = plan->load + k;
            ptrdiff_t low = 0, high = plan->blocks;
            /* the block whose rows these are */
            while (high - low > 1) {
                const ptrdiff_t middle = (low + high) / 2;
                if (plan->first[middle] <= load->row)
                    low = middle;
                else
                    high = middle;
            }
            const int32_t row = load->row - plan->first[low], stride = plan->stride[low];
            const int32_t offset = load->from - plan->at[low] - row * stride;
            to->from = 4 * plan->at[low] + 4 * row * stride + 2 * offset;
            to->stride = 2 * load->stride;
            to->to = in_panel(plan, s, load->to);
            to->rows = 2 * load->rows, to->columns = 2 * load->columns;
            to->row = 2 * load->row, to->column = 2 * load->column;
            to->transposed = load->transposed;
        }
}

/* Where products of two runs go. */
static void double_targets(const cardan_sparse *plan, int32_t *doubled)
{
    for (ptrdiff_t s = 0; s < plan->supernodes; s++) {
        const cardan_sparse_run *first = plan->run + plan->run_start[s];
        const cardan_sparse_run *end = plan->run + plan->run_start[s + 1];
        const int32_t *target = plan->target + plan->target_start[s];
        int32_t *to = doubled + plan->target_start[s];

        for (const cardan_sparse_run *i = first; i < end; i++)
            for (const cardan_sparse_run *j = first; j < end; j++)
                *to++ = in_panel(plan, i->owner > j->owner ? j->owner : i->owner, *target++);
    }
}

void cardan_sparse_pair_fill(const cardan_sparse *plan, double *memory)
{
    const ptrdiff_t ns = plan->supernodes, runs = sizes_of(plan).runs;
    cardan_sparse pair;
    int32_t *at[TABLES];

    (void)lay(plan, (int32_t *)(void *)memory, at, &pair);
    multiply(plan->first, plan->blocks + 1, 2, at[FIRST]);
    multiply(plan->at, plan->blocks, 4, at[AT]);
    multiply(plan->stride, plan->blocks, 2, at[STRIDE]);
    for (ptrdiff_t k = 0; k < 2 * plan->n; k++) {
        at[ORDER][k] = 2 * plan->order[k / 2] + (int32_t)(k % 2);
        at[MULTIPLIER][k] = plan->multiplier[k / 2];
    }
    multiply(plan->start, ns + 1, 2, at[START]);
    multiply(plan->panel, ns, 4, at[PANEL]);
    multiply(plan->later, ns, 2, at[LATER]);
    double_loads(plan, (cardan_sparse_load *)(void *)at[LOADS]);
    for (ptrdiff_t k = 0; k < runs; k++) {
        const cardan_sparse_run *run = plan->run + k;
        const cardan_sparse_run twice = {2 * run->at, 2 * run->size, 2 * run->place, run->owner};
        ((cardan_sparse_run *)(void *)at[RUNS])[k] = twice;
    }
    double_targets(plan, at[TARGETS]);
}

void cardan_sparse_pair_combine(const cardan_sparse *plan, const double *const *powers,
                                double re, double im, double *a)
{
    const double re2 = re * re - im * im, im2 = 2 * re * im;

    for (ptrdiff_t block = 0; block < plan->blocks; block++) {
        const ptrdiff_t stride = plan->stride[block];
        for (ptrdiff_t i = 0; i < plan->first[block + 1] - plan->first[block]; i++) {
            const ptrdiff_t from = plan->at[block] + i * stride;
            double *row = a + 4 * from, *next = row + 2 * stride;
            for (ptrdiff_t j = 0; j < stride; j++) {
                const double one = powers[1][from + j], two = powers[2][from + j];
                const double x = powers[0][from + j] + re * one + re2 * two;
                const double y = im * one + im2 * two;
                row[2 * j] = next[2 * j + 1] = x;
                row[2 * j + 1] = -y;
                next[2 * j] = y;
            }
        }
    }
}
