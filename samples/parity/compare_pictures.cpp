// Measures of what pictures show: visible individuals, zones, depth, colour.
#include <algorithm>

#include "samples/parity/compare_parts.h"
#include "samples/parity/depth.h"
#include "samples/parity/flip.h"
#include "samples/parity/psnr.h"
#include "samples/parity/regions.h"
#include "samples/parity/ssim.h"

namespace parity
{
namespace
{

std::string pixel(int x, int y) { return "pixel " + std::to_string(x) + ", " + std::to_string(y); }

std::string pixels(size_t count) { return std::to_string(count) + " pixels"; }

std::string first_outside(const IdAgreement &ids)
{
    return ids.outside == 0 ? std::string() : "first at " + pixel(ids.first_x, ids.first_y);
}

// "actor 17 (citizen, level 2), tunic, 35 pixels": the id combines an actor and a zone.
std::string zone_text(const Capture &capture, const WorstRegion &worst)
{
    if (worst.value == 0) return {};
    const uint32_t actor = static_cast<uint32_t>(worst.id >> 16);
    const size_t zone = worst.id & 0xffff;
    std::string out = actor_text(capture, actor);
    if (zone > 0 && capture.actors)
        for (const Actor &a : *capture.actors)
            if (a.id == actor && zone <= a.zones->size()) out += ", " + (*a.zones)[zone - 1];
    return out + ", " + pixels(worst.pixels);
}

void add_zones(const Pair &pair, Comparison &out)
{
    const Map<uint64_t> a = zone_ids(*pair.reference.actor, *pair.reference.zone);
    const Map<uint64_t> b = zone_ids(*pair.result.actor, *pair.result.zone);
    Counted same_actor;
    size_t people = 0;
    for (size_t i = 0; i < a.values.size(); ++i) {
        const uint32_t id = pair.reference.actor->values[i];
        same_actor.push_back(id == pair.result.actor->values[i]);
        people += same_actor.back() != 0 && id != 0;
    }
    IdAgreement ids = compare_ids(a, b, same_actor);
    out.measures.push_back({"zone_ids.outside", static_cast<double>(ids.outside), "pixels", first_outside(ids)});
    out.measures.push_back({"zone_ids.outside_share",
                            people == 0 ? 0 : static_cast<double>(ids.outside) / static_cast<double>(people), "",
                            "of " + pixels(people)});
    out.measures.push_back({"zone_ids.different", ids.share(), "", pixels(ids.different)});
    out.measures.push_back({"zone_ids.at_borders", ids.border_share(), "", "of " + pixels(ids.borders)});
    const WorstRegion worst = worst_ids(a, b, same_actor);
    if (worst.regions > 0)
        out.measures.push_back({"zone_ids.worst_zone", worst.value, "", zone_text(pair.reference, worst)});
    out.zone_marks = std::move(ids.marks);
}

// Pixels at which both show the same individual; empty: not known, and all count. Depth at other pixels is that of
// something else, and actor_ids has counted it.
Counted same_individual(const Pair &pair)
{
    Counted out;
    const auto &a = pair.reference.actor, &b = pair.result.actor;
    if (!a || !b) return out;
    for (size_t i = 0; i < a->values.size(); ++i) out.push_back(a->values[i] == b->values[i]);
    return out;
}

// Pixels that show an individual, so that an empty background does not dilute shares; of these, where both have ids,
// those at which both show the same individual and zone. Empty: not known, or there are none.
Counted people_alike(const Pair &pair)
{
    Counted out;
    const auto &a = pair.reference.actor, &b = pair.result.actor;
    if (!a && !b) return out;
    const auto &zones = pair.reference.zone, &own_zones = pair.result.zone;
    bool any = false;
    for (size_t i = 0; i < pair.reference.colour->pixels(); ++i) {
        const bool shown = (a && a->values[i] != 0) || (b && b->values[i] != 0);
        const bool alike = !a || !b || a->values[i] == b->values[i];
        const bool alike_zone = !zones || !own_zones || zones->values[i] == own_zones->values[i];
        out.push_back(shown && alike && alike_zone);
        any = any || out.back() != 0;
    }
    if (!any) out.clear();
    return out;
}

}  // namespace

void compare_id_maps(const Pair &pair, Comparison &out)
{
    if (!both_have(pair.reference.actor, pair.result.actor, "actor_ids", "actor.npy", out)) {
        out.not_compared.push_back({"zone_ids", "zones cannot be attributed without actor.npy in both"});
        return;
    }
    IdAgreement ids = compare_ids(actor_ids(*pair.reference.actor), actor_ids(*pair.result.actor), {});
    out.measures.push_back({"actor_ids.outside", static_cast<double>(ids.outside), "pixels", first_outside(ids)});
    out.measures.push_back({"actor_ids.different", ids.share(), "", pixels(ids.different)});
    out.measures.push_back({"actor_ids.at_silhouettes", ids.border_share(), "", "of " + pixels(ids.borders)});
    const WorstRegion worst = worst_ids(actor_ids(*pair.reference.actor), actor_ids(*pair.result.actor), {});
    if (worst.regions > 0)
        out.measures.push_back(
            {"actor_ids.worst_actor", worst.value, "",
             worst.value > 0 ? actor_text(pair.reference, static_cast<uint32_t>(worst.id)) + ", " + pixels(worst.pixels)
                             : ""});
    out.actor_marks = std::move(ids.marks);
    if (both_have(pair.reference.zone, pair.result.zone, "zone_ids", "zone.npy", out)) add_zones(pair, out);
}

void compare_depth(const Pair &pair, Comparison &out)
{
    if (!both_have(pair.reference.depth, pair.result.depth, "depth", "depth.npy", out)) return;
    const Counted counted = same_individual(pair);
    const DepthDeviation d = depth_deviation(*pair.reference.depth, *pair.result.depth, counted);
    out.measures.push_back({"depth.max", d.max, "", d.max > 0 ? pixel(d.max_x, d.max_y) : ""});
    out.measures.push_back({"depth.rms", d.rms, "", pixels(d.compared)});
    out.measures.push_back({"depth.median", d.median, "", {}});
    out.measures.push_back({"depth.p99_9", d.p99_9, "", {}});
    if (pair.reference.actor) {
        const WorstRegion worst =
            worst_depth(actor_ids(*pair.reference.actor), *pair.reference.depth, *pair.result.depth, counted);
        const std::string whose = actor_text(pair.reference, static_cast<uint32_t>(worst.id)) + ", ";
        if (worst.regions > 0)
            out.measures.push_back(
                {"depth.worst_actor", worst.value, "", worst.value > 0 ? whose + pixels(worst.pixels) : ""});
    }
    out.measures.push_back({"depth.not_finite", static_cast<double>(d.not_finite), "pixels", {}});
}

void compare_colour(const Pair &pair, double pixels_per_degree, Comparison &out)
{
    if (!both_have(pair.reference.colour, pair.result.colour, "colour", "colour.npy", out)) return;
    const Picture &a = *pair.reference.colour, &b = *pair.result.colour;
    const Counted counted = people_alike(pair);
    const ColourDeviation d = colour_deviation(a, b, counted);
    const std::string of = counted.empty()                             ? "of all pixels"
                           : pair.reference.actor && pair.result.actor ? "of pixels that show individuals alike"
                                                                       : "of pixels that show individuals";
    out.measures.push_back({"colour.max", double(d.max), "LSB", {}});
    out.measures.push_back({"colour.over_1", d.share_over(1), "", of});
    out.measures.push_back({"colour.over_2", d.share_over(2), "", of});
    out.measures.push_back({"colour.over_8", d.share_over(8), "", of});
    if (pair.reference.actor && pair.reference.zone) {
        const Map<uint64_t> zones = zone_ids(*pair.reference.actor, *pair.reference.zone);
        const WorstRegion worst = worst_colour(zones, a, b, counted), bias = worst_bias(zones, a, b, counted);
        if (worst.regions > 0)
            out.measures.push_back({"colour.worst_zone", worst.value, "LSB", zone_text(pair.reference, worst)});
        if (bias.regions > 0)
            out.measures.push_back({"colour.worst_bias", bias.value, "LSB", zone_text(pair.reference, bias)});
    }
    out.measures.push_back({"colour.bias", d.bias, "LSB", of});
    out.measures.push_back({"colour.psnr_db", d.psnr_db, "dB", {}});
    if (std::min(a.width, a.height) >= ssim_window) out.measures.push_back({"colour.ssim", mean_ssim(a, b), "", {}});
    out.flip = flip_map(a, b, pixels_per_degree);
    out.measures.push_back({"colour.flip_mean", mean_of(out.flip), "", {}});
    out.measures.push_back(
        {"colour.flip_max", double(*std::max_element(out.flip.values.begin(), out.flip.values.end())), "", {}});
}

}  // namespace parity
