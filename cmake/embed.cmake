# SPDX-License-Identifier: Apache-2.0
# Writes a binary file as a C++ array of 32-bit words (SPIR-V): cmake -DINPUT= -DOUTPUT= -DNAME= -P embed.cmake
file(READ ${INPUT} bytes HEX)
string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1," words "${bytes}")
file(WRITE ${OUTPUT} "#pragma once\n#include <cstdint>\nnamespace ghost::render::shaders {\ninline constexpr std::uint32_t ${NAME}[] = {${words}};\n}\n")
