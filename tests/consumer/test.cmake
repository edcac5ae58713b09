# Installs the build and builds a program of a few lines against what was installed.
#   cmake -D build=BUILD -D scratch=FOLDER -D flags=FLAGS -P test.cmake
function(run)
  execute_process(COMMAND ${ARGV} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGV} returned ${code}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

set(here ${CMAKE_CURRENT_LIST_DIR})
file(REMOVE_RECURSE ${scratch})
run(${CMAKE_COMMAND} --install ${build} --prefix ${scratch}/installed)

file(GLOB_RECURSE target_files ${scratch}/installed/*/vortreeTargets*.cmake)
foreach(target_file ${target_files})
  file(READ ${target_file} exported)
  if(exported MATCHES "fftw|hdf5|Eigen|fmt::|toml|CLI11|${build}")
    message(FATAL_ERROR "${target_file} leaks ${CMAKE_MATCH_0}")
  endif()
endforeach()

run(${CMAKE_COMMAND} -S ${here} -B ${scratch}/build -D CMAKE_PREFIX_PATH=${scratch}/installed
    -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_FLAGS=${flags})
run(${CMAKE_COMMAND} --build ${scratch}/build)
run(${scratch}/build/consumer)
set(expected "0.000000 -0.500000\n0.000000 0.000000\n0.000000 0.500000\n")
if(NOT output STREQUAL expected)
  message(FATAL_ERROR "two vortices of circulation 2 pi at x = -1, 1:\n${output}expected\n${expected}")
endif()
run(${scratch}/installed/bin/vortree --version)
run(${scratch}/installed/bin/vortree cases)

file(READ ${here}/main.cpp program)
file(READ ${here}/../../README.md readme)
string(FIND "${readme}" "${program}" place)
if(place EQUAL -1)
  message(FATAL_ERROR "the example of README.md is not tests/consumer/main.cpp")
endif()
