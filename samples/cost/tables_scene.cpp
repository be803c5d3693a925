// Tables 1 to 4: the operations that are counted, and the actors of the scene.
#include "samples/cost/report.h"

namespace cost
{
namespace
{

Table table_1()
{
    Table t = {"Table 1. Operations on an actor, and what they cost", {"number", "cost", "operation"}, {}, {}};
    for (size_t i = 0; i < operation_count; ++i) {
        const Operation operation = static_cast<Operation>(i);
        const std::string number = name_of(operation), cost = "C" + number.substr(1);
        t.rows.push_back({number, i < 3 ? cost + "a, " + cost + "b" : cost, description_of(operation)});
    }
    t.notes = {"Costs 01 to 03: a is for the values of the degrees of freedom, b for the matrix that they give."};
    return t;
}

Table table_2(const Scene &s)
{
    const auto row = [](const char *what, const char *words, int count) {
        return std::vector<Cell>{what, words, Figure{1.0 * count}};
    };
    return {
        "Table 2. The actors of the example scene",
        {"", "actors", "number"},
        {row("A+B+C", "all", s.actors()), row("A", "Refpoint Bsphere outside the frustum", s.outside),
         row("B", "Refpoint Bsphere within", s.refpoint_within),
         row("C", "Refpoint Bsphere on the edge (C1+C2+C3)", s.refpoint_crossing()),
         row("C1", "  Sklsroot Bsphere outside", s.root_outside), row("C2", "  Sklsroot Bsphere within", s.root_within),
         row("C3", "  Sklsroot Bsphere on the edge (C3.1+C3.2)", s.root_crossing()),
         row("C3.1", "    Internal Bspheres all outside or all within", s.internal_decided),
         row("C3.2", "    Internal Bspheres on the edge", s.internal_crossing),
         row("B+C", "of these pass the first cull (section 4.2)", s.pass_first_cull()),
         row("B+C2+C3", "of these pass the second", s.pass_second_cull())},
        {}};
}

Table table_3(const Scene &s)
{
    return {
        "Table 3. Each actor of it",
        {"", "number"},
        {{"Skeleton nodes", Figure{1.0 * s.nodes_per_actor}}, {"Internal Bspheres", Figure{1.0 * s.spheres_per_actor}}},
        {}};
}

Table table_4(const Scene &s)
{
    const Factors f = factors_of(s);
    const auto ratio = [&](const char *name, const char *of, double value) {
        return std::vector<Cell>{name, of, figure(value * f.actors), figure(value)};
    };
    return {"Table 4. Factors, from Tables 2 and 3",
            {"factor", "is", "number", "ratio"},
            {{"nActors", "A+B+C", figure(f.actors), ""},
             ratio("fRefpointBsphsIn", "B", f.refpoint_in),
             ratio("fSklsrootBsphsOut", "C1", f.root_out),
             ratio("fSklsrootBsphsIn", "C2", f.root_in),
             ratio("fSklsrootBsphsIsect", "C3.1", f.root_crossing),
             ratio("fCheckIntBsphs", "C3.2", f.check_internal),
             {"nSkelsPerActor", "", figure(f.nodes_per_actor), ""},
             {"nBsphsPerActor", "", figure(f.spheres_per_actor), ""},
             {"fLODtopo", "nodes kept by skeletal levels", "", figure(f.nodes_kept)}},
            {}};
}

}  // namespace

std::vector<Table> tables_of_scene(const Scene &scene)
{
    return {table_1(), table_2(scene), table_3(scene), table_4(scene)};
}

}  // namespace cost
