// SPDX-License-Identifier: Apache-2.0
#include "fixture_files/common/type_builder.h"

#include "base/check.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <numeric>

namespace ghost::fixture {
namespace {

constexpr float kHead_m = 0.35f;  // of a moving head whose size is not known
constexpr float kFixed_m = 0.25f; // of any other
constexpr float kSmallest_m = 0.02f;
constexpr float kLargest_m = 20.0f;

bool same(const Beam& a, const Beam& b) {
    return a.lamp_type == b.lamp_type && a.power_w == b.power_w && a.luminous_flux_lm == b.luminous_flux_lm &&
           a.color_temperature_k == b.color_temperature_k && a.beam_angle_deg == b.beam_angle_deg &&
           a.field_angle_deg == b.field_angle_deg && a.beam_type == b.beam_type;
}

bool same(const Body& a, const Body& b) {
    return a.carriage == b.carriage && a.size_m == b.size_m && a.pan == b.pan && a.tilt == b.tilt &&
           a.groups == b.groups && a.grid == b.grid && a.cells == b.cells && a.cell_groups == b.cell_groups &&
           a.cell_names == b.cell_names && same(a.beam, b.beam);
}

glm::mat4 at(float x, float y, float z) {
    return glm::translate(glm::mat4(1.0f), glm::vec3(x, y, z));
}

// Puts the geometries of one body into a Type. Indices are those of Type::geometries.
class Carpenter {
public:
    explicit Carpenter(Type& type) : type_(type), first_(type.geometries.size()) {}

    int add(const std::string& name, int parent, const glm::mat4& local,
            GeometryKind kind = GeometryKind::geometry) {
        Geometry geometry;
        geometry.kind = kind;
        geometry.name = name;
        geometry.parent = parent;
        geometry.local = local;
        const int index = static_cast<int>(type_.geometries.size());
        if (parent >= 0) type_.geometries[static_cast<std::size_t>(parent)].children.push_back(index);
        type_.geometries.push_back(std::move(geometry));
        return index;
    }

    int add_shape(const std::string& name, int parent, const glm::mat4& local, const std::string& primitive,
                  const glm::vec3& size_m) {
        const int index = add(name, parent, local);
        const glm::vec3 size = glm::max(size_m, glm::vec3(kSmallest_m));
        const auto known = std::find_if(type_.models.begin(), type_.models.end(), [&](const Model& model) {
            return model.primitive == primitive && model.size_m == size;
        });
        int model = static_cast<int>(known - type_.models.begin());
        if (known == type_.models.end()) {
            type_.models.emplace_back();
            type_.models.back().name = name;
            type_.models.back().primitive = primitive;
            type_.models.back().size_m = size;
            model = static_cast<int>(type_.models.size()) - 1;
        }
        type_.geometries[static_cast<std::size_t>(index)].model = model;
        return index;
    }

    int relative(int index) const { return index - static_cast<int>(first_); }

    // The cells of a group on a face of that size, around the parent's axis.
    void add_cells(const Body& body, int group, int parent, const glm::vec2& face_m, float z_m,
                   std::vector<int>& beam_nodes) {
        glm::ivec2 low(1 << 20);
        glm::ivec2 high(0);
        for (std::size_t i = 0; i < body.cells.size(); ++i) {
            if (body.cell_groups[i] != group) continue;
            low = glm::min(low, body.cells[i]);
            high = glm::max(high, body.cells[i]);
        }
        const glm::vec2 step = face_m / glm::vec2(glm::max(high - low + 1, glm::ivec2(1)));
        for (std::size_t i = 0; i < body.cells.size(); ++i) {
            if (body.cell_groups[i] != group) continue;
            const glm::vec2 place = (glm::vec2(body.cells[i] - low) + 0.5f) * step - 0.5f * face_m;
            const std::string name =
                body.cells.size() == 1
                    ? "Beam"
                    : "Beam " + (i < body.cell_names.size() ? body.cell_names[i] : std::to_string(i + 1));
            const int beam = add(name, parent, at(place.x, -place.y, z_m), GeometryKind::beam);
            Beam made = body.beam;
            made.luminous_flux_lm /= static_cast<float>(body.cells.size());
            made.power_w /= static_cast<float>(body.cells.size());
            made.beam_radius_m = std::clamp(0.4f * std::min(step.x, step.y), 0.002f, 0.5f);
            type_.geometries[static_cast<std::size_t>(beam)].beam = made;
            beam_nodes[i] = relative(beam);
        }
    }

    void turn_into_axis(int index) {
        type_.geometries[static_cast<std::size_t>(index)].kind = GeometryKind::axis;
    }

private:
    Type& type_;
    std::size_t first_;
};

glm::vec3 known_size(const Body& body) {
    const float otherwise = body.carriage == Carriage::fixed ? kFixed_m : kHead_m;
    glm::vec3 size = body.size_m;
    for (int k = 0; k < 3; ++k)
        size[k] = size[k] > 0.0f ? std::clamp(size[k], kSmallest_m, kLargest_m) : otherwise;
    return size;
}

// Base, yoke of a bar and two arms, head as a drum that hangs between them.
void build_heads(const Body& body, Carpenter& carpenter, int root, std::vector<int>& pans,
                 std::vector<int>& tilts, std::vector<int>& beams) {
    const glm::vec3 size = known_size(body);
    const float width = size.x / static_cast<float>(body.groups);
    const float depth = std::min(size.y, 1.2f * width);
    const float base = 0.17f * size.z;
    const float drop = 0.5f * size.z; // from the base to the tilt axis
    const float head = 0.55f * std::min(width, 1.5f * depth);
    const float length = 0.7f * size.z;
    carpenter.add_shape("Base", root, at(0, 0, -0.5f * base), "Cube", {size.x, 0.8f * depth, base});
    for (int group = 0; group < body.groups; ++group) {
        const std::string number = body.groups == 1 ? "" : " " + std::to_string(group + 1);
        const float x =
            (static_cast<float>(group) + 0.5f) * width - 0.5f * width * static_cast<float>(body.groups);
        const int yoke = carpenter.add("Yoke" + number, root, at(x, 0, -base));
        const float arm = 0.12f * width;
        const float arm_length = drop + 0.1f * size.z;
        carpenter.add_shape("Yoke bar" + number, yoke, at(0, 0, -0.5f * arm), "Cube",
                            {0.9f * width, 0.35f * depth, arm});
        for (const float side : {-1.0f, 1.0f})
            carpenter.add_shape(side < 0 ? "Yoke arm left" + number : "Yoke arm right" + number, yoke,
                                at(side * 0.39f * width, 0, -0.5f * arm_length), "Cube",
                                {arm, 0.35f * depth, arm_length});
        const int pivot = carpenter.add("Head" + number, yoke, at(0, 0, -drop));
        carpenter.add_shape("Head body" + number, pivot, glm::mat4(1.0f), "Cylinder", {head, head, length});
        if (body.pan) {
            carpenter.turn_into_axis(yoke);
            pans.push_back(carpenter.relative(yoke));
        }
        if (body.tilt) {
            carpenter.turn_into_axis(pivot);
            tilts.push_back(carpenter.relative(pivot));
        }
        carpenter.add_cells(body, group, pivot, glm::vec2(0.9f * head), -0.5f * length - 0.002f, beams);
    }
}

// A box with mirrors at its front end: the light starts at a mirror.
void build_scanner(const Body& body, Carpenter& carpenter, int root, std::vector<int>& pans,
                   std::vector<int>& tilts, std::vector<int>& beams) {
    const glm::vec3 size = known_size(body);
    const float mirror = 0.6f * std::min({size.x, size.y, size.z});
    carpenter.add_shape("Body", root, at(0, 0, -0.5f * size.z), "Cube", size);
    for (int group = 0; group < body.groups; ++group) {
        const std::string number = body.groups == 1 ? "" : " " + std::to_string(group + 1);
        const float share = (static_cast<float>(group) + 0.5f) / static_cast<float>(body.groups);
        const glm::mat4 place = at((share - 0.5f) * size.x, -0.5f * size.y - mirror, -0.5f * size.z);
        const int pan = carpenter.add("Pan" + number, root, place);
        const int tilt = carpenter.add("Mirror" + number, pan, glm::mat4(1.0f));
        const glm::mat4 slant = glm::rotate(at(0, 0, 0.4f * mirror), glm::radians(45.0f), glm::vec3(1, 0, 0));
        carpenter.add_shape("Mirror plate" + number, tilt, slant, "Cube", {mirror, mirror, kSmallest_m});
        if (body.pan) {
            carpenter.turn_into_axis(pan);
            pans.push_back(carpenter.relative(pan));
        }
        if (body.tilt) {
            carpenter.turn_into_axis(tilt);
            tilts.push_back(carpenter.relative(tilt));
        }
        carpenter.add_cells(body, group, tilt, glm::vec2(0.4f * mirror), 0.0f, beams);
    }
}

// The face is width by height, the light leaves along the depth.
void build_fixed(const Body& body, Carpenter& carpenter, int root, std::vector<int>& beams) {
    const glm::vec3 size = known_size(body);
    const bool round = body.cells.size() == 1 && size.x < 1.3f * size.z && size.z < 1.3f * size.x;
    carpenter.add_shape("Body", root, at(0, 0, -0.5f * size.y), round ? "Cylinder" : "Cube",
                        {size.x, size.z, size.y});
    carpenter.add_cells(body, 0, root, glm::vec2(size.x, size.z), -size.y - 0.002f, beams);
}

} // namespace

const TypeBuilder::Built& TypeBuilder::build(const Body& body) {
    for (const Built& known : built_)
        if (same(known.body, body)) return known;
    Built made;
    made.body = body;
    made.first = static_cast<int>(type_.geometries.size());
    made.beam_nodes.resize(body.cells.size(), -1);
    Carpenter carpenter(type_);
    const int root = carpenter.add("Fixture", -1, glm::mat4(1.0f));
    if (body.carriage == Carriage::head)
        build_heads(body, carpenter, root, made.pan_nodes, made.tilt_nodes, made.beam_nodes);
    else if (body.carriage == Carriage::mirror)
        build_scanner(body, carpenter, root, made.pan_nodes, made.tilt_nodes, made.beam_nodes);
    else
        build_fixed(body, carpenter, root, made.beam_nodes);
    made.count = static_cast<int>(type_.geometries.size()) - made.first;
    built_.push_back(std::move(made));
    return built_.back();
}

bool TypeBuilder::add_mode(ModeDraft draft) {
    Body& body = draft.body;
    CHECK(body.groups >= 1 && body.cells.size() <= kMaxCells);
    if (body.carriage == Carriage::fixed) {
        CHECK(!body.pan && !body.tilt);
        body.groups = 1;
    }
    body.cell_groups.resize(body.cells.size(), 0);
    for (int& group : body.cell_groups) group = std::clamp(group, 0, body.groups - 1);
    std::size_t functions = 0;
    std::size_t links = 0;
    for (const ChannelDraft& channel : draft.channels) {
        functions += channel.channel.functions.size();
        links += channel.cells.empty() ? body.cells.size() : channel.cells.size();
    }
    const std::size_t nodes =
        body.cells.size() + 8 * static_cast<std::size_t>(body.groups) + 4; // at most these are built
    if (nodes_made_ + nodes > kMaxBuiltNodes || functions_made_ + functions > kMaxBuiltFunctions ||
        links_made_ + links > kMaxBuiltLinks)
        return false;

    const Built built = build(body);
    Mode mode;
    mode.name = std::move(draft.name);
    mode.description = std::move(draft.description);
    for (int i = 0; i < built.count; ++i) {
        const Geometry& geometry = type_.geometries[static_cast<std::size_t>(built.first + i)];
        Node node;
        node.name = geometry.name;
        node.geometry = built.first + i;
        node.parent = geometry.parent < 0 ? -1 : geometry.parent - built.first;
        node.model = geometry.model;
        node.local = geometry.local;
        if (geometry.beam) mode.beams.push_back(i);
        if (geometry.model >= 0) mode.parts.push_back(i);
        mode.nodes.push_back(std::move(node));
    }
    // Mode::beams is in the order of nodes, cells are in the order of the file.
    std::vector<int> beam_of_cell(body.cells.size(), 0);
    for (std::size_t i = 0; i < body.cells.size(); ++i)
        beam_of_cell[i] = static_cast<int>(
            std::lower_bound(mode.beams.begin(), mode.beams.end(), built.beam_nodes[i]) - mode.beams.begin());

    // One channel for all groups turns several nodes: it becomes as many channels on the same bytes.
    std::vector<int> moved_to(draft.channels.size(), -1);
    std::vector<bool> is_last; // of Mode::channels
    for (std::size_t c = 0; c < draft.channels.size(); ++c) {
        ChannelDraft& source = draft.channels[c];
        bool pan = false;
        bool tilt = false;
        for (const ChannelFunction& function : source.channel.functions) {
            const Role role = function.meaning.role;
            pan |= role == Role::pan || role == Role::pan_rotate;
            tilt |= role == Role::tilt || role == Role::tilt_rotate;
        }
        std::vector<int> places{0};
        const std::vector<int>& axes = pan ? built.pan_nodes : built.tilt_nodes;
        if ((pan && body.pan) || (tilt && body.tilt)) {
            const int count = static_cast<int>(axes.size());
            places =
                source.group < 0
                    ? axes
                    : std::vector<int>{axes[static_cast<std::size_t>(std::min(source.group, count - 1))]};
        }
        std::vector<int> beams;
        for (const int cell : source.cells) {
            CHECK(cell >= 0 && static_cast<std::size_t>(cell) < beam_of_cell.size());
            beams.push_back(beam_of_cell[static_cast<std::size_t>(cell)]);
        }
        if (source.cells.empty()) {
            beams.resize(mode.beams.size());
            std::iota(beams.begin(), beams.end(), 0);
        }
        std::sort(beams.begin(), beams.end());
        beams.erase(std::unique(beams.begin(), beams.end()), beams.end());
        for (const int place : places) {
            Channel channel = source.channel;
            channel.node = place;
            channel.beams = beams;
            if (moved_to[c] < 0) moved_to[c] = static_cast<int>(mode.channels.size());
            mode.channels.push_back(std::move(channel));
            is_last.push_back(source.last);
        }
    }
    for (Channel& channel : mode.channels)
        for (ChannelFunction& function : channel.functions)
            if (function.master_channel >= 0)
                function.master_channel = moved_to[static_cast<std::size_t>(function.master_channel)];
    for (const int node : built.pan_nodes) mode.axes.push_back({node, true});
    for (const int node : built.tilt_nodes) mode.axes.push_back({node, false});
    std::stable_sort(mode.axes.begin(), mode.axes.end(), [](Axis a, Axis b) { return a.node < b.node; });
    mode.order.resize(mode.channels.size());
    std::iota(mode.order.begin(), mode.order.end(), 0);
    std::stable_partition(mode.order.begin(), mode.order.end(),
                          [&](int index) { return !is_last[static_cast<std::size_t>(index)]; });
    if (draft.footprint > 0) mode.footprint = {draft.footprint};
    nodes_made_ += mode.nodes.size();
    functions_made_ += functions;
    links_made_ += links;
    type_.modes.push_back(std::move(mode));
    return true;
}

int TypeBuilder::add_emitter(const std::string& name, const ColorCie& color) {
    const auto [known, is_new] =
        emitters_.try_emplace({name, color.x, color.y, color.Y}, static_cast<int>(type_.emitters.size()));
    if (is_new) {
        Emitter emitter;
        emitter.name = name;
        emitter.color = color;
        type_.emitters.push_back(std::move(emitter));
    }
    return known->second;
}

ChannelFunction make_function(const std::string& attribute, std::uint32_t dmx_from, std::uint32_t dmx_to,
                              float physical_from, float physical_to) {
    ChannelFunction function;
    function.name = attribute;
    function.attribute = attribute;
    function.meaning = attribute_from(attribute);
    function.dmx_from = dmx_from;
    function.dmx_to = dmx_to;
    function.dmx_default = dmx_from;
    function.physical_from = physical_from;
    function.physical_to = physical_to;
    return function;
}

void widen(ChannelFunction& function, int from_bytes, int to_bytes) {
    const int shift = 8 * (to_bytes - from_bytes);
    CHECK(shift >= 0 && shift <= 24);
    if (shift == 0) return;
    const auto low = [shift](std::uint32_t value) { return value << shift; };
    const auto high = [shift](std::uint32_t value) { return (value << shift) | ((1u << shift) - 1u); };
    function.dmx_from = low(function.dmx_from);
    function.dmx_to = high(function.dmx_to);
    function.dmx_default = low(function.dmx_default);
    for (ChannelSet& set : function.sets) {
        set.dmx_from = low(set.dmx_from);
        set.dmx_to = high(set.dmx_to);
    }
}

bool is_shown(const ChannelFunction& function) {
    return function.meaning.role != Role::none;
}

} // namespace ghost::fixture
