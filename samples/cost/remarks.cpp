// Compares S0's printed numbers with results from its own tables: disagreements, with both numbers, and agreements.
#include <algorithm>
#include <cmath>

#include "samples/cost/printed.h"
#include "samples/cost/report.h"

namespace cost
{
namespace
{

std::string number(double value) { return text_of(figure(value)); }
std::string tenth(double value) { return text_of(Figure{value, 1}); }
bool same(const Polynomial &a, const Polynomial &b)
{
    return a.both == b.both && a.track == b.track && a.coherence == b.coherence && a.constant == b.constant;
}

std::string traditional_management()
{
    const double follows = from_printed_counts().traditional.management.constant;
    return "Trad_ProcSGMC is printed as " + number(printed::traditional_management) + "; Table 5 times Table 6 gives " +
           number(follows) + (follows == printed::traditional_management ? ": it follows." : ": it does not follow.");
}

// Every number of Table 5 that its own formula does not give.
std::vector<std::string> counts_that_do_not_follow(const Scene &scene)
{
    std::vector<std::string> remarks;
    const Reading formulas = from_formulas(scene);
    for (const Processing p : {Processing::traditional, Processing::actor})
        for (size_t i = 0; i < operation_count; ++i) {
            const bool actor = p == Processing::actor;
            const double print = (actor ? printed::actor : printed::traditional)[i],
                         follows = (actor ? formulas.actor_counts : formulas.traditional_counts)[i];
            if (std::abs(print - follows) > 1e-6)
                remarks.push_back(std::string(name_of(static_cast<Operation>(i))) + " of " +
                                  (actor ? "actor" : "traditional") + " processing is printed as " + number(print) +
                                  "; its formula in Table 5 gives " + number(follows) + ".");
        }
    return remarks;
}

std::string constant(const Scene &scene)
{
    const Reading formulas = from_formulas(scene);
    const UnitCosts &units = table_6(Processing::actor);
    const double rest = printed::constant - formulas.actor_counts[no_04a] * units.one[no_04a].constant -
                        formulas.actor_counts[no_05] * units.one[no_05].constant;
    return "The constant of Act_ProcSGMC is printed as " + number(printed::constant) + "; the counts of Table 5 give " +
           number(from_printed_counts().constant) + ", with NO_04b from its formula " + number(formulas.constant) +
           ". It would follow from " + number(formulas.actor_counts[no_04b]) + " tests at " +
           number(rest / formulas.actor_counts[no_04b]) + " FMULT, where Table 6 says " +
           number(units.one[no_04b].constant) + ".";
}

std::string expansion()
{
    Polynomial expanded = {0, 0, 0, printed::constant};
    std::string sum;
    for (const Operation i : {no_01, no_02, no_03}) {
        expanded = expanded + printed::actor[i] * table_6(Processing::actor).one[i];
        sum += number(printed::actor[i]) + " C" + std::string(name_of(i)).substr(1) + "b + ";
    }
    const bool follows = same(expanded, printed::actor_management);
    return sum + number(printed::constant) + " is printed as " + text_of(printed::actor_management) +
           "; Table 6 expands it to " + text_of(expanded) + (follows ? ": it follows" : ": it does not follow") +
           ". With " + number(from_printed_counts().constant) + " it ends in " +
           number(from_printed_counts().actor.management.constant) + ".";
}

std::string dropped(const Scene &s)
{
    const double first = s.actors() * (1 - printed::typical_first),
                 second = first - s.actors() * printed::typical_second;
    const Factors f = factors_of(s);
    return "Table 5 drops actors that Table 2 keeps. Under section 4.2 " + number(s.pass_first_cull()) +
           " pass the first cull (B+C) and " + number(s.pass_second_cull()) +
           " the second (B+C2+C3); Table 5 counts B = " + number(f.refpoint_in * f.actors) +
           " for NO_03 and C2 = " + number(f.root_in * f.actors) + " for NO_01. " + number(first) + " and " +
           number(second) + " would be right for the typical scene of section 4.2, in which the first cull removes " +
           number(100 * printed::typical_first) + " % and the second " + number(100 * printed::typical_second) +
           " % more; in Table 2 they remove " + number(s.outside) + " and " + number(s.root_outside) + ".";
}

std::string sphere_tests(const Scene &s)
{
    return "NO_04b of Table 5 tests the Sklsroot Bspheres of C1 and C2 but not those of C3 (" +
           number(s.root_crossing()) +
           "), and NO_04a recalculates Internal Bspheres for C3.2 alone, although only these distinguish C3.2 from "
           "C3.1. For traditional processing it spends " +
           number(s.spheres_per_actor / 2.0) + " tests on each of C3.1 and none on C3.2.";
}

std::string halved_twice()
{
    const Counts &counts = printed::actor;
    const double follows = cost_of(counts, table_6(Processing::actor)).behaviour,
                 once = counts[no_01] + counts[no_02] + counts[no_03];
    return "Act_ProcBMC is printed as " + number(printed::actor_behaviour) + " AverageCost; Tables 5 and 6 give " +
           number(follows) + (follows == printed::actor_behaviour ? ": it follows" : ": it does not follow") +
           ". But both leave out the nodes that levels of detail drop: fLODtopo is in NO_01, and Table 6 halves CO_01a "
           "and CO_03a for the same reason. If they are left out once it is " +
           number(once) + ", and the improvement tends to " + tenth(printed::traditional_behaviour / once) +
           " instead of " + tenth(as_printed().limit()) + " (printed: " + number(printed::worst) + ").";
}

std::string range()
{
    const Reading reading = as_printed();
    const auto between = [&](double average) {
        double least = 1e300, most = 0;
        for (const Shares &shares : corner_shares) {
            least = std::min(least, reading.improvement(average, shares));
            most = std::max(most, reading.improvement(average, shares));
        }
        return tenth(least) + " to " + tenth(most);
    };
    return "The paper states an improvement of " + number(printed::least) + " to " + number(printed::most) +
           " for AverageCost below " + number(printed::common_cost) + "; equation (3) as printed gives " + between(0) +
           " at 0 and " + between(printed::common_cost) + " at " + number(printed::common_cost) + ".";
}

std::string matrices()
{
    const UnitCosts &actor = table_6(Processing::actor), &traditional = table_6(Processing::traditional);
    const double same_price = cost_of(printed::actor, traditional).management.constant;
    return "At fTrack = fCoh = 1, where neither saves anything, a node's matrix costs " +
           number(actor.one[no_01].at({1, 1})) + " in Table 6 against " + number(traditional.one[no_01].constant) +
           " in traditional processing. At traditional prices for both, the "
           "counts of Table 5 alone improve management " +
           tenth(printed::traditional_management / same_price) + " times, not " +
           tenth(as_printed().improvement(0, {1, 1})) + " to " + tenth(as_printed().improvement(0, {0, 0})) + ".";
}

std::string truth(const Scene &scene)
{
    const Reading print = as_printed(), real = by_order_of_work(scene);
    return "With the counts of section 4.2 the improvement at AverageCost 0 is " + tenth(real.improvement(0, {1, 1})) +
           " to " + tenth(real.improvement(0, {0, 0})) + " (printed: " + tenth(print.improvement(0, {1, 1})) + " to " +
           tenth(print.improvement(0, {0, 0})) + ") and tends to " + tenth(real.limit()) +
           " (printed: " + tenth(print.limit()) + ").";
}

}  // namespace

std::vector<std::string> remarks_of(const Scene &scene)
{
    std::vector<std::string> remarks = {traditional_management()};
    for (std::string &remark : counts_that_do_not_follow(scene)) remarks.push_back(std::move(remark));
    for (std::string &remark :
         std::vector<std::string>{constant(scene), expansion(), dropped(scene), sphere_tests(scene), halved_twice(),
                                  range(), matrices(), truth(scene)})
        remarks.push_back(std::move(remark));
    return remarks;
}

}  // namespace cost
