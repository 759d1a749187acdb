#pragma once
// SPDX-License-Identifier: Apache-2.0
// Moving pictures of a show: what [[media]] says, and what each of them shows now. The pictures themselves
// are decoded elsewhere (video/source.h). Values only. docs/design/projectors.md.

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>

namespace ghost::scene {

enum class MediaKind {
    file,   // a movie, or a picture that stays
    camera, // a video device, or a file that stands for one
    card,   // a test card
};

struct Media {
    std::string name;
    MediaKind kind = MediaKind::file;
    std::filesystem::path file; // or the device
    std::string card = "grid";
    bool loop = true;
    double start_s = 0; // time of the show at which it starts; before, it stands at its beginning
    std::string where;  // file:line, for messages
};

inline constexpr std::size_t kMaxMedia = 64;
inline constexpr int kMediaSide = 512; // texels of a picture's longer side, unless the show says otherwise

// What a medium shows now, without its texels.
struct MediaNow {
    std::uint32_t moment = 0; // number of the picture; never the same for two that differ
    glm::vec2 extent{1.0f};   // image::Pyramid
    glm::vec3 mean{0.0f};     // linear Rec.2020
    int side = kMediaSide;
};

} // namespace ghost::scene
