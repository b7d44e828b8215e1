#include "protocol/request_options.h"

#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool request_take_knob(Request *request, const char *text) {
    const char *equals = strchr(text, '=');
    if (!equals || request->knob_count == LAB_MAX_KNOBS)
        return check_fail("--knob takes NAME=VALUE, not \"%s\"", text);
    KnobSetting *knob = &request->knobs[request->knob_count++];
    snprintf(knob->name, sizeof knob->name, "%.*s", (int)(equals - text), text);
    knob->value = strtof(equals + 1, NULL);
    return true;
}

bool request_take_size(Request *request, const char *text) {
    int used = 0;
    bool ok = sscanf(text, "%dx%d%n", &request->width, &request->height, &used) == 2 && text[used] == '\0' &&
              request->width > 0 && request->height > 0 && request->width <= PROTOCOL_MAX_SIZE &&
              request->height <= PROTOCOL_MAX_SIZE;
    return ok || check_fail("--size takes WIDTHxHEIGHT up to %d, not \"%s\"", PROTOCOL_MAX_SIZE, text);
}
