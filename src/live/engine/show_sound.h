#pragma once
// SPDX-License-Identifier: Apache-2.0
// ShowSound: the sound of the show that is open ([show] sound), heard in time with its recording, whoever
// moves that: the transport, a loop, time code. It plays while the recording runs at its own speed, and is
// silent while that stands, is searched, or somebody plays it faster. A thread of its own decodes and listens
// to how late the output is; it never waits for others, nor they for it. Seconds of the recording; calls from
// one thread. What is wrong is one sentence.

#include "base/result.h"
#include "show/show.h"

#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace ghost::sound {
class SoundOutput;
} // namespace ghost::sound

namespace ghost::app {

class ShowSound {
public:
    // output: as ALSA has it; empty: nothing is ever heard.
    explicit ShowSound(std::string output) : output_(std::move(output)) {}
    ~ShowSound();
    ShowSound(const ShowSound&) = delete;
    ShowSound& operator=(const ShowSound&) = delete;

    // Of this show from now on; nothing changes where it is the same.
    void use(const scene::Sound& sound);
    // Where the recording stands at this moment; called for every frame while its sound is to be heard.
    void follow(double recording_s, std::chrono::nanoseconds now);
    // Sentences that came up since the last call.
    std::vector<std::string> take_messages();

private:
    struct Place {
        double recording_s = 0;
        std::chrono::nanoseconds at{0};
        bool runs = false;
    };
    void run();
    Result<void> play(sound::SoundOutput& output);
    void end();
    void say(const std::string& sentence);
    std::optional<double> wanted_s(std::chrono::nanoseconds moment) const;

    const std::string output_;
    scene::Sound sound_; // while the thread runs it does not change
    mutable std::mutex mutex_;
    Place place_;
    std::vector<std::string> messages_;
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

} // namespace ghost::app
