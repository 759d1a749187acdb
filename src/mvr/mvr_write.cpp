// SPDX-License-Identifier: Apache-2.0
#include "mvr/mvr_write.h"

#include "disk/files.h"
#include "mvr/mvr_edit.h"
#include "mvr/private/mvr_reader.h"

#include <zip.h>

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace ghost::scene {
namespace {

constexpr zip_uint16_t kFixedDate = 0x21; // 1 January 1980, the first day that a zip can name
constexpr zip_uint32_t kDeflateLevel = 9;

// The last change of each thing.
std::vector<PlotEdit> edits_of(const LoadedPlot& loaded, std::span<const PlotChange> changes,
                               Report& report) {
    std::unordered_map<std::string, int> objects;
    for (std::size_t i = 0; i < loaded.plot.objects.size(); ++i)
        objects.emplace(uuid_key(loaded.plot.objects[i].uuid), static_cast<int>(i));
    objects.erase("");
    std::map<std::tuple<int, int, int>, PlotEdit> last;
    for (const PlotChange& change : changes) {
        const auto found = objects.find(uuid_key(change.uuid));
        if (found == objects.end()) {
            report.add(Severity::warning, loaded.name,
                       "a change is left out: there is no object " + change.uuid);
            continue;
        }
        if (change.what == PlotChange::What::hidden) {
            const PlotObject& object = loaded.plot.objects[static_cast<std::size_t>(found->second)];
            report.add(Severity::note, loaded.name,
                       "MVR cannot say that '" + object.name + "' is hidden; it is written as it was");
            continue;
        }
        const int dmx_break = change.what == PlotChange::What::address ? change.dmx_break : 0;
        last[{found->second, static_cast<int>(change.what), dmx_break}] = {found->second, change};
    }
    std::vector<PlotEdit> edits;
    for (auto& [key, edit] : last) edits.push_back(std::move(edit));
    return edits;
}

// A zip that is being written; what was not closed leaves nothing behind.
class ZipWriter {
public:
    explicit ZipWriter(std::filesystem::path path) : path_(std::move(path)) {}
    ZipWriter(const ZipWriter&) = delete;
    ZipWriter& operator=(const ZipWriter&) = delete;
    ~ZipWriter() {
        if (handle_) zip_discard(handle_);
    }

    Result<void> open() {
        int code = 0;
        handle_ = zip_open(path_.string().c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code);
        if (handle_) return {};
        zip_error_t error;
        zip_error_init_with_code(&error, code);
        Error result{std::string("cannot write: ") + zip_error_strerror(&error), path_.string()};
        zip_error_fini(&error);
        return result;
    }

    Result<void> add(const char* name, zip_source_t* source, zip_int32_t method) {
        if (!source) return fail();
        const zip_int64_t index = zip_file_add(handle_, name, source, ZIP_FL_ENC_GUESS);
        if (index < 0) {
            zip_source_free(source);
            return fail();
        }
        const auto place = static_cast<zip_uint64_t>(index);
        // What is copied packed keeps its method only when it is named.
        if (zip_set_file_compression(handle_, place, method, method == ZIP_CM_DEFLATE ? kDeflateLevel : 0) !=
                0 ||
            zip_file_set_dostime(handle_, place, 0, kFixedDate, 0) != 0)
            return fail();
        return {};
    }

    Result<void> copy(zip_t* from, zip_uint64_t entry) {
        zip_stat_t stat;
        const char* name = zip_get_name(from, entry, ZIP_FL_ENC_RAW);
        if (!name || zip_stat_index(from, entry, 0, &stat) != 0 || !(stat.valid & ZIP_STAT_COMP_METHOD))
            return Error{"an entry of the original cannot be read", path_.string()};
            // To its end: -1. libzip 1.11 says ZIP_LENGTH_TO_END, which is 0, and takes that for no bytes.
#ifdef ZIP_LENGTH_TO_END // zip_source_zip is deprecated; Debian 12 has nothing else
        zip_source_t* const source =
            zip_source_zip_file(handle_, from, entry, ZIP_FL_COMPRESSED, 0, -1, nullptr);
#else
        zip_source_t* const source = zip_source_zip(handle_, from, entry, ZIP_FL_COMPRESSED, 0, -1);
#endif
        return add(name, source, stat.comp_method);
    }

    // One whose checksum does not fit: packed ones are copied unread; of stored ones libzip would check it,
    // so their bytes are taken up to their length. False: they are not all there.
    Result<bool> copy_damaged(zip_t* from, zip_uint64_t entry) {
        zip_stat_t stat;
        const char* name = zip_get_name(from, entry, ZIP_FL_ENC_RAW);
        if (!name || zip_stat_index(from, entry, 0, &stat) != 0 || stat.size > kMaxMvrMemberBytes)
            return false;
        if (stat.comp_method != ZIP_CM_STORE) {
            TRY_VOID(copy(from, entry));
            return true;
        }
        zip_file_t* file = zip_fopen_index(from, entry, 0);
        if (!file) return false;
        std::string& bytes = damaged_.emplace_back(static_cast<std::size_t>(stat.size), '\0');
        std::size_t done = 0;
        for (zip_int64_t got = 1; done < bytes.size() && got > 0;
             done += static_cast<std::size_t>(std::max<zip_int64_t>(got, 0)))
            got = zip_fread(file, bytes.data() + done, bytes.size() - done);
        zip_fclose(file);
        if (done < bytes.size()) return false;
        TRY_VOID(add(name, zip_source_buffer(handle_, bytes.data(), bytes.size(), 0), ZIP_CM_STORE));
        return true;
    }

    Result<void> add_text(const char* name, const std::string& text) {
        return add(name, zip_source_buffer(handle_, text.data(), text.size(), 0), ZIP_CM_DEFLATE);
    }

    Result<void> close() {
        if (zip_close(handle_) != 0) return fail();
        handle_ = nullptr;
        return {};
    }

private:
    Error fail() const {
        return {std::string("cannot write: ") + zip_strerror(handle_), path_.string()};
    }

    std::filesystem::path path_;
    zip_t* handle_ = nullptr;
    std::deque<std::string> damaged_; // what is written when it closes
};

// "" or what is wrong with a member: it is unpacked to its end, in pieces. What is packed by a method that we
// do not know is not looked at.
std::string damage_of(zip_t* from, zip_uint64_t entry) {
    zip_stat_t stat;
    if (zip_stat_index(from, entry, 0, &stat) != 0 || !(stat.valid & ZIP_STAT_SIZE) ||
        !(stat.valid & ZIP_STAT_COMP_METHOD))
        return "the zip does not say what it is";
    if (stat.comp_method != ZIP_CM_STORE && stat.comp_method != ZIP_CM_DEFLATE) return "";
    if (stat.size > kMaxMvrMemberBytes) return "it unpacks to more than is allowed, and was not looked at";
    zip_file_t* file = zip_fopen_index(from, entry, 0);
    if (!file) return zip_strerror(from);
    std::vector<char> piece(1 << 16);
    zip_uint64_t done = 0;
    zip_int64_t got = 0;
    while (done <= stat.size && (got = zip_fread(file, piece.data(), piece.size())) > 0)
        done += static_cast<zip_uint64_t>(got);
    zip_fclose(file);
    return got == 0 && done == stat.size ? "" : "its bytes do not fit its checksum or its length";
}

Result<void> write_members(LoadedPlot& loaded, const std::string* description, ZipWriter& out,
                           Report& report) {
    zip_t* from = loaded.archive.handle();
    const zip_int64_t first = zip_name_locate(from, loaded.description.c_str(), 0);
    if (first < 0) return Error{"the description is gone", loaded.name};
    const auto place = static_cast<zip_uint64_t>(first);
    if (description) {
        const char* name = zip_get_name(from, place, ZIP_FL_ENC_RAW);
        TRY_VOID(out.add_text(name ? name : loaded.description.c_str(), *description));
    } else {
        TRY_VOID(out.copy(from, place));
    }
    std::set<std::string> written{loaded.description};
    const auto count = static_cast<zip_uint64_t>(zip_get_num_entries(from, 0));
    for (zip_uint64_t i = 0; i < count; ++i) {
        const char* raw = i == place ? nullptr : zip_get_name(from, i, ZIP_FL_ENC_GUESS);
        if (!raw) continue;
        const std::string name = raw;
        if (leads_out(name)) {
            report.add(Severity::warning, loaded.name,
                       "'" + name + "' leads out of the archive; not written");
        } else if (!written.insert(name).second) {
            report.add(Severity::warning, loaded.name, "a second '" + name + "' is not written");
        } else if (!name.ends_with('/')) {
            const std::string damage = damage_of(from, i);
            if (damage.empty()) {
                TRY_VOID(out.copy(from, i));
                continue;
            }
            TRY(const bool is_whole, out.copy_damaged(from, i));
            report.add(Severity::error, loaded.name + ": " + name,
                       "is damaged (" + damage + "); it is " + (is_whole ? "written as it is" : "left out"));
        }
    }
    return {};
}

} // namespace

Result<void> write_mvr(LoadedPlot& loaded, std::span<const PlotChange> changes,
                       const std::filesystem::path& path, Report& report) {
    const std::vector<PlotEdit> edits = edits_of(loaded, changes, report);
    std::optional<std::string> description;
    if (!edits.empty()) {
        TRY(const std::vector<std::uint8_t> original, loaded.archive.read(loaded.description));
        TRY(description,
            edit_description(original, loaded.plot, edits, loaded.name + ": " + loaded.description));
    }
    const std::filesystem::path temporary = temporary_beside(path);
    const auto write = [&]() -> Result<void> {
        ZipWriter out(temporary);
        TRY_VOID(out.open());
        TRY_VOID(write_members(loaded, description ? &*description : nullptr, out, report));
        return out.close();
    };
    if (auto written = write(); !written.ok()) {
        std::error_code code;
        std::filesystem::remove(temporary, code);
        return Error{written.error().what, path.string()};
    }
    return commit_temporary(temporary, path);
}

} // namespace ghost::scene
