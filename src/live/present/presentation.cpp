// SPDX-License-Identifier: Apache-2.0
#include "live/present/presentation.h"

#include "base/log.h"
#include "link/picture_place.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <utility>

namespace ghost::app {
namespace {

constexpr double kClearly = 0.8;      // of the window's time
constexpr int kMostLostSurfaces = 20; // in one window: a display that loses each one must end
constexpr std::size_t kMeasured = 5;
constexpr int kTries = 50; // until an image of the surface is free

double ms_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

std::string ms_text(double ms) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", ms);
    return text;
}

// A name of formats, the same in every language.
std::string encoding_words(render::Encoding encoding) {
    return encoding == render::Encoding::pq ? "HDR10" : encoding == render::Encoding::scrgb ? "scRGB" : "";
}

} // namespace

bool is_device_faster(double device_ms, double window_ms, bool is_processor) {
    return device_ms < (is_processor ? kClearly : 1.0) * window_ms;
}

Presentation::Presentation(ui::Link& link, const PresentationOptions& options)
    : link_(link), options_(options) {}

Presentation::~Presentation() {
    end();
}

void Presentation::Screens::let_go(std::uint64_t number) {
    const std::lock_guard lock(mutex);
    gone.insert(number);
    // The rest of it belongs to the engine's thread.
    if (const auto found = all.find(number); found != all.end()) found->second.screen->let_go();
}

void Presentation::begin(const gpu::Device& device) {
    end();
    if (decided_ == false) return;
    if (!device.instance_of_surfaces()) {
        if (wants_device()) decide(false, "shown by the window: the graphics device has no displays");
        return;
    }
    device_ = &device;
    pass_ = std::make_unique<render::PresentPass>(device);
    commands_ = std::make_unique<gpu::Commands>(device);
    heard_ = has_offered_ = false; // that was of the device before
}

// Where it is measured a window has to wait for that, and it waits for no picture.
void Presentation::offer(bool is_quick) {
    if (!device_ || has_offered_) return;
    const bool is_measured = options_.shower == ui::Shower::measured && !decided_;
    if (is_measured && !is_quick) return;
    has_offered_ = true;
    const std::shared_ptr<gpu::Instance> instance = device_->instance_of_surfaces();
    ui::SurfaceOffer made;
    // Its address is that of the handle, which is all that a window asks for.
    made.instance = std::shared_ptr<void>(instance, instance->handle());
    made.let_go = [screens = screens_](std::uint64_t number) { screens->let_go(number); };
    made.is_measured = is_measured;
    link_.surface_offer.put(std::move(made));
    link_.on_news();
}

void Presentation::end() {
    {
        const std::lock_guard lock(screens_->mutex);
        screens_->all.clear();
    }
    if (std::exchange(is_busy_, false)) {
        try {
            commands_->wait();
        } catch (const std::exception& lost) {
            log_debug(lost.what());
        }
    }
    picture_ = {};
    size_ = glm::ivec2(0);
    commands_.reset();
    pass_.reset();
    device_ = nullptr;
}

void Presentation::listen() {
    if (auto news = link_.surfaces.take()) {
        surfaces_ = std::move(*news);
        heard_ = false;
    }
    if (!device_ || std::exchange(heard_, true)) return;
    const std::lock_guard lock(screens_->mutex);
    auto& all = screens_->all;
    for (auto one = all.begin(); one != all.end();) {
        const bool stays = std::any_of(surfaces_.begin(), surfaces_.end(), [&](const ui::Surface& surface) {
            return surface.number == one->first && !screens_->gone.contains(surface.number);
        });
        one = stays ? std::next(one) : all.erase(one);
    }
    for (const ui::Surface& surface : surfaces_) {
        if (screens_->gone.contains(surface.number)) continue;
        Shown& shown = all[surface.number];
        if (!shown.screen) {
            VkSurfaceKHR handle = VK_NULL_HANDLE;
            static_assert(sizeof handle == sizeof surface.handle);
            std::memcpy(&handle, &surface.handle, sizeof handle);
            shown.screen = std::make_unique<render::Screen>(*device_, *pass_, handle, options_.hdr);
        }
        shown.surface = surface;
        shown.is_new = true;
    }
}

// What screens still show of it is done, where the next one is written by this processor.
void Presentation::wait_for_screens() {
    const std::lock_guard lock(screens_->mutex);
    for (auto& [number, shown] : screens_->all) shown.screen->wait();
}

gpu::Texture& Presentation::texture_for(int width, int height, VkFormat format) {
    if (std::exchange(is_busy_, false)) commands_->wait();
    const auto wide = static_cast<std::uint32_t>(width), high = static_cast<std::uint32_t>(height);
    const bool fits = picture_.bytes() > 0 && picture_.shape().width == wide &&
                      picture_.shape().height == high && picture_.shape().format == format;
    if (!fits || device_->is_cpu()) wait_for_screens();
    if (!fits) picture_ = gpu::Texture(*device_, {wide, high, 1, 1, format, true, true});
    return picture_;
}

bool Presentation::wants_light() const {
    const std::lock_guard lock(screens_->mutex);
    return std::any_of(screens_->all.begin(), screens_->all.end(), [](const auto& one) {
        return one.second.screen->encoding() != render::Encoding::srgb;
    });
}

bool Presentation::wants_again() const {
    return device_ && is_of_device_ && options_.hdr && wants_light() != is_light_;
}

void Presentation::mark_new(const glm::ivec2& size, const ui::Framed& framed) {
    size_ = size;
    framed_ = framed;
    const std::lock_guard lock(screens_->mutex);
    for (auto& [number, shown] : screens_->all) shown.is_new = true;
}

void Presentation::take(render::Relighter& relighter, const ui::Framed& framed) {
    if (!device_ || decided_ == false) return;
    is_of_device_ = true;
    is_light_ = options_.hdr && wants_light();
    gpu::Texture& to = texture_for(relighter.width(), relighter.height(),
                                   is_light_ ? VK_FORMAT_R16G16B16A16_SFLOAT : VK_FORMAT_R8G8B8A8_UNORM);
    commands_->begin();
    if (is_light_)
        relighter.put_light(*commands_, to, shared::kPeak_cd_m2 / shared::kWhite_cd_m2);
    else
        relighter.put_picture(*commands_, to);
    commands_->submit();
    is_busy_ = true;
    mark_new({relighter.width(), relighter.height()}, framed);
}

void Presentation::take(const image::Image8& picture, const ui::Framed& framed) {
    if (!device_ || decided_ == false || picture.channels != 4) return;
    is_light_ = is_of_device_ = false;
    gpu::Texture& to = texture_for(picture.width, picture.height, VK_FORMAT_R8G8B8A8_UNORM);
    to.write(0, picture.samples.data(), picture.samples.size());
    mark_new({picture.width, picture.height}, framed);
}

void Presentation::show() {
    if (!device_ || decided_ == false) return;
    std::vector<std::uint64_t> lost;
    {
        const std::lock_guard lock(screens_->mutex);
        for (auto& [number, shown] : screens_->all) {
            if (!shown.is_new || screens_->gone.contains(number)) continue;
            if (!decided_ && options_.shower == ui::Shower::measured) {
                if (size_.x > 0 && shown.surface.covers) measure(shown);
                if (decided_ == false) break;
            } else if (!show_on(shown)) {
                lost.push_back(number);
            }
            if (decided_ == false) break;
        }
        for (const std::uint64_t number : lost) {
            screens_->all.erase(number);
            screens_->gone.insert(number);
        }
    }
    for (const std::uint64_t number : lost) {
        if (++losses_ > kMostLostSurfaces) {
            decide(false, "shown by the window: the display lost its surface too often");
            break;
        }
        log_info("the display lost the surface of the picture; it is made anew");
        publish(number);
    }
    if (decided_ == false) end(); // of what windows still have nothing is used
}

// False: its surface is lost.
bool Presentation::show_on(Shown& shown) {
    const ui::Surface& surface = shown.surface;
    const ui::Rect place = ui::place_of_picture(surface.size.x, surface.size.y, size_, framed_);
    const render::ScreenPicture picture{size_.x > 0 ? &picture_ : nullptr, is_light_};
    switch (shown.screen->show(
        picture, {place.x, place.y, place.width, place.height},
        {static_cast<std::uint32_t>(surface.size.x), static_cast<std::uint32_t>(surface.size.y)},
        surface.covers)) {
    case render::Screen::Shown::yes:
        shown.is_new = false;
        format_ = encoding_words(shown.screen->encoding());
        if (!decided_) decide(true, "shown by the graphics device, as it was asked for");
        break;
    case render::Screen::Shown::later:
        break;
    case render::Screen::Shown::lost:
        return false;
    case render::Screen::Shown::never:
        decide(false, "shown by the window: " + shown.screen->why_never());
        break;
    }
    return true;
}

// The real picture on the real surface, some times.
void Presentation::measure(Shown& shown) {
    std::vector<double> took_ms;
    for (int tries = 0; tries < kTries && took_ms.size() < kMeasured && decided_ != false; ++tries) {
        const auto begin = std::chrono::steady_clock::now();
        shown.is_new = true;
        decided_ = true; // else it would be decided by the first one
        const bool is_there = show_on(shown);
        if (decided_ == true) decided_.reset();
        if (!is_there) return;
        if (shown.is_new) continue;
        shown.screen->wait();
        took_ms.push_back(ms_since(begin));
    }
    if (decided_ == false || took_ms.size() < kMeasured) return; // once more with the next picture
    std::sort(took_ms.begin(), took_ms.end());
    const double device_ms = took_ms[took_ms.size() / 2] + shown.surface.paint_covers_ms;
    const double window_ms = read_ms_ + shown.surface.paint_ms;
    const bool is_device = is_device_faster(device_ms, window_ms, device_->is_cpu());
    log_debug("a picture is shown in " + ms_text(device_ms) + " ms by the graphics device, in " +
              ms_text(window_ms) + " ms by the window");
    if (is_device)
        decide(true, "shown by the graphics device in " + ms_text(device_ms) + " ms, by the window it took " +
                         ms_text(window_ms) + " ms");
    else
        decide(false, "shown by the window in " + ms_text(window_ms) +
                          " ms, by the graphics device it took " + ms_text(device_ms) + " ms");
}

void Presentation::decide(bool is_device, std::string words) {
    decided_ = is_device;
    words_ = std::move(words);
    publish(0);
}

void Presentation::publish(std::uint64_t lost) {
    link_.shower.put({decided_.value_or(false), decided_.has_value(), lost, words_, format_},
                     [](const ui::ShowerNow& unread, ui::ShowerNow& next) {
                         if (next.lost == 0) next.lost = unread.lost;
                     });
    link_.on_news();
}

} // namespace ghost::app
