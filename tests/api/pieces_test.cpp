// Actors on tracks that are made in pieces: each time is shown by its piece, whatever came before and comes after.
#include "tests/api/saved_bytes.h"
#include "tests/api/walkers.h"

using walkers::Walkers;

namespace
{

class Pieces : public Walkers
{
protected:
    // The way of track(1.2, 0, 1), in pieces of half a second.
    clq_track *piece(double end_s, const clq_track *previous)
    {
        std::vector<clq_track_point> points;
        for (int i = 0; i <= 160; ++i) {
            const double t = 0.1 * i, walked = std::min(t, 5.0) + std::max(0.0, t - 8);
            points.push_back({t, {1.2 * (walked - 6), 0, std::sin(0.8 * walked)}, NAN});
        }
        clq_track_def def = clq_track_def_init();
        def.points = points.data(), def.point_count = static_cast<uint32_t>(points.size());
        def.previous = previous, def.end_s = end_s;
        clq_track *made = nullptr;
        EXPECT_EQ(clq_track_create(locomotion_, &def, &made), CLQ_OK) << clq_last_error();
        tracks_.push_back(made);
        return made;
    }
    std::vector<clq_track *> pieces(int count)
    {
        std::vector<clq_track *> made;
        for (int k = 1; k <= count; ++k) made.push_back(piece(0.5 * k, made.empty() ? nullptr : made.back()));
        return made;
    }
    void follow(clq_crowd *crowd, clq_actor actor, clq_track *piece, double start_s = 0)
    {
        EXPECT_EQ(clq_actor_follow_track(crowd, actor, piece, start_s), CLQ_OK) << clq_last_error();
    }
    static void expect_at(clq_crowd *crowd, clq_actor actor, const clq_track *piece, double time_s)
    {
        clq_actor_info info = clq_actor_info_init();
        ASSERT_EQ(clq_actor_get_info(crowd, actor, &info), CLQ_OK);
        clq_track_state state;
        ASSERT_EQ(clq_track_evaluate(piece, time_s, &state), CLQ_OK);
        for (int k = 0; k < 3; ++k) ASSERT_NEAR(info.root.position[k], state.position[k], 1e-9) << time_s;
    }
};

}  // namespace

TEST_F(Pieces, AreShownEachAtItsTime)
{
    const std::vector<clq_track *> way = pieces(4);
    clq_crowd *crowd = this->crowd();
    const clq_actor actor = walker(crowd, way[0]);
    for (int k = 1; k < 4; ++k) follow(crowd, actor, way[k]);
    clq_view *view = this->view(crowd, 12);
    for (const double t : {1.99, 1.51, 1.5, 1.49, 0.01, 0.6, 1.2, 0.49, 1.0}) {
        ASSERT_EQ(clq_crowd_update(crowd, t, &view, 1), CLQ_OK) << clq_last_error();
        EXPECT_EQ(visible(view), 1u) << t;
        expect_at(crowd, actor, way[static_cast<size_t>(t / 0.5)], t);
    }
    for (const double t : {-0.01, 2.01}) {
        ASSERT_EQ(clq_crowd_update(crowd, t, &view, 1), CLQ_OK);
        EXPECT_EQ(visible(view), 0u) << t;
    }
}

TEST_F(Pieces, ShowTheSameWheneverTheyArrive)
{
    const std::vector<clq_track *> way = pieces(12);
    clq_crowd *early = crowd(), *late = crowd();
    const clq_actor a = walker(early, way[0]), b = walker(late, way[0]);
    for (int k = 1; k < 3; ++k) follow(early, a, way[k]);
    clq_view *ahead = view(early, 9), *behind = view(late, 9);
    int from_a = 3, from_b = 1;
    for (double t = 0.03; t < 4.9; t += 0.04) {
        if (t > 0.5 * (from_a - 2)) follow(early, a, way[static_cast<size_t>(from_a++)]);
        if (t > 0.5 * from_b) follow(late, b, way[static_cast<size_t>(from_b++)]);
        ASSERT_EQ(clq_crowd_update(early, t, &ahead, 1), CLQ_OK);
        ASSERT_EQ(clq_crowd_update(late, t, &behind, 1), CLQ_OK);
        ASSERT_EQ(clq_view_get_hash(ahead), clq_view_get_hash(behind)) << t;
    }
}

TEST_F(Pieces, EndNoLayer)
{
    const std::vector<clq_track *> way = pieces(3);
    clq_crowd *crowd = this->crowd();
    const clq_actor actor = walker(crowd, way[0]);
    clq_layer_def def = clq_layer_def_init();
    def.play.clip = clq_template_find_clip(citizen_, "applaud"), def.weight = 1;
    if (def.play.clip == CLQ_NONE) def.play.clip = clq_template_find_clip(citizen_, "stand");
    clq_layer layer;
    ASSERT_EQ(clq_actor_add_layer(crowd, actor, &def, &layer), CLQ_OK) << clq_last_error();
    follow(crowd, actor, way[1]);
    EXPECT_EQ(clq_actor_end_layer(crowd, actor, layer, 0.5, 0), CLQ_OK) << clq_last_error();
    ASSERT_EQ(clq_actor_add_layer(crowd, actor, &def, &layer), CLQ_OK) << clq_last_error();
    follow(crowd, actor, way[1]);  // begins anew: it is no continuation of itself
    EXPECT_NE(clq_actor_end_layer(crowd, actor, layer, 0.5, 0), CLQ_OK);
}

TEST_F(Pieces, ThatContinueAnotherTrackBeginAnew)
{
    const std::vector<clq_track *> way = pieces(3);
    clq_crowd *crowd = this->crowd();
    const clq_actor actor = walker(crowd, way[0]);
    clq_view *view = this->view(crowd, 12);
    follow(crowd, actor, way[2]);  // one is missing
    ASSERT_EQ(clq_crowd_update(crowd, 0.7, &view, 1), CLQ_OK);
    EXPECT_EQ(visible(view), 0u);
    follow(crowd, actor, way[0]);
    follow(crowd, actor, way[1], 0.1);  // another clock
    ASSERT_EQ(clq_crowd_update(crowd, 0.3, &view, 1), CLQ_OK);
    EXPECT_EQ(visible(view), 0u);
}

TEST_F(Pieces, GoOnFromASavedCrowd)
{
    const std::vector<clq_track *> way = pieces(12);
    clq_crowd *crowd = this->crowd(), *other = this->crowd();
    const clq_actor actor = walker(crowd, way[0]);
    for (int k = 1; k < 7; ++k) follow(crowd, actor, way[k]);
    const saved::Bytes bytes = saved::save(crowd);
    for (clq_track *piece : way) ASSERT_EQ(clq_crowd_add_track(other, piece), CLQ_OK);
    ASSERT_EQ(clq_crowd_restore(other, bytes.data(), bytes.size(), &citizen_, 1), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_crowd_get_hash(crowd), clq_crowd_get_hash(other));
    clq_view *a = view(crowd, 9), *b = view(other, 9);
    for (int k = 7; k < 12; ++k) {
        follow(crowd, actor, way[k]), follow(other, actor, way[k]);
        for (const double t : {0.5 * k - 1.4, 0.5 * k - 0.3, 0.5 * k + 0.2}) {
            ASSERT_EQ(clq_crowd_update(crowd, t, &a, 1), CLQ_OK);
            ASSERT_EQ(clq_crowd_update(other, t, &b, 1), CLQ_OK);
            ASSERT_EQ(visible(a), 1u) << t;
            ASSERT_EQ(clq_view_get_hash(a), clq_view_get_hash(b)) << t;
        }
    }
}

TEST_F(Pieces, AreLetGoOfOnceNoActorFollowsThem)
{
    const std::vector<clq_track *> way = pieces(20);
    clq_crowd *crowd = this->crowd();
    const clq_actor actor = walker(crowd, way[0]);
    for (int k = 1; k < 20; ++k) follow(crowd, actor, way[k]);
    uint32_t released = 0;
    ASSERT_EQ(clq_crowd_release_tracks(crowd, &released), CLQ_OK) << clq_last_error();
    EXPECT_EQ(released, 20u - CLQ_TRACK_PIECES);
    ASSERT_EQ(clq_crowd_release_tracks(crowd, &released), CLQ_OK);
    EXPECT_EQ(released, 0u);
    clq_view *view = this->view(crowd, 12);
    ASSERT_EQ(clq_crowd_update(crowd, 9.3, &view, 1), CLQ_OK);
    expect_at(crowd, actor, way[18], 9.3);
    ASSERT_EQ(clq_actor_leave_track(crowd, actor, 9.5), CLQ_OK);
    ASSERT_EQ(clq_crowd_release_tracks(crowd, nullptr), CLQ_OK);
    ASSERT_EQ(clq_crowd_release_tracks(crowd, &released), CLQ_OK);
    EXPECT_EQ(released, 0u);
    EXPECT_EQ(clq_crowd_release_tracks(nullptr, nullptr), CLQ_ARGUMENT);
}
