# SPDX-License-Identifier: Apache-2.0
# Writes the files of a folder as C++ that knows them by name: cmake -DFOLDER= -DOUTPUT= -P embed_files.cmake
file(GLOB files ${FOLDER}/*)
set(arrays "")
set(rows "")
set(number 0)
foreach(file ${files})
    get_filename_component(name ${file} NAME)
    file(READ ${file} bytes HEX)
    string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${bytes}")
    string(APPEND arrays "constexpr char kFile${number}[] = {${bytes}};\n")
    string(APPEND rows "    {\"${name}\", {kFile${number}, sizeof kFile${number}}},\n")
    math(EXPR number "${number} + 1")
endforeach()
file(WRITE ${OUTPUT} "#include \"web/private/files.h\"\nnamespace ghost::web {\nnamespace {\n${arrays}constexpr WebFile kFiles[] = {\n${rows}};\n}\n"
    "std::span<const WebFile> web_files() { return kFiles; }\n}\n")
