# Debian's gcc-arm-none-eabi with libstdc++-arm-none-eabi-newlib: Cortex-M4, no operating system. Builds the core only.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(RIG_CORTEX_M "-mcpu=cortex-m4 -mthumb -mfloat-abi=soft -ffunction-sections -fdata-sections -fstack-usage")
set(CMAKE_C_FLAGS_INIT "${RIG_CORTEX_M}")
set(CMAKE_CXX_FLAGS_INIT "${RIG_CORTEX_M}")
