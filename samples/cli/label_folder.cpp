#include "samples/cli/label_folder.h"

#include <filesystem>

#include "samples/cli/files.h"
#include "samples/cli/provenance.h"
#include "samples/cli/scene_about.h"
#include "samples/io/files.h"
#include "samples/io/json.h"
#include "samples/labels/frame_files.h"
#include "samples/scenes/check.h"

namespace cli
{
namespace
{

namespace fs = std::filesystem;

// Null or discarded: no such file, no JSON, or nested deeper than any file of labels.
labels::Json read_json(const fs::path &path)
{
    std::error_code none;
    if (!fs::is_regular_file(path, none)) return {};
    std::string problem;
    return io::parse_json<labels::Json>(text_of(path.string()), problem);
}

// Of all but the hash itself.
std::string hash_of(labels::Json about)
{
    about.erase("itself");
    const std::string text = about.dump();
    return sha256_of(text.data(), text.size());
}

std::string name_of(int frame) { return "frames/" + labels::number_of(frame) + ".json"; }

}  // namespace

LabelFolder::LabelFolder(std::string path, const labels::Json &settings, bool again)
    : path_(std::move(path)),
      settings_(settings.dump(1) + "\n"),
      settings_hash_(sha256_of(settings_.data(), settings_.size())),
      again_(again)
{
    const labels::Json before = read_json(fs::path(path_) / "settings.json");
    if (before.is_object() && !again && before != settings)
        throw scenes::Failure(path_ + " has labels of other settings: " + difference(before, settings) +
                              "; choose another folder, or make all anew with --again");
}

void LabelFolder::write(const labels::FrameFile &file)
{
    const fs::path to = fs::path(path_) / file.path;
    std::error_code failed;
    fs::create_directories(to.parent_path(), failed);
    if (failed) throw scenes::Failure("cannot make the folder " + to.parent_path().string() + ": " + failed.message());
    if (tidied_.insert(to.parent_path().string()).second) io::remove_abandoned_drafts(to.parent_path().string());
    write_whole(to.string(), file.bytes);
}

labels::Json LabelFolder::kept(int frame) const
{
    if (again_) return {};
    labels::Json read = read_json(fs::path(path_) / name_of(frame));
    if (!read.is_object()) return {};
    if (read.value("settings", labels::Json()) != settings_hash_)
        throw scenes::Failure(path_ + " has labels of other settings for frame " + std::to_string(frame) +
                              "; make them anew with --again");
    if (read.value("itself", labels::Json()) != hash_of(read) || read["frame"] != frame) return {};
    for (const auto &[file, sha256] : read["files"].items())
        if (!is_still((fs::path(path_) / file).string(), sha256)) return {};
    return read;
}

labels::Json LabelFolder::take(const std::vector<labels::FrameFile> &files, labels::Json about_frame)
{
    about_frame["settings"] = settings_hash_;
    about_frame["files"] = labels::Json::object();
    for (const labels::FrameFile &file : files) {
        write(file);
        about_frame["files"][file.path] = sha256_of(file.bytes.data(), file.bytes.size());
    }
    about_frame["itself"] = hash_of(about_frame);
    write({name_of(about_frame["frame"].get<int>()), about_frame.dump() + "\n"});
    return about_frame;
}

}  // namespace cli
