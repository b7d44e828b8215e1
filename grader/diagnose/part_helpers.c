#include "diagnose/part_helpers.h"

#include "compile/tokens.h"
#include "diagnose/part_tasks.h"
#include "scene/check.h"

#include <string.h>

void part_helpers_list(FaultPart *part, const MixedFile *file) {
    const Function *function = functions_find(&file->theirs, part->function);
    for (int i = 0; function && i < file->theirs.count; i++) {
        const char *name = file->theirs.list[i].name;
        if (!functions_find(&file->ours, name) && &file->theirs.list[i] != function &&
            !strstr(part->helpers, name) &&
            tokens_mention(file->text + function->begin, function->end - function->begin, name))
            check_append(part->helpers, sizeof part->helpers, "%s%s", part->helpers[0] ? ", " : "", name);
    }
}

void part_helpers_mark(bool tasks[], const Rubric *rubric, const MixedFile *file, const FaultPart *part) {
    const Function *caller = functions_find(&file->ours, part->ours);
    for (int i = 0; i < file->ours.count; i++) {
        const Function *ours = &file->ours.list[i];
        const bool called = caller && tokens_mention(file->ours_text + caller->begin,
                                                     caller->end - caller->begin, ours->name);
        if (!functions_find(&file->theirs, ours->name) && (part->helpers[0] || called))
            part_tasks_mark(tasks, rubric, file, ours->begin, ours->end);
    }
}
