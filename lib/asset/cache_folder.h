// A folder of files that only its owner may write. What another user has planted there is neither read nor followed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lib/asset/owned_folder.h"

namespace claque::asset
{

class CacheFolder
{
public:
    // Opens the folder and makes it, readable and writable for its owner alone, if it is missing. Throws base::Error
    // (CLQ_IO) with a sentence that says how to repair a folder that belongs to another user or that others may write.
    explicit CacheFolder(const std::string &path);

    std::vector<uint8_t> read(const std::string &name) const { return folder_.read(name); }
    // Writes the whole file or nothing, aside, and gives it its name when it is complete. Throws base::Error (CLQ_IO).
    void write(const std::string &name, const std::vector<uint8_t> &bytes) const;

private:
    OwnedFolder folder_;
};

}  // namespace claque::asset
