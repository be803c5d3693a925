// Questions to a scene, each compared with brute force over the whole crowd.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "tests/api/scene_people.h"

namespace scene_people
{

namespace
{

double length(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }

// The whole answer of a question, and that a smaller array gets its beginning.
template <class T, class Ask>
std::vector<T> whole(Crowd &crowd, const Ask &ask)
{
    uint32_t count = 0, again = 0;
    EXPECT_EQ(ask(static_cast<T *>(nullptr), 0u, &count), CLQ_OK) << clq_last_error();
    std::vector<T> all(count), some(crowd.random.below(count + 1));
    EXPECT_EQ(ask(all.data(), count, &again), CLQ_OK) << clq_last_error();
    EXPECT_EQ(again, count);
    EXPECT_EQ(ask(some.data(), uint32_t(some.size()), &again), CLQ_OK) << clq_last_error();
    EXPECT_EQ(again, count);
    EXPECT_TRUE(some.empty() || std::memcmp(some.data(), all.data(), some.size() * sizeof(T)) == 0)
        << "the first " << some.size() << " of " << count << " are other ones";
    return all;
}

struct Wanted {
    clq_actor actor;
    clq_scene_actor known;
    double distance;
};

// Everyone present whom `test` gives a distance, by it and by row.
template <class Test>
std::vector<Wanted> everyone(const Crowd &crowd, const clq_scene_filter &filter, double time_s, const Test &test)
{
    std::vector<Wanted> out;
    for (const Person *person : crowd.by_row()) {
        const clq_scene_actor known = crowd.known(*person, time_s);
        if (!known.present || !crowd.passes(*person, filter)) continue;
        const double distance = test(known);
        if (distance >= 0) out.push_back({person->id, known, distance});
    }
    return out;
}

void sort_by_distance(std::vector<Wanted> &wanted)
{
    std::stable_sort(wanted.begin(), wanted.end(),
                     [](const Wanted &a, const Wanted &b) { return a.distance < b.distance; });
}

void expect_equal(const std::vector<clq_scene_hit> &hits, const std::vector<Wanted> &wanted, const char *question)
{
    ASSERT_EQ(hits.size(), wanted.size()) << question;
    for (size_t i = 0; i < hits.size(); ++i) {
        ASSERT_TRUE(same(hits[i].actor, wanted[i].actor)) << question << ", answer " << i;
        ASSERT_EQ(hits[i].distance, wanted[i].distance) << question << ", answer " << i;
        for (int k = 0; k < 3; ++k) ASSERT_EQ(hits[i].position[k], wanted[i].known.position[k]) << question;
    }
}

void ask_near(Crowd &crowd)
{
    const clq_scene_filter filter = crowd.any_filter();
    const clq_transform at = crowd.any_place(crowd.field);
    const double time_s = crowd.any_time(), radius = crowd.random.one_in(8) ? HUGE_VAL : crowd.random.in(0, 12);
    std::vector<Wanted> wanted = everyone(crowd, filter, time_s, [&](const clq_scene_actor &known) {
        const double d = length(known.position[0] - at.position[0], known.position[1] - at.position[1],
                                known.position[2] - at.position[2]);
        return d <= radius ? d : -1;
    });
    sort_by_distance(wanted);
    const auto hits = whole<clq_scene_hit>(crowd, [&](clq_scene_hit *out, uint32_t capacity, uint32_t *count) {
        return clq_scene_find_within(crowd.scene, time_s, at.position, radius, &filter, out, capacity, count);
    });
    expect_equal(hits, wanted, "within");
    std::vector<clq_scene_hit> nearest(1 + crowd.random.below(12));
    uint32_t count = 0;
    ASSERT_EQ(clq_scene_find_nearest(crowd.scene, time_s, at.position, radius, &filter, nearest.data(),
                                     uint32_t(nearest.size()), &count),
              CLQ_OK);
    ASSERT_EQ(count, std::min(nearest.size(), wanted.size()));
    nearest.resize(count), wanted.resize(count);
    expect_equal(nearest, wanted, "nearest");
}

void ask_box(Crowd &crowd)
{
    const clq_scene_filter filter = crowd.any_filter();
    const clq_transform a = crowd.any_place(crowd.field), b = crowd.any_place(crowd.field);
    const double time_s = crowd.any_time();
    double low[3], high[3];
    for (int k = 0; k < 3; ++k)
        low[k] = std::min(a.position[k], b.position[k]), high[k] = std::max(a.position[k], b.position[k]);
    if (crowd.random.one_in(3)) low[1] = -HUGE_VAL, high[1] = HUGE_VAL;
    const std::vector<Wanted> wanted = everyone(crowd, filter, time_s, [&](const clq_scene_actor &known) {
        for (int k = 0; k < 3; ++k)
            if (known.position[k] < low[k] || known.position[k] > high[k]) return -1.0;
        return 0.0;
    });
    const auto hits = whole<clq_scene_hit>(crowd, [&](clq_scene_hit *out, uint32_t capacity, uint32_t *count) {
        return clq_scene_find_in_box(crowd.scene, time_s, low, high, &filter, out, capacity, count);
    });
    expect_equal(hits, wanted, "box");
}

void ask_ray(Crowd &crowd)
{
    const clq_scene_filter filter = crowd.any_filter();
    const clq_transform a = crowd.any_place(crowd.field), b = crowd.any_place(crowd.field);
    const double time_s = crowd.any_time(), most = crowd.random.one_in(2) ? HUGE_VAL : crowd.random.in(0, 40);
    clq_ray ray = {{a.position[0], a.position[1], a.position[2]}, {}, most};
    for (int k = 0; k < 3; ++k) ray.direction[k] = b.position[k] - a.position[k];
    const double size = length(ray.direction[0], ray.direction[1], ray.direction[2]);
    if (!(size > 0.1)) return;
    std::vector<Wanted> wanted = everyone(crowd, filter, time_s, [&](const clq_scene_actor &known) {
        double along = 0, square = 0;
        for (int k = 0; k < 3; ++k) {
            const double to = known.centre[k] - ray.origin[k];
            along += to * ray.direction[k] / size;
            square += to * to;
        }
        if (square <= known.radius * known.radius) return 0.0;
        const double across = square - along * along, root = known.radius * known.radius - across;
        if (along < 0 || root < 0) return -1.0;
        const double entry = along - std::sqrt(root);
        return entry <= most ? entry : -1;
    });
    sort_by_distance(wanted);
    const auto hits = whole<clq_scene_hit>(crowd, [&](clq_scene_hit *out, uint32_t capacity, uint32_t *count) {
        return clq_scene_find_on_ray(crowd.scene, time_s, &ray, &filter, out, capacity, count);
    });
    // Another formula: entries differ in their last bits, and so may the actor that is met at an edge.
    ASSERT_EQ(hits.size(), wanted.size());
    for (size_t i = 0; i < hits.size(); ++i) ASSERT_NEAR(hits[i].distance, wanted[i].distance, 1e-6);
}

void ask_frustum(Crowd &crowd)
{
    const clq_scene_filter filter = crowd.any_filter();
    const clq_transform a = crowd.any_place(crowd.field), b = crowd.any_place(crowd.field);
    const double time_s = crowd.any_time(), target[3] = {b.position[0], 0.3, b.position[2] + 0.1};
    const double eye[3] = {a.position[0], 1.7, a.position[2]};
    const float up[3] = {0, 1, 0};
    clq_camera camera;
    ASSERT_EQ(api_test::look_at(&camera, eye, target, up, 0.6f, 1.5f, 0.5f, float(crowd.random.in(2, 60))), CLQ_OK);
    // Planes of the six bounds of clip space, from the matrix that GL would use.
    const float *q = camera.rotation_xyzw;
    const auto turned = [&](const double v[3], double out[3]) {
        const double x = q[0], y = q[1], z = q[2], w = q[3], s = 2 / (x * x + y * y + z * z + w * w);
        const double m[9] = {1 - s * (y * y + z * z), s * (x * y - w * z),     s * (x * z + w * y),
                             s * (x * y + w * z),     1 - s * (x * x + z * z), s * (y * z - w * x),
                             s * (x * z - w * y),     s * (y * z + w * x),     1 - s * (x * x + y * y)};
        for (int r = 0; r < 3; ++r) out[r] = m[3 * r] * v[0] + m[3 * r + 1] * v[1] + m[3 * r + 2] * v[2];
    };
    double nearest_edge = HUGE_VAL;
    const std::vector<Wanted> wanted = everyone(crowd, filter, time_s, [&](const clq_scene_actor &known) {
        double away[3], to[3], seen[3];
        for (int k = 0; k < 3; ++k) away[k] = known.centre[k] - eye[k], to[k] = known.position[k] - eye[k];
        turned(away, seen);
        bool meets = true;
        for (int i = 0; i < 6; ++i) {
            double n[4], size = 0, distance = 0;
            for (int k = 0; k < 4; ++k)
                n[k] =
                    double(camera.projection[4 * k + 3]) + (i % 2 ? -1 : 1) * double(camera.projection[4 * k + i / 2]);
            size = length(n[0], n[1], n[2]);
            for (int k = 0; k < 3; ++k) distance += n[k] / size * seen[k];
            distance += n[3] / size;
            nearest_edge = std::min(nearest_edge, std::fabs(distance + known.radius));
            meets = meets && distance >= -known.radius;
        }
        return meets ? length(to[0], to[1], to[2]) : -1;
    });
    const auto hits = whole<clq_scene_hit>(crowd, [&](clq_scene_hit *out, uint32_t capacity, uint32_t *count) {
        return clq_scene_find_in_frustum(crowd.scene, time_s, &camera, &filter, out, capacity, count);
    });
    if (nearest_edge < 1e-9) return;  // the two formulas may round to either side
    expect_equal(hits, wanted, "frustum");
}

void ask_state(Crowd &crowd)
{
    const clq_scene_filter filter = crowd.any_filter();
    std::vector<clq_actor> wanted;
    for (const Person *person : crowd.by_row())
        if (crowd.passes(*person, filter)) wanted.push_back(person->id);
    const auto found = whole<clq_actor>(crowd, [&](clq_actor *out, uint32_t capacity, uint32_t *count) {
        return clq_scene_find(crowd.scene, &filter, out, capacity, count);
    });
    ASSERT_EQ(found.size(), wanted.size());
    for (size_t i = 0; i < found.size(); ++i) ASSERT_TRUE(same(found[i], wanted[i])) << "answer " << i;
}

void ask_order(Crowd &crowd)
{
    const clq_scene_filter filter = crowd.any_filter();
    const double a = crowd.random.below(40), b = crowd.random.one_in(4) ? HUGE_VAL : crowd.random.below(40);
    std::vector<const Person *> keyed;
    for (const Person *person : crowd.by_row())
        if (crowd.passes(*person, filter) && !std::isnan(person->key)) keyed.push_back(person);
    std::stable_sort(keyed.begin(), keyed.end(), [](const Person *p, const Person *q) { return p->key < q->key; });
    std::vector<clq_actor> wanted;
    for (const Person *person : keyed)
        if (person->key >= a && person->key <= b) wanted.push_back(person->id);
    const auto found = whole<clq_actor>(crowd, [&](clq_actor *out, uint32_t capacity, uint32_t *count) {
        return clq_scene_find_keys(crowd.scene, a, b, &filter, out, capacity, count);
    });
    ASSERT_EQ(found.size(), wanted.size());
    for (size_t i = 0; i < found.size(); ++i) ASSERT_TRUE(same(found[i], wanted[i])) << "answer " << i;
    for (size_t i = 0; i < keyed.size(); ++i)
        for (const bool back : {false, true}) {
            const size_t next = back ? i - 1 : i + 1;
            clq_actor got = {9, 9};
            ASSERT_EQ(clq_scene_find_next(crowd.scene, keyed[i]->id, back, &filter, &got), CLQ_OK) << clq_last_error();
            ASSERT_TRUE(same(got, next < keyed.size() ? keyed[next]->id : clq_actor{0, 0}));
        }
}

void ask_id(Crowd &crowd)
{
    const double time_s = crowd.any_time();
    if (const Person *person = crowd.someone()) {
        const clq_scene_actor known = crowd.known(*person, time_s);
        clq_actor_info info = clq_actor_info_init();
        ASSERT_EQ(clq_actor_get_info(crowd.crowd, person->id, &info), CLQ_OK);
        EXPECT_EQ(known.tmpl, info.tmpl);
        EXPECT_EQ(known.texture_set, info.texture_set);
        EXPECT_EQ(known.categories, person->categories);
        EXPECT_EQ(known.level, person->level);
        EXPECT_TRUE(known.key == person->key || (std::isnan(known.key) && std::isnan(person->key)));
    }
    if (crowd.gone.empty()) return;
    clq_scene_actor out = clq_scene_actor_init();
    const clq_actor gone = crowd.gone[crowd.random.below(uint32_t(crowd.gone.size()))];
    for (const Person &person : crowd.people)
        if (same(person.id, gone)) return;  // a restored state has it again
    EXPECT_EQ(clq_scene_get_actor(crowd.scene, gone, time_s, &out), CLQ_STALE_ID);
}

}  // namespace

void ask(Crowd &crowd, uint32_t which)
{
    void (*const questions[])(Crowd &) = {ask_near, ask_box, ask_ray, ask_frustum, ask_state, ask_order, ask_id};
    questions[which % 7](crowd);
}

}  // namespace scene_people
