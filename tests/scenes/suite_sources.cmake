# The suite's tests. Included by tests/scenes/CMakeLists.txt.
target_sources(scenes_test PRIVATE
    ${CMAKE_CURRENT_LIST_DIR}/glb_writer_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/suite_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/suite_geometry_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/suite_questions_test.cpp)
