// Recognises in the views of recognition_views and compares with what is in them.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/units.h"
#include "core/cloud/cloud_file.h"
#include "core/concurrency/worker_pool.h"
#include "core/recognition/recognise.h"

namespace gripscan::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Models = std::vector<std::shared_ptr<const TemplateModel>>;

struct Limits {
    double deg = 1.0;
    double mm = 1.5;
    double visible = 0.5;         ///< less than this may be missed
    double telling_detail = 0.2;  ///< less than this need not be told apart
};

struct Tally {
    int asked = 0, right = 0, missed = 0, wrong = 0;
    int absent_asked = 0, absent_reported = 0;
    int views = 0, views_right = 0;
    std::vector<double> seconds, deg, mm;
};

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

struct PoseError {
    double deg, mm;
};

PoseError error_of(const TemplateModel& model, const Pose& T, const Pose& truth) {
    const Eigen::Vector3d c = model.centre_m.cast<double>();
    return {deg_from_rad(rotation_angle_rad(T.linear().transpose() * truth.linear())),
            kMmPerM * (T * c - truth * c).norm()};
}

/// Up to the symmetry, and up to what the view does not show.
PoseError best_error(const TemplateModel& model, const Pose& T, const Pose& truth, bool told) {
    PoseError best = error_of(model, nearest_equivalent(T, model.symmetry, truth), truth);
    if (told) return best;
    for (const Pose& turn : model.symmetry.near_turns) {
        const PoseError e = error_of(model, T * turn, truth);
        if (e.deg < best.deg) best = e;
    }
    return best;
}

class Exam {
  public:
    Exam(const Models& models, const Limits& limits) : models_(models), limits_(limits) {}

    void view(const std::string& name, const Json& present, const std::vector<Detection>& found,
              double seconds) {
        ++tally.views;
        tally.seconds.push_back(seconds);
        bool fine = true;
        for (const auto& model : models_) {
            const auto truth = std::find_if(present.begin(), present.end(), [&](const Json& p) {
                return p["template"] == model->name;
            });
            const bool ok = truth == present.end() ? absent(name, *model, found)
                                                   : there(name, *model, *truth, found);
            fine = fine && ok;
        }
        tally.views_right += fine ? 1 : 0;
    }

    Tally tally;

  private:
    bool absent(const std::string& view, const TemplateModel& model,
                const std::vector<Detection>& found) {
        ++tally.absent_asked;
        bool fine = true;
        for (const Detection& d : found) {
            if (d.name != model.name) continue;
            ++tally.absent_reported;
            fine = false;
            fmt::print("{}: {} is not there but reported, score {:.2f}: {}\n", view, d.name,
                       d.score, d.explained());
        }
        return fine;
    }

    bool there(const std::string& view, const TemplateModel& model, const Json& truth,
               const std::vector<Detection>& found) {
        const auto T =
            *pose_from_row_major(truth["T_camera_template"].get<std::array<double, 16>>());
        const bool told = truth["telling_detail"].get<double>() >= limits_.telling_detail;
        const double visible = truth["visible"].get<double>();
        const bool asked = visible >= limits_.visible;
        tally.asked += asked ? 1 : 0;
        const Detection* best = nullptr;
        for (const Detection& d : found) {
            if (d.name == model.name) {
                best = &d;
                break;
            }
        }
        if (best == nullptr) {
            if (!asked) return true;
            ++tally.missed;
            fmt::print("{}: {} missed, {:.0f} % of it visible\n", view, model.name,
                       100.0 * visible);
            return false;
        }
        const PoseError e = best_error(model, best->T_camera_template, T, told);
        const bool right = e.deg <= limits_.deg && e.mm <= limits_.mm;
        if (right && asked) {
            tally.deg.push_back(e.deg);
            tally.mm.push_back(e.mm);
            ++tally.right;
        }
        if (right) return true;
        ++tally.wrong;
        fmt::print("{}: {} off by {:.2f} deg, {:.2f} mm, {:.0f} % visible, score {:.2f}: {}\n",
                   view, model.name, e.deg, e.mm, 100.0 * visible, best->score, best->explained());
        return false;
    }

    const Models& models_;
    Limits limits_;
};

void print(const Tally& t) {
    fmt::print("templates at least half visible   {}\n", t.asked);
    fmt::print("  right                           {} ({:.1f} %)\n", t.right,
               100.0 * t.right / std::max(1, t.asked));
    fmt::print("  missed                          {}\n", t.missed);
    fmt::print("  wrong pose (any visibility)     {}\n", t.wrong);
    fmt::print("absent templates                  {}\n", t.absent_asked);
    fmt::print("  reported                        {}\n", t.absent_reported);
    fmt::print("views                             {}\n", t.views);
    fmt::print("  without any fault               {}\n", t.views_right);
    fmt::print("median error of right ones        {:.3f} deg, {:.3f} mm\n", median(t.deg),
               median(t.mm));
    fmt::print("median time a view                {:.3f} s (slowest {:.3f} s)\n", median(t.seconds),
               t.seconds.empty() ? 0.0 : *std::max_element(t.seconds.begin(), t.seconds.end()));
}

Status score(const fs::path& folder, const std::vector<std::string>& names, int most,
             Tally& tally) {
    WorkerPool pool(threads_wanted());
    const auto text = read_whole_file(folder / "truth.json");
    if (!text) return forward_error(text.error());
    const Json views = Json::parse(*text);
    Models models;
    for (const auto& name : names) {
        const auto cloud = load_cloud(folder / (name + ".ply"));
        if (!cloud) return forward_error(cloud.error());
        auto model = make_template_model(name, *cloud, {}, {}, pool.for_each());
        if (!model) return forward_error(model.error());
        fmt::print("{}: diameter {:.0f} mm, {} coarse points, symmetry {}, {} near turns\n", name,
                   1e3 * (*model)->diameter_m, (*model)->coarse.size(), (*model)->symmetry.name,
                   (*model)->symmetry.near_turns.size());
        models.push_back(std::move(*model));
    }
    Exam exam(models, {});
    for (const Json& view : views) {
        if (exam.tally.views == most) break;
        const auto file = view["cloud"].get<std::string>();
        const auto cloud = load_cloud(folder / file);
        if (!cloud) return forward_error(cloud.error());
        const auto start = std::chrono::steady_clock::now();
        const auto found = recognise(models, *cloud, {}, {}, pool.for_each());
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
        if (!found) return forward_error(found.error());
        exam.view(file, view["present"], *found, spent.count());
        std::fflush(stdout);
    }
    tally = exam.tally;
    return {};
}

}  // namespace
}  // namespace gripscan::test

int main(int argc, char** argv) {
    using namespace gripscan;
    CLI::App app("Recognition against the truth of simulated views", "recognition_score");
    std::string folder;
    std::vector<std::string> names{"two-finger", "three-finger", "carton",
                                   "jug",        "bracket",      "hexagon"};
    int most = 1000000;
    app.add_option("folder", folder, "What recognition_views wrote")->required();
    app.add_option("--templates", names, "To look for (all six)");
    app.add_option("--most", most, "Views");
    CLI11_PARSE(app, argc, argv);
    test::Tally tally;
    if (const Status done = test::score(folder, names, most, tally); !done) {
        fmt::print(stderr, "recognition_score: {}\n", done.error().message);
        return 2;
    }
    test::print(tally);
    const bool good = 100 * tally.right >= 97 * tally.asked && tally.absent_reported == 0;
    return good ? 0 : 1;
}
