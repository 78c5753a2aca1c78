# SPDX-License-Identifier: Apache-2.0
# Debian's cross compiler set to make objects for OPEN-R on the ERS-7: code that the robot's loader
# can put anywhere. Nothing is linked to a program of Linux, so no sysroot is needed: of the C
# library only headers are read, of Eigen those of this machine (they are the same for all).
#
# -mabicalls -mshared -fPIC  the loader corrects nothing but the GOT and words of data (openr.md 3.3)
# -mno-relax-pic-calls       no R_MIPS_JALR, which the SDK's gensnap does not know
# -mno-plt                   no relocation of a PLT
# -march=mips2               what the SDK's own code has; mips4's movz may not be enabled
# -mfp32 -mnan=legacy        what the SDK's libraries are made for
# -fno-jump-tables           a table of offsets is R_MIPS_GPREL32, which is wrong when .reginfo is lost
# -fno-threadsafe-statics    an object has one thread
# EIGEN_MAX_STATIC_ALIGN_BYTES=0   malloc and the stack are aligned to 8 bytes
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR mipsel)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

find_program(KELPIE_CROSS_CXX mipsel-linux-gnu-g++)
if(NOT KELPIE_CROSS_CXX)
  message(FATAL_ERROR "no mipsel-linux-gnu-g++: install the Debian package g++-mipsel-linux-gnu")
endif()
set(CMAKE_C_COMPILER mipsel-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER mipsel-linux-gnu-g++)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)

set(flags "-EL -march=mips2 -mtune=r7000 -mabi=32 -mfp32 -mhard-float -mnan=legacy \
-mabicalls -mshared -fPIC -G0 -mno-plt -mno-relax-pic-calls -fno-jump-tables \
-fno-exceptions -fno-asynchronous-unwind-tables -fno-unwind-tables -fno-stack-protector \
-ffunction-sections -fdata-sections -ffp-contract=off \
-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=0 -DEIGEN_NO_DEBUG -DEIGEN_NO_IO \
-DEIGEN_MAX_STATIC_ALIGN_BYTES=0")
set(CMAKE_C_FLAGS_INIT "${flags}")
set(CMAKE_CXX_FLAGS_INIT
    "${flags} -fno-rtti -fno-threadsafe-statics -fno-use-cxa-atexit")
