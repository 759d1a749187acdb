# SPDX-License-Identifier: Apache-2.0
# Everything comes from the system's packages (their names in Debian 12 and 13 are in ./dev).
find_package(Threads REQUIRED)
find_package(glm REQUIRED)
find_package(pugixml REQUIRED)
find_package(assimp REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(Vulkan REQUIRED)
find_package(embree 4 QUIET) # Debian 13
if(NOT embree_FOUND)
    find_package(embree 3 REQUIRED) # Debian 12
endif()
find_package(TBB REQUIRED)
find_package(meshoptimizer REQUIRED)
find_package(GTest REQUIRED)
find_package(Qt6 REQUIRED COMPONENTS Widgets Network)
find_program(LRELEASE lrelease HINTS ${QT6_INSTALL_PREFIX}/${QT6_INSTALL_BINS} REQUIRED)
find_package(PkgConfig REQUIRED)
# Debian's CMake files of OpenEXR and libzip name Python modules and tools of other packages; pkg-config does not.
pkg_check_modules(OPENEXR REQUIRED IMPORTED_TARGET OpenEXR)
pkg_check_modules(PNG REQUIRED IMPORTED_TARGET libpng)
pkg_check_modules(TURBOJPEG REQUIRED IMPORTED_TARGET libturbojpeg)
pkg_check_modules(PANGOCAIRO REQUIRED IMPORTED_TARGET pangocairo cairo-pdf)
pkg_check_modules(LIBZIP REQUIRED IMPORTED_TARGET libzip)
pkg_check_modules(SECCOMP REQUIRED IMPORTED_TARGET libseccomp)
pkg_check_modules(XXHASH REQUIRED IMPORTED_TARGET libxxhash)
pkg_check_modules(QRENCODE REQUIRED IMPORTED_TARGET libqrencode)
pkg_check_modules(ZSTD REQUIRED IMPORTED_TARGET libzstd)
pkg_check_modules(ZLIB REQUIRED IMPORTED_TARGET zlib)
pkg_check_modules(FFMPEG REQUIRED IMPORTED_TARGET libavcodec libavformat libavutil libswresample libswscale)
pkg_check_modules(ALSA REQUIRED IMPORTED_TARGET alsa)
pkg_check_modules(LTC REQUIRED IMPORTED_TARGET ltc)
find_program(GLSLC glslc REQUIRED)

if(NOT TARGET glm::glm)
    add_library(glm::glm INTERFACE IMPORTED)
endif()

find_path(CLI11_INCLUDE CLI/CLI.hpp REQUIRED)
find_path(NLOHMANN_INCLUDE nlohmann/json.hpp REQUIRED)

# What only the files of this system need, by room; elsewhere: dependencies_elsewhere.cmake.
set(GHOST_OF_SYSTEM_base PkgConfig::SECCOMP)
