// SPDX-License-Identifier: Apache-2.0
// Libraries stay loaded in binaries of the sanitizers. The Vulkan loader leaves 128 bytes behind when it has
// looked for drivers, and unloads the library that could tell whose they are: LeakSanitizer then takes them
// for ours.
#include <dlfcn.h>

extern "C" int dlclose(void*) noexcept {
    return 0;
}
