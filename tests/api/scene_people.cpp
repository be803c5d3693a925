#include "tests/api/scene_people.h"

#include <algorithm>
#include <cmath>

namespace scene_people
{

Crowd::Crowd(uint64_t seed, const clq_tasks *tasks, double size) : random(seed), field(size)
{
    clq_context_def context = clq_context_def_init();
    if (tasks) context.tasks = *tasks;
    world = std::make_unique<TestWorld>(&context);
    cloth_.assign(4 * 4 * 4, 60);
    for (size_t i = 3; i < cloth_.size(); i += 4) cloth_[i] = 100;
    images_ = {looks_def.images[0], {"cloth", 4, 4, cloth_.data(), CLQ_ALPHA_ZONE_KEYS}};
    sets_ = {{"plain", &other_image_}};
    looks_def.def.name = "looks";
    looks_def.def.image_count = 2, looks_def.def.images = images_.data();
    looks_def.def.texture_set_count = 1, looks_def.def.texture_sets = sets_.data();
    parts_[0] = parts_[1] = looks_def.parts[0];
    parts_[0].lod_max_m = parts_[1].lod_min_m = 12;
    looks_def.def.part_count = 2, looks_def.def.parts = parts_;
    EXPECT_EQ(clq_template_build(world->context, &looks_def.def, &looks), CLQ_OK) << clq_last_error();
    crowd = world->new_crowd();
    world->set_up(crowd);
    note({1, 1});
    make_pieces();
    views[0] = world->new_view(crowd, 0), views[1] = world->new_view(crowd, 12);
    EXPECT_EQ(clq_scene_create(crowd, &scene), CLQ_OK) << clq_last_error();
}

Crowd::~Crowd()
{
    EXPECT_EQ(clq_scene_destroy(scene), CLQ_OK) << clq_last_error();
    clq_template_destroy(looks);
    for (clq_track *piece : pieces) clq_track_destroy(piece);
}

// A fast way with corners, upstairs.
void Crowd::make_pieces()
{
    std::vector<clq_track_point> points;
    for (int i = 0; i <= 120; ++i) {
        const double t = 0.1 * i, corner = std::fabs(std::fmod(t, 4) - 2);
        points.push_back({t, {3.5 * t - 20, 0.2 * t, 4 * corner}, NAN});
    }
    for (int k = 1; k <= 6; ++k) {
        clq_track_def def = clq_track_def_init();
        def.points = points.data(), def.point_count = uint32_t(points.size());
        def.previous = pieces.empty() ? nullptr : pieces.back(), def.end_s = 1.7 * k;
        pieces.push_back(nullptr);
        EXPECT_EQ(clq_track_create(world->locomotion, &def, &pieces.back()), CLQ_OK) << clq_last_error();
    }
}

clq_transform Crowd::any_place(double reach)
{
    clq_transform out = clq_transform_init();
    out.position[0] = random.in(-reach, reach), out.position[2] = random.in(-reach, reach);
    out.position[1] = random.one_in(4) ? random.in(0, 3) : 0;
    const double half = random.in(-1.5, 1.5);
    out.orientation_xyzw[1] = float(std::sin(half)), out.orientation_xyzw[3] = float(std::cos(half));
    out.scale = float(random.one_in(6) ? random.in(-3, -0.5) : random.in(0.5, 1.5));
    if (random.one_in(50)) out.scale *= 20;
    return out;
}

double Crowd::any_time() { return random.one_in(3) ? random.in(-5, 40) : time_s; }

void Crowd::fill(uint32_t count)
{
    while (people.size() < count) {
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = random.one_in(3) ? looks : world->templates[random.one_in(4)];
        def.transform = any_place(field);
        def.seed = random.below(1u << 30);
        clq_actor made;
        ASSERT_EQ(clq_actor_create(crowd, &def, &made), CLQ_OK) << clq_last_error();
        note(made);
    }
}

void Crowd::move()
{
    const uint32_t count = 1 + random.below(5);
    std::vector<clq_actor> ids;
    std::vector<clq_transform> places;
    for (uint32_t i = 0; i < count && someone(); ++i) {
        ids.push_back(someone()->id);
        clq_actor_info info = clq_actor_info_init();
        ASSERT_EQ(clq_actor_get_info(crowd, ids.back(), &info), CLQ_OK);
        if (random.one_in(3)) info.transform = any_place(field);
        for (double &x : info.transform.position) x += random.in(-0.3, 0.3);
        places.push_back(info.transform);
    }
    EXPECT_EQ(clq_crowd_set_transforms(crowd, ids.data(), places.data(), uint32_t(ids.size())), CLQ_OK);
}

void Crowd::change_group()
{
    const clq_transform place = any_place(field);
    if (groups.empty() || (groups.size() < 6 && random.one_in(6))) {
        clq_group made;
        ASSERT_EQ(clq_group_create(crowd, &place, &made), CLQ_OK);
        groups.push_back(made);
        return;
    }
    const size_t which = random.below(uint32_t(groups.size()));
    if (random.one_in(12)) {
        EXPECT_EQ(clq_group_destroy(crowd, groups[which]), CLQ_OK);
        groups.erase(groups.begin() + long(which));
    } else if (random.one_in(2)) {
        EXPECT_EQ(clq_group_set_transform(crowd, groups[which], &place), CLQ_OK);
    } else if (Person *individual = someone()) {
        const clq_transform seat = any_place(3);
        const clq_group to = random.one_in(4) ? clq_group{0, 0} : groups[which];
        clq_actor_join(crowd, individual->id, to, random.one_in(2) ? &seat : nullptr);  // refused on a track
    }
}

void Crowd::walk()
{
    Person *individual = someone();
    if (!individual) return;
    const double begin_s = random.in(-3, 20);
    if (random.one_in(3)) {
        const clq_root_path_play motion = {{random.below(3)}, float(random.in(-1, 1)), 0, begin_s};
        EXPECT_EQ(clq_actor_play_root_path(crowd, individual->id, &motion), CLQ_OK);
    } else if (random.one_in(3)) {
        const uint32_t count = 1 + random.below(uint32_t(pieces.size()));
        for (uint32_t i = 0; i < count; ++i) clq_actor_follow_track(crowd, individual->id, pieces[i], begin_s);
    } else if (random.one_in(3)) {
        clq_actor_leave_track(crowd, individual->id, any_time());  // where it follows one
    } else {
        clq_actor_follow_track(crowd, individual->id, world->tracks[random.below(2)],
                               begin_s);  // of its template, ungrouped
    }
}

void Crowd::change_looks()
{
    Person *individual = someone();
    if (!individual) return;
    if (random.one_in(3)) {
        clq_actor_set_texture_set(crowd, individual->id, random.below(2));
        return;
    }
    if (random.one_in(2)) {
        individual->categories = uint64_t(1) << random.below(5) | (random.one_in(3) ? uint64_t(1) << 63 : 0);
        EXPECT_EQ(clq_scene_set_categories(scene, &individual->id, 1, individual->categories), CLQ_OK);
        return;
    }
    individual->key = random.one_in(4) ? NAN : random.below(40);
    EXPECT_EQ(clq_scene_set_keys(scene, &individual->id, &individual->key, 1), CLQ_OK);
}

void Crowd::update(double to_s)
{
    time_s = to_s;
    const uint32_t count = random.below(3);
    ASSERT_EQ(clq_crowd_update(crowd, to_s, views, count), CLQ_OK) << clq_last_error();
    for (uint32_t v = 0; v < count; ++v) {
        clq_view_stats stats = clq_view_stats_init();
        ASSERT_EQ(clq_view_get_stats(views[v], &stats), CLQ_OK);
        for (uint32_t i = 0; i < stats.visible; ++i) {
            clq_drawn_actor drawn = clq_drawn_actor_init();
            ASSERT_EQ(clq_view_get_drawn_actor(views[v], i, &drawn), CLQ_OK);
            for (Person &person : people)
                if (same(person.id, drawn.actor)) person.level = drawn.level;
        }
    }
}

void Crowd::save()
{
    bytes_ = saved::save(crowd);
    people_then_ = people, groups_then_ = groups;
}

// Individuals that are in both states keep what the scene was given; no level has been shown.
void Crowd::restore()
{
    if (bytes_.empty()) return;
    clq_template *templates[3] = {world->templates[0], world->templates[1], looks};
    ASSERT_EQ(clq_crowd_restore(crowd, bytes_.data(), bytes_.size(), templates, 3), CLQ_OK) << clq_last_error();
    for (Person &person : people_then_) {
        const clq_actor id = person.id;
        person = {id};
        for (const Person &now : people)
            if (same(now.id, id)) person.categories = now.categories, person.key = now.key;
    }
    people = people_then_, groups = groups_then_;
    bytes_.clear();
}

void Crowd::happen()
{
    switch (random.below(16)) {
        case 0:
            if (people.size() < 160) fill(uint32_t(people.size()) + 1);
            break;
        case 1:
            if (people.size() > 100) {
                const size_t which = random.below(uint32_t(people.size()));
                EXPECT_EQ(clq_actor_destroy(crowd, people[which].id), CLQ_OK);
                gone.push_back(people[which].id);
                people.erase(people.begin() + long(which));
            }
            break;
        case 2:
            if (people.size() < 160 && someone()) {
                clq_actor twin;
                ASSERT_EQ(clq_actor_clone(crowd, someone()->id, nullptr, 7, &twin), CLQ_OK);
                note(twin);
            }
            break;
        case 3:
        case 4:
        case 5:
            move();
            break;
        case 6:
        case 7:
            change_group();
            break;
        case 8:
        case 9:
        case 10:
            walk();
            break;
        case 11:
        case 12:
            change_looks();
            break;
        case 13:
            update(random.one_in(8) ? random.in(0, 30) : time_s + 0.04);
            break;
        case 14:
            time_s += random.in(-0.1, 0.3);
            EXPECT_EQ(clq_scene_update(scene, time_s), CLQ_OK);
            break;
        default:
            if (random.one_in(40)) save();
            else if (random.one_in(40)) restore();
    }
}

clq_scene_actor Crowd::known(const Person &person, double at_s) const
{
    clq_scene_actor out = clq_scene_actor_init();
    EXPECT_EQ(clq_scene_get_actor(scene, person.id, at_s, &out), CLQ_OK) << clq_last_error();
    return out;
}

bool Crowd::passes(const Person &person, const clq_scene_filter &filter) const
{
    clq_actor_info info = clq_actor_info_init();
    EXPECT_EQ(clq_actor_get_info(crowd, person.id, &info), CLQ_OK);
    return (!filter.tmpl || info.tmpl == filter.tmpl) &&
           (filter.texture_set == CLQ_NONE || info.texture_set == filter.texture_set) &&
           (filter.level == CLQ_NONE || person.level == filter.level) &&
           (filter.any_of == 0 || (person.categories & filter.any_of) != 0) &&
           (person.categories & filter.all_of) == filter.all_of && (person.categories & filter.none_of) == 0;
}

clq_scene_filter Crowd::any_filter()
{
    clq_scene_filter filter = clq_scene_filter_init();
    if (random.one_in(2)) return filter;
    if (random.one_in(3)) filter.tmpl = random.one_in(2) ? looks : world->templates[random.below(2)];
    if (random.one_in(4)) filter.texture_set = random.below(3);
    if (random.one_in(4)) filter.level = random.below(3);
    if (random.one_in(4)) filter.any_of = 1u << random.below(6) | 1u << random.below(6);
    if (random.one_in(6)) filter.all_of = uint64_t(1) << 63;
    if (random.one_in(4)) filter.none_of = 1u << random.below(6);
    return filter;
}

std::vector<const Person *> Crowd::by_row() const
{
    std::vector<const Person *> out;
    for (const Person &person : people) out.push_back(&person);
    std::sort(out.begin(), out.end(), [](const Person *a, const Person *b) { return a->id.index1 < b->id.index1; });
    return out;
}

}  // namespace scene_people
