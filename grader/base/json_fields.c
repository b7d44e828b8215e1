// Holds an object against the table of its keys, and makes the one message that says what is wrong and what
// to write instead.
#include "base/json_fields.h"

#include "base/files.h"
#include "base/limits.h"
#include "scene/check.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SHOWN = 60 }; // bytes of a value in a message

static bool is_one_line(const char *text) {
    for (; *text; text++)
        if ((unsigned char)*text < ' ' || *text == 0x7f)
            return false;
    return true;
}

JsonPlace json_fields_enter(const JsonPlace *outer, const char *list, size_t index, const char *name) {
    JsonPlace place = *outer;
    const bool named = name && name[0] && is_one_line(name) && strlen(name) <= RUBRIC_MAX_NAME;
    check_append(place.entry, sizeof place.entry, "%s[%zu]%s%s%s: ", list, index, named ? " \"" : "",
                 named ? name : "", named ? "\"" : "");
    return place;
}

// Control characters could write anything to a terminal.
static void make_printable(char *text) {
    for (; *text; text++)
        if ((unsigned char)*text < ' ' || *text == 0x7f)
            *text = '?';
}

bool json_fields_fail(const JsonPlace *place, const char *key, const char *format, ...) {
    char text[2048] = "";
    va_list arguments;
    check_append(text, sizeof text, "%.*s%s", RUBRIC_MAX_NAME, key, key[0] ? ": " : "");
    va_start(arguments, format);
    vsnprintf(text + strlen(text), sizeof text - strlen(text), format, arguments);
    va_end(arguments);
    make_printable(text);
    return check_fail("%s/%s: %s%s", place->folder, place->file, place->entry, text);
}

static const char *type_name(json_type type) {
    return type == JSON_OBJECT ? "an object { }" : "a list [ ]";
}

// The value as JSON of printable ASCII, cut short.
static void show(char shown[SHOWN + 8], const json_t *value) {
    char *text =
        json_dumps(value, JSON_ENCODE_ANY | JSON_COMPACT | JSON_ENSURE_ASCII | JSON_REAL_PRECISION(10));
    const bool long_text = text && strlen(text) > SHOWN;
    snprintf(shown, SHOWN + 8, "%.*s%s", SHOWN, text ? text : "this", long_text ? " ..." : "");
    free(text);
}

static void show_key(char shown[SHOWN + 8], const char *key) {
    json_t *text = json_string(key);
    show(shown, text);
    json_decref(text);
}

// What people write who have seen little JSON.
static const char *remedy(const char *error) {
    static const char *const remedies[][2] = {
        {"unable to decode", ": save it as UTF-8"},
        {"near '}'", ": is there a comma too many before it?"},
        {"near ']'", ": is there a comma too many before it?"},
        {"near \x27\x27", ": texts stand in straight double quotes, \"so\""},
        {"near '\xe2\x80", ": texts stand in straight double quotes, \"so\""},
        {"near '/'", ": JSON has no comments"},
        {"near '#'", ": JSON has no comments"},
        {"duplicate", ": keep one of them"},
        {"end of file", ": a bracket or the text behind it is missing"},
        {"near '",
         ": texts stand in double quotes, numbers have a point, and a comma stands between two entries"},
    };
    for (size_t i = 0; i < sizeof remedies / sizeof remedies[0]; i++)
        if (strstr(error, remedies[i][0]))
            return remedies[i][1];
    return "";
}

json_t *json_fields_read(const JsonPlace *place, const char *text, size_t size, json_type type) {
    char path[FILES_PATH], *own = NULL;
    json_error_t error;
    if (!text) {
        files_join(path, place->folder, place->file);
        text = own = files_read(path, RUBRIC_MAX_FILE);
        size = own ? strlen(own) : 0;
    }
    if (!text)
        return NULL;
    json_t *root = json_loadb(text, size, JSON_REJECT_DUPLICATES, &error);
    free(own);
    if (!root)
        check_fail("%s/%s:%d: %s%s", place->folder, place->file, error.line, error.text, remedy(error.text));
    else if (json_typeof(root) != type)
        check_fail("%s/%s:1: expected %s", place->folder, place->file, type_name(type));
    if (root && json_typeof(root) == type)
        return root;
    json_decref(root);
    return NULL;
}

static size_t lines_length(const json_t *lines) {
    size_t i, length = 0;
    const json_t *line;
    json_array_foreach(lines, i, line) length += json_string_length(line) + (i > 0);
    return length;
}

static bool are_lines(const json_t *value, const JsonField *field) {
    size_t i, length = json_is_string(value) ? json_string_length(value) : lines_length(value);
    const json_t *line;
    if (!json_is_string(value) && json_array_size(value) == 0)
        return false;
    json_array_foreach(value, i, line) if (!json_is_string(line)) return false;
    return (double)length >= field->low && (double)length <= field->high;
}

static bool is_name(const json_t *value, const JsonField *field) {
    const double length = (double)json_string_length(value);
    return json_is_string(value) && length >= field->low && length <= field->high &&
           is_one_line(json_string_value(value));
}

static bool is_number(const json_t *value, const JsonField *field) {
    const double number = json_number_value(value);
    return json_is_number(value) && isfinite(number) && number >= field->low && number <= field->high;
}

static bool fits(const json_t *value, const JsonField *field) {
    const double entries = (double)(json_is_array(value) ? json_array_size(value) : json_object_size(value));
    switch (field->kind) {
    case FIELD_NAME:
        return is_name(value, field);
    case FIELD_LINES:
        return are_lines(value, field);
    case FIELD_WHOLE:
        return json_is_integer(value) && is_number(value, field);
    case FIELD_NUMBER:
        return is_number(value, field);
    case FIELD_FLAG:
        return json_is_boolean(value);
    case FIELD_LIST:
        return json_is_array(value) && entries >= field->low && entries <= field->high;
    case FIELD_KEYS:
        return json_is_object(value) && entries >= field->low && entries <= field->high;
    case FIELD_OTHER:
        return true;
    }
    return false;
}

static void describe(char text[160], const JsonField *field) {
    static const char *const formats[] = {
        [FIELD_NAME] = "a text of one line, of %.10g to %.10g bytes",
        [FIELD_LINES] = "a text, or a list of lines, of %.10g to %.10g bytes",
        [FIELD_WHOLE] = "a whole number from %.10g to %.10g",
        [FIELD_NUMBER] = "a number from %.10g to %.10g",
        [FIELD_FLAG] = "true or false",
        [FIELD_LIST] = "a list [ ] of %.10g to %.10g entries",
        [FIELD_KEYS] = "an object { } of %.10g to %.10g keys",
        [FIELD_OTHER] = "a value",
    };
    const char *format = formats[field->kind];
    if (strchr(format, '%'))
        snprintf(text, 160, format, field->low, field->high);
    else
        snprintf(text, 160, "%s", format);
}

bool json_fields_fits(const JsonPlace *place, const json_t *value, const JsonField *field) {
    char shown[SHOWN + 8], wanted[160];
    if (fits(value, field))
        return true;
    show(shown, value);
    describe(wanted, field);
    return json_fields_fail(place, field->key, "%s does not fit; write %s", shown, wanted);
}

static const JsonField *find(const JsonField *fields, const char *key) {
    for (; fields->key; fields++)
        if (strcmp(fields->key, key) == 0)
            return fields;
    return NULL;
}

static bool fail_unknown(const JsonPlace *place, const char *key, const JsonField *fields) {
    char shown[SHOWN + 8], known[400] = "";
    show_key(shown, key);
    for (const JsonField *field = fields; field->key; field++)
        check_append(known, sizeof known, "%s\"%s\"", field > fields ? ", " : "", field->key);
    return json_fields_fail(place, "", "there is no key %s; the keys here are %s", shown, known);
}

bool json_fields_check(const JsonPlace *place, const json_t *object, const JsonField *fields) {
    char text[160];
    const char *key;
    json_t *value;
    if (!json_is_object(object)) {
        show(text, object);
        return json_fields_fail(place, "", "%s does not fit; write an object { }", text);
    }
    json_object_foreach((json_t *)object, key, value) {
        const JsonField *field = find(fields, key);
        if (!field)
            return fail_unknown(place, key, fields);
        if (!json_fields_fits(place, value, field))
            return false;
    }
    for (const JsonField *field = fields; field->key; field++)
        if (field->need == FIELD_NEEDED && !json_object_get(object, field->key)) {
            describe(text, field);
            return json_fields_fail(place, field->key, "is missing; write %s", text);
        }
    return true;
}

const char *json_fields_join(json_t *kept, const json_t *value) {
    if (!json_is_array(value))
        return json_string_value(value);
    const size_t size = lines_length(value) + 1;
    char *text = calloc(size, 1), *end = text;
    size_t i;
    const json_t *line;
    INVARIANT(text);
    json_array_foreach(value, i, line) {
        if (i > 0)
            *end++ = '\n';
        memcpy(end, json_string_value(line), json_string_length(line));
        end += json_string_length(line);
    }
    json_t *joined = json_string(text);
    free(text);
    const bool is_kept = json_array_append_new(kept, joined) == 0;
    INVARIANT(is_kept);
    return json_string_value(joined);
}
