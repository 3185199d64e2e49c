#include "app/run_results.h"

#include <nlohmann/json.hpp>

#include "app/console.h"
#include "app/session_settings.h"
#include "core/base/units.h"
#include "core/report/results_folder.h"

namespace gripscan::app {
namespace {
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json cell_check_json(const ProcedureState& state) {
    Json items = Json::array();
    if (!state.cell) return items;
    for (const CellCheckItem& item : state.cell->items) {
        const bool known = item.outcome != CheckOutcome::kSkipped;
        items.push_back({{"name", item.name},
                         {"outcome", word(item.outcome)},
                         {"value", known ? Json(item.value) : Json()},
                         {"limit", known ? Json(item.limit) : Json()},
                         {"unit", item.unit},
                         {"sentence", item.sentence}});
    }
    return items;
}

}  // namespace

Status RunResults::keep(const ComputedTurn& turn) {
    auto session = open_session(session_);
    if (!session) return forward_error(session.error());
    auto settings = session_settings(*session, options_);
    if (!settings) return forward_error(settings.error());
    Status written = write_results(session_ / "results", turn.report,
                                   Provenance{*session, *settings, GRIPSCAN_VERSION, turn.held});
    if (written) work_.emplace(TurnWork{std::move(*session), std::move(*settings), turn});
    return written;
}

Result<ExitStatus> RunResults::deliver(bool complete, const Context& context) const {
    const auto status = [&]() -> Result<ExitStatus> {
        if (work_) return tell_results(*work_, session_ / "results", context);
        const auto work = compute_session(session_, options_, context);
        if (!work) return forward_error(work.error());
        return app::deliver(*work, session_ / "results", context);
    }();
    if (!status) return status;
    return complete ? *status : kNotTrusted;
}

void tell_rehearsal(const ProcedureState& state, const Context& context) {
    if (context.options.json) {
        Json motions = Json::array();
        for (const double angle_rad : state.rehearsed_joint6_rad) {
            motions.push_back(deg_from_rad(angle_rad));
        }
        print_result(Json{{"format", "gripscan-rehearsal/1"},
                          {"mode", word(state.plan.mode)},
                          {"cell_check", cell_check_json(state)},
                          {"joint6_deg", motions},
                          {"speed_percent", state.plan.speed_percent}}
                         .dump(2) +
                     "\n");
        return;
    }
    if (context.options.quiet) return;
    print_result(
        fmt::format("DRY: {} motions were written down, none was sent; with --live the arm moves\n",
                    state.rehearsed_joint6_rad.size()));
}

void tell_refusal(const ProcedureState& state, const Context& context) {
    if (context.options.json) {
        print_result(Json{{"format", "gripscan-cell-check/1"},
                          {"passed", state.cell && state.cell->passed()},
                          {"items", cell_check_json(state)}}
                         .dump(2) +
                     "\n");
        return;
    }
    say(context, "no turn was made: see the failed items of the cell check");
}

}  // namespace gripscan::app
