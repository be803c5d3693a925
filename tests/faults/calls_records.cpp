// Calls for recordings and records.
#include <claque/record.h>

#include "tests/api/failing_memory.h"
#include "tests/faults/calls.h"

namespace faults
{
namespace
{

using W = World &;

int drop(void *, const void *, size_t) { return 0; }

clq_status begin(clq_crowd *crowd)
{
    clq_recording_def def = clq_recording_def_init();
    def.write = drop;
    return clq_crowd_begin_recording(crowd, &def);
}

using Opening = decltype(clq_record_load) *;

clq_record *opened(W w, bool ready, Opening opening)
{
    clq_record *record = nullptr;
    EXPECT_EQ(opening(w.test.context, w.record.data(), w.record.size(), &record), CLQ_OK) << clq_last_error();
    if (!ready) return record;
    EXPECT_EQ(clq_record_set_templates(record, w.test.templates, 2), CLQ_OK) << clq_last_error();
    const clq_host_mechanism_def lent = {w.test.mechanism(TestWorld::host).host.run, nullptr, false};
    EXPECT_EQ(clq_record_lend_mechanism(record, {TestWorld::host + 1}, &lent), CLQ_OK) << clq_last_error();
    return record;
}

// A call for a record that was opened without faults.
template <class Body>
auto in_record(bool ready, const Body &body, Opening opening = clq_record_load)
{
    return [ready, body, opening](W w) {
        clq_record *record = nullptr;
        {
            const failing_memory::Unarmed unarmed;
            record = opened(w, ready, opening);
        }
        const clq_status status = body(w, record);
        const failing_memory::Unarmed unarmed;
        clq_record_destroy(record);
        return status;
    };
}

// Plays into a crowd that is gone afterwards: one that fails leaves it in a state between.
template <class Play>
auto into_a_crowd(const Play &play, Opening opening = clq_record_load)
{
    const auto body = [play](W w, clq_record *record) {
        clq_crowd *crowd = nullptr;
        {
            const failing_memory::Unarmed unarmed;
            EXPECT_EQ(clq_crowd_create(w.test.context, nullptr, &crowd), CLQ_OK);
        }
        const clq_status status = play(record, crowd);
        const failing_memory::Unarmed unarmed;
        if (status == CLQ_OK) w.found = clq_crowd_get_hash(crowd);
        EXPECT_EQ(clq_crowd_destroy(crowd), CLQ_OK);
        return status;
    };
    return in_record(true, body, opening);
}

void add_recordings(std::vector<Call> &all)
{
    const auto end = [](W w) { EXPECT_EQ(clq_crowd_end_recording(w.bare, nullptr), CLQ_OK) << clq_last_error(); };
    const auto begun = [](W w) { begin(w.bare); };
    all.push_back({"clq_crowd_begin_recording", [](W w) { return begin(w.bare); }, 0, end});
    all.push_back({"clq_crowd_get_recording",
                   [](W w) {
                       clq_recording_info info = clq_recording_info_init();
                       return clq_crowd_get_recording(w.bare, &info);
                   },
                   quiet,
                   {},
                   {},
                   begun});
    all.push_back({"clq_crowd_end_recording",
                   [](W w) { return clq_crowd_end_recording(w.bare, nullptr); },
                   quiet,
                   {},
                   {},
                   begun});
}

}  // namespace

std::vector<unsigned char> recorded_run(TestWorld &test)
{
    std::vector<unsigned char> bytes;
    clq_recording_def def = clq_recording_def_init();
    def.user = &bytes;
    def.write = [](void *user, const void *from, size_t count) {
        const auto *first = static_cast<const unsigned char *>(from);
        auto &to = *static_cast<std::vector<unsigned char> *>(user);
        to.insert(to.end(), first, first + count);
        return 0;
    };
    clq_crowd *crowd = nullptr;
    EXPECT_EQ(clq_crowd_create(test.context, nullptr, &crowd), CLQ_OK) << clq_last_error();
    test.set_up(crowd);
    test.fill(crowd, 5, 3);
    EXPECT_EQ(clq_crowd_begin_recording(crowd, &def), CLQ_OK) << clq_last_error();
    test.fill(crowd, 3, 4);
    EXPECT_EQ(clq_crowd_update(crowd, 1, nullptr, 0), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_crowd_end_recording(crowd, nullptr), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_crowd_destroy(crowd), CLQ_OK) << clq_last_error();
    return bytes;
}

void add_record_calls(std::vector<Call> &all)
{
    add_recordings(all);
    all.push_back(
        {"clq_record_load",
         [](W w) { return clq_record_load(w.test.context, w.record.data(), w.record.size(), w.out<clq_record>()); }, 0,
         [](W w) { clq_record_destroy(static_cast<clq_record *>(w.made)); }});
    all.push_back(
        {"clq_record_open",
         [](W w) { return clq_record_open(w.test.context, w.record.data(), w.record.size(), w.out<clq_record>()); }, 0,
         [](W w) { clq_record_destroy(static_cast<clq_record *>(w.made)); }});
    all.push_back({"clq_record_destroy",
                   [](W) {
                       clq_record_destroy(nullptr);
                       return CLQ_OK;
                   },
                   quiet});
    all.push_back({"clq_record_get_info",
                   in_record(false,
                             [](W, clq_record *record) {
                                 clq_record_info info = clq_record_info_init();
                                 return clq_record_get_info(record, &info);
                             }),
                   quiet});
    all.push_back({"clq_record_get_crowd_def",
                   in_record(false,
                             [](W, clq_record *record) {
                                 clq_crowd_def def = clq_crowd_def_init();
                                 return clq_record_get_crowd_def(record, &def);
                             }),
                   quiet});
    all.push_back(
        {"clq_record_get_template_name",
         in_record(false,
                   [](W, clq_record *record) { return *clq_record_get_template_name(record, 0) ? CLQ_OK : CLQ_LIMIT; }),
         quiet});
    all.push_back({"clq_record_get_time",
                   in_record(false,
                             [](W, clq_record *record) {
                                 double time_s;
                                 return clq_record_get_time(record, 0, &time_s);
                             }),
                   quiet});
    all.push_back({"clq_record_set_templates", in_record(false, [](W w, clq_record *record) {
                       return clq_record_set_templates(record, w.test.templates, 2);
                   })});
    all.push_back({"clq_record_lend_mechanism", in_record(false, [](W w, clq_record *record) {
                       const clq_host_mechanism_def lent = {w.test.mechanism(TestWorld::host).host.run, nullptr, false};
                       return clq_record_lend_mechanism(record, {3}, &lent);
                   })});
    all.push_back({"clq_record_play", into_a_crowd([](clq_record *record, clq_crowd *crowd) {
                       return clq_record_play(record, crowd, 2);
                   })});
    all.push_back({"clq_record_play",
                   into_a_crowd([](clq_record *record, clq_crowd *crowd) { return clq_record_play(record, crowd, 2); },
                                clq_record_open),
                   0,
                   {},
                   "in parts"});
    all.push_back({"clq_record_play_step", into_a_crowd([](clq_record *record, clq_crowd *crowd) {
                       return clq_record_play_step(record, crowd, 0);
                   })});
}

}  // namespace faults
