#include "class/hand_in_time.h"

#include "scene/count.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

static bool read_zone(struct tm *parts, const char *rest, bool *zoned) {
    rest += strspn(rest, " ");
    *zoned = rest[0] != '\0';
    if (!*zoned)
        return true;
    if (strcasecmp(rest, "UTC") == 0 || strcasecmp(rest, "GMT") == 0)
        rest = "+0000";
    const char *end = strptime(rest, "%z", parts);
    return end && !*end;
}

// strptime takes the 31st of November, and reads the year of "3.11.26" as that of the Romans.
static bool is_day(const struct tm *read, const struct tm *made) {
    enum { FIRST_YEAR = 1990 - 1900 };
    return read->tm_year >= FIRST_YEAR && read->tm_mday == made->tm_mday && read->tm_mon == made->tm_mon;
}

bool hand_in_time_parse(time_t *time, const char *text) {
    static const char *const forms[] = {
        "%Y-%m-%dT%H:%M:%S",     "%Y-%m-%d %H:%M:%S",  "%Y-%m-%dT%H:%M",    "%Y-%m-%d %H:%M",
        "%Y-%m-%d-%H-%M-%S",     "%d.%m.%Y %H:%M:%S",  "%d.%m.%Y %H:%M",    "%A, %d %B %Y, %I:%M %p",
        "%d %B %Y, %I:%M:%S %p", "%d %B %Y, %I:%M %p", "%b %d, %Y %I%M %p", "%b %d, %Y %I:%M %p",
    };
    for (size_t f = 0; f < COUNT(forms); f++) {
        struct tm parts = {.tm_isdst = -1};
        bool zoned;
        const char *rest = strptime(text, forms[f], &parts);
        if (!rest || !read_zone(&parts, rest, &zoned))
            continue;
        const long offset = parts.tm_gmtoff;
        struct tm made = parts;
        *time = zoned ? timegm(&made) - offset : mktime(&made);
        if (is_day(&parts, &made))
            return true;
    }
    return false;
}
