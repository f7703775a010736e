/* States of an FMU: a copy of everything that decides how it goes on.
 *
 * Part of cardan. A state is one block of bytes without pointers, so that it may come from another
 * process: the record, the numbers that a run changes, then arrays. Sizes, and all that follows from
 * the model, are in no state: they are those of the instance. Places and counts are refused outside of
 * their range, as in saved_record.py: bytes may come from anybody. What follows from parameters is
 * prepared anew.
 */
#include "fmu_core.h"
#include "jumps.h"
#include <stdlib.h>

/* arrays of the instance, and the memory of the run */
enum { PARTS = 7, POINTS = 10 /* MOST_POINTS of gauss.h */ };
/* of what is counted; samples that an importer may be behind */
static const ptrdiff_t MOST = PTRDIFF_MAX / 2;
static const double BEHIND = 1e6;

/* Whole numbers of a run, with the least and the largest value: counts, flags, places. */
#define INTEGERS(F)                                                                                \
    F(in_segment, 0, MOST) F(rejected, 0, MOST) F(ranks, 0, MOST) F(at_once, 0, MOST)              \
    F(occurred, 0, MOST) F(steps, 0, MOST) F(rejections, 0, MOST) F(evaluations, 0, MOST)          \
    F(projections, 0, MOST) F(passed, 0, MOST) F(looked, 0, MOST) F(limited, 0, MOST)              \
    F(jacobians, 0, MOST) F(factorizations, 0, MOST) F(model_status, -MOST, MOST)                  \
    F(fresh, 0, 1) F(begun, 0, 1) F(is_dense, 0, 1) F(jumps, 0, 1) F(row_open, 0, 2)               \
    F(event_pending, 0, run->ne > 0) F(culprit, -1, run->n + run->ne - 1)                          \
    F(open_row, -1, run->positions + run->rates - 1) F(constraint_rank, 0, run->rates)             \
    F(signal_count, 0, run->nr) F(stop_count, 0, most_stops) F(next_stop, 0, run->stop_count)      \
    F(pass_parts, 0, run->rates > 0 ? MOST : 0) F(pass_part, 0, run->pass_parts)                   \
    F(pass_points, run->pass_parts > 0, POINTS)
#define REALS(F)                                                                                   \
    F(t) F(t_old) F(t_start) F(segment) F(h) F(until) F(early) F(late) F(moment) F(error_before)   \
    F(correction) F(size) F(rank_margin) F(best_rank_margin) F(pass_start) F(pass_length)

#define INTEGER_FIELD(name, least, most) ptrdiff_t name;
#define REAL_FIELD(name) real name;
struct fmu_numbers {
    INTEGERS(INTEGER_FIELD)
    REALS(REAL_FIELD)
};

struct fmu_saved {
    uint64_t model, length, sum; /* hash of the token, bytes, hash of what follows */
    struct fmu_record is;
    struct fmu_numbers of_run;
    double numbers[1];
};

/* FNV-1a. Source: G. Fowler, L. C. Noll, K.-P. Vo, the hash of these names, 1991. */
static uint64_t hash(const void *bytes, size_t count)
{
    const unsigned char *byte = bytes;
    uint64_t sum = 14695981039346656037u;

    for (size_t i = 0; i < count; i++)
        sum = (sum ^ byte[i]) * 1099511628211u;
    return sum;
}

/* Numbers of a run, as a state holds them. */
static void take_numbers(struct fmu_numbers *to, const cardan_run *run)
{
#define TAKE_INTEGER(name, least, most) to->name = run->name;
#define TAKE_REAL(name) to->name = run->name;
    INTEGERS(TAKE_INTEGER)
    REALS(TAKE_REAL)
}

/* Give numbers to a run whose sizes are there; returns 0 where one lies outside of its range. */
static int give_numbers(cardan_run *run, const struct fmu_numbers *from, ptrdiff_t most_stops)
{
    int right = 1;

#define GIVE_INTEGER(name, least, most)                                                            \
    run->name = from->name;                                                                        \
    right = right && run->name >= (least) && run->name <= (most);
#define GIVE_REAL(name)                                                                            \
    run->name = from->name;                                                                        \
    right = right && run->name == run->name;
    INTEGERS(GIVE_INTEGER)
    REALS(GIVE_REAL)
    return right && fmu_finite(run->t) && fmu_finite(run->t_old) && fmu_finite(run->h);
}

/* Give samples what the model says of them; returns 0 where the next ones make no sense. */
static int restore_ticks(const fmu_instance *m)
{
    const cardan_run *run = &m->at.run;
    int right = 1;

    for (ptrdiff_t i = 0; i < run->tick_count; i++) {
        const cardan_exported_tick *row = fmu_scene(m)->ticks + i;
        cardan_tick *tick = run->ticks + i;

        tick->event = row->event, tick->period = row->period, tick->phase = row->phase;
        right = right && fmu_finite(tick->next) && run->t - tick->next <= BEHIND * tick->period;
    }
    return right;
}

/* Whether places that the memory of the run holds, such as rows of a factored matrix, exist. */
static int is_sound(const fmu_instance *m)
{
    const cardan_method *method = fmu_scene(m)->methods[0].method;

    return cardan_rank_sound(&m->at.run) && (!method->sound || method->sound(&m->at.run));
}

/* The numbers of the run that are state, and how many bytes they are. */
static char *run_memory(const fmu_instance *m, size_t *size)
{
    const cardan_simulation settings = {0};
    cardan_laid_run measured;

    *size = cardan_lay_run(fmu_scene(m), &settings, NULL, &measured) - measured.state_offset;
    return (char *)m->at.prepared + measured.state_offset;
}

/* Parts of a state behind its record: the arrays of the instance, then those of the run. */
static size_t parts_of(const fmu_instance *m, void *parts[PARTS], size_t sizes[PARTS])
{
    const ptrdiff_t nr = fmu_scene(m)->nr;
    const ptrdiff_t counts[] = {fmu_count(m, FMU_PARAMETER), nr, fmu_nx(m), fmu_scene(m)->event_count,
                                FMU_POLYNOMIAL * nr, m->is.jump_count};
    double *const arrays[] = {m->p, m->r, m->start, m->armed_at, m->polynomials, m->jumps};
    size_t total = 0;

    for (int k = 0; k < PARTS - 1; k++)
        parts[k] = arrays[k], sizes[k] = (size_t)counts[k] * sizeof(double);
    parts[PARTS - 1] = run_memory(m, sizes + PARTS - 1);
    for (int k = 0; k < PARTS; k++)
        total += sizes[k];
    return total;
}

static size_t head_size(void)
{
    return offsetof(struct fmu_saved, numbers);
}

fmu_status fmu_save(fmu_instance *m, fmu_saved **state)
{
    void *parts[PARTS];
    size_t sizes[PARTS];
    const size_t length = head_size() + parts_of(m, parts, sizes);
    fmu_saved *saved = *state && (*state)->length == length ? *state : realloc(*state, length + sizeof(double));
    char *at;

    if (!saved)
        return fmu_say(m, FMU_ERROR, "GetFMUState: there is no memory for a state.");
    *state = saved;
    /* what lies between fields has values too */
    memset(saved, 0, head_size());
    saved->length = length, saved->model = hash(m->model->token, strlen(m->model->token));
    memcpy(&saved->is, &m->is, sizeof saved->is);
    take_numbers(&saved->of_run, &m->at.run);
    at = (char *)saved->numbers;
    for (int k = 0; k < PARTS; at += sizes[k], k++)
        memcpy(at, parts[k], sizes[k]);
    saved->sum = hash(&saved->is, length - offsetof(struct fmu_saved, is));
    return FMU_OK;
}

/* Whether an instance can be in a state: one phase, a tolerance, no more jumps than there is room for. */
static int is_possible(const struct fmu_record *is, ptrdiff_t most_jumps)
{
    const int phase = is->phase;

    return phase > 0 && phase <= FMU_TERMINATED && (phase & (phase - 1)) == 0 && is->tolerance > 0
           && fmu_finite(is->tolerance) && fmu_finite(is->start) && fmu_finite(is->horizon)
           && is->jump_count >= 0 && is->jump_count <= most_jumps;
}

static fmu_status refuse(fmu_instance *m)
{
    return fmu_say(m, FMU_ERROR, "the FMU state is damaged or of another FMU.");
}

/* Refuse a state that is damaged or belongs to another FMU. */
static fmu_status check(fmu_instance *m, const fmu_saved *state)
{
    if (!state || state->length < head_size() || state->model != hash(m->model->token, strlen(m->model->token))
        || state->sum != hash(&state->is, (size_t)state->length - offsetof(struct fmu_saved, is)))
        return refuse(m);
    return FMU_OK;
}

fmu_status fmu_restore(fmu_instance *m, const fmu_saved *state)
{
    const int stale = m->is.stale_parameters;
    const ptrdiff_t most_jumps = (ptrdiff_t)cardan_jumps_capacity(fmu_scene(m));
    void *parts[PARTS];
    size_t sizes[PARTS];
    const char *at;

    if (check(m, state) != FMU_OK)
        return FMU_ERROR;
    if (!is_possible(&state->is, most_jumps))
        return refuse(m);
    memcpy(&m->is, &state->is, sizeof m->is);
    if (head_size() + parts_of(m, parts, sizes) != state->length) {
        (void)fmu_reset(m);
        return refuse(m);
    }
    at = (const char *)state->numbers;
    /* what follows from other parameters is not there */
    if ((stale || memcmp(at, m->p, sizes[0]) != 0) && !m->is.stale_parameters
        && cardan_prepare(fmu_scene(m), (const double *)(const void *)at, m->at.prepared) != 0)
        return fmu_say(m, FMU_ERROR, "SetFMUState: the model has no numbers at the parameters of the state.");
    /* sizes, tolerances and places of arrays are those of the instance */
    fmu_lay_run(m);
    for (int k = 0; k < PARTS; at += sizes[k], k++)
        memcpy(parts[k], at, sizes[k]);
    if (!give_numbers(&m->at.run, &state->of_run, most_jumps + 1) || !restore_ticks(m) || !is_sound(m)) {
        (void)fmu_reset(m);
        return refuse(m);
    }
    fmu_forget(m);
    return FMU_OK;
}

void fmu_discard_state(fmu_saved **state)
{
    free(*state);
    *state = NULL;
}

fmu_status fmu_saved_size(fmu_instance *m, const fmu_saved *state, size_t *size)
{
    if (check(m, state) != FMU_OK)
        return FMU_ERROR;
    *size = (size_t)state->length;
    return FMU_OK;
}

fmu_status fmu_write_state(fmu_instance *m, const fmu_saved *state, void *bytes, size_t size)
{
    if (check(m, state) != FMU_OK)
        return FMU_ERROR;
    if (size < state->length)
        return fmu_say(m, FMU_ERROR, "SerializeFMUState: the state takes %llu bytes.", (unsigned long long)state->length);
    memcpy(bytes, state, (size_t)state->length);
    return FMU_OK;
}

fmu_status fmu_read_state(fmu_instance *m, const void *bytes, size_t size, fmu_saved **state)
{
    fmu_saved *saved = size >= head_size() ? malloc(size + sizeof(double)) : NULL;

    if (saved) {
        memcpy(saved, bytes, size);
        if (saved->length <= size && check(m, saved) == FMU_OK) {
            fmu_discard_state(state);
            *state = saved;
            return FMU_OK;
        }
    }
    free(saved);
    return fmu_say(m, FMU_ERROR, "DeserializeFMUState: the bytes are damaged or of another FMU.");
}
