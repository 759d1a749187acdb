// SPDX-License-Identifier: Apache-2.0
// AUXData of an MVR description: symbols, classes, hanging positions, mapping definitions.
#include "mvr/private/mvr_reader.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace ghost::scene {
namespace {

PlotName read_name(MvrReader& reader, pugi::xml_node node) {
    return {reader.attribute(node, "uuid"), reader.attribute(node, "name"), reader.line_of(node)};
}

void read_symdef(MvrReader& reader, pugi::xml_node node) {
    Plot& plot = reader.plot();
    if (plot.symbols.size() >= kMaxMvrSymbols) {
        reader.say(Severity::error, node,
                   "more than " + std::to_string(kMaxMvrSymbols) + " symbols; the rest is left out");
        return;
    }
    const PlotName name = read_name(reader, node);
    const std::string key = uuid_key(name.uuid);
    if (key.empty() || !reader.symbol_index.emplace(key, static_cast<int>(plot.symbols.size())).second)
        reader.say(Severity::warning, node,
                   key.empty() ? "Symdef without a uuid: nothing can use it"
                               : "another Symdef has the uuid of this one; symbols mean the first");
    plot.symbols.push_back({name.uuid, name.name, {}, name.line});
    reader.symbol_nodes.push_back(node);
}

void read_mapping_definition(MvrReader& reader, pugi::xml_node node) {
    PlotMappingDefinition definition;
    definition.uuid = reader.attribute(node, "uuid");
    definition.name = reader.attribute(node, "name");
    definition.line = reader.line_of(node);
    definition.size_x = reader.integer(node.child("SizeX"), 0);
    definition.size_y = reader.integer(node.child("SizeY"), 0);
    definition.scale = reader.scale(node);
    std::vector<PlotSource> sources = reader.sources(node);
    if (!sources.empty()) definition.source = std::move(sources.front());
    if (definition.size_x <= 0 || definition.size_y <= 0)
        reader.say(Severity::warning, node, "a mapping definition needs SizeX and SizeY above 0");
    reader.plot().mapping_definitions.push_back(std::move(definition));
}

// Takes the symbols apart in thought: how many geometries each one is, and what closes a circle.
class SymbolCutter {
public:
    explicit SymbolCutter(MvrReader& reader)
        : reader_(reader), cost_(reader.plot().symbols.size()), height_(cost_.size()), state_(cost_.size()) {}

    void all() {
        for (std::size_t i = 0; i < cost_.size(); ++i) visit(i, 0);
        std::size_t total = 0;
        for (std::size_t i = 0; i < reader_.plot().objects.size(); ++i) {
            for (PlotGeometry& geometry : reader_.plot().objects[i].geometries) {
                const std::size_t cost =
                    geometry.symbol >= 0 ? cost_[static_cast<std::size_t>(geometry.symbol)] : 1;
                if (cost <= kMaxMeshInstances - total) {
                    total += cost;
                    continue;
                }
                reader_.say(Severity::error, reader_.object_nodes[i],
                            "more than " + std::to_string(kMaxMeshInstances) +
                                " geometries with all symbols taken apart; what goes beyond is left out");
                geometry.symbol = -1;
                geometry.mesh = -1;
            }
        }
    }

private:
    enum class State { fresh, open, done };

    void visit(std::size_t symbol, int depth) {
        if (state_[symbol] != State::fresh) return;
        state_[symbol] = State::open;
        std::size_t cost = 1;
        int height = 1;
        for (PlotGeometry& geometry : reader_.plot().symbols[symbol].geometries) {
            cost = std::min(cost + 1, kMaxMeshInstances + 1);
            if (geometry.symbol < 0) continue;
            const auto inner = static_cast<std::size_t>(geometry.symbol);
            const bool circle = state_[inner] == State::open;
            if (!circle && depth < kMaxMvrDepth) visit(inner, depth + 1);
            if (circle || state_[inner] != State::done || height_[inner] >= kMaxMvrDepth) {
                reader_.say(Severity::error, reader_.symbol_nodes[symbol],
                            circle ? std::string("this symbol contains itself; the circle is cut here")
                                   : "symbols in symbols more than " + std::to_string(kMaxMvrDepth) +
                                         " deep; what lies deeper is left out");
                geometry.symbol = -1;
                continue;
            }
            cost = std::min(cost + cost_[inner], kMaxMeshInstances + 1);
            height = std::max(height, height_[inner] + 1);
        }
        cost_[symbol] = cost;
        height_[symbol] = height;
        state_[symbol] = State::done;
    }

    MvrReader& reader_;
    std::vector<std::size_t> cost_;
    std::vector<int> height_;
    std::vector<State> state_;
};

} // namespace

void read_auxiliary(MvrReader& reader, pugi::xml_node scene) {
    for (const pugi::xml_node auxiliary : scene.children("AUXData"))
        for (const pugi::xml_node node : auxiliary.children()) {
            const std::string_view tag = node.name();
            if (tag == "Symdef") {
                read_symdef(reader, node);
            } else if (tag == "Class") {
                if (reader.take_part(node)) reader.plot().classes.push_back(read_name(reader, node));
            } else if (tag == "Position") {
                if (reader.take_part(node)) reader.plot().positions.push_back(read_name(reader, node));
            } else if (tag == "MappingDefinition") {
                if (reader.take_part(node)) read_mapping_definition(reader, node);
            } else {
                reader.unknown(node);
            }
        }
    // All symbols first: one may use another that stands below it.
    for (std::size_t i = 0; i < reader.symbol_nodes.size(); ++i) {
        const pugi::xml_node node = reader.symbol_nodes[i];
        const pugi::xml_node list = node.child("ChildList");
        if (!list && node.first_child())
            reader.say(Severity::note, node,
                       "Symdef without a ChildList; its geometries are read all the same");
        reader.plot().symbols[i].geometries = reader.geometries(list ? list : node);
    }
}

void cut_symbols(MvrReader& reader) {
    SymbolCutter(reader).all();
}

} // namespace ghost::scene
