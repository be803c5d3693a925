// What the tests of converted characters share: one file, converted by claque and read by Assimp.
#pragma once

#include <claque/assets.h>

#include <memory>
#include <string>

#include <assimp/Importer.hpp>

#include "samples/convert/convert.h"
#include "samples/scenes/check.h"
#include "tests/convert/assimp_reference.h"

namespace convert_test
{

// In units of the file, as Assimp leaves them.
convert::Options as_it_is();

struct Both {
    scenes::Own<clq_context> context;
    scenes::Own<clq_asset> asset;  // converted, read by claque
    Assimp::Importer importer;
    std::unique_ptr<Reference> reference;

    explicit Both(const std::string &path);
    clq_asset_info info() const;
};

// In the rest pose and in every clip, at its ends and between: every vertex within 1e-4 of the size of where the
// reference has it. Returns the number of poses.
size_t expect_same_poses(Both &both, const std::string &name);

scenes::Own<clq_asset> read_glb(clq_context *context, const std::string &glb);
scenes::Own<clq_context> new_context();

}  // namespace convert_test
