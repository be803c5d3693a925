// Tracks as bytes: what was saved comes back, and anything else is refused.
#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/track/track_file.h"
#include "tests/unit/track/made_tracks.h"

using namespace claque;

namespace
{

using Bytes = track::Array<uint8_t>;

Bytes saved()
{
    Bytes bytes;
    track::save(*test::track_of(test::ways()[8].points), bytes);
    return bytes;
}

track::Track loaded(const Bytes &bytes, const char *figure = "citizen")
{
    track::Track out(std::pmr::get_default_resource());
    track::load(bytes.data(), bytes.size(), test::locomotion_of(figure), out);
    return out;
}

clq_status status_of(const Bytes &bytes, const char *figure = "citizen")
{
    try {
        loaded(bytes, figure);
        return CLQ_OK;
    } catch (const base::Error &error) {
        return error.status();
    }
}

// The hash of the contents made right again, so that only the reader's own checks are left.
Bytes forged(Bytes bytes)
{
    uint64_t h = 0xcbf29ce484222325u;
    for (size_t i = 32; i < bytes.size(); ++i) h = (h ^ bytes[i]) * 0x100000001b3u;
    for (int i = 0; i < 8; ++i) bytes[24 + i] = uint8_t(h >> 8 * i);
    return bytes;
}

}  // namespace

TEST(TrackFile, GivesBackTheSameTrack)
{
    const auto made = test::track_of(test::ways()[8].points);
    const track::Track back = loaded(saved());
    EXPECT_EQ(back.hash, made->hash);
    for (double t = 0; t < made->length_s; t += 0.11) {
        const track::State a = track::state_at(*made, t), b = track::state_at(back, t);
        ASSERT_EQ(a.position, b.position);
        ASSERT_EQ(a.phase, b.phase);
        const pose::FootTarget x = track::foot_at(*made, a, 0, t), y = track::foot_at(back, b, 0, t);
        ASSERT_EQ(x.x, y.x);
        ASSERT_EQ(x.planted, y.planted);
    }
    Bytes again;
    track::save(back, again);
    EXPECT_EQ(again, saved());
}

TEST(TrackFile, CutOffIsRefusedWhereverItEnds)
{
    const Bytes whole = saved();
    for (size_t size = 0; size < whole.size(); size += size < 200 ? 1 : 97) {
        const Bytes cut(whole.begin(), whole.begin() + static_cast<ptrdiff_t>(size));
        ASSERT_EQ(status_of(cut), CLQ_FORMAT) << size;
    }
}

TEST(TrackFile, ChangedIsRefused)
{
    const Bytes whole = saved();
    for (size_t at = 0; at < whole.size(); at += at < 200 ? 1 : 61) {
        Bytes changed = whole;
        changed[at] ^= 0x41;
        ASSERT_EQ(status_of(changed), CLQ_FORMAT) << at;
    }
}

TEST(TrackFile, ChangedWithAForgedHashIsRefusedOrSafe)
{
    const Bytes whole = saved();
    int refused = 0;
    for (size_t at = 40; at < whole.size(); at += at < 400 ? 1 : 53)
        for (const uint8_t bits : {0xff, 0x80, 0x01}) {
            Bytes changed = whole;
            changed[at] ^= bits;
            try {
                const track::Track track = loaded(forged(changed));
                for (double t = -3; t < 40; t += 1.7) {
                    const track::State state = track::state_at(track, t);
                    for (int f = 0; f < 2; ++f) track::foot_at(track, state, f, t);
                }
            } catch (const base::Error &error) {
                ++refused;
                EXPECT_EQ(error.status(), CLQ_FORMAT);
            }
        }
    EXPECT_GT(refused, 50);
}

TEST(TrackFile, OfAnotherLocomotionIsRefusedByName)
{
    Bytes bytes = saved();
    bytes[32] ^= 1;  // of the locomotion's hash
    EXPECT_EQ(status_of(forged(bytes)), CLQ_ARGUMENT);
}
