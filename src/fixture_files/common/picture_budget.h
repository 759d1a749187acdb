#pragma once
// SPDX-License-Identifier: Apache-2.0
// PictureBudget: what the gobos of all fixture files of a show, or of a plot, may need in memory. A file of a
// MB may have 384 of them, and a show has thousands of files. One thread.

#include "base/report.h"
#include "fixture/type.h"

#include <cstdint>
#include <string>

namespace ghost::fixture {

inline constexpr std::uint64_t kMostTypePictures = std::uint64_t{4} << 30; // bytes, decoded

class PictureBudget {
public:
    explicit PictureBudget(std::uint64_t bytes = kMostTypePictures) : left_(bytes) {}

    // The pictures of a type that was just read; where they do not fit its slots stay open. Said once.
    void take(Type& type, const std::string& where, Report& report) {
        std::uint64_t bytes = 0;
        for (const Media& media : type.media) bytes += media.rgba.size();
        if (bytes <= left_) {
            left_ -= bytes;
            return;
        }
        for (Media& media : type.media) media.rgba = {};
        if (is_said_) return;
        is_said_ = true;
        report.add(
            Severity::error, where,
            "its gobos stay open, and perhaps those of other files: with it the pictures of all fixture "
            "files need more than " +
                std::to_string(kMostTypePictures >> 30) + " GiB");
    }

private:
    std::uint64_t left_;
    bool is_said_ = false;
};

} // namespace ghost::fixture
