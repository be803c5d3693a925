// A folder of labels. All of its pictures are of the same settings: others are refused.
#pragma once

#include <string>

#include "samples/labels/formats.h"
#include "samples/labels/frame_json.h"

namespace cli
{

class LabelFolder
{
public:
    // settings: what labels depend on. Writes them as settings.json, once. Throws scenes::Failure, and changes nothing,
    // if the folder has labels of other settings: the sentence has the first that differs. `again`: the settings
    // are replaced, and no picture is kept.
    LabelFolder(std::string path, const labels::Json &settings, bool again);

    void write(const labels::FrameFile &file) const;
    // What a picture says that is labelled already; empty: it is not.
    labels::Json kept(int frame) const;
    // The last file of a picture: with it the picture is whole.
    labels::Json conclude(labels::Json about_frame) const;

private:
    std::string path_, settings_hash_;
    bool again_;
};

}  // namespace cli
