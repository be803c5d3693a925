// Saves of crowds for `claque bench readers`.
#include <claque/claque.h>

#include "samples/cli/reader_parts.h"

namespace cli
{

using scenes::check;
using scenes::Own;

int append_bytes(void *text, const void *bytes, size_t size_bytes)
{
    static_cast<std::string *>(text)->append(static_cast<const char *>(bytes), size_bytes);
    return 0;
}

Own<clq_asset> asset_of(const scenes::Library &library, const std::string &bytes)
{
    clq_asset *made = nullptr;
    check(clq_asset_load(library.context(), bytes.data(), bytes.size(), nullptr, &made));
    return Own<clq_asset>(made);
}

Own<clq_template> template_of(const scenes::Library &library, const std::string &bytes)
{
    clq_template *made = nullptr;
    check(clq_asset_build(library.context(), asset_of(library, bytes).get(), 0, &made));
    return Own<clq_template>(made);
}

namespace
{

struct SavedCrowd {
    scenes::Library library{1};
    Own<clq_template> tmpl = template_of(library, gltf_with_animations(1));
    Own<clq_crowd> crowd;
    std::vector<clq_actor> actors;

    explicit SavedCrowd(uint32_t count)
    {
        clq_crowd *made = nullptr;
        check(clq_crowd_create(library.context(), nullptr, &made));
        crowd.reset(made);
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = tmpl.get();
        actors.resize(count);
        for (clq_actor &actor : actors) check(clq_actor_create(made, &def, &actor));
    }
    std::string bytes() const
    {
        std::string out;
        check(clq_crowd_save(crowd.get(), append_bytes, &out));
        return out;
    }
};

std::string saved_actors(uint32_t count) { return SavedCrowd(count).bytes(); }

std::string saved_groups(uint32_t count)
{
    const SavedCrowd one(1);
    const clq_transform place = clq_transform_init();
    clq_group group;
    for (uint32_t i = 0; i < count; ++i) check(clq_group_create(one.crowd.get(), &place, &group));
    return one.bytes();
}

std::string saved_members(uint32_t count)
{
    const SavedCrowd all(count);
    const clq_transform place = clq_transform_init();
    clq_group group;
    check(clq_group_create(all.crowd.get(), &place, &group));
    for (const clq_actor actor : all.actors) check(clq_actor_join(all.crowd.get(), actor, group, &place));
    return all.bytes();
}

std::string saved_layers(uint32_t count)
{
    const SavedCrowd all(count);
    clq_layer_def def = clq_layer_def_init();
    for (const clq_actor actor : all.actors) check(clq_actor_add_layer(all.crowd.get(), actor, &def, nullptr));
    return all.bytes();
}

std::string saved_attachments(uint32_t count)
{
    const SavedCrowd one(1);
    clq_attachment_def def = clq_attachment_def_init();
    for (uint32_t i = 0; i < count; ++i) {
        def.radius = float(i % 7);
        check(clq_actor_attach(one.crowd.get(), one.actors[0], &def, nullptr));
    }
    return one.bytes();
}

Reading read_save(scenes::Library &library, const std::string &bytes)
{
    const Own<clq_template> tmpl = template_of(library, gltf_with_animations(1));
    clq_crowd *made = nullptr;
    check(clq_crowd_create(library.context(), nullptr, &made));
    const Own<clq_crowd> crowd(made);
    clq_template *templates[] = {tmpl.get()};
    return timed([&] { return outcome_of(clq_crowd_restore(made, bytes.data(), bytes.size(), templates, 1)); });
}

}  // namespace

std::vector<ReaderElement> reader_elements_of_saves()
{
    return {{"save", "actors", most_elements, saved_actors, read_save},
            {"save", "groups", most_elements, saved_groups, read_save},
            {"save", "members of one group", most_elements, saved_members, read_save},
            {"save", "layers", most_elements, saved_layers, read_save},
            {"save", "attachments of one actor", 10000, saved_attachments, read_save}};
}

}  // namespace cli
