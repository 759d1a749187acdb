// SPDX-License-Identifier: Apache-2.0
// Modes: bytes joined, heads and axes found, wheels numbered, switching channels and colour macros linked.
#include "base/text.h"
#include "fixture/values.h"
#include "fixture_files/qxf/private/qxf_reader.h"

#include <algorithm>
#include <cmath>

namespace ghost::fixture {
namespace {

const std::string& attribute_of(const Sketch& sketch) {
    static const std::string none;
    for (const ChannelFunction& function : sketch.functions)
        if (is_shown(function)) return function.attribute;
    return none;
}

bool any_role(const Sketch& sketch, std::initializer_list<Role> roles) {
    return std::any_of(sketch.functions.begin(), sketch.functions.end(),
                       [&](const ChannelFunction& function) {
                           return std::find(roles.begin(), roles.end(), function.meaning.role) != roles.end();
                       });
}

// "Pan Fine", "Gobo rotation LSB (16 bit)" -> "pan", "gobo rotation"
std::string coarse_words(std::string words) {
    for (const char* word : {"fine", "lsb", "msb", "coarse", "16bit", "16-bit", "16 bit", "(", ")", ",", "-",
                             "[", "]", "low byte", "high byte"})
        for (std::size_t at = words.find(word); at != std::string::npos; at = words.find(word))
            words.erase(at, std::string_view(word).size());
    std::string result;
    for (const std::string_view part : split(words, ' '))
        if (!part.empty()) result += (result.empty() ? "" : " ") + std::string(part);
    return result;
}

// What a mode does not state is the fixture's.
QxfPhysical merged(const std::optional<QxfPhysical>& own, const QxfPhysical& whole) {
    if (!own) return whole;
    QxfPhysical result = *own;
    LampFacts& lamp = result.lamp;
    if (lamp.bulb.empty()) lamp.bulb = whole.lamp.bulb;
    if (lamp.lens.empty()) lamp.lens = whole.lamp.lens;
    if (lamp.lumens <= 0.0f) lamp.lumens = whole.lamp.lumens;
    if (lamp.power_w <= 0.0f) lamp.power_w = whole.lamp.power_w;
    if (lamp.color_temperature_k <= 0.0f) lamp.color_temperature_k = whole.lamp.color_temperature_k;
    if (lamp.degrees_max <= 0.0f) {
        lamp.degrees_min = whole.lamp.degrees_min;
        lamp.degrees_max = whole.lamp.degrees_max;
    }
    for (int k = 0; k < 3; ++k)
        if (result.size_m[k] <= 0.0f) result.size_m[k] = whole.size_m[k];
    if (result.focus.empty()) result.focus = whole.focus;
    if (result.pan_max_deg <= 0.0f) result.pan_max_deg = whole.pan_max_deg;
    if (result.tilt_max_deg <= 0.0f) result.tilt_max_deg = whole.tilt_max_deg;
    if (result.layout == glm::ivec2(1, 1)) result.layout = whole.layout;
    return result;
}

class ModeMaker {
public:
    ModeMaker(QxfReader& reader, TypeBuilder& builder, const QxfMode& mode)
        : reader_(reader), builder_(builder), mode_(mode), physical_(merged(mode.physical, reader.physical)),
          places_(mode.channels.size()) {}

    void run() {
        draft_.name = mode_.name;
        draft_.footprint = static_cast<int>(mode_.channels.size());
        sketch_all();
        find_cells();
        find_groups();
        make_body();
        for (std::size_t number = 0; number < places_.size(); ++number) make_channel(number);
        find_wheels();
        mix();
        link_switches();
        if (!builder_.add_mode(std::move(draft_)))
            reader_.say(Severity::error, mode_.line,
                        "mode '" + mode_.name +
                            "' is left out: the fixture has more than 65536 nodes or functions");
    }

private:
    struct Place {         // one channel of the mode
        int channel = -1;  // QxfReader::channels
        int coarse = -1;   // fine: the place of its coarse byte
        int fine = -1;     // coarse: the place of its fine byte
        std::string words; // its name without "fine" and the like
        std::vector<int> heads;
        Sketch sketch;
        std::vector<int> cells; // empty: all
        int group = -1;
        int draft = -1; // ModeDraft::channels
    };

    const QxfChannel& definition(const Place& place) const {
        return reader_.channels[static_cast<std::size_t>(place.channel)];
    }

    // Heads often list the coarse byte only.
    bool share_a_head(const Place& a, const Place& b) const {
        return a.heads.empty() || b.heads.empty() ||
               std::any_of(a.heads.begin(), a.heads.end(), [&](int head) {
                   return std::find(b.heads.begin(), b.heads.end(), head) != b.heads.end();
               });
    }

    bool fits(const Place& fine, const Place& coarse) const {
        const QxfChannel& low = definition(fine);
        const QxfChannel& high = definition(coarse);
        if (high.fine || coarse.fine >= 0) return false;
        if (fine.words == coarse.words) return true;
        if (!is_fine_preset(low.preset)) return false;
        const ChannelPreset* wanted = find_preset(low.preset);
        const ChannelPreset* offered = find_preset(high.preset);
        return wanted && offered && wanted->attribute == offered->attribute && share_a_head(fine, coarse);
    }

    // The coarse byte of a fine one: by name or preset, the nearest before it, else after it; else the
    // channel just before it, when that is of the same group.
    void join_bytes() {
        for (std::size_t fine = 0; fine < places_.size(); ++fine) {
            if (places_[fine].channel < 0 || !definition(places_[fine]).fine) continue;
            int found = -1;
            for (std::size_t k = fine; k-- > 0 && found < 0;)
                if (places_[k].channel >= 0 && fits(places_[fine], places_[k])) found = static_cast<int>(k);
            for (std::size_t k = fine + 1; k < places_.size() && found < 0; ++k)
                if (places_[k].channel >= 0 && fits(places_[fine], places_[k])) found = static_cast<int>(k);
            if (found < 0 && fine > 0 && places_[fine - 1].channel >= 0) {
                const QxfChannel& before = definition(places_[fine - 1]);
                if (!before.fine && places_[fine - 1].fine < 0 &&
                    before.group == definition(places_[fine]).group && !before.group.empty())
                    found = static_cast<int>(fine) - 1;
            }
            places_[fine].coarse = found;
            if (found >= 0)
                places_[static_cast<std::size_t>(found)].fine = static_cast<int>(fine);
            else
                reader_.say(Severity::error, definition(places_[fine]).line,
                            "fine channel '" + definition(places_[fine]).name + "' of mode '" + mode_.name +
                                "' has no coarse channel, it does nothing");
        }
    }

    void sketch_all() {
        for (std::size_t number = 0; number < places_.size(); ++number)
            places_[number].channel = mode_.channels[number].channel;
        for (Place& place : places_)
            if (place.channel >= 0) place.words = coarse_words(definition(place).words);
        for (std::size_t head = 0; head < mode_.heads.size(); ++head)
            for (const int number : mode_.heads[head].numbers) {
                std::vector<int>& heads = places_[static_cast<std::size_t>(number)].heads;
                if (heads.empty() || heads.back() != static_cast<int>(head))
                    heads.push_back(static_cast<int>(head));
            }
        join_bytes();
        for (Place& place : places_)
            if (place.channel >= 0 && !definition(place).fine)
                place.sketch = sketch_channel(reader_, place.channel, physical_);
    }

    // --- heads ---

    bool gives_light() const {
        const std::string kind = lower(reader_.fixture_kind);
        return kind != "smoke" && kind != "hazer" && kind != "fan";
    }

    void find_cells() {
        Body& body = draft_.body;
        if (!gives_light()) return;
        std::size_t count = std::max<std::size_t>(mode_.heads.size(), 1);
        if (mode_.heads.size() >= 2) {
            for (Place& place : places_) place.cells = place.heads;
        } else {
            count = guess_cells();
        }
        count = std::min(count, kMaxCells);
        body.grid = grid_of(static_cast<int>(count));
        for (int i = 0; i < static_cast<int>(count); ++i)
            body.cells.push_back({i % body.grid.x, i / body.grid.x});
    }

    // Channels of the same colour, or several dimmers, mean as many cells, stated or not.
    std::size_t guess_cells() {
        std::map<std::string, std::vector<std::size_t>> same;
        for (std::size_t number = 0; number < places_.size(); ++number) {
            const Place& place = places_[number];
            if (place.channel < 0 || place.sketch.functions.empty()) continue;
            const bool dimmer = place.sketch.subject == Subject::dimmer &&
                                definition(place).preset != "IntensityMasterDimmer" &&
                                !has_word(definition(place).words, {"master"});
            const bool colour =
                place.sketch.subject == Subject::fixed && any_role(place.sketch, {Role::color_add});
            if (dimmer || colour) same[dimmer ? "Dimmer" : attribute_of(place.sketch)].push_back(number);
        }
        std::size_t count = 1;
        for (const auto& [attribute, numbers] : same) count = std::max(count, numbers.size());
        if (count < 2) return 1;
        for (const auto& [attribute, numbers] : same)
            for (std::size_t k = 0; k < numbers.size(); ++k)
                if (numbers.size() == count) places_[numbers[k]].cells = {static_cast<int>(k)};
        reader_.say(Severity::note, mode_.line,
                    "mode '" + mode_.name + "' states no heads but repeats its colours or dimmers: " +
                        std::to_string(count) + " beams are taken");
        return count;
    }

    glm::ivec2 grid_of(int count) const {
        const glm::ivec2 layout = physical_.layout;
        if (layout.x * layout.y >= count && layout.x * layout.y > 1) return layout;
        const float across = physical_.size_m.x > 0.0f ? physical_.size_m.x : 1.0f;
        const float along = physical_.size_m.z > 0.0f ? physical_.size_m.z : 1.0f;
        const float rows = std::sqrt(static_cast<float>(count) * along / across);
        int columns = count;
        if (rows >= 1.5f) columns = static_cast<int>(std::ceil(static_cast<float>(count) / std::floor(rows)));
        columns = std::clamp(columns, 1, count);
        return {columns, (count + columns - 1) / columns};
    }

    // --- axes ---

    void find_groups() {
        Body& body = draft_.body;
        std::vector<std::size_t> pans;
        std::vector<std::size_t> tilts;
        std::size_t endless_pans = 0;
        std::size_t endless_tilts = 0;
        for (std::size_t number = 0; number < places_.size(); ++number) {
            const Sketch& sketch = places_[number].sketch;
            if (any_role(sketch, {Role::pan})) pans.push_back(number);
            if (any_role(sketch, {Role::tilt})) tilts.push_back(number);
            endless_pans += sketch.subject == Subject::pan_turn;
            endless_tilts += sketch.subject == Subject::tilt_turn;
        }
        body.pan = !pans.empty() || endless_pans > 0;
        body.tilt = !tilts.empty() || endless_tilts > 0;
        const std::size_t groups = std::clamp<std::size_t>(std::max(pans.size(), tilts.size()), 1, 64);
        body.groups = static_cast<int>(groups);
        for (const std::vector<std::size_t>& axis : {pans, tilts})
            for (std::size_t k = 0; k < axis.size() && axis.size() > 1; ++k)
                places_[axis[k]].group = static_cast<int>(std::min(k, groups - 1));
        if (body.cells.empty()) return;
        if (body.cells.size() < groups) { // the same light from every head
            body.cells.clear();
            body.grid = {static_cast<int>(groups), 1};
            for (int i = 0; i < static_cast<int>(groups); ++i) body.cells.push_back({i, 0});
            for (Place& place : places_) place.cells.clear();
        }
        body.cell_groups.resize(body.cells.size(), 0);
        for (std::size_t cell = 0; cell < body.cells.size(); ++cell) {
            body.cell_groups[cell] = static_cast<int>(cell * groups / body.cells.size());
            if (mode_.heads.size() != body.cells.size()) continue;
            for (const int number : mode_.heads[cell].numbers)
                if (places_[static_cast<std::size_t>(number)].group >= 0)
                    body.cell_groups[cell] = places_[static_cast<std::size_t>(number)].group;
        }
    }

    void make_body() {
        Body& body = draft_.body;
        const std::string focus = lower(physical_.focus);
        const std::string kind = lower(reader_.fixture_kind);
        body.size_m = physical_.size_m;
        if (focus == "mirror" && (body.pan || body.tilt))
            body.carriage = Carriage::mirror;
        else if (body.pan || body.tilt || (focus == "head" && kind == "moving head"))
            body.carriage = Carriage::head;
        LampFacts facts = physical_.lamp;
        for (const Place& place : places_)
            facts.has_gobos |= place.sketch.subject == Subject::gobo && place.sketch.slots;
        const BeamGuess guess = beam_from(facts, body.carriage);
        body.beam = guess.beam;
        if (body.cells.empty()) return;
        for (const std::string& sentence : guess.assumed) reader_.say(Severity::note, mode_.line, sentence);
    }

    // --- channels ---

    // Which wheel a channel belongs to: numbers in the order of the wheels, turning channels follow theirs.
    int wheel_number(std::size_t number) {
        Place& place = places_[number];
        const Subject subject = place.sketch.subject;
        const bool gobo = subject == Subject::gobo || subject == Subject::gobo_turn;
        int& count = gobo ? gobo_wheels_ : (subject == Subject::colour ? color_wheels_ : prisms_);
        if (subject == Subject::gobo || subject == Subject::colour || subject == Subject::prism) {
            if (place.sketch.slots || count == 0) ++count;
            numbers_[number] = count;
            return count;
        }
        const int acts_on = mode_.channels[number].acts_on;
        if (acts_on >= 0)
            if (const auto found = numbers_.find(static_cast<std::size_t>(acts_on)); found != numbers_.end())
                return found->second;
        return std::max(count, 1);
    }

    static void set_number(ChannelFunction& function, int number) {
        const std::size_t at = function.attribute.find('#');
        if (at == std::string::npos) return;
        function.attribute.replace(at, 1, std::to_string(number));
        if (const std::size_t in_name = function.name.find('#');
            in_name != std::string::npos &&
            (function.name.starts_with("Gobo#") || function.name.starts_with("Prism#")))
            function.name.replace(in_name, 1, std::to_string(number));
        function.meaning = attribute_from(function.attribute);
    }

    // Turning channels name no wheel of their own: it is the one with their number.
    void find_wheels() {
        std::map<std::pair<bool, int>, int> wheels; // gobo or prism, number
        for (const ChannelDraft& draft : draft_.channels)
            for (const ChannelFunction& function : draft.channel.functions) {
                const Role role = function.meaning.role;
                if (role == Role::gobo_wheel || role == Role::prism)
                    wheels.emplace(std::pair(role == Role::gobo_wheel, function.meaning.number),
                                   function.wheel);
            }
        for (ChannelDraft& draft : draft_.channels)
            for (ChannelFunction& function : draft.channel.functions) {
                const Role role = function.meaning.role;
                const bool gobo = role == Role::gobo_index || role == Role::gobo_rotate;
                const bool prism = role == Role::prism_index || role == Role::prism_rotate;
                if (function.wheel >= 0 || (!gobo && !prism)) continue;
                if (const auto found = wheels.find({gobo, function.meaning.number}); found != wheels.end())
                    function.wheel = found->second;
            }
    }

    // Nothing, and a message, where the mode's functions become too many.
    std::vector<ChannelFunction> with_room(const std::vector<ChannelFunction>& functions) {
        functions_made_ += functions.size();
        if (functions_made_ <= kMaxBuiltFunctions) return functions;
        reader_.say(Severity::error, mode_.line, "mode '" + mode_.name + "' has more than 65536 functions");
        return {};
    }

    void make_channel(std::size_t number) {
        Place& place = places_[number];
        if (place.channel < 0 || definition(place).fine) return;
        const QxfChannel& channel = definition(place);
        ChannelDraft draft;
        draft.channel.name = channel.name;
        draft.channel.offsets = {static_cast<int>(number)};
        if (place.fine >= 0) draft.channel.offsets.push_back(place.fine);
        const int bytes = static_cast<int>(draft.channel.offsets.size());
        draft.channel.max = dmx_max(bytes);
        draft.channel.functions = with_room(place.sketch.functions);
        const Subject subject = place.sketch.subject;
        const bool wheels = subject == Subject::gobo || subject == Subject::gobo_turn ||
                            subject == Subject::colour || subject == Subject::prism ||
                            subject == Subject::prism_turn;
        const int wheel = wheels ? wheel_number(number) : 1;
        int initial = channel.initial;
        for (ChannelFunction& function : draft.channel.functions) {
            set_number(function, wheel);
            widen(function, 1, bytes);
            const Role role = function.meaning.role;
            if (initial < 0 && (role == Role::pan || role == Role::tilt || role == Role::focus))
                initial = 128;
        }
        const std::uint32_t start = static_cast<std::uint32_t>(std::max(initial, 0));
        draft.channel.initial = start << (8 * (bytes - 1));
        draft.channel.logical.push_back({.attribute = attribute_of(place.sketch)});
        if (draft.channel.logical[0].attribute.find('#') != std::string::npos &&
            !draft.channel.functions.empty())
            draft.channel.logical[0].attribute = draft.channel.functions.front().attribute;
        draft.cells = place.cells;
        draft.group = place.group;
        place.draft = static_cast<int>(draft_.channels.size());
        draft_.channels.push_back(std::move(draft));
    }

    void mix() {
        std::vector<std::size_t> macros;
        for (const Place& place : places_)
            if (place.draft >= 0 && place.sketch.subject == Subject::colour && place.sketch.slots)
                macros.push_back(static_cast<std::size_t>(place.draft));
        mix_colours(reader_.loaded.type, builder_, draft_.channels, macros);
    }

    // --- switching channels ---

    void link_switches() {
        for (const Place& place : places_) {
            if (place.draft < 0) continue;
            const int bytes = static_cast<int>(
                draft_.channels[static_cast<std::size_t>(place.draft)].channel.offsets.size());
            for (const QxfCapability& capability : definition(place).capabilities)
                for (const QxfAlias& alias : capability.aliases)
                    if (alias.mode == mode_.name) link_switch(place.draft, bytes, capability, alias);
        }
    }

    void link_switch(int master, int bytes, const QxfCapability& capability, const QxfAlias& alias) {
        const auto from = reader_.channel_names.find(alias.channel);
        const auto to = reader_.channel_names.find(alias.with);
        const auto place = from == reader_.channel_names.end()
                               ? places_.end()
                               : std::find_if(places_.begin(), places_.end(), [&](const Place& candidate) {
                                     return candidate.channel == from->second;
                                 });
        if (to == reader_.channel_names.end() || place == places_.end()) {
            reader_.say(Severity::error, capability.line,
                        "an alias names channels '" + alias.channel + "' and '" + alias.with +
                            "' that mode '" + mode_.name + "' or the file does not have");
            return;
        }
        if (place->draft < 0 || place->draft == master) return;
        ChannelDraft& target = draft_.channels[static_cast<std::size_t>(place->draft)];
        const int shift = 8 * (bytes - 1);
        const int target_bytes = static_cast<int>(target.channel.offsets.size());
        std::vector<ChannelFunction> functions =
            with_room(sketch_channel(reader_, to->second, physical_).functions);
        for (ChannelFunction& function : functions) {
            set_number(function, 1);
            widen(function, 1, target_bytes);
            function.master_channel = master;
            function.master_from = capability.low << shift;
            function.master_to = (capability.high << shift) | ((1u << shift) - 1u);
        }
        target.channel.functions.insert(target.channel.functions.begin(), functions.begin(), functions.end());
    }

    QxfReader& reader_;
    TypeBuilder& builder_;
    const QxfMode& mode_;
    const QxfPhysical physical_;
    std::vector<Place> places_;
    ModeDraft draft_;
    std::map<std::size_t, int> numbers_; // of wheels, by place
    std::size_t functions_made_ = 0;
    int gobo_wheels_ = 0;
    int color_wheels_ = 0;
    int prisms_ = 0;
};

} // namespace

void convert_modes(QxfReader& reader) {
    TypeBuilder builder(reader.loaded.type);
    for (const QxfMode& mode : reader.modes) ModeMaker(reader, builder, mode).run();
}

} // namespace ghost::fixture
