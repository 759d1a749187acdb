#pragma once
// SPDX-License-Identifier: Apache-2.0
// Presentation: the pictures of the engine on the surfaces of its windows. It offers that to the windows,
// measures the first time whether the device or the window is faster, shows what is new, and says what
// becomes of it. Never waits for the display. Engine thread, but for what windows call.

#include "gpu/device.h"
#include "image/image.h"
#include "link/link.h"
#include "render/present/screen.h"
#include "render/relight/relighter.h"

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace ghost::app {

struct PresentationOptions {
    ui::Shower shower = ui::Shower::window;
    bool hdr = false; // HDR10 or scRGB, where the display has it
};

// Whether the device shows pictures from now on. is_processor: it draws on the cores that everything else
// runs on, and has to be clearly faster.
bool is_device_faster(double device_ms, double window_ms, bool is_processor);

class Presentation {
public:
    Presentation(ui::Link& link, const PresentationOptions& options);
    ~Presentation();
    Presentation(const Presentation&) = delete;
    Presentation& operator=(const Presentation&) = delete;

    // Whether a device should be able to show pictures at all.
    bool wants_device() const { return options_.shower != ui::Shower::window; }
    // Another device draws from now on; it stays until end().
    void begin(const gpu::Device& device);
    void end();
    // Windows hear of it. is_quick: what they then have for it is shown at once.
    void offer(bool is_quick);

    // What windows have new for it.
    void listen();
    // Another picture.
    void take(render::Relighter& relighter, const ui::Framed& framed);
    // Likewise, one that was not made on the device.
    void take(const image::Image8& picture, const ui::Framed& framed);
    // What it took until the window had the last picture, for it to paint.
    void note_read_ms(double read_ms) { read_ms_ = read_ms; }
    // The display turned out to show more than white, and the picture ends there.
    bool wants_again() const;
    // Whatever is new and was not shown yet.
    void show();

    // Pictures need not be read back.
    bool is_by_device() const { return decided_ && *decided_ && !screens_->all.empty(); }
    const std::string& words() const { return words_; }

private:
    struct Shown {
        std::unique_ptr<render::Screen> screen;
        ui::Surface surface;
        bool is_new = true; // there is something that it does not show
    };
    // What windows reach, too.
    struct Screens {
        std::mutex mutex;
        std::map<std::uint64_t, Shown> all;
        std::set<std::uint64_t> gone; // that windows took away
        void let_go(std::uint64_t number);
    };

    gpu::Texture& texture_for(int width, int height, VkFormat format);
    bool wants_light() const;
    void mark_new(const glm::ivec2& size, const ui::Framed& framed);
    bool show_on(Shown& shown);
    void measure(Shown& shown);
    void decide(bool is_device, std::string words);
    void publish(std::uint64_t lost);
    void wait_for_screens();

    ui::Link& link_;
    PresentationOptions options_;
    const gpu::Device* device_ = nullptr;
    std::shared_ptr<Screens> screens_ = std::make_shared<Screens>();
    std::vector<ui::Surface> surfaces_; // as windows said them last
    bool heard_ = true;                 // and screens_ has them
    bool has_offered_ = false;
    std::unique_ptr<render::PresentPass> pass_;
    std::unique_ptr<gpu::Commands> commands_; // by which a picture comes here
    bool is_busy_ = false;                    // these
    gpu::Texture picture_;
    bool is_light_ = false, is_of_device_ = false;
    glm::ivec2 size_{0}; // of the picture; 0: there is none
    ui::Framed framed_;
    double read_ms_ = 0;
    std::optional<bool> decided_; // the device shows them
    int losses_ = 0;
    std::string words_, format_;
};

} // namespace ghost::app
