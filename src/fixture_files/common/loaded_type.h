#pragma once
// SPDX-License-Identifier: Apache-2.0
// LoadedType: what every importer of fixture files gives. Values only.

#include "base/report.h"
#include "fixture/type.h"

#include <vector>

namespace ghost::fixture {

struct LoadedType {
    Type type;
    // At most 1001 (base/message_cap.h); the last one then says how many more there were.
    std::vector<Message> messages;
};

} // namespace ghost::fixture
