// Serialises a prepared template, so that a host need not split it again: a header (base/file_header.h), then the
// template in the order of template.h, every array with its length in front.
// A file has one version; files of other versions are refused and made again from the source.
#pragma once

#include "lib/model/template.h"

namespace claque::model
{

constexpr uint32_t template_file_version = 6;

// Appends to `out`. Equal templates give equal bytes. Throws std::bad_alloc.
void save(const Template &tmpl, std::pmr::vector<uint8_t> &out);

// The bytes may be anything. `out` must be empty and made with the memory resource of the template; after an exception
// it can only be destroyed. Allocates no more than the bytes can fill. Throws base::Error (FORMAT: truncated, changed,
// of another version, or refused by check()) or std::bad_alloc.
void load(const uint8_t *bytes, size_t size, Template &out);

}  // namespace claque::model
