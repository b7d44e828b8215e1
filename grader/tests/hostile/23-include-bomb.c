// A shader that is C as well and includes itself twice, 30 deep: 2^30 files.
// must: uncompiled CPU time limit exceeded|takes too long to compile|Killed signal terminated program cc1
// slow
#include "attack.frag"

static void attack(const Frame *frame) {
    (void)frame;
}
