#pragma once
// SPDX-License-Identifier: Apache-2.0
// Private to load_ofl: OflKeys knows every key that a mode may list: channels, their fine bytes, and aliases
// of switching channels; of templates also those with a pixel's name in their middle.

#include "fixture_files/ofl/private/ofl_reader.h"

namespace ghost::fixture {

// A template's key for that pixel.
std::string with_pixel(const std::string& text, const std::string& pixel);

// What a key of a mode's list stands for.
struct OflEntry {
    enum class Kind { coarse, fine, switching };
    Kind kind = Kind::coarse;
    const Json* channel = nullptr; // coarse and fine: the channel; switching: the channel that switches it
    std::string key;               // of the channel, still with $pixelKey
    std::string pointer;
    std::string alias; // switching: as written in switchChannels
};

class OflKeys {
public:
    explicit OflKeys(OflReader& reader);

    struct Found {
        const OflEntry* entry = nullptr;
        std::string pixel; // "": no template
    };
    Found find(const std::string& key) const;

private:
    struct Pattern {
        std::string before;
        std::string after;
        OflEntry entry;
    };

    void add(const std::string& key, OflEntry entry);
    void add_channel(const Json& channel, const std::string& key, const std::string& pointer);

    OflReader& reader_;
    std::map<std::string, OflEntry> plain_;
    std::vector<Pattern> patterns_;
};

} // namespace ghost::fixture
