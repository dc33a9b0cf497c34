# What most sources include, parsed once for each level of optimization. A source still names all that it needs.
set(zproof_precompiled
    <algorithm> <array> <cmath> <cstdint> <filesystem> <fstream> <functional> <iterator> <limits> <map> <memory> <optional>
    <span> <sstream> <stdexcept> <string> <string_view> <utility> <vector> <glm/glm.hpp>)

# zproof_build_quickly(target [OPTIMIZE -O1] [LIBRARY name HEADER <name.h>]): all targets of the same options share what is
# precompiled, that library's header too.
function(zproof_build_quickly target)
    cmake_parse_arguments(BUILD "" "OPTIMIZE;LIBRARY;HEADER" "" ${ARGN})
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${BUILD_OPTIMIZE}>)
    string(MAKE_C_IDENTIFIER "zproof_precompiled${BUILD_OPTIMIZE}${BUILD_LIBRARY}" headers)
    if(NOT TARGET ${headers})
        file(CONFIGURE OUTPUT nothing_else.cpp CONTENT "")
        add_library(${headers} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/nothing_else.cpp)
        target_link_libraries(${headers} PRIVATE zproof_strict ${BUILD_LIBRARY})
        target_compile_options(${headers} PRIVATE $<$<CONFIG:Release>:${BUILD_OPTIMIZE}>)
        target_precompile_headers(${headers} PRIVATE ${zproof_precompiled} ${BUILD_HEADER})
    endif()
    target_precompile_headers(${target} REUSE_FROM ${headers})
    get_target_property(type ${target} TYPE)
    if(type STREQUAL "EXECUTABLE")  # for which CMake takes -fPIE, unlike what is precompiled
        set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
        target_compile_options(${target} PRIVATE -fPIC)
    endif()
endfunction()

# zproof_room(name SOURCES a.cpp ... USES rooms-and-libraries ... [OPTIMIZE -O1] [BY_FOLDER]): one static library per
# folder, zproof::name. A room that only shows and reads text is optimized less, for a quick build. BY_FOLDER: sources that
# are compiled as one lie in one folder of the room, since its folders use names for different things.
function(zproof_room name)
    cmake_parse_arguments(ROOM BY_FOLDER OPTIMIZE "SOURCES;USES" ${ARGN})
    add_library(zproof_${name} STATIC ${ROOM_SOURCES})
    add_library(zproof::${name} ALIAS zproof_${name})
    set_target_properties(zproof_${name} PROPERTIES EXPORT_NAME ${name})
    target_link_libraries(zproof_${name} PUBLIC zproof_strict ${ROOM_USES})
    zproof_build_quickly(zproof_${name} OPTIMIZE ${ROOM_OPTIMIZE})
    if(ROOM_BY_FOLDER)
        set_target_properties(zproof_${name} PROPERTIES UNITY_BUILD_MODE GROUP)
        foreach(source IN LISTS ROOM_SOURCES)
            get_filename_component(folder ${source} DIRECTORY)
            math(EXPR count_${folder} "${count_${folder}} + 1")
            math(EXPR batch "${count_${folder}} / 8")
            set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder}_${batch})
        endforeach()
    endif()
endfunction()

# zproof_test(room SOURCES a_test.cpp ... USES ... [SLOW filter] [SAMPLED filter] [TOGETHER]): one test program per
# room; every TEST is one ctest entry, or all are TOGETHER where a process of its own costs more than a test. Those that
# a filter of GoogleTest matches have the label slow: `./dev test` leaves them out, but runs every tenth of SAMPLED
# ones. A name has no value in it: ctest begins with what took longest, and forgets how long a name with a blank took.
# What is tested is compiled as it is shipped; the tests themselves, for a quick build, are optimized less. Each source
# is compiled by itself: tests share more names than programs do.
function(zproof_test room)
    cmake_parse_arguments(TEST TOGETHER "SLOW;SAMPLED" "SOURCES;USES" ${ARGN})
    add_executable(${room}_test ${TEST_SOURCES})
    target_link_libraries(${room}_test PRIVATE zproof_strict ${TEST_USES} GTest::gtest_main)
    set_target_properties(${room}_test PROPERTIES UNITY_BUILD OFF)
    zproof_build_quickly(${room}_test OPTIMIZE -O1 LIBRARY GTest::gtest_main HEADER <gtest/gtest.h>)
    set(slow ${TEST_SLOW} ${TEST_SAMPLED})
    list(JOIN slow ":" slow)
    if(TEST_TOGETHER)
        add_test(NAME ${room}.Together COMMAND ${room}_test --gtest_brief=1 --gtest_filter=-${slow})
        set_tests_properties(${room}.Together PROPERTIES TIMEOUT 600 COST 50)
    else()
        gtest_discover_tests(${room}_test TEST_FILTER "-${slow}" NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600)
    endif()
    if(NOT slow)
        return()
    endif()
    gtest_discover_tests(${room}_test TEST_FILTER "${slow}" NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 1800 LABELS slow)
    if(TEST_SAMPLED)
        add_test(NAME ${room}.EveryTenth COMMAND ${room}_test --gtest_filter=${TEST_SAMPLED})
        set_tests_properties(${room}.EveryTenth PROPERTIES TIMEOUT 1200 COST 100
                             ENVIRONMENT "GTEST_TOTAL_SHARDS=10;GTEST_SHARD_INDEX=0")
    endif()
endfunction()
