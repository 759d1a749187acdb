#pragma once
// SPDX-License-Identifier: Apache-2.0
// Lenses that shine at the camera (docs/design/glare.md): discs with the luminance that their candela imply,
// the gobo seen in them, added to the finished frame. Never part of a kept image: images are added, and a
// lens may be brighter than a half float holds. Main thread; the device must outlive it.

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/texture.h"
#include "light/frame_lights.h"
#include "render/geometry/fragments.h"
#include "shared/glare.h"
#include "shared/optics.h"
#include "shared/types.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace ghost::render {

struct LensSettings {
    bool on = true;
    float radius_m = 0.07f; // of lights that do not say
    // The fixture's own body stands around and behind its lens, and in a pass it may look another way.
    float body_m = 0.35f;
    // Fraction of the light that dust and edges of the front glass send everywhere: a lens glows when seen
    // from beside its beam.
    float stray = 0.001f;
};

// How a lens lies in the picture, and what its pixels hold.
struct LensInView {
    shared::Lens lens{};
    glm::ivec2 low{0}, high{0}; // pixels that it may cover, within the picture
    float brightest = 0;        // cd/m^2, at most
};

// False where nothing can be seen of it: dark, turned away, beside its beam, outside the picture.
bool lens_in_view(const scene::LensFace& face, const shared::View& view, const LensSettings& settings,
                  LensInView& seen);

class LensPass {
public:
    LensPass(const gpu::Device& device, const LensSettings& settings);

    // Adds to layer 0 of frame, once a frame, after all lights are summed. faces: all of the show.
    void record(gpu::Commands& commands, const Fragments& fragments, const shared::View& view,
                const std::vector<scene::LensFace>& faces, const gpu::Texture& gobos,
                const gpu::Texture& slides, const gpu::Texture& frame);

    // Of the last record: cd/m^2 that the lenses of a pixel reach at most, together; lenses drawn.
    float brightest() const { return brightest_; }
    int drawn() const { return drawn_; } // lenses of the last record
    std::uint64_t memory_bytes() const { return lenses_.bytes() + list_.bytes(); }

private:
    struct Chunk {
        std::uint32_t beam_class = 0;
        std::uint32_t first_lens = 0;
        std::uint32_t first_block = 0; // in the list
        std::uint32_t blocks = 0;
    };
    void add_chunk(const std::vector<LensInView>& seen, std::uint32_t beam_class, std::uint32_t blocks_x);
    void upload();

    const gpu::Device& device_;
    LensSettings settings_;
    std::array<gpu::LateProgram, shared::kBeamClasses> program_;
    gpu::Buffer lenses_, list_;
    float brightest_ = 0;
    int drawn_ = 0;
    std::vector<shared::Lens> lens_values_; // of this frame
    std::vector<std::uint32_t> list_values_;
    std::vector<Chunk> chunks_;
};

} // namespace ghost::render
