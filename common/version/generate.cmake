# Writes OUT, the definition of k3d::code_version(), from VERSION and the checkout at SOURCE.
# Run at every build; the file changes only when the version does.
execute_process(COMMAND git describe --always --dirty --exclude=* --abbrev=12
    WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE
    RESULT_VARIABLE failed ERROR_QUIET)
set(version ${VERSION})
if(NOT failed)
    string(APPEND version "+${commit}")
    if(commit MATCHES "-dirty$")
        # Two edited trees of one commit are two versions.
        execute_process(COMMAND git diff HEAD WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE edits ERROR_QUIET)
        string(SHA1 hash "${edits}")
        string(SUBSTRING ${hash} 0 8 hash)
        string(APPEND version "-${hash}")
    endif()
endif()
set(text "#include \"common/version/version.h\"\nnamespace k3d {\nstd::string_view code_version() { return \"${version}\"; }\n}\n")
if(EXISTS ${OUT})
    file(READ ${OUT} old)
endif()
if(NOT "${old}" STREQUAL "${text}")
    file(WRITE ${OUT} "${text}")
endif()
