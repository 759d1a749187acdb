// SPDX-License-Identifier: Apache-2.0
// A second red, or a second dimmer, without a matrix that says where it is: other pixels ("Red 1", "Red 2")
// or another light in the same place ("Beam red", "Aura red"). Names alone tell.
#include "fixture_files/ofl/private/ofl_mode_maker.h"
#include "fixture_files/ofl/private/ofl_words.h"

#include <algorithm>

namespace ghost::fixture {
namespace {

// What a channel does to light: an emitter's attribute, "Dimmer", "Shutter1"; empty: none of these, or
// several.
std::string light_of(const ChannelDraft& draft) {
    std::string kind;
    for (const ChannelFunction& function : draft.channel.functions) {
        if (!is_shown(function)) continue;
        const Role role = function.meaning.role;
        const bool is_shutter = role == Role::shutter || role == Role::strobe || role == Role::strobe_pulse ||
                                role == Role::strobe_random || role == Role::strobe_effect;
        if (!is_shutter && role != Role::dimmer && role != Role::color_add) return "";
        const std::string own = is_shutter ? "Shutter1" : function.attribute;
        if (!kind.empty() && kind != own) return "";
        kind = own;
    }
    return kind;
}

} // namespace

void OflModeMaker::find_layers() {
    if (has_pixels_ || draft_.body.cells.empty()) return;
    std::map<std::string, std::vector<std::string>> labels; // of channels that do the same, in their order
    for (std::size_t i = 0; i < draft_.channels.size(); ++i) {
        const std::string kind = light_of(draft_.channels[i]);
        if (kind.empty() || kind == "Shutter1" || ofl_is_master(names_[i])) continue;
        const std::string label = ofl_label(names_[i]);
        if (kind == "Dimmer" && label.empty()) continue; // a dimmer beside one with a name is for all
        std::vector<std::string>& known = labels[kind];
        if (std::find(known.begin(), known.end(), label) == known.end()) known.push_back(label);
    }
    std::vector<std::string> layers;
    for (const auto& [kind, of_kind] : labels)
        if (kind != "Dimmer" && of_kind.size() > layers.size()) layers = of_kind;
    if (layers.size() < 2) layers = labels["Dimmer"];
    if (layers.size() < 2) return;
    const std::size_t cells = draft_.body.cells.size();
    if (cells == layers.size() ||
        (cells == 1 && layers.size() <= kMaxCells && std::all_of(layers.begin(), layers.end(), ofl_is_place)))
        return spread_layers(layers);
    if (cells > 1) return; // heads that share their light in a way that names do not tell
    const auto plain = std::find(layers.begin(), layers.end(), "");
    keep_layer(layers, plain == layers.end() ? 0 : static_cast<std::size_t>(plain - layers.begin()));
}

// A cell for each, side by side in the order of the file.
void OflModeMaker::spread_layers(const std::vector<std::string>& layers) {
    Body& body = draft_.body;
    if (body.cells.size() != layers.size()) {
        body.grid = {static_cast<int>(layers.size()), 1};
        body.cells.clear();
        for (int i = 0; i < body.grid.x; ++i) body.cells.push_back({i, 0});
        body.cell_groups.assign(body.cells.size(), 0);
    }
    body.cell_names = layers;
    std::replace(body.cell_names.begin(), body.cell_names.end(), std::string(), std::string("main"));
    std::map<std::string, std::vector<std::pair<std::size_t, int>>> found; // kind -> draft, cell
    for (std::size_t i = 0; i < draft_.channels.size(); ++i) {
        const std::string kind = light_of(draft_.channels[i]);
        if (kind.empty() || ofl_is_master(names_[i])) continue;
        for (std::size_t cell = 0; cell < layers.size(); ++cell) {
            const bool fits = kind == "Shutter1" ? ofl_has_label(names_[i], layers[cell])
                                                 : ofl_label(names_[i]) == layers[cell];
            if (fits) found[kind].emplace_back(i, static_cast<int>(cell));
        }
    }
    for (const auto& [kind, drafts] : found)
        if (drafts.size() > 1)
            for (const auto& [i, cell] : drafts) draft_.channels[i].cells = {cell};
}

// Where the others are, and how bright, is not in the file: the first one is the fixture's light.
void OflModeMaker::keep_layer(const std::vector<std::string>& layers, std::size_t kept) {
    std::string lost;
    int count = 0;
    for (std::size_t i = 0; i < draft_.channels.size(); ++i) {
        Channel& channel = draft_.channels[i].channel;
        const bool is_other = std::any_of(layers.begin(), layers.end(), [&](const std::string& label) {
            return label != layers[kept] && ofl_has_label(names_[i], label);
        });
        if (!is_other || std::none_of(channel.functions.begin(), channel.functions.end(), is_shown)) continue;
        for (ChannelFunction& function : channel.functions) {
            ChannelFunction idle = make_function("NoFeature", function.dmx_from, function.dmx_to, 0, 1);
            idle.name = function.name;
            idle.master_channel = function.master_channel;
            idle.master_from = function.master_from;
            idle.master_to = function.master_to;
            function = std::move(idle);
        }
        if (++count <= 8) lost += (lost.empty() ? "'" : ", '") + names_[i].substr(0, 60) + "'";
    }
    if (count == 0) return;
    if (count > 8) lost += ", ...";
    reader_.say(Severity::error, pointer_,
                "a second light whose place and brightness are not in the file is not shown: " + lost);
}

} // namespace ghost::fixture
