/* Saving and restoring: a crowd with a group, a clone and colours is saved, changed, and restored from the bytes.
 * Another crowd restored from the same bytes shows the same. */
#include <claque/assets.h>

#include <math.h>

#include "samples/examples/check.h"

typedef struct buffer {
    unsigned char bytes[65536];
    size_t size;
} buffer;

static int append(void *user, const void *bytes, size_t size_bytes)
{
    buffer *out = user;
    if (size_bytes > sizeof out->bytes - out->size) return 1;
    memcpy(out->bytes + out->size, bytes, size_bytes);
    out->size += size_bytes;
    return 0;
}

int main(void)
{
    static buffer saved, again;
    clq_context *context;
    clq_template *citizen;
    clq_crowd *crowd, *other;
    check(clq_context_create(NULL, &context));
    check(clq_template_builtin(context, "citizen", &citizen));
    check(clq_crowd_create(context, NULL, &crowd));

    /* A carriage of two: the second passenger is a clone of the first one, with colours of its own. */
    clq_group carriage;
    clq_transform place = clq_transform_init();
    place.position[0] = 100;
    check(clq_group_create(crowd, &place, &carriage));
    check(clq_group_set_speed(crowd, carriage, 1.5f)); /* at walking pace: its passengers are posed so often */
    clq_actor first, second;
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = citizen, def.seed = 1;
    def.play.clip = clq_template_find_clip(citizen, "sit_talk");
    check(clq_actor_create(crowd, &def, &first));
    clq_transform seat = clq_transform_init();
    check(clq_actor_join(crowd, first, carriage, &seat));
    check(clq_actor_randomise_colours(crowd, first, NULL, 0));
    seat.position[0] = 0.6;
    check(clq_actor_clone(crowd, first, &seat, 2, &second));

    clq_actor_info info = clq_actor_info_init();
    check(clq_actor_get_info(crowd, second, &info));
    expect(info.group.index1 == carriage.index1, "a clone is in the group of the actor that it is like");
    expect(info.play.clip == def.play.clip && info.seed == 2, "it plays the same clip and has its own seed");
    float colours[2][3 * 8];
    check(clq_actor_get_colours(crowd, first, colours[0], 8));
    check(clq_actor_get_colours(crowd, second, colours[1], 8));
    expect(memcmp(colours[0], colours[1], sizeof colours[0]) == 0, "it keeps the other's colours until they are set");
    check(clq_actor_randomise_colours(crowd, second, NULL, 0));
    check(clq_actor_get_colours(crowd, second, colours[1], 8));
    expect(memcmp(colours[0], colours[1], sizeof colours[0]) != 0, "sampled anew, by its own seed, they differ");
    clq_group_info group = clq_group_info_init();
    check(clq_group_get_info(crowd, carriage, &group));
    expect(group.member_count == 2 && group.enabled && group.transform.position[0] == 100, "two passengers at x = 100");

    const uint64_t hash = clq_crowd_get_hash(crowd);
    check(clq_crowd_save(crowd, append, &saved));

    /* The group ends: its members keep their place in the world. */
    check(clq_group_destroy(crowd, carriage));
    expect(clq_group_get_info(crowd, carriage, &group) == CLQ_STALE_ID, "the id of a destroyed group is stale");
    check(clq_actor_get_info(crowd, second, &info));
    expect(fabs(info.transform.position[0] - 100.6) < 1e-6, "its member stays at x = 100.6");
    check(clq_actor_destroy(crowd, first));
    expect(clq_crowd_get_hash(crowd) != hash, "the changed crowd has another hash");

    check(clq_crowd_restore(crowd, saved.bytes, saved.size, &citizen, 1));
    expect(clq_crowd_get_hash(crowd) == hash, "the restored crowd has the hash that it had when it was saved");
    check(clq_group_get_info(crowd, carriage, &group));
    expect(group.member_count == 2, "the ids of the group and of its members are valid again");
    check(clq_actor_get_info(crowd, first, &info));

    check(clq_crowd_create(context, NULL, &other));
    check(clq_crowd_restore(other, saved.bytes, saved.size, &citizen, 1));
    check(clq_crowd_save(other, append, &again));
    expect(again.size == saved.size && memcmp(again.bytes, saved.bytes, saved.size) == 0,
           "another crowd in the same state gives the same bytes");
    expect(clq_crowd_restore(other, saved.bytes, saved.size / 2, &citizen, 1) == CLQ_FORMAT, "half a file is refused");
    expect(clq_crowd_get_actor_count(other) == 2, "and the crowd stays as it was");

    clq_crowd_destroy(other);
    clq_crowd_destroy(crowd);
    clq_template_destroy(citizen);
    check(clq_context_destroy(context));
    return printf("two passengers saved in %u bytes, restored twice\n", (unsigned)saved.size) < 0;
}
