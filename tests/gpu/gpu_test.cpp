// SPDX-License-Identifier: Apache-2.0
// Device, buffers, textures and commands on whatever Vulkan device is there; lavapipe always is.
#include "support/made_shader.h"
#include "support/must.h"
#include "support/one_device.h"

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/device_memory.h"
#include "gpu/texture.h"

#include <chrono>
#include <cstring>
#include <gtest/gtest.h>
#include <numeric>
#include <type_traits>

namespace ghost::gpu {
namespace {

class Gpu : public ::testing::Test {
protected:
    void TearDown() override { EXPECT_EQ(device().validation_errors(), 0u); }
};

TEST_F(Gpu, DeviceHasANameAndMemory) {
    EXPECT_FALSE(device().name().empty());
    EXPECT_GT(device().memory().local_bytes(), std::uint64_t{64} << 20);
    EXPECT_GT(device().timestamp_period_ns(), 0.0);
}

bool layer_installed() {
    std::uint32_t count = 0;
    vkEnumerateInstanceLayerProperties(&count, nullptr);
    std::vector<VkLayerProperties> layers(count);
    vkEnumerateInstanceLayerProperties(&count, layers.data());
    for (const VkLayerProperties& layer : layers)
        if (std::strcmp(layer.layerName, "VK_LAYER_KHRONOS_validation") == 0) return true;
    return false;
}

// Else "no validation errors" would say nothing.
TEST_F(Gpu, MisuseIsCounted) {
    ASSERT_TRUE(layer_installed()) << "install vulkan-validationlayers";
    const auto made = Device::create({"", true});
    ASSERT_TRUE(made.ok());
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    info.size = 0; // not allowed
    VkBuffer buffer = VK_NULL_HANDLE;
    vkCreateBuffer((*made)->handle(), &info, nullptr, &buffer);
    EXPECT_EQ((*made)->validation_errors(), 1u);
    vkDestroyBuffer((*made)->handle(), buffer, nullptr);
}

TEST_F(Gpu, UnknownDeviceListsWhatThereIs) {
    const auto made = Device::create({"GeForce 8600M GT", false});
    ASSERT_FALSE(made.ok());
    EXPECT_NE(made.error().text().find("GeForce 8600M GT"), std::string::npos) << made.error().text();
    EXPECT_NE(made.error().text().find(device().name()), std::string::npos) << made.error().text();
    EXPECT_EQ(made.error().text().find("\\u000a"), std::string::npos) << made.error().text(); // one line
}

TEST_F(Gpu, DeviceIsFoundByPartOfItsName) {
    std::string part = device().name().substr(0, 4);
    for (char& letter : part) letter = static_cast<char>(std::toupper(letter));
    const auto made = Device::create({part, false});
    ASSERT_TRUE(made.ok()) << made.error().text();
    EXPECT_EQ((*made)->name(), device().name());
}

TEST_F(Gpu, DeviceIsFoundByItsNumber) {
    EXPECT_TRUE(Device::create({"0", false}).ok());
    EXPECT_FALSE(Device::create({"99", false}).ok());
}

TEST_F(Gpu, BytesGoThereAndBack) {
    std::vector<std::uint32_t> values(5000);
    std::iota(values.begin(), values.end(), 7u);
    Buffer there(device(), values.size() * 4, Access::device);
    there.write(values);
    const Buffer back(device(), values.size() * 4, Access::readback);
    Commands commands(device());
    commands.begin();
    commands.copy(there, back, values.size() * 4);
    commands.submit_and_wait();
    ASSERT_NE(back.mapped(), nullptr);
    EXPECT_EQ(std::memcmp(back.mapped(), values.data(), values.size() * 4), 0);
}

TEST_F(Gpu, CommandsWriteSmallBuffersInOrder) {
    const Buffer there(device(), 16, Access::device);
    const Buffer back(device(), 16, Access::readback);
    Commands commands(device());
    commands.begin();
    commands.write(there, std::vector<std::uint32_t>{1, 2, 3, 4});
    commands.write(there, std::vector<std::uint32_t>{9, 8});
    commands.copy(there, back, 16);
    commands.submit_and_wait();
    const auto* values = static_cast<const std::uint32_t*>(back.mapped());
    EXPECT_EQ(std::vector<std::uint32_t>(values, values + 4), (std::vector<std::uint32_t>{9, 8, 3, 4}));
}

TEST_F(Gpu, EmptyBuffersCanBeBound) {
    const Buffer empty(device(), 0, Access::device);
    EXPECT_TRUE(empty.valid());
    EXPECT_FALSE(Buffer().valid());
}

TEST_F(Gpu, BuffersAndTexturesMove) {
    Buffer a(device(), 64, Access::upload);
    const VkBuffer handle = a.handle();
    Buffer b(std::move(a));
    EXPECT_EQ(b.handle(), handle);
    a = Buffer(device(), 32, Access::upload);
    EXPECT_NE(a.handle(), handle);
    Texture c(device(), {8, 4});
    const VkImage image = c.image();
    Texture d;
    d = std::move(c);
    EXPECT_EQ(d.image(), image);
    EXPECT_EQ(d.shape().width, 8u);
}

TEST_F(Gpu, TextureKeepsItsTexelsAndClears) {
    Texture texture(device(), {7, 5, 3, 1, VK_FORMAT_R8G8B8A8_UNORM});
    std::vector<std::uint8_t> texels(7 * 5 * 3 * 4);
    for (std::size_t k = 0; k < texels.size(); ++k) texels[k] = static_cast<std::uint8_t>(k * 31);
    texture.write(0, texels.data(), texels.size());
    const Buffer back(device(), 7 * 5 * 4, Access::readback);
    const auto fetch = [&] {
        Commands commands(device());
        commands.begin();
        commands.copy(texture, back);
        commands.submit_and_wait();
        const auto* bytes = static_cast<const std::uint8_t*>(back.mapped());
        return std::vector<std::uint8_t>(bytes, bytes + 7 * 5 * 4);
    };
    EXPECT_EQ(fetch(), std::vector<std::uint8_t>(texels.begin(), texels.begin() + 7 * 5 * 4));
    const std::vector<std::uint8_t> layer(7 * 5 * 4, 77);
    texture.write_layer(1, layer.data(), layer.size());
    EXPECT_EQ(fetch()[0], texels[0]) << "another layer";
    texture.write_layer(0, layer.data(), layer.size());
    EXPECT_EQ(fetch(), layer);
    Commands commands(device());
    commands.begin();
    commands.clear(texture);
    commands.submit_and_wait();
    EXPECT_EQ(fetch(), std::vector<std::uint8_t>(7 * 5 * 4, 0));
}

TEST_F(Gpu, SpansAreMeasuredInOrder) {
    const Buffer a(device(), 1 << 20, Access::device);
    const Buffer b(device(), 1 << 20, Access::device);
    Commands commands(device());
    for (int run = 0; run < 3; ++run) { // the pool is used again
        commands.begin();
        commands.begin_span("first");
        commands.copy(a, b, 1 << 20);
        commands.begin_span("second");
        commands.copy(b, a, 1 << 20);
        const auto begun = std::chrono::steady_clock::now();
        commands.submit_and_wait();
        const std::chrono::duration<double, std::milli> waited = std::chrono::steady_clock::now() - begun;
        ASSERT_EQ(commands.spans().size(), 2u);
        EXPECT_EQ(commands.spans()[0].name, "first");
        EXPECT_EQ(commands.spans()[1].name, "second");
        double sum_ms = 0;
        for (const Span& span : commands.spans()) {
            EXPECT_GT(span.ms, 0.0) << span.name;
            sum_ms += span.ms;
        }
        EXPECT_LT(sum_ms, waited.count()) << "longer than we waited for all of it";
    }
    commands.begin();
    constexpr std::size_t kMany = 10'000; // more than there are time stamps for
    for (std::size_t k = 0; k < kMany; ++k) commands.begin_span("many");
    commands.submit_and_wait();
    EXPECT_GT(commands.spans().size(), kMany / 2);
    EXPECT_LT(commands.spans().size(), kMany);
}

// Drivers compile a shader when it is first used: a picture of another size must not pay for it again.
TEST_F(Gpu, AProgramThatIsMadeAgainHasItsPipeline) {
    const auto made = Device::create({"", true});
    ASSERT_TRUE(made.ok());
    const Device& own = **made;
    VkPipeline first = VK_NULL_HANDLE;
    {
        const Program program(own, kNothing);
        first = program.handle();
        EXPECT_EQ(own.pipelines().count(), 1u);
    }
    const Program again(own, kNothing);
    EXPECT_EQ(again.handle(), first);
    const Program other(own, kNothing, {7}), bound(own, {"bound", binding_module({.storage = 12})});
    EXPECT_NE(other.handle(), first);
    EXPECT_NE(bound.handle(), first);
    EXPECT_EQ(own.pipelines().count(), 3u);
    EXPECT_EQ(own.validation_errors(), 0u);
}

// As a member of a shader's bindings it cannot be left out.
static_assert(!std::is_default_constructible_v<Binding> && !std::is_aggregate_v<Binding>);

// A binding that is forgotten, or of another kind, ends the program at once, with the name of the shader.
TEST_F(Gpu, WrongBindingsAreNamed) {
    // A fork of the device's threads can inherit a lock that nobody gives back: the test starts itself anew instead.
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const Program program(device(), {"reader", binding_module({.storage = 12})});
    const Buffer buffer(device(), 64, Access::device);
    Commands commands(device());
    commands.begin();
    EXPECT_DEATH(commands.dispatch(program, 0, {}, 1), "shader reader is given 0 bindings, it has 1");
    EXPECT_DEATH(commands.dispatch(program, 0, {uniform(buffer)}, 1),
                 "shader reader is given a binding 0 of another kind");
    commands.dispatch(program, 0, {storage(buffer)}, 1);
    // One more is what glslc took out of the shader as unused.
    commands.dispatch(program, 0, {storage(buffer), uniform(buffer)}, 1);
    commands.submit_and_wait();
    EXPECT_EQ(device().validation_errors(), 0u);
}

} // namespace
} // namespace ghost::gpu
