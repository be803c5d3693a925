// OpenSceneGraph's plugin for files that end in .claque: a description of people (person_file.h) or a scenario.
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
