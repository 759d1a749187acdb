// SPDX-License-Identifier: Apache-2.0
// Links of an MVR description: UUIDs and file names to indices, when all of it has been read.
#include "mvr/private/mvr_reader.h"

#include "base/suggest.h"
#include "base/text.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace ghost::scene {
namespace {

template <class Entry>
std::unordered_map<std::string, int> index_of(const std::vector<Entry>& entries) {
    std::unordered_map<std::string, int> index;
    for (std::size_t i = 0; i < entries.size(); ++i)
        index.emplace(uuid_key(entries[i].uuid), static_cast<int>(i));
    index.erase("");
    return index;
}

class LinkResolver {
public:
    explicit LinkResolver(MvrReader& reader)
        : reader_(reader), classes_(index_of(reader.plot().classes)),
          positions_(index_of(reader.plot().positions)),
          definitions_(index_of(reader.plot().mapping_definitions)) {}

    void all() {
        Plot& plot = reader_.plot();
        for (std::size_t i = 0; i < plot.objects.size(); ++i) {
            const pugi::xml_node node = reader_.object_nodes[i];
            PlotObject& object = plot.objects[i];
            object.plot_class = find(classes_, object.class_uuid, node, "Classing", "Class");
            device(object, node, static_cast<int>(i));
            gdtf(object, node);
        }
        missing_gdtf();
    }

private:
    int find(const std::unordered_map<std::string, int>& index, const std::string& uuid, pugi::xml_node node,
             const char* link, const char* target) {
        const std::string key = uuid_key(uuid);
        if (key.empty()) return -1;
        const auto found = index.find(key);
        if (found != index.end()) return found->second;
        // Nobody's: what some programs write for "none".
        if (key != "00000000-0000-0000-0000-000000000000")
            reader_.say(Severity::note, node,
                        std::string("the ") + target + " that " + link + " names does not exist");
        return -1;
    }

    void device(PlotObject& object, pugi::xml_node node, int self) {
        PlotDevice& device = object.device;
        const auto& objects = reader_.object_index;
        device.position = find(positions_, device.position_uuid, node, "Position", "Position");
        device.focus = find(objects, device.focus_uuid, node, "Focus", "FocusPoint");
        if (device.focus >= 0 &&
            reader_.plot().objects[static_cast<std::size_t>(device.focus)].kind != ObjectKind::focus_point) {
            reader_.say(Severity::warning, node, "Focus names an object that is no FocusPoint; left out");
            device.focus = -1;
        }
        device.multipatch = find(objects, device.multipatch_uuid, node, "multipatch", "object");
        if (device.multipatch == self) device.multipatch = -1;
        for (PlotConnection& connection : device.connections)
            connection.to_object = find(objects, connection.to_uuid, node, "Connection", "object");
        for (PlotMapping& mapping : device.mappings)
            mapping.definition =
                find(definitions_, mapping.definition_uuid, node, "Mapping", "MappingDefinition");
    }

    void gdtf(PlotObject& object, pugi::xml_node node) {
        const std::string& spec = object.device.gdtf_spec;
        if (spec.empty()) {
            if (object.kind == ObjectKind::fixture)
                reader_.say(Severity::error, node, "Fixture without a GDTFSpec: it stays dark");
            return;
        }
        std::vector<PlotGdtf>& files = reader_.plot().gdtf_files;
        auto known = by_spec_.find(spec);
        if (known == by_spec_.end()) {
            const std::string member = gdtf_member(spec, node);
            const auto same = member.empty() ? by_member_.end() : by_member_.find(member);
            int index = same == by_member_.end() ? -1 : same->second;
            if (index < 0) {
                files.push_back({spec, member, 0});
                first_.push_back(node);
                index = static_cast<int>(files.size()) - 1;
                by_member_.emplace(member, index);
            }
            known = by_spec_.emplace(spec, index).first;
        }
        object.device.gdtf = known->second;
        ++files[static_cast<std::size_t>(known->second)].objects;
    }

    std::string gdtf_member(const std::string& spec, pugi::xml_node node) {
        const MvrMembers::Found named = reader_.members().find(spec);
        const bool has_end = lower(spec).ends_with(".gdtf");
        // A folder or picture of that name is no fixture.
        if (named.exact && lower(named.member).ends_with(".gdtf")) return named.member;
        const MvrMembers::Found with_end = has_end ? named : reader_.members().find(spec + ".gdtf");
        std::string member = with_end.member;
        if (!member.empty() && with_end.exact) return member;
        if (member.empty()) member = by_fixture_name(spec);
        if (!member.empty())
            reader_.say(Severity::warning, node, "GDTFSpec '" + spec + "': taken is '" + member + "'");
        return member;
    }

    static std::string fixture_name(std::string name) {
        name = lower(name);
        return name.ends_with(".gdtf") ? name.substr(0, name.size() - 5) : name;
    }

    // "Cluster S2" where the archive has one "Roxx@Cluster S2.gdtf".
    std::string by_fixture_name(const std::string& spec) {
        if (!by_fixture_) {
            by_fixture_.emplace();
            for (const std::string& file : reader_.members().gdtf_files()) {
                const std::string name = fixture_name(file);
                const std::size_t at = name.find('@');
                if (at == name.npos) continue;
                const auto [place, is_new] = by_fixture_->emplace(name.substr(at + 1), file);
                if (!is_new) place->second.clear(); // two of that name are none
            }
        }
        const auto found = by_fixture_->find(fixture_name(spec));
        return found == by_fixture_->end() ? "" : found->second;
    }

    void missing_gdtf() {
        const std::vector<PlotGdtf>& files = reader_.plot().gdtf_files;
        Suggestions suggestions;
        for (std::size_t i = 0; i < files.size(); ++i)
            if (files[i].member.empty())
                reader_.say(Severity::error, first_[i],
                            "fixture file '" + files[i].spec + "' is not in the archive" +
                                suggestions.did_you_mean(files[i].spec, reader_.members().gdtf_files()) +
                                " (" + std::to_string(files[i].objects) +
                                (files[i].objects == 1 ? " fixture needs it)" : " fixtures need it)"));
    }

    MvrReader& reader_;
    std::unordered_map<std::string, int> classes_;
    std::unordered_map<std::string, int> positions_;
    std::unordered_map<std::string, int> definitions_;
    std::unordered_map<std::string, int> by_spec_;   // Plot::gdtf_files
    std::unordered_map<std::string, int> by_member_; // the same
    std::optional<std::unordered_map<std::string, std::string>>
        by_fixture_;                    // member, by the name of its fixture
    std::vector<pugi::xml_node> first_; // of each of Plot::gdtf_files
};

} // namespace

void resolve_links(MvrReader& reader) {
    LinkResolver(reader).all();
}

} // namespace ghost::scene
