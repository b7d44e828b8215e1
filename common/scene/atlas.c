// Makes a chart of each flat face and places the charts in rows, from the bottom up.
#include "scene/atlas.h"

#include "scene/check.h"

#include <stdlib.h>
#include <string.h>

// The number that shaders/face_number.glsl gives a face by its normal in object space.
static int face_of(vec3s normal) {
    int axis = fabsf(normal.x) > 0.5f ? 0 : fabsf(normal.y) > 0.5f ? 1 : 2;
    return 2 * axis + (normal.raw[axis] < 0 ? 1 : 0);
}

static int texels_along(vec3s side, float texels_per_unit) {
    int count = (int)ceilf(glms_vec3_norm(side) * texels_per_unit - 1e-3f); // rounding adds no texel
    return count > 1 ? count : 1;
}

// `corners`: four vertices of a mesh, counter-clockwise from (s, t) = (0, 0).
static Chart make_chart(const mat4s *world_from_object, const Vertex *corners, float texels_per_unit) {
    Chart chart = {.corner = glms_mat4_mulv3(*world_from_object, corners[0].position, 1)};
    chart.side_s = glms_vec3_sub(glms_mat4_mulv3(*world_from_object, corners[1].position, 1), chart.corner);
    chart.side_t = glms_vec3_sub(glms_mat4_mulv3(*world_from_object, corners[3].position, 1), chart.corner);
    chart.right = glms_vec3_normalize(chart.side_s);
    chart.up = glms_vec3_normalize(chart.side_t);
    chart.normal = glms_vec3_cross(chart.right, chart.up);
    chart.width = texels_along(chart.side_s, texels_per_unit);
    chart.height = texels_along(chart.side_t, texels_per_unit);
    return chart;
}

// Adds the charts of object `o`, not yet placed; owners[] remembers their v_face.
static bool add_charts(Atlas *atlas, const Scene *scene, int o, float texels_per_unit, int *owners) {
    Mesh mesh;
    const Object *object = &scene->objects[o];
    if (object->shape != SHAPE_PLANE && object->shape != SHAPE_BOX)
        return true;
    if (!(glms_mat4_det(object->world_from_object) > 0))
        return check_fail("object %d is mirrored or flat, so that its faces have no outside: give it scales "
                          "above 0",
                          o);
    if (!mesh_create(&mesh, (Shape)object->shape))
        return false;
    for (int first = 0; first < mesh.vertex_count; first += 4) {
        owners[atlas->chart_count] = ATLAS_FACES * o + face_of(mesh.vertices[first].normal);
        atlas->charts[atlas->chart_count++] =
            make_chart(&object->world_from_object, &mesh.vertices[first], texels_per_unit);
    }
    mesh_destroy(&mesh);
    return true;
}

// Wide enough for the widest chart and about as wide as high.
static int choose_width(const Atlas *atlas) {
    int widest = 1, area = 0;
    for (int c = 0; c < atlas->chart_count; c++) {
        int width = atlas->charts[c].width + 2 * atlas->padding;
        widest = width > widest ? width : widest;
        area += width * (atlas->charts[c].height + 2 * atlas->padding);
    }
    int square = (int)ceilf(sqrtf((float)area));
    return square > widest ? square : widest;
}

// Places the charts in rows from the bottom, from left to right.
static void place_charts(Atlas *atlas, const int *owners) {
    int x = 0, y = 0, row_height = 0;
    atlas->width = choose_width(atlas);
    for (int c = 0; c < atlas->chart_count; c++) {
        Chart *chart = &atlas->charts[c];
        int width = chart->width + 2 * atlas->padding, height = chart->height + 2 * atlas->padding;
        if (x + width > atlas->width) {
            x = 0;
            y += row_height;
            row_height = 0;
        }
        chart->left = x + atlas->padding;
        chart->bottom = y + atlas->padding;
        atlas->rectangles[owners[c]] =
            (vec4s){{(float)chart->left, (float)chart->bottom, (float)chart->width, (float)chart->height}};
        x += width;
        row_height = height > row_height ? height : row_height;
    }
    atlas->height = y + row_height > 0 ? y + row_height : 1;
}

bool atlas_layout(Atlas *atlas, const Scene *scene, float texels_per_unit, int padding) {
    int owners[ATLAS_MAX_CHARTS] = {0};
    atlas_destroy(atlas);
    atlas->padding = padding;
    for (int o = 0; o < scene->object_count; o++)
        if (!add_charts(atlas, scene, o, texels_per_unit, owners))
            return false;
    place_charts(atlas, owners);
    if (atlas->width > ATLAS_MAX_SIZE || atlas->height > ATLAS_MAX_SIZE)
        return check_fail("the atlas would have %d x %d texels, %d x %d at most: lower the texel density",
                          atlas->width, atlas->height, ATLAS_MAX_SIZE, ATLAS_MAX_SIZE);
    size_t count = (size_t)atlas->width * (size_t)atlas->height;
    atlas->texels = malloc(count * sizeof *atlas->texels);
    if (!atlas->texels)
        return check_fail("out of memory for an atlas of %zu texels", count);
    for (size_t i = 0; i < count; i++)
        atlas->texels[i] = 1;
    return true;
}

void atlas_number_texels(Atlas *atlas) {
    for (int y = 0; y < atlas->height; y++)
        for (int x = 0; x < atlas->width; x++)
            atlas->texels[y * atlas->width + x] = (float)((5 * x + 3 * y) % 16) / 16;
}

void atlas_destroy(Atlas *atlas) {
    free(atlas->texels);
    memset(atlas, 0, sizeof *atlas);
}

vec3s atlas_position(const Chart *chart, float s, float t) {
    vec3s along = glms_vec3_add(glms_vec3_scale(chart->side_s, s), glms_vec3_scale(chart->side_t, t));
    return glms_vec3_add(chart->corner, along);
}
