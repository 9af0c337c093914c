# k3d_page(TARGET FOLDER PACKAGE FILES...): a page of the calling folder, assembled in <build>/FOLDER of the named
# FILES and, in lib/, of one npm package. No bundler: which of the package's files are copied is the list
# `files.txt` beside package.json. Without K3D_WEB or npm there is no TARGET, and --http says so.
option(K3D_WEB "Build the pages of k3d-server and k3d-optimizer (needs npm)" ON)
find_program(NPM npm)
if(NOT K3D_WEB)
    message(STATUS "K3D_WEB is off: the programs will have no page, and --http will say so")
elseif(NOT NPM)
    message(WARNING "npm was not found: the programs will have no page, and --http will say so. "
        "Install npm (docker/setup does) and configure again.")
endif()
set(K3D_INSTALL_PACKAGE ${CMAKE_CURRENT_LIST_DIR}/install_package.cmake)

function(k3d_page target folder package)
    if(NOT K3D_WEB OR NOT NPM)
        return()
    endif()
    set(files ${ARGN})
    list(TRANSFORM files PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
    set(npm_folder ${CMAKE_BINARY_DIR}/npm-${folder})
    set(web_folder ${CMAKE_BINARY_DIR}/${folder})
    # npm's part changes only with the lock file, so that an edit of the page asks no registry.
    add_custom_command(OUTPUT ${npm_folder}/done
        COMMAND ${CMAKE_COMMAND} -DNPM=${NPM} -DPACKAGE=${package} -DFROM=${CMAKE_CURRENT_SOURCE_DIR}
            -DTO=${npm_folder} -P ${K3D_INSTALL_PACKAGE}
        DEPENDS package.json package-lock.json files.txt ${K3D_INSTALL_PACKAGE}
        COMMENT "Installing ${package} with npm ci" VERBATIM)
    add_custom_command(OUTPUT ${web_folder}/done
        COMMAND ${CMAKE_COMMAND} -E rm -rf ${web_folder}
        COMMAND ${CMAKE_COMMAND} -E make_directory ${web_folder}
        COMMAND ${CMAKE_COMMAND} -E copy ${files} ${web_folder}
        COMMAND ${CMAKE_COMMAND} -E copy_directory ${npm_folder}/lib ${web_folder}/lib
        COMMAND ${CMAKE_COMMAND} -E touch ${web_folder}/done
        DEPENDS ${npm_folder}/done ${files}
        COMMENT "Assembling ${folder}" VERBATIM)
    add_custom_target(${target} ALL DEPENDS ${web_folder}/done)
endfunction()
