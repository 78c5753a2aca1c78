# SPDX-License-Identifier: Apache-2.0
# kelpie_subdirectory(folder)         adds a folder that has a CMakeLists.txt
# kelpie_library(name sources... )    a static library with the house's warnings; link with
#                                     target_link_libraries as usual
# kelpie_executable(name sources...)  the same for a program
# kelpie_tests(name libraries...)     one GoogleTest program of all *.cpp in the current folder, and
#                                     of the tests in folders below it that make no program of theirs

# What clang warns of beyond them is not our measure: it builds only the fuzzing programs.
set(KELPIE_WARNINGS -Wall -Wextra -Werror -Wconversion -Wshadow -Wdouble-promotion)
if(KELPIE_FUZZ)
  set(KELPIE_WARNINGS -w)
endif()

# What the tree lists once, as C++ and as Python names: made when the tree is configured, and again
# when one of its files changes, so that no target has to wait for it.
set(KELPIE_GENERATED ${CMAKE_BINARY_DIR}/generated)
file(GLOB KELPIE_LISTED CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/actuator/data/motions/*.toml)
set(KELPIE_REGISTRY ${CMAKE_SOURCE_DIR}/actuator/data/registry.py
                    ${CMAKE_SOURCE_DIR}/robot/core/enumerations.toml)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${KELPIE_LISTED} ${KELPIE_REGISTRY})
execute_process(
  COMMAND /usr/bin/python3 ${CMAKE_SOURCE_DIR}/actuator/data/registry.py
          ${CMAKE_SOURCE_DIR}/actuator/data/motions ${CMAKE_SOURCE_DIR}/robot/core/enumerations.toml
          ${KELPIE_GENERATED}
  COMMAND_ERROR_IS_FATAL ANY)
set(KELPIE_CONSTANTS ${CMAKE_SOURCE_DIR}/behaviour/constants.py
                     ${CMAKE_SOURCE_DIR}/behaviour/constants.toml)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${KELPIE_CONSTANTS})
execute_process(COMMAND /usr/bin/python3 ${KELPIE_CONSTANTS} ${KELPIE_GENERATED}/behaviour/Constants.h
                COMMAND_ERROR_IS_FATAL ANY)

function(kelpie_flags target)
  target_compile_options(${target} PRIVATE ${KELPIE_WARNINGS} -ffp-contract=off)
  target_compile_definitions(${target} PRIVATE EIGEN_DONT_VECTORIZE)
  target_include_directories(${target} PUBLIC ${CMAKE_SOURCE_DIR} ${KELPIE_GENERATED})
endfunction()

function(kelpie_library target)
  add_library(${target} STATIC ${ARGN})
  kelpie_flags(${target})
endfunction()

function(kelpie_executable target)
  add_executable(${target} ${ARGN})
  kelpie_flags(${target})
endfunction()

macro(kelpie_subdirectory folder)
  if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/CMakeLists.txt)
    add_subdirectory(${folder})
  endif()
endmacro()

function(kelpie_tests target)
  file(GLOB sources CONFIGURE_DEPENDS *.cpp */*Test.cpp)
  file(GLOB programs RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} */CMakeLists.txt)
  foreach(program ${programs})
    get_filename_component(folder ${program} DIRECTORY)
    list(FILTER sources EXCLUDE REGEX "/${folder}/[^/]*$")
  endforeach()
  add_executable(${target} ${sources} ${CMAKE_SOURCE_DIR}/tests/TestMain.cpp)
  kelpie_flags(${target})
  target_link_libraries(${target} PRIVATE ${ARGN} GTest::gtest)
  target_compile_definitions(${target} PRIVATE KELPIE_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
  gtest_discover_tests(${target} DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT 300)
endfunction()

# kelpie_link_opencv(target modules...): Debian's libopencv-*-dev packages ship neither a CMake nor a
# pkg-config file.
function(kelpie_link_opencv target)
  find_path(KELPIE_OPENCV_INCLUDE opencv2/core.hpp PATH_SUFFIXES opencv4 REQUIRED)
  target_include_directories(${target} SYSTEM PRIVATE ${KELPIE_OPENCV_INCLUDE})
  list(TRANSFORM ARGN PREPEND opencv_)
  target_link_libraries(${target} PRIVATE ${ARGN})
endfunction()
