// SPDX-License-Identifier: Apache-2.0
#include "gpu/pipeline_cache.h"

#include "base/log.h"
#include "disk/crc32.h"
#include "disk/files.h"
#include "disk/own_folder.h"
#include "gpu/device.h"

#include <array>
#include <cstdio>
#include <cstring>
#include <string>
#include <system_error>

namespace ghost::gpu {
namespace fs = std::filesystem;
namespace {

constexpr std::uintmax_t kMostPipelineBytes = std::uintmax_t{256} << 20;
constexpr std::array<char, 8> kFileMagic{'g', 'h', 'o', 's', 't', 'p', 'i', '1'};
constexpr std::size_t kHeadBytes = kFileMagic.size() + sizeof(std::uint32_t); // magic, CRC of what follows
constexpr const char* kExtension = ".pipelines";

VkPhysicalDeviceProperties properties_of(VkPhysicalDevice physical) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(physical, &properties);
    return properties;
}

// Of a device, whatever its driver: "10de-2330-".
std::string device_part(const VkPhysicalDeviceProperties& properties) {
    char text[32];
    std::snprintf(text, sizeof text, "%04x-%04x-", properties.vendorID, properties.deviceID);
    return text;
}

std::string name_of(const VkPhysicalDeviceProperties& properties) {
    std::string name = device_part(properties);
    for (const std::uint8_t byte : properties.pipelineCacheUUID) {
        char digits[3];
        std::snprintf(digits, sizeof digits, "%02x", byte);
        name += digits;
    }
    return name + kExtension;
}

// Vulkan 1.3, 10.6.1 "Pipeline cache header".
bool is_of(Bytes data, const VkPhysicalDeviceProperties& properties) {
    ByteReader reader(data);
    const std::uint32_t head_bytes = reader.u32_le();
    const std::uint32_t version = reader.u32_le();
    const std::uint32_t vendor = reader.u32_le();
    const std::uint32_t device = reader.u32_le();
    const Bytes uuid = reader.take(VK_UUID_SIZE);
    return reader.ok() && head_bytes >= reader.position() && head_bytes <= data.size() &&
           version == VK_PIPELINE_CACHE_HEADER_VERSION_ONE && vendor == properties.vendorID &&
           device == properties.deviceID &&
           std::memcmp(uuid.data(), properties.pipelineCacheUUID, VK_UUID_SIZE) == 0;
}

} // namespace

PipelineCache::PipelineCache(VkPhysicalDevice physical, VkDevice device, const fs::path& folder)
    : device_(device) {
    const VkPhysicalDeviceProperties properties = properties_of(physical);
    if (!folder.empty()) {
        std::error_code code;
        fs::create_directories(folder, code);
        if (code)
            log_warning(folder.string() + ": pipelines are not kept: " + code.message());
        else
            file_ = folder / name_of(properties);
    }
    std::error_code code;
    if (!file_.empty() && fs::exists(file_, code)) {
        if (auto found = contents(properties); found.ok())
            read_ = std::move(*found);
        else
            log_warning(file_.string() + ": " + found.error().what + "; pipelines are made anew");
    }
    VkPipelineCacheCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO;
    info.initialDataSize = read_.size();
    info.pInitialData = read_.data();
    VK_CALL(vkCreatePipelineCache(device, &info, nullptr, &cache_));
}

PipelineCache::~PipelineCache() {
    vkDestroyPipelineCache(device_, cache_, nullptr);
}

Result<std::vector<std::uint8_t>>
PipelineCache::contents(const VkPhysicalDeviceProperties& properties) const {
    TRY(const std::vector<std::uint8_t> bytes, read_file(file_, kMostPipelineBytes));
    ByteReader reader(bytes);
    const Bytes magic = reader.take(kFileMagic.size());
    const std::uint32_t crc = reader.u32_le();
    if (!reader.ok() || std::memcmp(magic.data(), kFileMagic.data(), kFileMagic.size()) != 0)
        return Error{"is no file of pipelines", ""};
    const Bytes data = reader.take(reader.left());
    if (crc32(data) != crc) return Error{"is damaged", ""};
    if (!is_of(data, properties)) return Error{"is of another device or driver", ""};
    return std::vector<std::uint8_t>(data.begin(), data.end());
}

void PipelineCache::keep() const {
    if (file_.empty()) return;
    std::size_t size = 0;
    if (vkGetPipelineCacheData(device_, cache_, &size, nullptr) != VK_SUCCESS)
        return; // a device that was lost
    std::vector<std::uint8_t> data(size);
    if (size == 0 || size > kMostPipelineBytes - kHeadBytes ||
        vkGetPipelineCacheData(device_, cache_, &size, data.data()) != VK_SUCCESS)
        return;
    data.resize(size);
    if (data == read_) return;
    std::vector<std::uint8_t> bytes(kFileMagic.begin(), kFileMagic.end());
    const std::uint32_t crc = crc32(data);
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(crc >> shift));
    bytes.insert(bytes.end(), data.begin(), data.end());
    if (const Result<void> written = write_file_atomic(file_, bytes); !written.ok()) {
        log_warning("pipelines are not kept: " + written.error().text());
        return;
    }
    remove_older();
}

void PipelineCache::remove_older() const {
    const auto folder = OwnFolder::open(file_.parent_path(), file_.parent_path());
    if (!folder.ok()) return;
    const std::string name = file_.filename().string();
    const std::string device = name.substr(0, name.rfind('-') + 1);
    for (const OwnFolder::File& other : folder->entries().files)
        if (other.name != name && other.name.starts_with(device) && other.name.ends_with(kExtension))
            (void)folder->remove_file(other.name);
}

} // namespace ghost::gpu
