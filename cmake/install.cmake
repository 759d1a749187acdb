# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` puts where, in two components: program, and dev for other projects (find_package(ghostlight)). No header is stable
# before 1.0. Man pages and completions are there when tools/package_files.sh has made them.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

install(TARGETS ghostlight RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(DIRECTORY assets/demo assets/fixtures DESTINATION ${CMAKE_INSTALL_DATADIR}/ghostlight COMPONENT program
    PATTERN .ghost EXCLUDE PATTERN src EXCLUDE)
install(FILES packaging/ghostlight.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT program)
install(FILES packaging/ghostlight.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT program)
install(FILES packaging/ghostlight.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages COMPONENT program)
install(FILES packaging/ghostlight.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT program)
install(DIRECTORY ${CMAKE_BINARY_DIR}/package_files/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT program OPTIONAL)
install(FILES ${CMAKE_BINARY_DIR}/package_files/ghostlight.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
    RENAME ghostlight COMPONENT program OPTIONAL)
foreach(package program:ghostlight dev:libghostlight-dev)
    string(REPLACE ":" ";" package ${package})
    list(GET package 0 component)
    list(GET package 1 name)
    install(FILES ${CMAKE_BINARY_DIR}/package_files/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name}
        COMPONENT ${component} OPTIONAL)
endforeach()

# The rooms that are of use by themselves: wire formats, merge, recordings, RDM, fixtures and their files, MVR, lights; and what these stand on.
foreach(room base disk archives net image json_xml_toml psn_osc dmx/wire dmx/merge dmx/timecode dmx/receive dmx/send dmx/record rdm fixture fixture_files/common
        fixture_files/gdtf fixture_files/qxf fixture_files/ofl fixture_files/ies_ldt fixture_files stage show photometry beam_groups passes light
        mvr)
    string(REPLACE "/" "_" name ${room})
    set_target_properties(ghost_${name} PROPERTIES EXPORT_NAME ${name})
    install(TARGETS ghost_${name} EXPORT ghostlight ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
    file(GLOB headers CONFIGURE_DEPENDS src/${room}/*.h)
    install(FILES ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ghostlight/${room} COMPONENT dev)
endforeach()
install(DIRECTORY shaders/shared DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ghostlight COMPONENT dev FILES_MATCHING PATTERN *.h)
set(ghost_config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/ghostlight)
install(EXPORT ghostlight NAMESPACE ghostlight:: DESTINATION ${ghost_config_dir} COMPONENT dev)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/ghostlight-config-version.cmake COMPATIBILITY ExactVersion)
install(FILES cmake/ghostlight-config.cmake ${CMAKE_BINARY_DIR}/ghostlight-config-version.cmake DESTINATION ${ghost_config_dir} COMPONENT dev)
