#include "exam/known_place.h"

#include "scene/check.h"

#include <stdio.h>
#include <string.h>

void known_place_append(KnownPlace *known, const char *folder, const Jail *jail, Reply *reply) {
    if (!reply->place)
        return;
    if (known->offset != reply->place || strcmp(known->folder, folder) != 0) {
        *known = (KnownPlace){.folder = ""};
        if (!compiler_locate(folder, jail, reply->place, known->text))
            return;
        snprintf(known->folder, sizeof known->folder, "%s", folder);
        known->offset = reply->place;
    }
    check_append(reply->message, sizeof reply->message, " (%s)", known->text);
}
