#include "base/blame.h"

#include "scene/count.h"

#include <errno.h>

bool blame_is_ours(int error) {
    static const int theirs[] = {0, ENOENT, ENOTDIR, ELOOP, EACCES, EPERM, EXDEV, ENAMETOOLONG, ENXIO};
    for (unsigned i = 0; i < COUNT(theirs); i++)
        if (error == theirs[i])
            return false;
    return true;
}
