// Which of the six faces of an object a flat face is.

// +x, -x, +y, -y, +z, -z in object space: 0 to 5.
int face_number(vec3 normal) {
    int axis = abs(normal.x) > 0.5 ? 0 : abs(normal.y) > 0.5 ? 1 : 2;
    return 2 * axis + (normal[axis] < 0.0 ? 1 : 0);
}
