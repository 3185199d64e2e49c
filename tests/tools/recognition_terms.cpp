// What speaks for and against the true poses in the views of recognition_views, and against those
// that the search offers: for judging the judgement. The product never sees a truth.

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/units.h"
#include "core/cloud/cloud_file.h"
#include "core/concurrency/worker_pool.h"
#include "core/recognition/template_search.h"

namespace gripscan::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct Off {
    double deg, mm;
};

Off off(const TemplateModel& model, const Pose& T, const Pose& truth) {
    const Pose near = nearest_equivalent(T, model.symmetry, truth);
    const Eigen::Vector3d c = model.centre_m.cast<double>();
    Off best{deg_from_rad(rotation_angle_rad(near.linear().transpose() * truth.linear())),
             kMmPerM * (near * c - truth * c).norm()};
    for (const Pose& turn : model.symmetry.near_turns) {
        const Pose other = T * turn;
        const double deg =
            deg_from_rad(rotation_angle_rad(other.linear().transpose() * truth.linear()));
        if (deg < best.deg) best = {deg, kMmPerM * (other * c - truth * c).norm()};
    }
    return best;
}

void print(const char* kind, const std::string& name, const PoseCandidate& c, const Off* e) {
    const VisibleAgreement& a = c.agreement;
    fmt::print(
        "  {:9} {:12} score {:.3f} | off {:6.2f} deg {:6.2f} mm | {} |"
        " points {} rms {:.2f} tol {:.2f} mm tied {:.4f}\n",
        kind, name, c.score, e ? e->deg : -1.0, e ? e->mm : -1.0, a.terms(), c.points.size(),
        1e3 * c.rms_m, 1e3 * c.tolerance_m, c.tied_down);
}

Status print_all(const fs::path& folder, const std::vector<std::string>& names, int first, int most,
                 int offered) {
    WorkerPool pool(threads_wanted());
    const auto text = read_whole_file(folder / "truth.json");
    if (!text) return forward_error(text.error());
    std::vector<std::shared_ptr<const TemplateModel>> models;
    for (const auto& name : names) {
        const fs::path ply = folder / (name + ".ply");
        const auto cloud = load_cloud(fs::exists(ply) ? ply : folder / (name + ".pcd"));
        if (!cloud) return forward_error(cloud.error());
        auto model = make_template_model(name, *cloud, {}, {}, pool.for_each());
        if (!model) return forward_error(model.error());
        models.push_back(std::move(*model));
    }
    int count = 0;
    for (const Json& view : Json::parse(*text)) {
        if (count++ < first) continue;
        if (count > first + most) break;
        const auto cloud = load_cloud(folder / view["cloud"].get<std::string>());
        if (!cloud) return forward_error(cloud.error());
        const auto t0 = std::chrono::steady_clock::now();
        const auto scene = make_scene_view(*cloud, models.front()->step_m, pool.for_each());
        if (!scene) return forward_error(scene.error());
        const std::chrono::duration<double> prepared = std::chrono::steady_clock::now() - t0;
        fmt::print("{}: {} points, noise {:.3f} mm, normals {}, prepared in {:.2f} s\n",
                   view["cloud"].get<std::string>(), cloud->size(), 1e3 * scene->noise_m,
                   cloud->has_normals(), prepared.count());
        for (const auto& model : models) {
            std::optional<Pose> truth;
            for (const Json& p : view["present"]) {
                if (p["template"] != model->name) continue;
                truth = *pose_from_row_major(p["T_camera_template"].get<std::array<double, 16>>());
                fmt::print("  {} visible {:.2f} detail {:.2f}\n", model->name,
                           p["visible"].get<double>(), p["telling_detail"].get<double>());
                const PoseCandidate c = refined_candidate(*model, *scene, *truth);
                const Off e = off(*model, c.T_scene_template, *truth);
                print("TRUE", model->name, c, &e);
                for (const Pose& turn : model->symmetry.near_turns) {
                    const PoseCandidate r =
                        refined_candidate(*model, *scene, c.T_scene_template * turn);
                    const Duel d =
                        duel(*model, *scene, c.T_scene_template, c.T_scene_template * turn,
                             std::min(c.tolerance_m, r.tolerance_m));
                    fmt::print("    duel {} : {} {} scores {:.3f} {:.3f}\n", d.first, d.second,
                               d.decisive() ? "decisive" : "", c.score, r.score);
                }
            }
            const auto t1 = std::chrono::steady_clock::now();
            const auto found = search_template(*model, *scene, pool.for_each());
            const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - t1;
            for (std::size_t i = 0; i < found.size() && static_cast<int>(i) < offered; ++i) {
                Off e{0, 0};
                if (truth) e = off(*model, found[i].T_scene_template, *truth);
                const bool right = truth && e.deg < 1.0 && e.mm < 1.5;
                print(right   ? "right"
                      : truth ? "wrong"
                              : "absent",
                      model->name, found[i], truth ? &e : nullptr);
            }
            fmt::print("  {} searched in {:.2f} s\n", model->name, spent.count());
        }
        std::fflush(stdout);
    }
    return {};
}

}  // namespace
}  // namespace gripscan::test

int main(int argc, char** argv) {
    CLI::App app("What speaks for and against poses in simulated views", "recognition_terms");
    std::string folder;
    std::vector<std::string> names{"two-finger", "three-finger", "carton",
                                   "jug",        "bracket",      "hexagon"};
    int first = 0, most = 1000000, offered = 3;
    app.add_option("folder", folder, "What recognition_views wrote")->required();
    app.add_option("--templates", names, "To look for (all six)");
    app.add_option("--first", first, "View to begin with, from 0");
    app.add_option("--most", most, "Views");
    app.add_option("--offered", offered, "Poses of the search shown for each template");
    CLI11_PARSE(app, argc, argv);
    const auto done = gripscan::test::print_all(folder, names, first, most, offered);
    if (done) return 0;
    fmt::print(stderr, "recognition_terms: {}\n", done.error().message);
    return 2;
}
