# gyromode_layer(NAME SOURCES … DEPENDS … [LINKS …])
#
# One folder of lib/gyromode is one static library. DEPENDS names the folders it may include; any other
# `#include "gyromode/<folder>/…"` in it stops the configuration, so dependencies run one way.
function(gyromode_layer name)
  cmake_parse_arguments(LAYER "" "" "SOURCES;DEPENDS;LINKS" ${ARGN})
  set(allowed ${name} ${LAYER_DEPENDS})
  file(GLOB files CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.h ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  foreach(file ${files})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(STRINGS ${file} includes REGEX "^#include \"gyromode/[a-z_]+/")
    foreach(line ${includes})
      string(REGEX REPLACE "^#include \"gyromode/([a-z_]+)/.*" "\\1" folder "${line}")
      if(NOT folder IN_LIST allowed)
        message(FATAL_ERROR "${file}: ${line}\n  the folder '${name}' may include only: ${allowed} (see lib/CMakeLists.txt)")
      endif()
    endforeach()
  endforeach()

  set(target gyromode_${name})
  add_library(${target} OBJECT ${LAYER_SOURCES})
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/lib>
                                              $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/lib>)
  target_compile_definitions(${target} PUBLIC ${gyromode_eigen_layout})
  target_link_libraries(${target} PUBLIC Eigen3::Eigen PRIVATE gyromode_warnings ${LAYER_LINKS})
  target_sources(gyromode PRIVATE $<TARGET_OBJECTS:${target}>)
  install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/gyromode/${name} FILES_MATCHING PATTERN "*.h" PATTERN "lapacke_complex.h" EXCLUDE)
endfunction()
