// Saves of crowds for `claque bench readers`.
#include <claque/behave.h>
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
    Own<clq_template> tmpl;
    Own<clq_crowd> crowd;
    std::vector<clq_actor> actors;

    explicit SavedCrowd(uint32_t count, const std::string &gltf = gltf_with_animations(1))
        : tmpl(template_of(library, gltf))
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

// Plays the only clip.
clq_mechanism idle_mechanism(const SavedCrowd &all)
{
    const uint32_t clip = 0;
    clq_mechanism_def def = clq_mechanism_def_init();
    def.tmpl = all.tmpl.get(), def.kind = CLQ_MECHANISM_IDLE;
    def.idle.clip_count = 1, def.idle.clips = &clip;
    clq_mechanism made;
    check(clq_crowd_add_mechanism(all.crowd.get(), &def, &made));
    return made;
}

std::string saved_mechanisms(uint32_t count)
{
    const SavedCrowd one(1);
    for (uint32_t i = 0; i < count; ++i) idle_mechanism(one);
    return one.bytes();
}

std::string saved_uses(uint32_t count)
{
    const SavedCrowd all(count);
    clq_mechanism_attachment use = clq_mechanism_attachment_init();
    use.mechanism = idle_mechanism(all);
    for (const clq_actor actor : all.actors) check(clq_actor_attach_mechanism(all.crowd.get(), actor, &use));
    return all.bytes();
}

void add_root_path(const SavedCrowd &to, uint32_t positions)
{
    std::vector<float> all(3 * size_t(positions));
    for (size_t i = 0; i < all.size(); ++i) all[i] = float(i % 7);
    clq_root_path_def def = clq_root_path_def_init();
    def.count = positions, def.positions = all.data();
    clq_root_path made;
    check(clq_crowd_add_root_path(to.crowd.get(), &def, &made));
}

std::string saved_root_paths(uint32_t count)
{
    const SavedCrowd one(1);
    for (uint32_t i = 0; i < count; ++i) add_root_path(one, 3);
    return one.bytes();
}

std::string saved_positions(uint32_t count)
{
    const SavedCrowd one(1);
    add_root_path(one, std::max(count, 2u));
    return one.bytes();
}

// Shut lids of `count` degrees of freedom. That number stands in a line before the bytes.
std::string saved_values(uint32_t count)
{
    const SavedCrowd one(1, gltf_with_degrees_of_freedom(count));
    std::vector<clq_dof_value> values(count);
    for (uint32_t i = 0; i < count; ++i) values[i] = {count - 1 - i, 0.5f};
    clq_mechanism_def def = clq_mechanism_def_init();
    def.tmpl = one.tmpl.get(), def.kind = CLQ_MECHANISM_BLINK;
    def.blink.closed.count = count, def.blink.closed.values = values.data();
    clq_mechanism made;
    check(clq_crowd_add_mechanism(one.crowd.get(), &def, &made));
    return digits(count) + "\n" + one.bytes();
}

Reading read_of(scenes::Library &library, const std::string &gltf, const char *bytes, size_t size)
{
    const Own<clq_template> tmpl = template_of(library, gltf);
    clq_crowd *made = nullptr;
    check(clq_crowd_create(library.context(), nullptr, &made));
    const Own<clq_crowd> crowd(made);
    clq_template *templates[] = {tmpl.get()};
    return timed([&] { return outcome_of(clq_crowd_restore(made, bytes, size, templates, 1)); });
}

Reading read_save(scenes::Library &library, const std::string &bytes)
{
    return read_of(library, gltf_with_animations(1), bytes.data(), bytes.size());
}

Reading read_values(scenes::Library &library, const std::string &bytes)
{
    const size_t begin = bytes.find('\n') + 1;
    const uint32_t count = static_cast<uint32_t>(std::stoul(bytes));
    return read_of(library, gltf_with_degrees_of_freedom(count), bytes.data() + begin, bytes.size() - begin);
}

}  // namespace

std::vector<ReaderElement> reader_elements_of_saves()
{
    return {{"save", "actors", most_elements, saved_actors, read_save},
            {"save", "groups", most_elements, saved_groups, read_save},
            {"save", "members of one group", most_elements, saved_members, read_save},
            {"save", "layers", most_elements, saved_layers, read_save},
            {"save", "attachments of one actor", 10000, saved_attachments, read_save},
            {"save", "mechanisms", most_elements, saved_mechanisms, read_save},
            {"save", "uses of a mechanism", most_elements, saved_uses, read_save},
            {"save", "values of a pose", most_elements, saved_values, read_values},
            {"save", "root paths", most_elements, saved_root_paths, read_save},
            {"save", "positions of a root path", most_elements, saved_positions, read_save}};
}

}  // namespace cli
