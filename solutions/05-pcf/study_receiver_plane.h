// Receiver-plane depth bias as edits of this lab's shader: each tap of the box compares with the depth that
// the receiver's plane has there, by the derivatives of the place in the map. J. Isidoro: Shadow Mapping:
// GPU-based Tips and Techniques, GDC 2006.
#pragma once

#define RECEIVER_PLANE                                                                                       \
    {"shadow.frag", "    vec2 texel = 1.0 / vec2(textureSize(u_shadow_map, 0));",                            \
     "    vec2 texel = 1.0 / vec2(textureSize(u_shadow_map, 0));\n"                                          \
     "    vec3 right = dFdx(position_map), up = dFdy(position_map);\n"                                       \
     "    vec2 slope = vec2(right.z * up.y - up.z * right.y, up.z * right.x - right.z * up.x) /\n"           \
     "                 (right.x * up.y - right.y * up.x);"},                                                 \
    {                                                                                                        \
        "shadow.frag", "vec2(x, y) * texel, position_map.z))",                                               \
            "vec2(x, y) * texel, position_map.z + dot(slope, vec2(x, y) * texel)))"                          \
    }
