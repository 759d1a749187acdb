# SPDX-License-Identifier: Apache-2.0
# Programs for 64-bit Windows, compiled on Linux (g++-mingw-w64-x86-64-posix) and run by Wine where it is there. Libraries that Debian
# does not have for it are those of tools/windows_libraries.sh.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)

# Of Windows 10 on. Sizes and times are printed as the C++ library's own printf does, which knows them.
set(CMAKE_C_FLAGS_INIT "-D_WIN32_WINNT=0x0A00 -D__USE_MINGW_ANSI_STDIO=1")
set(CMAKE_CXX_FLAGS_INIT "${CMAKE_C_FLAGS_INIT}")
# What CMake tries is one file without DLLs beside it. Objects of a room that is one unit have more sections than the older format holds.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static")
string(APPEND CMAKE_CXX_FLAGS_INIT " -Wa,-mbig-obj")

get_filename_component(ghost_windows_libraries ${CMAKE_CURRENT_LIST_DIR}/../build/windows_libraries ABSOLUTE)
set(CMAKE_FIND_ROOT_PATH /usr/x86_64-w64-mingw32 ${ghost_windows_libraries})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_LIBDIR} ${ghost_windows_libraries}/lib/pkgconfig:/usr/x86_64-w64-mingw32/lib/pkgconfig)
set(ENV{PKG_CONFIG_PATH} "")

find_program(GHOST_WINE NAMES wine64 wine PATHS /usr/lib/wine)
if(GHOST_WINE)
    set(CMAKE_CROSSCOMPILING_EMULATOR ${GHOST_WINE})
    set(GHOST_DRIVE "Z:") # where Wine has the folders of the machine
    set(GHOST_TEST_ENVIRONMENT "WINEDEBUG=-all;WINEPREFIX=${CMAKE_BINARY_DIR}/wine")
endif()
