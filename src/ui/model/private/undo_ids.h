#pragma once
// SPDX-License-Identifier: Apache-2.0
// Which steps of the undo list go on with the one before: those of one id that follow each other closely, as
// the changes of a slider do. Milliseconds.

namespace ghost::ui {

inline constexpr int kMergeWithin_ms = 1500;
inline constexpr int kFirstEditId = 1000; // of the show; those of the look (ProgrammerStep) are below

} // namespace ghost::ui
