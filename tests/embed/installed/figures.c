/* Asks both libraries for something: a built-in figure from claque-assets, what it is made of from claque. */
#include <claque/assets.h>
#include <claque/claque.h>

#include <stdio.h>

int main(void)
{
    clq_context *context = NULL;
    clq_template *citizen = NULL;
    clq_template_info info = clq_template_info_init();
    if (clq_context_create(NULL, &context) || clq_template_builtin(context, "citizen", &citizen) ||
        clq_template_get_info(citizen, &info)) {
        fprintf(stderr, "%s\n", clq_last_error());
        return 1;
    }
    printf("citizen: %u zones, %u clips\n", (unsigned)info.zone_count, (unsigned)info.clip_count);
    clq_template_destroy(citizen);
    return clq_context_destroy(context) != CLQ_OK;
}
