# cpack -G DEB in the build folder: zproof_VERSION_ARCH.deb, the program, and libzproof-dev_VERSION_ARCH.deb, the libraries.
# VERSION names the system that they are built for, as its /etc/os-release does: 0.2.0-debian12, 0.2.0-ubuntu24.04.
# ./dev package builds zproof_packaged, all that is in them, and calls packaging/make.sh.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME zproof)
set(ZPROOF_MAINTAINER "The authors of zproof <noreply@zproof.invalid>" CACHE STRING "who answers for the packages")
set(CPACK_PACKAGE_CONTACT ${ZPROOF_MAINTAINER})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(packages zproof libzproof-dev)
if(TARGET zproof_python)
    list(APPEND packages python3-zproof)
endif()
set(CPACK_COMPONENTS_ALL ${packages})
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
cmake_host_system_information(RESULT system QUERY DISTRIB_INFO)
set(CPACK_DEBIAN_PACKAGE_RELEASE ${system_ID}${system_VERSION_ID})
set(package_version ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})

set(CPACK_DEBIAN_ZPROOF_PACKAGE_NAME zproof)
set(CPACK_DEBIAN_ZPROOF_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_ZPROOF_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_ZPROOF_PACKAGE_RECOMMENDS "povray, libgl1-mesa-dri, mesa-vulkan-drivers")
set(CPACK_COMPONENT_ZPROOF_DESCRIPTION "zproof renders a scene with the rasterizer under test, asks independent
references what every pixel should hold, and decides every difference from
the geometry itself, with error bounds derived from the arithmetic that the
renderer declares. No threshold is tuned and no golden image is kept.")

# What find_package(zproof) and zproof.pc ask for.
set(CPACK_DEBIAN_LIBZPROOF-DEV_PACKAGE_NAME libzproof-dev)
set(CPACK_DEBIAN_LIBZPROOF-DEV_PACKAGE_SECTION libdevel)
set(development_packages "zproof (= ${package_version})" libboost-dev libdraco-dev libegl-dev libeigen3-dev libembree-dev libglm-dev libgmp-dev libisal-dev
    libmeshoptimizer-dev nettle-dev libopengl-dev libtbb-dev libtinygltf-dev libtinyobjloader-dev libwebp-dev nlohmann-json3-dev zlib1g-dev)
list(JOIN development_packages ", " CPACK_DEBIAN_LIBZPROOF-DEV_PACKAGE_DEPENDS)
set(CPACK_COMPONENT_LIBZPROOF-DEV_DESCRIPTION "Static libraries, headers, CMake package and pkg-config file: load a scene,
trace it, and hand your own frames to the judge.")

set(CPACK_DEBIAN_PYTHON3-ZPROOF_PACKAGE_NAME python3-zproof)
set(CPACK_DEBIAN_PYTHON3-ZPROOF_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON3-ZPROOF_PACKAGE_SHLIBDEPS ON)
if(TARGET zproof_python)
    # The module is built for one version of Python.
    get_target_property(python zproof_python PYTHON_VERSION)
    string(REGEX MATCH "^([0-9]+)\\.([0-9]+)" of_python "${python}")
    math(EXPR next "${CMAKE_MATCH_2} + 1")
    set(needed "zproof (= ${package_version})" "python3 (>= ${of_python})" "python3 (<< ${CMAKE_MATCH_1}.${next})" python3-numpy)
    list(JOIN needed ", " CPACK_DEBIAN_PYTHON3-ZPROOF_PACKAGE_DEPENDS)
endif()
set(CPACK_COMPONENT_PYTHON3-ZPROOF_DESCRIPTION "Python module: hand numpy arrays of triangle ids and depths to the judge,
in a test (there is a pytest plugin) or a notebook, and read the verdict.")

# Debian's own two files of every package.
configure_file(${PROJECT_SOURCE_DIR}/cmake/debian/changelog.in ${PROJECT_BINARY_DIR}/changelog @ONLY)
add_custom_command(OUTPUT changelog.Debian.gz DEPENDS ${PROJECT_BINARY_DIR}/changelog
    COMMAND gzip -9 -n -c changelog > changelog.Debian.gz)
add_custom_target(zproof_changelog ALL DEPENDS changelog.Debian.gz)
foreach(package IN LISTS packages)
    install(FILES ${PROJECT_SOURCE_DIR}/cmake/debian/copyright ${PROJECT_BINARY_DIR}/changelog.Debian.gz
            DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${package})
endforeach()
add_custom_target(zproof_packaged)
add_dependencies(zproof_packaged zproof_shell zproof_changelog zproof_image_io_module ${zproof_targets})
if(TARGET zproof_python)
    add_dependencies(zproof_packaged zproof_python)
endif()
include(CPack)
