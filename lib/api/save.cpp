// Saves and restores crowds.
#include "lib/crowd/save.h"

#include <claque/save.h>

#include "lib/api/boundary.h"
#include "lib/api/host_resolver.h"
#include "lib/api/recorder.h"

using namespace claque;

namespace
{

class HostSink : public base::Sink
{
public:
    HostSink(clq_write_function write, void *user) : write_(write), user_(user) {}
    void take(const uint8_t *bytes, size_t count) override
    {
        if (!api::host_takes(write_, user_, bytes, count))
            base::fail(CLQ_IO, "the writer refused %zu bytes of a saved crowd, after %zu that it took", count, taken_);
        taken_ += count;
    }

private:
    clq_write_function write_;
    void *user_;
    size_t taken_ = 0;
};

}  // namespace

extern "C" {

clq_status clq_crowd_save(const clq_crowd *crowd, clq_write_function write, void *user)
{
    return api::boundary("clq_crowd_save", [&] {
        api::require(crowd && write, "crowd or write is NULL");
        const api::Busy busy(crowd);
        HostSink sink(write, user);
        crowd::save(crowd->crowd, sink);
    });
}

clq_status clq_crowd_restore(clq_crowd *crowd, const void *bytes, size_t size_bytes, clq_template *const *templates,
                             uint32_t template_count)
{
    return api::boundary("clq_crowd_restore", [&] {
        api::require(crowd && bytes, "crowd or bytes is NULL");
        const api::Busy busy(crowd);
        api::check_templates(crowd->context, templates, template_count);
        api::HostResolver resolver(*crowd, templates, template_count);
        api::restore_state(crowd, static_cast<const uint8_t *>(bytes), size_bytes, resolver);
        api::changed_by(crowd, [](api::Recorder &to) { to.restored(); });
    });
}

}  // extern "C"
