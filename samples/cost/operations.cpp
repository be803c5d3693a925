#include "samples/cost/operations.h"

namespace cost
{
namespace
{

using F = const Factors &;
using S = const Scene &;

constexpr TableFormula traditional_5[operation_count] = {
    {"nActors x nSkelsPerActor", [](F f) { return f.actors * f.nodes_per_actor; }},
    {"nActors", [](F f) { return f.actors; }},
    {"nActors", [](F f) { return f.actors; }},
    {"nActors x (1 + 1 + nBsphsPerActor)", [](F f) { return f.actors * (1 + 1 + f.spheres_per_actor); }},
    {"nActors x (1 + fSklsrootBsphsOut + fSklsrootBsphsIn + fSklsrootBsphsIsect x nBsphsPerActor / 2)",
     [](F f) { return f.actors * (1 + f.root_out + f.root_in + f.root_crossing * f.spheres_per_actor / 2); }},
    {"nActors x (1 + nSkelsPerActor)", [](F f) { return f.actors * (1 + f.nodes_per_actor); }},
};

constexpr TableFormula actor_5[operation_count] = {
    {"fSklsrootBsphsIn x nActors x nSkelsPerActor x fLODtopo",
     [](F f) { return f.root_in * f.actors * f.nodes_per_actor * f.nodes_kept; }},
    {"nActors", [](F f) { return f.actors; }},
    {"nActors x fRefpointBsphsIn", [](F f) { return f.actors * f.refpoint_in; }},
    {"nActors x fCheckIntBsphs x nBsphsPerActor",
     [](F f) { return f.actors * f.check_internal * f.spheres_per_actor; }},
    {"nActors x (1 + fSklsrootBsphsOut + fSklsrootBsphsIn + fCheckIntBsphs x nBsphsPerActor / 2)",
     [](F f) { return f.actors * (1 + f.root_out + f.root_in + f.check_internal * f.spheres_per_actor / 2); }},
    {"nActors", [](F f) { return f.actors; }},
};

// The frustum's contents decide which spheres are tested; they are the same for both kinds of processing.
constexpr const char *tests = "nActors + C + C3.1 + C3.2 x nBsphsPerActor / 2",
                     *tests_why =
                         "every Refpoint Bsphere; the Sklsroot Bsphere of actors on the edge; then one test settles "
                         "C3.1, and half of the Internal Bspheres C3.2 (hierarchy)";
double tests_of(S s)
{
    return s.actors() + s.refpoint_crossing() + s.internal_decided + s.internal_crossing * s.spheres_per_actor / 2.0;
}

constexpr SceneFormula traditional_4_2[operation_count] = {
    {"nActors x nSkelsPerActor", "every actor is moved before any is culled",
     [](S s) { return 1.0 * s.actors() * s.nodes_per_actor; }},
    {"nActors", "everybody", [](S s) { return 1.0 * s.actors(); }},
    {"nActors", "everybody", [](S s) { return 1.0 * s.actors(); }},
    {"nActors x (1 + 1 + nBsphsPerActor)", "all spheres of all actors",
     [](S s) { return s.actors() * (1.0 + 1 + s.spheres_per_actor); }},
    {tests, tests_why, tests_of},
    {"nActors x (1 + nSkelsPerActor)", "every LOD node of every actor",
     [](S s) { return s.actors() * (1.0 + s.nodes_per_actor); }},
};

constexpr SceneFormula actor_4_2[operation_count] = {
    {"(B + C2 + C3) x nSkelsPerActor x fLODtopo", "actors that pass the second cull: steps 4 and 5",
     [](S s) { return s.pass_second_cull() * s.nodes_per_actor * s.nodes_kept; }},
    {"nActors", "step 1 is done for all actors", [](S s) { return 1.0 * s.actors(); }},
    {"B + C", "actors that pass the first cull need a Skeleton Root: step 3",
     [](S s) { return 1.0 * s.pass_first_cull(); }},
    {"C3 x nBsphsPerActor", "only new Internal Bspheres distinguish C3.1 from C3.2: step 6",
     [](S s) { return 1.0 * s.root_crossing() * s.spheres_per_actor; }},
    {tests, tests_why, tests_of},
    {"B + C2 + C3", "one eyeDistance for each actor with levels to choose from (S0 5)",
     [](S s) { return 1.0 * s.pass_second_cull(); }},
};

}  // namespace

const char *name_of(Operation operation)
{
    constexpr const char *names[operation_count] = {"NO_01", "NO_02", "NO_03", "NO_04a", "NO_04b", "NO_05"};
    return names[operation];
}

const char *description_of(Operation operation)
{
    constexpr const char *words[operation_count] = {
        "articulation matrix of a Skeleton node",        "position and orientation of the Reference Point",
        "position and orientation of the Skeleton Root", "sphere of one node recalculated from those below it",
        "sphere of one node tested against the frustum", "distance for the level of detail",
    };
    return words[operation];
}

const TableFormula &table_5(Operation operation, Processing processing)
{
    return (processing == Processing::actor ? actor_5 : traditional_5)[operation];
}

const SceneFormula &by_order_of_work(Operation operation, Processing processing)
{
    return (processing == Processing::actor ? actor_4_2 : traditional_4_2)[operation];
}

Counts counts_of_table_5(const Factors &factors, Processing processing)
{
    Counts counts;
    for (size_t i = 0; i < operation_count; ++i)
        counts[i] = table_5(static_cast<Operation>(i), processing).count(factors);
    return counts;
}

Counts counts_by_order_of_work(const Scene &scene, Processing processing)
{
    Counts counts;
    for (size_t i = 0; i < operation_count; ++i)
        counts[i] = by_order_of_work(static_cast<Operation>(i), processing).count(scene);
    return counts;
}

}  // namespace cost
