// SPDX-License-Identifier: Apache-2.0
// The matrix of pixels and its groups.
#include "base/natural_order.h"
#include "fixture/values.h"
#include "fixture_files/ofl/private/ofl_reader.h"

#include <algorithm>
#include <numeric>

namespace ghost::fixture {
namespace {

constexpr std::size_t kMaxGroups = 1024;
constexpr int kMaxSide = 1024;

std::string place_name(const glm::ivec3& place, const glm::ivec3& count) {
    std::string text;
    int dimensions = 0;
    for (int k = 0; k < 3; ++k) {
        if (count[k] <= 1) continue;
        text += (dimensions++ ? ", " : "") + std::to_string(place[k] + 1);
    }
    if (dimensions == 0) return "1";
    return dimensions == 1 ? text : "(" + text + ")";
}

// ">=2", "<=3", "=1", "even", "odd", "3n", "2n+1"
bool holds(const std::string& rule, int number) {
    const auto value = [](std::string_view text) { return parse_int(text).value_or(-1); };
    if (rule == "even") return number % 2 == 0;
    if (rule == "odd") return number % 2 == 1;
    if (rule.starts_with(">=")) return number >= value(rule.substr(2));
    if (rule.starts_with("<=")) return number <= value(rule.substr(2));
    if (rule.starts_with("=")) return number == value(rule.substr(1));
    if (const std::size_t n = rule.find('n'); n != std::string::npos) {
        const int step = value(std::string_view(rule).substr(0, n));
        const int rest = n + 1 < rule.size() ? value(std::string_view(rule).substr(n + 2)) : 0;
        return step > 0 && rest >= 0 && number % step == rest % step;
    }
    return false;
}

std::vector<int> group_members(OflReader& reader, const Json& json, const std::string& pointer) {
    const OflMatrix& matrix = reader.matrix;
    std::vector<int> members;
    if (json == Json("all")) {
        members.resize(matrix.keys.size());
        std::iota(members.begin(), members.end(), 0);
        return members;
    }
    if (json.is_array()) {
        for (const Json& key : json) {
            const auto found =
                key.is_string() ? matrix.index.find(key.get_ref<const std::string&>()) : matrix.index.end();
            if (found != matrix.index.end())
                members.push_back(found->second);
            else
                reader.say(Severity::error, pointer,
                           "a pixel group names pixels that the matrix does not have");
        }
        return members;
    }
    if (!member(json, "name").is_null())
        reader.say(Severity::error, pointer + "/name",
                   "patterns of pixel names are not read: the group has all pixels "
                   "that its other rules leave");
    for (std::size_t i = 0; i < matrix.keys.size(); ++i) {
        bool fits = json.is_object();
        for (int axis = 0; axis < 3; ++axis) {
            const Json& rules = member(json, axis == 0 ? "x" : (axis == 1 ? "y" : "z"));
            if (!rules.is_array()) continue;
            for (const Json& rule : rules)
                fits &= rule.is_string() && rule.get_ref<const std::string&>().size() < 32 &&
                        holds(rule.get_ref<const std::string&>(), matrix.places[i][axis] + 1);
        }
        if (fits) members.push_back(static_cast<int>(i));
    }
    return members;
}

} // namespace

void read_ofl_matrix(OflReader& reader) {
    const Json& json = member(reader.document, "matrix");
    if (!json.is_object()) return;
    OflMatrix& matrix = reader.matrix;
    const auto add = [&](const std::string& key, const glm::ivec3& place) {
        if (matrix.keys.size() == kMaxCells) return;
        if (!matrix.index.emplace(key, static_cast<int>(matrix.keys.size())).second) {
            reader.say(Severity::error, "/matrix/pixelKeys", "a second pixel '" + key + "'");
            return;
        }
        matrix.keys.push_back(key);
        matrix.places.push_back(place);
        matrix.count = glm::max(matrix.count, place + 1);
    };
    const Json& count = member(json, "pixelCount");
    const Json& keys = member(json, "pixelKeys");
    std::size_t wanted = 0;
    if (count.is_array() && count.size() == 3) {
        glm::ivec3 sides(1);
        for (int k = 0; k < 3; ++k)
            sides[k] =
                static_cast<int>(std::clamp(number_in(count[static_cast<std::size_t>(k)]).value_or(1.0f),
                                            1.0f, static_cast<float>(kMaxSide)));
        wanted = static_cast<std::size_t>(sides.x) * static_cast<std::size_t>(sides.y) *
                 static_cast<std::size_t>(sides.z);
        for (int z = 0; z < sides.z; ++z)
            for (int y = 0; y < sides.y && matrix.keys.size() < kMaxCells; ++y)
                for (int x = 0; x < sides.x; ++x) add(place_name({x, y, z}, sides), {x, y, z});
    } else if (keys.is_array()) {
        int z = 0;
        for (const Json& plane : keys) {
            int y = 0;
            for (const Json& row : plane.is_array() ? plane : Json::array()) {
                int x = 0;
                for (const Json& key : row.is_array() ? row : Json::array()) {
                    if (key.is_string()) {
                        ++wanted;
                        add(key.get_ref<const std::string&>().substr(0, 128), {x, y, z});
                    }
                    if (++x == kMaxSide) break;
                }
                if (++y == kMaxSide) break;
            }
            if (++z == kMaxSide) break;
        }
    } else {
        reader.say(Severity::error, "/matrix", "expected pixelCount or pixelKeys");
    }
    if (wanted > kMaxCells) reader.say(Severity::error, "/matrix", "more than 4096 pixels");
    const Json& groups = member(json, "pixelGroups");
    if (!groups.is_object()) return;
    for (const auto& [key, members] : groups.items()) {
        if (matrix.groups.size() == kMaxGroups) {
            reader.say(Severity::error, "/matrix/pixelGroups", "more than 1024 pixel groups");
            break;
        }
        matrix.groups.emplace_back(key,
                                   group_members(reader, members, "/matrix/pixelGroups/" + escaped(key)));
    }
}

std::vector<int> pixels_of(const OflMatrix& matrix, const std::string& key) {
    if (const auto found = matrix.index.find(key); found != matrix.index.end()) return {found->second};
    for (const auto& [group, members] : matrix.groups)
        if (group == key) return members;
    return {};
}

std::vector<std::string> repeat_keys(OflReader& reader, const Json& repeat_for, const std::string& pointer) {
    const OflMatrix& matrix = reader.matrix;
    std::vector<std::string> keys;
    if (repeat_for.is_array()) {
        for (const Json& key : repeat_for) {
            const std::string text = key.is_string() ? key.get_ref<const std::string&>() : "";
            if (pixels_of(matrix, text).empty())
                reader.say(Severity::error, pointer,
                           "'" + text.substr(0, 60) + "' is no pixel and no pixel group");
            else
                keys.push_back(text);
        }
        return keys;
    }
    const std::string order = repeat_for.is_string() ? repeat_for.get_ref<const std::string&>() : "";
    if (order == "eachPixelGroup") {
        for (const auto& [group, members] : matrix.groups) keys.push_back(group);
        return keys;
    }
    if (order == "eachPixelABC" || order == "eachPixel") {
        keys = matrix.keys;
        std::sort(keys.begin(), keys.end(), natural_less);
        return keys;
    }
    std::vector<int> pixels(matrix.keys.size());
    std::iota(pixels.begin(), pixels.end(), 0);
    if (order.size() == 12 && order.starts_with("eachPixel")) {
        const std::string axes = order.substr(9); // the first letter runs fastest
        std::stable_sort(pixels.begin(), pixels.end(), [&](int a, int b) {
            for (int k = 2; k >= 0; --k) {
                const int axis = std::clamp(axes[static_cast<std::size_t>(k)] - 'X', 0, 2);
                const int left = matrix.places[static_cast<std::size_t>(a)][axis];
                const int right = matrix.places[static_cast<std::size_t>(b)][axis];
                if (left != right) return left < right;
            }
            return false;
        });
    } else {
        reader.say(Severity::warning, pointer,
                   "expected eachPixelABC, eachPixelXYZ or its kind, eachPixelGroup or a "
                   "list of pixels; taking eachPixelXYZ");
    }
    for (const int pixel : pixels) keys.push_back(matrix.keys[static_cast<std::size_t>(pixel)]);
    return keys;
}

} // namespace ghost::fixture
