// Roles: layers stay within their masks, a gaze meets its target, mouths move with phrases, and so on.
#include <cmath>

#include <gtest/gtest.h>

#include "samples/scenes/roles/performer.h"

namespace
{

using namespace scenes;
using namespace scenes::roles;

using Matrix16 = std::array<double, 16>;

class Roles : public testing::Test
{
protected:
    Roles() : library_(1) {}

    void enter(const char *character, const char *clip)
    {
        performer_.reset();
        tmpl_ = library_.builtin(character);
        clq_crowd *made = nullptr;
        check(clq_crowd_create(library_.context(), nullptr, &made));
        crowd_.reset(made);
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = tmpl_, def.transform = stand(1, 0, 2, 0, 1, 1), def.seed = 5;
        def.play.clip = clq_template_find_clip(tmpl_, clip);
        check(clq_actor_create(made, &def, &actor_));
        kit_ = std::make_unique<Kit>(library_, made, tmpl_);
        performer_ = std::make_unique<Performer>(made, actor_, *kit_, present_role(made, actor_));
        role_ = performer_->given();
    }
    Matrix16 node(const char *name, double time_s)
    {
        performer_->perform(role_, time_s);
        Matrix16 m;
        check(clq_actor_get_node(crowd_.get(), actor_, clq_template_find_node(tmpl_, name), time_s, m.data()));
        return m;
    }
    std::string refusal(double time_s = 1)
    {
        try {
            performer_->perform(role_, time_s);
        } catch (const Failure &failure) {
            return failure.what();
        }
        return "";
    }
    static double apart(const Matrix16 &a, const Matrix16 &b)
    {
        return std::hypot(a[12] - b[12], a[13] - b[13], a[14] - b[14]);
    }

    Library library_;
    clq_template *tmpl_ = nullptr;
    std::unique_ptr<Kit> kit_;
    Own<clq_crowd> crowd_;
    clq_actor actor_ = {};
    std::unique_ptr<Performer> performer_;
    Role role_ = {};
};

TEST_F(Roles, LayersMoveTheJointsOfTheirMaskAlone)
{
    enter("citizen", "stand");
    const char *const joints[] = {"hand_l", "hand_r", "head", "toes_l", "pelvis"};
    std::map<std::string, Matrix16> before;
    for (const char *joint : joints) before[joint] = node(joint, 1.3);
    Layer layer;
    layer.clip.name = "cheer", layer.joint = "upper_arm_r";
    role_.motion.layers = {layer};
    for (const char *joint : joints) {
        if (std::string(joint) == "hand_r") EXPECT_GT(apart(node(joint, 1.3), before[joint]), 0.05);
        else EXPECT_LT(apart(node(joint, 1.3), before[joint]), 1e-6) << joint;
    }
    role_.motion.layers[0].inverted = true;
    EXPECT_GT(apart(node("hand_l", 1.3), before["hand_l"]), 0.05);
    role_.motion.layers[0].joint.clear();
    const double whole = apart(node("hand_r", 1.3), before["hand_r"]);
    role_.motion.layers[0].weight = 0.5f;
    const double half = apart(node("hand_r", 1.3), before["hand_r"]);
    EXPECT_LT(half, whole);
    EXPECT_GT(half, 0.01);
    role_.motion.layers.clear();
    for (const char *joint : joints) EXPECT_EQ(node(joint, 1.3), before[joint]) << joint;
    role_.motion.layers.resize(1);
    role_.motion.layers[0].clip.name = "fly";
    EXPECT_EQ(refusal().rfind("citizen has no clip 'fly'; there are: stand, walk, ", 0), 0u) << refusal();
    role_.motion.layers[0] = layer, role_.motion.layers[0].joint = "wing";
    EXPECT_EQ(refusal().rfind("citizen has no joint 'wing'; there are: root, pelvis, ", 0), 0u) << refusal();
}

TEST_F(Roles, LayersStayOnTheTreadmill)
{
    enter("citizen", "stand");
    role_.motion.treadmill_m_s = 1.4;
    const Matrix16 hand = node("hand_r", 80), toes = node("toes_l", 80);
    Layer layer;
    layer.clip.name = "cheer", layer.joint = "upper_arm_r";
    role_.motion.layers = {layer};
    EXPECT_GT(apart(node("hand_r", 80), hand), 0.05);
    EXPECT_LT(apart(node("toes_l", 80), toes), 1e-6);
    node("hand_r", 10);  // another lap
    EXPECT_GT(apart(node("hand_r", 80), hand), 0.05);
}

// The angle between where an eye looks, its +z, and the target.
double miss_deg(const Matrix16 &eye, const std::array<double, 3> &target)
{
    double to[3], dot = 0, length = 0, axis = 0;
    for (size_t k = 0; k < 3; ++k) {
        to[k] = target[k] - eye[12 + k];
        dot += to[k] * eye[8 + k], length += to[k] * to[k], axis += eye[8 + k] * eye[8 + k];
    }
    return std::acos(std::min(1.0, dot / std::sqrt(length * axis))) * 57.29578;
}

TEST_F(Roles, GazesMeetTheirTarget)
{
    for (const char *character : {"herald", "owl"}) {
        enter(character, "hover");
        const std::array<double, 3> ahead = {1, 1, 12};
        const double own = miss_deg(node("eye_left", 5), ahead);
        role_.face.looks = true;
        for (const std::array<double, 3> target : {std::array<double, 3>{1.6, 1.2, 5}, {0.2, 0.9, 6}, {1.2, 0.2, 7}}) {
            role_.face.target = target, role_.face.target_at_s = 1;
            EXPECT_LT(miss_deg(node("eye_left", 5), target), 9) << character << ", without it " << own;
        }
    }
}

TEST_F(Roles, PhrasesMoveTheMouthAndEnd)
{
    enter("herald", "hover");
    const auto jaw = [&](double t) {
        const Matrix16 m = node("jaw", t), h = node("head", t);
        double dot = 0;
        for (size_t k = 0; k < 3; ++k) dot += m[8 + k] * h[8 + k];
        return dot;  // 1: shut
    };
    const double shut = jaw(2);
    role_.face.phrase = "salve", role_.face.phrase_at_s = 2;
    double widest = 1;
    for (double t = 2; t < 2.5; t += 0.02) widest = std::min(widest, jaw(t));
    EXPECT_LT(widest, shut - 0.02);
    EXPECT_NEAR(jaw(1.9), shut, 1e-6);
    EXPECT_NEAR(jaw(3.2), shut, 1e-6);
    role_.face.phrase = "mm";
    EXPECT_NEAR(jaw(2.1), shut, 1e-6) << "lips are shut";
}

TEST_F(Roles, EyesBlinkAndFacesChange)
{
    enter("owl", "hover");
    const auto changes = [&](const char *joint, double until_s) {
        const Matrix16 first = node(joint, 0), head = node("head", 0);
        double most = 0;
        for (double t = 0; t < until_s; t += 0.05) {
            const Matrix16 m = node(joint, t), h = node("head", t);
            double a = 0, b = 0;
            for (size_t k = 0; k < 3; ++k) a += m[4 + k] * h[4 + k], b += first[4 + k] * head[4 + k];
            most = std::max(most, std::fabs(a - b));
        }
        return most;
    };
    EXPECT_LT(changes("lids", 10), 1e-6);
    role_.face.blinks = true;
    EXPECT_GT(changes("lids", 10), 0.05);
    role_.face.blinks = false;
    EXPECT_LT(changes("lids", 10), 1e-6);
    const Matrix16 before = node("brow", 6);
    role_.face.expresses = true, role_.face.expression = "raised", role_.face.expression_at_s = 1;
    EXPECT_GT(apart(node("brow", 6), before), 0.002);
    role_.face.expression = "scowl";
    EXPECT_EQ(refusal(), "owl has no expression 'scowl'; there are: at rest, raised, lowered, aslant");
    role_.face.expression = "raisd";
    EXPECT_EQ(refusal(), "owl has no expression 'raisd': 'raised' is near");
    role_.face = {};
    role_.dofs["browe"] = 0;
    EXPECT_NE(refusal().find("owl has no degree of freedom 'browe': 'brow'"), std::string::npos) << refusal();
    role_.dofs.clear();
    role_.face = {};
    EXPECT_EQ(node("brow", 6), before);
    enter("citizen", "stand");
    role_.face.looks = true;
    EXPECT_EQ(refusal(), "citizen has no degrees of freedom to look with");
}

TEST_F(Roles, FlightsPassTheirCornersAtTheirSpeed)
{
    enter("owl", "fly");
    role_.flight.corners = {4, 3, 2, 4, 3, -2, -4, 3, -2, -4, 5, 2};
    role_.flight.speed_m_s = 4;
    double nearest[4] = {9, 9, 9, 9}, length = 0;
    const double around = 4 + 8 + std::hypot(2, 4) + std::hypot(8, 2);
    Matrix16 last = node("body", 0);
    const Matrix16 first = last;
    for (double t = 0.02; t <= around / 4 + 1e-9; t += 0.02) {
        const Matrix16 at = node("body", t);
        length += apart(at, last);
        last = at;
        for (size_t corner = 0; corner < 4; ++corner) {
            const double *c = role_.flight.corners.data() + 3 * corner;
            nearest[corner] = std::min(nearest[corner], std::hypot(at[12] - c[0], at[13] - c[1], at[14] - c[2]));
        }
    }
    for (const double one : nearest) EXPECT_LT(one, 0.5);  // the body hovers about its root
    EXPECT_NEAR(length / (around / 4), 4, 1.2);
    EXPECT_LT(apart(last, first), 0.3);
    role_.flight = {};
    EXPECT_LT(apart(node("body", 1), first), 9);
    EXPECT_NEAR(node("body", 1)[12], 1, 0.2);
}

TEST_F(Roles, SpeedsOfAFlightThatAreDraggedLeaveNothingBehind)
{
    enter("owl", "fly");
    role_.flight.corners = {4, 3, 2, 4, 3, -2, -4, 3, -2};
    const auto drag = [&] {
        for (int step = 0; step < 50; ++step) {
            role_.flight.speed_m_s = 2 + 0.05 * step;
            performer_->perform(role_, 0);
        }
        size_t bytes = 0;
        const auto count = [](void *user, const void *, size_t size) -> int {
            *static_cast<size_t *>(user) += size;
            return 0;
        };
        check(clq_crowd_save(crowd_.get(), count, &bytes));
        return bytes;
    };
    const size_t once = drag();
    EXPECT_EQ(drag(), once);
}

TEST_F(Roles, ObjectsGrowTheSpheresOfThoseThatCarryThem)
{
    enter("citizen", "stand");
    clq_actor_info before = clq_actor_info_init(), after = clq_actor_info_init();
    check(clq_actor_get_info(crowd_.get(), actor_, &before));
    role_.load = {{"hand_r", "staff"}};
    performer_->perform(role_, 0);
    check(clq_actor_get_info(crowd_.get(), actor_, &after));
    EXPECT_GT(after.sklsroot_radius, before.sklsroot_radius + 0.1f);
    role_.load = {{"hand_r", "spear"}};
    EXPECT_EQ(refusal(), "there is no object 'spear' to carry");
    role_.load.clear();
    performer_->perform(role_, 0);
    check(clq_actor_get_info(crowd_.get(), actor_, &after));
    EXPECT_EQ(after.sklsroot_radius, before.sklsroot_radius);
}

TEST_F(Roles, MechanismsOfSharedObjectsAreRefusedInOneSentence)
{
    enter("herald", "hover");
    role_.mechanism = MechanismFile("/", CLAQUE_LIBRARY);
    EXPECT_EQ(refusal(), "the mechanism " + MechanismFile("/", CLAQUE_LIBRARY).path() +
                             " exports no function claque_mechanism_v1 (samples/scenes/roles/mechanism.h)");
    EXPECT_TRUE(performer_->given().mechanism.empty());
    role_.mechanism = MechanismFile("/", CLAQUE_NOD);
    EXPECT_EQ(refusal(), "");
    EXPECT_STREQ(kit_->own_name(MechanismFile("/", CLAQUE_NOD)), "nod");
    enter("citizen", "stand");
    role_.mechanism = MechanismFile("/", CLAQUE_NOD);
    EXPECT_EQ(refusal(), "the mechanism " + MechanismFile("/", CLAQUE_NOD).path() +
                             " nods with neck_pitch or head.pitch, and this character has neither");
}

TEST_F(Roles, MechanismsOfSharedObjectsMoveTheCharacter)
{
    enter("herald", "hover");
    const auto shown = [&](double time_s) {
        performer_->perform(role_, time_s);
        clq_view *view = nullptr;
        check(clq_view_create(crowd_.get(), &view));
        clq_look_at_def look = clq_look_at_def_init();
        look.eye[0] = 1, look.eye[1] = 1, look.eye[2] = 7, look.target[0] = 1, look.target[2] = 2;
        clq_camera camera = {};
        check(clq_camera_look_at(&look, &camera));
        check(clq_view_set_camera(view, &camera));
        check(clq_crowd_update(crowd_.get(), time_s, &view, 1));
        const uint64_t hash = clq_view_get_hash(view);
        check(clq_view_destroy(view));
        return hash;
    };
    const uint64_t before = shown(1.2);
    role_.mechanism = MechanismFile("/", CLAQUE_NOD);
    const uint64_t nods = shown(1.2);
    EXPECT_NE(nods, before);
    EXPECT_NE(shown(1.5), nods);
    EXPECT_EQ(shown(1.2), nods) << "a function of the time";
    role_.mechanism = {};
    EXPECT_EQ(shown(1.2), before);
}

}  // namespace
