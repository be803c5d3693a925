// What a host does with a template, whatever it came from.
#pragma once

#include "tests/fuzz/fuzzer.h"

namespace fuzzing
{

// Asks for everything that the template says of itself, saves and loads it, and shows a few individuals by every
// strategy, through a GL that reads every array.
void show(clq_context *context, clq_template *tmpl);

Bytes bytes_of(const clq_template *tmpl);

}  // namespace fuzzing
