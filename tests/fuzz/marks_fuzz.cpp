// SPDX-License-Identifier: Apache-2.0
// A CSV file of marks from anybody: what is kept is in the order of time, and each line is kept or named.
#include "base/check.h"
#include "book/marks.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    for (const double frames_per_s : {0.0, 25.0}) {
        ghost::Report report;
        double before_s = 0;
        for (const ghost::scene::Mark& mark : ghost::scene::read_marks(
                 {reinterpret_cast<const char*>(data), size}, "fuzz", frames_per_s, report)) {
            CHECK(std::isfinite(mark.at_s) && mark.at_s >= before_s);
            before_s = mark.at_s;
        }
    }
    return 0;
}
