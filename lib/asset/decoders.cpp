#include "lib/asset/decoders.h"

#include "lib/base/error.h"

namespace claque::asset
{

namespace
{

#ifdef CLAQUE_HAS_DRACO
constexpr bool has_draco = true;
#else
constexpr bool has_draco = false;
#endif
#ifdef CLAQUE_HAS_MESHOPT
constexpr bool has_meshopt = true;
#else
constexpr bool has_meshopt = false;
#endif
#ifdef CLAQUE_HAS_WEBP
constexpr bool has_webp = true;
#else
constexpr bool has_webp = false;
#endif

struct Known {
    Decoder decoder;
    const char *extension, *library;
    bool built;
};
constexpr Known known_decoders[] = {{Decoder::draco, "KHR_draco_mesh_compression", "libdraco", has_draco},
                                    {Decoder::meshopt, "EXT_meshopt_compression", "libmeshoptimizer", has_meshopt},
                                    {Decoder::webp, "EXT_texture_webp", "libwebp", has_webp}};

const Known &known_of(Decoder decoder) { return known_decoders[static_cast<size_t>(decoder)]; }

std::string built_in()
{
    std::string names;
    for (const Known &known : known_decoders)
        if (known.built) names += std::string(names.empty() ? "" : " and ") + known.library;
    return names.empty() ? "without any decoder" : "with " + names + " only";
}

}  // namespace

bool has_decoder(Decoder decoder) { return known_of(decoder).built; }

bool decoder_of(std::string_view extension, Decoder &out)
{
    for (const Known &known : known_decoders)
        if (extension == known.extension) {
            out = known.decoder;
            return true;
        }
    return false;
}

void refuse_without(Decoder decoder, const std::string &what)
{
    const Known &known = known_of(decoder);
    base::fail(CLQ_UNSUPPORTED, "%s needs %s, which %s decodes: this libclaque-assets was built %s", what.c_str(),
               known.extension, known.library, built_in().c_str());
}

void refuse_without_library(const char *what, const char *library)
{
    base::fail(CLQ_UNSUPPORTED, "%s is read by %s, and this libclaque-assets was built without it", what, library);
}

}  // namespace claque::asset
