// Samples that rules vary: each is a scene of its own.
#include <algorithm>

#include "lib/base/near_names.h"
#include "samples/cli/colour_arguments.h"
#include "samples/cli/label_scene.h"
#include "samples/labels/variation/haze.h"
#include "samples/labels/variation/jpeg.h"
#include "samples/labels/variation/noise.h"
#include "samples/labels/variation/standpoint.h"
#include "samples/scenes/amphitheatre/sun.h"

namespace cli
{
namespace
{

using labels::Choice;
using scenes::Failure;

constexpr uint32_t most_attempts = 100;

class VariedScene final : public LabelScene
{
public:
    VariedScene(scenes::Library &library, const SceneArguments &arguments, const scenes::SceneOptions &options,
                const labels::Wanted &wanted, double fps, const labels::Rules &rules)
        : library_(library),
          arguments_(arguments),
          options_(options),
          wanted_(wanted),
          fps_(fps),
          rules_(rules),
          skeletons_(library, *wanted.keypoint_set)
    {
        wanted_.keypoints = true;  // look_at_a_person() needs to know whether a head is visible
        wanted_.scene_depth = rules.visibility_m.has_value();
        // The built-in odeon is a scenario that comes with claque.
        if (arguments_.scene == "odeon")
            arguments_.described = std::make_shared<const scenes::Scenario>(scenes::odeon_scenario());
        check_rules();
    }

    LabelledPicture label(int number) override
    {
        const Choice choice = labels::choose(rules_, arguments_.seed, static_cast<uint32_t>(number), number / fps_);
        scenes::SceneRenderer scene(library_, options_for(choice));
        labels::Labeller labeller(library_, scene, wanted_);
        LabelledPicture out;
        out.choice = labels::choice_json(choice);
        out.sample = rules_.camera ? look_at_a_person(scene, labeller, choice, number, out.choice)
                                   : labeller.label(number, choice.time_s);
        out.silhouette_pictures = labeller.silhouette_pictures();
        degrade(choice, out.sample);
        return out;
    }

private:
    void check_rules() const;
    scenes::SceneOptions options_for(const Choice &choice) const;
    scenes::Daylight light_for(const Choice &choice, scenes::Daylight light) const;
    labels::Sample look_at_a_person(scenes::SceneRenderer &scene, labels::Labeller &labeller, const Choice &choice,
                                    int number, Json &chosen);
    // Adds haze, noise and the loss of compression to the colour picture.
    static void degrade(const Choice &choice, labels::Sample &sample);
    [[noreturn]] void refuse(const std::string &rule, const std::string &why) const
    {
        const auto place = rules_.places.find(rule);
        throw Failure((place == rules_.places.end() ? rule : place->second) + ": the scene '" + scene_of(arguments_) +
                      "' " + why);
    }

    scenes::Library &library_;
    SceneArguments arguments_;
    scenes::SceneOptions options_;
    labels::Wanted wanted_;
    double fps_;
    labels::Rules rules_;
    labels::Skeletons skeletons_;
};

void VariedScene::check_rules() const
{
    const scenes::Scenario *described = arguments_.described.get();
    if (rules_.count && described && (described->tracks || described->stage))
        refuse("people.count", "says itself how many people there are");
    for (const auto &[name, share] : rules_.classes) {
        std::vector<std::string> all;
        if (described)
            for (const scenes::SocialClass &one : described->characters) all.push_back(one.name);
        if (std::find(all.begin(), all.end(), name) == all.end())
            refuse("people.classes." + name, "has no class '" + name + "'" + claque::base::names_near(name, all));
    }
    const std::string scene = scene_of(arguments_);
    const bool lit = described ? !described->town : scene == "plaza";
    for (const auto &[rule, has] :
         {std::pair("light.sun", rules_.sun.has_value()), {"light.sky", rules_.sky.has_value()}})
        if (has && !lit) refuse(rule, "has light of its own, which no rule changes");
    if (rules_.hour && !lit && scene != "amphitheatre")
        refuse("light.hour", "has light of its own, which no rule changes");
    if (rules_.jpeg_quality && !labels::can_compress())
        throw Failure(rules_.places.at("sensor.jpeg_quality") +
                      ": this build cannot compress pictures: stb_image_write.h was not there");
    if (rules_.camera && (!arguments_.camera.empty() || !arguments_.path.empty()))
        throw Failure(rules_.places.at("camera") + ": a rule chooses the camera; leave out --camera and --path");
    if (!rules_.colours.empty() && !arguments_.colours.empty())
        throw Failure(rules_.places.at("people.colours") + ": a rule chooses the colours; leave out --colours");
}

scenes::Daylight VariedScene::light_for(const Choice &choice, scenes::Daylight light) const
{
    if (choice.hour) light = scenes::amphitheatre::daylight_at(*choice.hour);
    const float sun = static_cast<float>(choice.sun.value_or(1)), sky = static_cast<float>(choice.sky.value_or(1));
    light.sun = {light.sun.r * sun, light.sun.g * sun, light.sun.b * sun};
    light.sky = {light.sky.r * sky, light.sky.g * sky, light.sky.b * sky};
    light.bounce = {light.bounce.r * sky, light.bounce.g * sky, light.bounce.b * sky};
    return light;
}

scenes::SceneOptions VariedScene::options_for(const Choice &choice) const
{
    scenes::SceneOptions options = options_;
    options.crowd_options.seed = choice.scene_seed;
    if (choice.count) options.crowd_options.count = *choice.count;
    else if (arguments_.described && arguments_.count == 0) options.crowd_options.count = 0;  // its classes' own
    if (choice.hour) options.crowd_options.hour = *choice.hour;
    const bool lit = choice.hour || choice.sun || choice.sky;
    if (arguments_.described) {
        scenes::Scenario shown = *arguments_.described;
        for (const auto &[name, share] : choice.classes)
            for (std::vector<scenes::SocialClass> *all :
                 {&shown.characters, shown.theatre ? &shown.theatre->classes : nullptr})
                if (all)
                    for (scenes::SocialClass &one : *all)
                        if (one.name == name) {
                            one.share *= share;
                            one.count = static_cast<uint32_t>(share * one.count + 0.5);
                        }
        if (lit) shown.light = light_for(choice, shown.light.value_or(scenes::Daylight()));
        SceneArguments with = arguments_;
        with.described = std::make_shared<const scenes::Scenario>(std::move(shown));
        options.make = maker_of(with);
        wear_colours(options, arguments_.colours);
    } else if (lit) {
        options.crowd_options.light = light_for(choice, scenes::Daylight());
    }
    wear_colours(options, choice.colours);
    return options;
}

labels::Sample VariedScene::look_at_a_person(scenes::SceneRenderer &scene, labels::Labeller &labeller,
                                             const Choice &choice, int number, Json &chosen)
{
    scene.place(choice.time_s);
    const std::vector<labels::Head> heads = labels::heads_of(skeletons_, scene.scene(), choice.time_s);
    const std::string sample = "sample " + std::to_string(number) + ": ";
    if (heads.empty()) throw Failure(sample + "no individual has a head for a camera to look at");
    const double aspect = static_cast<double>(options_.width) / options_.height;
    std::string why_not;
    for (uint32_t attempt = 0; attempt < most_attempts; ++attempt) {
        const auto found = labels::stand(*rules_.camera, heads, choice, attempt, aspect, why_not);
        if (!found) continue;
        why_not = "scenery hides the person";
        if (!labels::has_free_sight(scene, *found, choice.time_s)) continue;
        scene.look_from(found->camera);
        const auto shows_person = [&](const labels::Sample &sample) {
            return std::any_of(sample.people.begin(), sample.people.end(), [&](const labels::Person &one) {
                return one.actor == found->person.actor && one.head.seen == labels::Seen::visible;
            });
        };
        why_not = "the person is hidden or not there";
        std::optional<labels::Sample> out = labeller.label_if(number, choice.time_s, shows_person);
        if (!out) continue;
        chosen["camera"] = labels::standpoint_json(*found);
        return std::move(*out);
    }
    throw Failure(sample + "none of " + std::to_string(most_attempts) + " cameras fits the rules; of the last one " +
                  why_not);
}

void VariedScene::degrade(const Choice &choice, labels::Sample &sample)
{
    if (choice.visibility_m)
        labels::add_haze(sample.rgb, sample.scene_depth, sample.width, sample.height, sample.camera,
                         *choice.visibility_m);
    if (choice.read_noise || choice.shot_noise)
        labels::add_noise(sample.rgb, choice.read_noise.value_or(0), choice.shot_noise.value_or(0), choice.seed,
                          choice.sample);
    if (choice.jpeg_quality) labels::compress(sample.rgb, sample.width, sample.height, *choice.jpeg_quality);
}

}  // namespace

std::unique_ptr<LabelScene> varied_scene(scenes::Library &library, const SceneArguments &arguments,
                                         const scenes::SceneOptions &options, const labels::Wanted &wanted, double fps,
                                         const labels::Rules &rules)
{
    return std::make_unique<VariedScene>(library, arguments, options, wanted, fps, rules);
}

}  // namespace cli
