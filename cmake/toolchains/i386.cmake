# 32-bit x86 with SSE2 maths (cmake/claque.cmake), run by its own loader: Debian's g++-i686-linux-gnu brings both.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR i686)
set(CMAKE_C_COMPILER i686-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER i686-linux-gnu-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR /usr/i686-linux-gnu/lib/ld-linux.so.2;--library-path;/usr/i686-linux-gnu/lib)
set(glm_DIR ${CMAKE_CURRENT_LIST_DIR}/glm)
