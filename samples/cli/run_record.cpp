#include "samples/cli/run_record.h"

#include <unistd.h>
#include <utility>

#include "samples/io/ending.h"
#include "samples/io/files.h"
#include "samples/scenes/check.h"

namespace cli
{

std::string check_record_name(const std::string &name)
{
    if (io::ending_of(name) == ".clt") return "";
    return "'" + name +
           "' would hold a record, so its name must end in .clt; `claque play` draws it, and --out gets pictures";
}

RunRecord::RunRecord(const std::string &path) : path_(path), draft_(io::draft_of(path)), unfinished_(draft_)
{
    unlink(draft_.c_str());  // of a process that was killed
    const int draft = io::open_draft(draft_, path_);
    file_ = draft < 0 ? nullptr : fdopen(draft, "wb");
    if (!file_) throw scenes::Failure(io::why(path_, "written"));
}

RunRecord::~RunRecord()
{
    if (crowd_) clq_crowd_end_recording(crowd_, nullptr);
    if (file_) std::fclose(file_);
    if (!kept_) unlink(draft_.c_str());
}

int RunRecord::write(void *user, const void *bytes, size_t size)
{
    return std::fwrite(bytes, 1, size, static_cast<std::FILE *>(user)) == size ? 0 : 1;
}

void RunRecord::begin(clq_crowd *crowd)
{
    clq_recording_def def = clq_recording_def_init();
    def.write = write, def.user = file_;
    scenes::check(clq_crowd_begin_recording(crowd, &def), path_);
    crowd_ = crowd;
}

clq_recording_info RunRecord::end()
{
    clq_recording_info info = clq_recording_info_init();
    scenes::check(clq_crowd_end_recording(std::exchange(crowd_, nullptr), &info), path_);
    const bool written = std::fflush(file_) == 0 && fsync(fileno(file_)) == 0;
    if (std::fclose(std::exchange(file_, nullptr)) != 0 || !written) throw scenes::Failure(io::why(path_, "written"));
    if (std::rename(draft_.c_str(), path_.c_str()) != 0) throw scenes::Failure(io::why(path_, "written"));
    kept_ = true;
    return info;
}

}  // namespace cli
