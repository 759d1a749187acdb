// SPDX-License-Identifier: Apache-2.0
#include "video/source.h"

#include "image/ldr.h"
#include "video/capture_consent.h"
#include "video/files/movie.h"
#include "video/private/camera.h"
#include "video/private/test_card.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

namespace ghost::video {
namespace {

constexpr double kAgain_s = 1.0;   // until a source that failed is tried again
constexpr double kSilent_s = 4.0;  // some cameras take seconds to begin
constexpr double kGlimpse_s = 0.1; // a film that is late shows something this often
constexpr std::size_t kMostMessages = 100;
// A film whose pictures end so much before its stated length is cut short: sound may be longer than pictures.
constexpr double kShortBy = 0.1;
constexpr double kShortBy_s = 0.5;

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool is_still(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    for (char& letter : ending)
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    return ending == ".png" || ending == ".jpg" || ending == ".jpeg";
}

std::string seconds_text(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", seconds);
    return text;
}

std::shared_ptr<const Picture> made(const image::Image8& rgba, int side, double from_s,
                                    bool stand_in = false) {
    static std::atomic<std::uint32_t> numbers{0};
    auto picture = std::make_shared<Picture>();
    picture->pyramid = image::make_pyramid(rgba, side);
    do picture->number = ++numbers;
    while (picture->number == 0);
    picture->from_s = from_s;
    picture->stand_in = stand_in;
    return picture;
}

} // namespace

Source::Source(SourceSettings settings) : settings_(std::move(settings)) {
    (void)at(0);
    thread_ = std::thread([this] { run(); });
}

Source::~Source() {
    queue_.stop();
    thread_.join();
}

// Before its start a film stands at its beginning.
double Source::moment(double show_s) const {
    return std::max(show_s, settings_.start_s);
}

std::shared_ptr<const Picture> Source::at(double show_s) {
    return queue_.at(moment(show_s));
}

std::shared_ptr<const Picture> Source::wait_for(double show_s, double at_most_s) {
    return queue_.wait_for(moment(show_s), at_most_s);
}

std::vector<std::string> Source::take_messages() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(messages_, {});
}

void Source::say(const std::string& sentence) {
    const std::scoped_lock lock(mutex_);
    if (sentence == last_said_ || messages_.size() >= kMostMessages) return;
    last_said_ = sentence;
    messages_.push_back("[[media]] '" + settings_.name + "': " + sentence);
}

void Source::run() {
    while (!queue_.stopped()) {
        const std::string problem = play();
        if (queue_.stopped()) return;
        say(problem + "; a striped card is shown until it can be read");
        if (!std::exchange(missing_, true)) replace(missing_card(), true);
        queue_.sleep(kAgain_s);
    }
}

void Source::recovered() {
    if (std::exchange(missing_, false)) say(settings_.path.string() + ": is there again");
}

void Source::replace(const image::Image8& rgba, bool stand_in) {
    queue_.replace(made(rgba, settings_.side, -kForever, stand_in));
}

// Runs until it is stopped, or says why it cannot.
std::string Source::play() {
    if (settings_.kind == SourceKind::camera) return play_camera();
    if (settings_.kind == SourceKind::file && !is_still(settings_.path)) return play_movie();
    image::Image8 picture;
    if (settings_.kind == SourceKind::card) {
        picture = test_card(settings_.card);
    } else {
        std::string damage;
        auto read = image::read_ldr(settings_.path, &damage);
        if (!read.ok()) return read.error().text();
        if (!damage.empty()) say(settings_.path.string() + ": " + damage);
        picture = std::move(*read);
    }
    recovered();
    replace(picture, false);
    while (queue_.sleep(kAgain_s)) {
    }
    return {};
}

std::string Source::play_movie() {
    auto movie = Movie::open(settings_.path);
    if (!movie.ok()) return movie.error().text();
    return follow(**movie);
}

std::string Source::follow(Movie& movie) {
    const glm::ivec2 size = image::fitted(movie.width(), movie.height(), settings_.side);
    const double length_s = movie.duration_s();
    double base_s = settings_.start_s; // moment of the show at which this round of the film begins
    double skipped_s = kForever;       // a picture that was not converted, for a later one may be due
    double converted_s = -kForever;    // by our clock
    bool any = false;
    const auto convert = [&](Movie::Which which, double from_s, double known_to_s, bool after_gap) {
        auto picture = movie.picture(which, size.x, size.y);
        if (!picture.ok()) {
            say(picture.error().text());
            return;
        }
        recovered();
        queue_.put(made(*picture, settings_.side, from_s), known_to_s, after_gap);
        converted_s = now_s();
        any = true;
    };
    const auto say_cut = [&] {
        say(settings_.path.string() + ": is cut short; of its " + seconds_text(length_s) +
            " s it shows what is there, then its last picture until it begins again");
    };
    if (movie.is_cut_short()) say_cut();
    if (movie.drops_alpha())
        say(settings_.path.string() +
            ": has an alpha channel, which this FFmpeg cannot decode without libvpx; it is opaque");
    queue_.begin_search(kForever); // nothing is here: the first need is a search
    for (bool first = true;;) {
        const PictureQueue::Need need = queue_.wait_for_need();
        if (need == PictureQueue::Need::stop) return {};
        if (need == PictureQueue::Need::search || first) {
            const double wanted_s = std::max(queue_.wanted_s(), settings_.start_s);
            const double since_s = wanted_s - settings_.start_s;
            const double round = settings_.loop ? std::floor(since_s / length_s) : 0.0;
            base_s = settings_.start_s + round * length_s;
            if (auto sought = movie.seek(std::min(wanted_s - base_s, length_s)); !sought.ok())
                return sought.error().text();
            queue_.begin_search(wanted_s);
            skipped_s = kForever;
            first = false;
            continue;
        }
        const auto next = movie.next();
        if (!next.ok()) return next.error().text();
        const double at_s = next->value_or(length_s);
        if (next->has_value() && settings_.loop && at_s >= length_s)
            continue; // beyond the end that the film states
        const double from_s = base_s + at_s;
        if (next->has_value() && from_s <= queue_.wanted_s()) {
            // The next one may be due already, and then this one was for nothing.
            const bool glimpse = now_s() - converted_s > kGlimpse_s;
            if (glimpse) convert(Movie::Which::newest, from_s, from_s, true);
            skipped_s = glimpse ? kForever : from_s;
            continue;
        }
        if (skipped_s < kForever) {
            const double shown_s = std::exchange(skipped_s, kForever);
            // Who waits for the end shall find what is to be said of it as well: it is known after that.
            if (next->has_value())
                convert(Movie::Which::before, shown_s, from_s, true);
            else
                convert(Movie::Which::newest, shown_s, shown_s, true);
        }
        if (next->has_value()) {
            convert(Movie::Which::newest, from_s, from_s, false);
            continue;
        }
        if (!any) return settings_.path.string() + ": no picture in it can be decoded";
        if (movie.damaged() > 0 && !movie.is_cut_short())
            say(settings_.path.string() + ": is damaged or cut short; what can be decoded is shown");
        else if (movie.read_to_s() + std::max(kShortBy * length_s, kShortBy_s) < length_s)
            say_cut();
        queue_.know_to(settings_.loop ? from_s : kForever);
        if (!settings_.loop) continue;
        base_s += length_s;
        if (auto sought = movie.seek(0); !sought.ok()) return sought.error().text();
    }
}

std::string Source::play_camera() {
    std::error_code code;
    if (!std::filesystem::exists(settings_.path, code))
        return settings_.path.string() + ": there is no such camera, nor a film in its place";
    if (std::filesystem::is_regular_file(settings_.path, code)) return play_file_as_camera();
    if (!may_capture(settings_.path))
        return settings_.path.string() +
               ": nobody has allowed on this machine that shows open it; `ghostlight capture " +
               settings_.path.string() + "` does";
    auto camera = Camera::open(settings_.path);
    if (!camera.ok()) return camera.error().text();
    double seen_s = now_s();
    while (!queue_.stopped()) {
        auto picture = (*camera)->next();
        if (!picture.ok()) return picture.error().text();
        if (!*picture && now_s() - seen_s > kSilent_s) return (*camera)->silence().text();
        if (!*picture) continue;
        seen_s = now_s();
        recovered();
        replace(**picture, false);
    }
    return {};
}

// At the pace of its time stamps; its end is that of a camera that is pulled out.
std::string Source::play_file_as_camera() {
    auto movie = Movie::open(settings_.path);
    if (!movie.ok()) return movie.error().text();
    const glm::ivec2 size = image::fitted((*movie)->width(), (*movie)->height(), settings_.side);
    const double begin_s = now_s();
    for (bool any = false;; any = true) {
        const auto next = (*movie)->next();
        if (!next.ok()) return next.error().text();
        if (!next->has_value())
            return settings_.path.string() +
                   (any ? ": its pictures have ended" : ": no picture in it can be decoded");
        if (!queue_.sleep(begin_s + **next - now_s())) return {};
        auto picture = (*movie)->picture(Movie::Which::newest, size.x, size.y);
        if (!picture.ok()) return picture.error().text();
        recovered();
        replace(*picture, false);
    }
}

} // namespace ghost::video
