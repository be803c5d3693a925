#include "samples/cost/measured.h"

#include <nlohmann/json.hpp>

#include "samples/io/json.h"
#include "samples/scenes/check.h"

namespace cost
{
namespace
{

using Json = nlohmann::ordered_json;

[[noreturn]] void refuse(const std::string &name, const std::string &why)
{
    throw scenes::Failure(name + " is not a report of counts: " + why);
}

double number_of(const Json &of, const char *key, double most, const std::string &name)
{
    if (!of.contains(key)) refuse(name, "it lacks '" + std::string(key) + "'");
    const Json &value = of[key];
    if (!value.is_number() || !(value.get<double>() >= 0) || !(value.get<double>() <= most))
        refuse(name, "its '" + std::string(key) + "' is " + value.dump(-1, ' ', false, Json::error_handler_t::replace) +
                         ", not a number from 0 to " + (most == 1 ? "1" : "1e12"));
    return value.get<double>();
}

Counts counts_of(const Json &of, const std::string &name)
{
    Counts counts;
    for (size_t i = 0; i < operation_count; ++i)
        counts[i] = number_of(of, name_of(static_cast<Operation>(i)), 1e12, name);
    if (!(counts[no_01] + counts[no_02] + counts[no_03] > 0)) refuse(name, "NO_01 to NO_03 are all 0: no actor moved");
    return counts;
}

Json counts_json(const Counts &counts)
{
    Json json;
    for (size_t i = 0; i < operation_count; ++i) json[name_of(static_cast<Operation>(i))] = counts[i];
    return json;
}

}  // namespace

Measured measured_of(const std::string &file, const std::string &name)
{
    std::string problem;
    const Json json = io::parse_json<Json>(file, problem);
    if (!problem.empty()) refuse(name, "it " + problem);
    if (!json.is_object()) refuse(name, "it is not an object");
    Measured measured;
    measured.actor = counts_of(json, name);
    measured.shares = {number_of(json, "fTrack", 1, name), number_of(json, "fCoh", 1, name)};
    if (!json.contains("note") || !json["note"].is_string()) refuse(name, "it has no 'note' that says what ran");
    measured.note = json["note"].get<std::string>();
    if (json.contains("traditional")) {
        if (!json["traditional"].is_object()) refuse(name, "its 'traditional' is not an object");
        measured.traditional = counts_of(json["traditional"], name + ", under 'traditional',");
    }
    return measured;
}

std::string json_of(const Measured &measured)
{
    Json json = {{"note", measured.note}};
    json.update(counts_json(measured.actor));
    json["fTrack"] = measured.shares.track;
    json["fCoh"] = measured.shares.coherence;
    if (measured.traditional) json["traditional"] = counts_json(*measured.traditional);
    return json.dump(2) + "\n";
}

}  // namespace cost
