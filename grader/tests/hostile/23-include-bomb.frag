#if __INCLUDE_LEVEL__ < 30
#include "attack.frag"
#include "attack.frag"
#endif
