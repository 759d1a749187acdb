// SPDX-License-Identifier: Apache-2.0
#include "ui/language/private/sentence_list.h"

#include <QtGlobal>
namespace ghost::ui {
std::span<const char* const> sentence_list() {
    static constexpr const char* kSentences[] = {QT_TRANSLATE_NOOP("Sentence", "no show is open")};
    return kSentences;
}
} // namespace ghost::ui
