// The libraries that a build may lack (cmake/parts.cmake): decoders of compressed data, and readers of XML, SQL and
// gzip.
#pragma once

#include <string>
#include <string_view>

namespace claque::asset
{

enum class Decoder { draco, meshopt, webp };

bool has_decoder(Decoder decoder);

// The decoder that an extension of glTF needs; false if it needs none.
bool decoder_of(std::string_view extension, Decoder &out);

// Throws base::Error (CLQ_UNSUPPORTED): `what` needs the decoder, and the build has others. Names all of them.
[[noreturn]] void refuse_without(Decoder decoder, const std::string &what);

// Throws base::Error (CLQ_UNSUPPORTED): `what` is read by a library that the build lacks.
[[noreturn]] void refuse_without_library(const char *what, const char *library);

}  // namespace claque::asset
