/* FMI 3.0 of an FMU: states, derivatives, model exchange and co-simulation. Part of cardan; see fmi3.c. */
#include "fmi3Functions.h"
#include "fmu_core.h"

static fmu_instance *core(fmi3Instance instance)
{
    return instance;
}

#define ALLOW(call, phases)                                                                        \
    do {                                                                                           \
        if (fmu_allow(core(instance), call, phases) != FMU_OK)                                     \
            return fmi3Error;                                                                      \
    } while (0)
/* Calls that this FMU declares not to have. */
#define ABSENT(call)                                                                               \
    do {                                                                                           \
        ALLOW(call, FMU_ANYTIME);                                                                  \
        return (fmi3Status)fmu_say(core(instance), FMU_ERROR, "%s: this FMU does not have it, as its " \
                                   "modelDescription.xml says.", call);                            \
    } while (0)

/* States of the FMU */

fmi3Status fmi3GetFMUState(fmi3Instance instance, fmi3FMUState *FMUState)
{
    ALLOW("fmi3GetFMUState", FMU_ANYTIME);
    return (fmi3Status)fmu_save(core(instance), (fmu_saved **)FMUState);
}

fmi3Status fmi3SetFMUState(fmi3Instance instance, fmi3FMUState FMUState)
{
    ALLOW("fmi3SetFMUState", FMU_ANYTIME);
    return (fmi3Status)fmu_restore(core(instance), FMUState);
}

fmi3Status fmi3FreeFMUState(fmi3Instance instance, fmi3FMUState *FMUState)
{
    ALLOW("fmi3FreeFMUState", FMU_ANYTIME);
    if (FMUState)
        fmu_discard_state((fmu_saved **)FMUState);
    return fmi3OK;
}

fmi3Status fmi3SerializedFMUStateSize(fmi3Instance instance, fmi3FMUState FMUState, size_t *size)
{
    ALLOW("fmi3SerializedFMUStateSize", FMU_ANYTIME);
    return (fmi3Status)fmu_saved_size(core(instance), FMUState, size);
}

fmi3Status fmi3SerializeFMUState(fmi3Instance instance, fmi3FMUState FMUState, fmi3Byte serializedState[],
                                 size_t size)
{
    ALLOW("fmi3SerializeFMUState", FMU_ANYTIME);
    return (fmi3Status)fmu_write_state(core(instance), FMUState, serializedState, size);
}

fmi3Status fmi3DeserializeFMUState(fmi3Instance instance, const fmi3Byte serializedState[], size_t size,
                                   fmi3FMUState *FMUState)
{
    ALLOW("fmi3DeserializeFMUState", FMU_ANYTIME);
    return (fmi3Status)fmu_read_state(core(instance), serializedState, size, (fmu_saved **)FMUState);
}

/* Derivatives */

fmi3Status fmi3GetDirectionalDerivative(fmi3Instance instance, const fmi3ValueReference unknowns[],
                                        size_t nUnknowns, const fmi3ValueReference knowns[], size_t nKnowns,
                                        const fmi3Float64 seed[], size_t nSeed, fmi3Float64 sensitivity[],
                                        size_t nSensitivity)
{
    ALLOW("fmi3GetDirectionalDerivative", FMU_INITIALIZING | FMU_ENTERED);
    if (nSeed != nKnowns || nSensitivity != nUnknowns)
        return (fmi3Status)fmu_say(core(instance), FMU_ERROR, "fmi3GetDirectionalDerivative: the lengths do not fit.");
    return (fmi3Status)fmu_derivative(core(instance), unknowns, nUnknowns, knowns, nKnowns, seed, sensitivity, 0);
}

fmi3Status fmi3GetAdjointDerivative(fmi3Instance instance, const fmi3ValueReference unknowns[],
                                    size_t nUnknowns, const fmi3ValueReference knowns[], size_t nKnowns,
                                    const fmi3Float64 seed[], size_t nSeed, fmi3Float64 sensitivity[],
                                    size_t nSensitivity)
{
    ALLOW("fmi3GetAdjointDerivative", FMU_INITIALIZING | FMU_ENTERED);
    if (nSeed != nUnknowns || nSensitivity != nKnowns)
        return (fmi3Status)fmu_say(core(instance), FMU_ERROR, "fmi3GetAdjointDerivative: the lengths do not fit.");
    return (fmi3Status)fmu_derivative(core(instance), unknowns, nUnknowns, knowns, nKnowns, seed, sensitivity, 1);
}

/* Model exchange */

fmi3Status fmi3UpdateDiscreteStates(fmi3Instance instance, fmi3Boolean *discreteStatesNeedUpdate,
                                    fmi3Boolean *terminateSimulation,
                                    fmi3Boolean *nominalsOfContinuousStatesChanged,
                                    fmi3Boolean *valuesOfContinuousStatesChanged,
                                    fmi3Boolean *nextEventTimeDefined, fmi3Float64 *nextEventTime)
{
    fmu_update update;
    fmu_status status;

    ALLOW("fmi3UpdateDiscreteStates", FMU_EVENT_MODE);
    status = fmu_update_discrete(core(instance), &update);
    *discreteStatesNeedUpdate = *nominalsOfContinuousStatesChanged = fmi3False;
    *terminateSimulation = update.terminate, *valuesOfContinuousStatesChanged = update.values_changed;
    *nextEventTimeDefined = update.next_defined, *nextEventTime = update.next;
    return (fmi3Status)status;
}

fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance instance)
{
    ALLOW("fmi3EvaluateDiscreteStates", FMU_INITIALIZING | FMU_EVENT_MODE);
    return fmi3OK;
}

fmi3Status fmi3CompletedIntegratorStep(fmi3Instance instance, fmi3Boolean noSetFMUStatePriorToCurrentPoint,
                                       fmi3Boolean *enterEventMode, fmi3Boolean *terminateSimulation)
{
    int enter = 0;
    fmu_status status;

    (void)noSetFMUStatePriorToCurrentPoint;
    ALLOW("fmi3CompletedIntegratorStep", FMU_CONTINUOUS);
    status = fmu_completed_step(core(instance), &enter);
    *enterEventMode = enter, *terminateSimulation = fmi3False;
    return (fmi3Status)status;
}

fmi3Status fmi3SetTime(fmi3Instance instance, fmi3Float64 time)
{
    ALLOW("fmi3SetTime", FMU_CONTINUOUS | FMU_EVENT_MODE);
    return (fmi3Status)fmu_set_time(core(instance), time);
}

fmi3Status fmi3SetContinuousStates(fmi3Instance instance, const fmi3Float64 continuousStates[],
                                   size_t nContinuousStates)
{
    ALLOW("fmi3SetContinuousStates", FMU_CONTINUOUS);
    return (fmi3Status)fmu_set_states(core(instance), continuousStates, nContinuousStates);
}

fmi3Status fmi3GetContinuousStates(fmi3Instance instance, fmi3Float64 continuousStates[],
                                   size_t nContinuousStates)
{
    ALLOW("fmi3GetContinuousStates", FMU_INITIALIZING | FMU_ENTERED);
    return (fmi3Status)fmu_get_states(core(instance), continuousStates, nContinuousStates);
}

fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance instance, fmi3Float64 derivatives[],
                                             size_t nContinuousStates)
{
    ALLOW("fmi3GetContinuousStateDerivatives", FMU_INITIALIZING | FMU_ENTERED);
    return (fmi3Status)fmu_get_block(core(instance), FMU_RATE, derivatives, nContinuousStates);
}

fmi3Status fmi3GetEventIndicators(fmi3Instance instance, fmi3Float64 eventIndicators[],
                                  size_t nEventIndicators)
{
    ALLOW("fmi3GetEventIndicators", FMU_INITIALIZING | FMU_ENTERED);
    return (fmi3Status)fmu_get_block(core(instance), FMU_INDICATOR, eventIndicators, nEventIndicators);
}

fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance instance, fmi3Float64 nominals[],
                                             size_t nContinuousStates)
{
    ALLOW("fmi3GetNominalsOfContinuousStates", FMU_ANYTIME);
    for (size_t k = 0; k < nContinuousStates; k++)
        nominals[k] = 1;
    return fmi3OK;
}

fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance instance, size_t *nEventIndicators)
{
    ALLOW("fmi3GetNumberOfEventIndicators", FMU_ANYTIME);
    *nEventIndicators = (size_t)fmu_count(core(instance), FMU_INDICATOR);
    return fmi3OK;
}

fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance instance, size_t *nContinuousStates)
{
    ALLOW("fmi3GetNumberOfContinuousStates", FMU_ANYTIME);
    *nContinuousStates = (size_t)fmu_nx(core(instance));
    return fmi3OK;
}

/* Co-simulation */

fmi3Status fmi3DoStep(fmi3Instance instance, fmi3Float64 currentCommunicationPoint,
                      fmi3Float64 communicationStepSize, fmi3Boolean noSetFMUStatePriorToCurrentPoint,
                      fmi3Boolean *eventHandlingNeeded, fmi3Boolean *terminateSimulation,
                      fmi3Boolean *earlyReturn, fmi3Float64 *lastSuccessfulTime)
{
    fmu_status status;

    (void)noSetFMUStatePriorToCurrentPoint;
    ALLOW("fmi3DoStep", FMU_STEPPING);
    status = fmu_do_step(core(instance), currentCommunicationPoint, communicationStepSize);
    *eventHandlingNeeded = *earlyReturn = fmi3False;
    *terminateSimulation = core(instance)->is.terminated;
    *lastSuccessfulTime = core(instance)->at.run.t;
    return (fmi3Status)status;
}

/* What this FMU does not have */

fmi3Status fmi3GetOutputDerivatives(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                                    size_t nValueReferences, const fmi3Int32 orders[], fmi3Float64 values[],
                                    size_t nValues)
{
    (void)valueReferences, (void)nValueReferences, (void)orders, (void)values, (void)nValues;
    ABSENT("fmi3GetOutputDerivatives");
}

fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance instance, fmi3ValueReference valueReference,
                                               size_t *nDependencies)
{
    (void)valueReference, (void)nDependencies;
    ABSENT("fmi3GetNumberOfVariableDependencies");
}

fmi3Status fmi3GetVariableDependencies(fmi3Instance instance, fmi3ValueReference dependent,
                                       size_t elementIndicesOfDependent[], fmi3ValueReference independents[],
                                       size_t elementIndicesOfIndependents[],
                                       fmi3DependencyKind dependencyKinds[], size_t nDependencies)
{
    (void)dependent, (void)elementIndicesOfDependent, (void)independents, (void)nDependencies;
    (void)elementIndicesOfIndependents, (void)dependencyKinds;
    ABSENT("fmi3GetVariableDependencies");
}

fmi3Status fmi3GetIntervalDecimal(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                                  size_t nValueReferences, fmi3Float64 intervals[],
                                  fmi3IntervalQualifier qualifiers[])
{
    (void)valueReferences, (void)nValueReferences, (void)intervals, (void)qualifiers;
    ABSENT("fmi3GetIntervalDecimal");
}

fmi3Status fmi3GetIntervalFraction(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                                   size_t nValueReferences, fmi3UInt64 counters[], fmi3UInt64 resolutions[],
                                   fmi3IntervalQualifier qualifiers[])
{
    (void)valueReferences, (void)nValueReferences, (void)counters, (void)resolutions, (void)qualifiers;
    ABSENT("fmi3GetIntervalFraction");
}

fmi3Status fmi3GetShiftDecimal(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                               size_t nValueReferences, fmi3Float64 shifts[])
{
    (void)valueReferences, (void)nValueReferences, (void)shifts;
    ABSENT("fmi3GetShiftDecimal");
}

fmi3Status fmi3GetShiftFraction(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                                size_t nValueReferences, fmi3UInt64 counters[], fmi3UInt64 resolutions[])
{
    (void)valueReferences, (void)nValueReferences, (void)counters, (void)resolutions;
    ABSENT("fmi3GetShiftFraction");
}

fmi3Status fmi3SetIntervalDecimal(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                                  size_t nValueReferences, const fmi3Float64 intervals[])
{
    (void)valueReferences, (void)nValueReferences, (void)intervals;
    ABSENT("fmi3SetIntervalDecimal");
}

fmi3Status fmi3SetIntervalFraction(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                                   size_t nValueReferences, const fmi3UInt64 counters[],
                                   const fmi3UInt64 resolutions[])
{
    (void)valueReferences, (void)nValueReferences, (void)counters, (void)resolutions;
    ABSENT("fmi3SetIntervalFraction");
}

fmi3Status fmi3SetShiftDecimal(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                               size_t nValueReferences, const fmi3Float64 shifts[])
{
    (void)valueReferences, (void)nValueReferences, (void)shifts;
    ABSENT("fmi3SetShiftDecimal");
}

fmi3Status fmi3SetShiftFraction(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                                size_t nValueReferences, const fmi3UInt64 counters[],
                                const fmi3UInt64 resolutions[])
{
    (void)valueReferences, (void)nValueReferences, (void)counters, (void)resolutions;
    ABSENT("fmi3SetShiftFraction");
}

fmi3Status fmi3ActivateModelPartition(fmi3Instance instance, fmi3ValueReference clockReference,
                                      fmi3Float64 activationTime)
{
    (void)clockReference, (void)activationTime;
    ABSENT("fmi3ActivateModelPartition");
}
