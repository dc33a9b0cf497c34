# The suite's generators, and its manifest as a string in the library. Included by scenes/CMakeLists.txt.
set(suite_dir ${CMAKE_CURRENT_LIST_DIR})
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${suite_dir}/manifest.json)
file(READ ${suite_dir}/manifest.json ZPROOF_SUITE_MANIFEST)
configure_file(${suite_dir}/manifest.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/suite_manifest.cpp @ONLY)

find_package(ZLIB REQUIRED)
target_link_libraries(zproof_scenes PRIVATE ZLIB::ZLIB nlohmann_json::nlohmann_json)
target_sources(zproof_scenes PRIVATE
    ${suite_dir}/../suite.cpp
    ${suite_dir}/../glb_writer.cpp
    ${suite_dir}/../view_document.cpp
    ${CMAKE_CURRENT_BINARY_DIR}/suite_manifest.cpp
    ${suite_dir}/cracks.cpp
    ${suite_dir}/cuts.cpp
    ${suite_dir}/density.cpp
    ${suite_dir}/extent.cpp
    ${suite_dir}/facing.cpp
    ${suite_dir}/fill_rule.cpp
    ${suite_dir}/indices.cpp
    ${suite_dir}/mesh_builder.cpp
    ${suite_dir}/near_plane.cpp
    ${suite_dir}/planes.cpp
    ${suite_dir}/projections.cpp
    ${suite_dir}/random.cpp
    ${suite_dir}/room.cpp
    ${suite_dir}/shapes.cpp
    ${suite_dir}/sizes.cpp
    ${suite_dir}/stacks.cpp
    ${suite_dir}/textured_ground.cpp
    ${suite_dir}/ties.cpp
    ${suite_dir}/tiny.cpp
    ${suite_dir}/unit_circle.cpp
    ${suite_dir}/views.cpp)
