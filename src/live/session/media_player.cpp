// SPDX-License-Identifier: Apache-2.0
#include "live/session/media_player.h"

#include "image/colour.h"
#include "image/pyramid.h"
#include "show/show.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <system_error>

namespace ghost::app {
namespace {

constexpr double kPatience_s = 10; // for a picture that a film needs
constexpr int kCheckedSide = 16;   // texels of a picture that nobody looks at

video::SourceSettings settings_of(const scene::Media& media, int side) {
    video::SourceSettings settings;
    settings.name = media.name;
    settings.kind = media.kind == scene::MediaKind::camera ? video::SourceKind::camera
                    : media.kind == scene::MediaKind::card ? video::SourceKind::card
                                                           : video::SourceKind::file;
    settings.path = media.file;
    settings.card = media.card;
    settings.loop = media.loop;
    settings.start_s = media.start_s;
    settings.side = side;
    return settings;
}

void put(const image::Pyramid& pyramid, std::uint32_t number, std::size_t k, scene::GoboStack& stack) {
    stack.images.slides[k] = {pyramid.side, pyramid.levels};
    stack.showing[k] = {number, pyramid.extent, image::rec709_to_rec2020(pyramid.mean), pyramid.side};
}

} // namespace

MediaPlayer::MediaPlayer(const scene::Show& show, scene::GoboStack& stack) {
    image::Image8 black(16, 9, 4);
    for (std::size_t k = 3; k < black.samples.size(); k += 4) black.samples[k] = 255;
    const image::Pyramid nothing = image::make_pyramid(black, show.media_side);
    stack.images.slides.resize(show.media.size());
    stack.showing.resize(show.media.size());
    for (std::size_t k = 0; k < show.media.size(); ++k) {
        put(nothing, 0, k, stack);
        sources_.push_back(std::make_unique<video::Source>(settings_of(show.media[k], show.media_side)));
        where_.push_back(show.media[k].where);
    }
}

void MediaPlayer::show(double time_s, bool waits, scene::GoboStack& stack, Report& report) {
    oldest_due_s_ = time_s;
    for (std::size_t k = 0; k < sources_.size(); ++k) {
        const auto picture = waits ? sources_[k]->wait_for(time_s, kPatience_s) : sources_[k]->at(time_s);
        if (picture && picture->number != stack.showing[k].moment)
            put(picture->pyramid, picture->number, k, stack);
        if (picture && std::isfinite(picture->from_s))
            oldest_due_s_ = std::min(oldest_due_s_, picture->from_s);
        for (const std::string& sentence : sources_[k]->take_messages())
            report.add(Severity::warning, where_[k], sentence);
    }
}

void check_media(const scene::Show& show, Report& report) {
    for (const scene::Media& media : show.media) {
        // What is not there is said by the loader, and a device may be busy with others' pictures.
        if (std::error_code code; !std::filesystem::is_regular_file(media.file, code)) continue;
        video::Source source(settings_of(media, kCheckedSide));
        source.wait_for(media.start_s, kPatience_s);
        for (const std::string& sentence : source.take_messages())
            report.add(Severity::error, media.where, sentence);
    }
}

} // namespace ghost::app
