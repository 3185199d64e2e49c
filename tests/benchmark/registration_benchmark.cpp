// Consecutive clouds of a recorded turn, registered by gripscan and by others, side by side: error
// against the truth, share of successes, processor time of one thread.
//
//   registration_benchmark SESSION --truth FOLDER|FILE.json
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ctime>
#include <limits>

#include "core/base/units.h"
#include "tests/benchmark/known_turn.h"
#include "tests/benchmark/peers.h"

namespace gripscan::test {
namespace {

struct Score {
    std::vector<double> angle_deg;
    std::vector<double> shift_mm;
    std::vector<double> cpu_ms;
    int successes = 0;  ///< below 1 deg and 2 mm
};

double cpu_now_ms() {
    timespec now{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

void add_step(Score& score, const Peer& peer, const Cloud& source, const Cloud& target,
              const Pose& T_true) {
    const double begin_ms = cpu_now_ms();
    const auto T = peer.align(source, target);
    score.cpu_ms.push_back(cpu_now_ms() - begin_ms);
    if (!T) {
        score.angle_deg.push_back(std::numeric_limits<double>::infinity());
        score.shift_mm.push_back(std::numeric_limits<double>::infinity());
        return;
    }
    const Eigen::Vector3d middle = centroid(source);
    score.angle_deg.push_back(
        deg_from_rad(rotation_angle_rad(T_true.linear().transpose() * T->linear())));
    score.shift_mm.push_back(kMmPerM * (*T * middle - T_true * middle).norm());
    if (score.angle_deg.back() < 1.0 && score.shift_mm.back() < 2.0) ++score.successes;
}

Score score_of(const Peer& peer, const KnownTurn& turn) {
    Score score;
    for (std::size_t k = 0; k + 1 < turn.clouds.size(); ++k) {
        const Pose T_true = turn.T_first_k[k + 1].inverse() * turn.T_first_k[k];
        add_step(score, peer, turn.clouds[k], turn.clouds[k + 1], T_true);
    }
    return score;
}

void print(const std::string& name, const Score& score, double reference_ms) {
    const double cpu_ms = median(score.cpu_ms);
    fmt::print("| {:<30} | {:>8.3f} | {:>8.3f} | {:>8.3f} | {:>3}/{:<3} | {:>8.0f} | {:>6.2f} |\n",
               name, median(score.angle_deg),
               *std::max_element(score.angle_deg.begin(), score.angle_deg.end()),
               median(score.shift_mm), score.successes, score.angle_deg.size(), cpu_ms,
               cpu_ms / reference_ms);
}

int run(const std::string& session, const std::string& truth) {
    const auto turn = load_known_turn(session, truth);
    if (!turn || turn->clouds.size() < 2) {
        fmt::print(stderr, "{}\n", turn ? "fewer than two clouds" : turn.error().message);
        return 2;
    }
    fmt::print("| {:<30} | {:>8} | {:>8} | {:>8} | {:>7} | {:>8} | {:>6} |\n", "method", "deg",
               "max deg", "mm", "success", "CPU ms", "ratio");
    fmt::print("|{:-<32}|{:->10}|{:->10}|{:->10}|{:->9}|{:->10}|{:->8}|\n", "", "", "", "", "", "",
               "");
    double reference_ms = 0.0;
    for (const Peer& peer : all_peers()) {
        const Score score = score_of(peer, *turn);
        if (reference_ms == 0.0) reference_ms = median(score.cpu_ms);
        print(peer.name, score, reference_ms);
    }
    return 0;
}

}  // namespace
}  // namespace gripscan::test

int main(int argc, char** argv) {
    CLI::App app("Registration of consecutive clouds, gripscan and others side by side");
    std::string session;
    std::string truth;
    app.add_option("session", session, "Session folder")->required();
    app.add_option("--truth", truth, "Truth: folder of the simulated cell, or JSON of an axis")
        ->required();
    CLI11_PARSE(app, argc, argv);
    return gripscan::test::run(session, truth);
}
