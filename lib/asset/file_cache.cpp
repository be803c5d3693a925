#include "lib/asset/file_cache.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <unordered_set>

#include "lib/asset/cache_folder.h"
#include "lib/asset/file.h"
#include "lib/asset/glb.h"
#include "lib/asset/json_view.h"
#include "lib/asset/uri.h"
#include "lib/base/error.h"
#include "lib/base/hash.h"

namespace claque::asset
{

namespace
{

// The URIs of buffers and images of a glTF file, as far as it can be parsed.
std::vector<std::string> uris_of(const uint8_t *bytes, uint64_t size, uint64_t memory_bytes)
{
    std::vector<std::string> uris;
    try {
        const Container container = open_container(bytes, size);
        const JsonDocument document(container.json, container.json_size, memory_bytes);
        for (const char *kind : {"buffers", "images"}) {
            const JsonView list = document.root()[kind];
            for (size_t i = 0; i < list.count(); ++i)
                if (const JsonView uri = list.at(i)["uri"]; uri.exists() && !is_data_uri(uri.text()))
                    uris.push_back(uri.text());
        }
    } catch (const base::Error &) {
        // The file is not glTF, or is one that the glTF reader refuses.
    }
    return uris;
}

}  // namespace

ContentHash::ContentHash() : a_(base::fnv_start), b_(base::mix(base::fnv_start)) {}

void ContentHash::add(const void *bytes, uint64_t size)
{
    a_ = base::fnv(base::fnv(a_, &size, sizeof size), bytes, size);
    b_ = base::mix(base::fnv(base::fnv(b_, bytes, size), &size, sizeof size));
}

std::string ContentHash::hex() const
{
    char text[40];
    std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(a_),
                  static_cast<unsigned long long>(b_));
    return text;
}

void add_bytes(const void *bytes, uint64_t size, const std::string &folder, uint64_t limit_bytes,
               ContentHash &content_hash)
{
    content_hash.add(bytes, size);
    if (folder.empty()) return;
    std::unordered_set<std::string> read;  // each file once, however often and however it is named
    for (const std::string &uri : uris_of(static_cast<const uint8_t *>(bytes), size, limit_bytes)) {
        try {
            const std::string name = std::filesystem::path(decode_relative_path(uri)).lexically_normal().string();
            if (!read.insert(name).second) continue;
            const std::vector<uint8_t> there = read_file(folder + "/" + name, limit_bytes);
            content_hash.add(there.data(), there.size());
        } catch (const base::Error &) {
            content_hash.add(uint64_t(0));
        }
    }
}

void add_file(const std::string &path, const std::string &folder, uint64_t limit_bytes, ContentHash &content_hash)
{
    const std::vector<uint8_t> bytes = read_file(path, limit_bytes);
    add_bytes(bytes.data(), bytes.size(), folder, limit_bytes, content_hash);
}

std::string user_cache_folder()
{
    const char *cache = std::getenv("XDG_CACHE_HOME"), *home = std::getenv("HOME");
    if (cache && *cache == '/') return std::string(cache) + "/claque";
    if (home && *home == '/') return std::string(home) + "/.cache/claque";
    return "";
}

std::vector<uint8_t> read_cached(const std::string &folder, const std::string &name)
{
    try {
        return CacheFolder(folder).read(name);
    } catch (const base::Error &) {
        return {};
    }
}

std::string write_cached(const std::string &folder, const std::string &name, const std::vector<uint8_t> &bytes)
{
    try {
        CacheFolder(folder).write(name, bytes);
        return "";
    } catch (const base::Error &error) {
        return error.what();
    }
}

}  // namespace claque::asset
