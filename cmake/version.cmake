# SPDX-License-Identifier: Apache-2.0
# kelpie_version(source fallback out)
# The version of a source tree by its last tag vX.Y, in an order that Debian's tools know:
#   0.2             that tag's commit
#   0.2+3.gabc1234  three commits later
#   0.1~20260102.gabc1234  a tree without such a tag, of that day's commit: before `fallback`, 0.1
#   0.1~unknown     no git, or a tree that is no repository
# A tree whose tracked files differ from the commit has ".dirty" behind that.
function(kelpie_version source fallback out)
  set(version ${fallback}~unknown)
  find_program(git git)
  if(git AND EXISTS ${source}/.git)
    execute_process(
      COMMAND ${git} -C ${source} describe --tags --match=v[0-9]* --dirty --abbrev=7
      OUTPUT_VARIABLE tagged RESULT_VARIABLE untagged ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
    execute_process(
      COMMAND ${git} -C ${source} log -1 --format=%cd --date=format:%Y%m%d
      OUTPUT_VARIABLE day RESULT_VARIABLE failed ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
    execute_process(
      COMMAND ${git} -C ${source} describe --always --dirty --abbrev=7 --exclude=*
      OUTPUT_VARIABLE commit ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(NOT untagged)
      string(REGEX REPLACE "^v" "" version ${tagged})
      string(REGEX REPLACE "^([^-]*)-([0-9]+)-g" "\\1+\\2.g" version ${version})
      string(REPLACE "-" "." version ${version})
    elseif(NOT failed)
      string(REPLACE "-" "." version ${fallback}~${day}.g${commit})
    endif()
  endif()
  set(${out} ${version} PARENT_SCOPE)
endfunction()
