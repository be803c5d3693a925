// Calls for templates.
#include "tests/faults/calls.h"

namespace faults
{
namespace
{

using W = World &;

clq_status found(uint32_t index) { return index == CLQ_NONE ? CLQ_LIMIT : CLQ_OK; }

const clq_template *one(W w) { return w.test.templates[0]; }

void add_template_makers(std::vector<Call> &all)
{
    all.push_back({"clq_template_build",
                   [](W w) { return clq_template_build(w.test.context, &w.test.with_dofs.def, w.out<clq_template>()); },
                   0, note_template});
    all.push_back({"clq_template_load",
                   [](W w) {
                       return clq_template_load(w.test.context, w.saved_template.data(), w.saved_template.size(),
                                                w.out<clq_template>());
                   },
                   0, note_template});
    all.push_back({"clq_template_save", [](W w) {
                       w.found = 0;
                       const auto take = [](void *user, const void *bytes, size_t count) {
                           uint64_t &sum = *static_cast<uint64_t *>(user);
                           sum = 31 * sum + hash_of(bytes, count);
                           return 0;
                       };
                       return clq_template_save(one(w), take, &w.found);
                   }});
    all.push_back({"clq_template_destroy",
                   [](W w) {
                       clq_template_destroy(w.test.templates[1]);  // crowds and the renderer still hold it
                       w.test.templates[1] = nullptr;
                       return CLQ_OK;
                   },
                   quiet | ends});
}

template <class Info, class Get>
void add_info(std::vector<Call> &all, const char *name, Info (*init)(), Get get, uint32_t traits = quiet)
{
    all.push_back({name,
                   [=](W w) {
                       Info info = init();
                       return get(w, &info);
                   },
                   traits});
}

void add_facts(std::vector<Call> &all)
{
    add_info(all, "clq_template_get_info", clq_template_info_init,
             [](W w, clq_template_info *out) { return clq_template_get_info(one(w), out); });
    add_info(all, "clq_template_get_clip", clq_clip_info_init,
             [](W w, clq_clip_info *out) { return clq_template_get_clip(one(w), 0, out); });
    add_info(all, "clq_template_get_zone", clq_zone_info_init,
             [](W w, clq_zone_info *out) { return clq_template_get_zone(one(w), 0, out); });
    add_info(all, "clq_template_get_dof", clq_dof_info_init,
             [](W w, clq_dof_info *out) { return clq_template_get_dof(one(w), 0, out); });
    add_info(all, "clq_template_get_level", clq_level_info_init,
             [](W w, clq_level_info *out) { return clq_template_get_level(one(w), 0, out); });
    add_info(all, "clq_template_get_mesh", clq_mesh_init,
             [](W w, clq_mesh *out) { return clq_template_get_mesh(one(w), 0, out); });
    add_info(all, "clq_template_get_triangles", clq_triangles_init,
             [](W w, clq_triangles *out) { return clq_template_get_triangles(one(w), 0, 0, out); });
    // The small template has neither; the refusal writes a sentence.
    add_info(
        all, "clq_template_get_marker", clq_marker_info_init,
        [](W w, clq_marker_info *out) {
            clq_template_get_marker(one(w), 0, out);
            return CLQ_OK;
        },
        inside);
    add_info(
        all, "clq_template_get_morph_target", clq_morph_target_init,
        [](W w, clq_morph_target *out) {
            clq_template_get_morph_target(one(w), 0, 0, out);
            return CLQ_OK;
        },
        inside);
    all.push_back({"clq_template_get_node_name",
                   [](W w) { return *clq_template_get_node_name(one(w), 0) ? CLQ_OK : CLQ_LIMIT; }, quiet});
    all.push_back({"clq_template_get_texture_set_name",
                   [](W w) { return *clq_template_get_texture_set_name(one(w), 0) ? CLQ_LIMIT : CLQ_OK; }, quiet});
    all.push_back({"clq_template_find_clip", [](W w) { return found(clq_template_find_clip(one(w), "bend")); }, quiet});
    all.push_back({"clq_template_find_zone", [](W w) { return found(clq_template_find_zone(one(w), "skin")); }, quiet});
    all.push_back({"clq_template_find_node", [](W w) { return found(clq_template_find_node(one(w), "tip")); }, quiet});
    all.push_back({"clq_template_find_dof", [](W w) { return found(clq_template_find_dof(one(w), "nod")); }, quiet});
    all.push_back({"clq_template_find_texture_set",
                   [](W w) { return clq_template_find_texture_set(one(w), "none") == CLQ_NONE ? CLQ_OK : CLQ_LIMIT; },
                   quiet});
}

void add_arrays(std::vector<Call> &all)
{
    all.push_back({"clq_template_get_influences",
                   [](W w) {
                       uint16_t joints[64];
                       float weights[64];
                       clq_influences out = clq_influences_init();
                       out.per_vertex = 4, out.joints = joints, out.weights = weights, out.capacity = 64;
                       return clq_template_get_influences(one(w), 0, &out);
                   },
                   quiet});
    all.push_back({"clq_template_get_wrap",
                   [](W w) {
                       clq_wrap s, t;
                       return clq_template_get_wrap(one(w), 0, &s, &t);
                   },
                   quiet});
    all.push_back({"clq_template_get_texture",
                   [](W w) {
                       uint8_t rgb[3 * 64];
                       uint32_t zones[64];
                       clq_texels out = clq_texels_init();
                       out.rgb = rgb, out.zones = zones, out.capacity = 64;
                       return clq_template_get_texture(one(w), 0, 0, &out);
                   },
                   quiet});
    all.push_back({"clq_template_get_split_picture", [](W w) {
                       uint8_t rgb[3 * 16 * 16];
                       clq_picture out = clq_picture_init();
                       out.pixels = rgb, out.capacity_bytes = sizeof rgb;
                       const clq_status status = clq_template_get_split_picture(one(w), 0, 2, &out);
                       w.found = status == CLQ_OK ? hash_of(rgb, sizeof rgb) : 0;
                       return status;
                   }});
    all.push_back({"clq_template_get_root_motion",
                   [](W w) {
                       double motion[3];
                       return clq_template_get_root_motion(one(w), 0, 0, 1, motion);
                   },
                   quiet});
}

}  // namespace

void note_template(World &w)
{
    auto *tmpl = static_cast<clq_template *>(w.made);
    w.found = bytes_of(tmpl);
    clq_template_destroy(tmpl);
}

void add_template_calls(std::vector<Call> &all) { add_template_makers(all), add_facts(all), add_arrays(all); }

}  // namespace faults
