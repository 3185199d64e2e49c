// Renders the views that recognition is examined by: clouds, what is in them, and the templates as
// meshes, into a folder.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/cloud/cloud_file.h"
#include "core/concurrency/worker_pool.h"
#include "core/sim/mesh_file.h"
#include "tests/tools/clutter_view.h"

namespace gripscan::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json view_json(const ClutterView& view, const std::string& file) {
    Json present = Json::array();
    for (const TrueTemplate& t : view.present) {
        present.push_back({{"template", t.name},
                           {"T_camera_template", row_major_from_pose(t.T_camera_template)},
                           {"visible", t.visible},
                           {"telling_detail", t.telling_detail}});
    }
    return {{"cloud", file}, {"present", present}};
}

Status render(int first, int count, int empty, unsigned fraction, const fs::path& out) {
    fs::create_directories(out);
    WorkerPool pool(threads_wanted());
    for (const auto& name : exam_templates()) {
        if (Status s = sim::save_mesh_ply(out / (name + ".ply"), template_mesh(name)); !s) return s;
    }
    Json views = Json::array();
    for (int i = 0; i < count + empty; ++i) {
        ClutterSettings settings;
        settings.seed = static_cast<std::uint64_t>(first + i);
        settings.image_fraction = fraction;
        settings.templates_present = i < count;
        const auto view = make_clutter_view(settings, pool.for_each());
        if (!view) return forward_error(view.error());
        const std::string file = fmt::format("view{:03}.pcd", first + i);
        if (Status s = save_cloud(out / file, view->cloud); !s) return s;
        views.push_back(view_json(*view, file));
        if (Status s = write_file_atomically(out / "truth.json", views.dump(1)); !s) return s;
        fmt::print(stderr, "\rview {} of {}", i + 1, count + empty);
    }
    fmt::print(stderr, "\n");
    return {};
}

}  // namespace
}  // namespace gripscan::test

int main(int argc, char** argv) {
    CLI::App app("Views for the exam of recognition", "recognition_views");
    int first = 1, count = 100, empty = 0;
    unsigned fraction = 1;
    std::string out;
    app.add_option("--first", first, "Seed of the first view (1)");
    app.add_option("--count", count, "Views with templates in them (100)");
    app.add_option("--empty", empty, "Views without any, after those (0)");
    app.add_option("--image-fraction", fraction, "2: half the camera's pixels a side (1)");
    app.add_option("--out", out, "Folder")->required();
    CLI11_PARSE(app, argc, argv);
    const auto done = gripscan::test::render(first, count, empty, fraction, out);
    if (done) return 0;
    fmt::print(stderr, "recognition_views: {}\n", done.error().message);
    return 2;
}
