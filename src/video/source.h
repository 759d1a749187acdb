#pragma once
// SPDX-License-Identifier: Apache-2.0
// Source: the pictures of one medium at the moments of a show. A worker of its own decodes a few pictures
// ahead of the moment that was asked for last, so asking never waits; while a picture is late the one before
// it stays. A film shows the picture whose time stamp the moment has reached, whatever the times between its
// pictures, so it never drifts from the show. What cannot be shown is said in one sentence, looks like a
// striped card, and is tried again every second: a camera may be pulled out and plugged in again. Asked by
// one thread.

#include "video/picture_queue.h"

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace ghost::video {

class Movie;

enum class SourceKind { file, camera, card };

struct SourceSettings {
    std::string name; // for messages
    SourceKind kind = SourceKind::file;
    std::filesystem::path
        path;           // film, picture or device; a camera's may be a film, which then runs as a camera does
    std::string card;   // test_card.h
    bool loop = true;   // else a film stays at its last picture
    double start_s = 0; // moment of the show at which a film begins
    int side = 512;     // texels
};

class Source {
public:
    explicit Source(SourceSettings settings);
    ~Source();
    Source(const Source&) = delete;
    Source& operator=(const Source&) = delete;

    // The picture for a moment of the show, as far as it is decoded. Null: there was none yet.
    std::shared_ptr<const Picture> at(double show_s);
    // The right one; waits for it, up to so long. For films that are not made live.
    std::shared_ptr<const Picture> wait_for(double show_s, double at_most_s);
    // Sentences that came up since the last call.
    std::vector<std::string> take_messages();
    const SourceSettings& settings() const { return settings_; }

private:
    void run();
    std::string play();
    std::string play_movie();
    std::string follow(Movie& movie);
    std::string play_camera();
    std::string play_file_as_camera();
    void replace(const image::Image8& rgba, bool stand_in);
    void recovered();
    void say(const std::string& sentence);
    double moment(double show_s) const;

    const SourceSettings settings_;
    PictureQueue queue_;
    std::mutex mutex_; // of messages_
    std::vector<std::string> messages_;
    std::string last_said_;
    bool missing_ = false;
    std::thread thread_;
};

} // namespace ghost::video
