#include "samples/cli/manifest.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "samples/cli/files.h"
#include "samples/cli/provenance.h"
#include "samples/cli/sequence.h"
#include "samples/io/json.h"
#include "samples/scenes/check.h"

namespace cli
{

namespace fs = std::filesystem;
using Json = Manifest::Json;

namespace
{

constexpr const char *mark = "claque_manifest";
constexpr int manifest_version = 1, largest_frame = 999999999;

// Frames lie beside the manifest. A check refuses others.
std::string relative(const std::string &file, const std::string &manifest)
{
    const fs::path folder = fs::path(manifest).parent_path();
    const fs::path from = fs::path(file).lexically_relative(folder.empty() ? "." : folder);
    return from.empty() || *from.begin() == ".." ? fs::absolute(file).lexically_normal().string() : from.string();
}

std::string whole_path(const std::string &file, const std::string &manifest)
{
    const fs::path path(file);
    return path.is_absolute() ? file : (fs::path(manifest).parent_path() / path).string();
}

struct ReadManifest {
    std::string name, pattern;
    Json about;
    std::vector<int> asked;
    struct Entry {
        int frame;
        std::string file, sha256;
    };
    std::vector<Entry> entries;
};

bool is_manifest(const Json &json) { return json.is_object() && json.contains(mark); }

// Throws scenes::Failure with what is wrong.
ReadManifest read_manifest(const std::string &path, const Json &json)
{
    ReadManifest found;
    found.name = fs::path(path).filename().string();
    try {
        if (json.at(mark) != manifest_version)
            throw scenes::Failure(path + ": version " + json.at(mark).dump() + " of manifests is not known");
        found.about = json.at("about");
        found.pattern = json.value("pattern", "");
        const std::string wrong = read_frames(json.at("asked").get<std::string>(), found.asked);
        if (!wrong.empty()) throw scenes::Failure(path + ": asked: " + wrong);
        for (const Json &one : json.at("frames")) {
            const std::optional<int64_t> frame = io::whole_in(one.at("frame"), 0, largest_frame);
            if (!frame) throw scenes::Failure(path + ": " + one.at("frame").dump() + " is no number of a frame");
            found.entries.push_back({static_cast<int>(*frame), one.at("file"), one.at("sha256")});
        }
    } catch (const Json::exception &error) {
        throw scenes::Failure(path + " is no whole manifest: " + error.what());
    }
    return found;
}

// Discarded: no JSON, or nested deeper than any manifest.
Json parsed(const std::string &path)
{
    std::string problem;
    return io::parse_json<Json>(text_of(path), problem);
}

void compare_about(const ReadManifest &first, const ReadManifest &other, FilmReport &report)
{
    std::set<std::string> keys;
    for (const Json *about : {&first.about, &other.about})
        for (const auto &[key, value] : about->items()) keys.insert(key);
    for (const std::string &key : keys) {
        const Json a = first.about.value(key, Json()), b = other.about.value(key, Json());
        if (a != b)
            report.sentences.push_back(key + " differs: " + a.dump() + " in " + first.name + ", " + b.dump() + " in " +
                                       other.name);
    }
}

// "" where the entry names the file beside the manifest that its frame has to have; otherwise a sentence.
std::string misnamed(const ReadManifest &manifest, const ReadManifest::Entry &entry)
{
    const std::string frame =
        manifest.name + ": frame " + std::to_string(entry.frame) + " is " + Json(entry.file).dump();
    if (fs::path(entry.file).filename() != entry.file || entry.file == "." || entry.file == "..")
        return frame + ", which is no name of a file beside the manifest";
    const std::string wanted = frame_path(manifest.pattern, entry.frame);
    return entry.file == wanted ? "" : frame + " instead of " + Json(wanted).dump();
}

}  // namespace

std::string array_words(const std::vector<int> &frames)
{
    std::string words;
    for (size_t i = 0; i < frames.size();) {
        size_t last = i;
        while (last + 1 < frames.size() && frames[last + 1] == frames[last] + 1) ++last;
        words += (words.empty() ? "" : ",") + std::to_string(frames[i]);
        if (last > i) words += "-" + std::to_string(frames[last]);
        i = last + 1;
    }
    return words;
}

Manifest::Manifest(std::string path, Json about, const std::vector<int> &asked, const std::string &out)
    : path_(std::move(path)), about_(std::move(about)), pattern_(relative(out, path_))
{
    for (const int frame : asked) asked_ += (asked_.empty() ? "" : ",") + std::to_string(frame);
    std::error_code none;
    if (!fs::exists(path_, none)) return;
    const Json older = parsed(path_);
    if (!is_manifest(older)) throw scenes::Failure(path_ + " is there and is no manifest");
    const ReadManifest before = read_manifest(path_, older);
    if (before.about != about_ || before.pattern != pattern_) return;
    for (const ReadManifest::Entry &one : before.entries) entries_[one.frame] = {one.file, one.sha256};
}

bool Manifest::has(int frame, const std::string &file) const
{
    const auto found = entries_.find(frame);
    return found != entries_.end() && found->second.file == relative(file, path_) &&
           is_still(file, found->second.sha256);
}

void Manifest::add(int frame, const std::string &file)
{
    entries_[frame] = {relative(file, path_), sha256_of_file(file)};
    write();
}

void Manifest::write() const
{
    Json json;
    json[mark] = manifest_version;
    json["about"] = about_;
    json["asked"] = asked_;
    json["pattern"] = pattern_;
    json["frames"] = Json::array();
    for (const auto &[frame, entry] : entries_)
        json["frames"].push_back({{"frame", frame}, {"file", entry.file}, {"sha256", entry.sha256}});
    write_whole(path_, json.dump(1) + "\n");
}

FilmReport check_film(const std::string &folder, const std::vector<int> &wanted)
{
    std::vector<std::string> paths;
    std::error_code wrong;
    for (const fs::directory_entry &one : fs::directory_iterator(folder, wrong))
        if (one.path().extension() == ".json") paths.push_back(one.path().string());
    if (wrong) throw scenes::Failure(folder + " could not be read: " + wrong.message());
    std::sort(paths.begin(), paths.end());
    std::vector<ReadManifest> manifests;
    for (const std::string &path : paths)
        if (const Json json = parsed(path); is_manifest(json)) manifests.push_back(read_manifest(path, json));
    if (manifests.empty()) throw scenes::Failure(folder + " has no manifest: render with --manifest makes one");

    FilmReport report;
    std::set<int> expected(wanted.begin(), wanted.end());
    std::map<int, std::string> whole;  // SHA-256 of each
    std::map<std::string, int> named;  // files, and the frame of each
    for (const ReadManifest &one : manifests) {
        if (!is_frame_pattern(one.pattern))
            throw scenes::Failure(folder + "/" + one.name + " does not say how its files are named: draw it anew");
        compare_about(manifests[0], one, report);
        if (wanted.empty()) expected.insert(one.asked.begin(), one.asked.end());
        std::set<int> own;
        for (const ReadManifest::Entry &entry : one.entries) {
            const auto frame_of_file = named.try_emplace(entry.file, entry.frame).first;
            std::string wrong_name = misnamed(one, entry);
            if (wrong_name.empty() && (!own.insert(entry.frame).second || frame_of_file->second != entry.frame))
                wrong_name = one.name + " has " + Json(entry.file).dump() + " a second time";
            if (!wrong_name.empty()) {
                report.sentences.push_back(wrong_name);
                continue;
            }
            const std::string path = whole_path(entry.file, folder + "/" + one.name);
            if (!is_still(path, entry.sha256)) {
                report.sentences.push_back(path + (fs::exists(path) ? " was changed after it was drawn" : " is gone"));
                continue;
            }
            const auto [at, fresh] = whole.try_emplace(entry.frame, entry.sha256);
            if (!fresh && at->second != entry.sha256)
                report.sentences.push_back("frame " + std::to_string(entry.frame) + " was drawn twice, differently");
        }
    }
    for (const int frame : expected)
        if (!whole.count(frame)) report.missing.push_back(frame);
    report.whole = expected.size() - report.missing.size();
    return report;
}

}  // namespace cli
