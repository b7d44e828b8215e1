// Reads the rule, and refuses what nobody can have meant: dates that are none, labs that there are not,
// shares for percents.
#include "book/late_rule.h"

#include "base/files.h"
#include "base/json_fields.h"
#include "base/places.h"
#include "base/text_check.h"
#include "class/hand_in_time.h"
#include "scene/check.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DAY = 24 * 60 * 60, MINUTE = 60 };

static const JsonField fields[] = {{"due", FIELD_KEYS, FIELD_NEEDED, 1, COURSE_MAX_LABS},
                                   {"free days", FIELD_WHOLE, FIELD_OPTIONAL, 0, 366},
                                   {"percent a day", FIELD_NUMBER, FIELD_NEEDED, 0, 100},
                                   {"at most percent", FIELD_NUMBER, FIELD_OPTIONAL, 0, 100},
                                   {"grace minutes", FIELD_WHOLE, FIELD_OPTIONAL, 0, 24 * 60},
                                   {.key = NULL}};

static bool read_due(LateRule *rule, const JsonPlace *place, const char *lab, const json_t *value) {
    const char *text = json_string_value(value);
    char folder[FILES_PATH];
    time_t due;
    if (strlen(lab) != 2 || lab[strspn(lab, "0123456789")])
        return json_fields_fail(place, "due", "\"%.20s\" is no lab: write its number, as \"03\"", lab);
    if (!text || !hand_in_time_parse(&due, text))
        return json_fields_fail(place, "due",
                                "lab %s: \"%.40s\" is no time: write one as \"2026-11-03 23:59\", or with a "
                                "zone as \"2026-11-03 23:59 +0100\"",
                                lab, text ? text : "");
    if (!places_find_lab(folder, lab))
        return json_fields_fail(place, "due", "there is no lab %s: correct its number", lab);
    int at = rule->count++;
    for (; at > 0 && rule->due[at - 1] > due; at--) {
        rule->due[at] = rule->due[at - 1];
        memcpy(rule->labs[at], rule->labs[at - 1], sizeof rule->labs[0]);
    }
    rule->due[at] = due;
    memcpy(rule->labs[at], lab, sizeof rule->labs[0]);
    return true;
}

static double number_or(const json_t *root, const char *key, double otherwise) {
    const json_t *value = json_object_get(root, key);
    return value ? json_number_value(value) : otherwise;
}

// 0.1 was meant as ten percent.
static bool is_share(double percent) {
    return percent > 0 && percent < 1;
}

static bool read_rule(LateRule *rule, const JsonPlace *place, json_t *root) {
    const char *lab;
    json_t *due;
    if (!json_fields_check(place, root, fields))
        return false;
    json_object_foreach(json_object_get(root, "due"), lab,
                        due) if (!read_due(rule, place, lab, due)) return false;
    rule->free_days = (int)number_or(root, "free days", 0);
    rule->percent = number_or(root, "percent a day", 0);
    rule->cap = number_or(root, "at most percent", 100);
    if (is_share(rule->percent))
        return json_fields_fail(place, "percent a day",
                                "%g is less than one percent: for ten percent write 10", rule->percent);
    if (is_share(rule->cap))
        return json_fields_fail(place, "at most percent", "%g is less than one percent: for a half write 50",
                                rule->cap);
    rule->grace = MINUTE * number_or(root, "grace minutes", 0);
    return rule->given = true;
}

bool late_rule_read(LateRule *rule, const char *path) {
    char folder[FILES_PATH];
    const char *slash = strrchr(path, '/');
    snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash - path) : 1, slash ? path : ".");
    const JsonPlace place = {.folder = folder, .file = slash ? slash + 1 : path};
    *rule = (LateRule){.given = false};
    size_t size;
    char *text = files_read_bytes(path, RUBRIC_MAX_FILE, &size);
    json_t *root = text && text_check(text, size, path)
                       ? json_fields_read(&place, text, strlen(text), JSON_OBJECT)
                       : NULL;
    free(text);
    const bool ok = root && read_rule(rule, &place, root);
    json_decref(root);
    return ok;
}

double late_rule_seconds(const LateRule *rule, const char *lab, time_t handed_in) {
    for (int i = 0; handed_in != 0 && i < rule->count; i++)
        if (strcmp(rule->labs[i], lab) == 0)
            return fmax(0, difftime(handed_in, rule->due[i]));
    return 0;
}

int late_rule_days(const LateRule *rule, const char *lab, time_t handed_in) {
    return (int)fmax(0, ceil((late_rule_seconds(rule, lab, handed_in) - rule->grace) / DAY));
}

double late_rule_share(const LateRule *rule, int days) {
    return fmin(days * rule->percent, rule->cap) / 100;
}
