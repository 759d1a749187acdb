// SPDX-License-Identifier: Apache-2.0
// A stage that is too large for Embree: whoever wants to trace it hears so, and the program goes on.
#include "support/test_stage.h"

#include "base/memory.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <new>

#include <sys/resource.h>

namespace ghost::bake {
namespace {

constexpr rlim_t kMB = rlim_t{1} << 20;

// Address space from now on: what it has, and so much more.
bool limit_memory(rlim_t more_bytes) {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlim_t most = pages * 4096 + more_bytes;
    const rlimit both{most, most};
    return ::setrlimit(RLIMIT_AS, &both) == 0;
}

// Squares side by side.
scene::Mesh cloth(std::uint32_t side) {
    scene::Mesh mesh;
    for (std::uint32_t k = 0; k < side * side; ++k)
        mesh.positions.emplace_back(static_cast<float>(k % side), static_cast<float>(k / side),
                                    static_cast<float>(k % 7));
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0, 0, 1));
    for (std::uint32_t k = 0; k + side + 1 < side * side; ++k)
        if (k % side + 1 < side)
            mesh.indices.insert(mesh.indices.end(), {k, k + 1, k + side, k + 1, k + side + 1, k + side});
    return mesh;
}

// 0: that there is no more memory is a bad_alloc.
int refused(rlim_t more_bytes) {
    scene::Stage stage;
    place(stage, add_mesh(stage, cloth(1000), add_material(stage, {0.5f, 0.5f, 0.5f})));
    { const Tracer fits(stage); } // its threads are there, and what these keep
    if (!limit_memory(more_bytes)) return 1;
    try {
        const Tracer tracer(stage);
    } catch (const std::bad_alloc&) {
        return 0;
    }
    return 2;
}

TEST(TracerMemory, has_an_end_that_is_told) {
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "a sanitizer reserves more address space than a limit leaves";
#endif
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    for (const rlim_t more_bytes :
         {10 * kMB, 60 * kMB, 100 * kMB}) // vertices are 12 MB, triangles 24, their tree the rest
        EXPECT_EXIT(std::_Exit(refused(more_bytes)), testing::ExitedWithCode(0), "") << more_bytes;
}

} // namespace
} // namespace ghost::bake
