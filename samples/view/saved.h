// What a person asks to be saved: pictures, camera paths and films, under the first numbers that this run has not used.
#pragma once

#include <memory>

#include "samples/view/film.h"
#include "samples/view/view.h"

namespace view
{

class Saved
{
public:
    explicit Saved(const Request &request) : request_(request) {}

    void picture(Surface &surface, int below, int width, int height, const std::string &name);
    // After each frame.
    void wishes(Surface &surface, const Input &input, const World &world, Model &model);
    // Completes a film that still runs. Returns what the person reads; empty: there is none.
    std::string end_film();
    int pictures() const { return pictures_; }

private:
    std::string named(const Model &model);
    void film(Surface &surface, const Input &input, const World &world, Model &model);

    const Request &request_;
    std::vector<uint8_t> rgb_;
    int number_ = 0, pictures_ = 0;
    std::unique_ptr<Film> film_;
    std::string film_name_;
};

}  // namespace view
