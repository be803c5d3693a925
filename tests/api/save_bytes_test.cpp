// Invalid saved crowds: cut, changed, of another version, forged.
#include "tests/api/save_fixture.h"

namespace
{

using saved::Bytes;

class SaveBytes : public SaveFixture
{
};

}  // namespace

TEST_F(SaveBytes, BytesThatAreCutChangedOrOfAnotherVersionAreRefused)
{
    const Bytes bytes = saved::save(crowd_);
    refused({}, CLQ_ARGUMENT, "bytes is NULL");
    refused(Bytes(1, 'c'), CLQ_FORMAT, "1 bytes that are not a saved crowd");
    Bytes other = bytes;
    saved::put(other, 8, 2, 4);
    refused(other, CLQ_FORMAT, "a saved crowd of version 2: this library reads version 6");
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

TEST_F(SaveBytes, ForgedBytesAreRefusedOrGiveACrowdThatWorks)
{
    crowd_ = test_world_.new_crowd();
    test_world_.set_up(crowd_);
    actors_ = test_world_.fill(crowd_, 3, 4);
    const clq_transform in_front = {{0, 1, -8}, {0, 0, 0, 1}, 1};
    ASSERT_EQ(clq_crowd_set_transforms(crowd_, actors_.data(), &in_front, 1), CLQ_OK);
    for (uint32_t kind = TestWorld::gaze; kind <= TestWorld::host; ++kind) {
        const clq_mechanism_attachment use = {{kind + 1}, 1, 0, 0};
        ASSERT_EQ(clq_actor_attach_mechanism(crowd_, actors_[0], &use), CLQ_OK) << clq_last_error();
    }
    const double point[3] = {3, 1, 2};
    ASSERT_EQ(clq_actor_gaze(crowd_, actors_[0], {TestWorld::gaze + 1}, point, 0.5), CLQ_OK);
    ASSERT_EQ(clq_actor_express(crowd_, actors_[0], {TestWorld::expression + 1}, 0, 0.5), CLQ_OK);
    ASSERT_EQ(clq_actor_express(crowd_, actors_[0], {TestWorld::expression + 1}, 1, 0.9), CLQ_OK);
    ASSERT_EQ(clq_actor_say(crowd_, actors_[0], {TestWorld::phrase + 1}, 0.5), CLQ_OK);
    clq_view *view = test_world_.new_view(crowd_, 0);
    const Bytes bytes = saved::save(crowd_);
    uint32_t taken = 0, refused_count = 0;
    for (size_t at = saved::header_bytes; at < bytes.size(); ++at)
        for (const uint8_t value : {0x00, 0x01, 0x7f, 0x80, 0xff}) {
            Bytes other = bytes;
            if (other[at] == value) continue;
            other[at] = value;
            saved::forge(other);
            const uint64_t before = clq_crowd_get_hash(crowd_);
            const clq_status status = restore(crowd_, other);
            if (status != CLQ_OK) {
                ++refused_count;
                ASSERT_TRUE(status == CLQ_FORMAT || status == CLQ_ARGUMENT) << clq_last_error();
                ASSERT_EQ(clq_crowd_get_hash(crowd_), before) << at << clq_last_error();
                continue;
            }
            ++taken;
            ASSERT_EQ(saved::save(crowd_), other) << at;
            for (const double time_s : {0.6, 0.95})
                ASSERT_EQ(clq_crowd_update(crowd_, time_s, &view, 1), CLQ_OK) << at << clq_last_error();
            const Bytes again = saved::save(crowd_);
            ASSERT_EQ(restore(crowd_, again), CLQ_OK) << at << clq_last_error();
            ASSERT_EQ(saved::save(crowd_), again) << at;
        }
    EXPECT_GT(taken, 1000u);
    EXPECT_GT(refused_count, 1000u);
}
