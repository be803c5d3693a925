// The treadmill: the person stays where it is, the ground goes with its feet, and the feet do not slide.
#include <cmath>

#include <gtest/gtest.h>

#include "samples/scenes/roles/performer.h"

namespace
{

using namespace scenes;
using namespace scenes::roles;

class Treadmills : public testing::Test
{
protected:
    Treadmills() : library_(1), tmpl_(library_.builtin("citizen"))
    {
        clq_crowd *made = nullptr;
        check(clq_crowd_create(library_.context(), nullptr, &made));
        crowd_.reset(made);
        check(clq_view_create(made, &view_));
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = tmpl_, def.transform = stand(3, 0.5, -2, 1, 0.4, 1);
        def.play.clip = clq_template_find_clip(tmpl_, "stand");
        check(clq_actor_create(made, &def, &actor_));
        kit_ = std::make_unique<Kit>(library_, made, tmpl_);
        performer_ = std::make_unique<Performer>(made, actor_, *kit_, present_role(made, actor_));
    }

    Treadmill &walk(double speed_m_s, double time_s = 0)
    {
        role_.motion.treadmill_m_s = speed_m_s;
        performer_->perform(role_, time_s);
        return *performer_->treadmill();
    }
    std::array<double, 3> root(double time_s)
    {
        performer_->perform(role_, time_s);
        clq_look_at_def look = clq_look_at_def_init();
        look.eye[0] = 3, look.eye[1] = 1.5, look.eye[2] = 6, look.target[0] = 3, look.target[1] = 1;
        clq_camera camera = {};
        check(clq_camera_look_at(&look, &camera));
        check(clq_view_set_camera(view_, &camera));
        check(clq_crowd_update(crowd_.get(), time_s, &view_, 1));
        clq_actor_info info = clq_actor_info_init();
        check(clq_actor_get_info(crowd_.get(), actor_, &info));
        EXPECT_TRUE(info.visible);
        return {info.root.position[0], info.root.position[1], info.root.position[2]};
    }
    std::array<double, 3> node(const char *name, double time_s)
    {
        performer_->perform(role_, time_s);
        double m[16];
        check(clq_actor_get_node(crowd_.get(), actor_, clq_template_find_node(tmpl_, name), time_s, m));
        return {m[12], m[13], m[14]};
    }
    // Along the person's heading.
    static double ahead(const std::array<double, 3> &from, const std::array<double, 3> &to)
    {
        const double length = std::hypot(1.0, 0.4);
        return ((to[0] - from[0]) + 0.4 * (to[2] - from[2])) / length;
    }

    Library library_;
    clq_template *tmpl_;
    std::unique_ptr<Kit> kit_;
    Own<clq_crowd> crowd_;
    clq_view *view_ = nullptr;
    clq_actor actor_ = {};
    std::unique_ptr<Performer> performer_;
    Role role_ = {};
};

TEST_F(Treadmills, KeepThePersonOnTheSpotAtAnySpeed)
{
    role_ = performer_->given();
    for (const double speed : {0.0, 0.1, 0.5, 1.4, 2.6, 4.5}) {
        walk(speed);
        for (double t = 0.3; t < 140; t += 9.7) {
            const std::array<double, 3> at = root(t);
            EXPECT_NEAR(at[0], 3, 0.002) << speed << " m/s at " << t;
            EXPECT_NEAR(at[1], 0.5, 1e-6) << speed << " m/s at " << t;
            EXPECT_NEAR(at[2], -2, 0.002) << speed << " m/s at " << t;
        }
    }
}

TEST_F(Treadmills, MoveTheGroundAsFastAsThePersonWalks)
{
    role_ = performer_->given();
    for (const double speed : {0.6, 1.4, 3.0}) {
        const Treadmill &treadmill = walk(speed);
        EXPECT_NEAR(treadmill.ground_m(90) - treadmill.ground_m(0), 90 * speed, 0.02 * 90 * speed);
        EXPECT_NEAR(treadmill.ground_m(0), 0, 0.001);
    }
}

TEST_F(Treadmills, TakeTheFootThatStandsAlongWithTheGround)
{
    role_ = performer_->given();
    const Treadmill &treadmill = walk(1.4);
    int stood = 0;
    for (double t = 10; t < 13; t += 0.04) {
        const std::array<double, 3> toes = node("toes_l", t), later = node("toes_l", t + 0.04);
        const double ground = treadmill.ground_m(t + 0.04) - treadmill.ground_m(t);
        if (toes[1] > 0.5 + 0.03 || later[1] > 0.5 + 0.03) continue;
        if (std::fabs(toes[1] - later[1]) > 0.0005) continue;  // it comes down or leaves
        EXPECT_NEAR(ahead(toes, later), -ground, 0.004) << t;
        ++stood;
    }
    EXPECT_GT(stood, 15);
}

TEST_F(Treadmills, HoldFeetByTheFootLaw)
{
    role_ = performer_->given();
    for (const double speed : {0.8, 1.4, 2.0, 3.5}) {
        const FootDrift &drift = walk(speed).drift();
        EXPECT_GT(drift.steps, 8u) << speed;
        EXPECT_GT(drift.most_mm, 0) << speed;
        EXPECT_LT(drift.most_mm, 20) << speed;
        EXPECT_LE(drift.mean_mm, drift.most_mm) << speed;
        RecordProperty("drift_mm_at_" + std::to_string(speed), std::to_string(drift.most_mm));
    }
}

TEST_F(Treadmills, JoinTheirLapsWithoutAJump)
{
    role_ = performer_->given();
    const Treadmill &treadmill = walk(1.4);
    double end = 0;
    while (treadmill.lap_at(end) == 0) end += 0.01;
    for (const char *name : {"head", "hand_l", "toes_r", "toes_l"}) {
        const std::array<double, 3> before = node(name, end - 0.02), after = node(name, end + 0.02);
        const std::array<double, 3> first = node(name, end - 0.06);
        const auto apart = [](const auto &a, const auto &b) {
            return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
        };
        EXPECT_LT(apart(before, after), apart(first, before) * 1.5 + 0.012) << name;
    }
    EXPECT_NEAR(treadmill.ground_m(end + 0.02) - treadmill.ground_m(end - 0.02), 0.04 * 1.4, 0.01);
}

TEST_F(Treadmills, LetThePersonGoBackToItsClip)
{
    role_ = performer_->given();
    const std::array<double, 3> before = node("hand_l", 2.5);
    walk(2);
    const std::array<double, 3> walking = node("hand_l", 2.5);
    role_.motion.treadmill_m_s.reset();
    const std::array<double, 3> after = node("hand_l", 2.5);
    EXPECT_GT(std::hypot(before[0] - walking[0], before[1] - walking[1], before[2] - walking[2]), 0.01);
    for (size_t k = 0; k < 3; ++k) EXPECT_EQ(after[k], before[k]);
}

TEST_F(Treadmills, RefuseCharactersThatCannotWalk)
{
    clq_template *owl = library_.builtin("owl");
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = owl;
    clq_actor actor = {};
    check(clq_actor_create(crowd_.get(), &def, &actor));
    Kit kit(library_, crowd_.get(), owl);
    Performer performer(crowd_.get(), actor, kit, present_role(crowd_.get(), actor));
    Role role = performer.given();
    role.motion.treadmill_m_s = 1;
    try {
        performer.perform(role, 0);
        FAIL() << "an owl walks";
    } catch (const Failure &failure) {
        EXPECT_EQ(std::string(failure.what())
                      .rfind("the character owl has no clip named walk; it has: fly, glide, hover;", 0),
                  0u)
            << failure.what();
    }
    EXPECT_FALSE(performer.given().motion.treadmill_m_s);
}

}  // namespace
