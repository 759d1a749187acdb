// SPDX-License-Identifier: Apache-2.0
#include "stage/model_wire.h"

#include "image/finite.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>

namespace ghost::scene {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{8} << 30; // of a model
constexpr std::size_t kMaxItems = 4'000'000;            // textures, materials, meshes, instances
constexpr std::size_t kMaxMessages = 100'000;
constexpr std::size_t kMaxTextBytes = std::size_t{1} << 20;
constexpr std::size_t kStepBytes = std::size_t{16} << 20;    // what is not there yet takes no more memory ..
constexpr std::size_t kAtOnceBytes = std::size_t{256} << 20; // .. and no more of the address space
constexpr int kMaxSide_px = 16'384;

Error gone() {
    return {"ended before its answer was whole", ""};
}

Error broken(const std::string& what) {
    return {"gave a wrong answer: " + what, ""};
}

template <class Value>
Bytes bytes_of(const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    return {reinterpret_cast<const std::uint8_t*>(&value), sizeof value};
}

template <class Item>
void send_items(const SendBytes& send, const std::vector<Item>& items) {
    static_assert(std::is_trivially_copyable_v<Item>);
    send_number(send, items.size());
    send({reinterpret_cast<const std::uint8_t*>(items.data()), items.size() * sizeof(Item)});
}

// The numbers of a material, without its name.
struct PlainMaterial {
    glm::vec3 base_colour, emission;
    float alpha, roughness, metalness, specular, normal_scale, alpha_cutoff;
    std::int32_t base_texture, normal_texture, surface_texture, emission_texture, alpha_mode, double_sided;
};

class Receiver {
public:
    explicit Receiver(const ReceiveBytes& receive) : receive_(receive) {}

    Result<Stage> stage() {
        Stage stage;
        TRY(const std::size_t textures, count());
        for (std::size_t k = 0; k < textures; ++k) {
            TRY(Texture texture, this->texture());
            stage.textures.push_back(std::move(texture));
        }
        TRY(const std::size_t materials, count());
        for (std::size_t k = 0; k < materials; ++k) {
            TRY(Material material, this->material(textures));
            stage.materials.push_back(std::move(material));
        }
        TRY(const std::size_t meshes, count());
        for (std::size_t k = 0; k < meshes; ++k) {
            TRY(Mesh mesh, this->mesh(materials));
            stage.meshes.push_back(std::move(mesh));
        }
        TRY(const std::size_t instances, count());
        for (std::size_t k = 0; k < instances; ++k) {
            TRY(Instance instance, this->instance(meshes));
            stage.instances.push_back(std::move(instance));
        }
        return stage;
    }

    Result<std::string> text() { return receive_text(receive_, kMaxTextBytes); }
    Result<std::size_t> count() { return receive_number(receive_, kMaxItems); }

    template <class Item>
    Result<std::vector<Item>> items() {
        TRY(const std::size_t count, receive_number(receive_, left_ / sizeof(Item)));
        left_ -= count * sizeof(Item);
        std::vector<Item> items;
        items.reserve(std::min(count, kAtOnceBytes / sizeof(Item)));
        while (items.size() < count) {
            const std::size_t at = items.size();
            items.resize(std::min(count, at + kStepBytes / sizeof(Item)));
            if (!receive_(
                    {reinterpret_cast<std::uint8_t*>(items.data() + at), (items.size() - at) * sizeof(Item)}))
                return gone();
        }
        return items;
    }

private:
    template <class Value>
    bool plain(Value& value) {
        static_assert(std::is_trivially_copyable_v<Value>);
        return receive_({reinterpret_cast<std::uint8_t*>(&value), sizeof value});
    }

    Result<Texture> texture() {
        Texture texture;
        TRY(texture.name, text());
        std::array<std::int32_t, 4> shape{};
        if (!plain(shape)) return gone();
        TRY(texture.pixels.samples, items<std::uint8_t>());
        const auto [width, height, channels, is_colour] = shape;
        if (width < 1 || height < 1 || width > kMaxSide_px || height > kMaxSide_px || channels < 1 ||
            channels > 4 ||
            texture.pixels.samples.size() != static_cast<std::size_t>(width) *
                                                 static_cast<std::size_t>(height) *
                                                 static_cast<std::size_t>(channels))
            return broken("a picture without its pixels");
        texture.pixels.width = width;
        texture.pixels.height = height;
        texture.pixels.channels = channels;
        texture.is_colour = is_colour != 0;
        return texture;
    }

    Result<Material> material(std::size_t textures) {
        Material material;
        TRY(material.name, text());
        PlainMaterial plain_one{};
        if (!plain(plain_one)) return gone();
        for (const int texture : {plain_one.base_texture, plain_one.normal_texture, plain_one.surface_texture,
                                  plain_one.emission_texture})
            if (texture < kNone || texture >= static_cast<int>(textures))
                return broken("a picture that is not there");
        if (plain_one.alpha_mode < 0 || plain_one.alpha_mode > static_cast<int>(AlphaMode::blend))
            return broken("a way of being transparent that does not exist");
        const float numbers[] = {plain_one.base_colour.x + plain_one.base_colour.y + plain_one.base_colour.z,
                                 plain_one.emission.x + plain_one.emission.y + plain_one.emission.z,
                                 plain_one.alpha,
                                 plain_one.roughness,
                                 plain_one.metalness,
                                 plain_one.specular,
                                 plain_one.normal_scale,
                                 plain_one.alpha_cutoff};
        for (const float number : numbers)
            if (!std::isfinite(number)) return broken("a material that is no number");
        material.base_colour = plain_one.base_colour;
        material.emission = plain_one.emission;
        material.alpha = plain_one.alpha;
        material.roughness = plain_one.roughness;
        material.metalness = plain_one.metalness;
        material.specular = plain_one.specular;
        material.normal_scale = plain_one.normal_scale;
        material.alpha_cutoff = plain_one.alpha_cutoff;
        material.base_texture = plain_one.base_texture;
        material.normal_texture = plain_one.normal_texture;
        material.surface_texture = plain_one.surface_texture;
        material.emission_texture = plain_one.emission_texture;
        material.alpha_mode = static_cast<AlphaMode>(plain_one.alpha_mode);
        material.double_sided = plain_one.double_sided != 0;
        return material;
    }

    Result<Mesh> mesh(std::size_t materials) {
        Mesh mesh;
        TRY(mesh.name, text());
        std::int32_t material = 0;
        if (!plain(material)) return gone();
        TRY(mesh.positions, items<glm::vec3>());
        TRY(mesh.normals, items<glm::vec3>());
        TRY(mesh.tangents, items<glm::vec4>());
        TRY(mesh.uvs, items<glm::vec2>());
        TRY(mesh.indices, items<std::uint32_t>());
        const std::size_t points = mesh.positions.size();
        if (material < 0 || static_cast<std::size_t>(material) >= materials)
            return broken("a material that is not there");
        if (mesh.normals.size() != points || (!mesh.tangents.empty() && mesh.tangents.size() != points) ||
            (!mesh.uvs.empty() && mesh.uvs.size() != points) || mesh.indices.size() % 3 != 0)
            return broken("a mesh whose lists differ in length");
        for (const std::uint32_t index : mesh.indices)
            if (index >= points) return broken("a point that is not there");
        for (std::size_t k = 0; k < points; ++k) {
            const glm::vec3 nothing = 0.0f * mesh.positions[k] + 0.0f * mesh.normals[k];
            if (nothing != glm::vec3(0.0f)) return broken("a point that is no number");
        }
        mesh.material = material;
        return mesh;
    }

    Result<Instance> instance(std::size_t meshes) {
        Instance instance;
        TRY(instance.name, text());
        std::int32_t mesh = 0;
        if (!plain(mesh) || !plain(instance.world)) return gone();
        if (mesh < 0 || static_cast<std::size_t>(mesh) >= meshes) return broken("a mesh that is not there");
        if (!image::is_finite(instance.world)) return broken("a place that is no number");
        instance.mesh = mesh;
        return instance;
    }

    const ReceiveBytes& receive_;
    std::size_t left_ = kMaxBytes;
};

void send_stage(const SendBytes& send, const Stage& stage) {
    send_number(send, stage.textures.size());
    for (const Texture& texture : stage.textures) {
        send_text(send, texture.name);
        const image::Image8& pixels = texture.pixels;
        send(bytes_of(
            std::array<std::int32_t, 4>{pixels.width, pixels.height, pixels.channels, texture.is_colour}));
        send_items(send, pixels.samples);
    }
    send_number(send, stage.materials.size());
    for (const Material& m : stage.materials) {
        send_text(send, m.name);
        send(bytes_of(PlainMaterial{m.base_colour, m.emission, m.alpha, m.roughness, m.metalness, m.specular,
                                    m.normal_scale, m.alpha_cutoff, m.base_texture, m.normal_texture,
                                    m.surface_texture, m.emission_texture, static_cast<int>(m.alpha_mode),
                                    m.double_sided}));
    }
    send_number(send, stage.meshes.size());
    for (const Mesh& mesh : stage.meshes) {
        send_text(send, mesh.name);
        send(bytes_of(std::int32_t{mesh.material}));
        send_items(send, mesh.positions);
        send_items(send, mesh.normals);
        send_items(send, mesh.tangents);
        send_items(send, mesh.uvs);
        send_items(send, mesh.indices);
    }
    send_number(send, stage.instances.size());
    for (const Instance& instance : stage.instances) {
        send_text(send, instance.name);
        send(bytes_of(std::int32_t{instance.mesh}));
        send(bytes_of(instance.world));
    }
}

} // namespace

void send_number(const SendBytes& send, std::uint64_t number) {
    send(bytes_of(number));
}

void send_text(const SendBytes& send, std::string_view text) {
    const std::string_view sent = text.substr(0, kMaxTextBytes);
    send_number(send, sent.size());
    send({reinterpret_cast<const std::uint8_t*>(sent.data()), sent.size()});
}

void send_model(const SendBytes& send, const Result<Stage>& model, const Report& report) {
    send_number(send, model.ok() ? 1 : 0);
    if (model.ok()) {
        send_stage(send, *model);
    } else {
        send_text(send, model.error().what);
        send_text(send, model.error().where);
    }
    const std::size_t messages = std::min(report.messages.size(), kMaxMessages);
    send_number(send, messages);
    for (std::size_t k = 0; k < messages; ++k) {
        const Message& message = report.messages[k];
        send_number(send, static_cast<std::uint64_t>(message.severity));
        send_text(send, message.where);
        send_text(send, message.what);
    }
}

Result<std::uint64_t> receive_number(const ReceiveBytes& receive, std::uint64_t most) {
    std::uint64_t number = 0;
    if (!receive({reinterpret_cast<std::uint8_t*>(&number), sizeof number})) return gone();
    if (number > most)
        return broken(std::to_string(number) + " where at most " + std::to_string(most) + " can be");
    return number;
}

Result<std::vector<std::uint8_t>> receive_bytes(const ReceiveBytes& receive, std::size_t most_bytes) {
    TRY(const std::size_t count, receive_number(receive, most_bytes));
    std::vector<std::uint8_t> bytes;
    while (bytes.size() < count) {
        const std::size_t at = bytes.size();
        bytes.resize(std::min(count, at + kStepBytes));
        if (!receive(std::span(bytes).subspan(at))) return gone();
    }
    return bytes;
}

Result<std::string> receive_text(const ReceiveBytes& receive, std::size_t most_bytes) {
    TRY(const auto bytes, receive_bytes(receive, most_bytes));
    return std::string(bytes.begin(), bytes.end());
}

Result<ReceivedModel> receive_model(const ReceiveBytes& receive) {
    Receiver receiver(receive);
    ReceivedModel received;
    TRY(const std::uint64_t ok, receive_number(receive, 1));
    if (ok) {
        TRY(received.model, receiver.stage());
    } else {
        Error error;
        TRY(error.what, receiver.text());
        TRY(error.where, receiver.text());
        received.model = std::move(error);
    }
    TRY(const std::size_t messages, receive_number(receive, kMaxMessages));
    for (std::size_t k = 0; k < messages; ++k) {
        TRY(const std::uint64_t severity,
            receive_number(receive, static_cast<std::uint64_t>(Severity::error)));
        TRY(std::string where, receiver.text());
        TRY(std::string what, receiver.text());
        received.report.add(static_cast<Severity>(severity), std::move(where), std::move(what));
    }
    return received;
}

} // namespace ghost::scene
