# find_package(zproof): the libraries zproof::scenes, zproof::compare and so on, with what they stand on.
include(CMakeFindDependencyMacro)
find_dependency(TBB)
find_dependency(embree 3.13)
find_dependency(OpenImageIO)
find_dependency(TinyGLTF)
find_dependency(nlohmann_json)
find_dependency(Boost)
find_dependency(glm)
find_dependency(ZLIB)
find_package(OpenGL QUIET COMPONENTS OpenGL EGL)  # where zproof was built with it
# Debian's OpenImageIO names OpenCV's include folder, which need not be there.
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "/usr/include"
                      INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "")
include(${CMAKE_CURRENT_LIST_DIR}/zproof-targets.cmake)
