#include "scene/ray.h"

// A vector of the world in the object's axes. These are orthogonal (no shear), so that no inverse is needed.
static vec3s in_object(const Object *object, vec3s vector_world) {
    vec3s vector_object;
    for (int i = 0; i < 3; i++) {
        const float *axis = object->world_from_object.raw[i];
        float along = axis[0] * vector_world.x + axis[1] * vector_world.y + axis[2] * vector_world.z;
        vector_object.raw[i] = along / (axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    }
    return vector_object;
}

static bool within(float distance, float max_distance) {
    return distance > 0 && distance <= max_distance;
}

static bool hits_plane(vec3s from, vec3s along, float max_distance) {
    float distance = -from.y / along.y;
    return within(distance, max_distance) && fabsf(from.x + distance * along.x) <= 1 &&
           fabsf(from.z + distance * along.z) <= 1;
}

// Slabs: Kay, Kajiya: Ray Tracing Complex Scenes, SIGGRAPH 1986.
static bool hits_slabs(vec3s low, vec3s high, vec3s from, vec3s along, float max_distance) {
    float enters = -INFINITY, leaves = INFINITY;
    for (int i = 0; i < 3; i++) {
        float a = (low.raw[i] - from.raw[i]) / along.raw[i], b = (high.raw[i] - from.raw[i]) / along.raw[i];
        enters = fmaxf(enters, fminf(a, b));
        leaves = fminf(leaves, fmaxf(a, b));
    }
    return enters <= leaves && (within(enters, max_distance) || within(leaves, max_distance));
}

static bool hits_box(vec3s from, vec3s along, float max_distance) {
    return hits_slabs(vec3_make(-1, -1, -1), vec3_make(1, 1, 1), from, along, max_distance);
}

// Two legs and a beam.
static bool hits_arch(vec3s from, vec3s along, float max_distance) {
    return hits_slabs(vec3_make(-1, -1, -1), vec3_make(-0.5f, 1, 1), from, along, max_distance) ||
           hits_slabs(vec3_make(0.5f, -1, -1), vec3_make(1, 1, 1), from, along, max_distance) ||
           hits_slabs(vec3_make(-1, 0.5f, -1), vec3_make(1, 1, 1), from, along, max_distance);
}

static bool hits_sphere(vec3s from, vec3s along, float max_distance) {
    float a = glms_vec3_dot(along, along), b = glms_vec3_dot(from, along);
    vec3s across = glms_vec3_cross(from, along); // b * b - a * (from^2 - 1) would lose all digits far away
    float root = a - glms_vec3_dot(across, across);
    if (root < 0)
        return false;
    root = sqrtf(root);
    return within((-b - root) / a, max_distance) || within((-b + root) / a, max_distance);
}

bool ray_hits(const Scene *scene, vec3s origin, vec3s direction, float max_distance) {
    static bool (*const hits[SHAPE_COUNT])(vec3s from, vec3s along,
                                           float max_distance) = {[SHAPE_PLANE] = hits_plane,
                                                                  [SHAPE_BOX] = hits_box,
                                                                  [SHAPE_SPHERE] = hits_sphere,
                                                                  [SHAPE_ARCH] = hits_arch};
    for (int i = 0; i < scene->object_count; i++) {
        const Object *object = &scene->objects[i];
        const float *center = object->world_from_object.raw[3];
        vec3s from_center = vec3_make(origin.x - center[0], origin.y - center[1], origin.z - center[2]);
        // Distances keep their measure: both vectors are scaled alike.
        if (hits[object->shape](in_object(object, from_center), in_object(object, direction), max_distance))
            return true;
    }
    return false;
}
