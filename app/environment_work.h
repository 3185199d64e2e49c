// The static environment learned from a session's captures, and a look at the cell against it.
#pragma once

#include <filesystem>
#include <functional>

#include "app/context.h"
#include "app/open_cell.h"
#include "core/scene/environment_learner.h"
#include "core/scene/scene_survey.h"
#include "core/session/session.h"
#include "core/session/session_store.h"
#include "core/stereo/rectifier.h"

namespace gripscan::app {

/// The cloud of the whole image, as an environment is learned from it and compared with it.
[[nodiscard]] Result<Cloud> whole_cloud(const StereoFrame& frame, const Rectifier& rectifier,
                                        const Progress& progress, const ForEach& for_each);

/// How a session of kind environment was recorded, as its journal says.
[[nodiscard]] Result<LearnSettings> learn_settings_of(const Session& session);

/// From the used captures of a session of kind environment. Errors: another kind, files that cannot
/// be read, too little seen, cancelled.
[[nodiscard]] Result<EnvironmentModel> learn_environment(const Session& session,
                                                         const Progress& progress,
                                                         const ForEach& for_each);

/// Begins a session of kind environment in a folder of its own.
[[nodiscard]] Result<SessionStore> begin_environment(const std::filesystem::path& folder,
                                                     const CellOptions& options, const Cell& cell,
                                                     bool arm_in_view);
/// Takes the captures and writes the table; `before` makes the arm stand elsewhere.
[[nodiscard]] Status record_environment(
    Cell& cell, SessionStore& store, int captures,
    const std::function<Status(int capture, Cell& cell)>& before, const Progress& progress);
/// Writes environment.bin and environment.json as a whole folder.
[[nodiscard]] Status write_environment(const EnvironmentModel& model,
                                       const std::filesystem::path& out);

/// The same, and prints JSON or text.
[[nodiscard]] Result<ExitStatus> deliver_environment(const EnvironmentModel& model,
                                                     const std::filesystem::path& out,
                                                     const Context& context);

/// `replay` of a session of kind environment.
[[nodiscard]] Result<ExitStatus> replay_environment(const Session& session,
                                                    const std::filesystem::path& out,
                                                    const Context& context);

/// Prints what a survey found; 0 if the area is clear and nothing has moved.
[[nodiscard]] ExitStatus tell_survey(const SceneSurvey& survey, const Context& context);

}  // namespace gripscan::app
