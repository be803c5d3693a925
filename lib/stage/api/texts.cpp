// Files in, and timetables.
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "lib/stage/api/boundary.h"
#include "lib/stage/api/stage_handle.h"
#include "lib/stage/machine/document.h"

namespace claque::stage
{

namespace
{

struct Descriptor {
    ~Descriptor() { close(number); }
    int number;
};

// A name may lead to a pipe without a writer, a device without an end, or a folder. With O_NONBLOCK, opening such a
// pipe does not wait.
std::string read_file(const char *path)
{
    const Descriptor file = {open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC)};
    struct stat facts = {};
    if (file.number < 0 || fstat(file.number, &facts) != 0)
        fail(CLQ_IO, "%s cannot be opened: %s", path, std::strerror(errno));
    if (!S_ISREG(facts.st_mode)) fail(CLQ_IO, "%s is not a regular file", path);
    std::string bytes;
    char piece[16384];
    for (ssize_t got; (got = read(file.number, piece, sizeof piece)) != 0;) {
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail(CLQ_IO, "%s cannot be read: %s", path, std::strerror(errno));
        bytes.append(piece, static_cast<size_t>(got));
        if (bytes.size() > max_text_bytes) fail(CLQ_LIMIT, "%s has more than %zu bytes", path, max_text_bytes);
    }
    return bytes;
}

void read_entry(const Document &document, const toml::table &from, Vocabulary &shared, double offset_s, Entry &made)
{
    document.known(from, {"at", "send", "value", "class", "radius", "position", "per_m", "every", "times"});
    const toml::node *at = from.get("at"), *send = from.get("send");
    if (!at || !send) document.refuse(from, "an event needs 'at' and 'send'");
    Task &task = made.task;
    task.kind = TaskKind::spread;
    task.due_s = offset_s + document.number(*at, "at", -1e9, 1e9);
    const std::string name = document.string(*send, "send");
    task.index = shared.find_event(name);
    if (task.index == none) document.refuse(*send, "no machine declares an event '" + name + "'");
    task.priority = shared.events[task.index].priority;
    task.has_place = 1;
    if (const toml::node *value = from.get("value")) task.value = document.number(*value, "value");
    if (const toml::node *radius = from.get("radius")) task.radius_m = document.number(*radius, "radius", 0, 1e6);
    if (const toml::node *per_m = from.get("per_m")) task.per_m_s = document.number(*per_m, "per_m", 0, 1e6);
    if (const toml::node *of = from.get("class")) task.agent_class = shared.add_class(document.string(*of, "class"));
    if (const toml::node *position = from.get("position")) document.point(*position, "position", task.place);
    if (const toml::node *every = from.get("every")) made.every_s = document.number(*every, "every", 0.01, 1e9);
    const toml::node *times = from.get("times");
    if (!times) return;
    if (made.every_s == 0) document.refuse(*times, "'times' belongs to 'every'");
    made.times = document.whole(*times, "times", 1, 1000000000);
}

}  // namespace

Text read_text(const clq_stage_text *source)
{
    Text out;
    out.name = source->path ? source->path : source->name ? source->name : "text";
    if (source->path) {
        out.bytes = read_file(source->path);
        return out;
    }
    require(source->text || source->text_bytes == 0, "the text has neither a path nor bytes");
    if (source->text_bytes > max_text_bytes)
        fail(CLQ_LIMIT, "%s has %zu bytes: %zu are the most", out.name.c_str(), source->text_bytes, max_text_bytes);
    out.bytes.assign(source->text ? source->text : "", source->text_bytes);
    return out;
}

std::vector<Entry> read_timetable(const Text &text, Vocabulary &shared, double offset_s)
{
    const Document document(text.bytes, text.name);
    document.known(document.root(), {"event"});
    std::vector<Entry> made;
    if (const toml::node *all = document.root().get("event"))
        for (const toml::node &one : document.list(*all, "event")) {
            made.emplace_back();
            read_entry(document, document.table(one, "an event"), shared, offset_s, made.back());
        }
    return made;
}

}  // namespace claque::stage
