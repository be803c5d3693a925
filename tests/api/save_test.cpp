// Save and restore through the C API: what is restored shows, answers and goes on as what was saved.
#include <functional>
#include <string>

#include "tests/api/saved_bytes.h"
#include "tests/api/stage.h"

namespace
{

using saved::Bytes;

class Save : public testing::Test
{
protected:
    Save() : crowd_(stage_.new_crowd())
    {
        stage_.set_up(crowd_);
        actors_ = stage_.fill(crowd_, 40, 1);
    }
    clq_crowd *other()  // set up as a host would, and with other people in it
    {
        clq_crowd *crowd = stage_.new_crowd();
        stage_.set_up(crowd);
        stage_.fill(crowd, 25, 2);
        return crowd;
    }
    clq_status restore(clq_crowd *crowd, const Bytes &bytes)
    {
        return clq_crowd_restore(crowd, bytes.data(), bytes.size(), stage_.templates, 2);
    }
    // A story of 100 frames; the hashes of what two views show.
    std::vector<uint64_t> story(clq_crowd *crowd, std::vector<clq_actor> actors, uint64_t seed)
    {
        std::vector<uint64_t> out;
        clq_view *views[2] = {stage_.new_view(crowd, 0), stage_.new_view(crowd, 12)};
        for (uint32_t frame = 0; frame < 100; ++frame) {
            stage_.happen(crowd, actors, seed, frame);
            EXPECT_EQ(clq_crowd_update(crowd, 3 + 0.05 * frame, views, 2), CLQ_OK) << clq_last_error();
            out.push_back(clq_view_hash(views[0]));
            out.push_back(clq_view_hash(views[1]));
        }
        for (clq_view *view : views) clq_view_destroy(view);
        return out;
    }
    void refused(const Bytes &bytes, clq_status status, const char *sentence)
    {
        const uint64_t before = clq_crowd_fingerprint(crowd_);
        EXPECT_EQ(restore(crowd_, bytes), status) << sentence;
        EXPECT_NE(std::string(clq_last_error()).find(sentence), std::string::npos) << clq_last_error();
        EXPECT_EQ(clq_crowd_fingerprint(crowd_), before) << sentence;
    }

    Stage stage_;
    clq_crowd *crowd_;
    std::vector<clq_actor> actors_;
};

double slope(void *, const double point[3]) { return 0.1 * point[0]; }

}  // namespace

TEST_F(Save, a_fresh_crowd_restored_goes_on_as_the_saved_one)
{
    const Bytes bytes = saved::save(crowd_);
    clq_crowd *fresh = stage_.new_crowd();
    stage_.set_up(fresh);
    ASSERT_EQ(restore(fresh, bytes), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_crowd_fingerprint(fresh), clq_crowd_fingerprint(crowd_));
    EXPECT_EQ(clq_crowd_actor_count(fresh), clq_crowd_actor_count(crowd_));
    EXPECT_EQ(saved::save(fresh), bytes);
    const std::vector<uint64_t> shown = story(crowd_, actors_, 7);
    EXPECT_EQ(story(fresh, actors_, 7), shown);
    EXPECT_NE(shown[0], shown[198]) << "a picture in which nothing moves shows nothing";
    EXPECT_EQ(saved::save(fresh), saved::save(crowd_)) << "the same calls gave the same ids";
}

TEST_F(Save, a_crowd_goes_back_in_time_and_shows_the_same_again)
{
    clq_view *view = stage_.new_view(crowd_, 0);
    const Bytes bytes = saved::save(crowd_);
    const std::vector<uint64_t> first = story(crowd_, actors_, 7);
    for (int take = 0; take < 3; ++take) {
        // Something else in between, so that caches and lists are full of it.
        EXPECT_EQ(clq_crowd_update(crowd_, 3.02 + take, &view, 1), CLQ_OK);
        const uint64_t list = clq_view_hash(view);
        ASSERT_EQ(restore(crowd_, bytes), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_view_hash(view), list) << "lists stay until the next update";
        EXPECT_EQ(saved::save(crowd_), bytes);
        EXPECT_EQ(story(crowd_, actors_, 7), first);
    }
}

TEST_F(Save, another_crowds_state_replaces_everything_that_was_there)
{
    clq_crowd *full = other();
    const std::vector<uint64_t> shown = story(crowd_, actors_, 7);
    const Bytes bytes = saved::save(crowd_);
    story(full, stage_.fill(full, 60, 3), 9);
    ASSERT_EQ(restore(full, bytes), CLQ_OK) << clq_last_error();
    EXPECT_EQ(saved::save(full), bytes);
    clq_view *views[2] = {stage_.new_view(crowd_, 0), stage_.new_view(full, 0)};
    for (int frame = 0; frame < 20; ++frame) {
        ASSERT_EQ(clq_crowd_update(crowd_, 9 + 0.1 * frame, &views[0], 1), CLQ_OK);
        ASSERT_EQ(clq_crowd_update(full, 9 + 0.1 * frame, &views[1], 1), CLQ_OK);
        ASSERT_EQ(clq_view_hash(views[1]), clq_view_hash(views[0])) << frame;
    }
}

TEST_F(Save, ids_are_valid_again_and_stale_where_they_were_stale)
{
    const clq_actor gone = actors_[3];
    ASSERT_EQ(clq_actor_destroy(crowd_, gone), CLQ_OK);
    clq_attached object, lost;
    const float centre[3] = {0, 0, 0};
    ASSERT_EQ(clq_actor_attach(crowd_, actors_[4], 0, centre, 1, &lost), CLQ_OK);
    ASSERT_EQ(clq_actor_detach(crowd_, lost), CLQ_OK);
    ASSERT_EQ(clq_actor_attach(crowd_, actors_[4], 0, centre, 9, &object), CLQ_OK);
    clq_actor_info before, after;
    ASSERT_EQ(clq_actor_get_info(crowd_, actors_[4], &before), CLQ_OK);
    const Bytes bytes = saved::save(crowd_);
    clq_crowd *crowd = other();
    ASSERT_EQ(restore(crowd, bytes), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_actor_destroy(crowd, gone), CLQ_STALE_ID);
    EXPECT_EQ(clq_actor_detach(crowd, lost), CLQ_STALE_ID);
    ASSERT_EQ(clq_actor_get_info(crowd, actors_[4], &after), CLQ_OK);
    EXPECT_EQ(after.sklsroot_radius, before.sklsroot_radius);
    EXPECT_EQ(after.refpoint_radius, before.refpoint_radius);
    EXPECT_EQ(after.visible, 0) << "nobody has been seen since";
    EXPECT_EQ(clq_actor_detach(crowd, object), CLQ_OK) << clq_last_error();
    ASSERT_EQ(clq_actor_get_info(crowd, actors_[4], &after), CLQ_OK);
    EXPECT_LT(after.sklsroot_radius, before.sklsroot_radius) << "what is attached is held by its actor again";
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = stage_.templates[1];
    clq_actor next, same;
    ASSERT_EQ(clq_actor_create(crowd_, &def, &next), CLQ_OK);
    ASSERT_EQ(clq_actor_create(crowd, &def, &same), CLQ_OK);
    EXPECT_EQ(same.index1, next.index1);
    EXPECT_EQ(same.generation, next.generation);
}

TEST_F(Save, the_ground_stays_with_the_crowd)
{
    for (const clq_actor actor : actors_) ASSERT_EQ(clq_actor_follow_ground(crowd_, actor, 5, 5), CLQ_OK);
    const Bytes bytes = saved::save(crowd_);
    ASSERT_EQ(clq_crowd_set_ground(crowd_, slope, nullptr), CLQ_OK);
    EXPECT_EQ(saved::save(crowd_), bytes) << "a callback is no state";
    clq_crowd *fresh = stage_.new_crowd();
    stage_.set_up(fresh);
    ASSERT_EQ(clq_crowd_set_ground(fresh, slope, nullptr), CLQ_OK);
    ASSERT_EQ(restore(fresh, bytes), CLQ_OK) << clq_last_error();
    EXPECT_EQ(story(fresh, actors_, 3), story(crowd_, actors_, 3));
}

TEST_F(Save, host_mechanisms_are_taken_over_by_number_or_refused_by_it)
{
    const Bytes bytes = saved::save(crowd_);
    clq_crowd *bare = stage_.new_crowd();
    const uint64_t before = clq_crowd_fingerprint(bare);
    EXPECT_EQ(restore(bare, bytes), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find("mechanism 6 of the saved crowd is the host's own"), std::string::npos)
        << clq_last_error();
    EXPECT_EQ(clq_crowd_fingerprint(bare), before);

    // One with a memory where the saved one has none.
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = stage_.templates[0];
    clq_actor actor;
    ASSERT_EQ(clq_actor_create(bare, &def, &actor), CLQ_OK);
    clq_mechanism_def wanted = stage_.mechanism(Stage::host);
    wanted.host.has_memory = 1;
    clq_mechanism made;
    for (int i = 0; i < 6; ++i) ASSERT_EQ(clq_crowd_add_mechanism(bare, &wanted, &made), CLQ_OK);
    EXPECT_EQ(restore(bare, bytes), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find("mechanism 6, the host's own, keeps a memory here"), std::string::npos)
        << clq_last_error();
}

TEST_F(Save, templates_are_found_by_name_and_structure)
{
    const Bytes bytes = saved::save(crowd_);
    const auto with = [&](std::vector<clq_template *> templates) {
        return clq_crowd_restore(crowd_, bytes.data(), bytes.size(), templates.data(),
                                 static_cast<uint32_t>(templates.size()));
    };
    const auto says = [](const char *sentence) {
        return std::string(clq_last_error()).find(sentence) != std::string::npos ? "" : clq_last_error();
    };
    const uint64_t before = clq_crowd_fingerprint(crowd_);
    EXPECT_EQ(with({stage_.templates[1]}), CLQ_ARGUMENT);
    EXPECT_STREQ(says("template 'figure' of the saved crowd is not among those given"), "");
    EXPECT_EQ(with({stage_.templates[0], stage_.templates[0]}), CLQ_ARGUMENT);
    EXPECT_STREQ(says("templates 0 and 1 are the same"), "");
    EXPECT_EQ(with({stage_.templates[0], nullptr}), CLQ_ARGUMENT);
    EXPECT_STREQ(says("template 1 is NULL"), "");
    stage_.dofs[Stage::turn].last = 0.9f;
    clq_template *changed = nullptr, *foreign = nullptr, *same = nullptr;
    ASSERT_EQ(clq_template_build(stage_.context, &stage_.with_dofs.def, &changed), CLQ_OK);
    stage_.dofs[Stage::turn].last = 1;
    EXPECT_EQ(with({changed, stage_.templates[1]}), CLQ_ARGUMENT);
    EXPECT_STREQ(says("template 'figure' is not the one that the saved crowd used"), "");
    Stage abroad;
    EXPECT_EQ(with({stage_.templates[0], abroad.templates[1]}), CLQ_ARGUMENT);
    EXPECT_STREQ(says("template 1 was made from another context"), "");
    EXPECT_EQ(clq_crowd_fingerprint(crowd_), before);
    // One that was built anew serves as well, in any order, and is held.
    ASSERT_EQ(clq_template_build(stage_.context, &stage_.with_dofs.def, &same), CLQ_OK);
    EXPECT_EQ(with({changed, stage_.templates[1], same}), CLQ_OK) << clq_last_error();
    for (clq_template *tmpl : {changed, foreign, same}) clq_template_destroy(tmpl);
    EXPECT_EQ(saved::save(crowd_), bytes);
    clq_actor_info info;
    ASSERT_EQ(clq_actor_get_info(crowd_, actors_[0], &info), CLQ_OK);
    EXPECT_EQ(info.tmpl, same);
    story(crowd_, actors_, 3);
}

TEST_F(Save, bytes_that_are_cut_changed_or_of_another_version_are_refused)
{
    const Bytes bytes = saved::save(crowd_);
    refused({}, CLQ_ARGUMENT, "bytes is NULL");
    refused(Bytes(1, 'c'), CLQ_FORMAT, "1 bytes that are not a saved crowd");
    Bytes other = bytes;
    saved::put(other, 8, 2, 4);
    refused(other, CLQ_FORMAT, "a saved crowd of version 2: this library reads version 1");
    saved::put(other, 8, 0x01000000, 4);
    refused(other, CLQ_FORMAT, "version 16777216");
    other = bytes;
    other.push_back(0);
    refused(other, CLQ_FORMAT, "bytes long");
    saved::forge(other);
    refused(other, CLQ_FORMAT, "a saved crowd has 1 bytes too many");
    for (size_t size = 1; size < bytes.size(); size += size < 200 ? 1 : 97) {
        other.assign(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
        refused(other, CLQ_FORMAT, "a");
        if (size < saved::header_bytes) continue;
        saved::forge(other);
        const clq_status status = restore(crowd_, other);
        ASSERT_TRUE(status == CLQ_FORMAT || status == CLQ_ARGUMENT) << size << clq_last_error();
    }
    for (size_t at = 0; at < bytes.size(); at += 31) {
        other = bytes;
        other[at] ^= 0x10;
        refused(other, CLQ_FORMAT, "a saved crowd");
    }
    EXPECT_EQ(saved::save(crowd_), bytes);
}

TEST_F(Save, forged_bytes_are_refused_or_give_a_crowd_that_works)
{
    crowd_ = stage_.new_crowd();
    stage_.set_up(crowd_);
    actors_ = stage_.fill(crowd_, 8, 4);
    clq_view *view = stage_.new_view(crowd_, 0);
    const Bytes bytes = saved::save(crowd_);
    uint32_t taken = 0, refused_count = 0;
    for (uint32_t number = 0; number < 6000; ++number) {
        Bytes other = bytes;
        const uint64_t lot = mixed(99, number);
        const size_t at = saved::header_bytes + (lot >> 16) % (bytes.size() - saved::header_bytes);
        const uint8_t values[4] = {0, 0xff, 0x7f, static_cast<uint8_t>(lot)};
        const size_t length = 1 + lot % 4;
        for (size_t k = 0; k < length && at + k < other.size(); ++k) other[at + k] = values[(lot >> 8) % 4];
        saved::forge(other);
        const uint64_t before = clq_crowd_fingerprint(crowd_);
        const clq_status status = restore(crowd_, other);
        if (status != CLQ_OK) {
            ++refused_count;
            ASSERT_TRUE(status == CLQ_FORMAT || status == CLQ_ARGUMENT) << clq_last_error();
            ASSERT_EQ(clq_crowd_fingerprint(crowd_), before) << number << clq_last_error();
            continue;
        }
        ++taken;
        ASSERT_EQ(clq_crowd_update(crowd_, 1, &view, 1), CLQ_OK) << number << clq_last_error();
        const Bytes again = saved::save(crowd_);
        ASSERT_EQ(restore(crowd_, again), CLQ_OK) << number << clq_last_error();
        ASSERT_EQ(saved::save(crowd_), again) << number;
    }
    EXPECT_GT(taken, 100u);
    EXPECT_GT(refused_count, 100u);
}

TEST_F(Save, a_writer_that_refuses_stops_it)
{
    const auto none = [](void *, const void *, size_t) { return 1; };
    EXPECT_EQ(clq_crowd_save(crowd_, none, nullptr), CLQ_IO);
    EXPECT_NE(std::string(clq_last_error()).find("the writer refused"), std::string::npos) << clq_last_error();
    int left = 2;
    const auto few = [](void *user, const void *, size_t) { return --*static_cast<int *>(user) < 0 ? 1 : 0; };
    EXPECT_EQ(clq_crowd_save(crowd_, few, &left), CLQ_IO);
    EXPECT_EQ(left, -1) << "it is not asked again";
    EXPECT_EQ(clq_crowd_save(nullptr, few, &left), CLQ_ARGUMENT);
    EXPECT_EQ(clq_crowd_save(crowd_, nullptr, nullptr), CLQ_ARGUMENT);
    const auto meddle = [](void *user, const void *, size_t) {
        return clq_group_create(static_cast<clq_crowd *>(user), nullptr, nullptr) == CLQ_BUSY ||
                       clq_crowd_update(static_cast<clq_crowd *>(user), 0, nullptr, 0) == CLQ_BUSY
                   ? 0
                   : 1;
    };
    EXPECT_EQ(clq_crowd_save(crowd_, meddle, crowd_), CLQ_OK) << clq_last_error();
}
