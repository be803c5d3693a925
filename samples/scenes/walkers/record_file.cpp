#include "samples/scenes/walkers/record_file.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "samples/io/regular_file.h"

namespace scenes::walkers
{

RecordFile::RecordFile(Library &library, const std::string &file)
{
    if (const std::string wrong = bytes.open(file); !wrong.empty()) throw Failure(wrong);
    clq_record *made = nullptr;
    check(clq_record_open(library.context(), bytes.data(), bytes.size(), &made), file);
    record.reset(made);
    check(clq_record_get_info(made, &info));
    if (info.step_count == 0) throw Failure(file + ": nothing was shown in this record: it has no update");
    if (info.whole) return;
    char text[160];
    std::snprintf(text, sizeof text,
                  " was cut off: %.2f s of the run could be read, from %.2f to %.2f s; the end that says how long it "
                  "was is gone",
                  info.end_s - info.start_s, info.start_s, info.end_s);
    clq_context_log(library.context(), CLQ_LOG_WARNING, (file + text).c_str());
}

bool is_record(const std::string &file)
{
    static const char magic[8] = {'c', 'l', 'a', 'q', 'u', 'e', 'R', 0x1a};
    char found[8] = {};
    const io::RegularFile in(file, io::most_record_bytes);
    return in.wrong().empty() && in.read(0, found, sizeof found) && std::memcmp(found, magic, sizeof magic) == 0;
}

RecordCast::RecordCast(Library &library, const RecordFile &file, const std::vector<SocialClass> &characters)
{
    clq_record *record = file.record.get();
    for (const SocialClass &one : characters) own_.push_back(template_of_file(library, one));
    for (const Own<clq_template> &own : own_) templates_.push_back(own.get());
    std::vector<std::string> builtins;
    for (uint32_t i = 0; i < file.info.template_count; ++i) {
        const std::string name = clq_record_get_template_name(record, i);
        if (is_builtin(name) && std::find(builtins.begin(), builtins.end(), name) == builtins.end())
            builtins.push_back(name);
    }
    for (const std::string &name : builtins) templates_.push_back(library.builtin(name));
    if (give(record) == CLQ_OK) return;
    for (const std::string &name : builtins)
        if (is_person(name)) templates_.push_back(library.builtin(name, {}));  // what flies has its own
    if (give(record) == CLQ_OK) return;
    for (const bool levels : {true, false})
        for (const std::string &name : builtins)
            if (is_person(name)) templates_.push_back(library.looking(name, levels));
    if (give(record) != CLQ_OK)
        throw Failure(std::string(clq_last_error()) +
                      "; --characters names the files of characters, and --turn, --height and --scale place them "
                      "as in the run");
}

clq_status RecordCast::give(clq_record *record) const
{
    return clq_record_set_templates(record, templates_.data(), static_cast<uint32_t>(templates_.size()));
}

}  // namespace scenes::walkers
