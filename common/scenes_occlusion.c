#include "scene_parts.h"

const SceneMaker scenes_occlusion[] = {
    {0},
};
