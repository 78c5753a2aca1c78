# SPDX-License-Identifier: Apache-2.0
# cmake -D OUT=FILE -D SOURCE=FOLDER -D VERSION=0.1 -P commit.cmake
# Writes a C++ file that holds the version (version.cmake; VERSION where there is no tag yet) and the
# commit of the source tree, "-dirty" when a tracked file differs from it, "unknown" where there is
# no git or the tree is no repository (a tarball, also one unpacked inside another repository). The
# file is touched only when that changes.
include(${CMAKE_CURRENT_LIST_DIR}/version.cmake)
kelpie_version(${SOURCE} ${VERSION} version)
set(commit unknown)
find_program(git git)
if(git AND EXISTS ${SOURCE}/.git)
  execute_process(
    COMMAND ${git} -C ${SOURCE} describe --always --dirty --abbrev=7 --exclude=*
    OUTPUT_VARIABLE described
    RESULT_VARIABLE failed
    ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT failed)
    set(commit ${described})
  endif()
endif()

file(
  WRITE ${OUT}.new
  "// Written by cmake/commit.cmake at every build.
#include \"tools/cli/Commit.h\"

namespace kelpie::cli {

const char* projectVersion() { return \"${version}\"; }
const char* sourceCommit() { return \"${commit}\"; }

}  // namespace kelpie::cli
")
execute_process(COMMAND ${CMAKE_COMMAND} -E copy_if_different ${OUT}.new ${OUT})
file(REMOVE ${OUT}.new)
