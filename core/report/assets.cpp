// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/assets.h"

// The bytes of a file as an array of the program: a C++ array of 850 kB would take seconds to compile.
#define PROVEOUT_EMBED(name, file)                                                                           \
    __asm__(".section .rodata\n" #name "_begin:\n.incbin \"" file "\"\n" #name                               \
            "_end:\n.byte 0\n.previous\n");                                                                  \
    extern "C" {                                                                                             \
    extern const char name##_begin[];                                                                        \
    extern const char name##_end[];                                                                          \
    }

PROVEOUT_EMBED(proveout_report_css, PROVEOUT_REPORT_PAGE "/report.css")
#ifdef PROVEOUT_THREE
PROVEOUT_EMBED(proveout_three_js, PROVEOUT_THREE "/three.min.js")
PROVEOUT_EMBED(proveout_orbit_js, PROVEOUT_THREE "/examples/js/controls/OrbitControls.js")
PROVEOUT_EMBED(proveout_loader_js, PROVEOUT_THREE "/examples/js/loaders/GLTFLoader.js")
PROVEOUT_EMBED(proveout_viewer_js, PROVEOUT_REPORT_PAGE "/viewer.js")
#define PROVEOUT_SCRIPT(name)                                                                                \
    { name##_begin, name##_end }
#else
#define PROVEOUT_SCRIPT(name)                                                                                \
    {}
#endif

namespace proveout {

std::string_view reportStyle() {
    return {proveout_report_css_begin, proveout_report_css_end};
}
std::string_view threeScript() {
    return PROVEOUT_SCRIPT(proveout_three_js);
}
std::string_view orbitScript() {
    return PROVEOUT_SCRIPT(proveout_orbit_js);
}
std::string_view loaderScript() {
    return PROVEOUT_SCRIPT(proveout_loader_js);
}
std::string_view viewerScript() {
    return PROVEOUT_SCRIPT(proveout_viewer_js);
}

} // namespace proveout
