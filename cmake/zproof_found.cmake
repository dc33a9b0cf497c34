# What zproof is built with. All that is missing is said at once, by the names of Debian's packages.
set(ZPROOF_MISSING "")

# zproof_find(debian-package NAME [VERSION]): find_package. A macro, since what it sets is the caller's.
macro(zproof_find debian)
    find_package(${ARGN} QUIET)
    if(NOT ${ARGV1}_FOUND)
        list(APPEND ZPROOF_MISSING ${debian})
    endif()
endmacro()

# Embree 3 or 4 (oracle/rtcore.h). Its own file would accept one of them only.
macro(zproof_find_embree)
    zproof_find(libembree-dev embree)
    if(embree_FOUND AND (embree_VERSION VERSION_LESS 3.13 OR embree_VERSION VERSION_GREATER_EQUAL 5))
        list(APPEND ZPROOF_MISSING libembree-dev)
    endif()
endmacro()

# Of a library that brings no file for CMake: one of its headers.
macro(zproof_find_header debian header)
    find_path(ZPROOF_FOLDER_OF_${debian} ${header})
    mark_as_advanced(ZPROOF_FOLDER_OF_${debian})
    if(NOT ZPROOF_FOLDER_OF_${debian})
        list(APPEND ZPROOF_MISSING ${debian})
    endif()
endmacro()

function(zproof_refuse_what_is_missing)
    if(ZPROOF_MISSING)
        list(JOIN ZPROOF_MISSING " " names)
        string(CONCAT remark "docs/dependencies.md says what each is for. "
            "Another version of one may be here: docs/cli.md, \"If it does not work\".")
        message(FATAL_ERROR "zproof needs libraries that are not here. "
            "On Debian: apt-get install --no-install-recommends ${names}\n"
            "Elsewhere: the packages that hold the same libraries. ${remark}")
    endif()
endfunction()
