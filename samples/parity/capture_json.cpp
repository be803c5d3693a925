#include "samples/parity/capture_json.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "samples/io/json.h"

namespace parity
{
namespace
{

using Json = nlohmann::json;

constexpr int format_version = 1, most_side = 16384;
constexpr size_t most_name = 1024;  // of a template, which every mesh and individual repeats

class Fields
{
public:
    Fields(const Json &json, const std::string &path) : json_(json), path_(path) {}

    std::string text(const char *key, size_t most = SIZE_MAX) const
    {
        const Json &v = field(key);
        if (!v.is_string()) fail(key, "a string");
        std::string found = v.get<std::string>();
        if (found.size() > most) fail(key, ("a string of at most " + std::to_string(most) + " bytes").c_str());
        return found;
    }
    double number(const char *key, double low, double high) const
    {
        const Json &v = field(key);
        const double value = v.is_number() ? v.get<double>() : NAN;
        if (!(value >= low && value <= high))
            fail(key, ("a number from " + Json(low).dump() + " to " + Json(high).dump()).c_str());
        return value;
    }
    size_t whole(const char *key, int64_t high, int64_t low = 0) const
    {
        (void)number(key, static_cast<double>(low), static_cast<double>(high));
        const std::optional<int64_t> value = io::whole_in(field(key), low, high);
        if (!value) fail(key, "a whole number");
        return static_cast<size_t>(*value);
    }
    const Json &any(const char *key) const { return field(key); }
    const Json &list(const char *key) const
    {
        const Json &v = field(key);
        if (!v.is_array()) fail(key, "a list");
        return v;
    }
    std::vector<std::string> texts(const char *key) const
    {
        std::vector<std::string> out;
        for (const Json &v : list(key)) {
            if (!v.is_string()) fail(key, "a list of strings");
            out.push_back(v.get<std::string>());
        }
        return out;
    }

private:
    const Json &field(const char *key) const
    {
        const auto it = json_.find(key);
        if (!json_.is_object() || it == json_.end())
            throw Unreadable(path_ + " has no '" + key + "'; docs/parity.md lists what a result needs");
        return *it;
    }
    [[noreturn]] void fail(const char *key, const char *what) const
    {
        throw Unreadable(path_ + ": '" + key + "' has to be " + what);
    }

    const Json &json_;
    const std::string &path_;
};

std::string text_of(const Json &scene)
{
    return scene.is_string() ? scene.get<std::string>() : scene.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void read_meshes(const Json &json, const std::string &path, CaptureInfo &out)
{
    struct Template {
        std::string name;
        ZoneNames zones;
    };
    std::vector<Template> templates;
    const Fields fields(json, path);
    for (const Json &t : fields.list("templates"))
        templates.push_back({Fields(t, path).text("name", most_name),
                             std::make_shared<const std::vector<std::string>>(Fields(t, path).texts("zones"))});
    for (const Json &m : fields.list("meshes")) {
        const Fields mesh(m, path);
        const size_t which = mesh.whole("template", UINT32_MAX);
        if (which >= templates.size())
            throw Unreadable(path + ": a mesh names template " + std::to_string(which) + " of " +
                             std::to_string(templates.size()));
        std::string kind = templates[which].name + ", level " + std::to_string(mesh.whole("level", UINT16_MAX));
        if (m.contains("texture_set") && m["texture_set"] != 0)
            kind += ", textures " + std::to_string(mesh.whole("texture_set", UINT16_MAX));
        out.meshes.push_back({kind, mesh.whole("vertices", UINT32_MAX), templates[which].zones});
    }
}

}  // namespace

CaptureInfo capture_info(const std::string &capture, const std::string &path, bool has_table)
{
    std::string problem;
    const Json json = io::parse_json<Json>(capture, problem);
    if (!problem.empty()) throw Unreadable(path + " " + problem);
    const Fields fields(json, path);
    if (fields.text("format") != "claque-parity") throw Unreadable(path + ": its format is not claque-parity");
    const size_t version = fields.whole("version", UINT32_MAX);
    if (version != format_version)
        throw Unreadable(path + " is of version " + std::to_string(version) + ", and version 1 can be read");
    const std::string kind = fields.text("kind");
    if (kind != "result") throw Unreadable(path + ": its kind is '" + kind + "', and a result is expected");
    CaptureInfo out;
    out.renderer = fields.text("renderer");
    out.scene = text_of(fields.any("scene"));
    out.width = static_cast<int>(fields.whole("width", most_side, 1));
    out.height = static_cast<int>(fields.whole("height", most_side, 1));
    out.time_s = fields.number("time_s", -1e12, 1e12);
    if (!has_table) return out;
    out.actors = fields.whole("actors", UINT32_MAX);
    out.vertices = fields.whole("vertices", UINT32_MAX);
    out.actor_columns = fields.texts("actor_columns");
    read_meshes(json, path, out);
    return out;
}

}  // namespace parity
