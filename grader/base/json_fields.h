// Reads JSON that a person wrote. Each object has a table of the keys that it may have; what does not fit
// ends in one message that names the file, the entry and the key, says what is wrong, and what to write
// instead.
#pragma once

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

typedef enum JsonFieldKind {
    FIELD_NAME,   // a text of one line, of `low` to `high` bytes
    FIELD_LINES,  // a text, or a list of lines: json_fields_join gives both as one text
    FIELD_WHOLE,  // a whole number from `low` to `high`
    FIELD_NUMBER, // a finite number from `low` to `high`
    FIELD_FLAG,   // true or false
    FIELD_LIST,   // of `low` to `high` entries
    FIELD_KEYS,   // an object of `low` to `high` keys that no table knows
    FIELD_OTHER   // anything: whoever reads it checks it, and `low` and `high` do not matter
} JsonFieldKind;

typedef enum JsonFieldNeed { FIELD_OPTIONAL, FIELD_NEEDED } JsonFieldNeed;

// A key that an object may have. A table ends with a field without a key.
typedef struct JsonField {
    const char *key;
    JsonFieldKind kind;
    JsonFieldNeed need;
    double low, high;
} JsonField;

// Where something stands, for messages. Folder and file are not owned.
typedef struct JsonPlace {
    const char *folder, *file;
    char entry[320]; // "checks[3] \"depth map\": "; "" for the whole file
} JsonPlace;

// The place of entry `index` (from 0) of the list `list` ("": the file is the list), with its name when it
// has one (not NULL) that can be printed.
JsonPlace json_fields_enter(const JsonPlace *outer, const char *list, size_t index, const char *name);

// check_fail with "FOLDER/FILE: ENTRY: KEY: " before the message; an empty key is left out.
bool json_fields_fail(const JsonPlace *place, const char *key, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

// Reads place's file, or `size` bytes of `text` in its place when that is not NULL. The caller frees it by
// json_decref. NULL with a message when it cannot be read, is no JSON, has a key twice, or is not of this
// type (object or array).
json_t *json_fields_read(const JsonPlace *place, const char *text, size_t size, json_type type);

// Does the object have only keys of the table, each with a value that fits, and all that are needed? Else
// false with a message.
bool json_fields_check(const JsonPlace *place, const json_t *object, const JsonField *fields);

// Does one value fit the field? False with a message. For lists and keys that no table knows.
bool json_fields_fits(const JsonPlace *place, const json_t *value, const JsonField *field);

// The text of FIELD_LINES that fits. A list's text is kept in the array `kept`, and lives as long as that.
const char *json_fields_join(json_t *kept, const json_t *value);
