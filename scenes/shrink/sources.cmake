# The shrinker. Included by scenes/CMakeLists.txt.
set(shrink_dir ${CMAKE_CURRENT_LIST_DIR})
target_sources(zproof_scenes PRIVATE
    ${shrink_dir}/../shrink.cpp
    ${shrink_dir}/camera.cpp
    ${shrink_dir}/coordinates.cpp
    ${shrink_dir}/digits.cpp
    ${shrink_dir}/picture.cpp
    ${shrink_dir}/triangles.cpp)
