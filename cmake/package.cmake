# SPDX-License-Identifier: Apache-2.0
# What CPack makes of the installed components: ghostlight and libghostlight-dev as .deb (./dev package).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/package)
set(CPACK_PACKAGE_CONTACT "Ghostlight maintainers <maintainers@ghostlight.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS ${CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS})
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_SOURCE_DIR}/cmake/same_times.cmake)
set(CPACK_COMPONENTS_ALL program dev)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME ghostlight)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "stage lighting visualiser driven by a real desk
 Draws stage, rig and the signal of a lighting desk (sACN, Art-Net, USB) with
 beams, gobos and shadows; opens MVR, GDTF and glTF; renders stills and films.")
# Vulkan drivers and Qt's platforms are loaded at run time, where dpkg-shlibdeps cannot see them.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "mesa-vulkan-drivers | vulkan-icd, qt6-qpa-plugins")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "fonts-dejavu-core | fonts-liberation, qt6-translations-l10n")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "slurm-client")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libghostlight-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEV_DESCRIPTION "libraries of the stage lighting visualiser Ghostlight
 Static libraries, headers and CMake files: DMX (sACN, Art-Net, RDM), fixtures
 (GDTF, QLC+, Open Fixture Library), plots (MVR) and shows.")
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libassimp-dev, libglm-dev, libopenexr-dev, libpng-dev, libpugixml-dev, libseccomp-dev, libtomlplusplus-dev, libturbojpeg0-dev, libzip-dev, libzstd-dev, nlohmann-json3-dev, pkg-config, zlib1g-dev")
include(CPack)
