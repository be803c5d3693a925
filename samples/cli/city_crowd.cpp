#include "samples/cli/city_crowd.h"

#include <atomic>
#include <cmath>
#include <cstdlib>

#include "samples/cli/stopwatch.h"
#include "samples/scenes/circuit.h"
#include "samples/scenes/eye.h"
#include "samples/scenes/random.h"
#include "samples/scenes/scene_crowd.h"

namespace cli
{
namespace
{

using scenes::check;
using scenes::Purpose;

constexpr uint64_t seed = 23;
constexpr double block_m = 90, half_block_m = 36, pavement_m = 3.5;
constexpr uint32_t people_a_block = 110, most_tracks = 1000;
constexpr double track_s = 240, walking_m_per_s = 1.3;
constexpr double square_m = 1.5;  // between people on the square

void *allocate(void *user, size_t bytes, size_t alignment)
{
    void *memory = std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
    if (memory) static_cast<std::atomic<uint64_t> *>(user)->fetch_add(bytes);
    return memory;
}

void release(void *user, void *memory, size_t bytes, size_t)
{
    static_cast<std::atomic<uint64_t> *>(user)->fetch_sub(bytes);
    std::free(memory);
}

struct DestroyTrack {
    void operator()(clq_track *p) const { clq_track_destroy(p); }
    void operator()(clq_locomotion *p) const { clq_locomotion_destroy(p); }
    void operator()(clq_scene *p) const { clq_scene_destroy(p); }
};

}  // namespace

struct CityCrowd::Hold {
    std::atomic<uint64_t> bytes{0};
    scenes::Own<clq_context> context;
    scenes::Own<clq_template> citizen;
    std::unique_ptr<clq_locomotion, DestroyTrack> locomotion;
    std::vector<std::unique_ptr<clq_track, DestroyTrack>> tracks;
    scenes::Own<clq_crowd> crowd;
    std::unique_ptr<clq_scene, DestroyTrack> scene;
    scenes::Own<clq_view> view;
};

CityCrowd::~CityCrowd() = default;

CityCrowd::CityCrowd(const CityOptions &options) : hold_(std::make_unique<Hold>())
{
    Hold &h = *hold_;
    clq_context_def def = clq_context_def_init();
    def.allocator = {&h.bytes, allocate, release};
    clq_context *context = nullptr;
    check(clq_context_create(&def, &context));
    h.context.reset(context);
    clq_levels_def levels = clq_levels_def_init();
    clq_prepare_def prepare = clq_prepare_def_init();
    prepare.builtin = "citizen";
    prepare.levels = &levels;
    clq_template *citizen = nullptr;
    check(clq_template_prepare(context, &prepare, &citizen, nullptr));
    h.citizen.reset(citizen);
    const uint32_t outside = options.count - options.in_view;
    const uint32_t each_way =
        std::max(3u, static_cast<uint32_t>(std::ceil(std::sqrt(static_cast<double>(outside) / people_a_block))));
    const uint64_t without_tracks = h.bytes;
    make_tracks(each_way);
    before_bytes_ = h.bytes;
    track_bytes_ = before_bytes_ - without_tracks;

    clq_crowd_def crowd_def = clq_crowd_def_init();
    crowd_def.seed = seed;
    clq_crowd *crowd = nullptr;
    check(clq_crowd_create(context, &crowd_def, &crowd));
    h.crowd.reset(crowd);
    if (options.indexed) {
        clq_scene *scene = nullptr;
        check(clq_scene_create(crowd, &scene));
        h.scene.reset(scene);
    }
    const Stopwatch creating;
    people(options, each_way);
    created_s_ = creating.ms() / 1000;
    clq_view *view = nullptr;
    check(clq_view_create(crowd, &view));
    h.view.reset(view);
    // Over the square, which lies before the city.
    const double half = std::sqrt(static_cast<double>(options.in_view)) * square_m / 2;
    const double eye[3] = {0, 12, 6}, target[3] = {0, 0, -half - 6};
    const clq_camera camera = scenes::look(eye, target, 96, 1.6, 0.5, 4 * half + 60);
    check(clq_view_set_camera(view, &camera));
}

// Walks round blocks, in either direction.
void CityCrowd::make_tracks(uint32_t each_way)
{
    Hold &h = *hold_;
    clq_locomotion_def def = clq_locomotion_def_init();
    def.tmpl = h.citizen.get();
    def.walk = clq_template_find_clip(def.tmpl, "walk");
    const uint32_t stand = clq_template_find_clip(def.tmpl, "stand");
    def.idle_count = 1, def.idles = &stand;
    clq_locomotion *locomotion = nullptr;
    check(clq_locomotion_create(h.context.get(), &def, &locomotion));
    h.locomotion.reset(locomotion);
    const uint32_t count = std::min(most_tracks, each_way * each_way);
    std::vector<clq_track_point> points;
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t block = static_cast<uint32_t>(uint64_t(i) * each_way * each_way / count);
        const double x = (block % each_way - (each_way - 1) / 2.0) * block_m, z = 80 + block / each_way * block_m;
        const double out = half_block_m + scenes::random_between(seed, i, Purpose::lane, 0.5, pavement_m);
        const scenes::Circuit circuit(out, out, 6);
        points.clear();
        for (double time = 0; time <= track_s; time += 0.5) {
            const scenes::Step step = circuit.at((i % 2 == 0 ? 1 : -1) * walking_m_per_s * time);
            points.push_back({time, {x + step.x, 0, z + step.z}, std::nanf("")});
        }
        clq_track_def track_def = clq_track_def_init();
        track_def.points = points.data();
        track_def.point_count = static_cast<uint32_t>(points.size());
        track_def.seed = i;
        clq_track *track = nullptr;
        check(clq_track_create(locomotion, &track_def, &track));
        h.tracks.emplace_back(track);
    }
}

void CityCrowd::people(const CityOptions &options, uint32_t each_way)
{
    Hold &h = *hold_;
    std::vector<clq_group> groups(options.grouped ? each_way * each_way : 0);
    for (clq_group &group : groups) check(clq_group_create(h.crowd.get(), nullptr, &group));
    const uint32_t clips[] = {clq_template_find_clip(h.citizen.get(), "stand"),
                              clq_template_find_clip(h.citizen.get(), "stand_look"),
                              clq_template_find_clip(h.citizen.get(), "stand_shift")};
    const uint32_t side = static_cast<uint32_t>(std::ceil(std::sqrt(static_cast<double>(options.in_view))));
    for (uint32_t person = 0; person < options.count; ++person) {
        const auto unit = [&](Purpose purpose) { return scenes::random_unit(seed, person, purpose); };
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = h.citizen.get();
        def.seed = person;
        def.play.clip = clips[scenes::random_bits(seed, person, Purpose::clip) % 3];
        def.play.phase_s = static_cast<float>(6 * unit(Purpose::phase));
        const bool outside = person >= options.in_view;
        const uint32_t block =
            static_cast<uint32_t>(unit(Purpose::seat) * static_cast<double>(each_way) * static_cast<double>(each_way));
        double x = (person % std::max(side, 1u) - side / 2.0) * square_m,
               z = -12 - person / std::max(side, 1u) * square_m;
        if (outside) {
            // Round a block: a place along its four sides.
            const double along = 4 * unit(Purpose::place_x),
                         across = half_block_m + pavement_m * unit(Purpose::place_z);
            const double run = (along - std::floor(along) - 0.5) * 2 * half_block_m;
            const int edge = static_cast<int>(along);
            x = (block % each_way - (each_way - 1) / 2.0) * block_m + (edge == 0   ? run
                                                                       : edge == 1 ? across
                                                                       : edge == 2 ? -run
                                                                                   : -across);
            z = 80 + block / each_way * block_m + (edge == 0 ? -across : edge == 1 ? run : edge == 2 ? across : -run);
        }
        def.transform = scenes::stand(x, 0, z, std::sin(6.28 * unit(Purpose::heading)), 1, 1);
        clq_actor actor = {};
        check(clq_actor_create(h.crowd.get(), &def, &actor));
        check(clq_actor_randomise_colours(h.crowd.get(), actor, nullptr, 0));
        if (outside && person % 10 == 0)
            check(clq_actor_follow_track(
                h.crowd.get(), actor, h.tracks[scenes::random_bits(seed, person, Purpose::row) % h.tracks.size()].get(),
                -(track_s - 60) * unit(Purpose::speed)));
        else if (outside && options.grouped) check(clq_actor_join(h.crowd.get(), actor, groups[block], nullptr));
    }
}

void CityCrowd::update(double time_s)
{
    clq_view *views[] = {hold_->view.get()};
    check(clq_crowd_update(hold_->crowd.get(), time_s, views, 1));
}

void CityCrowd::save(std::vector<uint8_t> &out) const
{
    out.clear();
    const clq_write_function append = [](void *user, const void *bytes, size_t size) -> int {
        std::vector<uint8_t> &all = *static_cast<std::vector<uint8_t> *>(user);
        const uint8_t *first = static_cast<const uint8_t *>(bytes);
        all.insert(all.end(), first, first + size);
        return 0;
    };
    check(clq_crowd_save(hold_->crowd.get(), append, &out));
}

void CityCrowd::restore(const std::vector<uint8_t> &bytes)
{
    clq_template *templates[] = {hold_->citizen.get()};
    check(clq_crowd_restore(hold_->crowd.get(), bytes.data(), bytes.size(), templates, 1));
}

clq_crowd_stats CityCrowd::stats() const
{
    clq_crowd_stats stats = clq_crowd_stats_init();
    check(clq_crowd_get_stats(hold_->crowd.get(), &stats));
    return stats;
}

uint64_t CityCrowd::held_bytes() const { return hold_->bytes - before_bytes_; }

}  // namespace cli
