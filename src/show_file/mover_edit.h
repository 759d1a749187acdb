#pragma once
// SPDX-License-Identifier: Apache-2.0
// Edits of the [[mover]] entries of show.toml: a truss on hoists, and the channels of a mover's axes. Text
// in, text out; errors: it is written in a way that cannot be edited, or there is no such mover. Any thread.

#include "base/result.h"
#include "show/movers.h"

#include <string>
#include <vector>

namespace ghost::scene {

// Its name, kind, load and axes; what an axis does not say is left out.
Result<std::string> add_mover(const std::string& text, const Mover& mover);

// The first channel of its first axis; those of the others follow it. bits: 8, 16 or 24. Error: they go past
// the end of the universe.
Result<std::string> set_mover_address(const std::string& text, const Mover& mover,
                                      const fixture::Address& first, int bits);

// These fixtures, by name, go with the mover of that name, "": with none, and no longer with another one that
// names them; what its patterns fit goes with it still.
Result<std::string> hang_on_mover(const std::string& text, const std::string& name,
                                  const std::vector<std::string>& fixtures);

} // namespace ghost::scene
