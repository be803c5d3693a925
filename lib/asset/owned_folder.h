// A folder that is read only where its owners alone can have written.
#pragma once

#include <cstdint>
#include <string>
#include <sys/types.h>
#include <vector>

namespace claque::asset
{

// A file descriptor that is closed; negative: none.
class Handle
{
public:
    explicit Handle(int number) : number_(number) {}
    ~Handle();
    Handle(const Handle &) = delete;
    Handle &operator=(const Handle &) = delete;
    int number() const { return number_; }
    bool is_open() const { return number_ >= 0; }

private:
    int number_;
};

struct Owners {
    uid_t usual, other;
    const char *remedy;  // the end of a sentence about a file of somebody else: "name another folder"
};

class OwnedFolder
{
public:
    // Opens the folder. Throws base::Error (CLQ_IO), with a sentence that names it and the remedy, for one that cannot
    // be opened, that belongs to neither owner, that others may write, or that lies behind a link of somebody else.
    OwnedFolder(const std::string &path, const Owners &owners);

    // Empty: the file is not there. Throws base::Error (CLQ_IO), with a sentence that names the file, for one that
    // belongs to neither owner, that others may write, that is a link or no file, that is empty or cannot be read.
    std::vector<uint8_t> read(const std::string &name) const;

    const std::string &path() const { return path_; }
    int number() const { return handle_.number(); }

private:
    std::string path_;
    Owners owners_;
    Handle handle_;
};

}  // namespace claque::asset
