#pragma once
// SPDX-License-Identifier: Apache-2.0
// Explanations for people and for programs: the same facts twice. Units as in explain.h; keys of the JSON:
// docs/guide/user-guide.md. Names of the network and of files are made fit for a terminal. Pure.

#include "diagnose/explain.h"

#include <string>
#include <vector>

namespace ghost::scene {

// Some twenty lines, the verdict first.
std::string words_of(const Explanation& explanation, const Reception& reception);

// One line: "Spot 1: dark because ...".
std::string line_of(const Explanation& explanation);

// One object; of several fixtures one with a summary and the list.
std::string json_of(const Explanation& explanation, const Reception& reception);
std::string json_of(const std::vector<Explanation>& explanations, const Reception& reception);

} // namespace ghost::scene
