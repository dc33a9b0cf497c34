# cmake --install: the program (component zproof), and the rooms as libraries with their headers and what
# find_package(zproof) and pkg-config need (component libzproof-dev). docs/packages.md tells how they are used.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(rooms math frame image_io scenes texture rasterizer oracle compare measure reports filters lessons api)
set(zproof_targets zproof_strict)
set(zproof_cmake_folder ${CMAKE_INSTALL_LIBDIR}/cmake/zproof)
install(FILES ${PROJECT_SOURCE_DIR}/zproof/zproof.h ${PROJECT_SOURCE_DIR}/zproof/filters.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/zproof/zproof COMPONENT libzproof-dev)
foreach(room IN LISTS rooms)
    list(APPEND zproof_targets zproof_${room})
    if(room STREQUAL "api")
        continue()
    endif()
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/zproof
            COMPONENT libzproof-dev FILES_MATCHING PATTERN "*.h" PATTERN commands EXCLUDE PATTERN selftest EXCLUDE)
endforeach()
set_target_properties(zproof_strict PROPERTIES EXPORT_NAME strict)
install(TARGETS ${zproof_targets} EXPORT zproof ARCHIVE COMPONENT libzproof-dev)
install(TARGETS zproof EXPORT zproof RUNTIME COMPONENT zproof)
install(TARGETS zproof-filters zproof-study RUNTIME COMPONENT zproof)
# The image module, and the run path by which the program finds it: beside itself, or here.
set(module_folder ${CMAKE_INSTALL_LIBDIR}/zproof)
file(RELATIVE_PATH module_from_program /${CMAKE_INSTALL_BINDIR} /${module_folder})
set_target_properties(zproof zproof-filters zproof-study PROPERTIES INSTALL_RPATH "$ORIGIN;$ORIGIN/${module_from_program}")
install(TARGETS zproof_image_io_module LIBRARY DESTINATION ${module_folder} COMPONENT zproof)
install(EXPORT zproof NAMESPACE zproof:: DESTINATION ${zproof_cmake_folder} FILE zproof-targets.cmake
        COMPONENT libzproof-dev)

configure_file(${CMAKE_CURRENT_LIST_DIR}/zproof-config.cmake.in ${PROJECT_BINARY_DIR}/zproof-config.cmake @ONLY)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/zproof-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/zproof-config.cmake ${PROJECT_BINARY_DIR}/zproof-config-version.cmake
              ${CMAKE_CURRENT_LIST_DIR}/zproof_scene_test.cmake
        DESTINATION ${zproof_cmake_folder} COMPONENT libzproof-dev)

# Static libraries refer to one another in both directions: the linker must see them as one group.
list(TRANSFORM rooms PREPEND -lzproof_ OUTPUT_VARIABLE room_flags)
list(JOIN room_flags " " room_flags)
set(opengl_modules "")
get_target_property(oracle_libraries zproof_oracle LINK_LIBRARIES)
if(OpenGL::EGL IN_LIST oracle_libraries)
    set(opengl_modules "opengl egl")
endif()
set(draco_module "")
if(TARGET draco::draco)
    set(draco_module draco)  # behind tinygltf, as scenes/CMakeLists.txt says
endif()
set(meshopt_flag "")
if(TARGET meshoptimizer::meshoptimizer)
    set(meshopt_flag -lmeshoptimizer)
endif()
# Found where the file lies, so that an installed tree may be moved.
file(RELATIVE_PATH up_to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" pc_prefix "\${pcfiledir}/${up_to_prefix}")
configure_file(${CMAKE_CURRENT_LIST_DIR}/zproof.pc.in ${PROJECT_BINARY_DIR}/zproof.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/zproof.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT libzproof-dev)

# What a shell and man(1) want to know, as the program itself writes it.
add_custom_command(OUTPUT shell/zproof.1.gz shell/zproof shell/_zproof shell/zproof.fish DEPENDS zproof zproof-filters zproof-study
    COMMAND ${CMAKE_COMMAND} -E make_directory shell
    COMMAND zproof man > shell/zproof.1
    COMMAND gzip -9 -n -f shell/zproof.1
    COMMAND zproof completion bash > shell/zproof
    COMMAND zproof completion zsh > shell/_zproof
    COMMAND zproof completion fish > shell/zproof.fish)
add_custom_target(zproof_shell ALL DEPENDS shell/zproof.1.gz)
set(shell ${CMAKE_CURRENT_BINARY_DIR}/shell)
install(FILES ${shell}/zproof.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT zproof)
install(FILES ${shell}/zproof DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT zproof)
install(FILES ${shell}/zproof.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT zproof)
foreach(folder site-functions vendor-completions)  # below /usr/local, and below /usr, as Debian's zsh looks
    install(FILES ${shell}/_zproof DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/${folder} COMPONENT zproof)
endforeach()

install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CONTRIBUTING.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT zproof)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT zproof
        FILES_MATCHING PATTERN "*.md" PATTERN "*.png" PATTERN "*.svg")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT libzproof-dev
        PATTERN "__pycache__" EXCLUDE)
