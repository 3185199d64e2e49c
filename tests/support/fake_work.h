// A cell without devices for tests of the procedure: motions arrive where they should, exposures
// succeed, and each step is judged as a script says.
#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/procedure/capture_store.h"
#include "core/procedure/effect_runner.h"
#include "core/procedure/journal.h"
#include "core/procedure/journal_codec.h"

namespace gripscan::test {

inline TurnStep accepted_row(int from, int to, double turn_rad) {
    TurnStep row;
    row.from = from;
    row.to = to;
    row.commanded_rad = row.robot_rad = row.icp_rad = turn_rad;
    row.error_rad = 0.0;
    row.sigma_rad = 0.0005;
    row.observability = 0.5;
    row.tilt_rad = row.axis_offset_m = row.slip_m = 0.0;
    row.overlap = 0.8;
    row.rms_m = 2e-4;
    row.T = Pose::Identity();
    row.verdict = Verdict::kAccept;
    row.sentence = "agrees with the robot";
    return row;
}

inline TurnStep rejected_row(int from, int to, double turn_rad, Cause cause) {
    TurnStep row = accepted_row(from, to, turn_rad);
    row.verdict = Verdict::kReject;
    row.cause = cause;
    row.sentence = "does not agree";
    return row;
}

inline CellReport passed_report() {
    return {{{"link", CheckOutcome::kPassed, 2.0, 50.0, "ms", "answers in time"}}};
}
inline CellReport failed_report() {
    return {{{"range", CheckOutcome::kFailed, -20.0, 0.0, "deg", "joint 6 ends 20 deg early"}}};
}

/// The arm and camera of the test: state that outlives an engine, as a real cell does.
struct FakeCell {
    double joint6_rad = -180.0 * kRadPerDeg;
    int last_id = 0;
    std::vector<double> motions_rad;  ///< really driven, in order
    std::vector<Shot> shots;          ///< really exposed

    RobotReading reading() const {
        RobotReading reading;
        reading.joints_rad[5] = joint6_rad;
        return reading;
    }
};

class FakeWork : public EffectRunner {
  public:
    explicit FakeWork(FakeCell& cell) : cell_(cell) {}

    /// Judges the step that leads to a shot; default: accepted.
    std::function<TurnStep(const CaptureRecord& from, const CaptureRecord& to)> judge =
        [](const CaptureRecord& from, const CaptureRecord& to) {
            TurnStep row =
                accepted_row(from.index, to.index, to.commanded_rad - from.commanded_rad);
            row.mode = to.mode;
            return row;
        };
    /// Called before each effect; an event it returns is what happens instead.
    std::function<std::optional<Event>(const Effect&)> interfere;
    CellReport report = passed_report();

    Event run(const Effect& effect, const ProcedureState& state, std::stop_token) override {
        if (interfere) {
            if (auto instead = interfere(effect)) return *instead;
        }
        return std::visit([&](const auto& e) { return (*this)(e, state); }, effect);
    }
    void halt() override {}

    Event operator()(const effect::OpenLink&, const ProcedureState& state) const {
        event::LinkUp up;
        up.identity = {"LRMate200iC/5L", 6, "GSP/1.0"};
        up.controller.automatic = up.controller.servo_on = true;
        if (state.plan.mode != MotionMode::kManual) up.reading = cell_.reading();
        return up;
    }
    Event operator()(const effect::MeasureCell&, const ProcedureState&) const {
        return event::CellChecked{report};
    }
    Event operator()(const effect::Turn& e, const ProcedureState&) const {
        if (e.command.id > cell_.last_id) {
            cell_.last_id = e.command.id;
            cell_.joint6_rad = e.command.angle_rad;
            cell_.motions_rad.push_back(e.command.angle_rad);
        } else if (e.command.id < cell_.last_id) {
            return event::TurnFailed{RobotFault::kStaleId, cell_.last_id, "stale"};
        }
        return event::Arrived{cell_.reading()};
    }
    Event operator()(const effect::LogTurn&, const ProcedureState&) const {
        return event::TurnLogged{};
    }
    Event operator()(const effect::Expose& e, const ProcedureState& state) const {
        cell_.shots.push_back(e.shot);
        CaptureRecord record;
        record.index = e.shot.index;
        record.attempt = e.shot.attempt;
        record.commanded_rad = e.shot.commanded_rad;
        if (state.plan.mode != MotionMode::kManual) {
            record.before = cell_.reading();
            record.joint6_after_rad = cell_.joint6_rad;
        }
        return event::Exposed{record};
    }
    Event operator()(const effect::Judge& e, const ProcedureState& state) const {
        return event::Judged{{judge(*state.data.find(e.from), *state.data.find(e.to)), {}, {}}};
    }
    Event operator()(const effect::EstimateAxis&, const ProcedureState&) const {
        return event::AxisFound{AxisEstimate{}, "axis found", std::nullopt, std::nullopt};
    }
    Event operator()(const effect::Solve&, const ProcedureState& state) const {
        const int steps = static_cast<int>(state.data.used().size()) - 1;
        return event::Solved{steps, steps, 1000};
    }
    template <typename T>
    Event operator()(const T&, const ProcedureState&) const {
        return event::WorkFailed{"not for the worker"};
    }

  private:
    FakeCell& cell_;
};

/// Keeps in memory what a session keeps on the disk.
class MemoryStore : public CaptureStore {
  public:
    Status store_images(int, int, const StereoFrame&) override { return {}; }
    Status save_table(std::span<const CaptureRecord> captures) override {
        table.assign(captures.begin(), captures.end());
        return {};
    }
    Status save_plan(const TurnPlan& saved) override {
        plan = saved;
        return {};
    }
    std::vector<RecordedCapture> recorded(std::span<const CaptureRecord>) const override {
        return {};
    }
    std::optional<TurnPlan> plan;
    std::vector<CaptureRecord> table;
};

class MemoryJournal : public Journal {
  public:
    Status write(std::string_view event, const JournalFields& fields) override {
        if (full_at && entries.size() >= *full_at) {
            return input_error("cannot write the journal: no space left on device");
        }
        entries.push_back({std::string(event), fields});
        return {};
    }
    /// The inputs as they are read back from text.
    std::vector<Input> inputs() const {
        std::vector<Input> inputs;
        for (const auto& [event, fields] : entries) {
            auto input = decode_input(event, fields);
            if (input && *input) inputs.push_back(**input);
        }
        return inputs;
    }
    std::vector<JournalRecord> entries;
    std::optional<std::size_t> full_at;
};

}  // namespace gripscan::test
