# SPDX-License-Identifier: Apache-2.0
# Writes compiled SPIR-V as a gpu::Shader of C++: cmake -DINPUT= -DOUTPUT= -DNAME= -P embed.cmake
file(READ ${INPUT} bytes HEX)
string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1," words "${bytes}")
file(WRITE ${OUTPUT} "#pragma once\n#include \"gpu/shader.h\"\nnamespace ghost::render::shaders {\n"
    "inline constexpr std::uint32_t kWords_${NAME}[] = {${words}};\ninline constexpr gpu::Shader kShader_${NAME}{\"${NAME}\", kWords_${NAME}};\n}\n")
