// What was found, as the report tells it: the parts that have the fault, and what proves it.
#include "diagnose/reset.h"

#include <stdio.h>
#include <string.h>

void reset_part(FaultPart *part, const Parts *parts, int p) {
    const Rubric *rubric = parts->rubric;
    int count = 0;
    *part = (FaultPart){.file = rubric->files[parts->list[p].file], .whole = parts->list[p].whole};
    snprintf(part->function, sizeof part->function, "%s", parts->list[p].function);
    memcpy(part->ours, part->function, sizeof part->ours);
    for (int t = 0; t < rubric->hint_count && count < FAULT_TASKS; t++)
        if (parts_have_task(parts, p, rubric->hints[t].task))
            part->tasks[count++] = rubric->hints[t].task;
}

static bool has_suspect(const Parts *parts, int p, const Suspects *suspects) {
    for (int i = 0; i < suspects->count; i++)
        if (parts_have_task(parts, p, parts->rubric->hints[suspects->tasks[i]].task))
            return true;
    return false;
}

static bool is_meant(const ResetFound *found, const Suspects *suspects, const Parts *parts, int p) {
    return found->both || suspects->count == 0 || has_suspect(parts, p, suspects);
}

void reset_note(Fault *fault, const ResetFound *found, const Suspects *suspects, const Parts *parts) {
    int count = 0;
    *fault = (Fault){.reset = true};
    for (int p = 0; p < parts->count; p++) {
        const bool meant = is_meant(found, suspects, parts, p);
        if (found->unknown[p] && suspects->count > 0 && meant) // nothing is proved of it
            return;
        count += found->parts[p] && meant;
    }
    for (int p = 0; p < parts->count && count <= FAULT_PARTS; p++)
        if (found->parts[p] && is_meant(found, suspects, parts, p))
            reset_part(&fault->parts[fault->count++], parts, p);
    fault->either = fault->count > 1 && !found->both;
    fault->failed = fault->repaired = found->failed;
    fault->stopped = found->stopped;
}
