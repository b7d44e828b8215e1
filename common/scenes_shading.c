#include "scene_parts.h"

const SceneMaker scenes_shading[] = {
    {0},
};
