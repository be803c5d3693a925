// S0's Table 6 and equations (1) to (3): costs typed from the paper, improvements worked out by hand.
#include <gtest/gtest.h>

#include "samples/cost/measured.h"
#include "samples/cost/readings.h"

namespace cost
{
namespace
{

const Scene equation_scene;

void expect_polynomial(const Polynomial &p, double both, double track, double coherence, double constant)
{
    EXPECT_NEAR(p.both, both, 1e-6);
    EXPECT_NEAR(p.track, track, 1e-6);
    EXPECT_NEAR(p.coherence, coherence, 1e-6);
    EXPECT_NEAR(p.constant, constant, 1e-6);
}

TEST(Equation, Table6IsThePaperS)
{
    const UnitCosts &traditional = table_6(Processing::traditional), &actor = table_6(Processing::actor);
    const double flat[operation_count] = {908, 454, 566, 50, 64, 8};
    for (size_t i = 0; i < operation_count; ++i) expect_polynomial(traditional.one[i], 0, 0, 0, flat[i]);
    expect_polynomial(actor.one[no_01], 29, 53, 19, 10);
    expect_polynomial(actor.one[no_02], 0, 0, 22, 63);
    expect_polynomial(actor.one[no_03], 0, 0, 85, 63);
    for (const Operation i : {no_04a, no_04b, no_05}) expect_polynomial(actor.one[i], 0, 0, 0, flat[i]);
    EXPECT_EQ(traditional.values, (std::array<double, 3>{1, 1, 1}));
    EXPECT_EQ(actor.values, (std::array<double, 3>{0.5, 1, 0.5}));
}

TEST(Equation, TraditionalCostsFollowFromTable5)
{
    EXPECT_DOUBLE_EQ(from_printed_counts().traditional.management.constant, 4206240);
    EXPECT_DOUBLE_EQ(from_printed_counts().traditional.behaviour, 4200);
}

TEST(Equation, TheConstantIs21Point600ByTable5And22Point880ByItsFormulas)
{
    EXPECT_DOUBLE_EQ(as_printed().constant, 23100);
    EXPECT_DOUBLE_EQ(from_printed_counts().constant, 21600);
    EXPECT_NEAR(from_formulas(equation_scene).constant, 22880, 1e-6);
    EXPECT_DOUBLE_EQ(by_order_of_work(equation_scene).constant, 800 * 50 + 238 * 64 + 60 * 8);
}

TEST(Equation, ThePrintedExpansionFollowsFromThePrintedConstant)
{
    expect_polynomial(as_printed().actor.management, 11600, 21200, 12350, 35290);
    expect_polynomial(from_printed_counts().actor.management, 11600, 21200, 12350, 35290 - 23100 + 21600);
    expect_polynomial(from_formulas(equation_scene).actor.management, 11600, 21200, 12350, 35290 - 23100 + 22880);
    expect_polynomial(by_order_of_work(equation_scene).actor.management, 34800, 63600, 31800, 79052);
}

TEST(Equation, BehaviourCosts315AsPrintedAnd740ByTheOrderOfWork)
{
    EXPECT_DOUBLE_EQ(as_printed().actor.behaviour, 315);
    EXPECT_DOUBLE_EQ(from_printed_counts().actor.behaviour, 315);
    EXPECT_DOUBLE_EQ(by_order_of_work(equation_scene).actor.behaviour, 740);
}

TEST(Equation, ImprovementAsPrintedAtSeveralPoints)
{
    const Reading r = as_printed();
    EXPECT_NEAR(r.improvement(0, {0, 0}), 4206240.0 / 35290, 1e-9);
    EXPECT_NEAR(r.improvement(0, {1, 1}), 4206240.0 / 80440, 1e-9);
    EXPECT_NEAR(r.improvement(100, {0, 1}), 4626240.0 / (31500 + 47640), 1e-9);
    EXPECT_NEAR(r.improvement(100, {1, 0}), 4626240.0 / (31500 + 56490), 1e-9);
    EXPECT_NEAR(r.improvement(1000, {0.5, 0.25}), 8406240.0 / (315000 + 1450 + 10600 + 3087.5 + 35290), 1e-9);
}

TEST(Equation, ImprovementOfTheOtherReadings)
{
    EXPECT_NEAR(from_printed_counts().improvement(0, {0, 0}), 4206240.0 / 33790, 1e-9);
    EXPECT_NEAR(from_formulas(equation_scene).improvement(10, {0, 0}), 4248240.0 / (3150 + 35070), 1e-6);
    EXPECT_NEAR(by_order_of_work(equation_scene).improvement(0, {1, 1}), 4192032.0 / 209252, 1e-9);
    EXPECT_NEAR(by_order_of_work(equation_scene).improvement(50, {0, 0}), (210000 + 4192032.0) / (37000 + 79052), 1e-9);
}

TEST(Equation, ImprovementFallsToThirteenAsPrintedAndBelowSixInTruth)
{
    EXPECT_NEAR(as_printed().limit(), 4200.0 / 315, 1e-12);
    EXPECT_NEAR(as_printed().improvement(1e9, {1, 1}), 4200.0 / 315, 1e-3);
    EXPECT_NEAR(by_order_of_work(equation_scene).limit(), 4200.0 / 740, 1e-12);
}

TEST(Equation, MeasuredCountsTakeThePlaceOfTheActorSide)
{
    Measured measured;
    measured.actor = {10, 4, 2, 6, 7, 3};
    measured.shares = {0.5, 0.25};
    const Reading r = as_measured(measured, equation_scene);
    EXPECT_DOUBLE_EQ(r.actor.behaviour, 5 + 4 + 1);
    // 10 x (29/8 + 53/2 + 19/4 + 10) + 4 x (5.5 + 63) + 2 x (21.25 + 63) + 300 + 448 + 24
    EXPECT_NEAR(r.actor.management.at(measured.shares), 448.75 + 274 + 168.5 + 772, 1e-9);
    EXPECT_DOUBLE_EQ(r.traditional.behaviour, 4200) << "taken from the scene where the run has no count";

    measured.traditional = Counts{40, 4, 4, 20, 8, 44};
    EXPECT_DOUBLE_EQ(as_measured(measured, equation_scene).traditional.behaviour, 48);
    EXPECT_DOUBLE_EQ(as_measured(measured, equation_scene).traditional.management.constant,
                     40 * 908 + 4 * 454 + 4 * 566 + 20 * 50 + 8 * 64 + 44 * 8);
}

}  // namespace
}  // namespace cost
