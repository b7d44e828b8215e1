#include "exam/exam_seeds.h"

#include "base/json_fields.h"
#include "base/places.h"
#include "exam/handed_out.h"
#include "scene/check.h"

#include <stdlib.h>
#include <string.h>
#include <sys/random.h>

enum { MAX_SEEDS = 10000 };

static bool take_seed(const JsonPlace *file, const json_t *seeds, size_t i, uint64_t *seed) {
    const char *text = json_string_value(json_array_get(seeds, i));
    const size_t length = text ? strlen(text) : 0;
    if (length == 0 || length > 20 || strspn(text, "0123456789") != length) {
        const JsonPlace place = json_fields_enter(file, "", i, NULL);
        return json_fields_fail(&place, "", "is no seed; write a whole number of 64 bits as a text");
    }
    *seed = strtoull(text, NULL, 10);
    return true;
}

// The list of what is recorded here; NULL with a message.
static json_t *read_seeds(JsonPlace *file) {
    static char path[FILES_PATH];
    places_path(path, "grader/recorded");
    *file = (JsonPlace){.folder = path, .file = "seeds.json"};
    json_t *seeds = json_fields_read(file, NULL, 0, JSON_ARRAY);
    if (seeds && json_fields_fits(file, seeds, &(JsonField){"", FIELD_LIST, FIELD_NEEDED, 1, MAX_SEEDS}))
        return seeds;
    json_decref(seeds);
    return NULL;
}

bool exam_seeds_draw(uint64_t *seed) {
    JsonPlace file;
    ssize_t drawn = getrandom(seed, sizeof *seed, 0);
    INVARIANT(drawn == sizeof *seed);
    if (!handed_out_alone())
        return true;
    json_t *seeds = read_seeds(&file);
    bool ok = seeds && take_seed(&file, seeds, (size_t)(*seed % json_array_size(seeds)), seed);
    json_decref(seeds);
    return ok;
}

int exam_seeds_list(uint64_t *list, int most) {
    JsonPlace file;
    json_t *seeds = read_seeds(&file);
    int count = 0;
    while (seeds && count < most && (size_t)count < json_array_size(seeds) &&
           take_seed(&file, seeds, (size_t)count, &list[count]))
        count++;
    json_decref(seeds);
    return count;
}
