# zproof_room(name SOURCES a.cpp ... USES rooms-and-libraries ...): one static library per folder, zproof::name.
function(zproof_room name)
    cmake_parse_arguments(ROOM "" "" "SOURCES;USES" ${ARGN})
    add_library(zproof_${name} STATIC ${ROOM_SOURCES})
    add_library(zproof::${name} ALIAS zproof_${name})
    set_target_properties(zproof_${name} PROPERTIES EXPORT_NAME ${name})
    target_link_libraries(zproof_${name} PUBLIC zproof_strict ${ROOM_USES})
endfunction()

# zproof_test(room SOURCES a_test.cpp ... USES ...): one test program per room; every TEST is one ctest entry.
function(zproof_test room)
    cmake_parse_arguments(TEST "" "" "SOURCES;USES" ${ARGN})
    add_executable(${room}_test ${TEST_SOURCES})
    target_link_libraries(${room}_test PRIVATE zproof_strict ${TEST_USES} GTest::gtest_main)
    gtest_discover_tests(${room}_test DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600)
endfunction()
