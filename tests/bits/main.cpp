// claque_bits [SECTION...]: some sections; without names, all.
#include "tests/bits/bits.h"

int main(int argc, char **argv) { return bits::print_sections(nullptr, argv + 1, argv + argc); }
