# Random scenes. Included by scenes/CMakeLists.txt, behind the suite, whose meshes and dice they use.
set(random_dir ${CMAKE_CURRENT_LIST_DIR})
target_sources(zproof_scenes PRIVATE
    ${random_dir}/../random_scenes.cpp
    ${random_dir}/degenerate.cpp
    ${random_dir}/loose.cpp
    ${random_dir}/shared.cpp
    ${random_dir}/stage.cpp
    ${random_dir}/ties.cpp
    ${random_dir}/views.cpp)
