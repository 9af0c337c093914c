# Installs what package-lock.json names into TO/lib: cmake -DNPM=... -DFROM=... -DTO=... -P install.cmake
file(REMOVE_RECURSE ${TO})
file(COPY ${FROM}/package.json ${FROM}/package-lock.json DESTINATION ${TO})
# No scripts of packages run; what npm has in its cache needs no registry.
execute_process(
    COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --prefer-offline --loglevel=error
    WORKING_DIRECTORY ${TO} RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
set(three ${TO}/node_modules/three)
if(NOT result EQUAL 0 OR NOT EXISTS ${three}/build/three.module.js)
    message(FATAL_ERROR "The page's three.js could not be installed: npm ci failed (${result}) and said:\n"
        "${said}\n"
        "It needs npm's registry or npm's cache. To build without the page, configure with -DK3D_WEB=OFF.")
endif()
file(COPY ${three}/build/three.module.js ${three}/build/three.core.js
    ${three}/examples/jsm/controls/OrbitControls.js DESTINATION ${TO}/lib)
file(COPY_FILE ${three}/LICENSE ${TO}/lib/three-LICENSE.txt)
file(REMOVE_RECURSE ${TO}/node_modules)
file(TOUCH ${TO}/done)
