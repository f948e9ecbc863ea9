# Debian's gcc-arm-none-eabi with libstdc++-arm-none-eabi-newlib: no operating system. RIG_CORTEX_M_CPU is cortex-m4
# unless it is set; the core is linked into a small image for emulated boards (tests/bare_metal).
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(RIG_CORTEX_M_CPU cortex-m4 CACHE STRING "processor of the image")
# The core computes with integers alone, but all that is linked into one program must agree about this.
set(RIG_CORTEX_M_FLOAT soft CACHE STRING "float ABI of the program: soft, softfp or hard")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES RIG_CORTEX_M_CPU RIG_CORTEX_M_FLOAT)
set(RIG_CORTEX_M "-mcpu=${RIG_CORTEX_M_CPU} -mthumb -mfloat-abi=${RIG_CORTEX_M_FLOAT} -ffunction-sections -fdata-sections -fstack-usage")
set(CMAKE_C_FLAGS_INIT "${RIG_CORTEX_M}")
set(CMAKE_CXX_FLAGS_INIT "${RIG_CORTEX_M}")
