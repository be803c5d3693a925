// Measures of individuals, their skinned positions and their normals.
#include <algorithm>
#include <cstdio>

#include "samples/parity/arrays.h"
#include "samples/parity/compare_parts.h"

namespace parity
{
namespace
{

const Actor *find(const std::vector<Actor> &actors, uint32_t id)
{
    const auto found = std::lower_bound(actors.begin(), actors.end(), id,
                                        [](const Actor &a, uint32_t wanted) { return a.id < wanted; });
    return found != actors.end() && found->id == id ? &*found : nullptr;
}

bool same_mesh(const Actor &a, const Actor &b) { return a.kind == b.kind && a.vertex_count == b.vertex_count; }

// The first one that has no counterpart, and their number.
struct Tally {
    size_t count = 0;
    std::string first;
    void add(const std::string &what)
    {
        if (count++ == 0) first = what;
    }
};

void add(Comparison &out, const char *name, const Tally &tally)
{
    out.measures.push_back({name, static_cast<double>(tally.count), "actors", tally.first});
}

// Actors that are in both with the same mesh. A folder without a table is in the other's order; without any table all
// vertices form one span.
std::vector<Span> spans_of(const Pair &pair, size_t reference_vertices, size_t result_vertices)
{
    const auto &own = pair.reference.actors, &other = pair.result.actors;
    const bool one_table = own.has_value() != other.has_value();
    if ((one_table || !own) && reference_vertices != result_vertices)
        throw Unreadable(pair.result.folder + " has " + std::to_string(result_vertices) + " vertices, " +
                         pair.reference.folder + " " + std::to_string(reference_vertices) +
                         ", and without actors.npy in both they cannot be matched");
    if (!own && !other) return {{0, 0, 0, reference_vertices, 0}};
    std::vector<Span> spans;
    for (const Actor &a : own ? *own : *other) {
        const Actor *b = one_table ? &a : find(*other, a.id);
        if (b && same_mesh(a, *b)) spans.push_back({a.id, a.first_vertex, b->first_vertex, a.vertex_count, a.size_m});
    }
    return spans;
}

std::string where(const Pair &pair, const Deviation &d)
{
    if (d.max == 0) return {};
    const std::string vertex = "vertex " + std::to_string(d.worst_vertex);
    return d.worst_actor == 0 ? vertex : actor_text(pair.reference, d.worst_actor) + ", " + vertex;
}

// Near 0 floats lie so densely that millions of them fit between two coordinates that mean the same.
std::string between(const Deviation &d)
{
    if (d.ulp_max == 0) return {};
    char text[64];
    std::snprintf(text, sizeof text, "between %.3g and %.3g", double(d.ulp_reference), double(d.ulp_result));
    return text;
}

void add_positions(const Pair &pair, Comparison &out)
{
    const auto &a = *pair.reference.positions, &b = *pair.result.positions;
    const std::vector<Span> spans = spans_of(pair, a.size() / 3, b.size() / 3);
    const Deviation d = positions_deviation(a, b, spans);
    out.measures.push_back({"positions.max_m", d.max, "m", where(pair, d)});
    out.measures.push_back({"positions.rms_m", d.rms, "m", std::to_string(d.compared) + " vertices"});
    const bool sized = std::any_of(spans.begin(), spans.end(), [](const Span &s) { return s.size_m > 0; });
    if (sized) out.measures.push_back({"positions.max_relative", d.max_relative, "", {}});
    out.measures.push_back({"positions.ulp_max", double(d.ulp_max), "ULP", between(d)});
    out.measures.push_back({"positions.ulp_median", double(d.ulp_median), "ULP", {}});
    out.measures.push_back({"positions.not_finite", static_cast<double>(d.not_finite), "vertices", {}});
}

void add_normals(const Pair &pair, Comparison &out)
{
    const auto &a = *pair.reference.normals, &b = *pair.result.normals;
    const Deviation d = normals_deviation(a, b, spans_of(pair, a.size() / 3, b.size() / 3));
    out.measures.push_back({"normals.max_deg", d.max, "degrees", where(pair, d)});
    out.measures.push_back({"normals.rms_deg", d.rms, "degrees", {}});
    out.measures.push_back({"normals.ulp_max", double(d.ulp_max), "ULP", between(d)});
    out.measures.push_back({"normals.ulp_median", double(d.ulp_median), "ULP", {}});
    out.measures.push_back({"normals.not_finite", static_cast<double>(d.not_finite), "normals", {}});
}

}  // namespace

std::string actor_text(const Capture &capture, uint32_t id)
{
    if (id == 0) return "the background";
    const Actor *a = capture.actors ? find(*capture.actors, id) : nullptr;
    return "actor " + std::to_string(id) + (a ? " (" + a->kind + ")" : "");
}

void compare_actors(const Pair &pair, Comparison &out)
{
    if (!both_have(pair.reference.actors, pair.result.actors, "actors", "actors.npy", out)) return;
    Tally missing, added, changed;
    for (const Actor &a : *pair.reference.actors) {
        const Actor *b = find(*pair.result.actors, a.id);
        if (!b) missing.add(actor_text(pair.reference, a.id));
        else if (!same_mesh(a, *b)) changed.add(actor_text(pair.reference, a.id) + " is " + b->kind);
    }
    for (const Actor &b : *pair.result.actors)
        if (!find(*pair.reference.actors, b.id)) added.add(actor_text(pair.result, b.id));
    add(out, "actors.missing", missing);
    add(out, "actors.added", added);
    add(out, "actors.changed", changed);
}

void compare_vertices(const Pair &pair, Comparison &out)
{
    if (both_have(pair.reference.positions, pair.result.positions, "positions", "positions.npy", out))
        add_positions(pair, out);
    if (both_have(pair.reference.normals, pair.result.normals, "normals", "normals.npy", out)) add_normals(pair, out);
}

}  // namespace parity
