#include "scene_parts.h"

const SceneMaker scenes_filter[] = {
    {0},
};
