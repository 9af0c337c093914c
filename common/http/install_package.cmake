# Installs what FROM/package-lock.json names, and of PACKAGE the files that FROM/files.txt lists into TO/lib:
# cmake -DNPM=... -DPACKAGE=... -DFROM=... -DTO=... -P install_package.cmake
file(REMOVE_RECURSE ${TO})
file(COPY ${FROM}/package.json ${FROM}/package-lock.json DESTINATION ${TO})
# No scripts of packages run; what npm has in its cache needs no registry.
execute_process(
    COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --prefer-offline --loglevel=error
    WORKING_DIRECTORY ${TO} RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
set(package_folder ${TO}/node_modules/${PACKAGE})
if(NOT result EQUAL 0 OR NOT EXISTS ${package_folder}/package.json)
    message(FATAL_ERROR "The page's ${PACKAGE} could not be installed: npm ci failed (${result}) and said:\n"
        "${said}\n"
        "It needs npm's registry or npm's cache. To build without the page, configure with -DK3D_WEB=OFF.")
endif()
file(STRINGS ${FROM}/files.txt wanted)
foreach(name IN LISTS wanted)
    file(COPY ${package_folder}/${name} DESTINATION ${TO}/lib)
endforeach()
file(COPY_FILE ${package_folder}/LICENSE ${TO}/lib/${PACKAGE}-LICENSE.txt)
file(REMOVE_RECURSE ${TO}/node_modules)
file(TOUCH ${TO}/done)
