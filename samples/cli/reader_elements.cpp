// The elements of all formats for `claque bench readers`, and how characters are read and built.
#include <claque/assets.h>

#include "samples/cli/reader_files.h"

namespace cli
{

std::string outcome_of(clq_status status) { return status == CLQ_OK ? "ok" : clq_status_name(status); }

namespace
{

Reading read_and(bool build, scenes::Library &library, const std::string &bytes)
{
    Reading out;
    clq_asset *asset = nullptr;
    clq_template *made = nullptr;
    const double begin = processor_ms();
    out.loaded = outcome_of(clq_asset_load(library.context(), bytes.data(), bytes.size(), nullptr, &asset));
    const double middle = processor_ms();
    out.load_ms = middle - begin;
    if (asset && build) {
        out.built = outcome_of(clq_asset_build(library.context(), asset, 0, &made));
        out.build_ms = processor_ms() - middle;
    }
    clq_template_destroy(made);
    clq_asset_destroy(asset);
    return out;
}

}  // namespace

Reading read_asset(scenes::Library &library, const std::string &bytes) { return read_and(true, library, bytes); }
Reading read_clips(scenes::Library &library, const std::string &bytes) { return read_and(false, library, bytes); }

std::vector<ReaderElement> reader_elements()
{
    std::vector<ReaderElement> all;
    for (const auto &source :
         {reader_elements_of_assets, reader_elements_of_saves, reader_elements_of_records, reader_elements_of_pictures,
          reader_elements_of_captures, reader_elements_of_tracks, reader_elements_of_areas,
#ifdef CLAQUE_STAGED
          reader_elements_of_machines,
#endif
          reader_elements_of_others})
        for (const ReaderElement &element : source()) all.push_back(element);
    return all;
}

}  // namespace cli
