// A folder of labels. All of its pictures are of the same settings: others are refused.
#pragma once

#include <set>
#include <string>

#include "samples/labels/formats.h"
#include "samples/labels/frame_json.h"

namespace cli
{

class LabelFolder
{
public:
    // settings: what labels depend on. Throws scenes::Failure if the folder has labels of other settings: the sentence
    // has the first that differs. `again`: they are replaced, and no picture is kept.
    LabelFolder(std::string path, const labels::Json &settings, bool again);

    // Writes settings.json, before the first picture.
    void begin() { write({"settings.json", settings_}); }
    // The first file in a folder removes what killed processes left there.
    void write(const labels::FrameFile &file);
    // What a picture says that is labelled already; empty: it is not, or one of its files is not what was written.
    labels::Json kept(int frame) const;
    // Writes a picture: its files, and then what it says, with the SHA-256 of each. With that the picture is whole.
    labels::Json take(const std::vector<labels::FrameFile> &files, labels::Json about_frame);

private:
    std::string path_, settings_, settings_hash_;
    bool again_;
    std::set<std::string> tidied_;
};

}  // namespace cli
