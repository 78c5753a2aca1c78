# SPDX-License-Identifier: Apache-2.0
# The Debian packages that tools/package makes with CPack: kelpie of the component runtime and
# kelpie-dev of dev (cmake/install.cmake). What they depend on comes from dpkg-shlibdeps, which asks
# the programs; two recommendations are programs that `kelpie stick` starts.
include(${CMAKE_CURRENT_LIST_DIR}/version.cmake)
kelpie_version(${CMAKE_SOURCE_DIR} ${PROJECT_VERSION} KELPIE_PACKAGE_VERSION)

# The manual, the words that bash completes, the list of what is linked and its licences, made from
# the programs themselves: of each package in a folder of its own.
set(KELPIE_RELEASE ${CMAKE_BINARY_DIR}/release)
set(KELPIE_DEV_RELEASE ${CMAKE_BINARY_DIR}/release-dev)
set(KELPIE_PROGRAMS kelpie kelpie-agent kelpie-world kelpie-percepts)
set(KELPIE_DEV_PROGRAMS kelpie-experiments)
list(TRANSFORM KELPIE_PROGRAMS REPLACE "(.+)" "$<TARGET_FILE:\\1>" OUTPUT_VARIABLE files)
list(TRANSFORM KELPIE_DEV_PROGRAMS REPLACE "(.+)" "$<TARGET_FILE:\\1>" OUTPUT_VARIABLE dev_files)
add_custom_target(
  kelpie-release
  COMMAND /usr/bin/python3 ${CMAKE_SOURCE_DIR}/tools/release/manual.py $<TARGET_FILE:kelpie>
          ${KELPIE_RELEASE} --version ${KELPIE_PACKAGE_VERSION}
  COMMAND /usr/bin/python3 ${CMAKE_SOURCE_DIR}/tools/release/sbom.py write ${KELPIE_RELEASE}
          --version ${KELPIE_PACKAGE_VERSION} --build ${CMAKE_BINARY_DIR} ${files}
  DEPENDS ${KELPIE_PROGRAMS}
  VERBATIM)
add_custom_target(
  kelpie-dev-release
  COMMAND /usr/bin/python3 ${CMAKE_SOURCE_DIR}/tools/release/manual.py
          $<TARGET_FILE:kelpie-experiments> ${KELPIE_DEV_RELEASE}
          --version ${KELPIE_PACKAGE_VERSION} --of evaluate
  COMMAND /usr/bin/python3 ${CMAKE_SOURCE_DIR}/tools/release/sbom.py write ${KELPIE_DEV_RELEASE}
          --version ${KELPIE_PACKAGE_VERSION} --build ${CMAKE_BINARY_DIR} --name kelpie-dev
          ${dev_files}
  DEPENDS ${KELPIE_DEV_PROGRAMS}
  VERBATIM)

foreach(pair kelpie.1.gz:man/man1 kelpie:bash-completion/completions
             kelpie.spdx.json:doc/kelpie copyright:doc/kelpie changelog.gz:doc/kelpie)
  string(REPLACE ":" ";" pair ${pair})
  list(GET pair 0 file)
  list(GET pair 1 place)
  install(FILES ${KELPIE_RELEASE}/${file} DESTINATION ${CMAKE_INSTALL_DATADIR}/${place}
          COMPONENT runtime OPTIONAL)
endforeach()
install(DIRECTORY ${KELPIE_RELEASE}/licences DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/kelpie
        COMPONENT runtime OPTIONAL)
install(FILES ${KELPIE_DEV_RELEASE}/kelpie-evaluate.1.gz
        DESTINATION ${CMAKE_INSTALL_DATADIR}/man/man1 COMPONENT dev OPTIONAL)
install(FILES ${KELPIE_DEV_RELEASE}/kelpie-dev.spdx.json ${KELPIE_DEV_RELEASE}/copyright
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/kelpie-dev COMPONENT dev OPTIONAL)
install(DIRECTORY ${KELPIE_DEV_RELEASE}/licences
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/kelpie-dev COMPONENT dev OPTIONAL)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME kelpie)
set(CPACK_PACKAGE_VERSION ${KELPIE_PACKAGE_VERSION})
set(CPACK_PACKAGE_CONTACT "The Kelpie project <kelpie@example.org>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL runtime dev)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME kelpie)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "python3, mtools")
set(CPACK_DEBIAN_DEV_PACKAGE_NAME kelpie-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "kelpie (= ${KELPIE_PACKAGE_VERSION}), python3")
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS "python3-distributed, python3-optuna, python3-cmaes")
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION
    "Robot soccer of the Sony AIBO ERS-7, from pixels to legs
Simulated matches of one robot or of two teams, films and logs of them, and a
studio in the browser; behaviours are written in Python.")
set(CPACK_COMPONENT_DEV_DESCRIPTION
    "Experiments of Kelpie and the scripts of its robot's toolchain
What `kelpie evaluate` and `kelpie farm` measure with, and checks of a robot's
object and memory stick.")
include(CPack)
