// Measures the line V* = 1/2 by marching squares, and how far a texel of the map stretches in the picture
// there.
#include "study/edge.h"

#include "study/pareto.h"
#include "base/statistics.h"
#include "shadow_map.h"

#include <math.h>
#include <stdlib.h>

// A picture of the truth: which object a pixel shows, and how much of it is lit.
typedef struct Field {
    MetricsSize size;
    const int32_t *traced;
    const float *truth;
} Field;

static bool same_object(const Field *field, ptrdiff_t a, ptrdiff_t b) {
    return metrics_object(field->traced[a]) == metrics_object(field->traced[b]);
}

// A pixel's truth, smoothed over its neighbours of the same object by a tent of 3 x 3: then linear
// interpolation between pixels meets a straight edge at every angle.
static double smooth(const Field *field, int x, int y) {
    const ptrdiff_t middle = (ptrdiff_t)y * field->size.width + x;
    double sum = 0, weights = 0;
    for (int dy = -1; dy <= 1; dy++)
        for (int dx = -1; dx <= 1; dx++) {
            const ptrdiff_t at = middle + (ptrdiff_t)dy * field->size.width + dx;
            const bool inside =
                x + dx >= 0 && x + dx < field->size.width && y + dy >= 0 && y + dy < field->size.height;
            if (!inside || !same_object(field, at, middle))
                continue;
            const double weight = (2 - abs(dx)) * (2 - abs(dy));
            sum += weight * (double)field->truth[at];
            weights += weight;
        }
    return sum / weights;
}

// The part of the line in a square of four pixels, whose values go round it.
static double piece(const double values[4]) {
    static const double corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    double ends[4][2];
    int count = 0;
    for (int i = 0; i < 4; i++) {
        const int j = (i + 1) % 4;
        if ((values[i] >= 0.5) == (values[j] >= 0.5))
            continue;
        const double way = (0.5 - values[i]) / (values[j] - values[i]);
        for (int axis = 0; axis < 2; axis++)
            ends[count][axis] = corners[i][axis] + way * (corners[j][axis] - corners[i][axis]);
        count++;
    }
    double length = 0;
    for (int i = 0; i < count; i += 2)
        length += hypot(ends[i][0] - ends[i + 1][0], ends[i][1] - ends[i + 1][1]);
    return length;
}

double edge_length(MetricsSize size, const int32_t *traced, const uint8_t *mask, const float *truth) {
    static const int around[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const Field field = {size, traced, truth};
    double length = 0;
    for (int y = 0; y + 1 < size.height; y++)
        for (int x = 0; x + 1 < size.width; x++) {
            const ptrdiff_t first = (ptrdiff_t)y * size.width + x;
            double values[4], sum = 0;
            bool counts = true;
            for (int i = 0; counts && i < 4; i++) {
                const ptrdiff_t at = first + around[i][0] + (ptrdiff_t)around[i][1] * size.width;
                counts = mask[at] && same_object(&field, at, first);
                sum += (double)truth[at];
            }
            if (!counts || sum <= 0 ||
                sum >= 4) // four that agree stay on their side, however they are smoothed
                continue;
            for (int i = 0; i < 4; i++)
                values[i] = smooth(&field, x + around[i][0], y + around[i][1]);
            length += piece(values);
        }
    return length;
}

double edge_error(const Metrics *metrics, double length) {
    return length > 0 ? metrics->edge.mae * (double)metrics->all.pixels / length : 0;
}

static vec2s project(mat4s clip_from_world, vec3s p) {
    vec4s clip = glms_mat4_mulv(clip_from_world, glms_vec4(p, 1));
    return (vec2s){{clip.x / clip.w, clip.y / clip.w}};
}

// How the place of `p` in clip space moves along the world's directions right and up, by differences; column
// by column.
static mat2s moves(mat4s clip_from_world, vec3s p, vec3s right, vec3s up) {
    const float step = 2e-3f;
    mat2s m;
    const vec3s along[2] = {right, up};
    for (int i = 0; i < 2; i++) {
        vec2s after = project(clip_from_world, glms_vec3_add(p, glms_vec3_scale(along[i], step / 2)));
        vec2s before = project(clip_from_world, glms_vec3_sub(p, glms_vec3_scale(along[i], step / 2)));
        m.col[i] = glms_vec2_scale(glms_vec2_sub(after, before), 1 / step);
    }
    return m;
}

// The largest factor by which a 2 x 2 matrix lengthens a vector.
static double largest_stretch(mat2s m) {
    double a = m.raw[0][0], b = m.raw[1][0], c = m.raw[0][1], d = m.raw[1][1];
    double sum = a * a + b * b + c * c + d * d, det = a * d - b * c;
    return sqrt((sum + sqrt(fmax(sum * sum - 4 * det * det, 0))) / 2);
}

// Pixels along the map's side around this point of a surface.
static double side_at(const TruthView *truth_view, const TruthHit *hit) {
    const Camera *camera = &truth_view->truth.scene.camera;
    float width = (float)truth_view->size.width, height = (float)truth_view->size.height;
    mat4s seen = glms_mat4_mul(camera_clip_from_view(camera, width / height), camera_view_from_world(camera));
    vec3s right = glms_vec3_normalize(glms_vec3_ortho(hit->face_normal));
    vec3s up = glms_vec3_cross(hit->face_normal, right);
    mat2s in_picture = moves(seen, hit->position, right, up);
    mat2s in_map =
        moves(shadow_map_clip_from_world(&truth_view->truth.scene.lights[0]), hit->position, right, up);
    mat2s picture_from_map = glms_mat2_mul(in_picture, glms_mat2_inv(in_map));
    for (int i = 0; i < 2; i++) {
        picture_from_map.raw[i][0] *= width; // both spaces are 2 wide
        picture_from_map.raw[i][1] *= height;
    }
    return largest_stretch(picture_from_map);
}

double edge_map_side(const TruthView *truth_view) {
    size_t pixels = (size_t)truth_view->size.width * (size_t)truth_view->size.height, count = 0;
    double *sides = calloc(pixels, sizeof *sides);
    for (size_t i = 0; sides && i < pixels; i++)
        if (truth_view->distance[i] < 1 && truth_view->facing[i] > METRICS_LEAST_FACING)
            sides[count++] = side_at(truth_view, &truth_view->picture.hits[i]);
    double side = count > 0 ? statistics_percentile(sides, count, 95) : 0;
    free(sides);
    return side;
}
