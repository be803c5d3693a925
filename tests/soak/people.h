// A crowd whose actors, groups and views come and go, and that plays on after it was saved and its templates were made
// anew. All that happens to it is a function of (seed, step).
#pragma once

#include <claque/claque.h>

#include <cstdint>
#include <vector>

#include "tests/api/test_world.h"

namespace soak
{

class People
{
public:
    // From what save() gave of other people, or new.
    People(TestWorld &world, uint64_t seed);
    People(TestWorld &world, const People &others, const std::vector<uint8_t> &saved);
    ~People();
    People(const People &) = delete;
    People &operator=(const People &) = delete;

    void happen(uint64_t step);
    void update(uint64_t step);
    uint64_t hash() const;  // of the crowd and of what its views show
    std::vector<uint8_t> save() const;

    // What the host knows of its crowd.
    struct Known {
        std::vector<clq_actor> actors;
        std::vector<clq_group> groups;
        std::vector<clq_attachment> attachments;
        std::vector<uint64_t> cameras;  // one a view
        uint64_t commands = 0, refused = 0;
    } known;
    clq_template *templates[2] = {nullptr, nullptr};
    clq_crowd *crowd = nullptr;
    std::vector<clq_view *> views;

private:
    void build();
    void follow_cameras();
    void note(clq_status status);
    void come_or_go(uint64_t bits);
    void group(uint64_t bits);
    void play(uint64_t bits, double time_s);
    void behave(uint64_t bits, double time_s);
    void change(uint64_t bits);

    TestWorld &world_;
    uint64_t seed_;
};

constexpr double step_s = 0.02;

}  // namespace soak
