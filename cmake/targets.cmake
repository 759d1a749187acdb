# SPDX-License-Identifier: Apache-2.0
# How our own targets are built: warnings are errors, includes start at src/ and shaders/.

function(ghost_options target)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -Wshadow -Wnon-virtual-dtor
        -Wno-missing-field-initializers -Werror)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
        # At -O3 it takes "a" + text for a copy onto itself (GCC bug 105329).
        target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-Wno-restrict>)
    endif()
    target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/src>
        $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/shaders> $<INSTALL_INTERFACE:include/ghostlight>)
    if(GHOST_UNITY)
        set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
    endif()
    if(GHOST_FUZZ) # without counters in the libraries the fuzzer is blind to them
        target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
    endif()
    if(GHOST_SANITIZE)
        target_compile_options(${target} PUBLIC -fsanitize=${GHOST_SANITIZE} -fno-omit-frame-pointer
            -fno-sanitize-recover=all)
        target_link_options(${target} PUBLIC -fsanitize=${GHOST_SANITIZE})
        # GCC 12 takes what instrumented std::regex copies for uninitialised
        target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    endif()
endfunction()

# Out of a list of files those of other systems: NAME_linux, NAME_posix (Linux and macOS), NAME_mac, NAME_windows; tests alike,
# NAME_posix_test.
function(ghost_only_ours files)
    set(others _windows _mac)
    if(WIN32)
        set(others _linux _posix _mac)
    elseif(APPLE)
        set(others _linux _windows)
    endif()
    foreach(other ${others})
        list(FILTER ${files} EXCLUDE REGEX "${other}(_test)?\\.cpp$")
    endforeach()
    set(${files} ${${files}} PARENT_SCOPE)
endfunction()

# On systems that not all of it was taken to, what needs a library or room that is not there is left out. Of these targets, missing gets
# the first that there is not.
function(ghost_missing missing)
    set(${missing} "" PARENT_SCOPE)
    if(NOT GHOST_PARTIAL)
        return()
    endif()
    foreach(target ${ARGN})
        if(target MATCHES "::|^ghost_" AND NOT TARGET ${target})
            set(${missing} ${target} PARENT_SCOPE)
            return()
        endif()
    endforeach()
endfunction()

# ghost_room(folder [LINKS rooms...] [PUBLIC|PRIVATE targets...]): static library ghost_<folder> of src/<folder>/*.cpp, with _ for /. Headers
# in src/<folder>/private are for the room alone; in src/<folder>/system are files of one system (ghost_only_ours).
function(ghost_room folder)
    cmake_parse_arguments(PARSE_ARGV 1 room "" "" "LINKS;PUBLIC;PRIVATE")
    string(REPLACE "/" "_" name ${folder})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/${folder}/*.cpp ${CMAKE_SOURCE_DIR}/src/${folder}/system/*.cpp)
    set(links ${room_LINKS})
    list(TRANSFORM links REPLACE "/" "_")
    list(TRANSFORM links PREPEND ghost_)
    ghost_only_ours(sources)
    ghost_missing(missing ${links} ${room_PUBLIC} ${room_PRIVATE})
    if(missing OR (GHOST_PARTIAL AND NOT folder IN_LIST GHOST_PORTED))
        return()
    endif()
    if(NOT sources) # plain values
        add_library(ghost_${name} INTERFACE)
        target_link_libraries(ghost_${name} INTERFACE ${links} ${room_PUBLIC})
        return()
    endif()
    add_library(ghost_${name} STATIC ${sources})
    ghost_options(ghost_${name})
    target_link_libraries(ghost_${name} PUBLIC ${links} ${room_PUBLIC} PRIVATE ${room_PRIVATE})
    if(folder MATCHES "^ui/")
        file(GLOB headers CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/${folder}/private/*.h)
        target_sources(ghost_${name} PRIVATE ${headers}) # AUTOMOC looks beside sources for all others
        set_target_properties(ghost_${name} PROPERTIES AUTOMOC ON)
        target_compile_definitions(ghost_${name} PRIVATE QT_NO_KEYWORDS) # TBB has names of its own for them
    endif()
endfunction()

# ghost_test(folder libraries...): test binary test_<folder>, with _ for /, of tests/<folder>/*_test.cpp.
function(ghost_test path)
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/${path}/*_test.cpp)
    string(REPLACE "/" "_" folder ${path})
    ghost_only_ours(sources)
    ghost_missing(missing ${ARGN})
    if(missing)
        return()
    endif()
    add_executable(test_${folder} ${sources})
    ghost_options(test_${folder})
    if(GHOST_SANITIZE)
        target_sources(test_${folder} PRIVATE ${CMAKE_SOURCE_DIR}/tests/sanitize/keep_loaded.cpp)
        set_target_properties(test_${folder} PROPERTIES ENABLE_EXPORTS ON)
    endif()
    if(path IN_LIST GHOST_MODEL_TESTS) # its main() stands before that of gtest_main
        target_sources(test_${folder} PRIVATE ${CMAKE_SOURCE_DIR}/tests/reader_main.cpp)
    endif()
    target_include_directories(test_${folder} PRIVATE ${CMAKE_SOURCE_DIR}/tests)
    target_compile_definitions(test_${folder} PRIVATE GHOST_SOURCE_DIR="${GHOST_DRIVE}${CMAKE_SOURCE_DIR}"
        GHOST_BINARY_DIR="${GHOST_DRIVE}${CMAKE_BINARY_DIR}")
    target_link_libraries(test_${folder} PRIVATE ${ARGN} GTest::gtest_main)
    add_test(NAME ${folder} COMMAND test_${folder} WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
    set(limit_s 1200)
    if(GHOST_SANITIZE) # instrumented code takes several times as long
        set(limit_s 3600)
    endif()
    # What tests of another user or checkout left in /tmp is not theirs to replace.
    file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/tests/tmp)
    set_tests_properties(${folder} PROPERTIES LABELS room TIMEOUT ${limit_s} ENVIRONMENT
        "TEST_TMPDIR=${GHOST_DRIVE}${CMAKE_BINARY_DIR}/tests/tmp;${GHOST_TEST_ENVIRONMENT}")
endfunction()

# ghost_fuzz(file): libFuzzer target fuzz_<name> of <name>_fuzz.cpp, linked to the rooms that it includes, itself or by
# headers of tests/.
function(ghost_fuzz file)
    get_filename_component(folder ${file} DIRECTORY)
    get_filename_component(name ${file} NAME_WE)
    string(REGEX REPLACE "_fuzz$" "" name ${name})
    set(rooms)
    set(files ${file})
    while(files)
        list(POP_FRONT files next)
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${next})
        file(STRINGS ${next} includes REGEX "^#include \"")
        foreach(include ${includes})
            string(REGEX REPLACE "^#include \"(.*)\".*" "\\1" include ${include})
            get_filename_component(room ${include} DIRECTORY)
            if(room STREQUAL "")
                list(APPEND files ${folder}/${include})
            elseif(room MATCHES "^(support|fuzz)$")
                list(APPEND files ${CMAKE_SOURCE_DIR}/tests/${include})
            else()
                string(REPLACE "/private" "" room ${room})
                string(REPLACE "/" "_" room ${room})
                list(APPEND rooms ghost_${room})
            endif()
        endforeach()
    endwhile()
    list(REMOVE_DUPLICATES rooms)
    add_executable(fuzz_${name} ${file})
    ghost_options(fuzz_${name})
    target_include_directories(fuzz_${name} PRIVATE ${CMAKE_SOURCE_DIR}/tests)
    target_compile_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
    target_link_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
    target_link_libraries(fuzz_${name} PRIVATE ${rooms})
endfunction()

# ghost_embed(room folder): puts the files of a folder at the top into the room's library; it reads them through web_files() of
# src/web/private/files.h.
function(ghost_embed room folder)
    file(GLOB files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${folder}/*)
    set(source ${CMAKE_BINARY_DIR}/generated/${folder}_files.cpp)
    add_custom_command(OUTPUT ${source}
        COMMAND ${CMAKE_COMMAND} -DFOLDER=${CMAKE_SOURCE_DIR}/${folder} -DOUTPUT=${source} -P ${CMAKE_SOURCE_DIR}/cmake/embed_files.cmake
        DEPENDS ${files} ${CMAKE_SOURCE_DIR}/cmake/embed_files.cmake
        COMMENT "files of ${folder}" VERBATIM)
    target_sources(ghost_${room} PRIVATE ${source})
endfunction()

# ghost_shaders(libraries...): compiles shaders/<room>/*.comp, *.vert and *.frag to SPIR-V and embeds it; C++ reads it through
# <build>/generated/shaders/<name>.h as kShader_<name>, where the names of vertex and fragment shaders end in _vert and
# _frag, and gives what it binds as <Name>Bindings (cmake/embed.cmake).
function(ghost_shaders)
    file(GLOB_RECURSE shaders CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/shaders/*.comp
        ${CMAKE_SOURCE_DIR}/shaders/*.vert ${CMAKE_SOURCE_DIR}/shaders/*.frag)
    file(GLOB shared CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/shaders/shared/*.h ${CMAKE_SOURCE_DIR}/shaders/common/*.glsl)
    set(headers)
    foreach(shader ${shaders})
        get_filename_component(name ${shader} NAME_WE)
        get_filename_component(stage ${shader} LAST_EXT)
        if(NOT stage STREQUAL ".comp")
            string(REPLACE "." "_" stage ${stage})
            string(APPEND name ${stage})
        endif()
        set(spirv ${CMAKE_BINARY_DIR}/generated/shaders/${name}.spv)
        set(glsl ${CMAKE_BINARY_DIR}/generated/shaders/${name}.glsl)
        set(header ${CMAKE_BINARY_DIR}/generated/shaders/${name}.h)
        add_custom_command(OUTPUT ${header}
            COMMAND ${GLSLC} --target-env=vulkan1.3 -O -Werror -I ${CMAKE_SOURCE_DIR}/shaders -o ${spirv} ${shader}
            COMMAND ${GLSLC} --target-env=vulkan1.3 -E -I ${CMAKE_SOURCE_DIR}/shaders -o ${glsl} ${shader}
            COMMAND ${CMAKE_COMMAND} -DINPUT=${spirv} -DGLSL=${glsl} -DOUTPUT=${header} -DNAME=${name}
                    -P ${CMAKE_SOURCE_DIR}/cmake/embed.cmake
            DEPENDS ${shader} ${shared} ${CMAKE_SOURCE_DIR}/cmake/embed.cmake
            COMMENT "shader ${name}" VERBATIM)
        list(APPEND headers ${header})
    endforeach()
    add_custom_target(ghost_shader_headers DEPENDS ${headers})
    foreach(library ${ARGN})
        add_dependencies(ghost_${library} ghost_shader_headers)
        target_include_directories(ghost_${library} PRIVATE ${CMAKE_BINARY_DIR}/generated)
    endforeach()
endfunction()
