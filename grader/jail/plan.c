#include "jail/plan.h"

#include "jail/stage.h"

void jail_part(const Jail *jail, const char *part, char path[FILES_PATH]) {
    if (jail)
        files_join(path, jail->stage, part);
    else
        stage_source(part, path);
}
