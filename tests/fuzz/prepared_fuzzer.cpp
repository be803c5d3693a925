// Prepared templates, as they are and with a corrected header, so that changes of the body are read.
#include "lib/model/template_file.h"
#include "tests/api/saved_bytes.h"
#include "tests/fuzz/shown.h"

namespace
{

using namespace fuzzing;

void load(const Bytes &bytes)
{
    clq_context *context = new_context();
    clq_template *tmpl = nullptr;
    if (done(clq_template_load(context, bytes.data(), bytes.size(), &tmpl), {CLQ_FORMAT, CLQ_LIMIT})) {
        EXPECT_EQ(bytes_of(tmpl), bytes);
        show(context, tmpl);
        clq_template_destroy(tmpl);
    }
    end(context);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    if (size == 0) return 0;
    Bytes file(bytes, bytes + size);
    load(file);
    if (size < saved::header_bytes) return 0;
    const Bytes before = file;
    saved::forge(file);  // the header has the form of a saved crowd's
    saved::put(file, 8, claque::model::template_file_version, 8);
    if (file != before) load(file);
    return 0;
}
