#include "scene_parts.h"

const SceneMaker scenes_random[] = {
    {0},
};
