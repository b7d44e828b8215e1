#include "worker/renderdoc.h"

#if __has_include(<renderdoc_app.h>)

#include <dlfcn.h>
#include <renderdoc_app.h>
#include <stdbool.h>
#include <stddef.h>

// NULL when no RenderDoc was loaded into this process before it began.
static RENDERDOC_API_1_0_0 *find_api(void) {
    static RENDERDOC_API_1_0_0 *api; // found at the first call
    static bool asked;
    void *library = asked ? NULL : dlopen("librenderdoc.so", RTLD_NOW | RTLD_NOLOAD);
    asked = true;
    pRENDERDOC_GetAPI get_api = NULL;
    if (library)
        *(void **)&get_api = dlsym(library, "RENDERDOC_GetAPI"); // as POSIX shows it
    if (get_api)
        get_api(eRENDERDOC_API_Version_1_0_0, (void **)&api);
    return api;
}

void renderdoc_begin(void) {
    RENDERDOC_API_1_0_0 *api = find_api();
    if (api)
        api->StartFrameCapture(NULL, NULL);
}

void renderdoc_end(void) {
    RENDERDOC_API_1_0_0 *api = find_api();
    if (api)
        api->EndFrameCapture(NULL, NULL);
}

#else

void renderdoc_begin(void) {
}

void renderdoc_end(void) {
}

#endif
