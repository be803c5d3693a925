// The file of a shared object that may be loaded. Files name mechanisms, and only the command's option
// --allow-mechanisms says that they are programs one trusts, so SharedMechanism takes nothing else.
#pragma once

#include <string>

namespace scenes::roles
{

class MechanismFile
{
public:
    MechanismFile() = default;  // none
    // `folder`: of --allow-mechanisms; empty: it was not given. Throws Failure unless the file, once links are
    // resolved, is in the folder or below.
    MechanismFile(const std::string &folder, const std::string &file);

    bool empty() const { return path_.empty(); }
    const std::string &path() const { return path_; }  // without links

    bool operator==(const MechanismFile &other) const { return path_ == other.path_; }
    bool operator!=(const MechanismFile &other) const { return path_ != other.path_; }

private:
    std::string path_;
};

}  // namespace scenes::roles
