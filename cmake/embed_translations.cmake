# SPDX-License-Identifier: Apache-2.0
# Writes compiled catalogues (ghostlight_de.qm) as C++ that knows them by language: cmake -DFOLDER= -DOUTPUT= -P
# embed_translations.cmake
file(GLOB files ${FOLDER}/*.qm)
set(arrays "")
set(rows "")
foreach(file ${files})
    get_filename_component(name ${file} NAME_WE)
    string(REGEX REPLACE "^ghostlight_" "" language ${name})
    file(READ ${file} bytes HEX)
    string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
    string(APPEND arrays "constexpr unsigned char kTexts_${language}[] = {${bytes}};\n")
    string(APPEND rows "    {\"${language}\", kTexts_${language}},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"ui/language/private/catalogues.h\"\nnamespace ghost::ui {\nnamespace {\n${arrays}constexpr Catalogue kCatalogues[] = {\n${rows}};\n}\n"
    "std::span<const Catalogue> catalogues() { return kCatalogues; }\n}\n")
