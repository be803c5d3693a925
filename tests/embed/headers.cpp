// The same as headers.c: a C++ host sees the same headers.
#include "headers.c"
