// The rules of saved commands, each on both sides of its bound.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/crowd/save_check.h"

namespace claque::crowd
{

namespace
{

std::string said(uint8_t kind, uint32_t poses, const std::function<void(Command &)> &change)
{
    Mechanism mechanism;
    mechanism.kind = kind_of(kind, std::pmr::get_default_resource());
    if (Expression *expression = std::get_if<Expression>(&mechanism.kind))
        while (expression->poses.size() < poses) expression->poses.emplace_back();
    Command command;
    change(command);
    try {
        check_command(mechanism, command, 4);
        return "";
    } catch (const base::Error &error) {
        EXPECT_EQ(error.status(), CLQ_FORMAT);
        return error.what();
    }
}

const char *const refused = "a saved crowd holds a command that mechanism 5 never gets";

}  // namespace

TEST(CommandRules, ChoicesAreThoseThatTheKindHas)
{
    for (uint8_t kind = 0; kind < 6; ++kind)
        for (uint32_t Command::*choice : {&Command::choice, &Command::choice_before}) {
            const uint32_t count = kind == 1 ? 3 : 1;  // expressions have poses
            for (const uint32_t taken : {0u, count - 1, model::none})
                EXPECT_EQ(said(kind, 3, [=](Command &one) { one.*choice = taken; }), "") << int(kind);
            EXPECT_EQ(said(kind, 3, [=](Command &one) { one.*choice = count; }), refused) << int(kind);
        }
    for (const uint8_t kind : {6, 255}) EXPECT_THROW(kind_of(kind, std::pmr::get_default_resource()), base::Error);
}

TEST(CommandRules, NumbersAreFiniteAndPointsNear)
{
    const auto at = [](double at_s) { return said(0, 0, [=](Command &one) { one.at_s = at_s; }); };
    for (const double taken : {-1e300, 1e300, double(-INFINITY)}) EXPECT_EQ(at(taken), "") << taken;
    for (const double wrong : {double(INFINITY), double(NAN)}) EXPECT_EQ(at(wrong), refused) << wrong;
    for (int k = 0; k < 3; ++k) {
        const auto point = [k](float x) { return said(0, 0, [=](Command &one) { one.point[k] = x; }); };
        for (const float taken : {1e30f, -1e30f}) EXPECT_EQ(point(taken), "") << k;
        for (const float wrong : {1.001e30f, -1.001e30f, INFINITY, NAN}) EXPECT_EQ(point(wrong), refused) << k;
    }
    for (float Command::*number : {&Command::from_yaw, &Command::from_pitch, &Command::side}) {
        EXPECT_EQ(said(0, 0, [=](Command &one) { one.*number = -1e30f; }), "");
        for (const float wrong : {-INFINITY, NAN})
            EXPECT_EQ(said(0, 0, [=](Command &one) { one.*number = wrong; }), refused);
    }
}

}  // namespace claque::crowd
