/* Messages of an FMU: what went wrong, where, and what to do. Part of cardan. */
#include "fmu_core.h"
#include <stdarg.h>
#include <stdio.h>

static const char *const CATEGORIES[] = {"logEvents", "logStatusWarning", "logStatusDiscard", "logStatusError",
                                         "logStatusFatal"};

/* Give a message to the importer; returns its status. */
fmu_status fmu_say(fmu_instance *m, fmu_status status, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    (void)vsnprintf(m->text, sizeof m->text, format, arguments);
    va_end(arguments);
    if (m->logger.sink && (status != FMU_OK || m->logger.events))
        m->logger.sink(m, status, CATEGORIES[status], m->text);
    return status;
}

/* What an answer of run.h means. */
static const char *reason_of(int status)
{
    switch (status) {
    case CARDAN_NOT_FINITE: return "a number is not finite. An input, a parameter or a start value makes it so, or the motion grows beyond all bounds";
    case CARDAN_TOO_SMALL: return "no step is small enough to stay within the tolerance. The motion is singular there, or the tolerance is tighter than it can be computed";
    case CARDAN_MODEL: return "the equations have no solution: the mass matrix is singular there";
    case CARDAN_SIZE: return "a size is more than memory can address";
    case CARDAN_CONSTRAINT_OPEN: return "loops cannot be closed there. The mechanism is at the end of its range or at a dead point, or start values and parameters do not fit together";
    case CARDAN_ROTATION_TOO_LARGE: return "a rotation in one step is most of a turn: take shorter communication steps";
    case CARDAN_UNSOLVED: return "the equations of an implicit step were not solved: take shorter communication steps";
    case CARDAN_EVENT_LIMIT: return "an event happens again and again at this one time: what it changes does not end what causes it";
    case CARDAN_CHATTER: return "an event happens ever again within no time to speak of, such as the last bounces of a ball that comes to rest";
    case CARDAN_ROTATION_UNRESOLVED: return "a step does not tell how a rotation turns: take shorter communication steps";
    default: return "the run ended";
    }
}

/* The variable or event that broke the run, "" if none is to blame. */
static const char *culprit_of(const fmu_instance *m)
{
    const cardan_run *run = &m->at.run;
    const ptrdiff_t k = run->culprit;

    if (k >= 0 && k < run->nx)
        return m->model->names[m->model->blocks[FMU_STATE].first + (unsigned)k];
    if (k >= run->n && k < run->n + run->ne)
        return fmu_scene(m)->events[k - run->n].name;
    return "";
}

/* Say why a call could not be carried out. */
fmu_status fmu_broke_down(fmu_instance *m, const char *call, int status)
{
    const char *who = culprit_of(m);

    return fmu_say(m, FMU_DISCARD, "%s at t = %.9g s: %s%s%s%s.", call, m->at.run.t, reason_of(status),
                   *who ? " (first at '" : "", who, *who ? "')" : "");
}
