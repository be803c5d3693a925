// The exported entry by which libclaque-assets passes a Model to libclaque; it is in no public header.
//
// A Model is a C++ object, which two libraries may share if both were built from the same sources by the same compiler
// with the same standard library. The build id checks this: if it differs, the Model is not read. libclaque only reads
// the Model, and neither library frees memory of the other.
#pragma once

#include <claque/template.h>

#include "lib/model/model.h"

extern "C" {

// Splits a model as clq_template_build splits a host's own arrays. `build_id` is that of the caller (build_id.h).
//   max_texture_px   0: 1024
// Fails with UNSUPPORTED (another build; the message names both ids), and as clq_template_build.
CLQ_API clq_status clq_private_template_from_model(clq_context *context, const char *build_id,
                                                   const claque::model::Model *model, uint32_t max_texture_px,
                                                   clq_template **out);

}  // extern "C"
