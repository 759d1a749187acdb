#pragma once
// SPDX-License-Identifier: Apache-2.0
// Screen: a surface of a window that a device shows pictures on: the swapchain, what lies over the picture,
// and the step that puts both together (shaders/present/present.comp). It never waits for the display: where
// no image is free the picture is shown at the next try. The thread that has the queue; the device, and the
// surface until let_go(), must outlive it.

#include "gpu/commands.h"
#include "gpu/texture.h"
#include "image/image.h"
#include "render/present/surface_choice.h"
#include "shared/present.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ghost::render {

// Pixels of the surface.
struct PicturePlace {
    double x = 0, y = 0, width = 0, height = 0;
};

// A picture on a device: sRGB of 8 bits, or light that goes on above white (shared/present.h).
struct ScreenPicture {
    const gpu::Texture* texture = nullptr; // sampled linearly; null: there is none, all is black
    bool is_light = false;
};

// How the picture and what lies over it are put together.
class PresentPass {
public:
    explicit PresentPass(const gpu::Device& device);
    // covers: as large as the surface; null: nothing does. Waits for nothing.
    void record(gpu::Commands& commands, const ScreenPicture& picture, const PicturePlace& place,
                const gpu::Texture* covers, const SurfaceFormat& format, const gpu::Texture& to) const;

private:
    gpu::Program program_;
    gpu::Texture nothing_;
};

class Screen {
public:
    enum class Shown {
        yes,
        later, // no image is free, or the surface has no size: once more
        lost,  // the surface has to be made anew
        never, // the device, or this program, cannot show anything there
    };

    Screen(const gpu::Device& device, const PresentPass& pass, VkSurfaceKHR surface, bool hdr);
    ~Screen();
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    // wanted: pixels of the window, which may be ahead of its surface. covers: BGRA, premultiplied, and shown
    // where it is as large as the surface.
    Shown show(const ScreenPicture& picture, const PicturePlace& place, VkExtent2D wanted,
               const std::shared_ptr<const image::Image8>& covers);
    // All that was given to the device is done. Also in the middle of a loss of the device.
    void wait();
    // The surface goes: nothing uses it any more. Any thread that keeps the others off.
    void let_go();
    // Of what is shown now.
    Encoding encoding() const { return format_ ? format_->encoding : Encoding::srgb; }
    VkExtent2D extent() const { return extent_; }
    const std::string& why_never() const { return why_never_; }

private:
    struct Slot {
        explicit Slot(const gpu::Device& device);
        ~Slot();
        Slot(const Slot&) = delete;
        Slot& operator=(const Slot&) = delete;
        const gpu::Device& device;
        gpu::Commands commands;
        VkSemaphore free = VK_NULL_HANDLE; // its image may be drawn to
        bool is_busy = false;
    };

    // False: shown_ says why not.
    bool make(VkExtent2D wanted);
    bool find_format();
    void destroy_swapchain();
    void take_covers(const std::shared_ptr<const image::Image8>& covers);
    Shown present(Slot& slot, std::uint32_t image, const ScreenPicture& picture, const PicturePlace& place);
    void copy_to(gpu::Commands& commands, VkImage image) const;
    VkSurfaceCapabilitiesKHR capabilities();

    const gpu::Device& device_;
    const PresentPass& pass_;
    VkSurfaceKHR surface_;
    bool hdr_;
    std::optional<SurfaceFormat> format_;
    std::string why_never_;
    VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
    VkExtent2D extent_{}, made_for_{};
    std::vector<VkImage> images_;
    std::vector<VkSemaphore> drawn_; // of each image: it may be shown
    std::array<std::unique_ptr<Slot>, 2> slots_;
    std::size_t next_ = 0;
    bool is_lost_ = false;
    gpu::Texture all_; // picture and overlay, as the surface has them
    gpu::Texture covers_;
    std::shared_ptr<const image::Image8> covers_of_; // that covers_ has
};

} // namespace ghost::render
