# cmake --install: the program, the rooms as libraries, their headers, and what find_package(zproof) needs.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(rooms math frame scenes texture rasterizer oracle compare)
set(zproof_targets zproof_strict)
foreach(room IN LISTS rooms)
    list(APPEND zproof_targets zproof_${room})
    install(DIRECTORY ${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/zproof FILES_MATCHING PATTERN "*.h")
endforeach()
set_target_properties(zproof_strict PROPERTIES EXPORT_NAME strict)
install(TARGETS ${zproof_targets} EXPORT zproof)
install(EXPORT zproof NAMESPACE zproof:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/zproof FILE zproof-targets.cmake)
install(FILES cmake/zproof-config.cmake DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/zproof)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/zproof-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/zproof-config-version.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/zproof)
