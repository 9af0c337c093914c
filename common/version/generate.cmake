# Writes OUT, the definition of k3d::code_version(), from VERSION and the code at SOURCE.
# Run at every build; the file changes only when the version does.

# The commit, if SOURCE is a checkout of its own (and not a folder somewhere in another's).
execute_process(COMMAND git rev-parse --show-cdup
    WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE above OUTPUT_STRIP_TRAILING_WHITESPACE
    RESULT_VARIABLE failed ERROR_QUIET)
set(version ${VERSION})
if(NOT failed AND above STREQUAL "")
    execute_process(COMMAND git describe --always --dirty --exclude=* --abbrev=12
        WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    string(APPEND version "+${commit}")
    if(commit MATCHES "-dirty$")
        # Two edited trees of one commit are two versions.
        execute_process(COMMAND git diff HEAD WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE edits ERROR_QUIET)
        string(SHA1 hash "${edits}")
        string(SUBSTRING ${hash} 0 8 hash)
        string(APPEND version "-${hash}")
    endif()
else()
    # A tarball or a container's copy: the code itself tells, since ledgers, workers and recordings rely on
    # two versions of it having two names.
    set(code ${SOURCE}/CMakeLists.txt)
    foreach(part server agent common optimizer)
        file(GLOB_RECURSE files ${SOURCE}/${part}/*.cpp ${SOURCE}/${part}/*.h ${SOURCE}/${part}/*.txt
            ${SOURCE}/${part}/*.cmake ${SOURCE}/${part}/*.toml)
        list(APPEND code ${files})
    endforeach()
    list(FILTER code EXCLUDE REGEX "/(node_modules|experiments)/")
    list(SORT code)
    foreach(file IN LISTS code)
        if(EXISTS ${file})
            file(SHA1 ${file} hash)
            file(RELATIVE_PATH name ${SOURCE} ${file})
            string(APPEND hashes "${name} ${hash}\n")
        endif()
    endforeach()
    string(SHA1 hash "${hashes}")
    string(SUBSTRING ${hash} 0 12 hash)
    string(APPEND version "+files-${hash}")
endif()
set(text "#include \"common/version/version.h\"\nnamespace k3d {\nstd::string_view code_version() { return \"${version}\"; }\n}\n")
if(EXISTS ${OUT})
    file(READ ${OUT} old)
endif()
if(NOT "${old}" STREQUAL "${text}")
    file(WRITE ${OUT} "${text}")
endif()
