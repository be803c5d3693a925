// Characters from the command line: a glTF or GLB file, a prepared file (.clq), or the name of a built-in character.
#pragma once

#include <string>
#include <vector>

#include "samples/cli/clip_arguments.h"
#include "samples/cli/file_arguments.h"
#include "samples/scenes/check.h"
#include "samples/scenes/library.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/social_classes.h"

namespace cli
{

struct LoadedCharacter {
    scenes::Own<clq_asset> asset;  // none for prepared files
    scenes::Own<clq_template> tmpl;
    uint32_t first_clip = 0;  // to show: of the added clips, where there are any
    bool one_clip = false;    // and no other
    scenes::Character character() const { return {tmpl.get(), first_clip, one_clip}; }
};

using scenes::is_prepared;
// Whether a file's name ends as those of formats that only `claque convert` reads. Its content decides.
bool is_other_format(const std::string &path);
// Whether a file is a character, by the ending of its name or, whatever that is, as GLB by its first bytes.
bool is_character_file(const std::string &path);

// With the file's own size where none is given. No warning then asks for another one: pictures of a character and
// transfers of its clips have the same result in any size.
FileArguments in_own_size(FileArguments of_file, const std::string &path);
// Both throw Failure with the path in the message. `first_clip`: the first to show, see add_clips.
scenes::Own<clq_asset> load_asset(scenes::Library &library, const std::string &path, const FileArguments &of_file = {},
                                  const ClipArguments &clips = {}, uint32_t *first_clip = nullptr);
// Levels of detail are made where `levels` says so and the character has none of its own; without added clips they come
// from the cache folder the next time.
LoadedCharacter load_character(scenes::Library &library, const std::string &path, const FileArguments &of_file = {},
                               const ClipArguments &clips = {}, scenes::Lod levels = scenes::Lod::off);

// The template in levels of detail, from the cache folder as above; NULL if the character has levels of its own or too
// much for any. `zones`: may be NULL.
clq_template *in_levels(scenes::Library &library, const std::string &path, const FileArguments &of_file,
                        const ClipArguments &clips, const clq_zone_map_def *zones = nullptr, uint32_t texture_px = 0);

clq_asset_info info_of(const clq_asset *asset);
clq_template_info info_of(const clq_template *tmpl);

}  // namespace cli
