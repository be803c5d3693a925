// One clq_context with threads, whose warnings are collected.
#pragma once

#include <claque/prepare.h>

#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "samples/scenes/check.h"
#include "samples/scenes/tasks_tbb.h"

namespace scenes
{

// Whether libclaque-assets has a built-in character of this name.
bool is_builtin(const std::string &name);
bool is_person(const std::string &name);  // one of its four people
extern const std::vector<std::string> person_names;

// Triangles of the coarser levels in scenes that do not take claque's usual ones. The multitude: S3's have a fifth and
// a tenth of a finest one that is five times ours. The amphitheatre: the last two are for people of up to six pixels.
extern const std::vector<uint32_t> multitude_levels, amphitheatre_levels;

class Library
{
public:
    explicit Library(int threads);

    clq_context *context() const { return context_.get(); }
    // A built-in character, made at the first request or read from the user's cache folder (claque/prepare.h). It lives
    // as long as the library. Call it from one thread at a time.
    clq_template *builtin(const std::string &name);
    // The same with coarser levels of detail of about these numbers of triangles, descending; empty: claque's usual
    // ones (claque/levels.h), or those of its own that an owl and a herald have.
    clq_template *builtin(const std::string &name, const std::vector<uint32_t> &levels);
    // The same with degrees of freedom of neck and head, so that a gaze turns it. `levels`: with claque's usual
    // levels of detail.
    clq_template *looking(const std::string &name, bool levels);
    // A character of the caller's own: `make` is called at the first request of the name.
    clq_template *own(const std::string &name, const std::function<Own<clq_template>()> &make);
    // The template in a prepared file. Its colours are chosen already, which a warning says where others are wanted.
    Own<clq_template> load_prepared(const std::string &path, clq_colours wanted = CLQ_COLOURS_NEAR);
    // Makes a template, or takes the one that another process made (share_templates).
    Own<clq_template> shared(const std::function<Own<clq_template>()> &make);
    std::vector<std::string> warnings() const;  // each once
    // `hear` is told the warnings of every library of the process too; NULL: none. To be set before the first is made.
    static void hear_warnings(void (*hear)(const std::string &text));

    // For processes that make the same templates in the same order. From now on `exchange` sees the bytes of each as
    // clq_template_save writes them: those that this process made if it `makes` them, else none, to be filled in.
    using Exchange = std::function<void(std::string &bytes)>;
    void share_templates(bool makes, Exchange exchange);

private:
    mutable std::mutex mutex_;
    std::vector<std::string> warnings_;
    TbbTasks tasks_;
    Own<clq_context> context_;
    std::map<std::string, Own<clq_template>> templates_;
    bool makes_ = true;
    Exchange exchange_;  // or none
};

}  // namespace scenes
