# SPDX-License-Identifier: Apache-2.0
# How our own targets are built: warnings are errors, includes start at src/ and shaders/.

function(ghost_options target)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -Wshadow -Wnon-virtual-dtor
        -Wno-missing-field-initializers -Werror)
    target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/src>
        $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/shaders> $<INSTALL_INTERFACE:include/ghostlight>)
    if(GHOST_FUZZ) # without counters in the libraries the fuzzer is blind to them
        target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
    endif()
    if(GHOST_SANITIZE)
        target_compile_options(${target} PUBLIC -fsanitize=${GHOST_SANITIZE} -fno-omit-frame-pointer
            -fno-sanitize-recover=all)
        target_link_options(${target} PUBLIC -fsanitize=${GHOST_SANITIZE})
    endif()
endfunction()

# ghost_library(name PUBLIC ... PRIVATE ...): static library ghost_<name> of src/<name>/*.cpp.
function(ghost_library name)
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/${name}/*.cpp)
    if(sources)
        add_library(ghost_${name} STATIC ${sources})
        ghost_options(ghost_${name})
        target_link_libraries(ghost_${name} ${ARGN})
    else()
        add_library(ghost_${name} INTERFACE)
    endif()
endfunction()

# ghost_test(folder libraries...): test binary test_<folder> of tests/<folder>/*_test.cpp.
function(ghost_test folder)
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/${folder}/*_test.cpp)
    if(NOT sources)
        return()
    endif()
    add_executable(test_${folder} ${sources})
    ghost_options(test_${folder})
    if(GHOST_SANITIZE)
        target_sources(test_${folder} PRIVATE ${CMAKE_SOURCE_DIR}/tests/sanitize/keep_loaded.cpp)
        set_target_properties(test_${folder} PROPERTIES ENABLE_EXPORTS ON)
    endif()
    if(folder IN_LIST GHOST_MODEL_TESTS) # its main() stands before that of gtest_main
        target_sources(test_${folder} PRIVATE ${CMAKE_SOURCE_DIR}/tests/reader_main.cpp)
    endif()
    target_compile_definitions(test_${folder} PRIVATE GHOST_SOURCE_DIR="${CMAKE_SOURCE_DIR}"
        GHOST_BINARY_DIR="${CMAKE_BINARY_DIR}")
    target_link_libraries(test_${folder} PRIVATE ${ARGN} GTest::gtest_main)
    add_test(NAME ${folder} COMMAND test_${folder} WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
    set(limit_s 1200)
    if(GHOST_SANITIZE) # instrumented code takes several times as long
        set(limit_s 3600)
    endif()
    # What tests of another user or checkout left in /tmp is not theirs to replace.
    file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/tests/tmp)
    set_tests_properties(${folder} PROPERTIES TIMEOUT ${limit_s} ENVIRONMENT TEST_TMPDIR=${CMAKE_BINARY_DIR}/tests/tmp)
endfunction()

# ghost_fuzz(name libraries...): libFuzzer target fuzz_<name> of tests/fuzz/<name>_fuzz.cpp.
function(ghost_fuzz name)
    add_executable(fuzz_${name} ${CMAKE_SOURCE_DIR}/tests/fuzz/${name}_fuzz.cpp)
    ghost_options(fuzz_${name})
    target_compile_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
    target_link_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
    target_link_libraries(fuzz_${name} PRIVATE ${ARGN})
endfunction()

# ghost_shaders(library): compiles shaders/*.comp, *.vert and *.frag to SPIR-V and embeds it; C++ reads it through
# <build>/generated/shaders/<name>.h as kShader_<name>, where the names of vertex and fragment shaders end in _vert and
# _frag.
function(ghost_shaders library)
    file(GLOB shaders CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/shaders/*.comp
        ${CMAKE_SOURCE_DIR}/shaders/*.vert ${CMAKE_SOURCE_DIR}/shaders/*.frag)
    file(GLOB shared CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/shaders/shared/*.h ${CMAKE_SOURCE_DIR}/shaders/*.glsl)
    set(headers)
    foreach(shader ${shaders})
        get_filename_component(name ${shader} NAME_WE)
        get_filename_component(stage ${shader} LAST_EXT)
        if(NOT stage STREQUAL ".comp")
            string(REPLACE "." "_" stage ${stage})
            string(APPEND name ${stage})
        endif()
        set(spirv ${CMAKE_BINARY_DIR}/generated/shaders/${name}.spv)
        set(header ${CMAKE_BINARY_DIR}/generated/shaders/${name}.h)
        add_custom_command(OUTPUT ${header}
            COMMAND ${GLSLC} --target-env=vulkan1.3 -O -Werror -I ${CMAKE_SOURCE_DIR}/shaders -o ${spirv} ${shader}
            COMMAND ${CMAKE_COMMAND} -DINPUT=${spirv} -DOUTPUT=${header} -DNAME=kShader_${name}
                    -P ${CMAKE_SOURCE_DIR}/cmake/embed.cmake
            DEPENDS ${shader} ${shared} ${CMAKE_SOURCE_DIR}/cmake/embed.cmake
            COMMENT "shader ${name}" VERBATIM)
        list(APPEND headers ${header})
    endforeach()
    if(headers AND TARGET ghost_${library})
        add_custom_target(ghost_shader_headers DEPENDS ${headers})
        get_target_property(kind ghost_${library} TYPE)
        if(NOT kind STREQUAL "INTERFACE_LIBRARY")
            add_dependencies(ghost_${library} ghost_shader_headers)
            target_include_directories(ghost_${library} PRIVATE ${CMAKE_BINARY_DIR}/generated)
        endif()
    endif()
endfunction()
