// A glTF 2.0 file's JSON, buffers and accessors, for trusted test files only: what is wrong throws whatever the
// standard library or nlohmann-json throws. Part of the reference; see gltf_reference.h.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace claque::reference
{

class GltfFile
{
public:
    // .gltf or .glb, told apart by content. External buffers are read from the file's own folder.
    explicit GltfFile(const std::string &path);

    const nlohmann::json &json() const { return json_; }

    // json[name] as an array; an empty one where it is absent.
    const nlohmann::json &list(const char *name) const;

    // All components of an accessor in a row, normalised types mapped to [0, 1] or [-1, 1], sparse ones filled in.
    std::vector<double> numbers(size_t accessor) const;

private:
    void load_buffer(const nlohmann::json &buffer, const std::string &folder);
    // The byte of a buffer that a view and an offset into it name.
    const unsigned char *address(size_t view, size_t offset_bytes) const;

    nlohmann::json json_;
    std::vector<std::vector<unsigned char>> buffers_;
    std::vector<unsigned char> glb_chunk_;
};

}  // namespace claque::reference
