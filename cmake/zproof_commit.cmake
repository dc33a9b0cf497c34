# At each build: cmake -DSOURCE=folder -DTEMPLATE=commit.cpp.in -DOUTPUT=commit.cpp -P zproof_commit.cmake
# Writes which commit of zproof is built. The output is written anew only where it changed, so that nothing is compiled
# in vain.

# The commit of a clone, with ", changed" where a tracked file differs from it. Nothing where SOURCE is no clone, also
# where it lies in another project's.
function(commit_of_clone result)
    set(${result} "" PARENT_SCOPE)
    set(git git --no-optional-locks -C ${SOURCE})
    execute_process(COMMAND ${git} rev-parse --show-toplevel HEAD
        OUTPUT_VARIABLE answer ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(NOT answer MATCHES "^(.*)\n([0-9a-f]+)$")
        return()
    endif()
    set(top ${CMAKE_MATCH_1})
    string(SUBSTRING ${CMAKE_MATCH_2} 0 12 commit)
    file(REAL_PATH ${SOURCE} source)
    file(REAL_PATH ${top} top)
    if(NOT source STREQUAL top)
        return()
    endif()
    execute_process(COMMAND ${git} status --porcelain --untracked-files=no OUTPUT_VARIABLE changes)
    if(changes)
        string(APPEND commit ", changed")
    endif()
    set(${result} ${commit} PARENT_SCOPE)
endfunction()

# The commit of a tree that git archive wrote.
function(commit_of_archive result)
    set(${result} "" PARENT_SCOPE)
    file(READ ${SOURCE}/cmake/commit.txt text)
    if(text MATCHES "^[0-9a-f]+")
        string(SUBSTRING ${CMAKE_MATCH_0} 0 12 commit)
        set(${result} ${commit} PARENT_SCOPE)
    endif()
endfunction()

commit_of_clone(ZPROOF_COMMIT)
if(NOT ZPROOF_COMMIT)
    commit_of_archive(ZPROOF_COMMIT)
endif()
if(NOT ZPROOF_COMMIT)
    set(ZPROOF_COMMIT unknown)
endif()
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
