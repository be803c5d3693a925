// What all people of a process share: their library, their renderers and a troupe for each root.
#pragma once

#include <memory>
#include <mutex>

#include "samples/hosts/osg/plugin/renderers.h"
#include "samples/hosts/osg/plugin/troupe_drawable.h"

namespace osg_plugin
{

class Company
{
public:
    // That of this process. It is never destroyed: programs keep nodes in variables of their own that end after the
    // libraries that a company needs.
    static Company &shared();

    scenes::Library &library() { return library_; }
    // Of troupes and renderers: several threads may cull and draw views.
    std::mutex &mutex() { return mutex_; }

    // A member lives as long as the company. Throws scenes::Failure.
    const Member &engage(const PersonFile &file);
    TroupeDrawable &troupe(osg::Node &root);

    // The renderer of the current context, with the textures of all members. Under the mutex. Throws scenes::Failure.
    clq_renderer *renderer(osg::State &state);
    // The context of this state ends, and is current.
    void release(osg::State &state);

private:
    Company();

    scenes::Library library_;
    std::mutex mutex_;
    Renderers renderers_;
    std::vector<std::unique_ptr<Member>> members_;
    struct Entry {
        osg::observer_ptr<osg::Node> root;
        osg::ref_ptr<TroupeDrawable> troupe;
    };
    std::map<const osg::Node *, Entry> troupes_;
};

}  // namespace osg_plugin
