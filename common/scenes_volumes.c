#include "scene_parts.h"

const SceneMaker scenes_volumes[] = {
    {0},
};
