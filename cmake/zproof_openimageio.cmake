# OpenImageIO::OpenImageIO for the image module, tests and benchmarks: the program is not linked to it.
# Debian's OpenImageIO names OpenCV's include folder, which is not there unless OpenCV is installed: then CMake refuses
# to generate. No header that we include needs it.
get_target_property(openimageio_folders OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
list(REMOVE_ITEM openimageio_folders /usr/include/opencv4)
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${openimageio_folders}" INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "")
