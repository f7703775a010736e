/* States of an FMU: a copy of everything that decides how it goes on.
 *
 * Part of cardan. A state is one block of bytes without pointers, so that it may come from another
 * process: the record, the run, then numbers. What follows from parameters is prepared anew.
 */
#include "fmu_core.h"
#include <stdlib.h>

/* arrays of the instance, and the memory of the run */
enum { PARTS = 7 };

struct fmu_saved {
    uint64_t model, length, sum; /* hash of the token, bytes, hash of what follows */
    struct fmu_record is;
    cardan_run run; /* its pointers are NULL */
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

/* Give a run the pointers of another one. */
static void take_pointers(cardan_run *to, const cardan_run *from)
{
    to->init = from->init, to->step = from->step, to->dense = from->dense, to->length = from->length;
    to->rhs = from->rhs, to->power = from->power, to->energy = from->energy;
    to->rhs_jacobian = from->rhs_jacobian, to->balance = from->balance;
    to->balance_tangent = from->balance_tangent, to->internal_rates = from->internal_rates;
    to->move = from->move, to->qdot = from->qdot, to->mesh = from->mesh, to->options = from->options;
    to->inputs = from->inputs, to->input_context = from->input_context, to->signals = from->signals;
    to->quaternions = from->quaternions;
    to->bounded = from->bounded, to->close_position = from->close_position;
    to->close_velocity = from->close_velocity, to->constraint_jacobian = from->constraint_jacobian;
    to->columns = from->columns, to->events = from->events, to->transition = from->transition;
    to->watch = from->watch, to->kinds = from->kinds, to->ticks = from->ticks;
    to->y = from->y, to->y_old = from->y_old, to->trial = from->trial, to->k = from->k, to->f = from->f;
    to->r = from->r, to->s = from->s, to->interpolant = from->interpolant, to->zeros = from->zeros;
    to->work = from->work, to->closing = from->closing, to->chart = from->chart;
    to->rank_memory = from->rank_memory, to->crossing = from->crossing;
    to->method_memory = from->method_memory, to->e = from->e, to->board = from->board;
    to->ledger = from->ledger, to->stops = from->stops, to->rows = from->rows;
    to->spreads = from->spreads, to->times = from->times, to->log = from->log;
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
    const ptrdiff_t counts[] = {fmu_count(m, FMU_PARAMETER), nr, fmu_nx(m), fmu_scene(m)->event_count, 6 * nr,
                                m->is.jump_count};
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
    static const cardan_run nowhere = {0};
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
    memcpy(&saved->run, &m->at.run, sizeof saved->run);
    take_pointers(&saved->run, &nowhere);
    at = (char *)saved->numbers;
    for (int k = 0; k < PARTS; at += sizes[k], k++)
        memcpy(at, parts[k], sizes[k]);
    saved->sum = hash(&saved->is, length - offsetof(struct fmu_saved, is));
    return FMU_OK;
}

/* Refuse a state that is damaged or belongs to another FMU. */
static fmu_status check(fmu_instance *m, const fmu_saved *state)
{
    if (!state || state->length < head_size() || state->model != hash(m->model->token, strlen(m->model->token))
        || state->sum != hash(&state->is, (size_t)state->length - offsetof(struct fmu_saved, is)))
        return fmu_say(m, FMU_ERROR, "the FMU state is damaged or of another FMU.");
    return FMU_OK;
}

fmu_status fmu_restore(fmu_instance *m, const fmu_saved *state)
{
    const int stale = m->is.stale_parameters;
    const cardan_run here = m->at.run;
    void *parts[PARTS];
    size_t sizes[PARTS];
    const char *at;

    if (check(m, state) != FMU_OK)
        return FMU_ERROR;
    memcpy(&m->is, &state->is, sizeof m->is);
    if (head_size() + parts_of(m, parts, sizes) != state->length) {
        (void)fmu_reset(m);
        return fmu_say(m, FMU_ERROR, "the FMU state is damaged or of another FMU.");
    }
    at = (const char *)state->numbers;
    /* what follows from other parameters is not there */
    if ((stale || memcmp(at, m->p, sizes[0]) != 0) && !m->is.stale_parameters
        && cardan_prepare(fmu_scene(m), (const double *)(const void *)at, m->at.prepared) != 0)
        return fmu_say(m, FMU_ERROR, "SetFMUState: the model has no numbers at the parameters of the state.");
    for (int k = 0; k < PARTS; at += sizes[k], k++)
        memcpy(parts[k], at, sizes[k]);
    memcpy(&m->at.run, &state->run, sizeof here);
    take_pointers(&m->at.run, &here);
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
