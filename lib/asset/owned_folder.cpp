#include "lib/asset/owned_folder.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "lib/base/error.h"

namespace claque::asset
{

namespace
{

constexpr uint64_t largest_entry = uint64_t(1) << 32;
constexpr mode_t others_may_write = S_IWGRP | S_IWOTH;

bool is_of(const Owners &owners, const struct stat &facts)
{
    return facts.st_uid == owners.usual || facts.st_uid == owners.other;
}

// Links that another user has made lead where that user wants.
void check_link(std::string path, const Owners &owners)
{
    // The system follows a link whose name ends in a slash.
    while (path.size() > 1 && path.back() == '/') path.pop_back();
    struct stat facts = {};
    if (lstat(path.c_str(), &facts) == 0 && S_ISLNK(facts.st_mode) && !is_of(owners, facts) && facts.st_uid != 0)
        base::fail(CLQ_IO, "'%s' is a link that user %u made: remove it, or %s", path.c_str(),
                   static_cast<unsigned>(facts.st_uid), owners.remedy);
}

void check_owner(const std::string &path, const struct stat &facts, const Owners &owners)
{
    if (!is_of(owners, facts))
        base::fail(CLQ_IO, "'%s' belongs to user %u, not to user %u: %s", path.c_str(),
                   static_cast<unsigned>(facts.st_uid), static_cast<unsigned>(owners.usual), owners.remedy);
    if (facts.st_mode & others_may_write)
        base::fail(CLQ_IO, "others may write there (mode %03o): 'chmod go-w %s' repairs that",
                   static_cast<unsigned>(facts.st_mode & 0777), path.c_str());
}

int opened(const std::string &path, const Owners &owners)
{
    check_link(path, owners);
    return open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

}  // namespace

Handle::~Handle()
{
    if (number_ >= 0) close(number_);
}

OwnedFolder::OwnedFolder(const std::string &path, const Owners &owners)
    : path_(path), owners_(owners), handle_(opened(path, owners))
{
    struct stat facts = {};
    if (!handle_.is_open() || fstat(number(), &facts) != 0)
        base::fail(CLQ_IO, "the folder '%s' cannot be used: %s; repair that, or %s", path.c_str(), std::strerror(errno),
                   owners.remedy);
    check_owner(path, facts, owners);
}

std::vector<uint8_t> OwnedFolder::read(const std::string &name) const
{
    const std::string path = path_ + "/" + name;
    const Handle file(openat(number(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    if (!file.is_open() && errno == ENOENT) return {};
    if (!file.is_open() && errno == ELOOP) base::fail(CLQ_IO, "'%s' is a link, and none is followed", path.c_str());
    struct stat facts = {};
    const auto fail = [&](const char *why) { base::fail(CLQ_IO, "'%s' cannot be read: %s", path.c_str(), why); };
    if (!file.is_open() || fstat(file.number(), &facts) != 0) fail(std::strerror(errno));
    if (!S_ISREG(facts.st_mode)) fail("it is no file");
    check_owner(path, facts, owners_);
    const uint64_t size = static_cast<uint64_t>(facts.st_size);
    if (size == 0) fail("it is empty");
    if (size > largest_entry) fail("it has more than 4 GiB");
    std::vector<uint8_t> bytes(size);
    for (size_t have = 0; have < bytes.size();) {
        const ssize_t got =
            ::read(file.number(), bytes.data() + have, std::min<size_t>(bytes.size() - have, size_t(1) << 30));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) fail(got < 0 ? std::strerror(errno) : "it became shorter");
        have += static_cast<size_t>(got);
    }
    return bytes;
}

}  // namespace claque::asset
