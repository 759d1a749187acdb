// SPDX-License-Identifier: Apache-2.0
// Layers and the tree of objects of an MVR description.
#include "mvr/private/mvr_reader.h"

#include "mvr/private/mvr_values.h"

#include <array>
#include <utility>

namespace ghost::scene {
namespace {

constexpr std::array kKinds = {ObjectKind::scene_object, ObjectKind::group,    ObjectKind::focus_point,
                               ObjectKind::fixture,      ObjectKind::support,  ObjectKind::truss,
                               ObjectKind::video_screen, ObjectKind::projector};

std::optional<ObjectKind> kind_of(std::string_view tag) {
    for (const ObjectKind kind : kKinds)
        if (tag == tag_of(kind)) return kind;
    return std::nullopt;
}

class ObjectReader {
public:
    explicit ObjectReader(MvrReader& reader) : reader_(reader) {}

    void layers(pugi::xml_node list);

private:
    void layer(pugi::xml_node node, bool implied);
    void child_list(pugi::xml_node list, int layer, int parent, int depth);
    void object(pugi::xml_node node, ObjectKind kind, int layer, int parent, int depth);
    void content(pugi::xml_node node, PlotObject& object);
    void place(pugi::xml_node node, PlotObject& object);

    MvrReader& reader_;
};

void ObjectReader::layers(pugi::xml_node list) {
    pugi::xml_node loose;
    for (const pugi::xml_node node : list.children()) {
        const std::string_view tag = node.name();
        if (tag == "Layer")
            layer(node, false);
        else if (tag == "ChildList" || kind_of(tag))
            loose = loose ? loose : node;
        else
            reader_.unknown(node);
    }
    if (!loose) return;
    reader_.say(Severity::warning, loose,
                "these objects are in no Layer; they are put in one without a name");
    layer(list, true);
}

void ObjectReader::layer(pugi::xml_node node, bool implied) {
    PlotLayer layer;
    layer.implied = implied;
    layer.line = reader_.line_of(node);
    if (!implied) {
        layer.uuid = reader_.attribute(node, "uuid");
        layer.name = reader_.attribute(node, "name");
        if (const auto matrix = reader_.matrix(node))
            layer.local = *matrix;
        else
            layer.placed_by = PlacedBy::nobody;
    }
    reader_.plot().layers.push_back(std::move(layer));
    const int index = static_cast<int>(reader_.plot().layers.size()) - 1;
    if (implied) {
        child_list(node, index, -1, 0);
        return;
    }
    for (const pugi::xml_node child : node.children()) {
        const std::string_view tag = child.name();
        if (tag == "ChildList")
            child_list(child, index, -1, 0);
        else if (const auto kind = kind_of(tag))
            object(child, *kind, index, -1, 0);
        else if (tag != "Matrix")
            reader_.unknown(child);
    }
}

void ObjectReader::child_list(pugi::xml_node list, int layer, int parent, int depth) {
    for (const pugi::xml_node child : list.children()) {
        if (reader_.cancelled()) return;
        const std::string_view tag = child.name();
        if (const auto kind = kind_of(tag))
            object(child, *kind, layer, parent, depth);
        else if (tag == "ChildList" && depth < kMaxMvrDepth)
            child_list(child, layer, parent, depth + 1);
        else if (tag != "Layer")
            reader_.unknown(child);
    }
}

void ObjectReader::place(pugi::xml_node node, PlotObject& object) {
    const Plot& plot = reader_.plot();
    glm::dmat4 to_world(1.0);
    if (object.parent >= 0)
        to_world = plot.objects[static_cast<std::size_t>(object.parent)].world;
    else if (object.layer >= 0)
        to_world = plot.layers[static_cast<std::size_t>(object.layer)].local;
    object.world = to_world * object.local;
    if (is_usable(object.world)) return;
    reader_.say(Severity::error, node,
                "lies further away than any stage, or is larger; it stays at the origin of what it hangs on");
    object.placed_by = object.turned_by = PlacedBy::nobody;
    object.local = glm::dmat4(1.0);
    object.world = to_world;
}

void ObjectReader::content(pugi::xml_node node, PlotObject& object) {
    for (const pugi::xml_node child : node.children()) {
        const std::string_view tag = child.name();
        if (tag.empty() || tag == "Matrix" || tag == "ChildList" || kind_of(tag)) continue;
        if (tag == "Classing") {
            object.class_uuid = reader_.text(child);
        } else if (tag == "Geometries") {
            object.geometries = reader_.geometries(child);
        } else if (tag == "ChainLength") {
            object.chain_length = reader_.number(child, reader_.text(child), 0);
        } else if (tag == "Sources") {
            object.sources = reader_.sources(child);
        } else if (tag == "Projections") {
            for (const pugi::xml_node projection : child.children("Projection"))
                if (reader_.take_part(projection))
                    object.projections.push_back({reader_.sources(projection), reader_.scale(projection)});
        } else if (!read_device_part(reader_, child, object.device)) {
            reader_.unknown(child);
        }
    }
}

void ObjectReader::object(pugi::xml_node node, ObjectKind kind, int layer, int parent, int depth) {
    reader_.tick(node);
    if (reader_.cancelled()) return;
    Plot& plot = reader_.plot();
    if (depth >= kMaxMvrDepth || plot.objects.size() >= kMaxMvrObjects) {
        reader_.say(Severity::error, node,
                    depth >= kMaxMvrDepth
                        ? "objects in objects more than " + std::to_string(kMaxMvrDepth) + " deep; left out"
                        : "more than " + std::to_string(kMaxMvrObjects) + " objects; the rest is left out");
        return;
    }
    PlotObject object;
    object.kind = kind;
    object.uuid = reader_.attribute(node, "uuid");
    object.name = reader_.attribute(node, "name");
    object.layer = layer;
    object.parent = parent;
    object.line = reader_.line_of(node);
    object.element = node.offset_debug();
    object.device.multipatch_uuid = reader_.attribute(node, "multipatch");
    if (const auto matrix = reader_.matrix(node))
        object.local = *matrix;
    else
        object.placed_by = object.turned_by = PlacedBy::nobody;
    place(node, object);
    content(node, object);

    const int index = static_cast<int>(plot.objects.size());
    const std::string key = uuid_key(object.uuid);
    if (key.empty())
        reader_.say(Severity::warning, node,
                    "object without a uuid: changes of it cannot be kept when the plot comes again");
    else if (!reader_.object_index.emplace(key, index).second)
        reader_.say(Severity::warning, node,
                    "another object has the uuid of this one; links and changes mean the first");
    plot.objects.push_back(std::move(object));
    reader_.object_nodes.push_back(node);
    if (parent >= 0)
        plot.objects[static_cast<std::size_t>(parent)].children.push_back(index);
    else
        plot.layers[static_cast<std::size_t>(layer)].objects.push_back(index);

    for (const pugi::xml_node child : node.children()) {
        if (std::string_view(child.name()) == "ChildList")
            child_list(child, layer, index, depth + 1);
        else if (const auto child_kind = kind_of(child.name()))
            this->object(child, *child_kind, layer, index, depth + 1);
    }
}

} // namespace

void read_layers(MvrReader& reader, pugi::xml_node scene) {
    ObjectReader objects(reader);
    if (!scene.child("Layers"))
        reader.say(Severity::error, scene, "there is no Layers element: the plot has no objects");
    for (const pugi::xml_node layers : scene.children("Layers")) objects.layers(layers);
}

} // namespace ghost::scene
