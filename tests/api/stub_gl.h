// An OpenGL 1.1 that draws nothing but checks the arguments of calls and reads the arrays as GL would, so that a
// sanitizer sees every access. Each thread has a context of its own.
#pragma once

#include "tests/api/test_world.h"

namespace stub_gl
{

clq_gl_function find(void *, const char *name);  // for clq_renderer_def.get_proc_address

// Every stack of this thread's context must be as deep as at first. Forgets the context.
void expect_balance();

void new_context();  // of this thread: nothing is pushed or bound in it

// Prepared for both templates.
clq_renderer *new_renderer(TestWorld &test_world);

}  // namespace stub_gl
