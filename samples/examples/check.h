/* What all examples share: a call that fails, or a result that is not as the headers say, ends the program. */
#ifndef CLAQUE_EXAMPLES_CHECK_H
#define CLAQUE_EXAMPLES_CHECK_H

#include <claque/claque.h>

#include <stdio.h>
#include <stdlib.h>

static void check(clq_status status)
{
    if (status == CLQ_OK) return;
    fprintf(stderr, "%s: %s\n", clq_status_name(status), clq_last_error());
    exit(1);
}

static void expect(bool holds, const char *sentence)
{
    if (holds) return;
    fprintf(stderr, "This should hold: %s\n", sentence);
    exit(1);
}

#endif
