# SPDX-License-Identifier: Apache-2.0
# ghost_translations(room): compiles assets/translations/*.ts and puts them into the room's library, which reads them
# through catalogues() of src/<room>/private/catalogues.h.
function(ghost_translations room)
    string(REPLACE "/" "_" name ${room})
    file(GLOB catalogues CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/assets/translations/*.ts)
    set(folder ${CMAKE_BINARY_DIR}/generated/translations)
    file(MAKE_DIRECTORY ${folder})
    set(compiled)
    foreach(catalogue ${catalogues})
        get_filename_component(language ${catalogue} NAME_WE)
        add_custom_command(OUTPUT ${folder}/${language}.qm
            COMMAND ${LRELEASE} -silent -nounfinished ${catalogue} -qm ${folder}/${language}.qm
            DEPENDS ${catalogue} COMMENT "texts ${language}" VERBATIM)
        list(APPEND compiled ${folder}/${language}.qm)
    endforeach()
    set(source ${CMAKE_BINARY_DIR}/generated/catalogues.cpp)
    add_custom_command(OUTPUT ${source}
        COMMAND ${CMAKE_COMMAND} -DFOLDER=${folder} -DOUTPUT=${source} -P ${CMAKE_SOURCE_DIR}/cmake/embed_translations.cmake
        DEPENDS ${compiled} ${CMAKE_SOURCE_DIR}/cmake/embed_translations.cmake
        COMMENT "texts of the window" VERBATIM)
    target_sources(ghost_${name} PRIVATE ${source})
endfunction()
