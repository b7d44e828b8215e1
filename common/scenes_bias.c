#include "scene_parts.h"

const SceneMaker scenes_bias[] = {
    {0},
};
