include(CMakePackageConfigHelpers)
install(TARGETS gyromode EXPORT gyromode-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT gyromode-targets NAMESPACE gyromode:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/gyromode)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/gyromode-config.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/gyromode-config.cmake
                              INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/gyromode)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/gyromode-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/gyromode-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/gyromode-config-version.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/gyromode)
install(DIRECTORY models DESTINATION ${CMAKE_INSTALL_DATADIR}/gyromode)
