/* For a library or a binding on top of claque: it shares the host's log and tasks, and reports failures as claque does.
 * Here a small library adds up numbers in parallel. */
#include <claque/claque.h>

#include "samples/examples/check.h"

enum { COUNT = 100 };

static void write_line(void *user, clq_log_level level, const char *text)
{
    (void)text;
    *(uint32_t *)user += level == CLQ_LOG_WARNING;
}

/* The host's tasks: here one thread, which takes the last job first. */
static void run(void *user, uint32_t count, void (*job)(void *job_data, uint32_t index), void *job_data)
{
    *(uint32_t *)user += count;
    while (count > 0) job(job_data, --count);
}

static void square(void *job_data, uint32_t index) { ((uint32_t *)job_data)[index] = index * index; }

/* The library's one function, with the manners of claque. */
static clq_status sum_of_squares(clq_context *context, uint32_t count, uint32_t *out)
{
    uint32_t squares[COUNT], sum = 0;
    if (count > COUNT) return clq_report(CLQ_LIMIT, "sum_of_squares: count is more than 100");
    clq_context_run(context, count, square, squares);
    for (uint32_t i = 0; i < count; ++i) sum += squares[i];
    if (count == 0) clq_context_log(context, CLQ_LOG_WARNING, "sum_of_squares: there is nothing to add up.");
    *out = sum;
    return CLQ_OK;
}

int main(void)
{
    uint32_t warnings = 0, jobs = 0, sum = 0;
    clq_context *context;
    clq_context_def def = clq_context_def_init();
    def.log.write = write_line, def.log.user = &warnings;
    def.tasks.run = run, def.tasks.user = &jobs;
    check(clq_context_create(&def, &context));

    check(sum_of_squares(context, COUNT, &sum));
    expect(sum == 328350, "the squares of 0 to 99 add up to 328350");
    expect(jobs == COUNT, "the host's tasks did all jobs");
    check(sum_of_squares(context, 0, &sum));
    expect(warnings == 1, "the host's log got the warning");
    expect(sum_of_squares(context, COUNT + 1, &sum) == CLQ_LIMIT, "the status is returned");
    expect(strcmp(clq_last_error(), "sum_of_squares: count is more than 100") == 0, "the sentence is the last error");
    check(clq_context_destroy(context));

    check(clq_context_create(NULL, &context));
    check(sum_of_squares(context, COUNT, &sum));
    expect(sum == 328350 && jobs == COUNT, "without tasks the calling thread does the jobs");
    check(clq_context_destroy(context));
    return printf("%u jobs, %u warning\n", jobs, warnings) < 0;
}
