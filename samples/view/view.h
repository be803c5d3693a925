// claque view: a window on a crowd, or the same interface played by a script without a window.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "samples/view/designer/files.h"
#include "samples/view/serve/options.h"
#include "samples/view/world.h"

namespace view
{

class Session;

struct Request {
    std::string title;
    Open open;
    Drop drop;  // Session::on_drop
    Switches switches;
    int width = 1280, height = 800;
    int processes = 1;   // that draw the picture; 1: the view itself. Others load what they show by themselves
    int cores_each = 1;  // of each of them
    float scale = 1;
    contexts::Kind context = contexts::Kind::any;
    std::string script, script_file;      // the text of a script and its name; no name: a window
    std::string rates;                    // a file for what the frames of a measured script cost, as JSON; empty: none
    std::optional<serve::Options> serve;  // over VNC in place of a screen
    std::string colours;                  // a colour map for the designer; no name: none
    std::string mechanisms;               // the folder of shared objects that may be loaded; empty: none
    Folder folder = {"."};                // where pictures, films, paths and colour maps are saved
    std::function<void(const std::string &path, const std::vector<uint8_t> &rgb, int width, int height)> save_picture;
    std::function<void(const std::string &path, const std::string &text)> save_text;
    double (*now)() = nullptr;  // seconds, for the costs of frames; null: they are not measured
    std::function<void(const std::string &what)> progress;
    std::function<void(const std::string &line)> say;  // what stays to be read
    std::function<void(const std::string &sentence)> conclude;
};

// Everything that a request asks of a new session.
void begin(const Request &request, Session &session);

// Throws scenes::Failure; also, with the packages' names, where the view was built without Dear ImGui.
void run(const Request &request);

}  // namespace view
