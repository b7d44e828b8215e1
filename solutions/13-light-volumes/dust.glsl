// The air, and the way from the eye to what a pixel shows.

#include "lights.glsl"

uniform float u_scattering; // share of the light that is sent elsewhere on each unit of its way
uniform float u_extinction; // share that is lost on each unit of its way

uniform sampler2D u_depth;      // of what is seen
uniform mat4 u_world_from_clip; // the inverse of the camera's matrix

// The point of the world that is seen at `uv` of the picture (0 to 1). In the sky it is a point of the far
// plane: there the dust ends.
vec3 seen_at(vec2 uv) {
#ifdef SOLUTION // 13.1
    vec4 position_clip = vec4(2.0 * vec3(uv, texture(u_depth, uv).r) - 1.0, 1.0);
    vec4 position_world = u_world_from_clip * position_clip;
    return position_world.xyz / position_world.w;
#else
    // TODO(13.1): uv and the depth that lies there are in [0, 1], clip space (w = 1) in [-1, 1]. Take that
    // point back to the world, and divide. Until then all is seen at the eye.
    return u_eye_world;
#endif
}

// The share of light that is left after a way of this length.
float transmittance(float way) {
#ifdef SOLUTION // 13.2
    return exp(-u_extinction * way);
#else
    // TODO(13.2): the law of Beer and Lambert. Until then nothing is lost.
    return 1.0;
#endif
}

// The sum of transmittance(t) over all t from 0 to `way`, exactly.
float gathered(float way) {
#ifdef SOLUTION // 13.7
    float depth = u_extinction * way;
    return depth < 1e-3 ? way : (1.0 - exp(-depth)) / u_extinction;
#else
    // TODO(13.7): the integral of transmittance. Where the extinction is 0, or so small that over this way
    // less than about 0.001 is lost, that is the way itself.
    return 0.0;
#endif
}
