// OpenSceneGraph's plugin for files that end in .claque: a description of people (person_file.h) or a scenario.
#include <claque/base.h>

#include <osg/Notify>
#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <osgDB/Registry>

#include "samples/hosts/osg/plugin/person_node.h"
#include "samples/hosts/osg/plugin/scenario_node.h"
#include "samples/scenes/roles/roles_scene.h"
#include "samples/scenes/walkers/scenario_walkers.h"
#ifdef CLAQUE_STAGED
#include "samples/stage/staged_scene.h"
#endif

namespace osg_plugin
{

// The plugin is a library on top of claque in a host of any floating-point settings: people stand in the same places
// under all of them.
class OwnFloats
{
public:
    OwnFloats() : entered_(clq_floats_enter()), differ_(clq_floats_differ()) {}
    ~OwnFloats()
    {
        if (entered_) clq_floats_leave();
        if (differ_)
            OSG_INFO << "claque: this program's floating-point settings count for nothing that claque computes\n";
    }
    OwnFloats(const OwnFloats &) = delete;
    OwnFloats &operator=(const OwnFloats &) = delete;

private:
    bool entered_, differ_;
};

class Reader : public osgDB::ReaderWriter
{
public:
    Reader()
    {
        supportsExtension("claque", "people, or a scenario, of claque");
        scenes::draw_tracks_with(scenes::walkers::make_scenario);
        scenes::draw_people_with(scenes::roles::make_scenario);
#ifdef CLAQUE_STAGED
        scenes::draw_stages_with(staged::make_scenario);
#endif
    }

    const char *className() const override { return "claque"; }

    ReadResult readNode(const std::string &name, const Options *options) const override
    {
        if (!acceptsExtension(osgDB::getLowerCaseFileExtension(name))) return ReadResult::FILE_NOT_HANDLED;
        const std::string path = osgDB::findDataFile(name, options);
        if (path.empty()) return ReadResult::FILE_NOT_FOUND;
        const OwnFloats own;
        try {
            const std::optional<PersonFile> person = read_person(path);
            return ReadResult(person ? person_node(*person).get() : scenario_node(path).get());
        } catch (const std::exception &failure) {
            return ReadResult(std::string(failure.what()));
        }
    }
};

}  // namespace osg_plugin

// The name of the macro's variables is the extension.
using osg_plugin::Reader;
REGISTER_OSGPLUGIN(claque, Reader)
