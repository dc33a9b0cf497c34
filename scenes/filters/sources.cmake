# The filter scenes. Included by scenes/CMakeLists.txt, behind the suite, whose meshes and dice they use.
set(filters_dir ${CMAKE_CURRENT_LIST_DIR})
target_sources(zproof_scenes PRIVATE
    ${filters_dir}/../filter_scenes.cpp
    ${filters_dir}/charts.cpp
    ${filters_dir}/planes.cpp
    ${filters_dir}/text.cpp
    ${filters_dir}/textured_mesh.cpp
    ${filters_dir}/textures.cpp
    ${filters_dir}/tunnel.cpp)
