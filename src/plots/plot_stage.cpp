// SPDX-License-Identifier: Apache-2.0
#include "plots/plot_stage.h"

#include "base/text.h"
#include "image/finite.h"
#include "stage/model_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace ghost::scene {
namespace {

constexpr double kFar_m = 5000.0;
constexpr double kOriginStep_m = 1000.0;
constexpr std::size_t kMaxPictureBytes = std::size_t{2} << 30;
constexpr std::uint64_t kMaxPartBytes = std::uint64_t{256} << 20;

std::set<std::string> small_letters(std::span<const std::string> names) {
    std::set<std::string> result;
    for (const std::string& name : names) result.insert(lower(name));
    return result;
}

// The kind of a message: what it says up to the names that it lists.
std::string kind_of(const Message& message) {
    return std::to_string(static_cast<int>(message.severity)) +
           message.what.substr(0, message.what.find(": '"));
}

// Hundreds of meshes of one program have the same fault: it is said once, with how many have it.
class MeshMessages {
public:
    void take(const Report& report) {
        for (const Message& message : report.messages) {
            const auto [entry, is_new] = first_.try_emplace(kind_of(message), kinds_.size());
            if (is_new)
                kinds_.push_back({message, 1});
            else
                ++kinds_[entry->second].second;
        }
    }
    void give(Report& report) const {
        for (const auto& [message, files] : kinds_)
            report.add(message.severity, message.where,
                       message.what +
                           (files > 1 ? " (and so in " + std::to_string(files - 1) + " more files)" : ""));
    }

private:
    std::map<std::string, std::size_t> first_;
    std::vector<std::pair<Message, std::size_t>> kinds_;
};

// Materials without pictures that say the same are one: a program writes its grey into every file.
class MaterialSet {
public:
    explicit MaterialSet(Stage& stage) : stage_(stage) {}

    // After absorb() has put new materials and meshes behind those that were there.
    void fold(std::size_t first_material, std::size_t first_mesh) {
        std::vector<int> place;
        std::size_t kept = first_material;
        for (std::size_t k = first_material; k < stage_.materials.size(); ++k) {
            Material& material = stage_.materials[k];
            const std::string key = key_of(material);
            const auto [entry, is_new] = index_.try_emplace(key, static_cast<int>(kept));
            place.push_back(entry->second);
            if (!is_new) continue;
            if (kept != k) stage_.materials[kept] = std::move(material);
            ++kept;
        }
        stage_.materials.resize(kept);
        for (std::size_t m = first_mesh; m < stage_.meshes.size(); ++m) {
            int& material = stage_.meshes[m].material;
            material = place[static_cast<std::size_t>(material) - first_material];
        }
    }

private:
    static std::string key_of(const Material& m) {
        std::string key = m.name + "\n";
        const float numbers[] = {m.base_colour.x, m.base_colour.y, m.base_colour.z, m.alpha,
                                 m.roughness,     m.metalness,     m.specular,      m.emission.x,
                                 m.emission.y,    m.emission.z,    m.normal_scale,  m.alpha_cutoff};
        const int whole[] = {m.base_texture,     m.normal_texture,       m.surface_texture,
                             m.emission_texture, m.double_sided ? 1 : 0, static_cast<int>(m.alpha_mode)};
        key.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
        key.append(reinterpret_cast<const char*>(whole), sizeof whole);
        return key;
    }

    Stage& stage_;
    std::map<std::string, int> index_;
};

// Pictures and buffers of an archive by name, wherever in it they lie.
ReadCompanion member_reader(LoadedPlot& loaded) {
    return [&loaded](const std::string& name) -> Result<std::vector<std::uint8_t>> {
        std::string member = loaded.archive.find(name);
        const std::size_t slash = name.find_last_of("/\\");
        if (member.empty() && slash != std::string::npos)
            member = loaded.archive.find(name.substr(slash + 1));
        if (member.empty()) return Error{"is not in the archive", name};
        return loaded.archive.read(member, kMaxPartBytes);
    };
}

class PlotStage {
public:
    PlotStage(LoadedPlot& loaded, Stage& stage, std::uint64_t most_mesh_bytes = kMostMeshBytes)
        : loaded_(loaded), stage_(stage), materials_(stage), mesh_bytes_left_(most_mesh_bytes) {
        for (const Texture& texture : stage.textures) picture_bytes_ += texture.pixels.samples.size();
    }

    // The instances of one mesh file, in metres, Z up; empty where it cannot be read.
    const std::vector<Instance>& parts_of(int mesh) {
        const auto [entry, is_new] = parts_.try_emplace(mesh);
        if (is_new) entry->second = read(loaded_.plot.meshes[static_cast<std::size_t>(mesh)]);
        return entry->second;
    }

    void place(const MeshInstance& instance, const glm::dvec3& origin_m) {
        const PlotObject& object = loaded_.plot.objects[static_cast<std::size_t>(instance.object)];
        glm::dmat4 to_world = instance.to_world;
        to_world[3] -= glm::dvec4(origin_m, 0.0);
        for (const Instance& part : parts_of(instance.mesh)) {
            const std::size_t triangles =
                stage_.meshes[static_cast<std::size_t>(part.mesh)].indices.size() / 3;
            if (drawn_ + triangles > kMaxDrawnTriangles) {
                ++left_out_;
                continue;
            }
            drawn_ += triangles;
            Instance& made = stage_.instances.emplace_back();
            made.name = name_of_object(object);
            if (made.name.empty()) made.name = part.name;
            if (object.layer >= 0)
                made.layer = loaded_.plot.layers[static_cast<std::size_t>(object.layer)].name;
            made.mesh = part.mesh;
            made.world = glm::mat4(to_world * glm::dmat4(part.world));
            if (usable(made.world) && !is_far_away(made)) continue;
            (usable(made.world) ? far_ : flat_).push_back(made.name);
            stage_.instances.pop_back();
        }
    }

    void finish(Report& report) const {
        messages_.give(report);
        if (not_read_ > 0)
            report.add(Severity::error, loaded_.name,
                       std::to_string(not_read_) + (not_read_ == 1 ? " mesh file is" : " mesh files are") +
                           " left out: the others need all of the " + std::to_string(kMostMeshBytes >> 30) +
                           " GiB that the meshes of a plot may have");
        if (!flat_.empty())
            report.add(Severity::error, loaded_.name,
                       "objects whose placement has no volume are left out: " + name_list(flat_));
        if (!far_.empty())
            report.add(Severity::error, loaded_.name,
                       "objects more than 10 km from most of the plot are left out: " + name_list(far_));
        if (left_out_ > 0)
            report.add(Severity::error, loaded_.name,
                       std::to_string(left_out_) +
                           " meshes are left out: the plot draws more than 20 million triangles");
    }

private:
    // Many programs name groups and layers only.
    std::string name_of_object(const PlotObject& object) const {
        const Plot& plot = loaded_.plot;
        const PlotObject* at = &object;
        while (at->name.empty() && at->parent >= 0) at = &plot.objects[static_cast<std::size_t>(at->parent)];
        if (at->name.empty() && at->layer >= 0) return plot.layers[static_cast<std::size_t>(at->layer)].name;
        return at->name;
    }

    static bool usable(const glm::mat4& matrix) {
        const float volume = glm::determinant(glm::mat3(matrix));
        return image::is_finite(matrix) && std::isfinite(volume) && std::abs(volume) > 1e-20f;
    }

    bool is_far_away(const Instance& placed) const {
        const std::vector<glm::vec3>& corners =
            stage_.meshes[static_cast<std::size_t>(placed.mesh)].positions;
        return !corners.empty() && is_far(glm::vec3(placed.world * glm::vec4(corners.front(), 1.0f)));
    }

    std::vector<Instance> read(const PlotMesh& mesh) {
        if (mesh.member.empty()) return {}; // the reader of the plot has said so
        if (not_read_ > 0) {                // who reads on to find a smaller one may read for hours
            ++not_read_;
            return {};
        }
        const std::string name = loaded_.name + ": " + mesh.member;
        Report of_mesh;
        const auto model = [&]() -> Result<Stage> {
            TRY(const auto bytes, loaded_.archive.read(mesh.member));
            return load_model(bytes, mesh.extension, name, ModelSource::archive, of_mesh,
                              member_reader(loaded_));
        };
        auto loaded = model();
        if (!loaded.ok())
            of_mesh.add(Severity::error, name, loaded.error().what + "; what it shows is missing");
        if (loaded.ok() && picture_bytes_ + bytes_of(*loaded) > kMaxPictureBytes) {
            of_mesh.add(Severity::error, name,
                        "its pictures are left out: those of the plot need more than 2 GiB");
            drop_pictures(*loaded);
        }
        messages_.take(of_mesh);
        if (!loaded.ok()) return {};
        const std::uint64_t bytes = mesh_bytes_of(*loaded);
        if (bytes > mesh_bytes_left_) {
            ++not_read_;
            return {};
        }
        mesh_bytes_left_ -= bytes;
        picture_bytes_ += bytes_of(*loaded);
        const std::size_t first_material = stage_.materials.size();
        const std::size_t first_mesh = stage_.meshes.size();
        // load_model has turned Y up to Z up; what is left is the unit.
        const auto metres = static_cast<float>(glm::length(glm::dvec3(mesh.to_metres[0])));
        glm::mat4 scale(metres);
        scale[3][3] = 1.0f;
        std::vector<Instance> parts = absorb(std::move(*loaded), scale, stage_);
        materials_.fold(first_material, first_mesh);
        return parts;
    }

    static std::size_t bytes_of(const Stage& model) {
        std::size_t bytes = 0;
        for (const Texture& texture : model.textures) bytes += texture.pixels.samples.size();
        return bytes;
    }

    static std::uint64_t mesh_bytes_of(const Stage& model) {
        std::uint64_t bytes = 0;
        for (const Mesh& mesh : model.meshes)
            bytes += (mesh.positions.size() + mesh.normals.size()) * sizeof(glm::vec3) +
                     mesh.tangents.size() * sizeof(glm::vec4) + mesh.uvs.size() * sizeof(glm::vec2) +
                     mesh.indices.size() * sizeof(std::uint32_t);
        return bytes;
    }

    static void drop_pictures(Stage& model) {
        model.textures.clear();
        for (Material& material : model.materials)
            material.base_texture = material.normal_texture = material.surface_texture =
                material.emission_texture = kNone;
    }

    LoadedPlot& loaded_;
    Stage& stage_;
    MaterialSet materials_;
    MeshMessages messages_;
    std::map<int, std::vector<Instance>> parts_;
    std::vector<std::string> flat_, far_; // names of what is left out
    std::size_t drawn_ = 0;
    std::size_t left_out_ = 0;
    std::size_t picture_bytes_ = 0;
    std::uint64_t mesh_bytes_left_;
    std::size_t not_read_ = 0; // mesh files
};

} // namespace

std::vector<bool> shown_objects(const Plot& plot, std::span<const std::string> hidden_layers,
                                std::span<const std::string> hidden_classes) {
    const std::set<std::string> layers = small_letters(hidden_layers);
    const std::set<std::string> classes = small_letters(hidden_classes);
    std::vector<bool> shown;
    for (const PlotObject& object : plot.objects) {
        bool drawn = !object.hidden;
        if (object.parent >= 0) drawn = drawn && shown[static_cast<std::size_t>(object.parent)];
        if (object.layer >= 0)
            drawn =
                drawn && !layers.contains(lower(plot.layers[static_cast<std::size_t>(object.layer)].name));
        if (object.plot_class >= 0)
            drawn = drawn &&
                    !classes.contains(lower(plot.classes[static_cast<std::size_t>(object.plot_class)].name));
        shown.push_back(drawn);
    }
    return shown;
}

glm::dvec3 origin_of(const Plot& plot) {
    std::vector<double> places[3];
    for (const PlotObject& object : plot.objects)
        if (object.kind == ObjectKind::fixture || !object.geometries.empty())
            for (int k = 0; k < 3; ++k) places[k].push_back(object.world[3][k]);
    glm::dvec3 origin_m(0.0);
    for (int k = 0; k < 3; ++k) {
        if (places[k].empty()) continue;
        // The median: one object that flew away must not take the others along.
        const auto middle = places[k].begin() + static_cast<std::ptrdiff_t>(places[k].size() / 2);
        std::nth_element(places[k].begin(), middle, places[k].end());
        if (std::isfinite(*middle) && std::abs(*middle) > kFar_m)
            origin_m[k] = std::round(*middle / kOriginStep_m) * kOriginStep_m;
    }
    return origin_m;
}

std::optional<ScreenPlane> screen_plane(LoadedPlot& loaded, int object, const glm::dvec3& origin_m) {
    constexpr double kLeast_m = 0.05;
    constexpr double kOneSided = 0.1; // share of its faces that must look one way
    Stage stage;
    PlotStage reader(loaded, stage);
    for (const MeshInstance& mesh : mesh_instances(loaded.plot, object)) reader.place(mesh, origin_m);
    glm::dmat3 axes(loaded.plot.objects[static_cast<std::size_t>(object)].world);
    for (int k = 0; k < 3; ++k) {
        if (!(glm::length(axes[k]) > 1e-9)) return std::nullopt;
        axes[k] = glm::normalize(axes[k]);
    }
    const glm::dmat3 to_local = glm::transpose(axes);
    glm::dvec3 low(1e30), high(-1e30), facing(0.0);
    double area = 0;
    for (const Instance& instance : stage.instances) {
        const Mesh& mesh = stage.meshes[static_cast<std::size_t>(instance.mesh)];
        std::vector<glm::dvec3> local;
        for (const glm::vec3& position : mesh.positions) {
            local.push_back(to_local * glm::dvec3(instance.world * glm::vec4(position, 1.0f)));
            low = glm::min(low, local.back());
            high = glm::max(high, local.back());
        }
        for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3) {
            const glm::dvec3 a = local[mesh.indices[k]];
            const glm::dvec3 across =
                glm::cross(local[mesh.indices[k + 1]] - a, local[mesh.indices[k + 2]] - a);
            facing += across;
            area += glm::length(across);
        }
    }
    const glm::dvec3 size = high - low;
    const int thin = size.y <= size.x && size.y <= size.z ? 1 : (size.z <= size.x ? 2 : 0);
    const int right = thin == 0 ? 1 : 0, up = thin == 2 ? 1 : 2;
    if (!(size[right] > kLeast_m && size[up] > kLeast_m) || !std::isfinite(size[thin])) return std::nullopt;
    const bool positive = facing[thin] > kOneSided * area;
    glm::dvec3 front = 0.5 * (low + high);
    front[thin] = positive ? high[thin] : low[thin];
    ScreenPlane plane;
    const glm::dvec3 normal = positive ? axes[thin] : -axes[thin];
    const glm::dvec3 above = axes[up];
    plane.to_world[0] = glm::dvec4(glm::cross(-normal, above), 0.0);
    plane.to_world[1] = glm::dvec4(-normal, 0.0);
    plane.to_world[2] = glm::dvec4(above, 0.0);
    plane.to_world[3] = glm::dvec4(axes * front, 1.0);
    plane.size_m = {size[right], size[up]};
    plane.depth_m = static_cast<float>(size[thin]);
    return plane;
}

Result<void> add_plot_stage(LoadedPlot& loaded, const std::vector<bool>& shown, const glm::dvec3& origin_m,
                            Stage& stage, Report& report, const ShowLoading& loading,
                            std::uint64_t most_mesh_bytes) {
    std::vector<MeshInstance> instances;
    for (std::size_t k = 0; k < loaded.plot.objects.size(); ++k) {
        const ObjectKind kind = loaded.plot.objects[k].kind;
        // A focus point's geometry is a mark in the drawing; a fixture's shape is that of its GDTF.
        if (!shown[k] || kind == ObjectKind::focus_point || kind == ObjectKind::fixture) continue;
        const std::vector<MeshInstance> own = mesh_instances(loaded.plot, static_cast<int>(k));
        instances.insert(instances.end(), own.begin(), own.end());
    }
    PlotStage plot_stage(loaded, stage, most_mesh_bytes);
    const std::size_t step = std::max<std::size_t>(1, instances.size() / 100);
    for (std::size_t k = 0; k < instances.size(); ++k) {
        if (k % step == 0) {
            if (loading.stop && loading.stop())
                return Error{"stopped while its meshes were read", loaded.name};
            if (loading.progress)
                loading.progress(static_cast<double>(k) / static_cast<double>(instances.size()), "meshes");
        }
        plot_stage.place(instances[k], origin_m);
    }
    plot_stage.finish(report);
    return {};
}

} // namespace ghost::scene
