#include "window/keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

static const float DRAG = 3, SCROLL = 0.1F; // radians a height, logarithms

void keys_drag(App *app, int buttons, int modifiers, float dx, float dy) {
    ViewState *state = &app->state;
    if (buttons & 1 << GLFW_MOUSE_BUTTON_RIGHT) {
        state->light.azimuth += DRAG * dx;
        state->light.elevation -= DRAG * dy;
    } else if (buttons & 1 << GLFW_MOUSE_BUTTON_MIDDLE || modifiers & GLFW_MOD_SHIFT) {
        state->camera.right -= dx;
        state->camera.up += dy;
    } else {
        state->camera.azimuth -= DRAG * dx;
        state->camera.elevation += DRAG * dy;
    }
    view_state_limit(state);
}

void keys_scroll(App *app, float steps) {
    app->state.camera.zoom -= SCROLL * steps;
    view_state_limit(&app->state);
}
