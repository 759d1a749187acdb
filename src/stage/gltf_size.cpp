// SPDX-License-Identifier: Apache-2.0
// glTF 2.0 lets a few bytes ask for gigabytes: accessors without data, accessors and nodes that are used many
// times over. And Assimp and its JSON reader go down into lists and nodes by recursion.
#include "stage/model_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

namespace ghost::scene {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMaxJsonItems = 4u << 20; // of the JSON: members and elements, for Assimp's reader
constexpr std::size_t kMaxNesting = kGltfJson.depth;
constexpr std::size_t kMaxNodes = 200'000; // of a scene; each is 1.5 kB of Assimp's
constexpr std::size_t kMaxNodeDepth = 256;
constexpr std::size_t kMaxUnpackedBytes = std::size_t{1} << 30; // as Assimp keeps it

std::string fault_of_text(std::string_view text) {
    std::size_t items = 0, nesting = 0;
    bool in_string = false;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const char letter = text[k];
        if (letter == '"') in_string = !in_string;
        if (in_string) {
            k += letter == '\\' ? 1 : 0;
            continue;
        }
        if (letter == '[' || letter == '{') {
            if (++nesting > kMaxNesting)
                return "has lists and objects more than " + std::to_string(kMaxNesting) +
                       " deep in each other";
        } else if ((letter == ']' || letter == '}') && nesting > 0) {
            --nesting;
        }
        if ((letter == '[' || letter == '{' || letter == ',') && ++items > kMaxJsonItems)
            return "lists more than " + std::to_string(kMaxJsonItems) + " things";
    }
    return "";
}

const Json& member(const Json& json, const char* key) {
    static const Json none;
    if (!json.is_object()) return none;
    const auto found = json.find(key);
    return found == json.end() ? none : *found;
}

std::size_t index_of(const Json& json) {
    return json.is_number_unsigned() ? json.get<std::size_t>() : static_cast<std::size_t>(-1);
}

// What Assimp keeps of a node tree: one node for every way that leads to it.
class NodeTree {
public:
    explicit NodeTree(const Json& nodes) : nodes_(nodes), found_(nodes.size()) {}

    std::string fault(const Json& scenes) {
        for (std::size_t k = 0; k < found_.size(); ++k)
            if (!visit(k))
                return "has nodes that hold themselves, or more than " + std::to_string(kMaxNodeDepth) +
                       " in each other";
        for (const Json& scene : scenes) {
            std::size_t count = 0;
            for (const Json& root : member(scene, "nodes"))
                if (index_of(root) < found_.size()) count += found_[index_of(root)].count;
            if (count > kMaxNodes) return "has a scene of more than " + std::to_string(kMaxNodes) + " nodes";
        }
        return "";
    }

private:
    struct Found {
        std::size_t count = 0; // with all below it; 0: not yet visited
        std::size_t depth = 0;
    };

    // False: goes too deep, which a circle does, too.
    bool visit(std::size_t node, std::size_t level = 1) {
        if (level > kMaxNodeDepth) return false;
        Found& found = found_[node];
        if (found.count > 0) return level + found.depth <= kMaxNodeDepth + 1;
        Found sum{1, 1};
        for (const Json& child : member(nodes_[node], "children")) {
            const std::size_t index = index_of(child);
            if (index >= found_.size()) continue;
            if (!visit(index, level + 1)) return false;
            sum.count = std::min(sum.count + found_[index].count, kMaxNodes + 1);
            sum.depth = std::max(sum.depth, found_[index].depth + 1);
        }
        found = sum;
        return true;
    }

    const Json& nodes_;
    std::vector<Found> found_;
};

// Bytes that the meshes and animations take once they are unpacked, each as often as it is used.
class Unpacked {
public:
    explicit Unpacked(const Json& document) : accessors_(member(document, "accessors")) {
        for (const Json& mesh : member(document, "meshes"))
            for (const Json& primitive : member(mesh, "primitives")) add_primitive(primitive);
        for (const Json& animation : member(document, "animations"))
            for (const Json& sampler : member(animation, "samplers"))
                for (const char* key : {"input", "output"}) add(count_of(member(sampler, key)), kKeyBytes);
        for (const Json& skin : member(document, "skins"))
            add(count_of(member(skin, "inverseBindMatrices")), 16 * sizeof(float));
    }
    std::size_t bytes() const { return bytes_; }

private:
    static constexpr std::size_t kKeyBytes = 32;
    static constexpr std::size_t kFaceBytes = 48; // aiFace and its own small array
    static constexpr std::size_t kVertexBytes = 16;

    void add_primitive(const Json& primitive) {
        const Json& attributes = member(primitive, "attributes");
        for (const Json& attribute : attributes) add(count_of(attribute), kVertexBytes);
        for (const Json& target : member(primitive, "targets"))
            for (const Json& attribute : target) add(count_of(attribute), kVertexBytes);
        const Json& indices = member(primitive, "indices");
        const Json& mode = member(primitive, "mode");
        const bool is_list = mode.is_null() || index_of(mode) == kGltfTriangles;
        add(count_of(indices.is_null() ? member(attributes, "POSITION") : indices),
            is_list ? kFaceBytes / 3 : kFaceBytes);
    }

    std::size_t count_of(const Json& accessor) const {
        const std::size_t index = index_of(accessor);
        if (!accessors_.is_array() || index >= accessors_.size()) return 0;
        const Json& count = member(accessors_[index], "count");
        return count.is_number_unsigned() ? count.get<std::size_t>() : 0;
    }

    void add(std::size_t count, std::size_t bytes_each) {
        bytes_ += std::min(count, kMaxUnpackedBytes) * bytes_each; // 4 million times 2^36: no overflow
    }

    const Json& accessors_;
    std::size_t bytes_ = 0;
};

// Assimp copies sparse values without looking whether their views hold so many.
class SparseValues {
public:
    explicit SparseValues(const Json& document)
        : views_(member(document, "bufferViews")), buffers_(member(document, "buffers")) {}

    bool fit(const Json& accessor) const {
        const Json& sparse = member(accessor, "sparse");
        if (sparse.is_null()) return true;
        const std::size_t count = number_of(member(sparse, "count"));
        const Json& indices = member(sparse, "indices");
        const std::size_t value_bytes = component_bytes(accessor) * components(member(accessor, "type"));
        return count <= number_of(member(accessor, "count")) && value_bytes > 0 &&
               holds(indices, count, component_bytes(indices)) &&
               holds(member(sparse, "values"), count, value_bytes);
    }

private:
    static std::size_t number_of(const Json& json) {
        return json.is_number_unsigned() ? json.get<std::size_t>() : 0;
    }
    static std::size_t component_bytes(const Json& of) {
        switch (number_of(member(of, "componentType"))) {
        case 5120:
        case 5121:
            return 1;
        case 5122:
        case 5123:
            return 2;
        case 5125:
        case 5126:
            return 4;
        default:
            return 0;
        }
    }
    static std::size_t components(const Json& type) {
        constexpr std::pair<const char*, std::size_t> kTypes[] = {
            {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}};
        for (const auto& [name, count] : kTypes)
            if (type == name) return count;
        return 0;
    }
    bool holds(const Json& part, std::size_t count, std::size_t bytes_each) const {
        const std::size_t index = index_of(member(part, "bufferView"));
        if (!views_.is_array() || index >= views_.size() || bytes_each == 0) return false;
        const Json& view = views_[index];
        const std::size_t buffer = index_of(member(view, "buffer"));
        if (!buffers_.is_array() || buffer >= buffers_.size()) return false;
        const std::size_t view_bytes = number_of(member(view, "byteLength"));
        const std::size_t view_offset = number_of(member(view, "byteOffset"));
        const std::size_t buffer_bytes = number_of(member(buffers_[buffer], "byteLength"));
        const std::size_t offset = number_of(member(part, "byteOffset"));
        return view_offset <= buffer_bytes && view_bytes <= buffer_bytes - view_offset &&
               offset <= view_bytes && count <= (view_bytes - offset) / bytes_each;
    }

    const Json& views_;
    const Json& buffers_;
};

} // namespace

Result<void> check_gltf_size(std::string_view text, const std::string& name) {
    if (std::string fault = fault_of_text(text); !fault.empty()) return Error{std::move(fault), name};
    TRY(const Json document, read_json(text, name, kGltfJson));
    if (!document.is_object()) return {}; // the reader says what is wrong with it
    const Json& nodes = member(document, "nodes");
    if (nodes.is_array())
        if (std::string fault = NodeTree(nodes).fault(member(document, "scenes")); !fault.empty())
            return Error{std::move(fault), name};
    const SparseValues sparse_values(document);
    const Json& accessors = member(document, "accessors");
    for (std::size_t k = 0; accessors.is_array() && k < accessors.size(); ++k)
        if (!sparse_values.fit(accessors[k]))
            return Error{"accessor " + std::to_string(k) +
                             " has sparse values that their buffer views do not hold",
                         name};
    if (const std::size_t bytes = Unpacked(document).bytes(); bytes > kMaxUnpackedBytes)
        return Error{"unpacks to " + std::to_string(bytes >> 20) +
                         " MiB of vertices and triangles, at most " +
                         std::to_string(kMaxUnpackedBytes >> 20) + " are allowed",
                     name};
    return {};
}

} // namespace ghost::scene
