// SPDX-License-Identifier: Apache-2.0
// Libraries stay loaded in binaries of the sanitizers. The Vulkan loader leaves 128 bytes behind when it has
// looked for drivers, and unloads the library that could tell whose they are: LeakSanitizer then takes them
// for ours. What a font library keeps of the fonts that it found is its own, too.
#include <dlfcn.h>

extern "C" int dlclose(void*) noexcept {
    return 0;
}

extern "C" const char* __lsan_default_suppressions() { // NOLINT(bugprone-reserved-identifier): its name
    return "leak:libfontconfig\n";
}
