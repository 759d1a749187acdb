// SPDX-License-Identifier: Apache-2.0
// DMX modes: channels become one instance per geometry instance (gdtf-spec "DMX Mode").
#include "fixture_files/gdtf/private/gdtf_reader.h"

#include "base/text.h"
#include "fixture_files/gdtf/private/gdtf_channel.h"
#include "fixture_files/gdtf/private/gdtf_macros.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <string_view>
#include <utility>

namespace ghost::fixture {
namespace {

constexpr std::size_t kMaxModes = 1024;
constexpr std::size_t kMaxTemplates = 8192;     // DMXChannel elements of a mode
constexpr std::size_t kMaxChannels = 16384;     // per mode, references expanded
constexpr std::size_t kMaxFunctions = 1u << 18; // over all modes, references expanded
constexpr int kMaxFootprint = 65536;

// Which instance of channel template `wanted` serves an instance of another: the one in the same reference,
// else any.
struct Instances {
    std::map<std::pair<int, int>, int> exact; // (template, reference instance) -> channel
    std::map<int, int> any;

    int find(int wanted, int instance) const {
        if (const auto found = exact.find({wanted, instance}); found != exact.end()) return found->second;
        if (const auto found = any.find(wanted); found != any.end()) return found->second;
        return -1;
    }
};

// The nodes that a channel's geometry name stands for: one per reference instance, the first of that name.
class NodesByName {
public:
    NodesByName() = default;
    NodesByName(const Type& type, const Mode& mode, const ExpandedNodes& expanded) {
        std::set<std::pair<std::string, int>> seen;
        const auto add = [&](std::size_t node, int geometry) {
            const std::string& name = type.geometries[static_cast<std::size_t>(geometry)].name;
            if (seen.emplace(name, expanded.instance[node]).second)
                nodes_[name].push_back(static_cast<int>(node));
        };
        for (std::size_t i = 0; i < mode.nodes.size(); ++i) {
            add(i, mode.nodes[i].geometry);
            if (expanded.reference[i] >= 0) add(i, expanded.reference[i]);
        }
    }

    // Exactly, else in any case.
    const std::vector<int>& find(const std::string& name) const {
        static const std::vector<int> none;
        if (const auto found = nodes_.find(name); found != nodes_.end()) return found->second;
        for (const auto& [other, nodes] : nodes_)
            if (lower(other) == lower(name)) return nodes;
        return none;
    }

private:
    std::map<std::string, std::vector<int>> nodes_;
};

std::size_t bytes_of_copy(const Channel& channel) {
    std::size_t bytes = sizeof(Channel) + channel.logical.size() * sizeof(LogicalChannel);
    for (const ChannelFunction& function : channel.functions) {
        bytes += sizeof(ChannelFunction) + function.name.size() + function.attribute.size() +
                 function.original_attribute.size() + function.custom_name.size();
        for (const ChannelSet& set : function.sets) bytes += sizeof(ChannelSet) + set.name.size();
        for (const SubChannelSet& set : function.sub_sets)
            bytes += sizeof(SubChannelSet) + set.name.size() + set.sub_unit.size();
    }
    return bytes;
}

// Whether a channel says that the fixture gives light of its own.
bool speaks_of_light(const Channel& channel) {
    for (const ChannelFunction& function : channel.functions) switch (function.meaning.role) {
        case Role::dimmer:
        case Role::shutter:
        case Role::strobe:
        case Role::color_add:
        case Role::color_sub_c:
        case Role::color_wheel:
        case Role::color_rgb:
        case Role::hsb_hue:
        case Role::cie_x:
        case Role::cct:
        case Role::gobo_wheel:
        case Role::zoom:
        case Role::iris:
            return true;
        default:
            break;
        }
    return false;
}

// "Dimmer17": what programs write for each of a head's channels that know only how many there are.
bool is_nameless(const Channel& channel) {
    constexpr std::string_view kStem = "dimmer";
    const std::string attribute = channel.logical.empty() ? "" : lower(channel.logical.front().attribute);
    return attribute.size() > kStem.size() && attribute.starts_with(kStem) &&
           attribute.find_first_not_of("0123456789", kStem.size()) == std::string::npos;
}

// Break and bytes to add for a channel in a reference; false where the reference lacks the channel's break.
bool place_in_reference(const ReferenceInstance& instance, bool overwrite, int& dmx_break, int& add) {
    if (instance.root) {
        if (overwrite) dmx_break = 1;
        add = 0;
        return true;
    }
    if (overwrite) {
        dmx_break = instance.overwrite.x;
        add = instance.overwrite.y;
        return true;
    }
    for (const glm::ivec2 known : instance.offsets)
        if (known.x == dmx_break) {
            add = known.y;
            return true;
        }
    return false;
}

struct ModeReader {
    GdtfReader& reader;
    pugi::xml_node mode_node{};
    Mode mode{};
    ExpandedNodes expanded{};
    NodesByName nodes_by_name{};
    std::vector<ChannelTemplate> templates{};
    Names template_names{};
    Instances instances{};
    std::vector<std::pair<int, int>> sources{}; // per channel: template, reference instance

    void instantiate(int index) {
        const ChannelTemplate& source = templates[static_cast<std::size_t>(index)];
        const std::vector<int>& nodes = nodes_by_name.find(source.geometry);
        const std::size_t bytes = bytes_of_copy(source.channel);
        if (nodes.empty())
            reader.say(Severity::error, source.node,
                       "the channel's geometry '" + source.geometry + "' is not in this mode's tree");
        for (const int node : nodes) {
            const int instance = expanded.instance[static_cast<std::size_t>(node)];
            if (mode.channels.size() == kMaxChannels ||
                reader.functions_made + source.channel.functions.size() > kMaxFunctions ||
                !reader.take_bytes(bytes)) {
                reader.say(Severity::error, source.node, "too many channels once references are expanded");
                return;
            }
            Channel channel = source.channel;
            int add = 0;
            if (!channel.offsets.empty() &&
                !place_in_reference(expanded.instances[static_cast<std::size_t>(instance)], source.overwrite,
                                    channel.dmx_break, add)) {
                reader.say(Severity::error, source.node,
                           "'" + mode.nodes[static_cast<std::size_t>(node)].name +
                               "' refers to this channel without a Break " +
                               std::to_string(channel.dmx_break));
                continue;
            }
            for (int& offset : channel.offsets) offset += add;
            if (std::any_of(channel.offsets.begin(), channel.offsets.end(),
                            [](int offset) { return offset < 0 || offset >= kMaxFootprint; })) {
                reader.say(Severity::error, source.node, "the channel's address is out of range");
                continue;
            }
            channel.node = node;
            const std::string attribute = channel.logical.empty() ? "" : channel.logical[0].attribute;
            channel.name = mode.nodes[static_cast<std::size_t>(node)].name + "_" + attribute;
            const int made = static_cast<int>(mode.channels.size());
            instances.exact.emplace(std::pair(index, instance), made);
            instances.any.emplace(index, made);
            sources.emplace_back(index, instance);
            reader.functions_made += channel.functions.size();
            mode.channels.push_back(std::move(channel));
        }
    }

    // "Head_Gobo2" or "Head_Gobo2.Gobo2.Rotate": template and function; -1 where unknown.
    std::pair<int, int> find_link(const std::string& link) const {
        const std::vector<std::string_view> parts = split(link, '.');
        const int found = find_name(template_names, std::string(parts[0]));
        if (found < 0) return {-1, -1};
        if (parts.size() < 3) return {found, -1};
        const auto& functions = templates[static_cast<std::size_t>(found)].channel.functions;
        const std::string name = link.substr(static_cast<std::size_t>(parts[2].data() - link.data()));
        for (std::size_t i = 0; i < functions.size(); ++i)
            if (functions[i].name == name) return {found, static_cast<int>(i)};
        for (std::size_t i = 0; i < functions.size(); ++i)
            if (lower(functions[i].name) == lower(name)) return {found, static_cast<int>(i)};
        return {-1, -1};
    }

    // Whether a function of this channel counts under values of a master from above 0 on.
    bool has_rest_of(const ChannelTemplate& source, const std::string& link, int bytes) const {
        return std::any_of(source.masters.begin(), source.masters.end(), [&](const ModeMaster& master) {
            return master.link == link && dmx_value(reader, master.node, "ModeFrom", bytes, 0) > 0;
        });
    }

    void link_masters() {
        for (std::size_t i = 0; i < mode.channels.size(); ++i) {
            const auto [source, instance] = sources[i];
            const ChannelTemplate& made_from = templates[static_cast<std::size_t>(source)];
            for (std::size_t f = 0; f < made_from.masters.size(); ++f) {
                const ModeMaster& master = made_from.masters[f];
                if (master.link.empty()) continue;
                const auto [channel, function] = find_link(master.link);
                const int found = channel < 0 ? -1 : instances.find(channel, instance);
                if (found < 0) {
                    if (instances.any.at(source) == static_cast<int>(i))
                        reader.say(Severity::error, master.node,
                                   "ModeMaster '" + master.link + "' does not exist in this mode");
                    continue;
                }
                ChannelFunction& follower = mode.channels[i].functions[f];
                const Channel& leader = mode.channels[static_cast<std::size_t>(found)];
                const int bytes = bytes_of(leader);
                follower.master_channel = found;
                follower.master_function = function;
                follower.master_from = dmx_value(reader, master.node, "ModeFrom", bytes, 0);
                follower.master_to = dmx_value(reader, master.node, "ModeTo", bytes, 0);
                if (function < 0 || follower.master_from != 0 || follower.master_to != 0) continue;
                // 0..0 is also what stands there where nobody wrote a range: then the whole of the function
                // that the link names is meant, unless another one here counts for the rest of it.
                const ChannelFunction& named = leader.functions[static_cast<std::size_t>(function)];
                if (named.dmx_from == 0 && has_rest_of(made_from, master.link, bytes)) continue;
                follower.master_from = named.dmx_from;
                follower.master_to = named.dmx_to;
            }
        }
    }

    void read_relations(pugi::xml_node node) {
        for (const pugi::xml_node child : node.child("Relations").children("Relation")) {
            const auto [master, unused] = find_link(reader.text(child, "Master"));
            const auto [follower, function] = find_link(reader.text(child, "Follower"));
            if (master < 0 || follower < 0) {
                reader.say(Severity::warning, child,
                           "the relation's master or follower does not exist in this mode");
                continue;
            }
            const std::string name = reader.text(child, "Name");
            const bool multiply = reader.choice(child, "Type", {"Multiply", "Override"}) == "Multiply";
            for (std::size_t i = 0; i < sources.size(); ++i) {
                if (sources[i].first != follower) continue;
                const int leader = instances.find(master, sources[i].second);
                if (leader < 0) continue;
                if (reader.is_full(child, mode.relations.size(), kMaxChannels, "relations in a mode") ||
                    !reader.take_bytes(sizeof(Relation) + name.size()))
                    return;
                mode.relations.push_back(
                    {name, multiply ? Relation::Kind::multiply : Relation::Kind::override_value, leader,
                     static_cast<int>(i), function});
            }
        }
    }

    void find_axes() {
        std::set<std::pair<int, bool>> seen;
        for (const Channel& channel : mode.channels)
            for (const ChannelFunction& function : channel.functions) {
                const Role role = function.meaning.role;
                const bool pan = role == Role::pan || role == Role::pan_rotate;
                const bool tilt = role == Role::tilt || role == Role::tilt_rotate;
                if ((pan || tilt) && seen.insert({channel.node, pan}).second)
                    mode.axes.push_back({channel.node, pan});
            }
        std::stable_sort(mode.axes.begin(), mode.axes.end(), [](Axis a, Axis b) { return a.node < b.node; });
    }

    // Values trickle down: a channel changes the beams at or under its node. Files also put a wheel beside
    // the beam; then the nearest ancestor with beams decides.
    void link_beams() {
        std::vector<std::vector<int>> under(mode.nodes.size());
        for (std::size_t b = 0; b < mode.beams.size(); ++b)
            for (int node = mode.beams[b]; node >= 0;
                 node = mode.nodes[static_cast<std::size_t>(node)].parent)
                under[static_cast<std::size_t>(node)].push_back(static_cast<int>(b));
        for (Channel& channel : mode.channels) {
            int node = channel.node;
            while (node >= 0 && under[static_cast<std::size_t>(node)].empty())
                node = mode.nodes[static_cast<std::size_t>(node)].parent;
            if (node < 0) continue;
            const std::vector<int>& beams = under[static_cast<std::size_t>(node)];
            if (!reader.take_bytes(beams.size() * sizeof(int))) {
                reader.say(Severity::error, mode_node,
                           "too many channels for too many beams, some channels change none");
                return;
            }
            channel.beams = beams;
        }
    }

    // Files made by drawing programs have a dimmer and a body, but no Beam: a lamp that is patched should
    // shine. It shines as a default Beam would, from the last moving part or where its first channel sits.
    // Where channels have numbers for names, nobody knows which one dims it, unless it is the only one.
    void stand_in_beam() {
        int node = -1;
        for (const Channel& channel : mode.channels)
            if (node < 0 && speaks_of_light(channel)) node = channel.node;
        bool by_hand = false;
        if (node < 0 && !mode.channels.empty() && is_nameless(mode.channels.front())) {
            node = mode.channels.front().node;
            by_hand = mode.channels.size() > 1;
            if (!by_hand)
                for (ChannelFunction& function : mode.channels.front().functions)
                    function.meaning = attribute_from("Dimmer");
        }
        if (node < 0 || kind_of(node) == GeometryKind::media_server_layer ||
            kind_of(node) == GeometryKind::media_server_master) {
            reader.say(Severity::warning, mode_node,
                       "no Beam or Laser geometry in mode '" + mode.name + "': it gives no light");
            return;
        }
        for (std::size_t i = 0; i < mode.nodes.size(); ++i)
            if (kind_of(static_cast<int>(i)) == GeometryKind::axis)
                node = std::max(node, static_cast<int>(i));
        for (const Axis axis : mode.axes) node = std::max(node, axis.node);
        Geometry geometry;
        geometry.kind = GeometryKind::beam;
        geometry.name = "Beam (assumed)";
        geometry.beam.emplace();
        geometry.beam->is_assumed = true;
        geometry.beam->is_lit_by_hand = by_hand;
        mode.beams.push_back(static_cast<int>(mode.nodes.size()));
        mode.nodes.push_back({.name = geometry.name,
                              .geometry = static_cast<int>(reader.type().geometries.size()),
                              .parent = node});
        reader.type().geometries.push_back(std::move(geometry));
        reader.say(Severity::warning, mode_node,
                   "no Beam or Laser geometry in mode '" + mode.name +
                       "': taking one of 10000 lm and 25 degrees at '" +
                       mode.nodes[static_cast<std::size_t>(node)].name +
                       (by_hand ? "', which hands alone light, as its channels have numbers for names"
                                : "', as its channels speak of light"));
    }

    GeometryKind kind_of(int node) const {
        const int geometry = mode.nodes[static_cast<std::size_t>(node)].geometry;
        return reader.loaded.type.geometries[static_cast<std::size_t>(geometry)].kind;
    }

    std::vector<int> channels_of(const std::string& link) const {
        std::vector<int> channels;
        const int wanted = find_link(link).first;
        for (std::size_t i = 0; wanted >= 0 && i < sources.size(); ++i)
            if (sources[i].first == wanted) channels.push_back(static_cast<int>(i));
        return channels;
    }

    // A lamp behind flags of cyan, magenta and yellow is white: one additive colour beside them, without an
    // Emitter, is a flag under a wrong name (Terbly V1000P). Taken as an LED it would be the only light.
    void drop_lone_emitter() {
        std::set<char> added;
        bool has_flags = false;
        const auto each = [&](const auto& use) {
            for (Channel& channel : mode.channels)
                for (ChannelFunction& function : channel.functions) use(function);
        };
        each([&](const ChannelFunction& function) {
            const Role role = function.meaning.role;
            has_flags |= role == Role::color_sub_c || role == Role::color_sub_m || role == Role::color_sub_y;
            if (role == Role::color_add) added.insert(function.emitter < 0 ? function.meaning.letter : '*');
        });
        if (!has_flags || added.size() != 1 ||
            std::string_view("RGB").find(*added.begin()) == std::string_view::npos)
            return;
        each([](ChannelFunction& function) {
            if (function.meaning.role == Role::color_add) function.meaning.role = Role::none;
        });
        reader.say(
            Severity::warning, mode_node,
            std::string("ColorAdd_") + *added.begin() +
                " is the only additive colour of a mode with cyan, magenta and yellow flags and has no "
                "Emitter; taken as a white lamp, the channel does nothing");
    }

    void check_bytes(pugi::xml_node node) {
        std::map<std::pair<int, int>, std::size_t> owners;
        for (std::size_t i = 0; i < mode.channels.size(); ++i)
            for (const int offset : mode.channels[i].offsets) {
                const int dmx_break = mode.channels[i].dmx_break;
                if (mode.footprint.size() < static_cast<std::size_t>(dmx_break))
                    mode.footprint.resize(static_cast<std::size_t>(dmx_break), 0);
                int& size = mode.footprint[static_cast<std::size_t>(dmx_break - 1)];
                size = std::max(size, offset + 1);
                const auto [owner, is_new] = owners.emplace(std::pair(dmx_break, offset), i);
                if (!is_new && owner->second != i)
                    reader.say(Severity::warning, node,
                               "channels '" + mode.channels[owner->second].name + "' and '" +
                                   mode.channels[i].name + "' both use byte " + std::to_string(offset + 1) +
                                   " of break " + std::to_string(dmx_break));
            }
    }

    int find_root(pugi::xml_node node) {
        const std::string wanted = reader.text(node, "Geometry");
        if (const int found = find_name(reader.top_level, wanted); found >= 0) return found;
        if (reader.top_level.empty()) {
            reader.say(Severity::error, node, "the fixture has no geometry, the mode is left out");
            return -1;
        }
        int first = reader.top_level.begin()->second;
        for (const auto& [name, index] : reader.top_level) first = std::min(first, index);
        reader.say(Severity::warning, node,
                   (wanted.empty() ? std::string("the mode names no geometry")
                                   : "the mode's geometry '" + wanted + "' is no top-level geometry") +
                       ", taking '" + reader.type().geometries[static_cast<std::size_t>(first)].name + "'");
        return first;
    }

    bool read(pugi::xml_node node) {
        mode_node = node;
        mode.name = reader.text(node, "Name");
        mode.description = reader.text(node, "Description");
        const int root = find_root(node);
        if (root < 0) return false;
        expanded = expand_geometries(reader, node, root, mode);
        nodes_by_name = NodesByName(reader.type(), mode, expanded);
        std::vector<std::string> twins;
        for (const pugi::xml_node child : node.child("DMXChannels").children("DMXChannel")) {
            if (reader.is_full(child, templates.size(), kMaxTemplates, "channels in a mode")) break;
            templates.push_back(read_channel(reader, child));
            const ChannelTemplate& last = templates.back();
            const std::string attribute =
                last.channel.logical.empty() ? "" : last.channel.logical[0].attribute;
            const std::string name = last.geometry + "_" + attribute;
            if (!template_names.emplace(name, static_cast<int>(templates.size()) - 1).second &&
                last.channel.logical.size() == 1 && lower(attribute) != "nofeature")
                twins.push_back(name);
        }
        for (std::size_t i = 0; i < templates.size(); ++i) instantiate(static_cast<int>(i));
        if (!twins.empty())
            reader.say(Severity::note, node,
                       std::to_string(twins.size()) + " channels have the name of another ('" + twins[0] +
                           "'), links mean the first");
        link_masters();
        read_relations(node);
        find_axes();
        if (mode.beams.empty()) stand_in_beam();
        link_beams();
        drop_lone_emitter();
        check_bytes(node);
        const auto find_channels = [this](const std::string& link) { return channels_of(link); };
        read_macros(reader, node.child("FTMacros"), find_channels, true, mode);
        read_macros(reader, node.parent().parent().child("FTMacros"), find_channels, false, mode);
        if (mode.footprint.empty())
            reader.say(Severity::warning, node,
                       "mode '" + mode.name + "' takes no DMX: " +
                           (mode.channels.empty() ? "it has no channels" : "all its channels are virtual"));
        mode.order.resize(mode.channels.size());
        std::iota(mode.order.begin(), mode.order.end(), 0);
        std::stable_sort(mode.order.begin(), mode.order.end(), [&](int a, int b) {
            return mode.channels[static_cast<std::size_t>(a)].node <
                   mode.channels[static_cast<std::size_t>(b)].node;
        });
        return true;
    }
};

} // namespace

void read_modes(GdtfReader& reader, pugi::xml_node fixture_type) {
    for (const pugi::xml_node node : fixture_type.child("DMXModes").children("DMXMode")) {
        if (reader.is_full(node, reader.type().modes.size(), kMaxModes, "modes")) break;
        ModeReader mode{.reader = reader};
        if (!mode.read(node)) continue;
        reader.add_name(reader.modes, node, "mode", mode.mode.name,
                        static_cast<int>(reader.type().modes.size()));
        reader.type().modes.push_back(std::move(mode.mode));
    }
    if (const pugi::xml_node list = fixture_type.child("FTMacros"); list.child("FTMacro"))
        reader.say(
            Severity::note, list,
            "FTMacros stands under FixtureType, expected under DMXMode; every mode that has the channels "
            "takes its macros");
    if (reader.type().modes.empty()) reader.say(Severity::error, fixture_type, "the fixture has no DMX mode");
}

} // namespace ghost::fixture
