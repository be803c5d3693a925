#include "samples/hosts/osg/plugin/company.h"

#include <algorithm>
#include <thread>

namespace osg_plugin
{

Company &Company::shared()
{
    static Company *const company = new Company;
    return *company;
}

Company::Company()
    : library_(static_cast<int>(std::max(1u, std::thread::hardware_concurrency()))), renderers_(library_.context())
{
}

const Member &Company::engage(const PersonFile &file)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    members_.push_back(std::make_unique<Member>(library_, file));
    return *members_.back();
}

TroupeDrawable &Company::troupe(osg::Node &root)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    Entry &entry = troupes_[&root];
    if (entry.root.get() == &root) return *entry.troupe;
    entry = {&root, new TroupeDrawable(*this)};  // also where another root was at this address
    return *entry.troupe;
}

clq_renderer *Company::renderer(osg::State &state)
{
    clq_renderer *renderer = renderers_.of(state);
    for (const std::unique_ptr<Member> &member : members_)
        scenes::check(clq_renderer_prepare(renderer, member->tmpl()));
    return renderer;
}

void Company::release(osg::State &state)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    renderers_.release(state);
}

}  // namespace osg_plugin
