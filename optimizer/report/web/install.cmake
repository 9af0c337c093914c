# Installs what package-lock.json names into TO/lib: cmake -DNPM=... -DFROM=... -DTO=... -P install.cmake
file(REMOVE_RECURSE ${TO})
file(COPY ${FROM}/package.json ${FROM}/package-lock.json DESTINATION ${TO})
# No scripts of packages run; what npm has in its cache needs no registry.
execute_process(
    COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --prefer-offline --loglevel=error
    WORKING_DIRECTORY ${TO} RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
set(uplot ${TO}/node_modules/uplot)
if(NOT result EQUAL 0 OR NOT EXISTS ${uplot}/dist/uPlot.esm.js)
    message(FATAL_ERROR "The run page's uPlot could not be installed: npm ci failed (${result}) and said:\n"
        "${said}\n"
        "It needs npm's registry or npm's cache. To build without the page, configure with -DK3D_WEB=OFF.")
endif()
file(COPY ${uplot}/dist/uPlot.esm.js ${uplot}/dist/uPlot.min.css DESTINATION ${TO}/lib)
file(COPY_FILE ${uplot}/LICENSE ${TO}/lib/uplot-LICENSE.txt)
file(REMOVE_RECURSE ${TO}/node_modules)
file(TOUCH ${TO}/done)
