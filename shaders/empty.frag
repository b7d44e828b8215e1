#version 410 core
// For passes that only want depth.

void main() {
}
