#include "study/method.h"

#include "scene/check.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static Method *add(MethodList *list, const char *lab, const char *family) {
    INVARIANT(list->count < METHOD_MOST);
    Method *method = &list->methods[list->count++];
    *method = (Method){
        .lab = lab, .family = family, .setting = {.view = VIEW_VISIBILITY, .object = TRUTH_NONE}, .maps = 1};
    return method;
}

Method *method_add(MethodList *list, const char *lab, const char *family, const char *format, ...) {
    Method *method = add(list, lab, family);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(method->name, sizeof method->name, format, arguments);
    va_end(arguments);
    return method;
}

Method *method_add_map(MethodList *list, const char *lab, const char *family, int map_size,
                       const char *format, ...) {
    Method *method = add(list, lab, family);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(method->name, sizeof method->name, format, arguments);
    va_end(arguments);
    check_append(method->name, sizeof method->name, "%s%d x %d", method->name[0] ? ", " : "", map_size,
                 map_size);
    method->map_size = map_size;
    setting_knob(&method->setting, "map size", (float)map_size);
    return method;
}

float method_knob(const Method *method, const char *name, float other) {
    for (int i = 0; i < method->setting.knob_count; i++)
        if (strcmp(method->setting.knobs[i].name, name) == 0)
            return method->setting.knobs[i].value;
    return other;
}
