// SPDX-License-Identifier: Apache-2.0
#include "fixture_files/ofl/private/ofl_keys.h"

namespace ghost::fixture {
namespace {

constexpr std::size_t kMaxTemplates = 512;
constexpr std::string_view kPixel = "$pixelKey";

} // namespace

std::string with_pixel(const std::string& text, const std::string& pixel) {
    const std::size_t at = text.find(kPixel);
    return at == std::string::npos ? text : text.substr(0, at) + pixel + text.substr(at + kPixel.size());
}

OflKeys::OflKeys(OflReader& reader) : reader_(reader) {
    for (const char* list : {"availableChannels", "templateChannels"}) {
        const Json& channels = member(reader.document, list);
        if (!channels.is_object()) continue;
        for (const auto& [key, channel] : channels.items())
            add_channel(channel, key, "/" + std::string(list) + "/" + escaped(key));
    }
}

OflKeys::Found OflKeys::find(const std::string& key) const {
    if (const auto known = plain_.find(key); known != plain_.end()) return {&known->second, ""};
    for (const Pattern& pattern : patterns_) {
        if (key.size() < pattern.before.size() + pattern.after.size() || !key.starts_with(pattern.before) ||
            !key.ends_with(pattern.after))
            continue;
        std::string pixel =
            key.substr(pattern.before.size(), key.size() - pattern.before.size() - pattern.after.size());
        if (!pixels_of(reader_.matrix, pixel).empty()) return {&pattern.entry, std::move(pixel)};
    }
    return {};
}

void OflKeys::add(const std::string& key, OflEntry entry) {
    const std::size_t at = key.find(kPixel);
    if (at == std::string::npos) {
        plain_.emplace(key, std::move(entry));
        return;
    }
    if (patterns_.size() == kMaxTemplates) {
        reader_.say(Severity::error, entry.pointer, "more than 512 template channels and aliases");
        return;
    }
    patterns_.push_back({key.substr(0, at), key.substr(at + kPixel.size()), std::move(entry)});
}

void OflKeys::add_channel(const Json& channel, const std::string& key, const std::string& pointer) {
    add(key, {OflEntry::Kind::coarse, &channel, key, pointer, ""});
    const Json& fine = member(channel, "fineChannelAliases");
    for (std::size_t i = 0; fine.is_array() && i < fine.size() && i < 3; ++i)
        if (fine[i].is_string())
            add(fine[i].get_ref<const std::string&>(), {OflEntry::Kind::fine, &channel, key, pointer, ""});
    const Json& capabilities = member(channel, "capabilities");
    std::set<std::string> aliases;
    for (std::size_t i = 0; capabilities.is_array() && i < capabilities.size(); ++i) {
        const Json& switches = member(capabilities[i], "switchChannels");
        if (!switches.is_object()) continue;
        for (const auto& [alias, target] : switches.items())
            if (aliases.insert(alias).second)
                add(alias, {OflEntry::Kind::switching, &channel, key, pointer, alias});
    }
}

} // namespace ghost::fixture
