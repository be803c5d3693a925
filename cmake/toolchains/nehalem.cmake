# A processor of 2008, without AVX, AVX2 and FMA, under user-mode QEMU. The compiler is this machine's own, which has to
# be one for x86-64.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER gcc)
set(CMAKE_CXX_COMPILER g++)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-x86_64;-cpu;Nehalem)
