// The version, statuses as text, and this thread's last error. Allocates nothing, so that it works when memory is
// exhausted.
#include <claque/base.h>

#include <cstring>

namespace
{

thread_local char last_error_text[1024] = "";

}  // namespace

extern "C" {

uint32_t clq_version(void) { return CLQ_VERSION; }

const char *clq_status_name(clq_status status)
{
    static const char *const names[] = {
        "CLQ_OK",     "CLQ_ARGUMENT",    "CLQ_STRUCT_SIZE",    "CLQ_STALE_ID",   "CLQ_OUT_OF_MEMORY", "CLQ_LIMIT",
        "CLQ_FORMAT", "CLQ_UNSUPPORTED", "CLQ_KEY_RESOLUTION", "CLQ_GL_MISSING", "CLQ_GL_STATE",      "CLQ_BUSY",
        "CLQ_IN_USE", "CLQ_IO",          "CLQ_CALLBACK"};
    const unsigned number = static_cast<unsigned>(status);
    return number < sizeof names / sizeof names[0] ? names[number] : "CLQ_?";
}

const char *clq_last_error(void) { return last_error_text; }

clq_status clq_report(clq_status status, const char *text)
{
    std::strncpy(last_error_text, text ? text : "", sizeof last_error_text - 1);
    return status;
}

}  // extern "C"
