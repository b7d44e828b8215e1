#include "diagnose/error_view.h"

#include "protocol/protocol.h"

#include <stdlib.h>
#include <string.h>

enum { LABS_WITHOUT_SHADOWS = 2 };

ErrorView error_view_of(const Check *check, const Rubric *rubric) {
    const bool shadows = atoi(rubric->id) > LABS_WITHOUT_SHADOWS;
    if (shadows && strcmp(check->view, VIEW_PICTURE) == 0)
        return ERROR_VIEW_SHADED;
    return shadows && strcmp(check->view, VIEW_VISIBILITY) == 0 ? ERROR_VIEW_VISIBILITY : ERROR_VIEW_VALUES;
}
