#include "protocol/request_options.h"

#include "base/option_values.h"
#include "protocol/protocol.h"
#include "scene/check.h"

#include <stdio.h>
#include <string.h>

static bool read_knob(KnobSetting *knob, const char *text) {
    const char *equals = strchr(text, '=');
    const size_t length = equals ? (size_t)(equals - text) : 0;
    double value;
    if (length < 1 || length >= sizeof knob->name || !option_decimal(&value, equals + 1))
        return false;
    snprintf(knob->name, sizeof knob->name, "%.*s", (int)length, text);
    knob->value = (float)value;
    return true;
}

bool request_take_knob(void *target, const char *text) {
    Request *request = target;
    if (request->knob_count == LAB_MAX_KNOBS)
        return check_fail("is given more than %d times", LAB_MAX_KNOBS);
    if (read_knob(&request->knobs[request->knob_count], text)) {
        request->knob_count++;
        return true;
    }
    check_clear();
    return check_fail("takes NAME=VALUE with a number, not \"%s\"", text);
}

bool request_take_size(void *target, const char *text) {
    Request *request = target;
    int width, height;
    if (!option_size(&width, &height, text, PROTOCOL_MAX_SIZE))
        return false;
    request->width = width;
    request->height = height;
    return true;
}

bool request_take_view(void *target, const char *text) {
    Request *request = target;
    if (strlen(text) >= sizeof request->view)
        return check_fail("takes the name of a view, not \"%s\"", text);
    snprintf(request->view, sizeof request->view, "%s", text);
    return true;
}
