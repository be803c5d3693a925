// A crowd whose individuals do all that moves or changes them, and what a host knows of them without asking a scene:
// the reference for its answers.
#pragma once

#include <map>
#include <memory>

#include "tests/api/calls.h"
#include "tests/api/saved_bytes.h"
#include "tests/api/test_world.h"

namespace scene_people
{

inline bool same(clq_actor a, clq_actor b) { return a.index1 == b.index1 && a.generation == b.generation; }

struct Person {
    clq_actor id;
    uint64_t categories = 0;
    double key = NAN;
    uint32_t level = CLQ_NONE;
};

// Numbers that follow from a seed.
class Random
{
public:
    explicit Random(uint64_t seed) : seed_(seed) {}
    uint32_t below(uint32_t n) { return static_cast<uint32_t>(mixed(seed_, ++drawn_) >> 20) % n; }
    double in(double low, double high) { return low + (high - low) * below(1000001) / 1000000; }
    bool one_in(uint32_t n) { return below(n) == 0; }

private:
    uint64_t seed_, drawn_ = 0;
};

struct Hits {
    std::vector<clq_scene_hit> all;
    uint32_t count = 0;
};

class Crowd
{
public:
    // tasks: of the context, or null; metres: the size of the field
    explicit Crowd(uint64_t seed, const clq_tasks *tasks = nullptr, double field = 30);
    ~Crowd();
    Crowd(const Crowd &) = delete;
    Crowd &operator=(const Crowd &) = delete;

    void fill(uint32_t count);
    void happen();  // one random operation of a host
    void update(double time_s);
    void save();
    void restore();

    clq_scene_actor known(const Person &person, double time_s) const;
    bool passes(const Person &person, const clq_scene_filter &filter) const;
    clq_scene_filter any_filter();
    clq_transform any_place(double reach);
    double any_time();
    Person *someone() { return people.empty() ? nullptr : &people[random.below(uint32_t(people.size()))]; }
    // Persons in the order of their rows.
    std::vector<const Person *> by_row() const;

    Random random;
    std::unique_ptr<TestWorld> world;
    SmallTemplate looks_def;
    clq_template *looks = nullptr;  // with two texture sets and two levels
    clq_crowd *crowd = nullptr;
    clq_scene *scene = nullptr;
    clq_view *views[2] = {nullptr, nullptr};
    std::vector<Person> people;
    std::vector<clq_actor> gone;
    std::vector<clq_track *> pieces;  // of one way, each after the other
    std::vector<clq_group> groups;
    double time_s = 0, field;

private:
    void move();
    void change_group();
    void walk();
    void change_looks();
    void note(clq_actor id) { people.push_back({id}); }

    void make_pieces();

    clq_part_def parts_[2];
    std::vector<uint8_t> cloth_;
    std::vector<clq_image_def> images_;
    std::vector<clq_texture_set_def> sets_;
    const uint32_t other_image_ = 1;
    saved::Bytes bytes_;
    std::vector<Person> people_then_;
    std::vector<clq_group> groups_then_;
};

// Asks a question of one of seven kinds and compares the answer with brute force.
void ask(Crowd &crowd, uint32_t which);

}  // namespace scene_people
