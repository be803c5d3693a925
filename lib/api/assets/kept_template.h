// Templates that are kept in a folder under names that say what they were made from.
#pragma once

#include <claque/prepare.h>

#include <functional>
#include <memory>
#include <string>

#include "lib/asset/file_cache.h"

namespace claque::api
{

struct Destroy {
    void operator()(clq_asset *asset) const { clq_asset_destroy(asset); }
    void operator()(clq_template *tmpl) const { clq_template_destroy(tmpl); }
};
using Asset = std::unique_ptr<clq_asset, Destroy>;
using Template = std::unique_ptr<clq_template, Destroy>;

struct KeptTemplate {
    Template tmpl;
    bool from_disk = false, stored = false;
    std::string why_not_stored;  // "" if it was, or if it came from disk, or if there is no folder
};

// The beginning of every name: the sources of this library, and the version of prepared files.
asset::ContentHash start_of_name();
void add_options(const clq_asset_options &options, asset::ContentHash &all);

// Loads the template from `folder`, or makes it and stores it there. `folder`: "" for none. `installed`: it may have
// been prepared with the library, and is then taken from there. Throws what `make` throws, and std::bad_alloc.
KeptTemplate kept_template(clq_context *context, bool installed, const std::string &folder,
                           const asset::ContentHash &name, const std::function<Template()> &make);

}  // namespace claque::api
