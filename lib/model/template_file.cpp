#include "lib/model/template_file.h"

#include "lib/base/file_header.h"
#include "lib/model/template_check.h"
#include "lib/model/template_fields.h"

namespace claque::model
{

namespace
{

constexpr base::FileForm form = {
    {'c', 'l', 'a', 'q', 'u', 'e', 'T', 0x1a}, template_file_version, "a prepared template"};

}

void save(const Template &tmpl, std::pmr::vector<uint8_t> &out)
{
    base::append_file<uint64_t>(form, out, [&](auto &archive) { walk_template(archive, tmpl); });
}

void load(const uint8_t *bytes, size_t size, Template &out)
{
    base::ArchiveReader<uint64_t> reader = base::open_file<uint64_t>(form, bytes, size);
    walk_template(reader, out);
    reader.end();
    try {
        check(out);
    } catch (const base::Error &error) {
        base::fail(CLQ_FORMAT, "a prepared template is no template: %s", error.what());
    }
    if (!out.motion.empty()) derive(out.rig, out.motion);
    for (Level &level : out.levels) plan_skinning(level);
}

}  // namespace claque::model
