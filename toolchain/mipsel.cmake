# SPDX-License-Identifier: Apache-2.0
# Debian's mipsel as a stand-in for the ERS-7's R7000: static programs, MIPS II instructions only.
# MIPS II is a subset of both the R7000's MIPS IV and of what Debian's C library is built for;
# -march=r7000 itself compiles but does not link with that library, and costs within 4 % the same.
# Python, zlib, zstd and Eigen come from the private sysroot of toolchain/make-sysroot
# (KELPIE_SYSROOT, or the default directory), libc and libstdc++ from the cross compiler.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR mipsel)

if(NOT DEFINED KELPIE_SYSROOT)
  if(DEFINED ENV{KELPIE_SYSROOT})
    set(KELPIE_SYSROOT "$ENV{KELPIE_SYSROOT}")
  elseif(DEFINED ENV{XDG_CACHE_HOME})
    set(KELPIE_SYSROOT "$ENV{XDG_CACHE_HOME}/kelpie/sysroot-mipsel")
  else()
    set(KELPIE_SYSROOT "$ENV{HOME}/.cache/kelpie/sysroot-mipsel")
  endif()
endif()
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES KELPIE_SYSROOT)

find_program(KELPIE_CROSS_CXX mipsel-linux-gnu-g++)
if(NOT KELPIE_CROSS_CXX)
  message(FATAL_ERROR "no mipsel-linux-gnu-g++: install the Debian package g++-mipsel-linux-gnu")
endif()
if(NOT EXISTS "${KELPIE_SYSROOT}/.kelpie-sysroot")
  message(FATAL_ERROR "no mipsel sysroot in ${KELPIE_SYSROOT}: run toolchain/make-sysroot")
endif()

set(CMAKE_C_COMPILER mipsel-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER mipsel-linux-gnu-g++)
set(CMAKE_LIBRARY_ARCHITECTURE mipsel-linux-gnu)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-mipsel)

set(CMAKE_FIND_ROOT_PATH "${KELPIE_SYSROOT}" /usr/mipsel-linux-gnu)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

set(flags "-march=mips2 -mtune=r7000 -fno-pie -ffunction-sections -fdata-sections \
-ffp-contract=off -isystem ${KELPIE_SYSROOT}/usr/include")
set(CMAKE_C_FLAGS_INIT "${flags}")
set(CMAKE_CXX_FLAGS_INIT "${flags}")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-no-pie -static -Wl,--gc-sections \
-L${KELPIE_SYSROOT}/usr/lib/mipsel-linux-gnu")
# What libpython3.11.a needs; at the end of every link line, where a static link wants it.
set(CMAKE_C_STANDARD_LIBRARIES_INIT "-lz -ldl -lutil -lm")
set(CMAKE_CXX_STANDARD_LIBRARIES_INIT "-lz -ldl -lutil -lm")

# find_package(Python3 3.11 EXACT COMPONENTS Development.Embed) takes these as given.
set(Python3_INCLUDE_DIR "${KELPIE_SYSROOT}/usr/include/python3.11" CACHE PATH "target's Python.h")
set(Python3_LIBRARY
    "${KELPIE_SYSROOT}/usr/lib/python3.11/config-3.11-mipsel-linux-gnu/libpython3.11.a"
    CACHE FILEPATH "target's static Python")
