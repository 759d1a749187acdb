#pragma once
// SPDX-License-Identifier: Apache-2.0
// For threads whose work may wait.

namespace ghost {

// The calling thread gets what processor time others leave (nice 19). Where the system does not do so,
// nothing happens.
void give_way();

} // namespace ghost
