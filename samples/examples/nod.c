/* A control mechanism as a shared object, for `claque view` and scenarios (docs/view.md): the character nods. */
#include <math.h>
#include <stdlib.h>

#include "samples/scenes/roles/mechanism.h"

typedef struct nod {
    uint32_t pitch;
} nod;

static void *open_nod(const clq_template *tmpl, claque_find_dof find, const char **why)
{
    static const char *const names[] = {"neck_pitch", "head.pitch", "neck pitch", "head_pitch"};
    for (size_t i = 0; i < sizeof names / sizeof *names; ++i) {
        const uint32_t dof = find(tmpl, names[i]);
        if (dof == CLQ_NONE) continue;
        nod *made = malloc(sizeof *made);
        if (made) made->pitch = dof;
        return made;
    }
    *why = "nods with neck_pitch or head.pitch, and this character has neither";
    return NULL;
}

/* A function of the time: it needs no memory, and any moment can be shown by itself. */
static void run_nod(void *opened, const clq_behaviour_call *call, clq_dof_writer *writer, claque_write_dof write)
{
    const nod *self = opened;
    write(writer, self->pitch, 0.35f * sinf((float)fmod(call->time_s, 2.0) * 3.14159265f * 2.0f), 1.0f);
}

static void close_nod(void *opened) { free(opened); }

CLAQUE_MECHANISM_EXPORT const claque_mechanism *claque_mechanism_v1(void);
const claque_mechanism *claque_mechanism_v1(void)
{
    static const claque_mechanism described = {sizeof(claque_mechanism), "nod", false, open_nod, run_nod, close_nod};
    return &described;
}
