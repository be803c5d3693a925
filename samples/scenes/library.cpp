#include "samples/scenes/library.h"

#include <algorithm>

#include "samples/io/files.h"
#include "samples/scenes/placement.h"

namespace scenes
{

namespace
{

Own<clq_template> prepared(clq_context *context, const clq_prepare_def &def)
{
    clq_template *made = nullptr;
    check(clq_template_prepare(context, &def, &made, nullptr), def.builtin);
    return Own<clq_template>(made);
}

// A head turns about its own axes: y up, x to the left. Names as roles::faces_of finds them.
std::vector<clq_asset_dof> dofs_to_look_with()
{
    struct Turn {
        const char *node, *name;
        bool yaw;
        float most_rad;
    };
    std::vector<clq_asset_dof> dofs;
    for (const Turn &turn : {Turn{"spine_upper", "spine_yaw", true, 0.25f}, Turn{"neck", "neck_yaw", true, 0.55f},
                             Turn{"neck", "neck_pitch", false, 0.25f}, Turn{"head", "eyes_yaw", true, 0.6f},
                             Turn{"head", "eyes_pitch", false, 0.35f}}) {
        clq_asset_dof dof = clq_asset_dof_init();
        dof.node_name = turn.node, dof.dof.name = turn.name;
        // Turned about x, a head that looks up leans back: a negative angle.
        if (turn.yaw) dof.dof.axis[1] = 1;
        else dof.dof.axis[0] = -1;
        dof.dof.min = -turn.most_rad, dof.dof.max = turn.most_rad;
        dofs.push_back(dof);
    }
    return dofs;
}

int append(void *user, const void *bytes, size_t size)
{
    static_cast<std::string *>(user)->append(static_cast<const char *>(bytes), size);
    return 0;
}

constexpr size_t most_warnings = 1000;
void (*heard_by)(const std::string &) = nullptr;

}  // namespace

const std::vector<std::string> person_names = {"citizen", "patrician", "decurion", "plebeian"};
const std::vector<uint32_t> multitude_levels = {540, 270};
const std::vector<uint32_t> amphitheatre_levels = {606, 250, 120, 60, 30, 14, 10};

bool is_person(const std::string &name)
{
    return std::find(person_names.begin(), person_names.end(), name) != person_names.end();
}

bool is_builtin(const std::string &name) { return is_person(name) || name == "herald" || name == "owl"; }

Library::Library(int threads) : tasks_(threads)
{
    clq_context_def def = clq_context_def_init();
    def.tasks = tasks_.hook();
    def.log.user = this;
    def.log.write = [](void *user, clq_log_level level, const char *text) {
        if (level != CLQ_LOG_WARNING) return;
        Library *self = static_cast<Library *>(user);
        if (heard_by) heard_by(text);
        const std::lock_guard<std::mutex> lock(self->mutex_);
        std::vector<std::string> &all = self->warnings_;
        if (all.size() < most_warnings && std::find(all.begin(), all.end(), text) == all.end()) all.emplace_back(text);
    };
    clq_context *made = nullptr;
    check(clq_context_create(&def, &made));
    context_.reset(made);
}

void Library::hear_warnings(void (*hear)(const std::string &)) { heard_by = hear; }

clq_template *Library::own(const std::string &name, const std::function<Own<clq_template>()> &make)
{
    Own<clq_template> &found = templates_[name];
    if (!found) found = shared(make);
    return found.get();
}

void Library::share_templates(bool makes, Exchange exchange)
{
    makes_ = makes;
    exchange_ = std::move(exchange);
}

Own<clq_template> Library::load_prepared(const std::string &path, clq_colours wanted)
{
    if (wanted != CLQ_COLOURS_NEAR)
        clq_context_log(
            context(), CLQ_LOG_WARNING,
            (path + " keeps its colours, as it is prepared already: claque prepare takes --colours " + name_of(wanted))
                .c_str());
    std::string bytes;
    const std::string wrong = io::read_whole(path, bytes, io::most_file_bytes);
    if (!wrong.empty()) throw Failure(wrong);
    clq_template *loaded = nullptr;
    check(clq_template_load(context(), bytes.data(), bytes.size(), &loaded), path);
    return Own<clq_template>(loaded);
}

Own<clq_template> Library::shared(const std::function<Own<clq_template>()> &make)
{
    if (!exchange_) return make();
    Own<clq_template> made;
    if (makes_) made = make();
    std::string bytes;
    if (made) check(clq_template_save(made.get(), append, &bytes), "a template for other processes");
    exchange_(bytes);
    if (makes_) return made;
    clq_template *loaded = nullptr;
    check(clq_template_load(context(), bytes.data(), bytes.size(), &loaded), "a template of another process");
    return Own<clq_template>(loaded);
}

clq_template *Library::builtin(const std::string &name)
{
    clq_prepare_def def = clq_prepare_def_init();
    def.builtin = name.c_str();
    return own(name, [&] { return prepared(context(), def); });
}

clq_template *Library::builtin(const std::string &name, const std::vector<uint32_t> &levels)
{
    std::string key = name + " in levels";
    for (const uint32_t triangles : levels) key += "/" + std::to_string(triangles);
    clq_levels_def chain = clq_levels_def_init();
    if (!levels.empty()) chain.targets = levels.data();
    chain.target_count = static_cast<uint32_t>(levels.size());
    clq_prepare_def def = clq_prepare_def_init();
    def.builtin = name.c_str();
    if (is_person(name) || !levels.empty()) def.levels = &chain;  // what flies has levels of its own
    return own(key, [&] { return prepared(context(), def); });
}

clq_template *Library::looking(const std::string &name, bool levels)
{
    const std::vector<clq_asset_dof> dofs = dofs_to_look_with();
    const clq_levels_def chain = clq_levels_def_init();
    clq_prepare_def def = clq_prepare_def_init();
    def.builtin = name.c_str();
    def.dofs = dofs.data(), def.dof_count = static_cast<uint32_t>(dofs.size());
    if (levels) def.levels = &chain;
    return own(name + (levels ? " that looks, in levels" : " that looks"), [&] { return prepared(context(), def); });
}

std::vector<std::string> Library::warnings() const
{
    const std::lock_guard<std::mutex> lock(mutex_);
    return warnings_;
}

}  // namespace scenes
