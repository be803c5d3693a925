// Prints a hash each of what libclaque and its companions compute for fixed scenes: equal with every compiler, every
// optimisation, every processor and every C library (expected.txt).
#include "tests/bits/bits.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace bits
{

const std::vector<const char *> people = {"citizen", "patrician", "decurion", "plebeian"};

void check(clq_status status)
{
    if (status == CLQ_OK) return;
    std::fprintf(stderr, "%s: %s\n", clq_status_name(status), clq_last_error());
    std::exit(1);
}

void Hash::add(const void *bytes, size_t size_bytes)
{
    const auto *data = static_cast<const unsigned char *>(bytes);
    for (size_t i = 0; i < size_bytes; ++i) value_ = (value_ ^ data[i]) * 1099511628211u;
}

int Hash::write(void *hash, const void *bytes, size_t size_bytes)
{
    static_cast<Hash *>(hash)->add(bytes, size_bytes);
    return 0;
}

void print(const std::string &name, const Hash &hash)
{
    std::printf("%-24s %016llx\n", name.c_str(), static_cast<unsigned long long>(hash.value()));
}

clq_template *built(clq_context *context, const char *name)
{
    clq_asset *asset;
    clq_template *out;
    check(clq_asset_builtin(context, name, &asset));
    check(clq_asset_build(context, asset, 0, &out));
    clq_asset_destroy(asset);
    return out;
}

clq_camera camera_at(const double eye[3], const double target[3])
{
    clq_look_at_def look = clq_look_at_def_init();
    clq_camera out;
    std::memcpy(look.eye, eye, sizeof look.eye);
    std::memcpy(look.target, target, sizeof look.target);
    look.fov_y_rad = 0.9f, look.aspect = 1.5f, look.z_far = 400;
    check(clq_camera_look_at(&look, &out));
    return out;
}

void Seen::add(const clq_view *view, bool with_palettes)
{
    clq_view_stats stats = clq_view_stats_init();
    check(clq_view_get_stats(view, &stats));
    list.add(clq_view_get_hash(view));
    for (uint32_t i = 0; i < stats.visible; ++i) {
        clq_drawn_actor drawn = clq_drawn_actor_init();
        check(clq_view_get_drawn_actor(view, i, &drawn));
        std::vector<float> positions(3 * drawn.vertex_count), normals(3 * drawn.vertex_count);
        check(clq_view_get_vertices(view, i, positions.data(), normals.data(), drawn.vertex_count));
        vertices.add(positions), vertices.add(normals);
        if (!with_palettes) continue;
        std::vector<float> palette(12 * drawn.joint_count);
        check(clq_view_get_palette(view, i, palette.data(), drawn.joint_count));
        palettes.add(palette);
    }
}

int print_sections(const clq_context_def *def, char **first, char **last)
{
    const std::pair<const char *, void (*)(clq_context *)> sections[] = {
        {"levels", levels}, {"templates", templates}, {"crowds", crowds}, {"mechanisms", mechanisms},
        {"files", files},   {"tracks", tracks},       {"stage", stage}};
    clq_context *context;
    check(clq_context_create(def, &context));
    for (const auto &[name, run] : sections) {
        bool wanted = first == last;
        for (char **one = first; one != last; ++one) wanted = wanted || std::strcmp(*one, name) == 0;
        if (wanted) run(context);
    }
    check(clq_context_destroy(context));
    return std::fflush(stdout) != 0;
}

}  // namespace bits
