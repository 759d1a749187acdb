// SPDX-License-Identifier: Apache-2.0
#include "gpu/shader.h"

#include "base/log.h"

#include <cstdlib>
#include <map>
#include <string>

namespace ghost::gpu {
namespace {

// Of the SPIR-V specification, section 3: instructions, decorations and storage classes that are read here.
constexpr std::uint32_t kHeaderWords = 5;
enum Op : std::uint32_t {
    type_image = 25,
    type_sampled_image = 27,
    type_struct = 30,
    type_pointer = 32,
    variable = 59,
    decorate = 71
};
enum Decoration : std::uint32_t { buffer_block = 3, binding_number = 33, descriptor_set = 34 };
enum Storage : std::uint32_t { uniform_constant = 0, uniform_block = 2, storage_buffer = 12 };
constexpr std::uint32_t kStoredImage = 2; // OpTypeImage, Sampled: used without a sampler

[[noreturn]] void refuse(const Shader& shader, const std::string& why) {
    log_error("shader " + std::string(shader.name) + ": " + why);
    std::abort();
}

struct Type {
    std::uint32_t op = 0;
    std::uint32_t sampled = 0; // of an image
    std::uint32_t to = 0;      // of a pointer
};

// What the module declares, by the ids of the results.
struct Module {
    std::map<std::uint32_t, Type> types;
    std::map<std::uint32_t, std::uint32_t> numbers, sets; // of variables
    std::map<std::uint32_t, bool> buffer_blocks;          // structs
    struct Variable {
        std::uint32_t pointer, id, storage;
    };
    std::vector<Variable> variables;
};

Module read(const Shader& shader) {
    Module module;
    const std::span<const std::uint32_t> words = shader.words;
    for (std::size_t at = kHeaderWords; at < words.size();) {
        const std::uint32_t length = words[at] >> 16, op = words[at] & 0xffffu;
        if (length == 0 || at + length > words.size()) refuse(shader, "its words end in the middle");
        const auto word = [&](std::uint32_t i) { return i < length ? words[at + i] : 0; };
        switch (op) {
        case type_image:
            module.types[word(1)] = {op, word(7), 0};
            break;
        case type_sampled_image:
        case type_struct:
            module.types[word(1)] = {op, 0, 0};
            break;
        case type_pointer:
            module.types[word(1)] = {op, 0, word(3)};
            break;
        case variable:
            module.variables.push_back({word(1), word(2), word(3)});
            break;
        case decorate:
            if (word(2) == binding_number) module.numbers[word(1)] = word(3);
            if (word(2) == descriptor_set) module.sets[word(1)] = word(3);
            if (word(2) == buffer_block) module.buffer_blocks[word(1)] = true;
            break;
        default:
            break;
        }
        at += length;
    }
    return module;
}

VkDescriptorType type_of(const Module& module, const Module::Variable& variable) {
    const auto pointer = module.types.find(variable.pointer);
    const std::uint32_t to = pointer == module.types.end() ? 0 : pointer->second.to;
    const auto found = module.types.find(to);
    if (found == module.types.end()) return kNoBinding; // an array
    const Type& type = found->second;
    if (type.op == type_struct && variable.storage == storage_buffer)
        return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    if (type.op == type_struct && variable.storage == uniform_block)
        return module.buffer_blocks.contains(to) ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER
                                                 : VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    if (type.op == type_sampled_image && variable.storage == uniform_constant)
        return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    if (type.op == type_image && variable.storage == uniform_constant && type.sampled == kStoredImage)
        return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    return kNoBinding;
}

} // namespace

std::vector<VkDescriptorType> bindings_of(const Shader& shader) {
    const Module module = read(shader);
    std::vector<VkDescriptorType> types;
    for (const Module::Variable& variable : module.variables) {
        const auto number = module.numbers.find(variable.id);
        if (number == module.numbers.end()) continue;
        const auto set = module.sets.find(variable.id);
        const std::string where = "binding " + std::to_string(number->second);
        if (set != module.sets.end() && set->second != 0) refuse(shader, where + " is not of set 0");
        const VkDescriptorType type = type_of(module, variable);
        if (type == kNoBinding)
            refuse(shader, where + ": expected a uniform or storage buffer, a sampled or a stored image");
        if (types.size() <= number->second) types.resize(number->second + 1, kNoBinding);
        if (types[number->second] != kNoBinding) refuse(shader, where + " is there twice");
        types[number->second] = type;
    }
    return types;
}

} // namespace ghost::gpu
