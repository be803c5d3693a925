// Forged saved crowds: each number of gaits, fades and layers that no command leads to is refused.
#include <cstring>
#include <limits>

#include "tests/api/arm.h"
#include "tests/api/calls.h"
#include "tests/api/saved_bytes.h"

namespace
{

using saved::Bytes;

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

template <class T>
std::vector<size_t> places_of(const Bytes &bytes, T value)
{
    std::vector<size_t> out;
    for (size_t at = saved::header_bytes; at + sizeof value <= bytes.size(); ++at)
        if (std::memcmp(&bytes[at], &value, sizeof value) == 0) out.push_back(at);
    return out;
}

class SaveLayers : public testing::Test
{
protected:
    SaveLayers()
    {
        clq_fade_def gait = arm_.motion(0, 1);
        gait.gait = arm_.add_gait(Arm::slow, Arm::fast);
        gait.share = 0.34375f;
        EXPECT_EQ(api_test::fade_to(arm_.crowd, arm_.actor, gait, 1, 0, CLQ_CURVE_LINEAR), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_actor_set_gait_share(arm_.crowd, arm_.actor, 0.71875f, 2.15625, 0.59375f), CLQ_OK);
        gait.share = 0.28125f, gait.play.start_s = 4;
        EXPECT_EQ(api_test::fade_to(arm_.crowd, arm_.actor, gait, 4.28125, 2.65625f, CLQ_CURVE_LINEAR), CLQ_OK);
        EXPECT_EQ(clq_actor_set_gait_share(arm_.crowd, arm_.actor, 0.84375f, 5.40625, 0.46875f), CLQ_OK);
        clq_layer_def layer = clq_layer_def_init();
        layer.play.clip = Arm::wave, layer.weight = 0.65625f, layer.play.start_s = 1.78125;
        layer.fade_in_s = 0.15625f, layer.fade_out_s = 0.21875f;
        clq_layer made;
        EXPECT_EQ(clq_actor_add_layer(arm_.crowd, arm_.actor, &layer, &made), CLQ_OK) << clq_last_error();
        bytes_ = saved::save(arm_.crowd);
        EXPECT_EQ(restore(bytes_), CLQ_OK) << clq_last_error();
    }
    clq_status restore(const Bytes &bytes)
    {
        return clq_crowd_restore(arm_.crowd, bytes.data(), bytes.size(), &arm_.tmpl, 1);
    }
    template <class T>
    void refuses(const char *what, T value, const std::vector<double> &wrong)
    {
        const std::vector<size_t> places = places_of(bytes_, value);
        EXPECT_FALSE(places.empty()) << what;
        for (const size_t at : places)
            for (const double other : wrong) {
                Bytes forged = bytes_;
                const T number = static_cast<T>(other);
                std::memcpy(&forged[at], &number, sizeof number);
                saved::forge(forged);
                EXPECT_EQ(restore(forged), CLQ_FORMAT) << what << " of " << other << " at " << at;
            }
        EXPECT_EQ(saved::save(arm_.crowd), bytes_) << what;
    }
    Arm arm_;
    Bytes bytes_;
};

TEST_F(SaveLayers, EachNumberOfAGaitIsHeldToItsRange)
{
    refuses("the share before, of the earlier gait", 0.34375f, {-0.5, 2, nan});
    refuses("the share, of the earlier gait", 0.71875f, {-0.5, 2, nan});
    refuses("the length of the earlier change", 0.59375f, {-1, inf, nan});
    refuses("the time of the earlier change", 2.15625, {inf, nan});
    refuses("the share before, of the gait", 0.28125f, {-0.5, 2, nan});
    refuses("the share of the gait", 0.84375f, {-0.5, 2, nan});
    refuses("the length of the change", 0.46875f, {-1, inf, nan});
    refuses("the time of the change", 5.40625, {inf, nan});
}

TEST_F(SaveLayers, EachNumberOfAFadeIsHeldToItsRange)
{
    refuses("the time of the fade", 4.28125, {inf, nan});
    refuses("the length of the fade", 2.65625f, {-1, inf, nan});
}

TEST_F(SaveLayers, EachNumberOfALayerIsHeldToItsRange)
{
    refuses("the weight", 0.65625f, {-1, inf, nan});
    refuses("the time of the layer", 1.78125, {inf, nan});
    refuses("the fade into it", 0.15625f, {-1, inf, nan});
    refuses("the fade out of it", 0.21875f, {-1, inf, nan});
}

}  // namespace
