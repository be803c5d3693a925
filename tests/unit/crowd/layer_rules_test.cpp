// The rules of plays, gaits, fades and layers, each on both sides of its bound; and gaits whose phase is the integral
// of their pace.
#include "lib/crowd/layer_rules.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/crowd/edits.h"
#include "lib/crowd/gait.h"
#include "tests/law/support/figure.h"

namespace claque::crowd
{

using namespace testing_support;

namespace
{

constexpr float no_number = std::numeric_limits<float>::quiet_NaN(), endless = std::numeric_limits<float>::infinity();

class LayerRules : public ::testing::Test
{
protected:
    LayerRules() : figure_(make_figure()), other_(make_figure()), crowd_(std::pmr::get_default_resource(), 7)
    {
        create(crowd_, *figure_, Transform(), Play(), 1);
        create(crowd_, *other_, Transform(), Play(), 1);
        for (const model::Template *tmpl : {figure_.get(), other_.get()}) {
            Gait gait(std::pmr::get_default_resource());
            gait.tmpl = tmpl, gait.clip_a = clip_walk, gait.clip_b = clip_sway;
            crowd_.layers().add(std::move(gait));
            MaskOf mask;
            mask.tmpl = tmpl;
            mask.weights = std::make_shared<const Array<float>>(tmpl->rig.node_count(), 0.5f);
            crowd_.layers().add(std::move(mask));
        }
        state_.now = of_gait(0);
        state_.fade_count = 2, state_.layer_count = 2;
        for (uint32_t k = 0; k < 2; ++k) {
            state_.fades[k].from.play.clip = k, state_.fades[k].at_s = 1 + k, state_.fades[k].length_s = 0.5f;
            state_.layers[k].play.clip = clip_sway, state_.layers[k].additive = k == 1;
        }
    }
    Source of_gait(uint32_t gait) const
    {
        Source out;
        out.gait = gait, out.play.clip = clip_walk;
        return out;
    }
    using Change = std::function<void(LayerState &)>;
    // The refusal of a changed state; "" if it is taken.
    std::string said(const Change &change) const
    {
        LayerState changed = state_;
        change(changed);
        try {
            check_layering(crowd_, 0, changed);
            return "";
        } catch (const base::Error &error) {
            return error.what();
        }
    }
    void takes(const Change &change, int line) const { EXPECT_EQ(said(change), "") << "line " << line; }
    void refuses(const char *why, const Change &change, int line) const
    {
        EXPECT_NE(said(change).find(why), std::string::npos) << "line " << line << ": '" << said(change) << "'";
    }
    template <class Get>
    void range(const char *why, const Get &get, const std::vector<double> &in, const std::vector<double> &out, int line)
    {
        using Number = std::remove_reference_t<decltype(get(state_))>;
        for (const double x : in) takes([&](LayerState &s) { get(s) = static_cast<Number>(x); }, line);
        for (const double x : out) {
            const Change change = [&](LayerState &s) { get(s) = static_cast<Number>(x); };
            refuses(why, change, line);
        }
    }

    std::unique_ptr<model::Template> figure_, other_;
    Crowd crowd_;
    LayerState state_;
};

#define TAKES(...) takes([&]([[maybe_unused]] LayerState &s) { __VA_ARGS__; }, __LINE__)
#define REFUSES(why, ...) \
    refuses(              \
        why, [&](LayerState &s) { __VA_ARGS__; }, __LINE__)
#define RANGE(why, get, ...) \
    range(                   \
        why, [&](LayerState & s) -> auto & { return get; }, __VA_ARGS__, __LINE__)

}  // namespace

TEST_F(LayerRules, OfPlaysInEachPlace)
{
    const double clips = double(figure_->rig.clips.size());
    TAKES();
    const std::vector<std::function<Play &(LayerState &)>> plays = {
        [](LayerState &s) -> Play & { return s.fades[0].from.play; },
        [](LayerState &s) -> Play & { return s.fades[1].from.play; },
        [](LayerState &s) -> Play & { return s.layers[0].play; },
        [](LayerState &s) -> Play & { return s.layers[1].play; }};
    for (const auto &play : plays) {
        RANGE("does not exist", play(s).clip, {clips - 1, double(model::none)}, {clips, double(track_gait)});
        RANGE("they must be finite", play(s).start_s, {-1e300}, {endless, no_number});
        RANGE("they must be finite", play(s).speed, {-1e30}, {endless, no_number});
        RANGE("they must be finite", play(s).phase_s, {-1e30}, {endless, no_number});
    }
    RANGE("does not exist", s.layers[1].reference_clip, {clips - 1}, {clips});
    RANGE("the reference's time is not finite", s.layers[1].reference_time_s, {-1e300}, {endless, no_number});
}

TEST_F(LayerRules, OfGaitsInEachPlace)
{
    const std::vector<std::function<Source &(LayerState &)>> sources = {
        [](LayerState &s) -> Source & { return s.now; },
        [&](LayerState &s) -> Source & { return s.fades[0].from = of_gait(0); },
        [&](LayerState &s) -> Source & { return s.fades[1].from = of_gait(0); }};
    for (const auto &source : sources) {
        RANGE("gait 3 does not exist: the crowd has 2", source(s).gait, {0}, {2});
        RANGE("gait 2 is of template", source(s).gait, {}, {1});
        RANGE("an actor that follows no track", source(s).gait, {}, {double(track_gait)});
        RANGE("0 to 1 is wanted", source(s).share, {0, 1}, {-1e-6, 1.000001, no_number});
        RANGE("a gait that no command leads to", source(s).share_from, {0, 1}, {-1e-6, 1.000001, no_number});
        RANGE("a gait that no command leads to", source(s).change_s, {-1e300}, {endless, no_number});
        RANGE("a gait that no command leads to", source(s).change_rounds, {-1e300}, {endless, no_number});
        RANGE("a gait that no command leads to", source(s).play.clip, {clip_walk}, {clip_sway});
        RANGE("a change of gait", source(s).change_length_s, {0, 1e30}, {-1e-6, endless, no_number});
    }
}

TEST_F(LayerRules, OfFades)
{
    for (const uint32_t k : {0u, 1u}) {
        RANGE("a command begins at", s.fades[k].at_s, {k ? 1e300 : -1e300}, {endless, no_number});
        RANGE("a fade of", s.fades[k].length_s, {0, 1e30}, {-1e-6, endless, no_number});
        REFUSES("a fade that no command leads to", s.fades[k].curve = static_cast<Curve>(3));
    }
    RANGE("a fade that no command leads to", s.fades[1].at_s, {1.0001}, {1, 0.5});
    const char *const one_clip = "an inertial fade needs one clip on both sides";
    REFUSES(one_clip, s.fades[0].curve = Curve::inertial);
    REFUSES(one_clip, s.fades[1].curve = Curve::inertial);
    TAKES(s.now = Source(), s.fades[1].curve = Curve::inertial);
    REFUSES(one_clip, s.now = Source(), s.fades[0].from = of_gait(0), s.fades[1].curve = Curve::inertial);
    REFUSES(one_clip, s.now = Source(), s.fades[1].from = of_gait(0), s.fades[0].curve = Curve::inertial);
}

TEST_F(LayerRules, OfLayers)
{
    for (const uint32_t k : {0u, 1u}) {
        RANGE("a command begins at", s.layers[k].start_s, {-1e300}, {-endless, no_number});
        RANGE("a layer from", (s.layers[k].start_s = 2, s.layers[k].end_s), {2, endless}, {1.999, no_number});
        RANGE("a layer's fade in", s.layers[k].fade_in_s, {0, 1e30}, {-1e-6, endless, no_number});
        RANGE("a layer's fade out", s.layers[k].fade_out_s, {0, 1e30}, {-1e-6, endless, no_number});
        REFUSES("a layer of no curve", s.layers[k].curve = static_cast<Curve>(3));
        REFUSES("a layer does not come in by inertia", s.layers[k].curve = Curve::inertial);
        RANGE("mask 3 does not exist: the crowd has 2", s.layers[k].mask, {0, double(model::none)}, {2});
        RANGE("mask 2 is of template", s.layers[k].mask, {}, {1});
    }
    RANGE("a layer's weight", s.layers[0].weight, {0, 1}, {-1e-6, 1.000001, no_number});
    RANGE("a layer's weight", s.layers[1].weight, {-4, 4}, {-4.00001, 4.00001, no_number});
}

TEST_F(LayerRules, OfEightClipsAtOnce)
{
    state_.fade_count = 3, state_.layer_count = 0;
    for (uint32_t k = 0; k < 3; ++k) state_.fades[k].from = of_gait(0), state_.fades[k].at_s = k;
    TAKES();
    REFUSES("3 fades, 4 layers and 8 clips run together", s.layer_count = 1);
    TAKES(s.layer_count = 1, s.now = Source());
}

TEST_F(LayerRules, OfAGait)
{
    const auto refusal = [&](const std::function<void(Gait &)> &change) -> std::string {
        Gait gait(std::pmr::get_default_resource());
        gait.tmpl = figure_.get(), gait.clip_a = clip_walk, gait.clip_b = clip_sway;
        gait.sync_a = {0, 0.5}, gait.sync_b = {0.25, 0.999};
        change(gait);
        try {
            check_gait(gait);
            return "";
        } catch (const base::Error &error) {
            return error.what();
        }
    };
    const uint32_t clips = static_cast<uint32_t>(figure_->rig.clips.size());
    EXPECT_EQ(refusal([](Gait &) {}), "");
    EXPECT_EQ(refusal([](Gait &gait) { gait.sync_a.clear(), gait.sync_b.clear(); }), "");
    for (uint32_t Gait::*clip : {&Gait::clip_a, &Gait::clip_b}) {
        EXPECT_NE(refusal([&](Gait &gait) { gait.*clip = clips; }).find("which does not exist"), std::string::npos);
        figure_->rig.clips[clips - 1].duration_s = 0;
        EXPECT_NE(refusal([&](Gait &gait) { gait.*clip = clips - 1; }).find("which has no length"), std::string::npos);
    }
    EXPECT_NE(refusal([](Gait &gait) { gait.sync_a.push_back(0.75); }).find("a gait with 3 and 2"), std::string::npos);
    for (Array<double> Gait::*sync : {&Gait::sync_a, &Gait::sync_b})
        for (const std::vector<double> &wrong :
             {std::vector<double>{-0.001, 0.5}, {0.5, 0.5}, {0.5, 0.4}, {0.5, 1}, {double(no_number), 0.5}})
            EXPECT_NE(
                refusal([&](Gait &gait) { (gait.*sync).assign(wrong.begin(), wrong.end()); }).find("of the cycle"),
                std::string::npos)
                << wrong[0] << ", " << wrong[1];
}

TEST_F(LayerRules, PhasesAreTheIntegralOfThePaceAtEachShare)
{
    const Gait &gait = crowd_.layers().gait(0);
    Source source = of_gait(0);
    source.play.speed = 1.3f, source.share_from = 0.2f, source.share = 0.9f, source.change_length_s = 2;
    source.change_s = 5, source.change_rounds = 7.25;
    const double a = 1.3f / double(figure_->rig.clips[clip_walk].duration_s),
                 b = 1.3f / double(figure_->rig.clips[clip_sway].duration_s);
    EXPECT_DOUBLE_EQ(pace_of(gait, 1.3f).a, a);
    EXPECT_DOUBLE_EQ(pace_of(gait, 1.3f).b, b);
    constexpr double step = 1e-3;
    double rounds = rounds_at(gait, source, 3);
    for (double t = 3; t < 9; t += step) {
        // The share goes smoothly from its first value to its second.
        const double middle = t + step / 2, part = std::clamp((middle - 5) / 2, 0.0, 1.0);
        const double share = double(0.2f) + (double(0.9f) - double(0.2f)) * part * part * (3 - 2 * part);
        ASSERT_NEAR(share_at(source, middle), share, 1e-6) << t;
        rounds += step * (a + (b - a) * share);
        ASSERT_NEAR(rounds_at(gait, source, t + step), rounds, 1e-6) << t;
    }
    EXPECT_DOUBLE_EQ(rounds_at(gait, source, 5), 7.25);
    source.change_length_s = 0;
    EXPECT_FLOAT_EQ(share_at(source, 5.001), 0.9f) << "at once";
}

TEST_F(LayerRules, MomentsThatBelongTogetherComeTogether)
{
    model::Rig &rig = figure_->rig;
    rig.clips[clip_walk].start_s = 0.125f;
    for (const bool synced : {false, true}) {
        Gait gait(std::pmr::get_default_resource());
        gait.tmpl = figure_.get(), gait.clip_a = clip_walk, gait.clip_b = clip_sway;
        if (synced) gait.sync_a = {0.1, 0.35, 0.8}, gait.sync_b = {0.05, 0.6, 0.7};
        const auto time_of = [&](uint32_t clip, double part) {
            return double(rig.clips[clip].start_s) + part * double(rig.clips[clip].duration_s);
        };
        for (double part = 0; part < 0.999; part += 0.0217) {
            const double time_s = time_of(clip_walk, part);
            EXPECT_NEAR(time_in_a(gait, share_of_a(gait, time_s)), time_s, 1e-6) << part;
            EXPECT_NEAR(share_of_a(gait, time_s), share_of_a(gait, time_of(clip_walk, part + 2)), 1e-6) << part;
            if (synced) continue;
            EXPECT_NEAR(time_in_a(gait, 3 + part), time_s, 1e-6);
            EXPECT_NEAR(time_in_b(gait, part - 4), time_of(clip_sway, part), 1e-6);
        }
        for (uint32_t k = 0; synced && k < 3; ++k) {
            EXPECT_NEAR(time_in_a(gait, k / 3.0), time_of(clip_walk, gait.sync_a[k]), 1e-6);
            EXPECT_NEAR(time_in_b(gait, 5 + k / 3.0), time_of(clip_sway, gait.sync_b[k]), 1e-6);
            const double next_a = k < 2 ? gait.sync_a[k + 1] : 1.1, next_b = k < 2 ? gait.sync_b[k + 1] : 1.05;
            const auto half = [](double from, double to) { return std::fmod((from + to) / 2, 1); };
            EXPECT_NEAR(time_in_a(gait, (k + 0.5) / 3), time_of(clip_walk, half(gait.sync_a[k], next_a)), 1e-6);
            EXPECT_NEAR(time_in_b(gait, (k + 0.5) / 3), time_of(clip_sway, half(gait.sync_b[k], next_b)), 1e-6);
        }
        EXPECT_NEAR(time_in_a(gait, double(no_number)), time_of(clip_walk, synced ? 0.1 : 0), 1e-6);
    }
}

}  // namespace claque::crowd
