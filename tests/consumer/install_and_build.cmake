# Installs the build into a folder of its own, then configures, builds and runs the consumer against it.
set(prefix ${BUILD}/consumer-prefix)
set(work ${BUILD}/consumer-build)
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()
file(REMOVE_RECURSE ${prefix} ${work})
# The C++ block of README.md becomes a program: its includes, then main() with matrices for it.
file(READ ${SOURCE}/README.md readme)
string(REGEX MATCH "```cpp\n(#include <[^>]*>\n)\n([^`]*)```" block "${readme}")
if(NOT block)
  message(FATAL_ERROR "README.md has no C++ block that starts with an include")
endif()
file(WRITE ${work}/readme.cpp "${CMAKE_MATCH_1}#include <cstdio>\nint main() {\n  const gyromode::Matrix mass = gyromode::Matrix::Identity(2, 2);\n"
     "  gyromode::Matrix gyroscopic(2, 2);\n  gyroscopic << 0, -1, 1, 0;\n  const gyromode::Matrix stiffness = mass;\n${CMAKE_MATCH_2}}\n")
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
# As the compiler comes, and for all instructions of this machine: matrices are made on one side of the library and freed on the other.
foreach(instructions "" -march=native)
  run(${CMAKE_COMMAND} -S ${SOURCE}/tests/consumer -B ${work} -G Ninja -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_BUILD_TYPE=Release -DREADME=${work}/readme.cpp -DCMAKE_CXX_FLAGS=${instructions})
  run(${CMAKE_COMMAND} --build ${work})
  run(${work}/consumer)
  run(${work}/readme)
endforeach()
run(${prefix}/bin/gyromode modes ${prefix}/share/gyromode/models/wiresaw.toml)
