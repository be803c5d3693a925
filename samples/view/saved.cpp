#include "samples/view/saved.h"

#include "samples/view/designer/files.h"
#include "samples/view/ground/save.h"
#include "samples/view/session.h"

namespace view
{

std::string Saved::named(const Model &model)
{
    if (model.saved_as.empty() || model.saved_as.find('/') != std::string::npos)
        throw scenes::Failure("'" + model.saved_as + "' is no name for a file: it needs letters, and no slash");
    return model.saved_as + "-" + std::to_string(++number_);
}

void Saved::picture(Surface &surface, int below, int width, int height, const std::string &name)
{
    surface.read(below, width, height, rgb_);
    request_.save_picture(request_.folder.at(name), rgb_, width, height);
    ++pictures_;
}

void Saved::wishes(Surface &surface, const Input &input, const World &world, Model &model)
{
    keep_designs(model.designer, world.context(), request_.folder, request_.save_text, model.message);
    keep_zones(model.designer, request_.folder, request_.save_picture, request_.save_text, model.message);
    try {
        if (model.wishes.picture) {
            const std::string name = named(model) + ".png";
            picture(surface, input.height - world.height(), world.width(), world.height(), name);
            model.message = name + " is saved";
        }
        if (model.wishes.save_path) {
            const std::string name = named(model) + ".toml";
            request_.save_text(request_.folder.at(name), path_text(model.view));
            model.message = name + " is saved";
        }
        if (model.ground.save_scenario) {
            const std::string name = named(model) + ".toml";
            request_.save_text(request_.folder.at(name), scenario_text(world, model));
            model.message = name + " is saved: claque render --scenario " + name;
        }
        film(surface, input, world, model);
    } catch (const scenes::Failure &failure) {
        film_.reset();
        model.film = false;
        model.message = failure.what();
    }
    model.wishes.picture = model.wishes.save_path = model.ground.save_scenario = false;
}

void Saved::film(Surface &surface, const Input &input, const World &world, Model &model)
{
    if (film_ && (film_->width() != world.width() || film_->height() != world.height())) model.film = false;
    if (!model.film) {
        if (film_) model.message = end_film();
        return;
    }
    if (!film_) {
        film_name_ = named(model) + ".mp4";
        film_ = std::make_unique<Film>(request_.folder.at(film_name_), world.width(), world.height());
        model.message = film_name_ + " is being made, until the size of the window or the button ends it";
    }
    surface.read(input.height - world.height(), world.width(), world.height(), rgb_);
    film_->add(rgb_, input.elapsed_s);
}

std::string Saved::end_film()
{
    if (!film_) return "";
    const std::unique_ptr<Film> film = std::move(film_);
    film->end();
    return film_name_ + " is saved, " + std::to_string(film->frames()) + " frames";
}

}  // namespace view
