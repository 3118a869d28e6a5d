# The package may be moved: nothing in it names a place of the machine that made it. Dependencies are looked for where it is used.
include(CMakePackageConfigHelpers)
set(gyromode_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/gyromode)
install(TARGETS gyromode EXPORT gyromode-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT gyromode-targets NAMESPACE gyromode:: DESTINATION ${gyromode_cmake_dir})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/gyromode-config.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/gyromode-config.cmake INSTALL_DESTINATION ${gyromode_cmake_dir})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/gyromode-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/gyromode-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/gyromode-config-version.cmake
              ${CMAKE_CURRENT_LIST_DIR}/FindLAPACKE.cmake ${CMAKE_CURRENT_LIST_DIR}/FindOpenBLASLibrary.cmake ${CMAKE_CURRENT_LIST_DIR}/Findlibmd.cmake
              ${CMAKE_CURRENT_LIST_DIR}/FindMatIO.cmake ${CMAKE_CURRENT_LIST_DIR}/Findlibzip.cmake ${CMAKE_CURRENT_LIST_DIR}/FindMuParser.cmake
              ${CMAKE_CURRENT_LIST_DIR}/FindMUMPS.cmake ${CMAKE_CURRENT_LIST_DIR}/FindMETIS.cmake
        DESTINATION ${gyromode_cmake_dir})
file(RELATIVE_PATH gyromode_pc_to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(${CMAKE_CURRENT_LIST_DIR}/gyromode.pc.in ${CMAKE_CURRENT_BINARY_DIR}/gyromode.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/gyromode.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(DIRECTORY models DESTINATION ${CMAKE_INSTALL_DATADIR}/gyromode)
