// A prepared template as bytes, so that a host need not split again. Little-endian whatever the machine:
//   8 bytes magic, u32 version, u32 zero, u64 bytes that follow, u64 FNV-1a of them; then the template in the order of
//   template.h, every array with its length in front.
// A file is of one version; others are refused and made anew from the source.
#pragma once

#include "lib/model/template.h"

namespace claque::model
{

constexpr uint32_t template_file_version = 5;

// Appends to `out`. The same template gives the same bytes. Throws std::bad_alloc.
void save(const Template &tmpl, std::pmr::vector<uint8_t> &out);

// The bytes may be anything. `out` is empty, made on the memory that the template shall live on; after a throw it is
// good for nothing but destruction. Nothing is allocated that the bytes could not fill. Throws base::Error (FORMAT: cut
// off, changed, of another version, or not a template that check() passes) or std::bad_alloc.
void load(const uint8_t *bytes, size_t size, Template &out);

}  // namespace claque::model
