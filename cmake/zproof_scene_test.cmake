# A test per scene in anybody's CMake project (docs/ci.md):
#
#   zproof_add_scene_test(NAME name [SCENE scene] RENDERER who [PRECISION promise]
#                         [RESOLUTION 640x480] [TIMEOUT seconds] [EVIDENCE folder] [LABELS label ...] [OPTIONS option ...])
#
# NAME       of the test; also the scene where SCENE is not given
# SCENE      a scene of zproof's suite, or a .gltf, .glb, .obj, .ply or .json file; relative to the current source folder
# RENDERER   a name that zproof knows, or a command with {scene}, {camera}, {width}, {height} and {out} in it. Generator
#            expressions are understood: "$<TARGET_FILE:mine> {scene} {camera} {width} {height} {out}"
# PRECISION  what the renderer promises, as of zproof run --precision
# RESOLUTION of suite scenes and glTF files, WIDTHxHEIGHT
# TIMEOUT    of the whole test, seconds; 600
# EVIDENCE   where report.html, results.json, junit.xml and the frames go; zproof/NAME in the current build folder
# LABELS     beside "zproof", which every such test has
# OPTIONS    further options of zproof run
#
# The test passes where zproof ends with 0 and fails with every other status, also where nothing was judged.
function(zproof_add_scene_test)
    cmake_parse_arguments(PARSE_ARGV 0 TEST ""
        "NAME;SCENE;RENDERER;PRECISION;RESOLUTION;TIMEOUT;EVIDENCE" "LABELS;OPTIONS")
    if(TEST_UNPARSED_ARGUMENTS)
        message(FATAL_ERROR "zproof_add_scene_test: unknown arguments: ${TEST_UNPARSED_ARGUMENTS}")
    endif()
    if(NOT TEST_NAME OR NOT TEST_RENDERER)
        message(FATAL_ERROR "zproof_add_scene_test: NAME and RENDERER are needed")
    endif()
    if(NOT TEST_SCENE)
        set(TEST_SCENE ${TEST_NAME})
    endif()
    if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${TEST_SCENE})  # else a scene of the suite, or a file yet to be made
        set(TEST_SCENE ${CMAKE_CURRENT_SOURCE_DIR}/${TEST_SCENE})
    endif()
    if(NOT TEST_TIMEOUT)
        set(TEST_TIMEOUT 600)
    endif()
    if(NOT TEST_EVIDENCE)
        set(TEST_EVIDENCE ${CMAKE_CURRENT_BINARY_DIR}/zproof/${TEST_NAME})
    endif()

    string(REPLACE ";" "\\;" TEST_RENDERER "${TEST_RENDERER}")  # a shell's, not a list's
    set(options --out ${TEST_EVIDENCE} --renderer ${TEST_RENDERER})
    if(TEST_PRECISION)
        list(APPEND options --precision ${TEST_PRECISION})
    endif()
    if(TEST_RESOLUTION)
        if(NOT TEST_RESOLUTION MATCHES "^([0-9]+)x([0-9]+)$")
            message(FATAL_ERROR "zproof_add_scene_test: RESOLUTION ${TEST_RESOLUTION}: WIDTHxHEIGHT expected")
        endif()
        list(APPEND options --width ${CMAKE_MATCH_1} --height ${CMAKE_MATCH_2})
    endif()

    # Below add_subdirectory(zproof EXCLUDE_FROM_ALL) nobody else asks for the program.
    get_target_property(is_installed zproof::zproof IMPORTED)
    if(NOT is_installed AND NOT TARGET zproof_of_scene_tests)
        add_custom_target(zproof_of_scene_tests ALL)
        add_dependencies(zproof_of_scene_tests zproof)
    endif()
    add_test(NAME ${TEST_NAME} COMMAND $<TARGET_FILE:zproof::zproof> run ${TEST_SCENE} ${options} ${TEST_OPTIONS})
    set_tests_properties(${TEST_NAME} PROPERTIES
        LABELS "zproof;${TEST_LABELS}"
        TIMEOUT ${TEST_TIMEOUT}
        ATTACHED_FILES_ON_FAIL "${TEST_EVIDENCE}/report.html;${TEST_EVIDENCE}/results.json")
endfunction()
