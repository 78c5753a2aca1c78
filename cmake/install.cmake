# SPDX-License-Identifier: Apache-2.0
# What `cmake --install BUILD --prefix DIR` puts where, by component: "runtime" is all that a match
# needs, "dev" the experiments, the farm and the scripts of toolchain/.
#
# Programs find their data in share/kelpie beside bin (tools/cli/DataFolder.h). In a build folder
# that is a link to the source tree; installed, it is what programs read of that tree.
if(NOT EXISTS ${CMAKE_BINARY_DIR}/share/kelpie/CMakeLists.txt)
  file(RELATIVE_PATH tree ${CMAKE_BINARY_DIR}/share ${CMAKE_SOURCE_DIR})
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/share)
  file(CREATE_LINK ${tree} ${CMAKE_BINARY_DIR}/share/kelpie SYMBOLIC)
endif()

include(GNUInstallDirs)
set(KELPIE_DATA ${CMAKE_INSTALL_DATADIR}/kelpie)
set(CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

# kelpie_install_data(component folder pattern...): the files of these names in it and below it.
function(kelpie_install_data component folder)
  list(TRANSFORM ARGN PREPEND ${CMAKE_SOURCE_DIR}/${folder}/)
  file(GLOB_RECURSE files RELATIVE ${CMAKE_SOURCE_DIR} CONFIGURE_DEPENDS ${ARGN})
  foreach(file ${files})
    get_filename_component(parent ${file} DIRECTORY)
    install(FILES ${CMAKE_SOURCE_DIR}/${file} DESTINATION ${KELPIE_DATA}/${parent}
            COMPONENT ${component})
  endforeach()
endfunction()

function(kelpie_install_rules)
  install(TARGETS kelpie kelpie-agent kelpie-world kelpie-percepts RUNTIME COMPONENT runtime)
  kelpie_install_data(runtime pycode *.py README.md)
  kelpie_install_data(runtime teams *.py *.toml README.md)
  kelpie_install_data(runtime examples/team *.py README.md)
  kelpie_install_data(runtime tools/league/value near.json far.json)
  kelpie_install_data(runtime tools/calibrate/carpet *.py)
  kelpie_install_data(runtime tools/calibrate/looking *.py)
  # All guides: each names others, and whoever has no source tree reads them here.
  install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/kelpie COMPONENT runtime
          FILES_MATCHING PATTERN *.md PATTERN *.png PATTERN *.json)
  install(PROGRAMS ${CMAKE_SOURCE_DIR}/toolchain/make-pyzip DESTINATION ${KELPIE_DATA}/toolchain
          COMPONENT runtime)
  # The studio's page, where tools/build studio has made it.
  install(DIRECTORY ${CMAKE_SOURCE_DIR}/build/studio/page DESTINATION ${KELPIE_DATA}/build/studio
          COMPONENT runtime OPTIONAL)

  install(TARGETS kelpie-experiments RUNTIME COMPONENT dev)
  kelpie_install_data(dev examples/agent *.py *.cpp README.md)
  kelpie_install_data(dev examples/exercises *.py)
  kelpie_install_data(dev tools/experiments *.py *.json *.toml)
  kelpie_install_data(dev tools/farm *.py README.md)
  kelpie_install_data(dev behaviour constants.py constants.toml)
  install(DIRECTORY ${CMAKE_SOURCE_DIR}/toolchain DESTINATION ${KELPIE_DATA} COMPONENT dev
          USE_SOURCE_PERMISSIONS PATTERN __pycache__ EXCLUDE PATTERN make-pyzip EXCLUDE)
endfunction()
